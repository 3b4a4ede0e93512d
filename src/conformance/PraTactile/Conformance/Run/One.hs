-- | Tries one law on one subject, and reports it.
module PraTactile.Conformance.Run.One
  ( -- * Workers
    Worker,
    newWorker,

    -- * Trying
    tryWork,
    tryToken,

    -- * Laws not tried
    blank,
    tooSlow,

    -- * Protocol checks
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

-- | A subject with the state of its use.
data Worker = Worker
  { workerSubject :: Subject,
    -- | The profile that was last put in force, and the failure if it was not accepted.
    workerForce :: IORef (Maybe (Profile, Maybe Counterexample)),
    -- | The ids of the laws that failed.
    workerFailed :: IORef (Set.Set String)
  }

-- | A worker whose subject has no profile in force.
newWorker :: Subject -> IO Worker
newWorker subject = Worker subject <$> newIORef Nothing <*> newIORef Set.empty

-- | Tries all cases of a law. A failing case is shrunk and asked again in a fresh process, unless
-- the law failed before under another profile.
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

-- | The note of an order law on an answer that is wrong in any order; other laws find it.
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

-- | Tries one case of a law.
tryToken :: (Subject -> Plan) -> Worker -> Work -> Value -> IO (Either FormatError LawReport)
tryToken planFor worker work case' =
  traverse
    (\tried -> inForce worker work (reportOf work False <$> tried))
    (tryCase (alone work (planFor subject)) subject (workCases work) case')
  where
    subject = workerSubject worker

-- | Trials that open profiles, and trials of touch and of objects, are made one at a time.
alone :: Work -> Plan -> Plan
alone work plan = plan {planBatch = maybe 1 (const (planBatch plan)) (workProfile work)}

-- | Runs the action with the work's profile in force; if the profile is refused, reports that.
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

-- | The failure of putting a profile in force, if it failed.
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

-- | The report of a law's cases. The flag tells whether the failing one depends on earlier
-- requests.
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

-- | The outcome: the law failed, or something else went wrong.
outcomeOf :: Trouble -> LawOutcome
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

-- | Why a reply is not an answer.
reasonFor :: Either Fault Response -> String
reasonFor got = case got of
  Right (ResponseSkipped _) -> "what is offered is answered or refused, not skipped"
  Right _ -> "an error of the subject is no answer"
  Left fault | faultKind fault == WrongType -> "the result has another type"
  Left _ -> "a request has one reply, within the time limit"

-- | The requests of exchanges, in the protocol's JSON.
requestsOf :: [Exchange] -> [Value]
requestsOf = zipWith request [1 ..]
  where
    request i (Exchange operation input _) = case operation of
      Just name -> runRequest i (SomeQuestion (Raw name input))
      Nothing -> profileRequestOf input

-- | An empty report of a law.
blank :: Work -> LawReport
blank work =
  (untried (workId work) (workStage work) (workSentence work) (workSource work))
    { lawReportNeeds = workNeeds work,
      lawReportProfile = fst <$> workProfile work
    }

-- | The report of a law that was not tried, with the reason.
skipped :: Work -> String -> LawReport
skipped work reason = (blank work) {lawReportNote = Just reason}

-- | The report of a law that was not finished within the time limit.
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

-- | The empty report of a check.
checkReport :: Check -> LawReport
checkReport check =
  (untried (checkId check) OnProtocol (checkSentence check) "the protocol")
    { lawReportExhaustive = True
    }

-- | The report of a check with its result.
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

-- | The report of a check that was not finished within the time limit.
checkTooSlow :: Check -> LawReport
checkTooSlow = outOfTime . checkReport
