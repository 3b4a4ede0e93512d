{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The lines and words of text formats.
module PraTactile.Format.Solid.Text
  ( Line (..),
    plain,
    linesOf,
    atLine,
    numbers,
    joined,
    textLine,
  )
where

import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder, string7)
import qualified Data.ByteString.Char8 as Char8
import Data.Maybe (fromMaybe)
import PraTactile.Format.Solid.Error
import PraTactile.Format.Solid.Number
import PraTactile.PlainText (plainText)

-- | A line with its number, counted from 1, and its words.
data Line = Line {lineNumber :: !Int, lineWords :: [ByteString]}
  deriving stock (Eq, Show)

-- | The text of a text format's bytes, with lines separated by LF. Refuses other encodings than
-- UTF-8.
plain :: ByteString -> Either SolidFileError ByteString
plain = either (Left . SolidFileError (AtLine 1) . FileInEncoding) Right . plainText

-- | The lines that have words. Text after @#@ is dropped.
linesOf :: ByteString -> [Line]
linesOf = filter (not . null . lineWords) . zipWith Line [1 ..] . map wordsOf . Char8.split '\n'
  where
    wordsOf = Char8.words . Char8.takeWhile (/= '#')

-- | Adds a line's number to a fault.
atLine :: Line -> Either Fault a -> Either SolidFileError a
atLine line = either (Left . SolidFileError (AtLine (lineNumber line))) Right

-- | The first three words as numbers. Refuses fewer words, and words that are no numbers.
numbers :: [ByteString] -> Either Fault (Number, Number, Number)
numbers given = case given of
  a : b : c : _ -> (,,) <$> decimal a <*> decimal b <*> decimal c
  _ -> Left (Needed "three coordinates")

-- | Joins lines whose last word ends in a backslash with the next line. The number is that of the
-- first line.
joined :: [Line] -> [Line]
joined given = case given of
  line : next : others
    | Just start <- continued line ->
      joined (Line (lineNumber line) (start ++ lineWords next) : others)
  line : others -> line {lineWords = fromMaybe (lineWords line) (continued line)} : joined others
  [] -> []
  where
    continued line = case reverse (lineWords line) of
      final : before
        | Just (start, '\\') <- Char8.unsnoc final ->
          Just (reverse before ++ [start | not (Char8.null start)])
      _ -> Nothing

-- | A line of output with the given words.
textLine :: [String] -> Builder
textLine = (<> "\n") . string7 . unwords
