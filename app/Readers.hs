-- | Readers of option values: decimal numbers, by "PraTactile.Decimal", and values made of them.
-- The forms of programming languages are refused: @0x10@, @" 1"@, @1_000@, @NaN@.
module Readers
  ( -- * Numbers
    Decimal (..),
    decimalReader,
    naturalReader,
    intReader,
    numbersReader,

    -- * Pairs of numbers
    pairReader,
    shapeReader,
    positionReader,
    readPosition,

    -- * Paths
    pathReader,

    -- * Names
    namedReader,
    namedReaderBy,
    namesReader,
  )
where

import Data.Bifunctor (first)
import Data.Char (isSpace)
import Data.Foldable (toList)
import Data.List (intercalate)
import Data.List.NonEmpty (NonEmpty (..))
import Numeric.Natural (Natural)
import Options.Applicative (ReadM, eitherReader)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Decimal (NotDecimal (..), asciiOf, readDouble, readWhole)
import Visible

-- | Numbers that are written in decimal; 'Left' is the complaint about a text.
class Decimal a where
  readDecimal :: String -> Either String a

-- | 0, 1, 2, ...
instance Decimal Natural where
  readDecimal text = case readWhole (asciiOf text) of
    Just n | n >= 0 -> Right (fromInteger n)
    _ -> Left (quoted text ++ " is not a whole number from 0 on")

-- | ..., -1, 0, 1, ...
instance Decimal Integer where
  readDecimal text =
    maybe (Left (quoted text ++ " is not a whole number")) Right (readWhole (asciiOf text))

-- | Whole numbers within the range of the machine.
instance Decimal Int where
  readDecimal text =
    readDecimal text >>= \n ->
      if n > toInteger (maxBound :: Int) || n < toInteger (minBound :: Int)
        then Left (quoted text ++ " is too large")
        else Right (fromInteger n)

-- | Any decimal number, as the nearest machine number.
instance Decimal Double where
  readDecimal text = first why (readDouble (asciiOf text))
    where
      why fault = quoted text ++ if fault == OutOfReach then " is too large" else " is not a number"

-- | A number of the type wanted.
decimalReader :: Decimal a => ReadM a
decimalReader = eitherReader readDecimal

-- | A number 0, 1, 2, ...
naturalReader :: ReadM Natural
naturalReader = decimalReader

-- | A whole number within the range of the machine.
intReader :: ReadM Int
intReader = decimalReader

-- | Two numbers separated by @x@, as 15x17: rows, then columns.
shapeReader :: ReadM Shape
shapeReader = eitherReader $ \text -> case splitOn 'x' text of
  high :| [wide] -> Shape <$> readDecimal high <*> readDecimal wide
  _ -> Left (quoted text ++ " is not a shape; write ROWSxCOLUMNS, as in 15x17")

-- | Two numbers separated by a comma: row, then column.
positionReader :: ReadM Position
positionReader = eitherReader readPosition

-- | The position in a text: row and column, separated by a comma.
readPosition :: String -> Either String Position
readPosition text = case splitOn ',' text of
  r :| [c] -> Position <$> readDecimal (trim r) <*> readDecimal (trim c)
  _ -> Left (quoted text ++ " is not a position; write ROW,COLUMN, as in 6,5")

-- | Numbers separated by commas.
numbersReader :: ReadM [Natural]
numbersReader = eitherReader $ \text -> case splitOn ',' text of
  one :| others -> traverse (readDecimal . trim) (one : others)

-- | Two numbers separated by a character, given an example for messages.
pairReader :: Decimal a => Char -> String -> ReadM (a, a)
pairReader separator example = eitherReader $ \text -> case splitOn separator text of
  a :| [b] | Right x <- readDecimal a, Right y <- readDecimal b -> Right (x, y)
  _ -> Left (quoted text ++ " is not understood; write it as in " ++ example)

-- | The path of a file or a folder; an empty text is refused.
pathReader :: ReadM FilePath
pathReader = eitherReader $ \text ->
  if null text then Left "an empty text names no file or folder" else Right text

-- | One of these values by its name, given what messages call such a value.
namedReader :: String -> [(String, a)] -> ReadM a
namedReader = namedReaderBy id

-- | One of these values by its name, after a function has normalised the text.
namedReaderBy :: (String -> String) -> String -> [(String, a)] -> ReadM a
namedReaderBy normal what choices = eitherReader (readNamed normal what choices)

readNamed :: (String -> String) -> String -> [(String, a)] -> String -> Either String a
readNamed normal what choices name = case lookup (normal name) choices of
  Just choice -> Right choice
  Nothing -> Left (quoted name ++ " is no " ++ what ++ "; write " ++ alternatives (map fst choices))
  where
    alternatives names = case reverse names of
      final : others@(_ : _) -> intercalate ", " (reverse others) ++ " or " ++ final
      _ -> concat names

-- | Some of these values by their names, separated by commas.
namesReader :: String -> [(String, a)] -> ReadM [a]
namesReader what choices =
  eitherReader (traverse (readNamed id what choices . trim) . toList . splitOn ',')

splitOn :: Char -> String -> NonEmpty String
splitOn separator text = case break (== separator) text of
  (part, _ : rest) -> let next :| others = splitOn separator rest in part :| (next : others)
  (part, []) -> part :| []

trim :: String -> String
trim = reverse . dropWhile isSpace . reverse . dropWhile isSpace
