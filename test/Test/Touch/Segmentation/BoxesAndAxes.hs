-- | Tests boxes, their neighbourhood and their mapping back to the composite, over all small
-- distances.
module Test.Touch.Segmentation.BoxesAndAxes (spec) where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import PraTactile.Image
import PraTactile.Registration (compositeOf)
import PraTactile.Segmentation
import PraTactile.Segmentation.Box
import PraTactile.Segmentation.Lattice
import PraTactile.Segmentation.Masked
import PraTactile.Symmetry
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)

spec :: Spec
spec = do
  describe "Extents" extents
  describe "Pieces of one thing" together
  describe "Along an axis" along
  describe "Neighbours" neighbours

extents :: Spec
extents = do
  it "of a rectangle are its sides, to the fraction that the pixels at its edges are covered" $
    forAll rectangle $ \(l, t, r, b) ->
      let pixels = pixelsOf (covered (l, t, r, b))
          region = touchedWhere (>= 0.5) pixels
       in conjoin
            [ near (horizontalExtent pixels 0.5 region) (l - 0.5) (r - 0.5),
              near (verticalExtent pixels 0.5 region) (t - 0.5) (b - 0.5)
            ]
  it "change by at most half a pixel where a line of one to three pixels sticks out" $
    [ (k, side, movedBy (measuredBy k side))
      | k <- [1 .. 4],
        side <- [0 .. 3]
    ]
      `shouldSatisfy` all
        ( \(k, side, moves) ->
            and
              [ if i /= side then move == 0 else if k <= 3 then move <= 0.5 else move == 3.5
                | (i, move) <- zip [0 ..] moves
              ]
        )
  it "are completed from the other side if one is open and more than half a pixel is missing" $
    [ ( (missing, open, open'),
        fitted 1.6 8 (Extent (Side 10 open) (Side (18 - missing) open'))
      )
      | missing <- [-1.75, -1.5, -0.75, -0.25, 0, 0.25, 0.5, 0.75, 1.5, 1.75],
        open <- [False, True],
        open' <- [False, True]
    ]
      `shouldBe` [ ( (missing, open, open'),
                     if abs missing > 1.6
                       then Nothing
                       else Just $ case (missing > 0.5, open, open') of
                         (True, True, False) -> 14 - missing
                         (True, False, True) -> 14
                         _ -> 14 - missing / 2
                   )
                   | missing <- [-1.75, -1.5, -0.75, -0.25, 0, 0.25, 0.5, 0.75, 1.5, 1.75],
                     open <- [False, True],
                     open' <- [False, True]
                 ]
  where
    rectangle = do
      l <- choose (3, 8)
      t <- choose (3, 8)
      w <- choose (4, 10)
      h <- choose (4, 10)
      pure (l, t, l + w, t + h)
    near found from to = case found of
      Just (Extent (Side a False) (Side b False)) ->
        counterexample (show (a, b, from, to)) (abs (a - from) < 0.51 && abs (b - to) < 0.51)
      other -> counterexample (show other) False
    -- Pixel i reaches from i to i + 1 here, and its centre is at i + 1/2.
    covered (l, t, r, b) x y = share l r x * share t b y
    share from to i = max 0 (min to (fromIntegral i + 1) - max from (fromIntegral i)) :: Double
    pixelsOf value = masked (compositeOf (generate 31 31 value))
    -- A box of 8 x 12 pixels from (10, 10) with a line of k pixels that sticks out of one side.
    measuredBy :: Int -> Int -> [Double]
    measuredBy k side =
      let line i = case side of
            0 -> (9 - i, 14)
            1 -> (18 + i, 14)
            2 -> (13, 9 - i)
            _ -> (13, 22 + i)
          raised =
            Set.fromList ([(x, y) | x <- [10 .. 17], y <- [10 .. 21]] ++ map line [0 .. k - 1])
          pixels = pixelsOf $ \x y ->
            if Set.notMember (x, y) raised then 0 else if inBox (x, y) then 1 else 0.9
          inBox (x, y) = x >= 10 && x <= 17 && y >= 10 && y <= 21
          ends extent = case extent of
            Just (Extent a b) -> (sidePlace a, sidePlace b)
            Nothing -> (0, 0)
          (left, right) = ends (horizontalExtent pixels 0.5 region)
          (top, bottom) = ends (verticalExtent pixels 0.5 region)
          region = touchedWhere (>= 0.5) pixels
       in [left, right, top, bottom]
    movedBy = zipWith (\a b -> abs (a - b)) [9.5, 17.5, 9.5, 21.5]

together :: Spec
together =
  it "pieces with two flat rows or columns between them are one thing, with three they are two" $
    [ ( flat,
        [ length (segmentedRejects s) + length (segmentedSymbols s)
          | (dx, dy) <- [(4 + flat, 0), (0, 4 + flat), (4 + flat, 4 + flat)],
            let s =
                  segment
                    (compositeOf (drawn [(10, 10, 4, 4), (10 + dx, 10 + dy, 4, 4)]))
        ]
      )
      | flat <- [1 .. 4]
    ]
      `shouldBe` [(1, [1, 1, 1]), (2, [1, 1, 1]), (3, [2, 2, 2]), (4, [2, 2, 2])]

-- | Rectangles (x, y, width, height) on a flat ground of 40 x 48.
drawn :: [(Int, Int, Int, Int)] -> Raster
drawn rectangles =
  generate 40 48 $ \x y ->
    if or [x >= l && x < l + w && y >= t && y < t + h | (l, t, w, h) <- rectangles] then 1 else 0

along :: Spec
along = do
  it "rejects have their boxes in place in the composite, whatever the axis" $
    conjoin
      [ counterexample (show (quarter, box)) $
          case segmentedRejects found of
            [Reject (l, t, r, b) WrongSize] ->
              counterexample (show (l, t, r, b)) $
                and
                  [ abs (l - (fromIntegral x - 0.5)) < 0.05,
                    abs (t - (fromIntegral y - 0.5)) < 0.05,
                    abs (r - (fromIntegral (x + w) - 0.5)) < 0.05,
                    abs (b - (fromIntegral (y + h) - 0.5)) < 0.05
                  ]
            other -> counterexample (show other) False
        | quarter <- [0 .. 3],
          box@(x, y, w, h) <- [(5, 6, 4, 7), (20, 9, 9, 5), (9, 25, 5, 16)],
          let (_, _, found) = segmentAlong (turned quarter) (compositeOf (drawn [box]))
      ]
  it "symbols have their centres in place in the composite, and the axis of the reading" $
    conjoin
      [ counterexample (show (quarter, box)) $
          case segmentedSymbols found of
            [symbol] ->
              let (cx, cy) = symbolCentre symbol
               in counterexample (show symbol) $
                    abs (cx - (fromIntegral (2 * x + w) - 1) / 2) < 0.05
                      && abs (cy - (fromIntegral (2 * y + h) - 1) / 2) < 0.05
                      && symbolAxis symbol == fromIntegral (90 * quarter)
            other -> counterexample (show other) False
        | quarter <- [0 .. 3],
          (x, y) <- [(5, 6), (20, 9)],
          let (w, h) = if even quarter then (8, 12) else (12, 8),
          let box = (x, y, w, h),
          let (_, _, found) = segmentAlong (turned quarter) (compositeOf (drawn [box]))
      ]

  it "a symbol's image is the composite around its centre, continued beyond an edge" $
    forAll ((,,,) <$> size 8 <*> size 12 <*> choose (0, 3) <*> choose (0, 3)) $ \(w, h, i, j) ->
      let place extent room k = case k :: Int of
            0 -> 0
            1 -> room - extent
            _ -> fromIntegral (floor (room - extent) `div` (2 :: Int)) + 0.25
          (x, y) = (place w 30 i, place h 36 j)
          image =
            generate 30 36 (\u v -> 0.1 + 0.7 * share x (x + w) u * share y (y + h) v)
          found = segment (compositeOf image)
       in case segmentedSymbols found of
            [symbol] ->
              let (cx, cy) = symbolCentre symbol
                  expected a b =
                    ( sample image (cx + fromIntegral a - 3.5) (cy + fromIntegral b - 5.5)
                        - segmentedBackground found
                    )
                      / segmentedContrast found
               in counterexample (show symbol) $
                    and
                      [ maybe False (near (expected a b)) (index (symbolPixels symbol) a b)
                        | a <- [0 .. 7],
                          b <- [0 .. 11]
                      ]
            _ -> counterexample (show found) False
  where
    -- If more than half a pixel were missing, a column or row would not have been touched.
    size full = choose (full - 0.5, full + 1.2)
    near a b = abs (a - b) < (1e-9 :: Double)
    -- The covered share of a pixel from i to i + 1.
    share from to i = max 0 (min to (fromIntegral i + 1) - max from (fromIntegral i)) :: Double

neighbours :: Spec
neighbours =
  it "two symbols are neighbours just when they lie a pitch apart to 4 taxels along each axis" $
    [ (x, y)
      | x <- [-26, -25.5 .. 26],
        y <- [-26, -25.5 .. 26],
        cellsOf (x, y) /= expected (x, y)
    ]
      `shouldBe` []
  where
    -- The place of the second symbol's cell from the first's, if they are in one cluster.
    cellsOf place = case arrange id [symbolAt (0, 0), symbolAt place] of
      [Cluster cells] -> case [cell | (cell, s) <- Map.toList cells, symbolCentre s == place] of
        [(i, j)] ->
          let (i0, j0) = fromMaybe (0, 0) (lookup (0, 0) (inverted cells)) in Just (i - i0, j - j0)
        _ -> Nothing
      _ -> Nothing
    inverted cells = [(symbolCentre s, cell) | (cell, s) <- Map.toList cells]
    expected (x, y)
      | close x 16 && close y 0 = Just (0, 1)
      | close x (-16) && close y 0 = Just (0, -1)
      | close x 0 && close y 20 = Just (1, 0)
      | close x 0 && close y (-20) = Just (-1, 0)
      | otherwise = Nothing
    close a b = abs (a - b) <= (4 :: Double)
    symbolAt place = SymbolImage place (constant 8 12 0) 0 (8, 12)
