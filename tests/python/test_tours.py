# SPDX-License-Identifier: GPL-3.0-or-later
"""Tours: whatever can be opened, its scans, its odometry, its truth."""
import gc
import math
import pathlib
import tempfile
import unittest

import numpy as np

import hitos
from support import DATA, LOG, SOURCE, address, cli


class Tours(unittest.TestCase):
    def test_every_dialect_opens_and_gives_its_fifty_scans(self):
        logs = sorted((DATA / "logs").glob("*.log.gz"))
        self.assertEqual(len(logs), 7)
        for log in logs:
            with self.subTest(log.name):
                tour = hitos.open(log)
                self.assertEqual(tour.format, log.name.split("-")[0].split(".")[0])
                scans = list(tour)
                self.assertEqual(len(scans), 50)
                self.assertTrue(all(a.time <= b.time for a, b in zip(scans, scans[1:])))
                self.assertTrue(all(np.isfinite(scan.points).all() for scan in scans))
                self.assertGreater(len(tour.odometry()), 10)
                self.assertEqual(tour.summary()["scans"], 50)

    def test_every_world_opens(self):
        self.assertIn("bigloop", hitos.worlds())
        for world in hitos.worlds():
            with self.subTest(world):
                tour = hitos.open(world)
                self.assertEqual(tour.format, "world")
                self.assertEqual(tour.truth.trajectory.shape[1], 4)
                self.assertEqual(tour.truth.walls.shape[1:], (2, 2))
                scan = next(iter(tour))
                self.assertEqual(len(scan) == 0, world == "posts")
                self.assertEqual(len(scan.landmarks) == 0, world != "posts")

    def test_landmarks_have_names(self):
        seen = np.concatenate([scan.landmarks for scan in hitos.open("posts")])
        self.assertEqual({*seen["identity"]}, set(range(15)))
        self.assertLess(seen["range"].max(), 12.6)
        self.assertLess(np.abs(seen["bearing"]).max(), 1.8)
        nameless = hitos.open("posts", world_set={"landmarks.identities": "false"})
        self.assertEqual({*next(iter(nameless)).landmarks["identity"]}, {-1})

    def test_recordings_open_by_topic(self):
        bag = SOURCE / "tests" / "fuzz" / "corpus" / "rosbag" / "two-lasers.bag"
        with self.assertRaisesRegex(hitos.Error, "topic"):
            hitos.open(bag)
        both = hitos.open(bag, scan_topic="all")
        self.assertEqual(both.format, "rosbag")
        self.assertEqual(len(list(both)), both.summary()["scans"])

    def test_scans_before_the_odometry_can_be_left_out(self):
        bag = SOURCE / "tests" / "unit" / "capture" / "two-lasers-cut.bag"
        kept = hitos.open(bag, scan_topic="all").summary()
        left = hitos.open(bag, scan_topic="all", early_scans="leave_out").summary()
        self.assertGreater(kept["early_scans"], 0)
        self.assertEqual(left["early_scans_left_out"], kept["early_scans"])
        self.assertEqual(left["scans"], kept["scans"] - kept["early_scans"])

    def test_the_truth_is_one(self):
        tour = hitos.open("corridor")
        self.assertEqual(address(tour.truth.trajectory), address(tour.truth.trajectory))

    def test_logs_know_no_truth(self):
        self.assertIsNone(hitos.open(LOG).truth)

    def test_ranges_and_angles_are_those_of_the_points(self):
        scan = next(iter(hitos.open(LOG)))
        x, y, theta = scan.laser_pose
        at = scan.angles + theta
        points = np.stack([x + scan.ranges * np.cos(at), y + scan.ranges * np.sin(at)], 1)
        np.testing.assert_allclose(points, scan.points, atol=1e-12)
        np.testing.assert_allclose(scan.first_angle + scan.rays * scan.angle_step, scan.angles,
                                   atol=1e-9)
        self.assertEqual(scan.ray_count, 181)
        self.assertTrue((scan.ranges < 50).all())

    def test_scans_are_read_as_the_programs_read_them(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder, "copy.log")
            cli("convert", LOG, "--to", "normalized", "--out", copy)
            pairs = list(zip(hitos.open(LOG), hitos.open(copy), strict=True))
        self.assertGreater(len(pairs), 1000)
        for one, other in pairs:
            self.assertEqual(one.time, other.time)
            np.testing.assert_array_equal(one.points, other.points)

    def test_two_loops_over_a_tour_do_not_disturb_each_other(self):
        tour = hitos.open(DATA / "logs" / "radish.log.gz")
        for one, other in zip(tour, tour, strict=True):
            self.assertEqual(one.line, other.line)

    def test_arrays_are_views_that_outlive_all_else(self):
        scan = next(iter(hitos.open(LOG)))
        points = scan.points
        self.assertEqual(address(points), address(scan.points))
        self.assertEqual(address(scan.ranges) + 8, address(scan.angles))  # pairs in C++'s memory
        kept = points.copy()
        for array in (points, scan.ranges, scan.rays, scan.run_starts):
            self.assertFalse(array.flags.writeable)
            self.assertFalse(array.flags.owndata)
            with self.assertRaises(ValueError):
                array[0] = 0
            with self.assertRaises(ValueError):
                array.flags.writeable = True
        del scan
        gc.collect()
        rubbish = [bytearray(len(points) * 16) for _ in range(100)]
        np.testing.assert_array_equal(points, kept)
        self.assertEqual(len(rubbish), 100)

    def test_a_world_can_be_changed_and_seeded(self):
        def first(**options):
            return next(iter(hitos.open("bigloop", **options))).ranges

        np.testing.assert_array_equal(first(), first(seed=1))
        self.assertFalse(np.array_equal(first(seed=1), first(seed=2)))
        np.testing.assert_array_equal(first(seed=1, tour_seed=9), first(seed=2, tour_seed=9))
        exact = first(world_set={"laser.sigma": 0.0})
        self.assertFalse(np.array_equal(exact, first()))
        self.assertEqual(hitos.open("bigloop", tour_seed=9).truth.seed, 9)

    def test_options_are_those_of_the_configuration(self):
        near = hitos.open(LOG, max_range=3.0)
        self.assertLess(max(scan.ranges.max() for scan in near if len(scan)), 3.0)
        with self.assertRaisesRegex(hitos.ConfigurationError, "odometry"):
            hitos.open(LOG, odometry="neither")

    def test_errors_are_typed_and_say_where(self):
        with self.assertRaises(hitos.FileError) as raised:
            hitos.open("no/such.log")
        self.assertEqual(raised.exception.path, "no/such.log")
        self.assertIn("no/such.log", str(raised.exception))
        self.assertIsInstance(raised.exception, OSError)
        with self.assertRaisesRegex(hitos.FileError, "bigloop2"):
            hitos.open("bigloup")
        with tempfile.TemporaryDirectory() as folder:
            world = pathlib.Path(folder, "bad.toml")
            world.write_text("[laser\n")
            with self.assertRaises(hitos.FormatError) as raised:
                hitos.open(world)
        self.assertEqual(raised.exception.path, str(world))
        self.assertEqual(raised.exception.line, 1)
        with self.assertRaises(TypeError):
            hitos.open(3.5)


class Measures(unittest.TestCase):
    def test_the_error_of_a_moved_path_is_none(self):
        path = hitos.open("bigloop").truth.trajectory
        turn = 0.7
        moved = path.copy()
        moved[:, 1] = 3 + path[:, 1] * math.cos(turn) - path[:, 2] * math.sin(turn)
        moved[:, 2] = -1 + path[:, 1] * math.sin(turn) + path[:, 2] * math.cos(turn)
        moved[:, 3] += turn
        error = hitos.trajectory_error(moved, path)
        self.assertLess(error.rmse, 1e-9)
        self.assertEqual(error.poses, len(path))
        moved[:, 0] += 1e6
        with self.assertRaisesRegex(hitos.Error, "is not one of this tour"):
            hitos.trajectory_error(moved, path)

    def test_arrays_of_another_kind_are_refused(self):
        path = hitos.open("bigloop").truth.trajectory
        with self.assertRaisesRegex(TypeError, "64-bit"):
            hitos.trajectory_error(path.astype(np.float32), path)
        with self.assertRaisesRegex(TypeError, "64-bit"):
            hitos.trajectory_error(path.tolist(), path)
        with self.assertRaisesRegex(ValueError, r"\(2227, 3\)"):
            hitos.trajectory_error(path[:, :3], path)
        for value in (np.nan, np.inf, -1e200):
            with self.assertRaisesRegex(ValueError, "estimate: .* row 3, column 2"):
                wrong = path.copy()
                wrong[3, 2] = value
                hitos.trajectory_error(wrong, path)
        # What lies otherwise in memory is read as it is.
        self.assertEqual(hitos.trajectory_error(np.asfortranarray(path)[::2], path[::2]).rmse,
                         hitos.trajectory_error(path[::2], path[::2]).rmse)

    def test_a_trajectory_file_reads_back(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "path.tum")
            file.write_text("1.5 2 3 0 0 0 0 1\n2.5 4 5 0 0 0 1 0\n")
            np.testing.assert_allclose(hitos.read_trajectory(file),
                                       [[1.5, 2, 3, 0], [2.5, 4, 5, math.pi]])


if __name__ == "__main__":
    unittest.main()
