-- | Which mutant is on, in the copy of the sources that @make mutate@ tests. It is no part of the
-- library.
module Mutant (chosen) where

import Control.Exception (IOException, catch)
import Data.IORef (IORef, atomicModifyIORef', newIORef)
import qualified Data.IntSet as Set
import System.Environment (lookupEnv)
import System.IO.Unsafe (unsafePerformIO)

-- | The variant that is on at a site, from 1; 0 is what stands in the sources. The environment
-- variable @PRA_TACTILE_MUTANT@ names it as @SITE.VARIANT@. With @PRA_TACTILE_SITES=FILE@ the
-- number of each site that is reached is appended to that file, once.
chosen :: Int -> Int
chosen site = unsafePerformIO $ do
  trace <- lookupEnv "PRA_TACTILE_SITES"
  case trace of
    Nothing -> pure ()
    Just file -> do
      first <-
        atomicModifyIORef' reached (\known -> (Set.insert site known, Set.notMember site known))
      if first then appendFile file (show site ++ "\n") `catch` nowhere else pure ()
  name <- lookupEnv "PRA_TACTILE_MUTANT"
  pure $ case break (== '.') <$> name of
    Just (which, '.' : variant) | which == show site -> read variant
    _ -> 0
  where
    -- A test may leave no room for any file.
    nowhere :: IOException -> IO ()
    nowhere _ = pure ()
{-# NOINLINE chosen #-}

-- | The sites that were reached.
reached :: IORef Set.IntSet
reached = unsafePerformIO (newIORef Set.empty)
{-# NOINLINE reached #-}
