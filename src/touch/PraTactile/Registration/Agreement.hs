{-# OPTIONS_HADDOCK hide #-}

-- | Whether frames show one relief where they should overlap: what their neighbourhood, which is
-- claimed by their positions, makes of their images.
module PraTactile.Registration.Agreement
  ( contradiction,
    evidenceAt,
  )
where

import Data.List (foldl', maximumBy, partition)
import qualified Data.Map.Lazy as Map
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
    (given, others) = case map (agreement (noiseOf settings (map snd frames))) shared of
      told : rest -> (told, rest)
      [] -> (Agreement 0 0, [])
    shared = sharings settings (map snd frames) (map pairsAlong ordered)
    (best, axes) = maximumBy (comparing (agreed . fst)) (zip others (drop 1 ordered))
    ordered = straight : filter (/= straight) (map snd axesNamed)
    pairsAlong a = telling mostPairs (overlapping (map (along a) frames))
    along a ((x, y), image) = let Pose x' y' _ = alongAxes a (Pose x y 0) in ((x', y'), image)

-- | How much likelier, as a natural logarithm, the images' overlaps make each of some lists of
-- places than the frames' own: by the pairs that lie otherwise to each other. No list of places is
-- made likelier, for symbols resemble each other.
evidenceAt :: Registration -> [(Taxels, Raster)] -> [[Taxels]] -> [Double]
evidenceAt settings frames others = zipWith (\a b -> min 0 (b - a)) (told asGiven) (told asOthers)
  where
    told = map (sum . map (tie settings noise)) . sharings settings images
    noise = noiseOf settings images
    asGiven = [telling mostOfLayout (filter (moved places) here) | places <- others]
    asOthers =
      [ telling mostOfLayout (filter (moved given) (overlapping (zip places images)))
        | places <- others
      ]
    here = overlapping frames
    (given, images) = unzip frames
    moved places = unlike (Boxed.fromList places)
    unlike places (Neighbours k l (x, y) _) =
      let ((x1, y1), (x2, y2)) = (places Boxed.! k, places Boxed.! l)
       in abs (x2 - x1 - x) > 1 || abs (y2 - y1 - y) > 1

-- | How much likelier, as a natural logarithm, what two frames share is if they show one relief
-- there, and are as alike as noise of that standard deviation lets them be, than if each shows its
-- own; less what it costs to look for the likeliest displacement.
tie :: Registration -> Double -> Shared -> Double
tie settings noise (Shared n total unlike)
  | total <= 0 = 0
  | likelier > 0 = max 0 (likelier - cost)
  | otherwise = min 0 (likelier + cost)
  where
    likelier =
      independent * n
        * (negate (log (1 - p * p)) / 2 - p * (p - min p like) / (1 - p * p))
    p = expectedAlike noise n total
    like = sqrt (max 0 (1 - unlike / total))
    cost = max 0 (log (4 * pi * supposedSigma settings * supposedSigma settings))

-- | The standard deviation of the noise: the one told, or what images show if that is more.
noiseOf :: Registration -> [Raster] -> Double
noiseOf settings images = max (registrationNoise settings) (frameNoise images)

-- | What the pairs of some lists of pairs share, as pairs from 'telling'.
sharings :: Registration -> [Raster] -> [[(Int, Int, Taxels)]] -> [[Shared]]
sharings settings images lists = map (map (sharedByPair Map.!)) lists
  where
    -- What pairs share, each once, as many axes have pairs in common, and when it is looked at.
    sharedByPair =
      Map.fromSet (sharedBy settings (Boxed.fromList images)) (Set.fromList (concat lists))

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
    expected = expectedAlike noise count total

-- | The correlation that frames of noise of that standard deviation are expected to have in so many
-- pixels, which vary so much in all, where they show one relief.
expectedAlike :: Double -> Double -> Double -> Double
expectedAlike noise count total = max 0 (min alike (1 - (noise * noise + flat) * count / total))

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
    sigma = sqrt 2 * supposedSigma settings
    prior = Prior (0, 0) (sigma * sigma)
    reach = max 1 (min 9 (2 * sigma))
    line = let r = floor reach :: Int in map fromIntegral [negate r .. r]
    displacements = [(dx, dy) | dy <- line, dx <- line, dx * dx + dy * dy <= reach * reach]

-- | Not quite nothing, so that rounding errors tell nothing: a variance of grey values.
flat :: Double
flat = 1e-6

-- | The most pairs that are looked at, of those side by side and of those one below the other: for
-- axes, and for each of many layouts.
mostPairs, mostOfLayout :: Int
mostPairs = 16
mostOfLayout = 8

-- | The correlation that overlapping frames are expected to have at most.
alike :: Double
alike = 0.85

-- | Pairs of images that overlap at their places, around at most @mostCentres@ of them.
overlapping :: [(Taxels, Raster)] -> [Neighbours]
overlapping = neighboursAround mostCentres

-- | Of those that lie side by side and of those that lie one below the other, each for itself, the
-- pairs that overlap by an eighth of a frame and by nearly half of the most, at most so many of
-- them, evenly; by their numbers, with where the second's upper left pixel lies in the first.
-- However large the one's overlaps are, they tell nothing of how the others lie; and pairs of
-- frames that hardly moved tell nothing of how any lie.
telling :: Int -> [Neighbours] -> [(Int, Int, Taxels)]
telling most found = concatMap largest [beside, below]
  where
    (beside, below) = partition (across . neighboursStep) (filter (apart . neighboursStep) found)
    across (x, y) = abs x > abs y
    apart (x, y) = max (abs x) (abs y) >= leastStep
    largest pairs =
      spacedOut most [(k, l, step) | Neighbours k l step share <- pairs, share >= least]
      where
        least = max 0.125 (0.45 * maximum (map neighboursShare pairs))

-- | How far apart two frames lie at least that tell how they lie, taxels.
leastStep :: Double
leastStep = 2

-- | The most images around which pairs are looked for.
mostCentres :: Int
mostCentres = 64
