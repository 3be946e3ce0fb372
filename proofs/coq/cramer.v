(* In the plane and in space: entries that are continuous and a determinant that never vanishes make an
   affine motion; rational entries make its inverse rational.
   SPDX-License-Identifier: GPL-3.0-or-later

   [inverse2], [inverse3]   the inverse matrices, by Cramer's rule
   [plane_motion], [space_motion]   A(t), b(t) with continuous entries and det A(t) <> 0
   [classified_plane], [classified_space]   the whole theorem from S, A and b: in E^2 and in E^3 *)
Require Import Reals Lra.
Require Fin.
Require Import Graze.words Graze.definitions Graze.times Graze.space Graze.sweep Graze.polynomials
  Graze.finite Graze.affine.
Open Scope R_scope.

Definition vec2 {A} (x y : A) (i : Fin.t 2) : A :=
  Fin.caseS' i (fun _ => A) x (fun _ => y).
Definition vec3 {A} (x y z : A) (i : Fin.t 3) : A :=
  Fin.caseS' i (fun _ => A) x (vec2 y z).

Notation i0 := Fin.F1.
Notation i1 := (Fin.FS Fin.F1).
Notation i2 := (Fin.FS (Fin.FS Fin.F1)).

Lemma all2 (P : Fin.t 2 -> Prop) : P i0 -> P i1 -> forall i, P i.
Proof.
  intros H0 H1 i. apply (Fin.caseS' i P H0). intros j.
  apply (Fin.caseS' j (fun j => P (Fin.FS j)) H1). intros k. apply (Fin.case0 (fun _ => _) k).
Qed.

Lemma all3 (P : Fin.t 3 -> Prop) : P i0 -> P i1 -> P i2 -> forall i, P i.
Proof. intros H0 H1 H2 i. apply (Fin.caseS' i P H0). apply all2; assumption. Qed.

Definition det2 (A : matrix 2) : R := A i0 i0 * A i1 i1 - A i0 i1 * A i1 i0.
Definition adjugate2 (A : matrix 2) : matrix 2 := fun i j =>
  vec2 (vec2 (A i1 i1) (- A i0 i1) j) (vec2 (- A i1 i0) (A i0 i0) j) i.
Definition inverse2 (A : matrix 2) : matrix 2 := fun i j => adjugate2 A i j * / det2 A.

(* The minor of rows p, q and columns r, s. *)
Definition minor (A : matrix 3) p q r s : R := A p r * A q s - A p s * A q r.
Definition det3 (A : matrix 3) : R :=
  A i0 i0 * minor A i1 i2 i1 i2 - A i0 i1 * minor A i1 i2 i0 i2 + A i0 i2 * minor A i1 i2 i0 i1.
Definition adjugate3 (A : matrix 3) : matrix 3 := fun i j =>
  vec3 (vec3 (minor A i1 i2 i1 i2) (- minor A i0 i2 i1 i2) (minor A i0 i1 i1 i2) j)
       (vec3 (- minor A i1 i2 i0 i2) (minor A i0 i2 i0 i2) (- minor A i0 i1 i0 i2) j)
       (vec3 (minor A i1 i2 i0 i1) (- minor A i0 i2 i0 i1) (minor A i0 i1 i0 i1) j) i.
Definition inverse3 (A : matrix 3) : matrix 3 := fun i j => adjugate3 A i j * / det3 A.

(* A sum over coordinates against the unit matrix, entry by entry. *)
Ltac unit_entry :=
  unfold unit_matrix; destruct Fin.eq_dec as [E|N];
  [try discriminate; try (apply Fin.FS_inj in E; discriminate)
  |try (exfalso; apply N; reflexivity)]; try clear E; try clear N.

Lemma inverse2_left A : det2 A <> 0 -> forall i j, product (inverse2 A) A i j = unit_matrix i j.
Proof.
  unfold det2. intros H i j.
  revert i. apply all2; revert j; apply all2; unfold product, inverse2, adjugate2, det2; simpl;
    unit_entry; field; assumption.
Qed.

Lemma inverse2_right A : det2 A <> 0 -> forall i j, product A (inverse2 A) i j = unit_matrix i j.
Proof.
  unfold det2. intros H i j.
  revert i. apply all2; revert j; apply all2; unfold product, inverse2, adjugate2, det2; simpl;
    unit_entry; field; assumption.
Qed.

Lemma inverse3_left A : det3 A <> 0 -> forall i j, product (inverse3 A) A i j = unit_matrix i j.
Proof.
  unfold det3, minor. intros H i j.
  revert i. apply all3; revert j; apply all3; unfold product, inverse3, adjugate3, det3, minor; simpl;
    unit_entry; field; assumption.
Qed.

Lemma inverse3_right A : det3 A <> 0 -> forall i j, product A (inverse3 A) i j = unit_matrix i j.
Proof.
  unfold det3, minor. intros H i j.
  revert i. apply all3; revert j; apply all3; unfold product, inverse3, adjugate3, det3, minor; simpl;
    unit_entry; field; assumption.
Qed.

(* ------------------------------------------------------------------ continuous and rational *)
Lemma continuous_opp {d} a b (g : R -> point d -> R) :
  continuous_in a b g -> continuous_in a b (fun t x => - g t x).
Proof.
  intros H. apply continuous_same with (fun t x => -1 * g t x); [intros; ring|].
  apply continuous_mult; [apply continuous_const|assumption].
Qed.

Ltac continuous := repeat first
  [ assumption | apply continuous_plus | apply continuous_minus | apply continuous_opp
  | apply continuous_mult | match goal with H : _ |- _ => apply H end ].
Ltac rational := repeat first
  [ assumption | apply rational_plus | apply rational_minus | apply rational_opp
  | apply rational_mult | match goal with H : _ |- _ => apply H end ].

Section Entries.
Context (a b : R).

Lemma inverse2_continuous (A : R -> matrix 2) :
  (forall i j, continuous_in (d := 2) a b (fun t _ => A t i j)) ->
  (forall t, a <= t <= b -> det2 (A t) <> 0) ->
  forall i j, continuous_in (d := 2) a b (fun t _ => inverse2 (A t) i j).
Proof.
  intros HA Hdet i j. unfold inverse2.
  apply (continuous_mult a b (fun t _ => adjugate2 (A t) i j)).
  - revert i. apply all2; revert j; apply all2; unfold adjugate2; simpl; continuous.
  - apply (continuous_inv a b (fun t _ => det2 (A t))); [|intros t _; apply Hdet].
    unfold det2. continuous.
Qed.

Lemma inverse3_continuous (A : R -> matrix 3) :
  (forall i j, continuous_in (d := 3) a b (fun t _ => A t i j)) ->
  (forall t, a <= t <= b -> det3 (A t) <> 0) ->
  forall i j, continuous_in (d := 3) a b (fun t _ => inverse3 (A t) i j).
Proof.
  intros HA Hdet i j. unfold inverse3.
  apply (continuous_mult a b (fun t _ => adjugate3 (A t) i j)).
  - revert i. apply all3; revert j; apply all3; unfold adjugate3, minor; simpl; continuous.
  - apply (continuous_inv a b (fun t _ => det3 (A t))); [|intros t _; apply Hdet].
    unfold det3, minor. continuous.
Qed.

Lemma inverse2_rational (A : R -> matrix 2) :
  (forall i j, rational (fun t => A t i j) a b) ->
  (forall t, a <= t <= b -> det2 (A t) <> 0) ->
  forall i j, rational (fun t => inverse2 (A t) i j) a b.
Proof.
  intros HA Hdet i j. unfold inverse2.
  apply (rational_mult (fun t => adjugate2 (A t) i j)).
  - revert i. apply all2; revert j; apply all2; unfold adjugate2; simpl; rational.
  - apply (rational_inv (fun t => det2 (A t))); [assumption|]. unfold det2. rational.
Qed.

Lemma inverse3_rational (A : R -> matrix 3) :
  (forall i j, rational (fun t => A t i j) a b) ->
  (forall t, a <= t <= b -> det3 (A t) <> 0) ->
  forall i j, rational (fun t => inverse3 (A t) i j) a b.
Proof.
  intros HA Hdet i j. unfold inverse3.
  apply (rational_mult (fun t => adjugate3 (A t) i j)).
  - revert i. apply all3; revert j; apply all3; unfold adjugate3, minor; simpl; rational.
  - apply (rational_inv (fun t => det3 (A t))); [assumption|]. unfold det3, minor. rational.
Qed.

End Entries.

(* ------------------------------------------------------------------ motions *)
Section Motions.
Context {a b : R} (Hab : a <= b).

Definition plane_motion (A : R -> matrix 2) (s : R -> point 2)
  (HA : forall i j, continuous_in (d := 2) a b (fun t _ => A t i j))
  (Hs : forall i, continuous_in (d := 2) a b (fun t _ => s t i))
  (Hdet : forall t, a <= t <= b -> det2 (A t) <> 0) : affine 2 a b :=
  {| in_order := Hab; linear := A; inverse_linear := fun t => inverse2 (A t); shift := s;
     left_inverse := fun t Ht => inverse2_left (A t) (Hdet t Ht);
     right_inverse := fun t Ht => inverse2_right (A t) (Hdet t Ht);
     linear_continuous := HA; inverse_continuous := inverse2_continuous a b A HA Hdet;
     shift_continuous := Hs |}.

Definition space_motion (A : R -> matrix 3) (s : R -> point 3)
  (HA : forall i j, continuous_in (d := 3) a b (fun t _ => A t i j))
  (Hs : forall i, continuous_in (d := 3) a b (fun t _ => s t i))
  (Hdet : forall t, a <= t <= b -> det3 (A t) <> 0) : affine 3 a b :=
  {| in_order := Hab; linear := A; inverse_linear := fun t => inverse3 (A t); shift := s;
     left_inverse := fun t Ht => inverse3_left (A t) (Hdet t Ht);
     right_inverse := fun t Ht => inverse3_right (A t) (Hdet t Ht);
     linear_continuous := HA; inverse_continuous := inverse3_continuous a b A HA Hdet;
     shift_continuous := Hs |}.

(* Entries rational on a piece. *)
Definition entries_rational {d} (A : R -> matrix d) (s : R -> point d) (u v : R) : Prop :=
  (forall i j, rational (fun t => A t i j) u v) /\ (forall i, rational (fun t => s t i) u v).

End Motions.

Lemma chain_inside (G : R -> R -> Prop) a b : chain G a b ->
  chain (fun u v => G u v /\ a <= u /\ v <= b) a b.
Proof.
  induction 1 as [|a b c Hab HG Hc IH]; [apply chain_end|].
  pose proof (chain_order _ _ _ Hc). apply chain_gap with b; [assumption|repeat split; try assumption; lra|].
  revert IH. apply chain_refine. intros u v Huv (K & Ku & Kv). apply chain_gap with v; [assumption| |apply chain_end].
  repeat split; try assumption; lra.
Qed.

Theorem classified_plane a b (Hab : a <= b) A s HA Hs Hdet (S : set 2) fs P :
  regular_closed S -> polyhedral S fs -> chain (entries_rational A s) a b ->
  let M := affine_motion (plane_motion Hab A s HA Hs Hdet) in
  exists w, is_word (trace_of M S P) a b w /\
    (forall v, is_word (trace_of M S P) a b v -> v = w) /\ admissible w /\
    forall f, let answer := pmc_of (class_of_word f w) in
      (answer = in_ <-> open_sweep M S P) /\
      (answer = on <-> boundary (open_sweep M S) P) /\
      (answer = out <-> ~ sweep M S P).
Proof.
  intros HS Hfs Hc. cbv zeta. apply (classified (plane_motion Hab A s HA Hs Hdet) S fs P HS Hfs).
  apply chain_inside in Hc. revert Hc. apply chain_refine. intros u v Huv ((Ha & Hb) & Hu & Hv).
  apply chain_gap with v; [assumption| |apply chain_end]. split; [|exact Hb].
  apply inverse2_rational; [exact Ha|]. intros t Ht. apply Hdet. lra.
Qed.

Theorem classified_space a b (Hab : a <= b) A s HA Hs Hdet (S : set 3) fs P :
  regular_closed S -> polyhedral S fs -> chain (entries_rational A s) a b ->
  let M := affine_motion (space_motion Hab A s HA Hs Hdet) in
  exists w, is_word (trace_of M S P) a b w /\
    (forall v, is_word (trace_of M S P) a b v -> v = w) /\ admissible w /\
    forall f, let answer := pmc_of (class_of_word f w) in
      (answer = in_ <-> open_sweep M S P) /\
      (answer = on <-> boundary (open_sweep M S) P) /\
      (answer = out <-> ~ sweep M S P).
Proof.
  intros HS Hfs Hc. cbv zeta. apply (classified (space_motion Hab A s HA Hs Hdet) S fs P HS Hfs).
  apply chain_inside in Hc. revert Hc. apply chain_refine. intros u v Huv ((Ha & Hb) & Hu & Hv).
  apply chain_gap with v; [assumption| |apply chain_end]. split; [|exact Hb].
  apply inverse3_rational; [exact Ha|]. intros t Ht. apply Hdet. lra.
Qed.
