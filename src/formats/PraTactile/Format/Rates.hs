{-# LANGUAGE OverloadedStrings #-}

-- | The table of rates as JSON and CSV. Hard decoding locates the likeliest symbol of each cell,
-- soft decoding the probabilities of all symbols.
module PraTactile.Format.Rates
  ( -- * Lines of the table
    Line (..),
    ways,
    moreAnswers,
    deviations,

    -- * The table
    RatesReport (..),
    encodeRates,
    csvHeading,
    lineCsv,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.ByteString (ByteString)
import Data.List (intercalate)
import Data.String (fromString)
import PraTactile.Array (Shape)
import PraTactile.Format.Json
import PraTactile.Format.Name
import PraTactile.Format.Profile
import PraTactile.Locate (Radius (..))
import PraTactile.Profile (Profile)
import PraTactile.Rates (Calibration (..))
import PraTactile.Rates.Formulas (Rates (..))

-- | A line of the table: the rates for patches of one size with one probability of damage.
data Line = Line
  { -- | the patch's rows and columns
    lineSize :: Shape,
    -- | the probability that the likeliest symbol of an observed cell is wrong, in per cent
    lineErrors :: Double,
    -- | the probability that a cell is not observed, in per cent
    lineErasures :: Double,
    -- | the number of simulated patches
    lineTrials :: Int,
    -- | hard decoding, simulated
    lineHard :: Rates,
    -- | hard decoding computed exactly, where that is possible
    lineExact :: Maybe Rates,
    -- | soft decoding, simulated; it answers if the answer is 99.9 % certain
    lineSoft :: Rates,
    -- | soft decoding, simulated, with the rate of wrong answers that hard decoding has; 'Nothing'
    -- if hard decoding is never wrong
    lineAsHard :: Maybe Rates,
    -- | of the answers of 'lineSoft'
    lineCalibration :: Calibration
  }
  deriving stock (Eq, Show)

-- | The ways of decoding, by name.
ways :: [(String, Line -> Maybe Rates)]
ways =
  [ ("hard", Just . lineHard),
    ("exact", lineExact),
    ("soft_999", Just . lineSoft),
    ("soft_as_hard", lineAsHard)
  ]

-- | By how many per cent soft decoding answers more patches than hard decoding, if its rate of
-- wrong answers is the same, on the same readings. 'Nothing' if 'lineAsHard' is, or if hard
-- decoding answers none.
moreAnswers :: Line -> Maybe Double
moreAnswers l = case lineAsHard l of
  Just soft | answered (lineHard l) > 0 -> Just (100 * (answered soft / answered (lineHard l) - 1))
  _ -> Nothing
  where
    answered rates = rateRight rates + rateWrong rates

-- | The differences of the simulated rates of hard decoding from the exact ones, in standard
-- errors: right, wrong, refused. 0 if a rate has no spread. 'Nothing' without exact rates.
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

-- | A table and its settings.
data RatesReport = RatesReport
  { ratesProfile :: Profile,
    -- | the number of simulated patches for each line
    ratesTrials :: Int,
    ratesSeed :: Int,
    ratesRadius :: Radius,
    ratesLines :: [Line]
  }

-- | The table as one line, without its line end.
encodeRates :: RatesReport -> ByteString
encodeRates report =
  encodeSchema "rates/1" $
    "profile" .= profileValue (ratesProfile report)
      <> "trials" .= ratesTrials report
      <> "seed" .= ratesSeed report
      <> "radius" .= stated
      <> "rates" .= map lineValue (ratesLines report)
  where
    stated = case ratesRadius report of
      Guaranteed -> Nothing
      UpTo e -> Just (naturalValue e)

-- | The column names of 'lineCsv'.
csvHeading :: String
csvHeading =
  intercalate
    ","
    ( ["size", "errors_percent", "erasures_percent"]
        ++ [way ++ "_" ++ what | (way, _) <- ways, what <- outcomes]
        ++ ["soft_as_hard_more_percent"]
        ++ ["hard_standard_errors_" ++ what | what <- outcomes]
        ++ ["soft_999_answers", "soft_999_wrong_expected", "soft_999_wrong_counted"]
    )

-- | The names of the fields of 'Rates', in their order.
outcomes :: [String]
outcomes = ["right", "wrong", "refused"]

-- | A line of the table as CSV.
lineCsv :: Line -> String
lineCsv l =
  intercalate
    ","
    ( [shapeText (lineSize l), show (lineErrors l), show (lineErasures l)]
        ++ concat
          [ maybe ["", "", ""] (\(Rates a b c) -> map show [a, b, c]) (rates l)
            | (_, rates) <- ways
          ]
        ++ [maybe "" show (moreAnswers l)]
        ++ maybe ["", "", ""] (map show) (deviations l)
        ++ [show answers, show expected, show wrong]
    )
  where
    Calibration answers expected wrong = lineCalibration l

lineValue :: Line -> Value
lineValue l =
  object
    [ "size" .= shapeText (lineSize l),
      "errors_percent" .= lineErrors l,
      "erasures_percent" .= lineErasures l,
      "by" .= object [fromString way .= fmap ratesValue (rates l) | (way, rates) <- ways],
      "soft_as_hard_more_percent" .= moreAnswers l,
      "hard_standard_errors"
        .= fmap (object . zipWith (\name x -> fromString name .= x) outcomes) (deviations l),
      "soft_999_calibration"
        .= object ["answers" .= answers, "wrong_expected" .= expected, "wrong_counted" .= wrong]
    ]
  where
    ratesValue (Rates a b c) = object ["right" .= a, "wrong" .= b, "refused" .= c]
    Calibration answers expected wrong = lineCalibration l
