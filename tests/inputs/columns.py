#!/usr/bin/env python3
# suite
"""Columns of a table used as points: answers of a table that Graze has written are not carried along, and no table has
two columns of one name.

A golden table classified again is itself, whole, continued, in shards, by ranks and in every form; a user's column that
has the name of an answer comes out under another one. SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import os
import pathlib
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import Checks, options, run  # noqa: E402
from machine import MPI_ENVIRONMENT, ranks  # noqa: E402

COMMON = pathlib.Path(__file__).resolve().parents[1] / "refuse" / "common"
SPACE = COMMON / "cube.off", COMMON / "move3.json"
PLANE = COMMON / "square.wkt", COMMON / "move2.json"
ANSWERS = ["pmc", "class", "definition", "case", "i", "t", "word"]
checks = Checks()
check = checks.holds


def call(graze, *words, stdin=None):
    done = run([graze, *map(str, words)], 120, stdin=stdin)
    check(done.returncode == 0, words, done.stderr)
    return done.stdout, done.stderr


def table(text):
    """(names, rows) without the `#` lines."""
    rows = list(csv.reader(line for line in text.splitlines() if not line.startswith("#")))
    return rows[0], rows[1:]


def again(graze, folder, scene, options_):
    """A table as points gives the same table."""
    d = 3 if scene is SPACE else 2
    points, golden = folder / "points.csv", folder / "golden.csv"
    points.write_text(",".join("xyz"[:d]) + ',note,"a, b"\n' + "".join(
        ",".join(f"{k * (i + 2) % 11}/2" for i in range(d)) + f',n{k},"{k}, ""{k}"""\n' for k in range(60)))
    golden.write_text(call(graze, "classify", *scene, points, *options_)[0])
    out, said = call(graze, "classify", *scene, golden, *options_)
    check(out == golden.read_text(), scene, options_, "the same table again", out[-300:])
    check("carried as" not in said, said)
    names = table(out)[0]
    check(names[:d] + ["note", "a, b"] == names[:d] + [n for n in names[d:] if n not in [*ANSWERS, "topo", "regular"]], names)
    return golden


def forms(graze, folder, golden):
    """The table is the same in parts, continued after an end, by ranks, and as JSON Lines, VTK and npy."""
    whole = golden.read_text()
    parts = [folder / f"part{k}.csv" for k in (1, 2, 3)]
    for k, part in enumerate(parts, 1):
        call(graze, "classify", *SPACE, golden, "--shard", f"{k}/3", "--output", part)
    merged = folder / "merged.csv"
    call(graze, "merge", *parts, "--output", merged)
    check(merged.read_text() == whole, "merged")
    lines = whole.splitlines(keepends=True)
    cut = folder / "cut.csv"
    cut.write_text("".join(lines[:-20]))
    call(graze, "classify", *SPACE, golden, "--resume", cut)
    check(cut.read_text() == whole, "continued")
    for form in ("jsonl", "vtk", "npy"):
        made = [run([graze, "classify", *map(str, SPACE), str(path), "--format", form], 120, text=False).stdout
                for path in (folder / "points.csv", golden)]
        check(made[0] == made[1] and made[0], form)
    started = ranks(checks, graze, 3)
    if started:
        done = run([*started, *SPACE, golden], 300, env=MPI_ENVIRONMENT)
        check(done.stdout == whole, "by ranks", done.stderr)


def named(graze, folder, text, options_=()):
    """(names, rows, what is said) of points with these columns."""
    path = folder / "named.csv"
    path.write_text(text)
    out, said = call(graze, "classify", *PLANE, path, *options_)
    names, rows = table(out)
    check(len(set(names)) == len(names), "two columns of one name", names)
    return names, rows, said


def clashes(graze, folder):
    names, rows, said = named(graze, folder, "t,x,y,pmc\n7,1,3,mine\n")
    check(names == ["x", "y", *ANSWERS, "t_in", "pmc_in"] and rows[0][-2:] == ["7", "mine"], names, rows)
    check("the column `t` is carried as `t_in`" in said and "`pmc_in`" in said, said)
    names, rows, _ = named(graze, folder, 'x,y,t_in,"t",t_in_in_in\n1,3,a,b,c\n')
    check(names[9:] == ["t_in", "t_in_in", "t_in_in_in"] and rows[0][9:] == list("abc"), names, rows)
    names, rows, _ = named(graze, folder, 'x,y,"t",t_in,t_in_in\n1,3,a,b,c\n')
    check(names[9:] == ["t_in_in_in", "t_in", "t_in_in"] and rows[0][9:] == list("abc"), names, rows)
    names, _, said = named(graze, folder, "x,y,class\n1,3,a\n", ["--operation", "unsweep"])
    check(names == ["x", "y", "pmc", "word", "class"] and "carried as" not in said, names, said)
    names, rows, said = named(graze, folder, "x,y,topo,n\n1,3,a,b\n", ["--topo"])
    check(names == ["x", "y", *ANSWERS, "topo_in", "n", "topo"] and rows[0][9:11] == ["a", "b"], names, rows)
    # Below a head of Graze only columns that Graze writes with that head are its answers; others are the user's.
    for head, answers in (("operation unsweep", "pmc,word"), ("columns pmc", "pmc")):
        given = f"# graze 0.1.0\n# {head}\nx,y,{answers},class\n1,3,{answers},mine\n"
        names, rows, _ = named(graze, folder, given, ["--operation", "unsweep"])
        check(names == ["x", "y", "pmc", "word", "class"] and rows[0][4] == "mine", names, rows)
    names, rows, _ = named(graze, folder, "# graze 0.1.0\nx,y,note,t\n1,3,n,mine\n")
    check(names[9:] == ["note", "t_in"] and rows[0][9:] == ["n", "mine"], names, rows)
    names, rows, _ = named(graze, folder, "# another program\nx,y,pmc\n1,3,mine\n")
    check(names[9:] == ["pmc_in"] and rows[0][9:] == ["mine"], names, rows)


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory(prefix="graze-columns-") as name:
        folder = pathlib.Path(name)
        for scene in (PLANE, SPACE):
            for options_ in ([], ["--columns", "pmc"], ["--topo"], ["--operation", "unsweep"],
                             ["--operation", "unsweep", "--topo", "--regular"], ["--folds", "combined"]):
                golden = again(graze, folder, scene, options_)
        forms(graze, folder, again(graze, folder, SPACE, []))
        clashes(graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
