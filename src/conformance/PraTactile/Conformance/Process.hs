-- | A subject in another process, in any language. It speaks the protocol: JSON lines on standard
-- input and output. Any other behaviour becomes a named fault.
--
-- 'Command' is the program with its arguments, 'Limits' has the time limits in seconds, and
-- 'checkTexts' lists the ids and sentences of the protocol's checks ('subjectChecks').
module PraTactile.Conformance.Process
  ( Command (..),
    Mode (..),
    Limits (..),
    withProcess,
    checkTexts,
  )
where

import Data.IORef
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Process.Checks
import PraTactile.Conformance.Process.Child (Command (..))
import PraTactile.Conformance.Process.OneShot
import PraTactile.Conformance.Process.Reply (Started (..))
import PraTactile.Conformance.Process.Session
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Profile (Profile, canonicalProfile)
import System.FilePath (takeFileName)

-- | How a command is used.
data Mode
  = -- | One process answers many requests.
    InSession
  | -- | One process per request.
    OneShot
  deriving stock (Eq, Show)

-- | Starts a command and uses it as a subject. In the end all its processes are gone. 'Left' has
-- the fault of the start: the command cannot be started, or gives no valid first reply in time.
-- Later faults are results of the subject's actions. Link the program that calls this with
-- @-threaded@; the command may be any program.
withProcess :: Mode -> Limits -> Command -> (Subject -> IO a) -> IO (Either Fault a)
withProcess mode limits command use = case mode of
  InSession -> withSession limits command (use . inSession limits)
  OneShot ->
    opening limits (offeredOneShot limits command canonicalProfile)
      >>= traverse (\offers -> inOneShot limits command offers >>= use)

inSession :: Limits -> Session -> Subject
inSession limits session =
  Subject
    { subjectName = startedName started,
      subjectOffers = [known | known <- allOperations, nameOf known `elem` said],
      subjectProfile = putProfile session,
      subjectAsk = askAll session,
      subjectFresh = Just (anew session),
      subjectBatch = max 64 (min 1024 (8 * startedInFlight started)),
      subjectUnknown = filter (`notElem` map nameOf allOperations) said,
      subjectChecks = sessionChecks limits session
    }
  where
    started = sessionStarted session
    said = startedOperations started

inOneShot :: Limits -> Command -> [SomeOp] -> IO Subject
inOneShot limits command offers = do
  force <- newIORef (canonicalProfile :: Profile)
  pure
    Subject
      { subjectName = takeFileName (commandProgram command),
        subjectOffers = offers,
        subjectProfile = \profile -> do
          writeIORef force profile
          oneShot limits command profile Nothing,
        subjectAsk = \questions -> do
          profile <- readIORef force
          upToFault [oneShot limits command profile (Just one) | one <- zip [1 ..] questions],
        -- Each request has a fresh process anyway.
        subjectFresh = Just (pure ()),
        subjectBatch = 32,
        subjectUnknown = [],
        subjectChecks = oneShotChecks limits command
      }
