-- | Tests poses: fits against truths made of exact rotations, their covariance against the spread
-- of draws, the blurred relief against its shape, and presses of the simulated sensor.
module Test.Recognition.PosesByConstruction
  ( spec,
  )
where

import Control.Monad (replicateM)
import Data.Foldable (for_)
import Data.List (transpose)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import PraTactile.Array (PseudorandomArray, Shape (Shape))
import PraTactile.Evaluate (PoseError (..), PoseTally (..), poseTally)
import PraTactile.Explore
  ( ProbedRegion (..),
    Turns (..),
    regionCorner,
    regionExtent,
    regionMotion,
    regionTurn,
  )
import PraTactile.Field (KnownField)
import PraTactile.Object.Canonical (canonicalPitch, canonicalPlacement)
import PraTactile.Object.Named (Named (..), namedDescription)
import PraTactile.Object.Placement hiding (more)
import PraTactile.Object.Placement.Search
import PraTactile.Object.WingedEdge
import PraTactile.Pose
import PraTactile.Pose.Alignment (Ground (..), heightAt)
import PraTactile.Pressing
import PraTactile.Recognise
import PraTactile.Recognise.FoundPose
import PraTactile.Registration (Composite)
import PraTactile.Registration.Stitching hiding (stitchedBy)
import PraTactile.Sensor (Sensor)
import PraTactile.Sensor.Frame (inverse, movePoint)
import PraTactile.Sensor.Preset
import PraTactile.Shape (area, shapes)
import qualified PraTactile.Symmetry as Symmetry
import PraTactile.Truth (Truth (..), truthFrom)
import qualified PraTactile.Truth as Truth
import Test.Effort (byEffort, whenFull)
import Test.Hspec hiding (fit)
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (total)
import Test.Recognition.Scenes (onRecognisers)
import Test.Solid.Drilled (drilledWith, plateOf)
import Test.Support
import Test.Touch.Paper (paperAlphabet, stitchedBy)

-- | A rotation and a translation of exact numbers.
type Exact = ([[Rational]], [Rational])

onPoint :: Exact -> [Rational] -> [Rational]
onPoint (rows, by) v = zipWith (+) by (map (sum . zipWith (*) v) rows)

-- | The rotation of a quaternion of whole numbers.
genRotation :: Gen [[Rational]]
genRotation = do
  a <- number
  b <- number
  c <- number
  d <- number `suchThat` \d -> any (/= 0) [a, b, c, d]
  pure (rotationBy a (b, c, d))
  where
    number = fromInteger <$> choose (-9, 9)

-- | The rotation of the quaternion with this real part and vector, not all 0.
rotationBy :: Rational -> (Rational, Rational, Rational) -> [[Rational]]
rotationBy a (b, c, d) =
  map
    (map (/ (a * a + b * b + c * c + d * d)))
    [ [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
      [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
      [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d]
    ]

-- | A quaternion's positive real part and its vector: small numbers scaled by these factors.
genPart :: Integer -> Integer -> Gen (Rational, (Rational, Rational, Rational))
genPart real imaginary =
  (,)
    <$> (fromInteger . (real *) <$> choose (1, 9))
    <*> ((,,) <$> part <*> part <*> part) `suchThat` (/= (0, 0, 0))
  where
    part = fromInteger . (imaginary *) <$> choose (-9, 9)

-- | A turn of the robot's plane, from x to y.
genTurn :: Gen [[Rational]]
genTurn = do
  (m, n) <- ((,) <$> choose (-20, 20) <*> choose (-20, 20)) `suchThat` (/= (0, 0))
  let (a, b) = (fromInteger m, fromInteger n)
      (c, s) = ((a * a - b * b) / (a * a + b * b), 2 * a * b / (a * a + b * b))
  pure [[c, -s, 0], [s, c, 0], [0, 0, 1]]

genLength :: Gen Rational
genLength = (\a -> fromInteger a / 16) <$> choose (-2000, 2000)

-- | A face at some pose in an object's frame and in the robot's plane, and points of it.
data Lying = Lying
  { -- | from the face's frame to the object's, and to the robot's
    lyingInObject :: Exact,
    lyingInPlane :: Exact,
    -- | as walked; the first is at the origin of the face's frame and the last on its x axis
    lyingCorners :: [[Rational]],
    lyingPoints :: [[Rational]]
  }
  deriving stock (Show)

genLying :: Gen Lying
genLying = do
  inObject <- (,) <$> genRotation <*> replicateM 3 genLength
  inPlane <- (,) <$> genTurn <*> ((\x y -> [x, y, 0]) <$> genLength <*> genLength)
  wide <- abs <$> genLength `suchThat` (/= 0)
  high <- abs <$> genLength `suchThat` (/= 0)
  count <- choose (2, 12)
  points <- replicateM count ((\x y -> [x, y, 0]) <$> genLength <*> genLength)
  let apart = [sum (map (^ (2 :: Int)) (zipWith (-) p q)) | p : _ <- [points], q <- points]
  if maximum apart < 1
    then genLying
    else
      pure
        Lying
          { lyingInObject = inObject,
            lyingInPlane = inPlane,
            lyingCorners = [[0, 0, 0], [0, high, 0], [wide, high, 0], [wide, 0, 0]],
            lyingPoints = points
          }

-- | The face's frame by the object's corners.
frameOf' :: Lying -> Maybe RigidMotion
frameOf' lying =
  faceFrame (map (point . onPoint (lyingInObject lying)) (lyingCorners lying))
  where
    point v = case v of
      [a, b, c] -> Point a b c
      _ -> Point 0 0 0

-- | The true pose: back into the face's frame, and on into the robot's.
truePose :: Lying -> RigidMotion
truePose lying = RigidMotion (map (map fromRational) rows) (map fromRational by)
  where
    (toObject, from) = lyingInObject lying
    (turn, at) = lyingInPlane lying
    rows = [[sum (zipWith (*) line column) | column <- toObject] | line <- turn]
    by = zipWith (-) at (map (sum . zipWith (*) from) rows)

-- | The points as seen, each off by this displacement, with a covariance.
seenAs :: Lying -> [((Double, Double), [[Double]])] -> [Seen]
seenAs lying = zipWith one (lyingPoints lying)
  where
    one p ((dx, dy), covariance) =
      let (x, y) = flat (onPoint (lyingInPlane lying) p)
       in Seen (flat p) (x + dx, y + dy) covariance
    flat v = case map fromRational v of
      x : y : _ -> (x, y)
      _ -> (0, 0)

-- | A covariance L L^T and its L.
genSpread :: Gen ([[Double]], [[Double]])
genSpread = do
  a <- choose (0.05, 0.5)
  c <- choose (0.05, 0.5)
  b <- choose (-0.3, 0.3)
  pure ([[a * a, a * b], [a * b, b * b + c * c]], [[a, 0], [b, c]])

-- | Two independent normal numbers, by Box and Muller.
genNormals :: Gen (Double, Double)
genNormals = do
  u <- choose (1e-12, 1)
  v <- choose (0, 2 * pi)
  pure (sqrt (-2 * log u) * cos v, sqrt (-2 * log u) * sin v)

farthest :: [Double] -> [Double] -> Double
farthest a b = maximum (0 : map abs (zipWith (-) a b))

entries :: RigidMotion -> [Double]
entries (RigidMotion rows by) = concat rows ++ by

spec :: Spec
spec = do
  it "the squared distance in units of the covariance has mean 3 over many draws" $
    let count = byEffort 200 1000
     in once . forAll (replicateM count drawnDistance) $ \distances ->
          -- The variance of chi-square with three degrees of freedom is 6.
          let mean = sum distances / fromIntegral count
           in counterexample (show mean) (abs (mean - 3) < 5 * sqrt (6 / fromIntegral count))
  prop "the covariance is that of a motion within the plane: of rank 3" $
    forAll genLying $ \lying ->
      forAll (traverse (const (fst <$> genSpread)) (lyingPoints lying)) $ \spreads ->
        case poseOf <$> frameOf' lying <*> rigidFit (seenAs lying (map ((,) (0, 0)) spreads)) of
          Nothing -> counterexample "no pose" False
          Just pose ->
            let c = poseCovariance pose
             in conjoin
                  [ map (c !!) [2, 3, 4] === replicate 3 (replicate 6 0),
                    property (farthest (concat c) (concat (transpose c)) < 1e-9),
                    fmap (< 1e-9) (poseDistance (poseMotion pose) pose) === Just True
                  ]
  prop "two poses differ by a translation and a rotation vector, up to nearly half a turn" $
    forAll ((,,) <$> genRotation <*> replicateM 3 genLength <*> replicateM 3 genLength) $
      \(rows, from, to) ->
        forAll (elements [(1, 1), (1, 100000), (100000, 1)] >>= \(s, c) -> genPart s c) $
          \(real, axis@(x, y, z)) ->
            let further = rotationBy real axis
                turned = [[sum (zipWith (*) line c) | c <- transpose rows] | line <- further]
                motion lines' at = RigidMotion (map (map fromRational) lines') (map fromRational at)
                size = sqrt (fromRational (x * x + y * y + z * z)) :: Double
                angle = 2 * atan2 size (fromRational real)
                wanted =
                  zipWith (\a b -> fromRational (a - b)) to from
                    ++ [angle * fromRational part / size | part <- [x, y, z]]
             in farthest wanted (poseDifference (motion turned to) (Pose (motion rows from) []))
                  < 1e-9 * min 1 angle
  prop "taxel heights at a shift add up to the shape's area; their gradients are the differences" $
    forAll ((,) <$> choose (0, 1) <*> choose (0, 1)) $ \(u, v) ->
      conjoin
        [ conjoin
            [ let total = sum [h | (h, _, _) <- mapMaybe (at u v) cellPlaces]
               in property (abs (total - fromIntegral (area shape)) < 1e-4),
              conjoin
                [ abs (a - (hx' - hx) / 2e-4) < 1e-2 && abs (b - (hy' - hy) / 2e-4) < 1e-2
                  | place <- cellPlaces,
                    Just (_, a, b) <- [at u v place],
                    Just (hx', _, _) <- [at (u + 1e-4) v place],
                    Just (hx, _, _) <- [at (u - 1e-4) v place],
                    Just (hy', _, _) <- [at u (v + 1e-4) place],
                    Just (hy, _, _) <- [at u (v - 1e-4) place]
                ]
            ]
          | Right known <- [paperAlphabet],
            shape <- shapes known,
            let ground = Ground (3, -5) (Map.singleton (0, 0) shape)
                at x y (i, j) = heightAt ground (3 + fromIntegral i + x, fromIntegral j + y - 5)
        ]
  prop "half of the errors are at most the median, half at least; the shares count distances" $
    forAll (listOf1 (PoseError <$> choose (0, 9) <*> choose (0, 9) <*> choose (0, 12))) $ \errors ->
      let half test = 2 * length (filter test errors) >= length errors
          share bound = length (filter ((<= bound) . poseErrorDistance) errors)
          shares counted = [poseWithin50 counted, poseWithin95 counted]
       in case poseTally errors of
            Nothing -> counterexample "no tally" False
            Just counted ->
              conjoin
                [ property (half ((<= poseMedianFar counted) . poseErrorFar)),
                  property (half ((>= poseMedianFar counted) . poseErrorFar)),
                  property (half ((<= poseMedianTurned counted) . poseErrorTurned)),
                  property (half ((>= poseMedianTurned counted) . poseErrorTurned)),
                  map (round . (fromIntegral (length errors) *)) (shares counted)
                    === map share [2.366, 7.8147]
                ]
  -- Faces had no pose where a placement began them at another vertex than their object's own list.
  for_ (plate : [(show one, namedDescription one) | one <- someSolids]) $ \(known, it') ->
    it (known ++ ": begun at any of its vertices, each face has its true pose") $ do
      body <- right (solid it')
      let Pitch right' down = canonicalPitch
          pitch = Pitch (right' / 4) (down / 4)
          faces =
            [ Wanted (Face (solidName body) (FaceName walk)) AsNamed
              | FaceName name <- solidFaces body,
                walk <- rotationsOf name
            ]
      for_ faces $ \wanted -> case layingsOf 1 (Shape 99 99) pitch [] [body] [wanted] of
        LaidSo layings -> do
          layout <- right (placement (Shape 99 99) pitch [body] layings)
          for_ (laidFaces layout) $ \laid ->
            for_ regions $ \region -> do
              let truth = Truth (laidFace laid) region (40, -25) Nothing
                  own = Face (solidName body) . FaceName
                  others = map own (rotationsOf (map fst (laidCorners laid)))
              true <- maybe (fail "no pose") pure (Truth.truePose layout truth)
              motionRows true `shouldSatisfy` isRotation
              for_ (laidCorners laid) $ \(vertex, spot) -> do
                let (x, y) = movePoint (inverse (regionMotion region)) (spotMillimetres spot)
                there <- maybe (fail "no vertex") pure (lookup vertex (solidVertices body))
                moved true (coordinates there)
                  `shouldSatisfy` ((< 1e-6) . farthest [x + 40, y - 25, 0])
              -- Named from another vertex, it is the same truth.
              for_ others $ \other ->
                fmap entries (Truth.truePose layout (truthFrom layout other truth))
                  `shouldSatisfy` maybe False ((< 1e-6) . farthest (entries true))
        found -> expectationFailure (show (wanted, found))
  onRecognisers $ \array readers -> do
    it "ideal presses at any angle: the median is within 0.05 mm and 0.02 degrees" $ do
      let count = byEffort 1 12
      errors <- presses array (map snd (take 1 readers)) idealSensor Nothing count
      length errors `shouldBe` count
      median (map (\(far, _, _) -> far) errors) `shouldSatisfy` (< 0.05)
      median (map (\(_, degrees, _) -> degrees) errors) `shouldSatisfy` (< 0.02)
    it "noisy presses by an inexact robot: errors are as large as the covariance says" $ do
      let (count, missed, far) = byEffort (2, 1, 0) (24, 2, 2)
      errors <- presses array (map snd (take 1 readers)) standardSensor (Just 1) count
      length errors `shouldSatisfy` (>= count - missed)
      let distances = map (\(_, _, distance) -> distance) errors
      -- 99 % of chi-square with three degrees of freedom is below 11.3.
      length (filter (< 11.3) distances) `shouldSatisfy` (>= length errors - far)
      -- A mean of few means little.
      whenFull $
        sum distances / fromIntegral (length distances) `shouldSatisfy` (\m -> m > 1 && m < 6)
  where
    moved (RigidMotion rows by) p =
      zipWith (+) by (map (sum . zipWith (*) (map fromRational p)) rows)
    drawnDistance = do
      lying <- genLying
      spreads <- traverse (const genSpread) (lyingPoints lying)
      off <- traverse drawnOff spreads
      let pose = poseOf <$> frameOf' lying <*> rigidFit (seenAs lying off)
      case pose >>= poseDistance (truePose lying) of
        -- A few points close together determine the angle so badly that it is not small.
        Just distance | wide lying -> pure distance
        _ -> drawnDistance
    wide lying =
      maximum
        [ sum (map (^ (2 :: Int)) (zipWith (-) p q))
          | p <- lyingPoints lying,
            q <- lyingPoints lying
        ]
        > 400
    drawnOff (covariance, l) = do
      (a, b) <- genNormals
      pure $ case map (sum . zipWith (*) [a, b]) l of
        [x, y] -> ((x, y), covariance)
        _ -> ((0, 0), covariance)
    rotationsOf walk = [take (length walk) (drop k (cycle walk)) | k <- [0 .. length walk - 1]]
    coordinates (Point a b c) = [a, b, c]
    regions =
      [ ProbedRegion 3 5 40 52 (Symmetry.turned 1) 0,
        ProbedRegion (-2) 7 40 52 (Symmetry.turned 2) (-31)
      ]
    isRotation lines' =
      farthest
        (concat [[sum (zipWith (*) a b) | b <- lines'] | a <- lines'])
        [1, 0, 0, 0, 1, 0, 0, 0, 1]
        < 1e-9
        && abs (determinant lines' - 1)
        < 1e-9
    determinant lines' = case lines' of
      [[a, b, c], [d, e, f], [g, h, i]] ->
        a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
      _ -> 0
    cellPlaces = [(i, j) | i <- [1 .. 14], j <- [1 .. 18]] :: [(Int, Int)]

-- | A plate whose faces have holes.
plate :: (String, Description)
plate =
  ( "a plate with two holes",
    plateOf (drilledWith 20 (160, 90) [(20, 40, 50, 70), (80, 40, 99, 60)])
  )

-- | The solids that a run takes.
someSolids :: [Named]
someSolids = byEffort [Cube, Pyramid 150 120 90, Prism 7 60 50, LShape 90 60 120] twentySolids

-- | Two of each kind that has lengths, and the paper's. A face of each is long, oblique, or no
-- rectangle.
twentySolids :: [Named]
twentySolids =
  [ Cube,
    Parallelepiped,
    Box 60 90 40,
    Box 33 (127 / 4) 120,
    Pyramid 150 120 90,
    Pyramid 60 60 200,
    Prism 3 60 50,
    Prism 6 40 90,
    Prism 7 60 50,
    Tetrahedron 100,
    Tetrahedron 77,
    Octahedron 55,
    Octahedron (200 / 3),
    Pyritohedron 60,
    Pyritohedron 81,
    LShape 90 60 120,
    LShape 160 30 60,
    Frame 90 120 40,
    Frame 200 99 20,
    Sheet 90 60
  ]

median :: [Double] -> Double
median values = case drop (length values `div` 2) (ordered values) of
  m : _ -> m
  [] -> 1 / 0
  where
    ordered [] = []
    ordered (p : more) = ordered (filter (< p) more) ++ p : ordered (filter (>= p) more)

-- | Errors of the answered presses at any angle: the distance of the region's middle from the
-- pose's, mm; that of the angle, degrees; and the squared distance by the covariance.
presses ::
  KnownField k =>
  PseudorandomArray k ->
  [Recogniser k] ->
  Sensor ->
  Maybe Double ->
  Int ->
  IO [(Double, Double, Double)]
presses array readers sensor told count = do
  layout <- right canonicalPlacement
  known <- right paperAlphabet
  made <- sequence [one layout known reader seed | reader <- readers, seed <- [1 .. count]]
  pure (concat made)
  where
    one layout known reader seed = do
      let how =
            (pressingWith sensor seed)
              { pressingTurns = TurnedBy (fromIntegral ((seed * 137) `mod` 360) + 0.37),
                pressingOrigin = (40, -25)
              }
          named = ObjectName (if even seed then "cube" else "parallelepiped")
      (frames, truth) <- right (pressed how known array layout named)
      composite <- right (stitchedBy standardStitching {stitchingPositionError = told} frames)
      recognition <- right (recognise reader composite)
      true <- right (truthOf layout truth)
      fmap ((< 1e-9) . farthest (entries true) . entries) (Truth.truePose layout truth)
        `shouldBe` Just True
      pure
        [ (sqrt (sum (map (^ (2 :: Int)) (take 2 middle))), angle, distance)
          | Just (object, pose) <- [posed layout known composite recognition],
            object == named,
            Just distance <- [poseDistance true pose],
            let e = poseDifference true pose
                angle = (180 / pi) * sqrt (sum (map (^ (2 :: Int)) (drop 3 e)))
                middle = zipWith (-) (at true) (at (poseMotion pose))
                -- The object's point that is truly at the middle of the region.
                at (RigidMotion rows by) = zipWith (+) by (map (sum . zipWith (*) here) rows)
                here =
                  map
                    (sum . zipWith (*) (zipWith (-) (middleOf truth) (motionBy true)))
                    (transpose (motionRows true))
        ]
    posed layout known composite = foundPose layout known array told [composite :: Composite]
    middleOf truth =
      [ fst (truthOrigin truth) + 1.5875 * fromIntegral (regionWidth (truthRegion truth)) / 2,
        snd (truthOrigin truth) + 1.5875 * fromIntegral (regionHeight (truthRegion truth)) / 2,
        0
      ]

-- | The true pose, by the middle of the region and the angle, and the cosines of a turn.
truthOf :: Placement -> Truth -> Either String RigidMotion
truthOf layout truth = case placementObject layout (faceObject (truthFace truth)) of
  Nothing -> Left "no such object"
  Just body ->
    let corners = map plain (cornerPoints body (faceName (truthFace truth)))
     in case (corners, reverse corners) of
          (origin : next : _, end : _) ->
            let x = unit (zipWith (-) end origin)
                y = unit (zipWith (-) next origin)
                z = [x1 * y2 - x2 * y1 | ((x1, y1), (x2, y2)) <- cyclic x y]
                rows =
                  [ zipWith (\a b -> cosine * a - sine * b) x y,
                    zipWith (\a b -> sine * a + cosine * b) x y,
                    z
                  ]
                (fx, fy) = faceMiddle
                (rx, ry) = robotMiddle
                on = [rx - (cosine * fx - sine * fy), ry - (sine * fx + cosine * fy), 0]
             in Right (RigidMotion rows (zipWith (-) on (map (sum . zipWith (*) origin) rows)))
          _ -> Left "no corners"
  where
    region = truthRegion truth
    turn = regionTurn region * pi / 180
    (cosine, sine) = (cos turn, sin turn)
    half n = 1.5875 * fromIntegral n / 2
    faceMiddle =
      let ((x, y), (w, h)) = (regionCorner region, regionExtent region) in (x + half w, y + half h)
    robotMiddle =
      let (x, y) = truthOrigin truth
       in (x + half (regionWidth region), y + half (regionHeight region))
    plain (Point a b c) = map fromRational [a, b, c] :: [Double]
    -- The faces of the two objects are rectangles, walked down from the upper left.
    unit v = map (/ sqrt (sum (map (^ (2 :: Int)) v))) v
    cyclic x y = drop 1 (take 4 (zip (rotations x) (rotations y)))
    rotations v = zip (cycle v) (drop 1 (cycle v))
