{-# OPTIONS_HADDOCK hide #-}

-- | The most likely symbol in an image, in either of two orientations, with its probability. The
-- formulas are in "PraTactile.Classification.Calibration".
module PraTactile.Classification.Estimate
  ( ClassEstimate (..),
    estimateDoubt,
    estimateChance,
    estimate,
    estimateFrom,
    leastDoubt,
  )
where

import Data.List (foldl')
import PraTactile.Classification.Calibration
import PraTactile.Classification.Network
import PraTactile.Classification.Templates
import PraTactile.Image
import PraTactile.Symmetry

-- | What an image most likely shows: a class, upright ('identity') or turned by 180 degrees
-- (@turned 2@).
data ClassEstimate = ClassEstimate
  { -- | the most likely class and orientation
    estimateLikeliest :: !(Int, Symmetry),
    -- | the probability of each pair of a class and an orientation, each above 0; they add up to 1
    estimateChances :: ![((Int, Symmetry), Double)],
    -- | the logarithm of a likelihood ratio: of the image if it shows another shape, to the image
    -- if it shows one of the alphabet ('logOddsOther'); 0 if it was not computed
    estimateForeignShape :: !Double
  }
  deriving stock (Eq, Show)

-- | The probability that the most likely class and orientation is wrong.
estimateDoubt :: ClassEstimate -> Double
estimateDoubt e = sum [chance | (what, chance) <- estimateChances e, what /= estimateLikeliest e]

-- | The probability of a class and an orientation; 0 for an unknown class.
estimateChance :: ClassEstimate -> (Int, Symmetry) -> Double
estimateChance e what = sum [chance | (this, chance) <- estimateChances e, this == what]

-- | The smallest doubt that is ever reported, 10^-7. More than ten million images would be needed
-- to support a smaller one.
leastDoubt :: Double
leastDoubt = 1e-7

-- | The estimate for an 8 x 12 image by a network. Refuses what 'outputs' refuses, and a network
-- whose number of outputs is not the number of shapes ('WrongOutputCount').
estimate :: Calibration -> Templates -> Network -> Raster -> Either NetworkError ClassEstimate
estimate calibration shapesSeen n image
  | outputCount n /= templateCount shapesSeen =
    Left (WrongOutputCount (outputCount n) (templateCount shapesSeen))
  | otherwise =
    estimateFrom calibration shapesSeen image
      <$> outputs n image
      <*> outputs n (onRaster (turned 2) image)

-- | The estimate for an 8 x 12 image by any classifier. The last two arguments are the classifier's
-- outputs, one for each shape: for the image, and for the image turned by 180 degrees.
estimateFrom :: Calibration -> Templates -> Raster -> [Double] -> [Double] -> ClassEstimate
estimateFrom calibration shapesSeen image upright upsideDown =
  case [(what, floored p) | (what, p) <- told] of
    [] -> ClassEstimate (0, identity) [] 0
    all'@(one : others) ->
      let likeliest = fst (foldl' (\a b -> if snd b > snd a then b else a) one others)
       in ClassEstimate likeliest all' (logOddsOther calibration likeliest seen)
  where
    seen = symbolFeatures shapesSeen image upright upsideDown
    told = classProbabilities calibration seen
    -- All the other classes together have at least 'leastDoubt', whatever the regression says.
    floored p = (1 - spread) * p + spread / n
    spread = leastDoubt * n / max 1 (n - 1)
    n = fromIntegral (length told)
