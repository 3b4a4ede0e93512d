-- | The machine that a reader of the figures needs to know: its processor and its load.
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

-- | Processor, cores, system and compiler, where known.
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

-- | The system's load average of the last minute; empty if unknown.
load :: IO String
load = takeWhile (not . isSpace) <$> contentOf "/proc/loadavg"

contentOf :: FilePath -> IO String
contentOf file = either nothing id <$> try (readFile file >>= \text -> length text `seq` pure text)
  where
    nothing :: IOException -> String
    nothing _ = ""
