(* An executable checker of the certificates that `pra-tactile certificate --rank` writes.

   Certificate.v proves that it is sound. PraTactile.Certificate.Check and data/check_certificate.py
   check the same claims. This checker shows primes by trial division, so it refuses a certificate
   with a prime of 2^34 or more. It does not check the seal. *)
From Coq Require Import NArith List Bool.
From PraTactile Require Import Exec Grid.
Import ListNotations.
Local Open Scope N_scope.

(* The parts of a certificate, as in PraTactile.Certificate. A factor of q^n - 1 is a prime l, its
   exponent, and x^((q^n - 1) / l). A proof that r is prime lists prime factors of r - 1, each with
   its exponent and a base. *)
Record certificate := Certificate
  { claimed : profile; claimedWindow : N * N; mask : list (N * N); claimedWindows : N; claimedPeriod : N;
    factors : list (N * N * list N); primes : list (N * list (N * N * N));
    vectors : list (list N); cells : list N; inverse : list (list N) }.

(* Trial division by all numbers up to the square root, and by some larger ones. *)
Definition isPrime (l : N) : bool :=
  (2 <=? l) && (l <? 2 ^ 34)
  && forallb (fun d => (l <=? d) || negb (l mod d =? 0)) (skipn 2 (upTo (2 ^ (N.size l / 2 + 1)))).

Definition areCodes (q : N) (a : list N) : bool := forallb (fun x => x <? q) a.

Definition hasLength {A} (n : nat) (a : list A) : bool := Nat.eqb (length a) n.

(* The linear combination c_1 v_1 + c_2 v_2 + ... of vectors of length n. *)
Fixpoint combination {T} (K : arithmetic T) (n : nat) (cs : list T) (vs : list (list T)) : list T :=
  match cs, vs with
  | c :: cs', v :: vs' => plus K (scale K c v) (combination K n cs' vs')
  | _, _ => repeat (zero K) n
  end.

Fixpoint identity {T} (K : arithmetic T) (n : nat) : list (list T) :=
  match n with
  | O => []
  | S n' => (one K :: repeat (zero K) n') :: map (cons (zero K)) (identity K n')
  end.

Fixpoint sameRows (a b : list (list N)) : bool :=
  match a, b with
  | [], [] => true
  | x :: a', y :: b' => same x y && sameRows a' b'
  | _, _ => false
  end.

Fixpoint ascending (a : list N) : bool :=
  match a with x :: (y :: _) as a' => (x <? y) && ascending a' | _ => true end.

Section Of.
Variable C : certificate.
Let P := claimed C.
Let q := profileOrder P.
Let K := field P.
Let h := lower P.
Let n := length h.
Let n1 := profileRows P.
Let n2 := profileColumns P.

(* The field GF(p^m) has at most 256 elements. Its modulus, of degree m, and the polynomial h over
   it, of degree n, are monic. *)
Definition fieldIsRight : bool :=
  let p := characteristicOf q in
  let m := pred (length (profileModulus P)) in
  (2 <=? q) && (q <=? 256) && (1 <=? N.of_nat m) && (N.of_nat m <=? 8) && (p ^ N.of_nat m =? q)
  && areCodes p (profileModulus P) && (last (profileModulus P) 0 =? 1).

Definition polynomialIsRight : bool :=
  hasLength (S n) (profilePolynomial P) && (1 <=? N.of_nat n) && areCodes q (profilePolynomial P) && areCodes q h
  && (last (profilePolynomial P) 0 =? 1) && negb (hd 0 (profilePolynomial P) =? 0).

(* Modulo h, x^(q^n - 1) is 1, and x^((q^n - 1) / l) is not 1 for any prime l that divides
   q^n - 1. *)
Definition orderIsRight : bool :=
  (claimedPeriod C =? period P)
  && forallb (fun shown => isPrime (fst shown)) (primes C)
  && ascending (map (fun f => fst (fst f)) (factors C))
  && forallb (fun f => isPrime (fst (fst f)) && (1 <=? snd (fst f)) && (snd (fst f) <? 4096)) (factors C)
  && (fold_right N.mul 1 (map (fun f => fst (fst f) ^ snd (fst f)) (factors C)) =? period P)
  && same (rootPower K h (period P)) (unit K h)
  && forallb (fun f => let residue := rootPower K h (period P / fst (fst f)) in
       same residue (snd f) && negb (same residue (unit K h))) (factors C).

Definition foldIsRight : bool :=
  hasLength n (profileState P) && areCodes q (profileState P) && negb (forallb (fun a => a =? 0) (profileState P))
  && (n1 * n2 =? period P)
  && match profileFolding P with Diagonal => N.gcd n1 n2 =? 1 | RowMajor => true end.

(* The window is the mask's bounding rectangle, the surface is the fold's own or the sheet, and the
   number of windows is the number of positions at which the rectangle lies on that surface. *)
Definition maskIsRight : bool :=
  let high := fold_right N.max 0 (map (fun at' => fst at' + 1) (mask C)) in
  let wide := fold_right N.max 0 (map (fun at' => snd at' + 1) (mask C)) in
  let seen := match profileSurface P with Sheet => (n1 + 1 - high) * (n2 + 1 - wide) | _ => n1 * n2 end in
  (different (map (fun at' => [fst at'; snd at']) (mask C)) =? N.of_nat (length (mask C)))
  && samePlace (claimedWindow C) (high, wide) && (1 <=? seen) && (claimedWindows C =? seen)
  && match profileSurface P, profileFolding P with
     | Torus, Diagonal | TwistedTorus, RowMajor | Sheet, _ => true
     | _, _ => false
     end.

(* The inverse of a modulo b by Euclid's algorithm, keeping r = t a modulo b. Nothing relies on its
   correctness, because exponentIsRight checks what is computed from it. *)
Fixpoint inverseBy (steps : nat) (b r r' t t' : N) : N :=
  match steps with
  | O => t
  | S steps' => if r' =? 0 then t else inverseBy steps' b r' (r mod r') t' ((t + (b - (r / r' * t') mod b)) mod b)
  end.

(* The exponent e of the cell (i, j). Along the diagonal e = i modulo n1 and e = j modulo n2; row by
   row e = n2 i + j. *)
Definition exponent (offset : N * N) : N :=
  let (i, j) := offset in
  match profileFolding P with
  | RowMajor => (n2 * i + j) mod (n1 * n2)
  | Diagonal =>
    let u := inverseBy (N.to_nat (2 * N.size n1 + 2)) n1 n1 (n2 mod n1) 0 1 in
    j mod n2 + n2 * ((u * (i + n1 * n2 - j mod n2)) mod n1)
  end.

Definition exponentIsRight (offset : N * N) : bool :=
  match profileFolding P with
  | RowMajor => true
  | Diagonal => (exponent offset mod n1 =? fst offset mod n1) && (exponent offset mod n2 =? snd offset mod n2)
  end.

Definition chosen : list (list N) := map (fun i => nth (N.to_nat i) (vectors C) []) (cells C).

Definition rankIsRight : bool :=
  forallb exponentIsRight (mask C)
  && sameRows (vectors C) (map (fun offset => rootPower K h (exponent offset)) (mask C))
  && hasLength n (cells C) && ascending (cells C) && forallb (fun i => i <? N.of_nat (length (mask C))) (cells C)
  && hasLength n (inverse C) && forallb (fun row => hasLength n row && areCodes q row) (inverse C)
  && sameRows (map (fun row => combination K n row chosen) (inverse C)) (identity K n).

Definition check : bool :=
  fieldIsRight && polynomialIsRight && orderIsRight && foldIsRight && maskIsRight && rankIsRight.
End Of.
