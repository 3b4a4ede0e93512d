-- | What is put under the suite, as the suite sees it: something with a name that offers some
-- operations and answers questions in the form of the protocol, or fails to.
module PraTactile.Conformance.Subject
  ( Subject (..),
    Came (..),
    Fault (..),
    FaultKind (..),
    faultName,
  )
where

import Data.Aeson (Value)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile)

-- | An implementation in this process or another one.
data Subject = Subject
  { subjectName :: String,
    subjectOffers :: [Operation],
    -- | Put a profile in force; what came, or what went wrong.
    subjectProfile :: Profile -> IO (Either Fault Came),
    -- | Ask these questions, in this order; as many replies, in the same order. After a fault the
    -- subject is started again, with the same profile, before it is asked on.
    subjectAsk :: [SomeQuestion] -> IO [Either Fault Came],
    -- | How many questions are best asked at once.
    subjectBatch :: Int
  }

-- | What came in reply, as the protocol has it.
data Came
  = CameResult Value
  | CameRefused String
  | CameSkipped String
  | CameErrored String
  deriving stock (Eq, Show)

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
