-- | Tests faces that lie at any angle, and arrangements of symbols that are not the array's.
module Test.Recognition.AnyAngle (spec) where

import Data.Either (isRight)
import Data.Foldable (for_)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, mapMaybe)
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Array
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Composite.Lattice
import PraTactile.Composite.Skew
import PraTactile.Field (KnownField)
import PraTactile.Geometry (symbolThickness)
import PraTactile.Image
import PraTactile.Object.Placement
import PraTactile.Recognise
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Recognition (preferred)
import PraTactile.Registration
  ( AlternativeLayout (..),
    Composite (..),
    CompositeFrame (..),
    Contradiction (..),
    LayoutCause (..),
    compositeOf,
    compositePosition,
  )
import PraTactile.Relief
import PraTactile.Segmentation (SymbolImage (..), onComposite)
import PraTactile.Sensor (HeightMap (..))
import PraTactile.Sensor.Frame (Motion (..), movePoint, taxelPitch)
import PraTactile.Sensor.Manifest (axesNamed, straight)
import PraTactile.Symmetry
import Test.Code.Locate.OtherPolynomials
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (classes, generate, tolerance)
import Test.Recognition.Setting
import Test.Recognition.Symbols

spec :: Spec
spec = do
  describe "the skew of a composite" skewSpec
  describe "a composite set upright" uprightSpec
  describe "the skew of symbols on a grid" gridSpec
  describe "symbols read as they are, or set upright" preferredSpec
  onPaper $ \setting -> do
    describe "a face at any angle" (angleSpec setting)
    describe "what is none of the array's" (foreignSpec setting)

gridSpec :: Spec
gridSpec = do
  prop "is that of the symbols without an image's, wherever they lie and in any rotation" $
    forAll (choose (-44, 44)) $ \angle ->
      forAll (elements rotations) $ \way ->
        near 1e-6 angle (gridSkew Nothing (gridOf way angle (3, 4)))
  prop "equals the image's angle if the symbols have the same angle" $
    forAll (choose (-44, 44)) $ \angle ->
      near 1e-6 angle (gridSkew (Just angle) (gridOf identity angle (2, 2)))
  prop "of a single symbol, which has no angle, is the image's" $
    forAll (choose (-44, 44)) $ \angle ->
      near 1e-3 angle (gridSkew (Just angle) (gridOf identity 0 (1, 1)))
        .&&. gridSkew Nothing (gridOf identity angle (1, 1)) === 0
  it "follows many symbols against the image, and the image against two symbols" $ do
    gridSkew (Just 0) (gridOf identity 6 (4, 5)) `shouldSatisfy` (\a -> a > 5 && a <= 6)
    gridSkew (Just 0) (gridOf identity 3.6 (1, 2)) `shouldSatisfy` (\a -> a >= 0 && a < 1.8)
  where
    near most wanted found = counterexample (show found) (abs (found - wanted) < most)

-- | This many rows and columns of symbols on their grid, seen in a rotation, turned clockwise by
-- that angle about a place.
gridOf :: Symmetry -> Double -> (Int, Int) -> FaceGrid
gridOf way angle (rowCount, columnCount) =
  FaceGrid (Map.fromList (zipWith symbol [0 ..] cells)) [] [] (0, 0)
  where
    cells = [(i, j) | i <- [0 .. rowCount - 1], j <- [0 .. columnCount - 1]]
    symbol n (i, j) =
      ((i, j), [readSymbol way n (turnedBy (along (fromIntegral j) (fromIntegral i)))])
    -- Cells are counted along the symbols' axes.
    along j i = onOffset (if exchangesAxes way then turned 1 else identity) (16 * j, 20 * i)
    turnedBy (x, y) =
      let (c, s) = (cos (angle * pi / 180), sin (angle * pi / 180))
       in (31 + c * x - s * y, 17 + s * x + c * y)

-- | A symbol of class 0, seen in that rotation at a place, without any doubt.
readSymbol :: Symmetry -> Int -> (Double, Double) -> ReadSymbol
readSymbol way n at = symbolOf n at (way, 0)

preferredSpec :: Spec
preferredSpec =
  prop "the only answer wins (as given: up to 7 degrees), else the reading with less doubt" $
    forAll (oneof [choose (-12, 12), elements [7, -7, 7.001, -7.001, 0]]) $ \angle ->
      forAll ((,) <$> genReading <*> genReading) $ \(asGiven, setRight) ->
        let surer = product (fst setRight) < product (fst asGiven)
            second = case (isRight (snd asGiven), isRight (snd setRight)) of
              (False, True) -> True
              (True, False) | abs angle <= 7 -> False
              _ -> surer
         in preferred angle (reading asGiven) (reading setRight)
              === reading (if second then setRight else asGiven)
  where
    -- Products are equal only for equal doubts in the same order: 0.1 three times is 1e-3 only up
    -- to rounding.
    genReading = do
      doubts <- sort <$> (choose (0, 4) >>= (`vectorOf` elements [1e-7, 1e-3, 0.3, 0.5]))
      answer <- elements [Left NoSymbols, Right (Several identity [])]
      pure (doubts :: [Double], answer)
    reading (doubts, answer) =
      Recognition (zipWith doubtful [0 ..] doubts) [] Map.empty (0, 0) Nothing Nothing 0 answer
    doubtful n doubt =
      (readSymbol identity n (0, 0))
        { readChances = [((identity, 0), 1 - doubt), ((identity, 1), doubt)]
        }

skewSpec :: Spec
skewSpec = do
  it "of a straight edge is the edge's angle, within half a degree (3 degrees near upright)" $
    for_ [-42, -38 .. 42] $ \angle ->
      for_ [-3.3, 0, 2.7] $ \away ->
        skew [compositeOf (edge angle away)]
          -- Near upright, the rows and columns of pixels draw the line.
          `shouldSatisfy` maybe False ((< if abs angle < 4 then 3 else 0.5) . abs . subtract angle)
  it "is Nothing where nothing changes, or where the image is too small" $
    for_ [constant 30 30 0, constant 30 30 0.7, constant 2 9 0, constant 0 0 0] $ \image ->
      skew [compositeOf image] `shouldBe` Nothing
  prop "is the same up to a quarter turn however the image lies" $
    forAll (choose (-40, 40)) $ \angle ->
      forAll (elements rotations) $ \symmetry ->
        let seen = skew . pure . compositeOf
            image = edge angle 1.3
         in counterexample (show (seen image, seen (onRaster symmetry image))) $
              maybe False (< 0.3) (apart <$> seen image <*> seen (onRaster symmetry image))
  where
    -- A ramp one taxel wide, across a line at an angle and at a distance from the image's middle.
    edge angle away =
      generate 36 30 $ \x y ->
        let (c, s) = (cos (angle * pi / 180), sin (angle * pi / 180))
            across = c * (fromIntegral y - 14.5) - s * (fromIntegral x - 17.5) - away
         in max 0 (min 1 (across + 0.5))
    apart a b = let d = abs (a - b) in min d (abs (90 - d)) :: Double

uprightSpec :: Spec
uprightSpec = do
  it "by quarter turns has the same pixels, turned" $
    for_ [(90, 1), (180, 2), (270, 3)] $ \(angle, quarters) -> do
      let (upright, _) = setUpright angle composite
      rasterDistance
        (compositeImage upright)
        (compositeImage (onComposite (turned (4 - quarters)) composite))
        `shouldSatisfy` (< 1e-9)
  prop "shows at each place what the original shows there, by the robot's sense of angles" $
    forAll (choose (-180, 180)) $ \angle ->
      forAll ((,) <$> choose (0, 11) <*> choose (0, 8)) $ \(x, y) ->
        let (upright, back) = setUpright angle composite
            robot = compositePosition composite (x, y)
            there = movePoint (Motion (negate angle) 0 0) robot
            (ox, oy) = compositeOrigin upright
            pixel = ((fst there - ox) / taxelPitch, (snd there - oy) / taxelPitch)
            (x', y') = back pixel
         in counterexample (show (pixel, (x', y'))) $
              abs (x' - x) < 1e-9 && abs (y' - y) < 1e-9
                && inside (compositeImage upright) pixel
  where
    composite =
      (compositeOf (generate 12 9 (\x y -> fromIntegral ((7 * x + 5 * y * y) `mod` 11) / 11)))
        { compositeOrigin = (31.5, -12.25)
        }
    inside image (u, v) =
      u > -0.5 && v > -0.5
        && u < fromIntegral (rasterWidth image) - 0.4
        && v < fromIntegral (rasterHeight image) - 0.4
    rasterDistance a b = either (const (1 / 0)) biggest (zipRaster (\u v -> abs (u - v)) a b)
    biggest image = fromMaybe 0 (maximumValue image)

angleSpec :: KnownField k => Setting k -> Spec
angleSpec setting =
  withCases 3 30 $
    prop "is read: object, face, place, and the angle to two degrees" $
      forAllShow (elements faces) (show . laidFace . fst) $ \(face, heights) ->
        forAll (choose (0, 360)) $ \angle ->
          forAll ((,) <$> choose (0, 1) <*> choose (0, 1)) $ \shares ->
            let motion = motionOf face angle shares
                recognition = recognise reader (compositeOf (felt (reliefHeights heights) motion))
             in counterexample (either show (show . recognisedAnswer) recognition) $
                  either (const False) (isTrue face motion angle) recognition
  where
    reader = recogniserOf setting
    faces = facesFelt setting
    (wide, high) = (40, 52) :: (Int, Int)
    -- From the pixels' coordinates, in millimetres, to the face's. The middle of the image lies on
    -- the face at these shares, far enough from its sides that a whole window is seen.
    motionOf face angle (u, v) = Motion (negate angle) (atX - midX) (atY - midY)
      where
        (fw, fh) = spotMillimetres (laidExtent face)
        room side = max 0 (side - 62 * taxelPitch)
        atX = fw / 2 + (u - 0.5) * room fw
        atY = fh / 2 + (v - 0.5) * room fh
        (midX, midY) = movePoint (Motion (negate angle) 0 0) (middle wide, middle high)
    middle side = taxelPitch * (fromIntegral side - 1) / 2
    -- The mean height under each pixel, from 4 x 4 points.
    felt (HeightMap pitch _ values _) motion =
      generate wide high $ \i j ->
        sum
          [ maybe 0 (/ symbolThickness) (index values (floor (x / pitch)) (floor (y / pitch)))
            | b <- quarters,
              a <- quarters,
              let (x, y) =
                    movePoint
                      motion
                      (taxelPitch * (fromIntegral i + a), taxelPitch * (fromIntegral j + b))
          ]
          / 16
    quarters = [-0.375, -0.125, 0.125, 0.375] :: [Double]
    isTrue face motion angle recognition = case recognisedAnswer recognition of
      Right (Found found)
        | OnFace place <- windowWhereabouts window ->
          let (x, y) = spotMillimetres (placeCentre place)
              (u, v) = windowSeenAt window
              (x', y') = movePoint motion (taxelPitch * u, taxelPitch * v)
              turnedTo = recognisedAngle recognition (foundOrientation found)
           in placeFace place == laidFace face
                && abs (x - x') < 3
                && abs (y - y') < 3
                && abs (remainder (turnedTo - angle)) < 2
                && all (axisFits angle) (recognisedSymbols recognition)
        where
          window = foundWindow found
      _ -> False
    axisFits angle s =
      let off = symbolAxis (readImage s) - angle
       in abs (off - 90 * fromIntegral (round (off / 90) :: Int)) < 3.5
    remainder d = d - 360 * fromIntegral (round (d / 360) :: Int)

foreignSpec :: KnownField k => Setting k -> Spec
foreignSpec setting = do
  it "for four clear symbols has the probability of Bayes' theorem, for each prior" $
    for_ [0.001, 0.005, 0.3] $ \share ->
      for_ [Position 0 0, Position 6 5, Position 14 16] $ \place -> do
        let told = doubtsOfOrigin <$> doubtsOf share (ours 2 2 place)
            -- All 256 contents are equally likely for foreign symbols by chance, and 255 for other
            -- arrays. A symbol of our array is what it seems in 99 % of cases and any symbol in the
            -- others.
            likelihood = (0.99 + 0.01 / 4) ^ (4 :: Int) / 255
            chances = [share / 2 / 256, share / 2 / 255]
            expected = map (/ (sum chances + (1 - share) * likelihood)) chances
        fmap (\told' -> [doubtOfRandom told', doubtOfOtherArrays told']) told
          `shouldSatisfy` maybe False (and . zipWith (\e -> near (1e-3 * e) e) expected)
  it "has probability 0 if its prior is 0" $
    fmap (doubtOfForeign . doubtsOfOrigin) (doubtsOf 0 (ours 2 2 (Position 3 3))) `shouldBe` Just 0
  it "four clear symbols alone are an answer by default, but not with a foreign prior of 0.5" $ do
    answered standardTolerance (ours 2 2 (Position 6 5)) `shouldBe` True
    answered standardTolerance {foreignPrior = 0.5} (ours 2 2 (Position 6 5)) `shouldBe` False
    answered standardTolerance {foreignPrior = 0.5} (ours 3 4 (Position 6 5)) `shouldBe` True
  it
    "another layout with another answer adds doubt by its odds"
    $ do
      let here = ours 3 4 (Position 6 5)
          there = ours 3 4 (Position 2 9)
          among others =
            either (const Nothing) Just $
              recogniseWith
                standardTolerance
                reader
                [(latticed here) {compositeAlternatives = others}]
          told others =
            fmap doubtOfStitching (among others >>= fmap supportDoubts . recognisedSupport)
          oneFrame odds shown = AlternativeLayout OneFrame 1 odds (latticeOf shown)
      told [] `shouldBe` Just 0
      told [oneFrame 0.004 there] `shouldSatisfy` near' 1e-6 (0.004 / 1.004)
      told [oneFrame 0.3 here] `shouldBe` Just 0
      -- A layout without a lattice shows something else.
      told [AlternativeLayout OneFrame 1 0.004 Nothing] `shouldSatisfy` near' 1e-6 (0.004 / 1.004)
      map (fmap isFound . among) [[], [oneFrame 0.004 there], [oneFrame 0.2 there]]
        `shouldBe` [Just True, Just True, Just False]
  it "other axes add doubt by their prior odds, if the array has their symbols as well" $ do
    -- Six columns by frames of two, and as many rows. Along other axes whole frames move.
    let acrossFlipped (x, y) = (negate x, y)
        downFlipped (x, y) = (x, negate y)
        told classes size stated flipped =
          axesDoubt
            [ (latticed classes)
                { compositeAxesStated = stated,
                  compositeFrames =
                    replicate 2 (CompositeFrame (0, 0) (0, 0) (constant 4 4 0) Nothing),
                  compositeLattice = inFrames size id classes,
                  compositeAlternatives =
                    [ AlternativeLayout
                        (OtherAxes acrossNegated)
                        0.4
                        1
                        (inFrames size flipped classes)
                    ]
                }
            ]
        sixColumns = told (ours 4 6 (Position 6 5)) (2, 2) False
    -- The symbols of a frame stay beside each other, which no column mirror of the array has.
    sixColumns downFlipped `shouldSatisfy` maybe False (< 1e-6)
    sixColumns acrossFlipped `shouldSatisfy` maybe False (< 1e-6)
    sixColumns id `shouldBe` Just 0
    -- One frame across for each column: the array is its own column mirror.
    let ofColumns place stated = told (ours 4 3 place) (4, 1) stated acrossFlipped
    -- On one face, and in reverse on several, which lowers no doubt.
    ofColumns (Position 4 7) False `shouldSatisfy` near' 1e-6 (0.004 / 1.004)
    ofColumns (Position 4 7) True `shouldSatisfy` near' 1e-6 (0.001 / 1.001)
    -- On several faces, and in reverse on one, which has 200 times the prior probability.
    ofColumns (Position 4 9) False `shouldSatisfy` near' 1e-6 (0.8 / 1.8)
    ofColumns (Position 4 9) True `shouldSatisfy` near' 1e-6 (0.2 / 1.2)
  it "a strip may have slipped by a cell, unless the array shows that it has not" $ do
    let strip classes x = (compositeOf (drawing classes)) {compositeOrigin = (x * 25.4, 0)}
        between a b = map (take (b - a) . drop a) (ours 4 4 (Position 4 0))
        slip composites = do
          found <- either (const Nothing) Just (recogniseWith standardTolerance reader composites)
          doubtOfSlip . supportDoubts <$> recognisedSupport found
    -- Two columns never check each other. A cell nearer they would be one.
    slip [strip (between 0 1) 0, strip (between 1 2) 1]
      `shouldSatisfy` maybe False (\p -> p > 0.001 && p < 0.002)
    slip [strip (between 0 2) 0, strip (between 2 4) 2] `shouldSatisfy` maybe False (< 1e-5)
    slip [strip (between 0 4) 0] `shouldBe` Just 0
  it "frames that contradict each other are refused, whatever they show" $ do
    let here = compositeOf (drawing (ours 3 4 (Position 6 5)))
        told =
          recogniseWith
            standardTolerance
            reader
            [here {compositeContradiction = Just nowhere}]
        nowhere = AgreeingAnywhere 9 3 2
    fmap recognisedAnswer told `shouldBe` Right (Left (FramesContradict nowhere))
  it "of arrangements of six symbols, half of them foreign, as many are wrong as the doubts say" $
    let count = byEffort 15 100
        byChance = vectorOf 2 (vectorOf 3 (choose (0, 3)))
        ofOthers = do
          other <- elements (byOtherPolynomials array)
          classesOf other 2 3 <$> elements everywhere
        tolerant = standardTolerance {foreignPrior = 0.5, toleratedDoubt = 0.999}
        true = mapMaybe (doubtIn tolerant . ours 2 3) (take (2 * count) everywhere)
     in once . forAllBlind ((++) <$> vectorOf count byChance <*> vectorOf count ofOthers) $
          \arrangements ->
            let located = mapMaybe (doubtIn tolerant) arrangements
                wrong = fromIntegral (length located)
                expected = sum (located ++ true)
             in length true === 2 * count
                  .&&. counterexample
                    (show (wrong, expected))
                    (abs (wrong - expected) <= 5 * sqrt (expected + 1))
  where
    ours = classesOf array
    array = settingArray setting
    reader = recogniserOf setting
    axesDoubt composites = do
      found <- either (const Nothing) Just (recogniseWith standardTolerance reader composites)
      doubtOfAxes . supportDoubts <$> recognisedSupport found
    -- A composite with its lattice, which leaves no doubt of the classes in its cells.
    latticed classes = (compositeOf (drawing classes)) {compositeLattice = latticeOf classes}
    latticeOf classes = inFrames (length classes, length (concat (take 1 classes))) id classes
    -- The lattice under frames of this many rows and columns of cells, each moved as a whole.
    inFrames (high, wide) move classes =
      Just
        Lattice
          { latticeAngle = 0,
            latticeHalfTurned = False,
            latticeOrigin = (4, 4),
            latticeFrames =
              [ (16 * fromIntegral (wide * x) + 8, 20 * fromIntegral (high * y) + 10)
                | frame <- Map.keys (Map.fromList [(frameOf cell, ()) | (cell, _) <- cells]),
                  let (x, y) = move frame
              ],
            latticeFlat = 0,
            latticeContrast = 1,
            latticeCells =
              Map.fromList
                [ ( (high * y + i `mod` high, wide * x + j `mod` wide),
                    Unboxed.generate 4 (\k -> if k == c then 60 else -60)
                  )
                  | ((i, j), c) <- cells,
                    let (x, y) = move (frameOf (i, j))
                ]
          }
      where
        cells = [((i, j), c) | (i, line) <- zip [0 ..] classes, (j, c) <- zip [0 ..] line]
        frameOf :: (Int, Int) -> (Int, Int)
        frameOf (i, j) = (j `div` wide, i `div` high)
    acrossNegated = fromMaybe straight (lookup "-x,y" axesNamed)
    near' tolerance expected = maybe False (near tolerance expected)
    near tolerance expected told = abs (told - expected) < tolerance
    seen tolerance classes =
      either (const Nothing) Just (recogniseWith tolerance reader [compositeOf (drawing classes)])
    doubtsOf share classes =
      supportDoubts
        <$> (seen standardTolerance {foreignPrior = share} classes >>= recognisedSupport)
    answered tolerance = maybe False isFound . seen tolerance
    isFound recognition = case recognisedAnswer recognition of
      Right (Found _) -> True
      _ -> False
    doubtIn tolerance classes = do
      recognition <- seen tolerance classes
      support <- recognisedSupport recognition
      if isFound recognition then Just (supportDoubt support) else Nothing
    drawing = drawingOf (readerAlphabet (settingReader setting)) . asDrawn
