-- | Pictures as SVG: a composite with the recovered symbols drawn over it; an array.
module Picture
  ( recognitionSvg
  , arraySvg
  ) where

import Text.Printf (printf)

import PraTactile.Array (Position (..))
import PraTactile.Image (Raster, rasterHeight, rasterWidth, toRows)
import PraTactile.Recognise
import PraTactile.Segment (SymbolImage (..))
import PraTactile.Shape (Alphabet, bitmapRows, shapeOf, symbolHeight, symbolWidth)
import PraTactile.Stitch (Composite (..))
import Recognised (orientationText, recognitionMessage, windowText)

-- | A composite, 12 units a taxel, dark where it is pressed; over it the shape of each recognised symbol with its element
-- (blue; orange where it contradicts the place) and the box of each that was not (red); faintly, what parts most likely are; the first window's outline, and the answer below.
recognitionSvg :: Alphabet -> (Int -> String) -> Composite -> Recognition -> String
recognitionSvg alphabet nameOf composite recognition = svg wide (high + 72) $
  taxelRects (compositeImage composite)
    ++ [ printf "<svg width=\"%g\" height=\"%g\">" wide high ] ++ concatMap partBox (recognisedParts recognition) ++ [ "</svg>" ]
    ++ concatMap symbolBox (recognisedSymbols recognition)
    ++ concat [ windowBox (foundWindow found) | Right (Found found) <- [recognisedAnswer recognition] ]
    ++ [ text 12 (high + 22) "start" 16 "#222" (recognitionMessage recognition) ]
    ++ concat [ [ text 12 (high + 43) "start" 14 "#555" (windowWords (foundWindow found))
                , text 12 (high + 63) "start" 14 "#555" ("the composite is " ++ orientationText (foundOrientation found)) ]
              | Right (Found found) <- [recognisedAnswer recognition] ]
  where
    wide = scale * fromIntegral (rasterWidth (compositeImage composite)) :: Double
    high = scale * fromIntegral (rasterHeight (compositeImage composite)) :: Double
    symbolBox symbol =
      let (x, y) = pixelCentre (symbolCentre (readImage symbol))
          colour
            | readNumber symbol `elem` wrong = "#d97706"
            | otherwise = maybe "#c0392b" (const "#1f6feb") (readClass symbol)
          label = maybe "?" (nameOf . snd) (readClass symbol)
          (w, h) = across symbol (scale * fromIntegral symbolWidth, scale * fromIntegral symbolHeight)
      in maybe [] (shapeRects colour (x, y)) (readClass symbol)
         ++ [ box x y w h colour 3
            , text x (y + h / 2 + 24) "middle" 24 colour label ]
    -- Drawn faintly: what a part most likely is.
    partBox part =
      let (x, y) = pixelCentre (symbolCentre (readImage part))
          (w, h) = across part (scale * fromIntegral symbolWidth, scale * fromIntegral symbolHeight)
      in [ "<g opacity=\"0.5\" stroke-dasharray=\"5 4\">" ] ++ shapeRects colour (x, y) (readLikeliest part) ++ [ box x y w h colour 2, "</g>" ]
      where
        colour = if readNumber part `elem` wrong then "#d97706" else "#1f6feb"
    wrong = maybe [] evidenceWrong (recognisedEvidence recognition)
    across symbol (u, v) = if isSideways (fst (readLikeliest symbol)) then (v, u) else (u, v)
    shapeRects colour (x, y) (orientation, c) =
      [ printf "<rect x=\"%.2f\" y=\"%.2f\" width=\"%g\" height=\"%g\" fill=\"%s\" fill-opacity=\"0.35\"/>" (x + du * scale - half) (y + dv * scale - half) scale scale (colour :: String)
      | Right shape <- [shapeOf alphabet c], (v, line) <- zip [0.5 ..] (bitmapRows shape), (u, True) <- zip [0.5 ..] line
      , let (du, dv) = onComposite orientation (u - 4, v - 6) ]
      where
        half = scale / 2
    -- The outermost symbols' boxes and a little more.
    windowBox window =
      let (x, y) = pixelCentre (windowSeenAt window)
          reach along size = 2 * maximum (0 : [ abs (along (pixelCentre (symbolCentre (readImage s))) - along (x, y)) | s <- recognisedSymbols recognition ]) + scale * (fromIntegral size + 3)
          (w, h) = maximum ((symbolWidth, symbolHeight) : [ (symbolHeight, symbolWidth) | s <- take 1 (recognisedSymbols recognition), isSideways (fst (readLikeliest s)) ])
      in [ box x y (reach fst w) (reach snd h) "#f0a020" 3 | length (recognisedSymbols recognition) == sum (map length (windowClasses window)) ]
    windowWords window =
      "window " ++ windowText nameOf window
        ++ " at row " ++ show (row (windowPosition window)) ++ ", column " ++ show (column (windowPosition window))

-- | Picture units a taxel.
scale :: Double
scale = 12

-- | Pixel centres lie at integers; a pixel covers one taxel round its centre.
pixelCentre :: (Double, Double) -> (Double, Double)
pixelCentre (x, y) = (scale * (x + 0.5), scale * (y + 0.5))

taxelRects :: Raster -> [String]
taxelRects image =
  [ printf "<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"rgb(%d,%d,%d)\"/>" (scale * i) (scale * j) (scale + 0.3) (scale + 0.3) grey grey grey
  | (j, line) <- zip [0 ..] (toRows image), (i, v) <- zip [0 ..] line
  , let grey = 250 - round (200 * min 1 (max 0 v)) :: Int ]

-- | An array: one cell an element, darker for a larger code.
arraySvg :: [[(Int, String)]] -> String
arraySvg cells = svg (side * fromIntegral (maximum (0 : map length cells))) (side * fromIntegral (length cells)) $ concat
  [ [ printf "<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"rgb(%d,%d,%d)\" stroke=\"#fff\"/>" (side * i) (side * j) side side grey grey grey
    , text (side * (i + 0.5)) (side * (j + 0.65)) "middle" 14 (if grey < 128 then "#fff" else "#222") name ]
  | (j, line) <- zip [0 ..] cells, (i, (code, name)) <- zip [0 ..] line
  , let grey = 235 - (180 * code) `div` max 1 top ]
  where
    side = 36 :: Double
    top = maximum (1 : map fst (concat cells))

svg :: Double -> Double -> [String] -> String
svg wide high content = unlines $
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\" font-family=\"sans-serif\">" wide high wide high
    : printf "<rect width=\"%g\" height=\"%g\" fill=\"#fff\"/>" wide high
    : content ++ ["</svg>"]

-- | A rectangle round a centre.
box :: Double -> Double -> Double -> Double -> String -> Double -> String
box x y w h colour stroke =
  printf "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" fill=\"none\" stroke=\"%s\" stroke-width=\"%g\"/>" (x - w / 2) (y - h / 2) w h colour stroke

text :: Double -> Double -> String -> Int -> String -> String -> String
text x y anchor size colour content =
  printf "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"%s\" font-size=\"%d\" font-weight=\"bold\" fill=\"%s\">%s</text>" x y anchor size colour (concatMap escaped content)
  where
    escaped c = case c of
      '<' -> "&lt;"
      '>' -> "&gt;"
      '&' -> "&amp;"
      _ -> [c]
