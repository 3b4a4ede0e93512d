{-# LANGUAGE TemplateHaskell #-}

-- | Which laws find an impostor: what trying all of them took minutes to find out, as data.
module PraTactile.Conformance.Impostors.Killers
  ( killersOf,
    killersOfProcess,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.FileEmbed (embedFile)
import Data.List (isSuffixOf)
import qualified Data.Map.Strict as Map
import PraTactile.Conformance.Laws.Order (orderName)

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
      | line <- lines (Bytes.unpack file),
        name : laws <- [words line]
    ]

-- | A line an impostor: its name and a colon, and the laws.
file :: ByteString
file = $(embedFile "data/impostors.txt")
