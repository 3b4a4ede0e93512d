{-# LANGUAGE DeriveTraversable #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Patches: rectangles of cells, some of them observed.
module PraTactile.Locate.Patch
  ( -- * Patches
    Patch,
    patch,
    patchShape,
    observedCells,
    observedOffsets,
    patchRows,
    patchOf,
    withoutCells,
    uprightAs,
    completeWindows,
    windowsWithout,

    -- * Errors
    LocateError (..),
  )
where

import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Grid (raggedRow)
import PraTactile.Symmetry
import PraTactile.Window

-- | Why there is no table or patch.
data LocateError
  = -- | The table would have this many entries, more than the second number.
    TableTooLarge Natural Natural
  | -- | The array does not fit in memory.
    TableArray FoldError
  | -- | The patch has no cells.
    PatchEmpty
  | -- | The row with this index, from 0, has the second number of cells instead of the third.
    PatchRagged Int Int Int
  | -- | The array has this many cells, more than the second number, too many to compare a patch
    -- with each.
    TooManyPlaces Natural Natural
  | -- | The rectangle around the patches has this many cells, more than the second number.
    PatchTooLarge Natural Natural
  | -- | There are this many patches, more than the second number.
    PatchesTooMany Natural Natural
  deriving stock (Eq, Show)

-- | A rectangle of cells, some of them observed.
data Patch a = Patch
  { -- | The rows and columns, at least one each.
    patchShape :: !Shape,
    -- | The observed cells by their offsets, row by row.
    observedCells :: [(Position, a)]
  }
  deriving stock (Eq, Show, Functor, Foldable, Traversable)

-- | The offsets of the observed cells, row by row.
observedOffsets :: Patch a -> [Position]
observedOffsets = map fst . observedCells

-- | The patch with these rows, where 'Nothing' is a cell that was not observed. Refuses a patch
-- without cells, and rows of different lengths. O(a) for a cells.
patch :: [[Maybe a]] -> Either LocateError (Patch a)
patch cells
  | width == 0 = Left PatchEmpty
  | Just (i, given, first) <- raggedRow cells = Left (PatchRagged i given first)
  | otherwise = Right (Patch (Shape (fromIntegral (length cells)) (fromIntegral width)) known)
  where
    width = sum (map length (take 1 cells))
    known = [(Position i j, a) | (i, line) <- zip [0 ..] cells, (j, Just a) <- zip [0 ..] line]

-- | The patch of this shape with these observed cells. The shape must have a cell, and the observed
-- cells must lie within it, row by row; this is not checked.
patchOf :: Shape -> [(Position, a)] -> Patch a
patchOf = Patch

-- | The rows, as 'patch' takes them. O(a log a) for a cells.
patchRows :: Patch a -> [[Maybe a]]
patchRows (Patch (Shape h w) cells) =
  [[Map.lookup (Position i j) known | j <- [0 .. w - 1]] | i <- [0 .. h - 1]]
  where
    known = Map.fromDistinctAscList cells

-- | The patch with the cells at these offsets marked as not observed.
withoutCells :: [Position] -> Patch a -> Patch a
withoutCells gone (Patch shape cells) = Patch shape (filter ((`notElem` gone) . fst) cells)

-- | Turns a patch that is seen in this symmetry upright.
uprightAs :: Symmetry -> Patch a -> Patch a
uprightAs symmetry seen@(Patch shape cells)
  | symmetry == identity = seen
  | otherwise =
    Patch
      (onShape back shape)
      (sortOn fst [(onPosition back shape offset, a) | (offset, a) <- cells])
  where
    back = invert symmetry

-- | The offsets, row by row, at which every cell of the mask is observed, with the content of these
-- cells.
completeWindows :: Mask -> Patch a -> [(Position, [a])]
completeWindows mask (Patch _ cells) =
  [ (Position i j, content)
    | Position i0 j0 <- take 1 offsets,
      -- A window begins where its first cell is observed.
      (Position r0 c0, _) <- cells,
      r0 >= i0 && c0 >= j0,
      let i = r0 - i0
          j = c0 - j0,
      Just content <-
        [traverse (\(Position r c) -> Map.lookup (Position (i + r) (j + c)) known) offsets]
  ]
  where
    offsets = maskOffsets mask
    known = Map.fromDistinctAscList cells

-- | The offsets of the complete windows without any of these cells, row by row.
windowsWithout :: [Position] -> Mask -> Patch a -> [Position]
windowsWithout wrong mask observed =
  [ offset
    | (offset@(Position i j), _) <- completeWindows mask observed,
      and [Position (i + i') (j + j') `Set.notMember` excluded | Position i' j' <- maskOffsets mask]
  ]
  where
    excluded = Set.fromList wrong
