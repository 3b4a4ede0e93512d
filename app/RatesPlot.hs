{-# LANGUAGE OverloadedStrings #-}

-- | The table of rates as a picture (Scalable Vector Graphics 1.1): a column of panels for each
-- size of patch; above, how many patches are not located right, below, how many are located wrong,
-- both against the share of wrong symbols and on logarithmic scales.
module RatesPlot
  ( ratesSvg,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.List (nub)
import Data.Maybe (catMaybes, fromMaybe, isJust, isNothing)
import Data.Text (Text)
import qualified Data.Text as Text
import Drawing (hundredths)
import Graphics.Svg
import Json (shapeText)
import PraTactile.Array (Shape)
import PraTactile.LinearCode.Rates
import PraTactile.Rates
import RatesTable
import Text.Printf (printf)

-- | The picture of a table that was made from this seed. What never happened, or less often than
-- the scale shows, is not drawn.
ratesSvg :: Int -> [Line] -> Lazy.ByteString
ratesSvg seed table = renderBS root <> "\n"
  where
    root =
      with
        (svg11_ (foldMap ("\n" <>) content))
        [ Width_ <<- number wide,
          Height_ <<- number high,
          ViewBox_ <<- numbers [0, 0, wide, high],
          Font_family_ <<- "sans-serif",
          Font_size_ <<- "12"
        ]
    content =
      [ style_ [] (toElement style),
        rect_ [Class_ <<- "paper", Width_ <<- number wide, Height_ <<- number high],
        text (wide / 2) 24 "middle" "title" "Patches located from damaged readings",
        text
          (wide / 2)
          42
          "middle"
          "ink"
          (trialsText ++ "; what never happened in them is not drawn")
      ]
        ++ concat
          [ panel table (columnAt i) (rowAt j) (i == 0) size what
            | (j, what) <- zip [0 ..] [NotRight, Wrong],
              (i, size) <- zip [0 :: Int ..] sizes
          ]
        ++ [text (wide / 2) (bottom + 38) "middle" "ink" "wrong symbols among the observed ones, %"]
        ++ legend table (bottom + 62)
    trialsText =
      concat (nub [show (lineTrials l) ++ " trials a dot, seed " | l <- table]) ++ show seed
    columnAt i = left + fromIntegral i * (panelWide + gap)
    rowAt j = top + fromIntegral (j :: Int) * (panelHigh + 44)
    sizes = nub (map lineSize table)
    wide = max 720 (left + fromIntegral (length sizes) * (panelWide + gap) + 8)
    bottom = top + 2 * panelHigh + 44
    high = bottom + 62 + 22 * fromIntegral (length allSeries + length (erasuresOf table))

left, top, panelWide, panelHigh, gap :: Double
left = 92
top = 82
panelWide = 200
panelHigh = 230
gap = 16

-- | Colours for light and for dark surroundings; the paper is drawn too, so that the two never mix.
-- The colour-blind can tell the three hues apart as well (M. Okabe and K. Ito 2002).
style :: String
style =
  rules "#ffffff" "#222222" "#d8d8d8" ["#0072b2", "#d55e00", "#009e73"]
    ++ " @media (prefers-color-scheme: dark) { "
    ++ rules "#16181c" "#e6e6e6" "#3c4048" ["#56b4e9", "#f08a3c", "#2fc79a"]
    ++ " }"
    ++ " .title { font-size: 15px; font-weight: bold } .grid { stroke-width: 1; fill: none }"
    ++ " .line { stroke-width: 2; fill: none; stroke-linejoin: round }"
  where
    rules :: String -> String -> String -> [String] -> String
    rules paper ink grid colours =
      printf
        ".paper { fill: %s } .ink, .title { fill: %s } .plain { stroke: %s } .grid { stroke: %s }"
        paper
        ink
        ink
        grid
        ++ concat
          [ printf " .line%d { stroke: %s } .dot%d { fill: %s }" i c i c
            | (i, c) <- zip [0 :: Int ..] colours
          ]

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

panel :: [Line] -> Double -> Double -> Bool -> Shape -> What -> [Element]
panel table x0 y0 leftmost size what =
  [ rect_
      [ Class_ <<- "grid",
        X_ <<- number x0,
        Y_ <<- number y0,
        Width_ <<- number panelWide,
        Height_ <<- number panelHigh
      ]
  ]
    ++ [ text (x0 + panelWide / 2) (y0 - 10) "middle" "ink" (shapeText size ++ " cells")
         | what == NotRight
       ]
    ++ concat [horizontal (vertical (fromIntegral k)) k | k <- [0, -1 .. round lowest :: Int]]
    ++ concat [upright (across p) p | p <- errors]
    ++ [ text_
           [ Class_ <<- "ink",
             Text_anchor_ <<- "middle",
             Transform_
               <<- ("translate(" <> numbers [x0 - 58, y0 + panelHigh / 2] <> ") rotate(-90)")
           ]
           (toElement (whatText what))
         | leftmost
       ]
    ++ concat [curve i s e | (i, s) <- zip [0 ..] allSeries, e <- zip [0 ..] (erasuresOf table)]
  where
    errors = filter (> 0) (nub (map lineErrors table))
    (first, final) = case errors of
      [] -> (1, 10)
      _
        | minimum errors < maximum errors -> (minimum errors, maximum errors)
        | otherwise -> (minimum errors / 2, 2 * maximum errors)
    across p = x0 + 14 + (panelWide - 28) * (log p - log first) / (log final - log first)
    vertical decade = y0 + panelHigh * decade / lowest
    horizontal y k =
      path_ [Class_ <<- "grid", D_ <<- ("M" <> numbers [x0, y] <> "h" <> number panelWide)] :
        [text (x0 - 8) (y + 4) "end" "ink" (decadeText (k + 2)) | leftmost, even k]
    upright x p =
      [ path_ [Class_ <<- "grid", D_ <<- ("M" <> numbers [x, y0 + panelHigh] <> "v5")],
        text x (y0 + panelHigh + 18) "middle" "ink" (numberText p)
      ]
    curve :: Int -> Series -> (Int, Double) -> [Element]
    curve i series (j, erasures) =
      [ polyline_
          ([Class_ <<- ("line " <> lineClass), Points_ <<- Text.unwords (map pair run)] ++ dashes j)
        | run <- runs (map (point (seriesLine series)) chosen),
          length run > 1
      ]
        ++ [ dot (if j > 0 then Hollow lineClass else Solid (numberedClass "dot")) x y
             | l <- chosen,
               Just (x, y) <- [point (seriesDots series) l]
           ]
      where
        lineClass = numberedClass "line"
        numberedClass name = name <> Text.pack (show i)
        pair (x, y) = number x <> "," <> number y
        chosen = [l | l <- table, lineSize l == size, lineErasures l == erasures, lineErrors l > 0]
    point from l = case from what l of
      Just s
        | s > 0,
          logBase 10 s >= lowest ->
          Just (across (lineErrors l), vertical (logBase 10 s))
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

legend :: [Line] -> Double -> [Element]
legend table y0 =
  concat
    ( zipWith
        entry
        [0 ..]
        (zipWith ofSeries [0 ..] allSeries ++ zipWith ofErasures [0 ..] (erasuresOf table))
    )
  where
    ofSeries i series = ("line line" <> Text.pack (show (i :: Int)), [], [], seriesText series)
    ofErasures j e =
      ( "line plain",
        dashes j,
        [if j > 0 then Hollow "plain" else Solid "ink"],
        numberText e ++ " % of the cells not observed"
      )
    entry i (kind, dash, dots, words') =
      [ path_ ([Class_ <<- kind, D_ <<- ("M" <> numbers [left, y i] <> "h30")] ++ dash),
        text (left + 40) (y i + 4) "start" "ink" words'
      ]
        ++ [dot which (left + 15) (y i) | which <- dots]
    y i = y0 + 22 * fromIntegral (i :: Int)

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
