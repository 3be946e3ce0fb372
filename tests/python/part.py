"""Runs the tests of this folder in this interpreter, with or without numpy, and counts them.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import signal
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "..", "src", "python"), HERE]


# Searches for planted bugs in scenes that are drawn: half of the time of all tests.
KIT = ("test_shrink.Planted.", "test_strategies.Strategies.")


def each(suite):
    """The tests of suites in suites."""
    for one in suite:
        yield from each(one) if isinstance(one, unittest.TestSuite) else [one]


class Counting(unittest.TextTestResult):
    """Counts what passed: a test is one, however many parts it has."""

    passed = 0

    def addSuccess(self, test):
        super().addSuccess(test)
        self.passed += 1


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("way", choices=["with-numpy", "without-numpy"])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--scale", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="test_*.py")
    parser.add_argument("--kit", choices=["with", "without", "alone"], default="with")
    options = parser.parse_args()
    if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:  # in a shell's background
        signal.signal(signal.SIGINT, signal.default_int_handler)
    if options.way == "without-numpy":
        # An entry of None makes the import fail as if the package were absent.
        sys.modules["numpy"] = None
        sys.modules["pandas"] = None
    import common
    common.GRAZE, common.SCALE, common.SEED = options.graze, options.scale, options.seed
    tests = unittest.defaultTestLoader.discover(HERE, pattern=options.only)
    if options.kit != "with":
        tests = unittest.TestSuite(test for test in each(tests) if test.id().startswith(KIT) == (options.kit == "alone"))
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=0, resultclass=Counting).run(tests)
    # A test that needs numpy is none of the run without it.
    idle = [skip for skip in result.skipped if options.way == "without-numpy" and skip[1] == "numpy"]
    skipped = [skip for skip in result.skipped if skip not in idle]
    for test, reason in skipped:
        print(f"SKIP {test.id()}: {reason}")
    bad = len(result.failures) + len(result.errors)
    print(f"seed {options.seed}, {options.way}, Python {sys.version.split()[0]}")
    print(f"sum {result.passed} {bad} {len(skipped)}")
    sys.exit(1 if bad or not result.testsRun else 0)


if __name__ == "__main__":
    main()
