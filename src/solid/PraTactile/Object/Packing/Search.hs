{-# OPTIONS_HADDOCK hide #-}

-- | The search for a packing.
--
-- Pieces are laid one after the other, in orders that are improved step by step
-- ("PraTactile.Object.Packing.Climb"). The packing with the fewest rows is kept. If there is none
-- and the problem is small enough, its whole tree is searched ("PraTactile.Object.Packing.Exact").
-- If the budget for that does not suffice, orders are tried for longer, until one gives a packing.
-- All budgets count steps, not time, so that the answer is the same on every machine.
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

-- | Looks for a packing of these kinds of pieces, by a seed. Each figure must fit somewhere.
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
    -- No packing can have less: it has as many free cells as the pieces need.
    fewestRows = length (takeWhile (< needed) (scanl (+) 0 freeInRows))
    freeInRows = map (freeInRow still) [0 .. rowsOf still - 1]
    needed = sum [n * fewestCells kinds k | (k, n) <- zip [0 ..] (U.toList (kindsCount kinds))]

-- | The most orders that are tried, and runs that are tested, to find the packing with the fewest
-- rows.
fewMoves, fewSteps :: Int
fewMoves = 300
fewSteps = 8000000

-- | The most orders and runs if neither a packing nor a proof of impossibility was found by then.
manyMoves, manySteps :: Int
manyMoves = 20000
manySteps = 30000000

-- | The most cells, of the sheet and of options, that the exact search may visit.
exactBudget :: Int
exactBudget = 300000000
