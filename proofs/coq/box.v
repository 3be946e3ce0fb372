(* A box is a solid to which the theorems apply: their hypotheses can be met.
   SPDX-License-Identifier: GPL-3.0-or-later

   [box]            the points with all coordinates between 0 and l
   [box_regular]    it is regular closed, [box_polyhedral] and given by the signs of 2d forms
   [box_I], [box_B], [box_O]   the state of a point in the plane against it
   [translation]    a continuous translation is a motion *)
Require Import Reals Lra List FunctionalExtensionality Classical.
Require Fin.
Require Import Graze.words Graze.times Graze.space Graze.sweep Graze.polynomials Graze.finite
  Graze.affine Graze.cramer.
Import ListNotations.
Open Scope R_scope.

Definition box (d : nat) (l : R) : set d := fun x => forall i, 0 <= x i <= l.
Definition inner (d : nat) (l : R) : set d := fun x => forall i, 0 < x i < l.

Lemma box_interior d l x : interior (box d l) x <-> inner d l x.
Proof.
  split.
  - intros (e & He & H) i.
    assert (near x e (fun j => x j - e / 2)) as H1.
    { intros j. replace (x j - e / 2 - x j) with (- (e / 2)) by ring. rewrite Rabs_left; lra. }
    assert (near x e (fun j => x j + e / 2)) as H2.
    { intros j. replace (x j + e / 2 - x j) with (e / 2) by ring. rewrite Rabs_right; lra. }
    pose proof (H _ H1 i). pose proof (H _ H2 i). simpl in *. lra.
  - intros H.
    destruct (common_margin (fun i e => forall y : R, Rabs (y - x i) < e -> 0 <= y <= l)) as (e & He & K).
    + intros i e f K Hfe y Hy. apply K. lra.
    + intros i. specialize (H i). exists (Rmin (x i) (l - x i)). split; [apply Rmin_pos; lra|].
      intros y Hy. pose proof (Rmin_l (x i) (l - x i)). pose proof (Rmin_r (x i) (l - x i)).
      apply Rabs_def2 in Hy. lra.
    + exists e. split; [assumption|]. intros y Hy i. apply (K i). apply Hy.
Qed.

Theorem box_regular d l : 0 < l -> regular_closed (box d l).
Proof.
  intros Hl x. split.
  - intros Hx e He. set (s := Rmin 1 (e / l)).
    assert (0 < e / l) as Hel by (apply Rdiv_lt_0_compat; assumption).
    assert (0 < s) as Hs by (apply Rmin_pos; lra).
    pose proof (Rmin_l 1 (e / l) : s <= 1) as S1. pose proof (Rmin_r 1 (e / l) : s <= e / l) as S2.
    assert (s * l <= e) as Hsl.
    { apply Rle_trans with (e / l * l); [apply Rmult_le_compat_r; lra|]. right. field. lra. }
    assert (0 < s * l) as Hsl0 by (apply Rmult_lt_0_compat; assumption).
    exists (fun i => x i + s * (l / 2 - x i)). split.
    + intros i. specialize (Hx i). replace (x i + s * (l / 2 - x i) - x i) with (s * (l / 2 - x i)) by ring.
      rewrite Rabs_mult, (Rabs_right s) by lra.
      apply Rle_lt_trans with (s * (l / 2)); [|lra].
      apply Rmult_le_compat_l; [lra|]. apply Rabs_le. lra.
    + apply box_interior. intros i. specialize (Hx i).
      assert (0 <= (1 - s) * x i) by (apply Rmult_le_pos; lra).
      assert (0 <= (1 - s) * (l - x i)) by (apply Rmult_le_pos; lra). split; lra.
  - intros H i. split; apply Rnot_lt_le; intros N.
    + destruct (H (- x i)) as (y & Hy & Hi); [lra|]. apply box_interior in Hi.
      specialize (Hi i). specialize (Hy i). apply Rabs_def2 in Hy. lra.
    + destruct (H (x i - l)) as (y & Hy & Hi); [lra|]. apply box_interior in Hi.
      specialize (Hi i). specialize (Hy i). apply Rabs_def2 in Hy. lra.
Qed.

Fixpoint coordinates (d : nat) : list (Fin.t d) :=
  match d with 0%nat => [] | S n => Fin.F1 :: map Fin.FS (coordinates n) end.

Lemma all_coordinates {d} (i : Fin.t d) : In i (coordinates d).
Proof.
  induction i as [n|n i IH]; simpl; [auto|]. right. apply in_map, IH.
Qed.

Definition box_forms (d : nat) (l : R) : list (form d) :=
  map (fun i => {| normal := unit_matrix i; offset := 0 |}) (coordinates d) ++
  map (fun i => {| normal := unit_matrix i; offset := l |}) (coordinates d).

Lemma box_value {d} (i : Fin.t d) c x : value {| normal := unit_matrix i; offset := c |} x = x i - c.
Proof. unfold value; simpl. rewrite sum_unit. reflexivity. Qed.

Theorem box_polyhedral d l : polyhedral (box d l) (box_forms d l).
Proof.
  assert (forall x y, agree (box_forms d l) x y -> box d l x -> box d l y) as H.
  { intros x y Ha Hx i. specialize (Hx i).
    pose proof (Ha {| normal := unit_matrix i; offset := 0 |}) as H0.
    pose proof (Ha {| normal := unit_matrix i; offset := l |}) as H1.
    rewrite !box_value in H0, H1.
    specialize (H0 ltac:(apply in_or_app; left; apply in_map_iff; exists i; split; [reflexivity|apply all_coordinates])).
    specialize (H1 ltac:(apply in_or_app; right; apply in_map_iff; exists i; split; [reflexivity|apply all_coordinates])).
    split; apply Rnot_lt_le; intros N.
    - assert (sign (y i - 0) = Lt) as E by (apply sign_Lt; lra). rewrite <- H0 in E. apply sign_Lt in E. lra.
    - assert (sign (y i - l) = Gt) as E by (apply sign_Gt; lra). rewrite <- H1 in E. apply sign_Gt in E. lra. }
  intros x y Ha. split; apply H; [assumption|apply agree_sym, Ha].
Qed.

(* ------------------------------------------------------------------ in the plane *)
Lemma box_I l (x : point 2) : 0 < x i0 < l -> 0 < x i1 < l -> state_at (box 2 l) x I.
Proof. intros H0 H1. apply box_interior. intros i. revert i. apply all2; assumption. Qed.

Lemma box_O l (x : point 2) : 0 < l -> x i0 < 0 \/ x i0 > l \/ x i1 < 0 \/ x i1 > l ->
  state_at (box 2 l) x O.
Proof.
  intros Hl H. apply (state_O_closed _ _ (regular_closed_closed _ (box_regular 2 l Hl))).
  intros K. pose proof (K i0). pose proof (K i1). lra.
Qed.

Lemma box_B l (x : point 2) : 0 < l -> 0 <= x i0 <= l -> 0 <= x i1 <= l ->
  x i0 = 0 \/ x i0 = l \/ x i1 = 0 \/ x i1 = l -> state_at (box 2 l) x B.
Proof.
  intros Hl H0 H1 H. split.
  - intros K. apply box_interior in K. pose proof (K i0). pose proof (K i1). lra.
  - intros K. apply interior_in in K. apply K. intros i. revert i. apply all2; assumption.
Qed.

(* ------------------------------------------------------------------ translations *)
Definition translation {d a b} (Hab : a <= b) (v : R -> point d)
  (Hv : forall i, continuous_in (d := d) a b (fun t _ => v t i)) : motion d a b.
Proof.
  refine {| move := fun t x i => x i + v t i; back := fun t x i => x i - v t i; ordered := Hab |}.
  - intros t x _. apply functional_extensionality. intros i. ring.
  - intros t x _. apply functional_extensionality. intros i. ring.
  - apply jointly_continuous_by_coordinates. intros i.
    apply continuous_plus; [apply continuous_coordinate|apply Hv].
  - apply jointly_continuous_by_coordinates. intros i.
    apply continuous_minus; [apply continuous_coordinate|apply Hv].
Defined.

Lemma translation_is {d a b} (Hab : a <= b) (v : R -> point d) Hv t x i :
  move (translation Hab v Hv) t x i = x i + v t i.
Proof. reflexivity. Qed.

(* 0 before s, 1 after s + 1, linear between: a leg of a path that takes one unit of time. *)
Definition leg (s t : R) : R := Rmin 1 (Rmax 0 (t - s)).

Lemma leg_cases s t : t <= s /\ leg s t = 0 \/ (s <= t <= s + 1 /\ leg s t = t - s)
  \/ s + 1 <= t /\ leg s t = 1.
Proof. unfold leg, Rmin, Rmax. destruct (Rle_dec 0 (t - s)); destruct Rle_dec; lra. Qed.

Lemma leg_continuous {d} a b s : continuous_in (d := d) a b (fun t _ => leg s t).
Proof.
  intros t x _ e He. exists e. split; [assumption|]. intros u y _ Hut _.
  apply Rabs_def2 in Hut. apply Rabs_def1; destruct (leg_cases s t) as [[H ->]|[[H ->]|[H ->]]];
    destruct (leg_cases s u) as [[K ->]|[[K ->]|[K ->]]]; lra.
Qed.
