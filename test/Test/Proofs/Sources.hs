-- | What the suite can say of @proofs/@ without Coq: no proof is left open, every file is checked,
-- and the committed certificates are those that the program issues.
module Test.Proofs.Sources (spec) where

import Data.Char (isAlphaNum)
import Data.List (isPrefixOf, isSuffixOf, sort, tails)
import Documents.Transcript (readText)
import System.Directory (findExecutable, listDirectory)
import System.FilePath ((</>))
import System.Process (readProcess)
import Test.Hspec

spec :: Spec
spec = do
  it "nothing is admitted or assumed, and no check of the kernel is turned off" $ do
    files <- sources
    length files `shouldSatisfy` (> 10)
    texts <- traverse readText files
    let spoken text = ' ' : unwords (wordsOf text) ++ " "
        said = [(file, word) | (file, text) <- zip files texts, word <- forbidden, says word text]
        says word text = any ((' ' : word ++ " ") `isPrefixOf`) (tails (spoken text))
    said `shouldBe` []
  it "every file is in _CoqProject" $ do
    files <- sources
    listed <- lines <$> readText ("proofs" </> "_CoqProject")
    sort [file | file <- listed, ".v" `isSuffixOf` file] `shouldBe` sort (map (drop 7) files)
  it "every theorem's assumptions are asked for, and the table of README has it" $ do
    files <- sources
    theorems <- concatMap theoremsOf <$> traverse readText files
    length theorems `shouldSatisfy` (> 10)
    asked <- wordsOf <$> readText ("proofs" </> "Axioms.v")
    told <- wordsOf <$> readText ("proofs" </> "README.md")
    [name | name <- theorems, name `notElem` asked || name `notElem` told] `shouldBe` []
  it "the committed certificates are those that the program issues" $ do
    python <- findExecutable "python3"
    case python of
      Nothing -> pendingWith "python3 is not installed here, so they were not made again"
      Just executable -> do
        made <- readProcess executable ["proofs/certificates.py", "pra-tactile"] ""
        committed <- readText ("proofs" </> "Certificates.v")
        lines made `shouldBe` lines committed
  where
    forbidden =
      ["Admitted", "admit", "Axiom", "Parameter", "Conjecture", "Unset Guard Checking"]
        ++ ["bypass_check", "type-in-type"]
    theoremsOf text =
      [takeWhile (`notElem` " :") rest | line <- lines text, Just rest <- [theorem line]]
    theorem line = if "Theorem " `isPrefixOf` line then Just (drop 8 line) else Nothing
    -- Names and words, apart from all that stands between them.
    wordsOf = words . map (\c -> if isAlphaNum c || c `elem` "_'-" then c else ' ')

sources :: IO [FilePath]
sources = map ("proofs" </>) . filter (".v" `isSuffixOf`) <$> listDirectory "proofs"
