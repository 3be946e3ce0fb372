"""Certificates of a Graze that decides one thing wrongly, and fits all its hints to that: none is accepted.

SPDX-License-Identifier: GPL-3.0-or-later

Builds graze anew for each of DECISIONS, a line of src turned round. Its certifier cuts intervals with care as long as
that helps, and then claims what it cannot prove (CAREFUL). Of the golden cases it certifies, each row whose claims are
not those of expected.csv stands alone in a certificate that graze-check must refuse; with nothing turned round most
cases are verified (not those whose intervals are finer than CAREFUL cuts). Run by hand or by CI, from the top of the repository; of every case with --scale.
"""
import glob
import os
import subprocess
import tempfile

from lib_certificate import Certificate, NOT_CHECKED, Programs, REFUTED, VERIFIED, answer_options, run, write
import casefile
from harness import ONLY, Checks, options

LIBS = "-lyajl -lmd -lflint -lmpfr -lgmp -lstdc++ -lm -pthread".split()
LEAST = 10  # forged rows of each decision; cases verified with none turned round
CAREFUL = [
    ("questions/certify/row.c", "enum { DEEPEST = 2000 };", "enum { DEEPEST = 10 };"),
    ("questions/certify/row.c", "return too_deep(r);", "break;"),
    ("questions/certify/row.c", "if (letter == 'B' ? prove_slide(r->e, at) : prove_clear(r->e, at)) {",
     "if (depth > DEEPEST || (letter == 'B' ? prove_slide(r->e, at) : prove_clear(r->e, at))) {"),
    ("api/api_rows.c", "    graze_trace trace;\n", "    graze_trace trace;\n    context->exact_only = 1;\n"),
]
DECISIONS = [
    ("nothing", None, "", ""),
    ("inside is outside", "input/solid/locate.c", "return winding == 1 ? GRAZE_STATE_I : winding == 0 ? GRAZE_STATE_O",
     "return winding == 1 ? GRAZE_STATE_O : winding == 0 ? GRAZE_STATE_I"),
    ("all is outside", "input/solid/locate.c", "return winding == 1 ? GRAZE_STATE_I", "return winding == 1 ? GRAZE_STATE_O"),
    ("all is inside", "input/solid/locate.c", "winding == 0 ? GRAZE_STATE_O", "winding == 0 ? GRAZE_STATE_I"),
    ("edges are on no facet", "decide/trace/touch.c", "if (finder_failed(f) || sign < 0)", "if (finder_failed(f) || sign <= 0)"),
    ("a plane is a facet", "decide/trace/touch.c", "if (finder_failed(f) || sign < 0)", "if (finder_failed(f))"),
    ("every second touch is lost", "decide/trace/touch.c", "if (!may_meet(&first[k], root) ||", "if (k % 2 == 0 || !may_meet(&first[k], root) ||"),
    ("what touches crosses", "decide/verdict/verdict.c", "    return left != right ? GRAZE_INTERSECTION : GRAZE_TANGENCY;",
     "    return left == right ? GRAZE_INTERSECTION : GRAZE_TANGENCY;"),
    ("a fold is regular", "decide/verdict/verdict.c", "if (k >= 2 && (t == 0", "if (k >= 3 && (t == 0"),
    ("the motion for its inverse", "input/motion/motion.c", "operation == GRAZE_UNSWEEP", "operation != GRAZE_UNSWEEP"),
]


def patch(sources, file, old, new):
    """The texts of the changed files."""
    if file not in sources:
        with open(os.path.join("src", file), encoding="utf-8") as stream:
            sources[file] = stream.read()
    if old not in sources[file]:
        return False
    sources[file] = sources[file].replace(old, new)
    return True


def build(tally, folder, build_folder, decision):
    """A graze that decides so, beside a graze-check; None if it is not built."""
    name, file, old, new = decision
    sources, objects = {}, []
    for change in CAREFUL + ([(file, old, new)] if file else []):
        if not tally.holds(patch(sources, *change), "stands in the source", *change):
            return None
    for path, text in sources.items():
        source = write(os.path.join(folder, path.replace("/", "_")), text)
        objects.append(source[:-2] + ".o")
        done = subprocess.run(["cc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O1", "-w", "-pthread", "-Iinclude", "-Isrc", "-c", source,
                               "-o", objects[-1]])
        if not tally.equal(done.returncode, 0, "compiles", name, path):
            return None
    program = os.path.join(folder, "graze")
    commands = [f"{build_folder}/{path[:-2]}.o" for path in glob.glob("src/program/*/*.c") if "/mpi/" not in path]
    done = subprocess.run(["c++", "-o", program, *commands, *objects, build_folder + "/libgraze.a", *LIBS])
    return program if tally.equal(done.returncode, 0, "links", name) else None


def claims(row, unsweep):
    return row.claims[:2] if unsweep else row.claims[:7]


def forge(tally, forger, honest, case, folder, name):
    """The number of forged rows of a case; for the forger that turns nothing round, 1 if the case is verified."""
    files = honest.convert(case, folder)
    more = answer_options(case.options)
    status, text, _ = run(forger.graze, "certify", *files, case.path("points.csv"), *more)
    if status != 0:
        return 0
    certificate = Certificate(text)
    columns = ["word", "pmc"] + ([] if certificate.unsweep else ["class", "definition", "case", "i", "t"])
    wrong = [row for row, right in zip(certificate.rows, case.expected)
             if claims(row, certificate.unsweep) != [right[c] for c in columns]]
    path = os.path.join(folder, "certificate")
    if name == "nothing":
        write(path, text)
        tally.equal(wrong, [], case.name, "nothing is turned round")
        return int(honest.check(*files, path)[0] == VERIFIED)
    for row in wrong:
        write(path, certificate.only([row]).text())
        status, _, error = honest.check(*files, path)
        tally.holds(status in (REFUTED, NOT_CHECKED), "a forged row is accepted", name, case.name, row.lines(), error)
    return len(wrong)


def main():
    wanted, tally = options(__doc__, ONLY), Checks()
    honest = Programs(wanted.graze)
    names = [n for k, n in enumerate(casefile.names()) if wanted.scale > 1 or k % 3 == 0]
    for decision in DECISIONS:
        if wanted.only not in decision[0]:
            continue
        with tempfile.TemporaryDirectory() as folder:
            program = build(tally, folder, os.path.dirname(wanted.graze), decision)
            if not program:
                continue
            forger = Programs(program)
            count = sum(forge(tally, forger, honest, casefile.Case(n), folder, decision[0]) for n in names)
        tally.holds(count >= LEAST, f"at least {LEAST} rows are forged", decision[0], count)
        print(f"{decision[0]}: {count} rows", flush=True)
    tally.finish()


if __name__ == "__main__":
    main()
