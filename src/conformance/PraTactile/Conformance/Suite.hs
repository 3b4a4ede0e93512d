-- | The shipped suite: all laws, and the answers of the definition.
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

-- | All laws under the given named profiles. 'Left' with the first profile that the definition
-- cannot handle, and the reason ('known').
standardSuite :: [(String, Profile)] -> Either (String, Unknown) (Suite ProfileFacts)
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

-- | The message for such a profile.
noSuiteText :: (String, Unknown) -> String
noSuiteText (name, unknown) = name ++ ": " ++ unknownText unknown

-- | The definition's answer, as a reply of the protocol.
answered :: ProfileFacts -> SomeQuestion -> Reply
answered about (SomeQuestion question) =
  either (RefusedFor . refusalReason) (Result . answerValue question) (expected about question)
