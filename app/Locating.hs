{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE OverloadedStrings #-}
-- | The roads from a patch to its position, as the command line offers them.
module Locating
  ( -- * Choices
    Road (..)
  , roadName
  , Choice (..)
    -- * Answers
  , Locator
  , locator
  , Answer (..)
    -- * Parts of them
  , exactRoad
  , exactChance
  , certainChance
  , counted
  , maybeNumber
  ) where

import Data.Aeson (Value (Null), object, toJSON, (.=))
import Data.Aeson.Key (Key)
import Data.Bifunctor (first)
import qualified Data.Map.Lazy as Map
import Numeric.Natural (Natural)

import Explain
import Json
import Message
import PatchText
import PraTactile.Array
import PraTactile.Field (KnownField)
import PraTactile.Locate
import PraTactile.Locate.Algebra
import PraTactile.Locate.Book
import PraTactile.Locate.BoundedDistance
import PraTactile.Locate.Chance
import PraTactile.Locate.Nearest
import PraTactile.Locate.OrderedStatistics
import PraTactile.Locate.Separation
import PraTactile.Symmetry
import PraTactile.Locate.Oriented (eachLaid)
import PraTactile.Locate.Patch (completeWindows, observedCells)
import PraTactile.Locate.Search
import PraTactile.Locate.Soft
import PraTactile.Window

-- | How the position is found.
data Road
  = TableRoad
  | AlgebraRoad
  | SearchRoad
  | NearestRoad   -- ^ compare with every position and correct errors
  | SoftRoad      -- ^ the probability of every position
  | InformationSetsRoad   -- ^ correct errors without visiting every position
  | ListRoad      -- ^ the probabilities of a list of likely positions
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | As the command line and JSON have it.
roadName :: Road -> String
roadName road = case road of
  TableRoad -> "table"
  AlgebraRoad -> "algebra"
  SearchRoad -> "search"
  NearestRoad -> "nearest"
  SoftRoad -> "soft"
  InformationSetsRoad -> "information-sets"
  ListRoad -> "list"

-- | What the command line chooses.
data Choice = Choice
  { chosenRoad :: Maybe Road      -- ^ 'Nothing': as the patch and the array need it
  , chosenRadius :: Radius
  , chosenDoubt :: Double         -- ^ the probability of a wrong answer that is tolerated
  , chosenPacking :: Packing
  }

-- | An answer, and what it is worth.
data Answer = Answer
  { answerOutcome :: Outcome
  , answerRoad :: Road
  , answerCorrected :: [Position]      -- ^ the offsets of the cells taken to be wrong
  , answerChance :: Maybe Chance       -- ^ of all contents of the observed cells, the share that would be located
  , answerDetails :: [(Key, Value)]   -- ^ further keys of the JSON form
  , answerExplained :: [String]        -- ^ in sentences
  }

-- | From a patch to its answer; 'Left' where the patch needs a road that the array does not allow.
type Locator k = Observed k -> Either String Answer

-- | The locator of an array; 'Left' where the road chosen is impossible for it. What is computed once for the array is computed when first used.
locator :: KnownField k => Choice -> Surface -> PseudorandomArray k -> Mask -> Either String (Locator k)
locator choice surface array mask = case chosenRoad choice of
  Nothing -> bySize shelved
  Just _ -> (`either'` const (Left "probabilities are for the comparison with all positions; leave out --road")) <$> viaExact
  where
    shelved = first locateMessage (book surface array mask)
    prepared = first algebraMessage (prepareAlgebra surface array mask)
    -- Large arrays are not compared with the patch: information sets, or where there are no logarithms the table.
    bySize (Right shelf) = Right (either' (viaNearest shelf) (viaSoft shelf))
    bySize (Left tooLarge) = case prepared of
      Right algebra -> Right (either' (viaInformationSets algebra (decoders algebra)) (viaList algebra))
      Left _ -> (`either'` const (Left tooLarge)) <$> viaExact
    either' hard soft observed = case observed of
      Symbols p -> hard p
      Chances p -> soft p
    viaExact = (\(road, exact) p -> plain road p <$> exact p) <$> exactRoad choice surface array mask
    plain road p outcome = plainWith (exactChance [identity] surface array mask road p) road p outcome
    plainWith worth road p outcome = Answer outcome road [] worth (counted outcome)
      (explainCells array mask (observedCells p) ++ explainOutcome outcome)
    viaNearest shelf p
      | fewer p =
          let worth = atMost . chance . correcting 0 (radiusFor (chosenRadius choice) 0) <$> around p
          in Right (plainWith worth NearestRoad p (Refused TooFewCells))
      | otherwise =
          let decision = nearest shelf (chosenRadius choice) p
          in Right (Answer (decisionOutcome decision) NearestRoad (decisionWrong decision)
               (chance . correcting (decisionDistance decision) (decisionRadius decision) <$> around p)
               (counted (decisionOutcome decision) ++ ofDecision decision)
               (explainCells array mask (observedCells p) ++ explainDecision decision ++ explainOutcome (decisionOutcome decision)))
    around p = spheres surface array [identity] (patchShape p) (map fst (observedCells p))
    -- Fewer cells than a window has never tell a position on the array's own surface.
    fewer p = length (observedCells p) < maskSize mask
    -- What is computed once for patches without holes of one shape, as it is first asked for.
    decoders algebra = Map.fromList [((h, w), decoder standardEffort algebra [Position i j | i <- [0 .. h - 1], j <- [0 .. w - 1]]) | h <- [1 .. 32], w <- [1 .. 32]]
    viaInformationSets algebra shapes p = do
      decoded <- first decodingMessage $ case Map.lookup (rows (patchShape p), columns (patchShape p)) shapes of
        Just (Right ready) | decoderOffsets ready == map fst (observedCells p) -> decodeWith ready (chosenRadius choice) p
        _ -> decodePatch algebra (chosenRadius choice) p
      let outcome = decodingOutcome decoded
      pure (Answer outcome InformationSetsRoad (decodingWrong decoded)
        (chance . correcting (atLeast (decodingDistance decoded)) (decodingRadius decoded) <$> around p)
        (counted outcome ++ ofDecoding decoded)
        (explainCells array mask (observedCells p) ++ explainDecoding decoded ++ explainOutcome outcome))
    viaSoft shelf p =
      let found = posterior shelf p
          outcome = decide (chosenDoubt choice) found
      in Right (Answer outcome SoftRoad [] (certainChance [identity] surface array p)
           (counted outcome ++ ofPosterior found) (explainPosterior (chosenDoubt choice) found ++ explainOutcome outcome))

    viaList algebra p = do
      found <- first algebraMessage (listPatch standardListing (chosenDoubt choice) algebra p)
      let outcome = decideListing (chosenDoubt choice) found
      pure (Answer outcome ListRoad [] (certainChance [identity] surface array p)
        (counted outcome ++ ofListing found) (explainListing (chosenDoubt choice) found ++ explainOutcome outcome))

-- | The road on which nothing is corrected: the one chosen, or else algebra, or where that cannot be the table. 'Left' where it is impossible for the array.
exactRoad :: KnownField k => Choice -> Surface -> PseudorandomArray k -> Mask -> Either String (Road, Patch k -> Either String Outcome)
exactRoad choice surface array mask = case chosenRoad choice of
  Nothing -> either (\infeasible -> first (\why -> infeasible ++ "; and " ++ why) table) Right algebra
  Just TableRoad -> table
  Just AlgebraRoad -> algebra
  Just _ -> Right (SearchRoad, first locateMessage . searchPatch surface array mask)
  where
    table = (\made -> (TableRoad, Right . locatePatch made)) <$> first locateMessage (buildTable (chosenPacking choice) surface array mask)
    algebra = (\made -> (AlgebraRoad, first algebraMessage . algebraPatch made)) <$> first algebraMessage (prepareAlgebra surface array mask)

-- | What an answer of a road on which nothing is corrected is worth, in one of these orientations. The table knows
-- complete windows only.
exactChance :: KnownField k => [Symmetry] -> Surface -> PseudorandomArray k -> Mask -> Road -> Patch k -> Maybe Chance
exactChance possible surface array mask road p =
  limited . chance . correctingNothing differ <$> spheres surface array possible shape offsets
  where
    differ = candidatesDiffer surface array possible shape offsets
    shape = patchShape p
    offsets = map fst (observedCells p)
    limited
      | road == TableRoad && any (null . completeWindows mask . snd) (eachLaid possible p) = atMost
      | otherwise = id

-- | What an answer from probabilities is worth, in one of these orientations: only a cell that leaves no doubt keeps
-- out a position.
certainChance :: KnownField k => [Symmetry] -> Surface -> PseudorandomArray k -> SoftPatch k -> Maybe Chance
certainChance possible surface array p =
  chance . amongCells certain <$> spheres surface array possible (softShape p) (map fst (softCells p))
  where
    certain = fromIntegral (length (filter (isCertain . snd) (softCells p)))

-- | How many positions.
counted :: Outcome -> [(Key, Value)]
counted outcome = case outcome of
  Located _ _ -> [("count", toJSON (1 :: Int))]
  Ambiguous places _ -> [("count", toJSON (length places))]
  AmbiguousCoset count dimension -> [("count", naturalValue count), ("dimension", naturalValue dimension)]
  Refused _ -> [("count", toJSON (0 :: Int))]

ofDecision :: Decision -> [(Key, Value)]
ofDecision decision =
  [ ("corrected", toJSON (map positionListValue (decisionWrong decision)))
  , ("nearest", maybeNumber (decisionNearest decision))
  , ("runner_up", maybeNumber (decisionRunnerUp decision))
  , ("minimum_distance", naturalValue (decisionDistance decision))
  , ("radius", naturalValue (decisionRadius decision))
  ]

ofDecoding :: Decoding -> [(Key, Value)]
ofDecoding decoded =
  [ ("corrected", toJSON (map positionListValue (decodingWrong decoded)))
  , ("nearest", exactly (decodingNearest decoded))
  , ("runner_up", maybe Null exactly (decodingRunnerUp decoded))
  , ("runner_up_at_least", maybeNumber (atLeast <$> decodingRunnerUp decoded))
  , ("minimum_distance", naturalValue (atLeast (decodingDistance decoded)))
  , ("minimum_distance_is", case decodingDistance decoded of { Exactly _ -> "exact"; AtLeast _ -> "at-least" })
  , ("radius", naturalValue (decodingRadius decoded))
  ]
  where
    exactly known = case known of { Exactly n -> naturalValue n; AtLeast _ -> Null }

maybeNumber :: Maybe Natural -> Value
maybeNumber = maybe Null naturalValue

ofPosterior :: Posterior -> [(Key, Value)]
ofPosterior found =
  [ ("doubt", toJSON (posteriorDoubt found))
  , likeliestFive (posteriorRanking found)
  ]

ofListing :: Listing -> [(Key, Value)]
ofListing found =
  [ ("doubt", toJSON (listingDoubt found))
  , ("doubt_is", "at-most")
  , likeliestFive (listingRanking found)
  , ("unlisted", toJSON (listingUnlisted found))
  ]

-- | The first five positions of a ranking.
likeliestFive :: [(Position, Double)] -> (Key, Value)
likeliestFive ranking = ("likeliest", toJSON [object ["position" .= positionValue place, "probability" .= probability] | (place, probability) <- take 5 ranking])
