"""libgraze through ctypes: where it is found; what it has is declared as `_abi` says.

GMP's own functions are looked up through libgraze, so that both sides use the same GMP. ctypes
releases the interpreter's lock during every call.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import ctypes.util
import functools
import os
import weakref
from ctypes import c_void_p
from typing import Any, Callable, Iterator

from ._abi import PROTOTYPES, signature
from .errors import LibraryError

VERSION = "0.1.0"
SONAME = "libgraze.so." + VERSION.split(".")[0]


def _places() -> Iterator[str]:
    """Names to try, the first that loads is taken: $GRAZE_LIBRARY alone if it is set; beside the
    package; the lib folder that an installed package stands in; the build folder of a checkout;
    what the dynamic linker finds."""
    named = os.environ.get("GRAZE_LIBRARY")
    if named:
        yield named
        return
    here = os.path.dirname(os.path.abspath(__file__))
    above = os.path.normpath(os.path.join(here, "..", "..", ".."))
    folders = [here, above]
    if os.path.exists(os.path.join(above, "include", "graze.h")):
        folders.append(os.path.join(above, "build"))
    for folder in folders:
        for name in (SONAME, "libgraze.so"):
            if os.path.exists(os.path.join(folder, name)):
                yield os.path.join(folder, name)
    yield SONAME
    found = ctypes.util.find_library("graze")
    if found:
        yield found


def _open() -> ctypes.CDLL:
    problems = []
    for name in _places():
        try:
            return ctypes.CDLL(name)
        except OSError as problem:
            problems.append(f"{name}: {problem}")
    raise LibraryError("libgraze cannot be loaded; expected `make` in a checkout, an installed "
                       "Graze, or its path in the variable GRAZE_LIBRARY ("
                       + "; ".join(problems) + ")")


@functools.lru_cache(maxsize=None)
def library() -> Any:
    """libgraze with its functions declared; loaded by the first call.

    Raises:
        LibraryError: it is not found, lacks a function, or is not of this module's version.
    """
    opened = _open()
    for name in ("graze_version", *PROTOTYPES):
        try:
            # gmp.h gives its functions other names in the library.
            function = opened["__g" + name if name.startswith("mp") else name]
        except AttributeError:
            raise LibraryError(f"{opened._name} lacks {name}; expected version {VERSION}") from None
        function.restype, function.argtypes = signature(name)
        setattr(opened, name, function)
    version = opened.graze_version().decode().split()[1]
    if version != VERSION:
        raise LibraryError(f"{opened._name} is version {version}; this module needs {VERSION}")
    return opened


def take_text(pointer: c_void_p, length: int = -1) -> str:
    """The text of a `char *` that was given out, which is freed."""
    try:
        return ctypes.string_at(pointer, length).decode("utf-8")
    finally:
        library().graze_free(pointer)


class Handle:
    """Owns one handle of the library and destroys it with itself; `keep` outlives it."""

    def __init__(self, pointer: c_void_p, destroy: Callable[[c_void_p], None], *keep: Any) -> None:
        self.pointer = pointer
        self._end = weakref.finalize(self, _destroy, destroy, pointer, keep)
        # At the end of the process a thread that was not joined may still use it.
        self._end.atexit = False

    def __enter__(self) -> c_void_p:
        return self.pointer

    def __exit__(self, *failure: Any) -> None:
        self._end()

    def __reduce__(self) -> Any:
        raise TypeError("a handle of libgraze cannot be pickled or copied")


def _destroy(destroy: Callable[[c_void_p], None], pointer: c_void_p, _keep: Any) -> None:
    destroy(pointer)
