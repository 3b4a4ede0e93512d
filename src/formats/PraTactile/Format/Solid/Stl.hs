{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The stereolithography files of 3D Systems (1988), text or binary: triangles with their
-- normals. A binary file has 80 bytes without meaning, a count, and 50 bytes per triangle. A file
-- is binary if the count fits its length. The word @solid@ at the beginning is no evidence for
-- text, because some programs begin binary files with it.
module PraTactile.Format.Solid.Stl
  ( readStl,
    writeStlText,
    writeStlBinary,
    allTriangles,
  )
where

import Control.Monad (replicateM)
import Data.Binary.Get
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isSpace, toLower)
import Data.Ratio ((%))
import qualified Data.Vector as V
import GHC.Float (float2Double)
import PraTactile.Format.Solid.Contents
import PraTactile.Format.Solid.Error
import PraTactile.Format.Solid.Number
import PraTactile.Format.Solid.Text
import PraTactile.Object.Description (ObjectName, objectText)
import PraTactile.Object.Mesh
import PraTactile.Object.Triangles
import PraTactile.Object.Vector
import PraTactile.PlainText (otherEncoding, withoutMark)

-- | Reads the polyhedron of a text or binary STL file; the first argument becomes its name. Normals
-- and attributes are ignored. Refuses, with the place, a text without the word @solid@ and what is
-- not a triangle. Refuses a file that is cut off or whose length does not fit the count, and other
-- encodings.
readStl :: ObjectName -> ByteString -> Either SolidFileError Contents
readStl name bytes
  | Just count <- counted,
    binarySize count == toInteger (Bytes.length bytes) =
    binary name count bytes
  | "solid" `Bytes.isPrefixOf` Char8.map toLower (Char8.dropWhile (<= ' ') begin),
    Bytes.notElem 0 begin =
    plain bytes >>= text name
  | Just encoding <- otherEncoding bytes =
    Left (SolidFileError (AtLine 1) (FileInEncoding encoding))
  | Just _ <- counted,
    Char8.all (\c -> isSpace c || c >= ' ' && c <= '~') begin =
    Left (SolidFileError (AtLine 1) (Needed "the word solid"))
  | Just count <- counted =
    Left (SolidFileError (AtByte 80) (LengthDiffers (binarySize count) (Bytes.length bytes)))
  | otherwise =
    Left
      ( SolidFileError
          (AtByte (Bytes.length bytes))
          (Ends "84 bytes of a binary file")
      )
  where
    -- Text contains no zero byte; nearly all binary files have one this early.
    begin = Bytes.take 1000 (withoutMark bytes)
    counted =
      either
        (const Nothing)
        (\(_, _, n) -> Just n)
        (runGetOrFail count' (Lazy.fromStrict bytes))
    count' = skip 80 *> getWord32le
    binarySize count = 84 + 50 * toInteger count

-- | Reads a binary file with this name and this count of triangles.
binary :: Integral n => ObjectName -> n -> ByteString -> Either SolidFileError Contents
binary name count bytes = do
  corners <- V.fromList . concat <$> traverse triangle [0 .. fromIntegral count - 1]
  let attached =
        or
          [ Bytes.index bytes (at f + 48 + k) /= 0
            | f <-
                [0 .. fromIntegral count - 1],
              k <- [0, 1]
          ]
  Right
    ( soup
        name
        Binary
        ([Passed "attributes of triangles" | attached] ++ [Passed "normals" | count > 0])
        corners
    )
  where
    at :: Int -> Int
    at f = 84 + 50 * f
    triangle f =
      case runGetOrFail
        (replicateM 9 getFloatle)
        (Lazy.fromStrict (Bytes.take 36 (Bytes.drop (at f + 12) bytes))) of
        Right (_, _, values) -> triples <$> traverse (number f) (zip [0 ..] values)
        Left _ -> Left (SolidFileError (AtByte (at f)) (Ends "a triangle"))
    number f (k, value) =
      either (Left . SolidFileError (AtByte (at f + 12 + 4 * k))) Right (machine value)
    triples values = case values of
      a : b : c : others -> (a, b, c) : triples others
      _ -> []

-- | Reads a text file with this name.
text :: ObjectName -> ByteString -> Either SolidFileError Contents
text name bytes =
  outside
    False
    []
    (concatMap wordsOf (zipWith Line [1 ..] (map Char8.words (Char8.split '\n' bytes))))
  where
    end = Left . SolidFileError (AtLine (length (Char8.split '\n' bytes)))
    -- The words after solid and endsolid on their lines are a name. Some programs write "end
    -- solid".
    wordsOf (Line at given) = map ((,) at) $ case given of
      word : next : others
        | lower word == "end",
          lower next `elem` ["solid", "facet", "loop"] ->
          withoutName ((word <> next) : others)
      _ -> withoutName given
    withoutName given = case given of
      word : _ | lower word `elem` ["solid", "endsolid"] -> [word]
      _ -> given
    lower = Char8.map toLower
    -- @begun@: inside a solid. A file that ends inside one was cut off.
    outside begun found given = case given of
      [] | begun -> end (Ends "endsolid")
      [] ->
        Right
          ( soup
              name
              Decimal
              [Passed "normals" | not (null found)]
              (V.fromList (reverse found))
          )
      (_, word) : others
        | lower word `elem` ["solid", "endsolid"] ->
          outside (lower word == "solid") found others
      (at, word) : others
        | lower word == "facet" -> facet found at others
        | otherwise -> fault at (Needed "facet or endsolid")
    fault at why = Left (SolidFileError (AtLine at) why)
    facet found at given = do
      others <- keywords ["normal"] given >>= dropNumbers at >>= keywords ["outer", "loop"]
      (a, others') <- vertex others
      (b, others'') <- vertex others'
      (c, others''') <- vertex others''
      rest <- keywords ["endloop", "endfacet"] others'''
      a `seq` b `seq` c `seq` outside True (c : b : a : found) rest
    keywords wanted given = case (wanted, given) of
      ([], _) -> Right given
      (word : more, (at, there) : others)
        | lower there == word -> keywords more others
        | otherwise -> fault at (Needed (Char8.unpack word))
      (word : _, []) -> end (Ends (Char8.unpack word))
    -- A normal need not be a number: some programs write nan for a sliver's.
    dropNumbers at given = case splitAt 3 given of
      ([_, _, _], others) -> Right others
      _ -> fault at (Needed "a normal of three numbers")
    vertex given = do
      others <- keywords ["vertex"] given
      case others of
        (at, x) : (_, y) : (_, z) : rest ->
          either
            (fault at)
            (\point -> Right (point, rest))
            ((,,) <$> decimal x <*> decimal y <*> decimal z)
        _ -> end (Ends "three coordinates")

-- | The triangles of all faces, each by the numbers of its vertices.
allTriangles :: Mesh -> [[Int]]
allTriangles it = [[i, j, k] | walk <- V.toList (meshWalks it), (i, j, k) <- triangles it walk]

-- | A polyhedron as a binary STL file. Coordinates are the nearest single-precision numbers.
writeStlBinary :: Mesh -> Written Builder.Builder
writeStlBinary it = numbers' {writtenBytes = header <> foldMap triangle faces}
  where
    numbers' = asMachine it
    faces = allTriangles it
    header =
      Builder.byteString (Bytes.take 80 (Char8.pack (take 80 ascii) <> Bytes.replicate 80 32))
        <> Builder.word32LE (fromIntegral (length faces))
    ascii =
      "binary STL of "
        ++ map (\c -> if c >= ' ' && c <= '~' then c else '?') (take 60 (objectText (meshName it)))
    triangle corners =
      foldMap Builder.floatLE (normalOf it corners)
        <> foldMap (foldMap Builder.floatLE . (writtenBytes numbers' V.!)) corners
        <> Builder.word16LE 0

-- | A polyhedron as a text STL file. Coordinates are decimal numbers, exact if possible.
writeStlText :: Mesh -> Written Builder.Builder
writeStlText it =
  texts {writtenBytes = textLine ["solid"] <> facets <> textLine ["endsolid"]}
  where
    facets = foldMap triangle (allTriangles it)
    texts = asDecimals it
    triangle corners =
      textLine ("facet normal" : map (show . float2Double) (normalOf it corners))
        <> textLine ["outer loop"]
        <> foldMap (\v -> textLine ("vertex" : writtenBytes texts V.! v)) corners
        <> textLine ["endloop"]
        <> textLine ["endfacet"]

-- | The unit normal of a triangle; zeros if it has no area.
normalOf :: Mesh -> [Int] -> [Float]
normalOf it corners = case map (meshPoints it V.!) corners of
  [a, b, c]
    | n /= zero -> map part [x, y, z]
    where
      n@(V3 x y z) = cross (b `minus` a) (c `minus` a)
      part u = fromRational (toRational (signum u) * toRational (squareRoot (u * u % dot n n)))
  _ -> [0, 0, 0]
