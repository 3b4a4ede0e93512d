-- | One law tried on one subject, as it is reported.
module PraTactile.Conformance.Run.One
  ( -- * Subjects at work
    Worker,
    newWorker,

    -- * Trying
    tryWork,
    tryToken,

    -- * Reports of what was not tried
    skipped,
    tooSlow,

    -- * Checks of the protocol
    checkReport,
    checkedReport,
    checkTooSlow,
  )
where

import Data.Aeson (Value (Bool))
import Data.IORef
import Data.List (nub)
import PraTactile.Array (area)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw (isVast)
import PraTactile.Conformance.Process.Reply (profileRequest, profileRequestOf, runRequest)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run.Case
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Run.Trials
import PraTactile.Conformance.Run.Work
import PraTactile.Conformance.Subject
import PraTactile.Format.Error (FormatError)
import PraTactile.Profile (Profile (..))

-- | A subject, and the profile that was put in force last, with what came instead of that.
data Worker = Worker Subject (IORef (Maybe (Profile, Maybe Counterexample)))

-- | Of a subject with no profile in force.
newWorker :: Subject -> IO Worker
newWorker subject = Worker subject <$> newIORef Nothing

-- | Try all cases of a law.
tryWork :: (Subject -> Plan) -> Suite about -> Worker -> Work -> IO LawReport
tryWork planFor suite worker@(Worker subject _) work =
  inForce worker work $
    tryLaw (narrowed work (planFor subject)) subject (workId work) (workCases work)
      >>= reportOf suite work

-- | Try one case of a law.
tryToken ::
  (Subject -> Plan) -> Suite about -> Worker -> Work -> Value -> IO (Either FormatError LawReport)
tryToken planFor suite worker@(Worker subject _) work case' =
  case tryCase (narrowed work (planFor subject)) subject (workCases work) case' of
    Left why -> pure (Left why)
    Right tried -> Right <$> inForce worker work (tried >>= reportOf suite work)

-- | Trials that put profiles in force have the subject for themselves. Of what compares positions
-- fewer cases are drawn where an array has very many of them, and fewer go on at once the more
-- there are: each may be answered by a list of all.
narrowed :: Work -> Plan -> Plan
narrowed work plan = case workProfile work of
  Nothing -> plan {planWindow = 1}
  Just (_, profile)
    | workStage work < OnProof -> plan
    | otherwise ->
      plan
        { planCases = if isVast profile then min 4 (planCases plan) else planCases plan,
          planWindow = max 4 (min (planWindow plan) (50000 `div` cells))
        }
    where
      cells = fromIntegral (max 1 (area (profileShape profile)))

-- | Do it with the profile of the work in force; where that is refused, say so.
inForce :: Worker -> Work -> IO LawReport -> IO LawReport
inForce (Worker subject held) work act = case workProfile work of
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

-- | What came of the cases.
reportOf :: Suite about -> Work -> Tried -> IO LawReport
reportOf suite work tried = case triedFailure tried of
  Just failure -> do
    cause <- likely failure (snd <$> workProfile work)
    pure
      counted
        { lawReportOutcome = outcomeOf (failureTrouble failure),
          lawReportCounterexample = Just (counterexampleOf work failure),
          lawReportLikely = cause
        }
  Nothing
    | triedCases tried == 0 ->
      pure
        (skipped work "no case under this profile")
          { lawReportExhaustive = triedExhaustive tried
          }
    | otherwise -> pure counted {lawReportOutcome = Held}
  where
    counted =
      (blank work)
        { lawReportCases = triedCases tried,
          lawReportExhaustive = triedExhaustive tried
        }
    likely failure profile = case failureTrouble failure of
      Wrong violation ->
        suiteLikely suite profile (nub (violationAsked violation : failureWrong failure))
      Broke {} -> pure Nothing

-- | Whether the law failed, or something else went wrong.
outcomeOf :: Trouble -> Outcome
outcomeOf trouble = case trouble of
  Wrong _ -> Failed
  Broke _ _ (Right (ResponseSkipped _)) -> Failed
  Broke _ _ (Left fault) | faultKind fault == WrongType -> Failed
  Broke {} -> Errored

counterexampleOf :: Work -> Failure -> Counterexample
counterexampleOf work failure =
  made
    { counterShrinks = failureShrinks failure,
      counterToken =
        Just (writeToken (Token (workId work) (snd <$> workProfile work) (failureCase failure)))
    }
  where
    made = case failureTrouble failure of
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
