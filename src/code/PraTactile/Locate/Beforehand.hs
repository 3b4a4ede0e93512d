{-# OPTIONS_HADDOCK hide #-}

-- | What is known of candidates beside the observed cells: how probable each is beforehand, and
-- which of the cells then show something that is not the array's.
--
-- If b are the probabilities of a cell, the cell that holds the array's symbol a counts as b(a). A
-- cell in which something else lies shows none of the symbols, and counts as 'silentChance' has it,
-- s(b). So a candidate is
--
-- > prior * product over silent cells of s(b) / b(a)
--
-- times as probable as the cells alone make it.
module PraTactile.Locate.Beforehand
  ( Beforehand (..),
    nothingBeforehand,
    beforehandWeight,
    reweighed,
    weighable,
  )
where

import Data.List (sortOn)
import Data.Maybe (isJust)
import Data.Ord (Down (..))
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Patch
import PraTactile.Position

-- | What is known of a candidate.
data Beforehand = Beforehand
  { -- | the logarithm of how probable it is beforehand, at most 0
    beforehandPrior :: !Double,
    -- | the offsets, as they are seen, of the cells that say nothing if it is right
    beforehandSilent :: [Position]
  }
  deriving stock (Eq, Show)

-- | All candidates are equally probable, and all cells speak.
nothingBeforehand :: Beforehand
nothingBeforehand = Beforehand 0 []

-- | The logarithm of how many times as probable a candidate is as the cells alone make it, given
-- the array's symbol in each cell if it is right.
beforehandWeight ::
  (Position -> Maybe (GF k)) -> Patch (Belief k) -> Candidate -> Beforehand -> Double
beforehandWeight symbolIn seen candidate known =
  beforehandPrior known
    + sum
      [ log (silentChance b / probabilitiesIn (candidateSymmetry candidate) b Primitive.! toCode a)
        | (offset, b) <- observedCells seen,
          offset `elem` beforehandSilent known,
          Just a <- [symbolIn offset]
      ]

-- | The posterior where each candidate is so many times as probable, by the logarithm, as it was
-- found to be. The first thousand are weighed that are at least 1e-60 times as probable as the
-- likeliest; all others, and places that are not listed, count as they were found: of a list, the
-- doubt is no bound of that.
reweighed :: (Candidate -> Double) -> Posterior Candidate -> Posterior Candidate
reweighed weightOf found
  | isJust (posteriorMany found) || all (== 0) weights = found
  | otherwise = case order of
    [] -> found
    (best, top) : others ->
      let relative (_, l) = exp (l - top)
          left = rest * exp (negate top)
          (equal, less) = span ((== top) . snd) order
          total = 1 + sum (map relative others) + left
       in found
            { posteriorBest = Just best,
              posteriorDoubt = (sum (map relative others) + left) / total,
              posteriorEqual = map fst equal,
              posteriorEqualDoubt = (sum (map relative less) + left) / total,
              posteriorMargin =
                case [top - l | (_, l) <- take 1 others] ++ [negate (log left) | left > 0] of
                  [] -> posteriorMargin found
                  margins -> Just (minimum margins),
              posteriorRanking =
                [(place, relative it / total) | it@(place, _) <- order]
                  ++ [(place, p * exp (negate top) / total) | (place, p) <- unweighed],
              posteriorUnlisted = (* (exp (negate top) / total)) <$> posteriorUnlisted found
            }
  where
    (weighed', unweighed) = weighable (posteriorRanking found)
    weights = map (weightOf . fst) weighed'
    order = sortOn (Down . snd) [(c, log p + w) | ((c, p), w) <- zip weighed' weights]
    -- The probability of all that was not weighed, without the rounding of 1 less the others.
    rest = max 0 (posteriorDoubt found - sum (map snd (drop 1 weighed')))

-- | The candidates that are weighed, and those that are not.
weighable :: [(place, Double)] -> ([(place, Double)], [(place, Double)])
weighable ranking = (likely, drop (length likely) ranking)
  where
    likely = take 1000 (takeWhile ((>= 1e-60 * best) . snd) ranking)
    best = maximum (0 : map snd (take 1 ranking))
