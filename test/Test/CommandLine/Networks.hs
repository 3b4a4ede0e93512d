{-# LANGUAGE OverloadedStrings #-}

-- | Networks on the command line: trained as the paper's, written for other languages, read again;
-- images and what they are taken for; the experiment.
module Test.CommandLine.Networks (spec) where

import Codec.Picture (Image (..), convertRGB8, pixelAt, readPng)
import Data.Aeson (Value (..), toJSON)
import Data.Foldable (for_, toList)
import Data.List (isInfixOf, isPrefixOf)
import System.Directory (doesPathExist, findExecutable, listDirectory, removeFile)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Process (callProcess, readProcess, readProcessWithExitCode)
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  for_
    [ ("network README.md", "line 1"),
      ("network data/shapes.txt", "line 1"),
      ("network --q 6", "GF(6)"),
      ("network --q 11", "--shapes"),
      ("network data/vectors", "folder"),
      ("images --set bitmap --count 0 --seed 1 --output x", "--count"),
      ("images --set bitmap --count 1 --noise -1 --seed 1 --output x", "--noise"),
      ("images --set bitmap --sensor real --count 1 --seed 1 --output x", "--set press"),
      ("images --set press --sensor nonsense --count 1 --seed 1 --output x", "nonsense"),
      ("images --set bitmap --foreign 97 --count 1 --seed 1 --output x", "--foreign"),
      ("images --set bitmap --foreign -1 --count 1 --seed 1 --output x", "--foreign"),
      ("network --q 9 data/network.txt", "4 classes"),
      ("classify --q 9 --network data/network.txt --batch", "4 classes"),
      ("classify no-such-file", "no-such-file"),
      ("classify README.md", "PGM"),
      ("classify data/worked-example/composite.pgm", "8 x 12"),
      ("classify --levels 1,1 data/worked-example/composite.pgm", "--levels"),
      ("classify --classifier means --network x y", "--network"),
      ("classify --classifier logistic --network x y", "--network"),
      ("experiment --seeds 0", "--seeds"),
      ("experiment --training paper", "paper"),
      ("experiment --vary stated,weights", "stated"),
      ("experiment --set bitmap --sensor real", "--set press"),
      ("train --regimen many --output x", "many"),
      ("train --output no-such-folder/x", "no-such-folder"),
      ("train --output x.txt --trace ./x.txt", "two outputs"),
      ("train --output - --calibration -", "two outputs"),
      ("experiment --output data", "not empty")
    ]
    $ \(arguments, about) -> it arguments (words arguments `complains` about)
  it "weights as JSON are read wherever weights are, and refused with other shapes" $
    inFolder $ \folder -> do
      let json = folder </> "n.json"
          spoilt = folder </> "spoilt.json"
          worked = "data/worked-example/frames"
      pra ["network", "data/network.txt", "--output", json]
        `shouldReturn` (0, "wrote " ++ json ++ "\n", "")
      pra ["decode", "--json", worked, "--network", json] `shouldReturn` workedExample
      ["decode", worked, "--network", json, "--shapes", "data/alphabets/gf5/shapes.txt"]
        `complains` "has 5 shapes"
      ["network", "--q", "3", json] `complains` "other shapes"
      text <- readFile json
      writeFile spoilt (take 2000 text)
      ["network", spoilt] `complains` "spoilt.json"
      writeFile spoilt (map (\c -> if c == '7' then '8' else c) text)
      ["decode", worked, "--network", spoilt] `complains` "spoilt.json"
  it "the digest is computed alike in another language" $ do
    (_, json, _) <- pra ["network", "--json"]
    let script =
          [ "import hashlib, json, struct, sys",
            "def text(v):",
            "    if isinstance(v, dict):",
            "        pairs = [json.dumps(k) + ':' + text(v[k]) for k in sorted(v)]",
            "        return '{' + ','.join(pairs) + '}'",
            "    if isinstance(v, list):",
            "        return '[' + ','.join(map(text, v)) + ']'",
            "    number = isinstance(v, (int, float))",
            "    return struct.pack('>d', v).hex() if number else json.dumps(v)",
            "given = json.load(sys.stdin)",
            "stated = given.pop('digest')",
            "print(hashlib.sha256(text(given).encode()).hexdigest() == stated)"
          ]
    readProcess "python3" ["-c", unlines script] json `shouldReturn` "True\n"
  it "other languages read the weights, and compute outputs alike" $
    inFolder $ \folder -> do
      let json = folder </> "n.json"
          images = folder </> "images"
          count = byEffort 1 2 :: Int
      _ <- pra ["network", "--output", json]
      _ <- pra (words "images --set press --seed 5 --count" ++ [show count, "--output", images])
      names <- filter (".pgm" `isInfixOf`) <$> listDirectory images
      length names `shouldBe` 4 * count
      let script = "examples/python/outputs.py"
      told <- readProcess "python3" (script : json : map (images </>) names) ""
      let greatest line = case words line of
            _ : values -> snd (maximum (zip (map read values :: [Double]) [0 :: Int ..]))
            [] -> -1
          labels = map (\name -> read (takeWhile (/= '_') name)) names
      map greatest (lines told) `shouldBe` labels
      let probabilities = "examples/python/probabilities.py"
          pressed = map (images </>) names
      likely <- readProcess "python3" (probabilities : json : "data/shapes.txt" : pressed) ""
      (_, classified, _) <- pra (words "classify --levels 0.25,0.75 --json" ++ pressed)
      let all' line = case (key ["probabilities"] line, key ["none"] line) of
            (Just (Array ps), Just none) ->
              [realToFrac n :: Double | Number n <- toList ps ++ [none]]
            _ -> []
          numbers line = map read (drop 1 (words line)) :: [Double]
      map (length . numbers) (lines likely) `shouldBe` replicate (4 * count) 5
      map (length . all') (lines classified) `shouldBe` replicate (4 * count) 5
      for_ (zip (lines likely) (lines classified)) $ \(theirs, ours) ->
        maximum (zipWith (\a b -> abs (a - b)) (numbers theirs) (all' ours))
          `shouldSatisfy` (< 1e-6)
  whenFull . it "a shipped network is trained again to the bit" $
    inFolder $ \folder -> do
      blas <-
        readProcess
          "sh"
          [ "-c",
            "ldd \"$(command -v pra-tactile)\" | grep -o '/[^ ]*blas[^ ]*' | xargs -r readlink -f"
          ]
          ""
      if any (`isInfixOf` blas) ["openblas", "mkl", "atlas", "blis"]
        then pendingWith ("weights are to the bit those of the reference BLAS; here it is " ++ blas)
        else do
          let again = folder </> "again.txt"
          (status, _, _) <- pra ["train", "--q", "2", "--uncalibrated", "--output", again]
          (trained, shipped) <- (,) <$> readFile again <*> readFile "data/alphabets/gf2/network.txt"
          (status, trained == shipped) `shouldBe` (0, True)
  it "as ONNX the weights give the same outputs" $
    inFolder $ \folder -> do
      (present, _, _) <- readProcessWithExitCode "python3" ["-c", "import onnx.reference"] ""
      if present /= ExitSuccess
        then pendingWith "Python's package onnx is not installed here"
        else do
          let json = folder </> "n.json"
              onnx = folder </> "n.onnx"
              images = folder </> "images"
          _ <- pra ["network", "--q", "3", "--output", json]
          _ <- pra (words "images --q 3 --set bitmap --count 2 --seed 5 --output" ++ [images])
          names <- map (images </>) . filter (".pgm" `isInfixOf`) <$> listDirectory images
          ours <- readProcess "python3" ("examples/python/outputs.py" : json : names) ""
          _ <- readProcess "python3" ["examples/python/to_onnx.py", json, onnx] ""
          let script =
                [ "import sys, numpy, onnx.reference",
                  "files = [open(name, 'rb').read()[-192:] for name in sys.argv[2:]]",
                  "images = numpy.array([numpy.frombuffer(f, '>u2') for f in files]) / 65535",
                  "network = onnx.reference.ReferenceEvaluator(sys.argv[1])",
                  "for row in network.run(None, {'image': (images - 0.25) / 0.5})[0]:",
                  "    print(*map(float, row))"
                ]
          theirs <- readProcess "python3" ("-c" : unlines script : onnx : names) ""
          let numbers own = map read . concatMap (own . words) . lines :: String -> [Double]
              apart = zipWith (-) (numbers (drop 1) ours) (numbers id theirs)
          length apart `shouldBe` 18
          maximum (map abs apart) `shouldSatisfy` (< 1e-12)
  it "a training by the paper's stages: each ends at its goal, and every epoch is in the trace" $
    inFolder $ \folder -> do
      let trace = folder </> "trace.csv"
          json = folder </> "n.json"
          train more =
            pra
              ( words "train --uncalibrated --seed 2 --regimen"
                  ++ [regimen, "--output", json, "--trace", trace]
                  ++ more
              )
          -- The toolbox's manual ends its noisy stage sooner.
          regimen = byEffort "manual" "stopped"
      (status, out, _) <- train []
      (status, length (filter ("stage " `isPrefixOf`) (lines out))) `shouldBe` (0, 3)
      rows <- map cells . lines <$> readFile trace
      take 1 rows `shouldBe` [["stage", "epoch", "error", "gradient", "rate", "step"]]
      let of' stage = [row | row@(s : _) <- drop 1 rows, s == stage]
          final stage = [read e :: Double | _ : _ : e : _ <- take 1 (reverse (of' stage))]
      concatMap final ["1", "3"] `shouldSatisfy` all (<= 0.1)
      map (map (!! 1)) [of' "1", of' "2", of' "3"]
        `shouldSatisfy` all (\is -> is == map show [0 .. length is - 1])
      described <- readFile json
      (key ["regimen"] described, key ["seed"] described)
        `shouldBe` (Just (toJSON regimen), Just (Number 2))
      (_, without, _) <- train ["--without-noise"]
      length (filter ("stage " `isPrefixOf`) (lines without)) `shouldBe` 2
  it "with --output - the standard output holds only the weights" $
    inFolder $ \folder -> do
      let file = folder </> "n.txt"
          -- Without the noisy stage it is one stage less.
          stages = byEffort 2 3
          fewer = byEffort ["--without-noise"] []
          train to =
            pra (words "train --uncalibrated --regimen manual --seed 1 --output" ++ to : fewer)
      (_, said, _) <- train file
      weights <- readFile file
      train "-" `shouldReturn` (0, weights, unlines (take (1 + stages) (lines said)))
  it "a file's name may have any bytes, also a line of a batch" $
    inFolder $ \folder -> do
      _ <- pra (words "images --set bitmap --count 1 --seed 1 --output" ++ [folder </> "i"])
      let classify how = "pra classify --levels 0.25,0.75 --json " ++ how
          name = "$(printf 'caf\\351.pgm')"
          script =
            "cp i/0_0.pgm \"" ++ name ++ "\"; " ++ classify ("\"" ++ name ++ "\"")
              ++ "; printf 'caf\\351.pgm\\n' | "
              ++ classify "--batch"
      (status, out, err) <- scripted folder script
      (status, err) `shouldBe` (0, "")
      map (key ["file"]) (lines out) `shouldBe` replicate 2 (Just (String "caf\\xe9.pgm"))
  it "images are classified as their labels say, either way up" $
    inFolder $ \folder -> do
      let images = folder </> "images"
      (status, _, _) <-
        pra
          (words "images --q 9 --set bitmap --count 2 --noise 0.1 --seed 5 --output" ++ [images])
      status `shouldBe` 0
      labels <- drop 1 . lines <$> readFile (images </> "labels.csv")
      let name c i = show c ++ "_" ++ show i ++ ".pgm"
      labels `shouldBe` [name c i ++ "," ++ show c | c <- [0 .. 8 :: Int], i <- [0, 1 :: Int]]
      for_ (byEffort ["network"] ["network", "means", "logistic"]) $ \classifier -> do
        (found, out, _) <-
          praWith
            (words "classify --q 9 --batch --levels 0.25,0.75 --json --classifier" ++ [classifier])
            (unlines [images </> show c ++ "_1.pgm" | c <- [0 .. 8 :: Int]])
        (found, map (key ["code"]) (lines out))
          `shouldBe` (0, [Just (Number (fromIntegral c)) | c <- [0 .. 8 :: Int]])
        for_ (lines out) $ \line -> case (key ["probabilities"] line, key ["none"] line) of
          (Just (Array ps), Just none) ->
            abs (sum [realToFrac p | Number p <- none : toList ps] - 1 :: Double)
              `shouldSatisfy` (< 1e-9)
          other -> expectationFailure (show other)
  it "a line that names no image is invalid, the rest goes on; nothing known is no error" $
    inFolder $ \folder -> do
      let images = folder </> "images"
          grey = folder </> "grey.pgm"
          half = folder </> "half.pgm"
      _ <- pra (words "images --set bitmap --count 1 --seed 1 --output" ++ [images])
      writeFile grey ("P2\n8 12\n255\n" ++ unwords (replicate 96 "7") ++ "\n")
      writeFile half (unlines ("P2" : "8 12" : "255" : replicate 12 "0 0 0 0 9 9 9 9"))
      (status, out, err) <-
        praWith
          (words "classify --batch --json --levels 0.25,0.75")
          (unlines [images </> "0_0.pgm", "", "nothing", grey, images </> "1_0.pgm"])
      (status, err) `shouldBe` (2, "")
      map (key ["outcome"]) (lines out)
        `shouldBe` map Just ["recognised", "invalid", "invalid", "invalid", "recognised"]
      map (key ["message"]) (lines out)
        `shouldBe` [ Just Null,
                     Just "an empty line names no file",
                     Just "there is no file nothing",
                     Just (toJSON (grey ++ ": all of its values are the same")),
                     Just Null
                   ]
      (_, inWords, _) <-
        praWith
          (words "classify --batch --levels 0.25,0.75")
          (concatMap (++ "\r\n") [grey, "nothing"])
      lines inWords
        `shouldBe` [ grey ++ ": invalid: all of its values are the same",
                     "nothing: invalid: there is no file nothing"
                   ]
      ["classify", grey] `complains` "the same"
      (none, said, _) <- pra ["classify", half, "--levels", "0,0.0352941"]
      (none, said) `shouldBe` (1, half ++ ": none\n")
  it "images of other shapes have the class -1, and are far from each symbol" $
    inFolder $ \folder -> do
      let images = folder </> "images"
      (status, _, _) <-
        pra (words "images --set bitmap --foreign 28 --count 5 --seed 5 --output" ++ [images])
      status `shouldBe` 0
      labels <- drop 1 . lines <$> readFile (images </> "labels.csv")
      labels `shouldBe` ["-1_" ++ show i ++ ".pgm,-1" | i <- [0 .. 4 :: Int]]
  it "the experiment writes its tables and curves, and all tables have the same rows" $
    inFolder $ \folder -> do
      let made = folder </> "made"
          asked =
            words
              ( "experiment --set bitmap "
                  ++ byEffort
                    "--training manual --seeds 1"
                    "--training manual,stopped --vary formula --seeds 2"
              )
          -- A row has noisy images, clean copies, or no such stage; a level of noise is a line.
          results = 3 * byEffort 1 4
      (status, out, _) <- pra (asked ++ ["--output", made])
      status `shouldBe` 0
      length (lines out) `shouldBe` 2 + results
      rows <- lines <$> readFile (made </> "rows.csv")
      levels <- lines <$> readFile (made </> "levels.csv")
      (length rows, length levels) `shouldBe` (1 + results, 1 + results * 11)
      whole <- readFile (made </> "experiment.json")
      (_, json, _) <- pra (asked ++ ["--json"])
      json `shouldBe` whole
      for_ ["noise.svg", "learning.svg"] $ \name ->
        readFile (made </> name) >>= (`shouldSatisfy` ("</svg>" `isInfixOf`))
      -- Drawn, the title leaves paper beside it: nothing of it is cut off.
      drawing <- findExecutable "rsvg-convert"
      for_ drawing $ \program -> for_ ["noise.svg", "learning.svg"] $ \name -> do
        let picture = made </> name ++ ".png"
        callProcess program ["-o", picture, made </> name]
        drawn <- readPng picture >>= either fail (pure . convertRGB8)
        let paper = pixelAt drawn 0 0
            ink = [pixelAt drawn x y | y <- [8 .. 28], x <- [0 .. imageWidth drawn - 1]]
            beside = [pixelAt drawn x y | y <- [8 .. 28], x <- [0, 1, imageWidth drawn - 1]]
        (name, all (== paper) ink, all (== paper) beside) `shouldBe` (name, False, True)
        removeFile picture
      (refused, _, why) <- pra (asked ++ ["--output", made])
      (refused, "not empty" `isInfixOf` why) `shouldBe` (2, True)
      doesPathExist (made ++ ".part") `shouldReturn` False
  where
    cells line = case break (== ',') line of
      (cell, _ : rest) -> cell : cells rest
      (cell, []) -> [cell]
