"""The golden cases, and generated rows of each, certified and verified; golden tables held to their
certificates.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

Solid and motion are converted by graze convert; a certificate's rows must be those of expected.csv, derived by hand for
the files as they were. 20 * --scale generated rows a
case, most of them degenerate, at most 300; with --rows N N of them, and the cases are told one by one. Wrong tables are of every eighth case, with --scale of all.
"""
import os
import tempfile

from lib_certificate import Certificate, Programs, REFUTED, VERIFIED, answer_options, run, write
import casefile
from harness import ONLY, Checks, options

COLUMNS = ["word", "pmc", "class", "definition", "case", "i", "t"]


def check_expected(tally, case, certificate):
    columns = COLUMNS[:2] if certificate.unsweep else COLUMNS
    tally.equal(len(certificate.rows), len(case.expected), case.name, "rows")
    for row, want in zip(certificate.rows, case.expected):
        tally.equal(row.claims[:len(columns)], [want[c] for c in columns], case.name, want["id"])


def check_tables(tally, programs, case, files, table):
    """Each column of the first row that is wrong is found, and rows too few or too many."""
    folder = os.path.dirname(files[2])
    lines = table.splitlines()
    first = next(k for k, line in enumerate(lines) if not line.startswith("#")) + 1
    cells = lines[first].split(",")
    wanted = case.dimension + (2 if "--operation" in case.options else 7)
    for k in range(wanted):
        wrong = list(cells)
        wrong[k] = "17" if wrong[k] != "17" else "18"
        other = lines[:first] + [",".join(wrong)] + lines[first + 1:]
        check_wrong(tally, programs, case, files, folder, other, f"column {k}")
    check_wrong(tally, programs, case, files, folder, lines[:first] + lines[first + 1:], "a row less")
    check_wrong(tally, programs, case, files, folder, lines[:first] + [lines[first]] + lines[first:], "a row more")
    check_wrong(tally, programs, case, files, folder, lines[:-1], "not complete")
    for end in ("# complete 9999", "# complete", lines[-1] + " 1", "complete", lines[-1] + "\nx"):
        check_wrong(tally, programs, case, files, folder, lines[:-1] + [end], "end")
    check_wrong(tally, programs, case, files, folder, lines[:first - 1], "no columns")
    for k in range(wanted):
        names = lines[first - 1].split(",")
        names[k] += "x"
        check_wrong(tally, programs, case, files, folder, lines[:first - 1] + [",".join(names)] + lines[first:], "name")
    for k, line in enumerate(lines[:first - 1]):
        key = line.split()[1]
        if key not in ("graze", "overlap", "coordinates", "ends-meet"):
            wrong = " ".join(line.split()[:2] + ["other"])
            check_wrong(tally, programs, case, files, folder, lines[:k] + [wrong] + lines[k + 1:], key)
            check_wrong(tally, programs, case, files, folder, lines[:k] + lines[k + 1:], "no " + key)


def check_wrong(tally, programs, case, files, folder, lines, what):
    path = write(os.path.join(folder, "wrong.csv"), "\n".join(lines) + "\n")
    tally.equal(programs.check(*files, path)[0], REFUTED, case.name, "a table with another", what)


def check_as_given(tally, programs, case, folder, rows, more):
    """The case's own files: those that graze-check cannot read are converted beside the certificate, which is verified."""
    own, table = os.path.join(folder, case.name), os.path.join(folder, "own.csv")
    files = case.path(case.solid), case.path("motion.json")
    status, _, error = run(programs.graze, "classify", *files, case.path("points.csv"), *more, "--certify", own, "--output", table)
    tally.equal(status, 0, case.name, error)
    beside = own + (".off" if case.dimension == 3 else ".wkt"), own + ".json"
    read = [new if os.path.exists(new) else old for old, new in zip(files, beside)]
    tally.equal([f"note: {old}: graze-check cannot read it" in error for old in files], [new in read for new in beside], case.name, error)
    status, out, error = programs.check(*read, own, table)
    tally.equal((status, out), (VERIFIED, f"verified: {len(rows)} rows\n"), case.name, "as given", error)
    with open(own, encoding="ascii") as file:
        tally.equal([row.claims for row in Certificate(file.read()).rows], [row.claims for row in rows], case.name, "as given")
    tally.equal(case.name != "bracket" or read == list(beside), True, case.name, "both are converted")


def certified(programs, case, folder):
    """[solid, motion, certificate, table] of the case's points, the solid as converted; the table's text; options."""
    scene, more = programs.convert(case, folder), answer_options(case.options)
    path = write(os.path.join(folder, "certificate"), programs.certify(*scene, case.path("points.csv"), more))
    table = programs.table(*scene, case.path("points.csv"), more)
    return [*scene, path, write(os.path.join(folder, "table.csv"), table)], table, more


def check_known(tally, programs, case, folder, as_given):
    """Rows are those of expected.csv."""
    files, _, more = certified(programs, case, folder)
    for jobs in ([], ["--jobs", "3"]):
        status, out, error = programs.check(*files, *jobs)
        tally.equal((status, out), (VERIFIED, f"verified: {len(case.expected)} rows\n"), case.name, *jobs, error)
    with open(files[2], encoding="ascii") as file:
        certificate = Certificate(file.read())
    check_expected(tally, case, certificate)
    if as_given:
        check_as_given(tally, programs, case, folder, certificate.rows, more)


def check_generated(tally, programs, case, folder, count):
    (solid, motion), more = programs.convert(case, folder), answer_options(case.options)
    points = write(os.path.join(folder, "points.csv"), run(programs.graze, "generate", solid, motion, "-n", str(count), "--seed", "3", "--quiet",
                                                           "--operation", case.option("--operation", "sweep"))[1])
    path = write(os.path.join(folder, "certificate"), programs.certify(solid, motion, points, more))
    table = write(os.path.join(folder, "table.csv"), programs.table(solid, motion, points, more))
    status, out, error = programs.check(solid, motion, path, table)
    tally.equal((status, out), (VERIFIED, f"verified: {count} rows\n"), case.name, "generated", error)


def main():
    chosen = options(__doc__, ONLY, ("--rows", {"type": int, "default": 0, "help": "generated rows a case"}))
    programs, tally = Programs(chosen.graze), Checks()
    with tempfile.TemporaryDirectory() as folder:
        named = [(n, name) for n, name in enumerate(casefile.names()) if chosen.only in name]
        for n, name in named if chosen.derived else []:
            # In figure2-turn-3d a sign follows a number without a blank, which graze-check does not read.
            check_known(tally, programs, casefile.Case(name), folder, chosen.scale > 1 or n % 8 == 0 or name in ("bracket", "figure2-turn-3d"))
        for n, name in chosen.once(named):
            case = casefile.Case(name)
            check_generated(tally, programs, case, folder, chosen.rows or min(300, 20 * max(1, int(chosen.scale))))
            if chosen.scale > 1 or n % 8 == 0:
                files, table, _ = certified(programs, case, folder)
                check_tables(tally, programs, case, files[:3], table)
            if chosen.rows:
                print(name, f"{tally.passed} passed, {tally.failed} failed", flush=True)
    tally.finish()


if __name__ == "__main__":
    main()
