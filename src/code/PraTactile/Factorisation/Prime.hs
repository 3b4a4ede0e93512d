{-# OPTIONS_HADDOCK hide #-}

-- | Primality with proof: by the strong test where a theorem says that it decides, and beyond by
-- Pocklington's theorem with prime factors that the strong test proves. Imports base only.
module PraTactile.Factorisation.Prime
  ( -- * Primality
    isPrime,
    millerRabinDomain,
    pocklington,
    factorsOfPredecessor,
    isPocklingtonWitness,

    -- * Errors
    FactorError (..),
  )
where

import Data.List (find, inits, nub)
import Numeric.Natural (Natural)
import PraTactile.Factorisation.Divisor

-- | Why a factorisation is not known.
data FactorError
  = -- | Zero has no factorisation.
    FactorisationOfZero
  | -- | This composite number was not split within the effort allowed.
    FactorNotFound Natural
  | -- | This number passes the strong test, but was not proved to be prime.
    PrimalityUndecided Natural
  | -- | b^n - 1, for this b and n, exceeds 2^1024, so factoring it is not tried.
    PowerTooLarge Natural Natural
  deriving stock (Eq, Show)

-- | Whether a number is prime. Below 'millerRabinDomain' the strong test decides. Above it, the
-- strong test still proves composites, and 'pocklington' proves primes. Refuses
-- ('PrimalityUndecided') if n - 1 cannot be factored far enough for that. O(log n) products modulo
-- n below 'millerRabinDomain' and for nearly every composite; a prime above it costs the
-- factorisation of n - 1.
--
-- >>> isPrime (2 ^ 61 - 1)
-- Right True
isPrime :: Natural -> Either FactorError Bool
isPrime n
  | n < 2 = Right False
  | n `elem` millerRabinBases = Right True
  | not (all (strongProbablePrime n) millerRabinBases) = Right False
  | n < millerRabinDomain = Right True
  | not (all (strongProbablePrime n) furtherBases) = Right False
  | pocklington n = Right True
  | otherwise = Left (PrimalityUndecided n)

-- | 3317044064679887385961981: no composite below it is a strong probable prime to the first 13
-- prime bases (Sorenson and Webster, Math. Comp. 86, 2017).
millerRabinDomain :: Natural
millerRabinDomain = 3317044064679887385961981

millerRabinBases :: [Natural]
millerRabinBases = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41]

-- | Primes beyond those bases. Above the domain, each is one more chance to recognise a composite.
furtherBases :: [Natural]
furtherBases = takeWhile (< 150) (drop (length millerRabinBases) smallPrimes)

-- | The strong test of n > 2: with n - 1 = 2^s d and d odd, either a^d = 1 or a^(2^i d) = -1 for
-- some i < s.
strongProbablePrime :: Natural -> Natural -> Bool
strongProbablePrime n a
  | even n = False
  | otherwise = start == 1 || (n - 1) `elem` take twos (iterate (\x -> x * x `mod` n) start)
  where
    twos = length (takeWhile even (iterate (`div` 2) (n - 1)))
    start = powerModulo n a ((n - 1) `div` 2 ^ twos)

-- | Whether the factors of n - 1 that are found prove that n > 2 is prime. 'True' is a proof;
-- 'False' proves nothing.
--
-- Let F divide n - 1. For each prime l that divides F, let some a have a^(n-1) = 1 modulo n and
-- a^((n-1)/l) - 1 coprime to n. Then every prime factor of n is 1 modulo F (Pocklington; a may
-- depend on l: Brillhart, Lehmer and Selfridge, Math. Comp. 29, 1975). So n is prime if F^2 > n.
pocklington :: Natural -> Bool
pocklington n = maybe False (all witnessed . nub) (find enough (inits (factorsOfPredecessor n)))
  where
    enough primes = product primes ^ (2 :: Int) > n
    witnessed l = any (isPocklingtonWitness n l) millerRabinBases

-- | Those prime factors of n - 1, for n > 1 and with repetition, that are found and are below
-- 'millerRabinDomain'. Computed lazily.
factorsOfPredecessor :: Natural -> [Natural]
factorsOfPredecessor n = small ++ found rest
  where
    (small, rest) = trialDivision (n - 1)
    found m
      | m == 1 = []
      | composite m = maybe [] (\d -> found d ++ found (m `div` d)) (properDivisor m)
      | otherwise = [m | m < millerRabinDomain]
    composite m = not (all (strongProbablePrime m) millerRabinBases)

-- | @isPocklingtonWitness n l a@ says whether a^(n-1) is 1 modulo n and a^((n-1)/l) - 1 is coprime
-- to n. O(log n) products modulo n.
isPocklingtonWitness :: Natural -> Natural -> Natural -> Bool
isPocklingtonWitness n l a =
  powerModulo n a (n - 1) == 1 && gcd n (powerModulo n a ((n - 1) `div` l) + n - 1) == 1

-- | @powerModulo n a e@ is a^e modulo n, by squaring.
powerModulo :: Natural -> Natural -> Natural -> Natural
powerModulo n = go 1
  where
    go acc _ 0 = acc `mod` n
    go acc a e = go (if odd e then acc * a `mod` n else acc) (a * a `mod` n) (e `div` 2)
