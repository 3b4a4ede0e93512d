-- | @pra-tactile stitch@: a folder of frames to one composite image.
module Command.Stitch
  ( command,
  )
where

import Control.Monad (unless, when)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.Foldable (for_)
import ExitStatus
import Frames
import FramesChoice
import Message
import Options
import Output
import Picture.Assembly (assemblySvg)
import PraTactile.Composite (asTaken)
import PraTactile.Format.Registration (encodeAssembly, stitchMethodName)
import PraTactile.Image (Raster, rasterHeight, rasterWidth)
import PraTactile.Image.Error (ImageError)
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, pgmFromIntensity, rasterPng)
import PraTactile.Registration
import PraTactile.Registration.Stitching
import PraTactile.Sensor.Manifest (Entry (..), Manifest (..))
import PraTactile.Source (Folder (..), preparedFrames, takingOf)
import Setup
import SvgFile (orNotSvg, pictureComplaint, standardOutput)
import System.FilePath (takeExtension)
import Visible (visibleName)

command :: Subcommand
command =
  subcommand
    "stitch"
    "Join the frames of a folder into one image"
    "Join the frames of a folder into one composite image, at corrected positions. If the frames \
    \show symbols, the lattice of symbols corrects the positions; else all overlapping pairs do. \
    \--method chooses another way."
    [framesGroup]
    [ "pra-tactile stitch frames --output composite.pgm",
      "pra-tactile stitch frames --method lattice --json",
      "pra-tactile stitch frames --picture stitched.svg"
    ]
    ( run <$> alphabetChoice
        <*> stitchingOptions
        <*> framesOptions
        <*> optional
          ( choosing
              "method"
              (allNamed stitchMethodName)
              "method"
              "METHOD"
              "How positions are corrected: lattice (by the lattice of symbols), joint (by all \
              \overlapping pairs, whatever they show), incremental (by correlation, as in the \
              \paper), nominal (not at all), or auto (default): lattice if the frames show \
              \symbols, at any angle, else joint"
              mempty
          )
        <*> pathArgument
          ( metavar "FOLDER" <> action "directory"
              <> help "A folder of frames, or a movie with --poses"
          )
        <*> optionalFile "output" "FILE" "Write the composite to this file, .pgm or .png"
        <*> pictureOption
          ["report"]
          "Draw where each frame should have been and where it was found, over the composite"
        <*> jsonSwitch "Print as JSON where each frame was"
    )

run ::
  AlphabetChoice ->
  StitchingChoice ->
  FramesChoice ->
  Maybe StitchMethod ->
  FilePath ->
  Maybe FilePath ->
  Maybe FilePath ->
  AnswerForm ->
  IO ExitStatus
run symbols stitching choice asked folder output report form = do
  when
    (output == Nothing && report == Nothing && form == AsText)
    (misused "there is nothing to do; give --output FILE, --picture FILE.svg or --json")
  for_ (pictureComplaint report form) misused
  when (asTheyAre stitching) $
    leaveOut "--no-stitching uses the nominal positions" [("--method", asked /= Nothing)]
  heeded (stitchingMethod asAsked) stitching symbols
  for_ report orNotSvg
  encoder <- traverse encoderFor output
  tables <- latticeTables <$> chosenAlphabet symbols
  known <- preparation choice
  contents <- loadFrames choice folder
  frames <- orUnusable (sourceMessage folder) (preparedFrames known contents)
  made <- orUnusable (\e -> folder ++ ": " ++ stitchMessage e) (assembledBy tables asAsked frames)
  let composite = assemblyComposite made
      names = map entryFile (manifestEntries (folderManifest contents))
  for_ (compositeContradiction composite) $ \contradiction ->
    warn
      ( "warning: " ++ folder ++ ": "
          ++ contradictionMessage (asTaken (takingOf known contents) Nothing contradiction)
      )
  sequence_ (written composite <$> output <*> encoder)
  for_ report $ \file -> do
    writeWhole file (assemblySvg (visibleName folder) (zip names frames) made)
    unless (form == AsJson || file == standardOutput) (sayWritten file "")
  when (form == AsJson) (Bytes.putStrLn (encodeAssembly names made))
  pure Answered
  where
    known' = stitchingOf stitching
    asAsked = maybe known' (\method -> known' {stitchingMethod = method}) asked
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

-- | Refuses options that a method does not use.
heeded :: StitchMethod -> StitchingChoice -> AlphabetChoice -> IO ()
heeded method stitching symbols = case method of
  Automatic -> pure ()
  Nominal ->
    leaveOut
      "this method uses the nominal positions"
      (ofRegistration stitching ++ alphabetGiven symbols)
  ByLattice ->
    leaveOut
      "the lattice method finds the noise itself"
      [given | given@("--frame-noise", _) <- ofRegistration stitching]
  _ -> leaveOut "only the lattice method uses shapes" (alphabetGiven symbols)

-- | The encoder of a composite for a file of this name.
encoderFor :: FilePath -> IO (Raster -> Either ImageError Lazy.ByteString)
encoderFor output = case map toLower (takeExtension output) of
  ".pgm" -> pure (fmap (Lazy.fromStrict . encodePgm Binary) . pgmFromIntensity 255)
  ".png" -> pure (Right . rasterPng)
  _ -> misused ("the form of " ++ output ++ " is not known; end its name in .pgm or .png")
