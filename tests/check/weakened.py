"""Every test the checker makes is needed: with one of them left out, something bad is accepted.

SPDX-License-Identifier: GPL-3.0-or-later

Each entry of WEAKENED is a line of src/check, what replaces it, and the suite that must then fail, with the scenes
it is narrowed to.
Builds graze-check anew for each: run by hand or by tests/long.sh, from the top of the repository.
"""
import glob
import os
import shutil
import subprocess
import sys
import tempfile

import lib_certificate  # noqa: F401  (sets the path)
from harness import ONLY, Checks, options

# Not listed, because no test here shows them needed yet: the signs of the motion (a row's own weight refuses the
# motions tried), closedness and disjoint facets (the rays of the sides refuse the solids tried), a table's number of rows,
# equal letters where intervals meet (the rays of the states refuse).
WEAKENED = [
    ("trace.c", "if (changes != 1 || c->q_left == 0 || c->q_right == 0)", "if (0)", "mutants figure2-c"),
    ("trace.c", "if (mpq_cmp(r->at, to) >= 0)", "if (0)", "mutants figure2-s"),
    ("trace.c", "if (!forced && !c->mid_certain)", "if (0)", "mutants figure2-s"),
    ("trace.c", "if (!cleared(r, f))\n            refute(", "if (0)\n            refute(", "mutants figure2-s"),
    ("trace.c", "if (!found)\n", "if (0)\n", "mutants figure2-s"),
    ("trace.c", "if (!solid_ray(&sum, r->s, at, 0, NULL) || sum != (r->free == 'I'))", "if (0)", "mutants figure2-s"),
    ("trace.c", "if (mpq_cmp(r->at, r->m->piece[r->m->count - 1].hi) != 0)", "if (0)", "mutants figure2-s"),
    ("main.c", 'if (strcmp(c->r.word, c->word) != 0)', "if (0)", "mutants figure2-s"),
    ("main.c", "if (strcmp(sha, expected) != 0)", "if (0)", "mutants figure2-s"),
    ("main.c", "if (!word_is(want(c, &at, end, \"pmc\"), v.pmc))", "if (word_is(want(c, &at, end, \"pmc\"), \"x\"))", "mutants figure2-s"),
    ("motion.c", "if (!same)", "if (0)", "solids"),
    ("legal.c", "if (sides[i] == 3)", "if (0)", "solids"),
    ("legal.c", "if (sum != (mpz_sgn(f->plane[f->axis]) > 0 ? 0 : 1))", "if (0)", "solids"),
    ("table.c", "!mpq_equal(x, point[k])", "0", "golden"),
]


def build(folder, file, old, new):
    """1 if the line stands just once and the program is built."""
    source = os.path.join(folder, "source")
    shutil.rmtree(source, ignore_errors=True)
    shutil.copytree("src/check", source)
    path = os.path.join(source, file)
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    if text.count(old) != 1:
        return False
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text.replace(old, new))
    command = ["cc", "-std=c11", "-O1", "-w", *glob.glob(source + "/*.c"), "-o",
               os.path.join(folder, "graze-check"), "-lgmp", "-lm"]
    return subprocess.run(command).returncode == 0


def main():
    chosen, tally = options(__doc__, ONLY), Checks()
    here = os.path.dirname(os.path.abspath(__file__))
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(os.path.abspath(chosen.graze), os.path.join(folder, "graze"))
        for file, old, new, suite in WEAKENED:
            if not tally.holds(build(folder, file, old, new), "stands just once, and is built", file, old):
                continue
            name, *only = suite.split()
            more = ["--scale", "2", "--only", *only] if only else []
            done = subprocess.run([sys.executable, os.path.join(here, name + ".py"), "--graze",
                                   os.path.join(folder, "graze"), *more], stdout=subprocess.PIPE)
            tally.holds(done.returncode == 1 and b"FAILED" in done.stdout, f"{suite}.py does not notice", file, old)
            print(file, old.strip(), "noticed" if done.returncode else "NOT noticed", flush=True)
    tally.finish()


if __name__ == "__main__":
    main()
