-- | A recognition in words.
module Recognised
  ( recognitionText,
    recognitionStatus,
    recognitionMessage,
    elementNames,
    orientationText,
    windowText,
    whereText,
  )
where

import Counted
import Data.Bifunctor (first)
import Data.List (intercalate)
import ExitStatus
import Message
import PraTactile.Array (Position (..))
import PraTactile.Field (GF, KnownField, fromCode, showElement)
import PraTactile.Locate (Reason (..))
import PraTactile.Object.Placement
import PraTactile.Recognise
import PraTactile.Recognise.Summary
import Visible

-- | The printed name of the element that a class stands for, in the recogniser's field.
elementNames :: KnownField k => Recogniser k -> Int -> String
elementNames reader = either (const "?") showElement . elementIn reader
  where
    elementIn :: KnownField k => Recogniser k -> Int -> Either () (GF k)
    elementIn _ = first (const ()) . fromCode

-- | The exit status: 0 where a position was found.
recognitionStatus :: Recognition -> ExitStatus
recognitionStatus recognition = case recognisedAnswer recognition of
  Right (Found _) -> Answered
  _ -> NotAnswered

-- | The answer in a sentence.
recognitionMessage :: Recognition -> String
recognitionMessage recognition = case recognisedAnswer recognition of
  Left (NotLocated BelowThreshold)
    | Just support <- recognisedSupport recognition -> thresholdMessage (supportDoubts support)
  Left refusal -> refusalMessage refusal
  Right (Several _ places) ->
    show (length places) ++ " positions fit what was recognised: "
      ++ positionsText places
  Right (Found found) -> whereText (windowWhereabouts (foundWindow found))

-- | The elements of a window, row by row.
windowText :: (Int -> String) -> ReadWindow -> String
windowText nameOf = intercalate " / " . map (unwords . map (maybe "?" nameOf)) . windowClasses

-- | The whole answer, line by line.
recognitionText :: (Int -> String) -> [FilePath] -> Recognition -> [String]
recognitionText nameOf paths recognition = case recognisedAnswer recognition of
  Left refusal ->
    ("refused (" ++ refusalName refusal ++ "): " ++ recognitionMessage recognition) : symbolLines
  Right (Several _ _) -> ("ambiguous: " ++ recognitionMessage recognition) : symbolLines
  Right (Found found) ->
    let window = foundWindow found
     in recognitionMessage recognition :
        symbolLines
          ++ windowLine window :
        ["centre    " ++ centreText on | OnFace on <- [windowWhereabouts window]]
          ++ ["composite " ++ lieText recognition (foundOrientation found) ++ " on the face"]
          ++ ["also      " ++ drop 10 (windowLine other) | other <- drop 1 (foundWindows found)]
  where
    symbols = recognisedSymbols recognition
    known = length [() | symbol <- symbols, Just _ <- [readClass symbol]]
    symbolLines =
      ("symbols   " ++ show (length symbols) ++ " complete, " ++ show known ++ " recognised") :
      ["support   " ++ supportText support | Just support <- [recognisedSupport recognition]]
        ++ [ "chance    " ++ chanceText chance
             | Just chance <- [recognisedSupport recognition >>= supportChance]
           ]
        ++ [ "unchecked " ++ sentence
             | Just checks <- [recognisedSupport recognition >>= supportChecks],
               sentence <- unchecked checks
           ]
        ++ [ "misplaced " ++ visibleName path ++ ": most of its symbols contradict the others'"
             | several paths,
               Just support <- [recognisedSupport recognition],
               (i, path) <- zip [0 ..] paths,
               i `elem` supportInconsistent support
           ]
    several = not . null . drop 1
    windowLine window =
      "window    " ++ windowText nameOf window
        ++ " at row "
        ++ show (row (windowPosition window))
        ++ ", column "
        ++ show (column (windowPosition window))
        ++ " of the array"

-- | The evidence for the likeliest position.
supportText :: Support -> String
supportText support =
  counted
    (supportAgreeing support)
    "certain symbol or part agrees"
    "certain symbols and parts agree"
    ++ ", "
    ++ counted (length (supportWrong support)) "contradicts" "contradict"
    ++ " ("
    ++ (if supportRadius support == 0 then "none" else "up to " ++ show (supportRadius support))
    ++ " may); doubt "
    ++ doubtText (supportDoubt support)
