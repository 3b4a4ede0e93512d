-- | Text of foreign origin, such as names and values, as it is shown: on one line, in printable
-- characters, of limited length.
module Visible
  ( visible,
    visibleName,
    withoutPasswords,
    nameInJson,
    objectCalled,
    quoted,
    visibleLine,
  )
where

import Data.Char (GeneralCategory (..), generalCategory, isSpace, ord)
import Data.List (stripPrefix)
import Numeric (showHex)
import PraTactile.Object.Description (ObjectName (..))
import PraTactile.Store (shownName)

-- | A text with control and unprintable characters as escapes: @\\n@, @\\x1b@. A byte of a file's
-- name that is no UTF-8 arrives as one of the characters U+DC80 to U+DCFF and is shown as the byte
-- that it was: @\\xe9@.
visible :: String -> String
visible = concatMap escaped
  where
    escaped c
      | c == '\n' = "\\n"
      | c == '\t' = "\\t"
      | c == '\r' = "\\r"
      | '\xDC80' <= c && c <= '\xDCFF' = hexadecimal (ord c - 0xDC00)
      | generalCategory c `elem` [Control, Format, Surrogate, LineSeparator, ParagraphSeparator] =
        hexadecimal (ord c)
      | otherwise = [c]
    hexadecimal n = "\\x" ++ (if n < 16 then "0" else "") ++ showHex n ""

-- | A file's or a database's name as it is shown in a result.
visibleName :: FilePath -> String
visibleName = visible . shownName

-- | A file's or a database's name as JSON has it: as it is shown, but for bytes that are no UTF-8,
-- which are escaped as in 'visible'.
nameInJson :: FilePath -> String
nameInJson =
  concatMap (\c -> if generalCategory c == Surrogate then visible [c] else [c]) . shownName

-- | The object of this name, of a file or an option: the text that it has in JSON, so that a name
-- with bytes that are no UTF-8 is the same one in placements, messages and options.
objectCalled :: String -> ObjectName
objectCalled = ObjectName . nameInJson

-- | A text between quotation marks, as messages show the user's values.
quoted :: String -> String
quoted text = "\"" ++ visibleName text ++ "\""

-- | A message in which each of these arguments that has a password is as 'shownName' shows it. An
-- argument may stand in the message as it is, or as messages show it, or be an option's value.
withoutPasswords :: [String] -> String -> String
withoutPasswords arguments message = foldl hidden message (concatMap values arguments)
  where
    values argument = argument : [value | (_, '=' : value) <- [break (== '=') argument]]
    hidden text value
      | shown == value = text
      | otherwise = foldl (replaced shown) text [value, visible value, unwords (words value)]
      where
        shown = shownName value
    replaced new text old
      | null old = text
      | otherwise = go text
      where
        go [] = []
        go rest@(c : others) = maybe (c : go others) ((new ++) . go) (stripPrefix old rest)

-- | A message as one line: visible, its long words cut in the middle, and cut itself where it is
-- longer than a screen.
visibleLine :: String -> String
visibleLine = cut 2000 80 . concatMap shorter . pieces . visible
  where
    shorter piece = if any isSpace (take 1 piece) then piece else cut 400 80 piece
    pieces text = case text of
      [] -> []
      c : _ -> let (piece, others) = span ((== isSpace c) . isSpace) text in piece : pieces others
    -- At most this many characters, of which the second number from the end.
    cut most end text
      | null (drop most text) = text
      | otherwise =
        take (most - end) text ++ " ... (" ++ show (length text) ++ " characters) ... "
          ++ drop (length text - end) text
