-- | Tests the answers about two frames: the best place and each axis against the posterior, the
-- confidence from which they are given, and pairs whose answer is known.
module Test.Touch.Registration.AnswersOfPairs (spec) where

import Data.List (maximumBy)
import Data.Maybe (fromMaybe, isJust, isNothing)
import Data.Ord (comparing)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Registration.Definition.Pairs
import PraTactile.Registration.Lattice.Fit (likelihood, whole)
import PraTactile.Registration.Lattice.Likelihood (logDensity)
import PraTactile.Registration.Lattice.Template (templates)
import qualified PraTactile.Registration.Overlap as Overlap
import PraTactile.Registration.Pair
import PraTactile.Registration.Pair.Alike
import PraTactile.Registration.Pair.Methods
import PraTactile.Registration.Pair.Straight
import PraTactile.Registration.Posterior
import PraTactile.Registration.Spectrum
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (Blind, generate, sample, tables)
import Test.Support
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (paperAlphabet)
import Test.Touch.Registration.Reliefs (genFrames)

spec :: Spec
spec = do
  askedSpec
  withCases 7 60 posteriorSpec
  withCases 7 60 refusalSpec
  withCases 2 20 methodSpec
  withCases 2 20 knownSpec
  withCases 7 60 straightSpec

askedSpec :: Spec
askedSpec = do
  it "standardPairing searches within 3 taxels, by the better method, with 99 % confidence" $
    standardPairing (1, 2) `shouldBe` Pairing (1, 2) 3 Auto 0.99
  it "frames of other sizes than the tables', or beyond 4 to 256 taxels, are refused by name" $ do
    known <- right paperAlphabet
    let asked (w, h) (m, n) (u, v) =
          ()
            <$ registerPair
              (tablesFor known w h)
              (standardPairing (2, 0))
              (generate m n (\x y -> fromIntegral ((x * 3 + y * 5) `mod` 7)))
              (generate u v (\x y -> fromIntegral ((x * 3 + y * 5) `mod` 7)))
        same size = asked size size size
    map same [(4, 4), (4, 5), (5, 4)] `shouldBe` replicate 3 (Right ())
    map (\size -> asked (4, 4) size size) [(3, 4), (4, 3), (257, 4), (4, 257), (5, 4), (4, 5)]
      `shouldBe` map (Left . PairFrameSize) [(3, 4), (4, 3), (257, 4), (4, 257), (5, 4), (4, 5)]
    asked (4, 4) (4, 4) (4, 5) `shouldBe` Left (PairSizes (4, 4) (4, 5))
  it "values that are not finite, and settings out of their ranges, are refused by name" $ do
    known <- right paperAlphabet
    let frame = generate 5 5 (\x y -> fromIntegral ((x * 3 + y * 5) `mod` 7))
        with v = generate 5 5 (\x y -> if (x, y) == (4, 4) then v else 0.5)
        tables = tablesFor known 5 5
        asked pairing a b = fmap (const ()) (registerPair tables pairing a b)
        usual = standardPairing (2, 0)
    [asked usual a b | v <- [0 / 0, 1 / 0, -1 / 0], (a, b) <- [(with v, frame), (frame, with v)]]
      `shouldBe` replicate 6 (Left PairNotFinite)
    let refused pairing = asked pairing frame frame == Left (UnusablePairing pairing)
    [refused usual {pairingConfidence = c} | c <- [-0.001, 0, 1, 1.001, 0 / 0]]
      `shouldBe` [True, False, False, True, False]
    [refused usual {pairingSearch = s} | s <- [-0.001, 0, 64.5]] `shouldBe` [True, False, True]
    [refused usual {pairingStep = s} | s <- [(1000.5, 0), (-1000.5, 0), (0, 1000.5), (0, -1000.5)]]
      `shouldBe` replicate 4 True

-- | A question about two frames by themselves, the frames, and the posterior, which
-- "Test.Touch.Registration.PairsByFormulas" compares with the formulas.
genAsked :: Gen (Pairing, (Raster, Raster), PlacePosterior)
genAsked = do
  (frames, (dx, dy)) <- genFrames 9 8
  (method, known) <- elements [(Blind, blind), (Correlation, correlationPosterior)]
  off <- frequency [(6, elements [0, 1]), (1, pure 9), (1, pure 20)]
  search <- elements [0, 1, 2, 3]
  let step = (fromIntegral dx + off, fromIntegral dy)
  pure (Pairing step search method 0.99, frames, placesOf (uncurry (known step search) frames))
  where
    blind step search a b =
      blindPosterior (Overlap.reliefOf (spectra 9 8) 0 [a, b]) step search
    placesOf (GridPosterior (x, y) _ (columns, rows) masses) =
      zip
        [(round x + i, round y + j) | j <- [0 .. rows - 1], i <- [0 .. columns - 1]]
        (V.toList masses)

-- | The answer at a confidence.
answer :: Pairing -> (Raster, Raster) -> Double -> Maybe Match
answer pairing (a, b) confidence = do
  known <- either (const Nothing) Just paperAlphabet
  either (const Nothing) Just $
    registerPair (uncurry (tablesFor known) (rasterSize a)) asked a b
  where
    asked = pairing {pairingConfidence = confidence}

-- | Just below and just above, if these are confidences.
beside :: Double -> [Double]
beside p = filter (\c -> c >= 0 && c <= 1) [p - 1e-6, p + 1e-6]

real :: Int -> Double
real = fromIntegral

near :: Double -> Double -> Bool
near p q = abs (p - q) < 1e-6

-- | The probability within three quarters of a taxel of a place, along both axes.
heldAround :: PlacePosterior -> (Double, Double) -> Double
heldAround known (x, y) =
  sum [p | ((i, j), p) <- known, abs (real i - x) <= reach, abs (real j - y) <= reach]
  where
    reach = 0.75 + 1e-6

posteriorSpec :: Spec
posteriorSpec = do
  it "the best place, the probabilities and the deviations are those of the posterior" $
    forAllBlind (genAsked `suchThat` crooked) $ \(pairing, frames, known) ->
      case answer pairing frames 0.99 of
        Nothing -> property False
        Just found ->
          let best = matchBest found
              most = maximum [heldAround known (real i + 0.5, real j + 0.5) | ((i, j), _) <- known]
              deviation part =
                let middle = sum [p * real (part d) | (d, p) <- known]
                    squared d = (real (part d) - middle) * (real (part d) - middle)
                 in sqrt (sum [p * squared d | (d, p) <- known] + 1 / 12)
           in counterexample (show (found, known)) $
                take 1 (matchHypotheses found) == [best]
                  && hypothesisProbability best >= 0.99 * most - 1e-6
                  && length (matchHypotheses found) <= 5
                  && and [near p (heldAround known d) | Hypothesis d p <- matchHypotheses found]
                  && near (fst (matchDeviations found)) (deviation fst)
                  && near (snd (matchDeviations found)) (deviation snd)
  it "an axis is fixed if two adjacent places along it have more than the confidence" $
    forAllBlind (genAsked `suchThat` crooked) $ \(pairing, frames, known) ->
      let along part =
            maximum
              [ sum [p | (d, p) <- known, part d - part from `elem` [0, 1]]
                | (from, _) <- known
              ]
          (severalX, severalY) = several pairing frames
          fixed c = fmap matchFixed (answer pairing frames c)
          (x, y) = (along fst, along snd)
       in conjoin
            [fmap fst (fixed c) === Just (c < x && not severalX) | c <- beside x]
            .&&. conjoin [fmap snd (fixed c) === Just (c < y && not severalY) | c <- beside y]
  where
    -- Along a straight edge only the prior is left.
    crooked (Pairing _ _ method _, (a, b), known) =
      method /= Blind || isNothing (straightness (fst (maximumBy (comparing snd) known)) a b)

several :: Pairing -> (Raster, Raster) -> (Bool, Bool)
several (Pairing step search _ _) (a, b) = apart (agreements step search a b)

refusalSpec :: Spec
refusalSpec = do
  it "an answer is given if its probability exceeds the confidence, and never without relief" $
    forAllBlind genAsked $ \asked@(pairing, frames, _) ->
      let p = maybe 0 (hypothesisProbability . matchBest) (answer pairing frames 0.99)
       in conjoin
            [ counterexample (show c) $
                fmap (isNothing . matchRefusal) (answer pairing frames c)
                  === Just (c < p && telling asked)
              | c <- beside p
            ]
  it "the confidence only decides whether the answer is given" $
    forAllBlind genAsked $ \(pairing, frames, _) -> forAll (choose (0, 1)) $ \confidence ->
      let what c = do
            found <- answer pairing frames c
            let Match _ best deviation _ method others = found
            pure (best, deviation, method, others)
       in what confidence === what 0.99
  it "no overlap, blank, one axis and ambiguous are the reasons that their names say" $
    forAllBlind genAsked $ \asked@(pairing, frames@(a, b), _) ->
      let p = maybe 0 (hypothesisProbability . matchBest) (answer pairing frames 0.99)
          likelier = zipWith (-) (reliefLogs (reliefOf [a, b])) (map whiteNoise [a, b])
          noise = any (< 5) likelier
          blank = flat asked || noise && several pairing frames == (False, False)
       in conjoin
            [ counterexample (show (c, found)) . label (show refusal) $
                isNothing refusal
                  || (refusal == Just NoOverlap) == not (meeting asked)
                  && (refusal == Just Blank) == (meeting asked && blank)
                  && (refusal /= Just OneAxis || uncurry (/=) (matchFixed found))
                  && (refusal /= Just Ambiguous || uncurry (==) (matchFixed found))
              | c <- 0.5 : beside p,
                Just found <- [answer pairing frames c],
                let refusal = matchRefusal found
            ]
  where
    telling asked@(pairing, frames, _) =
      meeting asked && not (flat asked) && several pairing frames == (False, False)
    meeting (_, (a, b), known) =
      or [uncurry min (rasterSize (fst (inCommon a b d))) > 0 | (d, _) <- known]
    flat (_, (a, b), _) = any (maybe True (<= 1e-9) . standardDeviation) [a, b]

methodSpec :: Spec
methodSpec =
  it "Auto uses the lattice if that is likelier; else Lattice is sure only of the prior" $
    forAllBlind genAsked $ \(pairing@(Pairing _ search _ _), frames@(a, b), _) ->
      let likely known = sum (map (logDensity . likelihood (templates known 0 9 8) . whole) [a, b])
          latticed = either (const False) shown paperAlphabet
          shown known = likely known > sum (reliefLogs (reliefOf [a, b]))
          by method = answer pairing {pairingMethod = method} frames 0.99
          -- The prior by half taxels, from the one nearest to the step.
          line = let n = ceiling (2 * search) in map ((/ 2) . fromIntegral) [negate n .. n :: Int]
          weight t = if search > 0 then exp (-2 * t * t / (search * search)) else 1
          share t = weight t / sum (map weight line)
          deviation = sqrt (sum [share t * t * t | t <- line] + 1 / 48)
          (stepX, stepY) = pairingStep pairing
          within' from t = sum [share u | u <- line, abs (from + u - t) <= 0.75 + 1e-6]
       in classify latticed "by the lattice" $ case (by Auto, by Blind, by Lattice) of
            (Just auto, Just blind, Just lattice)
              | not latticed ->
                let Hypothesis (x, y) p = matchBest lattice
                 in counterexample (show (auto, lattice)) $
                      matchMethod auto == Blind && auto == blind && matchMethod lattice == Lattice
                        && near p (within' stepX x * within' stepY y)
                        && near deviation (fst (matchDeviations lattice))
                        && near deviation (snd (matchDeviations lattice))
              | otherwise -> matchMethod auto === Lattice .&&. auto === lattice
            other -> counterexample (show other) False

-- | Relief that changes across three taxels.
genTexture :: Gen (Int -> Int -> Double)
genTexture = do
  coarse <- genRasterOf 12 12
  pure (\x y -> sample coarse (fromIntegral (x + 6) / 3) (fromIntegral (y + 6) / 3))

knownSpec :: Spec
knownSpec = do
  it "equal frames, and frames with a known displacement, are registered to it" $
    forAllBlind genTexture $ \texture ->
      forAll (elements [(0, 0), (3, 0), (-2, 4), (6, 1)]) $ \(dx, dy) ->
        forAll (elements [Correlation, Blind, Auto]) $ \method ->
          forAll ((,) <$> elements [-1, 0, 1] <*> elements [-1, 0, 1]) $ \(ex, ey) ->
            let moved x y = texture (x + dx) (y + dy)
                frames = (generate 16 16 texture, generate 16 16 moved)
                asked = Pairing (fromIntegral dx + ex, fromIntegral dy + ey) 3 method 0.99
                close (x, y) = abs (x - fromIntegral dx) <= 0.5 && abs (y - fromIntegral dy) <= 0.5
             in case answer asked frames 0.99 of
                  Just found ->
                    counterexample (show found) $
                      isNothing (matchRefusal found) && close (hypothesisShift (matchBest found))
                  Nothing -> property False
  it "of two places that are equally good the one nearer to the robot's is the best" $
    forAllBlind ((,,) <$> genTexture <*> genRasterOf 8 16 <*> genRasterOf 8 16) $
      \(texture, one, other) -> forAll (elements [False, True]) $ \upright ->
        -- Frames that are their own mirror images, of relief that repeats every 6 taxels. The
        -- second is 3 further, which is 3 back as well.
        let frame off noise = generate 16 16 $ \x y ->
              let (t, v) = if upright then (y, x) else (x, y)
                  u = (min t (15 - t) + off + 1) `mod` 6
               in texture (min u (5 - u)) v + 0.1 * fromMaybe 0 (index noise (min t (15 - t)) v)
            found t =
              answer
                (Pairing (if upright then (0, t) else (t, 0)) 4 Blind 0.99)
                (frame 0 one, frame 3 other)
                0.99
            place t = do
              (x, y) <- hypothesisShift . matchBest <$> found t
              pure (round (if upright then y else x) :: Int)
         in counterexample (show (map found [-1, 0, 1])) $
              map place [-1, 1] === map Just [-3, 3]
                .&&. (found 0 >>= matchRefusal) === Just OneAxis

straightSpec :: Spec
straightSpec = do
  it "along an upright or level edge the prior is left, and across it the posterior" $
    forAllBlind (vectorOf 24 (choose (0, 1))) $ \logs -> forAll (elements [False, True]) $ \level ->
      let edge t = if t < (5 :: Int) then 0 else 1
          frame off = generate 9 9 (\x y -> edge (off + if level then y else x))
          -- At the step it is likeliest; the edge has moved by 1.
          step = if level then (0, 1) else (1, 0)
          (ox, oy) = (fst step - 2, snd step - 2)
          found = posterior (ox, oy) 1 (5, 5) (V.fromList (take 12 logs ++ 3 : drop 12 logs))
          left = posteriorMasses (alongStraight step 2 (frame 0, frame 1) found)
          at table u v = table V.! (if level then u * 5 + v else v * 5 + u)
          across table u = sum [at table u v | v <- [0 .. 4]]
          prior v = exp (-2 * real ((v - 2) * (v - 2)) / 4)
          wanted u v = across (posteriorMasses found) u * prior v / sum (map prior [0 .. 4])
       in counterexample (show left) $
            and [near (at left u v) (wanted u v) | u <- [0 .. 4], v <- [0 .. 4 :: Int]]
  it "a place that is certain may move along the edge, as far as the line through it leads" $
    forAll (choose (0, pi)) $ \angle ->
      forAllBlind ((,) <$> genRasterOf 16 16 <*> genRasterOf 16 16) $ \(one, other) ->
        let (c, s) = (cos angle, sin angle)
            edge x y = 1 / (1 + exp (-2 * ((real x - 7.5) * c + (real y - 7.5) * s)))
            frame noise = generate 16 16 $ \x y -> edge x y + 0.1 * fromMaybe 0 (index noise x y)
            surely i = if i == 24 then 0 else -1 / 0
            found = posterior (-3, -3) 1 (7, 7) (V.generate 49 surely)
            left = posteriorMasses (alongStraight (0, 0) 3 (frame one, frame other) found)
            off i = let (y, x) = i `quotRem` 7 in abs ((real x - 3) * c + (real y - 3) * s)
            told = isJust (straightness (0, 0) (frame one) (frame other))
         in classify told "straight" . counterexample (show left) $
              not told
                || and
                  [ if m > 0 then off i < 0.8 else off i > 0.2
                    | (i, m) <- zip [0 ..] (V.toList left)
                  ]
  it "without any straight edge the posterior is unchanged" $
    forAllBlind genTexture $ \texture ->
      let frame = generate 16 16 texture
          found = posterior (-3, -3) 1 (7, 7) (V.generate 49 (\i -> if i == 24 then 0 else -9))
       in alongStraight (0, 0) 3 (frame, frame) found === found
