"""Scenes: a solid that moves, and every question about points.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import math
import os
from fractions import Fraction
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

from . import _parallel
from ._abi import C
from ._context import Context, Contexts, choice, settings
from ._library import Handle, library, take_text
from ._meshes import arrays_of
from ._numbers import Points, Rationals, numpy, read_points, rounded
from ._progress import Progress
from ._samples import samples
from ._traces import cell_given, read_topology, read_trace, verdict_of
from .boundaries import BUDGET, CONTACTS, DEPTH, Boundary, boundary
from .envelopes import Envelope, read_envelope
from .outlines import Outline, read_outline
from .errors import GrazeError, UseError
from .inputs import Motion, Solid, input_handle, input_settings
from .judgements import Judgement, judge
from .pictures import Page, Picture, cones, draw, page, picture
from .results import (ENCLOSURE_DTYPE, VERDICT_DTYPE, Cell, Enclosure, Pmc, Sample, Topology,
                      Trace, Verdict)
from .sites import Site, read_site

_FEW = 8  # points; a call of fewer may well be brief

Number = Union[int, float, str, Fraction]


class Scene:
    """A legal solid and a legal motion of it; points are classified against what it sweeps.

    Immutable. Threads may share a scene: each works with a context of its own. Every number is
    exact: a float is the dyadic rational it is, int, Fraction and Decimal are themselves, a str is
    a number token such as `0.1` (one tenth) or `22/7`.

    Points are given as an array of numpy of the shape (n, d), as n rows of d numbers, or as a
    DataFrame (of pandas, polars, ...): its columns x, y and in space z, in any order; its other
    columns are left out. Rows that are Series or named tuples are read by name as well. A masked
    value is an error, as NaN is.
    """

    def __init__(self, solid: Any,
                 motion: "Motion | str | os.PathLike[str] | Mapping[str, Any] | None",
                 operation: str = "sweep", overlap: str = "extend", folds: str = "separate",
                 triangulate: bool = False, round: str = "none", *,
                 limits: Optional[Mapping[str, int]] = None, use_filter: bool = True,
                 topo: bool = False, columns: str = "all", sdf: Any = None,
                 motion_error: Any = None, moments: bool = False, regular: bool = False,
                 boundary_distance: bool = False) -> None:
        """Read, validate and put together; decide whether first and last position meet.

        Args:
            solid: a `Solid`, or what one is made of: a path, or (vertices, facets).
            motion: a `Motion`, or what one is made of: a path, JSON text, or a dict. None: the solid
                does not move, and verdicts, rows and tables have pmc alone, with sdf beside it.
            operation: `sweep`, or `unsweep`: the points that stay in the solid all the time.
            overlap: `reject` makes it an error that first and last position meet; else `extend`.
            folds: `separate`: Definitions 6 and 7; `combined`: 10 and 11 in their place.
            triangulate: take facets that are not planar, fanned from their first vertex.
            round: `binary64` or `binary32` rounds every number of solid, motion and points first.
            limits: limits by name, as of `graze --limit`: `digits`, `degree`, `pieces`, ...
            topo: rows and tables end with the position relative to the closed sweep.
            columns: `pmc`: verdicts, rows and tables have that answer alone, which is decided
                sooner; the other fields of verdicts are 0. Not with topo, nor for JSON Lines.
            sdf: rows and tables enclose the signed distance to at most this width: a number, or
                text such as `1e-6r`, relative to `diagonal`. `distance` gives arrays.
            motion_error: with sdf, a number: rows and tables say whether pmc is certain for every
                motion within it.
            boundary_distance: with sdf: rows and tables have a proved lower bound of the distance
                to the boundary: all points that are nearer have the same pmc.
            moments: rows and tables have the first and the last time at which the point is in the
                closed solid, with pieces and rows of a log.
            regular: of an unsweep: rows and tables end with whether the point is in the closure of
                its interior. `regularised` has the witness.
            use_filter: let the certified floating-point filter go first; answers are the same.
        Raises:
            UseError: a word that is none, or a solid or motion that was rounded otherwise.
            MachineError, InputError, LimitError: see `Solid` and `Motion`.
            IllegalError: not a legal solid, motion or pair of them.
        """
        chosen = settings(round, limits, use_filter)
        width, relative = _width(sdf)
        options = C.graze_options(operation=choice("operation", operation, "graze_operation"),
                                  overlap=choice("overlap", overlap, "graze_overlap"),
                                  folds=choice("folds", folds, "graze_folds"))
        self._shown = C.graze_row_options(
            columns=choice("columns", columns, "graze_columns"), topo=int(topo), sdf=width,
            motion_error=rounded("motion_error", motion_error, math.inf), moments=int(moments),
            regular=int(regular), boundary=int(boundary_distance), at_rest=int(motion is None))
        if motion is None:
            if (operation, overlap, folds) != ("sweep", "extend", "separate"):
                raise UseError("operation, overlap and folds need a motion; expected one")
            columns, self._shown.columns = "pmc", choice("columns", "pmc", "graze_columns")
        if not isinstance(solid, Solid):
            solid = Solid(solid, triangulate=triangulate, round=round, limits=limits)
        if not isinstance(motion, (Motion, type(None))):
            motion = Motion(motion, round=round, limits=limits)
        both: Tuple[Union[Solid, Motion], ...] = (solid,) if motion is None else (solid, motion)
        for made in both:
            if input_settings(made).rounding != chosen.rounding:
                raise UseError("solid, motion and points must be rounded alike")
        self.solid, self.motion = solid, motion
        self.operation, self.overlap, self.folds, self.round = operation, overlap, folds, round
        self.topo, self.columns = bool(topo), columns
        self.sdf, self.motion_error = sdf, motion_error
        self.moments, self.regular = bool(moments), bool(regular)
        self.boundary_distance = bool(boundary_distance)
        self._contexts = Contexts(chosen)
        context, pointer = self._contexts.mine(), ctypes.c_void_p()
        parts = tuple(input_handle(made) for made in both)
        pointers = [part.pointer for part in parts]
        if motion is None:
            context.run(library().graze_scene_at_rest, ctypes.byref(pointer), context.pointer, *pointers)
        else:
            context.run(library().graze_scene_create, ctypes.byref(pointer), context.pointer, *pointers,
                        ctypes.byref(options))
        self._handle = Handle(pointer, library().graze_scene_destroy, *parts)
        if relative:
            tolerance = ctypes.c_double()
            context.run(library().graze_scene_width, ctypes.byref(tolerance), context.pointer,
                        pointer, width)
            self._shown.sdf = tolerance.value
        self._head("")  # do the options go together?

    def __repr__(self) -> str:
        if self.motion is None:
            return f"<graze.Scene, {self.solid!r} at rest>"
        return f"<graze.Scene, {self.operation} of {self.solid!r} by {self.motion!r}>"

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return int(library().graze_scene_dimension(self._handle.pointer))

    @property
    def ends_meet(self) -> Optional[bool]:
        """Whether the first and the last position have a point in common; None: not decided."""
        return {0: False, 1: True}.get(library().graze_scene_ends(self._handle.pointer))

    def box(self) -> Tuple[Tuple[Fraction, ...], Tuple[Fraction, ...]]:
        """The lowest and the highest corner of a dyadic box that holds the sweep (the unsweep)."""
        low, high, context = Rationals(self.dimension), Rationals(self.dimension), self._context()
        context.run(library().graze_scene_box, low.address, high.address, context.pointer,
                    self._handle.pointer)
        return tuple(low[k] for k in range(low.count)), tuple(high[k] for k in range(high.count))

    def classify(self, points: Any, jobs: Optional[int] = 1, progress: Progress = False) -> Any:
        """Classify points exactly.

        Args:
            points: an array or rows. Arrays of floats are the fast way; other threads of Python run
                meanwhile.
            jobs: threads; None takes all cores.
            progress: a function of (points done, points in all), called by any thread every few
                hundred points; what it raises ends the call. True: a bar of tqdm, if it is there.
        Returns:
            With numpy a structured array with the fields pmc, class, definition, case, i, t (see
            `Pmc`, `Class` and `Verdict`), without it a list of `Verdict`; one for each point.
        Raises:
            TypeError, UseError, InputError: of the points, named by row and coordinate; a column
                that is missing, a masked value.
            LimitError, InternalError: `partial` of the exception holds the verdicts given; where
                the message begins with `from point k`, it counts points from there.
        """
        given = self._points(points)
        out, address = _answers(C.graze_verdict, VERDICT_DTYPE, given.count)
        function = (library().graze_classify_doubles if given.are_doubles
                    else library().graze_classify)
        try:
            self._ask(function, given, address, ctypes.sizeof(C.graze_verdict), jobs, progress,
                      self._shown.columns)
        except GrazeError as failure:
            failure.partial = _verdicts(out)
            raise
        return _verdicts(out)

    def distance(self, points: Any, tolerance: float, jobs: Optional[int] = 1,
                 progress: Progress = False) -> Any:
        """Enclose the signed distances of points to the sweep, negative inside (semantics.md 8).

        Args:
            points, jobs, progress: as `classify`.
            tolerance: greatest width high - low that is wanted, positive.
        Returns:
            With numpy a structured array with the fields low, high, time, pmc, wide (see
            `Enclosure`), without it a list of `Enclosure`; one for each point.
        Raises:
            As `classify`; UseError: a tolerance that is not positive and finite.
        """
        given = self._points(points)
        out, address = _answers(C.graze_enclosure, ENCLOSURE_DTYPE, given.count)
        function = (library().graze_distances_doubles if given.are_doubles
                    else library().graze_distances)
        try:
            self._ask(function, given, address, ctypes.sizeof(C.graze_enclosure), jobs, progress,
                      float(tolerance))
        except GrazeError as failure:
            failure.partial = _enclosures(out)
            raise
        return _enclosures(out)

    def grid(self, size: Sequence[int], low: Optional[Sequence[Number]] = None,
             high: Optional[Sequence[Number]] = None) -> Any:
        """Exact memberships of a grid of points; neighbours are decided together where that is certain.

        Args:
            size: points along each axis, 2 or more.
            low, high: the first and the last point; `box` where they are not given.
        Returns:
            With numpy an array of bytes of the shape `size`, [i, j, k] being the membership (see
            `Pmc`) of the point i along x, j along y, k along z; without it bytes, x running fastest.
        Raises:
            TypeError, UseError, InputError, LimitError, InternalError: as `classify`.
        """
        context, pointer, box = self._context(), ctypes.c_void_p(), self.box()
        if len(size) != self.dimension:
            raise UseError(f"size: {len(size)} numbers; expected {self.dimension}")
        sizes = (ctypes.c_size_t * self.dimension)(*size)
        first = self._point(box[0] if low is None else low)
        last = self._point(box[1] if high is None else high)
        context.run(library().graze_grid_create, ctypes.byref(pointer), context.pointer,
                    self._handle.pointer, sizes, first.address, last.address)
        with Handle(pointer, library().graze_grid_destroy) as grid:
            count = int(library().graze_grid_count(grid))
            out = ctypes.create_string_buffer(count)
            context.run(library().graze_grid_pmc, out, context.pointer, grid, 0, 1, count)
        return out.raw if numpy is None else numpy.frombuffer(out.raw, "u1").reshape(size, order="F")

    @property
    def diagonal(self) -> float:
        """The diagonal of the box of the first position's corners, rounded down."""
        out, context = ctypes.c_double(), self._context()
        context.run(library().graze_scene_diagonal, ctypes.byref(out), context.pointer,
                    self._handle.pointer)
        return out.value

    def trace(self, point: Sequence[Number]) -> Trace:
        """All contacts of one point's trajectory with the boundary, in order of exact times.

        Raises:
            TypeError, UseError, InputError, LimitError, InternalError: as `classify`.
        """
        rationals = self._point(point)
        with self._trace(rationals) as pointer:
            return read_trace(pointer, tuple(rationals[k] for k in range(self.dimension)))

    def explain(self, point: Sequence[Number]) -> str:
        """The whole reasoning for one point, for a person to read. Raises as `trace`."""
        rationals, context, text = self._point(point), self._context(), ctypes.c_void_p()
        with self._trace(rationals) as pointer:
            context.run(library().graze_report_explain, ctypes.byref(text), context.pointer,
                        self._handle.pointer, rationals.address, pointer,
                        ctypes.byref(self._shown), brief=True)
        return take_text(text)

    def topology(self, point: Sequence[Number]) -> Topology:
        """Where one point lies relative to the closed sweep. Raises as `trace`."""
        return self._topology(library().graze_trace_topo, point)

    def regularised(self, point: Sequence[Number]) -> Topology:
        """Where one point lies relative to the regularised unsweep, the closure of its interior: an `on`
        point is `boundary`, or `exterior` on a part that dangles. Raises as `trace`; UseError: a sweep."""
        return self._topology(library().graze_trace_regular, point)

    def _topology(self, question: Any, point: Sequence[Number]) -> Topology:
        rationals, context, pointer = self._point(point), self._context(), ctypes.c_void_p()
        with self._trace(rationals) as trace:
            context.run(question, ctypes.byref(pointer), context.pointer, self._handle.pointer,
                        rationals.address, trace)
        with Handle(pointer, library().graze_topology_destroy) as topology:
            return read_topology(topology, self.dimension)

    def cones(self, point: Sequence[Number]) -> Picture:
        """A picture of the directions about a point that its contacts cover to first order (`graze
        explain --svg`): in the plane, of a point that is `on` a sweep. Raises as `trace`."""
        rationals = self._point(point)

        def drawn(name: str) -> bytes:
            with self._trace(rationals) as trace:
                return cones(name, self._context(), self._handle, rationals, trace)

        return picture(drawn)

    def site(self, time: Number, body: Optional[Sequence[Number]] = None, *,
             point: Optional[Sequence[Number]] = None) -> Site:
        """A boundary point of the solid at a time: `body` in the solid's frame, or `point` where it
        is then. Raises as `trace`, and InputError for a time beyond the motion and a point that is
        not on the boundary."""
        create = library().graze_site_create if point is None else library().graze_site_create_at
        place, when = self._site_place(body, point), Rationals(1)
        context, pointer = self._context(), ctypes.c_void_p()
        when.set(0, time, context)
        context.run(create, ctypes.byref(pointer), context.pointer, self._handle.pointer,
                    when.address, place.address)
        with Handle(pointer, library().graze_site_destroy) as site:
            return read_site(site, when[0], self.dimension)

    def snap(self, time: Number, cell: Cell, body: Optional[Sequence[Number]] = None, *,
             point: Optional[Sequence[Number]] = None) -> Optional[Tuple[Site, Fraction]]:
        """The contact of a face, edge or vertex at a time that is nearest to `body`, or to where
        `point` is in the solid's frame, and the squared distance there; None if the cell has no
        contact then. Raises as `site`, and InputError for a cell that the solid does not have."""
        call, when, square = library(), Rationals(1), Rationals(1)
        place = self._site_place(body, point)
        context, pointer = self._context(), ctypes.c_void_p()
        when.set(0, time, context)
        context.run(call.graze_site_snap if point is None else call.graze_site_snap_at,
                    ctypes.byref(pointer), context.pointer, self._handle.pointer, when.address,
                    place.address, cell_given(cell))
        with Handle(pointer, call.graze_site_destroy) as site:
            if not call.graze_site_shift(square.address, site):
                return None
            return read_site(site, when[0], self.dimension), square[0]

    def _site_place(self, body: Optional[Sequence[Number]],
                    point: Optional[Sequence[Number]]) -> Rationals:
        given = body if point is None else point
        if given is None or (body is not None and point is not None):
            raise UseError("a site takes body or point, one of them")
        return self._point(given)

    def envelope(self) -> Envelope:
        """Every time at which the contact points of the envelope change, and whether it is
        decomposable.

        Raises:
            UseError: the scene is an unsweep; LimitError, InternalError.
        """
        context, pointer = self._context(), ctypes.c_void_p()
        context.run(library().graze_envelope_create, ctypes.byref(pointer), context.pointer,
                    self._handle.pointer)
        return read_envelope(Handle(pointer, library().graze_envelope_destroy, self._handle), self)

    def outline(self, width: float = 1e-12) -> Outline:
        """The exact boundary in the plane: arcs, rings, area. `width`: the greatest width of an
        enclosed area or length, relative to its size.

        Raises:
            UseError: the width; InputError: a curved solid; IllegalError: a polyhedron; LimitError, InternalError.
        """
        return read_outline(self, width)

    def rows(self, points: Any, format: str = "csv", jobs: Optional[int] = 1,
             progress: Progress = False) -> List[str]:
        """The rows of `graze classify`, without line ends: CSV, or with `jsonl` JSON Lines, which
        hold every contact with its exact times. Raises as `classify`."""
        given, shown = self._points(points), C.graze_row_options.from_buffer_copy(self._shown)
        shown.format = choice("format", format, "graze_format", ("csv", "jsonl"))
        pieces: Dict[int, List[str]] = {}

        def piece(context: Context, first: int, count: int) -> None:
            rationals, start = given.exact(first, count)
            text, length, done = ctypes.c_void_p(), ctypes.c_size_t(), ctypes.c_size_t()
            status = context.call(
                library().graze_report_points, ctypes.byref(text), ctypes.byref(length),
                ctypes.byref(done), None, context.pointer, self._handle.pointer,
                rationals.at(start), count, None, ctypes.byref(shown))
            rows = take_text(text, length.value).split("\n")[:-1] if text else []
            context.check(status, f"point {first + done.value}: ")
            pieces[first] = rows

        _parallel.run(given.count, jobs, self._contexts, piece, progress)
        return [row for first in sorted(pieces) for row in pieces[first]]

    def table(self, points: Any, jobs: Optional[int] = 1, progress: Progress = False) -> str:
        """The whole table of `graze classify --coordinates exact`, a text to be written to a file."""
        head = self._head(f"# triangulate {'yes' if self.solid.triangulate else 'no'}\n")
        rows = self.rows(points, jobs=jobs, progress=progress)
        undecided = sum("?" in row or row.endswith(",undecided") for row in rows)
        counted = self.topo or self.regular or self.solid.primitives
        return "".join([head, *(row + "\n" for row in rows),
                        *([f"# undecided {undecided}\n"] if counted else []),
                        f"# complete {len(rows)}\n"])

    def _head(self, notes: str) -> str:
        context, head = self._context(), ctypes.c_void_p()
        context.check(library().graze_report_header(
            ctypes.byref(head), context.pointer, self._handle.pointer, notes.encode(), None,
            ctypes.byref(self._shown)))
        return take_text(head)

    def generate(self, count: int, seed: int = 1, strata: Optional[Mapping[str, int]] = None,
                 representable: bool = False, first: int = 0) -> Iterator[Sample]:
        """Query points, most of them degenerate by construction, no two of them equal; the same for
        the same arguments.

        Args:
            count: how many; fewer come where no others are found.
            seed: 0 to 2^64 - 1.
            strata: weights by name (`random`, `near`, `face`, `edge`, ...), the others then 0.
            representable: keep to points whose coordinates are floats.
            first: the row to begin with.
        Raises:
            UseError: no such stratum, or none of those asked for can be made.
        """
        return samples(Context(self._contexts.chosen), self._handle, self.dimension,
                       range(first, first + count), seed, strata, representable)

    def boundary(self, depth: int = DEPTH, coarse: Optional[int] = None, budget: int = BUDGET,
                 contacts: int = CONTACTS, seed: int = 1,
                 box: Optional[Tuple[Sequence[Number], Sequence[Number]]] = None,
                 sharp: bool = False, jobs: Optional[int] = 1) -> Boundary:
        """The boundary of the sweep as a surface, by adaptive sampling (`graze boundary`): every
        vertex is on it or between two points that were classified exactly.

        Args:
            depth: the greatest number of times that cells are halved along each axis.
            coarse: the number of times that all cells are halved; None is 4, in the plane 5, or the depth.
            budget: points that may be classified.
            contacts: points of contact that are made, so that thin parts are found; `seed` is theirs.
            box: the lowest and the highest corner; None is around the scene.
            sharp: give cells a vertex at an edge or corner of the sweep, where one is found.
            jobs: threads, as in `classify`; any number gives the same surface.
        Raises:
            UseError: a depth, a budget or a box that is none; LimitError, CanceledError.
        """
        corners = (self._point(box[0]), self._point(box[1])) if box else None
        return boundary(self._context(), self._handle, self.dimension, depth, coarse, budget,
                        contacts, seed, sharp, jobs, corners)

    def judge(self, vertices: Any, faces: Any = None, within: Any = "1e-2r", budget: Optional[int] = None, *,
              points: int = 1000, seed: int = 1, jobs: Optional[int] = 1) -> Judgement:
        """How far a mesh is from the boundary of the sweep, each way, by proved bounds (`graze judge`).

        The signed distances of the vertices themselves are `distance(vertices, tolerance)`.

        Args:
            vertices, faces: rows of 3 floats and of 3 vertices; or a file's name and None; or an object of
                trimesh or meshio. The mesh may be open, cross itself or have no orientation.
            within: greatest width of the bounds; text like "1e-3r" is that share of the diagonal.
            budget: cubes and points that may be asked about; None is 10^7.
            points: how many generated points a closed mesh is asked about, with `seed`.
            jobs: threads for the points and the volume.
        Raises:
            UseError: no rows of 3; InputError: a file or face that is none, a curved solid; IllegalError: a
            scene in the plane, or an unsweep; LimitError, CanceledError.
        """
        if faces is None:
            arrays = arrays_of(vertices)
            if not arrays and not isinstance(vertices, (str, bytes, os.PathLike)):
                raise UseError("without faces; expected a file's name or a mesh of trimesh or meshio")
            vertices, faces = arrays if arrays else (os.fsencode(vertices), None)
        return judge(self._context(), self._handle, vertices, faces, self._judged_width(within), budget, points,
                     seed, jobs)

    def _judged_width(self, within: Any) -> float:
        width, relative = _width(within)
        if not relative:
            return width
        out = ctypes.c_double()
        context = self._context()
        context.run(library().graze_scene_width, ctypes.byref(out), context.pointer, self._handle.pointer, width)
        return out.value

    def draw(self, points: Any = None, *, names: Optional[Sequence[str]] = None, title: str = "",
             grid: int = 0, times: int = 0,
             box: Optional[Tuple[Sequence[Number], Sequence[Number]]] = None,
             by: str = "class",
             plane: "str | Tuple[Sequence[Number], Number] | None" = None) -> Picture:
        """A picture: the class of every cell, positions of the solid, and for points their inverted
        trajectories with contacts (`graze draw`). A notebook shows it.

        Args:
            points: as for `classify`, some tens at most; `names` are their labels.
            title: a line above the picture.
            grid: cells along the longer side; 0 chooses.
            times: positions of the solid, 2 to 64; 0 is 5.
            box: the lowest and the highest corner; None is around the scene.
            by: colours of cells: `class`, or `distance`: bands of the signed distance and levels.
            plane: in space, as of `graze draw --plane`: "z=0.1" or "A,B,C,D"; or a normal and a
                number: the cells are where normal . x is the number. None is across z, through the
                middle of the box.
        """
        corners = (self._point(box[0]), self._point(box[1])) if box else None
        given = None if points is None else self._points(points)
        normal, kind = self._plane(plane), choice("by", by, "graze_draw_by")

        def drawn(name: str) -> bytes:
            return draw(name, self._context(), self._handle, given, names, corners, normal,
                        title=title, grid=grid, times=times, by=kind)

        return picture(drawn)

    def page(self, points: Any = None, *, names: Optional[Sequence[str]] = None,
             strata: Optional[Sequence[str]] = None, title: str = "",
             surface: Optional[int] = 0, times: int = 0,
             box: Optional[Tuple[Sequence[Number], Sequence[Number]]] = None,
             certificate: Any = None, checker: Any = None) -> Page:
        """A page of HTML to turn and to ask, as `graze draw -o scene.html` makes it: the solid at a
        time, what it sweeps, the points by class with their trajectories, and for each the sentences
        of `graze explain`. It needs no network. A notebook shows it.

        Args:
            points: as for `classify`; `names` are their labels, `strata` groups to filter by.
            title: a line above the scene.
            surface: level of the sweep's surface; 0 chooses, None leaves it out.
            times: positions of the solid, 2 to 64; 0 is 5.
            box: the lowest and the highest corner; None is around the scene.
            certificate: a file of `graze certify` for these points, in their order. The page has its
                bytes and those of the files of solid and motion, and the page of `graze-check`
                verifies it. Not of a solid or a motion that was made of arrays or text.
            checker: with certificate, the file of `make checker-page`: the page proves its points
                itself, by a button.
        Raises:
            UseError: a checker alone, or a certificate of a scene that was not read from files.
            InputError: a file that is not of this scene, or no page of `graze-check`.
        """
        corners = (self._point(box[0]), self._point(box[1])) if box else None
        given = None if points is None else self._points(points)
        files = [getattr(part, "_source", None) for part in (self.solid, self.motion)]
        if checker is not None and certificate is None:
            raise UseError("a checker proves points by a certificate; expected certificate too")
        if certificate is not None and None in files:
            raise UseError("a certificate is of files; expected a solid and a motion that were read from files")
        proof = None if certificate is None else [*files, certificate, checker]
        return page(self._context(), self._handle, given, names, strata, corners, proof, title=title,
                    times=times, surface=-1 if surface is None else surface)

    def _context(self) -> Context:
        return self._contexts.mine()

    def _points(self, points: Any) -> Points:
        return read_points(points, self.dimension, self._context())

    def _plane(self, plane: Any) -> Optional[Rationals]:
        """A normal and a number, one after the other."""
        if isinstance(plane, str):
            plane = _plane_of(plane)
        if plane is None:
            return None
        if len(plane) != 2 or len(plane[0]) != 3:
            raise UseError(f"plane is {plane!r}; expected a normal of 3 numbers, and a number")
        normal, place = plane
        out = Rationals(4)
        for k, value in enumerate([*normal, place]):
            out.set(k, value, self._context())
        return out

    def _point(self, point: Sequence[Number]) -> Rationals:
        return self._points([point]).exact(0, 1)[0]

    def _ask(self, function: Any, given: Points, address: int, size: int, jobs: Optional[int],
             progress: Progress, option: float) -> None:
        """One of the library's functions of many points, by `jobs` threads."""

        def piece(context: Context, first: int, count: int) -> None:
            status = context.call(function, address + first * size, context.pointer,
                                  self._handle.pointer, given.address(first), count, option,
                                  brief=count < _FEW)
            context.check(status, f"from point {first}: " if first else "")

        _parallel.run(given.count, jobs, self._contexts, piece, progress)

    def _trace(self, point: Rationals) -> Handle:
        context, pointer = self._context(), ctypes.c_void_p()
        context.run(library().graze_trace_create, ctypes.byref(pointer), context.pointer,
                    self._handle.pointer, point.address, brief=True)
        return Handle(pointer, library().graze_trace_destroy, self._handle)


def _width(sdf: Any) -> Tuple[float, int]:
    """The width of enclosures, rounded down, and whether it is relative."""
    relative = isinstance(sdf, str) and sdf.endswith("r")
    return rounded("sdf", sdf[:-1] if relative else sdf, 0.0), int(relative)


def _answers(structure: Any, dtype: Any, count: int) -> Tuple[Any, int]:
    """Room for the answers of `count` points, and its address."""
    if numpy is not None:
        array = numpy.zeros(count, dtype)
        return array, int(array.ctypes.data)
    room = (structure * count)()
    return room, ctypes.addressof(room)


def _enclosures(out: Any) -> Any:
    if numpy is not None:
        return out
    return [Enclosure(made.low, made.high, made.time, Pmc(made.pmc), bool(made.wide))
            for made in out]


def _verdicts(out: Any) -> Any:
    if numpy is not None:
        return out
    return [verdict_of(made) for made in out]


def _plane_of(text: str) -> Tuple[Sequence[Number], Number]:
    """`z=1/2`, or `A,B,C,D` for A x + B y + C z = D."""
    axis, equals, place = text.partition("=")
    fields = text.split(",")
    if equals and axis.strip() in ("x", "y", "z"):
        return [int(axis.strip() == name) for name in "xyz"], place.strip()
    if len(fields) != 4:
        raise UseError(f"plane is {text!r}; expected x=, y= or z= and a number, or A,B,C,D")
    return [field.strip() for field in fields[:3]], fields[3].strip()
