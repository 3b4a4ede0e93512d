{-# LANGUAGE OverloadedStrings #-}

-- | Tests rigid motions, the plan of a scan, and manifests.
module Test.Touch.Sensor.MotionsAndPlans (spec) where

import qualified Data.ByteString as B
import Data.Either (isLeft)
import Data.Foldable (for_)
import qualified Data.Text as Text
import Data.Text.Encoding (encodeUtf8)
import PraTactile.Geometry hiding (taxelPitch)
import qualified PraTactile.Geometry as Geometry
import PraTactile.PlainText (OtherEncoding (..))
import PraTactile.Sensor.Frame
import PraTactile.Sensor.Manifest
import PraTactile.Symmetry (degreesClockwise, nearestQuarter)
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  describe "Sizes" sizes
  describe "Angles and parabolas" formulas
  describe "Motions" motions
  describe "Plans" plans
  describe "Manifests" manifests

-- | The paper's sections III and IV.
sizes :: Spec
sizes = do
  it "the sensor has 16 elements a side, 1.5875 mm apart, a sixteenth of an inch" $
    (sensorSide, Geometry.taxelPitch) `shouldBe` (16, 25.4 / 16 :: Rational)
  it "symbols are 8 x 12 taxels, 1.5875 mm high, 25.4 mm apart across and 31.75 mm down" $ do
    (symbolWidth, symbolHeight, symbolThickness) `shouldBe` (8, 12, 1.5875 :: Rational)
    (columnPitch * 1.5875, rowPitch * 1.5875) `shouldBe` (25.4 :: Rational, 31.75 :: Rational)

formulas :: Spec
formulas = do
  it "half a turn is pi" $ toRadians 180 `shouldBe` pi
  it "toDegrees (toRadians a) = a" $
    property $ \a -> abs (toDegrees (toRadians a) - a) <= 1e-12 * abs a
  it "cosine and sine are exact at the multiples of 90" $
    map (cosineSine . (90 *)) [-5 .. 5]
      `shouldBe` take 11 (drop 3 (cycle [(1, 0), (0, 1), (-1, 0), (0, -1)]))
  it "cosine and sine are those of radians" $
    property $ \a ->
      let (c, s) = cosineSine a
          radians = a * pi / 180
       in abs (c - cos radians) < 1e-12 && abs (s - sin radians) < 1e-12
  it "rotated a . rotated b = rotated (a + b)" $
    property $ \a b place ->
      let (x, y) = rotated a (rotated b place)
          (x', y') = rotated (a + b) place
          size = 1 + abs (fst place) + abs (snd place)
       in abs (x - x') + abs (y - y') < 1e-9 * size
  it "a parabola that opens downwards is highest at its vertex; any other has no vertex" $
    forAll ((,,) <$> choose (-3, 3) <*> choose (-2, 2) <*> choose (-1, 1)) $ \(bend, v, top) ->
      let at t = top - bend * (t - v) * (t - v)
       in case parabolaVertex (at (-1)) (at 0) (at 1) of
            Just found -> bend > 0 && (bend < 1e-3 || abs (found - v) < 1e-9)
            Nothing -> bend < 1e-12
  it "an angle is its nearest quarter turn plus a rest in [-45, 45)" $
    forAll (oneof [arbitrary, (45 *) . fromIntegral <$> choose (-20, 20 :: Int)]) $ \angle ->
      let (quarter, beyond) = nearestQuarter angle
          turns = (angle - degreesClockwise quarter - beyond) / 360
       in beyond >= -45 && beyond < 45
            && abs (turns - fromIntegral (round turns :: Int)) < 1e-9

genMotion :: Gen Motion
genMotion =
  Motion
    <$> oneof [elements [0, 90, 180, 270], choose (0, 359.9)]
    <*> choose (-99, 99)
    <*> choose (-99, 99)

genPose :: Gen SensorPose
genPose = SensorPose <$> choose (-99, 99) <*> choose (-99, 99) <*> choose (0, 359.9)

-- | Equal up to rounding, also for angles around the full turn.
same :: SensorPose -> SensorPose -> Property
same a@(SensorPose x y r) b@(SensorPose x' y' r') =
  counterexample
    (show (a, b))
    (abs (x - x') < 1e-9 && abs (y - y') < 1e-9 && (turn < 1e-9 || 360 - turn < 1e-9))
  where
    turn = abs (r - r')

motions :: Spec
motions = do
  it "move stay = id" $ forAll genPose $ \p -> move stay p `same` p
  it "move (inverse m) (move m p) = p" $
    forAll ((,) <$> genMotion <*> genPose) $ \(m, p) -> move (inverse m) (move m p) `same` p
  it "move (inverse (inverse m)) p = move m p" $
    forAll ((,) <$> genMotion <*> genPose) $ \(m, p) -> move (inverse (inverse m)) p `same` move m p
  it "move (m `andThen` n) p = move n (move m p)" $
    forAll ((,,) <$> genMotion <*> genMotion <*> genPose) $ \(m, n, p) ->
      move (m `andThen` n) p `same` move n (move m p)
  it "distances stay the same" $
    forAll ((,,) <$> genMotion <*> genPose <*> genPose) $ \(m, p, q) ->
      let distance (x, y) (x', y') = sqrt ((x - x') * (x - x') + (y - y') * (y - y'))
          at (SensorPose x y _) = (x, y)
       in abs (distance (at p) (at q) - distance (movePoint m (at p)) (movePoint m (at q))) < 1e-9
  it "a quarter turn clockwise takes right to down, down to left, exactly" $ do
    movePoint (Motion 90 0 0) (1, 0) `shouldBe` (0, 1)
    movePoint (Motion 90 0 0) (0, 1) `shouldBe` (-1, 0)
    movePoint (Motion (-270) 0 0) (1, 0) `shouldBe` (0, 1)
    movePoint (Motion 180 5 7) (1, 2) `shouldBe` (4, 5)
  it "rotations stay in [0, 360)" $
    forAll ((,) <$> genMotion <*> genPose) $ \(m, p) ->
      let r =
            poseRotation (move m p)
       in r >= 0 && r < 360

  it "rotations stay in [0, 360) and turn correctly, however large or small they are" $
    [ r
      | e <- [-1074, -60, -50, 0, 1, 5, 9, 20 :: Int],
        sign <- [-1, 1],
        shift <- [-720, -360, 0, 360, 719],
        let r = sign * 2 ^^ e + shift,
        let r' = poseRotation (move (Motion r 0 0) (SensorPose 0 0 0)),
        let (x, y) = movePoint (Motion r 0 0) (1, 0),
        let (x', y') = (cos (r' * pi / 180), sin (r' * pi / 180)),
        not (r' >= 0 && r' < 360 && abs (x - x') < 1e-9 && abs (y - y') < 1e-9)
          || abs (x - cos (r * pi / 180)) + abs (y - sin (r * pi / 180)) > 1e-8
    ]
      `shouldBe` []

plans :: Spec
plans = do
  it "the evaluation's region has columns at 0, 8, 16, 24 and rows at 0, 8, 16, 24, 32, 36" $
    planScan 8 (0, 0) (40, 52)
      `shouldBe` Right
        [ SensorPose (taxelPitch * (x + 8)) (taxelPitch * (y + 8)) 0
          | y <- [0, 8, 16, 24, 32, 36],
            x <- [0, 8, 16, 24]
        ]
  it "the frames cover the region and nothing else, neighbours no further apart than the spacing" $
    forAll ((,,) <$> choose (1, 16) <*> choose (16, 70) <*> choose (16, 70)) $ \(spacing, w, h) ->
      forAll ((,) <$> choose (-50, 50) <*> choose (-50, 50)) $ \(left, top) ->
        case planScan spacing (left, top) (w, h) of
          Left e -> counterexample (show e) False
          Right poses ->
            let offsets edge coordinate =
                  unique [round ((coordinate p - edge) / taxelPitch - 8) | p <- poses]
                good size os =
                  take 1 os == [0]
                    && last os == size - 16
                    && and (zipWith (\a b -> b - a <= spacing) os (drop 1 os))
                xs = offsets left poseX
                ys = offsets top poseY
             in counterexample
                  (show (xs, ys))
                  ( good w xs
                      && good h ys
                      && length poses == length xs * length ys
                      && all ((== 0) . poseRotation) poses
                  )
  it "a spacing below one taxel, a region below the sensor, and an infinite region are refused" $ do
    planScan 0 (0, 0) (40, 40) `shouldBe` Left (SpacingTooSmall 0)
    planScan 8 (0, 0) (15, 40) `shouldBe` Left (RegionTooSmall 15 40)
    planScan 8 (0, 0) (40, -1) `shouldBe` Left (RegionTooSmall 40 (-1))
    planScan 1 (0, 0) (maxBound, maxBound) `shouldBe` Left (RegionTooLarge maxBound maxBound)
  it "a plan has at most 100000 presses" $ do
    let columnsAndRows (a, b) = planScan 1 (0, 0) (a + sensorSide - 1, b + sensorSide - 1)
    map (fmap length . columnsAndRows) [(250, 400), (11, 9091)]
      `shouldBe` [Right 100000, Left (RegionTooLarge 26 9106)]
  where
    unique :: [Int] -> [Int]
    unique = foldr (\a seen -> if a `elem` seen then seen else insertInOrder a seen) []
    insertInOrder a seen = takeWhile (< a) seen ++ [a] ++ dropWhile (< a) seen

manifests :: Spec
manifests = do
  it "optional parts may be missing: forces, and the positions of calibration frames" $ do
    parseManifest "file,x_mm,y_mm,rotation_deg\na.pgm,1,2,0\n"
      `shouldBe` Right [Entry "a.pgm" (Just (SensorPose 1 2 0)) Nothing]
    parseManifest "file\na.pgm\nb.pgm\n"
      `shouldBe` Right [Entry "a.pgm" Nothing Nothing, Entry "b.pgm" Nothing Nothing]
    parseManifest (header <> "a.pgm,1,2,0,\n")
      `shouldBe` Right [Entry "a.pgm" (Just (SensorPose 1 2 0)) Nothing]
    parseManifest "file,x_mm,y_mm\na.pgm,1,2\n"
      `shouldBe` Right [Entry "a.pgm" (Just (SensorPose 1 2 0)) Nothing]
    for_ [["x_mm"], ["y_mm", "rotation_deg"], ["rotation_deg"]] $ \columns ->
      parseManifest (encodeUtf8 (Text.intercalate "," ("file" : columns)) <> "\na.pgm,1,2\n")
        `shouldBe` Left (WrongHeader ("file" : columns))
  it "semicolons also separate fields; the header may be in capitals and in any order" $ do
    parseManifest "Y_MM;X_MM; File ;ROTATION_DEG\r\n2;1;a,b.pgm;0\r\n"
      `shouldBe` Right [Entry "a,b.pgm" (Just (SensorPose 1 2 0)) Nothing]
    parseManifest "file;x_mm;y_mm;rotation_deg\na.pgm;1,5;2;0\n"
      `shouldBe` Left (BadNumber 2 "x_mm" "1,5")
    parseManifest "file,x_mm,y_mm,rotation_deg\na.pgm,1,5,2,0\n"
      `shouldBe` Left (WrongFieldCount 2 5 4)
  it "UTF-16 is named in the refusal, with its byte order mark and without" $ do
    let wide = B.concatMap (\byte -> B.pack [byte, 0])
        swapped = B.concatMap (\byte -> B.pack [0, byte])
        text = header <> "a.pgm,1,2,0,3\n"
    for_ [wide text, "\xff\xfe" <> wide text, swapped text, "\xfe\xff" <> swapped text] $ \file ->
      parseManifest file `shouldBe` Left (ManifestInEncoding Utf16)
  it "parseManifest (renderManifest entries) = entries" $
    forAll (listOf1 genEntry) $ \entries -> parseManifest (renderManifest entries) === Right entries
  it "reads the example of the design" $
    parseManifest "file,x_mm,y_mm,rotation_deg,force_n\nf0.pgm,12.7,-3.5,180,9.81\n"
      `shouldBe` Right [Entry "f0.pgm" (Just (SensorPose 12.7 (-3.5) 180)) (Just 9.81)]
  it "skips a byte order mark, carriage returns and blank lines" $
    parseManifest "\xef\xbb\xbf\&file,x_mm,y_mm,rotation_deg,force_n\r\n\r\na b.pgm,1,2,0,3\r\n\n"
      `shouldBe` Right [Entry "a b.pgm" (Just (SensorPose 1 2 0)) (Just 3)]
  it "takes a quoted name with commas and quotes" $
    parseManifest (header <> "\"a,\"\"b\"\".pgm\",1,2,0,3")
      `shouldBe` Right [Entry "a,\"b\".pgm" (Just (SensorPose 1 2 0)) (Just 3)]
  it "names the line, counting blank ones, and the field that is not a finite number" $ do
    parseManifest (header <> "a,1,2,0,3\n\nb,1,two,0,3\n")
      `shouldBe` Left (BadNumber 4 "y_mm" "two")
    parseManifest (header <> "a,1,2,NaN,3\n") `shouldBe` Left (BadNumber 2 "rotation_deg" "NaN")
    parseManifest (header <> "a,Infinity,2,0,3\n") `shouldBe` Left (BadNumber 2 "x_mm" "Infinity")
    parseManifest (header <> "a,1,2,0,1e999999999\n")
      `shouldBe` Left (BadNumber 2 "force_n" "1e999999999")
    parseManifest (header <> "a,1,2,,3\n") `shouldBe` Left (BadNumber 2 "rotation_deg" "")
    parseManifest (header <> "a,1 2,2,0,1\n") `shouldBe` Left (BadNumber 2 "x_mm" "1 2")
  it "names the line with the wrong number of fields" $ do
    parseManifest (header <> "a,1,2,0\n") `shouldBe` Left (WrongFieldCount 2 4 5)
    parseManifest (header <> "a,1,2,0,3\nb,1,2,0,3,4\n") `shouldBe` Left (WrongFieldCount 3 6 5)
  it "refuses a file name that is empty, has a NUL or is not UTF-8" $ do
    parseManifest (header <> ",1,2,0,3\n") `shouldBe` Left (BadFileName 2)
    parseManifest (header <> "\xff,1,2,0,3\n") `shouldBe` Left (BadFileName 2)
    parseManifest (header <> "f1.pgm\0,1,2,0,3\n") `shouldBe` Left (BadFileName 2)
  it "refuses another header, an empty file and one without frames" $ do
    parseManifest "file,x_mm,y_mm,rotation,force_n\n"
      `shouldBe` Left (WrongHeader ["file", "x_mm", "y_mm", "rotation", "force_n"])
    parseManifest "" `shouldBe` Left EmptyManifest
    parseManifest " \n" `shouldSatisfy` isLeft
    parseManifest header `shouldBe` Left NoEntries
  it "refuses an unclosed quote, although the CSV library throws for one that ends the line" $ do
    parseManifest (header <> "\"") `shouldBe` Left (NotCsv 2)
    parseManifest (header <> "a,1,2,0,\"\n") `shouldBe` Left (NotCsv 2)
    parseManifest "\"" `shouldBe` Left (NotCsv 1)
  it "answers any bytes, especially quotes and commas" $
    withMaxSuccess 2000 $
      forAll ((,) <$> elements ["", header] <*> genBytes) $ \(start, rest) ->
        either (const True) (not . null) (parseManifest (start <> rest))
  where
    header = "file,x_mm,y_mm,rotation_deg,force_n\n"
    genBytes = B.pack <$> listOf (frequency [(2, arbitrary), (1, elements (B.unpack "\",\n\r1a "))])
    genEntry =
      Entry <$> genName
        <*> (Just <$> (SensorPose <$> finite <*> finite <*> finite))
        <*> oneof [Just <$> finite, pure Nothing]
    finite = arbitrary :: Gen Double
    genName = listOf1 (frequency [(5, choose ('a', 'z')), (1, elements " ,\"'.;/\233\8364#")])
