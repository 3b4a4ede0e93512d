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
    (distances, flat) = partDistances shapesSeen part
    (best, nearest) = case sortOn snd distances of
      first : _ -> first
      [] -> ((0, identity), 0)
    n = fromIntegral (length distances)
    least = min flat nearest
    variance = max leastVariance (least / max 1 (V.sum (rasterValues (partSeen part))))
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

-- The least variance of a taxel, how many neighbouring taxels err alike, and the probability of an
-- image that is nothing of the kind.
leastVariance, correlated, rubbish :: Double
leastVariance = 0.01
correlated = 4
rubbish = 0.001

{- Note [Parts] Errors of neighbouring taxels are not independent: misplacement and blur spoil whole
   strokes. So the exponent of the normal law is divided by a number that was fitted to 7886 parts,
   the half of them with 45 taxels or less, from 2100 simulated explorations with a position error
   of one taxel:

     noise                         0.1     0.2     0.3
     parts                        2566    2562    2758
     likeliest wrong, expected      36      49     105
     likeliest wrong, counted       18      35      83

   A divisor of 2 would expect 18, 26 and 57. The variance is that of the best of the shapes, or the
   square of a tenth of the contrast if that is more. -}
