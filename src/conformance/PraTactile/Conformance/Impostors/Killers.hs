-- | Which laws find an impostor: what trying all of them took minutes to find out, as data.
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

-- | The ids of laws that find the impostor of this name under some default profile, with seed
-- 1, in the order of the suite.
killersOf :: String -> [String]
killersOf name = Map.findWithDefault [] name killers

-- | Those of them that find the impostor as a process. The laws of the order do not: the impostor
-- makes its mistake whatever was asked before, and so does a fresh process.
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
