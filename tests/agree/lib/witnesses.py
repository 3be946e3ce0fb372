"""Witnesses of the boundary of the closed sweep, recomputed from their direction, path or square.

SPDX-License-Identifier: GPL-3.0-or-later

Places are exact rationals, and each is classified again: on a ray or a path all are `out` from epsilon down, of an
unsweep, whose witness shows that it is regular there, all are `in`.
"""
from exact import Fraction as F

# Halvings of epsilon, down to 2^-400 of it.
HALVINGS = [*range(48), *range(48, 401, 8)]
KEYS = {"first_order": {"direction", "epsilon"}, "leading_terms": {"direction", "normal", "order", "z", "epsilon"},
        "curves": {"rho"}, "section": {"rho"}}


def integers(values):
    return [int(x) for x in values]


def ray(point, said):
    """s -> the point + s direction."""
    direction = integers(said["direction"])
    return lambda s: tuple(p + s * u for p, u in zip(point, direction))


def path(point, said):
    """s -> the point + s^m x + s^(m + 1) z N."""
    x, normal, z = integers(said["direction"]), integers(said["normal"]), F(said["z"])
    m = said["order"]
    return lambda s: tuple(p + s ** m * u + s ** (m + 1) * z * n for p, u, n in zip(point, x, normal))


def check_square(checks, name, point, said):
    """It lies on its square: point + x a + y b, the larger of |x|, |y| equal to rho."""
    rho, witness = F(said["rho"]), [F(x) for x in said["witness"]]
    (a, b), d = [integers(v) for v in said["plane"]] if len(point) == 3 else [[1, 0], [0, 1]], len(point)
    way = [q - p for p, q in zip(point, witness)]
    # x and y with way = x a + y b, by a minor of (a, b) that is not 0
    i, j = next((i, j) for i in range(d) for j in range(i) if a[i] * b[j] != a[j] * b[i])
    det = a[i] * b[j] - a[j] * b[i]
    x, y = (way[i] * b[j] - way[j] * b[i]) / F(det), (a[i] * way[j] - a[j] * way[i]) / F(det)
    checks.equal([x * p + y * q for p, q in zip(a, b)], way, name, "the witness in its plane")
    checks.equal(max(abs(x), abs(y)), rho, name, "the witness on its square")


def check_witness(checks, graze, name, files, point, record, question="topo"):
    """Check the witness of an `on` point that is `boundary`, or whose answer to `regular` is `yes`; return its distance
    from the point, by the largest coordinate, or None where the witness is on a square."""
    said = {key[len(question) + 1:]: value for key, value in record.items() if key.startswith(question + "_")}
    level, point = said["level"], [F(x) for x in point]
    keys = set(said) - {"level", "witness"}
    plane = {"plane"} if level in ("curves", "section") and len(point) == 3 else set()
    checks.equal(keys, KEYS.get(level, set()) | plane, name, level)
    if keys != KEYS.get(level, set()) | plane:
        return None

    def check_beyond(places):
        flags, pmc = {"topo": ((), "out"), "regular": (("--operation", "unsweep"), "in")}[question]
        found = graze.classify(name + " witness", *files, places, *flags) or []
        checks.equal({answer.record["pmc"] for answer in found}, {pmc}, name, "places of the witness", record)

    witness = tuple(F(x) for x in said["witness"])
    if level in ("curves", "section"):
        check_square(checks, name, point, said)
        check_beyond([witness])
        return None
    place, epsilon = (ray if level == "first_order" else path)(point, said), F(said["epsilon"])
    checks.holds(epsilon > 0, name, "epsilon")
    checks.equal(place(epsilon), witness, name, "the witness at epsilon")
    if level == "leading_terms":
        x, normal = integers(said["direction"]), integers(said["normal"])
        checks.equal(sum(p * q for p, q in zip(x, normal)), 0, name, "x across N")
        checks.holds(any(x) and any(normal) and said["order"] > 0, name, "x, N and m are not 0")
    ways = [epsilon / 2 ** k for k in HALVINGS] + [epsilon * F(k, 37) for k in range(1, 37)]
    check_beyond([place(s) for s in ways])
    return max(abs(q - p) for p, q in zip(point, witness))
