-- | Messages about files and folders.
module Message.Files
  ( ManifestPresence (..),
    filesMessage,
    sourceMessage,
    decodeMessage,
    fileMessage,
    loneFramesMessage,
  )
where

import Data.List (intercalate)
import qualified Data.Text as Text
import Message.Code (profileMessage)
import Message.Format (formatMessage, rangeText)
import Message.Objects (placementMessage, recogniserMessage)
import Message.Touch
import PraTactile.Decode (DecodeError (..))
import PraTactile.Files (FilesError (..))
import PraTactile.Image.Error (ImageError)
import PraTactile.Registration (StitchError (..), maxImagePixels)
import PraTactile.Sensor.Frame (taxelPitches)
import PraTactile.Sensor.Manifest (manifestHeader, manifestName)
import PraTactile.Source (SourceError (..))
import System.FilePath ((</>))

filesMessage :: FilesError -> String
filesMessage e = case e of
  NoSuchFile file -> "there is no file " ++ file
  NoSuchFolder folder -> "there is no folder " ++ folder
  NoSuchPath path -> "there is no file or folder " ++ path
  IsFolder file -> file ++ " is a folder; a file is needed here"
  IsFile file ->
    file ++ " is a file; a folder of frames with its " ++ manifestName ++ " is needed here"
  NoManifest folder ->
    folder
      ++ " holds no "
      ++ manifestName
      ++ ", so the frames' positions are not known; 'pra-tactile probe' shows the form, "
      ++ "and its first line is "
      ++ header
  ManifestRefused file why -> file ++ ": " ++ manifestMessage why
  JsonManifestRefused file why -> formatMessage file "a manifest of frames" why
  PosesRefused file why -> file ++ ": " ++ posesMessage why
  MovieRefused file why -> movieMessage file why
  NotPermitted file -> "no permission to read " ++ file
  TooLarge path limit ->
    path
      ++ " is larger than "
      ++ show (limit `div` (1024 * 1024))
      ++ " MiB, the limit for inputs of this kind"
  Unreadable path why -> "cannot read " ++ path ++ ": " ++ why
  where
    header = intercalate "," (map Text.unpack manifestHeader)

-- | The message about a folder of frames, or a whole image.
sourceMessage :: FilePath -> SourceError -> String
sourceMessage folder e = case e of
  ImageElsewhere name ->
    folder ++ ": the frame " ++ show name ++ " is not a file in the manifest's folder"
  PositionAbsent name ->
    folder ++ ": the manifest does not say where " ++ show name
      ++ " was pressed (x_mm, y_mm, rotation_deg); only 'calibrate' needs no positions"
  ImageAbsent name -> folder ++ ": the frame " ++ show name ++ " is missing"
  ImageSize name (w, h) (w', h') ->
    (folder </> name) ++ " is " ++ by w h ++ " taxels; the manifest says " ++ by w' h'
  ImageRefused name why -> fileMessage (folder </> name) why
  PosesOfAnother poses frames ->
    folder ++ ": there are " ++ show poses ++ " poses, and the movie has " ++ show frames
      ++ " frames"
  ImagesTooLarge n -> folder ++ ": " ++ stitchMessage (TooManyFramePixels n)
  CalibrationRefused why -> folder ++ ": " ++ calibrationMessage why
  ImagePitch pitch ->
    rangeText (folder ++ ": the distance of its pixels in millimetres") taxelPitches
      ++ "; it is stated as "
      ++ show pitch
  ImageTooLarge (w, h) ->
    folder ++ " would have " ++ by w h ++ " pixels of 1.5875 mm; at most "
      ++ show maxImagePixels
      ++ " are allowed; is --taxel right?"
  where
    by w h = show w ++ " x " ++ show h

-- | The message about a movie.
movieMessage :: FilePath -> SourceError -> String
movieMessage file e = case e of
  ImageRefused _ why -> fileMessage file why
  _ -> sourceMessage file e

-- | The message about a source of @decode@, a folder of frames or an image.
decodeMessage :: FilePath -> DecodeError -> String
decodeMessage path e = case e of
  ArrayRefused why -> profileMessage why
  PlacementRefused why -> placementMessage why
  ShapesRefused why -> shippedMessage why
  NetworkRefused why -> networkMessage why
  PartsRefused why -> recogniserMessage why
  FolderRefused why -> sourceMessage path why
  FileRefused why -> fileMessage (if path == "-" then "the standard input" else path) why
  FramesRefused why -> path ++ ": " ++ stitchMessage why

-- | The message about an image.
fileMessage :: FilePath -> ImageError -> String
fileMessage file why = file ++ ": " ++ imageMessage why

-- | Whether a folder has a manifest.
data ManifestPresence = WithManifest | WithoutManifest

-- | The warning about n images in a folder that have the size of a frame but are in no manifest.
loneFramesMessage :: FilePath -> ManifestPresence -> Int -> String
loneFramesMessage folder manifest count =
  ( case manifest of
      WithManifest -> (folder </> manifestName) ++ " does not list "
      WithoutManifest -> folder ++ " holds no " ++ manifestName ++ " for "
  )
    ++ (if count == 1 then "an image" else show count ++ " images")
    ++ " of 16 x 16 taxels, the size of a frame; without positions "
    ++ (if count == 1 then "it was" else "each was")
    ++ " decoded as a whole composite"
