-- | Where images come from, as bytes: a folder of frames with its manifest, a movie with its poses,
-- or one image that is a whole composite. Nothing is read here; the sublibrary @files@ reads
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
import PraTactile.Sensor.Frame (Frame (..), Pose (..), isTaxelPitch, scaledFrame, taxelPitch)
import PraTactile.Sensor.Manifest
import PraTactile.Sensor.Resample (atCanonicalPitch, canonicalSize, isCanonical)
import PraTactile.Symmetry (onPixel)
import System.FilePath (isAbsolute, splitDirectories)
import Text.Printf (printf)

-- | A folder of frames: what its manifest says, and the bytes of the images that this names, by
-- their names.
data Folder = Folder
  { folderManifest :: Manifest,
    folderImages :: Map FilePath ByteString
  }
  deriving stock (Eq, Show)

-- | Why a source holds no frames.
data SourceError
  = -- | The manifest names this file, which is not one of its folder: the path is absolute, has a
    -- @..@ in it, or is no file's name at all: empty, or with a NUL in it.
    ImageElsewhere FilePath
  | -- | The manifest names this file, and it is not among the folder's images.
    ImageAbsent FilePath
  | -- | The file of this name has the first size, width and height, and the manifest says the
    -- second.
    ImageSize FilePath (Int, Int) (Int, Int)
  | -- | The manifest does not say where the frame of this name was pressed.
    PositionAbsent FilePath
  | -- | The file of this name is no frame.
    ImageRefused FilePath ImageError
  | -- | There are so many poses, and a movie of so many frames.
    PosesOfAnother Int Int
  | -- | The images that the manifest names have this many pixels together, more than
    -- 'maxFramePixels'.
    ImagesTooLarge Int
  | -- | The calibration does not correct the frames.
    CalibrationRefused CalibrationError
  | -- | The pixels of a whole image are this many millimetres apart, none of 'taxelPitches'.
    ImagePitch Double
  | -- | A whole image would have this width and height at the paper's pitch, more than
    -- 'maxImagePixels' pixels.
    ImageTooLarge (Int, Int)
  deriving stock (Eq, Show)

-- | What a manifest names, as far as it lies in its folder, each once: files to be read, or frames
-- of movies ('frameOfMovie') where there is no file of the whole name.
imagesNamed :: Manifest -> [FilePath]
imagesNamed = Set.toAscList . Set.fromList . filter inside . map entryFile . manifestEntries

-- | Whether a name stays within the folder that it is relative to.
inside :: FilePath -> Bool
inside name =
  isFileName name && not (isAbsolute name) && ".." `notElem` splitDirectories name

-- | The folder that a movie of this name is, given the entries of its frames ('parsePoses') if it
-- is told where they were pressed. Refuses what is no movie, and another number of frames.
movieFolder :: FilePath -> Maybe [Entry] -> ByteString -> Either SourceError Folder
movieFolder name told bytes = do
  count <- first (ImageRefused name) (imagesCount <$> decodeImages maxPixels bytes)
  let entries = fromMaybe (replicate count (Entry name Nothing Nothing)) told
  unless (count == length entries) (Left (PosesOfAnother (length entries) count))
  Right (Folder (listing (zipWith numbered [0 ..] entries)) (Map.singleton name bytes))
  where
    numbered i entry = entry {entryFile = name ++ "#" ++ show (i :: Int)}

-- | All frames of a folder, in the manifest's order and along its axes. Refuses, naming the file,
-- frames without a position, and what 'folderRasters' refuses.
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
          frameImage = feltImage felt,
          frameTaxel = fromMaybe taxelPitch (manifestTaxel manifest <|> imagesSpacing images),
          frameDead = feltDead felt
        }

-- | What all frames of a folder felt, in the manifest's order, wherever they were pressed. Refuses,
-- naming the file, images that cannot be read or are not there, and names that lead out of the
-- folder.
folderRasters :: Folder -> Either SourceError [Raster]
folderRasters = fmap (map (feltImage . fst)) . folderFelt

-- | The same with taxels that have no reading, and the files in which they stand.
folderFelt :: Folder -> Either SourceError [(Felt, Images)]
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

-- | The files of a folder, each decoded once, however many of its frames are named.
folderDecoded :: Folder -> Map FilePath (Either ImageError Images)
folderDecoded = Map.map (decodeImages maxPixels) . folderImages

-- | What a name means: a file, or a frame of a movie.
imageNamed :: Map FilePath a -> FilePath -> Maybe (a, Maybe Int)
imageNamed images name = case Map.lookup name images of
  Just found -> Just (found, Nothing)
  Nothing -> do
    (file, number) <- frameOfMovie name
    found <- Map.lookup file images
    Just (found, Just number)

-- | What is known of frames that their manifest does not say, or says wrongly, and of whole images.
data Preparation = Preparation
  { -- | what the manifest's two coordinates are, in place of what it says
    preparedAxes :: Maybe Axes,
    -- | what the images' columns and rows are: where the first one points, and the second
    preparedImageAxes :: Axes,
    -- | what the positions are multiplied by, across and down
    preparedPositionScale :: (Double, Double),
    -- | whether no contact is full scale in the images, and full contact 0
    preparedInverted :: Bool,
    -- | the reading of full contact, in place of what manifest and files say
    preparedFullScale :: Maybe Double,
    -- | the distance of neighbouring taxels in millimetres, in place of what the manifest says; of
    -- a whole image that of its pixels, which else is the paper's, times the symbols' size
    preparedTaxel :: Maybe Double,
    -- | what frames and whole images are corrected by
    preparedCalibration :: Maybe Calibration
  }
  deriving stock (Eq, Show)

-- | Frames as their manifest has them, not corrected.
asStated :: Preparation
asStated = Preparation Nothing straight (1, 1) False Nothing Nothing Nothing

-- | The frames of a folder as they are put together: prepared, and elements that are stuck not felt
-- ('withoutStuck'). Refuses what 'folderFrames' refuses; images of more than 'maxFramePixels'
-- pixels together, before one is decoded; and a calibration that does not fit them.
preparedFrames :: Preparation -> Folder -> Either SourceError [Frame]
preparedFrames known folder = do
  when (pixels > maxFramePixels) (Left (ImagesTooLarge pixels))
  frames <- folderFrames (withFullScale (preparedFullScale known) folder {folderManifest = stated})
  withoutStuck . map placed <$> first CalibrationRefused (traverse (prepared known) frames)
  where
    manifest = folderManifest folder
    -- What is no image has none; it is refused when it is decoded.
    pixels = sum (mapMaybe pixelsOf (manifestEntries manifest))
    pixelsOf entry = imageNamed sizes (entryFile entry) >>= fst
    sizes = Map.map (either (const Nothing) (Just . uncurry (*)) . imageSize) (folderImages folder)
    stated =
      manifest
        { manifestAxes = preparedAxes known <|> manifestAxes manifest,
          manifestTaxel = preparedTaxel known <|> manifestTaxel manifest
        }
    placed frame =
      let Pose x y r = framePose frame
          (across, down) = preparedPositionScale known
       in frame {framePose = Pose (across * x) (down * y) r}

-- | A frame with 0 for no contact, corrected, as it is seen from outside. Refuses a calibration of
-- another size.
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

-- | How the positions and images of a folder are taken.
takingOf :: Preparation -> Folder -> Taking
takingOf known folder =
  Taking
    { takenPositions =
        fromMaybe straight (preparedAxes known <|> manifestAxes (folderManifest folder)),
      takenImages = preparedImageAxes known,
      takenScale = preparedPositionScale known,
      takenTaxel =
        fromMaybe taxelPitch (preparedTaxel known <|> manifestTaxel (folderManifest folder))
    }

-- | Whether somebody said what the coordinates of a folder's manifest are.
axesStated :: Preparation -> Folder -> Bool
axesStated known folder = isJust (preparedAxes known <|> manifestAxes (folderManifest folder))

-- | The entries of these frames in a manifest, and their images as files of this format whose full
-- scale is this, by their names. Refuses what has no such image ('pgmFromIntensity').
frameImages ::
  ImageFormat -> Word16 -> [Frame] -> Either ImageError ([Entry], Map FilePath ByteString)
frameImages format top frames = do
  images <- traverse (fmap (encodeImage format) . pgmFromIntensity top . frameImage) frames
  pure (entries, Map.fromList (zip names images))
  where
    names = [printf "frame_%03d.%s" i (imageFormatName format) | i <- [0 .. length frames - 1]]
    entries = zipWith entry names frames
    entry name f = Entry name (Just (framePose f)) (Just (frameForce f))

-- | What shows one composite.
data Source
  = -- | frames that are put together
    FrameFolder Folder
  | -- | the bytes of an image that is a whole composite
    WholeImage ByteString
  deriving stock (Eq, Show)

-- | The composite that a file of one image is ("PraTactile.Image.File"). Refuses what is none, and
-- an image of more than 'maxImagePixels' pixels.
imageComposite :: ByteString -> Either ImageError Composite
imageComposite = fmap (compositeOf . fst) . wholeImage asStated

-- | The same as it stands in the file, with the distance of its pixels if the file tells it.
wholeImage :: Preparation -> ByteString -> Either ImageError (Raster, Maybe Double)
wholeImage known = frameOf (preparedFullScale known) Nothing

-- | The image of a file, or that of this number, from 0, of a movie, given the reading of full
-- contact if it is; with the distance of its pixels if the file tells it.
frameOf :: Maybe Double -> Maybe Int -> ByteString -> Either ImageError (Raster, Maybe Double)
frameOf full number bytes = do
  images <- decodeImages maxImagePixels bytes
  felt <- numberedImage full number images
  Right (feltImage felt, imagesSpacing images)

-- | How many readings of a source are above full scale, and how many there are. Of what is refused
-- there are none.
clippedReadings :: Preparation -> Source -> (Int, Int)
clippedReadings known source = (sum (map feltClipped felts), sum (map pixels felts))
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
    pixels = uncurry (*) . rasterSize . feltImage

-- | The folder with this reading of full contact, if it is given, in place of what its manifest
-- says.
withFullScale :: Maybe Double -> Folder -> Folder
withFullScale full folder =
  folder {folderManifest = manifest {manifestFullScale = full <|> manifestFullScale manifest}}
  where
    manifest = folderManifest folder

-- | The composite that an image is once it is 'prepared', at the paper's pitch, given the size of
-- the symbols: 2 is twice the paper's. The composite's lengths are divided by it. The centre of
-- pixel (0, 0) of the image as it is seen is at the origin. Refuses a calibration of another size,
-- a pitch that is none of 'taxelPitches', and more than 'maxImagePixels' afterwards.
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
      { compositeTaking =
          standardTaking {takenImages = preparedImageAxes known, takenTaxel = pitch}
      }
  where
    felt = Frame (Pose 0 0 0) 0 image pitch []
    pitch = fromMaybe (size * taxelPitch) (preparedTaxel known)
    half side = fromIntegral (side - 1) / 2
