{-# OPTIONS_GHC -fno-full-laziness #-}

-- | Measures a pure function: the time to evaluate its result, and the peak memory of the process.
module Bench.Clock
  ( -- * Measurements
    Measurement (..),
    Unit (..),
    unitName,

    -- * Measuring
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

-- | The unit of a measurement.
data Unit
  = -- | Seconds; less is better.
    Seconds
  | -- | A rate per second of the named things; more is better.
    PerSecond String
  deriving stock (Eq, Show)

-- | The unit in the JSON lines.
unitName :: Unit -> String
unitName Seconds = "s"
unitName (PerSecond things) = things ++ "/s"

-- | A measured value, and a text by which programs show that they did the same work.
data Measurement = Measurement
  { measured :: !Double,
    measuredIn :: !Unit,
    check :: String
  }
  deriving stock (Eq, Show)

-- | The seconds to evaluate a function's result to weak head normal form, and the result. It is
-- not inlined, and full laziness is off, so that no application is shared between measurements.
timed :: (a -> b) -> a -> IO (Double, b)
timed f x = do
  start <- getMonotonicTime
  y <- evaluate (f x)
  end <- getMonotonicTime
  pure (end - start, y)
{-# NOINLINE timed #-}

-- | The mean seconds per argument, with the arguments evaluated before; and the last result.
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

-- | The peak resident memory of this process, in MiB; 0 if the system does not report it.
peakMebibytes :: IO Double
peakMebibytes = do
  status <- readFile "/proc/self/status"
  let kibibytes =
        [ readMaybe (takeWhile isDigit (dropWhile (not . isDigit) l))
          | l <- lines status,
            "VmHWM:" `isPrefixOf` l
        ]
  pure (sum [k / 1024 | Just k <- kibibytes])
