# suite
"""Pairs of solids against CGAL: Minkowski sums for straight motions, intersections at single times for all.

SPDX-License-Identifier: GPL-3.0-or-later

Along b + t v the interiors meet at some time if and only if int S + segment meets int Q: the sum of the open solid is
the union of its positions, so that no seam where only closed positions meet counts. The closed sets meet if and only
if S + segment meets Q. At one time, exactly: I where the intersection has an interior, B where it has none and is not
empty, O where it is. Asked are the ends, every rational time of a contact, a time in each gap and in each slide, and
times by chance. `--scale 50` asks 2,000 straight pairs.
"""
import os
import sys
from collections import Counter

from pairs import Checks, Collide, first_agrees, options, trace_of

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from algebra import Root, between  # noqa: E402
from exact import Fraction as F  # noqa: E402
from motion import build, compose, legs, rotation, scaling, translate  # noqa: E402
from oracle import Oracle  # noqa: E402
from shells import shells_text  # noqa: E402
from solids import Mesh, block, meshes, prism, ring  # noqa: E402

STRAIGHT, TURNING = 40, 8
CHANCE = 2             # times by chance, of each pair
SECONDS = 300
TIP = "tip_on_face"    # CGAL's sum of its interior with a segment ends in a fault: along segments it stands


def pool():
    found = {name: meshes()[name] for name in ("hollow", "octahedron", "arrow", "edge_touch", TIP, "torus")}
    found["cube"] = block(0, 0, 0, 2, 2, 2)
    found["plate"] = block(0, 0, 0, 4, 3, 1)
    found["ell"] = prism(ring((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)), 0, 2)
    found["cup"] = prism(ring((0, 0), (5, 0), (5, 4), (4, 4), (4, 1), (1, 1), (1, 4), (0, 4)), 0, 1)
    found["tetrahedron"] = Mesh([(0, 0, 0), (3, 0, 0), (0, 3, 0), (0, 0, 3)], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    return found


def drawn(rng, solids, names):
    """A solid of the pool, perhaps with its axes exchanged."""
    name = rng.choice(names)
    axes = rng.choice(((0, 1, 2), (1, 2, 0), (2, 0, 1)))
    return name, solids[name].mapped(lambda p: tuple(p[k] for k in axes))


def moved(mesh, by):
    return mesh.mapped(lambda p: tuple(x + d for x, d in zip(p, by)))


def met(rng, moving, motion, fixed):
    """The fixed solid shifted: a corner of the moving one is at one of its corners, or beside by 1/4, 1/2 or 2, at a time in quarters."""
    t = motion.start + (motion.end - motion.start) * F(rng.randint(0, 4), 4)
    p, q = motion.map(rng.choice(moving.vertices), t), rng.choice(fixed.vertices)
    beside = rng.choice((0, 0, F(1, 2), F(1, 4), 2))
    return moved(fixed, [a - b + beside * rng.randint(-1, 1) for a, b in zip(p, q)])


def way(rng):
    """Along an axis, or askew."""
    if rng.random() < 0.6:
        out = [0, 0, 0]
        out[rng.randrange(3)] = rng.choice((-6, -4, -3, 3, 4, 6))
        return tuple(out)
    return tuple(rng.randint(-4, 4) for _ in range(3)) if rng.random() < 0.7 else (1, -2, F(7, 2))


def turning(rng):
    about = rng.choice((([0, 0, 1], 1), ([1, 2, 2], 3), ([0, 3, 4], 5)))
    turn = rotation([F(0), F(rng.choice((-1, 1)))], axis=about[0], length=about[1])
    go = translate([[F(0), F(rng.randint(-3, 3))] for _ in range(3)])
    grow = scaling([[F(1), F(rng.randint(-2, 4), 4)] for _ in range(3)])
    return build([(0, 1, compose(*rng.choice(((turn,), (turn, go), (grow,), (grow, turn)))))])


# ------------------------------------------------------------------------------------------------ asking
def position(motion, t):
    """M(t), row by row."""
    origin = motion.map((F(0),) * 3, t)
    columns = [motion.map([F(int(i == j)) for j in range(3)], t) for i in range(3)]
    return [x for i in range(3) for x in (*(c[i] - origin[i] for c in columns), origin[i])]


def letters_of(oracle, moving, fixed, segment, positions):
    """A letter for the segment, if there is one, and one for each position, as an Answer; None after a failed check."""
    row = lambda numbers: " ".join(map(str, numbers))
    lines = ["pair", shells_text(moving) + shells_text(fixed) + str(int(segment is not None))]
    lines += [row((*segment[0], *segment[1]))] if segment else []
    return oracle.ask("\n".join([*lines, str(len(positions)), *map(row, positions)]) + "\n", SECONDS)


def moments(rng, trace, motion):
    """Rational times: of the trace, between each two of it, and by chance."""
    found = {root.value for root in trace.times if root.value is not None}
    found |= {between(a, b) for a, b in zip(trace.times, trace.times[1:])}
    span = motion.end - motion.start
    found |= {motion.start + span * F(rng.randint(0, 1 << 10), 1 << 10) for _ in range(CHANCE)}
    return sorted(found)


def check(checks, collide, oracle, rng, name, scene, seen):
    moving, motion, fixed, segment = scene
    answer, first = (collide.ask(name, moving, motion, fixed, *flags) for flags in ((), ("--first",)))
    if answer is None or first is None:
        return
    first_agrees(checks, first, answer, name)
    trace = trace_of(answer, motion.start, motion.end)
    times = moments(rng, trace, motion)
    said = letters_of(oracle, moving, fixed, segment, [position(motion, t) for t in times])
    if said is None:
        return
    if said.status:
        checks.skip(name, "CGAL ended without an answer")
        return
    letters = said.text.split()
    checks.equal(len(letters), len(times) + bool(segment), name, "letters")
    if segment:
        checks.equal({"overlap": "I", "touch": "B", "clear": "O"}[answer.verdict], letters.pop(0), name, "sweep", answer.word)
    for t, letter in zip(times, letters):
        checks.equal(trace.state(Root(value=t)), letter, name, f"at {t}", answer.word)
    seen[answer.verdict] += 1
    seen["times"] += len(times)


def scenes(args):
    rng, solids = args.random, pool()
    all_, summed = sorted(solids), sorted(set(solids) - {TIP})
    for k in args.rounds(STRAIGHT, "straight"):
        (one, moving), (other, fixed) = drawn(rng, solids, summed), drawn(rng, solids, all_)
        ends = (0, 0, 0), way(rng)
        motion = legs(ends)
        fixed = met(rng, moving, motion, fixed)
        yield f"{one} {other} {k}", (moving, motion, fixed, ends)
    for k in args.rounds(TURNING, "turning"):
        (one, moving), (other, fixed) = drawn(rng, solids, all_), drawn(rng, solids, all_)
        motion = turning(rng)
        yield f"turning {one} {other} {k}", (moving, motion, met(rng, moving, motion, fixed), None)


def main():
    args = options(__doc__.splitlines()[0])
    checks, seen = Checks(), Counter()
    collide = Collide(args, checks)
    oracle = Oracle(args, checks, "pairs")
    for name, scene in scenes(args):
        check(checks, collide, oracle, args.random, name, scene, seen)
    print(", ".join(f"{n} {key}" for key, n in sorted(seen.items())))
    checks.holds(checks.skipped <= args.scale, "too many pairs without an answer by CGAL", checks.skipped)
    oracle.finish()
    checks.finish()


if __name__ == "__main__":
    main()
