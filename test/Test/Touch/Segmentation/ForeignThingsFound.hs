-- | Tests which regions have a symbol's size, which cannot be symbols, and where they are straight;
-- the height of symbols, and foreign regions beside them; each against its definition.
module Test.Touch.Segmentation.ForeignThingsFound (spec) where

import qualified Data.IntSet as IntSet
import Data.List (sort)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (Composite (..), compositeOf)
import PraTactile.Composite.Level (Levels (..))
import PraTactile.Image hiding (mean)
import PraTactile.Segmentation.Foreign
import PraTactile.Segmentation.Foreign.Extent
import PraTactile.Segmentation.Foreign.Height
import PraTactile.Segmentation.Masked
import PraTactile.Segmentation.Region
import PraTactile.Segmentation.Symbol (Cause (..), Reject (..))
import Test.Effort (withCases)
import Test.Hspec hiding (around)
import Test.QuickCheck hiding (generate)

spec :: Spec
spec = do
  withCases 12 100 sizeSpec
  straightSpec
  withCases 5 40 heightSpec
  foreignSpec
  withCases 6 50 removedSpec

wide, high :: Int
(wide, high) = (34, 30)

-- | A field of which all was touched.
field :: Masked
field = masked (compositeOf (constant wide high 0))

-- | Pixels' centres, as far as they are on the field, as a region.
regionOf :: ((Double, Double) -> Bool) -> Region
regionOf holds =
  [ y * wide + x
    | y <- [0 .. high - 1],
      x <- [0 .. wide - 1],
      holds (fromIntegral x, fromIntegral y)
  ]

-- | The pixels of a rectangle: its left column and top row, its width and height.
rectangle :: (Int, Int) -> (Int, Int) -> Region
rectangle (l, t) (w, h) = [y * wide + x | y <- [t .. t + h - 1], x <- [l .. l + w - 1]]

-- | A bar of this length and width around a place, turned clockwise by these degrees.
bar :: (Double, Double) -> Double -> (Double, Double) -> (Double, Double) -> Bool
bar (cx, cy) angle (long, short) (x, y) = abs u <= long / 2 && abs v <= short / 2
  where
    (c, s) = (cos (angle * pi / 180), sin (angle * pi / 180))
    (u, v) = (c * (x - cx) + s * (y - cy), c * (y - cy) - s * (x - cx))

-- | The extent of a region at an angle, with pixels one wide.
extent :: Region -> Double -> Double
extent region angle = maximum along - minimum along + 1
  where
    along =
      [ cos (angle * pi / 180) * fromIntegral (p `mod` wide)
          + sin (angle * pi / 180) * fromIntegral (p `div` wide)
        | p <- region
      ]

sizeSpec :: Spec
sizeSpec = do
  it "a region is too long if it extends over more than 18 pixels in one of eight directions" $
    forAll genBar $ \region ->
      let longest = maximum (map (extent region . (22.5 *)) [0 .. 7])
       in collect (longest > 18) (tooLong field region === (longest > 18))
  it "a region has a symbol's size if it is 12 by 8 pixels (1.8 more or less) at one of 36 angles" $
    forAll genBar $ \region ->
      let fits angle =
            let (long, short) = (extent region angle, extent region (angle + 90))
             in abs (long - 12) <= 1.8 && abs (short - 8) <= 1.8 && long - short >= 2
          wanted = length region `elem` [24 .. 110] && any (fits . (5 *)) [0 .. 35]
       in collect wanted (symbolSized field region === wanted)
  it "a region cannot be a symbol if too long, or if whole, at least 36 pixels, of another size" $
    [ ((l, t, w, h), unlikeSymbols field (rectangle (l, t) (w, h)))
      | (l, t, w, h) <-
          [(12, 9, 6, 6), (12, 9, 10, 10), (9, 9, 19, 2), (9, 9, 19, 1), (0, 0, 19, 1)]
            ++ [(12, 9, 5, 7), (12, 9, 8, 12), (12, 9, 12, 8), (9, 9, 18, 1)]
            ++ [(0, 9, 6, 6), (wide - 6, 9, 6, 6), (12, 0, 6, 6), (12, high - 6, 6, 6)]
    ]
      `shouldSatisfy` ((== replicate 5 True ++ replicate 8 False) . map snd)
  it "a region beside an untouched pixel is not whole" $
    -- A square of 6 x 6 with an untouched pixel beside it.
    forAll (elements [(9, 10), (16, 10), (12, 8), (12, 15)]) $ \(x, y) ->
      let region = regionOf (\(u, v) -> u >= 10 && u <= 15 && v >= 9 && v <= 14)
          hole = y * wide + x
          holed = showing [(p, 0) | p <- [0 .. wide * high - 1], p /= hole]
       in (unlikeSymbols field region, unlikeSymbols holed region) === (True, False)
  where
    genBar = do
      centre <- (,) <$> choose (8, 25) <*> choose (8, 21)
      angle <- choose (0, 180)
      size <-
        oneof
          [ (,) <$> choose (9, 15) <*> choose (6, 10),
            (,) <$> choose (2, 30) <*> choose (1, 12)
          ]
      let region = regionOf (bar centre angle size)
      pure (if null region then [0] else region)

straightSpec :: Spec
straightSpec = do
  withCases 7 60
    . it "straight pixels lie on a line of 17 with 16 in the region, at one of 16 angles"
    $ forAll genThing $
      \region ->
        let onLines =
              [ place
                | p <- region,
                  k <- [0 .. 15],
                  let line =
                        [ y * wide + x
                          | t <- [0 .. 16],
                            let along part = round (t * part (radians k)) :: Int,
                            let (x, y) = (p `mod` wide + along cos, p `div` wide + along sin),
                            x >= 0 && x < wide,
                            y >= 0 && y < high
                        ],
                  length (filter (`IntSet.member` places) line) >= 16,
                  place <- line
              ]
            places = IntSet.fromList region
         in sort (concat (straight field region)) === IntSet.toList (IntSet.fromList onLines)
  it "a line is straight from 16 pixels on, even without one; on a diagonal from 12 on" $
    [ null (straight field region)
      | region <-
          [ row [4 .. 19],
            row [4 .. 18],
            row ([4 .. 10] ++ [12 .. 20]),
            row ([4 .. 10] ++ [13 .. 21]),
            [y * wide + 7 | y <- [3 .. 18]],
            [y * wide + y | y <- [3 .. 14]],
            [y * wide + y | y <- [3 .. 13]]
          ]
    ]
      `shouldBe` [False, True, False, True, False, False, True]
  where
    radians k = 11.25 * k * pi / 180 :: Double
    row xs = [10 * wide + x | x <- xs]
    genThing = do
      angle <- choose (0, 180)
      long <- choose (12, 30)
      short <- choose (1, 4)
      at <- (,) <$> choose (8, 25) <*> choose (8, 21)
      let one = bar (16, 15) angle (long, short)
          other = bar at (angle + 90) (8, 12)
      pure (regionOf (\p -> one p || other p))

-- | The values of a composite, and where it was touched.
genScene :: Gen Masked
genScene = smoothed . masked <$> genComposite

-- | Bars of several heights on a slope, with some noise, not all of it touched.
genComposite :: Gen Composite
genComposite = do
  count <- choose (0, 5)
  bars <- vectorOf count $ do
    centre <- (,) <$> choose (4, 29) <*> choose (4, 25)
    angle <- choose (0, 180)
    size <-
      frequency
        [ (4, (,) <$> choose (11, 13) <*> choose (7, 9)),
          (1, (,) <$> choose (15, 34) <*> choose (2, 4)),
          (1, (,) <$> choose (3, 9) <*> choose (3, 9))
        ]
    height <- frequency [(4, choose (0.4, 0.6)), (2, choose (0.15, 1)), (1, choose (-0.5, 0))]
    pure (bar centre angle size, height)
  slope <- elements [0, 0, 0.004]
  rough <- elements [0, 0.02, 0.1]
  noise <- vectorOf (wide * high) (choose (negate rough, rough))
  untouched <- elements [0, 0, 60, 200]
  touched <- (++ repeat True) . map (> (1 :: Int)) <$> vectorOf untouched (choose (0, 9))
  let value x y =
        0.3 + slope * fromIntegral x + noise !! (y * wide + x)
          + sum [h | (holds, h) <- take 3 bars, holds (fromIntegral x, fromIntegral y)]
          -- The last one stands by itself, at its own height.
          + maximum (0 : [h | (holds, h) <- drop 3 bars, holds (fromIntegral x, fromIntegral y)])
      coverage x y = if touched !! (y * wide + x) then 1 else 0
  pure (compositeOf (generate wide high value)) {compositeCoverage = generate wide high coverage}

-- | The pixels of one region that are not in another.
without :: [Int] -> [Int] -> [Int]
without others = filter (not . among others)

-- | The pixels of the field within this distance of some.
near :: Int -> [Int] -> [Int]
near = around field

-- | The field with these values, touched nowhere else.
showing :: [(Int, Double)] -> Masked
showing pixels = maskedAs (wide, high) (V.fromList numbers) (V.fromList values)
  where
    (numbers, values) = unzip (sort pixels)

heightSpec :: Spec
heightSpec = do
  it "the highest of 23 cuts counts: a symbol beside a hole ten times as deep as it is high" $
    let symbol = regionOf (bar (15.5, 14.5) 0 (12, 8))
        rest = without symbol [1 .. wide * high - 1]
        found = symbolLevels (showing ((0, -10) : [(p, 0) | p <- rest] ++ [(p, 1) | p <- symbol])) 0
     in fmap (length . snd) found `shouldBe` Just 1
  it "a symbol needs twelve touched pixels at a distance of three" $
    [ snd <$> symbolLevels (showing ([(p, 1) | p <- symbol] ++ [(p, 0) | p <- take n ring])) 0
      | let symbol = regionOf (bar (15.5, 14.5) 0 (12, 8)),
        let ring = without (near 2 symbol) (near 3 symbol),
        n <- [11, 12]
    ]
      `shouldSatisfy` \found -> map (fmap length) found == [Nothing, Just 1]
  it "symbols have the median of their heights, above their surroundings" $
    forAll (vectorOf 3 (choose (0.4, 0.6))) $ \heights -> forAll (choose (0, 0.39)) $ \least ->
      let pixels = raised 0.25 (zip places heights)
       in case symbolLevels pixels least of
            Just (Levels low up, symbols) ->
              (low, sort (map sort symbols)) === (0.25, sort places)
                .&&. counterexample (show up) (abs (up - 0.25 - sort heights !! 1) < 1e-9)
            Nothing -> property False
  it "a symbol is at most 1.6 times and at least half as high as most" $ do
    let found other =
          length . snd <$> symbolLevels (raised 0 (zip places [0.5, 0.5, other])) 0
    map found [0.26, 0.24, 0.79, 0.81] `shouldBe` [Just 3, Just 2, Just 3, Just 2]
  it "regions of another size do not count, however high" $ do
    let bars = [(rectangle (2, 17) (30, 3), 1), (rectangle (4, 23) (4, 4), 0.9)]
        pixels = raised 0.25 (zip (take 2 places) [0.5, 0.5] ++ bars)
    fmap (sort . map sort) <$> symbolLevels pixels 0
      `shouldBe` Just (Levels 0.25 0.75, take 2 places)
  it "a symbol must stand as high as the least contrast" $ do
    let one least = maybe 0 (length . snd) (symbolLevels (raised 0 [(p, 0.5)]) least)
        p = rectangle (12, 9) (8, 12)
    map one [0.4999, 0.5001] `shouldBe` [1, 0]
  it "of overlapping regions the symbol is the one cut off nearest to half its height" $ do
    -- It has a symbol's size with its shoulder, too.
    let own = rectangle (12, 9) (8, 12)
        shoulder = rectangle (20, 9) (1, 12)
    fmap (map sort) <$> symbolLevels (raised 0 [(own, 1), (shoulder, 0.3)]) 0
      `shouldBe` Just (Levels 0 1, [own])
  it "a region that has a symbol's size only far from half its height is no symbol" $ do
    -- On a plateau too large for a symbol.
    let plateau h =
          raised 0 [(rectangle (12, 9) (8, 12), 1 - h), (rectangle (10, 9) (12, 12), h)]
    [length . snd <$> symbolLevels (plateau h) 0 | h <- [0.65, 0.75]] `shouldBe` [Just 1, Nothing]
  it "a symbol is as high as the lowest of the highest three tenths of its pixels" $ do
    let ridges n =
          raised 0 [(rectangle (12, 9) (8, 12), 0.75), (take n (rectangle (12, 9) (8, 12)), 0.25)]
        height n = levelEmbossing . fst <$> symbolLevels (ridges n) 0
    map height [28, 29] `shouldBe` [Just 0.75, Just 1]
  it "doubling the gain doubles all heights, and keeps the symbols" $
    forAllBlind genScene $ \scene -> forAll (elements [0.04, 0.2]) $ \least ->
      let doubled = scene {touchedValues = V.map (2 *) (touchedValues scene)}
          twice (Levels a b, symbols) = (Levels (2 * a) (2 * b), symbols)
          found = symbolLevels scene least
       in label (maybe "none" (show . length . snd) found) $
            symbolLevels doubled (2 * least) === fmap twice found
  where
    places = [rectangle (4, 1) (8, 12), rectangle (21, 1) (8, 12), rectangle (4, 17) (8, 12)]

-- | A field of this level with some regions above it by these heights.
raised :: Double -> [(Region, Double)] -> Masked
raised level regions =
  field {touchedValues = V.generate (wide * high) (\p -> level + sum (heights p))}
  where
    heights p = [h | (region, h) <- regions, p `elem` region]

foreignSpec :: Spec
foreignSpec = do
  it "twelve sunken pixels are foreign, and eleven are noise" $
    [ length (foreignIn (showing [(p, -1) | p <- take n [9 * wide + 3 ..]]) (Levels 0 1) [])
      | n <- [11, 12]
    ]
      `shouldBe` [0, 1]
  it "a bar is foreign from 0.35 of the symbols' height on, and too high from 1.5 on" $
    [ [(cause, height, of' region) | (region, cause, height) <- foreign' [(bar', v)] []]
      | v <- [0.34, 0.35, 1, 1.49, 1.5, 3],
        -- With a rim of one pixel at least and of two at most.
        let of' region = all (`elem` region) (near 1 bar') && all (`elem` rim2) region
    ]
      `shouldBe` [[]]
      ++ replicate 3 [(TooLarge, False, True)]
      ++ replicate 2 [(TooLarge, True, True)]
  it "a bar no longer than a symbol is not foreign, nor are pixels off its straight line" $ do
    foreign' [(rectangle (7, 10) (17, 3), 1), (rectangle (7, 20) (12, 8), 2)] [] `shouldBe` []
    -- A square of 8 x 8 under the end of the bar, on lines through both except for its far side.
    case foreign' [(bar', 1), (rectangle (7, 13) (8, 8), 1)] [] of
      [(region, TooLarge, False)] -> do
        filter (`notElem` region) bar' `shouldBe` []
        filter (`elem` region) (rectangle (7, 19) (8, 2)) `shouldBe` []
      other -> expectationFailure (show other)
  it "a region sunk by 0.35 of the symbols' height is foreign, whatever its shape" $
    [foreign' [(rectangle (9, 9) (4, 3), v)] [] | v <- [-0.34, -0.35, -2]]
      `shouldBe` [ [],
                   [(rectangle (7, 7) (8, 7), Hollow, True)],
                   [(rectangle (7, 7) (8, 7), Hollow, True)]
                 ]
  it "a symbol and its rim are not foreign" $ do
    let symbol = rectangle (10, 14) (8, 12)
        kept = rectangle (9, 13) (10, 14)
    foreign' [(bar', 2), (symbol, 1)] [symbol]
      `shouldBe` [([p | p <- rim2, p `notElem` kept], TooLarge, True)]
    foreign' [(symbol, 2)] [symbol] `shouldBe` []
  it "the slope of a region that is too high belongs to it, and is not reported again" $
    foreign' [(bar', 1.5), (rectangle (6, 9) (22, 5), 0.5)] []
      `shouldBe` [(rim2, TooLarge, True)]
  it "regions that are too high come first, then the level ones, then the sunken ones" $
    map
      (\(_, cause, height) -> (cause, height))
      ( foreign'
          [ (rectangle (3, 2) (4, 4), -1),
            (rectangle (3, 10) (24, 3), 1),
            (rectangle (3, 20) (24, 3), 2)
          ]
          []
      )
      `shouldBe` [(TooLarge, True), (TooLarge, False), (Hollow, True)]
  where
    bar' = rectangle (7, 10) (20, 3)
    rim2 = rectangle (5, 8) (24, 7)
    -- The foreign regions of a field at 0, where symbols are at 1.
    foreign' regions symbols =
      [ (sort (foreignPixels s), foreignCause s, foreignHeight s)
        | s <- foreignIn (raised 0 regions) (Levels 0 1) symbols
      ]

removedSpec :: Spec
removedSpec = do
  it "a bar, a hole or a plateau beside a symbol is masked with its rim, and nothing else is" $
    forAll (elements things) $ \(thing, value, cause, height) -> forAll (choose (0, 0.3)) $ \low ->
      let picture = drawn low [(symbol, 0.4), (thing, value)]
          composite = compositeOf picture
          ForeignMasked found byHeight rejects = maskForeign composite
          image = compositeImage found
          gone = [p | (p, 0) <- zip [0 ..] (V.toList (rasterValues (compositeCoverage found)))]
       in conjoin
            [ counterexample "all of it is masked" $ filter (`notElem` gone) thing === [],
              counterexample "at most four pixels around it are masked" $
                filter (`notElem` near 4 thing) gone === [],
              counterexample "nothing of the symbol is masked" $ filter (`elem` gone) symbol === [],
              counterexample "masked pixels count as flat, and the others stay" $
                V.toList (rasterValues image)
                  === [ if p `elem` gone then 0 else v
                        | (p, v) <- zip [0 ..] (V.toList (rasterValues picture))
                      ],
              counterexample "parts are read there if it is as high as symbols" $
                byHeight === Just (if height then found else composite),
              case rejects of
                [Reject (l, t, r, b) why] ->
                  why === cause
                    .&&. [l, t, r, b]
                    === [ minimum (columnsOf gone) - 0.5,
                          minimum (rowsOf gone) - 0.5,
                          maximum (columnsOf gone) + 0.5,
                          maximum (rowsOf gone) + 0.5
                        ]
                _ -> counterexample (show rejects) False
            ]
  it "nothing is masked without a symbol beside it" $
    forAll (elements things) $ \(thing, value, _, _) ->
      let composite = compositeOf (drawn 0.2 [(thing, value)])
       in maskForeign composite === ForeignMasked composite Nothing []
  it "a hole with a dozen deep pixels is masked, and a smaller one is noise" $ do
    let taken w h = length (maskedRejects (maskForeign (holed (rectangle (24, 14) (w, h)))))
        holed hole = compositeOf (drawn 0.5 [(symbol, 0.4), (hole, -0.5)])
    [taken 1 1, taken 2 2, taken 4 3, taken 5 5] `shouldBe` [0, 0, 1, 1]
  where
    symbol = rectangle (8, 15) (8, 12)
    things =
      [ (rectangle (3, 5) (28, 4), 0.4, TooLarge, False),
        (rectangle (3, 5) (28, 4), 0.7, TooLarge, True),
        (rectangle (24, 3) (4, 24), 0.4, TooLarge, False),
        (rectangle (23, 12) (8, 9), -0.6, Hollow, True)
      ]
    drawn low regions =
      generate wide high $ \x y -> low + sum [h | (r, h) <- regions, (y * wide + x) `elem` r]
    columnsOf = map (fromIntegral . (`mod` wide)) :: Region -> [Double]
    rowsOf = map (fromIntegral . (`div` wide)) :: Region -> [Double]
