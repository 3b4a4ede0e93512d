{-# OPTIONS_GHC -O1 #-}

-- | Tests the steps of the joint registration of frames to a lattice, each against its formula, for
-- any likelihoods: the phase of the lattice, the displacements of a frame, the mean field, and the
-- final places.
module Test.Touch.Registration.JointByFormulas (spec) where

import Control.Monad (forM)
import Data.List (maximumBy)
import qualified Data.Map.Strict as Map
import Data.Ord (comparing)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Image (constant)
import PraTactile.Registration.Definition (FrameLikelihoods (..), Robot (..), estimate, likely)
import qualified PraTactile.Registration.Definition as Definition
import PraTactile.Registration.Estimate
import PraTactile.Registration.Field
import PraTactile.Registration.Field.Cells
import PraTactile.Registration.Joint.Displacement
import PraTactile.Registration.Joint.Phase
import PraTactile.Registration.Lattice.Fit (likelihood, whole)
import PraTactile.Registration.Lattice.Likelihood (Likelihood (..))
import PraTactile.Registration.Lattice.Places (placesGrid)
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Numbers (cellShare)
import PraTactile.Registration.Posterior (Hypothesis (..))
import PraTactile.Registration.Settings (Registration (..), standardRegistration, supposedSigma)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (classes, scale, tables, total)
import Test.Touch.Paper (paperTables)

spec :: Spec
spec = do
  gridSpec
  withCases 2 24 phaseSpec
  withCases 5 40 optionSpec
  withCases 50 400 consensusSpec
  withCases 37 300 locatedSpec

-- The likelihood of an empty frame, to be replaced.
blank :: Likelihood
blank = likelihood (tablesOf 0 (16, 16)) (whole (constant 16 16 0))
  where
    tablesOf = tablesAt paperTables

-- | A frame at this place, with these log-likelihoods of phases and classes.
seenAt :: (Double, Double) -> V.Vector Double -> V.Vector Double -> FrameLikelihoods
seenAt place phases classes =
  FrameLikelihoods
    place
    (Map.fromList (zip (indices 40 32) (V.toList phases)))
    (Map.fromList (zip (indices rows columns) (inFours (V.toList classes))))
  where
    indices m n = [(o, y, x) | o <- [0, 1], y <- [0 .. m - 1], x <- [0 .. n - 1]]
    (columns, rows) = placesGrid (templatePlaces (likelihoodTables blank))
    inFours values = case splitAt 4 values of
      ([], _) -> []
      (some, rest) -> some : inFours rest

-- | The robot that the settings assume, with a known error.
robotOf :: Registration -> Robot
robotOf settings = Robot (sigma / 2, 2 * sigma) (gridReach (latticeGrid settings))
  where
    sigma = supposedSigma settings

genPlace :: Gen (Double, Double)
genPlace = (,) <$> choose (-40, 40) <*> choose (-40, 40)

gridSpec :: Spec
gridSpec =
  it "displacements reach as far as the search, by half taxels: from 2 to 64 of them" $
    [ gridReach . latticeGrid $
        standardRegistration {registrationSigma = Just s, registrationReach = r}
      | (s, r) <- [(1, 4.5), (0.1, 1), (0.5, 2.2), (2, 4.5), (7, 4.5), (7.2, 4.5), (1, 0)]
    ]
      `shouldBe` [18, 2, 5, 36, 63, 64, 2]

phaseSpec :: Spec
phaseSpec = do
  prop "the glimpsed log is at most the likeliest phase's, and equals it for a single frame" $
    forAllBlind (choose (1, 4) >>= (`vectorOf` genOnePhase)) $ \frames ->
      forAll (elements [0.5, 1, 2]) $ \sigma ->
        let grid = latticeGrid standardRegistration {registrationSigma = Just sigma}
            phases only = V.generate 2560 (\i -> if i == only then 0 else -1000)
            seen =
              [ (place, blank {phaseLogs = phases only, likeliestPhase = only})
                | (place, only) <- frames
              ]
            quick = quickPhaseLog grid seen
            likeliest = commonLog (commonPhase grid seen Nothing)
         in counterexample (show (quick, likeliest)) $
              quick <= likeliest + 1e-9
                && (length frames > 1 || abs (quick - likeliest) < 1e-9)
  it "the common phase is the likeliest over all frames, each within its prior" $
    forAllBlind (choose (2, 3) >>= (`vectorOf` ((,) <$> genPlace <*> genPhases))) $ \frames ->
      forAll (choose (0.2, 0.5)) $ \sigma ->
        let settings =
              standardRegistration
                { registrationSigma = Just sigma,
                  registrationReach = byEffort 1.5 3
                }
            robot = robotOf settings
            (o, y, x) = Definition.commonPhase robot [seenAt p v V.empty | (p, v) <- frames]
            seen = [(p, blank {phaseLogs = v}) | (p, v) <- frames]
            found = commonPhase (latticeGrid settings) seen Nothing
         in (commonOrientation found, commonRowColumn found) === (o, (y, x))
  where
    genOnePhase = (,) <$> genPlace <*> choose (0, 2559)
    genPhases = do
      wide <- elements [6, 5000, 20000, 20000]
      V.fromList <$> vectorOf (2 * 40 * 32) (choose (negate wide, 0))

optionSpec :: Spec
optionSpec = do
  it "a place exactly e^12 less likely than the best counts, and one slightly less does not" $
    -- A place to the right of the nominal one, and one to the left, have equal priors.
    [ map displacementShift (displacementsOf (latticeGrid robot) 0 (0, 0) ((0, 0), seen l))
      | let robot = standardRegistration {registrationSigma = Just 1},
        let seen l = blank {phaseLogs = V.replicate 2560 (-1000) V.// [(31, 0), (1, l)]},
        l <- [-12, -12.000001]
    ]
      `shouldBe` [[(-1, 0), (1, 0)], [(1, 0)]]
  it "a frame's displacements are those within e^12 of its best, and the cells seen there" $
    forAllBlind genSeen $ \(phases, classes, place, sigma) ->
      forAll (elements [0, 1]) $ \o ->
        forAll ((,) <$> choose (0, 39) <*> choose (0, 31)) $ \(y, x) ->
          let robot = standardRegistration {registrationSigma = Just sigma, registrationReach = 3}
              told = blank {phaseLogs = phases, classLogs = classes}
              upTo margin = likely margin (robotOf robot) (o, y, x) (seenAt place phases classes)
              found = displacementsOf (latticeGrid robot) o (y, x) (place, told)
              shifts = map displacementShift found
              -- At the edge itself rounding decides.
              wanted = [one | one@(d, _, _) <- upTo (12 + 1e-9), d `elem` shifts]
           in (shifts === [d | (d, _, _) <- wanted])
                .&&. property (all (`elem` shifts) [d | (d, _, _) <- upTo (12 - 1e-9)])
                .&&. conjoin
                  [ property (close (displacementSquare option) square)
                      .&&. [(cell c, Unboxed.toList ls) | (c, ls) <- displacementCells option]
                      === Map.toList cells
                    | (option, (_, square, cells)) <- zip found wanted
                  ]
  where
    close a b = abs (a - b) < 1e-9 * max 1 (abs b)
    -- A cell's row and column from its one number.
    cell k = let (i, j) = (k + 524288) `divMod` 1048576 in (i, j - 524288)
    -- Numbers of which some are exactly 12 below the best, or any.
    genSeen = do
      classes <- V.fromList <$> vectorOf (4 * V.length (cellLogs blank)) (choose (-9, 9))
      let phases = fmap V.fromList . vectorOf (2 * 40 * 32)
          halves k = fromIntegral <$> choose (negate k, k :: Int)
      wide <- elements [10, 60]
      oneof
        [ (,,,) <$> phases ((/ 2) <$> halves 30) <*> pure classes
            <*> ((,) <$> ((/ 2) <$> halves 80) <*> ((/ 2) <$> halves 80))
            <*> pure 0.5,
          (,,,) <$> phases (choose (negate wide, 0)) <*> pure classes <*> genPlace
            <*> choose (0.2, 1.5)
        ]

consensusSpec :: Spec
consensusSpec = do
  it "two frames that keep changing together are stopped after five sweeps" $ do
    -- Each begins at one of two displacements, to which the other frame's other one fits.
    let robot = Grid 2 5 [1]
        -- The square that makes a displacement this much likelier than none, for a deviation of 1.
        square l = -2 * (1 + 1 / 12) * l
        either' first second =
          [ displacementOf (0, 0) (square first) [(1, Unboxed.fromList [10, 0, 0])],
            displacementOf (4, 0) (square second) [(1, Unboxed.fromList [0, 10, 0])]
          ]
        likeliest = map (displacementShift . fst . maximumBy (comparing snd))
    likeliest (fieldFrames (meanField robot [either' 1 0, either' 0 1])) `shouldBe` [(4, 0), (0, 0)]
  it "each frame weighs its displacements by those of all others, until none changes" $
    forAll (choose (1, 4) >>= (`vectorOf` genTold)) $ \frames ->
      let grid = Grid 2 5 sigmas
          field@(MeanField found) = meanField grid (map (map option) frames)
          bySigma = sigmaShares grid (fieldSquares field)
          (wanted, bySigma') = Definition.meanField sigmas frames
          close a b = abs (a - b) < 1e-9
       in counterexample (show (map (map snd) found, wanted)) $
            map (map (displacementShift . fst)) found === map (map (\(d, _, _) -> d)) frames
              .&&. property (and (zipWith (\f w -> and (zipWith close (map snd f) w)) found wanted))
              .&&. property (and (zipWith close bySigma bySigma'))
  prop "the bound is never above log P, and equals it if nothing is open" $
    forAll (choose (1, 3) >>= (`vectorOf` genTold)) $ \frames ->
      forAll (elements [[2], [1, 3, 8]]) $ \some ->
        let grid = Grid 2 5 some
            field = meanField grid (map (map option) frames)
            bound = fieldBound grid field (fieldTold field)
            exact = Definition.togetherLog some (map (map part) frames)
            sure = length some == 1 && all ((== 1) . length) frames
         in counterexample (show (bound, exact)) $
              bound <= exact + 1e-9 * max 1 (abs exact) && (not sure || abs (bound - exact) < 1e-6)
  where
    sigmas = [1, 1.3, 2, 5, 8]
    part (d, square, cells) = (d, square, fmap (map (cellShare *)) cells)
    option (d, square, cells) =
      displacementOf d square [(c, Unboxed.fromList l) | (c, l) <- Map.toList cells]
    genTold :: Gen [((Int, Int), Double, Map.Map Int [Double])]
    genTold = do
      count <- choose (1, 4)
      strength <- elements [1, 5, 60, 900]
      places <- take count <$> shuffle [(x, y) | x <- [-5 .. 5], y <- [-5, 0, 5]]
      forM places $ \place ->
        (,,) place <$> choose (0, 60)
          <*> (sublistOf [1, 2, 3] >>= fmap Map.fromList . mapM (toldOf strength))
    toldOf strength c = (,) c <$> vectorOf 3 (symmetric strength)
    symmetric strength = choose (negate strength, strength)

locatedSpec :: Spec
locatedSpec = do
  it "no probability of a frame exceeds 1, despite rounding" $
    forAll (vectorOf 9 (choose (0.1, 1))) $ \weights ->
      let places = [(i, j) | j <- [-1 .. 1], i <- [-1 .. 1]]
          found = estimateAt halves (0, 0) (zip places (map (/ sum weights) weights))
       in estimateProbability found <= 1 && estimateProbability found > 0.999
  it "a frame is at the mean around its greatest mass; its alternatives are two taxels off" $
    forAll genPlace $ \place -> forAll genMasses $ \options ->
      let Estimate shift (alongX, alongY) probability others onGrid' =
            estimateAt halves (snd (onGrid halves place)) options
          Estimate shift' (alongX', alongY') probability' others' onGrid'' = estimate place options
          probabilities = map hypothesisProbability
          close a b = counterexample (show (a, b)) (abs (a - b) < 1e-9)
       in conjoin
            [ shift === shift',
              close alongX alongX',
              close alongY alongY',
              close probability probability',
              map hypothesisShift others === map hypothesisShift others',
              onGrid' === onGrid'',
              conjoin (zipWith close (probabilities others) (probabilities others'))
            ]
  where
    halves = Grid 2 12 [1]
    -- Some that count and some that hardly do, in parts of 2^14, so that sums are exact.
    genMasses = do
      reach <- elements [1, 2, 6, 12]
      count <- choose (1, 30)
      small <- elements [512, 64, 20, 12]
      weights <- vectorOf count (elements [512, small])
      places <- vectorOf count ((,) <$> choose (-reach, reach) <*> choose (-reach, reach))
      pure (zip places (map (/ 16384) weights))
