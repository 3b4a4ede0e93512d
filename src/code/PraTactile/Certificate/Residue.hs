{-# OPTIONS_HADDOCK hide #-}

-- | Arithmetic modulo a polynomial by Horner's rule. It is slow, short, and independent of the
-- arithmetic that it helps to check. Internal.
module PraTactile.Certificate.Residue
  ( Modulus,
    modulusFrom,
    reversed,
    degree,
    rootPower,
    powersAt,
  )
where

import Data.List (foldl')
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Vector (addScaled)
import PraTactile.LinearCode.Elimination

-- | A monic polynomial of degree n >= 1 with a nonzero constant term, by its n lower coefficients,
-- constant term first.
newtype Modulus (k :: Field) = Modulus (Row k)

type role Modulus nominal

-- | The polynomial with these coefficients, constant term first, if it is monic of degree at least
-- 1 with a nonzero constant term.
modulusFrom :: [GF k] -> Maybe (Modulus k)
modulusFrom stated = case (stated, reverse stated) of
  (constantTerm : _ : _, leading : _)
    | leading == one && constantTerm /= zero ->
      Just (Modulus (rowFromList (take (length stated - 1) stated)))
  _ -> Nothing

-- | The reciprocal x^n h(1/x) / h(0). It always exists, since h(0) is not 0; the 'Maybe' is that of
-- 'inverse' and 'modulusFrom'.
reversed :: KnownField k => Modulus k -> Maybe (Modulus k)
reversed (Modulus lower) = case rowToList lower of
  constantTerm : rest ->
    either
      (const Nothing)
      (\a -> modulusFrom (map (a *) (one : reverse rest) ++ [one]))
      (inverse constantTerm)
  [] -> Nothing

-- | The degree n.
degree :: Modulus k -> Int
degree (Modulus lower) = Primitive.length lower

-- | x^e modulo h, by its n coefficients, that of 1 first.
rootPower :: KnownField k => Modulus k -> Natural -> [GF k]
rootPower h e = concat (powersAt h [e])

-- | x^e modulo h for several e; the squares are computed once.
powersAt :: KnownField k => Modulus k -> [Natural] -> [[GF k]]
powersAt h = map (rowToList . foldl' (product' h) (unit h) . factors)
  where
    factors e = [square | (square, True) <- zip squares (binary e)]
    -- x, x^2, x^4, ...
    squares = iterate (\a -> product' h a a) (timesRoot h (unit h))
    binary e = map odd (takeWhile (> 0) (iterate (`div` 2) e))

unit :: Modulus k -> Row k
unit h = rowFromList (take (degree h) (one : repeat zero))

-- | The product of a and b modulo h, by Horner's rule from the highest coefficient of b down.
product' :: KnownField k => Modulus k -> Row k -> Row k -> Row k
product' h a =
  Primitive.foldr (\c acc -> addScaled c a (timesRoot h acc)) (Primitive.map (const zero) a)

-- | x a(x) modulo h: the coefficients move up, and x^n is replaced by its residue.
timesRoot :: KnownField k => Modulus k -> Row k -> Row k
timesRoot h@(Modulus lower) a =
  addScaled (negate top) lower (Primitive.cons zero (Primitive.take (degree h - 1) a))
  where
    top = Primitive.foldl' (\_ x -> x) zero a
