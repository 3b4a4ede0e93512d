(* T10. The checker of certificates is sound: if it accepts one, h is primitive and all windows of
   the mask are distinct.

   "Primitive" and "windows" are those of Exec.v and Grid.v. PraTactile.Certificate.Check and
   data/check_certificate.py check the same claims, and the tests compare the three verdicts. *)
From Coq Require Import NArith List Bool Lia.
From PraTactile Require Import Exec Quotient Grid Checker Lists Primes Root Period Maps Codes Places.
Import ListNotations.
Local Open Scope N_scope.

(* x^d modulo h, by d multiplications by x. *)
Definition powerOfRoot (P : profile) (d : N) : list N :=
  N.iter d (timesRoot (field P) (lower P)) (unit (field P) (lower P)).

(* h is primitive: x has order q^n - 1, and every nonzero polynomial of degree below n is a power
   of x. *)
Definition primitive (P : profile) : Prop :=
  powerOfRoot P (period P) = unit (field P) (lower P)
  /\ (forall d, 0 < d < period P -> powerOfRoot P d <> unit (field P) (lower P))
  /\ (forall w, length w = length (lower P) -> Forall (fun a => a < profileOrder P) w ->
        w = repeat 0 (length w) \/ exists k, k < period P /\ w = powerOfRoot P k).

(* All windows on the surface are distinct, and on either torus every position has a window. *)
Definition windowsAreDistinct (P : profile) (m : list (N * N)) : Prop :=
  NoDup (map snd (windows P (profileSurface P) (folded P) m))
  /\ (forall a b w, In a (positions P) -> In b (positions P) ->
        window P (profileSurface P) (folded P) m a = Some w -> window P (profileSurface P) (folded P) m b = Some w -> a = b)
  /\ (profileSurface P <> Sheet -> length (windows P (profileSurface P) (folded P) m) = length (positions P)).

Section Sound.
Variable C : certificate.
Notation P := (claimed C).
Notation q := (profileOrder P).
Notation h := (lower P).
Notation n := (length h).
Hypothesis yes : check C = true.

Lemma checked : fieldIsRight C = true /\ polynomialIsRight C = true /\ orderIsRight C = true
  /\ foldIsRight C = true /\ maskIsRight C = true /\ rankIsRight C = true.
Proof. unfold check in yes; rewrite !andb_true_iff in yes; tauto. Qed.

Lemma field_of_P : exists (F : Type) (K : arithmetic F) (e : F -> N) (all : list F),
    isRing K /\ respects K (field P) e /\ one K <> zero K /\ (forall x, In x all)
    /\ length all = N.to_nat q /\ (forall x y, e x = e y -> x = y)
    /\ (forall x, e x < q) /\ (forall a, a < q -> exists x, e x = a).
Proof.
  destruct checked as (H & _); unfold fieldIsRight in H; rewrite !andb_true_iff in H.
  destruct H as ((((((Q & _) & M) & _) & E) & B) & _).
  apply N.leb_le in Q, M; apply N.eqb_eq in E; unfold field.
  set (p := characteristicOf q) in *; set (m := pred (length (profileModulus P))) in *.
  assert (2 <= p) as two.
  { destruct (N.eq_dec p 0) as [Z | Z]; [rewrite Z, N.pow_0_l in E; lia |].
    destruct (N.eq_dec p 1) as [O | O]; [rewrite O, N.pow_1_l in E; lia | lia]. }
  rewrite <- E; apply codes_are_a_ring; auto; unfold m in *; lia.
Qed.

Lemma period_positive : 0 < period P.
Proof.
  destruct checked as (H & H2 & _); unfold fieldIsRight in H; unfold polynomialIsRight in H2.
  rewrite !andb_true_iff in H; rewrite !andb_true_iff in H2; destruct H as ((((((Q & _) & _) & _) & _) & _) & _).
  destruct H2 as (((((_ & L) & _) & _) & _) & _); apply N.leb_le in Q, L; unfold period.
  enough (2 ^ 1 <= q ^ N.of_nat n) by (rewrite N.pow_1_r in *; lia).
  transitivity (q ^ 1); [now apply N.pow_le_mono_l | apply N.pow_le_mono_r; lia].
Qed.

Lemma sound : primitive P /\ windowsAreDistinct P (mask C).
Proof.
  destruct field_of_P as (F & K & e & all & R & H & OZ & A & size & inj & below & onto).
  destruct checked as (HF & HP & HO & HS & HM & HR).
  pose proof period_positive as some.
  (* Lists of codes as lists of elements. *)
  assert (forall l, Forall (fun a => a < q) l -> exists l', map e l' = l) as lift.
  { induction 1 as [| a l B _ IH]; [now exists [] |]; destruct IH as [l' E].
    destruct (onto a B) as [x Ex]; exists (x :: l'); simpl; now rewrite Ex, E. }
  assert (forall l, areCodes q l = true -> Forall (fun a => a < q) l) as codes.
  { intros l; unfold areCodes; rewrite forallb_forall, Forall_forall; intros B x I; apply N.ltb_lt; auto. }
  assert (forall a b, map e a = map e b -> a = b) as map_inj.
  { induction a as [| x a IH]; intros [| y b]; simpl; try easy; intros [= E E']; f_equal; auto. }
  assert (zero (field P) = 0) as Z0 by (unfold field, gf, coded; simpl; unfold nought;
    induction (removelast _) as [| x l IH]; simpl in *; [easy | rewrite IH; lia]).
  unfold polynomialIsRight in HP; rewrite !andb_true_iff in HP; destruct HP as (((((_ & n1) & _) & hcodes) & _) & _).
  apply N.leb_le in n1; destruct (lift h (codes h hcodes)) as [h' Eh].
  assert (length h' = n) as Lh by (rewrite <- Eh; now rewrite map_length).
  unfold foldIsRight in HS; rewrite !andb_true_iff in HS; destruct HS as ((((Ls & scodes) & nonzero) & area) & fill).
  apply PeanoNat.Nat.eqb_eq in Ls; apply N.eqb_eq in area.
  destruct (lift _ (codes _ scodes)) as [S ES].
  assert (length S = length h') as LS by (rewrite Lh, <- Ls, <- ES; now rewrite map_length).
  assert (S <> nought K h') as SZ.
  { intros E; rewrite E in ES; rewrite (map_nought K (field P) e H) in ES; rewrite <- ES in nonzero.
    apply negb_true_iff in nonzero; rewrite <- not_true_iff_false in nonzero; apply nonzero.
    apply forallb_forall; intros a I; apply in_map_iff in I as (b & <- & _); now rewrite Z0. }
  (* x has order q^n - 1. *)
  unfold orderIsRight in HO; rewrite !andb_true_iff in HO.
  destruct HO as ((((((_ & _) & _) & primes) & whole) & closes) & residues).
  set (powers := map (fun f => fst f) (factors C)).
  rewrite forallb_forall in primes, residues; apply N.eqb_eq in whole; apply same_eq in closes.
  assert (forall d, map e (X K h' d) = rootPower (field P) h d) as EX.
  { intros d; rewrite <- Eh, <- (map_rootPower K (field P) e H), rootPower_X; auto. }
  assert (map e (unit K h') = unit (field P) h) as EU by (now rewrite (map_unit K (field P) e H), Eh).
  assert (X K h' (period P) = unit K h') as closes' by (apply map_inj; now rewrite EX, EU).
  assert (forall d, 0 < d < period P -> X K h' d <> unit K h') as order.
  { apply (order_of_root K R h' (period P) powers).
    - intros f I; apply in_map_iff in I as (g & <- & I); specialize (primes g I).
      rewrite !andb_true_iff in primes; now apply isPrime_prime.
    - rewrite <- whole; unfold powers; now rewrite map_map.
    - exact closes'.
    - intros l x I E; apply in_map_iff in I as ([[l' x'] residue] & [= -> ->] & I).
      specialize (residues _ I); simpl in residues; rewrite andb_true_iff in residues.
      destruct residues as [_ N]; apply negb_true_iff in N.
      rewrite <- EX, E, EU, same_refl in N; easy. }
  assert (Nat.pow (length all) (length h') = Datatypes.S (N.to_nat (period P))) as count.
  { rewrite size, Lh; apply Nnat.Nat2N.inj; rewrite Nnat.Nat2N.inj_succ, Nnat.N2Nat.id, Nnat.Nat2N.inj_pow, Nnat.N2Nat.id.
    unfold period in *; lia. }
  assert (0 < length h')%nat as some' by lia.
  assert (forall d, map e (N.iter d (timesRoot K h') (unit K h')) = powerOfRoot P d) as EI.
  { intros d; unfold powerOfRoot; rewrite <- EU; induction d as [| d IH] using N.peano_ind; [easy |].
    rewrite !N.iter_succ, (map_timesRoot K (field P) e H), IH, Eh; easy. }
  split.
  { split; [| split].
    - rewrite <- EI, <- EU; f_equal; exact closes'.
    - intros d L E; apply (order d L), map_inj; unfold X; now rewrite EI, EU.
    - intros w L B; destruct (lift w B) as [w' <-]; rewrite map_length in L.
      assert (w' = nought K h' \/ w' <> nought K h') as [-> | N].
      { clear - below inj; revert h'; induction w' as [| x w IH]; intros [| y h']; simpl; try (now left); try (now right).
        destruct (IH h') as [-> | N]; [| right; now intros [= _ E]].
        destruct (N.eq_dec (e x) (e (zero K))) as [E | E]; [left; f_equal; now apply inj | right; now intros [= ->]]. }
      + left; rewrite map_length, nought_length; unfold nought; rewrite map_map, (e_zero _ _ _ H), Z0.
        generalize h' as l; induction l as [| y l IH]; simpl; [easy |]; now rewrite IH.
      + right; destruct (nonzero_is_power K R h' all A OZ (period P) count some' closes' order w') as (k & Lk & ->);
          [congruence | exact N |].
        exists k; split; [exact Lk |]; apply EI. }
  (* The terms and the states of the sequence. *)
  assert (forall t, stateAt P t = map e (N.iter t (step K h') S)) as ET.
  { intros t; unfold stateAt; now rewrite (map_iter_step K (field P) e H), Eh, ES. }
  assert (forall t d, term P (t + d) = e (dot K (X K h' d) (N.iter t (step K h') S))) as Term.
  { intros t d; unfold term; rewrite ET, <- term_by_root by auto.
    rewrite <- Z0, <- (e_zero _ _ _ H); now destruct (N.iter (t + d) (step K h') S). }
  assert (forall t, term P t = term P (t mod period P)) as periodic.
  { assert (forall k r, N.iter (r + period P * k) (step K h') S = N.iter r (step K h') S) as loops.
    { induction k as [| k IH] using N.peano_ind; intros r; [now rewrite N.mul_0_r, N.add_0_r |].
      rewrite N.mul_succ_r, N.add_assoc, N.iter_add, (iter_period K R h' (period P) closes' S LS); apply IH. }
    intros t; unfold term; rewrite !ET, <- (loops (t / period P) (t mod period P)).
    replace (t mod period P + period P * (t / period P)) with t; [easy |].
    pose proof (N.div_mod t (period P)); lia. }
  assert (profileFolding P = Diagonal -> N.gcd (profileRows P) (profileColumns P) = 1) as coprime.
  { intros E; rewrite E in fill; now apply N.eqb_eq. }
  (* A window determines the state, and the state determines the position. *)
  unfold rankIsRight in HR; rewrite !andb_true_iff in HR.
  destruct HR as (((((((right & rows) & Lc) & _) & inside) & Li) & icodes) & unit').
  apply PeanoNat.Nat.eqb_eq in Lc, Li; apply sameRows_eq in rows, unit'.
  rewrite forallb_forall in right, inside, icodes.
  assert (forall o, In o (mask C) -> exponentOf P (exponent C o) o) as exponents.
  { intros [i j] I; specialize (right _ I); unfold exponentIsRight in right; unfold exponentOf, exponent in *.
    destruct (profileFolding P); [rewrite andb_true_iff, !N.eqb_eq in right; exact right |].
    simpl fst; simpl snd; rewrite area; now rewrite N.mod_mod by lia. }
  set (vs := map (fun i => X K h' (exponent C (nth (N.to_nat i) (mask C) (0, 0)))) (cells C)).
  assert (map (map e) vs = chosen C) as Evs.
  { unfold vs, chosen; rewrite map_map; apply map_ext_in; intros i I; rewrite EX, rows.
    specialize (inside i I); apply N.ltb_lt in inside.
    rewrite (nth_indep _ [] (rootPower (field P) h (exponent C (0, 0)))) by (rewrite map_length; lia).
    now rewrite (map_nth (fun o => rootPower (field P) h (exponent C o))). }
  assert (exists inv, map (map e) inv = inverse C) as [inv Einv].
  { clear - icodes lift codes; induction (inverse C) as [| row others IH]; [now exists [] |].
    destruct IH as [inv E]; [intros x I; apply icodes; now right |].
    specialize (icodes row (or_introl eq_refl)); rewrite andb_true_iff in icodes.
    destruct (lift row (codes row (proj2 icodes))) as [row' Er]; exists (row' :: inv); simpl; now rewrite Er, E. }
  assert (map (fun row => combination K (length S) row vs) inv = identity K (length S)) as inverts.
  { assert (forall a b, map (map e) a = map (map e) b -> a = b) as map_inj2.
    { induction a as [| x a IH]; intros [| y b]; simpl; try easy; intros [= E E']; f_equal; auto. }
    apply map_inj2; rewrite (map_identity K (field P) e H), map_map.
    rewrite LS, Lh; cbv zeta in unit'; rewrite <- unit', <- Einv, map_map; apply map_ext; intros row.
    now rewrite (map_combination K (field P) e H), Evs. }
  assert (forall t t', t < period P -> t' < period P ->
    map (fun o => term P (t + exponent C o)) (mask C) = map (fun o => term P (t' + exponent C o)) (mask C) -> t = t') as tells.
  { intros t t' Lt Lt' E.
    apply (states_are_distinct K R h' all A OZ (period P) count some' closes' order S t t' LS SZ Lt Lt').
    apply (inverse_decides K R _ _ vs inv).
    - now rewrite !iter_next_length.
    - intros v I; rewrite iter_next_length, LS; unfold vs in I; apply in_map_iff in I as (i & <- & _); now apply X_length.
    - rewrite iter_next_length; exact inverts.
    - unfold vs; rewrite !map_map; apply map_ext_in; intros i I; apply inj; rewrite <- !Term.
      specialize (inside i I); apply N.ltb_lt in inside.
      pose proof (f_equal (fun l => nth (N.to_nat i) l 0) E) as G; cbv beta in G.
      rewrite (nth_indep _ 0 (term P (t + exponent C (0, 0)))) in G by (rewrite map_length; lia).
      rewrite (map_nth (fun o => term P (t + exponent C o))) in G.
      rewrite (nth_indep _ 0 (term P (t' + exponent C (0, 0)))) in G by (rewrite map_length; lia).
      rewrite (map_nth (fun o => term P (t' + exponent C o))) in G; exact G. }
  assert (forall at', In at' (positions P) -> exists t, t < period P /\ place P t = at'
    /\ window P (ownSurface P) (folded P) (mask C) at' = Some (map (fun o => term P (t + exponent C o)) (mask C))) as own.
  { intros [r c] I; destruct (places_fill P Z0 area some coprime periodic (r, c) I) as (t & Lt & Et).
    exists t; split; [exact Lt | split; [exact Et |]].
    apply (own_window P Z0 area some coprime periodic t r c (exponent C) (mask C) Lt Et exponents). }
  unfold maskIsRight in HM; rewrite !andb_true_iff in HM; destruct HM as (_ & surfaces).
  assert (profileSurface P = ownSurface P \/ profileSurface P = Sheet) as surface.
  { unfold ownSurface; destruct (profileSurface P), (profileFolding P); try easy; auto. }
  assert (forall at' w, window P (profileSurface P) (folded P) (mask C) at' = Some w ->
    window P (ownSurface P) (folded P) (mask C) at' = Some w) as toOwn.
  { intros at' w W; destruct surface as [E | E]; rewrite E in W; [exact W |].
    apply (sheet_window P Z0 area some coprime); exact W. }
  assert (forall a b w, In a (positions P) -> In b (positions P) ->
    window P (profileSurface P) (folded P) (mask C) a = Some w ->
    window P (profileSurface P) (folded P) (mask C) b = Some w -> a = b) as distinct.
  { intros a b w Ia Ib Wa Wb; apply toOwn in Wa, Wb.
    destruct (own a Ia) as (t & Lt & <- & Wt), (own b Ib) as (t' & Lt' & <- & Wt').
    f_equal; apply tells; auto; congruence. }
  split; [| split; [exact distinct |]].
  - unfold windows; apply parts_distinct; [now apply positions_distinct | exact distinct].
  - intros N; destruct surface as [E | E]; [| easy]; rewrite E; unfold windows.
    assert (forall l, incl l (positions P) -> length (flat_map (fun a =>
      match window P (ownSurface P) (folded P) (mask C) a with Some w => [(a, w)] | None => [] end) l) = length l) as L.
    { induction l as [| a l IH]; intros I; [easy |]; simpl.
      destruct (own a (I a (or_introl eq_refl))) as (t & _ & _ & ->); simpl; rewrite IH; [easy |].
      intros b J; apply I; now right. }
    apply L, incl_refl.
Qed.
End Sound.

(* T10. If the checker accepts a certificate, its polynomial is primitive and its windows are
   distinct. *)
Theorem certificate_sound (C : certificate) : check C = true ->
  primitive (claimed C) /\ windowsAreDistinct (claimed C) (mask C).
Proof. apply sound. Qed.
