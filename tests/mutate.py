#!/usr/bin/env python3
"""Mutation test of the rooms of src: mutation/rooms.py names them, and who is asked about each.

A mutant has one comparison, connective, sign or call changed. Of each room some are drawn, anew with each seed, and put to
the room's suites until one is red; last to some of them under AddressSanitizer. A mutant that none notices is printed. One that
tests/mutants.txt explains is not drawn, one that gives the same code not counted. Fewer than --wanted of 100 noticed is a failure.
With --changed --each are drawn of each file that has changed since the commit of tests/base.txt; none is asked where no file has.
Wants a finished `make test`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import collections
import concurrent.futures
import glob
import itertools
import os
import queue
import random
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.path[:0] = [os.path.join(os.path.dirname(os.path.abspath(__file__)), folder) for folder in ("mutation", "lib")]

import changed  # noqa: E402
import changes  # noqa: E402
import suitetimes  # noqa: E402
from harness import MEMORY, bounded  # noqa: E402
from rooms import BOUNDARIES, OTHERS, ROOMS, files  # noqa: E402
from run import interpreter  # noqa: E402

RUN_SECONDS = 10    # of processor time, for one run of the program under a suite
UNIT_SECONDS = 60   # for a test in C
COMMON = ["-w", "-pthread", "-Iinclude", "-Isrc"]
COMPILERS = {".c": ["gcc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O1"], ".cpp": ["g++", "-std=c++17", "-frounding-math", "-O0"]}
LIBS = ["-lcmocka", "-lyajl", "-lmd", "-lflint", "-lmpfr", "-lgmp", "-lm", "-lstdc++", "-pthread"]
SANITIZE = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
WRAPPER = """#!/bin/sh
ulimit -t {seconds}
{memory}
case $1 in
classify|explain) command=$1; shift; exec "{program}" "$command" {flag} "$@";;
esac
exec "{program}" "$@"
"""


def is_red(command, seconds):
    """Whether a program fails, says FAIL or does not end in time. What it started ends with it."""
    started = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL,
                               start_new_session=True, env={**os.environ, "PYTHONUNBUFFERED": "1"})

    def end():
        try:
            os.killpg(started.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass

    timer = threading.Timer(seconds, end)
    timer.start()
    with started.stdout as lines:
        failed = any(line.startswith(b"FAIL") for line in lines)
    if failed:
        end()
    status = started.wait()
    timer.cancel()
    return failed or status != 0


class Parts:
    """Shared by all mutants: the objects of the program without debugging data, and what is known of the suites."""

    def __init__(self, build, folder):
        self.build, self.folder = os.path.abspath(build), folder
        self.archive = os.path.join(folder, "libgraze.a")
        subprocess.run(["strip", "-g", "-o", self.archive, f"{build}/libgraze.a"], check=True)
        self.commands = [path for path in glob.glob("src/program/*/*.c") if "/mpi/" not in path]
        self.program = self.joined("program.o", self.commands)
        self.sound = set()  # those asked that are green without any mutant
        self.known = changes.record()
        self.python = interpreter()[0]
        self.seconds = {path.rsplit(".", 1)[0]: 30 + 10 * wall for path, (wall, _) in suitetimes.read().items()}

    def joined(self, name, sources):
        """One object of those of the commands' sources."""
        out = os.path.join(self.folder, name)
        subprocess.run(["ld", "-r", "-S", "-o", out, *(f"{self.build}/{path[:-2]}.o" for path in sources)], check=True)
        return out


class Worker:
    """One mutant at a time, in a folder that stands in for the build folder."""

    def __init__(self, parts, name, end):
        self.parts, self.end, self.plain = parts, end, {}
        self.folder = os.path.join(parts.folder, name)
        os.makedirs(self.folder)
        for other in ["tests", "graze-check", "graze-mpi", *map(os.path.basename, glob.glob(f"{parts.build}/*.so*"))]:
            os.symlink(os.path.join(parts.build, other), os.path.join(self.folder, other))
        self.graze, self.object = self.place("mutant"), self.place("mutant.o")
        self.wrappers = {(flag, safe): self.wrapper(flag, safe) for flag in ("", "--no-filter") for safe in (False, True)}

    def place(self, name):
        return os.path.join(self.folder, name)

    def wrapper(self, flag, safe):
        path = self.place(f"graze{flag}{'-safe' if safe else ''}")
        with open(path, "w", encoding="utf-8") as file:
            file.write(WRAPPER.format(program=self.graze, flag=flag, seconds=RUN_SECONDS * (4 if safe else 1),
                                      memory="" if safe else f"ulimit -v {MEMORY >> 10}"))
        os.chmod(path, 0o755)
        return path

    def compiled(self, path, text, *more):
        """The object code of a source, which stays as self.object; None if it does not compile."""
        kind = os.path.splitext(path)[1]
        with open(self.place("mutant" + kind), "w", encoding="utf-8") as file:
            file.write(text)
        if subprocess.run([*COMPILERS[kind], *COMMON, *more, "-c", "-o", self.object, file.name],
                          stderr=subprocess.DEVNULL).returncode:
            return None
        with open(self.object, "rb") as file:
            return file.read()

    def link(self, out, objects, *more):
        subprocess.run(["g++", "-fuse-ld=gold", "-Wl,-rpath,$ORIGIN", "-o", out, *objects, self.object, self.parts.archive,
                        *more, *LIBS], check=True)

    def is_noticed_by(self, asker, safe=False):
        """Whether the suite is red. With `safe` the program and the tests are linked with AddressSanitizer."""
        words = asker.split()
        flag = "--no-filter" if words[0] == "exact" else ""
        name, *words = words[1:] if flag else words
        more = SANITIZE[:1] if safe else []
        if "/test_" in name:
            program = self.place("unit")
            self.link(program, [f"{self.parts.build}/tests/{name}.o"], *more)
            return is_red([program] if safe else bounded([program], MEMORY, cpu=UNIT_SECONDS), 10 * UNIT_SECONDS)
        return is_red([self.parts.python, f"tests/{name}.py", "--graze", self.wrappers[flag, safe], *words,
                       *(["--sanitizers"] if safe else [])], self.parts.seconds[name])

    def link_program(self, path, *more):
        """The program with the object of a source for its own; of a command's source the others are joined without it."""
        program = self.parts.program
        if path in self.parts.commands:
            program = self.parts.joined(f"{os.path.basename(self.folder)}.o", [other for other in self.parts.commands if other != path])
        self.link(self.graze, [program], *more)

    def check_sound(self, asker, path):
        """A suite that is red without any mutant, too, ends the run."""
        if asker not in self.parts.sound:
            with open(path, encoding="utf-8") as file:
                self.compiled(path, file.read())
            self.link_program(path)
            if self.is_noticed_by(asker):
                raise SystemExit(f"{asker} is red without any mutant")
            self.parts.sound.add(asker)

    def judge(self, room, mutant):
        """Fate of a mutant: `void`, `same code`, `late`, who notices it, or None."""
        path = mutant.path
        if path not in self.plain:
            with open(path, encoding="utf-8") as file:
                self.plain[path] = self.compiled(path, file.read())
            if self.plain[path] is None:
                raise SystemExit(f"{path} does not compile without any mutant")
        code = self.compiled(path, mutant.source())
        if code in (None, self.plain[path]):
            return "same code" if code else "void"
        self.link_program(path)
        for asker in ROOMS[room]:
            if time.time() > self.end:
                return "late"
            if self.is_noticed_by(asker):
                self.check_sound(asker, path)
                return asker
        if time.time() > self.end:
            return "late"
        self.compiled(path, mutant.source(), *SANITIZE)
        self.link_program(path, SANITIZE[0])
        return next((f"{asker} under AddressSanitizer" for asker in ROOMS[room][:3] if self.is_noticed_by(asker, True)), None)


def drawn(options, known):
    """(room, mutant) by turns of the rooms, or of the files that have changed, each drawn with the seed, without those that the record
    explains."""
    decks = []
    those = [(room, path) for room in ROOMS if room not in OTHERS and re.search(options.only, room) for path in files(room)
             if re.search(options.file, path) and (options.among is None or path in options.among)]
    for _, group in itertools.groupby(those, lambda pair: pair[0] if options.among is None else pair):
        group = list(group)
        room = group[0][0]
        moved = options.boundaries or room in BOUNDARIES
        deck = [m for _, path in group for m in changes.mutants(path) if (moved or not m.is_moved) and not m.is_in(known)]
        random.Random(f"{options.seed} {room}").shuffle(deck)
        decks.append([(room, m) for m in deck])
    return [pair for turn in itertools.zip_longest(*decks) for pair in turn if pair]


def judged(options, parts):
    """(room, mutant, fate, seconds) of --each mutants of each room or changed file, in the order of their ends."""
    idle, left, lock = queue.Queue(), collections.defaultdict(lambda: options.each), threading.Lock()
    end = time.time() + 60 * options.minutes
    for k in range(options.jobs):
        idle.put(Worker(parts, f"worker-{k}", end))

    def one(room, mutant):
        pile = room if options.among is None else mutant.path
        with lock:
            if left[pile] == 0 or time.time() > end:
                return room, mutant, "not asked", 0
            left[pile] -= 1
        worker, start = idle.get(), time.time()
        try:
            fate = worker.judge(room, mutant)
        finally:
            idle.put(worker)
        with lock:
            left[pile] += fate in ("void", "same code")
        return room, mutant, fate, time.time() - start

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for done in concurrent.futures.as_completed([pool.submit(one, *pair) for pair in drawn(options, parts.known)]):
            yield done.result()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build")
    parser.add_argument("--seed", default=time.strftime("%Y-%m-%d"), help="of the draw; the day if none is given")
    parser.add_argument("--each", type=int, default=8, help="mutants of each room, with --changed of each file")
    parser.add_argument("--minutes", type=float, default=600, help="after which none is asked any more")
    parser.add_argument("--wanted", type=int, default=95, help="of 100 mutants that must be noticed")
    parser.add_argument("--only", default="", help="rooms that meet this pattern")
    parser.add_argument("--file", default="", help="files that meet this pattern")
    parser.add_argument("--changed", action="store_true", help="of files that have changed since the commit of tests/base.txt, or of all "
                        "where git does not know it")
    parser.add_argument("--boundaries", action="store_true", help="move the boundaries of orders in every room")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="mutants at a time")
    parser.add_argument("--verbose", action="store_true", help="print the fate of each mutant")
    options = parser.parse_args()
    since = changed.recorded() if options.changed else None
    options.among = None if since is None else set(changed.files(since))
    print(f"seed {options.seed}", flush=True)
    if options.among is not None and not drawn(options, changes.record()):
        print("no file of these rooms has changed\n1 passed, 0 failed")
        return
    counts, noticed, asked, end = collections.defaultdict(collections.Counter), 0, 0, time.time() + 60 * options.minutes
    with tempfile.TemporaryDirectory() as folder:
        for room, mutant, fate, seconds in judged(options, Parts(options.build, folder)):
            kind = {None: "unnoticed", "void": "", "same code": "", "late": "", "not asked": ""}.get(fate, "noticed")
            counts[room][kind] += 1
            if fate is None or (options.verbose and fate != "not asked"):
                print(f"{fate or 'UNNOTICED'} ({seconds:.0f} s)\n{mutant.path} {mutant.function}\n| {mutant.changed}\n", flush=True)
    for room, count in counts.items():
        print(f"{room}: {count['noticed']} noticed, {count['unnoticed']} not")
        noticed, asked = noticed + count["noticed"], asked + count["noticed"] + count["unnoticed"]
    # A changed file may have no mutant but such as give the same code; one that was not reached in time is another thing.
    nothing = options.among is not None and asked == 0 and time.time() < end
    enough = nothing or 100 * noticed >= options.wanted * asked > 0
    print(f"{noticed} of {asked} mutants noticed\n{noticed + nothing} passed, {0 if enough else max(1, asked - noticed)} failed")
    sys.exit(0 if enough else 1)


if __name__ == "__main__":
    main()
