-- | Reading files: one that cannot be read is a plain message and status 2. The name @-@ is the
-- standard input.
module Files
  ( readBytes,
    readBytesUpTo,
  )
where

import Data.ByteString (ByteString)
import ExitStatus
import Message.Files (filesMessage)
import PraTactile.Files (largestInput, readUpTo)

-- | A file's bytes; at most 256 MiB.
readBytes :: FilePath -> IO ByteString
readBytes = readBytesUpTo largestInput

-- | A file's bytes; leaves with status 2 if there are more than this many.
readBytesUpTo :: Int -> FilePath -> IO ByteString
readBytesUpTo limit file = readUpTo limit file >>= orUnusable filesMessage
