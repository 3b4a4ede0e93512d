-- | Calibrates a network where the truth is known: on presses by several sensors, upright and at
-- any angle, of its alphabet's symbols and of other shapes.
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

-- | A kind of presses. Each kind uses a seed of its own.
data Condition = Condition
  { -- | the sensor that presses
    conditionSensor :: Preset,
    -- | whether regions have any angle; otherwise they are upright or upside down
    conditionAnyAngle :: Bool,
    -- | whether other shapes than the alphabet's are pressed
    conditionOthers :: Bool
  }
  deriving stock (Eq, Show)

-- | For each of the sensors @paper@, @real@ and @hard@: presses upright or upside down, at any
-- angle, and at any angle with other shapes.
conditions :: [Condition]
conditions =
  [ Condition sensor anyAngle others
    | sensor <- [Paper, Real, Hard],
      (anyAngle, others) <- [(False, False), (True, False), (True, True)]
  ]

-- | The condition as options of the command line.
conditionName :: Condition -> String
conditionName (Condition sensor anyAngle others) =
  presetName sensor ++ (if anyAngle then " --any-angle" else "")
    ++ (if others then " --foreign 24" else "")

-- | Images with the truth of each. Arguments: the alphabet; about how many images; a seed; the
-- condition.
--
-- The truth is 'Nothing' for other shapes, which differ from all of the alphabet's in at least 24
-- taxels. If there are no such shapes the list is empty. Refuses what 'labelledImages' refuses.
knownImages ::
  Alphabet -> Int -> Int -> Condition -> Either ImagesError [(Maybe (Int, Symmetry), Raster)]
knownImages known count seed condition = result (knownSteps known count seed condition)

-- | The steps of 'knownImages', one for each press, with the number of images so far.
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

-- | The number of other shapes that are drawn.
foreignKinds :: Int
foreignKinds = 16

-- | The number of images of each class that gives about the wanted number in total. Arguments: that
-- number; the number of classes.
share :: Int -> Int -> Int
share count classes = max 1 ((count + classes - 1) `div` classes)

-- | Images as a classifier sees them. Arguments: the templates of the alphabet; the classifier's
-- outputs for an image; the images, each with its truth as in 'knownImages'. Refuses images that
-- the classifier refuses.
seenBy ::
  Templates ->
  (Raster -> Either NetworkError [Double]) ->
  [(Maybe (Int, Symmetry), Raster)] ->
  Either NetworkError [LabelledFeatures]
seenBy shapesSeen told = traverse seen
  where
    seen (truth, image) =
      LabelledFeatures truth
        <$> (symbolFeatures shapesSeen image <$> told image <*> told (onRaster (turned 2) image))

-- | The calibration of a classifier on 300 symbols and 100 other shapes of each condition.
-- Arguments: the alphabet; its templates; the classifier's outputs for an image; a seed. No other
-- draw uses these images. There is one step for each press, with the number of 'calibrationImages'
-- so far.
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

-- | The approximate number of images of a condition in a calibration.
wanted :: Condition -> Int
wanted condition = if conditionOthers condition then 100 else 300

-- | The approximate memory, in bytes, of 'calibratedSteps' for this number of classes.
calibrationBytes :: Int -> Integer
calibrationBytes classes = fittedBytes classes (calibrationImages classes)

-- | The number of images in a calibration of this number of classes, if there are other shapes.
calibrationImages :: Int -> Int
calibrationImages classes = sum (map ofCondition conditions)
  where
    ofCondition c =
      let kinds = if conditionOthers c then foreignKinds else classes
       in kinds * share (wanted c) kinds
