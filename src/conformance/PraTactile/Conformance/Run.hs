{-# LANGUAGE OverloadedStrings #-}

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
import Data.Aeson (Value (..))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (for_, traverse_)
import Data.IORef
import Data.List (find)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import Data.Traversable (for)
import GHC.Clock (getMonotonicTime)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run.Case
import PraTactile.Conformance.Run.One
import PraTactile.Conformance.Run.Pattern
import PraTactile.Conformance.Run.Token
import PraTactile.Conformance.Run.Work
import PraTactile.Conformance.Subject
import PraTactile.Format.Error (FormatError)

-- | Make the subject's checks, then try all laws that were chosen, under each profile. Several
-- subjects that are alike share the work. The report, and each of its parts as it is made.
--
-- After a timeout or a crash, the laws that need the same operation are skipped.
runSuite :: Settings -> Suite about -> (LawReport -> IO ()) -> [Subject] -> IO Report
runSuite settings suite tell subjects = do
  start <- getMonotonicTime
  stopped <- newIORef False
  unanswered <- newIORef []
  let asks = operationsOf (stagesTried settings)
      offers = filter (`elem` asks) (concatMap subjectOffers (take 1 subjects))
      within late attempt = do
        now <- getMonotonicTime
        let left = start + settingLimit settings - now
        if left > 0 then fromMaybe late <$> withinSeconds left attempt else pure late
      -- The report of an attempt, or why it is not made, or that it took too long.
      judged needs leftOut notTried late attempt = do
        over <- readIORef stopped
        silent <- readIORef unanswered
        let failedBefore = if over then Just leftAlone else Nothing
        one <- case leftOut <|> failedBefore <|> noReplyTo (filter (`elem` silent) needs) of
          Just why -> pure notTried {lawReportNote = Just why}
          Nothing -> within late attempt
        classified <- evaluate (classify settings one)
        when (contradicts classified) $ do
          for_ (operationWithoutReply classified) $ \operation ->
            atomicModifyIORef' unanswered (\before -> (operation : before, ()))
          when (settingFailFast settings) $ writeIORef stopped True
        classified <$ tell classified
  -- How the subject is spoken to comes first: all else rests on it.
  checked <- for (concatMap (checksChosen settings) (take 1 subjects)) $ \check ->
    judged [] Nothing (checkReport check) (checkTooSlow check) $
      checkedReport check <$> checkTry check
  tried <- inParallel subjects (workOf settings offers suite) $ \worker work ->
    judged (workNeeds work) (workLeftOut work) (blank work) (tooSlow work) $
      tryWork (planOf settings) worker work
  end <- getMonotonicTime
  pure
    Report
      { reportSubject = concatMap subjectName (take 1 subjects),
        reportAsks = asks,
        reportOffers = offers,
        reportUnknown = concatMap subjectUnknown (take 1 subjects),
        reportSeed = settingSeed settings,
        reportPartial = not (choosesAll settings),
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
        (tryToken (planOf settings) worker work (tokenCase token))
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
            reportSeconds = end - start,
            reportUnexpected = [],
            reportLaws = [one]
          }

planOf :: Settings -> Subject -> Plan
planOf settings subject =
  Plan
    { planSeed = settingSeed settings,
      planCases = settingCases settings,
      planBatch = subjectBatch subject,
      planShrinks = True
    }

-- | Whether a law failed that is not known to.
contradicts :: LawReport -> Bool
contradicts one = lawReportOutcome one `elem` [Failed, Errored]

-- | The operation that a law ended at, where no reply came.
operationWithoutReply :: LawReport -> Maybe SomeOp
operationWithoutReply report = case lawReportCounterexample report of
  Just one
    | Left fault <- counterGot one,
      faultKind fault /= WrongType,
      Object keys : _ <- reverse (counterRequests one),
      Just (String name) <- KeyMap.lookup "operation" keys ->
      find ((== Text.unpack name) . nameOf) allOperations
  _ -> Nothing

-- | Why a law that needs these operations is skipped.
noReplyTo :: [SomeOp] -> Maybe String
noReplyTo operations = case operations of
  [] -> Nothing
  one : _ -> Just ("not asked: there was no reply to " ++ nameOf one ++ " before")

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
