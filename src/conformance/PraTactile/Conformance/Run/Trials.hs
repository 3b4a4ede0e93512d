{-# LANGUAGE GADTs #-}

-- | Runs trials in batches. The next questions of all trials are asked together, so another
-- process always has work. The result is the first failing trial in order, as if they had run one
-- after the other.
module PraTactile.Conformance.Run.Trials
  ( search,
    Search (..),
    Trouble (..),
    Asked (..),
  )
where

import Data.Aeson (Value (..), encode)
import qualified Data.ByteString.Lazy as Lazy
import Data.List (sortOn)
import Data.Maybe (listToMaybe)
import GHC.Conc (par)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Process.Reply (excerpt)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile (Profile)

-- | What is wrong in a trial.
data Trouble
  = Wrong Violation
  | -- | After these exchanges the last request got something that is not an answer.
    Broke [Exchange] Asked (Either Fault Response)
  deriving stock (Show)

-- | A request of a trial.
data Asked
  = AskedQuestion SomeQuestion
  | AskedProfile Profile
  deriving stock (Show)

-- | The outcome of trials.
data Search = Search
  { -- | The number of judged trials, including the first failing one. Trials to which the law does
    -- not apply are not counted.
    searchCases :: Int,
    -- | The first failing trial, by its index.
    searchTrouble :: Maybe (Int, Trouble)
  }

-- | A trial in progress: its index, its exchanges (newest first), and its next request.
data Active = Active Int [Exchange] (Ask Verdict)

-- | The state of a trial, by its index.
data Fate
  = Going Active
  | Judged Int
  | -- | The law does not apply to its case.
    Unjudged
  | InTrouble Int Trouble

-- | Runs trials in batches of the given size, up to the first failing one.
search :: Subject -> Int -> [Ask Verdict] -> IO Search
search subject size = go 0 . zipWith (`Active` []) [0 ..]
  where
    go cases trials = case splitAt size trials of
      ([], _) -> pure (Search cases Nothing)
      (batch, later) -> do
        Search more trouble <- tryBatch subject batch
        maybe (go (cases + more) later) (pure . Search (cases + more) . Just) trouble

-- | Asks one question of each trial, repeatedly, until all trials before the first failing one are
-- judged.
tryBatch :: Subject -> [Active] -> IO Search
tryBatch subject = go . map settled
  where
    go fates
      | null active = pure (Search (judged + length trouble) trouble)
      | otherwise = do
        replies <- asked subject active
        let came = zipWith fed active replies
        -- Verdicts are evaluated in parallel.
        foldr par (pure ()) came
        go (ended ++ came ++ map Going (drop (length replies) active))
      where
        ended = filter (not . goesOn) fates
        active = [trial | Going trial@(Active i _ _) <- fates, isBefore i]
        judged = length [() | Judged i <- fates, isBefore i]
        isBefore i = all ((i <) . fst) trouble
        trouble = listToMaybe (sortOn fst [(i, why) | InTrouble i why <- fates])
    goesOn fate = case fate of
      Going _ -> True
      _ -> False

-- | The state of a trial, which may have ended.
settled :: Active -> Fate
settled trial@(Active i _ next) = case next of
  Done Holds -> Judged i
  Done Inapplicable -> Unjudged
  Done (Violated violation) -> InTrouble i (Wrong violation)
  _ -> Going trial

-- | Asks the next questions of the first trials; returns the replies up to the first fault.
asked :: Subject -> [Active] -> IO [Either Fault Response]
asked subject trials = case trials of
  Active _ _ (Opening profile _) : _ -> (: []) <$> subjectProfile subject profile
  _ -> subjectAsk subject (questions trials)
  where
    questions some = case some of
      Active _ _ (Asking question _) : others -> SomeQuestion question : questions others
      _ -> []

-- | Continues a trial with the reply to its request.
fed :: Active -> Either Fault Response -> Fate
fed trial@(Active i before next) reply = case next of
  Done _ -> settled trial
  Opening profile continue -> case reply of
    Right (ResponseResult (Bool True)) ->
      on Nothing (profileValue profile) (Result (Bool True)) (continue (Right ()))
    Right (ResponseRefused why) ->
      on Nothing (profileValue profile) (RefusedFor why) (continue (Left (Refusal why)))
    Right (ResponseResult value) -> broken (AskedProfile profile) (Left (wrongType value))
    _ -> broken (AskedProfile profile) reply
  Asking question continue -> case reply of
    Right (ResponseResult value) -> case readAnswer question value of
      Just answer -> onward question (Result value) (continue (Right answer))
      Nothing -> broken (AskedQuestion (SomeQuestion question)) (Left (wrongType value))
    Right (ResponseRefused why) -> onward question (RefusedFor why) (continue (Left (Refusal why)))
    _ -> broken (AskedQuestion (SomeQuestion question)) reply
  where
    broken what got = InTrouble i (Broke (reverse before) what got)
    onward :: Question b -> Reply -> Ask Verdict -> Fate
    onward question = on (Just (operationOf question)) (questionInput question)
    on operation input got = settled . Active i (Exchange operation input got : before)

wrongType :: Value -> Fault
wrongType value =
  Fault WrongType ("a result of another type: " ++ excerpt (Lazy.toStrict (encode value)))
