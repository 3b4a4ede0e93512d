(* The executable array is the array of the theorems, cell by cell.

   Grid.v lists the terms with the places where the fold puts them, and looks a place up. For the
   diagonal fold with coprime sides the cell at any row and column of the torus is the code of the
   theorems' cell, and so are the windows.

   These Haskell functions rely on this file: cellAt of PraTactile.Array and windowAt of
   PraTactile.Window, which the conformance laws compare with the extracted Grid.v. *)

From Coq Require Import NArith Lia.
From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Exec Grid.
From PraTactile Require Import Sequence Primitive Fold Coded Correct Stepping Agreement.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma to_nat_mod (a b : N) : (0 < N.to_nat b)%N ->
  N.to_nat (N.modulo a b) = N.to_nat a %% N.to_nat b.
Proof.
move=> b_gt0; have b_neq0 : b <> N0 by move=> b0; rewrite b0 in b_gt0.
have lt_r : (N.to_nat (N.modulo a b) < N.to_nat b)%N.
  by apply/ltP; have := N.mod_lt a b b_neq0; lia.
have def_a : N.to_nat a = (N.to_nat (N.div a b) * N.to_nat b + N.to_nat (N.modulo a b))%N.
  have := N.div_mod a b b_neq0; rewrite -plusE -multE; lia.
by rewrite [in RHS]def_a modnMDl modn_small.
Qed.

Section Arrays.

Variables (P : Grid.profile) (q' : nat).
Local Notation K := (Grid.field P).
Local Notation lower := (Grid.lower P).
Local Notation state := (Grid.profileState P).
Local Notation n1 := (N.to_nat (Grid.profileRows P)).
Local Notation n2 := (N.to_nat (Grid.profileColumns P)).
Hypotheses (checked : is_field K q') (diagonal : Grid.profileFolding P = Grid.Diagonal).
Hypotheses (below_lower : all (@below q') lower) (below_state : all (@below q') state).
Hypotheses (n_gt0 : (0 < size lower)%N) (size_state : size state = size lower).
Hypotheses (area : (n1 * n2)%N = N.to_nat (Grid.period P)) (coprime_sides : coprime n1 n2).
Hypothesis period_gt0 : (0 < N.to_nat (Grid.period P))%N.

Local Notation s := (sequence (map (element checked) lower) (map (element checked) state)).

(* The array along whose diagonal the sequence lies. *)
Definition array_of (r c : nat) : field_of checked := s (chinese n1 n2 r c %% (n1 * n2)).

Lemma folded_list : Grid.folded P =
  [seq ((N.modulo (N.of_nat t) (Grid.profileRows P), N.modulo (N.of_nat t) (Grid.profileColumns P)),
     code (s t)) | t <- iota 0 (N.to_nat (Grid.period P))].
Proof.
have [_ terms] :=
  exec_terms checked below_lower below_state (N.to_nat (Grid.period P)) n_gt0 size_state.
rewrite /Grid.folded terms /Exec.upTo.
have seqE m k : List.seq m k = iota m k by elim: k m => //= k IHk m; rewrite IHk.
rewrite seqE; elim: (iota _ _) => //= t r ->.
by rewrite /Grid.place diagonal.
Qed.

(* The cell at a place inside the array. *)
Lemma cell_inside (r c : N) : (N.to_nat r < n1)%N -> (N.to_nat c < n2)%N ->
  Grid.cellIn (Grid.folded P) (r, c) = Some (code (array_of (N.to_nat r) (N.to_nat c))).
Proof.
move=> lt_r lt_c; set t0 := chinese n1 n2 (N.to_nat r) (N.to_nat c) %% (n1 * n2).
have n1_gt0 : (0 < n1)%N := leq_ltn_trans (leq0n _) lt_r.
have n2_gt0 : (0 < n2)%N := leq_ltn_trans (leq0n _) lt_c.
rewrite folded_list /Grid.cellIn.
set at_ := fun t => (N.modulo (N.of_nat t) (Grid.profileRows P),
  N.modulo (N.of_nat t) (Grid.profileColumns P)).
have sameE t : (t < n1 * n2)%N -> Grid.samePlace (r, c) (at_ t) = (t == t0).
  move=> lt_t; have modE (a : N) b : (0 < N.to_nat b)%N ->
      N.eqb a (N.modulo (N.of_nat t) b) = (N.to_nat a == t %% N.to_nat b).
    move=> b_gt0; rewrite -{2}(Nnat.Nat2N.id t) -to_nat_mod //.
    by apply/N.eqb_spec/eqP => [-> //|]; apply: Nnat.N2Nat.inj.
  rewrite /Grid.samePlace /= !modE //.
  have -> : (t == t0) = (t == chinese n1 n2 (N.to_nat r) (N.to_nat c) %[mod n1 * n2]).
    by rewrite /t0 [t %% _]modn_small.
  rewrite chinese_remainder // chinese_modl // chinese_modr //.
  by rewrite [N.to_nat r %% _]modn_small // [N.to_nat c %% _]modn_small // !(eq_sym (t %% _)).
have find_t0 (l : seq nat) : (forall t, t \in l -> (t < n1 * n2)%N) -> t0 \in l ->
    List.find (fun x => Grid.samePlace (r, c) (fst x)) [seq (at_ t, code (s t)) | t <- l]
      = Some (at_ t0, code (s t0)).
  elim: l => //= t l IHl small; rewrite inE => t0_in.
  rewrite sameE ?small ?mem_head //; case: eqP => [-> //|ne_t].
  apply: IHl => [u u_l|]; first by rewrite small // inE u_l orbT.
  by case/orP: t0_in => // /eqP eq_t; case: ne_t.
rewrite find_t0 // => [t|]; first by rewrite mem_iota area.
by rewrite mem_iota /= -area ltn_mod muln_gt0 n1_gt0.
Qed.

(* The cell at any row and column of the torus is the theorems' cell. *)
Theorem executable_cell (r c : N) :
  Grid.symbol P Grid.Torus (Grid.folded P) (r, c)
    = Some (code (torus n1 n2 array_of (N.to_nat r) (N.to_nat c))).
Proof.
have : (0 < n1)%N && (0 < n2)%N by rewrite -muln_gt0 area.
case/andP => n1_gt0 n2_gt0; rewrite /Grid.symbol /= cell_inside ?to_nat_mod // ?ltn_mod //.
Qed.

(* The array is the diagonal's, if the sequence has the period n1 n2. *)
Theorem executable_fold :
  (forall t, s (t %% (n1 * n2)) = s t) -> diagonal_fold s n1 n2 array_of.
Proof. by move=> s_per i; rewrite /array_of -[RHS]s_per (chinese_mod coprime_sides i). Qed.

(* A window of the torus holds the codes of the theorems' cells. *)
Theorem executable_window (mask : seq (N * N)) (r c : N) :
  Grid.window P Grid.Torus (Grid.folded P) mask (r, c)
    = Some [seq code (torus n1 n2 array_of (N.to_nat r + N.to_nat x.1) (N.to_nat c + N.to_nat x.2))
           | x <- mask].
Proof.
elim: mask => //= x mask ->; rewrite executable_cell.
by rewrite !Nnat.N2Nat.inj_add.
Qed.

End Arrays.
