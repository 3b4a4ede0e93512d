(* The powers of x modulo h, and the terms of the sequence by them: s(t + e) is a linear form in
   s(t), ..., s(t+n-1), whose coefficients are those of x^e.

   These Haskell modules rely on this file: PraTactile.Window.Rank, which decides whether a mask
   determines a position, and PraTactile.Sequence.Jump, which computes distant terms. *)
From Coq Require Import NArith List Bool Ring Lia.
From PraTactile Require Import Exec Quotient Checker.
Import ListNotations.
Local Open Scope N_scope.

Section Root.
Context {T : Type} (K : arithmetic T).
Hypothesis R : isRing K.
Add Ring ring : R.
Variable lower : list T.
Implicit Types a b u v S : list T.

Notation n := (length lower).
Notation M := (timesRoot K lower).
Notation next := (step K lower).
Notation "a [+] b" := (plus K a b) (at level 50, left associativity).
Notation "c .* a" := (scale K c a) (at level 40, left associativity).
Notation "a [*] b" := (product K lower a b) (at level 40, left associativity).

Definition X (e : N) : list T := N.iter e M (unit K lower).

Lemma iter_M_length e u : length u = n -> length (N.iter e M u) = n.
Proof.
  intros E; induction e as [| e IH] using N.peano_ind; [easy |]; rewrite N.iter_succ; now apply M_length.
Qed.
Lemma X_length e : length (X e) = n.
Proof. apply iter_M_length, unit_length. Qed.
Lemma iter_M_product e u v : length u = n -> N.iter e M u [*] v = N.iter e M (u [*] v).
Proof.
  intros E; induction e as [| e IH] using N.peano_ind; [easy |].
  rewrite !N.iter_succ, product_M, IH; [easy | exact R | now apply iter_M_length].
Qed.
Lemma X_acts e u : length u = n -> X e [*] u = N.iter e M u.
Proof. intros E; unfold X; rewrite iter_M_product, product_unit_l; auto; apply unit_length. Qed.
Lemma X_add d e : X d [*] X e = X (d + e).
Proof. rewrite X_acts by apply X_length; unfold X; now rewrite N.iter_add. Qed.
Lemma X_mul d e : X d = unit K lower -> X (e * d) = unit K lower.
Proof.
  intros E; induction e as [| e IH] using N.peano_ind; [easy |].
  rewrite N.mul_succ_l, <- X_add, IH, E; apply product_unit_l; auto; apply unit_length.
Qed.

(* Repeated squaring computes the power. *)
Lemma raised_X e : forall d, raised K lower (X d) e = X (d * Npos e).
Proof.
  induction e as [e IH | e IH |]; intros d; simpl raised.
  - rewrite X_add, IH, X_add; f_equal; lia.
  - rewrite X_add, IH; f_equal; lia.
  - f_equal; lia.
Qed.
Lemma rootPower_X e : rootPower K lower e = X e.
Proof.
  destruct e as [| e]; [easy |]; simpl rootPower; change (M (unit K lower)) with (X 1).
  rewrite raised_X; f_equal; lia.
Qed.

(* Linear forms of states. *)
Lemma dot_plus a b S : length a = length b -> dot K (a [+] b) S = add K (dot K a S) (dot K b S).
Proof.
  revert b S; induction a as [| x a IH]; intros [| y b] [| s S]; simpl; try easy; intros; try ring.
  rewrite IH by congruence; ring.
Qed.
Lemma dot_scale c a S : dot K (c .* a) S = mul K c (dot K a S).
Proof. revert S; induction a as [| x a IH]; intros [| s S]; simpl; try ring; rewrite IH; ring. Qed.
Lemma dot_nought_l a S : dot K (nought K a) S = zero K.
Proof. revert S; induction a as [| x a IH]; intros [| s S]; simpl; try ring; rewrite IH; ring. Qed.
Lemma dot_nought_r a S : dot K a (nought K S) = zero K.
Proof. revert S; induction a as [| x a IH]; intros [| s S]; simpl; try ring; rewrite IH; ring. Qed.

Lemma dot_shift z u : forall x S, length u = length S -> S <> [] ->
  add K (dot K (shift x u) S) (mul K (last u (zero K)) z) = add K (mul K x (hd (zero K) S)) (dot K u (tl S ++ [z])).
Proof.
  induction u as [| y u IH]; intros x [| s S]; try easy; intros [= E] _.
  destruct u as [| y' u], S as [| s' S]; try easy; [simpl; ring |].
  change (last (y :: y' :: u) (zero K)) with (last (y' :: u) (zero K)).
  specialize (IH y (s' :: S) E ltac:(easy)); simpl hd in *; simpl tl in *.
  change (shift x (y :: y' :: u)) with (x :: shift y (y' :: u)).
  change (dot K (x :: shift y (y' :: u)) (s :: s' :: S))
    with (add K (mul K x s) (dot K (shift y (y' :: u)) (s' :: S))).
  change (dot K (y :: y' :: u) ((s' :: S) ++ [z])) with (add K (mul K y s') (dot K (y' :: u) (S ++ [z]))).
  rewrite <- IH; ring.
Qed.
Lemma step_length S : length (next S) = length S.
Proof. destruct S; simpl; [easy | rewrite app_length; simpl; lia]. Qed.
Lemma dot_M u S : length u = n -> length S = n -> dot K (M u) S = dot K u (next S).
Proof.
  intros U L; unfold timesRoot; rewrite dot_plus, dot_scale by now rewrite scale_length, shift_length.
  destruct S as [| s S]; [destruct u; [simpl in *; ring | simpl in *; congruence] |].
  pose proof (dot_shift (neg K (dot K lower (s :: S))) u (zero K) (s :: S) ltac:(congruence) ltac:(easy)) as D.
  simpl hd in D; simpl tl in D; change (next (s :: S)) with (S ++ [neg K (dot K lower (s :: S))]).
  transitivity (add K (mul K (zero K) s) (dot K u (S ++ [neg K (dot K lower (s :: S))]))); [rewrite <- D; ring | ring].
Qed.
Lemma iter_next_length e S : length (N.iter e next S) = length S.
Proof. induction e as [| e IH] using N.peano_ind; [easy |]; now rewrite N.iter_succ, step_length. Qed.
Lemma dot_iter e : forall u S, length u = n -> length S = n -> dot K (N.iter e M u) S = dot K u (N.iter e next S).
Proof.
  induction e as [| e IH] using N.peano_ind; intros u S U L; [easy |].
  rewrite N.iter_succ, N.iter_succ_r, dot_M, IH by (rewrite ?step_length; try apply iter_M_length; easy); easy.
Qed.
Lemma dot_unit S : length S = n -> dot K (unit K lower) S = hd (zero K) S.
Proof.
  destruct lower, S; simpl; try easy; intros _.
  rewrite (dot_nought_l l S); ring.
Qed.

(* s(t + e) as a linear form in s(t), ..., s(t+n-1). *)
Lemma term_by_root S t e : length S = n ->
  hd (zero K) (N.iter (t + e) next S) = dot K (X e) (N.iter t next S).
Proof.
  intros L; rewrite N.add_comm, N.iter_add, <- dot_unit by now rewrite !iter_next_length.
  symmetry; unfold X; apply dot_iter; [apply unit_length | now rewrite iter_next_length].
Qed.

(* Two states are equal if all forms of a basis have the same values on them. *)
Lemma identity_decides : forall S S', length S = length S' ->
  (forall row, In row (identity K (length S)) -> dot K row S = dot K row S') -> S = S'.
Proof.
  induction S as [| s S IH]; intros [| s' S']; try easy; intros [= E] H; simpl in H.
  assert (repeat (zero K) (length S) = nought K S) as Z by now rewrite nought_repeat.
  assert (dot K (repeat (zero K) (length S)) S = zero K) as Z1 by now rewrite Z, dot_nought_l.
  assert (dot K (repeat (zero K) (length S)) S' = zero K) as Z2 by now rewrite Z, dot_nought_l.
  f_equal.
  - specialize (H _ (or_introl eq_refl)); simpl in H; rewrite Z1, Z2 in H.
    transitivity (add K (mul K (one K) s) (zero K)); [ring | rewrite H; ring].
  - apply IH; [easy |]; intros row I.
    specialize (H (zero K :: row) (or_intror (in_map _ _ _ I))); simpl in H.
    transitivity (add K (mul K (zero K) s) (dot K row S)); [ring | rewrite H; ring].
Qed.
Lemma identity_lengths k : forall row, In row (identity K k) -> length row = k.
Proof.
  induction k as [| k IH]; [easy |]; simpl; intros row [<- | I]; [simpl; now rewrite repeat_length |].
  apply in_map_iff in I as (row' & <- & I); simpl; f_equal; auto.
Qed.
Lemma forms_decide S S' : length S = n -> length S' = n ->
  (forall u, length u = n -> dot K u S = dot K u S') -> S = S'.
Proof.
  intros L L' H; apply identity_decides; [congruence |]; intros row I; apply H.
  rewrite (identity_lengths _ _ I); easy.
Qed.

(* A left inverse of the matrix of forms turns their values into the state. *)
Lemma combination_length k vs : (forall v, In v vs -> length v = k) -> forall cs, length (combination K k cs vs) = k.
Proof.
  induction vs as [| v vs IH]; intros V [| c cs]; simpl; try apply repeat_length.
  rewrite plus_length; [apply IH; auto with datatypes |].
  rewrite scale_length, IH; [apply V | ]; auto with datatypes.
Qed.
Lemma dot_combination S vs : (forall v, In v vs -> length v = length S) -> forall cs,
  dot K (combination K (length S) cs vs) S = dot K cs (map (fun v => dot K v S) vs).
Proof.
  assert (dot K (repeat (zero K) (length S)) S = zero K) as Z by (rewrite <- nought_repeat; apply dot_nought_l).
  induction vs as [| v vs IH]; intros V [| c cs]; simpl; try exact Z.
  rewrite dot_plus, dot_scale, IH; [easy | auto with datatypes |].
  rewrite scale_length, combination_length; [apply V | ]; auto with datatypes.
Qed.
Lemma inverse_decides S S' vs rows : length S = length S' -> (forall v, In v vs -> length v = length S) ->
  map (fun row => combination K (length S) row vs) rows = identity K (length S) ->
  map (fun v => dot K v S) vs = map (fun v => dot K v S') vs -> S = S'.
Proof.
  intros L V I E; apply identity_decides; [easy |]; intros row J; rewrite <- I in J.
  apply in_map_iff in J as (cs & <- & _); rewrite dot_combination by easy.
  rewrite L, dot_combination by now rewrite <- L.
  now rewrite E.
Qed.
End Root.
