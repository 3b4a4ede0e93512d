-- | @pra-tactile stitch@: a folder of frames to one composite image.
module Command.Stitch
  ( command,
    Assembly,
    assemblyOptions,
    assemble,
    registrationFor,
  )
where

import Control.Monad (unless, when)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.Foldable (for_)
import Data.Maybe (fromMaybe)
import ExitStatus
import Frames
import FramesChoice
import Message
import Options
import Output
import Picture.Assembly (assemblySvg)
import PraTactile.Format.Registration (encodeAssembly, wayName)
import PraTactile.Image (Raster, rasterHeight, rasterWidth)
import PraTactile.Image.Error (ImageError)
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, pgmFromIntensity, rasterPng)
import PraTactile.Registration hiding (Assembly, assemble)
import qualified PraTactile.Registration as Stitch
import PraTactile.Sensor.Frame (Frame (..))
import SvgFile (orNotSvg, standardOutput)
import System.FilePath (takeExtension)
import Visible (visibleName)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "stitch"
    "Assemble the frames of a folder into one composite image, correcting their positions by \
    \cross-correlation."
    [ "pra-tactile stitch frames --output composite.pgm",
      "pra-tactile stitch frames --method lattice --json",
      "pra-tactile stitch frames --report stitched.svg"
    ]
    ( run <$> assemblyOptions
        <*> framesOptions
        <*> optional
          ( choosing
              "method"
              (allNamed wayName)
              "method"
              "METHOD"
              "lattice (by the lattice of symbols), joint (by all pairs that overlap, \
              \whatever they show), incremental (by the paper's correlation), \
              \nominal (not at all), or auto: incremental, and by the lattice where \
              \--position-error is above 1.25 or the noise above 0.25 and the frames show symbols, \
              \at whatever angle (default)"
              mempty
          )
        <*> strArgument (metavar "FOLDER" <> action "directory")
        <*> optionalFile "output" "FILE" "The composite, .pgm or .png"
        <*> optionalFile
          "report"
          "FILE.svg"
          "Draw where each frame should have been and where it was found, over the composite"
        <*> jsonSwitch "Print where each frame was as JSON"
    )

-- | How frames are assembled, by what they are: 'Nothing' where the nominal positions are taken as
-- they are.
type Assembly = Maybe ([Frame] -> Registration)

-- | @--no-stitching@, or what the robot and the sensor are like.
assemblyOptions :: Parser Assembly
assemblyOptions =
  flag' Nothing (long "no-stitching" <> help "Take the nominal positions as they are")
    <|> Just
      <$> ( settingsFor
              <$> defaulting
                1
                decimalReader
                "position-error"
                "SIGMA"
                "Standard deviation of each frame's position that the robot is known for, taxels"
              <*> optional
                ( valued
                    decimalReader
                    "noise"
                    "SD"
                    "Standard deviation of the sensor's noise, as a share of full scale (default: \
                    \as the frames show it)"
                )
          )
  where
    settingsFor sigma (Just noise) = const (registrationFor sigma noise)
    settingsFor sigma Nothing = \frames -> withNoiseOf frames (registrationFor sigma 0)

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
assemble settings frames = maybe placeOnly (\known -> stitch (known frames)) settings frames

run ::
  Assembly ->
  FramesChoice ->
  Maybe Way ->
  FilePath ->
  Maybe FilePath ->
  Maybe FilePath ->
  AnswerForm ->
  IO ExitStatus
run settings choice asked folder output report form = do
  when
    (output == Nothing && report == Nothing && form == AsText)
    (unusable "there is nothing to do: give --output FILE, --report FILE.svg, or --json")
  when
    (report == Just standardOutput && form == AsJson)
    (unusable "--report - and --json both take the standard output; name a file for the picture")
  for_ report orNotSvg
  encoder <- traverse encoderFor output
  prepare <- preparation choice
  (names, frames) <- unzip <$> loadFolder prepare folder
  made <-
    orUnusable
      (\e -> folder ++ ": " ++ stitchMessage e)
      (Stitch.assemble way (maybe standardRegistration ($ frames) settings) frames)
  let composite = Stitch.assemblyComposite made
  for_ (compositeContradiction composite) $ \contradiction ->
    warn ("warning: " ++ folder ++ ": " ++ contradictionMessage contradiction)
  sequence_ (written composite <$> output <*> encoder)
  for_ report $ \file -> do
    writeWhole file (assemblySvg (visibleName folder) (zip names frames) made)
    unless (form == AsJson || file == standardOutput) (sayWritten file "")
  when
    (form == AsJson)
    (Bytes.putStrLn (encodeAssembly (zip names (map framePose frames)) made))
  pure Answered
  where
    way = fromMaybe (maybe Nominal (const Automatic) settings) asked
    written composite file encoder = do
      writeWhole file =<< orUnusable imageMessage (encoder (compositeImage composite))
      unless (form == AsJson) $
        sayWritten
          file
          ( ": " ++ show (rasterWidth (compositeImage composite)) ++ " x "
              ++ show (rasterHeight (compositeImage composite))
              ++ " taxels from "
              ++ show (length (compositeDisplacements composite))
              ++ " frames"
          )

-- | How a composite is written to a file of that name.
encoderFor :: FilePath -> IO (Raster -> Either ImageError Lazy.ByteString)
encoderFor output = case map toLower (takeExtension output) of
  ".pgm" -> pure (fmap (Lazy.fromStrict . encodePgm Binary) . pgmFromIntensity 255)
  ".png" -> pure (Right . rasterPng)
  _ -> unusable ("cannot tell the form of " ++ output ++ "; end its name in .pgm or .png")
