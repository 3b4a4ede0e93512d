{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Ascending numbers.
module PraTactile.Image.Ascending
  ( placeIn,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V

-- | At which place a number stands among ascending ones, if it does.
placeIn :: Vector Int -> Int -> Maybe Int
placeIn numbers wanted = go 0 (V.length numbers)
  where
    -- It stands from the first place on and before the last, or nowhere.
    go !from !to
      | from >= to = Nothing
      | otherwise =
        let middle = (from + to) `quot` 2
         in case compare (numbers V.! middle) wanted of
              EQ -> Just middle
              LT -> go (middle + 1) to
              GT -> go from middle
