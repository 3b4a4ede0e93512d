-- | Why an answer is what it is, in sentences: the cells used, their equations, the distance to the
-- next candidate.
module Explain
  ( explainAnswer,
  )
where

import AnswerText
import Data.List (intercalate, nub, sort)
import Message.Chance (shareText)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Decoder.Equations
import PraTactile.Polynomial (primitiveDegree)
import PraTactile.Symmetry
import PraTactile.Window
import Text.Printf (printf)

-- | What the answer rests on, given the array and its window, the displacements of the patches, the
-- observed symbols of all of them, and the doubt that is tolerated.
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
    ++ maybe [] (explainPosterior asked plain tolerated) (answerPosterior answer)
    ++ explainWindows (answerOutcome answer)
    ++ (if askedDisplaced asked then explainPatches displacements answer else [])
    ++ maybe [] explainChance (answerChance answer)
  where
    explainedDistances distances =
      ( if upright asked
          then explainCells array mask (observedCells seen)
          else explainSeen array mask seen (candidatesOf answer)
      )
        ++ ( if null (observedCells seen)
               then []
               else explainDistances asked plain (answerDecoder answer) distances
           )
    -- Of one upright patch, and of several where not all positions are compared, the words are
    -- those of positions.
    plain =
      upright asked
        && not
          (askedDisplaced asked && answerDecoder answer `elem` [NearestDecoder, PosteriorDecoder])

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
        ++ intercalate " + " (map unknown [0 .. n - 1])
        ++ " at the patch's upper left cell, they say:"
    ]
      ++ map equation given
      ++ [leaves (solve n given)]
  where
    n = primitiveDegree (arrayPrimitive array)
    unknown i = variable i ++ (case i of 0 -> ""; 1 -> " alpha"; _ -> " alpha^" ++ show i)
    variable i = "x" ++ show (i :: Int)
    equation e =
      "  cell "
        ++ place (equationOffset e)
        ++ ": "
        ++ combination (equationFactors e)
        ++ " = "
        ++ showElement (equationValue e)
    combination factors = case [term a i | (a, i) <- zip factors [0 ..], a /= zero] of
      [] -> "0"
      terms -> intercalate " + " terms
    term a i = (if a == one then "" else showElement a ++ " ") ++ variable i
    leaves solutions = case solutions of
      Inconsistent -> "These contradict each other: at least one cell is wrong."
      Solutions x []
        | all (== zero) x ->
          "Their only solution is zero, which is no power of alpha: the zero window stands nowhere."
        | otherwise ->
          "Their solution: "
            ++ intercalate ", " [variable i ++ " = " ++ showElement a | (i, a) <- zip [0 ..] x]
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
explainDistances :: Asked -> Bool -> DecoderName -> Distances -> [String]
explainDistances asked plain decoder distances
  | decoder `notElem` [NearestDecoder, InformationSetDecoder] = []
  | otherwise =
    [ differ
        ++ ", so that up to "
        ++ show (guaranteedRadius d)
        ++ " wrong ones are always corrected; up to "
        ++ show (correctionRadius distances)
        ++ " are."
    ]
      ++ nearestOne
      ++ [ "Wrong are then the cells " ++ unwords (map place wrong) ++ "."
           | wrong@(_ : _) <- [corrected distances]
         ]
  where
    d = atLeast (codeDistance distances)
    differ
      | plain = "Windows of these cells differ in at least " ++ show d ++ " cells" ++ searched
      | otherwise =
        ( if upright asked
            then "Positions"
            else "Candidates, positions in the orientations in question,"
        )
          ++ " differ in at least "
          ++ show d
          ++ " of these cells"
    searched = case codeDistance distances of
      Exactly _ -> ""
      AtLeast _ -> ", perhaps in more, for which the search would have been too long"
    nearestOne = case nearestDistance distances of
      Just (Exactly e) ->
        [ "The nearest "
            ++ (if plain then "position" else "one")
            ++ " differs in "
            ++ show e
            ++ " cells"
            ++ maybe "" next (runnerUpDistance distances)
            ++ "."
        ]
      Just (AtLeast e) | plain -> ["Every position differs in at least " ++ show e ++ " cells."]
      _ -> []
    next known = case known of
      Exactly e -> ", the next one in " ++ show e
      AtLeast e -> if plain then ", any other one in at least " ++ show e else ""

-- | How likely the likeliest candidates are.
explainPosterior :: Asked -> Bool -> Double -> Posterior Candidate -> [String]
explainPosterior asked plain tolerated found = case posteriorBest found of
  Nothing -> []
  Just _ ->
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
    isList = posteriorUnlisted found /= Nothing
    heading
      | isList =
        "The likeliest contents of the surest independent cells were gone through, "
          ++ show (posteriorWords found)
          ++ " of them; the "
          ++ candidates
          ++ ", with their probabilities:"
      | plain = "The probabilities of the positions:"
      | otherwise = "The probabilities of the candidates, positions in orientations:"
    candidates = if upright asked then "positions" else "candidates" :: String
    bound = if isList then "at least " else ""
    probability = if isList then "a probability of at most" else "probability" :: String
    candidateText (Candidate o at)
      | plain = place at
      | otherwise = pairText at ++ " " ++ orientationText o

-- | The windows that stand for the outcome.
explainWindows :: Outcome Candidate -> [String]
explainWindows outcome = case outcome of
  Unique _ windows@(_ : _) ->
    ["Complete windows that say so stand at the offsets " ++ unwords (map place windows) ++ "."]
  _ -> []

-- | Which patches do not belong, and what of them is wrong.
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

-- | How little an answer may be worth.
explainChance :: Chance -> [String]
explainChance found =
  [ "Of all contents of the observed cells " ++ (if chanceExact found then "" else "at most ")
      ++ shareText (chanceShare found)
      ++ " would be located."
  ]

place :: Position -> String
place (Position r c) = "(" ++ show r ++ "," ++ show c ++ ")"
