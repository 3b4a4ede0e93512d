-- | Valid names of files.
module PraTactile.FileName
  ( isFileName,
  )
where

-- | Whether a text can be a file's name: it is not empty and has no NUL, at which the system would
-- cut it.
isFileName :: FilePath -> Bool
isFileName name = not (null name) && '\0' `notElem` name
