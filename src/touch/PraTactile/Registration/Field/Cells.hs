{-# OPTIONS_HADDOCK hide #-}

-- | The mean field of "PraTactile.Registration.Model" over the cells of a lattice, and its bound.
-- Each frame's displacement follows from the frame itself and from the symbols that others show.
-- The field starts from each frame alone, and each sweep updates all frames.
--
-- Frames have errors in common, and each is an outlier in a cell with probability delta. The bound
-- F, which is at most log P of what the frames show, therefore counts only a share of the
-- log-likelihoods, 'cellShare'. Otherwise a sliver of a symbol that is felt a little otherwise than
-- modelled would count as much as a symbol. With <.> the mean over q_f, and h_fc0 = 0:
--
-- > h_fck(d) = share * l_fck(d)
-- > h_fc(d)  = log (epsilon + sum over k of P(k) exp h_fck(d))
-- > g_fck(d) = log ((1 - delta) exp h_fck(d) + delta exp h_fc(d))
-- > F = sum over c of log (epsilon exp (sum over f of <g_fc0>)
-- >                        + sum over k of P(k) exp (sum over f of <g_fck>))
-- >     + log (sum over sigma of exp (sum over f of <log pi_sigma(d_f)>))
-- >     - sum over f, d of q_f(d) log q_f(d)
--
-- These g also give the posterior of a cell's class, from which recognition starts:
--
-- > P(k in c) ~ P(k) exp (sum over f of <g_fck>)
module PraTactile.Registration.Field.Cells
  ( MeanField (..),
    meanField,
    fieldBound,
    fieldSquares,
    Told,
    fieldTold,
    toldAt,
    cellsBound,
    cellsTold,
    cellsAlone,
    cellOf,
  )
where

import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Probability (logSum)
import PraTactile.Registration.Field
import PraTactile.Registration.Joint.Displacement
  ( ClassLogs,
    Displacement (..),
    cellRowColumn,
    displacementCells,
  )
import PraTactile.Registration.Model (cellLog, classPrior)
import PraTactile.Registration.Numbers (absence, cellShare, heardOfCells, mostSweeps, outlier)

-- | The posterior of the displacements of all frames.
newtype MeanField = MeanField
  { -- | q_f of each frame, over its displacements.
    fieldFrames :: [[(Displacement, Double)]]
  }

-- | Finds the mean field, given the grid and each frame's displacements. It starts from each frame
-- alone; each sweep updates all frames.
meanField :: Grid -> [[Displacement]] -> MeanField
meanField grid frames = MeanField (settled mostSweeps (map likeliest) sweep alone)
  where
    alone =
      [ normalised
          [(d, prior d + sum (map (cellOf . snd) (displacementCells d))) | d <- ds]
        | let prior = robotLog mempty,
          ds <- frames
      ]
    robotLog others = displacementLog grid others . displacementSquare
    sweep now = zipWith (frame (together heard now)) (allButOne (map squaresOf now)) now
    frame byAll others ds =
      normalised
        [ ( d,
            prior d
              + sum
                [ maybe cellOf (cellGiven . less (IntMap.lookup c own)) (IntMap.lookup c byAll) l
                  | (c, l) <- displacementCells d
                ]
          )
          | (d, _) <- ds
        ]
      where
        prior = robotLog others
        own = heard ds
    less mine total = maybe total (Unboxed.zipWith (-) total) mine
    likeliest ds = fmap (displacementShift . fst) (foldl' larger Nothing ds)
    larger Nothing d = Just d
    larger (Just a) b = Just (if snd b > snd a then b else a)
    heard = expected heardOfCells id

-- | F, a lower bound of log P of what the frames show, up to a constant that does not depend on
-- their places. It needs each frame's contribution to its cells.
fieldBound :: Grid -> MeanField -> [Told] -> Double
fieldBound grid field@(MeanField frames) told =
  cellsBound told
    + logSum (sigmaLogs grid (fieldSquares field))
    - sum [p * log p | ds <- frames, (_, p) <- ds, p > 0]

-- | The contribution of one frame to each cell that it sees: \<g_fck> of an empty cell, and then of
-- the classes, by the cell's number.
type Told = IntMap ClassLogs

-- | The contribution of each frame to its cells.
fieldTold :: MeanField -> [Told]
fieldTold = map (expected 0 orAstray) . fieldFrames

-- | The contribution of a frame if it is at the given displacement, from all its displacements.
toldAt :: (Int, Int) -> [(Displacement, Double)] -> Told
toldAt shift ds =
  expected 0 orAstray [(d, 1) | (d, _) <- ds, displacementShift d == shift]

-- | The cells' part of F, from the contributions of all frames.
cellsBound :: [Told] -> Double
cellsBound = sum . map cell . IntMap.elems . together id
  where
    cell g = cellOf (Unboxed.map (subtract nothing) (Unboxed.drop 1 g)) + nothing
      where
        nothing = g Unboxed.! 0

-- | For each cell, by row and column, the log-likelihood ratio of each class to an empty cell, from
-- the contributions of all frames.
cellsTold :: [Told] -> Map (Int, Int) ClassLogs
cellsTold told =
  Map.fromDistinctAscList
    [ (cellRowColumn c, Unboxed.map (subtract (g Unboxed.! 0)) (Unboxed.drop 1 g))
      | (c, g) <- IntMap.toAscList (together id told)
    ]

-- | g_fck of an empty cell, and then of the classes, from l_fck.
orAstray :: ClassLogs -> ClassLogs
orAstray logs = Unboxed.map mixed (Unboxed.cons 0 l)
  where
    l = Unboxed.map (cellShare *) logs
    own = cellOf l
    mixed x = logSum [log (1 - outlier) + x, log outlier + own]

-- | The sum of h_fc over the cells that one frame sees at a phase.
cellsAlone :: [ClassLogs] -> Double
cellsAlone = sum . map (cellOf . Unboxed.map (cellShare *))

-- | The statistics of sigma from the displacements of one frame.
squaresOf :: [(Displacement, Double)] -> Squares
squaresOf ds = Squares 1 (sum [p * displacementSquare d | (d, p) <- ds])

-- | The statistics of sigma from the displacements of all frames.
fieldSquares :: MeanField -> Squares
fieldSquares = foldMap squaresOf . fieldFrames

-- | For each element, the combination of all others (leave-one-out).
allButOne :: Monoid m => [m] -> [m]
allButOne ms = zipWith (<>) (scanl (<>) mempty ms) (drop 1 (scanr (<>) mempty ms))

-- | The expected log-likelihoods of the cells that a frame sees, over its displacements of more
-- than the given probability. The function is applied to a cell's log-likelihoods first.
expected :: Double -> (ClassLogs -> ClassLogs) -> [(Displacement, Double)] -> IntMap ClassLogs
expected least of' ds =
  IntMap.fromListWith
    (Unboxed.zipWith (+))
    [(c, Unboxed.map (* p) (of' l)) | (d, p) <- ds, p > least, (c, l) <- displacementCells d]

-- | The sum of all frames' log-likelihoods in each cell.
together :: (frame -> IntMap ClassLogs) -> [frame] -> IntMap ClassLogs
together told = foldl' (\m -> IntMap.unionWith (Unboxed.zipWith (+)) m . told) IntMap.empty

-- | The log-likelihood ratio of a cell, classes summed, to an empty one.
cellOf :: ClassLogs -> Double
cellOf l = cellLog (Unboxed.length l) (l Unboxed.!)

-- | The log-likelihood ratio of a cell to an empty one by one frame, given first the sum of the
-- others' log-likelihoods.
cellGiven :: ClassLogs -> ClassLogs -> Double
cellGiven others mine =
  top
    + log
      ( empty * exp (negate top)
          + Unboxed.sum (Unboxed.zipWith (\m l -> m * exp (l - top)) classes mine)
      )
  where
    top = max 0 (Unboxed.maximum mine)
    share = classPrior (Unboxed.length mine)
    -- m', from m.
    empty = astray absence (absence * exp (negate most) / total)
    classes = Unboxed.map (astray share . (/ total)) likely
    astray prior m = (1 - outlier) * m + outlier * prior
    most = max 0 (Unboxed.maximum others)
    likely = Unboxed.map (\l -> share * exp (l - most)) others
    total = absence * exp (negate most) + Unboxed.sum likely
