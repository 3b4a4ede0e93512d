{-# OPTIONS_GHC -O1 #-}

-- | Tests training images, and parts of symbols, against their descriptions.
module Test.Touch.Classification.SpecimensOfEachKind (spec) where

import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Part (partDistances)
import PraTactile.Classification.Specimens
import PraTactile.Classification.Templates (templates)
import PraTactile.Image
import PraTactile.Segmentation (Part (..))
import PraTactile.Sensor
import PraTactile.Sensor.Frame (SensorPose (..))
import PraTactile.Shape
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  describe "Specimens" specimens
  describe "Parts" parts
  it "a sensor without full scale, or a map without cells, feels nothing" $
    [ forwardImage
        standardSensor {sensorFullScale = full}
        (heightMap pitch (constant 40 40 0.5))
        (SensorPose 20 20 turn)
      | turn <- [0, 30],
        (full, pitch) <- [(0, 1), (-1, 1), (0.8, 0), (0.8, -1)]
    ]
      `shouldSatisfy` all (== constant 16 16 0)

specimens :: Spec
specimens = do
  it "halves are the left or upper half of the shape, and the other half of another one" $
    either (expectationFailure . show) halves paperAlphabet
  it "displaced ones are displaced sideways, or up and down, equally often" $
    either (expectationFailure . show) displaced paperAlphabet
  it "curtailed ones lack a corner of at most 3 taxels (upside down 4), or a margin of at most 2" $
    either (expectationFailure . show) check paperAlphabet
  it "corners are missing at all four, along either side" $
    either (expectationFailure . show) cornered paperAlphabet
  where
    halves a = do
      let drawn kind shape seed = fst (specimen a kind shape (mkStdGen seed))
          -- Whether two images agree in some of their pixels.
          alike part one other = and [index one x y == index other x y | (x, y) <- part]
          left = [(x, y) | x <- [0, 1], y <- [0 .. 11]]
          right' = [(x, y) | x <- [6, 7], y <- [0 .. 11]]
          upper = [(x, y) | x <- [0 .. 7], y <- [0 .. 2]]
          lower = [(x, y) | x <- [0 .. 7], y <- [9 .. 11]]
          -- All specimens from one seed are seen in the same way.
          cases =
            [ (halved left right', halved upper lower)
              | (seed, shape) <- zip [1 .. 200] (cycle (shapes a)),
                let both = drawn Halves shape seed,
                let halved first second =
                      alike first both (drawn Upright shape seed)
                        && or
                          [ alike second both (drawn Upright other seed)
                            | other <- shapes a,
                              other /= shape
                          ]
            ]
      filter (== (False, False)) cases `shouldBe` []
      -- Within five standard errors of a half of the 200.
      [length (filter (== way) cases) | way <- [(True, False), (False, True)]]
        `shouldSatisfy` all (\n -> n >= 65 && n <= 135)
    -- From one seed the symbol in its place and the displaced one are blurred alike. The lesser
    -- displacement, uniform to 6 taxels, is below 2 in a third of them.
    displaced a = do
      let moves =
            [ movedBy (drawn Upright) (drawn Displaced)
              | (seed, shape) <- zip [1 .. byEffort 100 200] (cycle (shapes a)),
                let drawn kind = fst (specimen a kind shape (mkStdGen seed))
            ]
          small t = abs t <= (1 :: Int)
          large t = abs t >= 3
      [ length [() | (i, j) <- moves, small i, large j],
        length [() | (i, j) <- moves, large i, small j]
        ]
        `shouldSatisfy` all (\n -> n >= byEffort 3 10 && n <= byEffort 33 56)
      [move | move@(i, j) <- moves, abs i < 2, abs j < 2] `shouldBe` []
    -- The displacement in taxels, right and down, of the second image from the first: where their
    -- common part differs least.
    movedBy one other =
      snd (minimum [(difference i j, (i, j)) | i <- [-6 .. 6], j <- [-6 .. 6]])
      where
        difference i j =
          let squares =
                [ (a - b) ^ (2 :: Int)
                  | x <- [0 .. 7],
                    y <- [0 .. 11],
                    Just a <- [index other x y],
                    Just b <- [index one (x - i) (y - j)]
                ]
           in sum squares / fromIntegral (length squares) :: Double
    -- From one seed the whole symbol and the curtailed one are seen alike. Corners are longer than
    -- thick. Of 400 specimens a quarter lack one along either side. Seven in twelve of these lack
    -- one of four columns or more, and eight in twelve one of five rows or more.
    cornered a = do
      let lacking =
            [ [(x, y) | x <- [0 .. 7], y <- [0 .. 11], index whole x y /= index seen x y]
              | (seed, shape) <- zip [1 .. 400] (cycle (shapes a)),
                let draw kind = fst (specimen a kind shape (mkStdGen seed)),
                let (whole, seen) = (draw Upright, draw Curtailed)
            ]
          reach part pixels = (minimum (map part pixels), maximum (map part pixels))
          corners =
            [ (w > h, left == 0, top == 0)
              | pixels@(_ : _) <- lacking,
                let ((left, right'), (top, bottom)) = (reach fst pixels, reach snd pixels),
                let (w, h) = (right' - left + 1, bottom - top + 1),
                w <= 3 && h >= 5 && h < 12 || h <= 3 && w >= 4 && w < 8
            ]
      length (filter null lacking) `shouldSatisfy` (<= 4)
      let kinds = (,,) <$> [False, True] <*> [False, True] <*> [False, True]
      map (\kind -> length (filter (== kind) corners)) kinds `shouldSatisfy` all (>= 5)
    check a = do
      -- From one seed the whole symbol and the curtailed one are seen alike.
      let lacking whole curtailed =
            [ missing (fst (draw whole)) (fst (draw curtailed))
              | (seed, shape) <- zip [1 .. 200] (cycle (shapes a)),
                let draw kind = specimen a kind shape (mkStdGen seed)
            ]
          most found = (maximum (map fst found), maximum (map snd found))
      map most [lacking Upright Curtailed, lacking UpsideDown CurtailedUpsideDown]
        `shouldBe` [(3, 2), (4, 2)]
    -- The thickness, in the thinner direction, of the corner that contains all differences; and the
    -- same for a margin, which repeats what was seen, while a corner is flat.
    missing whole seen =
      let differing = [(x, y) | x <- [0 .. 7], y <- [0 .. 11], index whole x y /= index seen x y]
          thickness =
            minimum
              [ min
                  (maximum (0 : map (fromEdge right 8 . fst) differing))
                  (maximum (0 : map (fromEdge bottom 12 . snd) differing))
                | right <- [False, True],
                  bottom <- [False, True]
              ]
          isMargin = any (\(x, y) -> index seen x y /= Just 0) differing
       in (thickness, if isMargin then thickness else 0) :: (Int, Int)
    fromEdge far size t = if far then size - t else t + 1

parts :: Spec
parts =
  withCases 2 3
    . it "partDistances are sums of squares, from a flat face and from shapes moved by half taxels"
    $ forAll ((,) <$> genRasterOf 8 12 <*> genRasterOf 8 12) $ \(values, dice) ->
      let seen = mapRaster (\v -> if v < 0.6 then 1 else 0) dice
          -- From -1 to 1, and 0 where nothing was seen.
          pixels = generate 8 12 (\x y -> (2 * at values x y - 1) * at seen x y)
       in case paperAlphabet of
            Left e -> counterexample (show e) False
            Right a ->
              let (distances, flat) = partDistances (templates a) (Part pixels seen)
                  close p q = counterexample (show (p, q)) (abs (p - q) < 1e-9 * (1 + abs q))
               in conjoin $
                    close flat (V.sum (V.map (\v -> v * v) (rasterValues pixels))) :
                    [ close d (distanceBy a c move (onRaster s pixels) (onRaster s seen))
                      | ((c, s), moves) <- distances,
                        (move, d) <- moves
                    ]
                      ++ [map fst distances === [(c, s) | s <- [identity, turned 2], c <- [0 .. 3]]]
  where
    at image x y = fromMaybe 0 (index image x y)
    distanceBy a c (dx, dy) pixels seen =
      sum
        [ at seen x y * (at pixels x y - value) ^ (2 :: Int)
          | Right shape <- [shapeOf a c],
            x <- [0 .. 7],
            y <- [0 .. 11],
            let value = moved shape (fromIntegral x - dx) (fromIntegral y - dy)
        ]
    -- The shape between its taxels, flat around.
    moved shape x y =
      sum
        [ max 0 (1 - abs (x - fromIntegral i)) * max 0 (1 - abs (y - fromIntegral j))
          | i <- [0 .. 7],
            j <- [0 .. 11],
            embossedAt shape i j
        ]
