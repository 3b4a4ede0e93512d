{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile calibrate@: dark and flat frames to a sensor's calibration.
module Command.Calibrate
  ( command,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import ExitStatus
import Frames (loadUnplaced)
import FramesChoice (fullScaleOption)
import Message
import Options
import Output (sayWritten, writeWhole)
import PraTactile.Format (encodeCalibration)
import PraTactile.Image (rasterHeight, rasterWidth)
import PraTactile.Sensor.Calibration
import PraTactile.Source (folderRasters, withFullScale)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "calibrate"
    "Find each taxel's offset and gain, and which are dead, from frames where nothing is touched \
    \and frames where all taxels are pressed alike."
    [ "pra-tactile probe --dark 16 --sensor hard --seed 7 --output dark",
      "pra-tactile probe --flat 16 --sensor hard --seed 7 --output flat",
      "pra-tactile calibrate --dark dark --flat flat --output calibration.json"
    ]
    ( run
        <$> folderOption "dark" "The folder of frames, or the movie, where nothing is touched"
        <*> folderOption "flat" "The same where all taxels are pressed alike"
        <*> fullScaleOption
        <*> fileOption "output" "FILE" "The calibration, which stitch, decode and register take"
    )

run :: FilePath -> FilePath -> Maybe Double -> FilePath -> IO ExitStatus
run dark flat full output = do
  darks <- images dark
  flats <- images flat
  calibration <- orUnusable calibrationMessage (calibrate darks flats)
  writeWhole output (Lazy.fromStrict (encodeCalibration calibration <> "\n"))
  let offset = calibrationOffset calibration
  sayWritten
    output
    ( ": " ++ show (rasterWidth offset) ++ " x " ++ show (rasterHeight offset) ++ " taxels, "
        ++ show (length (calibrationDead calibration))
        ++ " of them dead"
    )
  pure Answered
  where
    images path =
      loadUnplaced path >>= orUnusable (sourceMessage path) . folderRasters . withFullScale full
