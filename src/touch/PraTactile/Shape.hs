{-# LANGUAGE OverloadedStrings #-}

-- | The embossed shapes of an alphabet's classes (the paper's section II.B): bitmaps 8 taxels wide
-- and 12 tall, and their drawing file. Which element of the field a class denotes is defined
-- elsewhere.
module PraTactile.Shape
  ( -- * Bitmaps
    Bitmap,
    bitmap,
    bitmapWhere,
    bitmapRows,
    embossedAt,
    area,
    toRaster,
    symbolWidth,
    symbolHeight,

    -- * Symmetries
    halfTurned,
    mirroredColumns,
    mirroredRows,

    -- * Alphabets
    Alphabet,
    alphabet,
    alphabetSize,
    shapes,
    shapeNames,
    shapeName,
    shapeOf,
    maxShapes,

    -- * Drawings
    Drawings,
    toDrawings,
    alphabetDrawings,
    decodeDrawings,
    decodeAlphabet,
    parseAlphabet,
    renderAlphabet,
    renderDrawings,
    drawBitmap,

    -- * Errors
    ShapeError (..),
  )
where

import Control.Monad (foldM, zipWithM_, (>=>))
import Data.Bits (popCount, setBit, testBit)
import Data.ByteString (ByteString)
import Data.Char (isSpace)
import Data.Foldable (toList)
import Data.List (foldl')
import Data.List.NonEmpty (NonEmpty, nonEmpty)
import Data.Text (Text)
import qualified Data.Text as T
import PraTactile.Geometry (symbolHeight, symbolWidth)
import PraTactile.Image (Raster, generate)
import PraTactile.PlainText
import PraTactile.Symmetry

-- | Why a bitmap, an alphabet, a drawing file or a design is refused.
data ShapeError
  = -- | The bitmap has this many rows; it must have 12.
    WrongRowCount Int
  | -- | This row (counted from 0) is this many taxels wide; it must be 8.
    WrongRowWidth Int Int
  | -- | The alphabet has no shape.
    EmptyAlphabet
  | -- | The alphabet has more than 'maxShapes' shapes.
    TooManyShapes
  | -- | The shape has no embossed taxel, so it looks like a face without symbols.
    BlankShape Text
  | -- | Two shapes have the same name.
    RepeatedName Text
  | -- | The two named shapes are the same bitmap.
    RepeatedShape Text Text
  | -- | The name is empty, begins or ends with a space, or is not printable.
    BadName Text
  | -- | The alphabet does not have this class; its number of classes follows.
    UnknownClass Int Int
  | -- | The line of the drawing file (counted from 1) is neither a row of @#@ and @.@, nor @symbol
    -- NAME@, nor a comment, nor empty.
    UnreadableLine Int Text
  | -- | The row on this line of the drawing file comes before any @symbol NAME@.
    RowWithoutSymbol Int
  | -- | The drawing that begins on this line is refused for the reason given.
    BadDrawing Int ShapeError
  | -- | The drawing file is not UTF-8 text.
    NotText
  | -- | The drawing file is text in this encoding, not in UTF-8.
    DrawingsInEncoding OtherEncoding
  | -- | No alphabet meets the constraints of a design.
    NoAlphabet
  deriving stock (Eq, Show)

-- | A shape: which of its 8 x 12 taxels are embossed. The ordering is arbitrary and only for sets.
newtype Bitmap = Bitmap Integer -- bit 8 * row + column
  deriving stock (Eq, Ord)

-- | Shows a bitmap as its drawing, one string per row.
instance Show Bitmap where
  showsPrec d = showsPrec d . T.lines . drawBitmap

-- | A bitmap from its rows, top to bottom, 'True' where embossed. Refuses anything but 12 rows
-- ('WrongRowCount') of 8 taxels ('WrongRowWidth').
bitmap :: [[Bool]] -> Either ShapeError Bitmap
bitmap rows
  | length rows /= symbolHeight = Left (WrongRowCount (length rows))
  | otherwise = do
    zipWithM_
      ( \i row ->
          if length row == symbolWidth
            then Right ()
            else Left (WrongRowWidth i (length row))
      )
      [0 ..]
      rows
    Right (fromRows rows)

-- | The bitmap that is embossed where the function of column and row says so.
bitmapWhere :: (Int -> Int -> Bool) -> Bitmap
bitmapWhere f = fromRows [[f x y | x <- [0 .. symbolWidth - 1]] | y <- [0 .. symbolHeight - 1]]

-- | The rows of a bitmap, from the top.
bitmapRows :: Bitmap -> [[Bool]]
bitmapRows b = [[embossedAt b x y | x <- [0 .. symbolWidth - 1]] | y <- [0 .. symbolHeight - 1]]

-- | Whether the taxel at a column and a row, counted from 0 at the upper left, is embossed.
-- 'False' outside the box.
embossedAt :: Bitmap -> Int -> Int -> Bool
embossedAt (Bitmap bits) x y =
  x >= 0 && x < symbolWidth && y >= 0 && y < symbolHeight && testBit bits (y * symbolWidth + x)

-- | The number of embossed taxels.
area :: Bitmap -> Int
area (Bitmap bits) = popCount bits

-- | The bitmap as an 8 x 12 image, 1 where embossed and 0 elsewhere.
toRaster :: Bitmap -> Raster
toRaster b = generate symbolWidth symbolHeight (\x y -> if embossedAt b x y then 1 else 0)

-- | Turned by 180 degrees.
halfTurned :: Bitmap -> Bitmap
halfTurned = seenAs (turned 2)

-- | Left and right exchanged.
mirroredColumns :: Bitmap -> Bitmap
mirroredColumns = seenAs mirror

-- | Top and bottom exchanged.
mirroredRows :: Bitmap -> Bitmap
mirroredRows = seenAs (turned 2 <> mirror)

-- | The bitmap under a symmetry that does not exchange the axes.
seenAs :: Symmetry -> Bitmap -> Bitmap
seenAs symmetry = fromRows . onRows symmetry . bitmapRows

-- | A bitmap from 12 rows of 8, which the callers guarantee.
fromRows :: [[Bool]] -> Bitmap
fromRows rows = Bitmap (foldl' setBit 0 [i | (i, True) <- zip [0 ..] (concat rows)])

-- | Named shapes in order of class, without conditions on the shapes.
type Drawings = NonEmpty (Text, Bitmap)

-- | Drawings from names and shapes. Refuses an empty list, more than 'maxShapes', a repeated name,
-- and a name that a drawing file cannot hold.
toDrawings :: [(Text, Bitmap)] -> Either ShapeError Drawings
toDrawings given
  | not (null (drop maxShapes given)) = Left TooManyShapes
  | otherwise = maybe (Left EmptyAlphabet) Right (nonEmpty given) <* foldM named [] (map fst given)
  where
    named seen name
      | T.null name || name /= T.strip name || T.any (\c -> isSpace c && c /= ' ') name =
        Left (BadName name)
      | name `elem` seen = Left (RepeatedName name)
      | otherwise = Right (name : seen)

-- | The named shapes of the classes 0, 1, ...: all different, none blank.
newtype Alphabet = Alphabet Drawings
  deriving stock (Eq, Show)

-- | An alphabet from names and shapes, class by class. Refuses what 'toDrawings' refuses, a blank
-- shape and a repeated one.
alphabet :: [(Text, Bitmap)] -> Either ShapeError Alphabet
alphabet = toDrawings >=> distinct

distinct :: Drawings -> Either ShapeError Alphabet
distinct given = Alphabet given <$ foldM shown [] given
  where
    shown seen (name, shape)
      | area shape == 0 = Left (BlankShape name)
      | Just other <- lookup shape seen = Left (RepeatedShape other name)
      | otherwise = Right ((shape, name) : seen)

-- | The greatest number of shapes in an alphabet, 256: the size of the largest field.
maxShapes :: Int
maxShapes = 256

-- | The number of classes.
alphabetSize :: Alphabet -> Int
alphabetSize = length . alphabetDrawings

-- | The named shapes of an alphabet.
alphabetDrawings :: Alphabet -> Drawings
alphabetDrawings (Alphabet given) = given

-- | The shapes, in order of class.
shapes :: Alphabet -> [Bitmap]
shapes = map snd . toList . alphabetDrawings

-- | The names, in order of class.
shapeNames :: Alphabet -> [Text]
shapeNames = map fst . toList . alphabetDrawings

-- | The name of a class's shape; empty for an unknown class.
shapeName :: Alphabet -> Int -> String
shapeName a k = concatMap T.unpack (take 1 (drop k (shapeNames a)))

-- | The shape of a class. Refuses an unknown class ('UnknownClass').
shapeOf :: Alphabet -> Int -> Either ShapeError Bitmap
shapeOf a k = case drop k (shapes a) of
  shape : _ | k >= 0 -> Right shape
  _ -> Left (UnknownClass k (alphabetSize a))

-- | Twelve lines of @#@ (embossed) and @.@ (flat).
drawBitmap :: Bitmap -> Text
drawBitmap = T.unlines . map (T.pack . map (\e -> if e then '#' else '.')) . bitmapRows

-- | The drawing file of an alphabet: for each class in order a line @symbol NAME@ and its drawing,
-- separated by empty lines.
renderAlphabet :: Alphabet -> Text
renderAlphabet = renderDrawings . alphabetDrawings

-- | The drawing file of any drawings, in the form of 'renderAlphabet'.
renderDrawings :: Drawings -> Text
renderDrawings given =
  T.intercalate "\n" ["symbol " <> name <> "\n" <> drawBitmap shape | (name, shape) <- toList given]

-- | Reads the bytes of an alphabet's drawing file (UTF-8) as 'parseAlphabet' does.
decodeAlphabet :: ByteString -> Either ShapeError Alphabet
decodeAlphabet = decodeDrawings >=> distinct

-- | Reads the bytes of a drawing file (UTF-8), also with blank or repeated shapes.
decodeDrawings :: ByteString -> Either ShapeError Drawings
decodeDrawings = either (Left . refused) parseDrawings . plainUtf8
  where
    refused why = case why of
      InEncoding encoding -> DrawingsInEncoding encoding
      NotUtf8Text -> NotText

-- | Reads an alphabet's drawing file in the form of 'renderAlphabet'. Lines that begin with @;@
-- are comments; empty lines and trailing spaces are ignored.
parseAlphabet :: Text -> Either ShapeError Alphabet
parseAlphabet = parseDrawings >=> distinct

parseDrawings :: Text -> Either ShapeError Drawings
parseDrawings text =
  mapM classify (zip [1 ..] (T.lines text)) >>= collect [] . concat >>= toDrawings
  where
    classify :: (Int, Text) -> Either ShapeError [(Int, DrawingLine)]
    classify (n, raw)
      | T.null line || T.isPrefixOf ";" line = Right []
      | Just name <- T.stripPrefix "symbol " line = Right [(n, Heading (T.strip name))]
      | T.all (`elem` ("#." :: String)) line = Right [(n, Row (map (== '#') (T.unpack line)))]
      | otherwise = Left (UnreadableLine n line)
      where
        line = T.stripEnd raw

    collect done [] = Right (reverse done)
    collect _ ((n, Row _) : _) = Left (RowWithoutSymbol n)
    collect done ((n, Heading name) : rest) = do
      let (rows, others) = spanRows rest
      shape <- either (Left . BadDrawing n) Right (bitmap rows)
      collect ((name, shape) : done) others

    spanRows ((_, Row row) : rest) = let (rows, others) = spanRows rest in (row : rows, others)
    spanRows others = ([], others)

-- | A line of the drawing file: a heading with its name, or a row.
data DrawingLine = Heading Text | Row [Bool]
