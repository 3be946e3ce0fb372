"""Solids and motions: from files, arrays, JSON text or dicts, validated exactly when made.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import json
import os
from fractions import Fraction
from typing import Any, Iterable, Mapping, Optional, Sequence, Tuple

from . import _motions
from ._abi import C
from ._context import Context, Settings, settings
from ._expressions import Expressions
from ._library import Handle, library, take_text
from ._frames import refuse_masked
from ._meshes import arrays_of
from ._motions import Joint
from ._numbers import Rationals, numpy, read_points
from ._poses import PoseForm, by_poses
from ._progress import Progress
from .errors import GrazeError, InputError, UseError, name_argument



class Solid(Expressions):
    """A legal solid. Immutable; scenes and threads may share it.

    Curved solids are made by `ball`, `box`, `cylinder`, ... and the operators `|`, `&`, `-`; they are
    read exactly, as `.csg.json` files are, those of operators when they are first used.

    Attributes:
        triangulate: whether facets that are not planar were fanned.
        report: for one made by `scad` with `near_rotation`, how many maps were taken as rotations, and
            how far they move a point at most; else "".
    """

    report = ""
    _source: Optional[str] = None

    def __init__(self, source: Any, *, triangulate: bool = False, round: str = "none",
                 limits: "Mapping[str, int] | None" = None) -> None:
        """Read and validate a solid.

        Args:
            source: the path of a file (.off .obj .ply .stl .nef3 .wkt .csg.json, OpenSCAD's .csg), a curved
                solid as a dict or as JSON text that begins with `{`, or (vertices, facets):
                rows of 2 or 3 numbers, and for each facet (in the plane: ring) its vertices from 0.
                Both may be arrays of numpy, the vertices a DataFrame too, as for points of a
                `Scene`: with a column z they are in space. Or a mesh of trimesh or meshio, or a
                polygon of shapely: what has vertices and faces, points and cells, or rings.
            triangulate: take facets that are not planar, fanned from their first vertex.
            round: `none`, `binary64` or `binary32`: round every coordinate first.
            limits: limits by name, as of `graze --limit`.
        Raises:
            MachineError: the file cannot be read.
            InputError: it is not of its format, or an index is out of range.
            IllegalError: it is not a solid.
            LimitError: a limit was met.
        """
        self._settings = settings(round, limits, True)
        self.triangulate = triangulate
        self._kept: Optional[Handle] = None
        if isinstance(source, str) and source.lstrip().startswith("{"):
            source = json.loads(source, parse_float=str)
        if isinstance(source, Mapping):
            self._read_expression(source)
            return
        context = Context(self._settings)
        pointer = ctypes.c_void_p()
        flags = C.GRAZE_SOLID_TRIANGULATE if triangulate else 0
        if isinstance(source, (str, bytes, os.PathLike)):
            self._source = os.fsdecode(source)
            context.run(library().graze_solid_read, ctypes.byref(pointer), context.pointer,
                        _path(source), flags)
        else:
            found = arrays_of(source)
            try:
                vertices, facets = source if found is None else found
            except (TypeError, ValueError):
                raise TypeError("a solid is a path, a pair (vertices, facets), or a mesh or polygon "
                                "of trimesh, meshio or shapely") from None
            _from_arrays(pointer, context, vertices, facets, flags)
        self._kept = Handle(pointer, library().graze_solid_destroy)

    def _read_expression(self, document: "Mapping[str, Any]") -> None:
        context, pointer = Context(self._settings), ctypes.c_void_p()
        text = json.dumps(_plain(document)).encode("utf-8")
        try:
            context.run(library().graze_solid_from_csg, ctypes.byref(pointer), context.pointer, text, len(text))
        except GrazeError as problem:
            name_argument(problem, "solid", rows=False)
            raise
        self._node, self._given = document["solid"], document
        self._kept = Handle(pointer, library().graze_solid_destroy)

    @classmethod
    def scad(cls, path: Any, *, smooth: int = False, near_rotation: Any = None,
             limits: "Mapping[str, int] | None" = None) -> "Solid":
        """The solid of an OpenSCAD file, `.csg`, as an expression (`graze convert`).

        Args:
            smooth: take what has this number of sides, `$fn`, or more as round, and what has fewer with its
                sides; True: all as round; False: refuse it.
            near_rotation: take the rotation, times a number, that each entry of a map is so near to;
                six digits of OpenSCAD make a turned ball an ellipsoid.
        """
        context, options = Context(settings("none", limits, True)), C.graze_scad_options(smooth=smooth)
        if near_rotation is not None:
            goal = _motions.filled([near_rotation], 1, context, "near_rotation")
            options.near_rotation = goal.address
        text, report = _motions.written(library().graze_scad_text, _path(path), ctypes.byref(options), context=context)
        made = cls(text, limits=limits)
        made.report = report.strip()
        return made

    @classmethod
    def _expressed(cls, dimension: int, node: "Mapping[str, Any]", *, lazily: bool = False) -> "Solid":
        made = cls.__new__(cls)
        made._settings, made.triangulate, made._kept = settings("none", None, True), False, None
        made._node, made._given = dict(node), {"dimension": dimension, "solid": node}
        if not lazily:
            made._read_expression(made._given)
        return made

    @property
    def _handle(self) -> Handle:
        if self._kept is None:
            self._read_expression(self._given)
        assert self._kept is not None
        return self._kept

    def json(self) -> str:
        """A curved solid that was made as an expression as a `.csg.json` file."""
        self._operand()
        return json.dumps(_plain(self._given)) + "\n"

    @property
    def primitives(self) -> Tuple[str, ...]:
        """Titles of the primitives of a curved solid in their order; none of a polyhedron."""
        pointer = self._handle.pointer
        return tuple(str(library().graze_solid_primitive(pointer, k).decode())
                     for k in range(library().graze_solid_primitive_count(pointer)))

    @property
    def dimension(self) -> int:
        """2 or 3."""
        if self._kept is None:
            return int(self._given["dimension"])
        return int(library().graze_solid_dimension(self._handle.pointer))

    def __repr__(self) -> str:
        if self.primitives:
            return f"<graze.Solid in E^{self.dimension}: {_count(len(self.primitives), 'primitive')}>"
        cells = "facet" if self.dimension == 3 else "edge"
        return (f"<graze.Solid in E^{self.dimension}: {_count(self.vertex_count, 'vertex')}, "
                f"{_count(self.facet_count, cells)}, {_count(self.component_count, 'component')}>")

    @property
    def vertex_count(self) -> int:
        """Vertices as the input numbers them."""
        return int(library().graze_solid_vertex_count(self._handle.pointer))

    @property
    def facet_count(self) -> int:
        """Facets as the input numbers them (in the plane: edges, those of no length left out)."""
        return int(library().graze_solid_facet_count(self._handle.pointer))

    @property
    def component_count(self) -> int:
        """Components of the boundary."""
        return int(library().graze_solid_component_count(self._handle.pointer))

    def contains(self, points: Any, *, boundary: bool = True, jobs: Optional[int] = 1,
                 progress: Progress = False) -> Any:
        """Whether points are in the solid, exactly, with no motion.

        Each call prepares the solid; for many calls, and for `on` as an answer of its own, distances
        and grids, make `Scene(solid, None)` once.

        Args:
            points, jobs, progress: as of `Scene.classify`.
            boundary: whether points on the boundary are in it.
        Returns:
            With numpy an array of bool, without it a list; one for each point.
        Raises:
            As `Scene.classify`; GrazeError: of a curved solid, where a point is not decided.
        """
        from .scene import Scene
        scene = Scene(self, None, round=library().graze_rounding_name(self._settings.rounding).decode(),
                      limits={library().graze_limit_name(k).decode(): value for k, value in self._settings.limits})
        verdicts = scene.classify(points, jobs, progress)
        pmc = [verdict.pmc for verdict in verdicts] if numpy is None else verdicts["pmc"].tolist()
        if C.GRAZE_PMC_UNDECIDED in pmc:
            raise GrazeError(f"point {pmc.index(C.GRAZE_PMC_UNDECIDED)}: whether it is in the solid is not decided")
        taken = (C.GRAZE_IN, C.GRAZE_ON) if boundary else (C.GRAZE_IN,)
        inside = [answer in taken for answer in pmc]
        return inside if numpy is None else numpy.array(inside, dtype=bool)

    @property
    def note(self) -> str:
        """Note on an unusual input: vertices that repeat a position; "" if there is none."""
        return str(library().graze_solid_note(self._handle.pointer).decode())


class Motion:
    """A legal motion. Immutable; scenes and threads may share it.

    Attributes:
        report: for one made by `line`, `rotate`, `screw`, `joints`, `poses`, `gcode` or `dyadic`,
            what was approximated, with proved bounds; else "".
    """

    report = ""
    _source: Optional[str] = None

    def __init__(self, source: Any, *, round: str = "none",
                 limits: "Mapping[str, int] | None" = None) -> None:
        """Read and check a motion.

        Args:
            source: the path of a JSON file; JSON text, which begins with `{`; or the same as a
                dict, in which a float is the dyadic number it is and a Fraction its ratio.
            round, limits: as for `Solid`.
        Raises:
            MachineError, InputError, IllegalError, LimitError: as for `Solid`.
            TypeError: the dict holds what JSON cannot.
        """
        self._settings = settings(round, limits, True)
        context = Context(self._settings)
        pointer = ctypes.c_void_p()
        given = source
        if isinstance(source, Mapping):
            source = json.dumps(_plain(source))
        if isinstance(source, str) and source.lstrip().startswith("{"):
            text = source.encode("utf-8")
            try:
                context.run(library().graze_motion_from_json, ctypes.byref(pointer),
                            context.pointer, text, len(text))
            except GrazeError as problem:
                if isinstance(given, Mapping):
                    name_argument(problem, "motion", rows=False)
                raise
        else:
            self._source = os.fsdecode(source)
            context.run(library().graze_motion_read, ctypes.byref(pointer), context.pointer,
                        _path(source))
        self._handle = Handle(pointer, library().graze_motion_destroy)

    @classmethod
    def _made(cls, text: str, report: str, limits: "Mapping[str, int] | None") -> "Motion":
        made = cls(text, limits=limits)
        made.report = report
        return made

    @classmethod
    def line(cls, *by: Any, limits: "Mapping[str, int] | None" = None) -> "Motion":
        """A straight line by d numbers for t from 0 to 1, exactly: `line(8, 0, 0)`."""
        return cls.joints([_motions.slide(*by)], limits=limits)

    @classmethod
    def rotate(cls, degrees: Any, axis: Any = None, center: Any = None, *, tolerance: Any = "1e-9",
               radius: Any = 1, limits: "Mapping[str, int] | None" = None) -> "Motion":
        """A turn for t from 0 to 1; without an axis in the plane. See graze_motion_write_rotation.

        Args:
            degrees: the angle, counter-clockwise, of any size.
            axis, center: 3 numbers and d numbers; without a center the origin.
            tolerance, radius: no point within `radius` of the origin ends further than `tolerance`
                from where it should; `report` says how far.
        """
        joint = _motions.Joint(degrees, axis, center)
        return cls._made(*_motions.by_joints([joint], False, tolerance, radius, limits), limits)

    @classmethod
    def screw(cls, degrees: Any, axis: Any, pitch: Any = 0, center: Any = None, *,
              tolerance: Any = "1e-6", radius: Any = 1,
              limits: "Mapping[str, int] | None" = None) -> "Motion":
        """A uniform turn that moves by `pitch` along the axis with every 360 degrees."""
        return cls.joints([_motions.Joint(degrees, axis, center, pitch)], tolerance=tolerance,
                          radius=radius, limits=limits)

    @classmethod
    def joints(cls, joints: "Iterable[Joint]", *, tolerance: Any = "1e-6", radius: Any = 1,
               limits: "Mapping[str, int] | None" = None) -> "Motion":
        """Joints that all move uniformly, the first one applied first: `turn` and `slide` make
        them. No point within `radius` of the origin is off by more than `tolerance` at any time."""
        return cls._made(*_motions.by_joints(joints, True, tolerance, radius, limits), limits)

    @classmethod
    def poses(cls, poses: Any, times: Any = None, *, quaternions: "str | None" = None,
              columns: Any = None, angles: "str | None" = None, ignore: Sequence[str] = (),
              affine: bool = False, shortest: bool = False, long: bool = False, slerp: bool = False,
              tolerance: Any = "1e-6", numbers: "str | None" = None, dimension: int = 3,
              limits: "Mapping[str, int] | None" = None) -> "Motion":
        """A motion through poses, linear between them (`graze motion poses`).

        Args:
            poses: the path of a log; or a DataFrame or an array of records, whose columns have the
                names that a log may have; or an array or rows of the shape (n, 4, 4), (n, 3, 4), or
                (n, 7), a position and a quaternion. A float is the dyadic number it is. An index
                of a frame that has a name, such as t, is a column too.
            times: n increasing numbers; without them those of the column, else 0, 1, 2, ...
            quaternions: of an array (n, 7): `wxyz`, or `xyzw` as ROS and scipy have them. There is
                no default: the numbers do not tell.
            columns: names of columns, as {"tx": "pos_x"} or "tx=pos_x,...". That of `row` has the
                rows that pieces get, whole numbers from 1 up.
            angles: the machine of three angles in degrees, as `graze motion poses --angles`.
            ignore: names of columns to pass over.
            affine: take matrices as they are; else each becomes the nearest rotation, which
                changes no entry by more than `tolerance`.
            shortest: the default: signs of quaternions that ask for more than half a turn are changed;
                `report` says where.
            long: keep them.
            slerp: turn between poses as SLERP does, up to an angle of `tolerance` radians at each time,
                by further poses between; without it `report` bounds the difference.
            numbers: of a log in a file: `binary64`, the doubles that they were printed from, as
                `graze motion poses` takes them and pandas reads them (default), or `written`.
            dimension: 2 for a motion in the plane: z is left out, refused what turns out of the plane by
                more than `tolerance`. Columns are x, y and qw, qz, or theta in radians.

        The columns first_row and last_row of `Scene(moments=True)`, and the report, name poses of a
        file by their lines, those of arrays and frames by their numbers, from 1: row k is
        `poses.iloc[k - 1]`, unless a column has the rows. A piece has the row of the pose that it leads to.
        """
        form = PoseForm(quaternions, columns, angles, ignore, affine, shortest, long, slerp, tolerance,
                        numbers, dimension)
        return cls._made(*by_poses(poses, times, form, limits), limits)

    @classmethod
    def gcode(cls, path: Any, *, tolerance: Any = "5e-3", start: "Sequence[Any] | None" = None,
              limits: "Mapping[str, int] | None" = None) -> "Motion":
        """The motion of a tool in a G-code program, in millimetres, one unit of t for each line that
        moves it (`graze motion gcode`). A piece has the line as its row.

        Args:
            path: the program.
            tolerance: the largest distance of a path from its arc or helix; `report` has a bound for
                each line that is not exact.
            start: the tip's position before the first line, 3 numbers; without it the motion begins
                where lines have given x, y and z.
        """
        return cls._made(*_motions.by_gcode(os.fsencode(path), tolerance, start, limits), limits)

    def dyadic(self, tolerance: Any = "1e-6") -> "Motion":
        """A motion near this one whose contacts have coordinates that a float can be, except those
        of turns; no entry of its matrix is off by more than `tolerance`."""
        context = Context(self._settings._replace(rounding=0))
        goal = Rationals(1)
        goal.set(0, tolerance, context)
        made = _motions.written(library().graze_motion_write_dyadic, self._handle.pointer,
                                goal.address, context=context)
        return self._made(*made, None)

    def json(self) -> str:
        """The motion as a file of plain pieces (`graze convert`)."""
        context, out = Context(self._settings), ctypes.c_void_p()
        context.run(library().graze_motion_text, ctypes.byref(out), context.pointer,
                    self._handle.pointer)
        return take_text(out)

    def __repr__(self) -> str:
        return f"<graze.Motion in E^{self.dimension}: {_count(self.piece_count, 'piece')}>"

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return int(library().graze_motion_dimension(self._handle.pointer))

    @property
    def piece_count(self) -> int:
        """Pieces after all cuts."""
        return int(library().graze_motion_piece_count(self._handle.pointer))


def _count(number: int, noun: str) -> str:
    plural = "vertices" if noun == "vertex" else noun + "s"
    return f"{number} {noun if number == 1 else plural}"


def input_settings(made: "Solid | Motion") -> Settings:
    """Settings that a solid or motion was read with."""
    return made._settings


def input_handle(made: "Solid | Motion") -> Handle:
    """The library's handle of a solid or motion."""
    return made._handle


def source_of(made: "Solid | Motion") -> Optional[str]:
    """The path of the file that a solid or motion was read from; None of arrays and texts."""
    return made._source


def _path(source: Any) -> bytes:
    path = os.fsencode(source)
    if b"\0" in path:
        raise UseError(f"{source!r} holds a NUL, which no path does")
    return path


def _plain(value: Any) -> Any:
    """A value as JSON has it, floats and Fractions as exact ratios."""
    if numpy is not None and isinstance(value, (numpy.ndarray, numpy.generic)):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(entry) for entry in value]
    if isinstance(value, (float, Fraction)):
        try:
            return str(Fraction(value))
        except (ValueError, OverflowError):
            raise InputError(f"{value} is not a number; expected a finite one") from None
    return value


def _from_arrays(out: ctypes.c_void_p, context: Context, vertices: Any, facets: Any,
                 flags: int) -> None:
    points = read_points(vertices, 0, context, "vertex")
    sizes, indices, keep = _facet_arrays(facets)
    make = (library().graze_solid_from_doubles if points.are_doubles
            else library().graze_solid_from_arrays)
    context.run(make, ctypes.byref(out), context.pointer, points.dimension, points.address(0),
                points.count, sizes, len(keep[0]), indices, flags)


def _facet_arrays(facets: Any) -> Tuple[Any, Any, Tuple[Any, ...]]:
    """Addresses of the sizes and the indices of all facets, and what must be kept meanwhile."""
    if numpy is not None and isinstance(facets, numpy.ndarray) and facets.ndim == 2 and facets.size:
        if facets.dtype.kind not in "iu":
            raise TypeError(f"facets are an array of {facets.dtype}; expected one of integers")
        refuse_masked(facets, "facet", facets.shape[1])
        if facets.min() < 0:
            raise InputError("a facet names a vertex below 0; expected from 0")
        width = f"u{ctypes.sizeof(ctypes.c_size_t)}"
        indices = numpy.ascontiguousarray(facets, dtype=width)
        sizes = numpy.full(len(facets), facets.shape[1], dtype=width)
        return sizes.ctypes.data, indices.ctypes.data, (sizes, indices)
    lengths, flat = [], []
    for k, facet in enumerate(facets):
        if not isinstance(facet, Iterable) or isinstance(facet, (str, bytes)):
            raise TypeError(f"facet {k} is a {type(facet).__name__}; expected a row of vertices")
        row = [_index(k, vertex) for vertex in facet]
        lengths.append(len(row))
        flat.extend(row)
    c_sizes = (ctypes.c_size_t * len(lengths))(*lengths)
    c_indices = (ctypes.c_size_t * len(flat))(*flat)
    return c_sizes, c_indices, (c_sizes, c_indices)


def _index(facet: int, vertex: Any) -> int:
    try:
        index = int(vertex.__index__())
    except AttributeError:
        raise TypeError(f"facet {facet} names {vertex!r}; expected a vertex's number") from None
    if not 0 <= index < 1 << 63:
        raise InputError(f"facet {facet} names vertex {index}; expected from 0")
    return index
