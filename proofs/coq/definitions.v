(* Definitions 5 to 11 of Erdim and Ilies as printed, the rule with k, and that they agree.
   SPDX-License-Identifier: GPL-3.0-or-later

   [position_case]  Table 1
   [D5] ... [D11]   the definitions, case by case, as printed; [D9] is about the word
   [class_of]       the rule: a class from k and t
   [rule_is_definitions]   in cases 1-4, 7 the rule's class is c iff the definition of c holds,
                           separate (5-9) and combined (5, 10, 11, 8, 9) (claims C12, C14)
   [one_definition]        exactly one definition holds in cases 1-4, 7 (claim C13)
   [no_definition_applies] none holds in cases 5, 6, 8, 9; [extended_i] what i is there (claim C15)
   [pmc_in], [pmc_on], [pmc_out]  in iff an I occurs, on iff a B and no I, out iff the word is O
   [D10_is], [D11_is], [replaced]  Definitions 10 and 11 against 6 and 7 (claim C14)
   [class_rev], [case_rev]         time reversed (claim C17) *)
Require Import Bool Arith List Lia.
Require Import Graze.words Graze.counts.
Import ListNotations.

(* ------------------------------------------------------------------ positions *)
(* Columns of Table 1 by P against S^0 (the state at t0), rows by P against S^1 (at t1). *)
Definition position_case (s0 s1 : state) : nat :=
  match s0, s1 with
  | O, O => 1 | O, B => 2 | O, I => 3
  | B, O => 4 | B, B => 5 | B, I => 6
  | I, O => 7 | I, B => 8 | I, I => 9
  end.
Definition case_of (w : word) : nat := position_case (first w) (last_of w).

(* P does not lie in both S^0 and S^1: cases 1-4 and 7. *)
Definition apart (w : word) : Prop := first w = O \/ last_of w = O.

(* ------------------------------------------------------------------ the definitions as printed *)
(* P against S^0, P against S^1, i_p, t_p. "i_p = 2k - 1" is written i + 1 = 2k. *)
Definition D5 (s0 s1 : state) (i t : nat) : Prop :=
  (s0 = O /\ s1 = O /\ i = 2 /\ t = 0) \/ (* case 1 *)
  (s0 = O /\ s1 = B /\ i = 2 /\ t = 0) \/ (* case 2 *)
  (s0 = O /\ s1 = I /\ i = 1 /\ t = 0) \/ (* case 3 *)
  (s0 = B /\ s1 = O /\ i = 2 /\ t = 0) \/ (* case 4 *)
  (s0 = I /\ s1 = O /\ i = 1 /\ t = 0).   (* case 7 *)

Definition D6 (s0 s1 : state) (i t : nat) : Prop := exists k, k >= 2 /\ (
  (s0 = O /\ s1 = O /\ i = 2 * k /\ t = 0) \/
  (s0 = O /\ s1 = B /\ i = 2 * k /\ t = 0) \/
  (s0 = O /\ s1 = I /\ i + 1 = 2 * k /\ t = 0) \/
  (s0 = B /\ s1 = O /\ i = 2 * k /\ t = 0) \/
  (s0 = I /\ s1 = O /\ i + 1 = 2 * k /\ t = 0)).

Definition D7 (s0 s1 : state) (i t : nat) : Prop := exists k j, k >= 1 /\ j >= 1 /\ (
  (s0 = O /\ s1 = O /\ i = 2 * k /\ t = j) \/
  (s0 = O /\ s1 = B /\ i = 2 * k /\ t = j) \/
  (s0 = O /\ s1 = I /\ i + 1 = 2 * k /\ t = j) \/
  (s0 = B /\ s1 = O /\ i = 2 * k /\ t = j) \/
  (s0 = I /\ s1 = O /\ i + 1 = 2 * k /\ t = j)).

Definition D8 (s0 s1 : state) (i t : nat) : Prop := exists j, j >= 1 /\ (
  (s0 = O /\ s1 = O /\ i = 0 /\ t = j) \/
  (s0 = O /\ s1 = B /\ i = 0 /\ t = j) \/
  (s0 = B /\ s1 = O /\ i = 0 /\ t = j)).

(* The trajectory does not meet S. *)
Definition D9 (w : word) : Prop := ~ In I w /\ ~ In B w.

Definition D10 (s0 s1 : state) (i t : nat) : Prop := exists k j, k >= 2 /\ j >= 1 /\ (
  (s0 = O /\ s1 = O /\ (i = 2 * k /\ t = 0 \/ i = 2 * k /\ t = j)) \/
  (s0 = O /\ s1 = B /\ (i = 2 * k /\ t = 0 \/ i = 2 * k /\ t = j)) \/
  (s0 = O /\ s1 = I /\ (i + 1 = 2 * k /\ t = 0 \/ i + 1 = 2 * k /\ t = j)) \/
  (s0 = B /\ s1 = O /\ (i = 2 * k /\ t = 0 \/ i = 2 * k /\ t = j)) \/
  (s0 = I /\ s1 = O /\ (i + 1 = 2 * k /\ t = 0 \/ i + 1 = 2 * k /\ t = j))).

Definition D11 (s0 s1 : state) (i t : nat) : Prop := exists k j, k = 1 /\ j >= 1 /\ (
  (s0 = O /\ s1 = O /\ i = 2 * k /\ t = j) \/
  (s0 = O /\ s1 = B /\ i = 2 * k /\ t = j) \/
  (s0 = O /\ s1 = I /\ i + 1 = 2 * k /\ t = j) \/
  (s0 = B /\ s1 = O /\ i = 2 * k /\ t = j) \/
  (s0 = I /\ s1 = O /\ i + 1 = 2 * k /\ t = j)).

Inductive class := regular | fold | fold_boundary | boundary | exterior.
Inductive folds := separate | combined. (* Definitions 6 and 7, or 10 and 11 in their place *)

Definition meets (f : folds) (w : word) (c : class) : Prop :=
  let D (d : state -> state -> nat -> nat -> Prop) := d (first w) (last_of w) (i_of w) (t_of w) in
  match c, f with
  | regular, _ => D D5
  | fold, separate => D D6
  | fold, combined => D D10
  | fold_boundary, separate => D D7
  | fold_boundary, combined => D D11
  | boundary, _ => D D8
  | exterior, _ => D9 w
  end.

(* ------------------------------------------------------------------ the rule *)
Definition class_of (f : folds) (k t : nat) : class :=
  match k, t, f with
  | 0, 0, _ => exterior
  | 0, S _, _ => boundary
  | 1, 0, _ => regular
  | 1, S _, _ => fold_boundary
  | S (S _), 0, _ => fold
  | S (S _), S _, separate => fold_boundary
  | S (S _), S _, combined => fold
  end.
Definition class_of_word (f : folds) (w : word) : class := class_of f (k_of w) (t_of w).

Inductive membership := in_ | on | out.
Definition pmc_of (c : class) : membership :=
  match c with exterior => out | boundary => on | _ => in_ end.

(* The number of the definition a row cites; 0 where no definition applies. *)
Definition definition_of (f : folds) (w : word) : nat :=
  match first w, last_of w with
  | O, _ | _, O =>
      match class_of_word f w, f with
      | regular, _ => 5
      | fold, separate => 6
      | fold_boundary, separate => 7
      | fold, combined => 10
      | fold_boundary, combined => 11
      | boundary, _ => 8
      | exterior, _ => 9
      end
  | _, _ => 0
  end.

(* ------------------------------------------------------------------ they agree *)
Lemma D9_word w : admissible w -> (D9 w <-> w = [O]).
Proof.
  intros [Hne Hl]. unfold D9. split; [|intros ->; simpl; intuition discriminate].
  intros [HI HB]. destruct w as [|x [|y w]]; [congruence| |].
  - destruct x; simpl in *; tauto.
  - destruct x, y; simpl in *; try discriminate; tauto.
Qed.

Lemma class_of_spec f k t c : class_of f k t = c <->
  match c, f with
  | regular, _ => k = 1 /\ t = 0
  | fold, separate => k >= 2 /\ t = 0
  | fold, combined => k >= 2
  | fold_boundary, separate => k >= 1 /\ t >= 1
  | fold_boundary, combined => k = 1 /\ t >= 1
  | boundary, _ => k = 0 /\ t >= 1
  | exterior, _ => k = 0 /\ t = 0
  end.
Proof.
  destruct k as [|[|k]], t as [|t], f, c; simpl; split; intros; try discriminate; try lia;
    reflexivity.
Qed.

(* A disjunction with one branch that fits the case at hand. *)
Ltac pick := first [ lia | split; [reflexivity|]; split; [reflexivity|]; lia
                   | left; pick | right; pick ].
Ltac split_all := repeat match goal with
  | H : exists _, _ |- _ => destruct H
  | H : _ /\ _ |- _ => destruct H
  | H : _ \/ _ |- _ => destruct H
  end.

Theorem rule_is_definitions f w c : admissible w -> apart w ->
  (class_of_word f w = c <-> meets f w c).
Proof.
  intros Hw Ha. unfold class_of_word. rewrite class_of_spec.
  destruct c; cbn [meets].
  5: { rewrite (D9_word w Hw), <- (exterior_word w Hw). destruct f; tauto. }
  all: pose proof (parity w Hw) as Hp; revert Hp;
    generalize (k_of w), (i_of w), (t_of w); intros k i t Hp;
    unfold apart in Ha; destruct (first w), (last_of w);
    try (exfalso; destruct Ha; congruence);
    ends; destruct f; unfold D5, D6, D7, D8, D10, D11; split; intros H;
    split_all; try discriminate; try lia.
  all: try pick.
  all: try (exists k; split; [lia|pick]).
  all: try (exists k, t; split; [lia|split; [lia|pick]]).
  all: try (exists t; split; [lia|pick]).
  all: destruct t as [|t]; [exists k, 1|exists k, (S t)]; split; [lia|split; [lia|pick] | lia|split; [lia|pick]].
Qed.

(* Disjoint and complete. *)
Theorem one_definition f w : admissible w -> apart w -> exists! c, meets f w c.
Proof.
  intros Hw Ha. exists (class_of_word f w). split.
  - apply rule_is_definitions; auto.
  - intros c Hc. apply rule_is_definitions; auto.
Qed.

(* ------------------------------------------------------------------ cases 5, 6, 8, 9 *)
Theorem apart_cases w : apart w <-> In (case_of w) [1; 2; 3; 4; 7].
Proof.
  unfold apart, case_of. destruct (first w), (last_of w); simpl; intuition discriminate.
Qed.

Theorem no_definition_applies f w c : ~ apart w -> ~ meets f w c.
Proof.
  intros Ha Hm. apply Ha. unfold apart.
  destruct c; cbn [meets] in Hm.
  5: { destruct Hm as [HI HB]. left. unfold first.
       destruct w as [|[]]; simpl in *; try tauto; exfalso; tauto. }
  all: destruct f; unfold D5, D6, D7, D8, D10, D11 in Hm; split_all; subst; auto.
Qed.

Theorem extended_i w : admissible w ->
  match case_of w with
  | 1 | 2 | 4 | 5 => i_of w = 2 * k_of w
  | 9 => i_of w + 2 = 2 * k_of w
  | _ => i_of w + 1 = 2 * k_of w
  end.
Proof.
  intros Hw. pose proof (parity w Hw) as Hp. unfold case_of.
  destruct (first w), (last_of w); simpl; ends; lia.
Qed.

(* ------------------------------------------------------------------ membership *)
Theorem pmc_in f w : admissible w -> (pmc_of (class_of_word f w) = in_ <-> In I w).
Proof.
  intros Hw. rewrite <- (k_inside w Hw). unfold class_of_word.
  destruct (k_of w) as [|[|k]], (t_of w), f; simpl; split; intros; try discriminate; try lia;
    reflexivity.
Qed.

Theorem pmc_out f w : admissible w -> (pmc_of (class_of_word f w) = out <-> D9 w).
Proof.
  intros Hw. rewrite (D9_word w Hw), <- (exterior_word w Hw). unfold class_of_word.
  destruct (k_of w) as [|[|k]], (t_of w), f; simpl; split; intros; split_all; try discriminate;
    try lia; auto.
Qed.

Theorem pmc_on f w : admissible w ->
  (pmc_of (class_of_word f w) = on <-> ~ In I w /\ In B w).
Proof.
  intros Hw. pose proof (pmc_in f w Hw) as Hi. pose proof (pmc_out f w Hw) as Ho. unfold D9 in Ho.
  destruct (in_dec state_eq_dec B w); destruct (pmc_of (class_of_word f w));
    split; intros H; try discriminate; try tauto; split; try tauto.
  all: try (intros HI; apply Hi in HI; discriminate).
  exfalso. assert (on = out) by (apply Ho; split; [intros HI; apply Hi in HI; discriminate|assumption]).
  discriminate.
Qed.

(* ------------------------------------------------------------------ Definitions 10 and 11 *)
Theorem D10_is s0 s1 i t :
  D10 s0 s1 i t <-> D6 s0 s1 i t \/ (D7 s0 s1 i t /\ i >= 3).
Proof.
  unfold D10, D6, D7; split.
  - intros (k & j & Hk & Hj & H). destruct t as [|t].
    + left. exists k. split; [assumption|]. split_all; subst; try lia; pick.
    + right. split; [|split_all; lia]. exists k, (S t). split; [lia|]. split; [lia|].
      split_all; subst; try lia; pick.
  - intros [(k & Hk & H)|((k & j & Hk & Hj & H) & Hi)].
    + exists k, 1. split; [assumption|]. split; [lia|]. split_all; subst; pick.
    + exists k, j. split; [split_all; lia|]. split; [assumption|]. split_all; subst; pick.
Qed.

Theorem D11_is s0 s1 i t : D11 s0 s1 i t <-> D7 s0 s1 i t /\ i <= 2.
Proof.
  unfold D11, D7; split.
  - intros (k & j & Hk & Hj & H). split; [exists k, j; intuition lia|split_all; lia].
  - intros ((k & j & Hk & Hj & H) & Hi). exists k, j. split; [split_all; lia|tauto].
Qed.

(* 10 and 11 replace 6 and 7: beside them they would give a point two classes. *)
Theorem replaced : exists w, admissible w /\ apart w /\
  meets separate w fold_boundary /\ meets combined w fold.
Proof.
  exists [O; B; I; B; O; B; I; B; O; B; O]. repeat split; try discriminate.
  - left; reflexivity.
  - apply rule_is_definitions; [split; [discriminate|reflexivity]|left; reflexivity|reflexivity].
  - apply rule_is_definitions; [split; [discriminate|reflexivity]|left; reflexivity|reflexivity].
Qed.

(* ------------------------------------------------------------------ time reversed *)
Theorem class_rev f w : class_of_word f (rev w) = class_of_word f w.
Proof. unfold class_of_word. rewrite k_rev, touches_rev. reflexivity. Qed.

Theorem case_rev w : case_of (rev w) =
  match case_of w with 2 => 4 | 4 => 2 | 3 => 7 | 7 => 3 | 6 => 8 | 8 => 6 | c => c end.
Proof.
  unfold case_of. rewrite first_rev, last_is_first_rev.
  destruct (first w), (last_of w); reflexivity.
Qed.
