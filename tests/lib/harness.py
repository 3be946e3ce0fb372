"""Shared by the suites in Python: counted checks, options, bounded runs of a program.

A suite ends with Checks.finish(): a summary line that tests/run.py reads, and status 1 if a check failed.
Failed checks are printed with their operands, the first 40 of them.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import math
import os
import random
import resource
import subprocess
import sys
from fractions import Fraction

import exact
import forks

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SHOWN = 40              # failed checks that are printed
SECONDS = 60            # of one run, thousands of times what most take
MEMORY = 4 << 30        # bytes of address space of a suite, and of each run
TOO_LATE = 124          # the exit status of a run that had to be ended, as `timeout` has it
FORKED = {"input", "stdin", "stdout", "stderr", "cwd", "env"}  # what a run may be given and still be forked
ONLY = ("--only", {"default": "", "help": "cases whose name contains this text"})


class Checks:
    """Counts of passed and failed checks and of skipped ones."""

    def __init__(self):
        self.passed = self.failed = self.skipped = 0

    def holds(self, condition, *what):
        """Count a check; `what` are a message and the operands, printed if it fails. An operand that is a float of gmpy2 is a failure."""
        condition = condition and not any(map(exact.is_float, (condition, *what)))
        if condition:
            self.passed += 1
        else:
            self.fail(*what)
        return condition

    def equal(self, got, want, *where):
        if got == want and not exact.is_float(got) and not exact.is_float(want):
            self.passed += 1
            return True
        self.fail(*where, f"got {got}, expected {want}")
        return False

    def fail(self, *what):
        self.failed += 1
        if self.failed <= SHOWN:
            print("FAILED", *(str(part)[:3000] for part in what), flush=True)
        elif self.failed == SHOWN + 1:
            print("FAILED further checks", flush=True)

    def skip(self, name, reason, count=1):
        self.skipped += count
        print(f"SKIP {name}: {reason}")

    def finish(self):
        """Print the summary and end the process."""
        skipped = f", {self.skipped} skipped" if self.skipped else ""
        print(f"{self.passed} passed, {self.failed} failed{skipped}")
        sys.exit(1 if self.failed or self.passed + self.skipped == 0 else 0)


class Options(argparse.Namespace):
    """The options of a suite. Its random part is a stream of rounds: of those at scale 1 a suite runs the share from `start` to `scale`,
    each with the same random numbers whatever ran before, so that runs of 0 to 1/4 and of 1/4 to 1 are together one of 0 to 1."""

    @property
    def derived(self):
        """Do checks run that are not random? They run once, where the stream begins, and in full."""
        return self.start == 0

    @property
    def share(self):
        """The part of the stream at scale 1 that runs: bars for totals over the stream are multiplied by it."""
        return self.scale - self.start

    @property
    def to_the_end(self):
        """Does the stream run to its end? Then costly checks are asked that say little beside cheaper ones of all calls."""
        return self.scale >= 1

    @property
    def ample(self):
        """Does enough of the stream run for totals that are seldom met?"""
        return self.share >= Fraction(3, 4)

    def rounds(self, count, name=""):
        """The numbers of the rounds that run of a stream of `count` at scale 1. Streams of one suite have different names."""
        for k in range(math.ceil(count * self.start), math.ceil(count * self.scale)):
            self.random.seed(f"{self.seed} {name} {k}")
            yield k

    def cycle(self, items, passes=1, name=""):
        """(k, item), round by round: `passes` passes over the items at scale 1, in an order in which neighbours are not alike."""
        order = self.order(items)
        for k in self.rounds(passes * len(order), name):
            yield k, order[k % len(order)]

    def once(self, items, name="", larger=()):
        """Each item once at scale 1, as in `cycle`; at larger scales those of `larger` too."""
        order = self.order(items)
        every = order + list(larger)
        for k in self.rounds(len(order), name):
            if k < len(every):
                yield every[k]

    @staticmethod
    def order(items):
        """The items shuffled, the same way for every seed."""
        items = list(items)
        random.Random(len(items)).shuffle(items)
        return items


def positive(text):
    """A fraction above 0, for `--scale`."""
    value = Fraction(text)
    if value <= 0:
        raise ValueError(text)
    return value


def share(text):
    """A fraction of 0 and more but less than 1, for `--from`."""
    value = Fraction(text)
    if not 0 <= value < 1:
        raise ValueError(text)
    return value


def options(description, *more, seed=2008):
    """The options of every suite, and `more` as (name, arguments of add_argument).

    In the result, `graze` is an absolute path, `random` a generator of the seed. The suite and what it starts may map MEMORY
    bytes each; not with sanitizers, which map much more.
    """
    parser = argparse.ArgumentParser(description=description.split("\n\n")[0].replace("%", "%%"))
    parser.add_argument("--graze", default=os.path.join(ROOT, "build", "graze"), help="the program under test")
    parser.add_argument("--scale", type=positive, default=Fraction(1), help="multiplies the random part; a fraction: its beginning")
    parser.add_argument("--from", dest="start", type=share, default=Fraction(0), metavar="F",
                        help="begin at this share of the random part at scale 1, without what is not random")
    parser.add_argument("--seed", type=int, default=seed, help="of the random part")
    parser.add_argument("--sanitizers", action="store_true", help="the program is built with a sanitizer")
    for name, arguments in more:
        parser.add_argument(name, **arguments)
    args = parser.parse_args(namespace=Options())
    if args.start >= args.scale:
        parser.error(f"--from {args.start}: expected less than the scale, {args.scale}")
    args.graze = os.path.abspath(args.graze)
    forks.serve(args.graze)
    args.random = random.Random(args.seed)
    if not args.sanitizers:
        hard = resource.getrlimit(resource.RLIMIT_AS)[1]
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY if hard == resource.RLIM_INFINITY else min(MEMORY, hard), hard))
    print(f"seed {args.seed}, scale {args.scale}" + (f", from {args.start}" if args.start else ""))
    return args


def bounded(command, memory=0, **more):
    """The command with `memory` bytes of address space instead of the suite's, 0: the most that is allowed, and other limits by their names
    in prlimit(1), which is part of every Debian: a function for preexec_fn costs each run more than the rest of its start."""
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    memory = memory or ("unlimited" if hard == resource.RLIM_INFINITY else hard)
    return ["prlimit", f"--as={memory}:", *(f"--{name}={most}" for name, most in more.items()), *command]


def without_leaks():
    """The environment of a program that keeps memory until it ends, as graze-check does."""
    return dict(os.environ, ASAN_OPTIONS=os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0")


def run(command, seconds=SECONDS, text=True, **more):
    """One run of a program, as subprocess.CompletedProcess; status TOO_LATE if it had to be ended.

    Without `input` or `stdin` standard input is empty. Output is text, or bytes if `text` is false.

    The program of --graze, and graze-check beside it, is started once and forks for each run (forks.py): where libraries lie in
    memory, and all that happens before main, is then that of the first. By exec go commands of another program, one in front of
    graze too (`bounded`, mpirun, a wrapper of the shell); runs with other arguments of subprocess.run than FORKED names; what a
    suite starts by itself: runs that get signals, terminals or FIFOs, other users, what is installed; and all if GRAZE_EXEC=1.
    """
    command = [str(word) for word in command]
    form = {"encoding": "utf-8", "errors": "replace"} if text else {}
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    if more.get("input") is None:
        more.pop("input", None)
        pipes["stdin"] = subprocess.DEVNULL
    try:
        done = forks.run(command, seconds, text, more) if FORKED.issuperset(more) else None
        return done or subprocess.run(command, timeout=seconds, check=False, **{**pipes, **form, **more})
    except subprocess.TimeoutExpired as late:
        got = [part.decode("utf-8", "replace") if text and isinstance(part, bytes) else part
               for part in (late.stdout, late.stderr)]
        empty = "" if text else b""
        said = f"\nno end after {seconds} s\n"
        return subprocess.CompletedProcess(command, TOO_LATE, got[0] or empty,
                                           (got[1] or empty) + (said if text else said.encode()))
