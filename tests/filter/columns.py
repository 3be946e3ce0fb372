#!/usr/bin/env python3
# suite
"""`classify --columns pmc`: the bytes of the full table without its other answers, in all that reads tables.

SPDX-License-Identifier: GPL-3.0-or-later

The full table is the second method. Its column pmc is held against that of the quick search, with the filter
and without it, on all golden cases, on generated and constructed points of the scenes of adversaries.py, and on
points whose trajectory meets the tip of a hole that rests on an edge. Shards, continued, compared and exported tables of pmc alone
are held to those of a whole run. A scale of 10 makes ten times as many points.
"""
import ast
import os
import random
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", *part.split("/"))
                for part in ("cases", "generate", "agree/lib", "lib")]

import casefile  # noqa: E402
from adversaries import scenes  # noqa: E402
from program import Checks, Graze, options, run  # noqa: E402
from queries import Maker, written  # noqa: E402

SECONDS = 300
POINTS, HEAVY_POINTS = 200, 40
PMC = ["--columns", "pmc"]


def projected(table):
    """The full table with pmc alone."""
    out, drop, at = [], None, None
    for line in table.splitlines(keepends=True):
        if line.startswith("# ends-meet"):
            out.insert(1 + max(k for k, other in enumerate(out) if other.startswith("# round ")), "# columns pmc\n")
        if line.startswith("#"):
            out.append(line)
            continue
        if drop is None:
            at = line.split(",").index("pmc") + 1 if "pmc," in line else 0
            drop = 1 if line.split(",")[at].strip() == "word" else 6
        cells = line.rstrip("\n").split(",")
        out.append(",".join(cells[:at] + cells[at + drop:]) + "\n")
    return "".join(out)


class Columns:
    def __init__(self, args):
        self.args, self.checks = args, Checks()
        self.graze = Graze(args, self.checks)
        self.rows = self.inside = 0

    def run(self, *words):
        done = run([self.args.graze, *words], SECONDS, text=False)
        return done.returncode, done.stdout.decode("latin-1"), done.stderr.decode("latin-1")

    def good(self, *words):
        status, out, error = self.run(*words)
        self.checks.equal(status, 0, *words, error[:300])
        return out

    def same(self, name, *words, free=("", ""), ways=((), ("--no-filter",))):
        """The table of pmc alone, after it was held against the full one. `free`: names of carried columns that the
        full table changes, because it has such answers, and how they stand where they are free."""
        expected = projected(self.good("classify", *words)).replace(*free, 1)
        for flags in ways:
            given = self.good("classify", *words, *PMC, *flags)
            self.checks.equal(given == expected, True, name, *words, *flags,
                              *[f"{a!r} {b!r}" for a, b in zip(given.splitlines(), expected.splitlines()) if a != b][:3])
        self.rows += expected.count("\n")
        self.inside += sum(",in" in line for line in expected.splitlines())
        return expected

    def cases(self):
        for name in self.args.once(casefile.names(), "cases"):
            case = casefile.Case(name)
            scene = case.path(case.solid), case.path("motion.json")
            self.same(name, *scene, case.path("points.csv"), *case.answers)
            self.same(name, *scene, "--grid", "35,19" if case.dimension == 2 else "9,5,8", *case.answers, ways=[()])

    def scenes(self):
        for _, scene in self.args.cycle(scenes(), 1, "scenes"):
            tag = scene.name.replace(", ", "_").replace(" ", "-")
            solid, motion = scene.texts()
            solid = self.graze.write(tag + scene.solid.suffix, solid)
            motion = self.graze.write(tag + ".json", motion)
            count = HEAVY_POINTS if scene.heavy else POINTS
            points = Maker(scene, self.args.random).points(count)
            path = self.graze.write(tag + ".csv", written(scene.d, points))
            self.same(scene.name, solid, motion, path, *scene.flags)
            self.same(scene.name, solid, motion, "--grid", self.sizes(scene.d, 6 if scene.heavy else 10), *scene.flags,
                      ways=[("--jobs", "2")])

    def sizes(self, dimension, most):
        """A grid whose last bricks are not whole ones."""
        each = most if dimension == 3 else 4 * most
        return ",".join(str(self.args.random.randrange(each // 2, each)) for _ in range(dimension))

    def grids(self):
        """Grids whose points lie on planes, edges and vertices of many poses; shards, and tables that go on."""
        case = casefile.Case("bracket")
        scene = case.path(case.solid), case.path("motion.json")
        for size, box in (("17,18,13", "-1,-1,-1,15,15,8"), ("21,10,11", "0,0,0,10,10,10"), ("19,17,18", "1/3,0,1/7,9,8,7")):
            words = (*scene, "--grid", size, "--box", box)
            for operation in ("sweep", "unsweep"):
                whole = self.same("bracket", *words, "--operation", operation, ways=[("--jobs", "1"), ("--jobs", "3")])
        words = ("classify", *words, *PMC, "--operation", "unsweep")
        parts = [os.path.join(os.path.dirname(self.graze.write("x", "")), f"grid-{k}.csv") for k in (1, 2, 3)]
        for k, part in enumerate(parts):
            self.good(*words, "--shard", f"{k + 1}/3", "--output", part)
        self.checks.equal(self.good("merge", *parts) == whole, True, "merged parts of a grid")
        cut = self.graze.write("grid-cut.csv", whole[:len(whole) * 2 // 3])
        self.good(*words, "--resume", cut)
        with open(cut, encoding="latin-1") as file:
            self.checks.equal(file.read() == whole, True, "a continued grid")
        self.same("bracket", *scene, "--grid", "9,10,11")

    def vast(self):
        """A square that grows to [-2e305, 2e305]^2, far beyond a double's reach: of the grid's points, multiples of
        5e305, the centre alone is inside. Of those of a grid over the sweep itself, 7 x 7 are: all but the outermost."""
        solid = self.graze.write("vast.wkt", "POLYGON((-1 -1, 1 -1, 1 1, -1 1, -1 -1))\n")
        motion = self.graze.write("vast.json", '{"dimension": 2, "pieces": [{"t": [0, 1], "transform": '
                                  '{"scale": "(1+t)*1e305"}}]}')
        for box, inside in (("2e306", 1), ("2e305", 49)):
            table = self.same("vast", solid, motion, "--grid", "9,9", f"--box=-{box},-{box},{box},{box}")
            self.checks.equal(table.count(",in\n"), inside, "vast", box)

    def tip_of_a_hole(self):
        """From outside through the tip of a hole, which rests on the outer edge, into the hole: never inside."""
        solid = self.graze.write("hole.wkt", "POLYGON((0 0, 8 0, 8 8, 0 8, 0 0), (4 0, 6 4, 4 6, 2 4, 4 0))\n")
        motion = self.graze.write("hole.json", '{"dimension": 2, "pieces": [{"t": [0, 1], "transform": '
                                  '{"translate": ["t/8", "-2*t"]}}]}')
        lines = ["x,y,note"]
        for k in range(1, 400):
            lines.append(f"{4 * 4000 + k}/4000,{-2 * 8 * k}/4000,through the tip")
            lines.append(f"{4 * 4000 + k + 1}/4000,{-2 * 8 * k}/4000,beside it")
        path = self.graze.write("hole.csv", "\n".join(lines) + "\n")
        rows = [line.split(",") for line in self.same("tip", solid, motion, path).splitlines() if line[0] != "#"][1:]
        self.checks.equal({row[2] for row in rows if row[3] == "through the tip"}, {"on"}, "through the tip")
        self.checks.equal({row[2] for row in rows if row[3] == "beside it"}, {"in"}, "beside the tip")

    def shallow_tip(self):
        """Through the tip of a hole where hole, tip and trajectories are all but parallel to the edge: the time of the crossing
        is uncertain, by the slope and by the distance from the origin."""
        solid = self.graze.write("thin.wkt", "POLYGON((0 1000, 16 1000, 16 1008, 0 1008, 0 1000), (4 1000, 12 256001/256, 12 4096001/4096, 4 1000))\n")
        motion = self.graze.write("thin.json", '{"dimension": 2, "pieces": [{"t": [0, 1], "transform": '
                                  '{"translate": ["-4*t", "-t/2048"]}}]}')
        steps = [k for k in range(1, 1600) if k % 4]
        lines = ["x,y"] + [f"{4 * 1601 - 4 * k}/1601,{1000 * 2048 * 1601 - k}/{2048 * 1601}" for k in steps]
        path = self.graze.write("thin.csv", "\n".join(lines) + "\n")
        rows = [line.split(",") for line in self.same("thin", solid, motion, path).splitlines() if line[0] != "#"][1:]
        self.checks.equal({row[2] for row in rows}, {"on"}, "through a shallow tip")

    def tables(self):
        """Every command that reads tables takes tables of pmc alone; carried columns may have the names of answers."""
        rng = random.Random(7)
        case = casefile.Case("bracket")
        solid, motion = case.path(case.solid), case.path("motion.json")
        numbers = [[str(rng.randrange(-20, 120)) + "/8" for _ in range(3)] for _ in range(300)]
        path = self.graze.write("named.csv", "x,word,y,z,class,i\n" + "".join(
            f"{x},OBIBO,{y},{z},boundary,7\n" for x, y, z in numbers))
        words = ("classify", solid, motion, path, *PMC)
        whole = self.same("named", solid, motion, path, free=("word_in,class_in,i_in\n", "word,class,i\n"))
        folder = os.path.dirname(path)
        parts = []
        for k in (2, 1, 3):
            parts.append(os.path.join(folder, f"part-{k}.csv"))
            self.good(*words, "--shard", f"{k}/3", "--output", parts[-1])
        self.checks.equal(self.good("merge", *parts) == whole, True, "merged parts")
        for _ in range(6):
            cut = os.path.join(folder, "cut.csv")
            with open(cut, "w", encoding="latin-1") as file:
                file.write(whole[:rng.randrange(40, len(whole) - 12)])
            self.good(*words, "--resume", cut)
            with open(cut, encoding="latin-1") as file:
                self.checks.equal(file.read() == whole, True, "a continued table")
        golden = self.graze.write("pmc.csv", whole)
        full = self.graze.write("full.csv", self.good("classify", solid, motion, path))
        for one, other in ((golden, golden), (full, golden)):
            report = self.good("compare", one, other)
            self.checks.equal("| 300 | 300 | 0 | 0 | 0 | 0 |" in report, True, one, other, report[:2000])
        status, _, message = self.run("compare", golden, full)
        self.checks.equal((status, "has no column class" in message), (3, True), "all answers by pmc alone", message)
        wrong = self.graze.write("wrong.csv", whole.replace(",out,", ",in,", 1))
        self.checks.equal(self.run("compare", golden, wrong)[0], 1, "a wrong pmc")
        self.merge_refuses(words, parts, folder)
        for form in ("npy", "vtk"):
            done = run([self.args.graze, *words, "--format", form], SECONDS, text=False)
            self.checks.equal(done.returncode, 0, form)
            if form == "npy":
                self.records(done.stdout, whole)

    def merge_refuses(self, words, parts, folder):
        """A part with all answers among parts of pmc alone, and one whose pmc is no answer."""
        other = os.path.join(folder, "other.csv")
        self.good(*[w for w in words if w not in PMC], "--shard", "3/3", "--output", other)
        status, _, message = self.run("merge", *parts[:2], other)
        self.checks.equal((status, "expected parts of one run" in message), (3, True), "parts of two kinds", message)
        with open(parts[2], encoding="latin-1") as file:
            text = file.read()
        for change in (",in,", ",regular,"), (",out,", ",,"), (",out,OBIBO", ",out"):
            with open(other, "w", encoding="latin-1") as file:
                file.write(text.replace(*change, 1))
            self.checks.equal(self.run("merge", *parts[:2], other)[0], 3, "a damaged part", change)

    def records(self, data, whole):
        """The pmc of a structured array, read by its own head: pmc is a byte behind three doubles, or wider."""
        start = 10 if data[6] == 1 else 12  # the length of the head has 2 bytes, from version 2 on 4
        size = int.from_bytes(data[8:start], "little")
        head = ast.literal_eval(data[start:start + size].decode("latin-1"))
        names = [name for name, _ in head["descr"]]
        self.checks.equal(names, ["x", "y", "z", "pmc", "word", "class", "i"], "columns of the array")
        widths = [int(kind[2:]) * (4 if kind[1] == "U" else 1) for _, kind in head["descr"]]
        at, records = sum(widths[:3]), data[start + size:]
        rows = [line.split(",") for line in whole.splitlines() if line[0] != "#"][1:]
        given = [records[k * sum(widths) + at:][:widths[3]].rstrip(b"\0").decode() for k in range(len(rows))]
        self.checks.equal(given == [row[3] for row in rows], True, "pmc of the array", given[:3])


def main():
    args = options(__doc__.splitlines()[0])
    columns = Columns(args)
    columns.cases()
    columns.scenes()
    if args.derived:
        columns.grids()
        columns.vast()
        columns.tip_of_a_hole()
        columns.shallow_tip()
        columns.tables()
    print(f"{columns.rows} lines both ways, {columns.inside} of points inside")
    columns.checks.equal(columns.inside * 5 > columns.rows, True, "a fifth of the points is inside")
    columns.checks.finish()


if __name__ == "__main__":
    main()
