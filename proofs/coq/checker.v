(* The verified checker of certificates, and what its acceptance means.
   SPDX-License-Identifier: GPL-3.0-or-later

   [check]   an oriented boundary, a motion, the times of its signs, a point and a row of a certificate
   [sweep_checked], [unsweep_checked]   if it accepts and the solid is legal, the motion is legal, the row's
             word is the word of the point, and its answers are what they should be
   [sweep_checked_plane], [sweep_checked_space], [unsweep_checked_plane], [unsweep_checked_space]   and
             there is such a motion over the reals *)
Require Import Reals Lra Lia List ZArith Bool.
Require Import Graze.words Graze.definitions Graze.unsweep Graze.times Graze.space Graze.sweep Graze.bernstein
  Graze.facets Graze.sample Graze.interval Graze.row Graze.simplices Graze.motions.
Import ListNotations.
Open Scope R_scope.

Definition check (o : operation) (f : folds) (d : nat) (scale : Z) (ss : list simplex) (ps : list piece)
  (signs : list time) (V : list Z) (r : row) : bool :=
  match facets_of scale d ss with
  | Some F => check_motion d ps signs && check_row o f d F ps V r
  | None => false
  end.

Lemma same_membership_eq x y : same_membership x y = true -> x = y.
Proof. destruct x, y; simpl; congruence. Qed.
Lemma same_class_eq x y : same_class x y = true -> x = y.
Proof. destruct x, y; simpl; congruence. Qed.

(* What a row of a sweep says of the point P. *)
Definition says_sweep {d a b} (M : motion d a b) (A : set d) (P : point d) (f : folds) (r : row) : Prop :=
  let w := word_of r in
  is_word (trace_of M A P) a b w /\ (forall v, is_word (trace_of M A P) a b v -> v = w) /\ admissible w /\
  class_claimed r = class_of_word f w /\ definition r = definition_of f w /\ position r = case_of w /\
  crosses r = i_of w /\ tangent r = t_of w /\ inner_count r = k_of w /\
  (pmc r = in_ <-> open_sweep M A P) /\
  (pmc r = definitions.on <-> space.boundary (open_sweep M A) P) /\
  (pmc r = out <-> ~ sweep M A P).
Definition says_unsweep {d a b} (M : motion d a b) (A : set d) (P : point d) (r : row) : Prop :=
  let w := word_of r in
  is_word (forward_trace M A P) a b w /\ (forall v, is_word (forward_trace M A P) a b v -> v = w) /\ admissible w /\
  (pmc r = in_ <-> interior (unsweep M A) P) /\
  (pmc r = definitions.on <-> unsweep M A P /\ ~ interior (unsweep M A) P) /\
  (pmc r = out <-> ~ unsweep M A P).

Section Checked.
Context {d : nat} (f : folds) (scale : Z) (ss : list simplex) (ps : list piece) (signs : list time) (V : list Z)
  (r : row) (A : set (S d)).
Hypothesis HA : legal_solid scale ss A.
Let t0 := instant (first_time ps).
Let t1 := instant (last_time ps).

Theorem check_row_word o : check o f (S d) scale ss ps signs V r = true ->
  legal_motion (S d) ps /\ forall M : motion (S d) t0 t1, given_by ps M ->
  is_word (fun t => state_at A (path ps M V o t)) t0 t1 (word_of r) /\ claims_ok o f r = true.
Proof.
  intros H. unfold check in H. destruct (facets_of scale (S d) ss) as [F|] eqn:EF; [|discriminate].
  apply andb_prop in H. destruct H as [Hm Hr]. pose proof (motion_legal _ _ _ Hm) as HL. split; [exact HL|].
  intros M HM. destruct (legal_facets scale ss F A EF HA) as [HF Hbounds].
  apply (row_sound F A ps M V f r HF Hbounds HM o Hr). apply (chained_inside (S d) ps), HL.
Qed.

Theorem sweep_checked : check sweeping f (S d) scale ss ps signs V r = true ->
  legal_motion (S d) ps /\ forall M : motion (S d) t0 t1, given_by ps M -> says_sweep M A (point_of V) f r.
Proof.
  intros H. destruct (check_row_word sweeping H) as [HL K]. split; [exact HL|]. intros M HM.
  destruct (K M HM) as [W C]. change (is_word (trace_of M A (point_of V)) t0 t1 (word_of r)) in W.
  pose proof (solid_regular _ _ _ HA) as HR. simpl in C.
  repeat (let X := fresh "E" in apply andb_prop in C; destruct C as [C X]).
  apply same_membership_eq in C. apply same_class_eq in E4.
  apply Nat.eqb_eq in E, E0, E1, E2, E3. unfold says_sweep.
  split; [exact W|]. split; [intros v Wv; exact (word_unique _ _ _ _ _ (trace_functional M A _) Wv W)|].
  split; [exact (trace_admissible M A _ _ W)|]. repeat (split; [assumption|]). rewrite C.
  split; [apply in_is, W|]. split; [apply on_is; assumption|]. apply out_is; [exact W|].
  apply regular_closed_closed, HR.
Qed.

Theorem unsweep_checked : check unsweeping f (S d) scale ss ps signs V r = true ->
  legal_motion (S d) ps /\ forall M : motion (S d) t0 t1, given_by ps M -> says_unsweep M A (point_of V) r.
Proof.
  intros H. destruct (check_row_word unsweeping H) as [HL K]. split; [exact HL|]. intros M HM.
  destruct (K M HM) as [W C]. change (is_word (forward_trace M A (point_of V)) t0 t1 (word_of r)) in W.
  pose proof (regular_closed_closed _ (solid_regular _ _ _ HA)) as HC. simpl in C.
  apply same_membership_eq in C. unfold says_unsweep.
  split; [exact W|]. split.
  { intros v Wv. refine (word_unique _ _ _ _ _ _ Wv W). intros t x y _. apply state_functional. }
  split; [exact (forward_admissible M A _ _ W)|]. rewrite C.
  split; [apply unsweep_in_is, W|]. split; [apply unsweep_on_is; assumption|]. apply unsweep_out_is; assumption.
Qed.
End Checked.

(* In the plane and in space the motion exists: the statements above are of something. *)
Section Dimensions.
Context (f : folds) (scale : Z) (ss : list simplex) (ps : list piece) (signs : list time) (V : list Z) (r : row).
Let t0 := instant (first_time ps).
Let t1 := instant (last_time ps).

Theorem sweep_checked_plane (A : set 2) : check sweeping f 2 scale ss ps signs V r = true ->
  legal_solid scale ss A ->
  (exists M : motion 2 t0 t1, given_by ps M) /\
  forall M : motion 2 t0 t1, given_by ps M -> says_sweep M A (point_of V) f r.
Proof.
  intros H HA. destruct (sweep_checked f scale ss ps signs V r A HA H) as [HL K].
  split; [apply motion_exists_plane, HL|exact K].
Qed.
Theorem sweep_checked_space (A : set 3) : check sweeping f 3 scale ss ps signs V r = true ->
  legal_solid scale ss A ->
  (exists M : motion 3 t0 t1, given_by ps M) /\
  forall M : motion 3 t0 t1, given_by ps M -> says_sweep M A (point_of V) f r.
Proof.
  intros H HA. destruct (sweep_checked f scale ss ps signs V r A HA H) as [HL K].
  split; [apply motion_exists_space, HL|exact K].
Qed.
Theorem unsweep_checked_plane (A : set 2) : check unsweeping f 2 scale ss ps signs V r = true ->
  legal_solid scale ss A ->
  (exists M : motion 2 t0 t1, given_by ps M) /\
  forall M : motion 2 t0 t1, given_by ps M -> says_unsweep M A (point_of V) r.
Proof.
  intros H HA. destruct (unsweep_checked f scale ss ps signs V r A HA H) as [HL K].
  split; [apply motion_exists_plane, HL|exact K].
Qed.
Theorem unsweep_checked_space (A : set 3) : check unsweeping f 3 scale ss ps signs V r = true ->
  legal_solid scale ss A ->
  (exists M : motion 3 t0 t1, given_by ps M) /\
  forall M : motion 3 t0 t1, given_by ps M -> says_unsweep M A (point_of V) r.
Proof.
  intros H HA. destruct (unsweep_checked f scale ss ps signs V r A HA H) as [HL K].
  split; [apply motion_exists_space, HL|exact K].
Qed.
End Dimensions.
