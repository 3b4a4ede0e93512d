{-# LANGUAGE ExistentialQuantification #-}

-- | Laws as data. A law has a name that stays, a sentence for the reader of a failure, and cases:
-- all of its domain under a profile, or drawn ones. A case is tried by asking ("Ask") and judged by
-- what the definition says, never by how the implementation agrees with itself alone.
module PraTactile.Conformance.Law
  ( -- * Laws
    Law (..),
    module PraTactile.Conformance.Stage,

    -- * Cases
    Cases (..),
    Domain (..),

    -- * Verdicts
    Verdict (..),
    Violation (..),
    Exchange (..),
    Reply (..),
  )
where

import Data.Aeson (Value)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Question
import PraTactile.Conformance.Stage
import PraTactile.Format.Json.Codec (Codec)
import Test.QuickCheck (Gen)

-- | What must hold of an implementation, given what the law is about: what is known of a profile by
-- definition (@Law Known@, asked under that profile), or the profiles of the suite, which its
-- trials open by themselves (@Law [Profile]@); a law of touch or of objects is about nothing but
-- its own cases (@Law ()@).
data Law about = Law
  { -- | The stage and what holds, such as @field/addition-commutes@. It never changes.
    lawId :: String,
    lawStage :: Stage,
    -- | What it asks for. An implementation that does not offer one of these skips the law.
    lawNeeds :: [SomeOp],
    -- | What holds, in a sentence.
    lawSentence :: String,
    -- | Where that is from: a definition, a theorem, a paper.
    lawSource :: String,
    lawCases :: about -> Cases
  }

-- | The cases of a law under a profile. A case can be written and read, so that a failure is tried
-- again from a text alone.
data Cases = forall a.
  Cases
  { casesForm :: Codec a,
    casesDomain :: Domain a,
    casesTrial :: a -> Ask Verdict
  }

-- | Which cases there are.
data Domain a
  = -- | All of them, in this order: the law exhausts its domain.
    Every [a]
  | -- | Drawn; with the smaller ones that a failing one is tried with.
    Some (Gen a) (a -> [a])

-- | What came of a case.
data Verdict
  = Holds
  | -- | The law says nothing of it.
    Inapplicable
  | Violated Violation
  deriving stock (Eq, Show)

-- | How a case violates a law.
data Violation = Violation
  { -- | What was asked, with what came; the last one is at fault, or all of them together.
    violationAsked :: [Exchange],
    -- | What should have come of it, as it is shown.
    violationExpected :: Reply,
    -- | By which road that is known: the definition, a theorem, another answer of the same
    -- implementation.
    violationRoad :: String,
    -- | Why that is expected here, in a sentence.
    violationReason :: String
  }
  deriving stock (Eq, Show)

-- | A question in the form of the protocol, and what came.
data Exchange = Exchange
  { -- | 'Nothing' for putting a profile in force, which then is the input.
    exchangeOperation :: Maybe SomeOp,
    exchangeInput :: Value,
    exchangeReply :: Reply
  }
  deriving stock (Eq, Show)

-- | A reply in the form of the protocol.
data Reply
  = Result Value
  | RefusedFor String
  deriving stock (Eq, Show)
