"""Compiling the files of proofs/coq in a folder of their own.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import re
import shutil
import subprocess

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SOURCE = os.path.join(ROOT, "proofs", "coq")
OPTIONS = ["-Q", ".", "Graze"]
HEAD = re.compile(r"^\s*(?:Theorem|Lemma|Corollary|Definition|Fixpoint|Record|Inductive)\s+(\w+)", re.M)


class Checks:
    """Counts what holds and prints what does not."""

    def __init__(self):
        self.passed = self.failed = 0

    def check(self, holds, message):
        self.passed, self.failed = self.passed + bool(holds), self.failed + (not holds)
        if not holds:
            print("FAILED", message, flush=True)
        return holds

    def finish(self):
        print(f"{self.passed} passed, {self.failed} failed")
        raise SystemExit(1 if self.failed else 0)


def sources():
    return sorted(os.path.basename(p) for p in glob.glob(os.path.join(SOURCE, "*.v")))


def copy(folder):
    """The sources, and nothing else, in a folder."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for name in sources():
        shutil.copy(os.path.join(SOURCE, name), folder)


def run(folder, *command):
    return subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, timeout=600)


def order(folder):
    """The files in an order in which each comes after those it needs."""
    done = run(folder, "coqdep", "-sort", *OPTIONS, *sources())
    if done.returncode:
        raise SystemExit("coqdep: " + done.stderr)
    return [os.path.basename(name) for name in done.stdout.split()]


def compile_file(folder, name):
    return run(folder, "coqc", "-q", *OPTIONS, name)


def without_comments(text):
    """The text with comments, which may be nested, and strings blanked; lines stay where they are."""
    out, depth, k = [], 0, 0
    while k < len(text):
        if text.startswith("(*", k):
            depth, k = depth + 1, k + 2
        elif text.startswith("*)", k) and depth:
            depth, k = depth - 1, k + 2
        else:
            out.append(text[k] if not depth or text[k] == "\n" else " ")
            k += 1
    return re.sub(r'"[^"\n]*"', '""', "".join(out))


def lemma_at(text, line):
    """The name of the last definition or statement that begins at or before a line."""
    before = "\n".join(without_comments(text).split("\n")[:line])
    names = HEAD.findall(before)
    return names[-1] if names else None
