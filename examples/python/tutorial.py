# SPDX-License-Identifier: GPL-3.0-or-later
"""Hitos from Python in four figures.

usage: tutorial.py [FOLDER]

A simulated robot drives through a building with a laser and with odometry that drifts. The figures
show what it sees, the map that a run makes of it, how sure the run is scan by scan, and how many
particles it takes. They land in FOLDER (default: the current one).
"""
import pathlib
import sys
import tempfile

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.patches import Ellipse

import hitos

FIRST_LAP = 580  # scans
INK, GREY, BLUE, ORANGE, GREEN = "#22272e", "#9aa4af", "#1f6fb4", "#d9730d", "#2a8c5a"


def placed(points, pose):
    """Points of the robot's frame in the world."""
    x, y, theta = pose
    c, s = np.cos(theta), np.sin(theta)
    return points @ np.array([[c, s], [-s, c]]) + (x, y)


def plan(axes, title):
    """Axes for a drawing to scale."""
    axes.set_aspect("equal")
    axes.set_title(title, loc="left")
    axes.set(xlabel="x (m)", ylabel="y (m)")


def figure_tour(tour, file):
    """What comes in: one scan, and all scans laid along the odometry."""
    scans = list(tour)
    # A run of few particles knows the pose by odometry at every scan.
    odometry = hitos.run(tour, {"filter.particles": 1}).odometry
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6), width_ratios=[1, 1.45])

    first = scans[0]
    left.add_collection(LineCollection([[(0, 0), p] for p in first.points], color=GREY, lw=0.3))
    left.plot(*first.points.T, ".", color=INK, ms=3, label=f"{len(first)} points")
    left.plot(0, 0, ">", color=ORANGE, ms=9, label="robot")
    left.legend(loc="upper right", frameon=False)
    plan(left, "The first scan, in the robot's frame")

    points = np.concatenate([placed(scan.points, pose[1:])
                             for scan, pose in zip(scans[::10], odometry[::10])])
    right.plot(*points.T, ",", color=INK, alpha=0.25)
    right.add_collection(LineCollection(tour.truth.walls, color=GREEN, lw=1.6, label="true walls"))
    right.plot(odometry[:, 1], odometry[:, 2], color=ORANGE, lw=1.2, label="path by odometry")
    right.plot(*tour.truth.trajectory[:, 1:3].T, color=GREEN, lw=0.9, label="true path")
    right.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=3, frameon=False)
    plan(right, "Every tenth scan laid along the odometry")
    figure.savefig(file, dpi=130, bbox_inches="tight")


def figure_map(tour, result, file):
    """What comes out: the grid, the landmarks with how sure they are, the path."""
    figure, axes = plt.subplots(figsize=(9.5, 5.6))
    grid = result.grid
    axes.imshow(grid.grey, cmap="gray", vmin=0, vmax=255, origin="lower", extent=grid.extent,
                alpha=0.55)
    axes.add_collection(LineCollection(result.segments, color=BLUE, lw=2.4, label="lines"))
    corners = result.landmarks["kind"] == "corner"
    axes.plot(result.landmarks["x"][corners], result.landmarks["y"][corners], "o", color=ORANGE,
              ms=4, label="corners, with ellipses of 10 sigma")
    for landmark, covariance in zip(result.landmarks[corners], result.covariances[corners]):
        variances, axis = np.linalg.eigh(covariance)
        width, height = 2 * 10 * np.sqrt(variances)
        turn = np.degrees(np.arctan2(axis[1, 0], axis[0, 0]))
        axes.add_patch(Ellipse((landmark["x"], landmark["y"]), width, height, angle=turn,
                               fill=False, color=ORANGE))
    axes.plot(result.odometry[:, 1], result.odometry[:, 2], color=GREY, lw=1, label="odometry")
    axes.plot(result.trajectory[:, 1], result.trajectory[:, 2], color=INK, lw=1.3, label="path")
    truth = tour.truth.trajectory
    ate = hitos.trajectory_error(result.trajectory, truth).rmse
    drift = hitos.trajectory_error(result.odometry, truth).rmse
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=4, frameon=False)
    plan(axes, f"The map: the path errs by {100 * ate:.1f} cm (ATE), the odometry by "
               f"{100 * drift:.1f} cm")
    figure.savefig(file, dpi=130, bbox_inches="tight")


def figure_steps(tour, configuration, file):
    """A run scan by scan: its particles now and then, and how far apart they are."""
    times, spread, neff, clouds = [], [], [], []
    run = hitos.Run(tour, configuration)
    for snapshot in run:
        times.append(snapshot.time)
        spread.append(np.sqrt(np.trace(snapshot.pose_covariance[:2, :2])))
        if snapshot.scans % 30 == 0 and snapshot.scans <= FIRST_LAP:
            clouds.append(snapshot.particles)  # a view: it stays what it is
    figures = run.result().figures

    figure, (above, middle, below) = plt.subplots(3, 1, figsize=(9, 8.6),
                                                  height_ratios=[3.2, 1, 1])
    truth = tour.truth.trajectory[:FIRST_LAP]
    above.plot(truth[:, 1], truth[:, 2], color=GREEN, lw=1.2, label="true path")
    for place, cloud in enumerate(clouds):
        above.plot(cloud[:, 0], cloud[:, 1], ".", color=BLUE, ms=2, alpha=0.5,
                   label=f"{len(cloud)} particles, every 30 scans" if place == 0 else None)
    above.legend(loc="center", frameon=False, markerscale=4)
    plan(above, "Where the particles were in the first lap")
    middle.plot(times, 100 * np.array(spread), color=BLUE, lw=1)
    middle.set(ylabel="cm", ylim=(0, None), xlim=(0, times[-1]))
    middle.set_title("Spread of the particles' positions", loc="left")
    middle.tick_params(labelbottom=False)
    below.plot(figures["time"], figures["neff"], color=ORANGE, lw=0.6)
    below.set(xlabel="time (s)", ylim=(0, 105), xlim=(0, times[-1]))
    below.set_title("Effective particles", loc="left")
    figure.tight_layout()
    figure.savefig(file, dpi=130)


def figure_study(tour, configuration, file):
    """How many particles it takes: each number with five seeds."""
    counts = [1, 2, 5, 10, 20, 50, 100]
    with tempfile.TemporaryDirectory() as folder:
        study = hitos.study(tour, {"filter.particles": counts}, configuration, runs=5, out=folder)
        runs = study.runs.copy()
    errors = 100 * runs["trajectory_error"].reshape(len(counts), -1)
    figure, axes = plt.subplots(figsize=(7, 4.4))
    axes.plot(np.repeat(counts, errors.shape[1]), errors.ravel(), "o", color=GREY, ms=5,
              label="one run")
    axes.plot(counts, np.median(errors, axis=1), color=BLUE, lw=2, marker="o",
              label="median of five seeds")
    axes.axhline(100 * runs["odometry_error"][0], color=ORANGE, lw=1.2, label="odometry alone")
    axes.set(xscale="log", yscale="log", xlabel="particles", ylabel="trajectory error, ATE (cm)")
    axes.set_xticks(counts, [str(count) for count in counts])
    axes.minorticks_off()
    axes.set_yticks([2, 5, 10, 20, 50], ["2", "5", "10", "20", "50"])
    axes.set_title("What more particles bring", loc="left")
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=130, bbox_inches="tight")


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    tour = hitos.open("bigloop", tour_seed=3)
    configuration = hitos.Configuration({"filter.particles": 100}, preset="simulated")
    figure_tour(tour, folder / "tour.png")
    result = hitos.run(tour, configuration)
    print(result)
    figure_map(tour, result, folder / "map.png")
    figure_steps(tour, configuration, folder / "steps.png")
    figure_study(tour, configuration, folder / "study.png")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "."))
