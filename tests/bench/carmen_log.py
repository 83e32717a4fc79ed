# SPDX-License-Identifier: GPL-3.0-or-later
"""The odometry and the scans of a CARMEN log, to be changed and written again."""
import gzip
import math


def compose(a, b):
    c, s = math.cos(a[2]), math.sin(a[2])
    return a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]


def between(a, b):
    c, s = math.cos(a[2]), math.sin(a[2])
    dx, dy = b[0] - a[0], b[1] - a[1]
    return c * dx + s * dy, c * dy - s * dx, math.remainder(b[2] - a[2], 2 * math.pi)


class Message:
    """An ODOM or FLASER line; its odometry pose stands in `fields` from `place` on."""

    def __init__(self, fields):
        self.fields = fields
        self.scan = fields[0] == "FLASER"
        self.place = 2 + int(fields[1]) + 3 if self.scan else 1
        self.pose = tuple(float(f) for f in fields[self.place:self.place + 3])

    def moved_to(self, pose):
        texts = [f"{pose[0]:.6f}", f"{pose[1]:.6f}", f"{math.remainder(pose[2], 2 * math.pi):.6f}"]
        self.fields[self.place:self.place + 3] = texts
        if self.scan:
            self.fields[self.place - 3:self.place] = texts


def read_messages(log):
    """Those of a compressed log."""
    with gzip.open(log, "rt") as lines:
        return [Message(fields) for fields in (line.split() for line in lines)
                if fields and fields[0] in ("ODOM", "FLASER")]


def write_messages(messages, log):
    log.write_text("".join(" ".join(m.fields) + "\n" for m in messages))
