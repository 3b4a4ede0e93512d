{-# LANGUAGE OverloadedStrings #-}

-- | The array in its symbols, and where the faces of objects lie on it.
module Picture.Layout
  ( sheetSvg,
    placementSvg,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import Drawing
import Drawing.Svg
import Numeric.Natural (Natural)
import Picture.Style
import PraTactile.Array (Position (..))
import PraTactile.Geometry (columnPitch, rowPitch)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Shape (Alphabet)
import PraTactile.Symmetry
import Visible (visible)

-- | Picture units a taxel.
taxel :: Double
taxel = 2

-- | The array in its symbols as an SVG file, given the classes by rows.
sheetSvg :: Alphabet -> String -> [[Int]] -> Lazy.ByteString
sheetSvg alphabet title classes =
  svgFile 16 title (above 16 [titled title, body])
  where
    body = headers classes ++ cells ++ symbols ink alphabet classes
    cells =
      [ Mark "cell" (Rectangle (outlined pale 0.5) (cellAt r c))
        | (r, c, _) <- numbered classes
      ]

-- | The array with the cells of each face in the colour of its object, and the faces' names, as an
-- SVG file.
placementSvg :: Alphabet -> String -> [[Int]] -> Placement -> Lazy.ByteString
placementSvg alphabet title classes layout =
  svgFile 16 title $
    above
      16
      [ titled title,
        headers classes ++ body,
        flowing 10 (max 400 (width (extentOf body))) legend
      ]
  where
    body =
      [Mark "cell" (Rectangle (filled "#f6f7f9" 1) (cellAt r c)) | (r, c, _) <- numbered classes]
        ++ concatMap coloured faces
        ++ symbols "#8a9099" alphabet classes
        ++ concatMap rim faces
        ++ concatMap named faces
    faces = laidFaces layout
    objects = nub (map (faceObject . laidFace) faces)
    colours = Map.fromList (zip objects (cycle palette))
    colourOf laid = Map.findWithDefault pale (faceObject (laidFace laid)) colours
    coloured laid =
      [ Mark "taken" (Rectangle (filled (colourOf laid) 0.3) (cellAt r c))
        | Position r c <- arrayCells laid
      ]
    -- The sides of cells beyond which the face has none.
    rim laid =
      [ Mark "rim" (Line (outlined (colourOf laid) 2.5) side)
        | Position r c <- cells,
          let Extent l t r' b = cellAt r c,
          (isNext, side) <-
            [ (\(Position i j) -> i + 1 == r && j == c, [(l, t), (r', t)]),
              (\(Position i j) -> i == r + 1 && j == c, [(l, b), (r', b)]),
              (\(Position i j) -> i == r && j + 1 == c, [(l, t), (l, b)]),
              (\(Position i j) -> i == r && j == c + 1, [(r', t), (r', b)])
            ],
          not (any isNext cells)
      ]
      where
        cells = arrayCells laid
    named laid =
      [ Mark "face-ground" (Rectangle (filled "#ffffff" 0.85) ground),
        Mark "face" (Words FromMiddle font (x, y + 5) name)
      ]
      where
        name = visible (faceText (faceName (laidFace laid)))
        room =
          extentOf
            [ Mark "" (Rectangle (filled pale 1) (cellAt r c))
              | Position r c <- arrayCells laid
            ]
        (x, y) = ((leftEdge room + rightEdge room) / 2, (topEdge room + bottomEdge room) / 2)
        font = plain {fontSize = max 5 (min 15 (0.9 * width room / unitWidth))}
        unitWidth = textWidth plain {fontSize = 1} name
        ground = around (textWidth font name + 6, fontSize font + 5) (x, y)
    legend =
      [ swatch ++ beside 8 swatch [Mark "legend" (Words FromLeft plain (0, 0) name)]
        | object <- objects,
          let name = visible (objectText object)
              colour = Map.findWithDefault pale object colours
              swatch = [Mark "legend" (Rectangle (filled colour 0.3) (Extent 0 0 24 13))]
      ]

-- | Colours of objects; after the last the first again.
palette :: [Text]
palette = [recognised, contradicting, answering, unrecognised, "#8a6d00", "#3b8fc2", "#5b5b5b"]

titled :: String -> Drawing
titled title = [Mark "heading" (Words FromLeft heading (0, 0) title)]

-- | Each cell with its row and its column.
numbered :: [[a]] -> [(Natural, Natural, a)]
numbered lines' = [(r, c, one) | (r, line) <- zip [0 ..] lines', (c, one) <- zip [0 ..] line]

-- | The numbers of rows and columns, beside them.
headers :: [[a]] -> Drawing
headers lines' =
  [ Mark "row" (Words FromRight plain (l - 8, (t + b) / 2 + 5) (show r))
    | (r, _) <- zip [0 ..] lines',
      let Extent l t _ b = cellAt r 0
  ]
    ++ [ Mark "column" (Words FromMiddle plain ((l + r) / 2, t - 8) (show c))
         | line <- take 1 lines',
           (c, _) <- zip [0 ..] line,
           let Extent l t r _ = cellAt 0 c
       ]

symbols :: Text -> Alphabet -> [[Int]] -> Drawing
symbols colour alphabet classes =
  concat
    [ shapeMark "symbol" (filled colour 1) alphabet taxel identity k ((l + r') / 2, (t + b) / 2)
      | (r, c, k) <- numbered classes,
        let Extent l t r' b = cellAt r c
    ]

cellAt :: Natural -> Natural -> Extent
cellAt r c = Extent (wide * j) (high * i) (wide * (j + 1)) (high * (i + 1))
  where
    (i, j) = (fromIntegral r, fromIntegral c)
    (wide, high) = (taxel * columnPitch, taxel * rowPitch)
