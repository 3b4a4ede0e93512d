{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Whole runs on a suite made for them: their reports, their time and what is known to fail; and
-- how cases are drawn, asked and made smaller.
module Test.Conformance.Run.Whole (spec) where

import Control.Concurrent (threadDelay)
import Control.Monad (forM_, forever, void)
import Data.Aeson (Value (..), toJSON)
import Data.IORef
import Data.List (isInfixOf, nub, sort)
import Data.Maybe (mapMaybe)
import GHC.Clock (getMonotonicTime)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Process.Reply (runRequest)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run
import PraTactile.Conformance.Run.Case
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Run.Trials
import PraTactile.Conformance.Subject
import PraTactile.Format.Json.Codec (natural)
import PraTactile.Grid (Surface (..))
import PraTactile.Profile (Profile (..))
import Test.Conformance.Run.SmallSuite
import Test.Hspec
import Test.QuickCheck (chooseInteger, sized)

spec :: Spec
spec = do
  describe "a run" runSpec
  describe "cases" caseSpec

runSpec :: Spec
runSpec = do
  it "has all that was chosen in its report, in order, and tells each as it is tried" $
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
        `shouldBe` (codeOperations ++ touchOperations, codeAndTouch)
      (reportUnknown report, reportUnexpected report) `shouldBe` (["unknown"], [])
      end <- getMonotonicTime
      reportSeconds report `shouldSatisfy` (\seconds -> seconds > 0 && seconds <= end - start)
      map
        (\law -> (lawReportCases law, lawReportExhaustive law))
        (filter ((== Held) . lawReportOutcome) (reportLaws report))
        `shouldBe` [(2, True), (2, True), (20, False), (1, True)]
  it "asks for the operations of its stages, and counts those that are offered of them" $
    forM_
      [ ([OnSequence], codeOperations, [OfTerms, OfAdd, OfTerm]),
        ([OnSegment], touchOperations, [OfSegment])
      ]
      $ \(stages, asks, offers) -> do
        report <-
          runSuite everything {settingStages = stages} suite (const (pure ())) [answering allZero]
        (reportAsks report, reportOffers report) `shouldBe` (asks, offers)
  it "ends at the first failure, if that is asked for" $
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
  it "what gets no reply is not asked again, unless that is known; after three waits nothing is" $
    forM_
      [ (Crashed, [], [Errored, Errored, Errored, Errored], "no reply to"),
        (TimedOut, [], [Errored, Errored, Errored, Skipped], "the time for a reply was over"),
        (TimedOut, ["*"], replicate 8 KnownFailure, "")
      ]
      $ \(kind, known, outcomes, why) -> do
        asked <- newIORef (0 :: Int)
        let asks (name, operation, question) =
              made (name, OnField, [operation]) (Cases natural (Every [0]) (const question))
            four =
              [ asks ("field/a", OfAdd, Holds <$ ask (Add 0 0)),
                asks ("field/b", OfTerm, Holds <$ ask (Term 0)),
                asks ("field/c", OfTerms, Holds <$ ask (Terms 0 1)),
                asks ("field/d", OfCell, Holds <$ ask (Cell 0 0))
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
            suite {suiteLaws = four, suiteOpenings = [], suiteWithoutProfile = []}
            (const (pure ()))
            [subject]
        let came = map lawReportOutcome (reportLaws report)
        (kind, came) `shouldBe` (kind, take 8 (outcomes ++ repeat Skipped))
        readIORef asked `shouldReturn` length (filter (/= Skipped) came)
        mapMaybe lawReportNote (reportLaws report)
          `shouldSatisfy` all (isInfixOf why)
  it "takes a glance at everything first: what fails under the last profile alone is soon seen" $
    -- Of a whole domain and of drawn cases; under the last of five profiles alone, at its end.
    forM_ [Every [0 .. 999], Some (fromInteger <$> chooseInteger (0, 999)) (const [])] $
      \domain -> forM_ [False, True] $ \failFast -> do
        asked <- newIORef (0 :: Int)
        inForce <- newIORef []
        let subject =
              (answering allZero)
                { subjectProfile = \p -> do
                    earlier <- readIORef asked
                    modifyIORef' inForce ((p, earlier) :)
                    pure (Right (ResponseResult (Bool True))),
                  subjectAsk = \questions -> do
                    modifyIORef' asked (+ length questions)
                    profiles <- map fst <$> readIORef inForce
                    let wrong q = take 1 profiles == [lastOne] && beyond 850 q
                    pure [result (if wrong q then 1 else 0) | q <- questions]
                }
        report <-
          runSuite
            everything {settingFailFast = failFast, settingRun = ["field/sums"], settingCases = 100}
            (underFive domain)
            (const (pure ()))
            [subject]
        map lawReportOutcome (reportLaws report) `shouldBe` replicate 4 Held ++ [Failed]
        reportGlance report `shouldBe` True
        profiles <- readIORef inForce
        -- All cases under the first profile, ten under three others, two sums each.
        let all' = case domain of
              Every every -> length every
              Some _ _ -> 100
        [count | (p, count) <- profiles, p == lastOne] `shouldBe` [2 * (all' + 30)]
        case (domain, mapMaybe lawReportCounterexample (reportLaws report)) of
          (Every _, [shown]) ->
            drop 1 (counterRequests shown) `shouldBe` [runRequest 2 (SomeQuestion (Add 1 851))]
          _ -> pure ()
  it "tries all cases where the glance shows no failure, each once" $
    -- Under the first profile at once, under the second those of the glance and the others.
    forM_ [1, 9, 10, 25, 100, 101] $ \cases ->
      forM_ [Every [0 .. 36], Every [], Some (sized (pure . fromIntegral)) (const [])] $
        \domain -> do
          numbers <- newIORef []
          let base = answering allZero
              subject =
                base
                  { subjectAsk = \questions -> do
                      modifyIORef' numbers (mapMaybe termOf questions ++)
                      subjectAsk base questions
                  }
              law = made ("sequence/all", OnSequence, []) (Cases natural domain asksTerm)
              twice =
                suite
                  { suiteProfiles = [("two", two), ("one", one)],
                    suiteLaws = [law],
                    suiteOpenings = []
                  }
          report <-
            runSuite
              everything {settingCases = cases, settingRun = ["sequence/all"]}
              twice
              (const (pure ()))
              [subject]
          asked <- readIORef numbers
          let wanted = case domain of
                Every every -> every
                Some _ _ -> [fromIntegral (i * 100 `div` cases `mod` 101) | i <- [0 .. cases - 1]]
          sort asked `shouldBe` sort (wanted ++ wanted)
          let came = case domain of
                Every [] -> (Skipped, 0, True)
                Every every -> (Held, length every, True)
                Some _ _ -> (Held, cases, False)
              told one' = (lawReportOutcome one', lawReportCases one', lawReportExhaustive one')
          map told (reportLaws report) `shouldBe` [came, came]
          reportGlance report `shouldBe` False
  it "asks one case at first of a law that failed under a profile before" $ do
    asked <- newIORef []
    let base = answering (const (result 9))
        subject =
          base
            { subjectProfile = \p -> modifyIORef asked (0 :) >> subjectProfile base p,
              subjectAsk = \questions -> do
                let more counts = (sum (take 1 counts) + length questions) : drop 1 counts
                modifyIORef asked more
                subjectAsk base questions
            }
    _ <-
      runSuite
        everything {settingRun = ["field/sums"]}
        (underFive (Every [0 .. 99]))
        (const (pure ()))
        [subject]
    -- Each has two sums.
    counts <- readIORef asked
    take 4 counts `shouldBe` [2, 2, 2, 2 :: Int]
  it "tries a law that failed under three profiles by long answers under no others" $
    forM_ [(1000, replicate 5 Failed), (3000, replicate 3 Failed ++ replicate 2 Skipped)] $
      \(size, outcomes) -> do
        let long = Right (ResponseResult (toJSON (replicate size (0 :: Int))))
        report <-
          runSuite
            everything {settingRun = ["field/sums"]}
            (underFive (Every [0, 2]))
            (const (pure ()))
            [answering (const long)]
        (size, map lawReportOutcome (reportLaws report)) `shouldBe` (size, outcomes)
        mapMaybe lawReportNote (reportLaws report)
          `shouldBe` [ "not tried: it failed under three profiles before, by long answers"
                       | Skipped <- outcomes
                     ]
  it "asks no more than two at once after a law failed by long answers" $
    forM_ [(1000, 4), (3000, 2)] $ \(size, most) -> do
      asked <- newIORef []
      let base = answering (const (Right (ResponseResult (toJSON (replicate size (0 :: Int))))))
          subject =
            base
              { subjectAsk = \questions -> do
                  modifyIORef asked (([() | q <- questions, beyond 49 q] :) :: [[()]] -> [[()]])
                  subjectAsk base questions
              }
          laws = [law "field/a" [0 .. 49], law "field/b" [50 .. 99]]
          law name numbers = made (name, OnField, [OfAdd]) (Cases natural (Every numbers) sums)
      _ <-
        runSuite
          everything
          suite {suiteProfiles = [("one", one)], suiteLaws = laws, suiteOpenings = []}
          (const (pure ()))
          [subject]
      ofSecond <- readIORef asked
      (size, maximum (map length ofSecond)) `shouldBe` (size, most)
  it "ends at no failure that there is not: what comes last is tried" $ do
    let subject = (answering allZero) {subjectChecks = [checked "protocol/a" CheckHeld]}
    report <-
      runSuite everything {settingFailFast = True} suite (const (pure ())) [subject]
    map lawReportOutcome (reportLaws report)
      `shouldBe` [Held, Held, Skipped, Held, Skipped, Held, Held]
  it "without time left everything is too slow, but for what is left out" $
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
  it "a law that takes longer than there is time is too slow, and those after it" $ do
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
  it "failures that are known are none; one that is said to fail and holds is unexpected" $ do
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
    -- Of this none was tried that could have held.
    run everything {settingKnown = ["sequence/*"]} failing `shouldReturn` ([Failed], [])
    run known' (answering (const (Left (Fault Crashed "")))) `shouldReturn` ([KnownFailure], [])
  it "checks of the protocol are chosen like laws, and say what came of them" $ do
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
  it "a token's case is tried again alone" $ do
    let again token = replay everything {settingSeed = 3} suite token
        case' n = Token "field/sums" (Just one) (toJSON (n :: Int))
        wrong = answering (\asked -> if asked `is` Add 1 2 then result 7 else allZero asked)
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
                  (codeOperations, [OfTerms, OfAdd, OfTerm])
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

-- | The first law of the suite on such cases, under five profiles.
underFive :: Domain Natural -> Suite Profile
underFive domain =
  suite
    { suiteProfiles =
        [("one", one), ("two", two), ("other", other), ("sheet", sheet), ("last", lastOne)],
      suiteLaws =
        [made ("field/sums", OnField, [OfAdd]) (Cases natural domain sums)],
      suiteOpenings = [],
      suiteWithoutProfile = []
    }
  where
    sheet = one {profileSurface = Sheet}

lastOne :: Profile
lastOne = one {profileSurface = TwistedTorus}

-- | Whether it is a sum with a number beyond that.
beyond :: Natural -> SomeQuestion -> Bool
beyond least (SomeQuestion question) = case question of
  Add _ n -> n > least
  _ -> False

-- | The number of a question about a term.
termOf :: SomeQuestion -> Maybe Natural
termOf (SomeQuestion question) = case question of
  Term n -> Just n
  _ -> Nothing

asksTerm :: Natural -> Ask Verdict
asksTerm = fmap (const Holds) . ask . Term

caseSpec :: Spec
caseSpec = do
  it "are made smaller, unless each would take as long again" $
    forM_ [minBound ..] $ \kind -> do
      let numbers = Cases natural (Some (pure 9) (\n -> [n - 1 | n > 0])) (judge' . Term)
          judge' question = Holds <$ ask question
          subject = answering (const (Left (Fault kind "")))
      came <- tryLaw (Plan 1 3 2 False Whole) subject "law" numbers
      let slow = kind `elem` [TimedOut, HalfLine, EndlessOutput]
      (kind, (\f -> (failureCase f, failureShrinks f)) <$> triedFailure came)
        `shouldBe` (kind, Just (if slow then (toJSON (9 :: Int), 0) else (toJSON (0 :: Int), 9)))
  it "of those that violate a law 256 are kept, of one search and of several" $ do
    forM_ [1, 255, 256, 257, 300] $ \count -> do
      let some = map violated [1 .. fromIntegral count]
      came <- search (answering allZero) (Window count count) some
      (count, length (searchWrong came), searchCases came, fst <$> searchTrouble came)
        `shouldBe` (count, min 256 count, 1, Just 0)
    forM_ [(100, 148), (207, 255), (208, 256), (209, 256), (300, 256)] $ \(count, kept) -> do
      let smaller n = if n > 0 then replicate 20 (n - 1) else []
          twenty = Cases natural (Some (pure 3) smaller) violated
      came <- tryLaw (Plan 1 count 400 False Whole) (answering allZero) "law" twenty
      (count, length . failureWrong <$> triedFailure came) `shouldBe` (count, Just kept)
  it "one at a time is asked to its end and judged before the next, and none after one that fails" $
    forM_ [1, 3, 6] $ \bad -> do
      numbers <- newIORef []
      let base = answering allZero
          numbered asked' = modifyIORef numbers ([n | n <- [1 .. 20], asked' `is` Term n] ++)
          subject =
            base {subjectAsk = \questions -> mapM_ numbered questions >> subjectAsk base questions}
          twice n =
            ask (Term n)
              >> if n == bad then violated (10 + n) else Holds <$ ask (Term (10 + n))
      _ <- search subject (Window 1 1) (map twice [1 .. 6])
      (reverse <$> readIORef numbers) `shouldReturn` concat [[n, 10 + n] | n <- [1 .. bad]]
  it "are as many as are wanted, though the law says nothing of all that are drawn first" $ do
    -- Sizes are 0, 10, 20 to 100, then 9, 19, 29 and on.
    let says n = if n `mod` 10 == 0 then Inapplicable else Holds
        cases gen = Cases natural (Some gen (const [])) (pure . says)
    later <-
      tryLaw
        (Plan 1 10 4 False Whole)
        (answering allZero)
        "law"
        (cases (sized (pure . fromIntegral)))
    (triedCases later, triedExhaustive later) `shouldBe` (10, False)
    never <- tryLaw (Plan 1 10 4 False Whole) (answering allZero) "law" (cases (pure 20))
    triedCases never `shouldBe` 0
  it "as many are asked at once as a subject takes, and of those that open profiles one" $
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
  it "are drawn in sizes that grow to 100, ten times as many as are needed, by seed and name" $ do
    forM_ [1, 2, 7, 100, 101] $ \count ->
      asksOf (Plan 1 count 1 False Whole) "law" (sized (pure . fromIntegral))
        `shouldBe` ( count,
                     [fromIntegral (i * 100 `div` count `mod` 101) | i <- [0 .. 10 * count - 1]]
                   )
    let draws seed name = snd (asksOf (Plan seed 5 1 False Whole) name large)
        large = fromInteger <$> chooseInteger (0, 10 ^ (9 :: Int))
        of' = [draws seed name | seed <- [1, 2], name <- ["law", "lay", "other"]]
    length (nub of') `shouldBe` 6
    draws 1 "law" `shouldBe` draws 1 "law"
  where
    -- How many are judged, and the numbers that all are of.
    asksOf plan name gen =
      let (trials, most) =
            trialsOf plan name (Cases natural (Some gen (const [])) asksTerm)
       in (most, mapMaybe termAsked trials)
    termAsked :: Ask Verdict -> Maybe Natural
    termAsked trial = case trial of
      Asking question _ -> termOf (SomeQuestion question)
      _ -> Nothing
    violated n =
      Violated (Violation [Exchange (Just OfTerm) (toJSON n) (Result Null)] (Result Null) "" "")
        <$ ask (Term n)
    alone =
      suite
        { suiteProfiles = [("one", one)],
          suiteLaws = [],
          suiteOpenings = [],
          suiteWithoutProfile = []
        }
