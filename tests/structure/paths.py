# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of files that comments and pages name."""
import functools
import glob
import os
import re
import subprocess

import sources

TOPS = "src|include|tests|proofs|cases"
# A path from the top, or from src/ or include/ with the extension of a source; without one it may be a folder.
FROM_TOP = re.compile(rf"(?<![\w/.<-])(?:{TOPS})/[\w./*-]*[\w*]")
WINGS = "|".join(sorted(os.listdir("src"), key=len, reverse=True)).replace(".", r"\.")
FROM_ROOM = re.compile(rf"(?<![\w/.<-])(?:[a-z]\w*/\w+\.(?:c|h|cpp|hpp|py|txt|md)\b|(?:{WINGS})/[a-z]\w+\b(?!/))")
# A name alone, which may stand in any folder.
ALONE = re.compile(r"(?<![\w/.*<{}$-])[a-z]\w+\.(?:c|h|cpp|hpp)\b(?!/)")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
HASHED = re.compile(r'(?:^|\s)#[^\n]*|""".*?"""', re.S)
FENCE = re.compile(r"^```.*?^```", re.M | re.S)
# Headers of the C library and of other libraries.
FOREIGN = {"gmp.h", "math.h", "stdio.h", "stdlib.h", "string.h", "stdint.h", "stddef.h", "stdarg.h", "mpfr.h",
           "yajl.h", "cairo.h", "locale.h", "fenv.h", "mpi.h"}
MADE = "build/"
PLACEHOLDER = re.compile(r"[A-Z]{3}")


def tracked():
    """The files of the repository; without git those of the folders that the pages name."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL, check=False).stdout.decode().split("\n")
    if listed != [""]:
        return [path for path in listed if os.path.isfile(path)]
    return [path for top in TOPS.split("|") for path in glob.glob(top + "/**", recursive=True) if os.path.isfile(path)]


def prose(path):
    """The text in which a file names others: its comments, or a page without the blocks that are run."""
    text = sources.read(path)
    if path.endswith(".md"):
        return FENCE.sub("", text)
    return "\n".join((HASHED if path.endswith((".py", "Makefile")) else COMMENT).findall(text))


@functools.cache
def exists(path):
    return any(os.path.exists(place) or glob.glob(place) for place in
               (path, path.rstrip("."), path + ".c", path + ".h", path + ".cpp", path + ".hpp", path + ".py"))


def missing():
    """(file, path named in it) for each path that does not exist; and the number of paths looked at."""
    files = tracked()
    names = {os.path.basename(path) for path in files} | FOREIGN
    wrong, seen = [], 0
    for file in files:
        if not file.endswith((".c", ".h", ".cpp", ".hpp", ".md", ".py", "Makefile")):
            continue
        text = prose(file)
        here = os.path.dirname(file)
        found = [(path, exists(path) or exists(os.path.join(here, path))) for path in FROM_TOP.findall(text)]
        text = FROM_TOP.sub(" ", text)
        found += [(path, any(exists(os.path.join(place, path)) for place in (here, "src", "include", "tests")))
                  for path in FROM_ROOM.findall(text)]
        text = FROM_ROOM.sub(" ", text)
        found += [(name, name in names) for name in ALONE.findall(text)]
        seen += len(found)
        wrong += [(file, path) for path, good in found
                  if not good and not path.startswith(MADE) and not PLACEHOLDER.search(path)]
    return wrong, seen
