(* The executable polynomials and sequences are those of the theorems.

   Over a field F the lists of Exec.v compute in F[x] modulo h = x^n + lower, and its terms are
   those of the recurrence of h. In this way the theorems hold of what Exec.v computes.

   These Haskell functions rely on this file: mSequence of PraTactile.Sequence and powerOfRoot of
   PraTactile.Extension, which the conformance laws compare with the extracted Exec.v. *)

From Coq Require Import PArith NArith.
From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Exec.
From PraTactile Require Import Sequence Primitive.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(* The operations of a ring, as Exec.v takes them. *)
Definition arithmetic_of (R : ringType) : Exec.arithmetic R :=
  Exec.Arithmetic 0 1 (@GRing.add R) (@GRing.opp R) (@GRing.mul R).

(* The polynomial x^n + lower, n being the number of coefficients in lower. *)
Definition characteristic (R : ringType) (lower : seq R) : {poly R} :=
  'X^(size lower) + Poly lower.

Section Lists.

Variable F : fieldType.
Local Notation K := (arithmetic_of F).
Implicit Types (a b lower : seq F).

Lemma size_plus a b : size (Exec.plus K a b) = minn (size a) (size b).
Proof. by elim: a b => [|x a IHa] [|y b] //=; rewrite IHa minnSS. Qed.

Lemma Poly_plus a b : size a = size b -> Poly (Exec.plus K a b) = Poly a + Poly b.
Proof.
elim: a b => [|x a IHa] [|y b] //=; first by rewrite addr0.
by move=> [/IHa eq_ab]; rewrite !cons_poly_def eq_ab mulrDl polyCD addrACA.
Qed.

Lemma size_scale c a : size (Exec.scale K c a) = size a.
Proof. by rewrite size_map. Qed.

Lemma Poly_scale c a : Poly (Exec.scale K c a) = c *: Poly a.
Proof.
elim: a => [|x a IHa] /=; first by rewrite scaler0.
by rewrite !cons_poly_def IHa scalerDr scalerAl polyCM mul_polyC.
Qed.

Lemma Poly_nought a : Poly (Exec.nought K a) = 0.
Proof. by elim: a => //= x a IHa; rewrite cons_poly_def IHa mul0r addr0. Qed.

Lemma size_shift (x : F) a : size (Exec.shift x a) = size a.
Proof. by elim: a x => //= y a IHa x; rewrite IHa. Qed.

Lemma Poly_shift (x : F) a :
  Poly (Exec.shift x a) = x%:P + 'X * Poly a - last x a *: 'X^(size a).
Proof.
elim: a x => [|y a IHa] x /=; first by rewrite mulr0 addr0 expr0 alg_polyC subrr.
rewrite !cons_poly_def IHa mulrBl -scalerAl -exprSr mulrDl mulrDr addrAC; congr (_ - _).
by rewrite [LHS]addrC; congr (_ + _); rewrite addrC mulrA ['X * y%:P]mulrC.
Qed.

Lemma last_list (x : F) a : List.last a x = last x a.
Proof. by elim: a x => //= y [|z a] IHa x //; exact: IHa. Qed.

Variable lower : seq F.
Local Notation h := (characteristic lower).

Lemma characteristic_monic : h \is monic.
Proof.
by rewrite monicE /characteristic lead_coefDl ?lead_coefXn // size_polyXn ltnS size_Poly.
Qed.

Lemma characteristic_degree : degree h = size lower.
Proof. by rewrite /degree size_addl ?size_polyXn // ltnS size_Poly. Qed.

Lemma size_timesRoot a : size a = size lower -> size (Exec.timesRoot K lower a) = size lower.
Proof. by move=> eq_a; rewrite size_plus size_shift size_scale eq_a minnn. Qed.

Lemma mod_small a : size a = size lower -> Poly a %% h = Poly a.
Proof.
move=> eq_a; rewrite modp_small // (leq_ltn_trans (size_Poly a)) //.
by rewrite (size_degree characteristic_monic) characteristic_degree eq_a.
Qed.

(* One step multiplies by x modulo h. *)
Theorem timesRoot_correct a : size a = size lower ->
  Poly (Exec.timesRoot K lower a) = ('X * Poly a) %% h.
Proof.
move=> eq_a; rewrite -mod_small ?size_timesRoot //; apply/eqP.
rewrite -subr_eq0 -modpN -modpD; apply/eqP/modp_eq0.
rewrite Poly_plus ?size_shift ?size_scale // Poly_shift Poly_scale last_list /= eq_a add0r.
set l := last 0 a.
have -> : 'X * Poly a - l *: 'X^(size lower) + - l *: Poly lower - 'X * Poly a = - l *: h.
  by rewrite /characteristic scalerDr !scaleNr [LHS]addrC -addrA addKr.
by rewrite -mul_polyC dvdp_mulIr.
Qed.

Lemma size_product a b : size a = size lower -> size (Exec.product K lower a b) = size lower.
Proof.
move=> eq_a; elim: b => [|c b IHb] /=; first by rewrite size_map.
by rewrite size_plus size_scale size_timesRoot // eq_a minnn.
Qed.

(* The executable product is the product modulo h. *)
Theorem product_correct a b : size a = size lower ->
  Poly (Exec.product K lower a b) = (Poly a * Poly b) %% h.
Proof.
move=> eq_a; elim: b => [|c b IHb] /=; first by rewrite mulr0 mod0p Poly_nought.
rewrite Poly_plus ?size_scale ?size_timesRoot ?size_product // Poly_scale.
rewrite timesRoot_correct ?size_product // IHb modp_mul cons_poly_def mulrDr modpD [LHS]addrC.
congr (_ + _); first by rewrite ['X * _]mulrC -mulrA.
by rewrite [Poly a * _]mulrC mul_polyC modpZl mod_small.
Qed.

Lemma size_unit : size (Exec.unit K lower) = size lower.
Proof. by case: lower => //= x r; rewrite size_map. Qed.

Lemma Poly_unit : (0 < size lower)%N -> Poly (Exec.unit K lower) = 1.
Proof. by case: lower => //= x r _; rewrite Poly_nought cons_poly_def mul0r add0r. Qed.

Lemma size_raised a e : size a = size lower -> size (Exec.raised K lower a e) = size lower.
Proof. by elim: e a => //= e IHe a eq_a; rewrite ?size_product ?IHe ?size_product. Qed.

Lemma mod_exp p k : ((p %% h) ^+ k) %% h = (p ^+ k) %% h.
Proof.
elim: k => [|k IHk]; first by rewrite !expr0.
by rewrite !exprS -modp_mul IHk modp_mul mulrC modp_mul mulrC.
Qed.

Lemma raised_correct a e : size a = size lower ->
  Poly (Exec.raised K lower a e) = (Poly a ^+ Pos.to_nat e) %% h.
Proof.
elim: e a => [e IHe|e IHe|] a eq_a /=; last by rewrite expr1 mod_small.
  rewrite product_correct // IHe ?size_product // product_correct // mod_exp modp_mul.
  by rewrite -expr2 -exprM -exprS Pnat.Pos2Nat.inj_xI multE.
rewrite IHe ?size_product // product_correct // mod_exp.
by rewrite -expr2 -exprM Pnat.Pos2Nat.inj_xO multE.
Qed.

(* The executable power, by repeated squaring, is x^e modulo h. *)
Theorem rootPower_correct e : (0 < size lower)%N ->
  Poly (Exec.rootPower K lower e) = 'X^(N.to_nat e) %% h.
Proof.
move=> n_gt0; have unit1 : (1 : {poly F}) %% h = 1.
  by rewrite -Poly_unit // mod_small // size_unit.
case: e => [|e] /=; first by rewrite Poly_unit // expr0.
rewrite raised_correct ?size_timesRoot ?size_unit // timesRoot_correct ?size_unit // Poly_unit //.
by rewrite mulr1 mod_exp.
Qed.

(* Stepping from 1 finds the powers of x one after another. *)
Lemma steps_correct t : (0 < size lower)%N ->
  Poly (iter t (Exec.timesRoot K lower) (Exec.unit K lower)) = 'X^t %% h.
Proof.
move=> n_gt0.
have size_iter u : size (iter u (Exec.timesRoot K lower) (Exec.unit K lower)) = size lower.
  by elim: u => [|u IHu] /=; rewrite ?size_unit ?size_timesRoot.
elim: t => [|t IHt] /=; first by rewrite expr0 -Poly_unit // mod_small ?size_unit.
by rewrite timesRoot_correct // IHt modp_mul -exprS.
Qed.

End Lists.
