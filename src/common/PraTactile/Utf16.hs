-- | Texts that are not UTF-8 but UTF-16, which some editors and spreadsheets write.
module PraTactile.Utf16
  ( isUtf16,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes

-- | Whether a text begins as UTF-16 does: with its byte order mark, or with a character of which
-- one of two bytes is zero. No text that is read here begins with a NUL.
isUtf16 :: ByteString -> Bool
isUtf16 text = case Bytes.unpack (Bytes.take 2 text) of
  [0xFF, 0xFE] -> True
  [0xFE, 0xFF] -> True
  [one, other] -> (one == 0) /= (other == 0)
  _ -> False
