{-# LANGUAGE BangPatterns #-}

-- | Lenstra's elliptic curves: divisors that have a prime factor p such that a curve's order modulo
-- p has small factors only. Imports base only.
module PraTactile.Factorisation.EllipticCurve
  ( curveDivisors,

    -- * A curve
    Point (..),
    multiple,
    secondStage,
  )
where

import Data.Bits (shiftR, testBit)
import Data.List (foldl')
import Numeric.Natural (Natural)

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

-- | A product that p divides if the order of the point modulo p is a prime from the limit, and from
-- 106, up to 50 times the limit: every such prime is 210 m - j or 210 m + j with j < 105 coprime to
-- 210, and then the points 210 m P and j P have the same x.
secondStage :: Integer -> Integer -> Integer -> Point -> Integer
secondStage n curve limit p = go first 1 (times first) (times (first + 1))
  where
    first = max 1 (limit `div` 210)
    times m = multiple n curve (210 * m) p
    wheel = times 1
    small = [multiple n curve j p | j <- [1, 3 .. 104], gcd j 210 == 1]
    go m !acc here next
      | m > (50 * limit + 104) `div` 210 = acc
      | otherwise = go (m + 1) (foldl' (include here) acc small) next (plus n here next wheel)
    include (Point x z) acc (Point xj zj) = acc * ((x * zj - xj * z) `rem` n) `rem` n
