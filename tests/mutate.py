#!/usr/bin/env python3
"""Mutation test of the code that decides contacts, counts and classes.

Every comparison, logical connective and sign in the files below is changed, one at a time, in a copy of the tree; the copy
is rebuilt and the suites below are run until one goes red. A mutant that no suite notices is an error unless
tests/mutants.txt lists it with the reason why it is equivalent. `--sample K/N` takes every N-th mutant from K on.
"""
import argparse
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

FILES = [
    "src/verdict/verdict.c", "src/trace/trace.c", "src/trace/contact.c", "src/trace/touch.c",
    "src/trace/time.c", "src/trace/trajectory.c", "src/trace/search.c", "src/solid/locate.c",
    "src/solid/solid.c", "src/solid/forms.c", "src/solid/tree.c", "src/number/algebraic.c",
    "src/number/isolate.c", "src/number/bernstein.c", "src/number/modular.c",
    "src/number/refine.c", "src/number/wide.c",
]
UNITS = [f"{{b}}/tests/unit/test_{name}" for name in ("algebraic", "modular", "bernstein", "refine")]
SUITES = [
    *([unit] for unit in UNITS),
    [sys.executable, "tests/examples/examples.py", "--graze", "{b}/graze"],
    [sys.executable, "tests/agree/near.py", "--graze", "{b}/graze"],
    [sys.executable, "tests/cases/cases.py", "--graze", "{b}/graze"],
    [sys.executable, "tests/agree/second_tracer.py", "--graze", "{b}/graze"],
    [sys.executable, "tests/agree/laws.py", "--graze", "{b}/graze"],
    [sys.executable, "tests/refuse/run.py", "--graze", "{b}/graze"],
    [sys.executable, "tests/words/words.py", "--graze", "{b}/graze"],
]
# A token and what it becomes. Two variants for an order: its negation, and its boundary moved.
SWAPS = {
    "<": [">=", "<="], "<=": [">", "<"], ">": ["<=", ">="], ">=": ["<", ">"], "==": ["!="],
    "!=": ["=="], "&&": ["||"], "||": ["&&"], " + ": [" - "], " - ": [" + "],
    "fmpz_sgn(": ["-fmpz_sgn("], "fmpq_sgn(": ["-fmpq_sgn("], "-1": ["1"], "_neg(": ["_set("],
}
TOKEN = re.compile(r'/\*.*?\*/|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|#[^\n]*|->|<<|>>|\+\+|--|'
                   r'fmpz_sgn\(|fmpq_sgn\(|fmp[zq]_(?:poly_)?neg\(|'
                   r'<=|>=|==|!=|&&|\|\||<|>| \+ | - |(?<=[ (])-1(?![0-9a-zA-Z.])', re.S)


def mutants(path):
    """(line number, line text, what, mutated source) for every change in a file."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for match in TOKEN.finditer(text):
        token = match.group()
        key = "_neg(" if token.endswith("neg(") else token
        for new in SWAPS.get(key, []):
            changed = token.replace("neg(", "set(") if key == "_neg(" else new
            line = text.count("\n", 0, match.start()) + 1
            start = text.rfind("\n", 0, match.start()) + 1
            source_line = text[start:text.find("\n", start)].strip()
            column = match.start() - start
            yield (line, source_line, f"{token.strip()} -> {changed.strip()} at {column}",
                   text[:match.start()] + changed + text[match.end():])


def known_equivalents():
    """{(path, line text, what)} of tests/mutants.txt: three lines a mutant, then its reason."""
    known = set()
    with open("tests/mutants.txt", encoding="utf-8") as file:
        blocks = file.read().split("\n\n")
    for block in blocks:
        lines = [l for l in block.splitlines() if not l.startswith("#")]
        if len(lines) >= 4:
            known.add((lines[0], lines[1].strip(), lines[2]))
    return known


def bound_memory():
    """Some mutants never stop asking for memory. The suites themselves hold the program to 4 GiB."""
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))


def is_killed(copy, build, log, limit):
    make = ["make", "-s", f"B={build}", f"{build}/graze", *(unit.format(b=build) for unit in UNITS),
            "WARN=-w"]
    if subprocess.run(make, cwd=copy, stdout=log, stderr=log).returncode != 0:
        return "does not compile"
    for parts in SUITES:
        command = [part.format(b=build) for part in parts]
        suite = subprocess.Popen(command, cwd=copy, stdout=log, stderr=log,
                                 stdin=subprocess.DEVNULL, preexec_fn=bound_memory,
                                 start_new_session=True)
        try:
            status = suite.wait(limit)
        except subprocess.TimeoutExpired:
            # A mutant may loop for ever: end it with the suite that started it.
            os.killpg(suite.pid, signal.SIGKILL)
            suite.wait()
            return f"too slow: {command[1] if len(command) > 1 else command[0]}"
        if status != 0:
            return command[1] if len(command) > 1 else command[0]
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sample", default="0/1", help="K/N: every N-th mutant from K on")
    parser.add_argument("--only", default="", help="only files whose path holds this")
    parser.add_argument("--limit", type=float, default=120, help="seconds for one suite")
    options = parser.parse_args()
    first, step = (int(n) for n in options.sample.split("/"))
    known = known_equivalents()
    everything = [(path, *m) for path in FILES if options.only in path for m in mutants(path)]
    chosen = everything[first::step]
    passed = failed = skipped = 0
    with tempfile.TemporaryDirectory() as folder, open(os.devnull, "w") as log:
        copy = os.path.join(folder, "graze")
        shutil.copytree(".", copy, ignore=shutil.ignore_patterns("build-*", ".git"))
        build = "build"
        red = is_killed(copy, build, log, options.limit)
        if red:
            print(f"{red} is red without any mutant")
            print("0 passed, 1 failed")
            sys.exit(1)
        start = time.time()
        for number, (path, line, text, what, source) in enumerate(chosen, 1):
            if (path, text, what) in known:
                skipped += 1
                continue
            target = os.path.join(copy, path)
            with open(target, encoding="utf-8") as file:
                original = file.read()
            with open(target, "w", encoding="utf-8") as file:
                file.write(source)
            killer = is_killed(copy, build, log, options.limit)
            with open(target, "w", encoding="utf-8") as file:
                file.write(original)
            if killer:
                passed += 1
            else:
                failed += 1
                print(f"SURVIVED {path}:{line}\n{path}\n{text}\n{what}\n", flush=True)
            if sys.stderr.isatty() or number % 50 == 0:
                print(f"{number} of {len(chosen)} mutants, {failed} survived, "
                      f"{time.time() - start:.0f} s", file=sys.stderr, flush=True)
    print(f"{len(chosen)} mutants of {len(everything)}: {passed} noticed, {failed} survived, "
          f"{skipped} known to be equivalent")
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
