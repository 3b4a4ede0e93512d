-- | The laws with hspec: each an item under its name.
module Main (main) where

import PraTactile.Conformance (lawProperties, library)
import Test.Hspec (describe, hspec, it)

main :: IO ()
main = hspec . describe "the laws of pra-tactile" $ mapM_ (uncurry it) (lawProperties library)
