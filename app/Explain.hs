-- | Why an answer is what it is, in sentences: the cells used, their equations, the distance to the next candidate.
module Explain
  ( explainCells
  , explainDecision
  , explainOriented
  , explainDecoding
  , explainPosterior
  , explainListing
  , explainOutcome
  , explainChance
  ) where

import Data.List (intercalate)
import Text.Printf (printf)

import Message.Chance (shareText)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.BoundedDistance
import PraTactile.Locate.Chance (Chance (..))
import PraTactile.Locate.Equations
import PraTactile.Locate.Nearest
import PraTactile.Locate.OrderedStatistics
import PraTactile.Locate.Oriented
import PraTactile.Locate.Soft
import PraTactile.Polynomial (primitiveDegree)
import PraTactile.Window

-- | The observed cells as equations for alpha^t, t being the index of the patch's upper left cell in the sequence, and what they leave open.
explainCells :: KnownField k => PseudorandomArray k -> Mask -> [(Position, GF k)] -> [String]
explainCells array mask cells = case equations array cells of
  Left _ -> ["no cell was observed"]
  Right given ->
    [ show (length cells) ++ " cells were observed; a window has " ++ show (maskSize mask) ++ ", and " ++ show n ++ " independent ones tell a position."
    , "With alpha a root of the array's polynomial and alpha^t = " ++ intercalate " + " (map unknown [0 .. n - 1]) ++ " at the patch's upper left cell, they say:"
    ]
      ++ map equation given
      ++ [leaves (solve n given)]
  where
    n = primitiveDegree (arrayPrimitive array)
    unknown i = variable i ++ (case i of { 0 -> ""; 1 -> " alpha"; _ -> " alpha^" ++ show i })
    variable i = "x" ++ show (i :: Int)
    equation e = "  cell " ++ place (equationOffset e) ++ ": " ++ combination (equationFactors e) ++ " = " ++ showElement (equationValue e)
    combination factors = case [term a i | (a, i) <- zip factors [0 ..], a /= zero] of
      [] -> "0"
      terms -> intercalate " + " terms
    term a i = (if a == one then "" else showElement a ++ " ") ++ variable i
    leaves solutions = case solutions of
      Inconsistent -> "These contradict each other: at least one cell is wrong."
      Solutions x []
        | all (== zero) x -> "Their only solution is zero, which is no power of alpha: the zero window stands nowhere."
        | otherwise -> "Their solution: " ++ intercalate ", " [variable i ++ " = " ++ showElement a | (i, a) <- zip [0 ..] x] ++ "."
      Solutions _ directions -> "They leave " ++ show (length directions) ++ " of the " ++ show n ++ " unknowns open: " ++ show (solutionCount solutions) ++ " positions."

-- | How near the nearest positions are.
explainDecision :: Decision -> [String]
explainDecision decision =
  [ "Windows of these cells differ in at least " ++ show (decisionDistance decision) ++ " cells, so that up to "
      ++ show (guaranteedRadius (decisionDistance decision)) ++ " wrong ones are always corrected; up to " ++ show (decisionRadius decision) ++ " are."
  ]
    ++ [ "The nearest position differs in " ++ show e ++ " cells" ++ maybe "" (\f -> ", the next one in " ++ show f) (decisionRunnerUp decision) ++ "."
       | Just e <- [decisionNearest decision]
       ]
    ++ [ "Wrong are then the cells " ++ unwords (map place wrong) ++ "." | wrong@(_ : _) <- [decisionWrong decision] ]

-- | The same where several orientations are in question, or only upright.
explainOriented :: Bool -> OrientedDecision -> [String]
explainOriented known decision =
  [ (if known then "Positions" else "Candidates, positions in the orientations in question,") ++ " differ in at least " ++ show (orientedMinimum decision) ++ " of these cells, so that up to "
      ++ show (guaranteedRadius (orientedMinimum decision)) ++ " wrong ones are always corrected; up to " ++ show (orientedRadius decision) ++ " are."
  ]
    ++ [ "The nearest one differs in " ++ show e ++ " cells" ++ maybe "" (\f -> ", the next one in " ++ show f) (orientedRunnerUp decision) ++ "."
       | Just e <- [orientedNearest decision]
       ]
    ++ [ "Wrong are then the cells " ++ unwords (map place wrong) ++ "." | wrong@(_ : _) <- [orientedWrong decision] ]

-- | How near the nearest positions are, as far as they were searched.
explainDecoding :: Decoding -> [String]
explainDecoding decoded =
  [ "Windows of these cells differ in at least " ++ show d ++ " cells" ++ searched ++ ", so that up to " ++ show (guaranteedRadius d)
      ++ " wrong ones are always corrected; up to " ++ show (decodingRadius decoded) ++ " are."
  , case decodingNearest decoded of
      Exactly e -> "The nearest position differs in " ++ show e ++ " cells" ++ maybe "" next (decodingRunnerUp decoded) ++ "."
      AtLeast e -> "Every position differs in at least " ++ show e ++ " cells."
  ]
    ++ [ "Wrong are then the cells " ++ unwords (map place wrong) ++ "." | wrong@(_ : _) <- [decodingWrong decoded] ]
  where
    d = atLeast (decodingDistance decoded)
    searched = case decodingDistance decoded of
      Exactly _ -> ""
      AtLeast _ -> ", perhaps in more, for which the search would have been too long"
    next known = case known of
      Exactly e -> ", the next one in " ++ show e
      AtLeast e -> ", any other one in at least " ++ show e

-- | How likely the likeliest positions are.
explainPosterior :: Double -> Posterior -> [String]
explainPosterior tolerated found =
  [ "The probabilities of the positions:" | Just _ <- [posteriorBest found] ]
    ++ [ printf "  %s: %.6g" (place at) chance | (at, chance) <- take 3 (posteriorRanking found) ]
    ++ [ printf "The likeliest is wrong with probability %.3g; %.3g is tolerated." (posteriorDoubt found) tolerated | Just _ <- [posteriorBest found] ]

-- | How likely the likeliest positions of a list are.
explainListing :: Double -> Listing -> [String]
explainListing tolerated found =
  [ "The likeliest contents of the surest independent cells were gone through, " ++ show (listingWords found) ++ " of them; the positions, with their probabilities:"
  | Just _ <- [listingBest found] ]
    ++ [ printf "  %s: at least %.6g" (place at) chance | (at, chance) <- take 3 (listingRanking found) ]
    ++ [ printf "All positions that were not met together have a probability of at most %.3g." (listingUnlisted found) | Just _ <- [listingBest found] ]
    ++ [ printf "The likeliest is wrong with a probability of at most %.3g; %.3g is tolerated." (listingDoubt found) tolerated | Just _ <- [listingBest found] ]

-- | What stands for the outcome.
explainOutcome :: Outcome -> [String]
explainOutcome outcome = case outcome of
  Located _ windows@(_ : _) -> ["Complete windows that say so stand at the offsets " ++ unwords (map place windows) ++ "."]
  _ -> []

-- | How little an answer may be worth.
explainChance :: Chance -> [String]
explainChance found =
  [ "Of all contents of the observed cells " ++ (if chanceExact found then "" else "at most ")
      ++ shareText (chanceShare found) ++ " would be located." ]

place :: Position -> String
place (Position r c) = "(" ++ show r ++ "," ++ show c ++ ")"
