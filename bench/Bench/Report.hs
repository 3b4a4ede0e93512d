-- | The report as a Markdown table.
module Bench.Report
  ( heading,
    rowText,
  )
where

import Bench.Compare
import Bench.Pairs (Spread (..))
import Bench.Targets
import Data.List (intercalate)
import Text.Printf (printf)

-- | The table's head.
heading :: [String]
heading =
  [ cells
      [ "what",
        "ours",
        "peer",
        "its figure",
        "its first call",
        "times as fast, min / median / max",
        "asked",
        "",
        "peak MiB"
      ],
    cells (replicate 9 "---")
  ]

cells :: [String] -> String
cells texts = "| " ++ intercalate " | " texts ++ " |"

-- | One row of the table. Our figure and the peer's are medians.
rowText :: Row -> String
rowText row =
  cells
    [ targetName (rowTarget row) ++ ": " ++ targetWhat (rowTarget row),
      maybe "-" spreadOf (rowOurs row),
      peerName,
      maybe notRun (quantity unit . median) (rowPeer row),
      maybe "" (quantity unit) (rowFirst row),
      maybe
        ""
        ( \s ->
            significant (least s)
              ++ " / **"
              ++ significant (median s)
              ++ "** / "
              ++ significant (greatest s)
        )
        (rowRatio row),
      asked,
      verdict ++ (if null (rowNote row) then "" else " (" ++ rowNote row ++ ")"),
      printf "%.0f" (rowPeak row)
    ]
  where
    unit = rowUnit row
    spreadOf s =
      quantity unit (median s)
        ++ " ("
        ++ quantity unit (least s)
        ++ " ... "
        ++ quantity unit (greatest s)
        ++ ")"
    peerName = case rowGoal row of
      TimesAsFast _ (Script name _ _) -> name
      TimesAsFast _ (Program name _ _) -> name
      _ -> ""
    notRun = case rowGoal row of
      TimesAsFast _ _ -> "not run"
      _ -> ""
    asked = case rowGoal row of
      TimesAsFast 0 _ -> ""
      TimesAsFast wanted _ -> significant wanted ++ " times"
      WithinSeconds limit -> quantity "s" limit
      AtLeast wanted -> quantity unit wanted
      WithinMebibytes limit -> printf "%.0f MiB" limit
      Recorded -> ""
    verdict = case rowStanding row of
      Met -> "met"
      Missed -> "MISSED"
      NoVerdict -> ""

-- | A value with three significant digits and a unit that fits its size.
quantity :: String -> Double -> String
quantity "s" seconds
  | seconds < 1e-6 = significant (seconds * 1e9) ++ " ns"
  | seconds < 1e-3 = significant (seconds * 1e6) ++ " us"
  | seconds < 1 = significant (seconds * 1e3) ++ " ms"
  | otherwise = significant seconds ++ " s"
quantity _ rate = significant (rate / 1e6) ++ " M/s"

significant :: Double -> String
significant x
  | x < 10 = printf "%.2f" x
  | x < 100 = printf "%.1f" x
  | otherwise = printf "%.0f" x
