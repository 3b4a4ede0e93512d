{-# OPTIONS_HADDOCK hide #-}

-- | Replaces the readings of dead elements by the mean of their nearest living neighbours.
module PraTactile.Sensor.Dead
  ( filled,
    distances,
  )
where

import Control.Monad (forM_, when)
import Data.Set (Set)
import qualified Data.Set as Set
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as Mutable

-- | The readings of a sensor, row by row, with each dead one replaced by the mean of its nearest
-- living neighbours. The arguments are width and height, the dead elements (row, column) and the
-- readings. The nearest neighbours are those in the smallest square ring that holds any; 0 if all
-- elements are dead. The rings are found once for all readings; then each dead element costs its
-- own ring, O(width + height).
filled :: (Int, Int) -> Set (Int, Int) -> V.Vector Double -> V.Vector Double
filled size@(w, h) gone
  | Set.null gone = id
  | otherwise = \readings ->
    let at (y, x) = readings V.! (y * w + x)
        place k r
          | r == 0 = readings V.! k
          | r > max w h = 0
          | otherwise = mean (map at (filter living (ring (k `divMod` w) r)))
     in V.imap place radii
  where
    radii = distances size gone
    living (y, x) = radii V.! (y * w + x) == 0
    mean values = sum values / fromIntegral (length values)
    -- The elements of the square ring of this radius that lie on the sensor, row by row.
    ring (y, x) r =
      [ (j, i)
        | j <- [max 0 (y - r) .. min (h - 1) (y + r)],
          i <-
            if abs (j - y) == r
              then [max 0 (x - r) .. min (w - 1) (x + r)]
              else [i | i <- [x - r, x + r], i >= 0, i < w]
      ]

-- | The distance of each element from the nearest living one, as the greater of the distances
-- along the two axes; more than the width and the height if none lives. Two passes over the sensor
-- from opposite corners, O(width * height): A. Rosenfeld, J. L. Pfaltz, Sequential operations in
-- digital picture processing, Journal of the ACM 13 (1966).
distances :: (Int, Int) -> Set (Int, Int) -> V.Vector Int
distances (w, h) gone = V.create $ do
  far <- Mutable.replicate (max 0 w * max 0 h) 0
  forM_ (Set.toList gone) $ \(y, x) -> Mutable.write far (y * w + x) (w + h)
  let nearer (y, x) (j, i) =
        when (i >= 0 && i < w && j >= 0 && j < h) $ do
          beside <- Mutable.read far (j * w + i)
          Mutable.modify far (min (beside + 1)) (y * w + x)
      pass s rows columns =
        forM_ [(y, x) | y <- rows, x <- columns] $ \(y, x) ->
          forM_ [(y - s, x - 1), (y - s, x), (y - s, x + 1), (y, x - s)] (nearer (y, x))
  pass 1 [0 .. h - 1] [0 .. w - 1]
  pass (-1) [h - 1, h - 2 .. 0] [w - 1, w - 2 .. 0]
  pure far
