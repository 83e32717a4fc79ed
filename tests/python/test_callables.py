# SPDX-License-Identifier: GPL-3.0-or-later
"""Line methods and proposals that are functions of Python."""
import threading
import traceback
import unittest

import numpy as np

import hitos

FEW = {"filter.particles": 20}
seen_by_thread = {}
barrier = threading.Barrier(2, timeout=60)


def runs_of(scan):
    ends = [*scan.run_starts[1:], len(scan)]
    return [(a, b) for a, b in zip(scan.run_starts, ends) if b - a >= 15]


def fitted(scan):
    """The same, with total least squares of its own."""
    rows = []
    for a, b in runs_of(scan):
        points = scan.points[a:b]
        middle = points.mean(axis=0)
        _, vectors = np.linalg.eigh((points - middle).T @ (points - middle))
        normal = vectors[:, 0]
        rows.append((middle @ normal, np.arctan2(normal[1], normal[0]), a, b))
    return np.array(rows)


def some(scan, generator):
    lines = runs_of(scan)
    return [line for line in lines if generator.random() < 0.7]


def meet(scan):
    """Both runs are inside their third scan at once, or nobody gets on."""
    mine = threading.get_ident()
    seen_by_thread[mine] = seen_by_thread.get(mine, 0) + 1
    if seen_by_thread[mine] == 3:
        barrier.wait()
    return runs_of(scan)


class Mine(Exception):
    pass


def raises(scan):
    if scan.time > 2.0:
        raise Mine("at", scan.time)
    return runs_of(scan)


answers = {}


def answer(scan):
    return answers["now"](scan)


def motion_model(poses, motion, normals):
    x, y, theta = poses.T
    dx, dy, turn = motion.displacement
    c, s = np.cos(theta), np.sin(theta)
    moved = np.stack([x + c * dx - s * dy, y + s * dx + c * dy, theta + turn], axis=1)
    return moved + normals * (0.008 if motion.moved else 0.0)


def weighted(poses, motion, normals):
    assert poses.shape == normals.shape == (1, 3)
    return motion_model(poses, motion, normals), -0.5 * (normals ** 2).sum(axis=1)


told = []


def watched(poses, motion, normals):
    told.append((poses, motion, normals))
    return motion_model(poses, motion, normals)


def proposes_badly(poses, motion, normals):
    return answers["proposal"](poses)


def setUpModule():
    hitos.add_line_method("own", runs_of, label="Own", purpose="takes every run for a line")
    hitos.add_line_method("fitted", fitted, reads=["split_merge.dmax"])
    hitos.add_line_method("some", some, random=True)
    hitos.add_line_method("meet", meet)
    hitos.add_line_method("raises", raises)
    hitos.add_line_method("answer", answer)
    hitos.add_proposal("own", motion_model, purpose="constant noise")
    hitos.add_proposal("weighted", weighted, weighted=True)
    hitos.add_proposal("watched", watched)
    hitos.add_proposal("bad", proposes_badly)


def run(**values):
    return hitos.run("corridor", {**FEW, **{key.replace("__", "."): value
                                           for key, value in values.items()}})


class LineMethods(unittest.TestCase):
    def test_it_is_chosen_like_any_other(self):
        chosen = {p.key: p for p in hitos.parameters()}["features.method"]
        self.assertEqual(chosen.choices["own"], "takes every run for a line")
        result = run(features__method="own")
        self.assertGreater(len(result.landmarks), 3)
        np.testing.assert_array_equal(result.trajectory,
                                      run(features__method="own").trajectory)

    def test_lines_may_come_fitted(self):
        one, other = run(features__method="own"), run(features__method="fitted")
        self.assertEqual(len(one.landmarks), len(other.landmarks))
        np.testing.assert_allclose(one.observed_lines, other.observed_lines, atol=1e-9)

    def test_random_methods_repeat(self):
        one, other = run(features__method="some"), run(features__method="some")
        np.testing.assert_array_equal(one.trajectory, other.trajectory)
        elsewhere = run(features__method="some", run__seed=2)
        self.assertFalse(np.array_equal(one.figures["seen_lines"],
                                        elsewhere.figures["seen_lines"]))

    def test_it_observes_what_it_says(self):
        snapshot = hitos.Run("corridor", {"features.method": "own"}).step(5)
        self.assertEqual(len(snapshot.observed_lines), len(runs_of(snapshot.scan)))

    def test_what_it_raises_arrives_as_it_is(self):
        run_ = hitos.Run("corridor", {"features.method": "raises"})
        for _ in range(2):  # a failed run says so again
            try:
                run_.finish()
                self.fail("nothing was raised")
            except Mine as raised:
                self.assertEqual(raised.args[0], "at")
                frames = [f.name for f in traceback.extract_tb(raised.__traceback__)]
                self.assertEqual((frames[-1], len(frames)), ("raises", 2))

    def test_impossible_answers_are_refused(self):
        for returned, kind, words in [
                (lambda scan: [(0, 1)], hitos.Error, "two or more"),
                (lambda scan: [(0, len(scan) + 1)], hitos.Error, "two or more"),
                (lambda scan: [(-1, 5)], hitos.Error, "two or more"),
                (lambda scan: [(0.5, 5)], hitos.Error, "whole"),
                (lambda scan: [(1.0, 0.0, 0, 5), (float("nan"), 0.0, 0, 5)], hitos.Error,
                 "rho nan, theta 0 for line 2 of the scan at .* s; expected finite numbers"),
                (lambda scan: [(float("inf"), 0.0, 0, 5)], hitos.Error, "finite"),
                (lambda scan: [(1.0, float("-inf"), 0, 5)], hitos.Error, "finite"),
                (lambda scan: [(float("nan"), 5)], hitos.Error, "whole"),
                (lambda scan: [(0, float("inf"))], hitos.Error, "two or more"),
                (lambda scan: [(1, 2, 3)], ValueError, "expected a row"),
                (lambda scan: "lines", ValueError, "could not convert"),
                (lambda scan: [(0, 2), (0,)], ValueError, "")]:
            answers["now"] = returned
            with self.subTest(words), self.assertRaisesRegex(kind, words):
                run(features__method="answer")
        answers["now"] = lambda scan: []
        self.assertEqual(len(run(features__method="answer").landmarks), 0)

    def test_two_runs_go_on_side_by_side(self):
        results = []
        threads = [threading.Thread(target=lambda: results.append(run(features__method="meet")))
                   for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 2)
        np.testing.assert_array_equal(results[0].trajectory, results[1].trajectory)
        self.assertFalse(barrier.broken)
        self.assertEqual(len(seen_by_thread), 2)  # neither of them a thread of Python
        self.assertTrue(set(seen_by_thread).isdisjoint(thread.ident for thread in threads))

    def test_a_run_is_for_one_thread_at_a_time(self):
        run_ = hitos.Run("corridor", FEW)
        problems = []

        def again(progress):
            try:
                run_.step()
            except hitos.Error as error:
                problems.append(str(error))
            return False
        run_.finish(progress=again)
        self.assertIn("under way", problems[0])

    def test_words_that_are_taken_or_late_are_refused(self):
        with self.assertRaisesRegex(hitos.ConfigurationError, "too late"):
            hitos.add_line_method("late", runs_of)
        with self.assertRaises(TypeError):
            hitos.add_line_method("none", None)


class Proposals(unittest.TestCase):
    def test_it_is_chosen_like_any_other_and_repeats(self):
        one, other = run(filter__proposal="own"), run(filter__proposal="own")
        np.testing.assert_array_equal(one.trajectory, other.trajectory)
        self.assertLess(one.summary["trajectory_error"]["ate_rmse_m"], 0.3)

    def test_the_number_of_threads_changes_nothing(self):
        # So many particles are worked on in blocks of other sizes by many threads.
        one = run(filter__proposal="own", filter__particles=1000, run__threads=1)
        other = run(filter__proposal="own", filter__particles=1000, run__threads=16)
        np.testing.assert_array_equal(one.trajectory, other.trajectory)
        np.testing.assert_array_equal(one.particles, other.particles)

    def test_it_draws_as_the_motion_model_of_constant_noise(self):
        values = {"motion__model": "odometry", "motion__sigma_x": 0.008,
                  "motion__sigma_y": 0.008, "motion__sigma_theta": 0.008}
        own, built_in = run(filter__proposal="own", **values), run(**values)
        np.testing.assert_allclose(own.trajectory, built_in.trajectory, atol=1e-6)

    def test_it_is_told_of_the_motion(self):
        told.clear()
        snapshots = list(hitos.Run("corridor", {**FEW, "filter.proposal": "watched"}))
        self.assertEqual(len(told), len(snapshots))
        poses, motion, normals = told[0]
        self.assertTrue(motion.first)
        self.assertFalse(normals.any())
        for before, after, (poses, motion, normals) in zip(snapshots, snapshots[1:], told[1:]):
            self.assertFalse(motion.first)
            # NumPy's cosine of a column with gaps depends on where it lies.
            self.assertTrue(poses.T.flags.c_contiguous and normals.T.flags.c_contiguous)
            np.testing.assert_array_equal(poses, before.particles)
            np.testing.assert_array_equal(motion.scan.points, after.scan.points)
            x, y, turn = motion.displacement
            self.assertEqual(motion.moved, bool(motion.path or motion.turned))
            step = after.odometry[-1] - before.odometry[-1]
            self.assertAlmostEqual(np.hypot(x, y), np.hypot(step[1], step[2]))
            self.assertAlmostEqual(np.cos(turn), np.cos(step[3]))
            self.assertAlmostEqual(motion.controls[:, 3].sum(), step[0])
        self.assertGreater(sum(m.path for _, m, _ in told), 1.0)

    def test_normals_are_standard_normal(self):
        told.clear()
        run(filter__proposal="watched")
        normals = np.concatenate([normal for _, _, normal in told[1:]])
        self.assertLess(abs(normals.mean()), 0.05)
        self.assertLess(abs(normals.std() - 1), 0.05)
        self.assertEqual(len(np.unique(normals)), normals.size)

    def test_weights_are_heeded(self):
        plain = run(filter__proposal="own")
        heeded = run(filter__proposal="weighted")
        np.testing.assert_allclose(plain.figures[0]["neff"], heeded.figures[0]["neff"])
        moving = plain.figures["neff"] != heeded.figures["neff"]
        self.assertTrue(moving.any())

    def test_impossible_answers_are_refused(self):
        for returned, kind, words in [
                (lambda poses: poses[:-1], ValueError, "expected x, y, theta for each of 20"),
                (lambda poses: poses[:, :2], ValueError, "expected x, y, theta"),
                (lambda poses: None, ValueError, "expected x, y, theta"),
                (lambda poses: "poses", ValueError, "could not convert"),
                (lambda poses: 1 / 0, ZeroDivisionError, "")]:
            answers["proposal"] = returned
            with self.subTest(words), self.assertRaisesRegex(kind, words):
                run(filter__proposal="bad")


if __name__ == "__main__":
    unittest.main()
