(* Facts about the paper's array, which the kernel computes from the definitions alone.

   PraTactile.Window.Proof, Locate and Window.Distance compute the same facts. *)
From Coq Require Import NArith List Bool.
From PraTactile Require Import Exec Grid Lists.
Import ListNotations.
Local Open Scope N_scope.

(* q = 4 with A^2 = A + 1, h = x^4 + x^2 + A x + A^2, 15 x 17, folded along the diagonal. *)
Definition paper : profile :=
  Profile 4 [1; 1; 1] [3; 2; 1; 0; 1] Characteristic [0; 0; 0; 1] 15 17 Diagonal Torus.

Definition paperArray : list cell := Eval vm_compute in folded paper.
Definition paperWindows (high wide : N) : list (N * N * list N) :=
  windows paper Torus paperArray (rectangle high wide).

Lemma paperArray_is_folded : folded paper = paperArray.
Proof. vm_compute. reflexivity. Qed.

(* Each of the 255 positions has a 2 x 2 window, and they are distinct. *)
Theorem paper_windows_are_distinct :
  map fst (windows paper Torus (folded paper) (rectangle 2 2)) = positions paper
  /\ length (positions paper) = 255%nat
  /\ NoDup (map snd (windows paper Torus (folded paper) (rectangle 2 2))).
Proof.
  rewrite paperArray_is_folded; split; [| split; [| apply different_NoDup]]; vm_compute; reflexivity.
Qed.

(* The worked example, 3 2 above 3 1, is at row 6, column 5, and nowhere else. *)
Theorem paper_worked_example :
  locate [3; 2; 3; 1] (windows paper Torus (folded paper) (rectangle 2 2)) = [(6, 5)].
Proof. vm_compute; reflexivity. Qed.

Definition columnIsZero (array : list cell) (c : N) : bool :=
  forallb (fun r => match cellIn array (r, c) with Some a => a =? 0 | None => false end) (upTo 15).

(* Exactly one of the 17 columns holds zeros alone. *)
Theorem paper_one_column_is_zero :
  length (filter (columnIsZero (folded paper)) (upTo 17)) = 1%nat.
Proof. vm_compute; reflexivity. Qed.

Definition distance (high wide : N) : N :=
  distanceOf (high * wide) (map snd (windows paper Torus (folded paper) (rectangle high wide))).

(* The least number of cells in which two windows differ, over all pairs. *)
Theorem paper_distances :
  map (fun shape => distance (fst shape) (snd shape)) [(2, 2); (2, 3); (3, 2); (3, 3); (3, 4); (4, 4)]
  = [1; 2; 2; 4; 6; 9].
Proof. vm_compute; reflexivity. Qed.

(* The four exponents of a 2 x 2 window have rank 4, by elimination. *)
Theorem paper_window_has_rank_4 :
  rank 4 (field paper) 4 (map (fun at' => rootPower (field paper) (lower paper)
    (hd 0 (filter (fun i => samePlace at' (place paper i)) (upTo 255)))) (rectangle 2 2)) = 4.
Proof. vm_compute; reflexivity. Qed.
