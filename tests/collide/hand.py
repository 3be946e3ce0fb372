# suite
"""Pairs whose words, times and cells are derived by hand, in the plane and in space.

SPDX-License-Identifier: GPL-3.0-or-later

S is the moving solid, Q the fixed one, b the translation. Above each scene stands its derivation. A contact is
(from, to, number of pairs of cells by type); where the pairs are few, their names too. At rational times the names of
all pairs are compared with those that meeting.py finds by clipping. `block` numbers the vertices of a box by
x + 2 y + 4 z, its facets z0, z1, y0, y1, x0, x1; `box_ring` goes round from the lower left corner.
"""
import json
from collections import Counter

from meeting import meeting_cells
from exact import Fraction as F, to_double
from pairs import Checks, Collide, cell_pairs, first_agrees, kind_of, options, time_is

from algebra import Root  # noqa: E402
from motion import build, compose, legs, matrix, rotation, scaling, translate, turn  # noqa: E402
from oracle import Oracle  # noqa: E402
from shells import shells_text  # noqa: E402
from solids import Mesh, Polygon, block, box_ring, edge, extruded, inside_out, joined, prism, ring  # noqa: E402

CUBE = block(0, 0, 0, 1, 1, 1)
SQUARE = Polygon([[box_ring(0, 0, 1, 1)]])
OCTA = Mesh([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
            [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
SLAB = block(-9, -9, -1, 9, 9, 0)
FULL_FACE = {"facet-facet": 1, "edge-edge": 4, "vertex-vertex": 4}
FACE_IN_FACE = {"facet-facet": 1, "edge-facet": 4, "vertex-facet": 4}
TINY = F(1, 2 ** 60)

SCENES = []


def root(poly, low, high):
    return Root(poly=poly, lo=F(low), hi=F(high))


def scene(name, moving, motion, fixed, word, *contacts, frame=None, flags=()):
    SCENES.append((name, moving, motion, fixed, word, contacts, frame, flags))


def moved(low, high, *polys):
    return build([(low, high, translate([list(p) for p in polys]))])


def along(z):
    """The plane (x, y) as (x, z) with y along the prism from -z to z; it mirrors."""
    return lambda r: prism(r, -z, z).mapped(lambda p: (p[0], p[2], p[1]), True)


def across(r, z):
    """The plane (x, y) as (y, z) with x along the prism from -z to z."""
    return prism(r, -z, z).mapped(lambda p: (p[2], p[0], p[1]))


def plane(*rings):
    return Polygon([[r] for r in rings])


# --------------------------------------------------------------------------------------- head on

# S = [t, t + 1] x [0, 1]^2 meets Q = [3, 4] x [0, 1]^2 where t + 1 >= 3 and t <= 4. At both times two equal closed
# squares lie on one another: a facet, four edges, four vertices, each on its twin alone.
WALL = block(3, 0, 0, 4, 1, 1)
scene("head on, touching at the end alone", CUBE, moved(0, 2, [0, 1], [0], [0]), WALL, "OB", (2, 2, FULL_FACE))
scene("head on", CUBE, moved(0, 3, [0, 1], [0], [0]), WALL, "OBI", (2, 2, FULL_FACE))
scene("head on and through", CUBE, moved(0, 5, [0, 1], [0], [0]), WALL, "OBIBO", (2, 2, FULL_FACE), (4, 4, FULL_FACE))
scene("from inside out", CUBE, moved(3, 5, [0, 1], [0], [0]), WALL, "IBO", (4, 4, FULL_FACE))
scene("touching at the start alone", CUBE, moved(0, 1, [2, -1], [0], [0]), WALL, "BO", (0, 0, FULL_FACE))
# x = 2 - t (2 - t) is 2 at 0 and 2, less between them
scene("touching at both ends", CUBE, moved(0, 2, [2, -2, 1], [0], [0]), WALL, "BOB", (0, 0, FULL_FACE), (2, 2, FULL_FACE))
# [1/3, 4/3]^2 on [0, 1]^2: the corner (1/3, 1/3) and two sides of the one lie in the other, (1, 1) and two sides the
# other way, and sides cross at (1, 1/3) and (1/3, 1)
scene("head on askew", CUBE, moved(0, 3, [0, 1], [F(1, 3)], [F(1, 3)]), WALL, "OBI",
      (2, 2, {"facet-facet": 1, "edge-facet": 2, "vertex-facet": 1, "facet-edge": 2, "facet-vertex": 1, "edge-edge": 2}))
# the same squares in the plane: sides x = 1 + t and x = 3
scene("head on in the plane", SQUARE, moved(0, 5, [0, 1], [0]), plane(box_ring(3, 0, 4, 1)), "OBIBO",
      (2, 2, {"edge-edge": 1, "vertex-vertex": 2}, {(edge(1, 2), edge(3, 0)), (("vertex", 1), ("vertex", 0)),
                                                    (("vertex", 2), ("vertex", 3))}),
      (4, 4, {"edge-edge": 1, "vertex-vertex": 2}, {(edge(3, 0), edge(1, 2)), (("vertex", 0), ("vertex", 1)),
                                                    (("vertex", 3), ("vertex", 2))}))

# ---------------------------------------------------------------------------- vertices and edges

# the octahedron's lowest vertex 5 is at height (1 + t^2) - 1 = t^2 over the slab's facet z1
scene("a vertex grazes a face", OCTA, moved(-1, 1, [0, 1], [0], [1, 0, 1]), SLAB, "OBO",
      (0, 0, {"vertex-facet": 1}, {(("vertex", 5), ("face", 1))}))
scene("a vertex enters a face", OCTA, moved(-1, 1, [0], [0], [1, -1]), SLAB, "OBI",
      (0, 0, {"vertex-facet": 1}, {(("vertex", 5), ("face", 1))}))
# the box's floor is at height 2 - t, the octahedron's highest vertex 4 at 1
scene("a face comes down on a vertex", block(-1, -1, 2, 1, 1, 4), moved(0, 2, [0], [0], [0, -1]), OCTA, "OBI",
      (1, 1, {"facet-vertex": 1}, {(("face", 0), ("vertex", 4))}))
# vertex 5 at height t^2 - e^2: roots -e and e, and inside between them; at t^2 + e^2 it misses. t^2 - e^2 / 2 has
# irrational roots, those of 2 t^2 - e^2
GRAZE = {"vertex-facet": 1}, {(("vertex", 5), ("face", 1))}
for bits in (30, 150, 550):
    e = F(1, 2 ** bits)
    scene(f"a vertex grazes 2^-{2 * bits} too deep", OCTA, moved(-1, 1, [0, 1], [0], [1 - e * e, 0, 1]), SLAB, "OBIBO",
          (-e, -e, *GRAZE), (e, e, *GRAZE))
    scene(f"a vertex misses by 2^-{2 * bits}", OCTA, moved(-1, 1, [0, 1], [0], [1 + e * e, 0, 1]), SLAB, "O")
    late, early = root([-1, 0, 2 ** (2 * bits + 1)], 0, 1), root([-1, 0, 2 ** (2 * bits + 1)], -1, 0)
    scene(f"a vertex grazes 2^-{2 * bits + 1} too deep", OCTA, moved(-1, 1, [0, 1], [0], [1 - e * e / 2, 0, 1]), SLAB, "OBIBO",
          (early, early, *GRAZE), (late, late, *GRAZE))

# A roof with its ridge 0-3 up along y, |y| <= 3, and one upside down, its ridge 0-3 along x, |x| <= 3, at z = 0. The
# ridges cross in (0, 0, 0) when b = (0, 0, 0), and no other parts have z = 0.
ROOF = along(3)(ring((0, 0), (-1, -2), (1, -2)))
UPSIDE_DOWN = across(ring((0, 0), (1, 2), (-1, 2)), 3)
RIDGES = ({"edge-edge": 1}, {(edge(0, 3), edge(0, 3))})
scene("crossed ridges touch at the end", ROOF, moved(0, 1, [0], [0], [-1, 1]), UPSIDE_DOWN, "OB", (1, 1, *RIDGES))
scene("crossed ridges touch and enter", ROOF, moved(0, 2, [0], [0], [-1, 1]), UPSIDE_DOWN, "OBI", (1, 1, *RIDGES))
scene("crossed ridges touch for an instant", ROOF, moved(0, 2, [0], [0], [-1, 2, -1]), UPSIDE_DOWN, "OBO", (1, 1, *RIDGES))
# at height 0 all the time the ridges cross while x = t is in [-3, 3]; first at the vertex x = -3, number 0
scene("crossed ridges slide", ROOF, moved(-4, 4, [0, 1], [0], [0]), UPSIDE_DOWN, "OBO",
      (-3, 3, {"edge-vertex": 1}, {(edge(0, 3), ("vertex", 0))}))
# the ridge, ends included, within the ceiling z = 0 of a slab
scene("a ridge meets a face", ROOF, moved(0, 2, [0], [0], [-1, 1]), block(-9, -9, 0, 9, 9, 1), "OBI",
      (1, 1, {"edge-facet": 1, "vertex-facet": 2},
       {(edge(0, 3), ("face", 0)), (("vertex", 0), ("face", 0)), (("vertex", 3), ("face", 0))}))
# Squares on their tips: S = |x| + |y - 2 + t| <= 1 falls on the ground y <= 0 with its tip 3
DIAMOND = plane(ring((1, 0), (0, 1), (-1, 0), (0, -1)))
GROUND = plane(box_ring(-9, -1, 9, 0))
scene("a tip on the ground", DIAMOND, moved(0, 2, [0], [2, -1]), GROUND, "OBI",
      (1, 1, {"vertex-edge": 1}, {(("vertex", 3), edge(2, 3))}))
# tip 0 at (t - 2 + 1, 0) meets tip 2 at (1, 0); then they overlap
scene("tip against tip", DIAMOND, moved(0, 3, [-2, 1], [0]), DIAMOND.mapped(lambda p: (p[0] + 2, p[1])), "OBI",
      (2, 2, {"vertex-vertex": 1}, {(("vertex", 0), ("vertex", 2))}))

# ----------------------------------------------------------------------------------------- slides

# S stands on z = 1 where Q = [2, 4] x [0, 1] x [0, 1] ends: [t, t + 1] meets [2, 4] from 1 to 4. First its lower edge
# x = 1 (vertices 1 and 3) is on the edge x = 2, z = 1 of Q (vertices 4 and 6).
scene("parallel faces slide", CUBE, moved(0, 6, [0, 1], [0], [1]), block(2, 0, 0, 4, 1, 1), "OBO",
      (1, 4, {"edge-edge": 1, "vertex-vertex": 2},
       {(edge(1, 3), edge(4, 6)), (("vertex", 1), ("vertex", 4)), (("vertex", 3), ("vertex", 6))}))
# a little higher it misses
for bits in (60, 1100):
    scene(f"parallel faces 2^-{bits} apart", CUBE, moved(0, 6, [0, 1], [0], [1 + F(1, 2 ** bits)]), block(2, 0, 0, 4, 1, 1), "O")
# [t^2, t^2 + 1] meets [3, 5] where t^2 is in [2, 5]
scene("a slide between irrational times", CUBE, moved(0, 3, [0, 0, 1], [0], [1]), block(3, 0, 0, 5, 1, 1), "OBO",
      (root([-2, 0, 1], 1, 2), root([-5, 0, 1], 2, 3), {"edge-edge": 1, "vertex-vertex": 2}))
# S fits between Q's two blocks exactly, from z = 1 to z = 2: B from where it enters at x = 2 until it leaves at x = 4
scene("a slide between two blocks", CUBE, moved(0, 6, [0, 1], [0], [1]),
      joined(block(2, 0, 0, 4, 1, 1), block(2, 0, 2, 4, 1, 3)), "OBO", (1, 4, {"edge-edge": 2, "vertex-vertex": 4}))
# first beside, then on: legs (0,0) to (2,0) with S on top of Q = [2, 4], then down into it
scene("a slide that dives", SQUARE, legs([(0, 1), (2, 1), (2, 0)]), plane(box_ring(2, 0, 4, 1)), "OBI",
      (F(1, 2), 1, {"vertex-vertex": 1}, {(("vertex", 1), ("vertex", 3))}))

# ------------------------------------------------------------------------------ holes and cavities

# A bar [2, 4]^2 x [2, 5] goes down through the hole [2, 4]^2 of a plate of height 1: its floor 2 - t reaches z = 1 at
# t = 1, its roof 5 - t reaches z = 0 at t = 5. First its floor's border lies on the rim of the hole.
PLATE = extruded(Polygon([[box_ring(0, 0, 6, 6), box_ring(2, 2, 4, 4)]]), [0, 1])[0]
scene("a key in its hole", block(2, 2, 2, 4, 4, 5), moved(0, 7, [0], [0], [0, -1]), PLATE, "OBO",
      (1, 5, {"edge-edge": 4, "vertex-vertex": 4}))
scene("a thin key in a hole", block(F(5, 2), 2 + TINY, 2, F(7, 2), 3, 5), moved(0, 7, [0], [0], [0, -1]), PLATE, "O")
# a slot [2, 4] x [1, 3], open above, and a key as wide: its corners 0, 1 at height 5 - t meet the slot's corners when
# t = 2, its floor the bottom when t = 4
SLOT = plane(ring((0, 0), (6, 0), (6, 3), (4, 3), (4, 1), (2, 1), (2, 3), (0, 3)))
scene("a key to the bottom", plane(box_ring(2, 5, 4, 7)), moved(0, 4, [0], [0, -1]), SLOT, "OB",
      (2, 4, {"vertex-vertex": 2}, {(("vertex", 0), ("vertex", 6)), (("vertex", 1), ("vertex", 3))}))
scene("a key through the bottom", plane(box_ring(2, 5, 4, 7)), moved(0, 5, [0], [0, -1]), SLOT, "OBI",
      (2, 4, {"vertex-vertex": 2}))
# narrower: nothing before the floor and its two corners are on the bottom edge, 4-5
scene("a narrow key to the bottom", plane(box_ring(F(5, 2), 5, F(7, 2), 7)), moved(0, 4, [0], [0, -1]), SLOT, "OB",
      (4, 4, {"edge-edge": 1, "vertex-edge": 2},
       {(edge(0, 1), edge(4, 5)), (("vertex", 0), edge(4, 5)), (("vertex", 1), edge(4, 5))}))
# A ring with a hole [2, 4]^2 and z from 0 to 2 goes down around a post [11/4, 13/4]^2 x [-5, 5] from height 10 in one
# unit of time, then sidewards by 2 s: the wall x = 2 + 2 s meets the post's x = 11/4 when s = 3/8. Two edges of the
# post cross that wall, two of the wall cross the post's facet, and they cross one another in four points.
RING = extruded(Polygon([[box_ring(0, 0, 6, 6), box_ring(2, 2, 4, 4)]]), [0, 2])[0]
scene("a ring around a post", RING, legs([(0, 0, 10), (0, 0, 0), (2, 0, 0)]),
      block(F(11, 4), F(11, 4), -5, F(13, 4), F(13, 4), 5), "OBI",
      (F(11, 8), F(11, 8), {"facet-facet": 1, "facet-edge": 2, "edge-facet": 2, "edge-edge": 4}))
# A cube [x, x + 1] x [3/2, 5/2]^2 in the cavity [1, 3]^3: between x = 1 and x = 2 it touches no wall
HOLLOW = joined(block(0, 0, 0, 4, 4, 4), inside_out(block(1, 1, 1, 3, 3, 3)))
scene("nested in a cavity", CUBE, moved(0, 1, [F(3, 2), F(1, 4)], [F(3, 2)], [F(3, 2)]), HOLLOW, "O")
scene("from wall to wall of a cavity", CUBE, moved(0, 1, [1, 1], [F(3, 2)], [F(3, 2)]), HOLLOW, "BOB",
      (0, 0, FACE_IN_FACE), (1, 1, FACE_IN_FACE))
scene("out of a cavity", CUBE, moved(0, 1, [F(3, 2), 1], [F(3, 2)], [F(3, 2)]), HOLLOW, "OBI",
      (F(1, 2), F(1, 2), FACE_IN_FACE))
# the cavity moves over a post that stands in it: the same the other way round, with the wall x = 1 + t at x = 3/2
scene("a hollow around a cube", HOLLOW, moved(0, 1, [0, 1], [0], [0]), block(F(3, 2), F(3, 2), F(3, 2), 2, 2, 2), "OBI",
      (F(1, 2), F(1, 2), {"facet-facet": 1, "facet-edge": 4, "facet-vertex": 4}))

# ----------------------------------------------------------------------------------------- inside

scene("inside all the time", CUBE, moved(0, 1, [1, 1], [1], [1]), block(0, 0, 0, 4, 4, 4), "I")
# boundaries that touch from inside do not matter
scene("inside along a wall", CUBE, moved(0, 2, [0, 1], [0], [0]), block(0, 0, 0, 3, 3, 3), "I")
scene("around all the time", block(-1, -1, -1, 5, 5, 5), moved(0, 1, [0, 1], [0], [0]), CUBE, "I")
# S = [t, t + 1] x [0, 1] leaves [0, 1]^2 at t = 1, the instant at which it enters [2, 3] x [0, 1]; had that begun at
# 3/2, S would have been in it by then
TWO = plane(box_ring(0, 0, 1, 1), box_ring(2, 0, 3, 1))
scene("from one part into the next", SQUARE, moved(0, 2, [0, 1], [0]), TWO, "IBI",
      (1, 1, {"edge-edge": 2, "vertex-vertex": 4}))
scene("in two parts at once", SQUARE, moved(0, 2, [0, 1], [0]), plane(box_ring(0, 0, 1, 1), box_ring(F(3, 2), 0, 3, 1)), "I")
TWO_BLOCKS = joined(block(0, 0, 0, 1, 1, 1), block(2, 0, 0, 3, 1, 1))
scene("from one block into the next", CUBE, moved(0, 2, [0, 1], [0], [0]), TWO_BLOCKS, "IBI",
      (1, 1, {"facet-facet": 2, "edge-edge": 8, "vertex-vertex": 8}))
scene("in two blocks at once", CUBE, moved(0, 2, [0, 1], [0], [0]),
      joined(block(0, 0, 0, 1, 1, 1), block(F(3, 2), 0, 0, 3, 1, 1)), "I")
# two squares that touch in (0, 0), where each has a vertex; a tip comes to it between them from the upper left
PINCH = plane(box_ring(-2, -2, 0, 0), box_ring(0, 0, 2, 2))
scene("a tip touches a pinch", plane(ring((0, 0), (-1, 2), (-2, 1))), moved(-1, 1, [0, 0, -1], [0, 0, 1]), PINCH, "OBO",
      (0, 0, {"vertex-vertex": 2}, {(("vertex", 0), ("vertex", 2)), (("vertex", 0), ("vertex", 4))}))

# -------------------------------------------------------------------------------- turns and growth

# A bar [0, 30] x [-5/2, 5/2] turns by 2 atan t. A point (a, b) is on its upper side where -2 t a + (1 - t^2) b =
# (1 + t^2) 5/2; for (5/2, 33/2) that is 19 t^2 + 5 t - 14 = (19 t - 14)(t + 1) = 0, so t = 14/19. The distance from the
# side falls with t. There the cosine is 165/557 and the sine 532/557, and the point is 33/2 along the bar. Of
# the post [3/2, 5/2] x [33/2, 35/2] it is the corner that is nearest to the side as long as both are positive.
BAR = box_ring(0, F(-5, 2), 30, F(5, 2))
POST = box_ring(F(3, 2), F(33, 2), F(5, 2), F(35, 2))
TURN = build([(0, 1, rotation([0, 1]))])
TURN_UPRIGHT = build([(0, 1, rotation([0, 1], axis=[0, 0, 1], length=1))])
LATE = F(14, 19)
scene("a bar turns into a post", plane(BAR), TURN, plane(POST), "OBI",
      (LATE, LATE, {"edge-vertex": 1}, {(edge(2, 3), ("vertex", 1))}))
# in space the post's edge x1, y0 (1-5) crosses the bar's side y1 (number 3: 2, 3, 7, 6) and its edges 2-3 and 6-7
scene("a beam turns into a post", block(0, F(-5, 2), 0, 30, F(5, 2), 1), TURN_UPRIGHT,
      block(F(3, 2), F(33, 2), -1, F(5, 2), F(35, 2), 2), "OBI",
      (LATE, LATE, {"facet-edge": 1, "edge-edge": 2},
       {(("face", 3), edge(1, 5)), (edge(2, 3), edge(1, 5)), (edge(6, 7), edge(1, 5))}))
# The spike's tip is 5 from the centre, all else nearer: a wall at x = -5 is grazed after half a turn, one at -5 - 2^-60 missed
SPIKE = plane(ring((5, 0), (0, 1), (0, -1)))
FULL_TURN = build([(0, 4, turn(4))])
scene("a full turn grazes a wall", SPIKE, FULL_TURN, plane(box_ring(-7, -2, -5, 2)), "OBO",
      (2, 2, {"vertex-edge": 1}, {(("vertex", 0), edge(1, 2))}))
scene("a full turn misses a wall by 2^-60", SPIKE, FULL_TURN, plane(box_ring(-7, -2, -5 - TINY, 2)), "O")
# begun and ended at the wall
scene("a full turn from the wall", SPIKE, FULL_TURN, plane(box_ring(5, -2, 7, 2)), "BOB",
      *[(t, t, {"vertex-edge": 1}, {(("vertex", 0), edge(3, 0))}) for t in (0, 4)])
# [-1, 1]^3 times 1 + t: its side x = 1 + t is at 3 when t = 2, a square [-3, 3]^2 that has Q's [-1, 1]^2 inside
scene("a growing cube", block(-1, -1, -1, 1, 1, 1), build([(0, 3, scaling([[1, 1]] * 3))]), block(3, -1, -1, 4, 1, 1), "OBI",
      (2, 2, {"facet-facet": 1, "facet-edge": 4, "facet-vertex": 4}))
# x = 1 + t^2 is 3 when t^2 = 2
scene("a cube that grows to an irrational time", block(-1, -1, -1, 1, 1, 1), build([(0, 2, scaling([[1, 0, 1]] * 3))]),
      block(3, -1, -1, 4, 1, 1), "OBI",
      (root([-2, 0, 1], 1, 2), root([-2, 0, 1], 1, 2), {"facet-facet": 1, "facet-edge": 4, "facet-vertex": 4}))
# mirrored, [-1, 0] + t: its side x = t is S's x = 0, edge 3-0, and is at 3 when t = 3
scene("a mirrored square", SQUARE, build([(0, 4, compose(scaling([[-1], [1]]), translate([[0, 1], [0]])))]),
      plane(box_ring(3, 0, 4, 1)), "OBI",
      (3, 3, {"edge-edge": 1, "vertex-vertex": 2}, {(edge(3, 0), edge(3, 0)), (("vertex", 0), ("vertex", 0)),
                                                    (("vertex", 3), ("vertex", 3))}))
# (x + t y, y): the corner (1, 1) goes to (1 + t, 1), alone at the front; x = 3 when t = 2
scene("a sheared square", SQUARE, build([(0, 3, matrix([[[1], [0, 1], []], [[], [1], []]], [1]))]),
      plane(box_ring(3, 0, 4, 2)), "OBI", (2, 2, {"vertex-edge": 1}, {(("vertex", 2), edge(3, 0))}))
# a floor that falls as t^2 from 2
scene("a fall to an irrational time", CUBE, moved(0, F(3, 2), [0], [0], [2, 0, -1]), SLAB, "OBI",
      (root([-2, 0, 1], 1, 2), root([-2, 0, 1], 1, 2), FACE_IN_FACE))

# --------------------------------------------------------------------------- standing still, breaks

# one unit of time a leg: to the wall, wait, and back
scene("a wait at the wall", CUBE, legs([(0, 0, 0), (2, 0, 0), (2, 0, 0), (0, 0, 0)]), WALL, "OBO", (1, 2, FULL_FACE))
scene("a turn at the wall", CUBE, legs([(0, 0, 0), (2, 0, 0), (0, 0, 0)]), WALL, "OBO", (1, 1, FULL_FACE))
scene("still at the wall", CUBE, moved(0, 1, [2], [0], [0]), WALL, "B", (0, 1, FULL_FACE))
scene("still apart", CUBE, moved(0, 1, [1], [0], [0]), WALL, "O")
scene("still inside", CUBE, moved(0, 1, [F(5, 2)], [0], [0]), WALL, "I")
# into the wall, wait inside, out again: touching when x = 2, half way on the legs of length 2 between 1 and 3
scene("a wait inside the wall", SQUARE, legs([(1, 0), (3, 0), (3, 0), (1, 0)]), plane(box_ring(3, 0, 4, 1)), "OBIBO",
      (F(1, 2), F(1, 2), {"edge-edge": 1, "vertex-vertex": 2}), (F(5, 2), F(5, 2), {"edge-edge": 1, "vertex-vertex": 2}))

# ------------------------------------------------------------------------------------- both move

# [t, t + 1] and [4 - t, 5 - t] meet when t + 1 = 4 - t
scene("two cubes towards each other", CUBE, moved(0, 2, [0, 1], [0], [0]), block(4, 0, 0, 5, 1, 1), "OBI",
      (F(3, 2), F(3, 2), FULL_FACE), frame=moved(0, 2, [0, -1], [0], [0]))
# [t, t + 1] after [3 + 2 t, 4 + 2 t]
scene("one cube after a faster one", CUBE, moved(0, 9, [0, 1], [0], [0]), WALL, "O", frame=moved(0, 9, [0, 2], [0], [0]))
# seen from the second, [1, 2] x [0, 1]^2, the first stands at [0, 1]^2 x [1, 2], or 2^-60 higher
scene("two cubes that go along edge on edge", CUBE, moved(0, 9, [0, 1], [0], [1, 5]), block(1, 0, 0, 2, 1, 1), "B",
      (0, 9, {"edge-edge": 1, "vertex-vertex": 2},
       {(edge(1, 3), edge(4, 6)), (("vertex", 1), ("vertex", 4)), (("vertex", 3), ("vertex", 6))}),
      frame=moved(0, 9, [0, 1], [0], [0, 5]))
scene("two cubes that go along apart", CUBE, moved(0, 9, [0, 1], [0], [1 + TINY, 5]), block(1, 0, 0, 2, 1, 1), "O",
      frame=moved(0, 9, [0, 1], [0], [0, 5]))
scene("two cubes that go along together", CUBE, moved(0, 9, [0, 1], [0], [0, 5]), block(1, 0, 0, 2, 1, 1), "B",
      (0, 9, FULL_FACE), frame=moved(0, 9, [0, 1], [0], [0, 5]))
# the bar turns, the post stands: here the bar is the second solid
scene("a post into which a bar turns", plane(POST), moved(0, 1, [0], [0]), plane(BAR), "OBI",
      (LATE, LATE, {"vertex-edge": 1}, {(("vertex", 1), edge(2, 3))}), frame=TURN)
# breaks of the one at 1, of the other at 1/2 and 3/2: [x, x + 1] with x from 0 to 2 and back, [y, y + 1] with y from 3
# until 3/2, then to 4: x + 1 = y at t = 1 alone, while the second one, come down by 1, is level with the first
scene("breaks at different times", SQUARE, legs([(0, 0), (2, 0), (0, 0)]), plane(box_ring(3, 0, 4, 1)), "OBO",
      (1, 1, {"edge-edge": 1, "vertex-vertex": 2}),
      frame=legs([(0, 1), (0, 0), (0, 0), (1, 0)], [0, F(1, 2), F(3, 2), 2]))
# times are those that both motions have: [1, 3], and [2, 5], at whose start the wall is touched already
scene("two motions of which one begins later", CUBE, moved(0, 3, [0, 1], [0], [0]), WALL, "OBI", (2, 2, FULL_FACE),
      frame=moved(1, 9, [0], [0], [0]))
scene("two motions that begin in contact", CUBE, moved(0, 5, [0, 1], [0], [0]), WALL, "BIBO", (2, 2, FULL_FACE),
      (4, 4, FULL_FACE), frame=legs([(0, 0, 0), (0, 0, 0), (0, 0, 0)], [2, 3, 7]))

# ------------------------------------------------------------------------------- inside, --inside

# S = [x, x + 1] x [1, 2]^2 in [0, 4]^3 with x = 1 + t: its side is at x = 4 when t = 2, within the wall
ROOM, INSIDE = block(0, 0, 0, 4, 4, 4), ("--inside",)
scene("stays inside", CUBE, moved(0, 1, [1, 1], [1], [1]), ROOM, "O", flags=INSIDE)
scene("leaves a room", CUBE, moved(0, 3, [1, 1], [1], [1]), ROOM, "OBI", (2, 2, FACE_IN_FACE), flags=INSIDE)
# 1 + x = 2 + 2 t (2 - t) is 4 at t = 1 and less elsewhere
scene("touches the wall from inside", CUBE, moved(0, 2, [1, 4, -2], [1], [1]), ROOM, "OBO", (1, 1, FACE_IN_FACE), flags=INSIDE)
scene("outside all the time", CUBE, moved(0, 1, [7, 1], [1], [1]), ROOM, "I", flags=INSIDE)
# as tall as the room: its floor and its ceiling touch all the time, a square each, within theirs
scene("as tall as the room", block(0, 0, 0, 1, 1, 4), moved(0, 1, [1, 1], [1], [0]), ROOM, "B",
      (0, 1, {"facet-facet": 2, "edge-facet": 8, "vertex-facet": 8}), flags=INSIDE)
# the bridge between the parts at x from 1 to 2 is not in the solid
scene("inside two parts at once", SQUARE, moved(0, 1, [F(1, 2), 1], [0]), TWO, "I", flags=INSIDE)


# ---------------------------------------------------------------------------------------- checks

def check_contact(checks, contact, want, sides, name, scene_parts):
    low, high, counts = want[:3]
    moving, motion, fixed, frame = scene_parts
    for key, t in (("from", low), ("to", high)):
        t = t if isinstance(t, Root) else Root(value=F(t))
        checks.holds(time_is(contact[key], t), name, key, contact[key], to_double(t))
    checks.equal(contact["kind"], kind_of(*sides), name, "kind")
    checks.holds(abs(float(contact["near"]) - to_double(low)) < 1e-6, name, "near", contact["near"])
    checks.equal(Counter(x["type"] for x in contact["cells"]), Counter(counts), name, "types")
    if len(want) > 3:
        checks.equal(cell_pairs(contact), want[3], name, "cells")
    if not isinstance(low, Root):
        checks.equal(cell_pairs(contact), meeting_cells(moving, motion, fixed, F(low), frame), name, "cells by clipping")


def sides_of(word):
    """(left, right) of each B."""
    return [(word[k - 1] if k else None, word[k + 1] if k + 1 < len(word) else None)
            for k, c in enumerate(word) if c == "B"]


def check_scene(collide, checks, name, moving, motion, fixed, word, contacts, frame, flags):
    full = collide.ask(name, moving, motion, fixed, *flags, motion_of_fixed=frame)
    if full is None or not checks.equal(full.word, word, name, "word"):
        return
    for got, want, sides in zip(full.contacts, contacts, sides_of(word)):
        check_contact(checks, got, want, sides, name, (moving, motion, fixed, frame))
    first = collide.ask(name, moving, motion, fixed, "--first", *flags, motion_of_fixed=frame)
    if first is not None:
        first_agrees(checks, first, full, name)
    collide.ask(name, moving, motion, fixed, "--ask", "overlap", *flags, motion_of_fixed=frame)


def nef(collide, checks, args):
    """A cube as a Nef polyhedron, on either side: facets, edges and vertices as in `head on and through`."""
    oracle = Oracle(args, checks, "to_nef")
    motion = moved(0, 5, [0, 1], [0], [0])
    for name, solids in (("moving", [CUBE, WALL]), ("fixed", [CUBE, WALL])):
        k = ("moving", "fixed").index(name)
        text = oracle.ask(shells_text(solids[k]), one_form=False)
        if not text or not checks.equal(text.status, 0, "nef", name, "to_nef"):
            continue
        solids[k] = collide.graze.write(f"{name}.nef3", text.text)
        answer = collide.ask(f"nef {name}", solids[0], motion, solids[1])
        if answer is not None:
            checks.equal((answer.word, answer.times()), ("OBIBO", [("2", "2"), ("4", "4")]), "nef", name)
            for c in answer.contacts:
                checks.equal(Counter(x["type"] for x in c["cells"]), Counter(FULL_FACE), "nef", name)
    oracle.finish()


def text(collide, checks):
    """[6 + t^2, 7 + t^2] leaves [0, 9] at the root of t^2 = 2, by its right side. Squares that coincide have their four sides and
    corners in common."""
    write = collide.graze.write
    small, large = (write(name, f"POLYGON(({a} {c}, {b} {c}, {b} {d}, {a} {d}, {a} {c}))")
                    for name, (a, b, c, d) in (("small.wkt", (6, 7, 1, 2)), ("large.wkt", (0, 9, 0, 9))))
    way = write("way.json", '{"dimension": 2, "pieces": [{"t": [0, 2], "transform": {"translate": ["t^2", 0]}}]}')
    out = collide.graze.call("collide", small, way, large, "--inside")
    checks.equal((out.returncode, out.stdout.splitlines()[:2]), (1, ["leaves at 1.4142135623730950...", "word OBI"]), "text")
    still = write("still.json", '{"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": [0, 0]}}]}')
    out = collide.graze.call("collide", small, still, small, "--inside")
    first, word, contact = out.stdout.splitlines()
    checks.equal((out.returncode, first, word), (1, "inside, touching", "word B"), "text")
    checks.holds(contact.startswith("contact 0 to 1, tangency: edge 0-1 of MOVING with edge 0-1, "), "text", contact)
    # Four pairs of edges, four of vertices: no more than the eight that are printed.
    checks.equal(contact.count(" of MOVING with "), 8, "text", contact)
    # The cube meets its fellow by a face with four edges and four vertices: nine pairs.
    cube, fellow = (write(f"{name}.off", block(x, 0, 0, x + 1, 1, 1).text()) for name, x in (("cube", 0), ("fellow", 3)))
    ahead = write("ahead.json", '{"dimension": 3, "pieces": [{"t": [0, 5], "transform": {"translate": ["t", 0, 0]}}]}')
    out = collide.graze.call("collide", cube, ahead, fellow, "--first")
    first, word, contact = out.stdout.splitlines()
    checks.equal((out.returncode, first, word), (1, "meets", "word OBI"), "text")
    checks.holds(contact.startswith("first contact 2: ") and contact.endswith(", and 1 more"), "text", contact)
    # t + 1 = 3 + t/2 at t = 4; the motions have [2, 5] in common.
    behind = write("behind.json", '{"dimension": 3, "pieces": [{"t": [2, 9], "transform": {"translate": ["t/2", 0, 0]}}]}')
    out = collide.graze.call("collide", cube, ahead, fellow, "--motion-of-fixed", behind)
    checks.equal(out.stdout.splitlines()[:2] + [out.stdout.splitlines()[2][:10]], ["overlap", "word OBI", "contact 4,"], "text")
    rows(collide, checks, small, large)


def rows(collide, checks, small, large):
    """Times of text have decimals beside them and the row of the piece, the first one that has the time. [6, 7] + x leaves [0, 9]
    by its right side at x = 2: with x = 6 t at t = 1/3 in the piece of line 4; with x = 2 t, then 4 t - 2, at the break t = 1, which the
    piece of line 7 has first. A piece without a row has none to name."""
    for first, second, where, shown, near, row in (
            ({"row": 4}, {"row": 9}, ["6*t", "6*t"], "1/3 (0.33333333333333333, row 4)", 0.33333333333333333, 4),
            ({"row": 7}, {"row": 9}, ["2*t", "4*t-2"], "1 (row 7)", 1, 7), ({}, {"row": 9}, ["6*t", "6*t"], "1/3 (0.33333333333333333)", 1 / 3, None),
            ({}, {}, ["6*t", "6*t"], "1/3 (0.33333333333333333)", 1 / 3, 0)):
        pieces = [{"t": [k, k + 1], "transform": {"translate": [x, 0]}, **more} for k, (x, more) in enumerate(zip(where, (first, second)))]
        way = collide.graze.write("rows.json", json.dumps({"dimension": 2, "pieces": pieces}))
        out = collide.graze.call("collide", small, way, large, "--inside").stdout.splitlines()
        checks.equal((out[0], out[2].split(",  ")[0].startswith(f"contact {shown}, ")), (f"leaves at {shown}", True), out)
        found = json.loads(collide.graze.call("collide", small, way, large, "--inside", "--format", "json").stdout)
        for contact in (found["first"], *found["contacts"]):
            checks.equal((contact["near"], contact.get("row", 0)), (near, row), "row", shown)


# The square [x, x + 1] x [y, y + 1] against the room [0, 4]^2 (inside) and against [4, 5] x [1, 2]. Its right side is at x = 4 where x = 3: by
# (a) at 1/4 on its way out, by (b) at 1/4, where x is greatest, by (c) at 1, the motion's end, by (d) from 1/4 on, where a leg along the wall begins,
# by (e) at 0, on its way out, by (f) all the time; by (g), x = 5 + t, it is outside, and its left side touches the block at 0; by (h) x is 1. By (i)
# x = 1 + t^2 is 3 at the root of 2.
FIRST = [  # x, y, end; inside: text, JSON's verdict, word, next; what the contact says; against the block: verdict, word, next; contact
    ("2+4*t", "1", 1, ("leaves at 1/4 (0.25)", "meets", "OBI", "I", ""), ("meets", "OBI", "I", "")),
    ("3-4*(t-1/4)^2", "1", 1, ("touches at 1/4 (0.25) and stays inside at first", "meets", "OBO", "O", ""), ("meets", "OBO", "O", "")),
    ("2+t", "1", 1, ("touches at 1, where the motion ends", "meets", "OB", None, ", where the motion ends"), ("meets", "OB", None, ", where the motion ends")),
    (("2+4*t", "3"), ("1", "3/4+t"), (F(1, 4), 1), ("touches at 1/4 (0.25) and stays inside at first", "meets", "OB", "B", ", which lasts"),
     ("meets", "OB", "B", ", which lasts")),
    ("3+t", "1+t", 1, ("leaves at 0", "meets", "BI", "I", ""), ("meets", "BI", "I", "")),
    ("3", "1+t", 1, ("touches at 0 and stays inside at first", "meets", "B", "B", ", which lasts"), ("meets", "B", "B", ", which lasts")),
    ("5+t", "1", 1, ("overlap", "overlap", "I", None, None), ("meets", "BO", "O", "")),
    ("1", "1+t", 1, ("inside", "inside", "O", None, None), ("clear", "O", None, None)),
    ("1+t^2", "1", 2, ("leaves at 1.414", "meets", "OBI", "I", ""), ("meets", "OBI", "I", "")),
]


def first_text(collide, checks):
    """The cut-off answer in words and as JSON."""
    write = collide.graze.write
    square, room, wall = (write(name, f"POLYGON(({a} {c}, {b} {c}, {b} {d}, {a} {d}, {a} {c}))")
                          for name, (a, b, c, d) in (("unit.wkt", (0, 1, 0, 1)), ("room.wkt", (0, 4, 0, 4)), ("block.wkt", (4, 5, 1, 2))))
    for k, (x, y, end, inside, beside) in enumerate(FIRST):
        legs_of = list(zip(x, y, end)) if isinstance(x, tuple) else [(x, y, end)]
        starts = [0] + [e for *_, e in legs_of]
        pieces = [{"t": [str(s), str(e)], "transform": {"translate": [a, b]}} for s, (a, b, e) in zip(starts, legs_of)]
        way = write(f"first{k}.json", json.dumps({"dimension": 2, "pieces": pieces}))
        for fixed, flags, (told, verdict, word, following, says) in ((room, ("--inside",), inside), (wall, (), (beside[0], *beside))):
            out = collide.graze.call("collide", square, way, fixed, "--first", *flags)
            lines = out.stdout.splitlines()
            checks.equal((out.returncode, lines[1]), (int(word != "O"), "word " + word), "text", k, *flags)
            checks.holds(lines[0] == told or "." in told and lines[0].startswith(told), "text", k, *flags, lines[0], told)
            checks.equal(len(lines), 2 if says is None else 3, "text", k, *flags)
            if says is not None:
                checks.holds(lines[2].startswith("first contact ") and lines[2].partition(": ")[0].endswith(says) and
                             lines[2].count(", w", 0, lines[2].index(": ")) == bool(says), "text", k, lines[2][:80], says)
            record = json.loads(collide.graze.call("collide", square, way, fixed, "--first", "--format", "json", *flags).stdout)
            checks.equal([record[key] for key in ("verdict", "word", "next")], [verdict, word, following], "JSON", k, *flags)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    collide = Collide(args, checks)
    for one in SCENES:
        check_scene(collide, checks, *one)
    nef(collide, checks, args)
    text(collide, checks)
    first_text(collide, checks)
    print(f"{len(SCENES)} pairs")
    checks.finish()


if __name__ == "__main__":
    main()
