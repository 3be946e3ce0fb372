#!/usr/bin/env python3
"""`make try` in made-up clones: since when files have changed, which suites are asked about each, and what is built for them; in this
repository, the suites asked about each file.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import io
import os
import re
import subprocess
import sys
import tempfile
from unittest import mock

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, ".."), os.path.join(HERE, "..", "lib"), os.path.join(HERE, "..", "mutation")]

import changed  # noqa: E402
import rooms  # noqa: E402
import stages  # noqa: E402
import suiterows  # noqa: E402
from harness import Checks, options, run  # noqa: E402
from runner import GOOD, lay_out, suite  # noqa: E402

SUITES = {"a/a.py": GOOD, "a/b.py": GOOD, "a/helper.py": "x = 1\n", "cases/cases.py": GOOD, "asks/asks.py": suite("print('5 passed, 0 failed' or \"tests/oracle\")"),
          "dear/dear.py": GOOD, "base.txt": ""}
ROWS = [("a/a.py", 3, "derived", "wing/room"), ("a/b.py", "1 + 2", "random", "wing/other, wing/room"), ("cases/cases.py", 3, "derived", "all"),
        ("asks/asks.py", 5, "derived", "-"), ("dear/dear.py", 3, "ci", "wing/room")]
# Builds what it is asked for, and says so.
MAKEFILE = "%:\n\t@echo built $@\nall:\n\t@echo built all\n"
GIT = {"GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@b", "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a@b", "GIT_CONFIG_GLOBAL": os.devnull,
       "GIT_CONFIG_NOSYSTEM": "1", "HOME": "/nonexistent"}


class Clone:
    """A made-up repository with suites in a folder of its own."""

    def __init__(self, folder, is_git=True):
        self.folder = folder
        lay_out(folder, {**SUITES, "times.txt": "dear/dear.py 60.0 101.0\n"}, ROWS)
        self.write("Makefile", MAKEFILE)
        self.write("src/wing/other/source.c", "")
        self.write(".gitignore", "/build/\n__pycache__/\n")
        if is_git:
            self.git("init", "-q", "-b", "main")
            self.commit()

    def git(self, *words):
        return subprocess.run(["git", "-C", self.folder, *words], check=True, stdout=subprocess.PIPE, text=True,
                              env={**os.environ, **GIT}).stdout.strip()

    def write(self, path, text):
        os.makedirs(os.path.dirname(os.path.join(self.folder, path)), exist_ok=True)
        with open(os.path.join(self.folder, path), "w", encoding="utf-8") as file:
            file.write(text)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", "x")
        return self.git("rev-parse", "HEAD")

    def keep_base(self, revision):
        self.write("tests/base.txt", f"{revision}  by hand\n")
        self.git("add", "-A")
        self.git("commit", "-q", "--amend", "--no-edit")

    def ask(self, *words, **environment):
        """Status, the suites that ran, all that was said."""
        done = run([sys.executable, "tests/changed.py", *words], cwd=self.folder, env={**os.environ, **GIT, **environment})
        return done.returncode, sorted(re.findall(r"^tests/(\S+): \d+ passed", done.stdout, re.M)), done.stdout + done.stderr


@contextlib.contextmanager
def clone(is_git=True):
    with tempfile.TemporaryDirectory() as folder:
        yield Clone(folder, is_git)


def check_base(checks):
    """Where nothing tells what has changed, the status is 2 and a line says why."""
    with clone(is_git=False) as it:
        status, ran, said = it.ask()
        checks.equal((status, ran), (2, []), "outside git", said)
        checks.holds("no clone of git" in said, said)
        it.git("init", "-q", "-b", "main")
        checks.equal(it.ask()[:2], (2, []), "a repository without commits")
    with clone() as it:
        outer = it.git("rev-parse", "HEAD")
        for text in ("", "0123456789012345678901234567890123456789  by hand\n", "\n"):
            it.write("tests/base.txt", text)
            status, ran, said = it.ask()
            checks.equal((status, ran), (2, []), "no base:", text, said)
            checks.holds("expected SINCE=REV" in said, said)
        for revision in ("nowhere", "--all", "HEAD~9", "HEAD:Makefile"):
            status, ran, said = it.ask(f"--since={revision}")
            checks.equal((status, ran), (2, []), "an unknown revision", said)
            checks.holds(f"knows no commit {revision}" in said, said)
        checks.equal(it.ask(f"--since={outer}", PATH="/nonexistent")[0], 2, "no git")
    with tempfile.TemporaryDirectory() as outside:  # a folder that is not the top of the clone that holds it
        subprocess.run(["git", "-C", outside, "init", "-q"], check=True, env={**os.environ, **GIT})
        inner = Clone(os.path.join(outside, "inner"), is_git=False)
        checks.equal(inner.ask()[0], 2, "a folder in another clone")


def check_since(checks):
    """Committed or not, since @{upstream}, the commit of tests/base.txt, or the one that is named."""
    with clone() as it:
        first = it.git("rev-parse", "HEAD")
        it.keep_base(first)
        first = it.git("rev-parse", "HEAD")
        it.write("src/wing/room/source.c", "int x;\n")
        it.commit()
        it.write("src/wing/other/source.c", "int y;\n")
        checks.equal(it.ask("--since", "HEAD")[:2], (0, ["a/b.py", "cases/cases.py"]), "what is not committed")
        checks.equal(it.ask("--since", first)[:2], (0, ["a/a.py", "a/b.py", "cases/cases.py"]), "what is committed too")
        it.git("checkout", "-q", "--", ".")
        checks.equal(it.ask("--since", "HEAD")[:2], (0, []), "nothing")
        it.write("src/wing/other/new.c", "int z;\n")
        checks.equal(it.ask("--since", "HEAD")[1], ["a/b.py", "cases/cases.py"], "a new file")
        it.write("build/src/wing/room/new.c", "")
        checks.equal(it.ask("--since", "HEAD")[1], ["a/b.py", "cases/cases.py"], "a file that git ignores")
        os.remove(os.path.join(it.folder, "src/wing/other/new.c"))
        it.git("mv", "src/wing/room/source.c", "src/wing/other/moved.c")
        checks.equal(it.ask("--since", "HEAD")[1], ["a/a.py", "a/b.py", "cases/cases.py"], "the room that a file has left")
        it.git("reset", "-q", "--hard")
    with clone() as it:
        kept = it.git("rev-parse", "HEAD")
        it.write("src/wing/room/source.c", "int x;\n")
        it.write("tests/base.txt", kept + "  by hand\n")
        it.commit()
        asked = it.ask()
        checks.holds({"a/a.py", "a/b.py", "cases/cases.py"} <= set(asked[1]) and "tests/base.txt" in asked[2], "since base.txt", asked)
        it.git("branch", "-q", "theirs")
        it.git("branch", "-q", "--set-upstream-to=theirs")
        checks.equal(it.ask()[:2], (0, []), "since @{upstream}, before base.txt")
        it.write("src/wing/other/source.c", "int y;\n")
        checks.equal(it.ask()[1], ["a/b.py", "cases/cases.py"], "since @{upstream}")
        it.git("checkout", "-q", "theirs")
        it.git("checkout", "-q", "--", ".")
        it.write("src/wing/room/source.c", "int theirs;\n")
        it.commit()
        it.git("checkout", "-q", "main")
        checks.equal(it.ask()[:2], (0, []), "what others did since this branch parted is not asked")


def check_built(checks):
    """Only what is asked is built; a failed build or suite gives make its status."""
    programs = ["--programs", "build/tests/oracle build/tests/other"]
    with clone() as it:
        it.write("src/wing/room/source.c", "int x;\n")
        status, ran, said = it.ask("--since", "HEAD", *programs)
        checks.equal((status, ran, re.findall(r"^built (\S+)", said, re.M)), (0, ["a/a.py", "a/b.py", "cases/cases.py"], ["all"]), said)
        it.write("tests/asks/asks.py", SUITES["asks/asks.py"] + "# changed\n")
        status, ran, said = it.ask("--since", "HEAD", *programs)
        checks.equal(re.findall(r"^built (\S+)", said, re.M), ["all", "build/tests/oracle"], "the program that the suite names", said)
        checks.holds("asks/asks.py" in ran, ran)
        it.write("tests/a/a.py", suite("print('2 passed, 1 failed')"))
        checks.equal(it.ask("--since", "HEAD")[0], 1, "a suite that fails")
        it.write("Makefile", "all:\n\t@false\n")
        checks.equal(it.ask("--since", "HEAD")[:2], (2, []), "what does not build")


def check_costly(checks):
    """Costly suites are asked of their own files; of rooms where all stays within BUDGET."""
    with clone() as it:
        it.write("src/wing/room/source.c", "int x;\n")
        it.git("add", "src")
        it.write("tests/times.txt", "dear/dear.py 60.0 99.0\n")
        it.git("add", "tests/times.txt")
        checks.holds("dear/dear.py" in it.ask("--since", "HEAD")[1], "within the budget")
        it.write("tests/times.txt", "a/a.py 2.0 2.0\ndear/dear.py 60.0 99.0\n")
        _, ran, said = it.ask("--since", "HEAD")
        checks.holds("dear/dear.py" not in ran and "left to CI: dear/dear.py" in said, "above the budget", said)
        it.write("tests/dear/dear.py", GOOD + "# changed\n")
        checks.holds("dear/dear.py" in it.ask("--since", "HEAD")[1], "its own file")


# A file of this repository; suites that are asked, and some that are not.
HERE_ASKED = [
    ("src/decide/trace/trace.c", ["agree/near.py", "cases/cases.py", "structure/structure.py", "words/words.py"], ["page/page.py", "shards/shards.py"]),
    ("src/program/cli/classify.c", ["refuse/run.py", "inputs/forms.py"], ["agree/near.py"]),
    ("src/output/page/page.js", ["page/page.py"], ["draw/draw.py"]),
    ("src/check/verdict.c", ["check/rows.py", "check/mutants.py"], ["agree/near.py"]),
    ("include/graze/core.h", ["install/abi.py", "api/test_misuse.c"], ["agree/near.py"]),
    ("src/python/graze/scene.py", ["python/run.py"], ["agree/near.py"]),
    ("src/base/context/context.c", [rooms.suite(asker) for asker in rooms.SMOKE], []),
    ("tests/lib/harness.py", [rooms.suite(asker) for asker in rooms.SMOKE], []),
    ("tests/agree/near.py", ["agree/near.py"], ["agree/laws.py", "cases/cases.py"]),
    ("tests/topo/shapes.py", ["topo/edges.py", "topo/verdicts.py"], ["agree/near.py"]),
    ("tests/unit/fixture.h", ["unit/test_forms.c"], ["api/test_word.c"]),
    ("tests/run.py", ["runner/runner.py", "runner/tries.py"], ["agree/near.py"]),
    ("cases/bracket/points.csv", ["cases/cases.py", "cases/recompute.py"], ["agree/near.py"]),
    ("README.md", ["readme/readme.py", "readme/formats.py"], ["agree/near.py"]),
    ("proofs/claims.md", ["proofs/claims.py"], ["agree/near.py"]),
    ("LICENSE", ["structure/structure.py"], ["agree/near.py"]),
]


def check_here(checks):
    rows, _ = suiterows.read()
    for path, some, others in HERE_ASKED:
        asked = changed.asked_of(path, rows)
        checks.equal(sorted(set(some) - asked), [], path, "does not ask")
        checks.equal(sorted(set(others) & asked), [], path, "asks")
    for pattern, names in changed.OTHERS:
        for name in names:
            checks.holds(any(path.startswith(name) for path in rows), f"{pattern} asks {name}, which is no suite")


def check_stages(checks):
    """CI asks in full where something has changed since the base, or where git does not know it; else samples."""
    def commands(recorded, names):
        options_ = mock.Mock(record=False, seed="1")
        with mock.patch.object(changed, "recorded", return_value=recorded), mock.patch.object(changed, "files", return_value=names):
            return {stage.name: " ".join(stage.command) for stage in stages.ci(options_)}

    none, all_, some = commands("c", ["README.md"]), commands(None, []), commands("c", ["src/check/poly.c"])
    checks.holds("--sample" in none["proofs"] and "--only verdict.c" in none["the checker weakened"] and "--only outside" in none["forged certificates"], none)
    checks.holds("--sample" not in all_["proofs"] and "trace.c" in all_["the checker weakened"] and "--only" not in all_["forged certificates"], all_)
    checks.holds("--sample" not in some["proofs"] and "trace.c" in some["the checker weakened"], some)


def check_kept(checks):
    """The base is written on a tree that is a commit's alone."""
    with clone() as it, contextlib.redirect_stdout(io.StringIO()), \
            mock.patch.object(changed, "ROOT", it.folder), mock.patch.object(changed, "BASE", os.path.join(it.folder, "tests", "base.txt")):
        head = it.git("rev-parse", "HEAD")
        it.write("src/wing/room/source.c", "int x;\n")
        said = stages.keep_base()
        checks.holds("stays" in said and not open(changed.BASE, encoding="utf-8").read(), "a tree with changes", said)
        it.git("checkout", "-q", "--", ".")
        said = stages.keep_base()
        with open(changed.BASE, encoding="utf-8") as file:
            checks.holds(file.read().startswith(head), "a clean tree", said)
        checks.equal(changed.recorded(), head, "the base is read again")


def main():
    options(__doc__)
    checks = Checks()
    check_base(checks)
    check_since(checks)
    check_built(checks)
    check_costly(checks)
    check_here(checks)
    check_stages(checks)
    check_kept(checks)
    checks.finish()


if __name__ == "__main__":
    main()
