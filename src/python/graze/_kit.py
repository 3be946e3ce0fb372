"""Scenes for tests: golden cases and scenes of the benchmark, where Graze has them.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import csv
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from typing import Any, Dict, Iterator, List, Tuple

from .errors import MachineError, UseError
from .scene import Scene


@dataclass(frozen=True)
class Case:
    """A golden case: its files, a scene of them, and the expected rows with their points, ids and words."""

    name: str
    solid: str
    motion: str
    scene: Scene
    rows: Tuple[Dict[str, str], ...]

    @property
    def points(self) -> List[Tuple[str, ...]]:
        """The points, as number tokens."""
        return [tuple(row[name] for name in "xyz"[:self.scene.dimension]) for row in self.rows]

    @property
    def labels(self) -> List[str]:
        """`in`, `on` or `out` of each point."""
        return [row["pmc"] for row in self.rows]


def _places() -> Iterator[str]:
    """Folders that may hold the cases: $GRAZE_CASES alone if it is set; those of a checkout; those under
    the prefix of the module, and under that of the program `graze`."""
    named = os.environ.get("GRAZE_CASES")
    if named:
        yield named
        return
    place = os.path.dirname(os.path.abspath(__file__))
    yield os.path.normpath(os.path.join(place, "..", "..", "..", "cases"))
    while os.path.dirname(place) != place:
        place = os.path.dirname(place)
        yield os.path.join(place, "share", "graze", "cases")
    program = shutil.which("graze")
    if program:
        yield os.path.normpath(os.path.join(os.path.dirname(os.path.realpath(program)), "..", "share", "graze", "cases"))


def cases_folder() -> str:
    """The folder of the golden cases. Raises MachineError where there is none."""
    for place in _places():
        if os.path.exists(os.path.join(place, "bracket", "motion.json")):
            return place
    raise MachineError("the golden cases are not installed; expected `make install`, or their folder in the variable GRAZE_CASES")


def case_names() -> List[str]:
    """The names of the golden cases, in order."""
    folder = cases_folder()
    return sorted(name for name in os.listdir(folder) if os.path.exists(os.path.join(folder, name, "expected.csv")))


def _options(folder: str) -> Dict[str, Any]:
    """The options of a case's README that a Scene has."""
    with open(os.path.join(folder, "README.md"), encoding="utf-8") as file:
        found: List[List[str]] = [line.split()[1:] for line in file if line.startswith("options: ")]
    words = found[0] if found else []
    given = {words[k][2:].replace("-", "_"): words[k + 1] if k + 1 < len(words) and not words[k + 1].startswith("--") else True
             for k in range(len(words)) if words[k].startswith("--")}
    return {name: given[name] for name in ("operation", "folds", "overlap", "triangulate", "round") if name in given}


def case(name: str) -> Case:
    """A golden case by its name, such as `bracket`.

    Raises:
        UseError: there is no such case; MachineError: the cases are not installed.
    """
    folder = os.path.join(cases_folder(), name)
    if not os.path.exists(os.path.join(folder, "expected.csv")):
        raise UseError(f"there is no golden case {name!r}; expected one of those that `graze cases` lists")
    solid = next(path for path in (os.path.join(folder, "solid" + end) for end in (".off", ".wkt", ".csg.json")) if os.path.exists(path))
    motion = os.path.join(folder, "motion.json")
    with open(os.path.join(folder, "expected.csv"), encoding="utf-8", newline="") as file:
        rows = tuple(csv.DictReader(line for line in file if not line.startswith("#")))
    return Case(name, solid, motion, Scene(solid, motion, **_options(folder)), rows)


def write_benchmark(name: str, folder: Any) -> Tuple[str, str]:
    """Write a scene of the benchmark, such as `gear-screw`, into a folder of this name in `folder`, unless it is
    there; the paths of its solid and its motion.

    Raises:
        MachineError: the cases or the program `graze` are not there, or it failed; UseError: there is no such scene.
    """
    place = os.path.join(os.fspath(folder), name)
    paths = os.path.join(place, "solid.off"), os.path.join(place, "motion.json")
    if all(os.path.exists(path) for path in paths) and os.path.exists(os.path.join(place, "scene.json")):
        return paths
    script = os.path.join(cases_folder(), "benchmark", "scenes.py")
    program = os.environ.get("GRAZE_PROGRAM") or shutil.which("graze") or os.path.join(cases_folder(), "..", "build", "graze")
    known = subprocess.run([sys.executable, script, "--list"], check=False, capture_output=True, text=True).stdout.split()
    if name not in known:
        raise UseError(f"the benchmark has no scene {name!r}; expected one of those that cases/benchmark/README.md lists")
    done = subprocess.run([sys.executable, script, "--graze", program, os.fspath(folder), name], check=False, capture_output=True, text=True)
    if done.returncode:
        raise MachineError(f"the scene {name} cannot be written: {(done.stderr or done.stdout).strip().splitlines()[-1]}")
    return paths
