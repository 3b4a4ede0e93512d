-- | All laws under all default profiles in one call. Put your own 'Implementation' in the place of
-- 'library'.
module Main (main) where

import PraTactile.Conformance (library, runLaws)
import System.Exit (exitWith)

main :: IO ()
main = runLaws library >>= exitWith
