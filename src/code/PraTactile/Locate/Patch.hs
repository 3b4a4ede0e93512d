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
  , patchShape
  , rectangular
  , LocateError (..)
  , patchRows
  , rearranged
  , observedCells
  , completeWindows
  ) where

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
  deriving stock (Eq, Show)

-- | A rectangle of observed and unobserved cells.
data Patch (k :: Field) = Patch
  { patchShape :: !Shape
  -- ^ Its rows and columns; at least one each.
  , patchCells :: !(Boxed.Vector (Maybe (GF k)))
  }

type role Patch nominal

-- | The patch with these rows; 'Nothing' is a cell that was not observed. Refuses no cells and rows
-- of different lengths.
patch :: [[Maybe (GF k)]] -> Either LocateError (Patch k)
patch cells = do
  shape <- rectangular cells
  pure (Patch shape (Boxed.fromList (concat cells)))

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
rearranged shape to observed = Patch shape (Boxed.replicate (fromIntegral (area shape)) Nothing Boxed.// moved)
 where
  moved =
    [ (fromIntegral (r * columns shape + c), Just a)
    | (offset, a) <- observedCells observed
    , let Position r c = to offset
    , r < rows shape && c < columns shape
    ]

-- | The observed cells with their offsets, row by row.
observedCells :: Patch k -> [(Position, GF k)]
observedCells observed =
  [ (Position r c, a)
  | (i, Just a) <- zip [0 ..] (Boxed.toList (patchCells observed))
  , let (r, c) = i `divMod` columns (patchShape observed)
  ]

-- | The offsets at which every cell of the mask is observed, row by row, with those cells' content.
completeWindows :: Mask -> Patch k -> [(Position, [GF k])]
completeWindows mask observed@(Patch (Shape height width) cells) =
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
