{-# LANGUAGE OverloadedStrings #-}
-- | The JSON that results are printed as. Keys are promises; integers above 2^53 - 1 are decimal strings, because many
-- readers of JSON hold numbers as IEEE doubles.
module Json
  ( -- * Printing
    printJson
  , encodeLine
    -- * Values
  , naturalValue
  , positionValue
  , positionListValue
  , shapeText
  , surfaceName
  , foldingName
  , chanceSeries
  ) where

import Data.Aeson
import Data.Aeson.Encoding (encodingToLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Text.Encoding.Error (lenientDecode)
import qualified Data.Text.Lazy.Encoding as Lazy
import Numeric.Natural (Natural)

import PraTactile.Array (Folding (..), Position (..), Shape (..), Surface (..))
import PraTactile.Locate.Chance (Chance (..))

-- | One object on one line, its keys in the order given.
encodeLine :: Series -> Lazy.ByteString
encodeLine = valid . encodingToLazyByteString . pairs
  where
    -- Whatever was in a text, JSON is UTF-8.
    valid = Lazy.encodeUtf8 . Lazy.decodeUtf8With lenientDecode

-- | Print one object on one line.
printJson :: Series -> IO ()
printJson = Lazy.putStrLn . encodeLine

-- | A number, or a decimal string where a double would round it.
naturalValue :: Natural -> Value
naturalValue n
  | n <= 2 ^ (53 :: Int) - 1 = toJSON (fromIntegral n :: Integer)
  | otherwise = toJSON (show n)

-- | @{"row": r, "column": c}@.
positionValue :: Position -> Value
positionValue (Position r c) = object ["row" .= naturalValue r, "column" .= naturalValue c]

-- | @[r, c]@, where many positions are listed.
positionListValue :: Position -> Value
positionListValue (Position r c) = toJSON [naturalValue r, naturalValue c]

-- | As the command line takes it: @15x17@.
shapeText :: Shape -> String
shapeText (Shape high wide) = show high ++ "x" ++ show wide

-- | As the command line takes it.
surfaceName :: Surface -> String
surfaceName surface = case surface of
  Torus -> "torus"
  TwistedTorus -> "twisted-torus"
  Sheet -> "sheet"

-- | As profiles have it.
foldingName :: Folding -> String
foldingName folding = case folding of
  Diagonal -> "diagonal"
  RowMajor -> "row-major"

-- | @chance@ and @chance_is@: both null where no cell was observed.
chanceSeries :: Maybe Chance -> Series
chanceSeries worth = "chance" .= fmap chanceShare worth <> "chance_is" .= fmap bound worth
  where
    bound found = if chanceExact found then "exact" else "at-most" :: String
