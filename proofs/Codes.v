(* The codes 0, ..., p^m - 1 with the operations of Exec.gf are a commutative ring, for any monic
   modulus of degree m.

   The proofs about certificates need no more: that the ring is a field follows from the q^n - 1
   powers of x. PraTactile.Field has the same codes. *)
From Coq Require Import NArith List Bool Lia Eqdep_dec Ring_theory.
From PraTactile Require Import Exec Quotient Checker Primes Maps.
Import ListNotations.
Local Open Scope N_scope.

(* Digits to codes and back. *)
Lemma digits_length p m a : length (digits p m a) = m.
Proof. revert a; induction m as [| m IH]; intros a; simpl; [easy | now rewrite IH]. Qed.
Lemma digits_below p m a : 2 <= p -> Forall (fun d => d < p) (digits p m a).
Proof. intros L; revert a; induction m as [| m IH]; intros a; simpl; constructor; auto; apply N.mod_lt; lia. Qed.
Lemma digits_code p m ds : length ds = m -> Forall (fun d => d < p) ds -> digits p m (code p ds) = ds.
Proof.
  intros <-; induction 1 as [| d ds D _ IH]; simpl; [easy |]; f_equal.
  - rewrite N.add_comm, N.mul_comm, N.add_comm, N.mod_add, N.mod_small; lia.
  - rewrite (N.mul_comm p), N.div_add, N.div_small, N.add_0_l by lia; exact IH.
Qed.
Lemma code_digits p m a : 2 <= p -> a < p ^ N.of_nat m -> code p (digits p m a) = a.
Proof.
  intros L; revert a; induction m as [| m IH]; intros a A; simpl.
  - simpl in A; lia.
  - rewrite IH; [pose proof (N.div_mod a p); lia |].
    rewrite Nnat.Nat2N.inj_succ, N.pow_succ_r' in A; apply N.div_lt_upper_bound; lia.
Qed.
Lemma code_below p m ds : 2 <= p -> length ds = m -> Forall (fun d => d < p) ds -> code p ds < p ^ N.of_nat m.
Proof.
  intros L <-; induction 1 as [| d ds D _ IH]; simpl length; simpl code; [simpl; lia |].
  rewrite Nnat.Nat2N.inj_succ, N.pow_succ_r'; nia.
Qed.

Section Sub.
Context {A : Type} (f : A -> bool).
Lemma sub_eq (x y : {a : A | f a = true}) : proj1_sig x = proj1_sig y -> x = y.
Proof. destruct x as [a E], y as [b F]; simpl; intros ->; f_equal; apply UIP_dec, bool_dec. Qed.
End Sub.

Section Integers.
Variable p : N.
Hypothesis two : 2 <= p.
Definition residue := {a : N | (a <? p) = true}.
Lemma mod_below a : (a mod p <? p) = true.
Proof. apply N.ltb_lt, N.mod_lt; lia. Qed.
Definition residueOf (a : N) : residue := exist _ (a mod p) (mod_below a).
Lemma residue_small (x : residue) : proj1_sig x mod p = proj1_sig x.
Proof. destruct x as [a E]; simpl; apply N.mod_small, N.ltb_lt, E. Qed.
Notation v := (@proj1_sig _ _).
Definition residues : arithmetic residue :=
  Arithmetic (residueOf 0) (residueOf 1) (fun x y => residueOf (v x + v y)) (fun x => residueOf (p - v x))
    (fun x y => residueOf (v x * v y)).
Lemma residues_ring : isRing residues.
Proof.
  constructor; intros; apply sub_eq; simpl; rewrite ?N.mod_0_l, ?(N.mod_small 1) by lia.
  - apply residue_small.
  - f_equal; lia.
  - rewrite N.add_mod_idemp_l, N.add_mod_idemp_r by lia; f_equal; lia.
  - rewrite ?N.mul_1_l; apply residue_small.
  - f_equal; lia.
  - rewrite N.mul_mod_idemp_l, N.mul_mod_idemp_r by lia; f_equal; lia.
  - rewrite N.mul_mod_idemp_l, N.add_mod_idemp_l, N.add_mod_idemp_r by lia; f_equal; lia.
  - easy.
  - rewrite N.add_mod_idemp_r by lia; destruct x as [a E]; simpl; apply N.ltb_lt in E.
    replace (a + (p - a)) with p by lia; apply N.mod_same; lia.
Qed.
Lemma residues_respect : respects residues (integersModulo p) v.
Proof. constructor; simpl; intros; rewrite ?N.mod_0_l, ?(N.mod_small 1); try lia. Qed.

Section Field.
Variable lower : list N.
Notation m := (length lower).
Hypothesis below : Forall (fun d => d < p) lower.
Hypothesis some : (0 < m)%nat.

Definition low : list residue := map residueOf lower.
Lemma v_residueOf ds : Forall (fun d => d < p) ds -> map v (map residueOf ds) = ds.
Proof. induction 1 as [| d ds D _ IH]; simpl; [easy |]; rewrite IH, N.mod_small; easy. Qed.
Lemma low_length : length low = m.
Proof. apply map_length. Qed.

Definition element := {a : list residue | Nat.eqb (length a) m = true}.
Lemma lengths (x : element) : length (v x) = length low.
Proof. destruct x as [a E]; simpl; rewrite low_length; now apply PeanoNat.Nat.eqb_eq. Qed.
Definition elementOf (a : list residue) (E : length a = length low) : element.
Proof. refine (exist _ a _); rewrite E, low_length; apply PeanoNat.Nat.eqb_refl. Defined.
Notation R := residues_ring.
Definition sum (x y : element) := elementOf (plus residues (v x) (v y))
  (eq_trans (plus_length residues _ _ (eq_trans (lengths x) (eq_sym (lengths y)))) (lengths y)).
Definition opposite (x : element) := elementOf (map (neg residues) (v x)) (eq_trans (map_length _ _) (lengths x)).
Definition times (x y : element) := elementOf (product residues low (v x) (v y))
  (product_length residues low _ _ (lengths x)).
Definition elements : arithmetic element :=
  Arithmetic (elementOf (nought residues low) (nought_length residues low))
    (elementOf (unit residues low) (unit_length residues low)) sum opposite times.
Lemma elements_ring : isRing elements.
Proof.
  constructor; intros; apply sub_eq; simpl.
  - apply plus_nought, lengths; exact R.
  - apply plus_comm; exact R.
  - apply plus_assoc; exact R.
  - apply product_unit_l, lengths; exact R.
  - apply product_comm; try apply lengths; exact R.
  - apply product_assoc; try apply lengths; exact R.
  - apply product_plus; try apply lengths; exact R.
  - reflexivity.
  - transitivity (nought residues (v x)); [apply (plus_neg residues R) | apply nought_same, lengths].
Qed.

Definition e (x : element) : N := code p (map v (v x)).
Lemma v_below (a : list residue) : Forall (fun d => d < p) (map v a).
Proof. induction a as [| [d E] a IH]; simpl; constructor; [now apply N.ltb_lt | exact IH]. Qed.
Lemma digits_e (x : element) : digits p m (e x) = map v (v x).
Proof.
  apply digits_code; [now rewrite map_length, lengths, low_length | apply v_below].
Qed.
Lemma e_respects : respects elements (coded p m (polynomials (integersModulo p) lower)) e.
Proof.
  assert (@map residue N v low = lower) as E by now apply v_residueOf.
  pose proof residues_respect as H.
  constructor; intros; cbn [coded polynomials zero one add neg mul]; rewrite ?digits_e.
  - change (code p (map v (nought residues low)) = code p (nought (integersModulo p) lower)).
    now rewrite (map_nought _ _ _ H), E.
  - change (code p (map v (unit residues low)) = code p (unit (integersModulo p) lower)).
    now rewrite (map_unit _ _ _ H), E.
  - change (code p (map v (plus residues (v a) (v b))) = code p (plus (integersModulo p) (map v (v a)) (map v (v b)))).
    now rewrite (map_plus _ _ _ H).
  - change (code p (map v (map (neg residues) (v a))) = code p (map (neg (integersModulo p)) (map v (v a)))).
    now rewrite (map_negs _ _ _ H).
  - change (code p (map v (product residues low (v a) (v b)))
      = code p (product (integersModulo p) lower (map v (v a)) (map v (v b)))).
    now rewrite (map_product _ _ _ H), E.
Qed.
Lemma map_v_injective (a b : list residue) : map v a = map v b -> a = b.
Proof.
  revert b; induction a as [| x a IH]; intros [| y b]; simpl; try easy; intros [= E F].
  f_equal; [now apply sub_eq | now apply IH].
Qed.
Lemma e_injective x y : e x = e y -> x = y.
Proof. intros E; apply sub_eq, map_v_injective; now rewrite <- !digits_e, E. Qed.
Lemma e_below x : e x < p ^ N.of_nat m.
Proof.
  apply code_below; [exact two | now rewrite map_length, lengths, low_length | apply v_below].
Qed.
Definition decoded (a : N) : element.
Proof.
  refine (elementOf (map residueOf (digits p m a)) _).
  now rewrite map_length, digits_length, low_length.
Defined.
Lemma e_decoded a : a < p ^ N.of_nat m -> e (decoded a) = a.
Proof. intros L; unfold e; simpl; rewrite v_residueOf by (now apply digits_below); now apply code_digits. Qed.
Lemma one_zero : one elements <> zero elements.
Proof.
  intros E; apply (f_equal (fun x => map v (v x))) in E; simpl in E; unfold low in E.
  destruct lower as [| d ds]; [simpl in some; lia |].
  simpl in E; injection E; rewrite N.mod_0_l, N.mod_small; lia.
Qed.
End Field.
End Integers.

(* With the operations of gf, the codes below p^m are a commutative ring. *)
Theorem codes_are_a_ring p modulus m : 2 <= p -> length modulus = S m -> (0 < m)%nat -> areCodes p modulus = true ->
  exists (F : Type) (K : arithmetic F) (e : F -> N) (all : list F),
    isRing K /\ respects K (gf p modulus) e /\ one K <> zero K /\ (forall x, In x all)
    /\ length all = N.to_nat (p ^ N.of_nat m) /\ (forall x y, e x = e y -> x = y)
    /\ (forall x, e x < p ^ N.of_nat m) /\ (forall a, a < p ^ N.of_nat m -> exists x, e x = a).
Proof.
  intros two E some B; set (low' := removelast modulus).
  assert (modulus = low' ++ [last modulus 0]) as D by (apply app_removelast_last; now destruct modulus).
  assert (length low' = m) as L.
  { rewrite D in E; rewrite app_length in E; simpl in E; lia. }
  assert (Forall (fun d => d < p) low') as Low.
  { unfold areCodes in B; rewrite forallb_forall in B; apply Forall_forall; intros x I; apply N.ltb_lt, B.
    rewrite D; apply in_or_app; now left. }
  exists (element p low'), (elements p two low'), (e p low'), (map (decoded p two low') (upTo (p ^ N.of_nat m))).
  rewrite <- L in *.
  repeat split; try (unfold gf; rewrite E; simpl pred; apply e_respects; auto).
  - apply elements_ring.
  - apply elements_ring.
  - apply elements_ring.
  - apply elements_ring.
  - apply elements_ring.
  - apply elements_ring.
  - apply elements_ring.
  - apply elements_ring.
  - now apply one_zero.
  - intros x; apply in_map_iff; exists (e p low' x); split; [| apply in_upTo, e_below; auto].
    apply e_injective; auto; apply e_decoded; auto; apply e_below; auto.
  - unfold upTo; now rewrite !map_length, seq_length.
  - apply e_injective; auto.
  - intros x; apply e_below; auto.
  - intros a A; exists (decoded p two low' a); now apply e_decoded.
Qed.
