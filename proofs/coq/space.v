(* E^d, open sets, and the state of a point against a set.
   SPDX-License-Identifier: GPL-3.0-or-later

   [point d], [near], [interior], [closure], [boundary], [open_set]  the usual topology, by boxes
   [regular_closed]  S = cl iS
   [state_at]        I, B or O: in iS, on the boundary, in the complement's interior
   [state_total], [state_functional]  each point has one state
   [uniform_on_interval]  what holds near each time with some margin holds with one margin *)
Require Import Reals Lra Classical.
Require Fin.
Require Import Graze.words.
Open Scope R_scope.

Definition point (d : nat) := Fin.t d -> R.
Definition set (d : nat) := point d -> Prop.

Section Space.
Context {d : nat}.

Definition near (x : point d) (e : R) (y : point d) : Prop := forall i, Rabs (y i - x i) < e.

Definition complement (A : set d) : set d := fun x => ~ A x.
Definition interior (A : set d) : set d := fun x => exists e, e > 0 /\ forall y, near x e y -> A y.
Definition closure (A : set d) : set d := fun x => forall e, e > 0 -> exists y, near x e y /\ A y.
Definition boundary (A : set d) : set d := fun x => closure A x /\ ~ interior A x.
Definition open_set (A : set d) : Prop := forall x, A x -> interior A x.
Definition closed_set (A : set d) : Prop := open_set (complement A).
Definition same (A A' : set d) : Prop := forall x, A x <-> A' x.
Definition regular_closed (A : set d) : Prop := same A (closure (interior A)).

Definition state_at (A : set d) (x : point d) (s : state) : Prop :=
  match s with
  | I => interior A x
  | O => interior (complement A) x
  | B => ~ interior A x /\ ~ interior (complement A) x
  end.

(* ------------------------------------------------------------------ facts *)
Implicit Types (A : set d) (x y z : point d) (e f : R).

Lemma near_self x e : e > 0 -> near x e x.
Proof. intros He i. replace (x i - x i) with 0 by ring. rewrite Rabs_R0. assumption. Qed.

Lemma near_less x e f y : near x e y -> e <= f -> near x f y.
Proof. intros H Hef i. specialize (H i). lra. Qed.

Lemma near_sym x e y : near x e y -> near y e x.
Proof. intros H i. rewrite Rabs_minus_sym. apply H. Qed.

Lemma near_trans x y z e f : near x e y -> near y f z -> near x (e + f) z.
Proof.
  intros H K i. specialize (H i). specialize (K i).
  replace (z i - x i) with ((z i - y i) + (y i - x i)) by ring.
  eapply Rle_lt_trans; [apply Rabs_triang|]. lra.
Qed.

Lemma interior_in A x : interior A x -> A x.
Proof. intros (e & He & H). apply H, near_self, He. Qed.

Lemma interior_mono A A' : (forall x, A x -> A' x) -> forall x, interior A x -> interior A' x.
Proof. intros H x (e & He & K). exists e. auto. Qed.

Lemma closure_mono A A' : (forall x, A x -> A' x) -> forall x, closure A x -> closure A' x.
Proof. intros H x K e He. destruct (K e He) as (y & Hy & Ha). eauto. Qed.

Lemma closure_in A x : A x -> closure A x.
Proof. intros H e He. exists x. split; [apply near_self, He|assumption]. Qed.

Lemma interior_open A : open_set (interior A).
Proof.
  intros x (e & He & H). exists (e / 2). split; [lra|]. intros y Hy.
  exists (e / 2). split; [lra|]. intros z Hz. apply H.
  replace e with (e / 2 + e / 2) by field. eapply near_trans; eassumption.
Qed.

Lemma closure_not_outside A x : closure A x <-> ~ interior (complement A) x.
Proof.
  split.
  - intros H (e & He & K). destruct (H e He) as (y & Hy & Ha). exact (K y Hy Ha).
  - intros H e He. apply NNPP. intros K. apply H. exists e. split; [assumption|].
    intros y Hy Ha. apply K. eauto.
Qed.

Lemma closure_closed A : closed_set (closure A).
Proof.
  intros x Hx. unfold complement in Hx. rewrite closure_not_outside in Hx. apply NNPP in Hx.
  apply interior_open in Hx. revert x Hx. apply interior_mono. intros y Hy.
  unfold complement. rewrite closure_not_outside. tauto.
Qed.

Lemma regular_closed_closed A : regular_closed A -> closed_set A.
Proof.
  intros H x Hx. assert (complement (closure (interior A)) x) as K by (intros K; apply Hx, H, K).
  apply closure_closed in K. revert K. apply interior_mono. intros y Hy Ha. apply Hy, H, Ha.
Qed.

Lemma state_functional A x s s' : state_at A x s -> state_at A x s' -> s = s'.
Proof.
  destruct s, s'; simpl; intros H K; try reflexivity; exfalso; try tauto.
  - exact (interior_in _ _ K (interior_in _ _ H)).
  - exact (interior_in _ _ H (interior_in _ _ K)).
Qed.

Lemma state_total A x : exists s, state_at A x s.
Proof.
  destruct (classic (interior A x)) as [H|H]; [exists I; exact H|].
  destruct (classic (interior (complement A) x)) as [K|K]; [exists O; exact K|].
  exists B. split; assumption.
Qed.

(* Of a closed set O is the complement, and B the boundary. *)
Lemma state_O_closed A x : closed_set A -> (state_at A x O <-> ~ A x).
Proof. intros H. split; [apply interior_in|apply H]. Qed.

Lemma state_B_closed A x : closed_set A -> (state_at A x B <-> boundary A x).
Proof. intros _. unfold state_at, boundary. rewrite closure_not_outside. tauto. Qed.

Lemma in_closed A x : closed_set A -> (A x <-> state_at A x I \/ state_at A x B).
Proof.
  intros H. pose proof (state_O_closed A x H) as Ho. destruct (state_total A x) as [s Hs].
  split.
  - intros Ha. destruct s; auto. apply Ho in Hs. contradiction.
  - intros [K|[K L]]; [apply interior_in, K|]. apply NNPP. intros N. apply L, Ho, N.
Qed.

End Space.

(* ------------------------------------------------------------------ an interval is compact *)
Lemma uniform_on_interval (a b : R) (Q : R -> R -> Prop) :
  a <= b ->
  (forall e f t, Q e t -> f <= e -> Q f t) ->
  (forall t, a <= t <= b -> exists e, e > 0 /\ forall u, a <= u <= b -> Rabs (u - t) < e -> Q e u) ->
  exists e, e > 0 /\ forall u, a <= u <= b -> Q e u.
Proof.
  intros Hab Hless Hnear.
  set (E := fun s => a <= s <= b /\ exists e, e > 0 /\ forall u, a <= u <= s -> Q e u).
  destruct (completeness E) as [T [HT1 HT2]].
  - exists b. intros s [Hs _]. lra.
  - exists a. split; [lra|]. destruct (Hnear a ltac:(lra)) as (e & He & H). exists e.
    split; [assumption|]. intros u Hu. apply H; [lra|]. replace (u - a) with 0 by lra.
    rewrite Rabs_R0. lra.
  - assert (E a) as Ea.
    { split; [lra|]. destruct (Hnear a ltac:(lra)) as (e & He & H). exists e.
      split; [assumption|]. intros u Hu. apply H; [lra|]. replace (u - a) with 0 by lra.
      rewrite Rabs_R0. lra. }
    assert (a <= T <= b) as HT by (split; [apply HT1, Ea|apply HT2; intros s [Hs _]; lra]).
    destruct (Hnear T HT) as (e & He & H).
    assert (exists s, E s /\ T - e < s) as (s & [Hs (f & Hf & K)] & Hsl).
    { apply NNPP. intros N. assert (T <= T - e) as L; [|lra]. apply HT2. intros s Hs.
      destruct (Rle_lt_dec s (T - e)); [assumption|]. exfalso. eauto. }
    set (v := Rmin b (T + e / 2)).
    assert (v <= b /\ v <= T + e / 2 /\ (v = b \/ v = T + e / 2)) as (V1 & V2 & V3)
      by (unfold v, Rmin; destruct Rle_dec; lra).
    assert (E v) as Ev.
    { split; [destruct V3; lra|]. exists (Rmin e f). split; [apply Rmin_pos; assumption|].
      intros u Hu. destruct (Rle_lt_dec u s) as [Hus|Hus].
      - apply Hless with f; [apply K; lra|apply Rmin_r].
      - apply Hless with e; [|apply Rmin_l]. apply H; [lra|].
        apply Rabs_def1; lra. }
    pose proof (HT1 v Ev). destruct V3 as [->|V3]; [|lra].
    destruct Ev as [_ (g & Hg & L)]. exists g. split; [assumption|]. intros u Hu. apply L. lra.
Qed.
