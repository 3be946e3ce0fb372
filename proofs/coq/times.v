(* From states at times to the word: what the word of a trace is, over the reals.
   SPDX-License-Identifier: GPL-3.0-or-later

   [trace]          the states at each time, as a relation
   [is_word]        w is the word of a trace on [a, b]: some m tells for each time which letter of w
                    is being walked, forwards, leaving none out, and neighbours in w differ
   [word_unique]    there is at most one word (the choice of cuts has no say)
   [letter_times]   two times walk the same letter iff the state is constant between them: the
                    letters are the maximal intervals of one state, the B's the contacts
   [letters_met], [first_met], [last_met]  the letters are the states met, the ends' among them
   [contact_closed]   the times of a letter B are a closed interval, if those of I and O are open
   [word_admissible]  if the times of I and those of O are open, the word is admissible
   [word_of_cuts]   finitely many instants with constant states between them have a word
   [word_joined], [word_reversed], [word_reparametrised]  claim C17 *)
Require Import Reals Lra Lia List Arith Bool Classical.
Require Import Graze.words.
Import ListNotations.
Open Scope R_scope.

Definition trace := R -> state -> Prop.

Definition functional (s : trace) (a b : R) : Prop :=
  forall t x y, a <= t <= b -> s t x -> s t y -> x = y.

Definition open_in (s : trace) (a b : R) (x : state) : Prop :=
  forall t, a <= t <= b -> s t x ->
  exists d, d > 0 /\ forall u, a <= u <= b -> Rabs (u - t) < d -> s u x.

Fixpoint stutter_free (w : word) : Prop :=
  match w with
  | x :: ((y :: _) as rest) => x <> y /\ stutter_free rest
  | _ => True
  end.

Definition walks (s : trace) (a b : R) (w : word) (m : R -> nat) : Prop :=
  (forall t, a <= t <= b -> exists x, nth_error w (m t) = Some x /\ s t x) /\
  (forall t u, a <= t -> t <= u -> u <= b -> (m t <= m u)%nat) /\
  (forall j, (j < length w)%nat -> exists t, a <= t <= b /\ m t = j).

Definition is_word (s : trace) (a b : R) (w : word) : Prop :=
  a <= b /\ stutter_free w /\ exists m, walks s a b w m.

(* ------------------------------------------------------------------ one word *)
Lemma stutter_free_nth w : stutter_free w <->
  forall j x y, nth_error w j = Some x -> nth_error w (S j) = Some y -> x <> y.
Proof.
  induction w as [|a w IH].
  - simpl. split; [|tauto]. intros _ [|j] x y Hx; discriminate.
  - destruct w as [|b w].
    + simpl. split; [|tauto]. intros _ [|[|j]] x y Hx Hy; discriminate.
    + change (stutter_free (a :: b :: w)) with (a <> b /\ stutter_free (b :: w)). rewrite IH.
      split.
      * intros [Hab H] [|j] x y Hx Hy; [simpl in *; congruence|]. exact (H j x y Hx Hy).
      * intros H. split; [apply (H 0%nat); reflexivity|]. intros j x y. apply (H (S j)).
Qed.

Lemma walk_behind s a b w m v n : functional s a b -> stutter_free v ->
  walks s a b w m -> walks s a b v n -> forall t, a <= t <= b -> (n t <= m t)%nat.
Proof.
  intros Hf Hv (Hw1 & Hw2 & Hw3) (Hv1 & Hv2 & Hv3). rewrite stutter_free_nth in Hv.
  enough (forall j t, a <= t <= b -> n t = j -> (j <= m t)%nat) as H by (intros t Ht; eapply H; eauto).
  induction j as [|j IH]; intros t Ht Hj; [lia|].
  destruct (Hv1 t Ht) as (y & Hy & Hsy). rewrite Hj in Hy.
  assert (S j < length v)%nat by (apply nth_error_Some; congruence).
  destruct (Hv3 j ltac:(lia)) as (u & Hu & Hnu).
  assert (u < t) by (destruct (Rlt_le_dec u t) as [|Hc]; [assumption|];
    pose proof (Hv2 t u ltac:(lra) Hc ltac:(lra)); lia).
  pose proof (IH u Hu Hnu) as Hmu. pose proof (Hw2 u t ltac:(lra) ltac:(lra) ltac:(lra)) as Hm.
  destruct (Hv1 u Hu) as (x & Hx & Hsx). rewrite Hnu in Hx.
  enough (m u <> m t) by lia. intros He.
  destruct (Hw1 t Ht) as (p & Hp & Hsp). destruct (Hw1 u Hu) as (q & Hq & Hsq).
  rewrite He in Hq. apply (Hv j x y Hx Hy).
  rewrite (Hf u x q Hu Hsx Hsq), (Hf t y p Ht Hsy Hsp). congruence.
Qed.

Lemma nth_error_same {A} : forall u v : list A,
  (forall j, nth_error u j = nth_error v j) -> u = v.
Proof.
  induction u as [|x u IH]; intros [|y v] H; [reflexivity|..].
  - discriminate (H 0%nat).
  - discriminate (H 0%nat).
  - pose proof (H 0%nat) as H0. simpl in H0. inversion H0; subst. f_equal.
    apply IH. intros j. apply (H (S j)).
Qed.

Theorem word_unique s a b v w :
  functional s a b -> is_word s a b v -> is_word s a b w -> v = w.
Proof.
  intros Hf (Hab & Hv & n & Wn) (_ & Hw & m & Wm).
  assert (forall t, a <= t <= b -> n t = m t) as Heq.
  { intros t Ht. apply Nat.le_antisymm;
      [apply (walk_behind s a b w m v n)|apply (walk_behind s a b v n w m)]; assumption. }
  destruct Wn as (Hn1 & _ & Hn3), Wm as (Hm1 & _ & Hm3).
  apply nth_error_same. intros j.
  destruct (lt_dec j (length v)) as [Hj|Hj].
  - destruct (Hn3 j Hj) as (t & Ht & <-).
    destruct (Hn1 t Ht) as (x & Hx & Hsx), (Hm1 t Ht) as (y & Hy & Hsy).
    rewrite <- (Heq t Ht) in Hy. rewrite Hx, Hy, (Hf t x y Ht Hsx Hsy). reflexivity.
  - destruct (lt_dec j (length w)) as [Hk|Hk].
    + destruct (Hm3 j Hk) as (t & Ht & <-). rewrite <- (Heq t Ht) in Hj.
      destruct (Hn1 t Ht) as (x & Hx & _). exfalso. apply Hj, nth_error_Some. congruence.
    + rewrite (proj2 (nth_error_None v j)), (proj2 (nth_error_None w j)) by lia. reflexivity.
Qed.

(* ------------------------------------------------------------------ what letters are *)
Theorem letter_times s a b w m : functional s a b -> stutter_free w -> walks s a b w m ->
  forall t u, a <= t -> t <= u -> u <= b ->
  (m t = m u <-> exists x, forall v, t <= v <= u -> s v x).
Proof.
  intros Hf Hw (H1 & H2 & H3) t u Ht Htu Hu. split.
  - intros He. destruct (H1 t ltac:(lra)) as (x & Hx & Hsx). exists x. intros v Hv.
    destruct (H1 v ltac:(lra)) as (y & Hy & Hsy).
    pose proof (H2 t v ltac:(lra) ltac:(lra) ltac:(lra)).
    pose proof (H2 v u ltac:(lra) ltac:(lra) ltac:(lra)).
    replace (m v) with (m t) in Hy by lia. congruence.
  - intros (x & Hx). destruct (Nat.eq_dec (m t) (m u)) as [|Hne]; [assumption|exfalso].
    pose proof (H2 t u Ht Htu Hu). rewrite stutter_free_nth in Hw.
    destruct (H1 t ltac:(lra)) as (y & Hy & Hsy), (H1 u ltac:(lra)) as (z & Hz & _).
    assert (m u < length w)%nat by (apply nth_error_Some; congruence).
    destruct (H3 (S (m t)) ltac:(lia)) as (v & Hv & Hmv).
    assert (t < v) by (destruct (Rlt_le_dec t v) as [|Hc]; [assumption|];
      pose proof (H2 v t ltac:(lra) Hc ltac:(lra)); lia).
    destruct (Rle_lt_dec v u) as [Hvu|Hvu].
    + destruct (H1 v Hv) as (q & Hq & Hsq). rewrite Hmv in Hq. apply (Hw _ _ _ Hy Hq).
      rewrite (Hf t y x ltac:(lra) Hsy (Hx t ltac:(lra))).
      rewrite (Hf v q x Hv Hsq (Hx v ltac:(lra))). reflexivity.
    + pose proof (H2 u v ltac:(lra) ltac:(lra) ltac:(lra)).
      assert (m u = S (m t)) as Hmu by lia. rewrite Hmu in Hz. apply (Hw _ _ _ Hy Hz).
      destruct (H1 u ltac:(lra)) as (q & Hq & Hsq). rewrite Hmu in Hq.
      rewrite (Hf t y x ltac:(lra) Hsy (Hx t ltac:(lra))).
      assert (q = x) by (apply (Hf u q x ltac:(lra) Hsq (Hx u ltac:(lra)))). congruence.
Qed.

Theorem letters_met s a b w x : functional s a b -> is_word s a b w ->
  (In x w <-> exists t, a <= t <= b /\ s t x).
Proof.
  intros Hf (Hab & _ & m & H1 & _ & H3). split.
  - intros Hx. apply In_nth_error in Hx. destruct Hx as [j Hj].
    destruct (H3 j) as (t & Ht & <-); [apply nth_error_Some; congruence|].
    exists t. split; [assumption|]. destruct (H1 t Ht) as (y & Hy & Hs). congruence.
  - intros (t & Ht & Hs). destruct (H1 t Ht) as (y & Hy & Hsy).
    rewrite (Hf t x y Ht Hs Hsy). eapply nth_error_In; eassumption.
Qed.

Lemma word_length s a b w m : a <= b -> walks s a b w m ->
  (0 < length w)%nat /\ m a = 0%nat /\ m b = (length w - 1)%nat.
Proof.
  intros Hab (H1 & H2 & H3).
  assert (0 < length w)%nat as Hw.
  { destruct (H1 a ltac:(lra)) as (x & Hx & _). destruct w; [|simpl; lia].
    destruct (m a); discriminate. }
  split; [assumption|]. split.
  - destruct (H3 0%nat Hw) as (t & Ht & Hm).
    pose proof (H2 a t ltac:(lra) ltac:(lra) ltac:(lra)). lia.
  - destruct (H3 (length w - 1)%nat ltac:(lia)) as (t & Ht & Hm).
    pose proof (H2 t b ltac:(lra) ltac:(lra) ltac:(lra)).
    destruct (H1 b ltac:(lra)) as (x & Hx & _).
    assert (m b < length w)%nat by (apply nth_error_Some; congruence). lia.
Qed.

Lemma nth_error_last {A} (w : list A) (d x : A) :
  nth_error w (length w - 1) = Some x -> last w d = x.
Proof.
  induction w as [|a [|b w] IH]; simpl in *; intros H; try congruence.
  rewrite Nat.sub_0_r in IH. apply IH. assumption.
Qed.

Theorem first_met s a b w : is_word s a b w -> s a (first w).
Proof.
  intros (Hab & _ & m & W). destruct (word_length _ _ _ _ _ Hab W) as (_ & Hm & _).
  destruct W as (H1 & _). destruct (H1 a ltac:(lra)) as (x & Hx & Hs). rewrite Hm in Hx.
  destruct w; simpl in *; congruence.
Qed.

Theorem last_met s a b w : is_word s a b w -> s b (last_of w).
Proof.
  intros (Hab & _ & m & W). destruct (word_length _ _ _ _ _ Hab W) as (_ & _ & Hm).
  destruct W as (H1 & _). destruct (H1 b ltac:(lra)) as (x & Hx & Hs). rewrite Hm in Hx.
  unfold last_of. rewrite (nth_error_last _ O x Hx). assumption.
Qed.

(* ------------------------------------------------------------------ admissible *)
(* Where the walk steps from letter j to the next. *)
Lemma step_time s a b w m j : walks s a b w m -> (S j < length w)%nat ->
  exists T, a <= T <= b /\ (forall t, a <= t -> t < T -> (m t <= j)%nat) /\
            (forall t, T < t -> t <= b -> (S j <= m t)%nat).
Proof.
  intros (H1 & H2 & H3) Hj.
  destruct (H3 j ltac:(lia)) as (s0 & Hs0 & Hm0).
  destruct (completeness (fun t => a <= t <= b /\ (m t <= j)%nat)) as [T [HT1 HT2]].
  - exists b. intros t [Ht _]. lra.
  - exists s0. split; [assumption|lia].
  - assert (a <= T <= b) as HT.
    { split; [apply Rle_trans with s0; [lra|apply HT1; split; [assumption|lia]]|].
      apply HT2. intros t [Ht _]. lra. }
    exists T. split; [assumption|]. split.
    + intros t Hat HtT. destruct (le_lt_dec (m t) j) as [|Hc]; [assumption|exfalso].
      apply (Rlt_not_le _ _ HtT), HT2. intros u [Hu Hmu].
      destruct (Rle_lt_dec u t) as [|Hd]; [assumption|].
      pose proof (H2 t u Hat ltac:(lra) ltac:(lra)). lia.
    + intros t HTt Htb. destruct (le_lt_dec (m t) j) as [Hc|Hc]; [exfalso|lia].
      apply (Rlt_not_le _ _ HTt), HT1. split; [lra|assumption].
Qed.

Lemma open_letters_apart s a b w m j x y : functional s a b -> walks s a b w m ->
  nth_error w j = Some x -> nth_error w (S j) = Some y ->
  open_in s a b x -> open_in s a b y -> x = y.
Proof.
  intros Hf W Hx Hy Ox Oy.
  assert (S j < length w)%nat as Hj by (apply nth_error_Some; congruence).
  destruct (step_time s a b w m j W Hj) as (T & HT & Hl & Hr). destruct W as (H1 & H2 & H3).
  destruct (H3 j ltac:(lia)) as (p & Hp & Hmp), (H3 (S j) Hj) as (q & Hq & Hmq).
  assert (p <= T) as HpT by (destruct (Rle_lt_dec p T) as [|Hc]; [assumption|];
    pose proof (Hr p Hc ltac:(lra)); lia).
  assert (T <= q) as HTq by (destruct (Rle_lt_dec T q) as [|Hc]; [assumption|];
    pose proof (Hl q ltac:(lra) Hc); lia).
  assert (forall t k z, a <= t <= b -> m t = k -> nth_error w k = Some z -> s t z) as Hz.
  { intros t k z Ht Hk Hz. destruct (H1 t Ht) as (v & Hv & Hs). congruence. }
  destruct (le_lt_dec (m T) j) as [Hc|Hc].
  - pose proof (H2 p T ltac:(lra) HpT ltac:(lra)).
    assert (s T x) as HsT by (apply (Hz T j); [assumption|lia|assumption]).
    destruct (Ox T HT HsT) as (d & Hd & Hs).
    assert (T < q) by (destruct HTq as [|<-]; [assumption|lia]).
    set (t := Rmin (T + d / 2) q).
    assert (T < t <= q /\ t <= T + d / 2) as Ht by (unfold t, Rmin; destruct Rle_dec; lra).
    apply (Hf t); [lra|apply Hs; [lra|rewrite Rabs_right; lra]|].
    apply (Hz t (S j)); [lra| |assumption].
    pose proof (Hr t ltac:(lra) ltac:(lra)). pose proof (H2 t q ltac:(lra) ltac:(lra) ltac:(lra)). lia.
  - pose proof (H2 T q ltac:(lra) HTq ltac:(lra)).
    assert (s T y) as HsT by (apply (Hz T (S j)); [assumption|lia|assumption]).
    destruct (Oy T HT HsT) as (d & Hd & Hs).
    assert (p < T) by (destruct HpT as [| ->]; [assumption|lia]).
    set (t := Rmax (T - d / 2) p).
    assert (p <= t < T /\ T - d / 2 <= t) as Ht by (unfold t, Rmax; destruct Rle_dec; lra).
    apply (Hf t); [lra| |apply Hs; [lra|rewrite Rabs_left; lra]].
    apply (Hz t j); [lra| |assumption].
    pose proof (Hl t ltac:(lra) ltac:(lra)). pose proof (H2 p t ltac:(lra) ltac:(lra) ltac:(lra)). lia.
Qed.

Lemma linked_nth w :
  (forall j x y, nth_error w j = Some x -> nth_error w (S j) = Some y -> neighbours x y = true) ->
  linked w = true.
Proof.
  induction w as [|a [|b w] IH]; intros H; [reflexivity..|].
  change (neighbours a b && linked (b :: w) = true). rewrite IH.
  - rewrite (H 0%nat a b); reflexivity.
  - intros j. apply (H (S j)).
Qed.

Theorem word_admissible s a b w : functional s a b -> open_in s a b I -> open_in s a b O ->
  is_word s a b w -> admissible w.
Proof.
  intros Hf HI HO (Hab & Hw & m & W). split.
  - pose proof (word_length _ _ _ _ _ Hab W) as (Hl & _). destruct w; [simpl in Hl; lia|discriminate].
  - apply linked_nth. intros j x y Hx Hy.
    pose proof (proj1 (stutter_free_nth w) Hw j x y Hx Hy) as Hne.
    pose proof (open_letters_apart s a b w m j x y Hf W Hx Hy) as Ho.
    destruct x, y; try reflexivity; exfalso; auto.
Qed.

(* The times of a letter between open ones are closed: its ends belong to it. *)
Theorem contact_closed s a b w m j : functional s a b -> open_in s a b I -> open_in s a b O ->
  a <= b -> stutter_free w -> walks s a b w m -> nth_error w j = Some B ->
  exists u v, u <= v /\ forall t, a <= t <= b -> (m t = j <-> u <= t <= v).
Proof.
  intros Hf HI HO Hab Hw W Hj.
  assert (j < length w)%nat as Hjl by (apply nth_error_Some; congruence).
  assert (exists v, a <= v <= b /\ m v = j /\ forall t, v < t -> t <= b -> m t <> j) as (v & Hv & Hmv & Hafter).
  { destruct (lt_dec (S j) (length w)) as [Hs|Hs].
    - destruct (step_time s a b w m j W Hs) as (T & HT & Hl & Hr).
      exists T. split; [assumption|]. split; [|intros t Ht Htb; pose proof (Hr t Ht Htb); lia].
      destruct W as (H1 & H2 & H3), (H3 j Hjl) as (p & Hp & Hmp).
      assert (p <= T) as HpT by (destruct (Rle_lt_dec p T) as [|Hc]; [assumption|];
        pose proof (Hr p Hc ltac:(lra)); lia).
      pose proof (H2 p T ltac:(lra) HpT ltac:(lra)) as Hge.
      destruct HpT as [HpT| ->]; [|assumption].
      destruct (Nat.eq_dec (m T) j) as [|Hne]; [assumption|exfalso].
      destruct (nth_error w (S j)) as [y|] eqn:Hy; [|apply nth_error_None in Hy; lia].
      assert (m T = S j) as HmT.
      { destruct (H3 (S j) Hs) as (q & Hq & Hmq). destruct (Rle_lt_dec T q) as [Hc|Hc].
        - pose proof (H2 T q ltac:(lra) Hc ltac:(lra)). lia.
        - pose proof (Hl q ltac:(lra) Hc). lia. }
      assert (open_in s a b y) as Oy.
      { pose proof (proj1 (stutter_free_nth w) Hw j B y Hj Hy). destruct y; try assumption; congruence. }
      destruct (H1 T HT) as (z & Hz & Hsz). rewrite HmT, Hy in Hz. inversion Hz; subst z.
      destruct (Oy T HT Hsz) as (d & Hd & Hn).
      set (t := Rmax (T - d / 2) p).
      assert (p <= t < T /\ T - d / 2 <= t) as Ht by (unfold t, Rmax; destruct Rle_dec; lra).
      pose proof (Hl t ltac:(lra) ltac:(lra)). pose proof (H2 p t ltac:(lra) ltac:(lra) ltac:(lra)).
      destruct (H1 t ltac:(lra)) as (z & Hz' & Hsz'). replace (m t) with j in Hz' by lia.
      assert (z = y) by (apply (Hf t); [lra|assumption|apply Hn; [lra|rewrite Rabs_left; lra]]).
      apply (proj1 (stutter_free_nth w) Hw j B y Hj Hy). congruence.
    - destruct (word_length s a b w m Hab W) as (_ & _ & Hb).
      exists b. split; [lra|]. split; [lia|]. intros t Ht Htb. lra. }
  assert (exists u, a <= u <= b /\ m u = j /\ forall t, a <= t -> t < u -> m t <> j) as (u & Hu & Hmu & Hbefore).
  { destruct j as [|j].
    - destruct (word_length s a b w m Hab W) as (_ & Ha & _).
      exists a. split; [lra|]. split; [assumption|]. intros t Ht Htb. lra.
    - destruct (step_time s a b w m j W Hjl) as (T & HT & Hl & Hr).
      exists T. split; [assumption|]. split; [|intros t Ht Htb; pose proof (Hl t Ht Htb); lia].
      destruct W as (H1 & H2 & H3), (H3 (S j) Hjl) as (p & Hp & Hmp).
      assert (T <= p) as HpT by (destruct (Rle_lt_dec T p) as [|Hc]; [assumption|];
        pose proof (Hl p ltac:(lra) Hc); lia).
      pose proof (H2 T p ltac:(lra) HpT ltac:(lra)) as Hge.
      destruct HpT as [HpT| <-]; [|assumption].
      destruct (Nat.eq_dec (m T) (S j)) as [|Hne]; [assumption|exfalso].
      destruct (nth_error w j) as [y|] eqn:Hy; [|apply nth_error_None in Hy; lia].
      assert (m T = j) as HmT.
      { destruct (H3 j ltac:(lia)) as (q & Hq & Hmq). destruct (Rle_lt_dec q T) as [Hc|Hc].
        - pose proof (H2 q T ltac:(lra) Hc ltac:(lra)). lia.
        - pose proof (Hr q Hc ltac:(lra)). lia. }
      pose proof (proj1 (stutter_free_nth w) Hw j y B Hy Hj) as Hyb.
      assert (open_in s a b y) as Oy by (destruct y; try assumption; congruence).
      destruct (H1 T HT) as (z & Hz & Hsz). rewrite HmT, Hy in Hz. inversion Hz; subst z.
      destruct (Oy T HT Hsz) as (d & Hd & Hn).
      set (t := Rmin (T + d / 2) p).
      assert (T < t <= p /\ t <= T + d / 2) as Ht by (unfold t, Rmin; destruct Rle_dec; lra).
      pose proof (Hr t ltac:(lra) ltac:(lra)). pose proof (H2 t p ltac:(lra) ltac:(lra) ltac:(lra)).
      destruct (H1 t ltac:(lra)) as (z & Hz' & Hsz'). replace (m t) with (S j) in Hz' by lia.
      assert (z = y) by (apply (Hf t); [lra|assumption|apply Hn; [lra|rewrite Rabs_right; lra]]).
      congruence. }
  destruct W as (H1 & H2 & H3). exists u, v. split.
  - apply Rnot_lt_le. intros Hc. exact (Hafter u Hc ltac:(lra) Hmu).
  - intros t Ht. split.
    + intros Hm. split; apply Rnot_lt_le; intros Hc.
      * exact (Hbefore t ltac:(lra) Hc Hm).
      * exact (Hafter t Hc ltac:(lra) Hm).
    + intros Huv. pose proof (H2 u t ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (H2 t v ltac:(lra) ltac:(lra) ltac:(lra)). lia.
Qed.

(* ------------------------------------------------------------------ words put together *)
Lemma stutter_free_app u v : stutter_free u -> stutter_free v -> u <> [] ->
  head_or v None = last_or None u -> stutter_free (u ++ tl v).
Proof.
  intros Hu Hv Hne He. destruct v as [|y v]; [rewrite app_nil_r; assumption|]. simpl in *.
  assert (exists p, u = p ++ [y]) as [p ->].
  { unfold last_or in He. destruct (rev u) as [|z r] eqn:Er; [discriminate|]. simpl in He.
    inversion He; subst. exists (rev r). rewrite <- (rev_involutive u), Er. reflexivity. }
  rewrite <- app_assoc. simpl. clear He Hne.
  induction p as [|x [|z p] IH]; simpl in *; tauto.
Qed.

Theorem word_joined s a b c u v : functional s a c ->
  is_word s a b u -> is_word s b c v -> is_word s a c (u ++ tl v).
Proof.
  intros Hf Wu Wv. pose proof (last_met _ _ _ _ Wu) as Hlast. pose proof (first_met _ _ _ _ Wv) as Hfirst.
  destruct Wu as (Hab & Hu & m & Wm), Wv as (Hbc & Hv & n & Wn).
  destruct (word_length _ _ _ _ _ Hab Wm) as (Lu & _ & Mb).
  destruct (word_length _ _ _ _ _ Hbc Wn) as (Lv & Nb & _).
  assert (first v = last_of u) as He by (apply (Hf b); [lra|assumption..]).
  destruct v as [|y v]; [simpl in Lv; lia|]. simpl in He. subst y. simpl tl.
  assert (nth_error u (length u - 1) = Some (last_of u)) as Hlu.
  { destruct Wm as (H1 & _). destruct (H1 b ltac:(lra)) as (x & Hx & _). rewrite Mb in Hx.
    rewrite Hx. unfold last_of. rewrite (nth_error_last _ O _ Hx). reflexivity. }
  split; [lra|]. split.
  { apply (stutter_free_app u (last_of u :: v)); try assumption.
    - intros ->. simpl in Lu. lia.
    - simpl. unfold last_or. unfold last_of. destruct u as [|z u] using rev_ind; [simpl in Lu; lia|].
      rewrite last_last, rev_app_distr. reflexivity. }
  destruct Wm as (M1 & M2 & M3), Wn as (N1 & N2 & N3).
  exists (fun t => if Rle_dec t b then m t else (length u - 1 + n t)%nat).
  assert (forall t, a <= t <= b -> (m t <= length u - 1)%nat) as Mle.
  { intros t Ht. destruct (M1 t Ht) as (x & Hx & _).
    assert (m t < length u)%nat by (apply nth_error_Some; congruence). lia. }
  split; [|split].
  - intros t Ht. destruct (Rle_dec t b) as [Hle|Hgt].
    + destruct (M1 t ltac:(lra)) as (x & Hx & Hs). exists x. split; [|assumption].
      rewrite nth_error_app1; [assumption|]. apply nth_error_Some. congruence.
    + destruct (N1 t ltac:(lra)) as (x & Hx & Hs). exists x. split; [|assumption].
      destruct (n t) as [|k]; simpl in Hx.
      * inversion Hx; subst. rewrite Nat.add_0_r, nth_error_app1 by lia. assumption.
      * rewrite nth_error_app2 by lia. replace (length u - 1 + S k - length u)%nat with k by lia.
        assumption.
  - intros t t' Ht Htt Ht'. destruct (Rle_dec t b), (Rle_dec t' b); try lra.
    + apply M2; lra.
    + pose proof (Mle t ltac:(lra)). lia.
    + pose proof (N2 t t' ltac:(lra) ltac:(lra) ltac:(lra)). lia.
  - intros j Hj. rewrite app_length in Hj. destruct (lt_dec j (length u)) as [Hl|Hl].
    + destruct (M3 j Hl) as (t & Ht & Hm). exists t. split; [lra|].
      destruct (Rle_dec t b); [assumption|lra].
    + destruct (N3 (j - length u + 1)%nat) as (t & Ht & Hn); [simpl; lia|]. exists t. split; [lra|].
      destruct (Rle_dec t b); [|lia].
      assert (t = b) by lra. subst t. lia.
Qed.

Theorem word_reversed s a b w : is_word s a b w ->
  is_word (fun t => s (- t)) (- b) (- a) (rev w).
Proof.
  intros (Hab & Hw & m & W). pose proof (word_length _ _ _ _ _ Hab W) as (Hl & _).
  destruct W as (H1 & H2 & H3).
  assert (forall j, (j < length w)%nat -> nth_error (rev w) j = nth_error w (length w - 1 - j)) as Hr.
  { clear. induction w as [|x w IH]; intros j Hj; [simpl in Hj; lia|]. simpl rev.
    assert (length (rev w) = length w) as Hl by apply rev_length. simpl length in *.
    destruct (Nat.eq_dec j (length w)) as [->|Hne].
    - rewrite nth_error_app2, Hl, Nat.sub_diag by lia.
      replace (S (length w) - 1 - length w)%nat with 0%nat by lia. reflexivity.
    - rewrite nth_error_app1, IH by lia.
      replace (S (length w) - 1 - j)%nat with (S (length w - 1 - j)) by lia. reflexivity. }
  assert (forall t, a <= t <= b -> (m t < length w)%nat) as Hm.
  { intros t Ht. destruct (H1 t Ht) as (x & Hx & _). apply nth_error_Some. congruence. }
  split; [lra|]. split.
  - rewrite stutter_free_nth in Hw |- *. intros j x y Hx Hy.
    assert (S j < length w)%nat
      by (rewrite <- rev_length; apply nth_error_Some; congruence).
    rewrite Hr in Hx, Hy by lia. intros ->.
    replace (length w - 1 - j)%nat with (S (length w - 1 - S j)) in Hx by lia.
    exact (Hw _ _ _ Hy Hx eq_refl).
  - exists (fun t => (length w - 1 - m (- t))%nat). split; [|split].
    + intros t Ht. pose proof (Hm (- t) ltac:(lra)).
      rewrite Hr by lia. replace (length w - 1 - (length w - 1 - m (- t)))%nat with (m (- t)) by lia.
      apply H1. lra.
    + intros t u Ht Htu Hu. pose proof (H2 (- u) (- t) ltac:(lra) ltac:(lra) ltac:(lra)). lia.
    + intros j Hj. rewrite rev_length in Hj.
      destruct (H3 (length w - 1 - j)%nat ltac:(lia)) as (t & Ht & Hmt).
      exists (- t). split; [lra|]. rewrite Ropp_involutive. lia.
Qed.

Theorem word_reparametrised s a b c d (f : R -> R) w :
  c <= d -> (forall t u, c <= t -> t <= u -> u <= d -> f t <= f u) ->
  (forall t, c <= t <= d -> a <= f t <= b) ->
  (forall v, a <= v <= b -> exists t, c <= t <= d /\ f t = v) ->
  is_word s a b w -> is_word (fun t => s (f t)) c d w.
Proof.
  intros Hcd Hmono Hin Honto (Hab & Hw & m & H1 & H2 & H3).
  split; [assumption|]. split; [assumption|]. exists (fun t => m (f t)). split; [|split].
  - intros t Ht. apply H1, Hin, Ht.
  - intros t u Ht Htu Hu. pose proof (Hin t ltac:(lra)). pose proof (Hin u ltac:(lra)).
    apply H2; [lra|apply Hmono; assumption|lra].
  - intros j Hj. destruct (H3 j Hj) as (v & Hv & Hm). destruct (Honto v Hv) as (t & Ht & <-).
    exists t. auto.
Qed.

(* ------------------------------------------------------------------ words from cuts *)
(* [cuts s a l b]: instants from a to b, constant states between them; l lists the state at a, in the
   first gap, at the next instant, and so on. *)
Inductive cuts (s : trace) : R -> list state -> R -> Prop :=
| cut_end a p : s a p -> cuts s a [p] a
| cut_gap a b c p x l : a < b -> s a p -> (forall t, a < t < b -> s t x) -> cuts s b l c ->
    cuts s a (p :: x :: l) c.

Fixpoint merged (l : list state) : word :=
  match l with
  | x :: ((y :: _) as rest) => if state_eqb x y then merged rest else x :: merged rest
  | _ => l
  end.

Lemma merged_head l : head_or (merged l) None = head_or l None.
Proof.
  induction l as [|x [|y l] IH]; [reflexivity..|].
  change (head_or (if state_eqb x y then merged (y :: l) else x :: merged (y :: l)) None = Some x).
  destruct (state_eqb x y) eqn:E; [|reflexivity]. apply state_eqb_eq in E. subst. exact IH.
Qed.

Lemma merged_free l : stutter_free (merged l).
Proof.
  induction l as [|x [|y l] IH]; [exact Logic.I..|].
  change (stutter_free (if state_eqb x y then merged (y :: l) else x :: merged (y :: l))).
  destruct (state_eqb x y) eqn:E; [exact IH|].
  pose proof (merged_head (y :: l)) as Hh. destruct (merged (y :: l)) as [|z r]; [discriminate|].
  inversion Hh; subst. split; [|exact IH]. intros ->.
  rewrite (proj2 (state_eqb_eq y y) eq_refl) in E. discriminate.
Qed.

Lemma cuts_head s a l b : cuts s a l b -> exists p r, l = p :: r /\ s a p.
Proof. intros []; eauto. Qed.

Lemma gap_word (s : trace) a b p x q : a < b -> s a p -> (forall t, a < t < b -> s t x) -> s b q ->
  is_word s a b (merged [p; x; q]).
Proof.
  intros Hab Hp Hx Hq. split; [lra|]. split; [apply merged_free|].
  set (i := if state_eqb p x then 0%nat else 1%nat).
  set (j := if state_eqb x q then 0%nat else 1%nat).
  exists (fun t => ((if Req_EM_T t a then 0 else i) + (if Req_EM_T t b then j else 0))%nat).
  split; [|split].
  - intros t Ht. unfold i, j. destruct (Req_EM_T t a), (Req_EM_T t b); subst; try lra;
      [exists p|exists q|exists x];
      (split; [|auto; apply Hx; lra]); destruct p, x, q; reflexivity.
  - intros t u Ht Htu Hu. destruct (Req_EM_T t a), (Req_EM_T t b), (Req_EM_T u a), (Req_EM_T u b);
      subst; try lra; lia.
  - intros k Hk.
    assert (k = 0 \/ k = i \/ k = i + j)%nat as H.
    { unfold i, j. destruct p, x, q; simpl in *; lia. }
    assert (forall t, t = a -> (if Req_EM_T t a then 0 else i) = 0)%nat as Ha
      by (intros t ->; destruct Req_EM_T; congruence).
    destruct H as [->|[->| ->]].
    + exists a. split; [lra|]. destruct (Req_EM_T a a), (Req_EM_T a b); try lra; lia.
    + exists ((a + b) / 2). split; [lra|].
      destruct (Req_EM_T ((a + b) / 2) a), (Req_EM_T ((a + b) / 2) b); try lra; lia.
    + exists b. split; [lra|]. destruct (Req_EM_T b a), (Req_EM_T b b); try lra; lia.
Qed.

Theorem word_of_cuts s a l b : functional s a b -> cuts s a l b -> is_word s a b (merged l).
Proof.
  intros Hf Hc. induction Hc as [a p Hp|a b c p x l Hab Hp Hx Hc IH].
  - split; [lra|]. split; [exact Logic.I|]. exists (fun _ => 0%nat). split; [|split].
    + intros t Ht. exists p. split; [reflexivity|]. replace t with a by lra. assumption.
    + intros; lia.
    + intros j Hj. simpl in Hj. exists a. split; [lra|lia].
  - destruct (cuts_head _ _ _ _ Hc) as (q & r & -> & Hq).
    assert (b <= c) as Hbc.
    { clear - Hc. induction Hc; lra. }
    assert (is_word s b c (merged (q :: r))) as Wr.
    { apply IH. intros t y z Ht. apply Hf. lra. }
    pose proof (word_joined s a b c _ _ Hf (gap_word s a b p x q Hab Hp Hx Hq) Wr) as W.
    replace (merged (p :: x :: q :: r)) with (merged [p; x; q] ++ tl (merged (q :: r))); [exact W|].
    pose proof (merged_head (q :: r)) as Hh.
    change (merged (p :: x :: q :: r)) with
      (let m := if state_eqb x q then merged (q :: r) else x :: merged (q :: r) in
       if state_eqb p x then m else p :: m).
    destruct (merged (q :: r)) as [|z m]; [discriminate|]. inversion Hh; subst z.
    destruct p, x, q; reflexivity.
Qed.
