-- | The form that every command's help has: what it does, and examples.
module Described
  ( described,
  )
where

import Ending
import Options.Applicative
import Options.Applicative.Help.Chunk (stringChunk, unChunk, vcatChunks)

-- | A command: its name, what it does in a sentence, examples of its use, and its options.
described :: String -> String -> [String] -> Parser (IO Ending) -> Mod CommandFields (IO Ending)
described name does examples options =
  command
    name
    (info (options <**> helper) (fullDesc <> progDesc does <> footerDoc (unChunk exampleText)))
  where
    exampleText = vcatChunks (map stringChunk (heading : map ("  " ++) examples))
    heading = if length examples == 1 then "Example:" else "Examples:"
