{-# OPTIONS_HADDOCK hide #-}

-- | Parts of symbols that do not lie wholly in a composite.
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

-- | The touched taxels at a place where a symbol is expected.
data Part = Part
  { -- | 8 x 12 taxels: background 0, embossing about 1, and 0 where nothing was touched.
    partPixels :: !Raster,
    -- | 1 where it was touched, 0 elsewhere.
    partSeen :: !Raster
  }
  deriving stock (Eq, Show)

-- | The part of a symbol whose box is centred at a place (x and y in pixels). The arguments before
-- the place are the composite, the grey value of flat ground and the contrast of the relief, and
-- the angle of the box in degrees clockwise. 'Nothing' if fewer than 'leastSeen' taxels were
-- touched or the contrast is not positive. Apply it to a composite once: what depends only on the
-- composite is then shared.
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

-- | The least number of touched taxels, of a symbol's 96.
leastSeen :: Int
leastSeen = 6
