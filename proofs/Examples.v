(* Further instances of the theorems: T2, T3 below rank n, T7 and T9.

   The arrays are those of Instances.v, the paper's 15 x 17 array over GF(4) and the 8 x 91 array
   over GF(9), and the sequence over GF(9) folded row by row into 26 rows and 28 columns. These
   sides have the common divisor 2, so that the diagonal does not fill this array.

   These Haskell functions rely on this file: windowRank and windowsOfRank of
   PraTactile.Window.Rank, fold of PraTactile.Array with RowMajor, and guaranteedRadius of
   PraTactile.Locate. *)

From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Exec.
From PraTactile Require Import Sequence Primitive Window Fold Cells Standard Twisted Decode.
From PraTactile Require Import Coded Correct Stepping Instances.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Lemma paper_degree : degree paper_polynomial = 4%N. Proof. exact: characteristic_degree. Qed.
Lemma cubic_degree : degree cubic = 3%N. Proof. exact: characteristic_degree. Qed.
Lemma paper_area : (15 * 17)%N = period paper_polynomial. Proof. by rewrite paper_period. Qed.
Lemma cubic_area : (8 * 91)%N = period cubic. Proof. by rewrite cubic_period. Qed.
Lemma cubic_row_area : (26 * 28)%N = period cubic. Proof. by rewrite cubic_period. Qed.

(* T2. Equal windows of two rows and two columns are at the same cell of the paper's array only, so
   their rank is 4. *)
Theorem paper_rank : torus_rank paper_polynomial 15 17 (rectangle 2 2) = 4%N.
Proof.
apply: etrans paper_degree; apply: (torus_tells_rank_n paper_primitive paper_recurrence
  paper_nonzero paper_area isT paper_fold); first by rewrite paper_period.
move=> r c r' c' /rowP eq_w; apply: paper_window_unique => i j lt_i lt_j.
have [eq_i eq_j] := rectangle_cell_eq (Ordinal lt_i) (Ordinal lt_j).
have := eq_w (Ordinal (rectangle_cell_lt (Ordinal lt_i) (Ordinal lt_j))).
by rewrite !mxE /= eq_i eq_j.
Qed.

(* The rank of the row of three cells in the array over GF(9). *)
Lemma cubic_rank : torus_rank cubic 8 91 (rectangle 1 3) = 3%N.
Proof.
have := @standard_rank _ cubic 1 3 cubic_primitive cubic_degree.
by rewrite cubic_rows cubic_columns cubic_degree; apply.
Qed.

(* The first k of m cells whose powers of x are independent have rank k. *)
Lemma first_cells_rank (F : fieldType) (h : {poly F}) m (e : 'I_m -> nat) k (le_k : (k <= m)%N) :
  mask_rank h e = m -> mask_rank h (fun i => e (widen_ord le_k i)) = k.
Proof.
move=> full; have free : row_free (mask_matrix h e) by apply/eqP.
have -> : mask_rank h (fun i => e (widen_ord le_k i))
    = \rank ((pid_mx k : 'M[F]_(k, m)) *m mask_matrix h e).
  congr (\rank _); apply/matrixP => i j; rewrite [RHS]mxE (bigD1 (widen_ord le_k i)) //=.
  rewrite big1 => [|l ne_l]; last first.
    by rewrite mxE; case: eqP => [eq_l|_]; rewrite ?mul0r //; case/eqP: ne_l; exact: val_inj.
  by rewrite addr0 !mxE eqxx ltn_ord mul1r.
by rewrite mxrankMfree // rank_pid_mx.
Qed.

(* The first three cells of the 2 x 2 rectangle, and the first two of the 1 x 3 rectangle. *)
Definition corner : mask 3 := fun i => rectangle 2 2 (widen_ord (isT : (3 <= 2 * 2)%N) i).
Definition pair : mask 2 := fun i => rectangle 1 3 (widen_ord (isT : (2 <= 1 * 3)%N) i).

Lemma corner_rank : torus_rank paper_polynomial 15 17 corner = 3%N.
Proof. exact: (first_cells_rank _ paper_rank). Qed.

Lemma pair_rank : torus_rank cubic 8 91 pair = 2%N.
Proof. exact: (first_cells_rank _ cubic_rank). Qed.

(* T3 below rank n. Three cells of rank 3 show all 64 contents in the 255 cells of the paper's
   array. *)
Theorem paper_corner_contents :
  #|[set window (torus 15 17 paper_array) corner x.1 x.2 | x : 'I_15 * 'I_17]| = 64%N.
Proof.
rewrite (torus_contents_count paper_primitive paper_recurrence paper_nonzero _ paper_area isT
  paper_fold).
by rewrite corner_rank paper_degree card_GF4.
Qed.

(* T3 below rank n. Two cells of rank 2 show all 81 contents in the array over GF(9). *)
Theorem cubic_pair_contents :
  #|[set window (torus 8 91 cubic_array) pair x.1 x.2 | x : 'I_8 * 'I_91]| = 81%N.
Proof.
rewrite (torus_contents_count cubic_primitive cubic_recurrence cubic_nonzero _ cubic_area isT
  cubic_fold).
by rewrite pair_rank cubic_degree card_GF9.
Qed.

(* T7. In 26 rows and 28 columns every cell is visited once row by row, and some cell is never
   visited along the diagonal. *)
Theorem cubic_row_by_row_fills :
  (forall r c, (r < 26)%N -> (c < 28)%N ->
     exists! i, (i < 728)%N /\ (i %/ 28 = r /\ i %% 28 = c)%N) /\ visited 26 28 != setT.
Proof.
split; last by rewrite diagonal_fills_iff_coprime.
by move=> r c lt_r lt_c; exact: (@row_by_row_fills 26 28).
Qed.

(* The arrays row by row. *)
Definition paper_row_array (r c : nat) : GF4 := paper_sequence (17 * r + c)%N.
Definition cubic_row_array (r c : nat) : GF9 := cubic_sequence (28 * r + c)%N.

(* The row of n cells has rank n row by row: its powers of x are 1, x, ..., x^(n-1). *)
Lemma run_rank (F : fieldType) (h : {poly F}) n2 n : h \is monic -> degree h = n ->
  twisted_rank h n2 (rectangle 1 n) = n.
Proof.
move=> h_monic deg; rewrite /twisted_rank /mask_rank.
have -> : mask_matrix h (twisted_exponents n2 (rectangle 1 n)) = pid_mx n.
  apply/matrixP => i j; have lt_i : (i < n)%N.
    by rewrite (leq_trans (ltn_ord i)) ?mul1n.
  rewrite !mxE /twisted_exponents /= divn_small // muln0 add0n modn_small //.
  rewrite modp_small ?coefXn ?lt_i ?andbT 1?eq_sym //.
  by rewrite size_polyXn size_degree // ltnS deg.
by rewrite rank_pid_mx ?mul1n ?deg.
Qed.

(* T3 on the twisted torus. Every nonzero pattern of four cells in a row is at exactly one cell of
   the paper's sequence row by row. *)
Theorem paper_row_pattern_once (v : 'rV[GF4]_(1 * 4)) : v != 0 ->
  exists! x : 'I_15 * 'I_17,
    window (twisted_torus 15 17 paper_row_array) (rectangle 1 4) x.1 x.2 = v.
Proof.
apply: (twisted_pattern_once paper_primitive paper_recurrence paper_nonzero paper_area).
- by [].
- by rewrite (run_rank _ (primitive_monic paper_primitive) paper_degree) paper_degree.
by rewrite paper_degree.
Qed.

(* T3 on the twisted torus. Every nonzero pattern of three cells in a row is at exactly one cell of
   the 26 x 28 array. *)
Theorem cubic_row_pattern_once (v : 'rV[GF9]_(1 * 3)) : v != 0 ->
  exists! x : 'I_26 * 'I_28,
    window (twisted_torus 26 28 cubic_row_array) (rectangle 1 3) x.1 x.2 = v.
Proof.
apply: (twisted_pattern_once cubic_primitive cubic_recurrence cubic_nonzero cubic_row_area).
- by [].
- by rewrite (run_rank _ (primitive_monic cubic_primitive) cubic_degree) cubic_degree.
by rewrite cubic_degree.
Qed.

(* Which of the first 255 terms of the paper's sequence are not zero. *)
Definition paper_nonzeros : seq bool := [seq x != 0
  | x <- Exec.terms (arithmetic_of GF4) paper_lower 255 (map gf4 [:: 0; 0; 0; 1]%num)].

Lemma paper_nonzeroE t : (paper_sequence t != 0) = nth false paper_nonzeros (t %% 255).
Proof.
rewrite -(term_mod paper_primitive paper_recurrence) paper_period /paper_nonzeros terms_correct //.
by rewrite (nth_map 0) ?size_mkseq ?ltn_mod // nth_mkseq ?ltn_mod.
Qed.

(* The exponents of the 3 x 3 rectangle, and the least number of nonzero cells by computation. *)
Definition square_exponent (l : nat) : nat := (chinese 15 17 (l %/ 3) (l %% 3) %% 255)%N.

Lemma square_weights :
  let terms := paper_nonzeros in let exponents := map square_exponent (iota 0 9) in
  all (fun t => 4 <= count (fun e => nth false terms ((t + e) %% 255)) exponents)%N (iota 0 255).
Proof. by vm_compute. Qed.

Lemma card_count m (P : pred nat) : #|[set i : 'I_m | P i]| = count P (iota 0 m).
Proof. by rewrite cardsE cardE /enum_mem size_filter -val_enum_ord count_map enumT. Qed.

(* Each window of three rows and three columns of the paper's array has at least 4 nonzero cells. *)
Lemma paper_square_weight (x : 'I_15 * 'I_17) :
  (4 <= distance (window (torus 15 17 paper_array) (rectangle 3 3) x.1 x.2) 0)%N.
Proof.
rewrite (torus_window _ _ _ _ paper_fold) //; set t := chinese 15 17 x.1 x.2.
have /allP/(_ (t %% 255)%N) := square_weights; rewrite mem_iota ltn_mod => /(_ isT).
rewrite count_map -card_count => /leq_trans; apply; apply/subset_leq_card/subsetP => i.
by rewrite !inE !mxE paper_nonzeroE /= modnDm.
Qed.

(* T9. Windows of three rows and three columns at different cells of the paper's array differ in at
   least 4 cells. *)
Theorem paper_square_distance (x x' : 'I_15 * 'I_17) : x != x' ->
  (4 <= distance (window (torus 15 17 paper_array) (rectangle 3 3) x.1 x.2)
          (window (torus 15 17 paper_array) (rectangle 3 3) x'.1 x'.2))%N.
Proof.
exact: (torus_distance paper_primitive paper_recurrence paper_nonzero paper_area isT paper_fold
  paper_square_weight).
Qed.

(* T9. If 2 e + s < 4, at most one cell's window is within e errors and s erasures of what was
   read in three rows and three columns. *)
Theorem paper_at_most_one_position e (E : {set 'I_(3 * 3)}) (y : 'rV[GF4]_(3 * 3)) :
  (2 * e + #|E| < 4)%N -> forall x x' : 'I_15 * 'I_17,
  (errors E (window (torus 15 17 paper_array) (rectangle 3 3) x.1 x.2) y <= e)%N ->
  (errors E (window (torus 15 17 paper_array) (rectangle 3 3) x'.1 x'.2) y <= e)%N -> x = x'.
Proof.
exact: (torus_at_most_one_position paper_primitive paper_recurrence paper_nonzero paper_area isT
  paper_fold paper_square_weight).
Qed.
