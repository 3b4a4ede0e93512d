{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | What an implementation under test must be able to do, in wire values only: profiles, element
-- codes and positions as numbers. A process in another language fits this record as well as this
-- library does.
module PraTactile.Conformance.Implementation
  ( -- * Implementations
    Implementation (..),
    Session (..),
    answering,
    notOffered,
    answerTo,
    probabilities,

    -- * Answers
    Wire,
    refuse,
  )
where

import PraTactile.Conformance.Answer
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire.Line (longestLine)
import PraTactile.Profile (Profile (..))

-- | An implementation opens a session for a profile, or refuses one that names no array.
data Implementation = Implementation
  { implementationName :: String,
    -- | What it can do. The laws that need anything else are skipped.
    offered :: [SomeOp],
    -- | Refuses a profile that names no array as @impossible-profile@: a polynomial that is not
    -- primitive, say, or sides of a diagonal fold that have a common divisor. Where it is not known
    -- whether it names one, it may be refused as @not-factored@; no law asks for one of that size.
    open :: Profile -> Wire Session,
    -- | What it says to questions about touch and objects, which know no profile; if it has none of
    -- these stages, @answering (const notOffered)@.
    withoutProfile :: Session
  }

-- | One function from every question to its answer, made by 'answering'.
newtype Session = Session (forall a. Question a -> Wire a)

-- | A session that answers so. What is asked by 'Raw' is read before the function sees it: what is
-- no input of its operation is refused as @invalid@. What no line of the protocol has room for is
-- refused as @too-long@ before it is computed.
answering :: (forall a. Question a -> Wire a) -> Session
answering answers = Session asked
  where
    asked :: Question a -> Wire a
    asked question = case question of
      Raw operation input -> case someQuestion operation input of
        Nothing -> refuse "invalid"
        Just (SomeQuestion typed) -> answerValue typed <$> asked typed
      _
        | leastBytes question > fromIntegral longestLine -> refuse "too-long"
        | otherwise -> answers question

-- | What a session answers.
answerTo :: Session -> Question a -> Wire a
answerTo (Session answers) = answers
