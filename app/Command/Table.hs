{-# LANGUAGE DerivingStrategies #-}
-- | @pra-tactile table@: the memory table from packed window to position, for a program or a ROM.
module Command.Table
  ( command
  ) where

import qualified Data.ByteString.Builder as Builder
import Data.ByteString.Builder (Builder)
import Data.Char (toLower)
import qualified Data.Map.Strict as Map
import Numeric (showHex)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import Options.Applicative hiding (command)
import System.IO (stdout)

import ArrayChoice
import Command.Prove (surfaceOption)
import Described
import Ending
import Output (writeWhole)
import Json
import Json.Profile
import Message
import PraTactile.Array (Position (..), Shape (..), Surface (..))
import PraTactile.Locate
import PraTactile.Profile

-- | The forms the table can take.
data Format = Csv | C | Mem
  deriving stock (Eq, Show)

command :: Mod CommandFields (IO Ending)
command = described "table" "Print the memory table: each packed window's position, as CSV, as a C array, or as a memory image for $readmemh."
  [ "pra-tactile table --format csv"
  , "pra-tactile table --format c > table.h" ]
  (run <$> arrayChoice <*> surfaceOption <*> format <*> optional (strOption (long "output" <> metavar "FILE" <> action "file" <> help "Write to a file instead of the standard output")))
  where
    format = option (eitherReader formatNamed) (long "format" <> metavar "FORMAT" <> completeWith ["csv", "c", "mem"] <> value Csv <> help "csv, c or mem (default: csv)")
    formatNamed name = case map toLower name of
      "csv" -> Right Csv
      "c" -> Right C
      "mem" -> Right Mem
      _ -> Left (show name ++ " is not a format; choose csv, c or mem")

run :: ArrayChoice -> Maybe Surface -> Format -> Maybe FilePath -> IO Ending
run choice chosen format output = do
  profile <- chosenProfile choice
  let on = fromMaybe (profileSurface profile) chosen
      built array mask = (\table -> (tableSize table, tableEntries table)) <$> buildTable (profilePacking profile) on array mask
  (size, entries) <- orUnusable locateMessage =<< orUnusable profileMessage (withProfile profile built)
  case [ () | format /= Csv, (_, _ : _ : _) <- entries ] of
    [] -> maybe (Builder.hPutBuilder stdout) (\file -> writeWhole file . Builder.toLazyByteString) output
            (render format profile on size entries)
    _ -> unusable "some windows occur more than once, which only --format csv can list; 'pra-tactile prove' shows where"
  pure Answered

-- | The table; positions are linear, row * columns + column, where a word must hold them.
render :: Format -> Profile -> Surface -> Natural -> [(Natural, [Position])] -> Builder
render format profile on size entries = case format of
  Csv -> line "window,row,column"
    <> mconcat [ line (show packed ++ "," ++ show r ++ "," ++ show c) | (packed, places) <- entries, Position r c <- places ]
  C -> mconcat (map line heading)
    <> mconcat [ line ("  " ++ maybe (macro ++ "_NONE") show (Map.lookup packed linear) ++ ",") | packed <- addresses ]
    <> line "};"
  Mem -> mconcat (map (line . ("// " ++)) description)
    <> mconcat [ line (hex (Map.findWithDefault none packed linear)) | packed <- addresses ]
  where
    line text = Builder.stringUtf8 text <> Builder.char7 '\n'
    Shape high wide = profileShape profile
    addresses = takeWhile (< size) [0 ..]
    linear = Map.fromList [ (packed, r * wide + c) | (packed, Position r c : _) <- entries ]
    -- The all-ones word of the least whole number of bytes that exceeds every position.
    none = until (>= high * wide) (\n -> 256 * n + 255) 255
    digits = length (showHex none "")
    hex n = let text = showHex n "" in replicate (digits - length text) '0' ++ text
    macro = "PRA_TABLE"
    bits = until (>= 4 * digits) (* 2) 8 :: Int
    description =
      [ "pra-tactile memory table: packed window -> row * " ++ show wide ++ " + column; " ++ showHex none "" ++ " (hexadecimal) where the window does not occur."
      , "surface " ++ surfaceName on ++ ", profile " ++ profileText profile ]
    heading =
      [ "/* " ++ text ++ " */" | text <- description ]
      ++ [ "#include <stdint.h>"
         , "#define " ++ macro ++ "_NONE 0x" ++ showHex none "" ++ "u"
         , "#define " ++ macro ++ "_COLUMNS " ++ show wide
         , "static const uint" ++ show bits ++ "_t pra_table[" ++ show size ++ "] = {" ]
