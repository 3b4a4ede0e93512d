{-# LANGUAGE OverloadedStrings #-}

-- | @rates@ as scripts use it.
module Test.CommandLine.Rates (spec) where

import Control.Monad (forM_)
import Data.Aeson
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (toList)
import Data.List (isInfixOf, isPrefixOf)
import Data.Maybe (isJust, listToMaybe)
import System.Directory (doesPathExist, listDirectory)
import System.FilePath ((</>))
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support
import Text.Read (readMaybe)

spec :: Spec
spec = do
  it "rates: a line for each size, share of errors and share of erasures, above and below" $ do
    (status, out, err) <-
      pra
        ( words
            "rates --trials 40 --size 2x2 --size 2x3 --errors 1 --errors 3.5 --erasures 0 \
            \--erasures 10"
        )
    (status, err) `shouldBe` (0, "")
    let cases = [[size, p, s] | size <- ["2x2", "2x3"], s <- ["0", "10"], p <- ["1", "3.5"]]
    [take 3 (words l) | l <- lines out, any (`isPrefixOf` l) ["2x2 ", "2x3 "]]
      `shouldBe` cases ++ cases
    maximum (map length (lines out)) `shouldSatisfy` (<= 140)
  it "rates: one seed, one result, on any number of cores and in any table" $ do
    let arguments = words "rates --trials 2500 --errors 5 --erasures 15 --format csv"
    (_, out, _) <- pra (arguments ++ words "--size 2x2 --size 3x3")
    (_, onOneCore, _) <- praUnder "-N1" (arguments ++ words "--size 2x2 --size 3x3") ""
    onOneCore `shouldBe` out
    (_, alone, _) <- pra (arguments ++ words "--size 3x3")
    drop 2 (lines out) `shouldBe` drop 1 (lines alone)
    (_, other, _) <- pra (arguments ++ words "--size 3x3 --seed 2")
    lines other `shouldNotBe` lines alone
  it "rates --radius: the guaranteed one is the default; beyond it there are no exact rates" $ do
    let csv radius =
          (\(_, out, _) -> lines out)
            <$> pra
              ( words "rates --size 4x4 --errors 20 --erasures 0 --trials 2000 --format csv"
                  ++ radius
              )
    guaranteed <- csv []
    csv ["--radius", "4"] `shouldReturn` guaranteed
    beyond <- csv ["--radius", "6"]
    length beyond `shouldBe` 2
    concatMap (take 1) [filter (",,," `isInfixOf`) beyond] `shouldBe` drop 1 beyond
    (_, text, _) <-
      pra
        (words "rates --size 2x2 --errors 5 --erasures 0 --trials 100 --radius 1")
    text `shouldSatisfy` ("a radius of 1 wrong cells" `isInfixOf`)
    (_, asJson, _) <-
      pra
        (words "rates --size 2x2 --errors 5 --erasures 0 --trials 100 --radius 1 --format json")
    key ["radius"] asJson `shouldBe` Just (Number 1)
  it "rates --format csv: as many numbers a line as names, and each way's three add up to 1" $ do
    (status, out, _) <-
      pra
        ( words
            "rates --trials 300 --size 3x3 --size 6x6 --errors 5 --erasures 0 --erasures 15 \
            \--format csv"
        )
    let table = map fields (lines out)
        names = concat (take 1 table)
    (status, length table) `shouldBe` (0, 5)
    take 6 names
      `shouldBe` [ "size",
                   "errors_percent",
                   "erasures_percent",
                   "hard_right",
                   "hard_wrong",
                   "hard_refused"
                 ]
    forM_ (drop 1 table) $ \l -> do
      length l `shouldBe` length names
      forM_ (words "hard exact soft_999 soft_as_hard") $ \way ->
        case traverse
          readMaybe
          [ value
            | (name, value) <- zip names l,
              name `elem` map ((way ++ "_") ++) ["right", "wrong", "refused"]
          ] of
          Just shares -> abs (sum shares - 1 :: Double) `shouldSatisfy` (< 1e-9)
          -- 36 cells have too many sets of missing ones for the exact rates, and so nothing may be
          -- known of how often hard decoding is wrong.
          Nothing ->
            (way `elem` ["exact", "soft_as_hard"], take 1 l, take 1 (drop 2 l))
              `shouldBe` (True, ["6x6"], ["15.0"])
  it "rates --format json: the keys that are promised, and the exact rates" $ do
    (status, out, _) <-
      pra
        ( words
            "rates --trials 200 --seed 3 --size 2x2 --errors 0.6 --erasures 0 --erasures 15 \
            \--format json"
        )
    (status, length (lines out)) `shouldBe` (0, 1)
    map (`key` out) [["schema"], ["trials"], ["seed"]]
      `shouldBe` map Just [String "pra-tactile/rates/1", Number 200, Number 3]
    key ["profile", "polynomial"] out `shouldBe` Just (toJSON [3, 2, 1, 0, 1 :: Int])
    -- The exact rates of 2x2 at 0.6 % without erasures: 97.6215 % right, 2.3692 % wrong, by a
    -- program in another language.
    let found path = case key ["rates"] out >>= firstOf >>= inside path of
          Just (Number x) -> Just (realToFrac x :: Double)
          _ -> Nothing
        close figure = maybe False (\x -> abs (x - figure) < 1e-9)
    found ["by", "exact", "right"] `shouldSatisfy` close 0.976215137296
    found ["by", "exact", "wrong"] `shouldSatisfy` close 0.023691588732611764
    forM_
      [ ["errors_percent"],
        ["erasures_percent"],
        ["by", "hard", "refused"],
        ["by", "soft_999", "right"],
        ["by", "soft_as_hard", "wrong"],
        ["soft_as_hard_more_percent"],
        ["hard_standard_errors", "right"],
        ["soft_999_calibration", "answers"],
        ["soft_999_calibration", "wrong_expected"],
        ["soft_999_calibration", "wrong_counted"]
      ]
      $ \path -> (path, found path) `shouldSatisfy` (isJust . snd)
  it "rates --picture: an SVG file beside the same table; refused before the work" $
    inFolder $ \folder -> do
      let arguments = words "rates --trials 50 --size 2x2 --size 4x4 --erasures 0 --erasures 5"
          file = folder </> "rates.svg"
      table <- pra arguments
      pra (arguments ++ ["--picture", file]) `shouldReturn` table
      picture <- readFile file
      forM_
        [ "<svg ",
          "http://www.w3.org/2000/svg",
          "2x2 cells",
          "4x4 cells",
          "5 % of the cells not observed",
          "</svg>"
        ]
        $ \part ->
          picture `shouldSatisfy` (part `isInfixOf`)
      listDirectory folder `shouldReturn` ["rates.svg"]
      complains
        (arguments ++ ["--picture", folder </> "no" </> "rates.svg"])
        "folder does not exist"
      complains (arguments ++ ["--picture", folder]) "is a folder"
      doesPathExist (folder </> "no") `shouldReturn` False
  it "rates: other fields and foldings; no errors at all" $
    forM_
      [ "--q 2 --polynomial 1,1,0,0,1 --shape 3x5 --size 2x2 --errors 0",
        "--q 3 --polynomial 2,0,0,2,1 --shape 8x10 --folding row-major --window 2x2 --size 1x3 \
        \--errors 40"
      ]
      $ \choice -> do
        (status, out, err) <-
          pra (words "rates --trials 50 --erasures 20 --format csv" ++ words choice)
        (status, length (lines out), err) `shouldBe` (0, 2, "")
  it "rates: impossible options are one line and status 2" $ do
    let with options about = complains ("rates" : words options) about
    with "--trials 0" "--trials"
    with "--trials -3" "--trials"
    forM_ ["-1", "75", "80"] $ \p -> with ("--errors " ++ p) "below 75"
    forM_ ["-1", "100"] $ \s -> with ("--erasures " ++ s) "below 100"
    with "--q 2 --polynomial 1,1,0,0,1 --shape 3x5 --errors 50" "below 50"
    with "--size 0x3" "no cells"
    with "--size 100x100" "4096"
    with
      "--size 2x2 --q 2 --polynomial 1,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1 --shape 1023x1025 \
      \--size 60x60"
      "are simulated"
    with "--q 6 --polynomial 1,1 --shape 1x5" "6 is not a prime power"
  it "docs/results/rates.md: the table has the lines and the exact rates of the command" $ do
    page <- lines <$> readFile "docs/results/rates.md"
    let sizes = byEffort ["2x2", "3x3"] ["2x2", "3x3", "4x4", "5x5"]
    (_, out, _) <- pra (words "rates --trials 1" ++ concat [["--size", size] | size <- sizes])
    let exact ls =
          take
            (8 * length sizes)
            [ (take 3 fields', take 3 (drop 6 fields'))
              | l <- ls,
                any ((`isPrefixOf` l) . (++ " ")) sizes,
                let fields' = words l
            ]
    length (exact page) `shouldBe` 8 * length sizes
    exact page `shouldBe` exact (lines out)
  it "rates: a number that is too large, or no number, is usage with status 2" $
    forM_
      [ "--trials 18446744073709551617",
        "--seed 99999999999999999999",
        "--trials 1.5",
        "--errors x",
        "--errors NaN",
        "--errors Infinity",
        "--erasures NaN",
        "--size 3",
        "--format xml"
      ]
      $ \options -> do
        (status, out, err) <- pra ("rates" : words options)
        (status, out, null err) `shouldBe` (2, "", False)
  where
    firstOf value = case value of
      Array values -> listToMaybe (toList values)
      _ -> Nothing
    inside path value = key path (Lazy8.unpack (encode value))
    fields l = case break (== ',') l of
      (field, _ : rest) -> field : fields rest
      (field, []) -> [field]
