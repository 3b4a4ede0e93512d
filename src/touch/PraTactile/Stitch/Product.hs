{-# LANGUAGE BangPatterns #-}

-- | Products of vectors, as loops: the library's own zips are not fused where the compiler keeps
-- memory alive around each element, and take five times as long.
module PraTactile.Stitch.Product
  ( dot,
    dotWithin,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V

-- | The sum of the products of two vectors' elements, as far as both have any.
dot :: Vector Double -> Vector Double -> Double
dot xs ys = dotWithin (min (V.length xs) (V.length ys)) 0 xs 0 ys

-- | That of so many elements, of the first vector from one place on, of the second from another.
-- Unchecked: both must have them.
dotWithin :: Int -> Int -> Vector Double -> Int -> Vector Double -> Double
dotWithin !n !i !xs !j !ys = go 0 0
  where
    go :: Int -> Double -> Double
    go !t !s
      | t >= n = s
      | otherwise = go (t + 1) (s + V.unsafeIndex xs (i + t) * V.unsafeIndex ys (j + t))
