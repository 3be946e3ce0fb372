(* Motion files: to pieces with integer polynomials, the inverse map beside the map.
   SPDX-License-Identifier: GPL-3.0-or-later

   A map is d rows, each its translation and then its coefficients. The inverse is a hint: the verified
   checker tests it. The map itself is believed to be what the file says. *)
open Fraction
open Text

type map = Fraction.t list list
type piece = { lo : Q.t; hi : Q.t; map : map }

let identity d = List.init d (fun i -> zero :: List.init d (fun j -> if i = j then one else zero))
let sum = List.fold_left ( +: ) zero
let column k m = List.map (fun row -> List.nth row k) m

(* a after b *)
let compose a b =
  let d = List.length a in
  List.map
    (fun row ->
      let image k = sum (List.map2 ( *: ) (List.tl row) (column k b)) in
      List.init (d + 1) (fun k -> if k = 0 then List.hd row +: image 0 else image k))
    a

let shifted c = List.mapi (fun i row -> List.nth c i :: List.tl row) (identity (List.length c))
let negated = List.map (fun f -> zero -: f)
let about center m = match center with None -> m | Some c -> compose (shifted c) (compose m (shifted (negated c)))

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

(* (w, x, y, z): I + 2 (w [v] + [v]^2) / |q|^2 for v = (x, y, z); in the plane its first two rows. *)
let of_quaternion d q =
  let e k = List.nth q k in
  let norm = sum (List.map (fun f -> f *: f) q) in
  let rot i j =
    let k = 3 - i - j in
    if i = j then
      let a = (i + 1) mod 3 and b = (i + 2) mod 3 in
      one -: (integer 2 *: ((e (a + 1) *: e (a + 1)) +: (e (b + 1) *: e (b + 1))) /: norm)
    else
      let sign = integer (if (i + 1) mod 3 = j then -2 else 2) in
      ((integer 2 *: e (i + 1) *: e (j + 1)) +: (sign *: e 0 *: e (k + 1))) /: norm in
  List.init d (fun i -> zero :: List.init d (rot i))

(* Rotation by n times 2 atan (tan) about the unit vector v: the half angle is that of (1 + i tan)^n. *)
let rotation d v tan n =
  if abs n > 300 then unread "the motion rotates more than 300 times";
  let tan = if n < 0 then zero -: tan else tan in
  let rec turned k = if k = 0 then (one, zero) else
      let a, b = turned (k - 1) in
      (a -: (b *: tan), b +: (a *: tan)) in
  let a, b = turned (abs n) in
  of_quaternion d (a :: List.map (fun c -> b *: c) v)

let only keys where =
  match where with
  | Object pairs -> List.iter (fun (k, _) -> if not (List.mem k keys) then unread ("key '" ^ k ^ "' is not expected")) pairs
  | _ -> unread "an object is expected"

let exactly n where =
  let l = items where in
  if List.length l <> n then unread (Printf.sprintf "an array of %d entries is expected" n);
  l

let whole where =
  let q = constant_entry where in
  if Z.equal (Q.den q) Z.one && Z.leq (Z.abs (Q.num q)) (Z.of_int 10000) then Z.to_int (Q.num q)
  else unread "a whole number is expected"

let entries ~s n where = List.map (fun x -> entry ~s x) (exactly n where)

let axis ~s d where =
  match (member "axis" where, d) with
  | None, 2 -> [ zero; zero; one ]
  | Some a, 3 ->
      let v = List.map (fun f -> match value f with Some q -> q | None -> unread "an axis that is not constant")
          (entries ~s 3 a) in
      let length = List.fold_left (fun sum c -> Q.add sum (Q.mul c c)) Q.zero v in
      if Q.sign length = 0 || not (Z.perfect_square (Q.num length) && Z.perfect_square (Q.den length)) then
        unread "the length of the axis is zero or not rational";
      let root = Q.make (Z.sqrt (Q.num length)) (Z.sqrt (Q.den length)) in
      List.map (fun c -> constant (Q.div c root)) v
  | _ -> unread "an axis is for three dimensions, and wanted there"

(* s is (t - lo) / (hi - lo); `from` is where in [0, 1] the part begins that is read. *)
let rec transform ~s ~from d where =
  let center key_of = Option.map (entries ~s d) (member "center" key_of) in
  match where with
  | Object pairs when List.length (List.filter (fun (k, _) -> k <> "center") pairs) = 1 ->
      let key, x = List.find (fun (k, _) -> k <> "center") pairs in
      if List.mem_assoc "center" pairs && key <> "quaternion" && key <> "scale" then
        unread "center stands beside quaternion or scale";
      let m = match key with
        | "matrix" -> matrix ~s d x
        | "translate" -> shifted (entries ~s d x)
        | "rotate" ->
            only [ "tan_half"; "times"; "center"; "axis" ] x;
            let n = match member "times" x with None -> 1 | Some n -> whole n in
            about (center x) (rotation d (axis ~s d x) (entry ~s (wanted "tan_half" x)) n)
        | "turn" -> turn ~s ~from d x center
        | "quaternion" when d = 3 -> of_quaternion d (entries ~s 4 x)
        | "scale" ->
            let f = match x with List _ -> entries ~s d x | _ -> List.init d (fun _ -> entry ~s x) in
            List.mapi (fun i row -> List.map (fun e -> List.nth f i *: e) row) (identity d)
        | "compose" -> List.fold_left (fun m step -> compose (transform ~s ~from d step) m) (identity d) (items x)
        | _ -> unread ("key '" ^ key ^ "' is not expected here") in
      about (center where) m
  | _ -> unread "a transform is expected: an object of one kind"

and matrix ~s d x =
  let rows = List.map (entries ~s (d + 1)) (items x) in
  let last = List.init (d + 1) (fun k -> if k = d then one else zero) in
  if not (List.length rows = d || (List.length rows = d + 1 && List.nth rows d = last)) then
    unread "a matrix has d rows, or d + 1 of which the last is 0 ... 0 1";
  List.init d (fun i ->
      let row = List.nth rows i in
      List.nth row d :: List.init d (fun k -> List.nth row k))

(* On the part [j/n, (j+1)/n] of n quarters: j quarters, then one with tan = n s - j. *)
and turn ~s ~from d x center =
  only [ "quarters"; "center"; "axis" ] x;
  let quarters = whole (wanted "quarters" x) in
  let n = abs quarters and sign = if quarters < 0 then -1 else 1 in
  let v = axis ~s d x in
  let part = Q.mul from (Q.of_int n) in
  let j = Z.fdiv (Q.num part) (Q.den part) in
  let quarter = rotation d v one (sign * Z.to_int (Z.erem j (Z.of_int 4))) in
  let m = if n = 0 then quarter
    else compose (rotation d v ((integer n *: s) -: constant (Q.of_bigint j)) sign) quarter in
  about (center x) m

(* The numbers of parts that turns within a transform ask for. *)
let rec parts where =
  let own = match Option.map (wanted "quarters") (member "turn" where) with
    | Some q -> [ max 1 (abs (whole q)) ]
    | None -> [] in
  own @ match member "compose" where with Some l -> List.concat_map parts (items l) | None -> []

let pieces_of d where =
  only [ "t"; "transform" ] where;
  let lo, hi = match List.map constant_entry (exactly 2 (wanted "t" where)) with [ a; b ] -> (a, b) | _ -> assert false in
  if Q.geq lo hi then raise (Refuted "motion: a piece does not have lo < hi");
  let x = wanted "transform" where and width = Q.sub hi lo in
  let s = (t -: constant lo) /: constant width in
  let cuts = List.sort_uniq Q.compare
      (List.concat_map (fun n -> List.init (n + 1) (fun i -> Q.of_ints i n)) (1 :: parts x)) in
  let time part = Q.add lo (Q.mul part width) in
  let rec cut = function
    | a :: (b :: _ as rest) -> { lo = time a; hi = time b; map = transform ~s ~from:a d x } :: cut rest
    | _ -> [] in
  cut cuts

(* Key frames: positions and quaternions (in the plane complex numbers) linear between them. *)
let frames d where =
  let kind = if d = 3 then "quaternion" else "complex" in
  let frame x =
    only [ "t"; "position"; kind ] x;
    let numbers n key default = match member key x with
      | Some l -> List.map constant_entry (exactly n l) | None -> default in
    let position = numbers d "position" (List.init d (fun _ -> Q.zero)) in
    let q = match numbers (2 * d - 2) kind (List.init (2 * d - 2) (fun k -> if k = 0 then Q.one else Q.zero)) with
      | [ re; im ] -> [ re; Q.zero; Q.zero; im ] | q -> q in
    (constant_entry (wanted "t" x), position, q) in
  let l = items where in
  if List.length l < 2 then unread "at least two frames are expected";
  let size = function Object pairs -> List.length pairs | _ -> 0 in
  if List.exists (fun x -> size x <> size (List.hd l)) l then unread "a frame lacks what another has";
  let rec between = function
    | (lo, p, q) :: ((hi, p', q') :: _ as rest) ->
        if Q.geq lo hi then raise (Refuted "motion: a piece does not have lo < hi");
        let s = (t -: constant lo) /: constant (Q.sub hi lo) in
        let linear a b = constant a +: (constant (Q.sub b a) *: s) in
        let rows = of_quaternion d (List.map2 linear q q') in
        let map = List.map2 (fun c row -> c :: List.tl row) (List.map2 linear p p') rows in
        { lo; hi; map } :: between rest
    | _ -> [] in
  between (List.map frame l)

let first ps = (List.hd ps).lo
let last ps = (List.nth ps (List.length ps - 1)).hi

let rec read where =
  let d = match wanted "dimension" where with
    | Number "2" -> 2 | Number "3" -> 3 | _ -> unread "the dimension is 2 or 3" in
  let inner x = let k, ps = read x in if k <> d then unread "the dimension is that of the motion around" else ps in
  match where with
  | Object [ (k, x); (l, y) ] when k = "dimension" || l = "dimension" ->
      let key, x = if k = "dimension" then (l, y) else (k, x) in
      let ps = match key with
        | "pieces" -> List.concat_map (pieces_of d) (items x)
        | "keyframes" -> frames d x
        | "relative" ->
            only [ "moving"; "frame" ] x;
            relative (inner (wanted "moving" x)) (inner (wanted "frame" x))
        | "sequence" -> sequence d (List.map inner (items x))
        | _ -> unread ("key '" ^ key ^ "' is not expected") in
      if ps = [] then unread "a motion has at least one piece";
      (d, ps)
  | _ -> unread "a motion has a dimension and one thing more"

(* frame^-1 moving, on the common pieces *)
and relative a b =
  if not (Q.equal (first a) (first b) && Q.equal (last a) (last b)) then
    raise (Refuted "motion: moving and frame do not have one interval of time");
  let rec go lo a b = match (a, b) with
    | p :: ps, q :: qs ->
        let hi = Q.min p.hi q.hi in
        { lo; hi; map = compose (inverse q.map) p.map }
        :: go hi (if Q.equal hi p.hi then ps else a) (if Q.equal hi q.hi then qs else b)
    | _ -> [] in
  go (first a) a b

(* On [j - 1, j] motion j after what the motions before it have ended in. *)
and sequence d motions =
  let step (j, ended, out) ps =
    let b = Q.sub (last ps) (first ps) in
    let a = Q.sub (first ps) (Q.mul (Q.of_int j) b) in
    let time x = Q.div (Q.sub x a) b in
    let moved = List.map (fun p ->
        { lo = time p.lo; hi = time p.hi;
          map = compose (List.map (List.map (fun f -> substitute f a b)) p.map) ended }) ps in
    let final = (List.nth moved (List.length moved - 1)).map in
    (j + 1, List.map (List.map (fun f -> at f (Q.of_int (j + 1)))) final, out @ moved) in
  let _, _, out = List.fold_left step (0, identity d, []) motions in
  out

(* ---------------------------------------------------------------- integer polynomials *)
(* The map over one denominator, without a common factor: rows and denominator. *)
let over_one_denominator m =
  let all = List.concat m in
  let lcm p q = mul p (fst (divide q (gcd p q))) in
  let den = List.fold_left (fun w f -> lcm w f.den) [ Q.one ] all in
  let numerator f = trim (mul f.num (fst (divide den f.den))) in
  let rows = List.map (List.map numerator) m in
  let numbers = List.concat (den :: List.concat rows) in
  let multiple = List.fold_left (fun z q -> Z.lcm z (Q.den q)) Z.one numbers in
  let integers p = List.map (fun q -> Q.num (Q.mul (Q.of_bigint multiple) q)) p in
  let content = List.fold_left (fun g q -> Z.gcd g (Q.num (Q.mul (Q.of_bigint multiple) q))) Z.zero numbers in
  let reduce p = List.map (fun z -> Z.divexact z content) (integers p) in
  (List.map (List.map reduce) rows, reduce (trim den))

let time q = (Q.num q, Q.den q)

let piece p : Checker.piece =
  let forward, forward_weight = over_one_denominator p.map in
  let backward, backward_weight = over_one_denominator (inverse p.map) in
  { begins = time p.lo; finishes = time p.hi; forward; forward_weight; backward; backward_weight }
