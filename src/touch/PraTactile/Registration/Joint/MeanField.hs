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
import PraTactile.Registration.Model (absence, classPrior, outlier)

-- | q of each frame over its displacements: begun from each frame alone, all frames anew in each
-- sweep, until none changes its likeliest displacement or five sweeps are done.
meanField :: [[Displacement]] -> [[(Displacement, Double)]]
meanField frames = go mostSweeps alone (expectedOf alone)
  where
    alone =
      [ normalised [(d, displacementPrior d + sum (map byItself (displacementCells d))) | d <- ds]
        | ds <- frames
      ]
    byItself (_, l) = cellGiven Nothing l
    go n now expectedByAll
      | n <= 1 || map likeliest now == map likeliest new = new
      | otherwise = go (n - 1) new (expectedOf new)
      where
        new = [sweep ds expectedByAll (expected ds) | ds <- now]
    sweep ds expectedByAll own =
      normalised
        [ ( d,
            displacementPrior d
              + sum
                [ cellGiven (fmap (`less` IntMap.lookup c own) (IntMap.lookup c expectedByAll)) l
                  | (c, l) <- displacementCells d
                ]
          )
          | (d, _) <- ds
        ]
    less total (Just mine) = Unboxed.zipWith (-) total mine
    less total Nothing = total
    likeliest ds = fmap (displacementShift . fst) (foldl' larger Nothing ds)
    larger Nothing d = Just d
    larger (Just a) b = Just (if snd b > snd a then b else a)
    expectedOf :: [[(Displacement, Double)]] -> IntMap ClassLogs
    expectedOf = foldl' (\m -> IntMap.unionWith (Unboxed.zipWith (+)) m . expected) IntMap.empty

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
