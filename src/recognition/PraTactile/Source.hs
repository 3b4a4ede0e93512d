-- | Where images come from, as bytes: a folder of frames with its manifest, or one image that is a
-- whole composite. Nothing is read here; the sublibrary @files@ reads ("PraTactile.Files").
module PraTactile.Source
  ( -- * Folders of frames
    Folder (..),
    manifestName,
    jsonManifestName,
    imagesNamed,
    namedImages,
    folderFrames,
    chosenFrames,
    manifestFrames,
    framesFolder,
    frameImages,

    -- * Whole images
    imageComposite,

    -- * What can be wrong
    SourceError (..),
  )
where

import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Data.Word (Word16)
import PraTactile.Image (Raster, rasterSize)
import PraTactile.Image.Error (ImageError)
import PraTactile.Image.Pgm (PgmFormat (..), decodePgm, encodePgm, pgmFromIntensity, pgmIntensity)
import PraTactile.Registration (Composite, compositeOf)
import PraTactile.Sensor.Frame (Frame (..))
import PraTactile.Sensor.Manifest
import System.FilePath (isAbsolute, splitDirectories)
import Text.Printf (printf)

-- | A folder of frames: the bytes of its manifest and of the images that this names, by their
-- names.
data Folder = Folder
  { folderManifest :: ByteString,
    folderImages :: Map FilePath ByteString
  }
  deriving stock (Eq, Show)

-- | Why a source holds no frames.
data SourceError
  = -- | The manifest cannot be read.
    ManifestRefused ManifestError
  | -- | The manifest names this file, which is not one of its folder: the path is absolute or has a
    -- @..@ in it.
    ImageElsewhere FilePath
  | -- | The manifest names this file, and it is not among the folder's images.
    ImageAbsent FilePath
  | -- | The file of this name has the first size, width and height, and the manifest says the
    -- second.
    ImageSize FilePath (Int, Int) (Int, Int)
  | -- | The file of this name is no frame.
    ImageRefused FilePath ImageError
  deriving stock (Eq, Show)

-- | The name of the manifest in a folder of frames.
manifestName :: FilePath
manifestName = "manifest.csv"

-- | The name of a manifest in its JSON form.
jsonManifestName :: FilePath
jsonManifestName = "manifest.json"

-- | The files that a manifest names, as far as they lie in its folder, each once: those to be read.
-- None if it cannot be read; 'folderFrames' then tells why.
namedImages :: ByteString -> [FilePath]
namedImages = either (const []) imagesNamed . parseManifest

-- | The same of its entries.
imagesNamed :: [Entry] -> [FilePath]
imagesNamed = Set.toAscList . Set.fromList . filter inside . map entryFile

-- | Whether a name stays within the folder that it is relative to.
inside :: FilePath -> Bool
inside name = not (isAbsolute name) && ".." `notElem` splitDirectories name

-- | All frames of a folder, in the manifest's order. Refuses, naming the file, a manifest and
-- images that cannot be read, names that lead out of the folder, and images that are not there.
folderFrames :: Folder -> Either SourceError [Frame]
folderFrames = chosenFrames (const True)

-- | The frames of a folder whose file names are wanted; the others' images need not be there.
chosenFrames :: (FilePath -> Bool) -> Folder -> Either SourceError [Frame]
chosenFrames wanted folder = do
  entries <- first ManifestRefused (parseManifest (folderManifest folder))
  manifestFrames wanted (listing entries) (folderImages folder)

-- | The frames of a manifest whose file names are wanted, along its axes, from its images by their
-- names.
manifestFrames ::
  (FilePath -> Bool) -> Manifest -> Map FilePath ByteString -> Either SourceError [Frame]
manifestFrames wanted manifest images =
  traverse frame (filter (wanted . entryFile) (manifestEntries manifest))
  where
    frame entry = do
      felt <- image (entryFile entry)
      let size = rasterSize felt
      case manifestFrame manifest of
        Just said | said /= size -> Left (ImageSize (entryFile entry) size said)
        _ -> Right ()
      let pose = alongAxes (manifestAxes manifest) (entryPose entry)
      pure (Frame pose (entryForce entry) felt (manifestTaxel manifest) [])
    image name
      | not (inside name) = Left (ImageElsewhere name)
      | otherwise = do
        bytes <- maybe (Left (ImageAbsent name)) Right (Map.lookup name images)
        first (ImageRefused name) (intensities bytes)

-- | The folder of these frames, each an 8-bit binary PGM. Refuses what has no such image
-- ('pgmFromIntensity').
framesFolder :: [Frame] -> Either ImageError Folder
framesFolder frames = do
  (entries, images) <- frameImages 255 frames
  pure (Folder (renderManifest entries) images)

-- | The entries of these frames in a manifest, and their images as binary PGM files of this maximum
-- value, by their names.
frameImages :: Word16 -> [Frame] -> Either ImageError ([Entry], Map FilePath ByteString)
frameImages top frames = do
  images <- traverse (fmap (encodePgm Binary) . pgmFromIntensity top . frameImage) frames
  pure (entries, Map.fromList (zip names images))
  where
    names = [printf "frame_%03d.pgm" i | i <- [0 .. length frames - 1]]
    entries = [Entry name (framePose f) (frameForce f) | (name, f) <- zip names frames]

-- | The composite that a PGM file is. Refuses what is no PGM.
imageComposite :: ByteString -> Either ImageError Composite
imageComposite = fmap compositeOf . intensities

intensities :: ByteString -> Either ImageError Raster
intensities = fmap pgmIntensity . decodePgm
