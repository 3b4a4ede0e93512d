(* What each theorem assumes. tools/proofs.sh reads the output, and fails unless every theorem is
   closed under the global context. It also fails if a Theorem of proofs/ is missing here.

   An axiom would be allowed by a line in this comment that says "allowed: NAME, because
   REASON". There is none. *)
From PraTactile Require Import Paper Tampered.
From PraTactile Require Import Primitive Window Fold Cells Standard Extension Twisted Decode.
From PraTactile Require Import Correct Stepping Agreement Arrays Instances Examples Executable Existence.
From PraTactile Require Import Period Codes Certificate Good.

(* The paper's array. *)
Print Assumptions paper_windows_are_distinct.
Print Assumptions paper_worked_example.
Print Assumptions paper_one_column_is_zero.
Print Assumptions paper_distances.
Print Assumptions paper_window_has_rank_4.

(* Primitive polynomials and their sequences. *)
Print Assumptions residue_power.
Print Assumptions primitive_irreducible.
Print Assumptions least_period.
Print Assumptions solutions_shift.

(* T1 to T3, in terms of exponents. *)
Print Assumptions rank_n_tells.
Print Assumptions tells_rank_n.
Print Assumptions rank_n_neq0.
Print Assumptions contents_with_zero.
Print Assumptions contents_count.
Print Assumptions nonzero_content_once.

(* T4 to T7. *)
Print Assumptions gcd_of_sides.
Print Assumptions diagonal_visits_lcm.
Print Assumptions diagonal_fills_iff_coprime.
Print Assumptions fold_15_273_visits_1365.
Print Assumptions row_by_row_fills.

(* T1 to T3, in terms of the torus's cells. *)
Print Assumptions torus_rank_n_tells.
Print Assumptions torus_tells_rank_n.
Print Assumptions torus_contents_with_zero.
Print Assumptions torus_contents_count.
Print Assumptions torus_rank_n_neq0.
Print Assumptions torus_pattern_once.

(* T8. *)
Print Assumptions standard_coprime.
Print Assumptions standard_rank.
Print Assumptions standard_window_unique.
Print Assumptions standard_pattern_once.

(* T1 and T2 in a field extension. *)
Print Assumptions functional_recurrence.
Print Assumptions extension_exists.
Print Assumptions span_rank.
Print Assumptions tells_iff_span.
Print Assumptions solution_functional.

(* T1 to T3 on the twisted torus. *)
Print Assumptions twisted_rank_n_tells.
Print Assumptions twisted_tells_rank_n.
Print Assumptions twisted_contents_count.
Print Assumptions twisted_pattern_once.

(* T9. *)
Print Assumptions at_most_one_position.
Print Assumptions ambiguous_reading.
Print Assumptions torus_distance.
Print Assumptions torus_at_most_one_position.

(* The executable polynomials and sequences. *)
Print Assumptions timesRoot_correct.
Print Assumptions product_correct.
Print Assumptions rootPower_correct.
Print Assumptions sequence_recurrence.
Print Assumptions terms_correct.
Print Assumptions order_is_primitive.

(* The executable definitions on codes. *)
Print Assumptions exec_terms.
Print Assumptions exec_rootPower.
Print Assumptions exec_rootPower_one.

(* The executable array. *)
Print Assumptions executable_cell.
Print Assumptions executable_fold.
Print Assumptions executable_window.

(* The theorems on arrays over GF(4) and GF(9). *)
Print Assumptions paper_primitive.
Print Assumptions cubic_primitive.
Print Assumptions paper_pattern_once.
Print Assumptions paper_window_unique.
Print Assumptions cubic_pattern_once.
Print Assumptions paper_functional.
Print Assumptions paper_rank.
Print Assumptions paper_corner_contents.
Print Assumptions cubic_pair_contents.
Print Assumptions cubic_row_by_row_fills.
Print Assumptions paper_row_pattern_once.
Print Assumptions cubic_row_pattern_once.
Print Assumptions paper_square_distance.
Print Assumptions paper_at_most_one_position.

(* T8 on the executable windows. *)
Print Assumptions executable_standard_unique.
Print Assumptions executable_standard_occurs.
Print Assumptions paper_executable_unique.
Print Assumptions paper_executable_occurs.

(* There are such polynomials, sequences and arrays. *)
Print Assumptions primitive_exists.
Print Assumptions solution_exists.
Print Assumptions standard_array_exists.

(* T10, and the certificates. *)
Print Assumptions nonzero_is_power.
Print Assumptions states_are_distinct.
Print Assumptions codes_are_a_ring.
Print Assumptions certificate_sound.
Print Assumptions certificates_are_good.
Print Assumptions certified_arrays.
Print Assumptions quartics_are_32.
Print Assumptions paper_polynomial_is_primitive.
Print Assumptions tampered_are_refused.
Print Assumptions untampered_are_good.
