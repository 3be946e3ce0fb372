(* Convex solids: a test of their oriented simplices that proves them legal.
   SPDX-License-Identifier: GPL-3.0-or-later

   [kept]         the points behind all simplices' planes
   [convex_ok]    the test, by signs of integers: every simplex behind every plane, a point behind all strictly,
                  faces covered by their simplices, simplices apart, and bounded
   [convex_legal] then the simplices are a legal solid, and it is [kept]
   [convex_checked_plane], [convex_checked_space], [convex_unsweep_plane], [convex_unsweep_space]   so of such
                  solids what the checker accepts is true without a hypothesis *)
Require Import Reals Lra Lia List ZArith Bool Classical.
Require Fin.
Require Import Graze.words Graze.definitions Graze.space Graze.sweep Graze.affine Graze.bernstein Graze.facets
  Graze.sample Graze.interval Graze.row Graze.simplices Graze.checker.
Import ListNotations.
Open Scope R_scope.

Definition kept {d} (scale : Z) (ss : list simplex) : set d :=
  fun x => forall s, In s ss -> zvalue (outward scale s) x <= 0.

(* ------------------------------------------------------------------ the test *)
(* Negative at vertex k, zero at the others. *)
Fixpoint only (k : nat) (l : list Z) : bool :=
  match l, k with
  | [], _ => false
  | c :: rest, 0%nat => Z.ltb c 0 && zero_list rest
  | c :: rest, S n => Z.eqb c 0 && only n rest
  end.
(* All vertices of s but its k are vertices of u: this keeps the walk short, and nothing rests on it. *)
Definition joined (k : nat) (s u : simplex) : bool :=
  forallb (fun i => Nat.eqb i k || existsb (same_list (nth i s [])) u) (seq 0 (length s)).
(* What of the face's plane is behind all planes is in a simplex of it: beyond a side of s there is nothing, or a
   neighbour in the same plane, from which the walk goes on; it does not return through the side where it entered. *)
Fixpoint walk (scale : Z) (ss : list simplex) (fuel : nat) (s : simplex) (entered : option nat) : bool :=
  forallb (fun k =>
    if match entered with Some e => Nat.eqb e k | None => false end then true else
    if existsb (fun u => only k (at_vertices scale s (outward scale u))) ss then true else
    match fuel with
    | 0%nat => false
    | S n => existsb (fun u =>
        if zero_list (at_vertices scale s (outward scale u)) then
          if joined k s u then
            existsb (fun j => if only k (at_vertices scale s (nth j (sides_of scale u) []))
              then walk scale ss n u (Some j) else false) (seq 0 (length u))
          else false
        else false) ss
    end) (seq 0 (length s)).

(* The vertices' mean, as a weight and coordinates times it. *)
Definition middle (scale : Z) (ss : list simplex) : list Z :=
  fold_right zadd [] (map (cons scale) (concat ss)).
Definition depth (scale : Z) (ss : list simplex) (s : simplex) : Z := (- zdot (outward scale s) (middle scale ss))%Z.

Definition behind (scale : Z) (s u : simplex) : list Z := map Z.opp (at_vertices scale s (outward scale u)).
Definition pair_ok (scale : Z) (ss : list simplex) (s u : simplex) : bool :=
  forallb (Z.leb 0) (behind scale s u)
  && (existsb (Z.ltb 0) (behind scale s u)
      || zero_list (minus (zscale (depth scale ss s) (outward scale u)) (zscale (depth scale ss u) (outward scale s)))).

Definition beyond_side (scale : Z) (s u : simplex) : bool :=
  existsb (fun h => forallb (Z.leb 0) (map Z.opp (at_vertices scale s h))) (sides_of scale u).
Definition parted (scale : Z) (s u : simplex) : bool :=
  existsb (Z.ltb 0) (behind scale s u) || beyond_side scale s u || beyond_side scale u s.
Fixpoint all_apart (scale : Z) (ss : list simplex) : bool :=
  match ss with [] => true | s :: rest => forallb (parted scale s) rest && all_apart scale rest end.

(* The forms' sum is a constant, so each is bounded; coordinates are combinations of the forms of d simplices. *)
Definition form_sum (scale : Z) (ss : list simplex) : list Z := fold_right zadd [] (map (outward scale) ss).
Definition cross (a b : list Z) (i : nat) : Z :=
  let c := nth ((i + 1) mod 3) in let e := nth ((i + 2) mod 3) in (c a 0 * e b 0 - e a 0 * c b 0)%Z.
Definition weights_for (d : nat) (s u v : simplex) (i : nat) : list Z :=
  let a := normal_of s in let b := normal_of u in let c := normal_of v in
  match d with
  | 2%nat => let j := (1 - i)%nat in [nth j b 0; - nth j a 0]%Z
  | _ => [cross b c i; cross c a i; cross a b i]
  end.
Definition axis_of (scale : Z) (d : nat) (s u v : simplex) (i : nat) : list Z :=
  pull (weights_for d s u v i) (map (outward scale) [s; u; v]).
Definition spans_axis (scale : Z) (d : nat) (s u v : simplex) (i : nat) : bool :=
  let g := axis_of scale d s u v i in
  let k := nth (S i) g 0%Z in
  negb (Z.eqb k 0) && zero_list (minus g (hd 0%Z g :: repeat 0%Z i ++ [k])).
Definition bounded_ok (scale : Z) (d : nat) (ss : list simplex) : bool :=
  zero_list (tl (form_sum scale ss))
  && existsb (fun u => existsb (fun v => forallb (spans_axis scale d (hd [] ss) u v) (seq 0 d)) ss) ss.

Definition facet_at (scale : Z) (d : nat) (s : simplex) : facet :=
  {| plane := outward scale s; sides := sides_of scale s; bounds := bounds_of scale d s |}.
Definition longest_walk : nat := 8.
Definition convex_ok (scale : Z) (d : nat) (ss : list simplex) : bool :=
  forallb (fun s => facet_ok scale d s (facet_at scale d s)) ss
  && Nat.eqb (length (middle scale ss)) (S d) && Z.ltb 0 (hd 0%Z (middle scale ss))
  && forallb (fun s => Z.ltb 0 (depth scale ss s)) ss
  && forallb (fun s => forallb (pair_ok scale ss s) ss) ss
  && all_apart scale ss && bounded_ok scale d ss
  && forallb (fun s => walk scale ss longest_walk s None) ss.

(* ------------------------------------------------------------------ lines and margins *)
Definition line {d} (x y : point d) (r : R) : point d := fun i => x i + r * (y i - x i).
Lemma zvalue_line {d} f (x y : point d) r : zvalue f (line x y r) = (1 - r) * zvalue f x + r * zvalue f y.
Proof.
  unfold line. rewrite (zvalue_plus f x (fun i => r * (y i - x i))), dot_times.
  assert (dot (tl f) (fun i => y i - x i) = dot (tl f) y - dot (tl f) x) as ->.
  { rewrite (dot_same _ (fun i => y i - x i) (fun i => y i + (-1) * x i)) by (intros; ring).
    rewrite dot_plus, dot_times. ring. }
  unfold zvalue. ring.
Qed.
Lemma line_near {d} (x y : point d) e : e > 0 -> exists r, r > 0 /\ forall s, Rabs s <= r -> near x e (line x y s).
Proof.
  intros He. destruct (common_margin (fun (i : Fin.t d) r => forall s, Rabs s <= r -> Rabs (s * (y i - x i)) < e)) as (r & Hr & H).
  - intros i r s H Hs u Hu. apply H. lra.
  - intros i. pose proof (Rabs_pos (y i - x i)) as Hp. exists (e / (1 + Rabs (y i - x i))).
    assert (e / (1 + Rabs (y i - x i)) > 0) as Hq by (apply Rdiv_lt_0_compat; lra). split; [exact Hq|].
    intros s Hs. rewrite Rabs_mult. apply Rle_lt_trans with (e / (1 + Rabs (y i - x i)) * Rabs (y i - x i)).
    + apply Rmult_le_compat_r; assumption.
    + replace e with (e / (1 + Rabs (y i - x i)) * (1 + Rabs (y i - x i))) at 2 by (field; lra).
      apply Rmult_lt_compat_l; lra.
  - exists r. split; [assumption|]. intros s Hs i. unfold line.
    replace (x i + s * (y i - x i) - x i) with (s * (y i - x i)) by ring. apply H, Hs.
Qed.
Lemma negative_near {d} (fs : list (list Z)) (x : point d) : (forall f, In f fs -> zvalue f x < 0) ->
  exists e, e > 0 /\ forall y, near x e y -> forall f, In f fs -> zvalue f y < 0.
Proof.
  induction fs as [|f fs IH]; intros H; [exists 1; split; [lra|intros y _ f []]|].
  destruct IH as (e & He & K); [intros g Hg; apply H; right; exact Hg|].
  destruct (dot_bound (d := d) (tl f)) as (c & Hc & L). pose proof (H f (or_introl eq_refl)) as Hf.
  set (m := - zvalue f x / (1 + c)). assert (0 < m) as Hm by (apply Rdiv_lt_0_compat; lra).
  assert (c * m < - zvalue f x) as Hcm.
  { replace (- zvalue f x) with ((1 + c) * m) by (unfold m; field; lra). lra. }
  exists (Rmin e m). split; [apply Rmin_pos; assumption|]. intros y Hy g [<-|Hg].
  - specialize (L x y m (near_less _ _ _ _ Hy (Rmin_r e m))). pose proof (Rle_abs (dot (tl f) y - dot (tl f) x)).
    unfold zvalue in *. lra.
  - exact (K y (near_less _ _ _ _ Hy (Rmin_l e m)) g Hg).
Qed.

(* ------------------------------------------------------------------ dot products of lists *)
Lemma rdot_opposite l w : rdot (map Z.opp l) w = - rdot l w.
Proof.
  revert w. induction l as [|c l IH]; intros [|u w]; simpl; try ring. rewrite IH, opp_IZR. ring.
Qed.
Lemma rdot_only k l w : only k l = true -> exists c, c < 0 /\ rdot l w = c * nth k w 0.
Proof.
  revert k w. induction l as [|c l IH]; intros k w H; [destruct k; discriminate|]. destruct k as [|k]; simpl in H;
    apply andb_prop in H; destruct H as [Hc Hl].
  - apply Z.ltb_lt, IZR_lt in Hc. exists (IZR c). split; [assumption|]. destruct w as [|u w]; simpl; [ring|].
    rewrite (rdot_zero l w Hl). ring.
  - apply Z.eqb_eq in Hc. subst c. destruct w as [|u w]; [exists (-1); split; [lra|simpl; ring]|].
    destruct (IH k w Hl) as (c & Hc & E). exists c. split; [assumption|]. simpl. rewrite E. ring.
Qed.
Lemma zvalue_form_sum {d} scale ss (x : point d) :
  zvalue (form_sum scale ss) x = fold_right Rplus 0 (map (fun s => zvalue (outward scale s) x) ss).
Proof.
  unfold form_sum. induction ss as [|s ss IH]; cbn [map fold_right]; [apply zvalue_none|]. rewrite zvalue_zadd, IH. reflexivity.
Qed.
Lemma rdot_bounded n V K : 0 <= K -> (forall v, In v V -> Rabs v <= K) ->
  Rabs (rdot n V) <= K * fold_right Rplus 0 (map (fun c => Rabs (IZR c)) n).
Proof.
  intros HK. revert V. induction n as [|c n IH]; intros V HV; [simpl; rewrite Rabs_R0; lra|].
  assert (0 <= fold_right Rplus 0 (map (fun c => Rabs (IZR c)) n)) as Hn.
  { clear. induction n as [|c n IH]; simpl; [lra|]. pose proof (Rabs_pos (IZR c)). lra. }
  pose proof (Rabs_pos (IZR c)) as Hc. pose proof (Rmult_le_pos _ _ HK Hn). pose proof (Rmult_le_pos _ _ HK Hc).
  destruct V as [|v V]; simpl; [rewrite Rabs_R0; lra|].
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  specialize (IH V (fun u Hu => HV u (or_intror Hu))).
  pose proof (Rmult_le_compat_l _ _ _ Hc (HV v (or_introl eq_refl))). lra.
Qed.
Lemma one_bound {n} (P : Fin.t n -> R -> Prop) : (forall i a b, P i a -> a <= b -> P i b) ->
  (forall i, exists b, P i b) -> exists b, forall i, P i b.
Proof.
  intros Hmore H. induction n as [|n IH].
  - exists 0. intros i. apply (Fin.case0 (fun i => P i 0) i).
  - destruct (H Fin.F1) as (a & Ha). destruct (IH (fun i => P (Fin.FS i))) as (b & Hb).
    + intros i. apply Hmore.
    + intros i. apply H.
    + exists (Rmax a b). intros i. apply (Fin.caseS' i (fun i => P i (Rmax a b))).
      * apply Hmore with a; [assumption|apply Rmax_l].
      * intros j. apply Hmore with b; [apply Hb|apply Rmax_r].
Qed.

(* ------------------------------------------------------------------ the proof *)
Section Convex.
Context {d : nat} (scale : Z) (ss : list simplex).
Hypothesis Hfacets : forall s, In s ss -> facet_ok scale (S d) s (facet_at scale (S d) s) = true.
Hypothesis Hlength : length (middle scale ss) = S (S d).
Hypothesis Hweight : (0 < hd 0 (middle scale ss))%Z.
Hypothesis Hdepth : forall s, In s ss -> (0 < depth scale ss s)%Z.
Hypothesis Hpairs : forall s u, In s ss -> In u ss -> pair_ok scale ss s u = true.
Hypothesis Happart : all_apart scale ss = true.
Hypothesis Hbounded : bounded_ok scale (S d) ss = true.
Hypothesis Hwalk : forall s, In s ss -> walk scale ss longest_walk s None = true.

Let A : set (S d) := kept scale ss.
Let center : point (S d) := point_of (middle scale ss).
Let form (s : simplex) := outward scale s.

Lemma center_value f : IZR (zdot f (middle scale ss)) = IZR (hd 0%Z (middle scale ss)) * zvalue f center.
Proof.
  rewrite zdot_rdot. rewrite (rdot_value f _ center).
  - unfold weight. destruct (middle scale ss); reflexivity.
  - unfold center, point_of. apply IZR_lt in Hweight. destruct (middle scale ss) as [|w U]; [discriminate|].
    exists (IZR w), (map IZR U). simpl in *. split; [reflexivity|]. split; [rewrite map_length; lia|].
    intros i. rewrite (map_nth IZR U 0%Z (nat_of i)). field. lra.
Qed.
Lemma center_inside s : In s ss -> zvalue (form s) center < 0.
Proof.
  intros Hs. pose proof (Hdepth s Hs) as H. unfold depth in H. apply IZR_lt in H. rewrite opp_IZR, center_value in H.
  apply IZR_lt in Hweight. apply Rmult_lt_reg_l with (1 := Hweight). unfold form. lra.
Qed.
Lemma scale_positive s : In s ss -> 0 < IZR scale.
Proof. intros Hs. apply (facet_facts _ _ _ (Hfacets s Hs)). Qed.

(* ---- topology *)
Lemma strict_interior x : (forall s, In s ss -> zvalue (form s) x < 0) -> interior A x.
Proof.
  intros H. destruct (negative_near (map form ss) x) as (e & He & K).
  - intros f Hf. apply in_map_iff in Hf. destruct Hf as (s & <- & Hs). apply H, Hs.
  - exists e. split; [assumption|]. intros y Hy s Hs. apply Rlt_le, (K y Hy), in_map, Hs.
Qed.
Lemma interior_strict x s : interior A x -> In s ss -> zvalue (form s) x < 0.
Proof.
  intros (e & He & H) Hs. destruct (line_near x center e He) as (r & Hr & K).
  assert (A (line x center (- r))) as HA by (apply H, K; rewrite Rabs_Ropp, Rabs_right; lra).
  specialize (HA s Hs). fold (form s) in HA. rewrite zvalue_line in HA. pose proof (center_inside s Hs) as Hc.
  apply Rnot_le_lt. intros N. pose proof (Rmult_le_pos (1 + r) _ ltac:(lra) N).
  pose proof (Rmult_lt_0_compat r (- zvalue (form s) center) Hr ltac:(lra)). lra.
Qed.
Lemma outside_open x s : In s ss -> 0 < zvalue (form s) x -> interior (complement A) x.
Proof.
  intros Hs H. destruct (negative_near [zscale (-1) (form s)] x) as (e & He & K).
  - intros f [<-|[]]. rewrite zvalue_zscale. lra.
  - exists e. split; [assumption|]. intros y Hy N. specialize (K y Hy _ (or_introl eq_refl)).
    rewrite zvalue_zscale in K. specialize (N s Hs). unfold form in K. lra.
Qed.
Lemma outside_side x : ~ A x -> exists s, In s ss /\ 0 < zvalue (form s) x.
Proof.
  intros H. apply NNPP. intros N. apply H. intros s Hs. apply Rnot_lt_le. intros K. apply N. eauto.
Qed.
Lemma kept_closed : closed_set A.
Proof. intros x Hx. destruct (outside_side x Hx) as (s & Hs & K). exact (outside_open x s Hs K). Qed.
Lemma kept_regular : regular_closed A.
Proof.
  intros x. split.
  - intros Hx e He. destruct (line_near x center e He) as (r & Hr & K).
    pose proof (Rmin_l 1 r). pose proof (Rmin_r 1 r). pose proof (Rmin_pos 1 r ltac:(lra) Hr).
    exists (line x center (Rmin 1 r)). split; [apply K; rewrite Rabs_right; lra|].
    apply strict_interior. intros s Hs. rewrite zvalue_line. pose proof (center_inside s Hs) as Hc.
    specialize (Hx s Hs). fold (form s) in Hx.
    pose proof (Rmult_le_pos (1 - Rmin 1 r) (- zvalue (form s) x) ltac:(lra) ltac:(lra)).
    pose proof (Rmult_lt_0_compat (Rmin 1 r) (- zvalue (form s) center) ltac:(lra) ltac:(lra)). lra.
  - intros H. apply NNPP. intros N. apply kept_closed in N. apply (proj1 (closure_not_outside A x)); [|exact N].
    revert H. apply closure_mono, interior_in.
Qed.

(* ---- values on a simplex *)
Lemma hull_behind s u (x : point (S d)) : In s ss -> In u ss -> in_hull scale s x -> zvalue (form u) x <= 0.
Proof.
  intros Hs Hu (w & W & Hpos). destruct (facet_facts _ _ _ (Hfacets s Hs)) as (H0 & _ & _ & Hl & _).
  pose proof (weighted_value scale s w x (form u) Hl W) as E.
  pose proof (Hpairs s u Hs Hu) as P. apply andb_prop in P. destruct P as [P _].
  pose proof (rdot_not_negative _ w P Hpos) as Q. unfold behind in Q. rewrite rdot_opposite in Q.
  apply Rmult_le_reg_l with (1 := H0). unfold form in *. lra.
Qed.
Lemma hull_on s (x : point (S d)) : In s ss -> in_hull scale s x -> zvalue (form s) x = 0.
Proof. intros Hs H. apply (facet_on _ _ _ (Hfacets s Hs)) in H. apply H. Qed.
Lemma inner_hull s (x : point (S d)) : in_relative_interior scale s x -> in_hull scale s x.
Proof. intros (w & W & H). exists w. split; [assumption|]. intros u Hu. apply Rlt_le, H, Hu. Qed.
Lemma inner_form s h (x : point (S d)) : In s ss -> in_relative_interior scale s x ->
  forallb (Z.leb 0) (map Z.opp (at_vertices scale s h)) = true ->
  zvalue h x <= 0 /\ (existsb (Z.ltb 0) (map Z.opp (at_vertices scale s h)) = true -> zvalue h x < 0).
Proof.
  intros Hs (w & W & Hpos) P. destruct (facet_facts _ _ _ (Hfacets s Hs)) as (H0 & _ & _ & Hl & _).
  pose proof (weighted_value scale s w x h Hl W) as E.
  assert (forall u, In u w -> 0 <= u) as Hpos' by (intros u Hu; apply Rlt_le, Hpos, Hu). split.
  - pose proof (rdot_not_negative _ w P Hpos') as Q. rewrite rdot_opposite in Q. apply Rmult_le_reg_l with (1 := H0). lra.
  - intros X. assert (0 < rdot (map Z.opp (at_vertices scale s h)) w) as Q.
    { apply rdot_positive; try assumption. unfold at_vertices. rewrite !map_length. apply W. }
    rewrite rdot_opposite in Q. apply Rmult_lt_reg_l with (1 := H0). lra.
Qed.

Lemma walk_covers fuel : forall s entered (x : point (S d)), In s ss -> walk scale ss fuel s entered = true -> A x ->
  zvalue (form s) x = 0 ->
  match entered with Some e => 0 <= zvalue (nth e (sides_of scale s) []) x | None => True end ->
  exists u, In u ss /\ in_hull scale u x.
Proof.
  induction fuel as [|n IH]; intros s entered x Hs Hw Hx H0 He;
  (destruct (classic (forall k, (k < length s)%nat -> 0 <= zvalue (nth k (sides_of scale s) []) x)) as [Hall|Hsome];
  [ exists s; split; [assumption|]; apply (facet_on _ _ _ (Hfacets s Hs)); split; [exact H0|];
    intros g Hg; destruct (In_nth _ _ [] Hg) as (k & Hk & <-); apply Hall;
    rewrite <- (proj1 (proj2 (proj2 (facet_facts _ _ _ (Hfacets s Hs))))); exact Hk | ];
  apply not_all_ex_not in Hsome; destruct Hsome as (k & Hk); apply imply_to_and in Hk; destruct Hk as (Hk & Hneg);
  apply Rnot_le_lt in Hneg;
  destruct (facet_facts _ _ _ (Hfacets s Hs)) as (Hscale & HD & Hn & Hl & Hweights & _);
  specialize (Hweights x H0); set (w := map _ _) in Hweights; simpl in Hn;
  assert (nth k w 0 < 0) as Hwk by
    (unfold w; simpl sides; rewrite (nth_indep _ 0 (zvalue [] x / IZR (Z.abs (coordinate (first_axis (normal_of s)) (normal_of s)))))
       by (rewrite map_length, Hn; exact Hk);
     rewrite (map_nth (fun g => zvalue g x / _)); unfold Rdiv;
     pose proof (Rinv_0_lt_compat _ HD) as HD'; pose proof (Rmult_lt_0_compat _ _ HD' (Ropp_0_gt_lt_contravar _ Hneg)); lra);
  simpl walk in Hw; rewrite forallb_forall in Hw; specialize (Hw k ltac:(apply in_seq; lia));
  destruct (match entered with Some e => Nat.eqb e k | None => false end) eqn:Ee;
  [ destruct entered as [e|]; [|discriminate]; apply Nat.eqb_eq in Ee; subst e; lra | ];
  destruct (existsb (fun u => only k (at_vertices scale s (outward scale u))) ss) eqn:Eo;
  [ apply existsb_exists in Eo; destruct Eo as (u & Hu & Eo);
    destruct (rdot_only _ _ w Eo) as (c & Hc & E);
    rewrite <- (weighted_value scale s w x (outward scale u) Hl Hweights) in E;
    specialize (Hx u Hu); pose proof (Rmult_le_pos (IZR scale) (- zvalue (outward scale u) x) ltac:(lra) ltac:(lra));
    pose proof (Rmult_lt_0_compat (- c) (- nth k w 0) ltac:(lra) ltac:(lra)); lra | ]).
  - discriminate.
  - apply existsb_exists in Hw. destruct Hw as (u & Hu & Hw).
    destruct (zero_list (at_vertices scale s (outward scale u))) eqn:Ez; [|discriminate].
    destruct (joined k s u); [|discriminate].
    apply existsb_exists in Hw. destruct Hw as (j & Hj & Hw).
    destruct (only k (at_vertices scale s (nth j (sides_of scale u) []))) eqn:Ej; [|discriminate].
    apply (IH u (Some j) x Hu Hw Hx).
    + pose proof (weighted_value scale s w x (outward scale u) Hl Hweights) as E. rewrite (rdot_zero _ w Ez) in E.
      apply Rmult_integral in E. destruct E; [lra|assumption].
    + destruct (rdot_only _ _ w Ej) as (c & Hc & E).
      rewrite <- (weighted_value scale s w x _ Hl Hweights) in E.
      pose proof (Rmult_lt_0_compat (- c) (- nth k w 0) ltac:(lra) ltac:(lra)).
      apply Rlt_le, Rmult_lt_reg_l with (1 := Hscale). lra.
Qed.

Lemma boundary_hulls x : boundary A x <-> exists s, In s ss /\ in_hull scale s x.
Proof.
  rewrite <- (state_B_closed A x kept_closed). split.
  - intros HB. assert (A x) as Hx by (apply (in_closed A x kept_closed); right; exact HB). destruct HB as [H _].
    assert (exists s, In s ss /\ zvalue (form s) x = 0) as (s & Hs & H0).
    { apply NNPP. intros N. apply H, strict_interior. intros s Hs. specialize (Hx s Hs). fold (form s) in Hx.
      destruct Hx as [Hx|Hx]; [assumption|]. exfalso. eauto. }
    exact (walk_covers longest_walk s None x Hs (Hwalk s Hs) Hx H0 Logic.I).
  - intros (s & Hs & H). split.
    + intros N. pose proof (interior_strict x s N Hs). pose proof (hull_on s x Hs H). lra.
    + intros N. apply interior_in in N. apply N. intros u Hu. exact (hull_behind s u x Hs Hu H).
Qed.

Lemma parted_apart s u (x : point (S d)) : In s ss -> In u ss -> parted scale s u = true ->
  ~ (in_relative_interior scale s x /\ in_relative_interior scale u x).
Proof.
  intros Hs Hu H [Ks Ku]. unfold parted in H. apply orb_prop in H. destruct H as [H|H]; [apply orb_prop in H; destruct H as [H|H]|].
  - pose proof (Hpairs s u Hs Hu) as P. apply andb_prop in P.
    pose proof (proj2 (inner_form s (form u) x Hs Ks (proj1 P)) H).
    pose proof (hull_on u x Hu (inner_hull u x Ku)). lra.
  - apply existsb_exists in H. destruct H as (h & Hh & H). pose proof (proj1 (inner_form s h x Hs Ks H)).
    apply (facet_inner _ _ _ (Hfacets u Hu)) in Ku. pose proof (proj2 Ku h Hh). lra.
  - apply existsb_exists in H. destruct H as (h & Hh & H). pose proof (proj1 (inner_form u h x Hu Ku H)).
    apply (facet_inner _ _ _ (Hfacets s Hs)) in Ks. pose proof (proj2 Ks h Hh). lra.
Qed.
Lemma pairs_apart l : (forall s, In s l -> In s ss) -> all_apart scale l = true ->
  ForallOrdPairs (fun s u => forall x : point (S d), ~ (in_relative_interior scale s x /\ in_relative_interior scale u x)) l.
Proof.
  induction l as [|s l IH]; intros Hin H; constructor; simpl in H; apply andb_prop in H; destruct H as [H1 H2].
  - apply Forall_forall. intros u Hu x. rewrite forallb_forall in H1.
    apply parted_apart; [apply Hin; left; reflexivity|apply Hin; right; exact Hu|apply H1, Hu].
  - apply IH; [|exact H2]. intros u Hu. apply Hin. right. exact Hu.
Qed.

Lemma sum_bounds l (x : point (S d)) : (forall s, In s l -> zvalue (form s) x <= 0) ->
  fold_right Rplus 0 (map (fun s => zvalue (outward scale s) x) l) <= 0 /\
  forall s, In s l -> fold_right Rplus 0 (map (fun s => zvalue (outward scale s) x) l) <= zvalue (form s) x.
Proof.
  induction l as [|u l IH]; intros H; simpl; [split; [lra|intros s []]|].
  destruct IH as [I1 I2]; [intros s Hs; apply H; right; exact Hs|].
  pose proof (H u (or_introl eq_refl)) as Hu. unfold form in *. split; [lra|].
  intros s [<-|Hs]; [lra|]. specialize (I2 s Hs). lra.
Qed.
Lemma is_bounded : bounded A.
Proof.
  unfold bounded_ok in Hbounded. apply andb_prop in Hbounded. destruct Hbounded as [Hsum Hspan].
  apply existsb_exists in Hspan. destruct Hspan as (u & Hu & Hspan).
  apply existsb_exists in Hspan. destruct Hspan as (v & Hv & Hspan). rewrite forallb_forall in Hspan.
  set (s := hd [] ss) in Hspan. assert (In s ss) as Hs by (unfold s; destruct ss; [destruct Hu|left; reflexivity]).
  set (K := Rabs (IZR (hd 0%Z (form_sum scale ss)))). pose proof (Rabs_pos (IZR (hd 0%Z (form_sum scale ss)))) as HK. fold K in HK.
  assert (forall x r, A x -> In r ss -> Rabs (zvalue (form r) x) <= K) as Hforms.
  { intros x r Hx Hr. destruct (sum_bounds ss x Hx) as [_ H2]. specialize (H2 r Hr). rewrite <- zvalue_form_sum in H2.
    assert (zvalue (form_sum scale ss) x = IZR (hd 0%Z (form_sum scale ss))) as E.
    { unfold zvalue. replace (dot (tl (form_sum scale ss)) x) with (zvalue (0%Z :: tl (form_sum scale ss)) x) by (unfold zvalue; simpl; ring).
      rewrite zvalue_zero by exact Hsum. ring. }
    rewrite E in H2. specialize (Hx r Hr). fold (form r) in Hx. rewrite Rabs_left1 by exact Hx.
    pose proof (Rle_abs (- IZR (hd 0%Z (form_sum scale ss)))) as Ha. rewrite Rabs_Ropp in Ha. fold K in Ha. lra. }
  destruct (one_bound (fun (i : Fin.t (S d)) b => forall x, A x -> Rabs (x i) <= b)) as (b & Hb).
  - intros i a b H Hab x Hx. specialize (H x Hx). lra.
  - intros i. specialize (Hspan (nat_of i)). pose proof (nat_of_bound i).
    specialize (Hspan ltac:(apply in_seq; lia)). unfold spans_axis in Hspan. apply andb_prop in Hspan. destruct Hspan as [Hk Hid].
    set (g := axis_of scale (S d) s u v (nat_of i)) in *. set (k := nth (S (nat_of i)) g 0%Z) in *.
    set (c := weights_for (S d) s u v (nat_of i)).
    set (B := K * fold_right Rplus 0 (map (fun c => Rabs (IZR c)) c)).
    exists (B + Rabs (IZR (hd 0%Z g))). intros x Hx.
    apply zvalue_minus with (x := x) in Hid. unfold g at 1, axis_of in Hid. rewrite zvalue_pull in Hid. fold c in Hid.
    pose proof (rdot_bounded c (map (fun f => zvalue f x) (map (outward scale) [s; u; v])) K HK) as HB.
    assert (Rabs (rdot c (map (fun f => zvalue f x) (map (outward scale) [s; u; v]))) <= B) as HB'.
    { apply HB. intros y [<-|[<-|[<-|[]]]]; apply Hforms; assumption. }
    apply (eq_ind _ (fun r => Rabs r <= B) HB') in Hid. unfold zvalue in Hid. simpl hd in Hid. simpl tl in Hid.
    rewrite dot_unit in Hid.
    assert (1 <= Rabs (IZR k)) as H1.
    { rewrite <- abs_IZR. apply IZR_le. destruct (Z.eqb_spec k 0); [discriminate|lia]. }
    assert (Rabs (IZR k * x i) <= B + Rabs (IZR (hd 0%Z g))) as H2.
    { replace (IZR k * x i) with (IZR (hd 0%Z g) + IZR k * x i + - IZR (hd 0%Z g)) by ring.
      eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
    rewrite Rabs_mult in H2. pose proof (Rmult_le_compat_r (Rabs (x i)) _ _ (Rabs_pos _) H1). lra.
  - exists b. intros x Hx i. apply Hb, Hx.
Qed.

Lemma one_side s (x : point (S d)) : In s ss -> in_relative_interior scale s x ->
  exists e, e > 0 /\ forall y, near x e y ->
    (zvalue (form s) y < 0 -> interior A y) /\ (0 < zvalue (form s) y -> interior (complement A) y).
Proof.
  intros Hs Hx.
  set (others := filter (fun u => existsb (Z.ltb 0) (behind scale s u)) ss).
  destruct (negative_near (map form others) x) as (e & He & K).
  { intros f Hf. apply in_map_iff in Hf. destruct Hf as (u & <- & Hu). apply filter_In in Hu. destruct Hu as [Hu Hb].
    pose proof (Hpairs s u Hs Hu) as P. apply andb_prop in P. exact (proj2 (inner_form s (form u) x Hs Hx (proj1 P)) Hb). }
  exists e. split; [assumption|]. intros y Hy. split; [|apply outside_open, Hs].
  intros Hneg. apply strict_interior. intros u Hu. destruct (existsb (Z.ltb 0) (behind scale s u)) eqn:Eb.
  - apply (K y Hy), in_map, filter_In. split; assumption.
  - pose proof (Hpairs s u Hs Hu) as P. apply andb_prop in P. destruct P as [_ P]. rewrite Eb, orb_false_l in P.
    apply zvalue_minus with (x := y) in P. rewrite !zvalue_zscale in P.
    pose proof (IZR_lt _ _ (Hdepth s Hs)) as D1. pose proof (IZR_lt _ _ (Hdepth u Hu)) as D2. fold (form s) (form u) in P.
    apply Rmult_lt_reg_l with (1 := D1). rewrite P.
    pose proof (Rmult_lt_0_compat _ (- zvalue (form s) y) D2 ltac:(lra)). lra.
Qed.

Theorem is_legal : legal_solid scale ss A.
Proof.
  split.
  - exact kept_regular.
  - apply pairs_apart; [auto|exact Happart].
  - exact boundary_hulls.
  - exact is_bounded.
  - intros before s after x E Hx _. apply one_side; [|exact Hx]. rewrite E. apply in_or_app. right. left. reflexivity.
Qed.
End Convex.

Theorem convex_legal d scale ss : convex_ok scale (S d) ss = true -> legal_solid (d := S d) scale ss (kept scale ss).
Proof.
  intros H. unfold convex_ok in H. repeat (apply andb_prop in H; let X := fresh "E" in destruct H as [H X]).
  rewrite forallb_forall in H, E, E2, E3. apply is_legal; try assumption.
  - apply Nat.eqb_eq. assumption.
  - apply Z.ltb_lt. assumption.
  - intros s Hs. apply Z.ltb_lt, E3, Hs.
  - intros s u Hs Hu. specialize (E2 s Hs). rewrite forallb_forall in E2. apply E2, Hu.
Qed.

(* ------------------------------------------------------------------ no hypothesis is left *)
Section Checked.
Context (f : folds) (scale : Z) (ss : list simplex) (ps : list piece) (signs : list time) (V : list Z) (r : row).
Let t0 := instant (first_time ps).
Let t1 := instant (last_time ps).

Theorem convex_checked_plane : check sweeping f 2 scale ss ps signs V r = true -> convex_ok scale 2 ss = true ->
  (exists M : motion 2 t0 t1, given_by ps M) /\
  forall M : motion 2 t0 t1, given_by ps M -> says_sweep M (kept scale ss) (point_of V) f r.
Proof. intros H K. apply (sweep_checked_plane f scale ss ps signs V r); [exact H|apply convex_legal, K]. Qed.
Theorem convex_checked_space : check sweeping f 3 scale ss ps signs V r = true -> convex_ok scale 3 ss = true ->
  (exists M : motion 3 t0 t1, given_by ps M) /\
  forall M : motion 3 t0 t1, given_by ps M -> says_sweep M (kept scale ss) (point_of V) f r.
Proof. intros H K. apply (sweep_checked_space f scale ss ps signs V r); [exact H|apply convex_legal, K]. Qed.
Theorem convex_unsweep_plane : check unsweeping f 2 scale ss ps signs V r = true -> convex_ok scale 2 ss = true ->
  (exists M : motion 2 t0 t1, given_by ps M) /\
  forall M : motion 2 t0 t1, given_by ps M -> says_unsweep M (kept scale ss) (point_of V) r.
Proof. intros H K. apply (unsweep_checked_plane f scale ss ps signs V r); [exact H|apply convex_legal, K]. Qed.
Theorem convex_unsweep_space : check unsweeping f 3 scale ss ps signs V r = true -> convex_ok scale 3 ss = true ->
  (exists M : motion 3 t0 t1, given_by ps M) /\
  forall M : motion 3 t0 t1, given_by ps M -> says_unsweep M (kept scale ss) (point_of V) r.
Proof. intros H K. apply (unsweep_checked_space f scale ss ps signs V r); [exact H|apply convex_legal, K]. Qed.
End Checked.
