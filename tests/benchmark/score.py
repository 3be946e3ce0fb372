#!/usr/bin/env python3
"""Scores of the benchmark: cases/benchmark/score.py on golden tables made by hand, and on meshes of a box.

SPDX-License-Identifier: GPL-3.0-or-later

*Levels.* The diagonal is 1024, so that the thresholds 0, 2^-40, 1e-6 and 1e-3 of it are 0, 2^-30, 0.001024 and 1.024. ROWS has with each bound
of the distance how many of them it reaches; one wrong answer must be counted at these and no others.
*Meshes.* [0, 2]^3 along x by 8 sweeps [0, 10] x [0, 2]^2. Which points a box holds is read off their coordinates.
"""
import csv
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import ROOT, Checks, options, run  # noqa: E402

SCORE = os.path.join(ROOT, "cases", "benchmark", "score.py")
WITHIN = "0.25"  # width of the distances of meshes
LEVELS = ("0", "2^-40", "1e-6", "1e-3")
# pmc, boundary_low, and how many of LEVELS it reaches
ROWS = [("in", "0", 1), ("in", repr(2.0 ** -31), 1), ("in", repr(2.0 ** -30), 2), ("in", "0.0010239", 2), ("in", "0.0010241", 3),
        ("in", "0.5", 3), ("in", "1.0239", 3), ("in", "1.0241", 4), ("in", "1024", 4),
        ("out", "0", 1), ("out", "1e-8", 2), ("out", "0.75", 3), ("out", "2", 4), ("on", "0", 0), ("on", "0", 0), ("on", "0", 0)]
IN, OUT, ON = 9, 4, 3
REACHED = {"in": (9, 7, 5, 2), "out": (4, 3, 2, 1)}  # rows of ROWS at each level
# The deviation of 101 poses is that of a row, which is then not scored: what is at most 0.5 is covered.
SCENE = {"name": "made", "family": "parts", "count": len(ROWS), "seed": 1, "straight": True, "diagonal": 1024.0,
         "poses": {"101": {"deviation": 0.5}, "1001": {"deviation": 0}, "11": {"deviation": 1024}}}
COVERED = {"in": 6, "out": 2}


def distance(pmc, bound):
    """The signed distance's enclosure of a row: [b, b + 1/2] outside, [-b - 1/2, -b] inside, 0."""
    bound = float(bound)
    return {"in": (-bound - 0.5, -bound), "out": (bound, bound + 0.5), "on": (0.0, 0.0)}[pmc]


def golden_text():
    lines = ["# graze", "x,y,z,pmc,id,sdf_low,sdf_high,boundary_low"]
    for k, (pmc, bound, _) in enumerate(ROWS, 1):
        low, high = distance(pmc, bound)
        lines.append(f"{k},{-k / 4},0.5,{pmc},{k},{low!r},{high!r},{bound}")
    return "\n".join([*lines, f"# complete {len(ROWS)}", ""])


def by_id(answers, first="id,pmc"):
    return "\n".join([first, *(f"{k},{answer}" for k, answer in enumerate(answers, 1)), ""])


TRUTH = [pmc for pmc, _, _ in ROWS]


class Scores:
    """Runs of score.py in a folder of their own."""

    def __init__(self, checks, folder, graze):
        self.checks, self.folder, self.graze = checks, folder, graze
        self.scene = os.path.join(folder, "made")
        os.mkdir(self.scene)
        self.write("made/golden.csv", golden_text())
        self.write("made/scene.json", json.dumps(SCENE))

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())
        return path

    def call(self, *words):
        return run([sys.executable, SCORE, "--graze", self.graze, *words])

    def ask_all(self, texts, *flags, scene=None):
        """The scores of tables, one line each."""
        paths = [self.write(f"candidate-{k}.csv", text) for k, text in enumerate(texts)]
        done = self.call(scene or self.scene, *paths, *flags)
        self.checks.equal((done.returncode, done.stderr, done.stdout.count("\n")), (0, "", len(texts)), "one line each")
        return [json.loads(line) for line in done.stdout.splitlines()]

    def ask(self, text, *flags, scene=None):
        return self.ask_all([text], *flags, scene=scene)[0]

    def counts(self, name, score, wrong, points=None):
        """Points and wrong ones at each level, `in` and `out`."""
        for k, level in enumerate(LEVELS):
            for pmc in ("in", "out"):
                want = {"points": (points or REACHED)[pmc][k], "wrong": wrong[pmc][k]}
                self.checks.equal(score["levels"][level][pmc], want, name, level, pmc)


NONE = {"in": (0, 0, 0, 0), "out": (0, 0, 0, 0)}


def check_levels(scores, checks):
    """All right, and the same answer everywhere."""
    own = scores.ask(golden_text())
    scores.counts("Graze's table", own, NONE)
    checks.equal([own["levels"][level]["balanced"] for level in LEVELS], [0] * 4, "Graze's table, balanced")
    checks.equal(own["on"], {"points": ON, "in": 0, "on": ON, "out": 0, "none": 0}, "Graze's table, on")
    checks.equal([own[key] for key in ("missing", "extra", "unreadable", "problems", "sdf", "judge")], [0, 0, 0, [], None, None], "Graze's table")
    everywhere = [("out", (1, 0)), ("in", (0, 1)), ("on", (1, 1))]
    found = scores.ask_all([by_id([answer] * len(ROWS)) for answer, _ in everywhere])
    for (answer, rates), same in zip(everywhere, found):
        scores.counts(answer, same, {pmc: tuple(n * rate for n in REACHED[pmc]) for pmc, rate in zip(("in", "out"), rates)})
        checks.equal([same["levels"][level]["balanced"] for level in LEVELS], [sum(rates) / 2] * 4, answer, "everywhere")
        checks.equal(same["on"], {"points": ON, "in": 0, "on": 0, "out": 0, "none": 0} | {answer: ON}, answer, "on")


def check_one_wrong(scores, checks):
    """One wrong answer counts at the levels that its distance reaches."""
    changes = [(k, other) for k, pmc in enumerate(TRUTH) for other in ("in", "on", "out") if other != pmc]
    found = scores.ask_all([by_id([*TRUTH[:k], other, *TRUTH[k + 1:]]) for k, other in changes])
    for (k, other), one in zip(changes, found):
        pmc, _, reached = ROWS[k]
        wrong = tuple(int(level < reached) for level in range(4))
        scores.counts(f"row {k + 1} is {other}", one, NONE if pmc == "on" else NONE | {pmc: wrong})
        checks.equal(sum(part["wrong"] for part in one["decades"]), int(pmc != "on"), k, other, "decades")
        checks.equal([one["on"]["on"], one["on"][other if pmc == "on" else "on"]], [ON - 1, 1] if pmc == "on" else [ON, ON], k, other, "on")


def check_decades(scores, checks):
    """Distances over 1024: 0 twice, 4.5e-13 and 9.1e-13; 9.8e-12; 9.999e-7; 1.0001e-6; 4.9e-4, 9.999e-4 and 7.3e-4;
    1.0001e-3 and 2e-3; 1."""
    parts = scores.ask(golden_text())["decades"]
    checks.equal({part["from"]: part["points"] for part in parts if part["points"]},
                 {None: 4, 1e-12: 1, 1e-7: 1, 1e-6: 1, 1e-4: 3, 1e-3: 2, 1.0: 1}, "decades")


def check_deviation(scores, checks):
    """Poses with a deviation of 1/2 leave nine rows, at the distances 1.0239, 1.0241, 1024; 0.75, 2. Poses with one
    of 1024 leave none."""
    left = {"in": (3, 3, 3, 2), "out": (2, 2, 2, 1)}
    wrong = by_id(["out" if pmc == "in" else "in" for pmc in TRUTH])
    found = scores.ask(wrong, "--poses", "101")
    scores.counts("101 poses", found, left, left)
    checks.equal([found[key] for key in ("poses", "deviation", "not_scored")], ["101", 0.5, sum(COVERED.values())], "101 poses")
    checks.equal(found["on"]["in"], ON, "101 poses, on")
    none = scores.ask(wrong, "--poses", "11")
    scores.counts("11 poses", none, NONE, NONE)
    checks.equal((none["levels"]["0"]["balanced"], none["not_scored"]), (None, IN + OUT), "11 poses")
    exact = scores.ask(wrong, "--poses", "1001")
    scores.counts("1001 poses that are exact", exact, REACHED)
    checks.equal(exact["not_scored"], 0, "1001 poses that are exact")


def check_rows(scores, checks):
    """Rows that are missing, too many or no answers are errors, and named."""
    lines = by_id(TRUTH).splitlines()
    gone = scores.ask("\n".join(lines[:1] + lines[3:]))  # ids 1 and 2 are `in` and reach one level
    scores.counts("missing", gone, NONE | {"in": (2, 0, 0, 0)})
    checks.equal((gone["missing"], gone["problems"]), (2, ["id 1 is missing", "id 2 is missing"]), "missing")
    more = scores.ask("\n".join([*lines, "77,in", "9,in", "1_0,in"]))
    scores.counts("extra", more, NONE | {"in": (1, 1, 1, 1)})  # id 9 twice: not answered
    checks.equal((more["extra"], more["missing"]), (3, 0), "extra")
    checks.equal(more["problems"], ["row 17: 77 is no golden point", "row 18: 9 is answered twice", "row 19: 1_0 is no golden point"], "extra")
    words = ["IN", "", "1", "inside", "nan"]
    odd = scores.ask(by_id([*words, *TRUTH[5:]]))
    scores.counts("unreadable", odd, NONE | {"in": (5, 3, 1, 0)})
    checks.equal((odd["unreadable"], odd["missing"], len(odd["problems"])), (5, 0, 5), "unreadable")
    for word, problem in zip(words, odd["problems"]):
        checks.holds(f"'{word}'" in problem, word, problem)
    none = scores.ask("id,pmc\n")
    scores.counts("empty", none, REACHED)
    checks.equal((none["missing"], none["on"]["none"], len(none["problems"])), (len(ROWS), ON, 5), "empty")
    short = scores.ask("\n".join([lines[0], "1", *lines[2:]]))
    checks.equal((short["unreadable"], short["levels"]["0"]["in"]["wrong"]), (1, 1), "a row that ends early")


def check_matching(scores, checks):
    """Rows match by id as a number, in any order; where there is no id, by the doubles of the coordinates."""
    turned = [f"{k}.0,{pmc}" for k, pmc in enumerate(TRUTH, 1)][::-1]
    printed = [f"{k:.3e},{pmc}" for k, pmc in enumerate(TRUTH, 1)]
    by_point = [f"{k}e0,{-k / 4:.17g},5e-1,{pmc}" for k, pmc in enumerate(TRUTH, 1)][::-1]
    texts = ["\n".join(["# head", " id, pmc", *turned]), "\n".join(["\ufeffid,pmc", *printed]), "\r\n".join(["x,y,z,pmc", *by_point])]
    for k, found in enumerate(scores.ask_all(texts)):
        scores.counts(f"matching {k}", found, NONE)
        checks.equal((found["missing"], found["extra"], found["on"]["on"]), (0, 0, ON), "matching", k)
    moved = scores.ask("\n".join(["x,y,z,pmc", "1,-0.25,0.5000001,in", *by_point[:-1]]))
    checks.equal((moved["missing"], moved["extra"], moved["levels"]["0"]["in"]["wrong"]), (1, 1, 1), "another point")


def check_distances(scores, checks):
    """Values against [sdf_low, sdf_high]: id 9 is `in` with [-1024.5, -1024], id 13 `out` with [2, 2.5]."""
    inside = [sum(distance(pmc, bound)) / 2 for pmc, bound, _ in ROWS]
    far = [*inside[:8], -1020.0, *inside[9:12], -5.0, *inside[13:]]
    texts = [by_id(values, "id,sdf") for values in (inside, far, ["inf", "nan", *inside[2:]])]
    right, wrong, none = scores.ask_all(texts)
    exact = {"none": 0, "greatest_miss": 0, "over": 0, "greatest_over": 0}
    checks.equal(right["sdf"], {"all": {"points": 16} | exact, "out": {"points": 4} | exact}, "middles")
    scores.counts("middles", right, NONE)
    checks.equal(wrong["sdf"], {"all": {"points": 16, "none": 0, "greatest_miss": 7.0, "over": 1, "greatest_over": 4.0},
                                "out": {"points": 4, "none": 0, "greatest_miss": 7.0, "over": 0, "greatest_over": 0}}, "misses")
    scores.counts("a wrong sign", wrong, NONE | {"out": (1, 1, 1, 1)})
    checks.equal((none["sdf"]["all"]["none"], none["unreadable"]), (2, 2), "no numbers")
    near = scores.ask(texts[1], "--poses", "101")["sdf"]["all"]  # the enclosures are wider by 1/2
    checks.equal((near["greatest_miss"], near["greatest_over"]), (6.5, 3.5), "misses beside the deviation")
    both = scores.ask(by_id([f"{pmc},{value}" for pmc, value in zip(TRUTH, far)], "id,pmc,sdf"))
    scores.counts("pmc beside sdf", both, NONE)
    checks.equal(both["sdf"], wrong["sdf"], "pmc beside sdf")


def check_bad_input(scores, checks):
    """Status 3 and the file's name; 2 for wrong usage."""
    good = scores.write("good.csv", by_id(TRUTH))
    cases = [("id,answer\n1,in\n", "columns id,answer; expected id or x,y,z, and pmc or sdf"), ("x,y,pmc\n", "expected id or x,y,z"),
             ("", "columns none"), ("id,pmc,pmc\n", "two columns pmc"), (b"id,pmc\n1,\xff\n", "byte 9 is not UTF-8")]
    for text, said in cases:
        done = scores.call(scores.scene, scores.write("bad.csv", text))
        checks.holds(done.returncode == 3 and "bad.csv: " in done.stderr and said in done.stderr and not done.stdout, text, done)
    done = scores.call(scores.scene, os.path.join(scores.folder, "none.csv"))
    checks.holds(done.returncode == 3 and "none.csv: No such file" in done.stderr, done)
    done = scores.call(scores.scene, good, "--poses", "7")
    checks.holds(done.returncode == 3 and "no 7 poses; expected one of 101, 1001, 11" in done.stderr, done)
    folder = os.path.join(scores.folder, "broken")
    os.mkdir(folder)
    files = [("golden.csv", "x,y,z,pmc\n1,2,3,in\n", "no column id"), ("golden.csv", golden_text().replace("in,1,", "in,one,"), "id one: expected numbers"),
             ("golden.csv", golden_text().replace("in,1,", "maybe,1,"), "id 1: expected numbers"), ("golden.csv", golden_text().splitlines()[1], "no rows"),
             ("golden.csv", golden_text().replace("in,2,", "in,1,"), "two of one id"), ("golden.csv", golden_text().replace("2,-0.5,", "1,-0.25,"), "or point"),
             ("golden.csv", golden_text().replace(",0\n", ",-1\n"), "id 1: expected numbers"),
             ("scene.json", "{}", "KeyError 'name'"), ("scene.json", "[", "expected name, family"),
             ("scene.json", json.dumps(SCENE | {"diagonal": 0}), "out of range"), ("scene.json", json.dumps(SCENE | {"family": "odd"}), "expected a family")]
    for name, text, said in files:
        scores.write("broken/scene.json", json.dumps(SCENE))
        scores.write("broken/golden.csv", golden_text())
        path = scores.write("broken/" + name, text)
        done = scores.call(folder, good)
        checks.holds(done.returncode == 3 and f"{path}: " in done.stderr and said in done.stderr, name, text[:80], said, done)
    for words in ([], [scores.scene], ["--poses"], ["--format", "csv", scores.scene, good]):
        checks.equal(scores.call(*words).returncode, 2, "usage", *words)


def check_table(scores, checks):
    """Two scenes of a family are pooled: 3 of 9 + 9 `in` and 0 of 8 `out` wrong are 8.33 %; a row for each setting."""
    wrong = scores.ask(by_id(["out"] * 3 + TRUTH[3:]))
    right = scores.ask(golden_text())
    lines = [json.dumps(score | {"code": "a", "setting": setting, "seconds": 1.5} | more) for score, setting, more in
             ((wrong, "cheap", {}), (right, "cheap", {}), (wrong, "dear", {}), (wrong, "cheap", {"family": "large", "missing": 4, "unreadable": 1}))]
    done = scores.call("--table", scores.write("one.jsonl", "\n".join(lines[:2])), scores.write("two.jsonl", "\n".join(lines[2:]) + "\n"))
    checks.equal(done.returncode, 0, done.stderr)
    rows = [line for line in done.stdout.splitlines() if line.startswith(("**", "| a"))]
    # At 2^-40 one of the three wrong rows counts: 1 of 14 and 1 of 7 in, halved.
    checks.equal(rows, ["**parts**", "| a | cheap | 2 | 8.33 % | 3.57 % | 0 | 0 | 0, 6, 0 | 0 | 3 |", "| a | dear | 1 | 16.7 % | 7.14 % | 0 | 0 | 0, 3, 0 | 0 | 2 |",
                        "**large**", "| a | cheap | 1 | 16.7 % | 7.14 % | 0 | 0 | 0, 3, 0 | 5 | 2 |",
                        "**all**", "| a | cheap | 3 | 11.1 % | 4.76 % | 0 | 0 | 0, 9, 0 | 5 | 4 |", "| a | dear | 1 | 16.7 % | 7.14 % | 0 | 0 | 0, 3, 0 | 0 | 2 |"])
    lost = scores.call("--table", scores.write("lost.jsonl", json.dumps(scores.ask(golden_text(), "--poses", "11"))))
    checks.holds("| candidate-0.csv |  | 1 | – | – | – | – | 0, 3, 0 | 0 |  |" in lost.stdout, "no rate", lost.stdout)
    for text in ("{", "[]", "{}"):
        done = scores.call("--table", scores.write("bad.jsonl", text))
        checks.equal((done.returncode, bool(done.stderr)), (3, True), "not a score", text)


def box_text(length, drop=0, turn=False):
    """[0, length] x [0, 2]^2 as OFF, without its last facets; turned inside out if wished."""
    facets = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (0, 4, 7, 3), (1, 2, 6, 5)][:6 - drop]
    corners = [(x, y, z) for z in (0, 2) for x, y in ((0, 0), (length, 0), (length, 2), (0, 2))]
    lines = ["OFF", f"8 {len(facets)} 0", *(" ".join(map(str, c)) for c in corners), *("4 " + " ".join(map(str, f[::-1] if turn else f)) for f in facets)]
    return "\n".join(lines) + "\n"


def inside_box(row, length):
    x, y, z = (float(row[axis]) for axis in "xyz")
    if not (0 <= x <= length and 0 <= y <= 2 and 0 <= z <= 2):
        return "out"
    return "on" if x in (0, length) or y in (0, 2) or z in (0, 2) else "in"


def make_box(scores, checks):
    """The scene whose sweep is a box, by Graze, and its golden rows; their answers are read off the coordinates."""
    names = ("solid.off", "motion.json", "points.csv", "golden.csv")
    os.mkdir(os.path.join(scores.folder, "box"))
    solid, motion, points, golden = (os.path.join(scores.folder, "box", name) for name in names)
    scores.write("box/solid.off", box_text(2))
    scores.write("box/motion.json", '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["8*t", "0", "0"]}}]}')
    scores.write("box/scene.json", json.dumps(SCENE | {"name": "box", "count": 300, "diagonal": 12 ** 0.5}))
    for words in (("generate", solid, motion, "-n", "300", "--seed", "5", "--plain", "--representable", "binary64", "--coordinates", "decimal", "--output", points),
                  ("classify", solid, motion, points, "--sdf", "1e-6r", "--topo", "--boundary-distance", "--output", golden)):
        checks.equal(run([scores.graze, *words]).returncode, 0, *words)
    with open(golden, encoding="ascii") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    checks.equal([row["pmc"] for row in rows], [inside_box(row, 10) for row in rows], "the box")
    return os.path.dirname(golden), rows


def wrong_by_level(rows, said):
    """Points and wrong ones at each level, if the rows get these answers."""
    found = {"in": ([], []), "out": ([], [])}
    for part in (0, 2.0 ** -40, 1e-6, 1e-3):
        for pmc in found:
            chosen = [answer for row, answer in zip(rows, said) if row["pmc"] == pmc and float(row["boundary_low"]) >= part * 12 ** 0.5]
            found[pmc][0].append(len(chosen))
            found[pmc][1].append(len(chosen) - chosen.count(pmc))
    return ({pmc: parts[k] for pmc, parts in found.items()} for k in (0, 1))


def check_meshes(scores, checks):
    """The sweep itself, also inside out; cut off at x = 9, which leaves out all beyond; open."""
    folder, rows = make_box(scores, checks)
    texts = {"exact.off": box_text(10), "turned.off": box_text(10, turn=True), "short.OFF": box_text(9), "open.off": box_text(10, drop=1)}
    done = scores.call(folder, *(scores.write(name, text) for name, text in texts.items()), "--within", WITHIN)
    checks.equal((done.returncode, done.stdout.count("\n")), (0, 4), done.stderr)
    exact, turned, short, without = map(json.loads, done.stdout.splitlines())
    for name, found, said in (("exact", exact, [row["pmc"] for row in rows]), ("turned", turned, [row["pmc"] for row in rows]),
                              ("short", short, [inside_box(row, 9) for row in rows]), ("open", without, [None] * len(rows))):
        points, wrong = wrong_by_level(rows, said)
        scores.counts(name, found, wrong, points)
        on = [answer for row, answer in zip(rows, said) if row["pmc"] == "on"]
        checks.equal(found["on"], {"points": len(on), "none": on.count(None)} | {a: on.count(a) for a in ("in", "on", "out")}, name, "on")
        checks.equal(found["missing"], said.count(None), name, "missing")
    checks.holds(short["levels"]["1e-3"]["in"]["wrong"] > 3 and short["on"]["out"] > 3, "some points are cut off", short)
    checks.equal((without["problems"][0], without["judge"]["mesh"]["rule"]), ("the mesh is not closed, so that nothing is inside", "none"), "open")
    # The face x = 9 is 1 from the outside, in its middle; the corners of x = 10 are 1 from the mesh.
    for key, true in (("mesh_to_sweep_outside", 0), ("mesh_to_sweep_inside", 1), ("sweep_to_mesh", 1)):
        at = short["judge"]["distance"][key]
        checks.holds(at["low"] <= true <= at["high"] and at["high"] - at["low"] <= float(WITHIN), key, at)
        checks.equal(exact["judge"]["distance"][key]["low"], 0, "exact", key)
    done = scores.call(folder, scores.write("none.stl", "solid\n"))
    checks.holds(done.returncode == 3 and "none.stl: graze judge, status" in done.stderr, "no mesh", done)


def main():
    args, checks = options(__doc__), Checks()
    with tempfile.TemporaryDirectory() as folder:
        scores = Scores(checks, folder, args.graze)
        for check in (check_levels, check_one_wrong, check_decades, check_deviation, check_rows, check_matching, check_distances,
                      check_bad_input, check_table, check_meshes):
            check(scores, checks)
    checks.finish()


if __name__ == "__main__":
    main()
