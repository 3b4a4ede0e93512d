(* How many wrong and unread cells leave at most one position.

   Let the windows at any two positions differ in at least d cells. The reader knows which cells
   are unread (erasures) and not which are wrong (errors). If 2 e + s < d, at most one position lies
   within e errors and s erasures. Any larger e or s fails for some reading.

   These Haskell functions rely on this file: corrects and minimumDistance of
   PraTactile.Window.Distance, and guaranteedRadius of PraTactile.Locate. *)

From mathcomp Require Import all_ssreflect all_algebra all_field.
From PraTactile Require Import Sequence Primitive Window Fold Cells.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(* The number of cells in which two windows differ. *)
Definition distance (T : eqType) m (u v : 'rV[T]_m) : nat := #|[set i | u 0 i != v 0 i]|.

(* The number of errors: the cells read, those outside E, that differ from the window. *)
Definition errors (T : eqType) m (E : {set 'I_m}) (u v : 'rV[T]_m) : nat :=
  #|[set i | (i \notin E) && (u 0 i != v 0 i)]|.

Lemma distance_errors (T : eqType) m (E : {set 'I_m}) (u v y : 'rV[T]_m) :
  (distance u v <= errors E u y + errors E v y + #|E|)%N.
Proof.
apply: leq_trans (leq_add (leq_card_setU _ _) (leqnn #|E|)).
apply: leq_trans (leq_card_setU _ _); apply/subset_leq_card/subsetP => i; rewrite !inE => ne_uv.
case: (i \in E); rewrite ?orbT //= orbF; apply: contraR ne_uv.
by rewrite negb_or !negbK => /andP[/eqP-> /eqP->].
Qed.

(* T9. Let the windows of a mask at any two cells of a surface differ in at least d cells, and let
   2 e + s < d. Then what was read with s erasures is within e errors of one window at most. *)
Theorem at_most_one_position (T : eqType) m (position : eqType) (at_ : position -> 'rV[T]_m) d e
    (E : {set 'I_m}) (y : 'rV[T]_m) :
  (forall x x', x != x' -> d <= distance (at_ x) (at_ x'))%N -> (2 * e + #|E| < d)%N ->
  forall x x', (errors E (at_ x) y <= e)%N -> (errors E (at_ x') y <= e)%N -> x = x'.
Proof.
move=> far lt_d x x' err_x err_x'; apply/eqP; apply: contraTT lt_d => /far le_d.
rewrite -leqNgt (leq_trans le_d) // (leq_trans (distance_errors E _ _ y)) // leq_add2r.
by rewrite mul2n -addnn leq_add.
Qed.

(* T9 cannot be improved: if two windows differ in at most 2 e + s cells, some readings with at most
   s erasures are within e errors of both. *)
Theorem ambiguous_reading (T : eqType) m (u v : 'rV[T]_m) e s : (distance u v <= 2 * e + s)%N ->
  exists (E : {set 'I_m}) (y : 'rV[T]_m),
    [/\ #|E| <= s, errors E u y <= e & errors E v y <= e]%N.
Proof.
set D := [set i | u 0 i != v 0 i] => le_D; pose l := enum D.
have card_seq (r : seq 'I_m) : (#|[set i in r]| <= size r)%N by rewrite cardsE card_size.
have size_l : (size l <= 2 * e + s)%N by rewrite -cardE.
pose E := [set i in take s l]; pose y := \row_i if i \in take e (drop s l) then u 0 i else v 0 i.
exists E, y; split.
- by rewrite (leq_trans (card_seq _)) // size_take; case: ltnP.
- apply: (@leq_trans #|[set i in drop e (drop s l)]|).
    apply/subset_leq_card/subsetP => i; rewrite !inE mxE; case: ifP => [_|]; rewrite ?eqxx ?andbF //.
    move=> not_mid /andP[not_E ne_uv]; have : i \in l by rewrite mem_enum inE.
    by rewrite -{1}(cat_take_drop s l) -{1}(cat_take_drop e (drop s l)) !mem_cat (negPf not_E) not_mid.
  rewrite (leq_trans (card_seq _)) // !size_drop -subnDA leq_subLR.
  by rewrite (leq_trans size_l) // mul2n -addnn addnC addnA.
apply: (@leq_trans #|[set i in take e (drop s l)]|).
  apply/subset_leq_card/subsetP => i; rewrite !inE mxE; case: ifP => //; rewrite eqxx andbF //.
by rewrite (leq_trans (card_seq _)) // size_take; case: ltnP.
Qed.

(* On the torus, windows at different cells differ in at least as many cells as the lightest window
   has nonzero ones, because their difference is again a window. *)
Theorem torus_distance (F : finFieldType) (h : {poly F}) (s : nat -> F) n1 n2 a m (w : mask m) d :
  let at_ (x : 'I_n1 * 'I_n2) := window (torus n1 n2 a) w x.1 x.2 in
  primitive h -> recurrence h s -> nonzero s -> (n1 * n2)%N = period h -> coprime n1 n2 ->
  diagonal_fold s n1 n2 a -> (forall x, d <= distance (at_ x) 0)%N ->
  forall x x', x != x' -> (d <= distance (at_ x) (at_ x'))%N.
Proof.
move=> at_ prim rec s_neq0 area co fold light x x' ne_x.
have contents := torus_contents prim rec w area co fold.
have [-> //|d_gt0] := posnP d; have full : torus_rank h n1 n2 w = degree h.
  apply/eqP; rewrite eqn_leq rank_leq_col leqNgt; apply/negP => lt_r.
  have [t lt_t zero_t] := deficient_zero prim rec s_neq0 lt_r.
  have : 0 \in [set at_ z | z : 'I_n1 * 'I_n2].
    by rewrite contents -zero_t; apply/imsetP; exists (Ordinal lt_t).
  case/imsetP => z _ at_z; have := light z; rewrite -at_z leqNgt.
  by rewrite /distance (eq_card0 (A := [set i | _])) ?d_gt0 // => i; rewrite inE eqxx.
have distE : distance (at_ x) (at_ x') = distance (at_ x - at_ x') 0.
  by apply: eq_card => i; rewrite !inE !mxE subr_eq0.
rewrite distE; have ne_at : at_ x != at_ x'.
  apply: contra_neq ne_x => /(torus_rank_n_tells prim rec s_neq0 area co fold full).
  rewrite !modn_small // => -[/val_inj eq1 /val_inj eq2].
  by rewrite [x]surjective_pairing [x']surjective_pairing eq1 eq2.
have : at_ x - at_ x' \in [set at_ z | z : 'I_n1 * 'I_n2].
  rewrite contents; have := content_sub prim rec (torus_exponents n1 n2 w)
    (chinese n1 n2 x.1 x.2) (chinese n1 n2 x'.1 x'.2).
  by rewrite !inE subr_eq0 -!(torus_window _ _ _ co fold) (negPf ne_at).
by case/imsetP => z _ ->.
Qed.

(* T9 on the torus. If every window has at least d nonzero cells and 2 e + s < d, at most one cell's
   window is within e errors and s erasures of what was read. *)
Theorem torus_at_most_one_position (F : finFieldType) (h : {poly F}) (s : nat -> F) n1 n2 a
    m (w : mask m) d e (E : {set 'I_m}) (y : 'rV[F]_m) :
  let at_ (x : 'I_n1 * 'I_n2) := window (torus n1 n2 a) w x.1 x.2 in
  primitive h -> recurrence h s -> nonzero s -> (n1 * n2)%N = period h -> coprime n1 n2 ->
  diagonal_fold s n1 n2 a -> (forall x, d <= distance (at_ x) 0)%N -> (2 * e + #|E| < d)%N ->
  forall x x', (errors E (at_ x) y <= e)%N -> (errors E (at_ x') y <= e)%N -> x = x'.
Proof.
move=> at_ prim rec s_neq0 area co fold light lt_d.
exact: (at_most_one_position (torus_distance prim rec s_neq0 area co fold light) lt_d).
Qed.
