#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the files that `hitos-cli run --write all` leaves as other programs do.

usage: read_outputs.py FOLDER

Knows nothing of Hitos but docs/formats.md; needs only Python's own library. Prints one line for each
file, "NAME: what was found", and ends with an error where one is not what it should be.
"""
import csv
import math
import pathlib
import re
import sys
import xml.etree.ElementTree as ET

FOLDER = pathlib.Path(sys.argv[1])


def wrap(angle):
    return math.atan2(math.sin(angle), math.cos(angle))


def near(a, b, tolerance=1e-6):
    return abs(a - b) <= tolerance * max(1.0, abs(a), abs(b))


def check(truth, words):
    if not truth:
        sys.exit(f"error: {words}")


def read_map():
    """Lines as (rho, theta) and corners as (x, y), of the map file."""
    lines, corners = [], []
    for line in (FOLDER / "map.txt").read_text().splitlines():
        a, b = (float(value) for value in re.findall(r":\s*(\S+)", line))
        lines.append((a, math.radians(b))) if line.startswith("rho") else corners.append((a, b))
    return lines, corners


def read_segments():
    rows = (FOLDER / "segments.txt").read_text().splitlines()
    return [[float(value) for value in row.split()] for row in rows if not row.startswith("#")]


def read_poses(name):
    rows = [[float(v) for v in row.split()] for row in (FOLDER / name).read_text().splitlines()
            if not row.startswith("#")]
    return [(r[1], r[2], 2.0 * math.atan2(r[6], r[7]), r[0]) for r in rows]


class MapServer:
    """A map as the documentation of map_server has it, mode trinary."""

    def __init__(self):
        text = (FOLDER / "map.yaml").read_text()
        facts = dict(line.split(": ", 1) for line in text.splitlines())
        self.resolution = float(facts["resolution"])
        self.origin = [float(value) for value in facts["origin"].strip("[]").split(",")]
        check(facts["mode"] == "trinary" and self.origin[2] == 0.0, "map.yaml: mode and yaw")
        data = (FOLDER / facts["image"]).read_bytes()
        magic, size, most, pixels = data.split(b"\n", 3)
        check(magic == b"P5" and most == b"255", "map.pgm: no binary PGM of 8 bits")
        self.width, self.height = (int(value) for value in size.split())
        check(len(pixels) == self.width * self.height, "map.pgm: as many pixels as it says")
        negate = int(facts["negate"])
        occupied, free = float(facts["occupied_thresh"]), float(facts["free_thresh"])
        self.states = []
        for pixel in pixels:
            share = (pixel if negate else 255 - pixel) / 255.0
            self.states.append(100 if share > occupied else 0 if share < free else -1)

    def at(self, x, y):
        """Occupied 100, free 0, else -1: of a place in the world."""
        column = math.floor((x - self.origin[0]) / self.resolution)
        row = math.floor((y - self.origin[1]) / self.resolution)
        if not (0 <= column < self.width and 0 <= row < self.height):
            return -1
        return self.states[(self.height - 1 - row) * self.width + column]

    def near(self, x, y):
        """The most that is at the place or a cell beside it."""
        steps = (-self.resolution, 0.0, self.resolution)
        return max(self.at(x + dx, y + dy) for dx in steps for dy in steps)


def map_server():
    grid = MapServer()
    check({100, 0, -1} <= set(grid.states), "map.pgm: occupied, free and unknown cells")
    seen = hit = 0
    for x1, y1, x2, y2, _ in read_segments():
        steps = max(int(math.hypot(x2 - x1, y2 - y1) / grid.resolution), 1)
        for i in range(1, steps):
            seen += 1
            share = i / steps
            hit += grid.near(x1 + share * (x2 - x1), y1 + share * (y2 - y1)) == 100
    # Walls of logs are neither straight nor whole; in a turned or shifted map hardly any is hit.
    check(hit > 0.4 * seen, f"map.pgm: {hit} of {seen} places on walls are occupied")
    poses = read_poses("trajectory.tum")
    at_poses = [grid.at(x, y) for x, y, _, _ in poses]
    free, hit = at_poses.count(0), at_poses.count(100)
    check(free > 0.5 * len(poses), f"map.pgm: {free} of {len(poses)} poses are in free cells")
    check(hit < 0.05 * len(poses), f"map.pgm: {hit} of {len(poses)} poses are in occupied cells")
    print(f"map.yaml: {grid.width} x {grid.height} cells, walls occupied, path free")
    return grid


def ieee(grid):
    root = ET.parse(FOLDER / "map.xml").getroot()
    check(root.tag == "map_data" and root.find("metadata/name").text, "map.xml: metadata")
    kinds = {one.get("type"): one for one in root.findall("global_map/local_map")}
    lines, corners = read_map()
    points = kinds["geometric"].findall("point")
    check(len(points) == len(corners), "map.xml: as many points as corners")
    for point, (x, y) in zip(points, corners):
        check(near(float(point.get("x")), x) and near(float(point.get("y")), y), "map.xml: a point")
    segments = kinds["geometric"].findall("line_segment")
    told = read_segments()
    check(len(segments) == len(told), "map.xml: as many segments as segments.txt")
    for segment, (x1, y1, x2, y2, number) in zip(segments, told):
        rho, alpha, a, b = (float(segment.get(n)) for n in ("rho", "alpha", "psi_a", "psi_b"))
        check(0.0 <= alpha < 2.0 * math.pi and a <= b, "map.xml: alpha and psi")
        check(segment.get("id").startswith(f"line_{int(number)}_"), "map.xml: a segment's id")
        c, s = math.cos(alpha), math.sin(alpha)
        ends = sorted([(rho * c - t * s, rho * s + t * c) for t in (a, b)])
        for end, true in zip(ends, sorted([(x1, y1), (x2, y2)])):
            check(math.dist(end, true) < 1e-6, "map.xml: an end of a segment")
    cells = kinds["grid"].find("grid")
    rows = [[int(v) for v in row.text.split()] for row in cells.findall("row")]
    width, height = int(cells.get("size_x")), int(cells.get("size_y"))
    check(len(rows) == height and all(len(row) == width for row in rows), "map.xml: its size")
    x0, y0 = float(cells.get("origin_x")), float(cells.get("origin_y"))
    step = float(cells.get("resolution_x"))
    for j, row in enumerate(rows):
        for i, percent in enumerate(row):
            state = grid.at(x0 + (i + 0.5) * step, y0 + (j + 0.5) * step)
            # The one is rounded to per cents, the other to three states.
            right = (percent >= 65 if state == 100 else 0 <= percent <= 20 if state == 0
                     else percent == -1 or 19 <= percent <= 65)
            check(right, f"map.xml: cell {i}, {j} has {percent}, map.pgm {state}")
    print(f"map.xml: {len(points)} points, {len(segments)} segments, {width} x {height} cells")


def landmarks():
    lines, corners = read_map()
    with open(FOLDER / "landmarks.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    check(len(rows) == len(lines) + len(corners), "landmarks.csv: as many rows as landmarks")
    for number, row in enumerate(rows, 1):
        check(int(row["map_line"]) == number, "landmarks.csv: the line of the map file")
        line = number <= len(lines)
        check(row["kind"] == ("line" if line else "corner"), "landmarks.csv: the kind")
        place = number - 1 if line else number - 1 - len(lines)
        check(int(row["landmark"]) == place + 1, "landmarks.csv: the number of its kind")
        value = lines[place] if line else corners[place]
        names = ("rho_m", "theta_rad") if line else ("x_m", "y_m")
        check(all(near(float(row[n]), v) for n, v in zip(names, value)), "landmarks.csv: a value")
        names = (("cov_rho_rho_m2", "cov_rho_theta_m_rad", "cov_theta_theta_rad2") if line
                 else ("cov_x_x_m2", "cov_x_y_m2", "cov_y_y_m2"))
        a, b, c = (float(row[name]) for name in names)
        check(a > 0.0 and c > 0.0 and a * c > b * b, "landmarks.csv: a covariance")
        check(int(row["observations"]) > 0, "landmarks.csv: observations")
    print(f"landmarks.csv: {len(rows)} rows")


def positive(matrix, least):
    """Whether a symmetric matrix is positive definite, by Gauss's elimination: all pivots are over
    `least` times the greatest number of the diagonal."""
    m = [row[:] for row in matrix]
    bound = least * max(m[k][k] for k in range(len(m)))
    for k in range(len(m)):
        if not m[k][k] > bound:
            return False
        if m[k][k] <= 0.0:
            continue
        for i in range(k + 1, len(m)):
            share = m[i][k] / m[k][k]
            m[i] = [a - share * b for a, b in zip(m[i], m[k])]
    return True


def graph():
    vertices, edges, fixed = {}, [], []
    for line in (FOLDER / "graph.g2o").read_text().splitlines():
        tag, *fields = line.split()
        if tag == "FIX":
            fixed.append(int(fields[0]))
        elif tag.startswith("VERTEX"):
            vertices[int(fields[0])] = (tag, [float(value) for value in fields[1:]])
        else:
            numbers = [float(value) for value in fields[2:]]
            edges.append((tag, int(fields[0]), int(fields[1]), numbers))
    check(fixed == [0], "graph.g2o: the first pose alone is fixed")
    poses = read_poses("trajectory.tum")
    lines, corners = read_map()
    for i, (x, y, theta, _) in enumerate(poses):
        tag, (vx, vy, vt) = vertices[i]
        good = tag == "VERTEX_SE2" and math.hypot(vx - x, vy - y) < 1e-6 and abs(wrap(vt - theta)) < 1e-6
        check(good, f"graph.g2o: pose {i}")
    check(len(vertices) == len(poses) + len(lines) + len(corners), "graph.g2o: its vertices")
    found = ([], [])
    for i in range(len(poses), len(vertices)):
        tag, values = vertices[i]
        if tag == "VERTEX_LINE2D":
            found[0].append((values[1], values[0]))
            check(values[2:] == [-1.0, -1.0], "graph.g2o: a line's ends")
        else:
            found[1].append(tuple(values))
    for mine, true in zip(found, (lines, corners)):
        good = len(mine) == len(true) and all(near(m[0], t[0]) and near(m[1], t[1])
                                              for m, t in zip(mine, true))
        check(good, "graph.g2o: landmarks are those of the map")
    chi2 = {}
    touched = set()
    for tag, a, b, numbers in edges:
        x, y, theta = vertices[a][1]
        c, s = math.cos(theta), math.sin(theta)
        other = vertices[b][1]
        if tag == "EDGE_SE2_LINE2D":
            expected = [wrap(other[0] - theta),
                        other[1] - x * math.cos(other[0]) - y * math.sin(other[0])]
            error = [wrap(expected[0] - numbers[0]), expected[1] - numbers[1]]
        else:
            dx, dy = other[0] - x, other[1] - y
            error = [c * dx + s * dy - numbers[0], -s * dx + c * dy - numbers[1]]
            if tag == "EDGE_SE2":
                turn = numbers[2]
                cz, sz = math.cos(turn), math.sin(turn)
                error = [cz * error[0] + sz * error[1], -sz * error[0] + cz * error[1],
                         wrap(other[2] - theta - turn)]
        n = len(error)
        upper = iter(numbers[n:])
        matrix = [[0.0] * n for _ in range(n)]
        for i in range(n):
            for j in range(i, n):
                matrix[i][j] = matrix[j][i] = next(upper)
        check(next(upper, None) is None, f"graph.g2o: {tag} has more numbers than it may")
        # What a corridor says of the way along it may be nothing, between key scans.
        least = -1e-9 if tag == "EDGE_SE2" and b != a + 1 else 0.0
        check(positive(matrix, least), f"graph.g2o: {tag} {a} {b}: information is not positive")
        value = sum(error[i] * matrix[i][j] * error[j] for i in range(n) for j in range(n))
        check(math.isfinite(value) and value >= 0.0, f"graph.g2o: {tag} {a} {b}: chi2")
        chi2.setdefault(tag, []).append(value)
        touched |= {a, b}
    check(touched == set(vertices), "graph.g2o: a vertex has no edge")
    for tag, values in chi2.items():
        mean = sum(values) / len(values)
        check(mean < 10.0, f"graph.g2o: {tag} has a mean chi2 of {mean}")
    print("graph.g2o:", ", ".join(f"{len(v)} {t}" for t, v in sorted(chi2.items())))


def corrected():
    """Poses of the scans of a CARMEN log, FLASER and ROBOTLASER1 alike."""
    poses, offset = [], 0.0
    for line in (FOLDER / "corrected.log").read_text().splitlines():
        fields = line.split()
        if fields[0] == "PARAM" and fields[1] == "robot_frontlaser_offset":
            offset = float(fields[2])
        elif fields[0] == "FLASER":
            after = fields[2 + int(fields[1]):]
            x, y, theta = (float(value) for value in after[:3])
            poses.append((x - offset * math.cos(theta), y - offset * math.sin(theta), theta))
        elif fields[0] == "ROBOTLASER1":
            count = int(fields[8])
            after = fields[9 + count + 1:]
            poses.append(tuple(float(value) for value in after[3:6]))
    true = read_poses("trajectory.tum")
    check(len(poses) == len(true), f"corrected.log: {len(poses)} scans of {len(true)}")
    for pose, (x, y, theta, _) in zip(poses, true):
        good = math.hypot(pose[0] - x, pose[1] - y) < 2e-6 and abs(wrap(pose[2] - theta)) < 2e-6
        check(good, f"corrected.log: a pose is {pose}, not {(x, y, theta)}")
    print(f"corrected.log: {len(poses)} scans")


def figure():
    name = "{http://www.w3.org/2000/svg}"
    root = ET.parse(FOLDER / "map.svg").getroot()
    width = float(root.get("width").removesuffix("mm"))
    check(root.tag == name + "svg" and width <= 85.0, f"map.svg: {width} mm wide")
    groups = {group.get("id"): group for group in root.findall(name + "g")}
    segments = len(groups["lines"].findall(name + "polyline")) if "lines" in groups else 0
    check(segments == len(read_segments()), "map.svg: as many lines as segments")
    corners = len(groups["corners"].findall(name + "path")) if "corners" in groups else 0
    check(corners == len(read_map()[1]), "map.svg: as many marks as corners")
    words = [text.text for text in root.iter(name + "text")]
    for needed in ("x [m]", "y [m]", "estimated path", "start"):
        check(needed in words, f"map.svg: no word says {needed}")
    print(f"map.svg: {width:g} x {root.get('height')}, {segments} lines, {corners} corners")


ieee(map_server())
landmarks()
graph()
corrected()
figure()
