-- | A process with three pipes. Nothing here waits for it without a limit: one thread writes its
-- input, another reads its standard error, and 'end' kills it with its whole process group.
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

    -- * Its state
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
    -- | Its process group, which has its number.
    childGroup :: CPid,
    childOutput :: Fd,
    childHandles :: [Handle],
    -- | The bytes to be written; 'Nothing' closes the input.
    childQueue :: Chan (Maybe Lazy.ByteString),
    childInputLost :: IORef Bool,
    -- | Bytes that were received and not yet used.
    childUnread :: IORef ByteString,
    childErrors :: IORef ByteString,
    -- | Filled when standard error has ended.
    childErrorsEnd :: MVar (),
    childThreads :: [ThreadId]
  }

-- | Starts a process in its own process group; 'Left' with the reason if that fails. Call it with
-- asynchronous exceptions masked, followed by 'end'.
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

-- | Kills a process and its group, and reaps it, so that no zombie remains.
end :: Child -> IO ()
end child = uninterruptibleMask_ $ do
  -- A process may have left its group. After it has ended, its number may belong to another
  -- process.
  ended <- exitCode child
  when (isNothing ended) (whatever (signalProcess sigKILL (childGroup child)))
  whatever (signalProcessGroup sigKILL (childGroup child))
  mapM_ killThread (childThreads child)
  whatever (closeFd (childOutput child))
  mapM_ (whatever . hClose) (childHandles child)
  whatever (waitForProcess (childProcess child))

whatever :: IO a -> IO ()
whatever action = void (try (void action) :: IO (Either IOException ()))

-- | Writes bytes until the end of input or an error.
write :: Chan (Maybe Lazy.ByteString) -> IORef Bool -> Handle -> IO ()
write queue broken input = go `catch` lost
  where
    go = readChan queue >>= maybe (hClose input) (\bytes -> Lazy.hPut input bytes >> go)
    lost :: IOException -> IO ()
    lost _ = writeIORef broken True

-- | Reads to the end and keeps the last 4 KiB.
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

-- | Queues bytes for standard input without waiting.
send :: Child -> Lazy.ByteString -> IO ()
send child = writeChan (childQueue child) . Just

-- | Closes standard input after everything queued.
closeInput :: Child -> IO ()
closeInput child = writeChan (childQueue child) Nothing

-- | Whether standard input is broken. Use it only for a process that is given up: it sends one
-- more line end, because the system may have accepted the last bytes before the pipe closed.
inputLost :: Child -> IO Bool
inputLost child = do
  send child (Lazy.pack [10])
  threadDelay 20000
  readIORef (childInputLost child)

-- | The last 4 KiB of standard error. For a process that has ended it waits for the rest, at most
-- half a second, because a child of the process may hold the pipe.
errorsTail :: Child -> IO ByteString
errorsTail child = do
  ended <- exitCode child
  _ <- timeout (if isNothing ended then 2000 else 500000) (readMVar (childErrorsEnd child))
  readIORef (childErrors child)

-- | The bytes that were received and must be used first by the next reader.
unread :: Child -> IORef ByteString
unread = childUnread

-- | The result of waiting for standard output.
data Received
  = Received ByteString
  | -- | The output has ended.
    OutputEnds
  | -- | Nothing came before the deadline.
    Late

-- | Waits for more standard output until a deadline on the monotonic clock (seconds). After the
-- process has ended, its output ends with what is in the pipe, even if a child holds the pipe. A
-- busy machine may take long to report that, so the pipe is read first.
receive :: Child -> Double -> IO Received
receive child deadline = do
  now <- getMonotonicTime
  let slice = min 0.05 (deadline - now)
  if slice <= 0
    then maybe Late got <$> readNow
    else do
      -- Only the waiting is interrupted, never a read, so no bytes are lost.
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

-- | Reads what is in a non-blocking pipe, if anything is; empty at its end.
readSome :: Fd -> IO (Maybe ByteString)
readSome fd = either nothing Just <$> try bytes
  where
    bytes = createAndTrim size (\buffer -> fromIntegral <$> fdReadBuf fd buffer (fromIntegral size))
    size = 32768
    nothing :: IOException -> Maybe ByteString
    nothing _ = Nothing

-- | The exit code, if the process has ended.
exitCode :: Child -> IO (Maybe ExitCode)
exitCode = getProcessExitCode . childProcess

-- | Waits for the exit code until a deadline on the monotonic clock.
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
