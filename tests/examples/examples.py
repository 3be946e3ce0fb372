# suite
"""The worked examples of examples.txt against the program, fields, times and hypothesis.

SPDX-License-Identifier: GPL-3.0-or-later

Every line is run as JSON Lines and as a table, and once more with `--overlap reject`, which must
refuse exactly the pairs marked `meet`. Every file of solids/ and motions/ must be used.
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "agree", "lib"))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

from program import Checks, Graze, options  # noqa: E402
from times import check_canonical  # noqa: E402

DEFINITION = {"regular": "5", "fold": "6", "fold_boundary": "7", "boundary": "8", "exterior": "9"}
NAMES = ("name", "solid", "motion", "point", "word", "i", "t", "k", "case", "class", "pmc", "ends",
         "times")


def examples():
    with open(os.path.join(HERE, "examples.txt"), encoding="utf-8") as f:
        for line in f:
            if line.strip() and not line.startswith("#"):
                fields = [x.strip() for x in line.split("|")]
                yield dict(zip(NAMES, fields, strict=True))


def check_time(checks, got, want, *where):
    """`got` is (from, to) of a contact; `want` the text of the table."""
    if want == "~":
        return
    if not want.startswith("poly"):
        low, _, high = want.partition("..")
        checks.equal(got, (low, high or low), *where)
        return
    poly, _, interval = want[4:].partition(" in ")
    low, _, high = interval.partition("..")
    expected = {"poly": poly.split(), "lo": low, "hi": high}
    if not all(isinstance(t, dict) for t in got):
        checks.fail(*where, f"got {got}, expected {want}")
        return
    for time in got:
        checks.equal({k: time[k] for k in expected}, expected, *where)
        checks.holds(check_canonical(checks, time, *where), *where, "irreducible")


def check(checks, graze, e):
    solid = os.path.join(HERE, "solids", e["solid"])
    motion = os.path.join(HERE, "motions", e["motion"] + ".json")
    point = e["point"].split()
    answers = graze.classify(e["name"], solid, motion, [point], table=True)
    if answers is None:
        return
    answer, meet = answers[0], e["ends"] == "meet"
    want = {k: e[k] for k in ("word", "i", "t", "case", "class", "pmc")}
    ext = e["case"] in ("5", "6", "8", "9")
    want["definition"] = "ext" if ext else DEFINITION[e["class"]]
    checks.equal({k: answer.row[k] for k in want}, want, e["name"], "table")
    checks.equal({k: str(answer.record[k]) for k in want}, want, e["name"], "jsonl")
    inside = (answer.word[0] == "I") + (answer.word[-1] == "I")
    checks.equal((answer.record["i"] + inside) / 2, int(e["k"]), e["name"], "k")
    times = [t.strip() for t in e["times"].split(";")] if e["times"] else []
    if times and checks.equal(len(answer.contacts), len(times), e["name"], "contacts"):
        for contact, want_time in zip(answer.contacts, times):
            check_time(checks, (contact["from"], contact["to"]), want_time, e["name"], want_time)
    csv = graze.write("point.csv", ",".join(point) + "\n")
    out = graze.call("classify", solid, motion, csv, "--overlap", "reject")
    checks.equal(out.returncode, 3 if meet else 0, e["name"], "reject", out.stderr.strip())


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    used = set()
    for e in examples():
        check(checks, graze, e)
        used |= {e["solid"], e["motion"] + ".json"}
    present = {f for d in ("solids", "motions") for f in os.listdir(os.path.join(HERE, d))}
    checks.equal(present, used, "every file is used")
    checks.finish()


if __name__ == "__main__":
    main()
