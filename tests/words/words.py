# suite
"""Every admissible word made to come true, in the plane and extruded in space.

SPDX-License-Identifier: GPL-3.0-or-later

The trajectory of the point (0, y) runs along a straight line from x = 0; letter number q that is
not B occupies (q - 1, q), a B is the point between. Solids of words with equally many such letters
share one motion, hence one run, each word on a line of its own. Three ways to touch: across edges
(`edge`), through convex vertices (`corner`), and along edges for a while (`slide`). In space the
contacts then lie in faces, on upright edges, on level edges or on vertices. Expected fields come
from definitions.py, expected times from the construction.
"""
import itertools
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from definitions import TABLE, admissible, expected, holding  # noqa: E402
from exact import Fraction as F  # noqa: E402
from program import Checks, Graze, options  # noqa: E402
from motion import build, translate  # noqa: E402
from solids import Polygon, box_ring, extruded, ring  # noqa: E402

MAIN = (1, 2, 3, 4, 7)
APART = 10
H = F(1, 8)      # half the length of a slide


def letters(word):
    return word.replace("B", "")


def touching_part(p, y, way):
    """The ring that touches the line from above at (p, y): a tip, or for a slide a flat foot."""
    if way == "slide":
        return ring((p - H, y), (p + H, y), (p + 2 * H, y + F(1, 2)), (p - 2 * H, y + F(1, 2)))
    return ring((p, y), (p + F(1, 4), y + F(1, 2)), (p - F(1, 4), y + F(1, 2)))


def run_part(a, b, y, way, open_start, open_end):
    """The part whose interior the trajectory runs through from a to b."""
    if open_start:
        a -= F(1, 2)
    if open_end:
        b += F(1, 2)
    if way == "corner":
        return ring((a, y), (a + F(1, 4), y - 1), (b - F(1, 4), y - 1), (b, y),
                    (b - F(1, 4), y + 1), (a + F(1, 4), y + 1))
    if way == "slide":
        return ring((a - H, y), (a + H, y), (a + H, y - 1), (b - H, y - 1), (b - H, y),
                    (b + H, y), (b + H, y + 1), (a - H, y + 1))
    return box_ring(a, y - 1, b, y + 1)


def parts_of(word, y, way):
    """The polygon parts that realise the word along the line at height y."""
    core, parts = letters(word), []
    leading = word[0] == "B"
    trailing = word[-1] == "B" and len(word) > 1
    start = 0
    while start < len(core):
        end = start
        if core[start] == "I":
            while end + 1 < len(core) and core[end + 1] == "I":
                end += 1
            outer = run_part(F(start), F(end + 1), y, way, start == 0 and not leading,
                             end == len(core) - 1 and not trailing)
            parts.append([outer] + [touching_part(F(p), y, way)[::-1]
                                    for p in range(start + 1, end + 1)])
        start = end + 1
    for p in range(len(core) + 1):
        near = core[max(p - 1, 0):p + 1]
        inner = 0 < p < len(core)
        if "I" not in near and (inner or (p == 0 and leading) or (p == len(core) and trailing)):
            parts.append([touching_part(F(p), y, way)])
    return parts


def far_part(n):
    """A component no trajectory comes near, narrow enough to miss itself after the motion."""
    return [box_ring(-n - 9, -20, F(-2 * n - 17, 2), -19)]


def times_of(word, way):
    """The contacts' times: place over length, a slide H around it, cut off at the ends."""
    n, out, place = len(letters(word)), [], 0
    for k, letter in enumerate(word):
        if letter != "B":
            place += 1
            continue
        h = H if way == "slide" else 0
        if n == 0:
            out.append(("0", "1"))
        else:
            low, high = max(F(place) - h, F(0)), min(F(place) + h, F(n))
            out.append((str(low / n), str(high / n)))
    return out


def groups(words):
    """Words that share a motion and a reading of the hypothesis: same length, both main or not."""
    out = {}
    for w in words:
        out.setdefault((len(letters(w)), TABLE[w[0], w[-1]] in MAIN), []).append(w)
    return out


def check_rows(checks, answers, words, combined, way, where):
    for word, answer in zip(words, answers or []):
        want = expected(word, combined)
        got = {k: answer.row[k] for k in want}
        checks.equal(got, want, where, word)
        record = {k: str(answer.record[k]) for k in want}
        checks.equal(record, want, where, word, "jsonl")
        spans = [(c["from"], c["to"]) for c in answer.contacts]
        checks.equal(spans, times_of(word, way), where, word, "times")


def batched(graze, checks, args, words):
    """All words, all ways, in the plane and in space, under both readings of folds."""
    spaces = ("plane", None), ("prism", [-1, 1]), ("layers", [-1, 0, 1])
    every = itertools.product(groups(words).items(), ("edge", "corner", "slide"), spaces)
    for ((n, main), group), way, (space, levels) in args.once(every, "batched"):
        lines = [APART * k for k in range(len(group))]
        parts = [p for w, y in zip(group, lines) for p in parts_of(w, y, way)]
        parts.append(far_part(n))
        flat = Polygon(parts)
        solid = flat if levels is None else extruded(flat, levels)[0]
        zero = [] if levels is None else [F(0)]
        motion = build([(0, 1, translate([[0, -n] if n else [0], [0]] + ([[0]] if zero else [])))])
        points = [[F(0), F(y)] + zero for y in lines]
        for folds in ("separate", "combined"):
            where = f"{space} {way} {n} {'main' if main else 'ext'} {folds}"
            flags = ["--folds", folds, "--overlap", "reject" if main else "extend"]
            answers = graze.classify(where, solid, motion, points, *flags, table=True)
            check_rows(checks, answers, group, folds == "combined", way, where)


def alone(graze, checks, args, words):
    """Each word with a solid and a run of its own; `reject` must refuse the extended cases."""
    for word in args.once(words, "alone"):
        n, main = len(letters(word)), TABLE[word[0], word[-1]] in MAIN
        solid = Polygon(parts_of(word, 0, "edge") + [far_part(n)])
        motion = build([(0, 1, translate([[0, -n] if n else [0], [0]]))])
        answers = graze.classify("alone " + word, solid, motion, [(F(0), F(0))], table=True)
        check_rows(checks, answers, [word], False, "edge", "alone")
        # a solid that moves to where it was meets itself, far component and all
        out = graze.call("classify", graze.write("reject.wkt", solid.text()),
                         graze.write("reject.json", motion.text()),
                         graze.write("reject.csv", "0,0\n"), "--overlap", "reject")
        checks.equal(out.returncode, 0 if main and n else 3, "alone reject", word)


def partition(checks, words):
    """Exactly one definition holds, under either reading: disjoint and complete."""
    for word in words:
        if TABLE[word[0], word[-1]] in MAIN:
            for combined in (False, True):
                checks.equal(len(holding(word, combined)), 1, "one definition", word, combined)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    words = admissible(9 + 2 * min(max(0, int(args.scale) - 1), 3))
    nine = admissible(9)
    checks.equal(len(nine), 153, "number of words of up to nine letters: 1 + 4(2+4+8+16) + 32")
    if args.derived:
        partition(checks, admissible(13))
    batched(graze, checks, args, words)
    alone(graze, checks, args, [w for w in nine if len(w) <= 7])
    print(f"{len(words)} words, {graze.runs} runs")
    checks.finish()


if __name__ == "__main__":
    main()
