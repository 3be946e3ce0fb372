#!/usr/bin/env python3
"""# suite: the structure of the sources: includes and calls point down the pipeline only and make no circle, each
source that others call has one header, a function's name stands once, the command line stands on the public
header, table/ and two small tools alone, only validate/ touches CGAL, FLINT's functions are called behind their own
headers, the top level holds nothing that is not named, the paths that comments and pages name are there, and so are
the lines that tests/mutants.txt explains.

A call through a pointer is an arrow from the file that names the function (calls.py), so a callback that a higher
room hands to a lower one points down.
"""
import argparse
import collections
import os
import re
import subprocess
import sys

import calls
import flint
import paths
import sources

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "mutation"))

import changes  # noqa: E402

# Rooms from the bottom to the top; those of one line know nothing of one another.
ORDER = ["context", "number", "table", "motion soup", "validate", "read", "solid", "filter", "scene", "trace",
         "verdict", "topo lattice", "contact distance", "envelope", "report compare generate", "convert boundary draw certify mend", "page", "png", "api", "run", "cli", "mpi"]
RANK = {room: rank for rank, rooms in enumerate(ORDER) for room in rooms.split()}
COMMANDS = {"run", "cli", "mpi"}
# Small tools that the commands use beside the public header and table/.
TOOLS = {"src/context/array.h", "src/number/text.h"}
# Rooms that are built only where their library is installed.
OPTIONAL = {"png", "mpi"}
TOP = {"src", "include", "tests", "proofs", "cases", "Makefile", "README.md", ".ci", "LICENSE",
       "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff", ".clang-format", ".gitignore"}
# Parts of the public header that inner rooms include: what all need, and the part that a room makes.
CORE = "include/graze/core.h"
PARTS = {room: room for room in ("report", "generate", "compare", "convert", "draw", "boundary", "certify",
                                  "topo", "contact", "distance", "envelope")}
PARTS["table"] = "report"
PARTS["page"] = "draw"
# What the checker of certificates may include.
STANDARD = {"float.h", "gmp.h", "math.h", "stdarg.h", "stddef.h", "stdint.h", "stdio.h", "stdlib.h", "string.h", "sys/wait.h",
            "unistd.h"}
# Its core, in which each test of a certificate stands, the files that read, and how many lines both may have.
CHECKER = {1230: {"base.c", "ends.c", "poly.c", "solid.c", "legal.c", "motion.c", "trace.c", "contact.c", "verdict.c", "check.c"},
           1110: {"certificate.c", "table.c", "read_solid.c", "read_motion.c", "text.c", "number.c", "sha256.c", "main.c"}}
failures = []
checks = 0


def check(holds, message):
    global checks
    checks += 1
    if not holds:
        failures.append(message)
        print("FAILED", message)


def is_below(room, target):
    return target == room or RANK.get(target, 99) < RANK.get(room, -1)


def check_checker(path, text):
    """The checker of certificates shares nothing with the rest."""
    check("SPDX-License-Identifier: MIT" in text, f"{path}: no licence line")
    for name in re.findall(r'#include "([^"]+)"', text):
        check(os.path.exists(f"src/check/{name}") and "/" not in name, f"{path} includes {name}")
    check(set(re.findall(r"#include <([^>]+)>", text)) <= STANDARD,
          f"{path} includes more than the C library and GMP")


def check_checker_size(everything):
    lines = {path[len("src/check/"):]: len(text.splitlines()) for path, text in everything.items()
             if path.startswith("src/check/") and path.endswith(".c")}
    check(set(lines) == set.union(*CHECKER.values()), f"src/check: {sorted(lines)} are not the files of CHECKER")
    for most, names in CHECKER.items():
        reached = sum(lines.get(name, 0) for name in names)
        check(reached <= most, f"src/check: {sorted(names)} have {reached} lines, expected at most {most}")


def check_includes(path, text):
    room = sources.room_of(path)
    for name, target in sources.included(path, text):
        check(target is not None, f"{path} includes {name}, which is not there")
        if target is None:
            continue
        if sources.is_public(path):
            check(sources.is_public(target), f"{path}: the public header includes {name}")
        elif sources.is_public(target):
            own = f"include/graze/{PARTS[room]}.h" if room in PARTS else CORE
            check(room in COMMANDS | {"api"} or target in (CORE, own),
                  f"{path} includes {name}; expected graze/core.h or the part that {room} makes")
        else:
            below = sources.room_of(target)
            check(is_below(room, below), f"{path} ({room}) includes {name} ({below})")
            check(room not in COMMANDS or below in COMMANDS | {"table"} or target in TOOLS,
                  f"{path}: the command line includes {name}")


def check_file(path, text):
    room = sources.room_of(path)
    check(room in RANK, f"{path}: {room} is no room")
    check("SPDX-License-Identifier: GPL-3.0-or-later" in text, f"{path}: no licence line")
    check(not re.search(r"#include <CGAL/", text) or room == "validate", f"{path} touches CGAL")
    check_includes(path, text)


def check_calls(files, arrows):
    """Calls go down as includes do, and neither makes a circle of files."""
    edges = set()
    for (caller, callee), names in arrows.items():
        edges.add((caller, callee))
        room, below = sources.room_of(caller), sources.room_of(callee)
        check(is_below(room, below), f"{caller} ({room}) calls {', '.join(sorted(names))} of {callee} ({below})")
    for path, text in files.items():
        edges |= {(path, target) for _, target in sources.included(path, text) if target}
    units = {(sources.unit_of(a), sources.unit_of(b)) for a, b in edges}
    circles = calls.circles(units)
    for circle in circles:
        inside = sorted(f"{a} -> {b}" for a, b in units if a in circle and b in circle and a != b)
        check(False, "a circle of files: " + ", ".join(inside))
    check(not circles, f"{len(circles)} circles of files")


def check_headers(files, objects, arrows):
    """The functions that a source defines for others are declared in its own header, or in the public one, and
    nowhere else."""
    headers = {path: sources.declared(text) for path, text in files.items() if path.endswith((".h", ".hpp"))}
    given = collections.defaultdict(set)
    for (_, source), names in arrows.items():
        given[source] |= names & objects[source].functions
    for source, names in sorted(given.items()):
        own = sources.unit_of(source) + (".h" if source.endswith(".c") else ".h*")
        for name in sorted(calls.free_functions(names)):
            places = [path for path, known in headers.items() if name in known]
            right = len(places) == 1 and (sources.unit_of(places[0]) == sources.unit_of(source)
                                          or sources.is_public(places[0]))
            check(right, f"{source} defines {name} for others; expected a declaration in {own} or the public header, "
                  f"found {' '.join(places) or 'none'}")


def check_flint(files):
    for path in files:
        wrong = flint.lacking(path, files)
        check(not wrong, f"{path} does not include {', '.join(wrong)}, of which it calls functions")


def check_paths():
    """Every path that a comment or a page names is there."""
    wrong, seen = paths.missing()
    check(seen > 400, f"{seen} paths are found in comments and pages")
    for file, path in wrong:
        check(False, f"{file} names {path}, which is not there")


def check_names(files, objects):
    """No two files define a function of the same name, but a program's own `main`, and what graze-mpi defines in the
    place of the command line's."""
    linked = calls.holders(objects)
    holders = collections.defaultdict(set)
    for path, text in files.items():
        for name in sources.defined(text):
            stands_in = sources.room_of(path) == "mpi" and len(linked[name]) == 2
            main = name == "main" and sources.room_of(path) in COMMANDS
            if not stands_in and not main:
                holders[name].add(sources.unit_of(path))
    for name, paths in sorted(holders.items()):
        check(len(paths) == 1, f"{name} is defined in {' '.join(sorted(paths))}")


def check_objects(objects, files):
    """The call graph is whole: each source has an object that is not older than it."""
    for path in files:
        if path.endswith((".c", ".cpp")):
            built = path in objects or sources.room_of(path) in OPTIONAL
            check(built, f"{path} has no object; expected one, made by make")


def check_top():
    if os.path.isdir(".git") or os.path.isfile(".git"):
        tracked = subprocess.run(["git", "ls-files"], stdout=subprocess.PIPE, check=True).stdout
        top = {name.split("/")[0] for name in tracked.decode().splitlines()}
        check(top <= TOP, f"top level: {sorted(top - TOP)}")


def check_public(files):
    """Each public header stands alone in C and in C++."""
    for path in (path for path in files if sources.is_public(path)):
        for compiler, language, standard in (("gcc", "c", "c11"), ("g++", "c++", "c++17")):
            done = subprocess.run([compiler, "-x", language, f"-std={standard}", "-Wall", "-Wextra", "-pedantic",
                                   "-Werror", "-Iinclude", "-fsyntax-only", path], stderr=subprocess.PIPE)
            check(done.returncode == 0, f"{path} alone as {standard}: {done.stderr.decode()}")


def check_mutants():
    known = changes.known_equivalents("tests/mutants.txt")
    made = {m.key() for path in {key[0] for key in known} for m in changes.mutants(path)}
    for key in sorted(known):
        check(key in made, f"tests/mutants.txt explains {key}, which is no mutant")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--graze", default="build/graze", help="its folder holds the objects")
    parser.add_argument("--scale", help="ignored: nothing here is random")
    parser.add_argument("--sanitizers", action="store_true", help="ignored: nothing here is run")
    build = os.path.dirname(parser.parse_args().graze)
    everything = {path: sources.read(path) for path in sources.sources()}
    files = {path: text for path, text in everything.items() if sources.room_of(path) != "check"}
    check(len(files) > 30 and len(files) < len(everything), "the sources are found")
    for path, text in everything.items():
        check(len(text.splitlines()) <= 500, f"{path} has more than 500 lines")
        if path in files:
            check_file(path, text)
        else:
            check_checker(path, text)
    check_checker_size(everything)
    objects = calls.read_objects(build, [path for path in files if path.endswith((".c", ".cpp"))])
    arrows = calls.calls(objects, lambda path: RANK.get(sources.room_of(path), 99))
    check(len(arrows) > 300, "the calls are found")
    check_objects(objects, files)
    check_calls(files, arrows)
    check_headers(files, objects, arrows)
    check_names(files, objects)
    check_flint(files)
    check_top()
    check_public(files)
    check_paths()
    check_mutants()
    print(f"{checks - len(failures)} passed, {len(failures)} failed")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
