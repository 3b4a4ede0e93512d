-- | The lines that a process writes, each within a time, a length and thus a memory.
module PraTactile.Conformance.Process.Lines
  ( Line (..),
    nextLine,

    -- * What nobody asked for
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

-- | What was read in place of a line, or the line.
data Line
  = -- | Without its end.
    Line ByteString
  | -- | The output ends with this, after which there is no end of a line.
    NoMore ByteString
  | -- | This much of a line has come until the time.
    Unfinished ByteString
  | -- | It is longer than 'longestLine'; this is how it begins.
    Oversized ByteString

-- | The next line, if it comes until a time on the monotonic clock.
nextLine :: Child -> Double -> IO Line
nextLine child deadline = do
  there <- readIORef (unread child)
  search [] 0 there
  where
    -- The pieces of the line so far, the last one first, none of which has an end; their length.
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

-- | How much came that nobody asked for.
data Flood = Flood
  { floodLines :: Int,
    floodBytes :: Int
  }

-- | The bytes after which output that nobody asked for counts as endless: what decides is how much
-- comes, not how fast.
longestFlood :: Int
longestFlood = 16 * longestLine

-- | Read and forget what a process still writes, until so many lines or more than 'longestFlood'
-- bytes have come, nothing comes for so many seconds, or so many have passed.
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
