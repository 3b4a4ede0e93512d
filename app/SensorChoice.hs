-- | The options that choose the simulated sensor: a preset or a file, and options that replace its
-- constants.
module SensorChoice
  ( SensorChoice (..),
    sensorOption,
    sensorOptions,
    sensorGroup,
    chosenSensor,
    chosenSpacing,
    chosenSize,
    ofPresses,
    feltBySymbols,
    readSensor,

    -- * The taxels' pitch
    usableTaxel,

    -- * How faces lie
    angleOption,
    angleReader,
    bendOption,
    bendBySymbols,
    bendText,
  )
where

import Control.Monad (foldM)
import Data.List (find, intercalate)
import Data.Maybe (fromMaybe, isJust)
import ExitStatus
import FormatFile (readSensorFile)
import Message (rangeText)
import Options
import PraTactile.Explore (defaultSpacing, regionSizeFor)
import PraTactile.Geometry (symbolThickness)
import PraTactile.Sensor
import PraTactile.Sensor.Constants
import PraTactile.Sensor.Frame (isTaxelPitch, taxelPitches)
import System.Directory (doesPathExist)
import Text.Printf (printf)
import Visible

-- | The options about the sensor.
data SensorChoice = SensorChoice
  { -- | a preset's name, or a file's
    sensorNamed :: Maybe String,
    -- | standard deviation, taxels
    positionSigma :: Maybe Double,
    -- | standard deviation, of full scale
    noiseSd :: Maybe Double,
    -- | standard deviation, degrees
    rotationSigma :: Maybe Double,
    -- | standard deviation, degrees
    tiltSigma :: Maybe Double,
    -- | columns and rows
    frameSize :: Maybe (Int, Int),
    -- | mm
    taxelSize :: Maybe Double,
    -- | between presses, in the sensor's taxels
    spacing :: Maybe Int
  }

-- | @--sensor@, a preset's name or a file, with this help.
sensorOption :: String -> Parser FilePath
sensorOption text =
  option pathReader $
    long "sensor"
      <> metavar "PRESET|FILE"
      <> completeWith (map presetName [minBound ..])
      <> action "file"
      <> help text

-- | @--sensor@, and the options that replace its constants.
sensorOptions :: Parser SensorChoice
sensorOptions =
  SensorChoice
    <$> optional
      ( sensorOption
          "The sensor: ideal, paper, real, hard, or a file as 'sensor --json' prints it (default: \
          \paper). The options below replace its constants"
      )
    <*> number
      "position-error"
      "SIGMA"
      "Standard deviation of each frame's position on both axes, in taxels of 1.5875 mm (paper: 1)"
    <*> number
      "noise"
      "SD"
      "Standard deviation of the sensor's noise, as a share of full scale (paper: 0.1)"
    <*> number
      "rotation-error"
      "SD"
      "Standard deviation of each frame's rotation, in degrees (paper: 0)"
    <*> number
      "tilt"
      "DEGREES"
      "Standard deviation of each frame's two tilts, about the sensor's x and y axes (paper: 0)"
    <*> optional
      ( valued
          (pairReader 'x' "32x32")
          "frame"
          "WIDTHxHEIGHT"
          "Size of the sensor in taxels, 4x4 to 256x256 (paper: 16x16)"
      )
    <*> number
      "taxel"
      "MM"
      "Distance between neighbouring taxels; their tabs grow with it (paper: 1.5875)"
    <*> optional
      ( valued
          intReader
          "spacing"
          "TAXELS"
          "Distance between neighbouring presses, in the sensor's taxels (default: half its \
          \shorter side)"
      )
  where
    number name meta = optional . valued decimalReader name meta

-- | The options of 'sensorOptions', as a group of a command's help.
sensorGroup :: Group
sensorGroup =
  Group
    "The simulated sensor"
    (words "sensor position-error noise rotation-error tilt frame taxel spacing")

-- | The sensor chosen; leaves with status 2 if a constant is impossible.
chosenSensor :: SensorChoice -> IO Sensor
chosenSensor choice
  | not (inRange 0 999.999999 (positionSigma choice)) =
    misused "--position-error must be a number of taxels, 0 or more"
  | not (inRange 0 999.999999 (noiseSd choice)) =
    misused "--noise must be a share of full scale, 0 or more"
  | not (inRange 0 180 (rotationSigma choice)) =
    misused "--rotation-error must be a number of degrees from 0 to 180"
  | not (inRange 0 60 (tiltSigma choice)) =
    misused
      "--tilt must be a number of degrees from 0 to 60"
  | not (all side (concat [[w, h] | Just (w, h) <- [frameSize choice]])) =
    misused "--frame must be from 4x4 to 256x256 taxels"
  | any (< 1) (spacing choice) = misused "--spacing must be a number of taxels, 1 or more"
  | otherwise = do
    base <- maybe (pure standardSensor) readSensor (sensorNamed choice)
    taxel <- traverse usableTaxel (taxelSize choice)
    tilted
      =<< foldM
        put
        (maybe id withTaxel taxel base)
        ( [("position_error", v) | Just v <- [positionSigma choice]]
            ++ [("noise", v) | Just v <- [noiseSd choice]]
            ++ [("rotation_error", v) | Just v <- [rotationSigma choice]]
            ++ concat
              [ [("columns", fromIntegral w), ("rows", fromIntegral h)]
                | Just (w, h) <- [frameSize choice]
              ]
        )
  where
    inRange least most = all (\v -> v >= least && v <= most)
    side n = n >= 4 && n <= (256 :: Int)
    tilted sensor = case tiltSigma choice of
      Just degrees -> put sensor ("tilt_spread", tiltShare sensor degrees)
      Nothing -> pure sensor
    put sensor (name, v) = either (misused . refusal name) pure (replaced name v sensor)
    refusal name = maybe name (rangeText name . constantRange)

-- | How far a tilt by this angle in degrees lowers one edge of a sensor below its centre, as a
-- share of a symbol's thickness.
tiltShare :: Sensor -> Double -> Double
tiltShare sensor degrees = half * tan (degrees * pi / 180) / symbolThickness
  where
    half = sensorTaxel sensor * fromIntegral (max (sensorColumns sensor) (sensorRows sensor)) / 2

-- | The distance of neighbouring presses of a sensor, in its taxels.
chosenSpacing :: SensorChoice -> Sensor -> Int
chosenSpacing choice sensor = fromMaybe (defaultSpacing sensor) (spacing choice)

-- | The options that say how a sensor is pressed on a face, and whether they were given.
ofPresses :: SensorChoice -> [(String, Bool)]
ofPresses choice =
  [ ("--position-error", isJust (positionSigma choice)),
    ("--rotation-error", isJust (rotationSigma choice)),
    ("--tilt", isJust (tiltSigma choice)),
    ("--spacing", isJust (spacing choice))
  ]

-- | The region that is explored, in taxels: the chosen one, or the default for the sensor.
chosenSize :: Maybe (Int, Int) -> Sensor -> (Int, Int)
chosenSize said sensor = fromMaybe (regionSizeFor sensor) said

-- | A sensor as it feels symbols that are larger than the paper's by this factor: its taxels are
-- closer by the factor.
feltBySymbols :: Rational -> Sensor -> Sensor
feltBySymbols scale sensor
  | scale == 1 = sensor
  | otherwise = withTaxel (sensorTaxel sensor / fromRational scale) sensor

-- | The sensor of a preset's name, or else in a file.
readSensor :: String -> IO Sensor
readSensor name = case find ((== name) . presetName) [minBound ..] of
  Just preset -> pure (presetSensor preset)
  Nothing -> do
    there <- doesPathExist name
    if there || name == "-"
      then readSensorFile name
      else
        misused
          ( quoted name ++ " is not a sensor: write "
              ++ intercalate ", " (map presetName [minBound ..])
              ++ " or the name of a file as 'pra-tactile sensor --json' prints it"
          )

-- | The distance of neighbouring taxels that @--taxel@ gives, in millimetres; leaves with status 2
-- if it is out of range.
usableTaxel :: Double -> IO Double
usableTaxel taxel
  | isTaxelPitch taxel = pure taxel
  | otherwise = misused (rangeText "--taxel, a number of millimetres," taxelPitches)

-- | @--turn DEGREES@, with its help.
angleOption :: String -> Parser Double
angleOption said =
  option
    angleReader
    ( long "turn" <> metavar "DEGREES" <> completeWith ["0", "90", "180", "270"] <> help said
    )

-- | An angle in degrees.
angleReader :: ReadM Double
angleReader = do
  degrees <- decimalReader
  if abs degrees <= 1e6
    then pure degrees
    else readerError "a turn is a number of degrees up to a million"

-- | @--bend@ and @--bend-axis@.
bendOption :: Parser (Maybe Bend)
bendOption =
  optional
    ( Bend
        <$> valued
          radiusReader
          "bend"
          "MM"
          "The face is wrapped on a cylinder of this radius; lengths on it are arc lengths \
          \(default: it is flat)"
        <*> choosing
          "axis"
          (allNamed bendAxisName)
          "bend-axis"
          "x|y"
          "The direction of the cylinder's axis on the face (default: y)"
          (value AboutY)
    )
  where
    radiusReader = do
      radius <- decimalReader
      if radius > 0 && radius <= longestRadius
        then pure radius
        else readerError (rangeText "a radius, a number of millimetres," (0, longestRadius))

-- | A bend in words.
bendText :: Bend -> String
bendText (Bend radius axis) =
  printf "bent about %s with a radius of %g mm" (bendAxisName axis) radius

-- | A bend for symbols larger than the paper's by this factor: its radius divided by the factor.
bendBySymbols :: Rational -> Bend -> Bend
bendBySymbols scale bend = bend {bendRadius = bendRadius bend / fromRational scale}
