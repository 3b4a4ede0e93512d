-- | An orderly end after a signal: started work is undone first, then the signal takes its effect.
module Interrupt
  ( endingInOrder,
    endings,
    ignoring,
  )
where

import Control.Concurrent (myThreadId)
import Control.Concurrent.MVar
import Control.Exception
import Control.Monad (forM_, void, when)
import System.Posix.Signals

-- | A signal that ends the program.
newtype Told = Told Signal
  deriving stock (Show)

instance Exception Told where
  toException = asyncExceptionToException
  fromException = asyncExceptionFromException

-- | The signals that tell a program to end.
endings :: [Signal]
endings = [sigINT, sigTERM, sigHUP]

-- | Ignore these from now on.
ignoring :: [Signal] -> IO ()
ignoring signals = forM_ signals $ \signal -> installHandler signal Ignore Nothing

-- | An action that SIGINT, SIGTERM and SIGHUP end as an exception does, but those of them that are
-- ignored do not. A pipe that nobody reads is an error of writing to it while the action lasts, not
-- the program's end.
endingInOrder :: IO a -> IO a
endingInOrder action = do
  thread <- myThreadId
  let heeding signal = do
        heeded <- newEmptyMVar
        let told = readMVar heeded >>= \so -> when so (throwTo thread (Told signal))
        before <- installHandler signal (CatchOnce told) Nothing
        -- Only now it is known whether it was ignored; one that came meanwhile waits to be told.
        let ignored = isIgnore before
        when ignored (void (installHandler signal Ignore Nothing))
        (signal, before) <$ putMVar heeded (not ignored)
      deaf = (,) sigPIPE <$> installHandler sigPIPE (Catch (pure ())) Nothing
      restored = mapM_ (\(signal, handler) -> installHandler signal handler Nothing)
  bracket (sequence (deaf : map heeding endings)) restored (const action)
    `catch` \(Told signal) -> do
      _ <- installHandler signal Default Nothing
      raiseSignal signal
      throwIO (Told signal)
  where
    isIgnore handler = case handler of
      Ignore -> True
      _ -> False
