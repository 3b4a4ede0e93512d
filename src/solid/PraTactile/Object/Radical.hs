-- | The coordinates of points on slanted faces: numbers
--
-- > p + q sqrt a + r sqrt c + s sqrt (a c)
--
-- with rational p, q, r, s and two positive whole numbers a and c, which a face has: those by which
-- the lengths of its upper side and of its normal are roots.
module PraTactile.Object.Radical
  ( Roots,
    roots,
    Radical,
    radical,
    fraction,
    plus,
    times,
    asFraction,
    nearest,
  )
where

import Data.Ratio (denominator, numerator, (%))
import PraTactile.Object.Vector (exactRoot, floorRoot)

-- | Two whole numbers, and their roots.
data Roots = Roots
  { -- | the roots of a, c and a c where these are fractions
    fractions :: !(Maybe Rational, Maybe Rational, Maybe Rational),
    -- | the greater of the two that is known to be one over the other: sqrt (a c) / a
    -- | a
    firstRadicand :: !Rational,
    -- | the roots of a, c and a c times 2^k, rounded down, for k = 64, 128, 256, ..
    approximated :: [(Int, (Integer, Integer, Integer))]
  }

-- | The roots of two positive whole numbers.
roots :: Integer -> Integer -> Roots
roots a c =
  Roots
    { fractions = (exact a, exact c, exact (a * c)),
      firstRadicand = fromInteger a,
      approximated =
        [(k, (rounded k a, rounded k c, rounded k (a * c))) | k <- iterate (2 *) 64]
    }
  where
    exact = exactRoot . fromInteger
    rounded k n = floorRoot (fromInteger (n * 4 ^ k))

-- | A number over the roots; equal numbers over the same roots are equal.
data Radical = Radical !Rational !Rational !Rational !Rational
  deriving stock (Eq, Ord, Show)

-- | p + q sqrt a + r sqrt c + s sqrt (a c), of p, q, r and s. The roots of whole numbers of which
-- no product is a square are independent over the fractions; others are expressed by them.
radical :: Roots -> Rational -> Rational -> Rational -> Rational -> Radical
radical over p q r s = case fractions over of
  (Just a, Just c, _) -> Radical (p + q * a + r * c + s * a * c) 0 0 0
  (Just a, Nothing, _) -> Radical (p + q * a) 0 (r + s * a) 0
  (Nothing, Just c, _) -> Radical (p + r * c) (q + s * c) 0 0
  (Nothing, Nothing, Just ac) -> Radical (p + s * ac) (q + r * ac / firstRadicand over) 0 0
  (Nothing, Nothing, Nothing) -> Radical p q r s

-- | A rational number, over any roots.
fraction :: Rational -> Radical
fraction p = Radical p 0 0 0

-- | The sum of two numbers over the same roots.
plus :: Radical -> Radical -> Radical
plus (Radical p q r s) (Radical p' q' r' s')
  | q == 0 && r == 0 && s == 0 && q' == 0 && r' == 0 && s' == 0 = Radical (p + p') 0 0 0
  | otherwise = Radical (p + p') (q + q') (r + r') (s + s')

-- | So many times the number.
times :: Rational -> Radical -> Radical
times k (Radical p q r s)
  | q == 0 && r == 0 && s == 0 = Radical (k * p) 0 0 0
  | otherwise = Radical (k * p) (k * q) (k * r) (k * s)

-- | The number, where it is rational.
asFraction :: Radical -> Maybe Rational
asFraction (Radical p q r s) = if q == 0 && r == 0 && s == 0 then Just p else Nothing

-- | The number rounded by a function that does not fall and is constant between some fractions,
-- such as to the nearest machine number: between bounds that both round alike.
nearest :: Eq a => (Rational -> a) -> Roots -> Radical -> a
nearest rounding over number@(Radical p q r s) = case asFraction number of
  Just exact -> rounding exact
  Nothing ->
    decided (map (both rounding . bounds) (approximated over))
  where
    -- It lies between two of the fractions at which the rounded number changes.
    decided found = case found of
      (below, above) : finer -> if below == above then below else decided finer
      [] -> rounding p
    both f (x, y) = (f x, f y)
    -- Whole multiples of 1 / 2^k on either side.
    bounds (k, (a, c, ac)) = (sum (map fst parts) % unit, sum (map snd parts) % unit)
      where
        unit = 2 ^ k
        parts =
          between p (unit, unit) : zipWith between [q, r, s] (map around [a, c, ac])
        around root = (root, root + 1)
        between share (low, high)
          | share >= 0 = (share `floored` low, share `raised` high)
          | otherwise = (share `floored` high, share `raised` low)
        floored share n = (numerator share * n) `div` denominator share
        raised share n = negate (floored (negate share) n)
