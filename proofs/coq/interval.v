(* What a certificate claims of one interval of time, and the tests that prove it (claims K7 to K11).
   SPDX-License-Identifier: GPL-3.0-or-later

   [view]       an interval [lo/den, hi/den], the polynomials W, X_1, ..., X_d of the trajectory, and
                their coefficients on it to degree `degree`
   [cleared]    tests L1, L2 and L3: a bound or a side is negative, or the plane's form has a sign
   [profile]    what is known of the sign of a form before, at and after the root of q
   [off_side]   tests L4 and L5; [holds] the facet holds the trajectory there
   [interval_ok]  the tests of an interval; interval_sound.v proves them right
   [letters]    the states that they prove *)
Require Import List ZArith Bool.
Require Import Graze.words Graze.bernstein Graze.facets Graze.sample.
Import ListNotations.

(* ------------------------------------------------------------------ the tests *)
(* The state s all along; or a root of q, in the interval or, where a side is missing, at its end. *)
Inductive kind := stays (s : state) | meets (before after : option state).

Record view := {
  lo : Z; hi : Z; den : Z; degree : nat;
  curve : list (list Z);
  coefficients : list (list Z)
}.

Fixpoint trim (p : list Z) : list Z :=
  match p with
  | [] => []
  | c :: q => match trim q with [] => if Z.eqb c 0 then [] else [c] | r => c :: r end
  end.
(* The combination of polynomials that a form is. *)
Fixpoint pull (f : list Z) (V : list (list Z)) : list Z :=
  match f, V with
  | c :: f', p :: V' => if Z.eqb c 0 then pull f' V' else zadd (zscale c p) (pull f' V')
  | _, _ => []
  end.

Definition sign_of (v : view) (f : list Z) : Z := strict (degree v) (pull f (coefficients v)).
Definition never_negative (v : view) (f : list Z) : bool := no_negative (pull f (coefficients v)).
Definition always_zero (v : view) (f : list Z) : bool := forallb (Z.eqb 0) (pull f (coefficients v)).

Definition cleared (v : view) (f : facet) : bool :=
  existsb (fun g => Z.ltb (sign_of v g) 0) (bounds f)
  || negb (Z.eqb (sign_of v (plane f)) 0)
  || existsb (fun g => Z.ltb (sign_of v g) 0) (sides f).

(* Division from the highest coefficients down; that the quotient is one is tested where it is used. *)
Fixpoint divide (fuel : nat) (f q : list Z) : list Z :=
  match fuel, f, q with
  | S k, c :: _, e :: _ =>
      let m := Z.div c e in m :: divide k (tl (zadd f (zscale (- m) q))) q
  | _, _, _ => []
  end.
Definition quotient (f q : list Z) : list Z :=
  rev (divide (S (length f) - length q) (rev f) (rev q)).
Fixpoint same_list (p q : list Z) : bool :=
  match p, q with
  | [], [] => true
  | c :: p', e :: q' => Z.eqb c e && same_list p' q'
  | _, _ => false
  end.
(* f = q^e r: whether e is odd, whether it is positive, and r. *)
Fixpoint divide_out (fuel : nat) (f q : list Z) : bool * bool * list Z :=
  match fuel with
  | 0%nat => (false, false, f)
  | S k =>
      let g := trim (quotient f q) in
      if same_list (trim (zmul q g)) f
      then let '(odd, _, r) := divide_out k g q in (negb odd, true, r)
      else (false, false, f)
  end.

Record profile := { before : option Z; at_root : option Z; after : option Z }.
Definition profile_of (v : view) (q : list Z) (left : Z) (f : list Z) : profile :=
  let s := sign_of v f in
  if negb (Z.eqb s 0) then {| before := Some s; at_root := Some s; after := Some s |}
  else match trim (pull f (curve v)) with
  | [] => {| before := Some 0%Z; at_root := Some 0%Z; after := Some 0%Z |}
  | p =>
      let '(odd, some, r) := divide_out (length p) p q in
      let n := pred (length r) in
      let s := strict n (bern (lo v) (hi v) (den v) n r) in
      let m := if some then Some 0%Z else None in
      if Z.eqb s 0 then {| before := None; at_root := m; after := None |}
      else if odd then {| before := Some (s * left)%Z; at_root := m; after := Some (- (s * left))%Z |}
      else {| before := Some s; at_root := m; after := Some s |}
  end.

Definition profiles (v : view) (q : list Z) (left : Z) (f : facet) : profile * list profile :=
  (profile_of v q left (plane f), map (profile_of v q left) (sides f)).
Definition known (test : Z -> bool) (o : option Z) : bool := match o with Some z => test z | None => false end.
Definition off_side (pick : profile -> option Z) (p : profile * list profile) : bool :=
  known (fun z => negb (Z.eqb z 0)) (pick (fst p)) || existsb (fun s => known (fun z => Z.ltb z 0) (pick s)) (snd p).
Definition holds (pick : profile -> option Z) (p : profile * list profile) : bool :=
  known (Z.eqb 0) (pick (fst p)) && forallb (fun s => known (Z.leb 0) (pick s)) (snd p).

Definition side_ok (pick : profile -> option Z) (s : option state) (ps : list (profile * list profile)) : bool :=
  match s with
  | None => true
  | Some B => existsb (holds pick) ps
  | Some _ => forallb (off_side pick) ps
  end.
(* The states beside the root force it onto the boundary. *)
Definition forced (l r : option state) : bool :=
  match l, r with
  | Some x, Some y => state_eqb x B || state_eqb y B || negb (state_eqb x y)
  | _, _ => false
  end.
Definition meet_ok (v : view) (F : list facet) (q : list Z) (left : Z) (l r : option state) : bool :=
  let ps := map (profiles v q left) (filter (fun f => negb (cleared v f)) F) in
  side_ok before l ps && side_ok after r ps && (forced l r || existsb (holds at_root) ps).

(* The trajectory's point at num/den, d + 1 integers. *)
Fixpoint value_at (p : list Z) (n : nat) (num de : Z) : Z :=
  match p with [] => 0%Z | c :: q => (c * de ^ Z.of_nat n + num * value_at q (pred n) num de)%Z end.
Definition state_ok (v : view) (F : list facet) (num : Z) (s : option state) : bool :=
  match s with
  | None | Some B => true
  | Some x =>
      match ray_sum F (map (fun p => value_at p (degree v) num (den v)) (curve v)) with
      | Some k => Z.eqb k (match x with I => 1 | _ => 0 end)
      | None => false
      end
  end.

(* The primitive polynomial whose root is num/de. *)
Definition root_form (num de : Z) : list Z := let g := Z.gcd num de in [(- (num / g))%Z; (de / g)%Z].

Definition held_all_along (v : view) (f : facet) : bool :=
  always_zero v (plane f) && forallb (never_negative v) (sides f).

Definition interval_ok (v : view) (F : list facet) (k : kind) (q : list Z) : bool :=
  match k with
  | stays B => existsb (held_all_along v) F
  | stays s => forallb (cleared v) F && state_ok v F (hi v) (Some s)
  | meets l r =>
      state_ok v F (lo v) l && state_ok v F (hi v) r &&
      match l, r with
      | None, None => false
      | None, _ => meet_ok v F (root_form (lo v) (den v)) (-1) l r
      | _, None => meet_ok v F (root_form (hi v) (den v)) (-1) l r
      | _, _ =>
          let n := pred (length q) in
          let left := one_change n (bern (lo v) (hi v) (den v) n q) in
          negb (Z.eqb left 0) && meet_ok v F q left l r
      end
  end.

(* The states at the beginning, in gaps and at instants in turn, at the end. *)
Definition letters (k : kind) : list state :=
  match k with
  | stays s => [s; s; s]
  | meets l r =>
      match l, r with
      | Some x, Some y => [x; x; B; y; y]
      | Some x, None => [x; x; B]
      | None, Some y => [B; y; y]
      | None, None => []
      end
  end.

(* A view's coefficients are those of its curve, whose weight is positive; short enough polynomials. *)
Definition view_ok (v : view) : bool :=
  Z.ltb 0 (den v) && Z.ltb (lo v) (hi v)
  && forallb (fun p => Nat.leb (length p) (S (degree v))) (curve v)
  && Z.eqb (strict (degree v) (hd [] (coefficients v))) 1.
Definition view_of (l h d : Z) (n : nat) (V : list (list Z)) : view :=
  {| lo := l; hi := h; den := d; degree := n; curve := V; coefficients := map (bern l h d n) V |}.
