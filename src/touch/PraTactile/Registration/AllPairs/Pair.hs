{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | What two frames that overlap say of their displacements, whatever they show.
module PraTactile.Registration.AllPairs.Pair
  ( Node (..),
    nodeOf,
    Pair (..),
    pairOf,
    pairReach,
    within,
    peak,
    byFrame,
    rest,
  )
where

import Data.List (foldl')
import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels, minus, plus)
import PraTactile.Image (Raster, rasterSize, rasterValues)
import PraTactile.Image.Correlate (Overlap (..), overlapAt, referenceOf)
import PraTactile.Registration.Loops (dot, dotWithin, tabulate)
import PraTactile.Registration.Neighbours (Neighbours (..))
import PraTactile.Registration.Search

-- | A frame.
data Node = Node
  { nodePlace :: !Taxels,
    nodeImage :: !Raster,
    -- | How much its pixels resemble those around them.
    nodeAlike :: Vector Double
  }

-- | A frame at its nominal place.
nodeOf :: (Taxels, Raster) -> Node
nodeOf (place, image) = Node place image (autocorrelations image)

-- | The autocorrelations of an image at all lags up to 'furthestAlike' along both axes, as if the
-- mean were around it.
autocorrelations :: Raster -> Vector Double
autocorrelations image = tabulate side side $ \j i -> at (i - furthestAlike) (j - furthestAlike)
  where
    side = 2 * furthestAlike + 1
    (w, h) = rasterSize image
    values = rasterValues image
    centred = let m = V.sum values / fromIntegral (V.length values) in V.map (subtract m) values
    total = dot centred centred
    at dx dy
      | total <= 0 || abs dx >= w || abs dy >= h = 0
      | otherwise = sum (map (row dx dy) [max 0 (negate dy) .. min h (h - dy) - 1]) / total
    row dx dy y =
      dotWithin (w - abs dx) (at' y (negate dx)) (at' (y + dy) dx)
    at' y dx = (centred, y * w + max 0 dx)

-- | How far pixels are taken to resemble each other, taxels.
furthestAlike :: Int
furthestAlike = 8

-- | What two frames say, by their numbers.
data Pair = Pair
  { pairFirst :: !Int,
    pairSecond :: !Int,
    -- | The greatest L: how much likelier, as a natural logarithm, they are of one relief than of
    -- two.
    pairMost :: !Double,
    -- | exp (L - the greatest), if the second's displacement on the grid exceeds the first's by so
    -- much: whole taxels up to 'pairReach' along both axes, row by row.
    pairShares :: !(Vector Float)
  }

-- | How far from each other two frames may lie beside their nominal displacement, taxels: two
-- standard deviations, of the largest that the robot's error may have.
pairReach :: Registration -> Int
pairReach settings = max 1 (min 12 (ceiling (2 * sqrt 2 * snd (sigmasFor settings))))

-- | What a pair says. What lies further apart than 'pairReach' tells nothing.
pairOf :: Registration -> Boxed.Vector Node -> Neighbours -> Pair
pairOf settings nodes (Neighbours k l step _) =
  Pair k l most (V.map (\t -> realToFrac (exp (t - most))) logs)
  where
    most = V.maximum logs
    logs = tabulate side side $ \j i ->
      let e@(x, y) = (i - reach, j - reach)
       in if within reach e then at (fromIntegral x + stepX, fromIntegral y + stepY) else 0
    reach = pairReach settings
    side = 2 * reach + 1
    -- Between the grid points nearest to the nominal places.
    (stepX, stepY) =
      let ((x, y), (x', y')) = (nodePlace (nodes Boxed.! k), nodePlace (nodes Boxed.! l))
       in (nearest x' - nearest x, nearest y' - nearest y)
    at = pairLog settings nodes (k, l) step

-- | L of two frames, by their numbers, the second's upper left pixel lying there in the first: an
-- overlap counts no more than where the second one is at a place given before.
pairLog ::
  Registration -> Boxed.Vector Node -> (Int, Int) -> Taxels -> Taxels -> Double
pairLog settings nodes (k, l) (x0, y0) = \(x, y) ->
  let overlap = overlapAt there image x y
   in share * logLikelihood settings overlap {overlapWeight = min most (overlapWeight overlap)}
  where
    -- Note [Pixels that resemble each other]
    share = 1 / sqrt (max 1 (dot (nodeAlike (nodes Boxed.! k)) (nodeAlike (nodes Boxed.! l))))
    there = referenceOf (nodeImage (nodes Boxed.! k))
    image = nodeImage (nodes Boxed.! l)
    !most = overlapWeight (overlapAt there image x0 y0)

{- Note [Pixels that resemble each other] By chance two reliefs correlate as if pixels were as many
   times fewer as the sum of the products of their autocorrelations over all lags (Bartlett, 1946).
   One relief under white noise is told by every pixel. What is taken is the mean of both in the
   logarithm (assumption). -}

-- | Whether that many taxels right and down are no further than a reach.
within :: Int -> (Int, Int) -> Bool
within reach (x, y) = x * x + y * y <= reach * reach

-- | Where L of two frames is highest near a difference of their displacements, to an eighth of a
-- taxel along x and then along y; and its second derivatives there, with the sign of a precision.
peak ::
  Registration -> Boxed.Vector Node -> (Int, Int) -> Taxels -> (Taxels, Taxels)
peak settings nodes (k, l) start = (best, (steep (1 / 2, 0), steep (0, 1 / 2)))
  where
    logs e = pairLog settings nodes (k, l) (step `plus` start) (step `plus` e)
    step = nodePlace (nodes Boxed.! l) `minus` nodePlace (nodes Boxed.! k)
    (top, best) = foldl' finer (logs start, start) [1 / 2, 1 / 4, finestStep]
    finer found size = foldl' (along size) found [(1, 0), (0, 1)]
    along size found@(_, e) (i, j) =
      foldl'
        (\old e' -> let s = logs e' in if s > fst old then (s, e') else old)
        found
        [e `minus` (i * size, j * size), e `plus` (i * size, j * size)]
    steep half = max 0 (4 * (2 * top - logs (best `minus` half) - logs (best `plus` half)))

-- | What is left of a place beyond the nearest grid point.
rest :: Taxels -> Taxels
rest (x, y) = (x - nearest x, y - nearest y)

-- | The nearest whole number.
nearest :: Double -> Double
nearest t = fromIntegral (round t :: Int)

-- | What is said of frames, by frame.
byFrame :: Int -> [(Int, a)] -> Boxed.Vector [a]
byFrame count said = Boxed.accumulate (flip (:)) (Boxed.replicate count []) (Boxed.fromList said)
