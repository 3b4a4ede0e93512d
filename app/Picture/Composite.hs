{-# LANGUAGE OverloadedStrings #-}

-- | The left side of the picture of a recognition: the composite and how it was read.
module Picture.Composite
  ( compositePanel,

    -- * Symbols
    Felt (..),
    Reading (..),
    readingOf,
    readingColour,
    readingPaint,

    -- * Windows
    answeringCells,
  )
where

import Data.Text (Text)
import Drawing
import Picture.Style
import PraTactile.Geometry (columnPitch, rowPitch, symbolHeight, symbolWidth)
import PraTactile.Image (rasterHeight, rasterWidth)
import PraTactile.Recognise
import PraTactile.Recognise.Summary (shownSkew)
import PraTactile.Registration (Composite (..))
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Shape (Alphabet)
import PraTactile.Symmetry (exchangesAxes)

-- | How a symbol, or a part of one, was read.
data Reading = AsExpected | Contradicting | Unrecognised | PartOf | PartContradicting
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | How much of a symbol was felt.
data Felt = Whole | Part
  deriving stock (Eq)

-- | How a symbol was read.
readingOf :: Recognition -> Felt -> ReadSymbol -> Reading
readingOf recognition felt symbol = case felt of
  Part -> if wrong then PartContradicting else PartOf
  Whole
    | wrong -> Contradicting
    | otherwise -> maybe Unrecognised (const AsExpected) (readClass symbol)
  where
    wrong = readNumber symbol `elem` maybe [] supportWrong (recognisedSupport recognition)

readingColour :: Reading -> Text
readingColour reading = case reading of
  AsExpected -> recognised
  PartOf -> recognised
  Contradicting -> contradicting
  PartContradicting -> contradicting
  Unrecognised -> unrecognised

-- | How a symbol's box is drawn.
readingPaint :: Reading -> Paint
readingPaint reading
  | reading `elem` [PartOf, PartContradicting] =
    (outlined (readingColour reading) 3) {dashed = True, opacity = 0.6}
  | otherwise = outlined (readingColour reading) 3

-- | How many taxels wide and high the cells of the answer's window are, as the composite shows
-- them.
answeringCells :: Finding -> (Double, Double)
answeringCells found
  | exchangesAxes (foundOrientation found) = (down, across)
  | otherwise = (across, down)
  where
    cells = windowClasses (foundWindow found)
    across = columnPitch * fromIntegral (maximum (0 : map length cells))
    down = rowPitch * fromIntegral (length cells)

-- | The composite, dark where it was pressed; over it the shape of each recognised symbol in its
-- box with its element, the box of each other, and dashed what parts most likely are, beyond the
-- composite too; the cells of the window that gives the answer, and the place. A taxel of the
-- symbols has this side, millimetres.
compositePanel :: Alphabet -> (Int -> String) -> Double -> Composite -> Recognition -> Drawing
compositePanel alphabet nameOf taxel composite recognition =
  panel "What was felt" note body (unit / taxel)
  where
    note =
      show wide ++ " x " ++ show high ++ " taxels, "
        ++ millimetres wide
        ++ " x "
        ++ millimetres high
        ++ " mm"
    millimetres taxels = hundredths (taxel * fromIntegral taxels)
    (wide, high) = (rasterWidth (compositeImage composite), rasterHeight (compositeImage composite))
    -- Picture units a taxel; a symbol is large enough to be looked at, a face fits on a screen.
    unit = max 1 (min 12 (1000 / fromIntegral (maximum [wide, high, 1])))
    frame = Extent 0 0 (unit * fromIntegral wide) (unit * fromIntegral high)
    body =
      Mark "composite" (Grey (compositeImage composite) frame) :
      Mark "composite-edge" (Rectangle (outlined pale 1) frame) :
      cornerMark (0, 0) (unit * 2.5, 0) (0, unit * 2.5) :
      concatMap (symbolMarks Part) (here recognisedParts)
        ++ concatMap (symbolMarks Whole) (here recognisedSymbols)
        ++ concat
          [windowMarks unit skew found | Right (Found found) <- [recognisedAnswer recognition]]
    here part = [s | s <- part recognition, readSource s == 0]
    symbolMarks felt symbol =
      symbolMark alphabet nameOf unit skew felt (readingOf recognition felt symbol) symbol
    skew = shownSkew recognition

-- | A pixel as picture units. Pixel centres lie at integers; a pixel covers one taxel round its
-- centre.
centred :: Double -> (Double, Double) -> (Double, Double)
centred unit (x, y) = (unit * (x + 0.5), unit * (y + 0.5))

-- | The drawing of a symbol, in a composite whose symbols are turned by this angle in degrees
-- beside quarter turns.
symbolMark ::
  Alphabet -> (Int -> String) -> Double -> Double -> Felt -> Reading -> ReadSymbol -> Drawing
symbolMark alphabet nameOf unit skew felt reading symbol =
  turnedAbout at skew (shapesShown ++ [Mark "symbol" (Rectangle (readingPaint reading) box)])
    ++ [ Mark "element" (Words FromMiddle font (fst at, bottomEdge box + 2.2 * unit) label)
         | felt == Whole
       ]
  where
    shapesShown =
      concat [shapeMark "shape" surface alphabet unit orientation c at | (orientation, c) <- shown]
    colour = readingColour reading
    surface = filled colour (if felt == Part then 0.2 else 0.4)
    font = Font (2 * unit) Bold colour
    shown = if felt == Part then [readLikeliest symbol] else maybe [] pure (readClass symbol)
    label = maybe "?" (nameOf . snd) (readClass symbol)
    at = centred unit (symbolCentre (readImage symbol))
    (w, h)
      | exchangesAxes (fst (readLikeliest symbol)) = (symbolHeight, symbolWidth)
      | otherwise = (symbolWidth, symbolHeight)
    box = around (unit * fromIntegral w, unit * fromIntegral h) at

-- | The window that gives the answer, and its centre.
windowMarks :: Double -> Double -> Finding -> Drawing
windowMarks unit skew found =
  turnedAbout
    at
    skew
    [Mark "window" (Rectangle (outlined answering 4) (around (unit * w, unit * h) at))]
    ++ placeMarks at
  where
    at = centred unit (windowSeenAt (foundWindow found))
    (w, h) = answeringCells found
