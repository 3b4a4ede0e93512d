{-# OPTIONS_HADDOCK hide #-}

-- | The answers of an implementation under test.
module PraTactile.Conformance.Answer
  ( Wire,
    refuse,
    orRefuse,
    notOffered,
    probabilities,
  )
where

import Control.Monad.Trans.Except (ExceptT, throwE)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Question

-- | An answer of an implementation, or its refusal.
type Wire = ExceptT Refusal IO

-- | Refuse for a reason.
refuse :: String -> Wire a
refuse = throwE . Refusal

-- | The value, or a refusal for this reason.
orRefuse :: String -> Either e a -> Wire a
orRefuse reason = either (const (refuse reason)) pure

-- | The answer of a session to a question of an operation that it lacks.
notOffered :: Wire a
notOffered = refuse "not-offered"

-- | What is known of a cell as the probabilities of all q symbols: for certain, 1 of one of them;
-- 'Nothing' where nothing is known. Refuses a code of q or more as @invalid@.
probabilities :: Natural -> Chance -> Wire (Maybe [Double])
probabilities q chance = case chance of
  Unfelt -> pure Nothing
  Probably chances -> pure (Just chances)
  Certainly code
    | code < q -> pure (Just [if c == code then 1 else 0 | c <- [0 .. q - 1]])
    | otherwise -> refuse "invalid"
