-- | Long work: the memory it takes, and the progress it tells.
module Test.CommandLine.LongWork (spec) where

import Data.Bits (testBit)
import Data.Foldable (for_)
import Data.List (inits, isInfixOf, isPrefixOf, isSuffixOf)
import qualified Data.Map.Strict as Map
import qualified Data.Text as Text
import Memory (mostBytes)
import PraTactile.Classification.Regimen
import PraTactile.Classification.Shipped (shippedAlphabet)
import PraTactile.Classification.Train (Demand (..))
import PraTactile.Classification.Traingdx (Descent (..))
import PraTactile.Evaluate
import PraTactile.Shape (alphabet, bitmapWhere, renderAlphabet)
import PraTactile.Shape.Design
import PraTactile.Steps hiding (counted)
import Progress
import System.Directory (doesFileExist)
import System.FilePath ((</>))
import System.IO (hGetContents)
import System.Process
import System.Random (mkStdGen)
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.QuickCheck
import Test.Support
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  describe "memory" memorySpec
  describe "counts" countSpec
  describe "progress" progressSpec

memorySpec :: Spec
memorySpec =
  it (show presses ++ " presses are evaluated in 80 MB") $ do
    (status, out, err) <-
      praUnder "-A1m -M80m" (words ("evaluate --presses " ++ show presses ++ " --seed 1")) ""
    (status, length (lines out), err) `shouldBe` (0, 3, "")
  where
    presses = byEffort 8 200 :: Int

countSpec :: Spec
countSpec = do
  it "a tally has every result once, and the sum of the answers' doubts" $
    property $
      forAll (listOf outcome) $ \outcomes -> do
        let counted = tally outcomes
            doubts = [d | r <- outcomes, Just d <- [doubtOf r]]
        (tallyRight counted, tallyWrong counted, sum (tallyRefused counted))
          === ( length [() | Correct _ <- outcomes],
                length [() | Mistaken _ <- outcomes],
                length outcomes - length doubts
              )
          .&&. tallyExpected counted === sum doubts
          .&&. Map.toList (tallyRefused counted)
            === [ (name, n)
                  | name <- reasons,
                    let n = length (filter (== NoAnswer name) outcomes),
                    n > 0
                ]
  where
    reasons = ["mirrored", "no-symbols"]
    outcome =
      oneof [Correct <$> choose (0, 1), Mistaken <$> choose (0, 1), NoAnswer <$> elements reasons]
    doubtOf r = case r of
      Correct d -> Just d
      Mistaken d -> Just d
      NoAnswer _ -> Nothing

progressSpec :: Spec
progressSpec = do
  it "a training has as many steps as its regimen has rounds, and as it is said to have epochs" $ do
    let short =
          shippedRegimen
            { stages =
                [ s {stageRounds = 1, roundDescent = (roundDescent s) {epochs = 2}}
                  | s <- stages shippedRegimen
                ],
              composition = map (fmap (`div` 25)) (composition shippedRegimen)
            }
    a <- right paperAlphabet
    let steps = trainingSteps short a 1
    map fst (roundsOf steps) `shouldBe` [1 .. 5]
    length (filter (== EpochDone) (stepsDone steps))
      `shouldBe` demandEpochs (regimenDemand short 4)
    demandEpochs (regimenDemand short 4) `shouldBe` 10
  it "a training holds as many images as are announced" $
    for_ [2, 4, 9] $ \q -> do
      shipped <- right (shippedAlphabet q)
      let regimen = regimenFor q
          (images, _) = roundImages (composition regimen) [0] shipped (mkStdGen 1)
      length images `shouldBe` demandImages (regimenDemand regimen q)
  it "shapes that are shipped, and sixteen, are trained; what a machine cannot hold is refused" $ do
    let bytes q = demandBytes (regimenDemand (regimenFor q) q)
    map bytes [2 .. 16] `shouldSatisfy` all (< mostBytes `div` 4)
    inFolder $ \folder -> do
      writeFile (folder </> "s16") (Text.unpack (drawn 16))
      writeFile (folder </> "s100") (Text.unpack (drawn 100))
      scripted folder "pra train --shapes s100 --output n.json" >>= (`refuses` "at once")
      scripted folder "pra images --set bitmap --count 100000 --shapes s100 --seed 1 --output i"
        >>= (`refuses` "at once")
      -- What it takes is said before the work, of which there are minutes.
      let training = "train --shapes " ++ folder </> "s16" ++ " --output " ++ folder </> "n.json"
      seen
        (proc "pra-tactile" (words training))
        ["training 16 shapes: 20080 images at once, 5000 epochs at most, about"]
  it "the search for shapes measures drawings, then tries all distances where it finds none" $ do
    let steps = stepsDone (designSteps 1 paperParameters {leastBlocks = 3, mostBlocks = 5})
        numbers = [i | Measured i <- steps]
    zipWith (<) numbers (drop 1 numbers) `shouldSatisfy` and
    numbers `shouldSatisfy` all (<= drawings)
    drop (length numbers) steps `shouldBe` map Trying [96, 95 .. 1]
  it "steps follow each other, and are counted on" $
    property $ \one other runs ->
      let of' numbers a = foldr Step (Done a) numbers
          both = of' one 'a' >>= \a -> of' other [a]
       in (stepsDone both, result both) === (one ++ other :: [Int], "a")
            .&&. stepsDone (inTurn [of' (scanl1 (+) run) () | run <- runs])
              === scanl1 (+) (concat (runs :: [[Int]]))
  it "the rest is estimated where steps are alike, as what they took, and nowhere else" $
    property $ \(Positive each) (Positive past) (Positive fresh) (Positive more) ->
      let done = past + fresh + 1 :: Integer
          whole = done + more
          -- A step takes so many seconds.
          seconds = fromInteger ((fresh + 1) * each)
          even' = lineAt (doneBefore past (evenly whole "x")) done seconds
          uneven = lineAt (doneBefore past (unevenly whole "x")) done seconds
       in conjoin
            [ counterexample even' ((", " ++ clock (more * each) ++ " left") `isSuffixOf` even'),
              counterexample uneven (not ("left" `isInfixOf` uneven)),
              counterexample uneven $
                (", " ++ clock ((fresh + 1) * each) ++ " so far") `isSuffixOf` uneven,
              property (all ((< 80) . length) [even', uneven])
            ]
  for_ work $ \(name, arguments, shown) -> do
    it (name ++ " tells it on a terminal") $
      inFolder $ \folder -> do
        let command =
              "exec pra-tactile "
                ++ arguments
                ++ " --output "
                ++ folder </> "out > "
                ++ folder </> "printed"
        -- script runs it on a pseudo-terminal, to which only the standard error goes, and ends it
        -- when script itself is ended.
        seen (proc "script" ["-qfc", command, "/dev/null"]) [shown, "\r["]
  it "evaluate tells it on a terminal, and clears its line" $ do
    told <-
      readProcess "script" ["-qc", "pra-tactile evaluate --presses 2 > /dev/null", "/dev/null"] ""
    told `shouldSatisfy` ("2/2" `isInfixOf`)
    reverse (take 4 (reverse told)) `shouldBe` "\r\ESC[K"
  it "rates tells it on a terminal between its lines, and spoils none of them" $
    inFolder $ \folder -> do
      -- Both streams go to the terminal, whose line the bar leaves before one is printed.
      let rates = "pra-tactile rates --size 2x2 --errors 2 --erasures 0 --erasures 15 --trials 2000"
      (_, lines', _) <- scripted folder rates
      told <- readProcess "script" ["-qc", rates, "/dev/null"] ""
      told `shouldSatisfy` ("/4000 trials" `isInfixOf`)
      map shownAtLast (lines told) `shouldBe` lines lines'
  it "nothing is told where the standard error is no terminal" $
    inFolder $ \folder -> do
      (_, _, quiet) <- pra ["evaluate", "--presses", "1"]
      (_, _, tabled) <- pra (words table ++ ["--output", folder </> "table.csv"])
      (quiet, tabled) `shouldBe` ("", "")
      doesFileExist (folder </> "table.csv") `shouldReturn` True
  it "a table on a terminal has no bar between its lines" $ do
    told <- readProcess "script" ["-qc", "pra-tactile table", "/dev/null"] ""
    told `shouldSatisfy` (not . ("[" `isInfixOf`))
  where
    table = "table --q 2 --polynomial 1,0,0,0,0,1,1 --shape 7x9"
    work =
      [ ("table", table, "64/64"),
        ("shapes --design", "shapes --design", "0/" ++ show drawings),
        ("train", "train", "0/5000 epochs"),
        ("train by the paper's stages", "train --regimen stated", "0/16 images"),
        ("images", "images --set press --count 1 --seed 1", "0/4 images"),
        ("experiment", "experiment --training manual --seeds 1", "0/416 images")
      ]
    -- What a terminal shows of a line in the end: what was written after it was last cleared.
    shownAtLast = filter (/= '\r') . last . breakOn "\r\ESC[K"
    breakOn mark text = case [i | i <- [0 .. length text], mark `isPrefixOf` drop i text] of
      [] -> [text]
      i : _ -> take i text : breakOn mark (drop (i + length mark) text)
    clock seconds
      | seconds >= 3600 = show h ++ ":" ++ two m ++ ":" ++ two s
      | otherwise = show m ++ ":" ++ two s
      where
        (h, rest) = seconds `divMod` 3600
        (m, s) = rest `divMod` 60
        two n = drop 1 (show (100 + n)) :: String
    -- As many different drawings, each its number as bits.
    drawn count =
      either (const Text.empty) renderAlphabet . alphabet $
        [ (Text.pack (show k), bitmapWhere (\x y -> testBit (k + 512 :: Int) (y * 8 + x)))
          | k <- [1 .. count]
        ]

-- | A process writes all of these to its standard output; it is ended once it has.
seen :: CreateProcess -> [String] -> Expectation
seen process marks =
  withCreateProcess process {std_in = CreatePipe, std_out = CreatePipe} $ \_ out _ handle -> do
    told <- maybe (pure "") hGetContents out
    let haveAll text = all (`isInfixOf` text) marks
    take 1 (filter haveAll (inits told)) `shouldSatisfy` (not . null)
    terminateProcess handle
