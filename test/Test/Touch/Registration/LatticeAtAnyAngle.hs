-- | Tests frames of symbols on a lattice at any angle: their templates, their registration, and
-- whether they contradict each other.
module Test.Touch.Registration.LatticeAtAnyAngle (spec) where

import Data.Foldable (for_)
import Data.List (sort, sortOn)
import Data.Maybe (fromMaybe, isNothing)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Noise
import PraTactile.Geometry (columnPitch, rotated, rowPitch)
import PraTactile.Image hiding (mean)
import PraTactile.Random (normalPair)
import PraTactile.Registration hiding (assemble, stitch)
import PraTactile.Registration.Arrangement (withMisfit)
import PraTactile.Registration.Lattice.Angle (latticeAngle)
import PraTactile.Registration.Lattice.Blur (areaSums)
import PraTactile.Registration.Lattice.Fit
import PraTactile.Registration.Lattice.Likelihood
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Symbols (symbolsClasses)
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Neighbours
import PraTactile.Registration.Pair.Methods
import PraTactile.Registration.Posterior
import PraTactile.Registration.Spectrum (spectra)
import PraTactile.Sensor.Frame
import PraTactile.Sensor.Manifest
import PraTactile.Shape hiding (alphabet)
import System.Random (mkStdGen, randomRs)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (classes, generate, tables, total)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (assemble, paperAlphabet, paperTables, stitch)

spec :: Spec
spec = either (it "the alphabet is read" . expectationFailure . show) shaped paperAlphabet

shaped :: Alphabet -> Spec
shaped alphabet = do
  describe "The templates of a frame" (templatesSpec alphabet)
  describe "Frames on a lattice" (registered alphabet)
  describe "The angle of a lattice under frames" (angled alphabet)
  describe "Frames that contradict each other" (contradicting alphabet)
  describe "Frames registered by all their pairs" (jointly alphabet)
  describe "The noise of frames" noise
  describe "What frames differ by without noise" misfit
  describe "Two frames on a lattice" (pairs alphabet)

-- | The scene around (0, 0), as a function of the place in taxels: random symbols in the cells of a
-- lattice, all turned clockwise by these degrees.
scene :: Alphabet -> Int -> Double -> (Double, Double) -> Double
scene alphabet seed angle place
  | u < symbolWidth && v < symbolHeight && embossedAt shape u v = 1
  | otherwise = 0
  where
    (x, y) = rotated (negate angle) place
    (j, u) = floor x `divMod` columnPitch :: (Int, Int)
    (i, v) = floor y `divMod` rowPitch :: (Int, Int)
    classes = shapes alphabet
    -- One class for each cell, the cells in any order.
    shape = classes !! (pick (97 * i + j) `mod` length classes)
    pick k = head (randomRs (0, 1000) (mkStdGen (7919 * seed + 31 * k)))

-- | The reading of a frame of 16 x 16 taxels whose upper left taxel's centre lies there: each the
-- mean over 3 x 3 points, a little wider than a taxel.
felt :: ((Double, Double) -> Double) -> (Double, Double) -> Raster
felt relief (x0, y0) =
  generate 16 16 $ \i j ->
    sum
      [ relief (x0 + fromIntegral i + a, y0 + fromIntegral j + b) / 9
        | a <- [-0.45, 0, 0.45],
          b <- [-0.45, 0, 0.45]
      ]

-- | Four by four frames, eight taxels apart, displaced by these errors.
scanned :: ((Double, Double) -> Double) -> [(Double, Double)] -> [Frame]
scanned relief errors =
  [ Frame
      (SensorPose (taxelPitch * x) (taxelPitch * y) 0)
      1
      (felt relief (x + dx, y + dy))
      taxelPitch
      []
    | ((x, y), (dx, dy)) <-
        zip
          [(fromIntegral i, fromIntegral j) | j <- [0, 8 .. 24 :: Int], i <- [0, 8 .. 24 :: Int]]
          errors
  ]

-- | Normal errors of this standard deviation.
errorsOf :: Double -> Int -> [(Double, Double)]
errorsOf sigma seed = go (mkStdGen seed)
  where
    go g = let ((a, b), g') = normalPair g in (sigma * a, sigma * b) : go g'

templatesSpec :: Alphabet -> Spec
templatesSpec alphabet = do
  withCases 2 20 $
    prop "correlate with any frame at any place as a drawn symbol does, either way up" $
      forAll (elements [0, 0, -77, 30, 90]) $ \angle -> forAll (genRasterOf 16 16) $ \image ->
        let tables = templates alphabet angle 16 16
            count = symbolsClasses (templateSymbols tables)
            (columns, rows) = placesGrid (templatePlaces tables)
            products = correlations tables image
         in forAll
              ( (,,,) <$> choose (0, 1) <*> choose (0, columns - 1) <*> choose (0, rows - 1)
                  <*> choose (0, count - 1)
              )
              $ \(o, x, y, k) ->
                let shape = (if o == 1 then halfTurned else id) (shapes alphabet !! k)
                    told = products V.! (cellIndex (templatePlaces tables) o y x * count + k)
                    symbol = drawing shape angle (placeOf tables x y)
                    drawn = V.sum (V.zipWith (*) (rasterValues image) symbol)
                 in -- Turned, places lie between taxels to a 32nd of one.
                    counterexample (show (told, drawn)) $
                      abs (told - drawn) < (if angle == 0 then 0.05 else 0.3)
  withCases 2 6 $
    -- Along the frame's axes they are exact. Turned, a taxel at the frame's edge counts for the
    -- share of it that is on the frame, which is not quite the share of its square: at half a taxel
    -- over the edge, along all of a symbol, 0.85.
    prop "have the sums and squares of a drawn symbol, at any angle" $
      forAll (elements [-77, -30, 0, 12, 45, 90]) $ \angle ->
        let tables = templates alphabet angle 16 16
            count = symbolsClasses (templateSymbols tables)
            (columns, rows) = placesGrid (templatePlaces tables)
         in forAll
              ((,,) <$> choose (0, columns - 1) <*> choose (0, rows - 1) <*> choose (0, count - 1))
              $ \(x, y, k) ->
                let place = placeOf tables x y
                    drawn = drawing (shapes alphabet !! k) angle place
                    i = cellIndex (templatePlaces tables) 0 y x * count + k
                    total = V.sum drawn
                    squares = V.sum (V.map (\t -> t * t) drawn)
                 in counterexample
                      ( show
                          ( place,
                            k,
                            templateSums tables V.! i,
                            total,
                            templateSquares tables V.! i,
                            squares
                          )
                      )
                      $ abs (templateSums tables V.! i - total) < 0.1
                        && abs (templateSquares tables V.! i - squares)
                          < (if angle == 0 then 0.1 else 0.9)
  withCases 2 10 $
    prop "have the tables' numbers in single cells" $
      forAll (elements [0, 37, -61]) $ \angle -> forAll (genRasterOf 16 16) $ \image ->
        forAll (choose (0, 2559)) $ \phase ->
          let tables = templates alphabet angle 16 16
              count = symbolsClasses (templateSymbols tables)
              cells = cellsOfPhase (templatePlaces tables) phase
              TemplateSums products sums squares =
                momentsAt tables (areaSums (templatePlaces tables) image) (V.fromList cells)
              ofCells numbers = V.concat [V.slice (count * c) count numbers | c <- cells]
           in (products, sums, squares)
                === ( ofCells (correlations tables image),
                      ofCells (templateSums tables),
                      ofCells (templateSquares tables)
                    )
  withCases 2 10 $
    prop "give a frame the same likelihood by the likely phases at whole taxels as by all phases" $
      \seed -> forAll (choose (-90, 90)) $ \angle -> forAll (choose (0, 0.5)) $ \sigma ->
        let image = felt (scene alphabet seed angle) (3, 5)
            noisy =
              generate 16 16 $ \x y ->
                rasterValues image V.! (16 * y + x) + fst (errorsOf sigma seed !! (16 * y + x))
            told = fitOf (templates alphabet angle 16 16) (whole noisy)
         in abs (fitLikely told - logDensity (fitLikelihood told)) < 1e-6
  where
    placeOf tables x y =
      (fromIntegral firstX + fromIntegral x / 2, fromIntegral firstY + fromIntegral y / 2)
      where
        (firstX, firstY) = placesFirst (templatePlaces tables)
    -- The blurred taxels of a symbol, added up on each taxel of a frame of 16 x 16.
    drawing shape angle (x, y) =
      V.fromList
        [ sum
            [ share (fromIntegral u - px) * share (fromIntegral v - py)
              | b <- [0 .. symbolHeight - 1],
                a <- [0 .. symbolWidth - 1],
                embossedAt shape a b,
                let (px, py) = rotated angle (x + fromIntegral a, y + fromIntegral b)
            ]
          | v <- [0 .. 15 :: Int],
            u <- [0 .. 15 :: Int]
        ]
    -- The share of a unit taxel, blurred by a normal distribution of deviation 0.75, by Simpson's
    -- rule on the density.
    share t = sum [w * density (t - 0.5 + s / 20) | (w, s) <- zip simpson [0 .. 20]] / 60
    simpson = 1 : concat (replicate 9 [4, 2]) ++ [4, 1] :: [Double]
    density d = exp (negate (d * d) / (2 * 0.5625)) / sqrt (2 * pi * 0.5625)

registered :: Alphabet -> Spec
registered alphabet = do
  withCases 2 20 $
    prop "stay within reach, also one of another scene, however clear all are" $
      \seed -> forAll (choose (0, 15)) $ \k ->
        let settings = standardRegistration {registrationSigma = Just 1.5, registrationNoise = 0}
            frames = scanned (scene alphabet seed 0) (errorsOf 1 seed)
            other = scanned (scene alphabet (seed + 1) 0) (errorsOf 1 seed)
            mixed = take k frames ++ [other !! k] ++ drop (k + 1) frames
         in case assemble ByLattice settings mixed of
              Left e -> counterexample (show e) False
              Right assembly ->
                let shifts = map registeredShift (assemblyFrames assembly)
                 in counterexample (show shifts) $
                      all (\(dx, dy) -> max (abs dx) (abs dy) <= 2 * 4.5 * 1.5) shifts
  it
    "are registered at any angle from errors of two taxels, mostly with certainty, and then well"
    $ do
      let told =
            [ assemble
                Automatic
                settings
                (scanned (scene alphabet seed angle) (take 16 (errorsOf 2 seed)))
              | (seed, angle) <- scenes
            ]
          settings = standardRegistration {registrationSigma = Just 2}
      [assemblyMethod made | Right made <- told] `shouldBe` (ByLattice <$ scenes)
      let frames =
            [ (registeredProbability f >= Just 0.99, max (abs (x - x0)) (abs (y - y0)))
              | (Right made, (seed, _)) <- zip told scenes,
                let ds = zipWith less (map registeredShift (assemblyFrames made)) (errorsOf 2 seed)
                    x0 = middle (map fst ds)
                    y0 = middle (map snd ds),
                (f, (x, y)) <- zip (assemblyFrames made) ds
            ]
          sure = [off | (True, off) <- frames]
      length sure `shouldSatisfy` (>= (9 * length frames) `quot` 10)
      length (filter (> 1) sure) `shouldSatisfy` (<= length sure `quot` 50)
  it "turned with their places by quarter turns have displacements turned alike" $
    for_ (byEffort [2] [1 .. 3]) $ \seed -> do
      let errors = take 16 (errorsOf 2 (100 + seed))
          settings = standardRegistration {registrationSigma = Just 2}
          frames = scanned (scene alphabet seed 25) errors
          moved = fmap (compositeDisplacements . assemblyComposite) . assemble ByLattice settings
          quarter (x, y) = (negate y, x)
      case (moved frames, moved (map turnedFrame frames)) of
        (Right here, Right there) ->
          spreadOf (zipWith less there (map quarter here)) `shouldSatisfy` (< 0.4)
        other -> expectationFailure (show other)
  where
    scenes =
      byEffort (filter ((`elem` [-61, 0, 45]) . snd)) id $
        zip [1 ..] [-88, -61, -45, -33, -20, 0, 7, 29, 45, 52, 71]
    middle ts = sort ts !! (length ts `quot` 2)
    less (x, y) (x', y') = (x - x', y - y')
    spreadOf ds =
      let n = fromIntegral (length ds)
          mean part = sum (map part ds) / n
       in sqrt
            ( sum [(x - mean fst) ^ (2 :: Int) + (y - mean snd) ^ (2 :: Int) | (x, y) <- ds]
                / (2 * n)
            )
    -- A quarter turn clockwise about the origin, of place and image; the sensor is not turned.
    turnedFrame frame =
      let SensorPose x y r = framePose frame
          turned' i j = at (frameImage frame) j (15 - i)
       in frame {framePose = SensorPose (negate y) x r, frameImage = generate 16 16 turned'}
    at image i j = rasterValues image V.! (j * 16 + i)

angled :: Alphabet -> Spec
angled alphabet =
  it "is the lattice's to two degrees, up to a half turn, and lies in [-90, 90)" $
    for_ (zip [1 ..] angles) $ \(seed, angle) -> do
      let images = map frameImage (scanned (scene alphabet seed angle) (errorsOf 1 seed))
          tables = paperTables
          -- Symbols show their angle up to quarter turns.
          hint = angle - 90 * fromIntegral (round (angle / 90) :: Int)
      case latticeAngle (fitsAt tables (map whole images)) (spectra 16 16) [hint] images of
        Nothing -> expectationFailure (show (seed, angle))
        Just against -> do
          let told = fitsAngle against
              off = told - angle
          (angle, told) `shouldSatisfy` (\(_, t) -> t >= -90 && t < 90)
          (angle, abs (off - 180 * fromIntegral (round (off / 180) :: Int)))
            `shouldSatisfy` ((< 2) . snd)
  where
    angles =
      byEffort [-90.2, -45, 89.6] $
        [-91, -90.6 .. -88.4] ++ [-45, 44] ++ [88.4, 88.8 .. 91]

contradicting :: Alphabet -> Spec
contradicting alphabet = do
  it "are not found if their positions are right, to the robot's error" $
    for_ (byEffort [1, 7] [1 .. 12]) $ \seed ->
      contradictionOf (scan seed) `shouldBe` Nothing
  it "are found if an axis is flipped or both are exchanged, with the axes along which they agree" $
    for_
      (zip [1 ..] [(a, b) | (a, _) <- axesNamed, a /= "x,y", b <- byEffort [1] [1 .. 3 :: Int]])
      $ \(seed, (name, _)) -> for_ (lookup name axesNamed) $ \axes ->
        -- The axes along which these positions are the original ones.
        contradictionOf [f {framePose = unalong axes (framePose f)} | f <- scan seed]
          `shouldBe` Just (AgreeingAlong axes)
  it "are found, along no axes, if the images belong to other places" $
    for_ (byEffort [3] [1 .. 6]) $ \seed ->
      let frames = scan seed
          order = map snd (sortOn fst (zip (randomRs (0, 1 :: Double) (mkStdGen seed)) frames))
       in contradictionOf (zipWith (\f g -> f {frameImage = frameImage g}) frames order)
            `shouldSatisfy` maybe False isAnywhere
  it "are not found if blank or single; at a wrong scale, the right scale is named" $ do
    let blank = [f {frameImage = constant 16 16 0.4} | f <- scan 1]
        apart =
          [ f
              { framePose =
                  (framePose f) {poseX = 5 * poseX (framePose f), poseY = 5 * poseY (framePose f)}
              }
            | f <- scan 2
          ]
    for_ [blank, take 1 (scan 3)] $ \frames ->
      contradictionOf frames `shouldSatisfy` isNothing
    contradictionOf apart `shouldSatisfy` maybe False (isScale 0.2)
  where
    scan seed = scanned (scene alphabet seed (fromIntegral (17 * seed))) (errorsOf 0.8 seed)
    isScale s found = case found of
      AgreeingAtScale across down -> all ((< 0.03) . abs . subtract 1 . (/ s)) [across, down]
      _ -> False
    isAnywhere found = case found of
      AgreeingAnywhere {} -> True
      _ -> False
    contradictionOf =
      either (error . show) compositeContradiction
        . (\frames -> stitch (withNoiseOf frames known) frames)
    known = standardRegistration {registrationSigma = Just 1}
    -- The pose which these axes map to the given one.
    unalong axes pose =
      head
        [ p
          | (_, back) <- axesNamed,
            let p = alongAxes back pose,
            let SensorPose x y _ = alongAxes axes p,
            abs (x - poseX pose) < 1e-9 && abs (y - poseY pose) < 1e-9,
            alongAxes axes (alongAxes back (SensorPose 1 2 0)) == SensorPose 1 2 0
        ]

jointly :: Alphabet -> Spec
jointly alphabet = do
  it "are placed to half a taxel, from errors of one and a half" $
    for_ (byEffort [2] [1 .. 4]) $ \seed -> do
      let errors = take 16 (errorsOf 1.5 seed)
      away errors (scanned (scene alphabet seed 10) errors) `shouldSatisfy` (< 0.5)
  it "are placed to three quarters of a taxel if one of them shows another place" $
    for_ (byEffort [2] [1 .. 4]) $ \seed -> do
      let errors = take 16 (errorsOf 1.5 seed)
          frames = scanned (scene alphabet seed 10) errors
          stray = felt (scene alphabet (seed + 50) 33) (200, 100)
          strayed =
            [if k == 5 then f {frameImage = stray} else f | (k, f) <- zip [0 :: Int ..] frames]
      away errors strayed `shouldSatisfy` (< 0.75)
  prop "neighbours are the pairs whose rectangles overlap, with the share of the overlap" $
    forAll (vectorOf 7 ((,) <$> choose (0, 40) <*> choose (0, 40))) $ \places ->
      let images = [((x, y), constant 9 7 0) | (x, y) <- places]
          told = [(k, l, share) | OverlappingPair k l _ share <- neighbours images]
          meeting n a b = max 0 (n - abs (a - b)) / n
          expected =
            [ (k, l, meeting 9 x x' * meeting 7 y y')
              | (k, (x, y)) <- zip [0 ..] places,
                (l, (x', y')) <- zip [0 ..] places,
                k < l,
                meeting 9 x x' * meeting 7 y y' > 0
            ]
          close (k, l, a) (k', l', b) = k == k' && l == l' && abs (a - b) < 1e-9
       in counterexample (show (sort told, expected)) $
            length told == length expected && and (zipWith close (sort told) expected)
  where
    away errors frames =
      case assemble ByPairs standardRegistration {registrationSigma = Just 1.5} frames of
        Right made ->
          -- By the median, since a stray frame is nowhere right.
          let ds = zipWith minus (compositeDisplacements (assemblyComposite made)) errors
              (x0, y0) = (middle (map fst ds), middle (map snd ds))
           in middle [max (abs (x - x0)) (abs (y - y0)) | (x, y) <- ds]
        Left _ -> 1 / 0
    minus (x, y) (x', y') = (x - x', y - y')
    middle ts = sort ts !! (length ts `quot` 2)

pairs :: Alphabet -> Spec
pairs alphabet =
  it "may lie at their true places, wherever the lattice lies under the first of them" $
    for_ (byEffort everyFifth id (zip [0, 0.5 .. 19.5] (cycle [0, 0.5 .. 15.5]))) $ \(x, y) -> do
      let relief = scene alphabet 5 0
          told = likelihood (templates alphabet 0 16 16) . whole
          noisy k image = zipWithRaster image (take 256 (map fst (errorsOf 0.05 k)))
          a = told (noisy 1 (felt relief (x, y)))
          b = told (noisy 2 (felt relief (x + 8, y)))
          GridPosterior _ _ _ masses = latticePosterior (8, 0) 1 a b
      -- Of five by five places half a taxel apart, the one in the middle.
      ((x, y), masses V.! 12) `shouldSatisfy` ((> 0.001) . snd)
  where
    everyFifth places = [place | (0, place) <- zip (cycle [0 .. 4 :: Int]) places]
    zipWithRaster image errors =
      generate 16 16 $ \x y -> fromMaybe 0 (index image x y) + errors !! (16 * y + x)

misfit :: Spec
misfit = do
  it "is a twentieth of the relief's variance, and nothing without relief" $ do
    let checked = generate 8 8 (\x y -> fromIntegral ((x + y) `mod` 2))
        told noise' frames =
          registrationNoise (withMisfit frames standardRegistration {registrationNoise = noise'})
    -- The checks' variance is 0.25, of which the noise has a hundredth here.
    told 0 [checked] `shouldSatisfy` near (sqrt 0.0125)
    told 0.05 [checked] `shouldSatisfy` near (sqrt (0.0025 + 0.05 * 0.2475))
    told 0 [checked, constant 8 8 0.3] `shouldSatisfy` near (sqrt 0.00625)
    told 0.07 [constant 8 8 0.3] `shouldSatisfy` near 0.07
    told 0.8 [checked] `shouldSatisfy` near 0.8
    told 0.1 [] `shouldSatisfy` near 0.1
  prop "grows with the frames' contrast" $
    forAll (genRasterOf 8 8) $ \image -> forAll (choose (0.1, 10)) $ \gain ->
      let told frame =
            registrationNoise (withMisfit [frame] standardRegistration {registrationNoise = 0})
       in abs (told (mapRaster (gain *) image) - gain * told image) < 1e-9
  where
    near wanted came = abs (wanted - came) < 1e-9

noise :: Spec
noise = do
  it "is the standard deviation of normal white noise, to a tenth" $
    for_ (zip [1 ..] [0.01, 0.1, 0.5]) $ \(seed, sigma) -> do
      let values = map fst (errorsOf sigma seed)
          images = [generate 16 16 (\i j -> values !! (256 * k + 16 * j + i)) | k <- [0 .. 11]]
      frameNoise images `shouldSatisfy` \s -> abs (s - sigma) < 0.1 * sigma
  it "is 0 for a plane, for a blank, and for frames too small to tell" $ do
    let plane = generate 16 16 (\i j -> 0.1 + 0.02 * fromIntegral i - 0.01 * fromIntegral j)
    for_ [[plane], [constant 16 16 0.3], [constant 1 9 0.3], []] $ \images ->
      frameNoise images `shouldSatisfy` (< 1e-9)
  prop "grows with the gain, and not with the offset" $
    forAll ((,) <$> choose (0.1, 3) <*> choose (-1, 1)) $ \(gain, offset) ->
      let image = generate 9 7 (\i j -> fromIntegral ((7 * i * i + 5 * j) `mod` 11))
          changed = mapRaster (\t -> gain * t + offset) image
       in abs (frameNoise [changed] - gain * frameNoise [image]) < 1e-6 * (1 + gain)
