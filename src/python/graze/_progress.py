"""Progress of long calls: told to a function, or shown by tqdm where it is installed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import contextlib
import threading
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


def _bar(total: int) -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore
    except ImportError:
        return None
    return tqdm(total=total, unit="points")
