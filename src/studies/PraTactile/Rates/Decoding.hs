{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_GHC -O2 #-}

-- | Decodes trials fast. The result contains only the figures that are counted, computed by
-- comparing machine words, and agrees with 'PraTactile.Locate.locate'. The tests compare the two.
--
-- A table of rates takes millions of trials. With 'PraTactile.Locate.locate', which makes a patch
-- of each trial, the patches from 2 x 2 to 5 x 5 cells of the default table take four times as
-- long.
module PraTactile.Rates.Decoding
  ( PatchResult (..),
    HardAnswer (..),
    decodeTrial,
  )
where

import Data.Bits (popCount, xor, (.&.), (.|.))
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word64)
import PraTactile.Locate (Radius (..), guaranteedRadius)
import PraTactile.Rates.Setup
import PraTactile.Rates.Trial

-- | The result of decoding a trial.
data PatchResult = PatchResult
  { -- | By hard decoding of the likeliest symbols, to the stated radius.
    resultHard :: !HardAnswer,
    -- | By soft decoding: whether the likeliest position is the true one.
    resultLikeliest :: !Bool,
    -- | The probability that another position is the true one.
    resultDoubt :: !Double
  }
  deriving stock (Eq, Show)

-- | An answer of hard decoding compared with the truth.
data HardAnswer = Correct | Mistaken | NoAnswer
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | Decodes a trial twice: its likeliest symbols, with errors up to this radius, and its
-- probabilities.
decodeTrial :: Radius -> TrialSetup k -> PatchTrial -> PatchResult
decodeTrial radius setup trial =
  PatchResult (hardAnswer radius setup trial) (best == trialPosition trial) doubt
  where
    (best, doubt) = likeliestPosition setup trial

-- | Hard decoding: the unique nearest position, if it is within the radius.
hardAnswer :: Radius -> TrialSetup k -> PatchTrial -> HardAnswer
hardAnswer radius setup trial
  | observed == 0 || nearestTies found > 1 || nearestErrors found > farthest = NoAnswer
  | nearestIndex found == trialPosition trial = Correct
  | otherwise = Mistaken
  where
    found = nearestPosition setup trial
    observed = Primitive.foldl' (\k limb -> k + popCount limb) 0 (trialSeen trial)
    farthest = case radius of
      Guaranteed -> fromIntegral (guaranteedRadius (fromIntegral (leastWeight found)))
      UpTo e -> fromIntegral (min e (fromIntegral (setupCells setup)))

-- | The nearest position to the likeliest symbols.
data Nearest = Nearest
  { -- | The number of observed cells in which it differs.
    nearestErrors :: !Int,
    -- | The number of positions that differ in just as many cells.
    nearestTies :: !Int,
    -- | The index of the first such position.
    nearestIndex :: !Int,
    -- | The least weight of any position's content in the observed cells.
    leastWeight :: !Int
  }

-- | Finds the nearest position by comparing with all.
nearestPosition :: TrialSetup k -> PatchTrial -> Nearest
nearestPosition setup trial = go 0 maxBound 0 0 maxBound
  where
    limbs = setupLimbs setup
    planes = setupPlanes setup
    go :: Int -> Int -> Int -> Int -> Int -> Nearest
    go !i !least !ties !at !weight
      | i == setupPositions setup = Nearest least ties at weight
      | e < least = go (i + 1) e 1 i w
      | otherwise = go (i + 1) least (if e == least then ties + 1 else ties) at w
      where
        e = differing (i * limbs) 0 0
        w = min weight (supported (i * limbs) 0 0)
    differing :: Int -> Int -> Int -> Int
    differing !from !l !total
      | l == limbs = total
      | otherwise =
        let unlike = digitsDiffering (planes * (from + l)) (planes * l) 0 0
         in differing from (l + 1) (total + popCount (unlike .&. seenAt l))
    digitsDiffering :: Int -> Int -> Int -> Word64 -> Word64
    digitsDiffering !from !own !b !bits
      | b == planes = bits
      | otherwise =
        digitsDiffering from own (b + 1) (bits .|. (digitAt (from + b) `xor` symbolAt (own + b)))
    supported :: Int -> Int -> Int -> Int
    supported !from !l !total
      | l == limbs = total
      | otherwise = supported from (l + 1) (total + popCount (supportAt (from + l) .&. seenAt l))
    -- All indices are below positions * limbs * planes.
    seenAt = Primitive.unsafeIndex (trialSeen trial)
    digitAt = Primitive.unsafeIndex (setupDigits setup)
    symbolAt = Primitive.unsafeIndex (trialSymbols trial)
    supportAt = Primitive.unsafeIndex (setupSupports setup)

-- | Soft decoding: the index of the first likeliest position, and the probability of all others.
likeliestPosition :: TrialSetup k -> PatchTrial -> (Int, Double)
likeliestPosition setup trial = (best, others / (1 + others))
  where
    n = setupCells setup
    positions = setupPositions setup
    totals = Primitive.generate positions (\i -> likelihood (i * n) ((i + 1) * n) 0)
    likelihood :: Int -> Int -> Double -> Double
    likelihood !i !end !total
      | i == end = total
      | otherwise = likelihood (i + 1) end (total + evidenceAt (contentsAt i))
    evidenceAt = Primitive.unsafeIndex (trialEvidence trial)
    contentsAt i = fromIntegral (Primitive.unsafeIndex (setupContents setup) i)
    best = Primitive.maxIndex totals
    highest = Primitive.unsafeIndex totals best
    -- The total probability of all others relative to the best.
    others = beside 0 0
    beside :: Int -> Double -> Double
    beside !i !total
      | i == positions = total
      | i == best || x < negligible = beside (i + 1) total
      | otherwise = beside (i + 1) (total + exp x)
      where
        x = Primitive.unsafeIndex totals i - highest
    -- Together these terms are below 1e-28, and doubts below 1e-20 are not distinguished.
    negligible = -80
