-- | Grids as people write them: rows separated by slashes or line ends.
module PraTactile.Rows
  ( rowsOf,
    textLines,
  )
where

import Data.Char (isSpace)
import Data.List (dropWhileEnd, isPrefixOf, isSuffixOf)

-- | The rows of a grid, without the spaces around each. Rows are separated by a slash, a line end,
-- or a slash between line ends. A separator after the last row and blank lines are ignored. Two
-- slashes have an empty row between them.
--
-- >>> rowsOf "3 2 / 3 1"
-- ["3 2","3 1"]
-- >>> rowsOf "3 2\r\n3 1 /\r\n\r\n"
-- ["3 2","3 1"]
rowsOf :: String -> [String]
rowsOf = withoutBlankLast . parted . foldr (beside . trim) "" . textLines
  where
    beside one other
      | null one || null other || "/" `isSuffixOf` one || "/" `isPrefixOf` other = one ++ other
      | otherwise = one ++ '/' : other
    parted line = case break (== '/') line of
      (row, _ : others) -> trim row : parted others
      (row, []) -> [trim row]
    withoutBlankLast rows = case reverse rows of
      "" : others -> reverse others
      _ -> rows

-- | The lines of a text. A line ends with LF, CR, CR LF, or any other Unicode character for a new
-- line or page. Text after the last line end is a line if it is not empty.
textLines :: String -> [String]
textLines text = case break (`elem` lineEnds) text of
  ("", "") -> []
  (line, '\r' : '\n' : others) -> line : textLines others
  (line, _ : others) -> line : textLines others
  (line, []) -> [line]
  where
    lineEnds = "\n\r\v\f\x85\x2028\x2029"

trim :: String -> String
trim = dropWhileEnd isSpace . dropWhile isSpace
