(* What in, on and out mean in space: the sweep, the unsweep, and the duality.
   SPDX-License-Identifier: GPL-3.0-or-later

   [motion d a b]    maps and their inverses on [a, b], jointly continuous in time and place
   [trace_of]        the states of the inverted trajectory of P against S
   [sweep], [open_sweep]  the union of S^t, of the interiors of S^t
   [trace_admissible]     the word of a trace, if it has one, is admissible
   [in_is], [out_is], [on_is], [on_is_rest]  the answers in, on, out of a word (claims C8, C18)
   [open_sweep_open], [sweep_closed], [sweep_is_closure], [sweep_regular]   claim C18
   [in_inner], [boundary_on]   in lies in int W, the boundary of W in `on` (claim C18)
   [seam]            where the test differs from the classification of W (claim C19, first half)
   [apart_everywhere]  S^0 and S^1 are disjoint iff every P is in cases 1-4, 7 (claim C13)
   [unsweep_in_is], [unsweep_out_is], [unsweep_on_is]   claim C20
   [dual_trace], [dual_set]   claim C21
   [word_moved]   solid, motion and point moved by one map: the same word (claim C17) *)
Require Import Reals Lra Classical List.
Require Import Graze.words Graze.counts Graze.definitions Graze.unsweep Graze.times Graze.space.
Open Scope R_scope.

Definition jointly_continuous {d} (a b : R) (f : R -> point d -> point d) : Prop :=
  forall t x, a <= t <= b -> forall e, e > 0 ->
  exists r, r > 0 /\ forall u y, a <= u <= b -> Rabs (u - t) < r -> near x r y ->
  near (f t x) e (f u y).

Record motion (d : nat) (a b : R) := {
  move : R -> point d -> point d;
  back : R -> point d -> point d;
  ordered : a <= b;
  move_back : forall t x, a <= t <= b -> move t (back t x) = x;
  back_move : forall t x, a <= t <= b -> back t (move t x) = x;
  move_continuous : jointly_continuous a b move;
  back_continuous : jointly_continuous a b back
}.
Arguments move {d a b}. Arguments back {d a b}.
Arguments ordered {d a b}. Arguments move_back {d a b}. Arguments back_move {d a b}.
Arguments move_continuous {d a b}. Arguments back_continuous {d a b}.

(* The motion M^ of the duality. *)
Definition inverse {d a b} (M : motion d a b) : motion d a b :=
  {| move := back M; back := move M; ordered := ordered M;
     move_back := back_move M; back_move := move_back M;
     move_continuous := back_continuous M; back_continuous := move_continuous M |}.

Section Sweep.
Context {d : nat} {a b : R} (M : motion d a b).

Definition image (t : R) (A : set d) : set d := fun P => exists x, A x /\ P = move M t x.
Definition sweep (A : set d) : set d := fun P => exists t, a <= t <= b /\ image t A P.
Definition open_sweep (A : set d) : set d :=
  fun P => exists t, a <= t <= b /\ interior (image t A) P.
Definition unsweep (A : set d) : set d := fun P => forall t, a <= t <= b -> A (move M t P).

Definition trace_of (A : set d) (P : point d) : trace := fun t => state_at A (back M t P).
Definition forward_trace (A : set d) (P : point d) : trace := fun t => state_at A (move M t P).

(* ------------------------------------------------------------------ images *)
Lemma image_back t A P : a <= t <= b -> (image t A P <-> A (back M t P)).
Proof.
  intros Ht. split.
  - intros (x & Hx & ->). rewrite back_move; assumption.
  - intros H. exists (back M t P). split; [assumption|]. rewrite move_back; auto.
Qed.

Lemma image_interior t A P : a <= t <= b -> (interior (image t A) P <-> interior A (back M t P)).
Proof.
  intros Ht. split.
  - intros (e & He & H).
    destruct (move_continuous M t (back M t P) Ht e He) as (r & Hr & K).
    exists r. split; [assumption|]. intros y Hy.
    assert (near (move M t (back M t P)) e (move M t y)) as L.
    { apply K; try assumption. replace (t - t) with 0 by ring. rewrite Rabs_R0. lra. }
    rewrite move_back in L by assumption. apply H in L. apply (image_back t A _ Ht) in L.
    rewrite back_move in L; assumption.
  - intros (e & He & H).
    destruct (back_continuous M t P Ht e He) as (r & Hr & K).
    exists r. split; [assumption|]. intros Q HQ. apply (image_back t A Q Ht), H, K; try assumption.
    replace (t - t) with 0 by ring. rewrite Rabs_R0. lra.
Qed.

Lemma sweep_back A P : sweep A P <-> exists t, a <= t <= b /\ A (back M t P).
Proof.
  split; intros (t & Ht & H); exists t; (split; [assumption|]); apply (image_back t A P Ht), H.
Qed.

Lemma open_sweep_back A P : open_sweep A P <-> exists t, a <= t <= b /\ interior A (back M t P).
Proof.
  split; intros (t & Ht & H); exists t; (split; [assumption|]); apply (image_interior t A P Ht), H.
Qed.

(* ------------------------------------------------------------------ the trace of a point *)
Lemma trace_functional A P : functional (trace_of A P) a b.
Proof. intros t x y _. apply state_functional. Qed.

Lemma open_along (f : R -> point d -> point d) A P s :
  jointly_continuous a b f -> open_set (fun x => state_at A x s) ->
  open_in (fun t => state_at A (f t P)) a b s.
Proof.
  intros Hf Ho t Ht Hs. destruct (Ho _ Hs) as (e & He & H).
  destruct (Hf t P Ht e He) as (r & Hr & K). exists r. split; [assumption|].
  intros u Hu Hut. apply H, K; try assumption. apply near_self, Hr.
Qed.

Theorem trace_admissible A P w : is_word (trace_of A P) a b w -> admissible w.
Proof.
  apply word_admissible; [apply trace_functional|..];
    apply open_along; try apply back_continuous; apply interior_open.
Qed.

Theorem forward_admissible A P w : is_word (forward_trace A P) a b w -> admissible w.
Proof.
  apply word_admissible; [intros t x y _; apply state_functional|..];
    apply open_along; try apply move_continuous; apply interior_open.
Qed.

(* ------------------------------------------------------------------ the sweep *)
Theorem open_sweep_open A : open_set (open_sweep A).
Proof.
  intros P (t & Ht & H). apply interior_open in H. revert H. apply interior_mono.
  intros Q HQ. exists t. auto.
Qed.

Theorem sweep_closed A : closed_set A -> closed_set (sweep A).
Proof.
  intros HA P HP. unfold complement in HP. rewrite sweep_back in HP.
  destruct (uniform_on_interval a b (fun e u => forall Q, near P e Q -> ~ A (back M u Q)))
    as (e & He & H).
  - exact (ordered M).
  - intros e f t H Hfe Q HQ. apply H. eapply near_less; eassumption.
  - intros t Ht.
    assert (complement A (back M t P)) as N by (intros N; apply HP; eauto).
    destruct (HA _ N) as (e & He & H).
    destruct (back_continuous M t P Ht e He) as (r & Hr & K). exists r. split; [assumption|].
    intros u Hu Hut Q HQ. apply H, K; assumption.
  - exists e. split; [assumption|]. intros Q HQ. unfold complement. rewrite sweep_back.
    intros (t & Ht & HA'). exact (H t Ht Q HQ HA').
Qed.

Lemma open_sweep_in A P : open_sweep A P -> sweep A P.
Proof. intros (t & Ht & H). exists t. split; [assumption|]. apply interior_in, H. Qed.

Theorem sweep_is_closure A : regular_closed A -> same (sweep A) (closure (open_sweep A)).
Proof.
  intros HA P. split.
  - rewrite sweep_back. intros (t & Ht & H) e He. apply HA in H.
    destruct (move_continuous M t (back M t P) Ht e He) as (r & Hr & K).
    destruct (H r Hr) as (y & Hy & Hi). exists (move M t y). split.
    + replace P with (move M t (back M t P)) by (apply move_back, Ht).
      apply K; try assumption. replace (t - t) with 0 by ring. rewrite Rabs_R0. lra.
    + apply open_sweep_back. exists t. split; [assumption|]. rewrite back_move; assumption.
  - intros H. apply NNPP. intros N. apply (sweep_closed A (regular_closed_closed A HA)) in N.
    apply (proj1 (closure_not_outside _ _) H). revert N. apply interior_mono.
    intros Q HQ HO. apply HQ, open_sweep_in, HO.
Qed.

Theorem sweep_regular A : regular_closed A -> regular_closed (sweep A).
Proof.
  intros HA P. rewrite (sweep_is_closure A HA P). split.
  - apply closure_mono. intros Q HQ. apply open_sweep_open in HQ. revert HQ. apply interior_mono.
    apply open_sweep_in.
  - intros H. apply (sweep_is_closure A HA). apply NNPP. intros N.
    apply (sweep_closed A (regular_closed_closed A HA)) in N.
    apply (proj1 (closure_not_outside _ _) H). revert N. apply interior_mono.
    intros Q HQ HO. apply HQ, interior_in, HO.
Qed.

(* ------------------------------------------------------------------ the answers *)
Section Answers.
Context (S : set d) (P : point d) (w : word) (f : folds).
Hypothesis the_word : is_word (trace_of S P) a b w.

Let word_admissible : admissible w := trace_admissible S P w the_word.
Let answer := pmc_of (class_of_word f w).

Theorem in_is : answer = in_ <-> open_sweep S P.
Proof.
  unfold answer. rewrite (pmc_in f w word_admissible), open_sweep_back.
  apply (letters_met _ _ _ _ I (trace_functional S P) the_word).
Qed.

Theorem out_is : closed_set S -> (answer = out <-> ~ sweep S P).
Proof.
  intros HS. unfold answer. rewrite (pmc_out f w word_admissible), sweep_back. unfold D9.
  rewrite !(letters_met _ _ _ _ _ (trace_functional S P) the_word). unfold trace_of.
  split.
  - intros [HI HB] (t & Ht & H). apply (in_closed _ _ HS) in H. destruct H; [apply HI|apply HB]; eauto.
  - intros H. split; intros (t & Ht & K); apply H; exists t; (split; [assumption|]);
      apply (in_closed _ _ HS); auto.
Qed.

Theorem on_is_rest : closed_set S -> (answer = on <-> sweep S P /\ ~ open_sweep S P).
Proof.
  intros HS. pose proof in_is as Hi. pose proof (out_is HS) as Ho.
  destruct answer; split; intros H; try discriminate; try reflexivity.
  - exfalso. apply H, Hi. reflexivity.
  - split; [apply NNPP; intros N; apply Ho in N; discriminate|].
    intros N. apply Hi in N. discriminate.
  - exfalso. apply Ho; [reflexivity|apply H].
Qed.

Theorem on_is : regular_closed S -> (answer = on <-> boundary (open_sweep S) P).
Proof.
  intros HS. rewrite (on_is_rest (regular_closed_closed S HS)), (sweep_is_closure S HS P).
  unfold boundary. split; intros [H K]; (split; [assumption|]); intros N; apply K.
  - apply interior_in, N.
  - apply open_sweep_open, N.
Qed.

Theorem in_inner : answer = in_ -> interior (sweep S) P.
Proof.
  intros H. apply in_is in H. apply open_sweep_open in H. revert H. apply interior_mono.
  apply open_sweep_in.
Qed.

Theorem boundary_on : regular_closed S -> boundary (sweep S) P -> answer = on.
Proof.
  intros HS [H K]. apply (on_is_rest (regular_closed_closed S HS)). split.
  - apply NNPP. intros N. apply (sweep_closed S (regular_closed_closed S HS)) in N.
    apply closure_not_outside in H. contradiction.
  - intros N. apply K, in_inner, in_is, N.
Qed.

(* In, on, out against int W, the boundary of W and its complement: they differ on seams only. *)
Theorem seam : regular_closed S ->
  ((answer = on /\ ~ boundary (sweep S) P) <-> (interior (sweep S) P /\ ~ open_sweep S P)).
Proof.
  intros HS. rewrite (on_is_rest (regular_closed_closed S HS)). unfold boundary. split.
  - intros [[H N] K]. split; [|assumption]. apply NNPP. intros L. apply K.
    split; [apply closure_in, H|assumption].
  - intros [H K]. split; [split; [apply interior_in, H|assumption]|]. tauto.
Qed.

Theorem positions : closed_set S ->
  (first w <> O <-> image a S P) /\ (last_of w <> O <-> image b S P).
Proof.
  intros HS. pose proof (ordered M) as Hab.
  pose proof (first_met _ _ _ _ the_word) as Hf. pose proof (last_met _ _ _ _ the_word) as Hl.
  unfold trace_of in *. rewrite (image_back a S P), (image_back b S P) by lra.
  pose proof (state_O_closed S (back M a P) HS) as Ha.
  pose proof (state_O_closed S (back M b P) HS) as Hb.
  split; split; intros H.
  - apply NNPP. intros N. apply Ha in N. apply H. exact (state_functional _ _ _ _ Hf N).
  - intros E. rewrite E in Hf. apply Ha in Hf. contradiction.
  - apply NNPP. intros N. apply Hb in N. apply H. exact (state_functional _ _ _ _ Hl N).
  - intros E. rewrite E in Hl. apply Hb in Hl. contradiction.
Qed.

Theorem apart_is : closed_set S -> (apart w <-> ~ (image a S P /\ image b S P)).
Proof.
  intros HS. destruct (positions HS) as [H0 H1]. rewrite <- H0, <- H1. unfold apart.
  destruct (state_eq_dec (first w) O), (state_eq_dec (last_of w) O); tauto.
Qed.

End Answers.

Theorem apart_everywhere S : closed_set S ->
  (forall P, exists w, is_word (trace_of S P) a b w) ->
  ((forall P, ~ (image a S P /\ image b S P)) <->
   (forall P w, is_word (trace_of S P) a b w -> apart w)).
Proof.
  intros HS Hw. split.
  - intros H P w W. apply (apart_is S P w W HS), H.
  - intros H P. destruct (Hw P) as [w W]. apply (apart_is S P w W HS), (H P w W).
Qed.

(* ------------------------------------------------------------------ unsweep *)
Section Unsweep.
Context (E : set d) (P : point d) (w : word).
Hypothesis the_word : is_word (forward_trace E P) a b w.

Let forward_functional : functional (forward_trace E P) a b.
Proof. intros t x y _. apply state_functional. Qed.

Let word_admissible : admissible w := forward_admissible E P w the_word.

Theorem unsweep_out_is : closed_set E -> (unsweep_pmc w = out <-> ~ unsweep E P).
Proof.
  intros HE. rewrite unsweep_out, (letters_met _ _ _ _ O forward_functional the_word).
  unfold forward_trace, unsweep. split.
  - intros (t & Ht & H) U. apply (state_O_closed _ _ HE) in H. apply H, U, Ht.
  - intros U. apply not_all_ex_not in U. destruct U as [t U]. apply imply_to_and in U.
    exists t. split; [apply U|]. apply (state_O_closed _ _ HE), U.
Qed.

Lemma only_inside : unsweep_pmc w = in_ <-> forall t, a <= t <= b -> interior E (move M t P).
Proof.
  rewrite (unsweep_in w word_admissible). split.
  - intros -> t Ht. destruct (state_total E (move M t P)) as [s Hs].
    assert (In s (I :: nil)) as Hin.
    { apply (letters_met _ _ _ _ s forward_functional the_word). eauto. }
    destruct Hin as [<-|[]]. exact Hs.
  - intros H. destruct (proj1 (unsweep_in w word_admissible)) as []; [|reflexivity].
    unfold unsweep_pmc.
    assert (forall s, In s w -> s = I) as K.
    { intros s Hs. apply (letters_met _ _ _ _ s forward_functional the_word) in Hs.
      destruct Hs as (t & Ht & Hs). exact (state_functional _ _ _ _ Hs (H t Ht : state_at E _ I)). }
    destruct (existsb (state_eqb O) w) eqn:E1.
    + apply existsb_state in E1. discriminate (K _ E1).
    + destruct (existsb (state_eqb B) w) eqn:E2; [|reflexivity].
      apply existsb_state in E2. discriminate (K _ E2).
Qed.

Theorem unsweep_in_is : unsweep_pmc w = in_ <-> interior (unsweep E) P.
Proof.
  rewrite only_inside. split.
  - intros H.
    destruct (uniform_on_interval a b (fun e u => forall Q, near P e Q -> E (move M u Q)))
      as (e & He & K).
    + exact (ordered M).
    + intros e f t K Hfe Q HQ. apply K. eapply near_less; eassumption.
    + intros t Ht. destruct (H t Ht) as (e & He & K).
      destruct (move_continuous M t P Ht e He) as (r & Hr & L). exists r. split; [assumption|].
      intros u Hu Hut Q HQ. apply K, L; assumption.
    + exists e. split; [assumption|]. intros Q HQ t Ht. apply K; assumption.
  - intros (e & He & K) t Ht.
    destruct (back_continuous M t (move M t P) Ht e He) as (r & Hr & L).
    exists r. split; [assumption|]. intros y Hy.
    assert (near (back M t (move M t P)) e (back M t y)) as Hn.
    { apply L; try assumption. replace (t - t) with 0 by ring. rewrite Rabs_R0. lra. }
    rewrite back_move in Hn by assumption.
    pose proof (K _ Hn t Ht) as Hy'. rewrite move_back in Hy'; assumption.
Qed.

Theorem unsweep_on_is : closed_set E ->
  (unsweep_pmc w = on <-> unsweep E P /\ ~ interior (unsweep E) P).
Proof.
  intros HE. rewrite <- unsweep_in_is. pose proof (unsweep_out_is HE) as Ho.
  destruct (unsweep_pmc w); split; intros H; try discriminate; try reflexivity.
  - destruct H. exfalso; auto.
  - split; [|discriminate]. apply NNPP. intros N. apply Ho in N. discriminate.
  - exfalso. apply Ho; [reflexivity|apply H].
Qed.

Theorem unsweep_on_boundary : closed_set E ->
  unsweep_pmc w = on -> boundary (unsweep E) P.
Proof.
  intros HE H. apply (unsweep_on_is HE) in H. split; [apply closure_in|]; apply H.
Qed.

End Unsweep.

End Sweep.

(* ------------------------------------------------------------------ duality *)
Theorem dual_set {d a b} (M : motion d a b) (S : set d) P :
  sweep M S P <-> ~ unsweep (inverse M) (complement S) P.
Proof.
  rewrite sweep_back. unfold unsweep, complement, inverse; simpl. split.
  - intros (t & Ht & H) U. exact (U t Ht H).
  - intros U. apply not_all_ex_not in U. destruct U as [t U]. apply imply_to_and in U.
    exists t. split; [apply U|]. apply NNPP, U.
Qed.

Lemma dual_state {d} (S : set d) x s : regular_closed S ->
  (state_at (closure (complement S)) x (exchange s) <-> state_at S x s).
Proof.
  intros HS.
  assert (same (interior (closure (complement S))) (interior (complement S))) as HO.
  { intros y. split; [|intros H; revert H; apply interior_mono; apply closure_in].
    intros H. apply (regular_closed_closed S HS). intros Hy. apply HS in Hy.
    apply interior_open in H. destruct H as (e & He & H). destruct (Hy e He) as (z & Hz & Hi).
    apply H, interior_in in Hz. rewrite closure_not_outside in Hz. apply Hz.
    revert Hi. apply interior_mono. intros p Hp K. exact (K Hp). }
  assert (same (interior (complement (closure (complement S)))) (interior S)) as HI.
  { intros y. split.
    - intros H. apply interior_in in H. unfold complement at 1 in H.
      rewrite closure_not_outside in H. apply NNPP in H. revert H. apply interior_mono.
      intros p Hp. apply NNPP. exact Hp.
    - intros H. apply interior_open in H. revert H. apply interior_mono.
      intros p Hp K. rewrite closure_not_outside in K. apply K. revert Hp. apply interior_mono.
      intros q Hq N. exact (N Hq). }
  destruct s; simpl; [apply HI| |apply HO].
  rewrite (HO x), (HI x). tauto.
Qed.

Theorem dual_trace {d a b} (M : motion d a b) (S : set d) P w : regular_closed S ->
  (is_word (forward_trace (inverse M) (closure (complement S)) P) a b (dual w) <->
   is_word (trace_of M S P) a b w).
Proof.
  intros HS. unfold is_word, walks, forward_trace, trace_of, inverse; simpl.
  assert (stutter_free (dual w) <-> stutter_free w) as Hfree.
  { induction w as [|x [|y w] IH]; [tauto..|]. simpl in *. rewrite IH.
    split; intros [H K]; (split; [|assumption]); destruct x, y; simpl in *; congruence. }
  assert (forall t j, (exists x, nth_error (dual w) j = Some x
      /\ state_at (closure (complement S)) (back M t P) x)
    <-> exists x, nth_error w j = Some x /\ state_at S (back M t P) x) as Hj.
  { intros t j. unfold dual. rewrite nth_error_map. split.
    - intros (x & Hx & Hs). destruct (nth_error w j) as [y|]; [|discriminate]. simpl in Hx.
      inversion Hx; subst. exists y. split; [reflexivity|]. apply (dual_state S _ y HS), Hs.
    - intros (x & -> & Hs). exists (exchange x). split; [reflexivity|].
      apply (dual_state S _ x HS), Hs. }
  rewrite Hfree. unfold dual. rewrite map_length. fold (dual w).
  split; intros (Hab & Hw & m & H1 & H2); (split; [assumption|]); (split; [assumption|]);
    exists m; (split; [|assumption]); intros t Ht; apply Hj, H1, Ht.
Qed.

(* ------------------------------------------------------------------ the world moved *)
Definition continuous_map {d} (T : point d -> point d) : Prop :=
  forall x e, e > 0 -> exists r, r > 0 /\ forall y, near x r y -> near (T x) e (T y).

Lemma interior_moved {d} (S : set d) (T U : point d -> point d) x :
  continuous_map T -> continuous_map U -> (forall x, U (T x) = x) -> (forall x, T (U x) = x) ->
  (interior (fun y => S (U y)) (T x) <-> interior S x).
Proof.
  intros HT HU HUT HTU. split; intros (e & He & H).
  - destruct (HT x e He) as (r & Hr & K). exists r. split; [assumption|]. intros y Hy.
    rewrite <- (HUT y). apply H, K, Hy.
  - destruct (HU (T x) e He) as (r & Hr & K). rewrite HUT in K. exists r. split; [assumption|].
    intros y Hy. apply H, K, Hy.
Qed.

Theorem word_moved {d a b} (M N : motion d a b) (S : set d) (T U : point d -> point d) P w :
  continuous_map T -> continuous_map U -> (forall x, U (T x) = x) -> (forall x, T (U x) = x) ->
  (forall t x, a <= t <= b -> move N t x = T (move M t (U x))) ->
  (is_word (trace_of N (fun y => S (U y)) (T P)) a b w <-> is_word (trace_of M S P) a b w).
Proof.
  intros HT HU HUT HTU HN.
  assert (forall t, a <= t <= b -> back N t (T P) = T (back M t P)) as Hb.
  { intros t Ht. rewrite <- (back_move N t (T (back M t P)) Ht). f_equal.
    rewrite (HN t _ Ht), HUT, (move_back M t P Ht). reflexivity. }
  assert (forall t s, a <= t <= b ->
    (trace_of N (fun y => S (U y)) (T P) t s <-> trace_of M S P t s)) as He.
  { intros t s Ht. unfold trace_of. rewrite (Hb t Ht).
    pose proof (interior_moved S T U (back M t P) HT HU HUT HTU) as HI.
    pose proof (interior_moved (complement S) T U (back M t P) HT HU HUT HTU) as HO.
    change (fun y => complement S (U y)) with (complement (fun y => S (U y))) in HO.
    destruct s; simpl; rewrite ?HI, ?HO; tauto. }
  unfold is_word, walks. split; intros (Hab & Hw & m & H1 & H2); (split; [assumption|]);
    (split; [assumption|]); exists m; (split; [|assumption]); intros t Ht;
    destruct (H1 t Ht) as (x & Hx & Hs); exists x; (split; [assumption|]); apply He; assumption.
Qed.
