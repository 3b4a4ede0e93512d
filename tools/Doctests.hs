-- | Runs the >>> examples of the sources' documentation: runghc tools/Doctests.hs FILE...
module Main (main) where

import System.Environment (getArgs)
import Test.DocTest (doctest)

main :: IO ()
main = getArgs >>= doctest . (["-isrc/common", "-isrc/code", "-isrc/touch", "-isrc/recognition", "-v0"] ++)
