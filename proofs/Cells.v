(* What a window of an array tells of its position, for any mask of cells.

   The theorems of Window.v, in terms of the array's cells: a window's content determines its row
   and column if and only if the mask has rank n, and the rank says how many different contents
   there are. They hold on the torus for the diagonal fold with coprime sides, and on the twisted
   torus for the row-by-row fold with any sides.

   These Haskell functions rely on this file: prove of PraTactile.Window.Proof, windowRank and
   windowsOfRank of PraTactile.Window.Rank, and windowAt of PraTactile.Window. *)

From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Import Sequence Primitive Window Fold.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(* A mask is a list of offsets (rows down, columns to the right) from the window's position. *)
Definition mask (m : nat) := 'I_m -> nat * nat.

(* The content of a window on a surface, given the surface's cell at each row and column. *)
Definition window (T : Type) (m : nat) (cell : nat -> nat -> T) (w : mask m) (r c : nat) :
  'rV[T]_m :=
  \row_i cell (r + (w i).1)%N (c + (w i).2)%N.

(* For each cell of the mask, the number of terms from the window's first term to the cell's. *)
Definition torus_exponents (n1 n2 m : nat) (w : mask m) (i : 'I_m) : nat :=
  chinese n1 n2 (w i).1 (w i).2.

Definition twisted_exponents (n2 m : nat) (w : mask m) (i : 'I_m) : nat :=
  (n2 * (w i).1 + (w i).2)%N.

Definition torus_rank (F : fieldType) (h : {poly F}) (n1 n2 m : nat) (w : mask m) : nat :=
  mask_rank h (torus_exponents n1 n2 w).

Definition twisted_rank (F : fieldType) (h : {poly F}) (n2 m : nat) (w : mask m) : nat :=
  mask_rank h (twisted_exponents n2 w).

Lemma torus_window (T : ringType) (s : nat -> T) n1 n2 a m (w : mask m) r c :
  coprime n1 n2 -> diagonal_fold s n1 n2 a ->
  window (torus n1 n2 a) w r c = content s (torus_exponents n1 n2 w) (chinese n1 n2 r c).
Proof. by move=> co_n fold; apply/rowP => i; rewrite !mxE (torus_term _ _ co_n fold) chineseD. Qed.

Lemma twisted_window (T : ringType) (s : nat -> T) n1 n2 a m (w : mask m) r c :
  (0 < n1)%N -> (0 < n2)%N -> (forall i, s (i %% (n1 * n2))%N = s i) -> row_fold s n1 n2 a ->
  window (twisted_torus n1 n2 a) w r c = content s (twisted_exponents n2 w) (n2 * r + c).
Proof.
move=> n1_gt0 n2_gt0 s_per fold; apply/rowP => i.
by rewrite !mxE (twisted_term _ _ _ _ s_per fold) // mulnDr addnACA.
Qed.

Lemma chinese_eq n1 n2 r c r' c' : coprime n1 n2 ->
  (chinese n1 n2 r c == chinese n1 n2 r' c' %[mod n1 * n2])
    = (r == r' %[mod n1]) && (c == c' %[mod n2]).
Proof. by move=> co_n; rewrite chinese_remainder // !chinese_modl ?chinese_modr. Qed.

Section Torus.

Variables (F : finFieldType) (h : {poly F}) (s : nat -> F).
Hypotheses (h_primitive : primitive h) (s_rec : recurrence h s) (s_neq0 : nonzero s).
Variables (n1 n2 : nat) (a : nat -> nat -> F) (m : nat) (w : mask m).
Hypotheses (area : (n1 * n2)%N = period h) (coprime_sides : coprime n1 n2).
Hypothesis fold : diagonal_fold s n1 n2 a.

Local Notation cell := (torus n1 n2 a).
Let e := torus_exponents n1 n2 w.
Let windowE r c : window cell w r c = content s e (chinese n1 n2 r c).
Proof. exact: torus_window. Qed.

Let contentE t : window cell w (t %% n1) (t %% n2) = content s e t.
Proof. by rewrite windowE -[LHS](content_mod h_primitive) // -area -chinese_mod // area content_mod. Qed.

Let sides_gt0 : (0 < n1)%N && (0 < n2)%N.
Proof. by rewrite -muln_gt0 area period_gt0. Qed.

(* T1 on the torus. If the mask has rank n, equal windows are at the same cell. *)
Theorem torus_rank_n_tells r c r' c' : torus_rank h n1 n2 w = degree h ->
  window cell w r c = window cell w r' c' -> r = r' %[mod n1] /\ c = c' %[mod n2].
Proof.
move=> full; rewrite !windowE => /(rank_n_tells h_primitive s_rec s_neq0 full)/eqP.
by rewrite -area chinese_eq // => /andP[/eqP-> /eqP->].
Qed.

(* T2 on the torus. If equal windows are at the same cell only, the mask has rank n. *)
Theorem torus_tells_rank_n : (1 < period h)%N ->
  (forall r c r' c', window cell w r c = window cell w r' c' ->
     r = r' %[mod n1] /\ c = c' %[mod n2]) -> torus_rank h n1 n2 w = degree h.
Proof.
move=> N_gt1 tell; apply: (tells_rank_n h_primitive s_rec s_neq0 N_gt1) => t t'.
rewrite -!contentE => /tell[]; rewrite !modn_mod => eq_r eq_c.
apply/eqP; rewrite -area chinese_remainder //.
by rewrite eq_r eq_c !eqxx.
Qed.

Lemma torus_contents :
  [set window cell w x.1 x.2 | x : 'I_n1 * 'I_n2] = [set content s e t | t : 'I_(period h)].
Proof.
apply/setP => v; apply/imsetP/imsetP => [[[r c] _ ->]|[t _ ->]].
  exists (Ordinal (ltn_pmod (chinese n1 n2 r c) (period_gt0 h_primitive))) => //=.
  by rewrite content_mod // windowE.
case/andP: sides_gt0 => n1_gt0 n2_gt0.
by exists (Ordinal (ltn_pmod t n1_gt0), Ordinal (ltn_pmod t n2_gt0)); rewrite //= contentE.
Qed.

(* T3 on the torus. The windows of a mask of rank r, with the window of zeros, have q^r contents. *)
Theorem torus_contents_with_zero :
  #|0 |: [set window cell w x.1 x.2 | x : 'I_n1 * 'I_n2]| = (#|F| ^ torus_rank h n1 n2 w)%N.
Proof. by rewrite torus_contents (contents_with_zero h_primitive s_rec s_neq0). Qed.

(* T3 on the torus. There are q^r different windows if r < n, and q^n - 1 if r = n. *)
Theorem torus_contents_count :
  #|[set window cell w x.1 x.2 | x : 'I_n1 * 'I_n2]| =
    if torus_rank h n1 n2 w == degree h then period h else (#|F| ^ torus_rank h n1 n2 w)%N.
Proof. by rewrite torus_contents (contents_count h_primitive s_rec s_neq0). Qed.

(* With rank n no window is zero. *)
Theorem torus_rank_n_neq0 r c : torus_rank h n1 n2 w = degree h -> window cell w r c != 0.
Proof. by rewrite windowE; apply: rank_n_neq0. Qed.

(* T3 on the torus. With n cells of rank n every nonzero content is at exactly one cell. *)
Theorem torus_pattern_once (v : 'rV[F]_m) :
  torus_rank h n1 n2 w = degree h -> m = degree h -> v != 0 ->
  exists! x : 'I_n1 * 'I_n2, window cell w x.1 x.2 = v.
Proof.
move=> full def_m v_neq0; have [t [[lt_t def_v] _]] :=
  nonzero_content_once h_primitive s_rec s_neq0 full def_m v_neq0.
have : v \in [set window cell w x.1 x.2 | x : 'I_n1 * 'I_n2].
  by rewrite torus_contents; apply/imsetP; exists (Ordinal lt_t).
case/imsetP=> x _ def_x; exists x; split=> [//|y def_y].
have := @torus_rank_n_tells x.1 x.2 y.1 y.2 full; rewrite def_y -def_x => /(_ erefl)[].
rewrite !modn_small // => /val_inj eq1 /val_inj eq2.
by rewrite [x]surjective_pairing [y]surjective_pairing eq1 eq2.
Qed.

End Torus.
