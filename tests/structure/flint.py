# SPDX-License-Identifier: GPL-3.0-or-later
"""Headers of FLINT that a file needs. FLINT 2.9's include one another, those of FLINT 3 do so less, so a file that
builds with one may not build with the other: each file includes the headers whose functions it names, or a header of the
project that does. Those that FLINT declares only behind mpfr.h need it first. scope.h brings what nearly all need, and who has it
names none of that again."""
import functools
import re

import sources

# Longest names first: _fmpz_poly_add is of fmpz_poly, not of fmpz.
MODULES = ("fmpz_poly_factor", "nmod_poly_factor", "fmpz_poly_mat", "fmpz_poly", "fmpq_poly", "nmod_poly", "fmpz_vec",
           "fmpq_vec", "nmod_vec", "fmpz_mat", "fmpq_mat", "nmod_mat", "fmpz", "fmpq")
BROUGHT = {"fmpq": {"fmpz"}}  # by FLINT 3's too
CALL = re.compile(r"\b_?(" + "|".join(MODULES) + r")_\w+\s*\(")
SCOPE = "src/base/context/scope.h"
OF_SYSTEM = re.compile(r"^#include <(?!graze)([^>]+)>", re.M)
BEHIND_MPFR = re.compile(r"\bfmp[qz]\w*_mpfr\s*\(")


@functools.cache
def of_flint(text):
    return set(re.findall(r"#include <flint/(\w+)\.h>", text))


def reached(path, files):
    """A file and the project's headers that it includes, themselves or through another."""
    found, todo = set(), [path]
    while todo:
        at = todo.pop()
        if at in files and at not in found:
            found.add(at)
            todo += [target for _, target in sources.included(at, files[at])]
    return found


def lacking(path, files):
    """The headers that a file names functions of and does not include, in order."""
    code = sources.bare(files[path])
    there = set()
    for other in reached(path, files):
        there |= of_flint(files[other])
    needed = {call.group(1) for call in CALL.finditer(code)}
    wrong = [f"flint/{name}.h" for name in sorted(needed - there.union(*(BROUGHT.get(name, set()) for name in there)))]
    own = [name for name in OF_SYSTEM.findall(files[path]) if name == "mpfr.h" or name.startswith("flint/")]
    if BEHIND_MPFR.search(code) and own[:1] != ["mpfr.h"] and (own or SCOPE not in reached(path, files)):
        wrong.append("mpfr.h before FLINT's")
    return wrong


def again(path, files):
    """The headers that a file names and has from scope.h, in order."""
    if path == SCOPE or SCOPE not in reached(path, files):
        return []
    return sorted(set(OF_SYSTEM.findall(files[path])) & set(OF_SYSTEM.findall(files[SCOPE])))
