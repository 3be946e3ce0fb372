"""Rows of contact points a second, on one core.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import random
from fractions import Fraction

import certificates
import scenes

FACES = 1000
LEAST = 2000  # rows a second
MOST = 3  # times `graze classify` of as many degenerate points
MOTIONS = {"translation": certificates.MOTION, "rotation": scenes.ROTATION.json}


def write_sites(path, mesh, count, moved):
    """Points in faces, corners and edges among them, at times k/64; or points beside them that are moved."""
    rng, (vertices, facets) = random.Random(11), mesh
    with open(path, "w", encoding="ascii") as file:
        file.write("time,bx,by,bz,cell\n")
        for _ in range(count):
            k = rng.randrange(len(facets))
            i, j = (Fraction(rng.randint(0, 4), 8) for _ in range(2))
            weights = (i, j, 1 - i - j)
            y = [sum(w * Fraction(repr(vertices[v][c])) for w, v in zip(weights, facets[k])) for c in range(3)]
            if moved:
                y = [x + Fraction(rng.randint(-8, 8), 64) for x in y]
            file.write(",".join(map(str, [Fraction(rng.randrange(65), 64), *y])) + f",face {k}\n")


def run(table, graze, folder, count):
    """All rows; `count` points each."""
    table.head(f"Contact points, {FACES:,} faces, one piece of degree 4")
    mesh = scenes.torus(*scenes.TORUS_SIZES[FACES])
    solid = os.path.join(folder, "contacts.off")
    scenes.write_off(solid, mesh)
    for name, text in MOTIONS.items():
        motion = os.path.join(folder, f"contacts-{name}.json")
        with open(motion, "w", encoding="ascii") as file:
            file.write(text)
        points = {n: certificates.write_points(graze, folder, solid, motion, "degenerate", n) for n in (1, count)}
        classified = certificates.a_row(count, lambda n: [graze, "classify", solid, motion, points[n], "--jobs", "1", "--quiet"])
        for flags in ([], ["--snap"]):
            path = lambda n: os.path.join(folder, f"contacts{n}{''.join(flags)}.csv")
            for n in (1, count):
                write_sites(path(n), mesh, n, flags)
            spent = certificates.a_row(
                count, lambda n: [graze, "contact", solid, motion, path(n), "--jobs", "1", "--quiet", *flags])
            table.row(f"graze contact {' '.join(flags)}, {name} ({count:,} rows)".replace(" ,", ","), certificates.as_multiple(1, spent),
                      least=LEAST, unit=" rows/s", graze=spent)
            table.row(f"  / classify of as many degenerate points, {name}", certificates.as_multiple(spent, classified), most=MOST,
                      graze=spent, peer=classified)
