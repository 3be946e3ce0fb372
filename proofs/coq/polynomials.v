(* Polynomials and rational functions of one variable: finitely many roots, hence signs that stay.
   SPDX-License-Identifier: GPL-3.0-or-later

   [eval]            a polynomial is the list of its coefficients, the constant one first
   [finitely_many_roots]  a polynomial is zero everywhere or has finitely many roots
   [sign_stays]      without a root between two times the sign is the same
   [rational]        a quotient of polynomials without a pole on [a, b]; [rational_plus], ...
   [chain]           an interval cut into finitely many gaps with a property
   [chain_avoiding]  finitely many exceptional instants can be made ends of gaps
   [signs_stay]      finitely many rational functions: a chain of gaps in which no sign changes *)
Require Import Reals Lra Lia List.
Import ListNotations.
Open Scope R_scope.

Fixpoint eval (p : list R) (x : R) : R := match p with [] => 0 | c :: q => c + x * eval q x end.

Lemma eval_continuous p : continuity (eval p).
Proof.
  induction p as [|c p IH]; intros x; simpl.
  - apply continuity_const. intros u v; reflexivity.
  - apply (continuity_plus (fun _ => c) (fun x => x * eval p x)).
    + apply continuity_const. intros u v; reflexivity.
    + apply (continuity_mult (fun x => x) (eval p)); [|exact IH].
      apply derivable_continuous, derivable_id.
Qed.

(* ------------------------------------------------------------------ roots *)
(* p(x) = p(r) + (x - r) q(x), q of a smaller degree. *)
Fixpoint quotient (p : list R) (r : R) : list R :=
  match p with [] => [] | [c] => [] | c :: q => eval q r :: quotient q r end.

Lemma quotient_eval p r x : eval p x = eval p r + (x - r) * eval (quotient p r) x.
Proof.
  induction p as [|c [|d q] IH].
  - simpl. ring.
  - simpl. ring.
  - change (c + x * eval (d :: q) x = (c + r * eval (d :: q) r)
      + (x - r) * (eval (d :: q) r + x * eval (quotient (d :: q) r) x)).
    rewrite IH. ring.
Qed.

Lemma quotient_length p r : length (quotient p r) = pred (length p).
Proof.
  induction p as [|c [|d q] IH]; [reflexivity..|].
  change (S (length (quotient (d :: q) r)) = S (length q)). rewrite IH. reflexivity.
Qed.

Theorem finitely_many_roots p :
  (forall x, eval p x = 0) \/ exists roots, forall x, eval p x = 0 -> In x roots.
Proof.
  remember (length p) as n eqn:Hn. revert p Hn. induction n as [|n IH]; intros p Hn.
  - left. destruct p; [reflexivity|discriminate].
  - destruct (Classical_Prop.classic (exists r, eval p r = 0)) as [[r Hr]|Hno].
    + destruct (IH (quotient p r)) as [H0|[roots H]].
      * rewrite quotient_length, <- Hn. reflexivity.
      * left. intros x. rewrite (quotient_eval p r x), Hr, H0. ring.
      * right. exists (r :: roots). intros x Hx.
        rewrite (quotient_eval p r x), Hr, Rplus_0_l in Hx.
        apply Rmult_integral in Hx. destruct Hx as [Hx|Hx]; [left; lra|right; auto].
    + right. exists []. intros x Hx. apply Hno. eauto.
Qed.

(* ------------------------------------------------------------------ signs *)
Definition sign (x : R) : comparison :=
  if Rlt_dec x 0 then Lt else if Rlt_dec 0 x then Gt else Eq.

Lemma sign_Lt x : sign x = Lt <-> x < 0.
Proof. unfold sign. destruct (Rlt_dec x 0), (Rlt_dec 0 x); split; intros; try discriminate; try lra; reflexivity. Qed.
Lemma sign_Gt x : sign x = Gt <-> 0 < x.
Proof.
  unfold sign. destruct (Rlt_dec x 0), (Rlt_dec 0 x); split; intros; try discriminate; try lra;
    reflexivity.
Qed.
Lemma sign_Eq x : sign x = Eq <-> x = 0.
Proof.
  unfold sign. destruct (Rlt_dec x 0), (Rlt_dec 0 x); split; intros; try discriminate; try lra;
    reflexivity.
Qed.

Lemma sign_stays p a b : (forall t, a < t < b -> eval p t <> 0) ->
  forall t u, a < t < b -> a < u < b -> sign (eval p t) = sign (eval p u).
Proof.
  intros Hno.
  assert (forall t u, a < t -> t <= u -> u < b -> sign (eval p t) = sign (eval p u)) as H.
  { intros t u Ht Htu Hu. pose proof (Hno t ltac:(lra)). pose proof (Hno u ltac:(lra)).
    destruct (Rle_lt_dec (eval p t * eval p u) 0) as [Hle|Hgt].
    - destruct (IVT_cor (eval p) t u (eval_continuous p) Htu Hle) as (z & Hz & Hz0).
      exfalso. apply (Hno z); [lra|assumption].
    - destruct (Rlt_dec (eval p t) 0) as [Ht0|Ht0].
      + rewrite (proj2 (sign_Lt _) Ht0). symmetry. apply sign_Lt.
        destruct (Rlt_dec (eval p u) 0) as [|Hu0]; [assumption|].
        pose proof (Rmult_lt_gt_compat_neg_l (eval p t) 0 (eval p u) Ht0 ltac:(lra)). lra.
      + rewrite (proj2 (sign_Gt (eval p t)) ltac:(lra)). symmetry. apply sign_Gt.
        apply Rmult_lt_reg_l with (eval p t); lra. }
  intros t u Ht Hu. destruct (Rle_lt_dec t u); [apply H|symmetry; apply H]; lra.
Qed.

(* ------------------------------------------------------------------ sums and products *)
Fixpoint padd (p q : list R) : list R :=
  match p, q with
  | [], _ => q
  | _, [] => p
  | c :: p', d :: q' => (c + d) :: padd p' q'
  end.
Definition pscale (c : R) (p : list R) : list R := map (Rmult c) p.
Fixpoint pmul (p q : list R) : list R :=
  match p with [] => [] | c :: p' => padd (pscale c q) (0 :: pmul p' q) end.

Lemma eval_padd p q x : eval (padd p q) x = eval p x + eval q x.
Proof. revert q. induction p as [|c p IH]; intros [|d q]; simpl; rewrite ?IH; ring. Qed.
Lemma eval_pscale c p x : eval (pscale c p) x = c * eval p x.
Proof.
  induction p as [|d p IH]; [simpl; ring|].
  change (c * d + x * eval (pscale c p) x = c * (d + x * eval p x)). rewrite IH. ring.
Qed.
Lemma eval_pmul p q x : eval (pmul p q) x = eval p x * eval q x.
Proof.
  induction p as [|c p IH]; simpl; [ring|].
  rewrite eval_padd, eval_pscale. simpl. rewrite IH. ring.
Qed.

(* ------------------------------------------------------------------ rational functions *)
Definition rational (f : R -> R) (a b : R) : Prop :=
  exists p q, forall t, a <= t <= b -> eval q t <> 0 /\ f t = eval p t / eval q t.

Lemma rational_same f g a b : (forall t, a <= t <= b -> f t = g t) -> rational f a b -> rational g a b.
Proof.
  intros He (p & q & H). exists p, q. intros t Ht. rewrite <- (He t Ht). apply H, Ht.
Qed.
Lemma rational_less f a b c d : a <= c -> d <= b -> rational f a b -> rational f c d.
Proof. intros Hac Hdb (p & q & H). exists p, q. intros t Ht. apply H. lra. Qed.
Lemma rational_polynomial p a b : rational (eval p) a b.
Proof. exists p, [1]. intros t _. simpl. split; [lra|field]. Qed.
Lemma rational_const c a b : rational (fun _ => c) a b.
Proof. exists [c], [1]. intros t _. simpl. split; [lra|field]. Qed.
Lemma rational_plus f g a b : rational f a b -> rational g a b -> rational (fun t => f t + g t) a b.
Proof.
  intros (p & q & H) (u & v & K). exists (padd (pmul p v) (pmul u q)), (pmul q v). intros t Ht.
  destruct (H t Ht) as [Hq ->], (K t Ht) as [Hv ->].
  rewrite eval_padd, !eval_pmul. split; [apply Rmult_integral_contrapositive; auto|].
  field. auto.
Qed.
Lemma rational_mult f g a b : rational f a b -> rational g a b -> rational (fun t => f t * g t) a b.
Proof.
  intros (p & q & H) (u & v & K). exists (pmul p u), (pmul q v). intros t Ht.
  destruct (H t Ht) as [Hq ->], (K t Ht) as [Hv ->].
  rewrite !eval_pmul. split; [apply Rmult_integral_contrapositive; auto|]. field. auto.
Qed.
Lemma rational_opp f a b : rational f a b -> rational (fun t => - f t) a b.
Proof.
  intros H. apply rational_same with (fun t => -1 * f t); [intros; ring|].
  apply rational_mult; [apply rational_const|assumption].
Qed.
Lemma rational_minus f g a b : rational f a b -> rational g a b -> rational (fun t => f t - g t) a b.
Proof. intros H K. apply rational_plus; [assumption|]. apply rational_opp, K. Qed.
Lemma rational_inv f a b : (forall t, a <= t <= b -> f t <> 0) -> rational f a b ->
  rational (fun t => / f t) a b.
Proof.
  intros Hne (p & q & H). exists q, p. intros t Ht. pose proof (Hne t Ht) as Hf.
  destruct (H t Ht) as [Hq He]. rewrite He in *.
  assert (eval p t <> 0) by (intros E; apply Hf; rewrite E; unfold Rdiv; ring).
  split; [assumption|]. field. auto.
Qed.

(* ------------------------------------------------------------------ chains of gaps *)
Inductive chain (G : R -> R -> Prop) : R -> R -> Prop :=
| chain_end a : chain G a a
| chain_gap a b c : a < b -> G a b -> chain G b c -> chain G a c.

Lemma chain_order G a b : chain G a b -> a <= b.
Proof. induction 1; lra. Qed.

Lemma chain_app G a b c : chain G a b -> chain G b c -> chain G a c.
Proof.
  induction 1 as [|a b c' Hab HG Hc IH]; intros K; [assumption|].
  apply chain_gap with b; auto.
Qed.

Lemma chain_refine (G H : R -> R -> Prop) a b :
  (forall c d, c < d -> G c d -> chain H c d) -> chain G a b -> chain H a b.
Proof.
  intros Hr. induction 1 as [|a b c Hab HG Hc IH]; [apply chain_end|].
  apply chain_app with b; auto.
Qed.

Lemma chain_avoiding (G : R -> R -> Prop) (l : list R) : forall a b, a <= b ->
  (forall c d, a <= c -> c < d -> d <= b -> (forall x, In x l -> ~ (c < x < d)) -> G c d) ->
  chain G a b.
Proof.
  induction l as [|r l IH]; intros a b Hab HG.
  - destruct (Rle_lt_or_eq_dec a b Hab) as [Hlt| ->]; [|apply chain_end].
    apply chain_gap with b; [assumption| |apply chain_end]. apply HG; simpl; try lra. tauto.
  - destruct (Rlt_dec a r) as [Har|Har]; [destruct (Rlt_dec r b) as [Hrb|Hrb]|].
    + apply chain_app with r; apply IH; try lra; intros c d Hc Hcd Hd Hl; apply HG; try lra;
        intros x [<-|Hx]; try lra; apply Hl, Hx.
    + apply IH; [assumption|]. intros c d Hc Hcd Hd Hl. apply HG; try lra.
      intros x [<-|Hx]; [lra|apply Hl, Hx].
    + apply IH; [assumption|]. intros c d Hc Hcd Hd Hl. apply HG; try lra.
      intros x [<-|Hx]; [lra|apply Hl, Hx].
Qed.

Definition same_signs (fs : list (R -> R)) (a b : R) : Prop :=
  forall f, In f fs -> forall t u, a < t < b -> a < u < b -> sign (f t) = sign (f u).

Lemma sign_quotient x y z v : y <> 0 -> v <> 0 -> sign x = sign z -> sign y = sign v ->
  sign (x / y) = sign (z / v).
Proof.
  intros Hy Hv Hx Hs. unfold Rdiv.
  assert (forall p q, q <> 0 -> sign (p * / q) = sign (p * q)) as Hpq.
  { intros p q Hq. replace (p * q) with ((p * / q) * (q * q)) by (field; assumption).
    assert (0 < q * q) as Hqq by (apply Rsqr_pos_lt in Hq; exact Hq).
    generalize (p * / q). intros r. destruct (Rtotal_order r 0) as [H|[->|H]].
    - rewrite (proj2 (sign_Lt r) H). symmetry. apply sign_Lt.
      rewrite Rmult_comm, <- (Rmult_0_r (q * q)). apply Rmult_lt_compat_l; assumption.
    - rewrite Rmult_0_l. reflexivity.
    - rewrite (proj2 (sign_Gt r) H). symmetry. apply sign_Gt. apply Rmult_lt_0_compat; assumption. }
  rewrite !Hpq by assumption.
  assert (forall p q, sign (p * q) = match sign p, sign q with
    | Eq, _ | _, Eq => Eq | Lt, Lt | Gt, Gt => Gt | _, _ => Lt end) as Hm.
  { intros p q.
    destruct (Rtotal_order p 0) as [Hp|[->|Hp]], (Rtotal_order q 0) as [Hq|[->|Hq]];
      rewrite ?Rmult_0_l, ?Rmult_0_r, ?(proj2 (sign_Lt _) Hp), ?(proj2 (sign_Gt _) Hp),
        ?(proj2 (sign_Lt _) Hq), ?(proj2 (sign_Gt _) Hq), ?(proj2 (sign_Eq 0) eq_refl); try reflexivity.
    - apply sign_Gt. replace (p * q) with ((- p) * (- q)) by ring. apply Rmult_lt_0_compat; lra.
    - apply sign_Lt. apply Ropp_lt_cancel. rewrite Ropp_0, Ropp_mult_distr_l.
      apply Rmult_lt_0_compat; lra.
    - apply sign_Lt. apply Ropp_lt_cancel. rewrite Ropp_0, Ropp_mult_distr_r.
      apply Rmult_lt_0_compat; lra.
    - apply sign_Gt. apply Rmult_lt_0_compat; lra. }
  rewrite !Hm, Hx, Hs. reflexivity.
Qed.

Theorem signs_stay (fs : list (R -> R)) a b : a <= b ->
  (forall f, In f fs -> rational f a b) -> chain (same_signs fs) a b.
Proof.
  intros Hab Hr.
  assert (exists l, forall c d, a <= c -> d <= b -> (forall x, In x l -> ~ (c < x < d)) ->
    same_signs fs c d) as [l Hl].
  { induction fs as [|f fs IH].
    - exists []. intros c d _ _ _ f [].
    - destruct IH as [l Hl]; [intros; apply Hr; right; assumption|].
      destruct (Hr f (or_introl eq_refl)) as (p & q & Hpq).
      assert (exists lp, forall c d, a <= c -> d <= b -> (forall x, In x lp -> ~ (c < x < d)) ->
        forall t u, c < t < d -> c < u < d -> sign (eval p t) = sign (eval p u)) as [lp Hlp].
      { destruct (finitely_many_roots p) as [H0|[roots H]].
        - exists []. intros. rewrite !H0. reflexivity.
        - exists roots. intros c d _ _ Hx. apply sign_stays. intros t Ht He. exact (Hx t (H t He) Ht). }
      exists (lp ++ l). intros c d Hc Hd Hx g [<-|Hg].
      + intros t u Ht Hu.
        destruct (Hpq t ltac:(lra)) as [Hq1 ->], (Hpq u ltac:(lra)) as [Hq2 ->].
        apply sign_quotient; try assumption.
        * apply (Hlp c d Hc Hd); try assumption. intros x Hin. apply Hx, in_or_app. auto.
        * apply (sign_stays q c d); try assumption. intros v Hv. apply Hpq. lra.
      + apply (Hl c d Hc Hd); [|assumption]. intros x Hin. apply Hx, in_or_app. auto. }
  apply chain_avoiding with l; [assumption|]. intros c d Hc Hcd Hd Hx. apply Hl; assumption.
Qed.
