(* The standard fold: every nonzero pattern of k1 rows and k2 columns occurs exactly once.

   Let h be primitive of degree n = k1 k2, and n1 = q^k1 - 1 and n2 = (q^n - 1) / n1 coprime. The
   rectangle of k1 rows and k2 columns has rank n for every such h, q, k1 and k2.

   These Haskell functions rely on this file: prove of PraTactile.Window.Proof, and windowRank of
   PraTactile.Window.Rank. *)

From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Import Sequence Primitive Window Fold Cells Independent.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(* The rectangle of k1 rows and k2 columns, read row by row. *)
Definition rectangle (k1 k2 : nat) : mask (k1 * k2) := fun i => (i %/ k2, i %% k2)%N.
Arguments rectangle : clear implicits.

(* The sides of the standard fold. *)
Definition standard_rows (F : finFieldType) (k1 : nat) : nat := (#|F| ^ k1).-1.
Definition standard_columns (F : finFieldType) (h : {poly F}) (k1 : nat) : nat :=
  (period h %/ standard_rows F k1)%N.

Lemma sum_rectangle (V : zmodType) k1 k2 (G : nat -> nat -> V) :
  \sum_(i < k1 * k2) G (i %/ k2)%N (i %% k2)%N = \sum_(i < k1) \sum_(j < k2) G i j.
Proof.
elim: k1 => [|k1 IHk]; first by rewrite mul0n !big_ord0.
rewrite mulSnr -(big_mkord xpredT (fun i => G (i %/ k2)%N (i %% k2)%N)).
rewrite (@big_cat_nat _ _ _ (k1 * k2)) ?leq_addr //= big_mkord IHk big_ord_recr /=; congr (_ + _).
rewrite -{1}[(k1 * k2)%N]add0n big_addn addKn big_mkord; apply: eq_bigr => j _.
have k2_gt0 : (0 < k2)%N := leq_ltn_trans (leq0n j) (ltn_ord j).
by rewrite addnC divnMDl // modnMDl divn_small // modn_small // addn0.
Qed.

Lemma rectangle_columns k1 k2 (l : 'I_(k1 * k2)) : (0 < k2)%N.
Proof. by case: k2 l => // [[l]]; rewrite muln0. Qed.

Lemma rectangle_row k1 k2 (l : 'I_(k1 * k2)) : (l %/ k2 < k1)%N.
Proof. by rewrite ltn_divLR ?(rectangle_columns l). Qed.

Lemma rectangle_column k1 k2 (l : 'I_(k1 * k2)) : (l %% k2 < k2)%N.
Proof. by rewrite ltn_mod (rectangle_columns l). Qed.

Lemma rectangle_cell_lt k1 k2 (i : 'I_k1) (j : 'I_k2) : (i * k2 + j < k1 * k2)%N.
Proof.
by rewrite (@leq_trans (i.+1 * k2)) ?leq_mul2r ?ltn_ord ?orbT // mulSn addnC ltn_add2r.
Qed.

Lemma rectangle_cell_eq k1 k2 (i : 'I_k1) (j : 'I_k2) :
  ((i * k2 + j) %/ k2 = i /\ (i * k2 + j) %% k2 = j)%N.
Proof.
have k2_gt0 : (0 < k2)%N := leq_ltn_trans (leq0n j) (ltn_ord j).
by rewrite divnMDl // modnMDl divn_small // modn_small // addn0.
Qed.

(* A pattern of k1 rows and k2 columns, read row by row. *)
Definition pattern_row (T : Type) k1 k2 (p : 'M[T]_(k1, k2)) : 'rV[T]_(k1 * k2) :=
  \row_l p (Ordinal (rectangle_row l)) (Ordinal (rectangle_column l)).

Lemma pattern_rowE (T : Type) k1 k2 (p : 'M[T]_(k1, k2)) (i : 'I_k1) (j : 'I_k2) :
  pattern_row p 0 (Ordinal (rectangle_cell_lt i j)) = p i j.
Proof.
have [eq_i eq_j] := rectangle_cell_eq i j.
by rewrite mxE; congr (p _ _); apply: val_inj; rewrite /= ?eq_i ?eq_j.
Qed.

Lemma standard_area (F : finFieldType) (h : {poly F}) k1 k2 : degree h = (k1 * k2)%N ->
  (standard_rows F k1 * standard_columns h k1)%N = period h.
Proof. by move=> deg; rewrite mulnC divnK // /period deg expnM dvdn_pred_predX. Qed.

(* The sides are coprime if and only if n1 and k2 are, by T4. *)
Theorem standard_coprime (F : finFieldType) (h : {poly F}) k1 k2 :
  primitive h -> degree h = (k1 * k2)%N ->
  coprime (standard_rows F k1) (standard_columns h k1) = coprime (standard_rows F k1) k2.
Proof.
move=> prim deg; have := degree_gt0 prim; rewrite deg muln_gt0 => /andP[k1_gt0 _].
by rewrite /coprime /standard_columns /standard_rows /period deg gcd_of_sides // finRing_gt1.
Qed.

(* T8. The rectangle of the standard fold has rank n, for every primitive h. *)
Theorem standard_rank (F : finFieldType) (h : {poly F}) k1 k2 :
  primitive h -> degree h = (k1 * k2)%N ->
  coprime (standard_rows F k1) (standard_columns h k1) ->
  torus_rank h (standard_rows F k1) (standard_columns h k1) (rectangle k1 k2) = degree h.
Proof.
move=> prim deg co; have monic_h := primitive_monic prim.
set n1 := standard_rows F k1; set n2 := standard_columns h k1.
have [L _ [alpha alpha_root _]] := irredp_FAdjoin (primitive_irreducible prim).
pose f := [rmorphism of in_alg L].
pose e := torus_exponents n1 n2 (rectangle k1 k2).
suff /eqP full : row_free (mask_matrix h e) by apply: etrans full _; rewrite deg.
rewrite -kermx_eq0; apply/rowV0P => v /sub_kermxP vM0; apply/rowP => l; rewrite mxE.
pose P := \sum_i v 0 i *: 'X^(e i) : {poly F}.
have /eqP : residue h P = residue h 0.
  rewrite residue0 -vM0 mulmx_sum_row /P (big_morph _ (residueD h) (residue0 h)).
  by apply: eq_bigr => i _; rewrite residueZ rowK.
rewrite residue_eq // subr0 => /(root_multiple (f := f) alpha_root).
rewrite /P rmorph_sum horner_sum => eval0.
pose c i j := if insub (i * k2 + j)%N is Some o then v 0 o else 0.
have cE (i : 'I_(k1 * k2)) : c (i %/ k2)%N (i %% k2)%N = v 0 i.
  by rewrite /c -divn_eq valK.
rewrite -cE; apply: (rectangle_independent prim alpha_root deg (standard_area deg) co).
- rewrite -(sum_rectangle k1 k2 (fun i j => f (c i j) * alpha ^+ chinese n1 n2 i j)) -[RHS]eval0.
  apply: eq_bigr => i _.
  by rewrite /= map_polyZ map_polyXn hornerZ hornerXn cE.
- exact: rectangle_row.
exact: rectangle_column.
Qed.

(* The two theorems below are about the array a of n1 rows and n2 columns whose diagonal holds a
   nonzero solution s of the recurrence of h. Rows and columns continue on the torus. *)

(* T8. Two windows of k1 rows and k2 columns with the same content are the same window. *)
Theorem standard_window_unique (F : finFieldType) (h : {poly F}) (s : nat -> F) k1 k2 a :
  let n1 := standard_rows F k1 in let n2 := standard_columns h k1 in
  primitive h -> recurrence h s -> nonzero s -> degree h = (k1 * k2)%N -> coprime n1 n2 ->
  diagonal_fold s n1 n2 a ->
  forall r c r' c',
    (forall i j, (i < k1)%N -> (j < k2)%N ->
       torus n1 n2 a (r + i) (c + j) = torus n1 n2 a (r' + i) (c' + j)) ->
    r = r' %[mod n1] /\ c = c' %[mod n2].
Proof.
move=> n1 n2 prim rec s_neq0 deg co fold r c r' c' eq_cells.
have full := standard_rank prim deg co.
apply: (torus_rank_n_tells prim rec s_neq0 (standard_area deg) co fold full).
apply/rowP => l; rewrite !mxE /=.
by apply: eq_cells; rewrite ?rectangle_row ?rectangle_column.
Qed.

(* T8. Every nonzero pattern of k1 rows and k2 columns is at exactly one cell. *)
Theorem standard_pattern_once (F : finFieldType) (h : {poly F}) (s : nat -> F) k1 k2 a :
  let n1 := standard_rows F k1 in let n2 := standard_columns h k1 in
  primitive h -> recurrence h s -> nonzero s -> degree h = (k1 * k2)%N -> coprime n1 n2 ->
  diagonal_fold s n1 n2 a ->
  forall p : 'M[F]_(k1, k2), p != 0 ->
    exists! x : 'I_n1 * 'I_n2,
      forall (i : 'I_k1) (j : 'I_k2), torus n1 n2 a (x.1 + i) (x.2 + j) = p i j.
Proof.
move=> n1 n2 prim rec s_neq0 deg co fold p p_neq0; have full := standard_rank prim deg co.
have windowP (x : 'I_n1 * 'I_n2) :
    window (torus n1 n2 a) (rectangle k1 k2) x.1 x.2 = pattern_row p <->
    forall (i : 'I_k1) (j : 'I_k2), torus n1 n2 a (x.1 + i) (x.2 + j) = p i j.
  split=> [/rowP eq_v i j|eq_p]; last by apply/rowP => l; rewrite !mxE -eq_p.
  have := eq_v (Ordinal (rectangle_cell_lt i j)); rewrite pattern_rowE !mxE /= => <-.
  by have [-> ->] := rectangle_cell_eq i j.
have row_neq0 : pattern_row p != 0.
  apply: contraNneq p_neq0 => row0; apply/eqP/matrixP => i j.
  by rewrite -pattern_rowE row0 !mxE.
have [x [def_x x_only]] :=
  torus_pattern_once prim rec s_neq0 (standard_area deg) co fold full (esym deg) row_neq0.
by exists x; split=> [|y /windowP/x_only //]; apply/windowP.
Qed.
