#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The promises of docs/reliability.md, and the tests that hold them.

usage: .ci/promises.py BUILD

Runs the tests that the page's first table names, by ctest in the folder BUILD, and prints the table
with what came of them. check-docs asks whether the tests that documents name exist.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "reliability.md"


def tests_of_sources():
    """{suite: its tests}: GoogleTest's and Qt's; a fuzz target is a suite of none."""
    found = {}
    for path in [*ROOT.glob("tests/**/*.cpp"), *ROOT.glob("tests/**/*.hpp")]:
        text = path.read_text()
        for suite, test in re.findall(r"\bTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\)", text):
            found.setdefault(suite, set()).add(test)
        for suite, slots in re.findall(r"^class (\w+) : public QObject \{(.*?)^\};", text,
                                       re.MULTILINE | re.DOTALL):
            found.setdefault(suite, set()).update(re.findall(r"void (\w+)\(\);", slots))
        for target in re.findall(r'\bTarget\{"(\w+)"', text):
            found.setdefault(target, set())
    return found


def tests_named(cell, known):
    """[(suite, separator, test)] of a cell; a name alone is a suite, or a test of the last one."""
    found = []
    for name in re.findall(r"`([^`/]+)`", cell):
        suite, separator, test = re.fullmatch(r"(?:(.*?)(\.|::))?(.*)", name).groups()
        if suite is None and name in known:
            suite, separator, test = name, ".", "*"
        elif suite is None:
            suite, separator = found[-1][:2] if found else ("", ".")
        found.append((suite, separator, test))
    return found


def promises():
    """[(line, promise, cell of its tests)]"""
    table = re.search(r"(?:^\|.*\n)+", PAGE.read_text(), re.MULTILINE)
    first = table.string[:table.start()].count("\n") + 1
    rows = [re.split(r"(?<!\\)\|", line) for line in table[0].splitlines()]
    return [(first + i, row[1].strip(), row[3]) for i, row in enumerate(rows) if i > 1]


def pattern(suite, separator, test):
    """Of the names that ctest knows; a class of the window's tests is one for it."""
    if separator == "::":
        return "^gui_" + suite.removesuffix("Test").lower() + "$"
    return rf"^([^/]*/)?{suite}\.{'[^/]*' if test == '*' else test}(/.*)?$"


def results(build, patterns):
    """{name: passed} of the tests that ctest has run."""
    ctest = ["ctest", "--test-dir", build]
    listed = subprocess.run([*ctest, "--show-only=json-v1"], stdout=subprocess.PIPE, check=True)
    numbers = [str(number) for number, test in enumerate(json.loads(listed.stdout)["tests"], 1)
               if any(re.match(each, test["name"]) for each in patterns)]
    with tempfile.TemporaryDirectory(prefix="hitos-") as folder:
        report = pathlib.Path(folder, "report.xml")
        subprocess.run([*ctest, "-I", "0,0,0," + ",".join(numbers), "--output-junit", report],
                       stdout=subprocess.DEVNULL, check=False)
        cases = xml.etree.ElementTree.parse(report).iter("testcase")
        return {case.get("name"): case.get("status") == "run" for case in cases
                if case.get("status") in ("run", "fail")}


def print_table(build):
    known = tests_of_sources()
    rows = [(promise, tests_named(cell, known)) for _, promise, cell in promises()]
    ran = results(build, {pattern(*test) for _, tests in rows for test in tests
                          if known.get(test[0])})
    print("| promise | tests | passed | failed | not run |\n|---|---|---:|---:|---:|")
    whole = True
    for promise, tests in rows:
        outcomes = [[passed for name, passed in ran.items() if re.match(pattern(*test), name)]
                    for test in tests if known.get(test[0])]
        passed, failed = (sum(each.count(value) for each in outcomes) for value in (True, False))
        missing = outcomes.count([])
        whole = whole and passed > 0 and failed + missing == 0
        names = ", ".join("".join(test) for test in tests)
        print(f"| {promise} | {names} | {passed} | {failed} | {missing} |")
    return whole


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(0 if print_table(os.path.abspath(sys.argv[1])) else 1)
