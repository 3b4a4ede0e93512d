-- | What a run of the suite says of a subject, as data.
module PraTactile.Conformance.Report
  ( -- * Reports
    Report (..),
    LawReport (..),
    untried,
    Outcome (..),
    outcomeName,
    countOf,
    casesOf,

    -- * Certification
    certified,
    sound,
    uncovered,

    -- * Failures
    Counterexample (..),
    counterexample,
  )
where

import Data.Aeson (Value)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject

-- | Of a subject.
data Report = Report
  { reportSubject :: String,
    -- | The operations that the laws ask for, those of the stages that were tried.
    reportAsks :: [SomeOp],
    -- | Those of them that it offers.
    reportOffers :: [SomeOp],
    -- | What it offers and nobody here knows.
    reportUnknown :: [String],
    reportSeed :: Int,
    -- | The laws were chosen, so that what they say is not all.
    reportPartial :: Bool,
    reportSeconds :: Double,
    -- | Patterns of laws that must fail, none of which did.
    reportUnexpected :: [String],
    -- | In the order in which they were tried.
    reportLaws :: [LawReport]
  }
  deriving stock (Show)

-- | Of a law under a profile. What it was made from, the cases among it, need not be kept.
data LawReport = LawReport
  { lawReportId :: !String,
    lawReportStage :: !Stage,
    lawReportNeeds :: ![SomeOp],
    lawReportSentence :: !String,
    lawReportSource :: !String,
    -- | The profile's name; 'Nothing' for a law of profiles or of the protocol.
    lawReportProfile :: !(Maybe String),
    lawReportOutcome :: !Outcome,
    lawReportCases :: !Int,
    lawReportExhaustive :: !Bool,
    lawReportCounterexample :: !(Maybe Counterexample),
    -- | Why it was skipped.
    lawReportNote :: !(Maybe String)
  }
  deriving stock (Show)

-- | Of what was not tried: its id, its stage, what must hold, and where that is from.
untried :: String -> Stage -> String -> String -> LawReport
untried name stage sentence source =
  LawReport
    { lawReportId = name,
      lawReportStage = stage,
      lawReportNeeds = [],
      lawReportSentence = sentence,
      lawReportSource = source,
      lawReportProfile = Nothing,
      lawReportOutcome = Skipped,
      lawReportCases = 0,
      lawReportExhaustive = False,
      lawReportCounterexample = Nothing,
      lawReportNote = Nothing
    }

-- | What came of a law.
data Outcome
  = Held
  | Failed
  | Skipped
  | Errored
  | -- | It failed, and was said to.
    KnownFailure
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | As reports name it.
outcomeName :: Outcome -> String
outcomeName outcome = case outcome of
  Held -> "held"
  Failed -> "failed"
  Skipped -> "skipped"
  Errored -> "errored"
  KnownFailure -> "known-failure"

-- | How many laws had this outcome, each counted for each profile.
countOf :: Outcome -> Report -> Int
countOf outcome = length . filter ((== outcome) . lawReportOutcome) . reportLaws

-- | How many cases were judged in all.
casesOf :: Report -> Int
casesOf = sum . map lawReportCases . reportLaws

-- | Whether no law failed or erred, something is offered, and of each operation that is offered at
-- least one law held.
certified :: Report -> Bool
certified report = sound report && null (uncovered report)

-- | Whether no law failed or erred, something held, and no law passed that must fail: what can be
-- said of a run of chosen laws.
sound :: Report -> Bool
sound report =
  countOf Failed report == 0
    && countOf Errored report == 0
    && null (reportUnexpected report)
    && not (null (reportOffers report))
    && countOf Held report > 0

-- | The operations that are offered, but of which no law held.
uncovered :: Report -> [SomeOp]
uncovered report =
  [ operation
    | operation <- reportOffers report,
      null
        [ ()
          | one <- reportLaws report,
            lawReportOutcome one == Held,
            operation `elem` lawReportNeeds one
        ]
  ]

-- | A case in which a subject is wrong.
data Counterexample = Counterexample
  { -- | In the form of the protocol.
    counterRequests :: [Value],
    -- | 'Nothing' where any answer would do.
    counterExpected :: Maybe Response,
    -- | By which road that is known.
    counterRoad :: String,
    counterGot :: Either Fault Response,
    counterReason :: String,
    counterShrinks :: Int,
    -- | Whether a fresh process answers the case rightly, so that the subject's answer depends on
    -- what it was asked before.
    counterDepends :: Bool,
    -- | 'Nothing' where there is nothing to replay: a check of the protocol, and what depends on
    -- earlier requests.
    counterToken :: Maybe String
  }
  deriving stock (Show)

-- | One that nothing was made smaller for, and that cannot be replayed: what was asked, what should
-- have come, by which road that is known, what came, and why another answer is expected.
counterexample ::
  [Value] -> Maybe Response -> String -> Either Fault Response -> String -> Counterexample
counterexample requests wanted road got reason =
  Counterexample
    { counterRequests = requests,
      counterExpected = wanted,
      counterRoad = road,
      counterGot = got,
      counterReason = reason,
      counterShrinks = 0,
      counterDepends = False,
      counterToken = Nothing
    }
