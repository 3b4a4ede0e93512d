-- | What is done to frames before they are put together: a taxel pitch and axes other than the
-- manifest's, and the sensor's calibration.
module FramesChoice
  ( FramesChoice (..),
    framesOptions,
    calibrationOption,
    preparation,
  )
where

import Data.Bifunctor (first)
import ExitStatus
import FormatFile (readCalibration)
import Frames (Preparation (..))
import Message
import Options
import PraTactile.Sensor.Calibration (corrected, withoutStuck)
import PraTactile.Sensor.Frame (Frame (..))
import PraTactile.Sensor.Manifest (Axes, axesNamed)

-- | What was said about the frames.
data FramesChoice = FramesChoice
  { -- | mm
    chosenTaxel :: Maybe Double,
    chosenAxes :: Maybe Axes,
    calibrationFile :: Maybe FilePath
  }

-- | @--taxel@, @--axes@ and @--calibration@.
framesOptions :: Parser FramesChoice
framesOptions =
  FramesChoice
    <$> optional
      ( valued
          decimalReader
          "taxel"
          "MM"
          "The distance between the sensor's neighbouring taxels (default: as manifest.json says, \
          \or 1.5875)"
      )
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
    <*> calibrationOption

-- | @--calibration@.
calibrationOption :: Parser (Maybe FilePath)
calibrationOption =
  optionalFile
    "calibration"
    "FILE"
    "Correct the frames first, by what 'calibrate' wrote; dead taxels count as not felt"

-- | What is to be done to frames, of which stuck elements are not felt; leaves with status 2 where
-- that is not possible.
preparation :: FramesChoice -> IO Preparation
preparation choice
  | not (all (\taxel -> taxel >= 0.05 && taxel <= 50) (chosenTaxel choice)) =
    unusable "--taxel is a number of millimetres from 0.05 to 50"
  | otherwise = do
    calibration <- traverse readCalibration (calibrationFile choice)
    let pitched frame = maybe frame (\taxel -> frame {frameTaxel = taxel}) (chosenTaxel choice)
        calibrated = maybe Right corrected calibration
    pure
      Preparation
        { preparedAxes = chosenAxes choice,
          prepared = first calibrationMessage . fmap withoutStuck . traverse (calibrated . pitched)
        }
