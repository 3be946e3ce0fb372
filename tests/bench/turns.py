"""Parts as CAD exports them, slid and turned, beside CGAL's count of the chords of the same trajectories.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import random
import subprocess
import sys

from measure import in_turns, run_cpu
from scenes import Motion, apply, points_crossing, save, tan_half, write_off

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))
from parts import disk, lathe, plate, ribs  # noqa: E402

REPEATS = 5
AXIS, CENTRE = (2 / 7, 3 / 7, 6 / 7), (0.5, 0, 0)


def quarters(count):
    """An angle of `count` quarters; in each the tangent of the half angle runs from 0 to 1."""
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


POSES = 20, 500, 9990  # pieces


def write_poses(path, count):
    """Poses on one arc of 270 degrees, whatever their number."""
    with open(path, "w", encoding="ascii") as file:
        file.write("t,x,y,z,qw,qx,qy,qz\n")
        for k in range(count + 1):
            t, a = k / count, 1.5 * math.pi * k / count
            axis = [math.sin(a / 2) * x for x in AXIS]
            numbers = [t, 3 * math.cos(a) - 3, 3 * math.sin(a), t, math.cos(a / 2), *axis]
            file.write(",".join(map(repr, numbers)) + "\n")


def points_near_poses(count):
    """Points near the arc."""
    rng = random.Random(5)
    for _ in range(count):
        t = rng.random()
        a = 1.5 * math.pi * t
        centre, width = (3 * math.cos(a) - 3, 3 * math.sin(a), t), (1, 1, 0.6)
        yield tuple(x + rng.uniform(-w, w) for x, w in zip(centre, width))


def measure_poses(bench):
    """One path cut into few and into many pieces: what the pieces cost."""
    bench.table.head("Many pieces: one path, a disk of 2,236 faces; the peer is the path in 20 pieces")
    write_off(bench.path("part.off"), disk(559))
    save(bench.path("poses.points"), (x for p in points_near_poses(bench.total) for x in p))
    with open(bench.path("one.csv"), "w", encoding="ascii") as file:
        file.write("0,0,0\n")
    few, many = bench.inside("part.off"), bench.inside("part.off")
    for count in POSES:
        poses, motion = bench.path(f"poses{count}.csv"), bench.path(f"poses{count}.json")
        write_poses(poses, count)
        subprocess.run([bench.graze, "motion", "poses", poses, "--output", motion], check=True,
                       stderr=subprocess.DEVNULL)
        (few if count == POSES[0] else many).ask("motion", motion)
        if count == POSES[0]:
            continue
        peer, graze, ratio, n = in_turns(bench.points(few, "poses"), bench.points(many, "poses"), bench.total,
                                         bench.target / 3, REPEATS)
        bench.table.row(f"{count:,} pieces ({n:,} points)", 1 / ratio, most=3, graze=graze, peer=peer)
        loading, _ = run_cpu([bench.graze, "classify", "--jobs", "1", bench.path("part.off"), motion,
                              bench.path("one.csv")])
        bench.table.row(f"{count:,} pieces, a whole run for one point", loading, most=1, unit=" s")
    few.close()
    many.close()
