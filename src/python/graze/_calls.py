"""Calls of the library that a signal ends at once.

Python runs the handlers of signals in the main thread between two steps of its own, so a call made
there would delay Ctrl-C to its end. The main thread therefore has long calls made by a thread that
waits for them, and ends one through its context's cancel callback when a handler raises.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import os
import queue
import sys
import threading
from typing import Any, Callable, Optional, Tuple

from .errors import CanceledError

_ENDLESS = 2**31 - 1  # questions of a call; the main thread ends it by setting 0
_BRIEF = 8  # questions: one for each point, and one for some milliseconds of exact arithmetic
_CANCELED = CanceledError.status
# Seconds after which a wait of the main thread lets handlers run: one that is due in the instant before a wait
# begins would else run at its end.
TURN = 0.1


class Countdown:
    """The int that the cancel callback of a context counts down: 0 ends the call."""

    def __init__(self) -> None:
        self.left, self._stopped = ctypes.c_int(0), False

    def begin(self, questions: int) -> None:
        self.left.value = questions
        if self._stopped:  # perhaps since the line before
            self.left.value = 0

    def stop(self) -> None:
        """End the call that another thread makes, and those that follow."""
        self._stopped = True
        self.left.value = 0


class _Task:
    """One call, its status or failure, and a lock that is held until it has ended."""

    def __init__(self, function: Callable[..., int], arguments: Tuple[Any, ...]) -> None:
        self.function, self.arguments = function, arguments
        self.status = 0
        self.failure: Optional[BaseException] = None
        self.running = threading.Lock()
        self.running.acquire()

    def run(self) -> None:
        try:
            self.status = self.function(*self.arguments)
        except BaseException as failure:
            self.failure = failure
        self.running.release()


_tasks: "queue.SimpleQueue[_Task]" = queue.SimpleQueue()
_caller: Optional[threading.Thread] = None


def _make_calls() -> None:
    while True:
        _tasks.get().run()


def _forget_caller() -> None:
    """A child of fork has none of its parent's threads."""
    global _caller, _tasks
    _caller, _tasks = None, queue.SimpleQueue()


os.register_at_fork(after_in_child=_forget_caller)


def call(countdown: Countdown, function: Callable[..., int], *arguments: Any, brief: bool) -> int:
    """The status of function(*arguments), which the countdown may end.

    What the handler of a signal raises meanwhile ends the call and is raised here.

    Args:
        brief: the call most often takes less than a thread's turn and may be made twice: it is
            begun here, and given to the other thread only when it takes long.
    """
    global _caller
    countdown.begin(_ENDLESS)
    if threading.current_thread() is not threading.main_thread() or sys.is_finalizing():
        return function(*arguments)
    if brief:
        countdown.begin(_BRIEF)
        status = function(*arguments)
        if status != _CANCELED:
            return status
        countdown.begin(_ENDLESS)
    if _caller is None:
        _caller = threading.Thread(target=_make_calls, name="graze calls", daemon=True)
        _caller.start()
    task = _Task(function, arguments)
    try:
        _tasks.put(task)
        while not task.running.acquire(timeout=TURN):
            pass
    except BaseException:
        _end_all(countdown.left)
        raise
    if task.failure is not None:
        raise task.failure
    return task.status


def _end_all(left: ctypes.c_int) -> None:
    """Cancel what runs and wait until the queue is empty: the arguments may then go."""
    last = _Task(lambda: 0, ())
    _tasks.put(last)
    while True:
        left.value = 0
        try:
            last.running.acquire()
            return
        except BaseException:  # a second Ctrl-C: the end is near
            continue
