-- | Searches for places of pieces on a sheet, so that no two share a cell.
--
-- A piece is a finite set A of masks, its alternatives; a mask is a finite set of cells P in Z^2. A
-- laying of a piece is one alternative P and a translation t. The sheet is S = {0 .. R - 1} x {0 ..
-- C - 1}. Disjoint sets of cells T_1 .. T_m in S are taken. A packing of A_1 .. A_n is a laying
-- (P_i, t_i) of each with
--
-- > P_i in A_i,    P_i + t_i in S,    P_i + t_i disjoint with T_j for all j,
-- > P_i + t_i disjoint with P_j + t_j for all j < i.
--
-- Nothing is turned or mirrored, and the sheet does not wrap around. A turned piece must be an
-- alternative of its own.
--
-- First a quick proof of impossibility is tried ('Reason'). Then "PraTactile.Object.Packing.Search"
-- looks for a packing, and for a proof that there is none.
module PraTactile.Object.Packing
  ( -- * Masks
    BlockMask,
    maskOf,
    block,
    maskCells,

    -- * Packing
    Sheet (..),
    packed,
    PackingResult (..),
    Laid (..),
    Reason (..),
  )
where

import Control.Monad (filterM, when)
import Control.Monad.ST (runST)
import Data.List (elemIndex)
import Data.Maybe (isJust)
import qualified Data.Set as Set
import PraTactile.Object.Packing.Kinds
import PraTactile.Object.Packing.Mask
import PraTactile.Object.Packing.Occupancy
import PraTactile.Object.Packing.Search

-- | The sheet, with the cells that are taken already.
data Sheet = Sheet
  { -- | in cells; a number below 0 counts as 0
    sheetRows :: !Int,
    sheetColumns :: !Int,
    -- | masks, each with the row and column of its block's upper left corner
    sheetTaken :: [(BlockMask, (Int, Int))]
  }
  deriving stock (Eq, Show)

-- | The result of a search.
data PackingResult
  = -- | a packing: for each piece, in order, how it lies
    Packed [Laid]
  | -- | there is no packing, for this reason
    Impossible Reason
  | -- | no packing was found, but it is not proved that there is none
    NotFound
  deriving stock (Eq, Show)

-- | How a piece lies.
data Laid = Laid
  { -- | the index of its alternative, from 0
    laidAlternative :: !Int,
    -- | the row and column of its block's upper left corner; it is outside the sheet if the block
    -- is larger than its cells need
    laidAt :: !(Int, Int)
  }
  deriving stock (Eq, Ord, Show)

-- | Why there is no packing: the first of these that holds. Pieces and taken masks are given by
-- their indices in the lists, from 0.
data Reason
  = -- | a cell of this taken mask is outside the sheet
    TakenOutside Int
  | -- | this taken mask shares a cell with an earlier one
    TakenOverlaps Int
  | -- | none of this piece's alternatives fits an empty sheet of this size, or it has none
    PieceTooLarge Int
  | -- | the pieces need at least the first number of cells, but only the second is free
    TooFewCells Int Int
  | -- | none of this piece's alternatives fits beside the taken masks
    NoRoom Int
  | -- | a complete search found none
    Exhausted
  deriving stock (Eq, Show)

-- | Looks for a packing of pieces, each given by its alternatives. For every seed, 'Impossible' is
-- true and 'Packed' is a packing. The seed selects among packings and may decide whether one is
-- found. The order of pieces and alternatives only decides which of several equal pieces lies
-- where.
--
-- The search prefers packings that end in an early row. If several alternatives of a piece fit at
-- one place, it lays the one with the most cells, unless no packing is found that way. On a large
-- sheet it uses only as many rows and columns as suffice for the pieces, and memory in proportion
-- to these.
--
-- >>> packed 1 (Sheet 2 3 []) [[block (2, 2)], [block (1, 2), block (2, 1)]]
-- Packed [Laid {laidAlternative = 0, laidAt = (0,0)},Laid {laidAlternative = 1, laidAt = (0,2)}]
-- >>> packed 1 (Sheet 3 3 []) [[block (2, 2)], [block (2, 2)]]
-- Impossible Exhausted
packed :: Int -> Sheet -> [[BlockMask]] -> PackingResult
packed seed sheet pieces = either Impossible id $ do
  refuse TakenOutside [not (lies figure place) | (figure, place) <- taken]
  still <- occupied (room rows columns taken fitting) taken
  refuse PieceTooLarge (map Set.null fitting)
  let needed = sum (map (minimum . map cells . Set.toList) fitting)
      free = toInteger rows * toInteger columns - sum (map (cells . fst) taken)
  when (needed > free) (Left (TooFewCells (fromInteger needed) (fromInteger free)))
  let roomy = Set.fromDistinctAscList (fitSomewhere still (Set.toAscList (Set.unions fitting)))
      possible = map (`Set.intersection` roomy) fitting
  refuse NoRoom (map Set.null possible)
  let kinds = kindsOf possible
  pure $ case search seed still kinds of
    Found lying -> Packed [Laid i place | (i, place) <- assigned kinds pieces lying]
    None -> Impossible Exhausted
    Unknown -> NotFound
  where
    rows = max 0 (sheetRows sheet)
    columns = max 0 (sheetColumns sheet)
    taken =
      [ (maskFigure mask, (r + top, c + left))
        | (mask, (r, c)) <- sheetTaken sheet,
          let (top, left) = maskCorner mask
      ]
    fitting = [Set.filter (`lies` (0, 0)) (Set.fromList (map maskFigure piece)) | piece <- pieces]
    lies figure (r, c) =
      r >= 0 && c >= 0 && r <= rows - figureRows figure && c <= columns - figureColumns figure
    cells = toInteger . figureCells
    refuse reason holds = maybe (Right ()) (Left . reason) (elemIndex True holds)

-- | The numbers of rows and columns of a sheet that suffice: if there is a packing, there is one in
-- the upper left part of this size. Take a block that is as tall and wide as the largest figures
-- and fits the sheet. If there are enough rows, n blocks fit below what is taken, as many side by
-- side as the columns allow. If there are enough columns, they fit side by side to the right of it.
room :: Int -> Int -> [(Figure, (Int, Int))] -> [Set.Set Figure] -> (Int, Int)
room rows columns taken pieces =
  ( rows `atMost` (bottom + tallest * ((n + line - 1) `div` line)),
    columns `atMost` (right + widest * n)
  )
  where
    atMost given enough = fromInteger (min (toInteger given) enough)
    n = toInteger (length pieces)
    figures = Set.toList (Set.unions pieces)
    tallest = most (1 : map figureRows figures)
    widest = most (1 : map figureColumns figures)
    line = max 1 (toInteger columns `div` widest)
    bottom = most (0 : [r + figureRows figure | (figure, (r, _)) <- taken])
    right = most (0 : [c + figureColumns figure | (figure, (_, c)) <- taken])
    most = toInteger . maximum

-- | A sheet with these numbers of rows and columns, and the taken masks on it.
occupied :: (Int, Int) -> [(Figure, (Int, Int))] -> Either Reason Still
occupied (rows, columns) taken = runST $ do
  it <- thaw (vacant rows columns)
  let go ((i, (figure, place)) : more) = do
        free <- fitsAt it figure place
        if free then lie it figure place >> go more else pure (Left (TakenOverlaps i))
      go [] = Right <$> freeze it
  go (zip [0 ..] taken)

-- | The figures that fit anywhere.
fitSomewhere :: Still -> [Figure] -> [Figure]
fitSomewhere still figures = runST $ do
  it <- thaw still
  filterM (\figure -> isJust . fst <$> firstFit it figure (0, 0)) figures
