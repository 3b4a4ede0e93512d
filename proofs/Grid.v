(* Executable definitions of a profile's array, its windows and locating. PraTactile.Array, Window
   and Locate compute the same things fast. *)
From Coq Require Import NArith List Bool.
From PraTactile Require Import Exec.
Import ListNotations.
Local Open Scope N_scope.

Inductive reading := Characteristic | Reciprocal.
Inductive folding := Diagonal | RowMajor.
Inductive surface := Torus | TwistedTorus | Sheet.

(* The conventions that determine an array, as in PraTactile.Profile. *)
Record profile := Profile
  { profileOrder : N; profileModulus : list N; profilePolynomial : list N; profileReading : reading;
    profileState : list N; profileRows : N; profileColumns : N; profileFolding : folding; profileSurface : surface }.

Section Of.
Variable P : profile.
Let q := profileOrder P.
Let n1 := profileRows P.
Let n2 := profileColumns P.

Definition field : arithmetic N := gf (characteristicOf q) (profileModulus P).

(* h without its leading 1. With the reciprocal reading, the profile states the polynomial f with
   h = x^n f(1/x) / f(0). *)
Definition lower : list N :=
  match profileReading P with
  | Characteristic => removelast (profilePolynomial P)
  | Reciprocal =>
    match inverseIn q field (hd 0 (profilePolynomial P)) with
    | Some b => scale field b (rev (tl (profilePolynomial P)))
    | None => []
    end
  end.

(* q^n - 1. *)
Definition period : N := q ^ N.of_nat (length lower) - 1.

Definition stateAt (i : N) : list N := N.iter i (step field lower) (profileState P).

(* s(i). *)
Definition term (i : N) : N := hd 0 (stateAt i).

(* The place at which the fold puts term i. *)
Definition place (i : N) : N * N :=
  match profileFolding P with
  | Diagonal => (i mod n1, i mod n2)
  | RowMajor => (i / n2, i mod n2)
  end.

(* A cell of the array: its place and its symbol. *)
Definition cell := (N * N * N)%type.

(* The array: one period of the sequence, each term with its place. *)
Definition folded : list cell :=
  combine (map place (upTo period)) (terms field lower (N.to_nat period) (profileState P)).

Definition samePlace (a b : N * N) : bool := (fst a =? fst b) && (snd a =? snd b).

(* The symbol at a place, or None if the fold puts no term there. *)
Definition cellIn (array : list cell) (at' : N * N) : option N :=
  option_map snd (find (fun x => samePlace at' (fst x)) array).

(* The place in the array of a row and a column that may lie beyond its edges, or None if they lie
   outside the sheet. *)
Definition onSurface (s : surface) (at' : N * N) : option (N * N) :=
  let (r, c) := at' in
  match s with
  | Torus => Some (r mod n1, c mod n2)
  | TwistedTorus => let i := (r * n2 + c) mod (n1 * n2) in Some (i / n2, i mod n2)
  | Sheet => if (r <? n1) && (c <? n2) then Some (r, c) else None
  end.

(* The fold's own surface: on it, a step to a neighbour is a constant number of terms, from any
   cell. *)
Definition ownSurface : surface :=
  match profileFolding P with Diagonal => Torus | RowMajor => TwistedTorus end.

Definition symbol (s : surface) (array : list cell) (at' : N * N) : option N :=
  match onSurface s at' with Some at'' => cellIn array at'' | None => None end.

(* The symbols that a mask, given by its offsets, shows at a position, or None if a cell is
   missing. *)
Fixpoint window (s : surface) (array : list cell) (mask : list (N * N)) (at' : N * N) : option (list N) :=
  match mask with
  | [] => Some []
  | offset :: others =>
    match symbol s array (fst at' + fst offset, snd at' + snd offset), window s array others at' with
    | Some a, Some rest => Some (a :: rest)
    | _, _ => None
    end
  end.

(* All positions, row by row. *)
Definition positions : list (N * N) :=
  flat_map (fun r => map (fun c => (r, c)) (upTo n2)) (upTo n1).

(* All windows on the surface, each with its position. *)
Definition windows (s : surface) (array : list cell) (mask : list (N * N)) : list (N * N * list N) :=
  flat_map (fun at' => match window s array mask at' with Some content => [(at', content)] | None => [] end) positions.
End Of.

(* The offsets of a rectangle's cells, row by row. *)
Definition rectangle (high wide : N) : list (N * N) :=
  flat_map (fun i => map (fun j => (i, j)) (upTo wide)) (upTo high).

Fixpoint same (a b : list N) : bool :=
  match a, b with
  | [], [] => true
  | x :: a', y :: b' => (x =? y) && same a' b'
  | _, _ => false
  end.

(* The number of different contents. *)
Fixpoint different (contents : list (list N)) : N :=
  match contents with
  | [] => 0
  | content :: others => (if existsb (same content) others then 0 else 1) + different others
  end.

(* The positions of the windows with this content. *)
Definition locate (content : list N) (found : list (N * N * list N)) : list (N * N) :=
  map fst (filter (fun w => same content (snd w)) found).

(* The number of cells in which two contents differ. *)
Fixpoint differences (a b : list N) : N :=
  match a, b with x :: a', y :: b' => (if x =? y then 0 else 1) + differences a' b' | _, _ => 0 end.

(* The least number of cells in which two of these contents differ, or the bound if that is less. *)
Fixpoint distanceOf (bound : N) (contents : list (list N)) : N :=
  match contents with
  | [] => bound
  | content :: others =>
    distanceOf (fold_left (fun least other => N.min least (differences content other)) others bound) others
  end.

(* The base-q number whose most significant digit is the first cell. *)
Definition packed (q : N) (content : list N) : N := fold_left (fun w a => q * w + a) content 0.
Definition unpacked (q : N) (cells : nat) (w : N) : list N := rev (digits q cells w).
