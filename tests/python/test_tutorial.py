# SPDX-License-Identifier: GPL-3.0-or-later
"""The tutorial runs without a display and makes its four figures; the words of help() run too."""
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

import hitos
from support import SOURCE

TUTORIAL = SOURCE / "examples" / "python" / "tutorial.py"


def python(*words, cwd):
    return subprocess.run([sys.executable, "-W", "error", *map(str, words)], cwd=cwd, text=True,
                          capture_output=True, check=False,
                          env={**os.environ, "MPLBACKEND": "Agg"})


def indented(text):
    """The indented blocks of a text, as one script."""
    return "\n".join(line[4:] if line.startswith("    ") else "" for line in text.splitlines())


class Tutorial(unittest.TestCase):
    def test_it_makes_four_figures(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("matplotlib is not installed")
        with tempfile.TemporaryDirectory() as folder:
            done = python(TUTORIAL, "figures", cwd=folder)
            self.assertEqual((done.stderr, done.returncode), ("", 0))
            files = sorted(pathlib.Path(folder, "figures").iterdir())
            self.assertEqual([file.name for file in files],
                             ["map.png", "steps.png", "study.png", "tour.png"])
            for file in files:
                with self.subTest(file.name):
                    content = file.read_bytes()
                    self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
                    width, height = struct.unpack(">II", content[16:24])
                    self.assertGreater(min(width, height), 400)

    def test_what_help_says_runs(self):
        script = indented(hitos.__doc__)
        # Own methods come before anything is run, as the words beside them say.
        begin = script.index("def whole_runs")
        end = script.index("hitos.run(", begin)
        own = script[begin:end]
        script = "import hitos\n" + own + script.replace(own, "")
        with tempfile.TemporaryDirectory() as folder:
            done = python("-c", script, cwd=folder)
            self.assertEqual((done.stderr, done.returncode), ("", 0))

    def test_another_python_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            package = pathlib.Path(folder, "hitos")
            package.mkdir()
            for file in pathlib.Path(hitos.__file__).parent.iterdir():
                name = file.name.replace("cpython-", "cpython-9")
                if file.is_file():
                    (package / name).symlink_to(file)
            done = python("-c", "import sys; sys.path.insert(0, '.'); import hitos", cwd=folder)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"ImportError: hitos was built for another Python than .*cpython-9")

    def test_the_pages_examples_run(self):
        page = (SOURCE / "docs" / "python.md").read_text()
        blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
        self.assertEqual(len(blocks), 3)
        for block in blocks:
            with self.subTest(block), tempfile.TemporaryDirectory() as folder:
                pathlib.Path(folder, "data").symlink_to(SOURCE / "data")
                done = python("-c", "import hitos\nimport numpy as np\n" + block, cwd=folder)
                self.assertEqual((done.stderr, done.returncode), ("", 0))


if __name__ == "__main__":
    unittest.main()
