{-# OPTIONS_HADDOCK hide #-}

-- | Logarithms of numbers that no 'Double' holds.
module PraTactile.Locate.Logarithm
  ( naturalLogarithm,
  )
where

import Data.Bits (shiftR)
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
