"""Events of envelopes: facts that are derived in tests/envelope/hand.py, and the rows of `graze envelope`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import unittest
from fractions import Fraction

import common
import graze

BLOCK = ([(2, -1), (4, -1), (4, 1), (2, 1)], [[0, 1, 2, 3]])
TURN = {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"compose": [
    {"rotate": {"tan_half": "t"}}, {"translate": ["2*t", "0"]}]}}]}


class Envelopes(unittest.TestCase):
    def test_facts(self):
        """On x = 2 theta changes its sign once, at the root of t^3 + 3t - 2."""
        envelope = graze.Scene(BLOCK, TURN).envelope()
        self.assertEqual((envelope.decomposable, envelope.facets, envelope.edges, envelope.vertices), ("no", 4, 0, 4))
        self.assertEqual(envelope.reason, "theta is negative on a slice")
        event, = [e for e in envelope.events if e.kind == "cusp" and e.before and e.after]
        self.assertEqual((str(event.facet), str(event.cell), event.other, event.before, event.after),
                         ("edge 0-3", "edge 0-3", None, 1, -1))
        self.assertEqual(list(event.time.coefficients), [-2, 3, 0, 1])
        self.assertEqual([float(e.time) for e in envelope.events], sorted(float(e.time) for e in envelope.events))
        self.assertIsNone(envelope.events[0].before)

    def test_still(self):
        """A square that moves along its side: nothing ever changes."""
        envelope = graze.Scene(common.SQUARE, common.moved("8*t", "0")).envelope()
        self.assertEqual((envelope.decomposable, envelope.events, envelope.cell, envelope.time), ("yes", (), None, None))

    def test_curve(self):
        """At t = 1/2 the slices of x = 2 and x = 4 are at y = 1 - t^2 = 3/4, with theta > 0 and < 0; the corners of x = 4 are contacts."""
        envelope = graze.Scene(BLOCK, TURN).envelope()
        parts = envelope.curve(Fraction(1, 2))
        self.assertEqual([(p.kind, str(p.cell), p.a, p.theta_a, p.theta_b) for p in parts],
                         [("slice", "edge 0-3", (2, Fraction(3, 4)), 1, 1), ("slice", "edge 1-2", (4, Fraction(3, 4)), -1, -1),
                          ("point", "vertex 1", (4, -1), None, None), ("point", "vertex 2", (4, 1), None, None)])
        self.assertEqual([p.form for p in parts], [None] * 4)
        self.assertEqual((parts[0].b, parts[0].orientation, parts[0].status), (parts[0].a, "reversing", "trimmed_far"))
        with self.assertRaises(graze.InputError):
            envelope.curve(1)

    def test_patches(self):
        """tests/envelope/joints.py derives them: at the cusp the slice of x = 2 changes the sign of theta."""
        patches, joints = graze.Scene(BLOCK, TURN).envelope().patches()
        self.assertEqual([(p.kind, str(p.cell), p.theta_a) for p in patches],
                         [("slice", "edge 0-3", 1), ("slice", "edge 0-3", -1), ("slice", "edge 1-2", -1), ("point", "vertex 1", None),
                          ("point", "vertex 2", None)])
        joint, = joints
        self.assertEqual((str(joint.cell), joint.patches, joint.form), ("edge 0-3", (0, 1), None))
        self.assertEqual((joint.start, joint.end), (patches[0].end, patches[1].start))
        self.assertEqual((patches[3].start, patches[3].end, patches[3].body, patches[3].a), (0, 1, (4, -1), None))
        site = graze.Scene(BLOCK, TURN).site(patches[0].time, patches[0].body)
        self.assertEqual((site.point, site.status, site.role), (patches[0].point, patches[0].status, "contact"))

    def test_still_patches(self):
        """Bottom and top slide, from corner to corner."""
        patches, joints = graze.Scene(common.SQUARE, common.moved("8*t", "0")).envelope().patches()
        self.assertEqual([p.kind for p in patches], ["whole"] * 2 + ["point"] * 4)
        self.assertEqual(sorted(len(j.patches) for j in joints), [2] * 4)

    def test_unsweep(self):
        with self.assertRaises(graze.UseError):
            graze.Scene(common.SQUARE, common.moved("8*t", "0"), operation="unsweep").envelope()
