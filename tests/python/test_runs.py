# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs: the same as those of the command line, step by step or at one go, and what they give."""
import gc
import json
import pathlib
import tempfile
import threading
import unittest

import numpy as np

import hitos
from support import DATA, LOG, address, cli

FEW = {"filter.particles": 20}


def equal(one, other):
    """To the last bit, field by field: between fields lies what nobody set."""
    np.testing.assert_equal(one.shape, other.shape)
    for field in one.dtype.names or [...]:
        np.testing.assert_array_equal(one[field], other[field])


def same(one, other):
    for name in ("trajectory", "online_trajectory", "odometry", "particles", "weights",
                 "landmarks", "covariances", "segments", "associations"):
        equal(getattr(one, name), getattr(other, name))
    np.testing.assert_array_equal(one.grid.grey, other.grid.grey)


class Runs(unittest.TestCase):
    def test_loops_are_told_and_changed_by_hand(self):
        def run(**changed):
            return hitos.run(LOG, hitos.Configuration({"filter.particles": 3, **changed},
                                                      preset="recorded"))
        result = run()
        loops = result.loops
        self.assertEqual([loop["scan"] for loop in loops], sorted(loop["scan"] for loop in loops))
        closed = [loop for loop in loops if loop["verdict"] == "closed"]
        self.assertEqual(closed, [{**loop} for loop in result.summary["quality"]["loops"]])
        self.assertGreater(len(closed), 0)
        first = closed[0]
        edits = f"refuse {first['scan']} {first['earlier']}"
        changed = run(**{"registration.edits": edits})
        self.assertIn(("by-hand", first["scan"]),
                      [(loop["verdict"], loop["scan"]) for loop in changed.loops])
        self.assertEqual(changed.summary["quality"]["by_hand"]["refused"], 1)
        self.assertNotIn("by_hand", result.summary["quality"])
        self.assertFalse(np.array_equal(changed.trajectory, result.trajectory))
        equal(changed.trajectory, run(**{"registration.edits": edits}).trajectory)
        self.assertEqual(hitos.run("corridor", FEW).loops, [])
        with self.assertRaisesRegex(hitos.ConfigurationError, "change 1: found"):
            run(**{"registration.edits": "open 3"})

    def test_files_are_those_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            reference = DATA / "maps" / "corridor.map"
            distances = DATA / "worlds" / "corridor.distances"
            cli("run", "corridor", "--set", "filter.particles=20", "--seed", "5", "--reference",
                reference, "--distances", distances, "--uncertainty", "--out", folder / "cli")
            result = hitos.run("corridor", {**FEW, "run.seed": 5}, reference=reference,
                               distances=distances, uncertainty=True, out=folder / "python")
            again = result.write(folder / "again")
            names = {path.name for path in (folder / "cli").iterdir()}
            self.assertIn("uncertainty.csv", names)
            for other in ("python", "again"):
                self.assertEqual({path.name for path in (folder / other).iterdir()}, names)
                for file in names - {"summary.json"}:
                    self.assertEqual((folder / other / file).read_bytes(),
                                     (folder / "cli" / file).read_bytes(), file)

            def summary(of):
                said = json.loads((folder / of / "summary.json").read_text())
                return {key: value for key, value in said.items()
                        if key not in ("run_seconds", "scans_per_second", "source",
                                       "rest_xxh3_128")}
            self.assertEqual(summary("python"), summary("cli"))
            written = json.loads((folder / "again" / "summary.json").read_text())
            del written["rest_xxh3_128"]  # of the file's text
            self.assertEqual(again, written)
            self.assertEqual(result.summary["map_error"], again["map_error"])
            np.testing.assert_allclose(
                hitos.read_trajectory(folder / "cli" / "trajectory.tum"), result.trajectory,
                atol=1e-8)

    def test_further_files_are_written_where_they_are_asked_for(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            cli("run", "corridor", "--set", "filter.particles=20", "--write", "svg,g2o", "--out",
                folder / "cli")
            result = hitos.run("corridor", FEW, out=folder / "out", also="map.svg, g2o")
            result.write(folder / "list", also=["svg", "g2o"])
            result.write(folder / "none")
            result.write(folder / "all", also="all")
            names = {path.name for path in (folder / "cli").iterdir()}
            self.assertIn("map.svg", names)
            for other in ("out", "list"):
                self.assertEqual({path.name for path in (folder / other).iterdir()}, names)
                self.assertEqual((folder / other / "map.svg").read_bytes(),
                                 (folder / "cli" / "map.svg").read_bytes())
            self.assertFalse((folder / "none" / "map.svg").exists())
            self.assertLess(names, {path.name for path in (folder / "all").iterdir()})

    def test_files_of_no_run_are_not_written_over(self):
        with tempfile.TemporaryDirectory() as name:
            out = pathlib.Path(name)
            (out / "map.txt").write_text("mine")
            with self.assertRaisesRegex(hitos.FileError, "holds map.txt, which is of no run"):
                hitos.run("corridor", FEW, out=out)
            self.assertEqual([path.name for path in out.iterdir()], ["map.txt"])
            self.assertEqual((out / "map.txt").read_text(), "mine")

    def test_further_files_that_there_are_not_are_refused(self):
        with tempfile.TemporaryDirectory() as name:
            out = pathlib.Path(name, "out")
            for also, words in [("map.svgg", "also: .*did you mean map.svg"),
                                (["svg", "pict"], "also: found \"pict\"")]:
                with self.assertRaisesRegex(hitos.ConfigurationError, words) as raised:
                    hitos.run("corridor", FEW, out=out, also=also)
                self.assertEqual(raised.exception.key, "also")
            with self.assertRaisesRegex(hitos.ConfigurationError, "give out too"):
                hitos.run("corridor", FEW, also="svg")
            self.assertFalse(out.exists())

    def test_several_threads_write_at_once(self):
        result = hitos.run("corridor", FEW)
        problems = []
        begin = threading.Barrier(6)

        def work(folder):
            try:
                begin.wait()
                for _ in range(3):
                    if folder is None:
                        self.assertEqual(result.summary["scans"], result.scans)
                    else:
                        result.write(folder)
            except Exception as error:
                problems.append(error)
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            folders = [root / "a", root / "a", root / "b", root / "c", None, None]
            threads = [threading.Thread(target=work, args=(folder,)) for folder in folders]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertEqual(problems, [])
            self.assertEqual({path.name for path in root.iterdir()}, {"a", "b", "c"})
            for folder in ("a", "b", "c"):
                cli("verify", root / folder)

    def test_a_log_runs_with_the_thesis_values(self):
        with tempfile.TemporaryDirectory() as name:
            cli("run", LOG, "--set", "filter.particles=20", "--out", pathlib.Path(name, "cli"))
            result = hitos.run(LOG, FEW, out=pathlib.Path(name, "python"))
            for file in ("map.txt", "trajectory.tum", "config.cfg"):
                self.assertEqual(pathlib.Path(name, "python", file).read_bytes(),
                                 pathlib.Path(name, "cli", file).read_bytes(), file)
        self.assertEqual(result.scans, 1050)

    def test_step_by_step_is_the_run_at_one_go(self):
        whole = hitos.run("corridor", FEW)
        run = hitos.Run("corridor", FEW)
        snapshots = list(run)
        self.assertEqual([s.scans for s in snapshots], list(range(1, whole.scans + 1)))
        self.assertIsNone(run.step())
        same(run.result(), whole)
        same(run.snapshot(), whole)
        leaps = hitos.Run("corridor", FEW)
        while leaps.step(7):
            pass
        same(leaps.result(), whole)
        self.assertTrue(whole.finished)

    def test_the_number_of_threads_changes_nothing(self):
        same(hitos.run("corridor", {"run.threads": 1}), hitos.run("corridor", {"run.threads": 3}))

    def test_another_seed_is_another_run(self):
        one = hitos.run("corridor", {**FEW, "run.seed": 1})
        other = hitos.run("corridor", {**FEW, "run.seed": 2})
        self.assertFalse(np.array_equal(one.trajectory, other.trajectory))

    def test_a_tour_brings_its_own_source_along(self):
        tour = hitos.open("corridor", tour_seed=7, world_set={"laser.sigma": 0.02})
        result = hitos.run(tour, hitos.Configuration(preset="simulated"))
        self.assertEqual(result.configuration["source.tour_seed"], 7)
        self.assertEqual(result.configuration["source.world_set"], "laser.sigma=0.02")
        self.assertEqual(result.summary["tour_seed"], 7)

    def test_progress_is_told_and_may_stop_the_run(self):
        seen = []
        whole = hitos.run("bigloop", FEW, progress=seen.append)
        self.assertEqual(seen[-1].scans, whole.scans)
        self.assertEqual(seen[-1].fraction, 1.0)
        self.assertTrue(seen[-1].finished)
        endless = hitos.open("bigloop", world_set={"tour.laps": 40})
        stopped = hitos.run(endless, FEW, progress=lambda p: p.scans < 10)
        self.assertFalse(stopped.finished)
        self.assertGreaterEqual(stopped.scans, 10)
        self.assertEqual(len(stopped.trajectory), stopped.scans)

    def test_what_progress_raises_arrives(self):
        class Mine(Exception):
            pass

        def fails(progress):
            raise Mine("enough")
        with tempfile.TemporaryDirectory() as name:
            with self.assertRaisesRegex(Mine, "enough"):
                hitos.run("bigloop", FEW, progress=fails, out=pathlib.Path(name, "out"))
            self.assertEqual(list(pathlib.Path(name).iterdir()), [])

    def test_results_say_when_they_are_of_the_past(self):
        run = hitos.Run("corridor", FEW)
        run.step(10)
        early = run.result()
        self.assertEqual(early.summary["scans"], 10)
        self.assertFalse(early.summary["finished"])
        run.step()
        with self.assertRaisesRegex(hitos.Error, "gone on"):
            early.summary
        with tempfile.TemporaryDirectory() as name:
            with self.assertRaisesRegex(hitos.Error, "gone on"):
                early.write(pathlib.Path(name, "out"))
            self.assertEqual(list(pathlib.Path(name).iterdir()), [])
        self.assertEqual((early.scans, len(early.figures)), (10, 10))

    def test_damage_in_the_middle_of_a_log_keeps_its_type(self):
        with tempfile.TemporaryDirectory() as name:
            log = pathlib.Path(name, "empty.log")
            log.write_text("POS 0.0 0.0 0.0 0.0\n" * 3)
            with self.assertRaises(hitos.FormatError) as raised:
                hitos.run(log)
            self.assertEqual(raised.exception.path, str(log))

    def test_inputs_are_not_overwritten(self):
        with tempfile.TemporaryDirectory() as name:
            log = pathlib.Path(name, "map.txt")
            cli("simulate", "corridor", "--out", log)
            with self.assertRaisesRegex(hitos.FileError, "another folder"):
                hitos.run(log, FEW, out=name)


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.snapshot = hitos.Run("corridor", FEW).step(40)

    def test_shapes(self):
        s = self.snapshot
        lines = int((s.landmarks["kind"] == "line").sum())
        self.assertEqual(s.trajectory.shape, (40, 4))
        self.assertEqual(s.online_trajectory.shape, (40, 4))
        self.assertEqual(s.odometry.shape, (40, 4))
        self.assertEqual(s.particles.shape, (20, 3))
        self.assertEqual(s.weights.shape, (20,))
        self.assertEqual(s.covariances.shape, (len(s.landmarks), 2, 2))
        self.assertEqual(s.pose_covariance.shape, (3, 3))
        self.assertEqual(s.segments.shape[1:], (2, 2))
        self.assertEqual(len(s.segments), len(s.segment_landmarks))
        self.assertTrue((s.landmarks["kind"][:lines] == "line").all())
        self.assertTrue((s.landmarks["kind"][lines:] == "corner").all())
        self.assertEqual(len(s.associations), len(s.observed_lines) + len(s.observed_corners))
        self.assertEqual(s.grid.grey.shape, s.grid.shape)

    def test_numbers_fit_each_other(self):
        s = self.snapshot
        self.assertAlmostEqual(s.weights.sum(), 1.0)
        np.testing.assert_array_equal(s.trajectory[-1, 1:], s.pose)
        np.testing.assert_array_equal(s.particles[s.best], s.pose)
        np.testing.assert_allclose(s.pose_covariance, s.pose_covariance.T, atol=1e-15)
        self.assertEqual(s.trajectory[-1, 0], s.time)
        lines = s.landmarks[s.landmarks["kind"] == "line"]
        np.testing.assert_allclose(lines["x"], lines["rho"] * np.cos(lines["theta"]), atol=1e-12)
        # Segments lie on their lines.
        of = s.landmarks[s.segment_landmarks]
        for end in (0, 1):
            away = (s.segments[:, end, 0] * np.cos(of["theta"])
                    + s.segments[:, end, 1] * np.sin(of["theta"]) - of["rho"])
            np.testing.assert_allclose(away, 0, atol=1e-9)
        self.assertTrue((np.linalg.eigvalsh(s.covariances) > 0).all())

    def test_nothing_is_copied_and_nothing_can_be_written(self):
        s = self.snapshot
        for name in ("trajectory", "online_trajectory", "odometry", "pose", "mean_pose",
                     "pose_covariance", "particles", "weights", "weights_before", "landmarks",
                     "covariances", "segments", "observed_lines", "associations"):
            with self.subTest(name):
                one, other = getattr(s, name), getattr(s, name)
                self.assertEqual(address(one), address(other))
                self.assertFalse(one.flags.owndata)
                self.assertFalse(one.flags.writeable)
                with self.assertRaises(ValueError):
                    one.flags.writeable = True
        # Poses and weights are members of the same structs, side by side in C++'s memory.
        self.assertEqual(address(s.weights) - address(s.particles), 24)
        self.assertEqual(s.weights.strides[0], s.particles.strides[0])
        self.assertEqual(address(s.grid.grey), address(s.grid.grey))
        self.assertFalse(s.grid.grey.flags.writeable)

    def test_views_outlive_snapshot_and_run(self):
        run = hitos.Run("corridor", FEW)
        snapshot = run.step(30)
        views = [snapshot.trajectory, snapshot.particles, snapshot.landmarks, snapshot.segments,
                 snapshot.scan.points, snapshot.grid.grey, run.result().grid.log_odds]
        kept = [view.copy() for view in views]
        run.step(20)
        del run, snapshot
        gc.collect()
        rubbish = [np.full(100_000, 7.0) for _ in range(50)]
        for view, copy in zip(views, kept):
            equal(view, copy)
        del rubbish

    def test_snapshots_stay_what_they_were(self):
        run = hitos.Run("corridor", FEW)
        first = run.step(10)
        before = first.trajectory.copy(), first.particles.copy(), first.grid.grey.copy()
        run.step(50)
        np.testing.assert_array_equal(first.trajectory, before[0])
        np.testing.assert_array_equal(first.particles, before[1])
        np.testing.assert_array_equal(first.grid.grey, before[2])
        self.assertEqual(first.scans, 10)

    def test_grids(self):
        result = hitos.run("corridor", FEW)
        grid = result.grid
        self.assertEqual(grid.log_odds.shape, grid.shape)
        known = grid.log_odds != 0
        self.assertTrue((grid.grey[~known] == hitos.UNKNOWN_GREY).all())
        self.assertTrue(known.any())
        free = 1 / (1 + np.exp(grid.log_odds[known].astype(float)))
        grey = np.interp(free, [0, 0.5, 1], [0, hitos.UNKNOWN_GREY, 255])
        np.testing.assert_allclose(grid.grey[known], grey, atol=1.01)
        left, right, bottom, top = grid.extent
        self.assertAlmostEqual((right - left) / grid.resolution, grid.shape[1])
        self.assertAlmostEqual((top - bottom) / grid.resolution, grid.shape[0])
        # Row 0 is the lowest: the robot's first place, (0, 0), is free.
        row, column = int(-bottom / grid.resolution), int(-left / grid.resolution)
        self.assertGreater(grid.grey[row, column], hitos.UNKNOWN_GREY)
        drawn = hitos.draw_grid("corridor", result.trajectory, FEW)
        self.assertIsNone(self.snapshot.grid.log_odds)
        coarse = hitos.draw_grid("corridor", result.trajectory, {"grid.resolution": 0.2})
        self.assertEqual(coarse.resolution, 0.2)
        self.assertLess(coarse.grey.size, drawn.grey.size / 10)

    def test_figures_have_a_row_for_every_scan(self):
        result = hitos.run("corridor", FEW)
        figures = result.figures
        self.assertEqual(len(figures), result.scans)
        np.testing.assert_array_equal(
            np.stack([figures[n] for n in ("x", "y", "theta")], 1),
            result.online_trajectory[:, 1:])
        self.assertTrue((figures["neff"] <= 20 + 1e-9).all())
        self.assertEqual(figures["lines"][-1] + figures["corners"][-1], len(result.landmarks))


if __name__ == "__main__":
    unittest.main()
