-- | How often the whole way is right, wrong, or refuses: simulated presses at random places on the
-- faces in turn, each decoded with stitching and, from the same frames, with the nominal positions
-- alone.
module PraTactile.Evaluate
  ( -- * A trial
    Trial (..),
    trial,
    trials,
    Exploration (..),
    exploration,
    Foreign (..),
    trialOf,
    trialsOf,
    fitting,

    -- * Its results
    Result (..),
    TrialResult (..),
    runTrial,

    -- * Counts
    Tally (..),
    tally,
    noResults,
    counting,
  )
where

import Data.Either (isRight)
import Data.List (foldl', unfoldr)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import PraTactile.Array (Shape (..))
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Object.Placement
import PraTactile.Random (uniform)
import PraTactile.Recognise
import PraTactile.Registration (Composite, Registration, compositePosition, placeOnly, stitch)
import PraTactile.Sensor (HeightMap, Sensor, drawSpecimen)
import PraTactile.Sensor.Frame (Frame)
import PraTactile.Symmetry (Symmetry)
import PraTactile.Truth
import System.Random (StdGen, mkStdGen, split)

-- | One exploration whose truth is known.
data Trial = Trial
  { trialFace :: LaidFace,
    trialRegion :: Region,
    trialFrames :: [Frame],
    -- | whether what was pressed is none of ours, so that any answer is wrong
    trialForeign :: Bool
  }

-- | How trials are made.
data Exploration = Exploration
  { explorationSensor :: Sensor,
    -- | the distance of neighbouring presses, in the sensor's taxels
    explorationSpacing :: Int,
    explorationTurns :: Turns,
    -- | width and height of the region, taxels
    explorationSize :: (Int, Int),
    explorationForeign :: Maybe Foreign
  }

-- | Presses on what is none of ours: our shapes in an arrangement by chance.
data Foreign = Foreign
  { -- | the share of such presses
    foreignShare :: Double,
    -- | of how many classes the symbols are
    foreignClasses :: Int,
    -- | the relief of a face with these classes, if there is one
    foreignRelief :: LaidFace -> [[Int]] -> Maybe HeightMap
  }

-- | Regions of this size with this sensor at its usual spacing, on faces that lie so; none foreign.
exploration :: Sensor -> Turns -> (Int, Int) -> Exploration
exploration sensor turns size = Exploration sensor (defaultSpacing sensor) turns size Nothing

-- | Explore a region of the given size (taxels) at a random place on a face, which lies in one of
-- the given rotations; @Nothing@ if it does not fit.
trial :: Sensor -> [Symmetry] -> (Int, Int) -> (LaidFace, HeightMap) -> StdGen -> Maybe Trial
trial sensor = (trialOf .) . exploration sensor . AmongTurns

-- | One trial made so. Of a foreign one the face is that whose size and symbols' number it has.
trialOf :: Exploration -> (LaidFace, HeightMap) -> StdGen -> Maybe Trial
trialOf how (face, heights) generator = do
  (region, generator1) <-
    drawnRegion (explorationTurns how) (explorationSize how) face generator
  (foreign', pressed, generator2) <- case explorationForeign how of
    Nothing -> Just (False, heights, generator1)
    Just others -> ground others (face, heights) generator1
  let (specimen, generator3) = drawSpecimen (explorationSensor how) generator2
  (frames, _) <-
    either (const Nothing) Just $
      exploreWith
        (explorationSensor how)
        (explorationSpacing how)
        specimen
        pressed
        region
        generator3
  pure (Trial face region frames foreign')

-- | What is pressed: the face, or by chance a foreign one, with symbols independent and uniform.
ground :: Foreign -> (LaidFace, HeightMap) -> StdGen -> Maybe (Bool, HeightMap, StdGen)
ground others (face, heights) generator
  | share >= foreignShare others = Just (False, heights, generator1)
  | otherwise = do
    drawn <- foreignRelief others face classes
    pure (True, drawn, generator2)
  where
    (share, generator1) = uniform generator
    (own, generator2) = split generator1
    Shape high wide = laidGrid face
    classes = rowsOf (fromIntegral high) (map symbol (unfoldr (Just . uniform) own))
    symbol u = min (foreignClasses others - 1) (floor (u * fromIntegral (foreignClasses others)))
    rowsOf :: Int -> [Int] -> [[Int]]
    rowsOf 0 _ = []
    rowsOf n symbols =
      let (line, rest) = splitAt (fromIntegral wide) symbols in line : rowsOf (n - 1) rest

-- | Trials on the faces in turn, each with a generator of its own split from the seed, so that any
-- one can be run alone.
trials :: Sensor -> [Symmetry] -> (Int, Int) -> [(LaidFace, HeightMap)] -> Int -> [Maybe Trial]
trials sensor possible size = trialsOf (exploration sensor (AmongTurns possible) size)

-- | The same made so.
trialsOf :: Exploration -> [(LaidFace, HeightMap)] -> Int -> [Maybe Trial]
trialsOf how faces seed =
  zipWith (trialOf how) (cycle faces) (unfoldr (Just . split) (mkStdGen seed))

-- | Whether this many 'trials' all find room on their faces; costs next to nothing beside running
-- them.
fitting :: Turns -> (Int, Int) -> [LaidFace] -> Int -> Int -> Bool
fitting possible size faces seed count = go count (cycle faces) (mkStdGen seed)
  where
    go n (face : others) generator
      | n > 0 =
        let (own, next) = split generator
         in isJust (drawnRegion possible size face own) && go (n - 1) others next
    go _ _ _ = True

-- | What became of a trial. Its fields are evaluated, so that a result keeps nothing of its trial.
data Result
  = -- | object, face, orientation and place are the true ones; with the answer's doubt
    Correct !Double
  | -- | an answer, but not the true one; likewise
    Mistaken !Double
  | -- | no answer, with the stable name of the refusal
    NoAnswer !String
  deriving stock (Eq, Ord, Show)

-- | The same frames decoded twice.
data TrialResult = TrialResult
  { withStitching :: !Result,
    withoutStitching :: !Result
  }
  deriving stock (Eq, Show)

-- | Decode a trial's frames with and without stitching.
runTrial :: KnownField k => Tolerance -> Recogniser k -> Registration -> Trial -> TrialResult
runTrial tolerance reader registration t =
  TrialResult (judge (stitch registration frames)) (judge (placeOnly frames))
  where
    frames = trialFrames t
    judge = either (const (NoAnswer "not-stitched")) (result tolerance reader t)

-- | Compare an answer with the truth: the window's centre must lie on the true face, in the true
-- orientation, within half a cell of where the composite shows it.
result :: KnownField k => Tolerance -> Recogniser k -> Trial -> Composite -> Result
result tolerance reader t composite = case recogniseWith tolerance reader [composite] of
  Left _ -> NoAnswer "network-misfit"
  Right recognition -> case recognisedAnswer recognition of
    Left refusal -> NoAnswer (refusalName refusal)
    Right (Several _ _) -> NoAnswer "ambiguous"
    Right (Found found)
      | not (trialForeign t) && isTrue (foundOrientation found) (foundWindow found) -> Correct doubt
      | otherwise -> Mistaken doubt
      where
        doubt = maybe 0 evidenceDoubt (recognisedEvidence recognition)
  where
    isTrue orientation window = case windowWhereabouts window of
      OnFace place ->
        isRight
          ( compared
              (placementPitch (recogniserPlacement reader))
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
    truth = Truth (laidFace (trialFace t)) (trialRegion t) (0, 0)

-- | How many of each.
data Tally = Tally
  { tallyRight :: !Int,
    tallyWrong :: !Int,
    -- | how many wrong ones the answers' doubts add up to
    tallyExpected :: !Double,
    -- | by the refusal's name
    tallyRefused :: !(Map.Map String Int)
  }
  deriving stock (Eq, Show)

-- | The tally of no results.
noResults :: Tally
noResults = Tally 0 0 0 Map.empty

-- | Count one more result, in constant memory.
counting :: Tally -> Result -> Tally
counting counted r = case r of
  Correct doubt ->
    counted {tallyRight = tallyRight counted + 1, tallyExpected = tallyExpected counted + doubt}
  Mistaken doubt ->
    counted {tallyWrong = tallyWrong counted + 1, tallyExpected = tallyExpected counted + doubt}
  NoAnswer name -> counted {tallyRefused = Map.insertWith (+) name 1 (tallyRefused counted)}

-- | Count results; the doubts are added up in their order.
tally :: [Result] -> Tally
tally = foldl' counting noResults
