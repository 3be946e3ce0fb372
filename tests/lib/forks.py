"""Runs of a program that starts once a suite and forks for each run (tests/lib/forks.c): a start costs a sixth of one by exec,
and less with sanitizers, where all that a library does before main is counted.

A process is a child of the suite, as one by exec is. harness.run says which runs go this way.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import array
import atexit
import functools
import os
import select
import signal
import socket
import struct
import subprocess
import threading
import time

# Variables that a program reads before its main: a run with other values belongs to another server.
BEFORE_MAIN = ("ASAN_OPTIONS", "LSAN_OPTIONS", "UBSAN_OPTIONS", "LLVM_PROFILE_FILE", "GCOV_PREFIX", "GCOV_PREFIX_STRIP",
               "GLIBC_TUNABLES", "LD_LIBRARY_PATH")
HERE = os.path.dirname(os.path.abspath(__file__))
MOST = 1 << 17      # bytes of words, as forks.c has it
PIPE = 1 << 16      # bytes at a time


class Server:
    """One program, started; `start` may be called by several threads."""

    def __init__(self, program, library, environment):
        self.lock, self.owner = threading.Lock(), os.getpid()
        self.socket, theirs = socket.socketpair()
        with theirs:
            self.process = subprocess.Popen(
                [program], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, pass_fds=[theirs.fileno()],
                env={**environment, "LD_PRELOAD": library, "LD_BIND_NOW": "1", "GRAZE_FORKS": str(theirs.fileno())})
        atexit.register(self.end)

    def start(self, arguments, words, files):
        """The number of a new process, whose arguments are the first `arguments` of the words, with these descriptors;
        ChildProcessError if the server has ended."""
        message = struct.pack("=II", len(words), arguments) + words
        with self.lock:
            try:
                sent = self.socket.sendmsg([message], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, array.array("i", files))])
                self.socket.sendall(message[sent:])
                reply = self.socket.recv(4)
            except (BrokenPipeError, ConnectionResetError):
                reply = b""
        if len(reply) < 4:
            raise ChildProcessError
        number, = struct.unpack("=i", reply)
        if number < 0:
            raise OSError(-number, os.strerror(-number))
        return number

    def end(self):
        if self.owner == os.getpid():
            self.socket.close()
            self.process.wait()


programs = {}       # path -> the library in front of its main
servers = {}        # (path, process, values of BEFORE_MAIN) -> Server
lock = threading.Lock()


def serve(graze):
    """From now on runs of graze, and of graze-check beside it, are forked if they can be."""
    for folder in (os.path.dirname(graze), os.path.join(HERE, "..", "..", "build")):
        library = os.path.abspath(os.path.join(folder, "tests", "forks.so"))
        if os.path.exists(library) and os.environ.get("GRAZE_EXEC") != "1":
            programs.update({path: library for path in (graze, graze + "-check", os.path.join(os.path.dirname(graze), "graze-check"))
                             if is_program(path)})
            break


def is_program(path):
    """Is there one, and no script, whose main would be that of the shell?"""
    try:
        with open(path, "rb") as file:
            return file.read(4) == b"\x7fELF" and os.access(path, os.X_OK)
    except OSError:
        return False


def server_of(program, environment):
    key = program, os.getpid(), *map(environment.get, BEFORE_MAIN)
    with lock:
        if key not in servers:
            servers[key] = Server(program, programs[program], environment)
        return servers[key]


def files_of(more):
    """Descriptors for standard input, output and error, None for a pipe; no tuple if they are none that can be passed."""
    asked = (subprocess.PIPE if more.get("input") is not None else more.get("stdin", subprocess.DEVNULL),
             more.get("stdout", subprocess.PIPE), more.get("stderr", subprocess.PIPE))
    if subprocess.STDOUT in asked or (asked[0] == subprocess.PIPE) != (more.get("input") is not None):
        return None
    return tuple(None if file == subprocess.PIPE else null() if file == subprocess.DEVNULL else
                 k if file is None else file if isinstance(file, int) else file.fileno() for k, file in enumerate(asked))


@functools.lru_cache
def null():
    return os.open(os.devnull, os.O_RDWR)


def run(command, seconds, text, more):
    """The result of harness.run, from a forked run; None if it cannot be forked."""
    environment, files = os.environ if more.get("env") is None else more["env"], files_of(more)
    if command[0] not in programs or not seconds or not files or "LD_PRELOAD" in environment:
        return None
    until, given = time.monotonic() + seconds, more.get("input")
    try:
        process = Process(server_of(command[0], environment), command, environment, more.get("cwd") or ".", files)
    except TooLong:
        return None
    except ChildProcessError:
        if programs.pop(command[0], None):
            print(f"note: {command[0]} does not fork, its runs are by exec")
        return None
    try:
        got, in_time = process.talk(given.encode() if text and given else given, until)
    finally:
        process.end()
    if text:
        got = [None if part is None else part.decode("utf-8", "replace").replace("\r\n", "\n").replace("\r", "\n") for part in got]
    if not in_time:
        raise subprocess.TimeoutExpired(command, seconds, *got)
    return subprocess.CompletedProcess(command, process.status, *got)


class TooLong(Exception):
    """More words than the server takes, but perhaps not too many for exec."""


class Process:
    """One run, with pipes for what it writes unless `files` has descriptors for it; `end` must be called."""

    def __init__(self, server, command, environment, folder, files):
        words = [*map(os.fsencode, command), *(os.fsencode(name) + b"=" + os.fsencode(value) for name, value in environment.items())]
        text = b"\0".join(words) + b"\0"
        if text.count(b"\0") != len(words):
            raise ValueError("embedded null byte")
        if len(text) > MOST:
            raise TooLong
        self.open, self.status, self.number = [], None, 0
        try:
            self.ends = [self.pipe(k) if file is None else (None, file) for k, file in enumerate(files)]
            self.open.append(os.open(folder, os.O_PATH | os.O_DIRECTORY))
            theirs = [*(file for _, file in self.ends), self.open[-1]]
            self.number = server.start(len(command), text, theirs)
        except BaseException:
            self.end()
            raise
        for own, file in self.ends:
            if own is not None:
                self.close(file)
        self.close(theirs[-1])

    def pipe(self, k):
        """(our end, its end) of a pipe for the descriptor k."""
        read, write = os.pipe()
        self.open += [read, write]
        return (write, read) if k == 0 else (read, write)

    def close(self, file):
        self.open.remove(file)
        os.close(file)

    def talk(self, given, until):
        """Write `given`, read all that the run writes, and wait for its end: (output, errors), and whether that was in time."""
        poll, got, left = select.poll(), {}, memoryview(given or b"")
        for k, (own, _) in enumerate(self.ends):
            if own is not None and k:
                got[own] = []
                poll.register(own, select.POLLIN)
        feed = self.ends[0][0]
        if feed is not None:
            os.set_blocking(feed, False)
            poll.register(feed, select.POLLOUT)
        waited = len(got) + (feed is not None)
        while waited:
            seconds = until - time.monotonic()
            events = poll.poll(seconds * 1000) if seconds > 0 else []
            if not events:
                break
            for file, _ in events:
                if file == feed:
                    left = left[write(feed, left):]
                    part = left
                else:
                    part = os.read(file, PIPE)
                    got[file].append(part)
                if not part:
                    poll.unregister(file)
                    self.close(file)
                    waited -= 1
        in_time = not waited and self.wait(until)
        return [b"".join(got[own]) if own in got else None for own, _ in self.ends[1:]], in_time

    def wait(self, until):
        """Whether it ends in time."""
        if not self.reap(os.WNOHANG):
            ended = os.pidfd_open(self.number)
            try:
                if select.select([ended], [], [], max(0, until - time.monotonic()))[0]:
                    self.reap(0)
            finally:
                os.close(ended)
        return self.status is not None

    def reap(self, how):
        number, status = os.waitpid(self.number, how)
        if number:
            self.status = os.waitstatus_to_exitcode(status)
        return number

    def end(self):
        """Kill it if it still runs, and close our ends."""
        if self.number and self.status is None:
            os.kill(self.number, signal.SIGKILL)
            self.reap(0)
        while self.open:
            os.close(self.open.pop())


def write(file, data):
    """The number of bytes that a pipe has taken; all of them if nobody reads the pipe."""
    try:
        return os.write(file, data[:PIPE])
    except BrokenPipeError:
        return len(data)
