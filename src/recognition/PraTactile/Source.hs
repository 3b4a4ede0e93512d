-- | Sources of images, as bytes: a folder of frames with its manifest, a movie with its poses, or
-- one image that is a whole composite. This module reads no files; the sublibrary @files@ does
-- ("PraTactile.Files").
module PraTactile.Source
  ( -- * Folders of frames
    Folder (..),
    imagesNamed,
    movieFolder,
    withFullScale,
    folderFrames,
    folderRasters,
    folderFelt,
    frameImages,

    -- * How they are taken
    Preparation (..),
    asStated,
    preparedFrames,
    axesStated,
    takingOf,

    -- * Whole images
    imageComposite,
    wholeImage,
    frameOf,
    preparedImage,

    -- * Either
    Source (..),
    clippedReadings,

    -- * What can be wrong
    SourceError (..),
  )
where

import Control.Applicative ((<|>))
import Control.Monad (unless, when)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, isNothing, mapMaybe)
import qualified Data.Set as Set
import Data.Word (Word16)
import PraTactile.FileName (isFileName)
import PraTactile.Image (Raster, mapRaster, onRaster, rasterSize)
import PraTactile.Image.Error (ImageError (..))
import PraTactile.Image.File
import PraTactile.Image.Pgm (maxPixels, pgmFromIntensity)
import PraTactile.Registration (Composite (..), compositeOf, maxFramePixels, maxImagePixels)
import PraTactile.Sensor.Calibration (Calibration, CalibrationError, corrected, withoutStuck)
import PraTactile.Sensor.Frame (Frame (..), SensorPose (..), isTaxelPitch, scaledFrame, taxelPitch)
import PraTactile.Sensor.Manifest
import PraTactile.Sensor.Resample (atCanonicalPitch, canonicalSize, isCanonical)
import PraTactile.Symmetry (onPixel)
import System.FilePath (isAbsolute, splitDirectories)
import Text.Printf (printf)

-- | A folder of frames: its manifest, and the bytes of the images that the manifest names.
data Folder = Folder
  { folderManifest :: Manifest,
    folderImages :: Map FilePath ByteString
  }
  deriving stock (Eq, Show)

-- | Why a source yields no frames.
data SourceError
  = -- | The manifest names this file outside its folder: the path is absolute, contains @..@, is
    -- empty, or contains a NUL.
    ImageElsewhere FilePath
  | -- | The manifest names this file, but it is not among the folder's images.
    ImageAbsent FilePath
  | -- | The file with this name has the first size (width, height), but the manifest states the
    -- second.
    ImageSize FilePath (Int, Int) (Int, Int)
  | -- | The manifest does not state where the frame with this name was pressed.
    PositionAbsent FilePath
  | -- | The file with this name is not a frame.
    ImageRefused FilePath ImageError
  | -- | The first number is that of poses, the second that of the movie's frames.
    PosesOfAnother Int Int
  | -- | The images that the manifest names have this many pixels in total, more than
    -- 'maxFramePixels'.
    ImagesTooLarge Int
  | -- | The calibration does not fit the frames.
    CalibrationRefused CalibrationError
  | -- | The pixels of a whole image are this many millimetres apart, outside 'taxelPitches'.
    ImagePitch Double
  | -- | At the paper's pitch, a whole image would have this width and height, more than
    -- 'maxImagePixels' pixels.
    ImageTooLarge (Int, Int)
  deriving stock (Eq, Show)

-- | The files that a manifest names within its folder, each once. A name that is not a file may
-- stand for a frame of a movie ('frameOfMovie').
imagesNamed :: Manifest -> [FilePath]
imagesNamed = Set.toAscList . Set.fromList . filter inside . map entryFile . manifestEntries

-- | Whether a relative name stays within its folder.
inside :: FilePath -> Bool
inside name =
  isFileName name && not (isAbsolute name) && ".." `notElem` splitDirectories name

-- | A movie as a folder. The entries of its frames ('parsePoses') are given if it is known where
-- they were pressed. Refuses files that are not movies, and a number of entries that differs from
-- the movie's frames.
movieFolder :: FilePath -> Maybe [Entry] -> ByteString -> Either SourceError Folder
movieFolder name told bytes = do
  count <- first (ImageRefused name) (imagesCount <$> decodeImages maxPixels bytes)
  let entries = fromMaybe (replicate count (Entry name Nothing Nothing)) told
  unless (count == length entries) (Left (PosesOfAnother (length entries) count))
  Right (Folder (listing (zipWith numbered [0 ..] entries)) (Map.singleton name bytes))
  where
    numbered i entry = entry {entryFile = name ++ "#" ++ show (i :: Int)}

-- | All frames of a folder, in the manifest's order and along its axes. Refuses frames without a
-- position, naming the file, and what 'folderRasters' refuses.
folderFrames :: Folder -> Either SourceError [Frame]
folderFrames folder = do
  poses <- traverse placed (manifestEntries manifest)
  felt <- folderFelt folder
  pure (zipWith3 frame (manifestEntries manifest) poses felt)
  where
    manifest = folderManifest folder
    placed entry =
      maybe
        (Left (PositionAbsent (entryFile entry)))
        (Right . alongAxes (fromMaybe straight (manifestAxes manifest)))
        (entryPose entry)
    frame entry pose (felt, images) =
      Frame
        { framePose = pose,
          frameForce = fromMaybe 0 (entryForce entry),
          frameImage = scaledImage felt,
          frameTaxel = fromMaybe taxelPitch (manifestTaxel manifest <|> imagesSpacing images),
          frameDead = scaledDead felt
        }

-- | The images of all frames of a folder, in the manifest's order, whether or not their positions
-- are known. Refuses, naming the file, images that are missing or cannot be read, and names that
-- lead out of the folder.
folderRasters :: Folder -> Either SourceError [Raster]
folderRasters = fmap (map (scaledImage . fst)) . folderFelt

-- | 'folderRasters' including taxels without a reading, with the decoded file of each frame.
folderFelt :: Folder -> Either SourceError [(ScaledImage, Images)]
folderFelt folder = traverse (felt . entryFile) (manifestEntries manifest)
  where
    manifest = folderManifest folder
    images = folderDecoded folder
    felt name = do
      unless (inside name) (Left (ImageElsewhere name))
      (decoded, number) <- maybe (Left (ImageAbsent name)) Right (imageNamed images name)
      found <- first (ImageRefused name) decoded
      seen <- first (ImageRefused name) (numberedImage (manifestFullScale manifest) number found)
      case manifestFrame manifest of
        Just said | said /= imagesSize found -> Left (ImageSize name (imagesSize found) said)
        _ -> Right (seen, found)

-- | The files of a folder, each decoded once.
folderDecoded :: Folder -> Map FilePath (Either ImageError Images)
folderDecoded = Map.map (decodeImages maxPixels) . folderImages

-- | The file that a name stands for, or the movie and the number of its frame.
imageNamed :: Map FilePath a -> FilePath -> Maybe (a, Maybe Int)
imageNamed images name = case Map.lookup name images of
  Just found -> Just (found, Nothing)
  Nothing -> do
    (file, number) <- frameOfMovie name
    found <- Map.lookup file images
    Just (found, Just number)

-- | Corrections for frames and whole images: what their manifest does not state, or states wrongly.
data Preparation = Preparation
  { -- | the directions of the manifest's two coordinates, replacing the manifest's statement
    preparedAxes :: Maybe Axes,
    -- | the directions of the images' columns and rows: where the first one points, and the second
    preparedImageAxes :: Axes,
    -- | the factors for positions, across and down
    preparedPositionScale :: (Double, Double),
    -- | whether intensities are inverted: no contact is full scale, and full contact 0
    preparedInverted :: Bool,
    -- | the reading of full contact, replacing the manifest's and the files'
    preparedFullScale :: Maybe Double,
    -- | the distance of neighbouring taxels in millimetres, replacing the manifest's. For a whole
    -- image, the distance of its pixels; by default the paper's times the symbols' size.
    preparedTaxel :: Maybe Double,
    -- | the calibration that corrects frames and whole images
    preparedCalibration :: Maybe Calibration
  }
  deriving stock (Eq, Show)

-- | No correction: frames as their manifest states them.
asStated :: Preparation
asStated = Preparation Nothing straight (1, 1) False Nothing Nothing Nothing

-- | The frames of a folder, corrected and ready for stitching. Stuck elements are marked as not
-- felt ('withoutStuck'). Refuses what 'folderFrames' refuses, a calibration that does not fit, and,
-- before decoding any, images of more than 'maxFramePixels' pixels in total.
preparedFrames :: Preparation -> Folder -> Either SourceError [Frame]
preparedFrames known folder = do
  when (pixels > maxFramePixels) (Left (ImagesTooLarge pixels))
  frames <- folderFrames (withFullScale (preparedFullScale known) folder {folderManifest = stated})
  withoutStuck . map placed <$> first CalibrationRefused (traverse (prepared known) frames)
  where
    manifest = folderManifest folder
    -- Files that are not images count 0; they are refused when they are decoded.
    pixels = sum (mapMaybe pixelsOf (manifestEntries manifest))
    pixelsOf entry = imageNamed sizes (entryFile entry) >>= fst
    sizes = Map.map (either (const Nothing) (Just . uncurry (*)) . imageSize) (folderImages folder)
    stated =
      manifest
        { manifestAxes = preparedAxes known <|> manifestAxes manifest,
          manifestTaxel = preparedTaxel known <|> manifestTaxel manifest
        }
    placed frame =
      let SensorPose x y r = framePose frame
          (across, down) = preparedPositionScale known
       in frame {framePose = SensorPose (across * x) (down * y) r}

-- | A frame with 0 for no contact, calibrated, and oriented as seen from outside. Refuses a
-- calibration of another size.
prepared :: Preparation -> Frame -> Either CalibrationError Frame
prepared known = fmap seen . calibrated . contact
  where
    contact frame
      | preparedInverted known = frame {frameImage = mapRaster (1 -) (frameImage frame)}
      | otherwise = frame
    calibrated = maybe Right corrected (preparedCalibration known)
    symmetry = axesSymmetry (preparedImageAxes known)
    seen frame =
      frame
        { frameImage = onRaster symmetry (frameImage frame),
          frameDead = map (onTaxel (rasterSize (frameImage frame))) (frameDead frame)
        }
    onTaxel size (i, j) = let (x, y) = onPixel symmetry size (j, i) in (y, x)

-- | The axes, scale and pitch with which a folder's positions and images are interpreted.
takingOf :: Preparation -> Folder -> FrameConventions
takingOf known folder =
  FrameConventions
    { positionAxes =
        fromMaybe straight (preparedAxes known <|> manifestAxes (folderManifest folder)),
      imageAxes = preparedImageAxes known,
      positionScale = preparedPositionScale known,
      conventionsTaxel =
        fromMaybe taxelPitch (preparedTaxel known <|> manifestTaxel (folderManifest folder))
    }

-- | Whether the user or the manifest stated the folder's axes.
axesStated :: Preparation -> Folder -> Bool
axesStated known folder = isJust (preparedAxes known <|> manifestAxes (folderManifest folder))

-- | The manifest entries and the image files of frames, in this format with this full scale; the
-- files are keyed by name. Refuses images that the format cannot hold ('pgmFromIntensity').
frameImages ::
  ImageFormat -> Word16 -> [Frame] -> Either ImageError ([Entry], Map FilePath ByteString)
frameImages format top frames = do
  images <- traverse (fmap (encodeImage format) . pgmFromIntensity top . frameImage) frames
  pure (entries, Map.fromList (zip names images))
  where
    names = [printf "frame_%03d.%s" i (imageFormatName format) | i <- [0 .. length frames - 1]]
    entries = zipWith entry names frames
    entry name f = Entry name (Just (framePose f)) (Just (frameForce f))

-- | The source of one composite.
data Source
  = -- | frames that are stitched
    FrameFolder Folder
  | -- | the bytes of an image that is a whole composite
    WholeImage ByteString
  deriving stock (Eq, Show)

-- | The composite in a file of one image ("PraTactile.Image.File"). Refuses files that are not
-- images, and images of more than 'maxImagePixels' pixels.
imageComposite :: ByteString -> Either ImageError Composite
imageComposite = fmap (compositeOf . fst) . wholeImage asStated

-- | The image of a file, not converted to the paper's pitch, and the distance of its pixels in
-- millimetres if the file states it.
wholeImage :: Preparation -> ByteString -> Either ImageError (Raster, Maybe Double)
wholeImage known = frameOf (preparedFullScale known) Nothing

-- | An image of a file, and the distance of its pixels in millimetres if the file states it.
-- Arguments: the reading of full contact, replacing the file's; the number of the frame of a movie,
-- from 0; the bytes.
frameOf :: Maybe Double -> Maybe Int -> ByteString -> Either ImageError (Raster, Maybe Double)
frameOf full number bytes = do
  images <- decodeImages maxImagePixels bytes
  felt <- numberedImage full number images
  Right (scaledImage felt, imagesSpacing images)

-- | The number of a source's readings above full scale, and the number of all its readings. A
-- source that is refused has none.
clippedReadings :: Preparation -> Source -> (Int, Int)
clippedReadings known source = (sum (map scaledClipped felts), sum (map pixels felts))
  where
    felts = case source of
      WholeImage bytes ->
        either (const []) pure (decodeImages maxImagePixels bytes >>= numberedImage full Nothing)
      FrameFolder folder
        -- PGM allows no reading above its own full scale.
        | isNothing (full <|> manifestFullScale manifest),
          all isPgm (folderImages folder) ->
          []
        | otherwise ->
          either (const []) (map fst) (folderFelt (withFullScale full folder))
        where
          manifest = folderManifest folder
    full = preparedFullScale known
    pixels = uncurry (*) . rasterSize . scaledImage

-- | Replaces the reading of full contact in a folder's manifest, if one is given.
withFullScale :: Maybe Double -> Folder -> Folder
withFullScale full folder =
  folder {folderManifest = manifest {manifestFullScale = full <|> manifestFullScale manifest}}
  where
    manifest = folderManifest folder

-- | The composite of an image, after the corrections, at the paper's pitch. The first argument is
-- the size of the symbols; 2 is twice the paper's. The composite's lengths are divided by it. The
-- centre of the corrected image's pixel (0, 0) is at the origin. Refuses a calibration of another
-- size, a pitch outside 'taxelPitches', and a result of more than 'maxImagePixels' pixels.
preparedImage :: Double -> Preparation -> Raster -> Either SourceError Composite
preparedImage size known image = do
  frame <- scaledFrame (1 / size) <$> first CalibrationRefused (prepared known felt)
  let (wide, high) = canonicalSize frame
      (w, h) = rasterSize (frameImage frame)
      pixel = frameTaxel frame
      beyond = (pixel * half w - taxelPitch * half wide, pixel * half h - taxelPitch * half high)
      composite
        | isCanonical frame = compositeOf (frameImage frame)
        | otherwise =
          (compositeOf (frameImage (atCanonicalPitch frame))) {compositeOrigin = beyond}
  unless (isTaxelPitch pixel) (Left (ImagePitch pitch))
  when
    (toInteger wide * toInteger high > toInteger maxImagePixels)
    (Left (ImageTooLarge (wide, high)))
  pure
    composite
      { compositeConventions =
          standardConventions {imageAxes = preparedImageAxes known, conventionsTaxel = pitch}
      }
  where
    felt = Frame (SensorPose 0 0 0) 0 image pitch []
    pitch = fromMaybe (size * taxelPitch) (preparedTaxel known)
    half side = fromIntegral (side - 1) / 2
