{-# LANGUAGE OverloadedStrings #-}

-- | The table of rates as JSON and CSV, and the JSON of what @evaluate@ counts.
module PraTactile.Format.Rates
  ( -- * Lines of the table
    Line (..),
    ways,
    moreAnswers,
    deviations,

    -- * The table
    RatesReport (..),
    encodeRates,
    csvHeading,
    lineCsv,

    -- * Simulated presses
    EvaluationReport (..),
    EvaluationConditions (..),
    encodeEvaluation,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.ByteString (ByteString)
import Data.List (intercalate)
import qualified Data.Map.Strict as Map
import Data.String (fromString)
import PraTactile.Array (Shape)
import PraTactile.Evaluate (PoseTally (..), Tally (..))
import PraTactile.Explore (Turns (..))
import PraTactile.Format.Json
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Format.Name
import PraTactile.Format.Profile
import PraTactile.Format.Sensor (bendCodec)
import PraTactile.Locate (Radius (..))
import PraTactile.Profile (Profile)
import PraTactile.Rates (Calibration (..))
import PraTactile.Rates.Formulas (Rates (..))
import PraTactile.Sensor (Bend)

-- | A line of the table: the rates of one size and one damage.
data Line = Line
  { lineSize :: Shape,
    -- | per cent
    lineErrors :: Double,
    -- | per cent
    lineErasures :: Double,
    lineTrials :: Int,
    -- | hard decoding, simulated
    lineHard :: Rates,
    -- | the same without chance, where it can be computed
    lineExact :: Maybe Rates,
    -- | soft decoding where 99.9 % certain
    lineSoft :: Rates,
    -- | soft decoding at as many wrong answers as hard decoding; nothing to compare where it is
    -- never wrong
    lineAsHard :: Maybe Rates,
    lineCalibration :: Calibration
  }
  deriving stock (Eq, Show)

-- | The ways to decode, by their names.
ways :: [(String, Line -> Maybe Rates)]
ways =
  [ ("hard", Just . lineHard),
    ("exact", lineExact),
    ("soft_999", Just . lineSoft),
    ("soft_as_hard", lineAsHard)
  ]

-- | By how many per cent more patches are answered by soft decoding at as many wrong answers, of
-- the same readings.
moreAnswers :: Line -> Maybe Double
moreAnswers l = case lineAsHard l of
  Just soft | answered (lineHard l) > 0 -> Just (100 * (answered soft / answered (lineHard l) - 1))
  _ -> Nothing
  where
    answered rates = rateRight rates + rateWrong rates

-- | By how many standard errors the simulated right, wrong and refused differ from the exact ones.
deviations :: Line -> Maybe [Double]
deviations l =
  ( \exact ->
      [deviation (rate (lineHard l)) (rate exact) | rate <- [rateRight, rateWrong, rateRefused]]
  )
    <$> lineExact l
  where
    deviation found p
      | found == p || spread <= 0 = 0
      | otherwise = (found - p) / spread
      where
        spread = sqrt (p * (1 - p) / fromIntegral (lineTrials l))

-- | A table and what it was made with.
data RatesReport = RatesReport
  { ratesProfile :: Profile,
    -- | a line
    ratesTrials :: Int,
    ratesSeed :: Int,
    ratesRadius :: Radius,
    ratesLines :: [Line]
  }

-- | The table on one line, without its end.
encodeRates :: RatesReport -> ByteString
encodeRates report =
  encodeSchema "rates/1" $
    "profile" .= profileValue (ratesProfile report)
      <> "trials" .= ratesTrials report
      <> "seed" .= ratesSeed report
      <> "radius" .= stated
      <> "rates" .= map lineValue (ratesLines report)
  where
    stated = case ratesRadius report of
      Guaranteed -> Nothing
      UpTo e -> Just (naturalValue e)

-- | The names of the columns that 'lineCsv' fills.
csvHeading :: String
csvHeading =
  intercalate
    ","
    ( ["size", "errors_percent", "erasures_percent"]
        ++ [way ++ "_" ++ what | (way, _) <- ways, what <- outcomes]
        ++ ["soft_as_hard_more_percent"]
        ++ ["hard_standard_errors_" ++ what | what <- outcomes]
        ++ ["soft_999_answers", "soft_999_wrong_expected", "soft_999_wrong_counted"]
    )

outcomes :: [String]
outcomes = ["right", "wrong", "refused"]

-- | A line of a table of rates, as comma-separated values.
lineCsv :: Line -> String
lineCsv l =
  intercalate
    ","
    ( [shapeText (lineSize l), show (lineErrors l), show (lineErasures l)]
        ++ concat
          [ maybe ["", "", ""] (\(Rates a b c) -> map show [a, b, c]) (rates l)
            | (_, rates) <- ways
          ]
        ++ [maybe "" show (moreAnswers l)]
        ++ maybe ["", "", ""] (map show) (deviations l)
        ++ [show answers, show expected, show wrong]
    )
  where
    Calibration answers expected wrong = lineCalibration l

lineValue :: Line -> Value
lineValue l =
  object
    [ "size" .= shapeText (lineSize l),
      "errors_percent" .= lineErrors l,
      "erasures_percent" .= lineErasures l,
      "by" .= object [fromString way .= fmap ratesValue (rates l) | (way, rates) <- ways],
      "soft_as_hard_more_percent" .= moreAnswers l,
      "hard_standard_errors"
        .= fmap (object . zipWith (\name x -> fromString name .= x) outcomes) (deviations l),
      "soft_999_calibration"
        .= object ["answers" .= answers, "wrong_expected" .= expected, "wrong_counted" .= wrong]
    ]
  where
    ratesValue (Rates a b c) = object ["right" .= a, "wrong" .= b, "refused" .= c]
    Calibration answers expected wrong = lineCalibration l

-- | What came of simulated presses, and how they were made.
data EvaluationReport = EvaluationReport
  { evaluationProfile :: Profile,
    evaluationPresses :: Int,
    evaluationSeed :: Int,
    -- | standard deviation, taxels
    evaluationPositionError :: Double,
    -- | standard deviation, of full scale
    evaluationNoise :: Double,
    -- | what was chosen beyond that, where it was
    evaluationConditions :: EvaluationConditions,
    evaluationStitched :: Tally,
    evaluationUnstitched :: Tally,
    -- | of right answers with stitching
    evaluationPose :: Maybe PoseTally
  }

-- | How presses were made beyond the usual.
data EvaluationConditions = EvaluationConditions
  { -- | the preset or the file
    conditionSensor :: Maybe String,
    -- | standard deviation, degrees
    conditionRotationError :: Maybe Double,
    -- | standard deviation of each of the sensor's two tilts, degrees, where it was stated
    conditionTilt :: Maybe Double,
    conditionTurns :: Turns,
    conditionBend :: Maybe Bend,
    -- | the share of foreign presses
    conditionForeign :: Maybe Double,
    -- | of all presses, the share of those on other arrays
    conditionForeignArrays :: Maybe Double,
    -- | whether decoders had to find the position error
    conditionUntold :: Bool
  }

-- | The counts on one line, without its end.
encodeEvaluation :: EvaluationReport -> ByteString
encodeEvaluation report =
  encodeSchema "evaluate/1" $
    "profile" .= profileValue (evaluationProfile report)
      <> "presses" .= evaluationPresses report
      <> "seed" .= evaluationSeed report
      <> "position_error_taxels" .= evaluationPositionError report
      <> "noise" .= evaluationNoise report
      <> foldMap ("sensor" .=) (conditionSensor chosen)
      <> foldMap ("rotation_error_deg" .=) (conditionRotationError chosen)
      <> foldMap ("tilt_deg" .=) (conditionTilt chosen)
      <> foldMap ("any_angle" .=) (if conditionTurns chosen == AnyAngle then Just True else Nothing)
      <> foldMap ("turn_deg" .=) (case conditionTurns chosen of TurnedBy t -> Just t; _ -> Nothing)
      <> foldMap (("bend" .=) . writeValue bendCodec) (conditionBend chosen)
      <> foldMap ("foreign" .=) (conditionForeign chosen)
      <> foldMap ("foreign_arrays" .=) (conditionForeignArrays chosen)
      <> foldMap ("untold" .=) (if conditionUntold chosen then Just True else Nothing)
      <> "stitching" .= tallyValue (evaluationStitched report)
      <> "no_stitching" .= tallyValue (evaluationUnstitched report)
      <> "pose" .= fmap poseValue (evaluationPose report)
  where
    chosen = evaluationConditions report

poseValue :: PoseTally -> Value
poseValue counted =
  object
    [ "median_mm" .= poseMedianFar counted,
      "median_deg" .= poseMedianTurned counted,
      "within_50" .= poseWithin50 counted,
      "within_95" .= poseWithin95 counted
    ]

tallyValue :: Tally -> Value
tallyValue counted =
  object
    [ "right" .= tallyRight counted,
      "wrong" .= tallyWrong counted,
      "wrong_expected" .= tallyExpected counted,
      "refused" .= sum (tallyRefused counted),
      "reasons"
        .= object [fromString reason .= n | (reason, n) <- Map.toAscList (tallyRefused counted)]
    ]
