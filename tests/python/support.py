# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the Python module share."""
import os
import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ["HITOS_BIN_DIR"])
DATA = SOURCE / "data"
LOG = DATA / "bigloop.log.gz"


def cli(*words):
    """Runs hitos-cli, which must succeed."""
    return subprocess.run([BIN / "hitos-cli", *map(str, words)], check=True, text=True,
                          capture_output=True).stdout


def start(script, *words):
    """A Python of its own that runs the script, with pipes to it."""
    return subprocess.Popen([sys.executable, "-c", script, *map(str, words)], text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def address(array):
    return array.__array_interface__["data"][0]
