-- | What README.md says of the library, done: its programs are run, and its package is planned by
-- cabal.
module Test.Readme (spec) where

import Data.List (isInfixOf, isPrefixOf)
import Documents.Transcript (readText)
import System.Directory (createDirectory, createDirectoryLink, getCurrentDirectory)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Process (readProcessWithExitCode)
import Test.Hspec
import Test.Support

spec :: Spec
spec = beforeAll (library <$> readText "README.md") $ do
  it "the program is of ten lines or less, and prints what is printed there" $ \text ->
    inFolder $ \folder -> do
      let (program, rest) = fenced "```haskell" text
      length program `shouldSatisfy` (\n -> n > 0 && n <= 10)
      writeFile (folder </> "Readme.hs") (unlines program)
      let script = [compiled (folder </> "Readme"), "'" ++ folder </> "Readme'"]
      cabal ["exec", "-v0", "--", "sh", "-c", unlines script]
        `shouldReturn` (ExitSuccess, unlines (indented rest), "")
  it "the one with a placement of one's own decodes after the commands shown with it" $ \text ->
    inFolder $ \folder -> do
      let (program, rest) = fenced "```haskell" (snd (fenced "```haskell" text))
          (commands, _) = fenced "```sh" rest
          script = ["set -e", "cd '" ++ folder ++ "'"] ++ map (++ " > log") commands
      length commands `shouldBe` 2
      writeFile (folder </> "Own.hs") (unlines program)
      (code, out, err) <-
        cabal
          ["exec", "-v0", "--", "sh", "-c", unlines (script ++ [compiled "Own", "./Own"])]
      (code, takeWhile (/= ',') out, err) `shouldBe` (ExitSuccess, "lid", "")
  it "plain cabal plans a package with its lines, without a network" $ \text ->
    inFolder $ \folder -> besideGhc $ do
      here <- getCurrentDirectory
      let (project, afterProject) = fenced "```cabal-project" text
          (depends, afterDepends) = fenced "```cabal" afterProject
          (configured, _) = fenced "```sh" afterDepends
          package = folder </> "example"
      createDirectory package
      createDirectoryLink here (folder </> "pra-tactile")
      writeFile (package </> "cabal.project") (unlines project)
      writeFile (package </> "Main.hs") "main :: IO ()\nmain = pure ()\n"
      writeFile
        (package </> "example.cabal")
        ( unlines
            ( [ "cabal-version: 3.0",
                "name: example",
                "version: 0",
                "executable example",
                "  default-language: Haskell2010",
                "  main-is: Main.hs"
              ]
                ++ map ("  " ++) depends
            )
        )
      let script =
            ["set -e", "cd '" ++ package ++ "'", "export HOME='" ++ folder ++ "'"]
              ++ configured
              ++ ["cabal build -v1 --dry-run"]
      (code, out, err) <- readProcessWithExitCode "sh" ["-c", unlines script] ""
      (code, "(lib:files)" `isInfixOf` out, "hackage" `isInfixOf` (out ++ err))
        `shouldBe` (ExitSuccess, True, False)
  where
    -- One of the libraries tells whether they come with GHC, as Debian's do.
    besideGhc act = do
      (_, listed, _) <- readProcessWithExitCode "ghc-pkg" (words "list --simple-output hmatrix") ""
      if "hmatrix" `isPrefixOf` listed
        then act
        else pendingWith "the libraries are not beside GHC here"
    library = dropWhile (/= "## The library") . lines
    -- The libraries are static, so a program is compiled and not interpreted.
    compiled file = "ghc -v0 -O0 '" ++ file ++ ".hs'"
    cabal arguments = readProcessWithExitCode "tools/cabal.sh" arguments ""

-- | The lines of the first block that this fence opens, and the lines after the block.
fenced :: String -> [String] -> ([String], [String])
fenced fence text = drop 1 <$> break (== "```") (drop 1 (dropWhile (/= fence) text))

-- | The first indented block.
indented :: [String] -> [String]
indented = map (drop 4) . takeWhile ("    " `isPrefixOf`) . dropWhile (not . ("    " `isPrefixOf`))
