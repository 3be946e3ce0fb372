"""The smallest scene in which a candidate is still wrong::

    python3 -m graze.shrink SOLID MOTION FOLDER --candidate 'CMD {solid} {motion} {points} {out}'

is what `graze validate --shrink FOLDER` runs; `shrink` is the same for a function of Python. A scene
loses what is not needed, as long as the candidate stays wrong in the same way: pieces and times of
its motion, terms, digits, components and corners of its solid, digits of the point. Each step is a
legal scene, and its answers are exact. FOLDER gets the scene, one point, its expected row, the
reason, and for a certificate what `graze-check` reads.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import argparse
import contextlib
import os
import random
import shutil
import signal
import sys
import time
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Callable, Iterator, List, Mapping, Optional, Sequence, Set, Tuple

from . import testing
from ._hull import Point
from ._judges import CommandJudge, FunctionJudge, Kind, Settings, Wrong, is_failure, kind_of_label, kind_of_row, representable
from ._plain import Model
from ._reductions import digits, simpler_motions, simpler_points, simpler_solids, small_motions, small_solids, to_integers, to_whole_point
from ._write import write_folder
from .comparison import compare
from .errors import GrazeError, LimitError, UseError
from .scene import Scene

__all__ = ["Model", "Shrunk", "main", "shrink"]

RUNS, SECONDS = 300, 600.0
_MANY, _FEW = 300, 60   # points that are made in small scenes, and in those of many facets
_LARGE = 500            # facets of a scene that is large


@dataclass(frozen=True)
class Shrunk:
    """A scene in which the candidate is wrong.

    Attributes:
        model: the scene as numbers; None where nothing simpler than the given files was found.
        point: the point.
        kind: (column, exact answer, given answer).
        runs, seconds: of the candidate, and in all.
        finished: False: the runs, the seconds or a signal ended it.
    """

    model: Optional[Model]
    point: Point
    kind: Kind
    runs: int
    seconds: float
    finished: bool


class _Over(Exception):
    """The runs or the seconds are used up."""


class _Signal(BaseException):
    """A signal asks to end; its number."""


class _Search:
    """The best scene so far, and what it has cost."""

    def __init__(self, judge: Any, runs: int, seconds: float, progress: bool) -> None:
        self.judge, self.most, self.seconds, self.progress = judge, runs, seconds, progress
        self.began, self.runs = time.monotonic(), 0
        self.best: Optional[Model] = None
        self.point: Point = ()
        self.points: List[Point] = []
        self.kind: Kind = ("", "", "")
        self.tried: Set[Any] = set()

    def spent(self) -> float:
        """Seconds since it began."""
        return time.monotonic() - self.began

    def start(self, points: Sequence[Point], kind: Kind) -> None:
        """The points that are wrong in this way at first."""
        self.points, self.point, self.kind = list(points), min(points, key=digits), kind

    def tell(self, model: Optional[Model]) -> None:
        """Progress on a terminal, on one line."""
        if self.progress:
            what = "the given scene" if model is None else f"{model.facet_count} facets, {len(model.pieces)} pieces"
            print(f"\rshrink: run {self.runs} of {self.most}, {self.spent():.0f} of {self.seconds:.0f} s, {what}\033[K", end="",
                  file=sys.stderr, flush=True)

    def attempt(self, model: Model, points: Sequence[Point] = (), made: Optional[int] = None) -> bool:
        """Is the candidate wrong in the same way at one of the points, or of others that are made? Then the scene is the best."""
        if self.runs >= self.most or self.spent() > self.seconds:
            raise _Over
        if made != 0:
            key = model.vertices, model.facets, model.pieces
            if key in self.tried:
                return False
            self.tried.add(key)
        try:
            scene = model.scene()
            asked = [point for point in dict.fromkeys(points) if all(map(representable, point))]
            count = made if made is not None else _FEW if model.facet_count > _LARGE else _MANY
            if count:
                asked += [sample.point for sample in scene.generate(count, seed=self.runs + 1, representable=True)]
                asked = list(dict.fromkeys(asked))
            if not asked:
                return False
        except Exception as problem:  # such a scene is not legal, or too large
            if is_failure(problem):
                return False
            raise
        self.runs += 1
        self.tell(self.best)
        wrong = self._wrong(model, scene, asked)
        if not wrong:
            return False
        self.points = sorted(wrong, key=digits)
        self.best, self.point = model, self.points[0]
        return True

    def _wrong(self, model: Model, scene: Scene, asked: Sequence[Point]) -> List[Point]:
        try:
            found: List[Wrong] = self.judge.ask(model, scene, asked)
        except Exception as problem:  # the candidate cannot read it, say
            if is_failure(problem):
                return []
            raise
        return [asked[k] for k, kind in found if kind == self.kind]

    def first(self, models: Iterator[Model], made: Optional[int] = None) -> bool:
        """Take the first of the models in which the candidate is wrong."""
        return any(self.attempt(model, self.points, made) for model in models)


def _search(search: _Search, given: Model) -> None:
    """First scenes of small integers, then what can be left out, until nothing can."""
    whole, points = to_integers(given, search.points)
    own = [list(piece) for piece in ((p,) for p in whole.pieces)] if len(whole.pieces) > 1 else []
    motions = [*small_motions(whole), *own[:4], list(whole.pieces)]
    solids = list(small_solids(whole))
    search.points, before = points, search.points
    found = any(search.attempt(solid.moved(motion), search.points) for motion in motions for solid in solids[:1])
    found = found or any(search.attempt(solid.moved(motion), search.points) for solid in solids[1:] for motion in motions)
    found = found or any(search.attempt(whole.moved(motion), search.points) for motion in motions)
    if not found:
        search.points = before
        if not search.attempt(given, before):
            return
    chance = random.Random(1)
    while _reduced(search, chance):
        continue
    larger = to_whole_point(search.best, search.point) if search.best else None
    if larger:
        search.attempt(larger[0], [larger[1]], 0)


def _size(search: _Search) -> Tuple[int, ...]:
    model = search.best
    assert model is not None
    entries = [c for piece in model.pieces for row in (*piece.entries, (piece.weight,)) for p in row for c in p]
    return (model.facet_count, len(model.pieces), max(piece.degree for piece in model.pieces),
            digits([x for v in model.vertices for x in v]) + digits(entries) + digits([t for p in model.pieces for t in (p.start, p.end)]),
            digits(search.point))


def _reduced(search: _Search, chance: random.Random) -> bool:
    """One pass over all reductions; was the scene made smaller?"""
    assert search.best is not None
    before = _size(search)
    if not search.best.convex:
        while search.first(simpler_solids(search.best, chance)):
            continue
    while search.first(search.best.moved(motion) for motion in simpler_motions(search.best)):
        continue
    while search.best.convex and search.first(simpler_solids(search.best, chance)):
        continue
    _simplify_point(search)
    return _size(search) < before


def _simplify_point(search: _Search) -> None:
    model, point = search.best, search.point
    assert model is not None
    points = simpler_points(search.points, *model.scene().box(), random.Random(1))
    points = [p for p in points if digits(p) < digits(point)]
    if points and model.facet_count <= _LARGE:
        search.attempt(model, points, 0)


@contextlib.contextmanager
def _signals(judge: Any) -> Iterator[None]:
    """Signals that end a program end the search instead, with the best scene so far."""

    def ended(number: int, _frame: Any) -> None:
        raise _Signal(number)

    old = {}
    with contextlib.suppress(ValueError):  # another thread than the first gets none
        for kind in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            old[kind] = signal.signal(kind, ended)
    try:
        yield
    finally:
        for kind, handler in old.items():
            signal.signal(kind, handler)
        stop = getattr(judge, "stop", None)
        if stop:
            stop()


def _run(search: _Search, given: Model) -> Tuple[Shrunk, int]:
    """Search until the end; the result, and the signal that ended it, else 0."""
    ended, finished = 0, True
    try:
        with _signals(search.judge):
            _search(search, given)
    except _Over:
        finished = False
    except _Signal as signalled:
        ended, finished = int(signalled.args[0]), False
    if search.progress:
        print("\r\033[K", end="", file=sys.stderr, flush=True)
    return Shrunk(search.best, search.point, search.kind, search.runs, search.spent(), finished), ended


def shrink(classify: Callable[..., Any], scene: Scene, folder: Any = None, *, n: int = 1000, seed: int = 1, on: Optional[str] = None,
           tolerance: Any = None, labels: Optional[Mapping[Any, str]] = None, points: Any = None, runs: int = RUNS,
           seconds: float = SECONDS, progress: bool = False) -> Optional[Shrunk]:
    """Find the smallest scene in which a function is still wrong; None where it is not wrong.

    Args:
        classify: a function of points and a `Model`, whose solid and motion it reads; else as for
            `graze.testing.check`, whose n, seed, on, tolerance, labels and points these are too.
        scene: of a polyhedron or polygon.
        folder: the scene is written there; it must not exist or be empty. None: nowhere.
        runs, seconds: how often classify is called, and how long it may take in all.
        progress: show it on standard error.
    Raises:
        UseError: the folder holds something, or the solid is curved; what `classify` raises.
    """
    place = None if folder is None else _free(os.fspath(folder))
    if scene.solid.primitives:
        raise UseError("the solid is curved; expected a polyhedron or polygon")
    given = Model.of(scene)
    wrong, _ = testing.wrong_rows(lambda array: classify(array, given), scene, n, seed, on, tolerance=tolerance, labels=labels, points=points)
    if not wrong:
        return None
    judge = FunctionJudge(classify, on, {"tolerance": tolerance, "labels": labels})
    search = _Search(judge, runs, seconds, progress)
    kinds = [kind_of_label(row.expected, row.given) for row in wrong]
    search.start([row.point for row, kind in zip(wrong, kinds) if kind == kinds[0]], kinds[0])
    found, ended = _run(search, given)
    if place is not None:
        write_folder(place, found.model or given, scene, found.point, found.kind, "", [])
    if ended:
        os.kill(os.getpid(), ended)
    return found


def _free(folder: str) -> str:
    """A folder that does not exist or is empty. Raises UseError for others."""
    if os.path.lexists(folder) and not (os.path.isdir(folder) and not os.listdir(folder)):
        raise UseError(f"{folder} is there; expected a folder that does not exist or is empty")
    return folder


def _arguments(words: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python3 -m graze.shrink", description="The smallest scene in which a candidate is still wrong.",
                                     allow_abbrev=False)
    parser.add_argument("solid", metavar="SOLID")
    parser.add_argument("motion", metavar="MOTION")
    parser.add_argument("folder", metavar="FOLDER", help="written; must not exist or be empty")
    parser.add_argument("--candidate", required=True, metavar="CMD", help="as of graze validate")
    parser.add_argument("--golden", metavar="FILE", help="a table of graze classify, and")
    parser.add_argument("--answers", metavar="FILE", help="the candidate's for the same points; else points are made")
    for name, choices in (("question", ("open", "closed")), ("on-as", ("on", "any", "in", "out")), ("candidate-has", ("columns", "sdf")),
                          ("truth", ("pseudo", "outside")), ("operation", ("sweep", "unsweep")), ("folds", ("separate", "combined")),
                          ("overlap", ("extend", "reject"))):
        parser.add_argument(f"--{name}", choices=choices, default=choices[0], help="as of graze validate")
    parser.add_argument("--sdf-tolerance", metavar="V", help="as of graze validate")
    parser.add_argument("--triangulate", action="store_true", help="as of graze validate")
    parser.add_argument("--timeout", type=float, default=3600, metavar="V", help="seconds of one run (3600)")
    parser.add_argument("--runs", type=int, default=RUNS, metavar="N", help=f"runs of the candidate at most ({RUNS})")
    parser.add_argument("--seconds", type=float, default=SECONDS, metavar="V", help=f"seconds in all ({SECONDS:.0f})")
    parser.add_argument("--remove", metavar="DIR", help="a folder of tables, removed at the end")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    return parser.parse_args(words)


def _wrong_at_first(judge: CommandJudge, scene: Scene, o: argparse.Namespace) -> List[Tuple[Point, Kind]]:
    """Points at which the candidate is wrong, deepest first, with the kind of each."""
    if not o.golden:
        points = [sample.point for sample in scene.generate(2000, representable=True)]
        found = judge.ask_in(o.solid, o.motion, scene, points)
        depth = testing.depths(scene, [points[k] for k, _ in found[:200]])
        deepest = sorted(range(len(depth)), key=depth.__getitem__, reverse=True)
        return [(points[found[k][0]], found[k][1]) for k in deepest]
    settings = judge.settings
    report = compare(o.golden, o.answers, question=settings.question, on_as=settings.on_as, candidate_has=settings.candidate_has,
                     truth=settings.truth, sdf_tolerance=settings.sdf_tolerance, show=100,
                     scene=None if settings.sdf_tolerance is not None else scene).report
    out = []
    for row in report["disagreements"]:
        if row.get("golden") and row.get("candidate"):
            out.append((tuple(map(Fraction, row["point"].split())), kind_of_row(row["golden"], row["candidate"])))
    return out


def _main(o: argparse.Namespace) -> int:
    """The work of the command; its exit status."""
    _free(o.folder)
    judge = CommandJudge(o.candidate, o.solid, Settings(o.question, o.on_as, o.candidate_has, o.truth, o.sdf_tolerance), o.timeout)
    try:
        return _shrunk(judge, o)
    finally:
        judge.close()


def _shrunk(judge: CommandJudge, o: argparse.Namespace) -> int:
    scene = Scene(o.solid, o.motion, operation=o.operation, folds=o.folds, overlap=o.overlap, triangulate=o.triangulate)
    if scene.solid.primitives:
        raise UseError(f"--shrink: {o.solid} is curved; expected a polyhedron or polygon")
    wrong = _wrong_at_first(judge, scene, o)
    if not wrong:
        return 0
    search = _Search(judge, o.runs, o.seconds, not o.quiet and sys.stderr.isatty())
    # An answer for membership that is wrong goes before a wrong class or count.
    kind = next((other for _, other in wrong if other[0] in ("pmc", "sdf")), wrong[0][1])
    search.start([point for point, other in wrong if other == kind], kind)
    given = Model.of(scene)
    found, ended = _run(search, given)
    model = found.model or given
    write_folder(o.folder, model, scene, found.point, found.kind, o.candidate, _options(o))
    print(f"graze: shrunk to {model.facet_count} {'facets' if model.dimension == 3 else 'edges'} and {len(model.pieces)} "
          f"piece{'s' * (len(model.pieces) > 1)} in {found.runs} runs of the candidate and {found.seconds:.1f} s"
          f"{'' if found.finished else ', not to the end'}: {o.folder}", file=sys.stderr)
    return -ended or 1


def _options(o: argparse.Namespace) -> List[str]:
    """The options that judge, as words of a command line."""
    usual = (None, "open", "on", "columns", "pseudo", "sweep", "separate", "extend")
    names = ("question", "on_as", "candidate_has", "truth", "sdf_tolerance", "operation", "folds", "overlap")
    return [word for name in names if getattr(o, name) not in usual for word in (f"--{name.replace('_', '-')}", getattr(o, name))]


def main(words: Optional[Sequence[str]] = None) -> int:
    """The command; its exit status is that of `graze validate`. A signal ends it as it ends others, once the folder is written."""
    o = _arguments(words)
    try:
        status = _main(o)
    except GrazeError as problem:
        print(f"graze: {problem}", file=sys.stderr)
        status = 2 if isinstance(problem, UseError) else 3 if isinstance(problem, ValueError) or not isinstance(problem, LimitError) else 6
    except OSError as problem:
        print(f"graze: {problem.filename or o.folder}: {problem.strerror}", file=sys.stderr)
        status = 5
    finally:
        if o.remove:
            shutil.rmtree(o.remove, ignore_errors=True)
    if status < 0:
        signal.signal(-status, signal.SIG_DFL)
        os.kill(os.getpid(), -status)
    return status


if __name__ == "__main__":
    sys.exit(main())
