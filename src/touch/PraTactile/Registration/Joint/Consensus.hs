-- | What each frame's displacement is, by itself and by what all others say of the symbols.
module PraTactile.Registration.Joint.Consensus
  ( swept,
  )
where

import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl')
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Registration.Joint.Option (Classes, Option (..))
import PraTactile.Registration.Model (absence, classPrior, outlier)

-- | For each frame its options with their probabilities, once every frame has been weighed with
-- what all others say of the symbols, until none changes its mind.
swept :: [[Option]] -> [[(Option, Double)]]
swept frames = go (4 :: Int) first (beliefs first)
  where
    first =
      [ weighed
          (map (\o -> (o, optionPrior o + sum (map (marginal Nothing . snd) (optionCells o)))) os)
        | os <- frames
      ]
    go n now known
      | n <= 0 || unchanged = new
      | otherwise = go (n - 1) new (beliefs new)
      where
        new = [anew os known (said os) | os <- now]
        unchanged = map leader now == map leader new
    anew os known own =
      weighed
        [ ( o,
            optionPrior o
              + sum
                [ marginal (fmap (`less` IntMap.lookup c own) (IntMap.lookup c known)) l
                  | (c, l) <- optionCells o
                ]
          )
          | (o, _) <- os
        ]
    less total (Just mine) = Unboxed.zipWith (-) total mine
    less total Nothing = total
    leader os = fmap (optionShift . fst) (foldl' larger Nothing os)
    larger Nothing o = Just o
    larger (Just a) b = Just (if snd b > snd a then b else a)
    beliefs :: [[(Option, Double)]] -> IntMap Classes
    beliefs = foldl' (\m os -> IntMap.unionWith (Unboxed.zipWith (+)) m (said os)) IntMap.empty

-- | What a frame says of the cells, in the mean over its options; nothing where it is not sure
-- where it is.
said :: [(Option, Double)] -> IntMap Classes
said os =
  IntMap.fromListWith
    (Unboxed.zipWith (+))
    [(c, Unboxed.map (* p) l) | (o, p) <- os, p > 0.02, (c, l) <- optionCells o]

-- | How much likelier a cell is than nothing there: by what one frame says of its classes, and
-- where there is any by what the others say.
marginal :: Maybe Classes -> Classes -> Double
marginal others mine = logMean (maybe prior known others)
  where
    n = Unboxed.length mine
    share = classPrior n
    prior = (absence, Unboxed.replicate n share)
    known theirs =
      let top = max 0 (Unboxed.maximum theirs)
          likely = Unboxed.map (\l -> share * exp (l - top)) theirs
          nothing = absence * exp (negate top)
          total = nothing + Unboxed.sum likely
       in (besides absence (nothing / total), Unboxed.map (besides share . (/ total)) likely)
    besides alone told = (1 - outlier) * told + outlier * alone
    logMean (nothing, shares) =
      let top = max 0 (Unboxed.maximum mine)
       in top
            + log
              ( nothing * exp (negate top)
                  + Unboxed.sum (Unboxed.zipWith (\s l -> s * exp (l - top)) shares mine)
              )

weighed :: [(Option, Double)] -> [(Option, Double)]
weighed scored = [(o, exp (s - top) / total) | (o, s) <- scored]
  where
    top = maximum (map snd scored)
    total = sum [exp (s - top) | (_, s) <- scored]
