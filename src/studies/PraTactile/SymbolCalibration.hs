-- | How sure a network is, found where the truth is known: on presses by several sensors, upright
-- and at any angle, of its alphabet's symbols and of other shapes.
module PraTactile.SymbolCalibration
  ( Condition (..),
    conditions,
    conditionName,
    knownImages,
    seenBy,
    calibratedSteps,
    calibrationImages,
    calibrationBytes,
  )
where

import PraTactile.Classification.Calibration
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Classification.Templates (Templates)
import PraTactile.Explore (Turns (..), halfTurns)
import PraTactile.Image (Raster, onRaster)
import PraTactile.Sensor (Preset (..), presetName, presetSensor)
import PraTactile.Shape (Alphabet, alphabetSize)
import PraTactile.Shape.Design (foreignShapes)
import PraTactile.Steps
import PraTactile.SymbolImages
import PraTactile.Symmetry

-- | What is pressed by what: another seed for each.
data Condition = Condition
  { conditionSensor :: Preset,
    conditionAnyAngle :: Bool,
    -- | other shapes than the alphabet's
    conditionOthers :: Bool
  }
  deriving stock (Eq, Show)

-- | The sensors @paper@, @real@ and @hard@, each upright and at any angle; and other shapes at any
-- angle.
conditions :: [Condition]
conditions =
  [ Condition sensor anyAngle others
    | sensor <- [Paper, Real, Hard],
      (anyAngle, others) <- [(False, False), (True, False), (True, True)]
  ]

-- | As options of the command line.
conditionName :: Condition -> String
conditionName (Condition sensor anyAngle others) =
  presetName sensor ++ (if anyAngle then " --any-angle" else "")
    ++ (if others then " --foreign 24" else "")

-- | Images of about so many symbols of each condition, by a seed, with what each truly shows:
-- 'Nothing' of other shapes, which are at least 24 taxels from all of the alphabet's; none where
-- there are no such shapes. Refuses what 'labelledImages' does.
knownImages ::
  Alphabet -> Int -> Int -> Condition -> Either ImagesError [(Maybe (Int, Symmetry), Raster)]
knownImages known count seed condition = result (knownSteps known count seed condition)

-- | The steps of 'knownImages', a press each: how many images there are so far.
knownSteps ::
  Alphabet ->
  Int ->
  Int ->
  Condition ->
  Steps Int (Either ImagesError [(Maybe (Int, Symmetry), Raster)])
knownSteps known count seed (Condition sensor anyAngle others)
  | not others = seenAs (\c -> Just (c, identity)) (symbolsOf known)
  | Right drawn <- foreignShapes seed 24 foreignKinds known =
    seenAs (const Nothing) (symbolsOf known) {symbolShapes = drawn}
  | otherwise = Done (Right [])
  where
    seenAs truth symbols =
      fmap (map (\(image, c) -> (truth c, image)) . labelledAs)
        <$> labelledSteps symbols source (share count (alphabetSize (symbolShapes symbols))) seed
    source =
      Presses
        (presetName sensor)
        (presetSensor sensor)
        (if anyAngle then AnyAngle else AmongTurns halfTurns)

-- | How many other shapes are drawn.
foreignKinds :: Int
foreignKinds = 16

-- | How many images of each class make about so many.
share :: Int -> Int -> Int
share count classes = max 1 ((count + classes - 1) `div` classes)

-- | Such images as a classifier, of which the outputs are given, sees them.
seenBy ::
  Templates ->
  (Raster -> Either NetworkError [Double]) ->
  [(Maybe (Int, Symmetry), Raster)] ->
  Either NetworkError [Seen]
seenBy shapesSeen told = traverse seen
  where
    seen (truth, image) =
      Seen truth <$> (look shapesSeen image <$> told image <*> told (onRaster (turned 2) image))

-- | The calibration of a classifier of an alphabet on 300 symbols and 100 others of each condition,
-- from a seed; what they are drawn from no other draw has. The steps are presses: how many of the
-- 'calibrationImages' there are so far.
calibratedSteps ::
  Alphabet ->
  Templates ->
  (Raster -> Either NetworkError [Double]) ->
  Int ->
  Steps Int (Either ImagesError (Either NetworkError Calibration))
calibratedSteps known shapesSeen told seed = do
  images <-
    inTurn [knownSteps known (wanted c) (own + k) c | (k, c) <- zip [0 ..] conditions]
  pure (fit <$> sequenceA images)
  where
    own = 1000000 + 100 * seed
    fit images = fitted (alphabetSize known) . concat <$> traverse (seenBy shapesSeen told) images

-- | About how many images of a condition a calibration has.
wanted :: Condition -> Int
wanted condition = if conditionOthers condition then 100 else 300

-- | About how many bytes 'calibratedSteps' holds at once for so many classes.
calibrationBytes :: Int -> Integer
calibrationBytes classes = fittedBytes classes (calibrationImages classes)

-- | How many images a calibration of so many classes has, where there are other shapes.
calibrationImages :: Int -> Int
calibrationImages classes = sum (map ofCondition conditions)
  where
    ofCondition c =
      let kinds = if conditionOthers c then foreignKinds else classes
       in kinds * share (wanted c) kinds
