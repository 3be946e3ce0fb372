"""Tests of classifiers against exact answers: `check` for any test runner; the kit's fixtures for pytest
are in `graze.pytest_plugin`, strategies for Hypothesis in `graze.strategies`.

    >>> import graze.testing
    >>> cube = graze.Scene(graze.tools.box(2, 2, 2), graze.Motion.line(8, 0, 0))
    >>> def swept(points):
    ...     return [0 < x < 10 and 0 < y < 2 and 0 < z < 2 for x, y, z in points]
    >>> graze.testing.check(swept, cube, n=100).rows
    100

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import shlex
from fractions import Fraction
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from ._kit import case, case_names, write_benchmark
from ._labels import ON_AS, WORDS, Labels, is_wrong, read_labels
from ._numbers import numpy
from ._plain import motion_of
from .errors import GrazeError, UseError
from .inputs import source_of
from .results import PMC_NAMES, Trace, pmc_names
from .scene import Scene
from .times import Time

__all__ = ["Checked", "WrongLabels", "WrongRow", "case", "case_names", "check", "scene_of", "wrong_rows", "write_benchmark"]

_MEASURED = 200  # wrong rows whose depth is asked for


class WrongRow(NamedTuple):
    """A row whose label is wrong: its number from 0, its point.

    `expected` and `given` are words, or `given` is a distance outside [low - tolerance, high +
    tolerance] of the exact one; `depth` is the least distance from the sweep's boundary, None where
    it is not known; `stratum` says how the point was made, "" of points that were given.
    """

    number: int
    point: Tuple[Fraction, ...]
    expected: str
    given: Any
    depth: Optional[float]
    stratum: str


class Checked(NamedTuple):
    """Result of `check`: rows judged, those left out as undecided, and (expected, given) counted."""

    rows: int
    undecided: int
    confusion: Dict[Tuple[str, str], int]


class WrongLabels(AssertionError):
    """Labels that differ from the exact answers; `wrong` holds the rows, deepest first."""

    def __init__(self, message: str, wrong: Sequence[WrongRow], checked: Checked) -> None:
        super().__init__(message)
        self.wrong, self.checked = list(wrong), checked


def check(classify: Callable[..., Any], scene: Any, n: int = 1000, seed: int = 1, on: Optional[str] = None, *,
          tolerance: Any = None, labels: Optional[Mapping[Any, str]] = None, points: Any = None,
          strata: Optional[Mapping[str, int]] = None, show: int = 3) -> Checked:
    """Ask a function about points, most of them degenerate, and compare with the exact answers.

    Args:
        classify: takes an array of floats of the shape (n, d), without numpy a list of tuples, and
            returns n labels, all of one kind: `in`, `on`, `out`; True (in) and False (out);
            integers -1 (in), 0 (on), 1 (out); or floats, signed distances that are negative inside.
        scene: a `Scene`, or what one is made of as a pair (solid, motion).
        n, seed: number of points made, and their seed. All have coordinates that floats hold.
        on: labels that are right for an `on` point: `on` alone, `in`, `out` or `any`. None: `on` for
            words and integers, `any` for Booleans and floats.
        tolerance: of floats: a distance is wrong only if it is further than this from the exact one,
            which is enclosed. None: the sign alone is judged.
        labels: the word of each value that classify returns, for other conventions: {1: "in", 0: "out"}.
        points: these points instead: rows of floats.
        strata: weights, as for `Scene.generate`.
        show: wrong rows in the message, the deepest ones.
    Raises:
        WrongLabels: an AssertionError, if a label is wrong.
        UseError: no labels, or not n of them, or arguments that do not go together.
    """
    __tracebackhide__ = True  # pytest shows the line of the test
    made = scene_of(scene)
    motion_of(made)  # one at rest is refused before it is asked
    wrong, checked = wrong_rows(classify, made, n, seed, on, tolerance=tolerance, labels=labels, points=points, strata=strata)
    if wrong:
        raise WrongLabels(message(made, wrong, checked, show, "" if points is not None else f"n={n}, seed={seed}"),
                          wrong, checked)
    return checked


def scene_of(given: Any) -> Scene:
    """A Scene, or one made of a pair (solid, motion)."""
    if isinstance(given, Scene):
        return given
    try:
        solid, motion = given
    except (TypeError, ValueError):
        raise TypeError(f"scene is a {type(given).__name__}; expected a Scene or a pair (solid, motion)") from None
    return Scene(solid, motion)


def wrong_rows(classify: Callable[..., Any], scene: Scene, n: int = 1000, seed: int = 1, on: Optional[str] = None, *,
               tolerance: Any = None, labels: Optional[Mapping[Any, str]] = None, points: Any = None,
               strata: Optional[Mapping[str, int]] = None) -> Tuple[List[WrongRow], Checked]:
    """The wrong rows, deepest first, and the counts of `check`, whose arguments these are."""
    if on is not None and on not in ON_AS:
        raise UseError(f"on is {on!r}; expected one of {', '.join(ON_AS)}")
    rows, names = _points(scene, n, seed, points, strata)
    given = _asked(classify, rows, scene.dimension, labels)
    if tolerance is not None and given.kind != "distances":
        raise UseError(f"tolerance is for floats; classify returned {given.kind}")
    golden = pmc_names(scene.classify(_array(rows, scene.dimension)))
    judge = _Judge(scene, rows, golden, given, on or given.default_on, tolerance)
    bad = [k for k in range(len(rows)) if golden[k] in WORDS and judge.wrong(k)]
    confusion: Dict[Tuple[str, str], int] = {}
    for k, word in enumerate(golden):
        if word in WORDS:
            confusion[word, given.words[k]] = confusion.get((word, given.words[k]), 0) + 1
    undecided = sum(word not in WORDS for word in golden)
    depths = judge.depths(bad)
    wrong = [WrongRow(k, tuple(map(Fraction, rows[k])), golden[k], given.values[k], depths.get(k), names[k]) for k in bad]
    wrong.sort(key=lambda row: (-1.0 if row.depth is None else row.depth, row.expected != "on"), reverse=True)
    return wrong, Checked(len(rows) - undecided, undecided, confusion)


def _points(scene: Scene, n: int, seed: int, points: Any, strata: Optional[Mapping[str, int]]) -> Tuple[List[Tuple[float, ...]], List[str]]:
    if points is not None:
        rows = [tuple(map(float, row)) for row in (points.tolist() if hasattr(points, "tolist") else points)]
        return rows, [""] * len(rows)
    samples = list(scene.generate(n, seed=seed, strata=strata, representable=True))
    if not samples:
        raise UseError("no points were made; expected strata that the scene has")
    return [tuple(map(float, sample.point)) for sample in samples], [sample.stratum for sample in samples]


def _array(rows: List[Tuple[float, ...]], dimension: int) -> Any:
    return rows if numpy is None else numpy.array(rows, float).reshape(len(rows), dimension)


def _asked(classify: Callable[..., Any], rows: List[Tuple[float, ...]], dimension: int, labels: Optional[Mapping[Any, str]]) -> Labels:
    """The labels of the function, which gets points of its own."""
    given = read_labels(classify(_array(rows, dimension)), labels)
    if len(given.values) != len(rows):
        raise UseError(f"classify returned {len(given.values)} labels; expected {len(rows)}, one for each point")
    return given


class _Judge:
    """Tells wrong labels from right ones, and how deep they are."""

    def __init__(self, scene: Scene, rows: List[Tuple[float, ...]], golden: List[str], given: Labels, on: str, tolerance: Any) -> None:
        self.scene, self.rows, self.golden, self.given, self.on = scene, rows, golden, given, on
        self.tolerance = Fraction(0 if tolerance is None else tolerance)
        self.enclosures: Any = None
        if tolerance is not None:
            if self.tolerance <= 0:
                raise UseError(f"tolerance is {tolerance}; expected a positive number")
            self.enclosures = scene.distance(_array(rows, scene.dimension), float(self.tolerance) / 16)

    def wrong(self, k: int) -> bool:
        if self.enclosures is None:
            return is_wrong(self.golden[k], self.given.words[k], self.on)
        low, high = _ends(self.enclosures[k])
        value = self.given.values[k]
        if value in (float("inf"), float("-inf")):
            return True
        return not low - self.tolerance <= Fraction(value) <= high + self.tolerance

    def depths(self, bad: List[int]) -> Dict[int, float]:
        """The least |s|; of a curved solid there is none."""
        chosen = sorted(bad, key=lambda k: self.golden[k] == "on")[:_MEASURED]
        return dict(zip(chosen, depths(self.scene, [self.rows[k] for k in chosen])))


def depths(scene: Scene, points: Sequence[Any]) -> List[float]:
    """The least distance of each point from the boundary of the sweep; none of a curved solid."""
    if not points or scene.solid.primitives:
        return []
    try:
        found = scene.distance(points, scene.diagonal * 1e-6)
    except GrazeError:
        return []
    return [float(max(low, -high, Fraction(0))) for low, high in map(_ends, found)]


def _ends(enclosure: Any) -> Tuple[Fraction, Fraction]:
    low, high = (enclosure["low"], enclosure["high"]) if numpy is not None else (enclosure.low, enclosure.high)
    return Fraction(float(low)), Fraction(float(high))


def message(scene: Scene, wrong: Sequence[WrongRow], checked: Checked, show: int, made: str) -> str:
    """The confusion, then the first rows with word, reason and the command that explains."""
    lines = [f"{len(wrong)} of {checked.rows} labels are wrong" + (f" ({made})" if made else "")]
    given = sorted({label for _, label in checked.confusion}, key=lambda label: (WORDS + (label,)).index(label))
    lines.append("  exact \\ given " + "".join(f"{label:>9}" for label in given))
    for word in WORDS:
        if any((word, label) in checked.confusion for label in given):
            lines.append(f"  {word:<13} " + "".join(f"{checked.confusion.get((word, label), 0):>9}" for label in given))
    for number, row in enumerate(wrong[:show], 1):
        trace = scene.trace(row.point)
        depth = "" if row.depth is None else f", {row.depth:.3g} from the boundary of the {scene.operation}"
        lines += [f"{number}. ({', '.join(map(str, row.point))}) is `{row.expected}`, given {row.given}; word {trace.word}{depth}"
                  + (f", stratum {row.stratum}" if row.stratum else ""), f"   {why(trace, scene.operation)}", f"   {explains(scene, row.point)}"]
    return "\n".join(lines)


def explains(scene: Scene, point: Sequence[Fraction]) -> str:
    """The command that gives the whole reasoning, or the call where solid or motion is no file."""
    numbers = [str(value) for value in point]
    files = source_of(scene.solid), source_of(motion_of(scene))
    if None in files:
        return f"scene.explain({numbers!r})"
    options = [word for name, word, usual in (("--operation", scene.operation, "sweep"), ("--folds", scene.folds, "separate"),
                                              ("--round", scene.round, "none")) if word != usual for word in (name, word)]
    return shlex.join(["graze", "explain", *map(str, files), *numbers, *options, *(["--triangulate"] if scene.solid.triangulate else [])])


def _when(time: Time) -> str:
    return str(time) if isinstance(time, Fraction) else f"about {float(time):.12g}"


def why(trace: Trace, operation: str = "sweep") -> str:
    """Two sentences: what the trajectory does, and what follows from it."""
    contacts, word, pmc = trace.contacts, trace.word, PMC_NAMES[trace.verdict.pmc]
    met = [" and ".join(map(str, contact.cells[:2])) + (" and more" if len(contact.cells) > 2 else "") for contact in contacts]

    def stretch(letter: str) -> str:
        place = word.index(letter)
        before = word[:place].count("B")
        begin = f"t = {_when(contacts[before - 1].end)} ({met[before - 1]})" if place else "the start"
        end = f"t = {_when(contacts[before].start)} ({met[before]})" if place + 1 < len(word) else "the end"
        return f"from {begin} to {end}"

    if operation == "unsweep":
        return {"in": "The point stays in the interior of the solid all the time. So it is `in` the unsweep.",
                "on": f"The point never leaves the solid, and is on its boundary at t = {_when(contacts[0].start)} ({met[0]}). So it is `on`."
                      if contacts else "", "out": f"The point is outside the solid {stretch('O')}. So it is `out`." if "O" in word else ""}.get(pmc, "")
    if pmc == "in":
        return f"The point is in the interior of the solid {stretch('I')}. One such time is enough for `in`."
    if pmc == "on":
        first = contacts[0]
        when = f"at t = {_when(first.start)}" if first.is_instant else f"from t = {_when(first.start)} to t = {_when(first.end)}"
        return f"The boundary of the solid meets the point {when} ({met[0]}). Its interior never does, so the point is `on`."
    if pmc == "out":
        return "The point is outside the solid all the time, and not even its boundary meets it. So it is `out`."
    return ""
