{-# OPTIONS_HADDOCK hide #-}

-- | The search for a packing.
--
-- Pieces are laid one after the other, in orders that are made better step by step
-- ("PraTactile.Object.Packing.Climb"), and of the packings found the one with the fewest rows is
-- kept. If there was none, and the problem is small enough to be written down, its whole tree is
-- searched ("PraTactile.Object.Packing.Exact"); where its budget does not suffice, orders
-- are tried for longer, until one gives a packing. All budgets are counts of steps, never a clock,
-- so that an answer is the same on every machine.
module PraTactile.Object.Packing.Search
  ( search,
    Found (..),
  )
where

import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Packing.Climb
import PraTactile.Object.Packing.Exact
import PraTactile.Object.Packing.Filling
import PraTactile.Object.Packing.Kinds
import PraTactile.Object.Packing.Occupancy

-- | Looks for a packing of these kinds of pieces, each of whose figures fits somewhere, by a seed.
search :: Int -> Still -> Kinds -> Found
search seed still kinds
  | complete compact = lying compact
  | otherwise = case maybe Unknown (exactly exactBudget) (problemOf still kinds) of
    Unknown | complete last' -> lying last'
    answer -> answer
  where
    compact = climbTo fewMoves fewSteps fewest (climbStart fewSteps seed still kinds)
    last' = climbTo manyMoves manySteps complete compact
    climbTo moves steps reached =
      until
        (\c -> climbMoves c >= moves || climbSteps c >= steps || reached c || oneOrder)
        (climbMove still kinds)
    oneOrder = U.length (kindsCount kinds) < 2
    complete climb = fillingOver (climbBest climb) == 0
    fewest climb = complete climb && fillingRows (climbBest climb) <= fewestRows
    lying climb = Found (fillingLying (climbBest climb))
    -- No packing has less than these, for they have as many free cells as the pieces need.
    fewestRows = length (takeWhile (< needed) (scanl (+) 0 freeInRows))
    freeInRows = map (freeInRow still) [0 .. rowsOf still - 1]
    needed = sum [n * fewestCells kinds k | (k, n) <- zip [0 ..] (U.toList (kindsCount kinds))]

-- | How many orders are tried for the packing with the fewest rows, and how many runs looked at.
fewMoves, fewSteps :: Int
fewMoves = 300
fewSteps = 8000000

-- | How many where no packing was found by then, nor a proof that there is none.
manyMoves, manySteps :: Int
manyMoves = 20000
manySteps = 30000000

-- | How many cells, of the sheet and of options, the exact search may look at.
exactBudget :: Int
exactBudget = 300000000
