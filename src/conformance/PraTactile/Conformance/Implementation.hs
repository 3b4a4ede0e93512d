{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | The interface of an implementation under test, in protocol values only: profiles, element
-- codes and positions as numbers. A process in another language fits it as well as this library.
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

-- | An implementation opens a session for a profile, or refuses a profile that describes no array.
data Implementation = Implementation
  { implementationName :: String,
    -- | The operations that it offers. Laws that need others are skipped.
    offered :: [SomeOp],
    -- | Opens a session. Refuses a profile that describes no array as @impossible-profile@: for
    -- example a polynomial that is not primitive, or sides of a diagonal fold with a common
    -- divisor. If that cannot be decided, it may be refused as @not-factored@; no law uses a
    -- profile of that size.
    open :: Profile -> Wire Session,
    -- | The answers to questions about touch and objects, which need no profile; @answering (const
    -- notOffered)@ if it offers none of these.
    withoutProfile :: Session
  }

-- | One function from every question to its answer, made by 'answering'.
newtype Session = Session (forall a. Question a -> Wire a)

-- | A session from a function of questions. 'Raw' inputs are read before the function sees them;
-- invalid ones are refused as @invalid@. Answers too long for a protocol line are refused as
-- @too-long@ before they are computed.
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

-- | The answer of a session to a question.
answerTo :: Session -> Question a -> Wire a
answerTo (Session answers) = answers
