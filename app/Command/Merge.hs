{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile merge@: the shards of a census as one file.
module Command.Merge
  ( command,
  )
where

import Control.Monad (filterM, forM_, unless)
import Data.Aeson ((.=))
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import qualified Data.Map.Strict as Map
import Described
import Ending
import Files (readBytes)
import Json
import Message.Census
import Options.Applicative hiding (command)
import Output
import PraTactile.Format.Census
import PraTactile.Format.Census.Contradiction (foundProved)
import PraTactile.Format.Census.Merge
import PraTactile.Format.Census.Row
import SameFile
import Visible

command :: Mod CommandFields (IO Ending)
command =
  described
    "merge"
    "Put the shards of a census together: the file that the census would be if it had been made \
    \in one run. They must be of one census, complete, undamaged, and have no entry in common. If \
    \one of them is of the old form, whose rows carry no check, so is what is written."
    ["pra-tactile merge part1.csv part2.csv part3.csv --output census.csv"]
    ( run
        <$> some
          ( strArgument
              (metavar "FILE..." <> action "file" <> help "Files of 'pra-tactile census --shard'")
          )
        <*> switch
          ( long "keep-whole"
              <> help
                "Of damaged files, take the rows that are whole; entries that are then missing \
                \are told"
          )
        <*> optional
          ( strOption
              ( long "output"
                  <> metavar "FILE"
                  <> action "file"
                  <> help
                    "Write to a file, which is none of the shards, instead of the standard output"
              )
          )
        <*> switch (long "json" <> help "With --output, tell as JSON what was written")
    )

run :: [FilePath] -> Bool -> Maybe FilePath -> Bool -> IO Ending
run files keepWhole output asJson = do
  forM_ output $ \file -> do
    inputs <- filterM (sameFile file) files
    forM_ (take 1 inputs) $ \input ->
      unusable
        ( "the output "
            ++ file
            ++ " is the shard "
            ++ input
            ++ ", which would be lost; give another --output"
        )
  (shards, notes) <- unzip <$> mapM (shard keepWhole) files
  (form, merged) <- orUnusable mergeMessage (mergeShards shards)
  mapM_ warn (concat notes)
  let text = encodeCensus form (map rowText merged)
  maybe (Lazy8.putStr text) (`writeWhole` text) output
  maybe
    (pure ())
    (report (length merged) (length (filter (foundProved . rowFindings) merged)))
    output
  pure Answered
  where
    report entries provedOnes file
      | asJson =
        unless (file == "-") $
          printJson
            ( "schema" .= ("pra-tactile/census/1" :: String) <> "file" .= nameInJson file
                <> "entries" .= entries
                <> "proved" .= provedOnes
            )
      | otherwise =
        sayWritten
          file
          (": " ++ show entries ++ " entries, " ++ show provedOnes ++ " of them proved")

-- | The rows of a file, all of them, or those that are whole if that is asked for, and what is to
-- be said of them. Leaves with status 2 if it is damaged.
shard :: Bool -> FilePath -> IO (Shard, [String])
shard keepWhole file = do
  bytes <- readBytes file
  contents <- orUnusable (censusFileMessage file) (contentsOf bytes)
  let form = contentsForm contents
      unchecked = [uncheckedMessage file | form == Unchecked]
  case completeRows contents of
    Right rows -> pure (Shard file form rows, unchecked)
    Left _
      | keepWhole ->
        let (kept, left) = keptRows contents
            lost = left + length [() | not (Bytes.null (contentsRest contents))]
         in pure
              ( Shard file form (Map.elems kept),
                unchecked ++ [keptMessage file (Map.size kept) lost]
              )
    Left fault -> unusable (censusFileMessage file fault)
