#!/usr/bin/env python3
"""Each rule of curved solids is needed (proofs/curved.md): the program is built without it, or without a condition of it,
and a suite of the room must be red. Left out are what others imply: circuits of planes alone (their last member is 0 along the
rest, C97) and indefinite forms (the ridge of one has both signs, C98), which are cheaper than those. By hand; wants a
finished `make test`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

from mutate import Parts, Worker  # noqa: E402
from rooms import ROOMS  # noqa: E402

CURVED, CSG = "src/decide/curved/", "src/input/csg/"
# (claim, what is left out, file, text, what stands there without it)
RULES = [
    ("C94", "factors of even order are no surfaces", CSG + "csg_build.c", "if (fmpz_is_even(parts->exp + k))", "if (0)"),
    ("C94", "the sign of the constant factor", CSG + "csg_build.c", "if (!status && negative)", "if (0)"),
    ("C95", "a gap in I shows a pattern", CURVED + "walker.c", ".near_in = before == GRAZE_STATE_I || after == GRAZE_STATE_I,", ".near_in = 0,"),
    ("C95", "a gap in O shows a pattern", CURVED + "walker.c", ".near_out = before == GRAZE_STATE_O || after == GRAZE_STATE_O};", ".near_out = 0};"),
    ("C95", "a gap in B makes B", CURVED + "walker.c", "if (before == GRAZE_STATE_B || after == GRAZE_STATE_B ||", "if ("),
    ("C96", "(a) cells of the tangent planes", CURVED + "state.c", "    see_cells(g, smooth);\n    graze_state", "    graze_state"),
    ("C96", "(c) circuits of d + 1 members", CURVED + "circuits.c", "is_linear(g, c) || c->size == g->dimension + 1 ? none", "is_linear(g, c) ? none"),
    ("C96", "(c) circuits of planes alone", CURVED + "circuits.c", "if (g->member[c->member[k]].degree > 1)", "if (0)"),
    ("C97", "circuits of d members", CURVED + "circuits.c", "c->size == g->dimension                      ? take_on_curve(g, c)",
     "c->size == g->dimension                      ? unknown"),
    ("C97", "an odd order shows both signs", CURVED + "circuits.c", "out = sign == 0 ? none : order % 2 ? both : takes_one(sign, TAKES_NOT);",
     "out = sign == 0 ? none : takes_one(sign, TAKES_NOT);"),
    ("C97", "an even order shows one sign", CURVED + "circuits.c", "out = sign == 0 ? none : order % 2 ? both : takes_one(sign, TAKES_NOT);",
     "out = sign == 0 ? none : both;"),
    ("C97", "a definite form takes one sign", CURVED + "circuits.c", "            out = takes_one(first, TAKES_NOT);", "            out = unknown;"),
    ("C98", "a ridge", CURVED + "circuits.c", "out = take_on_ridge(g, c, &p, first ? 0 : 1, first ? first : second);", "out = unknown;"),
    ("C98", "the other sign along the ridge", CURVED + "circuits.c", "int other = rest != 0 && (order % 2 || rest == -sign);", "int other = 0;"),
    ("C98", "a ridge in the second coordinate", CURVED + "circuits.c", "else if (first || second)", "else if (first)"),
    ("C99", "definite forms", CURVED + "apex.c", "            exclude_by_definite_form(g, k);", "            (void)exclude_by_definite_form;"),
    ("C99", "of definite forms alone", CURVED + "apex.c", "field_sign(g->f, h + 11) > 0 && field_sign(g->f, h) == sign", "sign"),
    ("C129", "(a) directions show patterns", CURVED + "apex.c", "        if (!flat)\n            pattern_add(&a->g->seen, negative);", "        (void)flat;"),
    ("C129", "(a) the opposite direction", CURVED + "apex.c", "way++, negative ^= a->odd)", "way++)"),
    ("C129", "(b) homogeneous members have no other pattern", CURVED + "apex.c", "if (!pattern_has(&a.shown, s & a.homogeneous))", "if (0)"),
    ("C129", "(b) of homogeneous members alone", CURVED + "apex.c", "(unsigned)(taylor_order(t) == t->degree) << k;", "1u << k;"),
    ("C129", "(d) leading coefficients", CURVED + "apex.c", "        cut_by_leading_term(&in_x, a, k);", "        (void)cut_by_leading_term;"),
    ("C129", "(d) discriminants", CURVED + "apex.c", "for (int i = 0; i <= k &&", "for (int i = 0; i < k &&"),
    ("C129", "(d) resultants", CURVED + "apex.c", "for (int i = 0; i <= k &&", "for (int i = k; i <= k &&"),
    ("C100", "curves in two surfaces", CURVED + "state.c", "            see_in_curves(g, smooth, j, k);", "            (void)see_in_curves;"),
    ("C100", "curves in one surface", CURVED + "state.c", "        see_in_surfaces(g, smooth, k);\n", "        (void)see_in_surfaces;\n"),
    ("C126", "the horizontal sides", CURVED + "stack.c", "k < n + 2 && small", "k < n && small"),
    ("C126", "the vertical line", CURVED + "stack.c", "        small = meet_once(s, 1, k, vertical);", "        (void)k;"),
    ("C126", "two branches of one member", CURVED + "stack.c", "j <= k && small", "j < k && small"),
    ("C126", "branches of two members", CURVED + "stack.c", "for (size_t j = 0; j <= k", "for (size_t j = k < n ? k : 0; j <= k"),
    ("C126", "the stack on the left", CURVED + "stack.c", "for (int side = 0; side < 2 && !s.status", "for (int side = 1; side < 2 && !s.status"),
    ("C126", "the stack on the right", CURVED + "stack.c", "for (int side = 0; side < 2 && !s.status", "for (int side = 0; side < 1 && !s.status"),
    ("C101", "gaps are cut at the roots of what was asked", CURVED + "walker.c",
     "        status = find_slide_cuts(&cuts, w, &f, low, high);", "        (void)find_slide_cuts;"),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build")
    parser.add_argument("--only", default="", help="rules whose claim or words hold this text")
    options = parser.parse_args()
    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        worker = Worker(Parts(options.build, folder), "worker", time.time() + 36000)
        for claim, words, path, text, without in RULES:
            if options.only not in claim + " " + words:
                continue
            with open(path, encoding="utf-8") as file:
                source = file.read()
            if source.count(text) != 1 or worker.compiled(path, source.replace(text, without)) is None:
                raise SystemExit(f"{path}: {claim}, {words}: the text is not there once, or does not compile without it")
            worker.link_program(path)
            noticed = next((asker for asker in ROOMS[os.path.dirname(path)[len("src/"):]] if worker.is_noticed_by(asker)), None)
            print(f"{claim} {words}: {noticed or 'UNNOTICED'}", flush=True)
            passed, failed = passed + bool(noticed), failed + (not noticed)
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed or not passed else 0)


if __name__ == "__main__":
    main()
