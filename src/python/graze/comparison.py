"""A candidate's table against a golden one (graze/compare.h).

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import csv
import ctypes
import decimal
import json
import os
import tempfile
from fractions import Fraction
from typing import Any, Dict, Mapping, NamedTuple

from ._abi import C
from ._context import Context, choice, settings
from ._frames import column_names, read_columns
from ._library import Handle, library, take_text
from .errors import InputError
from .scene import Scene


class Comparison(NamedTuple):
    """Result of `graze compare`.

    Attributes:
        report: figures and disagreements, as the JSON of `graze compare --format json`.
        text: the same as Markdown, which a notebook shows.
    """

    report: Dict[str, Any]
    text: str

    @property
    def differs(self) -> bool:
        """Is a row wrong, missing or extra?"""
        return any(self.report[key] for key in ("wrong", "missing", "extra"))

    def _repr_markdown_(self) -> str:
        return self.text

    def __repr__(self) -> str:
        keys = ("rows", "agree", "wrong", "missing", "undecided", "extra")
        return "<graze.Comparison: " + ", ".join(f"{self.report[k]} {k}" for k in keys) + ">"


def _number(name: str, value: Any) -> "bytes | None":
    """A number as the text of a token; None stays."""
    if value is None:
        return None
    try:
        text = value if isinstance(value, str) else str(
            value if isinstance(value, decimal.Decimal) else Fraction(value))
    except (ValueError, OverflowError):
        raise InputError(f"{name}: {value} is not a number; expected a finite one") from None
    return text.encode()


def compare(golden: Any, candidate: Any, *, question: str = "open", on_as: str = "on",
            candidate_has: str = "columns", truth: str = "pseudo", sdf_tolerance: Any = None,
            motion_error: Any = None, show: int = 10, solid: Any = None, motion: Any = None,
            scene: "Scene | None" = None, round: str = "none", limits: "Mapping[str, int] | None" = None) -> Comparison:
    """Compare a candidate's table with a golden one, row by row.

    Two tables of `graze contact` are compared too: rows of one time and one point belong together,
    in any order, and each column is judged that both have.

    Args:
        golden, candidate: paths of CSV files (`graze compare --help` says what they must have), or
            DataFrames with such columns.
        question: `open`, or `closed`: pmc refers to the closed sweep.
        on_as: `on`, or for candidates that only know in and out `any`, `in`, `out`.
        candidate_has: `columns`, or `sdf`: the sign of that column is the answer; where golden is a
            table of `classify --sdf`, its errors are reported (`report["errors-of-sdf"]`).
        truth: `pseudo`: the values of all points are judged; `outside`: those of `out` points.
        sdf_tolerance: a number: values that miss the enclosure by more are wrong. Signs have none.
        motion_error: a number: rows whose answer a motion within it may change are undecided.
        show: how many disagreements are kept: the deepest wrong rows, at most two of a stratum,
            where depths are known, else the first ones.
        solid, motion: names of files for the commands that explain them.
        scene: a Scene, that of golden: how deep the wrong rows are is measured in it
            (`report["depth-of-wrong-rows"]`).
        round: `none`, `binary64` or `binary32`: round points and times of both tables first.
    Raises:
        MachineError, InputError, LimitError: a table cannot be read or compared.
    """
    if scene is not None and not isinstance(scene, Scene):
        raise TypeError(f"scene is a {type(scene).__name__}; expected a Scene")
    names = [os.fsencode(name) if name is not None else None for name in (solid, motion)]
    options = C.graze_compare_options(
        question=choice("question", question, "graze_question"),
        on_as=choice("on_as", on_as, "graze_on_as"),
        has=choice("candidate_has", candidate_has, "graze_candidate_has"),
        truth=choice("truth", truth, "graze_truth"), show=show, solid=names[0], motion=names[1],
        sdf_tolerance=_number("sdf_tolerance", sdf_tolerance),
        motion_error=_number("motion_error", motion_error),
        scene=scene._handle.pointer if scene is not None else None)
    context, made = Context(settings(round, limits, True)), ctypes.c_void_p()
    with tempfile.TemporaryDirectory() as folder:
        paths = [_table(table, os.path.join(folder, name))
                 for table, name in ((golden, "golden.csv"), (candidate, "candidate.csv"))]
        context.run(library().graze_compare, ctypes.byref(made), context.pointer, *paths,
                    ctypes.byref(options))
        return _reported(made, context, folder)


def _table(table: Any, path: str) -> bytes:
    """The path of a table; a frame is written first."""
    names = column_names(table)
    if names is None:
        return os.fsencode(table)
    columns = [[_field(value) for value in column]
               for column in read_columns(table, names, "row")]
    with open(path, "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([names, *zip(*columns)])
        file.write(f"# complete {len(columns[0])}\n")
    return os.fsencode(path)


def _field(value: Any) -> str:
    """A value as a field: the shortest decimal of a float, nothing of what is missing."""
    if hasattr(value, "item"):
        value = value.item()
    if value is None or value != value:
        return ""
    return repr(value) if isinstance(value, float) else str(value)


def _reported(made: ctypes.c_void_p, context: Context, folder: str) -> Comparison:
    """The reports, in which tables of a folder have their names alone."""
    texts = []
    with Handle(made, library().graze_comparison_destroy) as pointer:
        for form in (C.GRAZE_COMPARISON_JSON, C.GRAZE_COMPARISON_TEXT):
            out = ctypes.c_void_p()
            context.run(library().graze_comparison_report, ctypes.byref(out), context.pointer,
                        pointer, form)
            texts.append(take_text(out).replace(folder + os.sep, ""))
    return Comparison(json.loads(texts[0]), texts[1])
