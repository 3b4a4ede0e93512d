-- | Tests the rule of descent, and the images that a network is trained with.
module Test.Touch.Classification.DescentByRule (spec) where

import Control.Monad (forM_)
import Data.Foldable (toList)
import Data.List (nub, sort, tails, unfoldr)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra (Matrix, fromLists, size, toLists)
import PraTactile.Classification.Network
import PraTactile.Classification.Regimen
import PraTactile.Classification.Samples
import PraTactile.Classification.Specimens
import PraTactile.Classification.Templates (match, templates)
import PraTactile.Classification.Train
import PraTactile.Classification.Traingdx
import PraTactile.Image
import PraTactile.Shape
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (generate, label, sample, scale)
import Test.Support
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  describe "Descent" descentSpec
  describe "Images" $ do
    seenSpec
    roundSpec

descentSpec :: Spec
descentSpec = do
  it "by hand, E(x) = x^2 from 1 at the rate 1 goes: tolerated, undone, lower, undone" $ do
    let rule = toolboxDescent {initialRate = 1, epochs = 4}
        run = toList (descend rule parabola (V.fromList [1]))
    map epochOutcome run `shouldBe` [Begun, Tolerated, Undone, Lower, Undone]
    map (V.toList . epochPoint) run `shouldSatisfy` near [[1], [-1], [-1], [0.4], [0.4]]
    [map epochRate run] `shouldSatisfy` near [[1, 1, 0.7, 0.735, 0.5145]]
    [map epochError run] `shouldSatisfy` near [[1, 1, 1, 0.16, 0.16]]
    [map epochGradient run] `shouldSatisfy` near [[2, 2, 2, 0.8, 0.8]]
    fmap (stopped toolboxDescent {epochs = 4}) (lastOf run) `shouldBe` Just (Just EpochsSpent)
  it "each epoch on any error follows the rule's formulas on lists" $
    forAllBlind genBowl $ \(bowl, start) -> forAll genDescent $ \rule ->
      let run = toList (descend rule (onVector bowl) (V.fromList start))
          wanted = byFormulas rule bowl start
       in counterexample (show (map epochRate run, map rateOf wanted)) $
            map epochOutcome run === map outcomeOf wanted
              .&&. property (near [map epochRate run] [map rateOf wanted])
              .&&. property (near (map (V.toList . epochPoint) run) (map pointOf wanted))
  it "ends at the goal, at a vanishing gradient, or after the last epoch, undone or not" $ do
    let why how start =
          let end = lastEpoch (descend how parabola (V.fromList start))
           in (stopped how end, epochNumber end)
        rule = toolboxDescent {initialRate = 1, epochs = 4}
    why rule {goal = 0.16 + 1e-9} [1] `shouldBe` (Just GoalReached, 3)
    why rule {goal = 1} [1] `shouldBe` (Just GoalReached, 0)
    why rule {leastGradient = 0.8 + 1e-9} [1] `shouldBe` (Just GradientVanished, 3)
    why rule {leastGradient = 2} [1] `shouldBe` (Just GradientVanished, 3)
    why rule {leastGradient = 2 + 1e-9} [1] `shouldBe` (Just GradientVanished, 0)
    why rule {epochs = 0} [1] `shouldBe` (Just EpochsSpent, 0)
    why rule [0] `shouldBe` (Just GoalReached, 0)
  modifyMaxSuccess (const 60)
    . it "of a network is the descent of its squared error along its gradient"
    $ forAllBlind genProblem $ \(n, images) -> forAll genDescent $ \rule ->
      let outcome = do
            b <- batch (outputCount n) images
            (found, trace) <- train rule b n
            let at (w1, w2) = network w1 w2
                split' v =
                  let (a, c) = splitAt (97 * hiddenCount n) v
                   in (inRows 97 a, inRows (hiddenCount n + 1) c)
                bowl v = case at (split' v) of
                  Right m
                    | Right e <- squaredError m b,
                      Right (g1, g2) <- gradient m b ->
                      (e, concat (toLists g1) ++ concat (toLists g2))
                  _ -> (0 / 0, v)
                start = concat (toLists (hiddenUnits n)) ++ concat (toLists (outputUnits n))
            wanted <- maybe (Left EmptyBatch) Right (lastOf (byFormulas rule bowl start))
            m <- at (split' (pointOf wanted))
            pure (greatestDifference found m, lastEpoch trace, wanted)
       in case outcome of
            Left e -> counterexample (show e) False
            Right (apart, end, wanted) ->
              counterexample (show (apart, end)) $
                (epochOutcome end, any (< 1e-9) apart) === (outcomeOf wanted, True)
                  .&&. property (near [[epochRate end]] [[rateOf wanted]])
  it "keeps a step that raises the error by the limit at most, at the same rate" $ do
    let end rise = lastEpoch (descend (limited rise) parabola (V.fromList [1]))
        -- One step from 1 to -2: the error is four times as great.
        limited rise =
          toolboxDescent {initialRate = 1.5, momentum = 0, epochs = 1, greatestIncrease = rise}
        kept rise = (epochOutcome (end rise), epochRate (end rise))
    map kept [4.001, 4] `shouldBe` replicate 2 (Tolerated, 1.5)
    kept 3.999 `shouldBe` (Undone, 1.5 * 0.7)
  it "that diverges gives no network" $
    ( do
        n <- network (fromLists [replicate 97 0]) (fromLists [[0, 0]])
        b <- batch 1 [(constant 8 12 1, Just 0)]
        fst <$> train shippedDescent {initialRate = 1 / 0, epochs = 3} b n
    )
      `shouldBe` Left NotFinite
  it "begins with weights uniform between -0.1 and 0.1, for the requested units" $ do
    let begun hidden outs = fst <$> initialNetwork hidden outs (mkStdGen 5)
    case begun 8 4 of
      Right n -> do
        [size (hiddenUnits n), size (outputUnits n)] `shouldBe` [(8, 97), (4, 9)]
        forM_ [(concat (toLists (hiddenUnits n)), 776), (concat (toLists (outputUnits n)), 36)] $
          \(weights, count) -> do
            length (nub weights) `shouldBe` count
            let few = fromIntegral count :: Double
                -- The largest of this many uniform draws is this far from the end once in 150.
                reached = 0.2 * 5 / few
            (minimum weights, maximum weights)
              `shouldSatisfy` \(least, most) ->
                least >= -0.1 && least < reached - 0.1 && most <= 0.1 && most > 0.1 - reached
            abs (sum weights / few) `shouldSatisfy` (< 5 * 0.2 / sqrt (12 * few))
      Left e -> expectationFailure (show e)
    [either Just (const Nothing) (begun h o) | (h, o) <- [(0, 1), (-1, 1), (1, 0), (1, -1), (1, 1)]]
      `shouldBe` replicate 4 (Just LayersDoNotFit) ++ [Nothing]
  where
    parabola x = (V.sum (V.map (^ (2 :: Int)) x), V.map (2 *) x)
    near as bs = map length as == map length bs && and (zipWith close' (concat as) (concat bs))
    close' p q = abs (p - q) <= 1e-9 * (1 + abs q) || p == q || (isNaN p && isNaN q)
    onVector bowl v = V.fromList <$> bowl (V.toList v)
    lastOf list = if null list then Nothing else Just (last list)
    inRows :: Int -> [Double] -> Matrix Double
    inRows width = fromLists . takeWhile (not . null) . unfoldr (Just . splitAt width)

-- | The formulas of traingdx on lists: the outcome, the point and the rate of an epoch.
data Formulas = Formulas {outcomeOf :: EpochOutcome, pointOf :: [Double], rateOf :: Double}

-- | From before the first epoch to the last.
byFormulas :: Descent -> ([Double] -> (Double, [Double])) -> [Double] -> [Formulas]
byFormulas rule bowl start = go 0 Begun start (initialRate rule) first
  where
    first = case firstChange rule of
      WholeStep -> [initialRate rule * g | g <- downhill start]
      AtRest -> map (const 0) start
    downhill = map negate . snd . bowl
    go :: Int -> EpochOutcome -> [Double] -> Double -> [Double] -> [Formulas]
    go count became x lr dx = Formulas became x lr : more
      where
        e = fst (bowl x)
        g = downhill x
        mc = momentum rule
        more
          | e <= goal rule || sqrt (sum (map (^ (2 :: Int)) g)) < leastGradient rule = []
          | count == epochs rule = []
          | e' / e > greatestIncrease rule =
            go (count + 1) Undone x slower [slower * d | d <- g]
          | e' < e = go (count + 1) Lower x' (lr * rateIncrease rule) dx'
          | otherwise = go (count + 1) Tolerated x' lr dx'
        slower = lr * rateDecrease rule
        dx' = case momentumForm rule of
          AsProgrammed -> [mc * a + (1 - mc) * lr * d | (a, d) <- zip dx g]
          AsDocumented -> [mc * a + lr * mc * d | (a, d) <- zip dx g]
        x' = zipWith (+) x dx'
        e' = fst (bowl x')

genDescent :: Gen Descent
genDescent = do
  share <- elements [0.95, 0.9, 0.5, 0]
  rate <- elements [1e-3, 0.1, 0.4, 1, 3]
  count <- choose (0, 12)
  form <- elements [AsProgrammed, AsDocumented]
  begin <- elements [WholeStep, AtRest]
  enough <- elements [0, 0, 0.3]
  steep <- elements [0, 1e-6, 0.5]
  pure
    toolboxDescent
      { momentum = share,
        initialRate = rate,
        rateIncrease = 1.25,
        rateDecrease = 0.5,
        goal = enough,
        leastGradient = steep,
        epochs = count,
        momentumForm = form,
        firstChange = begin
      }

-- | The error sum (a_i x_i^2 + b_i x_i^4), with its gradient, and a starting point.
genBowl :: Gen ([Double] -> (Double, [Double]), [Double])
genBowl = do
  n <- choose (1, 3)
  as <- vectorOf n (choose (0.1, 2))
  bs <- vectorOf n (choose (0, 0.5))
  start <- vectorOf n (choose (-2, 2))
  pure
    ( \x ->
        ( sum [a * u ^ (2 :: Int) + b * u ^ (4 :: Int) | (a, b, u) <- zip3 as bs x],
          [2 * a * u + 4 * b * u ^ (3 :: Int) | (a, b, u) <- zip3 as bs x]
        ),
      start
    )

-- | A small network, and images with a class or none.
genProblem :: Gen (Network, [(Raster, Maybe Int)])
genProblem = do
  q <- choose (1, 3)
  h <- choose (1, 2)
  count <- choose (1, 4)
  let genClass = oneof [pure Nothing, Just <$> choose (0, q - 1)]
  images <- vectorOf count ((,) <$> genRasterOf 8 12 <*> genClass)
  let weights r c = fromLists <$> vectorOf r (vectorOf c (choose (-0.4, 0.4)))
  n <- suchThatMap (network <$> weights h 97 <*> weights q (h + 1)) (either (const Nothing) Just)
  pure (n, images)

seenSpec :: Spec
seenSpec = do
  modifyMaxSuccess (const 30)
    . it "are two halves, each shifted, blurred along both axes and at the contrast, blended across"
    $ forAll genView $ \view -> forAll (choose (0, 3)) $ \c ->
      whenRight paperAlphabet $ \known ->
        let shape = shapes known !! c
            -- The margin of eight taxels is flat, and everything beyond it.
            cells = generate 24 28 (\x y -> if embossedAt shape (x - 8) (y - 8) then 1 else 0)
            half sign x y =
              sum
                [ p * q
                    * sample
                      cells
                      (fromIntegral (x + 8) + i - part viewShift fst - sign * part viewTear fst / 2)
                      (fromIntegral (y + 8) + j - part viewShift snd - sign * part viewTear snd / 2)
                  | (i, p) <- weights (fst (viewBlur view)),
                    (j, q) <- weights (snd (viewBlur view))
                ]
            part field side = side (field view)
            weights b = [(-1, b / 2), (0, 1 - b), (1, b / 2)]
            pixel x y =
              let right' = (fromIntegral x + 0.5) / 8
                  share = (1 - right') * half (-1) x y + right' * half 1 x y
               in viewBase view + (viewGain view - viewBase view) * share
            seen = see view (symbolScene shape)
            wanted = generate 8 12 pixel
         in counterexample (show (toRows seen, toRows wanted)) $
              V.all ((< 1e-9) . abs) (V.zipWith (-) (rasterValues seen) (rasterValues wanted))
  it "have the faults of stitching, each uniform within its bounds and independent of the others" $
    forM_ [0.1, 0.7, 2] $ \most -> do
      let views = map (fst . stitchedView most . mkStdGen) [1 .. 1000]
          faults =
            [ (fst . viewShift, -most, most),
              (snd . viewShift, -most, most),
              (fst . viewTear, -0.5, 0.5),
              (snd . viewTear, -0.5, 0.5),
              (fst . viewBlur, 0, 0.4),
              (snd . viewBlur, 0, 0.4),
              (viewGain, 0.85, 1.1),
              (viewBase, -0.03, 0.05)
            ]
          -- Each from 0 to 1.
          shares = [[(f v - low) / (high - low) | v <- views] | (f, low, high) <- faults]
          -- The distance between the share of draws below each and that of uniform ones:
          -- Kolmogorov's statistic, above 1.95 once in a thousand.
          statistic draws = sqrt 1000 * maximum (zipWith off [0 ..] (sort draws))
          off i t = max (abs (t - i / 1000)) (abs (t - (i + 1) / 1000)) :: Double
          -- Twelve times the mean product is a correlation.
          alike us vs = 12 * sum [(u - 0.5) * (v - 0.5) | (u, v) <- zip us vs] / 1000
      concat shares `shouldSatisfy` all (\t -> t >= 0 && t <= 1)
      map statistic shares `shouldSatisfy` all (< 1.95)
      [abs (alike us vs) | us : others <- tails shares, vs <- others]
        `shouldSatisfy` all (< 5 / sqrt 1000)
  it "of two shapes show the first at the left, or above, and the second beyond the middle" $
    whenRight paperAlphabet $ \known ->
      forAll ((,) <$> elements (shapes known) <*> elements (shapes known)) $ \(a, b) ->
        let bit' shape x y = if embossedAt shape x y then 1 else 0
            beside = generate 8 12 (\x y -> bit' (if x < 4 then a else b) x y)
            over = generate 8 12 (\x y -> bit' (if y < 6 then a else b) x y)
         in map (see exactView) [besideScene a b, overScene a b, flatScene]
              === [beside, over, constant 8 12 0]
  it "with an unseen part are flat in a corner, or repeat the taxels beside a margin" $
    forAll genUnseen $ \unseen ->
      forAll ((,) <$> choose (4, 8) <*> choose (4, 8)) $ \(w, h) ->
        forAll (genRasterOf w h) $ \image ->
          let value x y = fromMaybe 0 (index image x y)
              pixel x y = case unseen of
                CornerUnseen (Corner right' bottom n m)
                  | (if right' then x + n >= w else x < n),
                    if bottom then y + m >= h else y < m ->
                    0
                ColumnsUnseen False n -> value (max n x) y
                ColumnsUnseen True n -> value (min (w - 1 - n) x) y
                RowsUnseen False n -> value x (max n y)
                RowsUnseen True n -> value x (min (h - 1 - n) y)
                _ -> value x y
           in withUnseen unseen image === generate w h pixel
  where
    pair low high = (,) <$> choose (low, high) <*> choose (low, high)
    genView =
      SampleView
        <$> pair (-3) 3
        <*> pair (-1) 1
        <*> pair 0 0.5
        <*> choose (0.5, 1.2)
        <*> choose (-0.1, 0.1)
    genUnseen =
      oneof
        [ CornerUnseen
            <$> (Corner <$> arbitrary <*> arbitrary <*> choose (0, 3) <*> choose (0, 3)),
          ColumnsUnseen <$> arbitrary <*> choose (0, 2),
          RowsUnseen <$> arbitrary <*> choose (0, 2)
        ]

roundSpec :: Spec
roundSpec = do
  it "of a round come by kind and shape, in the given numbers, with the class if right" $
    forAll (choose (0, 3) >>= (`vectorOf` ((,) <$> elements [minBound ..] <*> choose (0, 3)))) $
      \makeup -> whenRight paperAlphabet $ \known ->
        map snd (fst (roundImages makeup [0, 0.1] known (mkStdGen 3)))
          === [ if kind `elem` [Upright, Curtailed] then Just k else Nothing
                | (kind, count) <- makeup,
                  k <- [0 .. 3],
                  _ <- [1 .. count]
              ]
  it "take the noises in turn, for each shape from the first; without noises they have none" $
    whenRight paperAlphabet $ \known -> do
      -- A flat face has a single value, so noise alone causes its spread.
      let spreads noises =
            [ fromMaybe 0 (standardDeviation image)
              | (image, _) <- fst (roundImages [(Bare, 5)] noises known (mkStdGen 4))
            ]
          inTurn = concat (replicate 4 (take 5 (cycle [0.3, 0, 0.02])))
      spreads [] `shouldSatisfy` all (< 1e-9)
      -- Values below 0 are clipped, which may lower the spread.
      zip inTurn (spreads [0.3, 0, 0.02])
        `shouldSatisfy` all
          ( \(noise, spread) -> case noise :: Double of
              0 -> spread < 1e-9
              0.3 -> spread > 0.09 && spread < 0.39
              _ -> spread > 1e-6 && spread < 0.03
          )
  it "show what their kinds demand" $
    whenRight paperAlphabet $ \known -> do
      let of' kind = map fst (fst (roundImages [(kind, 20)] [0] known (mkStdGen 5)))
          -- The class of the shape that is most similar, in its place.
          likest image = snd (maximum [(match (templates known) k image, k) | k <- [0 .. 3]])
          own = concatMap (replicate 20) [0 .. 3]
          agreeing turn kind =
            length (filter id (zipWith (==) own (map (likest . turn) (of' kind))))
      [agreeing id Upright, agreeing (onRaster (turned 2)) UpsideDown]
        `shouldSatisfy` all (> 76)
      map standardDeviation (of' Bare) `shouldSatisfy` all (maybe False (< 1e-9))
