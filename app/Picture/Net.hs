{-# LANGUAGE OverloadedStrings #-}

-- | An unfolded solid as a picture at true scale: what is cut, what is folded and to which side,
-- and which face is which.
module Picture.Net
  ( netSvg,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.List (maximumBy, sortOn)
import Data.Ord (comparing)
import Data.Text (Text)
import Drawing
import Drawing.Svg
import Picture.Style
import PraTactile.Object.Description
import PraTactile.Object.Net

-- | The picture of a net as an SVG file that is as large as the net, given its title and what is
-- raised on each face: polygons, in millimetres of the page, counter-clockwise, and those that are
-- hollow in them clockwise.
netSvg :: String -> (NetFace -> [[(Double, Double)]]) -> Net -> Lazy.ByteString
netSvg title raised net = svgToScale perMillimetre 16 title (netDrawing title raised net)

-- | Units a millimetre: as large on paper as the words of other pictures are.
perMillimetre :: Double
perMillimetre = 4

-- | The net, with a ruler and what its lines mean below.
netDrawing :: String -> (NetFace -> [[(Double, Double)]]) -> Net -> Drawing
netDrawing title raised net =
  above
    20
    [ [Mark "heading" (Words FromLeft heading (0, 0) title)],
      body,
      ruler,
      flowing 10 (max 400 (width (extentOf body))) (map entry meanings)
    ]
  where
    body =
      Mark "net" (Outline (filled paper 1) (map units (netOutline net))) :
      concatMap symbolMarks (netFaces net)
        ++ concatMap foldMark (netFolds net)
        ++ [Mark "cut" (Outline (outlined ink 2) (map units (netOutline net)))]
        ++ concat [faceMarks (null (raised face)) face | face <- netFaces net]
    symbolMarks face =
      [ Mark "symbol" (Outline (filled (if hollow loop then paper else ink) 1) (map units loop))
        | loop <- sortOn hollow (raised face)
      ]
    hollow loop = sum [x * y' - x' * y | ((x, y), (x', y')) <- cyclicPairs loop] > 0
    paper = "#f6f7f9"
    foldMark it =
      [ Mark (bendClass bend) (Line (bendPaint bend) [units from, units to])
        | let (from, to) = foldEnds it
              bend = foldBend it
      ]
    meanings =
      ("cut", outlined ink 2, "cut") :
        [ (bendClass bend, bendPaint bend, bendWords bend)
          | bend <- [Ridge, Valley, Flat],
            bend `elem` map foldBend (netFolds net)
        ]
    entry (name, paint, words') =
      let swatch = [Mark name (Line paint [(0, 6), (36, 6)])]
       in swatch ++ beside 8 swatch [Mark "legend" (Words FromLeft plain (0, 0) words')]

bendClass :: Bend -> Text
bendClass bend = case bend of
  Ridge -> "ridge"
  Valley -> "valley"
  Flat -> "flat"

bendPaint :: Bend -> Paint
bendPaint bend = case bend of
  Ridge -> outlined recognised 1.5
  Valley -> (outlined contradicting 1.5) {dashed = True}
  Flat -> outlined pale 1.5

bendWords :: Bend -> String
bendWords bend = case bend of
  Ridge -> "fold away from you"
  Valley -> "fold towards you"
  Flat -> "do not fold"

units :: (Double, Double) -> (Double, Double)
units (x, y) = (perMillimetre * x, perMillimetre * y)

-- | A face's name, if it is to be there and has room, and a mark in its upper left corner, the
-- first of its name.
faceMarks :: Bool -> NetFace -> Drawing
faceMarks withName face =
  corner
    ++ [ Mark "face" (Words FromMiddle font (x, y + 0.35 * size) name)
         | withName && size >= 2
       ]
  where
    corners = map units (netCorners face)
    name = faceText (netFaceName face)
    (x, y) = middleOf corners
    room = minimum (map (distanceFrom (x, y)) (cyclicPairs corners))
    size = min 13 (2 * room / textWidth (plain {fontSize = 1}) name)
    font = plain {fontSize = size}
    corner = case (corners, reverse corners) of
      (a : b : _, c : _) ->
        [Mark "upper-left" (Outline (filled ink 1) [a, towards a b, towards a c])]
      _ -> []
    towards (u, v) (u', v') =
      let k = min 0.25 (10 / max 1e-9 (distance (u, v) (u', v')))
       in (u + k * (u' - u), v + k * (v' - v))

-- | A point of a polygon that is far from its sides: the best of a few.
middleOf :: [(Double, Double)] -> (Double, Double)
middleOf corners =
  maximumBy (comparing room) (centroid : [p | p <- grid, inside p])
  where
    count = fromIntegral (length corners)
    centroid = (sum (map fst corners) / count, sum (map snd corners) / count)
    room p
      | inside p = minimum (map (distanceFrom p) (cyclicPairs corners))
      | otherwise = -1
    Extent l t r b = extentOf [Mark "" (Outline (filled ink 1) corners)]
    grid = [(l + i * (r - l) / 24, t + j * (b - t) / 24) | i <- [1 .. 23], j <- [1 .. 23]]
    inside (x, y) =
      odd . length $
        [ ()
          | ((x1, y1), (x2, y2)) <- cyclicPairs corners,
            (y1 > y) /= (y2 > y),
            x < x1 + (y - y1) * (x2 - x1) / (y2 - y1)
        ]

-- | How far a point is from a segment.
distanceFrom :: (Double, Double) -> ((Double, Double), (Double, Double)) -> Double
distanceFrom (x, y) ((x1, y1), (x2, y2)) = distance (x, y) (x1 + k * dx, y1 + k * dy)
  where
    (dx, dy) = (x2 - x1, y2 - y1)
    k = max 0 (min 1 (((x - x1) * dx + (y - y1) * dy) / max 1e-300 (dx * dx + dy * dy)))

distance :: (Double, Double) -> (Double, Double) -> Double
distance (x, y) (u, v) = sqrt ((u - x) ^ (2 :: Int) + (v - y) ^ (2 :: Int))

-- | A line of 100 mm, to see whether it was printed at its scale.
ruler :: Drawing
ruler =
  Mark "ruler" (Line line [(0, 0), (perMillimetre * 100, 0)]) :
  [ Mark "ruler" (Line line [(u, 0), (u, if mm `mod` 50 == 0 then -10 else -6)])
    | mm <- [0, 10 .. 100 :: Int],
      let u = perMillimetre * fromIntegral mm
  ]
    ++ [Mark "ruler" (Words FromLeft plain (perMillimetre * 100 + 8, 3) "100 mm")]
  where
    line = outlined ink 1
