(* A map between two arithmetics that respects the operations also respects every function of
   Exec.v.

   So a theorem about a field's elements is a theorem about their codes, which PraTactile.Field and
   the conformance protocol use. *)
From Coq Require Import NArith List.
From PraTactile Require Import Exec Checker.
Import ListNotations.

(* Maps that respect the operations, and the functions on lists under such maps. *)
Record respects {T U} (K : arithmetic T) (L : arithmetic U) (e : T -> U) : Prop :=
  { e_zero : e (zero K) = zero L; e_one : e (one K) = one L; e_add : forall a b, e (add K a b) = add L (e a) (e b);
    e_neg : forall a, e (neg K a) = neg L (e a); e_mul : forall a b, e (mul K a b) = mul L (e a) (e b) }.

Section Respects.
Context {T U} (K : arithmetic T) (L : arithmetic U) (e : T -> U) (H : respects K L e).

Lemma map_plus a b : map e (plus K a b) = plus L (map e a) (map e b).
Proof. revert b; induction a as [| x a IH]; intros [| y b]; simpl; try easy; now rewrite (e_add _ _ _ H), IH. Qed.
Lemma map_scale c a : map e (scale K c a) = scale L (e c) (map e a).
Proof. induction a as [| x a IH]; simpl; [easy |]; now rewrite (e_mul _ _ _ H), IH. Qed.
Lemma map_nought a : map e (nought K a) = nought L (map e a).
Proof. induction a as [| x a IH]; simpl; [easy |]; now rewrite (e_zero _ _ _ H), IH. Qed.
Lemma map_negs a : map e (map (neg K) a) = map (neg L) (map e a).
Proof. induction a as [| x a IH]; simpl; [easy |]; now rewrite (e_neg _ _ _ H), IH. Qed.
Lemma map_shift x a : map e (shift x a) = shift (e x) (map e a).
Proof. revert x; induction a as [| y a IH]; intros x; simpl; [easy |]; now rewrite IH. Qed.
Lemma map_last x a : e (last a x) = last (map e a) (e x).
Proof. induction a as [| y [| z a] IH]; try easy; exact IH. Qed.
Lemma map_unit a : map e (unit K a) = unit L (map e a).
Proof. destruct a; simpl; [easy |]; now rewrite (e_one _ _ _ H), map_nought. Qed.
Lemma map_timesRoot lower a : map e (timesRoot K lower a) = timesRoot L (map e lower) (map e a).
Proof.
  unfold timesRoot; now rewrite map_plus, map_shift, map_scale, (e_neg _ _ _ H), map_last, (e_zero _ _ _ H).
Qed.
Lemma map_product lower a b : map e (product K lower a b) = product L (map e lower) (map e a) (map e b).
Proof.
  induction b as [| x b IH]; simpl; [apply map_nought |]; now rewrite map_plus, map_scale, map_timesRoot, IH.
Qed.
Lemma map_raised lower d : forall a, map e (raised K lower a d) = raised L (map e lower) (map e a) d.
Proof. induction d as [d IH | d IH |]; intros a; simpl; rewrite ?map_product, ?IH, ?map_product; easy. Qed.
Lemma map_rootPower lower d : map e (rootPower K lower d) = rootPower L (map e lower) d.
Proof. destruct d; simpl; rewrite ?map_raised, ?map_timesRoot, map_unit; easy. Qed.
Lemma map_dot a b : e (dot K a b) = dot L (map e a) (map e b).
Proof.
  revert b; induction a as [| x a IH]; intros [| y b]; simpl; rewrite ?(e_zero _ _ _ H); try easy.
  now rewrite (e_add _ _ _ H), (e_mul _ _ _ H), IH.
Qed.
Lemma map_step lower a : map e (step K lower a) = step L (map e lower) (map e a).
Proof. destruct a as [| x a]; [easy |]; unfold step; now rewrite map_app; simpl map; rewrite (e_neg _ _ _ H), map_dot. Qed.
Lemma map_iter_step lower d a : map e (N.iter d (step K lower) a) = N.iter d (step L (map e lower)) (map e a).
Proof. induction d as [| d IH] using N.peano_ind; [easy |]; now rewrite !N.iter_succ, map_step, IH. Qed.
Lemma map_repeat x k : map e (repeat x k) = repeat (e x) k.
Proof. induction k as [| k IH]; simpl; [easy | now rewrite IH]. Qed.
Lemma map_combination k vs : forall cs,
  map e (combination K k cs vs) = combination L k (map e cs) (map (map e) vs).
Proof.
  induction vs as [| v vs IH]; intros [| c cs]; simpl; rewrite ?map_repeat, ?(e_zero _ _ _ H); try easy.
  now rewrite map_plus, map_scale, IH.
Qed.
Lemma map_identity k : map (map e) (identity K k) = identity L k.
Proof.
  induction k as [| k IH]; simpl; [easy |]; rewrite (e_one _ _ _ H), map_repeat, (e_zero _ _ _ H), <- IH, !map_map; f_equal.
  apply map_ext; intros a; simpl; now rewrite (e_zero _ _ _ H).
Qed.
End Respects.
