{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Where a frame was found, and where else it may be.
module PraTactile.Registration.Estimate
  ( Estimate (..),
    estimateAt,
    moveBy,
    centred,
  )
where

import Data.List (foldl', sortOn)
import qualified Data.Map.Strict as Map
import PraTactile.Composite.Blend (Taxels, plus)
import PraTactile.Registration.Field (Grid (..), inTaxels)
import PraTactile.Registration.Model (eighth)
import PraTactile.Registration.Numbers (leastOther, tolerance)
import PraTactile.Registration.Posterior (Hypothesis (..))

-- | Where a frame was found.
data Estimate = Estimate
  { -- | Its displacement from its nominal place, taxels right and down.
    estimateShift :: !Taxels,
    -- | The standard deviations, taxels.
    estimateDeviation :: !Taxels,
    -- | The probability that it is within 'tolerance' of the truth on both axes.
    estimateProbability :: !Double,
    -- | Displacements that it may have instead, at least two taxels away, with their probabilities,
    -- the most probable first: at most two, each of at least a thousandth.
    estimateOthers :: [Hypothesis],
    -- | These displacements on the grid that the frame's are on, where it has one.
    estimateElsewhere :: [(Int, Int)]
  }
  deriving stock (Eq, Show)

-- | Where a frame is, given how far its nominal place lies beyond its grid point (steps), and its
-- displacements on the grid with their probabilities: the mean of those within 'tolerance' of the
-- likeliest. There must be some displacements.
estimateAt :: Grid -> (Double, Double) -> [((Int, Int), Double)] -> Estimate
estimateAt grid (rx, ry) options =
  Estimate
    (finally meanX rx, finally meanY ry)
    (spreadOf meanX fst, spreadOf meanY snd)
    (min 1 mass)
    (map fst others)
    (map snd others)
  where
    others = take 2 (instead (filter (far (meanX, meanY) . snd) (sortOn (negate . fst) held)))
    instead found = case found of
      (p, (x, y)) : rest
        | p >= leastOther ->
          (Hypothesis (finally (fromIntegral x) rx, finally (fromIntegral y) ry) p, (x, y)) :
          instead (filter (far (fromIntegral x, fromIntegral y) . snd) rest)
      _ -> []
    far (x, y) (x', y') =
      max (abs (x - fromIntegral x')) (abs (y - fromIntegral y')) >= 2 * steps
    masses = Map.fromListWith (+) options
    steps = fromIntegral (gridPerTaxel grid) :: Double
    reach = floor (steps * tolerance + 1e-9) :: Int
    around (x, y) =
      [ ((x', y'), p)
        | y' <- [y - reach .. y + reach],
          x' <- [x - reach .. x + reach],
          Just p <- [Map.lookup (x', y') masses]
      ]
    held = [(sum (map snd (around d)), d) | d <- Map.keys masses]
    (mass, best) = foldl' (\a b -> if fst b > fst a + 1e-9 then b else a) (-1, (0, 0)) held
    near = around best
    meanX = sum [p * fromIntegral x | ((x, _), p) <- near] / mass
    meanY = sum [p * fromIntegral y | ((_, y), p) <- near] / mass
    finally mean rest = eighth (inTaxels grid (mean - rest))
    spreadOf :: Double -> ((Int, Int) -> Int) -> Double
    spreadOf mean part =
      inTaxels grid . sqrt $
        sum [p * squared (fromIntegral (part d) - mean) | (d, p) <- Map.toList masses] + 1 / 12
    squared !t = t * t

-- | An estimate with all its displacements moved.
moveBy :: Taxels -> Estimate -> Estimate
moveBy by l =
  l
    { estimateShift = estimateShift l `plus` by,
      estimateOthers = [h {hypothesisShift = hypothesisShift h `plus` by} | h <- estimateOthers l]
    }

-- | Estimates whose displacements have mean 0, since a shift common to all frames cannot be seen;
-- and that shift, to an eighth of a taxel.
centred :: [Estimate] -> ([Estimate], Taxels)
centred estimates = (map (moveBy (negate x, negate y)) estimates, common)
  where
    common@(x, y) = (mean fst, mean snd)
    mean part = eighth (sum (map (part . estimateShift) estimates) / n)
    n = fromIntegral (max 1 (length estimates))
