# suite
"""Recorded answers of CGAL (tests/lib/oracle.py): a wrong one, a missing one and those of other sources are noticed.

SPDX-License-Identifier: GPL-3.0-or-later

The wrong answer and the stale table are put into a copy of the table of agree/minkowski, which then must fail; the rest is asked of a
program that is a line of the shell.
"""
import contextlib
import io
import os
import sys
import tempfile
from types import SimpleNamespace

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import oracle  # noqa: E402
from harness import ROOT, Checks, options, run  # noqa: E402

SUITE = "agree/minkowski"
TABLE = os.path.join(oracle.FOLDER, "agree-minkowski.minkowski.jsonl.xz")
WITH_FOLDER = ("import sys; sys.path[:0] = ['tests/lib', 'tests/agree']; sys.argv[0] = 'tests/agree/minkowski.py'; import oracle; "
               "oracle.FOLDER = {!r}; import minkowski; minkowski.main()")
OTHER = {"in interior": "on boundary", "on boundary": "out exterior", "out exterior": "in interior", "on interior": "out exterior"}


def suite(args, folder):
    """agree/minkowski with the tables of a folder, on a scene of its nine."""
    kept = {name: value for name, value in os.environ.items() if name != "GRAZE_ORACLES"}
    return run([sys.executable, "-c", WITH_FOLDER.format(folder), "--graze", args.graze, "--scale", "1/9"], 300, cwd=ROOT, env=kept)


def copies(checks, args):
    """A table as it is, with one letter of it wrong, of other sources, without its rows, and none."""
    head, rows = oracle.read(TABLE)
    wrong = {key: oracle.Answer(a.status, "\n".join([OTHER[a.text.split("\n")[0]], *a.text.split("\n")[1:]])) for key, a in rows.items()}
    for name, table, said in (("as it is", (head, rows), None), ("a wrong answer", (head, wrong), "FAILED"),
                              ("other sources", (dict(head, source="0" * 64), rows), "is of another tests/agree/legs.h or tests/agree/minkowski.cpp or "
                               "tests/agree/shells.h than is here: `GRAZE_ORACLES=record python3 tests/agree/minkowski.py`"),
                              ("no rows", (head, {}), "has no answer to an input (seed 2008, scale 1/9; recorded: seed 2008, scale 1)"),
                              ("none", None, "is missing: `GRAZE_ORACLES=record")):
        with tempfile.TemporaryDirectory() as folder:
            if table:
                oracle.write(os.path.join(folder, os.path.basename(TABLE)), *table)
            out = suite(args, folder)
            checks.equal(out.returncode, 1 if said else 0, name, out.stdout[-500:], out.stderr)
            checks.holds((said or "0 failed") in out.stdout and not out.stderr, name, out.stdout[-1500:], out.stderr)


class Asked:
    """An oracle in a folder of its own whose program is a line of the shell, asked in one mode after the other."""

    def __init__(self, folder):
        self.folder, self.tool = folder, os.path.join(folder, "tool")

    def program(self, line):
        with open(self.tool, "w", encoding="ascii") as file:
            file.write(f"#!/bin/sh\n{line}\n")
        os.chmod(self.tool, 0o755)

    def ask(self, mode, *texts, seed=2008, scale=1, **more):
        """(answers, failed, what was said)"""
        checks, said = Checks(), io.StringIO()
        os.environ["GRAZE_ORACLES"] = mode
        with contextlib.redirect_stdout(said), contextlib.suppress(SystemExit):
            one = oracle.Oracle(SimpleNamespace(seed=seed, scale=scale, derived=True), checks, "minkowski", "made/up")
            answers = [one.ask(text, **more) for text in texts]
            one.finish()
            return [a and a.text for a in answers], checks.failed, said.getvalue()
        return [], checks.failed, said.getvalue()


def modes(checks, folder):
    oracle.FOLDER, oracle.build = folder, lambda program: asked.tool
    asked = Asked(folder)
    for more, line in (({}, "rev"), ({"as_file": True}, "rev >$1")):
        asked.program(line)
        checks.equal(asked.ask("record", "ab", "cd", **more)[:2], (["ba", "dc"], 0), "record", line)
        asked.program("exit 9")
        checks.equal(asked.ask("", "ab", "cd", **more), (["ba", "dc"], 0, ""), "from the table", line)
        for mode, texts, scale, failed, said in (("", ("ab", "xy"), 1, 1, "has no answer to an input (seed 2008, scale 1;"),
                                                 ("", ("ab",), 1, 1, "rows that nobody asks for"), ("", ("ab",), 2, 0, ""),
                                                 ("anew", ("ab", "cd"), 1, 2, "what is recorded is not what CGAL answers to"),
                                                 ("record", ("ab",), 2, 1, "expected a run at scale 1"), ("often", (), 1, 1, "expected anew or record")):
            got = asked.ask(mode, *texts, scale=scale, **more)
            checks.equal((got[1], said in got[2]), (failed, True), line, mode, texts, scale, *got)
        asked.program(line)
        checks.equal(asked.ask("anew", "ab", "cd", **more), (["ba", "dc"], 0, ""), "anew", line)
        checks.equal(asked.ask("anew", "ab", "xy", seed=7, **more), (["ba", "yx"], 0, ""), "anew, another seed", line)
    # Another version's form of an answer is no difference, where an answer has more forms than one.
    asked.program("rev")
    asked.ask("record", "ab")
    asked.program("cat")
    checks.equal(asked.ask("anew", "ab", one_form=False)[1], 1, "other form, same version")
    here = oracle.maker("minkowski")
    oracle.maker = lambda program: here + " and more"
    checks.equal(asked.ask("anew", "ab", one_form=False)[:2], (["ab"], 0), "other form, other version")
    checks.equal(asked.ask("anew", "ab")[1], 1, "other answer, other version")


def hashes(checks, folder):
    """A change of a header that a header includes is one of the program."""
    before, root = oracle.hash_of_sources("distances"), oracle.ROOT
    for path in oracle.sources(oracle.SOURCES["distances"]):
        os.makedirs(os.path.join(folder, os.path.dirname(path)), exist_ok=True)
        with open(os.path.join(root, path), encoding="utf-8") as file, open(os.path.join(folder, path), "w", encoding="utf-8") as copy:
            copy.write(file.read())
    oracle.ROOT = folder
    checks.equal(oracle.hash_of_sources("distances"), before, "a copy of the sources")
    with open(os.path.join(folder, "tests/agree/shells.h"), "a", encoding="utf-8") as file:
        file.write("\n")
    checks.holds(oracle.hash_of_sources("distances") != before, "a line more in shells.h")
    oracle.ROOT = root


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    copies(checks, args)
    with tempfile.TemporaryDirectory() as folder:
        hashes(checks, folder)
    with tempfile.TemporaryDirectory() as folder:
        modes(checks, folder)
    checks.finish()


if __name__ == "__main__":
    main()
