-- | The likely cause of a failure: the one shipped impostor that errs exactly alike.
module PraTactile.Conformance.Likely
  ( likely,
  )
where

import Control.Monad (filterM)
import Control.Monad.Trans.Except (runExceptT)
import Data.List (nub)
import Data.Maybe (isJust)
import PraTactile.Array (area)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Definition (agreesWithoutProfile)
import PraTactile.Conformance.Direct
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Law
import PraTactile.Conformance.Question
import PraTactile.Conformance.Run.Case (fewestAlike)
import PraTactile.Conformance.Wire
import PraTactile.Profile (Profile (..))

-- | The name of the impostor that gives every one of these answers under the profile, or without
-- one, if one alone does; given what was asked in at least three cases that fail, for in one or two
-- many err alike. None is looked for on arrays of more than 300 cells or over fields of more than
-- 100 elements, where to make all of them takes long.
likely :: Maybe Profile -> [[Exchange]] -> IO (Maybe String)
likely p failures
  | maybe False large p || different < fewestAlike = pure Nothing
  | otherwise = do
    alike <- filterM (errsAlike p (concat asked)) impostors
    pure $ case alike of
      [one] -> Just (impostorName one)
      _ -> Nothing
  where
    large under = area (profileShape under) > 300 || profileOrder under > 100
    asked = filter (not . null) (map (filter (isJust . exchangeOperation)) (nub failures))
    -- A question in another form is the same question.
    different = length (nub (map (map plain) asked))
    plain one = case exchangeOperation one >>= (`someQuestion` exchangeInput one) of
      Just (SomeQuestion question) -> one {exchangeInput = questionInput question}
      Nothing -> one

-- | Whether it answers all of them so.
errsAlike :: Maybe Profile -> [Exchange] -> Impostor -> IO Bool
errsAlike p exchanges impostor = case p of
  Nothing
    | all (`notElem` codeStages) (impostorTouches impostor) ->
      allAlike (sessionRespondent (withoutProfile made)) exchanges
    | otherwise -> pure False
  Just under ->
    runExceptT (open made under)
      >>= either (const (pure False)) ((`allAlike` exchanges) . sessionRespondent)
  where
    made = impostorMade impostor

allAlike :: Respondent -> [Exchange] -> IO Bool
allAlike answers exchanges = case exchanges of
  [] -> pure True
  Exchange (Just operation) input wanted : rest -> do
    got <- verdictBy answers (ask (Raw operation input))
    let reply = either (RefusedFor . refusalReason) Result got
    if isAlike (someQuestion operation input) wanted reply
      then allAlike answers rest
      else pure False
  Exchange Nothing _ _ : rest -> allAlike answers rest

-- | Whether two replies to a question are the same, or answers of which each would do for the
-- other: numbers may part in their last digits.
isAlike :: Maybe SomeQuestion -> Reply -> Reply -> Bool
isAlike asked one other = one == other || agree
  where
    agree = case (asked, one, other) of
      (Just (SomeQuestion question), Result a, Result b)
        | Just a' <- readAnswer question a,
          Just b' <- readAnswer question b ->
          agreesWithoutProfile question a' b'
      _ -> False
