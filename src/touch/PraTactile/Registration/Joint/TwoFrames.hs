{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Two frames on a lattice, solved exactly. A common shift is unobservable, so the first frame
-- stays at its nominal place. All phases of the lattice under it are summed.
module PraTactile.Registration.Joint.TwoFrames
  ( TwoFrames (..),
    twoFrames,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.List (maximumBy)
import qualified Data.Map.Strict as Map
import Data.Ord (comparing)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Field
import PraTactile.Registration.Field.Cells (cellOf)
import PraTactile.Registration.Joint.Displacement
import PraTactile.Registration.Lattice.Likelihood (Likelihood (..))
import PraTactile.Registration.Numbers (mostCandidates)

-- | The displacement of the second frame against the first.
data TwoFrames = TwoFrames
  { -- | The lattice's orientation and phase (row, column) at the likeliest displacement.
    twoPhase :: !(Int, (Int, Int)),
    -- | The displacements of the second frame on the grid, with their probabilities.
    twoDisplacements :: [((Int, Int), Double)]
  }

-- | The posterior of the second frame's displacement on a grid. Each frame comes with the place of
-- its first phase (taxels) and its likelihood.
--
-- > P(d) ~ pi(d) * sum over lambda of
-- >        product over c of (epsilon + sum over k of P(k) exp (l_Ack + l_Bck(d)))
twoFrames :: Grid -> (Taxels, Likelihood) -> (Taxels, Likelihood) -> TwoFrames
twoFrames grid first second =
  TwoFrames
    { twoPhase = snd (maximumBy (comparing fst) [(s, phase) | (s, phase, d) <- scored, d == best]),
      twoDisplacements = [(d, m / total) | (d, m) <- Map.toList masses]
    }
  where
    best = fst (maximumBy (comparing snd) (Map.toList masses))
    total = sum masses
    masses = Map.fromListWith (+) [(d, exp (s - top)) | (s, _, d) <- scored]
    top = maximum [s | (s, _, _) <- scored]
    scored = [scoreOf phase own k s | (phase, own, k, s) <- candidates]
    scoreOf phase@(o, rowColumn) own k s = (s + shared, phase, displacementShift there)
      where
        there = displacementAt grid o rowColumn second k
        shared =
          sum
            [ cellOf (Unboxed.zipWith (+) mine theirs) - alone - cellOf theirs
              | (c, theirs) <- displacementCells there,
                Just (mine, alone) <- [IntMap.lookup c own]
            ]
    candidates =
      [ (phase, own, k, s)
        | (phase, scores) <- byPhase,
          let own = cellsAt phase,
          k <- V.toList (V.findIndices (>= bar) scores),
          let s = scores V.! k
      ]
    cellsAt (o, rowColumn) =
      IntMap.fromList
        [ (c, (l, cellOf l))
          | (c, l) <- displacementCells (displacementAt grid {gridReach = 0} o rowColumn first 0)
        ]
    -- For each likely phase, the scores of the displacements by both frames separately.
    byPhase =
      [ (phase, V.map (+ l) (displacementScores grid o rowColumn second))
        | (phase@(o, rowColumn), l) <- likelyPhases grid first
      ]
    apart = maximum (map (V.maximum . snd) byPhase)
    bar = apart - fewest 15
    fewest :: Double -> Double
    fewest margin
      | margin < 0.5 || count <= mostCandidates = margin
      | otherwise = fewest (0.7 * margin)
      where
        !count = sum [V.length (V.filter (>= apart - margin) scores) | (_, scores) <- byPhase]

-- | The likely phases of the lattice under a frame at its nominal place, with their
-- log-likelihoods, which are at most 15 below the best.
likelyPhases :: Grid -> (Taxels, Likelihood) -> [((Int, (Int, Int)), Double)]
likelyPhases grid (place, given) =
  [ ((o, ((y + ny) `mod` down, (x + nx) `mod` across)), phases V.! i)
    | i <- V.toList (V.findIndices (>= bar) phases),
      let (row, x) = i `quotRem` across
          (o, y) = row `quotRem` down
  ]
  where
    phases = phaseLogs given
    (across, down) = phaseCounts given
    ((nx, ny), _) = onGrid grid place
    bar = V.maximum phases - 15
