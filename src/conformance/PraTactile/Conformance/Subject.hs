-- | A subject of the suite: something with a name that offers operations and answers questions in
-- the protocol's JSON, or fails to.
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

    -- * Time limit
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
    -- | Puts a profile in force; returns the response or the fault.
    subjectProfile :: Profile -> IO (Either Fault Response),
    -- | Asks these questions in order. Returns the replies in the same order, up to the first
    -- fault; it may return fewer if replies are long. After a fault the subject restarts with the
    -- same profile before the next question.
    subjectAsk :: [SomeQuestion] -> IO [Either Fault Response],
    -- | Restarts the subject, so that it forgets earlier questions; no profile is then in force.
    -- 'Nothing' if it cannot restart.
    subjectFresh :: Maybe (IO ()),
    -- | The best number of questions to ask at once.
    subjectBatch :: Int,
    -- | The names that it offers and the suite does not know.
    subjectUnknown :: [String],
    -- | The checks of the protocol, which are made first.
    subjectChecks :: [Check]
  }

-- | A requirement on the exchange itself, whatever is asked.
data Check = Check
  { -- | The id, in the form of a law's of the stage @protocol@.
    checkId :: String,
    -- | The requirement, in a sentence.
    checkSentence :: String,
    checkTry :: IO Checked
  }

-- | The result of a check.
data Checked
  = CheckHeld
  | -- | After these requests the first response was expected, and the second came.
    CheckFailed [Value] Response Response
  | -- | After these requests there was a fault.
    CheckErred [Value] Fault
  deriving stock (Eq, Show)

-- | A response of the protocol.
data Response
  = ResponseResult Value
  | ResponseRefused String
  | ResponseSkipped String
  | ResponseErrored String
  deriving stock (Eq, Show)

-- | The key of a response and its value.
responseItem :: Response -> (Key, Value)
responseItem response = case response of
  ResponseResult value -> (Key.fromString "result", value)
  ResponseRefused why -> (Key.fromString "refused", toJSON why)
  ResponseSkipped why -> (Key.fromString "skipped", toJSON why)
  ResponseErrored why -> (Key.fromString "errored", toJSON why)

-- | The expected reply of a law as a response.
responseOf :: Reply -> Response
responseOf reply = case reply of
  Result value -> ResponseResult value
  RefusedFor why -> ResponseRefused why

-- | A fault in place of a response, with details.
data Fault = Fault
  { faultKind :: FaultKind,
    faultDetail :: String
  }
  deriving stock (Eq, Show)

-- | The kinds of faults.
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

-- | The name of a kind of fault in reports.
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

-- | Whether such a fault shows only after a timeout, or after much output.
takesItsTime :: FaultKind -> Bool
takesItsTime = (`elem` [TimedOut, HalfLine, EndlessOutput])

-- | The results of actions, up to and including the first fault.
upToFault :: [IO (Either Fault a)] -> IO [Either Fault a]
upToFault actions = case actions of
  [] -> pure []
  action : others -> do
    response <- action
    (response :) <$> either (const (pure [])) (const (upToFault others)) response

-- | The result, unless the action takes more than the given number of seconds.
withinSeconds :: Double -> IO a -> IO (Maybe a)
withinSeconds seconds = timeout (max 1 (ceiling (min 1e9 seconds * 1e6)))

-- | The fault of work that was not finished within the time limit.
timeOver :: Fault
timeOver = Fault TooSlow "the time for all of it was over"
