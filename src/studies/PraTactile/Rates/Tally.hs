-- | Counts of simulated trials, and the rates they are.
module PraTactile.Rates.Tally
  ( -- * Counting
    Tally,
    tallyTrials,
    tallyRight,
    tallyWrong,
    noTrials,
    count,
    merge,

    -- * Rates
    hardRates,
    softRates,
    softRatesAtMost,

    -- * Are the probabilities honest?
    Calibration (..),
    calibration,
  )
where

import Data.List (foldl')
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import PraTactile.Rates.Decoding
import PraTactile.Rates.Formulas

-- | Counts of trials.
data Tally = Tally
  { -- | How many.
    tallyTrials :: !Int,
    -- | How many hard decoding located right.
    tallyRight :: !Int,
    -- | How many it located wrong; the others it refused.
    tallyWrong :: !Int,
    -- | Soft decoding, by the doubt of the likeliest position, in 50ths of a power of ten.
    tallyDoubts :: !(Map Int Soft)
  }
  deriving stock (Eq, Show)

-- | Of the trials with about the same doubt: how many, in how many the likeliest position was the
-- true one, and the sum of the doubts, which is the number of wrong ones to be expected.
data Soft = Soft !Int !Int !Double
  deriving stock (Eq, Show)

instance Semigroup Soft where
  Soft n a s <> Soft n' a' s' = Soft (n + n') (a + a') (s + s')

instance Monoid Soft where
  mempty = Soft 0 0 0

-- | None.
noTrials :: Tally
noTrials = Tally 0 0 0 Map.empty

-- | One trial more.
count :: Tally -> TrialResult -> Tally
count (Tally n right wrong doubts) (TrialResult hard likeliest doubt) =
  Tally
    (n + 1)
    (right + one (hard == Correct))
    (wrong + one (hard == Mistaken))
    (Map.insertWith (<>) bin soft doubts)
  where
    one holds = if holds then 1 else 0
    soft = Soft 1 (one likeliest) doubt
    bin = if doubt <= 1e-20 then 1000 else max 0 (floor (-50 * logBase 10 doubt))

-- | The counts together.
merge :: [Tally] -> Tally
merge = foldl' add noTrials
  where
    add (Tally n a b m) (Tally n' a' b' m') =
      Tally (n + n') (a + a') (b + b') (Map.unionWith (<>) m m')

-- | The rates of hard decoding to the radius of the cells observed.
hardRates :: Tally -> Rates
hardRates tally = ratesOf tally (fromIntegral (tallyRight tally)) (fromIntegral (tallyWrong tally))

-- | The rates of soft decoding where this probability of a wrong answer is tolerated, to a 50th of
-- a power of ten.
softRates :: Double -> Tally -> Rates
softRates tolerated tally = ratesOf tally (fromIntegral right) (fromIntegral (answers - right))
  where
    Soft answers right _ = tolerable tolerated tally

-- | The rates of soft decoding that answers where the doubt is least, as often as the wrong answers
-- to be expected stay at most this share of all trials. No other way to decide on the same readings
-- is right more often at as many wrong answers to be expected (C. K. Chow 1970). Of the 50th of a
-- power of ten at which the share is reached, a part is answered.
softRatesAtMost :: Double -> Tally -> Rates
softRatesAtMost share tally = go 0 0 0 (map snd (Map.toDescList (tallyDoubts tally)))
  where
    budget = share * fromIntegral (tallyTrials tally)
    go _ right wrong [] = ratesOf tally right wrong
    go spent right wrong (Soft n a doubts : others)
      | part < 1 = ratesOf tally right' wrong'
      | otherwise = go (spent + doubts) right' wrong' others
      where
        part = if doubts <= 0 then 1 else min 1 ((budget - spent) / doubts)
        right' = right + part * fromIntegral a
        wrong' = wrong + part * fromIntegral (n - a)

-- | How often the answers of soft decoding were wrong, beside how often their doubts expect it.
data Calibration = Calibration
  { -- | How many answers there were.
    calibratedAnswers :: !Int,
    -- | How many wrong ones are to be expected among them, by their own doubts.
    calibratedExpected :: !Double,
    -- | How many were wrong.
    calibratedWrong :: !Int
  }
  deriving stock (Eq, Show)

-- | The calibration of the answers where this probability of a wrong answer is tolerated.
calibration :: Double -> Tally -> Calibration
calibration tolerated tally = Calibration answers expected (answers - right)
  where
    Soft answers right expected = tolerable tolerated tally

tolerable :: Double -> Tally -> Soft
tolerable tolerated tally =
  mconcat [soft | (bin, soft) <- Map.toAscList (tallyDoubts tally), bin >= least]
  where
    least = ceiling (-50 * logBase 10 tolerated - 1e-9) :: Int

ratesOf :: Tally -> Double -> Double -> Rates
ratesOf tally right wrong =
  Rates (share right) (share wrong) (share (fromIntegral (tallyTrials tally) - right - wrong))
  where
    share n = n / fromIntegral (max 1 (tallyTrials tally))
