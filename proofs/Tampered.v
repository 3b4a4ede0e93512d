(* The checker refuses false certificates. Each is the paper's with one claim changed, and the
   kernel runs the checker on it.

   The tests change the certificates of the library in the same ways; the folder
   test/Test/Code/Certificate has more. *)
From Coq Require Import NArith List Bool.
From PraTactile Require Import Exec Grid Checker Certificates.
Import ListNotations.
Local Open Scope N_scope.

Definition genuine : certificate := Eval vm_compute in
  hd (Certificate (Profile 0 [] [] Characteristic [] 0 0 Diagonal Torus) (0, 0) [] 0 0 [] [] [] [] []) paperCertificates.

Definition withProfile (p : profile) (C : certificate) : certificate :=
  Certificate p (claimedWindow C) (mask C) (claimedWindows C) (claimedPeriod C) (factors C) (primes C) (vectors C) (cells C)
    (inverse C).
Definition withFactors f (C : certificate) : certificate :=
  Certificate (claimed C) (claimedWindow C) (mask C) (claimedWindows C) (claimedPeriod C) f (primes C) (vectors C) (cells C)
    (inverse C).
Definition withPrimes p (C : certificate) : certificate :=
  Certificate (claimed C) (claimedWindow C) (mask C) (claimedWindows C) (claimedPeriod C) (factors C) p (vectors C) (cells C)
    (inverse C).
Definition withRank v c i (C : certificate) : certificate :=
  Certificate (claimed C) (claimedWindow C) (mask C) (claimedWindows C) (claimedPeriod C) (factors C) (primes C) v c i.

Definition residueOf (P : profile) (l : N) : list N := rootPower (field P) (lower P) (period P / l).

(* A composite among the primes: 15 in place of 3 and 5, with the right residue for 15. *)
Definition compositeFactor : certificate :=
  withFactors [(15, 1, residueOf (claimed genuine) 15); (17, 1, residueOf (claimed genuine) 17)] genuine.

(* The composite 341 = 11 * 31 with a proof that it is prime. *)
Definition compositeShown : certificate := withPrimes [(341, [(2, 2, 3); (5, 1, 3); (17, 1, 3)])] genuine.

(* A wrong residue: that of x^51 in place of x^85. *)
Definition wrongResidue : certificate :=
  withFactors [(3, 1, residueOf (claimed genuine) 5); (5, 1, residueOf (claimed genuine) 5);
    (17, 1, residueOf (claimed genuine) 17)] genuine.

(* A prime left out. *)
Definition missingFactor : certificate := withFactors (tl (factors genuine)) genuine.

(* A singular inverse: its first row comes twice. *)
Definition singularInverse : certificate :=
  withRank (vectors genuine) (cells genuine)
    [[1; 0; 0; 0]; [1; 0; 0; 0]; [2; 0; 2; 3]; [1; 3; 1; 3]] genuine.

(* Dependent vectors: one cell is chosen twice. *)
Definition repeatedCell : certificate := withRank (vectors genuine) [0; 1; 1; 3] (inverse genuine) genuine.

Definition folding' f s n1 n2 : profile :=
  Profile 4 [1; 1; 1] [3; 2; 1; 0; 1] Characteristic [0; 0; 0; 1] n1 n2 f s.
(* Another fold or surface: row by row with the diagonal's vectors, 17 rows and 15 columns, an array
   of the wrong size, and row by row on the plain torus. *)
Definition rowByRow : certificate := withProfile (folding' RowMajor TwistedTorus 15 17) genuine.
Definition turned : certificate := withProfile (folding' Diagonal Torus 17 15) genuine.
Definition tooLarge : certificate := withProfile (folding' Diagonal Torus 15 34) genuine.
Definition otherSurface : certificate := withProfile (folding' RowMajor Torus 15 17) genuine.

(* A register whose state is all zeros, and a field whose modulus A^2 + 1 is a square. *)
Definition atRest : certificate :=
  withProfile (Profile 4 [1; 1; 1] [3; 2; 1; 0; 1] Characteristic [0; 0; 0; 0] 15 17 Diagonal Torus) genuine.
Definition noField : certificate :=
  withProfile (Profile 4 [1; 0; 1] [3; 2; 1; 0; 1] Characteristic [0; 0; 0; 1] 15 17 Diagonal Torus) genuine.

(* An irreducible polynomial whose root has order 85 only. All else is right: four cells of a row
   have rank 4 for any polynomial, and the residues are correct. The residue for 3 is 1. *)
Definition notPrimitive : certificate :=
  let P := Profile 4 [1; 1; 1] [1; 3; 1; 0; 1] Characteristic [0; 0; 0; 1] 15 17 RowMajor TwistedTorus in
  Certificate P (1, 4) (rectangle 1 4) 255 255 (map (fun l => (l, 1, residueOf P l)) [3; 5; 17]) []
    (identity (field P) 4) [0; 1; 2; 3] (identity (field P) 4).
(* With a primitive polynomial in its place the certificate is good, so only the order of the root
   was wrong. *)
Definition primitiveInItsPlace : certificate :=
  let P := Profile 4 [1; 1; 1] [3; 2; 1; 0; 1] Characteristic [0; 0; 0; 1] 15 17 RowMajor TwistedTorus in
  Certificate P (1, 4) (rectangle 1 4) 255 255 (map (fun l => (l, 1, residueOf P l)) [3; 5; 17]) []
    (identity (field P) 4) [0; 1; 2; 3] (identity (field P) 4).

Definition tampered : list certificate :=
  [compositeFactor; compositeShown; wrongResidue; missingFactor; singularInverse; repeatedCell; rowByRow; turned; tooLarge;
   otherSurface; atRest; noField; notPrimitive].

Theorem tampered_are_refused : Forall (fun C => check C = false) tampered.
Proof. repeat constructor; vm_compute; reflexivity. Qed.

Theorem untampered_are_good : check genuine = true /\ check primitiveInItsPlace = true.
Proof. split; vm_compute; reflexivity. Qed.
