-- | Mistakes in finding symbols in composites.
module PraTactile.Conformance.Impostors.Segment
  ( segmentImpostors,
  )
where

import Data.List (transpose)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question.Touch

-- | In where symbols are, and in what is one.
segmentImpostors :: [Impostor]
segmentImpostors = places ++ kinds

places :: [Impostor]
places =
  [ telling "tells-corners-for-centres" "tells where a symbol's upper left corner is" $ \_ ->
      map (\(Symbol (x, y) a) -> Symbol (x - 3.5, y - 5.5) a),
    telling "tells-rows-for-columns" "takes a symbol's row for its column" $ \_ ->
      map (\(Symbol (x, y) a) -> Symbol (y, x) a),
    telling "counts-pixels-from-one" "has 1, 1 for the upper left pixel" $ \_ ->
      map (\(Symbol (x, y) a) -> Symbol (x + 1, y + 1) a),
    telling "puts-symbols-on-a-lattice" "moves symbols to the first one's lattice" $ \_ found ->
      case found of
        Symbol (x0, y0) _ : _ ->
          [ Symbol (x0 + 16 * whole ((x - x0) / 16), y0 + 20 * whole ((y - y0) / 20)) a
            | Symbol (x, y) a <- found
          ]
        [] -> [],
    telling "calls-upright-symbols-lying" "tells axes a quarter turn off" $ \_ ->
      map (\(Symbol place a) -> Symbol place (a + 90)),
    telling "sees-every-symbol-upright" "tells an axis of 0 for every symbol" $ \_ ->
      map (\(Symbol place _) -> Symbol place 0),
    telling "knows-four-directions" "tells the nearest quarter turn for an axis" $ \_ ->
      map (\(Symbol place a) -> Symbol place (90 * whole (a / 90)))
  ]
  where
    whole t = fromInteger (round (t :: Double)) :: Double

kinds :: [Impostor]
kinds =
  [ telling "finds-upright-symbols-only" "passes over symbols that lie on their side" $ \_ ->
      filter (\(Symbol _ a) -> abs (a - 90) > 45),
    telling "overlooks-the-last-symbol" "leaves out the last symbol" $ \_ found ->
      take (length found - 1) found,
    telling "takes-cut-symbols-for-whole" "tells what the left edge cuts off as symbols" $ \rows ->
      (++ [Symbol (1, 6) 0 | uneven (concat (take 1 (transpose rows)))]),
    telling "sees-a-symbol-in-nothing" "tells a symbol where there is none" $ \rows found ->
      if null found then [Symbol (0, fromIntegral (length rows) / 2) 0] else found,
    mistouched
      "has-a-threshold-of-its-own"
      "takes grey values above 14000 for embossed where some are above 20000"
      $ \with ->
        with
          { segment = \rows ->
              segment with (if any (any (> 20000)) rows then map (map cut) rows else rows)
          },
    mistouched "segments-ragged-rows" "makes rows of several lengths alike" $ \with ->
      with
        { segment = \rows ->
            let wide = maximum (0 : map length rows)
             in segment with [take wide (row ++ repeat 0) | row <- rows]
        }
  ]
  where
    uneven column = or (zipWith (/=) column (drop 1 column))
    cut v
      | v > fullScale = v
      | otherwise = if v > 14000 then 20000 else 8000

-- | With other symbols, given the composite.
telling :: String -> String -> (Rows -> [Symbol] -> [Symbol]) -> Impostor
telling name mistake change =
  mistouched name mistake $ \with -> with {segment = \rows -> change rows <$> segment with rows}
