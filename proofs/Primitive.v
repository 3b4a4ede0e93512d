(* The residues modulo a primitive polynomial h, and the period of its sequences.

   Every nonzero residue modulo h is one power x^t, and t is unique modulo N = |F|^n - 1. Hence h is
   irreducible, a nonzero solution of the recurrence has least period N, and all nonzero solutions
   are shifts of one another.

   These Haskell functions rely on this file: checkPrimitive and period of
   PraTactile.Polynomial, termAt and stateAt of PraTactile.Sequence, and windowRank of
   PraTactile.Window.Rank. *)

From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Import Sequence.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Primitive.

Variables (F : finFieldType) (h : {poly F}).
Hypothesis h_primitive : primitive h.
Implicit Types (s : nat -> F) (p q : {poly F}).

Local Notation n := (degree h).
Local Notation N := (period h).

Lemma primitive_monic : h \is monic. Proof. by case/and4P: h_primitive. Qed.
Lemma degree_gt0 : (0 < n)%N. Proof. by case/and4P: h_primitive. Qed.
Let monic_h := primitive_monic.

Lemma period_gt0 : (0 < N)%N.
Proof.
have q_gt1 : (1 < #|F|)%N := finRing_gt1 F.
by rewrite /period -ltnS prednK ?expn_gt0 ?(ltnW q_gt1) // -{1}(exp1n n) ltn_exp2r ?degree_gt0.
Qed.

Lemma card_residues : (#|F| ^ n = N.+1)%N.
Proof. by rewrite /period prednK // expn_gt0 (ltnW (finRing_gt1 F)). Qed.

Lemma power_period : h %| 'X^N - 1. Proof. by case/and4P: h_primitive. Qed.

Lemma power_order m : (h %| 'X^m - 1) = (N %| m)%N.
Proof.
have dvdN k : h %| 'X^(k * N) - 1.
  elim: k => [|k IHk]; first by rewrite mul0n expr0 subrr dvdp0.
  have -> : 'X^(k.+1 * N) - 1 = 'X^N * ('X^(k * N) - 1) + ('X^N - 1) :> {poly F}.
    by rewrite mulSn exprD mulrBr mulr1 [RHS]addrA subrK.
  by rewrite dvdp_add ?power_period ?dvdp_mull.
apply/idP/idP => [|/dvdnP[k ->] //]; rewrite {1}(divn_eq m N) exprD.
set k := (m %/ N)%N; set r := (m %% N)%N => dvd_m.
have r_lt : (r < N)%N by rewrite ltn_mod period_gt0.
have dvd_r : h %| 'X^r - 1.
  have -> : 'X^r - 1 = 'X^(k * N) * 'X^r - 1 - ('X^(k * N) - 1) * 'X^r :> {poly F}.
    by rewrite mulrBl mul1r opprB [RHS]addrC addrA subrK.
  by rewrite dvdp_sub ?dvdp_mulr.
case/and4P: h_primitive => _ _ _ /forallP/(_ (Ordinal r_lt)) /=.
by rewrite dvd_r implybF -eqn0Ngt.
Qed.

Lemma coprime_power t : coprimep h 'X^t.
Proof.
apply: coprimep_expr; rewrite (coprimep_dvdr power_period) // coprimepX.
by rewrite /root !hornerE hornerXn expr0n (gtn_eqF period_gt0) sub0r oppr_eq0 oner_eq0.
Qed.

Lemma power_eq t t' : (residue h 'X^t == residue h 'X^t') = (t == t' %[mod N]).
Proof.
rewrite residue_eq //; wlog le_t : t t' / (t' <= t)%N => [wlog_t|].
  have [/wlog_t//|/ltnW/wlog_t] := leqP t' t.
  by rewrite -dvdpNr opprB => ->; rewrite eq_sym.
have -> : 'X^t - 'X^t' = 'X^t' * ('X^(t - t') - 1) :> {poly F}.
  by rewrite mulrBr mulr1 -exprD subnKC.
by rewrite Gauss_dvdpr ?coprime_power // power_order eqn_mod_dvd.
Qed.

Lemma power_neq0 t : residue h 'X^t != 0.
Proof.
rewrite -(residue0 h) residue_eq // subr0; apply/negP => dvd_h.
have : coprimep h h by rewrite (coprimep_dvdl dvd_h) ?coprime_power.
by rewrite coprimepp size_degree // eqSS (gtn_eqF degree_gt0).
Qed.

(* Every nonzero residue is a power of x. *)
Theorem residue_power (v : 'rV[F]_n) : v != 0 -> exists2 t, (t < N)%N & residue h 'X^t = v.
Proof.
move=> v_neq0; pose f (i : 'I_N) := residue h 'X^i.
have f_inj : injective f.
  move=> i j /eqP; rewrite power_eq !modn_small ?ltn_ord // => /eqP; exact: val_inj.
have im_f : [set f i | i : 'I_N] = [set~ 0].
  apply/eqP; rewrite eqEcard cardsC1 card_imset // card_ord card_mx mul1n card_residues leqnn andbT.
  by apply/subsetP => _ /imsetP[i _ ->]; rewrite !inE power_neq0.
have : v \in [set~ 0] by rewrite !inE.
by rewrite -im_f => /imsetP[i _ ->]; exists i.
Qed.

(* A primitive polynomial is irreducible. *)
Theorem primitive_irreducible : irreducible_poly h.
Proof.
split=> [|p size_p dvd_p]; first by rewrite size_degree // ltnS degree_gt0.
have h_neq0 := monic_neq0 monic_h.
have [lt_p|] := ltnP (size p) (size h); last first.
  move=> le_p; rewrite -(dvdp_size_eqp dvd_p) eqn_leq le_p andbT; exact: dvdp_leq.
have p_neq0 : p != 0 by apply: contraTneq dvd_p => ->; rewrite dvd0p.
have : residue h p != 0.
  by rewrite -(residue0 h) residue_eq // subr0; apply: contraL lt_p => /dvdp_leq; rewrite -leqNgt => ->.
case/residue_power=> t _ /eqP; rewrite residue_eq // => dvd_t.
have : p %| 'X^t by rewrite -(subrK p 'X^t) dvdp_add // (dvdp_trans dvd_p).
move=> p_dvd; have : coprimep p p by rewrite (coprimep_dvdl p_dvd) ?(coprimep_dvdr dvd_p) ?coprime_power.
by rewrite coprimepp => size1; rewrite size1 in size_p.
Qed.

Section Solution.

Variable s : nat -> F.
Hypotheses (s_rec : recurrence h s) (s_neq0 : nonzero s).

Lemma term_mod t : s (t %% N)%N = s t.
Proof.
rewrite (term_residue monic_h _ s_rec) [RHS](term_residue monic_h _ s_rec).
suff /eqP-> : residue h 'X^(t %% N) == residue h 'X^t by [].
by rewrite power_eq modn_mod.
Qed.

(* No nonzero combination of n consecutive terms vanishes everywhere. *)
Lemma hankel_unit : hankel n s \in unitmx.
Proof.
rewrite -row_free_unit -kermx_eq0; apply/rowV0P => v /sub_kermxP vG0.
apply/eqP; apply: contraT => /residue_power[t _ def_v].
case: s_neq0 => m /negP[]; apply/eqP.
have term0 e : s (t + e)%N = 0 by rewrite (hankel_term monic_h _ _ s_rec) def_v vG0 mul0mx mxE.
have <- : s (t + (t * N.-1 + m))%N = s m; last exact: term0.
by rewrite -[LHS]term_mod addnA -mulnS prednK ?period_gt0 // modnMDl term_mod.
Qed.

End Solution.

(* A nonzero solution has least period |F|^n - 1. *)
Theorem least_period s m : recurrence h s -> nonzero s ->
  ((forall t, s (t + m)%N = s t) <-> (N %| m)%N).
Proof.
move=> s_rec s_neq0; split=> [per_m|/dvdnP[k ->] t]; last first.
  by rewrite -term_mod // addnC modnMDl term_mod.
have := hankel_unit s_rec s_neq0; rewrite -row_free_unit => /row_free_inj inj_G.
rewrite -power_order -(expr0 'X) -residue_eq //; apply/eqP/inj_G.
have row_term t : residue h 'X^t *m hankel n s = \row_j s (t + j)%N.
  apply/rowP => j; rewrite mxE [RHS]mxE [RHS](term_residue monic_h _ (shifted_recurrence j s_rec)).
  by apply: eq_bigr => i _; rewrite [hankel n s _ _]mxE.
by rewrite !row_term; apply/rowP => j; rewrite !mxE add0n addnC per_m.
Qed.

(* Any two nonzero solutions are shifts of one another. *)
Theorem solutions_shift s s' : recurrence h s -> nonzero s -> recurrence h s' -> nonzero s' ->
  exists2 d, (d < N)%N & forall t, s' t = s (d + t)%N.
Proof.
move=> s_rec s_neq0 s'_rec [m s'm].
have unit_G := hankel_unit s_rec s_neq0.
pose v := (\row_j s' j) *m invmx (hankel n s).
have s'E t : s' t = (v *m hankel n s *m (residue h 'X^t)^T) 0 0.
  rewrite mulmxKV // mxE (term_residue monic_h _ s'_rec).
  by apply: eq_bigr => j _; rewrite !mxE mulrC.
have : v != 0 by apply: contraNneq s'm => v0; rewrite s'E v0 !mul0mx mxE.
by case/residue_power=> d lt_d def_v; exists d => // t; rewrite s'E -def_v -hankel_term.
Qed.

End Primitive.
