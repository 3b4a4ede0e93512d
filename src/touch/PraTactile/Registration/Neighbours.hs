{-# OPTIONS_HADDOCK hide #-}

-- | A spatial index of frames, and which frames overlap.
module PraTactile.Registration.Neighbours
  ( -- * The index
    Index (..),
    Square,
    indexed,
    squareAt,
    around,
    widest,

    -- * Pairs that overlap
    OverlappingPair (..),
    neighbours,
    neighboursAround,
    overlapShare,
  )
where

import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import PraTactile.Composite.Blend (Taxels, minus)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Image (Raster, rasterHeight, rasterWidth)

-- | A square's row and column.
type Square = (Int, Int)

-- | Frames by the square of a grid that their upper left pixel lies in.
data Index frame = Index
  { -- | the side of a square, taxels
    indexSide :: !Double,
    -- | the least x and y of all frames: the corner of square (0, 0), so that it does not matter
    -- where the robot counts from
    indexCorner :: !Taxels,
    -- | the frames of each square that has any, in the order given
    indexFrames :: !(Map Square [frame])
  }

-- | Frames at these places (taxels), in squares of this side: O(n log n).
indexed :: Double -> [(Taxels, frame)] -> Index frame
indexed side placed = empty {indexFrames = Map.fromListWith (++) (reverse held)}
  where
    empty = Index side (least fst, least snd) Map.empty
    least part = minimum (map (part . fst) placed)
    held = [(squareAt empty place, [frame]) | (place, frame) <- placed]

-- | The square of a place.
squareAt :: Index frame -> Taxels -> Square
squareAt (Index side corner _) place = (floor (y / side), floor (x / side))
  where
    (x, y) = place `minus` corner

-- | The squares within a number of rows and columns of one, row by row, with their frames.
around :: Int -> Index frame -> Square -> [(Square, [frame])]
around reach index (row, column) =
  [ (there, held)
    | j <- [negate reach .. reach],
      i <- [negate reach .. reach],
      let there = (row + j, column + i),
      Just held <- [Map.lookup there (indexFrames index)]
  ]

-- | The greatest width or height of images, taxels; at least 1.
widest :: [Raster] -> Double
widest images = fromIntegral (maximum (1 : [max (rasterWidth i) (rasterHeight i) | i <- images]))

-- | Two frames that overlap: their numbers, the smaller first; the place of the second's upper left
-- pixel in the first; and the overlap's share of the smaller frame.
data OverlappingPair = OverlappingPair
  { neighboursFirst :: !Int,
    neighboursSecond :: !Int,
    neighboursStep :: !Taxels,
    neighboursShare :: !Double
  }
  deriving stock (Eq, Show)

-- | The pairs of frames that overlap, given the places (taxels) of their upper left pixels, each
-- once. Of more than sixteen frames in one square of a frame's size, sixteen are used. The pairs
-- are then at most some hundred times the frames.
neighbours :: [(Taxels, Raster)] -> [OverlappingPair]
neighbours placed = neighboursAround (length placed) placed

-- | The pairs whose first frame is one of at most the given number, evenly spread.
neighboursAround :: Int -> [(Taxels, Raster)] -> [OverlappingPair]
neighboursAround most placed =
  [ OverlappingPair k l step share
    | (k, (place, a)) <- spacedOut most numbered,
      (l, (place', b)) <- concatMap snd (around 1 thinned (squareAt thinned place)),
      k < l,
      let step = place' `minus` place
          share = overlapShare a b step,
      share > 0
  ]
  where
    numbered = zip [0 :: Int ..] placed
    index = indexed (widest (map snd placed)) [(place, f) | f@(_, (place, _)) <- numbered]
    thinned = index {indexFrames = Map.map (spacedOut 16) (indexFrames index)}

-- | The overlap's share of the smaller of two images: the product of the shares along both axes.
-- The place is that of the second's upper left pixel in the first.
overlapShare :: Raster -> Raster -> Taxels -> Double
overlapShare a b (right, down) = along rasterWidth right * along rasterHeight down
  where
    along :: (Raster -> Int) -> Double -> Double
    along extent apart =
      let (m, n) = (fromIntegral (extent a), fromIntegral (extent b))
       in max 0 (if apart >= 0 then min n (m - apart) else min m (n + apart)) / max 1 (min m n)
