{-# LANGUAGE OverloadedStrings #-}

-- | The table of rates as a picture (Scalable Vector Graphics 1.1): a column of panels for each
-- size of patch; above, how many patches are not located right, below, how many are located wrong,
-- both against the share of wrong symbols and on logarithmic scales.
module RatesPlot
  ( ratesSvg,
    plotSvg,
    titleSize,
  )
where

import Counted (numberText)
import qualified Data.ByteString.Lazy as Lazy
import Data.List (nub)
import qualified Data.Text as Text
import Graphics.Svg
import PraTactile.Format.Rates
import RatesPlot.Panel
import Text.Printf (printf)

-- | The picture of a table that was made from this seed. What never happened, or less often than
-- the scale shows, is not drawn.
ratesSvg :: Int -> [Line] -> Lazy.ByteString
ratesSvg seed table = plotSvg wide high content
  where
    content =
      [ text (wide / 2) 24 "middle" "title" "Patches located from damaged readings",
        text
          (wide / 2)
          42
          "middle"
          "ink"
          (trialsText ++ "; what never happened in them is not drawn")
      ]
        ++ concat
          [ panel (Panel table (columnAt i) (rowAt j) size what) column
            | (j, what) <- zip [0 ..] [NotRight, Wrong],
              (i, size, column) <- zip3 [0 :: Int ..] sizes (Leftmost : repeat Inner)
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

left, top, gap :: Double
left = 92
top = 82
gap = 16

-- | An SVG file of that width and height with these elements on its paper.
plotSvg :: Double -> Double -> [Element] -> Lazy.ByteString
plotSvg wide high content = renderBS root <> "\n"
  where
    root =
      with
        (svg11_ (foldMap ("\n" <>) (style_ [] (toElement style) : paper : content)))
        [ Width_ <<- number wide,
          Height_ <<- number high,
          ViewBox_ <<- numbers [0, 0, wide, high],
          Font_family_ <<- "sans-serif",
          Font_size_ <<- "12"
        ]
    paper = rect_ [Class_ <<- "paper", Width_ <<- number wide, Height_ <<- number high]

-- | How high the letters of a title are.
titleSize :: Double
titleSize = 15

-- | Colours for light and for dark surroundings; the paper is drawn too, so that the two never mix.
-- The colour-blind can tell the three hues apart as well (M. Okabe and K. Ito 2002).
style :: String
style =
  rules "#ffffff" "#222222" "#d8d8d8" ["#0072b2", "#d55e00", "#009e73"]
    ++ " @media (prefers-color-scheme: dark) { "
    ++ rules "#16181c" "#e6e6e6" "#3c4048" ["#56b4e9", "#f08a3c", "#2fc79a"]
    ++ " }"
    ++ printf " .title { font-size: %.0fpx; font-weight: bold }" titleSize
    ++ " .grid { stroke-width: 1; fill: none }"
    ++ " .line { stroke-width: 2; fill: none; stroke-linejoin: round }"
  where
    rules :: String -> String -> String -> [String] -> String
    rules paper ink lines' colours =
      printf
        ".paper { fill: %s } .ink, .title { fill: %s } .plain { stroke: %s } .grid { stroke: %s }"
        paper
        ink
        ink
        lines'
        ++ concat
          [ printf " .line%d { stroke: %s } .dot%d { fill: %s }" i c i c
            | (i, c) <- zip [0 :: Int ..] colours
          ]

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
