"""The module and the program give the same answers: tables, JSON Lines, generated points, words.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import random
import re
import unittest
from fractions import Fraction as F

import common
import graze

# A case, further options of the program, and the same for the module.
WAYS = [("bracket", [], {}), ("bracket", ["--round", "binary32"], {"round": "binary32"}),
        ("gear", ["--folds", "combined"], {"folds": "combined"}), ("figure2-curves-2d", [], {}),
        ("unsweep-figure11a", ["--operation", "unsweep"], {"operation": "unsweep"}),
        ("family-orders-irrational", [], {})]


def scene_of(name, options):
    solid, motion, points, _ = common.case(name)
    return solid, motion, points, graze.Scene(solid, motion, **options)


def time_as_json(time):
    if isinstance(time, F):
        return str(time)
    low, high = time.interval
    return {"poly": list(map(str, time.coefficients)), "lo": str(low), "hi": str(high),
            "approx": time.decimal(17)}


def cell_as_json(cell):
    return {cell.kind: list(cell.indices) if cell.kind == "edge" else cell.indices[0]}


def trace_as_json(trace, unsweep):
    """The members of a row of JSON Lines, made of a trace."""
    verdict = trace.verdict
    out = {"point": list(map(str, trace.point)), "pmc": verdict.pmc.name.lower()}
    if not unsweep:
        out.update({"class": verdict.class_.name.lower(), "definition": verdict.definition or "ext",
                    "case": verdict.case, "i": verdict.i, "t": verdict.t})
    out["word"] = trace.word
    out["contacts"] = [{"kind": c.kind, "left": c.left, "right": c.right, "from": time_as_json(c.start),
                        "to": time_as_json(c.end), "features": list(map(cell_as_json, c.cells))}
                       for c in trace.contacts]
    return out


def csv_of(points):
    return "".join(",".join(map(str, point)) + "\n" for point in points)


class SameAnswers(unittest.TestCase):
    def test_tables(self):
        """Scene.table is what `graze classify --coordinates exact` prints, byte for byte, with any number of threads."""
        for name, flags, options in WAYS:
            with self.subTest(case=name, options=flags):
                solid, motion, points, scene = scene_of(name, options)
                given = [sample.point for sample in scene.generate(300 * common.SCALE, common.SEED)]
                given += [common.coordinates(row) for row in common.read_rows(points)]
                want = common.program("classify", "--coordinates", "exact", *flags, solid, motion, "-", text=csv_of(given))
                self.assertEqual(scene.table(given), want)
                self.assertEqual(scene.table(given, jobs=3), want)
        fanned = graze.Scene(solid, motion, triangulate=True)
        self.assertEqual(fanned.table([]), common.program("classify", "--coordinates", "exact", "--triangulate", solid, motion, "-",
                                                          text=""))

    def test_traces_and_rows_as_json(self):
        times = 0
        for name, flags, options in WAYS:
            solid, motion, points, scene = scene_of(name, options)
            given = [common.coordinates(row) for row in common.read_rows(points)]
            given += [sample.point for sample in scene.generate(60 * common.SCALE, common.SEED)]
            text = common.program("classify", *flags, "--format", "jsonl", solid, motion, "-",
                                  text=csv_of(given))
            lines = [line for line in text.splitlines() if not line.startswith("#")]
            self.assertEqual([json.loads(row) for row in scene.rows(given, "jsonl")],
                             [json.loads(line) for line in lines if "point" in json.loads(line)], name)
            for point, row in zip(given, scene.rows(given, "jsonl")):
                with self.subTest(case=name, options=flags, point=point):
                    trace = scene.trace(point)
                    want = json.loads(row)
                    for made in (want, built := trace_as_json(trace, scene.operation == "unsweep")):
                        made["definition"] = str(made.get("definition"))
                    self.assertEqual({key: built.get(key) for key in want if key in built}, want)
                    times += sum(isinstance(c.start, graze.AlgebraicNumber) for c in trace.contacts)
        self.assertGreater(times, 20, "irrational times occur")

    def test_classify_and_rows(self):
        """classify, by doubles and by rationals, with and without the filter, says what rows say."""
        for name, _, options in WAYS:
            solid, motion, _, scene = scene_of(name, options)
            exact = graze.Scene(solid, motion, use_filter=False, **options)
            given = [sample.point for sample in
                     scene.generate(400 * common.SCALE, common.SEED, representable=True)]
            rows = scene.rows(given)
            floats = [list(map(float, point)) for point in given]
            ways = [scene.classify(given), scene.classify(floats), scene.classify(floats, jobs=2),
                    exact.classify(floats)]
            if common.numpy is not None:
                ways.append(scene.classify(common.numpy.array(floats), jobs=None))
            for verdicts in ways:
                columns = graze.columns(verdicts)
                for k, row in enumerate(rows):
                    fields = row.split(",")[scene.dimension:]
                    with self.subTest(case=name, row=row):
                        self.assertEqual(columns["pmc"][k], fields[0])
                        if scene.operation == "sweep":
                            self.assertEqual([columns["class"][k], columns["definition"][k],
                                              str(columns["case"][k]), str(columns["i"][k]),
                                              str(columns["t"][k])], fields[1:6])

    def test_explanations(self):
        solid, motion, points, scene = scene_of("bracket", {})
        for row in common.read_rows(points)[:8]:
            point = common.coordinates(row)
            self.assertEqual(scene.explain(point), common.program("explain", solid, motion, "--", *point)
                             if any(c.startswith("-") for c in point)
                             else common.program("explain", solid, motion, *point))

    def test_generated_points(self):
        """Points, strata and contact times are those of `graze generate`."""
        rng = random.Random(common.SEED)
        for name in ("bracket", "figure2-curves-2d"):
            solid, motion, _, scene = scene_of(name, {})
            seed = rng.randrange(1000)
            text = common.program("generate", solid, motion, "-n", "200", "--seed", str(seed))
            lines = [line for line in text.splitlines() if not line.startswith("#")]
            header, rows = lines[0].split(","), [line.split(",") for line in lines[1:]]
            samples = list(scene.generate(200, seed))
            self.assertEqual(len(rows), 200)
            for row, sample in zip(rows, samples):
                fields = dict(zip(header, row))
                self.assertEqual([fields[c] for c in "xyz"[:scene.dimension]], list(map(str, sample.point)))
                order = {-1: "slide", 0: ""}.get(sample.order, str(sample.order))
                side = ("out" if sample.outward else "in") if sample.k else ""
                self.assertEqual([fields[c] for c in ("stratum", "order", "cell", "time", "k", "side")],
                                 [sample.stratum, order, str(sample.cell or ""),
                                  "" if sample.time is None else str(sample.time), str(sample.k or ""),
                                  side])
            self.assertEqual(list(scene.generate(50, seed, first=150)), samples[150:])
            for sample in scene.generate(20, seed, {"rounded": 1}, representable=True):
                self.assertTrue(sample.stratum.startswith("rounded-") and all(F(float(x)) == x for x in sample.point), sample)
                self.assertEqual(scene.trace(sample.point).verdict.pmc, sample.pmc)
            only = {sample.stratum for sample in scene.generate(40, seed, {"vertex": 3, "random": 1})}
            self.assertEqual(only, {"vertex", "random"})
            for refused in ({"corner": 1}, {"vertex": 0}, {"vertex": -1}):
                with self.assertRaises(graze.UseError):
                    scene.generate(1, 1, refused)

    def test_version(self):
        self.assertTrue(re.match(re.escape(graze.version()), common.program("--version")))
