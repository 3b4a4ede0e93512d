{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Search in ascending numbers.
module PraTactile.Image.Ascending
  ( placeIn,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V

-- | The index of a number in an ascending vector without repetitions; 'Nothing' if it is not there.
-- Binary search, O(log n).
placeIn :: Vector Int -> Int -> Maybe Int
placeIn numbers wanted = go 0 (V.length numbers)
  where
    -- The number can only be at an index from @from@ to @to - 1@.
    go !from !to
      | from >= to = Nothing
      | otherwise =
        let middle = (from + to) `quot` 2
         in case compare (numbers V.! middle) wanted of
              EQ -> Just middle
              LT -> go (middle + 1) to
              GT -> go from middle
