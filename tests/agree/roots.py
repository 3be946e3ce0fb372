# suite
"""Times of contact that lie close together, against PARI.

SPDX-License-Identifier: GPL-3.0-or-later

The square [0, 2]^2 is moved by f(t) along x, so the point (0, 1) meets an edge whenever f is 0 or
-2: the times of its contacts are the real roots of f (f + 2) in [0, 1], each once. gp counts them by
polsturm, and says of every time told whether its polynomial is irreducible and divides f (f + 2),
has one root between the ends told, and, unless these are j and j + 1, more than one between those of
the interval twice as wide. The families are known to be hard for the
isolation of roots. Without gp this is one skip.
"""
import json
import os
import shutil
import sys
import tempfile
from fractions import Fraction as F

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from program import Checks, options, run  # noqa: E402

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


def spread(rng):
    """Chebyshev's and Wilkinson's polynomials, and random ones near 1/2."""
    for n in (15, 30):
        a, b = [F(1)], [F(-1), F(2)]
        for _ in range(n - 1):
            c = [F(0)] * (len(b) + 1)
            for k, x in enumerate(b):
                c[k] -= 2 * x
                c[k + 1] += 4 * x
            for k, x in enumerate(a):
                c[k] -= x
            a, b = b, c
        yield f"Chebyshev {n}", "+".join(f"({x})*t^{k}" for k, x in enumerate(b))
    product = "*".join(f"(20*t-{k})" for k in range(1, 21))
    yield "Wilkinson", product
    yield "Wilkinson perturbed", f"{product}+1/2^100"
    for k in range(4):
        roots = [rng.randrange(1, 1 << 40) for _ in range(5)]
        yield f"random {k}", "*".join(f"(2^41*t-2^40-{r})" for r in roots) + f"-1/{rng.randrange(2, 1 << 60)}"


def times_of(graze, f, memory):
    """The times of the contacts, as gp reads them; or None and what went wrong."""
    with tempfile.TemporaryDirectory(prefix="graze-roots-") as folder:
        def path(name, text):
            with open(os.path.join(folder, name), "w", encoding="ascii") as file:
                file.write(text)
            return file.name
        done = run(
            [graze, "classify", "--format", "jsonl", path("s.wkt", "POLYGON((0 0, 2 0, 2 2, 0 2, 0 0))"),
             path("m.json", json.dumps({"dimension": 2, "pieces": [
                 {"t": [0, 1], "transform": {"translate": [f, 0]}}]})), path("p.csv", "0,1\n")],
            SECONDS, memory)
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


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    if not shutil.which("gp"):
        checks.skip("gp", "PARI's gp is not installed (Debian package pari-gp)")
        checks.finish()
    script, names = GP, []
    for name, f in list(clusters()) + list(spread(args.random)):
        times, why = times_of(args.graze, f, args.memory)
        if checks.holds(times is not None, name, f, why):
            names.append(name)
            script += f"check({f},{times});\n"
    done = run(["gp", "-q", "-f", "-s", "1G"], SECONDS, input=script)
    told = [line for line in done.stdout.splitlines() if line.startswith(("SEEN", "FAIL"))]
    checks.equal(len([line for line in told if line.startswith("SEEN")]), len(names),
                 "gp", done.stderr[-300:], told)
    for line in told:
        checks.holds(line.startswith("SEEN"), line)
    checks.finish()


if __name__ == "__main__":
    main()
