-- | Counts of simulated trials, and rates from them.
module PraTactile.Rates.Tally
  ( -- * Counting
    RatesTally,
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

    -- * Are the probabilities calibrated?
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
data RatesTally = RatesTally
  { -- | The number of trials.
    tallyTrials :: !Int,
    -- | The number of trials that hard decoding located right.
    tallyRight :: !Int,
    -- | The number of trials that hard decoding located wrong; it refused the others.
    tallyWrong :: !Int,
    -- | The results of soft decoding, by the doubt of the likeliest position. Bin b has doubts from
    -- 10^(-(b + 1) / 50) up to 10^(-b / 50); bin 1000 has all that are smaller.
    tallyDoubts :: !(Map Int Soft)
  }
  deriving stock (Eq, Show)

-- | For trials with about the same doubt: their number, the number in which the likeliest position
-- was true, and the sum of the doubts, which is the expected number of wrong ones.
data Soft = Soft !Int !Int !Double
  deriving stock (Eq, Show)

instance Semigroup Soft where
  Soft n a s <> Soft n' a' s' = Soft (n + n') (a + a') (s + s')

instance Monoid Soft where
  mempty = Soft 0 0 0

-- | The tally without trials.
noTrials :: RatesTally
noTrials = RatesTally 0 0 0 Map.empty

-- | Adds one trial.
count :: RatesTally -> PatchResult -> RatesTally
count (RatesTally n right wrong doubts) (PatchResult hard likeliest doubt) =
  RatesTally
    (n + 1)
    (right + one (hard == Correct))
    (wrong + one (hard == Mistaken))
    (Map.insertWith (<>) bin soft doubts)
  where
    one holds = if holds then 1 else 0
    soft = Soft 1 (one likeliest) doubt
    bin = if doubt <= 1e-20 then 1000 else max 0 (floor (-50 * logBase 10 doubt))

-- | The sum of tallies.
merge :: [RatesTally] -> RatesTally
merge = foldl' add noTrials
  where
    add (RatesTally n a b m) (RatesTally n' a' b' m') =
      RatesTally (n + n') (a + a') (b + b') (Map.unionWith (<>) m m')

-- | The rates of hard decoding to the radius of the observed cells.
hardRates :: RatesTally -> Rates
hardRates tally = ratesOf tally (fromIntegral (tallyRight tally)) (fromIntegral (tallyWrong tally))

-- | The rates of soft decoding with this tolerated probability of a wrong answer, rounded to a 50th
-- of a power of ten.
softRates :: Double -> RatesTally -> Rates
softRates tolerated tally = ratesOf tally (fromIntegral right) (fromIntegral (answers - right))
  where
    Soft answers right _ = tolerable tolerated tally

-- | The rates of soft decoding that answers the trials with the least doubts, up to an expected
-- share of wrong answers among all trials. No other rule on the same readings is right more often
-- with as many expected wrong answers (C. K. Chow 1970). Of the bin in which the share is reached,
-- a part is answered.
softRatesAtMost :: Double -> RatesTally -> Rates
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

-- | The observed number of wrong answers of soft decoding, and the number that their doubts
-- predict.
data Calibration = Calibration
  { -- | The number of answers.
    calibratedAnswers :: !Int,
    -- | The number of wrong answers that the doubts predict.
    calibratedExpected :: !Double,
    -- | The number of answers that were wrong.
    calibratedWrong :: !Int
  }
  deriving stock (Eq, Show)

-- | The calibration of the answers with this tolerated probability of a wrong answer.
calibration :: Double -> RatesTally -> Calibration
calibration tolerated tally = Calibration answers expected (answers - right)
  where
    Soft answers right expected = tolerable tolerated tally

-- | The trials with at most this doubt.
tolerable :: Double -> RatesTally -> Soft
tolerable tolerated tally =
  mconcat [soft | (bin, soft) <- Map.toAscList (tallyDoubts tally), bin >= least]
  where
    least = ceiling (-50 * logBase 10 tolerated - 1e-9) :: Int

-- | The rates of right and wrong answers, given their numbers; the other trials are refused.
ratesOf :: RatesTally -> Double -> Double -> Rates
ratesOf tally right wrong =
  Rates (share right) (share wrong) (share (fromIntegral (tallyTrials tally) - right - wrong))
  where
    share n = n / fromIntegral (max 1 (tallyTrials tally))
