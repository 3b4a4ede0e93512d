-- | What is put under the suite, as the suite sees it: something with a name that offers some
-- operations and answers questions in the form of the protocol, or fails to.
module PraTactile.Conformance.Subject
  ( Subject (..),
    Response (..),
    responseItem,
    responseOf,
    Check (..),
    Checked (..),
    Fault (..),
    FaultKind (..),
    faultName,
    takesItsTime,
    upToFault,

    -- * The time for all of it
    withinSeconds,
    timeOver,
  )
where

import Data.Aeson (Key, Value, toJSON)
import qualified Data.Aeson.Key as Key
import PraTactile.Conformance.Law (Reply (..))
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile)
import System.Timeout (timeout)

-- | An implementation in this process or another one.
data Subject = Subject
  { subjectName :: String,
    subjectOffers :: [SomeOp],
    -- | Put a profile in force; what came, or what went wrong.
    subjectProfile :: Profile -> IO (Either Fault Response),
    -- | Ask these questions, in this order; the replies in the same order, up to the first fault,
    -- or to where they are enough for once, because they are long.
    -- After a fault the subject is started again, with the same profile, before it is asked on.
    subjectAsk :: [SomeQuestion] -> IO [Either Fault Response],
    -- | Forget all that was asked, as only a process that is started anew does; 'Nothing' where
    -- none is, or each request has one of its own. No profile is in force afterwards.
    subjectFresh :: Maybe (IO ()),
    -- | How many questions are best asked at once.
    subjectBatch :: Int,
    -- | What it says that it offers and nobody here knows.
    subjectUnknown :: [String],
    -- | What must hold of how it is spoken to, tried before all else.
    subjectChecks :: [Check]
  }

-- | Something that must hold of the exchange itself, whatever is asked.
data Check = Check
  { -- | As the id of a law, of the stage @protocol@.
    checkId :: String,
    -- | What must hold, in a sentence.
    checkSentence :: String,
    checkTry :: IO Checked
  }

-- | What came of a check.
data Checked
  = CheckHeld
  | -- | After these requests this should have come, and that came.
    CheckFailed [Value] Response Response
  | -- | After these requests something went wrong.
    CheckErred [Value] Fault
  deriving stock (Eq, Show)

-- | What came in reply, as the protocol has it.
data Response
  = ResponseResult Value
  | ResponseRefused String
  | ResponseSkipped String
  | ResponseErrored String
  deriving stock (Eq, Show)

-- | As it stands in a reply: the one key that says what came, and its value.
responseItem :: Response -> (Key, Value)
responseItem response = case response of
  ResponseResult value -> (Key.fromString "result", value)
  ResponseRefused why -> (Key.fromString "refused", toJSON why)
  ResponseSkipped why -> (Key.fromString "skipped", toJSON why)
  ResponseErrored why -> (Key.fromString "errored", toJSON why)

-- | A reply to a law's question, as what came.
responseOf :: Reply -> Response
responseOf reply = case reply of
  Result value -> ResponseResult value
  RefusedFor why -> ResponseRefused why

-- | What a subject did instead of replying, and the particulars.
data Fault = Fault
  { faultKind :: FaultKind,
    faultDetail :: String
  }
  deriving stock (Eq, Show)

-- | The ways in which a process does not reply.
data FaultKind
  = CannotStart
  | NeverStarted
  | Crashed
  | TimedOut
  | NotJson
  | HalfLine
  | LineTooLong
  | EndlessOutput
  | OutOfOrder
  | AnsweredTwice
  | NotAReply
  | WrongType
  | OutputAfterStop
  | DoesNotStop
  | ClosedPipe
  | TooSlow
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | As reports name them.
faultName :: FaultKind -> String
faultName kind = case kind of
  CannotStart -> "cannot-start"
  NeverStarted -> "never-started"
  Crashed -> "crashed"
  TimedOut -> "timeout"
  NotJson -> "not-json"
  HalfLine -> "half-line"
  LineTooLong -> "line-too-long"
  EndlessOutput -> "endless-output"
  OutOfOrder -> "out-of-order"
  AnsweredTwice -> "answered-twice"
  NotAReply -> "not-a-reply"
  WrongType -> "wrong-type"
  OutputAfterStop -> "output-after-stop"
  DoesNotStop -> "does-not-stop"
  ClosedPipe -> "closed-pipe"
  TooSlow -> "too-slow"

-- | Whether such a fault is known only when the time for a reply is over, or after much output.
takesItsTime :: FaultKind -> Bool
takesItsTime = (`elem` [TimedOut, HalfLine, EndlessOutput])

-- | What comes of these actions, the first fault being the last of it.
upToFault :: [IO (Either Fault a)] -> IO [Either Fault a]
upToFault actions = case actions of
  [] -> pure []
  action : others -> do
    response <- action
    (response :) <$> either (const (pure [])) (const (upToFault others)) response

-- | The result, unless it takes more than so many seconds.
withinSeconds :: Double -> IO a -> IO (Maybe a)
withinSeconds seconds = timeout (max 1 (ceiling (min 1e9 seconds * 1e6)))

-- | What is said of what the time did not suffice for.
timeOver :: Fault
timeOver = Fault TooSlow "the time for all of it was over"
