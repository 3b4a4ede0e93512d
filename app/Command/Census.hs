{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile census@: every array of a size, as a CSV file that can be continued and made in
-- shards.
module Command.Census
  ( command,
  )
where

import CensusChoice
import Control.Monad (foldM, when)
import Control.Parallel.Strategies (parBuffer, rdeepseq, withStrategy)
import Data.Bifunctor (first)
import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Either (rights)
import Data.Maybe (fromMaybe)
import ExitStatus
import Files (alreadyIn)
import Message (censusMessage, proofMessage)
import Message.Census
import Numeric.Natural (Natural)
import Options
import Output
import PraTactile.Array (Folding, Shape)
import PraTactile.Census
import PraTactile.Format.Census
import PraTactile.Format.Census.Continue
import PraTactile.Format.Census.Contradiction (foundProved)
import PraTactile.Format.Census.Row
import PraTactile.Window.Proof (WindowVerdict (..))
import Progress
import System.IO

-- | The options.
data Asked = Asked
  { askedOrder :: Natural,
    askedModulus :: Maybe [Natural],
    askedDegree :: Natural,
    askedFolding :: Maybe Folding,
    askedWindows :: [Shape],
    askedShard :: (Natural, Natural),
    askedDamage :: Damage,
    askedOutput :: FilePath,
    askedForm :: AnswerForm
  }

command :: Subcommand
command =
  subcommand
    "census"
    "Tabulate every array of a size, as CSV"
    "Write a CSV file of every primitive polynomial of a degree, every shape that its sequence \
    \fills, and every window. A row says whether the windows are distinct, by two methods, and has \
    \their minimum distance. Running the command again continues an unfinished file. Each row ends \
    \with a check, the first digits of the SHA-256 of the rest of the row; a damaged file is \
    \refused."
    []
    [ "pra-tactile census --q 4 --degree 4 --output census.csv",
      "pra-tactile census --q 4 --degree 6 --shard 1/8 --output part1.csv"
    ]
    (run <$> asked)

asked :: Parser Asked
asked =
  Asked
    <$> orderOption
    <*> modulusOption
    <*> valued naturalReader "degree" "N" "Degree n of the polynomials; arrays have q^n - 1 cells"
    <*> foldingOption "How sequences fill the array: diagonal or row-major (default: both)"
    <*> many
      ( valued
          shapeReader
          "window"
          "ROWSxCOLUMNS"
          "A window; may be repeated (default: all rectangles of n cells, and those with one row \
          \or column more)"
      )
    <*> (fromMaybe (1, 1) <$> shardOption)
    <*> keepWholeSwitch
      "Continue a damaged file: keep its whole rows, and make the others again"
    <*> fileOption "output" "FILE" "The file that is written or continued"
    <*> jsonSwitch "Report as JSON what was written"

run :: Asked -> IO ExitStatus
run given = do
  standard <- orUnusable censusMessage (standardScope (askedOrder given) (askedDegree given))
  let scope =
        standard
          { scopeModulus = fromMaybe (scopeModulus standard) (askedModulus given),
            scopeFoldings = maybe (scopeFoldings standard) pure (askedFolding given),
            scopeWindows = askedWindows given
          }
      (i, k) = askedShard given
  entries <- orUnusable censusMessage (censusSize scope)
  found <- orUnusable censusMessage (census (\number -> number `mod` k == i - 1) scope)
  let shardSize = if entries < i then 0 else (entries - i) `div` k + 1
      wanted = Wanted scope entries [(entry, rowBody scope entries entry) | entry <- found]
  (size, kept) <- continued (askedDamage given) (askedOutput given) wanted
  provedOnes <-
    writtenAfter (askedOutput given) (size, keptBytes kept) $
      rowsAfter (toInteger shardSize) kept (rowsToMake wanted kept)
  Answered <$ sayCensus (askedForm given) (askedOutput given) shardSize provedOnes

-- | The rows after the kept ones, made on all cores, each with whether its windows are distinct.
rowsToMake :: Wanted -> Kept -> [Either String (Bool, ByteString)]
rowsToMake wanted kept =
  withStrategy
    (parBuffer 64 rdeepseq)
    [ (\row -> (isProved entry, checked row)) <$> first proofMessage body
      | (entry, body) <- drop (keptCount kept) (wantedInOrder wanted)
    ]

-- | The file's length and its rows so far, which must be the first of the wanted rows. Any other
-- file is left alone, with status 2. With 'Repaired', the damaged rows of a file are made again
-- first.
continued :: Damage -> FilePath -> Wanted -> IO (Int, Kept)
continued damage file wanted = do
  bytes <- alreadyIn file
  let sized kept = pure (Bytes.length bytes, kept)
  if beginsHeader bytes
    then sized (Kept 0 0 0)
    else do
      contents <- orUnusable (censusFileMessage file) (contentsOf bytes)
      case keptInOrder wanted bytes contents of
        Right kept -> sized kept
        Left _ | damage == Repaired -> do
          kept <- repaired file wanted contents
          pure (keptBytes kept, kept)
        Left fault -> unusable (censusFileMessage file fault)

-- | Make the damaged rows of a file again, up to the last whole one. The file is replaced whole, so
-- that an interruption loses no kept row.
repaired :: FilePath -> Wanted -> Contents -> IO Kept
repaired file wanted contents = do
  (parts, left) <- orUnusable (censusFileMessage file) (keptOfDamaged wanted contents)
  rows <- traverse (either (orUnusable proofMessage) (pure . rowText) . snd) parts
  let text = encodeCensus rows
      isProvedBy entry = either (const (isProved entry)) (foundProved . rowFindings)
      provedOnes = length (filter (uncurry isProvedBy) parts)
  warn (keptMessage file (length (rights (map snd parts))) left)
  writeWhole file text
  pure (Kept (length rows) provedOnes (fromIntegral (Lazy8.length text)))

isProved :: Entry -> Bool
isProved = either (const False) proved . entryVerdict

-- | Write the rows after the kept ones, each at once and whole, given the number of all rows.
-- Returns the number of rows with distinct windows.
rowsAfter :: Integer -> Kept -> [Either String (Bool, ByteString)] -> Handle -> IO Int
rowsAfter total kept made handle = do
  when (keptBytes kept == 0) (Bytes.hPutStr handle (headerLine <> "\n"))
  withProgress (doneBefore (toInteger (keptCount kept)) (evenly total "polynomials")) $ \bar -> do
    let put (done, provedOnes) row = do
          (yes, text) <- orUnusable id row
          Bytes.hPutStr handle (text <> "\n")
          hFlush handle
          tell bar (done + 1)
          pure $! ((,) $! done + 1) $! if yes then provedOnes + 1 else provedOnes
    snd <$> foldM put (toInteger (keptCount kept), keptProved kept) made
