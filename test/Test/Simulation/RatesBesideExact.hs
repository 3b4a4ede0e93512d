-- | Simulated rates, beside the exact ones.
module Test.Simulation.RatesBesideExact (spec) where

import Control.Monad (forM_, void)
import Data.Bits (testBit)
import Data.List (foldl', nub, sort, unfoldr)
import Data.Maybe (isJust)
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Polynomial (firstPrimitive)
import PraTactile.Rates
import PraTactile.Rates.Decoding
import PraTactile.Rates.Setup
import PraTactile.Rates.Trial
import PraTactile.Window
import System.Random (mkStdGen)
import Test.Code.Generators
import Test.Effort
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  it "two numbers are in the wrong order with probability Phi(-1/(sigma sqrt 2))" $
    forM_
      [(1 / sqrt 2, 0.15865525393145705), (1 / sqrt 8, 0.022750131948179195)]
      $ \(sigma, figure) ->
        abs (errorRate 2 sigma - figure) `shouldSatisfy` (< 1e-9)
  it "the noise for an error rate has that error rate" $
    forM_ [(q, p) | q <- [2, 4, 9], p <- [0.001, 0.02, 0.3]] $ \(q, p) ->
      abs (errorRate q (noiseFor q p) - p) `shouldSatisfy` (< 1e-9)
  it "the noise for no errors makes none" $
    forM_ [2, 4, 256] $ \q -> errorRate q (noiseFor q 0) `shouldSatisfy` (< 1e-15)
  it "the fast decoding of a trial is that of locate" $ do
    paper <- paperOn Torus
    window <- paperWindow
    let judged name array size damage = do
          setup <- right (trialSetup array size)
          let drawn = take (byEffort 15 150) (trialsOf setup damage 5)
              by decoder = locator (Just decoder) MostSignificantFirst array window
              located = decodeByLocate (by NearestDecoder) (by PosteriorDecoder)
          forM_ drawn $ \trial ->
            forM_ [Guaranteed, UpTo 0, UpTo 2, UpTo 100] $ \radius -> do
              let PatchResult a b doubt = decodeTrial radius setup trial
              case located radius setup trial of
                Just (PatchResult a' b' doubt') -> do
                  (name, size, radius, a, b) `shouldBe` (name :: String, size, radius, a', b')
                  -- Doubts below 1e-20 are counted alike.
                  abs (doubt - doubt') `shouldSatisfy` (<= 1e-9 * doubt' + 1e-22)
                Nothing -> expectationFailure "no answer"
          -- The answers are not all alike.
          pure [resultHard (decodeTrial Guaranteed setup trial) | trial <- drawn]
    answers <-
      concat
        <$> sequence
          [ judged "paper" paper size damage
            | size <-
                [Shape 1 1, Shape 2 2, Shape 3 3, Shape 2 5, Shape 4 4, Shape 9 9, Shape 17 16],
              damage <- [Damage 0.1 0, Damage 0.05 0.3, Damage 0.4 0.5]
          ]
    sort (nub answers) `shouldBe` [Correct, Mistaken, NoAnswer]
    binary <-
      right (firstPrimitive 4)
        >>= fmap naturally . right . folded Diagonal (Shape 3 5) ::
        IO (ArrayOn GF2)
    ternary <-
      right (firstPrimitive 4)
        >>= fmap naturally . right . folded RowMajor (Shape 8 10) ::
        IO (ArrayOn GF3)
    forM_ [Shape 1 3, Shape 2 2, Shape 3 4] $ \size ->
      void (judged "binary" binary size (Damage 0.1 0.2))
    forM_ [Shape 2 2, Shape 3 12] $ \size -> void (judged "ternary" ternary size (Damage 0.1 0.2))
  it
    "hard decoding is right, wrong and refused as often as the weights say, within 4 standard \
    \errors"
    $ do
      array <- paperOn Torus
      let cases =
            [ (Shape 2 2, Damage 0.02 0),
              (Shape 3 3, Damage 0.1 0),
              (Shape 3 4, Damage 0.1 0),
              (Shape 3 3, Damage 0.05 0.2)
            ]
      forM_ cases $ \(size, damage) -> do
        m <- right (rectangle size)
        setup <- right (trialSetup array size)
        exact <-
          maybe
            (expectationFailure "nothing" >> fail "nothing")
            pure
            (exactOn Guaranteed array m damage)
        let found = hardRates (simulate Guaranteed setup damage trials (Seed 1))
        forM_ [rateRight, rateWrong, rateRefused] $ \rate ->
          abs (rate found - rate exact)
            `shouldSatisfy` (<= 4 * sqrt (rate exact * (1 - rate exact) / fromIntegral trials))
  it
    "a stated radius: within the guaranteed one as the weights say; beyond it more answers are \
    \right, and more are wrong"
    $ do
      array <- paperOn Torus
      m <- right (rectangle (Shape 4 4))
      setup <- right (trialSetup array (Shape 4 4))
      let damage = Damage 0.2 0
          drawn = byEffort 2500 20000
          found = map (\e -> hardRates (simulate (UpTo e) setup damage drawn (Seed 5))) [0 .. 7]
      forM_ (zip [0 .. 4] found) $ \(e, rates) -> do
        exact <-
          maybe
            (expectationFailure "nothing" >> fail "nothing")
            pure
            (exactOn (UpTo e) array m damage)
        forM_ [rateRight, rateWrong, rateRefused] $ \rate ->
          let spread = sqrt (rate exact * (1 - rate exact) / fromIntegral drawn)
           in abs (rate rates - rate exact) `shouldSatisfy` (<= 4 * spread + 1e-9)
      exactOn (UpTo 5) array m damage `shouldBe` Nothing
      -- Whether there are any is known before anything is computed.
      [large, larger] <- mapM (right . rectangle) [Shape 25 40, Shape 7 143]
      [isJust (exactOn Guaranteed array them damage) | them <- [large, larger]]
        `shouldBe` [True, False]
      exactOn (UpTo 4) array m (Damage 0.2 0.1) `shouldBe` Nothing
      and (zipWith (<=) (map rateRight found) (drop 1 (map rateRight found))) `shouldBe` True
      and (zipWith (<=) (map rateWrong found) (drop 1 (map rateWrong found))) `shouldBe` True
  it
    "soft decoding errs as often as its doubts add up to, within 4 standard errors, at every \
    \threshold"
    $ do
      array <- paperOn Torus
      forM_
        [(Shape 2 2, Damage 0.05 0), (Shape 3 3, Damage 0.1 0.15), (Shape 3 3, Damage 0.2 0)]
        $ \(size, damage) -> do
          setup <- right (trialSetup array size)
          let tally = simulate Guaranteed setup damage trials (Seed 2)
          forM_ [1, 0.1, 0.01, 0.001] $ \tolerated -> do
            let Calibration answers expected wrong = calibration tolerated tally
            abs (fromIntegral wrong - expected) `shouldSatisfy` (<= 4 * sqrt (expected + 0.25))
            expected `shouldSatisfy` (<= tolerated * fromIntegral answers)
          calibratedAnswers (calibration 1 tally) `shouldBe` trials
  it "soft decoding answers more often than hard decoding, at no more wrong answers" $ do
    array <- paperOn Torus
    setup <- right (trialSetup array (Shape 3 3))
    forM_ [Damage 0.1 0, Damage 0.1 0.15, Damage 0.05 0.15] $ \damage -> do
      let tally = simulate Guaranteed setup damage trials (Seed 3)
          hard = hardRates tally
          soft = softRatesAtMost (rateWrong hard) tally
      rateRight soft `shouldSatisfy` (> rateRight hard + 0.02)
  it
    "soft decoding at most as wrong as no answers are gives none, at most as wrong as all are \
    \gives all"
    $ do
      array <- paperOn Torus
      setup <- right (trialSetup array (Shape 2 2))
      let tally = simulate Guaranteed setup (Damage 0.1 0) 1000 (Seed 4)
          Rates none none' all' = softRatesAtMost 0 tally
          Rates a b c = softRatesAtMost 1 tally
      (none < 0.01, none' < 0.01, all' > 0.99) `shouldBe` (True, True, True)
      (abs (a + b - 1) < 1e-9, abs c < 1e-9) `shouldBe` (True, True)
  it "answers of which none can be wrong are given at any share, also where others are doubted" $
    forM_ [(0, 0.25), (0.1, 0.25 + 0.4), (0.5, 1)] $ \(share, given) -> do
      -- One of four is beyond doubt; of the others each is wrong with probability 1/4.
      let tally = foldl' count noTrials (PatchResult NoAnswer True 0 : replicate 3 doubted)
          doubted = PatchResult NoAnswer True 0.25
          Rates isRight isWrong none = softRatesAtMost share tally
      maximum (map abs [isRight - given, isWrong, none - (1 - given)]) `shouldSatisfy` (< 1e-9)
  it "trials are counted, in parts or at once, and the rates are the shares of them" $
    property $
      forAll (listOf (listOf genResult)) $ \parts ->
        let results = concat parts
            tally = foldl' count noTrials results
            trials' = length results
            hard answer = length [() | PatchResult found _ _ <- results, found == answer]
            likely = length [() | PatchResult _ True _ <- results]
            share n = fromIntegral n / fromIntegral (max 1 trials') :: Double
            near (Rates a b c) (x, y, z) =
              maximum [abs (a - x), abs (b - y), abs (c - z)] < 1e-12
         in conjoin
              [ tally === merge (map (foldl' count noTrials) parts),
                (tallyTrials tally, tallyRight tally, tallyWrong tally)
                  === (trials', hard Correct, hard Mistaken),
                property $
                  near
                    (hardRates tally)
                    (share (hard Correct), share (hard Mistaken), share (hard NoAnswer)),
                -- All doubts are tolerated, so that every trial is answered.
                property (near (softRates 1 tally) (share likely, share (trials' - likely), 0)),
                calibratedAnswers (calibration 1 tally) === trials',
                calibratedWrong (calibration 1 tally) === trials' - likely
              ]
  it "one seed, one result; every seed, damage and size its own; parts merge" $ do
    array <- paperOn Torus
    setup <- right (trialSetup array (Shape 3 3))
    other <- right (trialSetup array (Shape 3 4))
    let part = simulate Guaranteed setup (Damage 0.05 0.1) 50 . Seed
        whole on damage seed = merge (simulations Guaranteed on damage 2500 (Seed seed))
    part 7 `shouldBe` part 7
    tallyTrials (merge [part 7, part 8]) `shouldBe` 100
    map tallyTrials (simulations Guaranteed setup (Damage 0.05 0.1) 2500 (Seed 7))
      `shouldBe` [1000, 1000, 500]
    whole setup (Damage 0.05 0.1) 7 `shouldBe` whole setup (Damage 0.05 0.1) 7
    let results =
          [ whole setup (Damage p s) seed
            | (p, s, seed) <- [(0.05, 0.1, 7), (0.05, 0.1, 8), (0.05, 0.11, 7), (0.06, 0.1, 7)]
          ]
            ++ [whole other (Damage 0.05 0.1) 7]
    length (nub (map show results)) `shouldBe` 5
  it "the sheet, no cells and too many cells are refused" $ do
    array <- paperOn Torus
    sheet <- paperOn Sheet
    either Left (const (Right ())) (trialSetup sheet (Shape 2 2)) `shouldBe` Left SetupOnSheet
    either Left (const (Right ())) (trialSetup array (Shape 0 2)) `shouldBe` Left SetupEmpty
    either Left (const (Right ())) (trialSetup array (Shape 1000 1000))
      `shouldBe` Left (SetupTooLarge 255000000 largestSetup)
    -- At 8 positions, so that patches of 2^22 cells have 2^25 together.
    eight <- naturally <$> arrayOver gf3 2 Diagonal (Shape 1 8)
    map (either Just (const Nothing) . trialSetup eight . Shape 1) [4194304, 4194305]
      `shouldBe` [Nothing, Just (SetupTooLarge 33554440 largestSetup)]
  it "patches of up to 1000 cells have exact rates, which add up to 1" $ do
    array <- arrayOver gf2 4 Diagonal (Shape 3 5)
    forM_ [(Shape 25 40, True), (Shape 7 143, False)] $ \(size, known) -> do
      m <- right (rectangle size)
      let rates = exactOn Guaranteed (naturally array) m (Damage 0.2 0)
      (size, fmap (\(Rates a b c) -> abs (a + b + c - 1) < 1e-9) rates)
        `shouldBe` (size, if known then Just True else Nothing)
  where
    trials = 5000 :: Int
    trialsOf setup damage seed =
      unfoldr
        (Just . drawTrial setup (noiseOf setup damage) (damageErasures damage))
        (mkStdGen seed)
    noiseOf setup damage =
      noiseFor (fieldOrder (arrayItself (setupArray setup))) (damageErrors damage)

-- | What a trial comes to by 'locate', asked about the likeliest symbols of a locator that looks
-- for the nearest position, and about the probabilities of one that has the posterior. 'Nothing'
-- where a question is refused.
decodeByLocate ::
  forall k.
  KnownField k =>
  Locator k ->
  Locator k ->
  Radius ->
  TrialSetup k ->
  PatchTrial ->
  Maybe PatchResult
decodeByLocate nearest withPosterior radius setup trial = do
  beliefs <-
    traverse
      (traverse reading)
      (chunked (fromIntegral (columns (setupShape setup))) [0 .. setupCells setup - 1])
      >>= rightOnly . patch
  hard <- rightOnly (locate nearest (query (Symbol . likeliest <$> beliefs)))
  soft <-
    rightOnly (locate withPosterior (query (Probabilities <$> beliefs)))
      >>= answerPosterior
  pure
    PatchResult
      { resultHard = case answerOutcome hard of
          Unique found _ -> if candidatePosition found == true then Correct else Mistaken
          _ -> NoAnswer,
        resultLikeliest = fmap candidatePosition (posteriorBest soft) == Just true,
        resultDoubt = posteriorDoubt soft
      }
  where
    query seen = (onePatch seen) {queryRadius = radius}
    rightOnly = either (const Nothing) Just
    true = positionOf (arrayItself (setupArray setup)) (trialPosition trial)
    q = fieldOrder (Proxy :: Proxy k)
    reading j
      | not (testBit (trialSeen trial Primitive.! (j `div` 64)) (j `mod` 64)) = Just Nothing
      | otherwise = Just <$> rightOnly (belief (map (/ sum weights) weights))
      where
        evidence = Primitive.toList (Primitive.slice (j * q) q (trialEvidence trial))
        weights = map (\x -> exp (x - maximum evidence)) evidence
    chunked size xs = case splitAt size xs of
      ([], _) -> []
      (first, others) -> first : chunked size others

exactOn :: KnownField k => Radius -> ArrayOn k -> Mask -> Damage -> Maybe Rates
exactOn stated array m = exactRates stated (locator Nothing MostSignificantFirst array m) m

-- | What decoding may make of a trial. Doubts are such as add up without rounding.
genResult :: Gen PatchResult
genResult =
  PatchResult
    <$> QuickCheck.elements [minBound ..]
    <*> arbitrary
    <*> ((/ 1024) . fromIntegral <$> choose (0, 1024 :: Int))
