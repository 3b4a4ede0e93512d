{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | Tests an implementation in this process: which profile is in force, which operations it does
-- not offer, and how laws of profiles judge it.
module Test.Conformance.InProcess (spec) where

import Control.Monad (forM, forM_)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Trans.Except (runExceptT)
import Data.Aeson (Value (..), toJSON)
import Data.Functor.Identity (runIdentity)
import Data.IORef
import Data.List (isInfixOf)
import PraTactile.Conformance
import PraTactile.Conformance.Ask (answerAll)
import PraTactile.Conformance.Definition
import PraTactile.Conformance.InProcess (inProcess)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Run (Suite (..))
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Suite (noSuiteText, standardSuite)
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Profile (Profile (..))
import Test.Hspec

spec :: Spec
spec = do
  it "an implementation of nothing refuses valid inputs as not-offered, and others as invalid" $ do
    map (operationIn . exampleOf) allOperations `shouldBe` allOperations
    forM_ (map exampleOf allOperations) $ \(SomeQuestion question) -> do
      let session = answering (const notOffered)
          operation = operationOf question
          ofFrames = operation `notElem` codeOperations ++ definedOperations
          says wire = either refusalReason (const "answered") <$> runExceptT wire
      says (answerTo session question) `shouldReturn` "not-offered"
      says (answerTo session (Raw operation (questionInput question)))
        `shouldReturn` "not-offered"
      says (answerTo session (Raw operation Null)) `shouldReturn` "invalid"
      Right about <- pure (known possible)
      (operation, either refusalReason (const "") (expected about question) == "not-offered")
        `shouldBe` (operation, ofFrames)
  it "a profile stays in force in this process until another is requested; touch needs none" $ do
    opened <- newIORef []
    subject <-
      inProcess
        library
          { implementationName = "mine",
            offered = [SomeOp Term, SomeOp Add],
            open = \p -> liftIO (modifyIORef opened (p :)) >> open library p
          }
    (subjectName subject, subjectOffers subject, subjectBatch subject)
      `shouldBe` ("mine", [SomeOp Term, SomeOp Add], 64)
    (subjectUnknown subject, length (subjectChecks subject)) `shouldBe` ([], 0)
    let sum' = subjectAsk subject [SomeQuestion (Add :? (1, 1)), SomeQuestion (Add :? (1, 0))]
        -- Written twice, because GHC 9.0.2 makes a different text of one that replicate repeats.
        none = map (Right . ResponseErrored) ["no profile is in force", "no profile is in force"]
        sums = map (Right . ResponseResult . toJSON) [0, 1 :: Int]
        blank = replicate 4 (replicate 4 0)
    sum' `shouldReturn` none
    subjectAsk subject [SomeQuestion (Segment :? blank)]
      `shouldReturn` [Right (ResponseResult (answerValue (Segment :? blank) []))]
    subjectProfile subject possible `shouldReturn` Right (ResponseResult (Bool True))
    sum' `shouldReturn` sums
    subjectProfile subject impossible `shouldReturn` Right (ResponseRefused "impossible-profile")
    sum' `shouldReturn` none
    reverse <$> readIORef opened `shouldReturn` [possible, impossible]
  it "answers and reasons are evaluated in full in this process; an exception ends the batch" $ do
    let session = answering $ \question -> case question of
          Terms :? (_, count) -> pure (if count == 2 then [1, error "no such term"] else [count])
          Term :? i -> refuse (if i == 2 then "be" ++ error "no such reason" else "because")
          _ -> notOffered
    subject <- inProcess library {open = const (pure session)}
    _ <- subjectProfile subject possible
    let came questions = do
          replies <- subjectAsk subject questions
          pure (map (either (Left . crash) Right) replies)
        crash fault =
          (faultKind fault, filter (`isInfixOf` faultDetail fault) said)
        said = ["no such term", "no such reason"]
        three = Right (ResponseResult (toJSON [3 :: Int]))
    came [SomeQuestion (Terms :? (0, count)) | count <- [3, 2, 3]]
      `shouldReturn` [three, Left (Crashed, ["no such term"])]
    came [SomeQuestion (Term :? 1), SomeQuestion (Term :? 2), SomeQuestion (Terms :? (0, 3))]
      `shouldReturn` [Right (ResponseRefused "because"), Left (Crashed, ["no such reason"])]
    came [SomeQuestion (Terms :? (0, 3)), SomeQuestion (Term :? 1)]
      `shouldReturn` [three, Right (ResponseRefused "because")]
  it "laws of profiles hold if possible profiles open and others are refused as impossible" $ do
    -- One of these laws asks questions as well.
    let openings = filter ((/= "profile/profiles-return") . lawId) openingLaws
    verdicts <- forM openings $ \one -> case lawCases one (map snd defaultProfiles) of
      Cases form (Every cases) trial ->
        pure [(lawId one, writeValue form case', trial case') | case' <- cases]
      Cases _ (Some _ _) _ -> fail (lawId one ++ " draws")
    forM_ (concat verdicts) $ \(name, profile', trial) -> do
      let opens =
            name
              `elem` ["profile/possible-ones-are-opened", "profile/polynomial-may-end-in-zeros"]
          right' = if opens then Right () else refusedFor "impossible-profile"
      forM_ [Right (), refusedFor "impossible-profile", refusedFor "invalid"] $ \came -> do
        let verdict = runIdentity (answerAll (const (pure came)) (const (pure noAnswer)) trial)
            told = case verdict of
              Violated violation -> Just (violationAsked violation, violationExpected violation)
              _ -> Nothing
        (name, told)
          `shouldBe` ( name,
                       if came == right'
                         then Nothing
                         else Just ([Exchange Nothing profile' (reply came)], reply right')
                     )
        (came == right', verdict == Holds) `shouldBe` (verdict == Holds, came == right')
  it "a suite needs profiles that describe arrays, and names the first that does not" $ do
    let under = [("one", possible), ("two", other)]
        failure = either Just (const Nothing)
    failure (standardSuite (under ++ [("three", impossible), ("four", impossible)]))
      `shouldBe` Just ("three", NoArray)
    suite <- either (fail . noSuiteText) pure (standardSuite under)
    suiteProfiles suite `shouldBe` under
    map (fmap knownProfile . suiteAbout suite) [possible, other, third, impossible]
      `shouldBe` [Just possible, Just other, Just third, Nothing]
    map lawId (suiteLaws suite) `shouldBe` map lawId laws
    map lawId (suiteOpenings suite) `shouldBe` map lawId openingLaws
    map lawId (suiteWithoutProfile suite) `shouldBe` map lawId lawsWithoutProfile
    Just about <- pure (suiteAbout suite possible)
    map (suiteAnswer suite about) [SomeQuestion (Add :? (1, 1)), SomeQuestion (Inverse :? 0)]
      `shouldBe` [Result (toJSON (0 :: Int)), RefusedFor "division-by-zero"]
  where
    operationIn (SomeQuestion question) = operationOf question
    named name = head [p | (name', p) <- defaultProfiles, name' == name]
    possible = named "gf2-3x5"
    other = named "gf3-2x13"
    third = named "gf5-4x31"
    impossible = possible {profileOrder = 6}
    refusedFor = Left . Refusal
    noAnswer :: Either Refusal b
    noAnswer = refusedFor "not-offered"
    reply = either (RefusedFor . refusalReason) (const (Result (Bool True)))
