# SPDX-License-Identifier: GPL-3.0-or-later
"""Configurations: every parameter by its key, checked when it is set."""
import pathlib
import re
import tempfile
import unittest

import numpy as np

import hitos
from support import SOURCE, cli


class Configurations(unittest.TestCase):
    def test_keys_and_defaults_are_those_of_the_command_line(self):
        said = dict(re.findall(r"^  ([\w.]+) = (\S*)", cli("parameters"), re.MULTILINE))
        listed = {p.key: p.default for p in hitos.parameters()}
        self.assertEqual(list(listed), list(said))
        for key, text in said.items():
            with self.subTest(key):
                kind = type(listed[key])
                self.assertEqual(kind(text), listed[key])
        self.assertEqual(hitos.Configuration().to_dict(), listed)
        self.assertEqual(list(hitos.Configuration()), list(listed))

    def test_parameters_say_what_they_are(self):
        by_key = {p.key: p for p in hitos.parameters()}
        particles = by_key["filter.particles"]
        self.assertEqual((particles.minimum, particles.default), (1, 100))
        self.assertIn("integers from 1", particles.allowed)
        self.assertIn("split-merge", by_key["features.method"].choices)
        self.assertEqual(by_key["split_merge.dmax"].unit, "m")
        self.assertEqual(by_key["split_merge.dmax"].symbol, "Dmax")
        self.assertIn("features.method", by_key["ransac.threshold"].read_where)
        self.assertIsNone(by_key["features.method"].minimum)

    def test_values_keep_their_types(self):
        c = hitos.Configuration({"filter.particles": np.int32(7), "split_merge.dmax": 1})
        self.assertEqual((c["filter.particles"], c["split_merge.dmax"]), (7, 1.0))
        c["split_merge.dmax"] = np.float64(0.1)
        c["resampling.rule"] = "neff"
        c["landmarks.vanish"] = True
        self.assertEqual(c["split_merge.dmax"], 0.1)
        self.assertEqual(c["landmarks.vanish"], "on")
        c["split_merge.dmax"] = "0.25"
        self.assertEqual(c["split_merge.dmax"], 0.25)

    def test_what_cannot_be_is_refused_and_changes_nothing(self):
        c = hitos.Configuration()
        before = c.copy()
        for key, value, words in [
                ("filter.particels", 3, "did you mean filter.particles"),
                ("filter.particles", 3.0, "not an integer"),
                ("filter.particles", np.float32(3), "not an integer"),
                ("filter.particles", 0, "1 to"),
                ("filter.particles", True, "not an integer"),
                ("filter.particles", None, "not an integer"),
                ("split_merge.dmax", "wide", "not a number"),
                ("split_merge.dmax", float("nan"), "split_merge.dmax"),
                ("features.method", "own", "split-merge")]:
            with self.subTest(key=key, value=value):
                with self.assertRaisesRegex(hitos.ConfigurationError, re.escape(words)) as raised:
                    c[key] = value
                self.assertEqual(raised.exception.key, key)
                self.assertIsInstance(raised.exception, ValueError)
                with self.assertRaises(hitos.ConfigurationError):
                    c.update({"filter.particles": 9, key: value})
                self.assertEqual(c, before)
        with self.assertRaises(hitos.ConfigurationError):
            c["no.such"]
        self.assertNotIn("no.such", c)

    def test_presets_and_files(self):
        self.assertEqual(set(hitos.presets()),
                         {p.stem for p in (SOURCE / "config").glob("*.cfg")} - {"init"})
        c = hitos.Configuration({"filter.particles": 9}, preset="recorded")
        self.assertEqual(c["filter.particles"], 9)
        self.assertNotEqual(c, hitos.Configuration({"filter.particles": 9}))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "c.cfg")
            c.write(file)
            self.assertEqual(hitos.Configuration(file=file), c)
            self.assertEqual(file.read_text(), c.to_text())
            file.write_text("[filter]\nparticels = 3\n")
            with self.assertRaises(hitos.FormatError) as raised:
                hitos.Configuration(file=file)
            self.assertEqual(raised.exception.line, 2)
        with self.assertRaisesRegex(hitos.ConfigurationError, "recorded"):
            hitos.Configuration(preset="unheard")
        with self.assertRaises(hitos.ConfigurationError):
            hitos.Configuration(preset="recorded", file="c.cfg")

    def test_copies_are_independent_and_differences_told(self):
        a = hitos.Configuration()
        b = a.copy()
        b["filter.particles"] = 5
        self.assertEqual(a["filter.particles"], 100)
        self.assertEqual(a.differences(b), ["filter.particles"])
        self.assertEqual(eval(repr(b), {"Configuration": hitos.Configuration}), b)

    def test_a_run_keeps_the_configuration_it_began_with(self):
        c = hitos.Configuration({"filter.particles": 5}, preset="simulated")
        run = hitos.Run("corridor", c)
        c["filter.particles"] = 50
        self.assertEqual(run.configuration["filter.particles"], 5)
        run.configuration["filter.particles"] = 50
        self.assertEqual(len(run.step().particles), 5)


if __name__ == "__main__":
    unittest.main()
