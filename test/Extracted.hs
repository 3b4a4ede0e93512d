{-# OPTIONS_GHC -O1 -w #-}

-- | The definitions of proofs/Exec.v and Grid.v and the checker of proofs/Checker.v, as Coq extracts
-- them by proofs/Extract.v. Written by @tools/proofs.sh --extract@; proofs/README.md says what is
-- trusted of it.
module Extracted where

import qualified Prelude

option_map :: (a1 -> a2) -> (Prelude.Maybe a1) -> Prelude.Maybe a2
option_map f o =
  case o of {
   Prelude.Just a -> Prelude.Just (f a);
   Prelude.Nothing -> Prelude.Nothing}

fst :: ((,) a1 a2) -> a1
fst p =
  case p of {
   (,) x _ -> x}

snd :: ((,) a1 a2) -> a2
snd p =
  case p of {
   (,) _ y -> y}

length :: (([]) a1) -> Prelude.Integer
length l =
  case l of {
   ([]) -> 0;
   (:) _ l' -> Prelude.succ (length l')}

app :: (([]) a1) -> (([]) a1) -> ([]) a1
app l m =
  case l of {
   ([]) -> m;
   (:) a l1 -> (:) a (app l1 m)}

data Comparison =
   Eq
 | Lt
 | Gt

pred :: Prelude.Integer -> Prelude.Integer
pred n =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> n)
    (\u -> u)
    n

add :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer
add x y =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> (\x -> 2 Prelude.* x) (add_carry p q))
      (\q -> (\x -> 2 Prelude.* x Prelude.+ 1) (add p q))
      (\_ -> (\x -> 2 Prelude.* x) (Prelude.succ p))
      y)
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> (\x -> 2 Prelude.* x Prelude.+ 1) (add p q))
      (\q -> (\x -> 2 Prelude.* x) (add p q))
      (\_ -> (\x -> 2 Prelude.* x Prelude.+ 1) p)
      y)
    (\_ ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> (\x -> 2 Prelude.* x) (Prelude.succ q))
      (\q -> (\x -> 2 Prelude.* x Prelude.+ 1) q)
      (\_ -> (\x -> 2 Prelude.* x) 1)
      y)
    x

add_carry :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer
add_carry x y =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> (\x -> 2 Prelude.* x Prelude.+ 1) (add_carry p q))
      (\q -> (\x -> 2 Prelude.* x) (add_carry p q))
      (\_ -> (\x -> 2 Prelude.* x Prelude.+ 1) (Prelude.succ p))
      y)
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> (\x -> 2 Prelude.* x) (add_carry p q))
      (\q -> (\x -> 2 Prelude.* x Prelude.+ 1) (add p q))
      (\_ -> (\x -> 2 Prelude.* x) (Prelude.succ p))
      y)
    (\_ ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> (\x -> 2 Prelude.* x Prelude.+ 1) (Prelude.succ q))
      (\q -> (\x -> 2 Prelude.* x) (Prelude.succ q))
      (\_ -> (\x -> 2 Prelude.* x Prelude.+ 1) 1)
      y)
    x

pred_double :: Prelude.Integer -> Prelude.Integer
pred_double x =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p -> (\x -> 2 Prelude.* x Prelude.+ 1) ((\x -> 2 Prelude.* x) p))
    (\p -> (\x -> 2 Prelude.* x Prelude.+ 1) (pred_double p))
    (\_ -> 1)
    x

data Mask =
   IsNul
 | IsPos Prelude.Integer
 | IsNeg

succ_double_mask :: Mask -> Mask
succ_double_mask x =
  case x of {
   IsNul -> IsPos 1;
   IsPos p -> IsPos ((\x -> 2 Prelude.* x Prelude.+ 1) p);
   IsNeg -> IsNeg}

double_mask :: Mask -> Mask
double_mask x =
  case x of {
   IsPos p -> IsPos ((\x -> 2 Prelude.* x) p);
   x0 -> x0}

double_pred_mask :: Prelude.Integer -> Mask
double_pred_mask x =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p -> IsPos ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x) p)))
    (\p -> IsPos ((\x -> 2 Prelude.* x) (pred_double p)))
    (\_ -> IsNul)
    x

sub_mask :: Prelude.Integer -> Prelude.Integer -> Mask
sub_mask x y =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> double_mask (sub_mask p q))
      (\q -> succ_double_mask (sub_mask p q))
      (\_ -> IsPos ((\x -> 2 Prelude.* x) p))
      y)
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> succ_double_mask (sub_mask_carry p q))
      (\q -> double_mask (sub_mask p q))
      (\_ -> IsPos (pred_double p))
      y)
    (\_ ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\_ -> IsNeg)
      (\_ -> IsNeg)
      (\_ -> IsNul)
      y)
    x

sub_mask_carry :: Prelude.Integer -> Prelude.Integer -> Mask
sub_mask_carry x y =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> succ_double_mask (sub_mask_carry p q))
      (\q -> double_mask (sub_mask p q))
      (\_ -> IsPos (pred_double p))
      y)
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> double_mask (sub_mask_carry p q))
      (\q -> succ_double_mask (sub_mask_carry p q))
      (\_ -> double_pred_mask p)
      y)
    (\_ -> IsNeg)
    x

sub :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer
sub x y =
  case sub_mask x y of {
   IsPos z -> z;
   _ -> 1}

mul :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer
mul x y =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p -> add y ((\x -> 2 Prelude.* x) (mul p y)))
    (\p -> (\x -> 2 Prelude.* x) (mul p y))
    (\_ -> y)
    x

iter :: (a1 -> a1) -> a1 -> Prelude.Integer -> a1
iter f x n =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\n' -> f (iter f (iter f x n') n'))
    (\n' -> iter f (iter f x n') n')
    (\_ -> f x)
    n

pow :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer
pow x =
  iter (mul x) 1

size_nat :: Prelude.Integer -> Prelude.Integer
size_nat p =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p0 -> Prelude.succ (size_nat p0))
    (\p0 -> Prelude.succ (size_nat p0))
    (\_ -> Prelude.succ 0)
    p

size :: Prelude.Integer -> Prelude.Integer
size p =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p0 -> Prelude.succ (size p0))
    (\p0 -> Prelude.succ (size p0))
    (\_ -> 1)
    p

compare_cont :: Comparison -> Prelude.Integer -> Prelude.Integer ->
                Comparison
compare_cont r x y =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> compare_cont r p q)
      (\q -> compare_cont Gt p q)
      (\_ -> Gt)
      y)
    (\p ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q -> compare_cont Lt p q)
      (\q -> compare_cont r p q)
      (\_ -> Gt)
      y)
    (\_ ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\_ -> Lt)
      (\_ -> Lt)
      (\_ -> r)
      y)
    x

compare :: Prelude.Integer -> Prelude.Integer -> Comparison
compare =
  compare_cont Eq

eqb :: Prelude.Integer -> Prelude.Integer -> Prelude.Bool
eqb p q =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p0 ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\q0 -> eqb p0 q0)
      (\_ -> Prelude.False)
      (\_ -> Prelude.False)
      q)
    (\p0 ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\_ -> Prelude.False)
      (\q0 -> eqb p0 q0)
      (\_ -> Prelude.False)
      q)
    (\_ ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\_ -> Prelude.False)
      (\_ -> Prelude.False)
      (\_ -> Prelude.True)
      q)
    p

gcdn :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer ->
        Prelude.Integer
gcdn n a b =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> 1)
    (\n0 ->
    (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
      (\a' ->
      (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
        (\b' ->
        case compare a' b' of {
         Eq -> a;
         Lt -> gcdn n0 (sub b' a') a;
         Gt -> gcdn n0 (sub a' b') b})
        (\b0 -> gcdn n0 a b0)
        (\_ -> 1)
        b)
      (\a0 ->
      (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
        (\_ -> gcdn n0 a0 b)
        (\b0 -> (\x -> 2 Prelude.* x) (gcdn n0 a0 b0))
        (\_ -> 1)
        b)
      (\_ -> 1)
      a)
    n

gcd :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer
gcd a b =
  gcdn ((Prelude.+) (size_nat a) (size_nat b)) a b

iter_op :: (a1 -> a1 -> a1) -> Prelude.Integer -> a1 -> a1
iter_op op p a =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\p0 -> op a (iter_op op p0 (op a a)))
    (\p0 -> iter_op op p0 (op a a))
    (\_ -> a)
    p

to_nat :: Prelude.Integer -> Prelude.Integer
to_nat x =
  iter_op (Prelude.+) x (Prelude.succ 0)

of_succ_nat :: Prelude.Integer -> Prelude.Integer
of_succ_nat n =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> 1)
    (\x -> Prelude.succ (of_succ_nat x))
    n

succ_double :: Prelude.Integer -> Prelude.Integer
succ_double x =
  (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
    (\_ -> (\x -> x) 1)
    (\p -> (\x -> x) ((\x -> 2 Prelude.* x Prelude.+ 1) p))
    x

double :: Prelude.Integer -> Prelude.Integer
double n =
  (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
    (\_ -> 0)
    (\p -> (\x -> x) ((\x -> 2 Prelude.* x) p))
    n

sub0 :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer
sub0 = (\n m -> Prelude.max 0 (n Prelude.- m))

compare0 :: Prelude.Integer -> Prelude.Integer -> Comparison
compare0 n m =
  (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
    (\_ ->
    (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
      (\_ -> Eq)
      (\_ -> Lt)
      m)
    (\n' ->
    (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
      (\_ -> Gt)
      (\m' -> compare n' m')
      m)
    n

size0 :: Prelude.Integer -> Prelude.Integer
size0 n =
  (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
    (\_ -> 0)
    (\p -> (\x -> x) (size p))
    n

pos_div_eucl :: Prelude.Integer -> Prelude.Integer -> (,) Prelude.Integer
                Prelude.Integer
pos_div_eucl a b =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\a' ->
    case pos_div_eucl a' b of {
     (,) q r ->
      let {r' = succ_double r} in
      case (Prelude.<=) b r' of {
       Prelude.True -> (,) (succ_double q) (sub0 r' b);
       Prelude.False -> (,) (double q) r'}})
    (\a' ->
    case pos_div_eucl a' b of {
     (,) q r ->
      let {r' = double r} in
      case (Prelude.<=) b r' of {
       Prelude.True -> (,) (succ_double q) (sub0 r' b);
       Prelude.False -> (,) (double q) r'}})
    (\_ ->
    (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
      (\_ -> (,) 0 ((\x -> x) 1))
      (\p ->
      (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
        (\_ -> (,) 0 ((\x -> x) 1))
        (\_ -> (,) 0 ((\x -> x) 1))
        (\_ -> (,) ((\x -> x) 1) 0)
        p)
      b)
    a

div_eucl :: Prelude.Integer -> Prelude.Integer -> (,) Prelude.Integer
            Prelude.Integer
div_eucl a b =
  (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
    (\_ -> (,) 0 0)
    (\na ->
    (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
      (\_ -> (,) 0 a)
      (\_ -> pos_div_eucl na b)
      b)
    a

div :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer
div = (\n m -> if m Prelude.== 0 then 0 else Prelude.div n m)

modulo :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer
modulo = (\n m -> if m Prelude.== 0 then n else Prelude.mod n m)

iter0 :: Prelude.Integer -> (a1 -> a1) -> a1 -> a1
iter0 n f x =
  (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
    (\_ -> x)
    (\p -> iter f x p)
    n

hd :: a1 -> (([]) a1) -> a1
hd default0 l =
  case l of {
   ([]) -> default0;
   (:) x _ -> x}

tl :: (([]) a1) -> ([]) a1
tl l =
  case l of {
   ([]) -> ([]);
   (:) _ m -> m}

nth :: Prelude.Integer -> (([]) a1) -> a1 -> a1
nth n l default0 =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> case l of {
            ([]) -> default0;
            (:) x _ -> x})
    (\m -> case l of {
            ([]) -> default0;
            (:) _ t -> nth m t default0})
    n

last :: (([]) a1) -> a1 -> a1
last l d =
  case l of {
   ([]) -> d;
   (:) a l0 -> case l0 of {
                ([]) -> a;
                (:) _ _ -> last l0 d}}

removelast :: (([]) a1) -> ([]) a1
removelast l =
  case l of {
   ([]) -> ([]);
   (:) a l0 -> case l0 of {
                ([]) -> ([]);
                (:) _ _ -> (:) a (removelast l0)}}

rev :: (([]) a1) -> ([]) a1
rev l =
  case l of {
   ([]) -> ([]);
   (:) x l' -> app (rev l') ((:) x ([]))}

map :: (a1 -> a2) -> (([]) a1) -> ([]) a2
map f l =
  case l of {
   ([]) -> ([]);
   (:) a t -> (:) (f a) (map f t)}

flat_map :: (a1 -> ([]) a2) -> (([]) a1) -> ([]) a2
flat_map f l =
  case l of {
   ([]) -> ([]);
   (:) x t -> app (f x) (flat_map f t)}

fold_left :: (a1 -> a2 -> a1) -> (([]) a2) -> a1 -> a1
fold_left f l a0 =
  case l of {
   ([]) -> a0;
   (:) b t -> fold_left f t (f a0 b)}

fold_right :: (a2 -> a1 -> a1) -> a1 -> (([]) a2) -> a1
fold_right f a0 l =
  case l of {
   ([]) -> a0;
   (:) b t -> f b (fold_right f a0 t)}

existsb :: (a1 -> Prelude.Bool) -> (([]) a1) -> Prelude.Bool
existsb f l =
  case l of {
   ([]) -> Prelude.False;
   (:) a l0 -> (Prelude.||) (f a) (existsb f l0)}

forallb :: (a1 -> Prelude.Bool) -> (([]) a1) -> Prelude.Bool
forallb f l =
  case l of {
   ([]) -> Prelude.True;
   (:) a l0 -> (Prelude.&&) (f a) (forallb f l0)}

filter :: (a1 -> Prelude.Bool) -> (([]) a1) -> ([]) a1
filter f l =
  case l of {
   ([]) -> ([]);
   (:) x l0 ->
    case f x of {
     Prelude.True -> (:) x (filter f l0);
     Prelude.False -> filter f l0}}

find :: (a1 -> Prelude.Bool) -> (([]) a1) -> Prelude.Maybe a1
find f l =
  case l of {
   ([]) -> Prelude.Nothing;
   (:) x tl0 ->
    case f x of {
     Prelude.True -> Prelude.Just x;
     Prelude.False -> find f tl0}}

combine :: (([]) a1) -> (([]) a2) -> ([]) ((,) a1 a2)
combine l l' =
  case l of {
   ([]) -> ([]);
   (:) x tl0 ->
    case l' of {
     ([]) -> ([]);
     (:) y tl' -> (:) ((,) x y) (combine tl0 tl')}}

skipn :: Prelude.Integer -> (([]) a1) -> ([]) a1
skipn n l =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> l)
    (\n0 -> case l of {
             ([]) -> ([]);
             (:) _ l0 -> skipn n0 l0})
    n

seq :: Prelude.Integer -> Prelude.Integer -> ([]) Prelude.Integer
seq start len =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> ([]))
    (\len0 -> (:) start (seq (Prelude.succ start) len0))
    len

repeat :: a1 -> Prelude.Integer -> ([]) a1
repeat x n =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> ([]))
    (\k -> (:) x (repeat x k))
    n

data Arithmetic0 t =
   Arithmetic t t (t -> t -> t) (t -> t) (t -> t -> t)

zero :: (Arithmetic0 a1) -> a1
zero a =
  case a of {
   Arithmetic zero0 _ _ _ _ -> zero0}

one :: (Arithmetic0 a1) -> a1
one a =
  case a of {
   Arithmetic _ one0 _ _ _ -> one0}

add0 :: (Arithmetic0 a1) -> a1 -> a1 -> a1
add0 a =
  case a of {
   Arithmetic _ _ add1 _ _ -> add1}

neg :: (Arithmetic0 a1) -> a1 -> a1
neg a =
  case a of {
   Arithmetic _ _ _ neg0 _ -> neg0}

mul0 :: (Arithmetic0 a1) -> a1 -> a1 -> a1
mul0 a =
  case a of {
   Arithmetic _ _ _ _ mul1 -> mul1}

plus :: (Arithmetic0 a1) -> (([]) a1) -> (([]) a1) -> ([]) a1
plus k a b =
  case a of {
   ([]) -> ([]);
   (:) x a' ->
    case b of {
     ([]) -> ([]);
     (:) y b' -> (:) (add0 k x y) (plus k a' b')}}

scale :: (Arithmetic0 a1) -> a1 -> (([]) a1) -> ([]) a1
scale k c =
  map (mul0 k c)

dot :: (Arithmetic0 a1) -> (([]) a1) -> (([]) a1) -> a1
dot k a b =
  case a of {
   ([]) -> zero k;
   (:) x a' ->
    case b of {
     ([]) -> zero k;
     (:) y b' -> add0 k (mul0 k x y) (dot k a' b')}}

nought :: (Arithmetic0 a1) -> (([]) a1) -> ([]) a1
nought k a =
  map (\_ -> zero k) a

unit0 :: (Arithmetic0 a1) -> (([]) a1) -> ([]) a1
unit0 k lower0 =
  case lower0 of {
   ([]) -> ([]);
   (:) _ rest -> (:) (one k) (nought k rest)}

shift :: a1 -> (([]) a1) -> ([]) a1
shift x a =
  case a of {
   ([]) -> ([]);
   (:) y a' -> (:) x (shift y a')}

timesRoot :: (Arithmetic0 a1) -> (([]) a1) -> (([]) a1) -> ([]) a1
timesRoot k lower0 a =
  plus k (shift (zero k) a) (scale k (neg k (last a (zero k))) lower0)

product :: (Arithmetic0 a1) -> (([]) a1) -> (([]) a1) -> (([]) a1) -> ([]) a1
product k lower0 a b =
  case b of {
   ([]) -> nought k a;
   (:) c b' ->
    plus k (scale k c a) (timesRoot k lower0 (product k lower0 a b'))}

raised :: (Arithmetic0 a1) -> (([]) a1) -> (([]) a1) -> Prelude.Integer ->
          ([]) a1
raised k lower0 a e =
  (\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))
    (\e' ->
    product k lower0 a (raised k lower0 (product k lower0 a a) e'))
    (\e' -> raised k lower0 (product k lower0 a a) e')
    (\_ -> a)
    e

rootPower :: (Arithmetic0 a1) -> (([]) a1) -> Prelude.Integer -> ([]) a1
rootPower k lower0 e =
  (\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)
    (\_ -> unit0 k lower0)
    (\e' -> raised k lower0 (timesRoot k lower0 (unit0 k lower0)) e')
    e

polynomials :: (Arithmetic0 a1) -> (([]) a1) -> Arithmetic0 (([]) a1)
polynomials k lower0 =
  Arithmetic (nought k lower0) (unit0 k lower0) (plus k) (map (neg k))
    (product k lower0)

step :: (Arithmetic0 a1) -> (([]) a1) -> (([]) a1) -> ([]) a1
step k lower0 state =
  case state of {
   ([]) -> ([]);
   (:) _ rest -> app rest ((:) (neg k (dot k lower0 state)) ([]))}

terms :: (Arithmetic0 a1) -> (([]) a1) -> Prelude.Integer -> (([]) a1) ->
         ([]) a1
terms k lower0 count state =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> ([]))
    (\count' -> (:) (hd (zero k) state)
    (terms k lower0 count' (step k lower0 state)))
    count

integersModulo :: Prelude.Integer -> Arithmetic0 Prelude.Integer
integersModulo p =
  Arithmetic 0 ((\x -> x) 1) (\a b -> modulo ((Prelude.+) a b) p) (\a ->
    modulo (sub0 p a) p) (\a b -> modulo ((Prelude.*) a b) p)

digits :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer -> ([])
          Prelude.Integer
digits p m a =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> ([]))
    (\m' -> (:) (modulo a p) (digits p m' (div a p)))
    m

code :: Prelude.Integer -> (([]) Prelude.Integer) -> Prelude.Integer
code p ds =
  fold_right (\d rest -> (Prelude.+) d ((Prelude.*) p rest)) 0 ds

coded :: Prelude.Integer -> Prelude.Integer -> (Arithmetic0
         (([]) Prelude.Integer)) -> Arithmetic0 Prelude.Integer
coded p m k =
  Arithmetic (code p (zero k)) (code p (one k)) (\a b ->
    code p (add0 k (digits p m a) (digits p m b))) (\a ->
    code p (neg k (digits p m a))) (\a b ->
    code p (mul0 k (digits p m a) (digits p m b)))

gf :: Prelude.Integer -> (([]) Prelude.Integer) -> Arithmetic0
      Prelude.Integer
gf p modulus =
  coded p (pred (length modulus))
    (polynomials (integersModulo p) (removelast modulus))

upTo :: Prelude.Integer -> ([]) Prelude.Integer
upTo n =
  map (\n -> n) (seq 0 ((\n -> n) n))

characteristicOf :: Prelude.Integer -> Prelude.Integer
characteristicOf q =
  case find (\d -> (Prelude.==) (modulo q d) 0)
         (skipn (Prelude.succ (Prelude.succ 0))
           (upTo ((Prelude.+) q ((\x -> x) 1)))) of {
   Prelude.Just p -> p;
   Prelude.Nothing -> 0}

inverseIn :: Prelude.Integer -> (Arithmetic0 Prelude.Integer) ->
             Prelude.Integer -> Prelude.Maybe Prelude.Integer
inverseIn q k a =
  find (\b -> (Prelude.==) (mul0 k a b) (one k)) (upTo q)

pivot :: (([]) (([]) Prelude.Integer)) -> Prelude.Maybe
         ((,) (([]) Prelude.Integer) (([]) (([]) Prelude.Integer)))
pivot rows =
  case rows of {
   ([]) -> Prelude.Nothing;
   (:) row others ->
    case (Prelude.==) (hd 0 row) 0 of {
     Prelude.True ->
      option_map (\found -> (,) (fst found) ((:) row (snd found)))
        (pivot others);
     Prelude.False -> Prelude.Just ((,) row others)}}

rank :: Prelude.Integer -> (Arithmetic0 Prelude.Integer) -> Prelude.Integer
        -> (([]) (([]) Prelude.Integer)) -> Prelude.Integer
rank q k width rows =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> 0)
    (\width' ->
    case pivot rows of {
     Prelude.Just p ->
      case p of {
       (,) row others ->
        let {
         scaled = case inverseIn q k (hd 0 row) of {
                   Prelude.Just b -> scale k b row;
                   Prelude.Nothing -> row}}
        in
        (Prelude.+) ((\x -> x) 1)
          (rank q k width'
            (map (\other ->
              tl (plus k other (scale k (neg k (hd 0 other)) scaled)))
              others))};
     Prelude.Nothing -> rank q k width' (map tl rows)})
    width

data Reading =
   Characteristic
 | Reciprocal

data Folding =
   Diagonal
 | RowMajor

data Surface =
   Torus
 | TwistedTorus
 | Sheet

data Profile0 =
   Profile Prelude.Integer (([]) Prelude.Integer) (([]) Prelude.Integer) 
 Reading (([]) Prelude.Integer) Prelude.Integer Prelude.Integer Folding 
 Surface

profileOrder :: Profile0 -> Prelude.Integer
profileOrder p =
  case p of {
   Profile profileOrder0 _ _ _ _ _ _ _ _ -> profileOrder0}

profileModulus :: Profile0 -> ([]) Prelude.Integer
profileModulus p =
  case p of {
   Profile _ profileModulus0 _ _ _ _ _ _ _ -> profileModulus0}

profilePolynomial :: Profile0 -> ([]) Prelude.Integer
profilePolynomial p =
  case p of {
   Profile _ _ profilePolynomial0 _ _ _ _ _ _ -> profilePolynomial0}

profileReading :: Profile0 -> Reading
profileReading p =
  case p of {
   Profile _ _ _ profileReading0 _ _ _ _ _ -> profileReading0}

profileState :: Profile0 -> ([]) Prelude.Integer
profileState p =
  case p of {
   Profile _ _ _ _ profileState0 _ _ _ _ -> profileState0}

profileRows :: Profile0 -> Prelude.Integer
profileRows p =
  case p of {
   Profile _ _ _ _ _ profileRows0 _ _ _ -> profileRows0}

profileColumns :: Profile0 -> Prelude.Integer
profileColumns p =
  case p of {
   Profile _ _ _ _ _ _ profileColumns0 _ _ -> profileColumns0}

profileFolding :: Profile0 -> Folding
profileFolding p =
  case p of {
   Profile _ _ _ _ _ _ _ profileFolding0 _ -> profileFolding0}

profileSurface :: Profile0 -> Surface
profileSurface p =
  case p of {
   Profile _ _ _ _ _ _ _ _ profileSurface0 -> profileSurface0}

field :: Profile0 -> Arithmetic0 Prelude.Integer
field p =
  let {q = profileOrder p} in gf (characteristicOf q) (profileModulus p)

lower :: Profile0 -> ([]) Prelude.Integer
lower p =
  let {q = profileOrder p} in
  case profileReading p of {
   Characteristic -> removelast (profilePolynomial p);
   Reciprocal ->
    case inverseIn q (field p) (hd 0 (profilePolynomial p)) of {
     Prelude.Just b -> scale (field p) b (rev (tl (profilePolynomial p)));
     Prelude.Nothing -> ([])}}

period :: Profile0 -> Prelude.Integer
period p =
  let {q = profileOrder p} in
  sub0 ((Prelude.^) q ((\n -> n) (length (lower p)))) ((\x -> x) 1)

stateAt :: Profile0 -> Prelude.Integer -> ([]) Prelude.Integer
stateAt p i =
  iter0 i (step (field p) (lower p)) (profileState p)

term :: Profile0 -> Prelude.Integer -> Prelude.Integer
term p i =
  hd 0 (stateAt p i)

place :: Profile0 -> Prelude.Integer -> (,) Prelude.Integer Prelude.Integer
place p =
  let {n1 = profileRows p} in
  let {n2 = profileColumns p} in
  (\i ->
  case profileFolding p of {
   Diagonal -> (,) (modulo i n1) (modulo i n2);
   RowMajor -> (,) (div i n2) (modulo i n2)})

type Cell = (,) ((,) Prelude.Integer Prelude.Integer) Prelude.Integer

folded :: Profile0 -> ([]) Cell
folded p =
  combine (map (place p) (upTo (period p)))
    (terms (field p) (lower p) ((\n -> n) (period p)) (profileState p))

samePlace :: ((,) Prelude.Integer Prelude.Integer) -> ((,) Prelude.Integer
             Prelude.Integer) -> Prelude.Bool
samePlace a b =
  (Prelude.&&) ((Prelude.==) (fst a) (fst b)) ((Prelude.==) (snd a) (snd b))

cellIn :: (([]) Cell) -> ((,) Prelude.Integer Prelude.Integer) ->
          Prelude.Maybe Prelude.Integer
cellIn array at' =
  option_map snd (find (\x -> samePlace at' (fst x)) array)

onSurface :: Profile0 -> Surface -> ((,) Prelude.Integer Prelude.Integer) ->
             Prelude.Maybe ((,) Prelude.Integer Prelude.Integer)
onSurface p =
  let {n1 = profileRows p} in
  let {n2 = profileColumns p} in
  (\s at' ->
  case at' of {
   (,) r c ->
    case s of {
     Torus -> Prelude.Just ((,) (modulo r n1) (modulo c n2));
     TwistedTorus ->
      let {i = modulo ((Prelude.+) ((Prelude.*) r n2) c) ((Prelude.*) n1 n2)}
      in
      Prelude.Just ((,) (div i n2) (modulo i n2));
     Sheet ->
      case (Prelude.&&) ((Prelude.<) r n1) ((Prelude.<) c n2) of {
       Prelude.True -> Prelude.Just ((,) r c);
       Prelude.False -> Prelude.Nothing}}})

ownSurface :: Profile0 -> Surface
ownSurface p =
  case profileFolding p of {
   Diagonal -> Torus;
   RowMajor -> TwistedTorus}

symbol :: Profile0 -> Surface -> (([]) Cell) -> ((,) Prelude.Integer
          Prelude.Integer) -> Prelude.Maybe Prelude.Integer
symbol p s array at' =
  case onSurface p s at' of {
   Prelude.Just at'' -> cellIn array at'';
   Prelude.Nothing -> Prelude.Nothing}

window :: Profile0 -> Surface -> (([]) Cell) -> (([])
          ((,) Prelude.Integer Prelude.Integer)) -> ((,) Prelude.Integer
          Prelude.Integer) -> Prelude.Maybe (([]) Prelude.Integer)
window p s array mask0 at' =
  case mask0 of {
   ([]) -> Prelude.Just ([]);
   (:) offset others ->
    case symbol p s array ((,) ((Prelude.+) (fst at') (fst offset))
           ((Prelude.+) (snd at') (snd offset))) of {
     Prelude.Just a ->
      case window p s array others at' of {
       Prelude.Just rest -> Prelude.Just ((:) a rest);
       Prelude.Nothing -> Prelude.Nothing};
     Prelude.Nothing -> Prelude.Nothing}}

positions :: Profile0 -> ([]) ((,) Prelude.Integer Prelude.Integer)
positions p =
  let {n1 = profileRows p} in
  let {n2 = profileColumns p} in
  flat_map (\r -> map (\c -> (,) r c) (upTo n2)) (upTo n1)

windows :: Profile0 -> Surface -> (([]) Cell) -> (([])
           ((,) Prelude.Integer Prelude.Integer)) -> ([])
           ((,) ((,) Prelude.Integer Prelude.Integer) (([]) Prelude.Integer))
windows p s array mask0 =
  flat_map (\at' ->
    case window p s array mask0 at' of {
     Prelude.Just content -> (:) ((,) at' content) ([]);
     Prelude.Nothing -> ([])}) (positions p)

rectangle :: Prelude.Integer -> Prelude.Integer -> ([])
             ((,) Prelude.Integer Prelude.Integer)
rectangle high wide =
  flat_map (\i -> map (\j -> (,) i j) (upTo wide)) (upTo high)

same :: (([]) Prelude.Integer) -> (([]) Prelude.Integer) -> Prelude.Bool
same a b =
  case a of {
   ([]) -> case b of {
            ([]) -> Prelude.True;
            (:) _ _ -> Prelude.False};
   (:) x a' ->
    case b of {
     ([]) -> Prelude.False;
     (:) y b' -> (Prelude.&&) ((Prelude.==) x y) (same a' b')}}

different :: (([]) (([]) Prelude.Integer)) -> Prelude.Integer
different contents =
  case contents of {
   ([]) -> 0;
   (:) content others ->
    (Prelude.+)
      (case existsb (same content) others of {
        Prelude.True -> 0;
        Prelude.False -> (\x -> x) 1}) (different others)}

locate :: (([]) Prelude.Integer) -> (([])
          ((,) ((,) Prelude.Integer Prelude.Integer) (([]) Prelude.Integer)))
          -> ([]) ((,) Prelude.Integer Prelude.Integer)
locate content found =
  map fst (filter (\w -> same content (snd w)) found)

differences :: (([]) Prelude.Integer) -> (([]) Prelude.Integer) ->
               Prelude.Integer
differences a b =
  case a of {
   ([]) -> 0;
   (:) x a' ->
    case b of {
     ([]) -> 0;
     (:) y b' ->
      (Prelude.+)
        (case (Prelude.==) x y of {
          Prelude.True -> 0;
          Prelude.False -> (\x -> x) 1}) (differences a' b')}}

distanceOf :: Prelude.Integer -> (([]) (([]) Prelude.Integer)) ->
              Prelude.Integer
distanceOf bound contents =
  case contents of {
   ([]) -> bound;
   (:) content others ->
    distanceOf
      (fold_left (\least other ->
        Prelude.min least (differences content other)) others bound) others}

packed :: Prelude.Integer -> (([]) Prelude.Integer) -> Prelude.Integer
packed q content =
  fold_left (\w a -> (Prelude.+) ((Prelude.*) q w) a) content 0

unpacked :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer -> ([])
            Prelude.Integer
unpacked q cells0 w =
  rev (digits q cells0 w)

data Certificate0 =
   Certificate Profile0 ((,) Prelude.Integer Prelude.Integer) (([])
                                                              ((,)
                                                              Prelude.Integer
                                                              Prelude.Integer)) 
 Prelude.Integer Prelude.Integer (([])
                                 ((,) ((,) Prelude.Integer Prelude.Integer)
                                 (([]) Prelude.Integer))) (([])
                                                          ((,)
                                                          Prelude.Integer
                                                          (([])
                                                          ((,)
                                                          ((,)
                                                          Prelude.Integer
                                                          Prelude.Integer)
                                                          Prelude.Integer)))) 
 (([]) (([]) Prelude.Integer)) (([]) Prelude.Integer) (([])
                                                      (([]) Prelude.Integer))

claimed :: Certificate0 -> Profile0
claimed c =
  case c of {
   Certificate claimed0 _ _ _ _ _ _ _ _ _ -> claimed0}

claimedWindow :: Certificate0 -> (,) Prelude.Integer Prelude.Integer
claimedWindow c =
  case c of {
   Certificate _ claimedWindow0 _ _ _ _ _ _ _ _ -> claimedWindow0}

mask :: Certificate0 -> ([]) ((,) Prelude.Integer Prelude.Integer)
mask c =
  case c of {
   Certificate _ _ mask0 _ _ _ _ _ _ _ -> mask0}

claimedWindows :: Certificate0 -> Prelude.Integer
claimedWindows c =
  case c of {
   Certificate _ _ _ claimedWindows0 _ _ _ _ _ _ -> claimedWindows0}

claimedPeriod :: Certificate0 -> Prelude.Integer
claimedPeriod c =
  case c of {
   Certificate _ _ _ _ claimedPeriod0 _ _ _ _ _ -> claimedPeriod0}

factors :: Certificate0 -> ([])
           ((,) ((,) Prelude.Integer Prelude.Integer) (([]) Prelude.Integer))
factors c =
  case c of {
   Certificate _ _ _ _ _ factors0 _ _ _ _ -> factors0}

primes :: Certificate0 -> ([])
          ((,) Prelude.Integer
          (([]) ((,) ((,) Prelude.Integer Prelude.Integer) Prelude.Integer)))
primes c =
  case c of {
   Certificate _ _ _ _ _ _ primes0 _ _ _ -> primes0}

vectors :: Certificate0 -> ([]) (([]) Prelude.Integer)
vectors c =
  case c of {
   Certificate _ _ _ _ _ _ _ vectors0 _ _ -> vectors0}

cells :: Certificate0 -> ([]) Prelude.Integer
cells c =
  case c of {
   Certificate _ _ _ _ _ _ _ _ cells0 _ -> cells0}

inverse :: Certificate0 -> ([]) (([]) Prelude.Integer)
inverse c =
  case c of {
   Certificate _ _ _ _ _ _ _ _ _ inverse0 -> inverse0}

isPrime :: Prelude.Integer -> Prelude.Bool
isPrime l =
  (Prelude.&&)
    ((Prelude.&&) ((Prelude.<=) ((\x -> x) ((\x -> 2 Prelude.* x) 1)) l)
      ((Prelude.<) l
        ((Prelude.^) ((\x -> x) ((\x -> 2 Prelude.* x) 1)) ((\x -> x)
          ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x Prelude.+ 1)
          ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x)
          ((\x -> 2 Prelude.* x) 1)))))))))
    (forallb (\d ->
      (Prelude.||) ((Prelude.<=) l d)
        (Prelude.not ((Prelude.==) (modulo l d) 0)))
      (skipn (Prelude.succ (Prelude.succ 0))
        (upTo
          ((Prelude.^) ((\x -> x) ((\x -> 2 Prelude.* x) 1))
            ((Prelude.+)
              (div (size0 l) ((\x -> x) ((\x -> 2 Prelude.* x) 1)))
              ((\x -> x) 1))))))

areCodes :: Prelude.Integer -> (([]) Prelude.Integer) -> Prelude.Bool
areCodes q a =
  forallb (\x -> (Prelude.<) x q) a

hasLength :: Prelude.Integer -> (([]) a1) -> Prelude.Bool
hasLength n a =
  (Prelude.==) (length a) n

combination :: (Arithmetic0 a1) -> Prelude.Integer -> (([]) a1) -> (([])
               (([]) a1)) -> ([]) a1
combination k n cs vs =
  case cs of {
   ([]) -> repeat (zero k) n;
   (:) c cs' ->
    case vs of {
     ([]) -> repeat (zero k) n;
     (:) v vs' -> plus k (scale k c v) (combination k n cs' vs')}}

identity :: (Arithmetic0 a1) -> Prelude.Integer -> ([]) (([]) a1)
identity k n =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> ([]))
    (\n' -> (:) ((:) (one k) (repeat (zero k) n'))
    (map (\x -> (:) (zero k) x) (identity k n')))
    n

sameRows :: (([]) (([]) Prelude.Integer)) -> (([]) (([]) Prelude.Integer)) ->
            Prelude.Bool
sameRows a b =
  case a of {
   ([]) -> case b of {
            ([]) -> Prelude.True;
            (:) _ _ -> Prelude.False};
   (:) x a' ->
    case b of {
     ([]) -> Prelude.False;
     (:) y b' -> (Prelude.&&) (same x y) (sameRows a' b')}}

ascending :: (([]) Prelude.Integer) -> Prelude.Bool
ascending a =
  case a of {
   ([]) -> Prelude.True;
   (:) x a' ->
    case a' of {
     ([]) -> Prelude.True;
     (:) y _ -> (Prelude.&&) ((Prelude.<) x y) (ascending a')}}

fieldIsRight :: Certificate0 -> Prelude.Bool
fieldIsRight c =
  let {p = claimed c} in
  let {q = profileOrder p} in
  let {p0 = characteristicOf q} in
  let {m = pred (length (profileModulus p))} in
  (Prelude.&&)
    ((Prelude.&&)
      ((Prelude.&&)
        ((Prelude.&&)
          ((Prelude.&&)
            ((Prelude.&&)
              ((Prelude.<=) ((\x -> x) ((\x -> 2 Prelude.* x) 1)) q)
              ((Prelude.<=) q ((\x -> x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) 1)))))))))))
            ((Prelude.<=) ((\x -> x) 1) ((\n -> n) m)))
          ((Prelude.<=) ((\n -> n) m) ((\x -> x) ((\x -> 2 Prelude.* x)
            ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x) 1))))))
        ((Prelude.==) ((Prelude.^) p0 ((\n -> n) m)) q))
      (areCodes p0 (profileModulus p)))
    ((Prelude.==) (last (profileModulus p) 0) ((\x -> x) 1))

polynomialIsRight :: Certificate0 -> Prelude.Bool
polynomialIsRight c =
  let {p = claimed c} in
  let {q = profileOrder p} in
  let {h = lower p} in
  let {n = length h} in
  (Prelude.&&)
    ((Prelude.&&)
      ((Prelude.&&)
        ((Prelude.&&)
          ((Prelude.&&) (hasLength (Prelude.succ n) (profilePolynomial p))
            ((Prelude.<=) ((\x -> x) 1) ((\n -> n) n)))
          (areCodes q (profilePolynomial p))) (areCodes q h))
      ((Prelude.==) (last (profilePolynomial p) 0) ((\x -> x) 1)))
    (Prelude.not ((Prelude.==) (hd 0 (profilePolynomial p)) 0))

orderIsRight :: Certificate0 -> Prelude.Bool
orderIsRight c =
  let {p = claimed c} in
  let {k = field p} in
  let {h = lower p} in
  (Prelude.&&)
    ((Prelude.&&)
      ((Prelude.&&)
        ((Prelude.&&)
          ((Prelude.&&)
            ((Prelude.&&) ((Prelude.==) (claimedPeriod c) (period p))
              (forallb (\shown -> isPrime (fst shown)) (primes c)))
            (ascending (map (\f -> fst (fst f)) (factors c))))
          (forallb (\f ->
            (Prelude.&&)
              ((Prelude.&&) (isPrime (fst (fst f)))
                ((Prelude.<=) ((\x -> x) 1) (snd (fst f))))
              ((Prelude.<) (snd (fst f)) ((\x -> x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) ((\x -> 2 Prelude.* x)
                ((\x -> 2 Prelude.* x) 1))))))))))))))) (factors c)))
        ((Prelude.==)
          (fold_right (Prelude.*) ((\x -> x) 1)
            (map (\f -> (Prelude.^) (fst (fst f)) (snd (fst f))) (factors c)))
          (period p))) (same (rootPower k h (period p)) (unit0 k h)))
    (forallb (\f ->
      let {residue = rootPower k h (div (period p) (fst (fst f)))} in
      (Prelude.&&) (same residue (snd f))
        (Prelude.not (same residue (unit0 k h)))) (factors c))

foldIsRight :: Certificate0 -> Prelude.Bool
foldIsRight c =
  let {p = claimed c} in
  let {q = profileOrder p} in
  let {h = lower p} in
  let {n = length h} in
  let {n1 = profileRows p} in
  let {n2 = profileColumns p} in
  (Prelude.&&)
    ((Prelude.&&)
      ((Prelude.&&)
        ((Prelude.&&) (hasLength n (profileState p))
          (areCodes q (profileState p)))
        (Prelude.not (forallb (\a -> (Prelude.==) a 0) (profileState p))))
      ((Prelude.==) ((Prelude.*) n1 n2) (period p)))
    (case profileFolding p of {
      Diagonal -> (Prelude.==) (Prelude.gcd n1 n2) ((\x -> x) 1);
      RowMajor -> Prelude.True})

maskIsRight :: Certificate0 -> Prelude.Bool
maskIsRight c =
  let {p = claimed c} in
  let {n1 = profileRows p} in
  let {n2 = profileColumns p} in
  let {
   high = fold_right Prelude.max 0
            (map (\at' -> (Prelude.+) (fst at') ((\x -> x) 1)) (mask c))}
  in
  let {
   wide = fold_right Prelude.max 0
            (map (\at' -> (Prelude.+) (snd at') ((\x -> x) 1)) (mask c))}
  in
  let {
   seen = case profileSurface p of {
           Sheet ->
            (Prelude.*) (sub0 ((Prelude.+) n1 ((\x -> x) 1)) high)
              (sub0 ((Prelude.+) n2 ((\x -> x) 1)) wide);
           _ -> (Prelude.*) n1 n2}}
  in
  (Prelude.&&)
    ((Prelude.&&)
      ((Prelude.&&)
        ((Prelude.&&)
          ((Prelude.==)
            (different
              (map (\at' -> (:) (fst at') ((:) (snd at') ([]))) (mask c)))
            ((\n -> n) (length (mask c))))
          (samePlace (claimedWindow c) ((,) high wide)))
        ((Prelude.<=) ((\x -> x) 1) seen))
      ((Prelude.==) (claimedWindows c) seen))
    (case profileSurface p of {
      Torus ->
       case profileFolding p of {
        Diagonal -> Prelude.True;
        RowMajor -> Prelude.False};
      TwistedTorus ->
       case profileFolding p of {
        Diagonal -> Prelude.False;
        RowMajor -> Prelude.True};
      Sheet -> Prelude.True})

inverseBy :: Prelude.Integer -> Prelude.Integer -> Prelude.Integer ->
             Prelude.Integer -> Prelude.Integer -> Prelude.Integer ->
             Prelude.Integer
inverseBy steps b r r' t t' =
  (\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))
    (\_ -> t)
    (\steps' ->
    case (Prelude.==) r' 0 of {
     Prelude.True -> t;
     Prelude.False ->
      inverseBy steps' b r' (modulo r r') t'
        (modulo
          ((Prelude.+) t (sub0 b (modulo ((Prelude.*) (div r r') t') b))) b)})
    steps

exponent :: Certificate0 -> ((,) Prelude.Integer Prelude.Integer) ->
            Prelude.Integer
exponent c =
  let {p = claimed c} in
  let {n1 = profileRows p} in
  let {n2 = profileColumns p} in
  (\offset ->
  case offset of {
   (,) i j ->
    case profileFolding p of {
     Diagonal ->
      let {
       u = inverseBy
             ((\n -> n)
               ((Prelude.+)
                 ((Prelude.*) ((\x -> x) ((\x -> 2 Prelude.* x) 1))
                   (size0 n1)) ((\x -> x) ((\x -> 2 Prelude.* x) 1)))) n1 n1
             (modulo n2 n1) 0 ((\x -> x) 1)}
      in
      (Prelude.+) (modulo j n2)
        ((Prelude.*) n2
          (modulo
            ((Prelude.*) u
              (sub0 ((Prelude.+) i ((Prelude.*) n1 n2)) (modulo j n2))) n1));
     RowMajor ->
      modulo ((Prelude.+) ((Prelude.*) n2 i) j) ((Prelude.*) n1 n2)}})

exponentIsRight :: Certificate0 -> ((,) Prelude.Integer Prelude.Integer) ->
                   Prelude.Bool
exponentIsRight c =
  let {p = claimed c} in
  let {n1 = profileRows p} in
  let {n2 = profileColumns p} in
  (\offset ->
  case profileFolding p of {
   Diagonal ->
    (Prelude.&&)
      ((Prelude.==) (modulo (exponent c offset) n1) (modulo (fst offset) n1))
      ((Prelude.==) (modulo (exponent c offset) n2) (modulo (snd offset) n2));
   RowMajor -> Prelude.True})

chosen :: Certificate0 -> ([]) (([]) Prelude.Integer)
chosen c =
  map (\i -> nth ((\n -> n) i) (vectors c) ([])) (cells c)

rankIsRight :: Certificate0 -> Prelude.Bool
rankIsRight c =
  let {p = claimed c} in
  let {q = profileOrder p} in
  let {k = field p} in
  let {h = lower p} in
  let {n = length h} in
  (Prelude.&&)
    ((Prelude.&&)
      ((Prelude.&&)
        ((Prelude.&&)
          ((Prelude.&&)
            ((Prelude.&&)
              ((Prelude.&&) (forallb (exponentIsRight c) (mask c))
                (sameRows (vectors c)
                  (map (\offset -> rootPower k h (exponent c offset))
                    (mask c)))) (hasLength n (cells c)))
            (ascending (cells c)))
          (forallb (\i -> (Prelude.<) i ((\n -> n) (length (mask c))))
            (cells c))) (hasLength n (inverse c)))
      (forallb (\row -> (Prelude.&&) (hasLength n row) (areCodes q row))
        (inverse c)))
    (sameRows (map (\row -> combination k n row (chosen c)) (inverse c))
      (identity k n))

check :: Certificate0 -> Prelude.Bool
check c =
  (Prelude.&&)
    ((Prelude.&&)
      ((Prelude.&&)
        ((Prelude.&&) ((Prelude.&&) (fieldIsRight c) (polynomialIsRight c))
          (orderIsRight c)) (foldIsRight c)) (maskIsRight c)) (rankIsRight c)

