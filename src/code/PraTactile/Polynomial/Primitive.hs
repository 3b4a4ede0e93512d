{-# OPTIONS_HADDOCK hide #-}

-- | Primitive polynomials over GF(q), and the check that makes one. Internal;
-- "PraTactile.Polynomial" exports all but the constructor and the modulus.
module PraTactile.Polynomial.Primitive
  ( Primitive (Primitive),
    primitivePolynomial,
    primitiveDegree,
    primitiveModulus,
    period,
    periodFactors,
    reciprocal,

    -- * Checking
    checkPrimitive,
    primitiveAmong,
    countPrimitive,
    PolynomialError (..),
  )
where

import Control.Monad (unless)
import Data.Bifunctor (first)
import Data.Function (on)
import Data.List (foldl')
import Data.Maybe (mapMaybe)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Factorisation
import PraTactile.Field
import PraTactile.Polynomial.Irreducible
import PraTactile.Polynomial.Modulus
import PraTactile.Polynomial.Ring

-- | Why a polynomial is not accepted as primitive.
data PolynomialError
  = -- | The degree is less than 1, so there is no sequence.
    PolynomialConstant
  | -- | The leading coefficient has this code instead of 1.
    PolynomialNotMonic Natural
  | -- | The constant term is 0, so x is a factor and the shift register forgets its state.
    ConstantTermZero
  | -- | The polynomial is a product of two of lower degree.
    PolynomialReducible
  | -- | The polynomial is irreducible, but its root has this order instead of q^n - 1.
    PolynomialNotPrimitive Natural
  | -- | It is unknown whether the root has order q^n - 1, because q^n - 1 was not factored.
    OrderNotFactored FactorError
  | -- | No polynomial of the degree is primitive, which a theorem excludes.
    NoPrimitivePolynomial Natural
  deriving stock (Eq, Show)

-- | A monic polynomial of degree n >= 1 that is proved to be primitive: it is irreducible, and its
-- root has order q^n - 1. Only 'checkPrimitive', the search, and the check of a certificate make
-- one.
data Primitive (k :: Field) = Primitive
  { -- | The polynomial that was shown to be primitive.
    primitivePolynomial :: Polynomial k,
    -- | The primes that divide q^n - 1, ascending, each with its exponent.
    periodFactors :: [(Natural, Natural)],
    -- | Arithmetic modulo the polynomial.
    primitiveModulus :: Modulus k
  }

type role Primitive nominal

instance Eq (Primitive k) where
  (==) = (==) `on` primitivePolynomial

instance Ord (Primitive k) where
  compare = compare `on` primitivePolynomial

instance KnownField k => Show (Primitive k) where
  showsPrec d = showsPrec d . primitivePolynomial

-- | The degree n, at least 1.
primitiveDegree :: Primitive k -> Int
primitiveDegree = modulusDegree . primitiveModulus

-- | q^n - 1: the order of the root, and the period of the sequence.
period :: KnownField k => Primitive k -> Natural
period h = fullPeriod (primitiveModulus h)

-- | The monic reciprocal x^n h(1/x) / h(0). Its root is the inverse of h's root, so it has the same
-- order. O(n).
reciprocal :: KnownField k => Primitive k -> Primitive k
reciprocal h = maybe h (Primitive reversed (periodFactors h)) (modulusOf reversed)
  where
    -- h(0) is not zero, so the degree does not change.
    reversed = constant (normalising upsideDown) * upsideDown
    upsideDown = polynomial (reverse (coefficients (primitivePolynomial h)))

-- | Checks that a polynomial is primitive. Refuses, each with its own 'PolynomialError',
-- polynomials that have degree 0, are not monic, are divisible by x, are reducible, or have a root
-- of lower order. It also refuses degrees for which q^n - 1 cannot be factored; if q^n exceeds
-- 'largestPower' it does so at once, before those other checks. O(r (n^3 + q n^2)) for r primes
-- that divide N, after N is factored ('factorisePowerMinusOne'), which may take longer.
checkPrimitive :: forall k. KnownField k => Polynomial k -> Either PolynomialError (Primitive k)
checkPrimitive h = case (modulusOf h, leadingCoefficient h) of
  (Just modulus, Just leading)
    | leading /= one -> Left (PolynomialNotMonic (fromIntegral (toCode leading)))
    | valueAt h zero == zero -> Left ConstantTermZero
    | otherwise -> do
      first
        OrderNotFactored
        (uncurry checkPower (characteristicPower k (fromIntegral (modulusDegree modulus))))
      unless (isIrreducible h) (Left PolynomialReducible)
      factors <- orderFactors k (fromIntegral (modulusDegree modulus))
      if rootGenerates factors modulus
        then Right (Primitive h factors modulus)
        else Left (PolynomialNotPrimitive (rootOrder factors modulus))
  _ -> Left PolynomialConstant
  where
    k = Proxy :: Proxy k

-- | The candidates that are monic, of degree n >= 1 and primitive, in their order, computed lazily.
-- Refuses degree 0, and degrees for which q^n - 1 is not factored. N is factored once
-- ('factorisePowerMinusOne'). Then a candidate takes O(r (n^3 + q n^2)) for r primes that divide N.
-- It takes only O(q n), as most do, if it has a root in GF(q) or its constant term excludes that it
-- is primitive.
primitiveAmong ::
  forall k.
  KnownField k =>
  Natural ->
  [Polynomial k] ->
  Either PolynomialError [Primitive k]
primitiveAmong n candidates
  | n == 0 = Left PolynomialConstant
  | otherwise = (`mapMaybe` candidates) . witness <$> orderFactors (Proxy :: Proxy k) n
  where
    witness factors h
      | fmap fromIntegral (polynomialDegree h) == Just n && isMonic h && mayBePrimitive h = do
        modulus <- modulusOf h
        if rootGenerates factors modulus then Just (Primitive h factors modulus) else Nothing
      | otherwise = Nothing

-- | Two quick necessary conditions: see Note [Cheap refusals]. Few polynomials of high degree
-- satisfy them.
mayBePrimitive :: KnownField k => Polynomial k -> Bool
mayBePrimitive h = case polynomialDegree h of
  Just n ->
    hasFullOrder (power (-1) (fromIntegral n) * valueAt h zero)
      && (n == 1 || all ((/= zero) . valueAt h) elements)
  Nothing -> False
  where
    hasFullOrder a = maybe False ((== 1) . gcd (fieldOrder h - 1)) (logarithm a)

{- Note [Cheap refusals]
   ~~~~~~~~~~~~~~~~~~~~~
   Let alpha be the root of an irreducible h. Its norm alpha^((q^n - 1)/(q - 1)) is (-1)^n h(0). If
   alpha has order q^n - 1, its norm has order q - 1. And an irreducible h of degree 2 or more has
   no root in GF(q). -}

{- Note [Primitive without irreducible]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   If x has order q^n - 1 in GF(q)[x]/h, its powers are q^n - 1 distinct units, so they are all
   nonzero residues. Then the ring is a field and h is irreducible, without a separate test.
   Irreducibility is tested only to say why a polynomial fails. That x has this order follows from
   x^N = 1, with N = q^n - 1, and x^(N/l) /= 1 for each prime l that divides N. -}

-- | Whether x has order q^n - 1 modulo h, of degree n, given the prime factors of q^n - 1. See Note
-- [Primitive without irreducible].
rootGenerates :: KnownField k => [(Natural, Natural)] -> Modulus k -> Bool
rootGenerates factors modulus =
  rootPowerIsOne modulus full && not (any (rootPowerIsOne modulus . (full `div`) . fst) factors)
  where
    full = fullPeriod modulus

-- | The order of x modulo an irreducible h, which divides q^n - 1.
rootOrder :: KnownField k => [(Natural, Natural)] -> Modulus k -> Natural
rootOrder factors modulus = foldl' withoutPrime (fullPeriod modulus) (map fst factors)
  where
    withoutPrime e l
      | e `mod` l == 0 && rootPowerIsOne modulus (e `div` l) = withoutPrime (e `div` l) l
      | otherwise = e

rootPowerIsOne :: KnownField k => Modulus k -> Natural -> Bool
rootPowerIsOne modulus e = powerOfX modulus e == residueOne modulus

-- | q^n - 1.
fullPeriod :: forall k. KnownField k => Modulus k -> Natural
fullPeriod modulus = fromIntegral (fieldOrder (Proxy :: Proxy k)) ^ modulusDegree modulus - 1

-- | The factors of q^n - 1 = p^(m n) - 1.
orderFactors :: KnownField k => Proxy k -> Natural -> Either PolynomialError [(Natural, Natural)]
orderFactors k n = first OrderNotFactored (uncurry factorisePowerMinusOne (characteristicPower k n))

-- | p and m n, for which q^n = p^(m n).
characteristicPower :: KnownField k => Proxy k -> Natural -> (Natural, Natural)
characteristicPower k n = (fromIntegral (fieldCharacteristic k), fromIntegral (fieldDegree k) * n)

-- | The number of primitive polynomials of degree n: phi(q^n - 1) / n, where phi is Euler's
-- function. Refuses what 'primitiveAmong' refuses. N is factored ('factorisePowerMinusOne').
countPrimitive :: KnownField k => Proxy k -> Natural -> Either PolynomialError Natural
countPrimitive k n
  | n == 0 = Left PolynomialConstant
  | otherwise = (`div` n) . totient <$> orderFactors k n
