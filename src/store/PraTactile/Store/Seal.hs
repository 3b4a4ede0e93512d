{-# OPTIONS_HADDOCK hide #-}

-- | Seals: what each row carries to tell that it is as it was written. A seal is the first 60 bits
-- of the SHA-256 of the table's name and of the row's other columns in their order, each on a line
-- of its own: a number as its decimal digits, a text as the number of its bytes in UTF-8, a colon
-- and the text, nothing as a hyphen. It guards against damage, not against forgery: whoever can
-- write can seal.
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

-- | A row with its seal, given the row by any.
sealed :: PersistEntity row => (Int64 -> row) -> row
sealed unsealed = unsealed (sealOf (unsealed 0))

-- | Whether the last column of a row is its seal.
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
