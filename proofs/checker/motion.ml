(* Motion files of plain pieces, as graze convert writes them: integer polynomials, the inverse map beside the map.
   SPDX-License-Identifier: GPL-3.0-or-later

   A map is d rows, each its translation and then its coefficients. The inverse is a hint: the verified
   checker tests it. The map itself is believed to be what the file says. *)
open Fraction
open Text

type map = Fraction.t list list
type piece = { lo : Q.t; hi : Q.t; map : map }

let sum = List.fold_left ( +: ) zero
let column k m = List.map (fun row -> List.nth row k) m

let minor m (i, j) (k, l) =
  let e i k = List.nth (List.nth m i) (k + 1) in
  (e i k *: e j l) -: (e i l *: e j k)

let inverse m =
  let d = List.length m in
  let e i k = List.nth (List.nth m i) (k + 1) in
  (* Entry (i, k) of the adjugate; in space cyclic indices bring the sign. *)
  let cofactor i k =
    if d = 3 then minor m ((k + 1) mod 3, (k + 2) mod 3) ((i + 1) mod 3, (i + 2) mod 3)
    else if i = k then e (1 - i) (1 - i)
    else zero -: e i k in
  let det = sum (List.init d (fun k -> cofactor 0 k *: e k 0)) in
  if det.num = [] then raise (Refuted "motion: the determinant is zero");
  List.init d (fun i ->
      let row = List.init d (fun k -> cofactor i k /: det) in
      (zero -: sum (List.map2 ( *: ) row (column 0 m))) :: row)

let exactly n where =
  let l = items where in
  if List.length l <> n then unread (Printf.sprintf "an array of %d entries is expected" n);
  l

let transform d = function
  | Object [ ("translate", x) ] ->
      let row i c = entry c :: List.init d (fun k -> if i = k then one else zero) in
      List.mapi row (exactly d x)
  | Object [ ("matrix", x) ] ->
      let row r =
        let entries = List.map entry (exactly (d + 1) r) in
        List.nth entries d :: List.filteri (fun k _ -> k < d) entries in
      List.map row (exactly d x)
  | _ -> unread "a transform is a matrix or a translation"

let plain_piece d = function
  | Object ([ ("t", times); ("transform", x) ] | [ ("t", times); ("row", Number _); ("transform", x) ]) ->
      work_allow piece_work;
      let time k = number (content (List.nth (exactly 2 times) k)) in
      if Q.geq (time 0) (time 1) then raise (Refuted "motion: a piece does not have lo < hi");
      { lo = time 0; hi = time 1; map = transform d x }
  | _ -> unread "a piece has t and transform"

let read = function
  | Object [ ("dimension", Number (("2" | "3") as d)); ("pieces", List (_ :: _ as pieces)) ] ->
      let d = int_of_string d in
      (d, List.map (plain_piece d) pieces)
  | _ -> unread "a motion has a dimension and plain pieces"

(* The map over one denominator, without a common factor: rows and denominator. *)
let over_one_denominator m =
  let all = List.concat m in
  let lcm p q = mul p (fst (divide q (gcd p q))) in
  let den = List.fold_left (fun w f -> lcm w f.den) [ Q.one ] all in
  let numerator f = trim (mul f.num (fst (divide den f.den))) in
  let rows = List.map (List.map numerator) m in
  let numbers = List.concat (den :: List.concat rows) in
  let multiple = List.fold_left (fun z q -> work_on (Q.of_bigint z) q; Z.lcm z (Q.den q)) Z.one numbers in
  let integers p = List.map Q.num (scale (Q.of_bigint multiple) p) in
  let content = List.fold_left Z.gcd Z.zero (integers numbers) in
  let reduce p = List.map (fun z -> Z.divexact z content) (integers p) in
  (List.map (List.map reduce) rows, reduce (trim den))

let time q = (Q.num q, Q.den q)

let piece p : Checker.piece =
  work_allow piece_work;
  let forward, forward_weight = over_one_denominator p.map in
  let backward, backward_weight = over_one_denominator (inverse p.map) in
  { begins = time p.lo; finishes = time p.hi; forward; forward_weight; backward; backward_weight }
