#!/usr/bin/env python3
"""# suite: number bombs: for each limit small inputs that would take too much time or memory without it.

Every bomb runs under 2,000,000 kB of address space and 60 s of wall time. It must end with status 6 and a
message that names its limit, or with the answer where `ends` says so. A limit that some --help names and no
bomb has is a failure, and so is a bomb of a limit that no --help names.

    bombs.py --graze GRAZE [--without] [--sanitizers] [NAME ...]

--without raises each bomb's limit as its row says, and sees that the bomb goes off: it is not done in 20 s, or
it runs out of memory. To add a bomb, add a row to BOMBS.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from harness import Checks, options  # noqa: E402

MEMORY = 2000000 << 10
SECONDS, SECONDS_WITHOUT = 60, 20
LIMIT_MET = 6

CUBE = """OFF
8 6 0
0 0 0
2 0 0
2 2 0
0 2 0
0 0 2
2 0 2
2 2 2
0 2 2
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""
MOVE = '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["8*t", 0, 0]}}]}'


def moved(transform):
    return '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": ' + transform + "}]}"


class Sparse(int):
    """A file of so many NUL bytes, which takes no room on the disk."""


class Endless(bytes):
    """A pipe that never ends: these bytes again and again."""


# name, limit, command (words; {name} is a file of the row), files, options that raise the limit (None: that
# cannot be done, and why stands beside the row), exit status and a part of the message
class Bomb:
    def __init__(self, name, limit, command, files, without, ends=LIMIT_MET, says=None):
        self.name, self.limit, self.command, self.files = name, limit, command, files
        self.without, self.ends, self.says = without, ends, says or f"{limit}="


CHECK = "check {cube.off} {move.json}"
BOMBS = [
    Bomb("digits-of-a-token", "digits", CHECK, {"move.json": moved('{"translate": ["1e99999999*t", 0, 0]}')},
         "--limit digits=100000000"),
    Bomb("digits-of-a-power", "digits", CHECK, {"move.json": moved('{"translate": ["(2+0*t)^300000000", 0, 0]}')},
         "--limit digits=100000000"),
    Bomb("digits-of-a-point", "digits", "classify --jobs 1 {cube.off} {move.json} {points.csv}",
         {"points.csv": "1e99999999,1e-99999999,1/3\n"}, "--limit digits=100000000"),
    Bomb("degree-of-a-power", "degree", CHECK, {"move.json": moved('{"translate": ["(1+t)^100000", 0, 0]}')},
         "--limit degree=1000000 --limit digits=100000000"),
    Bomb("degree-of-a-rotation", "degree", CHECK,
         {"move.json": moved('{"rotate": {"tan_half": "t", "times": 1000000, "axis": [0, 0, 1]}}')},
         "--limit degree=1000000 --limit digits=100000000"),
    Bomb("pieces-of-a-turn", "pieces", CHECK,
         {"move.json": moved('{"turn": {"quarters": 100000000, "axis": [0, 0, 1]}}')},
         "--limit pieces=100000000"),
    Bomb("pieces-of-joints", "pieces", "motion joints turn:360:0,0,1 turn:360:1,0,0 --tolerance 1e-15", {},
         "--limit pieces=100000000"),
    # The largest depth that --limit takes is one that the stack holds.
    Bomb("depth-of-json", "depth", CHECK, {"move.json": "[" * 1000000}, None),
    Bomb("depth-of-an-expression", "depth", CHECK,
         {"move.json": moved('{"translate": ["' + "(" * 1000000 + '", 0, 0]}')}, None),
    Bomb("depth-of-transforms", "depth", CHECK, {"move.json": moved('{"compose": [' * 400000)}, None),
    Bomb("grid-of-many", "grid", "classify --jobs 1 {cube.off} {move.json} --grid 3000,3000,3000", {},
         "--limit grid=1000000000000000000"),
    Bomb("grid-past-64-bits", "grid",
         "classify --jobs 1 {cube.off} {move.json} --grid 4294967296,4294967296,4", {}, None),
    Bomb("line-of-points", "line", "classify --jobs 1 {cube.off} {move.json} {points.csv}",
         {"points.csv": Endless(b"1,1,1,")}, "--limit line=1000000000000"),
    Bomb("line-of-a-table", "line", "compare {golden.csv} {candidate.csv}",
         {"golden.csv": "# graze 0.1.0\n# contract 1\n# dimension 2\nx,y,pmc\n1,1,in\n# complete 1\n",
          "candidate.csv": Endless(b"x,")}, "--limit line=1000000000000"),
    # The preset is for machines of that size; so these two have lower ones.
    Bomb("cells-of-vertices", "cells", "check --limit cells=1000000 {many.obj} {move.json}",
         {"many.obj": b"v 0 0 0\n" * 20000000}, "--limit cells=4000000000"),
    Bomb("bytes-of-a-pipe", "bytes", "check --limit bytes=100000000 {pipe.off} {move.json}",
         {"pipe.off": Endless(b"# no end\n")}, "--limit bytes=1000000000000"),
    Bomb("bytes-of-a-file", "bytes", "check {sparse.stl} {move.json}", {"sparse.stl": Sparse(5 << 30)},
         "--limit bytes=1000000000000"),
    Bomb("bytes-of-a-motion", "bytes", "check {cube.off} {sparse.json}", {"sparse.json": Sparse(5 << 30)},
         "--limit bytes=1000000000000"),
    Bomb("work-of-pieces-and-degree", "work", CHECK,
         {"move.json": moved('{"compose": [{"turn": {"quarters": 10000, "axis": [0, 0, 1]}}, '
                             '{"translate": ["t^190", "t^189", "t^188"]}]}')}, "--limit work=1000000000000000"),
    # Two roots that are no 2^-300000 apart; (x, y, z) = (0, 1, 1) meets the cube's face at both.
    Bomb("bits-of-close-roots", "bits", "classify --jobs 1 {cube.off} {close.json} {points.csv}",
         {"close.json": moved('{"translate": ["t^100-2*(10^900*t-1)^2", 0, 0]}'), "points.csv": "0,1,1\n"},
         "--limit bits=1000000000"),
    # Two tips that touch (0, 0) with one tangent, one of them on a way of a high degree, turning: an answer all the same.
    Bomb("curve-of-a-high-degree", "curve", "classify --jobs 1 --topo {tips.wkt} {tips.json} {points.csv}",
         {"tips.wkt": "MULTIPOLYGON(((0 0,-1 -2,1 -2,0 0)),((0 6,1 8,-1 8,0 6)))", "points.csv": "x,y\n0,0\n",
          "tips.json": '{"dimension": 2, "pieces": [{"t": [-1, 1], "transform": {"compose": [{"rotate": {"tan_half": '
                       '"(1-t^2)*t^3/7"}}, {"translate": ["t+t^80/3", "-t^2+t^80/5"]}]}}, {"t": [1, 2], "transform": '
                       '{"translate": ["(4/3)*(2-t)-(t-1)", "(-4/5)*(2-t)-7*(t-1)"]}}, {"t": [2, 4], "transform": '
                       '{"translate": ["t-3", "-6-(t-3)^2"]}}]}'},
         "--limit curve=1000000", 0, "the position of 1 of 1 rows is undecided"),
]

checks = Checks()
check = checks.holds


def feed(path, content, over):
    """Write into a named pipe until its reader is gone."""
    block = bytes(content) * (65536 // len(content))
    try:
        file = os.open(path, os.O_WRONLY)
    except OSError:
        return
    try:
        while not over.is_set():
            os.write(file, block)
    except OSError:
        pass
    finally:
        os.close(file)


def put(path, content, over):
    if isinstance(content, Sparse):
        with open(path, "wb") as file:
            file.truncate(content)
    elif isinstance(content, Endless):
        os.mkfifo(path)
        threading.Thread(target=feed, args=(path, content, over), daemon=True).start()
    else:
        with open(path, "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)


def release(path):
    """Let a writer go that still waits for a reader."""
    try:
        os.close(os.open(path, os.O_RDONLY | os.O_NONBLOCK))
    except OSError:
        pass


def run(graze, bomb, more, seconds, memory):
    """Exit status and standard error."""
    over = threading.Event()
    with tempfile.TemporaryDirectory(prefix="graze-bombs-") as folder:
        files = {"cube.off": CUBE, "move.json": MOVE, **bomb.files}
        paths = {name: os.path.join(folder, name) for name in files}
        words = [re.sub(r"^\{(.+)\}$", lambda at: paths[at[1]], word) for word in bomb.command.split()]
        for name, content in files.items():
            if "{" + name + "}" in bomb.command:
                put(paths[name], content, over)

        done = harness.run([graze, *words, *more], seconds, memory, stdout=subprocess.DEVNULL)
        over.set()
        for name, content in files.items():
            if isinstance(content, Endless):
                release(paths[name])
    return done.returncode, done.stderr


def limits_of_help(graze):
    """The names behind --limit in the help of every command."""
    overview = harness.run([graze, "--help"]).stdout
    names = set()
    for command in re.findall(r"^  graze ([a-z]+) ", overview, re.M):
        text = harness.run([graze, command, "--help"]).stdout
        at = re.search(r"--limit NAME=V\s+((?:.+\n(?:\s{20,}.*\n)*))", text)
        if at:
            names |= set(re.findall(r"([a-z]+) [0-9]", at[1]))
    return names


def main():
    args = options(__doc__, ("--without", {"action": "store_true"}), ("name", {"nargs": "*"}))
    memory = 0 if args.sanitizers else MEMORY
    chosen = [bomb for bomb in BOMBS if not args.name or bomb.name in args.name]
    if not args.name:
        listed, have = limits_of_help(args.graze), {bomb.limit for bomb in BOMBS}
        check(len(listed) >= 8, f"--help lists the limits: {sorted(listed)}")
        for limit in sorted(listed | have):
            check(limit in listed and limit in have, f"the limit {limit}: expected a row in --help and a bomb here")
    for bomb in chosen:
        if not args.without:
            status, text = run(args.graze, bomb, [], SECONDS, memory)
            check(status == bomb.ends and (status == 0 or bomb.says in text),
                  f"{bomb.name}: status {status}, expected {bomb.ends} and `{bomb.says}`; {text[:300]}")
        elif bomb.without:
            status, text = run(args.graze, bomb, bomb.without.split(), SECONDS_WITHOUT, memory)
            check(status not in (0, 1, 2, 3, LIMIT_MET), f"{bomb.name}: harmless without its limit: {status}; {text[:300]}")
    checks.finish()


if __name__ == "__main__":
    main()
