#!/usr/bin/env python3
"""Judges first contacts by `graze collide`: FCL's and Bullet's by conservative advancement, FCL's by discrete tests at 1,000 times.

    python3 cases/candidates/fcl.py --graze build/graze [--count N] [--code CODE] [--only FAMILY]

Compiles fcl.cpp and bullet.cpp into a temporary folder (Debian's libfcl-dev, libbullet-dev and libyajl-dev), makes N pairs of each family and prints
the table of the README. What is not installed is left out, and it says so. Every coordinate and coefficient is a double exactly.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import functools
import json
import math
import os
import random
import subprocess
import tempfile
from collections import Counter
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
# Code -> the header that shows that it is installed, flags, libraries.
CODES = {"fcl": ("/usr/include/fcl/fcl.h", ["-DNDEBUG", "-isystem", "/usr/include/eigen3"], ["-lfcl", "-lccd"]),
         "bullet": ("/usr/include/bullet/btBulletCollisionCommon.h", ["-DBT_USE_DOUBLE_PRECISION", "-isystem", "/usr/include/bullet"],
                    ["-lBulletCollision-float64", "-lLinearMath-float64"])}
MICRON = F(round(1e-6 * 2 ** 48), 2 ** 48)
GRANTED = 2e-4  # of the motion, early or late: ContinuousCollisionRequest's toc_err is 1e-4 of the part, or of its angle
# Code, shape, method, number of parts or of times.
METHODS = (("fcl", "box", "advance", 1), ("fcl", "mesh", "advance", 1), ("fcl", "mesh", "advance", 64), ("fcl", "box", "discrete", 1000),
           ("fcl", "mesh", "discrete", 1000), ("bullet", "box", "advance", 1), ("bullet", "hull", "advance", 1), ("bullet", "hull", "advance", 64))
WORDS = {"missed": "missed", "false": "made up", "late": "late", "inside": "late and inside", "early": "early", "crashed": "crashed"}
GARBAGE = dict(os.environ, MALLOC_PERTURB_="191")  # glibc hands out memory full of 32.5 as doubles
TRIANGLES = "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n"


class Box:
    """An axis-parallel box in place, as twelve triangles."""

    def __init__(self, low, high):
        self.low, self.high = [F(x) for x in low], [F(x) for x in high]

    def text(self):
        (x, y, z), (u, v, w) = self.low, self.high
        corners = [(a, b, c) for c in (z, w) for a, b in ((x, y), (u, y), (u, v), (x, v))]
        return "OFF\n8 12 0\n" + "".join(" ".join(map(str, p)) + "\n" for p in corners) + TRIANGLES

    def moved(self, by):
        return Box([a + d for a, d in zip(self.low, by)], [a + d for a, d in zip(self.high, by)])


def motion(transform):
    return json.dumps({"dimension": 3, "pieces": [{"t": [0, 1], "transform": transform}]})


def straight(start, way):
    return motion({"translate": [f"{F(a)}+{F(b)}*t" for a, b in zip(start, way)]})


# ------------------------------------------------------------------------------------------------ families
# Each makes (moving, motion, fixed) with a generator of random numbers. Sixteenths and 64ths keep all exact.

def size(rng):
    return [F(rng.randint(4, 32), 16) for _ in range(3)]


def two(rng):
    """A box whose low corner is the origin, and a fixed one that an x motion from -6 to 6 can meet."""
    return Box((0, 0, 0), size(rng)), Box((0, 0, 0), size(rng))


def beside(rng, moving, fixed, gap):
    """Where the moving box starts so that it passes the fixed one at a gap in y, overlapping in z."""
    up = F(rng.randint(int(-moving.high[2] * 64) + 8, int(fixed.high[2] * 64) - 8), 64)
    return (-6, fixed.high[1] + gap, up)


def pass_by(rng):
    moving, fixed = two(rng)
    return moving, straight(beside(rng, moving, fixed, F(rng.randint(1, 64), 64)), (F(rng.randint(192, 256), 16), 0, 0)), fixed


def near_miss(rng):
    moving, fixed = two(rng)
    return moving, straight(beside(rng, moving, fixed, MICRON), (F(rng.randint(192, 256), 16), 0, 0)), fixed


def near_hit(rng):
    moving, fixed = two(rng)
    return moving, straight(beside(rng, moving, fixed, -MICRON), (F(rng.randint(192, 256), 16), 0, 0)), fixed


def slide(rng):
    moving, fixed = two(rng)
    return moving, straight(beside(rng, moving, fixed, 0), (F(rng.randint(192, 256), 16), 0, 0)), fixed


def head_on(rng):
    """Into the fixed box, askew by a little, stopping inside or going through."""
    moving, fixed = two(rng)
    start = (-6, F(rng.randint(-8, 8), 32), F(rng.randint(-8, 8), 32))
    return moving, straight(start, (F(rng.randint(80, 192), 16), F(rng.randint(-4, 4), 32), F(rng.randint(-4, 4), 32))), fixed


def cubes(rng):
    """Two unit cubes, face on face, that end anywhere from just inside to beyond."""
    cube = Box((0, 0, 0), (1, 1, 1))
    far = F(rng.randint(32, 128), 16)
    return cube, straight((-far, 0, 0), (far - 1 + F(rng.randint(1, 48), 16), 0, 0)), cube


def through(rng):
    """A thin plate that crosses a thin wall between two of 1,000 times."""
    plate = Box((0, 0, 0), (F(1, 1024), 1, 1))
    wall = Box((0, F(-1, 2), F(-1, 2)), (F(1, 1024), F(3, 2), F(3, 2)))
    return plate, straight((-8 - F(rng.randint(0, 1023), 1024), 0, 0), (20, 0, 0)), wall


def turning(rng):
    """A bar that turns about its middle into a post, or stops before it; the angle is 2 atan t."""
    length, half = F(rng.randint(32, 64), 16), F(rng.randint(1, 8), 32)
    bar = Box((-length, -half, -1), (length, half, 1))
    at = (length * F(rng.randint(6, 15), 16), F(rng.randint(8, 64), 16))
    post = Box((*at, -2), (at[0] + F(1, 4), at[1] + F(1, 4), 2))
    return bar, motion({"rotate": {"axis": [0, 0, 1], "tan_half": "t"}}), post


FAMILIES = {"pass by": pass_by, "near miss of 1e-6": near_miss, "hit by 1e-6": near_hit, "slide": slide, "collision": head_on,
            "unit cubes head on": cubes, "plate through a wall": through, "bar turns into a post": turning}


# ------------------------------------------------------------------------------------------------- judging
def compile_codes(folder):
    """Code -> program, of those that are installed."""
    objects, out = [], {}
    for name in ("scene", "motion"):
        objects.append(os.path.join(folder, name + ".o"))
        subprocess.run(["cc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O2", "-c", "-o", objects[-1], os.path.join(HERE, name + ".c")], check=True)
    for code, (header, flags, libraries) in CODES.items():
        if not os.path.exists(header):
            print(f"SKIP {code}: lib{code}-dev is not installed")
            continue
        out[code] = os.path.join(folder, code)
        subprocess.run(["c++", "-std=c++17", "-O2", *flags, "-o", out[code], os.path.join(HERE, code + ".cpp"), *objects, *libraries,
                        "-lyajl", "-lm"], check=True)
    return out


def write(path, text):
    with open(path, "w", encoding="ascii") as file:
        file.write(text)


def collide(graze, paths, *flags):
    run = subprocess.run([graze, "collide", *paths, *flags, "--format", "json"], check=False, stdout=subprocess.PIPE, text=True)
    if run.returncode not in (0, 1):
        raise SystemExit(f"graze collide {' '.join(paths)}: status {run.returncode}")
    return json.loads(run.stdout)


def decimal(time):
    return float(F(time)) if isinstance(time, str) else float(time["approx"])


class Truth:
    """The pair word over time."""

    def __init__(self, graze, paths):
        found, first = collide(graze, paths), collide(graze, paths, "--first")["first"]
        if (first is None) != (found["first"] is None) or first and first["from"] != found["first"]["from"]:
            raise SystemExit(f"--first says otherwise: {' '.join(paths)}")
        self.verdict, self.word = found["verdict"], found["word"]
        self.first = first and decimal(first["from"])
        self.contacts = [(decimal(c["from"]), decimal(c["to"])) for c in found["contacts"]]

    def inside(self, t):
        """Do the interiors meet at t: contacts are the Bs of the word, other letters lie between them."""
        letters = self.word.split("B")
        passed = sum(start < t for start, _ in self.contacts)
        return letters[passed] == "I" and not any(start <= t <= end for start, end in self.contacts)


def answers(programs, methods, paths, more=(), environment=None):
    """(hit, share of the motion) of each method, a hit of None if it crashes; `more` are further arguments of the programs."""
    moving, path, fixed = paths
    out = {}
    for code, shape in dict.fromkeys(m[:2] for m in methods):
        waiting = [m for m in methods if m[:2] == (code, shape)]
        while waiting:
            lines = [f"{method} {n} {path}" for *_, method, n in waiting]
            run = subprocess.run([programs[code], shape, moving, fixed, *more], input="\n".join(lines) + "\n", check=False, stdout=subprocess.PIPE,
                                 text=True, env=environment)
            if run.returncode > 0:
                raise SystemExit(f"{code}: status {run.returncode}")
            found = [dict(word.split("=") for word in line.split()) for line in run.stdout.splitlines()[1:]]
            out.update((m, (one["hit"] == "1", float(one["t"]))) for m, one in zip(waiting, found))
            if run.returncode:
                out[waiting[len(found)]] = None, 0.0
            waiting = waiting[len(found) + 1:]
    return out


def even(t, _):
    return t


def by_angle(t, parts):
    """Both turn by even angles between the poses at the ends of a part; the tangent of the half angle is t."""
    k = math.floor(t * parts)
    a, b = math.atan(k / parts), math.atan((k + 1) / parts)
    return math.tan(a + (t * parts - k) * (b - a))


def judge(truth, hit, t):
    """What is wrong with an answer, if anything, and by how much time."""
    if hit is None:
        return "crashed", 0
    if truth.first is None:
        return ("false" if hit else "right"), 0
    if not hit:
        return "missed", 0
    if t > truth.first + GRANTED:
        return ("inside" if truth.inside(t) else "late"), t - truth.first
    if t < truth.first - GRANTED:
        return "early", truth.first - t
    return "right", 0


class Tally:
    """What each method's answers were, and the latest of them, by family and over all."""

    def __init__(self):
        self.counts, self.latest, self.changed = {}, Counter(), Counter()

    def add(self, name, method, said, by):
        self.counts.setdefault((name, method), Counter())[said] += 1
        if said in ("late", "inside"):
            self.latest[method] = max(self.latest[method], by)

    def cell(self, name, method):
        wrong = [f"{n} {WORDS[said]}" for said, n in sorted(self.counts[name, method].items()) if said != "right"]
        return ", ".join(wrong) or "right"


def written(folder, moving, path, fixed):
    """A pair as files: paths for graze, paths for the codes, further arguments of these."""
    paths = [os.path.join(folder, end) for end in ("moving.off", "motion.json", "fixed.off")]
    for where, text in zip(paths, (moving.text(), path, fixed.text())):
        write(where, text)
    return paths, paths, ()


def family(options, make, pair_files, programs, methods, name, tally):
    """Judges the pairs of a family and prints its row; `pair_files` writes a pair, as written() does."""
    rng, meet = random.Random(options.seed), 0
    for _ in range(options.count):
        ours, theirs, more = pair_files(*make(rng))
        truth = Truth(options.graze, ours)
        meet += truth.first is not None
        found, other = (answers(programs, methods, theirs, more, environment) for environment in (None, GARBAGE))
        for method, (hit, share) in found.items():
            clock = by_angle if getattr(make, "__name__", "") == "turning" and method[2] == "advance" else even
            tally.add(name, method, *judge(truth, hit, clock(share, method[3])))
            tally.changed[method] += found[method] != other[method]
    print_row(name, f"{meet} of {options.count}", *(tally.cell(name, m) for m in methods))


def print_row(*cells):
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def main(about, families, pair_files):
    """Prints the table of all families."""
    parser = argparse.ArgumentParser(description=about.split("\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--count", type=int, default=100, help="pairs of each family")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--code", default="", help="codes whose name contains this text")
    parser.add_argument("--only", default="", help="families whose name contains this text")
    options = parser.parse_args()
    options.graze = os.path.abspath(options.graze)
    with tempfile.TemporaryDirectory() as folder:
        programs = compile_codes(folder)
        methods = [m for m in METHODS if m[0] in programs and options.code in m[0]]
        tally = Tally()
        print_row("family", "meet", *(f"{code} {method} {n}, {shape}" for code, shape, method, n in methods))
        print("|---" * (2 + len(methods)) + "|")
        for name in families:
            if options.only in name:
                family(options, families[name], functools.partial(pair_files, folder), programs, methods, name, tally)
        print_row("latest, of the motion", "", *(f"{tally.latest[m]:.2g}" for m in methods))
        print_row("other answers where new memory is not 0", "", *(tally.changed[m] for m in methods))


if __name__ == "__main__":
    main(__doc__, FAMILIES, written)
