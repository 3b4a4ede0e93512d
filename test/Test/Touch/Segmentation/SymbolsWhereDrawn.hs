{-# OPTIONS_GHC -O1 #-}

-- | Tests segmentation, and the arrangement of symbols on their lattice.
module Test.Touch.Segmentation.SymbolsWhereDrawn (spec) where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Image.Correlate (overlapAt, referenceOf, zncc)
import PraTactile.Random (normals)
import PraTactile.Registration hiding (stitch)
import PraTactile.Segmentation
import PraTactile.Segmentation.Lattice
import PraTactile.Sensor
import PraTactile.Sensor.Frame
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Paper (stitch)
import Test.Touch.Sensor.MeanHeights (embossing, faceOf)

spec :: Spec
spec = do
  describe "Blank composites" blanks
  describe "One symbol" one
  describe "Incomplete symbols" rejected
  describe "Whole presses" presses
  describe "The lattice" lattice

-- | A composite of this size, its pixels clipped after noise of this standard deviation was added.
noisy :: Int -> Double -> Raster -> Composite
noisy seed sd image =
  compositeOf
    (generate w h (\x y -> max 0 (min 1 (value x y + sd * fromMaybe 0 (noise V.!? (y * w + x))))))
  where
    w = rasterWidth image
    h = rasterHeight image
    value x y = fromMaybe 0 (index image x y)
    (noise, _) = normals (w * h) (mkStdGen seed)

-- | An image of this size with a bitmap embossed at a real place (of its upper left pixel's
-- centre): each pixel the mean over its square.
embossedAt :: Int -> Int -> [((Double, Double), Raster)] -> Raster
embossedAt w h bitmaps =
  generate
    w
    h
    (\x y -> sum [share b (fromIntegral x - px) (fromIntegral y - py) | ((px, py), b) <- bitmaps])
  where
    -- The mean over a unit square of a function that is constant on unit squares: bilinear between
    -- them, 0 outside.
    share b x y =
      sum
        [ wx * wy * fromMaybe 0 (index b (floor x + i) (floor y + j))
          | (i, wx) <- [(0, 1 - part x), (1, part x)],
            (j, wy) <- [(0, 1 - part y), (1, part y)]
        ]
    part t = t - fromIntegral (floor t :: Int)

likeness :: Raster -> Raster -> Double
likeness a b = fromMaybe 0 (zncc (overlapAt (referenceOf a) b 0 0))

blanks :: Spec
blanks = do
  it "hold no symbol, whatever their level" $
    [segmentedSymbols (segment (compositeOf (constant 40 52 v))) | v <- [0, 0.3, 1]]
      `shouldBe` [[], [], []]
  it "hold no symbol and nothing embossed if they are noise alone" $
    forAll
      ((,,) <$> choose (1, 100000) <*> choose (0.01, 0.3) <*> elements [0, 0.3, 0.5])
      $ \(seed, sd, level) ->
        segment (noisy seed sd (constant 40 52 level)) === Segmentation [] [] 0 0
  it "hold no symbol if they have no pixels" $
    map (segment . compositeOf) [constant 0 0 1, constant 1 1 1, constant 0 5 0]
      `shouldBe` replicate 3 (Segmentation [] [] 0 0)

one :: Spec
one = do
  withCases 20 100
    . it "is found to a third of a taxel wherever it lies, and shows what is embossed"
    $ conjoin
      [ forAll
          ((,,) <$> choose (1, 100000) <*> choose (6, 26) <*> choose (6, 34))
          $ \(seed, x, y) ->
            alone (noisy seed 0.05 (embossedAt 40 52 [((x, y), bitmap)])) $ \symbol ->
              let (cx, cy) = symbolCentre symbol
               in counterexample (show ((x + 3.5, y + 5.5), symbol)) $
                    abs (cx - x - 3.5) < 1 / 3
                      && abs (cy - y - 5.5) < 1 / 3
                      && likeness (symbolPixels symbol) bitmap > 0.85
        | bitmap <- embossing ++ map (onRaster (turned 2)) embossing
      ]
  it "comes as 8 x 12 pixels with the background at 0 and the embossing at 1, upright" $
    forAll ((,,) <$> elements embossing <*> choose (0, 0.4) <*> choose (0.3, 0.6)) $
      \(bitmap, low, contrast) -> forAll genPlace $ \place ->
        let (x, y) = place :: (Int, Int)
            (left, top) = (fromIntegral x, fromIntegral y)
            raised = embossedAt 30 40 [((left, top), bitmap)]
         in alone (compositeOf (mapRaster (\v -> low + contrast * v) raised)) $ \symbol ->
              closeTo (symbolPixels symbol) bitmap
                .&&. symbolAxis symbol === 0
                .&&. near (symbolSize symbol) (8, 12)
                .&&. near (symbolCentre symbol) (left + 3.5, top + 5.5)
  it "is the same at any gain and offset" $
    forAll ((,,) <$> elements embossing <*> choose (0.3, 0.7) <*> choose (0, 0.3)) $
      \(bitmap, gain, offset) -> forAll ((,) <$> choose (3, 19) <*> choose (3, 25)) $ \place ->
        let plain = mapRaster (\v -> 0.1 + 0.8 * v) (embossedAt 30 40 [(place, bitmap)])
         in alone (compositeOf plain) $ \a ->
              alone (compositeOf (mapRaster (\v -> gain * v + offset) plain)) $ \b ->
                near (symbolCentre a) (symbolCentre b)
                  .&&. property (likeness (symbolPixels a) (symbolPixels b) > 0.9999)
  it "in the half-turned composite is half-turned" $
    forAll ((,) <$> choose (1, 100000) <*> elements embossing) $ \(seed, bitmap) ->
      let composite = noisy seed 0.05 (embossedAt 30 40 [((9.3, 11.6), bitmap)])
          upsideDown = compositeOf (onRaster (turned 2) (compositeImage composite))
       in alone composite $ \a -> alone upsideDown $ \b ->
            let (x, y) = symbolCentre a
             in near (29 - x, 39 - y) (symbolCentre b)
                  .&&. property
                    (likeness (symbolPixels a) (onRaster (turned 2) (symbolPixels b)) > 0.999)
  where
    near (x, y) (x', y') =
      counterexample (show ((x, y), (x', y'))) (abs (x - x') < 0.02 && abs (y - y') < 0.02)
    -- The levels are accurate to a 512th of the composite's range.
    closeTo a b =
      counterexample
        (show (toRows a))
        ( either
            (const False)
            (maybe True (< 0.01) . maximumValue)
            (zipRaster (\p q -> abs (p - q)) a b)
        )
    genPlace = (,) <$> choose (2, 20) <*> choose (2, 26)

-- | The one symbol of a composite, if it has one and nothing else.
alone :: Testable t => Composite -> (SymbolImage -> t) -> Property
alone composite check = case segment composite of
  Segmentation [symbol] [] _ _ -> property (check symbol)
  other -> counterexample (show other) False

rejected :: Spec
rejected = do
  withCases 10 100 . it "a symbol cut off by three taxels or more is called so, in all its pieces" $
    conjoin
      [ forAll (choose (3, 6)) $ \cut ->
          conjoin
            [ nothingBut CutOff (segment (compositeOf (embossedAt 40 52 [(place, bitmap)])))
              | place <- [(-cut, 20), (32 + cut, 20), (15, -cut), (15, 40 + cut)]
            ]
        | bitmap <- solid : embossing
      ]
  withCases 10 100
    . it "a symbol is found while only a row at its edge or half a column was not touched"
    $ conjoin
      [ forAll ((,) <$> choose (0, 0.5) <*> choose (0, 0.9)) $ \(columns, rows') ->
          conjoin
            [ alone (compositeOf (embossedAt 40 52 [(place, bitmap)])) $ \symbol ->
                let (cx, cy) = symbolCentre symbol
                 in counterexample
                      (show (place, symbol))
                      ( abs (cx - x - 3.5) < 0.5
                          && abs (cy - y - 5.5) < 0.5
                          && likeness (symbolPixels symbol) bitmap > 0.7
                      )
              | place@(x, y) <-
                  [(-columns, 20), (32 + columns, 20), (15, -rows'), (15, 40 + rows')]
            ]
        | bitmap <- embossing
      ]
  withCases 10 100
    . it "a symbol of which less than nine tenths was touched is cut off, though its box fits"
    $ conjoin
      [ forAll (choose (0.7, 1.5)) $ \cut ->
          conjoin
            [ nothingBut CutOff (segment (compositeOf (embossedAt 40 52 [(place, bitmap)])))
              | place <- [(-cut, 20), (32 + cut, 20), (15, -1 - cut), (15, 41 + cut)]
            ]
        | bitmap <- embossing
      ]
  it "a symbol at the edge of what was touched within a larger composite is cut off" $
    forAll (choose (3, 6)) $ \cut ->
      forAll (elements [identity, turned 2, mirror, mirror <> turned 2]) $ \side ->
        forAll arbitrary $ \across ->
          let whole = compositeOf (embossedAt 40 52 [((15, 20), solid)])
              -- From one edge, to this depth into the symbol.
              touched x y =
                (if across then fromIntegral x - 15 else fromIntegral y - 20)
                  >= cut - (0.5 :: Double)
              seen =
                whole
                  { compositeCoverage =
                      generate 40 52 (\x y -> if touched x y then 1 else 0)
                  }
           in causes (segment (onComposite side seen)) === ([], [CutOff])
  it "a region of another size than a symbol's is reported as that" $
    [ causes (segment (compositeOf (embossedAt 40 52 [((14, 20), constant w h 1)])))
      | (w, h) <- [(4, 4), (8, 8), (12, 12), (8, 16), (12, 8), (8, 10), (6, 12)]
    ]
      `shouldBe` replicate 7 ([], [WrongSize])
  it "up to three bright pixels are nothing, and four have the wrong size" $
    [ causes (segment (compositeOf (embossedAt 40 52 [((14, 20), solid), ((30, 5), few)])))
      | (w, h) <- [(1, 1), (1, 2), (3, 1), (1, 3), (2, 2), (4, 1)],
        let few = constant w h 1
    ]
      `shouldBe` map ((,) [(17.5, 25.5)]) ([[], [], [], []] ++ [[WrongSize], [WrongSize]])
  where
    nothingBut cause s =
      counterexample
        (show s)
        ( null (segmentedSymbols s)
            && not (null (segmentedRejects s))
            && and [c == cause | Reject _ c <- segmentedRejects s]
        )
    causes s =
      (map symbolCentre (segmentedSymbols s), [cause | Reject _ cause <- segmentedRejects s])
    solid = constant 8 12 1

presses :: Spec
presses =
  -- Fixed seeds: one press in a thousand or so is refused, and a test must not fail by chance. Only
  -- the robot's positions connect symbols on both sides of a gap without overlaps, hence the three
  -- taxels.
  it "with noise and position errors, all symbols of a scan are found within 3 taxels" $
    conjoin $
      flip
        map
        [ (seed, fromIntegral (seed * 7 `mod` 160) / 8, fromIntegral (seed * 11 `mod` 160) / 8)
          | seed <- [1 .. byEffort 4 24 :: Int]
        ]
        $ \(seed, x, y :: Double) ->
          let cells = [[0, 1, 2, 3], [3, 2, 0, 1], [1, 0, 3, 2], [2, 3, 1, 0]]
              poses = either (const []) id (planScan 8 (taxelPitch * x, taxelPitch * y) (40, 52))
              frames = fst (scan standardSensor (faceOf cells) stay poses (mkStdGen seed))
              inside =
                [ ((row, column), (cx - x, cy - y))
                  | row <- [0 .. 3 :: Int],
                    column <- [0 .. 3 :: Int],
                    let cx = 16 * fromIntegral column + 8,
                    let cy = 20 * fromIntegral row + 10,
                    cx - x > 7,
                    cx - x < 33,
                    cy - y > 9,
                    cy - y < 43
                ]
           in case stitch standardRegistration frames of
                Left e -> counterexample (show e) False
                Right composite ->
                  let places =
                        [ ( (px - taxelPitch * x) / taxelPitch + 0.5,
                            (py - taxelPitch * y) / taxelPitch + 0.5
                          )
                          | symbol <- segmentedSymbols (segment composite),
                            let (px, py) = compositePosition composite (symbolCentre symbol)
                        ]
                      offsets =
                        [minimumBy' [(a - cx, b - cy) | (a, b) <- places] | (_, (cx, cy)) <- inside]
                   in counterexample
                        (show (inside, places))
                        (not (null inside) && and [distance p q < 3 | p <- offsets, q <- offsets])
  where
    distance (a, b) (c, d) = max (abs (a - c)) (abs (b - d))
    minimumBy' = foldr (\p q -> if distance p (0, 0) < distance q (0, 0) then p else q) (99, 99)

lattice :: Spec
lattice = do
  it "symbols at pitch 16 x 20, each up to two taxels off, are arranged as they lie" $
    forAll (vectorOf 12 ((,) <$> choose (-2, 2) <*> choose (-2, 2))) $ \jitter ->
      forAll
        (shuffle (zip [(row, column) | row <- [0 .. 3], column <- [0 .. 2]] jitter))
        $ \placed ->
          let symbols =
                [ (cell, at (100 + 16 * fromIntegral column + dx, 50 + 20 * fromIntegral row + dy))
                  | (cell@(row, column), (dx, dy)) <- placed
                ]
           in arrange id (map snd symbols) === [Cluster (Map.fromList symbols)]
  it "the cells count from the uppermost row and leftmost column of any symbol" $
    -- An L upside down and mirrored: the upper left cell is empty.
    arrange id [at (16, 0), at (16, 20), at (0, 20)]
      `shouldBe` [ Cluster
                     ( Map.fromList
                         [((0, 1), at (16, 0)), ((1, 1), at (16, 20)), ((1, 0), at (0, 20))]
                     )
                 ]
  it "symbols without connecting neighbours stay in clusters of their own" $
    arrange id [at (0, 0), at (16, 0), at (48, 0), at (0, 60)]
      `shouldBe` [ Cluster (Map.fromList [((0, 0), at (0, 0)), ((0, 1), at (16, 0))]),
                   Cluster (Map.fromList [((0, 0), at (48, 0))]),
                   Cluster (Map.fromList [((0, 0), at (0, 60))])
                 ]
  it "diagonal neighbours alone do not connect" $
    length (arrange id [at (0, 0), at (16, 20)]) `shouldBe` 2
  it "two symbols in one place are a contradiction" $
    case arrange id [at (0, 0), at (16, -1), at (16, 3)] of
      [Contradiction (SharedCell _ a b) members] ->
        (map symbolCentre [a, b], length members) `shouldBe` ([(16, -1), (16, 3)], 3)
      other -> expectationFailure (show other)
  it "two roads that lead to different cells are a contradiction" $
    -- From (0, 0) to (60, 0) in five short steps and in three long ones.
    case arrange
      id
      (map at [(0, 0), (12, 4), (24, 8), (36, 8), (48, 4), (60, 0), (20, -4), (40, -4)]) of
      [Contradiction (TwoCells _ a b) members] -> (a /= b, length members) `shouldBe` (True, 8)
      other -> expectationFailure (show other)
  it "distances are measured along the symbols' axes" $
    forAll ((,) <$> choose (-180, 180) <*> elements [((0, 1), (16, 0)), ((1, 0), (0, 20))]) $
      \(angle, (cell, (right', down))) ->
        let slanted place = (at place) {symbolAxis = angle}
            (c, s) = (cos (angle * pi / 180), sin (angle * pi / 180))
            there = (c * right' - s * down, s * right' + c * down)
            two = Map.fromList [((0, 0), slanted (0, 0)), (cell, slanted there)]
            -- A symbol that lies a pitch off along the composite's axes, not along its own.
            (x, y) = (c * right' + s * down, c * down - s * right')
            beside (a, b) = abs (x - a) <= 4 && abs (y - b) <= 4
            isBeside = any beside [(16, 0), (-16, 0), (0, 20), (0, -20)]
         in arrange id [slanted (0, 0), slanted there] === [Cluster two]
              .&&. length (arrange id [slanted (0, 0), slanted (right', down)])
              === (if isBeside then 1 else 2)
  it "no symbols make no cluster" $ arrange id [] `shouldBe` []
  it "after a half turn each cell is as far from the last row and column as before from the first" $
    let place = (,) <$> choose (0, 5) <*> choose (0, 5)
     in forAll (Map.fromList <$> listOf1 ((,) <$> place <*> letter)) $ \cells ->
          let bottom = maximum (map fst (Map.keys cells))
              right' = maximum (map snd (Map.keys cells))
           in halfTurned cells === Map.mapKeys (\(i, j) -> (bottom - i, right' - j)) cells
  where
    letter = choose ('a', 'z')
    at place = SymbolImage place (constant 8 12 0) 0 (8, 12)
