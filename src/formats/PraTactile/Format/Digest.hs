-- | Digests of texts.
module PraTactile.Format.Digest
  ( digestOf,
  )
where

import Data.ByteString (ByteString)
import PraTactile.Certificate.Digest (sha256)

-- | The SHA-256 of some bytes, as 64 hexadecimal digits in lower case.
--
-- >>> import qualified Data.ByteString.Char8 as Char8
-- >>> digestOf (Char8.pack "abc")
-- "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
digestOf :: ByteString -> String
digestOf = sha256
