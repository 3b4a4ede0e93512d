-- | Profiles that name no array are refused.
module PraTactile.Conformance.Laws.Opening
  ( openingLaws,
  )
where

import PraTactile.Array (Shape (..))
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Profile (Profile (..), canonicalProfile)

-- | Each an impossible change of the canonical profile.
openingLaws :: [Law Implementation]
openingLaws =
  [ refused "q = 6 is no prime power" canonicalProfile {profileOrder = 6},
    refused
      "the modulus x^2 + 1 = (x + 1)^2 is reducible over GF(2)"
      canonicalProfile
        { profileModulus = [1, 0, 1]
        },
    refused "the modulus of GF(4) has degree 2" canonicalProfile {profileModulus = [1, 1, 0, 1]},
    refused "x^4 + 1 is not primitive" canonicalProfile {profilePolynomial = [1, 0, 0, 0, 1]},
    refused "a polynomial must be monic" canonicalProfile {profilePolynomial = [3, 2, 1, 0, 2]},
    refused
      "a coefficient must be an element"
      canonicalProfile
        { profilePolynomial = [3, 2, 1, 4, 1]
        },
    refused "the state must not be zero" canonicalProfile {profileState = [0, 0, 0, 0]},
    refused "the state has n elements" canonicalProfile {profileState = [0, 0, 1]},
    refused "16 x 16 has 256 cells, not 255" canonicalProfile {profileShape = Shape 16 16},
    refused
      "the sides of 15 x 273 are both divisible by 3"
      canonicalProfile
        { profilePolynomial = [2, 1, 1, 0, 0, 0, 1],
          profileState = [0, 0, 0, 0, 0, 1],
          profileShape = Shape 15 273,
          profileWindow = Shape 2 3
        },
    refused "a window has cells" canonicalProfile {profileWindow = Shape 0 2}
  ]
  where
    refused name impossible =
      Law
        (name ++ ": impossible-profile")
        ( \implementation ->
            refuses "impossible-profile" (profile <$> open implementation impossible)
        )
