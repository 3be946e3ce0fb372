"""Progress of long calls: told to a function, or shown on standard error, by tqdm where it is installed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import contextlib
import sys
import threading
import time
from typing import Any, Callable, Iterator, Union

Progress = Union[bool, Callable[[int, int], Any]]


@contextlib.contextmanager
def told(progress: Progress, total: int) -> Iterator[Callable[[int], None]]:
    """A function to be called with each number of points that is done, by any thread."""
    done, lock = 0, threading.Lock()
    bar = _bar(total) if progress is True else None

    def add(count: int) -> None:
        nonlocal done
        with lock:
            done += count
            if bar is not None:
                bar.update(count)
            elif callable(progress):
                progress(done, total)

    try:
        yield add
    finally:
        if bar is not None:
            bar.close()


class _Line:
    """The part that is done, on one line of standard error, written anew twice a second at most."""

    def __init__(self, total: int) -> None:
        self._done, self._total, self._shown = 0, total, 0.0

    def update(self, count: int) -> None:
        self._done += count
        now = time.monotonic()
        if now - self._shown >= 0.5 or self._done >= self._total:
            self._shown = now
            print(f"\r{self._done} of {self._total} points", end="", file=sys.stderr, flush=True)

    def close(self) -> None:
        if self._shown:
            print(file=sys.stderr)


def _bar(total: int) -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore
    except ImportError:
        return _Line(total)
    return tqdm(total=total, unit="points")
