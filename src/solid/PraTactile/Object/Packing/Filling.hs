{-# OPTIONS_HADDOCK hide #-}

-- | Bottom-left fill (Baker, Coffman and Rivest, SIAM J. Comput. 9, 1980; with holes filled,
-- Chazelle, IEEE Trans. Comput. 32, 1983), with row 0 as the bottom. One piece after the other is
-- laid at the first place, row by row, where one of its figures fits. Cells only become taken, so
-- that place only moves forwards, and each figure passes over the sheet once.
module PraTactile.Object.Packing.Filling
  ( Filling (..),
    fillingCost,
    Choice (..),
    filled,
  )
where

import Control.Monad (forM)
import Control.Monad.ST (runST)
import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import PraTactile.Object.Packing.Kinds
import PraTactile.Object.Packing.Mask
import PraTactile.Object.Packing.Occupancy

-- | The result of laying pieces in an order.
data Filling = Filling
  { -- | the least total number of cells of the pieces that found no place
    fillingOver :: !Int,
    -- | the number of rows up to the last one that is used
    fillingRows :: !Int,
    -- | the number of taken cells in the last two of these rows
    fillingLast :: !Int,
    -- | the laid pieces, the last one first
    fillingLying :: [Lying],
    -- | the pieces that found no place, by their indices in the given order, ascending
    fillingWithout :: [Int],
    -- | the number of runs that were tested
    fillingSteps :: !Int
  }

-- | The measure by which fillings are compared; less is better.
fillingCost :: Filling -> (Int, Int, Int)
fillingCost it = (fillingOver it, fillingRows it, fillingLast it)

-- | Which of a piece's figures is laid, if several have the same first place.
data Choice
  = MostCells
  | FewestCells
  deriving stock (Eq, Show)

-- | Lays pieces one after the other. Arguments: the sheet; the kinds of pieces; the choice among
-- figures; the kind of each piece in order. Each time 'patience' more steps were taken, the rows in
-- use by then are closed. O(figures * cells of the sheet) at most, if figures have few runs.
filled :: Still -> Kinds -> Choice -> U.Vector Int -> Filling
filled sheet kinds choice order = runST $ do
  it <- thaw sheet
  -- For each figure, the row and column before which it fits nowhere.
  fromRow <- M.replicate (V.length (kindsFigures kinds)) 0
  fromColumn <- M.replicate (V.length (kindsFigures kinds)) 0
  let go at over rows steps (closed, next) lying without
        | at == U.length order = do
          end <- freeze it
          let used = sum [columnsOf end - freeInRow end r | r <- [max 0 (rows - 2) .. rows - 1]]
          pure (Filling over rows used lying (reverse without) steps)
        | steps > next = go at over rows steps (rows, steps + patience) lying without
        | otherwise = do
          let k = order U.! at
          tried <- forM (kindsAlternatives kinds V.! k) $ \f -> do
            from <- max (closed, 0) <$> ((,) <$> M.read fromRow f <*> M.read fromColumn f)
            (place, n) <- firstFit it (kindsFigures kinds V.! f) from
            let (r, c) = fromMaybe (rowsOf sheet, 0) place
            M.write fromRow f r
            M.write fromColumn f c
            pure ([(p, preference f) | Just p <- [place]], n)
          let steps' = steps + 1 + sum (map snd tried)
          case concatMap fst tried of
            [] -> do
              let over' = over + fewestCells kinds k
              go (at + 1) over' rows steps' (closed, next) lying (at : without)
            places -> do
              let (p, preferred) = minimum places
                  f = abs preferred
                  figure = kindsFigures kinds V.! f
              lie it figure p
              go
                (at + 1)
                over
                (max rows (fst p + figureRows figure))
                steps'
                (closed, next)
                (Lying k f p : lying)
                without
      -- Figures are numbered in the order of their cells.
      preference f = case choice of
        MostCells -> negate f
        FewestCells -> f
  go 0 0 0 0 (0, patience) [] []

-- | The number of steps after which rows are closed: less than a second's. Only hundreds of figures
-- take so many.
patience :: Int
patience = 4000000
