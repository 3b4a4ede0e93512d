(* If x has order q^n - 1 modulo h, every nonzero polynomial of degree below n is a power of x, and
   the states within a period of the sequence are distinct.

   These Haskell modules rely on this file: PraTactile.Polynomial.Primitive and
   PraTactile.Certificate.Check. *)
From Coq Require Import NArith List Bool Ring Lia.
From PraTactile Require Import Exec Quotient Lists Root Primes.
Import ListNotations.
Local Open Scope N_scope.

Section Period.
Context {T : Type} (K : arithmetic T).
Hypothesis R : isRing K.
Add Ring ring : R.
Variable lower : list T.
Implicit Types a b u v S : list T.

Notation n := (length lower).
Notation M := (timesRoot K lower).
Notation next := (step K lower).
Notation X := (X K lower).
Notation "a [+] b" := (plus K a b) (at level 50, left associativity).
Notation "c .* a" := (scale K c a) (at level 40, left associativity).
Notation "a [*] b" := (product K lower a b) (at level 40, left associativity).

(* The order of x: if x^period is 1, and x^(period / l) is not 1 for any prime l that divides the
   period, no smaller power is 1. *)
Lemma order_of_root period (powers : list (N * N)) : (forall f, In f powers -> prime (fst f)) ->
  fold_right N.mul 1 (map (fun f => fst f ^ snd f) powers) = period ->
  X period = unit K lower -> (forall l e, In (l, e) powers -> X (period / l) <> unit K lower) ->
  forall d, 0 < d < period -> X d <> unit K lower.
Proof.
  intros A E XN XL d L XD.
  destruct (N.gcd_bezout_pos d period ltac:(lia)) as (s & t & B).
  set (g := N.gcd d period) in *.
  assert (X g = unit K lower) as XG.
  { pose proof (X_mul K R lower _ s XD) as H; rewrite B, N.add_comm, <- X_add in H by easy.
    rewrite (X_mul K R lower _ t XN), product_unit_l in H; [easy | easy |]; now apply X_length. }
  assert ((g | d)) as GD by apply N.gcd_divide_l.
  assert ((g | period)) as GP by apply N.gcd_divide_r.
  assert (0 < g <= d) as LG.
  { split; [| apply N.divide_pos_le; [lia | easy]].
    destruct (N.eq_dec g 0) as [G0 | G0]; [| lia]; rewrite G0 in GD; apply N.divide_0_l in GD; lia. }
  destruct (proper_divisor g period powers A E GP ltac:(lia)) as (l & e & I & [k D]).
  apply (XL l e I); rewrite D; now apply X_mul.
Qed.

Variable elements : list T.
Hypothesis all : forall x, In x elements.
Hypothesis one_zero : one K <> zero K.
Variable period : N.
Hypothesis size : Nat.pow (length elements) n = S (N.to_nat period).
Hypothesis some : (0 < n)%nat.
Hypothesis closes : X period = unit K lower.
Hypothesis order : forall d, 0 < d < period -> X d <> unit K lower.

Fixpoint tuples (k : nat) : list (list T) :=
  match k with O => [[]] | S k' => flat_map (fun x => map (cons x) (tuples k')) elements end.
Lemma in_tuples a : In a (tuples (length a)).
Proof.
  induction a as [| x a IH]; simpl; [now left |].
  apply in_flat_map; exists x; split; [apply all | now apply in_map].
Qed.
Lemma tuples_length k : length (tuples k) = Nat.pow (length elements) k.
Proof.
  induction k as [| k IH]; [easy |]; simpl; rewrite <- IH; clear; generalize (tuples k) as l; intros l.
  induction elements as [| x xs IHx]; [easy |]; simpl; rewrite app_length, map_length, IHx; lia.
Qed.

Lemma unit_nonzero : unit K lower <> nought K lower.
Proof. clear - some one_zero; destruct lower; simpl in *; [lia | congruence]. Qed.
Lemma X_nonzero i : i <= period -> X i <> nought K lower.
Proof.
  intros L E; assert (X i [*] X (period - i) = unit K lower) as H.
  { rewrite X_add by easy; now replace (i + (period - i)) with period by lia. }
  apply unit_nonzero; rewrite <- H, E, <- (scale_zero K R lower).
  replace (scale K (zero K) lower) with (scale K (zero K) (X i))
    by (rewrite !scale_zero by easy; apply nought_same; now apply X_length).
  rewrite product_scale, !scale_zero by (auto; now apply X_length).
  apply nought_same; rewrite product_length, X_length; auto; now apply X_length.
Qed.
Lemma X_injective i j : i < period -> j < period -> X i = X j -> i = j.
Proof.
  enough (forall i j, i < j -> j < period -> X i = X j -> False) as H.
  { intros I J E; destruct (N.lt_trichotomy i j) as [L | [-> | L]]; [| easy |]; exfalso.
    - exact (H i j L J E).
    - exact (H j i L I (eq_sym E)). }
  clear i j; intros i j L J E; apply (order (j - i)); [lia |].
  transitivity (X period [*] X (j - i)).
  - rewrite closes, product_unit_l; auto; apply X_length; easy.
  - rewrite X_add by easy; replace (period + (j - i)) with (j + (period - i)) by lia.
    rewrite <- X_add, <- E, X_add by easy; now replace (i + (period - i)) with period by lia.
Qed.

(* By counting: 0 and the powers of x are q^n different polynomials. *)
Theorem nonzero_is_power w : length w = n -> w <> nought K lower -> exists k, k < period /\ w = X k.
Proof.
  intros L W; set (powers := nought K lower :: map X (upTo period)).
  assert (NoDup powers) as D.
  { constructor.
    - intros I; apply in_map_iff in I as (i & E & I); apply in_upTo in I; now apply (X_nonzero i ltac:(lia)).
    - apply NoDup_image; [apply NoDup_upTo |]; intros i j I J; apply in_upTo in I, J; now apply X_injective. }
  assert (incl (tuples n) powers) as F.
  { apply NoDup_length_incl; [exact D | |].
    - rewrite tuples_length, size; unfold powers, upTo; simpl; rewrite !map_length, seq_length; lia.
    - intros a [<- | I].
      + rewrite <- (nought_length K lower); apply in_tuples.
      + apply in_map_iff in I as (i & <- & I); rewrite <- (X_length K lower i); apply in_tuples. }
  assert (In w powers) as [E | I] by (apply F; rewrite <- L; apply in_tuples); [congruence |].
  apply in_map_iff in I as (k & <- & I); exists k; split; [now apply in_upTo | easy].
Qed.

Lemma iter_period S : length S = n -> N.iter period next S = S.
Proof.
  intros L; apply (forms_decide K R lower); auto; [now rewrite iter_next_length |].
  intros u U; rewrite <- dot_iter, <- X_acts by auto; rewrite closes, product_unit_l; auto.
Qed.

Lemma iter_nought e : N.iter e next (nought K lower) = nought K lower.
Proof.
  apply (forms_decide K R lower); auto; rewrite ?iter_next_length; rewrite ?nought_length; auto.
  intros u U; rewrite <- dot_iter, !dot_nought_r; auto; apply nought_length.
Qed.

Theorem states_are_distinct S t t' : length S = n -> S <> nought K lower -> t < period -> t' < period ->
  N.iter t next S = N.iter t' next S -> t = t'.
Proof.
  intros L Z.
  enough (forall t t', t < t' -> t' < period -> N.iter t next S = N.iter t' next S -> False) as H.
  { intros A B E; destruct (N.lt_trichotomy t t') as [Lt | [-> | Lt]]; [| easy |]; exfalso.
    - exact (H t t' Lt B E).
    - exact (H t' t Lt A (eq_sym E)). }
  clear t t'; intros t t' A B E; set (d := t' - t); set (S1 := N.iter t next S).
  assert (length S1 = n) as L1 by (unfold S1; now rewrite iter_next_length).
  assert (N.iter d next S1 = S1) as E1.
  { unfold S1, d; rewrite <- N.iter_add; now replace (t' - t + t) with t' by lia. }
  set (w := X d [+] neg K (one K) .* unit K lower).
  assert (length w = n) as LW.
  { unfold w; rewrite plus_length; rewrite scale_length, ?unit_length, ?X_length; auto. }
  assert (w <> nought K lower) as W.
  { intros W; apply (order d ltac:(unfold d; lia)).
    assert (w [+] unit K lower = unit K lower) as W' by (rewrite W; apply plus_nought; auto; now rewrite unit_length).
    rewrite <- W'; unfold w; rewrite <- plus_assoc by easy.
    assert (neg K (one K) .* unit K lower [+] unit K lower = nought K lower) as ->.
    { transitivity (add K (neg K (one K)) (one K) .* unit K lower).
      - rewrite scale_add by easy; f_equal; generalize (unit K lower) as l; induction l as [| y l IH]; simpl; [easy |].
        f_equal; [ring | exact IH].
      - replace (add K (neg K (one K)) (one K)) with (zero K) by ring; rewrite scale_zero by easy.
        apply nought_same, unit_length. }
    rewrite plus_comm, plus_nought; auto; now apply X_length. }
  destruct (nonzero_is_power w LW W) as (k & LK & WK).
  assert (N.iter k next S1 = nought K lower) as Z1.
  { apply (forms_decide K R lower); rewrite ?iter_next_length, ?nought_length; auto; intros u U.
    rewrite dot_nought_r, <- dot_iter, <- X_acts, <- WK by auto.
    assert (w [*] u = N.iter d M u [+] neg K (one K) .* u) as ->.
    { unfold w; rewrite product_plus; [| exact R | now apply X_length | now rewrite scale_length, unit_length].
      rewrite product_scale; [| exact R | apply unit_length].
      now rewrite X_acts, product_unit_l by auto. }
    rewrite dot_plus by (auto; now rewrite scale_length, iter_M_length).
    rewrite dot_scale, dot_iter, E1 by auto; ring. }
  apply Z; rewrite <- (iter_period S L), <- (iter_period S L) at 1.
  rewrite <- N.iter_add; replace (period + period) with ((period + period - (k + t)) + (k + t)) by lia.
  rewrite N.iter_add, (N.iter_add k t); fold S1; rewrite Z1; apply iter_nought.
Qed.
End Period.
