{-# LANGUAGE OverloadedStrings #-}

-- | The right side of the picture of a recognition: the place on the object.
module Picture.Face
  ( FaceView (..),
    facePanel,
    onFace,
  )
where

import Drawing
import Picture.Style
import PraTactile.Array (Position)
import PraTactile.Explore (fillsBox)
import PraTactile.Image (rasterHeight, rasterWidth)
import PraTactile.Object.Placement
import PraTactile.Object.Rims
import PraTactile.Object.WingedEdge
import PraTactile.Recognise
import PraTactile.Registration (Composite (..))
import PraTactile.Relief (symbolTaxel)
import PraTactile.Sensor.Frame (Motion (..), movePoint)
import PraTactile.Shape (Alphabet)
import PraTactile.Symmetry

-- | The data for drawing a face.
data FaceView = FaceView
  { viewAlphabet :: Alphabet,
    viewLayout :: Placement,
    viewFace :: LaidFace,
    -- | the classes of its symbols, by row and column
    viewClasses :: Position -> Int,
    viewComposite :: Composite,
    viewFinding :: Finding,
    -- | by how many degrees, clockwise, the composite shows it turned beside quarter turns
    viewSkew :: Double,
    viewPlace :: Place
  }

-- | The face, upright and seen from outside: its vertices and its symbols; the composite's outline
-- as it lies there; the cells of the window that gives the answer, and how far the place is from
-- the face's upper left vertex.
facePanel :: FaceView -> Drawing
facePanel view = panel title note body (unitOf view)
  where
    Face object name = laidFace (viewFace view)
    (across, down) = faceExtent view
    title = "Where it is: " ++ objectText object ++ ", face " ++ faceText name
    note = hundredths across ++ " x " ++ hundredths down ++ " mm, upright, seen from outside"
    faceShape paint
      | fillsBox (viewFace view) =
        Rectangle paint (Extent 0 0 (unitOf view * across) (unitOf view * down))
      | [_] <- outlines = Outline paint (concat outlines)
      | otherwise = Region paint outlines
    outlines = map (map (shownAt . spotMillimetres . snd)) loops
    loops = rims (laidCorners (viewFace view))
    shownAt = units view
    centre = shownAt (spotMillimetres (placeCentre (viewPlace view)))
    shown = shownAt . onFace view
    body =
      Mark "face" (faceShape (outlined ink 2) {fillColour = "#f6f7f9"}) :
      symbolMarks view
        ++ Mark "outline" (Outline (outlined ink 2) {dashed = True} (map shownAt (outline view))) :
      cornerMark (shown (-0.5, -0.5)) (shown (2, -0.5)) (shown (-0.5, 2)) :
      Mark "window" (Rectangle (outlined answering 4) (around (shownAt (windowSize view)) centre)) :
      placeMarks centre
        ++ distanceMarks view
        ++ concatMap (vertexMark view) (concat loops)

-- | Width and height, millimetres.
faceExtent :: FaceView -> (Double, Double)
faceExtent = spotMillimetres . laidExtent . viewFace

-- | Picture units a millimetre: all that is drawn fits on a screen.
unitOf :: FaceView -> Double
unitOf view = min 4 (1000 / maximum [across, down, spread fst, spread snd])
  where
    (across, down) = faceExtent view
    spread side = let found = map side (outline view) in maximum found - minimum found

-- | Millimetres on the face, in picture units.
units :: FaceView -> (Double, Double) -> (Double, Double)
units view (right, below) = (unitOf view * right, unitOf view * below)

-- | The corners of the composite as it lies on the face, millimetres.
outline :: FaceView -> [(Double, Double)]
outline view =
  map
    (onFace view)
    [(-0.5, -0.5), (wide - 0.5, -0.5), (wide - 0.5, high - 0.5), (-0.5, high - 0.5)]
  where
    wide = fromIntegral (rasterWidth (compositeImage (viewComposite view)))
    high = fromIntegral (rasterHeight (compositeImage (viewComposite view)))

-- | The embossed symbols; none on a face so large that they would be smaller than can be seen.
symbolMarks :: FaceView -> Drawing
symbolMarks view
  | taxel < 1 / 2 = []
  | otherwise =
    concat
      [ shapeMark "embossed" (filled pale 1) (viewAlphabet view) taxel identity c (centre cell)
        | cell <- blockCells (laidBlock (viewFace view)),
          let c = viewClasses view cell
      ]
  where
    taxel = unitOf view * taxelOf view
    centre = units view . spotMillimetres . cellCentre (viewLayout view) (viewFace view)

-- | A taxel of the symbols, millimetres on the face.
taxelOf :: FaceView -> Double
taxelOf = symbolTaxel . placementPitch . viewLayout

-- | Width and height of the cells of the answer's window, millimetres.
windowSize :: FaceView -> (Double, Double)
windowSize view = (extent pitchRight wide, extent pitchDown (length cells))
  where
    wide = maximum (0 : map length cells)
    cells = windowClasses (foundWindow (viewFinding view))
    extent side several =
      fromRational (side (placementPitch (viewLayout view))) * fromIntegral several

-- | A vertex beside its corner, outside; bold if it is among the nearest.
vertexMark :: FaceView -> (VertexName, Spot) -> Drawing
vertexMark view (name, spot) =
  onPaper (Mark "vertex" (Words anchor font (u + right, v + below) (vertexText name)))
  where
    weight = if name `elem` placeCorners (viewPlace view) then Bold else Regular
    below = if v > 0 then 16 else -5
    (u, v) = units view (spotMillimetres spot)
    font = plain {fontWeight = weight, fontSize = 15}
    (anchor, right) = if u > 0 then (FromLeft, 6) else (FromRight, -6)

-- | How far the place is from the upper left vertex.
distanceMarks :: FaceView -> Drawing
distanceMarks view =
  [ Mark "distance" (Line thin [(0, -24), (0, -32), (u, -32), (u, -24)]),
    Mark "distance" (Line thin [(-28, 0), (-36, 0), (-36, v), (-28, v)])
  ]
    ++ onPaper (Mark "distance" (Words FromMiddle plain (u / 2, -38) (hundredths x ++ " mm")))
    ++ onPaper (Mark "distance" (Words FromRight plain (-42, v / 2 + 5) (hundredths y ++ " mm")))
  where
    (x, y) = spotMillimetres (placeCentre (viewPlace view))
    (u, v) = units view (x, y)
    thin = outlined answering 1.5

-- | The composite may reach beyond the face: its outline gives way to words.
onPaper :: Mark -> Drawing
onPaper text =
  [Mark "paper" (Rectangle (filled "#ffffff" 1) e) | Just e <- [markExtent text]] ++ [text]

-- | Where a pixel of the composite is on the face, in millimetres right of and below its upper left
-- vertex: the window's centre lies where the array has it, and the composite round it, turned as it
-- was.
onFace :: FaceView -> (Double, Double) -> (Double, Double)
onFace view (u, v) = (x + taxelOf view * right, y + taxelOf view * below)
  where
    (skew, found, place) = (viewSkew view, viewFinding view, viewPlace view)
    (x, y) = spotMillimetres (placeCentre place)
    (u0, v0) = windowSeenAt (foundWindow found)
    (right, below) = onOffset (invert (foundOrientation found)) level
    level = movePoint (Motion (negate skew) 0 0) (u - u0, v - v0)
