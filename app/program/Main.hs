-- | The executable: all of it is the library @command-line@, so that tests reach its parsers.
module Main (main) where

import qualified CommandLine

main :: IO ()
main = CommandLine.main
