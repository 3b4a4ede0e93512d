{-# LANGUAGE OverloadedStrings #-}

-- | A solid as it is seen from a direction: without its hidden parts, with its vertices' names and,
-- if they are given, the symbols on its faces.
module Picture.Solid
  ( solidSvg,
    encodedSvg,
    Shown (..),
    solidDrawing,
    onDrawing,
    Embossed,
    embossedOn,
    fewSymbols,
    onFaceOf,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import qualified Data.Text as Text
import Drawing
import Drawing.Svg
import Picture.Polygon
import Picture.Style
import PraTactile.Array (Position)
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Placement
import PraTactile.Object.View
import PraTactile.Object.WingedEdge
import PraTactile.Relief (symbolTaxel)
import PraTactile.Shape (Alphabet)
import PraTactile.Symmetry
import Text.Printf (printf)

-- | The symbols of faces, by the faces' places among those of the solid: polygons in millimetres of
-- space.
type Embossed = Map.Map Int [[(Double, Double, Double)]]

-- | A solid as it is seen.
data Shown = Shown
  { shownView :: View,
    shownSymbols :: Embossed,
    -- | the faces that stand out, by their places among those of the solid
    shownTinted :: [Int],
    -- | the greatest width and height, picture units
    shownSize :: !Double
  }

-- | A solid with its vertices' names as an SVG file, given its title.
solidSvg :: String -> View -> Solid -> Lazy.ByteString
solidSvg title view = encodedSvg title view Map.empty

-- | A solid with its symbols as an SVG file, given its title.
encodedSvg :: String -> View -> Embossed -> Solid -> Lazy.ByteString
encodedSvg title view symbols whole =
  svgFile 16 title $
    above
      16
      [ [Mark "heading" (Words FromLeft heading (0, 0) title)],
        solidDrawing (Shown view symbols [] 600) whole
      ]

-- | The drawing of a solid.
solidDrawing :: Shown -> Solid -> Drawing
solidDrawing shown whole =
  concatMap (patchMarks scale shown symbolsSeen) (patches looking)
    ++ (if null (drop mostNamed named) then concatMap (vertexMark scale) named else [])
  where
    looking = camera (shownView shown) whole
    named = seenVertices looking
    symbolsSeen = Map.map (map (map (onPicture looking))) (shownSymbols shown)
    scale = scaleOf shown whole

-- | Where more vertices are seen, none is named.
mostNamed :: Int
mostNamed = 100

-- | Where a point of space, in millimetres, is on the drawing of a solid.
onDrawing :: Shown -> Solid -> (Double, Double, Double) -> (Double, Double)
onDrawing shown whole at = (scale * x, scale * y)
  where
    (x, y) = onPicture (camera (shownView shown) whole) at
    scale = scaleOf shown whole

-- | Picture units a millimetre.
scaleOf :: Shown -> Solid -> Double
scaleOf shown whole = shownSize shown / max 1e-9 (max (width round') (height round'))
  where
    round' = extentOf [Mark "" (Outline (filled ink 1) corners)]
    corners = concatMap (map fst . patchCorners) (patches (camera (shownView shown) whole))

-- | A part of a face, what is embossed on it, and those of its sides that are edges.
patchMarks :: Double -> Shown -> Map.Map Int [[(Double, Double)]] -> VisiblePart -> Drawing
patchMarks scale shown symbols patch =
  Mark "face" (Outline paint (map units corners)) :
  [ Mark "embossed" (Region (filled ink 1) (map (map units) parts))
    | let parts =
            filter
              ((> 2) . length)
              (map (within corners) (Map.findWithDefault [] (patchFace patch) symbols)),
      not (null parts)
  ]
    ++ [ Mark "edge" (Line (outlined colour thickness) [units p, units q])
         | ((p, side), (q, _)) <- cyclicPairs (patchCorners patch),
           (colour, thickness) <- case side of
             Bent -> [(ink, 1.5)]
             Level -> [(pale, 1)]
             Cut -> []
       ]
  where
    corners = map fst (patchCorners patch)
    units (x, y) = (scale * x, scale * y)
    shade = round (160 + 90 * patchLight patch) :: Int
    (red, green, blue)
      | patchFace patch `elem` shownTinted shown = (shade - 60, shade, shade - 30)
      | otherwise = (shade - 12, shade - 5, min 255 (shade + 4))
    surface = Text.pack (printf "rgb(%d,%d,%d)" red green blue)
    -- Parts of one face have no gap between them.
    paint
      | patchWhole patch = filled surface 1
      | otherwise = (filled surface 1) {strokeColour = surface, strokeWidth = 0.7}

-- | A vertex's name where the edges that are seen from it leave the most room.
vertexMark :: Double -> SeenVertex -> Drawing
vertexMark scale vertex =
  [ Mark "vertex-ground" (Rectangle (filled "#ffffff" 0.8) ground),
    Mark "vertex" (Words FromMiddle font (x, y) name)
  ]
  where
    name = vertexText (seenName vertex)
    font = plain {fontWeight = Bold}
    (u, v) = seenAt vertex
    angles = sort [atan2 (v' - v) (u' - u) | (u', v') <- seenEdges vertex]
    gaps = [(b - a, (a + b) / 2) | (a, b) <- zip angles (drop 1 angles ++ again)]
    again = map (+ (2 * pi)) (take 1 angles)
    free = maybe 0 snd (listToMaybe (reverse (sort gaps)))
    away = 11 + textWidth font name / 2 * abs (cos free)
    (x, y) = (scale * u + away * cos free, scale * v + away * sin free + 5)
    ground = around (textWidth font name, 15) (x, y - 5)

-- | Whether the faces of an object have at most this many symbols.
fewSymbols :: Int -> Placement -> Solid -> Bool
fewSymbols most layout whole = null (drop most (concatMap blockOf' (laidFaces layout)))
  where
    blockOf' laid
      | faceObject (laidFace laid) == solidName whole = blockCells (laidBlock laid)
      | otherwise = []

-- | The embossed symbols on the faces of an object, given the shapes and the class in each cell of
-- a face.
embossedOn :: Alphabet -> Placement -> (LaidFace -> Position -> Int) -> Solid -> Embossed
embossedOn alphabet layout classesOf whole =
  Map.fromList
    [ (number, concatMap (symbolOn laid) (blockCells (laidBlock laid)))
      | laid <- laidFaces layout,
        faceObject (laidFace laid) == solidName whole,
        (number, face) <- zip [0 ..] (solidFaces whole),
        sameFace face (faceName (laidFace laid))
    ]
  where
    taxel = symbolTaxel (placementPitch layout)
    symbolOn laid cell =
      [ map (onFaceOf whole (faceName (laidFace laid))) [(l, t), (r, t), (r, b), (l, b)]
        | Mark _ (Patches _ runs) <-
            shapeMark
              ""
              (filled ink 1)
              alphabet
              taxel
              identity
              (classesOf laid cell)
              (spot laid cell),
          Extent l t r b <- runs
      ]
    spot laid = spotMillimetres . cellCentre layout laid

-- | A point of a face, in millimetres right of and below the first vertex of its name, in space.
onFaceOf :: Solid -> FaceName -> (Double, Double) -> (Double, Double, Double)
onFaceOf whole name (right, down) = case (corners, reverse corners) of
  (o@(ox, oy, oz) : _, p : _) ->
    let (ux, uy, uz) = unit (p `less` o)
        arms = map (`less` o) corners
        n = unit (foldr added (0, 0, 0) [a `cross` b | (a, b) <- cyclicPairs arms])
        (vx, vy, vz) = (ux, uy, uz) `cross` n
     in (ox + right * ux + down * vx, oy + right * uy + down * vy, oz + right * uz + down * vz)
  _ -> (0, 0, 0)
  where
    corners =
      [ (fromRational x, fromRational y, fromRational z)
        | vertex <- faceVertices name,
          Just (Point x y z) <- [lookup vertex (solidVertices whole)]
      ]
    less (a, b, c) (d, e, f) = (a - d, b - e, c - f)
    added (a, b, c) (d, e, f) = (a + d, b + e, c + f)
    cross (a, b, c) (d, e, f) = (b * f - c * e, c * d - a * f, a * e - b * d)
    unit (a, b, c) = let long = sqrt (a * a + b * b + c * c) in (a / long, b / long, c / long)
