(* The main theorems: what each says, and on which axioms it rests.
   SPDX-License-Identifier: GPL-3.0-or-later

   What this file prints is compared with statements.txt. Definitions that the statements use are printed
   too, so that the record shows what is claimed. *)
Require Import Reals.
Require Import Graze.words Graze.counts Graze.definitions Graze.readings Graze.unsweep Graze.table
  Graze.times Graze.space Graze.sweep Graze.polynomials Graze.finite Graze.affine Graze.cramer Graze.box
  Graze.scenes.
Set Printing Width 100.

(* Words, counts and classes. *)
Print admissible.
Print crossing.
Print i_of.
Print t_of.
Print k_of.
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
Print dual.
Check unsweep_in. Print Assumptions unsweep_in.
Check unsweep_out. Print Assumptions unsweep_out.
Check unsweep_on. Print Assumptions unsweep_on.
Check dual_admissible. Print Assumptions dual_admissible.
Check duality. Print Assumptions duality.

(* The table for the C functions. *)
Check all_words_complete. Print Assumptions all_words_complete.
Check all_words_once. Print Assumptions all_words_once.

(* The word of a trace. *)
Print functional.
Print open_in.
Print stutter_free.
Print walks.
Print is_word.
Check word_unique. Print Assumptions word_unique.
Check letter_times. Print Assumptions letter_times.
Check letters_met. Print Assumptions letters_met.
Check first_met. Print Assumptions first_met.
Check last_met. Print Assumptions last_met.
Check contact_closed. Print Assumptions contact_closed.
Check word_admissible. Print Assumptions word_admissible.
Check word_of_cuts. Print Assumptions word_of_cuts.
Check word_joined. Print Assumptions word_joined.
Check word_reversed. Print Assumptions word_reversed.
Check word_reparametrised. Print Assumptions word_reparametrised.

(* Sweep and unsweep in space. *)
Print near.
Print interior.
Print closure.
Print boundary.
Print regular_closed.
Print state_at.
Print jointly_continuous.
Print motion.
Print image.
Print sweep.
Print open_sweep.
Print unsweep.
Print trace_of.
Print forward_trace.
Check trace_admissible. Print Assumptions trace_admissible.
Check open_sweep_open. Print Assumptions open_sweep_open.
Check sweep_closed. Print Assumptions sweep_closed.
Check sweep_is_closure. Print Assumptions sweep_is_closure.
Check sweep_regular. Print Assumptions sweep_regular.
Check in_is. Print Assumptions in_is.
Check on_is. Print Assumptions on_is.
Check on_is_rest. Print Assumptions on_is_rest.
Check out_is. Print Assumptions out_is.
Check in_inner. Print Assumptions in_inner.
Check boundary_on. Print Assumptions boundary_on.
Check seam. Print Assumptions seam.
Check positions. Print Assumptions positions.
Check apart_is. Print Assumptions apart_is.
Check apart_everywhere. Print Assumptions apart_everywhere.
Check unsweep_in_is. Print Assumptions unsweep_in_is.
Check unsweep_out_is. Print Assumptions unsweep_out_is.
Check unsweep_on_is. Print Assumptions unsweep_on_is.
Check unsweep_on_boundary. Print Assumptions unsweep_on_boundary.
Check dual_set. Print Assumptions dual_set.
Check dual_trace. Print Assumptions dual_trace.
Check word_moved. Print Assumptions word_moved.

(* Rational trajectories through polyhedral sets. *)
Print rational.
Print chain.
Print form.
Print value.
Print polyhedral.
Print affine.
Print affine_motion.
Print rational_piece.
Print plane_motion.
Print space_motion.
Print entries_rational.
Check finitely_many_roots. Print Assumptions finitely_many_roots.
Check signs_stay. Print Assumptions signs_stay.
Check state_of_signs. Print Assumptions state_of_signs.
Check word_exists. Print Assumptions word_exists.
Check one_word. Print Assumptions one_word.
Check sweep_bounded. Print Assumptions sweep_bounded.
Check classified. Print Assumptions classified.
Check classified_plane. Print Assumptions classified_plane.
Check classified_space. Print Assumptions classified_space.

(* Scenes. *)
Print box.
Print literal_start.
Print dive.
Print return_.
Print seam_motion.
Check box_regular. Print Assumptions box_regular.
Check box_polyhedral. Print Assumptions box_polyhedral.
Check dive_word. Print Assumptions dive_word.
Check dive_literal. Print Assumptions dive_literal.
Check dive_apart. Print Assumptions dive_apart.
Check dive_without_class. Print Assumptions dive_without_class.
Check return_word. Print Assumptions return_word.
Check return_literal. Print Assumptions return_literal.
Check return_apart. Print Assumptions return_apart.
Check return_without_class. Print Assumptions return_without_class.
Check seam_word. Print Assumptions seam_word.
Check seam_on. Print Assumptions seam_on.
Check seam_inner. Print Assumptions seam_inner.
