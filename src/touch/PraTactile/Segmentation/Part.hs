{-# OPTIONS_HADDOCK hide #-}

-- | What was touched of a symbol that does not lie wholly in a composite.
module PraTactile.Segmentation.Part
  ( Part (..),
    partAt,
    leastSeen,
  )
where

import Data.Maybe (fromMaybe, isJust)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (Composite, leastCoverage, weighted)
import PraTactile.Geometry (rotated, symbolHeight, symbolWidth)
import PraTactile.Image (Raster, generate, rasterValues)
import PraTactile.Image.Correlate (referenceAt)

-- | What was touched of a place where a symbol is expected.
data Part = Part
  { -- | 8 x 12 taxels, background 0 and embossing about 1; 0 where nothing was touched.
    partPixels :: !Raster,
    -- | 1 where it was touched, and 0 elsewhere.
    partSeen :: !Raster
  }
  deriving stock (Eq, Show)

-- | What was touched of the box of a symbol with its centre at a place, x and y in pixels, given
-- what flat ground reads in the composite, how much more relief reads, and the angle of the box in
-- degrees clockwise. 'Nothing' where that is less than 'leastSeen' taxels, or relief reads no more.
-- What is computed once a composite is computed when it is given.
partAt :: Composite -> (Double, Double) -> Double -> (Double, Double) -> Maybe Part
partAt composite (flat, contrast) angle = look
  where
    image = weighted composite
    look (x, y)
      | contrast > 0 && V.sum (rasterValues seen) >= fromIntegral leastSeen =
        Just (Part pixels seen)
      | otherwise = Nothing
      where
        here i j = case uncurry (referenceAt image) (place i j) of
          Just (v, m) | m >= leastCoverage -> Just ((v - flat) / contrast)
          _ -> Nothing
        place i j = (x + u, y + v)
          where
            (u, v) = rotated angle (fromMiddle symbolWidth i, fromMiddle symbolHeight j)
        fromMiddle :: Int -> Int -> Double
        fromMiddle side k = fromIntegral k - (fromIntegral side - 1) / 2
        pixels = generate symbolWidth symbolHeight (\i j -> fromMaybe 0 (here i j))
        seen = generate symbolWidth symbolHeight (\i j -> if isJust (here i j) then 1 else 0)

-- | The fewest taxels of a symbol's 96 that are looked at.
leastSeen :: Int
leastSeen = 6
