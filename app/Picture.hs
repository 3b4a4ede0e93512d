{-# LANGUAGE OverloadedStrings #-}

-- | A recognition as a picture: the composite on the left, its place on the object on the right,
-- the answer and the legend below.
module Picture
  ( Page (..),
    recognitionPage,
    pageDrawing,
    pageSvg,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.List (nub, sort)
import Drawing
import Drawing.Svg
import Picture.Composite
import Picture.Face
import Picture.Posed
import Picture.Style
import PraTactile.Array (Position (..))
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge (ObjectName)
import PraTactile.Pose (RigidMotion)
import PraTactile.Recognise
import PraTactile.Recognise.Summary (lieText, shownSkew, upperLeftVertex)
import PraTactile.Registration (Composite)
import PraTactile.Relief (symbolTaxel)
import PraTactile.Shape (Alphabet)
import Recognised

-- | The parts of the picture, each where it is on the page.
data Page = Page
  { pageTitle :: String,
    pageComposite :: Drawing,
    -- | empty where the answer is on no face
    pageFace :: Drawing,
    -- | empty if the object's pose is unknown
    pageObject :: Drawing,
    pageAnswer :: Drawing,
    pageLegend :: Drawing
  }

-- | The picture of a recognition of one composite, given the shapes, the elements' names, the
-- placement, the class that is embossed in each cell of a face, and how which object lies.
recognitionPage ::
  Alphabet ->
  (Int -> String) ->
  Placement ->
  (LaidFace -> Position -> Int) ->
  Maybe (ObjectName, RigidMotion) ->
  Composite ->
  Recognition ->
  Page
recognitionPage alphabet nameOf layout classesOf posed composite recognition =
  Page (recognitionMessage recognition) felt face lying answer meanings
  where
    turnedBy = shownSkew recognition
    felt =
      compositePanel alphabet nameOf (symbolTaxel (placementPitch layout)) composite recognition
    face =
      concat
        [ beside 48 felt . facePanel $
            FaceView alphabet layout laid (classesOf laid) composite found turnedBy place
          | Right (Found found) <- [recognisedAnswer recognition],
            OnFace place <- [windowWhereabouts (foundWindow found)],
            Just laid <- [placementLaid layout (placeFace place)]
        ]
    lying =
      concat
        [ beside 48 (felt ++ face) (posedPanel alphabet layout classesOf (whole, motion) place)
          | Just (object, motion) <- [posed],
            Just whole <- [placementObject layout object],
            Right (Found found) <- [recognisedAnswer recognition],
            OnFace place <- [windowWhereabouts (foundWindow found)]
        ]
    shown = felt ++ face ++ lying
    room = max 640 (width (extentOf shown))
    answer =
      beneath
        28
        shown
        ( above
            6
            ( paragraph "answer" heading (recognitionMessage recognition) :
              map (paragraph "note" plain) (notes nameOf recognition)
            )
        )
    meanings = beneath 18 (shown ++ answer) (legend room recognition)
    paragraph name font content =
      above 4 [[Mark name (Words FromLeft font (0, 0) line)] | line <- wrapped room font content]

-- | What is drawn below moved there, flush left.
beneath :: Double -> Drawing -> Drawing -> Drawing
beneath gap upper lower = shifted (leftEdge a - leftEdge b, bottomEdge a + gap - topEdge b) lower
  where
    a = extentOf upper
    b = extentOf lower

-- | The drawing of a page.
pageDrawing :: Page -> Drawing
pageDrawing page =
  concatMap ($ page) [pageComposite, pageFace, pageObject, pageAnswer, pageLegend]

-- | The page as an SVG file.
pageSvg :: Page -> Lazy.ByteString
pageSvg page = svgFile 16 (pageTitle page) (pageDrawing page)

-- | Notes on an answer, beside its place.
notes :: (Int -> String) -> Recognition -> [String]
notes nameOf recognition = case recognisedAnswer recognition of
  Right (Found found) ->
    let window = foundWindow found
        Position r c = windowPosition window
     in ( "window " ++ windowText nameOf window ++ " at row " ++ show r ++ ", column " ++ show c
            ++ " of the array; the composite is "
            ++ lieText recognition (foundOrientation found)
            ++ concat [" on the face" | OnFace _ <- [windowWhereabouts window]]
        ) :
          [ "its centre is "
              ++ hundredths x
              ++ " mm to the right of and "
              ++ hundredths y
              ++ " mm below "
              ++ upperLeftVertex (placeFace place)
            | OnFace place <- [windowWhereabouts window],
              let (x, y) = spotMillimetres (placeCentre place)
          ]
  Right (Several _ _) -> []
  Left _ -> ["no answer, so no face is drawn"]

-- | The legend of this picture.
legend :: Double -> Recognition -> Drawing
legend room recognition = flowing 10 room (map entry (readings ++ answers))
  where
    entry (swatch, words') =
      swatch ++ beside 8 swatch [Mark "legend" (Words FromLeft plain (0, 0) words')]
    box name paint = [Mark name (Rectangle paint (Extent 0 0 24 13))]
    readings =
      [ (box "legend" (readingPaint reading), readingWords likeliest reading)
        | reading <- sort (nub (read' Whole recognisedSymbols ++ read' Part recognisedParts))
      ]
    read' felt symbols = map (readingOf recognition felt) (symbols recognition)
    likeliest = case recognisedAnswer recognition of
      Right (Found _) -> "the place"
      _ -> "the likeliest place"
    answers =
      concat
        [ [ (box "legend" (outlined answering 4), "the window that gives the answer"),
            (shifted (12, 6) (placeMarks (0, 0)), "its centre, the place")
          ]
            ++ [ ( box "legend" (outlined ink 2) {dashed = True}
                     ++ [cornerMark (0, 0) (9, 0) (0, 9)],
                   "the composite's outline on the face; its upper left corner is black on both \
                   \sides"
                 )
                 | OnFace _ <- [windowWhereabouts (foundWindow found)]
               ]
          | Right (Found found) <- [recognisedAnswer recognition]
        ]

-- | What was made of a symbol, in words, with those for where it should be.
readingWords :: String -> Reading -> String
readingWords likeliest reading = case reading of
  AsExpected -> "a recognised symbol"
  Contradicting -> "a recognised symbol that contradicts " ++ likeliest
  Unrecognised -> "a symbol that was not recognised"
  PartOf -> "part of a symbol, as what it most likely is"
  PartContradicting -> "a part that contradicts " ++ likeliest
