#!/usr/bin/env python3
# suite
"""Runs the refusal cases: what graze says and how it ends on bad input.

Every tests/refuse/*.txt holds cases; tests/refuse/common holds good files they share.

    === name-of-case
    run: graze check {dir}/cube.off {dir}/move.json
    exit: 3
    says: a distinctive part of standard error
    --- cube.off
    the file, literally, up to the next line that begins with "--- " or "=== "; blank lines at its
    end are left out
    --- big.csv python
    b"1,2,3\\n" * 1000        (a Python expression that gives bytes or str)

Further keys: `stdin: FILE`, `env: K=V`, `stdout: /dev/full` or `closed` or `broken` (a pipe without
a reader), `stderr: closed`, `signal: NAME AFTER` (sent after AFTER seconds; `exit: -15` is an
end by SIGTERM), `rows: N` (whole rows on standard output that are neither comment nor head),
`prints: a part of standard output`. `says` and `prints` may stand more than once. A case with exit 0
and a CSV table must end with `# complete`, every other case must not print it.

    run.py --graze GRAZE [--sanitizers] [NAME ...]

NAME restricts to case or topic names. A whole run also asks messages.py which messages of the
source no case reaches, or quotes with its expectation; each is a failure.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import concurrent.futures
import contextlib
import os
import pathlib
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import messages  # noqa: E402
from harness import Checks, options, run  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
SECONDS, SLOWER = 60, 6  # sanitizers and counters of coverage are slower
SEVERAL = ("says", "prints", "env")
KEYS = ("run", "exit", "stdin", "stdout", "stderr", "signal", "rows") + SEVERAL


class Case:
    """One case: its keys and its files, name -> bytes."""

    def __init__(self, topic, line, name):
        self.topic, self.line, self.name = topic, line, name
        self.keys = {key: [] for key in SEVERAL}
        self.files = {}

    def add_key(self, text):
        key, colon, value = text.partition(":")
        if not colon or key not in KEYS:
            raise SystemExit(f"{self.topic}: {self.name}: {text!r} is no key")
        if key in SEVERAL:
            self.keys[key].append(value.strip())
        elif key in self.keys:
            raise SystemExit(f"{self.topic}: {self.name}: {key} stands twice")
        else:
            self.keys[key] = value.strip()

    def add_file(self, head, lines):
        name, _, kind = head.partition(" ")
        text = "\n".join(lines)
        if kind == "python":
            content = eval(text.strip(), {})
            self.files[name] = content.encode() if isinstance(content, str) else content
        elif kind:
            raise SystemExit(f"{self.topic}: {self.name}: {kind!r} is no kind of file")
        else:
            self.files[name] = (text + "\n" if lines else "").encode()


def parse(path):
    """The cases of one file."""
    cases, lines, head = [], [], None

    def end_file():
        if head is not None:
            while lines and not lines[-1]:
                lines.pop()
            cases[-1].add_file(head, lines)

    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        if line.startswith("=== "):
            end_file()
            cases.append(Case(path.stem, number, line[4:].strip()))
            lines, head = [], None
        elif line.startswith("--- ") and cases:
            end_file()
            lines, head = [], line[4:].strip()
        elif head is not None:
            lines.append(line)
        elif line.strip() and cases:
            cases[-1].add_key(line)
    end_file()
    names = [case.name for case in cases]
    for name in names:
        if names.count(name) > 1:
            raise SystemExit(f"{path.name}: two cases are called {name}")
    for case in cases:
        if "run" not in case.keys or "exit" not in case.keys:
            raise SystemExit(f"{path.name}: {case.name} lacks run or exit")
    return cases


def with_closed(case, words):
    """The command, started by a shell that closes the streams which the case wants closed."""
    closed = [f"{number}>&-" for number, name in enumerate(("stdin", "stdout", "stderr")) if case.keys.get(name) == "closed"]
    return ["sh", "-c", 'exec "$@" ' + " ".join(closed), "sh", *words] if closed else words


def standard(case, folder, stack):
    """Where its standard input and output go, if not to pipes: a broken pipe has no reader, an open one no writer that ends it."""
    files, wanted = {}, case.keys.get("stdout")
    name = case.keys.get("stdin")
    if wanted == "broken" or name == "open":
        reader, writer = (stack.enter_context(os.fdopen(end, mode)) for end, mode in zip(os.pipe(), ("rb", "wb")))
        if name == "open":
            files["stdin"] = reader
        else:
            reader.close()
            files["stdout"] = writer
    elif wanted not in (None, "closed"):
        files["stdout"] = stack.enter_context(open(wanted, "wb"))
    if name not in (None, "closed", "open"):
        files["stdin"] = stack.enter_context(open(os.path.join(folder, name), "rb"))
    return files


def signaled(case, words, seconds, more):
    """A run that gets the signal of its case."""
    with subprocess.Popen(words, **{"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **more}) as child:
        which, after = case.keys["signal"].split()
        time.sleep(float(after))
        child.send_signal(getattr(signal, which))
        try:
            out, err = child.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            child.kill()
            out, err = child.communicate()
            err = (err or b"") + f"\n[still running after {seconds} seconds]".encode()
        return subprocess.CompletedProcess(words, child.returncode, out, err)


def execute(case, graze, folder, limited):
    """Run a case in a fresh folder; (status, stdout, stderr)."""
    for name, content in case.files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(content)
    words = shlex.split(case.keys["run"])
    if words[0] != "graze":
        raise SystemExit(f"{case.topic}: {case.name}: run must begin with graze")
    words = with_closed(case, [graze, *(w.replace("{dir}", folder).replace("{common}", str(HERE / "common")) for w in words[1:])])
    seconds = SECONDS if limited else SLOWER * SECONDS
    with contextlib.ExitStack() as stack:
        more = dict(standard(case, folder, stack), env=dict(os.environ, **dict(e.split("=", 1) for e in case.keys["env"])), cwd=folder)
        done = signaled(case, words, seconds, more) if "signal" in case.keys else run(words, seconds, text=False, **more)
    return done.returncode, done.stdout or b"", done.stderr or b""


def faults(case, status, out, err, folder):
    """Faults of the outcome, as sentences."""
    found = []
    out, err = out.decode("utf-8", "replace"), err.decode("utf-8", "replace")
    if str(status) != case.keys["exit"]:
        found.append(f"it ended with {status}, expected {case.keys['exit']}")
    for part in case.keys["says"]:
        if part.replace("{dir}", folder) not in err:
            found.append(f"standard error lacks {part!r}")
    for part in case.keys["prints"]:
        if part not in out:
            found.append(f"standard output lacks {part!r}")
    if status not in (0, -2, -15) and err.count("\n") != 1 and case.keys.get("stderr") != "closed":
        found.append("a refusal is one line on standard error")
    whole = out.startswith("# complete") or "\n# complete" in out
    if whole != (status == 0 and out.startswith("# graze")):
        found.append("`# complete` stands where it must not" if whole else "`# complete` is missing")
    if "rows" in case.keys:
        rows = [line for line in out.split("\n")[:-1] if not line.startswith("#")]
        if len(rows) - 1 != int(case.keys["rows"]) or (out and not out.endswith("\n")):
            found.append(f"there are {max(len(rows) - 1, 0)} whole rows, expected {case.keys['rows']}")
    return found


def main():
    args, checks = options(__doc__, ("names", {"nargs": "*", "help": "cases or topics"})), Checks()
    cases = [case for path in sorted(HERE.glob("*.txt")) for case in parse(path)]
    if args.names:
        cases = [c for c in cases if c.name in args.names or c.topic in args.names]
    for which in (signal.SIGINT, signal.SIGHUP):   # ignored where a shell runs this in the background
        if signal.getsignal(which) == signal.SIG_IGN:
            signal.signal(which, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    said = []
    with tempfile.TemporaryDirectory(prefix="graze-refuse-") as whole, concurrent.futures.ThreadPoolExecutor(4) as pool:
        def one(case):
            folder = os.path.join(whole, f"{case.topic}-{case.name}")
            os.mkdir(folder)
            return *execute(case, args.graze, folder, not args.sanitizers), folder

        waiting = {case: pool.submit(one, case) for case in cases if "signal" in case.keys}
        done = [(case, one(case)) for case in cases if case not in waiting]
        done += [(case, waiting[case].result()) for case in cases if case in waiting]
    for case, (status, out, err, folder) in done:
        said.append(err.decode("utf-8", "replace"))
        found = faults(case, status, out, err, folder)
        if not checks.holds(not found, f"{case.topic}.txt:{case.line}: {case.name}: " + "; ".join(found)):
            print("    run: " + case.keys["run"])
            print("    stdout: " + out[:2000].decode("utf-8", "replace").replace("\n", "\n      "))
            print("    stderr: " + err[:4000].decode("utf-8", "replace").replace("\n", "\n      "))
    if not args.names:
        reached, silent, unquoted = messages.account("".join(said), {part for case in cases for part in case.keys["says"]})
        checks.passed += reached
        for where, text in silent:
            checks.fail(f"{where}: no case reaches the message {text!r}")
        for where, text in unquoted:
            checks.fail(f"{where}: no case says what is expected in the message {text!r}")
    checks.finish()


if __name__ == "__main__":
    main()
