{-# LANGUAGE OverloadedStrings #-}

-- | Curves in panels side by side that share their scales, as Scalable Vector Graphics 1.1.
module CurvesPlot
  ( Curves (..),
    Scale (..),
    curvesSvg,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.Text (Text)
import qualified Data.Text as Text
import Drawing (Font (..), Weight (..), textWidth)
import Graphics.Svg
import RatesPlot (plotSvg, titleSize)
import RatesPlot.Panel (number, numbers, text)

-- | The curves of a plot.
data Curves = Curves
  { curvesTitle :: String,
    curvesAcross :: Scale,
    curvesUp :: Scale,
    -- | each with its title and its curves: colour, 0 to 2, and points
    curvesPanels :: [(String, [(Int, [(Double, Double)])])],
    -- | what the colours mean
    curvesLegend :: [(Int, String)]
  }

-- | An axis: its title, and the values at which a grid line stands, with their labels. The least
-- and the greatest value are the ends of the axis.
data Scale = Scale
  { scaleSays :: String,
    scaleMarks :: [(Double, String)]
  }

-- | The picture. What lies beyond a scale is drawn at its end.
curvesSvg :: Curves -> Lazy.ByteString
curvesSvg curves = plotSvg wide high content
  where
    content =
      [ text (wide / 2) 24 "middle" "title" (curvesTitle curves)
      ]
        ++ concat (zipWith (\i -> panel curves (i == 0) (placed i)) [0 ..] (curvesPanels curves))
        ++ [text (wide / 2) (top + side + 40) "middle" "ink" (scaleSays (curvesAcross curves))]
        ++ concat (zipWith entry [0 ..] (curvesLegend curves))
    entry i (colour, said) =
      [ path_ [Class_ <<- lineOf colour, D_ <<- ("M" <> numbers [placed 0, y] <> "h30")],
        text (placed 0 + 40) (y + 4) "start" "ink" said
      ]
      where
        y = top + side + 62 + 20 * fromIntegral (i :: Int)
    -- The title is wider than one panel, which then stands below its middle.
    wide = max (textWidth (Font titleSize Bold "ink") (curvesTitle curves) + 2 * gap) panelsWide
    panelsWide = left + fromIntegral (length (curvesPanels curves)) * (side + gap)
    placed i = left + (wide - panelsWide) / 2 + fromIntegral (i :: Int) * (side + gap)
    high = top + side + 62 + 20 * fromIntegral (length (curvesLegend curves))

left, top, side, gap :: Double
left = 76
top = 64
side = 220
gap = 24

-- | A panel that begins there, the first one with the words of the scale beside it.
panel :: Curves -> Bool -> Double -> (String, [(Int, [(Double, Double)])]) -> [Element]
panel curves isFirst x0 (title, drawn) =
  [ rect_
      [ Class_ <<- "grid",
        X_ <<- number x0,
        Y_ <<- number top,
        Width_ <<- number side,
        Height_ <<- number side
      ],
    text (x0 + side / 2) (top - 10) "middle" "ink" title
  ]
    ++ concat
      [ path_ [Class_ <<- "grid", D_ <<- ("M" <> numbers [x0, y] <> "h" <> number side)] :
          [text (x0 - 8) (y + 4) "end" "ink" said | isFirst]
        | (v, said) <- scaleMarks (curvesUp curves),
          let y = up v
      ]
    ++ concat
      [ [ path_ [Class_ <<- "grid", D_ <<- ("M" <> numbers [across v, top + side] <> "v5")],
          text (across v) (top + side + 18) "middle" "ink" said
        ]
        | (v, said) <- scaleMarks (curvesAcross curves)
      ]
    ++ [ text_
           [ Class_ <<- "ink",
             Text_anchor_ <<- "middle",
             Transform_ <<- ("translate(" <> numbers [x0 - 56, top + side / 2] <> ") rotate(-90)")
           ]
           (toElement (scaleSays (curvesUp curves)))
         | isFirst
       ]
    ++ [ polyline_ [Class_ <<- lineOf colour, Points_ <<- Text.unwords (map pair points)]
         | (colour, points) <- drawn
       ]
  where
    across v = x0 + side * shareOf (curvesAcross curves) v
    up v = top + side * (1 - shareOf (curvesUp curves) v)
    pair (x, y) = number (across x) <> "," <> number (up y)

lineOf :: Int -> Text
lineOf colour = "line line" <> Text.pack (show colour)

-- | How far along a scale a value lies, 0 to 1.
shareOf :: Scale -> Double -> Double
shareOf along v = max 0 (min 1 ((v - least) / max 1e-300 (greatest - least)))
  where
    values = map fst (scaleMarks along)
    least = minimum (1e300 : values)
    greatest = maximum (-1e300 : values)
