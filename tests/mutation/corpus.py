"""The runs that the suites make of the program, recorded once, so that they can be repeated fast.

SPDX-License-Identifier: GPL-3.0-or-later

A mutant that answers every run of a suite as the program does cannot turn that suite red, for a
suite sees nothing else. One that answers otherwise may: then the suite itself is asked. The cases
need no recording, their tables are in the repository.
"""
import os
import resource
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "cases"))

import casefile  # noqa: E402

CPU_SECONDS = 4     # of one run; the longest takes a small part of that
# Files that are arguments are kept, with the arguments; a run that reads standard input is left out.
RECORDER = """#!/bin/sh
flag=
case $1 in
classify|explain) flag={flag}; kept=1;;
check) kept=1;;
*) kept=;;
esac
if [ $kept ]; then
    folder=$(mktemp -d "{folder}/XXXXXXXX")
    line=
    n=0
    for a; do
        case $a in
        -) kept=;;
        esac
        if [ -f "$a" ]; then
            n=$((n + 1))
            cp "$a" "$folder/$n.${{a##*.}}"
            a=$folder/$n.${{a##*.}}
        fi
        line="$line\t$a"
    done
    [ $kept ] && printf 'whole\t%s%s\n' "$folder/expected" "$line" >>"{folder}/list"
fi
exec "{graze}" "$@" $flag
"""
WRAPPER = """#!/bin/sh
ulimit -t {seconds}
case $1 in
classify|explain) command=$1; shift; exec "{graze}" "$command" {flag} "$@";;
esac
exec "{graze}" "$@"
"""


class Suite:
    """A suite of programs runs, asked with one more option of the program or none."""

    def __init__(self, script, flag):
        self.script, self.flag = script, flag
        self.name = script + (f" {flag}" if flag else "")
        self.tag = self.name.replace("/", "-").replace(" ", "")
        self.list, self.seconds = None, 60


def executable(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    os.chmod(path, 0o755)
    return path


def with_options(line, flag):
    """A recorded run on one thread, with a further option where the program takes it."""
    fields = line.rstrip("\n").split("\t")
    if fields[2] == "classify" and "--jobs" not in fields:
        fields += ["--jobs", "1"]
    if flag and fields[2] != "check" and flag not in fields:
        fields.insert(3, flag)
    return "\t".join(fields) + "\n"


def cases_list(path, flag):
    """The runs of the cases, each against its expected.csv."""
    with open(path, "w", encoding="utf-8") as file:
        for name in casefile.names():
            case = casefile.Case(name)
            files = [case.path(f) for f in (case.solid, "motion.json", "points.csv")]
            line = ["rows", case.path("expected.csv"), "classify", *files, *case.options]
            file.write(with_options("\t".join(line), flag))
    return path


def record(folder, suite, graze):
    """Run a suite on the unchanged program; True if it is green. Then suite.list names its runs."""
    own = os.path.join(folder, suite.tag)
    suite.list = os.path.join(own, "replay")
    took = os.path.join(own, "seconds")
    if not os.path.exists(took):
        os.makedirs(own)
        wrapper = executable(os.path.join(os.path.dirname(graze), suite.tag),
                             RECORDER.format(folder=own, graze=graze, flag=suite.flag))
        start = time.time()
        done = subprocess.run([sys.executable, suite.script, "--graze", wrapper],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            print(done.stdout.decode("utf-8", "replace")[-2000:])
            return False
        with open(os.path.join(own, "list"), encoding="utf-8") as file:
            lines = sorted({with_options(line, suite.flag) for line in file})
        with open(suite.list, "w", encoding="utf-8") as file:
            file.writelines(lines)
        subprocess.run([graze, "--write", suite.list, str(CPU_SECONDS)], check=True,
                       stderr=subprocess.DEVNULL)
        with open(took, "w", encoding="utf-8") as file:
            file.write(f"{time.time() - start:.1f}\n")
    with open(took, encoding="utf-8") as file:
        suite.seconds = float(file.read())
    return True


def bound_memory():
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))


def replay(graze, path, before=bound_memory):
    """None if every run of a list gives what it should, else how the first other one differs: O by
    what it prints, S by its exit status or by a signal."""
    done = subprocess.run([graze, "--replay", path, str(CPU_SECONDS)], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, preexec_fn=before)
    if done.returncode == 2:
        raise RuntimeError(f"the replay of {path} failed")
    if done.returncode == 0:
        return None
    return "O" if done.returncode == 1 and done.stdout.startswith("O") else "S"
