"""Events of envelopes: facts that are derived in tests/envelope/hand.py, and the rows of `graze envelope`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import unittest

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
        event, = [e for e in envelope.events if e.kind == "theta" and e.before and e.after]
        self.assertEqual((str(event.facet), str(event.cell), event.other, event.before, event.after),
                         ("edge 0-3", "edge 0-3", None, 1, -1))
        self.assertEqual(list(event.time.coefficients), [-2, 3, 0, 1])
        self.assertEqual([float(e.time) for e in envelope.events], sorted(float(e.time) for e in envelope.events))
        self.assertIsNone(envelope.events[0].before)

    def test_still(self):
        """A square that moves along its side: nothing ever changes."""
        envelope = graze.Scene(common.SQUARE, common.moved("8*t", "0")).envelope()
        self.assertEqual((envelope.decomposable, envelope.events, envelope.cell, envelope.time), ("yes", (), None, None))

    def test_unsweep(self):
        with self.assertRaises(graze.UseError):
            graze.Scene(common.SQUARE, common.moved("8*t", "0"), operation="unsweep").envelope()
