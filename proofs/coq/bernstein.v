(* Signs of integer polynomials on an interval by their Bernstein coefficients.
   SPDX-License-Identifier: GPL-3.0-or-later

   [ev]            the value of a polynomial with integer coefficients, the constant one first
   [bern a b d n]  its coefficients on [a/d, b/d] to degree n, C(n, k) b_k times a positive number:
                   those of (1 + v)^n p((a + b v) / (d (1 + v)))
   [strict]        1 or -1 if all coefficients have this sign, else 0
   [strict_sign]   then p has this sign on the interval, its ends included (claim C22)
   [no_negative]   no coefficient is negative; [not_negative] then p is not negative there
   [one_change]    -1 or 1, the sign at the left end, if there is one change of sign and none is 0 at
                   the ends; else 0
   [one_root]      then p has just one root there, inside, and its signs beside it (claims C24, K7) *)
Require Import Reals Lra Lia List ZArith Bool.
Require Import Graze.polynomials.
Import ListNotations.
Open Scope R_scope.

Definition ev (p : list Z) (x : R) : R := eval (map IZR p) x.

(* ------------------------------------------------------------------ integer polynomials *)
Fixpoint zadd (p q : list Z) : list Z :=
  match p, q with
  | [], _ => q
  | _, [] => p
  | c :: p', e :: q' => (c + e)%Z :: zadd p' q'
  end.
Definition zscale (c : Z) (p : list Z) : list Z := map (Z.mul c) p.
Fixpoint zmul (p q : list Z) : list Z :=
  match p with [] => [] | c :: p' => zadd (zscale c q) (0%Z :: zmul p' q) end.

(* (al + be v) p *)
Definition times_linear (al be : Z) (p : list Z) : list Z := zadd (zscale al p) (0%Z :: zscale be p).
(* (d + d v)^n *)
Fixpoint power (d : Z) (n : nat) : list Z :=
  match n with O => [1%Z] | S n' => times_linear d d (power d n') end.

Fixpoint bern (a b d : Z) (n : nat) (p : list Z) : list Z :=
  match p with
  | [] => []
  | c :: q => zadd (zscale c (power d n)) (times_linear a b (bern a b d (pred n) q))
  end.

Definition all_positive (n : nat) (l : list Z) : bool :=
  Nat.eqb (length l) (S n) && forallb (Z.ltb 0) l.
Definition strict (n : nat) (l : list Z) : Z :=
  if all_positive n l then 1 else if all_positive n (map Z.opp l) then -1 else 0.
Definition no_negative (l : list Z) : bool := forallb (Z.leb 0) l.

(* Not positive up to some place, not negative from there on. *)
Fixpoint rising (l : list Z) : bool :=
  match l with
  | [] => true
  | c :: q => if Z.leb c 0 then rising q else no_negative q
  end.
Definition rises (n : nat) (l : list Z) : bool :=
  Nat.eqb (length l) (S n) && Z.ltb (hd 0%Z l) 0 && Z.ltb 0 (last l 0%Z) && rising l.
Definition one_change (n : nat) (l : list Z) : Z :=
  if rises n l then -1 else if rises n (map Z.opp l) then 1 else 0.

(* x has the sign s. *)
Definition signed (s : Z) (x : R) : Prop :=
  match s with Z0 => x = 0 | Zpos _ => 0 < x | Zneg _ => x < 0 end.
(* t is in [a/d, b/d]. *)
Definition within (a b d : Z) (t : R) : Prop := IZR a <= IZR d * t <= IZR b.

(* ------------------------------------------------------------------ values *)
Lemma ev_cons c p x : ev (c :: p) x = IZR c + x * ev p x.
Proof. reflexivity. Qed.
Lemma ev_zadd p q x : ev (zadd p q) x = ev p x + ev q x.
Proof.
  revert q. induction p as [|c p IH]; intros [|e q]; try (unfold ev; simpl; ring).
  change (zadd (c :: p) (e :: q)) with ((c + e)%Z :: zadd p q).
  rewrite !ev_cons, IH, plus_IZR. ring.
Qed.
Lemma ev_zscale c p x : ev (zscale c p) x = IZR c * ev p x.
Proof.
  induction p as [|e p IH]; [unfold ev; simpl; ring|].
  change (zscale c (e :: p)) with ((c * e)%Z :: zscale c p). rewrite !ev_cons, IH, mult_IZR. ring.
Qed.
Lemma ev_zmul p q x : ev (zmul p q) x = ev p x * ev q x.
Proof.
  induction p as [|c p IH]; [unfold ev; simpl; ring|].
  change (zmul (c :: p) q) with (zadd (zscale c q) (0%Z :: zmul p q)).
  rewrite ev_zadd, ev_zscale, !ev_cons, IH. ring.
Qed.
Lemma ev_opp p x : ev (map Z.opp p) x = - ev p x.
Proof.
  induction p as [|c p IH]; [unfold ev; simpl; ring|].
  simpl map. rewrite !ev_cons, IH, opp_IZR. ring.
Qed.

(* ------------------------------------------------------------------ the homogeneous form *)
Fixpoint heval (q : list Z) (n : nat) (x y : R) : R :=
  match q with [] => 0 | c :: q' => IZR c * y ^ n + x * heval q' (pred n) x y end.

Lemma heval_zadd p q n x y : heval (zadd p q) n x y = heval p n x y + heval q n x y.
Proof.
  revert q n. induction p as [|c p IH]; intros [|e q] n; simpl; try ring.
  rewrite IH, plus_IZR. ring.
Qed.
Lemma heval_zscale c p n x y : heval (zscale c p) n x y = IZR c * heval p n x y.
Proof.
  revert n. induction p as [|e p IH]; intros n; simpl; [ring|].
  change (map (Z.mul c) p) with (zscale c p). rewrite IH, mult_IZR. ring.
Qed.
Lemma heval_opp p n x y : heval (map Z.opp p) n x y = - heval p n x y.
Proof. revert n. induction p as [|e p IH]; intros n; simpl; [ring|]. rewrite IH, opp_IZR. ring. Qed.

Lemma heval_raised p n x y : (length p <= S n)%nat -> heval p (S n) x y = y * heval p n x y.
Proof.
  revert n. induction p as [|c p IH]; intros n Hn; [simpl; ring|].
  destruct n as [|n].
  - destruct p; [simpl; ring|simpl in Hn; lia].
  - change (IZR c * y ^ S (S n) + x * heval p (S n) x y = y * (IZR c * y ^ S n + x * heval p n x y)).
    rewrite IH by (simpl in Hn; lia). simpl. ring.
Qed.

Lemma heval_times_linear al be p n x y : (length p <= S n)%nat ->
  heval (times_linear al be p) (S n) x y = (IZR al * y + IZR be * x) * heval p n x y.
Proof.
  intros Hn. unfold times_linear. rewrite heval_zadd, heval_zscale, heval_raised by assumption.
  change (heval (0%Z :: zscale be p) (S n) x y) with (0 * y ^ S n + x * heval (zscale be p) n x y).
  rewrite heval_zscale. ring.
Qed.

Lemma zadd_length p q : length (zadd p q) = Nat.max (length p) (length q).
Proof. revert q. induction p as [|c p IH]; intros [|e q]; simpl; auto. Qed.
Lemma times_linear_length al be p : length (times_linear al be p) = S (length p).
Proof. unfold times_linear, zscale. rewrite zadd_length. simpl. rewrite !map_length. lia. Qed.
Lemma power_length d n : length (power d n) = S n.
Proof. induction n as [|n IH]; [reflexivity|]. simpl power. rewrite times_linear_length, IH. reflexivity. Qed.
Lemma bern_length a b d n p : (length p <= S n)%nat -> (length (bern a b d n p) <= S n)%nat.
Proof.
  revert n. induction p as [|c p IH]; intros n Hn; simpl; [lia|].
  rewrite zadd_length, times_linear_length. unfold zscale. rewrite map_length, power_length.
  destruct n as [|n].
  - destruct p; [simpl; lia|simpl in Hn; lia].
  - pose proof (IH n ltac:(simpl in Hn; lia)). change (pred (S n)) with n. lia.
Qed.

Lemma heval_power d n x y : heval (power d n) n x y = (IZR d * y + IZR d * x) ^ n.
Proof.
  induction n as [|n IH]; [simpl; ring|].
  change (power d (S n)) with (times_linear d d (power d n)).
  rewrite heval_times_linear, IH by (rewrite power_length; lia). simpl. ring.
Qed.

(* The coefficients are those of p: at t in the interval, x = d t - a and y = b - d t are not negative. *)
Theorem bern_value a b d n p t : (length p <= S n)%nat ->
  heval (bern a b d n p) n (IZR d * t - IZR a) (IZR b - IZR d * t)
  = (IZR d * (IZR b - IZR a)) ^ n * ev p t.
Proof.
  revert n. induction p as [|c p IH]; intros n Hn; [unfold ev; simpl; ring|].
  change (bern a b d n (c :: p))
    with (zadd (zscale c (power d n)) (times_linear a b (bern a b d (pred n) p))).
  rewrite heval_zadd, heval_zscale, heval_power, ev_cons.
  replace (IZR d * (IZR b - IZR d * t) + IZR d * (IZR d * t - IZR a))
    with (IZR d * (IZR b - IZR a)) by ring.
  destruct n as [|n].
  - destruct p; [unfold ev; simpl; ring|simpl in Hn; lia].
  - assert (length p <= S n)%nat as Hp by (simpl in Hn; lia).
    change (pred (S n)) with n. rewrite heval_times_linear by (apply bern_length, Hp).
    rewrite IH by exact Hp. simpl pow. ring.
Qed.

(* ------------------------------------------------------------------ one strict sign *)
Lemma heval_positive l : forall n x y, length l = S n -> forallb (Z.ltb 0) l = true ->
  0 <= x -> 0 <= y -> 0 < x + y -> 0 < heval l n x y.
Proof.
  induction l as [|c l IH]; intros n x y Hl Hp Hx Hy Hxy; [discriminate|].
  simpl in Hp. apply andb_prop in Hp. destruct Hp as [Hc Hp]. apply Z.ltb_lt, IZR_lt in Hc.
  destruct n as [|n].
  - destruct l; [simpl; lra|discriminate].
  - change (heval (c :: l) (S n) x y) with (IZR c * y ^ S n + x * heval l n x y).
    destruct (Req_dec x 0) as [->|Hx0].
    + assert (0 < y ^ S n) by (apply pow_lt; lra).
      pose proof (Rmult_lt_0_compat _ _ Hc H). lra.
    + assert (0 < heval l n x y) as Hh by (apply IH; auto).
      assert (0 <= y ^ S n) by (apply pow_le; lra).
      pose proof (Rmult_le_pos _ _ (Rlt_le _ _ Hc) H).
      pose proof (Rmult_lt_0_compat x _ ltac:(lra) Hh). lra.
Qed.

Lemma heval_not_negative l : forall n x y, no_negative l = true ->
  0 <= x -> 0 <= y -> 0 <= heval l n x y.
Proof.
  induction l as [|c l IH]; intros n x y Hp Hx Hy; [simpl; lra|].
  unfold no_negative in Hp. simpl in Hp. apply andb_prop in Hp. destruct Hp as [Hc Hp].
  apply Z.leb_le, IZR_le in Hc.
  change (heval (c :: l) n x y) with (IZR c * y ^ n + x * heval l (pred n) x y).
  apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto. apply pow_le; assumption.
Qed.

Section Interval.
Variables (a b d : Z).
Hypothesis (d_positive : (0 < d)%Z) (in_order : (a < b)%Z).

Let Hd : 0 < IZR d. Proof. apply IZR_lt, d_positive. Qed.
Let Hab : IZR a < IZR b. Proof. apply IZR_lt, in_order. Qed.

Lemma factor_positive n : 0 < (IZR d * (IZR b - IZR a)) ^ n.
Proof. apply pow_lt, Rmult_lt_0_compat; lra. Qed.

(* Coefficients l of a value v at t. *)
Definition coefficients_at (n : nat) (l : list Z) (t v : R) : Prop :=
  heval l n (IZR d * t - IZR a) (IZR b - IZR d * t) = (IZR d * (IZR b - IZR a)) ^ n * v.

Lemma strict_value n l t v : coefficients_at n l t v -> strict n l <> 0%Z -> within a b d t ->
  signed (strict n l) v.
Proof.
  intros Hv Hs [Ht1 Ht2]. unfold coefficients_at in Hv. pose proof (factor_positive n) as Hf.
  unfold strict in *. destruct (all_positive n l) eqn:E.
  - apply andb_prop in E. destruct E as [El Ep]. apply Nat.eqb_eq in El.
    pose proof (heval_positive _ n (IZR d * t - IZR a) (IZR b - IZR d * t) El Ep
      ltac:(lra) ltac:(lra) ltac:(lra)) as H. rewrite Hv in H. simpl.
    apply Rmult_lt_reg_l with (1 := Hf). lra.
  - destruct (all_positive n (map Z.opp l)) eqn:E'; [|congruence].
    apply andb_prop in E'. destruct E' as [El Ep]. apply Nat.eqb_eq in El.
    pose proof (heval_positive _ n (IZR d * t - IZR a) (IZR b - IZR d * t) El Ep
      ltac:(lra) ltac:(lra) ltac:(lra)) as H. rewrite heval_opp, Hv in H. simpl.
    apply Rmult_lt_reg_l with (1 := Hf). lra.
Qed.

Lemma not_negative_value n l t v : coefficients_at n l t v -> no_negative l = true ->
  within a b d t -> 0 <= v.
Proof.
  intros Hv Hs [Ht1 Ht2]. unfold coefficients_at in Hv.
  pose proof (heval_not_negative _ n (IZR d * t - IZR a) (IZR b - IZR d * t) Hs
    ltac:(lra) ltac:(lra)) as H. rewrite Hv in H. pose proof (factor_positive n).
  apply Rmult_le_reg_l with (1 := H0). lra.
Qed.

Theorem strict_sign n p t : (length p <= S n)%nat -> strict n (bern a b d n p) <> 0%Z ->
  within a b d t -> signed (strict n (bern a b d n p)) (ev p t).
Proof. intros Hn. apply (strict_value n _ t). apply bern_value, Hn. Qed.

Theorem not_negative n p t : (length p <= S n)%nat -> no_negative (bern a b d n p) = true ->
  within a b d t -> 0 <= ev p t.
Proof. intros Hn. apply (not_negative_value n _ t). apply bern_value, Hn. Qed.

(* ------------------------------------------------------------------ one change of sign *)
Lemma grows_not_negative l : no_negative l = true -> forall v u, 0 <= v <= u ->
  0 <= ev l v <= ev l u.
Proof.
  induction l as [|c l IH]; intros Hl v u Hv; [unfold ev; simpl; lra|].
  unfold no_negative in Hl. simpl in Hl. apply andb_prop in Hl. destruct Hl as [Hc Hl].
  apply Z.leb_le, IZR_le in Hc. destruct (IH Hl v u Hv) as [H1 H2]. rewrite !ev_cons.
  pose proof (Rmult_le_pos v (ev l v) ltac:(lra) H1).
  pose proof (Rmult_le_compat v u (ev l v) (ev l u) ltac:(lra) H1 ltac:(lra) H2). lra.
Qed.

Lemma grows l : rising l = true -> forall v u, 0 < v <= u -> 0 <= ev l v -> ev l v <= ev l u.
Proof.
  induction l as [|c l IH]; intros Hl v u Hv H0; [unfold ev; simpl; lra|].
  simpl in Hl. destruct (Z.leb c 0) eqn:E.
  - apply Z.leb_le, IZR_le in E. rewrite !ev_cons in *.
    assert (0 <= ev l v) as Hq.
    { apply Rmult_le_reg_l with v; lra. }
    pose proof (IH Hl v u Hv Hq).
    pose proof (Rmult_le_compat v u (ev l v) (ev l u) ltac:(lra) Hq ltac:(lra) H). lra.
  - apply Z.leb_gt, IZR_lt in E.
    assert (no_negative (c :: l) = true) as Hp.
    { unfold no_negative. simpl. rewrite (proj2 (Z.leb_le 0 c)); [exact Hl|].
      apply le_IZR. lra. }
    apply (grows_not_negative _ Hp v u). lra.
Qed.

Lemma grows_strictly l : rising l = true -> (hd 0 l < 0)%Z -> forall v u, 0 < v < u ->
  0 <= ev l v -> ev l v < ev l u.
Proof.
  destruct l as [|c l]; intros Hl Hc v u Hv H0; [simpl in Hc; lia|]. simpl in Hc, Hl.
  rewrite (proj2 (Z.leb_le c 0)) in Hl by lia. apply IZR_lt in Hc. rewrite !ev_cons in *.
  assert (0 < ev l v) as Hq.
  { apply Rmult_lt_reg_l with v; lra. }
  pose proof (grows l Hl v u ltac:(lra) ltac:(lra)) as H.
  pose proof (Rmult_le_compat_l u _ _ ltac:(lra) H).
  pose proof (Rmult_lt_compat_r _ v u Hq ltac:(lra)). lra.
Qed.

Lemma heval_affine l n x y : (length l <= S n)%nat -> 0 < y -> heval l n x y = y ^ n * ev l (x / y).
Proof.
  revert n. induction l as [|c l IH]; intros n Hn Hy; [unfold ev; simpl; ring|].
  change (heval (c :: l) n x y) with (IZR c * y ^ n + x * heval l (pred n) x y). rewrite ev_cons.
  destruct n as [|n].
  - destruct l; [unfold ev; simpl; field; lra|simpl in Hn; lia].
  - change (pred (S n)) with n. rewrite IH by (simpl in *; try lia; lra). simpl. field. lra.
Qed.

Lemma heval_end l n x : length l = S n -> heval l n x 0 = IZR (last l 0%Z) * x ^ n.
Proof.
  revert n. induction l as [|c l IH]; intros n Hn; [discriminate|].
  destruct n as [|n].
  - destruct l; [simpl; ring|discriminate].
  - change (heval (c :: l) (S n) x 0) with (IZR c * 0 ^ S n + x * heval l n x 0).
    rewrite IH by (simpl in Hn; lia). destruct l as [|e l]; [discriminate|].
    change (last (c :: e :: l) 0%Z) with (last (e :: l) 0%Z). simpl. ring.
Qed.

(* The signs of a polynomial beside its one root. *)
Definition root_between (p : list Z) (s : Z) (r : R) : Prop :=
  IZR a < IZR d * r < IZR b /\ ev p r = 0 /\
  forall t, within a b d t -> (t < r -> signed s (ev p t)) /\ (r < t -> signed (- s) (ev p t)).

Lemma one_root_rising n p : (length p <= S n)%nat -> rises n (bern a b d n p) = true ->
  exists r, root_between p (-1) r.
Proof.
  intros Hn H. unfold rises in H. apply andb_prop in H. destruct H as [H Hup].
  apply andb_prop in H. destruct H as [H Hlast]. apply andb_prop in H. destruct H as [H Hfirst]. set (l := bern a b d n p) in *.
  apply Nat.eqb_eq in H. apply Z.ltb_lt in Hfirst, Hlast.
  pose proof (factor_positive n) as Hf. set (K := (IZR d * (IZR b - IZR a)) ^ n) in *.
  assert (forall t, IZR d * t < IZR b -> K * ev p t = (IZR b - IZR d * t) ^ n
      * ev l ((IZR d * t - IZR a) / (IZR b - IZR d * t))) as Hval.
  { intros t Ht. unfold K. rewrite <- bern_value by assumption. fold l.
    apply heval_affine; [lia|lra]. }
  set (v := fun t => (IZR d * t - IZR a) / (IZR b - IZR d * t)).
  assert (forall t, IZR d * t < IZR b -> (0 <= ev p t <-> 0 <= ev l (v t))
      /\ (0 < ev p t <-> 0 < ev l (v t))) as Hsame.
  { intros t Ht. specialize (Hval t Ht). fold (v t) in Hval.
    assert (0 < (IZR b - IZR d * t) ^ n) as Hy by (apply pow_lt; lra).
    repeat split; intros Hp.
    - apply Rmult_le_reg_l with (1 := Hy). rewrite <- Hval, Rmult_0_r. apply Rmult_le_pos; lra.
    - apply Rmult_le_reg_l with (1 := Hf). rewrite Hval, Rmult_0_r. apply Rmult_le_pos; lra.
    - apply Rmult_lt_reg_l with (1 := Hy). rewrite <- Hval, Rmult_0_r. apply Rmult_lt_0_compat; lra.
    - apply Rmult_lt_reg_l with (1 := Hf). rewrite Hval, Rmult_0_r. apply Rmult_lt_0_compat; lra. }
  assert (forall t u, IZR a < IZR d * t -> t < u -> IZR d * u < IZR b -> 0 < v t < v u) as Hv.
  { intros t u H1 H2 H3.
    assert (IZR d * t < IZR d * u) by (apply Rmult_lt_compat_l; lra). unfold v. split.
    - apply Rdiv_lt_0_compat; lra.
    - apply Rmult_lt_reg_r with ((IZR b - IZR d * t) * (IZR b - IZR d * u));
        [apply Rmult_lt_0_compat; lra|].
      replace ((IZR d * t - IZR a) / (IZR b - IZR d * t) * ((IZR b - IZR d * t) * (IZR b - IZR d * u)))
        with ((IZR d * t - IZR a) * (IZR b - IZR d * u)) by (field; lra).
      replace ((IZR d * u - IZR a) / (IZR b - IZR d * u) * ((IZR b - IZR d * t) * (IZR b - IZR d * u)))
        with ((IZR d * u - IZR a) * (IZR b - IZR d * t)) by (field; lra).
      assert (0 < (IZR d * u - IZR d * t) * (IZR b - IZR a)) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (forall t u, IZR a < IZR d * t -> t < u -> IZR d * u < IZR b -> 0 <= ev p t -> 0 < ev p u) as Hgrow.
  { intros t u H1 H2 H3 H4. pose proof (Hv t u H1 H2 H3) as Hvv.
    assert (IZR d * t < IZR d * u) by (apply Rmult_lt_compat_l; lra).
    apply Hsame in H4; [|lra]. apply Hsame; [lra|].
    pose proof (grows_strictly l Hup Hfirst _ _ Hvv H4). lra. }
  set (lo := IZR a / IZR d). set (hi := IZR b / IZR d).
  assert (IZR d * lo = IZR a /\ IZR d * hi = IZR b) as [Elo Ehi] by (unfold lo, hi; split; field; lra).
  assert (ev p lo < 0) as Hlo.
  { pose proof (Hval lo ltac:(lra)) as E. rewrite Elo in E.
    replace ((IZR a - IZR a) / (IZR b - IZR a)) with 0 in E by (field; lra).
    assert (ev l 0 < 0) as Hl0.
    { destruct l as [|c l']; [discriminate|]. rewrite ev_cons. simpl in Hfirst. apply IZR_lt in Hfirst. lra. }
    assert (0 < (IZR b - IZR a) ^ n) as Hy by (apply pow_lt; lra).
    apply Rmult_lt_reg_l with (1 := Hf). rewrite E, Rmult_0_r.
    pose proof (Rmult_lt_compat_l _ _ _ Hy Hl0). lra. }
  assert (0 < ev p hi) as Hhi.
  { pose proof (bern_value a b d n p hi Hn) as E. fold l K in E. rewrite Ehi in E.
    replace (IZR b - IZR b) with 0 in E by ring. rewrite heval_end in E by exact H.
    apply IZR_lt in Hlast. assert (0 < (IZR b - IZR a) ^ n) as Hy by (apply pow_lt; lra).
    apply Rmult_lt_reg_l with (1 := Hf). rewrite <- E, Rmult_0_r. apply Rmult_lt_0_compat; assumption. }
  assert (lo < hi) as Hlohi by (apply Rmult_lt_reg_l with (1 := Hd); lra).
  destruct (IVT_cor (ev p) lo hi) as (r & Hr & Hr0).
  - apply eval_continuous.
  - lra.
  - pose proof (Rmult_lt_compat_r _ _ _ Hhi Hlo). lra.
  - assert (lo < r < hi) as Hr'.
    { destruct Hr as [[?|<-] [?| ->]]; try lra; split; lra. }
    assert (IZR a < IZR d * r < IZR b) as Hdr
      by (rewrite <- Elo, <- Ehi; split; apply Rmult_lt_compat_l; lra).
    exists r. split; [assumption|]. split; [assumption|]. intros t [Ht1 Ht2].
    split; intros Htr; simpl.
    + destruct (Rtotal_order (IZR a) (IZR d * t)) as [Hat|[Hat|Hat]]; [| |lra].
      * apply Rnot_le_lt. intros N.
        pose proof (Hgrow t r Hat Htr ltac:(lra) N). lra.
      * replace t with lo; [assumption|]. apply Rmult_eq_reg_l with (IZR d); lra.
    + destruct (Rtotal_order (IZR d * t) (IZR b)) as [Htb|[Htb|Htb]]; [| |lra].
      * apply (Hgrow r t); lra.
      * replace t with hi; [assumption|]. apply Rmult_eq_reg_l with (IZR d); lra.
Qed.

Lemma bern_opp n p : bern a b d n (map Z.opp p) = map Z.opp (bern a b d n p).
Proof.
  assert (forall q r, map Z.opp (zadd q r) = zadd (map Z.opp q) (map Z.opp r)) as Hadd.
  { induction q as [|x q IH]; intros [|y r]; simpl; try reflexivity. rewrite IH. f_equal. lia. }
  assert (forall c q, map Z.opp (zscale c q) = zscale c (map Z.opp q)) as Hscale.
  { intros c q. unfold zscale. rewrite !map_map. apply map_ext. intros x. lia. }
  revert n. induction p as [|c p IH]; intros n; [reflexivity|].
  simpl. rewrite IH, Hadd. f_equal.
  - unfold zscale. rewrite map_map. apply map_ext. intros x. lia.
  - unfold times_linear. rewrite Hadd. simpl. rewrite !Hscale. reflexivity.
Qed.

Theorem one_root n p : (length p <= S n)%nat -> one_change n (bern a b d n p) <> 0%Z ->
  exists r, root_between p (one_change n (bern a b d n p)) r.
Proof.
  intros Hn H. unfold one_change in *. destruct (rises n (bern a b d n p)) eqn:E.
  - apply (one_root_rising n); assumption.
  - destruct (rises n (map Z.opp (bern a b d n p))) eqn:E'; [|congruence].
    rewrite <- bern_opp in E'.
    destruct (one_root_rising n (map Z.opp p)) as (r & Hr & H0 & Hs); [rewrite map_length; assumption|assumption|].
    exists r. split; [assumption|]. rewrite ev_opp in H0. split; [lra|].
    intros t Ht. specialize (Hs t Ht). rewrite ev_opp in Hs. simpl in *.
    split; intros K; apply Hs in K; lra.
Qed.
End Interval.
