{-# OPTIONS_HADDOCK hide #-}

-- | Alternatives to the layout in which frames on a lattice are found: one frame elsewhere, or some
-- frames a whole cell further along the face. All frames stay on the lattice, so that their
-- log-likelihoods belong to other cells.
module PraTactile.Registration.Alternatives
  ( oneElsewhere,
    slipped,
    tiedGroups,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.List (sortOn, tails)
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Composite.Blend (minus, plus)
import PraTactile.Composite.Lattice
import PraTactile.Registration.Field.Cells
import PraTactile.Registration.Groups (joinedBy)
import PraTactile.Registration.Joint
import PraTactile.Registration.Joint.Displacement (cellNumber)
import PraTactile.Registration.Numbers (mostElsewhere, mostTied, sure)
import PraTactile.Registration.Posterior (Hypothesis (..))

-- | The lattices with one frame at an alternative place, each with the odds of that place to the
-- one found. They are the 'mostElsewhere' most probable of all frames.
oneElsewhere :: Joint -> [(Double, Lattice)]
oneElsewhere found =
  take mostElsewhere . sortOn (negate . fst) $
    [ (p / max 1e-9 (1 - p), laid k (hypothesisShift h) shift)
      | (k, l) <- zip [0 ..] (jointFrames found),
        (h, shift) <- zip (estimateOthers l) (estimateElsewhere l),
        let p = hypothesisProbability h
    ]
  where
    lattice = jointLattice found
    laid k to shift =
      lattice
        { latticeFrames = changed k (`plus` (to `minus` shiftOf k)) (latticeFrames lattice),
          latticeCells = cellsTold (changed k (const (toldAt shift (displacementsOf' k))) told)
        }
    told = jointTold found
    shiftOf k = estimateShift (jointFrames found !! k)
    displacementsOf' k = fieldFrames (jointField found) !! k
    changed :: Int -> (a -> a) -> [a] -> [a]
    changed k change xs = [if k == n then change x else x | (n, x) <- zip [0 ..] xs]

-- | The log-likelihood ratio of a slip to the layout found, and its lattice. Given are the rows and
-- columns of cells by which each frame slips.
slipped :: Joint -> [(Int, Int)] -> (Double, Lattice)
slipped found steps = (cellsBound told - cellsBound (jointTold found), laid)
  where
    told = zipWith slip steps (jointTold found)
    slip (i, j) = IntMap.mapKeysMonotonic (+ cellNumber i j)
    lattice = jointLattice found
    laid =
      lattice
        { latticeFrames = zipWith (plus . latticeStep lattice) steps (latticeFrames lattice),
          latticeCells = cellsTold told
        }

-- | The group of each frame, numbered in order. Two frames are tied if they are likelier to show
-- one symbol than two in the cells that both see. Ties join frames directly or through others. The
-- group -1 has the frames that show no symbol at odds of 99. Of more than 'mostTied' frames all are
-- one group.
tiedGroups :: Joint -> [Int]
tiedGroups found
  | length told > mostTied = map (const 0) told
  | otherwise = [IntMap.findWithDefault (-1) k groups | (k, _) <- zip [0 ..] told]
  where
    told = jointTold found
    showing = [(k, t) | (k, t) <- zip [0 ..] told, any symbolIn t]
    symbolIn g = Unboxed.maximum g - g Unboxed.! 0 > sure
    groups =
      IntMap.fromList
        [ (k, group)
          | (group, component) <- zip [0 ..] (filter (any (`elem` map fst showing)) joined),
            k <- component
        ]
    joined = joinedBy (length told) ties
    ties = [(k, l) | (k, a) : others <- tails showing, (l, b) <- others, tie a b > 0]
    -- The log-likelihood ratio of one symbol to two in the cells that both see.
    tie a b = cellsBound [a', b'] - cellsBound [a'] - cellsBound [b']
      where
        (a', b') = (IntMap.intersection a b, IntMap.intersection b a)
