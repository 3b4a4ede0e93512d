-- | How much the suite does. @PRA_TACTILE_EFFORT@ says so: @quick@, what a person waits for, or
-- @full@, everything. It is read here alone; every test takes its cases, sizes, profiles and
-- languages from here.
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

-- | What the environment asks for; anything but the two words ends the run.
effort :: Effort
effort = unsafePerformIO $ do
  given <- fromMaybe "quick" <$> lookupEnv "PRA_TACTILE_EFFORT"
  case given of
    "quick" -> pure Quick
    "full" -> pure Full
    other -> fail ("PRA_TACTILE_EFFORT is quick or full, and not " ++ other)
{-# NOINLINE effort #-}

-- | The first of a quick run, the second of a full one.
byEffort :: a -> a -> a
byEffort quick full = case effort of
  Quick -> quick
  Full -> full

-- | What a full run alone does.
whenFull :: Applicative f => f () -> f ()
whenFull = byEffort (const (pure ())) id

-- | So many random cases for each property.
withCases :: Int -> Int -> SpecWith a -> SpecWith a
withCases quick full = modifyMaxSuccess (const (byEffort quick full))
