{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}
-- | Patches as they are seen: several at known displacements, and in unknown orientation.
module Locating.Seen
  ( -- * Choices
    Turning (..)
  , turningName
  , orientationsOf
    -- * Answers
  , Report (..)
  , reporter
  , orientationText
  , pairText
  ) where

import Data.Aeson (Value (Null), object, toJSON, (.=))
import Data.Aeson.Key (Key)
import Data.Aeson.Types (Pair)
import Data.Bifunctor (first)
import Data.List (intercalate, nub, sort)
import Text.Printf (printf)

import Explain
import Json
import Locating
import Message
import PatchText
import PraTactile.Array
import PraTactile.Field (KnownField)
import PraTactile.Locate
import PraTactile.Locate.Algebra (prepareAlgebra)
import PraTactile.Locate.Book
import PraTactile.Locate.Chance
import PraTactile.Locate.Nearest
import PraTactile.Symmetry
import PraTactile.Locate.Oriented
import PraTactile.Locate.Patch (observedCells)
import PraTactile.Locate.Soft
import PraTactile.Locate.Together
import PraTactile.Window

-- | In which orientations patches may be seen.
data Turning
  = Upright
  | Turned    -- ^ by any number of quarter turns
  | Any       -- ^ and perhaps mirrored
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | As the command line has it.
turningName :: Turning -> String
turningName turning = case turning of
  Upright -> "upright"
  Turned -> "turned"
  Any -> "any"

-- | The orientations.
orientationsOf :: Turning -> [Symmetry]
orientationsOf turning = case turning of
  Upright -> [identity]
  Turned -> rotations
  Any -> symmetries

-- | An answer; of patches whose orientation was asked for, the candidates that are left; and of patches with displacements, what each is worth.
data Report = Report
  { reportAnswer :: Answer
  , reportCandidates :: Maybe [Candidate]
  , reportTogether :: [String]            -- ^ what there is to say of single patches, for the text form
  }

-- | From patches to an answer. 'Left' where the road chosen is impossible for the array. What is computed once for the array is computed when first used.
reporter
  :: KnownField k
  => Choice -> Turning -> Surface -> PseudorandomArray k -> Mask -> Either String (Written k -> Either String Report)
reporter choice turning surface array mask = do
  one <- locator choice surface array mask
  pure $ \written -> case (turning, written) of
    (Upright, Alone single) -> plain <$> one single
    (Upright, DisplacedSymbols given) | not compared -> do
      together <- first locateMessage (togetherBy surface array (one . Symbols) onlyPlace given)
      answer <- togetherDecision together
      pure (worth given together (plain answer))
    (_, Alone (Symbols p)) -> togetherDecision <$> symbols [((0, 0), p)]
    (_, Alone (Chances p)) -> togetherDecision <$> chances [((0, 0), p)]
    (_, DisplacedSymbols given) -> (\together -> worth given together (togetherDecision together)) <$> symbols given
    (_, DisplacedChances given) -> (\together -> worth given together (togetherDecision together)) <$> chances given
  where
    plain answer = Report answer Nothing []
    possible = orientationsOf turning
    shelved = first locateMessage (book surface array mask)
    prepared = prepareAlgebra surface array mask
    road = exactRoad choice surface array mask
    -- Whether all positions are compared, so that errors are corrected in any orientation.
    compared = chosenRoad choice == Nothing && either (const False) (const True) shelved
    onlyPlace answer = case answerOutcome <$> answer of
      Right (Located place _) -> Just (Candidate identity place)
      _ -> Nothing
    onlyCandidate outcome = case outcome of
      Right (OrientedAt candidate _) -> Just candidate
      _ -> Nothing
    symbols given = do
      joined <- first locateMessage (joinPatches given)
      case shelved of
        Right shelf | Nothing <- chosenRoad choice -> do
          together <- first locateMessage (nearestTogetherOriented shelf possible (chosenRadius choice) given)
          pure (ofDecision joined <$> together)
        _ | Right algebra <- prepared, Nothing <- chosenRoad choice -> do
              together <- first locateMessage (togetherBy surface array (boundedOriented algebra possible (chosenRadius choice)) (onlyCandidate . fmap orientedOutcome) given)
              first decodingMessage (sequenceA (fmap (ofBounded joined) <$> together))
          | UpTo _ <- chosenRadius choice -> Left "errors are corrected on arrays of up to 2^20 cells, or where positions are discrete logarithms that can be taken; leave out --radius"
          | otherwise -> do
              (named, exact) <- road
              together <- first locateMessage (togetherBy surface array (eachOriented possible exact) onlyCandidate given)
              sequenceA (fmap (ofExact named joined) <$> together)
    chances given = do
      case chosenRoad choice of
        Nothing -> pure ()
        Just _ -> Left "probabilities are for the comparison with all positions; leave out --road"
      shelf <- shelved
      joined <- first locateMessage (joinSoftPatches given)
      together <- first locateMessage (posteriorTogetherOriented shelf possible (chosenDoubt choice) given)
      pure (ofPosterior joined <$> together)
    report outcome named wrong worthOf details explained = Report
      (Answer (plainOutcome outcome) named wrong worthOf (countOf outcome : details ++ orientationDetails turning (candidatesOf outcome)) explained)
      (if turning == Upright then Nothing else Just (candidatesOf outcome)) []
    ofDecision joined decision
      | length (observedCells joined) < maskSize mask =
          let refusing = atMost . chance . correcting 0 (orientedRadius decision) <$> around joined
          in report (OrientedNowhere TooFewCells) NearestRoad [] refusing [] (cellsOf [] joined)
      | otherwise = ofNearest NearestRoad [] joined decision
    ofBounded = ofNearest InformationSetsRoad [("minimum_distance_is", "at-least")]
    ofNearest named more joined decision = report (orientedOutcome decision) named (orientedWrong decision)
      (chance . correcting (orientedMinimum decision) (orientedRadius decision) <$> around joined)
      ([ ("corrected", toJSON (map positionListValue (orientedWrong decision)))
       , ("nearest", maybeNumber (orientedNearest decision))
       , ("runner_up", maybeNumber (orientedRunnerUp decision))
       , ("minimum_distance", naturalValue (orientedMinimum decision)) ]
        ++ more ++ [ ("radius", naturalValue (orientedRadius decision)) ])
      (cellsOf (candidatesOf (orientedOutcome decision)) joined ++ explainOriented (turning == Upright) decision ++ explainOutcome (plainOutcome (orientedOutcome decision)))
    ofExact named joined outcome =
      report outcome named [] (exactChance possible surface array mask named joined) []
        (cellsOf (candidatesOf outcome) joined ++ explainOutcome (plainOutcome outcome))
    ofPosterior joined found =
      let outcome = decideOriented (chosenDoubt choice) found
      in report outcome SoftRoad [] (certainChance possible surface array joined)
           [ ("doubt", toJSON (posteriorDoubt found))
           , ("likeliest", toJSON [ object (("probability" .= probability) : candidateFields turning candidate) | (candidate, probability) <- take 5 (posteriorRanking found) ]) ]
           ([ "The probabilities of the candidates, positions in orientations:" | Just _ <- [posteriorBest found] ]
             ++ [ printf "  %s %s: %.6g" (pairText (candidatePosition candidate)) (orientationText (candidateSymmetry candidate)) probability | (candidate, probability) <- take 3 (posteriorRanking found) ]
             ++ [ printf "The likeliest is wrong with probability %.3g; %.3g is tolerated." (posteriorDoubt found) (chosenDoubt choice) | Just _ <- [posteriorBest found] ])
    around joined = spheres surface array possible (patchShape joined) (map fst (observedCells joined))
    -- The equations of the cells in the one orientation that is left, or in the first.
    cellsOf candidates joined =
      let seen = case nub (map candidateSymmetry candidates) of
            [only] -> only
            _ -> identity
          shape = patchShape joined
          laid = sort [ (onPosition (invert seen) shape offset, a) | (offset, a) <- observedCells joined ]
      in [ "Seen " ++ orientationText seen ++ "; upright, with the offsets that cells then have:" | seen /= identity ]
           ++ [ "In several orientations; taken to be upright:" | turning /= Upright, length (nub (map candidateSymmetry candidates)) /= 1 ]
           ++ explainCells array mask laid

-- | With what each patch is worth.
worth :: [Displaced a] -> TogetherAs b -> Report -> Report
worth given together report = report
  { reportAnswer = answer { answerDetails = answerDetails answer ++ details, answerExplained = answerExplained answer ++ explained }
  , reportTogether =
      [ "inconsistent: patch" ++ (if length strays == 1 then " " else "es ") ++ intercalate ", " (map (show . (+ 1)) strays) | strays@(_ : _) <- [togetherInconsistent together] ]
        ++ [ "in dispute: " ++ unwords (map pairText disputed) | disputed@(_ : _) <- [togetherDisputed together] ]
  }
  where
    answer = reportAnswer report
    each = zip3 [0 ..] (map fst given) (togetherWrong together)
    located = case answerOutcome answer of
      Located _ _ -> True
      _ -> False
    stray i = i `elem` togetherInconsistent together
    details =
      [ ("patches", toJSON [ object ["at" .= [r, c], "wrong" .= (if located then Just wrong else Nothing), "inconsistent" .= stray i] | (i, (r, c), wrong) <- each ])
      , ("disputed", toJSON (map positionListValue (togetherDisputed together))) ]
    explained =
      [ "Patch " ++ show (i + 1) ++ ", " ++ show r ++ " rows down and " ++ show c ++ " columns to the right: "
          ++ (case (located, stray i) of
                (True, True) -> show wrong ++ " of its cells wrong, more than it could have for certain if it were alone: it may not belong here"
                (True, False) -> show wrong ++ " of its cells wrong"
                (False, _) -> "it does not belong where the others are") ++ "."
      | (i, (r, c), wrong) <- each, located || stray i ]
        ++ [ "In dispute, and so not used, are the cells " ++ unwords (map pairText disputed) ++ "." | disputed@(_ : _) <- [togetherDisputed together] ]

plainOutcome :: OrientedOutcome -> Outcome
plainOutcome outcome = case outcome of
  OrientedAt candidate support -> Located (candidatePosition candidate) support
  OrientedAmong candidates -> Ambiguous (nub (sort (map candidatePosition candidates))) []
  OrientedMany count -> AmbiguousCoset count 0
  OrientedNowhere reason -> Refused reason

candidatesOf :: OrientedOutcome -> [Candidate]
candidatesOf outcome = case outcome of
  OrientedAt candidate _ -> [candidate]
  OrientedAmong candidates -> candidates
  _ -> []

-- | Each position counts in each orientation.
countOf :: OrientedOutcome -> (Key, Value)
countOf outcome = case outcome of
  OrientedMany count -> ("count", naturalValue count)
  _ -> ("count", toJSON (length (candidatesOf outcome)))

orientationDetails :: Turning -> [Candidate] -> [(Key, Value)]
orientationDetails turning candidates
  | turning == Upright = []
  | otherwise = case candidates of
      [Candidate o _] -> [("orientation_deg", toJSON (degrees o)), ("mirrored", toJSON (mirrored o)), ("candidates", toJSON ([] :: [Value]))]
      _ -> [("orientation_deg", Null), ("mirrored", Null), ("candidates", toJSON (map (object . candidateFields turning) candidates))]

-- | The orientation only where it was asked for.
candidateFields :: Turning -> Candidate -> [Pair]
candidateFields turning (Candidate o place) =
  ("position" .= positionValue place) : (if turning == Upright then [] else ["orientation_deg" .= degrees o, "mirrored" .= mirrored o])

-- | Clockwise.
degrees :: Symmetry -> Int
degrees o = 90 * (quarterTurns o `mod` 4)

-- | How a patch is seen.
orientationText :: Symmetry -> String
orientationText o = case (mirrored o, degrees o) of
  (False, 0) -> "upright"
  (True, 0) -> "mirrored"
  (flipped, turn) -> (if flipped then "mirrored and " else "") ++ "turned by " ++ show turn ++ " degrees"

pairText :: Position -> String
pairText (Position r c) = show r ++ "," ++ show c
