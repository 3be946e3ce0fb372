# suite
"""Times of contact that lie close together, against PARI.

SPDX-License-Identifier: GPL-3.0-or-later

The square [0, 2]^2 is moved by f(t) along x, so the point (0, 1) meets an edge whenever f is 0 or
-2: the times of its contacts are the real roots of f (f + 2) in [0, 1], each once. gp counts them by
polsturm, and says of every time told whether its polynomial is irreducible and divides f (f + 2),
has one root between the ends told, and, unless these are j and j + 1, more than one between those of
the interval twice as wide. The families are known to be hard for the
isolation of roots. Without gp that is one skip.

Moved by Chebyshev's polynomial of degree n, an odd number, the square [0, 1]^2 goes n times over a
point, and every pass is monotone: words and times are told by cosines.
"""
import json
import math
import os
import resource
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from exact import Fraction as F  # noqa: E402
from harness import Checks, bounded, options, run  # noqa: E402

SECONDS = 200

GP = r"""
\\ The interval twice as wide around [l, h], a dyadic one.
wider(l, h) = { my(w = 2 * (h - l), j = floor(l / w)); [j * w, (j + 1) * w]; }
check(f, T) = {
  my(g = f * (f + 2), n, p, ok); g /= gcd(g, deriv(g)); n = polsturm(g, [0, 1]);
  if(n != #T || #Set(T) != n, print("FAIL count ", n, " not ", #T); return);
  for(k = 1, #T, my([p, l, h] = T[k]);
    if(p == 0, if(subst(g, t, l) != 0, print("FAIL ", l, " is no root")); next);
    my(W = wider(l, h));
    ok = [g % p == 0, polisirreducible(p), polsturm(p, [l, h]) == 1,
          h - l == 1 || polsturm(p, W) > 1];
    if(vecmin(ok) == 0, print("FAIL time ", k, ": ", ok)));
  print("SEEN ", n); }
"""


def clusters():
    """Name and f as graze and gp both read it."""
    for n, digits in ((12, 3), (20, 4), (30, 5)):
        yield f"Mignotte {n} {digits}", f"t^{n}-2*(10^{digits}*t-1)^2"
        yield f"complex {n} {digits}", f"t^{n}+2*(10^{digits}*t-1)^2"
    yield "three", "t^24-2*(10^5*t-1)^3"
    yield "four", "t^24-2*(10^5*t-1)^4"
    yield "dyadic", "(t^24-2*(2^50*t-1)^2)*(2^50*t-1)"
    yield "nested", "(t^16-2*(10^6*t-1)^2)*(t^16-3*(10^6*t-1)^2)"
    yield "two clusters", "(t^16-2*(10^6*t-1)^2)*(t^16-3*((10^6+1)*t-1)^2)"


def chebyshev(n):
    """T_n(2 t - 1)"""
    a, b = [1], [-1, 2]
    for _ in range(n - 1):
        c = [0] * (len(b) + 1)
        for k, x in enumerate(b):
            c[k] -= 2 * x
            c[k + 1] += 4 * x
        for k, x in enumerate(a):
            c[k] -= x
        a, b = b, c
    return "+".join(f"({x})*t^{k}" for k, x in enumerate(b))


def spread():
    """Chebyshev's and Wilkinson's polynomials."""
    for n in (15, 30):
        yield f"Chebyshev {n}", chebyshev(n)
    product = "*".join(f"(20*t-{k})" for k in range(1, 21))
    yield "Wilkinson", product
    yield "Wilkinson perturbed", f"{product}+1/2^100"


def polynomials(args):
    """Name and f; random ones have their roots near 1/2."""
    yield from args.once([*clusters(), *spread()], "clusters")
    for k in args.rounds(4, "near 1/2"):
        roots = [args.random.randrange(1, 1 << 40) for _ in range(5)]
        yield f"random {k}", "*".join(f"(2^41*t-2^40-{r})" for r in roots) + f"-1/{args.random.randrange(2, 1 << 60)}"


def classify(graze, f, wkt="POLYGON((0 0, 2 0, 2 2, 0 2, 0 0))", point="0,1", rise=0):
    """The run with the one point."""
    with tempfile.TemporaryDirectory(prefix="graze-roots-") as folder:
        def path(name, text):
            with open(os.path.join(folder, name), "w", encoding="ascii") as file:
                file.write(text)
            return file.name
        return run(
            [graze, "classify", "--format", "jsonl", path("s.wkt", wkt),
             path("m.json", json.dumps({"dimension": 2, "pieces": [
                 {"t": [0, 1], "transform": {"translate": [f, f"({f})*{rise}"]}}]})), path("p.csv", point + "\n")],
            SECONDS)


def times_of(graze, f):
    """The times of the contacts, as gp reads them; or None and what went wrong."""
    done = classify(graze, f)
    if done.returncode:
        return None, done.stderr
    times = []
    for contact in json.loads(done.stdout)["contacts"]:
        at = contact["from"]
        if contact["to"] != at:
            return None, f"a contact from {at} to {contact['to']}"
        times.append(f"[0,{at},{at}]" if isinstance(at, str)
                     else f"[Pol([{','.join(reversed(at['poly']))}],t),{at['lo']},{at['hi']}]")
    return "[" + ",".join(times) + "]", ""


def passes(checks, args, n, x, word, edges, rise=0):
    """The point (x, 1/2) and the square moved by T = T_n(cos a), t = (1 + cos a) / 2: it is in the
    square while x - 1 < T < x. Contacts are at T = cos b for each b of edges, so at n a = 2 pi j + b
    and 2 pi j - b. Degree 199 takes 2 s of CPU; sought for each contact anew, its times took 40 s.
    A square that rises by T / 3 too is always beside the point: the contacts are the same."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = classify(args.graze, chebyshev(n), "POLYGON((0 0, 1 0, 1 1, 0 1, 0 0))", f"{x},1/2", rise)
    used = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    if not checks.equal(done.returncode, 0, "passes", n, x, done.stderr):
        return
    row = json.loads(done.stdout)
    checks.equal(row["word"], word, "passes", n, x)
    checks.holds(args.sanitizers or used < 15, "passes", n, x, used)
    angles = {round((2 * math.pi * j + s * b) / n, 12) for b in edges for j in range(n) for s in (1, -1)}
    times = sorted((1 + math.cos(a)) / 2 for a in angles if 0 <= a <= math.pi + 1e-9)
    if not checks.equal(len(row["contacts"]), len(times), "passes", n, x):
        return
    for contact, t in zip(row["contacts"], times):
        at = contact["from"]
        low, high = (F(at), F(at)) if isinstance(at, str) else (F(at["lo"]), F(at["hi"]))
        checks.holds(contact["to"] == at and low - F(1, 10 ** 9) < t < high + F(1, 10 ** 9), "passes", n, x, t, at)


def all_passes(checks, args):
    """T begins at -1 and ends at 1. Beside the plain case: the square stays at one side of the point
    and touches it with the left edge at each T = 1; the point is in the square at each T = -1."""
    thirds = math.pi / 3, 2 * math.pi / 3
    if args.derived:
        passes(checks, args, 31, F(1, 2), "O" + "BIBO" * 31, thirds)
    crossed = F(1, 2), "O" + "BIBO" * 199, thirds
    for case in args.once([crossed, (*crossed, "1/3"), (F(1), "O" + "BIBIBO" * 99 + "BIB", (0, math.pi / 2)),
                           (F(-1, 2), "I" + "BOBI" * 99 + "BO", (2 * math.pi / 3,))], "degree 199"):
        passes(checks, args, 199, *case)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    all_passes(checks, args)
    if not shutil.which("gp"):
        checks.skip("gp", "PARI's gp is not installed (Debian package pari-gp)")
        checks.finish()
    script, names = GP, []
    for name, f in polynomials(args):
        times, why = times_of(args.graze, f)
        if checks.holds(times is not None, name, f, why):
            names.append(name)
            script += f"check({f},{times});\n"
    done = run(bounded(["gp", "-q", "-f", "-s", "1G"]), SECONDS, input=script)
    told = [line for line in done.stdout.splitlines() if line.startswith(("SEEN", "FAIL"))]
    checks.equal(len([line for line in told if line.startswith("SEEN")]), len(names),
                 "gp", done.stderr[-300:], told)
    for line in told:
        checks.holds(line.startswith("SEEN"), line)
    checks.finish()


if __name__ == "__main__":
    main()
