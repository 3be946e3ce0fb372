(* The rows of all admissible words of up to 13 letters, to be compared with the C functions.
   SPDX-License-Identifier: GPL-3.0-or-later

   [all_words] n lists the admissible words of at most n letters, each once ([all_words_complete],
   [all_words_once]). A row is the word, i, t, k, the case, then class, membership and definition by
   Definitions 6 and 7 and by 10 and 11, and the membership of the unsweep. *)
Require Import Bool Arith List Lia String DecimalString.
Require Import Graze.words Graze.counts Graze.definitions Graze.unsweep.
Import ListNotations.
Open Scope string_scope.

Definition extend (w : word) : list word :=
  match w with
  | [] => [[I]; [B]; [O]]
  | B :: _ => [I :: w; O :: w]
  | _ => [B :: w]
  end.
Fixpoint words_of (n : nat) : list word :=
  match n with 0 => [[]] | S m => flat_map extend (words_of m) end.
Definition all_words (n : nat) : list word := flat_map words_of (seq 1 n).

Lemma in_words_of n : forall w, In w (words_of n) <-> List.length w = n /\ linked w = true.
Proof.
  induction n as [|n IH]; intros w.
  - simpl. destruct w; simpl; split; intros H; try tauto; try (destruct H; discriminate).
    destruct H as [H|[]]; discriminate.
  - simpl. rewrite in_flat_map. split.
    + intros (u & Hu & He). apply IH in Hu. destruct Hu as [Hn Hl].
      destruct u as [|[] u]; simpl in He; intuition; subst; simpl in *; auto.
    + intros [Hn Hl]. destruct w as [|x w]; [discriminate|]. exists w. split.
      * apply IH. split; [simpl in Hn; lia|eapply linked_tail; eassumption].
      * destruct w as [|y w]; [destruct x; simpl; auto|].
        simpl in Hl. destruct x, y; simpl in *; try discriminate; auto.
Qed.

Theorem all_words_complete n w :
  In w (all_words n) <-> admissible w /\ List.length w <= n.
Proof.
  unfold all_words. rewrite in_flat_map. split.
  - intros (m & Hm & Hw). apply in_seq in Hm. apply in_words_of in Hw. destruct Hw as [Hl Hk].
    split; [split|lia]; [|assumption]. intros ->. simpl in Hl. lia.
  - intros [[Hne Hl] Hn]. exists (List.length w). split.
    + apply in_seq. destruct w; [congruence|simpl in *; lia].
    + apply in_words_of. auto.
Qed.

Lemma extend_once w : NoDup (extend w).
Proof.
  destruct w as [|[] w]; repeat constructor; simpl; intuition discriminate.
Qed.

Lemma flat_map_once {A B} (f : A -> list B) (g : B -> A) l :
  NoDup l -> (forall a, NoDup (f a)) -> (forall a b, In b (f a) -> In a l -> g b = a) ->
  NoDup (flat_map f l).
Proof.
  intros Hl Hf Hg. induction Hl as [|a l Ha Hl IH]; simpl; [constructor|].
  assert (NoDup (flat_map f l)) as Hr by (apply IH; intros; apply Hg; simpl; auto).
  assert (forall b, In b (f a) -> ~ In b (flat_map f l)) as Hd.
  { intros b Hb Hc. apply in_flat_map in Hc. destruct Hc as (c & Hc & Hbc).
    assert (g b = a) by (apply Hg; simpl; auto). assert (g b = c) by (apply Hg; simpl; auto).
    subst. contradiction. }
  clear - Hf Hr Hd. specialize (Hf a). induction Hf as [|b m Hb Hm IH]; simpl; [assumption|].
  constructor.
  - rewrite in_app_iff. intros [H|H]; [contradiction|]. apply (Hd b); simpl; auto.
  - apply IH. intros c Hc. apply Hd. simpl; auto.
Qed.

Theorem all_words_once n : NoDup (all_words n).
Proof.
  apply (flat_map_once _ (@List.length state)).
  - apply seq_NoDup.
  - intros m. induction m as [|m IH]; simpl; [repeat constructor; simpl; tauto|].
    apply (flat_map_once _ (@tl state)); [assumption|apply extend_once|].
    intros a b Hb _. destruct a as [|[] a]; simpl in Hb; intuition; subst; reflexivity.
  - intros a b Hb _. apply in_words_of in Hb. tauto.
Qed.

(* ------------------------------------------------------------------ printing *)
Definition letter (s : state) : string := match s with I => "I" | B => "B" | O => "O" end.
Definition letters (w : word) : string := String.concat "" (map letter w).
Definition number (n : nat) : string := NilZero.string_of_uint (Nat.to_uint n).
Definition class_name (c : class) : string :=
  match c with
  | regular => "regular" | fold => "fold" | fold_boundary => "fold_boundary"
  | boundary => "boundary" | exterior => "exterior"
  end.
Definition pmc_name (m : membership) : string :=
  match m with in_ => "in" | on => "on" | out => "out" end.

Definition fields (f : folds) (w : word) : list string :=
  [class_name (class_of_word f w); pmc_name (pmc_of (class_of_word f w));
   number (definition_of f w)].
Definition row (w : word) : string := String.concat ","
  ([letters w; number (i_of w); number (t_of w); number (k_of w); number (case_of w)]
   ++ fields separate w ++ fields combined w ++ [pmc_name (unsweep_pmc w)]).

Definition rows (n : nat) : list string := map row (all_words n).
