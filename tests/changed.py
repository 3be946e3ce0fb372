#!/usr/bin/env python3
"""`make try`: the suites of the rooms that have changed, committed or not.

Changed since where @{upstream} and this branch part, else since the commit of tests/base.txt, or since --since REV. A file of src or
include asks the suites whose rows in tests/README.md name its room, or `all`; one of tests/FOLDER its suite, or those of its folder; one
that every room rests on asks SMOKE (mutation/rooms.py); OTHERS names who is asked of the rest. Random suites run at a quarter. Costly
ones (tier `ci`) run where that stays within BUDGET. Where nothing tells what has changed the status is 2.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, folder) for folder in ("lib", "mutation")]

import suiterows  # noqa: E402
import suitetimes  # noqa: E402
from rooms import SMOKE, suite  # noqa: E402

ROOT, BASE = os.path.dirname(HERE), os.path.join(HERE, "base.txt")
BUDGET = 100  # seconds of CPU that all may take by tests/times.txt, beyond which suites of tier `ci` are left to CI
RUN = ("derived", "random", "ci")  # tiers
# Files that are of no room and no suite's folder, and who is asked of them: beginnings of suites' paths. The first that fits.
OTHERS = [
    (r"src/base/|tests/lib/|tests/\w+/lib/", [suite(asker) for asker in SMOKE]),
    (r"src/docs/|src/README|proofs/|[^/]*\.md$", ["proofs/claims", "readme/", "structure/"]),
    (r"cases/benchmark/", ["benchmark/"]),
    (r"cases/contacts/", ["collide/contacts"]),
    (r"cases/candidates/", ["compare/python_candidates", "benchmark/codes"]),
    (r"cases/", ["cases/", "examples/"]),
    (r"Makefile$", ["install/", "runner/", "readme/"]),
    (r"tests/[^/]*$|tests/(mutation|stages)/|\.ci/", ["runner/", "structure/"]),
    (r"", ["structure/"]),
]


class NoBase(Exception):
    """Nothing tells what has changed; the reason."""


def git(*words):
    """Standard output of git in this repository, None if it fails or is not there."""
    try:
        done = subprocess.run(["git", "-C", ROOT, *words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    except FileNotFoundError:
        return None
    return done.stdout.strip() if done.returncode == 0 else None


def commit(revision):
    return git("rev-parse", "--verify", "-q", "--end-of-options", revision + "^{commit}")


def recorded():
    """The commit of tests/base.txt, None if there is none or git does not know it."""
    if not os.path.exists(BASE):
        return None
    with open(BASE, encoding="utf-8") as file:
        words = file.read().split()
    return commit(words[0]) if words else None


def base(since):
    """(commit, how it is called) since which files have changed."""
    top = git("rev-parse", "--show-toplevel")
    if top is None or os.path.realpath(top) != os.path.realpath(ROOT):
        raise NoBase("this folder is no clone of git, which tells what has changed; `make test` asks all suites")
    if since:
        found = commit(since)
        if not found:
            raise NoBase(f"git knows no commit {since}; expected SINCE=REV of this clone")
        return found, since
    upstream = commit("@{upstream}")
    if upstream:
        return git("merge-base", "HEAD", upstream) or upstream, "@{upstream}"
    found = recorded()
    if not found:
        raise NoBase("there is no @{upstream}, and git knows no commit of tests/base.txt; expected SINCE=REV")
    return found, "the commit of tests/base.txt"


def files(since):
    """Files that differ from a commit, or are new and not ignored; both names of one that was renamed."""
    return sorted({*git("diff", "--name-only", "--no-renames", since).splitlines(),
                   *git("ls-files", "--others", "--exclude-standard", "--full-name").splitlines()})


def asked_of(path, rows):
    """Paths of the suites of a file."""
    rooms = path[len("src/"):].rpartition("/")[0] if path.startswith("src/") else "api" if path.startswith("include/") else None
    out = {row.path for row in rows.values() if rooms and any(f"{rooms}/".startswith(f"{room}/") for room in row.rooms)}
    own = path.removeprefix("tests/")
    folder = [row.path for row in rows.values() if own != path and row.path.startswith(own.split("/")[0] + "/") and row.tier != "by hand"]
    if own in rows or (folder and not re.search("/lib/", path)):
        return {own} if own in rows else set(folder)
    if out:
        out |= {row.path for row in rows.values() if row.rooms == ("all",)}
    if not out or path.startswith("src/base/"):
        names = next(names for pattern, names in OTHERS if re.match(pattern, path))
        out |= {row for row in rows if row.startswith(tuple(names))}
    return out


def chosen(changed, rows):
    """Suite -> the first file that asks it; and the costly ones that are left to CI."""
    why = {name: "tests/" + name for name, row in rows.items() if "tests/" + name in changed and row.tier in RUN}
    for path in changed:
        for name in asked_of(path, rows):
            if rows[name].tier in RUN:
                why.setdefault(name, path)
    known = suitetimes.parts()

    def cost(name):
        return suitetimes.part_of(known.get(name, {}), suitetimes.QUARTER if rows[name].tier == "random" else suitetimes.WHOLE)[1]

    costly = sorted((name for name in why if rows[name].tier == "ci" and why[name] != "tests/" + name), key=cost)
    left, spent = [], sum(cost(name) for name in why if name not in costly)
    for name in costly:
        spent += cost(name)
        if spent > BUDGET:
            left.append(name)
            del why[name]
    return why, left


def targets(names, build, programs):
    """The goals of make for these suites: their programs, and from `programs` those that a suite's text names."""
    out = [f"{build}/tests/{name[:-2]}" for name in names if name.endswith(".c")]
    for name in names:
        if name.endswith(".py"):
            with open(os.path.join(HERE, name), encoding="utf-8") as file:
                text = file.read()
            out += [path for path in programs if f'{os.path.basename(path)}"' in text]
    return ["all", *sorted(set(out))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--since", default="", metavar="REV")
    parser.add_argument("--build", default="build")
    parser.add_argument("--programs", default="", help="what make builds for some suites alone")
    options = parser.parse_args()
    os.chdir(ROOT)
    try:
        since, name = base(options.since)
    except NoBase as reason:
        print(f"make try: {reason}", file=sys.stderr)
        sys.exit(2)
    changed, (rows, faults) = files(since), suiterows.read()
    for fault in faults:
        print("FAILED", fault)
    why, left = chosen(changed, rows)
    print(f"since {name} ({since[:12]}) {len(changed)} files have changed, which {len(why)} suites are about")
    for path in sorted(set(why.values())):
        print(f"  {path}: {' '.join(sorted(suite_ for suite_, first in why.items() if first == path))}")
    if left:
        print(f"  left to CI: {' '.join(left)}")
    if not why:
        print("no suite is asked" if changed else "nothing has changed")
        sys.exit(1 if faults else 0)
    sys.stdout.flush()
    built = subprocess.run(["make", "-s", f"B={options.build}", *targets(why, options.build, options.programs.split())])
    if built.returncode:
        sys.exit(built.returncode)
    sys.exit(subprocess.run([sys.executable, "tests/run.py", "--build", options.build, "--tier", "test", *sorted(why)]).returncode)


if __name__ == "__main__":
    main()
