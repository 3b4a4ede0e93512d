{-# OPTIONS_HADDOCK hide #-}

-- | Seals, by which a row shows that it was not changed. A seal is the first 60 bits of the
-- SHA-256 of the table's name and the row's other columns in order, one per line. A number is
-- written in decimal digits, a text as its number of bytes in UTF-8, a colon and the text, a null
-- as a hyphen. A seal protects against damage, not against forgery: every writer can compute it.
module PraTactile.Store.Seal
  ( sealed,
    isSealed,
  )
where

import Data.Bits (shiftL, shiftR, (.|.))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.Int (Int64)
import Data.Maybe (listToMaybe)
import Data.Text.Encoding (encodeUtf8)
import Data.Word (Word64)
import Database.Persist.Sql
import PraTactile.Certificate.Digest (sha256Bytes)

-- | The row with its seal. The argument makes the row from a seal.
sealed :: PersistEntity row => (Int64 -> row) -> row
sealed unsealed = unsealed (sealOf (unsealed 0))

-- | Whether the last column of a row is its correct seal.
isSealed :: PersistEntity row => row -> Bool
isSealed row =
  fmap toPersistValue (lastOf (toPersistFields row)) == Just (PersistInt64 (sealOf row))
  where
    lastOf = listToMaybe . reverse

sealOf :: PersistEntity row => row -> Int64
sealOf row =
  first60 . sha256Bytes . Bytes8.unlines $
    encodeUtf8 (unEntityNameDB (getEntityDBName (entityDef (Just row)))) :
    map (spelt . toPersistValue) (init' (toPersistFields row))
  where
    first60 = fromIntegral . (`shiftR` 4) . Bytes.foldl' shifted (0 :: Word64) . Bytes.take 8
    shifted bits byte = (bits `shiftL` 8) .|. fromIntegral byte
    init' fields = zipWith const fields (drop 1 fields)

spelt :: PersistValue -> Bytes.ByteString
spelt value = case value of
  PersistInt64 n -> Bytes8.pack (show n)
  PersistText text ->
    let bytes = encodeUtf8 text in Bytes8.pack (show (Bytes.length bytes) ++ ":") <> bytes
  PersistNull -> Bytes8.pack "-"
  other -> Bytes8.pack (show other)
