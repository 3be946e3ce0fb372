(* States, words, contacts and counts: what a trace is, and how its contacts are counted.
   SPDX-License-Identifier: GPL-3.0-or-later

   [state]       where the trajectory is: in iS, on the boundary of S, in the complement
   [word]        the states met in order of time, equal neighbours merged
   [admissible]  a word that can occur: of two neighbours exactly one is B
   [contacts]    for each B the states beside it; None at an end of the motion
   [crossing]    whether a contact is an intersection: [EI] Definitions 3 and 4 at the ends
   [i_of], [t_of], [k_of]  intersections, tangencies, and k of the rule
   [crossings_rev], [k_rev]  time reversed keeps the counts (claim C17) *)
Require Import Bool Arith List Lia.
Import ListNotations.

Inductive state := I | B | O.
Definition word := list state.

Definition state_eqb (a b : state) : bool :=
  match a, b with I, I | B, B | O, O => true | _, _ => false end.

Definition neighbours (a b : state) : bool := xorb (state_eqb a B) (state_eqb b B).

Fixpoint linked (w : word) : bool :=
  match w with
  | a :: ((b :: _) as rest) => neighbours a b && linked rest
  | _ => true
  end.

Definition admissible (w : word) : Prop := w <> [] /\ linked w = true.

(* The states at t0 and at t1. *)
Definition first (w : word) : state := hd O w.
Definition last_of (w : word) : state := last w O.

(* A contact: the germs before and after it. [contacts_between l w r] are those of w when l stands
   before it and r after it. *)
Definition germ := option state.
Definition contact := (germ * germ)%type.

Definition head_or (w : word) (r : germ) : germ := match w with [] => r | x :: _ => Some x end.

Fixpoint contacts_between (l : germ) (w : word) (r : germ) : list contact :=
  match w with
  | [] => []
  | B :: rest => (l, head_or rest r) :: contacts_between (Some B) rest r
  | x :: rest => contacts_between (Some x) rest r
  end.
Definition contacts (w : word) : list contact := contacts_between None w None.

Definition crossing (c : contact) : bool :=
  match c with
  | (Some a, Some b) => negb (state_eqb a b) (* an inner contact *)
  | (None, Some b) => state_eqb b I          (* at t0: Definition 4 *)
  | (Some a, None) => state_eqb a I          (* at t1: Definition 3 *)
  | (None, None) => false                    (* the whole motion *)
  end.

Definition crossings (l : list contact) : nat := length (filter crossing l).
Definition touches (l : list contact) : nat := length (filter (fun c => negb (crossing c)) l).

Definition i_of (w : word) : nat := crossings (contacts w).
Definition t_of (w : word) : nat := touches (contacts w).

Definition inside (s : state) : nat := if state_eqb s I then 1 else 0.
Definition k_of (w : word) : nat := (i_of w + inside (first w) + inside (last_of w)) / 2.

(* ------------------------------------------------------------------ small facts *)
Lemma state_eqb_eq a b : state_eqb a b = true <-> a = b.
Proof. destruct a, b; simpl; split; congruence. Qed.

Lemma state_eq_dec (a b : state) : {a = b} + {a <> b}.
Proof. decide equality. Qed.

Lemma neighbours_sym a b : neighbours a b = neighbours b a.
Proof. destruct a, b; reflexivity. Qed.

Lemma crossings_cons c l : crossings (c :: l) = (if crossing c then 1 else 0) + crossings l.
Proof. unfold crossings; simpl; destruct (crossing c); reflexivity. Qed.

Lemma touches_cons c l : touches (c :: l) = (if crossing c then 0 else 1) + touches l.
Proof. unfold touches; simpl; destruct (crossing c); reflexivity. Qed.

Lemma counts_sum w : i_of w + t_of w = length (contacts w).
Proof.
  unfold i_of, t_of. induction (contacts w) as [|c l IH]; [reflexivity|].
  rewrite crossings_cons, touches_cons; simpl. destruct (crossing c); lia.
Qed.

Lemma last_cons x y w : last_of (x :: y :: w) = last_of (y :: w).
Proof. reflexivity. Qed.

Lemma linked_tail x w : linked (x :: w) = true -> linked w = true.
Proof. destruct w; simpl; [reflexivity|]. intros H; apply andb_prop in H; apply H. Qed.

(* Induction over what follows a letter that is not B: nothing, a last B, or a B and such a letter. *)
Lemma after_letter_ind (P : state -> word -> Prop) :
  (forall x, x <> B -> P x []) ->
  (forall x, x <> B -> P x [B]) ->
  (forall x y r, x <> B -> y <> B -> linked (y :: r) = true -> P y r -> P x (B :: y :: r)) ->
  forall x r, x <> B -> linked (x :: r) = true -> P x r.
Proof.
  intros H0 H1 H2.
  assert (forall n x r, length r <= n -> x <> B -> linked (x :: r) = true -> P x r) as H.
  { induction n as [|n IH]; intros x r Hn Hx Hl.
    - destruct r; [apply H0; assumption | simpl in Hn; lia].
    - destruct r as [|b [|y r]]; [apply H0; assumption| |].
      + destruct x, b; simpl in Hl; try discriminate; try congruence; apply H1; assumption.
      + assert (b = B) as -> by (destruct x, b; simpl in Hl; congruence).
        assert (y <> B) as Hy by (intros ->; destruct x; simpl in Hl; congruence).
        apply linked_tail, linked_tail in Hl.
        apply H2; try assumption. apply IH; try assumption. simpl in Hn; lia. }
  intros x r. apply (H (length r)). lia.
Qed.

(* Every admissible word is `B`, begins with a letter, or begins with a B and a letter. *)
Lemma admissible_cases (P : word -> Prop) :
  P [B] ->
  (forall x r, x <> B -> linked (x :: r) = true -> P (x :: r)) ->
  (forall x r, x <> B -> linked (x :: r) = true -> P (B :: x :: r)) ->
  forall w, admissible w -> P w.
Proof.
  intros H0 H1 H2 [|x r] [Hne Hl]; [congruence|].
  destruct (state_eq_dec x B) as [->|Hx]; [|auto].
  destruct r as [|y r]; [assumption|].
  assert (y <> B) by (intros ->; simpl in Hl; congruence).
  apply H2; [assumption|]. eapply linked_tail; eassumption.
Qed.

(* ------------------------------------------------------------------ time reversed *)
Definition swap (c : contact) : contact := (snd c, fst c).

Lemma crossing_swap c : crossing (swap c) = crossing c.
Proof. destruct c as [[[]|] [[]|]]; reflexivity. Qed.

Definition last_or (l : germ) (w : word) : germ := head_or (rev w) l.

Lemma contacts_app l u v r :
  contacts_between l (u ++ v) r
  = contacts_between l u (head_or v r) ++ contacts_between (last_or l u) v r.
Proof.
  revert l. induction u as [|x u IH]; intros l; [reflexivity|].
  assert (forall y, last_or y (x :: u) = last_or (Some x) u) as H.
  { intros y. unfold last_or; simpl. destruct (rev u); reflexivity. }
  rewrite H. destruct x; simpl; rewrite IH; try reflexivity.
  destruct u; reflexivity.
Qed.

Lemma contacts_rev w : forall l r,
  contacts_between l (rev w) r = rev (map swap (contacts_between r w l)).
Proof.
  induction w as [|x w IH]; intros l r; [reflexivity|].
  simpl rev. rewrite contacts_app, IH.
  assert (last_or l (rev w) = head_or w l) as -> by (unfold last_or; rewrite rev_involutive; reflexivity).
  destruct x; simpl; rewrite ?app_nil_r; try reflexivity.
Qed.

Lemma filter_rev_length {A} (f : A -> bool) l : length (filter f (rev l)) = length (filter f l).
Proof.
  induction l as [|a l IH]; [reflexivity|]. simpl. rewrite filter_app, app_length, IH; simpl.
  destruct (f a); simpl; lia.
Qed.

Lemma filter_swap_length (f : contact -> bool) l :
  (forall c, f (swap c) = f c) -> length (filter f (map swap l)) = length (filter f l).
Proof.
  intros Hf. induction l as [|c l IH]; [reflexivity|].
  simpl. rewrite Hf. destruct (f c); simpl; rewrite IH; reflexivity.
Qed.

Theorem crossings_rev w : i_of (rev w) = i_of w.
Proof.
  unfold i_of, contacts, crossings. rewrite contacts_rev, filter_rev_length.
  apply filter_swap_length, crossing_swap.
Qed.

Theorem touches_rev w : t_of (rev w) = t_of w.
Proof.
  unfold t_of, contacts, touches. rewrite contacts_rev, filter_rev_length.
  apply filter_swap_length. intros c; rewrite crossing_swap; reflexivity.
Qed.

Lemma last_is_first_rev w : last_of (rev w) = first w.
Proof. destruct w as [|x w]; [reflexivity|]. simpl. unfold last_of. rewrite last_last. reflexivity. Qed.

Lemma first_rev w : first (rev w) = last_of w.
Proof. rewrite <- last_is_first_rev, rev_involutive. reflexivity. Qed.

Theorem k_rev w : k_of (rev w) = k_of w.
Proof.
  unfold k_of. rewrite crossings_rev, first_rev, last_is_first_rev. f_equal. lia.
Qed.

Lemma linked_app u v :
  linked (u ++ v) = linked u && linked v &&
    match last_or None u, head_or v None with Some a, Some b => neighbours a b | _, _ => true end.
Proof.
  induction u as [|x u IH]; [simpl; rewrite andb_true_r; reflexivity|].
  destruct u as [|y u].
  - destruct v as [|z v]; [reflexivity|]. simpl. rewrite andb_comm. reflexivity.
  - change (linked ((x :: y :: u) ++ v)) with (neighbours x y && linked ((y :: u) ++ v)).
    change (linked (x :: y :: u)) with (neighbours x y && linked (y :: u)).
    rewrite IH. unfold last_or. simpl rev.
    destruct (rev u); simpl; rewrite !andb_assoc; reflexivity.
Qed.

Theorem admissible_rev w : admissible w -> admissible (rev w).
Proof.
  intros [Hne Hl]. split.
  - intros H. apply Hne. rewrite <- (rev_involutive w), H. reflexivity.
  - clear Hne. induction w as [|x w IH]; [reflexivity|].
    simpl. rewrite linked_app, (IH (linked_tail _ _ Hl)). unfold last_or; rewrite rev_involutive.
    destruct w as [|y w]; [reflexivity|]. simpl.
    simpl in Hl. apply andb_prop in Hl. rewrite neighbours_sym. apply Hl.
Qed.
