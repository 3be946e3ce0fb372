"""Compiling the files of proofs/coq in a folder of their own.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from harness import ROOT, Checks  # noqa: E402,F401  (the scripts take Checks from here)

SOURCE = os.path.join(ROOT, "proofs", "coq")
OPTIONS = ["-Q", ".", "Graze"]
HEAD = re.compile(r"^\s*(?:Theorem|Lemma|Corollary|Definition|Fixpoint|Record|Inductive)\s+(\w+)", re.M)


def sources():
    return sorted(os.path.basename(p) for p in glob.glob(os.path.join(SOURCE, "*.v")))


def copy(folder):
    """The sources, and nothing else, in a folder."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for name in sources():
        shutil.copy(os.path.join(SOURCE, name), folder)


def run(folder, *command):
    return harness.run(command, 600, cwd=folder)


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
