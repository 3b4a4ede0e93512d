{-# LANGUAGE OverloadedStrings #-}

-- | Common parts of the pictures: colours with one meaning each, embossed shapes, a scale bar.
module Picture.Style
  ( -- * Colours
    recognised,
    contradicting,
    unrecognised,
    answering,
    ink,
    pale,

    -- * Fonts
    heading,
    plain,

    -- * Panels
    panel,

    -- * Marks
    shapeMark,
    placeMarks,
    cornerMark,
  )
where

import Data.Text (Text)
import Drawing
import PraTactile.Shape
  ( Alphabet,
    bitmapRows,
    shapeOf,
    symbolHeight,
    symbolWidth,
  )
import PraTactile.Symmetry

-- | Blue, vermilion, purple and green, which the colour-blind tell apart as well (M. Okabe and K.
-- Ito 2002).
recognised, contradicting, unrecognised, answering :: Text
recognised = "#0072b2"
contradicting = "#d55e00"
unrecognised = "#a0307c"
answering = "#00855f"

-- | Text and lines, and what is in the background.
ink, pale :: Text
ink = "#222222"
pale = "#b8bcc4"

heading, plain :: Font
heading = Font 16 Bold ink
plain = Font 13 Regular ink

-- | A side of the picture: its heading, a note, what is drawn, and a scale of this many units a
-- millimetre.
panel :: String -> String -> Drawing -> Double -> Drawing
panel title note body unit =
  above
    12
    [ [Mark "heading" (Words FromLeft heading (0, 0) title)],
      [Mark "note" (Words FromLeft plain (0, 0) note)],
      body,
      scaleBar unit 20
    ]

-- | The shape of a class round a centre, its taxels of this size, as it looks where its face lies
-- so; nothing if there is no such class.
shapeMark ::
  Text ->
  Paint ->
  Alphabet ->
  Double ->
  Symmetry ->
  Int ->
  (Double, Double) ->
  Drawing
shapeMark name paint alphabet taxel orientation c (x, y) =
  [ Mark name (Patches paint (concat (zipWith patches [0 ..] seen)))
    | Right shape <- [shapeOf alphabet c],
      let seen = onRows orientation (bitmapRows shape)
  ]
  where
    (w, h)
      | exchangesAxes orientation = (symbolHeight, symbolWidth)
      | otherwise = (symbolWidth, symbolHeight)
    patches :: Int -> [Bool] -> [Extent]
    patches v line =
      [Extent (across from) (down v) (across to) (down (v + 1)) | (from, to) <- runs 0 line]
    across u = x + taxel * (fromIntegral u - fromIntegral w / 2)
    down v = y + taxel * (fromIntegral v - fromIntegral h / 2)

-- | Where a row of taxels is embossed: from the first of a run to the one after its last, counted
-- from the number given.
runs :: Int -> [Bool] -> [(Int, Int)]
runs from line = case span not line of
  (_, []) -> []
  (flat, rest) ->
    let (run, others) = span id rest
        begin = from + length flat
        end = begin + length run
     in (begin, end) : runs end others

-- | The place that is the answer: a cross.
placeMarks :: (Double, Double) -> Drawing
placeMarks (x, y) =
  [ Mark "place" (Line line [(x - 9, y), (x + 9, y)]),
    Mark "place" (Line line [(x, y - 9), (x, y + 9)])
  ]
  where
    line = outlined answering 3

-- | A triangle in the corner of a rectangle, from the corner and two points on the sides that meet
-- there.
cornerMark :: (Double, Double) -> (Double, Double) -> (Double, Double) -> Mark
cornerMark a b c = Mark "corner" (Outline (filled ink 1) [a, b, c])

-- | A bar of this many units a millimetre and this many millimetres.
scaleBar :: Double -> Double -> Drawing
scaleBar unit millimetres =
  [ Mark
      "scale"
      (Line (outlined ink 2) [(0, -5), (0, 0), (unit * millimetres, 0), (unit * millimetres, -5)]),
    Mark
      "scale"
      (Words FromLeft plain (unit * millimetres + 8, 3) (hundredths millimetres ++ " mm"))
  ]
