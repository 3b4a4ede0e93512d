{-# LANGUAGE DerivingStrategies #-}
-- | How a command ends: the exit statuses, which scripts rely on, and the one form of a complaint.
module Ending
  ( -- * Exit statuses
    Ending (..)
  , finish
    -- * Bad usage and bad input
  , unusable
  , orUnusable
  , warn
  ) where

import System.Exit (ExitCode (..), exitWith)
import System.IO (hPutStrLn, stderr)

-- | The exit status.
data Ending
  = Answered      -- ^ 0
  | NotAnswered   -- ^ 1: well formed, but refused, ambiguous or refuted
  | Unusable      -- ^ 2: bad usage or bad input
  deriving stock (Eq, Ord, Show)

-- | Leave with the status of an ending.
finish :: Ending -> IO a
finish ending = exitWith $ case ending of
  Answered -> ExitSuccess
  NotAnswered -> ExitFailure 1
  Unusable -> ExitFailure 2

-- | Say on the standard error what is wrong and what to do, and leave with status 2.
unusable :: String -> IO a
unusable message = warn message >> finish Unusable

-- | The value, or 'unusable' with the error in words.
orUnusable :: (e -> String) -> Either e a -> IO a
orUnusable inWords = either (unusable . inWords) pure

-- | A line on the standard error.
warn :: String -> IO ()
warn message = hPutStrLn stderr ("pra-tactile: " ++ message)
