{-# OPTIONS_HADDOCK hide #-}

-- | Decides whether a window determines the position in arrays of a layout and shape: for every
-- primitive polynomial of the degree, or for at least one of them.
module PraTactile.Advise.Fit
  ( Fit (..),
    candidates,
    fits,
    fitsIn,
  )
where

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

-- | A window that determines the position, proved by its rank.
data Fit = Fit
  { -- | the window, which may be larger than needed
    fitWindow :: Shape,
    -- | whether every primitive polynomial of the degree works
    fitEvery :: Bool,
    -- | the first polynomial that works, as codes, constant term first
    fitPolynomial :: [Natural]
  }
  deriving stock (Eq, Show)

-- | The first primitive polynomials of a degree: the 32 that are tried, or 4 where finding each
-- takes longer.
candidates :: forall k. KnownField k => Proxy k -> Natural -> [Primitive k]
candidates k n =
  either (const []) (take (if q ^ n <= 2 ^ (32 :: Int) then 32 else 4)) (primitivePolynomials n)
  where
    q = fromIntegral (fieldOrder k) :: Natural

-- | Whether the windows of an array are distinct for one of these polynomials; otherwise the number
-- of polynomials that were tried. Arguments: n; the polynomials, all of degree n; the array's
-- layout and shape; the window.
fits :: KnownField k => Natural -> [Primitive k] -> (Layout, Shape) -> Shape -> Either Int Fit
fits n polynomials (layout, shape) window = case find works tried of
  Just h -> Right (Fit window sure (codesOf h))
  Nothing -> Left (length tried)
  where
    codesOf = map (fromIntegral . toCode) . coefficients . primitivePolynomial
    tried = if sure then take 1 polynomials else polynomials
    sure =
      or
        [ w `fitsIn` window
          | h <- take 1 polynomials,
            w <- sureWindows (fromIntegral (fieldOrder h)) n layout shape
        ]
    works h = either (const False) ((== n) . rankWith h) (rectangle window)
    rankWith h mask = case layout of
      Single folding ->
        either (const 0) (`windowRank` mask) (fold folding shape h (canonicalState h))
      Joint _ -> either (const 0) (`codeRank` mask) (foldCode shape h (canonicalState h))

-- | Whether a window is no larger than another, or than an array.
fitsIn :: Shape -> Shape -> Bool
fitsIn window shape = rows window <= rows shape && columns window <= columns shape
