-- | The size limit of written patches, checked on the text before anything is built from it. So the
-- memory for any line is proportional to its length.
module PatchBound
  ( largestPatch,
    oversized,
    excerpt,
    longestWord,
  )
where

import Data.Char (isSpace)
import Data.Text (Text)
import qualified Data.Text as Text

-- | 2^16 cells. The largest composite that frames are assembled to, of 2^22 taxels, has room for
-- 13107 symbols of 16 x 20 taxels: no touch tells more than that.
largestPatch :: Int
largestPatch = 65536

-- | The complaint about a text with more than 'largestPatch' cells, or too long to be a patch over
-- an alphabet of this size. One pass, in constant memory.
oversized :: Int -> Text -> Maybe String
oversized symbols text = case Text.uncons (Text.stripStart text) of
  Just ('[', _) -> ofJson 2
  Just ('{', _) -> ofJson 5
  _ -> ofText
  where
    ofText
      | writtenCells written + sinceSemicolon written > largestPatch = Just tooManyCells
      | writtenMarks written > largestPatch = Just tooManyParts
      | otherwise = Nothing
      where
        written = Text.foldl' writing (Written 0 0 0 False) text
    ofJson deep
      | jsonCells json > largestPatch = Just tooManyCells
      -- Beside the cells there are the probabilities of each, and less.
      | jsonOthers json > largestPatch * (symbols + 2) = Just tooManyParts
      | otherwise = Nothing
      where
        json = Text.foldl' (nesting deep) (Json 0 0 0 Outside) text
    tooManyCells =
      "the patch has more than "
        ++ show largestPatch
        ++ " cells, which is more than can be felt at a time"
    tooManyParts =
      "the patch has too many parts to be one of up to " ++ show largestPatch ++ " cells"

-- | Cells of the patches before, words since the last semicolon, marks, and whether a word goes on.
-- Words before a colon are no cells but a displacement.
data Written = Written
  {writtenCells :: !Int, sinceSemicolon :: !Int, writtenMarks :: !Int, _inWord :: !Bool}

writing :: Written -> Char -> Written
writing (Written cells since marks inWord) letter = case letter of
  ';' -> Written (cells + since) 0 (marks + 1) False
  ':' -> Written cells 0 (marks + 1) False
  '/' -> Written cells since (marks + 1) False
  _
    | isSpace letter -> Written cells since marks False
    | otherwise -> Written cells (if inWord then since else since + 1) marks True

-- | Cells and other values, how many brackets are open, and where in the text this is.
data Json = Json {jsonCells :: !Int, jsonOthers :: !Int, _open :: !Int, _where :: !Where}

data Where = Outside | InString | Escaped

-- | Cells are the values within this many brackets.
nesting :: Int -> Json -> Char -> Json
nesting deep (Json cells others open place) letter = case (place, letter) of
  (Escaped, _) -> Json cells others open InString
  (InString, '\\') -> Json cells others open Escaped
  (InString, '"') -> Json cells others open Outside
  (InString, _) -> Json cells others open InString
  (Outside, '"') -> Json cells others open InString
  (Outside, ',') -> value open
  (Outside, _)
    | letter `elem` "[{" -> value (open + 1)
    | letter `elem` "]}" -> Json cells others (open - 1) Outside
    | otherwise -> Json cells others open Outside
  where
    value depth
      | depth == deep = Json (cells + 1) others depth Outside
      | otherwise = Json cells (others + 1) depth Outside

-- | A word of this many characters or more is no element and no number of a displacement.
longestWord :: Int
longestWord = 64

-- | The beginning of a word that is too long to be repeated.
excerpt :: Text -> String
excerpt word
  | Text.length word < longestWord = Text.unpack word
  | otherwise = Text.unpack (Text.take 24 word) ++ "..."
