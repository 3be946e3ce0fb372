"""build/test-long.json: stages of `make test-long` that have passed at one commit with one seed, so that a later run goes on with the others.

Nothing is kept of a tree that is not a commit's, nor of a stage during which the tree has changed. Another commit or another seed begins
anew. SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import time

import changed

FILE = os.path.join("build", "test-long.json")


def commit():
    """The commit whose tree this is, None where files differ or are new."""
    return changed.git("rev-parse", "--verify", "-q", "HEAD") if changed.git("status", "--porcelain") == "" else None


def read(path):
    """(commit, seed, {stage: (wall, CPU)}) of the file; a file that is no such one, as after a full disk, keeps nothing."""
    try:
        with open(path, encoding="utf-8") as file:
            known = json.load(file)
        return known["commit"], known["seed"], {name: (float(wall), float(cpu)) for name, (wall, cpu) in known["passed"].items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None, "", {}


class Kept:
    """Stages that have passed at the commit of this tree, with the seed of the run: `seed`, else that of before, else the day's."""

    def __init__(self, seed=""):
        self.path, self.commit, self.passed = os.path.join(changed.ROOT, FILE), commit(), {}
        before, of_before, passed = read(self.path)
        if self.commit and before == self.commit and seed in ("", of_before):
            seed, self.passed = of_before, passed
        self.seed = seed or time.strftime("%Y%m%d")

    def ended(self, name, wall, cpu, failed):
        """Take in how a stage ended."""
        if self.commit is None or commit() != self.commit:
            self.commit = None
            return
        self.passed.pop(name, None)
        if not failed:
            self.passed[name] = wall, cpu
        os.makedirs(os.path.dirname(self.path), exist_ok=True)
        with open(self.path + ".new", "w", encoding="utf-8") as file:
            json.dump({"commit": self.commit, "seed": self.seed, "passed": self.passed}, file, indent=1)
        os.replace(self.path + ".new", self.path)

    def make_base(self, names):
        """Write the commit into tests/base.txt if all stages have passed at it; what is said of it."""
        if self.commit is None or commit() != self.commit:
            return "tests/base.txt stays: this tree is not that of a commit, or has changed during the run"
        missing = [name for name in names if name not in self.passed]
        if missing:
            return f"tests/base.txt stays: at this commit these have not passed: {', '.join(missing)}"
        with open(changed.BASE, "w", encoding="utf-8") as file:
            file.write(self.commit + "  make test-long passed\n")
        return "tests/base.txt has this commit now"
