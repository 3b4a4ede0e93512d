(* The windows of a sequence folded row by row, on the twisted torus.

   These are the theorems of Cells.v for a[r][c] = s(n2 r + c). The product of the sides n1 and n2
   must be q^n - 1; the sides may have a common divisor.

   These Haskell functions rely on this file: fold and naturalSurface of PraTactile.Array with
   RowMajor, and prove of PraTactile.Window.Proof. *)

From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Import Sequence Primitive Window Fold Cells.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Twisted.

Variables (F : finFieldType) (h : {poly F}) (s : nat -> F).
Hypotheses (h_primitive : primitive h) (s_rec : recurrence h s) (s_neq0 : nonzero s).
Variables (n1 n2 : nat) (a : nat -> nat -> F) (m : nat) (w : mask m).
Hypotheses (area : (n1 * n2)%N = period h) (fold : row_fold s n1 n2 a).

Local Notation cell := (twisted_torus n1 n2 a).
Let e := twisted_exponents n2 w.

Let sides_gt0 : (0 < n1)%N /\ (0 < n2)%N.
Proof. by apply/andP; rewrite -muln_gt0 area period_gt0. Qed.

Let windowE r c : window cell w r c = content s e (n2 * r + c).
Proof.
case: sides_gt0 => n1_gt0 n2_gt0; apply: twisted_window => // i.
by rewrite area (term_mod h_primitive).
Qed.

Let indexE t : (t < n1 * n2)%N ->
  (t %/ n2 < n1)%N && (t %% n2 < n2)%N /\ (n2 * (t %/ n2) + t %% n2)%N = t.
Proof.
case: sides_gt0 => n1_gt0 n2_gt0 lt_t.
by rewrite ltn_divLR // lt_t ltn_mod n2_gt0 mulnC -divn_eq.
Qed.

Let position_eq r c r' c' : (r < n1)%N -> (c < n2)%N -> (r' < n1)%N -> (c' < n2)%N ->
  (n2 * r + c = n2 * r' + c' %[mod n1 * n2])%N -> r = r' /\ c = c'.
Proof.
case: sides_gt0 => _ n2_gt0 lt_r lt_c lt_r' lt_c'.
have lt_i i j : (i < n1)%N -> (j < n2)%N -> (n2 * i + j < n1 * n2)%N.
  move=> lt_i lt_j; rewrite (@leq_trans (i.+1 * n2)) ?leq_mul2r ?lt_i ?orbT //.
  by rewrite mulSn mulnC addnC ltn_add2r.
rewrite !modn_small ?lt_i // ![(n2 * _)%N]mulnC => eq_i.
have := congr1 (divn^~ n2) eq_i; have := congr1 (modn^~ n2) eq_i.
by rewrite /= !modnMDl !divnMDl // !modn_small // !divn_small // !addn0.
Qed.

(* T1 on the twisted torus. If the mask has rank n, equal windows are at the same cell. *)
Theorem twisted_rank_n_tells r c r' c' : twisted_rank h n2 w = degree h ->
  (r < n1)%N -> (c < n2)%N -> (r' < n1)%N -> (c' < n2)%N ->
  window cell w r c = window cell w r' c' -> r = r' /\ c = c'.
Proof.
move=> full lt_r lt_c lt_r' lt_c'; rewrite !windowE => /(rank_n_tells h_primitive s_rec s_neq0 full).
by rewrite -area; apply: position_eq.
Qed.

(* T2 on the twisted torus. If equal windows are at the same cell only, the mask has rank n. *)
Theorem twisted_tells_rank_n : (1 < period h)%N ->
  (forall r c r' c', (r < n1)%N -> (c < n2)%N -> (r' < n1)%N -> (c' < n2)%N ->
     window cell w r c = window cell w r' c' -> r = r' /\ c = c') ->
  twisted_rank h n2 w = degree h.
Proof.
move=> N_gt1 tell; apply: (tells_rank_n h_primitive s_rec s_neq0 N_gt1) => t t'.
have lt_mod i : (i %% period h < n1 * n2)%N by rewrite area ltn_mod period_gt0.
rewrite -(content_mod h_primitive s_rec e t) -(content_mod h_primitive s_rec e t').
have [/andP[lt_r lt_c] eq_t] := indexE (lt_mod t).
have [/andP[lt_r' lt_c'] eq_t'] := indexE (lt_mod t').
rewrite -{1}eq_t -{1}eq_t' -!windowE => /(tell _ _ _ _ lt_r lt_c lt_r' lt_c')[eq_r eq_c].
by rewrite -eq_t -eq_t' eq_r eq_c.
Qed.

Let contents_of_cells :
  [set window cell w x.1 x.2 | x : 'I_n1 * 'I_n2] = [set content s e t | t : 'I_(period h)].
Proof.
apply/setP => v; apply/imsetP/imsetP => [[[r c] _ ->]|[t _ ->]].
  exists (Ordinal (ltn_pmod (n2 * r + c) (period_gt0 h_primitive))) => //=.
  by rewrite content_mod // windowE.
have lt_t : (t < n1 * n2)%N by rewrite area.
have [/andP[lt_r lt_c] eq_t] := indexE lt_t.
by exists (Ordinal lt_r, Ordinal lt_c); rewrite //= windowE eq_t.
Qed.

(* T3 on the twisted torus. There are q^r different windows if r < n, and q^n - 1 if r = n. *)
Theorem twisted_contents_count :
  #|[set window cell w x.1 x.2 | x : 'I_n1 * 'I_n2]| =
    if twisted_rank h n2 w == degree h then period h else (#|F| ^ twisted_rank h n2 w)%N.
Proof. by rewrite contents_of_cells (contents_count h_primitive s_rec s_neq0). Qed.

(* T3 on the twisted torus. With n cells of rank n every nonzero content is at exactly one cell. *)
Theorem twisted_pattern_once (v : 'rV[F]_m) :
  twisted_rank h n2 w = degree h -> m = degree h -> v != 0 ->
  exists! x : 'I_n1 * 'I_n2, window cell w x.1 x.2 = v.
Proof.
move=> full def_m v_neq0; have [t [[lt_t def_v] _]] :=
  nonzero_content_once h_primitive s_rec s_neq0 full def_m v_neq0.
have : v \in [set window cell w x.1 x.2 | x : 'I_n1 * 'I_n2].
  by rewrite contents_of_cells; apply/imsetP; exists (Ordinal lt_t).
case/imsetP=> x _ def_x; exists x; split=> [//|y def_y].
have [] := @twisted_rank_n_tells x.1 x.2 y.1 y.2 full; rewrite ?def_y -?def_x //.
move=> /val_inj eq1 /val_inj eq2.
by rewrite [x]surjective_pairing [y]surjective_pairing eq1 eq2.
Qed.

End Twisted.
