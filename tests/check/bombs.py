"""Small files that ask graze-check for endless work: each ends within a second, with status 2 and one line; and large
numbers that are no such file are verified.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

Each bomb is made by the product that it asks for, which the comment beside it counts. tests/proofs/checker.py
gives the motions to graze-check-coq.
"""
import random
import resource
import sys
import tempfile

from lib_certificate import NOT_CHECKED, Programs, VERIFIED
from limits import Bench
from meshes import CUBE, off
from harness import ONLY, Checks, options

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)
SECONDS = 1  # of CPU
ROW = "row 1000 1000 O out exterior 9 1 0 0 0\n"


def motion(*transforms, d=2, times=("0", "1")):
    """A motion of pieces one after the other, the first one at these times."""
    piece = '{"t": ["%s", "%s"], "transform": %s}'
    pieces = [piece % (*(times if k == 0 else (str(k), str(k + 1))), transform) for k, transform in enumerate(transforms)]
    return '{"dimension": %d, "pieces": [%s]}' % (d, ", ".join(pieces))


def translate(*entries):
    return '{"translate": [%s]}' % ", ".join(f'"{entry}"' for entry in entries)


def spread(rng, n):
    """n terms whose coefficients are far apart: their common factor is small, and multiples of them are long."""
    return " + ".join(f"{rng.choice((3, 7, 11, 13, 17, 19))}e{rng.randint(0, 19990)}*t^{k}" for k in range(n))


def quotients(n):
    """Two entries (A)/(B) of n terms each: the remainders of B and B' have n steps of n coefficients of up to 2 n times
    66,000 bits."""
    rng = random.Random(n)
    return translate(*(f"({spread(rng, n)})/({spread(rng, n)})" for _ in range(2)))


def plain(degree, first=3):
    return " + ".join(f"{first + k % 7}*t^{k}" for k in range(degree + 1))


def primes(count):
    out, n = [], 3
    while len(out) < count:
        if all(n % p for p in out if p * p <= n):
            out.append(n)
        n += 2
    return out


def long_number(seed):
    """An odd number of 19,990 digits."""
    return str(random.Random(seed).randint(10 ** 19989, 10 ** 19990) | 1)


MOTIONS = {f"quotients of {n} terms": motion(quotients(n)) for n in (4, 16, 48, 113)}
MOTIONS["pieces of quotients"] = motion(*(quotients(n) for n in range(4, 24)))
# The common denominator of 3,000 primes has about 40,000 bits: 3,000 terms times 300 coefficients times those.
MOTIONS["denominators without a common factor"] = motion(translate(
    " + ".join(f"1/{p}*t^{k % 300}" for k, p in enumerate(primes(6000))), "0"))
# graze-check-coq tests the times of a motion within its verified part, whose work nothing bounds.
TIMES = {}
# Horner's rule for the determinant, of degree 279: 39,000 products of 1,000 words with up to 279,000.
TIMES["a time of many digits"] = motion(translate(f"({plain(93)})/({plain(93, 5)})", "0"), times=(long_number(1), long_number(1) + "0"))
TIMES["times far apart"] = motion(translate(f"({plain(93)})/({plain(93, 5)})", "0"), times=("1e-19990", "1e19990"))

LATE = f"{long_number(1)[:-1]}/{long_number(2)}"  # between 0 and 1
HIGH = motion(translate(plain(200), "0"))


def cube(value):
    """The cube with the value of each axis at 0 and at 1."""
    return off(([tuple(value(axis, c) for axis, c in enumerate(p)) for p in CUBE[0]], CUBE[1]))


def check_motions(b):
    for what, text in {**MOTIONS, **TIMES}.items():
        ends_soon(b, what, motion=b.file("bomb.json", text))


def check_rows(b):
    """Horner's rule at a time of 1,000 words for a polynomial of degree 200: 20,000 products of up to 200,000 words."""
    high = b.file("high.json", HIGH)
    for what, lines in (("an interval", f"O {LATE}\nO 1\n"), ("a root", f"OBO {LATE}" + " 1" * 150 + "\n")):
        ends_soon(b, what, motion=high, change=lambda t: t[:t.index("row")] + ROW + lines + "complete 1\n")
    quotient = b.file("quotient.json", motion(translate(f"({plain(93)})/({plain(93, 5)})", "0")))
    ends_soon(b, "a time of signs", motion=quotient, change=lambda t: t.replace("signs 0 1", f"signs 0 {LATE} 1"))
    far = f"row {long_number(3)} {long_number(4)} O out exterior 9 1 0 0 0\nO 1\ncomplete 1\n"
    b.ends((VERIFIED,), "a point of many digits", 2, motion=high, change=lambda t: t[:t.index("row")] + far)


def check_solids(b):
    numbers = [long_number(k) for k in range(9)]
    for what, value in (("small and large", lambda axis, c: ("-3e-19990", "7e19990")[c]),
                        ("many denominators", lambda axis, c: f"{3 * c - 1}/{numbers[2 * axis + c]}")):
        ends_soon(b, what, d=3, solid=b.file("bomb.off", cube(value)))
    # Two common denominators of 66,000 bits: their greatest common divisor takes two million products of words, 9,000 times.
    ends_soon(b, "denominators", d=3, solid=b.file("bomb.off", "OFF\n3000 0 0\n" + f"1e-19990 1/{numbers[0]} 1e-19989\n" + "1e-19990 1e-19989 1e-19988\n" * 2999))
    # 600,000 bits for each of 300,000 coordinates: 22 GB.
    short = "".join(f"1/{n} 0 0\n" for n in numbers) + "1 2 3\n" * 99991
    ends_soon(b, "a common denominator", d=3, solid=b.file("bomb.off", f"OFF\n100000 0 0\n{short}"), words="common denominator")
    ends_soon(b, "counts", d=3, solid=b.file("bomb.off", "OFF\n999999999 999999999 999999999\n"), words="a vertex is not")
    ring = [f"{k}e{37 * k % 19990} {k + 1}e-{91 * k % 19990}" for k in range(1, 3000)]
    for what, positions in (("a ring of exponents", ring), ("a ring of primes", [f"1/{p} {k}" for k, p in enumerate(primes(6000))])):
        ends_soon(b, what, solid=b.file("bomb.wkt", "POLYGON ((" + ", ".join(positions + positions[:1]) + "))"))


def check_large(b):
    """No bombs: coordinates of as many digits as Graze takes, rotations of degree 40, a translation of degree 200."""
    rng = random.Random(5)
    numbers = [rng.randint(10 ** 9999, 10 ** 10000) for _ in range(3)]
    b.ends((VERIFIED,), "10,000 digits", 3, solid=b.file("large.off", cube(lambda axis, c: str((-1) ** (c + 1) * numbers[axis]))),
           change=lambda t: t[:t.index("row")] + "complete 0\n")
    q = [rng.randint(1, 1000) for _ in range(21)]
    square = [sum(q[i] * q[k - i] for i in range(21) if 0 <= k - i <= 20) for k in range(41)]
    entry = lambda first, sign, rest: "(%s)/(%s)" % (" + ".join(f"{first * (k == 0) + sign * c}*t^{k}" for k, c in enumerate(rest)).replace("+ -", "- "),
                                                      " + ".join(f"{(k == 0) + c}*t^{k}" for k, c in enumerate(square)))
    cos, sin, minus = entry(1, -1, square), entry(0, 2, q), entry(0, -2, q)
    turn = '{"matrix": [["%s", "%s", "0"], ["%s", "%s", "0"]]}' % (cos, minus, sin, cos)
    b.ends((VERIFIED,), "a rotation", 2, motion=b.file("large.json", motion(turn)), change=lambda t: t[:t.index("row")] + "complete 0\n")
    b.ends((VERIFIED,), "a translation", 2, motion=b.file("large.json", HIGH), change=lambda t: t[:t.index("row")] + "complete 0\n")


def ends_soon(b, what, d=2, words="too much work", **files):
    """Status 2, one line that says these words, within a second of CPU where no sanitizer looks on."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    b.ends((NOT_CHECKED,), what, d, **files)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    took = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    b.tally.holds(b.sanitizers or took < SECONDS, what, "seconds of CPU", took)
    b.tally.equal((b.error.count("\n"), words in b.error), (1, True), what, b.error)


def main():
    chosen = options(__doc__, ONLY)
    tally = Checks()
    with tempfile.TemporaryDirectory() as folder:
        b = Bench(Programs(chosen.graze), tally, folder)
        b.sanitizers = chosen.sanitizers
        for check in (check_motions, check_rows, check_solids, check_large):
            if chosen.only in check.__name__:
                check(b)
    tally.finish()


if __name__ == "__main__":
    main()
