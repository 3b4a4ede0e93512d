{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The estimated displacement of a frame, with alternatives.
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

-- | The estimated displacement of a frame.
data Estimate = Estimate
  { -- | Its displacement from its nominal place, taxels right and down.
    estimateShift :: !Taxels,
    -- | Its standard deviations, taxels.
    estimateDeviation :: !Taxels,
    -- | The probability that it is within 'tolerance' of the truth on both axes.
    estimateProbability :: !Double,
    -- | At most two alternative displacements, at least two taxels away, each of a probability of
    -- at least 'leastOther', the most probable first.
    estimateOthers :: [Hypothesis],
    -- | The alternatives on the grid of the frame's displacements, if it has one.
    estimateElsewhere :: [(Int, Int)]
  }
  deriving stock (Eq, Show)

-- | The estimate of a frame from its grid displacements with their probabilities, of which there
-- must be some. The offset of its nominal place from the grid point is in steps. The estimate is
-- the mean of the displacements within 'tolerance' of the best.
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

-- | Moves an estimate and its alternatives.
moveBy :: Taxels -> Estimate -> Estimate
moveBy by l =
  l
    { estimateShift = estimateShift l `plus` by,
      estimateOthers = [h {hypothesisShift = hypothesisShift h `plus` by} | h <- estimateOthers l]
    }

-- | Moves estimates so that their mean is 0, since a common shift is unobservable. Also gives the
-- mean, to an eighth of a taxel.
centred :: [Estimate] -> ([Estimate], Taxels)
centred estimates = (map (moveBy (negate x, negate y)) estimates, common)
  where
    common@(x, y) = (mean fst, mean snd)
    mean part = eighth (sum (map (part . estimateShift) estimates) / n)
    n = fromIntegral (max 1 (length estimates))
