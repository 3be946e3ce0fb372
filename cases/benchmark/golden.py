#!/usr/bin/env python3
"""Golden rows of the benchmark: points of each scene, exact answers, certificates that are checked, and hashes.

    python3 cases/benchmark/golden.py --graze build/graze OUT [NAME...]

Makes OUT/NAME for each scene (scenes.py), or for those that are named: points.csv, golden.csv, certificate.txt, which
graze-check must accept. What is done is not done again, so that a run that was ended is continued. The hash of the
answers is compared with hashes.txt; --record writes it there instead. Exit status 1: a hash differs, or a scene failed.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import concurrent.futures
import functools
import hashlib
import os
import signal
import subprocess
import sys
import threading
import time

from scenes import SCENES
from tables import STATUS_BAD_INPUT, BadInput, read_scene, read_table, read_text

HERE = os.path.dirname(os.path.abspath(__file__))
HASHES = os.path.join(HERE, "hashes.txt")
MAKERS = [os.path.join(HERE, name) for name in ("scenes.py", "solids.py", "motions.py", "poses.py")]
# Columns that are the same on every machine: points, and answers of exact decisions. Enclosures of distances are outputs
# of floating-point code, proved wherever it runs, but not promised to be the same bytes.
HASHED = ("x", "y", "z", "id", "stratum", "order", "cell", "time", "k", "side",
          "pmc", "class", "definition", "case", "i", "t", "word", "topo")
SDF = "1e-6r"


def answers_hash(path):
    """SHA-256 of the columns HASHED of a table, a line a row, the names first; and the number of rows."""
    names, rows = read_table(path)
    lacking = [name for name in HASHED if name not in names]
    if lacking:
        raise BadInput(f"{path}: no column {lacking[0]}; expected a table of golden.py")
    lines = [",".join(HASHED), *(",".join(row[name] or "" for name in HASHED) for row in rows)]
    return hashlib.sha256(("\n".join(lines) + "\n").encode()).hexdigest(), len(rows)


def read_hashes(path):
    """name: (hash, rows) of a file of lines `HASH ROWS NAME`."""
    lines = [line.split() for line in read_text(path).splitlines() if line and not line.startswith("#")]
    wrong = [line for line in lines if len(line) != 3 or len(line[0]) != 64]
    if wrong:
        raise BadInput(f"{path}: {' '.join(wrong[0])}; expected lines of hash, rows and name")
    return {name: (digest, int(rows)) for digest, rows, name in lines}


def write_hashes(path, known):
    with open(path, "w", encoding="ascii") as file:
        file.write("# SHA-256 of the answers of each scene, its rows, its name (golden.py --record)\n")
        file.writelines(f"{digest} {rows} {name}\n" for name, (digest, rows) in sorted(known.items()))


def digest_of(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


@functools.lru_cache
def program_digest(path):
    return digest_of(path)


class Failure(Exception):
    """A program ended with another status than 0; the message has its own words."""


RUNNING = set()  # programs that threads wait for; they end with this one, whose signal they need not get
ENDED = threading.Event()


def run(*command):
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as started:
        RUNNING.add(started)
        if ENDED.is_set():
            started.terminate()
        try:
            said = started.communicate()[0].strip().splitlines() or [""]
        finally:
            RUNNING.discard(started)
    if started.returncode:
        raise Failure(f"{os.path.basename(command[0])} {os.path.basename(command[1])}, status {started.returncode}: {said[-1]}")


class Progress:
    """One line on a terminal: how many scenes are done, and the steps under way."""

    def __init__(self, count):
        self.count, self.done, self.steps, self.lock = count, 0, {}, threading.Lock()
        self.shown = sys.stderr.isatty()

    def at(self, name, step):
        with self.lock:
            self.steps[name] = step
            if self.shown:
                under_way = ", ".join(f"{one}: {what}" for one, what in self.steps.items())
                print(f"\r\033[K{self.done} of {self.count} scenes; {under_way}"[:120], end="", file=sys.stderr, flush=True)

    def finish(self, name, line):
        with self.lock:
            self.steps.pop(name, None)
            self.done += 1
            if self.shown:
                print("\r\033[K", end="", file=sys.stderr, flush=True)
            print(line, flush=True)


class Maker:
    """Makes the files of one scene after another."""

    def __init__(self, options, progress):
        self.graze, self.checker, self.out, self.progress = options.graze, options.check, options.out, progress

    def make_scene(self, name, listed):
        """The folder by scenes.py, unless it is newer than what makes it, or a scene of the user's own."""
        scene = os.path.join(self.out, name, "scene.json")
        old = os.path.exists(scene) and os.path.getmtime(scene)
        if name in listed and (not old or any(os.path.getmtime(source) > old for source in MAKERS)):
            self.progress.at(name, "scene")
            run(sys.executable, MAKERS[0], "--graze", self.graze, self.out, name)

    def inputs(self, folder, scene):
        """What the files hang on: solid, motion, points and programs."""
        parts = [digest_of(os.path.join(folder, name)) for name in ("solid.off", "motion.json")]
        return " ".join([*parts, str(scene["count"]), str(scene["seed"]), program_digest(self.graze), program_digest(self.checker)])

    def make_rows(self, name, folder, scene):
        """Points, table, certificate, each by its last name only when it is whole."""
        solid, motion, points, golden, certificate = (os.path.join(folder, file) for file in
                                                      ("solid.off", "motion.json", "points.csv", "golden.csv", "certificate.txt"))
        steps = [("points", points, ["generate", solid, motion, "-n", str(scene["count"]), "--seed", str(scene["seed"]), "--plain",
                                     "--representable", "binary64", "--coordinates", "decimal"]),
                 ("rows", golden, ["classify", solid, motion, points, "--topo", "--sdf", SDF, "--boundary-distance"]),
                 ("certificate", certificate, ["certify", solid, motion, points])]
        for step, path, command in steps:
            self.progress.at(name, step)
            run(self.graze, *command, "--quiet", "--output", path + ".part")
            os.replace(path + ".part", path)
        self.progress.at(name, "check")
        run(self.checker, solid, motion, certificate, golden)

    def make(self, name, listed):
        """The hash and number of rows of the scene, made or found done, and the seconds that took."""
        start = time.monotonic()
        self.make_scene(name, listed)
        folder = os.path.join(self.out, name)
        scene, record = read_scene(folder), os.path.join(folder, "done.txt")
        inputs = self.inputs(folder, scene)
        if not os.path.exists(record) or read_text(record) != inputs:
            self.make_rows(name, folder, scene)
            with open(record, "w", encoding="ascii") as file:
                file.write(inputs)
        return *answers_hash(os.path.join(folder, "golden.csv")), time.monotonic() - start


def judge(name, found, known, record):
    """A word for the hash of a scene, and whether it is as it should be."""
    if record:
        return "recorded", True
    if name not in known:
        return "not in the list of hashes", False
    return ("agrees", True) if known[name] == found else (f"DIFFERS: {found[0]}, expected {known[name][0]}", False)


def make_all(options, names, listed):
    """Makes the scenes side by side; the hashes found, and how many scenes are not as they should be."""
    known, found, wrong = read_hashes(options.hashes) if os.path.exists(options.hashes) else {}, {}, 0
    progress = Progress(len(names))
    maker = Maker(options, progress)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        tasks = {pool.submit(maker.make, name, listed): name for name in names}
        try:
            for task in concurrent.futures.as_completed(tasks):
                name = tasks[task]
                try:
                    digest, rows, seconds = task.result()
                    said, good = judge(name, (digest, rows), known, options.record)
                    found[name] = digest, rows
                    said = f"{rows} rows, {seconds:.1f} s, hash {said}"
                except (BadInput, Failure, OSError) as error:
                    said, good = f"FAILED: {error}", False
                wrong += not good
                progress.finish(name, f"{name}: {said}")
        except KeyboardInterrupt:
            signal.signal(signal.SIGTERM, signal.SIG_IGN)
            pool.shutdown(wait=False, cancel_futures=True)
            ENDED.set()
            for started in list(RUNNING):
                started.terminate()
            raise
    if options.record:
        write_hashes(options.hashes, {**known, **found})
    return found, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--check", help="graze-check; beside graze if not given")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="scenes at a time (cores)")
    parser.add_argument("--hashes", default=HASHES, help="compare with those of this file (hashes.txt)")
    parser.add_argument("--record", action="store_true", help="write the hashes of these scenes there")
    parser.add_argument("out", metavar="OUT")
    parser.add_argument("names", metavar="NAME", nargs="*")
    options = parser.parse_intermixed_args()
    options.graze = os.path.abspath(options.graze)
    options.check = os.path.abspath(options.check or os.path.join(os.path.dirname(options.graze), "graze-check"))
    if options.jobs < 1:
        parser.error("--jobs: expected a number from 1 up")
    listed = list(SCENES)
    unknown = [name for name in options.names if name not in listed and not os.path.isdir(os.path.join(options.out, name))]
    if unknown:
        raise BadInput(f"{unknown[0]}: no scene of scenes.py --list, and no folder of {options.out}")
    os.makedirs(options.out, exist_ok=True)
    start = time.monotonic()
    found, wrong = make_all(options, options.names or listed, set(listed))
    used = os.times()
    print(f"{len(found)} scenes, {sum(rows for _, rows in found.values())} rows, {wrong} not as they should be; "
          f"{time.monotonic() - start:.0f} s, {used.children_user + used.children_system:.0f} s of CPU")
    return 1 if wrong else 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        sys.exit(main())
    except (BadInput, OSError) as error:
        print(f"golden.py: {error}", file=sys.stderr)
        sys.exit(STATUS_BAD_INPUT)
    except KeyboardInterrupt:
        print("golden.py: ended; the next run continues", file=sys.stderr)
        sys.exit(130)
