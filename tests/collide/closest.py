# suite
"""The least distance over a motion: pairs by hand, and random ones against distances at single times in fractions.

SPDX-License-Identifier: GPL-3.0-or-later

Above each scene stands its derivation. m is the least distance, as the root of a rational less the radii: low <= m <= high is checked in
fractions, of the decimals printed. The enclosure for a smaller tolerance lies in that for a greater one. At its time the distance is at most high; the
second method, nearest points of simplices in fractions (nearness.py), finds it nowhere below low.
"""
import json
from collections import Counter

from clearance import along_x
from distances import Scene, solid, some_motion
from exact import Fraction as F, to_double
from hand import CUBE, DIAMOND, FULL_TURN, OCTA, SLAB, SPIKE, SQUARE, WALL, moved, plane
from pairs import Checks, Collide, options
from round import H, Round, ball, capsule

from motion import build, compose, rotation, scaling, translate  # noqa: E402
from solids import block, box_ring, joined  # noqa: E402

TOLERANCES = ("1/16", "1e-5", "1e-12")
PAIRS = {2: 12, 3: 12}
SCENES = []


def scene(name, moving, motion, fixed, square, radii=0, time=None, frame=None, meets=False, x=None):
    """m is the root of `square` less `radii`; `time`: where it is reached, if at one time alone; `x`: the first coordinates of the two places then."""
    SCENES.append((name, moving, motion, fixed, F(square), F(radii), time, frame, meets, x))


# ------------------------------------------------------------------------------------- polyhedra

# S = [t, t + 1] x [0, 1]^2 against Q = [3, 4] x [0, 1]^2: 2 - t
scene("a face comes near", CUBE, along_x(0, 1), WALL, 1, time=1, x=(2, 3))
scene("moving apart", CUBE, moved(0, 1, [F(3, 2), -1], [0], [0]), WALL, F(1, 4), time=0)
# the tips (t, 2) and (0, 1): 1 at t = 0
scene("tip past tip", DIAMOND, moved(-1, 2, [0, 1], [3]), DIAMOND, 1, time=0)
# [3, 4] x [2, 3] over [t, t + 1] x [0, 1]: 1 from t = 2 to 4
scene("a slide at distance 1", SQUARE, moved(0, 6, [0, 1], [0]), plane(box_ring(3, 2, 4, 3)), 1)
# gaps of y and z of 2 and 2, that of x is 0 from t = 2 to 4
scene("an edge along an edge", CUBE, along_x(0, 6), block(3, 3, 3, 4, 4, 4), 8)
# the lowest vertex of the octahedron at height 1/3 + (t^2 - 2)^2, over the slab: at the root of 2
scene("a vertex at an irrational time", OCTA, moved(0, 2, [0, 1], [0], [F(16, 3), 0, -4, 0, 1]), SLAB, F(1, 9), time=1.4142135623730951)
# at height 1/4: each question of the bisection may be answered at the root of 2 alone
scene("a dyadic distance at an irrational time", OCTA, moved(0, 2, [0, 1], [0], [F(21, 4), 0, -4, 0, 1]), SLAB, F(1, 16), time=1.4142135623730951)
# the tip, 5 from the centre, against x <= -11/2 after half a turn
scene("a full turn past a wall", SPIKE, FULL_TURN, plane(box_ring(-8, -2, F(-11, 2), 2)), F(1, 4), time=2)
# the corner (1, 1, 1) of S + t (1, -1, 0), t in [0, 4], against the corner (3, 3, 3): (2 - t)^2 + (2 + t)^2 + 4 is least at t = 0
scene("corner to corner", CUBE, moved(0, 4, [0, 1], [0, -1], [0]), block(3, 3, 3, 4, 4, 4), 12, time=0)
# [-1, 1]^3 times 1 + t against x = 3: 2 - t until t = 3/2
scene("a growing cube", block(-1, -1, -1, 1, 1, 1), build([(0, F(3, 2), scaling([[1, 1]] * 3))]), block(3, 0, 0, 4, 1, 1), F(1, 4), time=F(3, 2))
# one moves by t, the other by -t: 5 - 2 t
scene("both move", CUBE, along_x(0, 2), block(6, 0, 0, 7, 1, 1), 1, time=2, frame=moved(0, 2, [0, -1], [0], [0]), x=(3, 4))
# [t, t + 1] and [6 - q, 7 - q], q = t until t = 1, then 2 t - 1: 6 - 3 t at t = 3/2
scene("both move, one in two pieces", CUBE, along_x(0, F(3, 2)), block(6, 0, 0, 7, 1, 1), F(9, 4), time=F(3, 2), x=(F(5, 2), 4),
      frame=build([(0, 1, translate([[0, -1], [0], [0]])), (1, 2, translate([[1, -2], [0], [0]]))]))
# Q = [-1, 1]^3 times 1 + t: 3 - (1 + t), in the world
scene("a frame that grows", block(3, 0, 0, 4, 1, 1), moved(0, 1, [0], [0], [0]), block(-1, -1, -1, 1, 1, 1), 1, time=1,
      frame=build([(0, 1, scaling([[1, 1]] * 3))]), x=(3, 2))
# Q of radius 1 times 1 + t: 3 - (1 + t)
scene("a ball in a frame that grows", block(3, -9, -9, 4, 9, 9), moved(0, 1, [0], [0], [0]), ball(1, 0, 0, 0), 9, 2, time=1,
      frame=build([(0, 1, scaling([[1, 1]] * 3))]), x=(3, 2))
# far and near parts: 1 from the post at x <= 0 at t = 1, 1/2 from that at 5 at t = 7/2
scene("two posts", CUBE, along_x(1, F(7, 2)), joined(block(-1, 0, 0, 0, 1, 1), block(5, 0, 0, 6, 1, 1)), F(1, 4), time=F(7, 2))
# a gap of 2^-40
scene("a narrow gap", CUBE, along_x(0, 2 - F(1, 2 ** 40)), WALL, F(1, 2 ** 80))
scene("far away", CUBE, along_x(-(10 ** 9), 0), block(10 ** 9, 0, 0, 10 ** 9 + 1, 1, 1), (10 ** 9 - 1) ** 2, time=0)

# ------------------------------------------------------------------------------------- where they meet

scene("a face comes to a face", CUBE, along_x(0, 6), WALL, 0, time=2, meets=True)
scene("a touch at an irrational time", OCTA, moved(0, 2, [0, 1], [0], [5, 0, -4, 0, 1]), SLAB, 0, time=1.4142135623730951, meets=True)
scene("overlap from the start", CUBE, along_x(F(5, 2), 6), WALL, 0, time=F(5, 2), meets=True)
scene("balls meet", ball(2, 0, 0, 0), moved(-6, 6, [0, 1], [3], [0]), ball(3, 0, 0, 0), 0, time=-4, meets=True)

# ------------------------------------------------------------------------------------- balls and capsules

PASS = moved(-6, 6, [0, 1], [3], [0])
# the centre (t, -1, -1) and the edge y = z = 0 of WALL, root of 2 while 3 <= t <= 4; of radius 1
scene("a ball past an edge", ball(1, 0, 0, 0), moved(0, 7, [0, 1], [-1], [-1]), WALL, 2, 1)
scene("a ball past a ball", ball(1, 0, 0, 0), PASS, ball(H, 0, 0, 0), 9, F(3, 2), time=0)
# axes along x and y, 2 - t apart
scene("capsules cross", capsule(H, (0, -3, 0), (0, 3, 0)), moved(0, F(1, 2), [0], [0], [-2, 1]), capsule(F(1, 4), (-3, 0, 0), (3, 0, 0)), F(9, 4), F(3, 4),
      time=F(1, 2))
# its centre is 1 + t, its radius (1 + t)/2: 3 - 3 (1 + t)/2 at t = 1/2; the radii are those at the time
scene("a ball grows", ball(H, 1, 0, 0), build([(0, H, scaling([[1, 1]] * 3))]), block(3, -9, -9, 4, 9, 9), F(9, 4), F(3, 4), time=H,
      x=(F(9, 4), 3))
# [-1/2, 1/2]^2 x [-1, 0] is 2 from the thin one's centre, 3 from the thick one's: 15/8 and 1
UNION = Round(([(F(0), F(0), F(2))], F(1, 8)), ([(F(0), F(0), F(-4))], F(2)))
scene("the pair with the least d - rho", CUBE, moved(0, 1, [F(-1, 2)], [F(-1, 2)], [-1]), UNION, 9, 2)
# its axis from 0 to (3, 0) turns to (0, 3), 2 from the centre (0, 5)
scene("a capsule turns past a disk", capsule(H, (0, 0), (3, 0)), build([(0, 1, rotation([0, 1]))]), ball(H, 0, 5), 4, 1, time=1)


def ask(collide, name, moving, motion, fixed, tolerance, frame=None, flags=()):
    """The record, its decimals as fractions; None after a failed check."""
    tag = name.replace(" ", "_")
    words = [collide.file(tag + "_moving", moving, moving.suffix), collide.file(tag, motion, ".json"), collide.file(tag + "_fixed", fixed, fixed.suffix)]
    if frame is not None:
        words += ["--motion-of-fixed", collide.file(tag + "_frame", frame, ".json")]
    out = collide.graze.call("collide", *words, "--closest", tolerance, "--format", "json", *flags)
    # Alone it asks for no verdict: 0, also where they meet.
    if out.returncode not in ((0, 1) if "--clearance" in flags else (0,)):
        collide.checks.fail(name, tolerance, f"exit {out.returncode}: {out.stderr.strip()[:300]}")
        return None
    return json.loads(out.stdout, parse_float=lambda x: F(x))


def at_most(bound, square, radii):
    """bound <= root of `square` less `radii`."""
    return bound + radii < 0 or (bound + radii) ** 2 <= square


def check_nested(checks, name, all_of):
    for wider, narrower in zip(all_of, all_of[1:]):
        checks.holds(wider["low"] <= narrower["low"] <= narrower["high"] <= wider["high"], name, "nested", wider, narrower)


def check_width(checks, name, closest, tolerance):
    """At most the tolerance, and, as each question halves it, not below its half but for the place that is left for rounding."""
    width, spare = closest["high"] - closest["low"], F(closest["high"]) / 2 ** 49
    checks.equal((width > F(tolerance), closest["wide"]), (False, False), name, "width", tolerance, closest)
    checks.holds(width >= F(tolerance) / 2 - spare, name, "questions", tolerance, closest)


def check_places(checks, name, closest):
    a, b = closest["at"]
    apart = to_double(sum((F(x) - F(y)) ** 2 for x, y in zip(a, b))) ** .5
    slack = 1e-13 * (1 + max(abs(to_double(F(x))) for x in a + b))
    checks.holds(to_double(closest["low"]) - slack <= apart <= to_double(closest["high"]) + slack, name, "places", closest)


def check_scene(collide, checks, name, moving, motion, fixed, square, radii, time, frame, meets, x):
    found = []
    for tolerance in TOLERANCES:
        record = ask(collide, name, moving, motion, fixed, tolerance, frame)
        if record is None:
            return
        c = record["closest"]
        found.append(c)
        near = to_double(F(c["near"]))
        if meets:
            checks.equal((c["low"], c["high"], c["at"], c["wide"]), (0, 0, None, False), name, "meets")
            checks.equal(c["t"], record["first"]["from"], name, "first time")
            checks.holds(abs(near - to_double(F(time))) < 1e-15, name, "time", near)
            continue
        checks.holds(at_most(c["low"], square, radii), name, "low", c["low"])
        checks.holds(not at_most(c["high"], square, radii) or (c["high"] + radii) ** 2 == square, name, "high", c["high"])
        if name != "far away" or tolerance != "1e-12":
            check_width(checks, name, c, tolerance)
        else:
            checks.equal(c["wide"], True, name, "doubles are no finer")
        check_places(checks, name, c)
        if time is not None and tolerance == "1e-12":
            checks.holds(abs(near - to_double(F(time))) < 1e-4, name, "time", near)
        if x is not None and tolerance == "1e-12":
            checks.holds(all(abs(to_double(F(p[0]) - q)) < 1e-4 for p, q in zip(c["at"], x)), name, "places", c["at"])
    check_nested(checks, name, found)


def one_pair(collide, checks, name, rng, d, tally):
    pair = Scene(solid(rng, d, rng.randint(1, 2)), some_motion(rng, d), solid(rng, d, 1).mapped(lambda p: tuple(x + 14 for x in p)), F(0), False)
    found = []
    for tolerance in TOLERANCES[:2] if rng.random() < .7 else TOLERANCES:
        record = ask(collide, name, pair.moving, pair.motion, pair.fixed, tolerance)
        if record is None:
            return
        found.append(record["closest"])
    c, start, end = found[-1], pair.motion.start, pair.motion.end
    check_nested(checks, name, found)
    tally["meets" if c["at"] is None else "apart"] += 1
    if c["at"] is None:
        checks.holds(record["word"] != "O", name, "word", record["word"])
        return
    check_places(checks, name, c)
    checks.equal(record["word"], "O", name, "word")
    checks.holds(pair.square(F(c["t"]), True) <= c["high"] ** 2, name, "high at the time", c)
    for k in range(16):
        t = start + (end - start) * F(k, 15)
        checks.holds(c["low"] ** 2 <= pair.square(t, True), name, "low at", t, c)


def forms(collide, checks):
    """Relative to both sizes, 1 + 1; beside a clearance, whose word it does not change; the text."""
    c = ask(collide, "relative", CUBE, along_x(0, 1), WALL, "1e-3r")["closest"]
    checks.equal(c, ask(collide, "absolute", CUBE, along_x(0, 1), WALL, "2e-3")["closest"], "relative")
    # 1 and 2; 2^-4 less a unit in its last place, which a width of 2^-4 is above
    far = ball(1, 9, 9, 9)
    c = ask(collide, "relative", CUBE, along_x(0, 1), far, "1e-3r")["closest"]
    checks.equal(c, ask(collide, "absolute", CUBE, along_x(0, 1), far, "3e-3")["closest"], "relative to a ball")
    check_width(checks, "no spare", ask(collide, "spare", CUBE, along_x(0, 1), WALL, "0.06249999999999978")["closest"], "0.06249999999999978")
    record = ask(collide, "beside", CUBE, along_x(0, 1), WALL, "1e-3", flags=("--clearance", "1"))
    checks.equal((record["closest"], record["word"]), (ask(collide, "alone", CUBE, along_x(0, 1), WALL, "1e-3")["closest"], "OB"), "clearance")
    words = [collide.file("text" + tag, thing, end) for tag, thing, end in (("a", CUBE, ".off"), ("m", along_x(0, 1), ".json"), ("b", WALL, ".off"))]
    told = collide.graze.call("collide", *words, "--closest", "1/8").stdout.splitlines()
    checks.equal(told[:2], ["clear", "word O"], "text")
    checks.holds(told[2].startswith("closest ") and " of MOVING and (" in told[2] and told[2].endswith(" of FIXED"), "text", told)
    still = collide.file("met", along_x(0, 6), ".json")
    checks.equal(collide.graze.call("collide", words[0], still, words[2], "--closest", "1/8").stdout.splitlines()[-1], "closest 0 at 2", "text")


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    collide = Collide(args, checks)
    if args.derived:
        for one in SCENES:
            check_scene(collide, checks, *one)
        forms(collide, checks)
    for d, count in PAIRS.items():
        for k in args.rounds(count, str(d)):
            one_pair(collide, checks, f"{d} {k}", args.random, d, tally)
    print(f"{len(SCENES)} pairs by hand; random: {dict(tally)}")
    checks.finish()


if __name__ == "__main__":
    main()
