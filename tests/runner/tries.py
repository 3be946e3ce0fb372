#!/usr/bin/env python3
"""`make try` in made-up clones: since when files have changed, which suites are asked about each, and what is built for them; in this
repository, the suites asked about each file; which stages of `make test-long` a run goes on with.

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
import kept  # noqa: E402
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


class Long:
    """`make test-long` of made-up stages a, b and c in a clone: each writes its name beside build/, and fails where a file says so."""

    def __init__(self, clone_):
        self.clone, self.folder = clone_, os.path.join(clone_.folder, "build")
        os.makedirs(self.folder, exist_ok=True)

    def run(self, seed="", first="", failing=""):
        """Status, the stages that ran, the seed that they were given, all that was said."""
        def made_up(options_):
            return [stages.Stage(name, ["sh", "-c", f"echo {name} {options_.seed} >> {self.folder}/ran; {'false' if name in failing else 'true'}"])
                    for name in "abc"]

        log = os.path.join(self.folder, "ran")
        with open(log, "w", encoding="utf-8"):
            pass
        said, options_ = io.StringIO(), mock.Mock(seed=seed, first=first)
        with contextlib.redirect_stdout(said), mock.patch.object(stages, "long", made_up), mock.patch.object(changed, "ROOT", self.clone.folder), \
                mock.patch.object(changed, "BASE", os.path.join(self.clone.folder, "tests", "base.txt")):
            status = stages.run_long(options_, mock.Mock())
        with open(log, encoding="utf-8") as file:
            words = file.read().split()
        return status, "".join(words[::2]), "".join(sorted(set(words[1::2]))), said.getvalue()

    def base(self):
        with open(os.path.join(self.clone.folder, "tests", "base.txt"), encoding="utf-8") as file:
            return file.read()


def check_kept(checks):
    """A run goes on where one at the same commit ended, with its seed; the base is written when all stages have passed at one commit."""
    with clone() as it:
        head, long = it.git("rev-parse", "HEAD"), Long(it)
        checks.equal(long.run("7", failing="b")[:3], (1, "ab", "7"), "the first that fails ends the run")
        status, ran, seed, said = long.run(failing="c")
        checks.equal((status, ran, seed, long.base()), (1, "bc", "7", ""), "the run goes on with the seed of before", said)
        checks.holds(f"goes on at {head[:12]}, where these have passed: a\n" in said and re.search(r"^a +\d", said, re.M), said)
        checks.equal(long.run("7", first="c")[:3], (0, "c", "7"), "--from")
        checks.equal(long.base(), head + "  make test-long passed\n", "all have passed, in three runs")
        it.git("checkout", "-q", "--", ".")
        status, ran, _, said = long.run()
        checks.equal((status, ran), (0, ""), "nothing is left", said)
        checks.holds(long.base().startswith(head) and "3 passed, 0 failed" in said, said)
        it.git("checkout", "-q", "--", ".")
        checks.equal(long.run("8", failing="c")[:3], (1, "abc", "8"), "another seed begins anew")
        checks.equal(long.run("8", first="b", failing="b")[:2], (1, "b"), "a stage asked again by --from")
        checks.equal(long.run("8")[:2], (0, "bc"), "passes no more once it has failed")
        it.git("checkout", "-q", "--", ".")
        long.run("9", failing="b")
        it.write("src/wing/room/source.c", "int x;\n")
        status, ran, _, said = long.run("9")
        checks.equal((status, ran, long.base()), (0, "abc", ""), "a tree with changes begins anew, and has no base", said)
        checks.holds("stays: this tree is not that of a commit" in said, said)
        it.commit()
        checks.equal(long.run("9", failing="c")[:2], (1, "abc"), "another commit begins anew")
        it.write("build/test-long.json", '{"commit": "')
        checks.equal(long.run("9", failing="c")[:2], (1, "abc"), "half a file")
    with clone() as it, mock.patch.object(changed, "ROOT", it.folder), \
            mock.patch.object(changed, "BASE", os.path.join(it.folder, "tests", "base.txt")):
        kept_ = kept.Kept("7")
        kept_.ended("a", 1, 1, failed=False)
        it.write("new.c", "")
        kept_.ended("b", 1, 1, failed=False)
        checks.holds("has changed during the run" in kept_.make_base("ab"), "a file that is new after b")
        os.remove(os.path.join(it.folder, "new.c"))
        kept_ = kept.Kept("7")
        checks.equal(list(kept_.passed), ["a"], "b is not kept")
        checks.holds("have not passed: b, c" in kept_.make_base("abc"), "b and c are missing")
        kept_.ended("b", 1, 1, failed=False)
        checks.holds("has this commit" in kept_.make_base("ab"), "a and b")
        checks.equal(changed.recorded(), it.git("rev-parse", "HEAD"), "the base is read again")


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
