#!/usr/bin/env python3
# suite
"""Candidates in Python: those of cases/candidates with numpy and, in CI, with pandas, and readers that are
off by an ulp, which lose no row.

The sweep of the cube is a box, and open intervals of 1000 positions cover the same open interval, so that the candidates are
right but for `on`, which they never answer.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import shlex
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from harness import Checks, options  # noqa: E402

CANDIDATES = os.path.join(harness.ROOT, "cases", "candidates")
CUBE = os.path.join(harness.ROOT, "tests", "refuse", "common", "cube.off")
MOVE = '{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["8*t", "0", "0"]}}]}'
# Reads floats, answers nothing of its own, and writes them back.
REWRITE = {
    "numpy": "import sys, numpy as np\n"
             "t = np.genfromtxt(sys.argv[1], delimiter=',', names=True, usecols=('x', 'y', 'z', 'id'))\n"
             "np.savetxt(sys.argv[2], np.c_[t['x'], t['y'], t['z'], t['id'], t['id'] * 0 + 1], delimiter=',',\n"
             "           header='x,y,z,id,sdf', comments='')\n",
    "pandas": "import sys, pandas as pd\n"
              "t = pd.read_csv(sys.argv[1])\nt['pmc'] = 'in'\nt[sys.argv[3:]].to_csv(sys.argv[2], index=False)\n"}
checks = Checks()
check = checks.holds


def interpreter(module):
    """An interpreter that has a module of Python, or None."""
    return next((p for p in (sys.executable, "/usr/bin/python3")
                 if os.path.exists(p) and harness.run([p, "-c", f"import {module}"]).returncode == 0), None)


def validate(graze, folder, command, *more):
    """The JSON report on a candidate."""
    motion = os.path.join(folder, "move.json")
    with open(motion, "w", encoding="utf-8") as file:
        file.write(MOVE)
    done = harness.run([graze, "validate", CUBE, motion, "-n", "1500", "--representable", "binary64", "--quiet", "--format",
                        "json", *more, "--candidate", shlex.join(command[:2]) + " {points} {out} " + shlex.join(command[2:])])
    check(done.returncode in (0, 1), command, done.stderr)
    return json.loads(done.stdout) if done.returncode in (0, 1) else {}


def ten_lines(graze, folder, python, module):
    """The candidate of the documentation is right, and its report has both figures."""
    path = os.path.join(CANDIDATES, f"cube_{module}.py")
    made = validate(graze, folder, [python, path], "--on-as", "out")
    told = made.get("comparison", {})
    check(made.get("verdict") == "no difference in 1500 rows; 0 wrong with `on` as any answer", made.get("verdict"))
    check(told.get("matched-by") == "id" and told["wrong-by-convention"]["on"] == sum(told["pmc"]["on"].values()) > 300, told)
    with open(path, encoding="utf-8") as file:
        check(len([line for line in file if line.strip()]) <= 11, path, "ten lines and a head")


def rewritten(graze, folder, python, module, columns, by):
    """All rows keep a counterpart, whatever a reader of floats makes of their points."""
    script = os.path.join(folder, "rewrite.py")
    with open(script, "w", encoding="utf-8") as file:
        file.write(REWRITE[module])
    told = validate(graze, folder, [python, script, *columns],
                    *(["--candidate-has", "sdf"] if module == "numpy" else [])).get("comparison", {})
    check(told.get("rows") == 1500 and told["missing"] == told["extra"] == 0 and told["matched-by"] == by, module, columns, told)
    return told.get("rows-with-other-coordinates")


def facts(graze, folder):
    """The environment of a candidate, and the first lines of its points."""
    said = os.path.join(folder, "said")
    script = f'env | grep ^GRAZE_ | sort >{shlex.quote(said)}; head -n 2 "$1" >>{shlex.quote(said)}; printf "pmc\\n" >"$2"'
    motion = os.path.join(folder, "move.json")
    with open(motion, "w", encoding="utf-8") as file:
        file.write(MOVE)
    command = [graze, "validate", CUBE, motion, "-n", "7", "--seed", "3", "--quiet", "--candidate", shlex.join(["sh", "-c", script, "sh"])
               + " {points} {out}"]
    done = harness.run(command, env={k: v for k, v in os.environ.items() if not k.startswith("GRAZE_")})
    check(done.returncode == 3 and "0 rows, and no columns x, y, z or id" in done.stderr, done.stderr)
    with open(said, encoding="utf-8") as file:
        lines = file.read().splitlines()
    # The box of the sweep of [0, 2]^3 along 8; which of its margins is the stratum's own affair.
    told = dict(line.split("=") for line in lines[:4])
    box = [float(x) for x in told.pop("GRAZE_BOX").split(",")]
    check(told == {"GRAZE_DIMENSION": "3", "GRAZE_ROWS": "7", "GRAZE_SEED": "3"}, told)
    check(all(low <= 0 and high >= size for low, high, size in zip(box[:3], box[3:], (10, 2, 2))), box)
    check(lines[4].startswith("x,y,z,id,stratum,") and lines[5].split(",")[3] == "1", lines[4:])


def early(graze, folder):
    """Where fewer points are found than are asked for, a candidate is told how many there are."""
    said = os.path.join(folder, "count")
    script = f'echo $GRAZE_ROWS >{shlex.quote(said)}; tail -n +2 "$1" | wc -l >>{shlex.quote(said)}; printf "pmc\n" >"$2"'
    harness.run([graze, "validate", CUBE, os.path.join(folder, "move.json"), "-n", "20000", "--strata", "vertex", "--quiet",
                 "--candidate", shlex.join(["sh", "-c", script, "sh"]) + " {points} {out}"])
    with open(said, encoding="utf-8") as file:
        told, rows = map(int, file.read().split())
    check(told == rows < 20000, "GRAZE_ROWS", told, rows)


def missing(graze, folder):
    """Without all rows there is no verdict, and no share of wrong ones."""
    motion = os.path.join(folder, "move.json")
    line = 'echo "id,pmc" >"$2"; tail -n +3 "$1" | head -n 40 | cut -d, -f4 | sed s/$/,in/ >>"$2"'
    out = harness.run([graze, "validate", CUBE, motion, "-n", "50", "--quiet", "--candidate", shlex.join(["sh", "-c", line, "sh"])
                       + " {points} {out}"])
    check(out.returncode == 1 and "\nverdict: none: 10 of 50 rows are missing\n" in out.stdout and "\nwrong:" not in out.stdout
          and "\nmissing: 10 of 50 rows; of the others wrong: " in out.stdout, out.stdout[:700], out.stderr)


def failing(graze, folder):
    """A candidate that fails on ratios is told of decimals; with them the message is the plain one."""
    motion = os.path.join(folder, "move.json")
    for more, hint in (([], True), (["--representable", "binary64"], False), (["--coordinates", "decimal", "--digits", "9"], False)):
        done = harness.run([graze, "validate", CUBE, motion, "-n", "50", "--quiet", *more, "--candidate", "false {points} {out}"])
        check(done.returncode == 3 and ("ended with status 1; expected 0; its points have ratios" in done.stderr) == hint, done.stderr)


def main():
    module = "pandas" if "--pandas" in sys.argv else "numpy"
    sys.argv = [word for word in sys.argv if word != "--pandas"]
    graze = options(__doc__).graze
    python = interpreter(module)
    with tempfile.TemporaryDirectory(prefix="graze python ") as folder:
        if not python and module == "pandas":
            checks.fail("no interpreter here has pandas; expected python3-pandas")
        elif not python:
            checks.skip("candidates in Python", f"no interpreter here has {module}")
        else:
            ten_lines(graze, folder, python, module)
        if python and module == "numpy":
            rewritten(graze, folder, python, module, [], "id")
        elif python:
            check(rewritten(graze, folder, python, module, ["x", "y", "z", "pmc"], "order") > 0, "no float is an ulp off")
            rewritten(graze, folder, python, module, ["x", "y", "z", "id", "pmc"], "id")
            rewritten(graze, folder, python, module, ["pmc"], "order")
        facts(graze, folder)
        early(graze, folder)
        missing(graze, folder)
        failing(graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
