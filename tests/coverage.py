#!/usr/bin/env python3
"""Line and branch coverage by file of the rooms that decide and that check, as tests/stages/sanitizers.sh has counted it.

Every file of src/decide and src/questions must have 90 % of its lines and 80 % of its branches run, or a row in
tests/coverage.txt that says why not, and below which figures it must not fall. Rows that are no longer needed are named.
A branch is one outcome of a condition of the source, by clang's counters: what sanitizers and exceptions add is none. Each status
of a call is asked in one, whose other outcome limits and missing memory alone take: so 80 %. The counters are exact where
functions return: a count of what is not taken is that of the way there less what is taken.

graze-check ends in the middle of its functions, whereby that difference shows outcomes that never were. So gcc counts it, which
notes such ends, in a program without sanitizers. Of src/check every line must be run and every branch taken, or
tests/check/branches.txt has a row for the branch's line.

    coverage.py [--build FOLDER] [--counted FOLDER]

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import glob
import json
import os
import re
import subprocess
import sys

LINES, BRANCHES = 90, 80
ROOMS = ("src/decide/", "src/questions/")
ROW = re.compile(r"^(src/\S+)\s+(\d+)\s+(\d+)\s+(\S.*)$")


def output(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout


def measure(build):
    """File -> (lines run, lines, branches taken, branches) of the library, by what all programs that contain it have counted."""
    counts = [path for path in glob.glob(build + "/counts/*.profraw") if os.path.getsize(path)]  # a program without a counted file has none
    if not counts:
        sys.exit(f"{build}/counts: expected counts, by tests/stages/sanitizers.sh")
    output("llvm-profdata", "merge", "-sparse", "-o", build + "/counts/all", *counts)
    found = json.loads(output("llvm-cov", "export", "-summary-only", "-instr-profile", build + "/counts/all", build + "/libgraze.so"))
    kinds = [(kind, key) for kind in ("lines", "branches") for key in ("covered", "count")]
    files = {os.path.relpath(f["filename"]): [f["summary"][kind][key] for kind, key in kinds] for f in found["data"][0]["files"]}
    return {name: figures for name, figures in files.items() if name.startswith(ROOMS)}  # not headers of other rooms


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


def percent(part, whole):
    return 100.0 * part / whole if whole else 100.0


def judge(files):
    """(passed, failed): each file is covered, or has its reason."""
    rows, passed, failed, sums = reasons(), 0, 0, [0, 0, 0, 0]
    print("  lines branches file")
    for name, figures in sorted(files.items()):
        sums = [a + b for a, b in zip(sums, figures)]
        lines, branches = percent(*figures[:2]), percent(*figures[2:])
        low = lines < LINES or branches < BRANCHES
        floor = rows.get(name, (LINES, BRANCHES, ""))
        good = lines >= floor[0] and branches >= floor[1]
        wrong = f"FAILED: expected {floor[0]} and {floor[1]}, or a reason" if not good else "its row is not needed" if name in rows and not low else ""
        print(f"  {lines:5.1f} {branches:5.1f}    {name}" + (f"  {floor[2]}" if low else "") + (f"  {wrong}" if wrong else ""))
        passed, failed = passed + good, failed + (not good)
    print(f"  {percent(*sums[:2]):5.1f} {percent(*sums[2:]):5.1f}    all")
    absent = [f"{room}: no file of it is counted" for room in ROOMS if not any(name.startswith(room) for name in files)]
    absent += [f"tests/coverage.txt: {name} is not there" for name in sorted(set(rows) - set(files))]
    for what in absent:
        print("FAILED", what)
    return passed, failed + len(absent)


def missed_by_checker(folder):
    """{(file, line's text): "line" or "branch"} of graze-check, and prints a row for each of its files."""
    missed, files = {}, 0
    for counts in sorted(glob.glob(folder + "/*.gcda")):
        for one in json.loads(output("gcov", "--json-format", "--stdout", "--branch-probabilities", counts))["files"]:
            path = os.path.relpath(one["file"])
            if not re.fullmatch(r"src/check/\w+\.c", path):
                continue
            files += 1
            with open(path, encoding="utf-8") as source:
                text = source.read().splitlines()
            branches = [branch["count"] > 0 for line in one["lines"] for branch in line["branches"]]
            run = [line["count"] > 0 for line in one["lines"]]
            print(f"  {percent(sum(run), len(run)):5.1f} {percent(sum(branches), len(branches)):5.1f}    {path}")
            for line in one["lines"]:
                kind = "" if line["count"] else "line"
                kind = kind or ("branch" if any(branch["count"] == 0 for branch in line["branches"]) else "")
                if kind:
                    missed[os.path.basename(path), text[line["line_number"] - 1].strip()] = kind
    if files != len(glob.glob("src/check/*.c")):
        sys.exit(f"{folder}: counts of {files} files of src/check")
    return missed


def judge_checker(folder):
    """(passed, failed): each branch not taken has its reason, each reason its branch."""
    missed, rows = missed_by_checker(folder), set()
    with open("tests/check/branches.txt", encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                name, text, _ = line.rstrip("\n").split(" | ")
                rows.add((name, text))
    wrong = [(key, f"a {kind} that is never run") for key, kind in missed.items() if kind == "line" or key not in rows]
    wrong += [(key, "its row is not needed") for key in sorted(rows - set(missed))]
    for (name, text), why in wrong:
        print(f"FAILED src/check/{name}: {text}: {why}")
    print(f"  {len(missed)} branches of graze-check are not taken")
    return max(len(missed) - len(wrong), 0), len(wrong)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build-clang", help="the library, and what clang counted of it")
    parser.add_argument("--counted", default="build/counted", help="graze-check and what gcc counted of it")
    options = parser.parse_args()
    results = judge(measure(options.build)), judge_checker(options.counted)
    passed, failed = (sum(part) for part in zip(*results))
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
