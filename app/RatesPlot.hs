{-# LANGUAGE DerivingStrategies #-}
-- | The table of rates as a picture: a column of panels for each size of patch; above, how many patches are not located right, below,
-- how many are located wrong, both against the share of wrong symbols and on logarithmic scales.
module RatesPlot
  ( ratesSvg
  ) where

import Data.List (nub)
import Data.Maybe (catMaybes, fromMaybe, isJust)
import Text.Printf (printf)

import Json (shapeText)
import PraTactile.Array (Shape)
import PraTactile.Locate.Rates
import PraTactile.Rates
import RatesTable

-- | The picture of a table that was made from this seed. What never happened, or less often than the scale shows, is not drawn.
ratesSvg :: Int -> [Line] -> String
ratesSvg seed table = unlines $
  [ printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\"" wide high wide high
      ++ " font-family=\"sans-serif\" font-size=\"12\">"
  , "<style>" ++ style ++ "</style>"
  , printf "<rect class=\"paper\" width=\"%g\" height=\"%g\"/>" wide high
  , text (wide / 2) 24 "middle" "title" "Patches located from damaged readings"
  , text (wide / 2) 42 "middle" "ink" (concat (nub [ show (lineTrials l) ++ " trials a dot, seed " | l <- table ]) ++ show seed
      ++ "; what never happened in them is not drawn")
  ]
    ++ concat [ panel table (left + fromIntegral i * (panelWide + gap)) (top + fromIntegral j * (panelHigh + 44)) (i == (0 :: Int)) size what
              | (j, what) <- zip [0 :: Int ..] [NotRight, Wrong], (i, size) <- zip [0 ..] sizes ]
    ++ [ text (wide / 2) (bottom + 38) "middle" "ink" "wrong symbols among the observed ones, %" ]
    ++ legend table (bottom + 62)
    ++ [ "</svg>" ]
  where
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

-- | Colours for light and for dark surroundings; the ground is drawn too, so that the two never mix. The three hues are told apart by
-- the colour-blind as well (M. Okabe and K. Ito 2002).
style :: String
style = rules "#ffffff" "#222222" "#d8d8d8" ["#0072b2", "#d55e00", "#009e73"]
  ++ " @media (prefers-color-scheme: dark) { " ++ rules "#16181c" "#e6e6e6" "#3c4048" ["#56b4e9", "#f08a3c", "#2fc79a"] ++ " }"
  ++ " .title { font-size: 15px; font-weight: bold } .grid { stroke-width: 1; fill: none }"
  ++ " .line { stroke-width: 2; fill: none; stroke-linejoin: round }"
  where
    rules paper ink grid colours =
      printf ".paper { fill: %s } .ink, .title { fill: %s } .plain { stroke: %s } .grid { stroke: %s }" paper ink ink grid
      ++ concat [ printf " .line%d { stroke: %s } .dot%d { fill: %s }" i c i c | (i, c) <- zip [0 :: Int ..] colours ] :: String

-- | What a panel shows: a share of all patches.
data What = NotRight | Wrong
  deriving stock (Eq)

whatText :: What -> String
whatText what = case what of
  NotRight -> "not located right (wrong or refused), %"
  Wrong -> "located wrong, %"

-- | A way to decode: its words, and what is drawn of it as a line and as dots.
data Series = Series
  { seriesText :: String
  , seriesLine :: What -> Line -> Maybe Double
  , seriesDots :: What -> Line -> Maybe Double
  }

allSeries :: [Series]
allSeries =
  [ Series "hard: line exact, dots simulated" (\what l -> Just (share what (fromMaybe (lineHard l) (lineExact l)))) (simulated lineHard)
  , Series "soft, where 99.9 % certain: dots simulated; wrong ones also by its own doubts, as a line" expected (simulated lineSoft)
  , Series "soft, answering until as many answers are wrong as hard decoding's: simulated" asHard asHard
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

panel :: [Line] -> Double -> Double -> Bool -> Shape -> What -> [String]
panel table x0 y0 leftmost size what =
  [ printf "<rect class=\"grid\" x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\"/>" x0 y0 panelWide panelHigh ]
    ++ [ text (x0 + panelWide / 2) (y0 - 10) "middle" "ink" (shapeText size ++ " cells") | what == NotRight ]
    ++ concat [ horizontal (vertical (fromIntegral k)) k | k <- [0, -1 .. round lowest :: Int] ]
    ++ concat [ upright (across p) p | p <- errors ]
    ++ [ printf "<text class=\"ink\" text-anchor=\"middle\" transform=\"translate(%g %g) rotate(-90)\">%s</text>"
           (x0 - 58) (y0 + panelHigh / 2) (whatText what)
       | leftmost ]
    ++ concat [ curve i s e | (i, s) <- zip [0 ..] allSeries, e <- zip [0 ..] (erasuresOf table) ]
  where
    errors = filter (> 0) (nub (map lineErrors table))
    (first, final) = case errors of
      [] -> (1, 10)
      _ | minimum errors < maximum errors -> (minimum errors, maximum errors)
        | otherwise -> (minimum errors / 2, 2 * maximum errors)
    across p = x0 + 14 + (panelWide - 28) * (log p - log first) / (log final - log first)
    vertical decade = y0 + panelHigh * decade / lowest
    horizontal y k =
      [ printf "<path class=\"grid\" d=\"M%g %.2fh%g\"/>" x0 y panelWide ]
        ++ [ text (x0 - 8) (y + 4) "end" "ink" (decadeText (k + 2)) | leftmost, even k ]
    upright x p =
      [ printf "<path class=\"grid\" d=\"M%.2f %.2fv5\"/>" x (y0 + panelHigh) ]
        ++ [ text x (y0 + panelHigh + 18) "middle" "ink" (numberText p) ]
    curve :: Int -> Series -> (Int, Double) -> [String]
    curve i series (j, erasures) =
      [ printf "<polyline class=\"line line%d\"%s points=\"%s\"/>" i (dashes j) (unwords (map (uncurry (printf "%.2f,%.2f")) run))
      | run <- runs (map (point (seriesLine series)) chosen), length run > 1 ]
        ++ [ dot (j > 0) (printf "line%d" i) (printf "dot%d" i) x y | l <- chosen, Just (x, y) <- [point (seriesDots series) l] ]
      where
        chosen = [ l | l <- table, lineSize l == size, lineErasures l == erasures, lineErrors l > 0 ]
    point from l = case from what l of
      Just s | s > 0, logBase 10 s >= lowest -> Just (across (lineErrors l), vertical (logBase 10 s))
      _ -> Nothing

-- | A dot, perhaps hollow, by the classes that colour lines and dots.
dot :: Bool -> String -> String -> Double -> Double -> String
dot hollow ofLine ofDot x y = printf "<circle class=\"%s\" cx=\"%.2f\" cy=\"%.2f\" r=\"3\"/>" (if hollow then "paper " ++ ofLine else ofDot) x y

-- | The points between gaps.
runs :: [Maybe a] -> [[a]]
runs points = case span isJust (dropWhile (not . isJust) points) of
  ([], _) -> []
  (run, others) -> catMaybes run : runs others

erasuresOf :: [Line] -> [Double]
erasuresOf = nub . map lineErasures

dashes :: Int -> String
dashes j = case drop j ["", "6 4", "2 3", "8 3 2 3"] of
  [] -> " stroke-dasharray=\"1 5\""
  "" : _ -> ""
  pattern' : _ -> " stroke-dasharray=\"" ++ pattern' ++ "\""

-- | A power of ten, of per cent.
decadeText :: Int -> String
decadeText k
  | k >= 0 = show (10 ^ k :: Int)
  | k >= -2 = "0." ++ replicate (-k - 1) '0' ++ "1"
  | otherwise = "10&#8315;" ++ concatMap raised (show (negate k))
  where
    raised digit = case digit of
      '1' -> "&#185;"
      '2' -> "&#178;"
      '3' -> "&#179;"
      _ -> "&#" ++ show (8304 + fromEnum digit - fromEnum '0') ++ ";"

legend :: [Line] -> Double -> [String]
legend table y0 = concat (zipWith entry [0 ..] (zipWith ofSeries [0 ..] allSeries ++ zipWith ofErasures [0 ..] (erasuresOf table)))
  where
    ofSeries i series = (printf "line line%d" (i :: Int), "", [], seriesText series)
    ofErasures j e = ("line plain", dashes j, [j > 0], numberText e ++ " % of the cells not observed")
    entry i (kind, dash, dots, words') =
      [ printf "<path class=\"%s\"%s d=\"M%g %gh30\"/>" (kind :: String) (dash :: String) left (y i)
      , text (left + 40) (y i + 4) "start" "ink" words' ]
      ++ [ dot hollow "plain" "ink" (left + 15) (y i) | hollow <- dots ]
    y i = y0 + 22 * fromIntegral (i :: Int)

text :: Double -> Double -> String -> String -> String -> String
text = printf "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"%s\" class=\"%s\">%s</text>"
