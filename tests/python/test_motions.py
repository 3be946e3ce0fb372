"""Motions made in Python, pictures and comparisons: positions by hand, files beside those of the program.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import base64
import csv
import html.parser
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from fractions import Fraction as F

import common
import graze
from common import numpy

IDENTITY = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
QUARTER = [[0, -1, 0, 4], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]


def program(*words):
    """Standard output of the program."""
    done = subprocess.run([common.GRAZE, *words], capture_output=True, text=True, timeout=300)
    assert done.returncode in (0, 1), done.stderr
    return done.stdout


def plain(text):
    """A motion file as plain pieces."""
    return graze.Motion(text).json()


class Frame:
    """The least that Graze needs of a frame."""

    def __init__(self, columns):
        self._columns = {name: list(column) for name, column in dict(columns).items()}
        self.columns = list(self._columns)

    def __getitem__(self, name):
        return self._columns[name]


def moved_by(motion, point):
    """Where the point is relative to the cube at the end of the motion: I, B or O."""
    scene = graze.Scene(common.CUBE, motion)
    return scene.trace(point).word[-1]


class Motions(unittest.TestCase):
    def test_rotate(self):
        """A quarter turn about z brings the cube [0, 2]^3 to [-2, 0] x [0, 2] x [0, 2]."""
        motion = graze.Motion.rotate(90, (0, 0, 1))
        self.assertEqual(moved_by(motion, (-1, 1, 1)), "I")
        self.assertEqual(moved_by(motion, (1, 1, 1)), "O")
        self.assertEqual(moved_by(motion, (-2, 2, 2)), "B")
        self.assertIn("every position is one of the exact turn", motion.report)
        same = plain(program("motion", "rotate", "--degrees", "37.5", "--axis", "1,2,2", "--center", "1,0,0"))
        self.assertEqual(graze.Motion.rotate("37.5", (1, 2, 2), (1, 0, 0)).json(), same)
        self.assertEqual(graze.Motion.rotate(F(75, 2), [1, 2, 2], [1, 0, 0]).json(), same)
        flat = graze.Motion.rotate(37.5, center=(1, 1))
        self.assertEqual(flat.json(), plain(program("motion", "rotate", "--dimension", "2", "--degrees", "37.5", "--center", "1,1")))
        with self.assertRaises(graze.UseError):
            graze.Motion.rotate(90, (0, 0, 0))
        with self.assertRaises(graze.UseError):
            graze.Motion.rotate(90, (0, 0, 1), (1, 1))

    def test_line(self):
        """The cube [0, 2]^3 ends at [8, 10] x [0, 2] x [-1/3, 5/3]."""
        line = graze.Motion.line(8, 0, F(-1, 3))
        self.assertEqual(moved_by(line, (9, 1, F(-1, 3))), "B")
        self.assertEqual(moved_by(line, (9, 1, 1)), "I")
        self.assertEqual(moved_by(line, (9, 1, 2)), "O")
        self.assertEqual(line.json(), plain(program("motion", "line", "--by", "8,0,-1/3")))
        self.assertEqual(graze.Motion.line(8, 0).dimension, 2)

    def test_joints(self):
        """A screw of pitch 8 by half a turn moves 4 along z."""
        screw = graze.Motion.screw(180, (0, 0, 1), 8)
        self.assertEqual(moved_by(screw, (-1, -1, 5)), "I")
        self.assertEqual(moved_by(screw, (-1, -1, 3)), "O")
        self.assertEqual(screw.json(), plain(program("motion", "screw", "--degrees", "180", "--axis", "0,0,1", "--pitch", "8")))
        chain = graze.Motion.joints([graze.turn(90, (0, 0, 1)), graze.turn(-45, (0, 0, 1), (2, 0, 0)), graze.slide(0, 0, 1)])
        want = program("motion", "joints", "turn:90:0,0,1", "turn:-45:0,0,1:2,0,0", "slide:0,0,1")
        self.assertEqual(chain.json(), plain(want))
        self.assertEqual(graze.Motion.joints([graze.slide(8, 0)]).dimension, 2)
        with self.assertRaises(graze.UseError):
            graze.Motion.joints([])
        with self.assertRaises(graze.UseError):
            graze.Motion.joints([graze.turn(90, pitch=1)])

    def test_gcode(self):
        """A program's motion is that of the program; a start; an arc that is refused by its line."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.nc")
            pathlib.Path(path).write_text("G0 X0 Y0 Z0\nG1 X3 F9\nG2 X3 Y8.001 J4\n")
            made = graze.Motion.gcode(path)
            self.assertEqual(made.json(), plain(program("motion", "gcode", path)))
            self.assertIn("line 3: the arc is off its circle by at most 1.0", made.report)
            self.assertEqual(graze.Motion.gcode(pathlib.Path(path), start=(1, F(1, 3), "0.5")).piece_count, made.piece_count + 1)
            with self.assertRaisesRegex(graze.InputError, "a.nc:3: the arc is off"):
                graze.Motion.gcode(path, tolerance="1e-4")
            with self.assertRaisesRegex(graze.UseError, "start has 2 numbers; expected 3"):
                graze.Motion.gcode(path, start=(1, 2))

    def test_poses_of_the_program(self):
        """Poses in memory give the bytes that `graze motion poses` and `graze convert` write of their log."""
        columns = {"t": [0, 0.1, F(1, 3)], "x": [0.1, 2, -7.25], "y": [1, 1e-3, 0], "z": [0, 0, 9], "qw": [1, 0.96, 1],
                   "qx": [0, 0, 0], "qy": [0, 0.28, 0], "qz": [0, 0, -1], "row": [2, 3, 4]}
        with tempfile.TemporaryDirectory() as folder:
            path, to = os.path.join(folder, "log.csv"), os.path.join(folder, "move.json")
            rows = [[str(F(x)) for x in row] for row in zip(*list(columns.values())[:-1])]
            pathlib.Path(path).write_text("\n".join(",".join(row) for row in [list(columns)[:-1], *rows]) + "\n")
            program("motion", "poses", path, "--numbers", "written", "-o", to)
            self.assertEqual(graze.Motion.poses(Frame(columns)).json(), program("convert", to))

    def test_poses(self):
        """The cube turns by a quarter and moves 4: it ends at [2, 4] x [0, 2] x [0, 2]."""
        given = [[IDENTITY, QUARTER], [m[:3] for m in (IDENTITY, QUARTER)],
                 [[0, 0, 0, 1, 0, 0, 0], [4, 0, 0, 1, 0, 0, 1]]]
        if numpy is not None:
            given += [numpy.array(poses, dtype=float) for poses in given]
        for poses in given:
            order = "wxyz" if len(poses[0]) == 7 else None
            motion = graze.Motion.poses(poses, [0, F(1, 3)], quaternions=order)
            self.assertEqual(moved_by(motion, (3, 1, 1)), "I")
            self.assertEqual(moved_by(motion, (5, 1, 1)), "O")
            self.assertIn('"1/3"', motion.json())
        far = graze.Motion.poses([[0.1, 0, 0, 1, 0, 0, 0], [0.1, 0, 0, -1, 0, 0, -1]], shortest=True, quaternions="wxyz")
        self.assertIn("signs of quaternions changed at poses 2; 1 in all", far.report)
        self.assertIn("each one exactly as given at its time", far.report)
        self.assertIn(f"({F(0.1).numerator} + ", far.json())
        # In the plane: a quarter turn about (4, 0) takes the corner (2, 1) of a bar to (3, 2).
        flat = graze.Motion.poses(Frame({"x": [4, 4], "y": [0, 0], "theta": [0, math.pi / 2]}), dimension=2)
        same = graze.Motion.poses([[4, 0, 5, 1, 0, 0, 0], [4, 0, 5, 1, 0, 0, 1]], quaternions="wxyz", dimension=2)
        self.assertIn("plane: z is left out", same.report)
        for motion in (flat, same):
            bar = graze.Scene(graze.Solid(([(0, 0), (2, 0), (2, 1), (0, 1)], [[0, 1, 2, 3]])), motion)
            self.assertEqual([bar.trace(p).word[-1] for p in ((3, 2), (F(7, 2), F(3, 2)), (9, 9))], ["B", "I", "O"])
        with self.assertRaisesRegex(graze.InputError, r"poses\[1\]: the pose turns out of the plane"):
            graze.Motion.poses([[0, 0, 0, 1, 0, 0, 0], [4, 0, 0, 1, 1, 0, 0]], quaternions="wxyz", dimension=2)
        with self.assertRaises(graze.UseError):
            graze.Motion.poses([[0, 0, 0, 1, 0, 0, 0]] * 2, quaternions="wxyz", dimension=4)
        half = 0.5 ** 0.5
        ways = [[0.1, 0, 0, 1, 0, 0, 0], [0.1, 0, 0, -half, 0, 0, -half]]
        far = graze.Motion.poses(ways, shortest=True, quaternions="wxyz")
        self.assertEqual(graze.Motion.poses(ways, quaternions="wxyz").json(), far.json())
        kept = graze.Motion.poses(ways, long=True, quaternions="wxyz")
        self.assertNotEqual(kept.json(), far.json())
        self.assertIn("at poses 2; 1 in all; they are kept", kept.report)
        # 0.92 degrees off SLERP at a quarter turn, 0.0161 radians; near it the way has more pieces.
        self.assertRegex(far.report, r"slerp: not taken.* at most 1.6\de-02 radians, most of all up to pose 2")
        near = graze.Motion.poses(ways, slerp=True, tolerance="1e-3", quaternions="wxyz")
        self.assertEqual((far.piece_count, near.piece_count), (1, 4))
        for both in ({"shortest": True, "long": True}, {"slerp": True, "long": True}, {"slerp": True, "affine": True}):
            with self.assertRaisesRegex(graze.UseError, "expected one of them"):
                graze.Motion.poses(ways, quaternions="wxyz", **both)
        rows = Frame({"row": [7, 9], "x": [0, 4], "y": [0, 0], "z": [0, 0]})
        self.assertIn('"row": 9', graze.Motion.poses(rows).json())
        for bad in ([[1, 2, 3]], [IDENTITY, IDENTITY[:3]], [[0, 0, 0, 1, 0, 0, 0], IDENTITY]):
            with self.assertRaises(graze.UseError):
                graze.Motion.poses(bad)
        with self.assertRaises(graze.UseError):
            graze.Motion.poses([IDENTITY, QUARTER], [0])
        with self.assertRaisesRegex(graze.InputError, "nan"):
            graze.Motion.poses([[float("nan"), 0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0, 0]], quaternions="wxyz")
        sheared = [[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]], [[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]]
        self.assertEqual(graze.Motion.poses(sheared, affine=True).piece_count, 1)
        with self.assertRaisesRegex(graze.InputError, "no rotation"):
            graze.Motion.poses(sheared)

    def test_orders(self):
        """The order of a quaternion is told or refused; names of columns tell it."""
        turned = [[0, 0, 0, 1, 0, 0, 0], [4, 0, 0, 1, 0, 0, 1]]
        ros = [[0, 0, 0, 0, 0, 0, 1], [4, 0, 0, 0, 0, 1, 1]]
        wanted = graze.Motion.poses(turned, quaternions="wxyz").json()
        self.assertEqual(graze.Motion.poses(ros, quaternions="xyzw").json(), wanted)
        self.assertNotEqual(graze.Motion.poses(ros, quaternions="wxyz").json(), wanted)
        for given in (turned, ros):
            for order in (None, "xyz"):
                with self.assertRaisesRegex(graze.UseError, "expected 'wxyz' for poses x, y, z, qw.*'xyzw'.*ROS"):
                    graze.Motion.poses(given, quaternions=order)
        names = ("x", "y", "z", "qx", "qy", "qz", "qw")
        frame = Frame(zip(names, zip(*ros)))
        self.assertEqual(graze.Motion.poses(frame).json(), wanted)
        if numpy is not None:
            records = numpy.array([tuple(row) for row in ros], dtype=[(name, float) for name in names])
            self.assertEqual(graze.Motion.poses(records).json(), wanted)
        with self.assertRaisesRegex(graze.UseError, "the names of columns tell their order"):
            graze.Motion.poses(frame, quaternions="xyzw")

    def test_logs(self):
        """Frames and files with other names, other columns and angles, as `graze motion poses` takes them."""
        wanted = graze.Motion.poses([[0, 0, 0, 1, 0, 0, 0], [4, 0, 0, 1, 0, 0, 1]], [2, 5], quaternions="wxyz").json()
        columns = {"stamp": [2, 5], "place": [0, 4], "y": [0, 0], "z": [0, 0], "qw": [1, 1], "qx": [0, 0], "qy": [0, 0],
                   "qz": [0.0, 1.0], "load": [0.5, 0.25]}
        chosen = {"columns": {"t": "stamp", "x": "place"}, "ignore": ["load"]}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "log.csv")
            with open(path, "w", encoding="utf-8") as file:
                csv.writer(file).writerows([columns, *zip(*columns.values())])
            # Poses of a frame have numbers from 1, those of a file its lines.
            for source, row in ((Frame(columns), 2), (path, 3), (pathlib.Path(path), 3)):
                there = wanted.replace('"row": 2', f'"row": {row}')
                self.assertEqual(there.count(f'"row": {row}'), 1)
                self.assertEqual(graze.Motion.poses(source, **chosen).json(), there)
                self.assertEqual(graze.Motion.poses(source, columns="t=stamp,x=place", ignore=["load"]).json(), there)
            for wrong in ({"times": [0, 1]}, {"quaternions": "wxyz"}):
                with self.assertRaisesRegex(graze.UseError, "a file's columns have names"):
                    graze.Motion.poses(path, **chosen, **wrong)
            with self.assertRaises(graze.InputError):
                graze.Motion.poses(Frame(columns), columns={"t": "stamp", "x": "place"})
            angles = Frame({"x": [0, 4], "y": [0, 0], "z": [0, 0], "a": [0, 90], "b": [0, 0], "c": [0, 0]})
            turned = graze.Motion.poses(angles, angles="kuka")
            self.assertEqual((moved_by(turned, (3, 1, 1)), moved_by(turned, (5, 1, 1))), ("I", "O"))

    def test_numbers_of_logs(self):
        """A log is read as the program reads it, as doubles or as written: 0.1 is more than a tenth as a double."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "log.csv")
            with open(path, "w", encoding="utf-8") as file:
                file.write("t,x,y,z\n0,0.1,0,0\n1,0.3,0,0\n")
            for numbers, start in ((None, F(0.1)), ("binary64", F(0.1)), ("written", F(1, 10))):
                made = graze.Motion.poses(path, numbers=numbers)
                by_program = graze.Motion(program("motion", "poses", path, *(["--numbers", numbers] if numbers else [])))
                self.assertEqual(made.json(), by_program.json(), numbers)
                self.assertIn(f"{start.numerator}/{start.denominator}", made.json(), numbers)
            with self.assertRaisesRegex(graze.UseError, "expected 'binary64' or 'written'"):
                graze.Motion.poses(path, numbers="float")
            with self.assertRaisesRegex(graze.UseError, "numbers is of a log in a file"):
                graze.Motion.poses([IDENTITY, QUARTER], numbers="written")

    def test_index(self):
        """An index with a name is a column; without one times count from 0."""
        class Indexed(Frame):
            def __init__(self, columns, name):
                super().__init__(columns)
                self.index = type("Index", (), {"name": name})()

            def reset_index(self):
                return Frame({"t": [10, 15], **{name: self[name] for name in "xyz"}})

        columns = {"x": [0, 2], "y": [0, 0], "z": [0, 0]}
        for name, ends in (("t", (10, 15)), (None, (0, 1))):
            piece, = json.loads(graze.Motion.poses(Indexed(columns, name)).json())["pieces"]
            self.assertEqual(tuple(map(int, piece["t"])), ends)

    def test_dyadic(self):
        motion = graze.Motion(common.moved("0.443221*t", "8*t", "0"))
        near = motion.dyadic()
        way = F(json.loads(near.json())["pieces"][0]["transform"]["matrix"][0][3].split("*")[0])
        self.assertEqual(way.denominator & (way.denominator - 1), 0)
        self.assertLess(abs(way - F("0.443221")), F(1, 10**6))
        self.assertIn("change: ", near.report)

    def test_names(self):
        """The text of each object in an interpreter."""
        scene = common.cube_scene()
        self.assertEqual(repr(scene.solid), "<graze.Solid in E^3: 8 vertices, 6 facets, 1 component>")
        self.assertEqual(repr(scene.motion), "<graze.Motion in E^3: 1 piece>")
        self.assertEqual(repr(scene), f"<graze.Scene, sweep of {scene.solid!r} by {scene.motion!r}>")
        self.assertIn("4 edges", repr(graze.Solid(common.SQUARE)))


class Tools(unittest.TestCase):
    def test_meshes(self):
        """The meshes of `graze solid`: the same as solids of its files, by vertices and by answers."""
        with tempfile.TemporaryDirectory() as folder:
            inside, outside = (os.path.join(folder, name) for name in ("inside.off", "outside.off"))
            for made, words in ((lambda **more: graze.tools.cutter(6, 20, corner="3/2", taper=5, tolerance="0.05", **more),
                                 "cutter --diameter 6 --length 20 --corner 3/2 --taper 5 --tolerance 0.05"),
                                (lambda **more: graze.tools.ball("2", tolerance="0.1", **more), "ball --diameter 2 --tolerance 0.1"),
                                (lambda **more: graze.tools.cylinder(2, 1, tolerance="0.1", **more),
                                 "cylinder --diameter 2 --length 1 --tolerance 0.1")):
                program("solid", *words.split(), "--inside", inside, "--outside", outside)
                for path, mesh in ((inside, made()), (outside, made(outside=True))):
                    with open(path, encoding="utf-8") as file:
                        lines = [line.split() for line in file if line.strip() and line[0] not in "#O"]
                    count = int(lines[0][0])
                    self.assertEqual(mesh[0], [tuple(map(F, line)) for line in lines[1:count + 1]])
                    self.assertEqual(mesh[1], [[int(k) for k in line[1:]] for line in lines[count + 1:]])
                    self.assertEqual(graze.Solid(mesh).vertex_count, count)
        corners, _ = graze.tools.box(1, "1/2", 0.25, at=(1, 0, -1))
        self.assertEqual((min(corners), max(corners)), ((1, 0, -1), (2, F(1, 2), F(-3, 4))))
        for wrong in (lambda: graze.tools.cutter(6, 20, corner=4, tolerance=1), lambda: graze.tools.box(0, 1, 1),
                      lambda: graze.tools.box(1, 1, 1, at=(0, 0)), lambda: graze.tools.ball(1, tolerance=0)):
            with self.assertRaises(graze.UseError):
                wrong()


class Pictures(unittest.TestCase):
    def test_draw(self):
        """A picture has the bytes of `graze draw`, and is SVG that a notebook shows."""
        solid, motion, points, _ = common.case("figure4")
        scene = graze.Scene(solid, motion)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "picture.svg")
            program("draw", solid, motion, "--grid", "20", "--title", "A title", "-o", path)
            picture = scene.draw(grid=20, title="A title")
            with open(path, encoding="utf-8") as file:
                self.assertEqual(picture.svg, file.read())
            picture.save(path)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(picture._repr_svg_(), file.read())
        marked = scene.draw([(0, 0), ("1/2", 1)], names=["first", "second"], grid=10, box=((-1, -1), (3, 3)))
        root = xml.etree.ElementTree.fromstring(marked.svg)
        self.assertTrue(root.tag.endswith("svg"))
        self.assertIn("second", marked.svg)
        painted = {path.get("class"): path.get("fill") for path in
                   xml.etree.ElementTree.fromstring(picture.svg).iter("{http://www.w3.org/2000/svg}path")}
        colours = graze.class_colours()
        self.assertEqual(sorted(colours), sorted(set(graze.CLASS_NAMES) - {"none"}))
        seen = [name for name in colours if name in painted]
        self.assertGreater(len(seen), 1)
        self.assertEqual([colours[name] for name in seen], [painted[name] for name in seen])
        with self.assertRaises(graze.UseError):
            scene.draw([(0, 0)], names=["one", "two"])

    def test_plane(self):
        """A plane across an axis and one that is not, as `graze draw --plane` takes them."""
        scene = common.cube_scene()
        across = scene.draw(grid=8, title="T", plane=((0, 0, 2), "1")).svg
        self.assertIn("in the plane z = 1/2", across)
        self.assertEqual(across, scene.draw(grid=8, title="T", plane=([0, 0, -1], -0.5)).svg)
        self.assertIn("in the plane x + 1/3*y = 2", scene.draw(grid=8, plane=((1, "1/3", 0), 2)).svg)
        for text in ("z=1/2", "z = 0.5", "0,0,2,1", "0, 0, 4, 2"):
            self.assertEqual(across, scene.draw(grid=8, title="T", plane=text).svg, text)
        for wrong in (((0, 0, 0), 1), ((1, 1), 1), ((1, 1, 1), 999), "w=1", "1,2,3", "z=", (1, 1, 0, 60)):
            with self.assertRaises((graze.UseError, graze.InputError)):
                scene.draw(plane=wrong)

    def test_png_pdf(self):
        """The same bytes as `graze draw` makes; a picture of directions too."""
        scene = common.cube_scene()
        flat = graze.Scene(common.SQUARE, common.moved("8*t", "0"))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.PNG")
            solid, motion = os.path.join(common.ROOT, "tests/refuse/common/cube.off"), os.path.join(folder, "move.json")
            with open(motion, "w", encoding="utf-8") as file:
                file.write(scene.motion.json())
            for name, kept in ((path, "b.png"), (os.path.join(folder, "a.Pdf"), "b.pdf")):
                kept = os.path.join(folder, kept)
                program("draw", solid, motion, "--grid", "8", "--title", "T", "--plane", "z=1/2", "-o", kept)
                scene.draw(grid=8, title="T", plane="z=1/2").save(name)
                with open(name, "rb") as made, open(kept, "rb") as wanted:
                    self.assertEqual(made.read(), wanted.read())
            flat.cones((4, 1)).save(path)
            with open(path, "rb") as made:
                self.assertEqual(made.read(8), b"\x89PNG\r\n\x1a\n")

    def test_without_cairo(self):
        """Where the library has no libgraze-png beside it, a PNG and a PDF are refused with what to install."""
        tell = """import common, graze, sys
for ending in ("png", "pdf", "svg"):
    try:
        common.cube_scene().draw(grid=4).save(sys.argv[1] + "/made." + ending)
    except graze.MachineError as error:
        print(error)
"""
        with tempfile.TemporaryDirectory() as folder:
            library = shutil.copy(os.environ["GRAZE_LIBRARY"], folder)
            there = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}  # of tests/python/threads.sh
            done = subprocess.run([sys.executable, "-c", tell, folder], env={**there, "GRAZE_LIBRARY": library, "PYTHONPATH": os.pathsep.join(sys.path)},
                                  cwd=os.path.dirname(os.path.abspath(__file__)), stdout=subprocess.PIPE, text=True, check=True)
            self.assertEqual(len(re.findall("PNG and PDF pictures need libgraze-png-.*libcairo2-dev", done.stdout)), 2, done.stdout)
            self.assertEqual(sorted(os.listdir(folder)), sorted(["made.svg", os.path.basename(library)]))

    def test_page(self):
        """A page has the bytes of `graze draw -o scene.html`, in a frame for a notebook."""
        solid, motion, points, _ = common.case("figure4")
        scene = graze.Scene(solid, motion)
        with open(points, encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.html")
            table = os.path.join(folder, "points.csv")
            with open(table, "w", encoding="utf-8") as file:
                file.write("x,y,id,stratum\n" + "".join(f"{r['x']},{r['y']},n{k},s{k % 2}\n" for k, r in enumerate(rows)))
            program("draw", solid, motion, table, "--title", "A <title>", "--surface", "4", "-o", path)
            page = scene.page([(r["x"], r["y"]) for r in rows], names=[f"n{k}" for k in range(len(rows))],
                              strata=[f"s{k % 2}" for k in range(len(rows))], title="A <title>", surface=4)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(page.html, file.read())
            page.save(path)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(page.html, file.read())
        frames = []
        parser = html.parser.HTMLParser()
        parser.handle_starttag = lambda tag, attributes: frames.append((tag, dict(attributes).get("srcdoc")))
        parser.feed(page._repr_html_())
        self.assertEqual(frames, [("iframe", page.html)])
        self.assertEqual(repr(page), f"<graze.Page, {len(page.html)} characters of HTML>")
        self.assertIn('"surface":null', scene.page(surface=None).html)
        with self.assertRaises(graze.UseError):
            scene.page([(0, 0)], names=["one"], strata=["a", "b"])
        with self.assertRaises(graze.UseError):
            scene.page(surface=99)


    def test_proof(self):
        """A page with a certificate has the bytes of `graze draw --certificate`, with a checker those of --checker; files of another scene are refused."""
        rows = [("1", "1/2"), ("9", "9"), ("2", "1")]
        with tempfile.TemporaryDirectory() as folder:
            solid, motion, bare, proof, checker, path = (os.path.join(folder, name) for name in ("s.wkt", "m.json", "p.csv", "c.txt", "k.html", "page.html"))
            for name, text in ((solid, b"POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\r\n"), (motion, json.dumps(common.moved("t", "0")).encode()),
                               (bare, b"x,y,id,stratum\n1,1/2,a,s\n9,9,b,s\n2,1,c,s\n"), (checker, b"<title>graze-check</title>\xff\x00<")):
                with open(name, "wb") as file:
                    file.write(text)
            scene = graze.Scene(pathlib.Path(solid), motion)
            program("certify", solid, motion, bare, "-o", proof)
            with open(proof, "rb") as file:
                held = base64.b64encode(file.read()).decode()
            for more in ({}, {"checker": pathlib.Path(checker)}):
                words = [word for name, file in more.items() for word in ("--" + name, str(file))]
                program("draw", solid, motion, bare, "--title", "T", "--surface", "none", "--certificate", proof, *words, "-o", path)
                page = scene.page(rows, names="abc", strata="sss", title="T", surface=None, certificate=proof, **more)
                with open(path, encoding="utf-8") as file:
                    self.assertEqual(page.html, file.read())
                self.assertEqual((page.html.count(held), '"checker":' in page.html), (1, bool(more)))
            self.assertNotIn(held, scene.page(rows, surface=None).html)
            with open(motion, encoding="utf-8") as file:
                of_text = graze.Scene(solid, file.read())
            for wrong, given in ((scene, {"checker": checker}), (of_text, {"certificate": proof}), (graze.Scene(solid, None), {"certificate": proof})):
                with self.assertRaises(graze.UseError):
                    wrong.page(rows, surface=None, **given)
            for given in ({"certificate": bare}, {"certificate": proof, "checker": bare}):
                with self.assertRaises(graze.InputError):
                    scene.page(rows, surface=None, **given)
            with self.assertRaises(graze.MachineError):
                scene.page(rows, surface=None, certificate=os.path.join(folder, "none"))
            with self.assertRaises(graze.InputError):
                graze.Scene(common.case("figure4")[0], motion).page(rows, surface=None, certificate=proof)


class Comparisons(unittest.TestCase):
    def test_compare(self):
        """One of three rows is wrong."""
        scene = common.cube_scene()
        with tempfile.TemporaryDirectory() as folder:
            golden, mine = (os.path.join(folder, name) for name in ("golden.csv", "mine.csv"))
            with open(golden, "w", encoding="utf-8") as file:
                file.write(scene.table([(5, 1, 1), (5, 1, 2), (5, 3, 1)]))
            with open(mine, "w", encoding="utf-8") as file:
                file.write("x,y,z,pmc\n5,1,1,in\n5,1,2,out\n5,3,1,out\n")
            points = {"x": [5, 5, 5], "y": [1.0, 1.0, 3.0], "z": [1, 2, 1]}
            frames = [Frame({**points, "pmc": answers}) for answers in (["in", "on", "out"], ["in", "out", "out"])]
            for pair in ((golden, frames[1]), (frames[0], mine), frames):
                found = graze.compare(*pair)
                self.assertEqual([found.report[key] for key in ("rows", "agree", "wrong", "missing", "extra")], [3, 2, 1, 0, 0])
            self.assertEqual((found.report["golden"], found.report["candidate"]), ("golden.csv", "candidate.csv"))
            found = graze.compare(golden, mine, solid="cube.off")
            self.assertEqual([found.report[key] for key in ("rows", "agree", "wrong", "missing", "extra")], [3, 2, 1, 0, 0])
            self.assertTrue(found.differs)
            self.assertIn("graze explain cube.off MOTION 5 1 2", found.text)
            self.assertFalse(graze.compare(golden, mine, on_as="out").differs)
            self.assertEqual(found.text, program("compare", golden, mine, "--solid", "cube.off"))
            self.assertIn("1 wrong", repr(found))
            with self.assertRaises(graze.MachineError):
                graze.compare(golden, os.path.join(folder, "nowhere.csv"))
            with self.assertRaises(graze.UseError):
                graze.compare(golden, mine, on_as="off")
