-- | Tests explorations and their results: regions, presses, trials and their counts, each against
-- its definition.
module Test.Recognition.ExplorationsAndTrials (spec) where

import Data.Foldable (for_)
import Data.List (genericLength, nub, unfoldr)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust)
import qualified Data.Vector.Storable as V
import PraTactile.Array
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Image
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge (FaceName (..), ObjectName (..), VertexName (..))
import PraTactile.Random (uniform)
import PraTactile.Recognise
import PraTactile.Registration (Composite, StitchError, placeOnly, standardRegistration)
import PraTactile.Relief
import PraTactile.Sensor
import PraTactile.Sensor.Frame
import PraTactile.Symmetry
import System.Random (StdGen, mkStdGen, split)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Recognition.Setting
import Test.Support (below)
import Test.Touch.Paper (stitch)

spec :: Spec
spec = do
  describe "Regions" regionSpec
  describe "Presses" pressSpec
  describe "Trials" trialSpec
  describe "Results" $ do
    countSpec
    onPaper $ \setting -> resultSpec (recogniserOf setting) (facesFelt setting)

-- | A face of this many taxels, with a grid of this many rows and columns.
faceOf :: (Int, Int) -> Shape -> LaidFace
faceOf (wide, high) grid =
  LaidFace
    { laidFace = Face (ObjectName "thing") (FaceName []),
      laidAt = Position 0 0,
      laidAnchor = Centred,
      laidBlock = wholeBlock grid,
      laidCorners =
        zip
          (map VertexName ["1", "2", "3", "4"])
          [ spotAt x y
            | (x, y) <- [(0, 0), (0, taxels high), (taxels wide, taxels high), (taxels wide, 0)]
          ],
      laidBox = spotAt 0 0,
      laidExtent = spotAt (taxels wide) (taxels high),
      laidMargin = spotAt 0 0
    }
  where
    taxels n = fromIntegral n * 127 / 80

-- | This many draws, and the generator after them.
draws :: Int -> StdGen -> ([Double], StdGen)
draws n g = (take n (unfoldr (Just . uniform) g), iterate (snd . uniform) g !! n)

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 * (1 + abs b))

genTurns :: Gen Turns
genTurns =
  oneof
    [ AmongTurns <$> elements [[], [turned 3], halfTurns, rotations, [turned 1, turned 2, mirror]],
      TurnedBy <$> oneof [elements [0, 90, -90, 360], choose (-400, 400)],
      pure AnyAngle
    ]

regionSpec :: Spec
regionSpec = do
  it
    "a region's bounding box is uniform on the face or centred; a longer region is uniform"
    $ forAll genTurns $ \turns ->
      forAll ((,) <$> choose (1, 60) <*> choose (1, 60)) $ \(width, height) ->
        forAll ((,) <$> choose (30, 90) <*> choose (30, 90)) $ \(wide, high) ->
          forAll (choose (1, 1000000)) $ \seed ->
            let (region, rest) =
                  drawnRegion
                    turns
                    (width, height)
                    (faceOf (wide, high) (Shape 1 1))
                    (mkStdGen seed)
                three = draws 3 (mkStdGen seed)
                ((u, v, w, z), end) = case (turns, draws 4 (mkStdGen seed)) of
                  (AnyAngle, ([a, b, c, d], g)) -> ((a, b, c, d), g)
                  (_, ([a, b, c, _], _)) -> ((a, b, c, 0), snd three)
                  (_, (_, g)) -> ((0, 0, 0, 0), g)
                (symmetry, angle) = case turns of
                  AmongTurns [] -> (identity, 0)
                  AmongTurns ways -> (ways !! floor (w * genericLength ways), 0)
                  TurnedBy degrees -> nearestQuarter degrees
                  AnyAngle -> nearestQuarter (360 * z)
                (across, down)
                  | exchangesAxes symmetry = (height, width)
                  | otherwise = (width, height)
                -- The place of the region's middle, as its distance from the face's edge.
                middle share face along other
                  | along > face = fromIntegral along / 2 + share * fromIntegral (face - along)
                  | rectangle >= fromIntegral face = fromIntegral face / 2
                  | otherwise = rectangle / 2 + share * (fromIntegral face - rectangle)
                  where
                    rectangle =
                      cos (angle * pi / 180) * fromIntegral along
                        + abs (sin (angle * pi / 180)) * fromIntegral other
                fits = across <= wide && down <= high
             in label (if fits then "on the face" else "over its edge") $
                  conjoin
                    [ near
                        (regionRight region + fromIntegral across / 2)
                        (middle u wide across down),
                      near
                        (regionDown region + fromIntegral down / 2)
                        (middle v high down across),
                      (regionWidth region, regionHeight region) === (width, height),
                      (regionSymmetry region, regionAngle region) === (symmetry, angle),
                      regionExtent region === (across, down),
                      fst (draws 2 rest) === fst (draws 2 end)
                    ]
  it "a region's corner is its taxels in millimetres, and its turn from 0 up to 360 degrees" $
    forAll ((,) <$> choose (0, 50) <*> choose (0, 50)) $ \(right', down) ->
      forAll (choose (0, 3)) $ \quarters ->
        forAll (elements [-45, -30, -0.5, 0, 12, 45]) $ \angle ->
          let region = ProbedRegion right' down 9 7 (turned quarters) angle
              whole = 90 * fromIntegral quarters + angle
           in near (fst (regionCorner region)) (1.5875 * right')
                .&&. near (snd (regionCorner region)) (1.5875 * down)
                .&&. regionTurn region === (if whole < 0 then 360 + whole else whole)
  it "each rotation is drawn equally often, within five standard errors" $ do
    let way seed =
          regionSymmetry . fst $
            drawnRegion
              (AmongTurns [identity, turned 1, turned 2])
              (9, 9)
              (faceOf (30, 30) (Shape 1 1))
              (mkStdGen seed)
        counts = Map.fromListWith (+) [(quarterTurns (way seed), 1 :: Double) | seed <- [1 .. 900]]
    Map.keys counts `shouldBe` [0, 1, 2]
    maximum [abs (n - 300) | n <- Map.elems counts] `shouldSatisfy` (< 5 * sqrt 200)

pressSpec :: Spec
pressSpec = do
  it "neighbouring presses are half of the sensor's shorter side apart, and at least a taxel" $
    forAll ((,) <$> choose (1, 40) <*> choose (1, 40)) $ \(wide, high) ->
      defaultSpacing idealSensor {sensorColumns = wide, sensorRows = high}
        === (if min wide high < 2 then 1 else min wide high `div` 2)
  withCases 2 15
    . it "a region's frames are the plan's, with what is felt at these places of the region"
    $ forAll ((,,) <$> elements [16, 12] <*> elements [8, 10, 16] <*> choose (1, 9)) $
      \(wide, high, spacing) -> forAll ((,) <$> choose (16, 24) <*> choose (16, 24)) $ \size ->
        forAll ((,) <$> elements rotations <*> elements [0, 0, 20]) $ \(symmetry, angle) ->
          let sensor = idealSensor {sensorColumns = wide, sensorRows = high}
              region = ProbedRegion 3.25 5.5 (fst size) (snd size) symmetry angle
              scene =
                heightMap
                  taxelPitch
                  (generate 40 40 (\x y -> fromIntegral ((x * 7 + y * 5) `mod` 11) / 8))
              explored =
                fst
                  <$> exploreWith sensor spacing (flawless sensor) scene region (mkStdGen 1)
              usual = fst <$> explore sensor scene region (mkStdGen 1)
              frames distance =
                map frame <$> planScanOf (sensorTaxelGrid sensor) distance (0, 0) size
              frame pose =
                Frame
                  pose
                  (sensorForce sensor)
                  (forwardImage sensor scene (move (regionMotion region) pose))
                  (sensorTaxel sensor)
                  []
           in explored === frames spacing .&&. usual === frames (min wide high `div` 2)
  it "a specimen is drawn before it explores" $ do
    let sensor = standardSensor {sensorGainSpread = 0.2, sensorDead = 0.1}
        scene = heightMap taxelPitch (constant 60 60 1)
        region = ProbedRegion 3 5 20 24 identity 0
        (specimen, rest) = drawSpecimen sensor (mkStdGen 5)
    fmap fst (explore sensor scene region (mkStdGen 5))
      `shouldBe` fmap fst (exploreWith sensor 8 specimen scene region rest)

trialSpec :: Spec
trialSpec = do
  withCases 2 6
    . it "each trial takes the next face, with its own generator, split from the seed"
    $ forAll ((,) <$> choose (1, 3) <*> choose (1, 99999)) $ \(count, seed) ->
      forAll (elements [AnyAngle, AmongTurns rotations, TurnedBy 30]) $ \turns ->
        let faces = [(faceOf (64 + k, 70) (Shape 2 3), scene) | k <- take count [0 ..]]
            how = exploration idealSensor turns (30, 24)
            generators = unfoldr (Just . split) (mkStdGen seed)
            told t = (trialFace t, trialRegion t, trialForeign t, map framePose (trialFrames t))
         in map (fmap told) (take 5 (trials how faces seed))
              === take 5 (zipWith (\face -> fmap told . trial how face) (cycle faces) generators)
  it "a trial is the drawn region, and its frames are the presses of that region" $
    forAll ((,) <$> choose (1, 99999) <*> elements [Nothing, Just (Bend 30 AboutX)]) $
      \(seed, bend) ->
        let how =
              (exploration noisy (AmongTurns rotations) (20, 18))
                { explorationSpacing = 5,
                  explorationBend = bend
                }
            face = faceOf (40, 44) (Shape 2 2)
            wanted = do
              let (region, g) = drawnRegion (AmongTurns rotations) (20, 18) face (mkStdGen seed)
              let (specimen, g') = drawSpecimen noisy g
              let surface = reliefHeights scene {reliefBend = bend}
                  explored = exploreWith noisy 5 specimen surface region g'
              (frames, _) <- either (const Nothing) Just explored
              pure (face, region, frames, False)
            told t = (trialFace t, trialRegion t, trialFrames t, trialForeign t)
         in isJust wanted .&&. fmap told (trial how (face, scene) (mkStdGen seed)) === wanted
  it "the share of foreign presses is the stated one, within five standard errors" $
    for_ [(0, 0), (0.3, 5 * sqrt (600 * 0.21)), (1, 0)] $ \(share, most) -> do
      let found = concatMap (trialOn (chances share (const True))) [1 .. 600]
      length found `shouldBe` 600
      abs (genericLength (filter id found) - 600 * share) `shouldSatisfy` (<= most)
  it "foreign symbols fill the face's grid, with each class equally likely in each cell" $ do
    let those predicate = concatMap (trialOn (chances 1 predicate)) [1 .. 600]
        often predicate = genericLength (those predicate) / 600 :: Double
    length (those (all (all (`elem` [0 .. 2])))) `shouldBe` 600
    for_ [0 .. 2] $ \c ->
      for_ [(0, 0), (1, 2), (2, 3)] $ \(i, j) ->
        often (\symbols -> symbols !! i !! j == c) `shouldSatisfy` nearly (1 / 3)
    -- Neighbours are equal as often as chance has it, along rows and from row to row.
    often (\symbols -> symbols !! 0 !! 0 == symbols !! 0 !! 1) `shouldSatisfy` nearly (1 / 3)
    often (\symbols -> symbols !! 0 !! 3 == symbols !! 1 !! 0) `shouldSatisfy` nearly (1 / 3)
  it "the share of presses on other arrays is the stated one, equal for each array" $ do
    let drawn laid =
          trialOn (chances 0.2 laid) {foreignArrays = 0.5, foreignFaces = map face [0 .. 3]}
        face c = const (const c)
        often laid = genericLength (filter id (concatMap (drawn laid) [1 .. 600])) / 600 :: Double
    often (const True) `shouldSatisfy` nearly 0.7
    -- Twelve cells by chance are all equal once in many thousand times.
    for_ [0 .. 3] $ \c -> often (all (all (== c))) `shouldSatisfy` nearly 0.125
  it "a foreign surface is pressed in place of the face; without a relief there is no trial" $ do
    let pressed drawn =
          trial
            (exploration idealSensor (AmongTurns [identity]) (16, 16))
              { explorationForeign = Just (chances 1 (const True)) {foreignRelief = \_ _ -> drawn}
              }
            (faceOf (40, 44) (Shape 2 2), scene)
            (mkStdGen 1)
        plateau = onMap (heightMap taxelPitch (constant 40 44 (sensorFullScale idealSensor / 2)))
    fmap (map (flatAt 0.5 . frameImage) . trialFrames) (pressed (Just plateau))
      `shouldBe` Just [True]
    isJust (pressed Nothing) `shouldBe` False
  where
    noisy = standardSensor {sensorGainSpread = 0.2}
    flatAt level image = V.all (\v -> abs (v - level) < 1e-9) (rasterValues image)
    scene = onMap (heightMap taxelPitch (constant 60 60 1))
    onMap heights =
      Relief
        { reliefOrigin = (0, 0),
          reliefSize = rasterSize (heightValues heights),
          reliefFineness = 1,
          reliefDrawn = \(x, y) (w, h) ->
            generate w h $ \i j ->
              fromMaybe (0 / 0) (index (heightValues heights) (x + i) (y + j)),
          reliefBend = heightBend heights
        }
    -- A share of 600, within five standard errors.
    nearly share found = abs (found - share) < 5 * sqrt (share * (1 - share) / 600 :: Double)
    -- Arrangements by chance in this share of presses. Those that fail the predicate cannot be
    -- pressed.
    chances share predicate =
      Foreign
        { foreignShare = share,
          foreignClasses = 3,
          foreignRelief = \face classAt ->
            let Shape high wide = laidGrid face
                symbols = [[classAt (Position i j) | j <- below wide] | i <- below high]
             in if predicate symbols then Just scene else Nothing,
          foreignArrays = 0,
          foreignFaces = []
        }
    -- Whether a trial is foreign; empty if the foreign surface cannot be pressed.
    trialOn others seed =
      [ trialForeign t
        | Just t <-
            [ trial
                (exploration idealSensor (AmongTurns [identity]) (16, 16))
                  { explorationForeign = Just others
                  }
                (faceOf (64, 60) (Shape 3 4), scene)
                (mkStdGen seed)
            ]
      ]

countSpec :: Spec
countSpec =
  it "results are counted: right, wrong, refused by name, and the doubts of all answers" $
    forAll (listOf genResult) $ \results ->
      let counted = tally results
          names = nub [name | NoAnswer name <- results]
       in conjoin
            [ tallyRight counted === length [() | Correct _ <- results],
              tallyWrong counted === length [() | Mistaken _ <- results],
              near
                (tallyExpected counted)
                (sum [d | Correct d <- results] + sum [d | Mistaken d <- results]),
              tallyRefused counted
                === Map.fromList [(n, length (filter (== NoAnswer n) results)) | n <- names],
              noResults === tally [],
              foldl counting noResults results === counted
            ]
  where
    genResult =
      oneof
        [ Correct <$> choose (0, 0.01),
          Mistaken <$> choose (0, 0.01),
          NoAnswer <$> elements ["a", "b", "c"]
        ]

resultSpec :: KnownField k => Recogniser k -> [(LaidFace, Relief)] -> Spec
resultSpec reader faces = do
  withCases 1 2
    . it "an answer is right exactly if its face, orientation and place are the true ones"
    $ forAllShow (elements faces) (show . laidFace . fst) $ \face ->
      forAll (choose (1, 99999 :: Int)) $ \seed ->
        case trial (exploration feeling (AmongTurns rotations) (40, 52)) face (mkStdGen seed) of
          Nothing -> property False
          Just t ->
            let moved (dx, dy) =
                  let r = trialRegion t
                      (x, y) = (regionRight r + dx, regionDown r + dy)
                   in t {trialRegion = r {regionRight = x, regionDown = y}}
                (w, h) = regionExtent (trialRegion t)
                about = turned 2 <> regionSymmetry (trialRegion t)
                -- The same place on the face, seen the other way up.
                other = fst (head' (filter ((/= trialFace t) . fst) faces))
                answers = map asked wrong
                asked = runTrial standardTolerance reader standardRegistration
                wrong =
                  [ t {trialForeign = True},
                    t {trialFace = other},
                    t {trialRegion = (trialRegion t) {regionSymmetry = about}}
                  ]
                    ++ map moved [(sign * 9, 0), (0, sign * 11)]
                stillRight = map moved [(sign * 7, 0), (0, sign * 9)]
                sign = if even seed then 1 else -1
                stitched = doubtIn (stitch standardRegistration (trialFrames t))
                placed = doubtIn (placeOnly (trialFrames t))
                both a b = TrialResult <$> a <*> b
             in counterexample (show (trialRegion t, w, h)) $
                  conjoin
                    [ Just (asked t)
                        === both (Correct <$> stitched) (Correct <$> placed),
                      map Just answers
                        === map (const (both (Mistaken <$> stitched) (Mistaken <$> placed))) wrong,
                      [ Just (withStitching (asked t'))
                        | t' <- stillRight
                      ]
                        === map (const (Correct <$> stitched)) stillRight
                    ]
  it "a refusal is counted by its name, and a failed registration by a name of its own" $ do
    let asked frames' =
          runTrial
            standardTolerance
            reader
            standardRegistration
            (Trial (fst (head' faces)) (ProbedRegion 0 0 40 52 identity 0) frames' Nothing False)
        flat = Frame (SensorPose 0 0 0) 1 (constant 16 16 0) taxelPitch []
        both name = TrialResult (NoAnswer name) (NoAnswer name)
    asked [] `shouldBe` both "not-stitched"
    asked [flat] `shouldBe` both "no-symbols"
  where
    -- A quick run registers two large frames, and not many small ones.
    feeling = byEffort idealSensor {sensorColumns = 40, sensorRows = 40} idealSensor
    head' = foldr const (faceOf (1, 1) (Shape 1 1), nothing)
    nothing = Relief (0, 0) (0, 0) 1 (\_ (w, h) -> constant w h 0) Nothing
    doubtIn :: Either StitchError Composite -> Maybe Double
    doubtIn together = do
      composite <- either (const Nothing) Just together
      recognition <-
        either (const Nothing) Just (recogniseWith standardTolerance reader [composite])
      supportDoubt <$> recognisedSupport recognition
