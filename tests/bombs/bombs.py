#!/usr/bin/env python3
"""# suite: number bombs: for each limit small inputs that would take too much time or memory without it.

Every bomb runs under 2,000,000 kB of address space and 60 s of wall time. It must end with status 6 and a
message that names its limit, or with the answer where `ends` says so. A limit that some --help names and no
bomb has is a failure, and so is a bomb of a limit that no --help names. README.md says what bounds each input of
each command: what it leaves out is a failure, and its options are tried.

    bombs.py --graze GRAZE [--without] [--sanitizers] [NAME ...]

--without raises each bomb's limit as its row says, and sees that the bomb goes off: it is not done in 20 s, or
it runs out of memory. To add a bomb, add a row to BOMBS.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from harness import Checks, bounded, options  # noqa: E402

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


SIGNED = "# graze 0.1.0\n# contract 1\n# dimension 2\nx,y,pmc,sdf\n1,1,in,-1\n# complete 1\n"


def moved(transform):
    return '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": ' + transform + "}]}"


def slid(*entries):
    return moved('{"translate": ["' + '", "'.join(entries) + '"]}')


def uneven(terms, power):
    """Coefficients 1 and 10^power in turn: no factor is common, and a zero is 10^-power from the next."""
    return "+".join(f"{1 + 7 * k % 9}{'e%d' % power if k % 2 else ''}*t^{k}" for k in range(terms))


def spread(terms, seed):
    """Coefficients of all sizes down to 10^-4990."""
    rng = random.Random(seed)
    return "+".join(f"{rng.randint(1, 99)}e-{rng.randint(1, 4990)}*t^{k}" for k in range(terms))


def dense(terms, digits, seed):
    """A polynomial whose coefficients are between -1 and 1 and have `digits` digits; it has no constant term."""
    rng = random.Random(seed)
    return "+".join(f"({rng.randint(-10 ** digits, 10 ** digits)}e-{digits})*t^{k}" for k in range(1, terms))


def quotient(terms, power):
    return f"({uneven(terms, power)})/({uneven(terms + 1, power)})"


def many(kind, item, count):
    return '{"dimension": 3, "' + kind + '": [' + ",".join(item.format(k, k + 1) for k in range(count)) + "]}"


def composed(item, count):
    return moved('{"compose": [' + ",".join(item.replace("K", str(k + 1)) for k in range(count)) + "]}")


class Sparse(int):
    """A file of this number of NUL bytes, which takes no room on the disk."""


class Endless(bytes):
    """A pipe that never ends: these bytes again and again."""


# name, limit, command (words; {name} is a file of the row), files, options that raise the limit (None: that
# cannot be done, and why stands beside the row), exit status and a part of the message
class Bomb:
    def __init__(self, name, limit, command, files, without, ends=LIMIT_MET, says=None):
        self.name, self.limit, self.command, self.files = name, limit, command, files
        self.without, self.ends, self.says = without, ends, says or f"{limit}="


def mapped(numbers, depth, node):
    """A curved solid under maps whose numbers are these in turn."""
    rows = [[numbers[(i + 3 * j) % len(numbers)] for j in range(4)] for i in range(3)]
    for _ in range(depth):
        node = {"affine": {"matrix": rows, "of": node}}
    return json.dumps({"dimension": 3, "solid": node})


BALLS = {"union": [{"ball": {"radius": 1, "center": [k, 0, 0]}} for k in range(100000)]}
# Two quartics that touch along x = z = 0, under a map with long numbers: no field of degree 3 has that line as a path.
TOUCHING = [{"polynomial": {key: str(value) for key, value in terms.items()}} for terms in (
    {"0,0,1": 7, "1,0,1": 1, "0,2,1": 2, "0,1,2": -1, "3,0,1": 2, "2,0,0": 5, "2,1,0": 1, "2,2,0": 3, "4,0,0": 1},
    {"0,0,1": 6, "0,3,1": 1, "2,0,1": 2, "0,0,2": 1, "2,0,0": 9, "2,1,0": -1, "2,0,2": 1, "3,0,0": 2})]
TILTED = [["1", "1/33333333", "-1/27777777", "0"], ["2/71111111", "1", "1/3", "0"], ["1/2", "-1/4", "1", "0"]]
LONG = [f"{d}" * n + "/" + f"{e}" * (n - 1) for d, e, n in ((1, 7, 9998), (3, 1, 9999), (7, 9, 9997), (9, 8, 9996))]
CHECK = "check {cube.off} {move.json}"
CURVED = "check {s.csg.json} {move.json}"
SCAD = "check {s.csg} {move.json}"
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
    Bomb("depth-of-a-curved-solid", "depth", CURVED, {"s.csg.json": '{"dimension": 3, "solid": ' + '{"union": [' * 500000}, None),
    Bomb("depth-of-openscad", "depth", SCAD, {"s.csg": "group() {" * 500000}, None),
    Bomb("digits-of-maps", "digits", CURVED, {"s.csg.json": mapped(LONG, 30, {"ball": {"radius": 1}})},
         "--limit digits=100000000 --limit work=1000000000000000"),
    Bomb("digits-of-a-box", "digits", CURVED, {"s.csg.json": mapped(["0", *LONG], 1, {"ball": {"radius": 1}})}, None),
    Bomb("work-of-a-curved-solid", "work", CURVED + " --limit work=1000000", {"s.csg.json": mapped([x[:300] + "1" for x in LONG], 1, BALLS)},
         "--limit work=1000000000000000"),
    Bomb("work-of-a-point", "work", "classify --jobs 1 {s.csg.json} {move.json} {points.csv} --limit work=2000000",
         {"s.csg.json": json.dumps({"dimension": 3, "solid": {"affine": {"matrix": TILTED, "of": {"difference": TOUCHING}}}}),
          "move.json": slid("t^2-1/2", "1/2-t^2", "2*t^2-1"), "points.csv": "1/99999999,1/3,-1/12\n"},
         "--limit work=1000000000000000", 0, "pmc of 1 of 1 rows is undecided"),
    Bomb("work-of-facets", "work", CURVED + " --limit work=3000000", {"s.csg.json": json.dumps({"dimension": 3, "solid": {"union": [
        {"box": {"low": [k * 7 % 101, k * 11 % 103, k * 13 % 107], "high": [k * 7 % 101 + 9, k * 11 % 103 + 9, k * 13 % 107 + 9]}}
        for k in range(3000)]}})}, "--limit work=1000000000000000"),
    Bomb("work-of-a-hull", "work", SCAD + " --limit work=1000000", {"s.csg": "hull() {" + "".join(
        f"multmatrix([[1, 0, 0, {k}], [0, 1, 0, {k * k}], [0, 0, 1, {k * k * k}], [0, 0, 0, 1]]) {{cube(size = [1, 1, 1]);}}"
        for k in range(300)) + "}"}, "--limit work=1000000000000000"),
    Bomb("cells-of-openscad", "cells", SCAD + " --limit cells=100000", {"s.csg": "sphere(r = 1);" * 200000}, None),
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
    Bomb("digits-of-a-power-of-a-power", "digits", CHECK, {"move.json": slid("((2)^33000)^30000", "0", "0")},
         None),  # the largest value that --limit takes ends it too
    Bomb("digits-of-an-interval", "digits", CHECK,
         {"move.json": slid("t^200", "0", "0").replace("[0, 1]", f'["1/{"7" * 9999}", "{"8" * 9999}"]')},
         "--limit digits=10000000 --limit work=1000000000000000"),
    Bomb("digits-of-a-quaternion", "digits", CHECK,
         {"move.json": moved('{"quaternion": ["1' + '", "1'.join(str(k) * 9999 for k in (3, 5, 7, 8)) + '"]}')}, None),
    Bomb("digits-of-a-composition", "digits", CHECK,
         {"move.json": composed('{"rotate": {"tan_half": "1/3", "axis": [1, 2, 2]}}', 50000)}, None),
    Bomb("digits-of-common-denominators", "digits", CHECK, {"move.json": slid(*(quotient(k, 9990) for k in (8, 9, 10)))}, None),
    Bomb("degree-of-a-power-of-a-power", "degree", CHECK, {"move.json": slid("((1+t)^200)^200", "0", "0")},
         "--limit degree=1000000 --limit digits=100000000 --limit work=1000000000000000"),
    Bomb("degree-of-factors", "degree", CHECK,
         {"move.json": slid("*".join(f"(t+{k})" for k in range(1, 9000)), "0", "0")}, None),
    Bomb("degree-of-common-denominators", "degree", CHECK,
         {"move.json": composed('{"translate": ["1/(t+K)", "1/(2*t+K)", "0"]}', 3000)}, None),
    Bomb("pieces-of-a-file", "pieces", CHECK,
         {"move.json": many("pieces", '{{"t": [{}, {}], "transform": {{"translate": ["t", 0, 0]}}}}', 30000)}, None),
    Bomb("pieces-of-key-frames", "pieces", CHECK,
         {"move.json": many("keyframes", '{{"t": {}, "position": [{}, 0, 0]}}', 200000)}, None),
    Bomb("pieces-of-turns", "pieces", CHECK,
         {"move.json": composed('{"turn": {"quarters": 900K, "axis": [0, 0, 1]}}', 60)}, None),
    Bomb("pieces-of-poses", "pieces", "motion poses {poses.csv}",
         {"poses.csv": "t,x,y,z,qw,qx,qy,qz\n" + "".join(f"{k},{k % 9},0,0,1,0,0,0\n" for k in range(100000))}, None),
    Bomb("pieces-of-a-program", "pieces", "motion gcode {a.nc}",
         {"a.nc": "G91 G0\nG90 X0 Y0 Z0\nG91\n" + "X1\n" * 1000000}, None),
    Bomb("pieces-of-a-helix", "pieces", "motion gcode {a.nc} --tolerance 1e-15",
         {"a.nc": "G0 X0 Y0 Z0\nG2 I5 Z1\n"}, None),
    Bomb("digits-of-a-program", "digits", "motion gcode {a.nc}",
         {"a.nc": "G0 X0 Y0 Z0\nG2 X1" + "0" * 1000000 + " R1\n"}, None),
    Bomb("work-of-quotients", "work", CHECK,
         {"move.json": slid("+0*".join(30 * [quotient(20, 9990)]), "0", "0")}, None),
    Bomb("work-of-a-matrix", "work", CHECK,
         {"move.json": moved('{"matrix": [' + ", ".join('["' + '", "'.join(
             uneven(50 + k * k % 11, 2500) for k in range(i, i + 4)) + '"]' for i in (1, 5, 9)) + "]}")}, None),
    Bomb("work-of-key-frames", "work", CHECK,
         {"move.json": many("keyframes", '{{"t": {0}, "quaternion": [1, "{1}e2000", 3, "{0}1e2000"]}}', 9000)}, None),
    # A weight that is nearly 0 at t = 1/3, and only there: its halves would be looked at down to 2^-16000.
    Bomb("work-of-a-box", "work", CHECK, {"move.json": slid("1/((3*t-1)^2+1e-9990)", "0", "0")},
         None),  # nor may they be more than the stack holds
    # A path that turns at times of all sizes; the box may be larger: an answer.
    Bomb("work-of-a-draft-of-a-box", "work", CHECK, {"move.json": slid(f"({spread(200, 1)})/({spread(200, 2)})", "0", "0")},
         None, 0, "legal"),
    # A motion within all limits, whose points take milliseconds each: many points, or the events of all facets.
    Bomb("work-of-an-envelope", "work", "envelope {cube.off} {long.json}",
         {"long.json": moved('{"quaternion": ["10+' + '", "'.join(dense(46, 400, k) for k in range(4)) + '"]}')},
         "--limit work=1000000000000000"),
    Bomb("work-of-a-picture", "work", "draw {cube.off} {long.json} -o {o.svg}",
         {"o.svg": "", "long.json": slid(*(dense(201, 900, k) for k in range(3)))},
         "--limit work=1000000000000000"),
    Bomb("work-of-a-boundary", "work", "boundary {cube.off} {long.json} --depth 6", {"long.json": slid(*(dense(201, 900, k) for k in range(3)))},
         "--limit work=1000000000000000"),
    # 2000 curves with a node at one point, so 2 million pairs of them; without this limit the answer is `on`.
    Bomb("work-of-curves-through-a-point", "work", "classify --jobs 1 {nodes.csg.json} {up.json} {points.csv}",
         {"nodes.csg.json": json.dumps({"dimension": 2, "solid": {"intersection": [
             {"polynomial": {"0,2": 1, "2,0": -k * k, "4,0": k, "1,3": 1}} for k in range(1, 2001)]}}),
          "up.json": '{"dimension": 2, "pieces": [{"t": [-1, 1], "transform": {"translate": ["-t^2", "-t"]}}]}',
          "points.csv": "x,y\n0,0\n"},
         "--limit work=1000000000000000", 0, "pmc of 1 of 1 rows is undecided"),
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
    # 2000 legs to and fro; each crosses half of the others.
    Bomb("arcs-of-an-outline", "arcs", "outline {square.wkt} {legs.json}",
         {"square.wkt": "POLYGON((0 0,1 0,1 1,0 1,0 0))",
          "legs.json": json.dumps({"dimension": 2, "keyframes": [{"t": k, "position": [k % 2 * 1000 + k * 7 % 13, k * 37 % 1001]} for k in range(2001)]})},
         "--limit arcs=1000000000"),
    # About 10^6 edges for a quarter of a circle.
    Bomb("edges-of-a-polygon", "arcs", "outline {square.wkt} {turn.json} --polygon p.wkt --within 1e-15 --limit arcs=10000",
         {"square.wkt": "POLYGON((0 0,1 0,1 1,0 1,0 0))",
          "turn.json": '{"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"rotate": {"tan_half": "t"}}}]}'},
         "--limit arcs=1000000000"),
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


def run(graze, bomb, more, seconds, limited):
    """Exit status and standard error."""
    over = threading.Event()
    with tempfile.TemporaryDirectory(prefix="graze-bombs-") as folder:
        files = {"cube.off": CUBE, "move.json": MOVE, **bomb.files}
        paths = {name: os.path.join(folder, name) for name in files}
        words = [re.sub(r"^\{(.+)\}$", lambda at: paths[at[1]], word) for word in bomb.command.split()]
        for name, content in files.items():
            if "{" + name + "}" in bomb.command:
                put(paths[name], content, over)

        command = [graze, *words, *more]
        done = harness.run(bounded(command, MEMORY) if limited else command, seconds, stdout=subprocess.DEVNULL)
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


def tables():
    """The rows of README.md: section -> lists of cells."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "README.md"), encoding="utf-8") as file:
        sections = re.split(r"^## ", file.read(), flags=re.M)[1:]
    return {section.splitlines()[0]: [[cell.strip(" `") for cell in line[1:-1].split("|")]
                                      for line in section.splitlines() if line.startswith("|")][2:] for section in sections}


OPERANDS = {"SOLID": "solid", "MOTION": "motion", "MOVING": "solid", "FIXED": "solid", "POINTS": "points", "X": "points", "GOLDEN": "tables", "CANDIDATE": "tables",
            "PART...": "parts", "CONTACTS": "points", "KIND": "options", "{solid}": "solid", "{motion}": "motion"}
NO_NUMBER = {"NAME=COLUMN,...", "MACHINE", "FILE", "FILE,", "DIR", "CMD", "NAME", "NAME=V", "NAME=V,", "NAME=W,...", "TEXT", "FOLDER", "FILE.off", "SOLID", "MOTION", "PAIRS.csv"}


def numeric_options(text):
    """The options of a --help that take a number: their value stands in capitals, or begins a list or an equation."""
    fields = [f for line in text.splitlines() for f in re.split(r"\s{2,}", line.strip()) if re.match("([a-z]+ )?-", f)]
    given = [pair for f in fields for pair in re.findall(r"(?<![^\s[])(--?[a-z][a-z-]*) ([^\s]+)", f)]
    return {name for name, value in given if value not in NO_NUMBER and re.match(r"[A-Z]|x0|z=|i/n|[.]{3}", value)}


def check_tables(graze):
    rows, overview = tables(), harness.run([graze, "--help"]).stdout
    commands = re.findall(r"^  graze ([a-z]+) ", overview, re.M)
    reads = {name: set(kinds.split(", ")) for name, kinds in rows["Commands"]}
    check(sorted(reads) == sorted(commands), f"README.md: the commands; expected {sorted(commands)}")
    listed, inputs = set(), {row[0] for row in rows["Inputs"]} | {"nothing"}
    for name in commands:
        text = harness.run([graze, name, "--help"]).stdout
        usage = re.match(r"graze [a-z]+([^:]*)", text)[1].replace("[", " ").replace("]", " ").split()
        for word in usage:
            check(word not in OPERANDS or OPERANDS[word] in reads[name], f"README.md: {name} reads {word}; expected its row to say so")
        check(reads[name] <= inputs, f"README.md: {name} reads {reads[name] - inputs}; expected rows of inputs")
        listed |= numeric_options(text)
    have = {row[0] for row in rows["Options"]}
    check(listed == have, f"README.md: options {sorted(listed ^ have)}; expected a row for each that takes a number, and no other")
    limits = {(bomb, row[2]) for row in rows["Inputs"] for bomb in row[3].split(", ") if bomb}
    bombs = {(bomb.name, bomb.limit) for bomb in BOMBS}
    check(limits == bombs, f"README.md: bombs {sorted(limits ^ bombs)}; expected a row with its limit for each, and no other")


def check_options(graze):
    files = {"cube.off": CUBE, "move.json": MOVE, "poses.csv": "t,x,y,z\n0,0,0,0\n1,1,0,0\n", "g.csv": SIGNED,
             "ball.csg": "sphere($fn = 0, $fa = 12, $fs = 2, r = 1);\n", "square.wkt": "POLYGON((0 0,1 0,1 1,0 1,0 0))",
             "slide.json": json.dumps({"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": ["t", "0"]}}]})}
    with tempfile.TemporaryDirectory(prefix="graze-bombs-") as folder:
        for name, content in files.items():
            put(os.path.join(folder, name), content, None)
        for option, bound, command in tables()["Options"]:
            words = [re.sub(r"^\{(.+)\}$", lambda at: os.path.join(folder, at[1]), word)
                     for word in command.replace("VALUE", "1e99999999").split()]
            done = harness.run([graze, *words], SECONDS)
            want = LIMIT_MET if bound == "digits" else 2
            check(option in words and done.returncode == want and (want == 2 or "digits=" in done.stderr),
                  f"{command}: status {done.returncode}, expected {want}; {done.stderr[:200]}")


def main():
    args = options(__doc__, ("--without", {"action": "store_true"}), ("name", {"nargs": "*"}))
    chosen = [bomb for bomb in BOMBS if not args.name or bomb.name in args.name]
    if not args.name:
        check_tables(args.graze)
        check_options(args.graze)
        listed, have = limits_of_help(args.graze), {bomb.limit for bomb in BOMBS}
        check(len(listed) >= 8, f"--help lists the limits: {sorted(listed)}")
        for limit in sorted(listed | have):
            check(limit in listed and limit in have, f"the limit {limit}: expected a row in --help and a bomb here")
    for bomb in chosen:
        if not args.without:
            status, text = run(args.graze, bomb, [], SECONDS, not args.sanitizers)
            check(status == bomb.ends and (status == 0 or bomb.says in text),
                  f"{bomb.name}: status {status}, expected {bomb.ends} and `{bomb.says}`; {text[:300]}")
        elif bomb.without:
            status, text = run(args.graze, bomb, bomb.without.split(), SECONDS_WITHOUT, not args.sanitizers)
            check(status not in (0, 1, 2, 3, LIMIT_MET), f"{bomb.name}: harmless without its limit: {status}; {text[:300]}")
    checks.finish()


if __name__ == "__main__":
    main()
