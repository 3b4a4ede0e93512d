{-# LANGUAGE OverloadedStrings #-}

-- | Faces of files that other programs write, laid on the array: triangles, other units, faces with
-- few symbols.
module Test.CommandLine.Place (spec) where

import Control.Monad (forM_)
import Data.Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (toList)
import Data.List (isInfixOf, stripPrefix, tails)
import Data.Maybe (mapMaybe)
import qualified Data.Text as Text
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Cells (gridCells, gridOf)
import PraTactile.Object.Named
import PraTactile.Object.Placement (Pitch (..))
import PraTactile.Object.WingedEdge
import Test.CommandLine.Run
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  -- The triangles of a box were laid one by one, and no press on them was recognised.
  it "the faces of an STL are whole, and its triangles where they are asked for" $
    inFolder $ \folder -> do
      let whole = "pra solid box:90x120x80 --output part.stl > log; "
      (_, out, err) <- scripted folder (whole ++ "pra place part.stl --json")
      (length (layings out), err) `shouldBe` (6, "")
      (_, apart, _) <- scripted folder "pra place part.stl --keep-triangles --json"
      length (layings apart) `shouldBe` 12
      -- A box has 384 unfoldings; so has its file.
      (_, nets, _) <- scripted folder "pra nets part.stl | head -1"
      nets `shouldBe` "part: 384 unfoldings\n"
      (_, added, _) <-
        scripted
          folder
          "pra place box:60x60x60 --output p; pra objects --placement p --write d.sqlite > log; \
          \pra objects --database d.sqlite --add part.stl --json"
      key ["faces"] (last (lines added)) `shouldBe` Just (Number 12)
  -- Rounded coordinates leave the triangles of a slanted face a little out of one plane.
  it "triangles that are nearly one face are reported, with the tolerance that merges them" $
    inFolder $ \folder -> do
      writeFile (folder ++ "/slanted.obj") slantedBox
      (_, apart, warned) <- scripted folder "pra place slanted.obj --json"
      length (layings apart) `shouldSatisfy` (> 6)
      warned `shouldSatisfy` ("--tolerance" `isInfixOf`)
      let tolerance = takeWhile (/= ' ') (following "--tolerance " warned)
      (_, mended, err) <-
        scripted folder ("pra place slanted.obj --json --tolerance " ++ tolerance)
      (length (layings mended), err) `shouldBe` (6, "")
  -- A part in inches was placed on none of 255 cells, with status 0.
  it "where no face has room for a symbol, nothing is laid, and the unit is asked for" $
    inFolder $ \folder -> do
      (status, out, _) <-
        scripted
          folder
          "pra solid box:4x5x3 --output lid.stl > log; \
          \pra place lid.stl --output p; s=$?; ls; exit $s"
      status `shouldBe` 1
      lines out `shouldSatisfy` any ("inches? give --scale 25.4" `isInfixOf`)
      drop 1 (lines out) `shouldBe` ["lid.stl", "log"]
      (reason, told, _) <- scripted folder "pra place lid.stl --json"
      (reason, key ["reason"] told) `shouldBe` (1, Just "no-symbols")
      (scaled, _, _) <- scripted folder "pra place lid.stl --scale 25.4"
      scaled `shouldBe` 0
      (metres, inMetres, _) <- pra ["place", "box:0.1x0.1x0.1"]
      metres `shouldBe` 1
      inMetres `shouldSatisfy` ("metres? give --scale 1000" `isInfixOf`)
      (added, nothing, _) <-
        scripted
          folder
          "pra objects --write d.sqlite > log; pra objects --database d.sqlite > a; \
          \pra objects --database d.sqlite --add lid.stl; s=$?; \
          \pra objects --database d.sqlite | cmp - a; exit $s"
      added `shouldBe` 1
      nothing `shouldSatisfy` ("inches" `isInfixOf`)
      (named, _, _) <- pra ["place", "cube", "box:4x5x3", "--face", "box:V1 V2 V3 V4"]
      named `shouldBe` 1
  it "an object without symbols is named, if others have some" $ do
    (status, _, err) <- pra ["place", "cube", "lid=box:4x5x3"]
    (status, lines err) `shouldBe` (0, ["pra-tactile: warning: the lid carries no symbol"])
  -- A face with room for six symbols got one, and a box of 6 x 7 cells was called so many symbols.
  it "each face has as many symbols as are told, and the most that any of its vertices gives it" $
    forM_ [("l:150x60x150", LShape 150 60 150), ("pyramid:150x120x90", Pyramid 150 120 90)] $
      \(name, known) -> do
        body <- right (solid (namedDescription known))
        (_, out, _) <- pra ["place", name, "--json"]
        let Pitch wide high = canonicalPitch
            most walk =
              maximum
                [ length (gridCells (gridOf (solidMesh body) (wide, high) begun))
                  | k <- [0 .. length walk - 1],
                    let from = take (length walk) (drop k (cycle walk)),
                    Just begun <- [walkNamed body (FaceName from)]
                ]
        layings out `shouldSatisfy` not . null
        forM_ (layings out) $ \laying -> do
          let counts = [numberIn "symbols" laying, numberIn "most_symbols" laying]
          counts `shouldBe` replicate 2 (Just (most (namesIn "face" laying)))
          numberIn "symbols" laying
            `shouldBe` Just (sum (map (Text.count "#") (textsIn "cells" laying)))
  it "a face that is begun where it has fewer symbols than it could have says so" $ do
    (_, out, _) <- pra ["place", "box:80x70x60", "--upright", "--face", "box:V2 V3 V4 V1"]
    -- 70 / 25.4 by 80 / 31.75 is 2 x 2; 80 / 25.4 by 70 / 31.75 is 3 x 2.
    lines out `shouldSatisfy` any ("4 symbols on 2x2 cells" `isInfixOf`)
    lines out `shouldSatisfy` any ("begun at V3 it has 6" `isInfixOf`)
    (_, better, _) <- pra ["place", "box:80x70x60", "--face", "box:V2 V3 V4 V1"]
    lines better `shouldSatisfy` any ("6 symbols on 2x3 cells" `isInfixOf`)
    lines better `shouldSatisfy` all (not . ("begun at" `isInfixOf`))
  it "faces whose cells have a rank below the polynomial's degree are warned of" $ do
    (_, _, none) <- pra ["place", "cube"]
    none `shouldBe` ""
    -- Two faces have two symbols, which have 16 contents, and the array has 255 places.
    (status, _, err) <- pra ["place", "box:60x60x200"]
    status `shouldBe` 0
    err `shouldSatisfy` ("warning: 2 faces cannot be told" `isInfixOf`)
  it "options for files are refused if no file is read" $
    inFolder $ \folder -> do
      complains ["objects", "--scale", "25.4"] "--add and --replace"
      complains ["draw", "sheet", "--keep-triangles", "--output", folder ++ "/a.svg"] "'solid'"
      complains
        ["draw", "solid", "--object", "cube", "--scale", "2", "--output", folder ++ "/a.svg"]
        "cube"
      complains
        ["probe", "--object", "cube", "--seed", "1", "--scale", "2", "--output", folder ++ "/f"]
        "--mesh"
  where
    following text whole = case mapMaybe (stripPrefix text) (tails whole) of
      rest : _ -> rest
      [] -> ""

-- | The laid faces that a report in JSON has.
layings :: String -> [Value]
layings out = case key ["layings"] out of
  Just (Array all') -> toList all'
  _ -> []

numberIn :: Key -> Value -> Maybe Int
numberIn name value = case partOf name value of
  Just (Number n) -> Just (round n)
  _ -> Nothing

textsIn :: Key -> Value -> [Text.Text]
textsIn name value = case partOf name value of
  Just (Array all') -> mapMaybe text (toList all')
  _ -> []
  where
    text one = case one of
      String it' -> Just it'
      _ -> Nothing

namesIn :: Key -> Value -> [VertexName]
namesIn name = map (VertexName . Text.unpack) . textsIn name

partOf :: Key -> Value -> Maybe Value
partOf name value = case value of
  Object fields -> KeyMap.lookup name fields
  _ -> Nothing

-- | A box turned by rational rotations, whose faces are two triangles each, with coordinates
-- rounded to millionths.
slantedBox :: String
slantedBox = unlines (map vertex corners ++ concatMap triangles faces)
  where
    corners = [(x, y, z) | x <- [0, 90], y <- [0, 120], z <- [0, 80]]
    vertex :: (Rational, Rational, Rational) -> String
    vertex (x, y, z) =
      let (x', y') = (0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y)
          (y'', z') = (5 / 13 * y' - 12 / 13 * z, 12 / 13 * y' + 5 / 13 * z)
       in unwords ("v" : map (show . rounded) [x' + 1 / 7, y'' + 1 / 3, z'])
    rounded :: Rational -> Double
    rounded v = fromIntegral (round (v * 1000000) :: Integer) / 1000000
    faces = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
    triangles :: (Int, Int, Int, Int) -> [String]
    triangles (a, b, c, d) = [unwords ("f" : map show three) | three <- [[a, b, c], [a, c, d]]]
