(* The fold puts exactly one term at each place of the array, and the cells of a window are terms at
   fixed distances from its first one.

   PraTactile.Array.Remainder and PraTactile.Window.Rank compute with these distances, the exponents
   e(i, j). *)
From Coq Require Import NArith List Bool Lia.
From PraTactile Require Import Exec Grid Checker Primes.
Import ListNotations.
Local Open Scope N_scope.

Lemma terms_map lower0 (K : arithmetic N) count : zero K = 0 -> forall S,
  terms K lower0 count S = map (fun i => hd 0 (N.iter (N.of_nat i) (step K lower0) S)) (seq 0 count).
Proof.
  intros Z; induction count as [| count IH]; intros S; [easy |].
  simpl terms; rewrite Z, IH; simpl seq; simpl map; f_equal.
  rewrite <- seq_shift, map_map; apply map_ext; intros i.
  now rewrite Nnat.Nat2N.inj_succ, N.iter_succ_r.
Qed.

Lemma sub_mod_divides n i j : n <> 0 -> i mod n = j mod n -> j <= i -> (n | i - j).
Proof.
  intros Z E L; exists (i / n - j / n).
  pose proof (N.div_mod i n Z) as I; pose proof (N.div_mod j n Z) as J; rewrite <- E in J.
  rewrite N.mul_sub_distr_r; lia.
Qed.
Lemma divides_sub_mod n i j : n <> 0 -> (n | i - j) -> j <= i -> i mod n = j mod n.
Proof.
  intros Z [k E] L; replace i with (j + k * n) by lia; now apply N.mod_add.
Qed.
Lemma mod_of_mod a b i : a <> 0 -> b <> 0 -> (i mod (a * b)) mod a = i mod a.
Proof. intros A B; rewrite N.mod_mul_r, N.mul_comm, N.mod_add, N.mod_mod; auto. Qed.

(* Chinese remainders: numbers that are equal modulo two coprime numbers are equal modulo their
   product. *)
Lemma remainders n1 n2 i j : n1 <> 0 -> n2 <> 0 -> N.gcd n1 n2 = 1 ->
  i mod n1 = j mod n1 -> i mod n2 = j mod n2 -> i mod (n1 * n2) = j mod (n1 * n2).
Proof.
  intros Z1 Z2 G.
  enough (forall i j, j <= i -> i mod n1 = j mod n1 -> i mod n2 = j mod n2 -> i mod (n1 * n2) = j mod (n1 * n2)) as H.
  { intros E1 E2; destruct (N.le_ge_cases j i); [now apply H | symmetry; now apply H]. }
  clear i j; intros i j L E1 E2; apply divides_sub_mod; [lia | | exact L].
  apply sub_mod_divides in E1 as [k1 D1], E2 as D2; try easy.
  rewrite D1 in D2 |- *; rewrite N.mul_comm in D2; apply N.gauss in D2 as [k D]; [| now rewrite N.gcd_comm].
  exists k; rewrite D; lia.
Qed.

Section Places.
Variable P : profile.
Notation n1 := (profileRows P).
Notation n2 := (profileColumns P).
Hypothesis zero_is_0 : zero (field P) = 0.
Hypothesis area : n1 * n2 = period P.
Hypothesis some : 0 < period P.
Hypothesis coprime : profileFolding P = Diagonal -> N.gcd n1 n2 = 1.
Hypothesis periodic : forall i, term P i = term P (i mod period P).

Lemma sides : n1 <> 0 /\ n2 <> 0.
Proof. split; intros E; rewrite E in area; lia. Qed.

Lemma place_injective i j : i mod period P = j mod period P <-> place P (i mod period P) = place P (j mod period P).
Proof.
  destruct sides as [Z1 Z2]; split; [now intros -> |]; unfold place; destruct (profileFolding P) eqn:F.
  - intros [= E1 E2]; rewrite <- area in *.
    rewrite !mod_of_mod in E1 by easy; rewrite (N.mul_comm n1 n2) in E2; rewrite !mod_of_mod in E2 by easy.
    now apply remainders; auto.
  - intros [= E1 E2]; rewrite (N.div_mod (i mod period P) n2 Z2), E1, E2; symmetry; now apply N.div_mod.
Qed.

Lemma in_positions r c : In (r, c) (positions P) <-> r < n1 /\ c < n2.
Proof.
  unfold positions; rewrite in_flat_map; split.
  - intros (r' & I & J); apply in_map_iff in J as (c' & [= -> ->] & J); now rewrite !in_upTo in *.
  - intros [I J]; exists r; split; [now apply in_upTo |]; apply in_map_iff; exists c; split; [easy | now apply in_upTo].
Qed.
Lemma place_in i : i < period P -> In (place P i) (positions P).
Proof.
  destruct sides as [Z1 Z2]; intros L; unfold place; destruct (profileFolding P); apply in_positions; split;
    try now apply N.mod_lt.
  apply N.div_lt_upper_bound; lia.
Qed.
Lemma positions_length : length (positions P) = N.to_nat (period P).
Proof.
  rewrite <- area, Nnat.N2Nat.inj_mul; unfold positions.
  assert (length (upTo n1) = N.to_nat n1) as <- by (unfold upTo; now rewrite map_length, seq_length).
  induction (upTo n1) as [| r rs IH]; [easy |]; simpl; rewrite app_length, IH, map_length.
  unfold upTo; rewrite map_length, seq_length; lia.
Qed.

Lemma places_distinct : NoDup (map (place P) (upTo (period P))).
Proof.
  assert (forall l, NoDup l -> (forall i, In i l -> i < period P) -> NoDup (map (place P) l)) as H.
  { induction 1 as [| i l N D IH]; intros B; simpl; constructor; [| apply IH; auto with datatypes].
    intros J; apply in_map_iff in J as (j & E & J).
    assert (i < period P) by auto with datatypes; assert (j < period P) by auto with datatypes.
    rewrite <- (N.mod_small i (period P)), <- (N.mod_small j (period P)) in E by easy.
    apply place_injective in E; rewrite !N.mod_small in E by easy; congruence. }
  apply H; [| intros i; apply in_upTo].
  unfold upTo; generalize (seq_NoDup (N.to_nat (period P)) 0); generalize (seq 0 (N.to_nat (period P))).
  induction 1 as [| x l N D IH]; simpl; constructor; auto.
  intros J; apply in_map_iff in J as (y & E & J); apply Nnat.Nat2N.inj in E; now subst.
Qed.
Lemma places_fill at' : In at' (positions P) -> exists t, t < period P /\ place P t = at'.
Proof.
  intros I; assert (In at' (map (place P) (upTo (period P)))) as J.
  { revert at' I; apply NoDup_length_incl; [apply places_distinct | |].
    - rewrite map_length, positions_length; unfold upTo; now rewrite map_length, seq_length.
    - intros at' I; apply in_map_iff in I as (t & <- & I); now apply place_in, in_upTo. }
  apply in_map_iff in J as (t & <- & J); exists t; split; [now apply in_upTo | easy].
Qed.
Lemma positions_distinct : NoDup (positions P).
Proof.
  apply (@NoDup_incl_NoDup _ (map (place P) (upTo (period P)))); [apply places_distinct | |].
  - rewrite map_length, positions_length; unfold upTo; now rewrite map_length, seq_length.
  - intros at' I; apply in_map_iff in I as (t & <- & I); now apply place_in, in_upTo.
Qed.

(* The cell at a place holds the term that the fold puts there. *)
Lemma folded_map : folded P = map (fun i => (place P i, term P i)) (upTo (period P)).
Proof.
  unfold folded; rewrite terms_map by exact zero_is_0; unfold upTo; rewrite !map_map.
  generalize (seq 0 (N.to_nat (period P))); induction l as [| i l IH]; [easy |]; simpl; now rewrite IH.
Qed.
Lemma samePlace_eq a b : samePlace a b = true <-> a = b.
Proof.
  destruct a as [r c], b as [r' c']; unfold samePlace; simpl; rewrite andb_true_iff, !N.eqb_eq; split.
  - now intros [-> ->].
  - now intros [= -> ->].
Qed.
Lemma cell_at k : cellIn (folded P) (place P (k mod period P)) = Some (term P k).
Proof.
  assert (k mod period P < period P) as L by (apply N.mod_lt; lia).
  unfold cellIn; rewrite folded_map; destruct (find _ _) as [[at' a] |] eqn:F; simpl.
  - apply find_some in F as [I E]; apply in_map_iff in I as (i & [= <- <-] & I); apply in_upTo in I.
    apply samePlace_eq in E; simpl in E; rewrite <- (N.mod_small i (period P)) in E by easy.
    apply place_injective in E; rewrite (N.mod_small i) in E by easy; f_equal; rewrite <- E; symmetry; apply periodic.
  - pose proof (find_none _ _ F (place P (k mod period P), term P (k mod period P))) as N.
    cbv beta in N; simpl in N; rewrite (proj2 (samePlace_eq _ _) eq_refl) in N.
    enough (true = false) by easy; apply N, in_map_iff; exists (k mod period P); split; [easy | now apply in_upTo].
Qed.

(* e is the exponent of the offset (i, j): the cell i rows down and j columns to the right holds the
   term e later, on the fold's own surface and on the sheet cut from it. *)
Definition exponentOf (e : N) (offset : N * N) : Prop :=
  match profileFolding P with
  | Diagonal => e mod n1 = fst offset mod n1 /\ e mod n2 = snd offset mod n2
  | RowMajor => e mod period P = (n2 * fst offset + snd offset) mod period P
  end.

Lemma own_place t e i j r c : t < period P -> place P t = (r, c) -> exponentOf e (i, j) ->
  onSurface P (ownSurface P) (r + i, c + j) = Some (place P ((t + e) mod period P)).
Proof.
  destruct sides as [Z1 Z2]; intros L; unfold place, exponentOf, ownSurface, onSurface.
  destruct (profileFolding P); simpl fst; simpl snd; rewrite <- area in *.
  - intros [= <- <-] [E1 E2]; f_equal; f_equal.
    + rewrite mod_of_mod by easy; rewrite N.add_mod_idemp_l by easy.
      now rewrite N.add_mod, <- E1, <- N.add_mod by easy.
    + rewrite (N.mul_comm n1 n2), mod_of_mod by easy; rewrite N.add_mod_idemp_l by easy.
      now rewrite N.add_mod, <- E2, <- N.add_mod by easy.
  - intros [= <- <-] E.
    assert (((t / n2 + i) * n2 + (t mod n2 + j)) mod (n1 * n2) = (t + e) mod (n1 * n2)) as ->; [| easy].
    rewrite (N.add_mod t e), E, <- N.add_mod by lia; f_equal.
    pose proof (N.div_mod t n2 Z2); lia.
Qed.
Lemma sheet_place at' : fst at' < n1 -> snd at' < n2 ->
  onSurface P (ownSurface P) at' = onSurface P Sheet at'.
Proof.
  destruct at' as [r c]; simpl; intros A B; destruct sides as [Z1 Z2].
  rewrite (proj2 (N.ltb_lt r n1) A), (proj2 (N.ltb_lt c n2) B); simpl.
  unfold ownSurface; destruct (profileFolding P); f_equal; [now rewrite !N.mod_small |].
  rewrite (N.mod_small (r * n2 + c)) by nia.
  rewrite (N.add_comm (r * n2)), N.div_add, N.mod_add, N.div_small, N.mod_small by easy; f_equal; lia.
Qed.

Lemma own_symbol t e i j r c : t < period P -> place P t = (r, c) -> exponentOf e (i, j) ->
  symbol P (ownSurface P) (folded P) (r + i, c + j) = Some (term P (t + e)).
Proof.
  intros L E H; unfold symbol; rewrite (own_place t e i j r c L E H); apply cell_at.
Qed.
Lemma sheet_symbol at' a : symbol P Sheet (folded P) at' = Some a -> symbol P (ownSurface P) (folded P) at' = Some a.
Proof.
  unfold symbol; destruct at' as [r c]; destruct (onSurface P Sheet (r, c)) eqn:E; [| easy].
  rewrite sheet_place, E; auto; simpl in *;
    destruct (r <? n1) eqn:A; destruct (c <? n2) eqn:B; try easy; now apply N.ltb_lt.
Qed.

(* A window's content by the exponents of the mask's cells. *)
Lemma own_window t r c (exponent : N * N -> N) m : t < period P -> place P t = (r, c) ->
  (forall o, In o m -> exponentOf (exponent o) o) ->
  window P (ownSurface P) (folded P) m (r, c) = Some (map (fun o => term P (t + exponent o)) m).
Proof.
  intros L E; induction m as [| [i j] m IH]; intros H; [easy |].
  cbn [window fst snd map]; rewrite (own_symbol t (exponent (i, j)) i j r c L E), IH; auto with datatypes.
Qed.
Lemma sheet_window at' m w : window P Sheet (folded P) m at' = Some w -> window P (ownSurface P) (folded P) m at' = Some w.
Proof.
  revert w; induction m as [| o m IH]; intros w; [easy |]; cbn [window].
  destruct (symbol P Sheet _ _) eqn:E; [| easy]; rewrite (sheet_symbol _ _ E).
  destruct (window P Sheet _ m _) eqn:F; [| easy]; now rewrite (IH _ eq_refl).
Qed.
End Places.
