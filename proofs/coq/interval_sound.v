(* The tests of an interval of a certificate are right (claims K7 to K11).
   SPDX-License-Identifier: GPL-3.0-or-later

   [divide_out_value]  f = q^e r, and what is said of e
   [cleared_off]       a cleared facet is not met on the interval (claim K8)
   [profile_sound]     the signs of a form beside a root are as said (claim K9)
   [same_state]        off all facets the state does not change (claim K11)
   [interval_sound]    if the tests succeed, the states on the interval are those of its kind *)
Require Import Reals Lra Lia List ZArith Znumtheory Bool.
Require Fin.
Require Import Graze.words Graze.times Graze.space Graze.polynomials Graze.bernstein Graze.facets Graze.ray
  Graze.sample Graze.interval.
Import ListNotations.
Open Scope R_scope.

(* ------------------------------------------------------------------ polynomials *)
Lemma ev_trim p t : ev (trim p) t = ev p t.
Proof.
  induction p as [|c p IH]; [reflexivity|]. simpl trim. rewrite ev_cons, <- IH.
  destruct (trim p) as [|e r]; [|reflexivity].
  destruct (Z.eqb_spec c 0) as [->|]; unfold ev; simpl; ring.
Qed.
Lemma ev_pull f V t : ev (pull f V) t = rdot f (map (fun p => ev p t) V).
Proof.
  revert V. induction f as [|c f IH]; intros [|p V]; try reflexivity.
  simpl. destruct (Z.eqb_spec c 0) as [->|]; [rewrite IH; ring|].
  rewrite ev_zadd, ev_zscale, IH. reflexivity.
Qed.
Lemma heval_pull f V n x y : heval (pull f V) n x y = rdot f (map (fun p => heval p n x y) V).
Proof.
  revert V. induction f as [|c f IH]; intros [|p V]; try reflexivity.
  simpl. destruct (Z.eqb_spec c 0) as [->|]; [rewrite IH; ring|].
  rewrite heval_zadd, heval_zscale, IH. reflexivity.
Qed.
Lemma rdot_scaled f k V : rdot f (map (Rmult k) V) = k * rdot f V.
Proof.
  revert V. induction f as [|c f IH]; intros [|v V]; simpl; try ring. rewrite IH. ring.
Qed.
Lemma same_list_eq p q : same_list p q = true -> p = q.
Proof.
  revert q. induction p as [|c p IH]; intros [|e q] H; try discriminate; [reflexivity|].
  simpl in H. apply andb_prop in H. destruct H as [H1 H2]. apply Z.eqb_eq in H1. f_equal; auto.
Qed.

Lemma divide_out_value fuel : forall f q odd some r, divide_out fuel f q = (odd, some, r) ->
  exists e, Nat.odd e = odd /\ (some = true -> e <> 0%nat) /\ forall t, ev f t = ev q t ^ e * ev r t.
Proof.
  induction fuel as [|k IH]; intros f q odd some r H; simpl in H.
  - inversion H; subst. exists 0%nat. split; [reflexivity|]. split; [discriminate|]. intros t. simpl. ring.
  - destruct (same_list _ f) eqn:E.
    + destruct (divide_out k (trim (quotient f q)) q) as [[o s] r'] eqn:D. inversion H; subst.
      destruct (IH _ _ _ _ _ D) as (e & He & _ & Hv). exists (S e). split; [|split].
      * rewrite Nat.odd_succ, <- Nat.negb_odd, He. reflexivity.
      * discriminate.
      * intros t. apply same_list_eq in E. rewrite <- E, ev_trim, ev_zmul, Hv. simpl. ring.
    + inversion H; subst. exists 0%nat. split; [reflexivity|]. split; [discriminate|]. intros t. simpl. ring.
Qed.

Lemma signed_times a b x y : signed a x -> signed b y -> signed (a * b) (x * y).
Proof.
  destruct a, b; simpl; intros H K; subst; try ring.
  - apply Rmult_lt_0_compat; assumption.
  - pose proof (Rmult_lt_0_compat x (- y) H ltac:(lra)). lra.
  - pose proof (Rmult_lt_0_compat (- x) y ltac:(lra) K). lra.
  - pose proof (Rmult_lt_0_compat (- x) (- y) ltac:(lra) ltac:(lra)). lra.
Qed.
Lemma signed_even s x e : s <> 0%Z -> signed s x -> Nat.odd e = false -> 0 < x ^ e.
Proof.
  intros Hs Hx He. rewrite <- Nat.negb_even in He. apply negb_false_iff in He. apply Nat.even_spec in He.
  destruct He as [m ->]. rewrite pow_mult. apply pow_lt.
  assert (x <> 0) as Hne by (destruct s; simpl in Hx; [congruence|lra|lra]).
  replace (x ^ 2) with (Rsqr x) by (unfold Rsqr; ring). apply Rsqr_pos_lt, Hne.
Qed.
Lemma signed_odd s x e : s <> 0%Z -> signed s x -> Nat.odd e = true -> signed s (x ^ e).
Proof.
  intros Hs Hx He. destruct e as [|e]; [discriminate|]. rewrite Nat.odd_succ in He.
  assert (0 < x ^ e) as H.
  { apply (signed_even s); try assumption. rewrite <- Nat.negb_even, He. reflexivity. }
  simpl. destruct s; simpl in *; [congruence|apply Rmult_lt_0_compat; assumption|].
  pose proof (Rmult_lt_0_compat (- x) (x ^ e) ltac:(lra) H). lra.
Qed.
Lemma signed_positive s x k : 0 < k -> signed s (k * x) -> signed s x.
Proof.
  intros Hk H. destruct s; simpl in *.
  - apply Rmult_integral in H. destruct H; lra.
  - apply Rmult_lt_reg_l with (1 := Hk). lra.
  - apply Rmult_lt_reg_l with (1 := Hk). lra.
Qed.

(* ------------------------------------------------------------------ the tests are right *)
Section Sound.
Context {d : nat} (v : view) (c : R -> point (S d)) (F : list facet) (A : set (S d)).
Hypothesis HL : legal F A.
Hypothesis bounds_hold : forall f g (x : point (S d)), In f F -> In g (bounds f) -> on f x -> 0 <= zvalue g x.
Hypothesis Hok : view_ok v = true.
Hypothesis Hcoefficients : coefficients v = map (bern (lo v) (hi v) (den v) (degree v)) (curve v).
Let inside t := within (lo v) (hi v) (den v) t.
Hypothesis follows : forall t, inside t -> homogeneous (map (fun p => ev p t) (curve v)) (c t).

Let Hden : (0 < den v)%Z.
Proof. unfold view_ok in Hok. repeat (apply andb_prop in Hok as [Hok ?]). apply Z.ltb_lt, Hok. Qed.
Let Horder : (lo v < hi v)%Z.
Proof. unfold view_ok in Hok. repeat (apply andb_prop in Hok as [Hok ?]). apply Z.ltb_lt. assumption. Qed.
Let Hlengths p : In p (curve v) -> (length p <= S (degree v))%nat.
Proof.
  unfold view_ok in Hok. repeat (apply andb_prop in Hok as [Hok ?]). intros Hp.
  rewrite forallb_forall in H0. apply Nat.leb_le, H0, Hp.
Qed.

Lemma heval_curve t : map (fun p => heval p (degree v) (IZR (den v) * t - IZR (lo v)) (IZR (hi v) - IZR (den v) * t))
    (coefficients v)
  = map (Rmult ((IZR (den v) * (IZR (hi v) - IZR (lo v))) ^ degree v)) (map (fun p => ev p t) (curve v)).
Proof.
  rewrite Hcoefficients, !map_map. apply map_ext_in. intros p Hp. apply bern_value, Hlengths, Hp.
Qed.

Lemma pull_coefficients f t : coefficients_at (lo v) (hi v) (den v) (degree v) (pull f (coefficients v)) t
  (ev (pull f (curve v)) t).
Proof. unfold coefficients_at. rewrite heval_pull, heval_curve, rdot_scaled, ev_pull. reflexivity. Qed.

Lemma weight_positive t : inside t -> 0 < weight (map (fun p => ev p t) (curve v)).
Proof.
  intros Ht. pose proof Hok as H. unfold view_ok in H. apply andb_prop in H. destruct H as [_ H].
  apply Z.eqb_eq in H. destruct (follows t Ht) as (w & U & E & _).
  rewrite Hcoefficients in H. pose proof Hlengths as Hl.
  destruct (curve v) as [|p V]; [discriminate|]. simpl in H. simpl.
  pose proof (strict_sign (lo v) (hi v) (den v) Hden Horder (degree v) p t) as K.
  rewrite H in K. apply K; [apply Hl; left; reflexivity|discriminate|exact Ht].
Qed.

Lemma pull_value f t : inside t ->
  ev (pull f (curve v)) t = weight (map (fun p => ev p t) (curve v)) * zvalue f (c t).
Proof. intros Ht. rewrite ev_pull. apply rdot_value, follows, Ht. Qed.

Lemma sign_of_value f t : inside t -> sign_of v f <> 0%Z -> signed (sign_of v f) (zvalue f (c t)).
Proof.
  intros Ht Hs. apply signed_positive with (1 := weight_positive t Ht). rewrite <- pull_value by exact Ht.
  apply (strict_value (lo v) (hi v) (den v) Hden Horder) with (t := t); [apply pull_coefficients|exact Hs|exact Ht].
Qed.

Lemma sign_of_negative f t : inside t -> Z.ltb (sign_of v f) 0 = true -> zvalue f (c t) < 0.
Proof.
  intros Ht Hs. apply Z.ltb_lt in Hs. pose proof (sign_of_value f t Ht ltac:(lia)) as H.
  destruct (sign_of v f); simpl in H; [lia|lia|assumption].
Qed.

Lemma cleared_off f t : In f F -> inside t -> cleared v f = true -> ~ on f (c t).
Proof.
  intros Hf Ht H Ho. unfold cleared in H. apply orb_prop in H. destruct H as [H|H]; [apply orb_prop in H; destruct H as [H|H]|].
  - apply existsb_exists in H. destruct H as (g & Hg & Hs). apply (sign_of_negative g t Ht) in Hs.
    pose proof (bounds_hold f g _ Hf Hg Ho). lra.
  - apply negb_true_iff, Z.eqb_neq in H. pose proof (sign_of_value _ t Ht H) as K.
    destruct Ho as [Ho _]. rewrite Ho in K. destruct (sign_of v (plane f)); simpl in K; [congruence|lra|lra].
  - apply existsb_exists in H. destruct H as (g & Hg & Hs). apply (sign_of_negative g t Ht) in Hs.
    destruct Ho as [_ Ho]. pose proof (Ho g Hg). lra.
Qed.

(* The root, where it is, and the signs of q beside it. *)
Definition root_of (q : list Z) (left : Z) (r : R) : Prop :=
  inside r /\ ev q r = 0 /\ left <> 0%Z /\
  forall t, inside t -> (t < r -> signed left (ev q t)) /\ (r < t -> signed (- left) (ev q t)).

Definition knows (o : option Z) (x : R) : Prop := match o with Some s => signed s x | None => True end.

Lemma profile_sound q left r f : root_of q left r -> forall t, inside t ->
  let p := profile_of v q left f in
  (t < r -> knows (before p) (zvalue f (c t))) /\ (t = r -> knows (at_root p) (zvalue f (c t))) /\
  (r < t -> knows (after p) (zvalue f (c t))).
Proof.
  intros (Hr & Hq0 & Hl & Hq) t Ht. cbv zeta. unfold profile_of.
  destruct (Z.eqb_spec (sign_of v f) 0) as [E|E]; cbn [negb].
  2: { pose proof (sign_of_value f t Ht E). simpl. tauto. }
  pose proof (weight_positive t Ht) as Hw. pose proof (pull_value f t Ht) as Hv.
  destruct (trim (pull f (curve v))) as [|c0 p0] eqn:Ep.
  - rewrite <- ev_trim, Ep in Hv. change (ev [] t) with 0 in Hv. symmetry in Hv.
    apply Rmult_integral in Hv. destruct Hv as [Hv|Hv]; [rewrite Hv in Hw; lra|]. simpl. tauto.
  - rewrite <- ev_trim, Ep in Hv. set (p := c0 :: p0) in *.
    destruct (divide_out (length p) p q) as [[odd some] rest] eqn:D.
    destruct (divide_out_value _ _ _ _ _ _ D) as (e & Ho & Hsome & He).
    set (n := pred (length rest)). set (s := strict n (bern (lo v) (hi v) (den v) n rest)).
    assert (knows (if some then Some 0%Z else None) (zvalue f (c r))) as Hmid.
    { destruct some; [|exact Logic.I]. simpl. specialize (Hsome eq_refl).
      pose proof (pull_value f r Hr) as Hvr. rewrite <- ev_trim, Ep in Hvr. fold p in Hvr.
      rewrite (He r), Hq0, pow_i, Rmult_0_l in Hvr by lia. symmetry in Hvr. pose proof (weight_positive r Hr).
      apply Rmult_integral in Hvr. destruct Hvr as [K|K]; [rewrite K in H; lra|exact K]. }
    destruct (Z.eqb_spec s 0) as [Es|Es].
    + simpl. repeat split; auto. intros ->. exact Hmid.
    + assert (signed s (ev rest t)) as Hs.
      { apply strict_sign; try assumption. unfold n. lia. }
      assert (forall z, signed z (ev p t) -> signed z (zvalue f (c t))) as Hback.
      { intros z Hz. apply signed_positive with (1 := Hw). rewrite <- Hv. exact Hz. }
      destruct odd; cbn [before at_root after knows]; (split; [|split; [intros ->; exact Hmid|]]); intros Hlt; apply Hback;
        rewrite (He t); destruct (Hq t Ht) as [Q1 Q2].
      * rewrite Rmult_comm. apply signed_times; [assumption|]. apply signed_odd; auto.
      * replace (- (s * left))%Z with (s * - left)%Z by lia. rewrite Rmult_comm.
        apply signed_times; [assumption|]. apply signed_odd; auto. lia.
      * pose proof (signed_even left _ e Hl (Q1 Hlt) Ho) as K.
        replace s with (1 * s)%Z by lia. apply signed_times; assumption.
      * pose proof (signed_even (- left) _ e ltac:(lia) (Q2 Hlt) Ho) as K.
        replace s with (1 * s)%Z by lia. apply signed_times; assumption.
Qed.

Definition on_part (pick : profile -> option Z) (q : list Z) (left : Z) (t : R) : Prop :=
  forall f, knows (pick (profile_of v q left f)) (zvalue f (c t)).

Lemma off_side_off pick q left f t : on_part pick q left t -> off_side pick (profiles v q left f) = true ->
  ~ on f (c t).
Proof.
  intros Hp H [Ho Hs]. apply orb_prop in H. destruct H as [H|H].
  - pose proof (Hp (plane f)) as K. unfold profiles in H. simpl in H. rewrite Ho in K.
    destruct (pick (profile_of v q left (plane f))) as [[]|]; simpl in *; try discriminate; lra.
  - apply existsb_exists in H. destruct H as (p & Hin & H). simpl in Hin. apply in_map_iff in Hin.
    destruct Hin as (g & <- & Hg). pose proof (Hp g) as K. pose proof (Hs g Hg).
    destruct (pick (profile_of v q left g)) as [[]|]; simpl in *; try discriminate; lra.
Qed.

Lemma holds_on pick q left f t : on_part pick q left t -> holds pick (profiles v q left f) = true -> on f (c t).
Proof.
  intros Hp H. apply andb_prop in H. destruct H as [H1 H2]. simpl in H1, H2. split.
  - pose proof (Hp (plane f)) as K.
    destruct (pick (profile_of v q left (plane f))) as [[]|]; simpl in *; try discriminate; assumption.
  - intros g Hg. rewrite forallb_forall in H2. specialize (H2 _ (in_map (profile_of v q left) _ g Hg)).
    pose proof (Hp g) as K.
    destruct (pick (profile_of v q left g)) as [[]|]; simpl in *; try discriminate; lra.
Qed.

(* ------------------------------------------------------------------ states *)
Let s (t : R) (x : state) := state_at A (c t) x.
Hypothesis opens : forall x t, x <> B -> inside t -> s t x ->
  exists e, e > 0 /\ forall u, inside u -> Rabs (u - t) < e -> s u x.

Lemma same_state t u : inside t -> inside u -> t <= u ->
  (forall r f, t <= r <= u -> In f F -> ~ on f (c r)) -> forall x, x <> B -> (s t x <-> s u x).
Proof.
  intros Ht Hu Htu Hoff.
  assert (forall r, t <= r <= u -> inside r) as Hin.
  { intros r Hr. unfold inside, within in *. assert (0 < IZR (den v)) by (apply IZR_lt, Hden).
    assert (IZR (den v) * t <= IZR (den v) * r) by (apply Rmult_le_compat_l; lra).
    assert (IZR (den v) * r <= IZR (den v) * u) by (apply Rmult_le_compat_l; lra). lra. }
  assert (forall r, t <= r <= u -> s r I \/ s r O) as Hio by (intros r Hr; apply (state_off HL); auto).
  intros x Hx. apply (connected (fun r => s r x)); [assumption|]. intros r Hr.
  assert (exists y, y <> B /\ s r y) as (y & Hy & Hsy) by (destruct (Hio r Hr); eexists; (split; [|eassumption]); discriminate).
  destruct (opens y r Hy (Hin r Hr) Hsy) as (e & He & K). exists e. split; [assumption|]. intros w Hw Hwr.
  specialize (K w (Hin w Hw) Hwr). split; intros H.
  - rewrite (state_functional _ _ _ _ H K). assumption.
  - rewrite (state_functional _ _ _ _ H Hsy). assumption.
Qed.

Lemma value_at_heval p n num de : IZR (value_at p n num de) = heval p n (IZR num) (IZR de).
Proof.
  revert n. induction p as [|e p IH]; intros n; simpl; [reflexivity|].
  rewrite plus_IZR, !mult_IZR, IH, <- pow_IZR. reflexivity.
Qed.

Lemma state_ok_state num t x : IZR (den v) * t = IZR num -> inside t -> x <> B ->
  (forall f, In f F -> ~ on f (c t)) -> state_ok v F num (Some x) = true -> s t x.
Proof.
  intros Hnum Ht Hx Hoff H.
  set (X := map (fun p => value_at p (degree v) num (den v)) (curve v)) in *.
  assert (0 < IZR (den v)) as Hd by (apply IZR_lt, Hden).
  assert (map IZR X = map (Rmult (IZR (den v) ^ degree v)) (map (fun p => ev p t) (curve v))) as EX.
  { unfold X. rewrite !map_map. apply map_ext_in. intros p Hp. rewrite value_at_heval, heval_affine; auto.
    f_equal. f_equal. rewrite <- Hnum. field. lra. }
  assert (0 < IZR (den v) ^ degree v) as Hk by (apply pow_lt, Hd).
  assert (homogeneous (map IZR X) (c t)) as HX.
  { rewrite EX. destruct (follows t Ht) as (w & U & -> & HU & Hn).
    exists (IZR (den v) ^ degree v * w), (map (Rmult (IZR (den v) ^ degree v)) U).
    split; [reflexivity|]. split; [rewrite map_length; assumption|]. intros i.
    replace 0 with (IZR (den v) ^ degree v * 0) by ring. rewrite map_nth, Hn. ring. }
  assert (0 < weight (map IZR X)) as HW.
  { rewrite EX. pose proof (weight_positive t Ht) as Hw. destruct (curve v); [simpl in Hw; lra|].
    simpl in *. apply Rmult_lt_0_compat; assumption. }
  unfold state_ok in H. fold X in H.
  destruct (ray_sum F X) as [k|] eqn:E; [|destruct x; [discriminate|congruence|discriminate]].
  destruct (ray_tells X (c t) HX HW F A k HL E Hoff) as [K1 K0].
  destruct x; [|congruence|]; apply Z.eqb_eq in H; [exact (K1 H)|exact (K0 H)].
Qed.

Lemma meet_states q left r l' r' : root_of q left r -> meet_ok v F q left l' r' = true ->
  (match l' with
   | None => True
   | Some B => forall t, inside t -> t < r -> s t B
   | Some _ => forall t f, inside t -> t < r -> In f F -> ~ on f (c t) end) /\
  (match r' with
   | None => True
   | Some B => forall t, inside t -> r < t -> s t B
   | Some _ => forall t f, inside t -> r < t -> In f F -> ~ on f (c t) end) /\
  (forced l' r' = true \/ s r B).
Proof.
  intros Hr H. unfold meet_ok in H. apply andb_prop in H. destruct H as [H Hmid].
  apply andb_prop in H. destruct H as [Hbefore Hafter].
  assert (forall pick t, inside t -> on_part pick q left t -> forall x,
    side_ok pick (Some x) (map (profiles v q left) (filter (fun f => negb (cleared v f)) F)) = true ->
    match x with B => s t B | _ => forall f, In f F -> ~ on f (c t) end) as Hside.
  { intros pick t Ht Hp x Hx.
    assert (forall f, In f F -> (cleared v f = true \/ In f (filter (fun f => negb (cleared v f)) F))) as Hcases.
    { intros f Hf. destruct (cleared v f) eqn:E; [auto|]. right. apply filter_In. rewrite E. auto. }
    destruct x; simpl in Hx.
    2: { apply existsb_exists in Hx. destruct Hx as (p & Hin & Hh). apply in_map_iff in Hin.
         destruct Hin as (f & <- & Hf). apply filter_In in Hf. apply (state_on HL f); [apply Hf|].
         exact (holds_on pick q left f t Hp Hh). }
    all: intros f Hf; destruct (Hcases f Hf) as [E|E]; [exact (cleared_off f t Hf Ht E)|];
      rewrite forallb_forall in Hx; apply (off_side_off pick q left f t Hp), Hx, in_map, E. }
  assert (forall t, inside t -> (t < r -> on_part before q left t) /\ (t = r -> on_part at_root q left t)
    /\ (r < t -> on_part after q left t)) as Hparts.
  { intros t Ht. pose proof (profile_sound q left r) as K. unfold on_part.
    repeat split; intros Hlt f; apply (K f Hr t Ht); assumption. }
  split; [|split].
  - destruct l' as [x|]; [|exact Logic.I].
    assert (forall t, inside t -> t < r -> match x with B => s t B | _ => forall f, In f F -> ~ on f (c t) end) as K
      by (intros t Ht Hlt; apply (Hside before t Ht); [apply Hparts; assumption|assumption]).
    destruct x; auto; intros t f Ht Hlt; apply (K t Ht Hlt).
  - destruct r' as [x|]; [|exact Logic.I].
    assert (forall t, inside t -> r < t -> match x with B => s t B | _ => forall f, In f F -> ~ on f (c t) end) as K
      by (intros t Ht Hlt; apply (Hside after t Ht); [apply Hparts; assumption|assumption]).
    destruct x; auto; intros t f Ht Hlt; apply (K t Ht Hlt).
  - apply orb_prop in Hmid. destruct Hmid as [Hmid|Hmid]; [left; assumption|right].
    apply (Hside at_root r (proj1 Hr)) with (x := B); [apply Hparts; [apply Hr|reflexivity]|exact Hmid].
Qed.

(* ------------------------------------------------------------------ the interval *)
Let a := IZR (lo v) / IZR (den v).
Let b := IZR (hi v) / IZR (den v).

Lemma ends : IZR (den v) * a = IZR (lo v) /\ IZR (den v) * b = IZR (hi v) /\ a < b /\ inside a /\ inside b /\
  forall t, inside t <-> a <= t <= b.
Proof.
  assert (0 < IZR (den v)) as Hd by (apply IZR_lt, Hden). pose proof (IZR_lt _ _ Horder).
  assert (IZR (den v) * a = IZR (lo v)) as Ea by (unfold a; field; lra).
  assert (IZR (den v) * b = IZR (hi v)) as Eb by (unfold b; field; lra).
  unfold inside, within. repeat split; try lra.
  - apply Rmult_lt_reg_l with (1 := Hd). lra.
  - apply Rmult_le_reg_l with (1 := Hd). lra.
  - apply Rmult_le_reg_l with (1 := Hd). lra.
  - destruct H0. rewrite <- Ea. apply Rmult_le_compat_l; lra.
  - destruct H0. rewrite <- Eb. apply Rmult_le_compat_l; lra.
Qed.

(* The states on a side of the root, from the test at the interval's end. *)
Lemma before_root r x : inside r -> a < r -> state_ok v F (lo v) (Some x) = true ->
  match x with
  | B => forall t, inside t -> t < r -> s t B
  | _ => forall t f, inside t -> t < r -> In f F -> ~ on f (c t) end ->
  forall t, a <= t < r -> s t x.
Proof.
  destruct ends as (Ea & Eb & Hab & Ia & Ib & Hin). intros Hr Har Hs Hoff t Ht.
  assert (inside t) as It by (apply Hin in Hr; apply Hin; lra).
  destruct x; [|apply Hoff; [assumption|lra]|];
    (apply (same_state a t Ia It ltac:(lra)); [|discriminate|];
      [intros u f Hu; apply Hoff; [apply Hin in It; apply Hin; lra|lra]|
       apply (state_ok_state (lo v)); try assumption; [discriminate|intros f; apply Hoff; [exact Ia|lra]]]).
Qed.

Lemma after_root r x : inside r -> r < b -> state_ok v F (hi v) (Some x) = true ->
  match x with
  | B => forall t, inside t -> r < t -> s t B
  | _ => forall t f, inside t -> r < t -> In f F -> ~ on f (c t) end ->
  forall t, r < t <= b -> s t x.
Proof.
  destruct ends as (Ea & Eb & Hab & Ia & Ib & Hin). intros Hr Hrb Hs Hoff t Ht.
  assert (inside t) as It by (apply Hin in Hr; apply Hin; lra).
  destruct x; [|apply Hoff; [assumption|lra]|];
    (apply (same_state t b It Ib ltac:(lra)); [|discriminate|];
      [intros u f Hu; apply Hoff; [apply Hin in It; apply Hin; lra|lra]|
       apply (state_ok_state (hi v)); try assumption; [discriminate|intros f; apply Hoff; [exact Ib|lra]]]).
Qed.

(* States beside a time that are not one open state make it a time on the boundary. *)
Lemma forced_B r x y : inside r -> a < r < b -> (forall t, a <= t < r -> s t x) -> (forall t, r < t <= b -> s t y) ->
  forced (Some x) (Some y) = true -> s r B.
Proof.
  intros Hr Hab Hx Hy Hf. destruct ends as (_ & _ & _ & _ & _ & Hin).
  destruct (state_total A (c r)) as [z Hz]. fold (s r z) in Hz.
  destruct (state_eq_dec z B) as [->|Hne]; [assumption|exfalso].
  destruct (opens z r Hne Hr Hz) as (e & He & K).
  assert (0 < Rmin e (Rmin (r - a) (b - r)) / 2) as Hm
    by (apply Rdiv_lt_0_compat; [repeat apply Rmin_pos|]; lra).
  set (m := Rmin e (Rmin (r - a) (b - r)) / 2) in *.
  assert (m < e /\ m < r - a /\ m < b - r) as (M1 & M2 & M3).
  { pose proof (Rmin_l e (Rmin (r - a) (b - r))). pose proof (Rmin_r e (Rmin (r - a) (b - r))).
    pose proof (Rmin_l (r - a) (b - r)). pose proof (Rmin_r (r - a) (b - r)). unfold m in *. lra. }
  assert (s (r - m) z) as S1.
  { apply K; [apply Hin; lra|]. replace (r - m - r) with (- m) by ring. rewrite Rabs_left; lra. }
  assert (s (r + m) z) as S2.
  { apply K; [apply Hin; lra|]. replace (r + m - r) with m by ring. rewrite Rabs_right; lra. }
  pose proof (state_functional _ _ _ _ (Hx (r - m) ltac:(lra)) S1).
  pose proof (state_functional _ _ _ _ (Hy (r + m) ltac:(lra)) S2). subst.
  destruct z; simpl in Hf; congruence.
Qed.

Theorem interval_sound k q : interval_ok v F k q = true -> cuts s a (letters k) b.
Proof.
  destruct ends as (Ea & Eb & Hab & Ia & Ib & Hin). intros H. destruct k as [x|l r].
  - enough (forall t, inside t -> s t x) as K.
    { simpl. apply cut_gap with b; [assumption|apply K, Ia| |constructor; apply K, Ib].
      intros t Ht. apply K, Hin. lra. }
    assert (x <> B -> interval_ok v F (stays x) q = true -> forall t, inside t -> s t x) as Hfree.
    { intros Hx H' t Ht.
      assert (forallb (cleared v) F && state_ok v F (hi v) (Some x) = true) as K by (destruct x; [exact H'|congruence|exact H']).
      apply andb_prop in K. destruct K as [Hc Hs]. rewrite forallb_forall in Hc.
      assert (forall u f, inside u -> In f F -> ~ on f (c u)) as Hoff by (intros u f Hu Hf; apply cleared_off; auto).
      apply (same_state t b Ht Ib); [apply Hin, Ht| |assumption|].
      - intros u f Hu. apply Hoff, Hin. apply Hin in Ht. lra.
      - apply (state_ok_state (hi v)); auto. }
    destruct x; [apply Hfree; [discriminate|assumption]| |apply Hfree; [discriminate|assumption]].
    intros t Ht. simpl in H. apply existsb_exists in H. destruct H as (f & Hf & H).
    apply andb_prop in H. destruct H as [H1 H2]. apply (state_on HL f); [assumption|].
    pose proof (weight_positive t Ht) as Hw. split.
    + pose proof (pull_coefficients (plane f) t) as K. unfold coefficients_at in K.
      assert (forall n x y, heval (pull (plane f) (coefficients v)) n x y = 0) as Hz.
      { unfold always_zero in H1. clear - H1. induction (pull (plane f) (coefficients v)) as [|e p IH]; [reflexivity|].
        simpl in H1. apply andb_prop in H1. destruct H1 as [E H1].
        assert (e = 0%Z) as -> by (destruct e; congruence). intros n x y. simpl. rewrite (IH H1). ring. }
      rewrite Hz, pull_value in K by exact Ht. symmetry in K.
      pose proof (factor_positive (lo v) (hi v) (den v) Hden Horder (degree v)) as Hf0.
      apply Rmult_integral in K. destruct K as [K|K]; [lra|].
      apply Rmult_integral in K. destruct K as [K|K]; [lra|exact K].
    + intros g Hg. rewrite forallb_forall in H2. specialize (H2 g Hg).
      apply Rmult_le_reg_l with (1 := Hw). rewrite Rmult_0_r, <- pull_value by exact Ht.
      apply (not_negative_value (lo v) (hi v) (den v) Hden Horder (degree v) (pull g (coefficients v)) t);
        [apply pull_coefficients|exact H2|exact Ht].
  - simpl in H. apply andb_prop in H. destruct H as [H Hm]. apply andb_prop in H. destruct H as [Hsl Hsr].
    assert (0 < IZR (den v)) as Hd by (apply IZR_lt, Hden).
    assert (forall e, inside e -> forall p, IZR (den v) * e = IZR p -> root_of (root_form p (den v)) (-1) e) as Hend.
    { intros e He p Hp. assert (0 < Z.gcd p (den v))%Z as Hg.
      { pose proof (Z.gcd_nonneg p (den v)). destruct (Z.eq_dec (Z.gcd p (den v)) 0) as [E|]; [|lia].
        apply Z.gcd_eq_0_r in E. lia. }
      pose proof (Zdivide_Zdiv_eq _ _ Hg (Z.gcd_divide_l p (den v))) as Ep.
      pose proof (Zdivide_Zdiv_eq _ _ Hg (Z.gcd_divide_r p (den v))) as Eq.
      set (g := Z.gcd p (den v)) in *. pose proof Hd as Hd'. rewrite Eq, mult_IZR in Hd', Hp. rewrite Ep, mult_IZR in Hp.
      apply IZR_lt in Hg. assert (0 < IZR (den v / g)) as Hk by (apply Rmult_lt_reg_l with (1 := Hg); lra).
      assert (IZR (den v / g) * e = IZR (p / g)) as Ee by (apply Rmult_eq_reg_l with (IZR g); lra).
      assert (forall t, ev (root_form p (den v)) t = IZR (den v / g) * t - IZR (p / g)) as Hlinear.
      { intros t. unfold root_form, ev. fold g. simpl. rewrite opp_IZR. ring. }
      split; [assumption|]. rewrite Hlinear. split; [lra|]. split; [discriminate|].
      intros t Ht. rewrite Hlinear. simpl. split; intros Hlt; pose proof (Rmult_lt_compat_l _ _ _ Hk Hlt); lra. }
    destruct l as [x|], r as [y|]; [| | |discriminate].
    + apply andb_prop in Hm. destruct Hm as [Hq Hm]. apply negb_true_iff, Z.eqb_neq in Hq.
      destruct (one_root (lo v) (hi v) (den v) Hden Horder (pred (length q)) q ltac:(lia) Hq) as (r & Hr & Hr0 & Hbeside).
      set (left := one_change (pred (length q)) (bern (lo v) (hi v) (den v) (pred (length q)) q)) in *.
      assert (inside r) as Ir by (unfold inside, within; lra).
      assert (a < r < b) as Hrab by (split; apply Rmult_lt_reg_l with (1 := Hd); lra).
      destruct (meet_states q left r (Some x) (Some y)) as (M1 & M2 & M3); [exact (conj Ir (conj Hr0 (conj Hq Hbeside)))|assumption|].
      pose proof (before_root r x Ir ltac:(lra) Hsl M1) as Hx. pose proof (after_root r y Ir ltac:(lra) Hsr M2) as Hy.
      assert (s r B) as HB by (destruct M3 as [M3|M3]; [exact (forced_B r x y Ir Hrab Hx Hy M3)|exact M3]).
      simpl. apply cut_gap with r; [lra|apply Hx; lra|intros; apply Hx; lra|].
      apply cut_gap with b; [lra|exact HB|intros; apply Hy; lra|]. constructor. apply Hy. lra.
    + destruct (meet_states _ _ b (Some x) None (Hend b Ib _ Eb) Hm) as (M1 & _ & [M3|M3]); [discriminate|].
      pose proof (before_root b x Ib Hab Hsl M1) as Hx.
      simpl. apply cut_gap with b; [lra|apply Hx; lra|intros; apply Hx; lra|]. constructor. exact M3.
    + destruct (meet_states _ _ a None (Some y) (Hend a Ia _ Ea) Hm) as (_ & M2 & [M3|M3]); [discriminate|].
      pose proof (after_root a y Ia Hab Hsr M2) as Hy.
      simpl. apply cut_gap with b; [lra|exact M3|intros; apply Hy; lra|]. constructor. apply Hy. lra.
Qed.
End Sound.
