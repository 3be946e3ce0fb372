"""Counting checks, and the options every suite takes. SPDX-License-Identifier: GPL-3.0-or-later"""
import argparse
import sys


class Tally:
    def __init__(self):
        self.passed, self.failed, self.skipped = 0, 0, 0

    def equal(self, got, want, *where):
        return self.holds(got == want, f"got {got}, want {want}", *where)

    def holds(self, condition, message, *where):
        if condition:
            self.passed += 1
        else:
            self.failed += 1
            print("FAILED", *where, message)
        return condition

    def skip(self, name, reason):
        self.skipped += 1
        print(f"SKIP {name}: {reason}")

    def finish(self):
        more = f", {self.skipped} skipped" if self.skipped else ""
        print(f"{self.passed} passed, {self.failed} failed{more}")
        sys.exit(1 if self.failed else 0)


def options(description):
    """--graze, --scale and --seed as every suite has them; cases are fixed, so the two last change
    nothing. --only NAME narrows the cases."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--scale", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    return parser.parse_args()
