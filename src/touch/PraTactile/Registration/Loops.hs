{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Loops for tables and products of vectors. The vector library's zips do not fuse where the
-- compiler keeps memory alive around each element, and take five times as long.
module PraTactile.Registration.Loops
  ( tabulate,
    dot,
    dotWithin,
  )
where

import Control.Monad (when)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M

-- | A table of the given numbers of columns and rows, row by row, from a function of row and
-- column. Work for a whole row is done once, if the function does it before it takes the column.
tabulate :: Int -> Int -> (Int -> Int -> Double) -> Vector Double
tabulate columns rows at = V.create $ do
  table <- M.unsafeNew (columns * rows)
  -- Note [Bounds of tables]
  let row !y = when (y < rows) $ do
        -- Evaluated here, the function of columns is inlined in the loop.
        let !here = at y
            !start = y * columns
            column !x =
              when (x < columns) $ M.unsafeWrite table (start + x) (here x) >> column (x + 1)
        column 0
        row (y + 1)
  row 0
  pure table
{-# INLINE tabulate #-}

{- Note [Bounds of tables] Rows and columns stay below their numbers. -}

-- | The dot product of two vectors, up to the shorter length.
dot :: Vector Double -> Vector Double -> Double
dot xs ys = dotWithin (min (V.length xs) (V.length ys)) (xs, 0) (ys, 0)

-- | The dot product of n elements, of each vector from its index on. Unchecked: both must have
-- them. Four independent sums run side by side.
dotWithin :: Int -> (Vector Double, Int) -> (Vector Double, Int) -> Double
dotWithin !n (!xs, !i) (!ys, !j) = fours 0 0 0 0 0
  where
    product' t = V.unsafeIndex xs (i + t) * V.unsafeIndex ys (j + t)
    fours :: Int -> Double -> Double -> Double -> Double -> Double
    fours !t !a !b !c !d
      | t + 4 > n = ones t ((a + b) + (c + d))
      | otherwise =
        fours
          (t + 4)
          (a + product' t)
          (b + product' (t + 1))
          (c + product' (t + 2))
          (d + product' (t + 3))
    ones !t !s
      | t >= n = s
      | otherwise = ones (t + 1) (s + product' t)
