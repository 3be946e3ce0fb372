# suite
"""A build whose compiler joins products and sums (FMA) and knows the machine gives the same bytes.

SPDX-License-Identifier: GPL-3.0-or-later

The C sources of the stages that compute in floating point are compiled again with -march=native
-ffp-contract=fast, also with clang where there is one, and linked with the other objects of the
build that --graze lies in. An error bound that holds only without contraction, or a compiler's
liberty taken for granted, shows as another row than the usual build gives without its filter.
The first quarter of the stream asks the first compiler alone; the others' whole streams are of the rest. Objects are kept in
build/contracted, named after all that makes them.
"""
import glob
import hashlib
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


def macros(compiler):
    """Macros of the compiler, its version too, if the machine has fused operations and the compiler will use them; else None."""
    said = run([compiler, *FLAGS, "-dM", "-E", "-x", "c", "-"], cwd=ROOT).stdout
    return said if "__FMA__" in said or "__ARM_FEATURE_FMA" in said else None


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


def digest(*texts):
    """A name for the contents of files, paths, and of texts, bytes."""
    found = hashlib.sha256()
    for text in texts:
        if isinstance(text, str):
            with open(os.path.join(ROOT, text), "rb") as file:
                text = text.encode() + b"\0" + file.read()
        found.update(b"%d " % len(text) + text)
    return found.hexdigest()[:32]


def compiled(compiler, known, folder):
    """Objects of the stages' sources, and why there are none: those of before where neither source nor header, flag nor compiler has changed."""
    os.makedirs(folder, exist_ok=True)
    headers = sorted(os.path.relpath(path, ROOT) for top in ("src", "include")
                     for path in glob.glob(os.path.join(ROOT, top, "**", "*.h"), recursive=True))
    common = digest(known.encode(), " ".join(FLAGS).encode(), *headers).encode()
    made = {path: os.path.join(folder, digest(common, path) + ".o") for path in sources()}
    for path, target in made.items():
        if not os.path.exists(target):
            done = run([compiler, *FLAGS, "-c", "-o", target + ".new", path], cwd=ROOT)
            if done.returncode:
                return None, done.stderr
            os.replace(target + ".new", target)
    for left in set(glob.glob(os.path.join(folder, "*"))) - set(made.values()):
        os.remove(left)
    return list(made.values()), ""


def built(compiler, known, build, folder):
    """The program with contraction, or (None, why)."""
    made, why = compiled(compiler, known, os.path.join(build, "contracted", compiler))
    if not made:
        return None, why
    program = os.path.join(folder, "graze_" + compiler)
    done = run([compiler, "-o", program, *made, *objects(build), *libraries()], cwd=ROOT)
    return (program if done.returncode == 0 else None), done.stderr


def main():
    args = options(__doc__.splitlines()[0])
    checks = Checks()
    graze = Graze(args, checks)
    build = os.path.dirname(args.graze)
    if args.sanitizers:
        checks.skip("contraction", "objects of a sanitizer build do not go with others")
        checks.finish()
    ways = [(k, compiler, macros(compiler)) for k, compiler in enumerate(("gcc", "clang")) if shutil.which(compiler)]
    ways = [way for way in ways if way[2]] if sources() and objects(build) else []
    for later, (k, compiler, known) in enumerate(ways):
        if later and args.derived and not args.ample:
            break
        if later:
            args.start = type(args.start)(0)  # the whole stream, which has not begun
        with tempfile.TemporaryDirectory() as folder:
            program, why = built(compiler, known, build, folder)
            if not checks.holds(program, compiler, why[:1000]):
                continue
            sides = Sides(graze, checks, Way(f"contracted by {compiler}", program),
                          Way("exact", args.graze, ["--no-filter"]))
            for n, scene in args.cycle([scene for scene in scenes()[k::2] if not scene.heavy or scene.lost], 1, compiler):
                sides.scene(scene, args.random, POINTS, args.seed + n)
            sides.summary()
    if not ways:
        checks.skip("contraction", "no objects beside the program, or no fused operations here")
    checks.finish()


if __name__ == "__main__":
    main()
