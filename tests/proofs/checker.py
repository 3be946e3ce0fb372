#!/usr/bin/env python3
"""The verified checker, extracted from proofs/coq, held to graze-check: golden cases and mutants.

SPDX-License-Identifier: GPL-3.0-or-later

Every golden case's certificate must be verified, and one of ten generated points of each. Then rows of each, one at a time and changed as
tests/check/mutants.py changes them, are given to both programs, which must agree row by row; a change that
is not among those that may leave a row true must be refused. Motions that ask for endless work
(tests/check/bombs.py) have status 2. A solid is said to be legal, not assumed to be,
if all its vertices are behind the planes of all its simplices, and only then.
"""
import argparse
import json
import os
import resource
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "check"))
sys.path.insert(0, os.path.join(HERE, "..", "motioncmd"))
import lib_certificate as lib  # noqa: E402  it finds the others
import bombs  # noqa: E402
import casefile  # noqa: E402
import evaluate  # noqa: E402
import harness  # noqa: E402
import meshes  # noqa: E402
import mutants  # noqa: E402


def mutants_of(certificate, count, every):
    """(kind, text) of each `every`-th mutant of the first `count` rows."""
    rows = certificate.rows[:count]
    every_one = [m for row in rows for m in mutants.mutants(certificate, row)]
    return every_one[::every]


class Checkers:
    def __init__(self, build, folder):
        self.programs = lib.Programs(os.path.join(build, "graze"))
        self.coq = os.path.join(build, "graze-check-coq")
        self.path = os.path.join(folder, "certificate")

    def both(self, solid, motion, text):
        """(status, message) of graze-check, the same of the verified checker."""
        lib.write(self.path, text)
        status, _, message = self.programs.check("--assume-legal", solid, motion, self.path)
        second = harness.run([self.coq, solid, motion, self.path])
        return (status, message), (second.returncode, second.stderr)


def check_verified(checks, checkers, case, files, points):
    """The certificate of these points, which both must verify."""
    text = checkers.programs.certify(*files, points, lib.answer_options(case.options))
    first, second = checkers.both(*files, text)
    checks.holds(first[0] == lib.VERIFIED, f"{case.name}: graze-check: {first}")
    checks.holds(second[0] == lib.VERIFIED, f"{case.name}: graze-check-coq: {second}")
    return text


def is_convex(printed):
    """No vertex is before a plane, and some are behind each: of the simplices that --print has printed."""
    simplices = [[int(w) for w in line.split()[1:]] for line in printed.splitlines() if line.startswith("simplex")]
    d = int(printed.split()[1])
    vertices = {tuple(s[k:k + d]) for s in simplices for k in range(0, d * d, d)}
    for s in simplices:
        p, *others = (s[k:k + d] for k in range(0, d * d, d))
        edges = [[a - b for a, b in zip(q, p)] for q in others]
        heights = [determinant(edges + [[a - b for a, b in zip(v, p)]]) * (1 if d == 3 else -1) for v in vertices]
        if max(heights) > 0 or min(heights) == 0:
            return False
    return len(simplices) <= 200


def determinant(m):
    if len(m) == 2:
        return m[0][0] * m[1][1] - m[0][1] * m[1][0]
    return sum(m[0][k] * (m[1][k - 2] * m[2][k - 1] - m[1][k - 1] * m[2][k - 2]) for k in range(3))


def check_legal(checks, checkers, case, files):
    """Whether the last certificate's solid is proved legal; which ones are is told by their vertices."""
    done = harness.run([checkers.coq, *files, checkers.path])
    convex = is_convex(harness.run([checkers.coq, "--print", *files]).stdout)
    want = "verified: " if convex else "verified, assuming a legal solid: "
    checks.holds(done.stdout.startswith(want), f"{case.name}: {done.stdout}, expected {want}")
    return convex


def check_motion(checks, checkers, case):
    """The verified checker's reading of a motion against a second reader, at five times a piece."""
    solid, motion = checkers.programs.convert(case, os.path.dirname(checkers.path))
    out = harness.run([checkers.coq, "--print", solid, motion])
    checks.holds(out.returncode == 0, f"{case.name}: {out.stderr}")
    low, high, weight, compared = 0, 0, [], 0
    with open(motion, encoding="utf-8") as file:
        second = evaluate.Motion(json.loads(file.read().replace("^", "**")))
    for line in out.stdout.splitlines():
        key, *words = line.split()
        if key == "piece":
            low, high = map(mutants.Fraction, words)
        elif key == "weight":
            weight = [int(w) for w in words]
        elif key == "entry":
            i, j, *entry = map(int, words)
            for t in (low + (high - low) * mutants.Fraction(k, 4) for k in range(5)):
                want = second.at(t)[i][j - 1]
                got = [sum(c * t ** n for n, c in enumerate(p)) for p in (entry, weight)]
                checks.holds(got[0] == want * got[1], f"{case.name}: entry {i} {j} at {t}: {got}, expected {want}")
                compared += 1
    checks.holds(compared >= 5 * case.dimension * (case.dimension + 1), f"{case.name}: {compared} entries compared")


def check_case(checks, checkers, case, every):
    solid, motion = checkers.programs.convert(case, os.path.dirname(checkers.path))
    generated = checkers.path + ".csv"
    points = harness.run([checkers.programs.graze, "generate", solid, motion, "-n", "10", "--seed", "5",
                          "--quiet", "--operation", case.option("--operation", "sweep")])
    lib.write(generated, points.stdout)
    check_verified(checks, checkers, case, (solid, motion), generated)
    text = check_verified(checks, checkers, case, (solid, motion), case.path("points.csv"))
    convex, tried = check_legal(checks, checkers, case, (solid, motion)), 0
    more = [*lib.answer_options(case.options), "--times"]
    first, second = checkers.both(solid, motion, checkers.programs.certify(solid, motion, generated, more))
    checks.holds(first[0] == lib.VERIFIED, f"{case.name}: graze-check, contacts: {first}")
    checks.holds(second[0] == lib.NOT_CHECKED and "'contacts'" in second[1], f"{case.name}: contacts: {second}")
    for kind, mutant in mutants_of(lib.Certificate(text), 2, every):
        first, second = checkers.both(solid, motion, mutant)
        what = f"{case.name}: {kind}:\n{mutant}graze-check {first}, graze-check-coq {second}"
        checks.holds((first[0] == lib.VERIFIED) == (second[0] == lib.VERIFIED), "they disagree: " + what)
        if kind not in mutants.STILL_TRUE:
            checks.holds(second[0] == lib.REFUTED or second[0] == lib.NOT_CHECKED, "accepted: " + what)
        tried += 1
    return tried, convex


def check_bombs(checks, checkers, folder):
    """The reader ends where a small motion asks for endless work: status 2, one line, within a second of CPU."""
    solid = lib.write(os.path.join(folder, "square.wkt"), meshes.SQUARE)
    plain = lib.write(os.path.join(folder, "plain.json"), meshes.MOVE[2])
    certificate = lib.Certificate(checkers.programs.certify(solid, plain, lib.write(os.path.join(folder, "points.csv"), "9,9\n")))
    for what, text in bombs.MOTIONS.items():
        motion = lib.write(os.path.join(folder, "bomb.json"), text)
        certificate.set("motion-sha256", lib.sha256(motion))
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        (first, _), (second, said) = checkers.both(solid, motion, certificate.text())
        took = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        checks.equal((first, second, said.count("\n")), (lib.NOT_CHECKED, lib.NOT_CHECKED, 1), what, said)
        checks.holds(took < 2, what, "seconds of CPU of both", took)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", default="build")
    parser.add_argument("--only", default="")
    parser.add_argument("--every", type=int, default=32)
    args = parser.parse_args()
    checks, tried, cases, legal = harness.Checks(), 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        checkers = Checkers(args.build, folder)
        check_bombs(checks, checkers, folder)
        for name in casefile.names():
            if args.only in name:
                case = casefile.Case(name)
                mutants_tried, convex = check_case(checks, checkers, case, args.every)
                tried, cases, legal = tried + mutants_tried, cases + 1, legal + convex
                check_motion(checks, checkers, case)
    print(f"graze-check-coq: {cases} cases, {tried} mutants, {legal} solids proved legal")
    checks.holds(args.only or (cases >= 60 and tried >= 900 and 20 <= legal < cases),
                 "too few cases, mutants or solids of a kind")
    checks.finish()


if __name__ == "__main__":
    main()
