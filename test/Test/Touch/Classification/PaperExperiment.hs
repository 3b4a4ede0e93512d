-- | Tests the paper's experiment: its images, its stages, its counts.
module Test.Touch.Classification.PaperExperiment (spec) where

import Control.Monad (forM_)
import Data.List (group, sort, tails, transpose)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Calibration (standardCalibration)
import PraTactile.Classification.Classifier
import PraTactile.Classification.Experiment
import PraTactile.Classification.Logistic (logisticObjective)
import PraTactile.Classification.Means
import PraTactile.Classification.Network (NetworkError (..), outputs)
import PraTactile.Classification.Shipped (ShippedError, shippedAlphabet)
import PraTactile.Classification.Traingdx
import PraTactile.Experiment
import PraTactile.Explore (Turns (..), halfTurns)
import PraTactile.Image
import PraTactile.Sensor (Preset (..), presetSensor)
import PraTactile.Shape
import PraTactile.SymbolImages
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (classify, generate)
import Test.Support
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (paperAlphabet, paperTables)

spec :: Spec
spec = do
  describe "images of symbols" imagesSpec
  describe "the middle stage" middleSpec
  describe "a training" trainingSpec
  describe "the table" tableSpec
  describe "other classifiers" meansSpec

imagesSpec :: Spec
imagesSpec = do
  it "as bitmaps are the shapes" $ do
    known <- right paperAlphabet
    made <- right (labelledImages (symbolsOf known) Bitmaps 2 1)
    labelledAs made
      `shouldBe` [(toRaster b, c) | (c, b) <- zip [0 ..] (shapes known), _ <- [1, 2 :: Int]]
  forM_ [("upright or upside down", AmongTurns halfTurns), ("at any angle", AnyAngle)] $
    \(name, turns) ->
      it ("pressed " ++ name ++ " are upright, and like the shape of their class") $ do
        known <- right paperAlphabet
        let source = Presses "real" (presetSensor Real) turns
            count = byEffort 2 8
        made <- right (labelledImages (Symbols known paperTables) source count 3)
        map snd (labelledAs made) `shouldBe` concatMap (replicate count) [0 .. 3]
        let like image = [alike image (toRaster b) | b <- both]
            both = concat [[b, halfTurned b] | b <- shapes known]
            likest image = snd (maximum (zip (like image) [0 :: Int ..]))
            right' = length [() | (image, c) <- labelledAs made, likest image == 2 * c]
        right' `shouldSatisfy` (>= 4 * count - 1)

-- | The correlation coefficient.
alike :: Raster -> Raster -> Double
alike a b = V.sum (V.zipWith (*) (unit a) (unit b))
  where
    unit image =
      let v = rasterValues image
          centred = V.map (subtract (V.sum v / fromIntegral (V.length v))) v
       in V.map (/ sqrt (V.sum (V.map (^ (2 :: Int)) centred))) centred

-- | Two images of each class, each of one value.
plain :: [(Raster, Int)]
plain = [(constant 8 12 (fromIntegral (10 * c + i)), c) | c <- [0 .. 3], i <- [1, 2 :: Int]]

middleSpec :: Spec
middleSpec = do
  it "has seven images of each class: the clean ones twice, and one with each noise" $ do
    let images = middleImages Stated Noisy plain (plain ++ plain) (mkStdGen 1)
    map length (group (sort (map snd images))) `shouldBe` [7, 7, 7, 7]
    take 16 images `shouldBe` plain ++ plain
    let spreads = [s | (image, _) <- drop 16 images, Just s <- [standardDeviation image]]
        near s d = abs (s - d) < 5 * d / sqrt (2 * 96)
    and (zipWith near spreads (concatMap (replicate 4) [0.1, 0.15, 0.2])) `shouldBe` True
  it "has thirty images with each noise in its larger form" $ do
    let images = middleImages Many Noisy plain (plain ++ plain) (mkStdGen 1)
    map length (group (sort (map snd images))) `shouldBe` [94, 94, 94, 94]
  it "has the same images without noise as its control, and none if it is left out" $ do
    let images = middleImages Many CleanCopies plain (plain ++ plain) (mkStdGen 1)
        noisy = middleImages Many Noisy plain (plain ++ plain) (mkStdGen 1)
    map snd images `shouldBe` map snd noisy
    filter (`notElem` plain) images `shouldBe` []
    -- Noise has the mean 0.
    let apart one other = (\a b -> abs (a - b)) <$> mean (fst one) <*> mean (fst other)
    zipWith apart images noisy `shouldSatisfy` all (< Just (0.2 * 5 / sqrt 96))
    middleImages Many NoMiddle plain (plain ++ plain) (mkStdGen 1) `shouldBe` []
  it "adds noise without clipping, and the same noise to each image for one seed" $
    forAll (genRasterOf 8 12) $ \image -> forAll (choose (0, 3)) $ \deviation seed ->
      let (a, _) = withWhiteNoise deviation image (mkStdGen seed)
          (b, _) = withWhiteNoise 1 (constant 8 12 0) (mkStdGen seed)
          wanted =
            V.zipWith (\v e -> v + deviation * e) (rasterValues image) (rasterValues b)
       in V.and (V.zipWith (\x y -> abs (x - y) < 1e-9) (rasterValues a) wanted)

trainingSpec :: Spec
trainingSpec = do
  it "goes through its stages to their goals, and repeats exactly" $ do
    known <- right paperAlphabet
    let bits = [(toRaster b, c) | (c, b) <- zip [0 ..] (shapes known), _ <- [1, 2 :: Int]]
        go training = trainedBy standardConditions training 4 (Material bits bits) 3
    forM_ (byEffort [Stopped] [Stated, Stopped, Manual]) $ \training -> do
      done <- right (go training Noisy)
      repeated <- right (go training Noisy)
      runNetwork done `shouldBe` runNetwork repeated
      map fst (runStages done) `shouldBe` [1, 2, 3]
      let ends = map (lastEpoch . snd) (runStages done)
          (clean, middle) = stageGoals training
      and (zipWith enough [clean, middle, clean] ends) `shouldBe` True
      none <- right (go training NoMiddle)
      map fst (runStages none) `shouldBe` [1, 3]
      -- The first stage is the same one.
      fmap NonEmpty.toList (lookup 1 (runStages none))
        `shouldBe` fmap NonEmpty.toList (lookup 1 (runStages done))
  it "refuses images of an unknown class" $ do
    let bad = Material [(constant 8 12 0, 4)] [(constant 8 12 0, 0)]
    fmap runNetwork (trainedBy standardConditions Stated 4 bad 1 Noisy)
      `shouldBe` Left (NoSuchClass 4 4)
  it "counts errors by the greatest output" $ do
    known <- right paperAlphabet
    let bits = [(toRaster b, c) | (c, b) <- zip [0 ..] (shapes known)]
        five = concatMap (replicate 5) bits
    done <- right (trainedBy standardConditions Stopped 4 (Material bits bits) 3 NoMiddle)
    let counted = wrongOf (runNetwork done) (testImages 4 five 9)
    map (map snd) counted `shouldBe` replicate 11 (replicate 4 5)
    -- Without noise, where every image is recognised.
    exact <- right (traverse (outputs (runNetwork done) . fst) bits)
    [snd (maximum (zip o [0 :: Int ..])) | o <- exact] `shouldBe` [0 .. 3]
    map fst (head counted) `shouldBe` [0, 0, 0, 0]
  where
    enough limit end =
      epochError end <= limit || epochGradient end < 1e-6 || epochNumber end == 5000

tableSpec :: Spec
tableSpec = do
  it "has the median, the least and the greatest of several values" $ do
    spreadOf [3, 1, 2] `shouldBe` Spread 2 1 3
    spreadOf [4, 1, 2, 8] `shouldBe` Spread 3 1 8
  it "is right by hand for two seeds, two classes and two levels" $ do
    let seed noisy clean none = [counts noisy, counts clean, counts none]
        -- the wrong answers at each level of each class, of 10
        counts levels' = [[(n, 10) | n <- level] | level <- levels']
        found =
          outcomes
            [ seed [[0, 1], [2, 3]] [[1, 1], [3, 3]] [[0, 0], [0, 3]],
              seed [[1, 0], [1, 0]] [[0, 0], [1, 1]] [[5, 0], [5, 0]]
            ]
    map outcomeMiddle found `shouldBe` [Noisy, CleanCopies, NoMiddle]
    -- The worse class of each seed, over both levels: 4 and 2 of 20; 4 and 1; 3 and 10.
    map outcomeWorst found
      `shouldBe` [Spread 15 10 20, Spread 12.5 5 20, Spread 32.5 15 50]
    map outcomeBetterThanClean found `shouldBe` [Just 0, Nothing, Nothing]
    map outcomeBetterThanNone found `shouldBe` [Just 1, Nothing, Nothing]
    map (map snd . outcomeLevels) (take 1 found) `shouldBe` [[Spread 5 5 5, Spread 15 5 25]]
  it "has each training as it is, and then with one change at a time" $ do
    known <- right paperAlphabet
    two <- right (shippedAlphabet 2)
    let rows = plan [Stated, Many] [minBound ..] [two, known] Bitmaps (symbolsOf known)
    map (fromMaybe "" . rowVaried) (filter ((== Many) . rowTraining) rows)
      `shouldBe` [ "",
                   "weights: uniform",
                   "weights: output layer times 0.01",
                   "ranges: of the images",
                   "least gradient: 1e-5",
                   "least gradient: 1e-10",
                   "formula: of the manual",
                   "stages: two images, two others",
                   "images: ideal",
                   "images: paper",
                   "images: real",
                   "images: hard",
                   "alphabet: q = 2"
                 ]

-- | The regression on the paper's shapes, trained once for all tests.
regression :: Either ShippedError Classifier
regression = logisticClassifier (standardCalibration 4) <$> paperAlphabet

meansSpec :: Spec
meansSpec = do
  withCases 20 100
    . it "the nearest mean orders outputs by the correlation with each class's mean image"
    $ forAll (vectorOf 3 (genRasterOf 8 12)) $ \centres ->
      forAll (vectorOf 6 (genRasterOf 8 12)) $ \spoils -> forAll (genRasterOf 8 12) $ \image ->
        let images =
              [ (blend centre spoil, Just c)
                | (c, centre) <- zip [0 ..] centres,
                  spoil <- take 2 (drop (2 * c) spoils)
              ]
            -- So that nothing is certain.
            unclear = [(i, Nothing) | (i, _) <- images]
            blend a b = generate 8 12 (\x y -> valueAt a x y + 0.1 * valueAt b x y)
            meanOf c =
              generate 8 12 (\x y -> sum [valueAt i x y | (i, Just k) <- images, k == c])
            wanted = [alike image (meanOf c) | c <- [0 .. 2]]
            steady = all ((> Just 1e-6) . standardDeviation) (image : map meanOf [0 .. 2])
         in steady ==> whenRight (meanOutputs (meansOf 3 (images ++ unclear)) image) $ \found ->
              let order values = map snd (sort (zip values [0 :: Int ..]))
               in counterexample (show (found, wanted)) $
                    length found === 3
                      .&&. (apart wanted && apart found ==> order found === order wanted)
  it "the gradient of logistic regression is its error's, by differences" $
    forAllBlind genLabelled $ \images -> forAll (vectorOf 194 (choose (-0.1, 0.1))) $ \w ->
      forAll (choose (0, 193)) $ \i ->
        let objective = logisticObjective 2 images
            at e = fst (objective (V.fromList w V.// [(i, w !! i + e)]))
            slope = snd (objective (V.fromList w)) V.! i
            difference = (at 1e-5 - at (-1e-5)) / 2e-5
         in counterexample (show (slope, difference)) (abs (slope - difference) < 1e-5)
  it "the error of the regression is the sum of -log p of the truths, plus half of all squares" $
    forAllBlind genLabelled $ \images -> forAll (vectorOf 194 (choose (-0.1, 0.1))) $ \w ->
      let chance k (image, named) =
            let s = sum (zipWith (*) (drop (97 * k) w) (V.toList (rasterValues image) ++ [1]))
                y = 1 / (1 + exp (-s))
             in if named == Just k then y else 1 - y
          wanted = sum [-log (chance k one) | one <- images, k <- [0, 1]] + sum (map (^ two) w) / 2
          two = 2 :: Int
          found = fst (logisticObjective 2 images (V.fromList w))
       in counterexample (show (found, wanted)) (abs (found - wanted) < 1e-9 * (1 + wanted))
  it "the fit has nearly the least error, and its outputs are 1 / (1 + exp (-w x))" $ do
    images <- learningImages <$> right paperAlphabet
    told <- classifierOutputs <$> right regression
    let -- For an image of 0 a class's output shows its bias; a single 1 adds one weight.
        single i = generate 8 12 (\x y -> if Just (8 * y + x) == i then 1 else 0)
        odds i = map (\y -> log (y / (1 - y))) <$> right (told (single i))
    biases <- odds Nothing
    ones <- traverse (odds . Just) [0 .. 95]
    let rows' = transpose (map (zipWith subtract biases) ones ++ [biases])
        w = V.fromList (concat rows')
        (least, slope) = logisticObjective 4 images w
        (begun, _) = logisticObjective 4 images (V.map (const 0) w)
        -- The error bends upwards by at least 1, so no weights have less than this.
        bound = least - V.sum (V.map (^ (2 :: Int)) slope) / 2
    (begun, least, bound) `shouldSatisfy` \_ -> least - bound < 0.01 * (begun - bound)
    forM_ (take 9 images) $ \(image, _) -> do
      found <- right (told image)
      let values = V.toList (rasterValues image) ++ [1]
          wanted = [1 / (1 + exp (-sum (zipWith (*) row values))) | row <- rows']
      zipWith (-) found wanted `shouldSatisfy` \off -> length off == 4 && all ((< 1e-9) . abs) off
  it "both recognise every shape either way up, by the same interface as the network" $ do
    known <- right paperAlphabet
    byRegression <- right regression
    let learnt = [meansClassifier (standardCalibration 4) known, byRegression]
    forM_ [(c, b, t) | (c, b) <- zip [0 ..] (shapes known), t <- [identity, turned 2]] $
      \(c, b, turn) -> forM_ learnt $ \classifier -> do
        shown <- right (classified classifier (onRaster turn (toRaster b)))
        (classifiedVerdict shown, classifiedSymbol shown) `shouldBe` (Recognised, Just (c, turn))
        sum (classifiedNone shown : classifiedChances shown)
          `shouldSatisfy` \s -> abs (s - 1) < 1e-12
        classifiedNone shown `shouldSatisfy` (< 0.01)
  where
    genLabelled = listOf1 ((,) <$> genRasterOf 8 12 <*> elements [Nothing, Just 0, Just 1])
    apart values = and [abs (a - b) > 1e-9 | a : others <- tails values, b <- others]
    valueAt image x y = fromMaybe 0 (index image x y)
