{-# LANGUAGE OverloadedStrings #-}

-- | A face at true scale, to be printed, cut or held beside what was made of it: an SVG file whose
-- units are millimetres.
--
-- >      C1 C2 C3 C4 of the cube       the name, and the upper left vertex marked
-- >   C1 o--------------+
-- >      | ##   ##   ## |              the outline, and the symbols black
-- >      | ##   ##   ## |
-- >      +--------------+
-- >      |--|--|--|--|--|              a ruler of 100 mm
module Picture.Template
  ( Template (..),
    templateFile,
    templateRounding,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.List (dropWhileEnd)
import Data.Text (Text)
import qualified Data.Text as Text
import Graphics.Svg
import Numeric (showFFloat)
import PraTactile.Array (Position)
import PraTactile.Emboss.Face
import PraTactile.Object.Chart (Spot (..))
import PraTactile.Object.Placement
import PraTactile.Object.Rims
import PraTactile.Object.WingedEdge

-- | A face to be drawn as a template.
data Template = Template
  { templateFace :: LaidFace,
    -- | the side of a taxel of its symbols, millimetres
    templateTaxel :: Rational,
    -- | its symbols, by their cells
    templateSymbols :: [(Position, Stamp)]
  }

-- | The file. The paper is cut so that it is a whole number of taxels from its left and upper edges
-- to the symbols: a raster of a pixel a taxel has each of them where a pixel is.
templateFile :: Template -> Lazy.ByteString
templateFile it = renderBS drawing <> "\n"
  where
    laid = templateFace it
    Face object face = laidFace laid
    taxel = fromRational (templateTaxel it) :: Double
    (boxLeft, boxTop) = spotMillimetres (laidBox laid)
    (wide, high) = spotMillimetres (laidExtent laid)
    (blockLeft, blockTop) = spotMillimetres (laidMargin laid)
    -- Where the face's first vertex is on the paper, this much room at least before the box.
    origin room from block =
      taxel * fromIntegral (ceiling ((room + block - from) / taxel) :: Int) - block
    (x0, y0) = (origin 15 boxLeft blockLeft, origin 25 boxTop blockTop)
    at (x, y) = (x0 + x, y0 + y)
    (left, top) = at (boxLeft, boxTop)
    (width, height) = (left + max wide 100 + 15, ruler + 15)
    ruler = top + high + 10
    drawing =
      with
        (svg11_ content)
        [ Width_ <<- number width <> "mm",
          Height_ <<- number height <> "mm",
          ViewBox_ <<- Text.unwords (map number [0, 0, width, height]),
          Font_family_ <<- "sans-serif",
          Font_size_ <<- "4"
        ]
    content =
      title_ [] (toElement (named <> ", " <> number wide <> " x " <> number high <> " mm"))
        <> part
          "paper"
          rect_
          [Width_ <<- number width, Height_ <<- number height, Fill_ <<- "#ffffff"]
        <> part "face" path_ ((D_ <<- foldMap (closed . map place) rimsOf) : drawnIn edge)
        <> foldMap symbol (templateSymbols it)
        <> foldMap vertex (take 1 (zip (faceVertices face) corners))
        <> said "name" (left, top - 15) (fitting named)
        <> foldMap stroke ([(left, ruler), (left + 100, ruler)] : map tick [0 .. 10])
        <> said "ruler" (left, ruler + 9) "100 mm"
    -- No letter is wider than 3.4 mm.
    fitting text
      | Text.length text <= room = text
      | otherwise = Text.take (room - 3) text <> "..."
      where
        room = floor ((width - left) / 3.4)
    named = Text.pack (faceText face ++ " of the " ++ objectText object)
    corners = map place (laidCorners laid)
    rimsOf = rims (laidCorners laid)
    place = at . spotMillimetres . snd
    stroke line = part "ruler" path_ ((D_ <<- open line) : drawnIn faint)
    tick k = let x = left + 10 * k in [(x, ruler), (x, ruler + 3)]
    vertex (name, (x, y)) =
      part "vertex" circle_ ([Cx_ <<- number x, Cy_ <<- number y, R_ <<- "1"] ++ drawnIn edge)
        <> said "vertex" (x, y - 3) (fitting (Text.pack (vertexText name)))
    symbol (cell, stamp) =
      part
        "symbol"
        path_
        [ D_ <<- foldMap (closed . map (spot . outlineSpot cell)) (stampOutlines stamp),
          Fill_ <<- "#000000",
          Fill_rule_ <<- "evenodd"
        ]
    spot found = case found of
      Lattice i j -> at (blockLeft + taxel * fromInteger i, blockTop + taxel * fromInteger j)
      Corner k -> foldr const (at (0, 0)) (drop k corners)

-- | An element of this class.
part :: Text -> ([Attribute] -> Element) -> [Attribute] -> Element
part name element attributes = "\n" <> element ((Class_ <<- name) : attributes)

-- | Words that begin there.
said :: Text -> (Double, Double) -> Text -> Element
said name (x, y) content =
  part
    name
    (\attributes -> text_ attributes (toElement content))
    [X_ <<- number x, Y_ <<- number y, Fill_ <<- faint]

-- | A line of this colour, and nothing in it.
drawnIn :: Text -> [Attribute]
drawnIn colour = [Fill_ <<- "none", Stroke_ <<- colour, Stroke_width_ <<- "0.2"]

-- | The colours of the outline and of what is beside it.
edge, faint :: Text
edge = "#1f77b4"
faint = "#999999"

-- | A closed line through these points.
closed :: [(Double, Double)] -> Text
closed points = open points <> "z"

open :: [(Double, Double)] -> Text
open points = case [number x <> "," <> number y | (x, y) <- points] of
  first : others -> "M" <> first <> Text.concat ["L" <> other | other <- others]
  [] -> ""

-- | Millimetres, to 'templateRounding'.
number :: Double -> Text
number x = Text.pack (trimmed (showFFloat (Just 5) x ""))
  where
    trimmed text = case dropWhileEnd (== '.') (dropWhileEnd (== '0') text) of
      "-0" -> "0"
      short -> short

-- | By how many millimetres a number of the file is off at most.
templateRounding :: Double
templateRounding = 5e-6
