{-# LANGUAGE OverloadedStrings #-}

-- | The benchmarks. @bench [NAME...] [--peers FOLDER]@ checks the targets, each with its peer;
-- @bench ladder@ runs series of growing sizes with criterion.
module Main (main) where

import Bench.Clock
import Bench.Compare
import Bench.Ladder (ladder)
import Bench.Machine
import Bench.Ours
import Bench.Report
import Bench.Targets
import Control.Monad (forM_, unless)
import Data.Aeson (object, (.=))
import qualified Data.Aeson as Aeson
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Options.Applicative
import System.Environment (getArgs, withArgs)
import System.Exit (exitFailure)
import System.IO

main :: IO ()
main = do
  hSetEncoding stdout utf8
  hSetBuffering stdout LineBuffering
  arguments <- getArgs
  case arguments of
    "ladder" : rest -> withArgs rest ladder
    ["--measure", name] -> measure name
    _ -> do
      options <- execParser commandLine
      hold options

-- | The command line's options.
data Options = Options
  { peers :: Maybe FilePath,
    rounds :: Int,
    patience :: Int,
    names :: [String]
  }

commandLine :: ParserInfo Options
commandLine =
  info
    (options <**> helper)
    ( fullDesc
        <> header
          "Targets held beside their peers; 'ladder' as the first word runs the ladders of sizes \
          \instead."
    )
  where
    options =
      Options
        <$> optional
          ( strOption
              ( long "peers"
                  <> metavar "FOLDER"
                  <> help
                    "The folder that bench/peers/setup.sh made (default: the peers do not run)"
              )
          )
        <*> option
          auto
          ( long "rounds"
              <> metavar "N"
              <> value 7
              <> showDefault
              <> help "How many pairs of measurements count, after one that does not"
          )
        <*> option
          auto
          ( long "patience"
              <> metavar "SECONDS"
              <> value 120
              <> showDefault
              <> help "How long an answer is waited for"
          )
        <*> many
          ( strArgument
              ( metavar "NAME..."
                  <> help ("Of: " ++ unwords (map targetName targets) ++ " (default: all)")
              )
          )

-- | Checks the chosen targets and prints the table row by row.
hold :: Options -> IO ()
hold options = do
  let unknown = filter (`notElem` map targetName targets) (names options)
  unless
    (null unknown)
    ( refuse
        ( "there is no target "
            ++ unwords unknown
            ++ "; there are "
            ++ unwords (map targetName targets)
        )
    )
  unless (rounds options >= 1) (refuse "--rounds is a number from 1 up")
  before <- load
  machine
    >>= putStrLn
      . (++ "; load " ++ before ++ " at the beginning; " ++ show (rounds options) ++ " rounds\n")
  mapM_ putStrLn heading
  forM_ [t | t <- targets, null (names options) || targetName t `elem` names options] $ \target ->
    compareWith (peers options) (patience options) (rounds options) target
      >>= mapM_ (putStrLn . rowText)
  after <- load
  putStrLn ("\nload " ++ after ++ " at the end")

-- | Measures once for each line on standard input.
measure :: String -> IO ()
measure name = case lookup name ours of
  Nothing -> refuse ("there is no measurement " ++ name ++ "; there are " ++ unwords (map fst ours))
  Just prepare -> prepare >>= loop
  where
    loop once = do
      ended <- isEOF
      unless ended $ do
        _ <- getLine
        m <- once
        peak <- peakMebibytes
        Lazy.putStrLn
          ( Aeson.encode
              ( object
                  [ "what" .= name,
                    "value" .= measured m,
                    "unit" .= unitName (measuredIn m),
                    "check" .= check m,
                    "peak_mib" .= peak
                  ]
              )
          )
        hFlush stdout
        loop once

refuse :: String -> IO a
refuse message = hPutStrLn stderr ("bench: " ++ message) >> exitFailure
