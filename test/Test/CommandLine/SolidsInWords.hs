{-# LANGUAGE OverloadedStrings #-}

-- | The words and the JSON of one answer about solids say the same numbers, of symbols of the
-- paper's size and of half that size.
module Test.CommandLine.SolidsInWords (spec) where

import Data.Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Char (isDigit)
import Data.Foldable (for_, toList)
import Data.List (stripPrefix, tails)
import Data.Maybe (fromMaybe, listToMaybe, mapMaybe)
import qualified Data.Text as Text
import Test.CommandLine.Run
import Test.Hspec
import Test.Support

spec :: Spec
spec =
  for_ [("of the paper's size", "1"), ("half as large", "1/2")] $ \(size, symbols) -> do
    it ("place, with symbols " ++ size) $
      for_ ["octahedron:110", "l:100x60x110", "box:60x90x50"] $ \solid -> do
        (said, told) <- bothOf ["place", solid, "--symbols", symbols]
        let layings = parts (at ["layings"] told)
        if null layings
          then
            map numbersIn said
              `shouldBe` [figuresAt told ["cells_needed"] ++ figuresAt told ["cells"]]
          else do
            map (numbersIn . afterColon) (take (1 + length layings) said)
              `shouldBe` ( [ fromIntegral (length layings),
                             sum (concatMap (figures . at ["symbols"]) layings)
                           ]
                             ++ figures (at ["cells"] told)
                         ) :
              [ figuresAt one ["symbols"]
                  ++ onArray one
                  ++ concatMap (figuresAt one . pure) ["rank", "distance"]
                | one <- layings
              ]
            map numbersIn (drop (1 + length layings) said)
              `shouldBe` [ figures (at ["profile", "window"] told)
                             ++ concat
                               [ figures (at ["windows", name] told)
                                 | name <- ["on_faces", "straddling", "on_none"]
                               ],
                           figures (at ["press_taxels"] told)
                         ]
    it ("solid, with symbols " ++ size) $
      for_ ["octahedron:110", "frame:99x80x30", "l:100x60x110"] $ \solid -> do
        (said, told) <- bothOf ["solid", solid, "--symbols", symbols]
        map numbersIn (take 2 (drop 1 said))
          `shouldBe` [ concatMap (figuresAt told . pure) ["vertices", "edges", "faces"],
                       concat
                         [ figuresAt piece [name]
                           | piece <- parts (at ["components"] told),
                             name <- ["vertices", "edges", "faces", "euler", "genus", "volume_mm3"]
                         ]
                     ]
        map (numbersIn . afterColon) (drop 3 said)
          `shouldBe` [ figuresAt face ["cells"] ++ figuresAt face ["size_mm"]
                       | face <- parts (at ["carrying"] told),
                         figuresAt face ["cells"] /= [0]
                     ]
    it ("emboss, with symbols " ++ size) $
      inFolder $ \folder -> do
        (status, out, _) <-
          scripted folder $
            "pra place box:60x90x50 --symbols " ++ symbols ++ " --output p.json > log && "
              ++ "pra emboss --placement p.json --object box --output b.stl && "
              ++ "pra emboss --placement p.json --object box --output b.stl --json"
        status `shouldBe` 0
        case lines out of
          [said, written] ->
            for_ (parts (maybe Null (at ["files"]) (key [] written))) $ \made ->
              numbersIn (afterColon said)
                `shouldBe` concatMap
                  (figuresAt made . pure)
                  ["vertices", "triangles", "volume_mm3", "raised_taxels", "stroke_mm", "height_mm"]
          _ -> expectationFailure out
  where
    bothOf arguments = do
      (_, said, _) <- pra arguments
      (_, written, _) <- pra (arguments ++ ["--json"])
      pure (lines said, fromMaybe Null (key [] written))
    figuresAt value path = figures (at path value)
    -- The size and the corner of the face's cells, as far as they lie on the array.
    onArray laying = case (figuresAt laying ["row"], figuresAt laying ["column"]) of
      ([row], [column]) ->
        let rows = parts (at ["cells"] laying)
            high = fromIntegral (length rows)
            wide = fromIntegral (maximum (0 : map textLength rows))
         in [high + min 0 row, wide + min 0 column, max 0 row, max 0 column]
      _ -> []
    textLength value = case value of
      String text -> Text.length text
      _ -> 0

-- | What follows the first colon.
afterColon :: String -> String
afterColon line = fromMaybe line (listToMaybe (mapMaybe (stripPrefix ": ") (tails line)))

-- | The value under some keys.
at :: [Key] -> Value -> Value
at path value = foldl part value path
  where
    part (Object fields) name = fromMaybe Null (KeyMap.lookup name fields)
    part _ _ = Null

parts :: Value -> [Value]
parts value = case value of
  Array list -> toList list
  _ -> []

-- | The numbers that a value has.
figures :: Value -> [Double]
figures value = case value of
  Number n -> [realToFrac n]
  String text -> numbersIn (Text.unpack text)
  Array list -> concatMap figures list
  _ -> []

-- | The numbers that a text has, but for exponents of units.
numbersIn :: String -> [Double]
numbersIn text = case text of
  [] -> []
  '^' : rest -> numbersIn (dropWhile isDigit rest)
  '-' : rest@(c : _) | isDigit c -> zipWith id (negate : repeat id) (numbersIn rest)
  c : rest
    | isDigit c ->
      let (whole, left) = span isDigit text
          (decimals, others) = case left of
            '.' : more@(d : _) | isDigit d -> span isDigit more
            _ -> ("0", left)
       in read (whole ++ "." ++ decimals) : numbersIn others
    | otherwise -> numbersIn rest
