{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Alphabets of shapes as text and pictures: drawings side by side, and the table of their
-- distances.
module PraTactile.Shape.Report
  ( drawAlphabet,
    distanceTable,
    renderReport,
    alphabetSvg,
  )
where

import Data.Foldable (toList)
import Data.Text (Text)
import qualified Data.Text as T
import qualified Data.Text.Lazy as LazyText
import Graphics.Svg
  ( AttrTag (..),
    Element,
    rect_,
    renderText,
    svg11_,
    text_,
    toElement,
    with,
    (<<-),
  )
import Numeric (showFFloat)
import PraTactile.Shape
import PraTactile.Shape.Design (Report (..))
import PraTactile.Shape.Distance
import PraTactile.Symmetry

-- | The shapes side by side in order of class, each under its name.
drawAlphabet :: Alphabet -> Text
drawAlphabet a =
  T.unlines (foldr (zipWith beside . drawn) (repeat "") (zip (shapeNames a) (shapes a)))
  where
    drawn (name, shape) =
      map (T.justifyLeft (max symbolWidth (T.length name)) ' ') (name : T.lines (drawBitmap shape))
    beside x "" = T.stripEnd x
    beside x rest = x <> "   " <> rest

-- | The table of distances: for every two classes (also a class with itself) the 'distance' in
-- taxels under each symmetry. Then for each class its area in taxels, which is its distance from
-- the blank box, and its greatest likeness to an ordinary feature.
distanceTable :: Alphabet -> Text
distanceTable a =
  T.unlines $
    columns ("" : map snd headings) :
    [ columns ((x <> ", " <> y) : [T.pack (show (distance s b c)) | (s, _) <- headings])
      | (i, (x, b)) <- numbered,
        (j, (y, c)) <- numbered,
        i <= j
    ]
      ++ [""]
      ++ [columns ["", "area", "likeness", "to"]]
      ++ [ columns [x, T.pack (show (area b)), T.pack (showFFloat (Just 2) l ""), T.pack (show f)]
           | (x, b) <- named,
             let (l, f) = greatestLikeness b
         ]
  where
    named = zip (shapeNames a) (shapes a)
    numbered = zip [0 :: Int ..] named
    columns = T.stripEnd . T.concat . zipWith (\w t -> T.justifyLeft w ' ' t) (12 : repeat 10)
    headings =
      [ (identity, "upright"),
        (turned 2, "turn 180"),
        (turned 1, "turn 90"),
        (turned 3, "turn 270"),
        (mirror, "mirror |"),
        (turned 2 <> mirror, "mirror -"),
        (turned 3 <> mirror, "mirror \\"),
        (turned 1 <> mirror, "mirror /")
      ]

-- | The report of a design in sentences, with the drawn shapes and their table.
renderReport :: Alphabet -> Report -> Text
renderReport a r =
  T.unlines
    [ T.pack (show (reportAdmissible r))
        <> " shapes meet the constraints, "
        <> T.pack (show (reportFamilies r))
        <> " up to a half turn and mirrors.",
      "The greatest separation of "
        <> T.pack (show (alphabetSize a))
        <> " of them is "
        <> T.pack (show (reportSeparation r))
        <> " of 96 taxels; "
        <> maybe
          "not all alphabets that have it were listed. This is the first found by seed "
          ( \count ->
              T.pack (show count)
                <> " alphabets have it. This is the one least like ordinary features, arranged by \
                   \seed "
          )
          (reportAlphabets r)
        <> T.pack (show (reportSeed r))
        <> ".",
      ""
    ]
    <> drawAlphabet a
    <> "\nLeast number of differing taxels over all shifts by at most one taxel\n"
    <> distanceTable a

-- | The shapes side by side as an SVG picture, 10 units per taxel, each with the outline of its
-- box.
alphabetSvg :: Drawings -> Text
alphabetSvg a = LazyText.toStrict (renderText root) <> "\n"
  where
    root =
      with
        ( svg11_
            (foldMap ("\n" <>) (concat (zipWith placed [0 ..] (toList a))))
        )
        [ ViewBox_ <<- T.unwords (map number [0, 0, length a * step + 40, 200]),
          Font_family_ <<- "sans-serif",
          Font_size_ <<- "20"
        ]
    step = 120
    number = T.pack . show :: Int -> Text
    rectangle x y width height =
      [X_ <<- number x, Y_ <<- number y, Width_ <<- number width, Height_ <<- number height]
    placed :: Int -> (Text, Bitmap) -> [Element]
    placed i (name, shape) =
      [ rect_
          ( rectangle x 20 (10 * symbolWidth) (10 * symbolHeight)
              ++ [Fill_ <<- "none", Stroke_ <<- "#999"]
          )
      ]
        ++ [ rect_ (rectangle (x + 10 * u) (20 + 10 * v) 10 10)
             | (v, row) <- zip [0 ..] (bitmapRows shape),
               (u, True) <- zip [0 ..] row
           ]
        ++ [ text_
               [X_ <<- number (x + 40), Y_ <<- "170", Text_anchor_ <<- "middle"]
               (toElement name)
           ]
      where
        x = i * step + 40
