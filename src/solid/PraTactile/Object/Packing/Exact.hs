{-# OPTIONS_HADDOCK hide #-}

-- | Decides whether kinds of pieces can be laid at all, by exact cover with cells to spare (Knuth,
-- Dancing links, 2000, algorithm X). An option is a figure of a kind at a place. For each kind k,
-- needs(k) options must be chosen, so that no cell is in two of them.
--
-- At a node of the tree, let A be the options that are disjoint with the chosen ones, A(k) those of
-- kind k, and A(c) those with cell c. Then
--
-- > surplus = |union of A| - sum over k of needs(k) * min {|a| : a in A(k)}
--
-- cells that options reach may stay free. The node has no solution if the surplus is negative, or
-- if |A(k)| < needs(k) for some k. Otherwise it branches on whatever has the fewest branches:
--
-- * a kind k: which of A(k), in order, is the first to be chosen, with |A(k)| - needs(k) + 1
--   branches. Earlier options are excluded below, because pieces of a kind are interchangeable;
-- * a cell c: which of A(c) covers it, or, if the surplus is positive, none, with |A(c)| or |A(c)|
--   + 1 branches.
--
-- The branches are complete. So if the whole tree is visited without a solution, there is none. The
-- work at a node is proportional to the cells of the sheet and of the options in A, and the budget
-- counts these.
module PraTactile.Object.Packing.Exact
  ( Found (..),
    Problem,
    problemOf,
    exactly,
  )
where

import Control.Monad (filterM)
import Control.Monad.ST (runST)
import Data.Bits
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import Data.Word (Word64)
import PraTactile.Object.Packing.Kinds
import PraTactile.Object.Packing.Mask
import PraTactile.Object.Packing.Occupancy

-- | The result of a search.
data Found
  = -- | the needed number of pieces of each kind, without a common cell
    Found [Lying]
  | -- | there is no solution
    None
  | -- | the budget did not suffice to decide
    Unknown
  deriving stock (Eq, Show)

-- | The needed number of pieces of each kind, and all places where the kinds' figures fit. Options
-- are numbered from 0.
data Problem = Problem
  { -- | the needed number of pieces of each kind
    needs :: !(U.Vector Int),
    -- | each option: its kind, its figure and its place
    options :: !(V.Vector Lying),
    -- | the kind of each option
    kindOf :: !(U.Vector Int),
    -- | the cells of each option, numbered row by row from 0
    cellsOf :: !(V.Vector (U.Vector Int)),
    -- | the cells of each option as bits, in 'wordsAnOption' words
    bitsOf :: !(U.Vector Word64),
    wordsAnOption :: !Int,
    -- | the number of the sheet's cells
    cellCount :: !Int
  }

-- | The problem of laying pieces of these kinds on the free cells of a sheet. 'Nothing' if its
-- options have more than 'largest' cells and words.
problemOf :: Still -> Kinds -> Maybe Problem
problemOf sheet kinds
  | sum (map weight figures) > largest = Nothing
  | otherwise =
    Just
      Problem
        { needs = kindsCount kinds,
          options = V.fromList found,
          kindOf = U.fromList (map lyingKind found),
          cellsOf = V.fromList cells,
          bitsOf = U.concat (map bitsOfCells cells),
          wordsAnOption = words',
          cellCount = count
        }
  where
    figures = [(k, f) | k <- [0 .. V.length alternatives - 1], f <- alternatives V.! k]
    alternatives = kindsAlternatives kinds
    figureOf f = kindsFigures kinds V.! f
    places f =
      [ (r, c)
        | r <- [0 .. rowsOf sheet - figureRows (figureOf f)],
          c <- [0 .. columnsOf sheet - figureColumns (figureOf f)]
      ]
    weight (_, f) =
      toInteger (max 0 (rowsOf sheet - figureRows (figureOf f) + 1))
        * toInteger (max 0 (columnsOf sheet - figureColumns (figureOf f) + 1))
        * toInteger (figureCells (figureOf f) + words')
    found =
      [ Lying k f place
        | (k, f) <- figures,
          place <- runST (thaw sheet >>= \it -> filterM (fitsAt it (figureOf f)) (places f))
      ]
    cells =
      [ U.fromList
          [ (r + i) * columnsOf sheet + c + j'
            | (i, j, l) <- U.toList (figureRuns (figureOf f)),
              j' <- [j .. j + l - 1]
          ]
        | Lying _ f (r, c) <- found
      ]
    count = rowsOf sheet * columnsOf sheet
    words' = (count + 63) `div` 64
    bitsOfCells own =
      U.accumulate
        setBit
        (U.replicate words' 0)
        (U.map (\c -> (c `shiftR` 6, c .&. 63)) own)

-- | The most cells and words of a problem's options: about 40 MB.
largest :: Integer
largest = 4000000

-- | The result of the tree below a node: an answer, or the rest of the budget.
data Below
  = Answer Found
  | Remaining !Int

-- | Solves a problem within a budget: the number of cells, of the sheet and of options, that may be
-- visited in all nodes together.
exactly :: Int -> Problem -> Found
exactly budget0 problem =
  case node budget0 (needs problem) (U.enumFromN 0 (V.length (options problem))) [] of
    Answer found -> found
    Remaining _ -> None
  where
    kinds = U.length (needs problem)
    node budget needed alive chosen
      | U.all (== 0) needed = Answer (Found (map (options problem V.!) chosen))
      | budget <= 0 = Answer Unknown
      | surplus < 0 || U.or (U.zipWith (<) perKind needed) = Remaining left
      | branchesOfKind <= branchesOfCell =
        ofKind left (take branchesOfKind (having ((== kind) . kindAt)))
      | otherwise = ofCell left (having (hasCell problem cell))
      where
        (perKind, least, perCell) = tally problem alive
        left = budget - cellCount problem - U.sum perCell
        surplus =
          U.length (U.filter (> 0) perCell)
            - U.sum (U.zipWith (\n l -> if n == 0 then 0 else n * l) needed least)
        (branchesOfKind, kind) =
          minimum [(perKind U.! k - needed U.! k + 1, k) | k <- [0 .. kinds - 1], needed U.! k > 0]
        (branchesOfCell, cell) = U.ifoldl' fewer (maxBound, 0) perCell
        fewer best i n = if n > 0 && n + none < fst best then (n + none, i) else best
        none = if surplus > 0 then 1 else 0
        having holds = U.toList (U.filter holds alive)
        ofKind b own = case own of
          o : others ->
            choosing b o (U.filter (\a -> kindAt a /= kind || a > o) alive) `orElse` \b' ->
              ofKind b' others
          [] -> Remaining b
        ofCell b own = case own of
          o : others -> choosing b o alive `orElse` \b' -> ofCell b' others
          [] | surplus > 0 -> node b needed (U.filter (not . hasCell problem cell) alive) chosen
          [] -> Remaining b
        choosing b o from =
          let k = kindAt o
              more = needed U.! k > 1
           in node
                b
                (needed U.// [(k, needed U.! k - 1)])
                (U.filter (\a -> (more || kindAt a /= k) && disjoint problem a o) from)
                (o : chosen)
    kindAt = U.unsafeIndex (kindOf problem)
    orElse below next = case below of
      Remaining budget -> next budget
      answer -> answer

-- | For some options, by their numbers: the number of options of each kind; the least number of
-- cells of an option of each kind; the number of options that cover each cell.
tally :: Problem -> U.Vector Int -> (U.Vector Int, U.Vector Int, U.Vector Int)
tally problem alive = runST $ do
  perKind <- M.replicate kinds 0
  least <- M.replicate kinds maxBound
  perCell <- M.replicate (cellCount problem) 0
  U.forM_ alive $ \o -> do
    let k = U.unsafeIndex (kindOf problem) o
        cells = V.unsafeIndex (cellsOf problem) o
    M.unsafeModify perKind (+ 1) k
    M.unsafeModify least (min (U.length cells)) k
    U.forM_ cells (M.unsafeModify perCell (+ 1))
  (,,) <$> U.unsafeFreeze perKind <*> U.unsafeFreeze least <*> U.unsafeFreeze perCell
  where
    kinds = U.length (needs problem)

-- | Whether an option has a cell. Arguments: the problem; the cell; the option.
hasCell :: Problem -> Int -> Int -> Bool
hasCell problem c o =
  testBit (U.unsafeIndex (bitsOf problem) (o * wordsAnOption problem + c `shiftR` 6)) (c .&. 63)

-- | Whether two options have no common cell.
disjoint :: Problem -> Int -> Int -> Bool
disjoint problem a b = go (wordsAnOption problem - 1)
  where
    go k = k < 0 || word a k .&. word b k == 0 && go (k - 1)
    word o k = U.unsafeIndex (bitsOf problem) (o * wordsAnOption problem + k)
