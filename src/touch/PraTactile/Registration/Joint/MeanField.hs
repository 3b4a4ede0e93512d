{-# OPTIONS_HADDOCK hide #-}

-- | What each frame's displacement is, by itself and by what all others say of the symbols.
module PraTactile.Registration.Joint.MeanField
  ( MeanField (..),
    meanField,
    fieldBound,
    Told,
    fieldTold,
    toldAt,
    cellsBound,
    cellsTold,
    cellsAlone,
  )
where

import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Registration.Joint.Displacement
  ( ClassLogs,
    Displacement (..),
    cellRowColumn,
    displacementCells,
  )
import PraTactile.Registration.Joint.Grid
import PraTactile.Registration.Model
  ( absence,
    cellLog,
    cellShare,
    classPrior,
    outlier,
  )

-- | What is found of the displacements of all frames, and of sigma.
data MeanField = MeanField
  { -- | q_f of each frame, over its displacements.
    fieldFrames :: [[(Displacement, Double)]],
    -- | q of the grid's sigmas.
    fieldSigmas :: [Double]
  }

-- | Begun from each frame alone, all frames anew in each sweep, until none changes its likeliest
-- displacement or five sweeps are done.
meanField :: Grid -> [[Displacement]] -> MeanField
meanField grid frames = MeanField found (sigmaShares grid (foldMap squaresOf found))
  where
    found = go mostSweeps alone (expectedOf alone)
    alone =
      [ normalised
          [ (d, robotLog mempty d + sum (map byItself (displacementCells d)))
            | d <- ds
          ]
        | ds <- frames
      ]
    robotLog others = displacementLog grid others . displacementSquare
    byItself (_, l) = cellGiven Nothing l
    go n now expectedByAll
      | n <= 1 || map likeliest now == map likeliest new = new
      | otherwise = go (n - 1) new (expectedOf new)
      where
        new = zipWith (sweep expectedByAll) (allButOne (map squaresOf now)) now
    sweep expectedByAll others ds =
      normalised
        [ ( d,
            robotLog others d
              + sum
                [ cellGiven (fmap (`less` IntMap.lookup c own) (IntMap.lookup c expectedByAll)) l
                  | (c, l) <- displacementCells d
                ]
          )
          | (d, _) <- ds
        ]
      where
        own = heard ds
    less total (Just mine) = Unboxed.zipWith (-) total mine
    less total Nothing = total
    likeliest ds = fmap (displacementShift . fst) (foldl' larger Nothing ds)
    larger Nothing d = Just d
    larger (Just a) b = Just (if snd b > snd a then b else a)
    expectedOf = together heard
    heard = expected 0.02 id

-- | F, which log P of what the frames show is at least, up to what does not depend on their places;
-- by what each tells of its cells.
fieldBound :: Grid -> MeanField -> [Told] -> Double
fieldBound grid (MeanField frames _) told =
  cellsBound told
    + logSum (sigmaLogs grid (foldMap squaresOf frames))
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
    cell g = cellLog (Unboxed.length g - 1) (\k -> g Unboxed.! (k + 1) - nothing) + nothing
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
    own = cellGiven Nothing l
    mixed x = logSum [log (1 - outlier) + x, log outlier + own]

-- | The sum of h_fc over the cells that one frame sees at a phase.
cellsAlone :: [ClassLogs] -> Double
cellsAlone = sum . map (cellGiven Nothing . Unboxed.map (cellShare *))

-- | What a frame's displacements tell of sigma.
squaresOf :: [(Displacement, Double)] -> Squares
squaresOf ds = Squares 1 (sum [p * displacementSquare d | (d, p) <- ds])

-- | For each, what all others are together.
allButOne :: Monoid m => [m] -> [m]
allButOne ms = zipWith (<>) (scanl (<>) mempty ms) (drop 1 (scanr (<>) mempty ms))

-- | The most sweeps over all frames.
mostSweeps :: Int
mostSweeps = 5

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

-- | How much likelier a cell is than nothing there: by what one frame says of its classes, and
-- where there is any by what the others say.
cellGiven :: Maybe ClassLogs -> ClassLogs -> Double
cellGiven others mine = logMean (maybe prior known others)
  where
    n = Unboxed.length mine
    share = classPrior n
    prior = (absence, Unboxed.replicate n share)
    known theirs =
      let top = max 0 (Unboxed.maximum theirs)
          likely = Unboxed.map (\l -> share * exp (l - top)) theirs
          nothing = absence * exp (negate top)
          total = nothing + Unboxed.sum likely
       in (mixed absence (nothing / total), Unboxed.map (mixed share . (/ total)) likely)
    mixed without given = (1 - outlier) * given + outlier * without
    logMean (nothing, shares) =
      let top = max 0 (Unboxed.maximum mine)
       in top
            + log
              ( nothing * exp (negate top)
                  + Unboxed.sum (Unboxed.zipWith (\s l -> s * exp (l - top)) shares mine)
              )

-- | Probabilities from logarithms of what they are proportional to.
normalised :: [(Displacement, Double)] -> [(Displacement, Double)]
normalised scored = [(o, exp (s - top) / total) | (o, s) <- scored]
  where
    top = maximum (map snd scored)
    total = sum [exp (s - top) | (_, s) <- scored]
