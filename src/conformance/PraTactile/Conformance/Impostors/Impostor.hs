{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Deliberately wrong implementations, each with one mistake that a decoder may have: the
-- definition with one edit.
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

-- | A wrong implementation.
data Impostor = Impostor
  { impostorName :: String,
    -- | The mistake, as a sentence without its subject, e.g. \"adds codes as numbers modulo q\".
    impostorMistake :: String,
    -- | The stages whose laws should find it.
    impostorTouches :: [Stage],
    -- | The implementation itself.
    impostorMade :: Implementation
  }

-- | The right answer to every question.
type RightAnswers = forall a. Question a -> Wire a

-- | The definition as an implementation. Touch, which has no definition, and objects, whose
-- definition is slow, are this library's.
definition :: Implementation
definition = library {open = fmap (\k -> answering (defined k)) . knownUnder}

-- | What is known under a profile; refuses as an implementation does.
knownUnder :: Profile -> Wire ProfileFacts
knownUnder = withExceptT (Refusal . reason) . except . known
  where
    reason cause = case cause of
      NoArray -> "impossible-profile"
      TooManyCells -> "table-too-large"

defined :: ProfileFacts -> Question a -> Wire a
defined k = except . expected k

-- | Changes some answers. The edit gets what is known of the profile and the right answers.
answeringOtherwise ::
  String ->
  String ->
  (forall a. ProfileFacts -> RightAnswers -> Question a -> Wire a) ->
  Impostor
answeringOtherwise name mistake edit =
  edited name mistake (\k -> answering (edit k (defined k)))

-- | Changes some answers to questions that need no profile. The edit gets the right answers.
withoutProfileOtherwise ::
  String -> String -> (forall a. RightAnswers -> Question a -> Wire a) -> Impostor
withoutProfileOtherwise name mistake edit =
  Impostor
    name
    mistake
    []
    definition {withoutProfile = answering (edit (answerTo (withoutProfile library)))}

-- | Changes the JSON of an input that needs no profile before it is read.
readingOtherwise :: String -> String -> (Value -> Value) -> Impostor
readingOtherwise name mistake edit =
  Impostor name mistake [] definition {withoutProfile = readingBefore edit (withoutProfile library)}

readingBefore :: (Value -> Value) -> Session -> Session
readingBefore edit (Session answers) = Session $ \question -> case question of
  Raw operation input -> answers (Raw operation (edit input))
  _ -> answers question

-- | Changes the JSON of an input before it is read.
reading :: String -> String -> (Value -> Value) -> Impostor
reading name mistake edit =
  edited name mistake (\k -> readingBefore edit (answering (defined k)))

-- | Opens another profile instead: the first possible one of these.
opening :: String -> String -> (Profile -> [Profile]) -> Impostor
opening name mistake others = Impostor name mistake [] definition {open = firstOf . others}
  where
    firstOf profiles = case [k | Right k <- map known profiles] of
      k : _ -> pure (answering (defined k))
      [] -> refuse "impossible-profile"

-- | Answers from changed knowledge of the array.
knowing :: String -> String -> (ProfileFacts -> ProfileFacts) -> Impostor
knowing name mistake edit = edited name mistake (\k -> answering (defined (edit k)))

-- | Answers as under another profile, if that is possible.
under :: String -> String -> (Profile -> Profile) -> Impostor
under name mistake edit = knowing name mistake other
  where
    other k = either (const k) id (known (edit (knownProfile k)))

edited :: String -> String -> (ProfileFacts -> Session) -> Impostor
edited name mistake made = Impostor name mistake [] definition {open = fmap made . knownUnder}
