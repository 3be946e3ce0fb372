(* The checker as an OCaml program, checker.ml: integers are Zarith's, natural numbers OCaml's.
   SPDX-License-Identifier: GPL-3.0-or-later

   What is written here is believed: that each of Zarith's functions is the one of Coq beside it. *)
Require Import List ZArith Bool Extraction.
Require ExtrOcamlBasic ExtrOcamlNatInt.
Require Import Graze.words Graze.definitions Graze.interval Graze.row Graze.simplices Graze.motions.

Extract Inductive positive => "Z.t"
  ["(fun p -> Z.succ (Z.shift_left p 1))" "(fun p -> Z.shift_left p 1)" "Z.one"]
  "(fun odd even one p -> if Z.equal p Z.one then one () else if Z.is_odd p then odd (Z.shift_right p 1) else even (Z.shift_right p 1))".
Extract Inductive Z => "Z.t" ["Z.zero" "" "Z.neg"]
  "(fun zero positive negative z -> match Z.sign z with 0 -> zero () | 1 -> positive z | _ -> negative (Z.neg z))".
Extract Inlined Constant Z.add => "Z.add".
Extract Inlined Constant Z.sub => "Z.sub".
Extract Inlined Constant Z.mul => "Z.mul".
Extract Inlined Constant Z.opp => "Z.neg".
Extract Inlined Constant Z.abs => "Z.abs".
Extract Inlined Constant Z.max => "Z.max".
Extract Inlined Constant Z.min => "Z.min".
Extract Inlined Constant Z.gcd => "Z.gcd".
Extract Inlined Constant Z.eqb => "Z.equal".
Extract Inlined Constant Z.leb => "Z.leq".
Extract Inlined Constant Z.ltb => "Z.lt".
Extract Inlined Constant Z.sgn => "(fun z -> Z.of_int (Z.sign z))".
Extract Inlined Constant Z.div => "(fun a b -> if Z.equal b Z.zero then Z.zero else Z.fdiv a b)".
Extract Inlined Constant Z.of_nat => "Z.of_int".
Extract Inlined Constant Z.pow => "(fun a n -> Z.pow a (Z.to_int n))".

Extraction "checker.ml" facets_of check_motion check_row.
