-- | @pra-tactile merge@: the shards of a census as one file.
module Command.Merge
  ( command,
  )
where

import CensusChoice
import Control.Exception (IOException, try)
import Control.Monad (filterM, unless)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (for_)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import ExitStatus
import Files (readBytes)
import Message.Census
import Options
import Output
import PraTactile.Format.Census
import PraTactile.Format.Census.Contradiction (foundProved)
import PraTactile.Format.Census.Merge
import PraTactile.Format.Census.Row
import System.Posix.Files (deviceID, fileID, getFileStatus)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "merge"
    "Put the shards of a census together: the file that the census would be if it had been made \
    \in one run. They must be of one census, complete, undamaged, and have no entry in common."
    ["pra-tactile merge part1.csv part2.csv part3.csv --output census.csv"]
    ( run
        <$> some
          ( pathArgument
              (metavar "FILE..." <> action "file" <> help "Files of 'pra-tactile census --shard'")
          )
        <*> keepWholeSwitch
          "Of damaged files, take the rows that are whole; entries that are then missing are told"
        <*> optionalFile
          "output"
          "FILE"
          "Write to a file, which is none of the shards, instead of the standard output"
        <*> jsonSwitch "With --output, tell as JSON what was written"
    )

run :: [FilePath] -> Damage -> Maybe FilePath -> AnswerForm -> IO ExitStatus
run files damage output form = do
  unless (isJust output) $
    leaveOut "the census is printed, and nothing is told of it" [("--json", form == AsJson)]
  for_ output $ \file -> do
    inputs <- filterM (sameFile file) files
    for_ (take 1 inputs) $ \input ->
      misused
        ( "the output "
            ++ file
            ++ " is the shard "
            ++ input
            ++ ", which would be lost; give another --output"
        )
  (shards, notes) <- unzip <$> mapM (shard damage) files
  merged <- orUnusable mergeMessage (mergeShards shards)
  mapM_ warn (concat notes)
  let text = encodeCensus (map rowText merged)
      provedOnes = length (filter (foundProved . rowFindings) merged)
  maybe (Lazy8.putStr text) (`writeWhole` text) output
  for_ output $ \file -> sayCensus form file (fromIntegral (length merged)) provedOnes
  pure Answered

-- | The rows of a file, all of them, or those that are whole if that is asked for, and what is to
-- be said of them. Leaves with status 2 if it is damaged.
shard :: Damage -> FilePath -> IO (Shard, [String])
shard damage file = do
  bytes <- readBytes file
  contents <- orUnusable (censusFileMessage file) (contentsOf bytes)
  case completeRows contents of
    Right rows -> pure (Shard file rows, [])
    Left _
      | damage == Repaired ->
        let (kept, left) = keptRows contents
            lost = left + length [() | not (Bytes.null (contentsRest contents))]
         in pure (Shard file (Map.elems kept), [keptMessage file (Map.size kept) lost])
    Left fault -> unusable (censusFileMessage file fault)

-- | Whether both paths lead to the same file, however they are spelt and over whatever links, hard
-- ones among them. What does not exist is the same as nothing.
sameFile :: FilePath -> FilePath -> IO Bool
sameFile a b = (\x y -> Just True == ((==) <$> x <*> y)) <$> identity a <*> identity b
  where
    identity path =
      either none (\status -> Just (deviceID status, fileID status)) <$> try (getFileStatus path)
    none :: IOException -> Maybe a
    none _ = Nothing
