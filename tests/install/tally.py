"""Counting checks, and running programs, for the suites of this folder. SPDX-License-Identifier: GPL-3.0-or-later"""
import os
import subprocess

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
passed = failed = 0


def check(holds, message):
    global passed, failed
    passed, failed = passed + bool(holds), failed + (not holds)
    if not holds:
        print("FAILED", message)
    return holds


def same(got, want, what):
    return check(got == want, f"{what}:\n  want {want!r}\n  got  {got!r}")


def run(command, folder=ROOT, **environment):
    """(standard output, standard error, status) of a list of words; make's own variables are taken away."""
    clean = {name: value for name, value in os.environ.items()
             if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "DESTDIR", "PREFIX")}
    done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, timeout=600, env=dict(clean, LC_ALL="C.UTF-8", **environment))
    return done.stdout.decode("utf-8", "replace"), done.stderr.decode("utf-8", "replace"), done.returncode


def output(command, folder=ROOT, **environment):
    """Standard output of a command that must succeed."""
    got, complaint, status = run(command, folder, **environment)
    check(status == 0, f"status {status} of {command}: {complaint}{got[-2000:]}")
    return got


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()
