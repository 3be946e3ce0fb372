"""Driving the program as a user does: files in, tables and JSON Lines out; checks that count.

SPDX-License-Identifier: GPL-3.0-or-later

One Run is one solid, one motion and a list of points in a folder of its own. Every answer carries
both outputs' fields; a program that fails, or prints another number of rows, is one failed check,
never an exception of ours.
"""
import argparse
import csv
import json
import os
import random
import resource
import subprocess
import sys
import tempfile


SECONDS = 60     # of one run, thousands of times what any takes


class Checks:
    """Counts comparisons; prints the operands of those that fail, a screenful at most."""

    def __init__(self):
        self.passed = self.failed = self.skipped = 0

    def equal(self, got, want, *where):
        if got == want:
            self.passed += 1
            return True
        self.fail(f"got {got}, want {want}", *where)
        return False

    def true(self, claim, *where):
        return self.equal(bool(claim), True, *where)

    def fail(self, what, *where):
        self.failed += 1
        if self.failed <= 40:
            print("FAILED", " | ".join(str(w)[:300] for w in where), "|", what[:1500])

    def skip(self, what, count=1):
        self.skipped += count
        print("skipped:", what)

    def finish(self):
        tail = f", {self.skipped} skipped" if self.skipped else ""
        print(f"{self.passed} passed, {self.failed} failed{tail}")
        sys.exit(1 if self.failed else 0)


def options(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--graze", default="build/graze", help="the program under test")
    parser.add_argument("--scale", type=int, default=1, help="multiplies the random part")
    parser.add_argument("--seed", type=int, default=2008, help="of the random part")
    parser.add_argument("--memory", type=int, default=4,
                        help="GiB a run may map; 0 for no limit, which sanitizers need")
    parser.add_argument("--keep", help="folder that keeps the files of every run")
    args = parser.parse_args()
    args.graze = os.path.abspath(args.graze)
    args.random = random.Random(args.seed)
    print(f"seed {args.seed}, scale {args.scale}")
    return args


class Answer:
    """One point's row: `record` of JSON Lines, `row` of the table (None where not asked for)."""

    def __init__(self, record, row):
        self.record, self.row = record, row
        self.contacts = record["contacts"]
        self.word = record["word"]

    def counts(self):
        """What the laws compare; None where unsweep has no such field."""
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
        self.memory = args.memory
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
        """One run; one that takes too long comes back as exit status 124, as `timeout` says it."""
        self.runs += 1
        command = [self.path, *args]
        try:
            return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS,
                                  preexec_fn=self.limit)
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess(command, 124, "", f"no end after {SECONDS} s")

    def limit(self):
        if self.memory:
            resource.setrlimit(resource.RLIMIT_AS, (self.memory << 30, self.memory << 30))

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
            self.checks.fail(f"exit {out.returncode}: {out.stderr.strip()[:300]}", name, *flags)
            return None
        records = [json.loads(line) for line in out.stdout.splitlines()]
        rows = [None] * len(records)
        if table:
            out = self.call("classify", solid, motion, csv_path, *flags)
            lines = [x for x in out.stdout.splitlines() if not x.startswith("#")]
            rows = list(csv.DictReader(lines))
        if len(records) != len(points) or len(rows) != len(points):
            self.checks.fail(f"{len(records)} records, {len(rows)} rows for {len(points)} points",
                             name)
            return None
        return [Answer(a, b) for a, b in zip(records, rows)]


def merged(word):
    """Equal neighbours made one."""
    return "".join(c for k, c in enumerate(word) if k == 0 or word[k - 1] != c)


def exchanged(word):
    return word.translate(str.maketrans("IO", "OI"))
