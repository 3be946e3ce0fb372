(* The theorem of the checker is not empty: a square is a legal solid, and a certificate is accepted.
   SPDX-License-Identifier: GPL-3.0-or-later

   [square_legal]     the square [0, 2] x [0, 2] with its four sides
   [square_accepted]  the certificate of the point (5, 1) under the translation by (8t, 0): OBIBO
   [square_swept]     so that point is in the open sweep *)
Require Import Reals Lra List ZArith.
Require Fin.
Require Import Graze.words Graze.definitions Graze.space Graze.sweep Graze.affine Graze.cramer Graze.box
  Graze.facets Graze.sample Graze.interval Graze.row Graze.simplices Graze.motions Graze.checker.
Import ListNotations.
Open Scope R_scope.

Definition square : list simplex := [[[0; 0]; [2; 0]]; [[2; 0]; [2; 2]]; [[2; 2]; [0; 2]]; [[0; 2]; [0; 0]]]%Z.
Definition facet_at (s : simplex) : facet :=
  {| plane := outward 1 s; sides := sides_of 1 s; bounds := bounds_of 1 2 s |}.

Lemma square_facets s : In s square -> facet_ok 1 2 s (facet_at s) = true.
Proof. intros [<-|[<-|[<-|[<-|[]]]]]; vm_compute; reflexivity. Qed.

(* Which points the sides hold. *)
Definition between (low x high : R) (strictly : bool) : Prop := if strictly then low < x < high else low <= x <= high.
Definition side_holds (k : nat) (x : point 2) (strictly : bool) : Prop :=
  match k with
  | 0%nat => x i1 = 0 /\ between 0 (x i0) 2 strictly
  | 1%nat => x i0 = 2 /\ between 0 (x i1) 2 strictly
  | 2%nat => x i1 = 2 /\ between 0 (x i0) 2 strictly
  | _ => x i0 = 0 /\ between 0 (x i1) 2 strictly
  end.

Ltac values :=
  repeat match goal with
  | |- context [facet_at ?s] => let f := eval vm_compute in (facet_at s) in change (facet_at s) with f
  | |- context [outward 1 ?s] => let f := eval vm_compute in (outward 1 s) in change (outward 1 s) with f
  end;
  unfold on, facets.inner, zvalue; cbn [plane sides hd tl dot In].

Lemma side_hull k s x : nth_error square k = Some s -> (in_hull 1 s x <-> side_holds k x false).
Proof.
  intros Hs. rewrite <- (facet_on 1 s (facet_at s)) by (apply square_facets; eapply nth_error_In; exact Hs).
  destruct k as [|[|[|[|[|k]]]]]; simpl in Hs; try discriminate; inversion Hs; subst s; values;
    unfold side_holds, between; (split; [intros [H0 H]|intros [H0 H]; split; [lra|intros g [<-|[<-|[]]]; cbn; lra]]);
    pose proof (H _ (or_introl eq_refl)) as H1; pose proof (H _ (or_intror (or_introl eq_refl))) as H2; cbn in H1, H2; lra.
Qed.
Lemma side_interior k s x : nth_error square k = Some s -> (in_relative_interior 1 s x <-> side_holds k x true).
Proof.
  intros Hs. rewrite <- (facet_inner 1 s (facet_at s)) by (apply square_facets; eapply nth_error_In; exact Hs).
  destruct k as [|[|[|[|[|k]]]]]; simpl in Hs; try discriminate; inversion Hs; subst s; values;
    unfold side_holds, between; (split; [intros [H0 H]|intros [H0 H]; split; [lra|intros g [<-|[<-|[]]]; cbn; lra]]);
    pose proof (H _ (or_introl eq_refl)) as H1; pose proof (H _ (or_intror (or_introl eq_refl))) as H2; cbn in H1, H2; lra.
Qed.

Lemma square_boundary x : boundary (box 2 2) x <-> exists s, In s square /\ in_hull 1 s x.
Proof.
  pose proof (regular_closed_closed _ (box_regular 2 2 ltac:(lra))) as HC.
  assert (boundary (box 2 2) x <-> box 2 2 x /\ ~ box.inner 2 2 x) as ->.
  { unfold boundary. rewrite box_interior. split; intros [H K]; (split; [|exact K]); [|apply closure_in, H].
    apply Classical_Prop.NNPP. intros N. apply HC in N. apply (proj1 (closure_not_outside _ _) H), N. }
  split.
  - intros [H K]. pose proof (H i0) as H0. pose proof (H i1) as H1.
    assert (exists k, (k < 4)%nat /\ side_holds k x false) as (k & Hk & Hs).
    { destruct (Rlt_dec 0 (x i1)); [|exists 0%nat; simpl; split; [repeat constructor|lra]].
      destruct (Rlt_dec (x i0) 2); [|exists 1%nat; simpl; split; [repeat constructor|lra]].
      destruct (Rlt_dec (x i1) 2); [|exists 2%nat; simpl; split; [repeat constructor|lra]].
      destruct (Rlt_dec 0 (x i0)); [|exists 3%nat; simpl; split; [repeat constructor|lra]].
      exfalso. exact (K (all2 (fun i => 0 < x i < 2) (conj r2 r0) (conj r r1))). }
    destruct (nth_error square k) as [s|] eqn:E.
    + exists s. split; [eapply nth_error_In; exact E|]. apply (side_hull k s x E), Hs.
    + apply nth_error_None in E. simpl in E. exfalso. apply (PeanoNat.Nat.lt_irrefl 4). eapply PeanoNat.Nat.le_lt_trans; eassumption.
  - intros (s & Hs & Hh). apply In_nth_error in Hs. destruct Hs as [k Hs].
    apply (side_hull k s x Hs) in Hh.
    assert (~ (0 < x i0 < 2 /\ 0 < x i1 < 2) /\ 0 <= x i0 <= 2 /\ 0 <= x i1 <= 2) as (K & H0 & H1).
    { destruct k as [|[|[|[|k]]]]; unfold side_holds, between in Hh; try lra. }
    split; [exact (all2 (fun i => 0 <= x i <= 2) H0 H1)|]. intros N. apply K. split; apply N.
Qed.

Lemma square_sides before s after x : square = before ++ s :: after -> in_relative_interior 1 s x ->
  exists e, e > 0 /\ forall y, near x e y ->
    (zvalue (outward 1 s) y < 0 -> interior (box 2 2) y) /\
    (0 < zvalue (outward 1 s) y -> interior (complement (box 2 2)) y).
Proof.
  intros E Hx.
  assert (exists k, nth_error square k = Some s) as [k Hk].
  { apply In_nth_error. rewrite E. apply in_or_app. right. left. reflexivity. }
  apply (side_interior k s x Hk) in Hx.
  pose proof (regular_closed_closed _ (box_regular 2 2 ltac:(lra))) as HC.
  set (m := match k with 0%nat | 2%nat => x i0 | _ => x i1 end).
  assert (0 < m < 2) as Hm by (destruct k as [|[|[|[|k]]]]; unfold side_holds, between in Hx; unfold m; lra).
  exists (Rmin 1 (Rmin m (2 - m))). split; [repeat apply Rmin_pos; lra|]. intros y Hy.
  pose proof (Rmin_l 1 (Rmin m (2 - m))). pose proof (Rmin_r 1 (Rmin m (2 - m))).
  pose proof (Rmin_l m (2 - m)). pose proof (Rmin_r m (2 - m)).
  pose proof (Rabs_def2 _ _ (Hy i0)) as [Y1 Y2]. pose proof (Rabs_def2 _ _ (Hy i1)) as [Y3 Y4].
  destruct k as [|[|[|[|[|k]]]]]; simpl in Hk; try discriminate; inversion Hk; subst s;
    unfold side_holds, between in Hx; unfold m in *; values;
    (split; intros Hv;
      [apply box_interior; refine (all2 (fun i => 0 < y i < 2) _ _); split; lra|apply HC; intros N; pose proof (N i0); pose proof (N i1); lra]).
Qed.

Theorem square_legal : legal_solid 1 square (box 2 2).
Proof.
  split.
  - apply box_regular. lra.
  - assert (forall j k s u (x : point 2), nth_error square j = Some s -> nth_error square k = Some u -> j <> k ->
      ~ (in_relative_interior 1 s x /\ in_relative_interior 1 u x)) as K.
    { intros j k s u x Hj Hk Hjk [K1 K2]. apply (side_interior j s x Hj) in K1. apply (side_interior k u x Hk) in K2.
      destruct j as [|[|[|[|j]]]], k as [|[|[|[|k]]]]; try (apply Hjk; reflexivity); simpl in Hj, Hk;
        try (destruct j; discriminate); try (destruct k; discriminate); unfold side_holds, between in *; lra. }
    repeat (constructor; [repeat (constructor; [intros x; first
      [exact (K 0 1 _ _ x eq_refl eq_refl ltac:(discriminate))%nat|exact (K 0 2 _ _ x eq_refl eq_refl ltac:(discriminate))%nat
      |exact (K 0 3 _ _ x eq_refl eq_refl ltac:(discriminate))%nat|exact (K 1 2 _ _ x eq_refl eq_refl ltac:(discriminate))%nat
      |exact (K 1 3 _ _ x eq_refl eq_refl ltac:(discriminate))%nat|exact (K 2 3 _ _ x eq_refl eq_refl ltac:(discriminate))%nat]|])|]);
      constructor.
  - apply square_boundary.
  - exists 2. intros x Hx i. specialize (Hx i). rewrite Rabs_right; lra.
  - intros before s after x E Hx _. exact (square_sides before s after x E Hx).
Qed.

(* ------------------------------------------------------------------ a certificate *)
Definition slide : piece :=
  {| begins := (0, 1); finishes := (1, 1);
     forward := [[[0; 8]; [1]; []]; [[]; []; [1]]]; forward_weight := [1];
     backward := [[[0; -8]; [1]; []]; [[]; []; [1]]]; backward_weight := [1] |}%Z.
Definition square_row : row :=
  {| word_of := [O; B; I; B; O]; pmc := in_; class_claimed := regular; definition := 5; position := 1;
     crosses := 2; tangent := 0; inner_count := 1;
     intervals := [(stays O, (1, 4), []); (meets (Some O) (Some I), (1, 2), [-3; 8]);
                   (meets (Some I) (Some O), (3, 4), [-5; 8]); (stays O, (1, 1), [])]%Z |}.

Theorem square_accepted :
  check sweeping separate 2 1 square [slide] [(0, 1); (1, 1)]%Z [1; 5; 1]%Z square_row = true.
Proof. vm_compute. reflexivity. Qed.

Theorem square_swept : exists M : motion 2 (instant (0, 1)%Z) (instant (1, 1)%Z),
  given_by [slide] M /\ open_sweep M (box 2 2) (point_of [1; 5; 1]%Z).
Proof.
  destruct (sweep_checked_plane separate 1 square [slide] [(0, 1); (1, 1)]%Z [1; 5; 1]%Z square_row (box 2 2)
    square_accepted square_legal) as [[M HM] K].
  exists M. split; [exact HM|]. destruct (K M HM) as (_ & _ & _ & _ & _ & _ & _ & _ & _ & H & _).
  apply H. reflexivity.
Qed.
