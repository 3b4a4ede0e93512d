-- | Logarithms of numbers that no 'Double' holds.
module PraTactile.Locate.Logarithm
  ( naturalLogarithm,
    logSum,
  )
where

import Data.Bits (shiftR)
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)

-- | The logarithm to base e of a number of any size; of 0 it is minus infinity.
--
-- >>> abs (naturalLogarithm (10 ^ 1000) - 1000 * log 10) < 1e-9
-- True
naturalLogarithm :: Natural -> Double
naturalLogarithm n
  | n < 2 ^ (1023 :: Int) = log (fromIntegral n)
  -- At least 511 binary digits are left of it, more than are told apart.
  | otherwise = 512 * log 2 + naturalLogarithm (n `shiftR` 512)

-- | The logarithm of the sum of the numbers of which these are the logarithms. O(n).
logSum :: Vector Double -> Double
logSum logs
  | Primitive.null logs || isInfinite best = -1 / 0
  | otherwise = best + log (Primitive.foldl' (\total x -> total + relative (x - best)) 0 logs)
  where
    best = Primitive.maximum logs
    -- What would not change the sum is left out.
    relative x = if x < -44 then 0 else exp x
