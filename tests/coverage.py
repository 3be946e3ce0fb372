#!/usr/bin/env python3
"""Line and branch coverage by file (make coverage), of the suites on a build with --coverage.

Every file of src, CGAL's headers left out, must have 90 % of its lines and 90 % of its branches run, or a row in
tests/coverage.txt that says why not, and below which figures it must not fall. Rows that are no longer
needed are named. Branches that only exceptions take are not counted.

Of graze-check (src/check) every line must be run and every branch taken, or tests/check/branches.txt has a row for the
branch's line.

    coverage.py [--measured]     --measured: do not run the suites again

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import glob
import json
import os
import re
import subprocess
import sys

BUILD = "build-coverage"
RIGHT = 90
# Suites that ask other programs, and a program that is linked in another way, asked below; besides those that run in the plain build
# alone (run.py).
SKIPPED = ["tests/real/", "tests/bombs/", "tests/python/", "tests/memory/"]
# Suites that give more inputs to code which others run too.
SKIPPED += ["collide/laws", "collide/polycubes", "contact/laws", "envelope/laws"]
# A process that ends while its threads run writes counts from which gcov derives a negative one now and then; gcovr leaves such a
# line out instead of ending.
GCOVR = ["gcovr", "--root", ".", "--gcov-ignore-parse-errors", "--exclude-throw-branches"]
ROW = re.compile(r"^(src/\S+)\s+(\d+)\s+(\d+)\s+(\S.*)$")


def run_suites():
    for old in glob.glob(BUILD + "/**/*.gcda", recursive=True):
        os.remove(old)
    command = [sys.executable, "tests/run.py", "--build", BUILD, "--tier", "all", "--sanitizers", "--limit", "1500"]
    for name in SKIPPED:
        command += ["--skip", name]
    memory = [sys.executable, "tests/memory/memory.py", "--graze", BUILD + "/graze", "--counted"]
    # One suite of the plain build alone runs here too, beside the others: branches of graze-check need it.
    with subprocess.Popen([*command, "--only", "tests/check/contacts"]) as of_checker:
        statuses = [subprocess.run(asked).returncode for asked in (command, memory)]
    return any([*statuses, of_checker.returncode])


def measure():
    """File -> (lines run, lines, branches taken, branches)."""
    out = BUILD + "/coverage.json"
    subprocess.run(GCOVR + ["--filter", "src/", "--json-summary", out, BUILD + "/src"], check=True, stdout=subprocess.DEVNULL)
    with open(out, encoding="utf-8") as file:
        return {f["filename"]: (f["line_covered"], f["line_total"], f["branch_covered"], f["branch_total"])
                for f in json.load(file)["files"]}


def reasons():
    rows = {}
    with open("tests/coverage.txt", encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            at = ROW.match(line)
            if at:
                rows[at[1]] = (int(at[2]), int(at[3]), at[4])
            elif line.strip() and not line.startswith("#"):
                sys.exit(f"tests/coverage.txt:{number}: expected FILE LINES BRANCHES REASON")
    return rows


def missed_by_checker():
    """{(file, line's text): "line" or "branch"} of graze-check, which is built in one call beside the other objects."""
    out, missed, files = BUILD + "/checker.json", {}, 0
    subprocess.run(GCOVR + ["--filter", "src/check/", "--json", out, "--exclude-directories", BUILD + "/src",
                            "--exclude-directories", BUILD + "/tests", BUILD], check=True, stdout=subprocess.DEVNULL)
    with open(out, encoding="utf-8") as file:
        for one in json.load(file)["files"]:
            files += 1
            with open(one["file"], encoding="utf-8") as source:
                text = source.read().splitlines()
            for line in one["lines"]:
                if line.get("gcovr/noncode"):
                    continue
                what = "line" if line["count"] == 0 else "branch"
                if what == "line" or any(branch["count"] == 0 for branch in line["branches"]):
                    missed[os.path.basename(one["file"]), text[line["line_number"] - 1].strip()] = what
    if files != len(glob.glob("src/check/*.c")):
        sys.exit(f"{BUILD}: counts of {files} files of src/check")
    return missed


def judge_checker():
    """(passed, failed): each branch not taken has its reason, each reason its branch."""
    missed, rows = missed_by_checker(), set()
    with open("tests/check/branches.txt", encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                name, text, _ = line.rstrip("\n").split(" | ")
                rows.add((name, text))
    wrong = [(key, f"a {what} that is never run") for key, what in missed.items() if what == "line" or key not in rows]
    for (name, text), why in wrong + [(key, "its row is not needed") for key in sorted(rows - set(missed))]:
        print(f"  src/check/{name}: {text}: {why}")
    print(f"  {len(missed)} branches of graze-check are not taken")
    return len(missed) - len(wrong), len(wrong)


def percent(part, whole):
    return 100.0 * part / whole if whole else 100.0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--measured", action="store_true")
    options = parser.parse_args()
    failed = 0 if options.measured else int(run_suites())
    files, rows, passed = measure(), reasons(), 0
    sums = [0, 0, 0, 0]
    print("  lines branches file")
    for name in sorted(files):
        figures = files[name]
        sums = [a + b for a, b in zip(sums, figures)]
        lines, branches = percent(*figures[:2]), percent(*figures[2:])
        low = min(lines, branches) < RIGHT
        floor = rows.get(name, (RIGHT, RIGHT, ""))
        good = lines >= floor[0] and branches >= floor[1]
        wrong = f"FAILED: expected {floor[0]} and {floor[1]}, or a reason" if not good else "its row is not needed" if name in rows and not low else ""
        print(f"  {lines:5.1f} {branches:5.1f}    {name}" + (f"  {floor[2]}" if low else "") + (f"  {wrong}" if wrong else ""))
        passed, failed = passed + good, failed + (not good)
    for name in sorted(set(rows) - set(files)):
        print(f"FAILED tests/coverage.txt: {name} is not there")
        failed += 1
    print(f"  {percent(*sums[:2]):5.1f} {percent(*sums[2:]):5.1f}    all")
    checker = judge_checker()
    passed, failed = passed + checker[0], failed + checker[1]
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
