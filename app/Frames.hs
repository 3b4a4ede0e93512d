-- | Frames and composites on disk: a folder with a manifest and PGM files, or a PGM file that is a
-- whole composite.
module Frames
  ( -- * What a path holds
    Source (..),
    sourcePath,
    sources,
    loadSource,
    loadSources,

    -- * Folders of frames
    frameFiles,
  )
where

import Control.Monad (forM_)
import Data.ByteString (ByteString)
import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes)
import ExitStatus
import Files (readBytes)
import Message
import PraTactile.Files
import PraTactile.Image (rasterHeight, rasterWidth)
import PraTactile.Image.Error (ImageError)
import PraTactile.Probe (Frame, sensorSide)
import PraTactile.Probe.Manifest (Entry (..), parseManifest)
import PraTactile.Source
import PraTactile.Stitch hiding (assemble)
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
      hasManifest <- doesFileExist (folder </> manifestName)
      case () of
        _
          | path == "-" -> pure (Just (CompositeFile path))
          | isFolder -> pure (Just (FrameFolder path))
          | not isFile -> unusable ("there is no file or folder " ++ path)
          | hasManifest -> do
            manifest <-
              folderManifest <$> (readChosen (const False) folder >>= orUnusable filesMessage)
            entries <- orUnusable (sourceMessage folder . ManifestRefused) (parseManifest manifest)
            pure
              ( if takeFileName path `elem` map entryFile entries
                  then Nothing
                  else Just (CompositeFile path)
              )
          | otherwise -> pure (Just (CompositeFile path))

-- | The composites of sources, stitched from their frames by the function where they are not
-- composites already. Says so where images of a frame's size are taken for composites, because they
-- stand in no manifest.
loadSources :: ([Frame] -> Either StitchError Composite) -> [Source] -> IO [Composite]
loadSources assemble given = do
  composites <- traverse (loadSource assemble) given
  let lone =
        [ file
          | (CompositeFile file, composite) <- zip given composites,
            frameSized (compositeImage composite)
        ]
  forM_ (nub (map takeDirectory lone)) $ \folder -> do
    hasManifest <- doesFileExist (folder </> manifestName)
    let presence = if hasManifest then WithManifest else WithoutManifest
    warn (loneFramesMessage folder presence (length (filter ((== folder) . takeDirectory) lone)))
  pure composites
  where
    frameSized image = rasterWidth image == sensorSide && rasterHeight image == sensorSide

-- | The composite of one source.
loadSource :: ([Frame] -> Either StitchError Composite) -> Source -> IO Composite
loadSource assemble source = case source of
  FrameFolder folder -> assembled folder (const True)
  Chosen folder names -> assembled folder (`elem` names)
  CompositeFile "-" ->
    readBytes "-" >>= orUnusable (fileMessage "the standard input") . imageComposite
  CompositeFile file ->
    readImage file >>= orUnusable filesMessage >>= orUnusable (fileMessage file) . imageComposite
  where
    assembled folder wanted = do
      content <- readChosen wanted folder >>= orUnusable filesMessage
      frames <- orUnusable (sourceMessage folder) (chosenFrames wanted content)
      orUnusable (\e -> folder ++ ": " ++ stitchMessage e) (assemble frames)

-- | The files of a folder of frames, 8-bit binary PGM, with its manifest.
frameFiles :: [Frame] -> Either ImageError [(FilePath, ByteString)]
frameFiles =
  fmap (\folder -> (manifestName, folderManifest folder) : Map.toList (folderImages folder))
    . framesFolder
