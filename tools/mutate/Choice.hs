-- | Which mutants are tried, and how: the options of @make mutate@.
module Choice
  ( Choice (..),
    chooseFrom,
    usage,
    sample,
  )
where

import Data.Bits (xor)
import Data.Char (ord)
import Data.List (foldl', isPrefixOf, sortOn)
import qualified Data.Map.Strict as Map
import Site
import System.Random (mkStdGen, random)
import Text.Read (readMaybe)

-- | What is hunted, and how.
data Choice = Choice
  { choiceCount :: Int,
    choiceSeed :: Int,
    -- | The modules whose names begin with one of these; all, if there are none.
    choiceOnly :: [String],
    -- | All mutants of the modules whose names begin with one of these are tried, too.
    choiceWhole :: [String],
    -- | The part of the sample that is tried here, from 1, and how many parts there are.
    choiceShard :: (Int, Int),
    choiceJobs :: Int,
    -- | Seconds of processor time that may be spent on a mutant by examples that take long.
    choiceSeconds :: Double,
    -- | Whether only groups of examples run that do not take long.
    choiceQuick :: Bool
  }

usage :: String
usage =
  "[--count N] [--seed N] [--only MODULE] [--whole MODULE] [--shard I/N] [--jobs N] [--seconds N] \
  \[--quick]"

-- | The options in words; without them 600 mutants of seed 1, two at a time, 60 seconds each.
chooseFrom :: [String] -> Maybe Choice
chooseFrom = go (Choice 600 1 [] [] (1, 1) 2 60 False)
  where
    go choice options = case options of
      [] -> Just choice
      "--count" : n : more -> readMaybe n >>= \i -> go choice {choiceCount = i} more
      "--seed" : n : more -> readMaybe n >>= \i -> go choice {choiceSeed = i} more
      "--jobs" : n : more -> readMaybe n >>= \i -> go choice {choiceJobs = i} more
      "--seconds" : n : more -> readMaybe n >>= \i -> go choice {choiceSeconds = i} more
      "--only" : name : more -> go choice {choiceOnly = name : choiceOnly choice} more
      "--whole" : name : more -> go choice {choiceWhole = name : choiceWhole choice} more
      "--quick" : more -> go choice {choiceQuick = True} more
      "--shard" : text : more -> case break (== '/') text of
        (i, '/' : n) -> do
          shard <- (,) <$> readMaybe i <*> readMaybe n
          go choice {choiceShard = shard} more
        _ -> Nothing
      _ -> Nothing

-- | Mutants of these sites in an order drawn from the seed, of each module three at least where it
-- has as many; those come first. The order is that of numbers drawn from the mutants' names, so
-- that other sources have the same sample but for what is new in them or gone. After the sample
-- stand the other mutants of those modules that are tried as a whole.
sample :: Choice -> [Site] -> [Mutant]
sample choice sites =
  drawn ++ [one {mutantDrawn = False} | one <- rest, among (choiceWhole choice) (moduleOf one)]
  where
    (drawn, rest) = splitAt (max (choiceCount choice) (length first)) (first ++ others)
    moduleOf = siteModule . mutantSite
    possible = filter (asked . siteModule) sites
    asked name = null (choiceOnly choice) || among (choiceOnly choice) name
    among names name = any (`isPrefixOf` name) names
    shuffled = map snd (sortOn fst [(number one, one) | one <- concatMap mutantsOf possible])
    number one = (fst (random (mkStdGen (digest (mutantName one)))) :: Int, mutantName one)
    digest = foldl' (\hash c -> (hash * 16777619) `xor` ord c) (choiceSeed choice)
    (first, others) = go (Map.empty :: Map.Map String Int) shuffled
    go seen mutants = case mutants of
      [] -> ([], [])
      one : more ->
        let early = Map.findWithDefault 0 (moduleOf one) seen < 3
            (a, b) = go (Map.insertWith (+) (moduleOf one) 1 seen) more
         in if early then (one : a, b) else (a, one : b)
