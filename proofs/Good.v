(* The committed certificates are good: the kernel runs the checker on each, and T10 says what
   follows.

   The certificates are those of the paper's array, of all 32 primitive quartics over GF(4), of each
   profile in data/profiles, and of the paper's array on other surfaces and with another mask. *)
From Coq Require Import NArith List Bool.
From PraTactile Require Import Grid Checker Lists Certificate Certificates Paper.
Import ListNotations.
Local Open Scope N_scope.

Definition certificates : list certificate :=
  paperCertificates ++ quarticCertificates ++ shippedCertificates ++ otherCertificates.

Theorem certificates_are_good : forallb check certificates = true /\ length certificates = 42%nat.
Proof. split; vm_compute; reflexivity. Qed.

Theorem certified_arrays C : In C certificates ->
  primitive (claimed C) /\ windowsAreDistinct (claimed C) (mask C).
Proof.
  intros I; apply certificate_sound; exact (proj1 (forallb_forall _ _) (proj1 certificates_are_good) C I).
Qed.

(* The 32 quartics are different, and each has the paper's shape and window. *)
Theorem quartics_are_32 :
  NoDup (map (fun C => profilePolynomial (claimed C)) quarticCertificates)
  /\ length quarticCertificates = 32%nat
  /\ forall C, In C quarticCertificates -> profileRows (claimed C) = 15 /\ profileColumns (claimed C) = 17
       /\ profileFolding (claimed C) = Diagonal /\ profileSurface (claimed C) = Torus /\ mask C = rectangle 2 2.
Proof.
  split; [apply different_NoDup; vm_compute; reflexivity | split; [vm_compute; reflexivity |]].
  intros C I; simpl in I; repeat destruct I as [<- | I]; try easy; repeat split; vm_compute; reflexivity.
Qed.

(* The first certificate is about the array of Paper.v: its polynomial is primitive. *)
Theorem paper_polynomial_is_primitive : primitive paper /\ windowsAreDistinct paper (rectangle 2 2).
Proof.
  destruct (certified_arrays (hd (Certificate paper (0, 0) [] 0 0 [] [] [] [] []) paperCertificates)) as [A B].
  - apply in_or_app; left; now left.
  - split; [exact A | exact B].
Qed.
