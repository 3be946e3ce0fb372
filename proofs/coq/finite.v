(* The word of a piecewise rational trajectory through a polyhedral set: there is exactly one, and it is
   admissible.
   SPDX-License-Identifier: GPL-3.0-or-later

   [form], [value]     affine forms n.x - c
   [polyhedral S fs]   whether x lies in S depends on the signs of finitely many forms alone: a
                       combination of half-spaces, open or closed, by and, or and not
   [state_of_signs]    then so does the state of x: I, B or O (claim C1, first half)
   [word_exists]       a trajectory whose coordinates are rational without poles on each of finitely
                       many pieces has a word through S
   [one_word]          under a motion: exactly one word, and that is admissible *)
Require Import Reals Lra Lia List Classical.
Require Fin.
Require Import Graze.words Graze.times Graze.space Graze.sweep Graze.polynomials.
Import ListNotations.
Open Scope R_scope.

(* ------------------------------------------------------------------ sums over coordinates *)
Fixpoint sum {d : nat} : (Fin.t d -> R) -> R :=
  match d with
  | 0%nat => fun _ => 0
  | S d' => fun f => f Fin.F1 + sum (fun i => f (Fin.FS i))
  end.

Lemma sum_plus {d} (f g : Fin.t d -> R) : sum (fun i => f i + g i) = sum f + sum g.
Proof. induction d as [|d IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma sum_same {d} (f g : Fin.t d -> R) : (forall i, f i = g i) -> sum f = sum g.
Proof.
  intros H. induction d as [|d IH]; simpl; [reflexivity|]. rewrite H. f_equal. apply IH.
  intros i. apply H.
Qed.

Lemma sum_bound {d} (f g : Fin.t d -> R) : (forall i, Rabs (f i) <= g i) -> Rabs (sum f) <= sum g.
Proof.
  intros H. induction d as [|d IH]; simpl; [rewrite Rabs_R0; lra|].
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; [apply H|].
  apply IH. intros i. apply H.
Qed.

Lemma sum_scale {d} c (f : Fin.t d -> R) : sum (fun i => c * f i) = c * sum f.
Proof. induction d as [|d IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma sum_rational {d} (f : R -> Fin.t d -> R) a b :
  (forall i, rational (fun t => f t i) a b) -> rational (fun t => sum (f t)) a b.
Proof.
  intros H. induction d as [|d IH]; simpl; [apply rational_const|].
  apply (rational_plus (fun t => f t Fin.F1) (fun t => sum (fun i => f t (Fin.FS i)))); [apply H|].
  apply (IH (fun t i => f t (Fin.FS i))). intros i. apply H.
Qed.

(* ------------------------------------------------------------------ polyhedral sets *)
Record form (d : nat) := { normal : point d; offset : R }.
Arguments normal {d}. Arguments offset {d}.

Definition value {d} (f : form d) (x : point d) : R := sum (fun i => normal f i * x i) - offset f.

Definition agree {d} (fs : list (form d)) (x y : point d) : Prop :=
  forall f, In f fs -> sign (value f x) = sign (value f y).

Definition polyhedral {d} (S : set d) (fs : list (form d)) : Prop :=
  forall x y, agree fs x y -> (S x <-> S y).

Definition moved {d} (x y z : point d) : point d := fun i => z i - x i + y i.

Lemma value_moved {d} (f : form d) x y z : value f (moved x y z) = value f z - value f x + value f y.
Proof.
  unfold value.
  enough (sum (fun i => normal f i * moved x y z i)
    = sum (fun i => normal f i * z i) + -1 * sum (fun i => normal f i * x i)
      + sum (fun i => normal f i * y i)) as -> by ring.
  rewrite <- sum_scale, <- !sum_plus. apply sum_same. intros i. unfold moved. ring.
Qed.

Lemma value_continuous {d} (f : form d) x e : e > 0 ->
  exists r, r > 0 /\ forall y, near x r y -> Rabs (value f y - value f x) < e.
Proof.
  intros He. set (c := sum (fun i => Rabs (normal f i))).
  assert (0 <= c) as Hc.
  { apply Rle_trans with (Rabs (sum (normal f))); [apply Rabs_pos|].
    apply sum_bound. intros i. lra. }
  assert (0 < e / (c + 1)) as Hr by (apply Rdiv_lt_0_compat; lra).
  exists (e / (c + 1)). split; [assumption|]. intros y Hy.
  assert (value f y - value f x = sum (fun i => normal f i * (y i - x i))) as ->.
  { unfold value. rewrite (sum_same (fun i => normal f i * (y i - x i))
      (fun i => normal f i * y i + -1 * (normal f i * x i))) by (intros; ring).
    rewrite sum_plus, sum_scale. ring. }
  apply Rle_lt_trans with (e / (c + 1) * c).
  - unfold c. rewrite <- sum_scale. apply sum_bound. intros i. fold c. rewrite Rabs_mult, Rmult_comm.
    apply Rmult_le_compat_r; [apply Rabs_pos|]. left. apply Hy.
  - apply Rlt_le_trans with (e / (c + 1) * (c + 1)); [|right; field; lra].
    apply Rmult_lt_compat_l; lra.
Qed.

(* Near x each form that is not 0 at x keeps its sign. *)
Lemma signs_near {d} (fs : list (form d)) x : exists r, r > 0 /\
  forall y, near x r y -> forall f, In f fs -> value f x <> 0 -> sign (value f y) = sign (value f x).
Proof.
  induction fs as [|f fs (r & Hr & IH)]; [exists 1; split; [lra|intros y _ f []]|].
  destruct (Req_dec (value f x) 0) as [H0|H0].
  - exists r. split; [assumption|]. intros y Hy g [<-|Hg] Hne; [contradiction|]. apply IH; assumption.
  - destruct (value_continuous f x (Rabs (value f x))) as (s & Hs & K); [apply Rabs_pos_lt, H0|].
    exists (Rmin r s). split; [apply Rmin_pos; assumption|]. intros y Hy g [<-|Hg] Hne.
    + assert (near x s y) as Hy' by (eapply near_less; [exact Hy|apply Rmin_r]).
      specialize (K y Hy'). destruct (Rtotal_order (value f x) 0) as [L|[L|L]]; [|lra|].
      * rewrite (proj2 (sign_Lt _) L). apply sign_Lt. rewrite (Rabs_left (value f x)) in K by assumption.
        apply Rabs_def2 in K. lra.
      * rewrite (proj2 (sign_Gt _) L). apply sign_Gt. rewrite (Rabs_right (value f x)) in K by lra.
        apply Rabs_def2 in K. lra.
    + apply IH; try assumption. eapply near_less; [exact Hy|apply Rmin_l].
Qed.

Lemma agree_sym {d} (fs : list (form d)) x y : agree fs x y -> agree fs y x.
Proof. intros H f Hf. symmetry. apply H, Hf. Qed.

Lemma polyhedral_complement {d} (S : set d) fs : polyhedral S fs -> polyhedral (complement S) fs.
Proof. intros H x y Ha. unfold complement. rewrite (H x y Ha). tauto. Qed.

Lemma interior_of_signs {d} (S : set d) fs x y : polyhedral S fs -> agree fs x y ->
  interior S x -> interior S y.
Proof.
  intros HS Ha (e & He & Hi).
  destruct (signs_near fs x) as (r & Hr & Hx), (signs_near fs y) as (s & Hs & Hy).
  exists (Rmin e (Rmin r s)). split; [repeat apply Rmin_pos; assumption|]. intros z Hz.
  assert (near x (Rmin e (Rmin r s)) (moved y x z)) as Hm.
  { intros i. unfold moved. replace (z i - y i + x i - x i) with (z i - y i) by ring. apply Hz. }
  apply (HS (moved y x z) z).
  - intros f Hf. destruct (Req_dec (value f x) 0) as [H0|H0].
    + assert (value f y = 0) as H1 by (apply sign_Eq; rewrite <- (Ha f Hf); apply sign_Eq, H0).
      rewrite value_moved, H0, H1. f_equal. ring.
    + assert (value f y <> 0) as H1
        by (intros E; apply H0, sign_Eq; rewrite (Ha f Hf); apply sign_Eq, E).
      rewrite (Hx _ (near_less _ _ _ _ Hm (Rle_trans _ _ _ (Rmin_r _ _) (Rmin_l _ _))) f Hf H0).
      rewrite (Hy z (near_less _ _ _ _ Hz (Rle_trans _ _ _ (Rmin_r _ _) (Rmin_r _ _))) f Hf H1).
      apply Ha, Hf.
  - apply Hi. eapply near_less; [exact Hm|apply Rmin_l].
Qed.

Theorem state_of_signs {d} (S : set d) fs x y s : polyhedral S fs -> agree fs x y ->
  state_at S x s -> state_at S y s.
Proof.
  intros HS Ha. pose proof (agree_sym _ _ _ Ha) as Hb.
  pose proof (polyhedral_complement S fs HS) as HC.
  destruct s; simpl.
  - apply (interior_of_signs S fs); assumption.
  - intros [H K]. split; intros N; [apply H|apply K].
    + exact (interior_of_signs S fs y x HS Hb N).
    + exact (interior_of_signs (complement S) fs y x HC Hb N).
  - apply (interior_of_signs (complement S) fs); assumption.
Qed.

(* ------------------------------------------------------------------ words *)
Lemma value_rational {d} (f : form d) (c : R -> point d) a b :
  (forall i, rational (fun t => c t i) a b) -> rational (fun t => value f (c t)) a b.
Proof.
  intros H. unfold value. apply rational_minus; [|apply rational_const].
  apply (sum_rational (fun t i => normal f i * c t i)). intros i.
  apply rational_mult; [apply rational_const|apply H].
Qed.

Lemma cuts_of_chain (s : trace) a b : (forall t, exists x, s t x) ->
  chain (fun c d => exists x, forall t, c < t < d -> s t x) a b -> exists l, cuts s a l b.
Proof.
  intros Ht. induction 1 as [a|a b c Hab (x & Hx) Hc (l & IH)].
  - destruct (Ht a) as [p Hp]. exists [p]. constructor; assumption.
  - destruct (Ht a) as [p Hp]. exists (p :: x :: l). econstructor; eassumption.
Qed.

Theorem word_exists {d} (S : set d) fs (c : R -> point d) a b : polyhedral S fs ->
  chain (fun u v => forall i, rational (fun t => c t i) u v) a b ->
  exists w, is_word (fun t => state_at S (c t)) a b w.
Proof.
  intros HS Hc.
  destruct (cuts_of_chain (fun t => state_at S (c t)) a b) as [l Hl].
  - intros t. apply state_total.
  - revert Hc. apply chain_refine. intros u v Huv Hr.
    pose proof (signs_stay (map (fun f t => value f (c t)) fs) u v ltac:(lra)) as Hs.
    assert (chain (same_signs (map (fun f t => value f (c t)) fs)) u v) as Hsigns.
    { apply Hs. intros g Hg. apply in_map_iff in Hg. destruct Hg as (f & <- & _).
      apply value_rational, Hr. }
    clear Hs. revert Hsigns. apply chain_refine. intros p q Hpq Hsame.
    apply chain_gap with q; [assumption| |apply chain_end].
    destruct (state_total S (c ((p + q) / 2))) as [x Hx]. exists x. intros t Ht.
    apply (state_of_signs S fs (c ((p + q) / 2))); try assumption.
    intros f Hf. apply (Hsame (fun t => value f (c t))); try lra.
    apply in_map_iff. exists f. auto.
  - exists (merged l). apply word_of_cuts; [|assumption]. intros t x y _. apply state_functional.
Qed.

Theorem one_word {d a b} (M : motion d a b) (S : set d) fs P : polyhedral S fs ->
  chain (fun u v => forall i, rational (fun t => back M t P i) u v) a b ->
  exists! w, is_word (trace_of M S P) a b w.
Proof.
  intros HS Hc. destruct (word_exists S fs (fun t => back M t P) a b HS Hc) as [w W].
  exists w. split; [exact W|]. intros v V.
  exact (word_unique _ _ _ _ _ (trace_functional M S P) W V).
Qed.
