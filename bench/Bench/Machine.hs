-- | What a reader of the figures has to know of the machine: its processor, and how busy it was
-- with other things.
module Bench.Machine
  ( machine,
    load,
  )
where

import Control.Exception (IOException, try)
import Data.Char (isSpace)
import Data.List (isPrefixOf)
import Data.Version (showVersion)
import GHC.Conc (getNumProcessors)
import System.Info (arch, compilerName, compilerVersion, os)

-- | Processor, cores, system and compiler, as far as they can be told.
machine :: IO String
machine = do
  cores <- getNumProcessors
  processor <- contentOf "/proc/cpuinfo"
  let named =
        [ dropWhile isSpace (drop 1 (dropWhile (/= ':') l))
          | l <- lines processor,
            "model name" `isPrefixOf` l
        ]
  pure
    ( concat (take 1 (named ++ [arch]))
        ++ ", "
        ++ show cores
        ++ " cores, "
        ++ os
        ++ ", "
        ++ compilerName
        ++ " "
        ++ showVersion compilerVersion
    )

-- | The system's mean number of running programs in the last minute; empty where it does not tell.
load :: IO String
load = takeWhile (not . isSpace) <$> contentOf "/proc/loadavg"

contentOf :: FilePath -> IO String
contentOf file = either nothing id <$> try (readFile file >>= \text -> length text `seq` pure text)
  where
    nothing :: IOException -> String
    nothing _ = ""
