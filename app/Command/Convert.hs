{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile convert@: images and movies in any form that is read, as a folder of PGM files.
module Command.Convert
  ( command,
  )
where

import Control.Monad (join, unless, when, zipWithM)
import Data.ByteString (ByteString)
import Data.List (intercalate, nub)
import Data.Maybe (fromMaybe, isNothing, listToMaybe, mapMaybe)
import Data.Traversable (for)
import ExitStatus
import Frames (loadUnplaced)
import FramesChoice (fullScaleOption, posesOption, taxelOption)
import Message
import Options
import Output
import PraTactile.Files
import PraTactile.Format (encodeManifest)
import PraTactile.Image.File
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, pgmFromIntensity)
import PraTactile.Sensor.Manifest
import PraTactile.Source
import SensorChoice (usableTaxel)
import Text.Printf (printf)
import Visible

data Options = Options
  { taxel :: Maybe Double,
    fullScale :: Maybe Double,
    poses :: Maybe FilePath,
    output :: FilePath,
    paths :: [FilePath]
  }

command :: Subcommand
command =
  subcommand
    "convert"
    "Write images, movies or frames as PGM files"
    "Read images, movies and folders of frames in any known form, and write them as a new folder \
    \of PGM files with a manifest.json."
    []
    ["pra-tactile convert data/worked-example/frames --output frames"]
    ( run
        <$> ( Options
                <$> taxelOption
                  "Distance between neighbouring taxels (default: as the files state, or 1.5875)"
                <*> fullScaleOption
                <*> posesOption "Where all frames were pressed, in their order"
                <*> folderOption "output" "A folder that is new or empty"
                <*> some
                  ( pathArgument
                      ( metavar "IN..." <> action "file"
                          <> help
                            "Images, movies or folders of frames"
                      )
                  )
            )
    )

run :: Options -> IO ExitStatus
run options = do
  orTaken (output options)
  chosen <- traverse usableTaxel (taxel options)
  folders <- traverse loadUnplaced (paths options)
  felt <- concat <$> zipWithM feltIn (paths options) folders
  placed <- for (poses options) $ \file -> readPoses file >>= orUnusable filesMessage
  let manifests = map folderManifest folders
      entries = fromMaybe (concatMap manifestEntries manifests) placed
      spacings = nub (mapMaybe manifestTaxel manifests ++ mapMaybe (imagesSpacing . snd) felt)
      axes = nub (map manifestAxes manifests)
      sizes = nub (map (imagesSize . snd) felt)
      count = length felt
      names = [printf "frame_%0*d.pgm" width i | i <- [0 .. count - 1]] :: [FilePath]
      width = max 3 (length (show (count - 1)))
  unless (length entries == count) . unusable $
    "there are " ++ show (length entries) ++ " poses and " ++ show count ++ " frames"
  when (isNothing chosen && several spacings) . unusable $
    "taxels are " ++ intercalate " and " (map (printf "%.4g") spacings)
      ++ " mm apart; state the distance by --taxel"
  when (several axes) (unusable "the manifests say different axes; convert one folder at a time")
  -- Everything about all frames is known before the first is made, so that frames need not be kept
  -- in memory.
  images <- length sizes `seq` for felt (asPgm (fullScale options))
  let taken =
        (listing [entry {entryFile = name} | (name, entry) <- zip names entries])
          { manifestTaxel = chosen <|> listToMaybe spacings,
            manifestFrame = if several sizes then Nothing else listToMaybe sizes,
            manifestAxes = join (listToMaybe axes)
          }
  writeFolder
    (output options)
    ((jsonManifestName, encodeManifest taken <> "\n") : zip names [bytes | (bytes, _, _) <- images])
  putStrLn
    ( "wrote " ++ show (length images) ++ " frames and their manifest to "
        ++ visibleName (output options)
        ++ counted
          "taxels without a reading are the mean of their neighbours"
          [n | (_, n, _) <- images]
        ++ counted "readings above full scale count as that" [n | (_, _, n) <- images]
    )
  pure Answered
  where
    several list = not (null (drop 1 list))
    feltIn path folder =
      orUnusable (sourceMessage path) (folderFelt (withFullScale (fullScale options) folder))
    counted what numbers = case sum numbers of
      0 -> ""
      n -> "; " ++ show n ++ " " ++ what

-- | A frame as a binary PGM file, the number of its taxels without a reading, and the number of its
-- readings above full scale. Readings are kept exactly if they fit into PGM and full scale is the
-- file's own.
asPgm :: Maybe Double -> (ScaledImage, Images) -> IO (ByteString, Int, Int)
asPgm full (felt, images) = do
  pgm <- orUnusable imageMessage (pgmFromIntensity levels (scaledImage felt))
  let bytes = encodePgm Binary pgm
      dead = length (scaledDead felt)
      clipped = scaledClipped felt
  bytes `seq` dead `seq` clipped `seq` pure (bytes, dead, clipped)
  where
    levels = if isNothing full then imagesLevels images else maxBound
