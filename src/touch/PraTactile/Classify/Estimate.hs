{-# LANGUAGE DerivingStrategies #-}

-- | The likeliest symbol in an image, in either of two orientations, and how sure that is.
--
-- The network's outputs tell which class and orientation are the likeliest; but they do not tell how often that is wrong, because an
-- output unit is nearly as sure of a blurred symbol as of a clear one. How well the image matches the likeliest symbol's own shape does. Note [Calibration]
module PraTactile.Classify.Estimate
  ( -- * Estimates
    Estimate (..)
  , estimate
  , leastDoubt

    -- * Matching
  , Templates
  , templates
  , match
  ) where

import Data.List (sortOn)
import Data.Ord (Down (..))
import Data.Vector (Vector)
import qualified Data.Vector as Boxed
import qualified Data.Vector.Storable as V

import PraTactile.Classify.Network
import PraTactile.Image
import PraTactile.Shape

-- | What an image most likely shows.
data Estimate = Estimate
  { estimateClass :: !Int
  , estimateHalfTurned :: !Bool
  -- ^ Whether it shows the symbol turned by 180 degrees.
  , estimateDoubt :: !Double
  -- ^ The probability that it shows another class or the other orientation, above 0 and at most that of a blind choice. All the others
  -- are equally likely.
  }
  deriving stock (Eq, Show)

-- | The least doubt that is ever told: more than ten million images would be needed to show that it is less.
leastDoubt :: Double
leastDoubt = 1e-7

-- | The estimate for an 8 x 12 image. Refuses what 'outputs' does, and ('WrongOutputCount') a network whose outputs are not one a shape.
estimate :: Templates -> Network -> Raster -> Either NetworkError Estimate
estimate shapesSeen n image
  | outputCount n /= templateCount shapesSeen = Left (WrongOutputCount (outputCount n) (templateCount shapesSeen))
  | otherwise = do
      upright <- outputs n image
      turned <- outputs n (halfTurn image)
      pure (likeliest (ranked upright turned))
 where
  ranked upright turned =
    sortOn (Down . snd) ([((c, False), logit o) | (c, o) <- zip [0 ..] upright] ++ [((c, True), logit o) | (c, o) <- zip [0 ..] turned])
  likeliest ((best, first) : (_, second) : _) = Estimate (fst best) (snd best) (doubt (first - second) (matched best))
  likeliest _ = Estimate 0 False 1
  matched (c, isTurned) = match shapesSeen c (if isTurned then halfTurn image else image)
  blind = 1 - 1 / fromIntegral (2 * templateCount shapesSeen)
  doubt lead likeness = max leastDoubt (min blind (sigmoid (intercept - perLead * lead - perLikeness * likeness)))

-- | The inverse of the logistic function; outputs are told from 0 and 1 to 10^-15.
logit :: Double -> Double
logit o = log (p / (1 - p))
 where
  p = max 1e-15 (min (1 - 1e-15) o)

-- The logistic regression of Note [Calibration].
intercept, perLead, perLikeness :: Double
intercept = 11.3
perLead = 0.11
perLikeness = 21.9

-- | The shapes of an alphabet as they are seen when misplaced a little.
newtype Templates = Templates (Vector [V.Vector Double])

templateCount :: Templates -> Int
templateCount (Templates classes) = Boxed.length classes

-- | Each shape of the alphabet at its place and moved by half a taxel in each direction.
templates :: Alphabet -> Templates
templates alphabetOfAll = Templates (Boxed.fromList (map placed (shapes alphabetOfAll)))
 where
  placed shape =
    [ standardised (rasterValues (generate symbolWidth symbolHeight (\x y -> sampled (framed shape) (fromIntegral x - dx) (fromIntegral y - dy))))
    | dx <- offsets
    , dy <- offsets
    ]
  offsets = [-0.5, 0, 0.5]
  -- With a flat margin of a taxel, so that what is moved out of the box is replaced by flat.
  framed shape = generate (symbolWidth + 2) (symbolHeight + 2) (\x y -> if embossedAt shape (x - 1) (y - 1) then 1 else 0)
  sampled image x y = sample image (x + 1) (y + 1)

-- | How much an 8 x 12 image is like the shape of a class: the greatest correlation coefficient of the two, the shape moved by up to half a
-- taxel; from -1 to 1. 0 for an image all of whose values are the same, for one of another size, and for a class that there is not.
match :: Templates -> Int -> Raster -> Double
match (Templates classes) c image = case classes Boxed.!? c of
  Just placed@(_ : _) | V.length values == symbolWidth * symbolHeight -> maximum (map (V.sum . V.zipWith (*) seen) placed)
  _ -> 0
 where
  values = rasterValues image
  seen = standardised values

-- | Less the mean, and of length 1; zero where all values are the same.
standardised :: V.Vector Double -> V.Vector Double
standardised values
  | size > 0 = V.map (/ size) centred
  | otherwise = centred
 where
  average = V.sum values / fromIntegral (max 1 (V.length values))
  centred = V.map (subtract average) values
  size = sqrt (V.sum (V.map (^ (2 :: Int)) centred))

-- Note [Calibration]
-- ~~~~~~~~~~~~~~~~~~
-- 25 000 symbols were cut from composites of 4 800 simulated explorations with a position error of one taxel and sensor noise of 0.1 to
-- 0.4 of full scale, and the estimate compared with the truth. The log odds of a wrong estimate were fitted by logistic regression on the
-- lead (of the greatest logit over the next) and the likeness (the greatest correlation with the shape):
--
--   noise               0.1     0.2     0.3     0.4
--   symbols            8525    8497    6169    1805
--   wrong, expected     1.3     2.8      41     102
--   wrong, counted        0       0      40     107
--
-- The lead alone would expect 10, 11, 48 and 78. Of the 147 wrong ones the true class and orientation was the network's second choice 30
-- times, and the others' 16 to 22 times each: as good as evenly spread, which is why all others count as equally likely.
