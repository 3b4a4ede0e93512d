-- | A search for where pieces lie on a sheet, no two on one cell.
--
-- A piece is a finite set A of masks, its alternatives: finite sets of cells P in Z^2. A laying of
-- it is one of them, P, and a translation t. Given a sheet S = {0 .. R - 1} x {0 .. C - 1} and what
-- is taken of it, pairwise disjoint sets of cells T_1 .. T_m in S, a packing of A_1 .. A_n is a
-- laying (P_i, t_i) of each with
--
-- > P_i in A_i,    P_i + t_i in S,    P_i + t_i disjoint with T_j for all j,
-- > P_i + t_i disjoint with P_j + t_j for all j < i.
--
-- Nothing is turned or mirrored, and the sheet does not wrap round: what turning would give is an
-- alternative of its own.
--
-- First it is asked whether there is a quick proof that there is none ('Reason'). Then
-- "PraTactile.Object.Packing.Search" looks for one, and for a proof that there is none.
module PraTactile.Object.Packing
  ( -- * Masks
    Mask,
    maskOf,
    block,
    maskCells,

    -- * Packing
    Sheet (..),
    packed,
    Outcome (..),
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

-- | Where pieces are to lie.
-- | Where pieces are to lie, and what lies there already and stays.
data Sheet = Sheet
  { -- | in cells; below 0 counts as 0
    sheetRows :: !Int,
    sheetColumns :: !Int,
    -- | masks, and the row and column of the upper left corner of their block
    sheetTaken :: [(Mask, (Int, Int))]
  }
  deriving stock (Eq, Show)

-- | What a search came to.
data Outcome
  = -- | a packing: for each piece, in their order, how it lies
    Packed [Laid]
  | -- | there is none
    Impossible Reason
  | -- | none was found, and that there is none was not proved
    NotFound
  deriving stock (Eq, Show)

-- | How a piece lies.
data Laid = Laid
  { -- | which of its alternatives, from 0
    laidAlternative :: !Int,
    -- | the row and column of the upper left corner of its block, which lies outside the sheet
    -- where the block is larger than what the cells span
    laidAt :: !(Int, Int)
  }
  deriving stock (Eq, Ord, Show)

-- | Why there is no packing, the first of these that holds. Pieces and what is taken are told by
-- their place in the list, from 0.
data Reason
  = -- | a cell of this one that is taken lies outside the sheet
    TakenOutside Int
  | -- | this one that is taken shares a cell with one before it
    TakenOverlaps Int
  | -- | none of this piece's alternatives fits on an empty sheet of this size, or it has none
    PieceTooLarge Int
  | -- | the pieces need so many cells at least, and so many are free
    TooFewCells Int Int
  | -- | none of this piece's alternatives fits beside what is taken
    NoRoom Int
  | -- | the whole tree was searched
    Exhausted
  deriving stock (Eq, Show)

-- | Looks for a packing of pieces, each told by its alternatives. Whatever the seed, 'Impossible'
-- is true and 'Packed' is a packing; the seed chooses among packings, and may decide whether one is
-- found. The order of pieces and alternatives decides nothing but which of equal pieces lies where.
--
-- Of packings, those are looked for that end in an early row; of a piece's alternatives that fit at
-- the same place, the one with most cells is laid, unless no packing is found so.
--
-- Of a large sheet only so many rows and columns are looked at as suffice for the pieces, and
-- memory is in proportion to these.
--
-- >>> packed 1 (Sheet 2 3 []) [[block (2, 2)], [block (1, 2), block (2, 1)]]
-- Packed [Laid {laidAlternative = 0, laidAt = (0,0)},Laid {laidAlternative = 1, laidAt = (0,2)}]
-- >>> packed 1 (Sheet 3 3 []) [[block (2, 2)], [block (2, 2)]]
-- Impossible Exhausted
packed :: Int -> Sheet -> [[Mask]] -> Outcome
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

-- | How many rows and columns of a sheet suffice: if there is a packing, there is one in these, the
-- upper left ones. Let all figures be no taller and no wider than a block that fits on the sheet.
-- Then n blocks lie below what is taken, as many in a line as columns allow, if there are so many
-- rows; and they lie in a line beside it, if there are so many columns.
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

-- | A sheet of so many rows and columns with what is taken of it.
occupied :: (Int, Int) -> [(Figure, (Int, Int))] -> Either Reason Still
occupied (rows, columns) taken = runST $ do
  it <- thaw (vacant rows columns)
  let go ((i, (figure, place)) : more) = do
        free <- fitsAt it figure place
        if free then lie it figure place >> go more else pure (Left (TakenOverlaps i))
      go [] = Right <$> freeze it
  go (zip [0 ..] taken)

-- | Those figures that fit anywhere.
fitSomewhere :: Still -> [Figure] -> [Figure]
fitSomewhere still figures = runST $ do
  it <- thaw still
  filterM (\figure -> isJust . fst <$> firstFit it figure (0, 0)) figures
