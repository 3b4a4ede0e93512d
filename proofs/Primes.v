(* Prime factors of natural numbers, and a proof that trial division recognises primes.
   PraTactile.Factorisation finds prime factors faster. *)
From Coq Require Import NArith List Bool Lia.
From PraTactile Require Import Exec Grid Checker.
Import ListNotations.
Local Open Scope N_scope.

Definition prime (l : N) : Prop := 1 < l /\ forall d, (d | l) -> d = 1 \/ d = l.

Lemma in_upTo n x : In x (upTo n) <-> x < n.
Proof.
  unfold upTo; rewrite in_map_iff; split.
  - intros (i & <- & I); apply in_seq in I; lia.
  - intros L; exists (N.to_nat x); split; [lia |]; apply in_seq; lia.
Qed.

Lemma upTo_from_two n : 2 <= n -> upTo n = 0 :: 1 :: skipn 2 (upTo n).
Proof.
  intros L; unfold upTo; destruct (N.to_nat n) as [| [| k]] eqn:E; [lia | lia |]; reflexivity.
Qed.
Lemma in_from_two n x : 2 <= x < n -> In x (skipn 2 (upTo n)).
Proof.
  intros L; assert (In x (upTo n)) as I by (apply in_upTo; lia).
  rewrite upTo_from_two in I by lia; destruct I as [I | [I | I]]; [lia | lia | exact I].
Qed.

(* Trial division by all numbers up to the square root. *)
Lemma isPrime_prime l : isPrime l = true -> prime l.
Proof.
  unfold isPrime; rewrite !andb_true_iff, forallb_forall; intros [[L _] H].
  apply N.leb_le in L; split; [lia |]; intros d D.
  assert (forall x y, l = x * y -> 2 <= x -> x <= y -> False) as no.
  { intros x y E L2 LE; assert (x * x <= l) as Q by (rewrite E; apply N.mul_le_mono_l; easy).
    assert (x < 2 ^ (N.size l / 2 + 1)) as B.
    { pose proof (N.size_gt l) as G; clear - Q G; revert G; generalize (N.size l) as s; intros s G.
      destruct (N.lt_ge_cases x (2 ^ (s / 2 + 1))) as [| X]; [easy | exfalso].
      assert (2 ^ s <= x * x); [| lia].
      transitivity (2 ^ (s / 2 + 1) * 2 ^ (s / 2 + 1)); [| now apply N.mul_le_mono].
      rewrite <- N.pow_add_r; apply N.pow_le_mono_r; [lia |].
      pose proof (N.div_mod s 2); pose proof (N.mod_lt s 2); lia. }
    specialize (H x (in_from_two _ x (conj L2 B))).
    apply orb_true_iff in H as [H | H]; [apply N.leb_le in H; nia |].
    rewrite E, N.mul_comm, N.mod_mul in H by lia; easy. }
  destruct D as [k E]; destruct (N.eq_dec d 1) as [| D1]; [now left | right].
  destruct (N.eq_dec k 1) as [-> | K1]; [lia | exfalso].
  assert (2 <= d) by (enough (d <> 0) by lia; intros ->; lia).
  assert (2 <= k) by (enough (k <> 0) by lia; intros ->; lia).
  destruct (N.le_ge_cases d k) as [LE | LE]; [apply (no d k) | apply (no k d)]; lia.
Qed.

(* Each number above 1 has a prime factor. *)
Lemma prime_factor m : 1 < m -> exists r, prime r /\ (r | m).
Proof.
  induction m as [m IH] using (well_founded_induction N.lt_wf_0); intros L.
  destruct (find (fun d => m mod d =? 0) (skipn 2 (upTo m))) as [d |] eqn:F.
  - apply find_some in F as [I E]; apply N.eqb_eq in E.
    assert (2 <= d < m) as B.
    { assert (In d (upTo m)) as J by (rewrite upTo_from_two by lia; now right; right).
      apply in_upTo in J; split; [| easy].
      unfold upTo in I; destruct (N.to_nat m) as [| [| k]]; [destruct I | destruct I |].
      change (In d (map N.of_nat (seq 2 k))) in I; apply in_map_iff in I as (i & <- & I).
      apply in_seq in I; lia. }
    destruct (IH d ltac:(lia) ltac:(lia)) as (r & Pr & D); exists r; split; [easy |].
    apply N.mod_divide in E; [| lia]; now apply (N.divide_trans _ d).
  - exists m; split; [split; [easy |] | apply N.divide_refl].
    intros d D; destruct (N.eq_dec d 1) as [| D1]; [now left | right].
    assert (d <= m) as LE by (apply N.divide_pos_le; [lia | easy]).
    destruct (N.eq_dec d m) as [| Dm]; [easy | exfalso].
    assert (d <> 0) as D0 by (intros ->; apply N.divide_0_l in D; lia).
    pose proof (find_none _ _ F d (in_from_two m d ltac:(lia))) as Z.
    apply N.mod_divide in D; [| easy]; cbv beta in Z; rewrite D in Z; easy.
Qed.

(* A prime that divides a product divides one of its factors. *)
Lemma prime_mult r a b : prime r -> (r | a * b) -> (r | a) \/ (r | b).
Proof.
  intros [L D] H; destruct (D (N.gcd r a) (N.gcd_divide_l r a)) as [G | G].
  - right; now apply (N.gauss _ a).
  - left; rewrite <- G; apply N.gcd_divide_r.
Qed.
Lemma prime_pow r a e : prime r -> (r | a ^ e) -> (r | a).
Proof.
  intros Pr; induction e as [| e IH] using N.peano_ind; intros H.
  - rewrite N.pow_0_r in H; apply N.divide_1_r in H; destruct Pr; lia.
  - rewrite N.pow_succ_r' in H; destruct (prime_mult _ _ _ Pr H); auto.
Qed.
Lemma prime_product r (powers : list (N * N)) : prime r -> (forall f, In f powers -> prime (fst f)) ->
  (r | fold_right N.mul 1 (map (fun f => fst f ^ snd f) powers)) -> exists e, In (r, e) powers.
Proof.
  intros Pr; induction powers as [| [l e] others IH]; intros A H; simpl in H.
  - apply N.divide_1_r in H; destruct Pr; lia.
  - destruct (prime_mult _ _ _ Pr H) as [D | D].
    + exists e; left; f_equal; apply prime_pow in D; [| easy].
      destruct (A (l, e) (or_introl eq_refl)) as [L1 DL]; destruct (DL r D) as [-> | ->]; [destruct Pr; simpl in *; lia | easy].
    + destruct IH as [e' I]; auto with datatypes; exists e'; now right.
Qed.

(* A proper divisor of a product m of prime powers divides m / l for one of its primes l. *)
Lemma proper_divisor g m (powers : list (N * N)) : (forall f, In f powers -> prime (fst f)) ->
  fold_right N.mul 1 (map (fun f => fst f ^ snd f) powers) = m -> (g | m) -> 0 < g < m ->
  exists l e, In (l, e) powers /\ (g | m / l).
Proof.
  intros A E [k D] L; assert (1 < k) as K by (rewrite D in L; nia).
  destruct (prime_factor k K) as (r & Pr & [k' Dk]).
  assert ((r | m)) as H by (exists (k' * g); rewrite D, Dk; lia).
  rewrite <- E in H; destruct (prime_product _ _ Pr A H) as [e I]; exists r, e; split; [easy |].
  exists k'; rewrite D, Dk; replace (k' * r * g) with (k' * g * r) by lia.
  apply N.div_mul; destruct Pr; lia.
Qed.
