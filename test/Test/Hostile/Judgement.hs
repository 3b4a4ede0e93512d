-- | The demands on every answer to a hostile input: it comes soon, in little memory and in our own
-- words, and accepted inputs satisfy the laws of valid ones.
module Test.Hostile.Judgement
  ( Judged (..),
    judgedBy,
    judgedIn,
    withinBounds,
    internals,
    shareOf,
  )
where

import Control.Concurrent (forkIO, killThread, myThreadId, threadDelay)
import Control.Exception
import Control.Monad (forever, replicateM_)
import Data.IORef (modifyIORef', newIORef, readIORef)
import Data.Int (Int64)
import Data.List (isInfixOf)
import GHC.Conc (disableAllocationLimit, enableAllocationLimit, setAllocationCounter)
import GHC.Stats (gc, gc_cpu_ns, gcdetails_live_bytes, getRTSStats)
import System.CPUTime (getCPUTime)
import System.Mem (performMajorGC)
import Test.Effort
import Test.QuickCheck
import Visible

-- | The outcome of an input.
data Judged
  = -- | for this reason
    Refused String
  | -- | with laws by name, and everything that may be printed of it
    Accepted [(String, Bool)] String
  deriving stock (Eq, Show)

-- | Demands that the answer, evaluated in full, takes at most two seconds and 300 MB of memory;
-- that a refusal is one line of our own words; and that an accepted value satisfies the laws.
judgedBy :: Judged -> Property
judgedBy = judgedIn . pure

-- | Makes the demands of 'judgedBy' on an answer that an action gives.
judgedIn :: IO Judged -> Property
judgedIn asked = ioProperty $ do
  outcome <- withinBounds (asked >>= \answer -> answer <$ evaluate (weight answer))
  pure $ case outcome of
    Left problem -> counterexample problem False
    Right (Refused why) -> classify True "refused" (oneLine why)
    Right (Accepted laws said) ->
      classify True "accepted" $
        conjoin
          ( counterexample said (withoutInternals said) :
              [counterexample ("does not hold: " ++ law) holds | (law, holds) <- laws]
          )

-- | All characters of an answer, so that nothing of it is left unevaluated.
weight :: Judged -> Int
weight answer = case answer of
  Refused why -> length why
  Accepted laws said -> length (filter snd laws) + length said

-- | The result of an action, or the bound that it exceeded.
withinBounds :: IO a -> IO (Either String a)
withinBounds action = (quickly `catch` \AllocationLimitExceeded -> watched) `catch` failed
  where
    quickly = do
      setAllocationCounter most
      enableAllocationLimit
      ended <$> (computingFor 2 action `finally` disableAllocationLimit)
    -- This much was allocated, but some may have been freed. Run it again and look from time to
    -- time at the live data, which takes time as well.
    watched = do
      before <- alive
      greatest <- newIORef before
      -- A collection takes long where much else is live.
      watcher <- forkIO . forever $ do
        alive >>= modifyIORef' greatest . max
        replicateM_ 25 (threadDelay 20000 >> live >>= modifyIORef' greatest . max)
      found <- computingFor 5 action `finally` killThread watcher
      used <- subtract before <$> readIORef greatest
      pure
        ( if used > most
            then Left ("memory of " ++ show used ++ " bytes was taken")
            else ended found
        )
    alive = performMajorGC >> live
    live = fromIntegral . gcdetails_live_bytes . gc <$> getRTSStats
    most = 300 * 1000 * 1000 :: Int64
    ended = maybe (Left "there was no answer in time") Right
    -- QuickCheck's own interruptions go on.
    failed problem = case fromException problem of
      Just asynchronous -> throwIO (asynchronous :: SomeAsyncException)
      Nothing -> pure (Left ("an exception: " ++ displayException (problem :: SomeException)))

-- | The result of an action, unless this process computes for longer than this many seconds.
-- Neither the time of other processes nor that of collecting the whole suite's garbage counts.
computingFor :: Integer -> IO a -> IO (Maybe a)
computingFor seconds action = do
  start <- computed
  caller <- myThreadId
  let watch = do
        threadDelay 100000
        now <- computed
        if now - start > seconds * 10 ^ (12 :: Int) then throwTo caller ComputedTooLong else watch
  (Just <$> bracket (forkIO watch) killThread (const action))
    `catch` \ComputedTooLong -> pure Nothing
  where
    -- In picoseconds.
    computed = do
      collecting <- gc_cpu_ns <$> getRTSStats
      subtract (1000 * toInteger collecting) <$> getCPUTime

data ComputedTooLong = ComputedTooLong
  deriving stock (Show)

instance Exception ComputedTooLong where
  toException = asyncExceptionToException
  fromException = asyncExceptionFromException

oneLine :: String -> Property
oneLine why =
  counterexample (show why) $
    conjoin
      [ counterexample "the refusal is empty" (not (null why)),
        counterexample "the refusal is more than a line" (length (lines (visibleLine why)) == 1),
        counterexample "the refusal is too long" (length (visibleLine why) <= 2200),
        withoutInternals why
      ]

withoutInternals :: String -> Property
withoutInternals said =
  conjoin
    [counterexample ("it says " ++ show word) False | word <- internals, word `isInfixOf` said]

-- | Words that GHC, its runtime system and the libraries used here say of their own failures, and
-- that mean nothing to a user.
internals :: [String]
internals =
  [ "openBinaryFile",
    "openFile:",
    "withBinaryFile",
    "withFile",
    "hClose",
    "hGetBuf",
    "hPutBuf",
    "hGetContents",
    "commitBuffer",
    "invalid byte sequence",
    "user error",
    "CallStack",
    "Prelude.",
    "fromJust",
    "Non-exhaustive",
    "Irrefutable",
    "no parse",
    "arithmetic overflow",
    "arithmetic underflow",
    "divide by zero",
    "stack overflow",
    "Heap exhausted",
    "heap overflow",
    "maximum heap size",
    "-rtsopts",
    "<<loop>>",
    "thread blocked",
    "bad argument",
    "index out of bounds",
    "index too large",
    "PersistMarshalError",
    "SqliteException",
    "Failed to parse Haskell type",
    "persistent",
    "keyOrFail",
    "Error in $",
    "parsing Natural",
    "parsing Double",
    "parse error",
    "encountered Object",
    "encountered Array",
    "encountered String",
    "expected Array",
    "but encountered",
    "endOfInput",
    "attoparsec",
    "not enough input",
    "Failed reading",
    "conversion error",
    "expected Double",
    "cannot unpack",
    "Cannot decode",
    "inconsistent dimensions",
    "Data.Text",
    "Data.Vector",
    "Data.Map",
    "Data.Aeson",
    "./Data/",
    "ExitFailure",
    "this should not have happened"
  ]

-- | The number of inputs in this many thousandths of all hostile inputs.
shareOf :: Int -> Int
shareOf thousandths = max 1 (byEffort 10000 100000 * thousandths `div` 1000)
