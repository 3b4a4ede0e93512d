-- | Running a suite on a subject: the laws one after the other, or shared among several processes
-- of the same subject, within a time for all, to a report.
module PraTactile.Conformance.Run
  ( module PraTactile.Conformance.Run.Work,
    runSuite,
    countWork,
    replay,
  )
where

import Control.Applicative ((<|>))
import Control.Concurrent
import Control.Exception
import Control.Monad (forM, when)
import Data.Foldable (for_, traverse_)
import Data.IORef
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Traversable (for)
import GHC.Clock (getMonotonicTime)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run.Case
import PraTactile.Conformance.Run.One
import PraTactile.Conformance.Run.Pattern
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Run.Unanswered
import PraTactile.Conformance.Run.Work
import PraTactile.Conformance.Subject
import PraTactile.Format.Error (FormatError)

-- | Try all laws that were chosen on a subject, of which several may be given that are alike; then
-- how it is spoken to. The report, and each of its parts as it is made.
--
-- Under the first profile all cases are tried at once, and then a glance is taken at everything
-- else, a tenth of its cases: what only one of the last profiles shows is so told about as soon as
-- what all of them show. If something fails, that is what there is to mend, and nothing more is
-- tried; otherwise the other cases are.
runSuite :: Settings -> Suite about -> (LawReport -> IO ()) -> [Subject] -> IO Report
runSuite settings suite tell subjects = do
  start <- getMonotonicTime
  let budget = Budget (start + settingLimit settings) (settingFailFast settings)
      asks = operationsOf (stagesTried settings)
      offers = filter (`elem` asks) (concatMap subjectOffers (take 1 subjects))
      work = workOf settings offers suite
      checks = concatMap (checksChosen settings) (take 1 subjects)
  stopped <- newIORef False
  unanswered <- newIORef nothingUnanswered
  let judged one = do
        classified <- evaluate (classify settings one)
        when (contradicts classified) $ do
          atomicModifyIORef' unanswered (\before -> (noted classified before, ()))
          when (settingFailFast settings) $ writeIORef stopped True
        pure classified
      told one = one <$ tell one
      try' share worker one = do
        notAsked <- (`whyNotAsked` workNeeds one) <$> readIORef unanswered
        tryWithin
          budget
          stopped
          (tryWork (planOf share settings) suite worker one)
          one {workLeftOut = workLeftOut one <|> notAsked}
          >>= judged
      soon worker one = try' (if wholeSoon suite one then Whole else AtAGlance) worker one
      atLength worker (one, before)
        | wholeSoon suite one || lawReportOutcome before == KnownFailure = pure before
        | otherwise = together before <$> try' TheOthers worker one
  -- How it is spoken to comes first: it is quickly seen, and all else rests on it.
  checked <- for checks $ \check -> do
    notAsked <- (`whyNotAsked` []) <$> readIORef unanswered
    let leftOut why = pure (checkReport check) {lawReportNote = Just why}
    maybe (checkWithin budget stopped check) leftOut notAsked >>= judged >>= told
  first <- inParallel subjects work soon
  let glance = any contradicts (first ++ checked) && not (all (wholeSoon suite) work)
  tried <-
    if glance
      then traverse told first
      else inParallel subjects (zip work first) (\worker one -> atLength worker one >>= told)
  end <- getMonotonicTime
  pure
    Report
      { reportSubject = concatMap subjectName (take 1 subjects),
        reportAsks = asks,
        reportOffers = offers,
        reportUnknown = concatMap subjectUnknown (take 1 subjects),
        reportSeed = settingSeed settings,
        reportPartial = not (choosesAll settings),
        reportGlance = glance,
        reportSeconds = end - start,
        reportUnexpected = unexpected settings (tried ++ checked),
        reportLaws = tried ++ checked
      }

-- | How many parts the report of such a run has.
countWork :: Settings -> Suite about -> Subject -> Int
countWork settings suite subject =
  length (workOf settings (subjectOffers subject) suite) + length (checksChosen settings subject)

-- | Try the case of a token again. 'Nothing' where no law has its name.
replay ::
  Settings -> Suite about -> Token -> Subject -> IO (Maybe (Either FormatError Report))
replay settings suite token subject = for (workFor suite token) $ \work -> do
  start <- getMonotonicTime
  worker <- newWorker subject
  tried <-
    fromMaybe (Right (tooSlow work))
      <$> withinSeconds
        (settingLimit settings)
        (tryToken (planOf Whole settings) suite worker work (tokenCase token))
  end <- getMonotonicTime
  let asks = operationsOf [workStage work]
  pure $ case tried of
    Left why -> Left why
    Right one ->
      Right
        Report
          { reportSubject = subjectName subject,
            reportAsks = asks,
            reportOffers = filter (`elem` asks) (subjectOffers subject),
            reportUnknown = subjectUnknown subject,
            reportSeed = settingSeed settings,
            reportPartial = True,
            reportGlance = False,
            reportSeconds = end - start,
            reportUnexpected = [],
            reportLaws = [one]
          }

planOf :: Share -> Settings -> Subject -> Plan
planOf share settings subject =
  Plan
    { planSeed = settingSeed settings,
      planCases = settingCases settings,
      planWindow = subjectBatch subject,
      planBrief = False,
      planShare = share
    }

-- | Whether all of it is tried before a glance is taken at the rest: what is of profiles, and what
-- is under the first one.
wholeSoon :: Suite about -> Work -> Bool
wholeSoon suite work = case workProfile work of
  Just (name, _) -> name `elem` map fst (take 1 (suiteProfiles suite))
  Nothing -> workStage work == OnProfile

-- | Whether something failed that is not known to.
contradicts :: LawReport -> Bool
contradicts one = lawReportOutcome one `elem` [Failed, Errored]

-- | What came of a law at a glance and of its other cases.
together :: LawReport -> LawReport -> LawReport
together before after
  | lawReportOutcome after == Skipped = before {lawReportExhaustive = lawReportExhaustive after}
  | otherwise = after {lawReportCases = lawReportCases before + lawReportCases after}

-- | When all must be done, and whether the first failure ends it.
data Budget = Budget Double Bool

-- | The report of some work, if there is time for it; otherwise it says so.
tryWithin :: Budget -> IORef Bool -> IO LawReport -> Work -> IO LawReport
tryWithin budget stopped try' work
  | Just reason <- workLeftOut work = pure (skipped work reason)
  | otherwise = withinBudget budget stopped (skipped work leftAlone) (tooSlow work) try'

-- | The report of a check, likewise.
checkWithin :: Budget -> IORef Bool -> Check -> IO LawReport
checkWithin budget stopped check =
  withinBudget
    budget
    stopped
    (checkReport check) {lawReportNote = Just leftAlone}
    (checkTooSlow check)
    (checkedReport check <$> checkTry check)

-- | What comes of an attempt, or the first of these reports where a failure has ended it all, or
-- the second where the time is over, before the attempt or during it.
withinBudget :: Budget -> IORef Bool -> LawReport -> LawReport -> IO LawReport -> IO LawReport
withinBudget (Budget deadline failFast) stopped ended late attempt = do
  over <- readIORef stopped
  now <- getMonotonicTime
  let left = deadline - now
      outcome
        | over && failFast = pure ended
        | left <= 0 = pure late
        | otherwise = fromMaybe late <$> withinSeconds left attempt
  outcome

-- | Why something is not tried.
leftAlone :: String
leftAlone = "not tried: another law failed before it"

checksChosen :: Settings -> Subject -> [Check]
checksChosen settings subject =
  [ check
    | check <- subjectChecks subject,
      OnProtocol `elem` stagesTried settings,
      null (settingRun settings) || any (`matches` checkId check) (settingRun settings),
      settingSkipMustFail settings || not (any (`matches` checkId check) (settingSkip settings))
  ]

-- | A failure of a law that must fail is a known one.
classify :: Settings -> LawReport -> LawReport
classify settings one
  | contradicts one,
    any (`matches` lawReportId one) (mustFail settings) =
    one {lawReportOutcome = KnownFailure}
  | otherwise = one

-- | The patterns of laws that must fail of which some were tried and none did.
unexpected :: Settings -> [LawReport] -> [String]
unexpected settings reports =
  [ pattern'
    | pattern' <- mustFail settings,
      let outcomes = [lawReportOutcome one | one <- reports, pattern' `matches` lawReportId one],
      Held `elem` outcomes,
      KnownFailure `notElem` outcomes
  ]

-- | Do all of it, each worker taking what comes next; the results in the order of the work.
inParallel :: [Subject] -> [work] -> (Worker -> work -> IO a) -> IO [a]
inParallel subjects work act = case subjects of
  [subject] -> newWorker subject >>= forM work . act
  _ -> do
    queue <- newMVar (zip [0 :: Int ..] work)
    results <- newMVar Map.empty
    ends <- mask_ . for subjects $ \subject -> do
      ended <- newEmptyMVar
      thread <- forkIOWithUnmask $ \unmasked ->
        try (unmasked (newWorker subject >>= worked queue results)) >>= putMVar ended
      pure (thread, ended)
    let await (_, ended) = takeMVar ended >>= either (throwIO :: SomeException -> IO ()) pure
    traverse_ await ends `onException` for_ ends (killThread . fst)
    Map.elems <$> readMVar results
  where
    worked queue results worker = do
      next <- modifyMVar queue $ \left -> pure $ case left of
        [] -> ([], Nothing)
        first : others -> (others, Just first)
      for_ next $ \(i, one) -> do
        report <- act worker one
        modifyMVar_ results (pure . Map.insert i report)
        worked queue results worker
