{-# OPTIONS_HADDOCK hide #-}

-- | Priors of candidates, and silent cells: cells that, if a candidate is right, do not show the
-- array.
--
-- Let b be the probabilities of a cell. A cell that holds the array's symbol a contributes b(a). A
-- silent cell shows none of the symbols and contributes s(b), 'silentChance'. So the posterior odds
-- of a candidate are multiplied by
--
-- > prior * product over silent cells of s(b) / b(a)
module PraTactile.Locate.Prior
  ( CandidatePrior (..),
    uniformPrior,
    priorWeight,
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

-- | The prior of a candidate, and the cells that are silent if it is right.
data CandidatePrior = CandidatePrior
  { -- | The natural logarithm of its prior relative to that of the favoured candidates, which have
    -- 0. It is not checked to be at most 0.
    candidateLogPrior :: !Double,
    -- | The offsets, as seen, of the silent cells.
    candidateSilent :: [Position]
  }
  deriving stock (Eq, Show)

-- | A uniform prior, and no silent cell.
uniformPrior :: CandidatePrior
uniformPrior = CandidatePrior 0 []

-- | The logarithm of the factor by which prior and silent cells change a candidate's probability.
-- Arguments: the array's symbol at an offset as seen if the candidate is right, 'Nothing' beyond a
-- sheet, where a silent cell changes nothing; the patch as seen; the candidate; its prior and
-- silent cells.
priorWeight ::
  (Position -> Maybe (GF k)) -> Patch (Belief k) -> Candidate -> CandidatePrior -> Double
priorWeight symbolIn seen candidate known =
  candidateLogPrior known
    + sum
      [ log (silentChance b / probabilitiesIn (candidateSymmetry candidate) b Primitive.! toCode a)
        | (offset, b) <- observedCells seen,
          offset `elem` candidateSilent known,
          Just a <- [symbolIn offset]
      ]

-- | Multiplies candidates' probabilities by exp of a weight and renormalises. Only the 'weighable'
-- candidates are weighted; all others, and unlisted places, count with weight 0. An unlisted place
-- might gain by its silent cells, so if places are unlisted the new doubt is no upper bound. A
-- posterior whose equally probable places are too many to list is returned unchanged.
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
    -- The probability of all that was not weighted, computed without the rounding of 1 less the
    -- others.
    rest = max 0 (posteriorDoubt found - sum (map snd (drop 1 weighed')))

-- | Splits a ranking into the candidates that are weighted and the rest: at most the first
-- thousand, with at least 1e-60 of the best one's probability.
weighable :: [(place, Double)] -> ([(place, Double)], [(place, Double)])
weighable ranking = (likely, drop (length likely) ranking)
  where
    likely = take 1000 (takeWhile ((>= 1e-60 * best) . snd) ranking)
    best = maximum (0 : map snd (take 1 ranking))
