-- | First weights of a network: by Nguyen and Widrow (Proc. IJCNN 1990, vol. 3, 21-26), as @initnw@
-- of the Neural Network Toolbox has it, or uniform ones.
--
-- A layer of s sigmoid units has r inputs whose range is more than a point. Let w be s rows of r
-- uniform draws from -1 to 1, each row scaled to the norm
--
-- > m = 0.7 s^(1/r)
--
-- and b_i = m l_i sign (w_i1), where l are s numbers from -1 to 1, equally far apart (of one unit,
-- 0). This is for inputs from -1 to 1 and for units that answer to sums from -1 to 1. The toolbox
-- has a sigmoid unit answer to sums from -4 to 4, so that both are multiplied by 4; and an input x
-- from a to b is brought to 2 (x - a) / (b - a) - 1:
--
-- > W_ij = 4 w_ij 2 / (b_j - a_j),    B_i = 4 b_i - sum_j 4 w_ij (b_j + a_j) / (b_j - a_j)
--
-- An input whose range is a point has the weight 0.
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

-- | Which weights a network begins with.
data FirstWeights
  = -- | by 'initnw': the hidden layer for inputs of these ranges, one an input, the output layer
    -- for hidden units from 0 to 1 and times this factor
    NguyenWidrow [Range] Double
  | -- | uniform from -0.1 to 0.1
    UniformWeights
  deriving stock (Eq, Show)

-- | The least and the greatest value of an input.
type Range = (Double, Double)

-- | The ranges of inputs over vectors of them; none for none.
rangesOf :: [[Double]] -> [Range]
rangesOf = map (\values -> (minimum values, maximum values)) . transpose

-- | A network with these numbers of hidden units and outputs. Refuses ('LayersDoNotFit') fewer than
-- one of either, and ranges that are not 96.
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

-- | A layer of so many sigmoid units, at least one, for inputs of these ranges: a row a unit, its
-- weights and its bias last. Without an input whose range is more than a point there are biases
-- alone.
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

-- | So many numbers from -1 to 1, equally far apart; one alone is 0.
spaced :: Int -> [Double]
spaced 1 = [0]
spaced n = [2 * fromIntegral i / fromIntegral (n - 1) - 1 | i <- [0 .. n - 1]]
