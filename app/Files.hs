-- | Reading files: one that cannot be read is a plain message and status 2. The name @-@ is the
-- standard input.
module Files
  ( readBytes,
    readBytesUpTo,
    alreadyIn,
    largestWork,
  )
where

import Data.ByteString (ByteString)
import ExitStatus
import Message.Files (filesMessage)
import Output (Target (..), targetOf)
import PraTactile.Files (largestInput, readUpTo)

-- | A file's bytes; at most 256 MiB.
readBytes :: FilePath -> IO ByteString
readBytes = readBytesUpTo largestInput

-- | A file's bytes; leaves with status 2 if there are more than this many.
readBytesUpTo :: Int -> FilePath -> IO ByteString
readBytesUpTo limit file = readUpTo limit file >>= orUnusable filesMessage

-- | 16 GiB: the most that is read of what the program itself wrote line by line.
largestWork :: Int
largestWork = 64 * largestInput

-- | The contents of a file that is to be continued; empty if there is none, or no regular file.
alreadyIn :: FilePath -> IO ByteString
alreadyIn name =
  targetOf name >>= orUnusable id >>= \target -> case target of
    Regular file (Just _) -> readBytesUpTo largestWork file
    _ -> pure mempty
