-- | Tests rasters, their correlation, and the random draws.
module Test.Touch.Image.RastersAndCorrelation
  ( spec,
    genRaster,
    genRasterWithin,
    genRasterOf,
  )
where

import Data.List (genericLength)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import Data.Word (Word64)
import PraTactile.Image
import PraTactile.Image.Correlate
import PraTactile.Random
import PraTactile.Symmetry
import System.Random (RandomGen (..), mkStdGen)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)

-- | A raster of one to twelve columns and rows with values from 0 to 1.
genRaster :: Gen Raster
genRaster = genRasterWithin (1, 12)

-- | A raster whose sides are within bounds.
genRasterWithin :: (Int, Int) -> Gen Raster
genRasterWithin sides = do
  w <- choose sides
  h <- choose sides
  genRasterOf w h

-- | A raster of this size with values from 0 to 1.
genRasterOf :: Int -> Int -> Gen Raster
genRasterOf w h = fromList w h <$> vectorOf (w * h) (choose (0, 1))

fromList :: Int -> Int -> [Double] -> Raster
fromList w h values = generate w h (\x y -> fromMaybe 0 (numbered V.!? (y * w + x)))
  where
    numbered = V.fromList values

spec :: Spec
spec = do
  describe "Rasters" rasters
  describe "Symmetries" seenAs
  describe "Statistics" statistics
  describe "Correlation" correlation
  describe "Random draws" draws

rasters :: Spec
rasters = do
  it "fromRows (toRows r) = r" $ forAll genRaster $ \r -> fromRows (toRows r) === Right r
  it "raster w h (rasterValues r) = r" $
    forAll genRaster $ \r -> raster (rasterWidth r) (rasterHeight r) (rasterValues r) === Right r
  it "there are always width * height values" $
    property $ \(Small w) (Small h) ->
      let r =
            generate w h (\_ _ -> 0)
       in V.length (rasterValues r) === rasterWidth r * rasterHeight r
  it "refuses rows of different length, naming the first" $
    fromRows [[1, 2], [3, 4], [5], [6, 7, 8]] `shouldBe` Left (RaggedRow 2 1 2)
  it "refuses a wrong number of values, also where width * height overflows" $ do
    raster 2 2 (V.fromList [1, 2, 3]) `shouldBe` Left (WrongValueCount 2 2 3)
    raster (2 ^ (32 :: Int)) (2 ^ (32 :: Int)) V.empty
      `shouldBe` Left (WrongValueCount (2 ^ (32 :: Int)) (2 ^ (32 :: Int)) 0)
    raster (-1) (-1) (V.fromList [1]) `shouldBe` Left (WrongValueCount (-1) (-1) 1)
  it "index (generate w h f) x y = f x y inside, Nothing outside" $
    forAll ((,) <$> choose (-2, 9) <*> choose (-2, 9)) $ \(x, y) ->
      index (generate 7 5 (\i j -> fromIntegral (10 * i + j))) x y
        === ( if x >= 0 && x < 7 && y >= 0 && y < 5
                then Just (fromIntegral (10 * x + y))
                else Nothing
            )
  it "index (crop (x, y) (w, h) r) i j = index r (x + i) (y + j)" $
    forAll genRaster $ \r ->
      forAll ((,) <$> choose (0, rasterWidth r) <*> choose (0, rasterHeight r)) $ \(x, y) ->
        let w = rasterWidth r - x
            h = rasterHeight r - y
         in fmap (\c -> [index c i j | i <- [0 .. w - 1], j <- [0 .. h - 1]]) (crop (x, y) (w, h) r)
              === Right [index r (x + i) (y + j) | i <- [0 .. w - 1], j <- [0 .. h - 1]]
  it "refuses to crop beyond the image" $ do
    let r = constant 4 3 1
    crop (1, 1) (4, 1) r `shouldBe` Left (OutsideImage (1, 1, 4, 1) (4, 3))
    crop (-1, 0) (1, 1) r `shouldBe` Left (OutsideImage (-1, 0, 1, 1) (4, 3))
    crop (0, 0) (maxBound, 1) r `shouldBe` Left (OutsideImage (0, 0, maxBound, 1) (4, 3))
  it "sample at a pixel's centre is its value" $
    forAll genRaster $ \r ->
      and
        [ sample r (fromIntegral x) (fromIntegral y) == v
          | (y, row) <- zip [0 :: Int ..] (toRows r),
            (x, v) <- zip [0 :: Int ..] row
        ]
  it "sample of the plane a x + b y + c is the plane" $
    forAll ((,,) <$> choose (-1, 1) <*> choose (-1, 1) <*> choose (-1, 1)) $ \(a, b, c) ->
      forAll ((,) <$> choose (0, 6) <*> choose (0, 4)) $ \(x, y) ->
        let plane i j = a * i + b * j + c
         in abs
              ( sample (generate 7 5 (\i j -> plane (fromIntegral i) (fromIntegral j))) x y
                  - plane x y
              )
              < 1e-12
  it "sample beyond the edge is the edge's value, and 0 of an empty raster" $ do
    sample (generate 2 2 (\x y -> fromIntegral (x + 2 * y))) 99 (-99) `shouldBe` 1
    sample (generate 2 2 (\x y -> fromIntegral (x + 2 * y))) (1 / 0) (1 / 0) `shouldBe` 3
    sample (constant 0 3 1) 0 0 `shouldBe` 0
  it "refuses to zip rasters of different size" $
    zipRaster (+) (constant 2 3 1) (constant 3 2 1) `shouldBe` Left (SizesDiffer (2, 3) (3, 2))

seenAs :: Spec
seenAs = do
  it "toRows . onRaster g = onRows g . toRows" $
    forAll genRaster $ \r ->
      conjoin [toRows (onRaster g r) === onRows g (toRows r) | g <- symmetries, hasPixels r]
  it "onRaster (g <> h) = onRaster g . onRaster h" $
    forAll genRaster $ \r ->
      conjoin
        [ onRaster (g <> h) r === onRaster g (onRaster h r)
          | g <- symmetries,
            h <- symmetries
        ]
  it "onRaster identity = id" $ forAll genRaster $ \r -> onRaster identity r === r
  it "a quarter turn takes the upper left pixel to the upper right" $
    (toRows . onRaster (turned 1) <$> fromRows [[1, 2, 3], [4, 5, 6]])
      `shouldBe` Right [[4, 1], [5, 2], [6, 3]]
  where
    -- Rows of an image without pixels do not determine its size.
    hasPixels r = rasterWidth r > 0 && rasterHeight r > 0

statistics :: Spec
statistics = do
  it "mean and standard deviation are those of the definition" $
    forAll genRaster $ \r ->
      let vs = concat (toRows r)
          m = sum vs / genericLength vs
          sd = sqrt (sum [(v - m) * (v - m) | v <- vs] / genericLength vs)
       in fmap (\x -> abs (x - m) < 1e-12) (mean r) === Just True
            .&&. fmap (\x -> abs (x - sd) < 1e-12) (standardDeviation r) === Just True
  it "the quantiles 0 and 1 are the least and the greatest value" $
    forAll genRaster $ \r -> (quantile 0 r, quantile 1 r) === (minimumValue r, maximumValue r)
  it "the middle quantile of 1, 2, 3, 10 is 2.5" $
    (quantile 0.5 <$> fromRows [[10, 2], [3, 1]]) `shouldBe` Right (Just 2.5)
  it "an empty raster has no statistics" $
    [mean none, standardDeviation none, minimumValue none, maximumValue none, quantile 0.5 none]
      `shouldBe` replicate 5 Nothing
  where
    none = constant 0 0 1

-- | The module's formulas on lists.
naive :: Raster -> Raster -> Raster -> (Double, Double) -> Overlap
naive sums weights image (dx, dy)
  | n <= 0 = Overlap 0 0 0 0
  | otherwise = Overlap n (covariance f f) (covariance c c) (covariance f c)
  where
    pixels =
      [ (m, v, s / m)
        | (y, row) <- zip [0 ..] (toRows image),
          (x, v) <- zip [0 ..] row,
          Just (s, m) <- [at (x + dx) (y + dy)],
          m > 0
      ]
    at px py = do
      let bx = floor px :: Int
          by = floor py :: Int
          four =
            [ (share, bx + i, by + j)
              | (i, sx) <- [(0, fromIntegral bx + 1 - px), (1, px - fromIntegral bx)],
                (j, sy) <- [(0, fromIntegral by + 1 - py), (1, py - fromIntegral by)],
                let share = sx * sy,
                sx > 0,
                sy > 0
            ]
      parts <-
        traverse
          ( \(share, i, j) ->
              (\s m -> (share * s, share * m)) <$> index sums i j <*> index weights i j
          )
          four
      pure (sum (map fst parts), sum (map snd parts))
    n = sum [m | (m, _, _) <- pixels]
    average g = sum [m * g p | p@(m, _, _) <- pixels] / n
    covariance g h = average (\p -> (g p - average g) * (h p - average h))
    f (_, v, _) = v
    c (_, _, v) = v

correlation :: Spec
correlation = do
  it "the overlap is that of the definition, at whole and at fractional displacements" $
    forAll scene $ \(sums, weights, image) ->
      forAll displacement $ \(dx, dy) ->
        let fast = (\ref -> overlapAt ref image dx dy) <$> reference sums weights
         in counterexample (show (fast, naive sums weights image (dx, dy))) $
              either (const False) (`agrees` naive sums weights image (dx, dy)) fast
  it "images far apart, or at a displacement of NaN, do not overlap" $
    forAll (genRasterOf 5 4) $ \image ->
      forAll (elements [1e9, -1e9, 1e300, 0 / 0, 1 / 0]) $ \far ->
        let ref = referenceOf image
         in map (\(dx, dy) -> overlapAt ref image dx dy) [(far, 0), (0, far), (far, far)]
              === replicate 3 (Overlap 0 0 0 0)
  it "an image matches itself with zncc 1, its negative with -1" $
    forAll (genRasterOf 5 4) $ \image ->
      let ref = referenceOf image
          near target = maybe False (\z -> abs (z - target) < 1e-9)
       in near 1 (zncc (overlapAt ref image 0 0))
            .&&. near (-1) (zncc (overlapAt ref (mapRaster negate image) 0 0))
  it "zncc does not depend on gain and offset" $
    forAll (genRasterOf 6 6) $ \image ->
      forAll
        ((,,) <$> genRasterOf 9 9 <*> choose (0.1, 3) <*> choose (-1, 1))
        $ \(big, gain, lift) ->
          let z i = zncc (overlapAt (referenceOf big) i 1.5 2)
           in case (z image, z (mapRaster (\v -> gain * v + lift) image)) of
                (Just a, Just b) -> abs (a - b) < 1e-9
                (a, b) -> a == b
  it "zncc lies between -1 and 1" $
    forAll scene $ \(sums, weights, image) ->
      forAll displacement $ \(dx, dy) ->
        either
          (const False)
          (\ref -> maybe True (\z -> abs z <= 1) (zncc (overlapAt ref image dx dy)))
          (reference sums weights)
  it "a flat image has no zncc, nor does one that does not meet the reference" $ do
    zncc (overlapAt (referenceOf (generate 5 5 (\x _ -> fromIntegral x))) (constant 3 3 0.7) 1 1)
      `shouldBe` Nothing
    let r = generate 5 5 (\x y -> fromIntegral (x * y))
    map
      (zncc . uncurry (overlapAt (referenceOf r) r))
      [(5, 0), (0, -5), (1e300, 0), (0 / 0, 0), (0, -1 / 0)]
      `shouldBe` replicate 5 Nothing
  it "refuses sums and weights of different size" $
    either Just (const Nothing) (reference (constant 2 2 1) (constant 2 3 1))
      `shouldBe` Just (SizesDiffer (2, 2) (2, 3))
  it "referenceAt interpolates by weight, and is Nothing outside" $ do
    let ref =
          either
            (const Nothing)
            Just
            ( reference
                (generate 2 1 (\x _ -> fromIntegral (6 * x)))
                (generate 2 1 (\x _ -> fromIntegral (1 + x)))
            )
    -- Values 0 with weight 1 and 3 with weight 2: halfway (0 + 6) / (1 + 2).
    (ref >>= \r -> referenceAt r 0.5 0) `shouldBe` Just (2, 1.5)
    (ref >>= \r -> referenceAt r (-0.5) 0) `shouldBe` Just (0, 0.5)
    (ref >>= \r -> referenceAt r 2 0) `shouldBe` Nothing
    (ref >>= \r -> referenceAt r (0 / 0) 0) `shouldBe` Nothing
  where
    scene = do
      w <- choose (1, 8)
      h <- choose (1, 8)
      values <- genRasterOf w h
      weights <- fromList w h <$> vectorOf (w * h) (frequency [(1, pure 0), (3, choose (0.1, 3))])
      image <- genRaster
      let sums = either (const values) id (zipRaster (*) values weights)
      pure (sums, weights, image)
    displacement = (,) <$> offset <*> offset
    offset = oneof [fromIntegral <$> choose (-9 :: Int, 9), choose (-9, 9)]
    agrees (Overlap n a b c) (Overlap n' a' b' c') =
      and (zipWith (\p q -> abs (p - q) < 1e-9) [n, a, b, c] [n', a', b', c'])

-- | A generator that repeats its words.
newtype Repeating = Repeating [Word64]

instance RandomGen Repeating where
  genWord64 (Repeating ws) = case ws of
    [] -> (0, Repeating [])
    w : rest -> (w, Repeating (rest ++ [w]))
  genWord32 g = let (w, g') = genWord64 g in (fromIntegral w, g')
  split g = (g, g)

draws :: Spec
draws = do
  it "uniform draws lie in [0, 1), at the extremes of the generator's words too" $ do
    map (fst . uniform . Repeating . pure) [0, maxBound] `shouldBe` [0, 1 - 2 ** (-53)]
    fst (uniform (Repeating [2 ^ (63 :: Int)])) `shouldBe` 0.5
  it "normal draws are finite at the extremes of the generator's words" $
    [ v
      | ws <- [[0, 0], [0, maxBound], [maxBound, 0], [maxBound, maxBound]],
        let ((a, b), _) = normalPair (Repeating ws),
        v <- [a, b],
        isNaN v || isInfinite v
    ]
      `shouldBe` []
  it "the moments of 100000 normal draws are 0, 1, 0, 3 within five standard errors" $ do
    let count = 100000 :: Int
        n = fromIntegral count
        (vs, _) = normals count (mkStdGen 20040501)
        moment k = V.sum (V.map (^ (k :: Int)) vs) / n
    -- The variances of the sample moments of order 1 to 4 are 1/n, 2/n, 15/n and 96/n.
    abs (moment 1) `shouldSatisfy` (< 5 * sqrt (1 / n))
    abs (moment 2 - 1) `shouldSatisfy` (< 5 * sqrt (2 / n))
    abs (moment 3) `shouldSatisfy` (< 5 * sqrt (15 / n))
    abs (moment 4 - 3) `shouldSatisfy` (< 5 * sqrt (96 / n))
  it "the two draws of a pair are uncorrelated within five standard errors" $ do
    let count = 50000 :: Int
        (vs, _) = normals (2 * count) (mkStdGen 7)
        products =
          V.generate count (\i -> fromMaybe 0 (vs V.!? (2 * i)) * fromMaybe 0 (vs V.!? (2 * i + 1)))
    abs (V.sum products / fromIntegral count) `shouldSatisfy` (< 5 / sqrt (fromIntegral count))
  it "normals n gives n draws, the pairs in turn" $
    forAll (choose (-2, 9)) $ \n ->
      let (vs, _) = normals n (mkStdGen 3)
          pairs g = let ((a, b), g') = normalPair g in a : b : pairs g'
       in V.toList vs === take n (pairs (mkStdGen 3))
  it "the same seed gives the same draws" $
    property $ \seed -> fst (normals 5 (mkStdGen seed)) === fst (normals 5 (mkStdGen seed))
