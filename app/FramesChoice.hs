-- | What is done to frames before they are put together: a taxel pitch that the manifest does not
-- say, and the sensor's calibration.
module FramesChoice
  ( FramesChoice (..),
    framesOptions,
    preparation,
  )
where

import Data.Bifunctor (first)
import ExitStatus
import FormatFile (readCalibration)
import Frames (Preparation)
import Message
import Options
import PraTactile.Probe (Frame (..))
import PraTactile.Probe.Calibration (corrected)

-- | What was said about the frames.
data FramesChoice = FramesChoice
  { -- | mm
    chosenTaxel :: Maybe Double,
    calibrationFile :: Maybe FilePath
  }

-- | @--taxel@ and @--calibration@.
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
    <*> optionalFile
      "calibration"
      "FILE"
      "Correct the frames first, by what 'calibrate' wrote; dead taxels count as not felt"

-- | What is to be done to frames; leaves with status 2 where that is not possible.
preparation :: FramesChoice -> IO Preparation
preparation choice
  | not (all (\taxel -> taxel >= 0.05 && taxel <= 50) (chosenTaxel choice)) =
    unusable "--taxel is a number of millimetres from 0.05 to 50"
  | otherwise = do
    calibration <- traverse readCalibration (calibrationFile choice)
    let pitched frame = maybe frame (\taxel -> frame {frameTaxel = taxel}) (chosenTaxel choice)
        calibrated = maybe Right corrected calibration
    pure (first calibrationMessage . traverse (calibrated . pitched))
