(* The finite field whose elements are codes: an executable arithmetic that passes a check is one.

   The check goes through all codes below q and finds that addition and multiplication are closed
   and obey the laws of a field. The elements are then the codes, and the field's operations are
   those of the arithmetic.

   This Haskell module relies on this file: PraTactile.Field, whose tables are this arithmetic. *)

From Coq Require Import NArith Lia.
From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Exec.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Coded.

Variables (K : Exec.arithmetic N) (q' : nat).
Local Notation q := q'.+1.
Local Notation zero := (Exec.zero K).
Local Notation one := (Exec.one K).
Local Notation add := (Exec.add K).
Local Notation neg := (Exec.neg K).
Local Notation mul := (Exec.mul K).

(* The codes below q. *)
Definition codes : seq N := [seq N.of_nat i | i <- iota 0 q].

Definition below (a : N) : bool := N.ltb a (N.of_nat q).

Definition closed_codes : bool :=
  [&& below zero, below one, N.eqb zero 0 & all (fun a => below (neg a) &&
    all (fun b => below (add a b) && below (mul a b)) codes) codes].

Definition lawful_triples : bool :=
  all (fun a => all (fun b => all (fun c =>
    [&& N.eqb (add a (add b c)) (add (add a b) c), N.eqb (mul a (mul b c)) (mul (mul a b) c)
      & N.eqb (mul (add a b) c) (add (mul a c) (mul b c))]) codes) codes) codes.

Definition lawful_pairs : bool :=
  all (fun a => all (fun b => N.eqb (add a b) (add b a) && N.eqb (mul a b) (mul b a)) codes) codes.

Definition inverse (a : N) : N := head 0%num [seq b <- codes | N.eqb (mul a b) one].

Definition lawful_elements : bool :=
  all (fun a => [&& N.eqb (add zero a) a, N.eqb (add (neg a) a) zero, N.eqb (mul one a) a
    & N.eqb a zero || (below (inverse a) && N.eqb (mul (inverse a) a) one)]) codes.

Definition is_field : bool :=
  [&& closed_codes, lawful_triples, lawful_pairs, lawful_elements, ~~ N.eqb one zero
    & N.eqb (inverse zero) zero].

(* The elements: the numbers below q. The field depends on the arithmetic and on its check. *)
Record field_of (checked : is_field) : Type := Coded { number : 'I_q }.

Hypothesis checked : is_field.
Local Notation coded := (field_of checked).

Canonical coded_subType := [newType for @number checked].
Definition coded_eqMixin := [eqMixin of coded by <:].
Canonical coded_eqType := EqType coded coded_eqMixin.
Definition coded_choiceMixin := [choiceMixin of coded by <:].
Canonical coded_choiceType := ChoiceType coded coded_choiceMixin.
Definition coded_countMixin := [countMixin of coded by <:].
Canonical coded_countType := CountType coded coded_countMixin.
Canonical coded_subCountType := [subCountType of coded].
Definition coded_finMixin := [finMixin of coded by <:].
Canonical coded_finType := FinType coded coded_finMixin.

Definition code (x : coded) : N := N.of_nat (number x).
Definition element (a : N) : coded := Coded checked (Ordinal (ltn_pmod (N.to_nat a) (ltn0Sn q'))).

Lemma code_in x : code x \in codes.
Proof. by rewrite /code map_f // mem_iota /= add0n ltn_ord. Qed.

Lemma codeK : cancel code element.
Proof. by move=> x; do 2!apply: val_inj; rewrite /= /code Nnat.Nat2N.id modn_small. Qed.

Lemma elementK a : below a -> code (element a) = a.
Proof.
rewrite /below /code => /N.ltb_lt lt_a /=; rewrite modn_small ?Nnat.N2Nat.id //.
by apply/ltP; lia.
Qed.

Definition addc x y := element (add (code x) (code y)).
Definition negc x := element (neg (code x)).
Definition mulc x y := element (mul (code x) (code y)).
Definition invc x := element (inverse (code x)).

Lemma closed_checked : [/\ below zero, below one, N.eqb zero 0
  & all (fun a => below (neg a) && all (fun b => below (add a b) && below (mul a b)) codes) codes].
Proof. by apply/and4P; case/andP: checked. Qed.

Lemma code_zero : code (element zero) = zero.
Proof. by apply: elementK; case: closed_checked. Qed.

Lemma code_one : code (element one) = one.
Proof. by apply: elementK; case: closed_checked. Qed.

Lemma coded_closed_pair x y : [/\ below (neg (code x)), below (add (code x) (code y))
  & below (mul (code x) (code y))].
Proof.
case: closed_checked => _ _ _ /allP/(_ _ (code_in x))/andP[neg_x /allP/(_ _ (code_in y))/andP[]].
by split.
Qed.

Lemma code_add x y : code (addc x y) = add (code x) (code y).
Proof. by apply: elementK; case: (coded_closed_pair x y). Qed.

Lemma code_mul x y : code (mulc x y) = mul (code x) (code y).
Proof. by apply: elementK; case: (coded_closed_pair x y). Qed.

Lemma code_neg x : code (negc x) = neg (code x).
Proof. by apply: elementK; case: (coded_closed_pair x x). Qed.

Lemma code_inj : injective code. Proof. exact: can_inj codeK. Qed.

Lemma coded_triples x y z : [/\ addc x (addc y z) = addc (addc x y) z,
  mulc x (mulc y z) = mulc (mulc x y) z
  & mulc (addc x y) z = addc (mulc x z) (mulc y z)].
Proof.
case/and5P: checked => _ /allP/(_ _ (code_in x))/allP/(_ _ (code_in y))/allP/(_ _ (code_in z)).
case/and3P=> /N.eqb_eq addA /N.eqb_eq mulA /N.eqb_eq mulD _ _ _.
by split; apply: code_inj; rewrite !(code_add, code_mul).
Qed.

Lemma coded_pairs x y : addc x y = addc y x /\ mulc x y = mulc y x.
Proof.
case/and5P: checked => _ _ /allP/(_ _ (code_in x))/allP/(_ _ (code_in y))/andP[].
by move=> /N.eqb_eq addC /N.eqb_eq mulC _ _; split; apply: code_inj; rewrite !(code_add, code_mul).
Qed.

Lemma coded_elements x : [/\ addc (element zero) x = x, addc (negc x) x = element zero,
  mulc (element one) x = x & x != element zero -> mulc (invc x) x = element one].
Proof.
case/and5P: checked => _ _ _ /allP/(_ _ (code_in x))/and4P[] /N.eqb_eq add0 /N.eqb_eq addN.
move=> /N.eqb_eq mul1 inv _; split; try apply: code_inj; rewrite ?(code_add, code_mul, code_neg);
  rewrite ?code_zero ?code_one // => ne_x; apply: code_inj; rewrite code_mul code_one.
case/orP: inv => [/N.eqb_eq eq_x|/andP[lt_i /N.eqb_eq mulV]]; last by rewrite elementK.
by case/eqP: ne_x; apply: code_inj; rewrite code_zero.
Qed.

Lemma coded_one_neq0 : element one != element zero.
Proof.
apply/eqP => /(congr1 code); rewrite code_zero code_one => eq10.
by case/and5P: checked => _ _ _ _ /andP[]; rewrite eq10 N.eqb_refl.
Qed.

Lemma coded_inv0 : invc (element zero) = element zero.
Proof.
by case/and5P: checked => _ _ _ _ /andP[_ /N.eqb_eq inverse0]; rewrite /invc code_zero inverse0.
Qed.

Definition coded_zmodMixin := ZmodMixin (fun x y z => let: And3 p _ _ := coded_triples x y z in p)
  (fun x y => proj1 (coded_pairs x y)) (fun x => let: And4 p _ _ _ := coded_elements x in p)
  (fun x => let: And4 _ p _ _ := coded_elements x in p).
Canonical coded_zmodType := ZmodType coded coded_zmodMixin.

Definition coded_ringMixin := @ComRingMixin [zmodType of coded] (element one) mulc
  (fun x y z => let: And3 _ p _ := coded_triples x y z in p) (fun x y => proj2 (coded_pairs x y))
  (fun x => let: And4 _ _ p _ := coded_elements x in p)
  (fun x y z => let: And3 _ _ p := coded_triples x y z in p) coded_one_neq0.
Canonical coded_ringType := RingType coded coded_ringMixin.
Canonical coded_comRingType := ComRingType coded (fun x y => proj2 (coded_pairs x y)).

Definition coded_unitMixin := @FieldUnitMixin [comRingType of coded] invc
  (fun x => let: And4 _ _ _ p := coded_elements x in p) coded_inv0.
Canonical coded_unitRingType := UnitRingType coded coded_unitMixin.
Canonical coded_comUnitRingType := [comUnitRingType of coded].
Lemma coded_fieldMixin : GRing.Field.mixin_of [unitRingType of coded].
Proof. by move=> x x_neq0. Qed.
Canonical coded_idomainType := IdomainType coded (FieldIdomainMixin coded_fieldMixin).
Canonical coded_fieldType := FieldType coded coded_fieldMixin.
Canonical coded_finZmodType := [finZmodType of coded].
Canonical coded_finRingType := [finRingType of coded].
Canonical coded_finComRingType := [finComRingType of coded].
Canonical coded_finUnitRingType := [finUnitRingType of coded].
Canonical coded_finComUnitRingType := [finComUnitRingType of coded].
Canonical coded_finIdomainType := [finIdomainType of coded].
Canonical coded_finFieldType := [finFieldType of coded].

Lemma card_coded : #|[finFieldType of coded]| = q.
Proof.
rewrite -[RHS]card_ord (bij_eq_card (f := @number checked)) //.
by exists (@Coded checked) => [[]|].
Qed.

(* The codes of sums and products are those of the arithmetic. *)
Lemma code_arithmetic (x y : coded) :
  [/\ code 0 = zero, code 1 = one, code (x + y) = add (code x) (code y), code (- x) = neg (code x)
    & code (x * y) = mul (code x) (code y)].
Proof.
split; [exact: code_zero | exact: code_one | exact: code_add | exact: code_neg |].
exact: code_mul.
Qed.

End Coded.
