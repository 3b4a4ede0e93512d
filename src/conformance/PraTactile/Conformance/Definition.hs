{-# LANGUAGE GADTs #-}

-- | What the answers are, by definition: every operation as it is defined, too slow to use on large
-- arrays and too simple to be wrong. Nothing here calls the algebra, the arrays or the decoders of
-- this library; it is the second road to every answer.
module PraTactile.Conformance.Definition
  ( Known,
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

-- | The answer to a question of the code, or the reason of its refusal.
expected :: Known -> Question a -> Either Refusal a
expected k = fromMaybe (Left (Refusal "not-offered")) . meant (Just k)

-- | The answer to a question that needs no profile, or the reason of its refusal. 'Nothing' for one
-- that needs a profile, and for one about frames, whose definition is in the scene that a law
-- draws.
expectedWithoutProfile :: Question a -> Maybe (Either Refusal a)
expectedWithoutProfile = meant Nothing

meant :: Maybe Known -> Question a -> Maybe (Either Refusal a)
meant about question = case question of
  op :? input -> case operationWays (recordOf op) of
    UnderProfile means _ -> (\k -> definition means k input) <$> about
    WithoutProfile means _ -> Just (definition means () input)
    ByScene _ _ -> Nothing
  Raw operation input -> case someQuestion operation input of
    Nothing -> Just (Left (Refusal "invalid"))
    Just (SomeQuestion asked') -> fmap (answerValue asked') <$> meant about asked'

-- | Whether an answer, the last argument, is as good as the expected one.
agrees :: Known -> Question a -> a -> a -> Bool
agrees k = agreesBy (Just k)

-- | Whether an answer to a question that needs no profile, the last argument, is as good as the
-- expected one.
agreesWithoutProfile :: Question a -> a -> a -> Bool
agreesWithoutProfile = agreesBy Nothing

agreesBy :: Maybe Known -> Question a -> a -> a -> Bool
agreesBy about question wanted got =
  answerValue question (likenedTo about question got wanted) == answerValue question got

-- | The expected answer, the last argument, in the form of another one.
inFormOf :: Known -> Question a -> a -> a -> a
inFormOf k = likenedTo (Just k)

likenedTo :: Maybe Known -> Question a -> a -> a -> a
likenedTo about question got wanted = case question of
  op :? input -> case operationWays (recordOf op) of
    UnderProfile means _ -> maybe wanted (\k -> likened means k input got wanted) about
    WithoutProfile means _ -> likened means () input got wanted
    ByScene _ _ -> wanted
  Raw operation input -> fromMaybe wanted $ do
    SomeQuestion asked' <- someQuestion operation input
    came <- readAnswer asked' got
    form <- likenedTo about asked' came <$> readAnswer asked' wanted
    -- Values of one number are many: 0.2 and 0.20000000000000001.
    Just $
      if answerValue asked' form == answerValue asked' came then got else answerValue asked' form

-- | Why the definition answers so under a profile, in a sentence for somebody whose implementation
-- answered something else: the convention of the profile that decides it, or the rule of a refusal.
why :: Known -> Question a -> Either Refusal a -> String
why k question wanted = case wanted of
  Left (Refusal reason) -> ruleOf (operationOf question) reason
  Right _ -> case operationOf question of
    SomeOp op -> case operationWays (recordOf op) of
      UnderProfile means _ -> because means k
      WithoutProfile means _ -> because means ()
      ByScene _ _ -> "by definition"
