-- | Tests the layouts other than the robot's that the frames leave possible.
module Test.Touch.Registration.OtherLayouts (spec) where

import Data.Foldable (for_)
import Data.List (nub, sort)
import qualified Data.Map.Strict as Map
import PraTactile.Composite.Lattice (Lattice (..))
import PraTactile.Image (constant, mapRaster)
import PraTactile.Registration hiding (assemble)
import PraTactile.Registration.Alternatives (slipped, tiedGroups)
import PraTactile.Registration.Joint (Joint (..), registerJointly)
import PraTactile.Registration.Lattice.Fit (fitsAt, whole)
import PraTactile.Registration.Layout
import PraTactile.Sensor.Frame (Frame (..), SensorPose (..), taxelPitch)
import PraTactile.Sensor.Manifest (axesName, axesNamed, straight)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Touch.Paper (assemble, paperTables)
import Test.Touch.Registration.Face (frameAt)

spec :: Spec
spec = do
  prop "are the seven other axes, four other scales, and slips, which share their probability" $
    forAll (choose (1, 5)) $ \columns -> forAll (choose (1, 5)) $ \rows ->
      forAll (choose (1, 4)) $ \several -> forAll (elements scaleLists) $ \likely ->
        let places = [(x * 12, y * 9) | y <- upTo rows, x <- upTo columns]
            tied = [k `mod` several | (k, _) <- zip [0 ..] places]
            groups = 1 + maximum tied
            all' = layouts likely tied places
            shareOf which = sum [layoutShare l | l <- all', which (layoutCause l)]
            -- One share of all that is no slip; one of slips if there are lines, and half of one
            -- for groups if there are several.
            slips = (if columns + rows > 2 then 1 else 0) + (if groups > 1 then 0.5 else 0)
            alike a b = abs (a - b) < 1e-9 :: Bool
            extent part ps = maximum (map part ps) - minimum (map part ps)
            scales = [((x, y), ps) | Layout (OtherScale x y) _ ps _ <- all']
         in zipWith alike (map shareOf [isAxes, isScale, (== Slip)]) [1, 1, slips]
              === [True, True, True]
              .&&. length (filter (isAxes . layoutCause) all')
              === 7
              .&&. length (filter ((== Slip) . layoutCause) all')
              === 4 * (columns + rows - 2 + if groups > 1 then groups else 0)
              -- Further from each other, across and down, by the stated factors.
              .&&. [(extent fst ps, extent snd ps) | (_, ps) <- scales]
              === [(x * extent fst places, y * extent snd places) | ((x, y), _) <- scales]
  prop "slips are at the lines between the rows that are furthest apart, eight at most" $
    forAll (choose (0, 14) >>= \count -> take count <$> shuffle [3 .. 20]) $ \gaps ->
      forAll arbitrary $ \upright ->
        let places = [if upright then (0, t) else (t, 0) | t <- scanl (+) 0 gaps]
            gapBefore moved =
              [b - a | ((same, a), (changed, b)) <- zip moved (drop 1 moved), same /= changed]
            told =
              [ gapBefore (zip (map (== (0, 0)) (layoutSteps l)) (map (uncurry (+)) places))
                | l <- layouts [] (map (const 0) places) places,
                  layoutCause l == Slip
              ]
         in sort (nub (concat told)) === drop (length gaps - 8) (sort gaps)
  it "a slip moves all beyond a line by a cell in any direction" $
    nub [layoutSteps l | l <- layouts [] [0, 0] [(0, 0), (16, 0)], layoutCause l == Slip]
      `shouldBe` [[(0, 0), step] | step <- [(0, 1), (0, -1), (1, 0), (-1, 0)]]
  it "a slip of all frames together moves the cells and has the same likelihood" $ do
    let found = jointOf [(x, y) | y <- [20, 30, 40], x <- [20, 30, 40]]
    for_ [(0, 1), (-1, 0)] $ \(i, j) -> do
      let (likelier, lattice) = slipped found (replicate 9 (i, j))
      abs likelier `shouldSatisfy` (< 1e-9)
      Map.toList (latticeCells lattice)
        `shouldBe` [ ((i' + i, j' + j), logs)
                     | ((i', j'), logs) <- Map.toList (latticeCells (jointLattice found))
                   ]
  it "frames with symbols in common are one group; blank frames are in no group" $ do
    tiedGroups (jointOf [(x, 20) | x <- [20, 24, 28, 84, 86, 88]]) `shouldBe` [0, 0, 0, 1, 1, 1]
    tiedGroups (jointFrom [((x, 0), constant 16 16 0.5) | x <- [0, 8, 16]])
      `shouldBe` [-1, -1, -1]
  it "except some slips are refuted by overlaps with relief, whatever the gain and offset" $ do
    let places = [(x, y) | y <- [20, 28 .. 52], x <- [20, 28 .. 44]]
        faults (gain, offset) = map alternativeCause (left gain offset places)
    nub (faults (1, 0)) `shouldSatisfy` all (== Slip)
    for_ [(0.1, 0.45), (0.02, 0.3)] $ \read' -> faults read' `shouldBe` faults (1, 0)
  it "remain if frames side by side do not overlap and lie on the same lattice" $ do
    -- Beginning with a cell, whole cells in every frame across, half of its overlap down.
    let places = [(x, y) | y <- [20, 30 .. 60], x <- [16, 32, 48]]
        faultsFrom origin = map alternativeCause (leftFrom origin places)
        faults = faultsFrom (0, 0)
    [axesName a | OtherAxes a <- faults] `shouldBe` ["-x,y"]
    [() | Slip <- faults] `shouldNotBe` []
    [() | OtherScale _ _ <- faults] `shouldNotBe` []
    -- Wherever the robot has its origin.
    for_ [(65536, 0), (-4096, 65536)] $ \origin -> faultsFrom origin `shouldBe` faults
  it "have no other axes if a seam cuts symbols, though nothing overlaps" $ do
    let faults = map alternativeCause (left 1 0 [(x, y) | y <- [20, 36, 52], x <- [24, 40, 56]])
    [axesName a | OtherAxes a <- faults] `shouldBe` []
  it "do not exist for a single frame, nor if frames are not registered" $ do
    map alternativeCause (left 1 0 [(20, 20)]) `shouldBe` []
    map alternativeCause (othersOf Nominal (0, 0) 1 0 [(16, 20), (32, 20), (48, 20)]) `shouldBe` []
  where
    scaleLists = [[], [(3, 3)], [(1, 0.7), (9, 9)]]
    upTo n = map fromIntegral [0 .. n - 1 :: Int]
    isAxes fault = fault `elem` [OtherAxes a | (_, a) <- axesNamed, a /= straight]
    isScale fault = case fault of
      OtherScale _ _ -> True
      _ -> False
    jointOf places = jointFrom [((x, y), frameAt (16, 16) (x, y)) | (x, y) <- places]
    jointFrom frames =
      registerJointly
        standardRegistration
        (fitsAt paperTables (map (whole . snd) frames) 0)
        (map (fmap whole) frames)
    left = othersOf Automatic (0, 0)
    leftFrom origin = othersOf Automatic origin 1 0
    othersOf method origin gain offset places =
      either (error . show) (filter beside . compositeAlternatives . assemblyComposite) $
        let frames = map (frame origin gain offset) places
         in assemble method (withNoiseOf frames standardRegistration) frames
    beside = (/= OneFrame) . alternativeCause
    frame :: (Double, Double) -> Double -> Double -> (Double, Double) -> Frame
    frame (left', top) gain offset (x, y) =
      Frame
        (SensorPose ((left' + x) * taxelPitch) ((top + y) * taxelPitch) 0)
        1
        (felt gain offset (x, y))
        taxelPitch
        []
    felt gain offset place = mapRaster (\v -> offset + gain * v) (frameAt (16, 16) place)
