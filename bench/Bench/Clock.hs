{-# OPTIONS_GHC -fno-full-laziness #-}

-- | Measuring a pure function: how long it takes to evaluate its result, and how much memory the
-- process has had.
module Bench.Clock
  ( -- * Measurements
    Measurement (..),
    Unit (..),
    unitName,

    -- * Taking them
    timed,
    timedEach,
    peakMebibytes,
  )
where

import Control.Exception (evaluate)
import Data.Char (isDigit)
import Data.List (isPrefixOf)
import GHC.Clock (getMonotonicTime)
import Text.Read (readMaybe)

-- | What a measurement's value counts.
data Unit
  = -- | Seconds: less is better.
    Seconds
  | -- | So many of these a second: more is better.
    PerSecond String
  deriving stock (Eq, Show)

-- | As the JSON lines have it.
unitName :: Unit -> String
unitName Seconds = "s"
unitName (PerSecond things) = things ++ "/s"

-- | One value, and a text that tells whether another program did the same work.
data Measurement = Measurement
  { measured :: !Double,
    measuredIn :: !Unit,
    check :: String
  }
  deriving stock (Eq, Show)

-- | The seconds that a function takes to evaluate its result to weak head normal form, and the
-- result. Not inlined and without full laziness, so that no application is shared between two
-- measurements.
timed :: (a -> b) -> a -> IO (Double, b)
timed f x = do
  start <- getMonotonicTime
  y <- evaluate (f x)
  end <- getMonotonicTime
  pure (end - start, y)
{-# NOINLINE timed #-}

-- | The mean seconds that a function takes over arguments that have been evaluated before, and the
-- last result.
timedEach :: (a -> b) -> b -> [a] -> IO (Double, b)
timedEach f before xs = do
  mapM_ evaluate xs
  start <- getMonotonicTime
  y <- go before xs
  end <- getMonotonicTime
  pure ((end - start) / fromIntegral (max 1 (length xs)), y)
  where
    go y [] = pure y
    go _ (a : rest) = evaluate (f a) >>= \y -> go y rest
{-# NOINLINE timedEach #-}

-- | The largest resident set of this process so far, in MiB; 0 where the system does not tell.
peakMebibytes :: IO Double
peakMebibytes = do
  status <- readFile "/proc/self/status"
  let kibibytes =
        [ readMaybe (takeWhile isDigit (dropWhile (not . isDigit) l))
          | l <- lines status,
            "VmHWM:" `isPrefixOf` l
        ]
  pure (sum [k / 1024 | Just k <- kibibytes])
