{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Tests whole runs on a suite made for them: reports, time limits and known failures; and how
-- cases are drawn, asked and made smaller.
module Test.Conformance.Run.Whole (spec) where

import Control.Concurrent (threadDelay)
import Control.Monad (forM_, forever, void)
import Data.Aeson (Value (..), toJSON)
import Data.IORef
import Data.List (nub, sort)
import Data.Maybe (mapMaybe)
import GHC.Clock (getMonotonicTime)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run
import PraTactile.Conformance.Run.Case
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Subject
import PraTactile.Format.Json.Codec (natural)
import PraTactile.Profile (Profile (..))
import Test.Conformance.Run.SmallSuite
import Test.Hspec hiding (before)
import Test.QuickCheck (chooseInteger, sized)

spec :: Spec
spec = do
  describe "a run" runSpec
  describe "cases" caseSpec

runSpec :: Spec
runSpec = do
  it "reports all that was chosen, in order, and announces each law as it is tried" $
    forM_ [1, 2, 3, 7] $ \workers -> do
      telling <- newIORef []
      start <- getMonotonicTime
      let subject = (answering allZero) {subjectChecks = [checked "protocol/a" CheckHeld]}
          settings = everything {settingSeed = 5, settingSkip = ["opens"]}
          told law = atomicModifyIORef' telling (\all' -> (law : all', ()))
      report <- runSuite settings suite told (replicate workers subject)
      let said =
            [ (lawReportId law, lawReportProfile law, lawReportOutcome law)
              | law <- reportLaws report
            ]
      said
        `shouldBe` [ ("profile/opens", Nothing, Skipped),
                     ("field/sums", Just "one", Held),
                     ("sequence/terms", Just "one", Skipped),
                     ("field/sums", Just "two", Held),
                     ("sequence/terms", Just "two", Skipped),
                     ("segment/none", Nothing, Held),
                     ("protocol/a", Nothing, Held)
                   ]
      countWork settings suite subject `shouldBe` length said
      heard <- readIORef telling
      sort (map lawReportId heard) `shouldBe` sort [name | (name, _, _) <- said]
      (reportSubject report, reportSeed report, reportPartial report) `shouldBe` ("made", 5, True)
      (reportAsks report, reportOffers report)
        `shouldBe` (codeOperations ++ operationsOf touchStages, codeAndTouch)
      (reportUnknown report, reportUnexpected report) `shouldBe` (["unknown"], [])
      end <- getMonotonicTime
      reportSeconds report `shouldSatisfy` (\seconds -> seconds > 0 && seconds <= end - start)
      map
        (\law -> (lawReportCases law, lawReportExhaustive law))
        (filter ((== Held) . lawReportOutcome) (reportLaws report))
        `shouldBe` [(2, True), (2, True), (20, False), (1, True)]
  it "asks for the operations of its stages, and counts how many of them are offered" $
    forM_
      [ ([OnSequence], codeOperations, [SomeOp Terms, SomeOp Add, SomeOp Term]),
        ([OnSegment], operationsOf touchStages, [SomeOp Segment])
      ]
      $ \(stages, asks, offers) -> do
        report <-
          runSuite everything {settingStages = stages} suite (const (pure ())) [answering allZero]
        (reportAsks report, reportOffers report) `shouldBe` (asks, offers)
  it "ends at the first failure, if that is requested" $
    forM_ [False, True] $ \failFast -> do
      let subject =
            (answering (const (result 9))) {subjectChecks = [checked "protocol/a" CheckHeld]}
      report <-
        runSuite everything {settingFailFast = failFast} suite (const (pure ())) [subject]
      let note = if failFast then Just "not tried: another law failed before it" else Nothing
      [(lawReportId law, lawReportOutcome law, lawReportNote law) | law <- reportLaws report]
        `shouldBe` take
          2
          [("profile/opens", Held, Nothing), ("field/sums", Failed, Nothing)]
          ++ if failFast
            then
              [ (name, Skipped, note)
                | name <- words "sequence/terms field/sums sequence/terms segment/none"
              ]
                ++ [("protocol/a", Held, Nothing)]
            else
              [ ("sequence/terms", Skipped, Just "no case under this profile"),
                ("field/sums", Failed, Nothing),
                ("sequence/terms", Skipped, Just "no case under this profile"),
                ("segment/none", Held, Nothing),
                ("protocol/a", Held, Nothing)
              ]
  it "never asks an operation again after its timeout or crash, unless that failure is known" $
    forM_ [(kind, known) | kind <- [Crashed, TimedOut], known <- [[], ["*"]]] $ \(kind, known) -> do
      asked <- newIORef (0 :: Int)
      let asks (name, operation, question) =
            made (name, OnField, [operation]) (Cases natural (Every [0]) (const question))
          two' =
            [ asks ("field/a", SomeOp Add, Holds <$ ask (Add :? (0, 0))),
              asks ("field/b", SomeOp Term, Holds <$ ask (Term :? 0))
            ]
          silent = answering (const (Left (Fault kind "")))
          subject =
            silent
              { subjectOffers = codeOperations,
                subjectAsk = \some -> modifyIORef' asked (+ 1) >> subjectAsk silent some
              }
      report <-
        runSuite
          everything {settingKnown = known}
          suite {suiteLaws = two', suiteOpenings = [], suiteWithoutProfile = []}
          (const (pure ()))
          [subject]
      map lawReportOutcome (reportLaws report)
        `shouldBe` if null known
          then [Errored, Errored, Skipped, Skipped]
          else replicate 4 KnownFailure
      readIORef asked `shouldReturn` (if null known then 2 else 4)
      mapMaybe lawReportNote (reportLaws report)
        `shouldBe` [ "not asked: there was no reply to " ++ name ++ " before"
                     | null known,
                       name <- ["add", "term"]
                   ]
  it "makes only the first failing case of a law smaller, not those under other profiles" $ do
    report <-
      runSuite
        everything {settingRun = ["field/sums"]}
        suite
          { suiteLaws =
              [ made
                  ("field/sums", OnField, [SomeOp Add])
                  (Cases natural (Some (pure 9) (\n -> [n - 1 | n > 3])) sums)
              ]
          }
        (const (pure ()))
        [answering (const (result 9))]
    map counterShrinks (mapMaybe lawReportCounterexample (reportLaws report)) `shouldBe` [6, 0]
  it "asks a fresh process for a failing case, and reports whether its answer is right" $
    forM_ [(True, Nothing), (False, Just ())] $ \(remembers, token) -> do
      asked <- newIORef (0 :: Int)
      let subject =
            (answering allZero)
              { subjectAsk = \questions -> do
                  before <- readIORef asked
                  modifyIORef' asked (+ length questions)
                  pure [result (if before > 1 || not remembers then 9 else 0) | _ <- questions],
                subjectBatch = 1,
                subjectFresh = Just (writeIORef asked 0)
              }
      report <- runSuite everything {settingRun = ["sums"]} onlyOne (const (pure ())) [subject]
      [shown] <- pure (mapMaybe lawReportCounterexample (reportLaws report))
      (counterDepends shown, () <$ counterToken shown) `shouldBe` (remembers, token)
  it "skips the law of order if an answer is wrong whatever was asked before" $
    forM_ [(True, Failed, Nothing), (False, Skipped, Just notJudged)] $
      \(remembers, outcome, note) -> do
        asked <- newIORef (0 :: Int)
        let subject =
              (answering allZero)
                { subjectAsk = \questions -> do
                    before <- readIORef asked
                    modifyIORef' asked (+ length questions)
                    pure [result (if before > 0 || not remembers then 9 else 0) | _ <- questions],
                  subjectBatch = 1,
                  subjectFresh = Just (writeIORef asked 0)
                }
            law =
              made ("field/in-any-order", OnField, [SomeOp Add]) (Cases natural (Every [0]) once')
            once' n = do
              first' <- ask (Add :? (n, 0))
              pure (if first' == Right 0 then Holds else violated)
            violated =
              Violated
                ( Violation
                    [Exchange (Just (SomeOp Add)) (toJSON ()) (Result Null)]
                    (Result Null)
                    ""
                    ""
                )
        _ <- subjectAsk subject [SomeQuestion (Add :? (0, 0))]
        report <-
          runSuite
            everything {settingRun = ["order"]}
            onlyOne {suiteLaws = [law]}
            (const (pure ()))
            [subject]
        [(lawReportOutcome one', lawReportNote one') | one' <- reportLaws report]
          `shouldBe` [(outcome, note)]
  it "ends early only at a failure: without one, the last law is tried" $ do
    let subject = (answering allZero) {subjectChecks = [checked "protocol/a" CheckHeld]}
    report <-
      runSuite everything {settingFailFast = True} suite (const (pure ())) [subject]
    map lawReportOutcome (reportLaws report)
      `shouldBe` [Held, Held, Skipped, Held, Skipped, Held, Held]
  it "reports everything as too slow without time left, except laws that are left out" $
    forM_ [0, -1] $ \limit -> do
      let subject = (answering allZero) {subjectChecks = [checked "protocol/a" CheckHeld]}
      report <-
        runSuite
          everything {settingLimit = limit, settingSkip = ["opens"]}
          suite
          (const (pure ()))
          [subject]
      map lawReportOutcome (reportLaws report) `shouldBe` Skipped : replicate 6 Errored
      map
        (\shown -> (counterGot shown, counterReason shown))
        (mapMaybe lawReportCounterexample (reportLaws report))
        `shouldBe` replicate
          6
          ( Left (Fault TooSlow "the time for all of it was over"),
            "--limit is the time for all laws together"
          )
  it "reports a law that exceeds the time, and those after it, as too slow" $ do
    let subject = (answering allZero) {subjectAsk = \_ -> forever (threadDelay 1000)}
    report <-
      runSuite
        everything {settingLimit = 0.02, settingRun = ["field/*"]}
        suite
        (const (pure ()))
        [subject]
    map lawReportOutcome (reportLaws report) `shouldBe` [Errored, Errored]
    let enough = everything {settingLimit = 0.9, settingRun = ["segment/*"]}
    quick <- runSuite enough suite (const (pure ())) [answering allZero]
    map lawReportOutcome (reportLaws quick) `shouldBe` [Held]
  it "accepts known failures; a law that is listed as failing and holds is unexpected" $ do
    let failing = answering (const (result 9))
        run settings subject = do
          report <- runSuite settings suite (const (pure ())) [subject]
          let own = filter ((== "field/sums") . lawReportId) (reportLaws report)
          pure (nub (map lawReportOutcome own), reportUnexpected report)
        known' = everything {settingKnown = ["field/*"]}
        skipped' = everything {settingSkip = ["sums", "opens"], settingSkipMustFail = True}
    run everything failing `shouldReturn` ([Failed], [])
    run known' failing `shouldReturn` ([KnownFailure], [])
    run known' (answering allZero) `shouldReturn` ([Held], ["field/*"])
    run skipped' failing `shouldReturn` ([KnownFailure], ["opens"])
    run skipped' {settingSkipMustFail = False} failing `shouldReturn` ([Skipped], [])
    -- None of these laws that could have held was tried.
    run everything {settingKnown = ["sequence/*"]} failing `shouldReturn` ([Failed], [])
    run known' (answering (const (Left (Fault Crashed "")))) `shouldReturn` ([KnownFailure], [])
  it "chooses checks of the protocol like laws, and reports their outcome" $ do
    let requests = [toJSON (1 :: Int)]
        subject =
          (answering allZero)
            { subjectChecks =
                [ checked "protocol/a" CheckHeld,
                  checked "protocol/b" $
                    CheckFailed requests (ResponseErrored "e") (ResponseSkipped "s"),
                  checked "protocol/c" (CheckErred requests (Fault DoesNotStop "d"))
                ]
            }
        run settings = do
          report <- runSuite settings suite (const (pure ())) [subject]
          length (reportLaws report) `shouldBe` countWork settings suite subject
          pure [law | law <- reportLaws report, lawReportStage law == OnProtocol]
        ids settings = map lawReportId <$> run settings
        names = map ("protocol/" ++)
    ids standardSettings `shouldReturn` names ["a", "b", "c"]
    ids standardSettings {settingStages = [OnField]} `shouldReturn` []
    ids standardSettings {settingRun = ["protocol/b"]} `shouldReturn` names ["b"]
    ids standardSettings {settingSkip = ["protocol/b"]} `shouldReturn` names ["a", "c"]
    ids standardSettings {settingSkip = ["protocol/b"], settingSkipMustFail = True}
      `shouldReturn` names ["a", "b", "c"]
    laws <- run standardSettings
    map (\law -> (lawReportOutcome law, lawReportCases law, lawReportExhaustive law)) laws
      `shouldBe` [(Held, 1, True), (Failed, 1, True), (Errored, 1, True)]
    map
      (\c -> (counterRequests c, counterExpected c, counterRoad c, counterGot c, counterReason c))
      (mapMaybe lawReportCounterexample laws)
      `shouldBe` [ ( requests,
                     Just (ResponseErrored "e"),
                     "the protocol",
                     Right (ResponseSkipped "s"),
                     "sentence of protocol/b"
                   ),
                   ( requests,
                     Nothing,
                     "the protocol",
                     Left (Fault DoesNotStop "d"),
                     "sentence of protocol/c"
                   )
                 ]
  it "replays the case of a token alone" $ do
    let again token = replay everything {settingSeed = 3} suite token
        case' n = Token "field/sums" (Just one) (toJSON (n :: Int))
        wrong = answering (\asked -> if asked `is` (Add :? (1, 2)) then result 7 else allZero asked)
        summary report =
          ( [ (lawReportId law, lawReportOutcome law, lawReportCases law)
              | law <- reportLaws report
            ],
            (reportPartial report, reportSeed report, reportSubject report),
            (reportAsks report, reportOffers report)
          )
        ofCode outcome =
          Just
            ( Just
                ( [("field/sums", outcome, 1)],
                  (True, 3, "made"),
                  (codeOperations, [SomeOp Terms, SomeOp Add, SomeOp Term])
                )
            )
        run subject token = fmap (either (const Nothing) (Just . summary)) <$> again token subject
    start <- getMonotonicTime
    Just (Right alone) <- again (case' 2) wrong
    end <- getMonotonicTime
    map counterShrinks (mapMaybe lawReportCounterexample (reportLaws alone)) `shouldBe` [0]
    reportSeconds alone `shouldSatisfy` (\seconds -> seconds > 0 && seconds <= end - start)
    run wrong (case' 2) `shouldReturn` ofCode Failed
    run wrong (case' 0) `shouldReturn` ofCode Held
    run (answering allZero) (case' 2) `shouldReturn` ofCode Held
    run wrong (Token "field/sums" (Just one) (String "x")) `shouldReturn` Just Nothing
    run wrong (Token "field/none" (Just one) Null) `shouldReturn` Nothing
  where
    notJudged = "not judged: an answer is wrong whatever was asked before"

-- | The index in a question about a term.
termOf :: SomeQuestion -> Maybe Natural
termOf (SomeQuestion question) = case question of
  Term :? n -> Just n
  _ -> Nothing

asksTerm :: Natural -> Ask Verdict
asksTerm = fmap (const Holds) . ask . (Term :?)

caseSpec :: Spec
caseSpec = do
  it "are made smaller, unless each step would take as long again" $
    forM_ [minBound ..] $ \kind -> do
      let numbers = Cases natural (Some (pure 9) (\n -> [n - 1 | n > 0])) (judge' . (Term :?))
          judge' question = Holds <$ ask question
          subject = answering (const (Left (Fault kind "")))
      came <- tryLaw (Plan 1 3 2 True) subject "law" numbers
      let slow = kind `elem` [TimedOut, HalfLine, EndlessOutput]
      (kind, (\f -> (failureCase f, failureShrinks f)) <$> triedFailure came)
        `shouldBe` (kind, Just (if slow then (toJSON (9 :: Int), 0) else (toJSON (0 :: Int), 9)))
  it "are as many as requested, even if the law does not apply to the first ones drawn" $ do
    -- Sizes are 0, 10, 20 to 100, then 9, 19, 29 and so on.
    let says n = if n `mod` 10 == 0 then Inapplicable else Holds
        cases gen = Cases natural (Some gen (const [])) (pure . says)
    later <-
      tryLaw
        (Plan 1 10 4 True)
        (answering allZero)
        "law"
        (cases (sized (pure . fromIntegral)))
    (triedCases later, triedExhaustive later) `shouldBe` (10, False)
    never <- tryLaw (Plan 1 10 4 True) (answering allZero) "law" (cases (pure 20))
    triedCases never `shouldBe` 0
  it "are asked as many at once as a subject takes; those that open profiles one by one" $
    forM_ [(5, [5, 5, 2]), (12, [12]), (64, [12]), (1, replicate 12 1)] $ \(batch, lengths) -> do
      counts <- newIORef []
      let base = answering allZero
          subject =
            base
              { subjectBatch = batch,
                subjectAsk = \questions ->
                  modifyIORef counts (length questions :) >> subjectAsk base questions
              }
          twelve stage = made ("a/b", stage, []) (Cases natural (Every [1 .. 12]) asksTerm)
          run one' = do
            writeIORef counts []
            void (runSuite everything one' (const (pure ())) [subject])
            reverse <$> readIORef counts
      run alone {suiteLaws = [twelve OnSequence]} `shouldReturn` lengths
      run alone {suiteWithoutProfile = [twelve OnSegment]} `shouldReturn` replicate 12 1
  it "are drawn in sizes up to 100, up to ten times as many as needed, by seed and name" $ do
    forM_ [1, 2, 7, 100, 101] $ \count ->
      asksOf (Plan 1 count 1 True) "law" (sized (pure . fromIntegral))
        `shouldBe` ( count,
                     [fromIntegral (i * 100 `div` count `mod` 101) | i <- [0 .. 10 * count - 1]]
                   )
    let draws seed name = snd (asksOf (Plan seed 5 1 True) name large)
        large = fromInteger <$> chooseInteger (0, 10 ^ (9 :: Int))
        of' = [draws seed name | seed <- [1, 2], name <- ["law", "lay", "other"]]
    length (nub of') `shouldBe` 6
    draws 1 "law" `shouldBe` draws 1 "law"
  where
    -- The number that are judged, and the numbers of all of them.
    asksOf plan name gen =
      let (trials, most) =
            trialsOf plan name (Cases natural (Some gen (const [])) asksTerm)
       in (most, mapMaybe termAsked trials)
    termAsked :: Ask Verdict -> Maybe Natural
    termAsked trial = case trial of
      Asking question _ -> termOf (SomeQuestion question)
      _ -> Nothing
    alone = onlyOne {suiteLaws = []}

-- | The suite under one profile, without laws of profiles and of touch.
onlyOne :: Suite Profile
onlyOne = suite {suiteProfiles = [("one", one)], suiteOpenings = [], suiteWithoutProfile = []}
