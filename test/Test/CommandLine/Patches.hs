{-# LANGUAGE OverloadedStrings #-}

-- | How large a written patch may be.
module Test.CommandLine.Patches (spec) where

import Data.Aeson
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List (intercalate)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import PatchBound
import Test.CommandLine.Run
import Test.Hspec
import Test.QuickCheck

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
  it "a line of 2 MB is answered in 32 MB of memory, and the next one after it" $
    for_
      [ Text.unpack (many "? "),
        "[[" ++ intercalate "," (replicate 400000 "null") ++ "]]",
        replicate 2000000 'A'
      ]
      $ \line -> do
        (status, out, err) <-
          praUnder "-N1 -A1m -M32m" ["locate", "--batch"] (line ++ "\n3 2 / 3 1\n")
        (status, err, map (key ["outcome"]) (lines out))
          `shouldBe` (2, "", [Just "invalid", Just "located"])
        length out `shouldSatisfy` (< 3000)
  where
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
