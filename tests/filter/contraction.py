# suite
"""A build whose compiler joins products and sums (FMA) and knows the machine gives the same bytes.

SPDX-License-Identifier: GPL-3.0-or-later

The C sources of the stages that compute in floating point are compiled again with -march=native
-ffp-contract=fast, also with clang where there is one, and linked with the other objects of the
build that --graze lies in. An error bound that holds only without contraction, or a compiler's
liberty taken for granted, shows as another row than the usual build gives without its filter.
"""
import glob
import os
import re
import shutil
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", *part.split("/")) for part in ("generate", "agree/lib", "lib")]

from adversaries import scenes  # noqa: E402
from program import ROOT, Checks, Graze, options, run  # noqa: E402
from sides import Sides, Way  # noqa: E402

STAGES = ("decide/bounds", "decide/surfaces", "decide/filter")
POINTS = 60
FLAGS = ["-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O2", "-fPIC", "-pthread",
         "-fvisibility=hidden", "-march=native", "-ffp-contract=fast", "-Iinclude", "-Isrc"]


def sources():
    return sorted(path for stage in STAGES
                  for path in glob.glob(os.path.join("src", stage, "*.c"), root_dir=ROOT))


def libraries():
    with open(os.path.join(ROOT, "Makefile"), encoding="utf-8") as file:
        return re.search(r"^LIBS := (.*)$", file.read(), re.M)[1].split()


def contracts(compiler):
    """Has the machine fused operations, and will the compiler use them?"""
    done = run([compiler, *FLAGS, "-dM", "-E", "-x", "c", "-"], cwd=ROOT)
    return "__FMA__" in done.stdout or "__ARM_FEATURE_FMA" in done.stdout


def has_source(path):
    return any(os.path.exists(os.path.join(ROOT, path[:-2] + ending)) for ending in (".c", ".cpp"))


def objects(build):
    """The objects of the usual build that are kept; none where they are not. An object whose source has moved is not
    one of the build."""
    replaced = {path[:-2] + ".o" for path in sources()}
    found = [os.path.relpath(path, build)
             for path in glob.glob(os.path.join(build, "src", "**", "*.o"), recursive=True)]
    return [os.path.join(build, path) for path in found
            if path not in replaced and has_source(path) and not path.startswith((os.path.join("src", "program", "mpi"), os.path.join("src", "output", "png")))]


def built(compiler, build, folder):
    """The program with contraction, or (None, why)."""
    made = []
    for path in sources():
        target = os.path.join(folder, re.sub(r"\W", "_", path) + ".o")
        done = run([compiler, *FLAGS, "-c", "-o", target, path], cwd=ROOT)
        if done.returncode:
            return None, done.stderr
        made.append(target)
    program = os.path.join(folder, "graze_" + compiler)
    done = run([compiler, "-o", program, *made, *objects(build), *libraries()], cwd=ROOT)
    return (program if done.returncode == 0 else None), done.stderr


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    build = os.path.dirname(args.graze)
    found = False
    if args.sanitizers:
        checks.skip("contraction", "objects of a sanitizer build do not go with others")
        checks.finish()
    for k, compiler in enumerate(("gcc", "clang")):
        if not shutil.which(compiler) or not contracts(compiler) or not sources():
            continue
        if not objects(build):
            break
        found = True
        with tempfile.TemporaryDirectory() as folder:
            program, why = built(compiler, build, folder)
            if not checks.holds(program, compiler, why[:1000]):
                continue
            sides = Sides(graze, checks, Way(f"contracted by {compiler}", program),
                          Way("exact", args.graze, ["--no-filter"]))
            for n, scene in args.cycle([scene for scene in scenes()[k::2] if not scene.heavy], 1, compiler):
                sides.scene(scene, args.random, POINTS, args.seed + n)
            sides.summary()
    if not found:
        checks.skip("contraction", "no objects beside the program, or no fused operations here")
    checks.finish()


if __name__ == "__main__":
    main()
