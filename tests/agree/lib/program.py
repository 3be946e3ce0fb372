"""Driving the program as a user does: files in, tables and JSON Lines out.

SPDX-License-Identifier: GPL-3.0-or-later

One Run is one solid, one motion and a list of points in a folder of its own. Every answer carries
both outputs' fields; a program that fails, or prints another number of rows, is one failed check,
never an exception of ours.
"""
import csv
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "lib"))

import harness  # noqa: E402
from harness import ROOT, Checks, run  # noqa: E402,F401  (suites take them from here)

KEEP = ("--keep", {"help": "folder that keeps the files of every run"})


def options(description, *more):
    """The options of every suite, and --keep."""
    return harness.options(description, KEEP, *more)


class Answer:
    """One point's row: `record` of JSON Lines, `row` of the table (None where not asked for)."""

    def __init__(self, record, row):
        self.record, self.row = record, row
        self.contacts = record["contacts"]
        self.word = record["word"]

    def counts(self):
        """The fields that the laws compare; None where unsweep has no such field."""
        r = self.record
        return (r["word"], r.get("i"), r.get("t"), r.get("class"), r.get("case"), r["pmc"])

    def times(self):
        return [(json.dumps(c["from"], sort_keys=True), json.dumps(c["to"], sort_keys=True))
                for c in self.contacts]

    def kinds(self):
        return [(c["kind"], c["left"], c["right"]) for c in self.contacts]

    def cells(self):
        return [cell_set(c["features"]) for c in self.contacts]


def cell_set(features):
    out = set()
    for f in features:
        (kind, value), = f.items()
        out.add((kind,) + (tuple(value) if isinstance(value, list) else (value,)))
    return out


class Graze:
    def __init__(self, args, checks):
        self.path, self.checks, self.keep = args.graze, checks, args.keep
        self.folder = tempfile.TemporaryDirectory()
        self.runs = 0

    def write(self, name, text):
        folder = self.keep or self.folder.name
        os.makedirs(folder, exist_ok=True)
        path = os.path.join(folder, name)
        with open(path, "w") as f:
            f.write(text)
        return path

    def call(self, *args):
        """One run within the limits of the suite."""
        self.runs += 1
        return run([self.path, *args])

    def classify(self, name, solid, motion, points, *flags, table=False):
        """Answers for the points, or None after a failed check. `solid` is an object with text()
        and suffix, or a path; `motion` likewise."""
        tag = name.replace(" ", "_").replace("/", "_")
        if not isinstance(solid, str):
            solid = self.write(tag + solid.suffix, solid.text())
        if not isinstance(motion, str):
            motion = self.write(tag + ".json", motion.text())
        rows = "".join(",".join(str(x) for x in p) + "\n" for p in points)
        csv_path = self.write(tag + ".csv", rows)
        out = self.call("classify", solid, motion, csv_path, "--format", "jsonl", *flags)
        if out.returncode:
            self.checks.fail(name, *flags, f"exit {out.returncode}: {out.stderr.strip()[:300]}")
            return None
        records = [json.loads(line) for line in out.stdout.splitlines()]
        rows = [None] * len(records)
        if table:
            out = self.call("classify", solid, motion, csv_path, *flags)
            lines = [x for x in out.stdout.splitlines() if not x.startswith("#")]
            rows = list(csv.DictReader(lines))
        if len(records) != len(points) or len(rows) != len(points):
            self.checks.fail(name, f"{len(records)} records, {len(rows)} rows for {len(points)} points")
            return None
        return [Answer(a, b) for a, b in zip(records, rows)]


def merged(word):
    """Equal neighbours made one."""
    return "".join(c for k, c in enumerate(word) if k == 0 or word[k - 1] != c)


def exchanged(word):
    return word.translate(str.maketrans("IO", "OI"))
