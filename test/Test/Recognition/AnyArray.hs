{-# LANGUAGE RankNTypes #-}

-- | Tests that any array can be pressed and recognised: as a plate, with relief drawn for a region
-- only, and without comparing all positions.
module Test.Recognition.AnyArray (spec) where

import Data.Foldable (for_)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array hiding (toRows)
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Field (KnownField, toCode)
import PraTactile.Grid (canonicalPosition)
import PraTactile.Image (crop, rasterSize, toRows)
import PraTactile.Locate
  ( AlgebraError (..),
    DecoderName (..),
    LocateError (..),
    LocatorError (..),
    Radius (..),
    decoderOfProbabilities,
  )
import PraTactile.Object.Canonical (canonicalPitch, canonicalPlacement)
import PraTactile.Object.Placement
import PraTactile.Object.Plate
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.GridOutcome
import PraTactile.Recognise.Recogniser
import PraTactile.Relief
import PraTactile.Sensor
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (tolerance)
import Test.Recognition.Scenes
import Test.Recognition.Setting
import Test.Recognition.Symbols
import Test.Support

spec :: Spec
spec = do
  describe "the plate" plateSpec
  describe "relief of a region" reliefSpec
  describe "without a codebook" decoderSpec
  describe "presses on a plate" pressSpec
  describe "regions larger than a face" edgeSpec

plateSpec :: Spec
plateSpec = do
  it "has each window that lies inside, at its place in the array, and no other" $
    forAll ((,) <$> elements [1 .. 9] <*> elements [1 .. 9]) $ \(high, wide) ->
      forAll ((,) <$> elements [1 .. 3] <*> elements [1 .. 3]) $ \(h, w) ->
        whenRight (platePlacement (Shape high wide)) $ \plate ->
          [ [(placeCell on, placeCentre on) | OnFace on <- [found]]
            | at <- shapeCells (Shape high wide),
              let found = whereabouts plate (Shape h w) at
          ]
            === [ [ (at, spotAt (25.4 * (real c + real w / 2)) (31.75 * (real r + real h / 2)))
                    | r + h <= high && c + w <= wide
                  ]
                  | at@(Position r c) <- shapeCells (Shape high wide)
                ]
  it "is one box, 25.4 mm thick and as large as its cells, whose upper face begins far left" $ do
    plate <- right (platePlacement (Shape 15 17))
    let told face =
          ( faceText (faceName (laidFace face)),
            (laidAt face, laidGrid face),
            map spotMillimetres [laidExtent face, laidMargin face]
          )
        upper = [p | body <- placementSolids plate, (_, p) <- take 2 (solidVertices body)]
    map solidName (placementSolids plate) `shouldBe` [plateName]
    map told (laidFaces plate)
      `shouldBe` [("S1 S2 S3 S4", (Position 0 0, Shape 15 17), [(431.8, 476.25), (0, 0)])]
    upper `shouldBe` [Point 0 476.25 25.4, Point 0 0 25.4]
  it "does not exist for an array without cells" $
    for_ [Shape 0 5, Shape 5 0] $ \shape ->
      either Just (const Nothing) (platePlacement shape) `shouldBe` Just (EmptyArray shape)
  where
    real = fromIntegral :: Natural -> Rational

reliefSpec :: Spec
reliefSpec = do
  withCases 7 60 $
    it "gives a region the same frames as the whole face's relief, to the bit" $
      forAll ((,) <$> elements sensors <*> pure Nothing) $
        feltAlike ((,) <$> choose (18, 70) <*> choose (18, 90))
  withCases 5 40 $
    it "gives the same frames on bent faces, with a narrow sensor at any rotation" $
      forAll ((,) soft . Just <$> (Bend (1.001 * leastRadius soft) <$> elements [minBound ..])) $
        feltAlike ((,) <$> choose (18, 40) <*> choose (30, 60))
  it "is drawn as the same rows and columns of the whole" $
    whenRight (platePlacement (Shape 15 17)) $ \plate ->
      onArray canonicalProfile plate paperReader $ \setting ->
        let drawn = [(whole, heightValues (reliefHeights whole)) | (_, whole) <- facesFelt setting]
         in forAllBlind (elements drawn) $ \(whole, heights) ->
              forAll ((,) <$> choose (0, 200) <*> choose (0, 200)) $ \at ->
                forAll ((,) <$> choose (1, 70) <*> choose (1, 90)) $ \size ->
                  fmap toRows (crop at size heights)
                    === Right (toRows (reliefDrawn whole at size))
  it "of a plate of four million cells is drawn only for the region and its surroundings" $
    withLarge $ \setting ->
      forAll (choose (1, 99999)) $ \seed ->
        forAllBlind (elements (facesFelt setting)) $ \(face, whole) ->
          let (region, _) = drawnRegion AnyAngle (80, 80) face (mkStdGen seed)
              (w, h) = rasterSize (heightValues (heightsUnder standardSensor region whole))
           in counterexample (show (w, h)) (w <= 160 && h <= 160)
  where
    feltAlike sizes (sensor, bend) =
      forAll ((,) <$> choose (1, 99999) <*> sizes) $ \(seed, size) ->
        forAll genTurns $ \turns ->
          onAnyFace $ \(face, flat) ->
            let whole = flat {reliefBend = bend}
                (region, g) = drawnRegion turns size face (mkStdGen seed)
                moved = onRelief whole region
                frames heights = fst <$> exploreWith sensor 13 (flawless sensor) heights moved g
             in frames (heightsUnder sensor region whole) === frames (reliefHeights whole)
    genTurns = oneof [AmongTurns . pure <$> elements rotations, TurnedBy <$> choose (0, 360)]
    onAnyFace test =
      whenRight (sequence [canonicalPlacement, platePlacement (Shape 15 17)]) $ \layouts ->
        forAllBlind (elements layouts) $ \layout ->
          onArray canonicalProfile layout paperReader $ \setting ->
            forAllBlind (elements (facesFelt setting)) test
    sensors =
      [ idealSensor,
        standardSensor {sensorPositionError = 3, sensorRotationError = 4},
        presetSensor Real,
        (presetSensor Hard) {sensorPositionError = 2}
      ]
    soft =
      (presetSensor Real)
        { sensorColumns = 2,
          sensorRows = 30,
          sensorPositionError = 0,
          sensorRotationError = 90,
          sensorStiffness = 0.001
        }

-- | An array of 2047 x 2049 cells with its window of 3 x 4, and its plate.
withLarge :: Testable p => (forall k. KnownField k => Setting k -> p) -> Property
withLarge = withPlate choice {chosenWindow = Just (Shape 3 4)}
  where
    choice = profileChoice 4 polynomial (Shape 2047 2049)
    polynomial = [2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]

-- | An array over GF(4) and its plate.
withPlate :: Testable p => ProfileChoice -> (forall k. KnownField k => Setting k -> p) -> Property
withPlate choice test =
  whenRight (chooseProfile choice) $ \profile ->
    whenRight (platePlacement (profileShape profile)) $ \plate ->
      onArray profile plate paperReader (\setting -> property (test setting))

decoderSpec :: Spec
decoderSpec = do
  for_ arrays $ \(name, profile, surfaces) ->
    withCases 7 60 $
      it ("finds a grid where comparing all positions does: " ++ name) $
        forAll (elements surfaces) $ \surface ->
          onBothRoads profile surface $ \array reader without ->
            forAllBlind (scenesOf surface array) $ \scene ->
              forAll (elements [Guaranteed, UpTo 0, UpTo 1]) $ \radius ->
                forAll (elements [0.01, 0.3]) $ \tolerated ->
                  forAll (elements [0, 0.005, 0.3]) $ \share ->
                    let found with =
                          locateGrid
                            with
                            (Tolerance tolerated radius share Nothing 0)
                            []
                            (FaceGrid (scattered scene) [] [] (0, 0))
                     in agreeing tolerated (found reader) (found without)
  it "refuses by name what is too much to decode" $
    onBothRoads canonicalProfile Torus $ \array reader without ->
      let cells =
            Map.fromList
              [ ((i, j), [symbolOf (65 * i + j) (16 * real j, 20 * real i) (identity, c)])
                | i <- [0 .. 64],
                  j <- [0 .. 64],
                  let c = toCode (cellAt array (Position (fromIntegral i) (fromIntegral j)))
              ]
          found with = locateGrid with standardTolerance [] (FaceGrid cells [] [] (0, 0))
       in once . conjoin $
            [ show (locationOutcome (found reader)) === show (Placed (Position 0 0)),
              counterexample (show (locationOutcome (found without))) $
                case locationOutcome (found without) of
                  Undecoded (LocatorAlgebra (AlgebraCells _)) -> True
                  _ -> False
            ]
  it "an array needs a codebook on a surface that is foreign to it" $
    onPaper $ \(Setting array mask layout symbols) ->
      let refused most =
            either Just (const Nothing) $
              recogniserUpTo most (ArrayOn TwistedTorus array) mask layout symbols
       in [refused 255, refused 254]
            === [Nothing, Just (RecogniserArray (LocatorPatch (TooManyPlaces 255 254)))]
  it "from 2^16 cells on, the cost depends on the press, except where only comparing works" $
    once . conjoin $
      [ withPlate choice $ \setting ->
          let locator = recogniserLocator (recogniserOn surface setting)
           in decoderOfProbabilities locator === Right decoder
        | (choice, surface, decoder) <- decoders
      ]
  where
    decoders =
      [ (profileChoice 4 [2, 1, 1, 0, 0, 0, 1] (Shape 63 65), Torus, PosteriorDecoder),
        (large, Torus, ListDecoder),
        (large, TwistedTorus, PosteriorDecoder)
      ]
    large = profileChoice 4 [3, 0, 2, 1, 0, 0, 0, 0, 0, 0, 1] (Shape 1023 1025)
    real = fromIntegral :: Int -> Double
    arrays =
      [ ("15 x 17", canonicalProfile, [Torus, Sheet]),
        ("15 x 17, row by row", foldedBy RowMajor canonicalProfile, [TwistedTorus, Sheet])
      ]
        ++ [ ("63 x 65", profile, [Torus, Sheet])
             | Right profile <-
                 [chooseProfile (profileChoice 4 [2, 1, 1, 0, 0, 0, 1] (Shape 63 65))]
           ]

-- | Scenes of symbols as an array on a surface has them from one of its first positions on.
scenesOf :: KnownField k => Surface -> PseudorandomArray k -> Gen Scene
scenesOf surface array = genScene cell [1e-7, 0.0005, 0.01, 0.09, 0.2, 0.8]
  where
    cell (Position r c) (i, j) =
      (\at -> (at, toCode (cellAt array at)))
        <$> canonicalPosition
          surface
          (arrayShape array)
          (toInteger r + toInteger i)
          (toInteger c + toInteger j)

-- | The recognisers of an array, laid as a plate, with a codebook and without.
onBothRoads ::
  Testable p =>
  Profile ->
  Surface ->
  (forall k. KnownField k => PseudorandomArray k -> Recogniser k -> Recogniser k -> p) ->
  Property
onBothRoads profile surface test =
  whenRight (placement (profileShape profile) canonicalPitch [] []) $ \nothingLaid ->
    onArray profile nothingLaid paperReader $ \(Setting array mask _ symbols) ->
      let made most = recogniserUpTo most (ArrayOn surface array) mask nothingLaid symbols
       in whenRight ((,) <$> made (2 ^ (20 :: Int)) <*> made 0) (property . uncurry (test array))

-- | Compares a location without a codebook with one that has it. If both place the grid, the place
-- is equal and the doubt no smaller. If only the exact one places it, the other's doubt exceeds
-- half of what is tolerated.
agreeing :: Double -> GridLocation -> GridLocation -> Property
agreeing tolerated exact bounded = case (locationOutcome exact, locationOutcome bounded) of
  (Placed a, Placed b) ->
    label "placed" $
      conjoin [a === b, locationOrientation exact === locationOrientation bounded, noLess]
  (Placed _, other) ->
    label "bounds" . counterexample (show (other, map doubts [exact, bounded])) $
      any (> tolerated / 2) (doubts bounded)
  (_, Placed b) -> counterexample ("placed at " ++ show b) False
  _ -> label "not placed" True
  where
    doubts = fmap supportDoubt . locationSupport
    noLess =
      counterexample (show (map doubts [exact, bounded])) $
        fmap (* 0.999999) (doubts exact) <= doubts bounded

pressSpec :: Spec
pressSpec = do
  it "are located in its corners and along its edges: the paper's array" $
    whenRight (platePlacement (Shape 15 17)) $ \plate ->
      onArray canonicalProfile plate paperReader (`locatedAround` (40, 52))
  it "are located in its corners and along its edges: 2047 x 2049 cells" $
    withLarge (`locatedAround` (80, 80))

edgeSpec :: Spec
edgeSpec =
  it "are decoded right or refused, and most are right" $
    onPaper $ \setting ->
      let count = byEffort 1 12
          -- The face of the cube is 80 taxels wide.
          size = byEffort (88, 52) (110, 66)
          how = standardExperiment standardSensor
          exploring = exploration standardSensor AnyAngle size
          results =
            evaluated
              how {experimentPresses = count, experimentExploration = exploring}
              (settingArray setting)
              (recogniserOf setting)
       in once . whenRight results $ \found ->
            let counted = tally (map withStitching found)
             in (tallyWrong counted, 6 * tallyRight counted >= 5 * count) === (0, True)
