{-# LANGUAGE OverloadedStrings #-}

-- | The standard input line by line, each in memory no longer than it is needed, and none beyond a
-- bound. A line ends with LF, CR LF or CR.
module Lines
  ( Line (..),
    forLines,
    lineText,
    linePath,
    largestLine,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8')
import GHC.Foreign (peekCStringLen)
import GHC.IO.Encoding (getFileSystemEncoding)
import System.IO (stdin)

-- | A line, without its end.
data Line
  = Line Text
  | -- | it holds bytes that are no UTF-8; these
    NotUtf8 ByteString
  | -- | it has this many bytes, more than 'largestLine'
    TooLong Integer
  deriving stock (Eq, Show)

-- | How many bytes a line may have: 1 MiB.
largestLine :: Int
largestLine = 1024 * 1024

-- | What a line says, or why that cannot be read.
lineText :: Line -> Either String Text
lineText given = case given of
  Line text -> Right text
  NotUtf8 _ -> Left "the line is not UTF-8 text"
  TooLong size ->
    Left ("the line has " ++ show size ++ " bytes; at most " ++ show largestLine ++ " are read")

-- | The file that a line names, whatever its bytes; no name where it is too long for one.
linePath :: Line -> IO FilePath
linePath given = case given of
  Line text -> pure (Text.unpack text)
  NotUtf8 bytes -> do
    encoding <- getFileSystemEncoding
    Bytes.useAsCStringLen bytes (peekCStringLen encoding)
  TooLong _ -> pure ""

-- | Go through the lines of the standard input as they come. What follows the last end of line is a
-- line if it is not empty.
forLines :: (a -> Line -> IO a) -> a -> IO a
forLines step = awaited [] 0
  where
    -- What follows a CR, which may have been the first half of an end of line.
    afterReturn state = do
      piece <- Bytes.hGetSome stdin 65536
      if Bytes.null piece then pure state else broken [] 0 (withoutFeed piece) state
    -- The pieces of the line so far, the latest first, and how many bytes they have.
    awaited pieces held state = do
      piece <- Bytes.hGetSome stdin 65536
      if Bytes.null piece
        then if held == 0 then pure state else step state (line (reverse pieces))
        else broken pieces held piece state
    broken pieces held piece state = case Bytes.findIndex isEnd piece of
      Just end -> next (line (reverse (Bytes.take end piece : pieces))) (Bytes.drop end piece) state
      Nothing
        | held' <= largestLine -> awaited (piece : pieces) held' state
        | otherwise -> skipped (toInteger held') state
        where
          held' = held + Bytes.length piece
    -- What is left of a line that is too long is counted, not kept.
    skipped count state = do
      piece <- Bytes.hGetSome stdin 65536
      case Bytes.findIndex isEnd piece of
        Just end -> next (TooLong (count + toInteger end)) (Bytes.drop end piece) state
        Nothing
          | Bytes.null piece -> step state (TooLong count)
          | otherwise -> skipped (count + toInteger (Bytes.length piece)) state
    -- Answer a line; the others begin with its end.
    next found others state = do
      state' <- step state found
      state' `seq` case Bytes.uncons others of
        Just (13, others')
          | Bytes.null others' -> afterReturn state'
          | otherwise -> broken [] 0 (withoutFeed others') state'
        _ -> broken [] 0 (Bytes.drop 1 others) state'
    withoutFeed piece = fromMaybe piece (Bytes.stripPrefix "\n" piece)
    isEnd byte = byte == 10 || byte == 13

line :: [ByteString] -> Line
line chunks
  | Bytes.length whole > largestLine = TooLong (toInteger (Bytes.length whole))
  | otherwise = either (const (NotUtf8 whole)) Line (decodeUtf8' whole)
  where
    whole = Bytes.concat chunks
