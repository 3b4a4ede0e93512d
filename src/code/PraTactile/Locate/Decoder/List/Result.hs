{-# OPTIONS_HADDOCK hide #-}

-- | The posterior of candidates from a list of likely words.
module PraTactile.Locate.Decoder.List.Result
  ( summary,
  )
where

import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe, maybeToList)
import Data.Ord (Down (..))
import qualified Data.Vector as Boxed
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.Locate.Answer
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Equations
import PraTactile.Locate.Decoder.List.Bounds
import PraTactile.Locate.Decoder.List.Search
import PraTactile.Locate.Decoder.ObservedCode

-- | Searches the likely words in each symmetry, one 'Branch' for each, and returns the posterior of
-- candidates.
summary :: KnownField k => Setting -> [Branch k] -> Posterior Candidate
summary setting branches
  | stateEqual state == 0 =
    impossible
      { posteriorUnlisted = Just (maybe 0 (const 1) beyond),
        posteriorWords = stateCount state
      }
  | otherwise = fromList setting branches state beyond
  where
    (state, beyond) = explore setting branches noWords

-- | The posterior of candidates from the list of a search and the bounds on what is unlisted;
-- 'Nothing' if everything possible is listed.
fromList ::
  KnownField k => Setting -> [Branch k] -> State k -> Maybe Bounds -> Posterior Candidate
fromList setting branches state beyond =
  Posterior
    { posteriorBest = listToMaybe (equal ++ map fst ranking),
      posteriorDoubt = shareOf (stateMost state - 1 + stateLess state + unlisted) 1,
      posteriorEqual = equal,
      posteriorMany = many,
      posteriorEqualDoubt =
        if maybe True ((< stateBest state) . wordBound) beyond
          then shareOf (stateLess state + unlisted) (stateEqual state)
          else 1,
      posteriorMargin = Just (if stateMost state > 1 then min 0 margin else margin),
      posteriorRanking = ranking,
      posteriorUnlisted =
        Just (shareOf unlisted (if settingSheet setting then stateEqual state else listed)),
      posteriorWords = stateCount state
    }
  where
    listed = stateEqual state + stateLess state
    unlisted = maybe 0 (\b -> exp (massBound b - stateBest state)) beyond + stateFaint state
    total = stateMost state + stateLess state + unlisted
    entries = entriesOf branches state
    (best, lesser) = span (\(x, _, _) -> x == stateBest state) entries
    (equal, many) = bestPlaces setting [(branch, word) | (_, branch, word) <- best]
    next = [x | (x, _, _) <- take 1 lesser] ++ map wordBound (maybeToList beyond)
    margin = stateBest state - maximum (stateForgotten state : next)
    ranking =
      [ (place, exp (x - stateBest state) / total)
        | (x, branch, word) <- entries,
          place <- candidatesOf branch (placesOf (solved (branch, word)))
      ]

-- | The words of the list, the likeliest first, each with its log-likelihood and its symmetry.
entriesOf :: [Branch k] -> State k -> [(Double, Branch k, Row k)]
entriesOf branches state =
  [ (x, branch, word)
    | (Down x, i, word) <- Map.keys (stateWords state),
      Just branch <- [numbered Boxed.!? i]
  ]
  where
    numbered = Boxed.fromList branches

-- | The candidates at these positions in a branch's symmetry.
candidatesOf :: Branch k -> [Position] -> [Candidate]
candidatesOf branch = map (Candidate (branchSymmetry branch))

-- | A word of a branch with its 'wordSolutions'.
solved :: KnownField k => (Branch k, Row k) -> (Branch k, Row k, Solutions k)
solved (branch, word) = (branch, word, wordSolutions (branchCode branch) word)

-- | The positions of a word.
placesOf :: KnownField k => (Branch k, Row k, Solutions k) -> [Position]
placesOf (branch, word, solutions) = wordPlaces (branchCode branch) word solutions

-- | The candidates of the equally best words. If they are too many to list, there are none, but
-- their number, and the dimension of their coset if they belong to one word. If it is not known how
-- many lie on the sheet, there are neither candidates nor a number.
bestPlaces ::
  KnownField k => Setting -> [(Branch k, Row k)] -> ([Candidate], Maybe (Natural, Maybe Natural))
bestPlaces setting best = case words' of
  [only@(branch, _, solutions)] -> case listingOf only of
    Right (Listed places) -> (candidatesOf branch (sort places), Nothing)
    Right More -> ([], Just (solutionCount solutions, Just (solutionFreedom solutions)))
    Left _ -> (few, Nothing)
  _
    | visits > largestListing,
      not (settingSheet setting) || any ((== Right More) . listingOf) words' ->
      ([], Just (sum [solutionCount solutions | (_, _, solutions) <- words'], Nothing))
    | otherwise -> (few, Nothing)
  where
    words' = map solved best
    visits = sum [wordVisits (branchCode branch) solutions | (branch, _, solutions) <- words']
    listingOf (branch, word, solutions) = wordListing (branchCode branch) word solutions
    few
      | visits > largestListing = []
      | otherwise = concat [candidatesOf branch (sort places) | (branch, places) <- bySymmetry]
    -- The words are in the order of symmetries; the positions of one symmetry are sorted together.
    bySymmetry = foldr gather [] [(branch, placesOf word) | word@(branch, _, _) <- words']
    gather (branch, places) gathered = case gathered of
      (other, more) : rest
        | branchSymmetry other == branchSymmetry branch -> (other, places ++ more) : rest
      _ -> (branch, places) : gathered
