{-# LANGUAGE DerivingStrategies #-}

-- |
-- Primes and factors of integers, as far as the order of a root of h asks for them:
-- h is primitive when its root has order exactly q^n - 1, which is decided from the
-- primes that divide q^n - 1. Every answer is proved; where the effort allowed does not
-- suffice, the answer is a refusal.
module PraTactile.Factorisation
  ( -- * Factorisation
    factorise
  , factorisePowerMinusOne
  , FactorError (..)

    -- * Primality
  , isPrime
  , millerRabinDomain

    -- * Euler's function
  , totient
  ) where

import Data.List (find, foldl', sort)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)

-- | Why a factorisation is not known.
data FactorError
  = -- | Zero has no factorisation.
    FactorisationOfZero
  | -- | This composite number was not split within the effort allowed.
    FactorNotFound Natural
  | -- | This number passes the test for primes, but was not proved to be one.
    PrimalityUndecided Natural
  deriving stock (Eq, Show)

-- | The primes that divide a number, ascending, each with its exponent. Refuses 0, and
-- numbers left with two prime factors of more than about 12 digits.
--
-- >>> factorise (2 ^ 64 - 1)
-- Right [(3,1),(5,1),(17,1),(257,1),(641,1),(65537,1),(6700417,1)]
factorise :: Natural -> Either FactorError [(Natural, Natural)]
factorise 0 = Left FactorisationOfZero
factorise n = collect <$> primeFactors n

-- | The factorisation of b^n - 1 by way of its algebraic factors, the values at b of the cyclotomic
-- polynomials of the divisors of n. Refuses b < 2 or n = 0 (the number is 0) and as 'factorise' does.
--
-- >>> factorisePowerMinusOne 4 4
-- Right [(3,1),(5,1),(17,1)]
factorisePowerMinusOne :: Natural -> Natural -> Either FactorError [(Natural, Natural)]
factorisePowerMinusOne b n
  | b < 2 || n == 0 = Left FactorisationOfZero
  | otherwise = collect . concat <$> mapM primeFactors (Map.elems cyclotomicValues)
 where
  -- b^d - 1 is the product of the values for all divisors of d.
  cyclotomicValues = foldl' include Map.empty (filter (\d -> n `mod` d == 0) [1 .. n]) :: Map Natural Natural
  include values d =
    Map.insert d ((b ^ d - 1) `div` product [v | (e, v) <- Map.toList values, d `mod` e == 0]) values

collect :: [Natural] -> [(Natural, Natural)]
collect primes = Map.toAscList (Map.fromListWith (+) [(p, 1) | p <- primes])

-- | The prime factors of a positive number, each as often as it divides.
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
        Just d -> (\as bs -> sort (as ++ bs)) <$> split d <*> split (m `div` d)

-- | The prime factors below 1000, and what is left.
trialDivision :: Natural -> ([Natural], Natural)
trialDivision n = foldl' divideOut ([], n) smallPrimes
 where
  divideOut (found, m) p
    | m `mod` p == 0 = divideOut (p : found, m `div` p) p
    | otherwise = (found, m)

smallPrimes :: [Natural]
smallPrimes = sieve [2 .. 997]
 where
  sieve (p : rest) = p : sieve (filter (\m -> m `mod` p /= 0) rest)
  sieve [] = []

-- | Pollard's rho with Brent's cycle search, in batches of 128 differences: a proper divisor of
-- a composite number without factors below 1000, or nothing when the effort is spent.
properDivisor :: Natural -> Maybe Natural
properDivisor n = firstJust (map attempt [1, 3, 5, 7])
 where
  firstJust candidates = find (const True) [d | Just d <- candidates]
  attempt c = tortoise 1 2
   where
    step y = (y * y + c) `mod` n
    -- Compare the point x with the next r points after it, then double r.
    tortoise r x
      | r > effort = Nothing
      | otherwise = batch r x x r
    batch r x y left
      | left == 0 = tortoise (2 * r) y
      | otherwise =
          let size = min 128 left
              points = take size (iterate step (step y))
              g = gcd n (foldl' (\acc z -> acc * distance x z `mod` n) 1 points)
           in case g of
                1 -> batch r x (foldl' (\_ z -> z) y points) (left - size)
                _ -> oneByOne x points
    -- The batch contains a difference that n does not divide coprimely: find the first.
    oneByOne x points = case find (/= 1) (map (gcd n . distance x) points) of
      Just d | d < n -> Just d
      _ -> Nothing
  effort = 2 ^ (20 :: Int) :: Int
  distance a b = if a > b then a - b else b - a

-- | Whether a number is prime. Below 'millerRabinDomain' it is decided by the strong test alone;
-- above it a composite is still recognised for certain, and a prime is proved by Pocklington's
-- theorem. Refuses when n - 1 does not factor far enough for that.
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

-- | Primes beyond those bases: above the domain each is one more chance to recognise a composite.
furtherBases :: [Natural]
furtherBases = takeWhile (< 150) (drop (length millerRabinBases) smallPrimes)

-- | n > 2: with n - 1 = 2^s d, d odd, either a^d = 1 or some a^(2^i d) = -1, i < s.
strongProbablePrime :: Natural -> Natural -> Bool
strongProbablePrime n a
  | even n = False
  | otherwise = start == 1 || (n - 1) `elem` take twos (iterate (\x -> x * x `mod` n) start)
 where
  twos = length (takeWhile even (iterate (`div` 2) (n - 1)))
  start = powerModulo n a ((n - 1) `div` 2 ^ twos)

-- | Pocklington: let n - 1 = F R with F > sqrt n. If for each prime l that divides F some a has
-- a^(n-1) = 1 and gcd (a^((n-1)/l) - 1) n = 1, then n is prime.
pocklington :: Natural -> Bool
pocklington n = factored * factored > n && all witnessed primes
 where
  (small, rest) = trialDivision (n - 1)
  proved = small ++ provedFactors rest
  primes = map fst (collect proved)
  factored = product proved
  witnessed l = any (witness l) millerRabinBases
  witness l a = powerModulo n a (n - 1) == 1 && gcd n (powerModulo n a ((n - 1) `div` l) + n - 1) == 1

-- | Such prime factors as are found and proved, each as often as it divides.
provedFactors :: Natural -> [Natural]
provedFactors 1 = []
provedFactors m = case isPrime m of
  Right True -> [m]
  Right False -> maybe [] (\d -> provedFactors d ++ provedFactors (m `div` d)) (properDivisor m)
  Left _ -> []

-- | @powerModulo n a e@ is a^e modulo n, by squaring.
powerModulo :: Natural -> Natural -> Natural -> Natural
powerModulo n = go 1
 where
  go acc _ 0 = acc `mod` n
  go acc a e = go (if odd e then acc * a `mod` n else acc) (a * a `mod` n) (e `div` 2)

-- | Euler's function of the number that has this factorisation: how many of its residues are units.
--
-- >>> totient <$> factorise 255
-- Right 128
totient :: [(Natural, Natural)] -> Natural
totient factors = product [p ^ (e - 1) * (p - 1) | (p, e) <- factors, e > 0]
