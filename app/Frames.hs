-- | Sources of composites on disk, for the commands that take what @decode@ takes.
module Frames
  ( framesArgument,
    loadSources,
    loadFolder,
    onlyImages,
  )
where

import Control.Monad (forM_)
import Data.List (nub)
import Data.Traversable (for)
import ExitStatus
import Message
import Options
import PraTactile.Decode (Stitching, sourceComposite)
import PraTactile.Files
import PraTactile.Image (rasterSize)
import PraTactile.Registration (Composite, LatticeTables, compositeImage)
import PraTactile.Sensor.Frame (sensorSide)
import PraTactile.Source
import System.FilePath (takeDirectory)

-- | The paths of images, folders of frames, and frames.
framesArgument :: Parser [FilePath]
framesArgument =
  some
    ( pathArgument
        ( metavar "PATH..."
            <> action "file"
            <> help "Images, folders of frames, or frames; - is an image on the standard input"
        )
    )

-- | The composites of sources, given the tables of the symbols that may have been felt, and how
-- much larger than the paper's they are, as 'sourceComposite' makes them. Says so where images of a
-- frame's size are taken for composites, because they stand in no manifest. Leaves with status 2
-- where one cannot be made.
loadSources ::
  LatticeTables -> Double -> Preparation -> Stitching -> [SourcePath] -> IO [Composite]
loadSources tables size known stitching paths = do
  composites <- for paths $ \path -> do
    source <- readSource path >>= orUnusable filesMessage
    orUnusable
      (decodeMessage (sourcePath path))
      (sourceComposite tables size known stitching source)
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

-- | A folder of frames.
loadFolder :: FilePath -> IO Folder
loadFolder folder = readFolder folder >>= orUnusable filesMessage
