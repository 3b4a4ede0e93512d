(* Stepping decides whether a polynomial is primitive, and makes the sequences of the theorems.

   Multiply 1 by x again and again, modulo h. If the result is 1 after |F|^n - 1 steps and not
   before, h is primitive. The first elements of the register's states obey the recurrence of h.

   These Haskell functions rely on this file: mSequence and next of PraTactile.Sequence, which the
   conformance laws compare with the extracted Exec.v. *)

From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Exec.
From PraTactile Require Import Sequence Primitive Correct.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(* Tests in N steps whether the order of x modulo x^n + lower is N. *)
Definition order_is (F : fieldType) (lower : seq F) (N : nat) : bool :=
  let step := Exec.timesRoot (arithmetic_of F) lower in
  let start := Exec.unit (arithmetic_of F) lower in
  (start \notin traject step (step start) N.-1) && (iter N step start == start).

(* The sequence with this state: the first elements of the states that follow it. *)
Definition sequence (F : fieldType) (lower state : seq F) (t : nat) : F :=
  head 0 (iter t (Exec.step (arithmetic_of F) lower) state).

Section Field.

Variables (F : fieldType) (lower : seq F).
Local Notation K := (arithmetic_of F).
Local Notation n := (size lower).
Local Notation h := (characteristic lower).
Hypothesis n_gt0 : (0 < n)%N.

Lemma Poly_inj (a b : seq F) : size a = size b -> Poly a = Poly b -> a = b.
Proof.
move=> eq_ab /polyP eq_P; apply: (@eq_from_nth _ 0) => // i _.
by rewrite -coef_Poly eq_P coef_Poly.
Qed.

Lemma iter_size t : size (iter t (Exec.timesRoot K lower) (Exec.unit K lower)) = n.
Proof. by elim: t => [|t IHt] /=; rewrite ?size_unit ?size_timesRoot. Qed.

Lemma iter_unit m :
  (iter m (Exec.timesRoot K lower) (Exec.unit K lower) == Exec.unit K lower) = (h %| 'X^m - 1).
Proof.
have unit1 : (1 : {poly F}) %% h = 1 by rewrite -(Poly_unit n_gt0) mod_small ?size_unit.
apply/eqP/idP => [eq_m|dvd_m].
  have := steps_correct m n_gt0; rewrite eq_m Poly_unit // -{1}unit1 => eq_1.
  by rewrite /dvdp modpD modpN -eq_1 subrr.
apply: Poly_inj; first by rewrite iter_size size_unit.
rewrite steps_correct // Poly_unit // -[RHS]unit1; apply/eqP.
by rewrite -subr_eq0 -modpN -modpD.
Qed.

Variable state : seq F.
Hypothesis size_state : size state = n.
Local Notation s := (sequence lower state).
Local Notation states t := (iter t (Exec.step K lower) state).

Lemma size_step (a : seq F) : size a = n -> size (Exec.step K lower a) = n.
Proof. by case: a => //= x a <-; rewrite size_cat addn1. Qed.

Lemma size_states t : size (states t) = n.
Proof. by elim: t => //= t IHt; rewrite size_step. Qed.

Lemma nth_step (a : seq F) i : size a = n -> (i.+1 < n)%N ->
  nth 0 (Exec.step K lower a) i = nth 0 a i.+1.
Proof. by case: a => //= [<- //|x a <-]; rewrite ltnS nth_cat => ->. Qed.

Lemma nth_states t i : (i < n)%N -> nth 0 (states t) i = s (t + i).
Proof.
elim: i t => [|i IHi] t lt_i; first by rewrite nth0 addn0.
by rewrite -nth_step ?size_states // -iterS IHi ?(ltnW lt_i) // addnS addSn.
Qed.

Lemma dot_sum (a b : seq F) : size a = size b ->
  Exec.dot K a b = \sum_(i < size a) a`_i * b`_i.
Proof.
elim: a b => [|x a IHa] [|y b] //=; first by rewrite big_ord0.
by move=> [/IHa eq_ab]; rewrite big_ord_recl eq_ab.
Qed.

Lemma last_step (a : seq F) : size a = n -> (Exec.step K lower a)`_n.-1 = - Exec.dot K lower a.
Proof.
case: a => [|x a] /= eq_n; first by move: n_gt0; rewrite -eq_n.
by rewrite -eq_n nth_cat ltnn subnn.
Qed.

Lemma characteristic_coef i : (i < n)%N -> h`_i = lower`_i.
Proof. by move=> lt_i; rewrite coefD coefXn (ltn_eqF lt_i) add0r coef_Poly. Qed.

(* The executable register obeys the recurrence. *)
Theorem sequence_recurrence : recurrence h s.
Proof.
move=> t; rewrite characteristic_degree -{1}(prednK n_gt0) addnS -addSn -nth_states ?prednK //.
rewrite iterS last_step ?size_states // dot_sum ?size_states //; congr (- _).
by apply: eq_bigr => i _; rewrite characteristic_coef // nth_states.
Qed.

(* The executable terms are the terms of the sequence. *)
Theorem terms_correct count : Exec.terms K lower count state = mkseq s count.
Proof.
have terms_from t : Exec.terms K lower count (states t) = mkseq (fun i => s (t + i)) count.
  elim: count t => [|count IHc] t //=; rewrite /mkseq /= addn0; congr (_ :: _).
  rewrite -iterS IHc (iotaDl 1 0) -map_comp; apply: eq_map => i /=.
  by rewrite addSnnS add1n.
by rewrite (terms_from 0%N).
Qed.

End Field.

(* A polynomial is primitive if and only if the order of x is |F|^n - 1, as found by stepping. *)
Theorem order_is_primitive (F : finFieldType) (lower : seq F) :
  (0 < size lower)%N ->
  primitive (characteristic lower) = order_is lower (#|F| ^ size lower).-1.
Proof.
move=> n_gt0; rewrite /primitive characteristic_monic /period characteristic_degree n_gt0 /=.
set N := (_ ^ _).-1; rewrite /order_is iter_unit // andbC; congr (_ && _).
set step := Exec.timesRoot _ _; set start := Exec.unit _ _.
apply/forallP/idP => [no_m|no_m m].
  apply/trajectP => [[i lt_i]]; rewrite -iterSr => eq_start.
  have lt_m : (i.+1 < N)%N by rewrite -ltn_predRL.
  have := no_m (Ordinal lt_m); rewrite /= -iter_unit //.
  by rewrite -/step -/start -eq_start eqxx.
apply/implyP => m_gt0; rewrite -iter_unit //; apply: contra no_m => /eqP eq_start.
apply/trajectP; exists m.-1; first by rewrite -ltnS !prednK // (leq_ltn_trans _ (ltn_ord m)).
by rewrite -iterSr prednK.
Qed.
