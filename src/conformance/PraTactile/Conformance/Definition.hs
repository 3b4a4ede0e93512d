{-# LANGUAGE GADTs #-}

-- | The expected answers by definition. Every operation is computed as it is defined, too slow for
-- large arrays and too simple to be wrong. It is a second, independent way to every answer: nothing
-- here calls the algebra, the arrays or the decoders of this library.
module PraTactile.Conformance.Definition
  ( ProfileFacts,
    Unknown (..),
    unknownText,
    known,
    knownProfile,
    expected,
    agrees,
    inFormOf,
    expectedWithoutProfile,
    agreesWithoutProfile,
    why,
  )
where

import Data.Maybe (fromMaybe)
import PraTactile.Conformance.Definition.Array
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question

-- | The answer to a question of the code, or its refusal.
expected :: ProfileFacts -> Question a -> Either Refusal a
expected k = fromMaybe (Left (Refusal "not-offered")) . meant (Just k)

-- | The answer to a question that needs no profile, or its refusal. 'Nothing' for a question that
-- needs a profile, and for one about frames, where the answer depends on the scene that a law
-- draws.
expectedWithoutProfile :: Question a -> Maybe (Either Refusal a)
expectedWithoutProfile = meant Nothing

meant :: Maybe ProfileFacts -> Question a -> Maybe (Either Refusal a)
meant about question = case question of
  op :? input -> case operationWays (recordOf op) of
    UnderProfile means _ -> (\k -> definition means k input) <$> about
    WithoutProfile means _ -> Just (definition means () input)
    ByScene _ _ -> Nothing
  Raw operation input -> case someQuestion operation input of
    Nothing -> Just (Left (Refusal "invalid"))
    Just (SomeQuestion asked') -> fmap (answerValue asked') <$> meant about asked'

-- | Whether the last argument, an answer, is as good as the expected answer before it.
agrees :: ProfileFacts -> Question a -> a -> a -> Bool
agrees k = agreesBy (Just k)

-- | Whether the last argument, an answer to a question without a profile, is as good as the
-- expected answer before it.
agreesWithoutProfile :: Question a -> a -> a -> Bool
agreesWithoutProfile = agreesBy Nothing

agreesBy :: Maybe ProfileFacts -> Question a -> a -> a -> Bool
agreesBy about question wanted got =
  answerValue question (likenedTo about question got wanted) == answerValue question got

-- | The expected answer (the last argument) in the form of another answer to the same question.
inFormOf :: ProfileFacts -> Question a -> a -> a -> a
inFormOf k = likenedTo (Just k)

likenedTo :: Maybe ProfileFacts -> Question a -> a -> a -> a
likenedTo about question got wanted = case question of
  op :? input -> case operationWays (recordOf op) of
    UnderProfile means _ -> maybe wanted (\k -> likened means k input got wanted) about
    WithoutProfile means _ -> likened means () input got wanted
    ByScene _ _ -> wanted
  Raw operation input -> fromMaybe wanted $ do
    SomeQuestion asked' <- someQuestion operation input
    came <- readAnswer asked' got
    form <- likenedTo about asked' came <$> readAnswer asked' wanted
    -- Several doubles can be written alike, such as 0.2 and 0.20000000000000001, so the JSON is
    -- compared.
    Just $
      if answerValue asked' form == answerValue asked' came then got else answerValue asked' form

-- | Why the definition gives this answer or refusal under a profile, in a sentence for an
-- implementer who got another one: the convention that decides it, or the rule of the refusal.
why :: ProfileFacts -> Question a -> Either Refusal a -> String
why k question wanted = case wanted of
  Left (Refusal reason) -> ruleOf (operationOf question) reason
  Right _ -> case operationOf question of
    SomeOp op -> case operationWays (recordOf op) of
      UnderProfile means _ -> because means k
      WithoutProfile means _ -> because means ()
      ByScene _ _ -> "by definition"
