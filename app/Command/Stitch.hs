-- | @pra-tactile stitch@: a folder of frames to one composite image.
module Command.Stitch
  ( command
  , stitchingOption
  , assembly
  ) where

import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Options.Applicative hiding (command)
import System.FilePath (takeExtension)

import Described
import Ending
import Files (writeWhole)
import Frames
import Message
import PraTactile.Image (rasterHeight, rasterWidth)
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, pgmFromIntensity, rasterPng)
import PraTactile.Probe (Frame)
import PraTactile.Stitch

command :: Mod CommandFields (IO Ending)
command = described "stitch" "Assemble the frames of a folder into one composite image, correcting their positions by cross-correlation."
  [ "pra-tactile stitch frames --output composite.pgm" ]
  (run <$> stitchingOption
       <*> strArgument (metavar "FOLDER")
       <*> strOption (long "output" <> metavar "FILE" <> help "The composite, .pgm or .png"))

-- | @--no-stitching@.
stitchingOption :: Parser Bool
stitchingOption = flag True False (long "no-stitching" <> help "Take the nominal positions as they are")

-- | Assemble frames with stitching or without.
assembly :: Bool -> [Frame] -> Either StitchError Composite
assembly corrected = if corrected then stitch standardRegistration else placeOnly

run :: Bool -> FilePath -> FilePath -> IO Ending
run corrected folder output = do
  encoder <- case map toLower (takeExtension output) of
    ".pgm" -> pure (fmap (Lazy.fromStrict . encodePgm Binary) . pgmFromIntensity 255)
    ".png" -> pure (Right . rasterPng)
    _ -> unusable ("cannot tell the form of " ++ output ++ "; end its name in .pgm or .png")
  composite <- loadSource (assembly corrected) (Folder folder)
  writeWhole output =<< orUnusable imageMessage (encoder (compositeImage composite))
  putStrLn ("wrote " ++ output ++ ": " ++ show (rasterWidth (compositeImage composite)) ++ " x "
    ++ show (rasterHeight (compositeImage composite)) ++ " taxels from " ++ show (length (compositeDisplacements composite)) ++ " frames")
  pure Answered
