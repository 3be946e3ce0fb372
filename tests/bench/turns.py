"""Parts as CAD exports them, slid and turned, beside CGAL's count of the chords of the same trajectories.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

from measure import in_turns
from scenes import Motion, apply, points_crossing, save, tan_half, write_off

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))
from parts import disk, lathe, plate, ribs  # noqa: E402

REPEATS = 5
AXIS, CENTRE = (2 / 7, 3 / 7, 6 / 7), (0.5, 0, 0)


def quarters(count):
    """An angle of `count` quarters, in each of which the tangent of the half angle runs from 0 to 1."""
    steps = (1, 0), (0, 1), (-1, 0), (0, -1)

    def angle(t):
        quarter = min(int(count * t), count - 1)
        c, s = tan_half(count * t - quarter)
        a, b = steps[quarter % 4]
        return a * c - b * s, b * c + a * s
    return angle


def turn(count):
    """A turn by `count` quarters about a skew axis."""
    transform = {"turn": {"quarters": count, "axis": ["2/7", "3/7", "6/7"], "center": ["1/2", "0", "0"]}}
    return Motion(transform, lambda t: (0, 0, 0), quarters(count), AXIS, CENTRE)


CHORDS = 16  # of a quarter turn, for the peers
SLIDE = Motion({"translate": ["0.7*t", "t/2", "0.9*t"]}, lambda t: (0.7 * t, t / 2, 0.9 * t))
# name -> motion, chords of a trajectory, most that Graze may take against CGAL
MOTIONS = {"translation": (SLIDE, 1, 1.0), "turn of 90 degrees": (turn(1), CHORDS, 1.5),
           "turn of 270 degrees": (turn(3), 3 * CHORDS, 1.5), "turn of 720 degrees": (turn(8), 8 * CHORDS, 1.5)}
# name -> mesh
PARTS = {"disk, small": lambda: disk(559), "disk": lambda: disk(6899), "plate with slits": lambda: plate(1333),
         "ribs": lambda: ribs(150), "lathe part": lambda: lathe(600)}


def save_queries(folder, name, motion, chords, points):
    """Points and, for the peers, the chords of each inverted trajectory, `chords` a point."""
    times = [motion.inverse(k / chords) for k in range(chords + 1)]
    save(f"{folder}/{name}.points", (x for p in points for x in p))
    ends = ([apply(m, p) for m in times] for p in points)
    save(f"{folder}/{name}.segments", (x for c in ends for k in range(chords) for x in c[k] + c[k + 1]))


def measure(bench):
    """Every part under every motion: Graze in process against all intersections of the chords."""
    for part, make in PARTS.items():
        mesh = make()
        solid = "part.off"
        write_off(bench.path(solid), mesh)
        bench.table.head(f"{part}, {len(mesh[1]):,} faces, against CGAL's count of {CHORDS} chords a quarter turn")
        inside, peers = bench.inside(solid), bench.peers(solid)
        box = [tuple(f(v[k] for v in mesh[0]) for k in range(3)) for f in (min, max)]
        for name, (motion, chords, most) in MOTIONS.items():
            with open(bench.path("part.json"), "w", encoding="ascii") as file:
                file.write(motion.json)
            inside.ask("motion", bench.path("part.json"))
            total = max(500, min(bench.total, 100000 // chords))
            save_queries(bench.folder, "part", motion, chords, points_crossing(motion, box, total, 3))
            graze, peer, ratio, n = in_turns(
                bench.points(inside, "part"),
                lambda start, n, c=chords: peers.ask("count", bench.path("part.segments"), c * start, c * n)["seconds"],
                total, bench.target / 3, REPEATS)
            bench.table.row(f"{part}, {name} ({n:,} points)", ratio, most=most, graze=graze, peer=peer)
        inside.close()
        peers.close()
