# suite
"""Codes of the benchmark: cases/benchmark/codes.py with programs made here, and the codes that are installed.

SPDX-License-Identifier: GPL-3.0-or-later

The scene is the unit cube that moves by 4 along x in unit time; 6 points and their answers are derived beside ROWS. A
program of the shell answers right, wrongly, not at all, too late, or ends in every way that the table has a word for.
"""
import argparse
import json
import math
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import ONLY, ROOT, Checks, options, run  # noqa: E402

BENCHMARK = os.path.join(ROOT, "cases", "benchmark")
sys.path.insert(0, BENCHMARK)

import catalogue  # noqa: E402
import codes  # noqa: E402
import oracle  # noqa: E402
import picture  # noqa: E402
from standings import failures, table  # noqa: E402

PROGRAM = os.path.join(BENCHMARK, "codes.py")
CUBE = ("OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n"
        "3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n")
MOTION = '{"dimension": 3, "pieces": [\n{"t": ["0", "1"], "transform": {"translate": ["4*t", "0", "0"]}}\n]}\n'
# The sweep is the box from 0 to (5, 1, 1): a point, its answer, its distance from the box's boundary.
ROWS = [("2.5,0.5,0.5", "in", 0.5), ("0.25,0.5,0.5", "in", 0.25), ("4.875,0.5,0.5", "in", 0.125), ("2,1,0.5", "on", 0),
        ("6,0.5,0.5", "out", 1), ("2,-0.5,0.5", "out", 0.5)]
TURNED = ((0.6, -0.8), (0.8, 0.6))  # rigid
STUB = """case $1 in
right|wrong) echo ran >> "$4"; echo id,pmc > "$3"; k=0; while IFS=, read -r x y z pmc; do k=$((k + 1)); [ $1$k = wrong1 ] && pmc=out; echo $k,$pmc >> "$3"; done < "$5";;
hang) while :; do :; done;;
crash) kill -SEGV $$;;
refuse) echo first; echo no such solid >&2; exit 4;;
silent) ;;
garbage) echo nothing,here > "$3";;
esac
"""
# Mode: what the table says of it.
FAILS = {"hang": "more than 1 s", "crash": "ended by SIGSEGV", "refuse": "status 4: no such solid", "silent": "nothing was written",
         "garbage": "score.py: out.csv: columns nothing,here; expected id or x,y,z, and pmc or sdf"}


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def poses_text(count, rows=((1, 0), (0, 1))):
    lines = ["t," + ",".join(f"m{i}{j}" for i in range(4) for j in range(4))]
    (a, b), (c, d) = rows
    lines += [f"{k / (count - 1)},{a},{b},0,{4 * k / (count - 1)},{c},{d},0,0,0,0,1,0,0,0,0,1" for k in range(count)]
    return "\n".join(lines) + "\n"


def make_scene(folder, name, family="parts", **more):
    made = os.path.join(folder, name)
    os.mkdir(made)
    golden = [f"{point},{pmc},{k},{bound if pmc == 'out' else -bound},{bound if pmc == 'out' else -bound},{bound}"
              for k, (point, pmc, bound) in enumerate(ROWS, 1)]
    facts = {"name": name, "family": family, "count": len(ROWS), "seed": 1, "straight": True, "diagonal": 3 ** 0.5,
             "poses": {"101": {"deviation": 0}, "1001": {"deviation": 0}}} | more
    files = {"solid.off": CUBE, "motion.json": MOTION, "scene.json": json.dumps(facts), "poses-101.csv": poses_text(101),
             "poses-1001.csv": poses_text(1001), "points.csv": "x,y,z,id\n" + "".join(f"{r[0]},{k}\n" for k, r in enumerate(ROWS, 1)),
             "golden.csv": "# graze\nx,y,z,pmc,id,sdf_low,sdf_high,boundary_low\n" + "\n".join(golden) + "\n# complete 6\n"}
    for file, text in files.items():
        write(os.path.join(made, file), text)
    return made


class Bench:
    """The codes module in a folder of its own."""

    def __init__(self, checks, graze, folder):
        self.checks, self.folder = checks, folder
        self.log, truth, stub = (os.path.join(folder, name) for name in ("runs.txt", "truth.txt", "stub.sh"))
        write(truth, "".join(f"{point},{pmc}\n" for point, pmc, _ in ROWS))
        write(stub, STUB)
        self.command = ["/bin/sh", stub, "{parameter}", "{points}", "{out}", self.log, truth]
        self.options = argparse.Namespace(graze=graze, out=folder, limit=1, rows=None, budget=1000)

    def stub(self, *modes, **more):
        return catalogue.Code("stub", [(f"it is {mode}", mode, more.pop("poses", None)) for mode in modes], self.command, **more)

    def lines(self, code, *names):
        with tempfile.TemporaryDirectory() as work:
            return codes.Runner(self.options, work).run([code], names)

    def runs(self):
        with open(self.log, encoding="ascii") as file:
            return len(file.readlines())


def scored(bench):
    """Right and wrong answers, what is kept, and what makes it run again."""
    checks, code = bench.checks, bench.stub("right", "wrong")
    first = bench.lines(code, "one", "two")
    checks.equal([line["levels"]["0"]["in"]["wrong"] for line in first], [0, 0, 1, 1], "wrong answers")
    checks.equal([line["levels"]["0"]["balanced"] for line in first], [0, 0, 1 / 6, 1 / 6], "a third of the in points, no out point")
    checks.equal([(line["scene"], line["setting"]) for line in first],
                 [("one", "it is right"), ("two", "it is right"), ("one", "it is wrong"), ("two", "it is wrong")], "order")
    checks.equal(bench.runs(), 4, "each ran once")
    checks.equal(bench.lines(code, "one", "two"), first, "the second time")
    checks.equal(bench.runs(), 4, "nothing ran again")
    text = table(first) + failures(first)
    checks.holds("| stub | it is wrong | 2 | 16.7 % |" in text and "| stub | it is right | 2 | 0 |" in text, "table", text)
    checks.holds("without a score" not in text, "nothing failed", text)
    with open(os.path.join(bench.folder, "two", "poses-1001.csv"), "a", encoding="ascii") as file:
        file.write("\n")
    bench.lines(code, "one", "two")
    checks.equal(bench.runs(), 4, "a table of poses that the code does not read")
    with open(os.path.join(bench.folder, "two", "golden.csv"), "a", encoding="ascii") as file:
        file.write("# more\n")
    bench.lines(code, "one", "two")
    checks.equal(bench.runs(), 6, "another golden table: both settings ran again on one scene")


def shortened(bench):
    """The first rows alone: 4 points, `in` three times and `on`, so that no rate of `out` points is known."""
    bench.options.rows = 4
    line, = bench.lines(bench.stub("right"), "one")
    bench.options.rows = None
    level = line["levels"]["0"]
    bench.checks.equal((line["points"], level["in"]["points"], level["out"]["points"]), (4, 3, 0), "four rows")
    bench.checks.equal((line["missing"], line["extra"]), (0, 2), "the stub answers six all the same")
    bench.checks.equal(table([line]).splitlines()[4].split(" | ")[3:5], ["–", "–"], "no rate")


def failing(bench):
    checks = bench.checks
    found = {line["setting"][len("it is "):]: line for line in bench.lines(bench.stub(*FAILS, "right"), "one")}
    for mode, reason in FAILS.items():
        checks.equal(found[mode].get("failure"), reason, mode)
    lines = list(found.values())
    text = failures(lines)
    for mode, reason in FAILS.items():
        checks.holds(f"| stub | it is {mode} | {reason} | one |" in text, "table of failures", mode, text)
    checks.holds("| stub | it is crash | 0 of 1 | – | – | – | – |" in table(lines), "no figure", table(lines))
    two = [*lines, *bench.lines(bench.stub("right"), "two")]
    checks.holds("| stub | it is right | 2 | 0 |" in table(two), "scenes are counted", table(two))
    gone = bench.stub("right", installed="/nonexistent/code.h")
    checks.equal(bench.lines(gone, "one"), [], "a code that is not there")
    checks.equal([line["failure"] for line in bench.lines(bench.stub("right", lacks=catalogue.not_straight), "one", "bent")
                  if "failure" in line], ["the motion is not straight"], "straight alone")
    checks.equal([line.get("failure") for line in bench.lines(bench.stub("right", lacks=catalogue.not_rigid), "one", "turned", "grown")],
                 [None, None, "the motion is not rigid"], "rigid alone")


def with_poses(bench):
    """A code that reads poses is scored so: all points are within this deviation but the one at 1."""
    line, = bench.lines(bench.stub("wrong", poses="101"), "far")
    bench.checks.equal((line["poses"], line["not_scored"], line["levels"]["0"]["out"]["points"]), ("101", 4, 1), "deviation")


def real(bench, names):
    """Each installed code on the cube: every point within the code's reach is right."""
    bench.options.limit = 60
    for code in catalogue.CODES:
        if code.name not in names:
            continue
        if not code.there():  # no test needs these packages
            continue
        code.settings = code.settings[:1]
        line, = bench.lines(code, "one")
        if bench.checks.holds("failure" not in line, code.name, line):
            bench.checks.equal([line["levels"]["0"][pmc]["wrong"] for pmc in ("in", "out")], [0, 0], code.name, line["problems"])
            bench.checks.holds(line["version"] and line["seconds"] >= 0, code.name, "version and seconds", line)
            if code.name in ("minkowski", "graze"):
                bench.checks.equal(line["on"]["on"], 1, code.name, "on")


def pictured(checks, folder):
    """The marks of a line: over scenes, wrong ones of each power of ten; a gap below 20 points; what is nearest at the left end."""
    def line(setting, *decades):
        return {"code": "a", "setting": setting, "decades": [dict(zip(("from", "points", "wrong"), d)) for d in decades]}

    path = os.path.join(folder, "picture.jsonl")
    lines = [line("x", (0, 30, 3), (1e-3, 10, 10)), {"code": "a", "setting": "x", "failure": "late"}, line("y", (1e-2, 20, 0)),
             line("x", (1e-3, 30, 0), (1e-2, 19, 1))]
    write(path, "".join(json.dumps(x) + "\n" for x in lines))
    groups = picture.by_code(path)
    checks.equal({key: len(found) for key, found in groups.items()}, {("a", "x"): 2, ("a", "y"): 1}, "picture", "lines")
    marks = picture.shares(groups["a", "x"])
    checks.equal([at for at, _ in marks], [picture.NEAREST, 1e-3, 1e-2], "picture", "powers of ten")
    checks.equal([share for _, share in marks[:2]], [0.1, 0.25], "picture", "shares")
    checks.holds(math.isnan(marks[2][1]), "picture", "a gap", marks)
    checks.equal(picture.shares(groups["a", "y"]), [(1e-2, 0)], "picture", "no error")


def command_line(checks):
    for arguments, status, said in ((["--list"], 0, "openvdb:1\t101 poses"), ([], 2, "expected OUT"), (["--limit", "0", "x"], 2, "from 1 up"),
                                    (["x", "--codes", "none"], 3, "--codes: none; expected some of --list"),
                                    (["x", "--codes", "graze:2"], 3, "--codes: graze:2; expected some of --list"),
                                    (["/nonexistent", "--rows", "1", "name"], 3, "/nonexistent")):
        done = run([sys.executable, PROGRAM, *arguments])
        checks.equal(done.returncode, status, arguments, done.stderr)
        checks.holds(said in (done.stdout if status == 0 else done.stderr), arguments, said, done.stderr)


def main():
    args = options(__doc__, ONLY)
    checks = Checks()
    command_line(checks)
    with tempfile.TemporaryDirectory() as folder:
        for name in ("one", "two"):
            make_scene(folder, name)
        make_scene(folder, "bent", straight=False)
        make_scene(folder, "far", poses={"101": {"deviation": 0.5}})
        for name, rows in (("turned", TURNED), ("grown", ((1.5, 0), (0, 1)))):
            write(os.path.join(make_scene(folder, name), "poses-101.csv"), poses_text(101, rows))
        bench = Bench(checks, args.graze, folder)
        pictured(checks, folder)
        scored(bench)
        shortened(bench)
        failing(bench)
        with_poses(bench)
        os.makedirs(os.path.join(folder, "programs"), exist_ok=True)
        oracle.stand_in(os.path.join(folder, "programs", "minkowski"), "benchmark/codes", "minkowski")
        names = ["sampled", "sampled_sdf", "ei_double", "graze", "openscad", "openvdb", "minkowski"]
        real(bench, [name for name in names if args.only in name])
    checks.finish()


if __name__ == "__main__":
    main()
