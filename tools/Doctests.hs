-- | Runs the >>> examples in the documentation of source files: runghc tools/Doctests.hs FILE...
module Main (main) where

import System.Directory (listDirectory)
import System.Environment (getArgs)
import Test.DocTest (doctest)

main :: IO ()
main = do
  arguments <- getArgs
  wings <- listDirectory "src"
  doctest ("-v0" : ["-isrc/" ++ wing | wing <- wings] ++ arguments)
