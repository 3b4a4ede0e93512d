{-# LANGUAGE ExistentialQuantification #-}

-- | Laws as data. A law has a permanent id, a sentence for the reader of a failure, and cases,
-- either its whole domain under a profile or drawn ones. A case asks questions ("Ask") and is
-- judged by the definition; consistency of the implementation with itself is not enough.
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

-- | A requirement on an implementation. @about@ is the subject of the law: @Law Known@ is asked
-- under one profile, of which this is known by definition; @Law [Profile]@ opens the suite's
-- profiles itself; @Law ()@, about touch or objects, has only its own cases.
data Law about = Law
  { -- | The stage and the property, such as @field/addition-commutes@. It never changes.
    lawId :: String,
    lawStage :: Stage,
    -- | The operations that it needs. If an implementation lacks one, the law is skipped.
    lawNeeds :: [SomeOp],
    -- | The property, in a sentence.
    lawSentence :: String,
    -- | Its source: a definition, a theorem or a paper.
    lawSource :: String,
    lawCases :: about -> Cases
  }

-- | The cases of a law. A case can be written and read as JSON, so that a failure can be tried
-- again from its text.
data Cases = forall a.
  Cases
  { casesForm :: Codec a,
    casesDomain :: Domain a,
    casesTrial :: a -> Ask Verdict
  }

-- | The domain of a law's cases.
data Domain a
  = -- | The whole domain, in this order.
    Every [a]
  | -- | Drawn cases, and the smaller cases to try instead of a failing one.
    Some (Gen a) (a -> [a])

-- | The judgement of a case.
data Verdict
  = Holds
  | -- | The law does not apply to it.
    Inapplicable
  | Violated Violation
  deriving stock (Eq, Show)

-- | How a case violates a law.
data Violation = Violation
  { -- | The questions and answers. The last one is wrong, or all of them together.
    violationAsked :: [Exchange],
    -- | The expected reply.
    violationExpected :: Reply,
    -- | The source of the expectation: the definition, a theorem, or another answer of the same
    -- implementation.
    violationRoad :: String,
    -- | The reason for the expectation, in a sentence.
    violationReason :: String
  }
  deriving stock (Eq, Show)

-- | A question in the protocol's JSON, and its reply.
data Exchange = Exchange
  { -- | The operation; 'Nothing' for putting a profile in force, which then is the input.
    exchangeOperation :: Maybe SomeOp,
    exchangeInput :: Value,
    exchangeReply :: Reply
  }
  deriving stock (Eq, Show)

-- | A reply in the protocol's JSON.
data Reply
  = Result Value
  | RefusedFor String
  deriving stock (Eq, Show)
