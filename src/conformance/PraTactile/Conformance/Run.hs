{-# LANGUAGE OverloadedStrings #-}

-- | Runs a suite on a subject and reports. Laws are tried in turn, or shared among several
-- processes of the same subject, within a time limit for the whole run.
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

-- | Runs the subject's checks, then all chosen laws under each profile. Equal subjects share the
-- work. Returns the report, and passes each part to the action when it is ready.
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
      -- The report of an attempt, or the reason why it is not made, or that it took too long.
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
  -- The checks of the protocol come first, because everything else depends on them.
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

-- | The number of parts of the report of such a run.
countWork :: Settings -> Suite about -> Subject -> Int
countWork settings suite subject =
  length (workOf settings (subjectOffers subject) suite) + length (checksChosen settings subject)

-- | Tries the case of a token again. 'Nothing' if its law is unknown.
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

-- | Whether a law failed or erred unexpectedly.
contradicts :: LawReport -> Bool
contradicts one = lawReportOutcome one `elem` [Failed, Errored]

-- | The operation that got no reply.
operationWithoutReply :: LawReport -> Maybe SomeOp
operationWithoutReply report = case lawReportCounterexample report of
  Just one
    | Left fault <- counterGot one,
      faultKind fault /= WrongType,
      Object keys : _ <- reverse (counterRequests one),
      Just (String name) <- KeyMap.lookup "operation" keys ->
      find ((== Text.unpack name) . nameOf) allOperations
  _ -> Nothing

-- | The note on a skipped law; the operations are those it needs that got no reply.
noReplyTo :: [SomeOp] -> Maybe String
noReplyTo operations = case operations of
  [] -> Nothing
  one : _ -> Just ("not asked: there was no reply to " ++ nameOf one ++ " before")

-- | The note on a law that is not tried because another failed.
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

-- | Marks the failure of a law that must fail as known.
classify :: Settings -> LawReport -> LawReport
classify settings one
  | contradicts one,
    any (`matches` lawReportId one) (mustFail settings) =
    one {lawReportOutcome = KnownFailure}
  | otherwise = one

-- | The patterns of laws that must fail of which some were tried and none failed.
unexpected :: Settings -> [LawReport] -> [String]
unexpected settings reports =
  [ pattern'
    | pattern' <- mustFail settings,
      let outcomes = [lawReportOutcome one | one <- reports, pattern' `matches` lawReportId one],
      Held `elem` outcomes,
      KnownFailure `notElem` outcomes
  ]

-- | Does all work; each worker takes the next item. The results are in the order of the work.
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
