"""Motions through poses: of arrays, of frames, and of logs in files (graze/convert.h).

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import os
from fractions import Fraction
from math import isfinite
from typing import Any, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from ._abi import C
from ._context import Context, settings
from ._frames import column_names, read_columns
from ._library import library
from ._motions import filled, written
from .errors import GrazeError, UseError, name_argument

_SHAPES = {(4, 4): 16, (3, 4): 12, (7,): 7}
_ORDERS = {"wxyz": ["qw", "qx", "qy", "qz"], "xyzw": ["qx", "qy", "qz", "qw"]}


class PoseForm(NamedTuple):
    """How poses are read (`Motion.poses`)."""

    quaternions: Optional[str]
    columns: Any
    angles: Optional[str]
    ignore: Sequence[str]
    affine: bool
    shortest: bool
    long: bool
    slerp: bool
    tolerance: Any
    numbers: Optional[str]
    dimension: int


def _text(value: Any) -> str:
    """A number token of exactly this value."""
    return str(Fraction(value)) if isinstance(value, float) and isfinite(value) else str(value)


def _listed(values: Any) -> List[Any]:
    return list(values.tolist() if hasattr(values, "tolist") else values)


def _frame(poses: Any) -> Optional[Tuple[List[str], List[List[Any]]]]:
    """Names and rows of a table with named columns, an array of records too; None of what has none."""
    index = getattr(getattr(poses, "index", None), "name", None)
    if index is not None and hasattr(poses, "reset_index"):
        poses = poses.reset_index()  # an index that has a name is a column, such as the time
    names = column_names(poses) or getattr(getattr(poses, "dtype", None), "names", None)
    if names is None:
        return None
    for name in names:
        if not isinstance(name, str) or set(name) & set(",;\n\""):
            raise UseError(f"poses has the column {name!r}; expected names without separators")
    columns = [_listed(column) for column in read_columns(poses, list(names), "pose")]
    return list(names), [list(row) for row in zip(*columns)]


def _array(poses: Any, quaternions: Optional[str]) -> Tuple[List[str], List[List[Any]]]:
    """Names and rows of an array, or of rows, each a matrix or a position and a quaternion."""
    flat: List[List[Any]] = []
    for k, pose in enumerate(_listed(poses)):
        pose = _listed(pose)
        nested = bool(pose) and hasattr(pose[0], "__len__") and not isinstance(pose[0], str)
        shape = (len(pose), len(pose[0])) if nested else (len(pose),)
        if shape not in _SHAPES:
            raise UseError(f"pose {k} has the shape {shape}; expected (4, 4), (3, 4), or 7 numbers, "
                           "a position and a quaternion")
        flat.append([entry for row in pose for entry in row] if nested else pose)
    if len({len(row) for row in flat}) > 1:
        raise UseError("the poses have several shapes; expected one")
    width = len(flat[0]) if flat else 7
    if width != 7:
        return [f"m{k // 4}{k % 4}" for k in range(width)], flat
    if quaternions not in _ORDERS:
        raise UseError(f"quaternions is {quaternions!r}; expected 'wxyz' for poses x, y, z, qw, qx, qy, "
                       "qz, or 'xyzw' for x, y, z, qx, qy, qz, qw, as ROS and scipy have them")
    return ["x", "y", "z", *_ORDERS[quaternions or ""]], flat


def _list_of_poses(poses: Any, times: Any, quaternions: Optional[str]) -> str:
    """Poses as a list with a line of names."""
    framed = _frame(poses)
    if framed is not None and quaternions is not None:
        raise UseError("quaternions is of arrays alone; the names of columns tell their order")
    names, rows = framed or _array(poses, quaternions)
    if times is not None:
        moments = _listed(times)
        if len(moments) != len(rows):
            raise UseError(f"{len(moments)} times for {len(rows)} poses; expected as many")
        names, rows = ["t"] + names, [[t] + row for t, row in zip(moments, rows)]
    return "\n".join(",".join(_text(entry) for entry in row) for row in [names] + rows) + "\n"


def by_poses(poses: Any, times: Any, form: PoseForm,
             limits: "Mapping[str, int] | None") -> Tuple[str, str]:
    """A motion through poses of an array, rows, a frame or a file."""
    is_file = isinstance(poses, (str, bytes, os.PathLike))
    if form.numbers not in (None, "binary64", "written"):
        raise UseError(f"numbers is {form.numbers!r}; expected 'binary64' or 'written'")
    if form.numbers is not None and not is_file:
        raise UseError("numbers is of a log in a file; those of arrays and frames are what they are")
    rounded = is_file and form.numbers != "written"
    context = Context(settings("binary64" if rounded else "none", limits, True))
    goal = filled([form.tolerance], 1, context, "the tolerance")
    flags = (C.GRAZE_POSES_AFFINE * form.affine + C.GRAZE_POSES_SHORTEST * form.shortest
             + C.GRAZE_POSES_LONG * form.long + C.GRAZE_POSES_SLERP * form.slerp)
    options = C.graze_pose_options(flags=flags, tolerance=goal.address, dimension=form.dimension)
    if form.columns is not None:
        columns = form.columns
        if isinstance(columns, Mapping):
            columns = ",".join(f"{name}={column}" for name, column in columns.items())
        options.columns = columns.encode()
    if form.angles is not None:
        options.angles = form.angles.encode()
    ignored = (ctypes.c_char_p * len(form.ignore))(*(name.encode() for name in form.ignore))
    options.ignored, options.ignored_count = ctypes.addressof(ignored), len(form.ignore)
    if is_file:
        if times is not None or form.quaternions is not None:
            raise UseError("times and quaternions are of arrays; a file's columns have names")
        return written(library().graze_motion_write_pose_list, os.fsencode(poses),
                       ctypes.byref(options), context=context)
    text = _list_of_poses(poses, times, form.quaternions).encode()
    options.text, options.length = text, len(text)
    options.flags |= C.GRAZE_POSES_NUMBERED
    try:
        return written(library().graze_motion_write_pose_list, b"poses", ctypes.byref(options),
                       context=context)
    except GrazeError as problem:
        name_argument(problem, "poses", rows=True)
        raise
