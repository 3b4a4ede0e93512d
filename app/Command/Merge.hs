{-# LANGUAGE OverloadedStrings #-}
-- | @pra-tactile merge@: the shards of a census as one file.
module Command.Merge
  ( command
  ) where

import Data.Aeson ((.=))
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Options.Applicative hiding (command)

import CensusFile
import Described
import Ending
import Files (readBytes)
import Output (writeWhole)
import Json

command :: Mod CommandFields (IO Ending)
command = described "merge" "Put the shards of a census together: the file that the census would be if it had been made in one run. They must be of one census, complete, and have no entry in common."
  [ "pra-tactile merge part1.csv part2.csv part3.csv --output census.csv" ]
  (run <$> some (strArgument (metavar "FILE..." <> action "file" <> help "Files of 'pra-tactile census --shard'"))
    <*> optional (strOption (long "output" <> metavar "FILE" <> action "file" <> help "Write to a file instead of the standard output"))
    <*> switch (long "json" <> help "With --output, tell as JSON what was written"))

run :: [FilePath] -> Maybe FilePath -> Bool -> IO Ending
run files output asJson = do
  shards <- mapM (\file -> readBytes file >>= fmap ((,) file) . orUnusable ((file ++ ": ") ++) . readLines) files
  merged <- orUnusable id (mergeShards shards)
  let text = Lazy8.unlines (map Lazy8.fromStrict (censusHeader : merged))
  maybe (Lazy8.putStr text) (`writeWhole` text) output
  maybe (pure ()) (report (length merged) (provedLines merged)) output
  pure Answered
  where
    report entries provedOnes file
      | asJson = printJson ("schema" .= ("pra-tactile/census/1" :: String) <> "file" .= file
          <> "entries" .= entries <> "proved" .= provedOnes)
      | otherwise = putStrLn ("wrote " ++ file ++ ": " ++ show entries ++ " entries, " ++ show provedOnes ++ " of them proved")
