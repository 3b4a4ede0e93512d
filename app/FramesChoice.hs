-- | How frames are put together: a taxel pitch and axes other than the manifest's, the sensor's
-- calibration, and what is known of robot and sensor. Pitch and calibration are of whole images,
-- too.
module FramesChoice
  ( FramesChoice (..),
    framesOptions,
    calibrationOption,
    taxelOption,
    posesOption,
    fullScaleOption,
    preparation,
    StitchingChoice (asTheyAre),
    stitchingOptions,
    stitchingOf,
    ofFrames,
    ofRegistration,
  )
where

import Data.Maybe (fromMaybe, isJust)
import FormatFile (readCalibration)
import Message.Format (rangeText)
import Options
import PraTactile.Decode (Stitching (..), nominalStitching, standardStitching)
import PraTactile.Image.File
import PraTactile.Sensor.Manifest (Axes, axesNamed, straight)
import PraTactile.Source (Preparation (..))
import SensorChoice (usableTaxel)

-- | What was said about the frames.
data FramesChoice = FramesChoice
  { -- | mm
    chosenTaxel :: Maybe Double,
    chosenAxes :: Maybe Axes,
    chosenImageAxes :: Maybe Axes,
    chosenPositionScale :: Maybe (Double, Double),
    chosenInverted :: Bool,
    -- | the reading of full contact
    chosenFullScale :: Maybe Double,
    -- | of a movie
    posesFile :: Maybe FilePath,
    calibrationFile :: Maybe FilePath
  }

-- | How frames and whole images are taken: @--taxel@, @--axes@, @--image-axes@, @--position-scale@,
-- @--inverted@, @--full-scale@, @--poses@ and @--calibration@.
framesOptions :: Parser FramesChoice
framesOptions =
  FramesChoice
    <$> taxelOption
      "The distance between the sensor's neighbouring taxels, or the pixels of a whole image \
      \(default: as manifest.json or the file says, or 1.5875)"
    <*> optional
      ( choosing
          "pair of axes"
          axesNamed
          "axes"
          "AXES"
          "What the manifest's two coordinates are, x to the right and y down, in place of what it \
          \says itself: x,-y has the second one go up, y,x has the two swapped (default: as \
          \manifest.json says, or x,y)"
          mempty
      )
    <*> optional
      ( choosing
          "pair of axes"
          axesNamed
          "image-axes"
          "AXES"
          "Where the images' columns and rows go, seen from outside the face, x to the right and y \
          \down: -x,y is mirrored, y,x transposed, -x,-y turned by half a turn (default: x,y)"
          mempty
      )
    <*> optional
      ( valued
          scaleReader
          "position-scale"
          "FACTOR[,FACTOR]"
          "Multiply the positions, or x and y each by its own factor, as in 1000 for metres \
          \(default: 1)"
      )
    <*> switch
      (long "inverted" <> help "No contact is white in the images, and full contact black")
    <*> fullScaleOption
    <*> posesOption "Where the frames of a movie, the one PATH, were pressed"
    <*> calibrationOption
  where
    scaleReader = do
      (across, down) <- pairReader ',' "1000 or 1000,1" <|> ((\s -> (s, s)) <$> decimalReader)
      if all (\s -> s > 0 && s <= 1e9) [across, down]
        then pure (across, down)
        else readerError "a scale is a number above 0, up to 10^9"

-- | @--taxel@.
taxelOption :: String -> Parser (Maybe Double)
taxelOption = optional . valued decimalReader "taxel" "MM"

-- | @--poses@.
posesOption :: String -> Parser (Maybe FilePath)
posesOption what =
  optionalFile "poses" "FILE" (what ++ ": a line a frame, x_mm,y_mm or x_mm,y_mm,rotation_deg")

-- | @--full-scale@.
fullScaleOption :: Parser (Maybe Double)
fullScaleOption =
  optional
    ( valued
        fullScaleReader
        "full-scale"
        "READING"
        "The reading of full contact; what is above counts as that (default: as manifest.json \
        \says, or the file: the largest of its type, 1 of numbers with a point and of text)"
    )
  where
    fullScaleReader = do
      full <- decimalReader
      if isFullScale full
        then pure full
        else readerError (rangeText "the reading of full contact" fullScales)

-- | @--calibration@.
calibrationOption :: Parser (Maybe FilePath)
calibrationOption =
  optionalFile
    "calibration"
    "FILE"
    "Correct the frames first, or an image of the sensor's size, by what 'calibrate' wrote; dead \
    \taxels count as not felt"

-- | What is known of the frames; leaves with status 2 where it cannot be.
preparation :: FramesChoice -> IO Preparation
preparation choice =
  Preparation
    (chosenAxes choice)
    (fromMaybe straight (chosenImageAxes choice))
    (fromMaybe (1, 1) (chosenPositionScale choice))
    (chosenInverted choice)
    (chosenFullScale choice)
    <$> traverse usableTaxel (chosenTaxel choice)
    <*> traverse readCalibration (calibrationFile choice)

-- | What was said of how frames are put together.
data StitchingChoice = StitchingChoice
  { asTheyAre :: Bool,
    positionError :: Maybe Double,
    sensorNoise :: Maybe Double
  }

-- | @--no-stitching@, and what the robot and the sensor are like.
stitchingOptions :: Parser StitchingChoice
stitchingOptions =
  StitchingChoice
    <$> switch (long "no-stitching" <> help "Take the nominal positions as they are")
    <*> optional
      ( valued
          decimalReader
          "position-error"
          "SIGMA"
          "Standard deviation of each frame's position that the robot is known for, taxels \
          \(default: 1; by the lattice, what the frames show of 0.5 to 4)"
      )
    <*> optional
      ( valued
          decimalReader
          "noise"
          "SD"
          "Standard deviation of the sensor's noise, as a share of full scale (default: as the \
          \frames show it)"
      )

-- | How frames are put together then.
stitchingOf :: StitchingChoice -> Stitching
stitchingOf choice =
  way
    { stitchingPositionError = positionError choice <|> stitchingPositionError way,
      stitchingNoise = sensorNoise choice <|> stitchingNoise way
    }
  where
    way = if asTheyAre choice then nominalStitching else standardStitching

-- | The options that say something of frames and their positions alone, and whether they were
-- given.
ofFrames :: StitchingChoice -> FramesChoice -> [(String, Bool)]
ofFrames stitching frames =
  ("--axes", isJust (chosenAxes frames)) :
  ("--position-scale", isJust (chosenPositionScale frames)) :
  ("--no-stitching", asTheyAre stitching) :
  ofRegistration stitching

-- | Those that say by what frames are registered.
ofRegistration :: StitchingChoice -> [(String, Bool)]
ofRegistration stitching =
  [ ("--position-error", isJust (positionError stitching)),
    ("--noise", isJust (sensorNoise stitching))
  ]
