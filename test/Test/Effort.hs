-- | How much the suite does. @PRA_TACTILE_EFFORT@ is @quick@, for a run that a person waits for, or
-- @full@, for everything. Only this module reads it; every test takes its cases, sizes, profiles
-- and languages from here.
module Test.Effort
  ( Effort (..),
    effort,
    byEffort,
    whenFull,
    withCases,
  )
where

import Data.Maybe (fromMaybe)
import System.Environment (lookupEnv)
import System.IO.Unsafe (unsafePerformIO)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)

-- | The two speeds.
data Effort = Quick | Full
  deriving stock (Eq, Show)

-- | The effort that the environment requests. Any word but these two ends the run.
effort :: Effort
effort = unsafePerformIO $ do
  given <- fromMaybe "quick" <$> lookupEnv "PRA_TACTILE_EFFORT"
  case given of
    "quick" -> pure Quick
    "full" -> pure Full
    other -> fail ("PRA_TACTILE_EFFORT is quick or full, and not " ++ other)
{-# NOINLINE effort #-}

-- | The first argument in a quick run, the second in a full one.
byEffort :: a -> a -> a
byEffort quick full = case effort of
  Quick -> quick
  Full -> full

-- | An action of full runs only.
whenFull :: Applicative f => f () -> f ()
whenFull = byEffort (const (pure ())) id

-- | The number of random cases of each property, in a quick and in a full run.
withCases :: Int -> Int -> SpecWith a -> SpecWith a
withCases quick full = modifyMaxSuccess (const (byEffort quick full))
