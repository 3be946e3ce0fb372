"""Numbers, files and sizes as graze-check reads them: each form of a number is the number it is, what is none is
refused, and past each cap the status is 2.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

One certificate, of a point far from a cube (square) that moves, with the hashes of the files at hand.
"""
import math
import os
import re
import sys
import tempfile

from lib_certificate import Certificate, ENVIRONMENT, NOT_CHECKED, Programs, REFUTED, VERIFIED, run, sha256, write
from column_sets import column_sets
from exact import Fraction
from meshes import CUBE, MOVE, SQUARE, both, off, scaled, tetrahedron
import harness
from harness import ONLY, Checks, options

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)
# Ways to write 1, and what is no number.
ONE = ["1", "+1", "1.0", "1.", "01", "2/2", "10e-1", "0.1e1", ".1E+1", "100E-2", "0.01e2", "1e0"]
NONE = ["1e", "1e+", "1e1.5", "/1", "1/", "1/0", "1/1/1", "1/-1", "1.0/1", "1/1.0", "1.0.0", "e1", ".", "-", "--1", "+-1", "0x1",
        "1_0", "one", "1e0x", "1e20001", "1e-20001", "0" * 20001 + "1",
        "1." + "0" * 20001, "x" * 70]


class Bench:
    def __init__(self, programs, tally, folder):
        self.programs, self.tally, self.folder = programs, tally, folder
        self.solid = {d: self.file("good" + (".off" if d == 3 else ".wkt"), off(CUBE) if d == 3 else SQUARE)
                      for d in (2, 3)}
        self.motion = {d: self.file(f"good{d}.json", MOVE[d]) for d in (2, 3)}
        self.text = {}
        for d in (2, 3):
            points = self.file("points.csv", ",".join(["1000"] * d) + "\n")
            self.text[d] = programs.certify(self.solid[d], self.motion[d], points)

    def file(self, name, text):
        return write(os.path.join(self.folder, name), text)

    def certificate(self, d, solid, motion):
        out = Certificate(self.text[d])
        out.set("solid-sha256", sha256(solid))
        out.set("motion-sha256", sha256(motion))
        return out

    def ends(self, wanted, what, d=3, solid=None, motion=None, change=None, more=()):
        """How graze-check ends with another solid, another motion, a changed certificate, more options."""
        solid, motion = solid or self.solid[d], motion or self.motion[d]
        text = self.certificate(d, solid, motion).text()
        path = self.file("certificate", change(text) if change else text)
        status, out, self.error = self.programs.check(solid, motion, path, *more)
        self.tally.equal((status in wanted, bool(out)), (True, status == VERIFIED), what, status, self.error)


def check_numbers(b):
    for d in (2, 3):
        ending = ".off" if d == 3 else ".wkt"
        for number, wanted in [(n, (VERIFIED,)) for n in ONE] + [(n, (REFUTED, NOT_CHECKED)) for n in NONE]:
            text = off(CUBE).replace("1 1 1\n", f"1 1 {number}\n") if d == 3 else SQUARE.replace("1 1,", f"1 {number},")
            b.ends(wanted, f"a coordinate {number[:20]}", d, solid=b.file("number" + ending, text))
            b.ends(wanted, f"a time {number[:20]}", d, motion=b.file("number.json", MOVE[d].replace('"1"', f'"{number}"')))
    for number, wanted in (("1", VERIFIED), ("001", VERIFIED), ("1.0", REFUTED), ("+1", REFUTED), ("x", REFUTED),
                           ("1000000000", REFUTED), ("0000000001", REFUTED), ("000000001", VERIFIED), ("-1", REFUTED)):
        b.ends((wanted,), f"a number of rows {number}", change=lambda t: t.replace("complete 1", f"complete {number}"))
    b.ends((REFUTED,), "another number of rows", change=lambda t: t.replace("complete 1", "complete 2"))
    b.tally.holds("'complete' says 2 rows; the certificate has 1" in b.error, "another number of rows", b.error)


def check_files(b):
    cube, square = off(CUBE), SQUARE
    for what, text in (("a byte order mark", "\ufeff" + cube), ("CRLF", cube.replace("\n", "\r\n")), ("tabs", cube.replace(" ", "\t")),
                       ("blank lines", cube.replace("\n", "\n\n")), ("blanks before", "  " + cube), ("no last line end", cube[:-1]),
                       ("comments", "# a\n" + cube.replace("\n", " # b\n")), ("counts on the first line", cube.replace("OFF\n", "OFF "))):
        b.ends((VERIFIED,), what, solid=b.file("file.off", text))
    for what, text in (("a byte order mark", "\ufeff" + square), ("line ends", square.replace(" ", "\r\n")),
                       ("several", "MULTI" + square.replace("POLYGON (", "POLYGON ((") + ")")):
        b.ends((VERIFIED,), what, 2, solid=b.file("file.wkt", text))
    for what, text in (("two thirds of a mark", b"\xef\xbb" + cube.encode()), ("another mark", b"\xfe\xff" + cube.encode())):
        path = os.path.join(b.folder, "file.off")
        with open(path, "wb") as file:
            file.write(text)
        b.ends((NOT_CHECKED,), what, solid=path)
    for what, text in (("text behind the last facet", cube + "x\n"),
                       ("a facet more, of two corners", cube.replace("8 6 0", "8 7 0") + "2 0 1\n")):
        b.ends((NOT_CHECKED,), what, solid=b.file("file.off", text))
    for what, text in (("text behind the last bracket", square + "x"), ("an open ring", square.replace(", 0 0))", "))"))):
        b.ends((NOT_CHECKED,), what, 2, solid=b.file("file.wkt", text))
    b.ends((REFUTED,), "a ring more, at one position", 2, solid=b.file("file.wkt", square[:-1] + ", (5 5, 5 5, 5 5, 5 5))"))
    b.ends((NOT_CHECKED,), "another ending", solid=b.file("cube.obj", cube + "# another file\n"))
    b.ends((NOT_CHECKED,), "no ending", solid=b.file("cube", cube + "# a third file\n"))
    b.ends((NOT_CHECKED,), "a byte 0", solid=b.file("file.off", cube.replace("OFF\n", "OFF \0 ")))
    b.ends((VERIFIED,), "bare numbers", motion=b.file("bare.json", MOVE[3].replace('"0"', "0").replace('"1"', "1")))
    for what, entry in (("a decimal", "0.5*t"), ("a ratio", "1/2*t - 1/2*t"), ("a minus", "-t"), ("blanks", " - 2 * t ^ 2  + 1 "),
                        ("a quotient", " ( t - 1 ) / ( t + 1 ) "), ("a constant", "(3)/(2)"), ("powers", "t^0 - t^1")):
        b.ends((VERIFIED, REFUTED), what, motion=b.file("entry.json", MOVE[3].replace('["t", "0"', f'["{entry}", "0"')))
    for folder in ("folder.off", "folder.json", "folder"):
        os.makedirs(os.path.join(b.folder, folder))
    place = [os.path.join(b.folder, n) for n in ("folder.off", "folder.json", "folder")]
    path = b.file("certificate", b.certificate(3, b.solid[3], b.motion[3]).text())
    for what, words in (("solid", [place[0], b.motion[3], path]), ("motion", [b.solid[3], place[1], path]),
                        ("certificate", [b.solid[3], b.motion[3], place[2]]), ("table", [b.solid[3], b.motion[3], path, place[2]])):
        status, out, _ = b.programs.check(*words)
        b.tally.equal((status, out), (NOT_CHECKED, ""), "a folder for a", what)


def check_tokens(b):
    """Every token of a file is looked at: with another in its place the file is refused."""
    for d, ending, text, pattern in ((3, ".off", off(CUBE), r"\S+"), (2, ".wkt", SQUARE, r"[(),]|[^\s(),]+"),
                                     (3, ".json", MOVE[3], r'"[^"]*"|[{}\[\]:,]|[^\s{}\[\]:,"]+')):
        for k, at in enumerate(re.finditer(pattern, text)):
            other = b.file("token" + ending, text[:at.start()] + f" {'x' * (70 if k % 2 else 1)} " + text[at.end():])
            what = f"x for {at[0]} at character {at.start()} of {ending}"
            b.ends((REFUTED, NOT_CHECKED), what, d, **{"motion" if ending == ".json" else "solid": other})
    for line in b.text[3].splitlines()[1:8]:
        key, value = line.split()[0], line.split()[1]
        for other in ("x", value + "0", value + " x", ""):
            b.ends((REFUTED,), f"a head's {key} {other}", change=lambda t: re.sub(f"^{key} .*$", f"{key} {other}", t, flags=re.M))


def check_caps(b):
    """Past a cap the status is 2."""
    caps = {}
    high = '"t^200 + 1"'
    caps["degree of the inverse"] = ('{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"matrix": [[%s, "0", "0", "0"], '
                                     '["0", %s, "0", "0"], ["0", "0", %s, "0"]]}}]}' % (high, high, high))
    for what, text in caps.items():
        b.ends((NOT_CHECKED,), what, motion=b.file("cap.json", text))
    row = lambda word: lambda t: t.replace(" O out exterior 9 1 0 0 0", f" {word} out exterior 9 1 0 0 0")
    b.ends((NOT_CHECKED,), "a word", change=row("O" * 100001))
    b.ends((REFUTED,), "a word within the cap", change=row("O" * 100000))
    b.ends((NOT_CHECKED,), "a degree", change=lambda t: t.replace("O 1\n", "OBO 1" + " 1" * 302 + "\n"))
    b.ends((REFUTED,), "a degree within the cap", change=lambda t: t.replace("O 1\n", "OBO 1" + " 1" * 301 + "\n"))
    b.ends((NOT_CHECKED,), "a line", change=lambda t: t.replace("complete", " " * (1 << 24) + "complete"))
    b.ends((NOT_CHECKED,), "a coefficient", change=lambda t: t.replace("O 1\n", "OBO 1 1 " + "1" * 20001 + "\n"))
    b.ends((NOT_CHECKED,), "another version", change=lambda t: t.replace("graze-certificate 1", "graze-certificate 2"))
    b.ends((VERIFIED,), "no rows", change=lambda t: t[:t.index("row")] + "complete 0\n")
    b.ends((VERIFIED,), "a last line without its end", change=lambda t: t[:-1])
    b.ends((REFUTED,), "an empty line behind the end", change=lambda t: t + "\nrow\n")
    b.ends((REFUTED,), "no rows and no end", change=lambda t: t[:t.index("row")] + "ended 0\n")
    b.ends((REFUTED,), "a sign for a coefficient", change=lambda t: t.replace("O 1\n", "OBO 1 1 -\n"))
    b.ends((REFUTED,), "half a coefficient", change=lambda t: t.replace("O 1\n", "OBO 1 1 1/2\n"))
    b.ends((REFUTED,), "an empty line", change=lambda t: t.replace("O 1\n", "O 1\n\n"))
    b.ends((REFUTED,), "an interval before the first row", change=lambda t: t.replace("row", "O 1\nrow", 1))
    path = b.file("certificate", b.text[3].replace("complete", " " * (1 << 23) + "complete"))
    done = harness.run(harness.bounded([b.programs.check_program, b.solid[3], b.motion[3], path], 12 << 20), env=ENVIRONMENT)
    b.tally.holds(b.sanitizers or (done.returncode == NOT_CHECKED and "out of memory" in done.stderr), "no memory", done)


def check_denominators(b):
    """A polygon whose corners have powers of primes as denominators, all on one of its sides: the common one is their product, which takes
    4 * 10^8 products of words. The side of a triangle that leaves this one takes 2^28 more; three sides of a square are past the 2^30 that a
    call has, and the 2^20 that each side adds are not enough. The solid is not tested, which is more work."""
    odd = [p ** int(66000 / math.log2(p)) for p in (3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53)]
    rest = (1 << 20) - math.prod(odd).bit_length()  # of 2: a power of it makes a product longer by its exponent
    cap, triangle, square = 1 << 20, "0 1", "1 1, 1/2 1, 0 1"
    for bits, corners, says in ((cap, triangle, ""), (cap + 1, triangle, f"a common denominator of {cap + 1} bits"), (cap, square, "too much work")):
        positions = [f"1/{n} 0" for n in sorted([*odd, 2 ** (rest + bits - cap)], reverse=True)]
        text = f"POLYGON ((0 0, {', '.join(positions)}, {corners}, 0 0))"
        b.ends((NOT_CHECKED if says else VERIFIED,), f"{bits} bits", 2, solid=b.file("bits.wkt", text), more=("--assume-legal",),
               change=lambda t: t[:t.index("row")] + "complete 0\n")
        b.tally.holds(says in b.error if says else b.error == "", bits, "its message", b.error)


def check_sizes(b):
    """Coordinates past the range of doubles, and a facet touched at every point that is tried."""
    for what, factor in (("huge", 10 ** 400), ("tiny", Fraction(1, 10 ** 400))):
        b.ends((VERIFIED, REFUTED), what, solid=b.file("size.off", off(scaled(CUBE, factor))))
        points = b.file("points.csv", ",".join([str(3 * factor)] * 3) + "\n" + ",".join([str(factor / 3 if what == "tiny" else factor // 3)] * 3) + "\n")
        solid, still = b.file("size.off", off(scaled(CUBE, factor))), b.file("still.json", MOVE[3].replace('"t", "0"', f'"{factor}*t", "0"'))
        path = b.file("certificate", b.programs.certify(solid, still, points))
        status, _, error = b.programs.check(solid, still, path)
        b.tally.equal(status, VERIFIED, what, "both ends", error)
    tips = []
    for k in range(1, 41):  # the weights 1 : k : k^2 of a piece of the top, corners (0, 0), (1, 0), (1, 1)
        total = 1 + k + k * k
        x, y, e = Fraction(k + k * k, total), Fraction(k * k, total), Fraction(1, 10 ** 6)
        tips.append(tetrahedron((x, y, 1), (x + e, y, 1 + e), (x, y + e, 1 + e), (x - e, y - e, 1 + e)))
    text = off(both(CUBE, *tips))
    b.ends((NOT_CHECKED,), "a facet touched at every point that is tried", solid=b.file("tips.off", text))
    status, _, error = run(b.programs.graze, "check", b.file("tips.off", text), b.motion[3])
    b.tally.equal(status, 0, "and it is legal", error)


NOTE = "graze-check: note: columns that are not certified: "
CERTIFIED = ["x", "y", "z", "pmc", "class", "definition", "case", "i", "t", "word"]  # what a certificate claims of a row


def head_of(table):
    return next(line for line in table.splitlines() if not line.startswith("#")).split(",")


def check_notes(b):
    """graze-check verifies the columns that a certificate claims, and its note names each other one that graze writes."""
    known = {name for names in column_sets().values() for name, mark in names.items() if mark != "*"}
    seen = set()
    for d, words in ((2, []), (3, []), (2, ["--operation", "unsweep"]), (3, ["--operation", "unsweep"])):
        points = b.file("points.csv", ",".join("xyz"[:d]) + ',"user, own"\n' + "1000," * d + "7\n")
        more = ["--moments", "--sdf", "1/1000", "--boundary-distance", "--motion-error", "1/100"] + (["--topo"] if d == 2 else [])
        more += ["--regular"] if d == 2 and words else []
        table = b.programs.table(b.solid[d], b.motion[d], points, words + more)
        certificate = b.file("certificate", b.programs.certify(b.solid[d], b.motion[d], points, words))
        other = [name for name in head_of(table) if name not in CERTIFIED]
        seen |= set(head_of(table)) - {'"user', ' own"'}
        b.tally.holds({"sdf_low", "sdf_high", "sdf_t", "boundary_low", "certain"} <= set(other), "not certified", d, words, other)
        row = table.splitlines()[-2 if d == 3 else -3].split(",")
        for k, name in enumerate(head_of(table)):
            forged = table.replace(",".join(row), ",".join(row[:k] + ["17"] + row[k + 1:]))
            status, out, error = b.programs.check(b.solid[d], b.motion[d], certificate, b.file("table.csv", forged), "--jobs", "3")
            b.tally.equal((status == VERIFIED, bool(out)), (name in other,) * 2, d, words, name, "forged", error)
            b.tally.equal(error.count(NOTE + ",".join(other) + "\n"), 1, d, words, "the note, once", error)
        bare = b.file("table.csv", b.programs.table(b.solid[d], b.motion[d], b.file("bare.csv", "1000," * (d - 1) + "1000\n"), words))
        status, _, error = b.programs.check(b.solid[d], b.motion[d], certificate, bare)
        b.tally.equal((status, error), (VERIFIED, ""), d, words, "nothing to note")
    b.tally.equal(seen, known | set(CERTIFIED), "columns that the writer has")


def check_tables(b):
    points = b.file("points.csv", 'x,y,z,topo,note\n1000,1000,1000,a,"x, y"\n')
    table = b.programs.table(b.solid[3], b.motion[3], points)
    certificate = b.file("certificate", b.programs.certify(b.solid[3], b.motion[3], points))
    status, _, error = b.programs.check(b.solid[3], b.motion[3], certificate, b.file("table.csv", table))
    b.tally.equal((status, error), (VERIFIED, NOTE + "topo,note\n"), "columns of the points")
    row = table.splitlines()[-2]
    for what, text, wanted in (("an empty line in the head", "\n" + table, REFUTED),
                               ("a point that is none", table.replace(row, "x" + row), REFUTED),
                               ("no end", table[:table.index(row)], REFUTED),
                               ("an empty line for a row", table.replace(row, ""), REFUTED),
                               ("a comment for a row", table.replace(row, "# " + row), REFUTED),
                               ("a cell of two lines", table.replace('"x, y"', '"x\ny"'), NOT_CHECKED),
                               ("no rows", table[:table.index("x,y,z")], REFUTED),
                               ("fewer rows", table.replace(table.splitlines()[-2] + "\n", ""), REFUTED)):
        status, out, error = b.programs.check(b.solid[3], b.motion[3], certificate, b.file("table.csv", text))
        b.tally.equal((status, bool(out)), (wanted, wanted == VERIFIED), what, error)
    b.tally.holds(len({row, "x,y,z,pmc,class,definition,case,i,t,word,topo,note"} & set(table.splitlines())) == 2, "its form", table)
    points = b.file("points.csv", "x,y,z,note\n1000,1000,1000,one\n1000,1000,1000,two\n")
    two = b.programs.table(b.solid[3], b.motion[3], points)
    certificate = b.file("certificate", b.programs.certify(b.solid[3], b.motion[3], points))
    for what, text, wanted in (("two rows", two, VERIFIED),
                               ("a count of what is not decided", two.replace("# complete", "# undecided 0\n# complete"), VERIFIED),
                               ("another count", two.replace("# complete", "# undecide 0\n# complete"), REFUTED),
                               ("two rows that are one", two.replace(",one", ',"one').replace(",two", ',two"'), NOT_CHECKED)):
        status, _, error = b.programs.check(b.solid[3], b.motion[3], certificate, b.file("table.csv", text))
        b.tally.equal(status, wanted, what, error)


def check_jobs(b):
    """A row that is refuted by another process, whichever it is."""
    points = b.file("points.csv", "1000,1000,1000\n" * 5)
    text = b.programs.certify(b.solid[3], b.motion[3], points)
    for row in range(5):
        at = [k for k, line in enumerate(text.splitlines()) if line.startswith("row")][row]
        lines = text.splitlines()
        lines[at] = lines[at].replace("1000 O", "1000 I").replace("out exterior 9 1 0 0 0", "in regular ext 9 0 0 1")
        lines[at + 1] = "I 1"
        path = b.file("certificate", "\n".join(lines) + "\n")
        for jobs in ("1", "2", "5", "7"):
            status, out, error = b.programs.check(b.solid[3], b.motion[3], path, "--jobs", jobs)
            b.tally.equal((status, out), (REFUTED, ""), "row", row, "jobs", jobs, error)
    path = b.file("certificate", text)
    for jobs in ("1", "2", "5", "7"):
        status, out, error = b.programs.check(b.solid[3], b.motion[3], path, "--jobs", jobs)
        b.tally.equal((status, out), (VERIFIED, "verified: 5 rows\n"), "jobs", jobs, error)
    # A shell that becomes graze-check leaves it a child of its own.
    done = harness.run(["sh", "-c", 'sleep 120 >/dev/null 2>&1 & exec "$@"', "sh", b.programs.check_program,
                        b.solid[3], b.motion[3], path, "--jobs", "2"], env=ENVIRONMENT)
    b.tally.equal((done.returncode, done.stdout), (VERIFIED, "verified: 5 rows\n"), "a child not its own", done.stderr)


def main():
    chosen = options(__doc__, ONLY)
    tally = Checks()
    with tempfile.TemporaryDirectory() as folder:
        b = Bench(Programs(chosen.graze), tally, folder)
        b.sanitizers = chosen.sanitizers  # they map more than the limit
        for check in (check_numbers, check_files, check_tokens, check_caps, check_denominators, check_sizes, check_notes, check_tables, check_jobs):
            if chosen.only in check.__name__:
                check(b)
    tally.finish()


if __name__ == "__main__":
    main()
