#!/usr/bin/env python3
"""Scores what a code says of a scene of the benchmark: a table of answers, or a mesh.

    python3 cases/benchmark/score.py SCENE CANDIDATE... [--poses 101|1001]
    python3 cases/benchmark/score.py --table FILE...

SCENE is a folder that golden.py has made. CANDIDATE is a CSV table with id, or x, y, z, and pmc or sdf or both, or a
mesh (.off .obj .ply .stl), which `graze judge` asks. Prints one line of JSON for each candidate; README.md defines
what is in it. --table reads such lines and prints Markdown by family. Exit status 3: a file is not what is expected.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import bisect
import json
import os
import subprocess
import sys
import tempfile
from fractions import Fraction as F

from standings import table
from tables import STATUS_BAD_INPUT, BadInput, number, read_scene, read_table, read_text

MESHES = (".off", ".obj", ".ply", ".stl")
ANSWERS = ("in", "on", "out")
LEVELS = {"0": F(0), "2^-40": F(1, 2 ** 40), "1e-6": F(1, 10 ** 6), "1e-3": F(1, 1000)}  # of the diagonal
DECADES = [F(1, 10 ** k) for k in range(12, -1, -1)]
SHOWN = 5  # problems that are told


class Scene:
    """Golden rows by id and by point."""

    def __init__(self, folder):
        self.folder, self.facts = folder, read_scene(folder)
        path = os.path.join(folder, "golden.csv")
        names, rows = read_table(path)
        lacking = [name for name in ("id", "x", "y", "z", "pmc", "sdf_low", "sdf_high", "boundary_low") if name not in names]
        if lacking:
            raise BadInput(f"{path}: no column {lacking[0]}; expected a table of golden.py")
        self.rows = [Golden(path, row) for row in rows]
        self.by_id = {number(row.id): k for k, row in enumerate(self.rows)}
        self.by_point = {row.point: k for k, row in enumerate(self.rows)}
        if not self.rows or len(self.by_id) != len(self.rows) or len(self.by_point) != len(self.rows):
            raise BadInput(f"{path}: no rows, or two of one id or point")

    def deviation(self, poses):
        """How far the poses are from the motion, at most; 0 for a code that reads the motion."""
        if not poses:
            return F(0)
        if poses not in self.facts["poses"]:
            raise BadInput(f"{self.folder}: no {poses} poses; expected one of {', '.join(self.facts['poses'])}")
        return F(self.facts["poses"][poses]["deviation"])


class Golden:
    """A golden row: its answer, a lower bound of its distance to the boundary of the sweep, its signed distance."""

    def __init__(self, path, row):
        self.id, self.pmc = row["id"], row["pmc"]
        self.point = tuple(number(row[axis]) for axis in "xyz")
        bounds = [number(row[name]) for name in ("sdf_low", "sdf_high", "boundary_low")]
        if self.pmc not in ANSWERS or None in (*bounds, *self.point, number(self.id)) or bounds[2] < 0:
            raise BadInput(f"{path}: id {self.id}: expected numbers and an answer of {', '.join(ANSWERS)}")
        self.low, self.high, self.boundary = map(F, bounds)


class Answers:
    """What a candidate says of each golden row: pmc, or None; sdf, or None; and what is wrong with its rows."""

    def __init__(self, scene):
        self.pmc, self.sdf = [None] * len(scene.rows), [None] * len(scene.rows)
        self.answered = [False] * len(scene.rows)
        self.extra = self.unreadable = 0
        self.has_sdf, self.problems = False, []

    def complain(self, text):
        if len(self.problems) < SHOWN:
            self.problems.append(text)

    def refuse(self, place, text):
        """A row too many; a point that is answered twice is not answered."""
        self.extra += 1
        self.complain(text)
        if place is not None:
            self.pmc[place] = self.sdf[place] = None

    def missing(self, scene):
        """The number of golden rows without one of the candidate, which are named."""
        rows = [row for row, there in zip(scene.rows, self.answered) if not there]
        for row in rows[:SHOWN]:
            self.complain(f"id {row.id} is missing")
        return len(rows)


def sign(value):
    return "in" if value < 0 else "out" if value > 0 else "on"


def read_answers(scene, path):
    """The rows of a table, by id or else by coordinates, in any order."""
    names, rows = read_table(path)
    points = "id" not in names
    if (points and not set("xyz") <= set(names)) or not {"pmc", "sdf"} & set(names):
        raise BadInput(f"{path}: columns {','.join(names) or 'none'}; expected id or x,y,z, and pmc or sdf")
    found = Answers(scene)
    found.has_sdf = "sdf" in names
    for count, row in enumerate(rows, 1):
        row = {name.strip(): (text or "").strip() for name, text in row.items() if isinstance(name, str) and not isinstance(text, list)}
        spelt = ",".join(row[axis] for axis in "xyz") if points else row["id"]
        place = scene.by_point.get(tuple(number(row[axis]) for axis in "xyz")) if points else scene.by_id.get(number(row["id"]))
        if place is None or found.answered[place]:
            found.refuse(place, f"row {count}: {spelt} is {'no golden point' if place is None else 'answered twice'}")
            continue
        found.answered[place] = True
        value = number(row.get("sdf"))
        found.sdf[place] = None if value is None else F(value)
        answer = row["pmc"] if "pmc" in names else sign(value) if value is not None else row["sdf"]
        if answer in ANSWERS:
            found.pmc[place] = answer
        else:
            found.unreadable += 1
            found.complain(f"row {count}: {spelt} is '{answer}'; expected in, on or out, or a finite number")
    return found


def judge(scene, path, options, *more):
    """What `graze judge` prints of a mesh."""
    files = [os.path.join(scene.folder, name) for name in ("solid.off", "motion.json")]
    done = subprocess.run([options.graze, "judge", *files, path, "--format", "json", *more], check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise BadInput(f"{path}: graze judge, status {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def ask_mesh(scene, path, options):
    """What a mesh says of the golden points, and its facts, distances and volumes."""
    with tempfile.TemporaryDirectory() as folder:
        answers = os.path.join(folder, "answers.csv")
        bounds = "--within", options.within, "--budget", str(options.budget)
        try:
            report = judge(scene, path, options, "--points", os.path.join(scene.folder, "points.csv"), "--answers", answers, *bounds)
            found = read_answers(scene, answers)
        except BadInput as refused:
            if "is not closed and has no answers" not in str(refused):
                raise
            report, found = judge(scene, path, options, "--no-points", *bounds), Answers(scene)
            found.complain("the mesh is not closed, so that nothing is inside")
    return found, {key: report[key] for key in ("mesh", "distance", "volume", "budget")}


def tally(scene, answers, chosen):
    """Points and wrong ones among the golden rows that are chosen, `in` and `out` apart, and the mean of both rates."""
    found = {pmc: {"points": 0, "wrong": 0} for pmc in ("in", "out")}
    for row, answer in zip(scene.rows, answers.pmc):
        if row.pmc != "on" and chosen(row):
            found[row.pmc]["points"] += 1
            found[row.pmc]["wrong"] += answer != row.pmc
    return found | {"balanced": balanced(found)}


def balanced(found):
    """The mean of the rates among `in` and `out` points; None where there are none of either."""
    parts = [found["in"], found["out"]]
    return sum(part["wrong"] / part["points"] for part in parts) / 2 if all(part["points"] for part in parts) else None


def decades(scene, answers, scored):
    """Points and wrong ones by the power of ten of their distance, of the diagonal; `from` is null below the least."""
    parts = [{"from": None if k == 0 else float(DECADES[k - 1]), "points": 0, "wrong": 0} for k in range(len(DECADES) + 1)]
    for row, answer in zip(scene.rows, answers.pmc):
        if row.pmc != "on" and scored(row):
            part = parts[bisect.bisect_right(DECADES, row.boundary / F(scene.facts["diagonal"]))]
            part["points"] += 1
            part["wrong"] += answer != row.pmc
    return parts


def tally_on(scene, answers):
    """What `on` points were called: errors under every convention at once."""
    said = [answer for row, answer in zip(scene.rows, answers.pmc) if row.pmc == "on"]
    return {"points": len(said)} | {answer or "none": said.count(answer) for answer in (*ANSWERS, None)}


def miss(row, value, deviation):
    """How far a value misses [sdf_low, sdf_high], widened by the deviation; above 0 if it is too large."""
    return max(F(0), value - row.high - deviation) or min(F(0), value - row.low + deviation)


def tally_sdf(scene, answers, deviation, chosen):
    """The greatest miss of the enclosures, and overestimates, among the rows that are chosen."""
    rows = [(row, value) for row, value in zip(scene.rows, answers.sdf) if chosen(row)]
    misses = [miss(row, value, deviation) for row, value in rows if value is not None]
    over = [m for m in misses if m > 0]
    return {"points": len(rows), "none": len(rows) - len(misses), "greatest_miss": float(max(map(abs, misses), default=0)),
            "over": len(over), "greatest_over": float(max(over, default=0))}


def score(scene, path, options):
    """The score of one candidate, as README.md defines it."""
    deviation, judged = scene.deviation(options.poses), None
    if path.lower().endswith(MESHES):
        answers, judged = ask_mesh(scene, path, options)
    else:
        answers = read_answers(scene, path)
    missing = answers.missing(scene)

    def scored(row):
        return not deviation or row.boundary > deviation

    levels = {name: tally(scene, answers, lambda row, d=part * F(scene.facts["diagonal"]): scored(row) and row.boundary >= d)
              for name, part in LEVELS.items()}
    sdf = {name: tally_sdf(scene, answers, deviation, lambda row, name=name: name in ("all", row.pmc)) for name in ("all", "out")}
    return {"scene": scene.facts["name"], "family": scene.facts["family"], "candidate": os.path.basename(path),
            "poses": options.poses, "deviation": float(deviation), "points": len(scene.rows),
            "missing": missing, "extra": answers.extra, "unreadable": answers.unreadable, "problems": answers.problems,
            "not_scored": sum(row.pmc != "on" and not scored(row) for row in scene.rows),
            "levels": levels, "decades": decades(scene, answers, scored), "on": tally_on(scene, answers),
            "sdf": sdf if answers.has_sdf else None, "judge": judged}


def read_scores(paths):
    """The lines of files."""
    found = []
    for path in paths:
        try:
            found += [json.loads(line) for line in read_text(path).splitlines() if line.strip()]
        except ValueError as error:
            raise BadInput(f"{path}: {error}; expected lines that score.py prints") from error
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze", help="asks meshes")
    parser.add_argument("--poses", help="the candidate reads poses-POSES.csv: what their deviation covers is not scored")
    parser.add_argument("--within", default="1e-2r", help="of a mesh: width of the distances' bounds")
    parser.add_argument("--budget", type=int, default=10 ** 5, help="of a mesh: cubes and points that are asked about (10^5)")
    parser.add_argument("--format", choices=["json"], default="json", help="of the output: a line a candidate")
    parser.add_argument("--table", action="store_true", help="Markdown of scores in files: all arguments are such")
    parser.add_argument("paths", metavar="SCENE CANDIDATE", nargs="+")
    options = parser.parse_intermixed_args()
    if options.table:
        print(table(read_scores(options.paths)), end="")
        return 0
    if len(options.paths) < 2:
        parser.error("expected a scene's folder and candidates")
    scene = Scene(options.paths[0])
    for path in options.paths[1:]:
        print(json.dumps(score(scene, path, options)), flush=True)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except BadInput as error:
        print(f"score.py: {error}", file=sys.stderr)
        sys.exit(STATUS_BAD_INPUT)
