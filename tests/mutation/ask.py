#!/usr/bin/env python3
"""Puts the patches of mutation/planted to the suites of a tree until one notices: by hand, of two trees, to tell what CI lost.

    ask.py --tree CLONE [--only mutant-0] [--from 0/2] [--known FILE] [--all]

CLONE is a clone of this repository at the commit that is asked, after `make test`; a patch is applied there, built, asked about and
taken back. Suites of the patch's room are asked first (rooms.py), or those that its kind of fault is for; with --all then
every other suite of `make test`, the quickest first. Who notices stands in a line each, `-` where nobody does. Who is red without
the patch too ends the run.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import glob
import os
import re
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
THREADS = os.path.join(HERE, "..", "stages", "threads.sh")
sys.path[:0] = [os.path.join(HERE, ".."), os.path.join(HERE, "..", "lib")]

import suitetimes  # noqa: E402
from mutate import is_red  # noqa: E402
from rooms import ROOMS, room_of  # noqa: E402
from run import interpreter  # noqa: E402

SECONDS = 900
# Suites, or commands after `$ `, for kinds of faults that no room's suites are for.
KINDS = {
    "an allocation that is not checked": ["memory/memory", "api/test_memory"],
    "a race": [f"$ {THREADS} test_threads.py"],
    "a document of a name that is gone": ["structure/structure", "readme/formats", "readme/readme", "refuse/run usage", "$ make -s docs"],
    "a rule of unfinished files": ["shards/ended", "shards/resume", "shards/record", "shards/shards", "memory/memory", "api/test_classify"],
    "a symbol that is exported by mistake": ["install/abi"],
    "a file that stays open": ["cases/cases", "readme/readme"],
    "a wrong exit status": ["memory/memory", "refuse/run", "judge/closed"],
    "a check of Python that is gone": ["python/run", "install/wheel"],
    "a page that does not react": ["page/page", "$ /usr/bin/python3 tests/page/browser.py --graze build/graze"],
    "a weaker definition": ["proofs/claims", "$ make -s proofs"],
    "a file that is not installed": ["install/install"],
}
# Kinds that sanitizers are for: the suites of the room are asked in a build with them too.
SANITIZED = ("a leak", "an overflow", "a read out of bounds", "a value that is not initialised", "an allocation that is not checked")
# How a tree builds with sanitizers stands in its stage; before it had one, so:
STAGE = os.path.join("tests", "stages", "sanitizers.sh")
BEFORE = """build="build-asan"
make -s B=$build CC=clang CXX=clang++ OPT="-O1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer" \\
    CFLAGS=-g1 CXXFLAGS=-g1 $build/graze programs
"""


def sanitized(name, tree):
    """The command that asks a suite in the build with sanitizers that the tree has: its folder, its flags, and what the suite runs."""
    stage = BEFORE
    if os.path.exists(os.path.join(tree, STAGE)):
        with open(os.path.join(tree, STAGE), encoding="utf-8") as file:
            stage = file.read()
    folder = re.search(r'^build="(.+)"$', stage, re.M)[0]
    made = re.search(r"^make -s B=\$build (?:.*\\\n)*.*?(?= \$build/graze programs$)", stage, re.M)[0]
    goals = f"$build/tests/{name}" if "/test_" in name else "all $build/tests/graze-memory"
    return f"""export ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1
{folder}
export LLVM_PROFILE_FILE=/dev/null
{made} {goals} && python3 tests/run.py --build $build --sanitizers --limit 2400 --only tests/{name}"""


class Tree:
    """The clone whose suites are asked."""

    def __init__(self, path, python):
        self.path, self.python, self.sound = path, python, set()

    def call(self, *command):
        return subprocess.run(command, cwd=self.path, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def build(self, *targets):
        done = self.call("make", "-s", "-j1", *targets)
        return done.returncode == 0

    def is_noticed_by(self, asker):
        here = os.getcwd()
        os.chdir(self.path)
        try:
            if asker.startswith("$ "):
                return is_red(["bash", "-c", asker[2:]], SECONDS)
            name, *words = asker.split()
            if name == "sanitized":
                return is_red(["bash", "-c", sanitized(words[0], self.path)], SECONDS)
            if "/test_" in name:
                return not self.build(f"build/tests/{name}") or is_red([f"build/tests/{name}"], SECONDS)
            return is_red([self.python, f"tests/{name}.py", "--graze", "build/graze", *words], SECONDS)
        finally:
            os.chdir(here)


    def notices(self, patch, path, those):
        """The first of `those` that notices the patch, or None."""
        if self.call("git", "apply", patch).returncode:
            raise SystemExit(f"{patch} does not apply to {self.path}")
        try:
            who = "the build" if not self.build("all") else next(filter(self.is_noticed_by, those), None)
        finally:
            self.call("git", "apply", "-R", patch)
            self.call("touch", path)
            self.build("all")
        if who not in (None, "the build") and who not in self.sound:
            if self.is_noticed_by(who):
                raise SystemExit(f"{who} is red without {patch}")
            self.sound.add(who)
        return who


def askers(what, path, everyone):
    kind = what.split(": ")[0]
    own = [*KINDS.get(kind, []), *(asker.removeprefix("exact ") for asker in ROOMS.get(room_of(path), []))]
    if kind in SANITIZED:
        own += [f"sanitized {asker.split()[0]}" for asker in own if not asker.startswith("$ ")]
    others = [name.rsplit(".", 1)[0] for name, _ in sorted(suitetimes.read().items(), key=lambda row: row[1])
              if "/" in name and name != suitetimes.CI]
    return list(dict.fromkeys([*own, *(others if everyone or not own else [])]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tree", required=True)
    parser.add_argument("--only", default="", help="patches whose name contains this text")
    parser.add_argument("--from", dest="share", default="0/1", help="K/N: every Nth patch, from the Kth on")
    parser.add_argument("--known", help="a file of such lines; what has one is not asked again")
    parser.add_argument("--all", action="store_true", help="ask every suite of `make test` after those of the room")
    options = parser.parse_args()
    first, step = map(int, options.share.split("/"))
    tree = Tree(options.tree, interpreter()[0])
    known = set()
    if options.known:
        with open(options.known, encoding="utf-8") as file:
            known = {line.split(" | ")[0] for line in file}
    patches = [path for path in sorted(glob.glob(os.path.join(HERE, "planted", "*.patch")))
               if options.only in path and os.path.basename(path)[:-6] not in known]
    for patch in patches[first::step]:
        with open(patch, encoding="utf-8") as file:
            what, path = re.match(r"(.*): (\S*)\n", file.read()).groups()
        began = time.time()
        who = tree.notices(patch, path, askers(what, path, options.all)) or "-"
        print(f"{os.path.basename(patch)[:-6]} | {what} | {path} | {who} | {time.time() - began:.0f} s", flush=True)


if __name__ == "__main__":
    main()
