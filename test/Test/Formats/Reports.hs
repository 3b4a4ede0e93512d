-- | Tests the JSON of @locate@ on answers made by hand: every outcome and every decoder, one patch
-- or several, in one orientation or several.
module Test.Formats.Reports (spec) where

import Control.Monad (forM_)
import PraTactile.Format.Answer
import PraTactile.Format.Answer.Report
import PraTactile.Format.Outcome
import PraTactile.Locate
import PraTactile.Locate.Answer (impossible)
import PraTactile.Position
import PraTactile.Profile (canonicalProfile)
import PraTactile.Symmetry
import Test.Hspec hiding (context)

spec :: Spec
spec = do
  it "a single place is reported with the windows that give it" $
    everywhere $ \context answer -> do
      let report = answerReport context answer {answerOutcome = Unique (one identity) windows}
      (statedOutcome report, statedPosition report, statedPositions report, statedReason report)
        `shouldBe` (Located, Just (Position 3 4), [], Nothing)
      statedWindows report `shouldBe` windows
      (evidenceCount <$> statedEvidence report, statedEvidence report >>= evidenceDimension)
        `shouldBe` (Just 1, Nothing)
  it "several places are reported once each and in order, with windows only if these add to them" $
    everywhere $ \context answer -> do
      let candidates =
            [Candidate o p | o <- [identity, turned 1], p <- [Position 3 4, Position 1 2]]
          report = answerReport context answer {answerOutcome = Ambiguous candidates windows}
          upright = answerSymmetries context == [identity]
          alone = answerDisplacements context == Nothing
      (statedOutcome report, statedPosition report, statedPositions report, statedReason report)
        `shouldBe` (SeveralFit, Nothing, [Position 1 2, Position 3 4], Nothing)
      statedWindows report
        `shouldBe` [w | w <- windows, upright, alone || answerDecoder answer /= NearestDecoder]
      evidenceCount <$> statedEvidence report `shouldBe` Just 4
  it "too many places are reported by number and dimension, and no place by its reason" $
    everywhere $ \context answer -> do
      forM_ [Nothing, Just 5] $ \dimension -> do
        let many = answerReport context answer {answerOutcome = AmbiguousMany 99 dimension}
        (statedOutcome many, statedPosition many, statedPositions many, statedWindows many)
          `shouldBe` (SeveralFit, Nothing, [], [])
        (evidenceCount <$> statedEvidence many, statedEvidence many >>= evidenceDimension)
          `shouldBe` (Just 99, dimension)
      forM_ reasons $ \reason -> do
        let none = answerReport context answer {answerOutcome = Refused reason}
        (statedOutcome none, statedReason none, statedPositions none, statedWindows none)
          `shouldBe` (NoAnswer, Just (reasonName reason), [], [])
        evidenceCount <$> statedEvidence none `shouldBe` Just 0
  it "an orientation is reported if several were asked for: one candidate's, or each candidate's" $
    everywhere $ \context answer -> do
      let told outcome =
            statedEvidence (answerReport context answer {answerOutcome = outcome})
              >>= evidenceOrientation
          asked found = if answerSymmetries context == [identity] then Nothing else Just found
          seen = map (\o -> CandidateReport (Position 3 4) (Just o))
      told (Unique (one (turned 1)) []) `shouldBe` asked (OrientationReport (Just (turned 1)) [])
      told (Ambiguous (map one [turned 1, mirror]) [])
        `shouldBe` asked (OrientationReport Nothing (seen [turned 1, mirror]))
      told (Refused ZeroWindow) `shouldBe` asked (OrientationReport Nothing [])
  it "patches are reported with their displacements, if any displacement was given" $
    everywhere $ \context answer -> do
      let verdicts = [PatchVerdict (Position 0 i) (Just (fromIntegral i)) (i == 1) | i <- [0 .. 2]]
          told =
            statedEvidence
              (answerReport context answer {answerPatches = verdicts, answerDisputed = windows})
              >>= evidencePatches
      told
        `shouldBe` fmap
          (\by -> (zipWith (\at i -> PatchReport at (Just i) (i == 1)) by [0 ..], windows))
          (answerDisplacements context)
  it "decoders that correct report distances; one that searches reports what it proved" $
    forM_
      [ (near, next, least)
        | near <- Nothing : known,
          next <- Nothing : known,
          Just least <- known
      ]
      $ \(near, next, least) -> everywhere $ \context answer -> do
        let distances = Distances windows near next least 2
            told = statedEvidence (answerReport context answer {answerDistances = Just distances})
            exactly given = case given of
              Just (Exactly n) -> Just n
              _ -> Nothing
            bound = fmap (\given -> case given of Exactly n -> n; AtLeast n -> n)
            plain =
              DistanceReport
                { statedCorrected = windows,
                  statedNearest = exactly near,
                  statedRunnerUp = exactly next,
                  statedRunnerUpBound = Nothing,
                  statedMinimumDistance = atLeast least,
                  statedMinimumExact = Nothing,
                  statedRadius = 2
                }
        (told >>= evidenceDistances) `shouldBe` case answerDecoder answer of
          NearestDecoder -> Just plain
          InformationSetDecoder ->
            Just
              plain
                { statedRunnerUpBound = Just (bound next),
                  statedMinimumExact = Just (exactly (Just least) /= Nothing)
                }
          _ -> Nothing
  it "at most the five likeliest candidates are reported" $
    everywhere $ \context answer ->
      forM_ [0, 1, 4, 5, 6, 9] $ \count -> do
        let ranking =
              [ (Candidate (turned 1) (Position i 0), 1 / fromIntegral (i + 1))
                | i <- take count [0 ..]
              ]
            posterior =
              impossible
                { posteriorRanking = ranking,
                  posteriorDoubt = 0.25,
                  posteriorUnlisted = Just 0.5
                }
            told = statedEvidence (answerReport context answer {answerPosterior = Just posterior})
            seen = if answerSymmetries context == [identity] then Nothing else Just (turned 1)
        (told >>= evidencePosterior)
          `shouldBe` Just
            ( PosteriorReport
                0.25
                [(CandidateReport (candidatePosition c) seen, p) | (c, p) <- take 5 ranking]
                (Just 0.5)
            )
  it "an invalid patch is reported with its reason and nothing else" $ do
    let report = invalidReport canonicalProfile "complaint"
    (statedOutcome report, statedReason report, statedMessage report, statedEvidence report)
      `shouldBe` (Invalid, Just "bad-input", "complaint", Nothing)
    (statedPosition report, statedPositions report, statedWindows report)
      `shouldBe` (Nothing, [], [])
  where
    one o = Candidate o (Position 3 4)
    windows = [Position 0 0, Position 0 1]
    known = [Just (Exactly 3), Just (AtLeast 3), Just (Exactly 0), Just (AtLeast 7)]

-- | Holds for every decoder and context.
everywhere :: (AnswerContext -> Answer -> Expectation) -> Expectation
everywhere use =
  forM_ [[identity], [turned 1], rotations] $ \possible ->
    forM_ [Nothing, Just [(0, 0), (1, -2), (0, 5)]] $ \displacements ->
      forM_ [minBound ..] $ \decoder ->
        use
          (AnswerContext canonicalProfile possible displacements "message" Nothing)
          (refusedBy decoder)
  where
    refusedBy decoder =
      Answer (Refused ZeroWindow) decoder Nothing Nothing Nothing Nothing Nothing Nothing [] []
