(* A ray that crosses facets strictly tells the state of its beginning (claim C6, by V0 to V3).
   SPDX-License-Identifier: GPL-3.0-or-later

   [connected]     what is open in an interval, and its contrary too, holds all along or nowhere
   [crossings]     each facet is missed by the ray from y along the first axis, or crossed inside
   [ray_state]     then the signs of the crossings add up to 1 if y is in iS, to 0 if in S^c *)
Require Import Reals Lra Lia List ZArith Bool Classical.
Require Fin.
Require Import Graze.words Graze.space Graze.affine Graze.polynomials Graze.bernstein Graze.facets.
Import ListNotations.
Open Scope R_scope.

Lemma large_number x : exists n, x < INR n.
Proof.
  destruct (archimed_cor1 (/ (Rabs x + 1))) as (n & Hn & Hn0).
  - apply Rinv_0_lt_compat. pose proof (Rabs_pos x). lra.
  - exists n. pose proof (Rle_abs x). pose proof (Rabs_pos x).
    apply lt_0_INR in Hn0. apply Rnot_le_lt. intros N.
    assert (/ (Rabs x + 1) <= / INR n) by (apply Rinv_le_contravar; lra). lra.
Qed.

Theorem connected (P : R -> Prop) a b : a <= b ->
  (forall t, a <= t <= b -> exists e, e > 0 /\
    forall u, a <= u <= b -> Rabs (u - t) < e -> (P u <-> P t)) ->
  (P a <-> P b).
Proof.
  intros Hab H.
  destruct (uniform_on_interval a b (fun e t => forall u, a <= u <= b -> Rabs (u - t) < e -> (P u <-> P t)))
    as (e & He & K).
  - assumption.
  - intros e f t K Hf u Hu Hut. apply K; [assumption|lra].
  - intros t Ht. destruct (H t Ht) as (e & He & K). exists (e / 2). split; [lra|].
    intros u Hu Hut v Hv Hvu. rewrite (K u Hu ltac:(lra)). apply K; [assumption|].
    replace (v - t) with ((v - u) + (u - t)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|]. lra.
  - enough (forall n t, a <= t <= b -> t <= a + INR n * (e / 2) -> (P a <-> P t)) as G.
    { destruct (large_number ((b - a) / (e / 2))) as [n Hn]. apply (G n); [lra|].
      apply Rmult_lt_compat_r with (r := e / 2) in Hn; [|lra].
      replace ((b - a) / (e / 2) * (e / 2)) with (b - a) in Hn by (field; lra). lra. }
    induction n as [|n IH]; intros t Ht Hn.
    + simpl in Hn. replace t with a by lra. tauto.
    + rewrite S_INR in Hn. destruct (Rle_lt_dec t (a + INR n * (e / 2))) as [Hle|Hlt]; [apply IH; assumption|].
      assert (0 <= INR n * (e / 2)) by (apply Rmult_le_pos; [apply pos_INR|lra]).
      rewrite (IH (a + INR n * (e / 2))) by lra. symmetry. apply (K (a + INR n * (e / 2))); [lra|assumption|].
      rewrite Rabs_right; lra.
Qed.

(* ------------------------------------------------------------------ crossings on a line *)
Definition crossing_list := list (R * Z).
Definition is_crossing (l : crossing_list) (s : R) : Prop := exists k, In (s, k) l.
Fixpoint ahead (l : crossing_list) (s : R) : Z :=
  match l with [] => 0%Z | (r, k) :: q => ((if Rlt_dec s r then k else 0) + ahead q s)%Z end.
Fixpoint total (l : crossing_list) : Z := match l with [] => 0%Z | (_, k) :: q => (k + total q)%Z end.
Fixpoint jump (l : crossing_list) (s : R) : Z :=
  match l with [] => 0%Z | (r, k) :: q => ((if Req_EM_T s r then k else 0) + jump q s)%Z end.

Lemma ahead_near l s : exists e, e > 0 /\ forall u, Rabs (u - s) < e ->
  (u < s -> ahead l u = (ahead l s + jump l s)%Z) /\ (s <= u -> ahead l u = ahead l s) /\
  (u <> s -> ~ is_crossing l u).
Proof.
  induction l as [|[r k] l (e & He & IH)].
  - exists 1. split; [lra|]. intros u Hu. simpl. repeat split; auto. intros _ [j []].
  - assert (exists f, f > 0 /\ forall u, Rabs (u - s) < f -> (u < s -> r <> s -> (u < r <-> s < r)) /\
      (s <= u -> (u < r <-> s < r)) /\ (u <> s -> u <> r)) as (f & Hf & Hr).
    { destruct (Req_dec r s) as [->|Hne].
      - exists 1. split; [lra|]. intros u Hu. repeat split; try lra; intros; try lra; congruence.
      - exists (Rabs (r - s)). split; [apply Rabs_pos_lt; lra|]. intros u Hu.
        assert ((u < r <-> s < r) /\ u <> r) as [K1 K2].
        { destruct (Rtotal_order r s) as [L|[L|L]]; [|lra|].
          - rewrite (Rabs_left (r - s)) in Hu by lra. apply Rabs_def2 in Hu. lra.
          - rewrite (Rabs_right (r - s)) in Hu by lra. apply Rabs_def2 in Hu. lra. }
        tauto. }
    exists (Rmin e f). split; [apply Rmin_pos; assumption|]. intros u Hu.
    pose proof (Rmin_l e f). pose proof (Rmin_r e f).
    destruct (IH u ltac:(lra)) as (I1 & I2 & I3), (Hr u ltac:(lra)) as (R1 & R2 & R3).
    simpl. split; [|split].
    + intros Hus. rewrite (I1 Hus). destruct (Req_EM_T s r) as [->|Hne].
      * destruct (Rlt_dec u r), (Rlt_dec r r); try lra; lia.
      * specialize (R1 Hus ltac:(lra)). destruct (Rlt_dec u r), (Rlt_dec s r); try tauto; lia.
    + intros Hus. rewrite (I2 Hus). specialize (R2 Hus).
      destruct (Rlt_dec u r), (Rlt_dec s r); tauto.
    + intros Hne [j [Hj|Hj]]; [inversion Hj; subst; apply (R3 Hne); reflexivity|].
      apply (I3 Hne). exists j. assumption.
Qed.

Lemma ahead_all l s : (forall r k, In (r, k) l -> s < r) -> ahead l s = total l.
Proof.
  induction l as [|[r k] l IH]; intros H; [reflexivity|]. simpl.
  rewrite IH by (intros; eapply H; right; eassumption).
  destruct (Rlt_dec s r) as [|N]; [reflexivity|]. exfalso. apply N, (H r k). left. reflexivity.
Qed.
Lemma ahead_none l : exists m, forall s, m <= s -> ahead l s = 0%Z.
Proof.
  induction l as [|[r k] l [m IH]]; [exists 0; reflexivity|].
  exists (Rmax m r). intros s Hs. pose proof (Rmax_l m r). pose proof (Rmax_r m r). simpl.
  rewrite IH by lra. destruct (Rlt_dec s r); [lra|reflexivity].
Qed.
Lemma jump_none l s : ~ is_crossing l s -> jump l s = 0%Z.
Proof.
  induction l as [|[r k] l IH]; intros H; [reflexivity|]. simpl. rewrite IH.
  - destruct (Req_EM_T s r) as [->|]; [|reflexivity]. exfalso. apply H. exists k. left. reflexivity.
  - intros [j Hj]. apply H. exists j. right. assumption.
Qed.
Lemma jump_app l m s : jump (l ++ m) s = (jump l s + jump m s)%Z.
Proof. induction l as [|[r k] l IH]; simpl; [reflexivity|]. rewrite IH. lia. Qed.

(* ------------------------------------------------------------------ a ray in space *)
Section Ray.
Context {d : nat} {F : list facet} {A : set (S d)}.
Hypothesis HL : legal F A.

Definition along (y : point (S d)) (s : R) : point (S d) :=
  fun i => y i + Fin.caseS' i (fun _ => R) s (fun _ => 0).

Definition missed (f : facet) (y : point (S d)) : Prop := forall s, 0 <= s -> ~ on f (along y s).
Definition crossed (f : facet) (y : point (S d)) (k : Z) (r : R) : Prop :=
  0 < r /\ inner f (along y r) /\ (k = 1 \/ k = -1)%Z /\
  exists n, signed k n /\ forall s, zvalue (plane f) (along y s) = n * (s - r).

Inductive crossings (y : point (S d)) : list facet -> crossing_list -> Prop :=
| crossings_none : crossings y [] []
| crossings_missed f G l : missed f y -> crossings y G l -> crossings y (f :: G) l
| crossings_crossed f G l k r : crossed f y k r -> crossings y G l -> crossings y (f :: G) ((r, k) :: l).

Lemma near_along y s u e : e > 0 -> Rabs (u - s) < e -> near (along y s) e (along y u).
Proof.
  intros He Hu i. unfold along. apply (Fin.caseS' i (fun i =>
    Rabs (y i + Fin.caseS' i (fun _ => R) u (fun _ => 0) - (y i + Fin.caseS' i (fun _ => R) s (fun _ => 0))) < e)).
  - simpl. replace (y Fin.F1 + u - (y Fin.F1 + s)) with (u - s) by ring. assumption.
  - intros j. simpl. replace (y (Fin.FS j) + 0 - (y (Fin.FS j) + 0)) with 0 by ring. rewrite Rabs_R0. lra.
Qed.

Lemma crossed_once f y k r s : crossed f y k r -> on f (along y s) -> s = r.
Proof.
  intros (_ & _ & Hk & n & Hn & Hv) [Ho _]. rewrite Hv in Ho.
  apply Rmult_integral in Ho. destruct Hk; subst; simpl in Hn; destruct Ho; lra.
Qed.

Lemma crossings_on y G l s f : crossings y G l -> 0 <= s -> In f G -> on f (along y s) -> is_crossing l s.
Proof.
  intros Hc Hs. induction Hc as [|g G l Hm Hc IH|g G l k r Hk Hc IH]; intros Hf Ho; [destruct Hf|..].
  - destruct Hf as [<-|Hf]; [exfalso; exact (Hm s Hs Ho)|auto].
  - destruct Hf as [<-|Hf].
    + rewrite (crossed_once _ _ _ _ _ Hk Ho). exists k. left. reflexivity.
    + destruct (IH Hf Ho) as [j Hj]. exists j. right. assumption.
Qed.

Lemma crossings_inner y G l s : crossings y G l -> is_crossing l s -> exists f, In f G /\ inner f (along y s).
Proof.
  intros Hc. induction Hc as [|g G l Hm Hc IH|g G l k r Hk Hc IH]; intros [j Hj]; [destruct Hj|..].
  - destruct IH as (f & Hf & Hi); [exists j; assumption|]. exists f. split; [right|]; assumption.
  - destruct Hj as [Hj|Hj].
    + inversion Hj; subst. exists g. split; [left; reflexivity|apply Hk].
    + destruct IH as (f & Hf & Hi); [exists j; assumption|]. exists f. split; [right|]; assumption.
Qed.

Lemma crossings_split y G l s : crossings y G l -> is_crossing l s ->
  exists G1 f G2 l1 k l2, G = G1 ++ f :: G2 /\ l = l1 ++ (s, k) :: l2 /\ crossed f y k s /\
    crossings y G1 l1 /\ crossings y G2 l2.
Proof.
  intros Hc. induction Hc as [|g G l Hm Hc IH|g G l k r Hk Hc IH]; intros [j Hj]; [destruct Hj|..].
  - destruct IH as (G1 & f & G2 & l1 & k & l2 & -> & -> & K1 & K2 & K3); [exists j; assumption|].
    exists (g :: G1), f, G2, l1, k, l2.
    split; [reflexivity|]. split; [reflexivity|]. split; [assumption|]. split; [constructor|]; assumption.
  - destruct Hj as [Hj|Hj].
    + inversion Hj; subst. exists [], g, G, [], j, l.
      split; [reflexivity|]. split; [reflexivity|]. split; [assumption|]. split; [constructor|assumption].
    + destruct IH as (G1 & f & G2 & l1 & k' & l2 & -> & -> & K1 & K2 & K3); [exists j; assumption|].
      exists (g :: G1), f, G2, ((r, k) :: l1), k', l2.
      split; [reflexivity|]. split; [reflexivity|]. split; [assumption|]. split; [constructor|]; assumption.
Qed.

Lemma inner_on (f : facet) (x : point (S d)) : inner f x -> on f x.
Proof. intros [H K]. split; [assumption|]. intros g Hg. left. auto. Qed.

Lemma apart_split G1 f G2 g (x : point (S d)) :
  ForallOrdPairs (fun f g => forall x : point (S d), ~ (inner f x /\ inner g x)) (G1 ++ f :: G2) ->
  In g (G1 ++ G2) -> inner f x -> inner g x -> False.
Proof.
  intros H Hg Hf Hi. induction G1 as [|h G1 IH]; simpl in *.
  - inversion H as [|a l Ha Hr]; subst. rewrite Forall_forall in Ha. exact (Ha g Hg x (conj Hf Hi)).
  - inversion H as [|a l Ha Hr]; subst. destruct Hg as [<-|Hg]; [|auto].
    rewrite Forall_forall in Ha. apply (Ha f) with x; [apply in_or_app; right; left; reflexivity|tauto].
Qed.

(* The state as a number. *)
Definition counts (x : point (S d)) (v : Z) : Prop :=
  (v = 1%Z /\ interior A x) \/ (v = 0%Z /\ interior (complement A) x).

Lemma counts_functional x v w : counts x v -> counts x w -> v = w.
Proof.
  intros [[-> H]|[-> H]] [[-> K]|[-> K]]; try reflexivity; exfalso.
  - exact (interior_in _ _ K (interior_in _ _ H)).
  - exact (interior_in _ _ H (interior_in _ _ K)).
Qed.

Section Line.
Variables (y : point (S d)) (l : crossing_list).
Hypothesis HC : crossings y F l.

Lemma local s : 0 <= s -> exists e k, e > 0 /\ forall u, 0 <= u -> Rabs (u - s) < e -> ~ is_crossing l u ->
  counts (along y u) (ahead l u + k)%Z.
Proof.
  intros Hs. destruct (ahead_near l s) as (e & He & Hl). destruct (classic (is_crossing l s)) as [Hx|Hx].
  - destruct (crossings_split _ _ _ _ HC Hx) as (G1 & f & G2 & l1 & k & l2 & EF & El & Hk & H1 & H2).
    assert (forall g, In g (G1 ++ G2) -> ~ inner g (along y s)) as Hni.
    { intros g Hg Hi. pose proof (legal_apart HL) as Ha. rewrite EF in Ha.
      apply (apart_split _ _ _ g (along y s) Ha Hg); [apply Hk|assumption]. }
    assert (forall m G, crossings y G m -> (forall g, In g G -> In g (G1 ++ G2)) -> ~ is_crossing m s) as Hno.
    { intros m G Hm Hin Hc. destruct (crossings_inner _ _ _ _ Hm Hc) as (g & Hg & Hi).
      exact (Hni g (Hin g Hg) Hi). }
    assert (jump l s = k) as Hj.
    { rewrite El, jump_app. simpl. rewrite !jump_none.
      - destruct (Req_EM_T s s); [lia|congruence].
      - apply (Hno l2 G2); [assumption|]. intros g Hg. apply in_or_app. auto.
      - apply (Hno l1 G1); [assumption|]. intros g Hg. apply in_or_app. auto. }
    destruct (legal_sides HL G1 f G2 (along y s) EF) as (f' & Hf' & Hside).
    + apply Hk.
    + intros g Hg Ho. apply in_app_or in Hg. destruct Hg as [Hg|Hg].
      * apply (Hno l1 G1 H1); [intros; apply in_or_app; auto|]. exact (crossings_on _ _ _ _ _ H1 Hs Hg Ho).
      * apply (Hno l2 G2 H2); [intros; apply in_or_app; auto|]. exact (crossings_on _ _ _ _ _ H2 Hs Hg Ho).
    + destruct Hk as (_ & _ & Hk & n & Hn & Hv).
      exists (Rmin e f'), ((if Z.eqb k 1 then 0 else 1) - ahead l s)%Z.
      split; [apply Rmin_pos; assumption|]. intros u Hu Hus Hc.
      pose proof (Rmin_l e f'). pose proof (Rmin_r e f').
      destruct (Hl u ltac:(lra)) as (A1 & A2 & _).
      destruct (Hside (along y u)) as [Sin Sout]; [apply near_along; lra|].
      rewrite Hv in Sin, Sout.
      assert (u <> s) as Hne by (intros ->; contradiction).
      destruct (Rtotal_order u s) as [L|[L|L]]; [|congruence|].
      * rewrite (A1 L), Hj. destruct Hk as [-> | ->]; cbn [signed Z.eqb Pos.eqb] in Hn |- *.
        -- left. split; [lia|]. apply Sin.
           pose proof (Rmult_lt_compat_l n u s Hn L). lra.
        -- right. split; [lia|]. apply Sout.
           pose proof (Rmult_lt_compat_l (- n) u s ltac:(lra) L). lra.
      * rewrite (A2 ltac:(lra)). destruct Hk as [-> | ->]; cbn [signed Z.eqb Pos.eqb] in Hn |- *.
        -- right. split; [lia|]. apply Sout.
           pose proof (Rmult_lt_compat_l n s u Hn L). lra.
        -- left. split; [lia|]. apply Sin.
           pose proof (Rmult_lt_compat_l (- n) s u ltac:(lra) L). lra.
  - assert (forall f, In f F -> ~ on f (along y s)) as Hoff.
    { intros f Hf Ho. apply Hx. exact (crossings_on _ _ _ _ _ HC Hs Hf Ho). }
    assert (exists v, counts (along y s) v) as [v Hv].
    { destruct (state_off HL _ Hoff) as [H|H]; [exists 1%Z; left|exists 0%Z; right]; auto. }
    assert (exists f, f > 0 /\ forall u, Rabs (u - s) < f -> counts (along y u) v) as (f & Hf & Hnear).
    { destruct Hv as [[-> H]|[-> H]]; apply interior_open in H; destruct H as (f & Hf & H);
        exists f; (split; [assumption|]); intros u Hu; [left|right]; (split; [reflexivity|]);
        apply H, near_along; assumption. }
    exists (Rmin e f), (v - ahead l s)%Z. split; [apply Rmin_pos; assumption|]. intros u Hu Hus Hc.
    pose proof (Rmin_l e f). pose proof (Rmin_r e f).
    destruct (Hl u ltac:(lra)) as (A1 & A2 & _).
    assert (ahead l u = ahead l s) as ->.
    { destruct (Rlt_le_dec u s) as [L|L]; [rewrite (A1 L), (jump_none _ _ Hx); lia|auto]. }
    replace (ahead l s + (v - ahead l s))%Z with v by lia. apply Hnear. lra.
Qed.

Theorem ray_state : counts y (total l).
Proof.
  assert (forall r k, In (r, k) l -> 0 < r) as Hpos.
  { clear HL. induction HC as [|g G m Hm Hc IH|g G m k r Hk Hc IH]; intros r' k' Hr.
    - destruct Hr.
    - exact (IH Hc r' k' Hr).
    - destruct Hr as [Hr|Hr]; [|exact (IH Hc r' k' Hr)].
      inversion Hr; subst. destruct Hk as [Hk _]. exact Hk. }
  set (P := fun s => exists e, e > 0 /\ forall u, 0 <= u -> Rabs (u - s) < e -> ~ is_crossing l u ->
    counts (along y u) (ahead l u)).
  destruct (ahead_none l) as [m Hm]. destruct (legal_bounded HL) as [b Hb].
  set (L := Rmax (Rmax m 0) (b - y Fin.F1 + 1) + 1).
  assert (m + 1 <= L /\ 1 <= L /\ b - y Fin.F1 + 2 <= L) as (L1 & L2 & L3).
  { unfold L. pose proof (Rmax_l (Rmax m 0) (b - y Fin.F1 + 1)). pose proof (Rmax_r (Rmax m 0) (b - y Fin.F1 + 1)).
    pose proof (Rmax_l m 0). pose proof (Rmax_r m 0). lra. }
  assert (P L) as PL.
  { exists 1. split; [lra|]. intros u Hu Hul _. apply Rabs_def2 in Hul. rewrite Hm by lra. right.
    split; [reflexivity|]. exists 1. split; [lra|]. intros z Hz Hz'. specialize (Hz Fin.F1).
    pose proof (Hb z Hz' Fin.F1) as Hzb. unfold along in Hz. simpl in Hz.
    apply Rabs_def2 in Hz. pose proof (Rle_abs (z Fin.F1)). lra. }
  assert (P 0) as P0.
  { apply (connected P 0 L); [lra| |exact PL]. intros s [Hs _].
    destruct (local s Hs) as (e & k & He & Hlocal).
    assert (forall v, 0 <= v -> Rabs (v - s) < e -> (P v <-> k = 0%Z)) as Hk.
    { intros v Hv Hvs. split.
      - intros (f & Hf & Hp). destruct (ahead_near l v) as (g & Hg & Hfree).
        set (h := Rmin (Rmin f g) (e - Rabs (v - s)) / 2).
        assert (0 < h /\ h < f /\ h < g /\ h < e - Rabs (v - s)) as (H1 & H2 & H3 & H4).
        { assert (0 < Rmin (Rmin f g) (e - Rabs (v - s))) by (repeat apply Rmin_pos; lra).
          pose proof (Rmin_l (Rmin f g) (e - Rabs (v - s))). pose proof (Rmin_r (Rmin f g) (e - Rabs (v - s))).
          pose proof (Rmin_l f g). pose proof (Rmin_r f g). unfold h. lra. }
        assert (Rabs (v + h - v) = h) as Eh by (replace (v + h - v) with h by ring; apply Rabs_right; lra).
        assert (~ is_crossing l (v + h)) as Hno by (apply (Hfree (v + h)); lra).
        assert (Rabs (v + h - s) < e) as Hvh.
        { replace (v + h - s) with (h + (v - s)) by ring. eapply Rle_lt_trans; [apply Rabs_triang|].
          rewrite (Rabs_right h); lra. }
        pose proof (counts_functional _ _ _ (Hp (v + h) ltac:(lra) ltac:(lra) Hno)
          (Hlocal (v + h) ltac:(lra) Hvh Hno)). lia.
      - intros ->. exists (e - Rabs (v - s)). split; [lra|]. intros u Hu Huv Hno.
        rewrite <- (Z.add_0_r (ahead l u)). apply Hlocal; try assumption.
        replace (u - s) with ((u - v) + (v - s)) by ring. eapply Rle_lt_trans; [apply Rabs_triang|]. lra. }
    exists e. split; [assumption|]. intros u Hu Hus. rewrite (Hk u ltac:(lra) Hus). symmetry. apply Hk; [assumption|].
    replace (s - s) with 0 by ring. rewrite Rabs_R0. assumption. }
  destruct P0 as (e & He & Hp).
  assert (counts (along y 0) (ahead l 0)) as K.
  { apply Hp; [lra|replace (0 - 0) with 0 by ring; rewrite Rabs_R0; assumption|].
    intros [k Hk]. apply Hpos in Hk. lra. }
  rewrite (ahead_all l 0 Hpos) in K.
  assert (forall x, interior x (along y 0) -> interior x y) as Hsame.
  { intros x (f & Hf & Hx). exists f. split; [assumption|]. intros z Hz. apply Hx. intros i.
    specialize (Hz i). unfold along. replace (y i + Fin.caseS' i (fun _ => R) 0 (fun _ => 0)) with (y i); [assumption|].
    apply (Fin.caseS' i (fun i => y i = y i + Fin.caseS' i (fun _ => R) 0 (fun _ => 0))); intros; simpl; ring. }
  destruct K as [[E K]|[E K]]; [left|right]; split; auto.
Qed.
End Line.
End Ray.
