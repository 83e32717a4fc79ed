# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies: the tables of the command line, resumed and stopped."""
import pathlib
import tempfile
import unittest

import numpy as np

import hitos
from support import DATA, cli

FEW = {"filter.particles": 10}


class Studies(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_tables_are_those_of_the_command_line(self):
        reference = DATA / "maps" / "corridor.map"
        said = cli("study", "corridor", "--set", "filter.particles=10", "--reference", reference,
                   "--vary", "dmax=0.02,0.05", "--runs", "2", "--seed", "3", "--odometry-noise",
                   "0.1", "--csv", "--out", self.folder / "cli")
        study = hitos.study("corridor", {"dmax": [0.02, 0.05]}, FEW, reference=reference, runs=2,
                            first_seed=3, odometry_noise=0.1, out=self.folder / "python")
        self.assertEqual(study.to_csv(), said)
        for name in ("quality.csv", "summary.csv", "summary.md"):
            self.assertEqual((self.folder / "python" / name).read_text(),
                             (self.folder / "cli" / name).read_text())
        self.assertEqual(study.keys, ["split_merge.dmax"])
        self.assertEqual([cell["values"] for cell in study.cells],
                         [{"split_merge.dmax": "0.02"}, {"split_merge.dmax": "0.05"}])
        runs = study.runs
        np.testing.assert_array_equal(runs["cell"], [0, 0, 1, 1])
        np.testing.assert_array_equal(runs["seed"], [3, 4, 3, 4])
        self.assertTrue(runs["ok"].all())
        for place, cell in enumerate(study.cells):
            errors = runs["error"][runs["cell"] == place]
            self.assertAlmostEqual(cell["error"]["mean"], errors.mean())
            self.assertAlmostEqual(cell["error"]["variance"], errors.var(ddof=1))
        self.assertIn("| 0.02 |", study.to_markdown())
        for figure in study.cells[0].keys() - {"values", "finished", "failed"}:
            self.assertIn(figure, runs.dtype.names)
            self.assertIn(f"\n{figure}", hitos.Study.runs.__doc__)
        np.testing.assert_array_equal(runs["landmarks"], runs["lines"] + runs["corners"])

    def test_values_come_in_every_way_that_the_command_line_has(self):
        for vary, texts in [
                ({"p": "10:20:5"}, [["10"], ["15"], ["20"]]),
                ({"filter.particles": (5, np.int64(6))}, [["5"], ["6"]]),
                ({"sensor": [(0.04, 0.00122)]}, [["0.04", "0.00122"]]),
                ({"dmax": [0.03], "p": [5, 6]}, [["0.03", "5"], ["0.03", "6"]])]:
            with self.subTest(vary):
                study = hitos.study("corridor", vary, FEW, runs=1,
                                    out=self.folder / "-".join(vary))
                self.assertEqual([list(cell["values"].values()) for cell in study.cells], texts)
        self.assertTrue(np.isnan(study.runs["error"]).all())  # no reference map
        self.assertFalse(np.isnan(study.runs["trajectory_error"]).any())

    def test_what_is_done_is_found_done(self):
        first = hitos.study("corridor", {"p": [5]}, runs=2, out=self.folder / "s")
        again = hitos.study("corridor", {"p": [5]}, runs=2, out=self.folder / "s")
        self.assertEqual((first.computed, first.reused), (2, 0))
        self.assertEqual((again.computed, again.reused), (0, 2))
        np.testing.assert_array_equal(first.runs["trajectory_error"],
                                      again.runs["trajectory_error"])

    def test_progress_is_told_and_may_stop(self):
        seen = []
        study = hitos.study("corridor", {"p": [5, 6]}, runs=2, out=self.folder / "s",
                            progress=seen.append)
        self.assertEqual(seen[-1].runs, 4)
        self.assertFalse(study.stopped)
        endless = hitos.open("bigloop", world_set={"tour.laps": 100})
        stopped = hitos.study(endless, {"p": [500, 600]}, runs=2, out=self.folder / "t",
                              progress=lambda now: False)
        self.assertTrue(stopped.stopped)
        self.assertFalse(stopped.runs["ok"].all())

        def fails(now):
            raise LookupError("enough")
        with self.assertRaisesRegex(LookupError, "enough"):
            hitos.study(endless, {"p": [500]}, out=self.folder / "u", progress=fails)

    def test_mistakes_are_told_before_anything_runs(self):
        for vary, words in [({"no.such": [1]}, "no.such"), ({"p": []}, "p"),
                            ({"p": [5, 5]}, "5"), ({"run.seed": [1]}, "run.seed"),
                            ({"sensor": [0.1]}, "sensor")]:
            with self.subTest(vary), self.assertRaisesRegex(hitos.Error, words):
                hitos.study("corridor", vary, out=self.folder / "s")
        self.assertFalse((self.folder / "s" / "quality.csv").exists())

    def test_a_value_that_no_run_can_have_is_refused_before(self):
        with self.assertRaisesRegex(hitos.ConfigurationError, "filter.particles: 0 is out of"):
            hitos.study("corridor", {"filter.particles": [5, 0]}, runs=1, out=self.folder / "s")
        self.assertFalse((self.folder / "s").exists())

    def test_runs_that_fail_all_say_why(self):
        with self.assertRaisesRegex(hitos.Error, "every run failed.*nowhere.log"):
            hitos.study("corridor", {"source.file": [str(self.folder / "nowhere.log")]}, runs=1,
                        out=self.folder / "s")


if __name__ == "__main__":
    unittest.main()
