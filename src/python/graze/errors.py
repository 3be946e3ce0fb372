"""Exceptions: a class for each status of graze.h, with message and place of the failure.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import re
from typing import Any, Dict, Type

from ._abi import C


class GrazeError(Exception):
    """Base of all errors of this module; `str` of it is the message.

    Attributes:
        file, line: place of the failure in a file, line from 1; "" and 0 where there is none.
        item, index: kind and number of the item that failed, such as "vertex" 3, counted as in the
            message; "" and 0 where there is none.
        field: a coordinate, a column, or a path in JSON; "" where there is none.
        status: the `graze_status` of graze.h; 0 if the library was not reached.
        partial: verdicts given before the failure, in the form `Scene.classify` returns them; those
            that are not `NONE` are exact. None where there are none.
    """

    status: int = 0
    file: str = ""
    line: int = 0
    item: str = ""
    index: int = 0
    field: str = ""

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.partial: Any = None


class LibraryError(GrazeError):
    """libgraze was not found, could not be loaded, or is of another version."""


class UseError(GrazeError, ValueError):
    """Wrong use: an argument of the call (GRAZE_EUSE)."""

    status = C.GRAZE_EUSE


class InputError(GrazeError, ValueError):
    """Bad input: the bytes do not follow their format (GRAZE_EINPUT)."""

    status = C.GRAZE_EINPUT


class IllegalError(GrazeError, ValueError):
    """Readable, but not a legal solid, motion or pair of them (GRAZE_EILLEGAL)."""

    status = C.GRAZE_EILLEGAL


class LimitError(GrazeError):
    """A limit is exceeded; `limits=` of the scene raises it (GRAZE_ELIMIT)."""

    status = C.GRAZE_ELIMIT


class MachineError(GrazeError):
    """The machine: a file, memory, a thread (GRAZE_ESYSTEM)."""

    status = C.GRAZE_ESYSTEM


class CanceledError(GrazeError):
    """The call was asked to stop (GRAZE_ECANCELED)."""

    status = C.GRAZE_ECANCELED


class InternalError(GrazeError):
    """A fault of Graze itself; no answer is given (GRAZE_EINTERNAL)."""

    status = C.GRAZE_EINTERNAL


BY_STATUS: Dict[int, Type[GrazeError]] = {
    kind.status: kind
    for kind in (UseError, InputError, IllegalError, LimitError, MachineError, CanceledError,
                 InternalError)
}


def name_argument(error: GrazeError, argument: str, rows: bool) -> None:
    """Name an argument where the library names a file that it was given as a text.

    Args:
        argument: its name, which the text had too.
        rows: its rows stand on the lines from 2 on; else lines mean nothing.
    """
    if error.file != argument:
        return
    place, behind = f"{argument}:{error.line}: ", str(error)
    if behind.startswith(place):
        row = f"{argument}[{error.line - 2}]" if rows and error.line > 1 else argument
        behind = f"{row}: {behind[len(place):]}"
    if rows:
        behind = re.sub(r"\bthat of line (\d+)",
                        lambda found: f"that of {argument}[{int(found[1]) - 2}]", behind)
        if error.line > 1:
            error.item, error.index = "pose", error.line - 2
    error.file, error.line = "", 0
    error.args = (behind,)
