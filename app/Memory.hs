-- | The memory that a command may use; its need is known before the work begins.
module Memory
  ( mostBytes,
    bytesText,
    orTooMuch,
  )
where

import Control.Monad (when)
import ExitStatus
import Text.Printf (printf)

-- | The largest memory in bytes: half of that of a small computer.
mostBytes :: Integer
mostBytes = 4000000000

-- | Bytes in words, to two digits.
--
-- >>> map bytesText [52300000, 2000000000]
-- ["52 MB","2.0 GB"]
bytesText :: Integer -> String
bytesText bytes
  | millions < 1000 = show (max 1 (round millions :: Integer)) ++ " MB"
  | otherwise = printf "%.1f GB" (millions / 1000)
  where
    millions = fromInteger bytes / 1e6 :: Double

-- | Leaves with status 2 where something would hold more than 'mostBytes'; given what it is, and
-- what to do instead.
orTooMuch :: String -> String -> Integer -> IO ()
orTooMuch what instead bytes =
  when (bytes > mostBytes) . unusable $
    what ++ " would hold about " ++ bytesText bytes ++ " at once; at most "
      ++ bytesText mostBytes
      ++ " are allowed: "
      ++ instead
