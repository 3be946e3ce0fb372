"""How the measurements are taken: programs that answer line by line, the command line under load, medians.

Invariant: both sides of a ratio are measured in turns, on the same points, fresh ones in every repeat; times
are CPU seconds unless a name says wall.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import array
import os
import select
import statistics
import subprocess
import threading
import time

PATIENCE = 1800  # seconds that no single answer may exceed


class Server:
    """A program that answers each line of its input by one line `key=value ...`."""

    def __init__(self, *command):
        self.command = command
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.ready = self._answer("start")

    def _answer(self, question):
        ready, _, _ = select.select([self.process.stdout], [], [], PATIENCE)
        line = self.process.stdout.readline() if ready else ""
        if not line:
            self.process.kill()
            raise SystemExit(f"{' '.join(self.command)}: no answer to: {question}")
        return {key: float(value) for key, value in (word.split("=") for word in line.split())}

    def ask(self, *words):
        question = " ".join(map(str, words))
        self.process.stdin.write(question + "\n")
        self.process.stdin.flush()
        return self._answer(question)

    def close(self):
        self.process.stdin.close()
        self.process.wait()


class Stream:
    """`graze classify` on its standard input. Rows are answered in blocks, each flushed, so that the CPU time
    between two whole blocks is that of reading, answering and printing their rows, and loading is left out."""
    BLOCK = 1024

    def __init__(self, graze, solid, motion, *flags):
        self.process = subprocess.Popen([graze, "classify", "--jobs", "1", *flags, solid, motion, "-"],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self.columns = 1  # the line of column names is still to come

    def cpu(self):
        spent = 0
        folder = f"/proc/{self.process.pid}/task"
        for task in os.listdir(folder):
            with open(f"{folder}/{task}/schedstat", encoding="ascii") as file:
                spent += int(file.read().split()[0])
        return spent / 1e9

    def _feed(self, text):
        while text:
            text = text[self.process.stdin.write(text):]

    def _await(self, wanted):
        """Read until `wanted` lines that are not `#` lines have come."""
        tail = b""
        while wanted > 0:
            ready, _, _ = select.select([self.process.stdout], [], [], PATIENCE)
            data = os.read(self.process.stdout.fileno(), 1 << 16) if ready else b""
            if not data:
                self.process.kill()
                raise SystemExit("graze classify wrote fewer rows than it was fed")
            *lines, tail = (tail + data).split(b"\n")
            wanted -= sum(not line.startswith(b"#") for line in lines)

    def rows(self, lines):
        """CPU seconds for the lines, whole blocks of them."""
        if len(lines) % self.BLOCK:
            raise ValueError("rows are fed in whole blocks")
        start = self.cpu()
        feeder = threading.Thread(target=self._feed, args=("".join(lines).encode(),), daemon=True)
        feeder.start()
        self._await(len(lines) + self.columns)
        self.columns = 0
        feeder.join()
        return self.cpu() - start

    def fitting(self, lines, target, repeats):
        """How many rows, in whole blocks, take `target` seconds; `lines` must last for all repeats."""
        self.rows(lines[:self.BLOCK])
        blocks = int(target / self.rows(lines[:self.BLOCK]))
        return max(1, min(len(lines) // self.BLOCK // repeats, blocks)) * self.BLOCK

    def close(self):
        self.process.stdin.close()
        while os.read(self.process.stdout.fileno(), 1 << 16):
            pass
        self.process.wait()


def run_cpu(command):
    """CPU and wall seconds of one run."""
    start = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"{' '.join(command)}: exit status {process.returncode}")
    return usage.ru_utime + usage.ru_stime, time.perf_counter() - start


def run_wall(commands):
    """Wall seconds until all of the commands, started together, have ended."""
    start = time.perf_counter()
    running = [subprocess.Popen(command, stdout=subprocess.DEVNULL) for command in commands]
    for process in running:
        if process.wait():
            raise SystemExit(f"{' '.join(process.args)}: exit status {process.returncode}")
    return time.perf_counter() - start


def fitting(ask, most, target):
    """How many points take `target` seconds, at most `most`. `ask(start, n)` gives seconds."""
    n = 20
    for _ in range(2):
        spent = ask(0, n)
        n = max(20, min(most, int(n * target / max(spent, 1e-9))))
    return n


def in_turns(first, second, total, target, repeats):
    """Medians of both sides' seconds a point and of their ratio first / second, and points a repeat.

    `first` and `second` are functions (start, n) -> seconds over the same `total` points."""
    n = fitting(first, total // repeats, target)
    pairs = [(first(r * n, n) / n, second(r * n, n) / n) for r in range(repeats)]
    return (statistics.median(a for a, _ in pairs), statistics.median(b for _, b in pairs),
            statistics.median(a / b for a, b in pairs), n)


def same_numbers(one, other):
    """How many of the 64-bit integers in two files agree, and how many there are."""
    lists = []
    for path in (one, other):
        numbers = array.array("q")
        with open(path, "rb") as file:
            numbers.frombytes(file.read())
        lists.append(numbers)
    return sum(a == b for a, b in zip(*lists)), max(map(len, lists))
