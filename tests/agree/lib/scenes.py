"""The scenes of the agreement tests: every solid with several motions of every sort.

SPDX-License-Identifier: GPL-3.0-or-later

Motions: legs with break points and turning points, polynomial and rational translations up to
degree six, rotations by tan_half, turns, complex and quaternion keyframes, scalings, reflections,
shears, and all of them run through squares, which makes rational contact times square roots.
"""
import random

from exact import Fraction as F

from motion import build, compose, keyframes, legs, matrix, quaternion, rotation, scaling, squared
from motion import translate, turn
from solids import meshes, polygons


def plane_motions():
    rot = compose(rotation([0, 1], center=[F(1), F(1)]), translate([[0, 3], [0, 0, 4]]))
    spin = compose(turn(3, center=[F(1), F(0)]), translate([[0, 6], [0, 2]], "s"))
    return {
        "legs": legs([(0, 0), (12, 0), (3, 0), (3, 9), (-9, 9)]),
        "there_and_back": legs([(9, 1), (-2, 0), (9, 1), (9, -12)], [0, F(2, 3), F(5, 2), 3]),
        "parabola": build([(-3, 3, translate([[0, 3], [-6, 0, 1]]))]),
        "sextic": build([(F(-3, 2), F(3, 2), translate([[0, 0, 0, 4], [-3, 0, 0, 0, 0, 0, 1]]))]),
        "rational": build([(0, 2, matrix([[[1, 0, 1], [0, 1], [0, 9, 0, 1]],
                                          [[0, -1], [1, 0, 1], [-2, 0, 5]]], [1, 0, 1]))]),
        "rotation": build([(-1, 1, rot)]),
        "double_rotation": build([(-1, 1, compose(rotation([0, 1], times=2),
                                                  translate([[0, 4], [0, -1]])))]),
        "turns": build([(0, 3, spin)]),
        "scaling": build([(0, 2, compose(
            scaling([[1, F(1, 2)], [2, F(-1, 2)]], center=[F(1), F(1)]),
            translate([[0, 0, 2], [0, 3]])))]),
        "mirror": build([(0, 1, compose(scaling([[-1, F(-1, 2)], [1, 1]]),
                                        translate([[-4, 14], [1, -2]])))]),
        "keyframes": keyframes([(0, (0, 0), (1, 0)), (1, (8, 1), (1, 1)), (3, (0, 6), (0, 1))]),
        "shear": build([(-1, 1, matrix([[[1], [0, 1], [0, 5]], [[0, 0, 1], [2], [0, 0, 0, 6]]],
                                       [1]))]),
    }


def space_motions():
    axis = rotation([0, 1], center=[F(1), F(0), F(1)], axis=[1, 2, 2], length=3)
    return {
        "legs": legs([(0, 0, 0), (8, 0, 0), (2, 0, 0), (2, 0, 7), (-6, 4, 7)]),
        "parabola": build([(-2, 2, translate([[0, 4], [-2, 0, 1], [1, 1]]))]),
        "sextic": build([(F(-3, 2), F(3, 2), translate([[0, 0, 0, 3], [0, 2],
                                                        [-2, 0, 0, 0, 0, 0, 1]]))]),
        "rotation": build([(-1, 1, compose(axis, translate([[0, 4], [0], [0, 1]])))]),
        "upright": build([(0, 1, compose(rotation([0, 1], center=[F(2), F(2), F(0)],
                                                  axis=[0, 0, 1], length=1),
                                         translate([[0, 6], [0, 0, 2], [0]])))]),
        "turns": build([(0, 2, compose(turn(3, axis=[0, 0, 2], length=2),
                                       translate([[0, 5], [0, 1], [0, 1]], "s")))]),
        "quaternion": build([(0, 1, compose(quaternion([[2], [0, 1], [1, 1], [0, -1]]),
                                            translate([[0, 7], [0, -2], [0]])))]),
        "keyframes": keyframes([(0, (0, 0, 0), (1, 0, 0, 0)), (1, (6, 0, 1), (1, 1, 0, 1)),
                                (F(5, 2), (0, 5, 0), (0, 1, 0, 1))]),
        "scaling": build([(0, 2, compose(scaling([[1, F(1, 2)], [2, F(-1, 2)], [1]]),
                                         translate([[0, 5], [0], [0, 0, 2]])))]),
        "mirror": build([(0, 1, compose(scaling([[-1, F(-1, 2)], [1, 1], [1]]),
                                        translate([[-4, 14], [1, -2], [0, 2]])))]),
    }


def chosen(args, where, solids, motions, count):
    """(name, solid, motion): `count` of them at scale 1; of 0, every solid and every motion at least once."""
    every = max(len(solids), len(motions))
    for k in args.rounds(count or every, where):
        turn, j = divmod(k, every)
        pairing = random.Random(f"{args.seed} {where} {turn}")
        names, tracks = (pairing.sample(list(x), len(x)) for x in (solids, motions))
        s, m = names[j % len(names)], tracks[j % len(tracks)]
        motion = motions[m]
        if (j + turn) % 3 == 2:
            m, motion = m + "_squared", squared(motion)[0]
        yield f"{s} {m}", solids[s], motion


def plane_scenes(args, count=0):
    return chosen(args, "plane", polygons(), plane_motions(), count)


def space_scenes(args, count=0):
    return chosen(args, "space", meshes(), space_motions(), count)


def scenes(args, count=0):
    """In the plane, and in space; `count` of each at scale 1."""
    yield from plane_scenes(args, count)
    yield from space_scenes(args, count)
