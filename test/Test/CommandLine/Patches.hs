{-# LANGUAGE OverloadedStrings #-}

-- | How patches are written, and how large they may be.
module Test.CommandLine.Patches (spec) where

import Data.Aeson
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List (intercalate)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import PatchBound
import System.FilePath ((</>))
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.QuickCheck
import Test.Support

spec :: Spec
spec = do
  it "65536 cells are taken in every form, and one more is not" $
    for_ forms $ \(name, form) -> do
      (name, oversized 4 (form 65536)) `shouldBe` (name, Nothing)
      (name, fmap (take 39) (oversized 4 (form 65537)))
        `shouldBe` (name, Just "the patch has more than 65536 cells, wh")
  it "the cells of all patches count, and those of displacements do not" $ do
    let patches count cells =
          Text.intercalate ";" (replicate count ("0,3: " <> Text.unwords (replicate cells "?")))
    oversized 4 (patches 2 32768) `shouldBe` Nothing
    oversized 4 (patches 2 32769) `shouldSatisfy` (/= Nothing)
  it "what is no patch is refused by its size, too: rows without cells, brackets" $
    for_ [many "/", many ";", "[" <> many "0," <> "0]", many "["] $ \text ->
      oversized 4 text `shouldSatisfy` (/= Nothing)
  it "brackets and commas in a text are none, nor is an escaped quotation mark its end" $
    oversized 4 ("[[\"" <> Text.replicate 100000 "[,\\\"" <> "\"]]") `shouldBe` Nothing
  it "a patch of probabilities is as large as one of symbols, whatever the alphabet" $
    for_ [2, 4, 25] $ \q -> do
      let cell = "[" <> Text.intercalate "," (replicate q "0") <> "]"
          given n = "[[" <> Text.intercalate "," (replicate n cell) <> "]]"
      oversized q (given 65536) `shouldBe` Nothing
      oversized q (given 65537) `shouldSatisfy` (/= Nothing)
  it "no patch of up to 40 x 40 is refused, as aeson writes it" $
    property $
      forAll ((,) <$> choose (1, 40) <*> choose (1, 40)) $ \(high, wide) ->
        forAll
          ( vectorOf
              high
              ( vectorOf
                  wide
                  (elements [Null, String "A^2", Number 3, toJSON (replicate 4 (0.25 :: Double))])
              )
          )
          $ \cells -> do
            let written :: Value -> Text.Text
                written = Text.decodeUtf8 . Lazy.toStrict . encode
                displaced = object ["patches" .= [object ["at" .= [0, 0 :: Int], "cells" .= cells]]]
            map (oversized 4 . written) [toJSON cells, displaced] === [Nothing, Nothing]
  it "a line of 2 MB is answered in 32 MB of memory, and the next one after it" $ do
    let long =
          [ "[[" ++ intercalate "," (replicate 400000 "null") ++ "]]",
            replicate 2000000 'A'
          ]
            ++ byEffort [] [Text.unpack (many "? ")]
    (status, out, err) <-
      praUnder "-N1 -A1m -M32m" ["locate", "--batch"] (concatMap (++ "\n3 2 / 3 1\n") long)
    (status, err, map (key ["outcome"]) (lines out))
      `shouldBe` (2, "", concatMap (const [Just "invalid", Just "located"]) long)
    length out `shouldSatisfy` (< 3000 * length long)
  it "line ends part the rows of a patch: a grid on several lines is not one long row" $ do
    (_, whole, _) <- pra ["locate", "--json", "3 2 1 / 3 1 3 / 2 2 2"]
    key ["outcome"] whole `shouldSatisfy` (/= Nothing)
    for_ (gridsOf ["3 2 1", "3 1 3", "2 2 2"]) $ \written -> do
      (_, out, err) <- pra ["locate", "--json", written]
      (written, out, err) `shouldBe` (written, whole, "")
    -- One row of four is elsewhere on the array: that is what two lines were taken for.
    (_, asOneRow, _) <- pra ["locate", "3 2 3 1"]
    (_, asTwo, _) <- pra ["locate", "3 2\n3 1"]
    (asOneRow, asTwo) `shouldBe` ("row 0, column 12\n", "row 6, column 5\n")
    outcome <- pra ["locate", "3 2 // 3 1"]
    outcome `refuses` "row 2 of the patch has 0 cells"
  it "so they do in several patches, and a semicolon may end the last one" $ do
    whole <- pra ["locate", "--json", "3 2 / 3 1 ; 0,3: 1 1 / 1 1"]
    for_
      ["3 2\n3 1\n;\n0,3: 1 1\n1 1\n", "3 2\r\n3 1;\r\n0,3:\r\n1 1 /\r\n1 1;\r\n"]
      $ \written -> pra ["locate", "--json", written] `shouldReturn` whole
  it "lines of a batch end with LF, CR LF or CR, however they arrive, and each is one patch" $ do
    (_, whole, _) <- praWith ["locate", "--batch"] "3 2 / 3 1\n0 0 / 0 0\n3 2 / 3 1\n"
    length (lines whole) `shouldBe` 3
    for_ ["\r\n", "\r"] $ \end -> do
      (_, out, _) <-
        praWith ["locate", "--batch"] (concatMap (++ end) ["3 2 / 3 1", "0 0 / 0 0", "3 2 / 3 1"])
      (end, out) `shouldBe` (end, whole)
    inFolder $ \folder -> do
      (_, out, _) <-
        scripted
          folder
          "(printf '3 2 / 3 1\\r'; sleep 0.1; printf '\\n0 0 / 0 0\\r\\n3 2 / 3 1') | pra locate \
          \--batch"
      out `shouldBe` whole
  it "a CSV file of an array is read with any line ends, and with semicolons" $
    inFolder $ \folder -> do
      (_, array, _) <- pra ["array", "--format", "csv"]
      let file = folder </> "array.csv"
          proved = do
            (status, out, _) <- pra ["prove", "--json", "--window", "2x2", file]
            pure (status, key ["proved"] out, key ["array", "shape"] out)
      writeBinary file array
      expected <- proved
      (\(status, yes, _) -> (status, yes)) expected `shouldBe` (0, Just (Bool True))
      for_ ["\r\n", "\r"] $ \end ->
        for_ [id, map (\c -> if c == ',' then ';' else c)] $ \separated -> do
          writeBinary file (concatMap ((++ end) . separated) (lines array))
          proved `shouldReturn` expected
  where
    -- A grid as it is written on several lines.
    gridsOf :: [String] -> [String]
    gridsOf rows =
      [ intercalate "\n" rows,
        unlines rows,
        concatMap (++ "\r\n") rows,
        intercalate "\r" rows,
        "\n \n" ++ intercalate "\n\n" rows ++ "\n\t\n",
        intercalate " /\n" rows,
        intercalate "\n/ " rows,
        concatMap (++ " /\n") rows,
        intercalate "\x2028" rows,
        intercalate " / " rows ++ " /"
      ]
    writeBinary file = Bytes.writeFile file . Bytes.pack
    many = Text.replicate 1000000
    forms =
      [ ("text" :: String, \n -> Text.unwords (replicate n "?")),
        ( "rows",
          \n -> Text.unwords (replicate 256 "?") <> " / " <> Text.unwords (replicate (n - 256) "?")
        ),
        ("displaced", \n -> "0,0: " <> Text.unwords (replicate n "?")),
        ("JSON", \n -> "[[" <> Text.intercalate "," (replicate n "null") <> "]]"),
        ( "JSON of patches",
          \n ->
            "{\"patches\": [{\"at\": [0, 0], \"cells\": [["
              <> Text.intercalate "," (replicate n "3")
              <> "]]}]}"
        )
      ]
