{-# LANGUAGE OverloadedStrings #-}

-- | The embossed shapes that stand for the classes of an alphabet (the paper's section II.B):
-- bitmaps 8 taxels wide and 12 tall, and the drawing file they are kept in. Which element a class
-- denotes is not known here.
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

    -- * What can be wrong
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

-- | Why a bitmap, an alphabet, its drawing file or a design is refused.
data ShapeError
  = -- | A bitmap must have 12 rows; this one has this many.
    WrongRowCount Int
  | -- | A row (counted from 0) must be 8 taxels wide; this one has this many.
    WrongRowWidth Int Int
  | -- | An alphabet has at least one shape.
    EmptyAlphabet
  | -- | An alphabet has at most 'maxShapes' shapes; this one has more.
    TooManyShapes
  | -- | A shape without any embossed taxel could not be distinguished from a face without symbols.
    BlankShape Text
  | -- | Two shapes have the same name.
    RepeatedName Text
  | -- | The two shapes so named are the same bitmap.
    RepeatedShape Text Text
  | -- | A name must be printable without spaces at either end, and not empty.
    BadName Text
  | -- | There is no such class in an alphabet of this many.
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
  | -- | The drawing file is text in this encoding, and not in UTF-8.
    DrawingsInEncoding OtherEncoding
  | -- | No alphabet meets the constraints of a design.
    NoAlphabet
  deriving stock (Eq, Show)

-- | A shape: which of its 8 x 12 taxels are embossed. The order is that of the rows' first
-- difference, embossed after flat, read backwards; it serves only to make sets.
newtype Bitmap = Bitmap Integer -- bit 8 * row + column
  deriving stock (Eq, Ord)

-- | Shown as its drawing, one string a row.
instance Show Bitmap where
  showsPrec d = showsPrec d . T.lines . drawBitmap

-- | A bitmap from its rows, from the top, 'True' where embossed. Refuses anything but 12 rows
-- ('WrongRowCount') of 8 ('WrongRowWidth').
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

-- | The bitmap whose taxel at a column and row is embossed where the function says so.
bitmapWhere :: (Int -> Int -> Bool) -> Bitmap
bitmapWhere f = fromRows [[f x y | x <- [0 .. symbolWidth - 1]] | y <- [0 .. symbolHeight - 1]]

-- | The rows of a bitmap, from the top.
bitmapRows :: Bitmap -> [[Bool]]
bitmapRows b = [[embossedAt b x y | x <- [0 .. symbolWidth - 1]] | y <- [0 .. symbolHeight - 1]]

-- | Whether the taxel at this column and row, counted from 0 at the upper left, is embossed.
-- Outside the box nothing is.
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

-- | Turned or mirrored; the callers exchange no axes.
seenAs :: Symmetry -> Bitmap -> Bitmap
seenAs symmetry = fromRows . onRows symmetry . bitmapRows

-- | The callers hold 12 rows of 8.
fromRows :: [[Bool]] -> Bitmap
fromRows rows = Bitmap (foldl' setBit 0 [i | (i, True) <- zip [0 ..] (concat rows)])

-- | Shapes with a name for each, whatever they show, in order of class.
type Drawings = NonEmpty (Text, Bitmap)

-- | Drawings from their names and shapes. Refuses none at all, more than 'maxShapes', a repeated
-- name, and one that a drawing file could not hold.
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

-- | The shapes of the classes 0, 1, ... with a name for each; all different, none blank.
newtype Alphabet = Alphabet Drawings
  deriving stock (Eq, Show)

-- | An alphabet from its names and shapes, class by class. Refuses what 'toDrawings' does, a blank
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

-- | The most shapes of an alphabet, 256: as many as the largest field has elements.
maxShapes :: Int
maxShapes = 256

-- | The number of classes.
alphabetSize :: Alphabet -> Int
alphabetSize = length . alphabetDrawings

-- | Its drawings.
alphabetDrawings :: Alphabet -> Drawings
alphabetDrawings (Alphabet given) = given

-- | The shapes, in order of class.
shapes :: Alphabet -> [Bitmap]
shapes = map snd . toList . alphabetDrawings

-- | The names, in order of class.
shapeNames :: Alphabet -> [Text]
shapeNames = map fst . toList . alphabetDrawings

-- | The name of a class's shape; nothing of a class that the alphabet does not have.
shapeName :: Alphabet -> Int -> String
shapeName a k = concatMap T.unpack (take 1 (drop k (shapeNames a)))

-- | The shape of a class. Refuses a class that the alphabet does not have.
shapeOf :: Alphabet -> Int -> Either ShapeError Bitmap
shapeOf a k = case drop k (shapes a) of
  shape : _ | k >= 0 -> Right shape
  _ -> Left (UnknownClass k (alphabetSize a))

-- | Twelve lines of @#@ (embossed) and @.@ (flat).
drawBitmap :: Bitmap -> Text
drawBitmap = T.unlines . map (T.pack . map (\e -> if e then '#' else '.')) . bitmapRows

-- | The drawing file of an alphabet: for each class in order a line @symbol NAME@ and its drawing,
-- with an empty line between.
renderAlphabet :: Alphabet -> Text
renderAlphabet = renderDrawings . alphabetDrawings

-- | The same of any drawings.
renderDrawings :: Drawings -> Text
renderDrawings given =
  T.intercalate "\n" ["symbol " <> name <> "\n" <> drawBitmap shape | (name, shape) <- toList given]

-- | Reads the bytes of a drawing file, UTF-8, as 'parseAlphabet' does.
decodeAlphabet :: ByteString -> Either ShapeError Alphabet
decodeAlphabet = decodeDrawings >=> distinct

-- | The same, but of shapes that an alphabet could not have as well.
decodeDrawings :: ByteString -> Either ShapeError Drawings
decodeDrawings = either (Left . refused) parseDrawings . plainUtf8
  where
    refused why = case why of
      InEncoding encoding -> DrawingsInEncoding encoding
      NotUtf8Text -> NotText

-- | Reads a drawing file as 'renderAlphabet' writes it. Lines that begin with @;@ are comments;
-- empty lines and spaces at the end of a line do not count.
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

-- | What a line of the drawing file says.
data DrawingLine = Heading Text | Row [Bool]
