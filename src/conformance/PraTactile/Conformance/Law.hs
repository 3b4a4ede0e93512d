{-# LANGUAGE ExistentialQuantification #-}

-- | Laws as data. A law has a permanent id, a sentence for the reader of a failure, and cases,
-- either its whole domain under a profile or drawn ones. A case asks questions ("Ask") and is
-- judged by the definition, or by whether several answers fit together.
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

-- | A requirement on an implementation. @about@ is the subject of the law. @Law ProfileFacts@ is
-- asked under one profile, given all that follows from it ("PraTactile.Conformance.Definition").
-- @Law [Profile]@ opens the suite's profiles itself. @Law ()@, about touch or objects, needs no
-- profile.
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
  = -- | All cases, in this order. The first failing case is reported as it is, so small cases come
    -- first.
    Every [a]
  | -- | Drawn cases, and the smaller cases to try instead of a failing one.
    Some (Gen a) (a -> [a])

-- | The judgement of a case.
data Verdict
  = Holds
  | -- | The law does not apply to the case. It is not counted; instead of a drawn case another one
    -- is drawn.
    Inapplicable
  | Violated Violation
  deriving stock (Eq, Show)

-- | How a case violates a law.
data Violation = Violation
  { -- | The questions and replies in order. Either the last reply is wrong, or the replies do not
    -- fit together.
    violationAsked :: [Exchange],
    -- | The reply that was expected to the last question.
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
  = -- | The result.
    Result Value
  | -- | Refused, with the stable name of the reason, such as @zero-window@.
    RefusedFor String
  deriving stock (Eq, Show)
