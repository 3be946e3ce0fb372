#!/usr/bin/env python3
# suite
"""The rounds of a suite's random part: a beginning and the rest of a stream are together the stream, whatever ran before.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import random
import subprocess
import sys
from fractions import Fraction

LIB = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib")
sys.path.insert(0, LIB)

from harness import Checks, Options, options  # noqa: E402


def made(scale, start="0", seed=7):
    return Options(scale=Fraction(scale), start=Fraction(start), seed=seed, random=random.Random(seed))


def numbers(args, count, name=""):
    """The first number that each round draws; round k then draws k more."""
    out = []
    for k in args.rounds(count, name):
        out.append((k, args.random.random()))
        for _ in range(k):
            args.random.random()
    return out


def streams(checks):
    for count in (0, 1, 2, 3, 4, 5, 12, 103):
        whole = numbers(made("1"), count)
        checks.equal([k for k, _ in whole], list(range(count)), count, "one stream")
        for at in ("1/4", "1/3", "99/100", "1"):
            before = numbers(made(at), count)
            after = numbers(made("1", at), count) if at != "1" else []
            checks.equal(before + after, whole, count, at)
            checks.equal(len(before), -(-count * Fraction(at).numerator // Fraction(at).denominator), count, at, "rounded up")
        checks.equal(numbers(made("4"), count)[:count], whole, count, "a larger scale goes on")
        checks.equal(len(numbers(made("4"), count)), 4 * count, count)
    checks.equal(len(numbers(made("1"), Fraction(7, 2))), 4, "a count that is no whole number")


def draws_differ(checks):
    whole = [x for _, x in numbers(made("1"), 50)]
    checks.equal(len(set(whole)), 50, "rounds draw different numbers")
    for other in (numbers(made("1"), 50, "another"), numbers(made("1", seed=8), 50)):
        checks.equal(set(whole) & {x for _, x in other}, set(), "another name or seed draws others")


def shares(checks):
    for scale, start, derived, share, ample in (("1", "0", True, "1", True), ("1/4", "0", True, "1/4", False),
                                                ("1", "1/4", False, "3/4", True), ("4", "0", True, "4", True),
                                                ("1/2", "1/4", False, "1/4", False)):
        args = made(scale, start)
        checks.equal((args.derived, args.share, args.ample), (derived, Fraction(share), ample), scale, start)


def lists(checks):
    items, more = [f"item {k}" for k in range(13)], ["more 0", "more 1"]
    whole = list(made("1").once(items, "", more))
    checks.equal(sorted(whole), sorted(items), "each once")
    checks.holds(whole != items, "in another order")
    checks.equal(list(made("1/4").once(items)) + list(made("1", "1/4").once(items)), whole, "a beginning and the rest")
    checks.equal(list(made("4", seed=9).once(items, "", more)), whole + more, "further ones at larger scales, in the same order for each seed")
    again = list(made("1").cycle(items, 2))
    checks.equal(again, list(enumerate(whole + whole)), "twice")
    checks.equal(len(list(made("1").cycle(items, Fraction(1, 2)))), 7, "half of them")


def from_outside(checks):
    """The options as they are written, and those that are refused."""
    script = ("import sys; sys.path.insert(0, sys.argv.pop(1)); import harness; args = harness.options('a suite')\n"
              "print(args.scale, args.start, args.derived, list(args.rounds(8)))")

    def said(*words):
        done = subprocess.run([sys.executable, "-c", script, LIB, *words], capture_output=True, text=True, timeout=60)
        return done.returncode, done.stdout.splitlines()[-1:], done.stderr
    for words, want in (((), "1 0 True [0, 1, 2, 3, 4, 5, 6, 7]"), (("--scale", "1/4"), "1/4 0 True [0, 1]"),
                        (("--from", "1/4"), "1 1/4 False [2, 3, 4, 5, 6, 7]"), (("--scale", "0.5", "--from", "3/8"), "1/2 3/8 False [3]")):
        checks.equal(said(*words)[:2], (0, [want]), *words)
    for words in (("--scale", "0"), ("--scale", "-1"), ("--from", "1"), ("--from", "-1/4"), ("--scale", "1/4", "--from", "1/4"), ("--scale", "x")):
        status, _, message = said(*words)
        checks.holds(status == 2 and words[-2] in message, *words, status, message)


def main():
    options(__doc__)
    checks = Checks()
    streams(checks)
    draws_differ(checks)
    shares(checks)
    lists(checks)
    from_outside(checks)
    checks.finish()


if __name__ == "__main__":
    main()
