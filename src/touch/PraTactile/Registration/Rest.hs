-- | Each frame of a composite against what the others show.
module PraTactile.Registration.Rest
  ( alignedToRest,
    restOf,
  )
where

import PraTactile.Composite (Composite (..))
import PraTactile.Composite.Blend (Blend (..), Taxels, blend)
import PraTactile.Image (Raster, generate, rasterHeight, rasterWidth, sample, zipRaster)
import PraTactile.Image.Correlate (Reference, reference, referenceAt)
import PraTactile.Registration.Rotation (Aligned, aligned, smooth)

-- | How a frame lies ('aligned', with that standard deviation of its rotation in degrees) against
-- what the other frames of its composite show, given the place of its upper left pixel, pixels of
-- the composite. 'Nothing' where they show too little there.
alignedToRest :: Double -> Composite -> Taxels -> Raster -> Maybe Aligned
alignedToRest sigma composite (x, y) image = do
  rest <- restOf composite corner (wide, high) (local, image)
  aligned sigma (known rest) local (smooth image)
  where
    margin = 2
    (wide, high) = (rasterWidth image + 2 * margin + 1, rasterHeight image + 2 * margin + 1)
    corner@(left, top) = (floor x - margin, floor y - margin) :: (Int, Int)
    local = (x - fromIntegral left, y - fromIntegral top)
    known rest u v = case referenceAt rest u v of
      Just (value, weight) | weight >= leastWeight -> Just value
      _ -> Nothing
    -- What hardly another frame has seen is not known.
    leastWeight = 0.5

-- | What a part of a composite, by its upper left pixel, its width and its height, would be without
-- one image, which was laid there on it; what is beyond the composite was seen by none.
restOf :: Composite -> (Int, Int) -> (Int, Int) -> (Taxels, Raster) -> Maybe Reference
restOf composite (left, top) (wide, high) own = do
  sums <- difference (part sumsOf) ownSums
  weights <- difference (part weightsOf) ownWeights
  either (const Nothing) Just (reference (smooth sums) (smooth weights))
  where
    Blend ownSums ownWeights = blend wide high [own]
    difference a b = either (const Nothing) Just (zipRaster (-) a b)
    part f = generate wide high (\i j -> f (left + i) (top + j))
    (image, coverage) = (compositeImage composite, compositeCoverage composite)
    inside i j = i >= 0 && j >= 0 && i < rasterWidth image && j < rasterHeight image
    at from i j = sample from (fromIntegral i) (fromIntegral j)
    weightsOf i j = if inside i j then at coverage i j else 0
    sumsOf i j = if inside i j then at coverage i j * at image i j else 0
