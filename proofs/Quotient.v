(* Polynomials modulo a monic polynomial form a commutative ring, if their coefficients do.

   The functions are those of Exec.v. PraTactile.Field and PraTactile.Extension rely on this file,
   for GF(p^m) and GF(q)[x]/h. *)
From Coq Require Import NArith List Bool Ring Lia.
From PraTactile Require Import Exec.
Import ListNotations.

(* The laws of a commutative ring. *)
Notation isRing K := (ring_theory (zero K) (one K) (add K) (mul K) (fun a b => add K a (neg K b)) (neg K) eq).

Section Quotient.
Context {T : Type} (K : arithmetic T).
Hypothesis R : isRing K.
Add Ring ring : R.
Variable lower : list T.
Implicit Types a b : list T.

Notation "0" := (zero K).
Notation n := (length lower).
Notation M := (timesRoot K lower).
Notation "a + b" := (add K a b).
Notation "a * b" := (mul K a b).
Notation "a [+] b" := (plus K a b) (at level 50, left associativity).
Notation "c .* a" := (scale K c a) (at level 40, left associativity).
Notation "a [*] b" := (product K lower a b) (at level 40, left associativity).

(* Lists as vectors. *)
Lemma plus_length a b : length a = length b -> length (a [+] b) = length b.
Proof. revert b; induction a as [| x a IH]; intros [| y b]; simpl; try easy; intros [= E]; now rewrite IH. Qed.
Lemma scale_length c a : length (c .* a) = length a.
Proof. apply map_length. Qed.
Lemma shift_length x a : length (shift x a) = length a.
Proof. revert x; induction a as [| y a IH]; simpl; [easy | intros; now rewrite IH]. Qed.
Lemma nought_length a : length (nought K a) = length a.
Proof. apply map_length. Qed.
Lemma M_length a : length a = n -> length (M a) = n.
Proof. intros E; unfold timesRoot; rewrite plus_length; rewrite scale_length; [| rewrite shift_length]; easy. Qed.
Lemma product_length a b : length a = n -> length (a [*] b) = n.
Proof.
  intros E; induction b as [| c b IH]; simpl; [now rewrite nought_length |].
  rewrite plus_length; rewrite ?scale_length; rewrite M_length; easy.
Qed.
Lemma unit_length : length (unit K lower) = n.
Proof. destruct lower; simpl; [easy | now rewrite nought_length]. Qed.

Lemma plus_comm a b : a [+] b = b [+] a.
Proof. revert b; induction a as [| x a IH]; intros [| y b]; simpl; try easy; f_equal; [ring | apply IH]. Qed.
Lemma plus_assoc a b c : a [+] (b [+] c) = a [+] b [+] c.
Proof. revert b c; induction a as [| x a IH]; intros [| y b] [| z c]; simpl; try easy; f_equal; [ring | apply IH]. Qed.
Lemma plus_cross a b c d : (a [+] b) [+] (c [+] d) = (a [+] c) [+] (b [+] d).
Proof. rewrite <- !plus_assoc; f_equal; rewrite !plus_assoc; f_equal; apply plus_comm. Qed.
Lemma plus_nought a b : length a = length b -> nought K b [+] a = a.
Proof. revert b; induction a as [| x a IH]; intros [| y b]; simpl; try easy; intros [= E]; f_equal; [ring | auto]. Qed.
Lemma plus_neg a : a [+] map (neg K) a = nought K a.
Proof. induction a as [| x a IH]; simpl; [easy | f_equal; [ring | exact IH]]. Qed.
Lemma scale_plus c a b : c .* (a [+] b) = c .* a [+] c .* b.
Proof. revert b; induction a as [| x a IH]; intros [| y b]; simpl; try easy; f_equal; [ring | apply IH]. Qed.
Lemma scale_add c d a : (c + d) .* a = c .* a [+] d .* a.
Proof. induction a as [| x a IH]; simpl; [easy | f_equal; [ring | exact IH]]. Qed.
Lemma scale_mul c d a : c .* (d .* a) = (c * d) .* a.
Proof. induction a as [| x a IH]; simpl; [easy | f_equal; [ring | exact IH]]. Qed.
Lemma scale_zero a : 0 .* a = nought K a.
Proof. induction a as [| x a IH]; simpl; [easy | f_equal; [ring | exact IH]]. Qed.
Lemma scale_nought c a : c .* nought K a = nought K a.
Proof. induction a as [| x a IH]; simpl; [easy | f_equal; [ring | exact IH]]. Qed.
Lemma nought_same a b : length a = length b -> nought K a = nought K b.
Proof. revert b; induction a as [| x a IH]; intros [| y b]; simpl; try easy; intros [= E]; f_equal; auto. Qed.

(* Multiplication by x is linear. *)
Lemma shift_plus x y a b : length a = length b -> shift (x + y) (a [+] b) = shift x a [+] shift y b.
Proof. revert x y b; induction a as [| z a IH]; intros x y [| w b]; simpl; try easy; intros [= E]; f_equal; auto. Qed.
Lemma shift_scale c x a : shift (c * x) (c .* a) = c .* shift x a.
Proof. revert x; induction a as [| z a IH]; intros x; simpl; [easy | f_equal; apply IH]. Qed.
Lemma last_plus a b : length a = length b -> last (a [+] b) 0 = last a 0 + last b 0.
Proof.
  revert b; induction a as [| x a IH]; intros [| y b]; simpl plus; try easy; [intros _; simpl; ring |].
  intros [= E]; destruct a as [| x' a], b as [| y' b]; simpl in E; try easy.
  change (last (x :: x' :: a) 0) with (last (x' :: a) 0); change (last (y :: y' :: b) 0) with (last (y' :: b) 0).
  rewrite <- IH; [easy | simpl; now rewrite E].
Qed.
Lemma last_scale c a : last (c .* a) 0 = c * last a 0.
Proof.
  induction a as [| x a IH]; [simpl; ring |].
  destruct a as [| x' a]; [easy |]; change (last (x :: x' :: a) 0) with (last (x' :: a) 0); now rewrite <- IH.
Qed.
Lemma M_plus a b : length a = length b -> M (a [+] b) = M a [+] M b.
Proof.
  intros E; unfold timesRoot; rewrite last_plus by easy; rewrite plus_cross; f_equal.
  - rewrite <- shift_plus by easy; f_equal; ring.
  - rewrite <- scale_add; f_equal; ring.
Qed.
Lemma M_scale c a : M (c .* a) = c .* M a.
Proof.
  unfold timesRoot; rewrite last_scale, scale_plus, scale_mul; f_equal.
  - rewrite <- shift_scale; f_equal; ring.
  - f_equal; ring.
Qed.
Lemma M_nought a : length a = n -> M (nought K a) = nought K lower.
Proof.
  intros E; rewrite <- scale_zero, M_scale, scale_zero by easy; apply nought_same; now apply M_length.
Qed.

(* The product is linear in both factors, and commutes with multiplication by x. *)
Lemma product_plus a b c : length a = n -> length b = n -> (a [+] b) [*] c = a [*] c [+] b [*] c.
Proof.
  intros A B; induction c as [| x c IH]; simpl.
  - rewrite <- (scale_zero a), <- (scale_zero b), <- scale_plus, scale_zero; easy.
  - rewrite IH, scale_plus, M_plus by now rewrite !product_length.
    apply plus_cross.
Qed.
Lemma product_scale d a c : length a = n -> (d .* a) [*] c = d .* (a [*] c).
Proof.
  intros A; induction c as [| x c IH]; simpl.
  - rewrite scale_nought; apply nought_same; apply scale_length.
  - rewrite IH, M_scale, scale_plus, !scale_mul; f_equal; f_equal; ring.
Qed.
Lemma product_M a c : length a = n -> M a [*] c = M (a [*] c).
Proof.
  intros A; induction c as [| x c IH]; simpl.
  - rewrite M_nought by easy; apply nought_same; now apply M_length.
  - rewrite IH, (M_plus (x .* a)), M_scale; [easy |].
    now rewrite scale_length, M_length; [| apply product_length].
Qed.
Lemma product_swap a b c : length a = n -> a [*] b [*] c = a [*] c [*] b.
Proof.
  intros A; induction c as [| x c IH]; simpl.
  - assert (product K lower (nought K a) b = 0 .* (a [*] b)) as ->.
    { rewrite <- product_scale by easy; now rewrite scale_zero. }
    now rewrite scale_zero.
  - rewrite product_plus, product_scale, product_M, IH; rewrite ?scale_length, ?M_length;
      try apply product_length; try easy; now apply M_length, product_length.
Qed.

(* 1 b = b, because Horner's rule puts the coefficients of b in place one by one. *)
Lemma shift_zeros b k : shift 0 (b ++ repeat 0 (S k)) = 0 :: b ++ repeat 0 k.
Proof.
  enough (forall x, shift x (b ++ repeat 0 (S k)) = x :: b ++ repeat 0 k) by easy.
  induction b as [| y b IH]; intros x; simpl; [| now rewrite <- IH].
  f_equal; revert x; induction k as [| k IHk]; intros x; simpl; [easy |]; now rewrite IHk.
Qed.
Lemma last_zeros b k : last (b ++ repeat 0 (S k)) 0 = 0.
Proof.
  change (repeat 0 (S k)) with (0 :: repeat 0 k); rewrite repeat_cons.
  now rewrite app_assoc, last_last.
Qed.
Lemma nought_repeat a : nought K a = repeat 0 (length a).
Proof. induction a as [| x a IH]; simpl; [easy | f_equal; exact IH]. Qed.
Lemma unit_product_zeros b : length b <= n -> unit K lower [*] b = b ++ repeat 0 (n - length b).
Proof.
  induction b as [| c b IH]; intros L.
  - simpl; rewrite nought_repeat, unit_length; f_equal; lia.
  - simpl product; simpl in L; rewrite IH by lia; unfold timesRoot.
    replace (n - length b) with (S (n - length (c :: b))) by (simpl; lia).
    set (k := n - length (c :: b)); rewrite shift_zeros, last_zeros.
    replace (neg K 0) with 0 by ring.
    rewrite scale_zero, (plus_comm (0 :: b ++ repeat 0 k)), plus_nought
      by (simpl; rewrite app_length, repeat_length; unfold k; simpl; lia).
    assert (c .* unit K lower = c :: repeat 0 (length b + k)) as ->.
    { unfold k; destruct lower as [| y rest]; simpl in *; [lia |]; rewrite scale_nought, nought_repeat.
      f_equal; [ring | f_equal; lia]. }
    simpl; f_equal; [ring |].
    rewrite <- (plus_nought (b ++ repeat 0 k) (b ++ repeat 0 k)) at 2 by easy.
    f_equal; rewrite nought_repeat, app_length, repeat_length; easy.
Qed.
Lemma product_unit_l b : length b = n -> unit K lower [*] b = b.
Proof. intros E; rewrite unit_product_zeros, E by lia; rewrite PeanoNat.Nat.sub_diag; apply app_nil_r. Qed.

Lemma product_comm a b : length a = n -> length b = n -> a [*] b = b [*] a.
Proof.
  intros A B; rewrite <- (product_unit_l a A) at 1; rewrite <- (product_unit_l b B) at 2.
  apply product_swap, unit_length.
Qed.
Lemma product_assoc a b c : length a = n -> length b = n -> length c = n -> a [*] (b [*] c) = a [*] b [*] c.
Proof.
  intros A B C; assert (length (b [*] c) = n) as L by now apply product_length.
  rewrite (product_comm a (b [*] c)), (product_comm a b), (product_swap b c a) by easy; easy.
Qed.
End Quotient.
