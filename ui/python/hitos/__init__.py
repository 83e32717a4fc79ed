# SPDX-License-Identifier: GPL-3.0-or-later
"""Hitos, a workbench for landmark SLAM, from Python.

A tour is a recorded log, a ROS recording or a simulated world; a run builds a map of lines and
corners from it and finds the robot's path. What comes out are numpy arrays, in metres, radians and
seconds. To begin:

    import hitos

    hitos.worlds()                                  # the worlds that come with Hitos
    tour = hitos.open("bigloop")                    # or "tour.log.gz", "tour.bag", "world.toml"
    for scan in tour:
        scan.time, scan.points, scan.ranges         # N x 2, N

    result = hitos.run(tour, {"filter.particles": 50})
    result.trajectory                               # N x 4: t, x, y, theta
    result.landmarks["kind"], result.covariances    # the map, M x 2 x 2
    result.particles, result.weights                # M x 3, M
    result.grid.grey                                # rows x columns, see help(hitos.Grid)
    result.summary["trajectory_error"]              # errors, where the truth is known
    result.write("out/bigloop")                     # the files of `hitos-cli run`

Parameters have the keys of `hitos-cli parameters`:

    for p in hitos.parameters():
        print(p.key, p.default, p.allowed)
    c = hitos.Configuration({"split_merge.dmax": 0.03}, preset="recorded")

Step by step, with a snapshot after every scan, which never changes and outlives the run:

    run = hitos.Run(tour, c)
    for snapshot in run:
        snapshot.particles, snapshot.observed_lines

Values of parameters, several seeds each:

    study = hitos.study("bigloop", {"filter.particles": [10, 30, 100]}, out="out/study", runs=5)
    study.runs["trajectory_error"]

A line method of one's own (add_proposal() does the same for where particles draw their poses):

    def whole_runs(scan):
        ends = [*scan.run_starts[1:], len(scan)]
        return [(a, b) for a, b in zip(scan.run_starts, ends) if b - a >= 15]

    hitos.add_line_method("whole-runs", whole_runs)
    hitos.run("bigloop", {"features.method": "whole-runs"})

Arrays show the memory of C++ without copies, read-only, and keep it alive. Functions that compute
let other threads of Python run meanwhile, and heed Ctrl+C. What is wrong raises hitos.Error, one of
FileError, FormatError and ConfigurationError. docs/python.md says more.
"""

import pathlib as _pathlib
import sys as _sys

import numpy as _numpy  # whoever lacks it is told at once

from .errors import ConfigurationError, Error, FileError, FormatError

try:
    from ._hitos import __version__
except ModuleNotFoundError as _error:
    _built = [_file.name for _file in _pathlib.Path(__file__).parent.glob("_hitos*.so")]
    raise ImportError(
        f"hitos was built for another Python than {_sys.executable} "
        f"({_sys.implementation.cache_tag}): found {_built or 'no module'} in {__path__[0]}"
    ) from _error

from ._hitos import (
    UNKNOWN_GREY,
    Configuration,
    Grid,
    Motion,
    Parameter,
    Progress,
    Result,
    Run,
    Scan,
    ScanIterator,
    Snapshot,
    Study,
    StudyProgress,
    Tour,
    TrajectoryError,
    Truth,
    add_line_method,
    add_proposal,
    draw_grid,
    open,
    parameters,
    presets,
    read_trajectory,
    run,
    study,
    trajectory_error,
    worlds,
)

for _error in (Error, FileError, FormatError, ConfigurationError):
    _error.__module__ = __name__  # where users find them
del _error

__all__ = [
    "Configuration",
    "ConfigurationError",
    "Error",
    "FileError",
    "FormatError",
    "Grid",
    "Motion",
    "Parameter",
    "Progress",
    "Result",
    "Run",
    "Scan",
    "ScanIterator",
    "Snapshot",
    "Study",
    "StudyProgress",
    "Tour",
    "TrajectoryError",
    "Truth",
    "UNKNOWN_GREY",
    "add_line_method",
    "add_proposal",
    "draw_grid",
    "open",
    "parameters",
    "presets",
    "read_trajectory",
    "run",
    "study",
    "trajectory_error",
    "worlds",
]
