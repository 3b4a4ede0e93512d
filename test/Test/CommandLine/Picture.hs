{-# LANGUAGE OverloadedStrings #-}

-- | Pictures, the simulated press and its truth, as scripts use them.
module Test.CommandLine.Picture (spec) where

import Data.Aeson
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, sort, stripPrefix, tails)
import System.Directory (listDirectory)
import System.FilePath ((</>))
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  it "a picture whose name is none of SVG is refused before any work" $
    inFolder $ \folder -> do
      for_ ["picture.png", "picture.PDF", "picture.svg.png"] $ \name -> do
        -- The input is not even looked for.
        complains ["decode", "no/such/file.pgm", "--picture", folder </> name] ".svg"
        complains ["rates", "--trials", "1000000000", "--plot", folder </> name] ".svg"
        complains ["stitch", "no/such/folder", "--report", folder </> name] ".svg"
      listDirectory folder `shouldReturn` []
      answer <- pra ["decode", worked]
      for_ ["picture.svg", "PICTURE.SVG", "picture"] $ \name -> do
        pra ["decode", worked, "--picture", folder </> name] `shouldReturn` answer
        picture <- readFile (folder </> name)
        for_ ["<svg ", "cube, face C1 C2 C3 C4, corner C2", "</svg>"] $ \part ->
          picture `shouldSatisfy` (part `isInfixOf`)
  it "- is the standard output: the picture alone, as the file has it" $
    inFolder $ \folder -> do
      _ <- pra ["decode", worked, "--picture", folder </> "picture.svg"]
      picture <- readFile (folder </> "picture.svg")
      pra ["decode", worked, "--picture", "-"] `shouldReturn` (0, picture, "")
      complains ["decode", "--json", worked, "--picture", "-"] "standard output"
      _ <- pra (words "rates --trials 20 --size 2x2 --plot" ++ [folder </> "rates.svg"])
      plot <- readFile (folder </> "rates.svg")
      pra (words "rates --trials 20 --size 2x2 --plot -") `shouldReturn` (0, plot, "")
      let frames = byEffort (folder </> "frames") "data/worked-example/frames"
      _ <- pra (words "probe --object cube --seed 1 --size 24x16 --output" ++ [folder </> "frames"])
      _ <- pra ["stitch", frames, "--report", folder </> "report.svg"]
      report <- readFile (folder </> "report.svg")
      pra ["stitch", frames, "--report", "-"] `shouldReturn` (0, report, "")
      complains ["stitch", "--json", frames, "--report", "-"] "standard output"
  it "what was refused has a picture too, without a face" $
    inFolder $ \folder -> do
      (status, _, _) <-
        pra ["decode", "--doubt", "0", worked, "--picture", folder </> "picture.svg"]
      picture <- readFile (folder </> "picture.svg")
      (status, "Where it is" `isInfixOf` picture, "not likely enough" `isInfixOf` picture)
        `shouldBe` (1, False, True)
  it "a face that is no rectangle is drawn as the polygon that it is" $
    inFolder $ \folder -> do
      (status, _, err) <-
        scripted
          folder
          "pra place t=tetrahedron:200 --output p.json > log && pra probe --placement p.json \
          \--object t --seed 3 --output f > log && pra decode --placement p.json f --picture x.svg \
          \> log"
      (status, err) `shouldBe` (0, "")
      picture <- readFile (folder </> "x.svg")
      let faces = [line | line <- lines picture, "class=\"face\"" `isInfixOf` line]
      map (length . filter (== ',') . pointsOf) faces
        `shouldSatisfy` \corners -> not (null corners) && all (== 3) corners
  it "docs/demo.svg is what the command below it in README draws" $ do
    readme <- lines <$> readFile "README.md"
    case [ words command
           | l <- readme,
             Just command <- [stripPrefix "$ pra-tactile " l],
             "docs/demo.svg" `isInfixOf` command
         ] of
      [arguments] -> do
        (status, drawn, _) <-
          pra [if argument == "docs/demo.svg" then "-" else argument | argument <- arguments]
        kept <- readFile "docs/demo.svg"
        (status, marks drawn) `shouldBe` (0, marks kept)
      other -> expectationFailure ("one command was expected: " ++ show other)
  it "a region off the face: how large it is, where, and how large the face is" $
    inFolder $ \folder -> do
      let press =
            [ "probe",
              "--object",
              "parallelepiped",
              "--face",
              "P6 P5 P8 P7",
              "--seed",
              "1",
              "--output",
              folder </> "frames"
            ]
      -- 40 x 52 taxels of 1.5875 mm.
      complains
        (press ++ ["--at", "0,60"])
        "63.5 x 82.55 mm from 0,60 mm, does not lie on the face P6 P5 P8 P7, which is 177.8 x \
        \101.6 mm"
      -- One that is longer than the face holds it.
      complains (press ++ words "--size 60x70 --at 0,5") "95.25 x 111.12 mm"
      -- Turned by a quarter, it lies across.
      complains (press ++ words "--size 80x20 --turn 90 --at 0,5") "31.75 x 127 mm"
  it "probe --truth, decode, compare: an answer agrees with its own truth only" $
    inFolder $ \folder -> do
      for_ (byEffort [0, 180] [0, 90, 180, 270 :: Int]) $ \degrees -> do
        let file name = folder </> name ++ show degrees
        (probed, _, _) <-
          pra
            [ "probe",
              "--object",
              "cube",
              "--face",
              "C1 C2 C3 C4",
              "--at",
              -- Four whole cells, or half a cell more on each side.
              byEffort "25.4,31.75" "12.7,12.7",
              "--turn",
              show degrees,
              "--origin",
              "1000,-250.5",
              "--seed",
              "3",
              "--size",
              byEffort "32x40" "48x48",
              "--truth",
              file "truth",
              "--output",
              file "frames"
            ]
        (decoded, answer, _) <- pra ["decode", "--json", file "frames"]
        writeFile (file "answer") answer
        (probed, decoded) `shouldBe` (0, 0)
        (agrees, out, _) <- pra ["compare", file "answer", file "truth"]
        (agrees, "they agree to " `isPrefixOf` last ("" : lines out)) `shouldBe` (0, True)
        (status, told, _) <- pra ["compare", "--json", file "answer", file "truth"]
        (status, key ["agree"] told, key ["answer_mm"] told)
          `shouldBe` (0, Just (Bool True), key ["place_mm"] answer)
        key ["distance_mm"] told `shouldSatisfy` maybe False (under 2)
      for_ [("answer0", "truth180", "other-orientation")] $ \(answer, truth, difference) -> do
        (status, told, _) <- pra ["compare", "--json", folder </> answer, folder </> truth]
        (status, key ["agree"] told, key ["difference"] told)
          `shouldBe` (1, Just (Bool False), Just (String difference))
      _ <-
        pra
          ( words "probe --object parallelepiped --seed 4 --truth"
              ++ [ folder </> "elsewhere",
                   "--output",
                   folder </> "other"
                 ]
          )
      (status, out, _) <- pra ["compare", folder </> "answer0", folder </> "elsewhere"]
      (status, "another face" `isInfixOf` out) `shouldBe` (1, True)
      (_, refused, _) <- pra ["decode", "--json", "--doubt", "0", folder </> "frames0"]
      writeFile (folder </> "refused") refused
      (none, _, _) <- pra ["compare", folder </> "refused", folder </> "truth0"]
      none `shouldBe` 1
      -- Exchanged, the files say themselves which is which.
      inOrder <- pra ["compare", "--json", folder </> "answer0", folder </> "truth0"]
      pra ["compare", "--json", folder </> "truth0", folder </> "answer0"] `shouldReturn` inOrder
      complains ["compare", folder </> "truth0", folder </> "truth0"] "not one answer"
      complains ["compare", folder </> "answer0", folder </> "answer0"] "not the truth"
      complains ["compare", worked, folder </> "truth0"] "not one answer"
  it "the window's centre in the robot's coordinates is where the composite shows it" $ do
    (_, out, _) <- pra ["decode", "--json", worked]
    case (key ["windows"] out, key ["robot_mm"] out) of
      (Just windows, Just there) -> case fromJSON windows of
        Success (window : _) | Success (x, y) <- fromJSON there -> do
          let pixel name = key [name] (Lazy8.unpack (encode (window :: Value))) >>= number
          pixel "x" `shouldSatisfy` maybe False (\u -> abs (1.5875 * u - x) < 1e-9)
          pixel "y" `shouldSatisfy` maybe False (\v -> abs (1.5875 * v - y) < 1e-9)
        _ -> expectationFailure "no window"
      other -> expectationFailure (show other)
  where
    worked = "data/worked-example/composite.pgm"
    under limit value = maybe False (< limit) (number value)
    number :: Value -> Maybe Double
    number value = case fromJSON value of
      Success x -> Just x
      Error _ -> Nothing
    -- What is drawn, without the order of attributes, of which the last has the slash, and the
    -- bytes of the image: both depend on versions of libraries.
    marks =
      sort
        . filter (not . ("xlink:href" `isPrefixOf`))
        . words
        . map (\c -> if c `elem` ("<>/" :: String) then ' ' else c)

-- | The points of a polygon in SVG.
pointsOf :: String -> String
pointsOf line = case [rest | end <- tails line, Just rest <- [stripPrefix "points=\"" end]] of
  points : _ -> takeWhile (/= '"') points
  [] -> ""
