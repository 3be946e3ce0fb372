"""A context of the library: options, limits and the last message, for one thread at a time.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import os
import threading
from typing import Any, Callable, Dict, Mapping, NamedTuple, Tuple

from . import _calls
from ._abi import words
from ._library import Handle, library
from .errors import BY_STATUS, InternalError, UseError


def choice(name: str, value: str, enum: str, only: Tuple[str, ...] = ()) -> int:
    """The number of a word of an enum of graze.h, or of those of its words in `only`."""
    numbers = words(enum)
    taken = only or tuple(numbers)
    if value not in taken:
        raise UseError(f"{name} is {value!r}; expected one of {', '.join(taken)}")
    return numbers[value]


class Settings(NamedTuple):
    """Settings of a context."""

    rounding: int
    limits: Tuple[Tuple[int, int], ...]
    use_filter: bool


def settings(rounding: str, limits: "Mapping[str, int] | None", use_filter: bool) -> Settings:
    """Settings from the words of `Scene`. Raises UseError for a word that is none."""
    names: Dict[str, int] = {}
    while True:
        name = library().graze_limit_name(len(names))
        if name is None:
            break
        names[name.decode()] = len(names)
    chosen = []
    for key, value in (limits or {}).items():
        if key not in names or not 0 < value < 1 << 64:
            raise UseError(f"limit {key!r} = {value}; expected a positive number for one of "
                           + ", ".join(names))
        chosen.append((names[key], value))
    return Settings(choice("round", rounding, "graze_rounding"), tuple(chosen), use_filter)


class Context:
    """One context of the library. It belongs to the thread that made it."""

    def __init__(self, chosen: Settings) -> None:
        pointer = ctypes.c_void_p()
        status = library().graze_context_create(ctypes.byref(pointer))
        if status:
            raise BY_STATUS.get(status, InternalError)("out of memory for a context")
        self._countdown = _calls.Countdown()
        self.stop = self._countdown.stop
        self.handle = Handle(pointer, _end_context, self._countdown)
        self.pointer = pointer
        self.rounding = chosen.rounding
        self.check(library().graze_context_set_rounding(pointer, chosen.rounding))
        library().graze_context_set_filter(pointer, int(chosen.use_filter))
        for limit, value in chosen.limits:
            self.check(library().graze_context_set_limit(pointer, limit, value))
        library().graze_context_set_cancel(pointer, library().graze_cancel_countdown,
                                           ctypes.byref(self._countdown.left))

    def call(self, function: Callable[..., int], *arguments: Any, brief: bool = False) -> int:
        """The status of function(*arguments), which a signal ends; `brief` as in `_calls`."""
        return _calls.call(self._countdown, function, *arguments, brief=brief)

    def run(self, function: Callable[..., int], *arguments: Any, brief: bool = False) -> None:
        """`call`, and raise the error of its status."""
        self.check(self.call(function, *arguments, brief=brief))

    def check(self, status: int, place: str = "") -> None:
        """Raise the error of a status, its message after `place`, unless it is GRAZE_OK."""
        if status:
            message = library().graze_context_message(self.pointer).decode("utf-8", "replace")
            error = BY_STATUS.get(status, InternalError)(place + message)
            at = library().graze_context_place(self.pointer)
            error.file, error.item, error.field = (os.fsdecode(text) for text in
                                                   (at.file, at.item, at.field))
            error.line, error.index = at.line, at.index
            raise error


def _end_context(pointer: ctypes.c_void_p) -> None:
    library().graze_context_destroy(pointer)
    # A thread's context goes with the thread; what the arithmetic keeps for it should too.
    library().graze_thread_finish()


class Contexts(threading.local):
    """A context for each thread that asks, made when it first does."""

    def __init__(self, chosen: Settings) -> None:
        super().__init__()
        self.chosen = chosen
        self._mine: "Context | None" = None

    def mine(self) -> Context:
        """The calling thread's context."""
        if self._mine is None:
            self._mine = Context(self.chosen)
        return self._mine

    def __reduce__(self) -> Any:
        raise TypeError("contexts of libgraze cannot be pickled")
