#!/usr/bin/env python3
"""A run by the fork server is one by exec: output, errors and status of graze, and of a program that shows how it was started, are
those of subprocess; nothing of one run is seen by the next; crashes, late runs, threads and an end of the server harm nobody.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import concurrent.futures
import os
import resource
import signal
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import forks  # noqa: E402
from harness import ROOT, TOO_LATE, Checks, bounded, options, run  # noqa: E402

COMMON = os.path.join(ROOT, "tests", "refuse", "common")
CUBE, MOVE, SQUARE, PLANE, POINTS = (os.path.join(COMMON, name) for name in ("cube.off", "move3.json", "square.wkt", "move2.json", "points.csv"))
WORDS = [["show"], ["show", "", "a b", "é\n", "\udcff"], ["exit", 0], ["exit", 7], ["exit", 255], ["abort"], ["late"], ["much", 40000],
         *(["raise", number] for number in (signal.SIGSEGV, signal.SIGKILL, signal.SIGTERM, signal.SIGPIPE, signal.SIGINT))]
GRAZE = [(["--version"], 0), ([], 2), (["check", CUBE, MOVE], 0), (["check", SQUARE, MOVE], 1), (["classify", CUBE], 2),
         (["classify", SQUARE, PLANE, POINTS], 0), (["classify", CUBE, MOVE, POINTS], 3), (["classify", CUBE, MOVE, "none.csv"], 5),
         (["explain", CUBE, MOVE, "1", "2", "3"], 0), (["check", CUBE, MOVE, "--limit", "work=1"], 6)]


def rewind(more):
    if "stdin" in more:
        more["stdin"].seek(0)


class Bench:
    def __init__(self, checks, folder, args):
        self.checks, self.folder, self.graze = checks, folder, args.graze
        self.probe = os.path.join(folder, "probe")
        subprocess.run(["cc", "-std=c11", "-o", self.probe, os.path.join(ROOT, "tests", "runner", "probe.c")], check=True)
        forks.programs[self.probe] = forks.programs[self.graze]

    def same(self, program, words, **more):
        """The run by the server; it must be equal to that by exec. Two of the one and two of the other: neither changes the next."""
        forked, library = [], forks.programs[program]
        for _ in range(2):
            rewind(more)
            forked.append(run([program, *words], **more))
            self.checks.holds(program in forks.programs, "the server has ended", program, words)
            forks.programs.pop(program, None)
            rewind(more)
            done = run([program, *words], **more)
            forks.programs[program] = library
            for got in forked:
                self.checks.holds((got.returncode, got.stdout, got.stderr) == (done.returncode, done.stdout, done.stderr),
                                  words, list(more), "forked", got, "by exec", done)
        return forked[0]


def check_starts(b):
    """Arguments, environment, folders, descriptors, limits, statuses, signals, output and input."""
    b.checks.equal(run([b.probe, "forked"]).stdout, "yes\n", "a run is forked")
    for words in WORDS:
        b.same(b.probe, words)
        b.same(b.probe, words, text=False)
    for words in (["show"], ["copy"]):
        b.same(b.probe, words, cwd="/usr", env={"A": "1", "B": "é", "ASAN_OPTIONS": "x=1"}, input="text\r\n")
        b.same(b.probe, words, env={"LD_PRELOAD": ""})
        b.same(b.probe, words, cwd=os.path.relpath(b.folder), env={}, text=False, input=b"\xff\x00" * 600000)
    b.same(b.probe, ["show", *(str(k) * 1000 for k in range(100))])
    b.same(b.probe, ["exit", 3], text=False, input=b"nobody reads it" * 100000)
    for k, (name, most) in enumerate((("AS", 1 << 31), ("FSIZE", 1 << 20), ("NOFILE", 100))):
        which = getattr(resource, "RLIMIT_" + name)
        before = resource.getrlimit(which)
        resource.setrlimit(which, (most, before[1]))
        b.same(b.probe, ["show", k])
        resource.setrlimit(which, before)
    here = os.getcwd()
    os.chdir(b.folder)
    b.same(b.probe, ["show"])
    os.chdir(here)


def check_files(b):
    """Files as standard input and output; a folder that is not there; a command that is too long."""
    path = os.path.join(b.folder, "file")
    for more in ({}, {"stderr": subprocess.DEVNULL}, {"stderr": subprocess.STDOUT}):
        with open(path, "w+b") as file, open(CUBE, "rb") as solid:
            b.same(b.probe, ["much", 5], stdout=file, **more)
            b.same(b.probe, ["copy"], stdin=solid, **more)
            b.checks.holds(file.tell() > 0 and solid.tell() > 0, "offsets are shared")
    for words, more, error in ((["show"], {"cwd": path}, NotADirectoryError), (["show"], {"cwd": path + "/none"}, OSError),
                               (["a\0b"], {}, ValueError), (["a" * (1 << 18)], {}, OSError)):
        library, raised = forks.programs[b.probe], []
        for _ in range(2):
            try:
                raised.append(run([b.probe, *words], **more))
            except (OSError, ValueError) as failure:
                raised.append(type(failure))
            forks.programs.pop(b.probe)
            forks.programs[b.probe] = library
        b.checks.holds(raised[0] == raised[1] and issubclass(raised[0], error), words, more, raised)


def check_late(b):
    """A late run gives what it wrote until then, and is gone; the server is not."""
    done = run([b.probe, "sleep", 60], 0.5)
    b.checks.equal((done.returncode, done.stderr), (TOO_LATE, "\nno end after 0.5 s\n"), "a late run")
    b.checks.holds(not os.path.exists(f"/proc/{int(done.stdout)}"), "a late run is gone", done.stdout)
    b.checks.equal(run([b.probe, "forked"]).stdout, "yes\n", "after a late run")


def check_threads(b):
    def one(k):
        done = run([b.probe, "copy"], input=f"{k}\n" * 1000, env={"K": str(k)})
        return done.returncode, done.stdout == f"{k}\n" * 1000, run([b.probe, "exit", k % 100]).returncode == k % 100

    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        for k, got in enumerate(pool.map(one, range(200))):
            b.checks.equal(got, (0, True, True), "threads", k)


def check_graze(b):
    for words, status in GRAZE:
        done = b.same(b.graze, words)
        b.checks.equal(done.returncode, status, words)
    for words in (["classify", SQUARE, PLANE, "-"], ["classify", SQUARE, PLANE, "/dev/stdin", "--format", "jsonl"]):
        b.checks.equal(b.same(b.graze, words, input="1,2\n1/2,1/3\n" * 500).returncode, 0, words)
        with open(POINTS, "rb") as file:
            b.checks.equal(b.same(b.graze, words, stdin=file).returncode, 0, words)
    with open("/dev/full", "wb") as full:
        b.checks.equal(b.same(b.graze, ["check", CUBE, MOVE], stdout=full).returncode, 5, "a full disk")


def check_exec(b):
    """Runs that are never forked, and those after the server's end."""
    script = os.path.join(b.folder, "script")
    with open(script, "w", encoding="utf-8") as file:
        file.write(f'#!/bin/sh\nexec {b.probe} "$@"\n')
    os.chmod(script, 0o755)
    forks.serve(script)
    b.checks.holds(script not in forks.programs, "a script")
    for words in ([script], bounded([b.probe], 1 << 30), ["env", b.probe]):
        b.checks.equal(run([*words, "forked"]).stdout, "no\n", words)
    b.checks.equal(run([b.probe, "forked"], start_new_session=True).stdout, "no\n", "a session of its own")
    b.checks.equal(run([b.probe, "forked"], env={"LD_PRELOAD": ""}).stdout, "no\n", "another library in front")
    for server in forks.servers.values():
        server.process.kill()
        server.process.wait()
    for want in ("no", "no"):
        b.checks.equal(run([b.probe, "forked"]).stdout, want + "\n", "after the end of the server")
    os.environ["GRAZE_EXEC"] = "1"
    forks.serve(b.probe)
    b.checks.holds(b.probe not in forks.programs, "GRAZE_EXEC")


def main():
    args = options(__doc__)
    checks = Checks()
    if args.graze not in forks.programs:
        checks.skip("forks", "runs are by exec here")
        checks.finish()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(checks, folder, args)
        for check in (check_starts, check_files, check_late, check_threads, check_graze, check_exec):
            check(bench)
    checks.finish()


if __name__ == "__main__":
    main()
