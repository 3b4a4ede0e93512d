{-# LANGUAGE OverloadedStrings #-}

-- | @locate@ with damage, as scripts use it.
module Test.CommandLine.Locate (spec) where

import Data.Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (for_)
import Data.List (intercalate, isInfixOf, isPrefixOf, isSuffixOf, transpose)
import qualified Data.Text as Text
import PraTactile.Array (Folding (..), Position (Position), Shape (Shape), cellAt)
import PraTactile.Field (toCode)
import PraTactile.Polynomial
import Test.Code.Generators
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec

spec :: Spec
spec = do
  it "locate corrects what the observed cells guarantee, and more only where told to" $ do
    (status, out, _) <- pra ["locate", "--json", "3 2 1 2 / 3 1 3 0 / 2 2 2 3 / 0 2 2 2"]
    ( status,
      key ["outcome"] out,
      key ["reason"] out,
      key ["radius"] out,
      key ["minimum_distance"] out
      )
      `shouldBe` (1, Just "refused", Just "beyond-radius", Just (Number 4), Just (Number 9))
    (_, array, _) <- pra ["array", "--format", "csv"]
    let rows = map (map (\c -> if c == ',' then ' ' else c)) (lines array)
        cells r c h w = [take w (drop c (words row)) | row <- take h (drop r rows)]
        wrongAt (i, j) patch =
          [ [ if (i, j) == (a, b) then (if cell == "0" then "1" else "0") else cell
              | (b, cell) <- zip [0 ..] row
            ]
            | (a, row) <- zip [0 :: Int ..] patch
          ] ::
            [[String]]
        damaged = foldr wrongAt (cells 4 3 4 4) [(0, 0), (1, 2), (2, 1), (3, 3 :: Int)]
    locates ["locate", spelled damaged] ["row 4, column 3 (4 cells corrected)"]
    (refused, strict, _) <- pra ["locate", "--json", "--radius", "3", spelled damaged]
    (refused, key ["reason"] strict) `shouldBe` (1, Just "beyond-radius")
    for_ ["table", "search", "algebra"] $ \road -> do
      (located, exact, _) <- pra ["locate", "--json", "--road", road, spelled (cells 4 3 4 4)]
      (located, key ["road"] exact, key ["position", "row"] exact)
        `shouldBe` (0, Just (String (Text.pack road)), Just (Number 4))
      (contradicted, no, _) <- pra ["locate", "--json", "--road", road, spelled damaged]
      (contradicted, key ["reason"] no) `shouldBe` (1, Just "contradiction")
  it "locate corrects errors on arrays of 2^60 cells, and tells what of the distance is proved" $ do
    h <- firstOver gf4 30
    array <- right (folded Diagonal (Shape (4 ^ (15 :: Int) - 1) (4 ^ (15 :: Int) + 1)) h)
    let codes = map (show . toCode)
        chosen =
          [ "--q",
            "4",
            "--polynomial",
            intercalate "," (codes (coefficients (primitivePolynomial h))),
            "--shape",
            "1073741823x1073741825",
            "--window",
            "15x2"
          ]
        seen height width =
          [ [cellAt array (Position (987654321 + i) (123456789 + j)) | j <- take width [0 ..]]
            | i <- take height [0 ..]
          ]
        wrong places cells =
          [ [if (i, j) `elem` places then a + 1 else a | (j, a) <- zip [0 :: Int ..] line]
            | (i, line) <- zip [0 :: Int ..] cells
          ]
        written = intercalate " / " . map (unwords . codes)
        some = [(0, 0), (3, 4), (7, 7)]
        locating options cells = pra (["locate", "--json"] ++ chosen ++ options ++ [written cells])
    (status, out, _) <- locating [] (wrong some (seen 8 8))
    ( status,
      key ["road"] out,
      key ["position"] out,
      key ["corrected"] out,
      key ["minimum_distance_is"] out
      )
      `shouldBe` ( 0,
                   Just "information-sets",
                   Just (object ["row" .= (987654321 :: Int), "column" .= (123456789 :: Int)]),
                   Just (toJSON [[0, 0], [3, 4], [7, 7 :: Int]]),
                   Just "at-least"
                 )
    (key ["nearest"] out, key ["runner_up"] out) `shouldBe` (Just (Number 3), Just Null)
    key ["radius"] out
      `shouldSatisfy` \radius -> radius `elem` [Just (toJSON e) | e <- [3 .. 8 :: Int]]
    (refused, no, _) <- locating ["--radius", "2"] (wrong some (seen 8 8))
    (refused, key ["reason"] no, key ["nearest"] no) `shouldBe` (1, Just "beyond-radius", Just Null)
    (coset, many, _) <- locating [] (seen 1 10)
    (coset, key ["count"] many, key ["dimension"] many)
      `shouldBe` (1, Just (toJSON (4 ^ (20 :: Int) :: Integer)), Just (Number 20))
    -- Quickly, what is explained is that of smaller arrays.
    whenFull $ do
      (explained, words', _) <-
        pra (["locate", "--explain"] ++ chosen ++ [written (wrong some (seen 8 8))])
      (explained, take 1 (lines words'))
        `shouldBe` (0, ["row 987654321, column 123456789 (3 cells corrected)"])
      lines words'
        `shouldSatisfy` any
          ("The nearest position differs in 3 cells, any other one in at least " `isPrefixOf`)
    complains
      ( ["locate"]
          ++ chosen
          ++ [ "--radius",
               "30",
               written
                 (wrong [(i, j) | i <- [0 .. 7], j <- [0 .. 7], (i + j) `mod` 3 == 0] (seen 8 8))
             ]
      )
      "give a smaller --radius"
    -- The same cells from probabilities: three are as likely another symbol.
    let chances places =
          encode
            [ [ [chance (at `elem` places) a b | b <- [0 .. 3]]
                | (j, a) <- zip [0 ..] line,
                  let at = (i, j)
              ]
              | (i, line) <- zip [0 :: Int ..] (seen 8 8)
            ]
        chance doubtful a b
          | doubtful = if b `elem` [toCode a, toCode (a + 1)] then 0.5 else 0 :: Double
          | otherwise = if b == toCode a then 1 else 0
        soft options places =
          pra (["locate"] ++ options ++ chosen ++ [Lazy8.unpack (chances (places :: [(Int, Int)]))])
    (likely, answer, _) <- soft ["--json"] some
    (likely, key ["road"] answer, key ["doubt_is"] answer, key ["position", "row"] answer)
      `shouldBe` (0, Just "list", Just "at-most", Just (Number 987654321))
    (unlikely, refusal, _) <-
      pra
        ( ["locate", "--json"]
            ++ chosen
            ++ [Lazy8.unpack (encode (replicate 8 (replicate 8 [0.4, 0.2, 0.2, 0.2 :: Double])))]
        )
    (unlikely, key ["reason"] refusal) `shouldBe` (1, Just "below-threshold")
    whenFull $ do
      (whole, sentences, _) <- soft ["--explain"] some
      (whole, lines sentences)
        `shouldSatisfy` \(status', said) -> status' == 0 && any ("at most" `isInfixOf`) said
  it "locate takes probabilities as JSON" $ do
    locates ["locate", "--doubt", "0.2", "[[[0,0,0.1,0.9],2],[\"A^2\",1]]"] ["row 6, column 5"]
    (status, out, _) <- pra ["locate", "--json", "[[[0,0,0.1,0.9],2],[3,1]]"]
    (status, key ["reason"] out) `shouldBe` (1, Just "below-threshold")
    (_, uncertain, _) <- pra ["locate", "--json", "[[[0.1,0.2,0.3,0.4],2],[[0.5,0.3,0.1,0.1],1]]"]
    -- Sixteen contents are possible; the five likeliest places are told.
    (\value -> case value of Just (Array them) -> length them; _ -> 0) (key ["likeliest"] uncertain)
      `shouldBe` 5
    for_
      (words "[[[0,0,0.1],2],[3,1]] [[[0,0,2,-1],2],[3,1]] [[3.5]] [[3],[]] [3 [[true]]")
      $ \patch ->
        complains ["locate", patch] ""
  it "locate --orientation tells how a patch is seen turned, clockwise, and mirrored" $ do
    (_, array, _) <- pra ["array", "--format", "csv"]
    let upright = cut array (6, 5) (4, 4)
        turned n = iterate (map reverse . transpose) upright !! n
    for_ [0 .. 3] $ \n -> do
      (status, out, _) <- pra ["locate", "--json", "--orientation", "turned", spelled (turned n)]
      ( status,
        key ["position"] out,
        key ["orientation_deg"] out,
        key ["mirrored"] out,
        key ["candidates"] out
        )
        `shouldBe` ( 0,
                     Just (object ["row" .= (6 :: Int), "column" .= (5 :: Int)]),
                     Just (toJSON (90 * n)),
                     Just (Bool False),
                     Just (toJSON ([] :: [Value]))
                   )
      -- Every array of windows with two columns is its own mirror image, so that never only one of
      -- both is left.
      (ambiguous, any', _) <-
        pra ["locate", "--json", "--orientation", "any", spelled (map reverse (turned n))]
      (ambiguous, key ["orientation_deg"] any', fmap candidates (key ["candidates"] any'))
        `shouldBe` ( 1,
                     Just Null,
                     Just [((360 - 90 * n) `mod` 360, False), ((360 - 90 * n) `mod` 360, True)]
                   )
    locates
      ["locate", "--orientation", "turned", spelled (turned 1)]
      ["row 6, column 5, turned by 90 degrees"]
    locates ["locate", "--orientation", "turned", spelled (turned 0)] ["row 6, column 5, upright"]
    locates ["locate", "--orientation", "upright", spelled (turned 0)] ["row 6, column 5"]
    for_ ["table", "search", "algebra"] $ \road ->
      locates
        ["locate", "--orientation", "turned", "--road", road, spelled (turned 3)]
        ["row 6, column 5, turned by 270 degrees"]
    (told, sentences, _) <-
      pra ["locate", "--orientation", "turned", "--explain", spelled (turned 2)]
    (told, filter ("turned by 180" `isInfixOf`) (lines sentences))
      `shouldSatisfy` \(status, found) -> status == 0 && length found == 2
    complains
      (words "locate --orientation turned --road table --radius 1" ++ [spelled upright])
      "--radius"
  it "locate takes several patches and names those that do not belong" $ do
    (_, array, _) <- pra ["array", "--format", "csv"]
    let at (r, c) = spelled (cut array (6 + r, 5 + c) (2, 2))
        text = at (0, 0) ++ " ; 0,3: " ++ at (0, 3) ++ " ; 4,-1: " ++ at (4, -1)
        astray = at (0, 0) ++ " ; 0,3: " ++ at (0, 3) ++ " ; 4,0: " ++ at (4, 1)
    locates ["locate", text] ["row 6, column 4"]
    (refused, named, _) <- pra ["locate", "3 2 / 3 1 ; 0,3: 1 1 / 1 1 ; 4,0: 2 2 / 3 0"]
    (refused, "inconsistent: patch 3\n" `isSuffixOf` named) `shouldBe` (1, True)
    locates ["locate", "3 2 / 3 1 ; 0,3: 1 1 / 1 1 ; 4,1: 2 2 / 3 0"] ["row 6, column 5"]
    locates ["locate", "--road", "algebra", text] ["row 6, column 4"]
    locates ["locate", "--road", "table", at (0, 0) ++ "; 1,1:" ++ at (1, 1)] ["row 6, column 5"]
    (status, out, _) <- pra ["locate", "--json", astray]
    (status, fmap inconsistent (key ["patches"] out)) `shouldBe` (1, Just [False, False, True])
    (_, explained, _) <- pra ["locate", "--explain", astray]
    filter ("does not belong" `isInfixOf`) (lines explained) `shouldSatisfy` ((== 1) . length)
    let patches =
          object
            [ "patches"
                .= [ object ["cells" .= codesOf (cut array (6, 5) (2, 2))],
                     object
                       [ "at" .= [1, 1 :: Int],
                         "cells" .= codesOf (disturbed (cut array (7, 6) (2, 2)))
                       ],
                     object ["at" .= [0, 4 :: Int], "cells" .= codesOf (cut array (6, 9) (2, 3))]
                   ]
            ]
    (located, found, _) <- pra ["locate", "--json", encoded patches]
    ( located,
      key ["position", "row"] found,
      key ["disputed"] found,
      fmap inconsistent (key ["patches"] found)
      )
      `shouldBe` (0, Just (Number 6), Just (toJSON [[1, 1 :: Int]]), Just [False, True, False])
    let chances =
          object
            [ "patches"
                .= [ object ["cells" .= [[[0, 0, 0.1, 0.9 :: Double]]]],
                     object ["at" .= [0, 0 :: Int], "cells" .= codesOf (cut array (6, 5) (2, 2))]
                   ]
            ]
    locates ["locate", encoded chances] ["row 6, column 5"]
    -- As after the last row, what parts patches may stand after the last one.
    locates ["locate", "3 2 / 3 1 ;"] ["row 6, column 5"]
    (batched, lines', _) <-
      praWith ["locate", "--batch"] (unlines [text, encoded chances, "3 2 / 3 1 ; 1:"])
    (batched, map (key ["outcome"]) (lines lines'))
      `shouldBe` (2, map (Just . String) ["located", "located", "invalid"])
    for_
      [ ("3 2 / 3 1 ; ;", "patch 2"),
        ("x,1: 3 2 / 3 1", "displacement"),
        ("1: 3 2", "displacement"),
        ("3 2 / 3 1 ; 0,3: 7", "patch 2"),
        ("999999999,0: 3 2 / 3 1 ; 3", "rectangle"),
        ("{\"patches\": []}", "no cells"),
        ("{\"patches\": 1}", "list"),
        ("{}", "patches"),
        ("{", "JSON"),
        ("{\"patches\": [{\"at\": [0.5, 0], \"cells\": [[1]]}]}", "displacement"),
        ("{\"patches\": [{\"at\": [0, 0]}]}", "cells"),
        ("{\"patches\": [{\"cell\": [[1]]}]}", "alone")
      ]
      $ \(patch, about) -> complains ["locate", patch] about
  it "locate knows orientations and several patches beyond 2^20 cells" $ do
    array <- arrayOver gf4 12 Diagonal (Shape 4095 4097)
    chosenPolynomial <-
      (\(_, out, _) -> concat (take 1 (lines out)))
        <$> pra (words "polynomials --q 4 --degree 12 --first")
    let chosen = ["--q", "4", "--polynomial", chosenPolynomial, "--shape", "4095x4097"]
        cells (r, c) (h, w) =
          [ [show (toCode (cellAt array (Position (r + i) (c + j)))) | j <- [0 .. w - 1]]
            | i <- [0 .. h - 1]
          ]
    locates
      ( ["locate", "--orientation", "turned"]
          ++ chosen
          ++ [spelled (transpose (reverse (cells (4000, 4096) (6, 4))))]
      )
      ["row 4000, column 4096, turned by 90 degrees"]
    locates
      ( ["locate"]
          ++ chosen
          ++ [ spelled (cells (4000, 4096) (4, 4))
                 ++ "; 7,0: "
                 ++ spelled (cells (4007, 4096) (3, 3))
             ]
      )
      ["row 4000, column 4096"]
    -- One wrong cell of 49, in any quarter turn.
    (status, out, _) <-
      pra
        ( words "locate --json --orientation turned"
            ++ chosen
            ++ [spelled (transpose (reverse (disturbed (cells (4000, 4096) (7, 7)))))]
        )
    ( status,
      key ["road"] out,
      key ["position", "row"] out,
      key ["orientation_deg"] out,
      key ["corrected"] out,
      key ["minimum_distance_is"] out
      )
      `shouldBe` ( 0,
                   Just "information-sets",
                   Just (Number 4000),
                   Just (Number 90),
                   Just (toJSON [[0, 6 :: Int]]),
                   Just "at-least"
                 )
    -- Neither could have one wrong cell alone, so that both are suspect; together they are located.
    locates
      ( ["locate", "--radius", "2"]
          ++ chosen
          ++ [ spelled (disturbed (cells (4000, 4096) (4, 4)))
                 ++ "; 7,0: "
                 ++ spelled (disturbed (cells (4007, 4096) (4, 4)))
             ]
      )
      ["row 4000, column 4096 (2 cells corrected); inconsistent: patches 1, 2"]
    -- Probabilities, too: one cell that is as likely 0 as 1, in four orientations.
    (undecided, many, _) <-
      pra (words "locate --json --orientation turned" ++ chosen ++ ["[[[0.5, 0.5, 0, 0]]]"])
    (undecided, key ["road"] many, key ["count"] many, key ["dimension"] many)
      `shouldBe` (1, Just "list", Just (toJSON (4 * (2 * 4 ^ (11 :: Int) - 1) :: Integer)), Nothing)
    let likely shape =
          Lazy8.unpack
            ( encode
                [ [[if b == code then 0.97 else 0.01 :: Double | b <- [0 .. 3]] | code <- line]
                  | line <- codesOf shape
                ]
            )
        probable = likely (transpose (reverse (cells (4000, 4096) (7, 4))))
    locates
      (["locate", "--orientation", "turned"] ++ chosen ++ [probable])
      ["row 4000, column 4096, turned by 90 degrees"]
  where
    spelled = intercalate " / " . map unwords
    cut array (r, c) (h, w) =
      [ take w (drop c (words row))
        | row <- take h (drop r (map (map (\x -> if x == ',' then ' ' else x)) (lines array)))
      ]
    codesOf rows = map (map read) rows :: [[Int]]
    disturbed rows = case rows of
      (a : line) : others -> ((if a == "0" then "1" else "0") : line) : others
      _ -> rows
    encoded = Lazy8.unpack . encode
    candidates value = case fromJSON value of
      Success found -> [(degrees, flipped) | Success (degrees, flipped) <- map pose found]
      Error _ -> []
    pose candidate = case candidate of
      Object fields
        | Just degrees <-
            KeyMap.lookup "orientation_deg" fields,
          Just flipped <- KeyMap.lookup "mirrored" fields ->
          (,) <$> fromJSON degrees <*> fromJSON flipped :: Result (Int, Bool)
      _ -> Error "no pose"
    inconsistent value = case fromJSON value of
      Success found ->
        [flag | Object fields <- found, Just (Bool flag) <- [KeyMap.lookup "inconsistent" fields]]
      Error _ -> []
