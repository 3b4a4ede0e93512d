(* The executable definitions on codes agree with the theorems' sequences and powers.

   Exec.v computes on codes, by an arithmetic K. If K passes the check of Coded.v, the codes are the
   elements of a finite field, and its terms and powers of x are those of Sequence.v.

   These Haskell functions rely on this file: termAt of PraTactile.Sequence and powerOfRoot of
   PraTactile.Extension, which the conformance laws compare with the extracted Exec.v. *)

From Coq Require Import PArith NArith.
From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Exec.
From PraTactile Require Import Sequence Primitive Coded Correct Stepping.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Agreement.

Variables (K : Exec.arithmetic N) (q' : nat).
Hypothesis checked : is_field K q'.
Local Notation F := [fieldType of field_of checked].
Local Notation KF := (arithmetic_of F).
Local Notation elements := (map (element checked)).
Local Notation codes_of := (map (@code _ _ checked)).
Implicit Types (a b lower state : seq F).

Lemma code0 : code (0 : field_of checked) = Exec.zero K.
Proof. by case: (code_arithmetic (0 : field_of checked) 0). Qed.

Lemma code1 : code (1 : field_of checked) = Exec.one K.
Proof. by case: (code_arithmetic (0 : field_of checked) 0). Qed.

Lemma codeD (x y : field_of checked) : code (x + y) = Exec.add K (code x) (code y).
Proof. by case: (code_arithmetic x y). Qed.

Lemma codeN (x : field_of checked) : code (- x) = Exec.neg K (code x).
Proof. by case: (code_arithmetic x x). Qed.

Lemma codeM (x y : field_of checked) : code (x * y) = Exec.mul K (code x) (code y).
Proof. by case: (code_arithmetic x y). Qed.

Lemma codes_plus a b : codes_of (Exec.plus KF a b) = Exec.plus K (codes_of a) (codes_of b).
Proof. by elim: a b => [|x a IHa] [|y b] //=; rewrite IHa codeD. Qed.

Lemma codes_scale c a : codes_of (Exec.scale KF c a) = Exec.scale K (code c) (codes_of a).
Proof. by elim: a => //= x a IHa; rewrite /Exec.scale /= -/(Exec.scale _ _ _) IHa codeM. Qed.

Lemma code_dot a b : code (Exec.dot KF a b) = Exec.dot K (codes_of a) (codes_of b).
Proof. by elim: a b => [|x a IHa] [|y b] /=; rewrite ?code0 // codeD codeM IHa. Qed.

Lemma codes_nought a : codes_of (Exec.nought KF a) = Exec.nought K (codes_of a).
Proof. by elim: a => //= x a IHa; rewrite -/(Exec.nought _ _) IHa code0. Qed.

Lemma codes_unit a : codes_of (Exec.unit KF a) = Exec.unit K (codes_of a).
Proof. by case: a => //= x a; rewrite codes_nought code1. Qed.

Lemma codes_shift (x : field_of checked) a :
  codes_of (Exec.shift x a) = Exec.shift (code x) (codes_of a).
Proof. by elim: a x => //= y a IHa x; rewrite IHa. Qed.

Lemma code_last (x : field_of checked) a : code (List.last a x) = List.last (codes_of a) (code x).
Proof. by rewrite last_list; elim: a x => //= y [|z a] IHa x //; exact: (IHa x). Qed.

Lemma codes_timesRoot lower a :
  codes_of (Exec.timesRoot KF lower a) = Exec.timesRoot K (codes_of lower) (codes_of a).
Proof. by rewrite codes_plus codes_shift codes_scale codeN code_last code0. Qed.

Lemma codes_product lower a b :
  codes_of (Exec.product KF lower a b) = Exec.product K (codes_of lower) (codes_of a) (codes_of b).
Proof.
elim: b => [|c b IHb] /=; first by rewrite codes_nought.
by rewrite codes_plus codes_scale codes_timesRoot IHb.
Qed.

Lemma codes_raised lower a e :
  codes_of (Exec.raised KF lower a e) = Exec.raised K (codes_of lower) (codes_of a) e.
Proof. by elim: e a => //= e IHe a; rewrite ?codes_product IHe codes_product. Qed.

Lemma codes_rootPower lower e :
  codes_of (Exec.rootPower KF lower e) = Exec.rootPower K (codes_of lower) e.
Proof. by case: e => [|e]; rewrite /= ?codes_raised ?codes_timesRoot codes_unit. Qed.

Lemma codes_step lower state :
  codes_of (Exec.step KF lower state) = Exec.step K (codes_of lower) (codes_of state).
Proof. by case: state => //= x state; rewrite map_cat /= codeN code_dot. Qed.

Lemma codes_terms lower state count :
  codes_of (Exec.terms KF lower count state)
    = Exec.terms K (codes_of lower) count (codes_of state).
Proof.
elim: count state => //= count IHc state; rewrite IHc codes_step; congr (_ :: _).
by case: state => [|x r] /=; rewrite ?code0.
Qed.

(* Codes below q are the codes of their elements. *)
Lemma codes_elements (l : seq N) : all (@below q') l -> codes_of (elements l) = l.
Proof. by elim: l => //= x l IHl /andP[lt_x /IHl ->]; rewrite elementK. Qed.

Variables (lower state : seq N).
Hypotheses (below_lower : all (@below q') lower) (below_state : all (@below q') state).
Local Notation h := (characteristic (elements lower)).
Local Notation s := (sequence (elements lower) (elements state)).

(* The executable terms are the codes of a sequence that obeys the recurrence. *)
Theorem exec_terms count : (0 < size lower)%N -> size state = size lower ->
  recurrence h s /\ Exec.terms K lower count state = [seq code (s t) | t <- iota 0 count].
Proof.
move=> n_gt0 eq_size; split; first by apply: sequence_recurrence; rewrite ?size_map.
rewrite -{1}(codes_elements below_lower) -{1}(codes_elements below_state) -codes_terms.
by rewrite terms_correct -?map_comp ?size_map.
Qed.

(* The executable power of x has the coefficients of x^e modulo h. *)
Theorem exec_rootPower e : (0 < size lower)%N ->
  exists2 a, Poly a = 'X^(N.to_nat e) %% h & Exec.rootPower K lower e = codes_of a.
Proof.
move=> n_gt0; exists (Exec.rootPower KF (elements lower) e).
  by apply: rootPower_correct; rewrite size_map.
by rewrite codes_rootPower codes_elements.
Qed.

(* The executable power of x is one if and only if h divides x^e - 1. *)
Theorem exec_rootPower_one e : (0 < size lower)%N ->
  (Exec.rootPower K lower e == Exec.unit K lower) = (h %| 'X^(N.to_nat e) - 1).
Proof.
move=> n_gt0; have n_gt0' : (0 < size (elements lower))%N by rewrite size_map.
rewrite -iter_unit // -{1 2}(codes_elements below_lower) -codes_rootPower -codes_unit.
rewrite (inj_eq (inj_map (@code_inj _ _ checked))); congr (_ == _); apply: Poly_inj.
  rewrite iter_size //; case: e => [|e]; rewrite /= ?size_unit //.
  by rewrite size_raised ?size_timesRoot ?size_unit.
by rewrite rootPower_correct // steps_correct.
Qed.

End Agreement.
