{-# LANGUAGE OverloadedStrings #-}

-- | A drawing as an SVG file (Scalable Vector Graphics 1.1).
module Drawing.Svg
  ( svgFile,
    svgToScale,
    svgPage,
  )
where

import Codec.Picture (Pixel8, encodePng, generateImage)
import qualified Data.ByteString.Base64.Lazy as Base64
import qualified Data.ByteString.Lazy as Lazy
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Lazy as LazyText
import qualified Data.Text.Lazy.Encoding as LazyText
import Drawing
import Graphics.Svg
import PraTactile.Image (Raster, index, rasterHeight, rasterWidth)

-- | The SVG file of a drawing on white paper, with a margin and a title for people who do not see
-- it.
svgFile :: Double -> String -> Drawing -> Lazy.ByteString
svgFile margin title drawing = svgSized number (marginal margin drawing) title drawing

-- | The SVG file of a drawing at true scale, given its units for a millimetre and a margin.
svgToScale :: Double -> Double -> String -> Drawing -> Lazy.ByteString
svgToScale unit margin title drawing =
  svgSized (inMillimetres unit) (marginal margin drawing) title drawing

-- | The SVG file of a drawing at true scale on a page, given its units for a millimetre and the
-- width and height of the page, whose upper left corner is the origin.
svgPage :: Double -> (Double, Double) -> String -> Drawing -> Lazy.ByteString
svgPage unit (wide, high) =
  svgSized (inMillimetres unit) (Extent 0 0 (unit * wide) (unit * high))

inMillimetres :: Double -> Double -> Text
inMillimetres unit units = number (units / unit) <> "mm"

-- | The bounding box of a drawing with a margin.
marginal :: Double -> Drawing -> Extent
marginal margin drawing = Extent (l - margin) (t - margin) (r + margin) (b + margin)
  where
    Extent l t r b = extentOf drawing

-- | The SVG file of a drawing on paper of this extent, given how a length in units is written as an
-- SVG length.
svgSized :: (Double -> Text) -> Extent -> String -> Drawing -> Lazy.ByteString
svgSized sized paper title drawing = renderBS root <> "\n"
  where
    root =
      with
        (svg11_ content)
        [ Width_ <<- sized (width paper),
          Height_ <<- sized (height paper),
          ViewBox_ <<- Text.unwords (map number [0, 0, width paper, height paper]),
          Font_family_ <<- "sans-serif"
        ]
    content =
      title_ [] (toElement title)
        <> foldMap
          mark
          ( shifted
              (negate (leftEdge paper), negate (topEdge paper))
              (Mark "paper" (Rectangle (filled "#ffffff" 1) paper) : drawing)
          )

mark :: Mark -> Element
mark (Mark name form) =
  "\n" <> case form of
    Rectangle paint e -> rect_ (named : box e ++ painted paint)
    Patches paint es -> path_ ([named, D_ <<- Text.concat (map patch es)] ++ painted paint)
    Outline paint points -> polygon_ ([named, Points_ <<- listed points] ++ painted paint)
    Region paint polygons ->
      path_ ([named, D_ <<- Text.concat (map closed polygons)] ++ painted paint)
    Line paint points -> polyline_ ([named, Points_ <<- listed points] ++ painted paint)
    Grey image e
      | rasterWidth image > 0 && rasterHeight image > 0 -> image_ (named : pixels image e ++ box e)
      | otherwise -> mempty
    Words anchor font at content -> text_ (named : lettered anchor font at) (toElement content)
  where
    named = Class_ <<- name
    closed points = "M" <> listed points <> "z"
    listed points = Text.unwords [number x <> "," <> number y | (x, y) <- points]
    pixels image e =
      [PreserveAspectRatio_ <<- "none", XlinkHref_ <<- pngAddress (enlargement image e) image]

box :: Extent -> [Attribute]
box e =
  [ X_ <<- number (leftEdge e),
    Y_ <<- number (topEdge e),
    Width_ <<- number (width e),
    Height_ <<- number (height e)
  ]

-- | A rectangle as part of a path.
patch :: Extent -> Text
patch e =
  Text.concat
    [ Text.unwords ["M" <> number (leftEdge e), number (topEdge e)],
      "h" <> number (width e),
      "v" <> number (height e),
      "h" <> number (negate (width e)) <> "z"
    ]

lettered :: Anchor -> Font -> (Double, Double) -> [Attribute]
lettered anchor font (x, y) =
  [ X_ <<- number x,
    Y_ <<- number y,
    Font_size_ <<- number (fontSize font),
    Fill_ <<- fontColour font
  ]
    ++ [Text_anchor_ <<- "middle" | anchor == FromMiddle]
    ++ [Text_anchor_ <<- "end" | anchor == FromRight]
    ++ [Font_weight_ <<- "bold" | fontWeight font == Bold]

painted :: Paint -> [Attribute]
painted paint =
  [Fill_ <<- fillColour paint]
    ++ concat
      [ [Stroke_ <<- strokeColour paint, Stroke_width_ <<- number (strokeWidth paint)]
        | strokeWidth paint > 0
      ]
    ++ [Stroke_dasharray_ <<- "5 4" | dashed paint]
    ++ [Opacity_ <<- number (opacity paint) | opacity paint < 1]

number :: Double -> Text
number = Text.pack . hundredths

-- | A grey image as a data address: PNG, white for 0. Each pixel is this many pixels square: not
-- every program that shows SVG keeps them sharp when it enlarges an image.
pngAddress :: Int -> Raster -> Text
pngAddress side image =
  "data:image/png;base64,"
    <> LazyText.toStrict (LazyText.decodeLatin1 (Base64.encode (encodePng grey)))
  where
    grey = generateImage enlarged (side * rasterWidth image) (side * rasterHeight image)
    enlarged x y = shade (fromMaybe 0 (index image (x `div` side) (y `div` side)))
    shade v = 250 - round (200 * min 1 (max 0 (if isNaN v then 0 else v))) :: Pixel8

-- | How many pixels square a pixel of this image is embedded: about as large as it is shown, four
-- million pixels at most in all.
enlargement :: Raster -> Extent -> Int
enlargement image e = max 1 (min shown affordable)
  where
    shown = round (width e / fromIntegral (rasterWidth image))
    affordable =
      floor
        ( sqrt
            (4e6 / (fromIntegral (rasterWidth image) * fromIntegral (rasterHeight image))) ::
            Double
        )
