-- | @pra-tactile table@: the memory table from packed window to position, for a program or a ROM.
module Command.Table
  ( command,
  )
where

import ArrayChoice
import Command.Prove (surfaceOption)
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Vector
import Described
import Ending
import Json
import Message
import Numeric (showHex)
import Numeric.Natural (Natural)
import Options.Applicative hiding (command)
import Output (writeWhole)
import PraTactile.Array (Position (..), Shape (..), Surface (..))
import PraTactile.Format.Profile
import PraTactile.Locate
import PraTactile.Profile
import Progress
import System.IO (stdout)

-- | The forms the table can take.
data Format = Csv | C | Mem
  deriving stock (Eq, Show)

command :: Mod CommandFields (IO Ending)
command =
  described
    "table"
    "Print the memory table: each packed window's position, as CSV, as a C array, or as a memory \
    \image for $readmemh."
    [ "pra-tactile table --format csv",
      "pra-tactile table --format c > table.h"
    ]
    ( run
        <$> arrayChoice
        <*> surfaceOption
        <*> format
        <*> optional
          ( strOption
              ( long "output"
                  <> metavar "FILE"
                  <> action "file"
                  <> help "Write to a file instead of the standard output"
              )
          )
    )
  where
    format =
      option
        (eitherReader formatNamed)
        ( long "format"
            <> metavar "FORMAT"
            <> completeWith ["csv", "c", "mem"]
            <> value Csv
            <> help "csv, c or mem (default: csv)"
        )
    formatNamed name = case map toLower name of
      "csv" -> Right Csv
      "c" -> Right C
      "mem" -> Right Mem
      _ -> Left (show name ++ " is not a format; choose csv, c or mem")

run :: ArrayChoice -> Maybe Surface -> Format -> Maybe FilePath -> IO Ending
run choice chosen format output = do
  profile <- chosenProfile choice
  let on = fromMaybe (profileSurface profile) chosen
      told table = (tableSize table, rendered format profile on table)
      built array mask = told <$> buildTable (profilePacking profile) on array mask
  (size, rendering) <-
    orUnusable locateMessage =<< orUnusable profileMessage (withProfile profile built)
  (heading, rows', end) <- maybe (unusable repeated) pure rendering
  besideOutput (output `elem` [Nothing, Just "-"]) (toInteger size) $ \tell -> do
    body <- tellingAsRead tell (inPieces rows')
    let text = Builder.toLazyByteString heading <> body <> Builder.toLazyByteString end
    maybe (Lazy.hPutStr stdout) writeWhole output text
  pure Answered
  where
    repeated =
      "some windows occur more than once, which only --format csv can list; 'pra-tactile prove' \
      \shows where"

-- | What is written for a packed window.
type Row = (Natural, Builder)

-- | Rows by the thousand, each piece with how many addresses it reaches to.
inPieces :: [Row] -> [(Integer, Lazy.ByteString)]
inPieces given = case splitAt 4096 given of
  ([], _) -> []
  (piece, more) ->
    (toInteger (maximum (map fst piece)) + 1, Builder.toLazyByteString (foldMap snd piece)) :
    inPieces more

-- | The table before its rows, the rows, and what follows them; positions are linear, row * columns
-- + column, where a word must hold them. 'Nothing' where a word would have to hold several.
rendered :: Format -> Profile -> Surface -> Table k -> Maybe (Builder, [Row], Builder)
rendered format profile on table = case format of
  Csv ->
    Just
      ( line "window,row,column",
        [ (packed, line (show packed ++ "," ++ show r ++ "," ++ show c))
          | (packed, places) <- tableEntries table,
            Position r c <- places
        ],
        mempty
      )
  _ | Vector.elem severalCode positions -> Nothing
  C ->
    Just
      ( foldMap line heading,
        [ (packed, line ("  " ++ maybe (macro ++ "_NONE") show at ++ ","))
          | (packed, at) <- addresses
        ],
        line "};"
      )
  Mem ->
    Just
      ( foldMap (line . ("// " ++)) description,
        [(packed, line (hex (fromMaybe none at))) | (packed, at) <- addresses],
        mempty
      )
  where
    line text = Builder.stringUtf8 text <> Builder.char7 '\n'
    Shape high wide = profileShape profile
    positions = tableUnique noneCode severalCode table
    (noneCode, severalCode) = (-1, -2)
    addresses =
      [ (packed, if at < 0 then Nothing else Just (fromIntegral at))
        | (packed, at) <- zip [0 ..] (Vector.toList positions)
      ]
    -- The all-ones word of the least whole number of bytes that exceeds every position.
    none = until (>= high * wide) (\n -> 256 * n + 255) 255
    digits = length (showHex none "")
    hex n = let text = showHex n "" in replicate (digits - length text) '0' ++ text
    macro = "PRA_TABLE"
    bits = until (>= 4 * digits) (* 2) 8 :: Int
    description =
      [ "pra-tactile memory table: packed window -> row * "
          ++ show wide
          ++ " + column; "
          ++ showHex none ""
          ++ " (hexadecimal) where the window does not occur.",
        "surface " ++ surfaceName on ++ ", profile " ++ profileText profile
      ]
    heading =
      ["/* " ++ text ++ " */" | text <- description]
        ++ [ "#include <stdint.h>",
             "#define " ++ macro ++ "_NONE 0x" ++ showHex none "" ++ "u",
             "#define " ++ macro ++ "_COLUMNS " ++ show wide,
             "static const uint"
               ++ show bits
               ++ "_t pra_table["
               ++ show (tableSize table)
               ++ "] = {"
           ]
