# SPDX-License-Identifier: GPL-3.0-or-later
"""What the built programs tell of themselves by --help and their lists, and what a check may leave out."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

PROGRAMS = ("hitos-cli", "BatchSLAM", "hitos")
LEFT_OUT = 77  # the status of a test that could not look at anything


def said(*command, **more):
    """What the command prints; it must succeed."""
    done = subprocess.run([str(word) for word in command], text=True, capture_output=True, check=False, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed: {done.stdout}{done.stderr}")
    return done.stdout


def present(tool):
    """Whether the tool is installed; where not, it is said, and HITOS_REQUIRE_PACKAGING makes it a failure."""
    if shutil.which(tool):
        return True
    if os.environ.get("HITOS_REQUIRE_PACKAGING"):
        sys.exit(f"{tool} is not installed")
    print(f"left out: {tool} is not installed")
    return False


class Command:
    """A program or a subcommand, as its --help describes it."""

    def __init__(self, folder, words):
        self.words = words  # ("hitos-cli", "study", "merge")
        text = said(folder / words[0], *words[1:], "--help", env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
        # "  -h,--help   …", "  --seed,--tour-seed TEXT …", "  --pictures{first}  …"
        lines = re.findall(r"^  (-[^\s{]+)(?:\{\w+\})?( [A-Z=]+)?(:\{[^}]*\})?", text, re.MULTILINE)
        self.options = [(names.split(","), value.strip(), choices[2:-1].split(",") if choices else [])
                        for names, value, choices in lines]
        block = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.MULTILINE)
        self.below = re.findall(r"^  (\S+)", block[1], re.MULTILINE) if block else []

    def names(self):
        return [name for names, _, _ in self.options for name in names]

    def page(self):
        return "-".join(self.words)


def commands(folder, program):
    """The program and all its subcommands."""
    found = [Command(folder, (program,))]
    for command in found:
        found += [Command(folder, (*command.words, word)) for word in command.below]
    return found


def parameters(folder):
    """{key: [choices]} of `hitos-cli parameters`."""
    found = {}
    for line in said(folder / "hitos-cli", "parameters").splitlines():
        if key := re.match(r"  (\w+\.\w+) = ", line):
            choices = found[key[1]] = []
        elif words := re.match(r"      one of ([^;]*)", line):
            choices += words[1].split(", ")
    return found


def programs(folder):
    return [program for program in PROGRAMS if (pathlib.Path(folder) / program).exists()]
