(* The theorem of the checker is not empty in space: a cube is a legal solid, and a certificate is accepted.
   SPDX-License-Identifier: GPL-3.0-or-later

   [cube_legal]      the cube [0, 2]^3 with twelve triangles, two to a face
   [cube_is_box]     what they bound is that cube
   [cube_accepted]   the certificate of the point (5, 3/2, 1) under the translation by (8t, t, 0): OBIBO
   [cube_swept]      so that point is in the open sweep, and its class is regular

   The certificate by hand: seen from the cube the point is (5 - 8t, 3/2 - t, 1). On [0, 1] its second coordinate runs
   from 3/2 to 1/2 and its third is 1, between 0 and 2. The first is 2 at t = 3/8, where 8t - 3 = 0, and 0 at t = 5/8,
   where 8t - 5 = 0: outside, inside from 3/8 to 5/8, outside. 1/4, 1/2 and 3/4 lie between. *)
Require Import Reals Lra List ZArith.
Require Fin.
Require Import Graze.words Graze.definitions Graze.space Graze.sweep Graze.box Graze.facets Graze.sample Graze.interval
  Graze.row Graze.simplices Graze.motions Graze.checker Graze.convex.
Import ListNotations.
Open Scope R_scope.

(* A square's corners, anticlockwise seen from outside; cut along the diagonal from the first. *)
Definition face (p q r s : list Z) : list simplex := [[p; q; r]; [p; r; s]].
Definition cube : list simplex := (
  face [0; 0; 0] [0; 2; 0] [2; 2; 0] [2; 0; 0] ++ face [0; 0; 2] [2; 0; 2] [2; 2; 2] [0; 2; 2] ++
  face [0; 0; 0] [2; 0; 0] [2; 0; 2] [0; 0; 2] ++ face [0; 2; 0] [0; 2; 2] [2; 2; 2] [2; 2; 0] ++
  face [0; 0; 0] [0; 0; 2] [0; 2; 2] [0; 2; 0] ++ face [2; 0; 0] [2; 2; 0] [2; 2; 2] [2; 0; 2])%Z.

Theorem cube_convex : convex_ok 1 3 cube = true.
Proof. vm_compute. reflexivity. Qed.
Theorem cube_legal : legal_solid (d := 3) 1 cube (kept 1 cube).
Proof. apply convex_legal, cube_convex. Qed.

Lemma all3 (P : Fin.t 3 -> Prop) : P Fin.F1 -> P (Fin.FS Fin.F1) -> P (Fin.FS (Fin.FS Fin.F1)) -> forall i, P i.
Proof.
  intros H0 H1 H2 i. apply (Fin.caseS' i P); [assumption|]. intros j. apply (Fin.caseS' j (fun j => P (Fin.FS j))); [assumption|].
  intros k. apply (Fin.caseS' k (fun k => P (Fin.FS (Fin.FS k)))); [assumption|].
  intros l. apply (Fin.case0 (fun l => P (Fin.FS (Fin.FS (Fin.FS l)))) l).
Qed.
Theorem cube_is_box : same (kept 1 cube) (box 3 2).
Proof.
  intros x. split.
  - intros H i. revert i. apply all3;
      [pose proof (H _ (nth_In cube [] (n := 8) ltac:(simpl; repeat constructor))) as K;
       pose proof (H _ (nth_In cube [] (n := 10) ltac:(simpl; repeat constructor))) as L
      |pose proof (H _ (nth_In cube [] (n := 4) ltac:(simpl; repeat constructor))) as K;
       pose proof (H _ (nth_In cube [] (n := 6) ltac:(simpl; repeat constructor))) as L
      |pose proof (H _ (nth_In cube [] (n := 0) ltac:(simpl; repeat constructor))) as K;
       pose proof (H _ (nth_In cube [] (n := 2) ltac:(simpl; repeat constructor))) as L];
      unfold zvalue in K, L; simpl in K, L; lra.
  - intros H s Hs. pose proof (H Fin.F1). pose proof (H (Fin.FS Fin.F1)). pose proof (H (Fin.FS (Fin.FS Fin.F1))).
    repeat (destruct Hs as [<-|Hs]; [unfold zvalue; simpl; lra|]). destruct Hs.
Qed.

(* ------------------------------------------------------------------ a certificate *)
Definition slant : piece :=
  {| begins := (0, 1); finishes := (1, 1);
     forward := [[[0; 8]; [1]; []; []]; [[0; 1]; []; [1]; []]; [[]; []; []; [1]]]; forward_weight := [1];
     backward := [[[0; -8]; [1]; []; []]; [[0; -1]; []; [1]; []]; [[]; []; []; [1]]]; backward_weight := [1] |}%Z.
(* 2, and twice the point. *)
Definition cube_point : list Z := [2; 10; 3; 2]%Z.
Definition cube_row : row :=
  {| word_of := [O; B; I; B; O]; pmc := in_; class_claimed := regular; definition := 5; position := 1;
     crosses := 2; tangent := 0; inner_count := 1;
     intervals := [(stays O, (1, 4), []); (meets (Some O) (Some I), (1, 2), [-3; 8]);
                   (meets (Some I) (Some O), (3, 4), [-5; 8]); (stays O, (1, 1), [])]%Z |}.

Theorem cube_accepted :
  check sweeping separate 3 1 cube [slant] [(0, 1); (1, 1)]%Z cube_point cube_row = true.
Proof. vm_compute. reflexivity. Qed.

Theorem cube_swept : exists M : motion 3 (instant (0, 1)%Z) (instant (1, 1)%Z),
  given_by [slant] M /\ open_sweep M (kept 1 cube) (point_of cube_point).
Proof.
  destruct (sweep_checked_space separate 1 cube [slant] [(0, 1); (1, 1)]%Z cube_point cube_row (kept 1 cube)
    cube_accepted cube_legal) as [[M HM] K].
  exists M. split; [exact HM|]. destruct (K M HM) as (_ & _ & _ & _ & _ & _ & _ & _ & _ & H & _).
  apply H. reflexivity.
Qed.
