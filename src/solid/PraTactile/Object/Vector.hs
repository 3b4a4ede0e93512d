-- | Exact integer vectors in space, and a few roots as machine numbers.
module PraTactile.Object.Vector
  ( V3 (..),
    plus,
    minus,
    scaled,
    cross,
    dot,
    zero,
    primitive,
    squareRoot,
    exactRoot,
    floorRoot,
  )
where

import Data.Ratio (denominator, numerator, (%))
import Math.NumberTheory.Logarithms (integerLog2)

-- | A point or vector with integer coordinates.
data V3 = V3 !Integer !Integer !Integer
  deriving stock (Eq, Ord, Show)

-- | The sum of two vectors.
plus :: V3 -> V3 -> V3
plus (V3 a b c) (V3 d e f) = V3 (a + d) (b + e) (c + f)

-- | The difference of two vectors.
minus :: V3 -> V3 -> V3
minus (V3 a b c) (V3 d e f) = V3 (a - d) (b - e) (c - f)

-- | A vector times a number.
scaled :: Integer -> V3 -> V3
scaled k (V3 a b c) = V3 (k * a) (k * b) (k * c)

-- | The vector product.
cross :: V3 -> V3 -> V3
cross (V3 a b c) (V3 d e f) = V3 (b * f - c * e) (c * d - a * f) (a * e - b * d)

-- | The scalar product.
dot :: V3 -> V3 -> Integer
dot (V3 a b c) (V3 d e f) = a * d + b * e + c * f

-- | The zero vector.
zero :: V3
zero = V3 0 0 0

-- | The shortest integer vector in the same direction.
primitive :: V3 -> V3
primitive v@(V3 a b c)
  | v == zero = zero
  | otherwise = V3 (a `quot` g) (b `quot` g) (c `quot` g)
  where
    g = gcd a (gcd b c)

-- | The square root of a number of any size, to the precision of a machine number; 0 for negative
-- numbers.
--
-- >>> squareRoot (10 ^ 600)
-- 1.0e300
squareRoot :: Rational -> Double
squareRoot square
  | square <= 0 = 0
  | even shift = fromInteger (floorRoot (scaledBy shift)) * half shift
  | otherwise = fromInteger (floorRoot (scaledBy (shift + 1))) * half (shift + 1)
  where
    -- A power of 4 makes it an integer of some 120 bits, whose root has 60.
    shift = 120 - (integerLog2 (numerator square) - integerLog2 (denominator square))
    scaledBy :: Int -> Rational
    scaledBy n = square * (if n >= 0 then 2 ^ n else 1 / 2 ^ negate n)
    half n = fromRational (if n >= 0 then 1 / 2 ^ (n `div` 2) else 2 ^ (negate n `div` 2))

-- | The square root of a fraction; 'Nothing' if it is irrational.
--
-- >>> (exactRoot (9 % 4), exactRoot 2)
-- (Just (3 % 2),Nothing)
exactRoot :: Rational -> Maybe Rational
exactRoot square
  | square < 0 = Nothing
  | root * root == square = Just root
  | otherwise = Nothing
  where
    -- A fraction in lowest terms is a square exactly if its numerator and its denominator are.
    root = integerRoot (numerator square) % integerRoot (denominator square)

-- | The integer part of the square root; 0 for negative numbers.
floorRoot :: Rational -> Integer
floorRoot square = integerRoot (floor square)

integerRoot :: Integer -> Integer
integerRoot n
  | n <= 0 = 0
  | otherwise = newton (2 ^ (integerLog2 n `div` 2 + 1))
  where
    -- From above, it decreases to the root.
    newton guess =
      let better = (guess + n `div` guess) `div` 2
       in if better >= guess then guess else newton better
