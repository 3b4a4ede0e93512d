{-# OPTIONS_HADDOCK hide #-}

-- | The search for likely words: the growing list, and when it is long enough.
module PraTactile.Locate.Decoder.List.Search
  ( -- * What is asked
    Setting (..),

    -- * The list
    State (..),
    noWords,
    explore,
    shareOf,
    positionsOnSheet,
  )
where

import Data.List (maximumBy)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Ord (Down (..), comparing)
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.Locate.Decoder.Algebra (largestListing)
import PraTactile.Locate.Decoder.List.Bounds
import PraTactile.Locate.Decoder.List.Letters
import PraTactile.Locate.Decoder.ObservedCode

-- | The limits of a search.
data Setting = Setting
  { -- | The most words that are searched.
    settingMost :: !Int,
    -- | The tolerated doubt.
    settingTolerated :: !Double,
    -- | Whether the surface is the sheet.
    settingSheet :: !Bool
  }

-- | The list so far. A log-likelihood is that of one position of a word; a word's total likelihood
-- is that times its number of positions.
data State k = State
  { -- | The words, with their log-likelihood and the index of their symmetry.
    stateWords :: !(Map (Down Double, Int, Row k) ()),
    -- | The log-likelihood of the best word; minus infinity without a word.
    stateBest :: !Double,
    -- | A lower bound on the number of positions with that likelihood.
    stateEqual :: !Double,
    -- | An upper bound on the number of positions with that likelihood.
    stateMost :: !Double,
    -- | The total likelihood of the other kept words, relative to the best.
    stateLess :: !Double,
    -- | The total likelihood of words that were searched but not kept, relative to the best.
    stateFaint :: !Double,
    -- | The largest log-likelihood of a word that was not kept; minus infinity without one.
    stateForgotten :: !Double,
    -- | The number of searched words.
    stateCount :: !Int
  }

-- | The empty list.
noWords :: State k
noWords = State Map.empty (-1 / 0) 0 0 0 0 (-1 / 0) 0

-- | Continues the search from the list so far. The branches are the remaining words of each
-- symmetry. Returns the final list and the bounds on what is unlisted; 'Nothing' if everything
-- possible is listed.
explore :: KnownField k => Setting -> [Branch k] -> State k -> (State k, Maybe Bounds)
explore setting branches state = case allBounds [b | (_, _, b) <- unfinished] of
  Nothing -> (state, Nothing)
  Just bounds
    | stateCount state >= settingMost setting || enough setting bounds state -> (state, Just bounds)
    | otherwise -> case maximumBy (comparing (\(_, _, b) -> massBound b)) unfinished of
      (i, branch, _) -> case step branch of
        Just (word, advanced) ->
          explore setting [if j == i then advanced else other | (j, other) <- zip [0 ..] branches]
            $! include setting i branch word state
        Nothing -> (state, Just bounds)
  where
    unfinished =
      [(i, branch, b) | (i, branch) <- zip [0 :: Int ..] branches, Just b <- [branchBounds branch]]

-- | Whether the search can end: the doubt is within the tolerated one, or cannot become so.
enough :: Setting -> Bounds -> State k -> Bool
enough setting bounds state = satisfied || hopeless
  where
    tolerated = settingTolerated setting
    unlisted = exp (massBound bounds - stateBest state) + stateFaint state
    beaten = wordBound bounds < stateBest state
    satisfied =
      stateEqual state > 0
        && ( shareOf (stateMost state - 1 + stateLess state + unlisted) 1 <= tolerated
               || (beaten && shareOf (stateLess state + unlisted) (stateEqual state) <= tolerated)
           )
    -- No further word can be as likely, and the listed ones are too likely already.
    hopeless =
      not (settingSheet setting)
        && beaten
        && shareOf (stateLess state) (stateEqual state) > tolerated

-- | Adds a word to the list. Arguments: the limits; the index of the word's symmetry; its branch;
-- the word; the list.
include :: KnownField k => Setting -> Int -> Branch k -> Row k -> State k -> State k
include setting i branch word state
  | isInfinite x || each == 0 = counted
  -- It is not kept, so it may count twice; the error is small.
  | x < stateBest state - faint =
    counted {stateFaint = stateFaint state + share, stateForgotten = max x (stateForgotten state)}
  | (Down x, i, word) `Map.member` stateWords state = counted
  | x < stateBest state = added {stateLess = stateLess state + share}
  | fewest == 0 = counted
  | x == stateBest state =
    added {stateEqual = stateEqual state + fewest, stateMost = stateMost state + each}
  | otherwise =
    added
      { stateBest = x,
        stateEqual = fewest,
        stateMost = each,
        stateLess = (stateMost state + stateLess state) * scale,
        stateFaint = stateFaint state * scale
      }
  where
    x = logLikelihood (branchLetters branch) word
    share = each * exp (x - stateBest state)
    scale = exp (stateBest state - x)
    each = if Primitive.all (== zero) word then branchEach branch - 1 else branchEach branch
    fewest = if settingSheet setting then positionsOnSheet (branchCode branch) word else each
    counted = state {stateCount = stateCount state + 1}
    added = counted {stateWords = Map.insert (Down x, i, word) () (stateWords state)}

-- | The number of positions of a word on the sheet, by looking them up. If there are more than
-- 'largestListing' to look up: 1 if any is on the sheet, else 0.
positionsOnSheet :: KnownField k => ObservedCode k -> Row k -> Double
positionsOnSheet code word
  | wordVisits code solutions > largestListing = count (take 1 places)
  | otherwise = count places
  where
    solutions = wordSolutions code word
    places = wordPlaces code word solutions
    count = fromIntegral . length

-- | 46: words with a likelihood below about 1e-20 of the best are not kept.
faint :: Double
faint = 46

-- | a / (a + b), which grows with a.
shareOf :: Double -> Double -> Double
shareOf a b = if isInfinite a then 1 else a / (a + b)
