-- | Evaluates the whole method: how often it is right, wrong, or refuses. Simulated presses at
-- random places on the faces in turn are decoded twice from the same frames: with stitching, and
-- with the nominal positions alone.
module PraTactile.Evaluate
  ( -- * Whole experiments
    Experiment (..),
    standardExperiment,
    evaluated,
    evaluatedPoses,
    restingOn,
    assumedStitching,
    ExperimentError (..),

    -- * A trial
    Trial (..),
    Exploration (..),
    exploration,
    Foreign (..),
    trial,
    trials,

    -- * Its results
    Result (..),
    TrialResult (..),
    runTrial,
    PoseError (..),
    PoseTally (..),
    poseTally,

    -- * Counts
    Tally (..),
    tally,
    noResults,
    counting,
    PressResult (..),
    Counts (..),
    countPresses,
    noCounts,
    countingPress,
  )
where

import Control.Monad (when)
import Data.Bifunctor (first, second)
import Data.Either (isRight)
import Data.List (foldl', genericLength, genericTake, sort, unfoldr)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, fromMaybe, listToMaybe)
import Data.Traversable (for)
import qualified Data.Vector as Boxed
import PraTactile.Array
  ( Position (..),
    PseudorandomArray,
    Shape (..),
    arrayFolding,
    arrayPrimitive,
    arrayShape,
    fold,
  )
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Geometry (columnPitch, rowPitch)
import PraTactile.Object.Placement
import PraTactile.Polynomial (primitiveDegree, primitivePolynomials)
import PraTactile.Pose (poseApart, poseDistance)
import PraTactile.Pressing (pressRegion)
import PraTactile.Random (uniform)
import PraTactile.Recognise
import PraTactile.Recognise.FoundPose (foundPose)
import PraTactile.Registration
  ( Composite,
    Registration (..),
    StitchMethod (..),
    compositePosition,
    stitch,
  )
import PraTactile.Registration.Stitching
import PraTactile.Relief
import PraTactile.Sensor
  ( Bend (..),
    Sensor (..),
    drawSpecimen,
    leastRadius,
    sensorTaxelGrid,
  )
import PraTactile.Sensor.Frame (Frame, ProbeError, planScanOf)
import PraTactile.Sequence (canonicalState)
import PraTactile.Shape (Alphabet, alphabetSize)
import PraTactile.Truth
import System.Random (StdGen, mkStdGen, split)

-- | The presses to evaluate, and how they are decoded.
data Experiment = Experiment
  { -- | the number of regions that are explored
    experimentPresses :: Int,
    experimentSeed :: Int,
    experimentExploration :: Exploration,
    -- | the share of presses on foreign surfaces: the array's shapes in another arrangement
    experimentForeign :: Maybe Double,
    -- | the share, of all presses, on arrays by other polynomials. It is part of
    -- 'experimentForeign'; the other foreign arrangements are random.
    experimentForeignArrays :: Double,
    -- | whether decoders get the robot's position error
    experimentTold :: Bool,
    -- | the tolerance of decoders, with 'experimentForeign' as their prior of foreign surfaces
    experimentTolerance :: Tolerance
  }

-- | A thousand regions of the default size with this sensor, on faces that lie upright or upside
-- down, none foreign, answered by 'standardTolerance'.
standardExperiment :: Sensor -> Experiment
standardExperiment sensor =
  Experiment
    { experimentPresses = 1000,
      experimentSeed = 1,
      experimentExploration = exploration sensor (AmongTurns halfTurns) (regionSizeFor sensor),
      experimentForeign = Nothing,
      experimentForeignArrays = 0,
      experimentTold = True,
      experimentTolerance = standardTolerance
    }

-- | Why an experiment is impossible.
data ExperimentError
  = -- | A face has no relief.
    ReliefRefused ReliefError
  | -- | The presses do not cover the region.
    PressesRefused ProbeError
  | -- | The cylinder's radius is not above the sensor's 'leastRadius', in millimetres.
    BendRefused Double
  deriving stock (Eq, Show)

-- | The results of presses on the array's faces in turn, in order and computed lazily.
evaluated ::
  KnownField k =>
  Experiment ->
  PseudorandomArray k ->
  Recogniser k ->
  Either ExperimentError [TrialResult]
evaluated experiment array reader = map fst <$> evaluatedPoses experiment array reader

-- | 'evaluated' with the errors of the pose for right answers with stitching.
evaluatedPoses ::
  KnownField k =>
  Experiment ->
  PseudorandomArray k ->
  Recogniser k ->
  Either ExperimentError [(TrialResult, Maybe PoseError)]
evaluatedPoses experiment array reader = do
  when (any ((<= least) . bendRadius) (explorationBend said)) (Left (BendRefused least))
  faces <- for (laidFaces layout) $ \face ->
    (,) face <$> first ReliefRefused (relief array layout alphabet face)
  _ <-
    first PressesRefused $
      planScanOf (sensorTaxelGrid sensor) (explorationSpacing how) (0, 0) (explorationSize how)
  pure (map decoded (take presses (catMaybes (trials how faces seed))))
  where
    Experiment presses seed said share shareOfArrays told tolerance = experiment
    layout = recogniserPlacement reader
    alphabet = readerAlphabet (recogniserReader reader)
    sensor = explorationSensor said
    least = leastRadius sensor
    how = said {explorationForeign = others <$> share}
    others part =
      Foreign
        { foreignShare = part - shareOfArrays,
          foreignClasses = alphabetSize alphabet,
          foreignRelief = \face ->
            either (const Nothing) Just . reliefOf layout alphabet face (alphabetSize alphabet),
          foreignArrays = shareOfArrays,
          foreignFaces = map classOn (byOtherPolynomials array)
        }
    decoded t =
      second
        (>>= poseError layout alphabet array (stitchingPositionError known) t)
        (ranTrial weighing reader (registrationFor known (trialFrames t)) t)
    known
      | told = assumedStitching sensor
      | otherwise = (assumedStitching sensor) {stitchingPositionError = Nothing}
    weighing = tolerance {foreignPrior = fromMaybe (foreignPrior tolerance) share}

-- | The number of rows and columns of the array beyond a face's block on which the result of a
-- press depends. Arguments: the region's size in taxels, and the array's window.
--
-- An answer with another face is wrong, whatever lies there, and refusals do not depend on the
-- objects. An answer with the true face is right where the composite shows it. Then all felt cells
-- are within the region's diagonal, and the cells of the windows that contain them decide whether
-- it is right.
restingOn :: (Int, Int) -> Shape -> Shape
restingOn (wide, high) window =
  Shape (rows window + across rowPitch) (columns window + across columnPitch)
  where
    across pitch = 1 + ceiling (diagonal / pitch)
    diagonal = sqrt (fromIntegral (wide * wide + high * high)) :: Double

-- | The arrays of the same shape by the first 1024 other primitive polynomials of the degree.
byOtherPolynomials :: KnownField k => PseudorandomArray k -> [PseudorandomArray k]
byOtherPolynomials array =
  [ other
    | Right found <- [primitivePolynomials (fromIntegral (primitiveDegree own))],
      h <- take 1024 (filter (/= own) found),
      Right other <- [fold (arrayFolding array) (arrayShape array) h (canonicalState h)]
  ]
  where
    own = arrayPrimitive array

-- | The settings of stitching for a sensor and its robot: the position error, and the noise of a
-- reading at full scale, including the differences between elements.
assumedStitching :: Sensor -> Stitching
assumedStitching sensor =
  Stitching
    { stitchingMethod = Automatic,
      stitchingPositionError = Just (sensorPositionError sensor),
      stitchingNoise = Just assumed
    }
  where
    assumed
      | slope <= 0 && spread <= 0 = noise
      | otherwise = sqrt ((noise + slope) ** 2 + (spread / 2) ** 2)
    noise = sensorNoise sensor
    slope = sensorNoiseSlope sensor
    spread = sensorGainSpread sensor

-- | One exploration with known truth.
data Trial = Trial
  { trialFace :: LaidFace,
    trialRegion :: ProbedRegion,
    trialFrames :: [Frame],
    -- | the cylinder that the face was wrapped on, if any
    trialBend :: Maybe Bend,
    -- | whether a foreign surface was pressed, so that any answer is wrong
    trialForeign :: Bool
  }

-- | How trials are made.
data Exploration = Exploration
  { explorationSensor :: Sensor,
    -- | the distance between neighbouring presses, in the sensor's taxels
    explorationSpacing :: Int,
    explorationTurns :: Turns,
    -- | width and height of the region, in taxels
    explorationSize :: (Int, Int),
    -- | the cylinder that each face is wrapped on; 'Nothing' if faces are flat
    explorationBend :: Maybe Bend,
    explorationForeign :: Maybe Foreign
  }

-- | Presses on foreign surfaces: the array's shapes in a random arrangement, or other arrays.
data Foreign = Foreign
  { -- | the share of presses on random arrangements
    foreignShare :: Double,
    -- | the number of classes of the symbols
    foreignClasses :: Int,
    -- | the relief of a face with these classes in the cells of its block; 'Nothing' if there is
    -- none
    foreignRelief :: LaidFace -> (Position -> Int) -> Maybe Relief,
    -- | the share of presses on other arrays
    foreignArrays :: Double,
    -- | for each other array, all with equal probabilities, the classes on a face
    foreignFaces :: [LaidFace -> Position -> Int]
  }

-- | Regions of this size with this sensor at its default spacing, on flat faces in these rotations,
-- none foreign.
exploration :: Sensor -> Turns -> (Int, Int) -> Exploration
exploration sensor turns size =
  Exploration
    { explorationSensor = sensor,
      explorationSpacing = defaultSpacing sensor,
      explorationTurns = turns,
      explorationSize = size,
      explorationBend = Nothing,
      explorationForeign = Nothing
    }

-- | Explores a region at a random place on a face. 'Nothing' if the presses do not cover it, or a
-- foreign surface has no relief. A foreign trial names the face whose size and number of symbols it
-- has.
trial :: Exploration -> (LaidFace, Relief) -> StdGen -> Maybe Trial
trial how (face, surface) generator = do
  let (region, generator1) =
        drawnRegion (explorationTurns how) (explorationSize how) face generator
  (foreign', flat, generator2) <- case explorationForeign how of
    Nothing -> Just (False, surface, generator1)
    Just others -> ground others (face, surface) generator1
  let (specimen, generator3) = drawSpecimen (explorationSensor how) generator2
  frames <-
    either (const Nothing) Just $
      pressRegion
        (explorationSensor how)
        (explorationSpacing how)
        specimen
        flat {reliefBend = explorationBend how}
        region
        generator3
  pure (Trial face region frames (explorationBend how) foreign')

-- | The surface that is pressed: the face, or at random a foreign surface, whose symbols are
-- independent and uniform, or those of another array.
ground :: Foreign -> (LaidFace, Relief) -> StdGen -> Maybe (Bool, Relief, StdGen)
ground others (face, surface) generator
  | share < foreignShare others = foreign' classes
  | share < foreignShare others + foreignArrays others =
    listToMaybe (drop among (foreignFaces others)) >>= foreign' . ($ face)
  | otherwise = Just (False, surface, generator1)
  where
    (share, generator1) = uniform generator
    (own, generator2) = split generator1
    foreign' laid = (\felt -> (True, felt, generator2)) <$> foreignRelief others face laid
    among = floor (fst (uniform own) * genericLength (foreignFaces others)) :: Int
    -- For large plates the arrangement repeats after 64 rows and columns.
    Shape high wide = Shape (min 64 (rows (laidGrid face))) (min 64 (columns (laidGrid face)))
    classes (Position i j) =
      drawn Boxed.! fromIntegral ((i `mod` high) * wide + j `mod` wide)
    drawn =
      Boxed.fromList (genericTake (high * wide) (map symbol (unfoldr (Just . uniform) own)))
    symbol u = min (foreignClasses others - 1) (floor (u * fromIntegral (foreignClasses others)))

-- | Trials on the faces in turn. Each has its own generator, split from the seed, so that it can be
-- run alone.
trials :: Exploration -> [(LaidFace, Relief)] -> Int -> [Maybe Trial]
trials how faces seed =
  zipWith (trial how) (cycle faces) (unfoldr (Just . split) (mkStdGen seed))

-- | The result of a trial. Its fields are strict, so that it does not keep its trial in memory.
data Result
  = -- | object, face, orientation and place are true; with the answer's doubt
    Correct !Double
  | -- | an answer that is not the true one, with its doubt
    Mistaken !Double
  | -- | no answer, with the refusal's stable name
    NoAnswer !String
  deriving stock (Eq, Ord, Show)

-- | The results of decoding the same frames with and without stitching.
data TrialResult = TrialResult
  { withStitching :: !Result,
    withoutStitching :: !Result
  }
  deriving stock (Eq, Show)

-- | Decodes a trial's frames with and without stitching.
runTrial :: KnownField k => Tolerance -> Recogniser k -> Registration -> Trial -> TrialResult
runTrial tolerance reader registration = fst . ranTrial tolerance reader registration

-- | 'runTrial' with the recognition of a right answer with stitching.
ranTrial ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  Registration ->
  Trial ->
  (TrialResult, Maybe RightAnswer)
ranTrial tolerance reader registration t =
  (TrialResult (fst stitched) (fst (judge nominal)), snd stitched)
  where
    frames = trialFrames t
    tables = readerTables (recogniserReader reader)
    stitched = judge (stitch tables registration frames)
    nominal = stitchedBy tables nominalStitching {stitchingPositionError = exact} frames
    exact = registrationSigma registration
    judge = either (const (NoAnswer "not-stitched", Nothing)) (result tolerance reader t)

-- | The recognition of a right answer.
data RightAnswer = RightAnswer Composite Recognition Finding

-- | Compares an answer with the truth. The window's centre must lie on the true face in the true
-- orientation, within half a cell of the true place of where the composite shows it.
result ::
  KnownField k => Tolerance -> Recogniser k -> Trial -> Composite -> (Result, Maybe RightAnswer)
result tolerance reader t composite = case recogniseWith tolerance reader [composite] of
  Left _ -> (NoAnswer "network-misfit", Nothing)
  Right recognition -> case recognisedAnswer recognition of
    Left refusal -> (NoAnswer (refusalName refusal), Nothing)
    Right (Several _ _) -> (NoAnswer "ambiguous", Nothing)
    Right (Found found)
      | not (trialForeign t) && isTrue (foundOrientation found) (foundWindow found) ->
        (Correct doubt, Just (RightAnswer composite recognition found))
      | otherwise -> (Mistaken doubt, Nothing)
      where
        doubt = maybe 0 supportDoubt (recognisedSupport recognition)
  where
    isTrue orientation window = case windowWhereabouts window of
      OnFace place ->
        isRight
          ( compared
              (recogniserPlacement reader)
              truth
              Claim
                { claimFace = placeFace place,
                  claimSymmetry = orientation,
                  claimPlace = spotMillimetres (placeCentre place),
                  claimSeenAt = compositePosition composite (windowSeenAt window),
                  claimAngle = Nothing
                }
          )
      _ -> False
    truth = trialTruth t

-- | The truth of a trial. The origin of the robot's frame is the region's upper left corner.
trialTruth :: Trial -> Truth
trialTruth t = Truth (laidFace (trialFace t)) (trialRegion t) (0, 0) (trialBend t)

-- | The errors of a pose.
data PoseError = PoseError
  { -- | the distance of the window's centre from its true place, in millimetres
    poseErrorFar :: !Double,
    -- | the angle between the rotations, in degrees
    poseErrorTurned :: !Double,
    -- | the squared Mahalanobis distance, 'poseDistance'
    poseErrorDistance :: !Double
  }
  deriving stock (Eq, Show)

poseError ::
  KnownField k =>
  Placement ->
  Alphabet ->
  PseudorandomArray k ->
  Maybe Double ->
  Trial ->
  RightAnswer ->
  Maybe PoseError
poseError layout alphabet array told t (RightAnswer composite recognition found) = do
  true <- truePose layout (trialTruth t)
  (_, pose) <- foundPose layout alphabet array told [composite] recognition
  let (x, y) = compositePosition composite (windowSeenAt (foundWindow found))
      (far, degrees) = poseApart true pose [x, y, 0]
  PoseError far degrees <$> poseDistance true pose

-- | A summary of poses' errors: the medians, in millimetres and degrees, and the shares within the
-- 50 % and 95 % regions of their covariances.
data PoseTally = PoseTally
  { poseMedianFar :: !Double,
    poseMedianTurned :: !Double,
    poseWithin50 :: !Double,
    poseWithin95 :: !Double
  }
  deriving stock (Eq, Show)

-- | The summary of errors; 'Nothing' if there are none. The bounds are those of chi-square with
-- three degrees of freedom.
poseTally :: [PoseError] -> Maybe PoseTally
poseTally errors
  | null errors = Nothing
  | otherwise =
    Just
      PoseTally
        { poseMedianFar = median poseErrorFar,
          poseMedianTurned = median poseErrorTurned,
          poseWithin50 = share 2.365974,
          poseWithin95 = share 7.814728
        }
  where
    count = length errors
    share bound =
      fromIntegral (length (filter ((<= bound) . poseErrorDistance) errors)) / fromIntegral count
    -- For an even number, the mean of the two in the middle.
    median part = sum middle / fromIntegral (length middle)
      where
        middle = take (2 - count `mod` 2) (drop ((count - 1) `div` 2) (sort (map part errors)))

-- | The numbers of results of each kind.
data Tally = Tally
  { tallyRight :: !Int,
    tallyWrong :: !Int,
    -- | the expected number of wrong answers, by the sum of the answers' doubts
    tallyExpected :: !Double,
    -- | the number of refusals, by name
    tallyRefused :: !(Map.Map String Int)
  }
  deriving stock (Eq, Show)

-- | The tally without results.
noResults :: Tally
noResults = Tally 0 0 0 Map.empty

-- | Adds one result to a tally, in constant memory.
counting :: Tally -> Result -> Tally
counting before r = case r of
  Correct doubt ->
    before {tallyRight = tallyRight before + 1, tallyExpected = tallyExpected before + doubt}
  Mistaken doubt ->
    before {tallyWrong = tallyWrong before + 1, tallyExpected = tallyExpected before + doubt}
  NoAnswer name -> before {tallyRefused = Map.insertWith (+) name 1 (tallyRefused before)}

-- | The tally of results; doubts are added in their order.
tally :: [Result] -> Tally
tally = foldl' counting noResults

-- | The result of a press.
data PressResult = PressResult
  { -- | counts from 1
    pressNumber :: !Int,
    pressResult :: !TrialResult,
    -- | the errors of the pose, for a right answer with stitching
    pressPose :: !(Maybe PoseError)
  }
  deriving stock (Eq, Show)

-- | The tallies and pose errors of presses.
data Counts = Counts
  { countsStitched :: !Tally,
    countsUnstitched :: !Tally,
    -- | the last one first
    countsPoses :: ![PoseError]
  }
  deriving stock (Eq, Show)

-- | Counts presses in their order.
countPresses :: [PressResult] -> Counts
countPresses = foldl' countingPress noCounts

-- | The counts without presses.
noCounts :: Counts
noCounts = Counts noResults noResults []

-- | Adds one press to the counts.
countingPress :: Counts -> PressResult -> Counts
countingPress (Counts stitched unstitched poses) (PressResult _ outcome pose) =
  Counts
    (counting stitched (withStitching outcome))
    (counting unstitched (withoutStitching outcome))
    (maybe poses (: poses) pose)
