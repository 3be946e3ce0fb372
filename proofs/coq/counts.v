(* Parity, and what k, i and t count in a word.
   SPDX-License-Identifier: GPL-3.0-or-later

   [parity]      i + [first = I] + [last = I] = 2 k, for every admissible word (claim C10)
   [k_runs]      k is the number of runs of I among the letters other than B (claim C10)
   [k_parts]     k is the number of parts of the word without O that hold an I (claim C11)
   [visits_k]    the letters I are k and the tangencies from inside (claim C11)
   [parts_k]     the parts without O are k and the other tangencies (claim C11)
   [k_inside]    k >= 1 iff the word holds an I; [exterior_word] k = t = 0 iff the word is O *)
Require Import Bool Arith List Lia.
Require Import Graze.words.
Import ListNotations.

(* The maximal runs of I in w without its B's; [before] says whether such a run comes before w. *)
Fixpoint runs (before : bool) (w : word) : nat :=
  match w with
  | [] => 0
  | I :: rest => (if before then 0 else 1) + runs true rest
  | O :: rest => runs false rest
  | B :: rest => runs before rest
  end.

(* The maximal parts of a word without O: the components of the preimage of S. *)
Fixpoint parts_from (open : word) (w : word) : list word :=
  match w with
  | [] => match open with [] => [] | _ => [rev open] end
  | O :: rest => match open with [] => [] | _ => [rev open] end ++ parts_from [] rest
  | x :: rest => parts_from (x :: open) rest
  end.
Definition parts (w : word) : list word := parts_from [] w.

Definition holds_I (w : word) : bool := existsb (state_eqb I) w.
Definition visits (w : word) : nat := length (filter (state_eqb I) w).
Definition from_inside (c : contact) : bool :=
  match c with (Some I, Some I) => true | _ => false end.
Definition t_in (w : word) : nat := length (filter from_inside (contacts w)).
Definition t_out (w : word) : nat := t_of w - t_in w.

(* ------------------------------------------------------------------ parity *)
Ltac ends := change (inside I) with 1 in *; change (inside O) with 0 in *;
  change (inside B) with 0 in *.

Lemma parity_after x r : x <> B -> linked (x :: r) = true ->
  crossings (contacts_between (Some x) r None) + inside x + inside (last_of (x :: r))
  = 2 * runs false (x :: r).
Proof.
  intros Hx Hl. revert x r Hx Hl. apply after_letter_ind.
  - intros [] H; try congruence; reflexivity.
  - intros [] H; try congruence; reflexivity.
  - intros x y r Hx Hy Hl IH. rewrite !last_cons.
    change (contacts_between (Some x) (B :: y :: r) None)
      with ((Some x, Some y) :: contacts_between (Some B) (y :: r) None).
    rewrite crossings_cons. revert IH.
    destruct x, y; try congruence; simpl; ends; intros; lia.
Qed.

Lemma doubled_runs w : admissible w ->
  i_of w + inside (first w) + inside (last_of w) = 2 * runs false w.
Proof.
  revert w. apply admissible_cases.
  - reflexivity.
  - intros x r Hx Hl. pose proof (parity_after x r Hx Hl) as H.
    unfold i_of, contacts, first; simpl hd. destruct x; try congruence; exact H.
  - intros x r Hx Hl. pose proof (parity_after x r Hx Hl) as H.
    unfold i_of, contacts, first; simpl hd. rewrite last_cons.
    change (contacts_between None (B :: x :: r) None)
      with ((None, Some x) :: contacts_between (Some B) (x :: r) None).
    rewrite crossings_cons. revert H. destruct x; try congruence; simpl; ends; intros; lia.
Qed.

Theorem k_runs w : admissible w -> k_of w = runs false w.
Proof. intros H. unfold k_of. rewrite (doubled_runs w H), Nat.mul_comm. apply Nat.div_mul. lia. Qed.

Theorem parity w : admissible w ->
  i_of w + inside (first w) + inside (last_of w) = 2 * k_of w.
Proof. intros H. rewrite (k_runs w H). apply doubled_runs, H. Qed.

(* ------------------------------------------------------------------ parts *)
Lemma holds_I_rev w : holds_I (rev w) = holds_I w.
Proof.
  unfold holds_I. induction w as [|x w IH]; [reflexivity|].
  simpl. rewrite existsb_app, IH; simpl. rewrite orb_false_r, orb_comm. reflexivity.
Qed.

Lemma parts_runs w : forall open,
  length (filter holds_I (parts_from open w))
  = (if holds_I open then 1 else 0) + runs (holds_I open) w.
Proof.
  induction w as [|x w IH]; intros open.
  - destruct open as [|y open]; [reflexivity|]. simpl parts_from. simpl filter.
    rewrite (holds_I_rev (y :: open) : holds_I (rev open ++ [y]) = _).
    destruct (holds_I (y :: open)); reflexivity.
  - destruct x; simpl parts_from; simpl runs; try rewrite IH.
    + simpl. destruct (holds_I open); simpl; lia.
    + simpl. reflexivity.
    + rewrite filter_app, app_length, IH. simpl.
      destruct open as [|y open]; [reflexivity|]. simpl filter.
      rewrite (holds_I_rev (y :: open) : holds_I (rev open ++ [y]) = _).
      destruct (holds_I (y :: open)); reflexivity.
Qed.

Theorem k_parts w : admissible w -> k_of w = length (filter holds_I (parts w)).
Proof. intros H. rewrite (k_runs w H). unfold parts. rewrite parts_runs. reflexivity. Qed.

(* ------------------------------------------------------------------ visits *)
Lemma visits_after x r : x <> B -> linked (x :: r) = true ->
  visits (x :: r)
  = runs false (x :: r) + length (filter from_inside (contacts_between (Some x) r None)).
Proof.
  intros Hx Hl. revert x r Hx Hl. apply after_letter_ind.
  - intros [] H; try congruence; reflexivity.
  - intros [] H; try congruence; reflexivity.
  - intros x y r Hx Hy Hl IH. revert IH.
    unfold visits. destruct x, y; try congruence; simpl; intros; lia.
Qed.

Theorem visits_k w : admissible w -> visits w = k_of w + t_in w.
Proof.
  intros H. rewrite (k_runs w H). revert w H. apply admissible_cases.
  - reflexivity.
  - intros x r Hx Hl. rewrite (visits_after x r Hx Hl).
    unfold t_in, contacts. destruct x; try congruence; reflexivity.
  - intros x r Hx Hl. pose proof (visits_after x r Hx Hl) as H. revert H.
    unfold t_in, contacts, visits. destruct x; try congruence; simpl; intros; lia.
Qed.

(* ------------------------------------------------------------------ components *)
Lemma inside_touches w : t_in w <= t_of w.
Proof.
  unfold t_in, t_of, touches. induction (contacts w) as [|c l IH]; [simpl; lia|].
  destruct c as [[[]|] [[]|]]; simpl; lia.
Qed.

Lemma parts_from_open w : forall x y u v,
  length (parts_from (x :: u) w) = length (parts_from (y :: v) w).
Proof.
  induction w as [|z w IH]; intros x y u v; [reflexivity|].
  destruct z; simpl; auto.
Qed.

Lemma parts_after x r : x <> B -> linked (x :: r) = true ->
  let c := contacts_between (Some x) r None in
  length (parts (x :: r)) + length (filter from_inside c) = runs false (x :: r) + touches c.
Proof.
  intros Hx Hl. revert x r Hx Hl. apply after_letter_ind; cbv zeta.
  - intros [] H; try congruence; reflexivity.
  - intros [] H; try congruence; reflexivity.
  - intros x y r Hx Hy Hl IH.
    change (contacts_between (Some x) (B :: y :: r) None)
      with ((Some x, Some y) :: contacts_between (Some B) (y :: r) None).
    rewrite touches_cons. revert IH. unfold parts.
    destruct x, y; try congruence; simpl.
    + rewrite (parts_from_open r I I [B; I] []). lia.
    + lia.
    + rewrite (parts_from_open r I I [B] []). lia.
    + lia.
Qed.

Theorem parts_k w : admissible w -> length (parts w) = k_of w + t_out w.
Proof.
  intros H. unfold t_out. pose proof (inside_touches w) as Hle.
  enough (length (parts w) + t_in w = k_of w + t_of w) by lia.
  rewrite (k_runs w H). clear Hle. revert w H. apply admissible_cases.
  - reflexivity.
  - intros x r Hx Hl. pose proof (parts_after x r Hx Hl) as H. cbv zeta in H.
    unfold t_in, t_of, contacts. destruct x; try congruence; exact H.
  - intros x r Hx Hl. pose proof (parts_after x r Hx Hl) as H. cbv zeta in H. revert H.
    unfold t_in, t_of, contacts.
    change (contacts_between None (B :: x :: r) None)
      with ((None, Some x) :: contacts_between (Some B) (x :: r) None).
    rewrite touches_cons. unfold parts. destruct x; try congruence; simpl; [|lia].
    rewrite (parts_from_open r I I [B] []). lia.
Qed.

(* ------------------------------------------------------------------ no k, and nothing at all *)
Lemma runs_false_none w : ~ In I w -> forall before, runs before w = 0.
Proof.
  induction w as [|x w IH]; intros H before; [reflexivity|].
  simpl in H. destruct x; simpl; [tauto|apply IH; tauto|apply IH; tauto].
Qed.

Lemma runs_false_some w : In I w -> runs false w >= 1.
Proof.
  induction w as [|x w IH]; intros [].
  - subst. simpl. lia.
  - destruct x; simpl; auto. lia.
Qed.

Theorem k_inside w : admissible w -> (k_of w >= 1 <-> In I w).
Proof.
  intros H. rewrite (k_runs w H). split; [|apply runs_false_some].
  intros Hk. destruct (in_dec state_eq_dec I w) as [|Hn]; [assumption|].
  rewrite (runs_false_none w Hn) in Hk. lia.
Qed.

Lemma contacts_none w : forall l r, contacts_between l w r = [] <-> ~ In B w.
Proof.
  induction w as [|x w IH]; intros l r; simpl.
  - tauto.
  - destruct x; simpl; try rewrite IH; try (split; [intros H [|]; [discriminate|tauto]|tauto]).
    split; [discriminate|]. tauto.
Qed.

Theorem exterior_word w : admissible w -> (k_of w = 0 /\ t_of w = 0 <-> w = [O]).
Proof.
  intros H. split; [|intros ->; split; reflexivity]. intros [Hk Ht].
  assert (i_of w = 0) as Hi by (pose proof (parity w H); lia).
  pose proof (counts_sum w) as Hc. rewrite Hi, Ht in Hc. symmetry in Hc.
  apply length_zero_iff_nil in Hc. apply contacts_none in Hc.
  assert (~ In I w) as Hn by (rewrite <- (k_inside w H); lia).
  destruct H as [Hne Hl]. destruct w as [|x [|y w]]; [congruence| |].
  - destruct x; simpl in *; tauto.
  - destruct x, y; simpl in *; try discriminate; tauto.
Qed.
