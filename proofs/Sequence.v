(* Maximal-length sequences over a finite field F, and why one linear map describes them.

   A primitive polynomial h of degree n and n first terms give a sequence by the recurrence
   s(t+n) = -(h_0 s(t) + ... + h_(n-1) s(t+n-1)). Its period is N = |F|^n - 1. Each term s(t) is a
   linear function of x^t modulo h, and the powers of x modulo h are all nonzero residues.

   These Haskell functions rely on this file: mSequence, stateAt and termAt of PraTactile.Sequence,
   and windowRank of PraTactile.Window.Rank. *)

From mathcomp Require Import all_ssreflect all_algebra.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Definition degree (F : ringType) (h : {poly F}) : nat := (size h).-1.

(* The recurrence whose characteristic polynomial is h, which is monic. *)
Definition recurrence (F : ringType) (h : {poly F}) (s : nat -> F) : Prop :=
  forall t, s (t + degree h)%N = - \sum_(i < degree h) h`_i * s (t + i)%N.

Definition nonzero (F : ringType) (s : nat -> F) : Prop := exists t, s t != 0.

Definition period (F : finFieldType) (h : {poly F}) : nat := (#|F| ^ degree h).-1.

(* h is primitive if it is monic, of positive degree n, and x has order |F|^n - 1 modulo h. *)
Definition primitive (F : finFieldType) (h : {poly F}) : bool :=
  [&& h \is monic, (0 < degree h)%N, h %| 'X^(period h) - 1
    & [forall m : 'I_(period h), (0 < m)%N ==> ~~ (h %| 'X^m - 1)]].

(* The n coefficients of p modulo h, as a row. *)
Definition residue (F : fieldType) (h p : {poly F}) : 'rV[F]_(degree h) :=
  \row_(j < degree h) (p %% h)`_j.

(* The Hankel matrix of the sequence: s(i + j) in row i and column j. *)
Definition hankel (F : ringType) (n : nat) (s : nat -> F) : 'M[F]_n :=
  \matrix_(i < n, j < n) s (i + j)%N.

Section Functional.

Variables (F : fieldType) (h : {poly F}).
Hypothesis h_monic : h \is monic.
Implicit Types (s : nat -> F) (p q : {poly F}).

Let h_neq0 : h != 0. Proof. exact: monic_neq0. Qed.

Lemma size_degree : size h = (degree h).+1.
Proof. by rewrite /degree prednK // size_poly_gt0. Qed.

Lemma size_mod_degree p : (size (p %% h)%R <= degree h)%N.
Proof. by rewrite -ltnS -size_degree ltn_modp. Qed.

(* The linear map that sends x^i to s(i). *)
Definition apply s p := \sum_(i < size p) p`_i * s i.

Lemma apply_wide s p m : (size p <= m)%N -> apply s p = \sum_(i < m) p`_i * s i.
Proof.
move=> le_pm; rewrite /apply (big_ord_widen m (fun i => p`_i * s i) le_pm) big_mkcond /=.
by apply: eq_bigr => i _; case: ltnP => // /(nth_default 0) ->; rewrite mul0r.
Qed.

Lemma applyD s p q : apply s (p + q) = apply s p + apply s q.
Proof.
pose m := maxn (size p) (size q).
rewrite !(@apply_wide _ _ m) ?leq_maxl ?leq_maxr ?size_add // -big_split /=.
by apply: eq_bigr => i _; rewrite coefD mulrDl.
Qed.

Lemma apply0 s : apply s 0 = 0.
Proof. by rewrite /apply size_poly0 big_ord0. Qed.

Lemma applyZ s c p : apply s (c *: p) = c * apply s p.
Proof.
rewrite (@apply_wide _ _ (size p)) ?size_scale_leq // mulr_sumr.
by apply: eq_bigr => i _; rewrite coefZ mulrA.
Qed.

Lemma apply_Xn s t : apply s 'X^t = s t.
Proof.
rewrite /apply size_polyXn big_ord_recr /= coefXn eqxx mul1r big1 ?add0r // => i _.
by rewrite coefXn (ltn_eqF (ltn_ord i)) mul0r.
Qed.

Lemma shifted_recurrence s e : recurrence h s -> recurrence h (fun t => s (t + e)%N).
Proof.
move=> rec t; rewrite addnAC rec; congr (- _); apply: eq_bigr => i _.
by rewrite addnAC.
Qed.

Lemma apply_shift s t : recurrence h s -> apply s ('X^t * h) = 0.
Proof.
move=> rec; rewrite (@apply_wide _ _ (t + (degree h).+1)); last first.
  by rewrite (leq_trans (size_mul_leq _ _)) // size_polyXn size_degree.
rewrite big_split_ord /= big1 ?add0r => [|i _]; last by rewrite coefXnM ltn_ord mul0r.
rewrite (eq_bigr (fun i : 'I_(degree h).+1 => h`_i * s (t + i)%N)) => [|i _]; last first.
  by rewrite coefXnM ltnNge leq_addr /= addKn.
by rewrite big_ord_recr /= -[h`_(degree h)]/(lead_coef h) (eqP h_monic) mul1r rec addrN.
Qed.

Lemma apply_multiple s q : recurrence h s -> apply s (q * h) = 0.
Proof.
move=> rec; rewrite -[q]coefK poly_def mulr_suml.
rewrite (big_morph (apply s) (applyD s) (apply0 s)) big1 // => i _.
by rewrite -scalerAl applyZ apply_shift ?mulr0.
Qed.

Lemma apply_mod s p : recurrence h s -> apply s (p %% h) = apply s p.
Proof. by move=> rec; rewrite [in RHS](divp_eq p h) applyD apply_multiple // add0r. Qed.

(* A term of a solution is a linear function of the power of x modulo h. *)
Lemma term_residue s t : recurrence h s ->
  s t = \sum_(j < degree h) residue h 'X^t 0 j * s j.
Proof.
move=> rec; rewrite -[LHS]apply_Xn -apply_mod // (apply_wide _ (size_mod_degree _)).
by apply: eq_bigr => i _; rewrite mxE.
Qed.

Lemma hankel_term s t e : recurrence h s ->
  s (t + e)%N = (residue h 'X^t *m hankel (degree h) s *m (residue h 'X^e)^T) 0 0.
Proof.
move=> rec; rewrite -mulmxA mxE.
rewrite [LHS](term_residue t (shifted_recurrence e rec)); apply: eq_bigr => j _.
congr (_ * _); rewrite addnC mxE [LHS](term_residue e (shifted_recurrence j rec)).
by apply: eq_bigr => k _; rewrite !mxE mulrC addnC.
Qed.

Lemma residue_eq p q : (residue h p == residue h q) = (h %| p - q).
Proof.
rewrite /dvdp modpD modpN subr_eq0; apply/eqP/eqP => [eq_r|eq_m]; last first.
  by apply/rowP => j; rewrite !mxE eq_m.
apply/polyP => i; have [lt_i|le_i] := ltnP i (degree h).
  by have /rowP/(_ (Ordinal lt_i)) := eq_r; rewrite !mxE.
by rewrite !nth_default // (leq_trans (size_mod_degree _)).
Qed.

Lemma residue0 : residue h 0 = 0.
Proof. by apply/rowP => j; rewrite !mxE mod0p coef0. Qed.

Lemma residueD p q : residue h (p + q) = residue h p + residue h q.
Proof. by apply/rowP => j; rewrite !mxE modpD coefD. Qed.

Lemma residueZ c p : residue h (c *: p) = c *: residue h p.
Proof. by apply/rowP => j; rewrite !mxE modpZl coefZ. Qed.

Lemma residue_rVpoly v : residue h (rVpoly v) = v.
Proof.
apply/rowP => j; rewrite !mxE modp_small ?coef_rVpoly_ord //.
by rewrite size_degree ltnS size_poly.
Qed.

End Functional.
