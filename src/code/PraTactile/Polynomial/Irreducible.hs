{-# OPTIONS_HADDOCK hide #-}

-- | Decides which polynomials over GF(q) are irreducible (Rabin's test), and counts them. Internal;
-- "PraTactile.Polynomial" exports it.
module PraTactile.Polynomial.Irreducible
  ( isIrreducible,
    countIrreducible,

    -- * What the test is made of
    powerMinusX,
    primeDivisors,
  )
where

import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Polynomial.Modulus
import PraTactile.Polynomial.Ring

-- | Whether a polynomial of degree n >= 1 has no factor of lower degree (Rabin, SIAM J. Comput. 9,
-- 1980): x^(q^n) = x modulo h, and x^(q^(n/l)) - x is coprime to h for every prime l that divides
-- n. O(n^3 + q n^2), but O(q n) if there is a root in GF(q), as for most polynomials.
isIrreducible :: KnownField k => Polynomial k -> Bool
isIrreducible h = case modulusOf h of
  Nothing -> False
  Just modulus ->
    let n = modulusDegree modulus
        coprime a = polynomialDegree (greatestCommonDivisor h a) == Just 0
     in -- Most polynomials have a root in GF(q), and powers are not needed.
        (n == 1 || all ((/= zero) . valueAt h) elements)
          && powerMinusX modulus n == 0
          && all (coprime . powerMinusX modulus . (n `div`)) (primeDivisors n)

-- | x^(q^d) - x modulo h.
powerMinusX :: forall k. KnownField k => Modulus k -> Int -> Polynomial k
powerMinusX modulus d = fromResidue (go d x) - fromResidue x
  where
    x = residueFrom modulus [zero, one]
    go :: Int -> Coefficients k -> Coefficients k
    go 0 a = a
    go i a = go (i - 1) $! frobenius modulus a

-- | The primes that divide a degree, ascending.
--
-- >>> primeDivisors 12
-- [2,3]
primeDivisors :: Int -> [Int]
primeDivisors n = [l | l <- [2 .. n], n `mod` l == 0, all (\d -> l `mod` d /= 0) [2 .. l - 1]]

-- | The number of monic irreducible polynomials of degree n, by Gauss's formula: (1/n) times the
-- sum of mu(d) q^(n/d) over the divisors d of n. It is 0 for n = 0. O(n) operations on integers up
-- to q^n.
countIrreducible :: forall k. KnownField k => Proxy k -> Natural -> Natural
countIrreducible k n
  | n == 0 = 0
  | otherwise = fromInteger (sum (map term subsets) `div` toInteger n)
  where
    term primes = moebius primes * q ^ (n `div` fromIntegral (product primes))
    q = toInteger (fieldOrder k)
    -- mu(d) is nonzero exactly for products d of different primes.
    subsets = foldr (\l rest -> rest ++ map (l :) rest) [[]] (primeDivisors (fromIntegral n))
    moebius primes = if even (length primes) then 1 else -1
