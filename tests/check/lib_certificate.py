"""Certificates as lists, written back, and the programs that make and check them.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import hashlib
import json
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in ("../lib", "../agree/lib", "../cases"):  # both have a module `times`: that of the cases is meant
    sys.path.insert(0, os.path.join(HERE, folder))
import definitions  # noqa: E402
import harness  # noqa: E402

VERIFIED, REFUTED, NOT_CHECKED = 0, 1, 2
RECORD = os.environ.get("GRAZE_CHECK_RECORD")  # a folder for all calls of graze-check: tests/check/weakened.py


class Row:
    """point: texts; claims: texts from the word on; intervals: lists [kind, time, c0, c1, ...]; contacts: pairs of
    the number of intervals before it and a list ["contact", ...]."""

    def __init__(self, words, dimension):
        self.point, self.claims, self.intervals = words[:dimension], words[dimension:], []
        self.contacts = []

    def __deepcopy__(self, _):  # copied thousands of times: copy's own way takes fifty times as long
        out = Row([*self.point, *self.claims], len(self.point))
        out.intervals = [list(interval) for interval in self.intervals]
        out.contacts = [(before, list(line)) for before, line in self.contacts]
        return out

    @property
    def word(self):
        return self.claims[0]

    def claim(self, word, unsweep, combined):
        """Claim a word, and all that follows from it by the printed definitions."""
        if unsweep:
            self.claims = [word, "in" if word == "I" else "out" if "O" in word else "on"]
            return
        is_ = definitions.expected(word, combined)
        k = definitions.runs_of_i(word)
        self.claims = [word, is_["pmc"], is_["class"], is_["definition"], is_["case"], is_["i"],
                       is_["t"], str(k)]

    def spelled(self):
        """The word of the intervals."""
        out = ""
        for interval in self.intervals:
            for letter in interval[0]:
                out += letter if out[-1:] != letter else ""
        return out

    def lines(self):
        out = [["row", *self.point, *self.claims]]
        for k in range(len(self.intervals) + 1):
            out += [line for before, line in self.contacts if before == k] + self.intervals[k:k + 1]
        return out


class Certificate:
    def __init__(self, text):
        lines = [line.split() for line in text.splitlines()]
        first = next((k for k, line in enumerate(lines) if line[0] in ("row", "complete")), 0)
        self.head, self.end, self.rows = lines[:first], lines[-1], []
        for line in lines[first:-1]:
            if line[0] == "row":
                self.rows.append(Row(line[1:], int(self.value("dimension"))))
            elif line[0] == "contact":
                self.rows[-1].contacts.append((len(self.rows[-1].intervals), line))
            else:
                self.rows[-1].intervals.append(line)

    def value(self, key):
        return next(line[1] for line in self.head if line[0] == key)

    def set(self, key, value):
        next(line for line in self.head if line[0] == key)[1] = value

    @property
    def unsweep(self):
        return self.value("operation") == "unsweep"

    @property
    def combined(self):
        return self.value("folds") == "combined"

    def lines(self):
        return [*self.head, *(line for row in self.rows for line in row.lines()), self.end]

    def text(self):
        return "".join(" ".join(line) + "\n" for line in self.lines())

    def only(self, rows):
        """A certificate with this head and these rows."""
        out = copy.copy(self)
        out.head, out.rows = copy.deepcopy(self.head), copy.deepcopy(rows)
        out.end = ["complete", str(len(rows))]
        return out


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


# graze-check keeps solid and motion until it ends; what it takes for a row it gives back.
ENVIRONMENT = harness.without_leaks()


def run(*command, env=None):
    """(status, standard output, standard error)"""
    done = harness.run(command, 600, env=env)
    return done.returncode, done.stdout, done.stderr


class Programs:
    def __init__(self, graze):
        self.graze = graze
        self.check_program = os.path.join(os.path.dirname(graze), "graze-check")

    def convert(self, case, folder):
        """A golden case's solid and motion as graze-check reads them: two paths."""
        solid = os.path.join(folder, "solid.off" if case.dimension == 3 else "solid.wkt")
        motion = os.path.join(folder, "motion.json")
        for source, path in ((case.path(case.solid), solid), (case.path("motion.json"), motion)):
            status, _, error = run(self.graze, "convert", source, "-o", path)
            if status != 0:
                raise RuntimeError(f"graze convert {source}: {status} {error}")
        return solid, motion

    def certify(self, solid, motion, points, options=()):
        status, out, error = run(self.graze, "certify", solid, motion, points, *options)
        if status != 0:
            raise RuntimeError(f"graze certify {solid} {motion} {points}: {status} {error}")
        return out

    def table(self, solid, motion, points, options=()):
        return run(self.graze, "classify", solid, motion, points, *options, "--quiet")[1]

    def check(self, *words):
        done = run(self.check_program, *words, env=ENVIRONMENT)
        if RECORD:
            record(words, *done)
        return done


def record(words, status, out, error):
    """Keep the files of a call and what came of it: one folder a call, named by what was given."""
    given = [open(word, "rb").read() if os.path.isfile(word) else None for word in words]
    name = hashlib.sha256(repr([given, [w for w, g in zip(words, given) if g is None]]).encode()).hexdigest()[:24]
    folder = os.path.join(RECORD, name)
    if os.path.exists(folder):
        return
    os.makedirs(folder)
    kept = []
    for k, (word, text) in enumerate(zip(words, given)):
        kept.append(word if text is None else f"{k}" + os.path.splitext(word)[1])
        if text is not None:
            with open(os.path.join(folder, kept[-1]), "wb") as file:
                file.write(text)
    with open(os.path.join(folder, "call.json"), "w", encoding="utf-8") as file:
        json.dump({"words": kept, "status": status, "out": out, "error": error}, file)


def answer_options(options):
    """The options of a case that certify takes too."""
    out = []
    for k, word in enumerate(options):
        if word in ("--folds", "--operation"):
            out += options[k:k + 2]
    return out
