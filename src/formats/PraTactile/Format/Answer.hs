{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of what @locate@ answers; "PraTactile.Format.Answer.Report" makes it of an answer.
module PraTactile.Format.Answer
  ( AnswerReport (..),
    Basis (..),
    DistanceReport (..),
    PosteriorReport (..),
    OrientationReport (..),
    CandidateReport (..),
    PatchReport (..),
    encodeAnswer,
    decodeAnswer,
  )
where

import Data.ByteString (ByteString)
import Numeric.Natural (Natural)
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec
import PraTactile.Format.Outcome
import PraTactile.Format.Profile
import PraTactile.Locate
import PraTactile.Position
import PraTactile.Profile (Profile)
import PraTactile.Symmetry

-- | An answer of @locate@: its keys, of which docs/explanation/locating.md says what they mean.
data AnswerReport = AnswerReport
  { statedProfile :: Profile,
    statedOutcome :: OutcomeName,
    statedPosition :: Maybe Position,
    statedPositions :: [Position],
    statedReason :: Maybe String,
    statedMessage :: String,
    statedWindows :: [Position],
    statedChance :: Maybe Chance,
    -- | 'Nothing' where what was given is no patch
    statedBasis :: Maybe Basis
  }
  deriving stock (Eq, Show)

-- | What an answer rests on.
data Basis = Basis
  { basisDecoder :: DecoderName,
    -- | how many candidates; each position counts in each orientation
    basisCount :: Natural,
    basisDimension :: Maybe Natural,
    basisDistances :: Maybe DistanceReport,
    basisPosterior :: Maybe PosteriorReport,
    -- | where the question weighs that it may be foreign
    basisDoubts :: Maybe PlaceDoubts,
    basisChecks :: Maybe Checks,
    -- | where patches may be seen in several orientations
    basisOrientation :: Maybe OrientationReport,
    -- | where patches were given with displacements
    basisPatches :: Maybe ([PatchReport], [Position]),
    basisExplanation :: Maybe [String]
  }
  deriving stock (Eq, Show)

-- | In how many cells candidates differ.
data DistanceReport = DistanceReport
  { statedCorrected :: [Position],
    statedNearest :: Maybe Natural,
    statedRunnerUp :: Maybe Natural,
    -- | where not all positions were compared: a bound, if there is one, and whether the minimum
    -- distance is exact
    statedRunnerUpBound :: Maybe (Maybe Natural),
    statedMinimumDistance :: Natural,
    statedMinimumExact :: Maybe Bool,
    statedRadius :: Natural
  }
  deriving stock (Eq, Show)

-- | How likely the likeliest candidates are.
data PosteriorReport = PosteriorReport
  { statedDoubt :: Double,
    -- | with their probabilities, at most five
    statedLikeliest :: [(CandidateReport, Double)],
    -- | the probability of all others, where not all positions were compared
    statedUnlisted :: Maybe Double
  }
  deriving stock (Eq, Show)

-- | In which orientation patches are seen, or all candidates where they are several.
data OrientationReport = OrientationReport
  { statedSymmetry :: Maybe Symmetry,
    statedCandidates :: [CandidateReport]
  }
  deriving stock (Eq, Show)

-- | A candidate, with its orientation only where that was asked for.
data CandidateReport = CandidateReport
  { statedPlace :: Position,
    statedSeen :: Maybe Symmetry
  }
  deriving stock (Eq, Show)

-- | What is said of one of several patches.
data PatchReport = PatchReport
  { statedAt :: (Integer, Integer),
    statedWrong :: Maybe Int,
    statedInconsistent :: Bool
  }
  deriving stock (Eq, Show)

-- | The answer on one line, without its end.
encodeAnswer :: AnswerReport -> ByteString
encodeAnswer = writeLine reportKeys

-- | The answer in a JSON text that 'encodeAnswer' made. Refuses another schema, and keys that are
-- missing or have other values.
decodeAnswer :: ByteString -> Either FormatError AnswerReport
decodeAnswer = decodeWith reportKeys

reportKeys :: Keys AnswerReport AnswerReport
reportKeys =
  schemaKey "pra-tactile/locate/1"
    *> ( AnswerReport
           <$> key "profile" profileCodec statedProfile
           <*> key "outcome" outcomeCodec statedOutcome
           <*> key "position" (nullable position) statedPosition
           <*> key "positions" (listOf position) statedPositions
           <*> key "reason" (nullable text) statedReason
           <*> key "message" text statedMessage
           <*> key "windows" (listOf positionPair) statedWindows
           <*> withKeys statedChance chanceKeys
           <*> optionalKeys "road" basisKeys statedBasis
       )

basisKeys :: Keys Basis Basis
basisKeys =
  Basis
    <$> key "road" (named decoderText) basisDecoder
    <*> key "count" natural basisCount
    <*> optionalKey "dimension" natural basisDimension
    <*> optionalKeys "corrected" distanceKeys basisDistances
    <*> optionalKeys "doubt" posteriorKeys basisPosterior
    <*> optionalKey "doubts" doubts basisDoubts
    <*> key "checks" checksCodec basisChecks
    <*> optionalKeys "mirrored" orientationKeys basisOrientation
    <*> optionalKeys "patches" patchKeys basisPatches
    <*> optionalKey "explanation" (listOf text) basisExplanation
  where
    doubts =
      object $
        PlaceDoubts
          <$> key "position" (nullable real) doubtOfPlace
          <*> withKeys doubtsOfForeign foreignKeys
    patchKeys =
      (,) <$> key "patches" (listOf patchReport) fst <*> key "disputed" (listOf positionPair) snd
    patchReport =
      object $
        PatchReport
          <$> key "at" (pairOf integer) statedAt
          <*> key "wrong" (nullable int) statedWrong
          <*> key "inconsistent" bool statedInconsistent

distanceKeys :: Keys DistanceReport DistanceReport
distanceKeys =
  DistanceReport
    <$> key "corrected" (listOf positionPair) statedCorrected
    <*> key "nearest" (nullable natural) statedNearest
    <*> key "runner_up" (nullable natural) statedRunnerUp
    <*> optionalKey "runner_up_at_least" (nullable natural) statedRunnerUpBound
    <*> key "minimum_distance" natural statedMinimumDistance
    <*> optionalKey "minimum_distance_is" (exactOr "at-least") statedMinimumExact
    <*> key "radius" natural statedRadius

posteriorKeys :: Keys PosteriorReport PosteriorReport
posteriorKeys =
  PosteriorReport
    <$> key "doubt" real statedDoubt
    <* optionalKey "doubt_is" text (("at-most" <$) . statedUnlisted)
    <*> key "likeliest" (listOf (object likely)) statedLikeliest
    <*> optionalKey "unlisted" real statedUnlisted
  where
    likely = flip (,) <$> key "probability" real snd <*> withKeys fst candidateKeys

orientationKeys :: Keys OrientationReport OrientationReport
orientationKeys =
  (\turns flipped -> OrientationReport (symmetryOf <$> turns <*> flipped))
    <$> key "orientation_deg" (nullable quarterTurn) (fmap quarterTurns . statedSymmetry)
    <*> key "mirrored" (nullable bool) (fmap mirrored . statedSymmetry)
    <*> key "candidates" (listOf (object candidateKeys)) statedCandidates

candidateKeys :: Keys CandidateReport CandidateReport
candidateKeys =
  CandidateReport
    <$> key "position" position statedPlace
    <*> optionalKeys "mirrored" symmetryKeys statedSeen
  where
    symmetryKeys =
      symmetryOf
        <$> key "orientation_deg" quarterTurn quarterTurns
        <*> key "mirrored" bool mirrored

-- | Mirrored or not, and then turned.
symmetryOf :: Int -> Bool -> Symmetry
symmetryOf turns flipped = turned turns <> (if flipped then mirror else identity)
