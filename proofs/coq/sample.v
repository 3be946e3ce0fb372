(* The state of a rational point by the ray of claim C6.
   SPDX-License-Identifier: GPL-3.0-or-later

   [homogeneous V x]  V is w, w x_1, ..., w x_d
   [crossing]    the test of one facet against the ray along the first axis from the point X, displaced
                 by (0, e, e^2, ...) for all small e > 0: 0 missed, 1 or -1 crossed inside, or undecided
   [ray_sum]     the sum over all facets, if each is decided
   [ray_tells]   then it tells the state of a point that is off all facets: 1 for I, 0 for O *)
Require Import Reals Lra Lia List ZArith Bool.
Require Fin.
Require Import Graze.words Graze.space Graze.affine Graze.polynomials Graze.bernstein Graze.facets Graze.ray.
Import ListNotations.
Open Scope R_scope.

(* ------------------------------------------------------------------ homogeneous points *)
Fixpoint nat_of {d} (i : Fin.t d) : nat :=
  match i with Fin.F1 => 0%nat | Fin.FS j => S (nat_of j) end.

Fixpoint rdot (f : list Z) (V : list R) : R :=
  match f, V with c :: f', v :: V' => IZR c * v + rdot f' V' | _, _ => 0 end.
Fixpoint zdot (f X : list Z) : Z :=
  match f, X with c :: f', x :: X' => (c * x + zdot f' X')%Z | _, _ => 0%Z end.

Definition homogeneous {d} (V : list R) (x : point d) : Prop :=
  exists w U, V = w :: U /\ length U = d /\ forall i, nth (nat_of i) U 0 = w * x i.
Definition weight (V : list R) : R := hd 0 V.

Lemma rdot_dot {d} n U w (x : point d) : length U = d ->
  (forall i, nth (nat_of i) U 0 = w * x i) -> rdot n U = w * dot n x.
Proof.
  revert n U x. induction d as [|d IH]; intros n U x HU H.
  - destruct U; [|discriminate]. destruct n; simpl; ring.
  - destruct U as [|u U]; [discriminate|]. destruct n as [|c n]; [simpl; ring|].
    simpl. rewrite (IH n U (fun i => x (Fin.FS i))).
    + pose proof (H Fin.F1) as H1. simpl in H1. rewrite H1. ring.
    + simpl in HU. lia.
    + intros i. apply (H (Fin.FS i)).
Qed.

Lemma rdot_value {d} f V (x : point d) : homogeneous V x -> rdot f V = weight V * zvalue f x.
Proof.
  intros (w & U & -> & HU & H). unfold weight, zvalue. destruct f as [|c f]; simpl.
  - assert (dot [] x = 0) as -> by (destruct d; reflexivity). ring.
  - rewrite (rdot_dot f U w x HU H). ring.
Qed.

Lemma zdot_rdot f X : IZR (zdot f X) = rdot f (map IZR X).
Proof.
  revert X. induction f as [|c f IH]; intros [|x X]; simpl; try reflexivity.
  rewrite plus_IZR, mult_IZR, IH. reflexivity.
Qed.

(* ------------------------------------------------------------------ displaced by infinitesimals *)
Definition displaced {d} (x : point (S d)) (e : R) : point (S d) :=
  fun i => x i + Fin.caseS' i (fun _ => R) 0 (fun j => e ^ S (nat_of j)).

Fixpoint leading (l : list Z) : Z :=
  match l with [] => 0%Z | c :: q => if Z.eqb c 0 then leading q else c end.
Definition displaced_sign (f X : list Z) : Z :=
  let h := zdot f X in if Z.eqb h 0 then leading (tl (tl f)) else h.

Lemma dot_same {d} n (x y : point d) : (forall i, x i = y i) -> dot n x = dot n y.
Proof.
  revert n x y. induction d as [|d IH]; intros [|c n] x y H; simpl; try reflexivity.
  rewrite H. f_equal. apply IH. intros i. apply H.
Qed.

Lemma dot_powers {d} n e k : length n = d -> dot n (fun j : Fin.t d => e ^ (k + nat_of j)) = e ^ k * ev n e.
Proof.
  revert n k. induction d as [|d IH]; intros n k Hn.
  - destruct n; [|discriminate]. unfold ev. simpl. ring.
  - destruct n as [|c n]; [discriminate|]. rewrite ev_cons. simpl.
    rewrite (dot_same n _ (fun j : Fin.t d => e ^ (S k + nat_of j))).
    + rewrite IH by (simpl in Hn; lia). rewrite Nat.add_0_r. simpl. ring.
    + intros i. f_equal. lia.
Qed.

Lemma displaced_value {d} f (x : point (S d)) e s : length f = S (S d) ->
  zvalue f (along (displaced x e) s) = zvalue f x + IZR (nth 1 f 0%Z) * s + e * ev (tl (tl f)) e.
Proof.
  intros Hf. destruct f as [|k [|n f]]; try discriminate. simpl in Hf.
  unfold along, displaced. rewrite zvalue_plus, zvalue_plus. simpl.
  rewrite (dot_same f (fun i => 0) (fun i : Fin.t d => 0 * 1)) by (intros; ring).
  assert (dot f (fun _ : Fin.t d => 0 * 1) = 0) as ->.
  { clear. revert f. induction d as [|d IH]; intros [|c f]; simpl; try reflexivity. rewrite IH. ring. }
  pose proof (dot_powers (d := d) f e 1 ltac:(lia) : dot f (fun j : Fin.t d => e ^ (1 + nat_of j)) = _) as H.
  simpl in H. rewrite H. ring.
Qed.

Lemma signed_near_zero p s : s <> 0%Z -> signed s (eval p 0) ->
  exists e, e > 0 /\ forall u, 0 <= u < e -> signed s (eval p u).
Proof.
  intros Hs H0. assert (eval p 0 <> 0) as Hne by (destruct s; simpl in H0; [congruence|lra|lra]).
  destruct (eval_continuous p 0 (Rabs (eval p 0))) as (e & He & H); [apply Rabs_pos_lt, Hne|].
  exists e. split; [assumption|]. intros u Hu. destruct (Req_dec u 0) as [->|Hu0]; [assumption|].
  assert (Rabs (eval p u - eval p 0) < Rabs (eval p 0)) as K.
  { apply (H u). split; [split; [exact Logic.I|auto]|]. simpl. unfold R_dist.
    replace (u - 0) with u by ring. rewrite Rabs_right; lra. }
  destruct s; simpl in *; [congruence|..].
  - rewrite (Rabs_right (eval p 0)) in K by lra. apply Rabs_def2 in K. lra.
  - rewrite (Rabs_left (eval p 0)) in K by lra. apply Rabs_def2 in K. lra.
Qed.

Lemma leading_small l : leading l <> 0%Z -> exists e, e > 0 /\ forall u, 0 < u < e -> signed (leading l) (ev l u).
Proof.
  induction l as [|c l IH]; simpl; [congruence|]. destruct (Z.eqb_spec c 0) as [->|Hc]; intros H.
  - destruct (IH H) as (e & He & K). exists e. split; [assumption|]. intros u Hu. rewrite ev_cons.
    specialize (K u Hu). destruct (leading l); simpl in *; [congruence|..].
    + pose proof (Rmult_lt_0_compat u (ev l u) ltac:(lra) K). lra.
    + pose proof (Rmult_lt_0_compat u (- ev l u) ltac:(lra) ltac:(lra)). lra.
  - destruct (signed_near_zero (map IZR (c :: l)) c Hc) as (e & He & K).
    + simpl. rewrite Rmult_0_l, Rplus_0_r. destruct c; simpl; [congruence|apply IZR_lt; lia|apply IZR_lt; lia].
    + exists e. split; [assumption|]. intros u Hu. apply K. lra.
Qed.

Lemma signed_self z : signed z (IZR z).
Proof. destruct z; simpl; [reflexivity|apply IZR_lt; lia|apply IZR_lt; lia]. Qed.

Lemma displaced_small {d} f X (x : point d) : homogeneous (map IZR X) x -> 0 < weight (map IZR X) ->
  displaced_sign f X <> 0%Z ->
  exists e, e > 0 /\ forall u, 0 < u < e ->
    signed (displaced_sign f X) (zvalue f x + u * ev (tl (tl f)) u).
Proof.
  intros HX Hw Hs. unfold displaced_sign in *. pose proof (rdot_value f _ x HX) as Hv.
  rewrite <- zdot_rdot in Hv. destruct (Z.eqb_spec (zdot f X) 0) as [E|E].
  - rewrite E in Hv. symmetry in Hv. apply Rmult_integral in Hv. destruct Hv as [Hv|Hv]; [lra|].
    destruct (leading_small _ Hs) as (e & He & K). exists e. split; [assumption|]. intros u Hu.
    specialize (K u Hu). rewrite Hv. destruct (leading (tl (tl f))); simpl in *; [congruence|..].
    + pose proof (Rmult_lt_0_compat u _ ltac:(lra) K). lra.
    + pose proof (Rmult_lt_0_compat u (- ev (tl (tl f)) u) ltac:(lra) ltac:(lra)). lra.
  - destruct (signed_near_zero (zvalue f x :: map IZR (tl (tl f))) (zdot f X) E) as (e & He & K).
    + simpl. rewrite Rmult_0_l, Rplus_0_r. pose proof (signed_self (zdot f X)) as H. rewrite Hv in H.
      destruct (zdot f X); simpl in *; [congruence|..].
      * apply Rmult_lt_reg_l with (1 := Hw). lra.
      * apply Rmult_lt_reg_l with (1 := Hw). lra.
    + exists e. split; [assumption|]. intros u Hu. apply (K u). lra.
Qed.

(* ------------------------------------------------------------------ one facet *)
Definition flat (g : list Z) : bool := Z.eqb (nth 1 g 0%Z) 0.
Definition crossing (f : facet) (X : list Z) : option Z :=
  let n := nth 1 (plane f) 0%Z in
  let h := zdot (plane f) X in
  let side g := displaced_sign g X in
  if negb (forallb (fun g => Nat.eqb (length g) (length X)) (plane f :: sides f)) then None
  else if Z.eqb n 0 then if Z.eqb (displaced_sign (plane f) X) 0 then None else Some 0%Z
  else if existsb (fun g => flat g && Z.ltb (side g) 0) (sides f) then Some 0%Z
  else if Z.eqb h 0 then None
  else if Z.ltb 0 (h * n) then Some 0%Z
  else if forallb (fun g => flat g && Z.ltb 0 (side g)) (sides f) then Some (Z.sgn n)
  else None.
Fixpoint ray_sum (F : list facet) (X : list Z) : option Z :=
  match F with
  | [] => Some 0%Z
  | f :: G =>
      match crossing f X, ray_sum G X with Some k, Some m => Some (k + m)%Z | _, _ => None end
  end.

Section Sample.
Context {d : nat} (X : list Z) (x : point (S d)).
Hypothesis (HX : homogeneous (map IZR X) x) (Hw : 0 < weight (map IZR X)).

Lemma X_length : length X = S (S d).
Proof.
  destruct HX as (w & U & E & HU & _). rewrite <- (map_length IZR X), E. simpl. rewrite HU. reflexivity.
Qed.

Lemma flat_value g e s : length g = length X -> flat g = true ->
  zvalue g (along (displaced x e) s) = zvalue g x + e * ev (tl (tl g)) e.
Proof.
  intros Hl Hf. apply Z.eqb_eq in Hf. rewrite displaced_value by (rewrite Hl; apply X_length).
  rewrite Hf. ring.
Qed.

Lemma sides_positive gs : (forall g, In g gs -> length g = length X) ->
  forallb (fun g => flat g && Z.ltb 0 (displaced_sign g X)) gs = true ->
  exists e, e > 0 /\ forall u s g, 0 < u < e -> In g gs -> 0 < zvalue g (along (displaced x u) s).
Proof.
  induction gs as [|g gs IH]; intros Hl H.
  - exists 1. split; [lra|]. intros u s g _ [].
  - simpl in H. apply andb_prop in H. destruct H as [H1 H2]. apply andb_prop in H1. destruct H1 as [Hf Hs].
    apply Z.ltb_lt in Hs. destruct (IH (fun g Hg => Hl g (or_intror Hg)) H2) as (e & He & K).
    destruct (displaced_small g X x HX Hw ltac:(lia)) as (f & Hf0 & L).
    exists (Rmin e f). split; [apply Rmin_pos; assumption|]. intros u s h Hu [<-|Hh].
    + pose proof (Rmin_r e f). rewrite flat_value by (try assumption; apply Hl; left; reflexivity).
      specialize (L u ltac:(lra)). destruct (displaced_sign g X); simpl in L; [lia|assumption|lia].
    + pose proof (Rmin_l e f). apply K; [lra|assumption].
Qed.

Definition tested (f : facet) (k : Z) (y : point (S d)) : Prop :=
  (k = 0%Z /\ missed f y) \/ exists r, crossed f y k r.

Lemma crossing_tested f k : crossing f X = Some k ->
  exists e, e > 0 /\ forall u, 0 < u < e -> tested f k (displaced x u).
Proof.
  unfold crossing.
  destruct (forallb (fun g => Nat.eqb (length g) (length X)) (plane f :: sides f)) eqn:El; [|discriminate].
  assert (length (plane f) = length X) as Hp.
  { simpl in El. apply andb_prop in El. apply Nat.eqb_eq, El. }
  assert (forall g, In g (sides f) -> length g = length X) as Hg.
  { intros g Hg. simpl in El. apply andb_prop in El. destruct El as [_ El]. rewrite forallb_forall in El.
    apply Nat.eqb_eq, El, Hg. }
  clear El. cbn [negb]. pose proof X_length as HXl.
  destruct (Z.eqb_spec (nth 1 (plane f) 0%Z) 0) as [En|En].
  { destruct (Z.eqb_spec (displaced_sign (plane f) X) 0) as [|Es]; [discriminate|]. intros H.
    inversion H; subst k. destruct (displaced_small (plane f) X x HX Hw Es) as (e & He & K).
    exists e. split; [assumption|]. intros u Hu. left. split; [reflexivity|]. intros s Hs [Ho _].
    rewrite displaced_value in Ho by congruence. rewrite En in Ho. specialize (K u Hu).
    destruct (displaced_sign (plane f) X); simpl in K; [congruence|lra|lra]. }
  destruct (existsb _ (sides f)) eqn:Eb.
  { intros H. inversion H; subst k. apply existsb_exists in Eb. destruct Eb as (g & Hin & Hb).
    apply andb_prop in Hb. destruct Hb as [Hf Hs]. apply Z.ltb_lt in Hs.
    destruct (displaced_small g X x HX Hw ltac:(lia)) as (e & He & K).
    exists e. split; [assumption|]. intros u Hu. left. split; [reflexivity|]. intros s _ [_ Ho].
    specialize (Ho g Hin). rewrite flat_value in Ho by auto. specialize (K u Hu).
    destruct (displaced_sign g X); simpl in K; [lia|lia|lra]. }
  destruct (Z.eqb_spec (zdot (plane f) X) 0) as [|Eh]; [discriminate|].
  assert (displaced_sign (plane f) X = zdot (plane f) X) as Ed.
  { unfold displaced_sign. destruct (Z.eqb_spec (zdot (plane f) X) 0); [contradiction|reflexivity]. }
  destruct (displaced_small (plane f) X x HX Hw ltac:(congruence)) as (e & He & K). rewrite Ed in K.
  destruct (Z.ltb_spec 0 (zdot (plane f) X * nth 1 (plane f) 0%Z)) as [Em|Em].
  { intros H. inversion H; subst k. exists e. split; [assumption|]. intros u Hu. left.
    split; [reflexivity|]. intros s Hs [Ho _]. rewrite displaced_value in Ho by congruence.
    specialize (K u Hu). pose proof (signed_self (nth 1 (plane f) 0%Z)) as Hn.
    destruct (zdot (plane f) X), (nth 1 (plane f) 0%Z) as [|n|n]; simpl in K, Hn; try lia.
    - pose proof (Rmult_le_pos _ s (Rlt_le _ _ Hn) Hs). lra.
    - pose proof (Rmult_le_pos (- IZR (Z.neg n)) s ltac:(lra) Hs). lra. }
  destruct (forallb _ (sides f)) eqn:Ea; [|discriminate]. intros H. inversion H; subst k.
  destruct (sides_positive (sides f) Hg Ea) as (e' & He' & K').
  exists (Rmin e e'). split; [apply Rmin_pos; assumption|]. intros u Hu. right.
  pose proof (Rmin_l e e'). pose proof (Rmin_r e e').
  set (n := IZR (nth 1 (plane f) 0%Z)). set (v := zvalue (plane f) x + u * ev (tl (tl (plane f))) u).
  specialize (K u ltac:(lra)). fold v in K.
  assert (n <> 0) as Hn0 by (unfold n; apply (IZR_neq _ 0), En).
  assert (forall s, zvalue (plane f) (along (displaced x u) s) = n * (s - - v / n)) as Hval.
  { intros s. rewrite displaced_value by congruence. fold n.
    replace (n * (s - - v / n)) with (v + n * s) by (field; assumption). unfold v. ring. }
  exists (- v / n).
  assert (signed (Z.sgn (nth 1 (plane f) 0%Z)) n /\ 0 < - v / n) as [Hsn Hr].
  { pose proof (signed_self (nth 1 (plane f) 0%Z)) as Hn. fold n in Hn.
    destruct (zdot (plane f) X), (nth 1 (plane f) 0%Z); simpl in K, Hn |- *; try lia; (split; [assumption|]).
    - replace (- v / n) with (v / - n) by (field; assumption). apply Rdiv_lt_0_compat; lra.
    - apply Rdiv_lt_0_compat; lra. }
  split; [assumption|]. split; [split|].
  - rewrite Hval. ring.
  - intros g Hin. apply K'; [lra|assumption].
  - split; [destruct (nth 1 (plane f) 0%Z); simpl; [contradiction|auto|auto]|].
    exists n. split; assumption.
Qed.

Lemma ray_sum_crossings F k : ray_sum F X = Some k -> exists e, e > 0 /\
  forall u, 0 < u < e -> exists l, crossings (displaced x u) F l /\ total l = k.
Proof.
  revert k. induction F as [|f F IH]; intros k H; simpl in H.
  - inversion H. exists 1. split; [lra|]. intros u _. exists []. split; [constructor|reflexivity].
  - destruct (crossing f X) as [i|] eqn:Ef; [|discriminate].
    destruct (ray_sum F X) as [m|]; [|discriminate]. inversion H; subst k.
    destruct (crossing_tested f i Ef) as (e & He & K), (IH m eq_refl) as (e' & He' & K').
    exists (Rmin e e'). split; [apply Rmin_pos; assumption|]. intros u Hu.
    pose proof (Rmin_l e e'). pose proof (Rmin_r e e').
    destruct (K' u ltac:(lra)) as (l & Hl & Ht).
    destruct (K u ltac:(lra)) as [[-> Hm]|[r Hr]].
    + exists l. split; [constructor; assumption|]. lia.
    + exists ((r, i) :: l). split; [constructor; assumption|]. simpl. lia.
Qed.

Theorem ray_tells F (A : set (S d)) k : legal F A -> ray_sum F X = Some k ->
  (forall f, In f F -> ~ on f x) ->
  (k = 1%Z -> state_at A x I) /\ (k = 0%Z -> state_at A x O).
Proof.
  intros HL Hk Hoff.
  assert (exists v, counts (A := A) x v) as [v Hv].
  { destruct (state_off HL x Hoff) as [H|H]; [exists 1%Z; left|exists 0%Z; right]; auto. }
  assert (exists r, r > 0 /\ forall y, near x r y -> counts (A := A) y v) as (r & Hr & Hnear).
  { destruct Hv as [[-> H]|[-> H]]; apply interior_open in H; destruct H as (r & Hr & H);
      exists r; (split; [assumption|]); intros y Hy; [left|right]; auto. }
  destruct (ray_sum_crossings F k Hk) as (e & He & K).
  set (u := Rmin (Rmin e r) 1 / 2).
  assert (0 < u /\ u < e /\ u < r /\ u < 1) as (U1 & U2 & U3 & U4).
  { assert (0 < Rmin (Rmin e r) 1) by (repeat apply Rmin_pos; lra).
    pose proof (Rmin_l (Rmin e r) 1). pose proof (Rmin_r (Rmin e r) 1).
    pose proof (Rmin_l e r). pose proof (Rmin_r e r). unfold u. lra. }
  destruct (K u ltac:(lra)) as (l & Hl & Ht).
  pose proof (ray_state HL (displaced x u) l Hl) as Hc. rewrite Ht in Hc.
  assert (counts (A := A) (displaced x u) v) as Hc'.
  { apply Hnear. intros i. unfold displaced.
    apply (Fin.caseS' i (fun i =>
      Rabs (x i + Fin.caseS' i (fun _ => R) 0 (fun j => u ^ S (nat_of j)) - x i) < r)).
    - simpl. replace (x Fin.F1 + 0 - x Fin.F1) with 0 by ring. rewrite Rabs_R0. lra.
    - intros j. simpl. assert (0 <= u ^ nat_of j <= 1) as Hp.
      { split; [apply pow_le; lra|]. rewrite <- (pow1 (nat_of j)). apply pow_incr. lra. }
      replace (x (Fin.FS j) + u * u ^ nat_of j - x (Fin.FS j)) with (u * u ^ nat_of j) by ring.
      rewrite Rabs_right; [|apply Rle_ge, Rmult_le_pos; lra].
      apply Rle_lt_trans with (u * 1); [apply Rmult_le_compat_l; lra|lra]. }
  rewrite (counts_functional _ _ _ Hc Hc'). destruct Hv as [[-> H]|[-> H]]; split; intros E; try discriminate; exact H.
Qed.
End Sample.
