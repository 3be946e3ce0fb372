#!/usr/bin/env python3
"""# suite: graze compare and graze validate from outside.

Golden tables come from graze itself on a scene with a slide, a vertex and break points; candidates are made from
them by known changes, and every figure of the JSON report is counted again here. Then the commands that the report
gives are run, a long table shows that memory does not grow with rows, and the candidates in C of cases/candidates are
compiled and judged on points whose answers are evident.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import random
import shlex
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from harness import Checks, options  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.join(HERE, "..", "..", "cases", "candidates")
PMC = ("in", "on", "out")
LITTLE = 180 << 20  # bytes: less than a long table
checks = Checks()
check = checks.holds


def run(*command):
    done = harness.run(command, 300)
    return done.returncode, done.stdout, done.stderr


def read_table(path):
    """(column names, rows as dicts) of a table."""
    with open(path, encoding="utf-8") as file:
        lines = [line.rstrip("\n") for line in file if not line.startswith("#")]
    names = lines[0].split(",")
    return names, [dict(zip(names, line.split(","))) for line in lines[1:]]


def write_table(path, names, rows, head=""):
    with open(path, "w", encoding="utf-8") as file:
        file.write(head + ",".join(names) + "\n")
        for row in rows:
            file.write(",".join(row[n] for n in names) + "\n")


def make_golden(graze, folder, solid, motion, count, seed):
    points, golden = os.path.join(folder, "points.csv"), os.path.join(folder, "golden.csv")
    status, _, said = run(graze, "generate", solid, motion, "-n", str(count), "--seed", str(seed),
                          "--output", points)
    check(status == 0, "generate", said)
    status, _, said = run(graze, "classify", solid, motion, points, "--output", golden)
    check(status == 0, "classify", said)
    return golden


def tally(rows, column):
    """value -> [rows, wrong, missing] as the report has it."""
    out = {}
    for golden, given in rows:
        if column == "k" and not golden[column]:
            continue
        one = out.setdefault(golden[column], [0, 0, 0])
        one[0] += 1
        one[1] += given is not None and any(given[c] != golden[c] for c in given)
        one[2] += given is None
    return out


def check_figures(report, pairs, columns, label):
    """Every figure of a report against a recount of the pairs it was made of."""
    for column in ("stratum", "k", "class", "definition", "case"):
        told = {g["value"]: [g["rows"], g["wrong"], g["missing"]] for g in report["by"][column]}
        check(told == tally(pairs, column), label, column, told, tally(pairs, column))
    wrong = {c: sum(b is not None and b[c] != a[c] for a, b in pairs) for c in columns}
    check(report["wrong-by-column"] == wrong, label, report["wrong-by-column"], wrong)
    if "pmc" in columns:
        matrix = {p: dict.fromkeys(PMC + ("missing",), 0) for p in PMC}
        for golden, given in pairs:
            matrix[golden["pmc"]][given["pmc"] if given else "missing"] += 1
        check(report["pmc"] == matrix, label, report["pmc"], matrix)


def changed(row, column, chance):
    """The value of a column, by chance a wrong one."""
    value = row[column]
    if chance.random() < 0.9:
        return value
    if column == "pmc":
        return chance.choice([p for p in PMC if p != value])
    if column == "class":
        return "regular" if value != "regular" else "fold"
    return value + "O" if column == "word" else str(int(value) + 1)


def figures(graze, folder, golden, names, rows, seed):
    chance = random.Random(seed)
    columns = sorted(chance.sample(["pmc", "class", "i", "t", "word"], chance.randint(1, 5)))
    coordinates = [c for c in ("x", "y", "z") if c in names]
    pairs, table = [], []
    for row in rows:
        given = None if chance.random() < 0.05 else {c: changed(row, c, chance) for c in columns}
        pairs.append((row, given))
        if given:
            table.append(dict({c: row[c] for c in coordinates}, **given))
    candidate = os.path.join(folder, "candidate.csv")
    order = coordinates + columns
    chance.shuffle(order)
    write_table(candidate, order, table)
    label = f"seed {seed} columns {columns}"
    status, out, said = run(graze, "compare", golden, candidate, "--format", "json", "--show", "3")
    check(status in (0, 1), label, said)
    report = json.loads(out)
    differ = any(b is None or any(b[c] != a[c] for c in columns) for a, b in pairs)
    check(status == (1 if differ else 0), label, status)
    check(report["rows"] == len(rows) and report["extra"] == 0, label, report["rows"])
    check_figures(report, pairs, columns, label)
    return report


def counts_as_floats(graze, folder, golden, names, rows):
    """Counts as pandas and numpy write them are these counts; a half is none."""
    candidate = os.path.join(folder, "floats.csv")
    order = [n for n in names if n in ("x", "y", "z")] + ["i", "t"]
    for form in ("%.1f", "%.18e", "%.0f."):
        write_table(candidate, order, [dict(r, i=form % int(r["i"]), t=form % int(r["t"])) for r in rows])
        status, out, said = run(graze, "compare", golden, candidate, "--format", "json")
        check(status == 0 and json.loads(out)["wrong"] == 0, form, status, said)
    write_table(candidate, order, [dict(r, t="1.0" if r["t"] == "0" else "0.0") for r in rows])
    status, out, _ = run(graze, "compare", golden, candidate, "--format", "json")
    check(status == 1 and json.loads(out)["wrong-by-column"]["t"] == len(rows), "other counts", out[:300])
    for wrong in ("1.5", "nan", "-1.0", "1e999999999"):
        write_table(candidate, order, [dict(rows[0], t=wrong)])
        status, _, said = run(graze, "compare", golden, candidate)
        check(status == 3 and f"floats.csv:2: t: '{wrong}' is no answer; expected a whole number" in said, wrong, said)


def explanations(graze, folder, golden, names, rows, scene):
    """The command beside a disagreement runs, and its answer is the golden one."""
    candidate = os.path.join(folder, "candidate.csv")
    wrong = [dict(r, pmc="in" if r["pmc"] == "out" else "out") for r in rows]
    write_table(candidate, [n for n in names if n in ("x", "y", "z", "pmc")], wrong)
    status, out, _ = run(graze, "compare", golden, candidate, "--format", "json", "--show", "5",
                         "--solid", scene[0], "--motion", scene[1])
    check(status == 1, "all rows wrong", status)
    report = json.loads(out)
    check(report["wrong"] == len(rows), report["wrong"], len(rows))
    for one, row in zip(report["disagreements"], rows):
        words = shlex.split(one["explain"])
        status, text, said = run(graze, *words[1:])
        check(status == 0 and row["word"] in text, one, text, said)


def compared(graze, golden, candidate):
    """Status and JSON report, or what was said."""
    status, out, said = run(graze, "compare", golden, candidate, "--format", "json")
    return status, json.loads(out) if status in (0, 1) else said


def order_of_rows(graze, folder, golden, names, rows):
    """Rows find one another in any order, by id or by point; through a pipe, which is read once, in one order."""
    candidate = os.path.join(folder, "candidate.csv")
    shuffled = list(rows)
    random.Random(1).shuffle(shuffled)
    for table in (shuffled, list(reversed(rows)), rows):
        for columns in (names, [n for n in names if n != "id"]):
            write_table(candidate, columns, table)
            status, told = compared(graze, golden, candidate)
            check(status == 0 and told["agree"] == len(rows) and told["missing"] == told["extra"] == 0, status, told)
            check(told["matched-by"] == ("id" if "id" in columns else "point"), told["matched-by"])
    write_table(candidate, [n for n in names if n != "id"], shuffled)
    with open(candidate, encoding="utf-8") as file:
        done = harness.run([graze, "compare", golden, "-"], 60, input=file.read())
    check(done.returncode == 3 and "in another order; expected the same order, or files" in done.stderr, done.stderr)
    write_table(candidate, names, [r for r in rows for _ in (0, 1)])
    status, told = compared(graze, golden, candidate)
    check(status == 1 and told["extra"] == len(rows) and told["missing"] == 0, "every row twice", status, told)
    status, told = compared(graze, golden, golden)
    check(status == 0 and told["agree"] == len(rows), "itself", status, told)
    with open(golden, encoding="utf-8") as file:
        text = file.read()
    write_table(candidate, names, rows, head=text[:text.index("x,y")].replace("solid-sha256 ",
                                                                             "solid-sha256 0"))
    status, said = compared(graze, golden, candidate)
    check(status == 3 and "solid-sha256" in said, status, said)


def written_otherwise(graze, folder, golden, names, rows):
    """Coordinates and ids as programs change them: doubles an ulp off, six digits, no points at all, ids as floats. Rows match
    by id, else by order; where points are others they are not matched."""
    candidate, axes = os.path.join(folder, "candidate.csv"), [n for n in names if n in ("x", "y", "z")]
    off = [dict(r, **{a: repr(math.nextafter(to_double(F(r[a])), math.inf)) for a in axes}) for r in rows]
    short = [dict(r, **{a: "%.6g" % to_double(F(r[a])) for a in axes}) for r in rows]
    floats = [dict(r, id="%.18e" % float(r["id"])) for r in rows]
    for table, columns, by in ((off, axes + ["pmc"], "order"), (short, axes + ["pmc"], "order"), (rows, ["pmc"], "order"),
                               (off, axes + ["id", "pmc"], "id"), (short[::-1], axes + ["id", "pmc"], "id"),
                               (floats[::-1], ["id", "word"], "id")):
        write_table(candidate, columns, table)
        status, told = compared(graze, golden, candidate)
        check(status == 0 and told["agree"] == len(rows) and told["matched-by"] == by, columns, by, status, told)
    step = max(abs(F(o[a]) - F(r[a])) for o, r in zip(off, rows) for a in axes)
    write_table(candidate, axes + ["pmc"], off)
    told = compared(graze, golden, candidate)[1]
    check(told["rows-with-other-coordinates"] == len(rows) and step <= F(told["largest-difference"]) <= step * F(1001, 1000), told, step)
    write_table(candidate, axes + ["pmc"], off[::-1])
    status, told = compared(graze, golden, candidate)
    check(status in (1, 3) and (status == 3 and "no row is one of" in told or told["missing"] > 0), "reversed, rounded", told)
    write_table(candidate, axes + ["id", "pmc"], [dict(r, id=s["id"]) for r, s in zip(rows, rows[1:] + rows[:1])])
    status, said = compared(graze, golden, candidate)
    check(status == 3 and "has other points under the ids of" in said, "ids of the next rows", said)
    write_table(candidate, ["pmc"], rows[1:])
    status, said = compared(graze, golden, candidate)
    check(status == 3 and f"{len(rows) - 1} rows, and no columns" in said, "a row less", said)


def conventions(graze, folder, golden, names, rows):
    """A candidate without `on`: the figures under each convention are those of runs with that convention."""
    candidate, axes = os.path.join(folder, "candidate.csv"), [n for n in names if n in ("x", "y", "z")]
    write_table(candidate, axes + ["pmc"], [dict(r, pmc="in" if k % 3 else "out") for k, r in enumerate(rows)])
    counts = {way: json.loads(run(graze, "compare", golden, candidate, "--on-as", way, "--format", "json")[1])
              for way in ("on", "any", "in", "out")}
    wrong = {way: told["wrong"] for way, told in counts.items()}
    check(all(told["wrong-by-convention"] == wrong for told in counts.values()), wrong, counts["on"]["wrong-by-convention"])
    check(wrong["any"] < wrong["in"] < wrong["on"] and wrong["any"] < wrong["out"], wrong)
    text = run(graze, "compare", golden, candidate)[1]
    shown = ", ".join(f"`--on-as {way}`: {count}" for way, count in wrong.items())
    on = sum(r["pmc"] == "on" for r in rows)
    check(f"conventions: {on} golden rows are `on`, which the candidate never answers; rows wrong with {shown}\n" in text, text[:800])
    once = [dict(r, pmc="on" if k == 0 else "in") for k, r in enumerate(rows)]
    write_table(candidate, axes + ["pmc"], once)
    check("conventions" not in run(graze, "compare", golden, candidate)[1], "a candidate with one `on`")


def long_tables(graze, folder, count, limited):
    """A table ten times longer needs no more memory; under rounding a digest a row."""
    golden, candidate = os.path.join(folder, "long.csv"), os.path.join(folder, "long2.csv")
    with open(golden, "w", encoding="utf-8") as one, open(candidate, "w", encoding="utf-8") as two:
        one.write("x,y,pmc,id\n")
        two.write("x,y,pmc\n")
        for k in range(count):
            one.write(f"{k}/8,1/3,{'in' if k % 2 else 'out'},{'n' * 60}\n")
            two.write(f"{k / 8!r},1/3,{'in' if k % 2 else 'out'}\n")
        one.write(f"# complete {count}\n")
    for extra in ([], ["--round", "binary64"]):
        command = [graze, "compare", golden, candidate, "--format", "json", *extra]
        status, out, said = run(*(harness.bounded(command, LITTLE) if limited else command))
        check(status == 0 and json.loads(out)["agree"] == count, extra, status, out[:200], said)


def compiled(compiler, folder, name):
    program = os.path.join(folder, name)
    sources = [os.path.join(CASES, f) for f in (name + ".c", "scene.c", "motion.c")]
    status, _, said = run(compiler, "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O1", "-o", program,
                          *sources, "-lyajl", "-lm")
    check(status == 0, "compiling", name, said)
    return program


def sampled_distances(graze, compiler, folder):
    """A minimum over fewer times is no less than s but for rounding; ten times the times come nearer."""
    program, largest = compiled(compiler, folder, "sampled_sdf"), []
    for poses in (10, 100):
        _, out, said = run(graze, "validate", os.path.join(CASES, "ell.off"), os.path.join(CASES, "arch.json"), "-n", "300",
                           "--representable", "binary64", "--on-as", "any", "--candidate-has", "sdf", "--format", "json",
                           "--candidate", f"'{program}' {poses} {{solid}} {{motion}} {{points}} {{out}}")
        told = json.loads(out)["comparison"]["errors-of-sdf"]
        check(told["values"] == 300 and told["over"] > 100, "overestimates", poses, told["over"], said)
        check(told["largest"] == told["largest-over"], "underestimates", poses, told["largest"])
        largest.append(float(told["largest"]))
    check(largest[0] > 5 * largest[1] > 0, "largest errors", largest)


def candidates(graze, folder):
    """The candidates compile and are right where nothing is close."""
    compiler = shutil.which("cc") or shutil.which("gcc")
    if not compiler:
        checks.skip("candidates", "there is no C compiler")
        return
    points = os.path.join(folder, "plain.csv")
    with open(points, "w", encoding="utf-8") as file:
        # Passed by the block's foot; inside at the start; beside; above its path; inside at the end.
        file.write("x,y,z\n9/2,5/2,1\n1/2,1/2,1\n-1,0,1\n5,9/2,7/2\n5,7,5/2\n")
    for name, parameter in (("sampled", "100"), ("ei_double", "1e-9")):
        program = compiled(compiler, folder, name)
        report = os.path.join(folder, "it's a report")
        status, _, said = run(graze, "validate", os.path.join(CASES, "ell.off"),
                              os.path.join(CASES, "arch.json"), "--points", points, "--output", report,
                              "--candidate",
                              f"'{program}' {parameter} {{solid}} {{motion}} {{points}} {{out}}")
        check(status == 0, name, status, said)
        with open(report + ".json", encoding="utf-8") as file:
            told = json.load(file)
        check(told["comparison"]["agree"] == 5 and told["verdict"] == "no difference in 5 rows", told)
        with open(report + ".md", encoding="utf-8") as file:
            check("verdict: no difference in 5 rows" in file.read(), name, "Markdown")
    status, out, said = run(graze, "validate", os.path.join(CASES, "ell.off"),
                            os.path.join(CASES, "arch.json"), "-n", "200", "--format", "json",
                            "--candidate", f"'{os.path.join(folder, 'sampled')}' 3 {{solid}} "
                            "{motion} {points} {out}")
    check(status == 1 and json.loads(out)["comparison"]["wrong"] > 20, "three samples", status, said)
    sampled_distances(graze, compiler, folder)


def main():
    args = options(__doc__, seed=1)
    graze = args.graze
    with tempfile.TemporaryDirectory(prefix="graze compare ") as folder:
        if args.derived:
            candidates(graze, folder)
            # Its bound of memory is of the plain build alone: with a sanitizer fewer rows, still of many blocks.
            long_tables(graze, folder, 30000 if args.sanitizers else 300000, not args.sanitizers)
        for scene in (("ell.off", "arch.json"), ("plate.wkt", "shear.json")):
            scene = [os.path.join(CASES, f) for f in scene]
            golden = make_golden(graze, folder, *scene, 400, args.seed)
            names, rows = read_table(golden)
            check(len(rows) == 400, scene, len(rows))
            if args.derived:
                counts_as_floats(graze, folder, golden, names, rows)
                explanations(graze, folder, golden, names, rows, scene)
                order_of_rows(graze, folder, golden, names, rows)
                written_otherwise(graze, folder, golden, names, rows)
                conventions(graze, folder, golden, names, rows)
            for round_ in args.rounds(15, os.path.basename(scene[0])):
                figures(graze, folder, golden, names, rows, args.seed + round_)
    checks.finish()


if __name__ == "__main__":
    main()
