-- | Training step by step, the images that it is done with and the counts that judge it, each
-- stated once more as a whole from its definition.
module Test.Touch.TrainSteps (spec) where

import Data.List (unfoldr)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra (Matrix, fromLists, maxElement, scale)
import PraTactile.Classification.Evaluate
import PraTactile.Classification.Network
import PraTactile.Classification.Regimen
import PraTactile.Classification.Samples
import PraTactile.Classification.Specimens
import PraTactile.Classification.Train
import PraTactile.Image
import PraTactile.Random (uniform)
import PraTactile.Shape
import System.Random (StdGen, mkStdGen)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (generate, label, sample, scale)
import Test.Support
import Test.Touch.Image (genRasterOf)

spec :: Spec
spec = do
  describe "Descent" descentSpec
  describe "Images" $ do
    seenSpec
    roundSpec
  describe "Counts" countSpec

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
  it "begins with weights drawn one after the other, uniform between -0.1 and 0.1" $
    forAll ((,,) <$> choose (-1, 3) <*> choose (-1, 3) <*> choose (1, 99999)) $
      \(hidden, outs, seed) ->
        let (first, g) = drawsOf (hidden * 97) (mkStdGen seed)
            (second, g') = drawsOf (outs * (hidden + 1)) g
            matrix c = fromLists . cut c . map (\u -> 0.2 * u - 0.1)
            cut c values = if null values then [] else take c values : cut c (drop c values)
         in case initialNetwork hidden outs (mkStdGen seed) of
              Left e -> (e, hidden < 1 || outs < 1) === (LayersDoNotFit, True)
              Right (n, rest) ->
                (hiddenUnits n, outputUnits n)
                  === (matrix 97 first, matrix (hidden + 1) second)
                  .&&. fst (uniform rest)
                  === fst (uniform g')
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

-- | So many draws, from 0 to 1.
drawsOf :: Int -> StdGen -> ([Double], StdGen)
drawsOf n g = (take n (unfoldr (Just . uniform) g), iterate (snd . uniform) g !! n)

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
  it "as stitching leaves them: each fault uniform within its bounds, drawn one after the other" $
    forAll ((,) <$> choose (0.1, 2) <*> choose (1, 99999)) $ \(most, seed) ->
      let (view, g) = stitchedView most (mkStdGen seed)
          (drawn, end) = drawsOf 8 (mkStdGen seed)
          bounds =
            [(-most, most), (-most, most), (-0.5, 0.5), (-0.5, 0.5), (0, 0.4), (0, 0.4)]
              ++ [(0.85, 1.1), (-0.03, 0.05)]
          told =
            [side (viewShift view) | side <- [fst, snd]]
              ++ [side (viewTear view) | side <- [fst, snd]]
              ++ [side (viewBlur view) | side <- [fst, snd]]
              ++ [viewGain view, viewBase view]
       in told === zipWith (\(low, high) t -> low + (high - low) * t) bounds drawn
            .&&. fst (uniform g) === fst (uniform end)
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
                CornerUnseen right' bottom n m
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
        [ CornerUnseen <$> arbitrary <*> arbitrary <*> choose (0, 3) <*> choose (0, 3),
          ColumnsUnseen <$> arbitrary <*> choose (0, 2),
          RowsUnseen <$> arbitrary <*> choose (0, 2)
        ]

roundSpec :: Spec
roundSpec =
  modifyMaxSuccess (const 20)
    . it "of a round are those of each kind in turn, of each shape, with the noises in turn"
    $ forAll (choose (0, 3) >>= (`vectorOf` genPart)) $
      \makeup -> forAll (elements [[], [0], [0, 0.1], [0.3, 0, 0.1]]) $ \noises ->
        forAll (choose (1, 99999)) $ \seed ->
          whenRight paperAlphabet $ \known ->
            let wanted =
                  [ (kind, k, shape, noise)
                    | (kind, count) <- makeup,
                      (k, shape) <- zip [0 ..] (shapes known),
                      noise <- take count (cycle (if null noises then [0] else noises))
                  ]
                (drawn, end) = go wanted (mkStdGen seed)
                go [] g = ([], g)
                go ((kind, k, shape, noise) : rest) g =
                  let (clean, g') = specimen known kind shape g
                      (image, g'') = withNoise noise clean g'
                      (others, g3) = go rest g''
                      class' = if kind `elem` [Upright, Curtailed] then Just k else Nothing
                   in ((image, class') : others, g3)
                (found, g0) = roundImages makeup noises known (mkStdGen seed)
             in found === drawn .&&. fst (uniform g0) === fst (uniform end)
  where
    genPart = (,) <$> elements [minBound .. maxBound] <*> choose (0, 3)

countSpec :: Spec
countSpec =
  modifyMaxSuccess (const 6)
    . it "are of verdicts on images drawn one after the other, by class, from the seed"
    $ forAllBlind genNetwork $ \n ->
      forAll ((,) <$> choose (0, 20) <*> choose (1, 9999)) $ \(count, seed) ->
        forAll (elements [0, 0.3, 1]) $ \deviation ->
          whenRight paperAlphabet $ \known ->
            let judged class' values =
                  let (first, best) = foldr higher (-1, -1) (zip [0 ..] values)
                      lead = minimum (1 : [best - v | (k, v) <- zip [0 ..] values, k /= first])
                      taken = best >= 0.5 && lead >= 0.1
                      right' = taken && Just first == class'
                      outvoted = maybe False (/= first) class'
                   in Tally
                        (one right')
                        (one (taken && not right'))
                        (one (not taken))
                        (one outvoted)
                higher p q = if snd p >= snd q then p else q
                one b = if b then 1 else 0 :: Int
                tallied :: Maybe Int -> (StdGen -> (Raster, StdGen)) -> Int -> Tally
                tallied class' draw k =
                  let images = take count (unfoldr (Just . draw) (mkStdGen (seed + k)))
                   in tallyTogether
                        [ judged class' values
                          | image <- images,
                            Right values <- [outputs n image]
                        ]
                placed placing shape g = case placing of
                  Aligned -> withNoise deviation (toRaster shape) g
                  Misplaced -> noisy (specimen known Upright shape g)
                  Incomplete -> noisy (specimen known Curtailed shape g)
                impostor kind shape = noisy . specimen known kind shape
                noisy (image, g) = withNoise deviation image g
                each f = [f k shape | (k, shape) <- zip [0 ..] (shapes known)]
                thresholds = Thresholds 0.5 0.1
             in conjoin $
                  [ errorRates thresholds n known placing deviation count seed
                      === Right (each (\k shape -> tallied (Just k) (placed placing shape) k))
                    | placing <- [minBound .. maxBound]
                  ]
                    ++ [ acceptanceRates thresholds n known kind deviation count seed
                           === Right (each (\k shape -> tallied Nothing (impostor kind shape) k))
                         | kind <- [Upright, Sideways]
                       ]
  where
    -- Four classes, which are told by chance.
    genNetwork = do
      let weights r c = fromLists <$> vectorOf r (vectorOf c (choose (-1, 1)))
      suchThatMap
        (network <$> weights 3 97 <*> (scale 3 <$> weights 4 4))
        (either (const Nothing) Just)
