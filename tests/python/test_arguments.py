# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of wrong types: a sentence names the argument, what was found and what was expected."""
import pathlib
import tempfile
import unittest

import numpy as np

import hitos

FEW = {"filter.particles": 5}
PATH = np.zeros((3, 4))


class Arguments(unittest.TestCase):
    def refused(self, words, function, *arguments, **named):
        with self.subTest(words), self.assertRaises(TypeError) as raised:
            function(*arguments, **named)
        self.assertEqual(str(raised.exception), words)

    def test_of_tours(self):
        self.refused("source: expected a path or the name of a world (str, bytes or os.PathLike), "
                     "found 3 (int)", hitos.open, 3)
        self.refused("seed: expected a whole number from 0 to 18446744073709551615, "
                     "found '1' (str)", hitos.open, "corridor", seed="1")
        self.refused("seed: expected a whole number from 0 to 18446744073709551615, "
                     "found -1 (int)", hitos.open, "corridor", seed=-1)
        self.refused("max_range: expected a number, found 'far' (str)", hitos.open, "corridor",
                     max_range="far")
        self.refused("format: expected a str, found None (NoneType)", hitos.open, "corridor",
                     format=None)
        self.refused("world_set: expected a dict, a str or None, found 3 (int)", hitos.open,
                     "corridor", world_set=3)
        self.refused("world_set: expected keys that are str, found 3 (int)", hitos.open,
                     "corridor", world_set={3: 4})

    def test_of_runs(self):
        self.refused("tour: expected a Tour, a path or the name of a world (str, bytes or "
                     "os.PathLike), found 2.5 (float)", hitos.run, 2.5)
        self.refused("configuration: expected a Configuration, a dict or None, found 'few' (str)",
                     hitos.run, "corridor", "few")
        self.refused("configuration: expected keys that are str, found 3 (int)", hitos.run,
                     "corridor", {3: 4})
        self.refused("progress: expected a function or None, found 3 (int)", hitos.run, "corridor",
                     FEW, progress=3)
        self.refused("out: expected a path (str, bytes or os.PathLike) or None, found 3 (int)",
                     hitos.run, "corridor", FEW, out=3)
        self.refused("also: expected a str, several of them or None, found 3 (int)", hitos.run,
                     "corridor", FEW, out="x", also=3)
        self.refused("also: expected a str, several of them or None, found 3 (int)", hitos.run,
                     "corridor", FEW, out="x", also=["svg", 3])
        self.refused("reference_trajectory: expected an N x 4 array of 64-bit floats, a path (str, "
                     "bytes or os.PathLike) or None, found [] (list)", hitos.run, "corridor", FEW,
                     reference_trajectory=[])
        self.refused("uncertainty: expected True or False, found 'no' (str)", hitos.Run,
                     "corridor", FEW, uncertainty="no")
        run = hitos.Run("corridor", FEW)
        self.refused("scans: expected a whole number from 0 to 18446744073709551615, "
                     "found 1.5 (float)", run.step, 1.5)
        self.refused("progress: expected a function or None, found 1 (int)", run.finish, 1)
        self.assertEqual(run.step(np.int64(2)).scans, 2)
        self.refused("folder: expected a path (str, bytes or os.PathLike), found None (NoneType)",
                     run.result().write, None)

    def test_of_studies(self):
        with tempfile.TemporaryDirectory() as name:
            out = pathlib.Path(name, "out")
            self.refused("vary: expected a dict, found 'p' (str)", hitos.study, "corridor", "p",
                         out=out)
            self.refused("vary: expected keys that are str, found 3 (int)", hitos.study,
                         "corridor", {3: [4]}, out=out)
            self.refused("vary: expected the values of p as a list or a str like \"10:100:10\", "
                         "found 3 (int)", hitos.study, "corridor", {"p": 3}, out=out)
            self.refused("runs: expected a whole number from -2147483648 to 2147483647, "
                         "found 2.0 (float)", hitos.study, "corridor", {"p": [3]}, out=out,
                         runs=2.0)
            self.refused("progress: expected a function or None, found 'x' (str)", hitos.study,
                         "corridor", {"p": [3]}, out=out, progress="x")
            self.assertFalse(out.exists())

    def test_of_configurations(self):
        configuration = hitos.Configuration()
        self.refused("values: expected a dict or None, found [] (list)", hitos.Configuration, [])
        self.refused("preset: expected a str or None, found 3 (int)", hitos.Configuration,
                     preset=3)
        self.refused("key: expected a str, found 3 (int)", configuration.__getitem__, 3)
        self.refused("key: expected a str, found 3 (int)", configuration.__setitem__, 3, 4)
        self.refused("values: expected a dict, found None (NoneType)", configuration.update, None)
        self.refused("values: expected keys that are str, found 3 (int)", configuration.update,
                     {3: 4})
        self.refused("other: expected a Configuration, found {} (dict)",
                     configuration.differences, {})

    def test_of_measures_and_methods(self):
        self.refused("estimate: expected an array of 64-bit floats, found [] (list)",
                     hitos.trajectory_error, [], PATH)
        self.refused("tolerance: expected a number, found 'x' (str)", hitos.trajectory_error, PATH,
                     PATH, "x")
        self.refused("path: expected a path (str, bytes or os.PathLike), found 3 (int)",
                     hitos.read_trajectory, 3)
        self.refused("trajectory: expected an array of 64-bit floats, found None (NoneType)",
                     hitos.draw_grid, "corridor", None)
        self.refused("function: expected a function, found 3 (int)", hitos.add_line_method, "x", 3)
        self.refused("word: expected a str, found 3 (int)", hitos.add_proposal, 3, print)
        self.refused("reads: expected a sequence of str, found [3] (list)", hitos.add_proposal,
                     "x", print, reads=[3])

    def test_long_ones_are_cut(self):
        with self.assertRaises(TypeError) as raised:
            hitos.open("corridor", seed=list(range(1000)))
        self.assertLess(len(str(raised.exception)), 150)
        self.assertTrue(str(raised.exception).endswith(" … (list)"))


if __name__ == "__main__":
    unittest.main()
