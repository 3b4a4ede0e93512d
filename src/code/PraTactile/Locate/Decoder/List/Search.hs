{-# OPTIONS_HADDOCK hide #-}

-- | The search for likely words: the list as it grows, and when it is long enough.
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

-- | What is the same for all words.
data Setting = Setting
  { -- | How many words are looked at, at most.
    settingMost :: !Int,
    -- | The doubt that is tolerated.
    settingTolerated :: !Double,
    -- | Whether the surface is the sheet.
    settingSheet :: !Bool
  }

-- | The list so far.
data State k = State
  { -- | By the logarithm of the likelihood, and the index of the symmetry.
    stateWords :: !(Map (Down Double, Int, Row k) ()),
    -- | That of the best; minus infinity while there is none.
    stateBest :: !Double,
    -- | How many positions have it, at least.
    stateEqual :: !Double,
    -- | And at most.
    stateMost :: !Double,
    -- | The likelihoods of the others that are kept, relative to it.
    stateLess :: !Double,
    -- | Those of the ones that were looked at and not kept.
    stateFaint :: !Double,
    -- | The logarithm of the largest of these; minus infinity if there are none.
    stateForgotten :: !Double,
    -- | How many words were looked at.
    stateCount :: !Int
  }

-- | The empty list.
noWords :: State k
noWords = State Map.empty (-1 / 0) 0 0 0 0 (-1 / 0) 0

-- | Go on from the list so far; the end, and what is not listed of it.
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

-- | Whether the doubt is at most as large as tolerated, or cannot become so.
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
    -- No word to come can be as likely, and those that are listed are too likely already.
    hopeless =
      not (settingSheet setting)
        && beaten
        && shareOf (stateLess state) (stateEqual state) > tolerated

-- | The list with one word more, of the symmetry of this index.
include :: KnownField k => Setting -> Int -> Branch k -> Row k -> State k -> State k
include setting i branch word state
  | isInfinite x || each == 0 = counted
  -- Not kept, so that it may count twice, which is little.
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

-- | At how many positions of the sheet a word is, which has to be looked up; of very many whether
-- it is at any.
positionsOnSheet :: KnownField k => ObservedCode k -> Row k -> Double
positionsOnSheet code word
  | wordVisits code solutions > largestListing = count (take 1 places)
  | otherwise = count places
  where
    solutions = wordSolutions code word
    places = wordPlaces code word solutions
    count = fromIntegral . length

-- | 46: words are not kept whose likelihood is less than about 1e-20 of that of the best.
faint :: Double
faint = 46

-- | a / (a + b), which grows with a.
shareOf :: Double -> Double -> Double
shareOf a b = if isInfinite a then 1 else a / (a + b)
