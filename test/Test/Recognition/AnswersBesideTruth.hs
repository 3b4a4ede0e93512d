-- | Tests the true place of a point that the robot touched, and answers compared with it.
module Test.Recognition.AnswersBesideTruth (spec) where

import PraTactile.Explore
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement (Face (..), Placement)
import PraTactile.Object.WingedEdge
import PraTactile.Sensor.Frame (taxelPitch)
import PraTactile.Symmetry
import PraTactile.Truth
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import qualified Test.Support as Support

spec :: Spec
spec = runIO (Support.right canonicalPlacement) >>= lawsOn

lawsOn :: Placement -> Spec
lawsOn layout = do
  prop "the region's corners, as the robot sees them, are those on the face, turned" $
    forAllShrink someTruth simpler $ \truth ->
      let region = truthRegion truth
          (wide, high) =
            ( taxelPitch * fromIntegral (regionWidth region),
              taxelPitch * fromIntegral (regionHeight region)
            )
          (ox, oy) = truthOrigin truth
          -- Clockwise from the upper left, in the robot's frame and on the face. A face that is
          -- turned clockwise by a quarter shows its lower left corner at the upper left.
          seen = [(ox, oy), (ox + wide, oy), (ox + wide, oy + high), (ox, oy + high)]
          (left, top) = (taxelPitch * regionRight region, taxelPitch * regionDown region)
          (across, down)
            | exchangesAxes (regionSymmetry region) = (high, wide)
            | otherwise = (wide, high)
          onFace =
            [(left, top), (left + across, top), (left + across, top + down), (left, top + down)]
          corners = take 4 (drop (quarterTurns (invert (regionSymmetry region))) (cycle onFace))
       in conjoin (zipWith near (map (truePlace truth) seen) corners)
  prop "an answer agrees with its truth within less than half a cell, and else is elsewhere" $
    forAllShrink someTruth simpler $ \truth point (dx, dy) ->
      let (x, y) = truePlace truth point
          claim =
            Claim
              (truthFace truth)
              (regionSymmetry (truthRegion truth))
              (x + dx, y + dy)
              point
              Nothing
          distance = sqrt (dx * dx + dy * dy)
       in compared layout truth claim `shouldSatisfy` \verdict -> case verdict of
            Right far ->
              abs dx < 12.7 + tiny && abs dy < 15.875 + tiny && abs (far - distance) < tiny
            Left (Elsewhere far) ->
              (abs dx > 12.7 - tiny || abs dy > 15.875 - tiny) && abs (far - distance) < tiny
            Left _ -> False
  prop "another face, or another way up, never agrees, whatever the place" $
    forAllShrink someTruth simpler $ \truth point ->
      let right =
            Claim
              (truthFace truth)
              (regionSymmetry (truthRegion truth))
              (truePlace truth point)
              point
              Nothing
       in ( compared
              layout
              truth
              right
                { claimFace = Face (ObjectName "cube") (readFaceName "C2 C6 C7 C3")
                },
            compared layout truth right {claimSymmetry = turned 1 <> claimSymmetry right}
          )
            === (Left OtherFace, Left OtherWayUp)
  -- Begun one vertex further, the face W wide and H high begins at its lower left. What was x right
  -- and y down is then H - y right and x down, and the face lies a quarter turn further back.
  prop "an answer that begins the face at another vertex describes the same place" $
    forAllShrink someTruth simpler $ \truth point (dx, dy) ->
      let (x, y) = truePlace truth point
          claim =
            Claim
              (truthFace truth)
              (regionSymmetry (truthRegion truth))
              (x + dx, y + dy)
              point
              Nothing
          onward given =
            given
              { claimFace = rotated (claimFace given),
                claimSymmetry = turned 3 <> claimSymmetry given,
                claimPlace = (127 - snd (claimPlace given), fst (claimPlace given))
              }
          rotated (Face object (FaceName walk)) =
            Face object (FaceName (drop 1 walk ++ take 1 walk))
          verdicts = map (compared layout truth) (take 4 (iterate onward claim))
       in counterexample (show verdicts) $
            all (nearly (take 1 verdicts)) verdicts || abs (abs dx - 12.7) < tiny
              || abs (abs dy - 15.875) < tiny
  prop "at any angle the centre stays the centre, and directions are turned back by the angle" $
    forAll askewTruth $ \truth ->
      let region = truthRegion truth
          (ox, oy) = truthOrigin truth
          half n = taxelPitch * fromIntegral n / 2
          centre = (ox + half (regionWidth region), oy + half (regionHeight region))
          (wide, high) = regionExtent region
          (x, y) = truePlace truth centre
          (u, v) = truePlace truth (fst centre + 10, snd centre)
          radians = regionTurn region * pi / 180
       in near
            (x, y)
            ( taxelPitch * regionRight region + half wide,
              taxelPitch * regionDown region + half high
            )
            .&&. near (u - x, v - y) (10 * cos radians, -10 * sin radians)
  prop "a turn by a small angle changes little" $
    forAllShrink someTruth simpler $ \truth point ->
      let (x, y) = point :: (Double, Double)
          region = truthRegion truth
          (u, v) = truePlace truth point
          (u', v') = truePlace truth {truthRegion = region {regionAngle = 1e-9}} point
       in abs x < 1e4 && abs y < 1e4 ==> near (u, v) (u', v')
  prop "at any angle the nearest quarter turn is right; at the border between two, both are" $
    forAll askewTruth $ \truth ->
      let said symmetry =
            compared layout truth $
              Claim (truthFace truth) symmetry (truePlace truth (1, 2)) (1, 2) Nothing
          region = truthRegion truth
          right = [symmetry | symmetry <- rotations, said symmetry /= Left OtherWayUp]
       in counterexample (show right) $
            regionSymmetry region `elem` right
              && length right == (if abs (regionAngle region) < 40 then 1 else 2)
  prop "exactly 50 degrees off counts as near, and more does not" $
    forAll askewTruth $ \truth ->
      let tilted angle = truth {truthRegion = (truthRegion truth) {regionAngle = angle}}
          symmetry = regionSymmetry (truthRegion truth)
          said angle =
            compared layout (tilted angle) $
              Claim (truthFace truth) symmetry (truePlace (tilted angle) (1, 2)) (1, 2) Nothing
       in map ((== Left OtherWayUp) . said) [50, -50, 50.001, -50.001]
            === [False, False, True, True]
  prop "an angle is its nearest quarter turn plus the rest" $
    forAll (choose (-1000, 1000)) $ \degrees ->
      let (symmetry, rest) = nearestQuarter degrees
          off = degreesClockwise symmetry + rest - degrees
       in counterexample (show (symmetry, rest)) $
            abs rest <= 45 && abs (off - 360 * fromIntegral (round (off / 360) :: Int)) < 1e-9
  where
    tiny = 1e-6 :: Double
    nearly firsts verdict = case (firsts, verdict) of
      ([Right a], Right b) -> abs (a - b) < tiny
      ([Left (Elsewhere a)], Left (Elsewhere b)) -> abs (a - b) < tiny
      ([a], b) -> a == b
      _ -> False
    near (x, y) (u, v) =
      counterexample (show ((x, y), (u, v))) (abs (x - u) < tiny && abs (y - v) < tiny)

-- | A truth at any angle.
askewTruth :: Gen Truth
askewTruth = do
  truth <- someTruth
  (symmetry, angle) <- nearestQuarter <$> choose (0, 360)
  pure truth {truthRegion = (truthRegion truth) {regionSymmetry = symmetry, regionAngle = angle}}

someTruth :: Gen Truth
someTruth =
  Truth (Face (ObjectName "cube") (readFaceName "C1 C2 C3 C4"))
    <$> ( ProbedRegion
            <$> choose (0, 30)
            <*> choose (0, 30)
            <*> choose (16, 50)
            <*> choose (16, 50)
            <*> elements rotations
            <*> pure 0
        )
    <*> ((,) <$> choose (-500, 500) <*> choose (-500, 500))
    <*> pure Nothing

-- | Simpler truths for shrinking: with an origin at 0, or upright.
simpler :: Truth -> [Truth]
simpler truth =
  filter
    (/= truth)
    [ truth {truthOrigin = (0, 0)},
      truth {truthRegion = region {regionRight = 0, regionDown = 0}},
      truth {truthRegion = region {regionSymmetry = identity}}
    ]
  where
    region = truthRegion truth
