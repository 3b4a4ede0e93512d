{-# LANGUAGE OverloadedStrings #-}

-- | A suite for trying the runner, and subjects that answer as instructed.
module Test.Conformance.Run.SmallSuite
  ( -- * The suite
    suite,
    made,
    sums,
    one,
    two,
    other,
    impossible,
    everything,
    codeAndTouch,

    -- * Subjects
    answering,
    allZero,
    result,
    is,
    checked,
  )
where

import Data.Aeson (Value (..), toJSON)
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..))
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations (operationOf, questionInput)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Run
import PraTactile.Conformance.Subject
import PraTactile.Format.Json.Codec (natural)
import PraTactile.Format.Profile (profileCodec)
import PraTactile.Profile

-- | Laws of profiles, of the code and of touch: one of each, and one of the code that never
-- applies.
suite :: Suite Profile
suite =
  Suite
    { suiteProfiles = [("one", one), ("impossible", impossible), ("two", two)],
      suiteAbout = \p -> if p == impossible then Nothing else Just p,
      suiteLaws =
        [ made ("field/sums", OnField, [SomeOp Add]) (Cases natural (Every [0, 2]) sums),
          made
            ("sequence/terms", OnSequence, [SomeOp Term, SomeOp Terms])
            (Cases natural (Every [7]) (const (pure Inapplicable)))
        ],
      suiteOpenings =
        [made ("profile/opens", OnProfile, []) (Cases profileCodec (Every [two]) opens)],
      suiteWithoutProfile =
        [ made
            ("segment/none", OnSegment, [SomeOp Segment])
            (Cases natural (Some (pure 0) (const [])) (const (pure Holds)))
        ],
      suiteAnswer = \_ _ -> Result (toJSON (0 :: Int))
    }
  where
    opens p = either (const Inapplicable) (const Holds) <$> opening p

made :: (String, Stage, [SomeOp]) -> Cases -> Law about
made (name, stage, needs) cases = Law name stage needs "sentence" "source" (const cases)

-- | Two sums for one number; both must be 0.
sums :: Natural -> Ask Verdict
sums n = do
  first <- ask (Add :? (0, n))
  second <- ask (Add :? (1, n))
  pure $
    if [first, second] == replicate 2 (Right 0)
      then Holds
      else
        Violated
          ( Violation
              [exchange (Add :? (0, n)) first, exchange (Add :? (1, n)) second]
              (Result (toJSON (0 :: Int)))
              "a road"
              "a reason"
          )
  where
    exchange question came =
      Exchange
        (Just (SomeOp Add))
        (questionInput question)
        (either (RefusedFor . refusalReason) (Result . toJSON) came)

one, two, other, impossible :: Profile
one = canonicalProfile
two = canonicalProfile {profileShape = Shape 3 85}
other = canonicalProfile {profileShape = Shape 5 51}
impossible = canonicalProfile {profileOrder = 6}

codeAndTouch :: [SomeOp]
codeAndTouch = [SomeOp Terms, SomeOp Add, SomeOp Segment, SomeOp Term]

everything :: Settings
everything = standardSettings {settingStages = codeStages ++ touchStages, settingCases = 20}

-- | A subject that gives these answers.
answering :: (SomeQuestion -> Either Fault Response) -> Subject
answering reply =
  Subject
    { subjectName = "made",
      subjectOffers = codeAndTouch,
      subjectProfile = \_ -> pure (Right (ResponseResult (Bool True))),
      subjectAsk = upToFault . map (pure . reply),
      subjectFresh = Nothing,
      subjectBatch = 4,
      subjectUnknown = ["unknown"],
      subjectChecks = []
    }

-- | The answers with which all laws hold.
allZero :: SomeQuestion -> Either Fault Response
allZero _ = result 0

result :: Int -> Either Fault Response
result = Right . ResponseResult . toJSON

is :: SomeQuestion -> Question a -> Bool
is (SomeQuestion asked) question =
  (operationOf asked, questionInput asked) == (operationOf question, questionInput question)

checked :: String -> Checked -> Check
checked name = Check name ("sentence of " ++ name) . pure
