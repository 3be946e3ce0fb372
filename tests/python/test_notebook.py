"""cases/notebook.py runs, and its picture shows what it printed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import io
import os
import re
import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from xml.etree import ElementTree

import common


class Notebook(unittest.TestCase):
    def test_picture(self):
        """The cells of the SVG, summed by colour, are the counts printed; the names are the legend's."""
        with tempfile.TemporaryDirectory() as folder:
            picture = os.path.join(folder, "picture.svg")
            script = os.path.join(common.ROOT, "cases", "notebook.py")
            done = subprocess.run([sys.executable, script, picture], stdout=subprocess.PIPE, check=True)
            text = done.stdout.decode()
            root = ElementTree.parse(picture).getroot()
        counts = Counter(map(int, re.findall(r"^  [a-z_]+ +(\d+)$", text, re.M)))
        shape = "{http://www.w3.org/2000/svg}"
        widths, colours = Counter(), Counter()
        for rect in root.iter(shape + "rect"):
            if rect.get("shape-rendering"):
                widths[rect.get("fill")] += int(rect.get("width")) // int(rect.get("height"))
            elif rect.get("stroke"):
                colours[rect.get("fill")] += 1
        self.assertEqual(Counter(widths.values()), counts)
        self.assertEqual((len(counts), sum(widths.values())), (5, 177 * 145))
        self.assertEqual(set(colours), set(widths))
        legend = {text.text for text in root.iter(shape + "text")}
        self.assertTrue({"regular", "fold", "fold boundary", "boundary", "exterior"} <= legend)

    def test_known_points(self):
        """Points of the picture's plane whose class is evident (the part's profile is turned about
        the origin by half a circle): at distance 3/4 from the axis nothing passes but the corner at
        distance 1 is touched; (5, 1) is the farthest corner, at the start."""
        import graze
        environment = {}
        path = os.path.join(common.ROOT, "cases", "notebook.py")
        with open(path, encoding="utf-8") as file:
            scene_part = file.read().split("# ## One point")[0]
        with contextlib.redirect_stdout(io.StringIO()):
            exec(compile(scene_part, path, "exec"), environment)
        verdicts = environment["scene"].classify([(0.0, 0.75, 1.0), (0.0, 1.0, 1.0), (5.0, 1.0, 1.0),
                                                  (0.0, 5.125, 1.0), (0.0, 4.5, 1.0)])
        self.assertEqual(graze.class_names(verdicts),
                         ["exterior", "boundary", "boundary", "exterior", "regular"])
