"""compare: errors of values against enclosures. The square that moves by 8 along x, s as derived beside the points.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import tempfile
import unittest
from fractions import Fraction as F

import common
import graze

# (x, y, pmc, s, a value): [0, 1]^2 sweeps [0, 9] x [0, 1]; the deepest place is at 1/2.
ROWS = [("4", "3", "out", F(2), "2.5"), ("4", "1/4", "in", F(-1, 4), "-1/8"), ("4", "1", "on", F(0), "0"),
        ("10", "1/2", "out", F(1), "3/4")]


class Values(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.golden = os.path.join(self.folder.name, "golden.csv")
        self.mine = os.path.join(self.folder.name, "mine.csv")
        with open(self.golden, "w", encoding="utf-8") as f:
            f.write("x,y,pmc,sdf_low,sdf_high\n")
            f.writelines(f"{x},{y},{pmc},{s},{s}\n" for x, y, pmc, s, _ in ROWS)
            f.write("# complete 4\n")
        with open(self.mine, "w", encoding="utf-8") as f:
            f.write("x,y,sdf\n" + "".join(f"{x},{y},{v}\n" for x, y, _, _, v in ROWS))

    def compare(self, **options):
        return graze.compare(self.golden, self.mine, candidate_has="sdf", **options)

    def test_errors(self):
        """1/2 and 1/8 above, 1/4 below, one within."""
        found = self.compare()
        errors = found.report["errors-of-sdf"]
        self.assertEqual([errors[k] for k in ("values", "within", "over", "under")], [4, 1, 2, 1])
        self.assertEqual((F(errors["largest"]), F(errors["quantiles"]["50"])), (F(1, 2), F("0.13")))
        self.assertFalse(found.differs)
        self.assertEqual(self.compare(sdf_tolerance=0.25).report["wrong"], 1)
        self.assertEqual(self.compare(sdf_tolerance=F(1, 9)).report["wrong"], 3)
        outside = self.compare(sdf_tolerance="1/9", truth="outside").report
        self.assertEqual((outside["wrong"], outside["errors-of-sdf"]["values"]), (2, 2))

    def test_depth(self):
        """Without enclosures in the table they are made in its scene: y = 1 and y = 3 above [0, 9] x [0, 1], both wrong."""
        with open(self.golden, "w", encoding="utf-8") as f:
            f.write("x,y,pmc\n4,3,out\n4,1,on\n# complete 2\n")
        with open(self.mine, "w", encoding="utf-8") as f:
            f.write("x,y,pmc\n4,3,in\n4,1,in\n")
        self.assertNotIn("depth-of-wrong-rows", graze.compare(self.golden, self.mine).report)
        scene = graze.Scene(common.SQUARE, common.moved("8*t", "0"))
        depth = graze.compare(self.golden, self.mine, scene=scene).report["depth-of-wrong-rows"]
        self.assertEqual((depth["on"]["largest"], depth["out"]["rows"]), ("0", 1))
        self.assertTrue(F(2) <= F(depth["out"]["largest"]) < F(2001, 1000))
        with self.assertRaisesRegex(TypeError, "scene is a int; expected a Scene"):
            graze.compare(self.golden, self.mine, scene=5)

    def test_motion_error(self):
        """|s| > 1/2 in two rows; widened by 1/2 all values are within."""
        report = self.compare(motion_error=0.5).report
        self.assertEqual((report["undecided-by-motion-error"], report["undecided"], report["errors-of-sdf"]["within"]), (2, 2, 4))

    def test_refusals(self):
        for name, bad in (("sdf_tolerance", -1), ("motion_error", 0), ("sdf_tolerance", float("nan")),
                          ("motion_error", float("inf")), ("motion_error", "x")):
            with self.assertRaisesRegex(graze.InputError, name):
                self.compare(**{name: bad})
        with self.assertRaises(graze.UseError):
            graze.compare(self.golden, self.mine, sdf_tolerance=1)
        with self.assertRaises(ValueError):
            self.compare(truth="inside")

    def test_positions(self):
        """A position that is none is refused by name, and no reason to leave its row out."""
        with open(self.golden, "w", encoding="utf-8") as f:
            f.write("x,y,pmc,topo\n4,1,on,unknown\n# complete 1\n")
        with open(self.mine, "w", encoding="utf-8") as f:
            f.write("x,y,pmc\n4,1,on\n")
        with self.assertRaisesRegex(graze.InputError, "topo: 'unknown' is no answer; expected interior, boundary or undecided"):
            graze.compare(self.golden, self.mine, question="closed")


class Contacts(unittest.TestCase):
    """The front of [0, 1]^2 moving by 8 along x: its points are egress, uncovered later; those of the top slide."""

    def test_contacts(self):
        scene = graze.Scene(common.SQUARE, common.moved("8*t", "0"))
        sites = [(F(1, 2), (1, F(1, 3))), (F(1, 2), (F(1, 3), 1))]
        with tempfile.TemporaryDirectory() as folder:
            golden, mine = (os.path.join(folder, name) for name in ("golden.csv", "mine.csv"))
            with open(golden, "w", encoding="utf-8") as f:
                f.write("time,bx,by,role,trimmed,status\n")
                for t, y in sites:
                    s = scene.site(t, y)
                    f.write(f"{t},{y[0]},{y[1]},{s.role},{'yes' if s.trimmed else 'no'},{s.status}\n")
                f.write("# complete 2\n")
            with open(mine, "w", encoding="utf-8") as f:  # in double, the other way round
                f.write("time,bx,by,role,status\n0.5,0.3333333333333333,1,contact,simple\n"
                        "0.5,1,0.3333333333333333,egress,trimmed_near\n")
            with self.assertRaisesRegex(graze.InputError, "no row is one of"):
                graze.compare(golden, mine)
            report = graze.compare(golden, mine, round="binary64").report
        self.assertEqual((report["agree"], report["wrong"], report["extra"]), (1, 1, 0))
        self.assertEqual(report["wrong-by-column"], {"role": 0, "status": 1})
        self.assertEqual(report["not-in-candidate"], ["trimmed"])
        self.assertEqual([g["value"] for g in report["by"]["status"] if g["wrong"]], ["slides"])
