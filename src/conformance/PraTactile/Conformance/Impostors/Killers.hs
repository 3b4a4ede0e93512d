{-# LANGUAGE TemplateHaskell #-}

-- | Which laws find an impostor: what trying all of them took minutes to find out, as data.
module PraTactile.Conformance.Impostors.Killers
  ( killersOf,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.FileEmbed (embedFile)
import qualified Data.Map.Strict as Map

-- | The ids of laws that find the impostor of this name under some default profile, with seed
-- 1, in the order of the suite.
killersOf :: String -> [String]
killersOf name = Map.findWithDefault [] name killers

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
