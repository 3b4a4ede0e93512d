-- | A progress bar on the standard error, where that is a terminal; nothing anywhere else.
module Progress
  ( withProgress
  ) where

import Control.Exception (finally)
import Control.Monad (when)
import Data.IORef
import GHC.Clock (getMonotonicTime)
import System.IO (hFlush, hIsTerminalDevice, hPutStr, stderr)

-- | Run an action that tells, each time something more is done, how much is done of so much; so much was done before.
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
  action tell `finally` when shown (draw "")

-- | One line of less than 80 characters.
bar :: Integer -> Integer -> Integer -> Double -> String
bar total before done seconds =
  "[" ++ replicate full '#' ++ replicate (40 - full) '.' ++ "] " ++ show done ++ "/" ++ show total ++ left
  where
    full = fromInteger (40 * done `div` max 1 total)
    fresh = done - before
    left
      | fresh <= 0 || done >= total = ""
      | otherwise = ", " ++ duration (round (seconds * fromInteger (total - done) / fromInteger fresh)) ++ " left"

-- | Hours, minutes and seconds: 1:02:03.
duration :: Integer -> String
duration seconds
  | seconds >= 3600 = show (seconds `div` 3600) ++ ":" ++ two (seconds `div` 60 `mod` 60) ++ ":" ++ two (seconds `mod` 60)
  | otherwise = show (seconds `div` 60) ++ ":" ++ two (seconds `mod` 60)
  where
    two n = if n < 10 then '0' : show n else show n
