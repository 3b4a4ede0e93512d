{-# LANGUAGE BangPatterns #-}

-- | Divisors of composite numbers: trial division, then Pollard's rho, then Lenstra's elliptic
-- curves, each with a stated effort. Nothing here has to be believed: that a divisor divides is
-- checked before it is given out. Imports base only.
module PraTactile.Factorisation.Divisor
  ( -- * Small primes
    smallPrimes,
    trialDivision,

    -- * Larger divisors
    properDivisor,
    squareRoot,
  )
where

import Data.Bits (shiftR, testBit)
import Data.List (find, foldl')
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)

-- | The primes below 1000.
smallPrimes :: [Natural]
smallPrimes = sieve [2 .. 997]
  where
    sieve (p : rest) = p : sieve (filter (\m -> m `mod` p /= 0) rest)
    sieve [] = []

-- | The prime factors below 1000 of a positive number, each as often as it divides, and what is
-- left.
--
-- >>> trialDivision 12024
-- ([167,3,3,2,2,2],1)
trialDivision :: Natural -> ([Natural], Natural)
trialDivision n = foldl' divideOut ([], n) smallPrimes
  where
    divideOut (found, m) p
      | m `mod` p == 0 = divideOut (p : found, m `div` p) p
      | otherwise = (found, m)

-- | A proper divisor of a composite number that has no factor below 1000, or nothing when the
-- effort is spent. The effort finds a factor of 10 digits nearly always in well under a second and
-- one of 20 digits mostly in some seconds; it is spent after about 10 seconds, of a number of any
-- size.
--
-- >>> (`elem` [Just 1009, Just 1013]) (properDivisor (1009 * 1013))
-- True
properDivisor :: Natural -> Maybe Natural
properDivisor n = find proper (squareRoot n : map (rho n) [1, 3] ++ curveDivisors n)
  where
    proper d = 1 < d && d < n && n `mod` d == 0

-- | The largest number whose square is not above the given one, by Newton's method.
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
-- answer divides n; it is 1 or n where the search failed.
rho :: Natural -> Natural -> Natural
rho n c = tortoise (1 :: Int) 2
  where
    step y = (y * y + c) `mod` n
    -- Compare the point x with the next r points after it, then double r.
    tortoise r x
      | r > 2 ^ (16 :: Int) = 1
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
    -- Some difference of the batch has a factor in common with n: the first one shows it.
    oneByOne x points = fromMaybe n (find (/= 1) (map (gcd n . distance x) points))
    distance a b = if a > b then a - b else b - a

{- Note [Elliptic curves]
   ~~~~~~~~~~~~~~~~~~~~~~
   Lenstra (Annals of Mathematics 126, 1987) in Montgomery's form (Math. Comp. 48, 1987): on B y^2 =
   x^3 + A x^2 + x only x = X/Z is computed, and the curve enters through (A + 2)/4 alone. That
   number is simply 2, 3, 4, ... and the point has x = 2: some B makes the point lie on the curve,
   and no formula needs it. Multiplying the point by all prime powers up to B1 makes Z divisible by
   a prime factor p of n if the order of the point on the curve modulo p has no other factors; the
   second stage lets one more prime pass, up to 50 B1. A curve that fails is followed by another
   one, of another order. Limits and numbers of curves are near those usual for factors of 15, 20
   and 25 digits. -}

-- | What the curves give, one after the other: divisors of n, many of them 1 or n.
curveDivisors :: Natural -> [Natural]
curveDivisors n = map fromInteger (concat (zipWith attempt [2 ..] levels))
  where
    levels = concatMap level [(2000, 30), (11000, 75), (50000, 60)]
    level (limit, curves) = replicate (affordable curves) (limit, foldl' lcm 1 [2 .. limit])
    -- Beyond 200 binary digits fewer curves, for a product takes the longer.
    affordable curves = max 1 (curves * 200 * 200 `div` (size * size))
    size = max 200 (length (takeWhile (> 0) (iterate (`shiftR` 1) n)))
    attempt curve (limit, multiplier) =
      let point = multiple modulus curve multiplier (Point 2 1)
       in [common point, gcd modulus (secondStage modulus curve limit point)]
    common (Point _ z) = gcd modulus z
    modulus = toInteger n

-- | A point up to its sign: x = X/Z modulo n.
data Point = Point !Integer !Integer

double :: Integer -> Integer -> Point -> Point
double n curve (Point x z) = Point (s * d `rem` n) (t * (d + curve * t) `rem` n)
  where
    s = (x + z) * (x + z) `rem` n
    d = (x - z) * (x - z) `rem` n
    t = s - d

-- | P + Q, given P - Q as well.
plus :: Integer -> Point -> Point -> Point -> Point
plus n (Point x z) (Point xp zp) (Point xq zq) =
  Point (z * (sums * sums `rem` n) `rem` n) (x * (differences * differences `rem` n) `rem` n)
  where
    u = (xp - zp) * (xq + zq)
    v = (xp + zp) * (xq - zq)
    sums = (u + v) `rem` n
    differences = (u - v) `rem` n

-- | @multiple n curve k p@ is k p for k >= 1, by a ladder whose two points always differ by p.
multiple :: Integer -> Integer -> Integer -> Point -> Point
multiple n curve k p = go (highest - 1) p (double n curve p)
  where
    highest = length (takeWhile (> 1) (iterate (`shiftR` 1) k))
    go :: Int -> Point -> Point -> Point
    go i !low !high
      | i < 0 = low
      | testBit k i = go (i - 1) (plus n p low high) (double n curve high)
      | otherwise = go (i - 1) (double n curve low) (plus n p low high)

-- | A product that p divides if the order of the point modulo p is a prime up to 50 times the
-- limit: every such prime is 210 m - j or 210 m + j with j < 105 coprime to 210, and then the
-- points 210 m P and j P have the same x.
secondStage :: Integer -> Integer -> Integer -> Point -> Integer
secondStage n curve limit p = go first 1 (times first) (times (first + 1))
  where
    first = max 1 (limit `div` 210)
    times m = multiple n curve (210 * m) p
    wheel = times 1
    small = [multiple n curve j p | j <- [1, 3 .. 104], gcd j 210 == 1]
    go m !acc here next
      | m > 50 * limit `div` 210 = acc
      | otherwise = go (m + 1) (foldl' (include here) acc small) next (plus n here next wheel)
    include (Point x z) acc (Point xj zj) = acc * ((x * zj - xj * z) `rem` n) `rem` n
