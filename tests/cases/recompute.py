"""Every word and time of every case once more, without a line of Graze.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

PARI's gp follows each point of each case through the solid (trace.gp, motion.gp; one process for
all) and finds word, times and cells; through curved solids curvedtrace.py does. They must be those
of the README's table, and expected.csv must say what follows from the word. Without gp cases of
polyhedra are one skip.
"""
import os
import shutil
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "lib"))

import casefile  # noqa: E402
import curvedfile  # noqa: E402
import curvedtrace  # noqa: E402
from exact import Fraction as F  # noqa: E402
from harness import ONLY, Checks, bounded, options, run  # noqa: E402
from motionfile import motion_of  # noqa: E402
from solidfile import facets_of, gp_facet  # noqa: E402
from times import same_root, same_time  # noqa: E402
from words import read, unswept  # noqa: E402


def script(case, name):
    """The gp text that answers all points of a case."""
    facets = "[" + ",".join(gp_facet(*f) for f in enumerate(facets_of(case.path(case.solid)))) + "]"
    unsweep = case.option("--operation", "sweep") == "unsweep"
    lines = [f"facets = {facets};", "motion = [];",
             f"iferr(motion = {motion_of(case.path('motion.json'))}, E, print(\"{name}: \", E));"]
    if not unsweep:
        lines.append("motion = [[p[1], p[2], p[3]^-1] | p <- motion];")
    for id, point in case.points:
        place = "[" + ",".join(str(F(x)) for x in point) + "]"
        lines.append(f'iferr(answer("{name} {id}", motion, {place}, facets), E, '
                     f'print("answer {name} {id} error ", E));')
    return "\n".join(lines) + "\n"


def time_of(text):
    if "@" not in text:
        return None, F(text), F(text)
    polynomial, low, high = text.split("@")
    return [F(c) for c in polynomial.strip("[]").split(",")], F(low), F(high)


def answers_of(text):
    """(case, id) -> (word, [(from, to)], [cells])."""
    out = {}
    for line in text.splitlines():
        head, *met = line.split("|")
        words = head.split()
        if words[:1] != ["answer"] or words[3] == "error":
            print("gp:", line)
            continue
        ends = zip(map(time_of, met[::3]), map(time_of, met[1::3]))
        out[words[1], words[2]] = words[3], list(ends), [c.strip() for c in met[2::3]]
    return out


def curved_answers(case):
    """The answers of a case of a curved solid; a time is (polynomial, low, high) or a bracket (low, high)."""
    def time(event):
        if isinstance(event, tuple):
            return event
        if event.settle() is not None:
            return None, event.value, event.value
        return [F(c) for c in event.poly], event.lo, event.hi
    solid, motion = curvedfile.Solid(case.path(case.solid)), curvedfile.motion_of(case.path("motion.json"))
    out = {}
    for id, point in case.points:
        word, spans = curvedtrace.follow(solid, motion, tuple(map(F, point)), case.option("--operation", "sweep") == "unsweep")
        out[case.name, id] = word, [(time(a), time(b)) for a, b in spans], None
    return out


def time_holds(got, want):
    """A bracket holds a rational time; a polynomial of curvedtrace.py may be a multiple of the minimal one."""
    if len(got) == 2:
        return want[0] is None and got[0] <= want[1] <= got[1]
    return same_time(got, want) if got[0] is None or want[0] is None else same_root(got, want)


def check(checks, case, answers):
    rows = {row.get("id"): row for row in case.expected}
    combined = case.option("--folds", "separate") == "combined"
    for id, point in case.points:
        where = (case.name, id)
        if not checks.holds(where in answers, "gp gave no answer", *where):
            continue
        word, spans, cells = answers[where]
        want_word, want_spans, want_cells = case.table.get(id, ("", [], None))
        checks.equal(word, want_word, *where, "word of the README")
        row = rows.get(id, {})
        fields = ({"pmc": unswept(word)} if case.option("--operation", "sweep") == "unsweep"
                  else read(word, combined))
        fields.update(word=word, **{axis: str(F(x)) for axis, x in zip("xyz", point)})
        checks.equal({k: row.get(k) for k in fields}, fields, *where, "expected.csv")
        same = len(spans) == len(want_spans) and all(
            time_holds(g, w) for got, want in zip(spans, want_spans) for g, w in zip(got, want))
        checks.holds(same, f"times {spans}, the README has {want_spans}", *where)
        if want_cells and cells is not None:
            checks.equal(cells, want_cells, *where, "cells")


def check_curved(checks, args):
    points = 0
    for name in args.once(n for n in casefile.all_names() if casefile.is_curved(n) and args.only in n):
        try:
            case = casefile.Case(name)
            check(checks, case, curved_answers(case))
            points += len(case.points)
        except (casefile.CaseError, ValueError, OSError, KeyError) as wrong:
            checks.holds(False, str(wrong), name)
    print(f"{points} points of curved solids")
    return points


def main():
    args, checks = options(__doc__, ONLY), Checks()
    curved = check_curved(checks, args)
    if not shutil.which("gp"):
        checks.skip("gp", "PARI's gp is not installed (Debian package pari-gp)")
        checks.finish()
    cases, text = [], ""
    text += "".join(f'read("{os.path.join(HERE, f)}");\n' for f in ("motion.gp", "trace.gp"))
    for name in args.once(name for name in casefile.names() if args.only in name):
        try:
            case = casefile.Case(name)
            text += script(case, name)
            cases.append(case)
        except (casefile.CaseError, ValueError, OSError, KeyError) as wrong:
            checks.holds(False, str(wrong), name)
    with tempfile.NamedTemporaryFile("w", suffix=".gp") as file:
        file.write(text)
        file.flush()
        done = run(bounded(["gp", "-q", "-f", "-D", "parisizemax=2G", file.name]), 600)
    answers = answers_of(done.stdout + done.stderr)
    checks.equal(done.returncode, 0, "gp's exit status")
    for case in cases:
        check(checks, case, answers)
    checks.holds(bool(cases) or curved > 0, "there are cases")
    print(f"{len(cases)} cases, {sum(len(c.points) for c in cases)} points")
    checks.finish()


if __name__ == "__main__":
    sys.exit(main())
