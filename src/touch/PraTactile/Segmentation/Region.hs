{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Regions of an image's pixels: connected components (Jain, Kasturi and Schunck, Machine Vision,
-- chapter 2; the paper's [15]), their surroundings and their extents.
module PraTactile.Segmentation.Region
  ( Region,
    components,

    -- * As sets
    around,
    among,
    eachOnce,

    -- * Their extent
    extentAlong,
    regionBox,
  )
where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Unboxed as V
import qualified Data.Vector.Unboxed.Mutable as M
import PraTactile.Geometry (cosineSine)
import PraTactile.Segmentation.Masked

-- | A list of pixel numbers.
type Region = [Int]

-- | The connected components of a list of pixels, ordered by their lowest pixel numbers; the pixels
-- of each are in no particular order. Of the image only the width counts. Two pixels are
-- connected when their columns and their rows differ by at most gap + 1, where gap >= 0; gap 0
-- means connection by sides and corners. O(area of the pixels' bounding box), or, if that is large,
-- O(n log area) for n pixels.
components :: Masked -> Int -> Region -> [Region]
components _ _ [] = []
components pixels gap some
  | wide * high > largestBox = apart (IntSet.fromList (map inside some))
  | otherwise = runST $ do
    left <- M.replicate (wide * high) False
    forM_ some $ \p -> M.write left (inside p) True
    go left 0
  where
    -- The bounding box with a margin of empty pixels, as wide as a pixel's neighbourhood. Its
    -- places are numbered row by row.
    margin = gap + 1
    Box left' top right bottom = boxOf pixels some
    (!x0, !y0) = (left' - margin, top - margin)
    !wide = right + margin + 1 - x0
    !high = bottom + margin + 1 - y0
    inside p = let (x, y) = placeOf pixels p in (y - y0) * wide + x - x0
    pixel i = let (y, x) = i `quotRem` wide in (y + y0) * maskedWidth pixels + x + x0
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
    -- The components by sets, for a large box that is mostly empty.
    apart left = case IntSet.minView left of
      Nothing -> []
      Just (p, others) ->
        let (component, rest) = flooded others [p] [] in component : apart rest
    flooded left [] found = (found, left)
    flooded left (p : queue) found =
      let near = filter (`IntSet.member` left) (map (p +) (V.toList steps))
       in flooded (foldl' (flip IntSet.delete) left near) (near ++ queue) (pixel p : found)

-- | The number of pixels up to which a bounding box is held as a whole.
largestBox :: Int
largestBox = 8388608

-- | The image's pixels, touched or not, within a distance of some pixel of the region, ascending.
-- The distance is the larger of those in columns and in rows.
around :: Masked -> Int -> Region -> Region
around pixels distance = eachOnce . concatMap down . eachOnce . concatMap across
  where
    across p = let x = p `rem` w in [p + max (-distance) (-x) .. p + min distance (w - 1 - x)]
    down p = filter within [p - distance * w, p - (distance - 1) * w .. p + distance * w]
    within p = p >= 0 && p < w * maskedHeight pixels
    w = maskedWidth pixels

-- | Membership in a list of numbers. Partial application prepares a table.
among :: [Int] -> Int -> Bool
among some = case tableOf some of
  Just (least, table) -> \p -> fromMaybe False (table V.!? (p - least))
  Nothing -> (`IntSet.member` IntSet.fromList some)

-- | The numbers sorted, without duplicates.
eachOnce :: [Int] -> [Int]
eachOnce some = case tableOf some of
  Just (least, table) -> map (least +) (V.toList (V.elemIndices True table))
  Nothing -> IntSet.toAscList (IntSet.fromList some)

-- | The numbers as a table from the least to the greatest; 'Nothing' if that range is far longer
-- than the list.
tableOf :: [Int] -> Maybe (Int, V.Vector Bool)
tableOf some
  | most - least > 64 * length some = Nothing
  | otherwise = Just (least, marked)
  where
    (!least, !most) = foldl' (\(!low, !high) p -> (min low p, max high p)) (maxBound, 0) some
    marked = V.create $ do
      table <- M.replicate (max 0 (most - least + 1)) False
      forM_ some $ \p -> M.write table (p - least) True
      pure table

-- | The extent of a region along a direction (degrees clockwise from the x axis), in pixels: the
-- distance between the outermost pixels' centres along it, plus 1. 0 for an empty region.
extentAlong :: Masked -> Region -> Double -> Double
extentAlong pixels region
  | null region = const 0
  | otherwise = \angle ->
    let (c, s) = cosineSine angle
        reaching (Span least most) (x, y) =
          let t = c * x + s * y in Span (min least t) (max most t)
        Span first end = V.foldl' reaching (Span (1 / 0) (-1 / 0)) places
     in end - first + 1
  where
    !places = V.fromList [(fromIntegral x, fromIntegral y) | (x, y) <- map (placeOf pixels) region]

-- | The least and the greatest value of a range.
data Span = Span !Double !Double

-- | The bounding box of a region at its pixels' outer edges, where centres have whole coordinates:
-- left, top, right, bottom. Zeros for an empty region.
regionBox :: Masked -> Region -> (Double, Double, Double, Double)
regionBox pixels region
  | null region = (0, 0, 0, 0)
  | otherwise = (before x0, before y0, before (x1 + 1), before (y1 + 1))
  where
    Box x0 y0 x1 y1 = boxOf pixels region
    before t = fromIntegral t - 0.5

-- | The first column and row, and the last column and row.
data Box = Box !Int !Int !Int !Int

-- | The bounding box of a region that is not empty.
boxOf :: Masked -> Region -> Box
boxOf pixels = foldl' wider (Box maxBound maxBound minBound minBound)
  where
    wider (Box x0 y0 x1 y1) p =
      let (x, y) = placeOf pixels p in Box (min x0 x) (min y0 y) (max x1 x) (max y1 y)
