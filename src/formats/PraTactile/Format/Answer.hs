{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of @locate@. "PraTactile.Format.Answer.Report" converts an answer to it.
module PraTactile.Format.Answer
  ( AnswerReport (..),
    Evidence (..),
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

-- | The keys of @locate@'s JSON. docs/explanation/locating.md explains them.
data AnswerReport = AnswerReport
  { statedProfile :: Profile,
    statedOutcome :: OutcomeName,
    statedPosition :: Maybe Position,
    -- | all positions, if there are several
    statedPositions :: [Position],
    -- | the stable name of a refusal's reason
    statedReason :: Maybe String,
    statedMessage :: String,
    -- | the offsets in the patch of the complete windows that agree
    statedWindows :: [Position],
    -- | the share of all contents of the observed cells that would be located as well
    statedChance :: Maybe Chance,
    -- | 'Nothing' if the input was not a patch
    statedEvidence :: Maybe Evidence
  }
  deriving stock (Eq, Show)

-- | The evidence for an answer.
data Evidence = Evidence
  { evidenceDecoder :: DecoderName,
    -- | the number of candidates; each position counts once per orientation
    evidenceCount :: Natural,
    -- | the dimension of the coset of positions, if they are too many to list
    evidenceDimension :: Maybe Natural,
    evidenceDistances :: Maybe DistanceReport,
    evidencePosterior :: Maybe PosteriorReport,
    -- | if the question has a prior probability that the patch is foreign
    evidenceDoubts :: Maybe PlaceDoubts,
    -- | the numbers of independent parity checks among the certain cells
    evidenceChecks :: Maybe Checks,
    -- | if several orientations were allowed
    evidenceOrientation :: Maybe OrientationReport,
    -- | if the patches came with displacements: each patch, and the cells that they show
    -- differently
    evidencePatches :: Maybe ([PatchReport], [Position]),
    evidenceExplanation :: Maybe [String]
  }
  deriving stock (Eq, Show)

-- | The numbers of cells in which candidates differ from the patch.
data DistanceReport = DistanceReport
  { -- | the cells that were corrected
    statedCorrected :: [Position],
    statedNearest :: Maybe Natural,
    statedRunnerUp :: Maybe Natural,
    -- | if not all positions were compared: a lower bound, where there is one
    statedRunnerUpBound :: Maybe (Maybe Natural),
    statedMinimumDistance :: Natural,
    statedMinimumExact :: Maybe Bool,
    statedRadius :: Natural
  }
  deriving stock (Eq, Show)

-- | The posterior of the most likely candidates.
data PosteriorReport = PosteriorReport
  { statedDoubt :: Double,
    -- | at most five, with their probabilities
    statedLikeliest :: [(CandidateReport, Double)],
    -- | the probability of all other positions, if not all were compared
    statedUnlisted :: Maybe Double
  }
  deriving stock (Eq, Show)

-- | The orientation of the patches, or all candidates if there are several orientations.
data OrientationReport = OrientationReport
  { statedSymmetry :: Maybe Symmetry,
    statedCandidates :: [CandidateReport]
  }
  deriving stock (Eq, Show)

-- | A candidate position, with its orientation if several were allowed.
data CandidateReport = CandidateReport
  { statedPlace :: Position,
    statedSeen :: Maybe Symmetry
  }
  deriving stock (Eq, Show)

-- | The report on one of several patches.
data PatchReport = PatchReport
  { -- | its displacement, rows and columns
    statedAt :: (Integer, Integer),
    -- | the number of its cells that contradict the answer
    statedWrong :: Maybe Int,
    -- | whether it has more wrong cells than would certainly be corrected if it were alone
    statedInconsistent :: Bool
  }
  deriving stock (Eq, Show)

-- | The answer as one line, without its line end.
encodeAnswer :: AnswerReport -> ByteString
encodeAnswer = writeLine reportKeys

-- | Reads the JSON of 'encodeAnswer'. Refuses another schema, missing keys and invalid values.
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
           <*> optionalKeys "road" evidenceKeys statedEvidence
       )

evidenceKeys :: Keys Evidence Evidence
evidenceKeys =
  Evidence
    <$> key "road" (named decoderText) evidenceDecoder
    <*> key "count" natural evidenceCount
    <*> optionalKey "dimension" natural evidenceDimension
    <*> optionalKeys "corrected" distanceKeys evidenceDistances
    <*> optionalKeys "doubt" posteriorKeys evidencePosterior
    <*> optionalKey "doubts" doubts evidenceDoubts
    <*> key "checks" checksCodec evidenceChecks
    <*> optionalKeys "mirrored" orientationKeys evidenceOrientation
    <*> optionalKeys "patches" patchKeys evidencePatches
    <*> optionalKey "explanation" (listOf text) evidenceExplanation
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

-- | The symmetry that mirrors, if the flag is set, and then turns by the given number of quarter
-- turns.
symmetryOf :: Int -> Bool -> Symmetry
symmetryOf turns flipped = turned turns <> (if flipped then mirror else identity)
