(* The standard fold's theorem, about the executable windows.

   Take a profile with a primitive polynomial, folded along the diagonal into the standard shape
   with coprime sides. Two windows of k1 rows and k2 columns on its torus that have the same content
   are at the same cell, and every content that is not zero occurs. The paper's profile is one of
   these.

   These Haskell functions rely on this file: prove of PraTactile.Window.Proof and windowAt of
   PraTactile.Window, which the conformance laws compare with the extracted Grid.v. *)

From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Exec Grid.
From PraTactile Require Import Sequence Primitive Fold Standard Coded Correct Stepping.
From PraTactile Require Import Agreement Arrays Instances.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma code_in_upTo (k : N) (i : nat) : (i < N.to_nat k)%N -> List.In (N.of_nat i) (Exec.upTo k).
Proof. by move=> lt_i; apply/List.in_map/List.in_seq; split; apply/leP. Qed.

Lemma in_rectangle (k1 k2 : N) (i j : nat) : (i < N.to_nat k1)%N -> (j < N.to_nat k2)%N ->
  List.In (N.of_nat i, N.of_nat j) (Grid.rectangle k1 k2).
Proof.
move=> lt_i lt_j; apply/List.in_flat_map; exists (N.of_nat i); split; first exact: code_in_upTo.
by apply: (List.in_map (fun b => (N.of_nat i, b))); apply: code_in_upTo.
Qed.

(* The rectangle's offsets, row by row. *)
Lemma rectangle_list (k1 k2 : N) : Grid.rectangle k1 k2 =
  [seq (N.of_nat (l %/ N.to_nat k2), N.of_nat (l %% N.to_nat k2))
  | l <- iota 0 (N.to_nat k1 * N.to_nat k2)].
Proof.
have seqE m k : List.seq m k = iota m k by elim: k m => //= k IHk m; rewrite IHk.
have mapE A B (f : A -> B) (l : seq A) : List.map f l = map f l by [].
rewrite /Grid.rectangle /Exec.upTo !seqE; set m2 := N.to_nat k2.
elim: (N.to_nat k1) => [|k IHk]; first by rewrite mul0n.
rewrite -[k.+1]addn1 iotaD List.map_app List.flat_map_app IHk mulnDl mul1n iotaD map_cat.
congr (_ ++ _); rewrite /= List.app_nil_r add0n -[(k * m2)%N in RHS]addn0 (iotaDl (k * m2) 0) !mapE -!map_comp.
apply/eq_in_map => l; rewrite mem_iota add0n => /andP[_ lt_l] /=.
have m2_gt0 : 0 < m2 := leq_ltn_trans (leq0n l) lt_l.
by rewrite divnMDl // modnMDl divn_small // modn_small // addn0.
Qed.

Section Standard.

Variables (P : Grid.profile) (q' : nat) (checked : is_field (Grid.field P) q') (k1 k2 : N).
Local Notation F := [finFieldType of field_of checked].
Local Notation lower := (Grid.lower P).
Local Notation state := (Grid.profileState P).
Local Notation n1 := (N.to_nat (Grid.profileRows P)).
Local Notation n2 := (N.to_nat (Grid.profileColumns P)).
Local Notation h := (characteristic (map (element checked) lower)).
Local Notation window_at := (Grid.window P Grid.Torus (Grid.folded P) (Grid.rectangle k1 k2)).

Hypothesis diagonal : Grid.profileFolding P = Grid.Diagonal.
Hypotheses (below_lower : all (@below q') lower) (below_state : all (@below q') state).
Hypotheses (n_gt0 : 0 < size lower) (size_state : size state = size lower).
Hypothesis state_neq0 : has (fun a => a != 0%num) state.
Hypothesis period_h : N.to_nat (Grid.period P) = period h.
Hypotheses (prim : primitive h) (deg : degree h = (N.to_nat k1 * N.to_nat k2)%N).
Hypotheses (rows : n1 = standard_rows F (N.to_nat k1)).
Hypotheses (columns : n2 = standard_columns h (N.to_nat k1)) (co : coprime n1 n2).

Let s := sequence (map (element checked) lower) (map (element checked) state).

Lemma executable_area : (n1 * n2)%N = N.to_nat (Grid.period P).
Proof. by rewrite rows columns period_h (standard_area deg). Qed.

Lemma executable_period_gt0 : 0 < N.to_nat (Grid.period P).
Proof. by rewrite period_h period_gt0. Qed.

Lemma executable_sides : (0 < n1) && (0 < n2).
Proof. by rewrite -muln_gt0 executable_area executable_period_gt0. Qed.

Lemma executable_recurrence : recurrence h s.
Proof. by apply: sequence_recurrence; rewrite !size_map. Qed.

Lemma executable_nonzero : nonzero s.
Proof.
case/hasP: state_neq0 => a /(nthP 0%num)[i lt_i <-] a_neq0; exists i.
have eq_size : size (map (element checked) state) = size (map (element checked) lower).
  by rewrite !size_map.
have lt_i' : i < size (map (element checked) lower) by rewrite size_map -size_state.
have -> : s i = nth 0%R (map (element checked) state) i.
  exact: esym (nth_states eq_size 0 lt_i').
rewrite (nth_map 0%num) //; apply: contraNneq a_neq0 => /(congr1 (@code _ _ checked)).
rewrite elementK; last by apply: (allP below_state); exact: mem_nth.
move=> ->; rewrite code0; case: (closed_checked checked) => _ _ zero0 _.
by apply/eqP; apply/N.eqb_spec.
Qed.

Lemma standard_fold : diagonal_fold s n1 n2 (array_of checked).
Proof.
apply: executable_fold => // t; rewrite executable_area period_h.
by apply: term_mod => //; exact: executable_recurrence.
Qed.

Lemma window_list (r c : N) : window_at (r, c) = Some [seq code (torus n1 n2 (array_of checked)
  (N.to_nat r + N.to_nat x.1) (N.to_nat c + N.to_nat x.2)) | x <- Grid.rectangle k1 k2].
Proof.
exact: (executable_window checked diagonal below_lower below_state n_gt0 size_state
  executable_area co executable_period_gt0).
Qed.

(* Equal executable windows on the torus are at the same cell. *)
Theorem executable_standard_unique r c r' c' : window_at (r, c) = window_at (r', c') ->
  N.modulo r (Grid.profileRows P) = N.modulo r' (Grid.profileRows P)
  /\ N.modulo c (Grid.profileColumns P) = N.modulo c' (Grid.profileColumns P).
Proof.
rewrite !window_list; case=> /List.map_ext_in_iff eq_cells.
have [] := @standard_window_unique _ h s (N.to_nat k1) (N.to_nat k2) (array_of checked)
    prim executable_recurrence executable_nonzero deg _ _
    (N.to_nat r) (N.to_nat c) (N.to_nat r') (N.to_nat c').
- by rewrite -rows -columns.
- by rewrite -rows -columns; exact: standard_fold.
- move=> i j lt_i lt_j; have := eq_cells _ (in_rectangle lt_i lt_j).
  by rewrite /= !Nnat.Nat2N.id -rows -columns => /(@code_inj _ _ checked).
case/andP: executable_sides => n1_gt0 n2_gt0; rewrite -rows -columns => eq_r eq_c.
by split; apply: Nnat.N2Nat.inj; rewrite !to_nat_mod.
Qed.

(* Every content of codes below q that are not all zero is at some cell of the torus. *)
Theorem executable_standard_occurs (w : seq N) :
  size w = (N.to_nat k1 * N.to_nat k2)%N -> all (@below q') w -> has (fun a => a != 0%num) w ->
  exists r c, [/\ N.to_nat r < n1, N.to_nat c < n2 & window_at (r, c) = Some w].
Proof.
move=> size_w below_w w_neq0.
pose p : 'M[F]_(N.to_nat k1, N.to_nat k2) :=
  (\matrix_(i, j) element checked (nth 0%num w (i * N.to_nat k2 + j)))%R.
have p_neq0 : (p != 0)%R.
  case/hasP: w_neq0 => a /(nthP 0%num)[l lt_l <-] a_neq0; rewrite size_w in lt_l.
  pose l' := Ordinal lt_l; apply: contraNneq a_neq0 => p0.
  have := congr1 (fun m : 'M[F]_(_, _) =>
    m (Ordinal (rectangle_row l')) (Ordinal (rectangle_column l'))) p0.
  rewrite !mxE /= -divn_eq => /(congr1 (@code _ _ checked)).
  rewrite elementK; last by apply: (allP below_w); rewrite mem_nth // size_w.
  move=> ->; rewrite code0; case: (closed_checked checked) => _ _ zero0 _.
  by apply/eqP; apply/N.eqb_spec.
have := @standard_pattern_once _ h s (N.to_nat k1) (N.to_nat k2) (array_of checked)
    prim executable_recurrence executable_nonzero deg.
rewrite -rows -columns => /(_ co standard_fold p p_neq0)[x [cells _]].
exists (N.of_nat x.1), (N.of_nat x.2); rewrite window_list !Nnat.Nat2N.id !ltn_ord; split=> //.
congr Some; rewrite rectangle_list -map_comp -[RHS](mkseq_nth 0%num) size_w.
apply/eq_in_map => l; rewrite mem_iota add0n => /andP[_ lt_l] /=; rewrite !Nnat.Nat2N.id.
pose l' := Ordinal lt_l.
have := cells (Ordinal (rectangle_row l')) (Ordinal (rectangle_column l')).
rewrite mxE /= -divn_eq => ->; rewrite elementK //.
by apply: (allP below_w); rewrite mem_nth // size_w.
Qed.

End Standard.

(* The paper's array: q = 4, x^4 + x^2 + A x + A^2, 15 rows and 17 columns along the diagonal. *)
Definition paper_profile : Grid.profile :=
  Grid.Profile 4 [:: 1; 1; 1]%num [:: 3; 2; 1; 0; 1]%num Grid.Characteristic [:: 0; 0; 0; 1]%num
    15 17 Grid.Diagonal Grid.Torus.

(* Equal executable windows of two rows and two columns of the paper's array are at the same
   cell. *)
Theorem paper_executable_unique r c r' c' :
  let at_ := Grid.window paper_profile Grid.Torus (Grid.folded paper_profile)
    (Grid.rectangle 2 2) in
  at_ (r, c) = at_ (r', c') ->
  N.modulo r 15 = N.modulo r' 15 /\ N.modulo c 17 = N.modulo c' 17.
Proof.
apply: (@executable_standard_unique paper_profile 3 gf4_is_field 2 2) => //.
- exact: esym paper_period.
- exact: paper_primitive.
- exact: characteristic_degree.
- exact: esym paper_rows.
exact: esym paper_columns.
Qed.

(* Every content of four codes below 4 that are not all zero is at some cell of the paper's
   array. *)
Theorem paper_executable_occurs (w : seq N) :
  size w = 4 -> all (@below 3) w -> has (fun a => a != 0%num) w ->
  exists r c, [/\ N.to_nat r < 15, N.to_nat c < 17 & Grid.window paper_profile Grid.Torus
    (Grid.folded paper_profile) (Grid.rectangle 2 2) (r, c) = Some w].
Proof.
apply: (@executable_standard_occurs paper_profile 3 gf4_is_field 2 2) => //.
- exact: esym paper_period.
- exact: paper_primitive.
- exact: characteristic_degree.
- exact: esym paper_rows.
exact: esym paper_columns.
Qed.
