"""tests/times.txt: seconds of wall time and of CPU, with all children, that each suite took, and `make test` and `.ci/run` as wholes.

Only --record of tests/run.py and tests/stages.py writes it, on two idle cores. The runner orders suites by it, mutate.py ends them by
it, documents quote it.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os

PATH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "times.txt")
HEAD = "# What a suite took on two idle cores: seconds of wall time, seconds of CPU. Written by --record of run.py and stages.py alone.\n"
TEST, CI = "make-test", ".ci/run"


def read():
    """Name -> (wall seconds, CPU seconds); empty if there is no file."""
    if not os.path.exists(PATH):
        return {}
    with open(PATH, encoding="utf-8") as file:
        rows = [line.split() for line in file if not line.startswith("#")]
    return {name: (float(wall), float(cpu)) for name, wall, cpu in rows}


def write(took):
    """Take over what some took. Together with TEST these are all suites: of others no row is left."""
    before = {name: row for name, row in read().items() if name == CI} if TEST in took else read()
    rows = sorted({**before, **took}.items())
    with open(PATH, "w", encoding="utf-8") as file:
        file.write(HEAD + "".join(f"{name} {wall:.1f} {cpu:.1f}\n" for name, (wall, cpu) in rows))
