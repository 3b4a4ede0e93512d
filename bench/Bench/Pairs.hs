{-# LANGUAGE OverloadedStrings #-}

-- | Programs that measure on request, asked alternately, so that other load affects both alike.
module Bench.Pairs
  ( -- * Programs that measure
    Participant,
    startOurs,
    startPeer,
    ask,
    stop,

    -- * Answers
    Answer (..),

    -- * Statistics
    Spread (..),
    spread,
  )
where

import Bench.Targets (Peer (..))
import Control.Monad (void)
import Data.Aeson (FromJSON (..), eitherDecodeStrict', withObject, (.:))
import qualified Data.ByteString.Char8 as Bytes
import Data.List (sort)
import Data.Maybe (fromMaybe)
import System.Environment (getExecutablePath)
import System.FilePath ((</>))
import System.IO
import System.Process
import System.Timeout (timeout)

-- | An answer: one line of JSON, as every participant prints it.
data Answer = Answer
  { answerValue :: Double,
    answerUnit :: String,
    answerCheck :: String,
    -- | MiB
    answerPeak :: Double
  }
  deriving stock (Eq, Show)

instance FromJSON Answer where
  parseJSON =
    withObject "measurement" $ \o ->
      Answer <$> o .: "value" <*> o .: "unit" <*> o .: "check" <*> o .: "peak_mib"

-- | A running program: its process, the handle to it, and the handle from it.
data Participant = Participant ProcessHandle Handle Handle

-- | Starts this library's measurement with the given name in its own process, with these options
-- for the run-time system.
startOurs :: [String] -> String -> IO Participant
startOurs runTime name = do
  self <- getExecutablePath
  start self (["--measure", name, "+RTS"] ++ runTime ++ ["-RTS"])

-- | Starts a peer from the folder that @bench/peers/setup.sh@ made.
startPeer :: FilePath -> Peer -> IO Participant
startPeer folder peer = case peer of
  Script _ file arguments ->
    start (folder </> "bin" </> "python") (("bench/peers" </> file) : arguments)
  Program _ file arguments -> start (folder </> "bin" </> file) arguments

start :: FilePath -> [String] -> IO Participant
start file arguments = do
  (toIt, fromIt, process) <- piped
  pure (Participant process toIt fromIt)
  where
    piped = do
      created <- createProcess (proc file arguments) {std_in = CreatePipe, std_out = CreatePipe}
      case created of
        (Just i, Just o, _, p) -> hSetBuffering i LineBuffering >> pure (i, o, p)
        _ -> ioError (userError ("no pipes to " ++ file))

-- | Asks for one measurement within the given number of seconds; 'Left' with the problem.
ask :: Int -> Participant -> IO (Either String Answer)
ask patience (Participant _ toIt fromIt) = do
  hPutStrLn toIt "measure"
  fromMaybe (Left ("no answer within " ++ show patience ++ " s"))
    <$> timeout (patience * 1000000) answered
  where
    answered = do
      ended <- hIsEOF fromIt
      if ended
        then pure (Left "it ended without an answer")
        else eitherDecodeStrict' <$> Bytes.hGetLine fromIt

-- | Terminates a program, even while it measures, and waits for it.
stop :: Participant -> IO ()
stop (Participant process toIt fromIt) = do
  hClose toIt
  hClose fromIt
  terminateProcess process
  void (waitForProcess process)

-- | The least, the median and the greatest of some values.
data Spread = Spread
  { least :: Double,
    median :: Double,
    greatest :: Double
  }
  deriving stock (Eq, Show)

-- | The spread of values; 'Nothing' for an empty list. The median of an even number is the mean of
-- the two in the middle.
spread :: [Double] -> Maybe Spread
spread values = case sort values of
  [] -> Nothing
  sorted@(smallest : _) ->
    let size = length sorted
        middle = take (2 - size `mod` 2) (drop ((size - 1) `div` 2) sorted)
     in Just (Spread smallest (sum middle / fromIntegral (length middle)) (maximum sorted))
