# suite
"""Words at a clearance, and least distances, never contradict FCL's distances at single times.

SPDX-License-Identifier: GPL-3.0-or-later

At a time where the word says O the distance is above R, where it says B it is R, where it says I it is below. No distance is below the enclosure of the least
one, and at its time there is one at most as great. FCL finds distances in doubles, of triangles, and of balls and capsules from triangles, to TOLERANCE; poses are
rounded to doubles. A boundary has no inside for FCL: fixed solids are thinner than the moving ones, so that none holds the other.
FCL is asked by cases/candidates/fcl.cpp, and its answers are recorded as CGAL's are. cases/candidates/distances.py asks FCL and Bullet at 1,000 times.
"""
import json
import os
import subprocess
import tempfile
from collections import Counter

from pairs import Checks, Collide, options, trace_of
from exact import Fraction as F, to_double  # noqa: E402
from round import ball, capsule

from algebra import Root  # noqa: E402
from motion import build, compose, matrix, rotation, translate  # noqa: E402
from oracle import Answer, Oracle, bounded  # noqa: E402
from solids import Mesh, block, meshes, prism, ring  # noqa: E402

PAIRS = {"polyhedra": 16, "balls": 8, "capsules": 8}
TIMES = 32
TOLERANCE = 2e-6   # libccd's nearest points of a ball or a capsule and a triangle are to 1e-6
RADII = [F(1, 8), F(1, 3), F(1), F(3, 2)]
AXES = (([0, 0, 1], 1), ([1, 2, 2], 3), ([0, 3, 4], 5))


class Distances(Oracle):
    """FCL's distances of a pair at poses; the text of a question is JSON."""

    def answer(self, text, seconds, as_file):
        asked = json.loads(text)
        with tempfile.TemporaryDirectory() as folder:
            def file(name, content):
                with open(os.path.join(folder, name), "w", encoding="ascii") as out:
                    out.write(content)
                return out.name
            paths = [file(f"{k}.off", asked[k]) for k in ("moving", "fixed")]
            poses = [file(f"{k}.json", pose) for k, pose in enumerate(asked["poses"])]
            out = subprocess.run(bounded([self.tool, "mesh", *paths, *asked["radius"]]), input="".join(f"distance 2 {p}\n" for p in poses), timeout=seconds,
                                 stdout=subprocess.PIPE, text=True, check=True)
            found = [dict(word.split("=") for word in line.split())["distance"] for line in out.stdout.splitlines()[1:]]
        return Answer(0, " ".join(f"{float(x):.9f}" for x in found))


def way(rng):
    """Past the origin, through it in the middle or beside; half of them turn about it, too."""
    go = translate([[F(rng.randint(-6, 6), 4) - F(c, 2), F(c), F(rng.randint(-2, 2), 2)] for c in (rng.randint(-9, 9) for _ in range(3))])
    axis, length = rng.choice(AXES)
    turn = rotation([F(0), F(rng.randint(-6, 6), 4)], axis=axis, length=length)
    return build([(0, 1, compose(*((turn, go) if rng.random() < 0.5 else (go,))))])


def moving_solid(rng):
    def at():
        return tuple(F(rng.randint(-8, 8), 4) for _ in range(3))
    while True:
        p = [at() for _ in range(4)]
        u, v, w = ([a - b for a, b in zip(q, p[0])] for q in p[1:])
        volume = sum(u[k] * (v[k - 2] * w[k - 1] - v[k - 1] * w[k - 2]) for k in range(3))
        if abs(volume) > 12:
            return Mesh(p, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]] if volume > 0 else [[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]])


def fixed_solid(rng):
    """A quarter thick; a moving ball, capsule or tetrahedron of volume 2 is thicker somewhere than that."""
    thin = F(1, 4)
    return rng.choice((block(-2, -2, 0, 2, 2, thin), block(0, -3, -1, thin, 3, 1),
                       prism(ring((-2, -2), (2, -2), (2, -2 + thin), (-2 + thin, -2 + thin), (-2 + thin, 2), (-2, 2)), -1, 1),
                       prism(ring((-2, -2), (2, -2), (2, 1), (2 - thin, 1), (2 - thin, -2 + thin), (-2 + thin, -2 + thin), (-2 + thin, 2), (-2, 2)), 0, 2)))


def scenes(args):
    rng = args.random
    for kind, count in PAIRS.items():
        for k in args.rounds(count, kind):
            corner = [F(rng.randint(4, 12), 8) for _ in range(3)]
            moving = (moving_solid(rng) if kind == "polyhedra" else ball(F(rng.randint(2, 8), 8), 0, 0, 0) if kind == "balls" else
                      capsule(F(rng.randint(2, 8), 8), [-x for x in corner], corner))
            yield f"{kind} {k}", moving, way(rng), fixed_solid(rng), rng.choice(RADII)


def triangles(collide, name, solid):
    """The solid as FCL reads it, in triangles."""
    path = collide.file(name.replace(" ", "_") + "_faces", solid, ".off")
    out = collide.graze.call("convert", path, "-o", path + ".triangles.off")
    if out.returncode:
        raise SystemExit(f"{name}: {out.stderr}")
    with open(path + ".triangles.off", encoding="ascii") as file:
        return file.read()


def pose(motion, t):
    """M(t) as a motion that stands, in decimals."""
    origin = motion.map((F(0),) * 3, t)
    columns = [motion.map([F(int(i == j)) for j in range(3)], t) for i in range(3)]
    rows = [[[F(to_double(c[i] - origin[i]))] for c in columns] + [[F(to_double(origin[i]))]] for i in range(3)]
    return build([(0, 1, matrix(rows, [F(1)]))]).text()


def points(body):
    """The base of a ball or capsule, for FCL."""
    return f"OFF\n{len(body.vertices)} 0 0\n" + "".join(" ".join(str(to_double(x)) for x in p) + "\n" for p in body.vertices)


def check(checks, collide, oracle, rng, scene, seen):
    name, moving, motion, fixed, radius = scene
    answer = collide.ask(name, moving, motion, fixed, "--clearance", str(radius), "--closest", "1e-7")
    if answer is None:
        return
    closest, trace = answer.record["closest"], trace_of(answer, motion.start, motion.end)
    nearest = closest["t"]
    nearest = F(nearest) if isinstance(nearest, str) else F(nearest["approx"])
    times = sorted(F(rng.randint(0, 1 << 12), 1 << 12) for _ in range(TIMES)) + [nearest]
    is_round = hasattr(moving, "bodies")
    question = {"moving": points(moving) if is_round else triangles(collide, name + " moving", moving), "fixed": triangles(collide, name, fixed),
                "radius": [str(to_double(moving.bodies[0][1]))] if is_round else [], "poses": [pose(motion, t) for t in times]}
    said = oracle.ask(json.dumps(question), one_form=False)
    if said is None:
        return
    distances = [max(0.0, float(x)) for x in said.text.split()]
    checks.equal(len(distances), len(times), name, "distances")
    rho = to_double(radius)
    for t, distance in zip(times, distances):
        letter = trace.state(Root(value=t))
        checks.holds(letter == "I" or distance >= rho - TOLERANCE, name, f"{letter} at {t}, FCL's distance {distance}", radius, answer.word)
        checks.holds(letter == "O" or distance <= rho + TOLERANCE, name, f"{letter} at {t}, FCL's distance {distance}", radius, answer.word)
        checks.holds(closest["low"] <= distance + TOLERANCE, name, f"FCL's distance {distance} at {t} is less than the least", closest)
        seen[letter] += 1
    checks.holds(distances[-1] <= closest["high"] + TOLERANCE, name, f"FCL's distance {distances[-1]} at the time of the least", closest)


def main():
    args = options(__doc__.splitlines()[0])
    checks, seen = Checks(), Counter()
    collide = Collide(args, checks)
    if os.environ.get("GRAZE_ORACLES") and not os.path.exists("/usr/include/fcl/fcl.h"):
        checks.skip("FCL's distances", "libfcl-dev is not installed")
        checks.finish()
    oracle = Distances(args, checks, "fcl")
    for scene in scenes(args):
        check(checks, collide, oracle, args.random, scene, seen)
    oracle.finish()
    print(f"times by letter: {dict(sorted(seen.items()))}")
    checks.holds(min(seen[letter] for letter in "IO") > 200 or not oracle.whole(), "both letters are common", seen)
    checks.finish()


if __name__ == "__main__":
    main()
