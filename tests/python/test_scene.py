"""Scenes and their answers: derived by hand here, and the golden cases.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import doctest
import json
import math
import os
import pickle
import tempfile
import unittest
from fractions import Fraction as F

import common
import graze
from graze import Cell, Class, Pmc

# The cube [0, 2]^3 runs 8 along x: c = (x - 8t, y, z). Words and times are evident.
CUBE_ANSWERS = [
    ((5, 1, 1), (Pmc.IN, Class.REGULAR, 5, 1, 2, 0), "OBIBO"),
    ((5, 1, 2), (Pmc.ON, Class.BOUNDARY, 8, 1, 0, 1), "OBO"),
    ((2, 1, 1), (Pmc.IN, Class.REGULAR, 5, 4, 2, 0), "BIBO"),
    ((9, 1, 1), (Pmc.IN, Class.REGULAR, 5, 3, 1, 0), "OBI"),
    ((5, 3, 1), (Pmc.OUT, Class.EXTERIOR, 9, 1, 0, 0), "O"),
]


class Answers(unittest.TestCase):
    def test_cube(self):
        scene = common.cube_scene()
        points = [point for point, _, _ in CUBE_ANSWERS]
        want = [tuple(map(int, verdict)) for _, verdict, _ in CUBE_ANSWERS]
        self.assertEqual(common.tuples(scene.classify(points)), want)
        self.assertEqual(common.tuples(scene.classify([list(map(float, p)) for p in points])), want)
        for point, verdict, word in CUBE_ANSWERS:
            trace = scene.trace(point)
            self.assertEqual((trace.verdict, trace.word, trace.point), (verdict, word, point))
        self.assertEqual((scene.dimension, scene.ends_meet, scene.solid.dimension), (3, False, 3))
        self.assertEqual((scene.solid.vertex_count, scene.solid.facet_count), (8, 6))
        self.assertEqual((scene.solid.component_count, scene.motion.piece_count), (1, 1))

    def test_positions(self):
        """The top face at z = 2 slides along (5, 1, 2): what is above is out."""
        scene = common.cube_scene()
        self.assertEqual(scene.topology((5, 1, 1)), ("interior", "word", "") + 8 * (None,))
        self.assertEqual(scene.topology((5, 3, 1)).position, "exterior")
        found = scene.topology((5, 1, 2))
        self.assertEqual((found.position, found.level, found.reason), ("boundary", "first_order", ""))
        self.assertEqual(scene.trace(found.witness).verdict.pmc, Pmc.OUT)
        self.assertGreater(found.witness[2], 2)
        self.assertEqual(found.witness, tuple(p + found.epsilon * u for p, u in zip((5, 1, 2), found.direction)))
        self.assertEqual((found.plane, found.rho), (None, None))
        self.assertEqual((found.normal, found.z, found.order), (None, None, None))
        rows = graze.Scene(scene.solid, scene.motion, topo=True)
        self.assertEqual(rows.rows([(5, 1, 2)]), ["5,1,2,on,boundary,8,1,0,1,OBO,boundary"])
        lines = rows.table([(5, 1, 2)]).splitlines()
        self.assertEqual(lines[-2:], ["# undecided 0", "# complete 1"])
        self.assertTrue(lines[-4].endswith(",topo"))
        self.assertFalse(scene.rows([(5, 1, 2)])[0].endswith(",boundary"))

    def test_cones(self):
        """The top of the square slides along (5, 1): what is above is left, in the colour of `on`."""
        scene = graze.Scene(common.SQUARE, common.moved("8*t", "0"))
        picture = scene.cones((5, 1)).svg
        self.assertIn('data-side="open"', picture)
        self.assertRaises(graze.UseError, scene.cones, (5, 2))
        self.assertRaises(graze.UseError, common.cube_scene().cones, (5, 1, 2))

    def test_path(self):
        """Between two ridges that draw z = x^2 and z = y^2 is a gap, in which the witness lies."""
        solid, motion = common.case("closed-roofs-open")[:2]
        scene = graze.Scene(solid, motion)
        found = scene.topology((0, 0, 0))
        self.assertEqual((found.position, found.level, found.order, found.plane, found.rho), ("boundary", "leading_terms", 1, None, None))
        for k in (0, 1, 60):
            s = found.epsilon / 2 ** k
            place = tuple(s * u + s ** 2 * found.z * n for u, n in zip(found.direction, found.normal))
            self.assertEqual(scene.trace(place).verdict.pmc, Pmc.OUT)
            self.assertTrue(k or place == found.witness)

    def test_pmc_alone(self):
        """The answers `pmc` of `CUBE_ANSWERS`, and no others; refused beside an option that needs the others."""
        full = common.cube_scene()
        scene = graze.Scene(full.solid, full.motion, columns="pmc")
        points = [point for point, _, _ in CUBE_ANSWERS]
        want = [(int(verdict[0]), 0, 0, 0, 0, 0) for _, verdict, _ in CUBE_ANSWERS]
        self.assertEqual(common.tuples(scene.classify(points)), want)
        self.assertEqual(scene.rows(points), [f"{x},{y},{z},{v[0].name.lower()}" for (x, y, z), v, _ in CUBE_ANSWERS])
        lines = scene.table(points).splitlines()
        self.assertIn("# columns pmc", lines)
        self.assertIn("x,y,z,pmc", lines)
        self.assertEqual(scene.trace((5, 1, 1)).word, "OBIBO")
        for wrong in ({"columns": "class"}, {"columns": "pmc", "topo": True}):
            with self.assertRaises(graze.UseError):
                graze.Scene(full.solid, full.motion, **wrong)
        with self.assertRaises(graze.UseError):
            scene.rows(points, format="jsonl")

    def test_enclosures(self):
        """Rows are those of the program; s of (5, 5/2, 1) is 1/2, that of (5, 1, 1) is -1."""
        plain = common.cube_scene()
        scene = graze.Scene(plain.solid, plain.motion, sdf="1e-6r", motion_error=F(3, 4))
        points = [(5, F(5, 2), 1), (5, 1, 1), (5, 1, 2)]
        rows = [row.split(",") for row in scene.rows(points)]
        self.assertEqual([row[-1] for row in rows], ["undecided", "yes", "undecided"])
        for row, s in zip(rows, (F(1, 2), -1, 0)):
            self.assertTrue(F(row[-4]) <= s <= F(row[-3]) and F(row[-3]) - F(row[-4]) <= F("3.5e-6"), row)
        self.assertEqual([json.loads(row)["certain"] for row in scene.rows(points, "jsonl")], ["undecided", "yes", "undecided"])
        lines = scene.table(points).splitlines()
        self.assertTrue(lines[-5].endswith(",word,sdf_low,sdf_high,sdf_t,certain"), lines)
        self.assertEqual([line.split(",") for line in lines[-4:-1]], rows)
        self.assertIn("# motion-error 0.75", lines)
        near = graze.Scene(plain.solid, plain.motion, sdf="1e-6r", boundary_distance=True)
        for row, far in zip(near.rows(points), (F(1, 2), 1, 0)):
            self.assertTrue(far * F(9, 10) <= F(row.split(",")[-1]) <= far, row)
        fine = graze.Scene(plain.solid, plain.motion, sdf="1e-9")
        self.assertIn("# sdf 1e-09", fine.table(points).splitlines())
        found = fine.distance(points, math.nextafter(1e-9, 0))
        for row, one in zip(fine.rows(points), found):
            low, high = (one["low"], one["high"]) if hasattr(found, "dtype") else (one.low, one.high)
            self.assertEqual([float(x) for x in row.split(",")[-3:-1]], [low, high])
        for wrong in ({"sdf": 0}, {"sdf": "-1"}, {"sdf": float("nan")}, {"sdf": "1e400"}, {"sdf": "r"},
                      {"boundary_distance": True}, {"motion_error": 1}, {"sdf": 1, "motion_error": 0}, {"sdf": 1, "columns": "pmc"}):
            with self.assertRaises(graze.UseError, msg=wrong):
                graze.Scene(plain.solid, plain.motion, **wrong)

    def test_moments(self):
        """The cube [0, 2]^3 goes along x by 8t: (5, 1, 1) is inside from 3/8 to 5/8, (5, 1, 3) never."""
        plain = common.cube_scene()
        scene = graze.Scene(plain.solid, plain.motion, moments=True)
        self.assertEqual([row.split(",")[-6:] for row in scene.rows([(5, 1, 1), (5, 1, 3)])],
                         [["3/8", "0.375", "0", "5/8", "0.625", "0"], [""] * 6])
        self.assertEqual(json.loads(scene.rows([(5, 1, 1)], "jsonl")[0])["last"], "5/8")
        lines = scene.table([(5, 1, 1)]).splitlines()
        self.assertIn("# moments yes", lines)
        self.assertTrue(lines[-3].endswith(",word,first,first_near,first_piece,last,last_near,last_piece"), lines)
        with self.assertRaises(graze.UseError):
            graze.Scene(plain.solid, plain.motion, moments=True, columns="pmc")

    def test_regular(self):
        """The cube [0, 2]^3 goes by 2 along x: its unsweep is the square x = 0; by 1: [0, 1] x [0, 2]^2."""
        plain = common.cube_scene()
        for way, (answer, position, level) in ((2, ("no", "exterior", "closed_cones")), (1, ("yes", "boundary", "first_order"))):
            motion = {"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": [f"{way}*t", 0, 0]}}]}
            scene = graze.Scene(plain.solid, motion, "unsweep", regular=True)
            self.assertEqual(scene.rows([(0, 1, 1)])[0].split(",")[-1], answer)
            found = scene.regularised((0, 1, 1))
            self.assertEqual((found.position, found.level), (position, level))
            self.assertEqual(found.witness is None, answer == "no")
            if found.witness:
                self.assertEqual(scene.trace(found.witness).verdict.pmc, Pmc.IN)
            self.assertEqual(scene.topology((0, 1, 1))[:2], ("boundary", "word"))
            lines = scene.table([(0, 1, 1)]).splitlines()
            self.assertTrue(lines[-4].endswith(",word,regular") and "# regular yes" in lines, lines)
            self.assertEqual(lines[-2], "# undecided 0")
        with self.assertRaises(graze.UseError):
            graze.Scene(plain.solid, plain.motion, regular=True)
        with self.assertRaises(graze.UseError):
            plain.regularised((0, 1, 1))

    def test_levels(self):
        """Points of a decade: the signed distance of the cube's sweep, in floats."""
        scene = common.cube_scene()
        made = list(scene.generate(40, 3, {"level": 1}))
        for sample, one in zip(made, scene.distance([sample.point for sample in made], 1e-13)):
            low, high = (one["low"], one["high"]) if graze.scene.numpy is not None else (one.low, one.high)
            self.assertEqual(low > 0, sample.outward)
            self.assertTrue(F(10) ** sample.decade <= min(abs(F(low)), abs(F(high))), sample)
            self.assertTrue(max(abs(F(low)), abs(F(high))) < F(10) ** (sample.decade + 1), sample)
        self.assertEqual({s.decade for s in scene.generate(9, 1)}, {None})

    def test_slide(self):
        """(5, 1, 2) has c = (5 - 8t, 1, 2) on the top from t = 3/8 to 5/8, over edges x = 2 and x = 0."""
        contact, = common.cube_scene().trace((5, 1, 2)).contacts
        self.assertEqual((contact.kind, contact.left, contact.right), ("tangency", "O", "O"))
        self.assertEqual((contact.start, contact.end), (F(3, 8), F(5, 8)))
        self.assertFalse(contact.is_instant)
        self.assertEqual(contact.cells, (Cell("face", (1,)), Cell("edge", (4, 7)), Cell("edge", (5, 6))))
        self.assertEqual(list(map(str, contact.cells)), ["face 1", "edge 4-7", "edge 5-6"])

    def test_end_of_the_motion(self):
        """(2, 1, 1) starts on the face x = 2 (face 3) and leaves through x = 0 (face 5) at 1/4."""
        first, second = common.cube_scene().trace((2, 1, 1)).contacts
        self.assertEqual((first.left, first.right, first.start), (None, "I", 0))
        self.assertEqual((second.left, second.right, second.start), ("I", "O", F(1, 4)))
        self.assertEqual((first.cells, second.cells), ((Cell("face", (3,)),), (Cell("face", (5,)),)))
        self.assertTrue(first.is_instant and first.kind == second.kind == "intersection")

    def test_irrational_times(self):
        """c = (3 - t^2, 1/2) is in [0, 1]^2 while t is in [sqrt 2, sqrt 3]."""
        trace = common.root_scene().trace((3, "1/2"))
        self.assertEqual((trace.word, trace.verdict[4:]), ("OBIBO", (2, 0)))
        first, second = (contact.start for contact in trace.contacts)
        self.assertEqual((first.coefficients, first.interval), ((-2, 0, 1), (1, 2)))
        self.assertEqual((second.coefficients, second.interval), ((-3, 0, 1), (1, 2)))
        low, high = second.refine(400)
        self.assertTrue(low ** 2 < 3 < high ** 2 and high - low <= F(1, 1 << 400))
        self.assertTrue(1 < first < second < 2)

    def test_negative_irrational_time(self):
        """From t = -2 to 0 instead, the times are -sqrt 3 and -sqrt 2, in (-2, -1)."""
        scene = graze.Scene(common.SQUARE, common.moved("t^2", "0", start="-2", end="0"))
        times = [contact.start for contact in scene.trace((3, "1/2")).contacts]
        self.assertEqual([t.interval for t in times], [(-2, -1), (-2, -1)])
        self.assertTrue(times[0] < times[1] < -1)
        self.assertEqual([str(t)[:6] for t in times], ["-1.732", "-1.414"])

    def test_unsweep(self):
        """The cube moved by 1 along x keeps 1 < x < 2 inside all the time: c = (x + t, y, z)."""
        scene = graze.Scene(common.CUBE, common.moved("t", "0", "0"), operation="unsweep")
        verdicts = scene.classify([("1/2", 1, 1), (1, 1, 1), ("3/2", 1, 1)])
        self.assertEqual(graze.pmc_names(verdicts), ["in", "on", "out"])
        self.assertEqual(graze.class_names(verdicts), ["none"] * 3)
        self.assertEqual(graze.definition_names(verdicts), [""] * 3)

    def test_overlap(self):
        """Moved by 1 the cube's ends meet: (3/2, 1, 1) is inside at both, case 9, which is `ext`."""
        motion = common.moved("t", "0", "0")
        scene = graze.Scene(common.CUBE, motion)
        verdicts = scene.classify([("3/2", 1, 1)])
        self.assertTrue(scene.ends_meet)
        self.assertEqual(common.tuples(verdicts), [(1, 1, 0, 9, 0, 0)])
        self.assertEqual(graze.definition_names(verdicts), ["ext"])
        with self.assertRaises(graze.IllegalError):
            graze.Scene(common.CUBE, motion, overlap="reject")

    def test_box_holds_the_sweep(self):
        """The cube's sweep is [0, 10] x [0, 2]^2; the box exceeds it by about 10/2048 at most."""
        low, high = common.cube_scene().box()
        for a, b, from_, to in zip(low, high, (0, 0, 0), (10, 2, 2)):
            self.assertTrue(from_ - F(1, 100) <= a <= from_ and to <= b <= to + F(1, 100), (a, b))

    def test_explain(self):
        text = common.cube_scene().explain((5, 1, 2))
        self.assertTrue(text.startswith("P = (5, 1, 2) is `on`"), text)


class Grids(unittest.TestCase):
    def test_square(self):
        """[0, 1]^2 moved by (8, 0) sweeps [0, 9] x [0, 1]; the points are (i - 1, j/2 - 1)."""
        scene = graze.Scene(common.SQUARE, common.moved("8*t", "0"))
        given = scene.grid((13, 9), (-1, -1), (11, 3))
        for i in range(13):
            for j in range(9):
                outside = not (0 <= i - 1 <= 9 and 2 <= j <= 4)
                touched = i - 1 in (0, 9) or j in (2, 4)
                expected = graze.Pmc.OUT if outside else graze.Pmc.ON if touched else graze.Pmc.IN
                self.assertEqual(given[i + 13 * j] if isinstance(given, bytes) else given[i, j], expected, (i, j))
        self.assertEqual(len(scene.grid((2, 2))), 4 if isinstance(given, bytes) else 2)

    def test_refusals(self):
        scene = graze.Scene(common.SQUARE, common.moved("8*t", "0"))
        for size, box in (((4,), ()), ((4, 1), ()), ((4, 4), ((0, 0), (0, 1)))):
            with self.assertRaises(graze.UseError):
                scene.grid(size, *box)
        with self.assertRaises(graze.LimitError):
            graze.Scene(common.SQUARE, common.moved("8*t", "0"), limits={"grid": 15}).grid((4, 4))


class Golden(unittest.TestCase):
    def test_cases(self):
        """classify and rows against every expected table under cases/."""
        names = common.case_names()
        self.assertGreater(len(names), 50)
        pmc, class_ = graze.PMC_NAMES.index, graze.CLASS_NAMES.index
        for name in names:
            solid, motion, points, options = common.case(name)
            scene = graze.Scene(solid, motion, **options)
            expected = common.read_rows(os.path.join(os.path.dirname(points), "expected.csv"))
            given = [common.coordinates(row) for row in expected]
            self.assertEqual(given, [list(map(common.token, common.coordinates(row)))
                                     for row in common.read_rows(points)], name)
            rows = scene.rows(given)
            verdicts = common.tuples(scene.classify(given))
            for row, text, verdict in zip(expected, rows, verdicts):
                with self.subTest(case=name, point=row):
                    self.assertEqual(text.split(","), list(row.values())[:text.count(",") + 1])
                    self.assertEqual(text.split(",")[-1], row["word"])
                    if "class" in row:
                        definition = 0 if row["definition"] == "ext" else int(row["definition"])
                        self.assertEqual(verdict, (pmc(row["pmc"]), class_(row["class"]), definition,
                                                   int(row["case"]), int(row["i"]), int(row["t"])))
                    else:
                        self.assertEqual(verdict[0], pmc(row["pmc"]))


class Inputs(unittest.TestCase):
    def test_motions(self):
        """One motion as dict, text and file; floats in it are the dyadic numbers they are."""
        made = common.moved("t^2", "0", end="2")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "motion.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(made, file)
            for motion in (made, "\n " + json.dumps(made), path, graze.Motion(made)):
                scene = graze.Scene(common.SQUARE, motion)
                self.assertEqual(scene.rows([(3, 1)]), ["3,1,on,boundary,8,1,0,1,OBO"])
        floats = {"dimension": 2, "pieces": [{"t": [0, 1.0], "transform": {"translate": [0.1, F(1, 3)]}}]}
        trace = graze.Scene(common.SQUARE, floats).trace((F(0.1), F(1, 3)))
        self.assertEqual((trace.word, trace.contacts[0].cells), ("B", (Cell("vertex", (0,)),)))

    def test_solids(self):
        """One square as ints, text, floats and a file, and the cube's numbers of cells."""
        want = common.root_scene().rows([(3, "1/2"), (2, 1)])
        floats = [tuple(map(float, vertex)) for vertex in common.SQUARE[0]]
        texts = [("0", "0"), ("1.0", 0), (F(1), "2/2"), (0, "1e0")]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "square.wkt")
            with open(path, "w", encoding="utf-8") as file:
                file.write("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n")
            for solid in ((floats, [[0, 1, 2, 3]]), (texts, iter([range(4)])), path, graze.Solid(path)):
                scene = graze.Scene(solid, common.moved("t^2", "0", end="2"))
                self.assertEqual(scene.rows([(3, "1/2"), (2, 1)]), want)

    @unittest.skipIf(common.numpy is None, "numpy")
    def test_solids_of_arrays(self):
        np = common.numpy
        want = common.cube_scene().classify([(5, 1, 2), (5, 1, 1)])
        for vertices in (np.array(common.CUBE[0]), np.array(common.CUBE[0], float)):
            for facets in (np.array(common.CUBE[1]), np.array(common.CUBE[1], np.uint8), common.CUBE[1],
                           list(np.array(common.CUBE[1]))):
                scene = graze.Scene((vertices, facets), common.moved("8*t", "0", "0"))
                self.assertEqual(scene.classify([(5, 1, 2), (5, 1, 1)]).tolist(), want.tolist())
        for facets, kind in [(-np.array(common.CUBE[1]), graze.InputError),
                             (np.array(common.CUBE[1], float), TypeError)]:
            with self.assertRaises(kind):
                graze.Solid((np.array(common.CUBE[0]), facets))

    def test_refused(self):
        vertices, facets = common.CUBE
        motion = common.moved("8*t", "0", "0")
        for make, kind, words in [
                (lambda: graze.Solid("nowhere.off"), graze.MachineError, "nowhere.off"),
                (lambda: graze.Solid((vertices, facets[:5])), graze.IllegalError, "edge"),
                (lambda: graze.Solid((vertices, [])), graze.IllegalError, "no facet"),
                (lambda: graze.Solid((vertices, facets[:5] + [(0, 1)])), graze.InputError, "facet 5"),
                (lambda: graze.Solid((vertices, facets[:5] + [(0, 1, 8)])), graze.InputError, "facet 5"),
                (lambda: graze.Solid((vertices, facets[:5] + [(0, 1, -1)])), graze.InputError, "facet 5"),
                (lambda: graze.Solid((vertices, facets[:5] + [(0, 1, "2")])), TypeError, "facet 5"),
                (lambda: graze.Solid((vertices, facets[:5] + [7])), TypeError, "facet 5"),
                (lambda: graze.Solid((vertices[:7] + [(1, 2)], facets)), graze.UseError, "vertex 7"),
                (lambda: graze.Solid((vertices[:7] + [(1, 2, "a")], facets)), graze.InputError, "vertex 7"),
                (lambda: graze.Solid(None), TypeError, "pair"),
                (lambda: graze.Solid("a\0.off"), graze.UseError, "NUL"),
                (lambda: graze.Motion("{"), graze.InputError, ""),
                (lambda: graze.Motion({"dimension": 3}), graze.InputError, "pieces"),
                (lambda: graze.Motion(common.moved("1/t", "0", "0")), graze.IllegalError, "pole"),
                (lambda: graze.Motion({"dimension": float("nan")}), graze.InputError, "nan"),
                (lambda: graze.Motion({"dimension": {1, 2}}), TypeError, "set"),
                (lambda: graze.Motion("nowhere.json"), graze.MachineError, "nowhere.json"),
                (lambda: graze.Scene(common.CUBE, common.moved("t", "0")), graze.IllegalError, "dimension"),
                (lambda: graze.Scene(common.CUBE, motion, folds="both"), graze.UseError, "folds"),
                (lambda: graze.Scene(common.CUBE, motion, round="binary16"), graze.UseError, "round")]:
            with self.assertRaises(kind, msg=words) as raised:
                make()
            self.assertIn(words, str(raised.exception))
            if isinstance(raised.exception, graze.GrazeError):
                self.assertEqual(raised.exception.status, kind.status)

    def test_triangulate(self):
        """A cube with one corner raised has facets that are not planar; fanned it is legal."""
        vertices = [v if v != (2, 2, 2) else (2, 2, 3) for v in common.CUBE[0]]
        with self.assertRaises(graze.IllegalError):
            graze.Solid((vertices, common.CUBE[1]))
        self.assertEqual(graze.Solid((vertices, common.CUBE[1]), triangulate=True).vertex_count, 8)

    def test_handles_stay_in_their_process(self):
        for call in (pickle.dumps, copy.deepcopy):
            with self.assertRaises(TypeError):
                call(common.root_scene())


class Columns(unittest.TestCase):
    def test_columns(self):
        points = [point for point, _, _ in CUBE_ANSWERS]
        made = graze.columns(common.cube_scene().classify(points), points)
        self.assertEqual(list(made), ["x", "y", "z", "pmc", "class", "definition", "case", "i", "t"])
        self.assertEqual(list(made["x"]), [5, 5, 2, 9, 5])
        self.assertEqual(made["pmc"], ["in", "on", "in", "in", "out"])
        self.assertEqual(made["class"], ["regular", "boundary", "regular", "regular", "exterior"])
        self.assertEqual((made["definition"], made["case"]), (["5", "8", "5", "5", "9"], [1, 1, 4, 3, 1]))
        self.assertEqual((made["i"], made["t"]), ([2, 0, 2, 1, 0], [0, 1, 0, 0, 0]))
        with self.assertRaises(ValueError):
            graze.columns(common.cube_scene().classify(points), points[1:])

    def test_dataframe(self):
        points = [point for point, _, _ in CUBE_ANSWERS]
        verdicts = common.cube_scene().classify(points)
        try:
            import pandas  # noqa: F401
        except ImportError:
            with self.assertRaises(graze.GrazeError):
                graze.to_dataframe(verdicts)
            return
        frame = graze.to_dataframe(verdicts, points)
        self.assertEqual(frame.groupby("class", observed=True)["i"].sum().to_dict(),
                         {"regular": 5, "boundary": 0, "exterior": 0})
        self.assertEqual(common.tuples(common.cube_scene().classify(frame[["x", "y", "z"]])),
                         common.tuples(verdicts))


class Package(unittest.TestCase):
    def test_example(self):
        here = os.getcwd()
        os.chdir(common.ROOT)
        try:
            failed, tried = doctest.testmod(graze)
        finally:
            os.chdir(here)
        self.assertEqual((failed, tried > 0), (0, True))

    def test_names_and_version(self):
        with open(os.path.join(common.ROOT, "include", "graze", "version.h"), encoding="utf-8") as file:
            self.assertIn(f'#define GRAZE_VERSION "{graze.__version__}"', file.read())
        self.assertTrue(graze.version().startswith(f"graze {graze.__version__}\n"))
        for name in graze.__all__:
            self.assertTrue(hasattr(graze, name), name)
            if name not in ("Time", "CLASS_NAMES", "PMC_NAMES", "ENCLOSURE_DTYPE", "VERDICT_DTYPE", "__version__"):
                self.assertTrue(getattr(graze, name).__doc__, name)
        self.assertTrue(os.path.exists(os.path.join(os.path.dirname(graze.__file__), "py.typed")))

    def test_words(self):
        """Words of the module are those of the library."""
        library = graze._library.library()
        for names, kind in ((graze.PMC_NAMES, graze.Pmc), (graze.CLASS_NAMES, graze.Class)):
            self.assertEqual([(member.name.lower(), member.value) for member in kind], [(name, k) for k, name in enumerate(names)])
        for enum in ("pmc", "class", "rounding", "topo", "topo_level", "role", "orientation", "event_kind", "curve_kind",
                     "chain_form", "decomposable"):
            for word, number in graze._abi.words("graze_" + enum).items():
                self.assertEqual(getattr(library, f"graze_{enum}_name")(number).decode(), word)

    @unittest.skipIf(common.numpy is None, "numpy")
    def test_layout(self):
        CVerdict = graze._abi.C.graze_verdict
        import ctypes
        self.assertEqual(graze.VERDICT_DTYPE.itemsize, ctypes.sizeof(CVerdict))
        for (name, _), c_name in zip(CVerdict._fields_, graze.VERDICT_DTYPE.names):
            self.assertEqual(getattr(CVerdict, name).offset, graze.VERDICT_DTYPE.fields[c_name][1])
