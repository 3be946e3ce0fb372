#!/usr/bin/env python3
"""The fifty scenes of the benchmark: writes a folder each, or lists them.

    python3 cases/benchmark/scenes.py --graze build/graze OUT [NAME...]
    python3 cases/benchmark/scenes.py --list
    python3 cases/benchmark/scenes.py --graze build/graze --table

A folder has solid.off, motion.json, scene.json, poses-101.csv and poses-1001.csv, as README.md describes them. All
is exact arithmetic, so that every machine makes the same bytes; Graze makes the motions of the two logs.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from fractions import Fraction as F

import poses
from motions import (ONE, ZERO, about, add, affine, along, is_straight, legs, motion_of, motion_text, poly, product, quarters, scaled, shifted,
                     spline, straight, times, turned, turning)
from solids import (Noise, ball, blocks, box, circle, disk, inside_out, lathe, moved, off, pattern, prism, rounded, sized, star, teeth, terrain,
                    together, torus)

FAMILIES = ("parts", "motions", "degenerate", "large", "adversarial")
POSES = (101, 1001)
POINTS, LOG_POINTS = 10000, 1000
SCENES = {}  # name: (family, words for solid and motion, function of graze that gives mesh and pieces)


def scene(family, words, log=False):
    def add_scene(make):
        SCENES[make.__name__.replace("_", "-")] = (family, words, make, log)
        return make
    return add_scene


# ------------------------------------------------------------------------------------------------ parts
@scene("parts", "angle bracket with two slots in the foot and a window in the wall, straight along a slanted way")
def bracket_straight(_):
    foot = pattern(["#######", "#.###.#", "#.###.#", "#######", "#######"])
    wall = [(i, 4, k) for k in (1, 2, 3) for i in range(7) if k != 2 or i not in (2, 3, 4)]
    return blocks(foot + wall, [0, 1, 2, 3, 5, 6, 7, 8], [0, F(3, 2), 2, F(5, 2), 4, 5], [0, 1, 3, 5, 6]), straight(10, 3, F(5, 2))


@scene("parts", "gear of 20 teeth with a bore, a quarter turn about its axis while it rises")
def gear_screw(_):
    return star(teeth(20, 4, 5, 6), [0, 1], bore=F(3, 2)), quarters(1, way=(0, 0, 3))


@scene("parts", "ring gear with 16 teeth inside, straight along its axis and then aside")
def ring_gear_legs(_):
    return star([6] * 96, [0, 1], bore=teeth(16, 4, F(7, 2), 6)), legs((0, 0, 0), (0, 0, 4), (5, 2, 4))


@scene("parts", "open-ended wrench, a quarter turn about a bolt")
def wrench_turn(_):
    outline = [(0, -1), (10, -1), (12, -3), (15, -3), (15, -1), (13, -1), (13, 1), (15, 1), (15, 3), (12, 3), (10, 1), (0, 1), (-2, F(3, 2)), (-2, F(-3, 2))]
    return prism(outline, 0, F(3, 4)), quarters(1, center=(14, 0, 0))


@scene("parts", "tube with a wall of 1/64 of its length, straight across")
def tube_across(_):
    wall = F(1, 8)
    return lathe([(2, 0), (2, 8), (2 - wall, 8), (2 - wall, 0)], 24, True), straight(5, 1, F(3, 2))


@scene("parts", "sheet metal box, open above, walls 1/50 of its length, along three legs")
def enclosure_legs(_):
    w = F(1, 8)
    at = [0, w, F(25, 4) - w, F(25, 4)]
    cells = [(i, j, k) for i in range(3) for j in range(3) for k in range(2) if k == 0 or (i, j) != (1, 1)]
    return blocks(cells, at, at, [0, w, 3]), legs((0, 0, 0), (4, 0, 1), (4, 3, 1), (6, 4, 4))


@scene("parts", "casting with two closed cavities and a bore, straight")
def casting_straight(_):
    body = prism([(0, 0), (9, 0), (10, 2), (10, 5), (8, 6), (1, 6), (0, 4)], 0, 4, [disk(F(3, 4), 16, 5, 3)])
    hollow = inside_out(moved(ball(3, F(5, 4)), 2, 3, 2))
    shaft = inside_out(moved(lathe([(1, 0), (F(1, 2), F(5, 2))], 12), F(15, 2), F(7, 2), F(3, 4)))
    return together(body, hollow, shaft), straight(6, 4, 3)


@scene("parts", "ball-end mill, along a parabola")
def mill_parabola(_):
    tip = [(2 * x, 2 - 2 * y) for x, y in circle(32)[8:0:-1]][1:]
    return lathe([(F(1, 4), 0), *tip, (2, 10), (F(3, 2), 12)], 20), [along(poly(0, 8), poly(0, 6, -6), poly(0, 0, 2))]


@scene("parts", "twist drill of two flutes, screwed in")
def drill_screw(_):
    radii = [F(1), F(7, 8), F(3, 4), F(1, 2), F(1, 4), F(1, 4), F(1, 2), F(7, 8)] * 2
    return star(radii, [F(k, 2) for k in range(13)], shift=1, steps=32), quarters(2, way=(0, 0, F(-3, 2)))


@scene("parts", "propeller of three twisted blades, turning once while it moves on along its axis")
def propeller_turn(_):
    blade = [F(1, 2), 1, 3, 4, 3, 1, F(1, 2), F(1, 2)] * 3
    return star(blade, [0, F(1, 8), F(1, 4), F(3, 8)], shift=1, steps=96), quarters(4, way=(0, 0, F(1, 2)))


# ------------------------------------------------------------------------------------------------ motions
def wedge():
    return prism([(0, 0), (4, 0), (4, 1), (1, 3), (0, 3)], 0, 2)


def hook():
    return blocks(pattern(["####", "#..#", "#..."], 1) + pattern(["#", "#"], 2), [0, 1, 2, 3, 4], [0, 1, 2, 3], [0, 1, 2])


@scene("motions", "wedge, straight")
def wedge_straight(_):
    return wedge(), straight(7, -3, F(9, 4))


@scene("motions", "hook, twelve straight legs")
def hook_legs(_):
    return hook(), legs((0, 0, 0), (3, 0, 0), (3, 2, 1), (5, 2, 3), (5, 6, 3), (2, 6, 4), (2, 8, 7), (0, 8, 7), (-3, 5, 6), (-3, 1, 6), (-5, 1, 3),
                        (-5, -2, 3), (-2, -4, 0))


@scene("motions", "hook, a screw of two turns about a slanted axis")
def hook_screw(_):
    return hook(), quarters(8, axis=(1, 2, 2), center=(6, 0, 0), way=(F(1, 2), 1, 1))


@scene("motions", "star-shaped body, tumbling about two axes while it flies")
def star_tumbling(_):
    return star([2, 1] * 5, [0, 1]), turning([((0, 0, 1), F(1)), ((1, 0, 0), F(1, 2))], 3, (0, 0, F(1, 2)), [poly(0, 4), ZERO, poly(0, 3, -1)])


@scene("motions", "gripper, a spline of eight cubic pieces")
def gripper_spline(_):
    jaw = prism([(0, 0), (6, 0), (6, 1), (2, 1), (2, 3), (6, 3), (6, 4), (0, 4)], 0, 2)
    points = [(0, 0, 0), (0, 0, 0), (6, 0, 6), (12, 6, 6), (12, 12, 0), (6, 12, -6), (0, 12, 0), (0, 6, 12), (6, 0, 12), (12, 0, 12), (18, 6, 6)]
    return jaw, spline(points)


@scene("motions", "wedge, a rational spline: two quarters of circles that bend either way, rising")
def wedge_rational(_):
    rise, first, second = poly(0, 2), poly(1, 0, 1), shifted(poly(1, 0, 1), 1)
    return wedge(), [along(poly(0, 0, -8), poly(0, 8), times(rise, first), 0, 1, first),
                     along(add(scaled(second, F(-4)), shifted(poly(0, -8), 1)), add(scaled(second, F(4)), shifted(poly(0, 0, 8), 1)),
                           times(rise, second), 1, 2, second)]


@scene("motions", "hook that grows, shears and moves: an affine motion of degree 2")
def hook_growing(_):
    return hook(), [affine([[poly(1, F(1, 2)), poly(0, 0, F(1, 4)), ZERO, poly(0, 6)],
                            [ZERO, poly(1, 0, F(1, 2)), poly(0, F(1, 4)), poly(0, 2, 1)],
                            [poly(0, F(-1, 8)), ZERO, poly(1, F(-1, 4)), poly(0, 1)]])]


@scene("motions", "roller of eight sides with a bore, a whole turn about its axis while it moves across it")
def roller_rolling(_):
    return star([2, 2, 2, 2, 2, F(5, 2), 2, 2], [0, 3], bore=F(1, 2)), quarters(4, way=(3, 0, 0))


@scene("motions", "hook held by an arm of six joints that turn uniformly, by `graze motion joints`", log=True)
def hook_joints(graze):
    made = graze("motion", "joints", "turn:40:0,0,1:9,-6,0", "turn:-25:0,1,0:6,0,-8", "turn:35:0,1,0:3,0,5", "turn:70:1,0,0:0,1,1", "turn:-50:0,1,0:1,1,1",
                 "turn:120:0,0,1:2,1,0", "--tolerance", "1e-3", "--radius", "8")
    return hook(), graze.pieces(made)


@scene("motions", "gripper held by an arm of six joints, 400 rows of a log, by `graze motion poses`", log=True)
def gripper_log(graze):
    jaw = prism([(0, 0), (6, 0), (6, 1), (2, 1), (2, 3), (6, 3), (6, 4), (0, 4)], 0, 2)
    return sized(jaw, F(1, 16)), graze.pieces(graze("motion", "poses", graze.file("log.csv", arm_log(400))))


ARM = (((0, 0, 1), (0, 0, 0)), ((0, 1, 0), (F(1, 4), 0, F(3, 4))), ((0, 1, 0), (0, 0, 1)), ((1, 0, 0), (F(1, 2), 0, 0)), ((0, 1, 0), (F(1, 2), 0, 0)),
       ((1, 0, 0), (F(1, 8), 0, 0)))  # axis and offset of each joint, from the foot to the hand


def arm_log(rows):
    """Poses of the hand in the foot's frame: times in hundredths, positions and quaternions with nine decimals, as a controller prints."""
    lines = ["t,x,y,z,qw,qx,qy,qz"]
    for k in range(rows):
        s = F(k, rows - 1)
        bends = (s * (1 - s), F(3, 4) * s - F(1, 4), F(1, 2) - s * s, s * (s - F(1, 2)), F(1, 4) + s * (1 - s), 2 * s - 1)  # tan of half the angle
        q, at = (F(1), F(0), F(0), F(0)), [F(0)] * 3
        for (axis, offset), bend in zip(ARM, bends):
            at = [a + b for a, b in zip(at, rotated(q, offset))]
            q = lowest_first(product(tuple([c] for c in q), about(axis, [bend])))
        length = F(math.isqrt(int(sum(c * c for c in q) * 10 ** 40)), 10 ** 20)
        lines.append(",".join([poses.decimal(F(k, 100)), *(poses.decimal(rounded(c, 10 ** 9)) for c in at),
                               *(poses.decimal(rounded(c / length, 10 ** 9)) for c in q)]))
    return "\n".join(lines) + "\n"


def lowest_first(q):
    return tuple(a[0] for a in q)


def rotated(q, v):
    """The image of v under the rotation of q."""
    _, _, rows, weight = turned(tuple([c] for c in q))
    return [sum(a[0] * c for a, c in zip(row, v)) / weight[0] for row in rows]


# ------------------------------------------------------------------------------------------------ degenerate
@scene("degenerate", "box along an axis: faces parallel to the motion, the end where the start leaves off")
def box_along_axis(_):
    return box((0, 0, 0), (2, 1, 1)), straight(2, 0, 0)


@scene("degenerate", "bar, a whole turn about its own end: closed, the first pose is the last")
def bar_closed_turn(_):
    return box((0, F(-1, 2), 0), (4, F(1, 2), 1)), quarters(4)


@scene("degenerate", "cross of four arms, a quarter turn about its axis: the last pose is the first, turned into itself")
def cross_quarter_turn(_):
    return blocks(pattern([".#.", "###", ".#."]), [-3, -1, 1, 3], [-3, -1, 1, 3], [0, 1]), quarters(1)


@scene("degenerate", "wedge, out and back along the same two legs, with a rest between")
def wedge_retracing(_):
    out = legs((0, 0, 0), (4, 0, 0), (4, 3, 2), (4, 3, 2), (4, 0, 0), (0, 0, 0))
    return wedge(), out


@scene("degenerate", "octahedron along two parabolas with one tangent where they meet and a cusp: kinks that are tangential")
def octahedron_kinks(_):
    body = ball(1, 2)
    return body, [along(poly(0, 4), poly(0, 4, -4), ZERO, 0, 1), along(shifted(poly(4, 4), 1), shifted(poly(0, -4, 4), 1), ZERO, 1, 2),
                  along(shifted(poly(8, 0, -4), 2), shifted(poly(0, 0, 4, -4), 2), ZERO, 2, 3)]


@scene("degenerate", "box that stops and rests: speeds that vanish at breaks to orders 2 and 3")
def box_stops(_):
    return box((0, 0, 0), (2, 1, 1)), [along(poly(0, 0, 4), ZERO, ZERO, 0, 1), along(poly(4), ZERO, ZERO, 1, 2),
                                       along(poly(4), shifted(poly(0, 0, 0, 3), 2), ZERO, 2, 3),
                                       along(shifted(poly(4, 0, 3, -2), 3), poly(3), shifted(poly(0, 0, 0, 2), 3), 3, 4)]


@scene("degenerate", "twin spikes along a parabola: vertices that touch the level of the base, edges that graze")
def spikes_grazing(_):
    pyramid = ([(F(-1), F(-1), F(0)), (F(1), F(-1), F(0)), (F(1), F(1), F(0)), (F(-1), F(1), F(0)), (F(0), F(0), F(2))],
               [(0, 2, 1), (0, 3, 2), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)])
    return together(pyramid, moved(pyramid, 4, 0, 0)), [along(poly(0, 8), ZERO, poly(0, -8, 8))]


@scene("degenerate", "staircase, slid along its own treads and risers")
def stairs_sliding(_):
    return blocks(pattern(["####", ".###", "..##", "...#"], 2), range(5), range(5), range(3)), legs((0, 0, 0), (1, 0, 0), (1, 1, 0), (2, 1, 0), (2, 1, 2), (2, 2, 2), (0, 0, 2))


@scene("degenerate", "door, a half turn about the edge that it hangs on: vertices that stand still")
def door_hinge(_):
    return box((0, 0, 0), (4, F(1, 2), 6)), quarters(2)


@scene("degenerate", "cube in three rows that touch along seams, and back: closed")
def cube_seams(_):
    return box((0, 0, 0), (1, 1, 1)), legs((0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0), (0, 2, 0), (2, 2, 1), (0, 0, 1), (0, 0, 0))


# ------------------------------------------------------------------------------------------------ large
@scene("large", "wavy torus, 20,000 triangles, straight")
def torus_straight(_):
    return torus(200, 50, 4, 1, 7), straight(5, 2, F(3, 2))


@scene("large", "ball, 20,000 triangles, along a parabola")
def ball_parabola(_):
    return ball(50, 2), [along(poly(0, 8), poly(0, 6, -6), poly(0, 0, 2))]


@scene("large", "rock, 10,000 triangles, tumbling about two axes")
def rock_tumbling(_):
    return ball(36, 2, Noise(1), F(1, 8)), turning([((0, 0, 1), F(1, 2)), ((1, 0, 0), F(1, 4))], 2, (0, 0, 0), [poly(0, 4), ZERO, poly(0, 3, -1)])


@scene("large", "block with a rough top, 50,000 triangles, two straight legs")
def terrain_legs(_):
    return terrain(158, F(1, 16), Noise(2), 2), legs((0, 0, 0), (3, 1, 2), (6, 6, 2))


@scene("large", "scaffold of square bars, 22,800 triangles, straight")
def scaffold_straight(_):
    n = 9
    at = [x for k in range(n + 1) for x in (k, k + F(1, 4))]
    cells = [(i, j, k) for i in range(2 * n + 1) for j in range(2 * n + 1) for k in range(2 * n + 1) if (i % 2) + (j % 2) + (k % 2) <= 1]
    return blocks(cells, at, at, at), straight(F(5, 2), F(7, 4), F(9, 8))


@scene("large", "helical gear of 24 teeth, 15,000 triangles, two teeth on about its axis while it rises")
def helical_gear_screw(_):
    # Twice the angle of tangent 1/4 is 28 degrees, a tooth 15.
    body = star(teeth(24, 6, 7), [F(k, 16) for k in range(19)], shift=1, bore=2)
    return body, turning([((0, 0, 1), F(1, 4))], way=(ZERO, ZERO, poly(0, 2)))


@scene("large", "rock, 10,000 triangles, a million of its sizes from the origin, straight")
def rock_far(_):
    return moved(ball(36, 2, Noise(3), F(1, 8)), 2 ** 21, -2 ** 20, 2 ** 22), straight(5, 4, -2)


@scene("large", "rock of the size 2^-30, 10,000 triangles, along a cubic")
def rock_tiny(_):
    u = F(1, 2 ** 30)
    return sized(ball(36, 2, Noise(4), F(1, 8)), u), [along(poly(0, 8 * u), poly(0, 6 * u, -12 * u, 6 * u), poly(0, 0, 2 * u))]


@scene("large", "torus of the size 2^40, 12,800 triangles, screwed")
def torus_huge(_):
    return sized(torus(160, 40, 4, 1, 5), 2 ** 40), quarters(1, axis=(2, 3, 6), center=(2 ** 43, 0, 0), way=(2 ** 42, 0, 0))


@scene("large", "wavy torus, 100,000 triangles, straight")
def torus_hundred_thousand(_):
    return torus(500, 100, 4, 1, 9), straight(3, -1, 2)


# ------------------------------------------------------------------------------------------------ adversarial
@scene("adversarial", "unit cube in eight positions each 1/4 on from the last, as in libigl's issue 2562, straight")
def igl_2562(_):
    return box((0, 0, 0), (1, 1, 1)), straight(F(7, 4), 0, 0)


@scene("adversarial", "plate 1/50 of its length thick, turning about two of its edges while it moves on")
def plate_fifty(_):
    return box((0, 0, 0), (F(25, 4), 4, F(1, 8))), turning([((0, 1, 0), F(1, 2)), ((0, 0, 1), F(1, 4))], 1, (0, 0, 0), (poly(0, 4), ZERO, poly(0, 2)))


@scene("adversarial", "plate 1/1024 of its length thick, by its length along its normal, then aside in its own plane")
def plate_thousand(_):
    return box((0, 0, 0), (8, 8, F(1, 128))), legs((0, 0, 0), (F(1, 4), 0, 8), (F(33, 4), 2, 8))


@scene("adversarial", "comb whose slots, 2^-8 to 2^-16 wide, lie along the motion, straight")
def comb_slots(_):
    ys, at = [], F(0)
    for k in range(5):
        ys += [at, at + 1]
        at += 1 + F(1, 2 ** (8 + 2 * k))
    cells = [(0, j, 0) for j in range(9)] + [(1, j, 0) for j in range(0, 9, 2)]
    return blocks(cells, [0, 1, 4], ys, [0, 2]), straight(6, 0, 0)


@scene("adversarial", "cube that comes by itself at gaps of 2^-10, 2^-20, 2^-30 and 2^-40, eleven legs")
def cube_gaps(_):
    way, at = [(F(0), F(0), F(0))], F(0)
    for k in (10, 20, 30, 40):
        at += 1 + F(1, 2 ** k)
        last = way[-1]
        other = F(4) - last[0]
        way += [(other, last[1], F(0)), (other, at, F(0))] if k < 40 else [(other, last[1], F(0)), (other, last[1], F(2)), (other, at, F(2)), (other, at, F(0)), (last[0], at, F(0))]
    return box((0, 0, 0), (1, 1, 1)), legs(*way)


@scene("adversarial", "block with holes 2^-6 to 2^-12 wide along the motion, straight")
def block_holes(_):
    holes = [[(x, y), (x + w, y), (x + w, y + w), (x, y + w)] for x, y, w in ((1, 1, F(1, 64)), (3, 1, F(1, 256)), (1, 3, F(1, 1024)), (3, 3, F(1, 4096)))]
    return prism([(0, 0), (4, 0), (4, 4), (0, 4)], 0, 2, holes), straight(0, 0, 5)


@scene("adversarial", "needle that darts out and back in 2^-12 of the time, between poses")
def needle_dart(_):
    body = prism([(0, 0), (2, 0), (F(1, 2), F(1, 4)), (0, 2)], 0, 1)
    middle, short = F(1, 2) + F(1, 2 ** 11), F(1, 2 ** 13)
    return body, legs((0, 0, 0), (1, 0, 0), (1, -4, 3), (1, 0, 0), (2, 0, 1), times_of=[0, middle - short, middle, middle + short, 1])


@scene("adversarial", "slab that goes aside and comes back 2^-24 above where it was: a crack between")
def slab_bend(_):
    # 35 t^4 - 84 t^5 + 70 t^6 - 20 t^7 leaves 0 and reaches 1 to the fourth order, so that the slab slides off and on.
    above = F(1, 4) + F(1, 2 ** 24)
    return box((0, 0, 0), (1, 8, F(1, 4))), [along(poly(0, 8, -8), ZERO, scaled(poly(0, 0, 0, 0, 35, -84, 70, -20), above))]


@scene("adversarial", "sector that turns about its tip until about 2^-32 of an angle is missing to close the ring")
def sector_almost_closed(_):
    # Its own angle has the tangent 7/24 and the cosine 24/25; 3/4 = (1 - 7/25) / (24/25) is the tangent of half of what a quarter leaves.
    body = prism([(F(3, 2), 0), (6, 0), (6, F(7, 4)), (F(3, 2), F(7, 16))], 0, 1)
    last = product(about((0, 0, 1), shifted(poly(0, F(3, 4) - F(1, 2 ** 32)), 3)), (poly(1), ZERO, ZERO, poly(-1)))
    return body, [*quarters(3), turned(last, 3, 4)]


@scene("adversarial", "two jaws that shrink until 2^-39 is left between them: an affine motion")
def jaws_shrinking(_):
    low = F(1, 2 ** 40)
    return (together(box((0, 0, 1), (4, 2, 2)), box((0, 0, -2), (4, 2, -1))),
            [affine([[ONE, ZERO, ZERO, poly(0, 1)], [ZERO, ONE, ZERO, ZERO], [ZERO, ZERO, poly(1, low - 1), ZERO]])])


# ------------------------------------------------------------------------------------------------ files
class Graze:
    """The program, as the functions of scenes call it."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def __call__(self, *words):
        done = subprocess.run([self.program, *words], check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if done.returncode:
            raise SystemExit(f"scenes.py: {' '.join(words[:2])}: {done.stderr}")
        return done.stdout

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        write(path, text)
        return path

    def pieces(self, motion):
        """The motion's pieces, by `graze convert`."""
        plain = os.path.join(self.folder, "plain.json")
        self("convert", self.file("motion.json", motion), "-o", plain)
        with open(plain, encoding="ascii") as file:
            return motion_of(file.read())


def write(path, text):
    """Whole, or not at all: a run may be ended here, and scene.json tells the next one that a scene is made."""
    with open(path + ".part", "w", encoding="ascii", newline="\n") as file:
        file.write(text)
    os.replace(path + ".part", path)


def diagonal(vertices):
    """Of the box of the vertices, as the double below."""
    corners = poses.box_corners(vertices)
    square = sum((F(b) - a) ** 2 for a, b in zip(corners[0], corners[-1]))
    return math.nextafter(poses.root_above(square), 0)


def write_scene(graze, out, name):
    family, _, make, log = SCENES[name]
    mesh, pieces = make(graze)
    folder = os.path.join(out, name)
    os.makedirs(folder, exist_ok=True)
    write(os.path.join(folder, "solid.off"), off(mesh))
    write(os.path.join(folder, "motion.json"), motion_text(pieces))
    tables = {count: poses.table(pieces, mesh[0], count) for count in POSES}
    for count, (text, _) in tables.items():
        write(os.path.join(folder, f"poses-{count}.csv"), text)
    facts = {"name": name, "family": family, "count": LOG_POINTS if log else POINTS, "seed": list(SCENES).index(name) + 1,
             "straight": is_straight(pieces), "diagonal": diagonal(mesh[0]), "poses": {str(count): {"deviation": bound} for count, (_, bound) in tables.items()}}
    write(os.path.join(folder, "scene.json"), json.dumps(facts, indent=1) + "\n")


def degree(pieces):
    return max(len(a) - 1 for _, _, rows, weight in pieces for a in (weight, *(a for row in rows for a in row)))


def print_table(graze):
    """The scenes in Markdown."""
    print("| scene | family | triangles | pieces | degree | straight | what it is |\n|---|---|--:|--:|--:|---|---|")
    for name, (family, words, make, _) in SCENES.items():
        mesh, pieces = make(graze)
        cells = (name, family, len(mesh[1]), len(pieces), degree(pieces), "yes" if is_straight(pieces) else "", words)
        print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def chosen(names):
    unknown = [name for name in names if name not in SCENES]
    if unknown:
        raise SystemExit(f"scenes.py: no scene {unknown[0]}; --list has their names")
    return names or list(SCENES)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--list", action="store_true", help="name, family and words of each, between tabs, and write nothing")
    parser.add_argument("--table", action="store_true", help="all that in Markdown, and triangles, pieces of the motion, its degree, and whether it is straight")
    parser.add_argument("out", nargs="?")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    if options.list:
        for name, (family, words, *_) in SCENES.items():
            print(name, family, words, sep="\t")
        return
    if not options.table and not options.out:
        parser.error("expected a folder to write to, --list or --table")
    with tempfile.TemporaryDirectory() as folder:
        graze = Graze(os.path.abspath(options.graze), folder)
        if options.table:
            print_table(graze)
            return
        for name in chosen(options.names):
            write_scene(graze, options.out, name)


if __name__ == "__main__":
    sys.exit(main())
