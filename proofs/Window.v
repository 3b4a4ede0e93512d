(* Whether a mask of cells determines its place in the sequence: the rank of the mask.

   The cells of a mask lie e_0, e_1, ... terms after the first: its content at t is
   s(t + e_0), s(t + e_1), ... This content is a linear function of x^t modulo h. Its rank is the
   rank of the x^(e_i) modulo h, and it decides whether the content tells t, and how many different
   contents there are.

   These Haskell functions rely on this file: windowRank and windowsOfRank of
   PraTactile.Window.Rank, and prove of PraTactile.Window.Proof. *)

From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Import Sequence Primitive.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(* The content at t of a mask with the exponents e. *)
Definition content (F : ringType) (s : nat -> F) (m : nat) (e : 'I_m -> nat) (t : nat) :
  'rV[F]_m :=
  \row_i s (t + e i)%N.

(* The matrix whose rows are the cells' powers of x modulo h. *)
Definition mask_matrix (F : fieldType) (h : {poly F}) (m : nat) (e : 'I_m -> nat) :
  'M[F]_(m, degree h) := \matrix_(i < m) residue h 'X^(e i).

Definition mask_rank (F : fieldType) (h : {poly F}) (m : nat) (e : 'I_m -> nat) : nat :=
  \rank (mask_matrix h e).

(* Equal contents are at equal places only, modulo the period. *)
Definition tells (F : ringType) (s : nat -> F) (N m : nat) (e : 'I_m -> nat) : Prop :=
  forall t t', content s e t = content s e t' -> t = t' %[mod N].

Lemma card_row_image (F : finFieldType) (n m : nat) (A : 'M[F]_(n, m)) :
  #|[set v *m A | v : 'rV_n]| = (#|F| ^ \rank A)%N.
Proof.
have -> : [set v *m A | v : 'rV_n] = [set w *m row_base A | w : 'rV_(\rank A)].
  apply/setP => u; apply/imsetP/imsetP => [][v _ ->].
    have /submxP[w ->] : (v *m A <= row_base A)%MS by rewrite eq_row_base submxMl.
    by exists w.
  have /submxP[w ->] : (v *m row_base A <= A)%MS by rewrite (submx_trans (submxMl _ _)) ?eq_row_base.
  by exists w.
by rewrite card_imset ?card_mx ?mul1n //; apply: row_free_inj; exact: row_base_free.
Qed.

Section Mask.

Variables (F : finFieldType) (h : {poly F}) (s : nat -> F).
Hypotheses (h_primitive : primitive h) (s_rec : recurrence h s) (s_neq0 : nonzero s).
Variables (m : nat) (e : 'I_m -> nat).

Local Notation n := (degree h).
Local Notation N := (period h).
Let h_monic := primitive_monic h_primitive.
Let A := hankel n s *m (mask_matrix h e)^T.

(* A content is a linear function of the residue of x^t. *)
Lemma content_linear t : content s e t = residue h 'X^t *m A.
Proof.
apply/rowP => i; rewrite mxE (hankel_term h_monic _ _ s_rec) mulmxA !mxE.
by apply: eq_bigr => j _; rewrite !mxE.
Qed.

Lemma content_rank : \rank A = mask_rank h e.
Proof.
rewrite /A (eqmxMfull _ _) ?mxrank_tr //.
by rewrite row_full_unit (hankel_unit h_primitive).
Qed.

Lemma rank_le : (mask_rank h e <= n)%N.
Proof. exact: rank_leq_col. Qed.

Lemma content_free : row_free A = (mask_rank h e == n).
Proof. by rewrite /row_free content_rank. Qed.

Lemma content_mod t : content s e (t %% N) = content s e t.
Proof.
rewrite !content_linear; suff /eqP-> : residue h 'X^(t %% N) == residue h 'X^t by [].
by rewrite power_eq // modn_mod.
Qed.

(* T1. If the mask has rank n, equal contents are at equal places, modulo the period. *)
Theorem rank_n_tells : mask_rank h e = n -> tells s N e.
Proof.
move=> full t t'; rewrite !content_linear; have /row_free_inj inj_A : row_free A.
  by rewrite content_free full.
by move/inj_A/eqP; rewrite power_eq // => /eqP.
Qed.

(* Below rank n the content is zero at some place. *)
Lemma deficient_zero : (mask_rank h e < n)%N -> exists2 t, (t < N)%N & content s e t = 0.
Proof.
move=> lt_r; have /rowV0Pn[v /sub_kermxP vA0] : kermx A != 0.
  by rewrite kermx_eq0 content_free (ltn_eqF lt_r).
case/(residue_power h_primitive) => t lt_t def_v.
by exists t; rewrite // content_linear def_v.
Qed.

(* T2. If equal contents are at equal places only, and the period exceeds 1, the mask has rank
   n. *)
Theorem tells_rank_n : (1 < N)%N -> tells s N e -> mask_rank h e = n.
Proof.
move=> N_gt1 tells_e; apply/eqP; rewrite eqn_leq rank_le leqNgt; apply/negP => lt_r.
have [t _ zero_t] := deficient_zero lt_r; set u := residue h 'X^t.
have u_neq0 : u != 0 := power_neq0 h_primitive t.
have /existsP[w /andP[w_neq0 w_neq]] : [exists w : 'rV[F]_n, (w != 0) && (w != - u)].
  apply: contraLR N_gt1; rewrite negb_exists -leqNgt -ltnS -(card_residues h).
  move/forallP => all_w; suff : [set: 'rV[F]_n] \subset [set 0; - u].
    by move/subset_leq_card; rewrite cardsT cards2 card_mx mul1n => /leq_trans->; case: (0 != - u).
  by apply/subsetP => w _; have := all_w w; rewrite !inE negb_and !negbK.
have [i _ def_i] := residue_power h_primitive w_neq0.
have wu_neq0 : w + u != 0 by rewrite addr_eq0.
have [j _ def_j] := residue_power h_primitive wu_neq0.
have /tells_e/eqP : content s e j = content s e i.
  by rewrite !content_linear def_i def_j mulmxDl -content_linear zero_t addr0.
rewrite -power_eq // def_i def_j -subr_eq0 addrC addKr => /eqP u0.
by rewrite u0 eqxx in u_neq0.
Qed.

Lemma contents_image :
  0 |: [set content s e t | t : 'I_N] = [set v *m A | v : 'rV[F]_n].
Proof.
apply/setP => v; rewrite !inE; apply/orP/imsetP => [[/eqP->|/imsetP[t _ ->]]|[w _ ->]].
- by exists 0; rewrite ?mul0mx.
- by exists (residue h 'X^t); rewrite ?content_linear.
have [->|/(residue_power h_primitive)[t lt_t <-]] := eqVneq w 0; first by rewrite mul0mx; left.
by right; apply/imsetP; exists (Ordinal lt_t); rewrite ?content_linear.
Qed.

(* With rank n no content is zero. *)
Theorem rank_n_neq0 t : mask_rank h e = n -> content s e t != 0.
Proof.
move=> full; have /row_free_inj inj_A : row_free A by rewrite content_free full.
rewrite content_linear -(mul0mx 1 A); apply/eqP => /inj_A/eqP.
by rewrite (negPf (power_neq0 h_primitive t)).
Qed.

(* T3. With rank r there are q^r different contents, the content of zeros included. *)
Theorem contents_with_zero :
  #|0 |: [set content s e t | t : 'I_N]| = (#|F| ^ mask_rank h e)%N.
Proof. by rewrite contents_image card_row_image content_rank. Qed.

(* T3. There are q^r different contents if r < n, and q^n - 1 if r = n. *)
Theorem contents_count : #|[set content s e t | t : 'I_N]| =
  if mask_rank h e == n then N else (#|F| ^ mask_rank h e)%N.
Proof.
rewrite -contents_with_zero cardsU1; case: eqP => [full|/eqP ne_r].
  rewrite card_imset ?card_ord // => i j /(rank_n_tells full)/eqP.
  by rewrite !modn_small // => /eqP/val_inj.
have [|t lt_t zero_t] := deficient_zero; first by rewrite ltn_neqAle ne_r rank_le.
suff -> : 0 \in [set content s e t | t : 'I_N] by [].
by apply/imsetP; exists (Ordinal lt_t).
Qed.

(* T3. With n cells of rank n every nonzero content is at one place below the period. *)
Theorem nonzero_content_once (v : 'rV[F]_m) : mask_rank h e = n -> m = n -> v != 0 ->
  exists! t, (t < N)%N /\ content s e t = v.
Proof.
move=> full def_m v_neq0; have : v \in 0 |: [set content s e t | t : 'I_N].
  rewrite contents_image; have /submxP[w ->] : (v <= A)%MS; last by apply/imsetP; exists w.
  by apply: submx_full; rewrite /row_full content_rank full def_m.
rewrite !inE (negPf v_neq0) => /imsetP[t _ def_v]; exists (t : nat); split=> [//|t' [lt_t' def_t']].
by have := @rank_n_tells full t t'; rewrite def_t' -def_v !modn_small //; apply.
Qed.

(* The difference of two contents is zero or again a content. *)
Lemma content_sub t t' :
  content s e t - content s e t' \in 0 |: [set content s e t | t : 'I_N].
Proof.
rewrite contents_image; apply/imsetP; exists (residue h 'X^t - residue h 'X^t') => //.
by rewrite mulmxBl !content_linear.
Qed.

End Mask.
