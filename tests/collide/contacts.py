# suite
"""The list of first contacts, cases/contacts: its first pairs of each family, with answers that are known by construction.

SPDX-License-Identifier: GPL-3.0-or-later

Head on, the time is the way over the speed. Two edges that cross, and a tip over a face, edge or tip, are apart while the moving
one's lowest point is above the fixed one's highest. A box slides on a box while their sides overlap. A near miss has the sign of its
gap. The list says which word and time follow, and `graze collide --first` must say the same. DART's spline is at the root of
8 t^3 - 12 t^2 + 1: the cube's side x is -2 + 12 t^2 - 8 t^3, and it meets the fixed one where that is -1.
Whole words and all times of pairs of convex solids agree with separating axes (contact_axes.py).
"""
import csv
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F  # noqa: E402
from harness import ROOT, Checks, options, run  # noqa: E402

CONTACTS = os.path.join(ROOT, "cases", "contacts")
sys.path[:0] = [CONTACTS, os.path.join(ROOT, "cases", "benchmark")]

import contact_axes  # noqa: E402
import golden  # noqa: E402
import pairs  # noqa: E402

FACETS = 80     # of both solids, of a pair that separating axes are asked about
KNOWN = ("head-on", "edges", "grazes", "slides", "near-misses")


def first_is_known(checks, graze, out, pair):
    """--first says what the pair was made for."""
    paths = [os.path.join(out, pair[name]) for name in ("moving", "motion", "fixed")]
    done = run([graze, "collide", *paths, "--first", "--format", "json"])
    found = json.loads(done.stdout)
    known = pair["known"].rstrip("+")[:3]
    known = "OB" if pair["family"] == "slides" else known  # the contact lasts
    checks.equal(found["word"], known, f"{pair['id']}: word of --first")
    if pair["known_first"]:
        checks.equal(found["first"]["from"], pair["known_first"], f"{pair['id']}: time of --first")


def ask_list(graze, out):
    return run([sys.executable, os.path.join(CONTACTS, "golden.py"), "--graze", graze, out, "--count", str(golden.FEW)])


def check_list(checks, graze, out):
    """Answers of the first pairs: known ones, hashes."""
    done = ask_list(graze, out)
    checks.equal((done.returncode, done.stdout), (0, "no difference\n"), "the first pairs of each family")
    hashed = {family for family, count in golden.read_hashes() if count == golden.FEW}
    checks.equal(hashed, set(pairs.FAMILIES), "families with a hash of their first pairs")
    table = golden.read_pairs(out)
    for pair in table:
        checks.holds(bool(pair["known"]) == (pair["family"] in KNOWN or pair["id"] == "splines-0000"), "known answers", pair["id"])
        if pair["family"] in KNOWN:
            first_is_known(checks, graze, out, pair)


def check_table(checks, graze, out):
    """The table of the list is golden.csv; a process of its own says the same of each family's first pair."""
    done = run([graze, "collide", "--list", os.path.join(out, "pairs.csv"), "--jobs", "2"])
    rows = list(csv.DictReader(line for line in done.stdout.splitlines() if not line.startswith("#")))
    with open(os.path.join(out, "golden.csv"), encoding="utf-8", newline="") as file:
        known = list(csv.DictReader(line for line in file if not line.startswith("#")))
    with open(os.path.join(out, "golden.jsonl"), encoding="utf-8") as file:
        objects = [json.loads(line) for line in file]
    checks.equal((done.returncode, len(rows)), (1, len(known)), done.stderr)
    for row, want, pair, found in zip(rows, known, golden.read_pairs(out), objects):
        near, named = row.pop("first_near"), want.pop("first_near")
        checks.holds(near == named or float(near) == float(named), pair["id"], near, named)
        checks.equal({name: row[name] for name in want}, want, pair["id"])
        checks.equal((row["family"], row["known"], row["message"]), (pair["family"], pair["known"], ""), pair["id"])
        if pair["id"].endswith("-0000"):
            alone = run([graze, "collide", *(os.path.join(out, pair[name]) for name in ("moving", "motion", "fixed")), "--format", "json"])
            checks.equal({"id": pair["id"], **json.loads(alone.stdout)}, found, "alone")


def check_changed(checks, graze, out):
    """An answer that is changed is noticed."""
    path = os.path.join(out, "slides.jsonl")
    with open(path, encoding="utf-8") as file:
        text = file.read()
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace('"word": "OB', '"word": "OI', 1))
    done = ask_list(graze, out)
    said = done.stdout.splitlines()
    checks.holds(done.returncode == 1 and said[0].startswith("slides-") and "known: OB" in said[0] and "another hash" in said[-1],
                 "a changed answer", said)


def check_axes(checks, out):
    """Words and times of the pairs of convex solids, by separating axes."""
    with open(os.path.join(out, "golden.jsonl"), encoding="utf-8") as file:
        answers = map(json.loads, file)
        asked = [pair["family"] for pair, found in zip(golden.read_pairs(out), answers)
                 if contact_axes.check_pair(checks, out, pair, found, FACETS)]
    # None of the first ten logs has two convex solids of few facets.
    checks.equal(set(asked), set(pairs.FAMILIES) - {"logs"}, "families whose pairs are asked of separating axes")


def check_dart(checks, out):
    with open(os.path.join(out, "golden.csv"), encoding="utf-8") as file:
        row = next(line for line in file if line.startswith("splines-0000"))
    polynomial, low, high = row.split("root(")[1].split(")")[0].split(";")
    checks.equal(polynomial, "1 0 -12 8", "DART's polynomial")
    values = [8 * t ** 3 - 12 * t ** 2 + 1 for t in (F(low), F(high))]
    checks.holds(values[0] * values[1] < 0 and 0 <= F(low) < F(high) <= 1, "its interval", row)


def main():
    chosen, checks = options(__doc__), Checks()
    with tempfile.TemporaryDirectory() as out:
        check_list(checks, chosen.graze, out)
        check_dart(checks, out)
        check_axes(checks, out)
        check_table(checks, chosen.graze, out)
        check_changed(checks, chosen.graze, out)
    checks.finish()


if __name__ == "__main__":
    main()
