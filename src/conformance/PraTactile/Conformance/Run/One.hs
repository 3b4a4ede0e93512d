-- | One law tried on one subject, as it is reported.
module PraTactile.Conformance.Run.One
  ( -- * Subjects at work
    Worker,
    newWorker,

    -- * Trying
    tryWork,
    tryToken,

    -- * Reports of laws not tried
    blank,
    tooSlow,

    -- * Checks of the protocol
    checkReport,
    checkedReport,
    checkTooSlow,
  )
where

import Data.Aeson (Value (Bool))
import Data.IORef
import Data.List (isSuffixOf)
import Data.Maybe (isJust, isNothing)
import qualified Data.Set as Set
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Order (orderName)
import PraTactile.Conformance.Process.Reply (profileRequest, profileRequestOf, runRequest)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run.Case
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Run.Trials (Asked (..), Trouble (..))
import PraTactile.Conformance.Run.Work
import PraTactile.Conformance.Subject
import PraTactile.Format.Error (FormatError)
import PraTactile.Profile (Profile)

-- | A subject at work.
data Worker = Worker
  { workerSubject :: Subject,
    -- | The profile that was put in force last, with what came instead of that.
    workerForce :: IORef (Maybe (Profile, Maybe Counterexample)),
    -- | The laws that failed.
    workerFailed :: IORef (Set.Set String)
  }

-- | Of a subject with no profile in force.
newWorker :: Subject -> IO Worker
newWorker subject = Worker subject <$> newIORef Nothing <*> newIORef Set.empty

-- | Try all cases of a law. A failing case is made smaller and asked of a fresh process, unless the
-- law failed under another profile before.
tryWork :: (Subject -> Plan) -> Worker -> Work -> IO LawReport
tryWork planFor worker work = inForce worker work $ do
  again <- Set.member (workId work) <$> readIORef (workerFailed worker)
  tried <-
    tryLaw
      (alone work (planFor subject)) {planShrinks = not again}
      subject
      (workId work)
      (workCases work)
  case triedFailure tried of
    Nothing -> pure (reportOf work False tried)
    Just failure -> do
      modifyIORef' (workerFailed worker) (Set.insert (workId work))
      depends <- if again then pure False else dependsOnEarlier worker work failure
      pure $
        if not depends && isOrderLaw && isWrong (failureTrouble failure)
          then skipped work wrongAlone
          else reportOf work depends tried
  where
    subject = workerSubject worker
    isOrderLaw = ("/" ++ orderName) `isSuffixOf` workId work && isJust (subjectFresh subject)
    isWrong trouble = case trouble of
      Wrong _ -> True
      Broke {} -> False

-- | Why the law of the order says nothing of a wrong answer: other laws find it.
wrongAlone :: String
wrongAlone = "not judged: an answer is wrong whatever was asked before"

-- | Whether a fresh process answers a failing case rightly.
dependsOnEarlier :: Worker -> Work -> Failure -> IO Bool
dependsOnEarlier worker work failure =
  case (subjectFresh subject, tryCase plan subject (workCases work) (failureCase failure)) of
    (Just fresh, Right again) -> do
      fresh
      mapM_ (subjectProfile subject . snd) (workProfile work)
      tried <- again
      writeIORef (workerForce worker) Nothing
      pure (isNothing (triedFailure tried))
    _ -> pure False
  where
    subject = workerSubject worker
    plan = Plan {planSeed = 0, planCases = 1, planBatch = 1, planShrinks = False}

-- | Try one case of a law.
tryToken :: (Subject -> Plan) -> Worker -> Work -> Value -> IO (Either FormatError LawReport)
tryToken planFor worker work case' =
  traverse
    (\tried -> inForce worker work (reportOf work False <$> tried))
    (tryCase (alone work (planFor subject)) subject (workCases work) case')
  where
    subject = workerSubject worker

-- | A trial that puts profiles in force has the subject for itself, and so has each trial of touch
-- and of objects.
alone :: Work -> Plan -> Plan
alone work plan = plan {planBatch = maybe 1 (const (planBatch plan)) (workProfile work)}

-- | Do it with the profile of the work in force; where that is refused, say so.
inForce :: Worker -> Work -> IO LawReport -> IO LawReport
inForce worker work act = case workProfile work of
  Nothing -> writeIORef held Nothing >> act
  Just (_, profile) -> do
    before <- readIORef held
    refused <- case before of
      Just (there, got) | there == profile -> pure got
      _ -> do
        got <- notInForce profile <$> subjectProfile subject profile
        got <$ writeIORef held (Just (profile, got))
    case refused of
      Nothing -> act
      Just shown ->
        pure (blank work) {lawReportOutcome = Errored, lawReportCounterexample = Just shown}
  where
    subject = workerSubject worker
    held = workerForce worker

-- | What came, unless the profile is in force.
notInForce :: Profile -> Either Fault Response -> Maybe Counterexample
notInForce profile got = case got of
  Right (ResponseResult (Bool True)) -> Nothing
  _ ->
    Just
      ( counterexample
          [profileRequest profile]
          (Just (ResponseResult (Bool True)))
          "the definition"
          got
          "the profile names an array, so that it can be put in force"
      )

-- | The report of a law's cases, given whether the failing one depends on earlier requests.
reportOf :: Work -> Bool -> Tried -> LawReport
reportOf work depends tried = case triedFailure tried of
  Just failure ->
    counted
      { lawReportOutcome = outcomeOf (failureTrouble failure),
        lawReportCounterexample = Just (counterexampleOf work depends failure)
      }
  Nothing
    | triedCases tried == 0 ->
      (skipped work "no case under this profile") {lawReportExhaustive = triedExhaustive tried}
    | otherwise -> counted {lawReportOutcome = Held}
  where
    counted =
      (blank work)
        { lawReportCases = triedCases tried,
          lawReportExhaustive = triedExhaustive tried
        }

-- | Whether the law failed, or something else went wrong.
outcomeOf :: Trouble -> Outcome
outcomeOf trouble = case trouble of
  Wrong _ -> Failed
  Broke _ _ (Right (ResponseSkipped _)) -> Failed
  Broke _ _ (Left fault) | faultKind fault == WrongType -> Failed
  Broke {} -> Errored

counterexampleOf :: Work -> Bool -> Failure -> Counterexample
counterexampleOf work depends failure =
  shown
    { counterShrinks = failureShrinks failure,
      counterDepends = depends,
      counterToken = if depends then Nothing else Just token
    }
  where
    token = writeToken (Token (workId work) (snd <$> workProfile work) (failureCase failure))
    shown = case failureTrouble failure of
      Wrong violation ->
        counterexample
          (requestsOf (violationAsked violation))
          (Just (responseOf (violationExpected violation)))
          (violationRoad violation)
          ( case reverse (violationAsked violation) of
              Exchange _ _ reply : _ -> Right (responseOf reply)
              [] -> Right (ResponseErrored "nothing was asked")
          )
          (violationReason violation)
      Broke before what got ->
        counterexample
          (requestsOf before ++ [requestOf (length before + 1) what])
          (answerTo what)
          "the definition"
          got
          (reasonFor got)
    answerTo what = case what of
      AskedQuestion question -> responseOf <$> workAnswer work question
      AskedProfile _ -> Nothing
    requestOf i what = case what of
      AskedQuestion question -> runRequest i question
      AskedProfile profile -> profileRequest profile

-- | Why what came is no answer.
reasonFor :: Either Fault Response -> String
reasonFor got = case got of
  Right (ResponseSkipped _) -> "what is offered is answered or refused, not skipped"
  Right _ -> "an error of the subject is no answer"
  Left fault | faultKind fault == WrongType -> "the result has another type"
  Left _ -> "a request has one reply, within the time limit"

-- | What was asked, as requests of the protocol.
requestsOf :: [Exchange] -> [Value]
requestsOf = zipWith request [1 ..]
  where
    request i (Exchange operation input _) = case operation of
      Just name -> runRequest i (SomeQuestion (Raw name input))
      Nothing -> profileRequestOf input

-- | A report of a law that says nothing yet.
blank :: Work -> LawReport
blank work =
  (untried (workId work) (workStage work) (workSentence work) (workSource work))
    { lawReportNeeds = workNeeds work,
      lawReportProfile = fst <$> workProfile work
    }

-- | Not tried, for this reason.
skipped :: Work -> String -> LawReport
skipped work reason = (blank work) {lawReportNote = Just reason}

-- | Not finished when the time for all was over.
tooSlow :: Work -> LawReport
tooSlow = outOfTime . blank

outOfTime :: LawReport -> LawReport
outOfTime report =
  report
    { lawReportOutcome = Errored,
      lawReportCounterexample =
        Just
          ( counterexample
              []
              Nothing
              ""
              (Left timeOver)
              "--limit is the time for all laws together"
          )
    }

-- | A check that was not made.
checkReport :: Check -> LawReport
checkReport check =
  (untried (checkId check) OnProtocol (checkSentence check) "the protocol")
    { lawReportExhaustive = True
    }

-- | What came of a check.
checkedReport :: Check -> Checked -> LawReport
checkedReport check checked = case checked of
  CheckHeld -> tried {lawReportOutcome = Held}
  CheckFailed requests wanted got -> failing Failed requests (Just wanted) (Right got)
  CheckErred requests fault -> failing Errored requests Nothing (Left fault)
  where
    tried = (checkReport check) {lawReportCases = 1}
    failing outcome requests wanted got =
      tried
        { lawReportOutcome = outcome,
          lawReportCounterexample =
            Just (counterexample requests wanted "the protocol" got (checkSentence check))
        }

-- | What is reported of a check that the time did not suffice for.
checkTooSlow :: Check -> LawReport
checkTooSlow = outOfTime . checkReport
