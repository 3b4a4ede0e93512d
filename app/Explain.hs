-- | The explanation of an answer in sentences: the cells used, their equations, the distance to the
-- next candidate.
module Explain
  ( explainAnswer,
  )
where

import AnswerText
import Data.List (intercalate, nub, sort)
import Message.Chance (checksSentences, shareText)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Decoder.Equations
import PraTactile.Polynomial (primitiveDegree)
import PraTactile.Symmetry
import PraTactile.Window
import Text.Printf (printf)

-- | The reasons for an answer, line by line, given the array and its window, the displacements of
-- the patches, the observed symbols of all of them, and the tolerated doubt.
explainAnswer ::
  KnownField k =>
  PseudorandomArray k ->
  Mask ->
  Asked ->
  [(Integer, Integer)] ->
  Patch (GF k) ->
  Double ->
  Answer ->
  [String]
explainAnswer array mask asked displacements seen tolerated answer =
  maybe [] explainedDistances (answerDistances answer)
    ++ maybe [] (explainPosterior asked terms tolerated) (answerPosterior answer)
    ++ maybe [] (explainDoubts tolerated) (answerDoubts answer)
    ++ explainWindows (answerOutcome answer)
    ++ (if askedDisplaced asked then explainPatches displacements answer else [])
    ++ maybe [] explainChance (answerChance answer)
    ++ maybe [] checksSentences (answerChecks answer)
  where
    explainedDistances distances =
      ( if upright asked
          then explainCells array mask (observedCells seen)
          else explainSeen array mask seen (candidatesOf answer)
      )
        ++ ( if null (observedCells seen)
               then []
               else explainDistances asked terms (answerDecoder answer) distances
           )
    severalCompared =
      askedDisplaced asked && answerDecoder answer `elem` [NearestDecoder, PosteriorDecoder]
    terms = if upright asked && not severalCompared then OfPositions else OfCandidates

-- | In which words: of one upright patch, and of several where not all positions are compared, in
-- those of positions.
data Terms = OfPositions | OfCandidates
  deriving stock (Eq)

-- | The equations of the cells in the one orientation that is left, or upright.
explainSeen ::
  KnownField k =>
  PseudorandomArray k ->
  Mask ->
  Patch (GF k) ->
  [Candidate] ->
  [String]
explainSeen array mask seen candidates =
  [ "Seen " ++ orientationText o ++ "; upright, with the offsets that cells then have:"
    | o /= identity
  ]
    ++ ["In several orientations; taken to be upright:" | length found /= 1]
    ++ explainCells
      array
      mask
      ( sort
          [(onPosition (invert o) (patchShape seen) offset, a) | (offset, a) <- observedCells seen]
      )
  where
    found = nub (map candidateSymmetry candidates)
    o = case found of
      [only] -> only
      _ -> identity

-- | The observed cells as equations for alpha^t, t being the index of the patch's upper left cell
-- in the sequence, and what they leave open.
explainCells :: KnownField k => PseudorandomArray k -> Mask -> [(Position, GF k)] -> [String]
explainCells array mask cells = case equations array cells of
  Left _ -> ["no cell was observed"]
  Right given ->
    [ show (length cells)
        ++ " cells were observed; a window has "
        ++ show (maskSize mask)
        ++ ", and "
        ++ show n
        ++ " independent ones tell a position.",
      "With alpha a root of the array's polynomial and alpha^t = "
        ++ intercalate " + " (map summand [0 .. n - 1])
        ++ " at the patch's upper left cell, they say:"
    ]
      ++ map equationText given
      ++ [solutionText n (solve n given)]
  where
    n = primitiveDegree (arrayPrimitive array)
    summand i = unknown i ++ (case i of 0 -> ""; 1 -> " alpha"; _ -> " alpha^" ++ show i)

-- | The coefficient of a power of alpha.
unknown :: Int -> String
unknown i = "x" ++ show i

equationText :: KnownField k => Equation k -> String
equationText e =
  "  cell "
    ++ place (equationOffset e)
    ++ ": "
    ++ (if null terms then "0" else intercalate " + " terms)
    ++ " = "
    ++ showElement (equationValue e)
  where
    terms = [term a i | (a, i) <- zip (equationFactors e) [0 ..], a /= zero]
    term a i = (if a == one then "" else showElement a ++ " ") ++ unknown i

-- | How many positions the equations leave, in words.
solutionText :: KnownField k => Int -> Solutions k -> String
solutionText n solutions = case solutions of
  Inconsistent -> "These contradict each other: at least one cell is wrong."
  Solutions x []
    | all (== zero) x ->
      "Their only solution is zero, which is no power of alpha: the zero window stands nowhere."
    | otherwise ->
      "Their solution: "
        ++ intercalate ", " [unknown i ++ " = " ++ showElement a | (i, a) <- zip [0 ..] x]
        ++ "."
  Solutions _ directions ->
    "They leave "
      ++ show (length directions)
      ++ " of the "
      ++ show n
      ++ " unknowns open: "
      ++ show (solutionCount solutions)
      ++ " positions."

-- | How near the nearest candidates are.
explainDistances :: Asked -> Terms -> DecoderName -> Distances -> [String]
explainDistances asked terms decoder distances
  | decoder `notElem` [NearestDecoder, InformationSetDecoder] = []
  | otherwise =
    [ differ
        ++ ", so that up to "
        ++ show (guaranteedRadius d)
        ++ " wrong ones are always corrected; up to "
        ++ show (correctionRadius distances)
        ++ " are."
    ]
      ++ explainNearest terms distances
      ++ [ "Wrong are then the cells " ++ unwords (map place wrong) ++ "."
           | wrong@(_ : _) <- [corrected distances]
         ]
  where
    d = atLeast (codeDistance distances)
    differ = case terms of
      OfPositions -> "Windows of these cells differ in at least " ++ show d ++ " cells" ++ searched
      OfCandidates -> subject ++ " differ in at least " ++ show d ++ " of these cells"
    subject
      | upright asked = "Positions"
      | otherwise = "Candidates, positions in the orientations in question,"
    searched = case codeDistance distances of
      Exactly _ -> ""
      AtLeast _ -> ", perhaps in more, for which the search would have been too long"

-- | The distance of the nearest candidate, and of the next one.
explainNearest :: Terms -> Distances -> [String]
explainNearest terms distances = case (nearestDistance distances, terms) of
  (Just (Exactly e), _) ->
    ["The nearest " ++ what ++ " differs in " ++ show e ++ " cells" ++ foldMap next second ++ "."]
  (Just (AtLeast e), OfPositions) -> ["Every position differs in at least " ++ show e ++ " cells."]
  _ -> []
  where
    what = if terms == OfPositions then "position" else "one"
    second = runnerUpDistance distances
    next known = case (known, terms) of
      (Exactly e, _) -> ", the next one in " ++ show e
      (AtLeast e, OfPositions) -> ", any other one in at least " ++ show e
      _ -> ""

-- | How likely it is that the patch is foreign.
explainDoubts :: Double -> PlaceDoubts -> [String]
explainDoubts tolerated doubts =
  [ printf
      "That it is nothing of the array's has a probability of %.3g, of which %.3g is for symbols \
      \by chance and %s%.3g for other arrays; %.3g is tolerated in all."
      (doubtOfForeign origin)
      (doubtOfRandom origin)
      (if otherArraysExact origin then "" else "at most ")
      (doubtOfOtherArrays origin)
      tolerated
  ]
  where
    origin = doubtsOfForeign doubts

-- | How likely the likeliest candidates are.
explainPosterior :: Asked -> Terms -> Double -> Posterior Candidate -> [String]
explainPosterior asked terms tolerated found
  | null (posteriorBest found) = []
  | otherwise =
    heading :
    [ "  " ++ candidateText candidate ++ ": " ++ bound ++ printf "%.6g" chance
      | (candidate, chance) <- take 3 (posteriorRanking found)
    ]
      ++ [ printf
             "All %s that were not met together have a probability of at most %.3g."
             candidates
             unlisted
           | Just unlisted <- [posteriorUnlisted found]
         ]
      ++ [ printf
             "The likeliest is wrong with %s %.3g; %.3g is tolerated."
             probability
             (posteriorDoubt found)
             tolerated
         ]
  where
    candidates = if upright asked then "positions" else "candidates" :: String
    -- A list of likely positions gives bounds.
    (bound, probability, heading) = case (posteriorUnlisted found, terms) of
      (Just _, _) ->
        ( "at least ",
          "a probability of at most" :: String,
          "The likeliest contents of the surest independent cells were gone through, "
            ++ show (posteriorWords found)
            ++ " of them; the "
            ++ candidates
            ++ ", with their probabilities:"
        )
      (_, OfPositions) -> ("", "probability", "The probabilities of the positions:")
      _ -> ("", "probability", "The probabilities of the candidates, positions in orientations:")
    candidateText (Candidate o at)
      | terms == OfPositions = place at
      | otherwise = pairText at ++ " " ++ orientationText o

-- | The windows that stand for the outcome.
explainWindows :: Outcome Candidate -> [String]
explainWindows outcome = case outcome of
  Unique _ windows@(_ : _) ->
    ["Complete windows that say so stand at the offsets " ++ unwords (map place windows) ++ "."]
  _ -> []

-- | The patches that contradict the answer, with their wrong cells.
explainPatches :: [(Integer, Integer)] -> Answer -> [String]
explainPatches displacements answer =
  [ "Patch "
      ++ show i
      ++ ", "
      ++ show r
      ++ " rows down and "
      ++ show c
      ++ " columns to the right: "
      ++ said
      ++ "."
    | (i, (r, c), verdict) <- zip3 [1 :: Int ..] displacements (answerPatches answer),
      Just said <- [patchText verdict]
  ]
    ++ [ "In dispute, and so not used, are the cells " ++ unwords (map pairText disputed) ++ "."
         | disputed@(_ : _) <- [answerDisputed answer]
       ]
  where
    patchText verdict = case (patchWrong verdict, patchInconsistent verdict) of
      (Just wrong, True) ->
        Just
          ( show wrong
              ++ " of its cells wrong, more than it could have for certain if it were alone: it \
                 \may not belong here"
          )
      (Just wrong, False) -> Just (show wrong ++ " of its cells wrong")
      (Nothing, True) -> Just "it does not belong where the others are"
      (Nothing, False) -> Nothing

-- | How often random cells would be located.
explainChance :: Chance -> [String]
explainChance found =
  [ "Of all contents of the observed cells " ++ (if chanceExact found then "" else "at most ")
      ++ shareText (chanceShare found)
      ++ " would be located."
  ]

place :: Position -> String
place (Position r c) = "(" ++ show r ++ "," ++ show c ++ ")"
