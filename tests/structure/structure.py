#!/usr/bin/env python3
"""# suite: the structure of the sources: includes point down the pipeline only, the command line stands on
graze.h, table/ and run/ alone, only validate/ touches CGAL, and the top level holds nothing that is not named.
"""
import glob
import os
import re
import subprocess
import sys

ORDER = ["context", "number", "table", "motion soup", "validate", "read", "solid", "filter", "scene", "trace",
         "verdict generate", "report compare", "convert boundary draw certify", "png", "api",
         "run", "cli", "mpi"]
RANK = {stage: rank for rank, stages in enumerate(ORDER) for stage in stages.split()}
TOP = {"src", "include", "tests", "proofs", "cases", "Makefile", "README.md", ".ci", "LICENSE",
       "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff", ".clang-format", ".gitignore"}
# What the checker of certificates may include.
STANDARD = {"gmp.h", "math.h", "stdarg.h", "stddef.h", "stdint.h", "stdio.h", "stdlib.h", "string.h"}
failures = []
checks = 0


def check(holds, message):
    global checks
    checks += 1
    if not holds:
        failures.append(message)
        print("FAILED", message)


def stage_of(path):
    parts = path.split("/")
    return parts[1] if len(parts) > 2 else "api"


def main():
    sources = sorted(glob.glob("src/**/*.[ch]", recursive=True) +
                     glob.glob("src/**/*.[ch]pp", recursive=True))
    check(len(sources) > 30, "the sources are found")
    for path in sources:
        with open(path, encoding="utf-8") as file:
            text = file.read()
        stage = stage_of(path)
        if stage == "check":  # the checker of certificates shares nothing with the rest
            check("SPDX-License-Identifier: MIT" in text, f"{path}: no licence line")
            for included in re.findall(r'#include "([^"]+)"', text):
                check(os.path.exists(f"src/check/{included}") and "/" not in included,
                      f"{path} includes {included}")
            check(set(re.findall(r"#include <([^>]+)>", text)) <= STANDARD,
                  f"{path} includes more than the C library and GMP")
            check(len(text.splitlines()) <= 500, f"{path} has more than 500 lines")
            continue
        check(stage in RANK, f"{path}: {stage} is no stage")
        check("SPDX-License-Identifier: GPL-3.0-or-later" in text, f"{path}: no licence line")
        for included in re.findall(r'#include "([^"]+)"', text):
            if included == "graze.h":
                continue
            target = stage_of("src/" + included) if "/" in included else stage
            below = target == stage or RANK.get(target, 99) < RANK.get(stage, -1)
            check(below, f"{path} ({stage}) includes {included} ({target})")
            if stage in ("run", "cli", "mpi"):  # libgraze.a has the objects of table/; they are not exported
                check(target in ("run", "cli", "mpi", "table"), f"{path}: the command line includes {included}")
        touches_cgal = re.search(r"#include <CGAL/", text) is not None
        check(not touches_cgal or stage == "validate", f"{path} touches CGAL")
        check(len(text.splitlines()) <= 500, f"{path} has more than 500 lines")
    if os.path.isdir(".git"):
        tracked = subprocess.run(["git", "ls-files"], stdout=subprocess.PIPE, check=True).stdout
        top = {name.split("/")[0] for name in tracked.decode().splitlines()}
        check(top <= TOP, f"top level: {sorted(top - TOP)}")
    for compiler, standard in (("gcc", "c11"), ("g++", "c++17")):
        language = "c" if compiler == "gcc" else "c++"
        for path in ["include/graze.h"] + sorted(glob.glob("include/graze/*.h")):
            done = subprocess.run([compiler, "-x", language, f"-std={standard}", "-Wall", "-Wextra", "-pedantic",
                                   "-Werror", "-fsyntax-only", "-Iinclude", path], stderr=subprocess.PIPE)
            check(done.returncode == 0, f"{path} alone as {standard}: {done.stderr.decode()}")
    print(f"{checks - len(failures)} passed, {len(failures)} failed")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
