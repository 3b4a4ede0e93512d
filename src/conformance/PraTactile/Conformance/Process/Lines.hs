-- | Reads the lines of a process, each with a limit of time and of length, so that memory is
-- bounded.
module PraTactile.Conformance.Process.Lines
  ( Line (..),
    nextLine,

    -- * Unrequested output
    Flood (..),
    longestFlood,
    drain,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.IORef
import GHC.Clock (getMonotonicTime)
import PraTactile.Conformance.Process.Child
import PraTactile.Conformance.Wire.Line (longestLine)

-- | A line, or what was read instead.
data Line
  = -- | The line without its line end.
    Line ByteString
  | -- | The output ended with this text, without a line end.
    NoMore ByteString
  | -- | Only this part of a line came before the deadline.
    Unfinished ByteString
  | -- | The line is longer than 'longestLine'; this is its beginning.
    Oversized ByteString

-- | Reads the next line until a deadline on the monotonic clock.
nextLine :: Child -> Double -> IO Line
nextLine child deadline = do
  there <- readIORef (unread child)
  search [] 0 there
  where
    -- The pieces of the line so far, last one first, without a line end; and their length.
    search pieces size piece = case Bytes.elemIndex '\n' piece of
      Just i
        | size + i <= longestLine -> do
          keep (Bytes.drop (i + 1) piece)
          pure (Line (Bytes.concat (reverse (Bytes.take i piece : pieces))))
      _ | size + Bytes.length piece > longestLine -> do
        keep piece
        pure (Oversized (Bytes.take 100 (Bytes.concat (reverse (piece : pieces)))))
      _ -> do
        let pieces' = if Bytes.null piece then pieces else piece : pieces
            whole = Bytes.concat (reverse pieces')
        more <- receive child deadline
        case more of
          Received bytes -> search pieces' (size + Bytes.length piece) bytes
          OutputEnds -> keep Bytes.empty >> pure (NoMore whole)
          Late -> keep whole >> pure (Unfinished whole)
    keep = writeIORef (unread child)

-- | The amount of unrequested output.
data Flood = Flood
  { floodLines :: Int,
    floodBytes :: Int
  }

-- | The number of bytes after which unrequested output counts as endless. The amount decides, not
-- the speed.
longestFlood :: Int
longestFlood = 16 * longestLine

-- | Reads and drops output until the given number of lines or more than 'longestFlood' bytes came,
-- nothing came for @silence@ seconds, or @seconds@ passed.
drain :: Child -> Double -> Double -> Int -> IO Flood
drain child silence seconds mostLines = do
  there <- readIORef (unread child)
  writeIORef (unread child) Bytes.empty
  now <- getMonotonicTime
  go (now + seconds) (Flood 0 0) there
  where
    go deadline before bytes
      | floodLines flood >= mostLines || floodBytes flood > longestFlood = pure flood
      | otherwise = do
        now <- getMonotonicTime
        more <- receive child (min deadline (now + silence))
        case more of
          Received piece | now < deadline -> go deadline flood piece
          _ -> pure flood
      where
        flood =
          Flood
            { floodLines = floodLines before + Bytes.count '\n' bytes,
              floodBytes = floodBytes before + Bytes.length bytes
            }
