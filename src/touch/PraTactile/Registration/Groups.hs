{-# OPTIONS_HADDOCK hide #-}

-- | Which frames overlap, directly or through others.
module PraTactile.Registration.Groups
  ( groupsOf,
    joinedBy,
  )
where

import Data.Foldable (toList)
import Data.Graph (buildG, components)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster, rasterHeight, rasterWidth)

-- | For each image, at its place in taxels, its group: images that overlap, directly or through
-- others, are of one group. Groups are numbered from 0 as they come.
groupsOf :: [(Taxels, Raster)] -> [Int]
groupsOf placed = map (groups IntMap.!) [0 .. length placed - 1]
  where
    groups =
      IntMap.fromList
        [ (k, group)
          | (group, component) <- zip [0 ..] (joinedBy (length placed) overlaps),
            k <- component
        ]
    -- Two images whose corners are in one square overlap, however many there are.
    side =
      fromIntegral
        (minimum (maxBound : concat [[rasterWidth i, rasterHeight i] | (_, i) <- placed])) ::
        Double
    furthest = maximum (1 : concat [[rasterWidth i, rasterHeight i] | (_, i) <- placed])
    reach = ceiling (fromIntegral furthest / side) :: Int
    square (x, y) = (floor (x / side) :: Int, floor (y / side) :: Int)
    squares =
      Map.fromListWith
        (flip (++))
        [(square place, [(k, (place, image))]) | (k, (place, image)) <- zip [0 ..] placed]
    -- Enough of them that who overlaps is joined.
    overlaps =
      [(k, l) | (k, _) : others <- Map.elems squares, (l, _) <- others]
        ++ [ pair
             | ((c, r), here) <- Map.toList squares,
               j <- [0 .. reach],
               i <- [negate reach .. reach],
               (j, i) > (0, 0),
               Just there <- [Map.lookup (c + i, r + j) squares],
               pair <- take 1 [(k, l) | (k, a) <- here, (l, b) <- there, meets a b]
           ]
    meets ((x, y), a) ((x', y'), b) =
      x' - x < wide a && x - x' < wide b && y' - y < tall a && y - y' < tall b
    wide = fromIntegral . rasterWidth
    tall = fromIntegral . rasterHeight

-- | The groups of so many things, by their numbers from 0, that pairs of them join, directly or
-- through others. The least of each group is its first, and groups come in the order of these.
joinedBy :: Int -> [(Int, Int)] -> [[Int]]
joinedBy count pairs = map toList (components (buildG (0, count - 1) pairs))
