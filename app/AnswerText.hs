-- | Where patches are, in words, as @locate@ prints it.
module AnswerText
  ( Asked (..),
    upright,
    answerText,
    reportOf,
    candidatesOf,
    orientationText,
    pairText,
  )
where

import Data.List (intercalate, nub, sort)
import Message
import PraTactile.Format (AnswerContext (..), AnswerReport, answerReport)
import PraTactile.Locate
import PraTactile.Position
import PraTactile.Profile (Profile)
import PraTactile.Recognise.Summary (orientationText)
import PraTactile.Symmetry

-- | The parts of the question on which the wording of the answer depends.
data Asked = Asked
  { askedSymmetries :: [Symmetry],
    -- | Whether patches were given with displacements; otherwise there is one patch.
    askedDisplaced :: Bool
  }

-- | Whether only the upright orientation is allowed, so that the answer names none.
upright :: Asked -> Bool
upright asked = askedSymmetries asked == [identity]

-- | The answer as its JSON has it, given the displacements of the patches and, if wanted, the
-- sentences that explain it.
reportOf ::
  Profile -> Asked -> [(Integer, Integer)] -> Maybe [String] -> Answer -> AnswerReport
reportOf profile asked displacements explanation answer = answerReport context answer
  where
    context =
      AnswerContext
        { answerProfile = profile,
          answerSymmetries = askedSymmetries asked,
          answerDisplacements = if askedDisplaced asked then Just displacements else Nothing,
          answerMessage = message,
          answerExplanation = explanation
        }
    message = case answerOutcome answer of
      Unique _ _ -> "located: " ++ answerText asked answer
      Refused reason -> reasonMessage reason
      _ -> answerText asked answer

-- | The outcome, the number of cells taken to be wrong, and the patches that contradict it.
answerText :: Asked -> Answer -> String
answerText asked answer =
  intercalate
    "; "
    ((outcomeText asked (answerOutcome answer) ++ corrections) : patchesText asked answer)
  where
    corrections = case maybe 0 (length . corrected) (answerDistances answer) of
      0 -> ""
      1 -> " (1 cell corrected)"
      n -> " (" ++ show n ++ " cells corrected)"

outcomeText :: Asked -> Outcome Candidate -> String
outcomeText asked outcome = case outcome of
  Unique (Candidate o (Position r c)) _ ->
    "row "
      ++ show r
      ++ ", column "
      ++ show c
      ++ (if upright asked then "" else ", " ++ orientationText o)
  Ambiguous candidates _
    | upright asked -> fitting (length places) ++ ": " ++ unwords (map pairText places)
    | otherwise ->
      fitting (length candidates) ++ ": " ++ intercalate "; " (map candidateText candidates)
    where
      places = nub (sort (map candidatePosition candidates))
  AmbiguousMany count _ -> fitting count
  Refused reason -> "refused (" ++ reasonName reason ++ "): " ++ reasonMessage reason
  where
    fitting count =
      "ambiguous: "
        ++ show count
        ++ (if upright asked then " positions fit" else " positions and orientations fit")
    candidateText candidate =
      pairText (candidatePosition candidate) ++ " " ++ orientationText (candidateSymmetry candidate)

-- | The patches that contradict the answer, with the cells in which they differ.
patchesText :: Asked -> Answer -> [String]
patchesText asked answer
  | not (askedDisplaced asked) = []
  | otherwise =
    [ "inconsistent: patch"
        ++ (if length strays == 1 then " " else "es ")
        ++ intercalate ", " (map show strays)
      | strays@(_ : _) <-
          [ [ i
              | (i, verdict) <- zip [1 :: Int ..] (answerPatches answer),
                patchInconsistent verdict
            ]
          ]
    ]
      ++ [ "in dispute: " ++ unwords (map pairText disputed)
           | disputed@(_ : _) <- [answerDisputed answer]
         ]

-- | The candidates, as far as they are listed.
candidatesOf :: Answer -> [Candidate]
candidatesOf answer = case answerOutcome answer of
  Unique candidate _ -> [candidate]
  Ambiguous candidates _ -> candidates
  _ -> []

-- | @r,c@.
pairText :: Position -> String
pairText (Position r c) = show r ++ "," ++ show c
