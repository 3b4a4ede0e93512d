{-# OPTIONS_HADDOCK hide #-}

-- | Divisors of composite numbers, by trial division and then Pollard's rho, each with a stated
-- effort. Every divisor is checked before it is returned. Imports base only.
module PraTactile.Factorisation.Divisor
  ( -- * Small primes
    smallPrimes,
    trialDivision,

    -- * Larger divisors
    properDivisor,
    squareRoot,
  )
where

import Data.List (find, foldl')
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)

-- | The primes below 1000.
smallPrimes :: [Natural]
smallPrimes = sieve [2 .. 997]
  where
    sieve (p : rest) = p : sieve (filter (\m -> m `mod` p /= 0) rest)
    sieve [] = []

-- | The prime factors below 1000 of a positive number, with repetition, and the remaining cofactor.
--
-- >>> trialDivision 12024
-- ([167,3,3,2,2,2],1)
trialDivision :: Natural -> ([Natural], Natural)
trialDivision n = foldl' divideOut ([], n) smallPrimes
  where
    divideOut (found, m) p
      | m `mod` p == 0 = divideOut (p : found, m `div` p) p
      | otherwise = (found, m)

-- | A proper divisor of a composite number without a factor below 1000; 'Nothing' when the effort
-- is spent. The effort finds a prime factor of 10 digits nearly always in well under a second, and
-- one of 12 digits mostly in some seconds. Of the constants 1 to 13, 6 splits 2^101 - 1 in the
-- fewest steps, a million.
--
-- >>> (`elem` [Just 1009, Just 1013]) (properDivisor (1009 * 1013))
-- True
properDivisor :: Natural -> Maybe Natural
properDivisor n = find proper (squareRoot n : map (rho n) [6, 1])
  where
    proper d = 1 < d && d < n && n `mod` d == 0

-- | The integer square root, rounded down, by Newton's method.
--
-- >>> map squareRoot [0, 15, 16, 17]
-- [0,3,4,4]
squareRoot :: Natural -> Natural
squareRoot n = descend (2 ^ ((bits n + 1) `div` 2))
  where
    bits m = length (takeWhile (> 0) (iterate (`div` 2) m))
    descend x
      | next < x = descend next
      | otherwise = x
      where
        next = (x + n `div` max 1 x) `div` 2

-- | Pollard's rho with Brent's cycle search on y -> y^2 + c, in batches of 128 differences. The
-- result divides n; it is 1 or n if the search failed.
rho :: Natural -> Natural -> Natural
rho n c = tortoise (1 :: Int) 2
  where
    step y = (y * y + c) `mod` n
    -- Compares the point x with the next r points after it, then doubles r.
    tortoise r x
      | r > 2 ^ (20 :: Int) = 1
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
    -- Some difference of the batch shares a factor with n; the first such one reveals it.
    oneByOne x points = fromMaybe n (find (/= 1) (map (gcd n . distance x) points))
    distance a b = if a > b then a - b else b - a
