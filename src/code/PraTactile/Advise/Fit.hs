{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Whether a window tells the position in arrays of a layout and shape: for every primitive polynomial of the
-- degree, or for one of them at least.
module PraTactile.Advise.Fit
  ( Fit (..)
  , fits
  ) where

import Data.List (find)
import Data.Proxy (Proxy)
import Numeric.Natural (Natural)
import PraTactile.Advise.Layout
import PraTactile.Array
import PraTactile.ArrayCode
import PraTactile.Field
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Window
import PraTactile.Window.Rank (windowRank)

-- | A window that tells the position, shown by rank.
data Fit = Fit
  { fitWindow :: Shape
  -- ^ the window, which may be larger than needed
  , fitEvery :: Bool
  -- ^ whether every primitive polynomial of the degree will do
  , fitPolynomial :: [Natural]
  -- ^ the first that does, as codes, constant term first
  }
  deriving stock (Eq, Show)

-- | Whether the windows are distinct with some of the first primitive polynomials of the degree; otherwise how
-- many were tried, which is 32 at most, and fewer for large degrees.
fits :: forall k. KnownField k => Proxy k -> Natural -> Layout -> Shape -> Shape -> Either Int Fit
fits k n layout shape window = case find works polynomials of
  Just h -> Right (Fit window sure (map (fromIntegral . toCode) (coefficients (primitivePolynomial h))))
  Nothing -> Left (length polynomials)
 where
  q = fromIntegral (fieldOrder k) :: Natural
  polynomials = either (const []) (take limit) (primitivePolynomials n) :: [Primitive k]
  limit
    | sure = 1
    | q ^ n <= 2 ^ (32 :: Int) = 32
    | otherwise = 4
  sure = or [rows w <= rows window && columns w <= columns window | w <- sureWindows q n layout shape]
  works h = either (const False) ((== n) . rankWith h) (rectangle window)
  rankWith h mask = case layout of
    Single folding -> either (const 0) (`windowRank` mask) (fold folding shape h (canonicalState h))
    Joint _ -> either (const 0) (`codeRank` mask) (foldCode shape h (canonicalState h))
