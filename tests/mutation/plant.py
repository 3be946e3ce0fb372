#!/usr/bin/env python3
"""Draws the 60 mutants and the 30 faults of other kinds of mutation/planted/, so that nobody chooses them: by hand, once.

A mutant is one of mutate.py's, drawn by turns of the rooms that decide. A fault is one place of its kind (KINDS), drawn of all
that there are. What does not compile as the Makefile compiles it, or gives the same code, is passed over. Each is a patch against
the commit that added it; its first line says what it is.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import collections
import difflib
import glob
import itertools
import os
import random
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, ".."))

import changes  # noqa: E402
from mutate import drawn  # noqa: E402

MUTANTS = 60
FLAGS = {".c": ["gcc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-Wno-stringop-overread", "-Wno-stringop-overflow"],
         ".cpp": ["g++", "-std=c++17", "-frounding-math"]}
COMMON = ["-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-fvisibility=hidden", "-pthread", "-Iinclude", "-Isrc"]
C = ["src/*/*.c", "src/*/*/*.c"]
CPP = [*C, "src/*/*/*.cpp"]
MESSAGE = r'"((?:[^"\\]|\\.)+?)[;,] expected (?:[^"\\]|\\.)+"'


def without_lock(text, match):
    """The text without any lock or unlock of what is locked there."""
    return re.sub(rf"^ *pthread_mutex_(?:un)?lock\({re.escape(match[1])}\);\n", "", text, flags=re.M)


# (kind, how many, where, pattern, what stands there instead: a template, or a function of the text and the match)
KINDS = [
    ("an allocation that is not checked", 3, CPP, r"(= (?:m|c|re)alloc\([^;]*;\n\s*if )\(!?\w[^()]*\)", r"\1(0)"),
    ("a leak", 3, CPP, r"(?<=\n)\s+(?:free|\w+_clear)\([^;]*\);\n", ""),
    ("an overflow: a product of int", 1, CPP, r"\(s(?:ize_t|long)\)(\w[\w.>\[\]-]*) (?=\*)", r"\1 "),
    ("an overflow: a number too narrow", 1, CPP, r"\b(?:slong|int64_t|size_t) (\w+) = ", r"int \1 = "),
    ("a read out of bounds", 3, CPP, r"(for \((?:size_t|int|slong|uint32_t) (\w+) = 0; \2 )<(?= [^=])", r"\1<="),
    ("a race", 2, C, r"pthread_mutex_lock\(([^)]*)\)", without_lock),
    ("a message that does not say what is expected", 3, CPP, MESSAGE, r'"\1"'),
    ("a document of a name that is gone", 3, ["README.md", "src/program/cli/formats.md", "proofs/semantics.md", "src/docs/*.md"],
     r"`(--[a-z]+(?:-[a-z]+)*)", r"`\1s"),
    ("a rule of unfinished files", 2, ["src/program/io/output.c", "src/program/run/jobs.c", "src/program/run/record.c",
                                       "src/program/points/lines.c"], r"\bif \((?![^\n]*alloc)[^\n]*\)(?=[ \n])", "if (0)"),
    ("a symbol that is exported by mistake", 1, ["src/api/*.c"], r"\Z", "\nGRAZE_API int graze_left_over(void);\n"
     "int graze_left_over(void) {\n    return 0;\n}\n"),
    ("a value that is not initialised", 2, CPP, r"\b((?:int|size_t|double|slong) \w+) = 0;", r"\1;"),
    ("a file that stays open", 1, C, r"(?<=\n)\s+(?:fclose|close)\([^;]*\);\n", ""),
    ("a wrong exit status", 1, ["src/program/*/*.c"], r"\bEXIT_(?:USAGE|INPUT|IO)\b", "EXIT_DONE"),
    ("a check of Python that is gone", 1, ["src/python/graze/*.py"], r"\bif [^\n]+:(?=\n +raise )", "if False:"),
    ("a page that does not react", 1, ["src/output/page/*.js"], r"\bif \([^\n]*\)(?= )", "if (false)"),
    ("a weaker definition", 1, ["proofs/coq/[!s]*.v"], r"&&", "||"),
    ("a file that is not installed", 1, ["Makefile"], r"(?<=\n)\t@install -m 644 [^\n]*\n", ""),
]


def code(path, text):
    """The assembly of a source, `text` itself of another file; None if it does not compile."""
    kind = os.path.splitext(path)[1]
    if kind not in FLAGS:
        return text
    done = subprocess.run([*FLAGS[kind], *COMMON, "-iquote", os.path.dirname(path), "-x", "c" if kind == ".c" else "c++", "-S", "-o", "-",
                           "-"], input=text.encode(), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return done.stdout if done.returncode == 0 else None


def is_another(path, old, new):
    changed = code(path, new)
    return changed is not None and changed != code(path, old)


def write(name, what, path, old, new):
    lines = difflib.unified_diff(old.splitlines(keepends=True), new.splitlines(keepends=True), f"a/{path}", f"b/{path}")
    with open(os.path.join(HERE, "planted", name + ".patch"), "w", encoding="utf-8") as file:
        file.write(f"{what}: {path}\n{''.join(lines)}")


def plant_mutants(seed):
    """Plant mutants, one room after the other in turn."""
    options = argparse.Namespace(only="", file="", boundaries=False, among=None, seed=seed)
    decks = collections.defaultdict(list)
    for room, mutant in drawn(options, changes.record()):
        decks[room].append(mutant)
    number = 0
    for room in itertools.cycle(list(decks)):
        while number < MUTANTS:
            mutant = decks[room].pop(0)
            with open(mutant.path, encoding="utf-8") as file:
                old = file.read()
            if is_another(mutant.path, old, mutant.source()):
                number += 1
                write(f"mutant-{number:02}", f"a mutant of {room}", mutant.path, old, mutant.source())
                break
        else:
            return


def places(where, pattern):
    """(path, text, match) of a kind's places."""
    for path in sorted({path for name in where for path in glob.glob(name)}):
        with open(path, encoding="utf-8") as file:
            text = file.read()
        yield from ((path, text, match) for match in re.finditer(pattern, text))


def plant_faults(seed):
    number = 0
    for kind, many, where, pattern, instead in KINDS:
        deck = list(places(where, pattern))
        random.Random(f"{seed} {kind}").shuffle(deck)
        left = many
        for path, text, match in deck:
            new = instead(text, match) if callable(instead) else text[:match.start()] + match.expand(instead) + text[match.end():]
            if left and is_another(path, text, new):
                left, number = left - 1, number + 1
                write(f"fault-{number:02}", kind, path, text, new)
        if left:
            raise SystemExit(f"{kind}: {left} places too few of {len(deck)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", required=True)
    options = parser.parse_args()
    plant_mutants(options.seed)
    plant_faults(options.seed)


if __name__ == "__main__":
    main()
