"""Times and cells of contacts in certificates: those of the golden cases, and wrong ones.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

Certificates with --times of every golden case, of its points and 20 * --scale generated ones, are verified. Those of its points must have
the times and cells that the case's README derives, cells where the solid's own file can be certified, whose numbers
they have; and for all points those of JSON Lines. Each contact of some rows is then changed in every way that matters, and each time
refuted.
"""
import collections
import copy
import json
import os
import tempfile

from lib_certificate import Certificate, Programs, REFUTED, VERIFIED, answer_options, run, write
from exact import Fraction
import casefile
from harness import ONLY, Checks, options
from times import given_time, roots_between, same_time, times_polynomial

KINDS = ("face", "edge", "vertex")


def take_time(words):
    """The TIME at the front of a line, taken off it."""
    if words.pop(0) != "root":
        raise ValueError("no root")
    low, high, c = words.pop(0), words.pop(0), []
    while words and words[0] not in ("to", *KINDS):
        c.append(Fraction(words.pop(0)))
    if roots_between(c, Fraction(low), Fraction(high)) != 1:
        raise ValueError(f"{c}: not exactly one root between {low} and {high}")
    return c, Fraction(low), Fraction(high)


def read_contact(line):
    """(from, to, cells) of a contact's line, cells as the README of a case has them."""
    words, ends = list(line[1:]), []
    while not ends or words[0] == "to":
        if ends:
            words.pop(0)
        if words[0] == "root":
            ends.append(take_time(words))
        else:
            number = Fraction(words.pop(0))
            ends.append((None, number, number))
    return ends[0], ends[-1], " ".join(words)


def cells_of(features):
    """The cells of a contact of JSON Lines, likewise."""
    out = []
    for feature in features:
        (kind, number), = feature.items()
        out.append(f"{kind} " + ("-".join(map(str, number)) if kind == "edge" else str(number)))
    return " ".join(out)


def check_contacts(tally, row, wanted, *place):
    """`wanted`: (from, to, cells or None) of each contact."""
    if not tally.equal(len(row.contacts), len(wanted), *place, "number of contacts"):
        return
    for (_, line), (low, high, cells) in zip(row.contacts, wanted):
        got = read_contact(line)
        tally.holds(same_time(got[0], low) and same_time(got[1], high), *place, f"times of {line}")
        if cells is not None:
            tally.equal(got[2], cells, *place, "cells")


def check_lines(tally, programs, name, files, certificate, more):
    """Against graze classify --format jsonl."""
    done = run(programs.graze, "classify", *files, *more, "--format", "jsonl", "--quiet")
    records = [json.loads(line) for line in done[1].splitlines()]
    tally.equal(len(records), len(certificate.rows), name, "records")
    for k, (row, record) in enumerate(zip(certificate.rows, records)):
        wanted = [(given_time(c["from"]), given_time(c["to"]), cells_of(c["features"])) for c in record["contacts"]]
        check_contacts(tally, row, wanted, name, f"row {k}")


def check_points(tally, programs, name, files, folder, more):
    """A certificate with contacts, verified; or None where the solid cannot be certified."""
    status, text, error = run(programs.graze, "certify", *files, *more, "--times", "--quiet")
    if status == 3 and "is not the fan of its first corner" in error:
        return None
    tally.equal(status, 0, name, error)
    path = write(os.path.join(folder, "certificate"), text)
    status, out, error = programs.check(*files[:2], path)
    out_wanted = f"verified: {len(Certificate(text).rows)} rows\n"
    tally.equal((status, out), (VERIFIED, out_wanted), name, os.path.basename(files[2]), error)
    certificate, plain = Certificate(text), Certificate(programs.certify(*files, more))
    tally.equal([row.lines()[0] for row in certificate.rows], [row.lines()[0] for row in plain.rows], name, "rows without times")
    check_lines(tally, programs, name, files, certificate, more)
    return certificate


def scenes_of(programs, case, folder):
    """(the solid is the case's own, [solid, motion]): the solid as converted, and as it is where graze-check reads such files."""
    solid, motion = programs.convert(case, folder)
    yield False, [solid, motion]
    if case.solid.endswith((".off", ".wkt")):
        yield True, [case.path(case.solid), motion]


def check_known(tally, programs, case, folder):
    """The certificates of its points: words, times and cells are those of its README."""
    for own, scene in scenes_of(programs, case, folder):
        certificate = check_points(tally, programs, case.name, [*scene, case.path("points.csv")], folder, answer_options(case.options))
        if not certificate:
            continue
        for row, (id, _) in zip(certificate.rows, case.points):
            word, spans, cells = case.table[id]
            tally.equal(row.word, word, case.name, id, "word")
            named = cells if cells and (own or case.dimension == 2) else [None] * len(spans)
            check_contacts(tally, row, [(*span, c) for span, c in zip(spans, named)], case.name, id)


def check_generated(tally, programs, case, folder, count):
    points = os.path.join(folder, "points.csv")
    for own, scene in scenes_of(programs, case, folder):
        if not own:
            write(points, run(programs.graze, "generate", *scene, "-n", str(count), "--seed", "3", "--quiet",
                              "--operation", case.option("--operation", "sweep"))[1])
        check_points(tally, programs, case.name, [*scene, points], folder, answer_options(case.options))


# ------------------------------------------------------------------------------------- wrong ones

def with_line(row, k, line):
    out = copy.deepcopy(row)
    out.contacts[k] = (out.contacts[k][0], line)
    return out


def wrong_cells(line):
    """(kind of change, line)"""
    first = min(k for k, word in enumerate(line) if word in KINDS)
    cells = [line[k:k + 2] for k in range(first, len(line), 2)]

    def joined(other):
        return line[:first] + [word for cell in other for word in cell]
    for k, (kind, number) in enumerate(cells):
        a, _, b = number.partition("-")
        other = [kind, f"{int(a) + 1}-{int(b) + 1}" if b else str(int(a) + 1)]
        yield "another cell", joined(cells[:k] + [other] + cells[k + 1:])
        for name in set(KINDS) - {kind}:
            wrong = f"{a}-{int(a) + 1}" if name == "edge" else a
            yield "another kind of cell", joined(cells[:k] + [[name, wrong]] + cells[k + 1:])
        if b:
            yield "an edge turned", joined(cells[:k] + [[kind, f"{b}-{a}"]] + cells[k + 1:])
        yield "a cell dropped", joined(cells[:k] + cells[k + 1:])
        yield "a cell twice", joined(cells[:k] + [cells[k]] + cells[k:])
        if k > 0:
            yield "cells exchanged", joined(cells[:k - 1] + [cells[k], cells[k - 1]] + cells[k + 1:])
    yield "a cell more", joined([*cells, ["vertex", "999999"]])
    yield "no number", line[:-1]


def wrong_times(line):
    for k, word in enumerate(line):
        if k > 0 and (line[k - 1] in ("contact", "to")) and word != "root":
            yield "another time", line[:k] + [str(Fraction(word) + Fraction(1, 1000))] + line[k + 1:]
            yield "a time not in lowest terms", line[:k] + [f"{2 * Fraction(word).numerator}/{2 * Fraction(word).denominator}"] + line[k + 1:]
        if word == "root":
            yield from wrong_roots(line, k)
        if word == "to":
            end = min(j for j, w in enumerate(line) if w in KINDS)
            yield "no end", line[:k] + line[end:]
            yield "ends exchanged", line[:1] + line[k + 1:end] + ["to"] + line[1:k] + line[end:]
    if "to" not in line:
        end = min(j for j, w in enumerate(line) if w in KINDS)
        yield "an end more", line[:end] + ["to"] + line[1:end] + line[end:]


def wrong_roots(line, k):
    low, high = Fraction(line[k + 1]), Fraction(line[k + 2])
    end = next(j for j, w in enumerate(line) if j > k and w in ("to", *KINDS))
    c, width = [int(x) for x in line[k + 3:end]], high - low

    def made(low, high, c):
        return line[:k + 1] + [str(low), str(high), *map(str, c)] + line[end:]
    yield "an interval behind the root", made(high, high + width, c)
    yield "an interval before the root", made(low - width, low, c)
    yield "a longer interval", made(low - width, high + width, c)
    yield "an interval turned", made(high, low, c)
    mid = (low + high) / 2
    yield "two roots", made(low, high, times_polynomial(c, [-mid.numerator, mid.denominator]))
    yield "no root", made(low, high, [1])
    for j in range(len(c)):
        yield "another coefficient", made(low, high, c[:j] + [c[j] + 1] + c[j + 1:])
    yield "a multiple", made(low, high, [2 * x for x in c])
    yield "the negative", made(low, high, [-x for x in c])


def wrong_rows(row):
    for k, (before, line) in enumerate(row.contacts):
        for kind, other in (*wrong_cells(line), *wrong_times(line)):
            yield kind, with_line(row, k, other)
        out = copy.deepcopy(row)
        out.contacts.pop(k)
        yield "a contact dropped", out
        out = copy.deepcopy(row)
        out.contacts.insert(k, (before, line))
        yield "a contact twice", out
        out = copy.deepcopy(row)
        out.contacts[k] = (before - 1, line)
        yield "a contact too early", out
        if k > 0 and line != row.contacts[k - 1][1]:
            out = copy.deepcopy(row)
            out.contacts[k - 1:k + 1] = [(row.contacts[k - 1][0], line), (before, row.contacts[k - 1][1])]
            yield "contacts exchanged", out
    out = copy.deepcopy(row)
    line = row.contacts[0][1] if row.contacts else ["contact", "1/2", "face", "0"]
    out.contacts.insert(0, (0, line))
    yield "a contact invented", out
    if row.contacts:
        out = copy.deepcopy(row)
        out.contacts.append((len(row.intervals), line))
        yield "a contact at the end", out


def wrong_heads(certificate):
    at = next(k for k, line in enumerate(certificate.head) if line[0] == "contacts")
    for other in ([], [["contacts"]], [["contacts", "no"]], [["contacts", "yes", "yes"]], [["contacts", "yes"]] * 2):
        out = copy.deepcopy(certificate)
        out.head[at:at + 1] = other
        if other or any(row.contacts for row in certificate.rows):
            yield "the head's line", out.text()
    out = copy.deepcopy(certificate)
    for row in out.rows:
        row.contacts = []
    if out.text() != certificate.text():
        yield "all contacts dropped", out.text()


def check_wrong(tally, programs, case, folder, count, seen):
    """Every change of some rows, of different words, is refuted."""
    name, (solid, motion) = case.name, programs.convert(case, folder)
    certificate = Certificate(programs.certify(solid, motion, case.path("points.csv"), [*answer_options(case.options), "--times"]))
    by_word = {row.word: row for row in certificate.rows if len(row.intervals) <= 40}
    rows = sorted(by_word.values(), key=lambda r: -len(r.contacts))[:count]
    texts = [(kind, certificate.only([out]).text()) for row in rows for kind, out in wrong_rows(row)]
    texts += wrong_heads(certificate.only(rows))
    whole = certificate.only(rows).text()
    if "\ncontact " in whole:
        texts.append(("the file ends before a contact", whole[:whole.index("\ncontact ") + 1]))
    for kind, text in texts:
        path = write(os.path.join(folder, "wrong"), text)
        status, out, error = programs.check(solid, motion, path)
        tally.equal(status, REFUTED, name, kind, out, error)
        seen[kind] += 1


def main():
    wanted = options(__doc__, ONLY, ("--rows", {"type": int, "default": 0, "help": "generated rows a case"}))
    programs, tally, seen = Programs(wanted.graze), Checks(), collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        many, named = max(1, int(wanted.scale)), [(n, name) for n, name in enumerate(casefile.names()) if wanted.only in name]
        for _, name in named if wanted.derived else []:
            check_known(tally, programs, casefile.Case(name), folder)
        for n, name in wanted.once(named):
            case = casefile.Case(name)
            check_generated(tally, programs, case, folder, wanted.rows or min(300, 20 * many))
            if many > 1 or n % 4 == 0 or wanted.only:
                check_wrong(tally, programs, case, folder, many + 1, seen)
            if wanted.rows:
                print(name, f"{tally.passed} passed, {tally.failed} failed", flush=True)
    print(f"{sum(seen.values())} wrong contacts: " + ", ".join(f"{count} {kind}" for kind, count in sorted(seen.items())))
    if not wanted.only:
        tally.holds((len(seen) >= 25 or not wanted.ample) and sum(seen.values()) >= 1000 * wanted.share, "25 kinds, 1000 in all")
    tally.finish()


if __name__ == "__main__":
    main()
