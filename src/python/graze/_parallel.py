"""Work on n things in pieces, in one thread or several, each with a context of its own.

A signal or another thread's failure ends the calls that run, and no further piece begins.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import os
import threading
from typing import Callable, List, Optional

from ._calls import TURN
from ._context import Context, Contexts
from ._progress import Progress, told
from .errors import UseError

PIECE = 512


def threads(jobs: Optional[int]) -> int:
    """How many threads `jobs` is. Raises UseError: it is not positive."""
    if jobs is not None and jobs < 1:
        raise UseError(f"jobs is {jobs}; expected at least 1, or None for all cores")
    return jobs or os.cpu_count() or 1


def run(count: int, jobs: Optional[int], contexts: Contexts,
        work: Callable[[Context, int, int], None], progress: Progress = False) -> None:
    """Call work(context, first, n) for pieces that together are 0 ... count - 1, and tell how many
    are done.

    Raises:
        UseError: `jobs` is not positive.
        BaseException: what `work` raised, the first if several did; other pieces may be left out.
    """
    jobs = threads(jobs)
    with told(progress, count) as add:

        def piece(context: Context, first: int, size: int) -> None:
            work(context, first, size)
            add(size)

        if jobs == 1 or count <= PIECE:
            for first in range(0, count, PIECE):
                piece(contexts.mine(), first, min(PIECE, count - first))
            return
        _run_threads(min(jobs, -(-count // PIECE)), count, contexts, piece)


def _run_threads(jobs: int, count: int, contexts: Contexts,
                 work: Callable[[Context, int, int], None]) -> None:
    lock, stop = threading.Lock(), threading.Event()
    starts = iter(range(0, count, PIECE))
    failures: List[BaseException] = []
    used: List[Context] = []

    def take_pieces(ended: threading.Event) -> None:
        try:
            used.append(contexts.mine())
            while not stop.is_set():
                with lock:
                    first = next(starts, None)
                if first is None:
                    return
                work(contexts.mine(), first, min(PIECE, count - first))
        except BaseException as failure:
            failures.append(failure)
            end_calls()
        finally:
            ended.set()

    def end_calls() -> None:
        stop.set()
        for context in used:
            context.stop()

    ends = [threading.Event() for _ in range(jobs)]
    threads = [threading.Thread(target=take_pieces, args=(end,), daemon=True) for end in ends]
    try:
        for thread in threads:
            thread.start()
        # An interrupted join may take its thread for ended (Python before 3.13); an event does not.
        for end in ends:
            while not end.wait(TURN):
                pass
    finally:
        end_calls()
        for thread, end in zip(threads, ends):
            if thread.ident is not None:
                end.wait()
                thread.join()
    if failures:
        raise failures[0]
