-- | The table of rates as text.
module RatesTable
  ( heading,
    lineText,
    checksHeading,
    checksText,
    checksOfAll,
  )
where

import Counted (numberText)
import PraTactile.Format.Name (shapeText)
import PraTactile.Format.Rates
import PraTactile.Rates
import Text.Printf (printf)

-- | The head of the table, hard decoding being to this radius.
heading :: Radius -> String
heading radius =
  unlines
    [ "Of all patches in %. Hard: from symbols, to " ++ reach ++ ".",
      "Soft: from the same cells' probabilities. 99.9 % certain: answered if the doubt is at most \
      \0.001.",
      "Wrong as hard: the surest are answered first, until as many are wrong as by hard decoding; \
      \more: how many % more are answered.",
      "",
      row "" "" "" ++ concat ["   " ++ centred 23 name | name <- overColumns],
      row "patch" "errors" "erased"
        ++ concat ("   " ++ unwords (map padded ["right", "wrong", "refused"]) <$ overColumns)
        ++ " "
        ++ padded "more"
    ]
  where
    reach = case radius of
      Guaranteed -> "the radius that the observed cells guarantee"
      UpTo e -> "a radius of " ++ show e ++ " wrong cells, guaranteed or not"
    overColumns =
      ["hard, simulated", "hard, exact", "soft, 99.9 % certain", "soft, wrong as hard"]
    centred width name =
      let left = (width - length name) `div` 2
       in take width (replicate left ' ' ++ name ++ repeat ' ')

lineText :: Line -> String
lineText l =
  damageText l
    ++ concat
      ["   " ++ maybe (unwords dashes) ratesText (rates l) | (_, rates) <- ways]
    ++ " "
    ++ padded (maybe "-" (printf "%+.2f") (moreAnswers l))
  where
    ratesText (Rates a b c) =
      unwords [printf "%7.3f" (100 * a), padded (short (100 * b)), padded (short (100 * c))]

-- | Three columns without a number.
dashes :: [String]
dashes = replicate 3 (padded "-")

-- | A column of 7 characters, flush right.
padded :: String -> String
padded = printf "%7s"

-- | The first columns of a line: size, errors, erasures.
row :: String -> String -> String -> String
row = printf "%-6s %6s %6s"

damageText :: Line -> String
damageText l =
  row (shapeText (lineSize l)) (numberText (lineErrors l)) (numberText (lineErasures l))

-- | Three digits, or two and a power of ten; at most 7 characters.
short :: Double -> String
short x
  | x == 0 = "0"
  | x >= 99.995 = "100"
  | x >= 9.9995 = printf "%.2f" x
  | x >= 0.9995 = printf "%.3f" x
  | x >= 0.001 = printf "%.4f" x
  | otherwise = printf "%.1e" x

checksHeading :: String
checksHeading =
  unlines
    [ "",
      "How far simulated hard decoding is from the exact rates, in standard errors. Of the soft \
      \answers where 99.9 % certain: how many there are,",
      "how many of them may be wrong at most, how many should be by their own doubts, and how \
      \many are.",
      "",
      row "patch" "errors" "erased"
        ++ "   "
        ++ unwords (map padded ["right", "wrong", "refused"])
        ++ checks "answers" "at most" "expected" "wrong"
    ]

-- | The columns of the calibration.
checks :: String -> String -> String -> String -> String
checks = printf "   %10s %9s %9s %9s"

checksText :: Line -> String
checksText l =
  damageText l ++ "   "
    ++ unwords (maybe dashes (map (printf "%+7.2f")) (deviations l))
    ++ checks (show answers) (expectedAtMost answers) (brief expected) (show wrong)
  where
    Calibration answers expected wrong = lineCalibration l
    brief x = if x >= 9.995 then tenths x else short x

-- | How many of these answers may be wrong.
expectedAtMost :: Int -> String
expectedAtMost answers = tenths (0.001 * fromIntegral answers)

tenths :: Double -> String
tenths = printf "%.1f"

-- | The checks of all lines together, if there are several: the largest deviation of each kind, and
-- sums of the rest.
checksOfAll :: [Line] -> String
checksOfAll made
  | length made < 2 = ""
  | otherwise =
    printf "%-20s   " ("all" :: String)
      ++ unwords [padded (maybe "-" (printf "%.2f") (largest i)) | i <- [0 .. 2]]
      ++ checks (show answers) (expectedAtMost answers) (tenths expected) (show wrong)
      ++ "\n"
  where
    answers = sum [n | Calibration n _ _ <- calibrations]
    expected = sum [x | Calibration _ x _ <- calibrations]
    wrong = sum [n | Calibration _ _ n <- calibrations]
    calibrations = map lineCalibration made
    largest i = case [abs d | Just ds <- map deviations made, d : _ <- [drop i ds]] of
      [] -> Nothing
      ds -> Just (maximum ds)
