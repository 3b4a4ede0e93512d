{-# LANGUAGE DerivingStrategies #-}

-- |
-- Patches that are seen turned or mirrored, and what the code alone can tell of it. Often nothing: every
-- quarter turn of a 2 x 2 window of the paper's array is another of its windows, and an array of windows with two
-- columns is its own mirror image; then only the symbols' own axes tell.
module PraTactile.Locate.Orientation
  ( -- * Orientations
    Orientation (..)
  , orientations
  , rotations
  , seenAs
  , undone

    -- * Locating in an unknown orientation
  , nearestOriented

    -- * What the code can tell
  , orientedDistance
  ) where

import Data.List (transpose)
import Data.Maybe (mapMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate.Book
import PraTactile.Locate.Nearest
import PraTactile.Locate.Patch

-- | How a patch is seen: mirrored or not, left and right exchanged; and then turned.
data Orientation = Orientation
  { mirrored :: Bool
  , quarterTurns :: Int
  -- ^ Clockwise; all that is the same modulo 4 is the same.
  }
  deriving stock (Eq, Ord, Show)

-- | The four quarter turns of an object seen from outside, the first of them none.
rotations :: [Orientation]
rotations = map (Orientation False) [0 .. 3]

-- | Those, and those of its mirror image.
orientations :: [Orientation]
orientations = rotations ++ map (Orientation True) [0 .. 3]

-- | Rows of cells as they are seen in an orientation.
--
-- >>> seenAs (Orientation False 1) ["ab", "cd"]
-- ["ca","db"]
seenAs :: Orientation -> [[a]] -> [[a]]
seenAs (Orientation flipped turns) cells = iterate clockwise (if flipped then map reverse cells else cells) !! (turns `mod` 4)
 where
  clockwise = map reverse . transpose

-- | The orientation that undoes another: the mirrored ones undo themselves.
undone :: Orientation -> Orientation
undone (Orientation flipped turns)
  | flipped = Orientation True turns
  | otherwise = Orientation False (negate turns `mod` 4)

-- | Of these orientations those in which the patch, seen so, is nearest to a position, each with its decision; the
-- position is that of the upper left cell once the orientation is undone. More than one is ambiguous. The guaranteed radius is that of
-- an orientation which is known; with several in question it promises nothing, but half of 'orientedDistance' does.
nearestOriented :: KnownField k => Book k -> [Orientation] -> Radius -> Patch k -> [(Orientation, Decision)]
nearestOriented shelf possible radius observed = filter ((== least) . decisionNearest . snd) decided
 where
  decided =
    [ (orientation, decision)
    | orientation <- possible
    , -- A patch has rows of one length, in any orientation.
    Right upright <- [patch (seenAs (undone orientation) (patchRows observed))]
    , let decision = nearest shelf radius upright
    ]
  least = case mapMaybe (decisionNearest . snd) decided of
    [] -> Nothing
    distances -> Just (minimum distances)

-- | The least number of cells in which a square patch of so many rows and columns, at one position and in one of
-- these orientations, differs from one at another position or in another orientation: so many errors and more can make one look like the
-- other. Compares every position with every position. 0 for no rows.
orientedDistance :: KnownField k => Book k -> [Orientation] -> Natural -> Natural
orientedDistance shelf possible side = minimum (same : across)
 where
  array = bookArray shelf
  shape = arrayShape array
  offsets = [Position i j | i <- below side, j <- below side]
  same = observedDistance shelf offsets
  -- To compare in two orientations is to compare in one and in what leads from it to the other.
  across =
    [ e
    | (k, from) <- zip [1 ..] possible
    , to <- drop k possible
    , r <- below (rows shape)
    , c <- below (columns shape)
    , Just content <- [traverse (traverse (cellOn r c)) [[(i, j) | j <- below side] | i <- below side]]
    , Right turned <- [patch (seenAs (undone to) (seenAs from (map (map Just) content)))]
    , Just e <- [decisionNearest (nearest shelf (UpTo 0) turned)]
    ]
  cellOn r c (i, j) = cellAt array <$> canonicalPosition (bookSurface shelf) shape (toInteger (r + i)) (toInteger (c + j))
  below n = takeWhile (< n) [0 ..]
