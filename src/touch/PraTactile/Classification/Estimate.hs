{-# OPTIONS_HADDOCK hide #-}

-- | The likeliest symbol in an image, in either of two orientations, and how sure that is: by the
-- formulas of "PraTactile.Classification.Calibration".
module PraTactile.Classification.Estimate
  ( Estimate (..),
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
data Estimate = Estimate
  { estimateLikeliest :: !(Int, Symmetry),
    -- | the probabilities of all, each above 0; they add up to 1
    estimateChances :: ![((Int, Symmetry), Double)],
    -- | the logarithm of how many times as likely the image is of another shape: 0 where that is
    -- not asked
    estimateUnlike :: !Double
  }
  deriving stock (Eq, Show)

-- | The probability that the likeliest is not right.
estimateDoubt :: Estimate -> Double
estimateDoubt e = sum [chance | (what, chance) <- estimateChances e, what /= estimateLikeliest e]

-- | The probability of a class and a turn; 0 for a class that there is not.
estimateChance :: Estimate -> (Int, Symmetry) -> Double
estimateChance e what = sum [chance | (this, chance) <- estimateChances e, this == what]

-- | The least doubt that is ever stated: more than ten million images would be needed to show that
-- it is less.
leastDoubt :: Double
leastDoubt = 1e-7

-- | The estimate for an 8 x 12 image. Refuses what 'outputs' does, and ('WrongOutputCount') a
-- network whose outputs are not one a shape.
estimate :: Calibration -> Templates -> Network -> Raster -> Either NetworkError Estimate
estimate calibration shapesSeen n image
  | outputCount n /= templateCount shapesSeen =
    Left (WrongOutputCount (outputCount n) (templateCount shapesSeen))
  | otherwise =
    estimateFrom calibration shapesSeen image
      <$> outputs n image
      <*> outputs n (onRaster (turned 2) image)

-- | The same from what the outputs of a classifier, one a shape, are for the image and for the
-- image turned by 180 degrees.
estimateFrom :: Calibration -> Templates -> Raster -> [Double] -> [Double] -> Estimate
estimateFrom calibration shapesSeen image upright upsideDown =
  case [(what, floored p) | (what, p) <- told] of
    [] -> Estimate (0, identity) [] 0
    all'@(one : others) ->
      let likeliest = fst (foldl' (\a b -> if snd b > snd a then b else a) one others)
       in Estimate likeliest all' (unlikeness calibration likeliest seen)
  where
    seen = look shapesSeen image upright upsideDown
    told = chances calibration seen
    -- Whatever the regression says, all others together have the least doubt.
    floored p = (1 - spread) * p + spread / n
    spread = leastDoubt * n / max 1 (n - 1)
    n = fromIntegral (length told)
