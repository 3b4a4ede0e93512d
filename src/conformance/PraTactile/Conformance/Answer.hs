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

-- | Refuses with the given reason.
refuse :: String -> Wire a
refuse = throwE . Refusal

-- | The value, or a refusal with the given reason.
orRefuse :: String -> Either e a -> Wire a
orRefuse reason = either (const (refuse reason)) pure

-- | The refusal of an operation that a session does not offer.
notOffered :: Wire a
notOffered = refuse "not-offered"

-- | A cell's knowledge as the probabilities of all q symbols: a certain symbol has probability 1;
-- 'Nothing' for an unknown cell. Refuses a code of q or more as @invalid@.
probabilities :: Natural -> Chance -> Wire (Maybe [Double])
probabilities q chance = case chance of
  Unfelt -> pure Nothing
  Probably chances -> pure (Just chances)
  Certainly code
    | code < q -> pure (Just [if c == code then 1 else 0 | c <- [0 .. q - 1]])
    | otherwise -> refuse "invalid"
