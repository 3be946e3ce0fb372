(* Unsweep, and the duality of sweep and unsweep, on words.
   SPDX-License-Identifier: GPL-3.0-or-later

   [unsweep_pmc]   in iff the word is I, out iff it holds an O, on otherwise ([IS] eq 35)
   [duality]       the word with I and O exchanged has the exchanged answer (claim C21) *)
Require Import Bool Arith List Lia.
Require Import Graze.words Graze.counts Graze.definitions.
Import ListNotations.

Definition unsweep_pmc (w : word) : membership :=
  if existsb (state_eqb O) w then out else if existsb (state_eqb B) w then on else in_.

Definition exchange (s : state) : state := match s with I => O | B => B | O => I end.
Definition dual (w : word) : word := map exchange w.
Definition opposite (m : membership) : membership :=
  match m with in_ => out | on => on | out => in_ end.

Lemma existsb_state s w : existsb (state_eqb s) w = true <-> In s w.
Proof.
  rewrite existsb_exists. split.
  - intros (x & Hx & He). apply state_eqb_eq in He. subst. assumption.
  - intros H. exists s. split; [assumption|]. apply state_eqb_eq. reflexivity.
Qed.

Theorem unsweep_in w : admissible w -> (unsweep_pmc w = in_ <-> w = [I]).
Proof.
  intros [Hne Hl]. unfold unsweep_pmc. split.
  - intros H. destruct w as [|[] [|[] w]]; simpl in *; try congruence;
      destruct (existsb _ w); simpl in *; discriminate.
  - intros ->. reflexivity.
Qed.

Theorem unsweep_out w : unsweep_pmc w = out <-> In O w.
Proof.
  unfold unsweep_pmc. rewrite <- existsb_state. destruct (existsb (state_eqb O) w); [tauto|].
  destruct (existsb (state_eqb B) w); split; discriminate.
Qed.

Theorem unsweep_on w : admissible w -> (unsweep_pmc w = on <-> w <> [I] /\ ~ In O w).
Proof.
  intros H. rewrite <- (unsweep_in w H), <- unsweep_out.
  destruct (unsweep_pmc w); split; intros K; try discriminate; try tauto; try (split; discriminate).
  all: exfalso; tauto.
Qed.

Lemma dual_involutive w : dual (dual w) = w.
Proof. induction w as [|[] w IH]; simpl; congruence. Qed.

Theorem dual_admissible w : admissible w -> admissible (dual w).
Proof.
  intros [Hne Hl]. split; [destruct w; simpl; congruence|]. clear Hne.
  induction w as [|x [|y w] IH]; [reflexivity..|].
  simpl in *. apply andb_prop in Hl. rewrite (IH (proj2 Hl)).
  destruct x, y; simpl in *; intuition.
Qed.

Lemma in_dual s w : In (exchange s) (dual w) <-> In s w.
Proof.
  unfold dual. rewrite in_map_iff. split.
  - intros (x & He & Hx). destruct x, s; simpl in *; congruence.
  - intros H. exists s. auto.
Qed.

Theorem duality f w : admissible w ->
  unsweep_pmc (dual w) = opposite (pmc_of (class_of_word f w)).
Proof.
  intros H. unfold unsweep_pmc.
  pose proof (pmc_in f w H) as Hi. pose proof (pmc_on f w H) as Ho.
  pose proof (in_dual I w) as HI. pose proof (in_dual B w) as HB. simpl in HI, HB.
  rewrite <- existsb_state in HI, HB.
  destruct (existsb (state_eqb O) (dual w)), (existsb (state_eqb B) (dual w)),
    (pmc_of (class_of_word f w)); simpl; try reflexivity; exfalso; intuition discriminate.
Qed.
