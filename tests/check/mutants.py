"""Certificates changed in every way that matters, and forged ones: none that says something untrue
is accepted.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

Each mutant of each chosen row is given to graze-check. It must be refuted, unless its kind is in
STILL_TRUE: then it may be accepted, and what it says of each point must be what graze says. At
least 1000 mutants over at least 30 scenes, hashes being right unless they are what is changed.
With --scale N, N > 1, all mutants of N + 2 rows of each scene, else every twelfth of three rows and all
forgeries.
"""
import collections
import concurrent.futures
import copy
import itertools
import os
import tempfile

from lib_certificate import (Certificate, NOT_CHECKED, Programs, REFUTED, VERIFIED, answer_options,
                             write)
from exact import Fraction
import casefile
from harness import ONLY, Checks, options

# Why a mutant of this kind may be accepted.
STILL_TRUE = {
    "time between": "an interval's end may lie elsewhere if the tests succeed there too",
    "two as one": "fewer hints may be enough",
    "interval dropped": "the next interval, longer by this one, may pass the tests too",
    "degree more": "t q has no root more on the interval",
    "root negated": "-q has the same roots",
    "root doubled": "q is made primitive",
    "coefficient": "a polynomial that happens to be a multiple of q on the interval",
    "point moved": "another point may have the same word by the same intervals",
    "scene hash": "it is compared with a table's alone",
    "folds": "a row without folds is the same by both conventions",
}


def end_of(row, k, start):
    return Fraction(row.intervals[k][1]) if k >= 0 else start


def changed(row, k, interval):
    out = copy.deepcopy(row)
    out.intervals[k] = interval
    return out


def times(row, start):
    """Changes of an interval's end."""
    for k, interval in enumerate(row.intervals):
        low, here = end_of(row, k - 1, start), end_of(row, k, start)
        for kind, time in (("time back", low), ("time before", low - 1), ("time between", (low + here) / 2),
                           ("time unread", None)):
            text = "1/0" if time is None else str(time)
            yield kind, changed(row, k, [interval[0], text, *interval[2:]])
        if k + 1 < len(row.intervals):
            after = end_of(row, k + 1, start)
            yield "time at next", changed(row, k, [interval[0], str(after), *interval[2:]])
            yield "time between", changed(row, k, [interval[0], str((here + after) / 2), *interval[2:]])
        else:
            yield "time past t1", changed(row, k, [interval[0], str(here + 1), *interval[2:]])


def roots(row, start):
    """Changes of an interval's polynomial."""
    for k, interval in enumerate(row.intervals):
        head, c = interval[:2], [int(x) for x in interval[2:]]
        if not c:
            yield "root too much", changed(row, k, [*head, "-1", "2"])
            continue
        for n in range(len(c)):
            for change in (1, -1):
                other = c[:n] + [c[n] + change] + c[n + 1:]
                yield "coefficient", changed(row, k, [*head, *map(str, other)])
            other = c[:n] + [-c[n]] + c[n + 1:]
            if c[n] and len([x for x in c if x]) > 1:
                yield "sign of a coefficient", changed(row, k, [*head, *map(str, other)])
        square = [sum(c[i] * c[n - i] for i in range(len(c)) if 0 <= n - i < len(c))
                  for n in range(2 * len(c) - 1)]
        mid = (end_of(row, k - 1, start) + end_of(row, k, start)) / 2
        second = [-mid.numerator, mid.denominator]
        twice = [sum(c[i] * second[n - i] for i in range(len(c)) if 0 <= n - i < 2)
                 for n in range(len(c) + 1)]
        for kind, other in (("root dropped", []), ("degree less", c[:-1]), ("degree more", [0, *c]),
                            ("root squared", square), ("root negated", [-x for x in c]),
                            ("root doubled", [2 * x for x in c]), ("root zero", [0, 0]),
                            ("two roots", twice), ("root constant", [1])):
            if kind == "two roots" and mid * c[1] + c[0] == 0 and len(c) == 2:
                continue
            yield kind, changed(row, k, [*head, *map(str, other)])
        yield "root unread", changed(row, k, [*head, *map(str, c[:-1]), "x"])


def kinds(row):
    """Other letters of one interval, the row's word following."""
    for k, interval in enumerate(row.intervals):
        for n in range(len(interval[0])):
            for letter in "IBO":
                if letter == interval[0][n]:
                    continue
                kind = interval[0][:n] + letter + interval[0][n + 1:]
                yield "letter of an interval", changed(row, k, [kind, *interval[1:]])
        yield "kind unknown", changed(row, k, ["X", *interval[1:]])


def order(row):
    """Intervals dropped, doubled, exchanged, joined."""
    for k in range(len(row.intervals)):
        out = copy.deepcopy(row)
        gone = out.intervals.pop(k)
        yield ("two as one" if k < len(row.intervals) - 1 and gone[0] == row.intervals[k + 1][0]
               and len(gone[0]) == 1 else "interval dropped"), out
        out = copy.deepcopy(row)
        out.intervals.insert(k, list(out.intervals[k]))
        yield "interval doubled", out
        if k + 1 < len(row.intervals):
            out = copy.deepcopy(row)
            out.intervals[k:k + 2] = [out.intervals[k + 1], out.intervals[k]]
            yield "intervals exchanged", out


def claims(row):
    """Other words, and other values of what follows from the word."""
    for k in range(1, len(row.claims)):
        out = copy.deepcopy(row)
        out.claims[k] = {"in": "on", "on": "out", "out": "in"}.get(row.claims[k], "7" if row.claims[k] != "7" else "6")
        yield "claim", out
        out = copy.deepcopy(row)
        out.claims.pop(k)
        yield "claim missing", out
    for other in {row.word + "O", row.word[1:], row.word[:-1], "O" + row.word, row.word + "BI"} - {"", row.word}:
        out = copy.deepcopy(row)
        out.claims[0] = other
        yield "word alone", out
    out = copy.deepcopy(row)
    out.claims.append("0")
    yield "claim too much", out


def points(row):
    for k in range(len(row.point)):
        for step in (Fraction(1, 2), Fraction(-1, 2 ** 40), 10 ** 6):
            out = copy.deepcopy(row)
            out.point[k] = str(Fraction(row.point[k]) + step)
            yield "point moved", out
    out = copy.deepcopy(row)
    out.point = out.point[:-1]
    yield "point shorter", out


def forged(row, certificate, start):
    """Consistent in themselves: the intervals say another word, and all claims follow from it."""
    def consistent(out):
        out.claim(out.spelled(), certificate.unsweep, certificate.combined)
        return out
    turned = {"O": "I", "I": "O", "B": "B"}
    out = copy.deepcopy(row)
    for interval in out.intervals:
        interval[0] = "".join(turned[letter] for letter in interval[0])
    if "".join(turned[x] for x in row.word) != row.word:
        yield "forged: in and out", consistent(out)
    yield from denied(row, consistent)
    for k in range(1, len(row.intervals)):
        out = copy.deepcopy(row)
        del out.intervals[k:]
        if out.spelled() != row.word:
            yield "forged: ends early", consistent(out)
    out = copy.deepcopy(row)
    out.intervals = [["B", interval[1]] for interval in row.intervals]
    if row.word != "B":
        yield "forged: on the boundary all the time", consistent(out)
    for k, interval in enumerate(row.intervals):
        kind, mid = interval[0], (end_of(row, k - 1, start) + end_of(row, k, start)) / 2
        linear = [str(-mid.numerator), str(mid.denominator)]
        if len(kind) == 3 and kind[0] == kind[2] and kind != "BBB":
            yield "forged: a touch denied", consistent(changed(row, k, [kind[0], interval[1]]))
        if len(kind) == 2:
            yield "forged: an end denied", consistent(changed(row, k, [kind.replace("B", ""), interval[1]]))
        if kind == "B":
            for letter in "OI":
                yield "forged: a slide denied", changed(row, k, [letter, interval[1]])
        if kind in ("O", "I"):
            yield "forged: a touch invented", consistent(changed(row, k, [kind + "B" + kind, interval[1], *linear]))
            yield "forged: a slide invented", changed(row, k, ["B", interval[1]])
            other = turned[kind]
            rest = copy.deepcopy(row)
            rest.intervals[k] = [kind + "B" + other, interval[1], *linear]
            for later in rest.intervals[k + 1:]:
                later[0] = "".join(turned[x] for x in later[0])
            yield "forged: a crossing invented", consistent(rest)
        if len(kind) == 3:
            yield from joined(row, k, consistent)
        if len(kind) == 3 and {kind[0], kind[2]} == {"O", "I"}:
            rest = copy.deepcopy(row)
            rest.intervals[k] = [kind[0] + "B" + kind[0], *interval[1:]]
            for later in rest.intervals[k + 1:]:
                later[0] = "".join(turned[x] for x in later[0])
            yield "forged: a crossing as a touch", consistent(rest)


def denied(row, consistent):
    """Whole contacts left out: clear intervals in their place; what comes after a crossing is turned."""
    k = 0
    while k < len(row.intervals):
        first = k
        while "B" in row.intervals[k][0] and row.intervals[k][0][-1] == "B" and k + 1 < len(row.intervals):
            k += 1
        letters = [x for x in (row.intervals[first][0][0], row.intervals[k][0][-1]) if x != "B"]
        if "B" in "".join(i[0] for i in row.intervals[first:k + 1]) and letters:
            out = copy.deepcopy(row)
            for interval in out.intervals[first:k + 1]:
                interval[:] = [letters[0], interval[1]]
            if letters[0] != letters[-1]:
                for later in out.intervals[k + 1:]:
                    later[0] = later[0].translate(str.maketrans("IO", "OI"))
            yield "forged: a contact denied", consistent(out)
        k += 1


def product(a, b):
    return [sum(int(a[i]) * int(b[n - i]) for i in range(len(a)) if 0 <= n - i < len(b))
            for n in range(len(a) + len(b) - 1)]


def joined(row, k, consistent):
    """Two roots as one: of the product of their polynomials, with what lies between left out."""
    first = row.intervals[k]
    for j in range(k + 1, len(row.intervals)):
        last = row.intervals[j]
        if len(last[0]) == 1 and last[0] != "B":
            continue
        if len(last[0]) == 3:
            out = copy.deepcopy(row)
            out.intervals[k:j + 1] = [[first[0][0] + "B" + last[0][2], last[1],
                                       *map(str, product(first[2:], last[2:]))]]
            yield "forged: two contacts as one", consistent(out)
        return


def whole(certificate):
    """Changes of the head and of the end."""
    for k in range(len(certificate.head)):
        out = copy.deepcopy(certificate)
        out.head.pop(k)
        yield "head line dropped", out
    for key, kind in (("solid-sha256", "other hash"), ("motion-sha256", "other hash"),
                      ("scene-sha256", "scene hash")):
        out = copy.deepcopy(certificate)
        out.set(key, "0" * 64)
        yield kind, out
    for key, a, b in (("dimension", "2", "3"), ("operation", "sweep", "unsweep"), ("folds", "separate", "combined")):
        out = copy.deepcopy(certificate)
        out.set(key, b if certificate.value(key) == a else a)
        yield key, out
    out = copy.deepcopy(certificate)
    out.set("graze-certificate", "2")
    yield "version", out
    signs = next(k for k, line in enumerate(certificate.head) if line[0] == "signs")
    line = certificate.head[signs]
    for kind, other in (("signs from later", line[:1] + line[2:]), ("signs to earlier", line[:-1]),
                        ("signs backwards", line[:1] + line[:0:-1]), ("signs past t1", line + ["1000000"]),
                        ("signs twice", line + line[-1:]), ("signs unread", line + ["x"])):
        out = copy.deepcopy(certificate)
        out.head[signs] = other
        yield kind, out
    for count in ("0", "1000", "-1", "x"):
        out = copy.deepcopy(certificate)
        out.end = ["complete", count]
        yield "number of rows", out
    for end in ([], ["complete"], certificate.end + ["0"]):
        out = copy.deepcopy(certificate)
        out.end = end or ["row"]
        yield "end", out


def mutants(certificate, row):
    start = Fraction(next(line for line in certificate.head if line[0] == "signs")[1])
    alone = certificate.only([row])
    changes = (times(row, start), roots(row, start), kinds(row), order(row), claims(row), points(row),
               forged(row, certificate, start))
    for kind, out in itertools.chain(*changes):
        yield kind, alone.only([out]).text()
    for kind, out in whole(alone):
        yield kind, out.text()
    text = alone.text()
    lines = text.splitlines(keepends=True)
    for k in range(len(lines)):
        yield "truncated", "".join(lines[:k])
    yield "truncated", text[:-len(lines[-1]) // 2 - 2]
    yield "text after the end", text + "row\n"
    yield "byte 0 in the word", text.replace(" " + row.word + " ", " " + row.word + "\0O ", 1)


def is_true(programs, case, folder, certificate):
    """An accepted certificate gives each row the answer that graze gives."""
    c = Certificate(certificate)
    points = write(os.path.join(folder, "points.csv"), "".join(",".join(r.point) + "\n" for r in c.rows))
    more = ["--folds", c.value("folds"), "--operation", c.value("operation")]
    table = programs.table(*case.converted, points, more)
    rows = [l.split(",") for l in table.splitlines() if not l.startswith("#")][1:]
    order = [6, 0, 1, 2, 3, 4, 5] if not c.unsweep else [1, 0]
    d = int(c.value("dimension"))
    return len(rows) == len(c.rows) and all(
        [cells[d + k] for k in order] == row.claims[:len(order)] for cells, row in zip(rows, c.rows))


def chosen_rows(certificate, count):
    """Rows of different words, the longest first."""
    by_word = {row.word: row for row in certificate.rows if len(row.intervals) <= 40}
    return sorted(by_word.values(), key=lambda r: -len(r.word))[:count]


class Judge:
    def __init__(self, programs, tally, folder):
        self.programs, self.tally, self.folder = programs, tally, folder
        self.refuted, self.accepted = collections.Counter(), collections.Counter()

    def judge(self, case, number, kind, text):
        folder = os.path.join(self.folder, str(number))
        os.makedirs(folder, exist_ok=True)
        path = write(os.path.join(folder, "certificate"), text)
        status, out, error = self.programs.check(*case.converted, path)
        if status in (REFUTED, NOT_CHECKED):
            return kind, None, f"{case.name}: {kind}: {error}" if not error else None
        if status != VERIFIED or not out.startswith("verified: "):
            return kind, None, f"{case.name}: {kind}: status {status}"
        right = kind in STILL_TRUE and is_true(self.programs, case, folder, text)
        keep = None if right else f"{case.name}: {kind}: accepted\n{text}"
        return kind, "accepted", keep


def main():
    wanted = options(__doc__, ONLY)
    programs, tally = Programs(wanted.graze), Checks()
    scenes = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        judge = Judge(programs, tally, folder)
        every = [(n, name) for n, name in enumerate(casefile.names()) if wanted.only in name]
        some = every if wanted.only else every[::2]
        for n, name in wanted.once(some, "cases", [pair for pair in every if pair not in some]):
            case = casefile.Case(name)
            place = os.path.join(folder, name)
            os.makedirs(place)
            case.converted = programs.convert(case, place)
            certificate = Certificate(programs.certify(*case.converted, case.path("points.csv"),
                                                       answer_options(case.options)))
            scenes += 1
            jobs = [(case, f"{n}-{r}-{k}", kind, text)
                    for r, row in enumerate(chosen_rows(certificate, max(1, int(wanted.scale)) + 2))
                    for k, (kind, text) in enumerate(mutants(certificate, row))
                    if wanted.scale > 1 or (k + n) % 12 == 0 or kind.startswith("forged")]
            for kind, accepted, failure in pool.map(lambda job: judge.judge(*job), jobs):
                (judge.accepted if accepted else judge.refuted)[kind] += 1
                tally.holds(failure is None, failure)
    total = sum(judge.refuted.values()) + sum(judge.accepted.values())
    print(f"{total} mutants over {scenes} scenes, {sum(judge.refuted.values())} refused")
    for kind, count in sorted(judge.accepted.items()):
        print(f"  accepted, and true: {count} of {count + judge.refuted[kind]}, {kind}: {STILL_TRUE.get(kind)}")
    if not wanted.only:
        tally.holds(total >= 1000 * wanted.share and scenes >= 30 * wanted.share, "at least 1000 mutants over 30 scenes")
        tally.holds(len([k for k in judge.refuted if k.startswith("forged")]) >= 8, "each kind of forgery occurs")
    tally.finish()


if __name__ == "__main__":
    main()
