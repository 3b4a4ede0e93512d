{-# OPTIONS_GHC -O1 #-}

-- | Tests registration by the lattice as a whole against its formulas: the likelihood of one frame,
-- the places of many frames, and the place of one in another.
module Test.Touch.Registration.ByDefinition (spec) where

import Control.Monad (forM)
import Data.Foldable (toList)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Registration.Definition
import PraTactile.Registration.Joint
import PraTactile.Registration.Lattice.Fit
import PraTactile.Registration.Lattice.Likelihood (Likelihood (..))
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Symbols (symbolsClasses)
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Model
import PraTactile.Registration.Pair.Methods
import PraTactile.Registration.Posterior (GridPosterior (..), Hypothesis (..))
import PraTactile.Registration.Settings (Registration (..), standardRegistration)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (classes, generate, sample, tables, total)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (paperAlphabet, paperTables)
import Test.Touch.Registration.Face (frameAt)
import Test.Touch.Sensor.MeanHeights (embossing)

spec :: Spec
spec = do
  cellSpec
  withCases 2 10 frameSpec
  withCases 2 12 ascentSpec
  withCases 1 6 jointSpec
  withCases 1 6 pairSpec

cellSpec :: Spec
cellSpec =
  it "the likelihood of a cell is the mean over its classes, and 0.01 for an empty one" $
    forAll (elements [0.5, 5, 50, 900]) $ \wide ->
      forAll (choose (1, 9) >>= (`vectorOf` choose (negate wide, wide))) $ \told ->
        let found = cellLog (length told) (told !!)
            wanted = cellLogOf told
         in counterexample (show (found, wanted)) $
              -- A class that is less likely by e^30 does not count.
              abs (found - wanted) < 1e-9 * max 1 (abs found)

tablesOf :: Double -> (Int, Int) -> LatticeTemplates
tablesOf = tablesAt paperTables

-- | The tables' values for a frame at any angle, which other tests compare with drawn symbols.
tabled :: LatticeTemplates -> Raster -> SymbolMoments
tabled tables image =
  Map.fromList
    [ ((o, firstY * q + y, firstX * q + x), [(at products, at sums, at squares) | at <- classes])
      | o <- [0, 1],
        y <- [0 .. rows - 1],
        x <- [0 .. columns - 1],
        let start = cellIndex places o y x * count,
        let classes = [(V.! (start + k)) | k <- [0 .. count - 1]]
    ]
  where
    places = templatePlaces tables
    q = placesFineness places
    (firstX, firstY) = placesFirst places
    (columns, rows) = placesGrid places
    count = symbolsClasses (templateSymbols tables)
    (products, sums, squares) =
      (correlations tables image, templateSums tables, templateSquares tables)

-- | The number in the tables of a phase that begins there, in places from the frame's upper left
-- taxel.
phaseNumber :: LatticeTemplates -> (Int, Int, Int) -> Int
phaseNumber tables (o, y, x) =
  (o * down + (y - q * firstY) `mod` down) * across + (x - q * firstX) `mod` across
  where
    q = placesFineness (templatePlaces tables)
    (firstX, firstY) = placesFirst (templatePlaces tables)
    (across, down) = (16 * q, 20 * q)

paper :: SymbolReadings
paper = either (error . show) drawings paperAlphabet

-- | The correlations of a frame at whole and at half taxels: drawn along its axes, from the tables
-- at angles.
felt :: Double -> Raster -> (SymbolMoments, SymbolMoments)
felt angle image
  | angle == 0 = (drawn paper 1 image, drawn paper 2 image)
  | otherwise = (tabled (coarser tables) image, tabled tables image)
  where
    tables = tablesOf angle (rasterSize image)

-- | By definition, theta and the likelihoods of the classes that follow from it; and theta at whole
-- taxels, by the phases that count there.
fitted ::
  Double ->
  Raster ->
  (Theta, Map.Map (Int, Int, Int) [Double], (Theta, (Int, Int, Int) -> Bool))
fitted angle image = (theta, classLogsOf theta fine, (rough, counts))
  where
    (coarse, fine) = felt angle standard
    standard = standardised image
    n = taxels image
    start = firstTheta standard
    -- Those that are not less likely at first by e^30; and those less than a taxel from them.
    counts = amongAll 640 (likelyOf start)
    rough = iterate (mStep 1 n counts coarse) (mStep 1 n (const True) coarse start) !! 3
    theta = mStep 2 n (amongAll 2560 fineOnes) fine rough
    likelyOf at = Map.keysSet (Map.filter (> maximum phases - 30) phases)
      where
        phases = phaseLogsOf 1 (classLogsOf at coarse)
    fineOnes =
      Set.fromList
        [ (o, (2 * y + j) `mod` 40, (2 * x + i) `mod` 32)
          | (o, y, x) <- Set.toList (likelyOf rough),
            j <- [-1 .. 1],
            i <- [-1 .. 1]
        ]
    -- All, if these are more than a quarter.
    amongAll count these
      | 4 * Set.size these > count = const True
      | otherwise = (`Set.member` these)

taxels :: Raster -> Double
taxels image = let (w, h) = rasterSize image in fromIntegral (w * h)

near :: Double -> String -> [Double] -> [Double] -> Property
near to what found wanted =
  counterexample (what ++ show (take 5 [p | p@(a, b) <- zip found wanted, abs (a - b) >= to])) $
    length found == length wanted && and (zipWith (\a b -> abs (a - b) < to) found wanted)

frameSpec :: Spec
frameSpec =
  it "a frame's likelihood sums over phases and classes, after four coarse steps and a fine one" $
    forAllBlind genFrame $ \image -> forAll (elements [0, 0, 30]) $ \angle ->
      let tables = tablesOf angle (rasterSize image)
          n = taxels image
          (coarse, _) = felt angle (standardised image)
          (theta@(Theta a b v), classes, (hint, few)) = fitted angle image
          phases = phaseLogsOf 2 classes
          hinted = Map.filterWithKey (\k _ -> few k) (phaseLogsOf 1 (classLogsOf hint coarse))
          told = fitOf tables (whole image)
          Likelihood _ (Theta a' b' v') _ classes' cells' phases' _ logs = fitLikelihood told
          some = phaseLogs (fitSome told)
          -- Values of evaluated phases are equal, and the phases left out hardly matter.
          told' k l = let l' = some V.! phaseNumber tables k in if isInfinite l' then l else l'
          -- The tables' blur is accurate to 1e-7, and logarithms are large.
          close what one other = near (1e-4 * (1 + maximum (map abs other))) what one other
       in conjoin
            [ near 1e-4 "theta" [a', b', v'] [a, b, v],
              close
                "classes"
                (V.toList classes')
                (concat (Map.elems classes)),
              close "cells" (V.toList cells') (map cellLogOf (Map.elems classes)),
              close
                "phases"
                [phases' V.! phaseNumber tables k | k <- Map.keys phases]
                (Map.elems phases),
              close "some phases" [told' k l | (k, l) <- Map.toList phases] (Map.elems phases),
              near
                0.1
                "what is left out"
                [logDensity (fitSome told)]
                [logs],
              close "log" [logs] [density n theta (Map.size phases) (Map.elems phases)],
              close "roughly" [fitCoarse told] [density n hint 640 (Map.elems hinted)]
            ]

genFrame :: Gen Raster
genFrame = do
  (w, h) <- elements [(11, 12), (9, 13)]
  rough <- genRasterOf w h
  noise <- genRasterOf w h
  block <- elements [1, 3, 5]
  (dx, dy) <- (,) <$> choose (-6, 8) <*> choose (-8, 8)
  shape <- elements embossing
  let at image x y = fromMaybe 0 (index image x y)
      blocks x y = if at rough (x `quot` block) (y `quot` block) > 0.6 then 1 else 0
      ramp x y = 0.3 * fromIntegral x - 0.2 * fromIntegral y
  -- Blocks, a symbol, or a slope; with noise or without.
  relief <- elements [blocks, blocks, \x y -> at shape (x - dx) (y - dy), ramp]
  share <- elements [0, 0.1, 1]
  pure (generate w h (\x y -> relief x y + share * at noise x y))

ascentSpec :: Spec
ascentSpec =
  it "no step of expectation and maximisation lowers a frame's likelihood, nor one by phases" $
    forAllBlind genFrame $ \image -> forAll (elements [0, 37, -61]) $ \angle ->
      let tables = tablesOf angle (rasterSize image)
          standard = standardised image
          coarse = tabled (coarser tables) standard
          fine = tabled tables standard
          n = taxels image
          logOf q theta places =
            let phases = phaseLogsOf q (classLogsOf theta places)
             in density n theta (Map.size phases) (Map.elems phases)
          start = firstTheta standard
          thetas = take 5 (iterate (mStep 1 n (const True) coarse) start)
          logs = [logOf 1 theta coarse | theta <- thetas]
          told = fitLikelihood (fitOf tables (whole image))
       in counterexample (show logs) (and (zipWith (\a b -> b >= a - 1e-3) logs (drop 1 logs)))
            .&&. counterexample
              (show (logDensity told, logOf 2 start fine))
              (logDensity told >= logOf 2 start fine)

jointSpec :: Spec
jointSpec =
  it "the places of frames follow from their common phase, displacements and mean field" $
    forAll (elements [0, 0, 20]) $ \angle ->
      forAllBlind genFrames $ \frames ->
        let settings = standardRegistration {registrationSigma = Just 0.4, registrationReach = 2}
            fits = fitsAt paperTables (map (whole . snd) frames) angle
            joint = registerJointly settings fits (map (fmap whole) frames)
            (found, sigma) = (jointFrames joint, jointSigma joint)
            (wanted, sigma') = together (Robot (0.2, 0.8) 4) angle frames
         in conjoin (zipWith alike found wanted)
              .&&. length found === length frames
              .&&. near 1e-3 "sigma" (toList sigma) [sigma' | length frames > 1]
  where
    genFrames = do
      -- Two frames are compared with all phases below.
      count <- elements (byEffort [3] [1, 3])
      forM [1 .. count :: Int] $ \k -> do
        jitter <- (,) <$> choose (-1, 1) <*> choose (-1, 1)
        noise <- genRasterOf 12 13
        let place = (7 * fromIntegral (k `div` 2) + 6, 8 * fromIntegral (k `mod` 2) + 9)
            image = frameAt (12, 13) place
            rough x y = 0.4 * fromMaybe 0 (index noise x y) + fromMaybe 0 (index image x y)
        pure ((fst place + fst jitter, snd place + snd jitter), generate 12 13 rough)
    alike a b =
      counterexample (show (a, b)) $
        nearPlace 1e-9 (estimateShift a) (estimateShift b)
          && nearPlace 1e-3 (estimateDeviation a) (estimateDeviation b)
          && abs (estimateProbability a - estimateProbability b) < 1e-3
          && length (estimateOthers a) == length (estimateOthers b)
          && and (zipWith other (estimateOthers a) (estimateOthers b))
    other (Hypothesis s p) (Hypothesis s' p') = nearPlace 1e-9 s s' && abs (p - p') < 1e-3
    nearPlace to (x, y) (x', y') = abs (x - x') < to && abs (y - y') < to

-- | By definition, the places of frames that a robot displaces, on a lattice at an angle, and the
-- standard deviation of its error.
together :: Robot -> Double -> [((Double, Double), Raster)] -> ([Estimate], Double)
together robot angle frames =
  (map centred located, exp (sum (zipWith (*) qs (map log bySigma))) / 2)
  where
    bySigma = sigmas 6 robot
    seen =
      [ FrameLikelihoods (about (negate angle) place) (phaseLogsOf 2 classes) classes
        | (place, image) <- frames,
          let (_, classes, _) = fitted angle image
      ]
    phase = commonPhase robot seen
    options = map (likely 12 robot phase) seen
    (fields, qs) = meanField bySigma options
    located =
      [ turn (estimate (framePlace one) (zip [d | (d, _, _) <- told] ps))
        | (one, told, ps) <- zip3 seen options fields
      ]
    about degrees (x, y) =
      let (c, s) = (cos (degrees * pi / 180), sin (degrees * pi / 180))
       in (c * x - s * y, s * x + c * y)
    -- Variances along the frames' axes are those along the lattice's by the squares of the cosines.
    turn l =
      let (c, s) = about angle (1, 0)
          (sx, sy) = estimateDeviation l
       in l
            { estimateShift = about angle (estimateShift l),
              estimateDeviation =
                (sqrt ((c * sx) ** 2 + (s * sy) ** 2), sqrt ((s * sx) ** 2 + (c * sy) ** 2)),
              estimateOthers = map (onShift (about angle)) (estimateOthers l)
            }
    onShift f h = h {hypothesisShift = f (hypothesisShift h)}
    -- To the nearest eighth of a taxel.
    middle part =
      let m = sum (map (part . estimateShift) located) / fromIntegral (length located)
       in fromIntegral (round (8 * m) :: Int) / 8
    less (x, y) = (x - middle fst, y - middle snd)
    centred l =
      l
        { estimateShift = less (estimateShift l),
          estimateOthers = map (onShift less) (estimateOthers l)
        }

pairSpec :: Spec
pairSpec =
  it "the posterior of two frames' displacement sums over all phases and symbols together" $
    forAllBlind genPair $ \(step, a, b) ->
      let told = likelihood (tablesOf 0 (12, 13)) . whole
          GridPosterior origin spacing size masses = latticePosterior step 1 (told a) (told b)
          displacements =
            [ ((round (2 * fst step) + i, round (2 * snd step) + j), prior)
              | j <- [-2 .. 2],
                i <- [-2 .. 2],
                -- The search is two standard deviations; in half taxels, with the cell's variance.
                let prior = negate (fromIntegral (i * i + j * j)) / (2 * (1 + 1 / 12))
            ]
          wanted = pairPosterior displacements (classesOf a) (classesOf b)
          classesOf image = let (_, classes, _) = fitted 0 image in classes
       in (origin, spacing, size) === ((fst step - 1, snd step - 1), 0.5, (5, 5))
            .&&. near 1e-3 "masses" (V.toList masses) wanted
  where
    genPair = do
      start <- (,) <$> choose (8, 20) <*> choose (8, 20)
      (dx, dy) <- elements [(6, 0), (0, 7), (-5, 4)]
      share <- elements [0.05, 0.2, 0.4]
      (noiseA, noiseB) <- (,) <$> genRasterOf 12 13 <*> genRasterOf 12 13
      let with noise image =
            generate 12 13 (\x y -> at image x y + share * at noise x y)
          at image x y = fromMaybe 0 (index image x y)
      let there = frameAt (12, 13)
          moved = (fst start + dx, snd start + dy)
      pure ((dx, dy), with noiseA (there start), with noiseB (there moved))
