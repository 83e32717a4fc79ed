# SPDX-License-Identifier: GPL-3.0-or-later
"""Known associations, against EKF-SLAM and FastSLAM written anew from the textbook.

Thrun, Burgard, Fox: Probabilistic Robotics (2005), table 10.1 (EKF-SLAM with known correspondences)
and table 13.1 (FastSLAM 1.0), with numpy's general matrices and inverses, from the log's text on:
nothing here is read by Hitos first.
"""
import pathlib
import tempfile
import unittest

import numpy as np

import hitos
from support import cli

SIGMA = np.array([0.02, 0.02, 0.01])  # of the motion, per step, in the world's axes [m, m, rad]
R = np.diag([0.02, 0.001])            # of a range and a bearing [m^2, rad^2]
NOISE = {"motion.model": "odometry", "motion.sigma_x": SIGMA[0], "motion.sigma_y": SIGMA[1],
         "motion.sigma_theta": SIGMA[2], "observation.var_rho": R[0, 0],
         "observation.var_theta": R[1, 1]}


def wrapped(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


def moved(pose, v, w, seconds):
    """A twist held for a time: an arc, by its chord."""
    x, y, theta = pose
    turn = w * seconds
    chord = v * seconds * np.sinc(turn / 2 / np.pi)
    middle = theta + turn / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + turn])


def steps(log):
    """Of each scan: its time, the step from the scan before in the robot's frame, what it sees."""
    step, clock, found = np.zeros(3), None, []
    for line in log.read_text().splitlines():
        word, *fields = line.split()
        if word == "ODOM":
            time, v, w = map(float, fields[:3])
            if clock is not None:
                step = moved(step, v, w, time - clock)
            clock = time
        elif word == "LANDMARKS":
            seen = np.array(fields[2:], dtype=float).reshape(-1, 3)
            found.append((float(fields[0]), step, seen))
            step = np.zeros(3)
    return found


def placed(pose, step):
    x, y, theta = pose
    c, s = np.cos(theta), np.sin(theta)
    return np.array([x + c * step[0] - s * step[1], y + s * step[0] + c * step[1],
                     theta + step[2]])


def seen_from(pose, landmark):
    """Range and bearing, with the derivatives by pose and by landmark."""
    dx, dy = landmark - pose[:2]
    q = dx * dx + dy * dy
    r = np.sqrt(q)
    h = np.array([r, np.arctan2(dy, dx) - pose[2]])
    by_landmark = np.array([[dx / r, dy / r], [-dy / q, dx / q]])
    by_pose = np.column_stack([-by_landmark, [0.0, -1.0]])
    return h, by_pose, by_landmark


def innovation(z, h):
    return np.array([z[0] - h[0], wrapped(z[1] - h[1])])


class Ekf:
    """One Gaussian over the pose and all landmarks."""

    def __init__(self):
        self.mean = np.zeros(3)
        self.covariance = np.zeros((3, 3))
        self.places = {}

    def step(self, step, seen, first):
        before = self.mean[:3].copy()
        self.mean[:3] = placed(before, step)
        f = np.eye(len(self.mean))
        f[0, 2] = -(self.mean[1] - before[1])
        f[1, 2] = self.mean[0] - before[0]
        self.covariance = f @ self.covariance @ f.T
        if not first and np.any(step != 0.0):
            self.covariance[:3, :3] += np.diag(SIGMA ** 2)
        known = [row for row in seen if int(row[0]) in self.places]
        if known:
            self.update(known)
        for row in seen:
            if int(row[0]) not in self.places:
                self.add(row)

    def update(self, rows):
        h = np.zeros((2 * len(rows), len(self.mean)))
        nu = np.zeros(2 * len(rows))
        for k, (identity, *z) in enumerate(rows):
            at = self.places[int(identity)]
            expected, by_pose, by_landmark = seen_from(self.mean[:3], self.mean[at:at + 2])
            h[2 * k:2 * k + 2, :3] = by_pose
            h[2 * k:2 * k + 2, at:at + 2] = by_landmark
            nu[2 * k:2 * k + 2] = innovation(z, expected)
        s = h @ self.covariance @ h.T + np.kron(np.eye(len(rows)), R)
        gain = self.covariance @ h.T @ np.linalg.inv(s)
        self.mean = self.mean + gain @ nu
        self.covariance = (np.eye(len(self.mean)) - gain @ h) @ self.covariance

    def add(self, row):
        identity, distance, bearing = row
        angle = self.mean[2] + bearing
        c, s = np.cos(angle), np.sin(angle)
        by_pose = np.array([[1.0, 0.0, -distance * s], [0.0, 1.0, distance * c]])
        by_z = np.array([[c, -distance * s], [s, distance * c]])
        size = len(self.mean)
        self.places[int(identity)] = size
        self.mean = np.append(self.mean, self.mean[:2] + distance * np.array([c, s]))
        grown = np.zeros((size + 2, size + 2))
        grown[:size, :size] = self.covariance
        grown[size:, :size] = by_pose @ self.covariance[:3, :]
        grown[:size, size:] = grown[size:, :size].T
        grown[size:, size:] = (by_pose @ self.covariance[:3, :3] @ by_pose.T
                               + by_z @ R @ by_z.T)
        self.covariance = grown

    def landmark(self, identity):
        at = self.places[identity]
        return self.mean[at:at + 2], self.covariance[at:at + 2, at:at + 2]


class Particle:
    """A map for one path, and how likely it makes what was seen."""

    def __init__(self):
        self.landmarks = {}
        self.log_weight = 0.0

    def step(self, pose, seen):
        before = dict(self.landmarks)  # each sighting is judged by what was known before the scan
        for identity, *z in seen:
            identity = int(identity)
            if identity not in before:
                angle = pose[2] + z[1]
                c, s = np.cos(angle), np.sin(angle)
                by_z = np.array([[c, -z[0] * s], [s, z[0] * c]])
                mean = pose[:2] + z[0] * np.array([c, s])
                self.landmarks[identity] = mean, by_z @ R @ by_z.T
                continue
            mean, covariance = before[identity]
            expected, _, h = seen_from(pose, mean)
            nu = innovation(z, expected)
            q = h @ covariance @ h.T + R
            gain = covariance @ h.T @ np.linalg.inv(q)
            self.landmarks[identity] = mean + gain @ nu, (np.eye(2) - gain @ h) @ covariance
            self.log_weight -= 0.5 * (nu @ np.linalg.solve(q, nu)
                                      + np.log(np.linalg.det(2 * np.pi * q)))


class Oracles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.log = pathlib.Path(cls.folder.name, "posts.log")
        cli("simulate", "posts", "--seed", "3", "--out", cls.log)
        cls.steps = steps(cls.log)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def close(self, found, wanted):
        """Within 1e-9 of the greatest number."""
        wanted = np.asarray(wanted)
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-9 * max(np.abs(wanted).max(), 1e-3))

    def compare(self, state, wanted):
        """The map, landmark by landmark, against means and covariances by their identities."""
        self.assertEqual(sorted(state.landmarks["identity"]), sorted(wanted))
        self.assertEqual(len(state.covariances), len(wanted))
        for landmark, covariance in zip(state.landmarks, state.covariances):
            mean, its_covariance = wanted[int(landmark["identity"])]
            self.close([landmark["x"], landmark["y"]], mean)
            self.close(covariance, its_covariance)

    def test_the_tour_sees_landmarks_again_and_again(self):
        seen = [len(seen) for _, _, seen in self.steps]
        self.assertGreater(len(seen), 500)
        self.assertGreater(np.mean(seen), 2)
        self.assertEqual({int(row[0]) for _, _, seen in self.steps for row in seen},
                         set(range(15)))

    def test_ekf_slam(self):
        run = hitos.Run(self.log, {"filter.algorithm": "ekf-slam", **NOISE})
        ekf = Ekf()
        for k, (_, step, seen) in enumerate(self.steps):
            ekf.step(step, seen, k == 0)
            state = run.step(1)
            self.close(state.pose[:2], ekf.mean[:2])
            self.assertLess(abs(wrapped(state.pose[2] - ekf.mean[2])), 1e-9)
            self.close(state.pose_covariance, ekf.covariance[:3, :3])
            self.compare(state, {identity: ekf.landmark(identity) for identity in ekf.places})

    def test_fastslam(self):
        count = 20
        run = hitos.Run(self.log, {"filter.particles": count, "resampling.rule": "neff",
                                   "resampling.neff_threshold": 0, **NOISE})
        particles = [Particle() for _ in range(count)]
        for _, _, seen in self.steps:
            state = run.step(1)
            for particle, pose in zip(particles, state.particles):
                particle.step(pose, seen)
            logs = np.array([particle.log_weight for particle in particles])
            weights = np.exp(logs - logs.max())
            self.close(state.weights, weights / weights.sum())
            best = particles[int(np.argmax(logs))]
            self.assertEqual(state.best, int(np.argmax(logs)))
            self.compare(state, best.landmarks)


if __name__ == "__main__":
    unittest.main()
