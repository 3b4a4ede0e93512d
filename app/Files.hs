-- | Reading files: one that cannot be read is a plain message and status 2. The name @-@ is the standard input.
module Files
  ( readBytes
  , readBytesUpTo
  ) where

import Control.Exception (IOException, try)
import Control.Monad (when)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import System.Directory (doesDirectoryExist)
import System.IO (Handle, IOMode (..), stdin, withBinaryFile)
import System.IO.Error (isDoesNotExistError, isPermissionError)

import Ending

-- | A file's bytes; at most 256 MiB.
readBytes :: FilePath -> IO ByteString
readBytes = readBytesUpTo (256 * 1024 * 1024)

-- | A file's bytes, if there are not more than so many; otherwise leaves with status 2.
readBytesUpTo :: Int -> FilePath -> IO ByteString
readBytesUpTo limit file = do
  isFolder <- if file == "-" then pure False else doesDirectoryExist file
  when isFolder (unusable (file ++ " is a folder; a file is needed here"))
  outcome <- try (if file == "-" then readIt stdin else withBinaryFile file ReadMode readIt)
  either (unusable . readMessage file) (maybe (unusable tooLarge) pure) outcome
  where
    -- The size is not asked for beforehand, so that pipes can be read too.
    readIt :: Handle -> IO (Maybe ByteString)
    readIt handle = do
      bytes <- Lazy.hGet handle (limit + 1)
      pure (if Lazy.length bytes > fromIntegral limit then Nothing else Just (Lazy.toStrict bytes))
    tooLarge = file ++ " is larger than " ++ show (limit `div` (1024 * 1024)) ++ " MiB, which no input of this kind needs"

-- | Why a file cannot be read.
readMessage :: FilePath -> IOException -> String
readMessage file problem
  | isDoesNotExistError problem = "there is no file " ++ file
  | isPermissionError problem = "no permission to read " ++ file
  | otherwise = "cannot read " ++ file ++ ": " ++ systemReason problem
