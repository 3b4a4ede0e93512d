-- | Tests stitching on scenes whose truth is known.
module Test.Touch.Registration.ScenesOfKnownTruth (spec) where

import Control.Monad (forM_)
import qualified Data.ByteString as B
import Data.Either (isLeft, isRight)
import Data.List (genericLength, unfoldr)
import Data.Maybe (fromMaybe)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image
import PraTactile.Image.Pgm (decodePgm, pgmIntensity)
import PraTactile.Random (normalPair, uniform)
import PraTactile.Registration hiding (assemble, stitch)
import PraTactile.Sensor
import PraTactile.Sensor.Frame
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (stitch)
import qualified Test.Touch.Paper as Stitch (assemble)
import Test.Touch.Sensor.MeanHeights (faceOf, texture)

spec :: Spec
spec = do
  describe "A single frame" single
  describe "Known truth" . beforeAll (pure texturedScenes) $ truth
  describe "Symmetries" . beforeAll (pure symbolScenes) $ seenOtherwise
  describe "Without relief or overlap" unseen
  describe "Noise and position errors" noisy
  describe "Refusals" refusals
  describe "Real frames" real

-- | A scene: the frames of a region, the errors of their places in taxels, and the result of
-- stitching them, computed once for all statements.
data Scene = Scene
  { sceneRelief :: HeightMap,
    sceneErrors :: [Taxels],
    sceneFrames :: [Frame],
    sceneStitched :: Either StitchError Composite
  }

-- | Seeds of scenes.
seeds :: [Int]
seeds = [1 .. byEffort 1 10]

-- | The width and height in taxels of the region with the frames of reliefs.
sceneSize :: (Int, Int)
sceneSize = byEffort (24, 32) (32, 40)

scenePoses :: [SensorPose]
scenePoses = uncurry region sceneSize

-- | Scenes of an exact sensor on reliefs with detail everywhere: with errors of whole taxels, with
-- errors of fractions, and without any.
data Textured = Textured {wholly :: [Scene], partly :: [Scene], exactly :: [Scene]}

texturedScenes :: Textured
texturedScenes =
  Textured
    { wholly = [texturedScene (texture seed 60 60) (errorsOf whole seed) | seed <- seeds],
      -- On a relief of cells three taxels wide: one as fine as the sensor itself cannot be
      -- interpolated.
      partly =
        [ texturedScene (texture seed 20 20) {heightPitch = 3 * taxelPitch} (errorsOf id seed)
          | seed <- seeds
        ],
      exactly = [texturedScene (uncurry (texture seed) aroundScene) (repeat (0, 0)) | seed <- seeds]
    }
  where
    whole (x, y) = (fromIntegral (round x :: Int), fromIntegral (round y :: Int))

-- | The width and height in taxels of a relief whose middle contains the region.
aroundScene :: (Int, Int)
aroundScene = let (w, h) = sceneSize in (w + 20, h + 20)

-- | A scene of a relief, with the first of these errors.
texturedScene :: HeightMap -> [Taxels] -> Scene
texturedScene relief errors =
  Scene relief (map snd placed) frames (stitch standardRegistration frames)
  where
    placed = zip scenePoses errors
    frames = pressed idealSensor relief placed

-- | Endless random errors, then changed, of up to two standard deviations, so that any two frames
-- are within the search's reach of each other.
errorsOf :: (Taxels -> Taxels) -> Int -> [Taxels]
errorsOf changed = filter near . map changed . unfoldr (Just . drawn) . mkStdGen
  where
    near (x, y) = x * x + y * y <= 4
    drawn g =
      let (x, g') = uniform g
          (y, g'') = uniform g'
       in ((4 * x - 2, 4 * y - 2), g'')

-- | Noisy frames of a face of symbols, with position errors of one taxel.
symbolScenes :: [Scene]
symbolScenes =
  [ Scene face [] frames (together frames)
    | seed <- seeds,
      let frames = fst (scan standardSensor face stay (region 32 40) (mkStdGen seed))
  ]

-- | Frames pressed at the nominal poses displaced by the given errors, in taxels, without other
-- noise.
pressed :: Sensor -> HeightMap -> [(SensorPose, Taxels)] -> [Frame]
pressed sensor relief placed =
  [ Frame
      pose
      10
      ( fst
          ( press
              sensor
              relief
              pose {poseX = poseX pose + taxelPitch * ex, poseY = poseY pose + taxelPitch * ey}
              (mkStdGen seed)
          )
      )
      taxelPitch
      []
    | (seed, (pose, (ex, ey))) <- zip [1 ..] placed
  ]

-- | The poses of a region of this width and height, taxels, from 10 taxels right and down of the
-- face's corner.
region :: Int -> Int -> [SensorPose]
region w h = either (const []) id (planScan 8 (10 * taxelPitch, 10 * taxelPitch) (w, h))

-- | The places less their mean.
centred :: [Taxels] -> [Taxels]
centred ps = [(x - sum (map fst ps) / n, y - sum (map snd ps) / n) | (x, y) <- ps]
  where
    n = genericLength ps

-- | The root mean square distance of two lists of places, along one axis, after a common shift.
residual :: [Taxels] -> [Taxels] -> Double
residual ps qs =
  sqrt
    ( sum [x * x + y * y | (x, y) <- centred (zipWith (\(a, b) (c, d) -> (a - c, b - d)) ps qs)]
        / (2 * genericLength ps)
    )

single :: Spec
single =
  it "is returned unchanged, touched once everywhere, where it was pressed" $
    forAll
      ((,,) <$> genRasterOf 16 16 <*> choose (-99, 99) <*> choose (-99, 99))
      $ \(image, x, y) ->
        let edge = 7.5 * taxelPitch
         in conjoin
              [ either
                  (\e -> counterexample (show e) False)
                  (check image (x - edge, y - edge))
                  (assemble [Frame (SensorPose x y 0) 1 image taxelPitch []])
                | assemble <- [placeOnly, stitch standardRegistration]
              ]
  where
    check image (left, top) c =
      conjoin
        [ compositeImage c === image,
          compositeCoverage c === constant 16 16 1,
          compositeOrigin c === (left, top),
          compositePosition c (2, 3) === (left + 2 * taxelPitch, top + 3 * taxelPitch),
          compositeDisplacements c === [(0, 0)]
        ]

truth :: SpecWith Textured
truth = do
  it "without noise, whole displacements are recovered to an eighth, up to a common shift" $
    \scenes -> once (conjoin (map (recovered 0.125) (wholly scenes)))
  it "without noise, fractional displacements are recovered to a third of a taxel" $
    \scenes ->
      once . conjoin $
        [ either
            (\e -> counterexample (show e) False)
            (\c -> property (residual (sceneErrors scene) (compositeDisplacements c) < 1 / 3))
            (sceneStitched scene)
          | scene <- partly scenes
        ]
  it "frames without errors give back the relief they touched" $
    \scenes ->
      once . conjoin $
        [ closeTo
            ( mapRaster (/ sensorFullScale idealSensor)
                <$> crop (10, 10) sceneSize (heightValues (sceneRelief scene))
            )
            (compositeImage <$> made)
          | scene <- exactly scenes,
            made <- [sceneStitched scene, placeOnly (sceneFrames scene)]
        ]
  it "a face seen from a robot that is turned by 180 degrees gives the half-turned composite" $
    \scenes ->
      once . conjoin $
        [ both (sceneStitched scene) (stitch standardRegistration frames) $ \c d ->
            closeImages (compositeImage c) (onRaster (turned 2) (compositeImage d))
          | scene <- exactly scenes,
            let (w, h) = aroundScene,
            let motion = Motion 180 (taxelPitch * fromIntegral w) (taxelPitch * fromIntegral h),
            let frames = fst (scan idealSensor (sceneRelief scene) motion scenePoses (mkStdGen 1))
        ]
  it "placeOnly covers each pixel as often as frames lie on it, and moves none" $ \_ -> do
    let c =
          placeOnly (pressed idealSensor (texture 1 60 60) [(pose, (0, 0)) | pose <- region 32 16])
    fmap
      (take 1 . toRows . mapRaster (fromIntegral . (round :: Double -> Int)) . compositeCoverage)
      c
      `shouldBe` Right [replicate 8 1 ++ replicate 16 2 ++ replicate 8 1]
    fmap compositeDisplacements c `shouldBe` Right (replicate 3 (0, 0))
  it "frames count as compared if some overlap and if they may be moved" $ \_ -> do
    let frames places = pressed idealSensor (texture 1 60 60) [(pose, (0, 0)) | pose <- places]
        three = region 32 16
        compared assemble = fmap ((== 0) . compositeUnregisteredError) . assemble . frames
        by way = fmap assemblyComposite . Stitch.assemble way standardRegistration
        apart = [pose | (i, pose) <- zip [0 :: Int ..] three, even i]
    -- Without an error all stay in place, and have been compared all the same.
    fmap compositeDisplacements (stitch standardRegistration (frames three))
      `shouldBe` Right (replicate 3 (0, 0))
    map (compared placeOnly) [three, take 1 three] `shouldBe` [Right False, Right True]
    -- By the lattice frames are levelled before they are compared.
    forM_ (byEffort id ([Automatic, ByPairs] ++) [Incremental, ByLattice]) $ \way ->
      map (compared (by way)) [three, take 1 three, apart]
        `shouldBe` [Right True, Right True, Right False]
  where
    recovered most scene = case sceneStitched scene of
      Left e -> counterexample (show e) False
      Right c ->
        let pairs = zip (centred (sceneErrors scene)) (centred (compositeDisplacements c))
         in counterexample (show pairs) $
              and [abs (x - x') < most && abs (y - y') < most | ((x, y), (x', y')) <- pairs]
    closeTo (Right a) (Right b) =
      counterexample
        (show (a, b))
        ( either
            (const False)
            (maybe True (< 1e-9) . maximumValue)
            (zipRaster (\p q -> abs (p - q)) a b)
        )
    closeTo _ _ = property False

-- | Frames registered with the noise that they show.
together :: [Frame] -> Either StitchError Composite
together frames = stitch (withNoiseOf frames standardRegistration) frames

-- | A gain and an offset.
genScale :: Gen (Double, Double)
genScale = (,) <$> choose (0.05, 2) <*> choose (-1, 1)

onScale :: (Double, Double) -> Frame -> Frame
onScale (gain, offset) f = f {frameImage = mapRaster (\v -> gain * v + offset) (frameImage f)}

-- | The reading of a pixel after this gain and offset, which is 0 where nothing touched.
scaledWhere :: (Double, Double) -> Double -> Double -> Double
scaledWhere (gain, offset) coverage v = if coverage < 0.001 then 0 else gain * v + offset

-- | The correlation of two images of one size.
alike :: Raster -> Raster -> Double
alike a b = covariance xs ys / sqrt (covariance xs xs * covariance ys ys)
  where
    (xs, ys) = (concat (toRows a), concat (toRows b))
    middle vs = sum vs / fromIntegral (length vs)
    about vs = map (subtract (middle vs)) vs
    covariance us vs = middle (zipWith (*) (about us) (about vs))

face :: HeightMap
face = faceOf [[0, 1, 2, 3], [3, 2, 0, 1], [1, 0, 3, 2]]

seenOtherwise :: SpecWith [Scene]
seenOtherwise = withCases 1 10 $ do
  it "a shift of all poses shifts the composite and changes nothing else" $ \scenes ->
    forAllBlind (elements scenes) $ \scene ->
      forAll ((,) <$> choose (-500, 500) <*> choose (-500, 500)) $ \(a, b) ->
        let shifted = [f {framePose = moved (framePose f)} | f <- sceneFrames scene]
            moved pose = pose {poseX = poseX pose + a, poseY = poseY pose + b}
         in both (sceneStitched scene) (together shifted) $ \c d ->
              closeImages (compositeImage c) (compositeImage d)
                .&&. near (fst (compositeOrigin c) + a) (fst (compositeOrigin d))
                .&&. near (snd (compositeOrigin c) + b) (snd (compositeOrigin d))
  it "neither the order of the frames matters, nor their repetition" $ \scenes ->
    forAllBlind (elements scenes) $ \scene ->
      let frames = zip [0 :: Int ..] (sceneFrames scene)
       in forAllBlind (sublistOf frames >>= shuffle . (++ frames) . concat . replicate 3) $
            \shuffled -> both (sceneStitched scene) (together (map snd shuffled)) $ \c d ->
              let told e = (compositeImage e, compositeCoverage e, compositeContradiction e)
                  others e =
                    [ (alternativeCause o, alternativeRatio o, alternativeLattice o)
                      | o <- compositeAlternatives e
                    ]
               in (told c, others c) === (told d, others d)
                    .&&. compositeDisplacements d
                    === [compositeDisplacements c !! key | (key, _) <- shuffled]
  it "a gain and an offset of all grey values change nothing else" $ \scenes ->
    forAllBlind (elements scenes) $ \scene -> forAll genScale $ \(gain, offset) ->
      both (sceneStitched scene) (together (map (onScale (gain, offset)) (sceneFrames scene))) $
        \c d ->
          either
            (property . const False)
            (`closeImages` compositeImage d)
            (zipRaster (scaledWhere (gain, offset)) (compositeCoverage c) (compositeImage c))
            .&&. compositeDisplacements d === compositeDisplacements c
            .&&. compositeContradiction d === compositeContradiction c
  it "a gain and an offset of each frame change nothing but what depends on them" $ \scenes ->
    forAllBlind (elements scenes) $ \scene -> forAll (vectorOf 12 genScale) $ \scales ->
      both (sceneStitched scene) (together (zipWith onScale scales (sceneFrames scene))) $ \c d ->
        let rho = alike (compositeImage c) (compositeImage d)
         in counterexample (show rho) (rho > 0.9)
              .&&. compositeDisplacements d === compositeDisplacements c
  it "a sensor turned in the robot's hand gives the same composite" $ \scenes ->
    forAllBlind (elements scenes) $ \scene ->
      forAll (vectorOf 12 (elements [0 :: Int .. 3])) $ \turns ->
        let -- A sensor turned clockwise by some quarters sees the image turned back by as many.
            fitsAt k f =
              f
                { framePose = (framePose f) {poseRotation = 90 * fromIntegral k},
                  frameImage = onRaster (turned (negate k)) (frameImage f)
                }
         in both (sceneStitched scene) (together (zipWith fitsAt turns (sceneFrames scene))) $
              \c d -> closeImages (compositeImage c) (compositeImage d)
  where
    near a b = counterexample (show (a, b)) (abs (a - b) < 1e-6)

-- | A relation between two composites, if both were made.
both ::
  Either StitchError Composite ->
  Either StitchError Composite ->
  (Composite -> Composite -> Property) ->
  Property
both (Right c) (Right d) f = f c d
both a b _ =
  counterexample (show (either Just (const Nothing) a, either Just (const Nothing) b)) False

closeImages :: Raster -> Raster -> Property
closeImages a b =
  counterexample (show (rasterWidth a, rasterHeight a, rasterWidth b, rasterHeight b)) $
    either
      (const False)
      (maybe True (< 1e-6) . maximumValue)
      (zipRaster (\p q -> abs (p - q)) a b)

unseen :: Spec
unseen = do
  it "blank frames stay in place" $
    fmap
      compositeDisplacements
      ( stitch
          standardRegistration
          [Frame pose 10 (constant 16 16 0) taxelPitch [] | pose <- region 32 40]
      )
      `shouldBe` Right (replicate 12 (0, 0))
  it "frames of noise alone are moved by less than the position errors" $
    conjoin
      [ case compositeDisplacements
          <$> stitch
            standardRegistration
            (pressed standardSensor blank [(pose, (0, 0)) | pose <- scenePoses]) of
          Right ds -> counterexample (show ds) (residual ds (repeat (0, 0)) < 0.5)
          Left e -> counterexample (show e) False
        | blank <-
            byEffort id (heightMap 1 (constant 0 0 0) :) [heightMap taxelPitch (constant 60 60 0.8)]
      ]
  it "frames that do not overlap stay in place" $
    fmap
      compositeDisplacements
      ( stitch
          standardRegistration
          ( pressed
              idealSensor
              (texture 1 99 99)
              [(SensorPose 20 20 0, (0, 0)), (SensorPose 120 20 0, (1, 1))]
          )
      )
      `shouldBe` Right [(0, 0), (0, 0)]

noisy :: Spec
noisy =
  it "with noise and errors, frames are placed to half a taxel, and to half of their errors" $
    conjoin
      [ let errors = take 12 (draw (mkStdGen seed))
            frames = pressed standardSensor face (zip (region 32 40) errors)
         in case (stitch standardRegistration frames, placeOnly frames) of
              (Right c, Right d) ->
                let afterwards = residual errors (compositeDisplacements c)
                    beforehand = residual errors (compositeDisplacements d)
                 in counterexample
                      (show (beforehand, afterwards))
                      (afterwards < 0.5 && afterwards < beforehand / 2)
              _ -> property False
        | seed <- [1 .. byEffort 4 20]
      ]
  where
    draw g = let (e, g') = normalPair g in e : draw g'

-- | The distance between a smooth scene and the composite of one frame of it, by a sensor turned by
-- this angle.
turnedOff :: Double -> Double
turnedOff degrees = case placeOnly [Frame (SensorPose 0 0 degrees) 1 image taxelPitch []] of
  Left _ -> 1
  Right composite ->
    let seen = compositeImage composite
        (ox, oy) = compositeOrigin composite
     in maximum
          [ abs (v - scene (ox / taxelPitch + fromIntegral x) (oy / taxelPitch + fromIntegral y))
            | (y, row) <- zip [0 :: Int ..] (toRows seen),
              (x, v) <- zip [0 :: Int ..] row,
              maybe False (> 0.99) (index (compositeCoverage composite) x y)
          ]
  where
    scene x y = 0.5 + 0.2 * sin (x / 4) + 0.2 * cos (y / 5)
    radians = degrees * pi / 180
    image = generate 16 16 $ \i j ->
      let (u, v) = (fromIntegral i - 7.5, fromIntegral j - 7.5)
       in scene (cos radians * u - sin radians * v) (sin radians * u + cos radians * v)

refusals :: Spec
refusals = do
  it "no frames are refused" $ [stitched [], placeOnly []] `shouldBe` [Left NoFrames, Left NoFrames]
  it "a frame of another size than the first is refused, and named" $
    stitched [good, good {frameImage = constant 16 15 0}] `shouldBe` Left (FrameSize 1 16 15)
  it "a frame of any rotation is taken, and turned back" $
    [ (degrees, off)
      | degrees <- [0.5, 30, 45, 100, 200, 359],
        let off = turnedOff degrees,
        off > 0.01
    ]
      `shouldBe` []
  it "a value that is not finite is refused with its frame" $ do
    let found =
          [ stitched [good, f]
            | f <-
                [ at (0 / 0) 0 0,
                  at 0 (1 / 0) 0,
                  at 0 0 (0 / 0),
                  good {frameImage = generate 16 16 (\x y -> if x + y == 0 then 0 / 0 else 0)}
                ]
          ]
    found `shouldBe` replicate 4 (Left (FrameNotFinite 1))
  it "an area too large to hold is refused" $ do
    stitched [good, at 1e9 1e9 0] `shouldSatisfy` tooLarge
    stitched [at 1e308 0 0, at (-1e308) 0 0] `shouldSatisfy` tooLarge
    -- 16 rows, of 2^18 pixels at most.
    let apart taxels = placeOnly [good, at (taxels * taxelPitch) 0 0]
    apart 262128 `shouldSatisfy` isRight
    apart 262129 `shouldSatisfy` tooLarge
  it "too many frames are refused" $
    forM_ [(10000, Nothing), (10001, Just (TooManyFrames 10001))] $ \(count, refused) ->
      (count, either Just (const Nothing) (placeOnly (replicate count good)))
        `shouldBe` (count, refused)
  it "too many pixels are refused, at the canonical pitch or the frames' own, unresampled" $ do
    let large pitch = Frame (SensorPose 0 0 0) 1 (constant 256 256 0.5) pitch []
        refusal pitch count =
          either Just (const Nothing) (placeOnly (replicate count (large pitch)))
    -- Taxels of 50 mm make 8062 x 8062 pixels of a frame.
    refusal 50 1 `shouldBe` Just (TooManyFramePixels 64995844)
    refusal 0.05 129 `shouldBe` Just (TooManyFramePixels (129 * 65536))
    refusal 0.05 128 `shouldBe` Nothing
  it "settings that make no sense are refused" $
    [ settings
      | settings <-
          [ standardRegistration {registrationSigma = Just 0},
            standardRegistration {registrationSigma = Just (0 / 0)},
            standardRegistration {registrationNoise = -1},
            standardRegistration {registrationReach = 1e9},
            standardRegistration {registrationReach = 0 / 0}
          ],
        not (isLeft (stitch settings [good]))
    ]
      `shouldBe` []
  where
    stitched = stitch standardRegistration
    good = at 0 0 0
    at x y r = Frame (SensorPose x y r) 1 (constant 16 16 0.5) taxelPitch []
    tooLarge (Left (AreaTooLarge _ _)) = True
    tooLarge _ = False

-- | Two crops, 16 x 16, of real pressure frames, at a known displacement from their poses.
real :: Spec
real = do
  it "crops of one F-Scan frame are registered to a quarter of a taxel" $
    withFrames
      [ "fscan_004",
        "fscan_008",
        "fscan_040",
        "fscan_044",
        "fscan_077",
        "fscan_111",
        "fscan_147",
        "fscan_184"
      ]
      $ \image ->
        [ (displacement, registered image image offset nominal)
          | (offset@(x, y), displacement@(dx, dy)) <-
              some [((0, 20), (0, 0)), ((3, 24), (1, -1)), ((0, 20), (-2, 2)), ((3, 24), (2, 1))],
            let nominal = (x + 2 - dx, y + 8 - dy)
        ]
  it "crops of one I-Scan frame, enlarged threefold, are registered to a quarter of a taxel" $
    withFrames ["iscan_033", "iscan_036", "iscan_039", "iscan_042"] $ \small ->
      let image =
            generate
              33
              33
              (\x y -> sample small ((fromIntegral x - 1) / 3) ((fromIntegral y - 1) / 3))
       in [ (displacement, registered image image offset nominal)
            | (offset@(x, y), displacement@(dx, dy)) <-
                some [((4, 6), (0, 0)), ((8, 8), (1, -1)), ((4, 6), (-2, 2)), ((8, 8), (2, 1))],
              let nominal = (x + 6 - dx, y + 5 - dy)
          ]
  where
    -- One place each, displaced to either side.
    some = byEffort (take 2 . drop 1) id
    -- The second crop lies two right and eight down (six and five) of the first, unlike its pose.
    registered first second (x, y) (nx, ny) = do
      a <- either (Left . show) Right (crop (x, y) (16, 16) first)
      b <-
        either (Left . show) Right (crop (x + trueStepX first, y + trueStepY first) (16, 16) second)
      c <-
        either
          (Left . show)
          Right
          ( stitch
              standardRegistration {registrationNoise = 0.01}
              [frameAt (x, y) a, frameAt (nx, ny) b]
          )
      case compositeDisplacements c of
        [(ax, ay), (bx, by)] -> Right (bx - ax, by - ay)
        other -> Left (show other)
    trueStepX image = if rasterWidth image == 33 then 6 else 2
    trueStepY image = if rasterWidth image == 33 then 5 else 8
    frameAt (x, y) image = Frame (SensorPose (along x) (along y) 0) 1 image taxelPitch []
    along k = taxelPitch * fromIntegral (k :: Int)
    withFrames names cases = do
      images <- traverse load (byEffort (take 1) id names)
      let results =
            [ (name, wanted, found)
              | (name, image) <- zip names images,
                (wanted, found) <- cases image
            ]
          off (_, (dx, dy), Right (x, y)) =
            abs (x - fromIntegral dx) > 0.25 || abs (y - fromIntegral dy) > 0.25
          off _ = True
      filter off results `shouldBe` ([] :: [(String, (Int, Int), Either String Taxels)])
    load name = do
      image <-
        B.readFile (folder ++ name ++ ".pgm")
          >>= either (fail . show) (pure . pgmIntensity) . decodePgm
      -- Scaled to full scale: a step of a walk uses a part of the sensor's range.
      pure (mapRaster (/ max 1e-9 (fromMaybe 1 (maximumValue image))) image)
    folder = "test/data/real-frames/"
