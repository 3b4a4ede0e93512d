-- | Initial weights of a network, either uniform or by Nguyen and Widrow (Proc. IJCNN 1990, vol.
-- 3, 21-26) as in @initnw@ of the Neural Network Toolbox.
--
-- A layer has s sigmoid units and r inputs whose range is not a single point. Let w be s rows of r
-- uniform draws from -1 to 1, each row scaled to the norm
--
-- > m = 0.7 s^(1/r)
--
-- and let b_i = m t_i sign (w_i1), where t are s equally spaced numbers from -1 to 1 (0 if s = 1).
-- These w and b suit inputs from -1 to 1 and units that respond to sums from -1 to 1. The toolbox
-- takes the sigmoid's responsive range to be -4 to 4, so it multiplies w and b by 4. An input x_j
-- whose range is l_j to u_j is mapped to 2 (x_j - l_j) / (u_j - l_j) - 1. The resulting weights W
-- and biases B are
--
-- > W_ij = 4 w_ij 2 / (u_j - l_j),    B_i = 4 b_i - sum_j 4 w_ij (u_j + l_j) / (u_j - l_j)
--
-- An input whose range is a single point gets the weight 0.
module PraTactile.Classification.NguyenWidrow
  ( -- * First weights
    FirstWeights (..),
    firstNetwork,

    -- * A layer
    Range,
    rangesOf,
    initnw,
  )
where

import Data.List (mapAccumL, transpose)
import Numeric.LinearAlgebra (Matrix, fromLists, scale)
import PraTactile.Classification.Network
import PraTactile.Classification.Train (initialNetwork)
import PraTactile.Random (uniform)
import System.Random (StdGen)

-- | How the first weights of a network are chosen.
data FirstWeights
  = -- | by 'initnw': the hidden layer for the given range of each input; the output layer for
    -- hidden units from 0 to 1, with its weights and biases multiplied by the given factor
    NguyenWidrow [Range] Double
  | -- | uniform from -0.1 to 0.1
    UniformWeights
  deriving stock (Eq, Show)

-- | The least and the greatest value of an input.
type Range = (Double, Double)

-- | The range of each input over a list of input vectors; an empty list if there are none.
rangesOf :: [[Double]] -> [Range]
rangesOf = map (\values -> (minimum values, maximum values)) . transpose

-- | A network for 8 x 12 images, and the next generator. Arguments: how its weights are chosen; the
-- number of hidden units; the number of outputs; a generator. Refuses ('LayersDoNotFit') numbers
-- below 1, and for 'NguyenWidrow' other than 96 ranges, one for each pixel.
firstNetwork :: FirstWeights -> Int -> Int -> StdGen -> Either NetworkError (Network, StdGen)
firstNetwork weights hidden outs g = case weights of
  UniformWeights -> initialNetwork hidden outs g
  NguyenWidrow ranges factor
    | hidden < 1 || outs < 1 || length ranges /= inputCount -> Left LayersDoNotFit
    | otherwise -> do
      let (w1, g') = initnw hidden ranges g
          (w2, g'') = initnw outs (replicate hidden (0, 1)) g'
      n <- network w1 (scale factor w2)
      Right (n, g'')

-- | A layer with the given number of sigmoid units (at least one) for inputs of the given ranges,
-- and the next generator. Each row is a unit: its weights, then its bias. If all ranges are single
-- points, all weights are 0 and m is 0.7 s.
initnw :: Int -> [Range] -> StdGen -> (Matrix Double, StdGen)
initnw units ranges g = (fromLists (zipWith unit (spaced units) rows), g')
  where
    (g', rows) = mapAccumL (\h _ -> mapAccumL weight h ranges) g [1 .. units]
    weight h (a, b)
      | a < b = let (u, h') = uniform h in (h', 2 * u - 1)
      | otherwise = (h, 0)
    r = length [() | (a, b) <- ranges, a < b]
    m
      | r == 0 = 0.7 * fromIntegral units
      | otherwise = 0.7 * fromIntegral units ** (1 / fromIntegral r) :: Double
    unit l drawn = zipWith over w ranges ++ [4 * m * l * side - sum (zipWith middle w ranges)]
      where
        w = map (* (4 * m / max 1e-300 (sqrt (sum (map (^ (2 :: Int)) drawn))))) drawn
        side = case [u | u <- drawn, u /= 0] of
          u : _ | u < 0 -> -1
          _ -> 1
    over w (a, b) = if a < b then 2 * w / (b - a) else 0
    middle w (a, b) = if a < b then w * (b + a) / (b - a) else 0

-- | The given number of equally spaced numbers from -1 to 1; a single one is 0.
spaced :: Int -> [Double]
spaced 1 = [0]
spaced n = [2 * fromIntegral i / fromIntegral (n - 1) - 1 | i <- [0 .. n - 1]]
