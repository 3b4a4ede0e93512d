{-# LANGUAGE OverloadedStrings #-}

-- | A panel of the picture of the rates: the rates of one size of patch against the share of wrong
-- symbols, both on logarithmic scales.
module RatesPlot.Panel
  ( Panel (..),
    Column (..),
    What (..),
    panel,
    panelWide,
    panelHigh,

    -- * What the curves are
    Series (..),
    allSeries,
    erasuresOf,
    dashes,
    Dot (..),
    dot,

    -- * Texts and numbers
    text,
    number,
    numbers,
  )
where

import Counted (numberText)
import Data.List (nub)
import Data.Maybe (catMaybes, fromMaybe, isJust, isNothing)
import Data.Text (Text)
import qualified Data.Text as Text
import Drawing (hundredths)
import Graphics.Svg
import PraTactile.Array (Shape)
import PraTactile.Format.Name (shapeText)
import PraTactile.Format.Rates
import PraTactile.Rates

panelWide, panelHigh :: Double
panelWide = 200
panelHigh = 230

-- | What a panel shows: a share of all patches.
data What = NotRight | Wrong
  deriving stock (Eq)

whatText :: What -> String
whatText what = case what of
  NotRight -> "not located right (wrong or refused), %"
  Wrong -> "located wrong, %"

-- | A way to decode: its words, and what is drawn of it as a line and as dots.
data Series = Series
  { seriesText :: String,
    seriesLine :: What -> Line -> Maybe Double,
    seriesDots :: What -> Line -> Maybe Double
  }

allSeries :: [Series]
allSeries =
  [ Series
      "hard: line exact, dots simulated"
      (\what l -> Just (share what (fromMaybe (lineHard l) (lineExact l))))
      (simulated lineHard),
    Series
      "soft, where 99.9 % certain: dots simulated; wrong ones also by its own doubts, as a line"
      expected
      (simulated lineSoft),
    Series
      "soft, answering until as many answers are wrong as hard decoding's: simulated"
      asHard
      asHard
  ]
  where
    simulated rates what l = Just (share what (rates l))
    expected what l = case what of
      NotRight -> Just (share what (lineSoft l))
      Wrong -> Just (calibratedExpected (lineCalibration l) / fromIntegral (lineTrials l))
    asHard what l = if what == NotRight then share what <$> lineAsHard l else Nothing
    share what rates = case what of
      NotRight -> rateWrong rates + rateRefused rates
      Wrong -> rateWrong rates

-- | The decades that are shown: of a share, 10^-8 to 1.
lowest :: Double
lowest = -8

-- | The rates that are drawn in a panel, of the patches of a size, and where its upper left corner
-- is.
data Panel = Panel
  { panelLines :: [Line],
    panelX :: Double,
    panelY :: Double,
    panelSize :: Shape,
    panelWhat :: What
  }

-- | The first of a row of panels has its scale beside it.
data Column = Leftmost | Inner
  deriving stock (Eq)

-- | A share of wrong symbols, per cent, as an abscissa; the scale is that of the whole table.
across :: Panel -> Double -> Double
across p errors =
  panelX p + 14 + (panelWide - 28) * (log errors - log first) / (log final - log first)
  where
    (first, final) = case shownErrors p of
      [] -> (1, 10)
      found
        | minimum found < maximum found -> (minimum found, maximum found)
        | otherwise -> (minimum found / 2, 2 * maximum found)

shownErrors :: Panel -> [Double]
shownErrors = filter (> 0) . nub . map lineErrors . panelLines

-- | A power of ten as an ordinate.
vertical :: Panel -> Double -> Double
vertical p decade = panelY p + panelHigh * decade / lowest

panel :: Panel -> Column -> [Element]
panel p column =
  [ rect_
      [ Class_ <<- "grid",
        X_ <<- number (panelX p),
        Y_ <<- number (panelY p),
        Width_ <<- number panelWide,
        Height_ <<- number panelHigh
      ]
  ]
    ++ [ text (panelX p + panelWide / 2) (panelY p - 10) "middle" "ink" cells
         | panelWhat p == NotRight
       ]
    ++ grid p column
    ++ concat
      [ curve p i s e
        | (i, s) <- zip [0 ..] allSeries,
          e <- zip [0 ..] (erasuresOf (panelLines p))
      ]
  where
    cells = shapeText (panelSize p) ++ " cells"

-- | The lines of the scales, and what is written at them.
grid :: Panel -> Column -> [Element]
grid p column =
  concat [horizontal (vertical p (fromIntegral k)) k | k <- [0, -1 .. round lowest :: Int]]
    ++ concat [upright (across p errors) errors | errors <- shownErrors p]
    ++ [ text_
           [ Class_ <<- "ink",
             Text_anchor_ <<- "middle",
             Transform_ <<- ("translate(" <> numbers beside <> ") rotate(-90)")
           ]
           (toElement (whatText (panelWhat p)))
         | column == Leftmost
       ]
  where
    (x0, y0) = (panelX p, panelY p)
    beside = [x0 - 58, y0 + panelHigh / 2]
    horizontal y k =
      path_ [Class_ <<- "grid", D_ <<- ("M" <> numbers [x0, y] <> "h" <> number panelWide)] :
        [text (x0 - 8) (y + 4) "end" "ink" (decadeText (k + 2)) | column == Leftmost, even k]
    upright x errors =
      [ path_ [Class_ <<- "grid", D_ <<- ("M" <> numbers [x, y0 + panelHigh] <> "v5")],
        text x (y0 + panelHigh + 18) "middle" "ink" (numberText errors)
      ]

-- | A way to decode at a share of missing cells, each with its number: its line, and its dots.
curve :: Panel -> Int -> Series -> (Int, Double) -> [Element]
curve p i series (j, erasures) =
  [ polyline_ ([Class_ <<- ("line " <> lineClass), Points_ <<- points run] ++ dashes j)
    | run <- runs (map (point (seriesLine series)) drawn),
      length run > 1
  ]
    ++ [ dot (if j > 0 then Hollow lineClass else Solid (numbered "dot")) x y
         | l <- drawn,
           Just (x, y) <- [point (seriesDots series) l]
       ]
  where
    lineClass = numbered "line"
    numbered name = name <> Text.pack (show i)
    points = Text.unwords . map pair
    pair (x, y) = number x <> "," <> number y
    drawn =
      [ l
        | l <- panelLines p,
          lineSize l == panelSize p,
          lineErasures l == erasures,
          lineErrors l > 0
      ]
    point from l = case from (panelWhat p) l of
      Just s
        | s > 0, logBase 10 s >= lowest -> Just (across p (lineErrors l), vertical p (logBase 10 s))
      _ -> Nothing

-- | A dot's class: a ring with paper in it, by the class of a line, or a disc.
data Dot = Hollow Text | Solid Text

dot :: Dot -> Double -> Double -> Element
dot which x y = circle_ [Class_ <<- named, Cx_ <<- number x, Cy_ <<- number y, R_ <<- "3"]
  where
    named = case which of
      Hollow ofLine -> "paper " <> ofLine
      Solid ofDot -> ofDot

-- | The points between gaps.
runs :: [Maybe a] -> [[a]]
runs points = case span isJust (dropWhile isNothing points) of
  ([], _) -> []
  (run, others) -> catMaybes run : runs others

erasuresOf :: [Line] -> [Double]
erasuresOf = nub . map lineErasures

dashes :: Int -> [Attribute]
dashes j = case drop j ["", "6 4", "2 3", "8 3 2 3"] of
  [] -> [Stroke_dasharray_ <<- "1 5"]
  "" : _ -> []
  pattern' : _ -> [Stroke_dasharray_ <<- pattern']

-- | A power of ten, of per cent.
decadeText :: Int -> String
decadeText k
  | k >= 0 = show (10 ^ k :: Int)
  | k >= -2 = "0." ++ replicate (-k - 1) '0' ++ "1"
  | otherwise = "10\8315" ++ map raised (show (negate k))
  where
    raised digit = fromMaybe digit (lookup digit (zip ['0' ..] superscripts))
    superscripts = "\8304\185\178\179\8308\8309\8310\8311\8312\8313"

-- | A line of text of a class, from a point of its baseline that its anchor names.
text :: Double -> Double -> Text -> Text -> String -> Element
text x y anchor named words' =
  text_
    [X_ <<- number x, Y_ <<- number y, Text_anchor_ <<- anchor, Class_ <<- named]
    (toElement words')

number :: Double -> Text
number = Text.pack . hundredths

numbers :: [Double] -> Text
numbers = Text.unwords . map number
