# suite
"""`collide --first` on boxes along straight legs: what stands just after the first instant of contact.

SPDX-License-Identifier: GPL-3.0-or-later

Two boxes, or unions of boxes without a common interior, in fractions alone. Along an axis two intervals have min of the upper ends minus max of the
lower ones in common; two boxes overlap where that is positive along all axes, touch where it is never negative, else are apart, and a union is in the largest
state of its parts. A box leaves a room where an end of it is beyond along some axis, and touches its wall where one is at an end. All of these are
linear in t on a leg, so states change at ratios of coordinates alone; the state after the first contact is that between it and the next such time.
Coordinates are small, so that most pairs touch along walls, at corners, at the ends of legs. The whole word is asked too: the cut-off one is its prefix.
"""
from collections import Counter
from itertools import product

from pairs import Checks, Collide, first_agrees, options

from exact import Fraction as F  # noqa: E402
from motion import legs  # noqa: E402
from solids import Polygon, block, box_ring, joined  # noqa: E402

PAIRS = 100      # in the plane, and in space


def state_of_parts(one, other, by):
    """State of two lists of boxes (low, high), the first moved."""
    best = "O"
    for (a, b), (c, d) in product(one, other):
        least = min(min(h + s, k) - max(l + s, j) for l, h, j, k, s in zip(a, b, c, d, by))
        best = min(best, "I" if least > 0 else "B" if least == 0 else "O", key="IBO".index)
    return best


def state_inside(one, room, by):
    """State of the boxes and the closed complement of one box."""
    spare = min(x for a, b in one for l, h, j, k, s in zip(a, b, *room[0], by) for x in (l + s - j, k - h - s))
    return "O" if spare > 0 else "B" if spare == 0 else "I"


def critical(one, other, places, times):
    """The times at which two coordinates are one, and those of the legs."""
    found = set(times)
    ends = {(k, q[k] - p[k]) for a, b in product(one, other) for p in a for q in b for k in range(len(p))}
    for s, t, p, q in zip(times, times[1:], places, places[1:]):
        found |= {s + (t - s) * (x - p[k]) / (q[k] - p[k]) for k, x in ends if min(p[k], q[k]) <= x <= max(p[k], q[k]) and p[k] != q[k]}
    return sorted(found)


def place(places, times, t):
    leg = next(k for k in range(len(times) - 1) if t <= times[k + 1])
    share = (t - times[leg]) / (times[leg + 1] - times[leg])
    return [p + (q - p) * share for p, q in zip(places[leg], places[leg + 1])]


def oracle(one, other, places, times, state):
    """(word, next, time of the first contact) of --first."""
    def at(t):
        return state(one, other, place(places, times, t))
    found = critical(one, other, places, times)
    if at(found[0]) == "I":
        return "I", None, found[0]
    first = next((k for k, t in enumerate(found) if at(t) != "O"), None)
    if first is None:
        return "O", None, None
    following = at((found[first] + found[first + 1]) / 2) if first + 1 < len(found) else None
    return "O" * (first > 0) + "B" + (following or "B").replace("B", ""), following, found[first]


def drawn_box(rng, d, far, size):
    low = [F(rng.randint(-far, far), 2) for _ in range(d)]
    return low, [x + F(rng.randint(1, size), 2) for x in low]


def drawn(rng, d, far, size):
    """One box, or two that lie beside one another with a gap, so that their union is legal."""
    low, high = drawn_box(rng, d, far, size)
    if rng.random() < 0.6:
        return [(low, high)]
    k = rng.randrange(d)
    beside = [list(low), list(high)]
    beside[0][k] = high[k] + F(rng.randint(1, 3), 2)
    beside[1][k] = beside[0][k] + F(rng.randint(1, 3), 2)
    return [(low, high), tuple(beside)]


def solid_of(boxes):
    if len(boxes[0][0]) == 2:
        return Polygon([[box_ring(*low, *high)] for low, high in boxes])
    return joined(*(block(*low, *high) for low, high in boxes))


def scene(rng, d):
    """(moving, fixed, places, times, inside)."""
    inside = rng.random() < 0.5
    far = 2 if inside else 6
    one, other = drawn(rng, d, far, 4), drawn(rng, d, 2, 6)
    if inside:
        other = [([F(-rng.randint(3, 5)) for _ in range(d)], [F(rng.randint(3, 5)) for _ in range(d)])]
    count = rng.randint(1, 3)
    places = [[F(0)] * d]
    for _ in range(count):
        moves = [rng.randint(-6, 6) * rng.choice((0, 1, 1)) for _ in range(d)]
        places.append([x + F(m, 2) for x, m in zip(places[-1], moves)])
    if rng.random() < 0.5:
        places.reverse()
    return one, other, places, [F(k) for k in range(count + 1)], inside


def drawn_pair(rng, d):
    """A scene with its answer; most of them have a contact."""
    plain = rng.random() < 0.1
    while True:
        pair = scene(rng, d)
        answer = oracle(*pair[:4], state_inside if pair[4] else state_of_parts)
        if plain or "B" in answer[0]:
            return pair, answer


def one_pair(collide, checks, name, drawn, tally):
    (one, other, places, times, inside), (word, following, when) = drawn
    tally[word, following] += 1
    files = (solid_of(one), legs(places, times), solid_of(other))
    flags = ("--inside",) * inside
    first = collide.ask(name, *files, "--first", *flags)
    if first is None:
        return
    checks.equal((first.word, first.record["next"]), (word, following), name, *flags, "just after the contact")
    checks.equal(first.first and F(first.first["from"]), when, name, *flags, "first contact")
    whole = collide.ask(name, *files, *flags)
    if whole is not None:
        first_agrees(checks, first, whole, name, *flags)


def main():
    args = options(__doc__.splitlines()[0])
    checks, tally = Checks(), Counter()
    collide = Collide(args, checks)
    for d in (2, 3):
        for k in args.rounds(PAIRS, str(d)):
            one_pair(collide, checks, f"{d} {k}", drawn_pair(args.random, d), tally)
    print(", ".join(f"{word} {following or 'end'} {n}" for (word, following), n in tally.most_common()))
    for wanted in (("OBI", "I"), ("OBO", "O"), ("OB", "B"), ("OB", None), ("BI", "I"), ("BO", "O"), ("B", "B"), ("O", None), ("I", None)):
        checks.holds(tally[wanted] > 0 or not args.ample, "no pair", wanted)
    checks.finish()


if __name__ == "__main__":
    main()
