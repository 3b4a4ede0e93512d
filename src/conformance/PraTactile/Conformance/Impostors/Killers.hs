-- | The laws that find each impostor, as data, because trying all laws takes minutes.
module PraTactile.Conformance.Impostors.Killers
  ( killersOf,
    killersOfProcess,
  )
where

import qualified Data.ByteString.Char8 as Bytes
import Data.List (isSuffixOf)
import qualified Data.Map.Strict as Map
import PraTactile.Conformance.Laws.Order (orderName)
import PraTactile.Embedded (impostorsFile)

-- | The ids of the laws that find the named impostor under some default profile with seed 1, in
-- the order of the suite.
killersOf :: String -> [String]
killersOf name = Map.findWithDefault [] name killers

-- | The laws that find the named impostor as a process. Laws about the order of questions do not:
-- the impostor makes its mistake whatever was asked before, and so does a fresh process.
killersOfProcess :: String -> [String]
killersOfProcess = filter (not . ofOrder) . killersOf
  where
    ofOrder law = ('/' : orderName) `isSuffixOf` law

killers :: Map.Map String [String]
killers =
  Map.fromList
    [ (takeWhile (/= ':') name, laws)
      | line <- lines (Bytes.unpack impostorsFile),
        name : laws <- [words line]
    ]
