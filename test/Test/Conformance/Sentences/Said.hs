{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | Impostors of the code held against what they say of themselves: where an answer differs from
-- the right one, and which one it is.
module Test.Conformance.Sentences.Said
  ( Says (..),
    Sentence,
    right,
    elsewhere,
    invalid,
    refused,
    saying,
    alike,
    sentencesHold,

    -- * Profiles
    profilesNamed,
    fields,
  )
where

import Control.Monad (unless)
import Control.Monad.Trans.Except (runExceptT)
import Data.Foldable (for_)
import Data.List (find)
import Data.Traversable (for)
import PraTactile.Conformance
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire (answerValue)
import PraTactile.Profile (Profile (..))
import Test.Hspec

-- | What somebody answers.
newtype Says = Says (forall b. Question b -> Either Refusal b)

-- | The name of an impostor, and what it answers under a profile.
type Sentence = (String, Known -> Says)

-- | What the definition answers.
right :: Known -> Question b -> Either Refusal b
right = expected

-- | All that is right under another profile.
elsewhere :: String -> (Profile -> Profile) -> Sentence
elsewhere name change =
  ( name,
    \about ->
      let other = known (change (knownProfile about))
       in Says (\question -> other >>= (`expected` question))
  )

refused :: String -> Either Refusal a
refused = Left . Refusal

invalid :: Either Refusal a
invalid = refused "invalid"

-- | A sentence for a name.
saying :: String -> (forall b. Known -> Question b -> Either Refusal b) -> Sentence
saying name answers = (name, \about -> Says (answers about))

-- | Each answers all these questions as is said, some of them otherwise than is right.
sentencesHold :: [Profile] -> (Known -> [SomeQuestion]) -> [Sentence] -> Spec
sentencesHold profiles questions sentences =
  for_ sentences $ \(name, says) -> it name $ do
    one <- maybe (fail ("no impostor " ++ name)) pure (find ((== name) . impostorName) impostors)
    differs <- for profiles $ \p -> do
      about <- either (fail . show) pure (known p)
      session <- runExceptT (open (impostorMake one library) p) >>= either (fail . show) pure
      for (questions about) $ \(SomeQuestion question) -> do
        came <- runExceptT (answerOf session question)
        let Says answers = says about
            said = answers question
            shown = either refusalReason (show . answerValue question)
        unless (alike about question said came) $
          (p, show question, shown came) `shouldBe` (p, show question, shown said)
        pure (not (alike about question said (right about question)))
    or (concat differs) `shouldBe` True

-- | The same refusal, or the same answer; probabilities are held to 10^-9.
alike :: Known -> Question b -> Either Refusal b -> Either Refusal b -> Bool
alike about question said came = case (said, came) of
  (Left a, Left b) -> a == b
  (Right a, Right b) -> case question of
    Posterior _ -> agrees about question a b
    Raw OfPosterior _ -> agrees about question a b
    _ -> answerValue question a == answerValue question b
  _ -> False

-- | Default profiles by their names.
profilesNamed :: [String] -> [Profile]
profilesNamed names = [p | name <- names, Just p <- [lookup name defaultProfiles]]

-- | A profile of every field of the default profiles, and of the others over GF(8) and GF(9).
fields :: [Profile]
fields =
  profilesNamed ["gf2-3x5", "gf3-2x13", "paper", "gf5-4x31", "gf8-7x9", "gf9-80x1", "gf9-5x16"]
    ++ concatMap
      (take 1)
      [ [ p
          | a <- [1 .. q - 1],
            b <- [1 .. q - 1],
            p <- profilesNamed [name],
            p' <- [p {profileModulus = modulus, profilePolynomial = [a, b, 1]}],
            Right _ <- [known p']
        ]
        | (q, name, modulus) <- [(8, "gf8-7x9", [1, 1, 0, 1]), (9, "gf9-80x1", [2, 1, 1])]
      ]
