(* Scenes in the plane: why the germ stands next to the whole contact, and a seam.
   SPDX-License-Identifier: GPL-3.0-or-later

   [literal_start]   Definition 4 to the letter: a ball around the start of the trajectory, however
                     small, holds a point of it in iS
   [dive_word], [dive_literal], [dive_apart], [dive_without_class]
                     the trajectory slides along the boundary, then dives: read to the letter its start is
                     a tangency, and no definition holds (claim C16)
   [return_word], [return_literal], [return_apart], [return_without_class]
                     it leaves its start outwards and comes back through it: read to the letter its
                     start is an intersection, and no definition holds (claim C16)
   [seam_word], [seam_inner], [seam_on]   a point with answer on that is interior to the sweep (claim C19) *)
Require Import Reals Lra List Classical.
Require Fin.
Require Import Graze.words Graze.counts Graze.definitions Graze.readings Graze.times Graze.space
  Graze.sweep Graze.affine Graze.cramer Graze.box.
Import ListNotations.
Open Scope R_scope.

Definition literal_start {d} (S : set d) (c : R -> point d) (a b : R) : Prop :=
  forall r, r > 0 -> exists t, a <= t <= b /\ near (c a) r (c t) /\ interior S (c t).

(* ------------------------------------------------------------------ tactics *)
Ltac legs := repeat match goal with
  | |- context [leg ?s ?t] =>
      let H := fresh in let E := fresh in
      destruct (leg_cases s t) as [[H E]|[[H E]|[H E]]]; rewrite ?E in *; try (exfalso; lra); clear E
  end.
Ltac one_of := first [lra | left; one_of | right; one_of].
(* The state asked for says which lemma applies. *)
Ltac state_here := match goal with
  | |- state_at _ _ I => apply box_I
  | |- state_at _ _ B => apply box_B
  | |- state_at _ _ O => apply box_O
  end; simpl; try lra; legs; one_of.
Ltac instant_or_gap := unfold trace_of; intros; state_here.

Ltac path_continuous := intros i; revert i; apply all2; simpl;
  repeat first [apply leg_continuous | apply continuous_const | apply continuous_opp | apply continuous_plus
               | apply continuous_minus | apply continuous_mult].

(* ------------------------------------------------------------------ slide, then dive *)
Definition dive_path (t : R) : point 2 := vec2 (-8 * leg 1 t) (-1 * leg 0 t).
Lemma dive_continuous i : continuous_in (d := 2) 0 2 (fun t _ => dive_path t i).
Proof. unfold dive_path. revert i. path_continuous. Qed.
Definition dive : motion 2 0 2 := translation (ltac:(lra) : 0 <= 2) dive_path dive_continuous.
Definition dive_point : point 2 := vec2 0 1.

Theorem dive_word : is_word (trace_of dive (box 2 4) dive_point) 0 2 [B; I; B; O].
Proof.
  change [B; I; B; O] with (merged [B; B; B; I; B; O; O]).
  apply word_of_cuts; [apply trace_functional|].
  apply cut_gap with 1; [lra|instant_or_gap|instant_or_gap|].
  apply cut_gap with (3 / 2); [lra|instant_or_gap|instant_or_gap|].
  apply cut_gap with 2; [lra|instant_or_gap|instant_or_gap|].
  apply cut_end. instant_or_gap.
Qed.

Theorem dive_literal : ~ literal_start (box 2 4) (fun t => back dive t dive_point) 0 2.
Proof.
  intros H. destruct (H (1 / 2)) as (t & Ht & Hn & Hi); [lra|]. apply box_interior in Hi.
  pose proof (Hn i1) as Hn1. pose proof (Hi i0) as Hi0. simpl in Hn1, Hi0.
  apply Rabs_def2 in Hn1. revert Hn1 Hi0. legs; lra.
Qed.

Theorem dive_apart P : ~ (image dive 0 (box 2 4) P /\ image dive 2 (box 2 4) P).
Proof.
  rewrite !image_back by lra. intros [H K]. pose proof (H i0) as H0. pose proof (K i0) as K0.
  simpl in H0, K0. revert H0 K0. legs; lra.
Qed.

(* i = 1 and t = 1 in case 4. *)
Theorem dive_without_class : let w := [B; I; B; O] in
  without_class (first w) (last_of w) (i_with false w) (t_with false w) /\ ~ D9 w.
Proof. apply ends_slide. Qed.

(* ------------------------------------------------------------------ out, and back through the start *)
Definition return_path (t : R) : point 2 :=
  vec2 (leg 0 t - 6 * leg 2 t + 10 * leg 4 t) (-3 * leg 1 t + 3 * leg 3 t).
Lemma return_continuous i : continuous_in (d := 2) 0 5 (fun t _ => return_path t i).
Proof. unfold return_path. revert i. path_continuous. Qed.
Definition return_ : motion 2 0 5 := translation (ltac:(lra) : 0 <= 5) return_path return_continuous.
Definition return_point : point 2 := vec2 0 2.

Theorem return_word : is_word (trace_of return_ (box 2 4) return_point) 0 5 [B; O; B; I; B; O].
Proof.
  change [B; O; B; I; B; O] with (merged [B; O; B; I; B; O; O]).
  apply word_of_cuts; [apply trace_functional|].
  apply cut_gap with (41 / 10); [lra|instant_or_gap|instant_or_gap|].
  apply cut_gap with (9 / 2); [lra|instant_or_gap|instant_or_gap|].
  apply cut_gap with 5; [lra|instant_or_gap|instant_or_gap|].
  apply cut_end. instant_or_gap.
Qed.

Theorem return_literal : literal_start (box 2 4) (fun t => back return_ t return_point) 0 5.
Proof.
  intros r Hr. set (s := Rmin (r / 20) (1 / 10)).
  assert (0 < s) as Hs by (apply Rmin_pos; lra).
  pose proof (Rmin_l (r / 20) (1 / 10) : s <= _) as S1.
  pose proof (Rmin_r (r / 20) (1 / 10) : s <= _) as S2.
  exists (9 / 2 - s). split; [lra|]. split.
  - intros i. revert i. apply all2; simpl; apply Rabs_def1; legs; lra.
  - apply box_interior. intros i. revert i. apply all2; simpl; legs; lra.
Qed.

Theorem return_apart P : ~ (image return_ 0 (box 2 4) P /\ image return_ 5 (box 2 4) P).
Proof.
  rewrite !image_back by lra. intros [H K]. pose proof (H i0) as H0. pose proof (K i0) as K0.
  simpl in H0, K0. revert H0 K0. legs; lra.
Qed.

(* i = 3 and t = 0 in case 4. *)
Theorem return_without_class : let w := [B; O; B; I; B; O] in
  without_class (first w) (last_of w) (i_with true w) (t_with true w) /\ ~ D9 w.
Proof. apply ends_return. Qed.

(* ------------------------------------------------------------------ a seam *)
Definition seam_path (t : R) : point 2 :=
  vec2 (2 * leg 0 t - 2 * leg 1 t + 8 * leg 2 t - 4 * leg 3 t) (4 * leg 1 t - 4 * leg 3 t).
Lemma seam_continuous i : continuous_in (d := 2) 0 4 (fun t _ => seam_path t i).
Proof. unfold seam_path. revert i. path_continuous. Qed.
Definition seam_motion : motion 2 0 4 := translation (ltac:(lra) : 0 <= 4) seam_path seam_continuous.
Definition seam_point : point 2 := vec2 4 1.

Theorem seam_word : is_word (trace_of seam_motion (box 2 2) seam_point) 0 4 [O; B; O; B].
Proof.
  change [O; B; O; B] with (merged [O; O; B; O; B]).
  apply word_of_cuts; [apply trace_functional|].
  apply cut_gap with 1; [lra|instant_or_gap|instant_or_gap|].
  apply cut_gap with 4; [lra|instant_or_gap|instant_or_gap|].
  apply cut_end. instant_or_gap.
Qed.

Theorem seam_on : pmc_of (class_of_word separate [O; B; O; B]) = on
  /\ boundary (open_sweep seam_motion (box 2 2)) seam_point.
Proof.
  split; [reflexivity|].
  apply (on_is _ _ _ _ separate seam_word (box_regular 2 2 ltac:(lra))). reflexivity.
Qed.

Theorem seam_inner : interior (sweep seam_motion (box 2 2)) seam_point.
Proof.
  exists (1 / 2). split; [lra|]. intros P HP. pose proof (HP i0) as H0. pose proof (HP i1) as H1.
  simpl in H0, H1. apply Rabs_def2 in H0, H1. apply sweep_back.
  destruct (Rle_lt_dec (P i0) 4); [exists 1|exists 4]; (split; [lra|]); intros i; revert i;
    apply all2; simpl; legs; lra.
Qed.
