{-# LANGUAGE RankNTypes #-}

-- | Trials asked with answers of our own: what is asked, and the verdict.
module Test.Conformance.Laws.Trials
  ( SomeQuestion (..),
    askedBy,
    passes,
    draws,
  )
where

import Control.Monad.Trans.Writer.Strict (Writer, runWriter, tell)
import PraTactile.Conformance
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law (Verdict (..))
import Test.QuickCheck (Gen, vectorOf)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)

-- | The verdict on who answers so, and what a trial asks of that one.
askedBy ::
  (forall b. Question b -> Either Refusal b) -> Ask Verdict -> (Verdict, [SomeQuestion])
askedBy answers = runWriter . answerAll (const (pure (Right ()))) reply
  where
    reply :: Question b -> Writer [SomeQuestion] (Either Refusal b)
    reply question = answers question <$ tell [SomeQuestion question]

-- | Whether a trial holds of who answers so.
passes :: (forall b. Question b -> Either Refusal b) -> Ask Verdict -> Bool
passes answers trial = fst (askedBy answers trial) == Holds

-- | So many values of a generator.
draws :: Int -> Gen a -> [a]
draws count gen = unGen (vectorOf count gen) (mkQCGen 1) 50
