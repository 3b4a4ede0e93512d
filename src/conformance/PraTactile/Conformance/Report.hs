-- | The report on a subject, as data.
module PraTactile.Conformance.Report
  ( -- * Reports
    Report (..),
    LawReport (..),
    untried,
    LawOutcome (..),
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

-- | The report on a subject.
data Report = Report
  { reportSubject :: String,
    -- | The operations that the tried stages' laws need.
    reportAsks :: [SomeOp],
    -- | The operations among these that it offers.
    reportOffers :: [SomeOp],
    -- | The names that it offers and the suite does not know.
    reportUnknown :: [String],
    reportSeed :: Int,
    -- | Whether only chosen laws were tried.
    reportPartial :: Bool,
    reportSeconds :: Double,
    -- | The patterns of laws that must fail, of which none failed.
    reportUnexpected :: [String],
    -- | In the order of trying.
    reportLaws :: [LawReport]
  }
  deriving stock (Show)

-- | The report on a law under a profile. It does not keep the cases.
data LawReport = LawReport
  { lawReportId :: !String,
    lawReportStage :: !Stage,
    lawReportNeeds :: ![SomeOp],
    lawReportSentence :: !String,
    lawReportSource :: !String,
    -- | The profile's name; 'Nothing' for a law about opening profiles or about the protocol.
    lawReportProfile :: !(Maybe String),
    lawReportOutcome :: !LawOutcome,
    lawReportCases :: !Int,
    lawReportExhaustive :: !Bool,
    lawReportCounterexample :: !(Maybe Counterexample),
    -- | The reason for skipping it.
    lawReportNote :: !(Maybe String)
  }
  deriving stock (Show)

-- | The report on a law that was not tried. The arguments are its id, stage, sentence and source.
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

-- | The outcome of a law.
data LawOutcome
  = Held
  | Failed
  | Skipped
  | Errored
  | -- | It failed, as expected.
    KnownFailure
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The name of an outcome in reports.
outcomeName :: LawOutcome -> String
outcomeName outcome = case outcome of
  Held -> "held"
  Failed -> "failed"
  Skipped -> "skipped"
  Errored -> "errored"
  KnownFailure -> "known-failure"

-- | The number of laws with this outcome, counted once per profile.
countOf :: LawOutcome -> Report -> Int
countOf outcome = length . filter ((== outcome) . lawReportOutcome) . reportLaws

-- | The number of judged cases in all.
casesOf :: Report -> Int
casesOf = sum . map lawReportCases . reportLaws

-- | Whether an implementation is certified: no law failed or erred, something is offered, and for
-- each offered operation at least one law held.
certified :: Report -> Bool
certified report = sound report && null (uncovered report)

-- | Whether no law failed or erred, some law held, and no law passed that must fail. That is all
-- that a run of chosen laws can show.
sound :: Report -> Bool
sound report =
  countOf Failed report == 0
    && countOf Errored report == 0
    && null (reportUnexpected report)
    && not (null (reportOffers report))
    && countOf Held report > 0

-- | The offered operations of which no law held.
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
  { -- | The requests in the protocol's JSON.
    counterRequests :: [Value],
    -- | The expected reply; 'Nothing' if any answer would do.
    counterExpected :: Maybe Response,
    -- | The source of the expected reply.
    counterRoad :: String,
    counterGot :: Either Fault Response,
    counterReason :: String,
    counterShrinks :: Int,
    -- | Whether a fresh process answers the case rightly, so that the answer depends on earlier
    -- requests.
    counterDepends :: Bool,
    -- | The token for replaying; 'Nothing' for a check of the protocol, and for a case that
    -- depends on earlier requests.
    counterToken :: Maybe String
  }
  deriving stock (Show)

-- | A counterexample that was not shrunk and cannot be replayed. The arguments are the requests,
-- the expected reply and its source, the reply that came, and the reason for the expectation.
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
