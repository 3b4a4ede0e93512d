{-# LANGUAGE OverloadedStrings #-}

-- | Tests files of polyhedra: written files are read unchanged, files of other programs are read as
-- the known solids, and other files are refused with the place.
module Test.Solid.FilesOfSolids (spec) where

import Control.Monad (forM_, when)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (transpose)
import qualified Data.Vector as V
import PraTactile.Conformance.Laws.Solids
import PraTactile.Format.Solid
import PraTactile.Object.Description
import PraTactile.Object.Merge
import PraTactile.Object.Mesh
import PraTactile.Object.Named
import PraTactile.Object.Validity
import System.FilePath ((</>))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "what is written is read again" $ do
    prop "as JSON, with the names, for any description" $
      forAllBlind solids $ \drawn ->
        back Json (fromDescription drawn) === Right (fromDescription drawn)
    forM_ [Off, Obj, PlyText] $ \format ->
      prop ("as " ++ formatName format ++ ", exactly, if coordinates are decimal numbers") $
        forAllBlind (moved decimal <$> solids) $ \drawn ->
          back format (fromDescription drawn) === Right (nameless (fromDescription drawn))
    prop "as ply, exactly, if coordinates are machine numbers" $
      forAllBlind (moved dyadic <$> solids) $ \drawn ->
        back Ply (fromDescription drawn) === Right (nameless (fromDescription drawn))
    forM_ [Stl, StlText] $ \format ->
      it ("as " ++ formatName format ++ ", whose triangles merge into the faces again") $
        forM_ [Cube, Box 3 4 5, Pyramid 3 4 5, Octahedron 3, LShape 4 2 4] $ \solid ->
          fmap (shapeOf . mergeCoplanar) (back format (fromDescription (namedDescription solid)))
            `shouldBe` Right (shapeOf (fromDescription (namedDescription solid)))
    it "single precision counts its rounded numbers: 101.6 mm is 101.5999984741211" $ do
      let it_ = fromDescription (namedDescription (Box 101.6 2 2))
          written = writeSolid Stl it_
      writtenRounded written `shouldBe` 4
      fmap
        (maximum . map (\(_, Point x _ _) -> x) . describedVertices . toDescription)
        (back Stl it_)
        `shouldBe` Right 101.59999847412109375
  describe "a file of trimesh" $ do
    forM_ ["cube-binary.stl", "cube-ascii.stl", "cube.off", "cube.obj", "cube.ply"] $ \file ->
      it ("of a cube of 127 mm is six squares: " ++ file) $ do
        it_ <- theirs file
        let merged = examine (mergeCoplanar it_)
        (reportVertices merged, reportEdges merged, reportFaces merged) `shouldBe` (8, 12, 6)
        map componentVolume (reportComponents merged) `shouldBe` [Just 2048383]
        reportDefects merged `shouldBe` []
    it "of a ring is a solid of genus 1, of 192 triangles" $ do
      it_ <- theirs "annulus.stl"
      let report = examine it_
      (reportFaces report, map componentGenus (reportComponents report)) `shouldBe` (192, [Just 1])
      reportDefects report `shouldBe` []
  describe "a file of OpenSCAD" $
    forM_ ["bracket.stl", "bracket.off"] $ \file ->
      it ("of a bracket with a square hole is one piece of genus 1: " ++ file) $ do
        it_ <- theirs file
        forM_ [(it_, 40), (mergeCoplanar it_, 12)] $ \(one, faces) -> do
          let report = examine one
          reportDefects report `shouldBe` []
          reportFaces report `shouldBe` faces
          [(componentGenus c, componentVolume c) | c <- reportComponents report]
            `shouldBe` [(Just 1, Just (120 * 60 * 10 + 10 * 60 * 70 - 30 * 20 * 10))]
  describe "indices, ends and numbers" $ do
    it "OBJ: negative and slashed indices, and lines that continue after a backslash, are read" $
      facesOf
        Obj
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n\
        \f -4/1/1 -2//3 \\\n -3\nf 1 2 4 # and so on\n"
        `shouldBe` Right [["V1", "V3", "V2"], ["V1", "V2", "V4"]]
    it "OFF: comments, colours, and counts on the first line are read" $
      facesOf Off "OFF 3 1 0 # of three\n\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n"
        `shouldBe` Right [["V1", "V2", "V3"]]
    it "OFF: counts that follow the word OFF without a space, as in ModelNet, are read" $
      forM_ ["OFF", "OFF ", "COFF"] $ \word ->
        facesOf Off (word <> "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
          `shouldBe` Right [["V1", "V2", "V3"]]
    it "STL: end solid, end facet and end loop are read as endsolid, endfacet and endloop" $ do
      let file end =
            "solid a b\nfacet normal 0 0 1\nouter loop\n"
              <> "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
              <> end "loop"
              <> end "facet"
              <> end "solid"
      facesOf Stl (file (\word -> "End " <> word <> "\n"))
        `shouldBe` facesOf Stl (file (\word -> "end" <> word <> "\n"))
      facesOf Stl (file (\word -> "end" <> word <> "\n")) `shouldBe` Right [["V1", "V2", "V3"]]
    it "STL: a binary header may begin like a byte order mark" $ do
      bytes <- Bytes.readFile (folder </> "cube-binary.stl")
      readSolid Stl "x" ("\xEF\xBB\xBFsolid" <> Bytes.drop 8 bytes)
        `shouldBe` readSolid Stl "x" bytes
    it "STL: a binary file that begins with the word solid is binary" $ do
      it_ <- theirs "cube-binary.stl"
      bytes <- Bytes.readFile (folder </> "cube-binary.stl")
      fmap contentsMesh (readSolid Stl (ObjectName "cube-binary") ("solid" <> Bytes.drop 5 bytes))
        `shouldBe` Right it_
    it "PLY: other elements and properties are skipped, in either order of bytes" $ do
      let header order =
            "ply\nformat " <> order <> " 1.0\ncomment x\nelement vertex 3\nproperty float x\n"
              <> "property uchar red\nproperty float y\nproperty float z\nelement thing 1\n"
              <> "property list uchar short w\nelement face 1\n"
              <> "property list uchar int vertex_index\nend_header\n"
          body short float int =
            Builder.toLazyByteString $
              foldMap
                (\(x, y, z) -> float x <> Builder.word8 7 <> float y <> float z)
                [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
                <> Builder.word8 2
                <> short 1
                <> short 2
                <> Builder.word8 3
                <> foldMap int [0, 1, 2]
          little = Lazy.toStrict (body Builder.int16LE Builder.floatLE Builder.int32LE)
          big = Lazy.toStrict (body Builder.int16BE Builder.floatBE Builder.int32BE)
      facesOf Ply (header "binary_little_endian" <> little) `shouldBe` Right [["V1", "V2", "V3"]]
      facesOf Ply (header "binary_big_endian" <> big) `shouldBe` Right [["V1", "V2", "V3"]]
      fmap contentsPassed (readSolid Ply (ObjectName "x") (header "binary_big_endian" <> big))
        `shouldBe` Right [Passed "vertex.red", Passed "thing.w"]
    it "PLY: a strip has a triangle for each corner from the third, all seen from one side" $ do
      let file element list =
            "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n\
            \property float z\nelement "
              <> element
              <> " 1\nproperty list int int vertex_indices\nend_header\n\
                 \0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n"
              <> list
              <> "\n"
      -- All in the plane z = 0, and all clockwise seen from above.
      facesOf Ply (file "tristrips" "5 0 1 2 3 4")
        `shouldBe` Right [["V1", "V2", "V3"], ["V3", "V2", "V4"], ["V3", "V4", "V5"]]
      facesOf Ply (file "tristrips" "9 0 1 2 -1 2 1 3 -1 4")
        `shouldBe` Right [["V1", "V2", "V3"], ["V3", "V2", "V4"]]
      -- A repeated corner makes no triangle, but counts in the alternation of sides.
      facesOf Ply (file "tristrips" "6 0 1 2 2 3 4")
        `shouldBe` Right [["V1", "V2", "V3"], ["V4", "V3", "V5"]]
      facesOf Ply (file "tristrips" "4 0 1 5 3")
        `shouldBe` Left (SolidFileError (AtLine 15) (NoSuchVertex 5 5))
      facesOf Ply (file "face" "3 0 1 -1")
        `shouldBe` Left (SolidFileError (AtLine 15) (NoSuchVertex (-1) 5))
      facesOf Ply (file "edge" "2 0 1")
        `shouldBe` Left (SolidFileError (AtLine 1) (Needed "the element face or tristrips"))
    it "PLY: a header may end its lines with CR or CR LF, before bytes that look like line ends" $
      forM_ ["\n", "\r\n", "\r"] $ \end -> do
        -- The first coordinate begins with the byte of LF, the second with a byte order mark.
        let header =
              Bytes.concat
                [ line <> end
                  | line <-
                      [ "ply",
                        "format binary_little_endian 1.0",
                        "element vertex 1",
                        "property int x",
                        "property int y",
                        "property int z",
                        "element face 0",
                        "property list uchar int vertex_indices",
                        "end_header"
                      ]
                ]
        fmap
          (map snd . describedVertices . toDescription . contentsMesh)
          (readSolid Ply "x" (header <> "\n\0\0\0\xEF\xBB\xBF\0\r\n\0\0"))
          `shouldBe` Right [Point 10 0xBFBBEF 0x0A0D]
    it "PLY: integers of each type are the same in bytes as in words, up to both limits" $
      forM_ integerTypes $ \(kind, size, least, largest) ->
        forM_ [least, -1, 1, largest `div` 2 + 1, largest] $ \n -> do
          let header coding =
                "ply\nformat " <> coding <> " 1.0\nelement vertex 3\nproperty " <> kind
                  <> " x\nproperty uchar y\nproperty uchar z\nelement face 1\n"
                  <> "property list uchar uchar vertex_index\nend_header\n"
              meshOf = fmap contentsMesh . readSolid Ply (ObjectName "x")
              words' = Char8.unlines [Char8.pack (show n) <> " 0 0", "0 1 0", "0 0 1", "3 0 1 2"]
              little = [fromInteger (n `div` 256 ^ k `mod` 256) | k <- [0 .. size - 1]]
              body number = Bytes.pack (number <> [0, 0] <> nought <> [1, 0] <> nought <> [0, 1])
              nought = replicate size 0
              file number = body number <> Bytes.pack [3, 0, 1, 2]
          when (n >= least) $
            forM_ [("binary_little_endian", little), ("binary_big_endian", reverse little)] $
              \(coding, number) ->
                (kind, n, meshOf (header coding <> file number))
                  `shouldBe` (kind, n, meshOf (header "ascii" <> words'))
    it "STL: attributes in either of their two bytes are reported" $ do
      bytes <- Bytes.readFile (folder </> "cube-binary.stl")
      forM_ [[0, 0], [1, 0], [0, 1]] $ \pair -> do
        let changed = Bytes.take 132 bytes <> Bytes.pack pair <> Bytes.drop 134 bytes
            told = contentsPassed <$> readSolid Stl (ObjectName "x") changed
        (pair, elem (Passed "attributes of triangles") <$> told)
          `shouldBe` (pair, Right (pair /= [0, 0]))
    it "JSON: names and exact fractions are read" $
      fmap
        (describedVertices . toDescription . contentsMesh)
        ( readSolid
            Json
            (ObjectName "x")
            "{\"schema\":\"pra-tactile/object/1\",\"name\":\"a\",\"vertices\":[{\"name\":\"A\",\
            \\"at\":[\"127/4\",\"31.75\",\"0\"]}],\"faces\":[]}"
        )
        `shouldBe` Right [(VertexName "A", Point (127 / 4) (127 / 4) 0)]
    it "equal points become one vertex in every format: a box, each face with its own vertices" $ do
      let Description _ points faces = namedDescription (Box 130 163 101.6)
          corners =
            [ (round (x * 10), round (y * 10), round (z * 10))
              | FaceName walk <- faces,
                Just (Point x y z) <- map (`lookup` points) walk
            ]
          text (x, y, z) = Char8.pack (unwords [show n ++ "e-1" | n <- [x, y, z :: Int]]) <> "\n"
          faceTexts from =
            [ Char8.pack (unwords (map show [from + 4 * f .. from + 4 * f + 3]))
              | f <- [0 .. 5 :: Int]
            ]
          vertices prefix = foldMap ((prefix <>) . text) corners
          whole (format, bytes) = examine . contentsMesh <$> readSolid format "x" bytes
      forM_
        [ (Obj, vertices "v " <> foldMap (\f -> "f " <> f <> "\n") (faceTexts 1)),
          (Off, "OFF\n24 6 0\n" <> vertices "" <> foldMap (\f -> "4 " <> f <> "\n") (faceTexts 0)),
          ( Ply,
            "ply\nformat ascii 1.0\nelement vertex 24\nproperty float x\nproperty float y\n\
            \property float z\nelement face 6\nproperty list uchar int vertex_index\nend_header\n"
              <> vertices ""
              <> foldMap (\f -> "4 " <> f <> "\n") (faceTexts 0)
          )
        ]
        $ \file -> do
          fmap reportDefects (whole file) `shouldBe` Right []
          fmap reportVertices (whole file) `shouldBe` Right 8
          fmap (map componentVolume . reportComponents) (whole file)
            `shouldBe` Right [Just (130 * 163 * 101.6)]
      -- A vertex keeps the number that the file gives it.
      facesOf Obj "v 0 0 0\nv 1 0 0\nv 1e0 0 0\nv 0 1 0\nf 1 3 4\n"
        `shouldBe` Right [["V1", "V2", "V4"]]
    it "OBJ: numbers below 10^300, of up to 400 decimal places and 1000 characters, are read" $
      forM_
        [ ("-999e297", -999 * 10 ^ (297 :: Int)),
          ("10.1e-399", 101 / 10 ^ (400 :: Int)),
          (Char8.replicate 999 '0' <> "7", 7)
        ]
        $ \(text, number) ->
          fmap
            (map snd . describedVertices . toDescription . contentsMesh)
            (readSolid Obj (ObjectName "x") ("v 0 0 " <> text <> "\n"))
            `shouldBe` Right [Point 0 0 number]
  describe "a malformed file is refused at its first fault" $
    forM_ refusals $ \(what, format, bytes, fault) ->
      it (formatName format ++ ": " ++ what) $
        fmap contentsMesh (readSolid format (ObjectName "x") bytes) `shouldBe` Left fault
  prop "OBJ: a fault names the line where it begins, after any lines and over any continuation" $
    forAll (elements [(file, n, why) | (_, Obj, file, SolidFileError (AtLine n) why) <- brief]) $
      \(bytes, n, why) ->
        forAll (resize 4 (listOf (elements ["", "# \\", "g one", "g one \\\nand another"]))) $
          \above ->
            forAll (vectorOf 9 (elements [" ", "\t", "  \\\n", "\\\n \\\n"])) $ \gaps ->
              let (good, others) = splitAt (n - 1) (Char8.lines bytes)
                  spread line = Bytes.concat (concat (transpose [Char8.words line, tail' line]))
                  tail' line = take (length (Char8.words line) - 1) gaps
                  file = Char8.unlines (above ++ good ++ map spread others)
                  at = n + Char8.count '\n' (Char8.unlines above)
               in fmap contentsMesh (readSolid Obj (ObjectName "x") file)
                    === Left (SolidFileError (AtLine at) why)
  where
    brief = filter (\(_, _, file, _) -> Bytes.length file < 99) refusals

refusals :: [(String, SolidFormat, ByteString, SolidFileError)]
refusals =
  [ ( "a count of 10^9",
      Off,
      "OFF\n1000000000 1 0\n0 0 0\n",
      at 4 (Ends "999999999 of its 1000000000 vertices")
    ),
    ("an index beyond the end", Off, "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", at 4 (NoSuchVertex 1 1)),
    ("an index beyond the end", Obj, "v 0 0 0\nf 1 1 2\n", at 2 (NoSuchVertex 2 1)),
    ("an index before the beginning", Obj, "v 0 0 0\nf 1 1 -2\n", at 2 (NoSuchVertex (-2) 1)),
    ("the index 0", Obj, "v 0 0 0\nf 0 1 1\n", at 2 (NoSuchVertex 0 1)),
    ("NaN", Obj, "v 0 nan 0\n", at 1 NotFinite),
    ("1e999999999", Obj, "v 0 0 1e999999999\n", at 1 TooLargeOrFine),
    ("1e-999999999", Obj, "v 0 0 1e-999999999\n", at 1 TooLargeOrFine),
    ("10^300", Obj, "v 0 0 1e300\n", at 1 TooLargeOrFine),
    ("-10^300", Obj, "v 0 0 -0.01e302\n", at 1 TooLargeOrFine),
    ("401 decimal places", Obj, "v 0 0 10.1e-400\n", at 1 TooLargeOrFine),
    ( "a number of 1001 characters",
      Obj,
      "v 0 0 " <> Char8.replicate 1000 '0' <> "7\n",
      at 1 TooLargeOrFine
    ),
    ( "a number of a megabyte",
      Obj,
      "v 0 0 "
        <> Char8.replicate 1000000 '9'
        <> "\n",
      at 1 TooLargeOrFine
    ),
    ( "a text of another format",
      Obj,
      "OFF\n1 0 0\n0 0 0\n",
      at 4 (Ends "its first vertex, a line v X Y Z")
    ),
    ("a text of another format", Off, "v 0 0 0\n", at 1 (Needed "the word OFF")),
    ("a longer word that begins with OFF", Off, "OFFER 1 0 0\n", at 1 (Needed "the word OFF")),
    ("a text of another format", Ply, "v 0 0 0\n", at 1 (Needed "the word ply")),
    ( "a text of another format",
      Stl,
      Char8.concat (replicate 20 "v 0 0 0\n"),
      at 1 (Needed "the word solid")
    ),
    ("no number", Off, "OFF\n1 0 0\n0 0 x\n", at 3 NotNumber),
    ("a triangle too few", Stl, binary 2 1, SolidFileError (AtByte 80) (LengthDiffers 184 134)),
    ( "a count of 4 * 10^9",
      Stl,
      binary maxBound 0,
      SolidFileError (AtByte 80) (LengthDiffers 214748364834 84)
    ),
    ( "less than a header",
      Stl,
      "abc",
      SolidFileError (AtByte 3) (Ends "84 bytes of a binary file")
    ),
    -- After the header and two triangles, the normal and five numbers: 84 + 2 * 50 + 12 + 5 * 4.
    ( "a NaN in the third triangle",
      Stl,
      Bytes.take 216 (binary 3 3) <> Bytes.pack [0, 0, 192, 127] <> Bytes.drop 220 (binary 3 3),
      SolidFileError (AtByte 216) NotFinite
    ),
    ( "text that ends early",
      Stl,
      "solid x\nfacet normal 0 0 1\nouter loop\n",
      at 4 (Ends "vertex")
    ),
    ( "text that ends after a facet",
      Stl,
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n\
      \endloop\nendfacet\n",
      at 9 (Ends "endsolid")
    ),
    ( "a binary file that begins with the word solid and was cut off",
      Stl,
      "solid" <> Bytes.drop 5 (binary 2 1),
      SolidFileError (AtByte 80) (LengthDiffers 184 134)
    ),
    ( "a list that is longer than the file",
      Ply,
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n\
      \property float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n\
      \\255\255\255\127",
      SolidFileError (AtByte 168) (Ends "1 of 1 rows of face")
    )
  ]
  where
    at n = SolidFileError (AtLine n)
    binary :: Word -> Int -> ByteString
    binary count there =
      Bytes.replicate 80 32
        <> Lazy.toStrict (Builder.toLazyByteString (Builder.word32LE (fromIntegral count)))
        <> Bytes.replicate (50 * there) 0

-- | The names of PLY's types of integers, with their bytes, their least and their largest values.
integerTypes :: [(ByteString, Int, Integer, Integer)]
integerTypes =
  [ (name, size, if signed then negate half else 0, if signed then half - 1 else 2 * half - 1)
    | (names, size, signed) <-
        [ (["char", "int8"], 1, True),
          (["uchar", "uint8"], 1, False),
          (["short", "int16"], 2, True),
          (["ushort", "uint16"], 2, False),
          (["int", "int32"], 4, True),
          (["uint", "uint32"], 4, False)
        ],
      name <- names,
      let half = 2 ^ (8 * size - 1)
  ]

folder :: FilePath
folder = "test" </> "data" </> "solids"

theirs :: FilePath -> IO Mesh
theirs file = do
  bytes <- Bytes.readFile (folder </> file)
  case formatOfFile file of
    Just format
      | Right found <- readSolid format (ObjectName (takeWhile (/= '.') file)) bytes ->
        pure (contentsMesh found)
    _ -> fail file

back :: SolidFormat -> Mesh -> Either SolidFileError Mesh
back format it_ =
  contentsMesh
    <$> readSolid
      format
      (meshName it_)
      (Lazy.toStrict (Builder.toLazyByteString (writtenBytes (writeSolid format it_))))

facesOf :: SolidFormat -> ByteString -> Either SolidFileError [[String]]
facesOf format bytes =
  map (map vertexText . faceVertices) . describedFaces . toDescription . contentsMesh
    <$> readSolid format (ObjectName "x") bytes

-- | The mesh with the names that unnamed vertices are given.
nameless :: Mesh -> Mesh
nameless it_ =
  withShape
    (unnamed (V.length (meshPoints it_)))
    (meshDenominator it_)
    (meshPoints it_)
    (meshWalks it_)
    it_

-- | Measures of a mesh that do not depend on the order of vertices and faces.
shapeOf :: Mesh -> (Int, Int, Int, [Maybe Rational])
shapeOf it_ =
  ( reportVertices report,
    reportEdges report,
    reportFaces report,
    map componentVolume (reportComponents report)
  )
  where
    report = examine it_

decimal, dyadic :: Point -> Point
decimal (Point x y z) = Point (near x) (near y) (near z)
  where
    near v = fromInteger (round (v * 1000)) / 1000
dyadic (Point x y z) = Point (near x) (near y) (near z)
  where
    near v = fromInteger (round (v * 1024)) / 1024
