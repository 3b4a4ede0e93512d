-- | Patches of small arrays, and where they lie: what impostors are asked who locate otherwise.
module Test.Conformance.Sentences.Patches
  ( -- * Arrays and patches
    smallArrays,
    patchQuestions,
    drawnPatch,
    noPatch,
    observedIn,

    -- * Surfaces
    Surface',
    surfaceOf,
    everywhere,
    wrapped,
    placeOf,
  )
where

import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), Surface (..))
import PraTactile.Conformance
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Question
import PraTactile.Profile
import Test.Conformance.Sentences.Said
import Test.QuickCheck (Gen, chooseInt, elements, frequency, vectorOf)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)

-- | Small arrays of both foldings on all surfaces, with windows of one row and of two.
smallArrays :: [Profile]
smallArrays =
  profilesNamed ["gf2-3x5", "gf2-3x5-row-major", "gf3-2x13"]
    ++ [ p {profileSurface = Sheet, profileWindow = Shape 2 2}
         | p <- profilesNamed ["gf2-3x5", "gf3-2x13"]
       ]
    ++ [p {profileSurface = TwistedTorus} | p <- profilesNamed ["gf2-3x5"]]
    ++ [p {profileWindow = Shape 1 2} | p <- profilesNamed ["gf3-2x13"]]

-- | Patches of all sizes around the window's from all over the array: as they are there, with cells
-- not felt, with cells wrong, of zeros alone; and what is no patch.
patchQuestions :: Known -> [SomeQuestion]
patchQuestions about =
  concatMap asked (patches ++ special)
    ++ [SomeQuestion (Pack []), SomeQuestion (Cell 3 3), SomeQuestion (Distance ["##"])]
  where
    asked patch =
      SomeQuestion (Locate patch) :
      map (SomeQuestion . (`Nearest` patch)) [Nothing, Just 0, Just 1, Just 3]
        ++ [SomeQuestion (Posterior (map (map (maybe Unfelt Certainly)) patch))]
    patches = unGen (vectorOf 24 (drawnPatch about)) (mkQCGen 7) 30
    q = profileOrder (knownProfile about)
    special =
      [ [],
        [[]],
        [[Just 0], []],
        [[Just q, Just 0]],
        [[Nothing, Nothing], [Nothing, Nothing]],
        [[Just q], [Just 0], [Just 1]],
        [[Nothing, Just 1], [Just 0]],
        -- Of the first row alone, or of as many cells as it has.
        [[Just 1, Nothing, Nothing, Nothing], [Just 0, Just 1, Just 0, Just 1]],
        [[Nothing, Nothing, Just 1, Nothing, Just 0], [Just 1, Just 0, Just 0, Just 1, Just 0]],
        [[Nothing, Nothing], [Just 1, Nothing], [Just 0, Just 1], [Just 1, Just 1]],
        [Just 1 : replicate 6 Nothing, map Just [1, 0, 0, 1, 1, 0, 1]],
        [Nothing : Just 1 : replicate 6 Nothing, map Just [1, 1, 0, 0, 0, 1, 0, 1]]
      ]
        ++ map (uncurry zeros) [(1, 1), (1, 4), (2, 2), (3, 3), (2, 5)]
    zeros a b = replicate a (replicate b (Just 0))

drawnPatch :: Known -> Gen Patch
drawnPatch about = do
  (r, c) <- (,) <$> below n1 <*> below n2
  high <- elements [h, h, h + 1, h + 2, max 1 (h - 1)]
  wide <- elements [w, w, w + 1, w + 2, max 1 (w - 1)]
  unfelt <- elements [0, 0, 0, 10, 40]
  wrong <- elements [0, 0, 10, 25]
  let there i j = either (const Nothing) Just (right about (Cell (r + i) (c + j)))
      damaged cell' =
        frequency
          [(unfelt, pure Nothing), (wrong, Just <$> below q), (100 - unfelt - wrong, pure cell')]
  traverse (traverse damaged) [[there i j | j <- [0 .. wide - 1]] | i <- [0 .. high - 1]]
  where
    p = knownProfile about
    q = profileOrder p
    Shape n1 n2 = profileShape p
    Shape h w = profileWindow p
    below n = fromIntegral <$> chooseInt (0, fromIntegral n - 1) :: Gen Natural

-- | What an array has at a row and a column of the profile's surface, which may be negative.
type Surface' = (Integer, Integer) -> Maybe Code

surfaceOf :: Known -> Surface'
surfaceOf about = \at -> wrapped p at >>= (`Map.lookup` array)
  where
    p = knownProfile about
    array = Map.fromList [(at, code) | at <- everywhere p, Right code <- [cellAt at]]
    cellAt (r, c) = right about (Cell (fromInteger r) (fromInteger c))

everywhere :: Profile -> [(Integer, Integer)]
everywhere p = [(r, c) | r <- [0 .. n1 - 1], c <- [0 .. n2 - 1]]
  where
    (n1, n2) = sizes p

sizes :: Profile -> (Integer, Integer)
sizes p = let Shape n1 n2 = profileShape p in (toInteger n1, toInteger n2)

-- | Where a place of the plane is on the profile's surface.
wrapped :: Profile -> (Integer, Integer) -> Maybe (Integer, Integer)
wrapped p (r, c) = case profileSurface p of
  Torus -> Just (r `mod` n1, c `mod` n2)
  TwistedTorus -> Just (((r * n2 + c) `mod` (n1 * n2)) `divMod` n2)
  Sheet -> if r >= 0 && r < n1 && c >= 0 && c < n2 then Just (r, c) else Nothing
  where
    (n1, n2) = sizes p

observedIn :: Patch -> Map.Map (Integer, Integer) Code
observedIn patch =
  Map.fromList
    [((i, j), code) | (i, line) <- zip [0 ..] patch, (j, Just code) <- zip [0 ..] line]

noPatch :: Known -> Patch -> Bool
noPatch about patch =
  all null patch
    || length (nub (map length patch)) > 1
    || any (>= profileOrder (knownProfile about)) (catMaybes (concat patch))

-- | One place, or several.
placeOf :: [(Integer, Integer)] -> Place
placeOf places = case map position places of
  [at] -> At at
  several -> OneOf several
  where
    position (r, c) = Position (fromInteger r) (fromInteger c)
