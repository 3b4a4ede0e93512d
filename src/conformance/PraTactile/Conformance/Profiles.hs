-- | The profiles under which an implementation is tried unless others are named: characteristic 2,
-- 3 and 5, prime and extension fields, other moduli, states and readings, both foldings, all
-- surfaces and both packings; windows that repeat, and windows whose numbers no double holds.
module PraTactile.Conformance.Profiles
  ( defaultProfiles,
    profileNamed,
    apartMask,
  )
where

import Data.List (find)
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (..), Surface (..))
import PraTactile.Profile
import PraTactile.Window (Packing (..))

-- | The default profiles, each with a name that stays.
defaultProfiles :: [(String, Profile)]
defaultProfiles = papers ++ fields ++ windows

-- | The name of a profile among the default ones.
profileNamed :: Profile -> Maybe String
profileNamed profile = fst <$> find ((== profile) . snd) defaultProfiles

-- | The cells (0, 0), (0, 9) and (11, 8): on the paper's array they have rank 3, yet all windows on
-- the sheet differ.
apartMask :: [String]
apartMask = "#........#" : replicate 10 ".........." ++ ["........#."]

-- | The paper's array, each convention but one or two as the paper has it.
papers :: [(String, Profile)]
papers =
  [ ("paper", canonicalProfile),
    ( "paper-sheet",
      canonicalProfile {profileSurface = Sheet, profilePacking = LeastSignificantFirst}
    ),
    ("paper-state", canonicalProfile {profileState = [3, 1, 0, 2]}),
    ("paper-reciprocal", canonicalProfile {profileReading = Reciprocal}),
    ("paper-twisted", canonicalProfile {profileSurface = TwistedTorus})
  ]

-- | Other fields and sizes.
fields :: [(String, Profile)]
fields =
  [ ("gf2-3x5", over 2 [1, 1] [1, 1, 0, 0, 1] (Shape 3 5) (Shape 2 2)),
    ( "gf2-3x5-row-major",
      (over 2 [1, 1] [1, 1, 0, 0, 1] (Shape 3 5) (Shape 1 4))
        { profileFolding = RowMajor,
          profileSurface = TwistedTorus
        }
    ),
    ("gf3-2x13", over 3 [1, 1] [1, 2, 0, 1] (Shape 2 13) (Shape 1 3)),
    ("gf4-63x65", over 4 [1, 1, 1] [2, 1, 1, 0, 0, 0, 1] (Shape 63 65) (Shape 3 2)),
    ("gf5-4x31", over 5 [3, 1] [2, 3, 0, 1] (Shape 4 31) (Shape 1 3)),
    ("gf8-7x9", over 8 [1, 0, 1, 1] [5, 2, 1] (Shape 7 9) (Shape 1 2)),
    ("gf9-80x1", over 9 [2, 2, 1] [3, 1, 1] (Shape 80 1) (Shape 2 1)),
    -- The root of this modulus has order 4, so that the primitive element is another one.
    ( "gf9-5x16",
      (over 9 [1, 0, 1] [7, 5, 1] (Shape 5 16) (Shape 1 2))
        { profileReading = Reciprocal,
          profileState = [3, 1]
        }
    )
  ]

-- | Windows that are too small, and one of 20 cells.
windows :: [(String, Profile)]
windows =
  [ ("gf9-5x16-window-4x5", over 9 [2, 2, 1] [3, 1, 1] (Shape 5 16) (Shape 4 5)),
    ("gf4-15x17-window-1x2", canonicalProfile {profileWindow = Shape 1 2}),
    ( "gf4-15x17-window-1x2-sheet",
      canonicalProfile {profileWindow = Shape 1 2, profileSurface = Sheet}
    )
  ]

-- | A field by q and its modulus, a polynomial, a shape and a window, with the conventions of the
-- paper's array.
over :: Natural -> [Natural] -> [Natural] -> Shape -> Shape -> Profile
over q modulus h shape window =
  canonicalProfile
    { profileOrder = q,
      profileModulus = modulus,
      profilePolynomial = h,
      profileState = replicate (length h - 2) 0 ++ [1],
      profileShape = shape,
      profileWindow = window
    }
