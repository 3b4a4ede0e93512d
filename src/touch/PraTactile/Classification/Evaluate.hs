-- | How often a network errs, on synthetic images it has not seen: the paper's measurement (section
-- IV, 1100 images of each character at each level of noise), refusals and wrong answers apart.
module PraTactile.Classification.Evaluate
  ( Tally (..),
    tallyImages,
    tallyTogether,
    Placing (..),
    errorRates,
    acceptanceRates,
  )
where

import Data.List (elemIndex, foldl')
import Data.Maybe (isJust)
import PraTactile.Classification.Network
import PraTactile.Classification.Samples
import PraTactile.Classification.Specimens
import PraTactile.Image (Raster)
import PraTactile.Shape
import System.Random (StdGen, mkStdGen)

-- | What became of a number of images.
data Tally = Tally
  { -- | Recognised as what they are.
    tallyRight :: !Int,
    -- | Recognised as something else.
    tallyWrong :: !Int,
    -- | Not recognised.
    tallyRefused :: !Int,
    -- | Whose own class's output is not the greatest, whatever the verdict: the paper's error,
    -- which knows no refusal.
    tallyOutvoted :: !Int
  }
  deriving stock (Eq, Show)

-- | How many images there were.
tallyImages :: Tally -> Int
tallyImages t = tallyRight t + tallyWrong t + tallyRefused t

-- | The tally of all of them.
tallyTogether :: [Tally] -> Tally
tallyTogether = foldl' plus (Tally 0 0 0 0)
  where
    plus (Tally a b c d) (Tally a' b' c' d') = Tally (a + a') (b + b') (c + c') (d + d')

-- | How the test images are made.
data Placing
  = -- | Taxel upon taxel, as in the paper's synthetic images.
    Aligned
  | -- | As stitching and segmentation leave them, misplaced by up to 'misplacementBound'.
    Misplaced
  | -- | The same, and a corner or a margin was not seen.
    Incomplete
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | For each class the tally of this many upright images, from a seed, with white noise of that
-- standard deviation. Refuses ('WrongOutputCount') a network for another number of classes.
errorRates ::
  Thresholds ->
  Network ->
  Alphabet ->
  Placing ->
  Double ->
  Int ->
  Int ->
  Either NetworkError [Tally]
errorRates thresholds n a placing deviation count seed
  | outputCount n /= alphabetSize a = Left (WrongOutputCount (outputCount n) (alphabetSize a))
  | otherwise = sequence [tally k shape (mkStdGen (seed + k)) | (k, shape) <- zip [0 ..] (shapes a)]
  where
    tally k shape = tallied thresholds n (Just k) count (draw shape)
    draw shape g = case placing of
      Aligned -> withNoise deviation (toRaster shape) g
      Misplaced -> uncurry (withNoise deviation) (specimen a Upright shape g)
      Incomplete -> uncurry (withNoise deviation) (specimen a Curtailed shape g)

-- | For each class the tally of this many specimens of a kind that is no upright symbol, made of
-- that class's shape: all that are recognised are wrong.
acceptanceRates ::
  Thresholds ->
  Network ->
  Alphabet ->
  Kind ->
  Double ->
  Int ->
  Int ->
  Either NetworkError [Tally]
acceptanceRates thresholds n a kind deviation count seed =
  sequence
    [ tallied
        thresholds
        n
        Nothing
        count
        (uncurry (withNoise deviation) . specimen a kind shape)
        (mkStdGen (seed + k))
      | (k, shape) <- zip [0 ..] (shapes a)
    ]

tallied ::
  Thresholds ->
  Network ->
  Maybe Int ->
  Int ->
  (StdGen -> (Raster, StdGen)) ->
  StdGen ->
  Either NetworkError Tally
tallied thresholds n class' count draw = go count (Tally 0 0 0 0)
  where
    go left t g
      | left <= 0 = Right t
      | otherwise = do
        let (image, g') = draw g
        values <- outputs n image
        let t' = scored (decide thresholds values) (greatest values) t
        t' `seq` go (left - 1 :: Int) t' g'
    scored verdict first t = outvoted $ case verdict of
      Recognised k _ | Just k == class' -> t {tallyRight = tallyRight t + 1}
      Recognised _ _ -> t {tallyWrong = tallyWrong t + 1}
      _ -> t {tallyRefused = tallyRefused t + 1}
      where
        outvoted u
          | isJust class' && class' /= first = u {tallyOutvoted = tallyOutvoted u + 1}
          | otherwise = u
    greatest values = elemIndex (maximum values) values
