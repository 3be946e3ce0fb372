(* Readings of the definitions that fail, and what depends on where a loop begins.
   SPDX-License-Identifier: GPL-3.0-or-later

   [odd_has_no_definition]  an odd count in cases 1, 2, 4 belongs to none of Definitions 5-8, 10, 11
   [wrong_parse_*]          "k >= 2" of Definition 10 taken for its second alternative alone: it
                            then overlaps Definitions 5 and 9 (claim C14)
   [loop_*]                 one closed motion, three base points, three classes (claim C15)
   [ends_*]                 a slide out of the start counted as a tangency, and a start counted by the
                            whole curve: on words (claim C16; literal.v has the scenes) *)
Require Import Bool Arith List Lia.
Require Import Graze.words Graze.counts Graze.definitions.
Import ListNotations.

Theorem odd_has_no_definition s0 s1 i t :
  (s0 = O /\ s1 = O) \/ (s0 = O /\ s1 = B) \/ (s0 = B /\ s1 = O) ->
  Nat.odd i = true ->
  ~ D5 s0 s1 i t /\ ~ D6 s0 s1 i t /\ ~ D7 s0 s1 i t /\ ~ D8 s0 s1 i t
  /\ ~ D10 s0 s1 i t /\ ~ D11 s0 s1 i t.
Proof.
  intros Hs Hi. apply Nat.odd_spec in Hi. destruct Hi as [m Hm].
  unfold D5, D6, D7, D8, D10, D11; repeat split; intros H; split_all; subst; try discriminate; lia.
Qed.

(* ------------------------------------------------------------------ Definition 10 parsed wrongly *)
Definition D10_wrong (s0 s1 : state) (i t : nat) : Prop :=
  (exists k, (s0 = O /\ (s1 = O \/ s1 = B) \/ s0 = B /\ s1 = O) /\ i = 2 * k /\ t = 0) \/
  (exists k, (s0 = O /\ s1 = I \/ s0 = I /\ s1 = O) /\ i + 1 = 2 * k /\ t = 0) \/
  (exists k j, k >= 2 /\ j >= 1 /\
     ((s0 = O /\ (s1 = O \/ s1 = B) \/ s0 = B /\ s1 = O) /\ i = 2 * k /\ t = j \/
      (s0 = O /\ s1 = I \/ s0 = I /\ s1 = O) /\ i + 1 = 2 * k /\ t = j)).

Definition wrongly_fold (w : word) : Prop := D10_wrong (first w) (last_of w) (i_of w) (t_of w).

Theorem wrong_parse_regular : let w := [O; B; I; B; O] in
  admissible w /\ apart w /\ wrongly_fold w /\ meets combined w regular.
Proof.
  cbv zeta. assert (admissible [O; B; I; B; O]) as Hw by (split; [discriminate|reflexivity]).
  assert (apart [O; B; I; B; O]) as Ha by (left; reflexivity).
  repeat split; try assumption; try discriminate.
  - left. exists 1. cbv. intuition.
  - apply rule_is_definitions; auto.
Qed.

Theorem wrong_parse_exterior :
  admissible [O] /\ apart [O] /\ wrongly_fold [O] /\ meets combined [O] exterior.
Proof.
  repeat split; try discriminate.
  - left; reflexivity.
  - left. exists 0. cbv. intuition.
  - simpl; intuition discriminate.
  - simpl; intuition discriminate.
Qed.

(* ------------------------------------------------------------------ closed motions *)
Theorem loop_from_inside :
  k_of [I; B; O; B; I] = 2 /\ t_of [I; B; O; B; I] = 0 /\
  class_of_word separate [I; B; O; B; I] = fold.
Proof. repeat split. Qed.

Theorem loop_from_outside :
  k_of [O; B; I; B; O] = 1 /\ t_of [O; B; I; B; O] = 0 /\
  class_of_word separate [O; B; I; B; O] = regular.
Proof. repeat split. Qed.

Theorem loop_from_boundary :
  k_of [B; O; B; I; B] = 1 /\ t_of [B; O; B; I; B] = 1 /\
  class_of_word separate [B; O; B; I; B] = fold_boundary.
Proof. repeat split. Qed.

(* ------------------------------------------------------------------ the ends read otherwise *)
(* The counts of a word whose contact at t0 is taken for what [start_crosses] says. *)
Definition i_with (start_crosses : bool) (w : word) : nat :=
  (if start_crosses then 1 else 0) + crossings (tl (contacts w)).
Definition t_with (start_crosses : bool) (w : word) : nat :=
  (if start_crosses then 0 else 1) + touches (tl (contacts w)).

Definition without_class (s0 s1 : state) (i t : nat) : Prop :=
  ~ D5 s0 s1 i t /\ ~ D6 s0 s1 i t /\ ~ D7 s0 s1 i t /\ ~ D8 s0 s1 i t.

(* The trajectory slides, then dives: the contact at t0 is no intersection of a small ball. *)
Theorem ends_slide : let w := [B; I; B; O] in
  i_of w = 2 /\ t_of w = 0 /\ i_with false w = 1 /\ t_with false w = 1 /\
  without_class (first w) (last_of w) (i_with false w) (t_with false w) /\ ~ D9 w.
Proof.
  cbv zeta. repeat split.
  5: intros [H _]; apply H; simpl; auto.
  all: intros H; unfold D5, D6, D7, D8 in H; cbn in H; split_all; subst; try discriminate; lia.
Qed.

(* It leaves its start outwards and comes back through it: the ball sees the way back. *)
Theorem ends_return : let w := [B; O; B; I; B; O] in
  i_of w = 2 /\ t_of w = 1 /\ i_with true w = 3 /\ t_with true w = 0 /\
  without_class (first w) (last_of w) (i_with true w) (t_with true w) /\ ~ D9 w.
Proof.
  cbv zeta. repeat split.
  5: intros [H _]; apply H; simpl; auto.
  all: intros H; unfold D5, D6, D7, D8 in H; cbn in H; split_all; subst; try discriminate; lia.
Qed.

(* The two passages through the start taken for one point: the class changes. *)
Theorem ends_merged : let w := [B; O; B; I; B; O] in
  class_of_word separate w = fold_boundary /\ D5 (first w) (last_of w) 2 0.
Proof. cbv zeta. split; [reflexivity|]. cbv. intuition. Qed.
