-- | A progress bar on the standard error, where that is a terminal; nothing anywhere else.
module Progress
  ( withProgress,
    follow,
    tellingAsRead,
    Meanwhile (..),
    besideOutput,
  )
where

import Control.Exception (finally)
import Control.Monad (when)
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef
import GHC.Clock (getMonotonicTime)
import PraTactile.Steps (Steps (..))
import System.IO (hFlush, hIsTerminalDevice, hPutStr, stderr, stdout)
import System.IO.Unsafe (unsafeInterleaveIO)

-- | Run an action, which calls its argument with how much is done each time something more is;
-- given how much there is to do in all, and how much was done before.
withProgress :: Integer -> Integer -> ((Integer -> IO ()) -> IO a) -> IO a
withProgress total before action = do
  shown <- hIsTerminalDevice stderr
  start <- getMonotonicTime
  drawn <- newIORef (start - 1)
  let tell done = when shown $ do
        now <- getMonotonicTime
        last' <- readIORef drawn
        -- Ten times a second is often enough for an eye.
        when (now - last' > 0.1 || done >= total) $ do
          writeIORef drawn now
          draw (bar total before done (now - start))
      draw line = hPutStr stderr ('\r' : line ++ "\ESC[K") >> hFlush stderr
  when shown (draw (bar total before before 0))
  action tell `finally` when shown (draw "")

-- | Whether lines go to the standard output at the same time.
data Meanwhile = Printing | NotPrinting
  deriving stock (Eq)

-- | Likewise, but without a bar where lines are printed to a terminal: they and the bar would run
-- into each other.
besideOutput :: Meanwhile -> Integer -> ((Integer -> IO ()) -> IO a) -> IO a
besideOutput meanwhile total action = do
  mixed <- (meanwhile == Printing &&) <$> hIsTerminalDevice stdout
  if mixed then action (const (pure ())) else withProgress total 0 action

-- | Pieces of output as one, each telling how much is done when it comes to be written.
tellingAsRead :: (Integer -> IO ()) -> [(Integer, Lazy.ByteString)] -> IO Lazy.ByteString
tellingAsRead tell = fmap Lazy.concat . go
  where
    go pieces = case pieces of
      [] -> pure []
      (done, bytes) : more -> unsafeInterleaveIO (tell done >> (bytes :) <$> go more)

-- | The result of a computation in steps, each of which is how much is done.
follow :: Integral n => (Integer -> IO ()) -> Steps n a -> IO a
follow tell steps = case steps of
  Step done more -> tell (toInteger done) >> follow tell more
  Done a -> pure a

-- | One line of less than 80 characters.
bar :: Integer -> Integer -> Integer -> Double -> String
bar total before done seconds =
  "["
    ++ replicate full '#'
    ++ replicate (40 - full) '.'
    ++ "] "
    ++ show done
    ++ "/"
    ++ show total
    ++ left
  where
    full = fromInteger (40 * done `div` max 1 total)
    fresh = done - before
    left
      | fresh <= 0 || done >= total = ""
      | otherwise =
        ", "
          ++ duration (round (seconds * fromInteger (total - done) / fromInteger fresh))
          ++ " left"

-- | Hours, minutes and seconds: 1:02:03.
duration :: Integer -> String
duration seconds
  | seconds >= 3600 =
    show (seconds `div` 3600)
      ++ ":"
      ++ two (seconds `div` 60 `mod` 60)
      ++ ":"
      ++ two (seconds `mod` 60)
  | otherwise = show (seconds `div` 60) ++ ":" ++ two (seconds `mod` 60)
  where
    two n = if n < 10 then '0' : show n else show n
