(* The main theorems: what each says, and on which axioms it rests.
   SPDX-License-Identifier: GPL-3.0-or-later

   What this file prints is compared with statements.txt. Definitions that the statements use are printed
   too, so that the record shows what is claimed. Where real numbers come in, the axioms of a group of
   theorems are printed at once: Coq takes seconds for each. *)
Require Import Reals.
Require Import Graze.words Graze.counts Graze.definitions Graze.readings Graze.unsweep Graze.table
  Graze.times Graze.space Graze.sweep Graze.polynomials Graze.finite Graze.affine Graze.cramer Graze.box
  Graze.scenes.
Set Printing Width 100.

(* Words, counts and classes. *)
Print state.
Print word.
Print neighbours.
Print linked.
Print first.
Print last_of.
Print contacts_between.
Print contacts.
Print admissible.
Print crossing.
Print crossings.
Print touches.
Print inside.
Print i_of.
Print t_of.
Print k_of.
Print runs.
Print parts_from.
Print parts.
Print holds_I.
Print visits.
Print from_inside.
Print t_in.
Print t_out.
Check parity. Print Assumptions parity.
Check k_runs. Print Assumptions k_runs.
Check k_parts. Print Assumptions k_parts.
Check visits_k. Print Assumptions visits_k.
Check parts_k. Print Assumptions parts_k.
Check k_inside. Print Assumptions k_inside.
Check exterior_word. Print Assumptions exterior_word.
Check crossings_rev. Print Assumptions crossings_rev.
Check touches_rev. Print Assumptions touches_rev.
Check k_rev. Print Assumptions k_rev.
Check admissible_rev. Print Assumptions admissible_rev.

(* Definitions 5 to 11 and the rule. *)
Print position_case.
Print case_of.
Print apart.
Print D5.
Print D6.
Print D7.
Print D8.
Print D9.
Print D10.
Print D11.
Print meets.
Print class_of.
Print class_of_word.
Print pmc_of.
Check rule_is_definitions. Print Assumptions rule_is_definitions.
Check one_definition. Print Assumptions one_definition.
Check apart_cases. Print Assumptions apart_cases.
Check no_definition_applies. Print Assumptions no_definition_applies.
Check extended_i. Print Assumptions extended_i.
Check pmc_in. Print Assumptions pmc_in.
Check pmc_on. Print Assumptions pmc_on.
Check pmc_out. Print Assumptions pmc_out.
Check D10_is. Print Assumptions D10_is.
Check D11_is. Print Assumptions D11_is.
Check replaced. Print Assumptions replaced.
Check class_rev. Print Assumptions class_rev.
Check case_rev. Print Assumptions case_rev.

(* Readings that fail, loops. *)
Print D10_wrong.
Print wrongly_fold.
Print i_with.
Print t_with.
Print without_class.
Check odd_has_no_definition. Print Assumptions odd_has_no_definition.
Check wrong_parse_regular. Print Assumptions wrong_parse_regular.
Check wrong_parse_exterior. Print Assumptions wrong_parse_exterior.
Check loop_from_inside. Print Assumptions loop_from_inside.
Check loop_from_outside. Print Assumptions loop_from_outside.
Check loop_from_boundary. Print Assumptions loop_from_boundary.
Check ends_slide. Print Assumptions ends_slide.
Check ends_return. Print Assumptions ends_return.
Check ends_merged. Print Assumptions ends_merged.

(* Unsweep on words. *)
Print unsweep_pmc.
Print exchange.
Print opposite.
Print dual.
Check unsweep_in. Print Assumptions unsweep_in.
Check unsweep_out. Print Assumptions unsweep_out.
Check unsweep_on. Print Assumptions unsweep_on.
Check dual_admissible. Print Assumptions dual_admissible.
Check duality. Print Assumptions duality.

(* The table for the C functions. *)
Print words_of.
Print all_words.
Check all_words_complete. Print Assumptions all_words_complete.
Check all_words_once. Print Assumptions all_words_once.

(* The word of a trace. *)
Print trace.
Print functional.
Print open_in.
Print stutter_free.
Print walks.
Print is_word.
Print merged.
Print cuts.
Check word_unique.
Check letter_times.
Check letters_met.
Check first_met.
Check last_met.
Check contact_closed.
Check word_admissible.
Check word_of_cuts.
Check word_joined.
Check word_reversed.
Check word_reparametrised.
Definition of_times :=
  (@word_unique, @letter_times, @letters_met, @first_met, @last_met, @contact_closed,
   @word_admissible, @word_of_cuts, @word_joined, @word_reversed, @word_reparametrised).
Print Assumptions of_times.

(* Sweep and unsweep in space. *)
Print point.
Print set.
Print near.
Print interior.
Print complement.
Print closure.
Print boundary.
Print open_set.
Print closed_set.
Print same.
Print regular_closed.
Print state_at.
Print jointly_continuous.
Print motion.
Print image.
Print sweep.
Print open_sweep.
Print unsweep.
Print inverse.
Print trace_of.
Print forward_trace.
Check trace_admissible.
Check open_sweep_open.
Check sweep_closed.
Check sweep_is_closure.
Check sweep_regular.
Check in_is.
Check on_is.
Check on_is_rest.
Check out_is.
Check in_inner.
Check boundary_on.
Check seam.
Check positions.
Check apart_is.
Check apart_everywhere.
Check unsweep_in_is.
Check unsweep_out_is.
Check unsweep_on_is.
Check unsweep_on_boundary.
Check dual_set.
Check dual_trace.
Check word_moved.
Definition of_sweep :=
  (@trace_admissible, @open_sweep_open, @sweep_closed, @sweep_is_closure, @sweep_regular,
   @in_is, @on_is, @on_is_rest, @out_is, @in_inner, @boundary_on, @seam, @positions,
   @apart_is, @apart_everywhere, @unsweep_in_is, @unsweep_out_is, @unsweep_on_is,
   @unsweep_on_boundary, @dual_set, @dual_trace, @word_moved).
Print Assumptions of_sweep.

(* Rational trajectories through polyhedral sets. *)
Print eval.
Print sign.
Print rational.
Print chain.
Print form.
Print value.
Print agree.
Print polyhedral.
Print sum.
Print matrix.
Print unit_matrix.
Print product.
Print apply_matrix.
Print continuous_in.
Print bounded.
Print affine.
Print affine_move.
Print affine_back.
Check affine_motion_is.
Print rational_piece.
Print det2.
Print det3.
Print inverse2.
Print inverse3.
Print minor.
Print adjugate2.
Print adjugate3.
Print plane_motion.
Print space_motion.
Print entries_rational.
Check finitely_many_roots.
Check signs_stay.
Check state_of_signs.
Check word_exists.
Check one_word.
Check sweep_bounded.
Check classified.
Check classified_plane.
Check classified_space.
Definition of_motions :=
  (@finitely_many_roots, @signs_stay, @state_of_signs, @word_exists, @one_word,
   @sweep_bounded, @classified, @classified_plane, @classified_space).
Print Assumptions of_motions.

(* Scenes. *)
Print box.
Check translation_is.
Print leg.
Print literal_start.
Print dive_path.
Print dive_point.
Print return_path.
Print return_point.
Print seam_path.
Print seam_point.
Print dive.
Print return_.
Print seam_motion.
Check box_regular.
Check box_polyhedral.
Check dive_word.
Check dive_literal.
Check dive_apart.
Check dive_without_class.
Check return_word.
Check return_literal.
Check return_apart.
Check return_without_class.
Check seam_word.
Check seam_on.
Check seam_inner.
Definition of_scenes :=
  (@box_regular, @box_polyhedral, @dive_word, @dive_literal, @dive_apart,
   @dive_without_class, @return_word, @return_literal, @return_apart,
   @return_without_class, @seam_word, @seam_on, @seam_inner).
Print Assumptions of_scenes.

(* The verified checker. What its tests compute is no part of the statements: what they prove is. *)
Require Import ZArith.
Require Import Graze.bernstein Graze.facets Graze.ray Graze.sample Graze.interval Graze.interval_sound
  Graze.row Graze.simplices Graze.motions Graze.checker Graze.square
  Graze.convex Graze.cube.
Print ev.
Print within.
Print signed.
Print root_between.
Check strict_sign.
Check not_negative.
Check one_root.
Print nat_of.
Print dot.
Print zvalue.
Print rdot.
Print zdot.
Print simplex.
Print coordinate.
Print total_weight.
Print weighted.
Print in_hull.
Print in_relative_interior.
Print form_of.
Print normal_of.
Print outward.
Print legal_solid.
Print facet.
Print facets.on.
Print facets.inner.
Print legal.
Check connected.
Check ray_state.
Check ray_tells.
Check facet_on.
Check facet_inner.
Check legal_facets.
Print kind.
Print letters.
Print time.
Print instant.
Print piece.
Print entry.
Print mapped.
Print given_by.
Print value_of.
Print det_poly.
Print span.
Print first_time.
Print last_time.
Print chained.
Print legal_motion.
Check motion_legal.
Check motion_exists_plane.
Check motion_exists_space.
Print operation.
Print row.
Print point_of.
Check divide_out_value.
Check cleared_off.
Check profile_sound.
Check same_state.
Check interval_sound.
Check row_sound.
Print check.
Print says_sweep.
Print says_unsweep.
Check sweep_checked_plane.
Check sweep_checked_space.
Check unsweep_checked_plane.
Check unsweep_checked_space.
Print square.
Print slide.
Print square_row.
Check square_legal.
Check square_accepted.
Check square_swept.
Print kept.
Check convex_legal.
Check convex_checked_plane.
Check convex_checked_space.
Check convex_unsweep_plane.
Check convex_unsweep_space.
Print face.
Print cube.
Print slant.
Print cube_point.
Print cube_row.
Check cube_convex.
Check cube_legal.
Check cube_is_box.
Check cube_accepted.
Check cube_swept.
Definition of_checker :=
  (@strict_sign, @not_negative, @one_root, @connected, @ray_state, @ray_tells, @facet_on, @facet_inner, @legal_facets,
   @motion_legal, @motion_exists_plane, @motion_exists_space, @divide_out_value, @cleared_off, @profile_sound,
   @same_state, @interval_sound, @row_sound, @sweep_checked_plane, @sweep_checked_space, @unsweep_checked_plane,
   @unsweep_checked_space, @square_legal, @square_accepted, @square_swept,
   @convex_legal, @convex_checked_plane, @convex_checked_space, @convex_unsweep_plane,
   @convex_unsweep_space, @cube_convex, @cube_legal, @cube_is_box, @cube_accepted, @cube_swept).
Print Assumptions of_checker.
