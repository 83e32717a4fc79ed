# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run of hitos-cli has left, and how its path lies on another one."""
import csv
import json
import math
import statistics
import subprocess

from carmen_log import compose


class Run:
    def __init__(self, cli, log, out, *options):
        options = options or ("--preset", "recorded")
        command = [cli, "run", log, "--replace", "--out", out, *options]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        summary = json.loads((out / "summary.json").read_text())
        self.breaks = summary["quality"].get("scans_breaking", [])
        self.second = summary["quality"].get("later_tours", [None])[-1]
        rows = csv.DictReader((out / "loops.csv").read_text().splitlines())
        self.loops = [(int(row["earlier"]), int(row["scan"])) for row in rows
                      if row["verdict"] == "closed"]
        poses = [list(map(float, line.split())) for line in
                 (out / "trajectory.tum").read_text().splitlines()]
        self.path = [(p[1], p[2], 2 * math.atan2(p[6], p[7])) for p in poses]


def aligned(path, onto):
    """The motion that lays one path on the other as well as it goes."""
    a, b = (tuple(statistics.fmean(p[i] for p in poses) for i in (0, 1)) for poses in (path, onto))
    dot = cross = 0.0
    for p, q in zip(path, onto):
        px, py, qx, qy = p[0] - a[0], p[1] - a[1], q[0] - b[0], q[1] - b[1]
        dot += px * qx + py * qy
        cross += px * qy - py * qx
    turn = math.atan2(cross, dot)
    x, y, _ = compose((0.0, 0.0, turn), (a[0], a[1], 0.0))
    return b[0] - x, b[1] - y, turn


def driven(path, first, last):
    return sum(math.dist(a[:2], b[:2]) for a, b in zip(path[first:last], path[first + 1:last + 1]))
