-- | The protocol with a process that answers many requests in turn. A process that fails is
-- killed, and a new one takes its place with the same profile.
module PraTactile.Conformance.Process.Session
  ( Session,
    Limits (..),
    withSession,
    opening,
    sessionStarted,
    putProfile,
    askAll,
    anew,

    -- * For protocol checks
    withStarted,
  )
where

import Control.Exception
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.IORef
import Data.Maybe (fromMaybe)
import PraTactile.Conformance.Process.Await
import PraTactile.Conformance.Process.Child
import PraTactile.Conformance.Process.Reply
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Wire.Line (longestLine)
import PraTactile.Profile (Profile)

-- | Time limits.
data Limits = Limits
  { -- | For the reply to each request, in seconds.
    limitReply :: Double,
    -- | For everything before the subject can be used, in seconds.
    limitOpening :: Double
  }

-- | A command with its running process, if there is one.
data Session = Session
  { sessionCommand :: Command,
    sessionLimits :: Limits,
    sessionStarted :: Started,
    sessionChild :: IORef (Maybe Child),
    -- | The profile that was last put in force.
    sessionProfile :: IORef (Maybe Profile),
    -- | The number of the next request.
    sessionNext :: IORef Int
  }

-- | Starts a command, runs the action, and kills the process in any case. 'Left' if it cannot be
-- started or never answers.
withSession :: Limits -> Command -> (Session -> IO a) -> IO (Either Fault a)
withSession limits command use = do
  held <- newIORef Nothing
  flip finally (letGo held) $ do
    started <- opening limits (begun limits command held)
    case started of
      Left fault -> pure (Left fault)
      Right said -> do
        session <- Session command limits said held <$> newIORef Nothing <*> newIORef 1
        Right <$> use session

-- | The result of an action, within the limit for opening.
opening :: Limits -> IO (Either Fault a) -> IO (Either Fault a)
opening limits = fmap (fromMaybe (Left timeOver)) . withinSeconds (limitOpening limits)

-- | Starts the command and waits for its first reply.
begun :: Limits -> Command -> IORef (Maybe Child) -> IO (Either Fault Started)
begun limits command held = mask $ \unmasked -> do
  letGo held
  started <- begin command
  case started of
    Left problem -> pure (Left (Fault CannotStart problem))
    Right child -> do
      writeIORef held (Just child)
      unmasked $ do
        send child (requestLine startRequest)
        reply <- awaitLine child (limitReply limits)
        either (fmap Left . flooded child 1) (pure . Right) (reply >>= readStarted)

letGo :: IORef (Maybe Child) -> IO ()
letGo held = mask_ $ do
  child <- readIORef held
  mapM_ end child
  writeIORef held Nothing

-- | Kills the process. The next request starts another one, in which no profile is in force.
anew :: Session -> IO ()
anew session = letGo (sessionChild session) >> writeIORef (sessionProfile session) Nothing

-- | Runs an action with its own newly started process.
withStarted :: Session -> (Child -> IO (Either Fault a)) -> IO (Either Fault a)
withStarted session use = do
  held <- newIORef Nothing
  flip finally (letGo held) $ do
    started <- begun (sessionLimits session) (sessionCommand session) held
    child <- readIORef held
    case (started, child) of
      (Right _, Just one) -> use one
      (Left fault, _) -> pure (Left fault)
      _ -> pure (Left (Fault CannotStart "it has ended"))

-- | The process, restarted if there is none, with its profile in force.
current :: Session -> IO (Either Fault Child)
current session = do
  there <- readIORef (sessionChild session)
  case there of
    Just child -> pure (Right child)
    Nothing -> do
      started <- begun (sessionLimits session) (sessionCommand session) (sessionChild session)
      child <- readIORef (sessionChild session)
      profile <- readIORef (sessionProfile session)
      case (started, child) of
        (Right _, Just one) -> do
          again <- maybe (pure (Right (ResponseErrored ""))) (profileOn session one) profile
          either (failed session) (const (pure (Right one))) again
        (Left fault, _) -> failed session fault
        _ -> failed session (Fault CannotStart "it has ended")

failed :: Session -> Fault -> IO (Either Fault a)
failed session fault = Left fault <$ letGo (sessionChild session)

-- | Puts a profile in force; returns the response.
putProfile :: Session -> Profile -> IO (Either Fault Response)
putProfile session profile = do
  child <- current session
  got <- either (pure . Left) (\one -> profileOn session one profile) child
  writeIORef (sessionProfile session) (if inForce got then Just profile else Nothing)
  either (failed session) (pure . Right) got
  where
    inForce got = case got of
      Right (ResponseResult _) -> True
      _ -> False

profileOn :: Session -> Child -> Profile -> IO (Either Fault Response)
profileOn session child profile = do
  send child (requestLine (profileRequest profile))
  line <- awaitLine child (limitReply (sessionLimits session))
  either (fmap Left . flooded child 1) (pure . Right) (line >>= fmap replyResponse . readReply)

-- | Asks questions; returns their replies in order, up to the first fault.
askAll :: Session -> [SomeQuestion] -> IO [Either Fault Response]
askAll session questions = do
  (got, fault) <- exchangeAgain (startedInFlight (sessionStarted session)) questions
  case fault of
    Nothing -> pure (map Right got)
    Just why
      | length suspects <= 1 -> pure (map Right got ++ [Left why])
      | otherwise -> do
        -- The questions in flight are asked again one by one, which shows the one at fault.
        (alone, again) <- exchangeAgain 1 suspects
        pure (map Right got ++ maybe [Left why] (\f -> map Right alone ++ [Left f]) again)
      where
        suspects =
          take (startedInFlight (sessionStarted session)) (drop (length got) questions)
  where
    exchangeAgain window asked = do
      child <- current session
      (got, fault) <-
        either (\why -> pure ([], Just why)) (\one -> exchange session one window asked) child
      mapM_ (const (letGo (sessionChild session))) fault
      pure (got, fault)

-- | Asks questions with at most @window@ requests in flight, fewer if replies are long. After a
-- mebibyte of replies it stops; the remaining questions must be asked again. So the amount at once
-- is bounded, whatever the process answers.
exchange :: Session -> Child -> Int -> [SomeQuestion] -> IO ([Response], Maybe Fault)
exchange session child window questions = do
  first <- readIORef (sessionNext session)
  let count = length questions
      requests = zipWith (\i -> requestLine . runRequest i) [first ..] questions
  writeIORef (sessionNext session) (first + count)
  go first first requests [] 0 (longestLine `div` 4)
  where
    -- The state: the number of the next reply, the number of the next request, the requests not yet
    -- sent, the replies, their total length, and the recent length of a reply.
    go next unsent requests got whole long
      | next == unsent && null requests = pure (reverse got, Nothing)
      | next == unsent && whole > longestLine = pure (reverse got, Nothing)
      | not (null requests) && whole <= longestLine && unsent - next <= open `div` 2 = do
        let (now, later) = splitAt (open - (unsent - next)) requests
        send child (mconcat now)
        go next (unsent + length now) later got whole long
      | otherwise = do
        line <- awaitLine child (limitReply (sessionLimits session))
        let size = either (const 0) Bytes.length line
        case line >>= answerTo next of
          Right one ->
            go (next + 1) unsent requests (one : got) (whole + size) (max size (3 * long `div` 4))
          Left fault -> do
            why <- flooded child (unsent - next) fault
            pure (reverse got, Just why)
      where
        open = max 1 (min window (longestLine `div` max 1 long))

-- | Reads a line as the reply to the request with this number.
answerTo :: Int -> ByteString -> Either Fault Response
answerTo number line = do
  reply <- readReply line
  case replySequence reply of
    Just given
      | given == toInteger number -> Right (replyResponse reply)
      | given < toInteger number && given >= 1 ->
        Left (Fault AnsweredTwice (instead ("answered " ++ show given ++ " again")))
      | otherwise -> Left (Fault OutOfOrder (instead ("answered " ++ show given)))
    Nothing -> Left (Fault NotAReply (instead "a reply without \"sequence\""))
  where
    instead what = what ++ " where " ++ show number ++ " was to be answered: " ++ excerpt line
