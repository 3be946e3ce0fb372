#!/usr/bin/env python3
"""# suite: every seed of every fuzz target run once, and the table of README.md held to graze.h.

A seed counts as one test. Some seed of each target must be taken, not refused: seeds that are all refused at
the door show little. SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
import seeds  # noqa: E402
from harness import Checks, options  # noqa: E402

HERE = "tests/fuzz"
MOST_BYTES = 2 << 20    # of all seeds
SECONDS = 120           # for the seeds of one target
BATCH = 400

checks = Checks()
check = checks.holds


def run(program, words, folder):
    """Status and output of the program."""
    done = harness.run([program, *words], SECONDS, stderr=subprocess.STDOUT,
                       env=dict(os.environ, GRAZE_FUZZ_FOLDER=folder))
    return done.returncode, done.stdout


def replay(program, target, paths, folder):
    """The outcome of each seed up to the one at which the program ended."""
    said = {}
    for first in range(0, len(paths), BATCH):
        status, output = run(program, [target, *paths[first:first + BATCH]], folder)
        said.update(re.findall(r"^(.+): (taken|refused)$", output, re.M))
        if status != 0:
            print(f"{target}: ended with {status}\n{output[-3000:]}")
    return said


def targets_held(program, folder):
    status, output = run(program, [], folder)
    targets = output.split()
    check(status == 0 and len(targets) > 20, "the list of targets")
    size = 0
    for target in targets:
        files, packed = seeds.plain(target), seeds.archived(target)
        check(len(files) <= seeds.PLAIN,
              f"{seeds.CORPUS}/{target} has {len(files)} files, expected {seeds.PLAIN} at most: {HERE}/fuzz.py --pack {target}")
        check(not packed or len(files) >= seeds.PLAIN, f"{seeds.archive(target)} has seeds, though there are {len(files)} files only")
        check(not set(files) & set(packed), f"{sorted(set(files) & set(packed))}: seeds of {target} as files and in the archive")
        paths = seeds.lay_out(target, os.path.join(folder, "seeds", target))
        size += sum(os.path.getsize(path) for path in paths)
        said = replay(program, target, paths, folder)
        for path in paths:
            check(path in said, f"{target}, seed {os.path.basename(path)}: broke the target, or was not reached behind one that did")
        check("taken" in said.values(), f"{target}: no seed is taken")
    check(size < MOST_BYTES, f"the seeds have {size} bytes, expected less than {MOST_BYTES}")
    known = {os.path.basename(path).split(".")[0] for path in glob.glob(f"{seeds.CORPUS}/*") + glob.glob(f"{HERE}/words/*")}
    check(known <= set(targets), f"{sorted(known - set(targets))}: seeds or words of no target")
    return targets


def public_functions():
    text = ""
    for path in sorted(glob.glob("include/graze/*.h")):
        with open(path, encoding="utf-8") as file:
            text += re.sub(r"/\*.*?\*/", "", file.read(), flags=re.S)
    return [re.search(r"(graze_\w+)\s*\(", declared)[1] for declared in re.findall(r"GRAZE_API([^;{]*);", text)]


def bodies():
    """Bodies of the functions of targets and runs, by name; a command is all of its file."""
    found = {}
    for path in [path for place in (HERE, "src/program/io", "src/program/points", "src/program/run") for path in glob.glob(f"{place}/*.c")]:
        with open(path, encoding="utf-8") as file:
            text = re.sub(r"/\*.*?\*/", "", file.read(), flags=re.S)
        for head, body in re.findall(r"^(\w[^;={}]*\))\s*\{\n(.*?)^\}", text, re.M | re.S):
            name = re.search(r"(\w+)\(", head)[1]
            found.setdefault(name, []).append((path, body))
    for path in glob.glob("src/program/cli/*.c"):
        with open(path, encoding="utf-8") as file:
            found["command_" + os.path.basename(path)[:-2]] = [(path, file.read())]
    return found


def reached(target, known):
    """All names that a target's function mentions, and those that the functions it mentions do."""
    names, todo = set(), [("fuzz_" + target, None)]
    while todo:
        name, where = todo.pop()
        for path, body in known.get(name, []):
            if len(known[name]) > 1 and path != where:   # static functions of one name
                continue
            fresh = set(re.findall(r"\w+", body)) - names
            names |= fresh
            todo += [(other, path) for other in fresh]
    return names


def table_held(targets):
    with open(f"{HERE}/README.md", encoding="utf-8") as file:
        rows = re.findall(r"^\| `(graze_\w+)` \| (.+?) \|$", file.read(), re.M)
    table, functions, known = dict(rows), public_functions(), bodies()
    calls = {target: reached(target, known) for target in targets}
    check(len(functions) > 70 and len(rows) == len(table), "the functions are found, each once")
    for function in functions:
        check(function in table, f"README.md has no row for {function}: expected targets that call it, or a reason")
    for function, text in rows:
        check(function in functions, f"README.md has a row for {function}, which graze.h does not have")
        named = re.split(r", ", text)
        if any(name in targets for name in named):
            for name in named:
                check(name in targets and function in calls[name], f"{function}: {name} is no target that calls it")
        else:
            check(len(text.split()) > 1, f"{function}: `{text}` is neither a target nor a reason")


def main():
    program = os.path.join(os.path.dirname(options(__doc__).graze), "tests/fuzz/replay")
    with tempfile.TemporaryDirectory(prefix="graze-replay-") as folder:
        table_held(targets_held(program, folder))
    checks.finish()


if __name__ == "__main__":
    main()
