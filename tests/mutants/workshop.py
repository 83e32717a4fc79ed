# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests/mutants/run and tests/mutants/machine have in common: a copy of the tree in which a
mutant is built and given to the tests of its layer."""

import contextlib
import os
import pathlib
import resource
import shutil
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

# layer: test program, and the tests that are tried before all of them
TESTS = {
    "base": ("test_base", None),
    "capture": ("test_capture", None),
    "features": ("test_features", None),
    "registration": ("test_registration", None),
    "slam": ("test_slam", None),
    "simulation": ("test_simulation", None),
    "evaluation": ("test_services", "MapError*:AlignedMapError*:TrajectoryError*:*Distance*:*Uncert*:"
                                    "Quality*:Suitability*"),
    "run": ("test_services", "ResultsTest*:Algoritmo*:RunWorker*"),
    "study": ("test_services", "Study*:SharedReadings*"),
}
# What is tried besides on mutants that those leave: it takes longer.
OTHERS = {"capture": ("test_integration", "TourExamination*:LaserDoubts*:RealClocks*:*OfClocks*:"
                                          "*OfTurns*:*EveryReader*:RosRecording*")}
LONGEST_SECONDS = 600
# What a mutant may take before it is stopped; no test takes a tenth of it.
MEMORY_BYTES = 8 << 30
FILE_BYTES = 1 << 28


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_BYTES, FILE_BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def copy_tree(folder):
    """Copies what git knows or would add; files that did not change keep their time."""
    names = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard", "-z"],
                           check=True, capture_output=True, text=True).stdout.split("\0")
    for name in filter(None, names):
        source, target = ROOT / name, folder / name
        if not source.is_file():
            target.unlink(missing_ok=True)
            continue
        if target.is_file() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, target)


class Workshop:
    def __init__(self, folder, jobs):
        self.folder, self.jobs = folder, jobs
        self.build = folder / "build/mutants"
        self.seconds = {}
        copy_tree(folder)
        shared = os.environ.get("HITOS_SHARED_DIR", ROOT / "../shared")
        # As in the preset dev, so that a mutant costs one source and one library.
        self.call(["cmake", "-S", folder, "-B", self.build, "-G", "Ninja", "--log-level=WARNING",
                   "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                   "-DBUILD_SHARED_LIBS=ON", "-DHITOS_DEV=ON", "-DHITOS_WINDOW=OFF",
                   "-DHITOS_PYTHON=OFF", f"-DHITOS_SHARED_DIR={shared}"]).check_returncode()

    @staticmethod
    def call(command, **more):
        return subprocess.run(list(map(str, command)), stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace", **more)

    def compiles(self, program):
        said = self.call(["cmake", "--build", self.build, "-j", self.jobs, "--target", program])
        return said.returncode == 0, said.stdout

    def failure(self, program, chosen, limit=None):
        """The first test that fails, or nothing."""
        command = [self.build / "tests" / program, "--gtest_brief=1", "--gtest_fail_fast"]
        if chosen:
            command.append(f"--gtest_filter={chosen}")
        try:
            said = self.call(command, timeout=limit, cwd=self.folder, preexec_fn=limited)
        except subprocess.TimeoutExpired:
            return "does not end"
        if said.returncode == 0:
            return None
        failed = [line for line in said.stdout.splitlines() if line.startswith("[  FAILED  ]")]
        return failed[0][13:].split(",")[0].split(" (")[0] if failed else "crash"

    def prepare(self, layer):
        program, _ = TESTS[layer]
        good, said = self.compiles(program)
        begin = time.monotonic()
        problem = "it does not build:\n" + said[-2000:] if not good else self.failure(program, None)
        if problem:
            raise SystemExit(f"{layer}: {program} fails without any mutant: {problem}")
        self.seconds[layer] = time.monotonic() - begin
        other = OTHERS.get(layer)
        if other and (not self.compiles(other[0])[0] or self.failure(*other, LONGEST_SECONDS)):
            raise SystemExit(f"{layer}: {other[0]} fails without any mutant")

    def other_failure(self, layer):
        program, chosen = OTHERS.get(layer, (None, None))
        if not program or not self.compiles(program)[0]:
            return None
        return self.failure(program, chosen, LONGEST_SECONDS)

    def verdict(self, layer, file, broken):
        """What becomes of the file broken that way: broken(text) gives its text."""
        if layer not in self.seconds:
            self.prepare(layer)
        program, first = TESTS[layer]
        path = self.folder / file
        text = path.read_text()
        path.write_text(broken(text))
        try:
            good, _ = self.compiles(program)
            if not good:
                return "does not compile"
            limit = 30 + 5 * self.seconds[layer]
            killer = (first and self.failure(program, first, limit)) or \
                self.failure(program, None, limit) or self.other_failure(layer)
            return f"killed by {killer}" if killer else "SURVIVED"
        finally:
            path.write_text(text)


@contextlib.contextmanager
def workshop(folder, jobs):
    """In that folder, to stay; where there is none, in one that goes away."""
    if folder:
        folder.mkdir(parents=True, exist_ok=True)
        yield Workshop(folder.resolve(), jobs)
        return
    with tempfile.TemporaryDirectory(prefix="hitos-mutants-") as passing:
        yield Workshop(pathlib.Path(passing), jobs)
