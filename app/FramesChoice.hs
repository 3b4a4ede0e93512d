-- | The options for frames and images: pitch, axes and calibration, which replace or supplement the
-- manifest's, and what is known of the robot and the sensor. Pitch and calibration also apply to
-- whole images.
module FramesChoice
  ( FramesChoice (..),
    framesOptions,
    framesGroup,
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

-- | The options about frames.
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

-- | The options for reading frames and whole images: @--taxel@, @--axes@, @--image-axes@,
-- @--position-scale@, @--inverted@, @--full-scale@, @--poses@ and @--calibration@.
framesOptions :: Parser FramesChoice
framesOptions =
  FramesChoice
    <$> taxelOption
      "Distance between neighbouring taxels of the sensor, or pixels of a whole image (default: as \
      \manifest.json or the file states, or 1.5875)"
    <*> optional
      ( choosing
          "pair of axes"
          axesNamed
          "axes"
          "AXES"
          "Which axes the manifest's two coordinates are, where x points right and y down: for \
          \x,-y the second one points up, for y,x the two are swapped (default: as manifest.json \
          \states, or x,y)"
          mempty
      )
    <*> optional
      ( choosing
          "pair of axes"
          axesNamed
          "image-axes"
          "AXES"
          "Where the images' columns and rows point, seen from outside the face, where x points \
          \right and y down: -x,y is mirrored, y,x transposed, -x,-y turned by 180 degrees \
          \(default: x,y)"
          mempty
      )
    <*> optional
      ( valued
          scaleReader
          "position-scale"
          "FACTOR[,FACTOR]"
          "Multiply the positions by this, or x and y by a factor each; 1000 if they are in metres \
          \(default: 1)"
      )
    <*> switch
      (long "inverted" <> help "In the images no contact is white, and full contact is black")
    <*> fullScaleOption
    <*> posesOption "Where the frames of a movie, the only PATH, were pressed"
    <*> calibrationOption
  where
    scaleReader = do
      (across, down) <- pairReader ',' "1000 or 1000,1" <|> ((\s -> (s, s)) <$> decimalReader)
      if all (\s -> s > 0 && s <= 1e9) [across, down]
        then pure (across, down)
        else readerError "a scale is a number above 0 and up to 10^9"

-- | The options of 'framesOptions' and 'stitchingOptions', as a group of a command's help.
framesGroup :: Group
framesGroup =
  Group
    "Frames and images"
    ( words
        "no-stitching position-error frame-noise taxel axes image-axes position-scale inverted \
        \full-scale poses calibration"
    )

-- | @--taxel@.
taxelOption :: String -> Parser (Maybe Double)
taxelOption = optional . valued decimalReader "taxel" "MM"

-- | @--poses@.
posesOption :: String -> Parser (Maybe FilePath)
posesOption what =
  optionalFile
    "poses"
    "FILE"
    ( what
        ++ ": one line for each frame, x_mm,y_mm or \
           \x_mm,y_mm,rotation_deg"
    )

-- | @--full-scale@.
fullScaleOption :: Parser (Maybe Double)
fullScaleOption =
  optional
    ( valued
        fullScaleReader
        "full-scale"
        "READING"
        "The reading of full contact; higher readings count as this one (default: as manifest.json \
        \or the file states; else the largest value of the file's type, 1 for floating point and \
        \text)"
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
    "Correct the frames, or an image of the sensor's size, by this file of 'calibrate'; dead \
    \taxels count as not felt"

-- | How frames are prepared, from the options; leaves with status 2 if a value is impossible.
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

-- | The options about stitching.
data StitchingChoice = StitchingChoice
  { asTheyAre :: Bool,
    positionError :: Maybe Double,
    sensorNoise :: Maybe Double
  }

-- | @--no-stitching@, @--position-error@ and @--frame-noise@.
stitchingOptions :: Parser StitchingChoice
stitchingOptions =
  StitchingChoice
    <$> switch (long "no-stitching" <> help "Use the nominal positions, without correction")
    <*> optional
      ( valued
          decimalReader
          "position-error"
          "SIGMA"
          "Standard deviation of the robot's position error, in taxels (default: 1; by the \
          \lattice, the value from 0.5 to 4 that the frames show)"
      )
    <*> optional
      ( orAlias "noise" decimalReader mempty $
          valued
            decimalReader
            "frame-noise"
            "SD"
            "Standard deviation of the noise in the frames, as a share of full scale (default: as \
            \the frames show it)"
      )

-- | The stitching that the options choose.
stitchingOf :: StitchingChoice -> Stitching
stitchingOf choice =
  way
    { stitchingPositionError = positionError choice <|> stitchingPositionError way,
      stitchingNoise = sensorNoise choice <|> stitchingNoise way
    }
  where
    way = if asTheyAre choice then nominalStitching else standardStitching

-- | The options that apply only to frames and their positions, and whether they were given.
ofFrames :: StitchingChoice -> FramesChoice -> [(String, Bool)]
ofFrames stitching frames =
  ("--axes", isJust (chosenAxes frames)) :
  ("--position-scale", isJust (chosenPositionScale frames)) :
  ("--no-stitching", asTheyAre stitching) :
  ofRegistration stitching

-- | The options about registration, and whether they were given.
ofRegistration :: StitchingChoice -> [(String, Bool)]
ofRegistration stitching =
  [ ("--position-error", isJust (positionError stitching)),
    ("--frame-noise", isJust (sensorNoise stitching))
  ]
