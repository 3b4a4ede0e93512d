-- | Converts bytes to text. Every text format, from files and standard input, is read through
-- 'plainText', so that byte order marks, encodings and line ends are treated alike.
--
-- Windows' editors and spreadsheets put a byte order mark before a text, PowerShell writes UTF-16,
-- and lines end with LF, CR LF, or CR alone.
module PraTactile.PlainText
  ( plainText,
    plainUtf8,
    OtherEncoding (..),
    encodingName,
    NotUtf8Text (..),

    -- * Parts
    byteOrderMark,
    withoutMark,
    otherEncoding,
    lineFeeds,
  )
where

import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.List (find)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import Data.Text.Encoding (decodeUtf8')

-- | An encoding that is not UTF-8.
data OtherEncoding = Utf16 | Utf32
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The name of the encoding.
encodingName :: OtherEncoding -> String
encodingName encoding = case encoding of
  Utf16 -> "UTF-16"
  Utf32 -> "UTF-32"

-- | Why bytes are not UTF-8 text.
data NotUtf8Text
  = -- | They are text in this other encoding.
    InEncoding OtherEncoding
  | -- | They contain bytes that do not occur in UTF-8 text.
    NotUtf8Text
  deriving stock (Eq, Show)

-- | A text without its byte order mark and with LF as every line end. Refuses other encodings.
--
-- >>> import Data.String (fromString)
-- >>> plainText (fromString "\xEF\xBB\xBFv 1\rv 2\r\nv 3\n")
-- Right "v 1\nv 2\nv 3\n"
-- >>> plainText (fromString "\xFF\xFEv\NUL")
-- Left Utf16
plainText :: ByteString -> Either OtherEncoding ByteString
plainText bytes = maybe (Right (lineFeeds (withoutMark bytes))) Left (otherEncoding bytes)

-- | The characters of a UTF-8 text, after 'plainText'. Refuses other encodings and invalid bytes.
plainUtf8 :: ByteString -> Either NotUtf8Text Text
plainUtf8 bytes =
  first InEncoding (plainText bytes) >>= first (const NotUtf8Text) . decodeUtf8'

-- | The byte order mark U+FEFF in UTF-8.
byteOrderMark :: ByteString
byteOrderMark = Bytes.pack [0xEF, 0xBB, 0xBF]

-- | The bytes after the byte order mark, or all bytes without one.
withoutMark :: ByteString -> ByteString
withoutMark bytes = fromMaybe bytes (Bytes.stripPrefix byteOrderMark bytes)

-- | The other encoding of a text: found by its mark, or by zeros among its first characters, which
-- are ASCII in every format. 'Nothing' if there is no sign of one.
otherEncoding :: ByteString -> Maybe OtherEncoding
otherEncoding bytes = snd <$> find (matches . fst) forms
  where
    begin = Bytes.unpack (Bytes.take 4 bytes)
    matches form = length begin >= length form && and (zipWith ($) form begin)
    forms =
      [ ([(== 0xFF), (== 0xFE), (== 0), (== 0)], Utf32),
        ([(== 0), (== 0), (== 0xFE), (== 0xFF)], Utf32),
        ([(== 0xFF), (== 0xFE)], Utf16),
        ([(== 0xFE), (== 0xFF)], Utf16),
        ([letter, (== 0), (== 0), (== 0)], Utf32),
        ([(== 0), (== 0), (== 0), letter], Utf32),
        ([letter, (== 0), letter, (== 0)], Utf16),
        ([(== 0), letter, (== 0), letter], Utf16)
      ]
    letter c = c >= 9 && c < 127

-- | Replaces every line end CR LF or CR by LF. O(n).
lineFeeds :: ByteString -> ByteString
lineFeeds bytes
  | Bytes.notElem 13 bytes = bytes
  | otherwise = fst (Bytes.unfoldrN (Bytes.length bytes) step 0)
  where
    step i
      | i >= Bytes.length bytes = Nothing
      | Bytes.index bytes i /= 13 = Just (Bytes.index bytes i, i + 1)
      | i + 1 < Bytes.length bytes, Bytes.index bytes (i + 1) == 10 = Just (10, i + 2)
      | otherwise = Just (10, i + 1)
