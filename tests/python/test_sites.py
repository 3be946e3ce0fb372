"""Contact points: facts that are derived in tests/contact/hand.py, and the rows of `graze contact`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import tempfile
import unittest
from fractions import Fraction as F

import common
import graze

BLOCK = ([(2, -1), (4, -1), (4, 1), (2, 1)], [[0, 1, 2, 3]])
TURN = {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"compose": [
    {"rotate": {"tan_half": "t"}}, {"translate": ["2*t", "0"]}]}}]}


class Sites(unittest.TestCase):
    def test_facts(self):
        """The block turns and moves: its side x = 2 touches at (2, 3/4), t = 1/2, and enters at 4/5."""
        site = graze.Scene(BLOCK, TURN).site("1/2", [2, F(3, 4)])
        self.assertEqual((site.role, site.status, site.trimmed), ("contact", "trimmed_far", True))
        self.assertEqual((site.theta, site.order, site.orientation), (1, 2, "reversing"))
        self.assertEqual((site.left, site.right, site.near, site.near_in), ("O", "O", F(4, 5), F(4, 5)))
        self.assertEqual((site.point, site.trace.word, str(site.cell)), ((F(8, 5), F(41, 20)), "OBOBI", "edge 0-3"))
        self.assertEqual([(f.side, f.speed, f.drift, f.theta, f.order, f.sign) for f in site.facets],
                         [(-1, 0, F(8, 5), F(24, 25), 2, 1), (1, 0, F(8, 5), F(24, 25), 2, 1)])

    def test_ends(self):
        """A square that moves to the right: its back at the start, an irrational time, a time given by a string."""
        scene = graze.Scene(common.SQUARE, common.moved("8*t", "0"))
        site = scene.site(0, [0, 0.5])
        self.assertEqual((site.role, site.status, site.left, site.right), ("contact", "simple", None, "O"))
        self.assertEqual((site.near, site.near_in, site.theta, site.orientation), (None, None, None, None))
        by_place = common.root_scene().site("1", point=["1", "1/2"])
        self.assertEqual((by_place.body, by_place.role, by_place.near), ((0, F(1, 2)), "ingress", 1))

    def test_snap(self):
        """On the side x = 2 of the turning block the contact at 1/2 is (2, 3/4); its opposite y = -1 has none."""
        scene = graze.Scene(BLOCK, TURN)
        site, square = scene.snap("1/2", graze.Cell("edge", (0, 3)), [5, F(1, 3)])
        self.assertEqual((site.body, square, site.role, site.near), ((2, F(3, 4)), F(1321, 144), "contact", F(4, 5)))
        self.assertEqual(scene.snap("1/2", graze.Cell("edge", (0, 3)), point=site.point)[1], 0)
        self.assertIsNone(scene.snap("1/2", graze.Cell("edge", (0, 1)), [5, F(1, 3)]))
        self.assertEqual(scene.snap("1/2", graze.Cell("vertex", (1,)), [4, 0])[1], 1)
        with self.assertRaisesRegex(graze.InputError, "no such cell"):
            scene.snap("1/2", graze.Cell("face", (0,)), [5, 0])

    def test_refusals(self):
        scene = graze.Scene(common.SQUARE, common.moved("8*t", "0"))
        with self.assertRaisesRegex(graze.InputError, "not on the boundary"):
            scene.site(0, ["1/2", "1/2"])
        with self.assertRaisesRegex(graze.InputError, "no such time"):
            scene.site(2, [0, 0])
        with self.assertRaisesRegex(graze.UseError, "one of them"):
            scene.site(0)
        with self.assertRaises(graze.UseError):
            graze.Scene(common.SQUARE, common.moved("8*t", "0"), operation="unsweep").site(0, [0, 0])

    def test_program(self):
        """The program's JSON Lines have the same."""
        scene = graze.Scene(BLOCK, TURN)
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ("s.wkt", "m.json", "c.csv")]
            texts = ["POLYGON ((2 -1, 4 -1, 4 1, 2 1, 2 -1))", json.dumps(TURN), "time,bx,by\n1/3,4,1/2\n1/4,2,1\n0,3,-1\n"]
            for path, text in zip(paths, texts):
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            out = common.program("contact", *paths, "--format", "jsonl")
        for line in out.splitlines():
            row = json.loads(line)
            site = scene.site(row["time"], row["body"])
            self.assertEqual((row["role"], row["status"], row["word"]), (site.role, site.status, site.trace.word))
            self.assertEqual([(F(f["speed"]), F(f["drift"]), F(f["theta"])) for f in row["facets"]],
                             [(f.speed, f.drift, f.theta) for f in site.facets])
