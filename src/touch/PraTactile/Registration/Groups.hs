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
import PraTactile.Composite.Blend (Taxels, minus)
import PraTactile.Image (Raster, rasterHeight, rasterWidth)
import PraTactile.Registration.Neighbours

-- | For each image, at its place in taxels, its group: images that overlap, directly or through
-- others, are of one group. Groups are numbered from 0 as they come. Linear in the images, however
-- many overlap.
groupsOf :: [(Taxels, Raster)] -> [Int]
groupsOf placed =
  IntMap.elems . IntMap.fromList $
    [ (k, group)
      | (group, component) <- zip [0 ..] (joinedBy (length placed) enough),
        k <- component
    ]
  where
    -- Two images in one square overlap, however many there are.
    narrowest = minimum (maxBound : concat [[rasterWidth i, rasterHeight i] | (_, i) <- placed])
    index =
      indexed
        (fromIntegral narrowest)
        [(place, (k, (place, image))) | (k, (place, image)) <- zip [0 ..] placed]
    reach = ceiling (widest (map snd placed) / fromIntegral narrowest)
    -- Pairs that overlap, as many as join all that do: each image of a square with its first, and
    -- one pair of two squares.
    enough =
      [(k, l) | (k, _) : others <- Map.elems (indexFrames index), (l, _) <- others]
        ++ [ pair
             | (here, held) <- Map.toList (indexFrames index),
               (there, held') <- around reach index here,
               there > here,
               pair <- take 1 [(k, l) | (k, a) <- held, (l, b) <- held', overlap a b]
           ]
    overlap (place, a) (place', b) = overlapShare a b (place' `minus` place) > 0

-- | The groups of this many things, by their numbers from 0, that pairs of them join, directly or
-- through others. The least of each group is its first, and groups come in the order of these.
joinedBy :: Int -> [(Int, Int)] -> [[Int]]
joinedBy count pairs = map toList (components (buildG (0, count - 1) pairs))
