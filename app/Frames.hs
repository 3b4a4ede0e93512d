{-# LANGUAGE OverloadedStrings #-}

-- | Frames and composites on disk: a folder with a manifest and PGM files, or a PGM file that is a
-- whole composite.
module Frames
  ( -- * What a path holds
    Source (..),
    sourcePath,
    sources,
    loadSource,
    loadSources,
    loadFrames,
    loadFolder,
    Preparation (..),

    -- * Folders of frames
    frameFiles,
    listedFrameFiles,
  )
where

import Control.Monad (forM_)
import Data.ByteString (ByteString)
import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, fromMaybe)
import ExitStatus
import Files (readBytes)
import FormatFile (readManifestFile)
import Message
import PraTactile.Files
import PraTactile.Format (encodeManifest)
import PraTactile.Image (rasterHeight, rasterWidth)
import PraTactile.Image.Error (ImageError)
import PraTactile.Registration hiding (assemble)
import PraTactile.Sensor.Frame (Frame (..), Layout (..), sensorSide, standardLayout)
import PraTactile.Sensor.Manifest
import PraTactile.Source
import System.Directory (doesDirectoryExist, doesFileExist)
import System.FilePath (takeDirectory, takeFileName, (</>))

-- | What is decoded together.
data Source
  = -- | a folder of frames with its manifest
    FrameFolder FilePath
  | -- | some frames of a folder, as its manifest has them
    Chosen FilePath [FilePath]
  | -- | one image that is a whole composite; @-@ is the standard input
    CompositeFile FilePath

-- | The path that stands for a source: its file or its folder.
sourcePath :: Source -> FilePath
sourcePath source = case source of
  FrameFolder folder -> folder
  Chosen folder _ -> folder
  CompositeFile file -> file

-- | Sort paths into sources: folders and composite images each by itself; files that the manifest
-- beside them lists belong together. Leaves with status 2 where a path does not exist.
sources :: [FilePath] -> IO [Source]
sources paths = do
  found <- traverse sourceOf paths
  let listed = [takeDirectory path | (path, Nothing) <- zip paths found]
      chosen folder =
        Chosen
          folder
          [takeFileName path | (path, Nothing) <- zip paths found, takeDirectory path == folder]
  pure (catMaybes found ++ map chosen (nub listed))
  where
    -- Nothing: a frame that the manifest beside it lists.
    sourceOf path = do
      let folder = takeDirectory path
      isFolder <- doesDirectoryExist path
      isFile <- doesFileExist path
      hasManifest <- isListed folder
      case () of
        _
          | path == "-" -> pure (Just (CompositeFile path))
          | isFolder -> pure (Just (FrameFolder path))
          | not isFile -> unusable ("there is no file or folder " ++ path)
          | hasManifest -> do
            manifest <- readManifest folder
            pure
              ( if takeFileName path `elem` map entryFile (manifestEntries manifest)
                  then Nothing
                  else Just (CompositeFile path)
              )
          | otherwise -> pure (Just (CompositeFile path))

-- | The composites of sources, stitched from their frames by the function where they are not
-- composites already. Says so where images of a frame's size are taken for composites, because they
-- stand in no manifest.
loadSources ::
  Preparation -> ([Frame] -> Either StitchError Composite) -> [Source] -> IO [Composite]
loadSources prepare assemble given = do
  composites <- traverse (loadSource prepare assemble) given
  let lone =
        [ file
          | (CompositeFile file, composite) <- zip given composites,
            frameSized (compositeImage composite)
        ]
  forM_ (nub (map takeDirectory lone)) $ \folder -> do
    hasManifest <- isListed folder
    let presence = if hasManifest then WithManifest else WithoutManifest
    warn (loneFramesMessage folder presence (length (filter ((== folder) . takeDirectory) lone)))
  pure composites
  where
    frameSized image = rasterWidth image == sensorSide && rasterHeight image == sensorSide

-- | What is done to frames before they are assembled.
data Preparation = Preparation
  { -- | what the manifest's coordinates are, in place of what it says itself
    preparedAxes :: Maybe Axes,
    -- | what is made of the frames, or a message why it cannot be
    prepared :: [Frame] -> Either String [Frame]
  }

-- | Frames as they are.
unprepared :: Preparation
unprepared = Preparation Nothing Right

-- | The composite of one source.
loadSource ::
  Preparation -> ([Frame] -> Either StitchError Composite) -> Source -> IO Composite
loadSource prepare assemble source = case source of
  FrameFolder folder -> assembled folder (const True)
  Chosen folder names -> assembled folder (`elem` names)
  CompositeFile "-" ->
    readBytes "-" >>= orUnusable (fileMessage "the standard input") . imageComposite
  CompositeFile file ->
    readImage file >>= orUnusable filesMessage >>= orUnusable (fileMessage file) . imageComposite
  where
    assembled folder wanted = do
      frames <- wantedFrames prepare wanted folder
      orUnusable (\e -> folder ++ ": " ++ stitchMessage e) (assemble frames)

-- | All frames of a folder.
loadFrames :: FilePath -> IO [Frame]
loadFrames = wantedFrames unprepared (const True)

-- | All frames of a folder, prepared, each with its file's name.
loadFolder :: Preparation -> FilePath -> IO [(FilePath, Frame)]
loadFolder prepare folder = do
  names <- map entryFile . manifestEntries <$> readManifest folder
  zip names <$> wantedFrames prepare (const True) folder

-- | The frames of a folder whose files' names are wanted, prepared.
wantedFrames :: Preparation -> (FilePath -> Bool) -> FilePath -> IO [Frame]
wantedFrames prepare wanted folder = do
  inJson <- doesFileExist (folder </> jsonManifestName)
  frames <- if inJson then fromJson else fromCsv
  orUnusable ((folder ++ ": ") ++) (prepared prepare frames)
  where
    fromCsv = do
      content <- readChosen wanted folder >>= orUnusable filesMessage
      map turnedRound <$> orUnusable (sourceMessage folder) (chosenFrames wanted content)
    turnedRound frame =
      maybe frame (\axes -> frame {framePose = alongAxes axes (framePose frame)}) chosen
    fromJson = do
      manifest <- readManifest folder
      images <-
        readImages wanted folder (imagesNamed (manifestEntries manifest))
          >>= orUnusable filesMessage
      orUnusable
        (sourceMessageOf (folder </> jsonManifestName) folder)
        ( manifestFrames
            wanted
            manifest {manifestAxes = fromMaybe (manifestAxes manifest) chosen}
            images
        )
    chosen = preparedAxes prepare

-- | A folder's manifest: the JSON form where there is one, else the CSV form.
readManifest :: FilePath -> IO Manifest
readManifest folder = do
  inJson <- doesFileExist (folder </> jsonManifestName)
  if inJson
    then readManifestFile (folder </> jsonManifestName)
    else do
      manifest <- folderManifest <$> (readChosen (const False) folder >>= orUnusable filesMessage)
      listing <$> orUnusable (sourceMessage folder . ManifestRefused) (parseManifest manifest)

-- | Whether a folder has a manifest of either form.
isListed :: FilePath -> IO Bool
isListed folder =
  (||) <$> doesFileExist (folder </> manifestName) <*> doesFileExist (folder </> jsonManifestName)

-- | The files of a folder of frames, 8-bit binary PGM, with its manifest.
frameFiles :: [Frame] -> Either ImageError [(FilePath, ByteString)]
frameFiles =
  fmap (\folder -> (manifestName, folderManifest folder) : Map.toList (folderImages folder))
    . framesFolder

-- | The same of frames of a sensor of this layout whose readings have so many bits, 0 for real
-- numbers: as 'frameFiles' where it is the standard sensor, else with a manifest in its JSON form,
-- and images with as many grey values as the readings have.
listedFrameFiles :: Layout -> Int -> [Frame] -> Either ImageError [(FilePath, ByteString)]
listedFrameFiles layout bits frames
  | layout == standardLayout && bits <= 8 = frameFiles frames
  | otherwise = do
    (entries, images) <- frameImages (if bits <= 8 then 255 else 2 ^ bits - 1) frames
    pure ((jsonManifestName, encodeManifest (said entries) <> "\n") : Map.toList images)
  where
    said entries =
      (listing entries)
        { manifestTaxel = layoutTaxel layout,
          manifestFrame = Just (layoutColumns layout, layoutRows layout)
        }
