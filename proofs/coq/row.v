(* A checker of one row of a certificate, and that what it accepts is true (claim K12).
   SPDX-License-Identifier: GPL-3.0-or-later

   [piece]        a piece of a motion: the map (A|b)/h and its inverse (N|n)/w, integer polynomials; a row
                  of a matrix is its translation, then its coefficients
   [given_by]     a motion over the reals is the one that the pieces give
   [inverts]      the test that the second map undoes the first
   [row], [check_row]   a row of a certificate, and the check of it
   [row_sound]    a row that is accepted says the word of the point's trace *)
Require Import Reals Lra Lia List ZArith Bool.
Require Fin.
Require Import Graze.words Graze.definitions Graze.unsweep Graze.times Graze.space Graze.sweep Graze.polynomials
  Graze.finite Graze.affine Graze.bernstein Graze.facets Graze.sample Graze.interval Graze.interval_sound.
Import ListNotations.
Open Scope R_scope.

(* ------------------------------------------------------------------ motions *)
(* A time: a numerator and a denominator, which must be positive. *)
Definition time := (Z * Z)%type.
Definition instant (t : time) : R := IZR (fst t) / IZR (snd t).
Definition time_ok (t : time) : bool := Z.ltb 0 (snd t).
Definition not_after (t u : time) : bool := Z.leb (fst t * snd u) (fst u * snd t).
Definition same_time (t u : time) : bool := Z.eqb (fst t * snd u) (fst u * snd t).

Record piece := {
  begins : time; finishes : time;
  forward : list (list (list Z)); forward_weight : list Z;
  backward : list (list (list Z)); backward_weight : list Z
}.

Definition entry (m : list (list (list Z))) (i j : nat) : list Z := nth j (nth i m []) [].
(* w times the image of x. *)
Definition mapped {d} (m : list (list (list Z))) (t : R) (x : point d) : point d :=
  fun i => ev (entry m (nat_of i) 0) t + sum (fun j => ev (entry m (nat_of i) (S (nat_of j))) t * x j).

Definition given_by {d a b} (ps : list piece) (M : motion d a b) : Prop :=
  forall p t, In p ps -> instant (begins p) <= t <= instant (finishes p) ->
  ev (forward_weight p) t <> 0 /\
  forall x i, ev (forward_weight p) t * move M t x i = mapped (forward p) t x i.

Fixpoint poly_dot (A C : list (list Z)) : list Z :=
  match A, C with p :: A', q :: C' => zadd (zmul p q) (poly_dot A' C') | _, _ => [] end.
Definition column (m : list (list (list Z))) (k : nat) : list (list Z) := map (fun r => nth k r []) m.
Definition is_zero (p : list Z) : bool := match trim p with [] => true | _ => false end.
Definition minus (p q : list Z) : list Z := zadd p (map Z.opp q).
(* Row i of N A is that of h w times the unit matrix, and n h + N b is zero. *)
Definition inverts_row (p : piece) (d i : nat) : bool :=
  let r := nth i (backward p) [] in
  Nat.eqb (length r) (S d)
  && is_zero (zadd (zmul (hd [] r) (forward_weight p)) (poly_dot (tl r) (column (forward p) 0)))
  && forallb (fun k =>
       is_zero (minus (poly_dot (tl r) (column (forward p) (S k)))
         (if Nat.eqb k i then zmul (forward_weight p) (backward_weight p) else []))) (seq 0 d).
Definition inverts (d : nat) (p : piece) : bool :=
  Nat.eqb (length (backward p)) d && Nat.eqb (length (forward p)) d
  && forallb (fun r => Nat.eqb (length r) (S d)) (forward p)
  && forallb (inverts_row p d) (seq 0 d).

(* ------------------------------------------------------------------ the check of a row *)
Inductive operation := sweeping | unsweeping.

Record row := {
  word_of : word; pmc : membership;
  class_claimed : class; definition : nat; position : nat; crosses : nat; tangent : nat; inner_count : nat;
  intervals : list (kind * time * list Z)
}.

(* A rational point is q, q p_1, ..., q p_d. *)
Definition point_of {d} (V : list Z) : point d := fun i => IZR (nth (nat_of i) (tl V) 0%Z) / IZR (hd 0%Z V).

Definition curve_of (m : list (list (list Z))) (w : list Z) (V : list Z) : list (list Z) :=
  trim (zscale (hd 0%Z V) w) :: map (fun r => trim (pull V r)) m.
Definition curve_on (o : operation) (V : list Z) (p : piece) : time * time * list (list Z) :=
  (begins p, finishes p, match o with
    | sweeping => curve_of (backward p) (backward_weight p) V
    | unsweeping => curve_of (forward p) (forward_weight p) V
    end).

Definition degree_of (C : list (list Z)) : nat := pred (fold_right (fun p n => Nat.max (length p) n) 0%nat C).
Definition oriented (l h d : Z) (C : list (list Z)) : view :=
  let n := degree_of C in
  let v := view_of l h d n C in
  if Z.eqb (strict n (hd [] (coefficients v))) (-1) then view_of l h d n (map (map Z.opp) C) else v.
Definition primitive (q : list Z) : list Z :=
  let g := fold_right Z.gcd 0%Z q in if Z.eqb g 0 then q else map (fun c => Z.div c g) q.

Definition within_piece (t u : time) (c : time * time * list (list Z)) : bool :=
  not_after (fst (fst c)) t && not_after u (snd (fst c)).
Definition times_ok (t u : time) (v : view) : bool :=
  Z.eqb (lo v * snd t) (fst t * den v) && Z.eqb (hi v * snd u) (fst u * den v).
Definition step_ok (F : list facet) (cs : list (time * time * list (list Z))) (t u : time) (k : kind)
  (q : list Z) : bool :=
  match find (within_piece t u) cs with
  | Some c =>
      let g := Z.gcd (snd t) (snd u) in
      let l := (fst t * (snd u / g))%Z in
      let h := (fst u * (snd t / g))%Z in
      let d := (snd t * (snd u / g))%Z in
      let v := oriented l h d (snd c) in
      times_ok t u v && view_ok v && interval_ok v F k (trim (primitive q))
  | None => false
  end.

Fixpoint follow (F : list facet) (cs : list (time * time * list (list Z))) (first last t : time)
  (l : list (kind * time * list Z)) : option (list state) :=
  match l with
  | [] => None
  | (k, u, q) :: rest =>
      if time_ok u && not_after first t && not_after u last && step_ok F cs t u k q then
        match rest with
        | [] => if same_time u last then Some (letters k) else None
        | _ =>
            match follow F cs first last u rest with
            | Some m => Some (letters k ++ tl m)
            | None => None
            end
        end
      else None
  end.

Fixpoint same_word (u v : word) : bool :=
  match u, v with
  | [], [] => true
  | x :: u', y :: v' => state_eqb x y && same_word u' v'
  | _, _ => false
  end.
Definition same_membership (x y : membership) : bool :=
  match x, y with in_, in_ | definitions.on, definitions.on | out, out => true | _, _ => false end.
Definition same_class (x y : class) : bool :=
  match x, y with
  | regular, regular | fold, fold | fold_boundary, fold_boundary => true
  | definitions.boundary, definitions.boundary | exterior, exterior => true
  | _, _ => false
  end.
(* What a row says beside its word. *)
Definition claims_ok (o : operation) (f : folds) (r : row) : bool :=
  let w := word_of r in
  match o with
  | unsweeping => same_membership (pmc r) (unsweep_pmc w)
  | sweeping =>
      same_membership (pmc r) (pmc_of (class_of_word f w))
      && same_class (class_claimed r) (class_of_word f w)
      && Nat.eqb (definition r) (definition_of f w) && Nat.eqb (position r) (case_of w)
      && Nat.eqb (crosses r) (i_of w) && Nat.eqb (tangent r) (t_of w) && Nat.eqb (inner_count r) (k_of w)
  end.

Definition first_time (ps : list piece) : time := match ps with [] => (0, 1)%Z | p :: _ => begins p end.
Fixpoint last_time (ps : list piece) : time :=
  match ps with [] => (0, 1)%Z | [p] => finishes p | _ :: rest => last_time rest end.

Definition check_row (o : operation) (f : folds) (d : nat) (F : list facet) (ps : list piece) (V : list Z)
  (r : row) : bool :=
  Nat.eqb (length V) (S d) && Z.ltb 0 (hd 0%Z V)
  && forallb (fun p => time_ok (begins p) && time_ok (finishes p) && inverts d p) ps
  && claims_ok o f r
  && match follow F (map (curve_on o V) ps) (first_time ps) (last_time ps) (first_time ps) (intervals r) with
     | Some l => same_word (merged l) (word_of r)
     | None => false
     end.

(* ------------------------------------------------------------------ times *)
Lemma not_after_instant t u : time_ok t = true -> time_ok u = true -> not_after t u = true -> instant t <= instant u.
Proof.
  unfold time_ok, not_after, instant. intros Ht Hu H. apply Z.ltb_lt, IZR_lt in Ht. apply Z.ltb_lt, IZR_lt in Hu.
  apply Z.leb_le, IZR_le in H. rewrite !mult_IZR in H.
  apply Rmult_le_reg_r with (IZR (snd t) * IZR (snd u)); [apply Rmult_lt_0_compat; assumption|].
  replace (IZR (fst t) / IZR (snd t) * (IZR (snd t) * IZR (snd u))) with (IZR (fst t) * IZR (snd u)) by (field; lra).
  replace (IZR (fst u) / IZR (snd u) * (IZR (snd t) * IZR (snd u))) with (IZR (fst u) * IZR (snd t)) by (field; lra).
  assumption.
Qed.

Lemma same_instant n m t : (0 < m)%Z -> time_ok t = true -> (n * snd t = fst t * m)%Z -> IZR n / IZR m = instant t.
Proof.
  unfold time_ok, instant. intros Hm Ht H. apply Z.ltb_lt, IZR_lt in Ht. apply IZR_lt in Hm.
  apply (f_equal IZR) in H. rewrite !mult_IZR in H. apply Rmult_eq_reg_r with (IZR m * IZR (snd t)).
  - replace (IZR n / IZR m * (IZR m * IZR (snd t))) with (IZR n * IZR (snd t)) by (field; lra).
    replace (IZR (fst t) / IZR (snd t) * (IZR m * IZR (snd t))) with (IZR (fst t) * IZR m) by (field; lra). assumption.
  - assert (0 < IZR m * IZR (snd t)) by (apply Rmult_lt_0_compat; assumption). lra.
Qed.

(* ------------------------------------------------------------------ trajectories *)
Lemma rdot_sum {d} n U : length n = d ->
  rdot n U = sum (fun i : Fin.t d => IZR (nth (nat_of i) n 0%Z) * nth (nat_of i) U 0).
Proof.
  revert n U. induction d as [|d IH]; intros n U Hn.
  - destruct n; [reflexivity|discriminate].
  - destruct n as [|c n]; [discriminate|]. simpl in Hn. destruct U as [|u U].
    + simpl. rewrite (sum_same _ (fun _ => 0)), sum_zero; [ring|]. intros i. destruct (nat_of i); ring.
    + simpl. rewrite (IH n U) by lia. reflexivity.
Qed.

Lemma poly_dot_sum {d} A C t : length A = d ->
  ev (poly_dot A C) t = sum (fun i : Fin.t d => ev (nth (nat_of i) A []) t * ev (nth (nat_of i) C []) t).
Proof.
  revert A C. induction d as [|d IH]; intros A C HA.
  - destruct A; [reflexivity|discriminate].
  - destruct A as [|p A]; [discriminate|]. simpl in HA. destruct C as [|q C].
    + rewrite (sum_same _ (fun _ => 0)), sum_zero; [reflexivity|]. intros i.
      replace (nth (nat_of i) [] []) with (@nil Z) by (destruct (nat_of i); reflexivity).
      change (ev [] t) with 0. ring.
    + simpl poly_dot. rewrite ev_zadd, ev_zmul, (IH A C) by lia. reflexivity.
Qed.

Lemma is_zero_ev p t : is_zero p = true -> ev p t = 0.
Proof. unfold is_zero. rewrite <- ev_trim. destruct (trim p); [reflexivity|discriminate]. Qed.

Lemma column_entry {d} m k (i : Fin.t d) : nth (nat_of i) (column m k) [] = entry m (nat_of i) k.
Proof.
  unfold column, entry. rewrite <- (map_nth (fun r : list (list Z) => nth k r [])). f_equal.
  destruct k; reflexivity.
Qed.

Lemma nat_of_bound {d} (i : Fin.t d) : (nat_of i < d)%nat.
Proof. induction i; simpl; lia. Qed.
Lemma nat_of_eq {d} (i j : Fin.t d) : nat_of i = nat_of j <-> i = j.
Proof.
  split; [|intros ->; reflexivity]. induction i as [n|n i IH]; intros H.
  - apply (Fin.caseS' j (fun j => nat_of (Fin.F1 : Fin.t (S n)) = nat_of j -> Fin.F1 = j)); [reflexivity| |assumption].
    intros k Hk. discriminate.
  - revert H. apply (Fin.caseS' j (fun j => nat_of (Fin.FS i) = nat_of j -> Fin.FS i = j)); [discriminate|].
    intros k Hk. simpl in Hk. f_equal. apply IH. lia.
Qed.

Lemma inverts_value {d} p t (c P : point d) : inverts d p = true -> ev (forward_weight p) t <> 0 ->
  (forall i, ev (forward_weight p) t * P i = mapped (forward p) t c i) ->
  forall i, ev (backward_weight p) t * c i = mapped (backward p) t P i.
Proof.
  intros H Hh HP i. unfold inverts in H. apply andb_prop in H. destruct H as [_ H].
  rewrite forallb_forall in H. specialize (H (nat_of i)). unfold inverts_row in H.
  pose proof (nat_of_bound i) as Hi. rewrite in_seq in H. specialize (H ltac:(lia)).
  apply andb_prop in H. destruct H as [H Hcols]. apply andb_prop in H. destruct H as [Hlen Hconst].
  apply Nat.eqb_eq in Hlen. rewrite forallb_forall in Hcols.
  set (r := nth (nat_of i) (backward p) []) in *. set (h := ev (forward_weight p) t) in *.
  assert (length (tl r) = d) as Hr by (destruct r; simpl in *; lia).
  assert (forall j, nth (nat_of j) (tl r) [] = entry (backward p) (nat_of i) (S (nat_of (j : Fin.t d)))) as Hentry.
  { intros j. unfold entry. fold r. destruct r; [simpl in Hlen; lia|reflexivity]. }
  assert (hd [] r = entry (backward p) (nat_of i) 0) as Hhd by (unfold entry; fold r; destruct r; reflexivity).
  apply is_zero_ev with (t := t) in Hconst. rewrite ev_zadd, ev_zmul, (poly_dot_sum _ _ t Hr), Hhd in Hconst. fold h in Hconst.
  assert (forall k : Fin.t d, sum (fun j : Fin.t d => ev (entry (backward p) (nat_of i) (S (nat_of j))) t
      * ev (entry (forward p) (nat_of j) (S (nat_of k))) t)
    = if Nat.eqb (nat_of k) (nat_of i) then h * ev (backward_weight p) t else 0) as Hk.
  { intros k. specialize (Hcols (nat_of k)). rewrite in_seq in Hcols. pose proof (nat_of_bound k).
    specialize (Hcols ltac:(lia)). apply is_zero_ev with (t := t) in Hcols.
    unfold minus in Hcols. rewrite ev_zadd, ev_opp, (poly_dot_sum _ _ t Hr) in Hcols.
    rewrite (sum_same _ (fun j : Fin.t d => ev (nth (nat_of j) (tl r) []) t
      * ev (nth (nat_of j) (column (forward p) (S (nat_of k))) []) t)) by (intros j; rewrite Hentry, column_entry; reflexivity).
    destruct (Nat.eqb (nat_of k) (nat_of i)); [rewrite ev_zmul in Hcols; fold h in Hcols|change (ev [] t) with 0 in Hcols]; lra. }
  apply Rmult_eq_reg_l with h; [|assumption].
  unfold mapped. rewrite Rmult_plus_distr_l, <- sum_scale.
  rewrite (sum_same (fun j => h * (ev (entry (backward p) (nat_of i) (S (nat_of j))) t * P j))
    (fun j => ev (entry (backward p) (nat_of i) (S (nat_of j))) t * ev (entry (forward p) (nat_of j) 0) t
      + sum (fun k => ev (entry (backward p) (nat_of i) (S (nat_of j))) t
          * (ev (entry (forward p) (nat_of j) (S (nat_of k))) t * c k)))).
  2: { intros j. rewrite sum_scale. replace (h * (ev (entry (backward p) (nat_of i) (S (nat_of j))) t * P j))
       with (ev (entry (backward p) (nat_of i) (S (nat_of j))) t * (h * P j)) by ring. rewrite HP. unfold mapped. ring. }
  rewrite sum_plus, sum_exchange.
  rewrite (sum_same (fun k => sum (fun j => _)) (fun k => c k * (if Nat.eqb (nat_of k) (nat_of i) then h * ev (backward_weight p) t else 0))).
  2: { intros k. rewrite <- Hk, <- sum_scale. apply sum_same. intros j. ring. }
  rewrite (sum_same (fun j : Fin.t d => ev (entry (backward p) (nat_of i) (S (nat_of j))) t * ev (entry (forward p) (nat_of j) 0) t)
    (fun j => ev (nth (nat_of j) (tl r) []) t * ev (nth (nat_of j) (column (forward p) 0) []) t))
    by (intros j; rewrite Hentry, column_entry; reflexivity).
  rewrite (sum_same (fun k : Fin.t d => c k * (if Nat.eqb (nat_of k) (nat_of i) then h * ev (backward_weight p) t else 0))
    (fun k => (h * ev (backward_weight p) t) * (unit_matrix i k * c k))).
  2: { intros k. unfold unit_matrix. destruct (Nat.eqb_spec (nat_of k) (nat_of i)) as [E|E], (Fin.eq_dec i k) as [E'|E'].
       - ring.
       - exfalso. apply E'. symmetry. apply nat_of_eq, E.
       - exfalso. apply E. rewrite E'. reflexivity.
       - ring. }
  rewrite sum_scale, sum_unit. lra.
Qed.

Lemma curve_homogeneous {d} m w V t (c : point d) : length V = S d -> (0 < hd 0 V)%Z -> length m = d ->
  (forall i, ev w t * c i = mapped m t (point_of V) i) -> (forall i, (i < d)%nat -> length (nth i m []) = S d) ->
  homogeneous (map (fun p => ev p t) (curve_of m w V)) c.
Proof.
  intros HV Hq Hm Hc Hrows. exists (IZR (hd 0%Z V) * ev w t), (map (fun r => ev (trim (pull V r)) t) m).
  split; [simpl; rewrite ev_trim, ev_zscale, map_map; reflexivity|]. split; [rewrite map_length; assumption|].
  intros i. pose proof (nat_of_bound i) as Hi.
  rewrite (nth_indep _ 0 ((fun r => ev (trim (pull V r)) t) [])) by (rewrite map_length; lia).
  rewrite (map_nth (fun r => ev (trim (pull V r)) t)), ev_trim, ev_pull.
  replace (IZR (hd 0%Z V) * ev w t * c i) with (IZR (hd 0%Z V) * (ev w t * c i)) by ring. rewrite Hc.
  destruct V as [|q V]; [discriminate|]. simpl in HV, Hq. apply IZR_lt in Hq.
  specialize (Hrows (nat_of i) Hi). unfold mapped, entry. destruct (nth (nat_of i) m []) as [|b r]; [discriminate|].
  simpl. rewrite (rdot_sum (d := d)) by lia. rewrite Rmult_plus_distr_l, <- sum_scale.
  f_equal. apply sum_same. intros j. unfold point_of. simpl.
  rewrite (nth_indep _ 0 (ev [] t)) by (rewrite map_length; simpl in Hrows; pose proof (nat_of_bound j); lia).
  rewrite (map_nth (fun p => ev p t)). field. lra.
Qed.

Lemma homogeneous_opposite {d} C t (c : point d) : homogeneous (map (fun p => ev p t) C) c ->
  homogeneous (map (fun p => ev p t) (map (map Z.opp) C)) c.
Proof.
  intros (w & U & E & HU & H). exists (- w), (map Ropp U). rewrite map_map.
  rewrite (map_ext _ (fun p => - ev p t)) by (intros; apply ev_opp).
  split; [rewrite <- (map_map (fun p => ev p t) Ropp), E; reflexivity|]. split; [rewrite map_length; assumption|].
  intros i. replace 0 with (- 0) by ring. rewrite map_nth, H. ring.
Qed.

(* ------------------------------------------------------------------ intervals in a row *)
Lemma cuts_app s a l b m c : cuts s a l b -> cuts s b m c -> (forall x y, s b x -> s b y -> x = y) ->
  cuts s a (l ++ tl m) c.
Proof.
  intros Hl Hm Hf. induction Hl as [a p Hp|a b c' p x l Hab Hp Hx Hl IH].
  - destruct (cuts_head _ _ _ _ Hm) as (q & r & -> & Hq). simpl. rewrite (Hf p q Hp Hq). assumption.
  - simpl. econstructor; eauto.
Qed.

Lemma same_word_eq u v : same_word u v = true -> u = v.
Proof.
  revert v. induction u as [|x u IH]; intros [|y v] H; try discriminate; [reflexivity|].
  simpl in H. apply andb_prop in H. destruct H as [H1 H2]. apply state_eqb_eq in H1. f_equal; auto.
Qed.

Section Row.
Context {d : nat} (F : list facet) (A : set (S d)) (c : R -> point (S d)) (first last : time)
  (cs : list (time * time * list (list Z))).
Hypothesis HL : legal F A.
Hypothesis bounds_hold : forall f g (x : point (S d)), In f F -> In g (bounds f) -> on f x -> 0 <= zvalue g x.
Hypothesis Hcs : forall p q C, In (p, q, C) cs -> time_ok p = true /\ time_ok q = true /\
  forall t, instant p <= t <= instant q -> homogeneous (map (fun f => ev f t) C) (c t).
Let s (t : R) (x : state) := state_at A (c t) x.
Hypothesis opens : forall x, x <> B -> open_in s (instant first) (instant last) x.
Hypothesis (first_ok : time_ok first = true) (last_ok : time_ok last = true).

Lemma step_sound t u k q : time_ok t = true -> time_ok u = true -> not_after first t = true ->
  not_after u last = true -> step_ok F cs t u k q = true -> cuts s (instant t) (letters k) (instant u).
Proof.
  intros Ht Hu Hfirst Hlast H. unfold step_ok in H.
  destruct (find (within_piece t u) cs) as [[[p r] C]|] eqn:E; [|discriminate].
  apply find_some in E. destruct E as [Hin Hw]. apply andb_prop in Hw. destruct Hw as [Hp Hr]. simpl in Hp, Hr.
  destruct (Hcs p r C Hin) as (Tp & Tr & Hhom). cbn [snd] in H.
  set (l := (fst t * (snd u / Z.gcd (snd t) (snd u)))%Z) in *.
  set (h := (fst u * (snd t / Z.gcd (snd t) (snd u)))%Z) in *.
  set (e := (snd t * (snd u / Z.gcd (snd t) (snd u)))%Z) in *.
  set (v := oriented l h e C) in *.
  apply andb_prop in H. destruct H as [H Hint]. apply andb_prop in H. destruct H as [Htimes Hview].
  apply andb_prop in Htimes. destruct Htimes as [E1 E2]. apply Z.eqb_eq in E1, E2.
  assert (0 < den v)%Z as Hden.
  { unfold view_ok in Hview. repeat (apply andb_prop in Hview as [Hview ?]). apply Z.ltb_lt, Hview. }
  pose proof (same_instant _ _ _ Hden Ht E1) as I1. pose proof (same_instant _ _ _ Hden Hu E2) as I2.
  assert (forall w, within (lo v) (hi v) (den v) w <-> instant t <= w <= instant u) as Hwithin.
  { intros w. rewrite <- I1, <- I2. apply IZR_lt in Hden. unfold within. split; intros [K1 K2]; split.
    - apply Rmult_le_reg_l with (1 := Hden). replace (IZR (den v) * (IZR (lo v) / IZR (den v))) with (IZR (lo v)) by (field; lra). assumption.
    - apply Rmult_le_reg_l with (1 := Hden). replace (IZR (den v) * (IZR (hi v) / IZR (den v))) with (IZR (hi v)) by (field; lra). assumption.
    - replace (IZR (lo v)) with (IZR (den v) * (IZR (lo v) / IZR (den v))) by (field; lra). apply Rmult_le_compat_l; lra.
    - replace (IZR (hi v)) with (IZR (den v) * (IZR (hi v) / IZR (den v))) by (field; lra). apply Rmult_le_compat_l; lra. }
  pose proof (not_after_instant _ _ Tp Ht Hp). pose proof (not_after_instant _ _ Hu Tr Hr).
  pose proof (not_after_instant _ _ first_ok Ht Hfirst). pose proof (not_after_instant _ _ Hu last_ok Hlast).
  rewrite <- I1, <- I2.
  apply (interval_sound v c F A HL bounds_hold Hview) with (q := trim (primitive q)).
  - unfold v, oriented. destruct (Z.eqb _ _); reflexivity.
  - intros w Hw. apply Hwithin in Hw.
    assert (curve v = C \/ curve v = map (map Z.opp) C) as [-> | ->]
      by (unfold v, oriented; destruct (Z.eqb _ _); auto); [|apply homogeneous_opposite]; apply Hhom; lra.
  - intros x w Hx Hw Hs. apply Hwithin in Hw. destruct (opens x Hx w ltac:(lra) Hs) as (e' & He & K).
    exists e'. split; [assumption|]. intros z Hz Hzw. apply Hwithin in Hz. apply K; [lra|assumption].
  - assumption.
Qed.

Lemma follow_sound l : forall t m, time_ok t = true -> follow F cs first last t l = Some m ->
  cuts s (instant t) m (instant last).
Proof.
  induction l as [|[[k u] q] l IH]; intros t m Ht H; [discriminate|].
  cbn [follow] in H.
  destruct (time_ok u && not_after first t && not_after u last && step_ok F cs t u k q) eqn:E; [|discriminate].
  apply andb_prop in E. destruct E as [E Hstep]. apply andb_prop in E. destruct E as [E Hlast].
  apply andb_prop in E. destruct E as [Hu Hfirst].
  pose proof (step_sound t u k q Ht Hu Hfirst Hlast Hstep) as Hc.
  destruct l as [|i l'].
  - destruct (same_time u last) eqn:Es; [|discriminate]. inversion H; subst.
    apply Z.eqb_eq in Es. replace (instant last) with (instant u); [assumption|].
    apply same_instant; [apply Z.ltb_lt, Hu|assumption|assumption].
  - destruct (follow F cs first last u (i :: l')) as [n|] eqn:En; [|discriminate]. inversion H; subst.
    apply cuts_app with (instant u); [assumption|apply IH; assumption|]. intros x y. apply state_functional.
Qed.
End Row.

(* ------------------------------------------------------------------ the row *)
Section Accepted.
Context {d : nat} (F : list facet) (A : set (S d)) (ps : list piece)
  (M : motion (S d) (instant (first_time ps)) (instant (last_time ps))) (V : list Z) (f : folds) (r : row).
Hypothesis HL : legal F A.
Hypothesis bounds_hold : forall f g (x : point (S d)), In f F -> In g (bounds f) -> on f x -> 0 <= zvalue g x.
Hypothesis HM : given_by ps M.

Let P : point (S d) := point_of V.
(* The trajectory: inverted for a sweep, forward for an unsweep. *)
Definition path (o : operation) (t : R) : point (S d) :=
  match o with sweeping => back M t P | unsweeping => move M t P end.

Lemma times_in p : In p ps -> forallb (fun p => time_ok (begins p) && time_ok (finishes p) && inverts (S d) p) ps = true ->
  time_ok (begins p) = true /\ time_ok (finishes p) = true /\ inverts (S d) p = true.
Proof.
  intros Hp H. rewrite forallb_forall in H. specialize (H p Hp).
  apply andb_prop in H. destruct H as [H H3]. apply andb_prop in H. tauto.
Qed.

Theorem row_sound o : check_row o f (S d) F ps V r = true ->
  (forall p, In p ps -> instant (first_time ps) <= instant (begins p) /\ instant (finishes p) <= instant (last_time ps)) ->
  is_word (fun t => state_at A (path o t)) (instant (first_time ps)) (instant (last_time ps)) (word_of r)
  /\ claims_ok o f r = true.
Proof.
  intros H Hinside. unfold check_row in H.
  apply andb_prop in H. destruct H as [H Hfollow]. apply andb_prop in H. destruct H as [H Hclaims].
  apply andb_prop in H. destruct H as [H Hps]. apply andb_prop in H. destruct H as [HV Hq].
  apply Nat.eqb_eq in HV. apply Z.ltb_lt in Hq. split; [|exact Hclaims].
  destruct (follow _ _ _ _ _ _) as [l|] eqn:E; [|discriminate]. apply same_word_eq in Hfollow. rewrite <- Hfollow.
  apply word_of_cuts; [intros t x y _; apply state_functional|].
  assert (exists p, In p ps /\ begins p = first_time ps) as (p0 & Hp0 & E0).
  { destruct ps as [|p ps']; [|exists p; split; [left|]; reflexivity].
    destruct (intervals r) as [|[[k u] q] l']; [discriminate|]. cbn [follow] in E.
    rewrite andb_comm in E. simpl in E. discriminate. }
  assert (exists p, In p ps /\ finishes p = last_time ps) as (p1 & Hp1 & E1).
  { clear - Hp0. assert (exists p, In p ps) as Hne by eauto. clear Hp0 p0.
    induction ps as [|p rest IH]; [destruct Hne as (p & []) |]. destruct rest as [|q rest].
    - exists p. split; [left|]; reflexivity.
    - destruct IH as (p1 & H1 & E1); [exists q; left; reflexivity|]. exists p1. split; [right; exact H1|exact E1]. }
  destruct (times_in p0 Hp0 Hps) as (T0 & _ & _). destruct (times_in p1 Hp1 Hps) as (_ & T1 & _).
  rewrite E0 in T0. rewrite E1 in T1.
  apply (follow_sound F A (path o) (first_time ps) (last_time ps) (map (curve_on o V) ps)) with (l := intervals r);
    try assumption.
  - intros a b C Hin. apply in_map_iff in Hin. destruct Hin as (p & Ep & Hp). unfold curve_on in Ep.
    inversion Ep; subst a b. clear Ep. destruct (times_in p Hp Hps) as (T2 & T3 & Hinv).
    split; [assumption|]. split; [assumption|]. intros t Ht.
    pose proof (Hinside p Hp) as [B1 B2]. destruct (HM p t Hp Ht) as [Hh Hmove].
    pose proof Hinv as Hshape. unfold inverts in Hshape. apply andb_prop in Hshape. destruct Hshape as [Hshape Hrows].
    apply andb_prop in Hshape. destruct Hshape as [Hshape Hfrows]. apply andb_prop in Hshape. destruct Hshape as [Hb Hf].
    apply Nat.eqb_eq in Hb, Hf. rewrite forallb_forall in Hrows, Hfrows.
    destruct o.
    + apply curve_homogeneous; try assumption.
      * apply (inverts_value p t (back M t P) P Hinv Hh). intros i. rewrite <- Hmove.
        rewrite move_back by lra. reflexivity.
      * intros i Hi. specialize (Hrows i). rewrite in_seq in Hrows. specialize (Hrows ltac:(lia)).
        unfold inverts_row in Hrows. apply andb_prop in Hrows. destruct Hrows as [Hrows _].
        apply andb_prop in Hrows. destruct Hrows as [Hrows _]. apply Nat.eqb_eq, Hrows.
    + apply curve_homogeneous; try assumption.
      * intros i. apply Hmove.
      * intros i Hi. apply Nat.eqb_eq, Hfrows, nth_In. lia.
  - intros x Hx. destruct o; apply open_along; try apply back_continuous; try apply move_continuous;
      destruct x; try congruence; apply interior_open.
Qed.
End Accepted.
