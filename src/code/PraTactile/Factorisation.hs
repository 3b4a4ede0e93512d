-- | Factors and primes of integers, as needed for the order of a polynomial's root. A polynomial h
-- is primitive when its root has order exactly q^n - 1, and the primes that divide q^n - 1 decide
-- that. Every answer is proved; if the allowed effort does not suffice, the function refuses.
-- Imports base only.
module PraTactile.Factorisation
  ( -- * Factorisation
    factorise,
    factorisePowerMinusOne,
    checkPower,
    largestPower,
    cyclotomicValues,
    FactorError (..),

    -- * Primality
    isPrime,
    millerRabinDomain,
    pocklingtonFactors,
    isPocklingtonWitness,

    -- * Euler's function
    totient,
  )
where

import Data.List (group, sort)
import Numeric.Natural (Natural)
import PraTactile.Factorisation.Divisor
import PraTactile.Factorisation.Prime

-- | The primes that divide a number, ascending, each with its exponent. Refuses 0; a number with
-- two prime factors of more than about 12 digits; and one with a prime above 'millerRabinDomain'
-- for which 'pocklingtonFactors' do not suffice. O(sqrt p) products modulo the number for its
-- second largest prime p, at most 2^23.
--
-- >>> factorise (2 ^ 64 - 1)
-- Right [(3,1),(5,1),(17,1),(257,1),(641,1),(65537,1),(6700417,1)]
factorise :: Natural -> Either FactorError [(Natural, Natural)]
factorise 0 = Left FactorisationOfZero
factorise n = collect <$> primeFactors n

-- | The factorisation of b^n - 1 from its algebraic factors, the 'cyclotomicValues' at b of the
-- divisors of n. Refuses b < 2 and n = 0, at once what 'checkPower' refuses, and then what
-- 'factorise' refuses. The cost is that of 'factorise' for each value.
--
-- >>> factorisePowerMinusOne 4 4
-- Right [(3,1),(5,1),(17,1)]
factorisePowerMinusOne :: Natural -> Natural -> Either FactorError [(Natural, Natural)]
factorisePowerMinusOne b n
  | b < 2 || n == 0 = Left FactorisationOfZero
  | otherwise =
    checkPower b n >> collect . concat <$> mapM (primeFactors . snd) (cyclotomicValues b n)

-- | Refuses b and n if b^n exceeds 'largestPower', without computing much.
--
-- >>> checkPower 2 1000000
-- Left (PowerTooLarge 2 1000000)
checkPower :: Natural -> Natural -> Either FactorError ()
checkPower b n
  | b > 1 && (n > 1024 || b ^ n > largestPower) = Left (PowerTooLarge b n)
  | otherwise = Right ()

-- | 2^1024. For larger powers b^n - 1 has parts that can hardly ever be factored with the allowed
-- effort.
largestPower :: Natural
largestPower = 2 ^ (1024 :: Int)

-- | The divisors d of n >= 1, ascending, each with the value at b >= 2 of the d-th cyclotomic
-- polynomial. The product of these values is b^n - 1, and for each divisor e of n the values of e's
-- divisors multiply to b^e - 1. O(n + d^2) for d divisors, in operations on numbers up to b^n.
--
-- >>> cyclotomicValues 2 6
-- [(1,1),(2,3),(3,7),(6,3)]
cyclotomicValues :: Natural -> Natural -> [(Natural, Natural)]
cyclotomicValues b n = values
  where
    values = [(d, (b ^ d - 1) `div` product (properly d)) | d <- [1 .. n], n `mod` d == 0]
    properly d = [v | (e, v) <- takeWhile ((< d) . fst) values, d `mod` e == 0]

collect :: [Natural] -> [(Natural, Natural)]
collect primes = [(p, fromIntegral (length same)) | same@(p : _) <- group (sort primes)]

-- | The prime factors of a positive number, with repetition.
primeFactors :: Natural -> Either FactorError [Natural]
primeFactors n = (small ++) <$> split rest
  where
    (small, rest) = trialDivision n
    split 1 = Right []
    split m = do
      prime <- isPrime m
      if prime
        then Right [m]
        else case properDivisor m of
          Nothing -> Left (FactorNotFound m)
          Just d -> (++) <$> split d <*> split (m `div` d)

-- | Those prime factors of n - 1, ascending with their exponents, that are found and are below
-- 'millerRabinDomain'. If their product exceeds the square root of n, and each has an
-- 'isPocklingtonWitness', then n is prime.
--
-- >>> take 3 (pocklingtonFactors (2 ^ 89 - 1))
-- [(2,1),(3,1),(5,1)]
pocklingtonFactors :: Natural -> [(Natural, Natural)]
pocklingtonFactors = collect . factorsOfPredecessor

-- | Euler's function of the number with this factorisation: the number of units modulo it.
--
-- >>> totient <$> factorise 255
-- Right 128
totient :: [(Natural, Natural)] -> Natural
totient factors = product [p ^ (e - 1) * (p - 1) | (p, e) <- factors, e > 0]
