(* The standard fold's theorem, about the executable windows.

   For a profile with a primitive polynomial, folded along the diagonal into the standard shape with
   coprime sides, two windows of k1 rows and k2 columns on the torus with the same content are at the
   same cell. The paper's profile is one of these.

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

Lemma in_upTo (k : N) (i : nat) : (i < N.to_nat k)%N -> List.In (N.of_nat i) (Exec.upTo k).
Proof. by move=> lt_i; apply/List.in_map/List.in_seq; split; apply/leP. Qed.

Lemma in_rectangle (k1 k2 : N) (i j : nat) : (i < N.to_nat k1)%N -> (j < N.to_nat k2)%N ->
  List.In (N.of_nat i, N.of_nat j) (Grid.rectangle k1 k2).
Proof.
move=> lt_i lt_j; apply/List.in_flat_map; exists (N.of_nat i); split; first exact: in_upTo.
by apply: (List.in_map (fun b => (N.of_nat i, b))); apply: in_upTo.
Qed.

(* Equal executable windows on the torus are at the same cell. *)
Theorem executable_standard_unique (P : Grid.profile) (q' : nat)
    (checked : is_field (Grid.field P) q') (k1 k2 : N) :
  let lower := Grid.lower P in let state := Grid.profileState P in
  let n1 := N.to_nat (Grid.profileRows P) in let n2 := N.to_nat (Grid.profileColumns P) in
  let h := characteristic (map (element checked) lower) in
  Grid.profileFolding P = Grid.Diagonal ->
  all (@below q') lower -> all (@below q') state -> (0 < size lower)%N ->
  size state = size lower -> N.to_nat (Grid.period P) = period h ->
  has (fun a => a != 0%num) state ->
  primitive h -> degree h = (N.to_nat k1 * N.to_nat k2)%N ->
  n1 = standard_rows [finFieldType of field_of checked] (N.to_nat k1) ->
  n2 = standard_columns h (N.to_nat k1) -> coprime n1 n2 ->
  forall r c r' c',
    Grid.window P Grid.Torus (Grid.folded P) (Grid.rectangle k1 k2) (r, c)
      = Grid.window P Grid.Torus (Grid.folded P) (Grid.rectangle k1 k2) (r', c') ->
    N.modulo r (Grid.profileRows P) = N.modulo r' (Grid.profileRows P)
    /\ N.modulo c (Grid.profileColumns P) = N.modulo c' (Grid.profileColumns P).
Proof.
move=> lower state n1 n2 h diagonal below_l below_s n_gt0 eq_size per state_neq0 prim deg.
move=> rows columns co r c r' c'.
have area : (n1 * n2)%N = N.to_nat (Grid.period P) by rewrite rows columns per (standard_area deg).
have per_gt0 : (0 < N.to_nat (Grid.period P))%N by rewrite per period_gt0.
set s := sequence (map (element checked) lower) (map (element checked) state).
have n_gt0' : (0 < size (map (element checked) lower))%N by rewrite size_map.
have eq_size' : size (map (element checked) state) = size (map (element checked) lower).
  by rewrite !size_map.
have rec : recurrence h s by apply: sequence_recurrence.
have s_neq0 : nonzero s.
  case/hasP: state_neq0 => a /(nthP 0%num)[i lt_i <-] a_neq0; exists i.
  have lt_i' : (i < size (map (element checked) lower))%N by rewrite size_map -eq_size.
  have -> : s i = nth 0%R (map (element checked) state) i.
    exact: esym (nth_states eq_size' 0 lt_i').
  rewrite (nth_map 0%num) //.
  apply: contraNneq a_neq0 => /(congr1 (@code _ _ checked)).
  rewrite elementK; last by apply: (allP below_s); exact: mem_nth.
  move=> ->; rewrite code0; case: (closed_checked checked) => _ _ zero0 _.
  by apply/eqP; apply/N.eqb_spec.
have fold : diagonal_fold s n1 n2 (array_of checked).
  apply: executable_fold => // t; rewrite area per; exact: term_mod.
rewrite !(executable_window checked diagonal below_l below_s n_gt0 eq_size area co per_gt0).
case=> /List.map_ext_in_iff eq_cells.
have [] := @standard_window_unique _ h s (N.to_nat k1) (N.to_nat k2) (array_of checked)
    prim rec s_neq0 deg _ _ (N.to_nat r) (N.to_nat c) (N.to_nat r') (N.to_nat c').
- by rewrite -rows -columns.
- by rewrite -rows -columns.
- move=> i j lt_i lt_j; have := eq_cells _ (in_rectangle lt_i lt_j).
  by rewrite /= !Nnat.Nat2N.id -rows -columns => /(@code_inj _ _ checked).
have n12_gt0 : (0 < n1)%N && (0 < n2)%N by rewrite -muln_gt0 area.
case/andP: n12_gt0 => n1_gt0 n2_gt0; rewrite -rows -columns => eq_r eq_c.
by split; apply: Nnat.N2Nat.inj; rewrite !to_nat_mod.
Qed.

(* The paper's array: q = 4, x^4 + x^2 + A x + A^2, 15 rows and 17 columns along the diagonal. *)
Definition paper_profile : Grid.profile :=
  Grid.Profile 4 [:: 1; 1; 1]%num [:: 3; 2; 1; 0; 1]%num Grid.Characteristic [:: 0; 0; 0; 1]%num
    15 17 Grid.Diagonal Grid.Torus.

(* Equal executable windows of two rows and two columns of the paper's array are at the same cell. *)
Theorem paper_executable_unique r c r' c' :
  let at_ := Grid.window paper_profile Grid.Torus (Grid.folded paper_profile) (Grid.rectangle 2 2) in
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
