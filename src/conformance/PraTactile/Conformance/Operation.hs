{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE RankNTypes #-}

-- | The description of an operation: one record, from which everything else about it follows. The
-- records are in modules below "PraTactile.Conformance.Operations", which has the only @case@ from
-- operations to records.
module PraTactile.Conformance.Operation
  ( Operation (..),
    Ways (..),

    -- * By definition
    Meaning (..),
    meaning,
    Group (..),
    Inputs (..),
    ofCode,
  )
where

import Data.Aeson (Value)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Answer (Wire)
import PraTactile.Conformance.Definition.Array (ProfileFacts)
import PraTactile.Conformance.Library.Prepared (Prepared)
import PraTactile.Conformance.Question (Code, Refusal)
import PraTactile.Conformance.Stage (Stage)
import PraTactile.Conformance.Vectors.Draw (Draw)
import PraTactile.Conformance.Vectors.Flag (Flag)
import PraTactile.Field (KnownField)
import PraTactile.Format.Json.Codec (Codec)
import PraTactile.Profile (Profile)

-- | Everything that the suite knows of an operation.
data Operation i o = Show i =>
  Operation
  { -- | Its name in the protocol.
    operationName :: String,
    -- | The stage whose laws are about it alone.
    operationStage :: Stage,
    -- | Its answer, in the words of the table of operations.
    operationSays :: String,
    operationInput :: Codec i,
    operationOutput :: Codec o,
    -- | The reasons of its refusals besides @invalid@, each with its rule.
    operationReasons :: [(String, String)],
    -- | The least number of bytes of an answer in JSON.
    operationLeast :: i -> Natural,
    operationWays :: Ways i o
  }

-- | How the answers are known, and the library's own answer.
data Ways i o
  = -- | Under a profile, by definition.
    UnderProfile (Meaning ProfileFacts i o) (forall k. KnownField k => Prepared k -> i -> Wire o)
  | -- | Without a profile, by definition.
    WithoutProfile (Meaning () i o) (i -> Wire o)
  | -- | Without a profile, by the truth of a scene that a law draws; with an example input.
    ByScene i (i -> Wire o)

-- | The definition of an operation, and its inputs for tests. @about@ is what is known of the
-- profile, or @()@.
data Meaning about i o = Meaning
  { -- | The answer by definition, or the refusal.
    definition :: about -> i -> Either Refusal o,
    -- | The defined answer (the last argument) in the form of the given answer; equal to the given
    -- answer if both agree.
    likened :: about -> i -> o -> o -> o,
    -- | The reason for the answer, in a sentence for an implementer who got another one.
    because :: about -> String,
    -- | A typical input, without special properties.
    example :: about -> i,
    -- | Inputs that are answered, with small numbers, and with large ones where any size is
    -- allowed.
    typical :: about -> [i],
    -- | Inputs that are refused, each for another reason.
    refused :: about -> [i],
    -- | Smaller inputs to try instead of a failing one, smallest first.
    smaller :: i -> [i],
    -- | The inputs of test vectors.
    asked :: about -> [Group i],
    -- | All inputs in order, if they are too many for test vectors, with the name of the table and
    -- the code of an answer.
    tabled :: about -> Maybe (String, [i], o -> Code),
    -- | The special properties of an input under a profile.
    flags :: Profile -> i -> [Flag],
    -- | The names of the two ways to the answer: the library's and the definition's.
    roads :: (String, String),
    -- | The answer in test vectors, from the defined and the library's answer.
    stated :: o -> o -> o
  }

-- | A meaning from the definition, the sentence 'because', the roads and the example. The defined
-- answer is the only right one; there are no further inputs.
meaning ::
  (about -> i -> Either Refusal o) ->
  (about -> String) ->
  (String, String) ->
  (about -> i) ->
  Meaning about i o
meaning defined why ways input =
  Meaning
    { definition = defined,
      likened = \_ _ _ wanted -> wanted,
      because = why,
      example = input,
      typical = pure . input,
      refused = const [],
      smaller = const [],
      asked = const [],
      tabled = const Nothing,
      flags = \_ _ -> [],
      roads = ways,
      stated = \_ given -> given
    }

-- | Inputs of test vectors, with their source.
data Group i = Group String (Inputs i)

-- | The kind of a group of inputs.
data Inputs i
  = -- | They are the whole domain.
    WholeDomain [i]
  | Chosen [i]
  | -- | Drawn from the seed.
    Drawn (Draw [i])
  | -- | JSON values, most of which are invalid inputs.
    OtherForms [Value]

-- | The inputs of an operation of the code: the whole domain with its source, if given, otherwise
-- drawn ones; then edge cases.
ofCode :: Maybe (String, [i]) -> Draw [i] -> [i] -> [Group i]
ofCode whole some edges =
  maybe
    [Group "Drawn from the seed." (Drawn some)]
    (\(source, inputs) -> [Group source (WholeDomain inputs)])
    whole
    ++ [Group "Edges of the domain, and beyond." (Chosen edges)]
