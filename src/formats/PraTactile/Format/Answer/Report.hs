-- | Converts the library's answers to the JSON of @locate@.
module PraTactile.Format.Answer.Report
  ( AnswerContext (..),
    answerReport,
    invalidReport,
  )
where

import Data.List (nub, sort)
import PraTactile.Format.Answer
import PraTactile.Format.Outcome
import PraTactile.Locate
import PraTactile.Profile (Profile)
import PraTactile.Symmetry

-- | The question's context and the wording of the answer.
data AnswerContext = AnswerContext
  { answerProfile :: Profile,
    -- | the allowed orientations of the patches
    answerSymmetries :: [Symmetry],
    -- | the displacements of the patches, if they were given
    answerDisplacements :: Maybe [(Integer, Integer)],
    -- | the answer in a sentence
    answerMessage :: String,
    -- | the explanation in sentences, if requested
    answerExplanation :: Maybe [String]
  }

-- | The report of an answer.
answerReport :: AnswerContext -> Answer -> AnswerReport
answerReport context answer = case answerOutcome answer of
  Unique candidate windows ->
    report {statedPosition = Just (candidatePosition candidate), statedWindows = windows}
  Ambiguous candidates windows ->
    report
      { statedOutcome = SeveralFit,
        statedPositions = nub (sort (map candidatePosition candidates)),
        statedWindows = if windowsCertain then windows else []
      }
  AmbiguousMany _ _ -> report {statedOutcome = SeveralFit}
  Refused reason -> report {statedOutcome = NoAnswer, statedReason = Just (reasonName reason)}
  where
    report =
      (reportOf Located (answerProfile context) (answerMessage context))
        { statedChance = answerChance answer,
          statedEvidence = Just (evidenceOf context answer)
        }
    -- If the orientation is unknown, or cells are in dispute, complete windows mean nothing.
    windowsCertain =
      isUpright context
        && (answerDisplacements context == Nothing || answerDecoder answer /= NearestDecoder)

-- | The report for an input that is not a patch, with the reason.
invalidReport :: Profile -> String -> AnswerReport
invalidReport profile complaint =
  (reportOf Invalid profile complaint) {statedReason = Just "bad-input"}

-- | A report with only an outcome, a profile and a message.
reportOf :: OutcomeName -> Profile -> String -> AnswerReport
reportOf outcome profile message =
  AnswerReport
    { statedProfile = profile,
      statedOutcome = outcome,
      statedPosition = Nothing,
      statedPositions = [],
      statedReason = Nothing,
      statedMessage = message,
      statedWindows = [],
      statedChance = Nothing,
      statedEvidence = Nothing
    }

isUpright :: AnswerContext -> Bool
isUpright context = answerSymmetries context == [identity]

evidenceOf :: AnswerContext -> Answer -> Evidence
evidenceOf context answer =
  Evidence
    { evidenceDecoder = answerDecoder answer,
      evidenceCount = count,
      evidenceDimension = dimension,
      evidenceDistances = answerDistances answer >>= distanceReport (answerDecoder answer),
      evidencePosterior = posteriorReport candidateReport <$> answerPosterior answer,
      evidenceDoubts = answerDoubts answer,
      evidenceChecks = answerChecks answer,
      evidenceOrientation = if isUpright context then Nothing else Just orientation,
      evidencePatches = (,) <$> patches <*> pure (answerDisputed answer),
      evidenceExplanation = answerExplanation context
    }
  where
    (count, dimension, candidates) = case answerOutcome answer of
      Unique candidate _ -> (1, Nothing, [candidate])
      Ambiguous several _ -> (fromIntegral (length several), Nothing, several)
      AmbiguousMany many coset -> (many, coset, [])
      Refused _ -> (0, Nothing, [])
    orientation = case candidates of
      [Candidate o _] -> OrientationReport (Just o) []
      several -> OrientationReport Nothing (map candidateReport several)
    candidateReport (Candidate o place) =
      CandidateReport place (if isUpright context then Nothing else Just o)
    patches = zipWith patchReport (answerPatches answer) <$> answerDisplacements context
    patchReport verdict at = PatchReport at (patchWrong verdict) (patchInconsistent verdict)

-- | The distances, or 'Nothing' for a decoder that does not correct.
distanceReport :: DecoderName -> Distances -> Maybe DistanceReport
distanceReport decoder distances = case decoder of
  NearestDecoder -> Just report
  InformationSetDecoder ->
    Just
      report
        { statedRunnerUpBound = Just (atLeast <$> runnerUpDistance distances),
          statedMinimumExact = Just (exactly (codeDistance distances) /= Nothing)
        }
  _ -> Nothing
  where
    report =
      DistanceReport
        { statedCorrected = corrected distances,
          statedNearest = nearestDistance distances >>= exactly,
          statedRunnerUp = runnerUpDistance distances >>= exactly,
          statedRunnerUpBound = Nothing,
          statedMinimumDistance = atLeast (codeDistance distances),
          statedMinimumExact = Nothing,
          statedRadius = correctionRadius distances
        }
    exactly known = case known of
      Exactly n -> Just n
      AtLeast _ -> Nothing

posteriorReport :: (Candidate -> CandidateReport) -> Posterior Candidate -> PosteriorReport
posteriorReport candidateReport found =
  PosteriorReport
    { statedDoubt = posteriorDoubt found,
      statedLikeliest =
        [(candidateReport candidate, p) | (candidate, p) <- take 5 (posteriorRanking found)],
      statedUnlisted = posteriorUnlisted found
    }
