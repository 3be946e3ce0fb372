#!/usr/bin/env python3
# suite
"""The JSON Schema of curved solids takes what Graze takes, and refuses what is wrong in form.

The scenes of words.py, the seeds of the fuzz target, and changes of them by one key, item or type are given to both; of the
refusals of tests/refuse/curved.txt those with status 3 are of form, but for the few that are named here.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "lib"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import words  # noqa: E402
from scenes import Checks, options  # noqa: E402

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCHEMA = os.path.join(ROOT, "src", "program", "cli", "csg.schema.json")
# Faults that show only in sums of powers, the number of points, or the text of the file.
UNSEEN = {"powers", "term-twice", "face-without-point"}
VALIDATE = """
import json, sys
import jsonschema
schema = json.load(open(sys.argv[1], encoding="utf-8"))
jsonschema.Draft202012Validator.check_schema(schema)
valid = jsonschema.Draft202012Validator(schema).is_valid
print(json.dumps([valid(solid) for solid in json.load(open(sys.argv[2], encoding="utf-8"))]))
"""


def judged(checks, solids, folder):
    """For each solid whether the schema takes it; None if no interpreter here has jsonschema."""
    path = os.path.join(folder, "solids.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(solids, file)
    for python in (sys.executable, "/usr/bin/python3"):
        done = subprocess.run([python, "-c", VALIDATE, SCHEMA, path], capture_output=True, text=True, timeout=600)
        if done.returncode == 0:
            return json.loads(done.stdout)
        if "No module named 'jsonschema'" not in done.stderr:
            checks.fail(done.stderr[-500:])
    return None


def changes(value):
    """The value with one key or item gone, one key more, or one value of another type."""
    if isinstance(value, dict):
        for key in value:
            yield {k: v for k, v in value.items() if k != key}
            yield {**value, key: None}
            for inner in changes(value[key]):
                yield {**value, key: inner}
        yield {**value, "unknown": 1}
    elif isinstance(value, list):
        yield value[:-1]
        yield value + value[:1]
        for k, item in enumerate(value[:2]):
            for inner in changes(item):
                yield value[:k] + [inner] + value[k + 1:]
    else:
        yield [value]


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    solids = {f"words: {name}": {"dimension": motion.dimension, "solid": node} for name, node, motion, *_ in words.SCENES}
    for folder in (("tests", "fuzz", "corpus", "csg"), ("cases", "*")):
        for path in glob.glob(os.path.join(ROOT, *folder, "*.csg.json")):
            with open(path, encoding="utf-8") as file:
                solids[os.path.relpath(path, ROOT)] = json.load(file)
    good = dict(solids)
    for name in sorted(good)[::9]:
        for k, changed in enumerate(changes(good[name])):
            solids[f"{name}, change {k}"] = copy.deepcopy(changed)
    with open(os.path.join(ROOT, "tests", "refuse", "curved.txt"), encoding="utf-8") as file:
        for case in re.split(r"^=== curved-", file.read(), flags=re.M)[1:]:
            body = re.search(r"^--- s\.csg\.json\n(.*)$", case, re.M)
            if body and "\nexit: 3\n" in case and "graze check" in case and case.split("\n")[0] not in UNSEEN:
                solids["refusal: " + case.split("\n")[0]] = json.loads(body[1])
    solids = dict(args.once(solids.items()))
    with tempfile.TemporaryDirectory() as folder:
        valid = judged(checks, list(solids.values()), folder)
        if valid is None:
            checks.skip("schema", "no jsonschema", 400)
            checks.finish()
        moves = {}
        for d in (2, 3):
            moves[d] = os.path.join(ROOT, "tests", "refuse", "common", f"move{d}.json")
        path = os.path.join(folder, "solid.csg.json")
        for (name, solid), taken in zip(solids.items(), valid):
            with open(path, "w", encoding="utf-8") as file:
                json.dump(solid, file)
            d = solid.get("dimension") if isinstance(solid, dict) else None
            done = subprocess.run([args.graze, "check", path, moves[2 if d == 2 else 3]], capture_output=True, text=True,
                                  timeout=60)
            # Status 1 is of geometry: the form is right.
            checks.equal(done.returncode in (0, 1), taken, name, json.dumps(solid)[:300], done.stderr[-200:])
    checks.finish()


if __name__ == "__main__":
    main()
