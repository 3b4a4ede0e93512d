-- | Whether frames show one relief where they should overlap: what their neighbourhood, which is
-- claimed by their positions, makes of their images.
module PraTactile.Registration.Agreement
  ( contradiction,
  )
where

import Data.List (foldl', maximumBy)
import qualified Data.Map.Strict as Map
import Data.Ord (comparing)
import qualified Data.Set as Set
import qualified Data.Vector as Boxed
import PraTactile.Composite (Contradiction (..))
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Noise (frameNoise, spacedOut)
import PraTactile.Image (Raster)
import PraTactile.Image.Correlate (Overlap (..), overlapAt, referenceOf)
import PraTactile.Registration.Neighbours (Neighbours (..), neighboursAround)
import PraTactile.Registration.Search
import PraTactile.Sensor.Frame (Pose (..))
import PraTactile.Sensor.Manifest (alongAxes, axesNamed, straight)

-- | Whether frames at these nominal places (taxels) contradict each other where they overlap: along
-- other axes they would agree beyond doubt better, or they have next to nothing in common although
-- they are clear enough to tell.
contradiction :: Registration -> [(Taxels, Raster)] -> Maybe Contradiction
contradiction settings frames
  | agreed best > 13 / 12 * agreed given + decisive,
    agreed best >= clearShare * agreeable best =
    Just (AgreeingAlong axes)
  | agreeable given > clear,
    agreed given < leastShare * agreeable given =
    Just AgreeingNowhere
  | otherwise = Nothing
  where
    given = agreement noise (sharing straight)
    (best, axes) =
      maximumBy
        (comparing (agreed . fst))
        [(agreement noise (sharing a), a) | (_, a) <- axesNamed, a /= straight]
    noise = max (registrationNoise settings) (frameNoise (map snd frames))
    -- What pairs tell, each once: many axes have pairs in common.
    sharing a = [Map.findWithDefault nothing pair sharedByPair | pair <- pairsAlong a]
    sharedByPair =
      Map.fromSet (sharedBy settings images) (Set.fromList (concatMap (pairsAlong . snd) axesNamed))
    images = Boxed.fromList (map snd frames)
    nothing = Shared 0 0 0
    pairsAlong a = telling (map (along a) frames)
    along a ((x, y), image) = let Pose x' y' _ = alongAxes a (Pose x y 0) in ((x', y'), image)

-- | How much likelier, as a natural logarithm, other axes must be, beside a twelfth of what they
-- tell at all, which pixels that resemble their neighbours make uncertain.
decisive :: Double
decisive = 100

-- | How much frames must have to tell before it counts that they tell it not.
clear :: Double
clear = 60

-- | Of what frames of one relief would tell, how much must be there, and how much other axes must
-- bring to be named: symbols resemble each other, and so do frames of different ones.
leastShare, clearShare :: Double
leastShare = 0.3
clearShare = 0.5

-- | What overlaps tell, as natural logarithms.
data Agreement = Agreement
  { -- | How much likelier the frames are if those that overlap show one relief there, up to noise
    -- of one variance for all, than if each shows a relief of its own.
    agreed :: !Double,
    -- | What that would be if the frames were alike up to the noise that they are told to have or
    -- show, and to a correlation of @alike@ at most: frames that were pressed otherwise are not
    -- quite alike.
    agreeable :: !Double
  }

-- | What overlaps of frames with noise of that standard deviation tell, each at its most probable
-- displacement.
agreement :: Double -> [Shared] -> Agreement
agreement noise pairs
  | unlike <= 0 || total <= 0 = Agreement 0 0
  | otherwise =
    Agreement
      (independent * count / 2 * log (total / unlike))
      (negate independent * count / 2 * log (1 - expected * expected))
  where
    Shared count total unlike = foldl' added (Shared 0 0 0) pairs
    added (Shared n t u) (Shared n' t' u') = Shared (n + n') (t + t') (u + u')
    expected = max 0 (min alike (1 - (noise * noise + flat) * count / total))

-- | How many pixels of two frames overlap, how much they vary in all, and how much of that the
-- other does not share.
data Shared = Shared !Double !Double !Double

-- | What two of the frames share, the second's upper left pixel lying there in the first, up to the
-- difference of their errors.
sharedBy :: Registration -> Boxed.Vector Raster -> (Int, Int, Taxels) -> Shared
sharedBy settings images (k, l, (x, y)) =
  shared (snd (maximumBy (comparing fst) (map scored displacements)))
  where
    there = referenceOf (images Boxed.! k)
    scored d@(dx, dy) =
      (independent * logLikelihood settings overlap + logPrior prior d, overlap)
      where
        overlap = overlapAt there (images Boxed.! l) (whole (x + dx)) (whole (y + dy))
    shared (Overlap n va vb cov) = Shared n (n * varying) (n * varying * (1 - like * like))
      where
        varying = (va + vb) / 2 + flat
        like = max 0 cov / sqrt ((va + flat) * (vb + flat))
    whole t = fromIntegral (round t :: Int) :: Double
    sigma = sqrt 2 * registrationSigma settings
    prior = Prior (0, 0) (sigma * sigma)
    reach = max 1 (min 9 (2 * sigma))
    line = let r = floor reach :: Int in map fromIntegral [negate r .. r]
    displacements = [(dx, dy) | dy <- line, dx <- line, dx * dx + dy * dy <= reach * reach]

-- | Not quite nothing, so that rounding errors tell nothing: a variance of grey values.
flat :: Double
flat = 1e-6

-- | The most pairs that are looked at.
mostPairs :: Int
mostPairs = 24

-- | The correlation that overlapping frames are expected to have at most.
alike :: Double
alike = 0.85

-- | Pairs of images that overlap at their places: of those around at most @mostCentres@ images the
-- ones that overlap most, at most @mostPairs@ of them, evenly; by their numbers, with where the
-- second's upper left pixel lies in the first.
telling :: [(Taxels, Raster)] -> [(Int, Int, Taxels)]
telling placed =
  spacedOut mostPairs [(k, l, step) | Neighbours k l step share <- found, share >= 0.75 * largest]
  where
    found = neighboursAround mostCentres placed
    largest = maximum (0 : map neighboursShare found)

-- | The most images around which pairs are looked for.
mostCentres :: Int
mostCentres = 64
