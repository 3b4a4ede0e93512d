(* What each theorem assumes. tools/proofs.sh reads what this prints, and fails unless each is closed under the global context.

   It fails too where a Theorem of proofs/ is not asked for here. An axiom would be allowed by a line "allowed: NAME, because
   REASON" in this comment. None is. *)
From PraTactile Require Import Paper Tampered Period Codes Certificate Good.

(* The paper's array. *)
Print Assumptions paper_windows_are_distinct.
Print Assumptions paper_worked_example.
Print Assumptions paper_one_column_is_zero.
Print Assumptions paper_distances.
Print Assumptions paper_window_has_rank_4.

(* T1 to T9 stand here. *)

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
