-- | The suite as it is shipped: all laws, and what the definition answers.
module PraTactile.Conformance.Suite
  ( standardSuite,
    noSuiteText,
  )
where

import Data.Bifunctor (bimap)
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws (laws, lawsWithoutProfile, openingLaws)
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Run.Work
import PraTactile.Profile (Profile)

-- | All laws under these profiles, by their names. 'Left' with the name of one of which the
-- definition knows nothing, and why that is ('known').
standardSuite :: [(String, Profile)] -> Either (String, Unknown) (Suite Known)
standardSuite profiles = suite <$> traverse possible profiles
  where
    possible (name, profile) =
      bimap ((,) name) ((,) (name, profile)) (known profile)
    suite made =
      Suite
        { suiteProfiles = map fst made,
          suiteAbout = \profile ->
            case lookup profile [(p, about) | ((_, p), about) <- made] of
              Just about -> Just about
              Nothing -> either (const Nothing) Just (known profile),
          suiteLaws = laws,
          suiteOpenings = openingLaws,
          suiteWithoutProfile = lawsWithoutProfile,
          suiteAnswer = answered
        }

-- | Why there is no suite about such a profile.
noSuiteText :: (String, Unknown) -> String
noSuiteText (name, unknown) = name ++ ": " ++ unknownText unknown

-- | What the definition answers, as a reply of the protocol.
answered :: Known -> SomeQuestion -> Reply
answered about (SomeQuestion question) =
  either (RefusedFor . refusalReason) (Result . answerValue question) (expected about question)
