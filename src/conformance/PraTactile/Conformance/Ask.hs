{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE RankNTypes #-}

-- | Trials: questions to an implementation, where later ones may depend on earlier answers, and a
-- final judgement. A trial is independent of the transport: a function in this process, or another
-- process that several trials use in turn. A trial that opens profiles needs the implementation for
-- itself, because it changes the profile in force.
module PraTactile.Conformance.Ask
  ( Ask (..),
    ask,
    opening,
    answerAll,
  )
where

import Control.Monad (ap, liftM)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile)

-- | A computation that asks questions and uses the answers.
data Ask a
  = Done a
  | forall b. Asking (Question b) (Either Refusal b -> Ask a)
  | -- | Puts a profile in force. Later questions are asked under it.
    Opening Profile (Either Refusal () -> Ask a)

instance Functor Ask where
  fmap = liftM

instance Applicative Ask where
  pure = Done
  (<*>) = ap

instance Monad Ask where
  Done a >>= use = use a
  Asking question continue >>= use = Asking question (\answer -> continue answer >>= use)
  Opening profile continue >>= use = Opening profile (\answer -> continue answer >>= use)

-- | Asks one question.
ask :: Question b -> Ask (Either Refusal b)
ask question = Asking question Done

-- | Puts a profile in force.
opening :: Profile -> Ask (Either Refusal ())
opening profile = Opening profile Done

-- | Runs a trial, one question after the other. The functions open a profile and answer a question.
answerAll ::
  Monad m =>
  (Profile -> m (Either Refusal ())) ->
  (forall b. Question b -> m (Either Refusal b)) ->
  Ask a ->
  m a
answerAll open answer asked = case asked of
  Done a -> pure a
  Asking question continue -> answer question >>= answerAll open answer . continue
  Opening profile continue -> open profile >>= answerAll open answer . continue
