(* Rational functions of t: quotients of polynomials over Q, the constant coefficient first, reduced.
   SPDX-License-Identifier: GPL-3.0-or-later *)

(* What is not read here, with the reason: exit status 2. What no motion or solid has: status 1. *)
exception Unread of string
exception Refuted of string

(* Work, in products of two words, before it is done: so much at the beginning, and more of it for each piece (K14). *)
let most_work = 1 lsl 28
let piece_work = 1 lsl 23
let work_left = ref most_work
let work_allow more = work_left := min most_work (!work_left + more)

let work_on a b =
  let size q = Z.size (Q.num q) + Z.size (Q.den q) in
  work_left := !work_left - (size a * size b) - 64;
  if !work_left < 0 then
    raise (Unread (Printf.sprintf "numbers of %d and %d words are too much work in this motion" (size a) (size b)))

type poly = Q.t list
type t = { num : poly; den : poly }

let rec trim = function
  | [] -> []
  | c :: p -> ( match trim p with [] when Q.sign c = 0 -> [] | q -> c :: q)

let rec add p q =
  match (p, q) with [], r | r, [] -> r | c :: p, e :: q -> work_on c e; Q.add c e :: add p q

let scale c = List.map (fun e -> work_on c e; Q.mul c e)
let rec mul p q = match p with [] -> [] | c :: p -> add (scale c q) (Q.zero :: mul p q)
let degree p = List.length p - 1
let leading p = List.nth p (degree p)

(* Quotient and remainder; q is trimmed and not zero. *)
let rec divide p q =
  let p = trim p in
  let n = degree p - degree q in
  if n < 0 then ([], p)
  else
    let () = work_on (leading p) (leading q) in
    let term = List.init (n + 1) (fun k -> if k = n then Q.div (leading p) (leading q) else Q.zero) in
    let quotient, rest = divide (add p (scale Q.minus_one (mul term q))) q in
    (add quotient term, rest)

let rec gcd p q = if q = [] then p else gcd q (snd (divide p q))

let make num den =
  let num = trim num and den = trim den in
  if den = [] then raise (Refuted "motion: a division by zero");
  match den with
  | [ c ] -> { num = scale (Q.inv c) num; den = [ Q.one ] }
  | _ ->
      let g = gcd den num in
      { num = trim (fst (divide num g)); den = trim (fst (divide den g)) }

(* c t^k *)
let monomial c k = make (List.init (k + 1) (fun i -> if i = k then c else Q.zero)) [ Q.one ]
let zero = monomial Q.zero 0
let one = monomial Q.one 0
let ( +: ) a b = make (add (mul a.num b.den) (mul b.num a.den)) (mul a.den b.den)
let ( *: ) a b = make (mul a.num b.num) (mul a.den b.den)
let ( -: ) a b = a +: (monomial Q.minus_one 0 *: b)
let ( /: ) a b = make (mul a.num b.den) (mul a.den b.num)
