-- | Tests the library where arrays and touch meet: reliefs, explorations, and the whole way from an
-- image to the face.
module Test.Recognition.FromImageToFace (spec) where

import Data.Foldable (for_)
import Data.List (nub, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Numeric.LinearAlgebra (konst)
import PraTactile.Array
  ( ArrayOn (..),
    Position (..),
    Shape (..),
    Surface (..),
    cellAt,
  )
import PraTactile.Classification.Network (network)
import PraTactile.Classification.Reader (Reader (..), readerOf)
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Field (KnownField, toCode)
import PraTactile.Geometry (symbolThickness)
import PraTactile.Image
import PraTactile.Locate (Reason (..))
import PraTactile.Object.Canonical (canonicalLayings)
import PraTactile.Object.Placement
import PraTactile.Object.Radicals
import PraTactile.Recognise
import PraTactile.Recognise.Reading (Group (..), groups)
import PraTactile.Registration (compositeOf, standardRegistration)
import PraTactile.Relief
import PraTactile.Sensor (HeightMap (..), standardSensor)
import PraTactile.Sensor.Frame (movePoint, taxelPitch)
import PraTactile.Sensor.Manifest (Remedy (..), axesNamed)
import PraTactile.Shape
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (generate)
import Test.Recognition.Setting
import Test.Recognition.Symbols

spec :: Spec
spec = onPaper $ \setting -> do
  recogniserSpec setting
  groupSpec
  reliefSpec setting
  exploreSpec setting
  recogniseSpec setting

reliefs :: KnownField k => Setting k -> [(LaidFace, HeightMap)]
reliefs = map (fmap reliefHeights) . facesFelt

-- | The classes of a face's block, row by row.
classesOn :: KnownField k => Setting k -> LaidFace -> [[Int]]
classesOn setting face = classesOf (settingArray setting) high wide (laidAt face)
  where
    Shape high wide = laidGrid face

recogniserSpec :: KnownField k => Setting k -> Spec
recogniserSpec (Setting array mask layout reader) = describe "a recogniser" $ do
  it "refuses a placement whose symbols have another pitch than the reader's" $
    for_ [Pitch 25 31.75, Pitch 25.4 31, Pitch 12.7 31.75] $ \pitch ->
      refusal (Shape 15 17) pitch `shouldBe` Just (PitchesDiffer pitch (Pitch 25.4 31.75))
  it "refuses a placement on an array of another shape" $
    for_ [Shape 17 17, Shape 15 18, Shape 63 65] $ \shape ->
      refusal shape (Pitch 25.4 31.75) `shouldBe` Just (ArraysDiffer shape (Shape 15 17))
  it "refuses different numbers of network outputs, shapes and field elements" $ do
    let all' = readerAlphabet reader
    Right two <- pure (alphabet (take 2 (zip (shapeNames all') (shapes all'))))
    Right three <- pure (network (konst 0 (5, 97)) (konst 0 (3, 6)))
    let refused names with =
          either
            Just
            (const Nothing)
            (recogniser (ArrayOn Torus array) mask layout (readerOf names with))
    refused two (readerNetwork reader) `shouldBe` Just (ClassesDiffer 4 2 4)
    refused all' three `shouldBe` Just (ClassesDiffer 3 4 4)
    refused two three `shouldBe` Just (ClassesDiffer 3 2 4)
    refused all' (readerNetwork reader) `shouldBe` Nothing
  it "takes the canonical placement, laid again" $
    refusal (Shape 15 17) (Pitch 25.4 31.75) `shouldBe` Nothing
  where
    refusal shape pitch =
      case placement shape pitch (placementSolids layout) canonicalLayings of
        Left e -> error ("no placement: " ++ show e)
        Right laid ->
          either Just (const Nothing) (recogniser (ArrayOn Torus array) mask laid reader)

groupSpec :: Spec
groupSpec = describe "groups of symbols" $ do
  it "have each symbol by its number, even if several lie at the same place" $
    let found =
          groups
            [symbolAt 0 0 (0, 0), symbolAt 1 0 (0, 0), symbolAt 2 0 (100, 0), symbolAt 3 1 (100, 0)]
     in sort (map (map readNumber . groupSymbols) found) `shouldBe` [[0], [1], [2], [3]]
  it "have each symbol once, in its cell, wherever it lies and in any order" $
    property $
      forAll (shuffle (zip [0 ..] [(i, j) | i <- [0 .. 2], j <- [0 .. 3]])) $ \placed ->
        forAll ((,) <$> choose (-1e6, 1e6) <*> choose (-1e6, 1e6)) $ \(x, y) ->
          map
            (fmap (fmap readNumber) . groupCells)
            ( groups
                [ symbolAt n 0 (x + 16 * fromIntegral j, y + 20 * fromIntegral i)
                  | (n, (i, j)) <- placed
                ]
            )
            === [Just (Map.fromList [(cell, n) | (n, cell) <- placed])]
  where
    symbolAt number source centre =
      (symbolOf number centre (identity, 0)) {readSource = source, readClass = Nothing}

-- | A rectangle of a face as an image of full contrast: x, y, width, height in taxels.
region :: HeightMap -> (Int, Int, Int, Int) -> Raster
region heights (x, y, w, h) =
  generate w h (\i j -> maybe 0 (/ symbolThickness) (index (heightValues heights) (x + i) (y + j)))

reliefSpec :: KnownField k => Setting k -> Spec
reliefSpec setting = describe "reliefs" $ do
  it "every face has one, as large as the face in taxels" $ do
    length (reliefs setting) `shouldBe` 12
    for_ (reliefs setting) $ \(face, heights) ->
      map
        ((* (127 / 80)) . fromIntegral)
        [rasterWidth (heightValues heights), rasterHeight (heightValues heights)]
        `shouldBe` mapMaybe asFraction [spotRight (laidExtent face), spotDown (laidExtent face)]
  it "a face's classes are the array's codes where it is laid" $
    for_ (laidFaces (settingLayout setting)) $ \face ->
      concat (classesOn setting face)
        `shouldBe` [ toCode (cellAt (settingArray setting) (Position r c))
                     | let Position r0 c0 = laidAt face,
                       let Shape h w = laidGrid face,
                       r <- [r0 .. r0 + h - 1],
                       c <- [c0 .. c0 + w - 1]
                   ]
  it "each cell holds its symbol's bitmap, 8 x 12 amid 16 x 20 taxels, and nothing else" $
    for_ (reliefs setting) $ \(face, heights) -> do
      let margin side = round (nearestDouble (side (laidMargin face)) / taxelPitch) :: Int
      for_ (zip [0 ..] (classesOn setting face)) $ \(i, line) ->
        for_ (zip [0 ..] line) $ \(j, c) -> do
          let cell = region heights (margin spotRight + 16 * j, margin spotDown + 20 * i, 16, 20)
              expected shape x y = if embossedAt shape (x - 4) (y - 4) then 1 else 0
          Right (toRows cell)
            `shouldBe` fmap
              (\shape -> toRows (generate 16 20 (expected shape)))
              (shapeOf (readerAlphabet (settingReader setting)) c)

exploreSpec :: Setting k -> Spec
exploreSpec setting = describe "explorations" $ do
  prop "a random region lies on its face, in the robot's frame as in the face's" $ \seed ->
    forAll (elements (laidFaces (settingLayout setting))) $ \face ->
      let (r, _) = randomRegion rotations standardRegionSize face (mkStdGen seed)
          extent side = nearestDouble (side (laidExtent face)) + 1e-9
       in property
            ( and
                [ x >= -1e-9 && x <= extent spotRight && y >= -1e-9 && y <= extent spotDown
                  | (x, y) <- cornersOf r
                ]
            )
  prop "at any whole angle, a region's corners are on the face or equally far off it" $ \seed ->
    forAll ((,) <$> elements (laidFaces (settingLayout setting)) <*> anyAngle) $
      \(face, degrees) -> conjoin . flip map [seed .. seed + 9] $ \seed' ->
        let lying = TurnedBy (fromIntegral (degrees :: Int))
            (r, _) = drawnRegion lying standardRegionSize face (mkStdGen seed')
            corners = cornersOf r
            fits side coordinates =
              let (low, high) = (minimum coordinates, maximum coordinates)
               in counterexample (show (low, high, side)) $
                    if high - low <= side
                      then low >= -1e-6 && high <= side + 1e-6
                      else abs (low + high - side) < 1e-6
         in fits (nearestDouble (spotRight (laidExtent face))) (map fst corners)
              .&&. fits (nearestDouble (spotDown (laidExtent face))) (map snd corners)
  it "the standard region is 40 taxels wide and 52 tall" $ standardRegionSize `shouldBe` (40, 52)
  where
    -- Often a degree off a quarter turn, where only few places are too near the edge.
    anyAngle = oneof [choose (-360, 360), (+) . (90 *) <$> choose (-3, 3) <*> elements [-1, 1]]
    -- Millimetres to the right of and below the face's upper left vertex.
    cornersOf r =
      [ movePoint (regionMotion r) (taxelPitch * fromIntegral x, taxelPitch * fromIntegral y)
        | let (w, h) = standardRegionSize,
          x <- [0, w],
          y <- [0, h]
      ]

recogniseSpec :: KnownField k => Setting k -> Spec
recogniseSpec setting = describe "recognition" $ do
  it "a window that lies on a face is found there, whichever way up" $ do
    let windows =
          [ (face, heights, i, j)
            | (face, heights) <- reliefs setting,
              let Shape h w = laidGrid face,
              i <- [0 .. h - 2],
              j <- [0 .. w - 2]
          ]
        cases = (,) <$> windows <*> rotations
    length windows `shouldBe` 132
    -- A quick run takes every eleventh: windows of each face, and each way up.
    for_ [chosen | (k, chosen) <- zip [0 :: Int ..] cases, k `mod` byEffort 11 1 == 0] $
      \((face, heights, i, j), orientation) -> do
        let margin side = round (nearestDouble (side (laidMargin face)) / taxelPitch) :: Int
            image =
              region
                heights
                ( margin spotRight + 16 * fromIntegral j,
                  margin spotDown + 20 * fromIntegral i,
                  32,
                  40
                )
            Position r c = laidAt face
        found (onRaster orientation image)
          `shouldBe` Right
            (orientation, Position (r + i) (c + j), Just (laidFace face, Position i j))
  it "a blank image is refused: no-symbols" $
    refusal (constant 40 52 0) `shouldBe` Just (ShownInstead InsteadFlat NoSymbols)
  it "uniform contact is refused: no-symbols" $
    refusal (constant 40 52 1) `shouldBe` Just (ShownInstead InsteadFlat NoSymbols)
  it "an image of no size is refused: no-symbols" $
    refusal (constant 0 0 0) `shouldBe` Just (ShownInstead InsteadFlat NoSymbols)
  it "three symbols are too few" $
    refusal (windowOf [(4, 4, 0, id), (20, 4, 1, id), (4, 24, 2, id)])
      `shouldBe` Just (NotLocated NoCompleteWindow)
  it "one symbol half-turned among upright ones is a contradiction of orientation" $
    refusal
      (windowOf [(4, 4, 3, id), (20, 4, 2, id), (4, 24, 3, id), (20, 24, 1, onRaster (turned 2))])
      `shouldBe` Just OrientationContradicts
  it "a mirror image is refused as mirrored, whichever way up" $
    for_ [symmetry <> mirror | symmetry <- rotations] $ \symmetry -> do
      let seen = windowOf [(4, 4, 3, id), (20, 4, 2, id), (4, 24, 3, id), (20, 24, 1, id)]
      refusal (onRaster symmetry seen)
        `shouldBe` Just (Mirrored [Remedy Nothing (lookup "-x,y" axesNamed)])
  it "every refusal has its own name" $
    length (nub (map refusalName refusals)) `shouldBe` length refusals
  it "the names of refusals are the promised ones" $
    map refusalName refusals
      `shouldMatchList` [ "no-symbols",
                          "symbols-unclear",
                          "mirrored",
                          "orientation-contradiction",
                          "grid-contradiction",
                          "windows-contradiction",
                          "frames-contradiction",
                          "not-decoded",
                          "zero-window",
                          "too-few-cells",
                          "no-complete-window",
                          "not-in-array",
                          "contradiction",
                          "off-sheet",
                          "beyond-radius",
                          "below-threshold"
                        ]
  withCases 2 40 $
    prop "a random exploration with noise is right or refused, never wrong" $ \seed ->
      forAllShow (elements (facesFelt setting)) (show . laidFace . fst) $ \face ->
        case trial usual face (mkStdGen seed) of
          Nothing -> counterexample "the region does not lie on the face" False
          Just t ->
            case withStitching (runTrial standardTolerance reader standardRegistration t) of
              Mistaken doubt -> counterexample ("wrong, with a doubt of " ++ show doubt) False
              _ -> property True
  where
    reader = recogniserOf setting
    usual = exploration standardSensor (AmongTurns rotations) standardRegionSize
    found image = case recognise reader (compositeOf image) of
      Left e -> Left (show e)
      Right recognition -> case recognisedAnswer recognition of
        Left e -> Left (refusalName e)
        Right (Several _ _) -> Left "several"
        Right (Found answer) ->
          let window =
                foundWindow answer
           in Right
                (foundOrientation answer, windowPosition window, onFace (windowWhereabouts window))
    onFace place = case place of
      OnFace p -> Just (placeFace p, placeCell p)
      _ -> Nothing
    refusal image =
      either
        (const Nothing)
        (either Just (const Nothing) . recognisedAnswer)
        (recognise reader (compositeOf image))
    windowOf placed =
      pasted
        (32, 40)
        [ (x, y, change (toRaster (shapes (readerAlphabet (settingReader setting)) !! c)))
          | (x, y, c, change) <- placed
        ]
