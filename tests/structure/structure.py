#!/usr/bin/env python3
"""# suite: the structure of the sources: seven wings, whose order and whose rooms' order includes and calls follow
downwards only and without a circle, each room has one header that is its face, which alone other rooms include, a function is
declared in one header of its room, a function's name stands once, the commands stand on the public header, two rooms and two small tools alone, only one room touches CGAL, FLINT's functions are called behind their own
headers, the top level holds nothing that is not named, the paths that comments and pages name are there, the identifiers, options and commands too (quotes.py), and so are
the lines that tests/mutants.txt explains and that tests/check/forged.py turns round; comments, pages and messages
begin with their subject, but for a number that only falls.

A call through a pointer is an arrow from the file that names the function (calls.py), so a callback that a higher
room hands to a lower one points down.
"""
import argparse
import collections
import glob
import os
import re
import subprocess
import sys

import calls
import flint
import openings
import paths
import quotes
import sources

TESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
sys.path[:0] = [os.path.join(TESTS, "mutation"), os.path.join(TESTS, "check")]

import changes  # noqa: E402
import forged  # noqa: E402
import rooms  # noqa: E402

# Wings from the bottom to the top, and in each its rooms, floor by floor; those of one floor know nothing of one another.
WINGS = {
    "base": ["context", "number"],
    "input": ["delimited motion soup", "csg", "validate", "read", "planar", "solid", "convert mend", "scad"],
    "decide": ["bounds", "surfaces", "filter", "scene", "trace", "curved", "verdict", "lattice"],
    "questions": ["topo", "contact distance collide", "envelope generate certify outline", "boundary judge"],
    "output": ["table", "report", "compare", "draw", "page png"],
    "api": ["api"],
    "program": ["io", "points", "run", "cli", "mpi"],
}
# Beside the wings: the checker of certificates, which shares nothing with them, the module and what installs.
BESIDE = {"check", "docs", "python", "install"}
FLOORS = [(wing, floor.split()) for wing, floors in WINGS.items() for floor in floors]
RANK = {room: rank for rank, (_, floor) in enumerate(FLOORS) for room in floor}
WING = {room: wing for wing, floor in FLOORS for room in floor}
COMMANDS = {"io", "points", "run", "cli", "mpi"}
# Small tools that the commands use beside the public header and table/, and the table of columns, which is not of a face alone.
TOOLS = {"src/base/context/array.h", "src/base/context/scope.h", "src/base/context/slots.h", "src/base/context/spelling.h",
         "src/base/number/text.h", "src/base/number/json.h", "src/output/report/columns.h"}
# Rooms that the commands include headers of, beside their own.
SHARED = {"table", "delimited"}
# Rooms that are built only where their library is installed.
OPTIONAL = {"png", "mpi"}
TOP = {"src", "include", "tests", "proofs", "cases", "Makefile", "README.md", ".ci", "LICENSE",
       "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff", ".clang-format", ".gitignore",
       "LICENSES", ".reuse", "SECURITY.md", "RELEASE.md", "codemeta.json", "Containerfile"}
# Parts of the public header that inner rooms include: what all need, and the part that a room makes.
CORE = "include/graze/core.h"
MOST_HEADERS = 130  # of all rooms but the checker's
PARTS = {room: room for room in ("report", "generate", "compare", "convert", "draw", "boundary", "certify",
                                  "topo", "contact", "distance", "envelope", "curved", "judge", "outline")}
PARTS["table"] = "report"
PARTS["page"] = "draw"
PARTS["collide"] = "pair"
# Headers that the checker of certificates may include.
STANDARD = {"float.h", "gmp.h", "math.h", "stdarg.h", "stddef.h", "stdint.h", "stdio.h", "stdlib.h", "string.h", "sys/wait.h",
            "unistd.h"}
# Its core, in which each test of a certificate stands, the files that read, and how many lines both may have.
CHECKER = {1300: {"base.c", "ends.c", "poly.c", "solid.c", "legal.c", "motion.c", "trace.c", "contact.c", "verdict.c", "check.c"},
           1200: {"certificate.c", "table.c", "read_solid.c", "read_motion.c", "text.c", "number.c", "sha256.c", "main.c"}}
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
            check(room not in COMMANDS or below in COMMANDS | SHARED or target in TOOLS,
                  f"{path}: the command line includes {name}")


def check_file(path, text):
    room = sources.room_of(path)
    check(sources.wing_of(path) == WING.get(room), f"{path}: {room} is no room of its wing")
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
    circles = calls.circles(edges)
    for circle in circles:
        inside = sorted(f"{a} -> {b}" for a, b in edges if a in circle and b in circle and a != b)
        check(False, "a circle of calls, or of headers: " + ", ".join(inside))
    check(not circles, f"{len(circles)} circles")


def face_of(path):
    """The header of a file's room that other rooms include."""
    folder = os.path.dirname(path)
    return f"{folder}/{os.path.basename(folder)}.h"


def check_faces(files):
    """base has a header for each subject, which all rooms include; every other room has one face, and inner headers that are worth
    a file. Headers of C++, .hpp, are inner."""
    for path, text in files.items():
        if not path.startswith("src/"):
            continue
        for name, target in sources.included(path, text):
            inner = target and target.startswith("src/") and sources.wing_of(target) != "base"
            if inner and target not in TOOLS and os.path.dirname(target) != os.path.dirname(path):
                check(target == face_of(target), f"{path} includes {name}; expected {face_of(target)[4:]}, the face of its room")
        lines = len(text.splitlines())
        if path.endswith(".h") and sources.wing_of(path) != "base":
            is_face = path == face_of(path)
            check(lines <= 400 if is_face else lines >= 60, f"{path} has {lines} lines; expected " +
                  ("at most 400 of a face" if is_face else "at least 60 of an inner header"))
    headers = [path for path in files if path.startswith("src/") and path.endswith((".h", ".hpp"))]
    check(len(headers) <= MOST_HEADERS, f"src has {len(headers)} headers, expected at most {MOST_HEADERS}")


def check_headers(files, objects, arrows):
    """The functions that a source defines for others are declared in one header of its room, or in the
    public one, and nowhere else."""
    headers = {path: sources.declared(text) for path, text in files.items() if path.endswith((".h", ".hpp"))}
    given = collections.defaultdict(set)
    for (_, source), names in arrows.items():
        given[source] |= names & objects[source].functions
    for source, names in sorted(given.items()):
        own = f"{os.path.dirname(source)}/*.h"
        for name in sorted(calls.free_functions(names)):
            places = [path for path, known in headers.items() if name in known]
            right = len(places) == 1 and (os.path.dirname(places[0]) == os.path.dirname(source) or sources.is_public(places[0]))
            check(right, f"{source} defines {name} for others; expected a declaration in {own} or the public header, "
                  f"found {' '.join(places) or 'none'}")


def check_words(everything):
    """One meaning a name: a file's name stands in one room, a type's name in the headers of one room. The commands are
    named as what they ask for is, and the checker shares nothing."""
    apart = COMMANDS | {"check"}
    stems, types = collections.defaultdict(set), collections.defaultdict(set)
    for path, text in everything.items():
        room = sources.room_of(path)
        if room not in apart and not sources.is_public(path):
            stems[os.path.basename(sources.unit_of(path))].add(room)
        if room != "check" and path.endswith((".h", ".hpp")):
            for name in sources.types(text):
                types[name].add(room)
    check(len(stems) > 200 and len(types) > 150, f"{len(stems)} names of files and {len(types)} of types are found")
    for what, found in (("file", stems), ("type", types)):
        for name, rooms in sorted(found.items()):
            check(len(rooms) == 1, f"the name {name} of a {what} stands in the rooms {', '.join(sorted(rooms))}; expected one")


def check_flint(files):
    for path in files:
        wrong = flint.lacking(path, files)
        check(not wrong, f"{path} does not include {', '.join(wrong)}, of which it calls functions")
        wrong = flint.again(path, files)
        check(not wrong, f"{path} includes {', '.join(wrong)}, which scope.h brings")


def check_paths():
    """Every path that a comment or a page names is there."""
    wrong, seen = paths.missing()
    check(seen > 400, f"{seen} paths are found in comments and pages")
    for file, path in wrong:
        check(False, f"{file} names {path}, which is not there")


def check_quoted(build):
    """Every identifier, option, command and target that a page or a comment quotes is there."""
    wrong, seen = quotes.missing(build)
    check(seen > 2000, f"{seen} names are found in comments and pages")
    for file, name in wrong:
        check(False, f"{file} quotes {name}, which is not there")


def check_openings():
    """Openings without a subject and phrases that hide a bound are at most those allowed; the pattern finds samples."""
    for path, text, lines in openings.SAMPLES:
        found = [line for line, _ in openings.found(path, text)]
        check(found == lines, f"openings in a sample {path}: lines {found}, expected {lines}")
    for place, found in openings.places(paths.tracked()).items():
        allowed = openings.ALLOWED[place]
        check(len(found) <= allowed, "\n".join([f"{place} has {len(found)} openings without a subject or hidden bounds, expected "
                                                f"at most {allowed} (CONTRIBUTING.md, Words):", *found]))
        if len(found) < allowed:
            print(f"tests/structure/openings.py allows {place} {allowed}, {len(found)} are left: lower the number")


def check_names(files, objects):
    """No two files define a function of the same name, but a program's own `main`, and what graze-mpi defines in the
    place of the command line's."""
    linked = calls.holders(objects)
    holders = collections.defaultdict(set)
    for path, text in files.items():
        for name in sources.defined(text):
            stands_in = sources.room_of(path) == "mpi" and len(linked[name]) == 2
            main = name == "main" and sources.room_of(path) in COMMANDS
            falsified = name == "flip"  # of the program whose decisions can be falsified
            if not stands_in and not main and not falsified:
                holders[name].add(sources.unit_of(path))
    for name, paths in sorted(holders.items()):
        check(len(paths) == 1, f"{name} is defined in {' '.join(sorted(paths))}")


def check_objects(objects, files):
    """The call graph is whole: each source has an object that is not older than it."""
    for path in files:
        if path.endswith((".c", ".cpp")):
            built = path in objects or sources.room_of(path) in OPTIONAL
            check(built, f"{path} has no object; expected one, made by make")


def check_rooms():
    """The map of the sources has each wing in order, and each room of it with what it makes of what."""
    text = sources.read("src/README.md")
    wings = re.findall(r"^## (\w+)", text, re.M)
    here = {place.split("/")[1] for place in glob.glob("src/**/*.*", recursive=True)} - {"README.md"}
    check(here == set(WINGS) | BESIDE, f"src has {sorted(here)}, expected {sorted(set(WINGS) | BESIDE)}")
    check(wings == list(WINGS) + ["beside"], f"src/README.md: wings {wings}, expected {list(WINGS)} and beside")
    for section, wing in zip(text.split("\n## ")[1:], wings):
        named = re.findall(r"^\| \[(\w+)\]\(([\w/]+)\) \|", section, re.M)
        expected = sorted(BESIDE) if wing == "beside" else [room for floor in WINGS[wing] for room in floor.split()]
        check([name for name, _ in named] == expected, f"src/README.md, {wing}: rooms {named}, expected {expected}")
        for name, link in named:
            check(os.path.isdir(f"src/{link}"), f"src/README.md: {link} is not there")


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
    known = changes.record()
    strangers = changes.strangers(known)
    for key in sorted(known):
        check(key not in strangers, f"{changes.RECORD} explains {key}, which is no mutant")
    for room in rooms.ROOMS:
        check(rooms.files(room), f"tests/mutation/rooms.py: {room} has no sources")
    for path, old, _ in forged.CAREFUL + [change[1:] for change in forged.DECISIONS]:
        check(path is None or old in sources.read(os.path.join("src", path)), f"tests/check/forged.py changes what does not stand in {path}: {old}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--graze", default="build/graze", help="its folder holds the objects")
    parser.add_argument("--scale", "--seed", help="ignored: nothing here is random")
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
    check_faces(files)
    check_headers(files, objects, arrows)
    check_names(files, objects)
    check_flint(files)
    check_words(everything)
    check_rooms()
    check_top()
    check_public(files)
    check_paths()
    check_quoted(build)
    check_openings()
    check_mutants()
    print(f"{checks - len(failures)} passed, {len(failures)} failed")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
