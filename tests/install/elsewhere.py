#!/usr/bin/env python3
# suite
"""`make` where there is no dpkg: libraries are looked for by pkg-config and the compiler, and what is lacking is said in a line each.

The programs of this machine but for dpkg's and apt's are all that PATH has. A compiler that does not know a header stands for a
machine without the library. SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import tempfile

from programs import check, checks, options, read, run, same

LIBRARIES = {"GMP": "gmp.h", "MPFR": "mpfr.h", "FLINT": "flint/fmpq_poly.h", "yajl": "yajl/yajl_tree.h", "libmd": "sha2.h", "CGAL": "CGAL/version.h"}
COMPILER = """#!/bin/sh
for word; do case "$word" in *.cpp) grep -qE '<({})>' "$word" && exit 1 ;; esac; done
exec g++ "$@"
"""


def tools(folder):
    """A folder of links to all programs but dpkg's and apt's."""
    place = os.path.join(folder, "bin")
    os.mkdir(place)
    for name in os.listdir("/usr/bin"):
        if not name.startswith(("dpkg", "apt")):
            os.symlink(os.path.join("/usr/bin", name), os.path.join(place, name))
    return place


def compiler(folder, lacking):
    path = os.path.join(folder, f"compiler{len(lacking)}")
    with open(path, "w", encoding="ascii") as file:
        file.write(COMPILER.format("|".join(map(re.escape, (LIBRARIES[name] for name in lacking)))))
    os.chmod(path, 0o755)
    return path


def main():
    options(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        path = tools(folder)

        def make(number, *words):
            build = os.path.join(folder, f"build{number}")
            return run(["make", "-s", f"B={build}", f"{build}/.packages-build", *words], PATH=path)
        out, error, status = make(0)
        same((out, error, status), ("", "", 0), "nothing is lacking")
        for number, lacking in enumerate((["FLINT"], ["CGAL"], list(LIBRARIES)), 1):
            _, error, status = make(number, f"CXX={compiler(folder, lacking)}")
            said = [line for line in error.splitlines() if line.startswith("make: lacks")]
            check(status == 2 and [line.split()[2].rstrip(":") for line in said] == lacking, lacking, status, error)
            check(all(f"<{LIBRARIES[name]}>" in line and "src/docs/elsewhere.md" in line for name, line in zip(lacking, said)), error)
        _, error, status = make(9, "CC=no-such-compiler")
        check(status == 2 and "make: lacks a compiler, no-such-compiler; CC= and CXX= name others" in error, error)
    named = re.findall(r"^\| (?:\w+ )*?(GMP|MPFR|FLINT|yajl|libmd|CGAL)\b.*\|$", read("src", "docs", "elsewhere.md"), re.M)
    same(sorted(named), sorted(LIBRARIES), "rows of the table of packages")
    packages = set(re.search(r"^PACKAGES_BUILD := (.*)", read("Makefile"), re.M)[1].split())
    page = read("src", "docs", "elsewhere.md")
    check(all(re.search(rf"`[^`]*\b{re.escape(name)}(?![\w+])", page) for name in packages), packages, "the packages of Debian")
    checks.finish()


if __name__ == "__main__":
    main()
