#!/usr/bin/env python3
# suite
"""Pictures of dense meshes.

A drum with many sides has two rims that are sharp and no other edge; its slice is one closed line; a torus of 80,000
triangles fits in 2 MB. Triangles of one plane are one face. Faces that are drawn as pixels have the colours of those drawn as paths. The scale bar has
the length that its number says, measured against the solid. Hundreds of names on a long motion are placed in seconds, none over another.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import itertools
import math
import os
import re
import resource
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from harness import Checks, options  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"
checks = Checks()
check = checks.holds
MOVE = '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["%s*t", "0", "0"]}}]}'


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def off(path, vertices, triangles):
    rows = [" ".join(f"{x:.9f}" for x in v) for v in vertices] + [f"3 {a} {b} {c}" for a, b, c in triangles]
    return write(path, f"OFF\n{len(vertices)} {len(triangles)} 0\n" + "\n".join(rows) + "\n")


def drum(sides):
    """A prism over a regular polygon about the z axis, of radius 2 and height 2."""
    ring = [(2 * math.cos(2 * math.pi * k / sides), 2 * math.sin(2 * math.pi * k / sides)) for k in range(sides)]
    vertices = [(x, y, z) for z in (0, 2) for x, y in ring] + [(0, 0, 0), (0, 0, 2)]
    faces = []
    for k in range(sides):
        n = (k + 1) % sides
        faces += [(k, n, sides + n), (k, sides + n, sides + k), (n, k, 2 * sides), (sides + k, sides + n, 2 * sides + 1)]
    return vertices, faces


def torus(around, across):
    vertices, faces = [], []
    for i in range(around):
        for j in range(across):
            a, b = 2 * math.pi * i / around, 2 * math.pi * j / across
            vertices.append(((3 + math.cos(b)) * math.cos(a), (3 + math.cos(b)) * math.sin(a), math.sin(b)))
            m, n = (i + 1) % around, (j + 1) % across
            faces += [(i * across + j, m * across + j, m * across + n), (i * across + j, m * across + n, i * across + n)]
    return vertices, faces


def draw(graze, solid, motion, out, *more):
    done = harness.run([graze, "draw", solid, motion, "-o", out, "--grid", 40, *more], 300)
    check(done.returncode == 0, more, done.stderr)
    return ElementTree.parse(out).getroot()


def group(root, name):
    return next(g for g in root.iter(SVG + "g") if g.get("class") == name)


def paths(part):
    return list(part.iter(SVG + "path"))


def corners(path):
    """The nodes of a path's data as points, M, L, H and V."""
    x = y = 0
    for verb, numbers in re.findall(r"([MLHVz])([^MLHVz]*)", path.get("d")):
        values = [float(n) for n in numbers.split()]
        if verb in "ML":
            x, y = values
        elif verb == "H":
            x = values[0]
        elif verb == "V":
            y = values[0]
        if verb != "z":
            yield verb, x, y


def test_outline(graze, folder):
    """The slice of the drum at its middle height: rings, each with one beginning, one a position, also dashed."""
    for sides in (12, 3000):
        solid = off(os.path.join(folder, "drum.off"), *drum(sides))
        motion = write(os.path.join(folder, "move.json"), MOVE % "6")
        root = draw(graze, solid, motion, os.path.join(folder, "drum.svg"), "--times", "3", "--plane", "z=1")
        lines = [p for p in paths(group(root, "classes")) if p.get("fill") == "none" and p.get("d").count("z") == 1][:3]
        check(len(lines) == 3, sides, "rings", len(lines))
        check(sum("stroke-dasharray" in p.attrib for p in lines) == 1, sides, "the end is dashed")
        for p in lines:
            nodes = list(corners(p))
            check(sum(verb == "M" for verb, _, _ in nodes) == 1, sides, "one line, begun once")
            if sides == 12:
                check(len(nodes) >= 24, "nodes", len(nodes))  # each side is two triangles
            steps = [math.dist(a[1:], b[1:]) for a, b in zip(nodes, nodes[1:])]
            check(sides == 12 or min(steps[:-1]) > .35, sides, "nodes are near one another", min(steps))
            wide = max(x for _, x, _ in nodes) - min(x for _, x, _ in nodes)
            high = max(y for _, _, y in nodes) - min(y for _, _, y in nodes)
            check(abs(wide - high) < .03 * wide, sides, "the ring is round", wide, high)


def test_edges(graze, folder):
    """From the side, a dense drum's sharp edges are its rims: pixels of the colour of edges at two heights alone."""
    solid = off(os.path.join(folder, "drum.off"), *drum(3000))
    motion = write(os.path.join(folder, "move.json"), MOVE % "1/1000")
    root = draw(graze, solid, motion, os.path.join(folder, "drum.svg"), "--times", "2", "--view", "0,-1,0", "-p", "9,9,9")
    rows = collections.Counter()
    for p in paths(group(root, "trajectories")):
        stroke = p.get("stroke", "")
        level = int(stroke[1:3], 16) if stroke.startswith("#") else 255
        if p.get("shape-rendering") == "crispEdges" and level < 105:
            nodes = list(corners(p))
            for (_, x0, y0), (_, x1, _) in zip(nodes[::2], nodes[1::2]):
                rows[y0] += x1 - x0
    check(rows, "no edge is drawn")
    tall = [y for y, length in rows.items() if length > 100]
    check(2 <= len(tall) <= 4 and max(tall) - min(tall) > 50, "rims", sorted(rows.items()))
    other = sum(length for y, length in rows.items() if min(abs(y - t) for t in tall) > 2)
    check(other < 60, "edges off the rims", other)


def test_faces(graze, folder):
    """The lid of a coarse drum is one face, though twelve triangles: no line meets its middle, and no triangle of
    another position comes between those of one."""
    solid = off(os.path.join(folder, "drum.off"), *drum(12))
    motion = write(os.path.join(folder, "move.json"), MOVE % "1")
    root = draw(graze, solid, motion, os.path.join(folder, "lid.svg"), "--times", "3", "-p", "9,9,9")
    ends = collections.Counter()
    for p in paths(group(root, "trajectories")):
        if p.get("fill", "none") == "none" and p.get("class") is None:
            ends.update((x, y) for _, x, y in corners(p))
    check(len(ends) >= 12 + 7 and max(ends.values()) <= 6, "lines that meet in one point", ends.most_common(3))
    fills = [p.get("fill") for p in paths(group(root, "positions")) if p.get("shape-rendering") == "crispEdges"]
    lids = {fill for fill, count in collections.Counter(fills).items() if count >= 12}
    order = [fill for fill, _ in itertools.groupby(fill for fill in fills if fill in lids)]
    check(len(lids) == len(order) == 3, "the lids are painted one after the other", order)


def test_size(graze, folder):
    solid = off(os.path.join(folder, "torus.off"), *torus(400, 100))
    motion = write(os.path.join(folder, "move.json"), MOVE % "5")
    out = os.path.join(folder, "torus.svg")
    root = draw(graze, solid, motion, out, "-p", "3,0,0", "-p", "0,0,0")
    check(os.path.getsize(out) < 2_000_000, "bytes", os.path.getsize(out))
    check(len(paths(group(root, "positions"))) < 1000, "paths", len(paths(group(root, "positions"))))


def brightest(part):
    """The most frequent colours of the faces in a part, by their area or the length of their runs."""
    out = collections.Counter()
    for p in paths(part):
        nodes = [(x, y) for _, x, y in corners(p)]
        if p.get("shape-rendering") != "crispEdges":
            continue
        if p.get("fill", "none") != "none":
            area = abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(nodes, nodes[1:] + nodes[:1]))) / 2
            out[p.get("fill")] += area * float(p.get("opacity", 1))
        else:
            out[p.get("stroke")] += sum(b[0] - a[0] for a, b in zip(nodes[::2], nodes[1::2]))
    return out


def test_pixels(graze, folder):
    """The lid of a drum from above: one colour and one area, as paths of the coarse one, as pixels of the dense one."""
    found = []
    for sides in (400, 3000):
        solid = off(os.path.join(folder, "drum.off"), *drum(sides))
        motion = write(os.path.join(folder, "move.json"), MOVE % "1/1000")
        root = draw(graze, solid, motion, os.path.join(folder, "drum.svg"), "--times", "2", "--view", "0,0,1", "-p", "9,9,9")
        (colour, area), = brightest(group(root, "trajectories")).most_common(1)
        found.append((int(colour[1:], 16), area))
    # Paths are mixed with white where they are drawn, by a quarter; pixels are mixed here.
    grey = [found[0][0] & 255, found[1][0] & 255]
    check(abs(.75 * grey[0] + .25 * 255 - grey[1]) < 4, "colours of the lid", [hex(c) for c, _ in found])
    check(abs(found[0][1] / .75 - found[1][1]) < .03 * found[1][1], "areas of the lid", found)


def test_bar(graze, folder):
    """From above: positions 10 wide."""
    cube = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "refuse", "common", "cube.off")
    motion = write(os.path.join(folder, "move.json"), MOVE % "8")
    root = draw(graze, cube, motion, os.path.join(folder, "bar.svg"), "--view", "0,0,1", "-p", "5,1,1")
    for name, width in (("positions", 10), ("trajectories", 2)):
        part = group(root, name)
        bar = next(p for p in paths(part) if p.get("class") == "scale")
        faces = [x for p in paths(part) if p.get("shape-rendering") == "crispEdges" for _, x, _ in corners(p)]
        unit = (max(faces) - min(faces)) / width
        nodes = list(corners(bar))
        length = abs(nodes[1][1] - nodes[0][1])
        number = next(t.text for t in part.iter(SVG + "text") if abs(float(t.get("x")) - (nodes[0][1] + nodes[1][1]) / 2) < .02
                      and abs(float(t.get("y")) - nodes[0][2]) < 10)
        check(abs(length / unit - float(number)) < .02 * float(number), name, "bar", length, unit, number)


def box_of_name(element):
    """Left, top, right and bottom of a name as it is placed: 13 pixels high, letters no narrower than 0.4 of their size."""
    x, y = float(element.get("x")), float(element.get("y"))
    return x, y - 10.5, x + .4 * 12 * len(element.text), y + 2.5


def test_names(graze, folder, random):
    """300 named points about a cube on a motion of 60 pieces: the time grows with the points alone."""
    cube = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "refuse", "common", "cube.off")
    frames = ", ".join(f'{{"t": "{k}", "position": ["{k}/20", "{k * k % 7}/5", "{k * k % 5}/5"], "quaternion": ["60", "{k}", "0", "{k % 3}"]}}'
                       for k in range(61))
    motion = write(os.path.join(folder, "log.json"), f'{{"dimension": 3, "keyframes": [{frames}]}}')
    points = write(os.path.join(folder, "many.csv"), "id,x,y,z\n" + "".join(
        f"name{k},{random.uniform(0, 4):.3f},{random.uniform(0, 2):.3f},{random.uniform(0, 2):.3f}\n" for k in range(300)))
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    root = draw(graze, cube, motion, os.path.join(folder, "many.svg"), points)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    check(after.ru_utime - before.ru_utime < 10, "seconds", after.ru_utime - before.ru_utime)
    for part in ("positions", "trajectories"):
        texts = [t for t in group(root, part).iter(SVG + "text") if t.text.startswith("name")]
        told = [re.match(r"no room for (\d+) name", t.text) for t in group(root, part).iter(SVG + "text")]
        check(len(texts) >= 20, part, "names", len(texts))
        check(sum(int(m[1]) for m in told if m) + len(texts) <= 300, part, "names placed and left out", len(texts))
        boxes = [box_of_name(t) for t in texts]
        common = [max(min(a[2], b[2]) - max(a[0], b[0]), 0) * max(min(a[3], b[3]) - max(a[1], b[1]), 0)
                  for a, b in itertools.combinations(boxes, 2)]
        check(max(common, default=0) <= 12, part, "names on one another", max(common, default=0))


def main():
    args = options(__doc__)
    graze = args.graze
    with tempfile.TemporaryDirectory() as folder:
        test_outline(graze, folder)
        test_edges(graze, folder)
        test_faces(graze, folder)
        test_size(graze, folder)
        test_pixels(graze, folder)
        test_bar(graze, folder)
        test_names(graze, folder, args.random)
    checks.finish()


if __name__ == "__main__":
    main()
