"""Pairs of solids: words, times and cells derived here, and the words of `graze collide`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import subprocess
import tempfile
import unittest
from fractions import Fraction

import common
import graze

FAR = ([(3, 0), (4, 0), (4, 1), (3, 1)], [[0, 1, 2, 3]])


class Collisions(unittest.TestCase):
    def test_head_on(self):
        """[t, t + 1] x [0, 1] meets [3, 4] x [0, 1] for t in [2, 4], by the whole side x = t + 1 at t = 2 and x = t at 4."""
        found = graze.collide(common.SQUARE, common.moved("t", "0", end="5"), FAR)
        self.assertEqual((found.verdict, found.word, found.overlap, bool(found)), ("overlap", "OBIBO", 2, True))
        first, last = found.contacts
        self.assertEqual((first.kind, first.left, first.right, first.start, first.end), ("intersection", "O", "I", 2, 2))
        self.assertEqual({(str(c.moving), str(c.fixed), c.type) for c in first.cells},
                         {("edge 1-2", "edge 0-3", "edge-edge"), ("vertex 1", "vertex 0", "vertex-vertex"),
                          ("vertex 2", "vertex 3", "vertex-vertex")})
        self.assertEqual(last.start, 4)

    def test_first(self):
        """With t^2 in place of t the first contact is at the root of 2."""
        found = graze.collide(common.SQUARE, common.moved("t^2", "0", end="5"), FAR, first=True)
        contact, = found.contacts
        self.assertEqual((found.verdict, found.word, contact.kind, contact.end), ("meets", "OBI", None, None))
        self.assertEqual(list(contact.start.coefficients), [-2, 0, 1])
        self.assertEqual((found.next, found.overlap, bool(found)), ("I", contact.start, True))
        # The square is at x = 3 at the end, t = 2; with x = 2 it touches all the time; with x = t/2 never.
        for x, word, following, verdict in (("t", "OB", None, "meets"), ("2", "B", "B", "meets"), ("t/2", "O", None, "clear")):
            found = graze.collide(common.SQUARE, common.moved(x, "0", end="2"), FAR, first=True)
            self.assertEqual((found.word, found.next, found.verdict), (word, following, verdict))
        self.assertIsNone(graze.collide(common.SQUARE, common.moved("t", "0", end="5"), FAR).next)

    def test_clearance(self):
        """The squares are 2 - t apart, then t - 4; 1/3 at 5/3 and 13/3. A clearance of 0 is none."""
        motion = common.moved("t", "0", end="5")
        for clearance in (Fraction(1, 3), "1/3"):
            found = graze.collide(common.SQUARE, motion, FAR, clearance=clearance)
            self.assertEqual((found.word, found.overlap), ("OBIBO", Fraction(5, 3)))
            self.assertEqual([c.start for c in found.contacts], [Fraction(5, 3), Fraction(13, 3)])
        self.assertEqual(graze.collide(common.SQUARE, motion, FAR, clearance=0.0), graze.collide(common.SQUARE, motion, FAR))
        with self.assertRaises(graze.UseError):
            graze.collide(common.SQUARE, motion, FAR, clearance=-1)

    def test_closest(self):
        """The squares are 2 - t apart: 1/2 at t = 3/2; at t = 2 they meet. Their sizes are 1 and 1."""
        near = common.moved("t", "0", end="3/2")
        found = graze.collide(common.SQUARE, near, FAR, closest=1e-6).closest
        self.assertTrue(found.low <= 0.5 <= found.high <= found.low + 1e-6)
        self.assertEqual((found.time, found.at, found.wide), (Fraction(3, 2), ((2.5, found.at[0][1]), (3.0, found.at[0][1])), False))
        self.assertEqual(graze.collide(common.SQUARE, near, FAR, closest="1/1024r").closest,
                         graze.collide(common.SQUARE, near, FAR, closest="1/512").closest)
        met = graze.collide(common.SQUARE, common.moved("t", "0", end="5"), FAR, closest=1).closest
        self.assertEqual(met, graze.Closest(0.0, 0.0, Fraction(2), None, False))
        self.assertIsNone(graze.collide(common.SQUARE, near, FAR).closest)
        for wrong in (0, -1, "x"):
            with self.assertRaises(graze.UseError):
                graze.collide(common.SQUARE, near, FAR, closest=wrong)
        with self.assertRaises(graze.UseError):
            graze.collide(common.SQUARE, near, FAR, closest=1, first=True)

    def test_motion_error(self):
        """The squares are 2 - t apart: 1/4 at t = 7/4, and the middle of a side is 1/4 deep at 9/4. At a clearance of 1/2: 3/4 and 1/4 apart."""
        motion = common.moved("t", "0", end="5")
        for error in (Fraction(1, 4), "1/4", 0.25):
            found = graze.collide(common.SQUARE, motion, FAR, motion_error=error)
            self.assertEqual(found.first_contact, graze.FirstContact(Fraction(7, 4), Fraction(9, 4)))
        found = graze.collide(common.SQUARE, motion, FAR, motion_error=Fraction(1, 4), clearance=Fraction(1, 2))
        self.assertEqual(found.first_contact, graze.FirstContact(Fraction(5, 4), Fraction(7, 4)))
        self.assertEqual(graze.collide(common.SQUARE, motion, FAR, motion_error=0).first_contact, graze.FirstContact(2, 2))
        near = common.moved("t", "0", end="15/8")
        self.assertEqual(graze.collide(common.SQUARE, near, FAR, motion_error="1/4").first_contact, graze.FirstContact(Fraction(7, 4), None))
        away = graze.collide(common.SQUARE, common.moved("t", "0", end="1"), FAR, motion_error="1/4")
        self.assertEqual((away.first_contact, bool(away)), (graze.FirstContact(None, None), False))
        self.assertIsNone(graze.collide(common.SQUARE, motion, FAR).first_contact)
        for wrong in ({"motion_error": -1}, {"motion_error": 1, "first": True}, {"motion_error": 1, "inside": True}, {"motion_error": 1, "closest": 1}):
            with self.assertRaises(graze.UseError):
                graze.collide(common.SQUARE, motion, FAR, **wrong)

    def test_never(self):
        found = graze.collide(common.SQUARE, common.moved("t", "2"), FAR)
        self.assertEqual((found.verdict, found.word, found.contacts, found.overlap, bool(found)), ("clear", "O", (), None, False))

    def test_both_move(self):
        """Two squares with one motion stand still relative to each other; the times are those of both motions."""
        square, motion = graze.Solid(common.SQUARE), graze.Motion(common.moved("t", "t^2", end="5"))
        self.assertEqual(graze.collide(square, motion, FAR, motion).word, "O")
        slower = common.moved("t/2", "0", start="2", end="10")
        # t + 1 = 3 + t/2 at t = 4; the motions have [2, 5] in common.
        found = graze.collide(square, common.moved("t", "0", end="5"), FAR, slower)
        self.assertEqual((found.word, found.contacts[0].start, found.contacts[0].row), ("OBI", 4, None))
        logged = common.moved("t", "0", end="5")
        logged["pieces"][0]["row"] = 17
        self.assertEqual(graze.collide(square, logged, FAR).contacts[0].row, 17)
        with self.assertRaises(graze.IllegalError):
            graze.collide(square, motion, FAR, common.moved("t", "0", start="5", end="6"))

    def test_inside(self):
        """[t, t + 1] stays in [0, 4] up to t = 3, touching at t = 0."""
        room = ([(0, -1), (4, -1), (4, 2), (0, 2)], [[0, 1, 2, 3]])
        found = graze.collide(common.SQUARE, common.moved("t", "0", end="4"), room, inside=True)
        self.assertEqual((found.word, found.overlap, [c.start for c in found.contacts]), ("BOBI", 3, [0, 3]))
        self.assertEqual(graze.collide(common.SQUARE, common.moved("1 + t", "0"), room, inside=True).verdict, "clear")
        found = graze.collide(common.SQUARE, common.moved("1 + t", "0"), room, inside=True, first=True)
        self.assertEqual((found.verdict, found.next, bool(found)), ("inside", None, False))
        found = graze.collide(common.SQUARE, common.moved("t", "0", end="4"), room, inside=True, first=True)
        self.assertEqual((found.verdict, found.word, found.next, found.overlap), ("meets", "BO", "O", None))

    def test_rounding(self):
        with self.assertRaises(graze.UseError):
            graze.collide(graze.Solid(common.SQUARE), common.moved("t", "0"), FAR, round="binary64")

    def test_program(self):
        """The word and the first time are those of the command's JSON."""
        with tempfile.TemporaryDirectory() as folder:
            names = [os.path.join(folder, name) for name in ("moving.wkt", "motion.json", "fixed.wkt")]
            with open(names[0], "w") as file:
                file.write("POLYGON((0 0, 1 0, 1 1, 0 1, 0 0))")
            with open(names[1], "w") as file:
                json.dump(common.moved("t", "t/3", end="5"), file)
            with open(names[2], "w") as file:
                file.write("POLYGON((3 0, 4 0, 4 1, 3 1, 3 0))")
            done = subprocess.run([common.GRAZE, "collide", *names, "--format", "json"], capture_output=True)
            told = json.loads(done.stdout)
            found = graze.collide(*names)
            self.assertEqual((done.returncode, told["verdict"], told["word"]), (1, found.verdict, found.word))
            self.assertEqual(Fraction(told["first"]["from"]), found.contacts[0].start)
            self.assertEqual([c["type"] for c in told["first"]["cells"]], [c.type for c in found.contacts[0].cells])
