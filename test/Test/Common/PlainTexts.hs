{-# LANGUAGE OverloadedStrings #-}

-- | Marks, encodings and ends of lines are the same to every text format.
--
-- The story: an OBJ file with a byte order mark lost its first vertex without a word, an STL file
-- with one claimed to take 8 GB, and a table that a spreadsheet saved with CR alone was one line.
module Test.Common.PlainTexts (spec) where

import Control.Monad (forM_)
import CsvGrid (parseGrid)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import Data.Char (isAlphaNum, toUpper)
import Data.List (isInfixOf)
import qualified Data.Text as Text
import Data.Text.Encoding (encodeUtf16BE, encodeUtf16LE, encodeUtf32LE)
import PraTactile.Classification.Calibration (decodeCalibration)
import PraTactile.Classification.Network.File (decodeNetwork)
import PraTactile.Format (decodeManifest)
import PraTactile.Format.Json.Strict (readJson)
import PraTactile.Format.Solid
import PraTactile.PlainText
import PraTactile.Sensor.Manifest (parseManifest)
import PraTactile.Shape (decodeAlphabet)
import Test.CommandLine.Run
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Support (inFolder)

spec :: Spec
spec = do
  prop "lines, each with an end of its own, are those lines" $
    forAll (listOf1 (elements ["", "v 1", "f \xc3\xa9"])) $ \texts ->
      forAll (vectorOf (length texts) (elements ["\n", "\r\n", "\r"])) $ \ends ->
        forAll (elements ["", byteOrderMark]) $ \mark ->
          -- CR before an empty line that ends with LF would be CR LF.
          ("\r", "", "\n") `notElem` zip3 ends (drop 1 texts) (drop 1 ends)
            ==> plainText (mark <> Bytes.concat (zipWith (<>) texts ends))
            === Right (Char8.unlines texts)
  it "a mark is one at the beginning alone, and bytes that are no text stay as they are" $ do
    plainText ("a" <> byteOrderMark) `shouldBe` Right ("a" <> byteOrderMark)
    plainText (byteOrderMark <> byteOrderMark) `shouldBe` Right byteOrderMark
    map plainText ["", "\xef\xbb", "\NUL\NUL", "a\NUL", "\xff"]
      `shouldBe` map Right ["", "\xef\xbb", "\NUL\NUL", "a\NUL", "\xff"]
  forM_ readers $ \(name, content, reader) -> do
    file <- runIO content
    describe name $ do
      it "reads the same with a mark, and with every end of line" $ do
        reader file `shouldSatisfy` either (const False) (const True)
        forM_ ["\n", "\r\n", "\r"] $ \end ->
          forM_ ["", byteOrderMark] $ \mark ->
            reader (mark <> Bytes.intercalate end (Char8.split '\n' file)) `shouldBe` reader file
      it "names UTF-16 and UTF-32" $ do
        let text = Text.pack (Char8.unpack file)
        forM_
          [ ("UTF16", encodeUtf16LE text),
            ("UTF16", encodeUtf16BE text),
            ("UTF16", encodeUtf16LE ("\xFEFF" <> text)),
            ("UTF16", encodeUtf16BE ("\xFEFF" <> text)),
            ("UTF32", encodeUtf32LE ("\xFEFF" <> text))
          ]
          $ \(encoding, bytes) ->
            reader bytes `shouldSatisfy` either (names encoding) (const False)
  it "the program says what to do with UTF-16, in files, lines and lists" $
    inFolder $ \folder -> do
      Bytes.writeFile (folder ++ "/part.obj") (encodeUtf16LE "\xFEFFv 0 0 0\n")
      Bytes.writeFile (folder ++ "/lines.txt") (encodeUtf16LE "\xFEFF\&3 2 / 3 1\n")
      forM_
        [ "pra solid part.obj",
          "pra solid - --format obj < part.obj",
          "pra place --objects part.obj --output p.json",
          "pra locate --batch < lines.txt",
          "pra synthesise --q 4 < lines.txt"
        ]
        $ \script -> do
          (status, _, err) <- scripted folder script
          (script, status) `shouldBe` (script, 2)
          (script, err) `shouldSatisfy` (("is UTF-16; save it as UTF-8" `isInfixOf`) . snd)
  it "the standard input line by line: a mark, and every end of line" $
    inFolder $ \folder -> do
      let patches = ["3 2 0 / 3 0 2 / 0 1 3", "?", "3 2 0 / 3 0 2 / 0 1 3"]
      [wanted, marked, returns, alone] <-
        mapM
          ( \bytes -> do
              Bytes.writeFile (folder ++ "/lines.txt") bytes
              scripted folder "pra locate --batch < lines.txt"
          )
          [ Char8.unlines patches,
            byteOrderMark <> Char8.unlines patches,
            Bytes.concat (map (<> "\r\n") patches),
            byteOrderMark <> Bytes.intercalate "\r" patches
          ]
      [marked, returns, alone] `shouldBe` replicate 3 wanted
      scripted folder "pra locate \"$(printf '\\357\\273\\277%s' '3 2 0 / 3 0 2 / 0 1 3')\""
        `shouldReturn'` scripted folder "pra locate '3 2 0 / 3 0 2 / 0 1 3'"
  where
    names encoding = isInfixOf encoding . map toUpper . filter isAlphaNum
    shouldReturn' a b = b >>= shouldReturn a

-- | Every text format: its name, a file of it, and how that is read.
readers :: [(String, IO ByteString, ByteString -> Either String String)]
readers =
  [ ("OBJ", pure "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n", solid Obj),
    ("OFF", pure "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", solid Off),
    ( "STL",
      pure
        "solid of lines\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n\
        \endloop\nendfacet\nendsolid\n",
      solid Stl
    ),
    ( "PLY",
      pure
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
        \property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
        \0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
      solid Ply
    ),
    ( "an object as JSON",
      pure
        "{\"schema\": \"pra-tactile/object/1\",\n\"name\": \"a\", \"vertices\": [],\n\
        \\"faces\": []}\n",
      solid Json
    ),
    ("any JSON", pure "[1,\n2]\n", shown . readJson),
    ( "a manifest as CSV",
      pure "file,x_mm,y_mm,rotation_deg,force_n\na.pgm,.5,1.,+2,0\n",
      shown . parseManifest
    ),
    ( "a manifest as JSON",
      pure
        "{\"schema\": \"pra-tactile/manifest/1\", \"taxel_mm\": 1.5875,\n\"frames\": [{\"file\": \
        \\"a.pgm\", \"x_mm\": 1, \"y_mm\": 2, \"rotation_deg\": 0, \"force_n\": 10}]}\n",
      shown . decodeManifest
    ),
    ("an array as CSV", pure "0,1\n1,0\n", either Left (Right . show) . parseGrid Nothing),
    ("shapes", Bytes.readFile "data/shapes.txt", shown . decodeAlphabet),
    ("a network", Bytes.readFile "data/network.txt", shown . decodeNetwork),
    ("a calibration", Bytes.readFile "data/calibration.txt", shown . decodeCalibration)
  ]
  where
    solid format = shown . readSolid format "x"
    shown :: (Show e, Show a) => Either e a -> Either String String
    shown = either (Left . show) (Right . show)
