{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The JSON of what @evaluate@ counts.
module PraTactile.Format.Evaluation
  ( EvaluationReport (..),
    EvaluationConditions (..),
    encodeEvaluation,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.ByteString (ByteString)
import qualified Data.Map.Strict as Map
import Data.String (fromString)
import PraTactile.Evaluate (PoseTally (..), Tally (..))
import PraTactile.Explore (Turns (..))
import PraTactile.Format.Json
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Format.Profile
import PraTactile.Format.Sensor (bendCodec)
import PraTactile.Profile (Profile)
import PraTactile.Sensor (Bend)

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
