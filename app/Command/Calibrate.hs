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

command :: Subcommand
command =
  subcommand
    "calibrate"
    "Find a sensor's offsets, gains and dead taxels"
    "Find each taxel's offset and gain, and the dead taxels, from dark frames, in which nothing is \
    \touched, and flat frames, in which all taxels are pressed alike."
    []
    [ "pra-tactile probe --dark 16 --sensor hard --seed 7 --output dark",
      "pra-tactile probe --flat 16 --sensor hard --seed 7 --output flat",
      "pra-tactile calibrate --dark dark --flat flat --output calibration.json"
    ]
    ( run
        <$> folderOption "dark" "The dark frames: a folder, or a movie"
        <*> folderOption "flat" "The flat frames: a folder, or a movie"
        <*> fullScaleOption
        <*> fileOption
          "output"
          "FILE"
          "Write the calibration to this file, for --calibration of \
          \stitch, segment, decode and register"
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
