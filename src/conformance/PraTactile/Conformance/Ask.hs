{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE RankNTypes #-}

-- | Trials: some questions to an implementation, those that come later chosen by the answers to
-- those before, and a judgement at the end. A trial does not know how it is asked: of a function in
-- this process, or of another process that several trials ask in turns. A trial that opens profiles
-- has the implementation for itself, because the profile then in force is another one.
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

-- | Questions, and what comes of the answers.
data Ask a
  = Done a
  | forall b. Asking (Question b) (Either Refusal b -> Ask a)
  | -- | Put this profile in force; what is asked after it is asked under it.
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

-- | Ask one question.
ask :: Question b -> Ask (Either Refusal b)
ask question = Asking question Done

-- | Put a profile in force.
opening :: Profile -> Ask (Either Refusal ())
opening profile = Opening profile Done

-- | Ask all of it of somebody who opens profiles and answers at once.
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
