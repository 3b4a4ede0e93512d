{-# LANGUAGE BangPatterns #-}

-- | Regions of an image's pixels: connected components (Jain, Kasturi and Schunck, Machine Vision,
-- chapter 2; the paper's [15]), and how far they extend.
module PraTactile.Segmentation.Region
  ( Region,
    components,
    extentAlong,
    regionBox,
  )
where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Geometry (cosineSine)
import PraTactile.Segmentation.Masked

-- | The numbers of some pixels.
type Region = [Int]

-- | The connected components of some pixels, in the order of their first ones. Two pixels are
-- connected when neither their columns nor their rows differ by more than the gap and one: gap 0 is
-- connection by sides and corners. The gap is at least 0. O(area of the box around the pixels), or
-- where that is large, O(pixels, times the logarithm of the area).
components :: Masked -> Int -> Region -> [Region]
components _ _ [] = []
components pixels gap some
  | wide * high > largestBox = apart (IntSet.fromList (map inside places))
  | otherwise = runST $ do
    left <- M.replicate (wide * high) False
    forM_ places $ \place -> M.write left (inside place) True
    go left 0
  where
    places = map (placeOf pixels) some
    -- The box around them with a margin of pixels that are none of them, as wide as what is looked
    -- at from one. Its places are numbered row by row.
    margin = gap + 1
    (x0, top) = (minimum (map fst places) - margin, minimum (map snd places) - margin)
    wide = maximum (map fst places) + margin + 1 - x0
    high = maximum (map snd places) + margin + 1 - top
    inside (x, y) = (y - top) * wide + x - x0
    pixel i = let (y, x) = i `quotRem` wide in (y + top) * maskedWidth pixels + x + x0
    steps = V.fromList [j * wide + i | j <- [-margin .. margin], i <- [-margin .. margin]]
    go :: M.MVector s Bool -> Int -> ST s [Region]
    go left !p
      | p >= wide * high = pure []
      | otherwise = do
        isFirst <- M.read left p
        if isFirst
          then do
            M.write left p False
            component <- flood left [p] []
            (component :) <$> go left (p + 1)
          else go left (p + 1)
    flood :: M.MVector s Bool -> [Int] -> [Int] -> ST s Region
    flood _ [] found = pure found
    flood left (p : queue) found = do
      near <- newAround left p 0 queue
      flood left near (pixel p : found)
    newAround :: M.MVector s Bool -> Int -> Int -> [Int] -> ST s [Int]
    newAround left !p !k queue
      | k >= V.length steps = pure queue
      | otherwise = do
        let p' = p + steps V.! k
        isNew <- M.read left p'
        when isNew (M.write left p' False)
        newAround left p (k + 1) (if isNew then p' : queue else queue)
    -- The same where most of a large box is none of them.
    apart left = case IntSet.minView left of
      Nothing -> []
      Just (p, others) ->
        let (component, rest) = flooded others [p] [] in component : apart rest
    flooded left [] found = (found, left)
    flooded left (p : queue) found =
      let near = filter (`IntSet.member` left) (map (p +) (V.toList steps))
       in flooded (foldl' (flip IntSet.delete) left near) (near ++ queue) (pixel p : found)

-- | A box of so many pixels or fewer is looked at as a whole.
largestBox :: Int
largestBox = 8388608

-- | How far a region extends along a direction, in degrees clockwise from the x axis, in pixels. 0
-- for an empty one.
extentAlong :: Masked -> Region -> Double -> Double
extentAlong pixels region angle
  | null region = 0
  | otherwise = let (least, most) = foldl' reaching (1 / 0, -1 / 0) region in most - least + 1
  where
    !(!c, !s) = cosineSine angle
    !w = max 1 (maskedWidth pixels)
    reaching (!least, !most) p =
      let (y, x) = p `quotRem` w
          t = c * fromIntegral x + s * fromIntegral y
       in (min least t, max most t)

-- | The box around a region's pixels: left, top, right, bottom. At the origin for an empty one.
regionBox :: Masked -> Region -> (Double, Double, Double, Double)
regionBox pixels region
  | null region = (0, 0, 0, 0)
  | otherwise = (least fst - 0.5, least snd - 0.5, most fst + 0.5, most snd + 0.5)
  where
    places = map (placeOf pixels) region
    least part = fromIntegral (minimum (map part places))
    most part = fromIntegral (maximum (map part places))
