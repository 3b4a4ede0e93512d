(* The powers of a root that belong to a rectangle of the standard fold are independent.

   Let h be primitive of degree n = k1 k2, n1 = q^k1 - 1 and n2 = (q^n - 1) / n1 coprime. For a root
   alpha of h the rectangle's powers are alpha^e(i,j) = b^i g^j, where b has order n1 and
   alpha = b g. A polynomial over GF(q) of degree below k1 that vanishes at b vanishes at the k1
   conjugates b^(q^m), so it is zero. A polynomial over GF(q^k1) of degree below k2 that vanishes at
   g vanishes at the k2 conjugates of g, so it is zero. So the b^i g^j are independent over GF(q).

   Standard.v relies on this file, and so do windowRank of PraTactile.Window.Rank and prove of
   PraTactile.Window.Proof. *)

From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Import Sequence Primitive.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Lemma power_injective Q k i j : (1 < Q)%N -> (i < k)%N -> (j < k)%N ->
  Q ^ i = Q ^ j %[mod (Q ^ k).-1] -> i = j.
Proof.
move=> Q_gt1 lt_i lt_j; have Q_gt0 l : (0 < Q ^ l)%N by rewrite expn_gt0 (ltnW Q_gt1).
rewrite -[(Q ^ i)%N]prednK // -[(Q ^ j)%N]prednK // -(addn1 (Q ^ i).-1) -(addn1 (Q ^ j).-1).
move/eqP; rewrite eqn_modDr.
have small l : (l < k)%N -> ((Q ^ l).-1 < (Q ^ k).-1)%N.
  by move=> lt_l; rewrite -ltnS !prednK // ltn_exp2l.
rewrite !modn_small ?small // => /eqP eq_pred; apply: (expnI Q_gt1).
by rewrite -[(Q ^ i)%N]prednK // eq_pred prednK.
Qed.

(* A polynomial is zero if the Q-th power fixes its coefficients, and it vanishes at an element with
   at least as many conjugates as the polynomial has coefficients. *)
Lemma conjugate_roots (L : fieldType) (Q k : nat) (y : L) (p : {poly L}) :
  [char L].-nat Q -> (forall i, p`_i ^+ Q = p`_i) -> (size p <= k)%N -> p.[y] = 0 ->
  (forall i j, (i < k)%N -> (j < k)%N -> y ^+ (Q ^ i) = y ^+ (Q ^ j) -> i = j) -> p = 0.
Proof.
move=> charQ fixed size_p p_y distinct; apply/eqP; apply: contraT => p_neq0.
have addQ : {morph (fun x : L => x ^+ Q) : u v / u + v} by move=> u v; rewrite exprDn_char.
have Q_gt0 : (0 < Q)%N by case/andP: charQ.
have pQ x : p.[x ^+ Q] = p.[x] ^+ Q.
  rewrite !horner_coef (big_morph _ addQ (expr0n _ _)) ?(gtn_eqF Q_gt0) //.
  by apply: eq_bigr => i _; rewrite exprMn fixed exprAC.
have root_p i : p.[y ^+ (Q ^ i)] = 0.
  by elim: i => [|i IHi]; rewrite ?expr1 // expnSr exprM pQ IHi expr0n (gtn_eqF Q_gt0).
suff : (k < size p)%N by rewrite ltnNge size_p.
rewrite -[k](size_iota 0) -(size_map (fun i => y ^+ (Q ^ i))); apply: max_poly_roots => //.
  by apply/allP => _ /mapP[i _ ->]; rewrite /root root_p.
rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_iota /= => lt_i lt_j; exact: distinct.
Qed.

Section Root.

Variables (F : finFieldType) (h : {poly F}) (L : fieldType) (f : {rmorphism F -> L}) (alpha : L).
Hypotheses (h_primitive : primitive h) (alpha_root : root (map_poly f h) alpha).

Local Notation q := #|F|.
Local Notation N := (period h).
Let h_monic := primitive_monic h_primitive.

Lemma root_multiple p : h %| p -> (map_poly f p).[alpha] = 0.
Proof. by case/dvdpP=> r ->; rewrite rmorphM hornerM (rootP alpha_root) mulr0. Qed.

Lemma root_power_neq0 t : alpha ^+ t != 0.
Proof.
have := root_multiple (power_period h_primitive).
rewrite rmorphB /= rmorph1 map_polyXn hornerD hornerN hornerXn hornerC => /eqP.
rewrite subr_eq0 => /eqP alphaN; apply: expf_neq0; apply: contraNneq (oner_neq0 L) => alpha0.
by rewrite -alphaN alpha0 expr0n (gtn_eqF (period_gt0 h_primitive)).
Qed.

Lemma root_residue p : (map_poly f p).[alpha] = 0 -> residue h p = 0.
Proof.
move=> p_root; apply/eqP; apply: contraT => /(residue_power h_primitive)[t _ /eqP].
rewrite residue_eq // => /root_multiple/eqP.
rewrite rmorphB /= map_polyXn hornerD hornerN hornerXn p_root subr0.
by rewrite (negPf (root_power_neq0 t)).
Qed.

Lemma root_power_eq t t' : (alpha ^+ t == alpha ^+ t') = (t == t' %[mod N]).
Proof.
rewrite -power_eq // residue_eq //; apply/eqP/idP => [eq_t|/root_multiple/eqP].
  rewrite -[_ - _]subr0 -residue_eq // residue0; apply/eqP/root_residue.
  by rewrite rmorphB /= !map_polyXn hornerD hornerN !hornerXn eq_t subrr.
by rewrite rmorphB /= !map_polyXn hornerD hornerN !hornerXn subr_eq0 => /eqP.
Qed.

Lemma char_card k : [char L].-nat (q ^ k)%N.
Proof.
have [p p_prime charFp] := finCharP F.
have charLp : p \in [char L] by rewrite (fmorph_char f).
rewrite pnatX (eq_pnat _ (charf_eq charLp)) -cardsT.
by rewrite [p.-nat _](primeChar_pgroup charFp).
Qed.

Lemma coefficient_fixed (x : F) k : f x ^+ (q ^ k) = f x.
Proof. by elim: k => [|k IHk]; rewrite ?expr1 // expnSr exprM IHk -rmorphX expf_card. Qed.

Variables k1 k2 n2 : nat.
Hypothesis degree_h : degree h = (k1 * k2)%N.
Local Notation Q := (q ^ k1)%N.
Local Notation n1 := (q ^ k1).-1.
Hypotheses (standard_area : (n1 * n2)%N = N) (coprime_sides : coprime n1 n2).

Lemma rows_gt0 : (0 < k1)%N.
Proof. by have := degree_gt0 h_primitive; rewrite degree_h muln_gt0 => /andP[]. Qed.

Lemma columns_gt0 : (0 < k2)%N.
Proof. by have := degree_gt0 h_primitive; rewrite degree_h muln_gt0 => /andP[]. Qed.

Let b := alpha ^+ chinese n1 n2 1 0.
Let g := alpha ^+ chinese n1 n2 0 1.

Let card_gt1 : (1 < q)%N := finRing_gt1 F.

Let powerE r c : alpha ^+ chinese n1 n2 r c = b ^+ r * g ^+ c.
Proof.
rewrite -!exprM -exprD /chinese !mul0n addn0 add0n !mul1n.
by congr (_ ^+ (_ + _)); rewrite -mulnA mulnC.
Qed.

Let alphaE : alpha = b * g.
Proof.
apply/esym/eqP; rewrite -[b]expr1 -[g]expr1 -powerE -[X in _ == X]expr1 root_power_eq.
by rewrite -standard_area chinese_remainder // chinese_modl ?chinese_modr ?eqxx.
Qed.

Let b_eq i j : b ^+ i = b ^+ j -> i = j %[mod n1].
Proof.
have bE l : b ^+ l = alpha ^+ chinese n1 n2 l 0 by rewrite powerE mulr1.
move/eqP; rewrite !bE root_power_eq -standard_area chinese_remainder // !chinese_modl //.
by case/andP => /eqP.
Qed.

Let b_fixed m : b ^+ (Q ^ m) = b.
Proof.
elim: m => [|m IHm]; rewrite ?expr1 // expnSr exprM IHm.
rewrite -[in LHS](prednK (n := Q)) ?expn_gt0 ?(ltnW card_gt1) //; rewrite exprS -exprM.
suff /eqP-> : alpha ^+ (chinese n1 n2 1 0 * n1) == alpha ^+ 0 by rewrite mulr1.
by rewrite root_power_eq -standard_area /chinese mul0n addn0 mul1n mulnAC [(n2 * n1)%N]mulnC modnMr mod0n.
Qed.

Lemma rectangle_independent (c : nat -> nat -> F) :
  \sum_(i < k1) \sum_(j < k2) f (c i j) * alpha ^+ chinese n1 n2 i j = 0 ->
  forall i j, (i < k1)%N -> (j < k2)%N -> c i j = 0.
Proof.
move=> sum0.
pose coef_b j := \poly_(i < k1) f (c i j); pose coef_g := \poly_(j < k2) (coef_b j).[b].
have g0 : coef_g = 0.
  apply: (@conjugate_roots _ Q k2 g); rewrite ?char_card ?size_poly //.
  - move=> j; rewrite coef_poly; case: ifP => _; last by rewrite expr0n expn_eq0 (gtn_eqF (ltnW card_gt1)).
    rewrite horner_poly.
    have addQ : {morph (fun x : L => x ^+ Q) : u v / u + v} by move=> u v; rewrite exprDn_char ?char_card.
    rewrite (big_morph _ addQ (expr0n _ _)) ?expn_eq0 ?(gtn_eqF (ltnW card_gt1)) //.
    apply: eq_bigr => i _; rewrite exprMn coefficient_fixed exprAC.
    by rewrite -[Q]expn1 (b_fixed 1).
  - rewrite horner_poly -[RHS]sum0 exchange_big /=; apply: eq_bigr => j _.
    by rewrite horner_poly mulr_suml; apply: eq_bigr => i _; rewrite powerE mulrA.
  move=> i j lt_i lt_j eq_g.
  have /eqP : alpha ^+ (Q ^ i) = alpha ^+ (Q ^ j) by rewrite alphaE !exprMn eq_g !b_fixed.
  rewrite root_power_eq /period degree_h expnM => /eqP; apply: power_injective => //.
  by rewrite -{1}(exp1n k1) ltn_exp2r ?rows_gt0.
move=> i j lt_i lt_j; apply/eqP; rewrite -(fmorph_eq0 f); apply/eqP.
have : (coef_b j).[b] = 0.
  by have /polyP/(_ j) := g0; rewrite coef_poly lt_j coef0.
move=> bj0; have : coef_b j = 0.
  apply: (@conjugate_roots _ q k1 b); rewrite ?size_poly //; first exact: (char_card 1).
  - move=> l; rewrite coef_poly; case: ifP => _; first exact: (coefficient_fixed _ 1).
    by rewrite expr0n (gtn_eqF (ltnW card_gt1)).
  by move=> l l' lt_l lt_l' /b_eq; apply: power_injective.
by move/polyP/(_ i); rewrite coef_poly lt_i coef0.
Qed.

End Root.
