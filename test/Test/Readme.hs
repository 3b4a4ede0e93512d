-- | Tests what README.md and docs/how-to/library.md say of the library: their programs run, and
-- cabal plans the package.
module Test.Readme (spec) where

import Data.List (isInfixOf, isPrefixOf)
import Documents.Transcript (readText)
import System.Directory (createDirectory, createDirectoryLink, getCurrentDirectory)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Process (readProcessWithExitCode)
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = beforeAll ((,) <$> linesOf "README.md" <*> linesOf "docs/how-to/library.md") $ do
  it ("a program of at most ten lines prints what is shown; the other " ++ verb) $
    \(readme, page) -> inFolder $ \folder -> do
      let (program, afterProgram) = fenced "```haskell" page
          (own, afterOwn) = fenced "```haskell" afterProgram
          (commands, _) = fenced "```sh" afterOwn
          printed = indented readme
      length program `shouldSatisfy` (\n -> n > 0 && n <= 10)
      readText "examples/haskell/Decode.hs" `shouldReturn` unlines program
      (null own, length commands) `shouldBe` (False, 2)
      writeFile (folder </> "Readme.hs") (unlines program)
      writeFile (folder </> "Own.hs") (unlines own)
      -- Linking the second program takes as long as the first: a quick run only checks its types.
      let second =
            byEffort
              [compiled "-fno-code" "Own"]
              (map (++ " > log") commands ++ [compiled "" "Own", "./Own"])
          -- The first program reads a folder of the project.
          script =
            [ "set -e",
              "project=$PWD",
              "cd '" ++ folder ++ "'",
              compiled "" "Readme",
              "(cd \"$project\" && '" ++ folder </> "Readme')"
            ]
              ++ second
      (code, out, err) <- cabal ["exec", "-v0", "--", "sh", "-c", unlines script]
      let (first, others) = splitAt (length printed) (lines out)
      (code, first, err) `shouldBe` (ExitSuccess, printed, "")
      map (takeWhile (/= ',')) (take 1 others) `shouldBe` byEffort [] ["lid"]
  it "plain cabal plans a package with these lines, without a network" $ \(_, page) ->
    inFolder $ \folder -> besideGhc $ do
      here <- getCurrentDirectory
      let (project, afterProject) = fenced "```cabal-project" page
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
    -- One library shows whether the libraries come with GHC, as Debian's do.
    besideGhc act = do
      (_, listed, _) <- readProcessWithExitCode "ghc-pkg" (words "list --simple-output hmatrix") ""
      if "hmatrix" `isPrefixOf` listed
        then act
        else pendingWith "the libraries are not beside GHC here"
    verb = byEffort "compiles" "decodes"
    linesOf file = lines <$> readText file
    -- The libraries are static, so a program is compiled and not interpreted.
    compiled how file = unwords ["ghc -v0 -O0", how, file ++ ".hs"]
    cabal arguments = readProcessWithExitCode "tools/cabal.sh" arguments ""

-- | The lines of the first block that this fence opens, and the lines after the block.
fenced :: String -> [String] -> ([String], [String])
fenced fence text = drop 1 <$> break (== "```") (drop 1 (dropWhile (/= fence) text))

-- | The first indented block.
indented :: [String] -> [String]
indented = map (drop 4) . takeWhile ("    " `isPrefixOf`) . dropWhile (not . ("    " `isPrefixOf`))
