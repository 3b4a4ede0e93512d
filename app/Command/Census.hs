{-# LANGUAGE OverloadedStrings #-}
-- | @pra-tactile census@: every array of a size, as a CSV file that can be continued and made in shards.
module Command.Census
  ( command
  ) where

import Control.Exception (IOException, try)
import Control.Monad (foldM_, when)
import Control.Parallel.Strategies (parBuffer, rdeepseq, withStrategy)
import Data.Aeson ((.=))
import qualified Data.ByteString.Char8 as Bytes
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import Options.Applicative hiding (command)
import System.Directory (doesPathExist)
import System.IO

import ArrayChoice
import CensusFile
import Described
import Ending
import Files (readBytes)
import Json
import Message (censusMessage, proofMessage)
import PraTactile.Array (Folding, Shape)
import PraTactile.Census
import Progress

-- | What the command line says.
data Asked = Asked
  { askedOrder :: Natural
  , askedModulus :: Maybe [Natural]
  , askedDegree :: Natural
  , askedFolding :: Maybe Folding
  , askedWindows :: [Shape]
  , askedShard :: (Natural, Natural)
  , askedOutput :: FilePath
  , askedJson :: Bool
  }

command :: Mod CommandFields (IO Ending)
command = described "census" "Every primitive polynomial of a degree, every shape that its sequence fills, and every window: whether the windows are distinct, by both roads, and their minimum distance, as a CSV file. Running it again continues an unfinished file."
  [ "pra-tactile census --q 4 --degree 4 --output census.csv"
  , "pra-tactile census --q 4 --degree 6 --shard 1/8 --output part1.csv" ]
  (run <$> asked)
  where
    asked = Asked
      <$> orderOption
      <*> optional modulusOption
      <*> option naturalReader (long "degree" <> metavar "N" <> help "Degree n of the polynomials: arrays of q^n - 1 cells")
      <*> optional (option foldingReader (long "folding" <> metavar "FOLDING" <> completeWith (map foldingName [minBound ..]) <> help "diagonal or row-major (default: both)"))
      <*> many (option shapeReader (long "window" <> metavar "ROWSxCOLUMNS" <> help "A window, instead of all rectangles of n cells and those with one row or column more; may be repeated"))
      <*> option shardReader (long "shard" <> metavar "I/K" <> value (1, 1) <> help "Only the I-th of K parts, which 'merge' puts together")
      <*> strOption (long "output" <> metavar "FILE" <> action "file" <> help "The file to write or to continue")
      <*> switch (long "json" <> help "Tell as JSON what was written")

shardReader :: ReadM (Natural, Natural)
shardReader = pairReader '/' "--shard 1/8" >>= \(i, k) ->
  if 1 <= i && i <= (k :: Integer) then pure (fromInteger i, fromInteger k) else readerError "a shard is I/K with I from 1 to K, as in --shard 1/8"

run :: Asked -> IO Ending
run asked = do
  standard <- orUnusable censusMessage (standardScope (askedOrder asked) (askedDegree asked))
  let scope = standard
        { scopeModulus = fromMaybe (scopeModulus standard) (askedModulus asked)
        , scopeFoldings = maybe (scopeFoldings standard) pure (askedFolding asked)
        , scopeWindows = askedWindows asked }
      (i, k) = askedShard asked
      inShard number = number `mod` k == i - 1
      numbers entries = takeWhile (< entries) [i - 1, i - 1 + k ..]
  entries <- orUnusable censusMessage (censusSize scope)
  Kept kept bytes <- continued (askedOutput asked) (\line -> Bytes.unpack (lineCensus line) == censusName scope && lineEntries line == entries) (numbers entries)
  let start = fromIntegral (length kept) :: Natural
  found <- orUnusable censusMessage (census (\number -> inShard number && number >= i - 1 + k * start) scope)
  let shardSize = if entries < i then 0 else (entries - i) `div` k + 1
      rendered = withStrategy (parBuffer 64 rdeepseq) (map (either (Left . proofMessage) Right . entryLine scope entries) found)
  append (askedOutput asked) bytes (toInteger shardSize) (toInteger start) rendered
  written <- Bytes.lines <$> readBytes (askedOutput asked)
  report asked shardSize (provedLines (drop 1 written))
  pure Answered

-- | What is in the file already: nothing, or the first of the lines that it is to have. Leaves with status 2 if it is
-- anything else, and does not touch it.
continued :: FilePath -> (Line -> Bool) -> [Natural] -> IO Kept
continued file ofThis numbers = do
  there <- doesPathExist file
  if not there then pure (Kept [] 0) else do
    Kept kept bytes <- readBytes file >>= orUnusable ((file ++ ": ") ++) . wholeLines
    when (not (all ofThis kept) || not (and (zipWith (==) (map lineEntry kept) numbers)) || length kept > length (zip kept numbers))
      (unusable (file ++ " is not an unfinished file of this census or shard; give another --output"))
    pure (Kept kept bytes)

-- | Cut the file to so many bytes and write the lines after them, each at once and whole.
append :: FilePath -> Int -> Integer -> Integer -> [Either String String] -> IO ()
append file bytes total start rendered = do
  outcome <- try $ withBinaryFile file ReadWriteMode $ \handle -> do
    hSetFileSize handle (fromIntegral bytes)
    hSeek handle SeekFromEnd 0
    when (bytes == 0) (Bytes.hPutStr handle (censusHeader <> "\n"))
    withProgress total start $ \tell -> do
      let put done line = do
            text <- orUnusable id line
            Bytes.hPutStr handle (Bytes.pack (text ++ "\n"))
            hFlush handle
            done + 1 <$ tell (done + 1)
      foldM_ put start rendered
  either (\problem -> unusable ("cannot write " ++ file ++ ": " ++ show (problem :: IOException))) pure outcome

report :: Asked -> Natural -> Int -> IO ()
report asked entries provedOnes
  | askedJson asked = printJson ("schema" .= ("pra-tactile/census/1" :: String) <> "file" .= askedOutput asked
      <> "entries" .= naturalValue entries <> "proved" .= provedOnes)
  | otherwise = putStrLn ("wrote " ++ askedOutput asked ++ ": " ++ show entries ++ " entries, " ++ show provedOnes ++ " of them proved")
