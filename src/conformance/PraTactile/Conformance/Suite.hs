-- | The suite as it is shipped: all laws, and what the definition answers.
module PraTactile.Conformance.Suite
  ( standardSuite,
  )
where

import PraTactile.Conformance.Definition
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws (laws, openingLaws, touchLaws)
import PraTactile.Conformance.Likely (likely)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Run.Work
import PraTactile.Conformance.Wire
import PraTactile.Profile (Profile)

-- | All laws under these profiles, by their names. 'Left' with the name of one that describes no
-- array.
standardSuite :: [(String, Profile)] -> Either String (Suite Known)
standardSuite profiles = suite <$> traverse possible profiles
  where
    possible (name, profile) =
      either (const (Left name)) (\about -> Right ((name, profile), about)) (known profile)
    suite made =
      Suite
        { suiteProfiles = map fst made,
          suiteAbout = \profile ->
            case lookup profile [(p, about) | ((_, p), about) <- made] of
              Just about -> Just about
              Nothing -> either (const Nothing) Just (known profile),
          suiteLaws = laws,
          suiteOpenings = openingLaws,
          suiteTouch = touchLaws,
          suiteAnswer = answered,
          suiteLikely = likely
        }

-- | What the definition answers, as a reply of the protocol.
answered :: Known -> SomeQuestion -> Reply
answered about (SomeQuestion question) =
  either (RefusedFor . refusalReason) (Result . answerValue question) (expected about question)
