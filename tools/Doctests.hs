-- | Runs the >>> examples of the sources' documentation: runghc tools/Doctests.hs FILE...
module Main (main) where

import System.Environment (getArgs)
import Test.DocTest (doctest)

main :: IO ()
main = getArgs >>= doctest . (["-isrc/" ++ wing | wing <- wings] ++) . ("-v0" :)
  where
    wings = ["common", "code", "touch", "simulation", "recognition", "formats"]
