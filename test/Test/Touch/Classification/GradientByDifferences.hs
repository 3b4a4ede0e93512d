-- | Tests training: batches, gradients against finite differences, descent, synthetic images.
module Test.Touch.Classification.GradientByDifferences (spec) where

import Data.List (sort)
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra (Matrix, accum, atIndex, fromLists)
import PraTactile.Classification.Network
import PraTactile.Classification.Regimen
import PraTactile.Classification.Samples
import PraTactile.Classification.Specimens
import PraTactile.Classification.Train
import PraTactile.Classification.Traingdx
import PraTactile.Image (Raster, constant, generate, index, rasterValues, toRows)
import PraTactile.Shape
import PraTactile.Symmetry (onRows, turned)
import System.Random (mkStdGen)
import Test.Effort (byEffort, whenFull)
import Test.Hspec
import Test.QuickCheck hiding (classify, generate, label, output)
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  describe "A batch" $
    it "refuses no images, images that are not 8 x 12, and unknown classes" $
      [ either Just (const Nothing) (batch 2 images)
        | images <-
            [ [],
              [(constant 8 11 0, Nothing)],
              [(constant 8 12 0, Just 2)],
              [(constant 8 12 0, Just (-1))],
              [(constant 8 12 0, Just 1)]
            ]
      ]
        `shouldBe` [ Just EmptyBatch,
                     Just (WrongImageSize 8 11),
                     Just (NoSuchClass 2 2),
                     Just (NoSuchClass 2 (-1)),
                     Nothing
                   ]

  describe "Backpropagation" $ do
    it "squaredError = the sum over images and outputs of (output - target)^2" $
      property $
        forAll problemGen $ \(n, images) ->
          let expected =
                [ (y - target) ^ (2 :: Int)
                  | (image, label) <- images,
                    Right ys <- [outputs n image],
                    (k, y) <- zip [0 ..] ys,
                    let target = if label == Just k then 1 else 0
                ]
           in (batch (outputCount n) images >>= squaredError n) `nearly` sum expected
    it "gradient = the finite difference of squaredError, for a sample of all weights" $
      property $
        withMaxSuccess 20 $
          forAll problemGen $ \(n, images) -> forAll (vectorOf 12 (choose (0, 96))) $ \columns ->
            let b = batch (outputCount n) images
                difference move =
                  (/ 2e-5)
                    <$> ( (-)
                            <$> (b >>= \b' -> move 1e-5 >>= (`squaredError` b'))
                            <*> (b >>= \b' -> move (-1e-5) >>= (`squaredError` b'))
                        )
                slopes = b >>= gradient n
                hidden = [(i, j) | i <- [0 .. hiddenCount n - 1], j <- 96 : columns]
                output = [(i, j) | i <- [0 .. outputCount n - 1], j <- [0 .. hiddenCount n]]
             in conjoin $
                  [ fmap ((`atIndex` p) . fst) slopes
                      `close` difference
                        (\e -> network (nudged p e (hiddenUnits n)) (outputUnits n))
                    | p <- hidden
                  ]
                    ++ [ fmap ((`atIndex` p) . snd) slopes
                           `close` difference
                             (\e -> network (hiddenUnits n) (nudged p e (outputUnits n)))
                         | p <- output
                       ]
    it "refuses a batch for another number of classes" $
      ( do
          (n, _) <-
            initialNetwork 2 3 (mkStdGen 1)
          b <- batch 2 [(constant 8 12 0, Nothing)]
          squaredError n b
      )
        `shouldBe` Left (WrongOutputCount 3 2)

  describe "Descent" $ do
    it "lowers the error within 50 epochs" $
      property $
        withMaxSuccess 10 $
          forAll problemGen $ \(n, images) ->
            case batch (outputCount n) images >>= \b -> train shippedDescent {epochs = 50} b n of
              Right (_, progress) ->
                counterexample (show progress) (errorAfter progress < errorBefore progress)
              Left refusal -> counterexample (show refusal) False

  describe "A training" $ do
    it "with one seed gives one network to the bit, and with another seed another network" $ do
      let trained seed =
            paperAlphabet' >>= \a -> either (Left . show) (Right . fst) (trainWith short a seed)
          short = byEffort (regimenOf 25 20) (regimenOf 5 200)
          first = trained 5
      trained 5 `shouldBe` first
      (trained 6 == first) `shouldBe` False
    whenFull . it "of 400 epochs on a fifth of the images finds clean shapes and half turns" $ do
      let verdicts = do
            a <- paperAlphabet'
            (n, _) <- either (Left . show) Right (trainWith (regimenOf 5 200) a 5)
            either
              (Left . show)
              Right
              ( mapM
                  (fmap (greatest 0.5) . outputs n)
                  (concat [[toRaster b, toRaster (halfTurned b)] | b <- shapes a])
              )
      verdicts
        `shouldBe` Right [Just 0, Nothing, Just 1, Nothing, Just 2, Nothing, Just 3, Nothing]
    it "the shipped regimen is the paper's: 8 hidden units, momentum 0.95, 5000 epochs" $ do
      hiddenLayerSize shippedRegimen `shouldBe` 8
      sum [stageRounds s * epochs (roundDescent s) | s <- stages shippedRegimen] `shouldBe` 5000
      [momentum (roundDescent s) | s <- stages shippedRegimen] `shouldBe` replicate 5 0.95
      map (maximum . stageNoise) (stages shippedRegimen) `shouldBe` [0, 0.1, 0.15, 0.2, 0]
      map (minimum . stageNoise) (stages shippedRegimen) `shouldBe` replicate 5 0
      map (length . stageNoise) (stages shippedRegimen) `shouldBe` [1, 2, 2, 2, 1]
    it "has the stated number of images of each sort for each class" $ do
      let among kinds = sum [n | (kind, n) <- composition shippedRegimen, kind `elem` kinds]
          upsideDown = [UpsideDown, CurtailedUpsideDown]
      among [Upright, Curtailed] `shouldBe` 375
      3 * among [Curtailed] `shouldBe` 375
      among upsideDown `shouldBe` 225
      among [Bare] `shouldBe` 5
      among (filter (`notElem` (Bare : upsideDown)) impostors) `shouldBe` 650
      sort (map fst (composition shippedRegimen)) `shouldBe` [minBound .. maxBound]

  describe "Synthetic images" $ do
    it "a symbol in an exact view is its bitmap" $
      onShapes $ \b -> see exactView (symbolScene b) `shouldBe` toRaster b
    it "a symbol shifted by whole taxels is its bitmap shifted" $
      onShapes $ \b ->
        see exactView {viewShift = (2, -1)} (symbolScene b)
          `shouldBe` generate 8 12 (\x y -> bit (embossedAt b (x - 2) (y + 1)))
    it "a symbol shifted by half a taxel has in each taxel the mean of the two it lies across" $
      onShapes $ \b ->
        see exactView {viewShift = (0.5, 0)} (symbolScene b)
          `shouldBe` generate
            8
            12
            (\x y -> (bit (embossedAt b x y) + bit (embossedAt b (x - 1) y)) / 2)
    it "a symbol blurred by 0.4 along the rows has in each taxel 0.2, 0.6 and 0.2 of three" $
      onShapes $ \b ->
        toRows (see exactView {viewBlur = (0.4, 0)} (symbolScene b))
          `shouldSatisfy` \seen ->
            and
              [ abs (v - (0.6 * at b x y + 0.2 * at b (x - 1) y + 0.2 * at b (x + 1) y)) < 1e-12
                | (y, row) <- zip [0 ..] seen,
                  (x, v) <- zip [0 ..] row
              ]
    it "gain and base are the values of embossed and flat taxels" $
      onShapes $ \b ->
        toRows (see exactView {viewGain = 0.75, viewBase = 0.25} (symbolScene b))
          `shouldBe` [[if e then 0.75 else 0.25 | e <- row] | row <- bitmapRows b]
    it "two halves of one shape are that shape" $
      onShapes $ \b ->
        map (see exactView) [besideScene b b, overScene b b] `shouldBe` [toRaster b, toRaster b]
    it "a symbol on its side is a quarter turn clockwise, seen through the window" $
      onShapes $ \b ->
        let lying = onRows (turned 1) (bitmapRows b)
            expected =
              replicate 2 (replicate 8 False)
                ++ map (take 8 . drop 2) lying
                ++ replicate 2 (replicate 8 False)
         in toRows (see exactView (sidewaysScene b)) `shouldBe` map (map bit) expected
    it "values with noise lie from 0 to 1 in steps of 1/255; without, they are the nearest steps" $
      property $ \seed -> forAll (choose (0, 0.5)) $ \deviation ->
        let image = constant 8 12 0.5
            (noisy, _) = withNoise deviation image (mkStdGen seed)
            (plain, _) = withNoise 0 image (mkStdGen seed)
            steps = map (* 255) (V.toList (rasterValues noisy))
         in conjoin
              ( map
                  ( \s ->
                      counterexample
                        (show s)
                        (s >= 0 && s <= 255 && abs (s - fromIntegral (round s :: Int)) < 1e-9)
                  )
                  steps
              )
              .&&. plain === constant 8 12 (128 / 255)
    it "the noise has the requested standard deviation" $ do
      let (noisy, _) = withNoise 0.1 (constant 100 100 0.5) (mkStdGen 1)
          deviations = map (subtract 0.5) (V.toList (rasterValues noisy))
      -- The standard error of a standard deviation from 10^4 draws is 0.7 %: four of them, and the
      -- rounding.
      sqrt (sum (map (^ (2 :: Int)) deviations) / 10000) `shouldSatisfy` \s -> abs (s - 0.1) < 0.003
    it "an unseen corner is flat, an unseen margin repeats the last seen, and the rest stays" $ do
      let image = generate 8 12 (\x y -> fromIntegral (100 * x + y + 1))
          cell unseen x y = index (withUnseen unseen image) x y
          corner = CornerUnseen (Corner True False 2 3)
      [cell corner x y | (x, y) <- [(6, 2), (7, 0), (5, 2), (6, 3), (0, 0)]]
        `shouldBe` map Just [0, 0, 503, 604, 1]
      [cell (ColumnsUnseen False 2) x 4 | x <- [0, 1, 2, 3]]
        `shouldBe` map Just [205, 205, 205, 305]
      [cell (RowsUnseen True 1) 0 y | y <- [9, 10, 11]] `shouldBe` map Just [10, 11, 11]

errorBefore, errorAfter :: Trace -> Double
errorBefore = epochError . NonEmpty.head
errorAfter = epochError . lastEpoch

-- | A regimen of two rounds on one of this many parts of the images, with this many epochs each.
regimenOf :: Int -> Int -> Regimen
regimenOf share many =
  shippedRegimen
    { composition =
        [(kind, max 1 (count `div` share)) | (kind, count) <- composition shippedRegimen],
      stages =
        [Stage 1 shippedDescent {epochs = many} noise | noise <- [[0], [0, 0.1]]]
    }

paperAlphabet' :: Either String Alphabet
paperAlphabet' = either (Left . show) Right paperAlphabet

onShapes :: (Bitmap -> Expectation) -> Expectation
onShapes check = either (expectationFailure . show) (mapM_ check . shapes) paperAlphabet

greatest :: Double -> [Double] -> Maybe Int
greatest least ys = case [k | (k, y) <- zip [0 ..] ys, y >= least, y == maximum ys] of
  [k] -> Just k
  _ -> Nothing

bit :: Bool -> Double
bit e = if e then 1 else 0

at :: Bitmap -> Int -> Int -> Double
at b x y = bit (embossedAt b x y)

-- | The matrix with one entry changed by this amount.
nudged :: (Int, Int) -> Double -> Matrix Double -> Matrix Double
nudged p e m = accum m (+) [(p, e)]

nearly :: Either NetworkError Double -> Double -> Property
nearly (Right a) b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 * (1 + abs b))
nearly (Left refusal) _ = counterexample (show refusal) False

close :: Either NetworkError Double -> Either NetworkError Double -> Property
close (Right a) (Right b) = counterexample (show (a, b)) (abs (a - b) <= 1e-6 * (1 + abs b))
close a b = counterexample (show (a, b)) False

-- | A small random network, and some images with random classes or none.
problemGen :: Gen (Network, [(Raster, Maybe Int)])
problemGen = do
  q <- choose (1, 3)
  h <- choose (1, 3)
  count <- choose (1, 6)
  images <- vectorOf count ((,) <$> imageGen <*> oneof [pure Nothing, Just <$> choose (0, q - 1)])
  let weights r c = fromLists <$> vectorOf r (vectorOf c (choose (-0.4, 0.4)))
  n <- suchThatMap (network <$> weights h 97 <*> weights q (h + 1)) (either (const Nothing) Just)
  pure (n, images)

imageGen :: Gen Raster
imageGen = do
  values <- V.fromList <$> vectorOf 96 (choose (0, 1))
  pure (generate 8 12 (\x y -> values V.! (8 * y + x)))
