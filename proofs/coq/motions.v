(* Piecewise rational motions: the test that one is legal, and that a legal one is a motion (claim K6).
   SPDX-License-Identifier: GPL-3.0-or-later

   [check_motion]   pieces in order that agree where they meet, denominator and determinant of one strict
                    sign each between neighbours of the given times
   [legal_motion]   over the reals: no pole, no zero of the determinant, no jump
   [motion_legal]   the first implies the second
   [motion_exists]  a legal motion of the plane or of space is a motion over the reals *)
Require Import Reals Lra Lia List ZArith Bool.
Require Fin.
Require Import Graze.space Graze.sweep Graze.polynomials Graze.finite Graze.affine Graze.cramer Graze.bernstein
  Graze.sample Graze.interval Graze.interval_sound Graze.row.
Import ListNotations.
Open Scope R_scope.

(* ------------------------------------------------------------------ the test *)
Definition det_poly (d : nat) (m : list (list (list Z))) : list Z :=
  let e i j := entry m i (S j) in
  let minor i j k l := minus (zmul (e i k) (e j l)) (zmul (e i l) (e j k)) in
  match d with
  | 2%nat => minor 0 1 0 1
  | 3%nat => zadd (minus (zmul (e 0 0) (minor 1 2 1 2)) (zmul (e 0 1) (minor 1 2 0 2))) (zmul (e 0 2) (minor 1 2 0 1))
  | _ => []
  end%nat.

Definition before_strictly (t u : time) : bool := Z.ltb (fst t * snd u) (fst u * snd t).
(* p has one strict sign on [t, u]. *)
Definition sign_on (t u : time) (p : list Z) : bool :=
  let q := trim p in
  let n := pred (length q) in
  let l := (fst t * snd u)%Z in
  let h := (fst u * snd t)%Z in
  let d := (snd t * snd u)%Z in
  before_strictly t u && negb (Z.eqb (strict n (bern l h d n q)) 0).
Fixpoint signs_along (d : nat) (p : piece) (t : time) (ts : list time) : bool :=
  match ts with
  | [] => same_time t (finishes p)
  | u :: rest =>
      time_ok u && sign_on t u (forward_weight p) && sign_on t u (det_poly d (forward p)) && signs_along d p u rest
  end.
Definition in_piece (p : piece) (t : time) : bool := not_after (begins p) t && not_after t (finishes p).
Definition piece_ok (d : nat) (signs : list time) (p : piece) : bool :=
  time_ok (begins p) && time_ok (finishes p)
  && match filter (in_piece p) signs with
     | [] => false
     | t :: ts => time_ok t && same_time t (begins p) && signs_along d p t ts
     end.
Definition agree_at (p q : piece) (t : time) (i j : nat) : bool :=
  let r := minus (zmul (entry (forward p) i j) (forward_weight q)) (zmul (entry (forward q) i j) (forward_weight p)) in
  Z.eqb (value_at r (pred (length r)) (fst t) (snd t)) 0.
Fixpoint joined (d : nat) (ps : list piece) : bool :=
  match ps with
  | [] => false
  | p :: rest =>
      before_strictly (begins p) (finishes p)
      && match rest with
         | [] => true
         | q :: _ =>
             same_time (finishes p) (begins q)
             && forallb (fun i => forallb (agree_at p q (finishes p) i) (seq 0 (S d))) (seq 0 d)
             && joined d rest
         end
  end.
Fixpoint ascending (ts : list time) : bool :=
  match ts with t :: ((u :: _) as rest) => before_strictly t u && ascending rest | _ => true end.
Definition check_motion (d : nat) (ps : list piece) (signs : list time) : bool :=
  joined d ps && forallb (piece_ok d signs) ps
  && ascending signs
  && forallb (fun t => time_ok t && not_after (first_time ps) t && not_after t (last_time ps)) signs.

(* ------------------------------------------------------------------ what a legal motion is *)
Definition value_of (p : piece) (i j : nat) (t : R) : R := ev (entry (forward p) i j) t / ev (forward_weight p) t.
Definition span (p : piece) (t : R) : Prop := instant (begins p) <= t <= instant (finishes p).

Fixpoint chained (d : nat) (ps : list piece) : Prop :=
  match ps with
  | [] => False
  | p :: rest =>
      instant (begins p) < instant (finishes p) /\
      match rest with
      | [] => True
      | q :: _ =>
          instant (finishes p) = instant (begins q) /\
          (forall i j, (i < d)%nat -> (j <= d)%nat ->
            value_of p i j (instant (finishes p)) = value_of q i j (instant (finishes p))) /\
          chained d rest
      end
  end.
Definition legal_motion (d : nat) (ps : list piece) : Prop :=
  chained d ps /\
  forall p t, In p ps -> span p t -> ev (forward_weight p) t <> 0 /\ ev (det_poly d (forward p)) t <> 0.

(* ------------------------------------------------------------------ the test is right *)
Lemma before_instant t u : time_ok t = true -> time_ok u = true -> before_strictly t u = true -> instant t < instant u.
Proof.
  unfold time_ok, before_strictly, instant. intros Ht Hu H. apply Z.ltb_lt, IZR_lt in Ht. apply Z.ltb_lt, IZR_lt in Hu.
  apply Z.ltb_lt, IZR_lt in H. rewrite !mult_IZR in H.
  apply Rmult_lt_reg_r with (IZR (snd t) * IZR (snd u)); [apply Rmult_lt_0_compat; assumption|].
  replace (IZR (fst t) / IZR (snd t) * (IZR (snd t) * IZR (snd u))) with (IZR (fst t) * IZR (snd u)) by (field; lra).
  replace (IZR (fst u) / IZR (snd u) * (IZR (snd t) * IZR (snd u))) with (IZR (fst u) * IZR (snd t)) by (field; lra).
  assumption.
Qed.
Lemma same_time_instant t u : time_ok t = true -> time_ok u = true -> same_time t u = true -> instant t = instant u.
Proof.
  intros Ht Hu H. apply same_instant; [apply Z.ltb_lt, Ht|assumption|]. apply Z.eqb_eq, H.
Qed.

Lemma sign_on_value t u p : time_ok t = true -> time_ok u = true -> sign_on t u p = true ->
  instant t < instant u /\ forall w, instant t <= w <= instant u -> ev p w <> 0.
Proof.
  intros Ht Hu H. unfold sign_on in H. apply andb_prop in H. destruct H as [Hb H].
  split; [apply before_instant; assumption|]. intros w Hw.
  apply negb_true_iff, Z.eqb_neq in H. unfold time_ok in Ht, Hu. apply Z.ltb_lt in Ht, Hu.
  set (l := (fst t * snd u)%Z) in *. set (h := (fst u * snd t)%Z) in *. set (d := (snd t * snd u)%Z) in *.
  assert (0 < d)%Z as Hd by (unfold d; lia). assert (l < h)%Z as Hlh by (apply Z.ltb_lt, Hb).
  pose proof (strict_sign l h d Hd Hlh (pred (length (trim p))) (trim p) w ltac:(lia) H) as K.
  rewrite ev_trim in K.
  assert (within l h d w) as Hin.
  { unfold within, l, h, d, instant in *. rewrite !mult_IZR. apply IZR_lt in Ht, Hu.
    assert (IZR (fst t) = IZR (snd t) * (IZR (fst t) / IZR (snd t))) as E1 by (field; lra).
    assert (IZR (fst u) = IZR (snd u) * (IZR (fst u) / IZR (snd u))) as E2 by (field; lra).
    assert (0 < IZR (snd t) * IZR (snd u)) by (apply Rmult_lt_0_compat; assumption). split.
    - rewrite E1 at 1. replace (IZR (snd t) * (IZR (fst t) / IZR (snd t)) * IZR (snd u))
        with (IZR (snd t) * IZR (snd u) * (IZR (fst t) / IZR (snd t))) by ring. apply Rmult_le_compat_l; lra.
    - rewrite E2 at 1. replace (IZR (snd u) * (IZR (fst u) / IZR (snd u)) * IZR (snd t))
        with (IZR (snd t) * IZR (snd u) * (IZR (fst u) / IZR (snd u))) by ring. apply Rmult_le_compat_l; lra. }
  specialize (K Hin). destruct (strict _ _); simpl in K; [congruence|lra|lra].
Qed.

Lemma signs_along_value d p ts : forall t, time_ok t = true -> time_ok (finishes p) = true ->
  signs_along d p t ts = true -> instant t < instant (finishes p) \/ ts = [] ->
  forall w, instant t <= w <= instant (finishes p) -> ts <> [] ->
  ev (forward_weight p) w <> 0 /\ ev (det_poly d (forward p)) w <> 0.
Proof.
  induction ts as [|u ts IH]; intros t Ht Hf H Hlt w Hw Hne; [congruence|].
  simpl in H. apply andb_prop in H. destruct H as [H Hrest]. apply andb_prop in H. destruct H as [H H2].
  apply andb_prop in H. destruct H as [Hu H1].
  destruct (sign_on_value t u _ Ht Hu H1) as [Htu K1]. destruct (sign_on_value t u _ Ht Hu H2) as [_ K2].
  destruct (Rle_lt_dec w (instant u)) as [Hle|Hgt]; [split; [apply K1|apply K2]; lra|].
  destruct ts as [|x ts'].
  - simpl in Hrest. rewrite (same_time_instant u (finishes p) Hu Hf Hrest) in Hgt. lra.
  - apply (IH u Hu Hf Hrest); [left; lra|lra|discriminate].
Qed.

Lemma piece_ok_value d signs p : instant (begins p) < instant (finishes p) -> piece_ok d signs p = true ->
  forall t, span p t -> ev (forward_weight p) t <> 0 /\ ev (det_poly d (forward p)) t <> 0.
Proof.
  intros Hlt H t Ht. unfold piece_ok in H. apply andb_prop in H. destruct H as [H Hs].
  apply andb_prop in H. destruct H as [Hb Hf].
  destruct (filter (in_piece p) signs) as [|u ts]; [discriminate|].
  apply andb_prop in Hs. destruct Hs as [Hs Ha]. apply andb_prop in Hs. destruct Hs as [Hu He].
  pose proof (same_time_instant _ _ Hu Hb He) as E. unfold span in Ht. rewrite <- E in Ht, Hlt.
  apply (signs_along_value d p ts u Hu Hf Ha); [left; assumption|assumption|].
  intros ->. simpl in Ha. pose proof (same_time_instant _ _ Hu Hf Ha). lra.
Qed.

Lemma root_at r t : time_ok t = true -> Z.eqb (value_at r (pred (length r)) (fst t) (snd t)) 0 = true -> ev r (instant t) = 0.
Proof.
  intros Ht H. apply Z.eqb_eq in H. apply (f_equal IZR) in H. apply Z.ltb_lt, IZR_lt in Ht.
  rewrite value_at_heval, heval_affine in H by (try lia; assumption). unfold instant.
  apply Rmult_integral in H. destruct H as [H|H]; [|exact H].
  pose proof (pow_lt _ (pred (length r)) Ht). lra.
Qed.

Theorem motion_legal d ps signs : check_motion d ps signs = true -> legal_motion d ps.
Proof.
  intros H. unfold check_motion in H. apply andb_prop in H. destruct H as [H _].
  apply andb_prop in H. destruct H as [H _]. apply andb_prop in H. destruct H as [Hj Hp].
  assert (forall p, In p ps -> piece_ok d signs p = true) as Hok by (apply forallb_forall, Hp). clear Hp.
  assert (forall p, In p ps -> time_ok (begins p) = true /\ time_ok (finishes p) = true) as Htimes.
  { intros p Hin. specialize (Hok p Hin). unfold piece_ok in Hok. apply andb_prop in Hok. destruct Hok as [Hok _].
    apply andb_prop, Hok. }
  assert (forall p, In p ps -> instant (begins p) < instant (finishes p)) as Hlt.
  { clear Hok. induction ps as [|p rest IH]; [intros p []|].
    cbn [joined] in Hj. apply andb_prop in Hj. destruct Hj as [Hb Hrest].
    intros q [<-|Hq]; [apply before_instant; try assumption; apply (Htimes p (or_introl eq_refl))|].
    apply IH; try assumption; [|intros r Hr; apply Htimes; right; assumption].
    destruct rest as [|r rest]; [destruct Hq|]. apply andb_prop in Hrest. apply Hrest. }
  assert (forall p t, In p ps -> span p t -> ev (forward_weight p) t <> 0 /\ ev (det_poly d (forward p)) t <> 0) as Hno.
  { intros p t Hin. apply (piece_ok_value d signs p (Hlt p Hin) (Hok p Hin)). }
  split; [|exact Hno]. clear Hok. induction ps as [|p rest IH]; [discriminate|].
  cbn [joined] in Hj. apply andb_prop in Hj. destruct Hj as [Hb Hrest].
  split; [apply Hlt; left; reflexivity|]. destruct rest as [|q rest]; [exact Logic.I|].
  apply andb_prop in Hrest. destruct Hrest as [Hrest Hj]. apply andb_prop in Hrest. destruct Hrest as [Hs Ha].
  assert (In p (p :: q :: rest) /\ In q (p :: q :: rest)) as [Ip Iq] by (split; [left|right; left]; reflexivity).
  assert (instant (finishes p) = instant (begins q)) as E by (apply same_time_instant; try assumption; apply Htimes; assumption).
  split; [exact E|]. split.
  - intros i j Hi Hj'. rewrite forallb_forall in Ha. specialize (Ha i). rewrite in_seq in Ha.
    specialize (Ha ltac:(lia)). rewrite forallb_forall in Ha. specialize (Ha j). rewrite in_seq in Ha.
    specialize (Ha ltac:(lia)). apply root_at in Ha; [|apply Htimes; assumption].
    unfold minus in Ha. rewrite ev_zadd, ev_opp, !ev_zmul in Ha.
    destruct (Hno p (instant (finishes p)) Ip) as [N1 _]; [split; [left; apply Hlt; assumption|lra]|].
    destruct (Hno q (instant (finishes p)) Iq) as [N2 _]; [split; [lra|rewrite E; left; apply Hlt; assumption]|].
    unfold value_of. apply Rmult_eq_reg_r with (ev (forward_weight p) (instant (finishes p)) * ev (forward_weight q) (instant (finishes p)));
      [|apply Rmult_integral_contrapositive; auto]. field_simplify; [lra|assumption|assumption].
  - apply IH; try assumption; intros r Hr; [apply Htimes|apply Hlt|]; try (right; assumption).
    intros Hin Hsp. apply Hno; [right|]; assumption.
Qed.

Lemma chained_inside d ps : chained d ps -> instant (first_time ps) <= instant (last_time ps) /\
  forall p, In p ps -> instant (first_time ps) <= instant (begins p) /\ instant (finishes p) <= instant (last_time ps).
Proof.
  induction ps as [|p rest IH]; [intros []|]. intros [Hlt H]. destruct rest as [|q rest].
  - simpl. split; [lra|]. intros r [<-|[]]. lra.
  - destruct H as (E & _ & Hc). destruct (IH Hc) as [I1 I2].
    change (first_time (p :: q :: rest)) with (begins p). change (last_time (p :: q :: rest)) with (last_time (q :: rest)).
    change (first_time (q :: rest)) with (begins q) in *. pose proof (I2 q (or_introl eq_refl)).
    split; [lra|]. intros r [<-|Hr]; [lra|]. specialize (I2 r Hr). lra.
Qed.

(* ------------------------------------------------------------------ pieces joined are a motion *)
Section Glue.
Context {d : nat}.
Let continuous a b (f : R -> R) := continuous_in (d := d) a b (fun t _ => f t).

Lemma continuous_ev p a b : continuous a b (ev p).
Proof.
  intros t x Ht e He. destruct (eval_continuous (map IZR p) t e He) as (r & Hr & K). exists r. split; [assumption|].
  intros u y Hu Hut _. destruct (Req_dec t u) as [->|Hne].
  - replace (ev p u - ev p u) with 0 by ring. rewrite Rabs_R0. assumption.
  - apply (K u). split; [split; [exact Logic.I|assumption]|exact Hut].
Qed.

Lemma continuous_glued a b c f g : a <= b <= c -> continuous a b f -> continuous b c g -> f b = g b ->
  continuous a c (fun t => if Rle_dec t b then f t else g t).
Proof.
  intros Habc Hf Hg Hb t x Ht e He. destruct (Rtotal_order t b) as [Htb|[->|Htb]].
  - destruct (Hf t x ltac:(lra) e He) as (r & Hr & K). exists (Rmin r (b - t)). split; [apply Rmin_pos; lra|].
    intros u y Hu Hut _. pose proof (Rmin_l r (b - t)). pose proof (Rmin_r r (b - t)).
    assert (u < b) by (apply Rabs_def2 in Hut; lra).
    destruct (Rle_dec u b), (Rle_dec t b); try lra. apply (K u x); [lra|lra|]. apply near_self. assumption.
  - destruct (Hf b x ltac:(lra) e He) as (r & Hr & K), (Hg b x ltac:(lra) e He) as (r' & Hr' & K').
    exists (Rmin r r'). split; [apply Rmin_pos; assumption|]. intros u y Hu Hut _.
    pose proof (Rmin_l r r'). pose proof (Rmin_r r r'). destruct (Rle_dec b b); [|lra].
    destruct (Rle_dec u b).
    + apply (K u x); [lra|lra|]. apply near_self. assumption.
    + rewrite Hb. apply (K' u x); [lra|lra|]. apply near_self. assumption.
  - destruct (Hg t x ltac:(lra) e He) as (r & Hr & K). exists (Rmin r (t - b)). split; [apply Rmin_pos; lra|].
    intros u y Hu Hut _. pose proof (Rmin_l r (t - b)). pose proof (Rmin_r r (t - b)).
    assert (b < u) by (apply Rabs_def2 in Hut; lra).
    destruct (Rle_dec u b), (Rle_dec t b); try lra. apply (K u x); [lra|lra|]. apply near_self. assumption.
Qed.

Fixpoint glued (ps : list piece) (i j : nat) (t : R) : R :=
  match ps with
  | [] => 0
  | [p] => value_of p i j t
  | p :: rest => if Rle_dec t (instant (finishes p)) then value_of p i j t else glued rest i j t
  end.

Variables (n : nat) (ps : list piece).
Hypothesis HL : legal_motion n ps.

Lemma glued_value qs : chained n qs -> forall p t i j, (i < n)%nat -> (j <= n)%nat ->
  In p qs -> span p t -> glued qs i j t = value_of p i j t.
Proof.
  induction qs as [|q rest IH]; intros Hc p t i j Hi Hj Hp Ht; [destruct Hp|].
  destruct Hc as [Hlt Hc]. destruct rest as [|r rest].
  - destruct Hp as [<-|[]]. reflexivity.
  - destruct Hc as (E & Ha & Hc).
    change (glued (q :: r :: rest) i j t)
      with (if Rle_dec t (instant (finishes q)) then value_of q i j t else glued (r :: rest) i j t).
    destruct (chained_inside n (r :: rest) Hc) as [_ Hin].
    change (first_time (r :: rest)) with (begins r) in Hin. unfold span in Ht.
    destruct (Rle_dec t (instant (finishes q))) as [Hle|Hgt]; destruct Hp as [<-|Hp].
    + reflexivity.
    + pose proof (Hin p Hp). assert (t = instant (finishes q)) as -> by lra.
      rewrite (Ha i j Hi Hj). rewrite <- (IH Hc p (instant (finishes q)) i j Hi Hj Hp Ht).
      symmetry. apply (IH Hc); try assumption; [left; reflexivity|].
      unfold span. destruct Hc as [Hr _]. lra.
    + lra.
    + apply (IH Hc); assumption.
Qed.

Lemma glued_continuous i j : (i < n)%nat -> (j <= n)%nat ->
  continuous (instant (first_time ps)) (instant (last_time ps)) (glued ps i j).
Proof.
  intros Hi Hj. destruct HL as [Hc Hno].
  assert (forall p, In p ps -> continuous (instant (begins p)) (instant (finishes p)) (value_of p i j)) as Hp.
  { intros p Hp. unfold value_of, Rdiv.
    apply (continuous_mult (instant (begins p)) (instant (finishes p)) (fun t _ => ev (entry (forward p) i j) t)).
    - apply continuous_ev.
    - apply (continuous_inv (instant (begins p)) (instant (finishes p)) (fun t _ => ev (forward_weight p) t)).
      + apply continuous_ev.
      + intros t x Ht. apply (Hno p t Hp Ht). }
  clear Hno HL. induction ps as [|p rest IH]; [destruct Hc|]. destruct rest as [|q rest].
  - apply (Hp p (or_introl eq_refl)).
  - destruct Hc as (Hlt & E & Ha & Hc). destruct (chained_inside n (q :: rest) Hc) as [Hord Hin].
    change (first_time (p :: q :: rest)) with (begins p). change (last_time (p :: q :: rest)) with (last_time (q :: rest)).
    change (first_time (q :: rest)) with (begins q) in *.
    apply (continuous_glued (instant (begins p)) (instant (finishes p))); [lra|apply Hp; left; reflexivity| |].
    + rewrite E. apply IH; [assumption|]. intros r Hr. apply Hp. right. assumption.
    + rewrite (Ha i j Hi Hj), E. symmetry. apply (glued_value (q :: rest) Hc); try assumption; [left; reflexivity|].
      unfold span. destruct Hc as [Hq _]. lra.
Qed.

Lemma in_some_piece t : instant (first_time ps) <= t <= instant (last_time ps) -> exists p, In p ps /\ span p t.
Proof.
  destruct HL as [Hc _]. clear HL. revert t. induction ps as [|p rest IH]; intros t Ht; [destruct Hc|].
  destruct rest as [|q rest]; [exists p; split; [left; reflexivity|exact Ht]|].
  destruct Hc as (Hlt & E & _ & Hc). destruct (Rle_lt_dec t (instant (finishes p))) as [Hle|Hgt].
  - exists p. split; [left; reflexivity|]. unfold span. simpl in Ht. lra.
  - destruct (IH Hc t) as (r & Hr & Hs); [simpl in *; lra|]. exists r. split; [right; assumption|assumption].
Qed.
End Glue.

Lemma det_plane m t : ev (det_poly 2 m) t = det2 (fun i j => ev (entry m (nat_of i) (S (nat_of j))) t).
Proof. unfold det_poly, minus, det2. rewrite ev_zadd, ev_opp, !ev_zmul. simpl. ring. Qed.
Lemma det_space m t : ev (det_poly 3 m) t = det3 (fun i j => ev (entry m (nat_of i) (S (nat_of j))) t).
Proof.
  unfold det_poly, minus, det3, minor. rewrite !ev_zadd, !ev_opp, !ev_zmul, !ev_zadd, !ev_opp, !ev_zmul. simpl. ring.
Qed.

Section Exists.
Variable ps : list piece.
Let a := instant (first_time ps).
Let b := instant (last_time ps).
Definition matrix_at {d} (t : R) : matrix d := fun i j => glued ps (nat_of i) (S (nat_of j)) t.
Definition shift_at {d} (t : R) : point d := fun i => glued ps (nat_of i) 0 t.

Lemma matrix_value {d} p t : legal_motion d ps -> In p ps -> span p t ->
  (forall i j, @matrix_at d t i j = value_of p (nat_of i) (S (nat_of j)) t) /\
  (forall i, @shift_at d t i = value_of p (nat_of i) 0 t).
Proof.
  intros [Hc _] Hp Ht. unfold matrix_at, shift_at. split; intros i; [intros j|].
  - pose proof (nat_of_bound i). pose proof (nat_of_bound j). apply (glued_value d ps Hc); auto; lia.
  - pose proof (nat_of_bound i). apply (glued_value d ps Hc); auto; lia.
Qed.

Lemma given_by_affine {d} (M : affine d a b) : legal_motion d ps ->
  (forall t i j, linear M t i j = matrix_at t i j) -> (forall t i, shift M t i = shift_at t i) ->
  given_by ps (affine_motion M).
Proof.
  intros HL HA Hs p t Hp Ht. destruct (matrix_value p t HL Hp Ht) as [E1 E2]. destruct HL as [_ Hno].
  destruct (Hno p t Hp Ht) as [Hw _]. split; [assumption|]. intros x i. simpl. unfold affine_move, apply_matrix, mapped.
  rewrite Hs, E2, Rmult_plus_distr_l, <- sum_scale, Rplus_comm. unfold value_of. f_equal; [field; assumption|].
  apply sum_same. intros j. rewrite HA, E1. unfold value_of. field. assumption.
Qed.

Lemma continuous_entries {d} : legal_motion d ps ->
  (forall i j, continuous_in (d := d) a b (fun t _ => @matrix_at d t i j)) /\
  (forall i, continuous_in (d := d) a b (fun t _ => @shift_at d t i)).
Proof.
  intros HL. unfold matrix_at, shift_at. split; intros i; [intros j|].
  - pose proof (nat_of_bound i). pose proof (nat_of_bound j). apply (glued_continuous d ps HL); lia.
  - pose proof (nat_of_bound i). apply (glued_continuous d ps HL); lia.
Qed.

Theorem motion_exists_plane : legal_motion 2 ps -> exists M : motion 2 a b, given_by ps M.
Proof.
  intros HL. destruct (continuous_entries HL) as [HA Hs].
  assert (a <= b) as Hab by (apply (chained_inside 2 ps), HL).
  assert (forall t, a <= t <= b -> det2 (matrix_at t) <> 0) as Hdet.
  { intros t Ht. destruct (in_some_piece 2 ps HL t Ht) as (p & Hp & Hsp).
    destruct (matrix_value p t HL Hp Hsp) as [E _]. destruct HL as [_ Hno]. destruct (Hno p t Hp Hsp) as [Hw Hd].
    rewrite det_plane in Hd. intros N. apply Hd. unfold det2 in *. rewrite !E in N. unfold value_of in N.
    apply Rmult_eq_reg_r with (/ ev (forward_weight p) t * / ev (forward_weight p) t);
      [|apply Rmult_integral_contrapositive; split; apply Rinv_neq_0_compat; assumption].
    rewrite Rmult_0_l, <- N. unfold Rdiv. ring. }
  exists (affine_motion (plane_motion Hab matrix_at shift_at HA Hs Hdet)).
  apply given_by_affine; [assumption|reflexivity|reflexivity].
Qed.

Theorem motion_exists_space : legal_motion 3 ps -> exists M : motion 3 a b, given_by ps M.
Proof.
  intros HL. destruct (continuous_entries HL) as [HA Hs].
  assert (a <= b) as Hab by (apply (chained_inside 3 ps), HL).
  assert (forall t, a <= t <= b -> det3 (matrix_at t) <> 0) as Hdet.
  { intros t Ht. destruct (in_some_piece 3 ps HL t Ht) as (p & Hp & Hsp).
    destruct (matrix_value p t HL Hp Hsp) as [E _]. destruct HL as [_ Hno]. destruct (Hno p t Hp Hsp) as [Hw Hd].
    rewrite det_space in Hd. intros N. apply Hd. unfold det3, minor in *. rewrite !E in N. unfold value_of in N.
    apply Rmult_eq_reg_r with (/ ev (forward_weight p) t * / ev (forward_weight p) t * / ev (forward_weight p) t);
      [|repeat (apply Rmult_integral_contrapositive; split); apply Rinv_neq_0_compat; assumption].
    rewrite Rmult_0_l, <- N. unfold Rdiv. ring. }
  exists (affine_motion (space_motion Hab matrix_at shift_at HA Hs Hdet)).
  apply given_by_affine; [assumption|reflexivity|reflexivity].
Qed.
End Exists.
