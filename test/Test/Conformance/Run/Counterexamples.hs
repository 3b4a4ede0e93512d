{-# LANGUAGE OverloadedStrings #-}

-- | Tests what the runner reports of laws that fail or are errored: what was asked, what came, and
-- why it is no answer.
module Test.Conformance.Run.Counterexamples (spec) where

import Control.Monad (forM_)
import Data.Aeson (Value (..), toJSON)
import Data.IORef
import PraTactile.Conformance.Process.Reply (profileRequest, runRequest)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Subject
import Test.Conformance.Run.SmallSuite
import Test.Hspec

spec :: Spec
spec = do
  it "for each failure to answer, the report says if the law failed or erred, what came, and why" $
    forM_ noAnswers $ \(came, outcome, got, why) -> do
      report <- tried "field/sums" (answeringAt came)
      [law] <- pure (reportLaws report)
      (came, lawReportOutcome law) `shouldBe` (came, outcome)
      Just shown <- pure (lawReportCounterexample law)
      (counterGot shown, counterReason shown) `shouldBe` (got, why)
      counterRoad shown `shouldBe` "the definition"
      counterExpected shown `shouldBe` Just (ResponseResult (toJSON (0 :: Int)))
      -- 1 + 2 is the second question of the second case.
      counterRequests shown
        `shouldBe` [ runRequest 1 (SomeQuestion (Add :? (0, 2))),
                     runRequest 2 (SomeQuestion (Add :? (1, 2)))
                   ]
      (lawReportCases law, lawReportExhaustive law, counterShrinks shown) `shouldBe` (2, True, 0)
      fmap readToken (counterToken shown)
        `shouldBe` Just (Just (Token "field/sums" (Just one) (toJSON (2 :: Int))))
  it "for a wrong answer, the report has all that was asked and what should have come" $ do
    report <- tried "field/sums" (answeringAt (result 7))
    [law] <- pure (reportLaws report)
    lawReportOutcome law `shouldBe` Failed
    Just shown <- pure (lawReportCounterexample law)
    counterRequests shown
      `shouldBe` [ runRequest 1 (SomeQuestion (Add :? (0, 2))),
                   runRequest 2 (SomeQuestion (Add :? (1, 2)))
                 ]
    (counterGot shown, counterExpected shown)
      `shouldBe` (result 7, Just (ResponseResult (toJSON (0 :: Int))))
    (counterRoad shown, counterReason shown) `shouldBe` ("a road", "a reason")
  it "a profile that cannot be put in force is requested once, and all its laws are errored" $
    forM_ (Left gone : map Right [ResponseRefused "no", ResponseResult (Bool False)]) $ \came -> do
      asked <- newIORef []
      let base = answering allZero
      report <-
        runSuite
          everything
          suite
          (const (pure ()))
          [ base
              { subjectProfile = \profile -> do
                  modifyIORef asked (profile :)
                  pure (if profile == two then came else yes)
              }
          ]
      profiles <- readIORef asked
      -- The law of profiles opens one; then each profile is opened once.
      reverse profiles `shouldBe` [two, one, two]
      let under = [law | law <- reportLaws report, lawReportProfile law == Just "two"]
          shown = [c | law <- under, Just c <- [lawReportCounterexample law]]
      map (\law -> (lawReportId law, lawReportOutcome law)) under
        `shouldBe` [("field/sums", Errored), ("sequence/terms", Errored)]
      map counterRequests shown `shouldBe` replicate 2 [profileRequest two]
      map counterGot shown `shouldBe` replicate 2 came
      map counterExpected shown `shouldBe` replicate 2 (Just (ResponseResult (Bool True)))
      map counterToken shown `shouldBe` replicate 2 Nothing
  it "a law of profiles reports the profile it requested, and after a fault expects nothing" $ do
    let base = answering allZero
    report <- tried "profile/opens" base {subjectProfile = \_ -> pure (Left gone)}
    [law] <- pure (reportLaws report)
    Just shown <- pure (lawReportCounterexample law)
    (counterRequests shown, counterExpected shown) `shouldBe` ([profileRequest two], Nothing)
    (lawReportOutcome law, lawReportProfile law) `shouldBe` (Errored, Nothing)
  it "a law without cases is skipped, with the reason" $ do
    report <- tried "sequence/terms" (answering allZero)
    [law] <- pure (reportLaws report)
    (lawReportOutcome law, lawReportNote law, lawReportCases law, lawReportExhaustive law)
      `shouldBe` (Skipped, Just "no case under this profile", 0, True)
  where
    tried name subject =
      runSuite
        everything {settingRun = [name]}
        suite {suiteProfiles = [("one", one)]}
        (const (pure ()))
        [subject]
    answeringAt came =
      answering (\asked -> if asked `is` (Add :? (1, 2)) then came else allZero asked)
    gone = Fault Crashed "gone"
    yes = Right (ResponseResult (Bool True))
    noAnswers =
      [ ( Left fault,
          if wrong then Failed else Errored,
          Left fault,
          if wrong then otherType else late
        )
        | kind <- [minBound ..],
          let fault = Fault kind "detail",
          let wrong = kind == WrongType
      ]
        ++ [ ( Right (ResponseSkipped "s"),
               Failed,
               Right (ResponseSkipped "s"),
               "what is offered is answered or refused, not skipped"
             ),
             ( Right (ResponseErrored "e"),
               Errored,
               Right (ResponseErrored "e"),
               "an error of the subject is no answer"
             ),
             ( Right (ResponseResult (String "x")),
               Failed,
               Left (Fault WrongType "a result of another type: \"x\""),
               otherType
             )
           ]
    otherType = "the result has another type"
    late = "a request has one reply, within the time limit"
