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

-- | The group of each image, given their places in taxels: images that overlap, directly or through
-- others. Groups are numbered from 0 in order. The cost is linear in the images, however many
-- overlap.
groupsOf :: [(Taxels, Raster)] -> [Int]
groupsOf placed =
  IntMap.elems . IntMap.fromList $
    [ (k, group)
      | (group, component) <- zip [0 ..] (joinedBy (length placed) enough),
        k <- component
    ]
  where
    -- Squares are so narrow that two images in one square always overlap.
    narrowest = minimum (maxBound : concat [[rasterWidth i, rasterHeight i] | (_, i) <- placed])
    index =
      indexed
        (fromIntegral narrowest)
        [(place, (k, (place, image))) | (k, (place, image)) <- zip [0 ..] placed]
    reach = ceiling (widest (map snd placed) / fromIntegral narrowest)
    -- Enough pairs to join all images that overlap: each image with the first of its square, and
    -- one pair for two squares.
    enough =
      [(k, l) | (k, _) : others <- Map.elems (indexFrames index), (l, _) <- others]
        ++ [ pair
             | (here, held) <- Map.toList (indexFrames index),
               (there, held') <- around reach index here,
               there > here,
               pair <- take 1 [(k, l) | (k, a) <- held, (l, b) <- held', overlap a b]
           ]
    overlap (place, a) (place', b) = overlapShare a b (place' `minus` place) > 0

-- | The connected components of count things, numbered from 0, that the pairs join. Each component
-- begins with its least member, and components come in the order of these.
joinedBy :: Int -> [(Int, Int)] -> [[Int]]
joinedBy count pairs = map toList (components (buildG (0, count - 1) pairs))
