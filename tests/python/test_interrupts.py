# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl+C, and threads of Python beside what C++ computes."""
import pathlib
import signal
import sys
import tempfile
import threading
import unittest

import hitos
from support import LOG, start

# Works on what lasts for ever; says when it is under way, and what has come of it.
SCRIPT = """
import pathlib, sys, threading
import hitos

folder = pathlib.Path(sys.argv[1])
endless = hitos.open("bigloop", world_set={"tour.laps": 100})
said = False

def progress(now):
    global said
    if not said:
        said = True
        print("under way", flush=True)

try:
    if sys.argv[2] == "run":
        hitos.run(endless, progress=progress, out=folder / "out")
    elif sys.argv[2] == "steps":
        progress(None)
        for snapshot in hitos.Run(endless):
            pass
    elif sys.argv[2] == "study":
        hitos.study(endless, {"filter.particles": [500, 600]}, out=folder / "out", threads=2,
                    progress=progress)
    elif sys.argv[2] == "summary":
        progress(None)
        for _ in range(1000):
            endless.summary()
    elif sys.argv[2] == "grid":
        progress(None)
        for _ in range(1000):
            hitos.draw_grid(endless, endless.truth.trajectory, {"grid.resolution": 0.02})
except KeyboardInterrupt:
    print("interrupted", threading.active_count(), flush=True)
"""


# Ends while a daemon thread is at work on what lasts for ever.
DAEMON = """
import atexit, pathlib, sys, threading
import hitos

folder = pathlib.Path(sys.argv[1])
inside = threading.Event()

def own(scan):
    inside.set()
    return [(0, len(scan))] if len(scan) > 1 else []

hitos.add_line_method("own", own)
endless = hitos.open("bigloop", world_set={"tour.laps": 100})
short = hitos.run("corridor", {"filter.particles": 20})

def told(now):
    inside.set()

def work():
    what = sys.argv[2]
    if what == "run":
        hitos.run(endless, progress=told, out=folder / "out")
    elif what == "own":
        hitos.run(endless, {"features.method": "own"})
    elif what == "study":
        hitos.study(endless, {"filter.particles": [500, 600]}, out=folder / "out", threads=2,
                    progress=told)
    inside.set()
    while what == "steps":
        for snapshot in hitos.Run(endless, {"filter.particles": 5}):
            pass
    while what == "scans":
        for scan in endless:
            pass
    while what == "summary":
        endless.summary()
    while what == "write":
        short.write(folder / "written")

def late():
    # What the main thread does at its end goes on as ever.
    print(hitos.run("corridor", {"filter.particles": 2}).scans, flush=True)

threading.Thread(target=work, daemon=True).start()
inside.wait()
atexit.register(late)
"""


class Interrupts(unittest.TestCase):
    def interrupt(self, what, folder):
        process = start(SCRIPT, folder, what)
        self.assertEqual(process.stdout.readline(), "under way\n")
        process.send_signal(signal.SIGINT)
        said, complaints = process.communicate(timeout=120)
        self.assertEqual(complaints, "")
        self.assertEqual(said, "interrupted 1\n")
        self.assertEqual(process.returncode, 0)

    def test_runs_end_and_leave_nothing(self):
        for what in ("run", "steps", "summary", "grid"):
            with self.subTest(what), tempfile.TemporaryDirectory() as folder:
                self.interrupt(what, folder)
                self.assertEqual(list(pathlib.Path(folder).iterdir()), [])

    def test_studies_end_and_go_on_later(self):
        with tempfile.TemporaryDirectory() as folder:
            self.interrupt("study", folder)
            left = [path.name for path in pathlib.Path(folder).rglob("*") if path.is_file()]
            self.assertFalse([name for name in left if name == "summary.csv"])
            # Nobody holds the folder any more.
            study = hitos.study("corridor", {"filter.particles": [5]}, runs=1,
                                out=pathlib.Path(folder, "out"))
            self.assertEqual(study.computed, 1)

    def test_a_raised_signal_arrives_in_the_run(self):
        def progress(now):
            signal.raise_signal(signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt):
            hitos.run(LOG, progress=progress)

    def test_a_handler_of_ones_own_is_called(self):
        class Alarm(Exception):
            pass

        def handler(number, frame):
            raise Alarm
        before = signal.signal(signal.SIGALRM, handler)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.1)
            with self.assertRaises(Alarm):
                hitos.run(hitos.open("bigloop", world_set={"tour.laps": 100}))
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)

    def test_a_run_that_was_interrupted_goes_on(self):
        run = hitos.Run("corridor", {"filter.particles": 20})

        def progress(now):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            run.finish(progress=progress)
        result = run.finish()
        whole = hitos.run("corridor", {"filter.particles": 20})
        self.assertEqual(result.trajectory.tobytes(), whole.trajectory.tobytes())


class Threads(unittest.TestCase):
    def test_python_goes_on_while_a_run_computes(self):
        """The interpreter never takes the lock from a thread here: the run ends only if the other
        thread gets it while hitos.run() is inside C++."""
        stop = threading.Event()
        inside = threading.Event()
        endless = hitos.open("bigloop", world_set={"tour.laps": 100})

        def ends():
            inside.wait()
            stop.set()

        def progress(now):
            inside.set()
            return not stop.is_set()
        other = threading.Thread(target=ends)
        interval = sys.getswitchinterval()
        sys.setswitchinterval(1000)
        try:
            other.start()
            result = hitos.run(endless, {"filter.particles": 20}, progress=progress)
        finally:
            sys.setswitchinterval(interval)
        other.join()
        self.assertFalse(result.finished)

    def test_what_progress_ends_does_not_take_a_finished_runs_place(self):
        with tempfile.TemporaryDirectory() as name:
            out = pathlib.Path(name) / "out"
            hitos.run("corridor", {"filter.particles": 5}, out=out)
            summary = (out / "summary.json").read_bytes()
            with self.assertWarnsRegex(UserWarning, "keeps the results of a run to its tour's end"):
                result = hitos.run("corridor", {"filter.particles": 500}, out=out,
                                   progress=lambda now: False)
            self.assertFalse(result.finished)
            self.assertEqual((out / "summary.json").read_bytes(), summary)
            result.write(out)  # which is said of this very result
            self.assertNotEqual((out / "summary.json").read_bytes(), summary)

    def test_many_threads_read_and_run_at_once(self):
        results = {}

        def work(seed):
            tour = hitos.open("corridor", tour_seed=seed)
            scans = sum(1 for _ in tour)
            result = hitos.run(tour, {"filter.particles": 10, "run.seed": seed})
            results[seed] = (scans, result.scans, result.trajectory.tobytes())
        threads = [threading.Thread(target=work, args=(seed,)) for seed in range(1, 7)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for seed, (read, run, path) in results.items():
            self.assertEqual(read, run)
            alone = hitos.run(hitos.open("corridor", tour_seed=seed),
                              {"filter.particles": 10, "run.seed": seed})
            self.assertEqual(path, alone.trajectory.tobytes())
        self.assertEqual(len(results), 6)


class Daemons(unittest.TestCase):
    def test_the_interpreter_may_end_while_they_work(self):
        for what in ("run", "own", "study", "steps", "scans", "summary", "write"):
            for _ in range(2):
                with self.subTest(what), tempfile.TemporaryDirectory() as folder:
                    process = start(DAEMON, folder, what)
                    said, complaints = process.communicate(timeout=120)
                    self.assertEqual(complaints, "")
                    self.assertEqual(said, "160\n")
                    self.assertEqual(process.returncode, 0)
                    # Whole, or not there; what was being written is gone.
                    left = {path.name for path in pathlib.Path(folder).iterdir()}
                    self.assertLessEqual(left, {"written"} if what == "write" else {"out"}
                                         if what == "study" else set())


if __name__ == "__main__":
    unittest.main()
