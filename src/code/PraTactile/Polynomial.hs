{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE RoleAnnotations #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Polynomials over GF(q), and which of them are primitive: those whose root alpha
-- generates GF(q^n), so that the shift register of the paper's section II runs through
-- all q^n - 1 non-zero states.
module PraTactile.Polynomial
  ( -- * Polynomials
    Polynomial
  , polynomial
  , polynomialFromCodes
  , coefficients
  , constant
  , variable
  , polynomialDegree
  , leadingCoefficient
  , isMonic

    -- * Division
  , quotientRemainder
  , greatestCommonDivisor
  , powerModulo

    -- * Irreducible polynomials
  , isIrreducible

    -- * Primitive polynomials
  , Primitive
  , checkPrimitive
  , primitivePolynomial
  , primitiveDegree
  , period
  , reciprocal
  , PolynomialError (..)

    -- * Search
  , monicPolynomials
  , primitivePolynomials
  , firstPrimitive
  , countPrimitive
  ) where

import Data.Bifunctor (bimap)
import Data.List (foldl')
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Factorisation
import PraTactile.Field
import PraTactile.Polynomial.Ring

-- | Why a polynomial is not accepted as primitive.
data PolynomialError
  = -- | The degree is less than 1, so that there is no sequence.
    PolynomialConstant
  | -- | The leading coefficient has this code instead of 1.
    PolynomialNotMonic Natural
  | -- | The constant term is 0, so that x is a factor and the shift register forgets.
    ConstantTermZero
  | -- | The polynomial is a product of two of lower degree.
    PolynomialReducible
  | -- | The polynomial is irreducible, but its root has this order instead of q^n - 1.
    PolynomialNotPrimitive Natural
  | -- | Whether the root has order q^n - 1 is not known, because q^n - 1 was not factored.
    OrderNotFactored FactorError
  | -- | No polynomial of the degree is primitive: a theorem says that this cannot be.
    NoPrimitivePolynomial Natural
  deriving stock (Eq, Show)

-- | A monic polynomial of degree n >= 1 that has been shown to be primitive: irreducible, and with
-- a root of order q^n - 1. Only 'checkPrimitive' and the search make one.
newtype Primitive (k :: Field) = Primitive (Polynomial k)
  deriving stock (Eq, Ord)

type role Primitive nominal

instance KnownField k => Show (Primitive k) where
  showsPrec d (Primitive h) = showsPrec d h

-- | Whether a polynomial of degree n >= 1 has no factor of lower degree (Rabin's test): x^(q^n) = x
-- modulo h, and x^(q^(n/l)) - x is coprime to h for every prime l that divides n.
isIrreducible :: forall k. KnownField k => Polynomial k -> Bool
isIrreducible h = case polynomialDegree h of
  Just n | n >= 1 -> frobenius n == quotientBy variable && all (coprime . frobenius . (n `div`)) (primesOf n)
  _ -> False
 where
  q = fromIntegral (fieldOrder (Proxy :: Proxy k)) :: Natural
  quotientBy a = snd <$> quotientRemainder a h
  frobenius d = powerModulo h variable (q ^ d)
  coprime = maybe False (\power' -> polynomialDegree (greatestCommonDivisor h (power' - variable)) == Just 0)
  primesOf n = [l | l <- [2 .. n], n `mod` l == 0, all (\d -> l `mod` d /= 0) [2 .. l - 1]]

-- | Check that a polynomial is primitive. See Note [Primitive without irreducible]. Refuses, each
-- with its own 'PolynomialError', polynomials of degree 0, not monic, divisible by x, reducible, or
-- with a root of lower order; and those of a degree so large that q^n - 1 is not factored.
checkPrimitive :: forall k. KnownField k => Polynomial k -> Either PolynomialError (Primitive k)
checkPrimitive h = case (polynomialDegree h, leadingCoefficient h) of
  (Just n, Just leading)
    | n < 1 -> Left PolynomialConstant
    | leading /= one -> Left (PolynomialNotMonic (fromIntegral (toCode leading)))
    | take 1 (coefficients h) == [zero] -> Left ConstantTermZero
    | Right primes <- factors n, rootGenerates primes n h -> Right (Primitive h)
    | not (isIrreducible h) -> Left PolynomialReducible
    | otherwise -> Left (either OrderNotFactored (PolynomialNotPrimitive . rootOrder n h) (factors n))
  _ -> Left PolynomialConstant
 where
  factors n = orderPrimes (Proxy :: Proxy k) (fromIntegral n)

-- | Whether x has order q^n - 1 modulo h, of degree n, given the primes that divide q^n - 1.
rootGenerates :: KnownField k => [Natural] -> Int -> Polynomial k -> Bool
rootGenerates primes n h = rootPowerIsOne h full && not (any (rootPowerIsOne h . (full `div`)) primes)
 where
  full = fullPeriod h n

-- | The order of x modulo an irreducible h: it divides q^n - 1.
rootOrder :: KnownField k => Int -> Polynomial k -> [Natural] -> Natural
rootOrder n h = foldl' withoutPrime (fullPeriod h n)
 where
  withoutPrime e l
    | e `mod` l == 0 && rootPowerIsOne h (e `div` l) = withoutPrime (e `div` l) l
    | otherwise = e

rootPowerIsOne :: KnownField k => Polynomial k -> Natural -> Bool
rootPowerIsOne h e = powerModulo h variable e == Just (constant one)

{- Note [Primitive without irreducible]
   If x has order q^n - 1 in GF(q)[x]/h, its powers are q^n - 1 distinct units: all non-zero
   residues. So the ring is a field and h irreducible, without a test of its own; irreducibility is
   tested only to tell why a polynomial fails. That x has this order is shown by x^N = 1, N = q^n - 1,
   and x^(N/l) /= 1 for each prime l that divides N. -}

-- | q^n - 1.
fullPeriod :: forall k. KnownField k => Polynomial k -> Int -> Natural
fullPeriod _ n = fromIntegral (fieldOrder (Proxy :: Proxy k)) ^ n - 1

-- | The primes that divide q^n - 1 = p^(m n) - 1.
orderPrimes :: KnownField k => Proxy k -> Natural -> Either FactorError [Natural]
orderPrimes k n = map fst <$> orderFactors k n

orderFactors :: KnownField k => Proxy k -> Natural -> Either FactorError [(Natural, Natural)]
orderFactors k n = factorisePowerMinusOne p (m * n)
 where
  p = fromIntegral (fieldCharacteristic k)
  m = fromIntegral (fieldDegree k)

-- | The polynomial that was shown to be primitive.
primitivePolynomial :: Primitive k -> Polynomial k
primitivePolynomial (Primitive h) = h

-- | n, the degree; at least 1.
primitiveDegree :: Primitive k -> Int
primitiveDegree (Primitive h) = length (coefficients h) - 1

-- | q^n - 1: the order of the root, and the period of the sequence.
period :: KnownField k => Primitive k -> Natural
period h@(Primitive a) = fullPeriod a (primitiveDegree h)

-- | The monic reciprocal x^n h(1/x) / h(0), whose root is the inverse of the root of h and so of
-- the same order.
reciprocal :: forall k. KnownField k => Primitive k -> Primitive k
reciprocal (Primitive h) = Primitive (polynomial (map (inverted *) (reverse (coefficients h))))
 where
  -- h(0) is not zero, and c^(q - 2) is the inverse of such a c.
  inverted = power (sum (take 1 (coefficients h))) (fromIntegral (fieldOrder (Proxy :: Proxy k) - 2))

-- | The primitive polynomials of a degree n >= 1, ascending (coefficients compared from the highest
-- degree down), made as they are asked for. Refuses degree 0, and degrees for which q^n - 1 is not
-- factored.
primitivePolynomials :: forall k. KnownField k => Natural -> Either PolynomialError [Primitive k]
primitivePolynomials n
  | n == 0 = Left PolynomialConstant
  | otherwise = case orderPrimes (Proxy :: Proxy k) n of
      Left unknown -> Left (OrderNotFactored unknown)
      Right primes -> Right (map Primitive (filter (generates primes) (monicPolynomials n)))
 where
  generates primes h = take 1 (coefficients h) /= [zero] && rootGenerates primes (fromIntegral n) h

-- | The first of 'primitivePolynomials'. Over GF(4), degree 4, it is the paper's x^4 + x^2 + A x + A^2.
firstPrimitive :: KnownField k => Natural -> Either PolynomialError (Primitive k)
firstPrimitive n = primitivePolynomials n >>= \found -> case found of
  h : _ -> Right h
  [] -> Left (NoPrimitivePolynomial n)

-- | How many primitive polynomials of degree n there are: phi(q^n - 1) / n, phi being Euler's
-- function. Refuses as 'primitivePolynomials' does.
countPrimitive :: KnownField k => Proxy k -> Natural -> Either PolynomialError Natural
countPrimitive k n
  | n == 0 = Left PolynomialConstant
  | otherwise = bimap OrderNotFactored ((`div` n) . totient) (orderFactors k n)
