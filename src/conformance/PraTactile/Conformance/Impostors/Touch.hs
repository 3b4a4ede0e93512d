{-# LANGUAGE GADTs #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Impostors of registration, stitching and segmentation.
module PraTactile.Conformance.Impostors.Touch
  ( alphabetImpostors,
    registerImpostors,
    stitchImpostors,
    segmentImpostors,
  )
where

import Data.List (minimumBy)
import Data.Ord (comparing)
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question

-- | Mistakes about the shapes of the symbols.
alphabetImpostors :: [Impostor]
alphabetImpostors =
  [ withoutProfileOtherwise "knows-one-alphabet" "takes all shapes for the usual ones" $
      \right question -> case question of
        Register :? (_, pair) -> right (Register :? (Nothing, pair))
        Stitch :? (_, search, frames) -> right (Stitch :? (Nothing, search, frames))
        _ -> right question
  ]

-- | Mistakes in a frame's displacement, and in the reasons of refusals.
registerImpostors :: [Impostor]
registerImpostors =
  [ registered "registers-rows-for-columns" "takes down for right and right for down" $ \_ found ->
      let (x, y) = registeredBest found in found {registeredBest = (y, x)},
    registered "compares-grey-values" "compares grey values as they are" $ \pair found ->
      if registeredReason found == Nothing
        then found {registeredBest = leastDifference pair}
        else found,
    registered "registers-whatever-comes" "refuses nothing" $ \_ found ->
      found {registeredReason = Nothing, registeredFixed = (True, True)},
    withoutProfileOtherwise "takes-the-least-frame" "cuts frames of two sizes to what both have" $
      \right question -> case question of
        Register :? (shapes, pair) ->
          let (a, b) = (pairFirst pair, pairSecond pair)
              cut rows = map (take (least width)) (take (least length) rows)
              least f = min (f a) (f b)
              width rows = length (concat (take 1 rows))
           in right (Register :? (shapes, pair {pairFirst = cut a, pairSecond = cut b}))
        _ -> right question
  ]
  where
    registered :: String -> String -> (Pair -> Registered -> Registered) -> Impostor
    registered name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Register :? (_, pair) -> change pair <$> right question
        _ -> right question

-- | The whole displacement within the search with the least mean squared difference.
leastDifference :: Pair -> Taxels
leastDifference (Pair a b (sx, sy) search) =
  minimumBy
    (comparing difference)
    [(fromInteger x, fromInteger y) | x <- around sx, y <- around sy]
  where
    around s = [s - toInteger search .. s + toInteger search]
    difference (x, y) =
      let both =
            [ (fromIntegral u - fromIntegral v) ^ (2 :: Int)
              | (rowA, rowB) <- zip (from (round y) a) (from (negate (round y)) b),
                (u, v) <- zip (from (round x) rowA) (from (negate (round x)) rowB)
            ]
       in if null both then 1 / 0 else sum both / fromIntegral (length both) :: Double
    from :: Int -> [a] -> [a]
    from n = drop (max 0 n)

-- | Mistakes in the displacements of frames from their nominal places.
stitchImpostors :: [Impostor]
stitchImpostors =
  [ stitched "stitches-nothing" "leaves every frame where it should be" $ \_ _ -> (0, 0),
    stitched "stretches-the-robot" "takes the robot's taxels for 5 % longer than they are" $
      \(NominalFrame _ (px, py)) (x, y) -> (x + 0.05 * fromInteger px, y + 0.05 * fromInteger py),
    withoutProfileOtherwise "stitches-frames-of-any-size" "cuts frames of two sizes alike" $
      \right question -> case question of
        Stitch :? (shapes, search, frames) ->
          let high = minimum (256 : [length rows | NominalFrame rows _ <- frames])
              wide = minimum (256 : [length row | NominalFrame rows _ <- frames, row <- rows])
              cut (NominalFrame rows place) = NominalFrame (map (take wide) (take high rows)) place
           in right (Stitch :? (shapes, search, map cut frames))
        _ -> right question
  ]
  where
    stitched :: String -> String -> (NominalFrame -> Taxels -> Taxels) -> Impostor
    stitched name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Stitch :? (_, _, frames) -> zipWith change frames <$> right question
        _ -> right question

-- | Mistakes in finding symbols and their places.
segmentImpostors :: [Impostor]
segmentImpostors =
  [ segmented "tells-corners-for-centres" "tells where a symbol's upper left corner is" $ \_ ->
      map (\(Symbol (x, y) a) -> Symbol (x - 3.5, y - 5.5) a),
    segmented "finds-upright-symbols-only" "passes over symbols that lie on their side" $ \_ ->
      filter (\(Symbol _ a) -> abs (a - 90) > 45),
    segmented "sees-a-symbol-in-nothing" "tells a symbol where there is none" $ \rows found ->
      if null found then [Symbol (0, fromIntegral (length rows) / 2) 0] else found,
    changed
      "has-a-threshold-of-its-own"
      "takes grey values above 14000 for embossed where some are above 20000"
      $ \rows -> if any (any (> 20000)) rows then map (map cut) rows else rows,
    changed "segments-ragged-rows" "makes rows of several lengths alike" $ \rows ->
      let wide = maximum (0 : map length rows) in [take wide (row ++ repeat 0) | row <- rows]
  ]
  where
    segmented :: String -> String -> (Rows -> [Symbol] -> [Symbol]) -> Impostor
    segmented name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Segment :? rows -> change rows <$> right question
        _ -> right question
    changed :: String -> String -> (Rows -> Rows) -> Impostor
    changed name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Segment :? rows -> right (Segment :? change rows)
        _ -> right question
    cut v
      | v > fullScale = v
      | otherwise = if v > 14000 then 20000 else 8000
