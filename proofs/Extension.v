(* The sequence and the rank in terms of a field extension: s(t) = phi(alpha^t).

   Let L be an extension of F of degree n and alpha a root of h in L. For a linear map phi from L to
   F the sequence phi(alpha^t) obeys the recurrence of h. If h is primitive, every solution has this
   form, and the rank of a mask is the dimension over F of the span of the alpha^(e_i).

   These Haskell functions rely on this file: termAt of PraTactile.Sequence, whose jumps multiply
   powers of a root, and windowVectors and windowRank of PraTactile.Window.Rank. *)

From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Import Sequence Primitive Window Independent.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(* alpha is a root of h in the extension L. *)
Definition root_in (F : fieldType) (h : {poly F}) (L : fieldExtType F) (alpha : L) : bool :=
  root (map_poly (in_alg L) h) alpha.

(* The values of phi at the powers of alpha obey the recurrence of h, in the form with the minus
   sign. *)
Theorem functional_recurrence (F : fieldType) (h : {poly F}) (L : fieldExtType F) (alpha : L)
    (phi : {linear L -> F^o}) :
  h \is monic -> root_in h alpha -> recurrence h (fun t => phi (alpha ^+ t)).
Proof.
move=> h_monic /rootP; rewrite horner_coef size_map_poly size_degree // big_ord_recr /=.
rewrite coef_map /= -[h`_(degree h)]/(lead_coef h) (eqP h_monic) scale1r mul1r => root_h t.
have -> : alpha ^+ (t + degree h) = - \sum_(i < degree h) h`_i *: alpha ^+ (t + i).
  rewrite exprD; move/eqP: root_h; rewrite addrC addr_eq0 => /eqP ->.
  rewrite mulrN mulr_sumr; congr (- _); apply: eq_bigr => i _.
  by rewrite coef_map /= mulr_algl -scalerAr exprD.
by rewrite linearN linear_sum; congr (- _); apply: eq_bigr => i _; rewrite linearZ.
Qed.

Theorem extension_exists (F : finFieldType) (h : {poly F}) : primitive h ->
  exists L : fieldExtType F, \dim {:L} = degree h /\ exists alpha : L, root_in h alpha.
Proof.
move=> prim; have [L dim_L [alpha root_alpha _]] := irredp_FAdjoin (primitive_irreducible prim).
by exists L; split; last by exists alpha.
Qed.

Section Extension.

Variables (F : finFieldType) (h : {poly F}) (L : fieldExtType F) (alpha : L).
Hypotheses (h_primitive : primitive h) (dim_L : \dim {:L} = degree h).
Hypothesis alpha_root : root_in h alpha.

Local Notation n := (degree h).
Let h_monic := primitive_monic h_primitive.
Let f := [rmorphism of in_alg L].

(* The value at alpha of a polynomial over F. *)
Let value (p : {poly F}) : L := (map_poly f p).[alpha].

Let value_power t : value 'X^t = alpha ^+ t.
Proof. by rewrite /value map_polyXn hornerXn. Qed.

Let value_sum k (c : 'I_k -> F) (u : 'I_k -> nat) :
  value (\sum_i c i *: 'X^(u i)) = \sum_i c i *: alpha ^+ u i.
Proof.
rewrite /value rmorph_sum horner_sum; apply: eq_bigr => i _.
by rewrite /= map_polyZ map_polyXn hornerZ hornerXn mulr_algl.
Qed.

Let residue_sum k (c : 'I_k -> F) (u : 'I_k -> nat) :
  residue h (\sum_i c i *: 'X^(u i)) = \sum_i c i *: residue h 'X^(u i).
Proof.
rewrite (big_morph _ (residueD h) (residue0 h)); apply: eq_bigr => i _.
by rewrite residueZ.
Qed.

(* Two polynomials have the same value at alpha if and only if they are the same modulo h. *)
Lemma value_eq p p' : value p = value p' <-> residue h p = residue h p'.
Proof.
have valueB : value (p - p') = value p - value p' by rewrite /value rmorphB hornerD hornerN.
split=> [/eqP|/eqP].
  rewrite -subr_eq0 -valueB => /eqP/(root_residue h_primitive alpha_root).
  rewrite -[RHS](residue0 h) => /eqP; rewrite residue_eq // subr0 => dvd_p.
  by apply/eqP; rewrite residue_eq.
rewrite residue_eq // => /(root_multiple (f := f) alpha_root) value0.
by apply/eqP; rewrite -subr_eq0 -valueB; apply/eqP.
Qed.

(* The rank of a mask is the dimension of the span of the alpha^(e_i). *)
Theorem span_rank m (e : 'I_m -> nat) :
  \dim (span [seq alpha ^+ e i | i : 'I_m]) = mask_rank h e.
Proof.
set M := mask_matrix h e; pose u i := e (maxrankfun M i).
pose S := [tuple alpha ^+ u i | i < \rank M].
have rowE j : row j (rowsub (maxrankfun M) M) = residue h 'X^(u j) by rewrite row_rowsub rowK.
have free_S : free S.
  apply/freeP => k; rewrite (eq_bigr (fun i => k i *: alpha ^+ u i)) => [|i _]; last first.
    by rewrite (nth_map i) ?size_enum_ord // nth_ord_enum.
  have value0 : value 0 = 0 by rewrite /value rmorph0 horner0.
  rewrite -value_sum -[RHS]value0 => /value_eq sum0 i.
  have /row_free_inj inj_M : row_free (rowsub (maxrankfun M) M) by exact: maxrowsub_free.
  suff /rowP/(_ i) : \row_i k i = 0 by rewrite !mxE.
  apply: inj_M; rewrite mul0mx mulmx_sum_row -[RHS](residue0 h) -[RHS]sum0 residue_sum.
  by apply: eq_bigr => j _; rewrite rowE mxE.
suff -> : span [seq alpha ^+ e i | i : 'I_m] = span S by rewrite (eqnP free_S) size_tuple.
apply/eqP; rewrite eqEsubv; apply/andP; split; apply/span_subvP => x.
  case/imageP => i _ ->.
  have /submxP[c def_c] : (row i M <= rowsub (maxrankfun M) M)%MS.
    by rewrite eq_maxrowsub row_sub.
  have <- : \sum_(j < \rank M) c 0 j *: alpha ^+ u j = alpha ^+ e i.
    rewrite -value_sum -value_power; apply/value_eq; rewrite residue_sum.
    rewrite -[RHS](rowK (fun i => residue h 'X^(e i))) -/M def_c mulmx_sum_row.
    by apply: eq_bigr => j _; rewrite rowE.
  apply: memv_suml => j _; apply/memvZ/memv_span/mapP.
  by exists j; rewrite ?mem_enum.
by case/mapP => j _ ->; apply: memv_span; apply: image_f.
Qed.

(* T1 and T2. The mask tells t modulo q^n - 1 if and only if the alpha^(e_i) span L over F. *)
Theorem tells_iff_span (s : nat -> F) m (e : 'I_m -> nat) :
  recurrence h s -> nonzero s -> (1 < period h)%N ->
  tells s (period h) e <-> span [seq alpha ^+ e i | i : 'I_m] = fullv.
Proof.
move=> rec s_neq0 N_gt1; split=> [tells_e|span_e].
  apply/eqP; rewrite eqEdim subvf /= dim_L span_rank.
  by rewrite (tells_rank_n h_primitive rec s_neq0 N_gt1 tells_e).
by apply: rank_n_tells => //; rewrite -span_rank span_e.
Qed.

(* The first n powers of alpha are a basis of L. *)
Let powers : n.-tuple L := [tuple alpha ^+ i | i < n].

Let powersE (k : 'I_n -> F) : \sum_(i < n) k i *: powers`_i = \sum_i k i *: alpha ^+ i.
Proof. by apply: eq_bigr => i _; rewrite (nth_map i) ?size_enum_ord // nth_ord_enum. Qed.

Let powers_basis : basis_of {:L} powers.
Proof.
rewrite basisEfree subvf dim_L size_tuple leqnn !andbT; apply/freeP => k.
have value0 : value 0 = 0 by rewrite /value rmorph0 horner0.
rewrite (powersE k) -(value_sum k (fun i => i)) -[RHS]value0 => /value_eq sum0 i.
have sumE : \sum_j k j *: 'X^j = rVpoly (\row_j k j).
  rewrite [X in rVpoly X]row_sum_delta linear_sum; apply: eq_bigr => j _.
  by rewrite linearZ /= rVpoly_delta mxE.
have /rowP/(_ i) : \row_j k j = 0.
  by rewrite -[LHS](residue_rVpoly h_monic) -sumE sum0 residue0.
by rewrite !mxE.
Qed.

(* Every solution of the recurrence is phi(alpha^t) for a linear phi. *)
Theorem solution_functional (s : nat -> F) : recurrence h s ->
  exists phi : {linear L -> F^o}, forall t, s t = phi (alpha ^+ t).
Proof.
move=> rec; pose phi (x : L) : F^o := \sum_(i < n) coord powers i x * s i.
have phi_linear : linear phi.
  move=> c x y; rewrite /phi scaler_sumr -big_split; apply: eq_bigr => i _.
  rewrite /= linearP mulrDl; congr (_ + _); exact: (esym (mulrA c (coord powers i x) (s i))).
exists (Linear phi_linear) => t; rewrite (term_residue h_monic _ rec).
have rec_phi := functional_recurrence (Linear phi_linear) h_monic alpha_root.
rewrite [RHS](term_residue h_monic _ rec_phi); apply: eq_bigr => j _; congr (_ * _).
have -> : alpha ^+ j = powers`_j by rewrite (nth_map j) ?size_enum_ord // nth_ord_enum.
rewrite /= /phi (bigD1 j) //= coord_free ?(basis_free powers_basis) // eqxx mul1r big1 ?addr0 //.
move=> i ne_ij; rewrite coord_free ?(basis_free powers_basis) // eq_sym (negPf ne_ij).
by rewrite mul0r.
Qed.

(* The sequence of phi vanishes only if phi does. *)
Lemma functional_nonzero (phi : {linear L -> F^o}) :
  (exists x, phi x != 0) -> nonzero (fun t => phi (alpha ^+ t)).
Proof.
case=> x; rewrite (coord_basis powers_basis (memvf x)) linear_sum => phi_x.
have /existsP[i phi_i] : [exists i : 'I_n, phi (alpha ^+ i) != 0]; last by exists i.
apply: contraNT phi_x; rewrite negb_exists => /forallP phi0; apply/eqP/big1 => i _.
have -> : powers`_i = alpha ^+ i by rewrite (nth_map i) ?size_enum_ord // nth_ord_enum.
by rewrite linearZ /=; move: (phi0 i); rewrite negbK => /eqP->; rewrite scaler0.
Qed.

End Extension.
