{-# LANGUAGE OverloadedStrings #-}

-- | The right side of the picture of a recognition: where on the object that is.
module Picture.Face
  ( facePanel,
    onFace,
  )
where

import Drawing
import Picture.Style
import PraTactile.Array (Position (..))
import PraTactile.Image (rasterHeight, rasterWidth)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Probe (taxelPitch)
import PraTactile.Recognise
import PraTactile.Shape (Alphabet)
import PraTactile.Stitch (Composite (..))
import PraTactile.Symmetry

-- | The face, upright and seen from outside: its vertices and its symbols, given by their classes;
-- the composite's outline as it lies there; the cells of the window that gives the answer, and how
-- far the place is from the face's upper left vertex.
facePanel ::
  Alphabet ->
  Placement ->
  LaidFace ->
  [[Int]] ->
  Composite ->
  Finding ->
  Place ->
  Drawing
facePanel alphabet layout laid classes composite found place =
  above
    12
    [ [ Mark
          "heading"
          ( Words
              FromLeft
              heading
              (0, 0)
              ("Where it is: " ++ objectText object ++ ", face " ++ faceText name)
          )
      ],
      [ Mark
          "note"
          ( Words
              FromLeft
              plain
              (0, 0)
              (hundredths across ++ " x " ++ hundredths down ++ " mm, upright, seen from outside")
          )
      ],
      body,
      scaleBar unit 20
    ]
  where
    Face object name = laidFace laid
    (across, down) = spotMillimetres (laidExtent laid)
    (x, y) = spotMillimetres (placeCentre place)
    units (right, below) = (unit * right, unit * below)
    -- Picture units a millimetre: all that is drawn fits on a screen.
    unit = min 4 (1000 / maximum [across, down, spread (map fst outline), spread (map snd outline)])
    spread line = maximum line - minimum line
    face = Extent 0 0 (unit * across) (unit * down)
    body =
      Mark "face" (Rectangle (outlined ink 2) {fillColour = "#f6f7f9"} face) :
      symbols
        ++ Mark "outline" (Outline (outlined ink 2) {dashed = True} (map units outline)) :
      cornerMark (shown (-0.5, -0.5)) (shown (2, -0.5)) (shown (-0.5, 2)) :
      Mark "window" (Rectangle (outlined answering 4) cells) :
      placeMarks (units (x, y)) ++ distances ++ concatMap vertex (faceSpots laid)
    shown = units . onFace found place
    outline = map (onFace found place) corners
    symbols =
      [ mark
        | (i, line) <- zip [0 ..] classes,
          (j, c) <- zip [0 ..] line,
          let centre = units (spotMillimetres (cellCentre layout laid (Position i j))),
          mark <-
            shapeMark "embossed" (filled pale 1) alphabet (unit * taxelPitch) identity c centre
      ]
    wide = fromIntegral (rasterWidth (compositeImage composite))
    high = fromIntegral (rasterHeight (compositeImage composite))
    corners = [(-0.5, -0.5), (wide - 0.5, -0.5), (wide - 0.5, high - 0.5), (-0.5, high - 0.5)]
    cells =
      let lines' = windowClasses (foundWindow found)
          extent side several =
            fromRational (side (placementPitch layout)) * fromIntegral (several :: Int)
          size =
            (extent pitchRight (maximum (0 : map length lines')), extent pitchDown (length lines'))
       in around (units size) (units (x, y))
    -- Beside its corner, outside; bold if it is among the nearest.
    vertex (corner', spot) =
      let (u, v) = units (spotMillimetres spot)
          font = plain {fontBold = corner' `elem` placeCorners place, fontSize = 15}
          (anchor, right) = if u > 0 then (FromLeft, 6) else (FromRight, -6)
       in onPaper
            ( Mark
                "vertex"
                (Words anchor font (u + right, v + (if v > 0 then 16 else -5)) (vertexText corner'))
            )
    distances =
      Mark "distance" (Line thin [(0, -24), (0, -32), (unit * x, -32), (unit * x, -24)]) :
      Mark "distance" (Line thin [(-28, 0), (-36, 0), (-36, unit * y), (-28, unit * y)]) :
      onPaper (Mark "distance" (Words FromMiddle plain (unit * x / 2, -38) (hundredths x ++ " mm")))
        ++ onPaper
          (Mark "distance" (Words FromRight plain (-42, unit * y / 2 + 5) (hundredths y ++ " mm")))
    -- The composite may reach beyond the face: its outline gives way to words.
    onPaper words' =
      [Mark "paper" (Rectangle (filled "#ffffff" 1) e) | Just e <- [markExtent words']] ++ [words']
    thin = outlined answering 1.5

-- | Where a pixel of the composite is on the face, in millimetres right of and below its upper left
-- vertex: the window's centre lies where the array has it, and the composite round it, turned as it
-- was.
onFace :: Finding -> Place -> (Double, Double) -> (Double, Double)
onFace found place (u, v) = (x + taxelPitch * right, y + taxelPitch * below)
  where
    (x, y) = spotMillimetres (placeCentre place)
    (u0, v0) = windowSeenAt (foundWindow found)
    (right, below) = onOffset (invert (foundOrientation found)) (u - u0, v - v0)
