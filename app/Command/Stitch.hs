-- | @pra-tactile stitch@: a folder of frames to one composite image.
module Command.Stitch
  ( command,
    Assembly,
    assemblyOptions,
    assemble,
    registrationFor,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import ExitStatus
import Frames
import FramesChoice
import Message
import Options
import Output
import PraTactile.Image (rasterHeight, rasterWidth)
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, pgmFromIntensity, rasterPng)
import PraTactile.Probe (Frame)
import PraTactile.Stitch
import System.FilePath (takeExtension)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "stitch"
    "Assemble the frames of a folder into one composite image, correcting their positions by \
    \cross-correlation."
    ["pra-tactile stitch frames --output composite.pgm"]
    ( run <$> assemblyOptions
        <*> framesOptions
        <*> strArgument (metavar "FOLDER" <> action "directory")
        <*> fileOption "output" "FILE" "The composite, .pgm or .png"
    )

-- | How frames are assembled: 'Nothing' where the nominal positions are taken as they are.
type Assembly = Maybe Registration

-- | @--no-stitching@, or what the robot and the sensor are like.
assemblyOptions :: Parser Assembly
assemblyOptions =
  flag' Nothing (long "no-stitching" <> help "Take the nominal positions as they are")
    <|> Just
      <$> ( registrationFor
              <$> defaulting
                1
                decimalReader
                "position-error"
                "SIGMA"
                "Standard deviation of each frame's position that the robot is known for, taxels"
              <*> defaulting
                0.1
                decimalReader
                "noise"
                "SD"
                "Standard deviation of the sensor's noise, as a share of full scale"
          )

-- | Registration for a robot and a sensor of this position error (taxels) and noise (share of full
-- scale); an error of less than a hundredth of a taxel is taken as that, because a prior without
-- width cannot be searched.
registrationFor :: Double -> Double -> Registration
registrationFor sigma noise =
  standardRegistration
    { registrationSigma = if sigma >= 0 then max 0.01 sigma else sigma,
      registrationNoise = noise
    }

-- | Assemble frames with stitching or without.
assemble :: Assembly -> [Frame] -> Either StitchError Composite
assemble = maybe placeOnly stitch

run :: Assembly -> FramesChoice -> FilePath -> FilePath -> IO ExitStatus
run way choice folder output = do
  encoder <- case map toLower (takeExtension output) of
    ".pgm" -> pure (fmap (Lazy.fromStrict . encodePgm Binary) . pgmFromIntensity 255)
    ".png" -> pure (Right . rasterPng)
    _ -> unusable ("cannot tell the form of " ++ output ++ "; end its name in .pgm or .png")
  prepare <- preparation choice
  composite <- loadSource prepare (assemble way) (FrameFolder folder)
  writeWhole output =<< orUnusable imageMessage (encoder (compositeImage composite))
  sayWritten
    output
    ( ": " ++ show (rasterWidth (compositeImage composite)) ++ " x "
        ++ show (rasterHeight (compositeImage composite))
        ++ " taxels from "
        ++ show (length (compositeDisplacements composite))
        ++ " frames"
    )
  pure Answered
