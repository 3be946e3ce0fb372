(* Motions given by matrices, and the theorem that the parts make up (cramer.v has the inverse matrices).
   SPDX-License-Identifier: GPL-3.0-or-later

   [continuous_in]    a number that depends on time and place, continuously in both; [continuous_plus], ...
   [affine]           x -> A(t) x + b(t) with an inverse matrix, all entries continuous
   [affine_motion]    such maps are a motion
   [back_rational]    rational entries of the inverse matrix and of b make the inverted trajectory so
   [sweep_bounded]    the sweep of a bounded solid is bounded (claim C18: with sweep_closed, compact)
   [classified]       the theorem the parts make up: a polyhedral solid, a piecewise rational motion: each
                      point has one word, it is admissible, and its answer is what it should be *)
Require Import Reals Lra FunctionalExtensionality.
Require Fin.
Require Import Graze.words Graze.definitions Graze.times Graze.space Graze.sweep Graze.polynomials
  Graze.finite.
Open Scope R_scope.

(* ------------------------------------------------------------------ continuity *)
Section Continuity.
Context {d : nat} (a b : R).

Definition continuous_in (g : R -> point d -> R) : Prop :=
  forall t x, a <= t <= b -> forall e, e > 0 ->
  exists r, r > 0 /\ forall u y, a <= u <= b -> Rabs (u - t) < r -> near x r y ->
  Rabs (g u y - g t x) < e.

(* Two margins at once. *)
Lemma both_margins g h t x e f : continuous_in g -> continuous_in h -> a <= t <= b -> e > 0 -> f > 0 ->
  exists r, r > 0 /\ forall u y, a <= u <= b -> Rabs (u - t) < r -> near x r y ->
  Rabs (g u y - g t x) < e /\ Rabs (h u y - h t x) < f.
Proof.
  intros Hg Hh Ht He Hf. destruct (Hg t x Ht e He) as (r & Hr & K), (Hh t x Ht f Hf) as (s & Hs & L).
  exists (Rmin r s). split; [apply Rmin_pos; assumption|]. intros u y Hu Hut Hy.
  pose proof (Rmin_l r s). pose proof (Rmin_r r s). split.
  - apply K; try assumption; [lra|]. eapply near_less; eassumption.
  - apply L; try assumption; [lra|]. eapply near_less; eassumption.
Qed.

Lemma continuous_const c : continuous_in (fun _ _ => c).
Proof.
  intros t x Ht e He. exists 1. split; [lra|]. intros. replace (c - c) with 0 by ring.
  rewrite Rabs_R0. lra.
Qed.

Lemma continuous_coordinate i : continuous_in (fun _ x => x i).
Proof. intros t x Ht e He. exists e. split; [assumption|]. intros u y _ _ Hy. apply Hy. Qed.

Lemma continuous_plus g h : continuous_in g -> continuous_in h ->
  continuous_in (fun t x => g t x + h t x).
Proof.
  intros Hg Hh t x Ht e He.
  destruct (both_margins g h t x (e / 2) (e / 2) Hg Hh Ht ltac:(lra) ltac:(lra)) as (r & Hr & K).
  exists r. split; [assumption|]. intros u y Hu Hut Hy. destruct (K u y Hu Hut Hy) as [K1 K2].
  replace (g u y + h u y - (g t x + h t x)) with ((g u y - g t x) + (h u y - h t x)) by ring.
  eapply Rle_lt_trans; [apply Rabs_triang|]. lra.
Qed.

Lemma continuous_mult g h : continuous_in g -> continuous_in h ->
  continuous_in (fun t x => g t x * h t x).
Proof.
  intros Hg Hh t x Ht e He.
  set (p := Rabs (g t x)). set (q := Rabs (h t x)).
  assert (0 <= p /\ 0 <= q) as [Hp Hq] by (split; apply Rabs_pos).
  set (k := Rmin 1 (e / (p + q + 2))).
  assert (0 < e / (p + q + 2)) as He2 by (apply Rdiv_lt_0_compat; lra).
  assert (0 < k) as Hk by (apply Rmin_pos; lra).
  pose proof (Rmin_l 1 (e / (p + q + 2)) : k <= 1) as K1.
  pose proof (Rmin_r 1 (e / (p + q + 2)) : k <= _) as K2.
  destruct (both_margins g h t x k k Hg Hh Ht Hk Hk) as (r & Hr & K).
  exists r. split; [assumption|]. intros u y Hu Hut Hy. destruct (K u y Hu Hut Hy) as [L1 L2].
  replace (g u y * h u y - g t x * h t x) with
    ((g u y - g t x) * (h u y - h t x) + g t x * (h u y - h t x) + h t x * (g u y - g t x)) by ring.
  apply Rle_lt_trans with (k * k + p * k + q * k).
  - eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
    + eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. fold p. apply Rplus_le_compat.
      * apply Rmult_le_compat; try apply Rabs_pos; lra.
      * apply Rmult_le_compat_l; lra.
    + rewrite Rabs_mult. fold q. apply Rmult_le_compat_l; lra.
  - apply Rle_lt_trans with (k * (p + q + 1)).
    + replace (k * k + p * k + q * k) with (k * (k + p + q)) by ring. apply Rmult_le_compat_l; lra.
    + apply Rlt_le_trans with (k * (p + q + 2)); [apply Rmult_lt_compat_l; lra|].
      apply Rle_trans with (e / (p + q + 2) * (p + q + 2)); [apply Rmult_le_compat_r; lra|].
      right. field. lra.
Qed.

Lemma continuous_inv g : continuous_in g -> (forall t x, a <= t <= b -> g t x <> 0) ->
  continuous_in (fun t x => / g t x).
Proof.
  intros Hg Hne t x Ht e He. pose proof (Hne t x Ht) as H0.
  set (p := Rabs (g t x)). assert (0 < p) as Hp by (apply Rabs_pos_lt, H0).
  set (k := Rmin (p / 2) (e * (p * p) / 2)).
  assert (0 < e * (p * p) / 2) as He2.
  { apply Rdiv_lt_0_compat; [|lra]. repeat apply Rmult_lt_0_compat; assumption. }
  assert (0 < k) as Hk by (apply Rmin_pos; lra).
  pose proof (Rmin_l (p / 2) (e * (p * p) / 2) : k <= _) as K1.
  pose proof (Rmin_r (p / 2) (e * (p * p) / 2) : k <= _) as K2.
  destruct (Hg t x Ht k Hk) as (r & Hr & K). exists r. split; [assumption|].
  intros u y Hu Hut Hy. specialize (K u y Hu Hut Hy). pose proof (Hne u y Hu) as H1.
  assert (p / 2 < Rabs (g u y)) as Hq.
  { pose proof (Rabs_triang (g t x - g u y) (g u y)) as Htri.
    replace (g t x - g u y + g u y) with (g t x) in Htri by ring. fold p in Htri.
    rewrite Rabs_minus_sym in Htri. lra. }
  replace (/ g u y - / g t x) with ((g t x - g u y) * / (g u y * g t x)) by (field; auto).
  rewrite Rabs_mult, Rabs_inv, Rabs_mult. fold p. rewrite Rabs_minus_sym.
  assert (0 < Rabs (g u y) * p) as Hqp by (apply Rmult_lt_0_compat; lra).
  apply Rmult_lt_reg_r with (Rabs (g u y) * p); [assumption|].
  rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  apply Rlt_le_trans with (e * (p / 2 * p)); [lra|].
  apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; lra.
Qed.

Lemma continuous_same g h : (forall t x, g t x = h t x) -> continuous_in g -> continuous_in h.
Proof.
  intros He Hg t x Ht e Hpos. destruct (Hg t x Ht e Hpos) as (r & Hr & K). exists r.
  split; [assumption|]. intros. rewrite <- !He. auto.
Qed.

Lemma continuous_minus g h : continuous_in g -> continuous_in h ->
  continuous_in (fun t x => g t x - h t x).
Proof.
  intros Hg Hh. apply continuous_same with (fun t x => g t x + -1 * h t x); [intros; ring|].
  apply continuous_plus; [assumption|]. apply continuous_mult; [apply continuous_const|assumption].
Qed.

End Continuity.

Lemma continuous_sum {d n} a b (g : R -> point d -> Fin.t n -> R) :
  (forall i, continuous_in a b (fun t x => g t x i)) -> continuous_in a b (fun t x => sum (g t x)).
Proof.
  intros H. induction n as [|n IH]; simpl; [apply continuous_const|].
  apply (continuous_plus a b (fun t x => g t x Fin.F1) (fun t x => sum (fun i => g t x (Fin.FS i)))).
  - apply H.
  - apply (IH (fun t x i => g t x (Fin.FS i))). intros i. apply H.
Qed.

(* One margin for finitely many coordinates. *)
Lemma common_margin {n} (Q : Fin.t n -> R -> Prop) :
  (forall i e f, Q i e -> f <= e -> Q i f) ->
  (forall i, exists e, e > 0 /\ Q i e) -> exists e, e > 0 /\ forall i, Q i e.
Proof.
  induction n as [|n IH]; intros Hless H.
  - exists 1. split; [lra|]. intros i. apply (Fin.case0 (fun i => Q i 1) i).
  - destruct (H Fin.F1) as (e & He & K), (IH (fun i => Q (Fin.FS i))) as (f & Hf & L).
    + intros i. apply Hless.
    + intros i. apply H.
    + exists (Rmin e f). split; [apply Rmin_pos; assumption|]. intros i.
      apply (Fin.caseS' i (fun i => Q i (Rmin e f))).
      * apply Hless with e; [assumption|apply Rmin_l].
      * intros j. apply Hless with f; [apply L|apply Rmin_r].
Qed.

Lemma jointly_continuous_by_coordinates {d} a b (f : R -> point d -> point d) :
  (forall i, continuous_in a b (fun t x => f t x i)) -> jointly_continuous a b f.
Proof.
  intros H t x Ht e He.
  destruct (common_margin (fun i r => forall u y, a <= u <= b -> Rabs (u - t) < r -> near x r y ->
    Rabs (f u y i - f t x i) < e)) as (r & Hr & K).
  - intros i r s K Hsr u y Hu Hut Hy. apply K; [assumption|lra|]. eapply near_less; eassumption.
  - intros i. exact (H i t x Ht e He).
  - exists r. split; [assumption|]. intros u y Hu Hut Hy i. apply K; assumption.
Qed.

(* ------------------------------------------------------------------ matrices *)
Definition matrix (d : nat) := Fin.t d -> Fin.t d -> R.
Definition unit_matrix {d} : matrix d := fun i j => if Fin.eq_dec i j then 1 else 0.
Definition product {d} (A A' : matrix d) : matrix d := fun i k => sum (fun j => A i j * A' j k).
Definition apply_matrix {d} (A : matrix d) (x : point d) : point d := fun i => sum (fun j => A i j * x j).

Lemma sum_zero {n} : sum (fun _ : Fin.t n => 0) = 0.
Proof. induction n as [|n IH]; simpl; [reflexivity|]. rewrite IH. ring. Qed.

Lemma sum_exchange {m n} (f : Fin.t m -> Fin.t n -> R) :
  sum (fun i => sum (fun j => f i j)) = sum (fun j => sum (fun i => f i j)).
Proof.
  induction m as [|m IH]; simpl; [symmetry; apply sum_zero|].
  rewrite sum_plus, IH. reflexivity.
Qed.

Lemma sum_unit {n} (i : Fin.t n) (x : Fin.t n -> R) : sum (fun k => unit_matrix i k * x k) = x i.
Proof.
  induction n as [|n IH]; [apply (Fin.case0 (fun i => _ = x i) i)|].
  unfold unit_matrix in *. simpl.
  apply (Fin.caseS' i (fun i => (if Fin.eq_dec i Fin.F1 then 1 else 0) * x Fin.F1
    + sum (fun k => (if Fin.eq_dec i (Fin.FS k) then 1 else 0) * x (Fin.FS k)) = x i)).
  - destruct (Fin.eq_dec Fin.F1 Fin.F1) as [_|N]; [|congruence].
    rewrite (sum_same _ (fun _ => 0)), sum_zero; [ring|].
    intros k. destruct (Fin.eq_dec Fin.F1 (Fin.FS k)) as [E|_]; [discriminate|ring].
  - intros j. destruct (Fin.eq_dec (Fin.FS j) Fin.F1) as [E|_]; [discriminate|].
    rewrite (sum_same _ (fun k => (if Fin.eq_dec j k then 1 else 0) * x (Fin.FS k))), (IH j (fun k => x (Fin.FS k))); [ring|].
    intros k. destruct (Fin.eq_dec (Fin.FS j) (Fin.FS k)) as [E|N], (Fin.eq_dec j k) as [E'|N'];
      try reflexivity; exfalso.
    + apply N', Fin.FS_inj, E.
    + apply N. congruence.
Qed.

Lemma apply_product {d} (A A' : matrix d) x i :
  apply_matrix A (apply_matrix A' x) i = apply_matrix (product A A') x i.
Proof.
  unfold apply_matrix, product.
  rewrite (sum_same _ (fun j => sum (fun k => A i j * A' j k * x k))).
  - rewrite sum_exchange. apply sum_same. intros k.
    rewrite (sum_same _ (fun j => x k * (A i j * A' j k))) by (intros; ring).
    rewrite sum_scale. ring.
  - intros j. rewrite <- sum_scale. apply sum_same. intros k. ring.
Qed.

(* ------------------------------------------------------------------ affine motions *)
Record affine (d : nat) (a b : R) := {
  in_order : a <= b;
  linear : R -> matrix d;
  inverse_linear : R -> matrix d;
  shift : R -> point d;
  left_inverse : forall t, a <= t <= b -> forall i j,
    product (inverse_linear t) (linear t) i j = unit_matrix i j;
  right_inverse : forall t, a <= t <= b -> forall i j,
    product (linear t) (inverse_linear t) i j = unit_matrix i j;
  linear_continuous : forall i j, continuous_in (d := d) a b (fun t _ => linear t i j);
  inverse_continuous : forall i j, continuous_in (d := d) a b (fun t _ => inverse_linear t i j);
  shift_continuous : forall i, continuous_in (d := d) a b (fun t _ => shift t i)
}.
Arguments linear {d a b}. Arguments inverse_linear {d a b}. Arguments shift {d a b}.

Definition affine_move {d a b} (M : affine d a b) t (x : point d) : point d :=
  fun i => apply_matrix (linear M t) x i + shift M t i.
Definition affine_back {d a b} (M : affine d a b) t (P : point d) : point d :=
  apply_matrix (inverse_linear M t) (fun j => P j - shift M t j).

Lemma apply_unit {d} (A : matrix d) x i : (forall i j, A i j = unit_matrix i j) -> apply_matrix A x i = x i.
Proof.
  intros H. unfold apply_matrix. rewrite (sum_same _ (fun k => unit_matrix i k * x k)).
  - apply sum_unit.
  - intros k. rewrite H. reflexivity.
Qed.

Definition affine_motion {d a b} (M : affine d a b) : motion d a b.
Proof.
  refine {| move := affine_move M; back := affine_back M; ordered := in_order d a b M |}.
  - intros t x Ht. apply functional_extensionality. intros i. unfold affine_move, affine_back.
    rewrite apply_product, apply_unit by (apply right_inverse; assumption). ring.
  - intros t x Ht. apply functional_extensionality. intros i. unfold affine_move, affine_back.
    replace (fun j => apply_matrix (linear M t) x j + shift M t j - shift M t j)
      with (apply_matrix (linear M t) x) by (apply functional_extensionality; intros; ring).
    rewrite apply_product. apply apply_unit, left_inverse, Ht.
  - apply jointly_continuous_by_coordinates. intros i. unfold affine_move, apply_matrix.
    apply continuous_plus; [|apply shift_continuous].
    apply (continuous_sum a b (fun t x j => linear M t i j * x j)). intros j.
    apply continuous_mult; [apply linear_continuous|apply continuous_coordinate].
  - apply jointly_continuous_by_coordinates. intros i. unfold affine_back, apply_matrix.
    apply (continuous_sum a b (fun t x j => inverse_linear M t i j * (x j - shift M t j))). intros j.
    apply continuous_mult; [apply inverse_continuous|].
    apply continuous_minus; [apply continuous_coordinate|apply shift_continuous].
Defined.

Lemma affine_motion_is {d a b} (M : affine d a b) :
  move (affine_motion M) = affine_move M /\ back (affine_motion M) = affine_back M.
Proof. split; reflexivity. Qed.

Lemma back_rational {d a b} (M : affine d a b) P u v :
  (forall i j, rational (fun t => inverse_linear M t i j) u v) ->
  (forall i, rational (fun t => shift M t i) u v) ->
  forall i, rational (fun t => back (affine_motion M) t P i) u v.
Proof.
  intros Ha Hb i. simpl. unfold affine_back, apply_matrix.
  apply (sum_rational (fun t j => inverse_linear M t i j * (P j - shift M t j))). intros j.
  apply rational_mult; [apply Ha|]. apply rational_minus; [apply rational_const|apply Hb].
Qed.

(* ------------------------------------------------------------------ bounded *)
Definition bounded {d} (A : set d) : Prop := exists r, forall x, A x -> forall i, Rabs (x i) <= r.

(* A bound that holds however small: |g| <= 1/e for some e. *)
Lemma continuous_bounded {d} a b (g : R -> R) : a <= b ->
  continuous_in (d := d) a b (fun t _ => g t) ->
  exists e, e > 0 /\ (0 < e -> forall t, a <= t <= b -> Rabs (g t) <= / e).
Proof.
  intros Hab Hg. destruct (uniform_on_interval a b (fun e t => 0 < e -> Rabs (g t) <= / e)) as (e & He & K).
  - assumption.
  - intros e f t H Hfe Hf. apply Rle_trans with (/ e); [apply H; lra|].
    apply Rinv_le_contravar; assumption.
  - intros t Ht. destruct (Hg t (fun _ => 0) Ht 1 ltac:(lra)) as (r & Hr & K).
    set (k := Rabs (g t) + 1). assert (0 < k) as Hk by (pose proof (Rabs_pos (g t)); unfold k; lra).
    assert (0 < / k) as Hk' by (apply Rinv_0_lt_compat, Hk).
    exists (Rmin r (/ k)). split; [apply Rmin_pos; assumption|]. intros u Hu Hut Hpos.
    pose proof (Rmin_l r (/ k)) as R1. pose proof (Rmin_r r (/ k)) as R2.
    apply Rle_trans with k.
    + pose proof (K u (fun _ => 0) Hu ltac:(lra) (near_self _ _ Hr)) as L.
      pose proof (Rabs_triang (g u - g t) (g t)) as Htri.
      replace (g u - g t + g t) with (g u) in Htri by ring. unfold k. lra.
    + apply Rle_trans with (/ / k); [right; rewrite Rinv_inv; reflexivity|].
      apply Rinv_le_contravar; assumption.
  - exists e. auto.
Qed.

Theorem sweep_bounded {d a b} (M : affine d a b) (S : set d) :
  bounded S -> bounded (sweep (affine_motion M) S).
Proof.
  intros [r Hr]. pose proof (in_order d a b M) as Hab.
  assert (forall e f x, 0 < f -> f <= e -> (0 < e -> x <= / e) -> x <= / f) as Hless.
  { intros e f x Hf Hfe H. apply Rle_trans with (/ e); [apply H; lra|].
    apply Rinv_le_contravar; assumption. }
  destruct (common_margin (fun i e => 0 < e -> forall t, a <= t <= b -> Rabs (shift M t i) <= / e))
    as (e & He & Ke).
  { intros i e f H Hfe Hf t Ht. apply (Hless e); auto. }
  { intros i. apply (continuous_bounded (d := d)); [assumption|apply shift_continuous]. }
  destruct (common_margin (fun i e => 0 < e -> forall j t, a <= t <= b -> Rabs (linear M t i j) <= / e))
    as (f & Hf & Kf).
  { intros i x y H Hfe Hy j t Ht. apply (Hless x); auto. }
  { intros i. destruct (common_margin (fun j e => 0 < e -> forall t, a <= t <= b -> Rabs (linear M t i j) <= / e))
      as (f & Hf & Kf).
    - intros j x y H Hfe Hy t Ht. apply (Hless x); auto.
    - intros j. apply (continuous_bounded (d := d)); [assumption|apply linear_continuous].
    - exists f. auto. }
  exists (sum (fun _ : Fin.t d => / f * r) + / e). intros P (t & Ht & x & Hx & ->) i. simpl.
  unfold affine_move, apply_matrix. eapply Rle_trans; [apply Rabs_triang|].
  apply Rplus_le_compat; [|apply Ke; assumption].
  apply sum_bound. intros j. rewrite Rabs_mult.
  apply Rmult_le_compat; try apply Rabs_pos; [apply Kf; assumption|apply Hr; assumption].
Qed.

(* ------------------------------------------------------------------ the whole *)
Definition rational_piece {d a b} (M : affine d a b) (u v : R) : Prop :=
  (forall i j, rational (fun t => inverse_linear M t i j) u v) /\
  (forall i, rational (fun t => shift M t i) u v).

Theorem classified {d a b} (M : affine d a b) (S : set d) fs P :
  regular_closed S -> polyhedral S fs -> chain (rational_piece M) a b ->
  exists w, is_word (trace_of (affine_motion M) S P) a b w /\
    (forall v, is_word (trace_of (affine_motion M) S P) a b v -> v = w) /\
    admissible w /\
    forall f, let answer := pmc_of (class_of_word f w) in
      (answer = in_ <-> open_sweep (affine_motion M) S P) /\
      (answer = on <-> boundary (open_sweep (affine_motion M) S) P) /\
      (answer = out <-> ~ sweep (affine_motion M) S P).
Proof.
  intros HS Hfs Hc.
  destruct (one_word (affine_motion M) S fs P Hfs) as (w & W & Hu).
  - revert Hc. apply chain_refine. intros u v Huv [Ha Hb].
    apply chain_gap with v; [assumption| |apply chain_end]. apply back_rational; assumption.
  - exists w. split; [exact W|]. split; [intros v V; symmetry; apply Hu, V|].
    split; [exact (trace_admissible _ _ _ _ W)|]. intros f. cbv zeta.
    split; [apply in_is, W|]. split; [apply on_is; assumption|].
    apply out_is; [exact W|apply regular_closed_closed, HS].
Qed.
