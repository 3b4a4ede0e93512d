-- | Trials: some questions to an implementation, those that come later chosen by the answers to
-- those before, and a judgement at the end. A trial does not know how it is asked: of a function in
-- this process, or of another process that several trials ask in turns.
module PraTactile.Conformance.Ask
  ( Ask (..),
    ask,
    answerAll,
  )
where

import Control.Monad (ap, liftM)
import PraTactile.Conformance.Question

-- | Questions, and what comes of the answers.
data Ask a
  = Done a
  | forall b. Asking (Question b) (Either Refusal b -> Ask a)

instance Functor Ask where
  fmap = liftM

instance Applicative Ask where
  pure = Done
  (<*>) = ap

instance Monad Ask where
  Done a >>= use = use a
  Asking question continue >>= use = Asking question (\answer -> continue answer >>= use)

-- | Ask one question.
ask :: Question b -> Ask (Either Refusal b)
ask question = Asking question Done

-- | Ask all of it of somebody who answers at once.
answerAll :: Monad m => (forall b. Question b -> m (Either Refusal b)) -> Ask a -> m a
answerAll answer asked = case asked of
  Done a -> pure a
  Asking question continue -> answer question >>= answerAll answer . continue
