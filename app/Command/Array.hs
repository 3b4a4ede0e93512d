{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile array@: the array itself, as text, CSV, JSON, PGM or SVG.
module Command.Array
  ( command,
  )
where

import ArrayChoice
import Codec.Picture (Image (..), Pixel8)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.List (intercalate, transpose)
import qualified Data.Vector.Storable as Storable
import ExitStatus
import Message (foldMessage, imageMessage, profileMessage)
import Options
import Output (writeWhole)
import Picture.Array (arraySvg)
import PraTactile.Array (Shape (..), toRows)
import PraTactile.Field (showElement, toCode)
import PraTactile.Format (encodeArray)
import PraTactile.Image.Pgm (PgmFormat (..), encodePgm, pgm8)
import PraTactile.Profile

-- | The output formats.
data Format = Text | Csv | Json | Pgm | Svg
  deriving stock (Eq, Show)

command :: Subcommand
command =
  subcommand
    "array"
    "Print the array as text, CSV, JSON, PGM or SVG"
    "Print the array, one row a line. Text has the elements, as 0, 1, A and A^2; CSV, JSON and PGM \
    \have their codes."
    [arrayGroup]
    [ "pra-tactile array",
      "pra-tactile array --format csv --q 2 --polynomial 1,1,0,0,1 --shape 3x5"
    ]
    (run <$> format <*> outputFileOption <*> arrayChoice)
  where
    format = choosing "format" formats "format" "FORMAT" text (value Text)
    text = "What is printed: text, csv, json, pgm or svg (default: text)"
    formats = [("text", Text), ("csv", Csv), ("json", Json), ("pgm", Pgm), ("svg", Svg)]

-- | The array with each element's code and its name.
type Cells = [[(Int, String)]]

run :: Format -> Maybe FilePath -> ArrayChoice -> IO ExitStatus
run format output choice = do
  profile <- chosenProfile choice
  cells <-
    orUnusable
      profileMessage
      (withProfile profile (\array _ -> fmap (map (map named)) (toRows array)))
  rendered <- orUnusable foldMessage cells
  maybe Lazy.putStr writeWhole output =<< render format profile rendered
  pure Answered
  where
    named element = (toCode element, showElement element)

render :: Format -> Profile -> Cells -> IO Lazy.ByteString
render format profile cells = case format of
  Text -> pure (Lazy8.pack (unlines (alignedRows (map (map snd) cells))))
  Csv -> pure (Lazy8.pack (unlines (map (intercalate "," . map show) codes)))
  Json -> pure (encodeArray profile codes <> "\n")
  Pgm ->
    Lazy.fromStrict . encodePgm Binary
      <$> orUnusable
        imageMessage
        (pgm8 (fromIntegral (profileOrder profile - 1)) (codeImage profile codes))
  Svg -> pure (arraySvg cells)
  where
    codes = map (map fst) cells

codeImage :: Profile -> [[Int]] -> Image Pixel8
codeImage profile codes =
  Image
    (fromIntegral wide)
    (fromIntegral high)
    (Storable.fromList (map fromIntegral (concat codes)))
  where
    Shape high wide = profileShape profile

-- | Rows of words in columns of equal width, no space at the ends of lines.
alignedRows :: [[String]] -> [String]
alignedRows grid = [trimEnd (unwords (zipWith pad widths line)) | line <- grid]
  where
    widths = map (maximum . map length) (transpose grid)
    pad width word = word ++ replicate (width - length word) ' '
    trimEnd = reverse . dropWhile (== ' ') . reverse
