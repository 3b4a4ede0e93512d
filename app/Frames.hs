-- | Sources of composites on disk, for the commands that take what @decode@ takes.
module Frames
  ( framesArgument,
    chosenSources,
    loadSources,
    loadFrames,
    loadUnplaced,
    onlyImages,
  )
where

import Control.Monad (forM_, when)
import Data.Foldable (for_)
import Data.List (nub)
import Data.Traversable (for)
import ExitStatus
import FramesChoice (FramesChoice (..))
import Message
import Options
import PraTactile.Decode (Stitching, sourceComposite)
import PraTactile.Files
import PraTactile.Image (rasterSize)
import PraTactile.Registration (Composite, LatticeTables, compositeImage)
import PraTactile.Sensor.Frame (sensorSide)
import PraTactile.Source
import System.Directory (doesDirectoryExist)
import System.FilePath (takeDirectory)
import Visible (visibleName)

-- | The paths of images, folders of frames, and frames.
framesArgument :: Parser [FilePath]
framesArgument =
  some
    ( pathArgument
        ( metavar "PATH..."
            <> action "file"
            <> help
              "Images, folders of frames, or single frames; - is an image on the standard input"
        )
    )

-- | The kind of each path; with @--poses@, the only path is a movie.
chosenSources :: FramesChoice -> [FilePath] -> IO [SourcePath]
chosenSources choice paths = case (posesFile choice, paths) of
  (Nothing, _) -> sourcePaths paths >>= orUnusable filesMessage
  (Just poses, [movie]) -> pure [MoviePath poses movie]
  _ -> misused "--poses is of one movie; give its file as the only PATH"

-- | The composites of sources as 'sourceComposite' makes them, given the tables of the symbols and
-- their size relative to the paper's. Warns of images of a frame's size that are in no manifest,
-- and so are taken for composites. Leaves with status 2 if a composite cannot be made.
loadSources ::
  LatticeTables -> Double -> Preparation -> Stitching -> [SourcePath] -> IO [Composite]
loadSources tables size known stitching paths = do
  sources <- for paths $ \path -> readSource path >>= orUnusable filesMessage
  composites <- for (zip paths sources) $ \(path, source) ->
    orUnusable
      (decodeMessage (sourcePath path))
      (sourceComposite tables size known stitching source)
  for_ (zip paths sources) $ \(path, source) -> do
    let (clipped, count) = clippedReadings known source
        name = visibleName (sourcePath path)
    when (clipped > 0) $
      warn
        ( "warning: " ++ name ++ ": " ++ show clipped ++ " of " ++ show count
            ++ " readings are above full scale and count as that; --full-scale sets it"
        )
  let lone =
        [ takeDirectory file
          | (ImagePath file, composite) <- zip paths composites,
            rasterSize (compositeImage composite) == (sensorSide, sensorSide)
        ]
  forM_ (nub lone) $ \folder -> do
    listed <- hasManifest folder
    let presence = if listed then WithManifest else WithoutManifest
    warn (loneFramesMessage folder presence (length (filter (== folder) lone)))
  pure composites

-- | Whether no source has frames.
onlyImages :: [SourcePath] -> Bool
onlyImages sources = and [case source of ImagePath _ -> True; _ -> False | source <- sources]

-- | A folder of frames, or a movie with its poses.
loadFrames :: FramesChoice -> FilePath -> IO Folder
loadFrames choice path = case posesFile choice of
  Nothing -> readFolder path >>= orUnusable filesMessage
  Just file -> do
    entries <- readPoses file >>= orUnusable filesMessage
    readMovie (Just entries) path >>= orUnusable filesMessage

-- | A folder of frames, or a movie or an image without positions.
loadUnplaced :: FilePath -> IO Folder
loadUnplaced path = do
  isFolder <- doesDirectoryExist path
  (if isFolder then readFolder path else readMovie Nothing path) >>= orUnusable filesMessage
