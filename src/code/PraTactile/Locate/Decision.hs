{-# OPTIONS_HADDOCK hide #-}

-- | The decision of a decoder of symbols, in common terms for all decoders, and how decisions in
-- several symmetries are combined.
module PraTactile.Locate.Decision
  ( Decision (..),
    exactDecision,
    nowhereDecision,
    overSymmetries,
  )
where

import Data.List (sort, sortOn)
import Data.Maybe (catMaybes, mapMaybe)
import Numeric.Natural (Natural)
import PraTactile.Locate.Answer
import PraTactile.Position
import PraTactile.Symmetry

-- | The outcome for symbols, and the distances of candidates.
data Decision place = Decision
  { decisionOutcome :: Outcome place,
    decisionDistances :: Distances
  }
  deriving stock (Eq, Show)

-- | The decision of a decoder that corrects nothing: its radius is 0. Arguments: what is known of
-- the minimum distance; the outcome.
exactDecision :: Known -> Outcome place -> Decision place
exactDecision d outcome = Decision outcome (Distances [] agreeing Nothing d 0)
  where
    agreeing = case outcome of
      Refused _ -> Nothing
      _ -> Just (Exactly 0)

-- | The decision for a patch without observed cells, with this radius.
nowhereDecision :: Natural -> Decision place
nowhereDecision = Decision (Refused TooFewCells) . Distances [] Nothing Nothing (Exactly 0)

-- | Combines the decisions in several symmetries. Arguments: the minimum distance between any two
-- candidates; the radius; for each symmetry, the shape of the patch set upright and the decision
-- for it. The outcome names only the nearest candidates, although others may be within the radius.
-- If no symmetry has a place, the reason is the first in this list that any symmetry gives: off the
-- sheet, contradiction, not in array, no complete window, beyond the radius, zero window.
overSymmetries :: Known -> Natural -> [(Symmetry, Shape, Decision Position)] -> Decision Candidate
overSymmetries d radius found = Decision outcome (Distances wrong least next d radius)
  where
    distancesOf (_, _, decision) = decisionDistances decision
    nearestOf = nearestDistance . distancesOf
    ordered = sortOn bound (concatMap (bothOf . distancesOf) found)
    bothOf distances = catMaybes [nearestDistance distances, runnerUpDistance distances]
    least = case ordered of
      e : _ -> Just e
      [] -> Nothing
    -- The second smallest of lower bounds is a lower bound on the second smallest number.
    next = case drop 1 ordered of
      e : _
        | all exact ordered -> Just e
        | otherwise -> Just (AtLeast (atLeast e))
      [] -> Nothing
    -- Of equal numbers the exact one comes first, since it was found.
    bound known = (atLeast known, not (exact known))
    exact known = case known of
      Exactly _ -> True
      AtLeast _ -> False
    nearestOnes = filter ((== least) . nearestOf) found
    outcome = combinedOutcome (if any answered nearestOnes then nearestOnes else found)
    wrong = case (outcome, filter answered nearestOnes) of
      (Unique _ _, [(o, shape, decision)]) ->
        sort (map (onPosition o shape) (corrected (decisionDistances decision)))
      _ -> []
    answered (_, _, decision) = case decisionOutcome decision of
      Refused _ -> False
      _ -> True

-- | The outcome of several symmetries: all their places together, or a common reason. Each symmetry
-- comes with the shape of the upright patch.
combinedOutcome :: [(Symmetry, Shape, Decision Position)] -> Outcome Candidate
combinedOutcome found = case (concatMap listed outcomes, mapMaybe unlisted outcomes) of
  ([], []) -> Refused (farthest [reason | (_, _, Refused reason) <- outcomes])
  ([(place, support)], []) -> Unique place support
  (several, []) -> case outcomes of
    [(o, shape, Ambiguous _ support)] -> Ambiguous (map fst several) (seen o shape support)
    _ -> Ambiguous (map fst several) []
  ([], [(count, dimension)]) -> AmbiguousMany count dimension
  (several, more) -> AmbiguousMany (fromIntegral (length several) + sum (map fst more)) Nothing
  where
    outcomes = [(o, shape, decisionOutcome decision) | (o, shape, decision) <- found]
    seen o shape = sort . map (onPosition o shape)
    listed (o, shape, outcome) = case outcome of
      Unique place support -> [(Candidate o place, seen o shape support)]
      Ambiguous places _ -> [(Candidate o place, []) | place <- places]
      _ -> []
    unlisted (_, _, outcome) = case outcome of
      AmbiguousMany count dimension -> Just (count, dimension)
      _ -> Nothing
    farthest given = case filter (`elem` given) order of
      reason : _ -> reason
      [] -> TooFewCells
    order = [OffSheet, Contradiction, NotInArray, NoCompleteWindow, BeyondRadius, ZeroWindow]
