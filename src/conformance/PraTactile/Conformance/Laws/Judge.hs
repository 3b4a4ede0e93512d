{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The judgement of answers: by the definition's answer to the same question, or by whether
-- several answers fit together.
module PraTactile.Conformance.Laws.Judge
  ( -- * Laws of one question
    defined,
    definedWithoutProfile,
    invalid,
    asDefined,
    inOrder,
    judge,
    questionForm,
    rawForm,

    -- * Laws of several questions
    Trial,
    trial,
    answer,
    demand,
    inapplicable,
    law,
    Because (..),

    -- * Raw questions
    some,
  )
where

import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT, runExceptT, throwE)
import Control.Monad.Trans.State.Strict (StateT, modify', runStateT)
import Data.Aeson (Value, toJSON)
import Data.Maybe (fromMaybe)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Definition hiding (known)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Format.Error (Misfit (NotPair))
import PraTactile.Format.Json.Codec (Codec, anything, listOf, readValue, refuse, via)

-- | A law that all these questions are answered or refused by definition. It needs the operation
-- that they ask for. The texts are the name of the property, the sentence and its source.
defined ::
  Stage ->
  String ->
  Op i o ->
  String ->
  String ->
  (ProfileFacts -> Domain SomeQuestion) ->
  Law ProfileFacts
defined stage what operation sentence source domain =
  law stage what [SomeOp operation] sentence source $ \known ->
    Cases questionForm (domain known) (asDefined known)

-- | 'defined' for questions that need no profile.
definedWithoutProfile ::
  Stage -> String -> Op i o -> String -> String -> String -> Domain SomeQuestion -> Law ()
definedWithoutProfile stage what operation sentence source reason domain =
  law stage what [SomeOp operation] sentence source $ \() -> Cases questionForm domain judged
  where
    judged (SomeQuestion question) = case expectedWithoutProfile question of
      Nothing -> pure Inapplicable
      Just wanted ->
        judge question wanted fits "the definition" reason <$> ask question
        where
          fits = either (const (const False)) (agreesWithoutProfile question) wanted

-- | A law that all these questions are refused as @invalid@.
invalid :: Stage -> String -> Op i o -> (about -> [SomeQuestion]) -> Law about
invalid stage what operation questions =
  law
    stage
    what
    [SomeOp operation]
    ( nameOf (SomeOp operation)
        ++ " refuses every invalid input as invalid: numbers that are not codes, values of a \
           \wrong type, missing keys, malformed values"
    )
    "the protocol, refusals"
    (\about -> Cases questionForm (Every (questions about)) refused)
  where
    refused (SomeQuestion question) =
      judge
        question
        (Left (Refusal "invalid"))
        (const False)
        "the protocol"
        "the input is none that the operation takes"
        <$> ask question

-- | A law, with an id made of its stage and the name of its property.
law :: Stage -> String -> [SomeOp] -> String -> String -> (about -> Cases) -> Law about
law stage what = Law (stageName stage ++ "/" ++ what) stage

-- | Asks a question and judges the answer by the definition.
asDefined :: ProfileFacts -> SomeQuestion -> Ask Verdict
asDefined known (SomeQuestion question) = judgedAsDefined known question <$> ask question

judgedAsDefined :: ProfileFacts -> Question a -> Either Refusal a -> Verdict
judgedAsDefined known question got = judge question shown fits road reason got
  where
    shown = either (const wanted) (\a -> inFormOf known question a <$> wanted) got
    fits = either (const (const False)) (agrees known question) wanted
    wanted = expected known question
    road = "the definition"
    reason = why known question wanted

-- | Asks questions in turn and judges each answer by the definition.
inOrder :: ProfileFacts -> [SomeQuestion] -> Ask Verdict
inOrder known = go []
  where
    go before questions = case questions of
      [] -> pure Holds
      SomeQuestion question : others -> do
        got <- ask question
        case judgedAsDefined known question got of
          Violated violation ->
            pure (Violated violation {violationAsked = reverse (exchanged question got : before)})
          _ -> go (exchanged question got : before) others

-- | The verdict on a reply: it must be the wanted refusal, or an answer that fits. The texts are
-- the source of the wanted reply and its reason.
judge ::
  Question a ->
  Either Refusal a ->
  (a -> Bool) ->
  String ->
  String ->
  Either Refusal a ->
  Verdict
judge question wanted fits road reason got = case (wanted, got) of
  (Left refusal, Left refusal') | refusal == refusal' -> Holds
  (_, Right a) | fits a -> Holds
  _ -> Violated (Violation [exchanged question got] (reply question wanted) road reason)

exchanged :: Question a -> Either Refusal a -> Exchange
exchanged question got =
  Exchange (Just (operationOf question)) (questionInput question) (reply question got)

reply :: Question a -> Either Refusal a -> Reply
reply question = either (RefusedFor . refusalReason) (Result . answerValue question)

-- | The JSON of a question: its operation and its input.
questionForm :: Codec SomeQuestion
questionForm = formOf some

formOf :: (SomeOp -> Value -> SomeQuestion) -> Codec SomeQuestion
formOf made = via written asked (listOf anything)
  where
    written (SomeQuestion question) =
      [toJSON (nameOf (operationOf question)), questionInput question]
    asked given = case given of
      [name, input] -> (`made` input) <$> readValue operationForm name
      _ -> refuse NotPair

-- | The JSON of a question whose input is kept as it was written.
rawForm :: Codec SomeQuestion
rawForm = formOf (\operation -> SomeQuestion . Raw operation)

-- | The question of an operation with this input; raw if the input is malformed.
some :: SomeOp -> Value -> SomeQuestion
some operation input =
  fromMaybe (SomeQuestion (Raw operation input)) (someQuestion operation input)

-- | Several questions with their replies, up to the first wrong refusal.
type Trial = ExceptT Verdict (StateT [Exchange] Ask)

-- | Why several answers must fit together: the source, and the reason in a sentence.
data Because = Because String String

-- | Runs a trial. A violation includes everything that was asked.
trial :: Trial () -> Ask Verdict
trial asking = do
  (outcome, exchanges) <- runStateT (runExceptT asking) []
  pure $ case outcome of
    Right () -> Holds
    Left (Violated violation) -> Violated violation {violationAsked = reverse exchanges}
    Left other -> other

-- | Asks a question that the definition answers; a refusal is a violation. If the definition
-- refuses too, the law does not apply.
answer :: ProfileFacts -> Question a -> Trial a
answer known question = do
  got <- lift (lift (ask question))
  lift (modify' (exchanged question got :))
  case got of
    Right a -> pure a
    Left refusal -> case wanted of
      Left refusal' | refusal == refusal' -> throwE Inapplicable
      _ ->
        throwE
          ( Violated
              ( Violation
                  []
                  (reply question wanted)
                  "the definition"
                  (why known question wanted)
              )
          )
  where
    wanted = expected known question

-- | Requires a condition on the last answer. The arguments are the reason, the question, the right
-- answer to it, and the condition.
demand :: Because -> Question a -> a -> Bool -> Trial ()
demand (Because road reason) question wanted held
  | held = pure ()
  | otherwise = throwE (Violated (Violation [] (reply question (Right wanted)) road reason))

-- | Ends a trial to which the law does not apply.
inapplicable :: Trial a
inapplicable = throwE Inapplicable
