{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE RankNTypes #-}

-- | What an operation is: one record, of which everything else about it is a function. Each record
-- stands in a module below "PraTactile.Conformance.Operations", which has the one @case@ from
-- operations to their records.
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
import PraTactile.Conformance.Definition.Array (Known)
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
    -- | What it answers, for the table of operations.
    operationSays :: String,
    operationInput :: Codec i,
    operationOutput :: Codec o,
    -- | The reasons of its refusals beside @invalid@, each with its rule.
    operationReasons :: [(String, String)],
    -- | The least number of bytes of an answer in JSON.
    operationLeast :: i -> Natural,
    operationWays :: Ways i o
  }

-- | How the answers are known, and this library's.
data Ways i o
  = -- | Under a profile, by definition.
    UnderProfile (Meaning Known i o) (forall k. KnownField k => Prepared k -> i -> Wire o)
  | -- | Without a profile, by definition.
    WithoutProfile (Meaning () i o) (i -> Wire o)
  | -- | Without a profile, by the truth of the scene that a law draws. An input.
    ByScene i (i -> Wire o)

-- | The definition of an operation and the inputs that show it, given what is known of the profile
-- or nothing.
data Meaning about i o = Meaning
  { -- | The answer by definition, or the refusal.
    definition :: about -> i -> Either Refusal o,
    -- | The defined answer, the last argument, in the form of the one that came: the one that came
    -- itself where both agree.
    likened :: about -> i -> o -> o -> o,
    -- | Why the answer is what it is, in a sentence for somebody whose implementation differs.
    because :: about -> String,
    -- | An input that is none of the edges.
    example :: about -> i,
    -- | Inputs that are answered, with small numbers, and with large ones where these may have any
    -- size.
    typical :: about -> [i],
    -- | Inputs that are refused, each for another reason.
    refused :: about -> [i],
    -- | Smaller inputs to try in the place of a failing one, the smallest first.
    smaller :: i -> [i],
    -- | The inputs of test vectors.
    asked :: about -> [Group i],
    -- | All inputs in an order, where they are too many for test vectors, and their codes.
    tabled :: about -> Maybe (String, [i], o -> Code),
    -- | What is remarkable about an input under a profile.
    flags :: Profile -> i -> [Flag],
    -- | The two ways to the answer: the library's and the definition's.
    roads :: (String, String),
    -- | The answer that test vectors state, of the defined and the library's.
    stated :: o -> o -> o
  }

-- | A meaning of these parts: the definition, the sentence why, the roads and the example. The
-- defined answer is the only right one, and nothing else is known of the inputs.
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

-- | Inputs of test vectors, with where they are from.
data Group i = Group String (Inputs i)

-- | How inputs of test vectors came about.
data Inputs i
  = -- | They are the whole domain.
    WholeDomain [i]
  | Chosen [i]
  | -- | From the seed.
    Drawn (Draw [i])
  | -- | JSON values, most of which are no inputs.
    OtherForms [Value]

-- | The inputs of an operation of the code: the whole domain if it is small, with a sentence on it,
-- otherwise drawn ones; and edges.
ofCode :: Maybe (String, [i]) -> Draw [i] -> [i] -> [Group i]
ofCode whole some edges =
  maybe
    [Group "Drawn from the seed." (Drawn some)]
    (\(source, inputs) -> [Group source (WholeDomain inputs)])
    whole
    ++ [Group "Edges of the domain, and beyond." (Chosen edges)]
