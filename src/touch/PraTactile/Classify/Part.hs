-- | The likeliest symbol of which only a part was touched.
module PraTactile.Classify.Part
  ( estimatePart,
    partDistances,
  )
where

import Data.List (sortOn)
import qualified Data.Vector.Storable as V
import PraTactile.Classify.Estimate
import PraTactile.Classify.Templates
import PraTactile.Image
import PraTactile.Segment (Part (..))
import PraTactile.Symmetry

-- | The estimate for a part of a symbol, by the shapes themselves, because the network knows whole
-- symbols only. What was touched is taken for a shape, in either orientation, or for a flat face,
-- with normal noise; see Note [Parts].
estimatePart :: Templates -> Part -> Estimate
estimatePart shapesSeen part = Estimate best [(what, chance d) | (what, d) <- distances]
  where
    -- What is flat, or rubbish, is any of the shapes alike.
    chance d = (1 - rubbish) * (weight d + weight flat / n) / total + rubbish / n
    taxels = V.sum (rasterValues (partSeen part))
    correlated = alikeAmong taxels
    rubbish = nothingOfTheKind taxels
    (distances, flat) = partDistances shapesSeen part
    (best, nearest) = case sortOn snd distances of
      first : _ -> first
      [] -> ((0, identity), 0)
    n = fromIntegral (length distances)
    least = min flat nearest
    variance = max leastVariance (least / max 1 taxels)
    weight d = exp ((least - d) / (2 * variance * correlated))
    total = sum (map (weight . snd) distances) + weight flat

-- | The sum of squared differences over the taxels seen: from each class upright, from each turned
-- by 180 degrees, and from a flat face.
partDistances :: Templates -> Part -> ([((Int, Symmetry), Double)], Double)
partDistances shapesSeen part =
  ( concatMap from [identity, turned 2],
    V.sum (V.map (^ (2 :: Int)) (rasterValues (partPixels part)))
  )
  where
    from symmetry =
      [((c, symmetry), apart symmetry c) | c <- [0 .. templateCount shapesSeen - 1]]
    apart symmetry c =
      squaredDistance
        shapesSeen
        c
        (onRaster symmetry (partPixels part))
        (onRaster symmetry (partSeen part))

-- The least variance of a taxel.
leastVariance :: Double
leastVariance = 0.01

-- How many neighbouring taxels err alike, where so many were seen.
alikeAmong :: Double -> Double
alikeAmong taxels = if taxels < 16 then 2.5 else 4

-- The probability of an image that is nothing of the kind, where so many taxels were seen. Of less
-- than a third of a symbol, frames that were put together a taxel wrong may make another symbol, so
-- that it is never beyond a hundredth of doubt.
nothingOfTheKind :: Double -> Double
nothingOfTheKind taxels = if taxels < 32 then 0.012 else 0.001

{- Note [Parts] Errors of neighbouring taxels are not independent: misplacement and blur spoil whole
   strokes. So the exponent of the normal law is divided by a number, and the variance is that of
   the best of the shapes, or the square of a tenth of the contrast if that is more. The numbers
   were chosen so that, of the parts of presses by every sensor, upright and at any angle, and with
   position errors to three taxels, about as many are wrong as are told to be; where nothing but
   noise disturbs, fewer are. bench/calibration.py counts them, and docs/evaluation.md has what it
   counted. -}
