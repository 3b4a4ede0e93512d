{-# OPTIONS_GHC -O1 #-}

-- | Tests the parts of recognising a symbol, each against its definition: the likeness of an image
-- to a shape, and the certainty of an estimate.
module Test.Touch.Classification.EstimatesByPosterior (spec) where

import Data.Bifunctor (first)
import Data.Foldable (for_)
import Data.List (unfoldr)
import Data.Maybe (fromMaybe)
import Data.Text.Encoding (encodeUtf8)
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Calibration
import PraTactile.Classification.Estimate
import PraTactile.Classification.FreeForm
import PraTactile.Classification.Part
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Classification.Regimen
import PraTactile.Classification.Specimens
import PraTactile.Classification.Templates
import PraTactile.Image hiding (mean)
import PraTactile.Random (uniform)
import PraTactile.Segmentation (Part (..))
import PraTactile.Shape
import PraTactile.Shape.Distance (separation)
import PraTactile.Steps
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Effort (byEffort)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (paperReader)

spec :: Spec
spec = do
  describe "Likeness" likenessSpec
  describe "Estimates" estimateSpec
  describe "A part of a symbol" partSpec
  it "images without noise levels have noise 0, and symbols alone have a class" $ do
    let made noises = fst (roundImages [(Upright, 2), (Bare, 3)] noises known (mkStdGen 7))
    made [] `shouldBe` made [0]
    map snd (made []) `shouldBe` concat [[Just k, Just k] | k <- [0 .. 3]] ++ replicate 12 Nothing
  it "counting steps from 1 leaves their result" $
    property $ \steps ->
      let those = foldr Step (Done 'r') (steps :: [Int])
       in (stepsDone (counted those), result (counted those)) === ([1 .. length steps], 'r')

near :: Double -> Double -> Property
near wanted came = counterexample (show (wanted, came)) (abs (wanted - came) < 1e-9)

known :: Alphabet
known = readerAlphabet paperReader

seen :: Templates
seen = readerTemplates paperReader

-- | A shape moved right and down by these taxels, interpolated between its taxels; flat outside its
-- box.
moved :: Bitmap -> (Double, Double) -> [[Double]]
moved shape (dx, dy) =
  [ [ sum
        [ share (x - dx) i * share (y - dy) j
          | i <- [-3 .. 10],
            j <- [-3 .. 14],
            embossedAt shape i j
        ]
      | x <- [0 .. 7]
    ]
    | y <- [0 .. 11]
  ]
  where
    share t i = max 0 (1 - abs (t - fromIntegral i))

likenessSpec :: Spec
likenessSpec = do
  it "is the greatest correlation with the shape, moved by up to half a taxel" $
    withMaxSuccess 15 $
      forAll (genRasterOf 8 12) $ \image ->
        conjoin
          [ near
              (maximum [correlated image (moved shape (dx, dy)) | dx <- halves, dy <- halves])
              (match seen c image)
            | (c, shape) <- zip [0 ..] (shapes known)
          ]
  it "has one template for each shape" $ templateCount seen `shouldBe` length (shapes known)
  it "does not change with the gain of an image, however faint" $
    withMaxSuccess 15 $
      forAll (genRasterOf 8 12) $ \image -> forAll (elements [1e-3, 0.1, 30]) $ \gain ->
        conjoin
          [ near (match seen c image) (match seen c (mapRaster (\v -> 0.3 + gain * v) image))
            | c <- [0 .. 3]
          ]
  it "is 0 for a constant image, for another size, and for an unknown class" $ do
    let shape = generate 8 12 (\x y -> fromIntegral (x * y))
    [match seen c (constant 8 12 v) | c <- [0 .. 3], v <- [0, 0.3, 0.5, 1]]
      `shouldSatisfy` all ((< 1e-9) . abs)
    for_ [(8, 11), (12, 8), (0, 0)] $ \(w, h) ->
      match seen 0 (generate w h (\x y -> fromIntegral (x * y))) `shouldBe` 0
    [match seen c shape | c <- [-1, 4]] `shouldBe` [0, 0]
    [squaredDistances seen c shape shape | c <- [-1, 4]] `shouldBe` [[], []]
  it "by distance is the weighted sum of squares, for each move by up to a taxel" $
    withMaxSuccess 15 $
      forAll ((,) <$> genRasterOf 8 12 <*> genRasterOf 8 12) $ \(image, weight) ->
        conjoin
          [ map fst found === [(dx, dy) | dx <- [-1, -0.5 .. 1], dy <- [-1, -0.5 .. 1]]
              .&&. conjoin
                [ near
                    ( sum
                        [ w * (v - t) * (v - t)
                          | (w, v, t) <-
                              zip3
                                (concat (toRows weight))
                                (concat (toRows image))
                                (concat (moved shape move))
                        ]
                    )
                    distance
                  | (move, distance) <- found
                ]
            | (c, shape) <- zip [0 ..] (shapes known),
              let found = squaredDistances seen c image weight
          ]
  where
    halves = [-0.5, 0, 0.5]

correlated :: Raster -> [[Double]] -> Double
correlated image rows = correlation (concat (toRows image)) (concat rows)

correlation :: [Double] -> [Double] -> Double
correlation us vs = product' a b / sqrt (product' a a * product' b b)
  where
    (a, b) = (centred us, centred vs)
    centred values = map (subtract (sum values / fromIntegral (length values))) values
    product' p q = sum (zipWith (*) p q)

estimateSpec :: Spec
estimateSpec = do
  it "have the probabilities that outputs, likenesses and offsets give" $
    withMaxSuccess (byEffort 60 200) $
      forAll
        ( (,,,) <$> genCalibration <*> genRasterOf 8 12 <*> vectorOf 4 genOutput
            <*> vectorOf 4 genOutput
        )
        $ \(fitted', image, upright, upsideDown) ->
          let Calibration alpha beta gammas deltas = fitted'
              odds o = let p = max 1e-15 (min (1 - 1e-15) o) in p / (1 - p)
              unlike r = max 0.01 (1 - max 0 r ** 2)
              -- Without logarithms: odds and unlikenesses to the powers alpha and - beta.
              worth =
                [ ( (c, turn),
                    (odds o ** alpha * exp gamma / unlike s ** beta, o, s)
                  )
                  | (turn, values) <- [(identity, upright), (turned 2, upsideDown)],
                    (c, (o, gamma)) <- zip [0 ..] (zip values gammas),
                    let s = match seen c (onRaster turn image)
                ]
              whole = sum [w | (_, (w, _, _)) <- worth]
              e = estimateFrom fitted' seen image upright upsideDown
              likeliest = estimateLikeliest e
              ofFree = unlike (freeFormCorrelation image)
              ratio =
                sum
                  [ sum (zipWith (*) deltas [1, log (unlike s / ofFree), s, log (odds o)])
                    | (what, (_, o, s)) <- worth,
                      what == likeliest
                  ]
           in conjoin
                [ conjoin
                    [ counterexample (show what) $
                        let p = estimateChance e what in p > 0 .&&. abs (w / whole - p) < 2e-7
                      | (what, (w, _, _)) <- worth
                    ],
                  near 1 (sum (map snd (estimateChances e))),
                  estimateChance e likeliest === maximum (map snd (estimateChances e)),
                  property (estimateDoubt e >= leastDoubt * 0.999),
                  near 0 (estimateChance e (4, identity)),
                  near (max (-9) (min 9 ratio)) (estimateForeignShape e)
                ]
  it "a calibration is recovered from choices drawn by it" $ do
    let true = [0.8, -1.5]
        drawnChoice g =
          let (xs, g') = drawnMany 6 g
              rows' = [V.fromList [a, b] | (a, b) <- pairsOf xs]
              powers = [exp (sum (zipWith (*) true (V.toList r))) | r <- rows']
              (u, g'') = uniform g'
              place = length (takeWhile (< u * sum powers) (scanl1 (+) powers))
           in ((rows' !! min 2 place, rows'), g'')
        choices = take 4000 (unfoldr (Just . drawnChoice) (mkStdGen 3))
        found = V.toList (conditionalLogit (V.fromList [0, 0]) (V.fromList [0.01, 0.01]) choices)
    for_ (zip true found) $ \(wanted, came) -> abs (wanted - came) `shouldSatisfy` (< 0.1)
  it "a calibration without information is the prior's mean, whatever its precision" $
    forAll ((,) <$> vectorOf 3 (choose (-9, 9)) <*> vectorOf 3 (choose (0.01, 99))) $
      \(means, precisions) -> forAll (listOf (vectorOf 3 (choose (-2, 2)))) $ \alternatives ->
        -- Equal alternatives contain no information, whichever is chosen.
        let alike = [(x, [x, x, x]) | x <- map V.fromList alternatives]
         in conditionalLogit (V.fromList means) (V.fromList precisions) alike
              === V.fromList means
  it "a calibration is where likelihood and prior balance: the slope is 0" $
    forAll ((,) <$> vectorOf 2 (choose (-1, 1)) <*> vectorOf 2 (choose (0.1, 9))) $
      \(means, precisions) -> forAll (choose (1, 30) >>= (`vectorOf` genChoice)) $ \choices ->
        let w = conditionalLogit (V.fromList means) (V.fromList precisions) choices
            slope i =
              (precisions !! i) * (means !! i - w V.! i)
                + sum
                  [ chosen V.! i - sum (zipWith (\p x -> p * x V.! i) (shares xs) xs)
                    | (chosen, xs) <- choices
                  ]
            shares xs =
              let powers = [exp (V.sum (V.zipWith (*) w x)) | x <- xs]
               in map (/ sum powers) powers
         in conjoin [counterexample (show (i, slope i)) (abs (slope i) < 1e-6) | i <- [0, 1]]
  it "a calibration on each choice twice is the one on each once under half the prior" $
    forAll (vectorOf 2 (choose (0.1, 9))) $ \precisions ->
      forAll (choose (1, 30) >>= (`vectorOf` genChoice)) $ \choices ->
        let found prior = conditionalLogit (V.fromList [0.5, -0.5]) (V.fromList prior)
            twice = found precisions (choices ++ choices)
            once' = found (map (/ 2) precisions) choices
         in counterexample (show (twice, once')) $
              V.and (V.zipWith (\a b -> abs (a - b) < 1e-6) twice once')
  it "a calibration is read as it was written" $
    forAll ((,) <$> choose (1, 9) <*> vectorOf 20 arbitrary) $ \(q, numbers) ->
      let some from count = take count (drop from numbers)
          written = Calibration (numbers !! 0) (numbers !! 1) (some 6 q) (some 2 4)
       in decodeCalibration (encodeUtf8 (renderCalibration written)) === Right written
  where
    genOutput = oneof [choose (0, 1), choose (0.9, 1), elements [0, 1, 1e-20, 1 - 1e-16]]
    genCalibration =
      Calibration <$> choose (0, 1) <*> choose (0, 9) <*> vectorOf 4 (choose (-2, 2))
        <*> vectorOf 4 (choose (-2, 2))
    genChoice = do
      alternatives <- choose (1, 4) >>= (`vectorOf` (V.fromList <$> vectorOf 2 (choose (-2, 2))))
      chosen <- elements alternatives
      pure (chosen, alternatives)
    drawnMany n g = case n :: Int of
      0 -> ([], g)
      _ -> let (u, g') = uniform g in first ((2 * u - 1) * 2 :) (drawnMany (n - 1) g')
    pairsOf (a : b : rest) = (a, b) : pairsOf rest
    pairsOf _ = []

partSpec :: Spec
partSpec = do
  it "is at least as doubtful as a free shape makes it, however well one shape fits" $ do
    for_ [1 .. 12] $ \rows ->
      minimum [doubtOf rows c | c <- [0 .. 3]]
        `shouldSatisfy` (> 7 / 8 * nothingOfTheKind (8 * fromIntegral rows) - 1e-12)
    maximum [doubtOf 12 c | c <- [0 .. 3]] `shouldSatisfy` (< 0.0011)
  it "is each shape moved a little, flat, or a free shape: the posterior of all these" $
    withMaxSuccess (byEffort 20 60) $
      forAll (elements [0, 0.5, 1, 2]) $ \sigma ->
        forAll (choose (1, 12) >>= \rows -> (,) rows <$> genRasterOf 8 rows) $ \(rows, image) ->
          let part = upper rows image
              taxels = 8 * fromIntegral rows
              (distances, flat) = partDistances seen part
              least = minimum (flat : concatMap (map snd . snd) distances)
              asOne = 3500 / fromIntegral (separation known) ** 2 + 0.75 * sigma ** 2
              -- By a normal law for each variance of a taxel, e^u times the likeliest one's.
              byVariance d =
                sum
                  [ exp (taxels / (2 * asOne) * (1 - u - ratio * exp (negate u)))
                    | u <- [-8, -7.95 .. 40],
                      let ratio = (d + 0.003 * taxels) / (least + 0.003 * taxels)
                  ]
              normal d = byVariance d / byVariance least
              prior (x, y) = exp (negate (x * x + y * y) / (2 * (0.25 ** 2 + sigma ** 2)))
              whole = sum [prior (x, y) | x <- line, y <- line]
              ofShape moves = sum [prior m * normal d | (m, d) <- moves] / whole
              rubbish = max (50 ** (sigma - 1) / 1000) (nothingOfTheKind taxels)
              everything = normal flat + sum (map (ofShape . snd) distances)
              chance l = (1 - rubbish) * (l + normal flat / 8) / everything + rubbish / 8
              e = estimatePart seen sigma part
           in conjoin $
                near (1 - estimateChance e (estimateLikeliest e)) (estimateDoubt e) :
                (maximum (map snd (estimateChances e)) === estimateChance e (estimateLikeliest e)) :
                  [ near (chance (ofShape moves)) (estimateChance e what)
                    | (what, moves) <- distances
                  ]
  where
    line = [-1, -0.5, 0, 0.5, 1]
    nothingOfTheKind :: Double -> Double
    nothingOfTheKind taxels = if taxels < 32 then 0.006 else 0.001
    doubtOf rows c =
      let part = upper rows (toRaster (shapes known !! c))
       in estimateDoubt (estimatePart seen 0 part)
    -- Only the upper rows are seen; the image has at least as many.
    upper rows image =
      Part
        (generate 8 12 (\x y -> if y < rows then fromMaybe 0 (index image x y) else 0))
        (generate 8 12 (\_ y -> if y < rows then 1 else 0))
