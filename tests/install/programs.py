"""Running programs as a user of an installation does, for the suites of this folder.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402,F401  (suites take them from here)

checks = Checks()
check = checks.holds


def same(got, want, what):
    return check(got == want, f"{what}:\n  want {want!r}\n  got  {got!r}")


def run(command, folder=ROOT, **environment):
    """(standard output, standard error, status) of a list of words; make's own variables are taken away."""
    clean = {name: value for name, value in os.environ.items()
             if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "DESTDIR", "PREFIX")}
    done = harness.run(command, 600, cwd=folder, env=dict(clean, LC_ALL="C.UTF-8", **environment))
    return done.stdout, done.stderr, done.returncode


def output(command, folder=ROOT, **environment):
    """Standard output of a command that must succeed."""
    got, complaint, status = run(command, folder, **environment)
    check(status == 0, f"status {status} of {command}: {complaint}{got[-2000:]}")
    return got


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()
