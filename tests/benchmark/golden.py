#!/usr/bin/env python3
"""Golden rows of the benchmark: cases/benchmark/golden.py makes what its hashes say, and notices what is changed.

SPDX-License-Identifier: GPL-3.0-or-later

One scene of the tree is made whole; the rest is tried on a cube of the suite's own, with few points, and with programs
that fail in the place of Graze's.
"""
import hashlib
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import ROOT, Checks, options, run, without_leaks  # noqa: E402

HERE = os.path.join(ROOT, "cases", "benchmark")
SMALL = "igl-2562"  # the scene of the tree that is made: a cube, straight
CUBE = ("OFF\n8 6 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 2 3 7 6\n4 0 4 7 3\n4 1 2 6 5\n")
MOVE = '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["8*t", "0", "0"]}}]}\n'
SCENE = {"name": "cube", "family": "parts", "count": 60, "seed": 3, "straight": True, "diagonal": 3.46, "poses": {}}
HASHED = "x,y,z,id,stratum,order,cell,time,k,side,pmc,class,definition,case,i,t,word,topo"


class Golden:
    """Runs of golden.py on a folder of scenes."""

    def __init__(self, checks, folder, args):
        self.checks, self.folder = checks, folder
        self.programs = {"--graze": args.graze, "--check": os.path.join(os.path.dirname(args.graze), "graze-check")}
        self.hashes = self.path("hashes.txt")

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, text, *names):
        os.makedirs(os.path.dirname(self.path(*names)), exist_ok=True)
        with open(self.path(*names), "w", encoding="ascii") as file:
            file.write(text)

    def read(self, *names):
        with open(self.path(*names), encoding="ascii") as file:
            return file.read()

    def scene(self, name, **changed):
        self.write(CUBE, "out", name, "solid.off")
        self.write(MOVE, "out", name, "motion.json")
        self.write(json.dumps(SCENE | changed), "out", name, "scene.json")

    def call(self, *words, **programs):
        flags = [word for pair in (self.programs | {"--hashes": self.hashes, "--jobs": "1"} | programs).items() for word in pair]
        return run([sys.executable, os.path.join(HERE, "golden.py"), *flags, self.path("out"), *words], seconds=200, env=without_leaks())

    def expect(self, what, status, said, *words, **programs):
        """A run ends so, and each text stands in what it prints."""
        done = self.call(*words, **programs)
        said = [said] if isinstance(said, str) else said
        self.checks.holds(done.returncode == status and all(text in done.stdout + done.stderr for text in said), what, status, said, done)
        return done


def is_verified(golden, table):
    """Output of graze-check for the cube's certificate beside a table."""
    files = [golden.path("out", "cube", name) for name in ("solid.off", "motion.json", "certificate.txt")]
    return run([golden.programs["--check"], *files, table], env=without_leaks()).returncode == 0


def check_tree(golden, checks):
    """A scene of the tree has the hash of the tree, and a row for each point."""
    done = golden.expect("a scene of the tree", 0, [f"{SMALL}: 10000 rows", "hash agrees", "1 scenes, 10000 rows, 0 not"], SMALL,
                         **{"--hashes": os.path.join(HERE, "hashes.txt")})
    if done.returncode == 0:
        rows = [line for line in golden.read("out", SMALL, "golden.csv").splitlines() if not line.startswith("#")]
        checks.equal(len(rows), 10001, "rows and names")
        for name in ("sdf_low", "sdf_high", "boundary_low", *HASHED.split(",")):
            checks.holds(name in rows[0].split(","), name, rows[0])


def check_hash(golden, checks):
    """The hash is that of the columns HASHED: computed here once more from the table."""
    golden.scene("cube")
    golden.expect("recorded", 0, "cube: 60 rows", "--record", "cube")
    golden.expect("agrees", 0, "hash agrees", "cube")
    rows = [line.split(",") for line in golden.read("out", "cube", "golden.csv").splitlines() if not line.startswith("#")]
    at = [rows[0].index(name) for name in HASHED.split(",")]
    text = "".join(",".join(row[k] for k in at) + "\n" for row in rows)
    checks.equal(golden.read("hashes.txt").splitlines()[1:], [f"{hashlib.sha256(text.encode()).hexdigest()} 60 cube"], "the hash")


def changed(text, column, value):
    """The table with another value in its first row."""
    lines = text.splitlines()
    head = next(k for k, line in enumerate(lines) if not line.startswith("#"))
    fields = lines[head + 1].split(",")
    fields[lines[head].split(",").index(column)] = value
    return "\n".join([*lines[:head + 1], ",".join(fields), *lines[head + 2:], ""])


def check_changes(golden, checks):
    """A changed answer is noticed, by the hash and by graze-check; a changed enclosure is none of the hash's."""
    text, table = golden.read("out", "cube", "golden.csv"), golden.path("out", "cube", "golden.csv")
    checks.holds(is_verified(golden, table), "the certificate holds")
    for column, value, checked in (("pmc", "maybe", True), ("word", "OBOBO", True), ("x", "77", True), ("topo", "nowhere", False), ("id", "0", False)):
        golden.write(changed(text, column, value), "out", "cube", "golden.csv")
        golden.expect(column, 1, ["hash DIFFERS", "1 not as they should be"], "cube")
        checks.equal(is_verified(golden, table), not checked, column, "is certified")
    golden.write(changed(text, "sdf_low", "-7"), "out", "cube", "golden.csv")
    golden.expect("sdf_low", 0, "hash agrees", "cube")
    golden.write("\n".join(line for line in text.splitlines() if not line.startswith("#")), "out", "cube", "golden.csv")
    golden.expect("the head is not hashed", 0, "hash agrees", "cube")
    rows = text.splitlines(keepends=True)
    golden.write("".join(rows[:-3] + rows[-2:]), "out", "cube", "golden.csv")
    golden.expect("a row less", 1, ["59 rows", "hash DIFFERS"], "cube")
    golden.write(text.replace("topo", "top"), "out", "cube", "golden.csv")
    golden.expect("a column less", 1, "FAILED: " + table + ": no column topo", "cube")
    golden.write(text, "out", "cube", "golden.csv")


def check_again(golden, checks):
    """A finished scene is not computed again, unless its files have changed."""
    made = os.stat(golden.path("out", "cube", "golden.csv")).st_mtime_ns
    golden.scene("other", seed=4)
    golden.expect("the other one alone", 0, ["cube: 60 rows", "other: 60 rows"], "--record", "cube", "other")
    checks.equal(os.stat(golden.path("out", "cube", "golden.csv")).st_mtime_ns, made, "the cube is not made again")
    checks.equal([line.split()[1:] for line in golden.read("hashes.txt").splitlines()[1:]], [["60", "cube"], ["60", "other"]], "both are recorded")
    kept = golden.read("hashes.txt")
    golden.expect("the other one alone is recorded, the cube stays so", 0, "1 scenes", "--record", "other")
    checks.equal(golden.read("hashes.txt"), kept, "both stay recorded")
    golden.write(kept.replace(" 60 cube", " 61 cube"), "hashes.txt")
    golden.expect("another number of rows", 1, "hash DIFFERS", "cube")
    golden.write(kept, "hashes.txt")
    os.remove(golden.path("out", "cube", "done.txt"))
    golden.expect("a run that was ended", 0, "hash agrees", "cube")
    checks.holds(os.stat(golden.path("out", "cube", "golden.csv")).st_mtime_ns > made, "the cube is made again")
    for change in ({"seed": 5}, {"count": 61}):
        golden.scene("cube", **change)
        golden.expect(change, 1, "hash DIFFERS", "cube")
    golden.scene("cube")
    golden.write(MOVE.replace("8*t", "7*t"), "out", "cube", "motion.json")
    golden.expect("another motion", 1, "hash DIFFERS", "cube")
    golden.scene("cube")
    golden.expect("as before", 0, "hash agrees", "cube")


def check_failures(golden, checks):
    """A program that fails is named, the other scenes are made, and nothing half done stays under its last name."""
    golden.write("#!/bin/sh\necho it is refuted\nexit 1\n", "refuses")
    golden.write(f'#!/bin/sh\n[ "$1" = certify ] && {{ echo no room; exit 5; }}\nexec {golden.programs["--graze"]} "$@"\n', "full")
    for name in ("refuses", "full"):
        os.chmod(golden.path(name), 0o755)
    golden.expect("a certificate that is refuted", 1, ["cube: FAILED: refuses solid.off, status 1: it is refuted", "1 not as"], "cube",
                  **{"--check": golden.path("refuses")})
    os.remove(golden.path("out", "cube", "certificate.txt"))
    golden.expect("a program that fails", 1, "cube: FAILED: full certify, status 5: no room", "cube", **{"--graze": golden.path("full")})
    checks.holds(not os.path.exists(golden.path("out", "cube", "certificate.txt")), "no certificate is left")
    golden.scene("broken", family="odd")
    golden.scene("illegal")
    golden.write(CUBE.replace("4 1 2 6 5\n", "").replace("8 6 0", "8 5 0"), "out", "illegal", "solid.off")
    golden.expect("two scenes that fail", 1, ["broken: FAILED", "scene.json: a value is out of range", "illegal: FAILED: graze generate, status 3",
                                               "cube: 60 rows", "hash agrees", "2 not as they should be"], "broken", "illegal", "cube")
    golden.scene("stranger")
    golden.expect("a scene without a hash", 1, "hash not in the list", "stranger")
    golden.expect("no such scene", 3, "nowhere: no scene", "nowhere")
    golden.write("1234 60 cube\n", "hashes.txt")
    golden.expect("hashes that are none", 3, "hashes.txt: 1234 60 cube; expected lines", "cube")
    checks.equal(golden.call("--jobs", "0", "cube").returncode, 2, "usage")


def main():
    args, checks = options(__doc__), Checks()
    with tempfile.TemporaryDirectory() as folder:
        golden = Golden(checks, folder, args)
        for check in (check_hash, check_changes, check_again, check_failures, check_tree):
            check(golden, checks)
    checks.finish()


if __name__ == "__main__":
    main()
