{-# LANGUAGE RankNTypes #-}

-- | Asks an implementation in this process, without the JSON of the protocol.
module PraTactile.Conformance.Direct
  ( Respondent,
    sessionRespondent,
    openingRespondent,
    verdictBy,
    firstViolated,
  )
where

import Control.Monad.Trans.Except (runExceptT)
import Data.IORef
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile)

-- | A function that puts profiles in force and one that answers questions.
data Respondent
  = Respondent (Profile -> IO (Either Refusal ())) (forall b. Question b -> IO (Either Refusal b))

-- | A session that answers questions under its own profile, or questions that need none. It opens
-- no profiles.
sessionRespondent :: Session -> Respondent
sessionRespondent asked = Respondent (const (runExceptT notOffered)) (runExceptT . answerTo asked)

-- | An implementation that opens profiles and answers under the one in force.
openingRespondent :: Implementation -> IO Respondent
openingRespondent implementation = do
  force <- newIORef Nothing
  let opens p = do
        opened <- runExceptT (open implementation p)
        writeIORef force (either (const Nothing) Just opened)
        pure (() <$ opened)
      answers :: Question b -> IO (Either Refusal b)
      answers question =
        readIORef force >>= runExceptT . maybe notOffered (`answerTo` question)
  pure (Respondent opens answers)

-- | The result of a trial.
verdictBy :: Respondent -> Ask a -> IO a
verdictBy (Respondent opens answers) = answerAll opens answers

-- | The first violated trial with its number (from 1) among at most the given number of judged
-- trials.
firstViolated :: Respondent -> Int -> [Ask Verdict] -> IO (Maybe (Int, Violation))
firstViolated answers = go 1
  where
    go n left trials = case trials of
      one : rest | left > 0 -> do
        got <- verdictBy answers one
        case got of
          Violated violation -> pure (Just (n :: Int, violation))
          Holds -> go (n + 1) (left - 1) rest
          Inapplicable -> go (n + 1) left rest
      _ -> pure Nothing
