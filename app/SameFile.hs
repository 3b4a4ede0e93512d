-- | Whether two paths lead to one file.
module SameFile
  ( sameFile,
  )
where

import Control.Exception (IOException, try)
import System.Posix.Files (deviceID, fileID, getFileStatus)

-- | Whether both paths lead to the same file, however they are spelt and over whatever links, hard
-- ones among them. What does not exist is the same as nothing.
sameFile :: FilePath -> FilePath -> IO Bool
sameFile a b = (\x y -> Just True == ((==) <$> x <*> y)) <$> identity a <*> identity b
  where
    identity path =
      either none (\status -> Just (deviceID status, fileID status)) <$> try (getFileStatus path)
    none :: IOException -> Maybe a
    none _ = Nothing
