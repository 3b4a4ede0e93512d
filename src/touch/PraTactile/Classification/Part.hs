-- | The likeliest symbol of which only a part was touched.
module PraTactile.Classification.Part
  ( estimatePart,
    Pixels (..),
    partDistances,
  )
where

import Data.List (sortOn)
import Data.Ord (Down (..))
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Estimate
import PraTactile.Classification.Templates
import PraTactile.Image
import PraTactile.Segmentation (Part (..))
import PraTactile.Symmetry

-- | How the pixels of a composite came about.
data Pixels
  = -- | As the frames were put together.
    AsPut
  | -- | Interpolated once more, to set the composite upright: then the errors of neighbouring ones
    -- are more alike.
    Resampled
  | -- | Of several frames at their nominal places, which nobody has compared: parts of strokes may
    -- lie anywhere.
    Unregistered
  deriving stock (Eq, Show)

-- | The estimate for a part of a symbol, by the shapes themselves, because the network knows whole
-- symbols only. What was touched is taken for a shape, in either orientation and not quite in its
-- place, or for a flat face, with normal noise; see Note [Parts].
estimatePart :: Templates -> Pixels -> Part -> Estimate
estimatePart shapesSeen pixels part = Estimate best [(what, chance l) | (what, l) <- likelihoods] 0
  where
    -- What is flat, or rubbish, is any of the shapes alike.
    chance l = (1 - rubbish) * (l + flatLikelihood / n) / total + rubbish / n
    taxels = V.sum (rasterValues (partSeen part))
    rubbish = nothingOfTheKind taxels
    (distances, flat) = partDistances shapesSeen part
    likelihoods = map (fmap moved) distances
    moved moves = sum [misplacement move * likelihood d | (move, d) <- moves] / allMoves moves
    allMoves = sum . map (misplacement . fst)
    likelihood d = exp ((least - d) / (2 * variance))
    flatLikelihood = likelihood flat
    best = case sortOn (Down . snd) likelihoods of
      (what, _) : _ -> what
      [] -> (0, identity)
    n = fromIntegral (length distances)
    least = minimum (flat : concatMap (map snd . snd) distances)
    variance = alike pixels * max leastVariance (least / max 1 taxels)
    total = sum (map snd likelihoods) + flatLikelihood

-- | The sum of squared differences over the taxels seen: from each class upright, and from each
-- turned by 180 degrees, moved in each way by up to a taxel; and from a flat face.
partDistances :: Templates -> Part -> ([((Int, Symmetry), [((Double, Double), Double)])], Double)
partDistances shapesSeen part =
  ( concatMap from [identity, turned 2],
    V.sum (V.map (^ (2 :: Int)) (rasterValues (partPixels part)))
  )
  where
    from symmetry =
      [((c, symmetry), apart symmetry c) | c <- [0 .. templateCount shapesSeen - 1]]
    apart symmetry c =
      squaredDistances
        shapesSeen
        c
        (onRaster symmetry (partPixels part))
        (onRaster symmetry (partSeen part))

-- How likely a part lies so many taxels right and down of where its neighbours have it: a normal
-- law, but for a factor.
misplacement :: (Double, Double) -> Double
misplacement (x, y) = exp (negate (x * x + y * y) / (2 * 0.35 * 0.35))

-- The least variance of a taxel.
leastVariance :: Double
leastVariance = 0.01

-- How many taxels err alike, as one.
alike :: Pixels -> Double
alike pixels = case pixels of
  AsPut -> 2.25
  Resampled -> 3
  Unregistered -> 5

-- The probability of an image that is nothing of the kind, where so many taxels were seen. Of less
-- than a third of a symbol, frames that were put together a taxel wrong may make another symbol.
nothingOfTheKind :: Double -> Double
nothingOfTheKind taxels = if taxels < 32 then 0.006 else 0.001

{- Note [Parts] Errors of neighbouring taxels are not independent: misplacement and blur spoil whole
   strokes. So a part may lie a little beside its place, in every direction alike, and the variance
   of what then still differs, that of the best of the shapes or the square of a tenth of the
   contrast if that is more, counts for several taxels at once. With the numbers here the 7900 parts
   of 2400 presses by every sensor, upright and at any angle, with noise to 0.5 and position errors
   to three taxels, are nearly likeliest, and about as many of them wrong as are told to be under
   each condition. Likeliest of all would be that next to nothing is nothing of the kind: of 3000
   parts with no other doubt none was wrong (assumption: of another sensor some are).
   bench/calibration.py counts other presses, and docs/evaluation.md has what it counted. At nominal
   places, which may be several taxels wrong, no number of taxels is right for every robot
   (assumption). -}
