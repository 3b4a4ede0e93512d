{-# LANGUAGE BangPatterns #-}

-- | Tables of numbers by column and row.
module PraTactile.Registration.Lattice.Tabulate
  ( tabulate,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M

-- | A table of so many columns and rows, row by row, from what it has in a row and a column. What
-- is the same for a row is calculated once, if the function does so before it takes the column.
tabulate :: Int -> Int -> (Int -> Int -> Double) -> Vector Double
tabulate columns rows at = V.create $ do
  table <- M.unsafeNew (columns * rows)
  -- Note [Bounds of tables]
  let row !y
        | y >= rows = pure ()
        | otherwise = column (at y) (y * columns) 0 >> row (y + 1)
      column here !start !x
        | x >= columns = pure ()
        | otherwise = M.unsafeWrite table (start + x) (here x) >> column here start (x + 1)
  row 0
  pure table
{-# INLINE tabulate #-}

{- Note [Bounds of tables] Rows and columns stay below how many there are of them. -}
