#!/usr/bin/env python3
"""Definitions made false on purpose: for each a proof must fail, at the lemma named beside it.

A variant is a change of one text in a copy of one file of proofs/coq. Files before the change are compiled
once; from there on all are compiled until one fails. That the unchanged copy compiles is checked first.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import concurrent.futures
import os
import re
import shutil

from coq import Checks, compile_file, copy, lemma_at, order

# The false claim, the file, the text and its replacement, the file and the lemma that must fail.
VARIANTS = [
    ("at t0 a germ O makes the intersection", "words.v",
     "| (None, Some b) => state_eqb b I ", "| (None, Some b) => state_eqb b O ", "words.v", "crossing_swap"),
    ("at both ends a germ O makes the intersection", "words.v",
     """state_eqb b I          (* at t0: Definition 4 *)
  | (Some a, None) => state_eqb a I """, """state_eqb b O
  | (Some a, None) => state_eqb a O """, "counts.v", "parity_after"),
    ("a contact between equal states is an intersection", "words.v",
     "negb (state_eqb a b)", "state_eqb a b", "counts.v", "parity_after"),
    ("a contact that is the whole motion is an intersection", "words.v",
     "| (None, None) => false", "| (None, None) => true", "counts.v", "doubled_runs"),
    ("k without the end at t1", "words.v",
     "(i_of w + inside (first w) + inside (last_of w)) / 2", "(i_of w + inside (first w)) / 2",
     "words.v", "k_rev"),
    ("I and O are neighbours", "words.v",
     "xorb (state_eqb a B) (state_eqb b B)", "negb (state_eqb a b)", "words.v", "after_letter_ind"),
    ("Definition 6 from k = 1 on", "definitions.v",
     "nat) : Prop := exists k, k >= 2", "nat) : Prop := exists k, k >= 1",
     "definitions.v", "rule_is_definitions"),
    ("Definition 7 without a tangency", "definitions.v",
     "exists k j, k >= 1 /\\ j >= 1", "exists k j, k >= 1 /\\ j >= 0",
     "definitions.v", "rule_is_definitions"),
    ("Definition 10 from k = 1 on", "definitions.v",
     "exists k j, k >= 2 /\\ j >= 1", "exists k j, k >= 1 /\\ j >= 1",
     "definitions.v", "rule_is_definitions"),
    ("a touch alone is outside", "definitions.v",
     "| 0, S _, _ => boundary", "| 0, S _, _ => exterior", "definitions.v", "class_of_spec"),
    ("a fold that is touched is a fold, also separately", "definitions.v",
     "| S (S _), S _, separate => fold_boundary", "| S (S _), S _, separate => fold",
     "definitions.v", "class_of_spec"),
    ("case 5 is taken for case 4", "definitions.v", "| B, B => 5", "| B, B => 4",
     "definitions.v", "apart_cases"),
    ("an unsweep's contact comes before its O", "unsweep.v",
     "if existsb (state_eqb O) w then out else if existsb (state_eqb B) w then on",
     "if existsb (state_eqb B) w then on else if existsb (state_eqb O) w then out",
     "unsweep.v", "unsweep_out"),
    ("a word may repeat a letter", "times.v",
     "x <> y /\\ stutter_free rest", "stutter_free rest", "times.v", "stutter_free_nth"),
    ("the walk along a word may go back", "times.v",
     "u <= b -> (m t <= m u)%nat", "u <= b -> (m t <= m t)%nat", "times.v", "walk_behind"),
    ("an open state need not last", "times.v", "exists d, d > 0 /\\", "exists d, d >= 0 /\\",
     "times.v", "open_letters_apart"),
    ("an interior point without room", "space.v",
     "exists e, e > 0 /\\ forall y, near x e y -> A y.", "exists e, e >= 0 /\\ forall y, near x e y -> A y.",
     "space.v", "interior_in"),
    ("O is all of the complement", "space.v",
     "| O => interior (complement A) x", "| O => complement A x", "space.v", "state_functional"),
    ("a rational function may have a pole", "polynomials.v",
     "eval q t <> 0 /\\ f t =", "True /\\ f t =", "polynomials.v", "rational_plus"),
    ("points agree if forms negative at one are so at the other", "finite.v",
     "sign (value f x) = sign (value f y).", "sign (value f x) = Lt -> sign (value f y) = Lt.",
     "finite.v", "agree_sym"),
    ("a coefficient 0 counts as positive", "bernstein.v",
     "(S n) && forallb (Z.ltb 0) l.", "(S n) && forallb (Z.leb 0) l.", "bernstein.v", "strict_value"),
    ("a root's polynomial may be 0 at the interval's end", "bernstein.v",
     "Z.ltb 0 (last l 0%Z)", "Z.leb 0 (last l 0%Z)", "bernstein.v", "one_root_rising"),
    ("a facet is without its rim", "facets.v",
     "forall g, In g (sides f) -> 0 <= zvalue g x.", "forall g, In g (sides f) -> 0 < zvalue g x.",
     "ray.v", "inner_on"),
    ("a crossing counts the other way", "sample.v", "then Some (Z.sgn n)", "then Some (- Z.sgn n)%Z",
     "sample.v", "crossing_tested"),
    ("a facet is clear where a side's form has no sign", "interval.v",
     "|| existsb (fun g => Z.ltb (sign_of v g) 0) (sides f).",
     "|| existsb (fun g => Z.leb (sign_of v g) 0) (sides f).", "interval_sound.v", "cleared_off"),
    ("an odd power of the root keeps its sign", "interval.v",
     "after := Some (- (s * left))%Z", "after := Some (s * left)%Z", "interval_sound.v", "profile_sound"),
    ("a facet's plane is left where its form may be zero", "interval.v",
     "known (fun z => negb (Z.eqb z 0)) (pick (fst p))", "known (fun z => true) (pick (fst p))",
     "interval_sound.v", "off_side_off"),
    ("a facet holds beyond its sides", "interval.v",
     "forallb (fun s => known (Z.leb 0) (pick s)) (snd p).", "forallb (fun s => true) (snd p).",
     "interval_sound.v", "holds_on"),
    ("equal states beside a root force a contact", "interval.v",
     "negb (state_eqb x y)", "state_eqb x y", "interval_sound.v", "forced_B"),
    ("the ray's sum is 1 outside", "interval.v",
     "match x with I => 1 | _ => 0 end", "match x with I => 0 | _ => 1 end", "interval_sound.v", "state_ok_state"),
    ("a row may end before t1", "row.v",
     "if same_time u last then Some (letters k) else None", "Some (letters k)", "row.v", "follow_sound"),
    ("a simplex has points of negative weights", "simplices.v",
     "weighted scale s w x /\\ forall u, In u w -> 0 <= u.", "weighted scale s w x /\\ forall u, In u w -> u <= 1.",
     "simplices.v", "facet_on"),
    ("a motion may have poles", "motions.v",
     "negb (Z.eqb (strict n (bern l h d n q)) 0).", "true.", "motions.v", "sign_on_value"),
    ("a convex solid has vertices before a plane", "convex.v",
     "forallb (Z.leb 0) (behind scale s u)\n", "forallb (fun c => true) (behind scale s u)\n",
     "convex.v", "hull_behind"),
    ("a convex solid has no point behind all planes", "convex.v",
     "forallb (fun s => Z.ltb 0 (depth scale ss s)) ss", "forallb (fun s => Z.leb 0 (depth scale ss s)) ss",
     "convex.v", "convex_legal"),
    ("a face ends at a side where it is left", "convex.v",
     "| 0%nat => false\n    | S n => existsb", "| 0%nat => true\n    | S n => existsb", "convex.v", "walk_covers"),
]
ERROR = re.compile(r'^File "\./([\w.]+)", line (\d+)', re.M)


def try_variant(build, number, files, variant):
    """Where the variant fails, as (file, lemma), or a text that says why it does not count."""
    _, changed, old, new, _, _ = variant
    folder = os.path.join(build, "proofs-broken", str(number))
    copy(folder)
    path = os.path.join(folder, changed)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if text.count(old) != 1:
        return f"expected to find once in {changed}: {old}"
    text = text.replace(old, new)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    first = files.index(changed)
    for name in files[:first]:
        for made in (name + "o", name[:-2] + ".glob"):
            shutil.copy(os.path.join(build, "proofs", made), folder)
    for name in files[first:]:
        done = compile_file(folder, name)
        if done.returncode:
            place = ERROR.search(done.stderr)
            if not place or place.group(1) != name:
                return f"{name}: {done.stderr}"
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                return name, lemma_at(file.read(), int(place.group(2)))
    return "nothing fails"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", default="build")
    parser.add_argument("--sample", action="store_true", help="one of six variants, where nothing has changed that the proofs are about")
    args = parser.parse_args()
    checks = Checks()
    files = order(os.path.join(args.build, "proofs"))
    for name in files:
        checks.holds(os.path.exists(os.path.join(args.build, "proofs", name + "o")),
                     f"{name} is compiled unchanged")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        asked = list(enumerate(VARIANTS))[::6 if args.sample else 1]
        found = pool.map(lambda v: try_variant(args.build, v[0], files, v[1]), asked)
        for (_, variant), where in zip(asked, found):
            what, _, _, _, file, lemma = variant
            if checks.holds(where == (file, lemma), f"{what}: expected a failure in {file}, {lemma}: {where}"):
                print(f"{what}: fails in {file}, {lemma}")
    checks.finish()


if __name__ == "__main__":
    main()
