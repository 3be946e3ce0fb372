"""Judges of candidates, for `graze.shrink`: where one is wrong in a scene.

A judge is asked for the wrong ones of some points, with the kind of error of each: the exact answer
and the given one.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import os
import shlex
import signal
import subprocess
import tempfile
from fractions import Fraction
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from ._hull import Point
from ._plain import Model, number, written_ending
from .comparison import compare
from .errors import GrazeError, MachineError, UseError
from .scene import Scene

Kind = Tuple[str, str, str]  # column, exact answer, given one
Wrong = Tuple[int, Kind]     # number of the point, and how it is wrong
PLACEHOLDERS = ("{solid}", "{motion}", "{points}", "{out}")


class Settings(NamedTuple):
    """How answers are judged, as `graze validate` has it."""

    question: str = "open"
    on_as: str = "on"
    candidate_has: str = "columns"
    truth: str = "pseudo"
    sdf_tolerance: Optional[str] = None


class FunctionJudge:
    """A function of points and a model, judged as by `graze.testing.check`."""

    def __init__(self, classify: Callable[..., Any], on: Optional[str], options: Mapping[str, Any]) -> None:
        self.classify, self.on, self.options = classify, on, dict(options)
        self.command = ""

    def ask(self, model: Model, scene: Scene, points: Sequence[Point]) -> List[Wrong]:
        """The wrong ones of these points."""
        from .testing import wrong_rows
        wrong, _ = wrong_rows(lambda array: self.classify(array, model), scene, on=self.on, points=points, **self.options)
        return [(row.number, kind_of_label(row.expected, row.given)) for row in wrong]


def kind_of_label(expected: str, given: Any) -> Kind:
    """The kind of a wrong label."""
    if isinstance(given, float):
        return "sdf", expected, "negative" if given < 0 else "positive" if given > 0 else "0"
    return "pmc", expected, str(given)


class CommandJudge:
    """A candidate of `graze validate`, run on files in a folder of its own."""

    def __init__(self, command: str, solid: str, settings: Settings, timeout: float) -> None:
        self.words = _words(command)
        self.command, self.solid, self.settings, self.timeout = command, solid, settings, timeout
        self.folder = tempfile.TemporaryDirectory(prefix="graze-shrink-")
        self.child: "Optional[subprocess.Popen[bytes]]" = None

    def close(self) -> None:
        """End the candidate and remove its files."""
        self.stop()
        self.folder.cleanup()

    def stop(self) -> None:
        """End the candidate, with all that it started."""
        if self.child is not None and self.child.poll() is None:
            os.killpg(self.child.pid, signal.SIGKILL)
            self.child.wait()

    def ask(self, model: Model, scene: Scene, points: Sequence[Point]) -> List[Wrong]:
        """The wrong ones of these points. Raises MachineError: the candidate fails, or writes no table."""
        ending = written_ending(self.solid, model.dimension)
        self._write("solid" + ending, model.solid_text(ending))
        self._write("motion.json", model.motion_text())
        return self.ask_in(self._path("solid" + ending), self._path("motion.json"), scene, points)

    def ask_in(self, solid: str, motion: str, scene: Scene, points: Sequence[Point]) -> List[Wrong]:
        """Ask as `ask` does, in a scene of files."""
        names = "x,y,z"[:2 * scene.dimension - 1]
        self._write("points.csv", "".join([names + ",id\n", *(",".join(map(number, p)) + f",{k}\n" for k, p in enumerate(points, 1))]))
        paths = dict(zip(PLACEHOLDERS, (solid, motion, self._path("points.csv"), self._path("candidate.csv"))))
        if os.path.exists(paths["{out}"]):
            os.remove(paths["{out}"])
        self._run([paths.get(word, word) for word in self.words], scene, points)
        if not os.path.isfile(paths["{out}"]):
            raise MachineError(f"the candidate {self.words[0]} has written no table to {{out}}")
        return self._compare(scene, points)

    def _run(self, words: List[str], scene: Scene, points: Sequence[Point]) -> None:
        low, high = scene.box()
        told = {"GRAZE_DIMENSION": str(scene.dimension), "GRAZE_ROWS": str(len(points)), "GRAZE_SEED": "1",
                "GRAZE_BOX": ",".join(repr(float(x)) for x in (*low, *high))}
        try:
            with open(os.devnull, "rb") as nothing:
                self.child = subprocess.Popen(words, stdin=nothing, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                              env={**os.environ, **told}, start_new_session=True)
            status = self.child.wait(self.timeout)
        except OSError as problem:
            raise MachineError(f"the candidate {words[0]} cannot be run: {problem.strerror}") from None
        except subprocess.TimeoutExpired:
            raise MachineError(f"the candidate {words[0]} took more than {self.timeout:.0f} s") from None
        finally:
            self.stop()
        if status:
            raise MachineError(f"the candidate {words[0]} ended with status {status}; expected 0")

    def _compare(self, scene: Scene, points: Sequence[Point]) -> List[Wrong]:
        asked = self.settings
        table = scene_for(scene, asked).table(points).splitlines()
        head = next(k for k, line in enumerate(table) if not line.startswith("#"))
        # At most two rows of a stratum are shown: each row is a stratum.
        rows = [f"{line},{k},{k}" for k, line in enumerate(table[head + 1:head + 1 + len(points)], 1)]
        self._write("golden.csv", "\n".join([*table[:head], table[head] + ",id,stratum", *rows, *table[head + 1 + len(points):]]) + "\n")
        found = compare(self._path("golden.csv"), self._path("candidate.csv"), question=asked.question, on_as=asked.on_as,
                        candidate_has=asked.candidate_has, truth=asked.truth, sdf_tolerance=asked.sdf_tolerance, show=10 ** 6)
        return [(row["golden-line"] - head - 2, kind_of_row(row["golden"], row.get("candidate") or ""))
                for row in found.report["disagreements"] if row.get("golden-line")]

    def _path(self, name: str) -> str:
        return os.path.join(self.folder.name, name)

    def _write(self, name: str, text: str) -> None:
        with open(self._path(name), "w", encoding="utf-8") as file:
            file.write(text)


def scene_for(scene: Scene, asked: Settings) -> Scene:
    """The scene whose tables have what the comparison needs."""
    closed, values = asked.question == "closed", asked.sdf_tolerance is not None
    if not closed and not values:
        return scene
    return Scene(scene.solid, scene.motion, operation=scene.operation, folds=scene.folds, overlap=scene.overlap, topo=closed,
                 sdf="1e-10r" if values else None)


def _words(command: str) -> List[str]:
    try:
        words = shlex.split(command)
    except ValueError:
        raise UseError("--candidate: a quote or a backslash is left open") from None
    for needed in PLACEHOLDERS[2:]:
        if needed not in words:
            raise UseError("--candidate: expected {points} and {out} as words of their own")
    return words


def kind_of_row(golden: str, candidate: str) -> Kind:
    """The kind of a disagreement of a comparison."""
    exact, given = (_fields(text) for text in (golden, candidate))
    if "pmc" in given and given["pmc"] != exact.get("pmc"):
        return "pmc", exact.get("pmc", ""), given["pmc"]
    for name, value in given.items():
        if name == "sdf":
            return "sdf", exact.get("pmc", ""), "negative" if value.startswith("-") else "0" if not value.strip("0.") else "positive"
        if exact.get(name) != value:
            return name, exact.get("pmc", ""), given.get("pmc", "")
    return "", exact.get("pmc", ""), ""


def _fields(text: str) -> Dict[str, str]:
    return dict(part.split("=", 1) for part in text.split() if "=" in part)


def is_failure(problem: BaseException) -> bool:
    """Does a reduced scene that ends so count as one in which the candidate is not wrong?"""
    return isinstance(problem, (GrazeError, ArithmeticError))


def representable(value: Fraction) -> bool:
    """Does a float hold the number exactly?"""
    try:
        return Fraction(float(value)) == value
    except OverflowError:
        return False
