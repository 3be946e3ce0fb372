(* The checker as an OCaml program, checker.ml: integers are Zarith's (under the name Integer), natural numbers OCaml's.
   SPDX-License-Identifier: GPL-3.0-or-later

   What is written here is believed: that each of Zarith's functions is the one of Coq beside it. *)
Require Import List ZArith Bool Extraction.
Require ExtrOcamlBasic ExtrOcamlNatInt.
Require Import Graze.words Graze.definitions Graze.interval Graze.row Graze.simplices Graze.motions Graze.convex.

Extract Inductive positive => "Integer.t"
  ["(fun p -> Integer.succ (Integer.shift_left p 1))" "(fun p -> Integer.shift_left p 1)" "Integer.one"]
  "(fun odd even one p -> if Integer.equal p Integer.one then one () else if Integer.is_odd p then odd (Integer.shift_right p 1) else even (Integer.shift_right p 1))".
Extract Inductive Z => "Integer.t" ["Integer.zero" "" "Integer.neg"]
  "(fun zero positive negative z -> match Integer.sign z with 0 -> zero () | 1 -> positive z | _ -> negative (Integer.neg z))".
Extract Inlined Constant Z.add => "Integer.add".
Extract Inlined Constant Z.sub => "Integer.sub".
Extract Inlined Constant Z.mul => "Integer.mul".
Extract Inlined Constant Z.opp => "Integer.neg".
Extract Inlined Constant Z.abs => "Integer.abs".
Extract Inlined Constant Z.max => "Integer.max".
Extract Inlined Constant Z.min => "Integer.min".
Extract Inlined Constant Z.gcd => "Integer.gcd".
Extract Inlined Constant Z.eqb => "Integer.equal".
Extract Inlined Constant Z.leb => "Integer.leq".
Extract Inlined Constant Z.ltb => "Integer.lt".
Extract Inlined Constant Z.sgn => "(fun z -> Integer.of_int (Integer.sign z))".
Extract Inlined Constant Z.div => "(fun a b -> if Integer.equal b Integer.zero then Integer.zero else Integer.fdiv a b)".
Extract Inlined Constant Z.of_nat => "Integer.of_int".
Extract Inlined Constant Z.pow => "(fun a n -> Integer.pow a (Integer.to_int n))".

Extraction "checker.ml" facets_of convex_ok check_motion check_row.
