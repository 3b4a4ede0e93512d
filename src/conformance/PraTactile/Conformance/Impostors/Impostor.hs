{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Implementations that are wrong, each in one way in which a decoder may be wrong: the
-- definition, with one edit.
module PraTactile.Conformance.Impostors.Impostor
  ( Impostor (..),
    RightAnswers,
    definition,
    knownUnder,

    -- * Edits
    answeringOtherwise,
    withoutProfileOtherwise,
    reading,
    readingOtherwise,
    opening,
    knowing,
    under,
  )
where

import Control.Monad.Trans.Except (except, withExceptT)
import Data.Aeson (Value)
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law (Stage)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile)

-- | An implementation with a mistake in it.
data Impostor = Impostor
  { impostorName :: String,
    -- | What it does instead of what it should, as a sentence without its subject.
    impostorMistake :: String,
    -- | The stages whose laws are there to find it.
    impostorTouches :: [Stage],
    -- | What it is.
    impostorMade :: Implementation
  }

-- | What is answered to every question.
type RightAnswers = forall a. Question a -> Wire a

-- | The definition as an implementation. Touch, which has none, and objects, of which it takes
-- long, are this library's.
definition :: Implementation
definition = library {open = fmap (\k -> answering (defined k)) . knownUnder}

-- | What is known under a profile, or its refusal.
knownUnder :: Profile -> Wire Known
knownUnder = withExceptT (Refusal . reason) . except . known
  where
    reason cause = case cause of
      NoArray -> "impossible-profile"
      TooManyCells -> "table-too-large"

defined :: Known -> Question a -> Wire a
defined k = except . expected k

-- | With some answers otherwise, given what is known of the profile, and the right answers.
answeringOtherwise ::
  String ->
  String ->
  (forall a. Known -> RightAnswers -> Question a -> Wire a) ->
  Impostor
answeringOtherwise name mistake edit =
  edited name mistake (\k -> answering (edit k (defined k)))

-- | With some answers to questions that need no profile otherwise, given the right ones.
withoutProfileOtherwise ::
  String -> String -> (forall a. RightAnswers -> Question a -> Wire a) -> Impostor
withoutProfileOtherwise name mistake edit =
  Impostor
    name
    mistake
    []
    definition {withoutProfile = answering (edit (answerTo (withoutProfile library)))}

-- | Taking an input that needs no profile for another one, before it is read.
readingOtherwise :: String -> String -> (Value -> Value) -> Impostor
readingOtherwise name mistake edit =
  Impostor name mistake [] definition {withoutProfile = readingBefore edit (withoutProfile library)}

readingBefore :: (Value -> Value) -> Session -> Session
readingBefore edit (Session answers) = Session $ \question -> case question of
  Raw operation input -> answers (Raw operation (edit input))
  _ -> answers question

-- | Taking an input for another one, before it is read.
reading :: String -> String -> (Value -> Value) -> Impostor
reading name mistake edit =
  edited name mistake (\k -> readingBefore edit (answering (defined k)))

-- | Taking a profile for another one, the first of these that is possible.
opening :: String -> String -> (Profile -> [Profile]) -> Impostor
opening name mistake others = Impostor name mistake [] definition {open = firstOf . others}
  where
    firstOf profiles = case [k | Right k <- map known profiles] of
      k : _ -> pure (answering (defined k))
      [] -> refuse "impossible-profile"

-- | Answering by what is not so of an array.
knowing :: String -> String -> (Known -> Known) -> Impostor
knowing name mistake edit = edited name mistake (\k -> answering (defined (edit k)))

-- | Answering as under another profile, where that is possible.
under :: String -> String -> (Profile -> Profile) -> Impostor
under name mistake edit = knowing name mistake other
  where
    other k = either (const k) id (known (edit (knownProfile k)))

edited :: String -> String -> (Known -> Session) -> Impostor
edited name mistake made = Impostor name mistake [] definition {open = fmap made . knownUnder}
