{-# LANGUAGE GADTs #-}

-- | Trials in batches: the next question of each trial is asked together with those of the others,
-- so that another process always has something to do. The first trial in order that is in trouble
-- is the one that would be found by trying one after the other.
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

-- | What is wrong with a case.
data Trouble
  = Wrong Violation
  | -- | After these exchanges this was asked, and that came, which is no answer.
    Broke [Exchange] Asked (Either Fault Response)
  deriving stock (Show)

-- | A request that a trial makes.
data Asked
  = AskedQuestion SomeQuestion
  | AskedProfile Profile
  deriving stock (Show)

-- | The outcome of trials.
data Search = Search
  { -- | The number of trials judged, up to the first one in trouble. A trial that the law says
    -- nothing of does not count.
    searchCases :: Int,
    -- | The first trial in trouble, by its index.
    searchTrouble :: Maybe (Int, Trouble)
  }

-- | A trial that goes on: its index, its exchanges with the last one first, and its next request.
data Active = Active Int [Exchange] (Ask Verdict)

-- | What has become of a trial, by its index.
data Fate
  = Going Active
  | Judged Int
  | -- | The law says nothing of its case.
    Unjudged
  | InTrouble Int Trouble

-- | Try these, in batches of this size, up to the first one in trouble.
search :: Subject -> Int -> [Ask Verdict] -> IO Search
search subject size = go 0 . zipWith (`Active` []) [0 ..]
  where
    go cases trials = case splitAt size trials of
      ([], _) -> pure (Search cases Nothing)
      (batch, later) -> do
        Search more trouble <- tryBatch subject batch
        maybe (go (cases + more) later) (pure . Search (cases + more) . Just) trouble

-- | Ask one question of each trial, and again, until all before the first one in trouble are
-- judged.
tryBatch :: Subject -> [Active] -> IO Search
tryBatch subject = go . map settled
  where
    go fates
      | null active = pure (Search (judged + length trouble) trouble)
      | otherwise = do
        replies <- asked subject active
        let came = zipWith fed active replies
        -- Each verdict by whichever core is free.
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

-- | The fate of a trial that may have nothing more to ask.
settled :: Active -> Fate
settled trial@(Active i _ next) = case next of
  Done Holds -> Judged i
  Done Inapplicable -> Unjudged
  Done (Violated violation) -> InTrouble i (Wrong violation)
  _ -> Going trial

-- | What the first trials ask next, asked; the replies up to the first fault.
asked :: Subject -> [Active] -> IO [Either Fault Response]
asked subject trials = case trials of
  Active _ _ (Opening profile _) : _ -> (: []) <$> subjectProfile subject profile
  _ -> subjectAsk subject (questions trials)
  where
    questions some = case some of
      Active _ _ (Asking question _) : others -> SomeQuestion question : questions others
      _ -> []

-- | A trial with the reply to its request.
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
