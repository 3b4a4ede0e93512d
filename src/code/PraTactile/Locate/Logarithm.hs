{-# OPTIONS_HADDOCK hide #-}

-- | Logarithms of integers beyond the range of 'Double'.
module PraTactile.Locate.Logarithm
  ( naturalLogarithm,
  )
where

import Data.Bits (shiftR)
import Numeric.Natural (Natural)

-- | The natural logarithm of an integer of any size; minus infinity for 0.
--
-- >>> abs (naturalLogarithm (10 ^ 1000) - 1000 * log 10) < 1e-9
-- True
naturalLogarithm :: Natural -> Double
naturalLogarithm n
  | n < 2 ^ (1023 :: Int) = log (fromIntegral n)
  -- At least 511 binary digits remain, more than the precision of a Double.
  | otherwise = 512 * log 2 + naturalLogarithm (n `shiftR` 512)
