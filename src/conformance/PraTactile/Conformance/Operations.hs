{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | All operations, and what follows from their records: their JSON, their reasons of refusal,
-- their inputs.
module PraTactile.Conformance.Operations
  ( -- * Operations
    recordOf,
    allOperations,
    codeOperations,
    definedOperations,
    operationsOf,
    operationsIn,
    nameOf,
    operationForm,
    stageOf,

    -- * Questions
    operationOf,
    questionInput,
    someQuestion,
    exampleOf,
    typicalOf,
    refusedOf,
    smallerQuestions,
    malformedForms,

    -- * Answers
    answerValue,
    readAnswer,
    leastBytes,
    ruleOf,
  )
where

import Data.Aeson (Value, object)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Definition.Array (ProfileFacts, known)
import PraTactile.Conformance.Operation
import qualified PraTactile.Conformance.Operations.Arrays as Arrays
import qualified PraTactile.Conformance.Operations.Fields as Fields
import qualified PraTactile.Conformance.Operations.Objects as Objects
import qualified PraTactile.Conformance.Operations.Places as Places
import qualified PraTactile.Conformance.Operations.Touch as Touch
import PraTactile.Conformance.Question
import PraTactile.Conformance.Stage
import PraTactile.Format.Json.Codec hiding (object)
import PraTactile.Profile (canonicalProfile)

-- | The record of an operation.
recordOf :: Op i o -> Operation i o
recordOf op = case op of
  Add -> Fields.add
  Multiply -> Fields.multiply
  Negate -> Fields.negate'
  Inverse -> Fields.inverse
  Power -> Fields.power
  Logarithm -> Fields.logarithm
  Trace -> Fields.trace
  Primitive -> Fields.primitive
  FirstPrimitive -> Fields.firstPrimitive
  Term -> Arrays.term
  Terms -> Arrays.terms
  Cell -> Arrays.cell
  Pack -> Arrays.pack
  Unpack -> Arrays.unpack
  Locate -> Places.locate
  Nearest -> Places.nearest
  Posterior -> Places.posterior
  Prove -> Arrays.prove
  Distance -> Arrays.distance
  Register -> Touch.register
  Stitch -> Touch.stitch
  Segment -> Touch.segment
  Outputs -> Touch.outputs
  SolidReport -> Objects.solidReport
  FaceCells -> Objects.faceCells
  Whereabouts -> Objects.whereabouts
  FacePose -> Objects.facePose

-- | All operations, in the order of writing a decoder.
allOperations :: [SomeOp]
allOperations =
  [SomeOp Add, SomeOp Multiply, SomeOp Negate, SomeOp Inverse, SomeOp Power, SomeOp Logarithm]
    ++ [SomeOp Trace, SomeOp Primitive, SomeOp FirstPrimitive, SomeOp Term, SomeOp Terms]
    ++ [SomeOp Cell, SomeOp Pack, SomeOp Unpack, SomeOp Locate, SomeOp Nearest, SomeOp Posterior]
    ++ [SomeOp Prove, SomeOp Distance, SomeOp Register, SomeOp Stitch, SomeOp Segment]
    ++ [SomeOp Outputs, SomeOp SolidReport, SomeOp FaceCells, SomeOp Whereabouts, SomeOp FacePose]

-- | The operations that are asked under a profile.
codeOperations :: [SomeOp]
codeOperations = operationsOf codeStages

-- | The operations that need no profile and have a definition.
definedOperations :: [SomeOp]
definedOperations =
  [some | some@(SomeOp op) <- allOperations, WithoutProfile _ _ <- [operationWays (recordOf op)]]

-- | The operations that the laws of these stages ask for, including all stages of the sets to
-- which they belong.
operationsOf :: [Stage] -> [SomeOp]
operationsOf stages =
  [ some
    | some <- allOperations,
      set <- codeStages : map snd stagesApart,
      stageOf some `elem` set,
      any (`elem` set) stages
  ]

-- | The operations of one stage.
operationsIn :: Stage -> [SomeOp]
operationsIn stage = filter ((== stage) . stageOf) allOperations

-- | The operation's name in the protocol.
nameOf :: SomeOp -> String
nameOf (SomeOp op) = operationName (recordOf op)

-- | An operation, by its name.
operationForm :: Codec SomeOp
operationForm = among nameOf allOperations

-- | The stage whose laws are about the operation alone.
stageOf :: SomeOp -> Stage
stageOf (SomeOp op) = operationStage (recordOf op)

-- | The operation that a question asks for.
operationOf :: Question a -> SomeOp
operationOf question = case question of
  op :? _ -> SomeOp op
  Raw some _ -> some

-- | The input of a question, as a request states it.
questionInput :: Question a -> Value
questionInput question = case question of
  op :? input -> writeValue (operationInput (recordOf op)) input
  Raw _ input -> input

-- | The question with an operation and a JSON input; 'Nothing' if the input does not fit the
-- operation: not an object, a missing key, a wrong type, a negative number in place of a natural
-- one. Further keys are ignored.
someQuestion :: SomeOp -> Value -> Maybe SomeQuestion
someQuestion (SomeOp op) value = case recordOf op of
  it@Operation {} ->
    either (const Nothing) (Just . SomeQuestion . (op :?)) (readValue (operationInput it) value)

-- | A question of an operation that every profile answers or refuses.
exampleOf :: SomeOp -> SomeQuestion
exampleOf some@(SomeOp op) = case recordOf op of
  it@Operation {} -> case operationWays it of
    UnderProfile means _ ->
      either (const (raw some)) (SomeQuestion . (op :?) . example means) (known canonicalProfile)
    WithoutProfile means _ -> SomeQuestion (op :? example means ())
    ByScene input _ -> SomeQuestion (op :? input)

-- | A question with an invalid input.
raw :: SomeOp -> SomeQuestion
raw some = SomeQuestion (Raw some (object []))

-- | Questions of an operation that every profile answers, with small numbers, and with large ones
-- where any size is allowed.
typicalOf :: ProfileFacts -> SomeOp -> [SomeQuestion]
typicalOf = inputsUnder typical

-- | Questions of an operation that are refused, each for another reason.
refusedOf :: ProfileFacts -> SomeOp -> [SomeQuestion]
refusedOf k some = raw some : inputsUnder refused k some

inputsUnder ::
  (forall i o. Meaning ProfileFacts i o -> ProfileFacts -> [i]) ->
  ProfileFacts ->
  SomeOp ->
  [SomeQuestion]
inputsUnder inputs k (SomeOp op) = case recordOf op of
  it@Operation {} -> case operationWays it of
    UnderProfile means _ -> map (SomeQuestion . (op :?)) (inputs means k)
    _ -> []

-- | Smaller questions to try instead of a failing one, smallest first. A raw question has none;
-- for one about frames the scene is made smaller instead.
smallerQuestions :: SomeQuestion -> [SomeQuestion]
smallerQuestions (SomeQuestion question) = case question of
  op :? input -> map (SomeQuestion . (op :?)) $ case operationWays (recordOf op) of
    UnderProfile means _ -> smaller means input
    WithoutProfile means _ -> smaller means input
    ByScene _ _ -> []
  Raw _ _ -> []

-- | Invalid inputs of the operation, derived from this question's input.
malformedForms :: Question a -> [Value]
malformedForms question = case question of
  op :? input -> malformedOf (operationInput (recordOf op)) input
  Raw _ _ -> []

-- | The answer to a question in the protocol's JSON.
answerValue :: Question a -> a -> Value
answerValue question answer = case question of
  op :? _ -> writeValue (operationOutput (recordOf op)) answer
  Raw _ _ -> answer

-- | Reads the answer to a question from JSON; 'Nothing' if it does not fit.
readAnswer :: Question a -> Value -> Maybe a
readAnswer question value = case question of
  op :? _ -> either (const Nothing) Just (readValue (operationOutput (recordOf op)) value)
  Raw _ _ -> Just value

-- | The least number of bytes of an answer as JSON, estimated from the numbers in the question.
leastBytes :: Question a -> Natural
leastBytes question = case question of
  op :? input -> operationLeast (recordOf op) input
  Raw _ _ -> 1

-- | The rule of a refusal.
ruleOf :: SomeOp -> String -> String
ruleOf (SomeOp op) reason = fromMaybe "by definition" (lookup reason rules)
  where
    rules =
      ("invalid", "the operation does not take such an input") : operationReasons (recordOf op)
