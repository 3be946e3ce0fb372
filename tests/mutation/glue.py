"""The code around the kernel, of which the mutation test asks a sample, and who is asked.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import random

from changes import mutants

CASES = "the cases with the filter"
REFUSE = "tests/refuse/run.py --sanitizers"  # that is, with more time
# Folder -> who is asked, the likeliest first: the cases, a C program, or a suite in Python.
GLUE = {
    "src/decide/filter": [CASES, "tests/unit/test_filter", "tests/api/test_exact_count", "tests/examples/examples.py",
                   "tests/agree/near.py", "tests/words/words.py", "tests/api/test_filter_environment",
                   "tests/filter/equal.py"],
    "src/output/compare": ["tests/unit/test_compare", "tests/compare/compare.py", f"{REFUSE} compare"],
    "src/output/report": [CASES, "tests/unit/test_report", "tests/api/test_reports", "tests/cases/cases.py",
                   "tests/explain/explain.py",
                   f"{REFUSE} usage certify"],
    "src/input/convert": ["tests/api/test_writing", "tests/motioncmd/motion.py", "tests/api/test_export",
                    f"{REFUSE} motion motion-limits"],
    "src/output/table": ["tests/unit/test_stream", "tests/unit/test_compare", "tests/api/test_export",
                  "tests/compare/compare.py", "tests/draw/draw.py",
                  "tests/shards/shards.py", "tests/shards/resume.py", f"{REFUSE} points compare shards motion"],
}
SECONDS = 600       # of one suite; a mutant may make it slower
SAMPLE, SEED = 15, 10


def askers(path):
    """Who is asked about a mutant of a file; None for a file of the kernel."""
    return GLUE.get(os.path.dirname(path))


def sample():
    """SAMPLE mutants of each folder, drawn with a seed of its own."""
    for folder in GLUE:
        everything = [m for path in sorted(glob.glob(folder + "/*.c"))
                      if path != "src/decide/filter/flip.c" for m in mutants(path)]  # which flips alone are compiled with
        chosen = random.Random(f"{SEED} {folder}").sample(range(len(everything)), SAMPLE)
        yield from (everything[k] for k in sorted(chosen))
