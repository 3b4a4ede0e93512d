{-# OPTIONS_HADDOCK hide #-}

-- | The scales of positions that fit what the frames show. Positions in another unit, or counted in
-- steps, differ from the true ones by a factor across and down.
module PraTactile.Registration.Scale
  ( likelyScales,
  )
where

import Data.List (sortOn)
import Data.Ord (Down (..))
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Numbers (greatestExtent, leastExtent, mostScales)

-- | The scales across and down, of both axes alike or of one, at which nominal places (taxels) are
-- likelier than as given. The function is the log-likelihood of places. At most 'mostScales', the
-- likeliest first.
--
-- From one scale to the next the outermost frame moves by less than a taxel. The largest extent is
-- 'greatestExtent'.
likelyScales :: ([Taxels] -> Double) -> [Taxels] -> [(Double, Double)]
likelyScales likely places =
  map snd . take mostScales . sortOn (Down . fst) $
    concatMap (peaks . map scored) [both, across, down]
  where
    asTold = likely places
    scored scale = (likely (map (scaled scale) places), scale)
    scaled (sx, sy) (x, y) = (centreX + sx * (x - centreX), centreY + sy * (y - centreY))
    (centreX, extentX) = spread (map fst places)
    (centreY, extentY) = spread (map snd places)
    both = [(s, s) | s <- scalesOf (max extentX extentY)]
    across = [(s, 1) | extentY > 0, s <- scalesOf extentX]
    down = [(1, s) | extentX > 0, s <- scalesOf extentY]
    -- Scores above both neighbours.
    peaks found =
      [ b
        | ((a, _), b@(here, _), (c, _)) <- zip3 found (drop 1 found) (drop 2 found),
          here > asTold,
          here >= a,
          here > c
      ]

-- | The scales to try for places of an extent, ascending: none for an extent of 0.
scalesOf :: Double -> [Double]
scalesOf extent
  | extent <= 0 = []
  | otherwise = [t / extent | t <- takeWhile (< greatestExtent) (iterate (+ 1) leastExtent)]

-- | The middle and the extent of some numbers.
spread :: [Double] -> (Double, Double)
spread ts = ((least + most) / 2, most - least)
  where
    (least, most) = (minimum ts, maximum ts)
