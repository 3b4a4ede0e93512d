-- | Tests the first weights of networks against the formulas of Nguyen and Widrow.
module Test.Touch.Classification.FirstWeightsByFormula (spec) where

import Data.List (nub)
import Numeric.LinearAlgebra (toLists)
import PraTactile.Classification.Network
import PraTactile.Classification.NguyenWidrow
import System.Random (mkStdGen)
import Test.Hspec
import Test.QuickCheck
import Test.Support

spec :: Spec
spec = do
  it "for inputs from -1 to 1 each row has the norm 4 times 0.7 s^(1/r)" $
    forAll genLayer $ \(s, ranges, seed) ->
      let r = length (filter wide ranges)
          m = 4 * 0.7 * fromIntegral s ** (1 / fromIntegral r)
       in conjoin [near (norm (scaled ranges row)) m | row <- layerOf s ranges seed]
  it "the biases are equally far apart, up to the sign of the first weight" $
    forAll genLayer $ \(s, ranges, seed) ->
      let r = length (filter wide ranges)
          m = 4 * 0.7 * fromIntegral s ** (1 / fromIntegral r)
          place i = if s == 1 then 0 else 2 * fromIntegral i / fromIntegral (s - 1) - 1
       in conjoin
            [ near (centredBias ranges row) (m * place i * signum (first (scaled ranges row)))
              | (i, row) <- zip [0 :: Int ..] (layerOf s ranges seed)
            ]
  it "an input with a single value has the weight 0, and does not change the others" $
    forAll genLayer $ \(s, ranges, seed) ->
      let rows' = layerOf s (ranges ++ [(0.3, 0.3)]) seed
       in map (take (length ranges)) rows' === map (take (length ranges)) (layerOf s ranges seed)
            .&&. map (take 1 . drop (length ranges)) rows' === replicate s [0]
  it "without any range there are only biases, equally far apart around 0" $
    forAll (choose (2, 9)) $ \s -> forAll arbitrary $ \seed ->
      let rows' = layerOf s [(0.3, 0.3), (-1, -1)] seed
          biases = concatMap (drop 2) rows'
          greatest = maximum biases
          place i = 2 * fromIntegral i / fromIntegral (s - 1) - 1
       in map (take 2) rows' === replicate s [0, 0]
            .&&. greatest > 0
            .&&. conjoin [near b (greatest * place i) | (i, b) <- zip [0 :: Int ..] biases]
  it "the directions are those of uniform draws: on all sides, and different" $ do
    let rows' = layerOf 2000 [(-1, 1), (-1, 1)] 3
        turns = [atan2 b a | a : b : _ <- rows']
        -- An eighth of the draws in a square lies between 0 and 45 degrees, as in each such part.
        part k = length [t | t <- turns, t >= k * pi / 4, t < (k + 1) * pi / 4]
    length (nub turns) `shouldBe` 2000
    map part [-4 .. 3] `shouldSatisfy` all (\n -> abs (n - 250) < 75)
  it "the output layer is for hidden units from 0 to 1, times the factor" $ do
    let begun factor = firstNetwork (NguyenWidrow (replicate 96 (0, 1)) factor) 8 4 (mkStdGen 5)
    (whole, g) <- right (begun 1)
    (small, g') <- right (begun 0.01)
    hiddenUnits small `shouldBe` hiddenUnits whole
    let entries = concat . toLists . outputUnits
    zip (entries whole) (entries small)
      `shouldSatisfy` all (\(a, b) -> abs (b - 0.01 * a) < 1e-12)
    show g `shouldBe` show g'
    let m = 4 * 0.7 * 4 ** (1 / 8)
    map (norm . scaled (replicate 8 (0, 1))) (toLists (outputUnits whole))
      `shouldSatisfy` all (\n -> abs (n - m) < 1e-9)
  it "no units, and ranges other than 96, are refused" $
    map
      (either Just (const Nothing) . uncurry3 firstNetwork)
      [ (NguyenWidrow (replicate 96 (0, 1)) 1, 0, 1),
        (NguyenWidrow (replicate 96 (0, 1)) 1, 1, 0),
        (NguyenWidrow (replicate 95 (0, 1)) 1, 1, 1),
        (NguyenWidrow (replicate 96 (0, 1)) 1, 1, 1)
      ]
      `shouldBe` replicate 3 (Just LayersDoNotFit) ++ [Nothing]
  it "the ranges of images are the least and the greatest of each input" $
    rangesOf [[1, 5, 2], [3, -1, 2]] `shouldBe` [(1, 3), (-1, 5), (2, 2)]
  where
    uncurry3 f (a, b, c) = f a b c (mkStdGen 1)

layerOf :: Int -> [Range] -> Int -> [[Double]]
layerOf s ranges seed = toLists (fst (initnw s ranges (mkStdGen seed)))

-- | A row's weights for inputs that are scaled to -1 to 1.
scaled :: [Range] -> [Double] -> [Double]
scaled ranges row = [w * (b - a) / 2 | (w, (a, b)) <- zip row ranges]

-- | A row's bias for scaled inputs: the sum of the unit in the middle of all ranges.
centredBias :: [Range] -> [Double] -> Double
centredBias ranges row =
  sum (zipWith (\w (a, b) -> w * (a + b) / 2) row ranges) + sum (drop (length ranges) row)

norm :: [Double] -> Double
norm = sqrt . sum . map (^ (2 :: Int))

first :: [Double] -> Double
first values = case filter (/= 0) values of
  v : _ -> v
  [] -> 0

wide :: Range -> Bool
wide (a, b) = a < b

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 * (1 + abs b))

-- | Units, ranges of which at least one is not a point, and a seed.
genLayer :: Gen (Int, [Range], Int)
genLayer = do
  s <- choose (1, 9)
  ranges <- listOf1 genRange `suchThat` any wide
  seed <- arbitrary
  pure (s, ranges, seed)
  where
    genRange = do
      a <- choose (-3, 3)
      d <- oneof [pure 0, choose (0.1, 4)]
      pure (a, a + d)
