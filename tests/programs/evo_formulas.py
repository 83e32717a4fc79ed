#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What evo (M. Grupp, 2017) prints of two TUM files with the same stamps, by its documented formulas,
written anew with numpy and 4 x 4 matrices.

usage: evo_formulas.py ESTIMATE REFERENCE METRES

evo_ape tum REFERENCE ESTIMATE --align, with -r trans_part; evo_rpe tum REFERENCE ESTIMATE --delta METRES
--delta_unit m with -r trans_part and angle_rad, with --all_pairs ("all") and without ("chain").
"""
import sys

import numpy as np


def poses(path):
    matrices = []
    for row in np.loadtxt(path):
        x, y, z, w = row[4:8] / np.linalg.norm(row[4:8])
        matrix = np.eye(4)
        matrix[:3, :3] = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
        matrix[:3, 3] = row[1:4]
        matrices.append(matrix)
    return matrices


def umeyama(points, partners):
    """Umeyama (1991), eq 38 to 43, without scale; one point a row."""
    mean, partner_mean = points.mean(axis=0), partners.mean(axis=0)
    covariance = (partners - partner_mean).T @ (points - mean) / len(points)
    u, _, vt = np.linalg.svd(covariance)
    sign = np.diag([1, 1, np.sign(np.linalg.det(u) * np.linalg.det(vt))])
    rotation = u @ sign @ vt
    return rotation, partner_mean - rotation @ mean


def pairs(estimate, delta, all_pairs):
    positions = np.array([pose[:3, 3] for pose in estimate])
    way = np.append(0, np.cumsum(np.linalg.norm(np.diff(positions, axis=0), axis=1)))
    if all_pairs:
        for i in range(len(way) - 1):
            misses = np.abs(way[i + 1:] - way[i] - delta)
            if misses.min() <= 0.1 * delta:
                yield i, i + 1 + int(np.argmin(misses))
        return
    marks, last = [], 0.0
    for i, there in enumerate(way):
        if there - last >= delta:
            marks.append(i)
            last = there
    yield from zip(marks, marks[1:])


def tell(name, errors):
    errors = np.array(errors)
    print(f"{name}_rmse {np.sqrt(np.mean(errors ** 2)):.9f}")
    print(f"{name}_mean {errors.mean():.9f}")
    print(f"{name}_median {np.median(errors):.9f}")
    print(f"{name}_deviation {errors.std():.9f}")
    print(f"{name}_maximum {errors.max():.9f}")


def main():
    estimate, reference = poses(sys.argv[1]), poses(sys.argv[2])
    points = np.array([pose[:3, 3] for pose in estimate])
    partners = np.array([pose[:3, 3] for pose in reference])
    rotation, shift = umeyama(points, partners)
    tell("ate", np.linalg.norm(points @ rotation.T + shift - partners, axis=1))
    for name in ("all", "chain"):
        translations, rotations = [], []
        for i, j in pairs(estimate, float(sys.argv[3]), name == "all"):
            of_reference = np.linalg.inv(reference[i]) @ reference[j]
            of_estimate = np.linalg.inv(estimate[i]) @ estimate[j]
            error = np.linalg.inv(of_reference) @ of_estimate
            translations.append(np.linalg.norm(error[:3, 3]))
            skew = error[:3, :3] - error[:3, :3].T
            sine = np.linalg.norm([skew[2, 1], skew[0, 2], skew[1, 0]]) / 2
            rotations.append(np.arctan2(sine, (np.trace(error[:3, :3]) - 1) / 2))
        print(f"{name}_pairs {len(translations)}")
        tell(f"{name}_translation", translations)
        tell(f"{name}_rotation", rotations)


if __name__ == "__main__":
    main()
