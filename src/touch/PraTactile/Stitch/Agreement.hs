{-# LANGUAGE BangPatterns #-}

-- | Whether frames show one relief where they should overlap: what their neighbourhood, which is
-- claimed by their positions, makes of their images.
module PraTactile.Stitch.Agreement
  ( contradiction,
    Agreement (..),
    agreement,
  )
where

import Data.List (foldl', maximumBy, sortOn)
import qualified Data.Map.Strict as Map
import Data.Ord (comparing)
import PraTactile.Image (Raster, rasterHeight, rasterWidth)
import PraTactile.Image.Correlate (Overlap (..), overlapAt, referenceOf)
import PraTactile.Probe (Pose (..))
import PraTactile.Probe.Manifest (alongAxes, axesNamed, straight)
import PraTactile.Stitch.Blend (Place)
import PraTactile.Stitch.Composite (Contradiction (..))
import PraTactile.Stitch.Noise (frameNoise)
import PraTactile.Stitch.Search

-- | Whether frames at these nominal places (taxels) contradict each other where they overlap: along
-- other axes they would agree beyond doubt better, or they have next to nothing in common although
-- they are clear enough to tell.
contradiction :: Registration -> [(Place, Raster)] -> Maybe Contradiction
contradiction settings frames
  | agreed best > 13 / 12 * agreed given + decisive,
    agreed best >= clearShare * agreeable best =
    Just (AgreeingAlong axes)
  | agreeable given > decisive / leastShare,
    agreed given < leastShare * agreeable given =
    Just AgreeingNowhere
  | otherwise = Nothing
  where
    given = agreement settings frames
    (best, axes) =
      maximumBy
        (comparing (agreed . fst))
        [(agreement settings (map (along a) frames), a) | (_, a) <- axesNamed, a /= straight]
    along a ((x, y), image) = let Pose x' y' _ = alongAxes a (Pose x y 0) in ((x', y'), image)

-- | How much likelier, as a natural logarithm, other axes must be, beside a twelfth of what they tell
-- at all, which pixels that resemble their neighbours make uncertain.
decisive :: Double
decisive = 20

-- | Of what frames of one relief would tell, how much must be there, and how much other axes must
-- bring to be named: symbols resemble each other, and so do frames of different ones.
leastShare, clearShare :: Double
leastShare = 0.3
clearShare = 0.5

-- | What overlaps tell, as natural logarithms.
data Agreement = Agreement
  { -- | How much likelier the frames are if those that overlap show one relief there, up to noise of
    -- one variance for all, than if each shows a relief of its own.
    agreed :: !Double,
    -- | What that would be if the frames were alike up to the noise that they are told to have or show, and to a correlation of 'alike'
    -- at most: frames that were pressed otherwise are not quite alike.
    agreeable :: !Double
  }

-- | What frames at these places (taxels) tell, by at most 'mostPairs' pairs, those that overlap most,
-- each at its most probable displacement.
agreement :: Registration -> [(Place, Raster)] -> Agreement
agreement settings frames
  | unlike <= 0 || total <= 0 = Agreement 0 0
  | otherwise =
    Agreement
      (independent * count / 2 * log (total / unlike))
      (negate independent * count / 2 * log (1 - expected * expected))
  where
    telling = take mostPairs (sortOn (negate . meeting) (neighbours frames))
    (count, total, unlike) = foldl' added (0, 0, 0) (map paired telling)
    added (!n, !t, !u) (n', t', u') = (n + n', t + t', u + u')
    noise = max (registrationNoise settings) (frameNoise (map snd frames)) ** 2
    expected = max 0 (min alike (1 - (noise + flat) * count / total))
    meeting ((x, y), a, b) =
      (fromIntegral (min (rasterWidth a) (rasterWidth b)) - abs x)
        * (fromIntegral (min (rasterHeight a) (rasterHeight b)) - abs y) ::
        Double
    -- How many pixels overlap, how much they vary, and how much of that the other does not share.
    paired (step, a, b) =
      shared (snd (maximumBy (comparing fst) (map (scored step (referenceOf a) b) displacements)))
    scored (x, y) there b d@(dx, dy) =
      (independent * logLikelihood settings overlap + logPrior prior d, overlap)
      where
        overlap = overlapAt there b (whole (x + dx)) (whole (y + dy))
    shared (Overlap n va vb cov) = (n, n * varying, n * varying * (1 - like * like))
      where
        varying = (va + vb) / 2 + flat
        like = max 0 cov / sqrt ((va + flat) * (vb + flat))
    -- Not quite nothing, so that rounding errors tell nothing.
    flat = 1e-6
    whole t = fromIntegral (round t :: Int) :: Double
    -- The difference of two frames' errors.
    sigma = sqrt 2 * registrationSigma settings
    prior = Prior (0, 0) (sigma * sigma)
    reach = max 1 (min 9 (ceiling (2 * sigma))) :: Int
    displacements =
      [ (fromIntegral dx, fromIntegral dy)
        | dy <- [negate reach .. reach],
          dx <- [negate reach .. reach]
      ]

-- | The most pairs that are looked at.
mostPairs :: Int
mostPairs = 40

-- | The correlation that overlapping frames are expected to have at most.
alike :: Double
alike = 0.85

-- | The pairs of images that overlap at their places: the displacement from the first's upper left
-- pixel to the second's, and both images. Each pair once.
neighbours :: [(Place, Raster)] -> [(Place, Raster, Raster)]
neighbours placed =
  [ ((x' - x, y' - y), a, b)
    | (k, ((x, y), a)) <- numbered,
      let (column, row) = square (x, y),
      j <- [-1 .. 1],
      i <- [-1 .. 1],
      (l, ((x', y'), b)) <- Map.findWithDefault [] (column + i, row + j) squares,
      k < l,
      abs (x' - x) < fromIntegral (rasterWidth a),
      abs (y' - y) < fromIntegral (rasterHeight a)
  ]
  where
    numbered = zip [0 :: Int ..] placed
    squares = Map.fromListWith (++) [(square place, [f]) | f@(_, (place, _)) <- numbered]
    square (x, y) = (floor (x / side) :: Int, floor (y / side) :: Int)
    side = fromIntegral (maximum (1 : [max (rasterWidth i) (rasterHeight i) | (_, i) <- placed]))
