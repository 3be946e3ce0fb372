#!/usr/bin/env python3
# suite
"""src/cli/formats.md against the program: its motions are legal, and it names every key, every limit with its
default, every status and every column.

The names come from the program's own refusals and help, so that a key or limit that is added and not
described fails here. SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402

PAGE = os.path.join(ROOT, "src", "cli", "formats.md")
CORNERS = ("0 0 0", "2 0 0", "2 2 0", "0 2 0", "0 0 2", "2 0 2", "2 2 2", "0 2 2")
FACETS = ("0 3 2 1", "4 5 6 7", "0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7")
CUBE = "\n".join(("OFF", "8 6 0", *CORNERS, *("4 " + facet for facet in FACETS))) + "\n"
SQUARE = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\n"
# Motions with an unknown key at every place that has keys of its own; the refusal lists the known ones.
UNKNOWN = [
    {"dimension": 3, "?": 1},
    {"dimension": 3, "pieces": [{"?": 1}]},
    {"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"?": 1}}]},
    {"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"rotate": {"?": 1}}}]},
    {"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"turn": {"?": 1}}}]},
    {"dimension": 3, "keyframes": [{"?": 1}, {"t": 1}]},
    {"dimension": 2, "keyframes": [{"?": 1}, {"t": 1}]},
    {"dimension": 3, "relative": {"?": 1}},
]
checks = Checks()
check = checks.holds


class Program:
    def __init__(self, graze, folder):
        self.graze, self.folder = graze, folder
        self.solids = {2: self.write("square.wkt", SQUARE), 3: self.write("cube.off", CUBE)}

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run(self, *words):
        done = harness.run([self.graze, *words], 120, stderr=subprocess.STDOUT)
        return done.stdout, done.returncode

    def check_motion(self, dimension, text):
        return self.run("check", self.solids[dimension], self.write("motion.json", text))


def motions(page, program):
    """Every json block is a legal motion; returns the keys they show."""
    blocks = re.findall(r"^```json\n(.*?)^```$", page, re.M | re.S)
    keys = set()

    def collect(pairs):
        keys.update(key for key, _ in pairs)
        return dict(pairs)

    check(len(blocks) >= 10, f"{len(blocks)} motions on the page")
    for block in blocks:
        dimension = json.loads(block, object_pairs_hook=collect)["dimension"]
        output, status = program.check_motion(dimension, block)
        check(status == 0, f"status {status} of\n{block}{output}")
    return keys


def known_keys(program):
    keys = set()
    for motion in UNKNOWN:
        output, status = program.check_motion(motion["dimension"], json.dumps(motion))
        listed = re.search(r"unknown key; expected one of (.*)", output)
        if check(status == 3 and listed, f"{motion}: status {status}, {output}"):
            keys.update(listed[1].split(", "))
    return keys


def examples(program, known):
    """What graze motion --examples prints: legal motions with every key, each named in the line before one."""
    output, status = program.run("motion", "--examples")
    lines = output.splitlines()
    check(status == 0 and len(lines) % 2 == 0 and len(lines) > 20, status, output)
    shown, named = set(), set()

    def collect(pairs):
        shown.update(key for key, _ in pairs)
        return dict(pairs)

    for note, text in zip(lines[::2], lines[1::2]):
        check(note.startswith("# ") and text.startswith("{"), note, text)
        named.update(re.findall(r"[a-z_]+", note))
        motion = json.loads(text, object_pairs_hook=collect)
        output, status = program.check_motion(motion["dimension"], text)
        check(status == 0, f"status {status} of {text}{output}")
    check(shown == known, f"keys without an example: {sorted(known - shown)}; unknown: {sorted(shown - known)}")
    check(known <= named, f"keys that no line names: {sorted(known - named)}")


def number(text):
    """10^10, 4*10^9, 4·10^9 and 10,000 as integers."""
    factor, _, power = text.replace("·", "*").replace(",", "").rpartition("*")
    base, _, exponent = power.partition("^")
    return int(factor or 1) * int(base) ** int(exponent or 1)


def limits(page, program):
    output, _ = program.run("classify", "--help")
    listed = re.search(r"--limit NAME=V(.*?)\n\n", output, re.S)[1]
    program_has = {name: number(value) for name, value in re.findall(r"([a-z]+) ([\d*^]+)", listed)}
    table = page[page.index("## Limits"):]
    page_has = {name: number(value) for name, value in
                re.findall(r"^\| `([a-z]+)` \|.*\| ([\d,·^]+) \|$", table, re.M)}
    check(program_has == page_has, f"limits: --help {program_has}, the page {page_has}")
    output, _ = program.run("check", "a", "b", "--limit", "?=1")
    every = set(re.search(r"NAME one of (.*)", output)[1].split(", "))
    check(every == set(page_has), f"limits: known {every}, the page {set(page_has)}")


def tables(page, program):
    points = program.write("points.csv", "x,y,z,note\n5,1,1,a\n")
    motion = program.write("move.json", '{"dimension": 3, "pieces": [{"t": [0, 1], '
                                        '"transform": {"translate": ["8*t", 0, 0]}}]}')
    for words, names in ((["classify"], "x,y,z,pmc,class,definition,case,i,t,word"),
                         (["classify", "--operation", "unsweep"], "x,y,z,pmc,word")):
        output, status = program.run(*words, program.solids[3], motion, points)
        head = [line for line in output.splitlines() if not line.startswith("#")][:1]
        check(status == 0 and head == [names + ",note"], f"{words}: {head}")
        check(f"`{names}`" in page, f"the page does not have the columns {names}")
        check(output.endswith("# complete 1\n"), f"{words} ends with {output[-20:]!r}")
    statuses = set(re.findall(r"^\| (\d) \|", page, re.M))
    check(statuses == set("0123456"), f"exit status {sorted(statuses)}")


def main():
    graze = options(__doc__).graze
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    with tempfile.TemporaryDirectory() as folder:
        program = Program(graze, folder)
        shown, known = motions(page, program), known_keys(program)
        check(known <= shown, f"keys that no example of the page shows: {sorted(known - shown)}")
        check(shown <= known, f"keys of examples that no refusal lists: {sorted(shown - known)}")
        examples(program, known)
        limits(page, program)
        tables(page, program)
    checks.finish()


if __name__ == "__main__":
    main()
