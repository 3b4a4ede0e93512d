{-# LANGUAGE OverloadedStrings #-}

-- | The table of the network experiment as JSON and CSV, and the trace of a training as CSV.
module PraTactile.Format.Experiment
  ( encodeExperiment,
    paperOf,
    rowsCsv,
    levelsCsv,
    traceCsv,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.ByteString (ByteString)
import Data.Foldable (toList)
import Data.List (intercalate)
import PraTactile.Classification.Experiment (middleName, trainingName)
import PraTactile.Classification.Traingdx (Epoch (..), Trace, outcomeName)
import PraTactile.Experiment
import PraTactile.Format.Json
import PraTactile.Shape (alphabetSize)
import PraTactile.SymbolImages (sourceName, sourceSensor, symbolShapes)

-- | The table as one line, without its line end.
encodeExperiment :: [(Row, RowResult)] -> ByteString
encodeExperiment table = encodeSchema "experiment/1" ("rows" .= map rowValue table)

rowValue :: (Row, RowResult) -> Value
rowValue (row, outcome) =
  object
    [ "training" .= trainingName (rowTraining row),
      "middle" .= middleName (outcomeMiddle outcome),
      "varied" .= rowVaried row,
      "set" .= sourceName (rowSource row),
      "sensor" .= sourceSensor (rowSource row),
      "seeds" .= outcomeSeeds outcome,
      "levels" .= map level (outcomeLevels outcome),
      "worst_class_percent" .= spread (outcomeWorst outcome),
      "better_than_clean" .= outcomeBetterThanClean outcome,
      "better_than_none" .= outcomeBetterThanNone outcome,
      "paper_percent" .= paperOf (row, outcome)
    ]
  where
    level (noise, errors) = object ["noise" .= noise, "error_percent" .= spread errors]
    spread (Spread m l g) = object ["median" .= m, "least" .= l, "greatest" .= g]

-- | The paper's figure for a row, if the paper gives it (only for four shapes).
paperOf :: (Row, RowResult) -> Maybe Double
paperOf (row, outcome)
  | rowVaried row == Nothing && alphabetSize (symbolShapes (rowSymbols row)) == 4 =
    paperPercent (outcomeMiddle outcome)
  | otherwise = Nothing

-- | The table as CSV, with a heading.
rowsCsv :: [(Row, RowResult)] -> String
rowsCsv table = csv (heading : map line table)
  where
    heading =
      rowHeading
        ++ ["worst_class_percent_" ++ part | part <- spreadParts]
        ++ ["better_than_clean", "better_than_none", "paper_percent"]
    line (row, outcome) =
      rowCells (row, outcome)
        ++ spreadCells (outcomeWorst outcome)
        ++ [shown (outcomeBetterThanClean outcome), shown (outcomeBetterThanNone outcome)]
        ++ [shown (paperOf (row, outcome))]

-- | The errors of the table's rows at each noise level as CSV, with a heading.
levelsCsv :: [(Row, RowResult)] -> String
levelsCsv table = csv (heading : concatMap block table)
  where
    heading = rowHeading ++ ["noise"] ++ ["error_percent_" ++ part | part <- spreadParts]
    block (row, outcome) =
      [ rowCells (row, outcome) ++ [show noise] ++ spreadCells errors
        | (noise, errors) <- outcomeLevels outcome
      ]

rowHeading, spreadParts :: [String]
rowHeading = ["training", "middle", "varied", "set", "sensor", "seeds"]
spreadParts = ["median", "least", "greatest"]

rowCells :: (Row, RowResult) -> [String]
rowCells (row, outcome) =
  [ trainingName (rowTraining row),
    middleName (outcomeMiddle outcome),
    concat (rowVaried row),
    sourceName (rowSource row),
    concat (sourceSensor (rowSource row)),
    show (outcomeSeeds outcome)
  ]

spreadCells :: Spread -> [String]
spreadCells (Spread m l g) = map show [m, l, g]

shown :: Show a => Maybe a -> String
shown = foldMap show

-- | The epochs of a training's stages as CSV. Epoch 0 of a stage, or of a round, is the state
-- before its first epoch.
traceCsv :: [(Int, Trace)] -> String
traceCsv stages =
  csv $
    ["stage", "epoch", "error", "gradient", "rate", "step"] :
      [ [ show stage,
          show (epochNumber e),
          show (epochError e),
          show (epochGradient e),
          show (epochRate e),
          outcomeName (epochOutcome e)
        ]
        | (stage, trace) <- stages,
          e <- toList trace
      ]

-- | Rows of cells as CSV. Only cells with a comma, a quote or a line break are quoted.
csv :: [[String]] -> String
csv = unlines . map (intercalate "," . map cell)
  where
    cell text
      | any (`elem` (",\"\n" :: String)) text = '"' : concatMap twice text ++ "\""
      | otherwise = text
    twice c = if c == '"' then "\"\"" else [c]
