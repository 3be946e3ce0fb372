#!/usr/bin/env python3
"""# suite: every seed of every fuzz target run once, and the table of README.md held to graze.h.

A seed counts as one test. Of each target some seed must be taken, not refused: seeds that are all refused at
the door show little. SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import glob
import os
import re
import subprocess
import sys
import tempfile

HERE = "tests/fuzz"
MOST_BYTES = 2 << 20    # of all seeds
SECONDS = 120           # for the seeds of one target
BATCH = 400

passed, failed = 0, 0


def count(holds):
    global passed, failed
    passed, failed = passed + holds, failed + (not holds)


def check(holds, message):
    count(holds)
    if not holds:
        print("FAILED", message)


def run(program, words, folder):
    """Status and output of the program."""
    try:
        done = subprocess.run([program, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=SECONDS,
                              env=dict(os.environ, GRAZE_FUZZ_FOLDER=folder))
    except subprocess.TimeoutExpired as late:
        return f"not done after {SECONDS} s", (late.stdout or b"").decode("utf-8", "replace")
    return done.returncode, done.stdout.decode("utf-8", "replace")


def replay(program, target, seeds, folder):
    """The outcome of each seed, as far as the program came."""
    said = {}
    for first in range(0, len(seeds), BATCH):
        batch = seeds[first:first + BATCH]
        status, output = run(program, [target, *batch], folder)
        said.update(re.findall(r"^(tests/fuzz/corpus/\S+): (taken|refused)$", output, re.M))
        if status != 0:
            print(f"{target}: ended with {status}\n{output[-3000:]}")
    return said


def targets_held(program, folder):
    status, output = run(program, [], folder)
    targets = output.split()
    check(status == 0 and len(targets) > 20, "the list of targets")
    size = 0
    for target in targets:
        seeds = sorted(glob.glob(f"{HERE}/corpus/{target}/*"))
        size += sum(os.path.getsize(seed) for seed in seeds)
        said = replay(program, target, seeds, folder)
        lost = [seed for seed in seeds if seed not in said]
        for seed in seeds:
            count(seed in said)
        if lost:
            print(f"FAILED {lost[0]}: broke the target; {len(lost) - 1} seeds behind it were not reached")
        check("taken" in said.values(), f"{target}: no seed is taken")
    check(size < MOST_BYTES, f"the seeds have {size} bytes; right are less than {MOST_BYTES}")
    known = {os.path.basename(path) for path in glob.glob(f"{HERE}/corpus/*") + glob.glob(f"{HERE}/words/*")}
    check(known <= set(targets), f"{sorted(known - set(targets))}: seeds or words of no target")
    return targets


def public_functions():
    text = ""
    for path in sorted(glob.glob("include/graze/*.h")):
        with open(path, encoding="utf-8") as file:
            text += re.sub(r"/\*.*?\*/", "", file.read(), flags=re.S)
    return [re.search(r"(graze_\w+)\s*\(", declared)[1] for declared in re.findall(r"GRAZE_API([^;{]*);", text)]


def bodies():
    """What stands in each function of the targets, by its name; of a command all of its file."""
    found = {}
    for path in glob.glob(f"{HERE}/*.c"):
        with open(path, encoding="utf-8") as file:
            text = re.sub(r"/\*.*?\*/", "", file.read(), flags=re.S)
        for head, body in re.findall(r"^(\w[^;={}]*\))\s*\{\n(.*?)^\}", text, re.M | re.S):
            name = re.search(r"(\w+)\(", head)[1]
            found.setdefault(name, []).append((path, body))
    for path in glob.glob("src/cli/*.c"):
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
        check(function in table, f"README.md has no row for {function}: right are targets that call it, or a reason")
    for function, text in rows:
        check(function in functions, f"README.md has a row for {function}, which graze.h does not have")
        named = re.split(r", ", text)
        if any(name in targets for name in named):
            for name in named:
                check(name in targets and function in calls[name], f"{function}: {name} is no target that calls it")
        else:
            check(len(text.split()) > 1, f"{function}: `{text}` is neither a target nor a reason")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--scale", type=int, default=1)
    options = parser.parse_args()
    program = os.path.join(os.path.dirname(options.graze), "tests/fuzz/replay")
    with tempfile.TemporaryDirectory(prefix="graze-replay-") as folder:
        table_held(targets_held(program, folder))
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
