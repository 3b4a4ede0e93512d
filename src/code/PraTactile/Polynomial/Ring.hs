{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE RoleAnnotations #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- The ring of polynomials over GF(q). Internal; "PraTactile.Polynomial" exports it.
module PraTactile.Polynomial.Ring
  ( Polynomial
  , polynomial
  , polynomialFromCodes
  , coefficients
  , constant
  , variable
  , polynomialDegree
  , leadingCoefficient
  , isMonic
  , quotientRemainder
  , greatestCommonDivisor
  , powerModulo
  , monicPolynomials
  ) where

import Data.List (dropWhileEnd, genericTake, unfoldr)
import Data.Maybe (listToMaybe)
import Data.Ord (comparing)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Field

-- | A polynomial over the field k: its coefficients, constant term first, the last one not
-- zero. 'Ord' compares the coefficients from the highest degree down, after the degrees.
newtype Polynomial (k :: Field) = Polynomial [GF k]
  deriving stock (Eq)

type role Polynomial nominal

instance Ord (Polynomial k) where
  compare = comparing (\(Polynomial cs) -> (length cs, reverse cs))

instance KnownField k => Show (Polynomial k) where
  showsPrec d (Polynomial cs) = showParen (d > 10) (showString "polynomial " . shows cs)

-- | 'fromInteger' gives the constants that come from Z; 'abs' is the identity and 'signum' is 1 except
-- at 0.
instance KnownField k => Num (Polynomial k) where
  Polynomial a + Polynomial b = polynomial (zipLong (+) a b)
  Polynomial a - Polynomial b = polynomial (zipLong (-) a b)
  Polynomial a * Polynomial b = polynomial (foldr (\x rest -> zipLong (+) (map (x *) b) (zero : rest)) [] a)
  negate (Polynomial a) = Polynomial (map negate a)
  abs = id
  signum (Polynomial a) = if null a then Polynomial [] else constant one
  fromInteger = constant . fromInteger

-- | Coefficientwise, the shorter list continued by zeros.
zipLong :: (GF k -> GF k -> GF k) -> [GF k] -> [GF k] -> [GF k]
zipLong f (a : as) (b : bs) = f a b : zipLong f as bs
zipLong f [] bs = map (f zero) bs
zipLong f as [] = map (`f` zero) as

-- | The polynomial with these coefficients, constant term first; zeros at the end are dropped.
polynomial :: [GF k] -> Polynomial k
polynomial = Polynomial . dropWhileEnd (== zero)

-- | The polynomial whose coefficients have these codes, constant term first. Refuses codes not below q.
polynomialFromCodes :: KnownField k => [Natural] -> Either FieldError (Polynomial k)
polynomialFromCodes = fmap polynomial . elementsFromCodes

-- | The coefficients, constant term first, the last one not zero; none for the zero polynomial.
coefficients :: Polynomial k -> [GF k]
coefficients (Polynomial cs) = cs

-- | The polynomial of degree 0 with this value, or the zero polynomial.
constant :: GF k -> Polynomial k
constant c = polynomial [c]

-- | x.
variable :: Polynomial k
variable = Polynomial [zero, one]

-- | The degree; 'Nothing' for the zero polynomial.
polynomialDegree :: Polynomial k -> Maybe Int
polynomialDegree (Polynomial cs) = if null cs then Nothing else Just (length cs - 1)

-- | The coefficient of the highest degree; 'Nothing' for the zero polynomial.
leadingCoefficient :: Polynomial k -> Maybe (GF k)
leadingCoefficient (Polynomial cs) = listToMaybe (reverse cs)

-- | Whether the leading coefficient is 1.
isMonic :: Polynomial k -> Bool
isMonic a = leadingCoefficient a == Just one

-- | Division with remainder, the remainder of lower degree than the divisor. 'Nothing' exactly when
-- the divisor is zero.
quotientRemainder :: KnownField k => Polynomial k -> Polynomial k -> Maybe (Polynomial k, Polynomial k)
quotientRemainder (Polynomial a) (Polynomial b) = case reverse b of
  [] -> Nothing
  leading : lower -> do
    inverted <- either (const Nothing) Just (inverse leading)
    let steps = length a - length lower
        (quotient, rest) = longDivision steps (map (inverted *) lower) (reverse a)
    pure (polynomial (reverse (map (inverted *) quotient)), polynomial (reverse rest))

-- | That many steps of the division by a monic polynomial whose lower coefficients are given, all
-- highest degree first.
longDivision :: KnownField k => Int -> [GF k] -> [GF k] -> ([GF k], [GF k])
longDivision steps lower a = case a of
  top : rest | steps > 0 ->
    let (quotient, remainder) = longDivision (steps - 1) lower (zipLong (-) rest (map (top *) lower))
     in (top : quotient, remainder)
  _ -> ([], a)

-- | The monic greatest common divisor, by Euclid; zero when both are zero.
greatestCommonDivisor :: KnownField k => Polynomial k -> Polynomial k -> Polynomial k
greatestCommonDivisor a b = case quotientRemainder a b of
  Just (_, r) -> greatestCommonDivisor b r
  Nothing -> case leadingCoefficient a >>= either (const Nothing) Just . inverse of
    Just inverted -> Polynomial (map (inverted *) (coefficients a))
    Nothing -> a

-- | @powerModulo h a e@ is a^e modulo h, by squaring from the highest binary digit of e down, so
-- that the other factor is always a itself, which for powers of x is short. 'Nothing' exactly when
-- h is zero.
powerModulo :: KnownField k => Polynomial k -> Polynomial k -> Natural -> Maybe (Polynomial k)
powerModulo h a = go
 where
  reduce b = snd <$> quotientRemainder b h
  go 0 = reduce 1
  go e = do
    root <- go (e `div` 2)
    square <- reduce (root * root)
    if odd e then reduce (square * a) else Just square

-- | All monic polynomials of a degree, ascending: q^n of them, made as they are asked for.
monicPolynomials :: forall k. KnownField k => Natural -> [Polynomial k]
monicPolynomials n = map monicOf [0 .. q ^ n - 1]
 where
  q = toInteger (fieldOrder (Proxy :: Proxy k))
  monicOf index = Polynomial (genericTake n (unfoldr digit index ++ repeat zero) ++ [one])
  digit 0 = Nothing
  digit i = Just (either (const zero) id (fromCode (fromInteger (i `mod` q))), i `div` q)
