(* Executable definitions of fields, polynomials, sequences and rank, on lists, N and bool.

   Each writes down a convention of PraTactile.Profile, without regard for speed.
   PraTactile.Field, Sequence and LinearCode.Elimination compute the same things fast, and the
   conformance laws in test/ compare them with the extracted definitions. Every function ends by
   structural recursion; none has fuel. Grid.v defines arrays, windows and locating. *)
From Coq Require Import NArith List Bool.
Import ListNotations.
Local Open Scope N_scope.

(* The operations of a ring. *)
Record arithmetic (T : Type) := Arithmetic
  { zero : T; one : T; add : T -> T -> T; neg : T -> T; mul : T -> T -> T }.
Arguments Arithmetic {T}. Arguments zero {T}. Arguments one {T}.
Arguments add {T}. Arguments neg {T}. Arguments mul {T}.

(* Polynomials modulo h = x^n + lower, and the recurrence of h. Coefficients are in ascending order,
   the constant term first. *)
Section Over.
Context {T : Type} (K : arithmetic T).

Fixpoint plus (a b : list T) : list T :=
  match a, b with x :: a', y :: b' => add K x y :: plus a' b' | _, _ => [] end.

Definition scale (c : T) : list T -> list T := map (mul K c).

Fixpoint dot (a b : list T) : T :=
  match a, b with x :: a', y :: b' => add K (mul K x y) (dot a' b') | _, _ => zero K end.

Definition nought (a : list T) : list T := map (fun _ => zero K) a.

Definition unit (lower : list T) : list T :=
  match lower with [] => [] | _ :: rest => one K :: nought rest end.

(* Moves the elements up by one place: x becomes the first, and the last one is dropped. *)
Fixpoint shift (x : T) (a : list T) : list T :=
  match a with [] => [] | y :: a' => x :: shift y a' end.

(* x a(x) modulo h, which replaces x^n by -lower. *)
Definition timesRoot (lower a : list T) : list T :=
  plus (shift (zero K) a) (scale (neg K (last a (zero K))) lower).

(* a(x) b(x) modulo h, by Horner's rule. *)
Fixpoint product (lower a b : list T) : list T :=
  match b with
  | [] => nought a
  | c :: b' => plus (scale c a) (timesRoot lower (product lower a b'))
  end.

Fixpoint raised (lower a : list T) (e : positive) : list T :=
  match e with
  | xH => a
  | xO e' => raised lower (product lower a a) e'
  | xI e' => product lower a (raised lower (product lower a a) e')
  end.

(* x^e modulo h. *)
Definition rootPower (lower : list T) (e : N) : list T :=
  match e with N0 => unit lower | Npos e' => raised lower (timesRoot lower (unit lower)) e' end.

Definition polynomials (lower : list T) : arithmetic (list T) :=
  Arithmetic (nought lower) (unit lower) plus (map (neg K)) (product lower).

(* One step of the register, from s(i), ..., s(i+n-1) to s(i+1), ..., s(i+n), where
   s(i+n) = -(c0 s(i) + ... + c(n-1) s(i+n-1)). *)
Definition step (lower state : list T) : list T :=
  match state with [] => [] | _ :: rest => rest ++ [neg K (dot lower state)] end.

Fixpoint terms (lower : list T) (count : nat) (state : list T) : list T :=
  match count with
  | O => []
  | S count' => hd (zero K) state :: terms lower count' (step lower state)
  end.
End Over.

(* GF(p^m): a code's base-p digits are the coefficients of a polynomial in A, lowest degree first. *)
Definition integersModulo (p : N) : arithmetic N :=
  Arithmetic 0 1 (fun a b => (a + b) mod p) (fun a => (p - a) mod p) (fun a b => (a * b) mod p).

Fixpoint digits (p : N) (m : nat) (a : N) : list N :=
  match m with O => [] | S m' => a mod p :: digits p m' (a / p) end.

Definition code (p : N) (ds : list N) : N := fold_right (fun d rest => d + p * rest) 0 ds.

Definition coded (p : N) (m : nat) (K : arithmetic (list N)) : arithmetic N :=
  Arithmetic (code p (zero K)) (code p (one K)) (fun a b => code p (add K (digits p m a) (digits p m b)))
    (fun a => code p (neg K (digits p m a))) (fun a b => code p (mul K (digits p m a) (digits p m b))).

Definition gf (p : N) (modulus : list N) : arithmetic N :=
  coded p (pred (length modulus)) (polynomials (integersModulo p) (removelast modulus)).

(* 0, 1, ..., n - 1. *)
Definition upTo (n : N) : list N := map N.of_nat (seq 0 (N.to_nat n)).

(* The least divisor of q that is at least 2. *)
Definition characteristicOf (q : N) : N :=
  match find (fun d => q mod d =? 0) (skipn 2 (upTo (q + 1))) with Some p => p | None => 0 end.

Definition inverseIn (q : N) (K : arithmetic N) (a : N) : option N :=
  find (fun b => mul K a b =? one K) (upTo q).

(* The rank of rows of this width, by elimination: a row whose first element is not 0 clears the
   first elements of the others. *)
Fixpoint pivot (rows : list (list N)) : option (list N * list (list N)) :=
  match rows with
  | [] => None
  | row :: others =>
    if hd 0 row =? 0 then option_map (fun found => (fst found, row :: snd found)) (pivot others)
    else Some (row, others)
  end.

Fixpoint rank (q : N) (K : arithmetic N) (width : nat) (rows : list (list N)) : N :=
  match width with
  | O => 0
  | S width' =>
    match pivot rows with
    | None => rank q K width' (map (@tl N) rows)
    | Some (row, others) =>
      let scaled := match inverseIn q K (hd 0 row) with Some b => scale K b row | None => row end in
      1 + rank q K width' (map (fun other => tl (plus K other (scale K (neg K (hd 0 other)) scaled))) others)
    end
  end.
