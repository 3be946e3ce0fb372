#!/usr/bin/env python3
# suite
"""OpenSCAD's `.csg` files: words and times of each construct derived by hand, the same answers as of `.csg.json` twins, and
what --smooth and --near-rotation take. tests/refuse/scad.txt has what is refused.

SPDX-License-Identifier: GPL-3.0-or-later

c(t), the inverted trajectory of the origin, is the path that is given. Where a text is as OpenSCAD 2021.01 writes it, it
has all of the arguments; a reason stands beside a word that is not evident.
"""
import json
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))

from scenes import (Checks, Curved, Graze, along, ball, box, capsule, common, cone, cylinder, minus, options, torus,  # noqa: E402
                    times_of, union)
from exact import Fraction as F, to_double  # noqa: E402
from harness import run  # noqa: E402

ORIGIN = {2: (0, 0), 3: (0, 0, 0)}
ROUND = "$fn = 0, $fa = 12, $fs = 2, "


def sphere(r):
    return f"sphere({ROUND}r = {r});"


def rod(h, r1, r2, center="false"):
    return f"cylinder({ROUND}h = {h}, r1 = {r1}, r2 = {r2}, center = {center});"


def cube(*size, center="false"):
    return f"cube(size = {list(size)}, center = {center});"


def square(*size, center="false"):
    return f"square(size = {list(size)}, center = {center});"


def circle(r):
    return f"circle({ROUND}r = {r});"


def moved(x, y, z, *nodes):
    return f"multmatrix([[1, 0, 0, {x}], [0, 1, 0, {y}], [0, 0, 1, {z}], [0, 0, 0, 1]]) {{\n" + "\n".join(nodes) + "\n}"


def mapped(rows, *nodes):
    return f"multmatrix({[list(row) for row in rows] + [[0, 0, 0, 1]]}) {{\n" + "\n".join(nodes) + "\n}"


def of(name, *nodes, arguments=""):
    return f"{name}({arguments}) {{\n" + "\n".join(nodes) + "\n}\n"


def prism(height, *nodes, center="false"):
    return of("linear_extrude", *nodes,
              arguments=f"height = {height}, center = {center}, convexity = 1, scale = [1, 1], $fn = 0, $fa = 12, $fs = 2")


def raised(more, *nodes):
    return of("linear_extrude", *nodes, arguments=more + ", convexity = 1, $fn = 0, $fa = 12, $fs = 2")


def turned(*nodes):
    return of("rotate_extrude", *nodes, arguments="angle = 360, convexity = 2, $fn = 0, $fa = 12, $fs = 2")


QUARTER = ((0, -1, 0, 0), (1, 0, 0, 0), (0, 0, 1, 0))
VASE = "polygon(points = [[0, 0], [8, 4], [4, 8], [4, 12], [12, 16], [0, 20]], paths = undef, convexity = 1);"
PYRAMID = ("polyhedron(points = [[10, 0, 0], [0, 10, 0], [-10, 0, 0], [0, -10, 0], [0, 0, 10]], "
           "faces = [[0, 1, 2, 3], [4, 1, 0], [4, 2, 1], [4, 3, 2], [4, 0, 3]], convexity = 1);")
SIMPLEX = "polyhedron(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]);"
PLATE = "polygon(points = [[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [2, 1], [2, 2]], paths = [[0, 1, 2, 3], [4, 5, 6]], convexity = 1);"
NOTCH = ("polyhedron(points = [[0, 0, 0], [2, 4, 0], [8, 4, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0], [0, 0, 5], [2, 4, 5], [8, 4, 5], "
         "[10, 0, 5], [10, 10, 5], [0, 10, 5]], faces = [[0, 1, 2, 3, 4, 5], [11, 10, 9, 8, 7, 6], [0, 6, 7, 1], [1, 7, 8, 2], [2, 8, 9, 3], "
         "[3, 9, 10, 4], [4, 10, 11, 5], [5, 11, 6, 0]], convexity = 2);")
CORNERS = of("hull", sphere(1), moved(6, 0, 0, sphere(1)), moved(0, 6, 0, sphere(1)), moved(0, 0, 6, sphere(1)))
ROUNDED = of("minkowski", cube(2, 2, 2), sphere(1), arguments="convexity = 0")
FRAME = of("minkowski", of("difference", square(10, 10), moved(2, 2, 0, square(6, 6))), circle(1))
TUNNEL = of("difference", cube(10, 10, 2), moved(2, 2, -1, cube(6, 6, 4)))
ANGLE = "polygon(points = [[0, 0], [6, 0], [6, 2], [2, 2], [2, 6], [0, 6]], paths = undef);"
# name, text, path over [-20, 20], word, times
SCENES = [
    ("cube", cube(2, 4, 6), ("t", "2", "3"), "OBIBO", [0, 2]),
    ("cube in the middle", cube(2, 4, 6, center="true"), ("t", "0", "0"), "OBIBO", [-1, 1]),
    ("sphere", sphere(5), ("t", "3", "0"), "OBIBO", [-4, 4]),
    ("cylinder", rod(10, 5, 5), ("0", "3", "t"), "OBIBO", [0, 10]),
    ("cylinder in the middle", rod(10, 5, 5, "true"), ("t", "3", "5"), "OBO", [(-4, 4)]),
    ("frustum", rod(4, 4, 2), ("t", "0", "2"), "OBIBO", [-3, 3]),          # of radius 4 - z / 2
    ("frustum, its top", rod(4, 4, 2), ("t", "0", "4"), "OBO", [(-2, 2)]),
    ("frustum upside down", rod(4, 2, 4, "true"), ("t", "0", "0"), "OBIBO", [-3, 3]),
    ("cone", rod(3, 0, 3), ("t", "0", "2"), "OBIBO", [-2, 2]),
    ("cone, its apex", rod(3, 3, 0), ("t", "0", "3"), "OBO", [0]),
    ("polyhedron", PYRAMID, ("t", "0", "5"), "OBIBO", [-5, 5]),             # |x| + |y| + z <= 10
    ("polyhedron, an edge", PYRAMID, ("0", "t", "0"), "OBO", [(-10, 10)]),
    ("scaled", mapped(((2, 0, 0, 1), (0, 1, 0, 0), (0, 0, 1, 0)), sphere(1)), ("t", "0", "0"), "OBIBO", [-1, 3]),
    ("two in a row", moved(-1, 0, 0, sphere(1)) + moved(1, 0, 0, sphere(1)), ("t", "0", "0"), "OBIBIBO", [-2, 0, 2]),
    ("names of a union", of("group", of("color", of("render", of("union", cube(1, 1, 1)), arguments="convexity = 1"),
                                        arguments="[1, 0, 0, 1]")), ("t", "1/2", "1/2"), "OBIBO", [0, 1]),
    ("difference", of("difference", cube(4, 4, 4, center="true"), sphere(1), moved(2, 0, 0, sphere("0.5"))), ("t", "0", "0"),
     "OBIBOBIBO", [-2, -1, 1, F(3, 2)]),
    ("intersection", of("intersection", cube(4, 4, 4), sphere(2)), ("t", "1", "0"), "OBO", [(0, [-3, 0, 1])]),
    ("prism of a disk", prism(6, circle(5), center="true"), ("0", "3", "t"), "OBIBO", [-3, 3]),
    # x^2 + y^2 <= 9 without the square [0, 2] x [-1, 1], which is turned from [-1, 1] x [-2, 0].
    ("prism of a difference", prism(2, of("difference", circle(3), mapped(QUARTER, moved(-1, -2, 0, square(2, 2))))),
     ("t", "0", "1"), "OBIBOBIBO", [-3, 0, 2, 3]),
    ("ring", turned(moved(10, 0, 0, square(5, 5))), ("t", "0", "1"), "OBIBOBIBO", [-15, -10, 10, 15]),
    ("ring of what is on the left", turned(moved(-15, 0, 0, square(5, 5))), ("0", "t", "1"), "OBIBOBIBO", [-15, -10, 10, 15]),
    ("torus", turned(moved(5, 1, 0, circle(2))), ("t", "0", "1"), "OBIBOBIBO", [-7, -3, 3, 7]),
    # (x - 2)^2 + z^2 <= 4 touches the axis; at height 1 it reaches from 2 - sqrt 3 to 2 + sqrt 3, at (2, 1) upwards from -sqrt 3 on.
    ("horn torus", turned(moved(2, 1, 0, circle(2))), ("2", "0", "t"), "OBIBO", [-1, 3]),
    # A ring from 2 to 3, along rays of (3, 4): in from 2/5 to 3/5 on the one side of the axis that is in the turn.
    *((f"turn of {what}", of("rotate_extrude", moved(x, 0, 0, square(1, 1)), arguments=f"{what}, convexity = 2"), (*path, "1/2"),
       "OBIBO", [F(2, 5), F(3, 5)])
      for what, x, path in (("angle = 90", 2, ("3*t", "4*t")), ("angle = 135", 2, ("-3*t", "4*t")), ("angle = 270", 2, ("-3*t", "4*t")),
                            ("angle = -90", 2, ("3*t", "-4*t")), ("angle = 45, start = 45", 2, ("3*t", "4*t")),
                            ("angle = 90", -3, ("-3*t", "-4*t")), ("angle = 180", 2, ("3*t", "4*t")))),
    ("torus of a turned disk", turned(mapped(QUARTER, moved(0, -5, 0, circle(2)))), ("t", "0", "2"), "OBOBO", [-5, 5]),     # its top
    ("ball of half a disk", turned(of("intersection", circle(5), moved(0, -5, 0, square(5, 10)))), ("t", "3", "0"), "OBIBO",
     [-4, 4]),
    ("vase, cone", turned(VASE), ("t", "0", "2"), "OBIBO", [-4, 4]),        # radius 8 at height 4, 0 at 0
    ("vase, edge", turned(VASE), ("t", "0", "4"), "OBIBO", [-8, 8]),
    ("vase, inwards", turned(VASE), ("t", "0", "6"), "OBIBO", [-6, 6]),
    ("vase, cylinder", turned(VASE), ("t", "0", "10"), "OBIBO", [-4, 4]),
    ("vase, axis", turned(VASE), ("0", "0", "t+5"), "OBIBO", [-5, 15]),
    # At height z the axis-crossing triangle is beside the axis from 0 to 4 - 2 |z|, on whose apexes z = +-2 the axis leaves it.
    ("outline cut at the axis", turned(of("intersection", "polygon(points = [[4, 0], [-4, 4], [-4, -4]], paths = undef);",
                                          moved(0, -9, 0, square(9, 18)))), ("t", "0", "1"), "OBIBO", [-2, 2]),
    ("disk", circle(5), ("t", "3"), "OBIBO", [-4, 4]),
    ("square", mapped(QUARTER, square(2, 6)), ("t", "1"), "OBIBO", [-6, 0]),
    # At height 3/2 the triangle reaches from 3/2 to 2.
    ("polygon with a path inside", PLATE, ("t", "3/2"), "OBIBOBIBO", [0, F(3, 2), 2, 4]),
    ("marks", of("intersection", cube(1, 1, 1), "%\t" + cube(3, 3, 3), "*roof() {" + cube(5, 5, 5) + "}", "#\t" + cube(2, 2, 2)),
     ("t", "1/2", "1/2"), "OBIBO", [0, 1]),
    ("background first", of("difference", "%" + cube(9, 9, 9), cube(2, 2, 2), cube(1, 2, 2)), ("t", "1", "1"), "OBIBO", [1, 2]),
    ("root", moved(5, 0, 0, "!" + cube(1, 1, 1), "import(file = \"a.stl\");"), ("t", "1/2", "1/2"), "OBIBO", [0, 1]),
    ("nothing taken away", of("difference", cube(1, 1, 1), "group();", of("intersection", cube(2, 2, 2), "group();")) + "group();",
     ("t", "1/2", "1/2"), "OBIBO", [0, 1]),
    ("comments", "// cube(size = [9, 9, 9]);\n/* a { brace\n * and *///\n" + cube(1, 1, 1) + " // end", ("t", "1/2", "1/2"), "OBIBO", [0, 1]),
    ("parts of size 0", of("difference", cube(2, 2, 2), cube(0, 9, 9), "polyhedron(points = [], faces = []);", rod(1, 0, 0),
                           mapped(((1, 0, 0, 0), (0, 0, 0, 0), (0, 0, 1, 0)), sphere(9)), "sphere(r = inf);"), ("t", "1", "1"), "OBIBO", [0, 2]),
    # Two rods that cross: x + y <= 13/4 is its side between their ends.
    ("hull", of("hull", cube(6, 0.5, 0.5, center="true"), cube(0.5, 6, 0.5, center="true")), ("t", "1", "0"), "OBIBO", [F(-9, 4), F(9, 4)]),
    ("hull between", of("hull", cube(1, 1, 1), moved(4, 2, 0, cube(1, 1, 1))), ("t", "3/2", "1/2"), "OBIBO", [1, 4]),
    ("hull in the plane", of("hull", square(1, 1), moved(4, 2, 0, square(1, 1))), ("t", "3/2"), "OBIBO", [1, 4]),
    ("hull that is extruded", prism(2, of("hull", square(1, 1), moved(4, 2, 0, square(1, 1)))), ("t", "3/2", "1"), "OBIBO", [1, 4]),
    # The outline's edges from (1, 0) to (5, 2) and from (0, 1) to (4, 3), turned: at height 3/2 from 1 to 4.
    ("hull that is turned", turned(of("hull", square(1, 1), moved(4, 2, 0, square(1, 1)))), ("t", "0", "3/2"), "OBIBOBIBO",
     [-4, -1, 1, 4]),
    ("sum of boxes", of("minkowski", cube(2, 2, 2), moved(1, 0, 0, cube(1, 1, 1)), arguments="convexity = 0"), ("t", "1", "1"),
     "OBIBO", [1, 4]),
    # The cube [0, 1]^3 and x, y, z >= 0, x + y + z <= 1: x + y + z <= 3 + 1 cuts the corner of [0, 2]^3.
    ("sum of a box and a simplex", of("minkowski", cube(1, 1, 1), SIMPLEX), ("t", "5/4", "5/4"), "OBIBO", [0, F(3, 2)]),
    ("sum in the plane", of("minkowski", square(1, 1), "polygon(points = [[0, 0], [1, 0], [0, 1]]);"), ("t", "3/2"), "OBIBO",
     [0, F(3, 2)]),
    # Parts of another dimension than the first one, and solids in an extrusion, are left out.
    ("a plane part of a solid", of("difference", cube(2, 2, 2), circle(9), moved(1, 0, 0, cube(2, 9, 9))), ("t", "1", "1"), "OBIBO", [0, 1]),
    ("a solid part in the plane", square(4, 4) + "sphere(r = 9);", ("t", "1"), "OBIBO", [0, 4]),
    ("intersection of two dimensions", of("intersection", cube(2, 2, 2), circle(1)) + cube(1, 1, 1), ("t", "1/2", "1/2"), "OBIBO", [0, 1]),
    ("a solid in an extrusion", prism(2, cube(9, 9, 9), square(2, 6)), ("t", "1", "1"), "OBIBO", [0, 2]),
    ("a polygon of two points", "polygon(points = [[0, 0], [1, 1]], paths = undef);" + square(2, 2), ("t", "1"), "OBIBO", [0, 2]),
    ("cylinder to infinity", rod(1, 1, "inf") + "polyhedron(points = [[0, 0, 0]], faces = []);" + cube(1, 1, 1), ("t", "1/2", "1/2"), "OBIBO", [0, 1]),
    # Between (0, 0) and (2, 4), and (8, 4) and (10, 0), a notch of the square [0, 10]^2 from below.
    ("polyhedron with a notch", NOTCH, ("t", "2", "2"), "OBIBOBIBO", [0, 1, 9, 10]),
    ("polyhedron with a notch, across", NOTCH, ("5", "t", "2"), "OBIBO", [4, 10]),
    ("polyhedron with a notch, its corner", NOTCH, ("t", "4", "2"), "OBIBIBO", [0, (2, 8), 10]),
    ("polyhedron with a notch, cut by a ball", of("difference", NOTCH, moved(5, 10, 2, sphere(1))), ("5", "t", "2"), "OBIBO", [4, 9]),
    ("disk alone in a hull", of("hull", circle(2)), ("t", "0"), "OBIBO", [-2, 2]),
    ("hull of two balls", of("hull", sphere(2), moved(6, 0, 0, sphere(2))), ("t", "0", "0"), "OBIBO", [-2, 8]),
    ("hull of two balls, across", of("hull", sphere(2), moved(6, 0, 0, sphere(2))), ("3", "t", "0"), "OBIBO", [-2, 2]),
    # Beside the segment (x - y)^2 <= 2, and a ball about its end.
    ("hull of balls on a line", of("hull", *(moved(k, k, 0, sphere(1)) for k in (3, 0, 4, 1))), ("4", "t", "0"), "OBIBO", [[14, -8, 1], 5]),
    # x + y + z <= 6 + sqrt 3 over the face of the tetrahedron, x >= -1 over that in x = 0; y = z = 1 is over both.
    ("hull of four balls", CORNERS, ("t", "1", "1"), "OBIBO", [-1, [13, -8, 1]]),
    # Beside the edge from (6, 0, 0) to (0, 0, 6) at distance^2 9/25 + (x - 3)^2 / 2.
    ("hull of four balls, an edge", CORNERS, ("t", "-3/5", "3"), "OBIBO", [F(-4, 5), [193, -150, 25]]),
    ("hull of disks", of("hull", circle(1), moved(4, 0, 0, circle(1)), moved(0, 3, 0, circle(1))), ("t", "1"), "OBIBO", [-1, F(13, 3)]),
    # The cube [0, 2]^3, over a face, over an edge, and over a corner, where x^2 = 1 - 4/9 - 1/9.
    ("rounded cube", ROUNDED, ("t", "1", "1"), "OBIBO", [-1, 3]),
    ("rounded cube, an edge", ROUNDED, ("t", "-3/5", "1"), "OBIBO", [F(-4, 5), F(14, 5)]),
    ("rounded cube, a corner", ROUNDED, ("t", "-2/3", "-1/3"), "OBIBO", [F(-2, 3), F(8, 3)]),
    # The square [0, 10]^2 without [2, 8]^2: outside it is rounded, inside [3, 7]^2 stays.
    ("sum of a frame and a disk", FRAME, ("t", "5"), "OBIBOBIBO", [-1, 3, 7, 11]),
    ("sum of a frame and a disk, a corner", FRAME, ("t", "-3/5"), "OBIBO", [F(-4, 5), F(54, 5)]),
    ("sum of a frame and a disk, inside", FRAME, ("t", "3"), "OBIBIBO", [-1, (3, 7), 11]),
    ("sum of disks", of("minkowski", circle(1), moved(2, 0, 0, circle(2))), ("t", "0"), "OBIBO", [-1, 5]),
    ("offset", of("offset", square(4, 4), arguments="r = 1, $fn = 0"), ("t", "-3/5"), "OBIBO", [F(-4, 5), F(24, 5)]),
    ("offset of two that meet", of("offset", square(4, 4), moved(4, 0, 0, square(4, 4)), arguments="r = -1"), ("t", "2"), "OBIBO", [1, 7]),
    ("offset of a disk", of("offset", circle(4), arguments="r = -1"), ("t", "0"), "OBIBO", [-3, 3]),
    # Within [0, 6]^2 without (2, 6]^2; (x - 2)^2 + (17/10 - 2)^2 >= 1/4 about the corner inwards.
    ("offset inwards", of("offset", ANGLE, arguments="r = -0.5"), ("t", "1"), "OBIBO", [F(1, 2), F(11, 2)]),
    ("offset inwards, a corner", of("offset", ANGLE, arguments="r = -0.5"), ("t", "17/10"), "OBIBO", [F(1, 2), F(8, 5)]),
    ("offset that is extruded", prism(2, of("offset", "polygon(points = [[0, 0], [4, 0], [0, 3]]);", arguments="r = 1")), ("t", "1", "1"),
     "OBIBO", [-1, F(13, 3)]),
    # x + y <= 2 + sqrt 2 over the edge, at y = 3/2: (x - 1/2)^2 = 2.
    ("offset that is extruded, of an irrational edge", prism(2, of("offset", "polygon(points = [[0, 0], [2, 0], [0, 2]]);", arguments="r = 1")),
     ("t", "3/2", "1"), "OBIBO", [-1, [-7, -4, 4]]),
    ("offset that is extruded, inwards", prism(2, of("offset", square(4, 4), arguments="r = -1")), ("2", "2", "t"), "OBIBO", [0, 2]),
    ("hull of disks that is extruded", prism(2, of("hull", circle(1), moved(4, 0, 0, circle(1)))), ("2", "t", "1"), "OBIBO", [-1, 1]),
    # A top that is scaled by s over height h: at height z all is scaled by 1 + (s - 1) z / h about the origin.
    ("pyramid", raised("height = 4, scale = [0, 0]", square(4, 4, center="true")), ("t", "0", "2"), "OBIBO", [-1, 1]),
    ("pyramid, its apex", raised("height = 4, scale = 0", square(4, 4, center="true")), ("t", "0", "4"), "OBO", [0]),
    ("scaled beside the axis", raised("height = 2, scale = 2", moved(2, 0, 0, square(2, 2))), ("t", "1", "1"), "OBIBO", [3, 6]),
    ("scaled, in the middle", raised("height = 2, center = true, scale = [2, 2]", moved(2, 0, 0, square(2, 2))), ("t", "1", "0"), "OBIBO",
     [3, 6]),
    ("scaled and turned", raised("height = 2, scale = 2", mapped(QUARTER, moved(2, 0, 0, square(2, 2)))), ("t", "4", "1"), "OBIBO", [-3, 0]),
    ("scaled polygon with a hole", raised("height = 2, scale = 0.5", PLATE), ("t", "9/8", "1"), "OBIBOBIBO", [0, F(9, 8), F(3, 2), 3]),
    ("scaled difference", raised("height = 2, scale = 0.5", of("difference", square(4, 4), moved(1, 1, 0, square(2, 2)))), ("t", "3/2", "1"),
     "OBIBOBIBO", [0, F(3, 4), F(9, 4), 3]),
    ("two scales", raised("height = 2, scale = [2, 0]", moved(1, 1, 0, square(2, 2))), ("t", "1", "1"), "OBIBO", [F(3, 2), F(9, 2)]),
    ("two scales, upwards", raised("height = 2, scale = [2, 0]", moved(1, 1, 0, square(2, 2))), ("2", "1", "t"), "OBIBO", [0, F(4, 3)]),
    # About (3, 0) with radius 3/2 at height 1; at y = 9/10 within 6/5.
    ("scaled disk", raised("height = 2, scale = 0.5", moved(4, 0, 0, circle(2))), ("t", "9/10", "1"), "OBIBO", [F(9, 5), F(21, 5)]),
    ("along v", raised("height = 5, v = [0.6, 0, 0.8]", square(2, 2)), ("t", "1", "2"), "OBIBO", [F(3, 2), F(7, 2)]),
    ("along v, a disk", raised("height = 5, v = [0.6, 0, 0.8]", circle(2)), ("t", "0", "2"), "OBIBO", [F(-1, 2), F(7, 2)]),
    # From z = -2 to 2; at 1 scaled by 1 + 2 * 3/4, moved by 3/4.
    ("along v and scaled", raised("height = 5, v = [0.6, 0, 0.8], center = true, scale = 3", square(2, 2, center="true")), ("t", "0", "1"),
     "OBIBO", [F(-7, 4), F(13, 4)]),
    ("delta", of("offset", square(4, 4), arguments="delta = 1, chamfer = false"), ("t", "-9/10"), "OBIBO", [-1, 5]),
    # The long edge, 3 x + 4 y <= 12, becomes 3 x + 4 y <= 17.
    ("delta of a triangle", of("offset", "polygon(points = [[0, 0], [0, 3], [4, 0]]);", arguments="delta = 1"), ("t", "-1/2"), "OBIBO",
     [-1, F(19, 3)]),
    ("delta inwards, a notch", of("offset", ANGLE, arguments="delta = -0.5"), ("t", "17/10"), "OBIBO", [F(1, 2), F(3, 2)]),
    ("delta outwards, a notch", of("offset", ANGLE, arguments="delta = 0.5"), ("t", "12/5"), "OBIBO", [F(-1, 2), F(13, 2)]),
    ("delta of a frame", of("offset", of("difference", square(10, 10), moved(2, 2, 0, square(6, 6))), arguments="delta = 1"), ("t", "16/5"),
     "OBIBOBIBO", [-1, 3, 7, 11]),
    ("delta of a frame, inwards", of("offset", of("difference", square(10, 10), moved(2, 2, 0, square(6, 6))), arguments="delta = -0.5"),
     ("t", "5"), "OBIBOBIBO", [F(1, 2), F(3, 2), F(17, 2), F(19, 2)]),
    ("delta of a disk", of("offset", circle(4), arguments="delta = -1"), ("t", "0"), "OBIBO", [-3, 3]),
    ("delta that is scaled", raised("height = 2, scale = 0.5", of("offset", square(4, 4, center="true"), arguments="delta = 1")),
     ("t", "2", "1"), "OBIBO", [F(-9, 4), F(9, 4)]),
    # A square, a cube of side 1 from the origin: a notch or a hole loses 1 at its low ends, the whole gains 1 at its high ends.
    ("sum of a notch and a square", of("minkowski", ANGLE, square(1, 1)), ("t", "4"), "OBIBO", [0, 3]),
    ("sum of a square and a notch", of("minkowski", square(1, 1), ANGLE), ("t", "5/2"), "OBIBO", [0, 7]),
    ("sum of a frame and a square", of("minkowski", of("difference", square(10, 10), moved(2, 2, 0, square(6, 6))), square(1, 1)), ("t", "5"),
     "OBIBOBIBO", [0, 3, 8, 11]),
    ("sum of a notch and a square, extruded", prism(2, of("minkowski", ANGLE, square(1, 1))), ("t", "4", "1"), "OBIBO", [0, 3]),
    ("sum of a notched part alone", of("minkowski", NOTCH), ("t", "2", "2"), "OBIBOBIBO", [0, 1, 9, 10]),
    # At y = 2 from places of the notch at y = 1 to 2, where it is widest at 1 + 1 and 9.
    ("sum of a notched body and a cube", of("minkowski", NOTCH, cube(1, 1, 1)), ("t", "2", "2"), "OBIBOBIBO", [0, 2, 9, 11]),
    ("sum of a notched body and a cube, upwards", of("minkowski", NOTCH, cube(1, 1, 1)), ("1/2", "5/2", "t"), "OBIBO", [0, 6]),
    ("sum of a tunnel and a simplex", of("minkowski", SIMPLEX, TUNNEL), ("t", "5", "1"), "OBIBOBIBO", [0, 3, 8, 11]),
    # From 1/2 above the tunnel's top the simplex reaches 1/2 to the side.
    ("sum of a tunnel and a simplex, above", of("minkowski", TUNNEL, SIMPLEX), ("t", "5", "5/2"), "OBIBOBIBO", [0, F(5, 2), 8, F(21, 2)]),
    ("exponents", "sphere(r = 1e-2);", ("t", "0", "0"), "OBIBO", [F(-1, 100), F(1, 100)]),
]
# OpenSCAD's text of a solid and its nodes of .csg.json: equal at points of a lattice, which meets the surfaces, and at random fractions.
TWINS = [
    (of("difference", cube(4, 4, 4, center="true"), moved(1, 0, 0, sphere(2)), rod(6, 1, 1, "true")),
     minus(box((-2, -2, -2), (2, 2, 2)), ball((1, 0, 0), 2), cylinder((0, 0, -3), (0, 0, 1), 1, 0, 6))),
    (of("union", rod(2, 3, 1), moved(0, 0, 2, rod(1, 1, 0))),
     union(minus(cone((0, 0, 3), (0, 0, -1), 1, 3), {"halfspace": {"normal": ["0", "0", "-1"], "offset": "-2"}}),
           cone((0, 0, 3), (0, 0, -1), 1, 1))),
    (turned(moved(3, 0, 0, circle(1))), torus((0, 0, 0), (0, 0, 1), 3, 1)),
    (turned(moved(1, 0, 0, square(2, 2))), minus(cylinder((0, 0, 0), (0, 0, 1), 3, 0, 2), cylinder((0, 0, 0), (0, 0, 1), 1, 0, 2))),
    (turned("polygon(points = [[1, 0], [3, 0], [1, 2]], paths = undef);"),
     minus(cone((0, 0, 3), (0, 0, -1), 1, 3), cylinder((0, 0, -1), (0, 0, 1), 1, 0, 9))),
    (PYRAMID.replace("10", "3"), common(*({"halfspace": {"normal": [str(a), str(b), "1"], "offset": "3"}}
                                          for a in (-1, 1) for b in (-1, 1)), {"halfspace": {"normal": ["0", "0", "-1"], "offset": "0"}})),
    (prism(3, of("difference", circle(3), "polygon(points = [[0, 0], [2, 0], [0, 2]], paths = undef);")),
     minus(cylinder((0, 0, 0), (0, 0, 3), 3, 0, 1), {"polygon": {"points": [["0", "0"], ["2", "0"], ["0", "2"]], "extrude": ["-1", "4"]}})),
]

TWINS += [
    (NOTCH, minus(box((0, 0, 0), (10, 10, 5)),
                  {"polygon": {"points": [["0", "0"], ["10", "0"], ["8", "4"], ["2", "4"]], "extrude": ["-1", "6"]}})),
    (ROUNDED, union(box((-1, 0, 0), (3, 2, 2)), box((0, -1, 0), (2, 3, 2)), box((0, 0, -1), (2, 2, 3)),
                    *(capsule([2 * (k // 2) if i == (axis + 1) % 3 else 2 * (k % 2) if i == (axis + 2) % 3 else 0 for i in range(3)],
                              [2 * (i == axis) for i in range(3)], 1) for axis in range(3) for k in range(4)))),
    (prism(2, of("offset", square(4, 4, center="true"), arguments="r = 1")),
     union(box((-3, -2, 0), (3, 2, 2)), box((-2, -3, 0), (2, 3, 2)),
           *(cylinder((x, y, 0), (0, 0, 1), 1, 0, 2) for x in (-2, 2) for y in (-2, 2)))),
]


class Scad:
    """A text in a dimension, as a file."""
    suffix = ".csg"

    def __init__(self, dimension, text):
        self.dimension, self.given = dimension, text

    def text(self):
        return self.given


def check_scenes(graze, checks):
    for name, text, path, word, times in SCENES:
        d = len(path)
        answers = graze.classify(name, Scad(d, text), along(-20, 20, *path), [ORIGIN[d]])
        if answers:
            checks.equal(answers[0].word, word, name)
            checks.equal(times_of(answers[0].contacts), times, name)


def check_twins(graze, checks, args):
    pick = args.random
    points = [(x, y, z) for x in range(-4, 5, 2) for y in (-1, 0, 1, 2) for z in (0, 1, 2)] if args.derived else []
    points += [tuple(F(pick.randint(-40, 40), pick.randint(1, 11)) for _ in range(3)) for _ in args.rounds(100)]
    for k, (text, node) in enumerate(TWINS):
        motion = along(-3, 3, "t", "t^2/4", "t/2")
        both = [graze.classify(f"twin {k}", solid, motion, points) for solid in (Scad(3, text), Curved(3, node))]
        if not (both[0] and both[1]):
            continue
        checks.holds(len({a.word for a in both[1]}) > 3 or not args.derived, f"twin {k}", "too few words to tell solids apart")
        for point, got, want in zip(points, *both):
            checks.equal((got.counts(), got.times()), (want.counts(), want.times()), f"twin {k}", point)


class Bench:
    def __init__(self, args, checks, folder):
        self.args, self.checks, self.folder = args, checks, folder

    def convert(self, text, *options):
        path = os.path.join(self.folder, "s.csg")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return run([self.args.graze, "convert", path, *options])


def check_smooth(bench):
    """With --smooth the file is that of the same text without numbers of sides."""
    text = of("union", "sphere($fn = 30, r = 2);", "cylinder($fn = 6, h = 1, r1 = 1, r2 = 2);", turned(moved(5, 0, 0, "circle($fn = 9, r = 1);")))
    round_one = bench.convert(re.sub(r"\$fn = \d+", "$fn = 0", text))
    smooth = bench.convert(text, "--smooth")
    bench.checks.equal((smooth.returncode, smooth.stdout), (0, round_one.stdout), "smooth", smooth.stderr)
    bench.checks.holds("taken as round: 4, with sides: 0, as empty: 0" in smooth.stderr, "smooth, counts", smooth.stderr)
    # A nut trap stays: corners of a square, a cone's rings, and of a ball of 5 sides 3 rings.
    for sides, text, says, facets in (
            (7, "cylinder($fn = 4, h = 2, r1 = 2, r2 = 2);", "taken as round: 0, with sides: 1", "8 vertices and 6 facets"),
            (7, "cylinder($fn = 4, h = 2, r1 = 2, r2 = 0);", "taken as round: 0, with sides: 1", "5 vertices and 5 facets"),
            (9, "sphere($fn = 5, r = 2);", "taken as round: 0, with sides: 1", "15 vertices and 12 facets"),
            (4, "cylinder($fn = 4, h = 2, r1 = 2, r2 = 2);", "taken as round: 1, with sides: 0", None),
            (7, prism(1, "circle($fn = 6, r = 2);") + cube(0, 1, 1), "taken as round: 0, with sides: 1, as empty: 1", "12 vertices and 8 facets")):
        made = bench.convert(text, f"--smooth={sides}", "-o", os.path.join(bench.folder, "m.csg.json"))
        mesh = run([bench.args.graze, "convert", os.path.join(bench.folder, "m.csg.json")])
        bench.checks.holds(made.returncode == 0 and says in made.stderr, "sides", text, made.stderr)
        bench.checks.holds(facets in mesh.stderr if facets else mesh.returncode == 3, "sides", text, mesh.stderr)
    square_rod = bench.convert("cylinder($fn = 4, h = 2, r1 = 2, r2 = 2);", "--smooth=5")
    points = [[F(x) for x in p] for p in json.loads(square_rod.stdout)["solid"]["polyhedron"]["points"]]
    bench.checks.equal(sorted(map(tuple, points)), sorted((x, y, z) for x, y in ((2, 0), (-2, 0), (0, 2), (0, -2)) for z in (0, 2)), "corners")


def matrices(node, out):
    """The linear parts of the maps of a node, outermost first."""
    if isinstance(node, dict):
        if "affine" in node:
            out.append([[F(x) for x in row[:-1]] for row in node["affine"]["matrix"]])
        for value in node.values():
            matrices(value, out)
    elif isinstance(node, list):
        for value in node:
            matrices(value, out)
    return out


def gram(m):
    """The product of the transpose and the matrix."""
    n = len(m)
    return [[sum(m[k][i] * m[k][j] for k in range(n)) for j in range(n)] for i in range(n)]


# rows, tolerance, the scale of the rotation that must be found, or None
NEAR = [
    (((0.866025, -0.5, 0, 3), (0.5, 0.866025, 0, 0), (0, 0, 1, 0)), "1e-6", 1),
    (((0.353553, -0.612372, 0.707107, 0), (0.866025, 0.5, 0, 0), (-0.353553, 0.612372, 0.707107, 0)), "1e-6", 1),
    (((-0.866025, 0.5, 0, 0), (0.5, 0.866025, 0, 0), (0, 0, 1, 0)), "1e-6", 1),              # a reflection
    (((1.73205, -1, 0, 0), (1, 1.73205, 0, 0), (0, 0, 2, 0)), "1e-5", 2),
    (((0.8, -0.6, 0, 0), (0.6, 0.8, 0, 0), (0, 0, 1, 0)), "1e-6", None),                      # exact: it stays
    (((2, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)), "1e-6", None),                               # a stretch: it stays
    (((0.866025, -0.5, 0, 0), (0.5, 0.866025, 0, 0), (0, 0, 1, 0)), "1e-8", None),            # not so near
]


def check_near(bench):
    """The map that is written, over the scale, is exactly orthogonal and as near in each entry as the tolerance; no corner of the
    cube moves by more than is told, and that is no more than all errors of a column together for its distance from the origin."""
    checks = bench.checks
    for rows, tolerance, scale in NEAR:
        done = bench.convert(mapped(rows, cube(6, 6, 6, center="true")), "--near-rotation", tolerance)
        if not checks.equal(done.returncode, 0, rows, done.stderr):
            continue
        given = [[F(str(x)) for x in row[:3]] for row in rows]
        got = matrices(json.loads(done.stdout), [])[0]
        told = re.search(r"maps taken as rotations: (\d+); no point moves by more than (\S+)", done.stderr)
        checks.equal(told and told[1], "0" if scale is None else "1", rows, done.stderr)
        if scale is None:
            checks.equal(got, given, rows)
            continue
        checks.equal(gram(got), [[F(scale) ** 2 * (i == j) for j in range(3)] for i in range(3)], rows)
        change = [[a - b for a, b in zip(*pair)] for pair in zip(got, given)]
        most = max(abs(x) for row in change for x in row)
        checks.holds(0 < most <= F(tolerance) * scale, rows, "within the tolerance", to_double(most))
        shifts = [sum((3 * sum(s * x for s, x in zip(signs, row))) ** 2 for row in change)
                  for signs in ((a, b, c) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1))]
        bound = F(told[2])
        checks.holds(max(shifts) <= bound ** 2 <= (9 * 3 * most * F(11, 10)) ** 2, rows, "displacement", to_double(max(shifts)) ** 0.5, told[2])


def check_near_angle(bench):
    """A turn by 30 degrees is one between the x axis and (cos, sin) = (sqrt 3 / 2, 1/2), within 2^-60."""
    text = of("rotate_extrude", moved(2, 0, 0, square(1, 1)), arguments="angle = 30, convexity = 2")
    done = bench.convert(text, "--near-rotation", "1e-6")
    if not bench.checks.equal(done.returncode, 0, "angle", done.stderr):
        return
    sides = [[F(x) for x in part["halfspace"]["normal"]] for part in json.loads(done.stdout)["solid"]["intersection"][0]["intersection"]]
    bench.checks.equal(sides[0], [0, -1, 0], "from the x axis")
    small = F(1, 2 ** 59)
    bench.checks.holds(abs(sides[1][0] + F(1, 2)) < small and abs(sides[1][1] ** 2 - F(3, 4)) < 2 * small and sides[1][1] > 0, "to 30", sides[1])
    told = re.search(r"maps taken as rotations: 1; no point moves by more than (\S+)", done.stderr)
    bench.checks.holds(told and 0 < F(told[1]) <= 5 * small, "displacement", done.stderr)
    bench.checks.equal(bench.convert(text).returncode, 3, "without the option")


def check_near_delta(bench):
    """The long edge of a triangle, x + y <= 2, becomes x + y <= 2 + sqrt 2, and meets y = -1 at x = 3 + sqrt 2."""
    text = of("offset", "polygon(points = [[0, 0], [2, 0], [0, 2]]);", arguments="delta = 1")
    done = bench.convert(text, "--near-rotation", "1e-6")
    if not bench.checks.equal(done.returncode, 0, "delta", done.stderr):
        return
    parts = [[[F(x) for x in p] for p in part["polygon"]["points"]] for part in json.loads(done.stdout)["solid"]["union"]]
    corner = {x for part in parts for x, y in part if y == -1 and x > 3}
    told = re.search(r"maps taken as rotations: 1; no point moves by more than (\S+)", done.stderr)
    bench.checks.holds(told and 0 < F(told[1]) < F(1, 2 ** 50), "displacement", done.stderr)
    bench.checks.holds(len(corner) == 1 and all(abs((x - 3) ** 2 - 2) < 3 * F(told[1]) for x in corner), "where edges meet", corner)
    bench.checks.equal(bench.convert(text).returncode, 3, "without the option")


def check_near_chain(bench):
    """An outer map enlarges the displacement of an inner one; revolved and flat nodes have their maps turned too."""
    third = NEAR[0][0]
    text = mapped(((10, 0, 0, 0), (0, 10, 0, 0), (0, 0, 10, 0)), mapped(third, sphere(1)))
    told = [F(re.search(r"more than (\S+)", bench.convert(t, "--near-rotation", "1e-6").stderr)[1])
            for t in (mapped(third, sphere(1)), text)]
    bench.checks.holds(0 < told[0] and F(9) < told[1] / told[0] < 11, "ten times", told)
    flat = mapped(third, moved(0, 0, 0, circle(1)))
    for text in (flat, prism(1, flat), turned(moved(5, 0, 0, flat))):
        done = bench.convert(text, "--near-rotation", "1e-6")
        bench.checks.holds(done.returncode == 0 and "as rotations: 1;" in done.stderr, text, done.stderr)
    # Without a rotation the disk is an ellipse, which may not be revolved; with one it is a torus.
    bench.checks.holds('"torus"' in done.stdout and bench.convert(text).returncode == 3, "torus", done.stdout)


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    if args.derived:
        check_scenes(graze, checks)
        with tempfile.TemporaryDirectory() as folder:
            bench = Bench(args, checks, folder)
            check_smooth(bench)
            check_near(bench)
            check_near_chain(bench)
            check_near_angle(bench)
            check_near_delta(bench)
    check_twins(graze, checks, args)
    checks.finish()


if __name__ == "__main__":
    main()
