{-# OPTIONS_HADDOCK hide #-}

-- | What each frame's displacement is, by itself and by what all others say of the symbols: the
-- mean field of "PraTactile.Registration.Model" over cells, and its bound. It begins from each
-- frame alone; all frames are found anew in each sweep.
--
-- What frames tell of a cell has errors in common, and each frame shows with probability delta
-- something of its own. So the bound F, which log P of what frames show is at least, counts a share
-- of the log-likelihoods, 'cellShare'. Otherwise a sliver of a symbol that is felt a little
-- otherwise than supposed would count as much as a symbol. With <.> the mean over q_f, and h_fc0 =
-- 0:
--
-- > h_fck(d) = share * l_fck(d)
-- > h_fc(d)  = log (epsilon + sum over k of P(k) exp h_fck(d))
-- > g_fck(d) = log ((1 - delta) exp h_fck(d) + delta exp h_fc(d))
-- > F = sum over c of log (epsilon exp (sum over f of <g_fc0>)
-- >                        + sum over k of P(k) exp (sum over f of <g_fck>))
-- >     + log (sum over sigma of exp (sum over f of <log pi_sigma(d_f)>))
-- >     - sum over f, d of q_f(d) log q_f(d)
--
-- By the same g a cell's class is told, from which recognition makes its answer:
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
import PraTactile.Registration.Field
import PraTactile.Registration.Joint.Displacement
  ( ClassLogs,
    Displacement (..),
    cellRowColumn,
    displacementCells,
  )
import PraTactile.Registration.Model (cellLog, classPrior, logSum)
import PraTactile.Registration.Numbers (absence, cellShare, heardOfCells, mostSweeps, outlier)

-- | The posterior of the displacements of all frames.
newtype MeanField = MeanField
  { -- | q_f of each frame, over its displacements.
    fieldFrames :: [[(Displacement, Double)]]
  }

-- | Begun from each frame alone; each sweep finds all frames anew.
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

-- | F, which log P of what the frames show is at least, up to what does not depend on their places;
-- by what each tells of its cells.
fieldBound :: Grid -> MeanField -> [Told] -> Double
fieldBound grid field@(MeanField frames) told =
  cellsBound told
    + logSum (sigmaLogs grid (fieldSquares field))
    - sum [p * log p | ds <- frames, (_, p) <- ds, p > 0]

-- | What one frame tells of each cell that it sees: \<g_fck> of an empty cell, and then of the
-- classes; by the cell's number.
type Told = IntMap ClassLogs

-- | What each frame tells of its cells.
fieldTold :: MeanField -> [Told]
fieldTold = map (expected 0 orAstray) . fieldFrames

-- | What a frame of these displacements tells, if it is at the one with this shift.
toldAt :: (Int, Int) -> [(Displacement, Double)] -> Told
toldAt shift ds =
  expected 0 orAstray [(d, 1) | (d, _) <- ds, displacementShift d == shift]

-- | The part of F that is of the cells: how likely they are together, by what frames tell of them.
cellsBound :: [Told] -> Double
cellsBound = sum . map cell . IntMap.elems . together id
  where
    cell g = cellOf (Unboxed.map (subtract nothing) (Unboxed.drop 1 g)) + nothing
      where
        nothing = g Unboxed.! 0

-- | For each cell, by its row and column, the log-likelihood ratio of each class to an empty cell,
-- by what frames tell of it.
cellsTold :: [Told] -> Map (Int, Int) ClassLogs
cellsTold told =
  Map.fromDistinctAscList
    [ (cellRowColumn c, Unboxed.map (subtract (g Unboxed.! 0)) (Unboxed.drop 1 g))
      | (c, g) <- IntMap.toAscList (together id told)
    ]

-- | g_fck of an empty cell, and then of the classes.
orAstray :: ClassLogs -> ClassLogs
orAstray logs = Unboxed.map mixed (Unboxed.cons 0 l)
  where
    l = Unboxed.map (cellShare *) logs
    own = cellOf l
    mixed x = logSum [log (1 - outlier) + x, log outlier + own]

-- | The sum of h_fc over the cells that one frame sees at a phase.
cellsAlone :: [ClassLogs] -> Double
cellsAlone = sum . map (cellOf . Unboxed.map (cellShare *))

-- | What a frame's displacements tell of sigma.
squaresOf :: [(Displacement, Double)] -> Squares
squaresOf ds = Squares 1 (sum [p * displacementSquare d | (d, p) <- ds])

-- | What all displacements tell of sigma.
fieldSquares :: MeanField -> Squares
fieldSquares = foldMap squaresOf . fieldFrames

-- | For each, what all others are together.
allButOne :: Monoid m => [m] -> [m]
allButOne ms = zipWith (<>) (scanl (<>) mempty ms) (drop 1 (scanr (<>) mempty ms))

-- | What is expected of the cells that a frame sees, over its displacements of more than that
-- probability, given what each makes of the log likelihoods of a cell's classes.
expected :: Double -> (ClassLogs -> ClassLogs) -> [(Displacement, Double)] -> IntMap ClassLogs
expected least of' ds =
  IntMap.fromListWith
    (Unboxed.zipWith (+))
    [(c, Unboxed.map (* p) (of' l)) | (d, p) <- ds, p > least, (c, l) <- displacementCells d]

-- | What all frames say of each cell.
together :: (frame -> IntMap ClassLogs) -> [frame] -> IntMap ClassLogs
together told = foldl' (\m -> IntMap.unionWith (Unboxed.zipWith (+)) m . told) IntMap.empty

-- | The log-likelihood ratio of a cell, its classes summed, to an empty one.
cellOf :: ClassLogs -> Double
cellOf l = cellLog (Unboxed.length l) (l Unboxed.!)

-- | The log-likelihood ratio of a cell to an empty one by one frame, given what the others say.
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
