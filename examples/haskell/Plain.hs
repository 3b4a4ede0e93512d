-- | The laws with plain QuickCheck: those of the field, each under its name.
module Main (main) where

import Control.Monad (unless)
import Data.List (isPrefixOf)
import PraTactile.Conformance (lawProperties, library)
import System.Exit (exitFailure)
import Test.QuickCheck (isSuccess, quickCheckResult)

main :: IO ()
main = do
  held <- mapM tried [law | law@(name, _) <- lawProperties library, "field/" `isPrefixOf` name]
  unless (and held) exitFailure
  where
    tried (name, property) = putStr (name ++ ": ") >> isSuccess <$> quickCheckResult property
