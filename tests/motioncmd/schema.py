#!/usr/bin/env python3
# suite
"""The JSON Schema of motion files: it takes every motion that Graze takes, and refuses what is wrong in form.

All motions of cases and tests, the examples of formats.md, and changes of them by one key, item or type are given to
both. The refusals of tests/refuse/motion.txt that the schema cannot see are those of expressions and of geometry, and a
few that are named here. SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402

SCHEMA = os.path.join(ROOT, "src", "program", "cli", "motion.schema.json")
# Faults that show only in the values of expressions, or in the text of the file.
UNSEEN = re.compile(r"(expression|order|jump|singular|pole|axis|quaternion|keyframes|relative|sequence)-|json-nan$|key-twice"
                    r"|type-matrix-last-|type-times-is-not-whole$")
checks = Checks()
check = checks.holds
VALIDATE = """
import json, sys
import jsonschema
with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft202012Validator.check_schema(schema)
valid = jsonschema.Draft202012Validator(schema).is_valid
with open(sys.argv[2], encoding="utf-8") as file:
    print(json.dumps([valid(motion) for motion in json.load(file)]))
"""


def judged(motions, folder):
    """Does the schema take each of these? None if no interpreter here has jsonschema."""
    path = os.path.join(folder, "motions.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(motions, file)
    for python in (sys.executable, "/usr/bin/python3"):
        if os.path.exists(python):
            done = subprocess.run([python, "-c", VALIDATE, SCHEMA, path], capture_output=True, text=True, timeout=600)
            if done.returncode == 0:
                return json.loads(done.stdout)
            if "No module named 'jsonschema'" not in done.stderr:
                check(False, done.stderr)
                return None
    return None


def good_motions():
    found = {}
    for pattern in ("cases/**/*.json", "tests/examples/motions/*.json", "tests/refuse/common/*.json"):
        for path in sorted(glob.glob(os.path.join(ROOT, pattern), recursive=True)):
            if path.endswith(".csg.json"):
                continue
            with open(path, encoding="utf-8") as file:
                motion = json.load(file)
            if isinstance(motion, dict) and "dimension" in motion:
                found[os.path.relpath(path, ROOT)] = motion
    with open(os.path.join(ROOT, "src", "program", "cli", "formats.md"), encoding="utf-8") as file:
        for k, block in enumerate(re.findall(r"```json\n(.*?)```", file.read(), re.S)):
            found[f"formats.md, example {k}"] = json.loads(block)
    return found


def refusals():
    """Name -> motion of the cases whose file Python can read too."""
    with open(os.path.join(ROOT, "tests", "refuse", "motion.txt"), encoding="utf-8") as file:
        cases = re.split(r"^=== ", file.read(), flags=re.M)[1:]
    found = {}
    for case in cases:
        body = re.search(r"^--- \S+\.json\n(.*?)(?=^--- |\Z)", case, re.M | re.S)
        try:
            motion = json.loads(body[1]) if body else None
        except ValueError:
            continue
        if body and "exit: 0" not in case:
            found[case.split("\n")[0]] = motion
    return found


def places(value, path=()):
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from places(inner, path + (key,))


def changed(motion, rng):
    """The motion with one place taken away, doubled, renamed or replaced."""
    out = copy.deepcopy(motion)
    *way, last = rng.choice([path for path in places(out) if path])
    inner = out
    for key in way:
        inner = inner[key]
    kind = rng.randrange(4)
    if kind == 0:
        del inner[last]
    elif kind == 1 and isinstance(inner, list):
        inner.append(inner[last])
    elif kind == 1:
        inner[rng.choice(("center", "times", "axis", "t", "other", "position"))] = inner.pop(last)
    else:
        inner[last] = rng.choice((0, "1", "s", "1/2", [], ["0", "0"], ["0", "0", "1"], {}, None, True, 2, " 3 ", "1e1", "1.5"))
    return out


def with_unknown_keys(motion):
    """The motion with a key more, in each of its objects."""
    for path in places(motion):
        out = copy.deepcopy(motion)
        inner = out
        for key in path:
            inner = inner[key]
        if isinstance(inner, dict):
            inner["other"] = "1"
            yield out


def takes(graze, motion, folder):
    path = os.path.join(folder, "motion.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(motion, file)
    return harness.run([graze, "convert", path, "-o", os.path.join(folder, "plain.json")], 60).returncode == 0


def main():
    args = options(__doc__)
    good, bad = good_motions(), refusals()
    check(len(good) > 100 and len(bad) > 100, len(good), len(bad))
    small = [motion for motion in good.values() if len(json.dumps(motion)) < 3000]
    others = [changed(args.random.choice(small), args.random) for _ in args.rounds(400)]
    if not args.derived:
        good, bad = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        odd = [motion for given in small[::7] if args.derived for motion in with_unknown_keys(given)]
        seen = judged([*good.values(), *bad.values(), *others, *odd], folder)
        if seen is None:
            checks.skip("schema", "no interpreter here has jsonschema")
            checks.finish()
        for name, valid in zip(good, seen):
            check(valid, "refused by the schema", name)
        for name, valid in zip(bad, seen[len(good):]):
            check(not valid or UNSEEN.match(name), "taken by the schema", name)
        both = 0
        for motion, valid in zip(others, seen[len(good) + len(bad):]):
            taken = takes(args.graze, motion, folder)
            both += taken
            check(valid or not taken, "refused by the schema alone", json.dumps(motion))
        for motion, valid in zip(odd, seen[len(seen) - len(odd):]):
            check(not valid, "an unknown key is taken", json.dumps(motion))
        check(both > 20 * args.share, "changed motions that Graze takes", both)
    checks.finish()


if __name__ == "__main__":
    main()
