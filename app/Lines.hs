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
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8')
import ExitStatus
import GHC.Foreign (peekCStringLen)
import GHC.IO.Encoding (getFileSystemEncoding)
import Message.Format (encodingMessage)
import PraTactile.PlainText (otherEncoding, withoutMark)
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

-- | The text of a line, or why it cannot be read.
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

-- | Go through the lines of the standard input as they come; each ends with LF, CR LF or CR. What
-- follows the last end of line is a line if it is not empty. A byte order mark at the beginning is
-- passed over; leaves with status 2 where the first line is text in another encoding than UTF-8.
forLines :: (a -> Line -> IO a) -> a -> IO a
forLines step = awaited (Begun [] 0 True False)
  where
    awaited begun state = do
      piece <- Bytes.hGetSome stdin 65536
      case () of
        _
          | not (Bytes.null piece) -> broken begun piece state
          | begunBytes begun == 0 -> pure state
          | otherwise -> lineOf begun Bytes.empty >>= step state
    broken begun piece state
      | afterReturn begun && Bytes.take 1 piece == Bytes.singleton 10 =
        broken begun {afterReturn = False} (Bytes.drop 1 piece) state
      | otherwise = case endOfLine piece of
        Just end -> lineOf begun (Bytes.take end piece) >>= next piece end state
        Nothing
          | begunBytes longer <= largestLine -> awaited longer state
          | otherwise -> skipped (toInteger (begunBytes longer)) state
      where
        longer =
          begun
            { begunPieces = piece : begunPieces begun,
              begunBytes = begunBytes begun + Bytes.length piece,
              afterReturn = afterReturn begun && Bytes.null piece
            }
    -- What is left of a line that is too long is counted, not kept.
    skipped count state = do
      piece <- Bytes.hGetSome stdin 65536
      case endOfLine piece of
        Just end -> next piece end state (TooLong (count + toInteger end))
        Nothing
          | Bytes.null piece -> step state (TooLong count)
          | otherwise -> skipped (count + toInteger (Bytes.length piece)) state
    next piece end state found = do
      state' <- step state found
      let begun = Begun [] 0 False (Bytes.index piece end == 13)
      state' `seq` broken begun (Bytes.drop (end + 1) piece) state'
    endOfLine = Bytes.findIndex (\c -> c == 10 || c == 13)
    lineOf begun final = line (isFirst begun) (Bytes.concat (reverse (final : begunPieces begun)))

-- | What there is so far of a line.
data Begun = Begun
  { -- | the latest first
    begunPieces :: [ByteString],
    begunBytes :: !Int,
    isFirst :: !Bool,
    -- | whether the line before it ended with CR, so that LF would belong to that end
    afterReturn :: !Bool
  }

-- | A line of these bytes; the first one of the input may have a byte order mark.
line :: Bool -> ByteString -> IO Line
line begins bytes = case otherEncoding bytes of
  Just encoding | begins -> unusable ("the standard input" ++ encodingMessage encoding)
  _
    | Bytes.length bytes > largestLine -> pure (TooLong (toInteger (Bytes.length bytes)))
    | otherwise -> pure (either (const (NotUtf8 whole)) Line (decodeUtf8' whole))
  where
    whole = if begins then withoutMark bytes else bytes
