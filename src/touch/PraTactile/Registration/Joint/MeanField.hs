-- | What each frame's displacement is, by itself and by what all others say of the symbols.
module PraTactile.Registration.Joint.MeanField
  ( meanField,
  )
where

import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Registration.Joint.Displacement
  ( ClassLogs,
    Displacement (..),
    displacementCells,
  )
import PraTactile.Registration.Joint.Grid
import PraTactile.Registration.Model (absence, classPrior, outlier)

-- | q of each frame over its displacements, and that of the grid's sigmas: begun from each frame
-- alone, all frames anew in each sweep, until none changes its likeliest displacement or five
-- sweeps are done.
meanField :: Grid -> [[Displacement]] -> ([[(Displacement, Double)]], [Double])
meanField grid frames = (found, sigmaShares grid (foldMap squaresOf found))
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
        own = expected ds
    less total (Just mine) = Unboxed.zipWith (-) total mine
    less total Nothing = total
    likeliest ds = fmap (displacementShift . fst) (foldl' larger Nothing ds)
    larger Nothing d = Just d
    larger (Just a) b = Just (if snd b > snd a then b else a)
    expectedOf :: [[(Displacement, Double)]] -> IntMap ClassLogs
    expectedOf = foldl' (\m -> IntMap.unionWith (Unboxed.zipWith (+)) m . expected) IntMap.empty

-- | What a frame's displacements tell of sigma.
squaresOf :: [(Displacement, Double)] -> Squares
squaresOf ds = Squares 1 (sum [p * displacementSquare d | (d, p) <- ds])

-- | For each, what all others are together.
allButOne :: Monoid m => [m] -> [m]
allButOne ms = zipWith (<>) (scanl (<>) mempty ms) (drop 1 (scanr (<>) mempty ms))

-- | The most sweeps over all frames.
mostSweeps :: Int
mostSweeps = 5

-- | The log likelihoods of the cells' classes that are expected of a frame, over its displacements;
-- those that are not likely by a fiftieth say nothing.
expected :: [(Displacement, Double)] -> IntMap ClassLogs
expected ds =
  IntMap.fromListWith
    (Unboxed.zipWith (+))
    [(c, Unboxed.map (* p) l) | (d, p) <- ds, p > 0.02, (c, l) <- displacementCells d]

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
