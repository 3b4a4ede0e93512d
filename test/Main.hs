-- | All specifications, by hand, because hspec-discover is not everywhere to be had.
module Main (main) where

import Test.Hspec (describe, hspec)

import qualified Test.Code.Array
import qualified Test.Code.Field
import qualified Test.House

main :: IO ()
main = hspec $ do
  describe "House" Test.House.spec
