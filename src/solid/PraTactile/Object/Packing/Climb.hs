{-# OPTIONS_HADDOCK hide #-}

-- | Improves orders of pieces for bottom-left fill by hill climbing. Orders by size are tried
-- first. Then the best of them is changed, a stretch at a time, and a change is kept if the result
-- is no worse.
module PraTactile.Object.Packing.Climb
  ( Climb,
    climbBest,
    climbSteps,
    climbMoves,
    climbStart,
    climbMove,
  )
where

import Data.List (minimumBy, nub, sortOn)
import Data.Ord (Down (..), comparing)
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Packing.Filling
import PraTactile.Object.Packing.Kinds
import PraTactile.Object.Packing.Mask
import PraTactile.Object.Packing.Occupancy
import System.Random (StdGen, genWord64, mkStdGen)

-- | The best filling so far, and how it was found.
data Climb = Climb
  { climbBest :: !Filling,
    climbOrder :: !(U.Vector Int),
    climbChoice :: !Choice,
    climbRandom :: !StdGen,
    -- | the number of runs tested in all fillings so far
    climbSteps :: !Int,
    -- | the number of changes of the order that were tried
    climbMoves :: !Int
  }

-- | The best filling among orders by size, the largest pieces first. Arguments: the number of steps
-- after which no further order is tried; a seed for later changes; the sheet; the pieces. Pieces
-- are laid as figures with few cells only if some find no place otherwise.
climbStart :: Int -> Int -> Still -> Kinds -> Climb
climbStart enough seed sheet kinds
  | fillingOver (climbBest wide) == 0 || climbSteps wide > enough = wide
  | otherwise = better wide (begun FewestCells)
  where
    wide = begun MostCells
    begun choice = foldl next (start choice (by (\k -> [cells k]))) (map (start choice) orders)
    start choice order =
      let filling = filled sheet kinds choice order
       in Climb filling order choice (mkStdGen seed) (fillingSteps filling) 0
    next best other = if climbSteps best > enough then best else better best other
    better one other =
      (minimumBy (comparing (fillingCost . climbBest)) [one, other])
        { climbSteps = climbSteps one + climbSteps other
        }
    -- Including the order by cells alone.
    orders =
      nub
        [ by (\k -> [least k, cells k]),
          by (\k -> [most k, cells k]),
          by (\k -> [least k, most k, cells k])
        ]
    by size =
      U.concat
        [ U.replicate (kindsCount kinds U.! k) k
          | k <- sortOn (Down . size) [0 .. U.length (kindsCount kinds) - 1]
        ]
    cells = fewestCells kinds
    least = minimum . map figureRows . figuresOf kinds
    most = maximum . map figureRows . figuresOf kinds

-- | Tries one change of the order, which is kept if the result is no worse. A stretch of pieces is
-- reversed or moved, or a piece that found no place comes earlier.
climbMove :: Still -> Kinds -> Climb -> Climb
climbMove sheet kinds climb
  | fillingCost found <= fillingCost (climbBest climb) =
    next {climbBest = found, climbOrder = order}
  | otherwise = next
  where
    found = filled sheet kinds (climbChoice climb) order
    next =
      climb
        { climbRandom = random',
          climbSteps = climbSteps climb + fillingSteps found,
          climbMoves = climbMoves climb + 1
        }
    before = climbOrder climb
    n = U.length before
    without = fillingWithout (climbBest climb)
    (draws, random') = drawn 4 (climbRandom climb)
    order = case draws of
      which : x : y : z : _
        | which `mod` 4 < 2,
          not (null without) ->
          let from = without !! (x `mod` length without)
           in moved from 1 (y `mod` (from + 1))
        | even which -> turned (x `mod` n) (stretch y (n - x `mod` n))
        | otherwise ->
          let from = x `mod` n
              l = stretch y (n - from)
           in moved from l (z `mod` (n - l + 1))
      _ -> before
    stretch y left = 1 + y `mod` min left longest
    turned from l = let (front, part, rest) = parts from l in U.concat [front, U.reverse part, rest]
    moved from l to =
      let (front, part, rest) = parts from l
          (front', rest') = U.splitAt to (front U.++ rest)
       in U.concat [front', part, rest']
    parts from l =
      let (front, back) = U.splitAt from before
          (part, rest) = U.splitAt l back
       in (front, part, rest)

-- | The most pieces of a stretch. Longer ones are seldom kept.
longest :: Int
longest = 60

-- | This number of random integers below 2^62.
drawn :: Int -> StdGen -> ([Int], StdGen)
drawn 0 g = ([], g)
drawn k g = (fromIntegral (word `div` 4) : rest, g'')
  where
    (word, g') = genWord64 g
    (rest, g'') = drawn (k - 1) g'
