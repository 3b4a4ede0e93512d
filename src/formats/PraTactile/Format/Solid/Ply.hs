{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The Polygon File Format of Stanford in all three kinds: a header that names elements and their
-- properties, then their values, as text or as machine numbers in either byte order.
module PraTactile.Format.Solid.Ply
  ( readPly,
    writePlyText,
    writePlyBinary,
  )
where

import Control.Monad (replicateM, unless, when)
import Data.Binary.Get
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (find, zip4)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Format.Solid.Contents
import PraTactile.Format.Solid.Error
import PraTactile.Format.Solid.Number
import PraTactile.Format.Solid.Text
import PraTactile.Object.Description (ObjectName)
import PraTactile.Object.Mesh
import PraTactile.PlainText (lineFeeds, otherEncoding, withoutMark)

-- | The encoding of values.
data Coding = AsText | LittleEndian | BigEndian
  deriving stock (Eq, Show)

-- | The type of a value: an integer (signed if the flag is set) or a floating-point number, with
-- its number of bytes.
data Type = Integral Bool Int | Floating Int
  deriving stock (Eq, Show)

data Property = Property
  { propertyName :: ByteString,
    -- | for a list, the type of its length
    propertyLength :: Maybe Type,
    propertyType :: Type
  }
  deriving stock (Eq, Show)

data Element = Element
  {elementName :: ByteString, elementCount :: Int, elementProperties :: [Property]}
  deriving stock (Eq, Show)

-- | The values of one item, by its properties.
type Row = [[Number]]

-- | Reads the polyhedron of a PLY file: the properties @x@, @y@ and @z@ of its vertices, and the
-- list @vertex_indices@ (or @vertex_index@) of its faces and triangle strips. Everything else is
-- ignored.
readPly :: ObjectName -> ByteString -> Either SolidFileError Contents
readPly name bytes = do
  (coding, elements, body) <- header bytes
  vertex <- there "the element vertex" (find ((== "vertex") . elementName) elements)
  let shapes = filter ((`elem` ["face", "tristrips"]) . elementName) elements
  when (null shapes) (Left (SolidFileError (AtLine 1) (Needed "the element face or tristrips")))
  axes <-
    traverse
      ( \axis ->
          there
            ("the property " ++ Char8.unpack axis ++ " of vertices")
            (place [axis] vertex)
      )
      ["x", "y", "z"]
  lists <- traverse indices shapes
  let wanted = ("vertex", axes) : lists
  found <- (if coding == AsText then textRows else binaryRows coding) wanted elements body
  points <- V.fromList <$> traverse (point . snd) (concat (lookup "vertex" found))
  walks <- concat <$> traverse (walksOf (V.length points)) found
  let base = if coding == AsText then Decimal else Binary
      beside =
        [ Passed (shortName (elementName e) ++ "." ++ shortName (propertyName p))
          | e <- elements,
            (i, p) <- zip [0 ..] (elementProperties e),
            maybe True (i `notElem`) (lookup (elementName e) wanted)
        ]
  Right (contents name base beside points (V.fromList walks))
  where
    there what = maybe (Left (SolidFileError (AtLine 1) (Needed what))) Right
    place names element =
      fmap
        fst
        ( find
            ((`elem` names) . propertyName . snd)
            (zip [0 :: Int ..] (elementProperties element))
        )
    point row = case row of
      [[x], [y], [z]] -> Right (x, y, z)
      _ -> Left (SolidFileError (AtLine 1) (Needed "three coordinates, which are no lists"))
    indices shape =
      (,) (elementName shape) . (: [])
        <$> there
          ("the list vertex_indices of " ++ shortName (elementName shape))
          (place ["vertex_indices", "vertex_index"] shape)
    walksOf count (element, rows) = case element of
      "face" -> traverse (\(at, row) -> U.fromList <$> traverse (index count at) (concat row)) rows
      "tristrips" ->
        concat
          <$> traverse
            (\(at, row) -> concatMap stripped <$> traverse (traverse (index count at)) (runs row))
            rows
      _ -> Right []
    -- In one list, -1 separates strips.
    runs row = case break (== Number (-1) 0) (concat row) of
      (run, _ : others) -> run : runs [others]
      (run, []) -> [run]
    index count at (Number n e)
      | e < 0 || e > 300 = Left (SolidFileError at NotNumber)
      | wanted < 0 || wanted >= toInteger count =
        Left (SolidFileError at (NoSuchVertex wanted count))
      | otherwise = Right (fromInteger wanted)
      where
        -- A number in text has an exponent of 10; an integer in bytes has the exponent 0.
        wanted = n * 10 ^ e

-- | The triangles of a strip: each corner with the two before it. Every other triangle is
-- reversed, so that all have the same orientation. Triangles with a repeated corner are dropped.
--
-- >>> map U.toList (stripped [0, 3, 1, 2])
-- [[0,3,1],[1,3,2]]
stripped :: [Int] -> [Walk]
stripped corners =
  [ U.fromList (if turned then [b, a, c] else [a, b, c])
    | (turned, a, b, c) <-
        zip4 (cycle [False, True]) corners (drop 1 corners) (drop 2 corners),
      a /= b && b /= c && a /= c
  ]

-- | Reads the header: the encoding, the elements, and the rest of the file with the number of
-- lines (text) or bytes before it.
header :: ByteString -> Either SolidFileError (Coding, [Element], (Int, ByteString))
header bytes
  | Just encoding <- otherEncoding bytes =
    Left (SolidFileError (AtLine 1) (FileInEncoding encoding))
  | Just (["ply"], next) <- lineOf (Bytes.length bytes - Bytes.length text) =
    go 2 next Nothing []
  | otherwise = Left (SolidFileError (AtLine 1) (Needed "the word ply"))
  where
    text = withoutMark bytes
    -- If the header's first line ends with CR alone, all its lines do; a binary body may begin with
    -- a byte that looks like LF.
    lineEnd = case Char8.uncons (Char8.dropWhile (`Char8.notElem` "\r\n") text) of
      Just ('\r', rest) | not ("\n" `Bytes.isPrefixOf` rest) -> '\r'
      _ -> '\n'
    lineOf :: Int -> Maybe ([ByteString], Int)
    lineOf from
      | from >= Bytes.length bytes = Nothing
      | otherwise =
        let line = Char8.takeWhile (/= lineEnd) (Bytes.drop from bytes)
         in Just (Char8.words line, from + Bytes.length line + 1)
    go ::
      Int ->
      Int ->
      Maybe Coding ->
      [Element] ->
      Either SolidFileError (Coding, [Element], (Int, ByteString))
    go at from coding elements = case lineOf from of
      Nothing -> Left (SolidFileError (AtLine at) (Ends "end_header"))
      Just (given, next) -> case given of
        ["end_header"] -> case coding of
          Just known ->
            Right
              ( known,
                reverse elements,
                if known == AsText
                  then (at, lineFeeds (Bytes.drop next bytes))
                  else (next, Bytes.drop next bytes)
              )
          Nothing -> wrong "the format"
        ["format", kind, _]
          | Just known <- lookup kind codings -> go (at + 1) next (Just known) elements
        ["element", name, count]
          | Right n <- whole count, n >= 0 -> go (at + 1) next coding (Element name n [] : elements)
        ["property", "list", length', kind, name]
          | Just (Integral s l) <- lookup length' types,
            Just t <- lookup kind types,
            e : others <- elements ->
            go (at + 1) next coding (with e (Property name (Just (Integral s l)) t) : others)
        ["property", kind, name]
          | Just t <- lookup kind types,
            e : others <- elements ->
            go (at + 1) next coding (with e (Property name Nothing t) : others)
        word : _ | word `elem` ["comment", "obj_info"] -> go (at + 1) next coding elements
        [] -> go (at + 1) next coding elements
        _ -> wrong "a line of a PLY header"
      where
        wrong = Left . SolidFileError (AtLine at) . Needed
    with e p = e {elementProperties = elementProperties e ++ [p]}
    codings =
      [ ("ascii", AsText),
        ("binary_little_endian", LittleEndian),
        ("binary_big_endian", BigEndian)
      ]
    types =
      [ (name, kind)
        | (names, kind) <-
            [ (["char", "int8"], Integral True 1),
              (["uchar", "uint8"], Integral False 1),
              (["short", "int16"], Integral True 2),
              (["ushort", "uint16"], Integral False 2),
              (["int", "int32"], Integral True 4),
              (["uint", "uint32"], Integral False 4),
              (["float", "float32"], Floating 4),
              (["double", "float64"], Floating 8)
            ],
          name <- names
      ]

-- | The wanted properties of the wanted elements, row by row, each row with its place.
type Rows = [(ByteString, [(Place, Row)])]

textRows ::
  [(ByteString, [Int])] ->
  [Element] ->
  (Int, ByteString) ->
  Either SolidFileError Rows
textRows wanted elements (before, body) =
  go
    elements
    ( filter
        (not . null . lineWords)
        (zipWith Line [before + 1 ..] (map Char8.words (Char8.split '\n' body)))
    )
  where
    go [] _ = Right []
    go (e : others) given = do
      (rows, left) <- rowsOf e (elementCount e) given
      ((elementName e, rows) :) <$> go others left
    rowsOf e count = taking count []
      where
        taking 0 found left = Right (reverse found, left)
        taking n found (line : left) = do
          values <- atLine line (row (elementProperties e) (lineWords line))
          let kept = keep wanted e values
          length (concat kept)
            `seq` taking
              (n - 1 :: Int)
              ((AtLine (lineNumber line), kept) : found)
              left
        taking n _ [] =
          Left (SolidFileError (AtLine (before + Char8.count '\n' body)) (missing n e))
    row [] _ = Right []
    row (p : others) given = case propertyLength p of
      Nothing -> do
        (values, left) <- take' 1 given
        (values :) <$> row others left
      Just _ -> do
        (sizes, left) <- take' 1 given
        size <- case sizes of
          [Number n e]
            | n >= 0,
              e >= 0,
              e < 10,
              n * 10 ^ e <= toInteger (length left) ->
              Right (fromInteger (n * 10 ^ e))
          _ -> Left (Needed "a list of as many values as it says")
        (values, left') <- take' size left
        (values :) <$> row others left'
    take' n given = do
      let own = take n given
      unless (length own == n) (Left (Needed "a value for each property"))
      values <- traverse decimal own
      Right (values, drop n given)

-- | The wanted ones of an element's values.
keep :: [(ByteString, [Int])] -> Element -> [a] -> [a]
keep wanted e values = maybe [] (map (values !!)) (lookup (elementName e) wanted)

-- | The fault that the given number of an element's rows is missing.
missing :: Int -> Element -> Fault
missing n e =
  Ends (show n ++ " of " ++ show (elementCount e) ++ " rows of " ++ shortName (elementName e))

-- | A name in the file, shortened for a message.
shortName :: ByteString -> String
shortName = Char8.unpack . Bytes.take 40

binaryRows ::
  Coding ->
  [(ByteString, [Int])] ->
  [Element] ->
  (Int, ByteString) ->
  Either SolidFileError Rows
binaryRows coding wanted elements (before, body) = go elements 0
  where
    go [] _ = Right []
    go (e : others) from = do
      (rows, next) <- rowsOf e (if null (elementProperties e) then 0 else elementCount e) from
      ((elementName e, rows) :) <$> go others next
    rowsOf e count = taking count []
      where
        taking :: Int -> [(Place, Row)] -> Int -> Either SolidFileError ([(Place, Row)], Int)
        taking 0 found from = Right (reverse found, from)
        taking n found from =
          case runGetOrFail
            (traverse property (elementProperties e))
            (Lazy.fromStrict (Bytes.drop from body)) of
            Left _ ->
              Left (SolidFileError at (missing n e))
            Right (_, used, values) -> do
              kept <-
                traverse
                  (traverse (either (Left . SolidFileError at) Right))
                  (keep wanted e values)
              length (concat kept)
                `seq` taking
                  (n - 1)
                  ((at, kept) : found)
                  (from + fromIntegral used)
          where
            at = AtByte (before + from)
    property p = case propertyLength p of
      Nothing -> (: []) <$> value (propertyType p)
      Just kind -> do
        size <- value kind
        case size of
          Right (Number n 0) | n >= 0 -> list (fromInteger n) (propertyType p)
          _ -> fail "a negative length"
    -- A list never gets more memory than the bytes that are there.
    list n kind = do
      start <- bytesRead
      let needed = toInteger n * toInteger (sizeOf kind)
      if toInteger start + needed > toInteger (Bytes.length body)
        then fail "beyond the end"
        else replicateM n (value kind)
    sizeOf kind = case kind of
      Integral _ n -> n
      Floating n -> n
    value :: Type -> Get (Either Fault Number)
    value kind = case kind of
      Integral True 1 -> whole' <$> getInt8
      Integral False 1 -> whole' <$> getWord8
      Integral True 2 -> whole' <$> (if big then getInt16be else getInt16le)
      Integral False 2 -> whole' <$> (if big then getWord16be else getWord16le)
      Integral True _ -> whole' <$> (if big then getInt32be else getInt32le)
      Integral False _ -> whole' <$> (if big then getWord32be else getWord32le)
      Floating 4 -> machine <$> (if big then getFloatbe else getFloatle)
      Floating _ -> machine <$> (if big then getDoublebe else getDoublele)
    big = coding == BigEndian
    whole' :: Integral a => a -> Either Fault Number
    whole' n = Right (Number (toInteger n) 0)

headerOf :: String -> String -> Mesh -> Builder.Builder
headerOf coding kind it =
  foldMap
    (\line -> Builder.string7 line <> "\n")
    [ "ply",
      "format " ++ coding ++ " 1.0",
      "element vertex " ++ show (V.length (meshPoints it)),
      "property " ++ kind ++ " x",
      "property " ++ kind ++ " y",
      "property " ++ kind ++ " z",
      "element face " ++ show (V.length (meshWalks it)),
      "property list uint int vertex_indices",
      "end_header"
    ]

-- | A polyhedron as a text PLY file. Coordinates are decimal numbers, exact if possible.
writePlyText :: Mesh -> Written Builder.Builder
writePlyText it = texts {writtenBytes = headerOf "ascii" "double" it <> vertices <> faces}
  where
    texts = asDecimals it
    vertices = foldMap textLine (writtenBytes texts)
    faces = foldMap (\walk -> textLine (map show (U.length walk : U.toList walk))) (meshWalks it)

-- | A polyhedron as a little-endian PLY file. Coordinates are the nearest double-precision
-- numbers.
writePlyBinary :: Mesh -> Written Builder.Builder
writePlyBinary it =
  numbers' {writtenBytes = headerOf "binary_little_endian" "double" it <> vertices <> faces}
  where
    numbers' = asMachine it
    vertices = foldMap (foldMap Builder.doubleLE) (writtenBytes numbers')
    faces = foldMap face (meshWalks it)
    face walk =
      Builder.word32LE (fromIntegral (U.length walk))
        <> foldMap (Builder.int32LE . fromIntegral) (U.toList walk)
