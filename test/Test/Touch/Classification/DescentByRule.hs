-- | The rule of descent, and the images that a network is trained with.
module Test.Touch.Classification.DescentByRule (spec) where

import Control.Monad (forM_)
import Data.List (nub, sort, tails)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra (Matrix, fromLists, maxElement, scale, size, toLists)
import PraTactile.Classification.Network
import PraTactile.Classification.Regimen
import PraTactile.Classification.Samples
import PraTactile.Classification.Specimens
import PraTactile.Classification.Templates (match, templates)
import PraTactile.Classification.Train
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

-- | Where a descent is: the weights, the last change, and the rate.
data State = State (Matrix Double, Matrix Double) (Matrix Double, Matrix Double) Double

descentSpec :: Spec
descentSpec = do
  modifyMaxSuccess (const 60)
    . it "each epoch is a step with momentum, undone and slower where the error grew too much"
    $ forAllBlind genProblem $ \(n, images) ->
      forAll (elements [1e-3, 0.1, 1, 3, 10]) $ \rate ->
        forAll (choose (0, 8)) $ \count ->
          forAll (elements [0.95, 0.5, 0]) $ \share ->
            let descent = Descent share rate 1.25 0.5 1.04 count
                outcome = do
                  b <- batch (outputCount n) images
                  (found, progress) <- train descent b n
                  first <- squaredError n b
                  let start = State (hiddenUnits n, outputUnits n) (none n) rate
                  State w _ end <- times count (epoch descent b) start
                  wanted <- uncurry network w
                  final <- squaredError wanted b
                  pure (found, progress, wanted, Progress count first final end)
             in case outcome of
                  Left e -> counterexample (show e) False
                  Right (found, progress, wanted, expected) ->
                    conjoin
                      [ counterexample (show (progress, expected)) (alike progress expected),
                        property (close (hiddenUnits found) (hiddenUnits wanted)),
                        property (close (outputUnits found) (outputUnits wanted))
                      ]
  it "an error that grew by less is kept, at the same rate; the limit itself is not too much" $ do
    -- One output for one image, which rises from a half, and the error with it, if the rate is
    -- below 0.
    let asked limit = do
          n <- network (fromLists [replicate 97 0]) (fromLists [[0, 0]])
          b <- batch 1 [(constant 8 12 0, Nothing)]
          (m, progress) <- train (Descent 0 (-0.01) 2 0.5 limit 1) b n
          e <- squaredError m b
          let growth = errorAfter progress / errorBefore progress
          pure (m == n, finalRate progress, errorAfter progress == e, growth)
    case asked 2 of
      Right (same, rate, told, growth) -> do
        (same, rate, told) `shouldBe` (False, -0.01, True)
        growth `shouldSatisfy` (> 1)
        let kept limit = fmap (\(s, r, _, _) -> (s, r)) (asked limit)
        kept (growth * 1.0001) `shouldBe` Right (False, -0.01)
        kept (growth * 0.9999) `shouldBe` Right (True, -0.005)
      Left e -> expectationFailure (show e)
  it "begins with weights uniform between -0.1 and 0.1, of as many units as are asked for" $ do
    let begun hidden outs = fst <$> initialNetwork hidden outs (mkStdGen 5)
    case begun 8 4 of
      Right n -> do
        [size (hiddenUnits n), size (outputUnits n)] `shouldBe` [(8, 97), (4, 9)]
        forM_ [(concat (toLists (hiddenUnits n)), 776), (concat (toLists (outputUnits n)), 36)] $
          \(weights, count) -> do
            length (nub weights) `shouldBe` count
            let few = fromIntegral count :: Double
                -- The largest of so many uniform draws is this far from the end, once in 150.
                reached = 0.2 * 5 / few
            (minimum weights, maximum weights)
              `shouldSatisfy` \(least, most) ->
                least >= -0.1 && least < reached - 0.1 && most <= 0.1 && most > 0.1 - reached
            abs (sum weights / few) `shouldSatisfy` (< 5 * 0.2 / sqrt (12 * few))
      Left e -> expectationFailure (show e)
    [either Just (const Nothing) (begun h o) | (h, o) <- [(0, 1), (-1, 1), (1, 0), (1, -1), (1, 1)]]
      `shouldBe` replicate 4 (Just LayersDoNotFit) ++ [Nothing]
  it "ends where the error is nothing" $ do
    let perfect = do
          n <- network (fromLists [replicate 97 0]) (fromLists [[0, -1000]])
          b <- batch 1 [(constant 8 12 0, Nothing)]
          (m, progress) <- train (Descent 0.5 0.1 2 0.5 1.04 9) b n
          pure (m == n, progress)
    case perfect of
      Right (same, progress) ->
        (same, errorBefore progress < 1e-300, progressEpochs progress)
          `shouldBe` (True, True, if errorBefore progress == 0 then 0 else 9)
      Left e -> expectationFailure (show e)
  where
    none n = (scale 0 (hiddenUnits n), scale 0 (outputUnits n))
    times count step state
      | count <= (0 :: Int) = Right state
      | otherwise = step state >>= times (count - 1) step
    epoch descent b (State w change rate) = do
      n <- uncurry network w
      slope <- gradient n b
      now <- squaredError n b
      let on :: Matrix Double -> Matrix Double -> Matrix Double
          on c g = scale (momentum descent) c - scale ((1 - momentum descent) * rate) g
          moved = both on change slope
          w' = both (+) w moved
          slower = rate * rateDecrease descent
      n' <- uncurry network w'
      later <- squaredError n' b
      pure $
        if later > greatestIncrease descent * now
          then State w (both (\_ g -> scale (negate slower) g) change slope) slower
          else State w' moved (if later < now then rate * rateIncrease descent else rate)
    both f (a, b) (c, d) = (f a c, f b d)
    close a b = maxElement (abs (a - b)) < 1e-9
    alike (Progress e p q rate) (Progress e' p' q' rate') =
      e == e'
        && and (zipWith near [p, q, rate] [p', q', rate'])
    near p q = abs (p - q) <= 1e-9 * (1 + abs q)

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
            -- The margin of eight taxels is flat; beyond it all goes on so.
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
  it "as stitching leaves them: each fault uniform within its bounds, whatever the others are" $
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
          -- How far the share of draws below each is from what it is of uniform ones: Kolmogorov's
          -- statistic, above 1.95 once in a thousand.
          statistic draws = sqrt 1000 * maximum (zipWith off [0 ..] (sort draws))
          off i t = max (abs (t - i / 1000)) (abs (t - (i + 1) / 1000)) :: Double
          -- Twelve times the mean product is a correlation.
          alike us vs = 12 * sum [(u - 0.5) * (v - 0.5) | (u, v) <- zip us vs] / 1000
      concat shares `shouldSatisfy` all (\t -> t >= 0 && t <= 1)
      map statistic shares `shouldSatisfy` all (< 1.95)
      [abs (alike us vs) | us : others <- tails shares, vs <- others]
        `shouldSatisfy` all (< 5 / sqrt 1000)
  it "of two shapes are the first at the left, or above, and the second beyond the middle" $
    whenRight paperAlphabet $ \known ->
      forAll ((,) <$> elements (shapes known) <*> elements (shapes known)) $ \(a, b) ->
        let bit' shape x y = if embossedAt shape x y then 1 else 0
            beside = generate 8 12 (\x y -> bit' (if x < 4 then a else b) x y)
            over = generate 8 12 (\x y -> bit' (if y < 6 then a else b) x y)
         in map (see exactView) [besideScene a b, overScene a b, flatScene]
              === [beside, over, constant 8 12 0]
  it "with a part that was not seen are flat in a corner, or repeat what is next to a margin" $
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
      View
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
  it "of a round are those of each kind in turn, of each shape: so many, with its class if right" $
    forAll (choose (0, 3) >>= (`vectorOf` ((,) <$> elements [minBound ..] <*> choose (0, 3)))) $
      \makeup -> whenRight paperAlphabet $ \known ->
        map snd (fst (roundImages makeup [0, 0.1] known (mkStdGen 3)))
          === [ if kind `elem` [Upright, Curtailed] then Just k else Nothing
                | (kind, count) <- makeup,
                  k <- [0 .. 3],
                  _ <- [1 .. count]
              ]
  it "have the noises in turn, for each shape from the first; of no noises none" $
    whenRight paperAlphabet $ \known -> do
      -- A flat face is seen as one value, of whose spread noise alone is the cause.
      let spreads noises =
            [ fromMaybe 0 (standardDeviation image)
              | (image, _) <- fst (roundImages [(Bare, 5)] noises known (mkStdGen 4))
            ]
          inTurn = concat (replicate 4 (take 5 (cycle [0.3, 0, 0.02])))
      spreads [] `shouldSatisfy` all (< 1e-9)
      -- What is below 0 is clipped, so that there may be less.
      zip inTurn (spreads [0.3, 0, 0.02])
        `shouldSatisfy` all
          ( \(noise, spread) -> case noise :: Double of
              0 -> spread < 1e-9
              0.3 -> spread > 0.09 && spread < 0.39
              _ -> spread > 1e-6 && spread < 0.03
          )
  it "are of their kinds" $
    whenRight paperAlphabet $ \known -> do
      let of' kind = map fst (fst (roundImages [(kind, 20)] [0] known (mkStdGen 5)))
          -- The class of the shape that is likest, in its place.
          likest image = snd (maximum [(match (templates known) k image, k) | k <- [0 .. 3]])
          own = concatMap (replicate 20) [0 .. 3]
          agreeing turn kind =
            length (filter id (zipWith (==) own (map (likest . turn) (of' kind))))
      [agreeing id Upright, agreeing (onRaster (turned 2)) UpsideDown]
        `shouldSatisfy` all (> 76)
      map standardDeviation (of' Bare) `shouldSatisfy` all (maybe False (< 1e-9))
