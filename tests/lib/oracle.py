"""CGAL's programs beside the tests, and FCL's: their answers as recorded tables, or asked anew.

A program of these takes minutes to compile and answers always the same, so its answers to a suite are recorded in
tests/oracles/FOLDER-SUITE.PROGRAM.jsonl.xz: JSON Lines, first what the table is of, the hash of the program's sources too, then a row for
each input, by the input's hash. A suite that asks for an input without a row fails, and so does one whose table is of other sources.
GRAZE_ORACLES=anew builds the program, asks it, and compares its answers with those that are recorded; GRAZE_ORACLES=record writes them.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import contextlib
import fcntl
import hashlib
import json
import lzma
import os
import platform
import re
import subprocess
import sys
import tempfile
from types import SimpleNamespace

from harness import ROOT, Checks, bounded, run

SOURCES = {"minkowski": "tests/agree/minkowski.cpp", "to_nef": "tests/agree/to_nef.cpp", "distances": "tests/distance/oracle.cpp",
           "pairs": "tests/collide/oracle.cpp", "places": "tests/rest/oracle.cpp", "fcl": "cases/candidates/fcl.cpp"}
TARGETS = {"fcl": "bench/fcl"}  # else of the program's name
FOLDER = os.path.join(ROOT, "tests", "oracles")
VERSIONS = {"CGAL": ("/usr/include/CGAL/version.h", "define CGAL_VERSION (.*)"), "FCL": ("/usr/include/fcl/config.h", 'define FCL_VERSION "(.*)"')}
INCLUDED = re.compile(r'^#include "(.*)"', re.M)

Answer = collections.namedtuple("Answer", "status text")  # the text is empty if the status is not 0


def sources(path):
    """The paths of a source and of the headers of the tests that it includes."""
    found, left = [], [os.path.normpath(path)]
    while left:
        path = left.pop()
        if path not in found:
            found.append(path)
            with open(os.path.join(ROOT, path), encoding="utf-8") as file:
                left += [os.path.normpath(os.path.join(os.path.dirname(path), name)) for name in INCLUDED.findall(file.read())]
    return sorted(found)


def hash_of_sources(program):
    digest = hashlib.sha256()
    for path in sources(SOURCES[program]):
        with open(os.path.join(ROOT, path), "rb") as file:
            content = file.read()
        digest.update(f"{path} {len(content)}\n".encode() + content)
    return digest.hexdigest()


def hash_of_input(text, as_file):
    return hashlib.sha256(f"{'file' if as_file else 'text'}\n{text}".encode()).hexdigest()[:32]


def maker(program):
    """The library's version and the machine: of others an answer may have another form."""
    library = "FCL" if program == "fcl" else "CGAL"
    path, pattern = VERSIONS[library]
    with open(path, encoding="utf-8") as file:
        return f"{library} {re.search(pattern, file.read())[1]}, {platform.machine()}"


def read(path):
    """The head of a table and its answers, {hash of the input: Answer}."""
    with lzma.open(path, "rt", encoding="utf-8") as file:
        head, *rows = map(json.loads, file)
    return head, {row["input"]: Answer(row["status"], row["answer"]) for row in rows}


def write(path, head, rows):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    lines = [head, *({"input": key, "status": answer.status, "answer": answer.text} for key, answer in rows.items())]
    with lzma.open(path + ".new", "wt", preset=9 | lzma.PRESET_EXTREME, encoding="utf-8", newline="\n") as file:
        file.writelines(json.dumps(line) + "\n" for line in lines)
    os.replace(path + ".new", path)


def build(program):
    """The path of the program, built if its sources have changed; by one suite at a time."""
    target = os.path.join("build", "tests", TARGETS.get(program, program))
    os.makedirs(os.path.join(ROOT, "build", "tests"), exist_ok=True)
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("MAKE", "MFLAGS"))}
    with open(os.path.join(ROOT, target + ".lock"), "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        subprocess.run(bounded(["make", "-s", "-C", ROOT, target]), env=kept, stdout=subprocess.DEVNULL, check=True)
    return os.path.join(ROOT, target)


class Oracle:
    """A program that a suite asks. Ends the suite if the table is missing or of other sources."""

    def __init__(self, args, checks, program, suite=None):
        self.args, self.checks, self.program = args, checks, program
        self.suite = suite or os.path.relpath(os.path.abspath(sys.argv[0]), os.path.join(ROOT, "tests"))[:-len(".py")]
        self.path = os.path.join(FOLDER, f"{self.suite.replace('/', '-')}.{program}.jsonl.xz")
        self.shown = os.path.relpath(self.path, ROOT)
        self.mode = os.environ.get("GRAZE_ORACLES", "")
        self.head = {"program": SOURCES[program], "source": hash_of_sources(program), "seed": args.seed, "scale": str(args.scale)}
        self.tool, self.recorded, self.asked, self.same_form = None, {}, {}, False
        if self.mode not in ("", "anew", "record"):
            self.end(f"GRAZE_ORACLES={self.mode}; expected anew or record")
        if self.mode == "record" and not self.whole():
            self.end("GRAZE_ORACLES=record; expected a run at scale 1 from the beginning")
        if self.mode != "record":
            self.load()
        if self.mode:
            self.head["made by"] = maker(program)
            self.same_form = self.mode == "anew" and self.head["made by"] == self.recorded_head["made by"]
            self.tool = build(program)

    def whole(self):
        return self.args.scale == 1 and self.args.derived

    def end(self, *what):
        self.checks.fail(*what)
        self.checks.finish()

    def to_record(self):
        return f"`GRAZE_ORACLES=record python3 tests/{self.suite}.py` compiles CGAL's program for a minute and records its answers"

    def load(self):
        if not os.path.exists(self.path):
            self.end(f"{self.shown} is missing: {self.to_record()}")
        self.recorded_head, self.recorded = read(self.path)
        if self.recorded_head["source"] != self.head["source"]:
            self.end(f"{self.shown} is of another {' or '.join(sources(SOURCES[self.program]))} than is here: {self.to_record()}")

    def ask(self, text, seconds=600, as_file=False, one_form=True):
        """The program's answer to a text on standard input, or None after a failed check. With `as_file` its argument is a file, whose
        text is the answer. An answer that may have `one_form` alone is compared whatever CGAL has made it."""
        key = hash_of_input(text, as_file)
        recorded = self.recorded.get(key)
        if not self.tool:
            self.asked[key] = recorded
            if recorded is None:
                head = self.recorded_head
                self.checks.fail(f"{self.shown} has no answer to an input (seed {self.args.seed}, scale {self.args.scale}; recorded: seed "
                                 f"{head['seed']}, scale {head['scale']}): does graze, whose answers some inputs hang on, answer as before? "
                                 f"{self.to_record()}; GRAZE_ORACLES=anew, needed for another seed or scale, asks it alone", text[:300])
            return recorded
        answer = self.asked[key] = self.answer(text, seconds, as_file)
        if recorded and (one_form or self.same_form):
            self.checks.equal(recorded, answer, f"{self.shown}: what is recorded is not what CGAL answers to", text[:300])
        return answer

    def answer(self, text, seconds, as_file):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "answer")
            out = run(bounded([self.tool, *([file] if as_file else [])]), seconds, input=text)
            if out.returncode or not as_file:
                return Answer(out.returncode, "" if out.returncode else out.stdout)
            with open(file, encoding="utf-8") as answer:
                return Answer(0, answer.read())

    def finish(self):
        """To be called when all has been asked: the table is written, or has no row that nobody asks for."""
        if self.mode == "record" and not self.checks.failed:
            write(self.path, self.head, self.asked)
            print(f"{self.shown}: {len(self.asked)} answers, {os.path.getsize(self.path)} bytes")
        elif self.mode == "record":
            self.checks.fail(f"{self.shown} is not recorded, as checks have failed")
        elif self.whole() and self.args.seed == self.recorded_head["seed"] and not self.checks.failed:
            self.checks.equal(set(self.recorded) - set(self.asked), set(), f"{self.shown}: rows that nobody asks for; {self.to_record()}")


def stand_in(path, suite, program):
    """Write a program that answers as CGAL's does, by the table of a suite that asks it once."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"#!{sys.executable}\nimport sys\nsys.path.insert(0, {os.path.dirname(os.path.abspath(__file__))!r})\n"
                   f"import oracle\noracle.answer_once({suite!r}, {program!r})\n")
    os.chmod(path, 0o755)


def answer_once(suite, program):
    checks = Checks()
    with contextlib.redirect_stdout(sys.stderr):
        one = Oracle(SimpleNamespace(seed=0, scale=1, derived=True), checks, program, suite)
        answer = one.ask(sys.stdin.read())
        one.finish()
    if answer:
        sys.stdout.write(answer.text)
    sys.exit(1 if checks.failed else answer.status)
