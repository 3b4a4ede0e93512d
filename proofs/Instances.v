(* Arrays to which the theorems apply: the paper's over GF(4), and one over GF(9).

   GF(4) has A^2 = A + 1 and the codes 0, 1, 2, 3 for 0, 1, A, A^2; the paper's polynomial is
   x^4 + x^2 + A x + A^2, and its array has 15 rows and 17 columns. Over GF(9) with A^2 = A + 1 the
   polynomial is the first primitive cubic, and the array has 8 rows and 91 columns.

   These Haskell functions rely on this file: fold of PraTactile.Array, which makes these arrays,
   and prove of PraTactile.Window.Proof. *)

From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Exec.
From PraTactile Require Import Sequence Primitive Window Fold Cells Standard Extension.
From PraTactile Require Import Coded Correct Stepping.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Order.

Variables (F : finFieldType) (q : nat) (lower : seq F).
Hypothesis card_F : #|F| = q.
Local Notation n := (size lower).

Lemma order_primitive :
  (0 < n)%N -> order_is lower (q ^ n).-1 -> primitive (characteristic lower).
Proof. by move=> n_gt0; rewrite order_is_primitive // card_F. Qed.

Lemma order_period : period (characteristic lower) = (q ^ n).-1.
Proof. by rewrite /period characteristic_degree card_F. Qed.

Lemma order_rows k1 : standard_rows F k1 = (q ^ k1).-1.
Proof. by rewrite /standard_rows card_F. Qed.

Lemma order_columns k1 :
  standard_columns (characteristic lower) k1 = ((q ^ n).-1 %/ (q ^ k1).-1)%N.
Proof. by rewrite /standard_columns order_period order_rows. Qed.

End Order.

(* The field of 4 elements. *)
Lemma gf4_is_field : is_field (Exec.gf 2 [:: 1; 1; 1]%num) 3.
Proof. by vm_compute. Qed.
Definition GF4 : finFieldType := [finFieldType of field_of gf4_is_field].
Definition gf4 (a : N) : GF4 := element gf4_is_field a.

Lemma card_GF4 : #|GF4| = 4%N.
Proof. exact: (card_coded gf4_is_field). Qed.

(* The field of 9 elements. *)
Lemma gf9_is_field : is_field (Exec.gf 3 [:: 2; 2; 1]%num) 8.
Proof. by vm_compute. Qed.
Definition GF9 : finFieldType := [finFieldType of field_of gf9_is_field].
Definition gf9 (a : N) : GF9 := element gf9_is_field a.

Lemma card_GF9 : #|GF9| = 9%N.
Proof. exact: (card_coded gf9_is_field). Qed.

(* The coefficients without the leading one, constant term first. *)
Definition paper_lower : seq GF4 := map gf4 [:: 3; 2; 1; 0]%num.
Definition paper_polynomial : {poly GF4} := characteristic paper_lower.

Lemma paper_order : order_is paper_lower 255.
Proof. by vm_compute. Qed.

Theorem paper_primitive : primitive paper_polynomial.
Proof. exact: (@order_primitive GF4 4 paper_lower card_GF4 isT paper_order). Qed.

Definition cubic_lower : seq GF9 := map gf9 [:: 3; 1; 0]%num.
Definition cubic : {poly GF9} := characteristic cubic_lower.

Lemma cubic_order : order_is cubic_lower 728.
Proof. by vm_compute. Qed.

Theorem cubic_primitive : primitive cubic.
Proof. exact: (@order_primitive GF9 9 cubic_lower card_GF9 isT cubic_order). Qed.

(* The sequences that begin with 0, ..., 0, 1. *)
Definition paper_sequence : nat -> GF4 := sequence paper_lower (map gf4 [:: 0; 0; 0; 1]%num).
Definition cubic_sequence : nat -> GF9 := sequence cubic_lower (map gf9 [:: 0; 0; 1]%num).

Lemma paper_recurrence : recurrence paper_polynomial paper_sequence.
Proof. exact: sequence_recurrence. Qed.

Lemma paper_nonzero : nonzero paper_sequence.
Proof. by exists 3%N; vm_compute. Qed.

Lemma cubic_recurrence : recurrence cubic cubic_sequence.
Proof. exact: sequence_recurrence. Qed.

Lemma cubic_nonzero : nonzero cubic_sequence.
Proof. by exists 2%N; vm_compute. Qed.

Lemma paper_period : period paper_polynomial = 255%N.
Proof. exact: (order_period paper_lower card_GF4). Qed.

Lemma cubic_period : period cubic = 728%N.
Proof. exact: (order_period cubic_lower card_GF9). Qed.

(* The arrays: the sequences along the diagonal. *)
Definition paper_array (r c : nat) : GF4 := paper_sequence (chinese 15 17 r c).
Definition cubic_array (r c : nat) : GF9 := cubic_sequence (chinese 8 91 r c).

Lemma paper_fold : diagonal_fold paper_sequence 15 17 paper_array.
Proof.
apply: diagonal_fold_exists => // i; rewrite -[(15 * 17)%N]/255%N -paper_period.
exact: (term_mod paper_primitive paper_recurrence).
Qed.

Lemma cubic_fold : diagonal_fold cubic_sequence 8 91 cubic_array.
Proof.
apply: diagonal_fold_exists => // i; rewrite -[(8 * 91)%N]/728%N -cubic_period.
exact: (term_mod cubic_primitive cubic_recurrence).
Qed.

Lemma paper_rows : standard_rows GF4 2 = 15%N. Proof. exact: (order_rows card_GF4). Qed.
Lemma paper_columns : standard_columns paper_polynomial 2 = 17%N.
Proof. exact: (order_columns paper_lower card_GF4). Qed.
Lemma cubic_rows : standard_rows GF9 1 = 8%N. Proof. exact: (order_rows card_GF9). Qed.
Lemma cubic_columns : standard_columns cubic 1 = 91%N.
Proof. exact: (order_columns cubic_lower card_GF9). Qed.

(* Every nonzero pattern of two rows and two columns is at exactly one cell of the paper's array. *)
Theorem paper_pattern_once (p : 'M[GF4]_(2, 2)) : p != 0 ->
  exists! x : 'I_15 * 'I_17,
    forall i j : 'I_2, torus 15 17 paper_array (x.1 + i) (x.2 + j) = p i j.
Proof.
have := @standard_pattern_once _ paper_polynomial paper_sequence 2 2 paper_array.
rewrite paper_rows paper_columns; apply => //.
- exact: paper_primitive.
- exact: paper_recurrence.
- exact: paper_nonzero.
- by rewrite characteristic_degree.
exact: paper_fold.
Qed.

(* Windows of two rows and two columns with the same content are the same window. *)
Theorem paper_window_unique r c r' c' :
  (forall i j, (i < 2)%N -> (j < 2)%N ->
     torus 15 17 paper_array (r + i) (c + j) = torus 15 17 paper_array (r' + i) (c' + j)) ->
  r = r' %[mod 15] /\ c = c' %[mod 17].
Proof.
have := @standard_window_unique _ paper_polynomial paper_sequence 2 2 paper_array.
rewrite paper_rows paper_columns; apply => //.
- exact: paper_primitive.
- exact: paper_recurrence.
- exact: paper_nonzero.
- by rewrite characteristic_degree.
exact: paper_fold.
Qed.

(* Every nonzero pattern of one row and three columns is at exactly one cell of the array over
   GF(9). *)
Theorem cubic_pattern_once (p : 'M[GF9]_(1, 3)) : p != 0 ->
  exists! x : 'I_8 * 'I_91,
    forall (i : 'I_1) (j : 'I_3), torus 8 91 cubic_array (x.1 + i) (x.2 + j) = p i j.
Proof.
have := @standard_pattern_once _ cubic cubic_sequence 1 3 cubic_array.
rewrite cubic_rows cubic_columns; apply => //.
- exact: cubic_primitive.
- exact: cubic_recurrence.
- exact: cubic_nonzero.
- by rewrite characteristic_degree.
exact: cubic_fold.
Qed.

(* An extension, a root and a linear map that satisfy the hypotheses of Extension.v. *)
Theorem paper_functional : exists (L : fieldExtType GF4) (alpha : L) (phi : {linear L -> GF4^o}),
  [/\ \dim {:L} = 4%N, root_in paper_polynomial alpha
    & forall t, paper_sequence t = phi (alpha ^+ t)].
Proof.
have [L [dim_L [alpha root_alpha]]] := extension_exists paper_primitive.
have [phi s_phi] := solution_functional paper_primitive dim_L root_alpha paper_recurrence.
by exists L, alpha, phi; split; rewrite // dim_L characteristic_degree.
Qed.
