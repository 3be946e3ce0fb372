(* Facets given by integer forms, and what a legal solid is: the hypotheses V0 to V3.
   SPDX-License-Identifier: GPL-3.0-or-later

   [zvalue]     the value k + n.x of a form [k; n_1; ...; n_d] at a point
   [facet]      a plane form and side forms; [on] it: the plane's is 0, no side's is negative;
                [inner]: all sides' are positive; [bounds]: forms that are not negative on it
   [legal F A]  A is a set that the facets bound: regular closed (V0), relative interiors disjoint (V0),
                the boundary is the union of the facets (V1), bounded (V2), and at points of one facet
                alone A is where the plane's form is negative (V3)
   [state_off]  off all facets a point has state I or O *)
Require Import Reals Lra Lia List ZArith Bool Classical.
Require Fin.
Require Import Graze.words Graze.space Graze.affine Graze.polynomials Graze.bernstein.
Import ListNotations.
Open Scope R_scope.

(* ------------------------------------------------------------------ forms *)
Fixpoint dot {d : nat} : list Z -> point d -> R :=
  match d with
  | 0%nat => fun _ _ => 0
  | S d' => fun n x =>
      match n with [] => 0 | c :: n' => IZR c * x Fin.F1 + dot n' (fun i => x (Fin.FS i)) end
  end.
Definition zvalue {d} (f : list Z) (x : point d) : R := IZR (hd 0%Z f) + dot (tl f) x.

Record facet := { plane : list Z; sides : list (list Z); bounds : list (list Z) }.

Definition on {d} (f : facet) (x : point d) : Prop :=
  zvalue (plane f) x = 0 /\ forall g, In g (sides f) -> 0 <= zvalue g x.
Definition inner {d} (f : facet) (x : point d) : Prop :=
  zvalue (plane f) x = 0 /\ forall g, In g (sides f) -> 0 < zvalue g x.

Record legal {d} (F : list facet) (A : set d) : Prop := {
  legal_regular : regular_closed A;
  legal_apart : ForallOrdPairs (fun f g => forall x : point d, ~ (inner f x /\ inner g x)) F;
  legal_boundary : forall x, boundary A x <-> exists f, In f F /\ on f x;
  legal_bounded : bounded A;
  legal_sides : forall before f after x, F = before ++ f :: after -> inner f x ->
    (forall g, In g (before ++ after) -> ~ on g x) ->
    exists e, e > 0 /\ forall y, near x e y ->
      (zvalue (plane f) y < 0 -> interior A y) /\
      (0 < zvalue (plane f) y -> interior (complement A) y)
}.
Arguments legal_regular {d F A}. Arguments legal_apart {d F A}. Arguments legal_boundary {d F A}.
Arguments legal_bounded {d F A}. Arguments legal_sides {d F A}.

(* ------------------------------------------------------------------ facts *)
Lemma dot_plus {d} n (x y : point d) : dot n (fun i => x i + y i) = dot n x + dot n y.
Proof.
  revert n x y. induction d as [|d IH]; intros [|c n] x y; simpl; try ring.
  rewrite (IH n (fun i => x (Fin.FS i)) (fun i => y (Fin.FS i))). ring.
Qed.

Lemma zvalue_plus {d} f (x y : point d) : zvalue f (fun i => x i + y i) = zvalue f x + dot (tl f) y.
Proof. unfold zvalue. rewrite dot_plus. ring. Qed.

Lemma dot_bound {d} n : exists c, 0 <= c /\ forall (x y : point d) e, near x e y ->
  Rabs (dot n y - dot n x) <= c * e.
Proof.
  revert n. induction d as [|d IH]; intros [|c n].
  1-3: exists 0; split; [lra|]; intros; simpl; replace (0 - 0) with 0 by ring; rewrite Rabs_R0; lra.
  destruct (IH n) as (b & Hb & H). exists (Rabs (IZR c) + b). split; [pose proof (Rabs_pos (IZR c)); lra|].
  intros x y e Hxy. simpl.
  specialize (H (fun i => x (Fin.FS i)) (fun i => y (Fin.FS i)) e (fun i => Hxy (Fin.FS i))).
  pose proof (Hxy Fin.F1) as H1.
  replace (IZR c * y Fin.F1 + dot n (fun i => y (Fin.FS i)) - (IZR c * x Fin.F1 + dot n (fun i => x (Fin.FS i))))
    with (IZR c * (y Fin.F1 - x Fin.F1) + (dot n (fun i => y (Fin.FS i)) - dot n (fun i => x (Fin.FS i)))) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  pose proof (Rmult_le_compat_l (Rabs (IZR c)) _ _ (Rabs_pos _) (Rlt_le _ _ H1)). lra.
Qed.

Section Legal.
Context {d : nat} {F : list facet} {A : set d}.
Hypothesis HL : legal F A.

Lemma state_off x : (forall f, In f F -> ~ on f x) -> state_at A x I \/ state_at A x O.
Proof.
  intros H. destruct (state_total A x) as [[] Hs]; auto. exfalso.
  apply (state_B_closed A x (regular_closed_closed A (legal_regular HL))) in Hs.
  apply (legal_boundary HL) in Hs. destruct Hs as (f & Hf & Ho). exact (H f Hf Ho).
Qed.

Lemma state_on f x : In f F -> on f x -> state_at A x B.
Proof.
  intros Hf Ho. apply (state_B_closed A x (regular_closed_closed A (legal_regular HL))).
  apply (legal_boundary HL). eauto.
Qed.
End Legal.
