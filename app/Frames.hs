-- | Frames and composites on disk: a folder with a manifest and PGM files, or a PGM file that is a whole composite.
module Frames
  ( -- * What a path holds
    Source (..)
  , sourcePath
  , sources
  , loadSource
    -- * Folders of frames
  , manifestName
  , readFrames
  , frameFiles
  ) where

import Control.Monad (unless)
import Data.ByteString (ByteString)
import Data.List (nub)
import Data.Maybe (catMaybes)
import System.Directory (doesDirectoryExist, doesFileExist)
import System.FilePath (isAbsolute, splitDirectories, takeDirectory, takeFileName, (</>))
import Text.Printf (printf)

import Ending
import Files
import Message
import PraTactile.Image (Raster)
import PraTactile.Image.Pgm
import PraTactile.Probe (Frame (..))
import PraTactile.Probe.Manifest
import PraTactile.Stitch

-- | What is decoded together.
data Source
  = Folder FilePath              -- ^ a folder of frames with its manifest
  | Chosen FilePath [FilePath]   -- ^ some frames of a folder, as its manifest has them
  | CompositeFile FilePath       -- ^ one image that is a whole composite

-- | The path that stands for a source: its file or its folder.
sourcePath :: Source -> FilePath
sourcePath source = case source of
  Folder folder -> folder
  Chosen folder _ -> folder
  CompositeFile file -> file

-- | Sort paths into sources: folders and composite images each by itself; files that the manifest beside them lists
-- belong together. Leaves with status 2 where a path does not exist.
sources :: [FilePath] -> IO [Source]
sources paths = do
  found <- traverse sourceOf paths
  let listed = [ takeDirectory path | (path, Nothing) <- zip paths found ]
      chosen folder = Chosen folder [ takeFileName path | (path, Nothing) <- zip paths found, takeDirectory path == folder ]
  pure (catMaybes found ++ map chosen (nub listed))
  where
    -- Nothing: a frame that the manifest beside it lists.
    sourceOf path = do
      isFolder <- doesDirectoryExist path
      isFile <- doesFileExist path
      hasManifest <- doesFileExist (takeDirectory path </> manifestName)
      case () of
        _ | isFolder -> pure (Just (Folder path))
          | not isFile -> unusable ("there is no file or folder " ++ path)
          | hasManifest -> do
              entries <- readManifest (takeDirectory path)
              pure (if takeFileName path `elem` map entryFile entries then Nothing else Just (CompositeFile path))
          | otherwise -> pure (Just (CompositeFile path))

-- | The composite of a source, stitched from its frames by the function where it is not one already.
loadSource :: ([Frame] -> Either StitchError Composite) -> Source -> IO Composite
loadSource assemble source = case source of
  Folder folder -> readFrames folder (const True) >>= together folder
  Chosen folder names -> readFrames folder (`elem` names) >>= together folder
  CompositeFile file -> compositeOf <$> readImage file
  where
    together folder = orUnusable (\e -> folder ++ ": " ++ stitchMessage e) . assemble

-- | The name of the manifest in a folder of frames.
manifestName :: FilePath
manifestName = "manifest.csv"

readManifest :: FilePath -> IO [Entry]
readManifest folder = do
  there <- doesFileExist file
  unless there (unusable (folder ++ " holds no " ++ manifestName ++ ", so the frames' positions are not known; 'pra-tactile probe' shows the form"))
  readBytes file >>= orUnusable (\e -> file ++ ": " ++ manifestMessage e) . parseManifest
  where
    file = folder </> manifestName

-- | The frames of a folder whose file names are wanted, in the manifest's order.
readFrames :: FilePath -> (FilePath -> Bool) -> IO [Frame]
readFrames folder wanted = do
  entries <- filter (wanted . entryFile) <$> readManifest folder
  traverse load entries
  where
    load entry
      | isAbsolute (entryFile entry) || ".." `elem` splitDirectories (entryFile entry) =
          unusable (folder </> manifestName ++ ": the frame " ++ show (entryFile entry) ++ " is not a file in the manifest's folder")
      | otherwise = Frame (entryPose entry) (entryForce entry) <$> readImage (folder </> entryFile entry)

readImage :: FilePath -> IO Raster
readImage file = readBytes file >>= orUnusable (\e -> file ++ ": " ++ imageMessage e) . fmap pgmIntensity . decodePgm

-- | The files of a folder of frames, 8-bit binary PGM, with its manifest.
frameFiles :: [Frame] -> Either ImageError [(FilePath, ByteString)]
frameFiles frames = do
  images <- traverse (fmap (encodePgm Binary) . pgmFromIntensity 255 . frameImage) frames
  pure ((manifestName, renderManifest entries) : zip names images)
  where
    names = [ printf "frame_%03d.pgm" i | i <- [0 .. length frames - 1] ]
    entries = [ Entry name (framePose f) (frameForce f) | (name, f) <- zip names frames ]
