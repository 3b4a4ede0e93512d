-- | Checks a target: alternating rounds of our program and the peer, the ratio of each round, and
-- whether the goal is met.
module Bench.Compare
  ( Row (..),
    Standing (..),
    compareWith,
  )
where

import Bench.Pairs
import Bench.Targets
import Control.Exception (IOException, bracket, try)
import Control.Monad (replicateM)
import Data.Maybe (listToMaybe)

-- | The state of a goal.
data Standing
  = Met
  | Missed
  | -- | There was no goal or no peer.
    NoVerdict
  deriving stock (Eq, Show)

-- | A line of the report.
data Row = Row
  { rowTarget :: Target,
    rowGoal :: Goal,
    rowUnit :: String,
    rowOurs :: Maybe Spread,
    rowPeer :: Maybe Spread,
    -- | the peer's first answer, which includes its compilation on first use
    rowFirst :: Maybe Double,
    -- | our speed divided by the peer's
    rowRatio :: Maybe Spread,
    -- | the memory of our process, MiB
    rowPeak :: Double,
    rowStanding :: Standing,
    rowNote :: String
  }

-- | Compares a target with each of its goals, in the given number of rounds after one that is not
-- counted. The arguments are the folder of the peers (without it only our side runs), the timeout
-- in seconds, the number of rounds, and the target.
compareWith :: Maybe FilePath -> Int -> Int -> Target -> IO [Row]
compareWith folder patience rounds target = mapM row (targetGoals target)
  where
    row goal = guarded goal $ case (goal, folder) of
      (TimesAsFast _ peer, Just peers) ->
        withOurs $ \us -> bracket (startPeer peers peer) stop $ \them -> do
          judged goal 1 <$> oneAndMore (pair us them)
      -- A process that has measured before may still hold memory, so each measurement gets a new
      -- one.
      (WithinMebibytes _, _) -> judged goal 0 <$> replicateM rounds (withOurs alone)
      _ -> withOurs (fmap (judged goal 1) . oneAndMore . alone)
    -- A program that did not answer is not asked again.
    oneAndMore act =
      act >>= \one -> (one :) <$> either (const (pure [])) (const (replicateM rounds act)) one
    withOurs = bracket (startOurs (targetRunTime target) (targetOurs target)) stop
    pair us them = (\a b -> (,) <$> a <*> (Just <$> b)) <$> ask patience us <*> ask patience them
    alone us = fmap (\a -> (a, Nothing)) <$> ask patience us
    guarded goal act = either (failed goal) id <$> (try act :: IO (Either IOException Row))
    failed goal problem = (emptyRow goal) {rowNote = show problem}
    emptyRow goal = Row target goal "" Nothing Nothing Nothing Nothing 0 NoVerdict ""
    judged goal uncounted rounded = case sequence rounded of
      Left problem -> (emptyRow goal) {rowNote = problem}
      Right answers ->
        let counted = drop uncounted answers
            unit = concatMap (answerUnit . fst) (take 1 answers)
            us = spread (map (answerValue . fst) counted)
            ratios = spread [faster unit (answerValue a) (answerValue b) | (a, Just b) <- counted]
            peak = maximum (0 : map (answerPeak . fst) answers)
            different = or [answerCheck a /= answerCheck b | (a, Just b) <- answers]
         in (emptyRow goal)
              { rowUnit = unit,
                rowOurs = us,
                rowPeer = spread [answerValue b | (_, Just b) <- counted],
                rowFirst = listToMaybe [answerValue b | (_, Just b) <- answers],
                rowRatio = ratios,
                rowPeak = peak,
                rowStanding = standing goal us ratios peak,
                rowNote = if different then "the results differ" else ""
              }
    faster unit a b = if unit == "s" then b / a else a / b

standing :: Goal -> Maybe Spread -> Maybe Spread -> Double -> Standing
standing goal us ratios peak = case goal of
  TimesAsFast 0 _ -> NoVerdict
  TimesAsFast wanted _ -> maybe NoVerdict (met . (>= wanted) . median) ratios
  WithinSeconds limit -> maybe NoVerdict (met . (<= limit) . median) us
  AtLeast wanted -> maybe NoVerdict (met . (>= wanted) . median) us
  WithinMebibytes limit -> met (peak <= limit)
  Recorded -> NoVerdict
  where
    met yes = if yes then Met else Missed
