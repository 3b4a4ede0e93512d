-- | The default profiles for testing an implementation. They cover characteristics 2, 3, 5, 7 and
-- 211; prime and extension fields up to GF(256); several moduli, states and readings; both
-- foldings, all surfaces and both packings, and any two of these together; sides with a common
-- divisor; degrees from 1 to 9; and an array of more than 2^16 cells. Their windows include ones
-- that repeat, ones as large as the array and larger, and ones whose numbers exceed a double's
-- precision.
module PraTactile.Conformance.Profiles
  ( defaultProfiles,
    profileNamed,
    over,
    apartMask,
  )
where

import Data.List (find, foldl')
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (..), Surface (..))
import PraTactile.Profile
import PraTactile.Window (Packing (..))

-- | The default profiles, each with a permanent name. After the paper's, each differs in as many
-- keys as possible from those before it, so that a mistake in any key is found early.
defaultProfiles :: [(String, Profile)]
defaultProfiles = case papers ++ fields ++ windows ++ combined of
  first : others -> first : go [first] others
  [] -> []
  where
    go _ [] = []
    go before (one : more) =
      let next = foldl' (\a b -> if apart before b > apart before a then b else a) one more
       in next : go (next : before) (filter ((/= fst next) . fst) (one : more))
    apart before (_, p) = (minimum counts, sum counts)
      where
        counts = [differing p other | (_, other) <- before]

-- | The number of keys in which two profiles differ.
differing :: Profile -> Profile -> Int
differing a b =
  length . filter id $
    [ on profileOrder,
      on profileModulus,
      on profilePolynomial,
      on profileReading,
      on profileState,
      on profileFolding,
      on profileShape,
      on profileWindow,
      on profileSurface,
      on profilePacking
    ]
  where
    on :: Eq a => (Profile -> a) -> Bool
    on key = key a /= key b

-- | The name of a default profile.
profileNamed :: Profile -> Maybe String
profileNamed profile = fst <$> find ((== profile) . snd) defaultProfiles

-- | A mask of the cells (0, 0), (0, 9) and (11, 8): on the paper's array they have rank 3, yet all
-- windows on the sheet differ.
apartMask :: [String]
apartMask = "#........#" : replicate 10 ".........." ++ ["........#."]

-- | The paper's array with one or two other conventions.
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
    -- The root of this modulus has order 4, so it is not the primitive element.
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

-- | Combinations that the others lack.
combined :: [(String, Profile)]
combined =
  [ ( "gf7-4x12-row-major",
      (over 7 [4, 1] [5, 2, 1] (Shape 4 12) (Shape 1 3))
        { profileReading = Reciprocal,
          profileState = [3, 5],
          profileFolding = RowMajor,
          profilePacking = LeastSignificantFirst
        }
    ),
    ( "gf16-17x15-row-major-sheet",
      (over 16 [1, 1, 1, 1, 1] [6, 11, 1] (Shape 17 15) (Shape 3 1))
        { profileReading = Reciprocal,
          profileState = [9, 4],
          profileFolding = RowMajor,
          profileSurface = Sheet
        }
    ),
    ( "gf25-48x13-row-major-twisted",
      (over 25 [2, 0, 1] [18, 14, 1] (Shape 48 13) (Shape 2 1))
        { profileState = [7, 20],
          profileFolding = RowMajor,
          profileSurface = TwistedTorus,
          profilePacking = LeastSignificantFirst
        }
    ),
    ( "gf49-16x3-sheet",
      (over 49 [1, 0, 1] [12, 1] (Shape 16 3) (Shape 1 2))
        { profileReading = Reciprocal,
          profileState = [13],
          profileSurface = Sheet,
          profilePacking = LeastSignificantFirst
        }
    ),
    ( "gf5-3x8-window-3x8-sheet",
      (over 5 [3, 1] [3, 3, 1] (Shape 3 8) (Shape 3 8))
        { profileState = [2, 0],
          profileSurface = Sheet
        }
    ),
    ( "gf2-7x73-row-major-torus",
      (over 2 [1, 1] [1, 0, 0, 1, 0, 1, 1, 0, 0, 1] (Shape 7 73) (Shape 3 3))
        { profileReading = Reciprocal,
          profileFolding = RowMajor,
          profilePacking = LeastSignificantFirst
        }
    ),
    ( "gf3-5x16-window-6x17-twisted",
      (over 3 [1, 1] [2, 1, 1, 2, 1] (Shape 5 16) (Shape 6 17))
        { profileReading = Reciprocal,
          profileState = [0, 1, 2, 0],
          profileSurface = TwistedTorus,
          profilePacking = LeastSignificantFirst
        }
    ),
    ("gf7-304x387", over 7 [4, 1] [5, 5, 5, 3, 5, 6, 1] (Shape 304 387) (Shape 2 3)),
    ( "gf211-14x15-window-9x8-twisted",
      (over 211 [209, 1] [47, 1] (Shape 14 15) (Shape 9 8))
        { profileReading = Reciprocal,
          profileState = [100],
          profileFolding = RowMajor,
          profileSurface = TwistedTorus
        }
    ),
    ( "gf243-2x121",
      (over 243 [1, 2, 0, 0, 0, 1] [135, 1] (Shape 2 121) (Shape 1 1))
        { profilePacking = LeastSignificantFirst
        }
    ),
    ("gf256-15x17", over 256 [1, 0, 1, 1, 1, 0, 0, 0, 1] [2, 1] (Shape 15 17) (Shape 1 1))
  ]

-- | A profile with the conventions of the paper's array. The arguments are q, the modulus, the
-- polynomial, the array's shape and the window's.
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
