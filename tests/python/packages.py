#!/usr/bin/env python3
"""Solids and points of shapely, meshio and pandas themselves, as Debian has them: what test_meshes.py and
test_frames.py show with stand-ins. One of the long tests, which install these packages.

The square [0, 6]^2 with the hole [1, 5]^2 moves by 2 along x, the box [0, 2]^3 by 8; words and classes by hand.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import ROOT, Checks, options, run  # noqa: E402

CORNERS = [(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
QUADS = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def trials(folder):
    """Run by an interpreter that has the packages."""
    import graze
    import meshio
    import numpy
    import pandas
    import shapely.geometry as shapes
    import shapely.wkt
    checks = Checks()
    square = lambda low, high: [(low, low), (high, low), (high, high), (low, high)]
    step = {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": ["2*t", 0]}}]}
    along = {"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["8*t", 0, 0]}}]}
    word = lambda solid, point: graze.Scene(solid, step).trace(point).word

    ring = shapes.Polygon(square(0, 6), [square(1, 5)])
    checks.equal((word(ring, (6, 3)), word(ring, (4, 3))), ("BIBO", "O"), "a polygon with a hole")
    checks.equal(word(shapely.wkt.loads(ring.wkt), (6, 3)), "BIBO", "a polygon from WKT")
    two = shapes.MultiPolygon([shapes.Polygon(square(0, 1)), shapes.Polygon(square(4, 5))])
    checks.equal((word(two, (3, "1/2")), word(two, (6, "9/2"))), ("OB", "OBIB"), "two polygons")
    checks.equal(graze.Solid(shapes.box(0, 0, 2, 1).difference(shapes.box(0, 0, 1, 1))).component_count, 1, "a difference")
    for wrong in (shapes.LineString([(0, 0), (1, 1)]), shapes.Polygon([(0, 0, 1), (1, 0, 1), (1, 1, 1)])):
        try:
            graze.Solid(wrong)
            checks.fail("taken", wrong)
        except graze.InputError:
            checks.holds(True)

    box = meshio.Mesh(numpy.array(CORNERS, float), [("quad", numpy.array(QUADS))])
    checks.equal(graze.Scene(box, along).trace((5, 1, 2)).word, "OBO", "a mesh of meshio")
    path = os.path.join(folder, "box.ply")
    triangles = [t for a, b, c, d in QUADS for t in ((a, b, c), (a, c, d))]
    meshio.Mesh(numpy.array(CORNERS, float), [("triangle", numpy.array(triangles))]).write(path)
    checks.equal(graze.Scene(meshio.read(path), along).trace((5, 1, 1)).word, "OBIBO", "a file of meshio")
    checks.equal(graze.Scene(path, along).trace((5, 1, 1)).word, "OBIBO", "meshio's file, read by Graze")
    try:
        graze.Solid(meshio.Mesh(numpy.array(CORNERS, float), [("hexahedron", numpy.array([range(8)]))]))
        checks.fail("a hexahedron was taken")
    except graze.InputError:
        checks.holds(True)

    points = pandas.DataFrame({"name": ["a", "b", "c"], "z": [1.0, 2.0, 1.0], "y": [1, 1, 3], "x": [5, 5, 5]})
    scene = graze.Scene(box, along)
    verdicts = scene.classify(points)
    checks.equal(graze.class_names(verdicts), ["regular", "boundary", "exterior"], "a DataFrame in")
    frame = graze.to_dataframe(verdicts, points)
    checks.holds(isinstance(frame, pandas.DataFrame), type(frame))
    checks.equal(list(frame["pmc"]), ["in", "on", "out"], "a DataFrame out")
    checks.equal(list(frame["x"]), [5, 5, 5], "its points")
    masked = pandas.DataFrame({"x": [5.0, None], "y": [1.0, 1.0], "z": [1.0, 1.0]})
    try:
        scene.classify(masked)
        checks.fail("a missing value was taken")
    except graze.GrazeError:
        checks.holds(True)
    checks.finish()


def main():
    if sys.argv[1:2] == ["--here"]:
        trials(sys.argv[2])
        return
    import tempfile
    args = options(__doc__)
    library = os.path.join(os.path.dirname(os.path.abspath(args.graze)), "libgraze.so")
    environment = dict(os.environ, GRAZE_LIBRARY=library, PYTHONPATH=os.path.join(ROOT, "src", "python"),
                       PYTHONDONTWRITEBYTECODE="1")
    python = next((p for p in (sys.executable, "/usr/bin/python3") if os.path.exists(p)
                   and run([p, "-c", "import meshio, pandas, shapely"]).returncode == 0), None)
    if not python:
        sys.exit("no interpreter here has meshio, pandas and shapely; expected python3-meshio, python3-pandas, "
                 "python3-shapely")
    with tempfile.TemporaryDirectory() as folder:
        done = run([python, os.path.abspath(__file__), "--here", folder], 300, env=environment)
    print(done.stdout, end="")
    print(done.stderr, end="", file=sys.stderr)
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
