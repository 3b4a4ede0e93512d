{-# LANGUAGE OverloadedStrings #-}

-- | The table of rates, as text, CSV and JSON.
module RatesTable
  ( Line (..),
    ways,

    -- * Text
    heading,
    lineText,
    numberText,
    checksHeading,
    checksText,
    checksOfAll,

    -- * Other forms
    csvHeading,
    lineCsv,
    lineValue,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.List (intercalate)
import Data.String (fromString)
import Json
import PraTactile.Array (Shape)
import PraTactile.LinearCode.Rates
import PraTactile.Rates
import Text.Printf (printf)

-- | A line of the table: the rates of one size and one damage.
data Line = Line
  { lineSize :: Shape,
    -- | per cent
    lineErrors :: Double,
    -- | per cent
    lineErasures :: Double,
    lineTrials :: Int,
    -- | hard decoding, simulated
    lineHard :: Rates,
    -- | the same without chance, where it can be computed
    lineExact :: Maybe Rates,
    -- | soft decoding where 99.9 % certain
    lineSoft :: Rates,
    -- | soft decoding at as many wrong answers as hard decoding; nothing to compare where it is
    -- never wrong
    lineAsHard :: Maybe Rates,
    lineCalibration :: Calibration
  }

-- | The ways to decode, by the names that other programs know, with the words over their columns.
ways :: [(String, String, Line -> Maybe Rates)]
ways =
  [ ("hard", "hard, simulated", Just . lineHard),
    ("exact", "hard, exact", lineExact),
    ("soft_999", "soft, 99.9 % certain", Just . lineSoft),
    ("soft_as_hard", "soft, wrong as hard", lineAsHard)
  ]

-- | By how many per cent more patches are answered by soft decoding at as many wrong answers, of
-- the same readings.
moreAnswers :: Line -> Maybe Double
moreAnswers l = case lineAsHard l of
  Just soft | answered (lineHard l) > 0 -> Just (100 * (answered soft / answered (lineHard l) - 1))
  _ -> Nothing
  where
    answered rates = rateRight rates + rateWrong rates

-- | By how many standard errors the simulated right, wrong and refused differ from the exact ones.
deviations :: Line -> Maybe [Double]
deviations l =
  ( \exact ->
      [deviation (rate (lineHard l)) (rate exact) | rate <- [rateRight, rateWrong, rateRefused]]
  )
    <$> lineExact l
  where
    deviation found p
      | found == p || spread <= 0 = 0
      | otherwise = (found - p) / spread
      where
        spread = sqrt (p * (1 - p) / fromIntegral (lineTrials l))

-- | The head of the table, hard decoding being to this radius.
heading :: Radius -> String
heading radius =
  unlines
    [ "Of all patches in %. Hard: from symbols, to "
        ++ reach
        ++ ". Soft: from the same cells' probabilities, answered",
      "where 99.9 % certain; and answered, the surest first, until as many are wrong as by hard \
      \decoding: 'more' is by how many % more often.",
      "",
      printf "%-6s %6s %6s" ("" :: String) ("" :: String) ("" :: String)
        ++ concat ["   " ++ centred 23 name | (_, name, _) <- ways],
      printf "%-6s %6s %6s" ("patch" :: String) ("errors" :: String) ("erased" :: String)
        ++ concat
          ( replicate
              (length ways)
              ( printf
                  "   %7s %7s %7s"
                  ("right" :: String)
                  ("wrong" :: String)
                  ("refused" :: String)
              )
          )
        ++ printf " %7s" ("more" :: String)
    ]
  where
    reach = case radius of
      Guaranteed -> "the radius that the observed cells guarantee"
      UpTo e -> "a radius of " ++ show e ++ " wrong cells, guaranteed or not"
    centred width name =
      let left =
            (width - length name) `div` 2
       in take width (replicate left ' ' ++ name ++ repeat ' ')

lineText :: Line -> String
lineText l =
  damageText l
    ++ concat
      [ "   " ++ maybe (printf "%7s %7s %7s" dash dash dash) ratesText (rates l)
        | (_, _, rates) <- ways
      ]
    ++ printf " %7s" (maybe dash (printf "%+.2f") (moreAnswers l))
  where
    ratesText (Rates a b c) =
      printf "%7.3f %7s %7s" (100 * a) (short (100 * b)) (short (100 * c)) :: String
    dash = "-" :: String

damageText :: Line -> String
damageText l =
  printf
    "%-6s %6s %6s"
    (shapeText (lineSize l))
    (numberText (lineErrors l))
    (numberText (lineErasures l))

-- | Without a fraction where there is none.
numberText :: Double -> String
numberText x
  | x == fromIntegral whole = show whole
  | otherwise = show x
  where
    whole = round x :: Int

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
      printf
        "%-6s %6s %6s   %7s %7s %7s   %10s %9s %9s %9s"
        ("patch" :: String)
        ("errors" :: String)
        ("erased" :: String)
        ("right" :: String)
        ("wrong" :: String)
        ("refused" :: String)
        ("answers" :: String)
        ("at most" :: String)
        ("expected" :: String)
        ("wrong" :: String)
    ]

checksText :: Line -> String
checksText l =
  damageText l ++ "   "
    ++ maybe (printf "%7s %7s %7s" dash dash dash) (unwords . map (printf "%+7.2f")) (deviations l)
    ++ printf
      "   %10d %9.1f %9s %9d"
      answers
      (0.001 * fromIntegral answers :: Double)
      (short' expected)
      wrong
  where
    Calibration answers expected wrong = lineCalibration l
    short' x = if x >= 9.995 then printf "%.1f" x else short x :: String
    dash = "-" :: String

-- | The same of all lines, where there are several: the largest deviation of each kind, the sums of
-- the rest.
checksOfAll :: [Line] -> String
checksOfAll made
  | length made < 2 = ""
  | otherwise =
    printf "%-20s   " ("all" :: String)
      ++ unwords [printf "%7s" (maybe "-" (printf "%.2f") (largest i) :: String) | i <- [0 .. 2]]
      ++ printf
        "   %10d %9.1f %9.1f %9d\n"
        (total (\(Calibration n _ _) -> n))
        (0.001 * fromIntegral (total (\(Calibration n _ _) -> n)) :: Double)
        (sum [x | Calibration _ x _ <- map lineCalibration made])
        (total (\(Calibration _ _ n) -> n))
  where
    total part = sum (map (part . lineCalibration) made)
    largest i = case [abs d | Just ds <- map deviations made, d : _ <- [drop i ds]] of
      [] -> Nothing
      ds -> Just (maximum ds)

csvHeading :: String
csvHeading =
  commas
    ( ["size", "errors_percent", "erasures_percent"]
        ++ [way ++ "_" ++ what | (way, _, _) <- ways, what <- outcomes]
        ++ ["soft_as_hard_more_percent"]
        ++ ["hard_standard_errors_" ++ what | what <- outcomes]
        ++ ["soft_999_answers", "soft_999_wrong_expected", "soft_999_wrong_counted"]
    )

outcomes :: [String]
outcomes = ["right", "wrong", "refused"]

lineCsv :: Line -> String
lineCsv l =
  commas
    ( [shapeText (lineSize l), show (lineErrors l), show (lineErasures l)]
        ++ concat
          [ maybe ["", "", ""] (\(Rates a b c) -> map show [a, b, c]) (rates l)
            | (_, _, rates) <- ways
          ]
        ++ [maybe "" show (moreAnswers l)]
        ++ maybe ["", "", ""] (map show) (deviations l)
        ++ [show answers, show expected, show wrong]
    )
  where
    Calibration answers expected wrong = lineCalibration l

commas :: [String] -> String
commas = intercalate ","

lineValue :: Line -> Value
lineValue l =
  object
    [ "size" .= shapeText (lineSize l),
      "errors_percent" .= lineErrors l,
      "erasures_percent" .= lineErasures l,
      "by" .= object [fromString way .= fmap ratesValue (rates l) | (way, _, rates) <- ways],
      "soft_as_hard_more_percent" .= moreAnswers l,
      "hard_standard_errors"
        .= fmap (object . zipWith (\name x -> fromString name .= x) outcomes) (deviations l),
      "soft_999_calibration"
        .= object ["answers" .= answers, "wrong_expected" .= expected, "wrong_counted" .= wrong]
    ]
  where
    ratesValue (Rates a b c) = object ["right" .= a, "wrong" .= b, "refused" .= c]
    Calibration answers expected wrong = lineCalibration l
