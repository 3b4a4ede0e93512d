{-# OPTIONS_HADDOCK hide #-}

-- | Which of many frames overlap.
module PraTactile.Registration.Neighbours
  ( Neighbours (..),
    neighbours,
    neighboursAround,
  )
where

import qualified Data.Map.Strict as Map
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Image (Raster, rasterHeight, rasterWidth)

-- | Two frames that overlap, by their numbers, the smaller one first; where the second's upper left
-- pixel lies in the first; and the share of the smaller frame that the overlap has.
data Neighbours = Neighbours
  { neighboursFirst :: !Int,
    neighboursSecond :: !Int,
    neighboursStep :: !Taxels,
    neighboursShare :: !Double
  }
  deriving stock (Eq, Show)

-- | The pairs that overlap at these places (taxels) of the frames' upper left pixels, each once. Of
-- more than sixteen frames whose upper left pixels lie within a square of a frame's size, sixteen
-- are looked at, so that the pairs are not more than some hundred times the frames.
neighbours :: [(Taxels, Raster)] -> [Neighbours]
neighbours placed = neighboursAround (length placed) placed

-- | The same around at most so many of the frames, evenly.
neighboursAround :: Int -> [(Taxels, Raster)] -> [Neighbours]
neighboursAround most placed =
  [ Neighbours k l (x' - x, y' - y) share
    | (k, ((x, y), a)) <- spacedOut most numbered,
      let (column, row) = square (x, y),
      j <- [-1 .. 1],
      i <- [-1 .. 1],
      (l, ((x', y'), b)) <- Map.findWithDefault [] (column + i, row + j) squares,
      k < l,
      let share = meeting rasterWidth a b (x' - x) * meeting rasterHeight a b (y' - y),
      share > 0
  ]
  where
    meeting :: (Raster -> Int) -> Raster -> Raster -> Double -> Double
    meeting extent a b apart =
      let (m, n) = (fromIntegral (extent a), fromIntegral (extent b))
       in max 0 (if apart >= 0 then min n (m - apart) else min m (n + apart)) / max 1 (min m n)
    numbered = zip [0 :: Int ..] placed
    squares =
      Map.map (spacedOut 16) $
        Map.fromListWith (flip (++)) [(square place, [f]) | f@(_, (place, _)) <- numbered]
    -- Counted from the frames, so that it does not matter where the robot counts from.
    square (x, y) = (floor ((x - left) / side) :: Int, floor ((y - top) / side) :: Int)
    left = minimum (map (fst . fst) placed)
    top = minimum (map (snd . fst) placed)
    side =
      fromIntegral (maximum (1 : [max (rasterWidth i) (rasterHeight i) | (_, i) <- placed])) ::
        Double
