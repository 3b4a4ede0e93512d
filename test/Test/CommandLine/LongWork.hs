-- | Long work: the memory it takes, and the progress it tells.
module Test.CommandLine.LongWork (spec) where

import Data.Foldable (for_)
import Data.List (isInfixOf)
import qualified Data.Map.Strict as Map
import PraTactile.Classification.Regimen
import PraTactile.Classification.Traingdx (Descent (..))
import PraTactile.Evaluate
import PraTactile.Shape.Design
import PraTactile.Steps (stepsDone)
import System.Directory (doesFileExist)
import System.FilePath ((</>))
import System.Process (readProcess)
import Test.CommandLine.Run
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
  it "200 presses are evaluated in 80 MB" $ do
    (status, out, err) <- praUnder "-A1m -M80m" (words "evaluate --presses 200 --seed 1") ""
    (status, length (lines out), err) `shouldBe` (0, 3, "")

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
  it "a training has as many steps as its regimen has rounds" $ do
    let short =
          shippedRegimen
            { stages =
                [ s {stageRounds = 1, roundDescent = (roundDescent s) {epochs = 2}}
                  | s <- stages shippedRegimen
                ],
              composition = map (fmap (`div` 25)) (composition shippedRegimen)
            }
    fmap (\a -> length (stepsDone (trainingRounds short a 1))) paperAlphabet
      `shouldBe` Right (regimenRounds short)
    regimenRounds short `shouldBe` 5
  it "the search for shapes goes forward, to the length announced where it finds nothing" $ do
    let steps = stepsDone (designSteps 1 paperParameters {leastBlocks = 3, mostBlocks = 5})
    zipWith (<) steps (drop 1 steps) `shouldSatisfy` and
    take 1 (reverse steps) `shouldBe` [searchLength]
  for_ work $ \(name, arguments, shown) -> do
    it (name ++ " tells it on a terminal") $
      inFolder $ \folder -> do
        let command =
              "timeout 8 pra-tactile "
                ++ arguments
                ++ " --output "
                ++ folder </> "out > "
                ++ folder </> "printed"
        -- script runs it on a pseudo-terminal, where here the standard error goes alone.
        told <- readProcess "script" ["-qc", command, "/dev/null"] ""
        told `shouldSatisfy` (shown `isInfixOf`)
        told `shouldSatisfy` ("\r[" `isInfixOf`)
  it "evaluate tells it on a terminal, and clears its line" $ do
    told <-
      readProcess "script" ["-qc", "pra-tactile evaluate --presses 6 > /dev/null", "/dev/null"] ""
    told `shouldSatisfy` ("6/6" `isInfixOf`)
    reverse (take 4 (reverse told)) `shouldBe` "\r\ESC[K"
  it "nothing is told where the standard error is no terminal" $
    inFolder $ \folder -> do
      (_, _, quiet) <- pra ["evaluate", "--presses", "6"]
      (_, _, tabled) <- pra (words table ++ ["--output", folder </> "table.csv"])
      (_, _, designed) <- pra ["shapes", "--design", "--output", folder </> "shapes.txt"]
      (quiet, tabled, designed) `shouldBe` ("", "", "")
      doesFileExist (folder </> "table.csv") `shouldReturn` True
  it "a table on a terminal has no bar between its lines" $ do
    told <- readProcess "script" ["-qc", "pra-tactile table", "/dev/null"] ""
    told `shouldSatisfy` (not . ("[" `isInfixOf`))
  where
    table = "table --q 2 --polynomial 1,0,0,0,0,1,1 --shape 7x9"
    work =
      [ ("table", table, "64/64"),
        ("shapes --design", "shapes --design", "0/" ++ show searchLength),
        ("train", "train", "0/17")
      ]
