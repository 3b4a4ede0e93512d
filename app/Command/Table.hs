-- | @pra-tactile table@: the memory table from packed window to position, for a program or a ROM.
module Command.Table
  ( command,
  )
where

import ArrayChoice
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.List (intercalate)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Vector
import ExitStatus
import Message
import Numeric (showHex)
import Numeric.Natural (Natural)
import Options
import Output (writeWhole)
import PraTactile.Array (ArrayOn (..), Position (..), Shape (..), Surface, area)
import PraTactile.Format.Name (surfaceName)
import PraTactile.Format.Profile (profileText)
import PraTactile.Locate
import PraTactile.Profile
import Progress
import System.IO (stdout)

-- | The output formats.
data Format = Csv | C | Mem
  deriving stock (Eq, Show)

command :: Subcommand
command =
  subcommand
    "table"
    "Print the memory table from windows to positions"
    "Print the memory table, which has the position of each packed window: as CSV, as a C array, \
    \or as a memory image for $readmemh."
    [arrayGroup]
    [ "pra-tactile table --format csv",
      "pra-tactile table --format c > table.h"
    ]
    (run <$> surfaceOption <*> format <*> outputFileOption <*> arrayChoice)
  where
    format =
      option
        (namedReaderBy usualName "format" formats)
        ( long "format"
            <> metavar "FORMAT"
            <> completeWith (map fst formats)
            <> value Csv
            <> help "What is printed: csv, c, or mem, which $readmemh reads (default: csv)"
        )
    formats = [("csv", Csv), ("c", C), ("mem", Mem)]
    -- The memory image is also named after $readmemh, which reads it.
    usualName given = case map toLower given of
      "$readmemh" -> "mem"
      "readmemh" -> "mem"
      name -> name

run :: Maybe Surface -> Format -> Maybe FilePath -> ArrayChoice -> IO ExitStatus
run chosen format output choice = do
  profile <- chosenProfile choice
  let on = fromMaybe (profileSurface profile) chosen
      sizeAndText table = (tableSize table, rendered format profile on table)
      built array mask = sizeAndText <$> buildTable (profilePacking profile) (ArrayOn on array) mask
  (size, rendering) <-
    orUnusable locateMessage =<< orUnusable profileMessage (withProfile profile built)
  (heading, body, end) <- maybe (unusable repeated) pure rendering
  let meanwhile = if output `elem` [Nothing, Just "-"] then Printing else NotPrinting
  besideOutput meanwhile (evenly size "addresses") $ \bar -> do
    pieces <- tellingAsRead bar (inPieces body)
    let text = Builder.toLazyByteString heading <> pieces <> Builder.toLazyByteString end
    maybe (Lazy.hPutStr stdout) writeWhole output text
  pure Answered
  where
    repeated =
      "some windows occur more than once, which only --format csv can list; 'pra-tactile prove' \
      \shows where"

-- | What is written for a packed window.
type Row = (Natural, Builder)

-- | Rows in pieces of 4096, each with the number of addresses up to its end.
inPieces :: [Row] -> [(Integer, Lazy.ByteString)]
inPieces given = case splitAt 4096 given of
  ([], _) -> []
  (piece, more) ->
    (toInteger (maximum (map fst piece)) + 1, Builder.toLazyByteString (foldMap snd piece)) :
    inPieces more

-- | The text before the rows, the rows, and the text after them. 'Nothing' if a word would have to
-- hold several positions.
rendered :: Format -> Profile -> Surface -> Table k -> Maybe (Builder, [Row], Builder)
rendered format profile on table = case format of
  Csv -> Just (line "window,row,column", csvRows table, mempty)
  C -> inWords (cHeading profile on table layout) cRow (line "};")
  Mem -> inWords (foldMap (line . ("// " ++)) (description profile on layout)) memRow mempty
  where
    layout = wordLayout profile
    positions = tableUnique noneCode severalCode table
    (noneCode, severalCode) = (-1, -2)
    inWords heading rowOf end
      | Vector.elem severalCode positions = Nothing
      | otherwise =
        Just (heading, zip [0 ..] (map (rowOf . position) (Vector.toList positions)), end)
    position at = if at < 0 then Nothing else Just (fromIntegral at :: Natural)
    cRow at = line ("  " ++ maybe "PRA_TABLE_NONE" show at ++ ",")
    memRow = line . wordText layout . fromMaybe (wordNone layout)

csvRows :: Table k -> [Row]
csvRows table =
  [ (packed, line (intercalate "," (map show [packed, r, c])))
    | (packed, places) <- tableEntries table,
      Position r c <- places
  ]

-- | How a word holds a position, row * columns + column.
data WordLayout = WordLayout
  { -- | the all-ones word of the least whole number of bytes that exceeds every position
    wordNone :: Natural,
    -- | hexadecimal, without zeros before them
    wordText :: Natural -> String,
    -- | 8, 16, 32, ...
    wordBits :: Int
  }

wordLayout :: Profile -> WordLayout
wordLayout profile =
  WordLayout
    { wordNone = none,
      wordText = \n -> let text = showHex n "" in replicate (digits - length text) '0' ++ text,
      wordBits = until (>= 4 * digits) (* 2) 8
    }
  where
    none = until (>= area (profileShape profile)) (\n -> 256 * n + 255) 255
    digits = length (showHex none "")

-- | The description of a table of words, in two lines.
description :: Profile -> Surface -> WordLayout -> [String]
description profile on layout =
  [ "pra-tactile memory table: packed window -> row * "
      ++ show (columns (profileShape profile))
      ++ " + column; "
      ++ wordText layout (wordNone layout)
      ++ " (hexadecimal) where the window does not occur.",
    "surface " ++ surfaceName on ++ ", profile " ++ profileText profile
  ]

cHeading :: Profile -> Surface -> Table k -> WordLayout -> Builder
cHeading profile on table layout =
  foldMap line $
    ["/* " ++ text ++ " */" | text <- description profile on layout]
      ++ [ "#include <stdint.h>",
           "#define PRA_TABLE_NONE 0x" ++ wordText layout (wordNone layout) ++ "u",
           "#define PRA_TABLE_COLUMNS " ++ show (columns (profileShape profile)),
           "static const uint"
             ++ show (wordBits layout)
             ++ "_t pra_table["
             ++ show (tableSize table)
             ++ "] = {"
         ]

line :: String -> Builder
line text = Builder.stringUtf8 text <> Builder.char7 '\n'
