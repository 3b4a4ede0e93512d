-- | The likeliest symbol in an image, in either of two orientations, and how sure that is.
--
-- The network's outputs tell which class and orientation are the likeliest; but they do not tell
-- how often that is wrong, because an output unit is nearly as sure of a blurred symbol as of a
-- clear one. How well the image matches the likeliest symbol's own shape does. Note [Calibration]
module PraTactile.Classification.Estimate
  ( Estimate (..),
    estimateDoubt,
    estimateChance,
    estimate,
    estimateFrom,
    leastDoubt,

    -- * How doubt follows from an image
    Regression (..),
    standardRegression,
    regressors,
  )
where

import Data.List (sortOn)
import Data.Ord (Down (..))
import PraTactile.Classification.Network
import PraTactile.Classification.Templates
import PraTactile.Image
import PraTactile.Symmetry

-- | What an image most likely shows: a class, upright ('identity') or turned by 180 degrees
-- (@turned 2@).
data Estimate = Estimate
  { estimateLikeliest :: !(Int, Symmetry),
    -- | the probabilities of all, each above 0; they add up to 1
    estimateChances :: ![((Int, Symmetry), Double)]
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
estimate :: Regression -> Templates -> Network -> Raster -> Either NetworkError Estimate
estimate fitted shapesSeen n image
  | outputCount n /= templateCount shapesSeen =
    Left (WrongOutputCount (outputCount n) (templateCount shapesSeen))
  | otherwise =
    estimateFrom fitted shapesSeen image
      <$> outputs n image
      <*> outputs n (onRaster (turned 2) image)

-- | The same from what the network's outputs, one a shape, are for the image and for the image
-- turned by 180 degrees.
estimateFrom :: Regression -> Templates -> Raster -> [Double] -> [Double] -> Estimate
estimateFrom (Regression intercept perLead perLikeness) shapesSeen image upright upsideDown =
  case regressors shapesSeen image upright upsideDown of
    Just (best, others, lead, likeness) ->
      let w = doubt lead likeness
       in Estimate
            best
            ((best, 1 - w) : [(what, w / fromIntegral (length others)) | what <- others])
    Nothing -> Estimate (0, identity) []
  where
    blind = 1 - 1 / fromIntegral (2 * templateCount shapesSeen)
    doubt lead likeness =
      max leastDoubt (min blind (sigmoid (intercept - perLead * lead - perLikeness * likeness)))

-- | What the doubt is told from: the likeliest class and turn, the others, the lead (of the
-- greatest logit over the next) and the likeness (the greatest correlation with the likeliest's
-- shape).
regressors ::
  Templates ->
  Raster ->
  [Double] ->
  [Double] ->
  Maybe ((Int, Symmetry), [(Int, Symmetry)], Double, Double)
regressors shapesSeen image upright upsideDown =
  case sortOn (Down . snd) (logits identity upright ++ logits (turned 2) upsideDown) of
    (best, first) : others@((_, second) : _) ->
      Just (best, map fst others, first - second, matched best)
    _ -> Nothing
  where
    logits symmetry values = [((c, symmetry), logit o) | (c, o) <- zip [0 ..] values]
    matched (c, symmetry) = match shapesSeen c (onRaster symmetry image)

-- | The inverse of the logistic function; outputs are limited to 10^-15 from 0 and 1.
logit :: Double -> Double
logit o = log (p / (1 - p))
  where
    p = max 1e-15 (min (1 - 1e-15) o)

-- | The logistic regression of Note [Calibration]: the log odds of a wrong estimate are the first
-- number, less the second times the lead, less the third times the likeness.
data Regression = Regression
  { regressionIntercept :: !Double,
    regressionPerLead :: !Double,
    regressionPerLikeness :: !Double
  }
  deriving stock (Eq, Show)

-- | That of the shapes shipped for GF(4).
standardRegression :: Regression
standardRegression = Regression 11.3 0.11 21.9

{- Note [Calibration] Of the shapes shipped for GF(4) 25 000 symbols were cut from composites of
   5000 simulated explorations with a position error of one taxel and sensor noise of 0.1 to 0.4 of
   full scale, and the estimate compared with the truth. The log odds of a wrong estimate were
   fitted by logistic regression on the lead (of the greatest logit over the next) and the likeness
   (the greatest correlation with the shape):

     noise               0.1     0.2     0.3     0.4
     symbols            8525    8497    6169    1804
     wrong, expected     1.3     2.8      39      94
     wrong, counted        0       0      40     107

   The lead alone would expect 10, 11, 48 and 78. Of the 147 wrong ones the true class and
   orientation was the network's second choice 30 times, and the others' 16 to 22 times each: as
   good as evenly spread, which is why all others count as equally likely. -}
