-- | Another process and the three pipes to it. Whatever it does, nothing here waits for it without
-- a limit: what it is sent is written by a thread of its own, its standard error is read by another
-- one, and it ends, with all of its process group, when 'withChild' does.
module PraTactile.Conformance.Process.Child
  ( -- * Processes
    Child,
    Command (..),
    begin,
    end,

    -- * Talking to it
    send,
    closeInput,
    unread,
    receive,
    Received (..),

    -- * How it fares
    inputLost,
    exitCode,
    waitExit,
    errorsTail,
  )
where

import Control.Concurrent
import Control.Exception
import Control.Monad (unless, void, when)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Internal (createAndTrim)
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef
import Data.Maybe (isNothing)
import GHC.Clock (getMonotonicTime)
import System.Directory (doesPathExist, findExecutable)
import System.Exit (ExitCode)
import System.IO
import System.IO.Error (ioeGetErrorString)
import System.Posix.IO (FdOption (..), closeFd, fdReadBuf, handleToFd, setFdOption)
import System.Posix.Signals (sigKILL, signalProcess, signalProcessGroup)
import System.Posix.Types (CPid, Fd)
import System.Process
import System.Timeout (timeout)

-- | A program and its arguments.
data Command = Command
  { commandProgram :: FilePath,
    commandArguments :: [String]
  }
  deriving stock (Eq, Show)

-- | A process that was started and not yet ended.
data Child = Child
  { childProcess :: ProcessHandle,
    -- | Its process group, of which it is the first.
    childGroup :: CPid,
    childOutput :: Fd,
    childHandles :: [Handle],
    -- | What the writer is to write; 'Nothing' to close.
    childQueue :: Chan (Maybe Lazy.ByteString),
    childInputLost :: IORef Bool,
    -- | What was received and not yet used.
    childUnread :: IORef ByteString,
    childErrors :: IORef ByteString,
    -- | Full once there will be no more of that.
    childErrorsEnd :: MVar (),
    childThreads :: [ThreadId]
  }

-- | Start a process, in a process group of its own; 'Left' with the reason where it cannot be
-- started. To be called with asynchronous exceptions masked, and followed by 'end'.
begin :: Command -> IO (Either String Child)
begin command = try (begun command) >>= either (fmap Left . reason) (pure . Right)
  where
    reason :: IOException -> IO String
    reason problem = do
      found <- findExecutable (commandProgram command)
      there <- doesPathExist (commandProgram command)
      pure $ case found of
        Nothing
          | '/' `notElem` commandProgram command || not there -> "there is no such program"
          | otherwise -> "it is no program that may be run"
        Just _ -> ioeGetErrorString problem

begun :: Command -> IO Child
begun (Command program arguments) = do
  (handles, process) <- started
  broken <- newIORef False
  errors <- newIORef Bytes.empty
  errorsEnd <- newEmptyMVar
  rest <- newIORef Bytes.empty
  queue <- newChan
  case handles of
    (Just input, Just output, Just complaints) -> do
      mapM_ (`hSetBinaryMode` True) [input, complaints]
      hSetBuffering input NoBuffering
      out <- handleToFd output
      setFdOption out NonBlockingRead True
      group <- maybe (throwIO (userError "it ended at once")) pure =<< getPid process
      writer <- forkIOWithUnmask (\unmasked -> unmasked (write queue broken input))
      reader <- forkIOWithUnmask $ \unmasked ->
        unmasked (keepTail complaints errors) `finally` putMVar errorsEnd ()
      pure
        Child
          { childProcess = process,
            childGroup = group,
            childOutput = out,
            childHandles = [input, complaints],
            childQueue = queue,
            childInputLost = broken,
            childUnread = rest,
            childErrors = errors,
            childErrorsEnd = errorsEnd,
            childThreads = [writer, reader]
          }
    _ -> throwIO (userError "it has no pipes")
  where
    started = do
      (input, output, complaints, process) <-
        createProcess
          (proc program arguments)
            { std_in = CreatePipe,
              std_out = CreatePipe,
              std_err = CreatePipe,
              create_group = True,
              close_fds = False
            }
      pure ((input, output, complaints), process)

-- | End a process and all of its group, and forget it: no zombie stays.
end :: Child -> IO ()
end child = uninterruptibleMask_ $ do
  -- A process may have left its group; where it has ended, its number may be another one's.
  ended <- exitCode child
  when (isNothing ended) (whatever (signalProcess sigKILL (childGroup child)))
  whatever (signalProcessGroup sigKILL (childGroup child))
  mapM_ killThread (childThreads child)
  whatever (closeFd (childOutput child))
  mapM_ (whatever . hClose) (childHandles child)
  whatever (waitForProcess (childProcess child))

whatever :: IO a -> IO ()
whatever action = void (try (void action) :: IO (Either IOException ()))

-- | Write what comes, until that is the end of it or cannot be written.
write :: Chan (Maybe Lazy.ByteString) -> IORef Bool -> Handle -> IO ()
write queue broken input = go `catch` lost
  where
    go = readChan queue >>= maybe (hClose input) (\bytes -> Lazy.hPut input bytes >> go)
    lost :: IOException -> IO ()
    lost _ = writeIORef broken True

-- | Read to the end and keep the last 4 KiB.
keepTail :: Handle -> IORef ByteString -> IO ()
keepTail complaints errors = go `catch` ended
  where
    go = do
      more <- Bytes.hGetSome complaints 65536
      unless (Bytes.null more) $ do
        modifyIORef' errors (\before -> lastOf (before <> lastOf more))
        go
    lastOf bytes = Bytes.copy (Bytes.drop (Bytes.length bytes - 4096) bytes)
    ended :: IOException -> IO ()
    ended _ = pure ()

-- | Have bytes written to the standard input, without waiting for that.
send :: Child -> Lazy.ByteString -> IO ()
send child = writeChan (childQueue child) . Just

-- | Close the standard input after all that was sent.
closeInput :: Child -> IO ()
closeInput child = writeChan (childQueue child) Nothing

-- | Whether the standard input cannot be written to. What was sent last may have been taken by the
-- system before it was closed, so a line end more is sent: to be asked of a process that is given
-- up.
inputLost :: Child -> IO Bool
inputLost child = do
  send child (Lazy.pack [10])
  threadDelay 20000
  readIORef (childInputLost child)

-- | The end of what it wrote to its standard error, at most 4 KiB. Of a process that has ended all
-- is awaited, because what it said last may arrive after its end; but no longer than half a second,
-- for a child of its own may hold the pipe.
errorsTail :: Child -> IO ByteString
errorsTail child = do
  ended <- exitCode child
  _ <- timeout (if isNothing ended then 2000 else 500000) (readMVar (childErrorsEnd child))
  readIORef (childErrors child)

-- | What was received and is to be used first by whoever reads on.
unread :: Child -> IORef ByteString
unread = childUnread

-- | Some more of the standard output.
data Received
  = Received ByteString
  | -- | There will be no more.
    OutputEnds
  | -- | There is none until this time.
    Late

-- | Wait for more of the standard output, until a time on the monotonic clock, seconds. Where the
-- process has ended, what it left in the pipe is all, even if a child of its own holds the pipe;
-- and that is there, however long a busy machine takes to say so.
receive :: Child -> Double -> IO Received
receive child deadline = do
  now <- getMonotonicTime
  let slice = min 0.05 (deadline - now)
  if slice <= 0
    then maybe Late got <$> readNow
    else do
      -- Only the waiting is given up, never a read that has begun: nothing that came is lost.
      _ <- timeout (max 1 (ceiling (slice * 1e6))) (threadWaitRead (childOutput child))
      more <- readNow
      case more of
        Just bytes -> pure (got bytes)
        Nothing -> do
          ended <- exitCode child
          maybe (receive child deadline) (const (maybe OutputEnds got <$> readNow)) ended
  where
    readNow = readSome (childOutput child)
    got bytes = if Bytes.null bytes then OutputEnds else Received bytes

-- | What is there to be read of a pipe that is not waited for, if anything is; empty at its end.
readSome :: Fd -> IO (Maybe ByteString)
readSome fd = either nothing Just <$> try bytes
  where
    bytes = createAndTrim size (\buffer -> fromIntegral <$> fdReadBuf fd buffer (fromIntegral size))
    size = 32768
    nothing :: IOException -> Maybe ByteString
    nothing _ = Nothing

-- | How it ended, if it has.
exitCode :: Child -> IO (Maybe ExitCode)
exitCode = getProcessExitCode . childProcess

-- | Wait for its end until a time on the monotonic clock.
waitExit :: Child -> Double -> IO (Maybe ExitCode)
waitExit child deadline = go 0.0002
  where
    go pause = do
      code <- exitCode child
      now <- getMonotonicTime
      case code of
        Nothing | now < deadline -> do
          threadDelay (ceiling (min pause (deadline - now) * 1e6 :: Double))
          go (min 0.02 (2 * pause))
        _ -> pure code
