{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE RoleAnnotations #-}

-- |
-- Patches: what was read of the array in one place, with cells that were not read. Internal;
-- "PraTactile.Locate" exports what a user needs.
module PraTactile.Locate.Patch
  ( Patch
  , patch
  , patchWith
  , patchShape
  , rectangular
  , LocateError (..)
  , patchRows
  , rearranged
  , observedCells
  , completeWindows
  ) where

import Data.List (sortOn)
import qualified Data.Vector as Boxed
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Window

-- | Why there is no table or no patch.
data LocateError
  = -- | The table would have this many entries, more than the second number.
    TableTooLarge Natural Natural
  | -- | The array does not fit into memory.
    TableArray FoldError
  | -- | The patch has no cells.
    PatchEmpty
  | -- | The row with this index, from 0, has this many cells instead of that many.
    PatchRagged Int Int Int
  | -- | The array has this many cells, more than the second number: too many to compare a patch with
    -- each of them.
    TooManyPlaces Natural Natural
  | -- | The rectangle around patches has this many cells, more than the second number.
    PatchTooLarge Natural Natural
  | -- | These are so many patches, more than the second number.
    PatchesTooMany Natural Natural
  deriving stock (Eq, Show)

-- | A rectangle of observed and unobserved cells.
data Patch (k :: Field) = Patch
  { patchShape :: !Shape
  -- ^ Its rows and columns; at least one each.
  , observedCells :: [(Position, GF k)]
  -- ^ The observed cells with their offsets, row by row.
  , patchCells :: Boxed.Vector (Maybe (GF k))
  -- ^ All cells, row by row; made when first asked for, because few observed cells far apart make a large rectangle.
  }

type role Patch nominal

-- | The patch with these rows; 'Nothing' is a cell that was not observed. Refuses no cells and rows
-- of different lengths.
patch :: [[Maybe (GF k)]] -> Either LocateError (Patch k)
patch cells = do
  shape <- rectangular cells
  let everything = Boxed.fromList (concat cells)
  everything `seq` pure (Patch shape (observedIn shape everything) everything)
 where
  observedIn shape everything =
    [ (Position r c, a)
    | (i, Just a) <- zip [0 ..] (Boxed.toList everything)
    , let (r, c) = i `divMod` columns shape
    ]

-- | The patch of this shape, at least one cell, whose observed cells are these, row by row, all of them within it.
patchWith :: Shape -> [(Position, GF k)] -> Patch k
patchWith shape observed = Patch shape observed (unobserved Boxed.// map at observed)
 where
  unobserved = Boxed.replicate (fromIntegral (area shape)) Nothing
  at (Position r c, a) = (fromIntegral (r * columns shape + c), Just a)

-- | The shape of rows. Refuses as 'patch' does.
rectangular :: [[a]] -> Either LocateError Shape
rectangular cells
  | width == 0 = Left PatchEmpty
  | (i, r) : _ <- ragged = Left (PatchRagged i (length r) width)
  | otherwise = Right (Shape height (fromIntegral width))
 where
  height = fromIntegral (length cells)
  ragged = filter ((/= width) . length . snd) (zip [0 ..] cells)
  width = sum (map length (take 1 cells))

-- | The rows, as 'patch' takes them.
patchRows :: Patch k -> [[Maybe (GF k)]]
patchRows observed = go (Boxed.toList (patchCells observed))
 where
  go cells = case splitAt (fromIntegral (columns (patchShape observed))) cells of
    ([], _) -> []
    (r, rest) -> r : go rest

-- | The patch of this shape, at least one cell, whose observed cells are those of another patch, each at the position told; without those that are
-- told one beyond it.
rearranged :: Shape -> (Position -> Position) -> Patch k -> Patch k
rearranged shape to observed = patchWith shape (sortOn fst moved)
 where
  moved = [(at, a) | (offset, a) <- observedCells observed, let at = to offset, within at]
  within at = row at < rows shape && column at < columns shape

-- | The offsets at which every cell of the mask is observed, row by row, with those cells' content.
completeWindows :: Mask -> Patch k -> [(Position, [GF k])]
completeWindows mask observed@(Patch (Shape height width) _ cells) =
  [ (Position i j, content)
  | Position i0 j0 <- take 1 offsets
  , -- The window is where its first cell is observed.
  (Position r0 c0, _) <- observedCells observed
  , r0 >= i0 && c0 >= j0
  , let i = r0 - i0
        j = c0 - j0
  , i + rows extent <= height && j + columns extent <= width
  , Just content <- [traverse (\(Position r c) -> at (i + r) (j + c)) offsets]
  ]
 where
  offsets = maskOffsets mask
  extent = maskExtent mask
  at r c = do
    cell <- cells Boxed.!? fromIntegral (r * width + c)
    cell
