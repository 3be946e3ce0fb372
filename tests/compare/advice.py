#!/usr/bin/env python3
# suite
"""Notes of compare and validate where a user would be misled: numbers that another program rounded, points that no
double can be, and files that are gone when the report is read.

Rounded tables are made here by Python's own floats; which points are dyadic is seen from the motion.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import shlex
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from harness import Checks, options  # noqa: E402

CUBE = os.path.join(harness.ROOT, "tests", "refuse", "common", "cube.off")
checks = Checks()
check = checks.holds


def run(*command, **more):
    done = harness.run([str(word) for word in command], 60, **more)
    return done.returncode, done.stdout, done.stderr


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def translation(way):
    return json.dumps({"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": way}}]})


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        lines = [line.rstrip("\n").split(",") for line in file if not line.startswith("#")]
    return [dict(zip(lines[0], line)) for line in lines[1:]]


def rounded(graze, folder):
    """A candidate whose coordinates went through doubles and that lacks a row: of the others those with thirds are lost,
    until both tables are rounded or have an id. With as many rows as the golden table it loses none."""
    motion = write(folder, "move.json", translation(["8*t", "0", "0"]))
    points = "x,y,z,id\n" + "".join(f"{k}/{3 if k % 10 else 1},1,1/2,r{k}\n" for k in range(1, 101))
    golden = os.path.join(folder, "golden.csv")
    run(graze, "classify", CUBE, motion, write(folder, "points.csv", points), "--output", golden)
    rows = rows_of(golden)
    exact = sum(F(row["x"]).denominator == 1 for row in rows)
    for digits in ("%.17g", "%r"):
        text = "".join(",".join(digits % to_double(F(row[a])) for a in "xyz") + f",{row['pmc']},{row['id']}\n" for row in rows)
        by_order = write(folder, "all.csv", "x,y,z,pmc,mark\n" + text)
        told = json.loads(run(graze, "compare", golden, by_order, "--format", "json")[1])
        check(told["agree"] == 100 and told["matched-by"] == "order" and told["rows-with-other-coordinates"] == 100 - exact, told)
        by_point = write(folder, "mine.csv", "x,y,z,pmc,mark\n" + text[:-1].rpartition("\n")[0] + "\n")
        status, out, _ = run(graze, "compare", golden, by_point)
        check(status == 1 and f"| 100 | {exact - 1} | 0 | {101 - exact} | 0 | {100 - exact} |" in out, digits, out[:600])
        check("wrong: 0.00 %" not in out and f"\nmissing: {101 - exact} of 100 rows; of the others wrong: 0" in out, out[:600])
        hint = next((line for line in out.splitlines() if line.startswith("hint: ")), "")
        check("look rounded" in hint and "`--round binary64`" in hint and "column `id`" in hint, digits, out[:600])
        told = json.loads(run(graze, "compare", golden, by_point, "--format", "json")[1])["hint"]
        check("hint: " + told == hint, told)
        status, out, _ = run(graze, "compare", golden, by_point, "--round", "binary64")
        check(status == 1 and "| 100 | 99 | 0 | 1 | 0 | 0 |" in out and "hint" not in out, digits, out[:600])
        status, out, _ = run(graze, "compare", golden, write(folder, "id.csv", "x,y,z,pmc,id\n" + text))
        check(status == 0 and "hint" not in out, digits, out[:600])
    # Ten digits: rounding both to doubles does not help, and the report says so.
    text = "".join(",".join("%.10g" % to_double(F(row[a])) for a in "xyz") + f",{row['pmc']}\n" for row in rows[:99])
    out = run(graze, "compare", golden, write(folder, "mine.csv", "x,y,z,pmc\n" + text), "--round", "binary64")[1]
    check("hint: many rows are missing and as many extra, rounded too" in out and "17 digits" in out, out[:600])
    # A few rows that are lost are no hint of rounding, nor are rows that only one table has.
    text = "".join(f"{row['x']},{row['y']},{row['z']},{row['pmc']}\n" for row in rows[:50])
    out = run(graze, "compare", golden, write(folder, "mine.csv", "x,y,z,pmc\n" + text))[1]
    check("hint" not in out and "| 100 | 50 | 0 | 50 | 0 | 0 |" in out, out[:600])
    out = run(graze, "compare", golden, write(folder, "mine.csv", "x,y,z,pmc\n" + text.replace("8/3,1,", "8/3,2,")))[1]
    check("hint" not in out, out[:600])


def candidate_of(graze, *change):
    """A command that answers as Graze does, with these words of sed applied to its rows."""
    line = f'{shlex.quote(graze)} classify "$1" "$2" "$3" | grep -v "^#" | sed {shlex.join(change)} > "$4"'
    return f"sh -c {shlex.quote(line)} sh {{solid}} {{motion}} {{points}} {{out}}"


def strata(graze, folder):
    """A motion by 0.443221, whose contacts are no doubles, and by 7/16, whose contacts are."""
    decimal = write(folder, "decimal.json", translation(["0.443221*t + 0.1", "8*t+1/3", "1/7"]))
    right = candidate_of(graze, "-e", "s/^$//")
    status, out, said = run(graze, "validate", CUBE, decimal, "-n", 300, "--representable", "binary64", "--format", "json",
                            "--candidate", right)
    told = json.loads(out)
    share = {group["value"]: group["rows"] for group in told["comparison"]["by"]["stratum"]}
    check(status == 0 and "graze motion dyadic" in said and "`rounded` has their weight" in told["points"], status, said)
    notes = [line for line in said.splitlines() if "note: " in line]
    kinds = ("no points of the strata ", "`graze motion dyadic` makes", "`rounded` has their weight: ")
    check([sum(f"{decimal}: {kind}" in line for line in notes) for kind in kinds] == [1, 1, 1] and all(";" not in line for line in notes),
          "a line for each", notes)
    for name in ("edge", "vertex", "start", "end"):
        check(name in said.split("have coordinates")[0] and share.get("rounded-" + name, 0) > 5 and name not in share, name, said, share)
    status, out, said = run(graze, "generate", CUBE, decimal, "-n", 300, "--seed", 1, "--representable", "binary64", "--strata",
                            "vertex,edge")
    check(status == 2 and out == "", "named strata are not replaced", status, said)
    status, out, said = run(graze, "validate", CUBE, decimal, "-n", 30, "--representable", "binary64", "--strata",
                            "random,vertex", "--candidate", right)
    check(status == 0 and "\npoints: no points of the strata vertex have coordinates" in out, status, out[:500], said)
    turns = write(folder, "turns.json", '{"dimension": 3, "keyframes": [{"t": 0, "position": ["1/3", "1/7", "1/9"], "quaternion": [7, 1, 0, 2]},'
                  '{"t": 1, "position": ["2/3", "64/7", "1/11"], "quaternion": [7, 5, 3, 0]}]}')
    for words, count in ((("--strata", "random,vertex"), 0), ((), 1)):
        _, out, said = run(graze, "generate", CUBE, turns, "-n", 50, "--seed", 1, "--representable", "binary64", *words)
        check("have coordinates" in said and "motion dyadic" not in said and "`rounded` has" in said, "no dyadic motion turns", said)
        check(("rounded-vertex" in out) == bool(count), words, out)
    dyadic = os.path.join(folder, "dyadic.json")
    run(graze, "motion", "dyadic", decimal, "--output", dyadic)
    for motion in (dyadic, write(folder, "sixteenths.json", translation(["7/16*t", "8*t", "0"]))):
        status, out, said = run(graze, "validate", CUBE, motion, "-n", 300, "--representable", "binary64", "--format", "json",
                                "--candidate", right)
        made = json.loads(out)
        share = {group["value"]: group["rows"] for group in made["comparison"]["by"]["stratum"]}
        check(status == 0 and share["vertex"] > 30 and share["edge"] > 30 and "binary64" not in made["points"], motion, share)


def ratios(graze, folder):
    """A report on points that a reader of floats may misread says so, and no other does."""
    motion, right = write(folder, "third.json", translation(["8*t", "1/3", "0"])), candidate_of(graze, "-e", "s/^$//")
    points = write(folder, "own.csv", "x,y,z\n1/3,1,1\n")
    for words, said in (((), True), (("--coordinates", "exact"), True), (("--coordinates", "decimal", "--digits", 9), False),
                        (("--representable", "binary64"), False), (("--points", points), False)):
        count = () if "--points" in words else ("-n", 20)
        status, out, _ = run(graze, "validate", CUBE, motion, *count, "--candidate", right, *words)
        check(status == 0 and ("\npoints: with ratios such as 1/3" in out) == said, words, status, out[:500])


def gone(graze, folder):
    """Without --keep the report has the rows; with it, files and lines, which are there."""
    motion = write(folder, "move.json", translation(["8*t", "0", "0"]))
    wrong = candidate_of(graze, "-e", "s/,on,/,in,/")
    temporary = os.path.join(folder, "temporary")
    os.mkdir(temporary)
    status, out, _ = run(graze, "validate", CUBE, motion, "-n", 50, "--show", 5, "--candidate", wrong,
                         env={**os.environ, "TMPDIR": temporary})
    check(status == 1 and temporary not in out and "golden.csv" not in out and "line " not in out, out[-1500:])
    blocks = out.split("Rows of the golden table:\n\n")[1].split("\nRows of the candidate:\n\n")
    golden, mine = ([line.strip().split(",") for line in block.strip().splitlines()] for block in blocks)
    check(golden[0][:4] == ["x", "y", "z", "pmc"] and golden[0] == mine[0] and len(golden) == len(mine) == 6, golden, mine)
    for right, given in zip(golden[1:], mine[1:]):
        check(right[3] == "on" and given[3] == "in" and right[:3] == given[:3] and right[4:] == given[4:], right, given)
        word = run(graze, "explain", CUBE, motion, *right[:3])[1].split("Its word is ")[1].split(".")[0]
        check(word == right[golden[0].index("word")], right, word)
    made = json.loads(run(graze, "validate", CUBE, motion, "-n", 50, "--show", 5, "--candidate", wrong, "--format", "json")[1])
    told = made["comparison"]
    check([d["golden-row"].split(",") for d in told["disagreements"]] == golden[1:], told["disagreements"])
    check([d["candidate-row"].split(",") for d in told["disagreements"]] == mine[1:], told["disagreements"])
    check(told["golden-columns"].split(",") == golden[0] and "golden-line" not in told["disagreements"][0], told)
    kept = os.path.join(folder, "kept")
    out = run(graze, "validate", CUBE, motion, "-n", 50, "--show", 5, "--candidate", wrong, "--keep", kept)[1]
    with open(os.path.join(kept, "golden.csv"), encoding="utf-8") as file:
        lines = file.read().splitlines()
    cited = int(out.split("1. line ")[1].split()[0])
    shown = lines[cited - 1].split(",")[:-3]   # but for sdf_low, sdf_high, sdf_t
    check(shown == golden[1] and kept in out and "Rows of" not in out, cited, golden[1])


def left(graze, folder):
    """An {out} that is no file is refused at once, and nothing that a candidate leaves stays."""
    motion = write(folder, "move.json", translation(["8*t", "0", "0"]))
    own, temporary = os.path.join(folder, "own"), os.path.join(folder, "temporary")
    os.mkdir(own)
    write(own, "file", "x")
    right = f'{shlex.quote(graze)} classify "$1" "$2" "$3"'
    unix = f'{shlex.quote(sys.executable)} -c "import socket, sys; socket.socket(socket.AF_UNIX).bind(sys.argv[1])" "$4"'
    no_table = "has written no table to {out}"
    for script, want, says in (('mkfifo "$4"', 3, "has left a FIFO at {out}; expected a file"),
                               ('mkdir -p "$4/a/b"; echo x >"$4/a/c"', 3, "has left a folder at {out}"),
                               (f'ln -s {shlex.quote(own)} "$4"', 3, "has left a folder at {out}"),
                               ('ln -s /dev/zero "$4"', 3, "has left a device at {out}"), (unix, 3, "has left a socket at {out}"),
                               ('ln -s "$4.none" "$4"', 3, no_table), ('ln -s "$4" "$4"', 3, no_table),
                               ('mkdir "$4"; sleep 60', 3, "took more than 1 s"),
                               (f'{right} >"$4.more" && ln -s "$4.more" "$4"; mkdir "$4.parts" && mkfifo "$4.parts/pipe"', 0, "")):
        status, _, said = run(graze, "validate", CUBE, motion, "-n", 20, "--quiet", "--timeout", 1 if "sleep" in script else 60,
                              "--candidate", shlex.join(["sh", "-c", script, "sh"]) + " {solid} {motion} {points} {out}",
                              env={**os.environ, "TMPDIR": temporary})
        check(status == want and says in said and said.count("\n") == (want != 0), script, status, said)
        check(os.listdir(temporary) == [] and os.listdir(own) == ["file"], script, os.listdir(temporary))


NAMES = ["10", "2", "1x", "-3", "09", "9", "a|b<script>", "`x` [y](z)", "-x"]


def markdown(graze, folder):
    """Text of a column or a name is shown in a report and is no mark of Markdown; strata stand in an order that does
    not depend on that of the rows: numbers by value, then texts."""
    motion = write(folder, "move.json", translation(["8*t", "0", "0"]))
    shown = ["-3", "2", "09", "9", "10", "-x", "1x", "\\`x\\` \\[y\\](z)", "a\\|b&lt;script>"]
    for names in (NAMES, NAMES[::-1]):
        points = write(folder, "named.csv", "x,y,z,stratum\n" + "".join(f"{k},1,1,{name}\n" for k, name in enumerate(names)))
        golden, mine = os.path.join(folder, "a|b.csv"), os.path.join(folder, "mine.csv")
        run(graze, "classify", CUBE, motion, points, "--output", golden)
        with open(golden, encoding="utf-8") as file:
            write(folder, "mine.csv", file.read().replace(",in,", ",out,"))
        out = run(graze, "compare", golden, mine)[1]
        check("golden: " + golden.replace("a|b", "a\\|b") + "\n" in out, out[:300])
        table = out[out.index("| stratum |"):].splitlines()[2:]
        check([line.split(" |")[0].removeprefix("| ") for line in table[:len(shown)]] == shown, table[:12])
        check("<script" not in out, out)
    right = f"{graze} classify {{solid}} {{motion}} {{points}} --output {{out}} --limit line=9999999"
    out = run(graze, "validate", CUBE, motion, "-n", 20, "--quiet", "--candidate", shlex.join(["sh", "-c", 'echo `true` >&2; "$0" "$@"']) + " " + right)[1]
    check("\ncommand: ``" in out and "`true`" in out and "<script" not in out, out[:400])


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory() as folder:
        rounded(graze, folder)
        strata(graze, folder)
        ratios(graze, folder)
        gone(graze, folder)
        markdown(graze, folder)
        left(graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
