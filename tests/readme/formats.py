#!/usr/bin/env python3
# suite
"""src/program/cli/formats.md against the program: its motions are legal, and it names every key, every limit with its
default, every status and every column, and those of options with their lines, order and refusals as the program has them, as do
the help and the lists of other pages. The form of proofs/glossary.md and CHANGELOG.md.

The names come from the program's own refusals and help, so that a key or limit that is added and not
described fails here. Of the glossary each term is one that the tree uses, each reference has the claims it names,
and the names of answers in the public headers have their lines. SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from column_sets import column_sets  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402

PAGE = os.path.join(ROOT, "src", "program", "cli", "formats.md")
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
    """Output of graze motion --examples: legal motions with every key, each named in the line before one."""
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
    listed = re.search(r"--limit NAME=V(.*?)(?:\n\n|\Z)", output, re.S)[1]
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


class Asked:
    """Tables of graze classify with options that add columns: of a cube, or of a ball, that moves, by a log or not."""

    def __init__(self, program):
        self.program, self.points = program, program.write("points.csv", "x,y,z,note\n5,1,1,a\n")
        pieces = ('{"dimension": 3, "pieces": [{"t": [0, 1], %s"transform": {"translate": ["8*t", 0, 0]}}]}' % row for row in ("", '"row": 7, '))
        self.plain, self.logged = (program.write(f"move{k}.json", text) for k, text in enumerate(pieces))
        self.ball = program.write("ball.csg.json", '{"dimension": 3, "solid": {"ball": {"radius": 1}}}')
        self.arguments = dict(re.findall(r"^  --([a-z-]+)(?: ([A-Z]+))? ", program.run("classify", "--help")[0], re.M))

    def words(self, option):
        return [f"--{option}", *(["1/100"] if self.arguments[option] else [])]

    def shown(self, option):
        return f"--{option} {self.arguments[option]}".rstrip()

    def run(self, *words, motion="", solid=""):
        given = [] if "--at-rest" in words else [motion or self.plain]
        return self.program.run("classify", solid or self.program.solids[3], *given, self.points, *words)

    def names(self, *words, **how):
        output, status = self.run(*words, **how)
        check(status == 0, words, how, output)
        return next(line for line in output.splitlines() if not line.startswith("#")).split(",")

    def beside(self, option):
        """The words that the option needs beside it, as refusals ask for them."""
        output, status = self.run(*self.words(option))
        needs = re.search(r"expected --([a-z-]+)( [a-z]+)? beside it", output)
        check(status == (2 if needs else 0), option, output)
        return ([f"--{needs[1]}", needs[2].strip()] if needs[2] else self.words(needs[1])) if needs else []

    def lines(self, option, beside):
        """The lines that begin with `#` which the option brings, with letters for numbers."""
        before, after = (self.run(*words, *beside)[0].splitlines() for words in ([], self.words(option)))
        new = [line.split() for line in after if line.startswith("#") and line not in before]
        letter = [value if value == "yes" else self.arguments[option] if key == option else "N" if value.isdigit() else "D" for _, key, value in new]
        return ", ".join(f"`# {key} {value}`" for (_, key, _), value in zip(new, letter))

    def row(self, option, columns):
        """The option's row of the page, from what the program does."""
        beside = self.beside(option)
        words = self.words(option) + beside
        where = {"": self.names(*words, motion=self.logged), " (from a log)": self.names(*words)}
        refused = [more for more in ("--columns pmc", "--at-rest", "--format jsonl", "--format npy", "--format vtk")
                   if self.run(*words, *more.split())[1] == 2]
        if "--at-rest" not in refused:
            where[" (not with `--at-rest`)"] = self.names(*words, "--at-rest")
        check(where[""][-len(columns):] == list(columns), option, "the table's last columns", where[""])
        told = ["`" + name + "`" + "".join(why for why, names in where.items() if name not in names) for name in columns]
        curved = ["curved solids"] if self.run(*words, solid=self.ball)[1] == 3 else []
        cells = (f"`{self.shown(option)}`", ", ".join(told), self.lines(option, beside), f"`{' '.join(beside).replace(' 1/100', '')}`" if beside else "",
                 ", ".join([f"`{more}`" for more in refused] + curved))
        return "| " + " | ".join(cells) + " |"


def columns_of_options(page, program):
    """The page's table of them is what the program does; the help has each option, and the names that it does not have itself."""
    asked, sets = Asked(program), column_sets()
    wanted = "".join(asked.row(option, columns) + "\n" for option, columns in sets.items())
    head = "\n| option | columns | lines | beside it | not beside it |\n|---|---|---|---|---|\n"
    check(f"{head}{wanted}\n" in page, f"formats.md: expected the rows\n{wanted}")
    for before, more in ((11, []), (6, ["--operation", "unsweep"])):
        taken = [option for option in sets if more or "unsweep" not in asked.beside(option)]
        names = asked.names(*(word for option in taken for word in asked.words(option)), *more, motion=asked.logged)
        check(names[before:] == [name for option in taken for name in sets[option]], "order", more, names)
    tables_of_values = "".join(re.findall(r"^\| column \| values \|\n\|[-|]+\|\n((?:\|.*\n)+)", page, re.M))
    of = {name: number for number, columns in enumerate(sets.values()) for name in columns}
    told = [name for line in tables_of_values.splitlines() for name in re.findall(r"`(\w+)`", line.split("|")[1]) if name in of]
    check(sorted(told) == sorted(of) and told == sorted(told, key=of.get), "columns with values on the page, once and in order", told)
    helped = dict(re.findall(r"^  --([a-z-]+)(.*(?:\n {20,}.*)*)", program.run("classify", "--help")[0], re.M))
    for option, columns in sets.items():
        count = re.search(r"\b(a|one|two|three) (?:columns?|more)\b", helped[option])
        check(not count or {"a": 1, "one": 1, "two": 2, "three": 3}[count[1]] == len(columns), option, helped[option])
        name = next(iter(columns))
        check(len(columns) > 1 or name == option or f"column {name}" in helped[option], option, helped[option])


def read(*parts):
    with open(os.path.join(ROOT, *parts), encoding="utf-8") as file:
        return file.read()


# The answer that a name belongs to, by the function that gives the name.
OF = {"pmc": "pmc", "class": "class", "topo": "position", "topo_level": "level", "regular": "regular", "role": "role", "trim": "status",
      "orientation": "orientation", "event_kind": "event", "decomposable": "decomposable",
      "curve_kind": "part of a curve", "chain_form": "chain", "pair_verdict": "verdict of a pair"}
NAMING = r'/\*\* ([^/]*?), else "none"\. Static\. \*/\nGRAZE_API const char \*graze_(\w+)_name'


def names_of_answers():
    """(name, what it is of) of each answer, from the comments of the functions that name them."""
    headers = "".join(read(path) for path in sorted(glob.glob(os.path.join(ROOT, "include", "graze", "*.h"))))
    found = {(name, OF.get(what, what))
             for comment, what in re.findall(NAMING, headers)
             for name in re.findall(r'"(\w+)"', comment)}
    kinds = re.findall(r"\bGRAZE_(INTERSECTION|TANGENCY)\b = ", headers)
    return found | {(kind.lower(), "kind of a contact") for kind in kinds}


def references(where, text):
    """Each link leads to a file, which has the claims that are named behind it."""
    for target, claims in re.findall(r"\]\(([^)]*)\)((?:,? C\d+)*)", text):
        path = os.path.join(ROOT, "proofs", target)
        if check(os.path.exists(path), f"{where}: a link leads to {target}"):
            for claim in re.findall(r"C\d+", claims):
                check(f"\n## {claim} " in read(path), f"{where}: {target} does not prove {claim}")


def glossary():
    page = read("proofs", "glossary.md")
    places = [path for pattern in ("include/**/*.h", "proofs/*.md", "src/**/*.[ch]", "src/**/*.md", "*.md")
              for path in glob.glob(os.path.join(ROOT, pattern), recursive=True) if not path.endswith("glossary.md")]
    tree = re.sub(r"[\s*]+", " ", "\n".join(map(read, places))).lower()
    lines = [line for line in page.splitlines() if line.startswith("- ")]
    terms = []
    for line in lines:
        entry = re.fullmatch(r"- \*\*([^*]+)\*\*: (.*[^.]) \((.*(?:\]\(|\[EI\]|\[IS\]|\[AMS\]).*)\)", line)
        if check(entry, f"expected `- **term**: one sentence (reference)`: {line}"):
            terms.append(entry[1])
            check(". " not in entry[2] and len(entry[2]) <= 200, f"{entry[1]}: more than a sentence")
            check(re.search(rf"\b{re.escape(entry[1].lower())}", tree), f"{entry[1]} is used nowhere")
    references("proofs/glossary.md", page)
    check(50 <= len(terms) == len(set(terms)), f"{len(terms)} terms")
    for part in page.split("\n## "):
        listed = re.findall(r"^- \*\*([^*]+)", part, re.M)
        check(listed == sorted(listed, key=str.lower), f"terms are not in order: {listed}")
    rows = re.findall(r"^\| (`[^|]*) \| ([^|]*) \| ([^|]* \(.*\[.*\)) \|$", page, re.M)
    listed = [(name, what) for words, what, _ in rows for name in re.findall(r"`(\w+)`", words)]
    check(len(listed) == len(set(listed)), "a name of an answer stands twice")
    wanted = names_of_answers()
    check(len(wanted) > 40, f"{len(wanted)} names of answers are found")
    check(set(listed) == wanted, f"names of answers: lacking {sorted(wanted - set(listed))}, unknown {sorted(set(listed) - wanted)}")


def changelog():
    """One section, of three parts of short lines."""
    page = read("CHANGELOG.md")
    check(re.findall(r"^#+ (.*)", page, re.M) == ["Changes", "1.0.0 - unreleased", "Added", "Changed", "Fixed"], "CHANGELOG.md: its headings")
    for number, line in enumerate(page.splitlines(), 1):
        check(len(line) <= 160, f"CHANGELOG.md:{number}: {len(line)} characters, expected at most 160")
        check(not line or line[0] in "#-" or number < page[:page.index("## ")].count("\n") + 1,
              f"CHANGELOG.md:{number}: expected one line for each change")


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
        columns_of_options(page, program)
    glossary()
    changelog()
    checks.finish()


if __name__ == "__main__":
    main()
