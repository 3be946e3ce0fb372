"""Threads, the interpreter's lock, memory, failures half way, and where the library is found.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import gc
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import common
import graze
from graze import _library, _parallel

FINDS = "import graze; print(graze.version().split()[1])"


def cloud(count, box, seed):
    """Random points of a box, as rows of floats."""
    rng = random.Random(seed)
    low, high = ([float(end) for end in corner] for corner in box)
    return [[rng.uniform(a, b) for a, b in zip(low, high)] for _ in range(count)]


def bracket(**options):
    return graze.Scene(*common.case("bracket")[:2], **options)


class Threads(unittest.TestCase):
    def test_jobs(self):
        """The answers do not depend on the number of threads, nor on the way pieces are cut."""
        scene = bracket()
        points = cloud(6 * _parallel.PIECE + 7, scene.box(), common.SEED)
        want = common.tuples(scene.classify(points))
        self.assertGreater(len(set(want)), 4)
        for jobs in (2, 5, None):
            self.assertEqual(common.tuples(scene.classify(points, jobs=jobs)), want, jobs)
        self.assertEqual(len(scene.rows(points, jobs=4)), len(points))
        for jobs in (0, -1):
            with self.assertRaises(graze.UseError):
                scene.classify(points, jobs=jobs)

    def test_a_scene_shared_by_threads(self):
        scene = bracket()
        points = cloud(200, scene.box(), common.SEED)
        want = [(scene.trace(p), scene.explain(p)) for p in points[:20]]
        verdicts = common.tuples(scene.classify(points))

        def ask(_):
            return ([(scene.trace(p), scene.explain(p)) for p in points[:20]],
                    common.tuples(scene.classify(points)))

        with ThreadPoolExecutor(6) as pool:
            for got in pool.map(ask, range(24)):
                self.assertEqual(got, (want, verdicts))

    def test_other_threads_run_meanwhile(self):
        """One call into the library, during which another thread counts its turns. Were the lock
        held, it could not count to more than one or two."""
        scene = bracket(use_filter=False)
        points = cloud(4000 * common.SCALE, scene.box(), common.SEED)
        turns, done, piece = [0], threading.Event(), _parallel.PIECE
        inside = []

        def count():
            while not done.wait(0.001):
                turns[0] += 1

        def call(*arguments):
            before = turns[0]
            begun = time.monotonic()
            status = classify(*arguments)
            inside.append((turns[0] - before, time.monotonic() - begun))
            return status

        library = _library.library()
        classify = library.graze_classify_doubles
        counter = threading.Thread(target=count)
        counter.start()
        try:
            _parallel.PIECE, library.graze_classify_doubles = len(points), call
            scene.classify(points)
        finally:
            _parallel.PIECE, library.graze_classify_doubles = piece, classify
            done.set()
            counter.join()
        (turned, seconds), = inside
        self.assertGreater(seconds, 0.05, "the call is long enough to tell")
        self.assertGreater(turned, 10, f"turns in {seconds} s")

    def test_failure_half_way(self):
        """A number too long for the limit among the points: the error, and verdicts before it: in one thread all of
        them, in several those that were given when the failure ended the other calls."""
        scene = common.root_scene(limits={"digits": 20})
        points = [(1, 2)] * (3 * _parallel.PIECE) + [(10 ** 30, 1)]
        for jobs in (1, 3):
            with self.assertRaises(graze.LimitError) as raised:
                scene.classify(points, jobs=jobs)
            partial = common.tuples(raised.exception.partial)
            self.assertEqual((len(partial), partial[-1][0]), (len(points), 0))
            given = [verdict for verdict in partial if verdict[0]]
            self.assertEqual(set(given) - {(3, 5, 9, 1, 0, 0)}, set())
            if jobs == 1:
                self.assertEqual(len(given), 3 * _parallel.PIECE)
            self.assertIn(f"from point {3 * _parallel.PIECE}: ", str(raised.exception))
            with self.assertRaises(graze.LimitError) as raised:
                scene.rows([(1, 2)] * 3 + points, jobs=jobs)
            self.assertIn(f"point {3 * _parallel.PIECE + 3}: ", str(raised.exception))
        self.assertEqual(common.tuples(scene.classify([(1, 2)])), [(3, 5, 9, 1, 0, 0)])

    def test_failure_ends_a_call_that_runs(self):
        """A piece whose call is held until the failure of another ends it has no verdicts."""
        scene = common.root_scene(limits={"digits": 20})
        points = [(1, 2)] * (3 * _parallel.PIECE) + [(10 ** 30, 1)]
        library, calls = _library.library(), []
        classify = library.graze_classify

        def call(*arguments):
            calls.append(arguments)
            late = time.monotonic() + 30
            while arguments is calls[0] and not scene._contexts.mine()._countdown._stopped and time.monotonic() < late:
                time.sleep(0.001)
            return classify(*arguments)

        library.graze_classify = call
        try:
            with self.assertRaises(graze.LimitError) as raised:
                scene.classify(points, jobs=2)
        finally:
            library.graze_classify = classify
        self.assertIn(f"from point {3 * _parallel.PIECE}: ", str(raised.exception))
        self.assertEqual(sum(verdict[0] != 0 for verdict in common.tuples(raised.exception.partial)), 2 * _parallel.PIECE)
    @unittest.skipIf(threading.current_thread() is not threading.main_thread(), "not the main thread")
    def test_interrupt(self):
        """Ctrl-C ends a long call after the piece at hand, and the scene is as before."""
        scene = bracket()
        points = cloud(60 * _parallel.PIECE, scene.box(), common.SEED)
        library, calls = _library.library(), []
        classify = library.graze_classify_doubles

        def call(*arguments):
            calls.append(arguments)
            if len(calls) == 5:
                os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.02)
            return classify(*arguments)

        library.graze_classify_doubles = call
        try:
            for jobs in (1, 2):
                calls.clear()
                before = threading.active_count()
                with self.assertRaises(KeyboardInterrupt):
                    scene.classify(points, jobs=jobs)
                self.assertLess(len(calls), 30, "of 60 pieces")
                self.assertEqual(threading.active_count(), before)
        finally:
            library.graze_classify_doubles = classify
        self.assertEqual(len(scene.classify(points[:10])), 10)

    @unittest.skipIf(threading.current_thread() is not threading.main_thread(), "not the main thread")
    def test_interrupt_within_a_call(self):
        """Ctrl-C ends a call that runs, whatever it does, and the next one goes on."""
        library = _library.library()
        square = ((0, 0), (1, 0), (1, 1), (0, 1)), ((0, 1, 2, 3),)
        # Two roots 10^-1530 apart: seconds of exact arithmetic for one point.
        close = {"dimension": 2, "pieces": [{"t": ["0", "1"], "transform": {
            "translate": ["t^100-2*(10^30*t-1)^2", "0"]}}]}
        scene = graze.Scene(square, close)

        def wait_for_writer():
            with tempfile.TemporaryDirectory() as folder:
                pipe = os.path.join(folder, "solid.off")
                os.mkfifo(pipe)
                graze.Solid(pipe)

        def interrupt_process():
            os.kill(os.getpid(), signal.SIGINT)

        def interrupt_unseen():
            """The handler is then due in the main thread, whose wait goes on."""
            signal.pthread_kill(threading.get_ident(), signal.SIGINT)

        for name, act in (("graze_trace_create", lambda: scene.trace((0, 0))),
                          ("graze_report_points", lambda: scene.rows([(0, 0)], jobs=1)),
                          ("graze_classify", lambda: scene.classify([(0, 0)] * 1024, jobs=2)),
                          ("graze_solid_read", wait_for_writer)):
            for interrupt in (interrupt_process, interrupt_unseen):
                with self.subTest(name, interrupt=interrupt.__name__):
                    self.interrupted(library, name, act, interrupt)
        self.assertEqual(scene.trace((0, 5)).word, "O")

    def interrupted(self, library, name, act, interrupt):
        function, statuses = getattr(library, name), []
        once = iter([threading.Timer(0.2, interrupt)])

        # The first call may be a brief one of the main thread, which ends by itself.
        def call(*arguments):
            main = threading.current_thread() is threading.main_thread()
            timer = None if main else next(once, None)
            if timer:
                timer.start()
            statuses.append(function(*arguments))
            return statuses[-1]

        setattr(library, name, call)
        try:
            with self.assertRaises(KeyboardInterrupt):
                act()
        finally:
            setattr(library, name, function)
        self.assertEqual(set(statuses), {6})  # GRAZE_ECANCELED


class Memory(unittest.TestCase):
    def test_every_handle_is_destroyed_once(self):
        library = _library.library()
        kinds = ["context", "solid", "motion", "scene", "trace", "generator"]
        functions = {}
        ended = dict.fromkeys(kinds, 0)

        def counting(kind, function):
            def end(pointer):
                ended[kind] += 1
                function(pointer)
            return end

        gc.collect()
        for kind in kinds:
            name = f"graze_{kind}_destroy"
            functions[name] = getattr(library, name)
            setattr(library, name, counting(kind, functions[name]))
        try:
            for _ in range(3):
                scene = common.cube_scene()
                scene.trace((5, 1, 2))
                scene.explain((5, 1, 1))
                self.assertEqual(len(list(scene.generate(2))), 2)
                ring = [scene]
                ring.append(ring)
                del scene, ring
            with self.assertRaises(graze.IllegalError):
                graze.Scene(common.CUBE, common.moved("t", "0"))
            gc.collect()
        finally:
            for name, function in functions.items():
                setattr(library, name, function)
        # Each turn: contexts of solid, motion, scene and generator; the failed scene made three more.
        self.assertEqual(ended, {"context": 3 * 4 + 3, "solid": 4, "motion": 4, "scene": 3, "trace": 6,
                                 "generator": 3})

    @unittest.skipUnless(os.path.exists("/proc/self/statm"), "no /proc")
    @unittest.skipIf("libtsan" in os.environ.get("LD_PRELOAD", ""), "the thread sanitizer keeps memory for each thread that was")
    def test_memory_does_not_grow(self):
        """Scenes, traces and threads, many times: after a start no more than 4 MB are added. What the
        arithmetic keeps for a thread is 0.2 MB with such points; there are 200 threads and more."""
        def resident():
            with open("/proc/self/statm", encoding="ascii") as file:
                return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")

        shared = bracket(use_filter=False)
        points = [(f"{k}/{3 ** 60 + k}", 1, "2/7") for k in range(40)]

        def turn():
            scene = common.root_scene()
            scene.trace((3, "1/2"))
            scene.classify([(1, 2)] * (2 * _parallel.PIECE), jobs=2)
            thread = threading.Thread(target=shared.classify, args=(points,))
            thread.start()
            thread.join()

        for _ in range(30):
            turn()
        gc.collect()
        before = resident()
        for _ in range(200 * common.SCALE):
            turn()
        gc.collect()
        self.assertLess(resident() - before, 4 << 20)


class Finding(unittest.TestCase):
    def find(self, folder, variables, path):
        environment = {key: value for key, value in os.environ.items()
                       if key not in ("GRAZE_LIBRARY", "LD_LIBRARY_PATH")}
        environment.update(variables, PYTHONPATH=path, PYTHONDONTWRITEBYTECODE="1")
        return subprocess.run([sys.executable, "-c", FINDS], cwd=folder, env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)

    def test_places(self):
        """The variable alone if it is set; else beside the package, a checkout's build, the linker."""
        library = os.path.join(os.path.dirname(os.path.abspath(common.GRAZE)), "libgraze.so")
        package = os.path.dirname(graze.__file__)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "src", "python")
            shutil.copytree(package, os.path.join(path, "graze"), ignore=shutil.ignore_patterns("__pycache__"))
            places = [({}, os.path.join(path, "graze", "libgraze.so.0")),
                      ({}, os.path.join(folder, "libgraze.so.0")),
                      ({}, os.path.join(folder, "build", "libgraze.so")),
                      ({"LD_LIBRARY_PATH": folder}, os.path.join(folder, "libgraze.so.0")),
                      ({"GRAZE_LIBRARY": os.path.join(folder, "any.so")}, os.path.join(folder, "any.so"))]
            os.makedirs(os.path.join(folder, "build"))
            os.makedirs(os.path.join(folder, "include"))
            for variables, place in places:
                if os.path.basename(os.path.dirname(place)) == "build":
                    shutil.copy(os.path.join(common.ROOT, "include", "graze.h"),
                                os.path.join(folder, "include"))
                os.symlink(library, place)
                done = self.find(folder, variables, path)
                self.assertEqual(done.stdout.decode().strip(), graze.__version__, done.stderr.decode())
                os.unlink(place)
            os.symlink(library, os.path.join(path, "graze", "libgraze.so.0"))
            done = self.find(folder, {"GRAZE_LIBRARY": "/nowhere.so"}, path)
            self.assertIn("LibraryError: libgraze cannot be loaded", done.stderr.decode())

    def test_another_library(self):
        """A library that is not libgraze is refused by name."""
        done = self.find(".", {"GRAZE_LIBRARY": "libc.so.6"}, os.path.dirname(os.path.dirname(graze.__file__)))
        self.assertIn("lacks graze_version", done.stderr.decode())
