#!/usr/bin/env python3
"""Runs codes over scenes of the benchmark, scores what they say, and prints the table of results.

    python3 cases/benchmark/codes.py --graze build/graze OUT [--codes NAME[:K],...] [--rows N] [NAME...]

OUT is what golden.py made; all scenes there, or those that are named. Programs are compiled into OUT/programs. A code
that is not installed is skipped, and it says so; one that fails on a scene is in the table with its reason. OUT/results.jsonl
gets a line for each code, setting and scene: what score.py says, with code, setting, version, command and CPU seconds, or
`failure`. What is done is not done again while inputs and programs are the same. --list names the codes.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import hashlib
import itertools
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time

from catalogue import CODES, chosen
from standings import distances, failures, table
from tables import STATUS_BAD_INPUT, BadInput, read_scene, read_text

HERE = os.path.dirname(os.path.abspath(__file__))
SCORE = os.path.join(HERE, "score.py")
MEMORY = 8 << 30  # bytes of address space of a run
PATIENCE = 6      # times the limit of CPU seconds that a run may last by the clock
SCENE = ("solid.off", "motion.json", "points.csv")


# ------------------------------------------------------------------------------------------------ running
def digest(paths, *words):
    """One hash of files and words."""
    found = hashlib.sha256(json.dumps(words).encode())
    for path in paths:
        with open(path, "rb") as file:
            found.update(hashlib.sha256(file.read()).digest())
    return found.hexdigest()


class Failure(Exception):
    """Why a code has no answer; the message is the table's."""


def run_limited(command, limit, folder):
    """The CPU seconds of a command and its children, in a folder of its own; raises Failure."""
    def bound():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 2))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    said = os.path.join(folder, "said.txt")
    with open(said, "wb") as file:
        child = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=file, stderr=file, start_new_session=True, preexec_fn=bound)
        late = threading.Timer(PATIENCE * limit, os.killpg, (child.pid, signal.SIGKILL))
        start = time.monotonic()
        late.start()
        try:
            _, status, usage = os.wait4(child.pid, 0)
        except BaseException:
            os.killpg(child.pid, signal.SIGKILL)
            raise
        finally:
            late.cancel()
    seconds, status = usage.ru_utime + usage.ru_stime, os.waitstatus_to_exitcode(status)
    child.returncode = status
    if status:
        late = status in (-signal.SIGXCPU, 128 + signal.SIGXCPU) or seconds >= limit or time.monotonic() - start >= PATIENCE * limit
        raise Failure(f"more than {limit} s" if late else reason(status, said))
    return seconds


def reason(status, said):
    """Words for the end of a program; a script says 128 more than the signal that ended its child."""
    number = -status if status < 0 else status - 128
    if number in signal.valid_signals():
        return f"ended by {signal.Signals(number).name}"
    with open(said, encoding="utf-8", errors="replace") as file:
        lines = file.read().strip().splitlines()
    return f"status {status}: {lines[-1][:100] if lines else 'without a word'}"


# ------------------------------------------------------------------------------------------------ scenes
def shortened(source, folder, rows):
    """A folder with the first rows of a scene."""
    os.makedirs(folder)
    for name in os.listdir(source):
        path = os.path.join(source, name)
        if name in ("points.csv", "golden.csv"):
            with open(path, encoding="ascii") as old, open(os.path.join(folder, name), "w", encoding="ascii") as new:
                heads = (line for line in old if not line.startswith("#"))
                new.writelines(itertools.islice(heads, rows + 1))
        elif os.path.isfile(path):
            os.symlink(path, os.path.join(folder, name))
    return folder


class Runner:
    """Runs one code at one setting on one scene after another."""

    def __init__(self, options, folder):
        self.options, self.folder, self.programs = options, folder, os.path.join(options.out, "programs")
        os.makedirs(self.programs, exist_ok=True)

    def command(self, code, setting, program, folder, out):
        _, parameter, poses = setting
        names = {name.split(".")[0]: os.path.join(folder, name) for name in SCENE}
        names |= {"poses": os.path.join(folder, f"poses-{poses}.csv"), "program": program, "parameter": parameter, "out": out,
                  "graze": self.options.graze}
        return [word.format(**names) for word in code.command]

    def answer(self, code, setting, program, folder, scene):
        """What score.py says, and the seconds that the code took."""
        lack = code.lacks(folder, scene)
        if lack:
            raise Failure(lack)
        with tempfile.TemporaryDirectory() as work:
            out = os.path.join(work, "out" + code.ending)
            seconds = run_limited(self.command(code, setting, program, folder, out), self.options.limit, work)
            if not os.path.exists(out):
                raise Failure("nothing was written")
            command = [sys.executable, SCORE, "--graze", self.options.graze, "--budget", str(self.options.budget), folder, out]
            done = subprocess.run(command + (["--poses", setting[2]] if setting[2] else []), check=False, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True)
        if done.returncode:
            raise Failure(done.stderr.strip().replace(work + os.sep, "")[:200])
        return json.loads(done.stdout) | {"seconds": round(seconds, 2)}

    def line(self, code, setting, program, version, name):
        """The line of results; kept in the scene's folder, and read from there while nothing has changed."""
        source = os.path.join(self.options.out, name)
        scene, folder = read_scene(source), source
        if self.options.rows:
            folder = os.path.join(self.folder, name)
            if not os.path.isdir(folder):
                shortened(source, folder, self.options.rows)
        inputs = [os.path.join(folder, file) for file in (*SCENE, "golden.csv", *([f"poses-{setting[2]}.csv"] if setting[2] else ()))]
        key = digest([*inputs, *code.sources, SCORE], setting, code.command[1:], version, self.options.limit, self.options.budget)
        kept = os.path.join(source, "codes", f"{code.name}-{code.settings.index(setting)}.json")
        if os.path.exists(kept):
            found = json.loads(read_text(kept))
            if found["key"] == key:
                return found["line"]
        head = {"code": code.name, "setting": setting[0], "version": version, "command": code.told(), "scene": name,
                "family": scene["family"], "diagonal": scene["diagonal"]}
        try:
            found = head | self.answer(code, setting, program, folder, scene)
        except Failure as failure:
            found = head | {"candidate": code.name, "failure": str(failure)}
        os.makedirs(os.path.dirname(kept), exist_ok=True)
        with open(kept, "w", encoding="utf-8") as file:
            json.dump({"key": key, "line": found}, file)
        return found

    def run(self, codes, names):
        """Lines of all codes, settings and scenes."""
        lines = []
        for code in codes:
            if not code.there():
                print(f"{code.name} is left out: {code.installed} is not there", file=sys.stderr)
                continue
            program, version = code.compile(self.programs), code.version(self.options.graze)
            for setting, name in itertools.product(code.asked or code.settings, names):
                lines.append(self.line(code, setting, program, version, name))
                tell(f"{code.name}, {setting[0]}, {name}: {lines[-1].get('failure', 'scored')}")
        return lines


def tell(text):
    if sys.stderr.isatty():
        print(f"\r\033[K{text[:110]}", end="", file=sys.stderr, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--codes", help="some of them, with commas between; NAME:K is the setting K of it alone")
    parser.add_argument("--limit", type=int, default=120, help="CPU seconds of a code on a scene (120)")
    parser.add_argument("--rows", type=int, help="the first golden rows of a scene alone")
    parser.add_argument("--budget", type=int, default=10 ** 5, help="of `graze judge` for meshes (100000)")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("out", metavar="OUT", nargs="?")
    parser.add_argument("names", metavar="NAME", nargs="*")
    options = parser.parse_intermixed_args()
    if options.list:
        print("".join(f"{code.name}:{k}\t{setting[0]}\n" for code in CODES for k, setting in enumerate(code.settings, 1)), end="")
        return
    if not options.out or options.limit < 1 or options.rows is not None and options.rows < 1:
        parser.error("expected OUT; --limit and --rows from 1 up")
    options.graze, options.out = os.path.abspath(options.graze), os.path.abspath(options.out)
    codes = chosen(options.codes) if options.codes else CODES
    names = options.names or sorted(name for name in os.listdir(options.out) if os.path.exists(os.path.join(options.out, name, "golden.csv")))
    with tempfile.TemporaryDirectory() as folder:
        lines = Runner(options, folder).run(codes, names)
    with open(os.path.join(options.out, "results.jsonl"), "w", encoding="utf-8") as file:
        file.writelines(json.dumps(line, ensure_ascii=False) + "\n" for line in lines)
    print(table(lines) + distances(lines) + failures(lines), end="")


if __name__ == "__main__":
    try:
        main()
    except (BadInput, OSError) as error:
        print(f"codes.py: {error}", file=sys.stderr)
        sys.exit(STATUS_BAD_INPUT)
