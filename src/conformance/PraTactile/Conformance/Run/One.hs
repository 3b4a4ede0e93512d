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
import Data.List (isSuffixOf, nub)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, listToMaybe)
import PraTactile.Array (area)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Order (orderName)
import PraTactile.Conformance.Process.Reply (profileRequest, profileRequestOf, runRequest)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run.Case
import PraTactile.Conformance.Run.Fresh
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Run.Trials (Trouble (..), itemsOf)
import PraTactile.Conformance.Run.Work
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Wire (questionInput)
import PraTactile.Format.Error (FormatError)
import PraTactile.Profile (Profile (..))

-- | A subject at work.
data Worker = Worker
  { workerSubject :: Subject,
    -- | What it was asked.
    workerPast :: IO [Asked],
    -- | How many questions it has replied to, and how many of these replies were long.
    workerReplied :: IO Int,
    workerLong :: IO Int,
    -- | The profile that was put in force last, with what came instead of that.
    workerForce :: IORef (Maybe (Profile, Maybe Counterexample)),
    -- | The laws that failed, and under how many profiles by long answers.
    workerFailed :: IORef (Map String Int),
    -- | How many items there is still room for in the cases that are kept.
    workerRoom :: IORef Int,
    -- | How many requests may still be asked to find what failures depend on.
    workerAgain :: IORef Int
  }

-- | Of a subject with no profile in force.
newWorker :: Subject -> IO Worker
newWorker subject = do
  (noting, past, replied, long) <- remembering subject
  Worker noting past replied long <$> newIORef Nothing
    <*> newIORef Map.empty
    <*> newIORef 100000
    <*> newIORef 20000

-- | Try all cases of a law. Of one that failed under another profile the first case that fails is
-- enough: why it does is told there. After three profiles under which it failed by long answers it
-- is not tried under others.
tryWork :: (Subject -> Plan) -> Suite about -> Worker -> Work -> IO LawReport
tryWork planFor suite worker work = do
  before <- readIORef (workerFailed worker)
  case Map.lookup (workId work) before of
    Just long | long >= mostLong -> pure (skipped work failedAtLength)
    known' -> inForce worker work $ do
      longBefore <- workerLong worker
      let brief = isJust known'
          usual = (narrowed work (planFor subject)) {planBrief = brief}
          -- Of answers that are long and wrong few are asked for that nobody looks at.
          plan = if sum before > 0 then usual {planWindow = min 2 (planWindow usual)} else usual
          atLength = not brief && Map.size before < mostAgain
          ofOrder = ("/" ++ orderName) `isSuffixOf` workId work
      tried <-
        if ofOrder
          then tryOrder plan worker work
          else tryLaw plan subject (workId work) (workCases work)
      longAfter <- workerLong worker
      let isLong = if longAfter > longBefore then 1 else 0
      keptBy worker =<< case triedFailure tried of
        Just failure -> do
          writeIORef (workerFailed worker) (Map.insertWith (+) (workId work) isLong before)
          depends <- if atLength then dependenceOf plan worker work failure else pure OnItself
          reportOf (if brief then withoutCause else suite) work depends tried
        Nothing
          | ofOrder && triedCases tried == 0 -> pure (skipped work wrongThemselves)
          | otherwise -> reportOf suite work OnItself tried
  where
    subject = workerSubject worker
    withoutCause = suite {suiteLikely = \_ _ -> pure Nothing}

-- | Try the law that answers do not depend on what was asked before. A wrong answer that a fresh
-- process gives to the same question alone does not depend on that: it counts as the right one
-- here, and other laws find it. After 'mostExcused' of them nothing is said of the law.
tryOrder :: Plan -> Worker -> Work -> IO Tried
tryOrder plan worker work = go []
  where
    subject = workerSubject worker
    law excused how =
      tryLaw how (excusing excused subject) (workId work) (workCases work)
    go excused = do
      tried <- law excused plan {planBrief = True}
      case (failureTrouble <$> triedFailure tried, subjectFresh subject) of
        (Just (Wrong violation), Just fresh)
          | Exchange (Just operation) input reply : _ <- reverse (violationAsked violation) -> do
            fresh
            mapM_ (subjectProfile subject . snd) (workProfile work)
            alone <- subjectAsk subject [SomeQuestion (Raw operation input)]
            let right = responseOf (violationExpected violation)
            if alone /= [Right (responseOf reply)]
              then law excused plan
              else
                if length excused < mostExcused
                  then go ((operation, input, responseOf reply, right) : excused)
                  else pure tried {triedCases = 0, triedFailure = Nothing}
        _ -> pure tried

-- | How many answers that are wrong by themselves the law of the order bears.
mostExcused :: Int
mostExcused = 10

-- | The subject, with other replies in the place of these, to these questions.
excusing :: [(Operation, Value, Response, Response)] -> Subject -> Subject
excusing excused subject
  | null excused = subject
  | otherwise =
    subject {subjectAsk = \questions -> zipWith excuse questions <$> subjectAsk subject questions}
  where
    excuse (SomeQuestion question) got =
      fromMaybe got . listToMaybe $
        [ Right right
          | (operation, input, wrong, right) <- excused,
            got == Right wrong,
            operationOf question == operation,
            questionInput question == input
        ]

-- | Under how many profiles a law fails by long answers before it is not tried under others.
mostLong :: Int
mostLong = 3

wrongThemselves :: String
wrongThemselves = "not tried: too many answers are wrong whatever was asked before"

failedAtLength :: String
failedAtLength = "not tried: it failed under three profiles before, by long answers"

-- | The report without its case if that is long and there is no room for it beside the others.
keptBy :: Worker -> LawReport -> IO LawReport
keptBy worker report = do
  room <- readIORef (workerRoom worker)
  let left = room - items
  if left >= 0 || items < 2000
    then report <$ writeIORef (workerRoom worker) left
    else pure report {lawReportCounterexample = Nothing, lawReportNote = Just tooLong}
  where
    tooLong = "the case is too long to be kept beside those before it"
    items = maybe 0 caseItems (lawReportCounterexample report)
    -- All of it, so that nothing else is kept for its sake.
    caseItems one =
      length (counterReason one) + maybe 0 length (counterToken one)
        + sum (map itemsOf (counterRequests one))
        + either (length . faultDetail) (itemsOf . snd . responseItem) (counterGot one)
        + maybe 0 (itemsOf . snd . responseItem) (counterExpected one)

-- | What a failure depends on.
dependenceOf :: Plan -> Worker -> Work -> Failure -> IO Dependence
dependenceOf plan worker work failure = do
  replied <- workerReplied worker
  case tryCase plan subject (workCases work) (failureCase failure) of
    -- Who has never replied does not depend on what was asked before.
    _ | replied == 0 -> pure OnItself
    Left _ -> pure OnItself
    Right again -> do
      asked <- workerPast worker
      let comesAgain = isJust . triedFailure <$> again
      depends <- dependence (workerAgain worker) subject profile asked comesAgain
      depends <$ writeIORef (workerForce worker) Nothing
  where
    subject = workerSubject worker
    profile = snd <$> workProfile work

-- | Of how many laws a failure is tried again: as many as are told of at length.
mostAgain :: Int
mostAgain = 10

-- | Try one case of a law.
tryToken ::
  (Subject -> Plan) -> Suite about -> Worker -> Work -> Value -> IO (Either FormatError LawReport)
tryToken planFor suite worker work case' =
  case tryCase (narrowed work (planFor subject)) subject (workCases work) case' of
    Left why -> pure (Left why)
    Right tried -> Right <$> inForce worker work (tried >>= reportOf suite work OnItself)
  where
    subject = workerSubject worker

-- | Trials that put profiles in force have the subject for themselves. Where an array has many
-- positions, fewer cases are drawn of what compares them, and fewer go on at once: each may be
-- answered by a list of all.
narrowed :: Work -> Plan -> Plan
narrowed work plan = case workProfile work of
  Nothing -> plan {planWindow = 1}
  Just (_, profile)
    | workStage work < OnProof -> plan
    | otherwise ->
      plan
        { planCases = if cells > 1024 then max 1 (planCases plan `div` 5) else planCases plan,
          planWindow = max 4 (min (planWindow plan) (50000 `div` cells))
        }
    where
      cells = fromIntegral (max 1 (area (profileShape profile)))

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

-- | What came of the cases.
reportOf :: Suite about -> Work -> Dependence -> Tried -> IO LawReport
reportOf suite work depends tried = case triedFailure tried of
  Just failure -> do
    cause <- likely failure (snd <$> workProfile work)
    pure
      counted
        { lawReportOutcome = outcomeOf (failureTrouble failure),
          lawReportCounterexample = Just (counterexampleOf work depends failure),
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

counterexampleOf :: Work -> Dependence -> Failure -> Counterexample
counterexampleOf work depends failure =
  alone
    { counterShrinks = failureShrinks failure,
      counterEarlier = earlier,
      counterRequests =
        zipWith requestOf [1 - length before' ..] before' ++ counterRequests alone,
      counterToken =
        case earlier of
          Nothing -> Just token
          Just _ -> Nothing
    }
  where
    token = writeToken (Token (workId work) (snd <$> workProfile work) (failureCase failure))
    (earlier, before') = case depends of
      OnItself -> (Nothing, [])
      OnEarlier some -> (Just (length some), some)
      OnUnknown -> (Just 0, [])
    alone = case failureTrouble failure of
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
