(* Every finite field has primitive polynomials of every degree.

   Let L be a splitting field of x^N - 1 over F, N = |F|^n - 1. Its N roots are different, so one of
   them, alpha, has order N. The minimal polynomial of alpha is primitive of degree n. Hence the
   theorems about primitive polynomials are not empty, for any q and n.

   These Haskell functions rely on this file: firstPrimitive of PraTactile.Polynomial, which
   searches until it finds one, and census of PraTactile.Census. *)

From mathcomp Require Import all_ssreflect all_algebra all_field all_solvable.
From PraTactile Require Import Sequence Primitive Fold Independent Standard Extension.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(* An extension of F has an element of order N, if N is not zero in F. *)
Lemma order_exists (F : finFieldType) (N : nat) : (0 < N)%N -> N%:R != 0 :> F ->
  exists (L : fieldExtType F) (alpha : L), N.-primitive_root alpha.
Proof.
move=> N_gt0 N_neq0; have XN_neq0 : 'X^N - 1 != 0 :> {poly F}.
  by rewrite monic_neq0 // monic_Xn_sub_1.
have [L [rs def_rs _]] := FinSplittingFieldFor XN_neq0; exists L.
have map_XN : map_poly (in_alg L) ('X^N - 1) = 'X^N - 1.
  by rewrite rmorphB /= map_polyXn rmorph1.
rewrite map_XN in def_rs.
have XN_rs : 'X^N - 1 = \prod_(z <- rs) ('X - z%:P).
  by apply/eqP; rewrite -eqp_monic ?monic_Xn_sub_1 ?monic_prod_XsubC.
have uniq_rs : uniq rs.
  rewrite -separable_prod_XsubC -XN_rs separable_Xn_sub_1 //.
  by rewrite -(rmorph_nat [rmorphism of in_alg L]) fmorph_eq0.
have all_rs : all N.-unity_root rs.
  by apply/allP => z z_rs; rewrite /root_of_unity XN_rs root_prod_XsubC.
have size_rs : size rs = N.
  have := congr1 (fun p : {poly L} => size p) XN_rs.
  by rewrite size_prod_XsubC size_Xn_sub_1 // => -[].
have := has_prim_root N_gt0 all_rs uniq_rs; rewrite size_rs leqnn => /(_ isT)/hasP[alpha _ prim].
by exists alpha.
Qed.

(* There is a primitive polynomial of every degree. *)
Theorem primitive_exists (F : finFieldType) (n : nat) : (0 < n)%N ->
  exists h : {poly F}, primitive h /\ degree h = n.
Proof.
move=> n_gt0; pose N := (#|F| ^ n).-1; have q_gt1 : (1 < #|F|)%N := finRing_gt1 F.
have qn_gt1 : (1 < #|F| ^ n)%N by rewrite -{1}(exp1n n) ltn_exp2r.
have N1 : N.+1 = (#|F| ^ n)%N by rewrite prednK // ltnW.
have N_gt0 : (0 < N)%N by rewrite -ltnS N1.
have [p p_prime charFp] := finCharP F.
have N_neq0 : N%:R != 0 :> F.
  apply/eqP => N0; have := congr1 (fun m => m%:R : F) N1; rewrite -addn1 natrD N0 add0r => /eqP.
  rewrite natrX; have -> : #|F|%:R = 0 :> F.
    have : p.-nat #|F| by rewrite -cardsT; apply: (primeChar_pgroup charFp).
    case/p_natP => k def_q; rewrite def_q; case: k def_q => [|k] def_q; last first.
      by rewrite natrX (charf0 charFp) expr0n.
    by rewrite def_q in q_gt1.
  by rewrite expr0n (gtn_eqF n_gt0) oner_eq0.
have [L [alpha prim]] := order_exists N_gt0 N_neq0.
pose f := [rmorphism of in_alg L].
have /polyOver1P[h def_h] := minPolyOver 1 alpha.
have h_monic : h \is monic by rewrite -(map_monic f) -def_h monic_minPoly.
have root_h p' : (h %| p') = root (map_poly f p') alpha.
  apply/idP/idP => [/dvdpP[r ->]|root_p].
    by rewrite rmorphM rootM /= -def_h root_minPoly orbT.
  rewrite -(dvdp_map f) -def_h minPoly_dvdp //.
  by apply/polyOver1P; exists p'.
have order_h m : (h %| 'X^m - 1) = (N %| m)%N.
  rewrite root_h rmorphB /= map_polyXn rmorph1 /root hornerD hornerN hornerXn hornerC subr_eq0.
  by rewrite -(prim_order_dvd prim).
have deg_gt0 : (0 < degree h)%N.
  rewrite /degree -(size_map_poly f) -def_h size_minPoly /=.
  by rewrite adjoin_degreeE divn_gt0 ?adim_gt0 // dimvS // subv_adjoin.
have size_h := size_degree h_monic.
have deg_ge : (n <= degree h)%N.
  pose g (i : 'I_N) := residue h 'X^i.
  have g_inj : injective g.
    move=> i j /eqP; rewrite residue_eq // root_h rmorphB /= !map_polyXn /root hornerD hornerN.
    by rewrite !hornerXn subr_eq0 (eq_prim_root_expr prim) !modn_small // => /eqP/val_inj.
  have g_neq0 i : g i != 0.
    rewrite -(residue0 h) residue_eq // subr0 root_h /= map_polyXn /root hornerXn.
    apply: expf_neq0; apply/eqP => alpha0; have := prim_expr_order prim.
    by rewrite alpha0 expr0n (gtn_eqF N_gt0) => /eqP; rewrite eq_sym oner_eq0.
  have : [set g i | i : 'I_N] \subset [set~ 0].
    by apply/subsetP => _ /imsetP[i _ ->]; rewrite !inE g_neq0.
  move/subset_leq_card; rewrite card_imset // card_ord cardsC1 card_mx mul1n.
  rewrite -ltnS prednK ?expn_gt0 ?(ltnW q_gt1) // N1.
  by rewrite leq_exp2l.
have deg_le : (degree h <= n)%N.
  pose g (v : 'rV[F]_(degree h)) := (map_poly f (rVpoly v)).[alpha].
  have g_inj : injective g.
    move=> v w /eqP; rewrite /g -subr_eq0 -hornerN -hornerD -rmorphB -[_ == _]/(root _ _) -root_h.
    by rewrite -residue_eq // !residue_rVpoly // => /eqP.
  have fixed x : x \in [seq g v | v : 'rV[F]_(degree h)] -> root ('X^(#|F| ^ n) - 'X) x.
    case/imageP => v _ ->; rewrite /root hornerD hornerN hornerXn hornerX subr_eq0 /g.
    set P := map_poly f _; have addQ : {morph (fun x : L => x ^+ (#|F| ^ n)) : u v / u + v}.
      by move=> u u'; rewrite exprDn_char // (char_card f).
    rewrite !horner_coef (big_morph _ addQ (expr0n _ _)) ?(gtn_eqF (ltnW qn_gt1)) //.
    apply/eqP/eq_bigr => i _; rewrite exprMn coef_map /= (coefficient_fixed f) exprAC; congr (_ * _).
    by rewrite -[in LHS]N1 exprS (prim_expr_order prim) mulr1.
  have size_P : size ('X^(#|F| ^ n) - 'X : {poly L}) = (#|F| ^ n).+1.
    by rewrite size_addl size_polyXn // size_opp size_polyX ltnS.
  have P_neq0 : 'X^(#|F| ^ n) - 'X != 0 :> {poly L} by rewrite -size_poly_eq0 size_P.
  have := max_poly_roots P_neq0 (introT allP fixed) (_ : uniq _).
  rewrite map_inj_uniq ?enum_uniq // size_P size_map -cardE card_mx mul1n ltnS => /(_ isT).
  by rewrite leq_exp2l.
exists h; have deg_h : degree h = n by apply/eqP; rewrite eqn_leq deg_le deg_ge.
split=> //; rewrite /primitive h_monic /period deg_h n_gt0 -/N order_h dvdnn /=.
apply/forallP => m; apply/implyP => m_gt0; rewrite order_h.
by rewrite gtnNdvd.
Qed.

(* The recurrence of a primitive polynomial has nonzero solutions. *)
Theorem solution_exists (F : finFieldType) (h : {poly F}) : primitive h ->
  exists s, recurrence h s /\ nonzero s.
Proof.
move=> prim; have [L [dim_L [alpha root_alpha]]] := extension_exists prim.
pose X := vbasis {:L}.
have /existsP[i phi_i] : [exists i, coord X i 1 != 0].
  have one_sum := coord_vbasis (memvf (1 : L)); apply: contraNT (oner_neq0 L).
  rewrite negb_exists => /forallP coord0; apply/eqP; rewrite [LHS]one_sum; apply: big1 => i _.
  by move: (coord0 i); rewrite negbK => /eqP->; rewrite scale0r.
pose phi : {linear L -> F^o} := [linear of coord X i].
exists (fun t => phi (alpha ^+ t)); split; last by exists 0%N; rewrite expr0.
by apply: functional_recurrence => //; apply: primitive_monic.
Qed.

(* Standard arrays exist: if q^k1 - 1 and k2 are coprime, some array of q^k1 - 1 rows has every
   nonzero pattern of k1 rows and k2 columns at exactly one cell of the torus. *)
Theorem standard_array_exists (F : finFieldType) (k1 k2 : nat) : (0 < k1)%N -> (0 < k2)%N ->
  let n1 := (#|F| ^ k1).-1 in let n2 := ((#|F| ^ (k1 * k2)).-1 %/ n1)%N in coprime n1 k2 ->
  exists a : nat -> nat -> F, forall p : 'M[F]_(k1, k2), p != 0 ->
    exists! x : 'I_n1 * 'I_n2,
      forall (i : 'I_k1) (j : 'I_k2), torus n1 n2 a (x.1 + i) (x.2 + j) = p i j.
Proof.
move=> k1_gt0 k2_gt0 n1 n2 co; have k_gt0 : (0 < k1 * k2)%N by rewrite muln_gt0 k1_gt0.
have [h [prim deg]] := primitive_exists F k_gt0; have [s [rec s_neq0]] := solution_exists prim.
have co_h : coprime (standard_rows F k1) (standard_columns h k1).
  by rewrite (standard_coprime prim deg).
exists (fun r c => s (chinese (standard_rows F k1) (standard_columns h k1) r c)) => p p_neq0.
have n2E : standard_columns h k1 = n2 by rewrite /standard_columns /period deg.
have fold := diagonal_fold_exists co_h (_ : forall i, s (i %% (_ * _))%N = s i).
have := @standard_pattern_once _ h s k1 k2 _ prim rec s_neq0 deg co_h (fold _) p p_neq0.
rewrite n2E; apply => i; rewrite -n2E (standard_area deg); exact: term_mod.
Qed.
