-- | Ending in order when the program is told to end: what was begun is undone first, then the
-- signal takes its effect.
module Interrupt
  ( endingInOrder,
  )
where

import Control.Concurrent (myThreadId)
import Control.Exception
import Control.Monad (forM, forM_)
import System.Posix.Signals

-- | A signal that ends the program.
newtype Told = Told Signal
  deriving stock (Show)

instance Exception Told where
  toException = asyncExceptionToException
  fromException = asyncExceptionFromException

-- | An action that SIGINT, SIGTERM and SIGHUP end as an exception does. A pipe that nobody reads is
-- an error of writing to it while the action lasts, not the program's end.
endingInOrder :: IO a -> IO a
endingInOrder action = do
  thread <- myThreadId
  before <- forM [sigINT, sigTERM, sigHUP] $ \signal ->
    (,) signal <$> installHandler signal (CatchOnce (throwTo thread (Told signal))) Nothing
  pipe <- installHandler sigPIPE (Catch (pure ())) Nothing
  let restored = do
        forM_ before $ \(signal, handler) -> installHandler signal handler Nothing
        installHandler sigPIPE pipe Nothing
  (action <* restored) `catch` \(Told signal) -> do
    _ <- installHandler signal Default Nothing
    raiseSignal signal
    throwIO (Told signal)
