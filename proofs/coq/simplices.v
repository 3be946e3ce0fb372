(* Solids given by oriented simplices: sides in the plane, triangles in space.
   SPDX-License-Identifier: GPL-3.0-or-later

   [in_hull], [in_relative_interior]   the points of a simplex, by the weights of its vertices
   [outward]          the form that is positive on a simplex's outer side
   [legal_solid]      V0 to V3 for the set A that a list of simplices bounds
   [facet_of]         the forms of a simplex; that they are right is tested, by identities between integers
   [facet_on], [facet_inner]   then the forms describe the simplex and its relative interior
   [legal_facets]     a legal solid's facets are legal *)
Require Import Reals Lra Lia List ZArith Bool.
Require Fin.
Require Import Graze.words Graze.space Graze.finite Graze.affine Graze.polynomials Graze.bernstein Graze.facets
  Graze.sample Graze.interval Graze.interval_sound Graze.row.
Import ListNotations.
Open Scope R_scope.

(* A simplex is its d vertices; a vertex is its coordinates times `scale`. *)
Definition simplex := list (list Z).
Definition coordinate (i : nat) (v : list Z) : Z := nth i v 0%Z.
Definition total_weight (w : list R) : R := fold_right Rplus 0 w.

Definition weighted {d} (scale : Z) (s : simplex) (w : list R) (x : point d) : Prop :=
  length w = length s /\ total_weight w = 1 /\
  forall i, IZR scale * x i = rdot (map (coordinate (nat_of i)) s) w.
Definition in_hull {d} (scale : Z) (s : simplex) (x : point d) : Prop :=
  exists w, weighted scale s w x /\ forall u, In u w -> 0 <= u.
Definition in_relative_interior {d} (scale : Z) (s : simplex) (x : point d) : Prop :=
  exists w, weighted scale s w x /\ forall u, In u w -> 0 < u.

(* ------------------------------------------------------------------ forms *)
(* The form n.x + k, for points times `scale`. *)
Definition form_of (scale : Z) (n : list Z) (k : Z) : list Z := k :: map (Z.mul scale) n.
Definition normal_of (s : simplex) : list Z :=
  match s with
  | [p; q] =>
      let u i := (coordinate i q - coordinate i p)%Z in [u 1%nat; (- u 0%nat)%Z]
  | [p; q; r] =>
      let u i := (coordinate i q - coordinate i p)%Z in
      let v i := (coordinate i r - coordinate i p)%Z in
      let minor i j := (u i * v j - u j * v i)%Z in [minor 1 2; minor 2 0; minor 0 1]%nat
  | _ => []
  end.
(* Positive where the normal points: left of it a side's inner part, behind it a triangle's. *)
Definition outward (scale : Z) (s : simplex) : list Z :=
  form_of scale (normal_of s) (- zdot (normal_of s) (hd [] s)).

Record legal_solid {d} (scale : Z) (ss : list simplex) (A : set d) : Prop := {
  solid_regular : regular_closed A;
  solid_apart : ForallOrdPairs (fun s u => forall x : point d,
    ~ (in_relative_interior scale s x /\ in_relative_interior scale u x)) ss;
  solid_boundary : forall x, boundary A x <-> exists s, In s ss /\ in_hull scale s x;
  solid_bounded : bounded A;
  solid_sides : forall before s after x, ss = before ++ s :: after -> in_relative_interior scale s x ->
    (forall u, In u (before ++ after) -> ~ in_hull scale u x) ->
    exists e, e > 0 /\ forall y, near x e y ->
      (zvalue (outward scale s) y < 0 -> interior A y) /\
      (0 < zvalue (outward scale s) y -> interior (complement A) y)
}.

(* ------------------------------------------------------------------ a simplex's facet *)
Fixpoint first_axis (n : list Z) : nat :=
  match n with [] => 0%nat | c :: q => if Z.eqb c 0 then S (first_axis q) else 0%nat end.
Definition unit (d i : nat) (c : Z) : list Z := map (fun j => if Nat.eqb j i then c else 0%Z) (seq 0 d).

(* Side k is 0 on the other vertices and positive at vertex k; it leaves out the first axis of the normal. *)
Definition sides_of (scale : Z) (s : simplex) : list (list Z) :=
  let a := first_axis (normal_of s) in
  match s with
  | [p; q] =>
      let b := (1 - a)%nat in
      let e := Z.sgn (coordinate b q - coordinate b p) in
      [form_of scale (unit 2 b (- e)) (e * coordinate b q); form_of scale (unit 2 b e) (- (e * coordinate b p))]
  | [p; q; r] =>
      let b := ((a + 1) mod 3)%nat in
      let c := ((a + 2) mod 3)%nat in
      let e := Z.sgn (coordinate a (normal_of s)) in
      let edge u v :=
        let m := (e * (coordinate c u - coordinate c v))%Z in
        let n := (e * (coordinate b v - coordinate b u))%Z in
        form_of scale (zadd (unit 3 b m) (unit 3 c n)) (- (m * coordinate b u + n * coordinate c u)) in
      [edge q r; edge r p; edge p q]
  | _ => []
  end.
Definition bounds_of (scale : Z) (d : nat) (s : simplex) : list (list Z) :=
  flat_map (fun i =>
    let c := map (coordinate i) s in
    let high := fold_right Z.max (hd 0%Z c) c in
    let low := fold_right Z.min (hd 0%Z c) c in
    [form_of scale (unit d i (-1)) high; form_of scale (unit d i 1) (- low)]) (seq 0 d).

Definition zero_list (p : list Z) : bool := forallb (Z.eqb 0) p.
Definition at_vertices (scale : Z) (s : simplex) (f : list Z) : list Z := map (fun v => zdot f (scale :: v)) s.
(* d times `scale` x_i is the sum of the sides' forms by vertices, up to the plane's. *)
Definition identity_ok (scale : Z) (s : simplex) (f : facet) (de : Z) (a i : nat) : bool :=
  let n := coordinate a (normal_of s) in
  zero_list (minus (zscale de (0%Z :: repeat 0%Z i ++ [scale]))
    (zadd (pull (map (coordinate i) s) (sides f)) (if Nat.eqb i a then zscale (Z.sgn n) (plane f) else []))).
Definition facet_ok (scale : Z) (d : nat) (s : simplex) (f : facet) : bool :=
  let a := first_axis (normal_of s) in
  let de := Z.abs (coordinate a (normal_of s)) in
  Z.ltb 0 scale && Z.ltb 0 de && Nat.eqb (length (sides f)) (length s)
  && forallb (fun v => Nat.eqb (length v) d) s
  && zero_list (minus [de] (pull (map (fun _ => 1%Z) s) (sides f)))
  && forallb (identity_ok scale s f de a) (seq 0 d)
  && zero_list (at_vertices scale s (plane f))
  && forallb (fun g => forallb (Z.leb 0) (at_vertices scale s g) && existsb (Z.ltb 0) (at_vertices scale s g)) (sides f)
  && forallb (fun g => forallb (Z.leb 0) (at_vertices scale s g)) (bounds f).
Definition facet_of (scale : Z) (d : nat) (s : simplex) : option facet :=
  let f := {| plane := outward scale s; sides := sides_of scale s; bounds := bounds_of scale d s |} in
  if facet_ok scale d s f then Some f else None.
Fixpoint facets_of (scale : Z) (d : nat) (ss : list simplex) : option (list facet) :=
  match ss with
  | [] => Some []
  | s :: rest =>
      match facet_of scale d s, facets_of scale d rest with Some f, Some F => Some (f :: F) | _, _ => None end
  end.

(* ------------------------------------------------------------------ values *)
Lemma dot_none {d} (x : point d) : dot [] x = 0.
Proof. destruct d; reflexivity. Qed.
Lemma dot_zadd {d} n m (x : point d) : dot (zadd n m) x = dot n x + dot m x.
Proof.
  revert n m x. induction d as [|d IH]; intros [|c n] [|e m] x; simpl; try ring.
  rewrite IH, plus_IZR. ring.
Qed.
Lemma dot_zscale {d} k n (x : point d) : dot (zscale k n) x = IZR k * dot n x.
Proof.
  revert n x. induction d as [|d IH]; intros [|c n] x; simpl; try ring.
  change (map (Z.mul k) n) with (zscale k n). rewrite IH, mult_IZR. ring.
Qed.
Lemma zvalue_none {d} (x : point d) : zvalue [] x = 0.
Proof. unfold zvalue. simpl. rewrite dot_none. ring. Qed.
Lemma zvalue_zadd {d} f g (x : point d) : zvalue (zadd f g) x = zvalue f x + zvalue g x.
Proof.
  destruct f as [|c f], g as [|e g]; simpl zadd; rewrite ?zvalue_none; try ring.
  unfold zvalue. simpl. rewrite dot_zadd, plus_IZR. ring.
Qed.
Lemma zvalue_zscale {d} k f (x : point d) : zvalue (zscale k f) x = IZR k * zvalue f x.
Proof.
  destruct f as [|c f]; [simpl; rewrite zvalue_none; ring|].
  unfold zvalue. simpl. change (map (Z.mul k) f) with (zscale k f). rewrite dot_zscale, mult_IZR. ring.
Qed.
Lemma zvalue_pull {d} f V (x : point d) : zvalue (pull f V) x = rdot f (map (fun g => zvalue g x) V).
Proof.
  revert V. induction f as [|c f IH]; intros [|g V]; try (apply zvalue_none).
  simpl. destruct (Z.eqb_spec c 0) as [->|]; [rewrite IH; ring|].
  rewrite zvalue_zadd, zvalue_zscale, IH. reflexivity.
Qed.
Lemma zvalue_zero {d} p (x : point d) : zero_list p = true -> zvalue p x = 0.
Proof.
  intros H. assert (p = zscale 0 p) as ->.
  { induction p as [|c p IH]; [reflexivity|]. unfold zero_list in H. simpl in H.
    apply andb_prop in H. destruct H as [Hc Hp].
    assert (c = 0%Z) as -> by (destruct c; congruence). simpl. f_equal. apply IH, Hp. }
  rewrite zvalue_zscale. ring.
Qed.
Lemma zvalue_minus {d} f g (x : point d) : zero_list (minus f g) = true -> zvalue f x = zvalue g x.
Proof.
  intros H. apply zvalue_zero with (x := x) in H. unfold minus in H. rewrite zvalue_zadd in H.
  replace (map Z.opp g) with (zscale (-1) g) in H by (apply map_ext; intros; lia).
  rewrite zvalue_zscale in H. lra.
Qed.
Lemma dot_unit {d} (i : Fin.t d) c (x : point d) : dot (repeat 0%Z (nat_of i) ++ [c]) x = IZR c * x i.
Proof.
  induction i as [n|n i IH]; simpl.
  - rewrite dot_none. ring.
  - rewrite (IH (fun j => x (Fin.FS j))). ring.
Qed.

Lemma rdot_ones (s : simplex) V : length V = length s -> rdot (map (fun _ => 1%Z) s) V = total_weight V.
Proof.
  revert V. induction s as [|v s IH]; intros [|u V] H; try discriminate; [reflexivity|].
  simpl. rewrite IH by (simpl in H; lia). ring.
Qed.
Lemma rdot_over n V (D : R) : rdot n (map (fun u => u / D) V) = rdot n V / D.
Proof.
  rewrite (map_ext _ (Rmult (/ D))) by (intros; unfold Rdiv; ring). rewrite rdot_scaled. unfold Rdiv. ring.
Qed.

(* A form at a weighted mean of the vertices. *)
Lemma dot_vertex {d} n v : length v = d -> dot n (fun i : Fin.t d => IZR (coordinate (nat_of i) v)) = IZR (zdot n v).
Proof.
  revert n v. induction d as [|d IH]; intros n v Hv.
  - destruct v; [|discriminate]. destruct n; reflexivity.
  - destruct v as [|e v]; [discriminate|]. destruct n as [|c n]; [reflexivity|]. simpl in Hv.
    simpl zdot. rewrite plus_IZR, mult_IZR. simpl. f_equal. rewrite <- (IH n v) by lia. reflexivity.
Qed.
Lemma dot_times {d} n k (x : point d) : dot n (fun i => k * x i) = k * dot n x.
Proof.
  revert n x. induction d as [|d IH]; intros [|c n] x; simpl; try ring.
  rewrite (IH n (fun i => x (Fin.FS i))). ring.
Qed.

Lemma weighted_value {d} scale s w (x : point d) f : (forall v, In v s -> length v = d) ->
  weighted scale s w x -> IZR scale * zvalue f x = rdot (at_vertices scale s f) w.
Proof.
  intros Hs (Hlen & Hsum & Hx). unfold zvalue. rewrite Rmult_plus_distr_l, <- dot_times.
  rewrite (dot_same _ _ _ Hx). rewrite <- (Rmult_1_r (IZR scale * _)), <- Hsum. clear Hsum Hx.
  unfold at_vertices. revert w Hlen. induction s as [|v s IH]; intros [|u w] Hlen; try discriminate.
  - simpl. rewrite (dot_same _ _ (fun i => 0 * x i)) by (intros; ring). rewrite dot_times. ring.
  - simpl in Hlen. specialize (IH (fun v Hv => Hs v (or_intror Hv)) w ltac:(lia)).
    simpl map. simpl rdot. rewrite <- IH. simpl total_weight.
    rewrite (dot_same _ _ (fun i : Fin.t d => u * IZR (coordinate (nat_of i) v) + rdot (map (coordinate (nat_of i)) s) w))
      by (intros; ring).
    rewrite (dot_plus (tl f) (fun i : Fin.t d => u * IZR (coordinate (nat_of i) v))), (dot_times (tl f) u).
    rewrite dot_vertex by (apply Hs; left; reflexivity).
    destruct f as [|c f]; simpl; rewrite ?plus_IZR, ?mult_IZR; ring.
Qed.

Lemma rdot_not_negative n w : forallb (Z.leb 0) n = true -> (forall u, In u w -> 0 <= u) -> 0 <= rdot n w.
Proof.
  revert w. induction n as [|c n IH]; intros [|u w] H Hw; try (simpl; lra).
  simpl in H. apply andb_prop in H. destruct H as [Hc Hn]. apply Z.leb_le, IZR_le in Hc.
  simpl. pose proof (IH w Hn (fun v Hv => Hw v (or_intror Hv))).
  pose proof (Rmult_le_pos _ _ Hc (Hw u (or_introl eq_refl))). lra.
Qed.
Lemma rdot_positive n w : length w = length n -> forallb (Z.leb 0) n = true -> existsb (Z.ltb 0) n = true ->
  (forall u, In u w -> 0 < u) -> 0 < rdot n w.
Proof.
  revert w. induction n as [|c n IH]; intros [|u w] Hl H E Hw; try discriminate.
  simpl in H. apply andb_prop in H. destruct H as [Hc Hn]. simpl.
  pose proof (Hw u (or_introl eq_refl)) as Hu.
  assert (forall v, In v w -> 0 < v) as Hw' by (intros v Hv; apply Hw; right; exact Hv).
  simpl in E. apply orb_prop in E. destruct E as [E|E].
  - apply Z.ltb_lt, IZR_lt in E. pose proof (Rmult_lt_0_compat _ _ E Hu).
    pose proof (rdot_not_negative n w Hn (fun v Hv => Rlt_le _ _ (Hw' v Hv))). lra.
  - apply Z.leb_le, IZR_le in Hc. pose proof (Rmult_le_pos _ _ Hc (Rlt_le _ _ Hu)).
    pose proof (IH w ltac:(simpl in Hl; lia) Hn E Hw'). lra.
Qed.
Lemma rdot_zero n w : zero_list n = true -> rdot n w = 0.
Proof.
  revert w. induction n as [|c n IH]; intros [|u w] H; try reflexivity.
  unfold zero_list in H. simpl in H. apply andb_prop in H. destruct H as [Hc Hn].
  assert (c = 0%Z) as -> by (destruct c; congruence). simpl. rewrite (IH w Hn). ring.
Qed.

(* ------------------------------------------------------------------ forms and hull agree *)
Section Facet.
Context {d : nat} (scale : Z) (s : simplex) (f : facet).
Hypothesis Hok : facet_ok scale d s f = true.

Let D := IZR (Z.abs (coordinate (first_axis (normal_of s)) (normal_of s))).
Lemma facet_facts :
  0 < IZR scale /\ 0 < D /\ length (sides f) = length s /\ (forall v, In v s -> length v = d) /\
  (forall x : point d, zvalue (plane f) x = 0 ->
    weighted scale s (map (fun g => zvalue g x / D) (sides f)) x) /\
  zero_list (at_vertices scale s (plane f)) = true /\
  (forall g, In g (sides f) -> forallb (Z.leb 0) (at_vertices scale s g) = true
    /\ existsb (Z.ltb 0) (at_vertices scale s g) = true) /\
  (forall g, In g (bounds f) -> forallb (Z.leb 0) (at_vertices scale s g) = true).
Proof.
  pose proof Hok as H. unfold facet_ok in H.
  apply andb_prop in H. destruct H as [H Hbounds]. apply andb_prop in H. destruct H as [H Hsides].
  apply andb_prop in H. destruct H as [H Hplane]. apply andb_prop in H. destruct H as [H Hid].
  apply andb_prop in H. destruct H as [H Hsum]. apply andb_prop in H. destruct H as [H Hlen].
  apply andb_prop in H. destruct H as [H Hnum]. apply andb_prop in H. destruct H as [Hscale Hde].
  apply Z.ltb_lt, IZR_lt in Hscale. apply Z.ltb_lt, IZR_lt in Hde. fold D in Hde. apply Nat.eqb_eq in Hnum.
  rewrite forallb_forall in Hlen, Hsides, Hbounds, Hid.
  repeat split; try assumption.
  - intros v Hv. apply Nat.eqb_eq, Hlen, Hv.
  - rewrite !map_length. assumption.
  - rewrite <- (rdot_ones s) by (rewrite map_length; assumption).
    rewrite <- (map_map (fun g => zvalue g x) (fun u => u / D)), rdot_over, <- zvalue_pull.
    rewrite <- (zvalue_minus _ _ x Hsum). unfold zvalue. simpl. rewrite dot_none. fold D. field. lra.
  - intros i. specialize (Hid (nat_of i)). rewrite in_seq in Hid. pose proof (nat_of_bound i).
    specialize (Hid ltac:(lia)). unfold identity_ok in Hid. apply zvalue_minus with (x := x) in Hid.
    rewrite zvalue_zscale, zvalue_zadd, zvalue_pull in Hid. fold D in Hid.
    assert (zvalue (if Nat.eqb (nat_of i) (first_axis (normal_of s)) then
      zscale (Z.sgn (coordinate (first_axis (normal_of s)) (normal_of s))) (plane f) else []) x = 0) as Hz.
    { destruct (Nat.eqb _ _); [rewrite zvalue_zscale, H; ring|apply zvalue_none]. }
    rewrite Hz in Hid. unfold zvalue at 1 in Hid. simpl hd in Hid. simpl tl in Hid. rewrite dot_unit in Hid.
    rewrite <- (map_map (fun g => zvalue g x) (fun u => u / D)), rdot_over.
    apply Rmult_eq_reg_l with D; [|lra].
    replace (D * (rdot (map (coordinate (nat_of i)) s) (map (fun g => zvalue g x) (sides f)) / D))
      with (rdot (map (coordinate (nat_of i)) s) (map (fun g => zvalue g x) (sides f))) by (field; lra). lra.
  - specialize (Hsides g H). apply andb_prop in Hsides. apply Hsides.
  - specialize (Hsides g H). apply andb_prop in Hsides. apply Hsides.
Qed.

Theorem facet_on (x : point d) : on f x <-> in_hull scale s x.
Proof.
  destruct facet_facts as (Hs & HD & Hn & Hl & Hw & Hp & Hg & _). split.
  - intros H. exists (map (fun g => zvalue g x / D) (sides f)). split; [apply Hw, H|].
    intros u Hu. apply in_map_iff in Hu. destruct Hu as (g & <- & Hin).
    destruct H as [_ H]. specialize (H g Hin). apply Rmult_le_reg_r with D; [assumption|].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
  - intros (w & W & Hpos). split.
    + pose proof (weighted_value scale s w x (plane f) Hl W) as E. rewrite (rdot_zero _ w Hp) in E.
      apply Rmult_integral in E. destruct E; [lra|assumption].
    + intros g Hin. pose proof (weighted_value scale s w x g Hl W) as E.
      pose proof (rdot_not_negative _ w (proj1 (Hg g Hin)) Hpos). apply Rmult_le_reg_l with (1 := Hs). lra.
Qed.

Theorem facet_inner (x : point d) : inner f x <-> in_relative_interior scale s x.
Proof.
  destruct facet_facts as (Hs & HD & Hn & Hl & Hw & Hp & Hg & _). split.
  - intros H. exists (map (fun g => zvalue g x / D) (sides f)). split; [apply Hw, H|].
    intros u Hu. apply in_map_iff in Hu. destruct Hu as (g & <- & Hin).
    destruct H as [_ H]. specialize (H g Hin). apply Rdiv_lt_0_compat; assumption.
  - intros (w & W & Hpos). split.
    + pose proof (weighted_value scale s w x (plane f) Hl W) as E. rewrite (rdot_zero _ w Hp) in E.
      apply Rmult_integral in E. destruct E; [lra|assumption].
    + intros g Hin. pose proof (weighted_value scale s w x g Hl W) as E.
      assert (0 < rdot (at_vertices scale s g) w) as K.
      { apply rdot_positive; try apply Hg; try assumption. unfold at_vertices. rewrite map_length. apply W. }
      apply Rmult_lt_reg_l with (1 := Hs). lra.
Qed.

Theorem facet_bounds g (x : point d) : In g (bounds f) -> on f x -> 0 <= zvalue g x.
Proof.
  intros Hin Ho. apply facet_on in Ho. destruct Ho as (w & W & Hpos).
  destruct facet_facts as (Hs & _ & _ & Hl & _ & _ & _ & Hb).
  pose proof (weighted_value scale s w x g Hl W) as E.
  pose proof (rdot_not_negative _ w (Hb g Hin) Hpos). apply Rmult_le_reg_l with (1 := Hs). lra.
Qed.
End Facet.

(* ------------------------------------------------------------------ the whole solid *)
Definition describes (scale : Z) (d : nat) (s : simplex) (f : facet) : Prop :=
  facet_ok scale d s f = true /\ plane f = outward scale s.
Lemma facets_of_describe scale d ss F : facets_of scale d ss = Some F -> Forall2 (describes scale d) ss F.
Proof.
  revert F. induction ss as [|s ss IH]; intros F H; simpl in H.
  - inversion H. constructor.
  - unfold facet_of in H. destruct (facet_ok scale d s _) eqn:E; [|discriminate].
    destruct (facets_of scale d ss) as [G|]; [|discriminate]. inversion H; subst.
    constructor; [split; [assumption|reflexivity]|apply IH; reflexivity].
Qed.

Lemma described {scale d ss F} : Forall2 (describes scale d) ss F -> forall f, In f F ->
  exists s, In s ss /\ describes scale d s f.
Proof.
  induction 1 as [|s f ss F H Hr IH]; intros g []; [subst; exists s; split; [left; reflexivity|assumption]|].
  destruct (IH g H0) as (u & Hu & K). exists u. split; [right; assumption|assumption].
Qed.
Lemma describing {scale d ss F} : Forall2 (describes scale d) ss F -> forall s, In s ss ->
  exists f, In f F /\ describes scale d s f.
Proof.
  induction 1 as [|s f ss F H Hr IH]; intros g []; [subst; exists f; split; [left; reflexivity|assumption]|].
  destruct (IH g H0) as (u & Hu & K). exists u. split; [right; assumption|assumption].
Qed.

Theorem legal_facets {d} scale ss F (A : set d) : facets_of scale d ss = Some F -> legal_solid scale ss A ->
  legal F A /\ forall f g (x : point d), In f F -> In g (bounds f) -> on f x -> 0 <= zvalue g x.
Proof.
  intros HF HA. apply facets_of_describe in HF. split.
  - split.
    + apply (solid_regular _ _ _ HA).
    + pose proof (solid_apart _ _ _ HA) as Ha. clear HA. induction HF as [|s f ss F Hs HF IH]; [constructor|].
      inversion Ha as [|u l H1 H2]; subst. constructor; [|apply IH; assumption].
      rewrite Forall_forall in H1 |- *. intros g Hg x [K1 K2].
      destruct (described HF g Hg) as (u & Hu & Hgu).
      apply (H1 u Hu x). split; [apply (facet_inner scale s f (proj1 Hs)), K1|apply (facet_inner scale u g (proj1 Hgu)), K2].
    + intros x. rewrite (solid_boundary _ _ _ HA). split.
      * intros (s & Hs & Hx). destruct (describing HF s Hs) as (f & Hf & Hd). exists f.
        split; [assumption|]. apply (facet_on scale s f (proj1 Hd)), Hx.
      * intros (f & Hf & Hx). destruct (described HF f Hf) as (s & Hs & Hd). exists s.
        split; [assumption|]. apply (facet_on scale s f (proj1 Hd)), Hx.
    + apply (solid_bounded _ _ _ HA).
    + intros before f after x -> Hx Hno.
      apply Forall2_app_inv_r in HF. destruct HF as (ss1 & ss2 & H1 & H2 & ->).
      inversion H2 as [|s f' ss3 F' Hs H3]; subst.
      rewrite (proj2 Hs). apply (solid_sides _ _ _ HA ss1 s ss3 x eq_refl).
      * apply (facet_inner scale s f (proj1 Hs)), Hx.
      * intros u Hu Hux. apply in_app_or in Hu. destruct Hu as [Hu|Hu];
          [destruct (describing H1 u Hu) as (g & Hg & Hd)|destruct (describing H3 u Hu) as (g & Hg & Hd)];
          (apply (Hno g); [apply in_or_app; auto|apply (facet_on scale u g (proj1 Hd)), Hux]).
  - intros f g x Hf Hg Ho. destruct (described HF f Hf) as (s & Hs & Hd).
    exact (facet_bounds scale s f (proj1 Hd) g x Hg Ho).
Qed.
