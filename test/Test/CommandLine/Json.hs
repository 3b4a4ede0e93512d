-- | An object that has a key twice is refused, in every JSON that the program reads.
module Test.CommandLine.Json (spec) where

import Control.Monad (forM_)
import Data.List (isInfixOf)
import System.FilePath ((</>))
import Test.CommandLine.Run
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  it "a place on one face has that face among its faces" $ do
    (status, out, _) <- pra ["objects", "--at", "6,5", "--json"]
    status `shouldBe` 0
    filter (/= '"') out `shouldSatisfy` isInfixOf "faces:[{face:[C1,C2,C3,C4],object:cube}]"
  it "a profile" $
    inFolder $ \folder -> do
      (_, profile, _) <- pra ["profile"]
      let file = folder </> "p.json"
      forM_ ["\"q\": 4, ", "\"\\u0071\": 2, ", "\"x\": {\"a\": 1, \"a\": 1}, "] $ \more -> do
        writeFile file ("{" ++ more ++ drop 1 profile)
        complains ["array", "--profile", file] "is given twice"
  it "a certificate, in itself and in its parts" $
    inFolder $ \folder -> do
      (_, certificate, _) <- pra ["certificate"]
      let file = folder </> "c.json"
      writeFile file ("{\"windows\":255," ++ drop 1 certificate)
      complains ["check", file] "\"windows\" is given twice"
      writeFile file (replaced "\"evidence\":{" "\"evidence\":{\"road\":\"rank\"," certificate)
      complains ["check", file] "\"road\" is given twice"
  it "patches" $ do
    complains
      ["locate", "{\"patches\": [{\"cells\": [[3, 2], [3, 1]], \"cells\": [[0, 0], [0, 1]]}]}"]
      "\"cells\" is given twice"
    complains
      ["locate", "{\"patches\": [], \"patches\": [{\"cells\": [[3, 2], [3, 1]]}]}"]
      "\"patches\" is given twice"
    complains ["locate", "[[3, {\"a\": 1, \"a\": 2}]]"] "\"a\" is given twice"
  it "a truth, and an answer that is compared with it" $
    inFolder $ \folder -> do
      let truth = folder </> "truth.json"
          answer = folder </> "answer.json"
      _ <-
        pra
          ( words "probe --object cube --seed 7 --output"
              ++ [ folder </> "frames",
                   "--truth",
                   truth
                 ]
          )
      (_, decoded, _) <- pra ["decode", "--json", folder </> "frames"]
      writeFile answer decoded
      (status, _, _) <- pra ["compare", answer, truth]
      status `shouldBe` 0
      writeFile answer ("{\"on\":\"face\"," ++ drop 1 decoded)
      complains ["compare", answer, truth] "\"on\" is given twice"
      writeFile answer decoded
      known <- readFile truth
      writeFile (truth ++ "2") ("{\"object\":\"cube\"," ++ drop 1 known)
      complains ["compare", answer, truth ++ "2"] "\"object\" is given twice"
  where
    replaced from to text
      | take (length from) text == from = to ++ drop (length from) text
      | otherwise = take 1 text ++ replaced from to (drop 1 text)
