#!/usr/bin/env python3
# suite
"""No file that a command reads, and none that it writes already, is the one that an option makes it write.

For each command, option to write and file to read, both are one file: by its name, by `./`, by a symbolic link, by a
hard link, by a link to the file that is read. Refused is status 2 with one line that names both, and everything in the
folder stays as it was. The same for two options to write, also where the file is not there yet. The options come from
--help and from the option tables: one that takes a file and has no row here, or takes a text and is not known to take
another one than a file, is a failure. SPDX-License-Identifier: GPL-3.0-or-later
"""
import itertools
import os
import pathlib
import re
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import machine  # noqa: E402
from harness import ROOT, Checks, options, run  # noqa: E402

COMMON = pathlib.Path(ROOT, "tests", "refuse", "common")
CSV, SCENE = "1,1\n5,1\n9,9\n", ["S.wkt", "M.json"]
SITES, LIST = "time,x,y\n1/2,2,1\n", "moving,motion,fixed\nS.wkt,M.json,S.wkt\n"
# Endings of what an option writes where that is not its value.
ENDINGS = {("validate", "--output"): [".md", ".json"], ("validate", "--keep"): ["/points.csv", "/golden.csv", "/candidate.csv"]}


class Row:
    """A command in the words of a run that ends with status 0; `read` are those of them that are files to read, which is
    also what the options of `reads` are given, and `writes` has names with the ending that each option asks for."""

    def __init__(self, words, read, writes, reads=(), ends=0, others=()):
        self.words, self.read, self.writes, self.reads, self.ends = words.split(), read, writes, reads, ends
        self.others = others

    @property
    def command(self):
        return self.words[0]


ROWS = [
    Row("check S.wkt M.json", SCENE, {"--receipt": "o", "--output": "o", "-o": "o"}),
    Row("classify S.wkt M.json P.csv", SCENE + ["P.csv"], {"--output": "o", "-o": "o", "--certify": "o", "--resume": "o"},
        reads=["--receipt"]),
    Row("certify S.wkt M.json P.csv", SCENE + ["P.csv"], {"--output": "o", "-o": "o", "--resume": "o"}, reads=["--receipt"]),
    Row("contact S.wkt M.json C.csv", SCENE + ["C.csv"], {"--output": "o", "--resume": "o"}),
    Row("merge 1.csv 2.csv", ["1.csv", "2.csv"], {"--output": "o"}),
    Row("explain S.wkt M.json 3 2", SCENE, {"--svg": "o.svg", "--output": "o"}),
    Row("generate S.wkt M.json -n 3 --seed 1", SCENE, {"--output": "o"}),
    Row("compare T.csv T2.csv", ["T.csv", "T2.csv"], {"--output": "o", "--page": "o.html"}, reads=["--solid", "--motion"]),
    Row("validate S.wkt M.json -n 3 --candidate", SCENE, {"--output": "o", "--keep": "o"}, others=["--shrink"]),
    Row("validate S.wkt M.json --candidate", SCENE, {"--output": "o", "--keep": "o"}, reads=["--points"]),
    Row("draw S.wkt M.json P.csv --grid 4", SCENE + ["P.csv"], {"--output": "o.svg", "-o": "o.svg"}),
    Row("draw S.wkt M.json P.csv --surface none", SCENE + ["P.csv"], {"--output": "o.html", "-o": "o.html"}, reads=["--certificate", "--checker"]),
    Row("boundary S.wkt M.json --depth 2", SCENE, {"--surface": "o.vtk", "--cells": "o.vtk", "--points": "o.vtk", "--output": "o"}),
    Row("convert S.wkt", ["S.wkt"], {"--output": "o.wkt", "-o": "o.wkt"}),
    Row("convert M.json", ["M.json"], {"--output": "o.json", "-o": "o.json"}),
    Row("solid ball --diameter 1", [], {"--inside": "o.off", "--outside": "o.off"}),
    Row("solid box --size 1,1,1", [], {"--output": "o.off", "-o": "o.off", "--outside": "o.off"}),
    Row("mend S.off", ["S.off"], {"--output": "o.off", "-o": "o.off"}),
    Row("envelope S.wkt M.json --at 1/2 -n 2", SCENE,
        {"--events": "o", "--curve": "o", "--patches": "o", "--joints": "o", "--points": "o", "--output": "o"}),
    Row("collide S.wkt M.json S.wkt", SCENE, {"--output": "o", "-o": "o"}, reads=["--motion-of-fixed"], ends=1),
    Row("collide", [], {"--output": "o", "-o": "o", "--resume": "o"}, reads=["--list", "--motion-of-fixed"], ends=1),
    Row("outline S.wkt M.json --within 1", SCENE, {"--polygon": "o.wkt"}),
    Row("outline S.wkt M.json", SCENE, {"--arcs": "o", "--samples": "o", "--output": "o", "-o": "o"}),
    Row("outline S.wkt M.json --samples s", SCENE, {"--certify": "o"}),
    Row("judge B.off B.json B.off --within 1 --count 1", ["B.off", "B.json"], {"--vertices": "o.csv", "--answers": "o.csv", "--page": "o.html", "--output": "o"},
        reads=["--points"]),
    Row("motion poses Q.csv", ["Q.csv"], {"--output": "o", "--report": "o"}),
    Row("motion gcode G.nc", ["G.nc"], {"--output": "o", "--report": "o"}),
    Row("motion dyadic M.json", ["M.json"], {"--output": "o", "--report": "o"}),
    Row("motion line --by 1,0,0", [], {"--output": "o", "--report": "o"}),
    Row("motion joints slide:1,0,0", [], {"--output": "o", "--report": "o"}),
    Row("motion rotate --degrees 90 --dimension 2", [], {"--output": "o", "--report": "o"}),
    Row("cases", [], {}, others=["--folder", "--output"]),
]
# Options whose text is none of a file, and short names of others.
TEXTS = {"by", "format", "grid", "box", "at", "strata", "times", "plane", "view", "title", "depth", "coarse", "budget", "contacts", "candidate",
         "degrees", "axis", "center", "pitch", "tolerance", "radius", "affine", "shortest", "long", "slerp", "scale", "from", "to", "every",
         "numbers", "dyadic", "dimension", "folder", "o", "columns", "angles", "diameter", "length", "corner", "taper", "size",
         "near-rotation", "start"}
# Their commands add what they write; the folder of --shrink must be new or empty.
EXTRA = {("validate", "keep"), ("validate", "output"), ("validate", "shrink")}
COLUMNS = {("motion", "--ignore")}
# Commands whose report --output takes, an option of all commands without a row in their table; beside a file it yields to it.
REPORTS = {"check", "explain", "boundary", "envelope", "outline", "judge", "cases"}


class Bench:
    """Runs in folders that have the inputs of all rows."""

    def __init__(self, graze, checks, folder):
        self.graze, self.checks, self.folder = graze, checks, folder
        self.inputs = folder / "inputs"
        self.candidate = f"'{graze}' classify {{solid}} {{motion}} {{points}} --output {{out}}"
        self.inputs.mkdir()
        for name, old in (("S.wkt", "square.wkt"), ("M.json", "move2.json"), ("S.off", "cube.off"), ("B.off", "cube.off"),
                          ("B.json", "move3.json")):
            shutil.copy(COMMON / old, self.inputs / name)
        for name, text in (("P.csv", CSV), ("B.csv", "1,1,1\n"), ("C.csv", SITES), ("L.csv", LIST), ("G.nc", "G0 X0 Y0 Z0\nG1 X1\n"), ("K.html", "<title>graze-check</title>\n"), ("Q.csv", "t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,1,0,0,1,0,0,0\n")):
            (self.inputs / name).write_text(text)
        for words in ("check S.wkt M.json --receipt R", "certify S.wkt M.json P.csv -o C.txt", "classify S.wkt M.json P.csv -o T.csv", "classify S.wkt M.json P.csv -o T2.csv",
                      "classify S.wkt M.json P.csv --shard 1/2 -o 1.csv", "classify S.wkt M.json P.csv --shard 2/2 -o 2.csv"):
            done = self.run(self.inputs, words.split())
            checks.equal(done.returncode, 0, words, done.stderr)
        self.count = 0

    def run(self, at, words, **more):
        return run([self.graze, *words], cwd=at, **more)

    def fresh(self):
        """A folder with the inputs, which may be changed."""
        self.count += 1
        at = self.folder / str(self.count)
        shutil.copytree(self.inputs, at)
        return at

    def refused(self, at, words, names, where, **more):
        """Run; refused, in one line with these names, and nothing has changed."""
        before = contents(at)
        done = self.run(at, words, **more)
        line = done.stderr.splitlines()
        good = (done.returncode == 2 and len(line) == 1 and line[0].endswith("; expected another file")
                and ": is also " in line[0] and all(name in line[0] for name in names) and not done.stdout)
        self.checks.holds(good, where, words, "named", names, done.returncode, done.stderr, done.stdout)
        self.checks.equal(changed(before, contents(at)), [], where, words, "files that changed")
        shutil.rmtree(at)


def contents(folder):
    """Name -> what it is, for all below a folder."""
    found = {}
    for path in sorted(folder.rglob("*")):
        found[str(path.relative_to(folder))] = (os.readlink(path) if path.is_symlink() else None,
                                                path.read_bytes() if path.is_file() else None)
    return found


def changed(before, after):
    return sorted(name for name in before.keys() | after.keys() if before.get(name) != after.get(name))


def given(bench, row):
    """Words of a run of that row."""
    values = {"--receipt": "R", "--solid": "S.wkt", "--motion": "M.json", "--points": "B.csv" if "B.off" in row.read else "P.csv", "--motion-of-fixed": "M.json",
              "--list": "L.csv", "--certificate": "C.txt", "--checker": "K.html"}
    words = list(row.words) + [bench.candidate] * (row.words[-1] == "--candidate")
    return words + [word for option in row.reads for word in (option, values[option])]


def endings(row, option):
    """The endings behind the option's value in the names of the files that it writes."""
    found = ENDINGS.get((row.command, option), [""])
    return found[1:] if "--points" in row.reads and option == "--keep" else found


def join(path, option, row):
    """The option's value for a file to be written at `path`."""
    for ending in endings(row, option):
        if ending and path.endswith(ending):
            return path[:-len(ending)]
    return path


def put_link(kind, at, target, name):
    """Make `name` another name of `target`; the two as a run spells them: (read, written)."""
    (at / name).parent.mkdir(exist_ok=True)
    if kind == "symbolic":
        (at / name).symlink_to(os.path.relpath(at / target, (at / name).parent))
    elif kind == "hard":
        os.link(at / target, at / name)
    else:
        os.rename(at / target, at / name)
        if kind == "linked":
            (at / "link").symlink_to(name)
    return {"same": (name, name), "dots": (name, "./" + name), "linked": ("link", name)}.get(kind, (target, name))


def check_reads(bench, row):
    """Each option to write against each file to read."""
    words = given(bench, row)
    files = [word for k, word in enumerate(words) if word in row.read or k and words[k - 1] in row.reads]
    for (option, value), target in itertools.product(row.writes.items(), files):
        if option == "--output" and row.command in REPORTS - {"check"}:  # one option in the code
            continue
        for ending in endings(row, option):
            for kind in ("same", "dots", "linked", "symbolic", "hard"):
                at = bench.fresh()
                read, written = put_link(kind, at, target, value + ending)
                line = [read if word == target else word for word in words] + [option, join(written, option, row)]
                name = "--output" if option == "-o" else option
                bench.refused(at, line, [f"{name} {written}: ", f" {read}, which is read"], f"{row.command} {option} onto {target}, {kind}")


def put_both(kind, at, first, second):
    """Make two names one file, which is there for links of the kinds of put_link alone; the second as a run spells it."""
    for name in (first, second):
        (at / name).parent.mkdir(exist_ok=True)
    if kind in ("hard", "symbolic"):
        (at / first).write_text("it is there\n")
        put_link(kind, at, first, second)
    if kind == "dangling":
        (at / second).symlink_to(os.path.relpath(at / first, (at / second).parent))
    if kind == "chain":
        (at / "middle").symlink_to(first)
        (at / second).symlink_to(at / "middle")
    return {"dots": "./" + second}.get(kind, second)


def check_writes(bench, row):
    """Each two options to write, onto a new file, and onto one that is there."""
    kinds = {name: value for name, value in row.writes.items() if name != "-o" and not (name == "--output" and row.command in REPORTS - {"check"})}
    for (one, value), (two, other) in itertools.combinations(kinds.items(), 2):
        for ending, last in itertools.product(endings(row, one), endings(row, two)):
            equal = ["same", "dots"] if value + ending == other + last else []
            for kind in equal + ["dangling", "chain", "hard", "symbolic"]:
                at = bench.fresh()
                first, second = "a" + value + ending, ("a" if kind in equal else "b") + other + last
                second = put_both(kind, at, first, second)
                line = given(bench, row) + [one, join(first, one, row), two, join(second, two, row)]
                bench.refused(at, line, [first, second, one, two, ", which is written"], f"{row.command} {one} {two}, {kind}")


def check_good(bench, row):
    """All options to write, each to a file of its own: it runs, and reads what it is to read. Then all to /dev/null."""
    plain = {name: value for name, value in row.writes.items() if name not in ("-o", "--resume")}
    at = bench.fresh()
    before = contents(at)
    line = given(bench, row) + [word for k, (name, value) in enumerate(plain.items()) for word in (name, f"{k}{value}")]
    done = bench.run(at, line)
    after = contents(at)
    bench.checks.equal(done.returncode, row.ends, line, done.stderr)
    bench.checks.equal([name for name in before if before[name] != after[name]], [], line)
    bench.checks.holds(len(after) >= len(before) + len(plain), line, "a file for each option", sorted(after))
    line = given(bench, row)
    for k, (name, value) in enumerate(plain.items()):
        for ending in endings(row, name) if name != "--keep" else []:
            (at / f"null{k}{value}{ending}").symlink_to("/dev/null")
        line += [name, f"null{k}{value}"]
    done = bench.run(at, line)
    bench.checks.equal(done.returncode, row.ends, line, done.stderr)
    shutil.rmtree(at)


def check_standard(bench):
    """Standard input and output that are plain files; pipes; files that are not there."""
    scene = ["classify", "S.wkt", "M.json"]
    at = bench.fresh()
    with open(at / "P.csv", "rb") as held:
        bench.refused(at, [*scene, "-", "--output", "P.csv"], ["--output P.csv", "standard input, which is read"], "redirected", stdin=held)
    for words, name in (("check S.wkt -", "--receipt"), ("motion dyadic -", "--report"), ("classify S.wkt M.json P.csv --receipt -", "-o")):
        at = bench.fresh()  # the file of that name
        shutil.copy(at / ("R" if name == "-o" else "M.json"), at / "-")
        bench.refused(at, [*words.split(), name, "./-"], [" ./-: is also ", "-, which is read"], words)
    for words in ([*scene, "P.csv", "--certify", "both"], ["envelope", "S.wkt", "M.json", "--events", "/dev/stdout"]):
        at = bench.fresh()
        with open(at / "both", "wb") as held:
            done = bench.run(at, words, stdout=held)
        bench.checks.holds(done.returncode == 2 and "standard output: is also --" in done.stderr, words, done.returncode, done.stderr)
        shutil.rmtree(at)
    at = bench.fresh()
    before = contents(at)
    with open(at / "M.json", "ab") as held:
        done = bench.run(at, ["check", "S.wkt", "M.json"], stdout=held)
    bench.checks.holds(done.returncode == 2 and "standard output: is also M.json" in done.stderr, done.returncode, done.stderr)
    bench.checks.equal(contents(at), before)
    with open(at / "o", "wb") as held:
        done = bench.run(at, [*scene, "P.csv", "--output", "o"], stdout=held)
    bench.checks.equal((done.returncode, (at / "o").read_bytes()), (0, (at / "T.csv").read_bytes()), done.stderr)
    for name in ("o", "./-"):
        done = bench.run(at, [*scene, "-", "--output", name], input=CSV)
        bench.checks.equal((done.returncode, (at / name).read_bytes()), (0, (at / "T.csv").read_bytes()), done.stderr)
    done = bench.run(at, ["envelope", "S.wkt", "M.json", "--events", "/dev/stdout"])
    bench.checks.holds(done.returncode == 0 and "time,time_near,kind" in done.stdout, done.stderr)
    os.mkfifo(at / "fifo")
    fifo = os.open(at / "fifo", os.O_RDWR | os.O_NONBLOCK)
    done = bench.run(at, ["envelope", "S.wkt", "M.json", "--events", "fifo", "--patches", "fifo"])
    bench.checks.holds(done.returncode == 0 and os.read(fifo, 1 << 16).count(b"\n") > 2, done.stderr)
    os.close(fifo)
    (at / "round").symlink_to("round")
    for name in ("no/o", "round", "x" * 300, "y" * 5000):
        done = bench.run(at, ["envelope", "S.wkt", "M.json", "--events", name, "--patches", name])
        bench.checks.holds(done.returncode == 5 and "cannot be opened for writing" in done.stderr, name[:20], done.returncode, done.stderr)
    shutil.rmtree(at)


def check_dash(bench, row):
    """`-` is standard output: the bytes of the file, in its form where the name has one, and no file; beside another `-`, and beside
    the product that has no file, it is refused. A report goes to standard error."""
    plain = {name: value for name, value in row.writes.items() if name not in ("--resume", "--keep")}
    if row.command == "validate":  # its report has the time that it took
        plain = {}
    for option, value in plain.items():
        needed = [name for name in plain if name not in (option, "-o") and {name, option} != {"--output", "-o"}
                  and (row.command == "envelope" or name == "--output") and not (name == "--output" and row.command in REPORTS)]
        beside = [word for name in needed for word in (name, name[2:] + plain[name][1:])]
        at = bench.fresh()
        done = bench.run(at, given(bench, row) + beside + [option, "whole" + value[1:]])
        bench.checks.equal(done.returncode, row.ends, row.command, option, done.stderr)
        there, report = (at / ("whole" + value[1:])).read_bytes(), done.stdout
        spelt = [["-"], ["-" + value[1:]]]
        if row.command == "boundary" and option != "--output" or row.command == "draw":  # a surface is PLY, points are CSV, a picture SVG, unless said otherwise
            spelt[0] += ["--format", value[2:]]
        for words in spelt:
            name = words[0]
            before = contents(at)
            done = bench.run(at, given(bench, row) + beside + [option, *words], text=False)
            bench.checks.equal((done.returncode, done.stdout), (row.ends, there), row.command, option, name, done.stderr)
            bench.checks.holds(report.encode() in done.stderr, row.command, option, "the report", done.stderr)
            bench.checks.equal(changed(before, contents(at)), [], row.command, option, name)
        shutil.rmtree(at)
    names = [name for name in plain if name != "-o"]
    for one, two in itertools.combinations(names, 2):
        at = bench.fresh()
        line = given(bench, row) + [one, "-", two, "-"]
        done = bench.run(at, line)
        bench.checks.holds(done.returncode == 2 and done.stderr.endswith("which is written; expected another file\n") and not done.stdout,
                           line, done.returncode, done.stderr)
        shutil.rmtree(at)
    if "--resume" in row.writes:
        for more in (["--resume", "-"], ["--resume", "o", "--certify", "-"])[:2 if "--certify" in plain else 1]:
            at = bench.fresh()
            before = contents(at)
            done = bench.run(at, given(bench, row) + more)
            bench.checks.holds(done.returncode == 2 and "expected their names in place of -" in done.stderr, more, done.returncode, done.stderr)
            bench.checks.equal(changed(before, contents(at)), [], more)
            shutil.rmtree(at)


def check_resume(bench):
    """A table and a certificate are continued; so are both."""
    for row in ROWS:
        if "--resume" not in row.writes:
            continue
        for beside in ([], ["--certify", "certificate"])[:2 if "--certify" in row.writes else 1]:
            at = bench.fresh()
            line = given(bench, row) + beside
            done = bench.run(at, line + ["--resume", "table"])
            bench.checks.equal(done.returncode, row.ends, line, done.stderr)
            whole = contents(at)
            for name in ["table"] + beside[1:]:
                text = (at / name).read_bytes()
                (at / name).write_bytes(text[:text.rindex(b"complete") - 9])
            done = bench.run(at, line + ["--resume", "table"])
            bench.checks.equal(done.returncode, row.ends, line, done.stderr)
            bench.checks.equal(changed(whole, contents(at)), [], line)
            shutil.rmtree(at)
    at = bench.fresh()
    (at / "keep").mkdir()
    shutil.move(at / "P.csv", at / "keep" / "points.csv")
    for points in ("keep/points.csv", "./keep/../keep/points.csv"):
        done = bench.run(at, ["validate", "S.wkt", "M.json", "--candidate", bench.candidate, "--points", points, "--keep", "keep"])
        bench.checks.holds((at / "keep" / "points.csv").read_text() == CSV and done.returncode == 0, points, done.stderr)
    shutil.rmtree(at)


def check_ranks(bench):
    """graze-mpi refuses what graze classify does, and all ranks end."""
    start = machine.ranks(bench.checks, bench.graze, 2)
    if not start:
        return
    for more in (["--output", "P.csv"], ["--output", "o", "--certify", "./o"]):
        at = bench.fresh()
        before = contents(at)
        done = run([*start, "S.wkt", "M.json", "P.csv", *more], 60, cwd=at, env=machine.MPI_ENVIRONMENT)
        bench.checks.holds(done.returncode == 2 and done.stderr.count("expected another file") == 1, more, done.returncode, done.stderr)
        bench.checks.equal(changed(before, contents(at)), [], more)
        shutil.rmtree(at)


def check_rows(bench):
    """Each option that takes a file, by --help and by the tables of options, has a row."""
    commands = re.findall(r"^  graze ([a-z]+) [A-Z]", bench.run(bench.folder, ["--help"]).stdout, re.M)
    commands = sorted({name for name in commands if name.islower()} | {"cases"})
    bench.checks.equal(commands, sorted({row.command for row in ROWS}), "commands with a row")
    for command in commands:
        rows = [row for row in ROWS if row.command == command]
        known = {name for row in rows for name in [*row.writes, *row.reads, *row.others]}
        text = bench.run(bench.folder, [command, "--help"]).stdout
        shown = {(name) for name in re.findall(r"(?<![\w-])(--?[a-z][a-z-]*) (?:FILE|NAME|DIR|FOLDER)\b(?!=)", text)
                 if (command, name) not in COLUMNS}
        if "-o, --output" in text:
            shown |= {"--output"}
        bench.checks.equal(sorted(shown - known), [], command, "options of --help without a row")
        table = pathlib.Path(ROOT, "src", "program", "cli", command + ".c").read_text(encoding="utf-8")
        for macro, rest in (("FILE_WRITTEN", "writes"), ("FILE_READ", "reads")):
            named = {"--" + name for name in re.findall(macro + r'\("([a-z-]+)"', table)}
            named |= {"--output"} if rest == "writes" and re.search(r"\bOUTPUT\(", table) else set()
            wanted = {name for row in rows for name in getattr(row, rest)} - {"-o"} - {"--" + n for c, n in EXTRA if c == command}
            wanted -= {"--output"} if command in REPORTS else set()
            bench.checks.equal(sorted(named), sorted(wanted), command, macro)
        for name in re.findall(r'(?:OPTION|FLAG)\("([a-z-]+)",[^)]*, value_text\)', table):
            bench.checks.holds(name in TEXTS or (command, name) in EXTRA, command, name, "takes a text; is that a file?")


def main():
    args = options(__doc__)
    checks = Checks()
    with tempfile.TemporaryDirectory(prefix="graze-onto-") as folder:
        bench = Bench(args.graze, checks, pathlib.Path(folder).resolve())
        check_rows(bench)
        for row in ROWS:
            check_reads(bench, row)
            check_writes(bench, row)
            if row.writes:
                check_good(bench, row)
                check_dash(bench, row)
        check_standard(bench)
        check_resume(bench)
        check_ranks(bench)
    checks.finish()


if __name__ == "__main__":
    main()
