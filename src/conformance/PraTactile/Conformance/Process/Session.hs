-- | The protocol with a process that answers many requests, one after the other. A process that
-- fails is ended; another one takes its place and its profile.
module PraTactile.Conformance.Process.Session
  ( Session,
    Limits (..),
    withSession,
    opening,
    sessionStarted,
    putProfile,
    askAll,
    anew,

    -- * For the laws of the protocol
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

-- | How long is waited.
data Limits = Limits
  { -- | For the reply to each request, seconds.
    limitReply :: Double,
    -- | For all that is asked before the subject can be used, seconds.
    limitOpening :: Double
  }

-- | A process of a command, or none at the moment.
data Session = Session
  { sessionCommand :: Command,
    sessionLimits :: Limits,
    sessionStarted :: Started,
    sessionChild :: IORef (Maybe Child),
    -- | The profile that was put in force last.
    sessionProfile :: IORef (Maybe Profile),
    -- | The number of the next request.
    sessionNext :: IORef Int
  }

-- | Start a command and use it; it is ended afterwards, however that ends. 'Left' where it cannot
-- be started, or never answers.
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

-- | What comes of an action, if that comes in the time for what is asked first.
opening :: Limits -> IO (Either Fault a) -> IO (Either Fault a)
opening limits = fmap (fromMaybe (Left timeOver)) . withinSeconds (limitOpening limits)

-- | Start the command and await its first reply.
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

-- | End the process; the next request goes to another one, in which no profile is in force.
anew :: Session -> IO ()
anew session = letGo (sessionChild session) >> writeIORef (sessionProfile session) Nothing

-- | A process of its own that was started, for an action.
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

-- | The process, started again if there is none, with its profile in force.
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

-- | Put a profile in force; what came.
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

-- | Ask questions; their replies in order, up to the first fault.
askAll :: Session -> [SomeQuestion] -> IO [Either Fault Response]
askAll session questions = do
  (got, fault) <- exchangeAgain (startedInFlight (sessionStarted session)) questions
  case fault of
    Nothing -> pure (map Right got)
    Just why
      | length suspects <= 1 -> pure (map Right got ++ [Left why])
      | otherwise -> do
        -- Which of those that waited for a reply is at fault shows when each is asked alone.
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

-- | Ask, with so many requests at most that wait for their replies, and with fewer of them where
-- replies are long; after a mebibyte of replies the rest is left to be asked another time. So what
-- comes at once has an end, whatever the process answers.
exchange :: Session -> Child -> Int -> [SomeQuestion] -> IO ([Response], Maybe Fault)
exchange session child window questions = do
  first <- readIORef (sessionNext session)
  let count = length questions
      requests = zipWith (\i -> requestLine . runRequest i) [first ..] questions
  writeIORef (sessionNext session) (first + count)
  go first first requests [] 0 (longestLine `div` 4)
  where
    -- The number of the next reply, that of the next request, the requests from it on, the replies,
    -- how long they are together, and how long a reply has been of late.
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

-- | A line as the reply to the request of this number.
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
