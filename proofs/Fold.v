(* Folding a sequence of n1 n2 terms into an array of n1 rows and n2 columns.

   Along the diagonal, a[i mod n1][i mod n2] = s(i): this reaches lcm(n1, n2) cells, hence all of
   them if and only if n1 and n2 are coprime. Row by row, a[r][c] = s(n2 r + c): this always reaches
   all, and the cell after a row's last is the next row's first (the twisted torus). On either
   surface a step down or to the right adds a constant to the index, whatever the cell.

   These Haskell functions rely on this file: fold, sequenceIndex, positionOfIndex, naturalSurface
   and cellAt of PraTactile.Array. *)

From mathcomp Require Import all_ssreflect all_algebra.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* T4. The sides n1 = q^k1 - 1 and n2 = (q^(k1 k2) - 1) / n1 of the standard fold have the same
   greatest common divisor as n1 and k2. *)
Theorem gcd_of_sides q k1 k2 : 1 < q -> 0 < k1 ->
  gcdn (q ^ k1).-1 ((q ^ (k1 * k2)).-1 %/ (q ^ k1).-1) = gcdn (q ^ k1).-1 k2.
Proof.
move=> q_gt1 k1_gt0; have Q_gt1 : 1 < q ^ k1 by rewrite -{1}(exp1n k1) ltn_exp2r.
have n1_gt0 : 0 < (q ^ k1).-1 by case: (q ^ k1) Q_gt1 => [|[]].
rewrite expnM (predn_exp (q ^ k1)) mulKn //.
rewrite -[LHS]gcdn_modr -[RHS]gcdn_modr; congr gcdn.
have Q_eq1 : q ^ k1 = 1 %[mod (q ^ k1).-1] by rewrite -{1}[q ^ k1]prednK ?(ltnW Q_gt1) // -addn1 modnDl.
elim: k2 => [|k IHk]; first by rewrite big_ord0.
by rewrite big_ord_recr /= -modnDm IHk -modnXm Q_eq1 modnXm exp1n modnDm addn1.
Qed.

(* The cells (r, c) that the diagonal visits: r = i mod n1 and c = i mod n2 for some i. *)
Definition visited n1 n2 : {set 'I_n1 * 'I_n2} :=
  [set x : 'I_n1 * 'I_n2 | [exists i : 'I_(n1 * n2), (i %% n1 == x.1) && (i %% n2 == x.2)]].

Lemma visitedP n1 n2 (x : 'I_n1 * 'I_n2) :
  reflect (exists i, i %% n1 = x.1 /\ i %% n2 = x.2) (x \in visited n1 n2).
Proof.
rewrite inE; apply: (iffP existsP) => [[i /andP[/eqP r /eqP c]]|[i [r c]]]; first by exists i.
have lt_i : i %% (n1 * n2) < n1 * n2.
  by rewrite ltn_mod muln_gt0 (leq_ltn_trans _ (ltn_ord x.1)) // (leq_ltn_trans _ (ltn_ord x.2)).
by exists (Ordinal lt_i); rewrite /= modn_dvdm ?dvdn_mulr // modn_dvdm ?dvdn_mull // r c !eqxx.
Qed.

(* T5. The diagonal visits lcm(n1, n2) cells. *)
Theorem diagonal_visits_lcm n1 n2 : 0 < n1 -> 0 < n2 -> #|visited n1 n2| = lcmn n1 n2.
Proof.
move=> n1_gt0 n2_gt0.
pose f (i : 'I_(lcmn n1 n2)) :=
  (Ordinal (ltn_pmod i n1_gt0), Ordinal (ltn_pmod i n2_gt0)) : 'I_n1 * 'I_n2.
have f_inj : injective f.
  move=> i j [/eqP r /eqP c]; apply: val_inj => /=.
  wlog le_ij : i j r c / j <= i => [wlog_ij|].
    case: (leqP j i) => [/wlog_ij|/ltnW/wlog_ij wlog_ji]; first exact.
    by apply/esym/wlog_ji; rewrite eq_sym.
  have : lcmn n1 n2 %| i - j by rewrite dvdn_lcm -!eqn_mod_dvd // r c.
  by rewrite -eqn_mod_dvd // !modn_small // => /eqP.
rewrite -[RHS]card_ord -(card_imset _ f_inj); apply: eq_card => x.
apply/visitedP/imsetP => [[i [r c]]|[i _ ->]]; last by exists i.
have lt_i : i %% lcmn n1 n2 < lcmn n1 n2 by rewrite ltn_mod lcmn_gt0 n1_gt0.
exists (Ordinal lt_i) => //; rewrite [x]surjective_pairing; congr pair; apply: val_inj => /=.
  by rewrite modn_dvdm ?dvdn_lcml.
by rewrite modn_dvdm ?dvdn_lcmr.
Qed.

(* T5. The diagonal visits every cell if and only if the sides are coprime. *)
Theorem diagonal_fills_iff_coprime n1 n2 : 0 < n1 -> 0 < n2 ->
  (visited n1 n2 == setT) = coprime n1 n2.
Proof.
move=> n1_gt0 n2_gt0; rewrite eqEcard subsetT cardsT card_prod !card_ord diagonal_visits_lcm //.
rewrite -muln_lcm_gcd -{2}(muln1 (lcmn n1 n2)) leq_pmul2l ?lcmn_gt0 ?n1_gt0 //.
by rewrite /coprime eqn_leq gcdn_gt0 n1_gt0 andbT.
Qed.

(* T6. In 15 rows and 273 columns the diagonal visits 1365 of the 4095 cells. *)
Theorem fold_15_273_visits_1365 : #|visited 15 273| = 1365 /\ #|{: 'I_15 * 'I_273}| = 4095.
Proof. by rewrite diagonal_visits_lcm // card_prod !card_ord. Qed.

(* T7. Row by row every cell is visited once. *)
Theorem row_by_row_fills n1 n2 r c : r < n1 -> c < n2 ->
  exists! i, i < n1 * n2 /\ (i %/ n2 = r /\ i %% n2 = c).
Proof.
move=> lt_r lt_c; have n2_gt0 : 0 < n2 := leq_ltn_trans (leq0n c) lt_c.
exists (r * n2 + c); split; last by move=> i [_ [<- <-]]; rewrite -divn_eq.
rewrite divnMDl // modnMDl divn_small // modn_small // addn0; split=> //.
by rewrite (@leq_trans (r.+1 * n2)) // ?leq_mul2r ?lt_r ?orbT // mulSn addnC ltn_add2r.
Qed.

(* An array is a function of row and column. Only rows below n1 and columns below n2 count. *)
Definition diagonal_fold T (s : nat -> T) n1 n2 (a : nat -> nat -> T) : Prop :=
  forall i, a (i %% n1) (i %% n2) = s i.

Definition row_fold T (s : nat -> T) n1 n2 (a : nat -> nat -> T) : Prop :=
  forall r c, r < n1 -> c < n2 -> a r c = s (n2 * r + c).

(* The cell at any row and column, when opposite edges are joined. *)
Definition torus T n1 n2 (a : nat -> nat -> T) (r c : nat) : T := a (r %% n1) (c %% n2).

(* The cell at any row and column, when each row's end is joined to the next row's beginning, and
   the last row's end to the first row's beginning. *)
Definition twisted_torus T n1 n2 (a : nat -> nat -> T) (r c : nat) : T :=
  let i := (n2 * r + c) %% (n1 * n2) in a (i %/ n2) (i %% n2).

(* Beyond the edges the diagonal's array continues: the index is linear in row and column. *)
Lemma torus_term T (s : nat -> T) n1 n2 a r c : coprime n1 n2 -> diagonal_fold s n1 n2 a ->
  torus n1 n2 a r c = s (chinese n1 n2 r c).
Proof. by move=> co_n fold; rewrite -fold chinese_modl ?chinese_modr. Qed.

Lemma chineseD n1 n2 r c i j :
  chinese n1 n2 (r + i) (c + j) = chinese n1 n2 r c + chinese n1 n2 i j.
Proof. by rewrite /chinese !mulnDl addnACA. Qed.

Lemma twisted_term T (s : nat -> T) n1 n2 a r c : 0 < n1 -> 0 < n2 ->
  (forall i, s (i %% (n1 * n2)) = s i) -> row_fold s n1 n2 a ->
  twisted_torus n1 n2 a r c = s (n2 * r + c).
Proof.
move=> n1_gt0 n2_gt0 s_per fold; rewrite /twisted_torus fold ?ltn_mod //; last first.
  by rewrite ltn_divLR // ltn_mod muln_gt0 n1_gt0.
by rewrite mulnC -divn_eq s_per.
Qed.

(* Folded arrays exist for every sequence with the period n1 n2. *)
Lemma diagonal_fold_exists T (s : nat -> T) n1 n2 : coprime n1 n2 ->
  (forall i, s (i %% (n1 * n2)) = s i) -> diagonal_fold s n1 n2 (fun r c => s (chinese n1 n2 r c)).
Proof. by move=> co_n s_per i; rewrite -s_per -chinese_mod // s_per. Qed.
