-- | Intervals that certainly contain a real number, with a stated number of binary places.
module PraTactile.Object.Enclosure
  ( Enclosure,
    enclosed,
    middle,
    radius,
    signKnown,
  )
where

import Data.Bits (shiftL, shiftR)
import Data.Ratio (denominator, numerator, (%))
import PraTactile.Object.Number
import PraTactile.Object.Vector (floorRoot)

-- | The numbers from centre - reach to centre + reach, both in units of 2^-places.
data Enclosure = Enclosure
  { places :: !Int,
    centre :: !Integer,
    reach :: !Integer
  }
  deriving stock (Show)

-- | An interval for the product of a rational number and the root of a non-negative integer. The
-- first argument is the number of binary places. Intervals that are combined must have the same
-- number of places, which is not checked.
enclosed :: Int -> Rational -> Integer -> Enclosure
enclosed digits q under
  | under == 1 = Enclosure digits ((n `shiftL` digits) `div` d) 1
  | otherwise = Enclosure digits (signum n * root) 1
  where
    (n, d) = (numerator q, denominator q)
    root = floorRoot (fromInteger (((n * n * under) `shiftL` (2 * digits)) `quot` (d * d)))

-- | The centre of an interval, and the distance from it to either end.
middle, radius :: Enclosure -> Rational
middle it = centre it % (1 `shiftL` places it)
radius it = reach it % (1 `shiftL` places it)

-- | The common sign of all numbers of the interval; 'Nothing' if it contains 0.
signKnown :: Enclosure -> Maybe Int
signKnown (Enclosure _ m r)
  | m > r = Just 1
  | negate m > r = Just (-1)
  | otherwise = Nothing

instance Number Enclosure where
  plus (Enclosure p m r) (Enclosure _ n s) = Enclosure p (m + n) (r + s)
  minus (Enclosure p m r) (Enclosure _ n s) = Enclosure p (m - n) (r + s)

  -- The centre is rounded by less than 1, and so is the radius.
  product' (Enclosure p m r) (Enclosure _ n s) =
    Enclosure p ((m * n) `shiftR` p) (((abs m * s + abs n * r + r * s) `shiftR` p) + 2)
  times k (Enclosure p m r) =
    Enclosure
      p
      ((m * numerator k) `div` denominator k)
      ((r * abs (numerator k)) `div` denominator k + 2)
