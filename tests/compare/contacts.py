#!/usr/bin/env python3
"""# suite: graze compare on tables of graze contact.

The tables are those of two scenes, moved points and rows without a contact among them. Candidates are made of them by one
change each, in every column, and the report must have that change and no other; then by many changes at random, in any order
of rows, and every figure is counted again here.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import random
import shlex
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from exact import Fraction, to_double  # noqa: E402
from harness import Checks, options  # noqa: E402

CASES = os.path.join(harness.ROOT, "cases", "candidates")
SCENES = [("ell.off", "arch.json"), ("plate.wkt", "shear.json")]
# Two answers of each column, so that one of them is not the row's.
OTHERS = {"cell": ("face 77", "edge 70-77"), "role": ("egress", "hidden"), "theta": ("+", "-"), "contact_order": ("3", "inf"),
          "orientation": ("reversing", "degenerate"), "left": ("I", "O"), "right": ("I", "O"), "trimmed": ("yes", "no"),
          "status": ("meets", "trimmed_far"), "near": ("1/7", "root(-1 0 7;0;1)"), "near_in": ("3/7", "root(-1 0 7;0;1)"),
          "word": ("OBIBOBIBOBIBO", "BIB"), "shift": ("1/99", "2")}
checks = Checks()
check = checks.holds


class Table:
    """A golden table: its file, its names, and rows as dicts with their line in `#`."""

    def __init__(self, path):
        self.path, self.rows, self.names = path, [], None
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                if line.startswith("#"):
                    continue
                cells = line.rstrip("\n").split(",")
                if self.names is None:
                    self.names = cells
                    self.judged = [n for n in cells if n in OTHERS]
                    self.key = [n for n in ("time", "bx", "by", "bz") if n in cells]
                else:
                    self.rows.append(dict(zip(self.names, cells), **{"#": number}))


class Runs:
    """Runs of graze in a folder."""

    def __init__(self, graze, folder):
        self.graze, self.candidate = graze, os.path.join(folder, "candidate.csv")

    def write(self, names, rows):
        with open(self.candidate, "w", encoding="utf-8") as file:
            file.write(",".join(names) + "\n")
            for number, row in enumerate(rows, 2):
                row["at"] = number
                file.write(",".join(row[n] for n in names) + "\n")

    def report(self, golden, *more):
        """The status and the report, or what was said."""
        done = harness.run([self.graze, "compare", golden.path, self.candidate, "--format", "json", *more], 60)
        return done.returncode, json.loads(done.stdout) if done.returncode < 2 else done.stderr


def without_id(path):
    """Contact points without the id by which their rows would be matched."""
    with open(path, encoding="utf-8") as file:
        lines = [line.split(",") for line in file if not line.startswith("#")]
    if "id" in lines[0]:
        at = lines[0].index("id")
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(",".join(line[:at] + line[at + 1:]) for line in lines)


def make(graze, folder, scene):
    """Contact points of a scene, moved and by chance, with and without contact."""
    solid, motion = (os.path.join(CASES, f) for f in scene)
    made, golden = (os.path.join(folder, scene[0] + end) for end in (".points", ".csv"))
    strata = "face=2,edge=2,vertex=1,start=1,end=1,break=1,slide=1"
    for command in (["generate", solid, motion, "-n", "70", "--strata", strata, "--seed", "3", "--representable", "binary64",
                     "--quiet", "-o", made], ["contact", solid, motion, made, "--snap", "--quiet", "-o", golden]):
        done = harness.run([graze, *command], 60)
        check(done.returncode == 0, command, done.stderr)
        without_id(made)
    return distinct(golden)


def distinct(path):
    """The table without rows whose key an earlier one has."""
    table, seen = Table(path), set()
    with open(path, encoding="utf-8") as file:
        lines = file.readlines()
    for row in table.rows:
        key = tuple(row[n] for n in table.key)
        if key in seen:
            lines[row["#"] - 1] = ""
        seen.add(key)
    with open(path, "w", encoding="utf-8") as file:
        file.write("".join(lines[:-1]) + f"# complete {len(seen)}\n")
    return Table(path)


def copies(rows):
    return [dict(row) for row in rows]


def another(row, column):
    return next(v for v in OTHERS[column] if v != row[column])


def one_change(runs, golden, column, index, value):
    """One answer is another: wrong in this column and row alone, and shown with both lines and answers."""
    rows = copies(golden.rows)
    changed = rows[index]
    random.Random(index).shuffle(rows)
    was, changed[column] = changed[column], value
    runs.write(golden.names, rows)
    status, told = runs.report(golden)
    want = {name: int(name == column) for name in golden.judged}
    if not check(status == 1 and told["wrong-by-column"] == want, column, value, status, told if status > 1 else ""):
        return
    counts = [told[k] for k in ("agree", "wrong", "missing", "extra")]
    check(counts == [len(rows) - 1, 1, 0, 0], column, counts)
    [found] = told["disagreements"]
    check((found["golden-line"], found["candidate-line"]) == (changed["#"], changed["at"]), column, found)
    check(f"{column}={was}" in found["golden"] and f"{column}={value}" in found["candidate"], column, found)
    for grouping in ("status", "role"):
        name = golden.rows[index][grouping]
        groups = {g["value"]: g["wrong"] for g in told["by"][grouping] if g["wrong"]}
        check(groups == {name: 1}, column, grouping, groups)


def each_column(runs, golden, chance):
    for column in golden.judged:
        answered = [k for k, row in enumerate(golden.rows) if row[column]]
        empty = [k for k, row in enumerate(golden.rows) if not row[column]]
        for index in chance.sample(answered, 2):
            one_change(runs, golden, column, index, another(golden.rows[index], column))
        one_change(runs, golden, column, chance.choice(answered), "")  # no answer
        if empty:
            one_change(runs, golden, column, chance.choice(empty), OTHERS[column][0])
        runs.write(golden.key + [column], copies(golden.rows))
        status, told = runs.report(golden)
        check(status == 0 and list(told["wrong-by-column"]) == [column] and
              told["not-in-candidate"] == [n for n in golden.judged if n != column], column, status, told)


def other_forms(runs, golden):
    """Numbers in other forms are the same; keys may be the point in the world."""
    rows = copies(golden.rows)
    for row in rows:
        for name in golden.names:
            if row[name] and name in golden.key + ["near", "near_in", "shift"] and not row[name].startswith("root"):
                value = Fraction(row[name])
                row[name] = f"{value.numerator * 6}/{value.denominator * 6}" if value != int(value) else f"+{int(value)}.0e0" \
                    if value >= 0 else f"{int(value)}.0"
    runs.write(golden.names, rows)
    status, told = runs.report(golden)
    check(status == 0 and told["agree"] == len(rows), "other forms", told)
    world = ["time"] + [n for n in ("x", "y", "z") if n in golden.names]
    runs.write(world + ["trimmed", "role"], copies(golden.rows)[::-1])
    status, told = runs.report(golden)
    check(status == 0 and told["matched-by"] == world and list(told["wrong-by-column"]) == ["role", "trimmed"], "world", told)


def columns_of_one(runs, golden, folder):
    """Columns that one table lacks are named, in both reports, and not judged."""
    other = os.path.join(folder, "lacking.csv")
    kept = [n for n in golden.names if n not in ("shift", "near", "left")]
    with open(other, "w", encoding="utf-8") as file:
        file.write("\n".join([",".join(kept), *(",".join(r[n] for n in kept) for r in golden.rows), f"# complete {len(golden.rows)}"])
                   + "\n")
    lacking = Table(other)
    runs.write([n for n in golden.names if n not in ("theta", "word", "left")], copies(golden.rows))
    status, told = runs.report(lacking)
    check(status == 0 and (told["not-in-candidate"], told["not-in-golden"]) == (["theta", "word"], ["near", "shift"]), told)
    text = harness.run([runs.graze, "compare", other, runs.candidate], 60).stdout
    for line in ("not judged, since the candidate has no such column: theta word\n",
                 "not judged, since the golden table has no such column: near shift\n", f"| role | {len(golden.rows)} | 0 |\n"):
        check(line in text, line, text)


def missing_and_extra(runs, golden):
    rows = copies(golden.rows)
    runs.write(golden.names, rows[:4] + rows[5:])
    status, told = runs.report(golden)
    check(status == 1 and (told["missing"], told["extra"]) == (1, 0), "a row missing", told)
    runs.write(golden.names, rows + copies(rows[4:5]))
    status, told = runs.report(golden)
    check(status == 1 and (told["missing"], told["extra"], told["wrong"]) == (0, 1, 0), "a row twice", told)
    rows[4]["time"] = "1/1000003"
    runs.write(golden.names, rows)
    status, told = runs.report(golden)
    check(status == 1 and (told["missing"], told["extra"]) == (1, 1), "another time", told)
    lines = {(d["golden-line"], d["candidate-line"]) for d in told["disagreements"]}
    check(lines == {(rows[4]["#"], 0), (0, rows[4]["at"])}, "lines", lines)
    for row in rows:
        row["time"] = "root(-1 0 7;0;1)"
    runs.write(golden.names, rows)
    status, said = runs.report(golden)
    check(status == 3 and "no row is one of" in said, "foreign", said)


def rounded(runs, golden, folder):
    """Thirds and their doubles; golden rows that rounding makes equal are refused where answers differ."""
    with open(golden.path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    body = [line for line in lines if not line.startswith("#")]
    other = os.path.join(folder, "thirds.csv")
    column = golden.names.index("time")
    rows = [line.split(",") for line in body[1:]]
    for k, row in enumerate(rows):
        row[column] = f"{k + 1}/{3 * len(rows) + 1}"
    with open(other, "w", encoding="utf-8") as file:
        file.write("\n".join([body[0], *(",".join(r) for r in rows), f"# complete {len(rows)}"]) + "\n")
    thirds = Table(other)
    given = copies(thirds.rows)
    for row in given:
        for name in golden.key:
            row[name] = repr(to_double(Fraction(row[name])))
    runs.write(golden.key + ["role", "trimmed"], given[::-1])
    status, said = runs.report(thirds)
    check(status == 3 and "no row is one of" in said, "not rounded", status, said)
    status, told = runs.report(thirds, "--round", "binary64")
    check(status == 0 and told["agree"] == len(rows), "rounded", told)
    rows.append(list(rows[0]))
    rows[-1][column] = repr(to_double(Fraction(rows[0][column])))
    rows[-1][golden.names.index("role")] = "hidden"
    with open(other, "w", encoding="utf-8") as file:
        file.write("\n".join([body[0], *(",".join(r) for r in rows), f"# complete {len(rows)}"]) + "\n")
    status, said = runs.report(thirds, "--round", "binary64")
    check(status == 3 and f":{len(rows) + 1}: rounding makes this row equal to that of line 2" in said, "merged", said)


def recount(pairs, column):
    out = {}
    for row, given, wrong in pairs:
        one = out.setdefault(row[column], [0, 0, 0])
        one[0] += 1
        one[1] += given is not None and bool(wrong)
        one[2] += given is None
    return out


def many_changes(runs, golden, chance):
    """Any order, rows dropped, answers changed at random in some of the columns."""
    columns = sorted(chance.sample(golden.judged, chance.randint(1, len(golden.judged))), key=golden.judged.index)
    pairs, rows = [], []
    for row in golden.rows:
        given = None if chance.random() < 0.1 else dict(row)
        wrong = [c for c in columns if given and chance.random() < 0.1]
        for c in wrong:
            given[c] = another(row, c)
        pairs.append((row, given, wrong))
        rows += [given] if given else []
    chance.shuffle(rows)
    runs.write(chance.sample(golden.key + columns, len(golden.key + columns)), rows)
    status, told = runs.report(golden)
    if not check(status < 2 and told["rows"] == len(pairs), "random", status, told if status > 1 else ""):
        return
    check(told["wrong-by-column"] == {c: sum(c in w for _, _, w in pairs) for c in columns}, "columns", columns)
    for grouping in ("status", "role", "stratum"):
        groups = {g["value"]: [g["rows"], g["wrong"], g["missing"]] for g in told["by"][grouping]}
        check(groups == recount(pairs, grouping), grouping, groups)
    check(told["extra"] == 0 and told["missing"] == sum(g is None for _, g, _ in pairs), "counts", told["missing"])


def equal_keys(runs, folder):
    """Points moved to one place: the rows of a key belong together in their order."""
    table = os.path.join(folder, "equal.csv")
    rows = ["1/2,0,0,vertex 0,yes,1/9", "1/2,0,0,vertex 0,yes,4/9", "1/2,1,0,edge 0-1,no,0"]
    with open(table, "w", encoding="utf-8") as file:
        file.write("time,bx,by,cell,trimmed,shift\n" + "\n".join(rows) + "\n# complete 3\n")
    golden = Table(table)
    for order, wrong in (((2, 0, 1), 0), ((1, 2, 0), 2)):
        for more in ((), ("--round", "binary64")):
            runs.write(golden.names, [copies(golden.rows)[k] for k in order])
            status, told = runs.report(golden, *more)
            check(status == (wrong > 0) and told["wrong-by-column"] == {"cell": 0, "trimmed": 0, "shift": wrong}, order, told)


def kinds(runs, graze, folder, golden, scene):
    """Tables of two kinds are refused, in either role; a page and the explaining commands of a table."""
    solid, motion = (os.path.join(CASES, f) for f in scene)
    points, answers = os.path.join(folder, "points.csv"), os.path.join(folder, "answers.csv")
    names = [n for n in ("x", "y", "z") if n in golden.names]
    with open(points, "w", encoding="utf-8") as file:
        file.write(",".join(names + ["role", "time"]) + "\n" + "".join(",".join(r[n] for n in names + ["role", "time"]) + "\n"
                                                                     for r in golden.rows))
    done = harness.run([graze, "classify", solid, motion, points, "-o", answers, "--quiet"], 60)
    check(done.returncode == 0, "classify", done.stderr)
    for first, second, has in ((golden.path, answers, "has answers of graze classify"),
                               (answers, golden.path, "has contact points")):
        done = harness.run([graze, "compare", first, second], 60)
        check(done.returncode == 3 and f"{os.path.basename(second)}: {has}" in done.stderr and "two tables of one kind" in
              done.stderr, "kinds", done.stderr)
    done = harness.run([graze, "compare", answers, answers, "--format", "json"], 60)
    told = json.loads(done.stdout)
    check(done.returncode == 0 and "role" not in told["by"] and "role" not in told["wrong-by-column"], "carried", told)
    rows = copies(golden.rows)
    rows[2]["trimmed"] = another(rows[2], "trimmed")
    runs.write(golden.names, rows)
    page = os.path.join(folder, "page.html")
    done = harness.run([graze, "compare", golden.path, runs.candidate, "--solid", solid, "--motion", motion, "--page", page], 120)
    place = " ".join(rows[2][n] for n in names)
    check(done.returncode == 1 and f"`graze explain {shlex.quote(solid)} {shlex.quote(motion)} {place}`" in done.stdout, "explained", done.stderr)
    judged = {n: 1 for n in golden.judged if f"| {n} | {len(rows) - (n == 'trimmed')} | {int(n == 'trimmed')} |" in done.stdout}
    check(len(judged) == len(golden.judged) and os.path.getsize(page) > 1000, "columns", judged)


def main():
    args = options(__doc__, seed=1)
    with tempfile.TemporaryDirectory(prefix="graze contacts ") as folder:
        runs = Runs(args.graze, folder)
        for scene in SCENES:
            golden = make(args.graze, folder, scene)
            check(len(golden.rows) > 50 and len(golden.judged) == 13, scene, golden.judged)
            if args.derived:
                each_column(runs, golden, args.random)
                other_forms(runs, golden)
                columns_of_one(runs, golden, folder)
                missing_and_extra(runs, golden)
                rounded(runs, golden, folder)
                kinds(runs, args.graze, folder, golden, scene)
            for _ in args.rounds(5, str(scene)):
                many_changes(runs, golden, args.random)
        if args.derived:
            equal_keys(runs, folder)
    checks.finish()


if __name__ == "__main__":
    main()
