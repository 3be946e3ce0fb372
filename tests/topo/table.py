#!/usr/bin/env python3
# suite
"""`classify --topo` and `explain --topo`: the column in tables, shards, continued and exported tables, and where it is refused.

SPDX-License-Identifier: GPL-3.0-or-later

Rows without --topo are those with it less the last column; parts merge to the table of one run.
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

from program import Checks, Graze, options, run  # noqa: E402
from harness import without_leaks  # noqa: E402

EXAMPLES = os.path.join(HERE, "..", "examples")
# Example 49 and points about it: in, out, the seam, a corner.
CUBE = os.path.join(EXAMPLES, "solids", "c2.off"), os.path.join(EXAMPLES, "motions", "seam_ends_3.json")
# Examples 17b, 7 and points about them, with the answers' last column.
SQUARE = os.path.join(EXAMPLES, "solids", "q2.wkt"), os.path.join(EXAMPLES, "motions", "seam_ends.json")
ROWS = [("4", "1", "interior"), ("0", "1", "boundary"), ("1", "1", "interior"), ("40", "1", "exterior"),
        ("4", "0", "boundary"), ("4", "1/3", "interior"), ("0", "0", "boundary")]


def rows_of(text):
    return [line for line in text.splitlines() if not line.startswith("#")]


def check_table(checks, graze, points):
    plain = graze.call("classify", *SQUARE, points, "--quiet")
    topo = graze.call("classify", *SQUARE, points, "--quiet", "--topo")
    loud = graze.call("classify", *SQUARE, points, "--topo")
    checks.equal(topo.stderr, "", "--quiet: notes")
    checks.equal((loud.stdout, loud.stderr), (topo.stdout, ""), "no note of no row")
    checks.equal(topo.returncode, 0, topo.stderr)
    checks.equal([line.rsplit(",", 1)[0] for line in rows_of(topo.stdout)], rows_of(plain.stdout), "rows")
    checks.equal([line.rsplit(",", 1)[1] for line in rows_of(topo.stdout)], ["topo"] + [r[2] for r in ROWS])
    checks.equal(topo.stdout.splitlines()[-2:], ["# undecided 0", f"# complete {len(ROWS)}"])
    checks.holds("# topo yes" in topo.stdout and "topo" not in plain.stdout, "the head")
    checks.equal(plain.stderr, "", "nothing is said without --topo")
    return topo.stdout


def check_parts(checks, graze, points, whole):
    parts = []
    for k in range(3):
        out = graze.call("classify", *SQUARE, points, "--quiet", "--topo", "--shard", f"{k + 1}/3")
        parts.append(graze.write(f"part-{k}.csv", out.stdout))
    merged = graze.call("merge", "--quiet", *parts)
    checks.equal(merged.stdout, whole, "merged", merged.stderr)
    lines = whole.splitlines(keepends=True)
    begun = graze.write("begun.csv", "".join(lines[:-4]) + lines[-4][:3])
    ended = graze.call("classify", *SQUARE, points, "--quiet", "--topo", "--resume", begun)
    with open(begun, encoding="utf-8") as f:
        checks.equal(f.read(), whole, "continued", ended.stderr)
    other = graze.write("other.csv", "".join(lines[:-4]))
    refused = graze.call("classify", *SQUARE, points, "--quiet", "--resume", other)
    checks.equal(refused.returncode, 3, "a table with positions is not continued without")


def check_forged(checks, graze, points):
    """merge and --resume refuse a row whose position does not go with pmc."""
    parts = []
    for k in range(2):
        text = graze.call("classify", *SQUARE, points, "--quiet", "--topo", "--shard", f"{k + 1}/2").stdout
        parts.append(graze.write(f"forged-{k}.csv", text.replace("p2,interior", "p2,boundary")))
    refused = graze.call("merge", "--quiet", *parts)
    checks.equal(refused.returncode, 3, "a forged position", refused.stderr)
    checks.holds("forged-0.csv: was changed" in refused.stderr, refused.stderr)


def check_undecided(checks, graze):
    """Example 54 is undecided in space; a point far away is not."""
    roofs = os.path.join(EXAMPLES, "solids", "crossed_roofs.off"), os.path.join(EXAMPLES, "motions", "roofs_54.json")
    points = graze.write("roofs.csv", "0,0,0\n90,0,0\n0,0,0\n")
    flags = ("--topo",)
    out = graze.call("classify", *roofs, points, *flags)
    checks.equal([line.rsplit(",", 1)[1] for line in rows_of(out.stdout)[1:]],
                 ["undecided", "exterior", "undecided"])
    checks.equal(out.stdout.splitlines()[-2:], ["# undecided 2", "# complete 3"])
    checks.holds("the position of 2 of 3 rows is undecided" in out.stderr, out.stderr)
    lines = graze.call("classify", *roofs, points, *flags, "--format", "jsonl")
    checks.equal(lines.stdout.count('"topo":"undecided","topo_reason":"'), 2)
    checks.holds("the position of 2 of 3 rows is undecided" in lines.stderr, lines.stderr)
    parts = [graze.write(f"roofs-{k}.csv", graze.call("classify", *roofs, points, *flags, "--shard",
                                                      f"{k + 1}/2").stdout) for k in range(2)]
    checks.equal(graze.call("merge", "--quiet", *parts).stdout, out.stdout, "merged counts")
    begun = graze.write("roofs-begun.csv", "".join(out.stdout.splitlines(keepends=True)[:-3]))
    graze.call("classify", *roofs, points, *flags, "--resume", begun)
    with open(begun, encoding="utf-8") as f:
        checks.equal(f.read(), out.stdout, "continued counts")


def check_explain(checks, graze):
    """`explain` on examples 7, 17b and 54."""
    said = graze.call("explain", *SQUARE, "0", "1", "--topo").stdout
    checks.holds("it is `boundary`, by level `first_order`." in said and "A point that is out: (" in said, said)
    said = graze.call("explain", *SQUARE, "4", "1", "--topo").stdout
    checks.holds("it is `interior`, by level `closed_cones`." in said and "that is out" not in said, said)
    checks.holds("That is, closed cones that contacts cover exactly fill all directions about P" in said, said)
    roofs = os.path.join(EXAMPLES, "solids", "crossed_roofs.off"), os.path.join(EXAMPLES, "motions", "roofs_54.json")
    said = graze.call("explain", *roofs, "0", "0", "0", "--topo").stdout
    checks.holds("it is undecided: to first order the contacts close" in said, said)
    checks.holds("are covered, except some in the plane" in said and "in the plane dz = 0:" in said, said)
    checks.holds("; it closes dz < 0\n" in said and "; it closes dz > 0\n" in said, "both roofs", said)
    checks.holds("That is a hint, no verdict." in said, said)
    checks.holds("closed set" not in graze.call("explain", *SQUARE, "4", "1").stdout, "nothing without --topo")


def check_closings(checks, graze):
    """The part that each contact covers, in worked examples: half-planes of sides, three quarters of a reflex corner, a pinch's
    two sides; the body moves, so that what is inside at c(t) is seen about P. Over the end of a piece a contact is told
    for each."""
    def said(solid, motion, point):
        files = os.path.join(EXAMPLES, "solids", solid), os.path.join(EXAMPLES, "motions", motion + ".json")
        text = graze.call("explain", *files, *point.split(), "--topo").stdout
        return [line.strip() for line in text.partition("that each covers to first order:\n")[2].splitlines()]
    checks.equal(said("q2.wkt", "seam_ends", "4 1")[:3],
                 ["at t = 1 and before, edge: dx <= 0", "at t = 1 and after, edge: dx <= 0",
                  "at t = 4 and before, edge: dx >= 0"], "17b")
    checks.equal(said("ll.wkt", "notch", "2 2")[0],
                 "at t = 1 and before, corner: counter-clockwise from (0, 1) to (1, 0)", "26")
    checks.equal(said("dd.wkt", "diagonal_up", "0 0")[0], "at t = 1/2, corner: all directions", "19")
    checks.equal(said("c2.off", "seam_ends_3", "4 1 1")[0], "at t = 1 and before, facet: dx <= 0", "49")
    checks.holds(any(line.startswith("at an irrational t between ") for line in said("dd.wkt", "pinch_sqrt2", "0 0")), "31")
    checks.equal(graze.call("explain", *SQUARE, "1", "1", "--topo").stdout.count("first order"), 0, "a point that is in")


def check_others(checks, graze, points):
    for form in ("vtk", "npy"):
        out = graze.write("export." + form, "")
        made = graze.call("classify", *SQUARE, points, "--quiet", "--topo", "--format", form, "--output", out)
        checks.equal(made.returncode, 0, form, made.stderr)
        with open(out, "rb") as f:
            checks.holds(b"topo" in f.read(), form, "has the column")
    named = graze.write("named.csv", "x,y,topo\n4,1,a\n")
    carried = graze.call("classify", *SQUARE, named, "--quiet", "--topo")
    names = rows_of(carried.stdout)[0].split(",")
    checks.equal((carried.returncode, names[-2:]), (0, ["topo_in", "topo"]), carried.stderr)
    checks.equal(graze.call("classify", *SQUARE, named, "--quiet").returncode, 0, "without --topo")
    unsweep = graze.call("classify", *SQUARE, points, "--quiet", "--topo", "--operation", "unsweep")
    of_pmc = {"in": "interior", "on": "boundary", "out": "exterior"}
    for line in rows_of(unsweep.stdout)[1:]:
        fields = line.split(",")
        checks.equal(fields[-1], of_pmc[fields[2]], line)
    space = graze.call("classify", *CUBE, graze.write("cube.csv", "4,1,1\n9,9,9\n"), "--quiet", "--topo")
    checks.equal(rows_of(space.stdout)[2].split(",")[-1], "exterior", space.stderr)


def check_checker(checks, graze, points):
    checker = os.path.join(os.path.dirname(graze.path), "graze-check")
    certificate, motion = graze.write("certificate.txt", ""), graze.write("plain.json", "")
    graze.call("convert", SQUARE[1], "-o", motion)
    whole = graze.call("classify", SQUARE[0], motion, points, "--quiet", "--topo").stdout
    graze.call("certify", SQUARE[0], motion, points, "-o", certificate)
    said = run([checker, SQUARE[0], motion, certificate, graze.write("whole.csv", whole)], env=without_leaks())
    checks.equal(said.returncode, 0, "graze-check takes the table", said.stdout, said.stderr)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    points = graze.write("points.csv", "x,y,id\n" + "".join(f"{x},{y},p{k}\n" for k, (x, y, _) in enumerate(ROWS)))
    whole = check_table(checks, graze, points)
    check_parts(checks, graze, points, whole)
    check_forged(checks, graze, points)
    check_undecided(checks, graze)
    check_explain(checks, graze)
    check_closings(checks, graze)
    check_others(checks, graze, points)
    check_checker(checks, graze, points)
    checks.finish()


if __name__ == "__main__":
    main()
