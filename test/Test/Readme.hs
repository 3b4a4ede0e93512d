-- | What README.md says of the library, done: its program is run, and its package is planned by
-- cabal.
module Test.Readme (spec) where

import Data.List (isInfixOf, isPrefixOf)
import House.Source (readText)
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
      cabal ["exec", "-v0", "--", "runghc", folder </> "Readme.hs"]
        `shouldReturn` (ExitSuccess, unlines (indented rest), "")
  it "as it stands, the program decodes what a sensor of half the pitch felt" $ \text ->
    inFolder $ \folder -> do
      let (program, _) = fenced "```haskell" text
          frames = "data/worked-example/frames"
          pressing = "probe --object cube --face 'C1 C2 C3 C4' --at 12,44 --upright --seed 7"
          finer = "--sensor real --frame 32x32 --taxel 0.79375"
          commands =
            [ "set -e",
              "mkdir -p data/worked-example",
              unwords ["pra-tactile", pressing, finer, "--output", frames, "> log"],
              "runghc Readme.hs"
            ]
      writeFile (folder </> "Readme.hs") (unlines program)
      (code, out, err) <-
        cabal
          [ "exec",
            "-v0",
            "--",
            "sh",
            "-c",
            "cd '" ++ folder ++ "'\n" ++ unlines commands
          ]
      (code, take 1 (lines out), err)
        `shouldBe` (ExitSuccess, ["cube, face C1 C2 C3 C4, corner C2"], "")
  it "so does the one with a placement of one's own, after the commands shown with it" $ \text ->
    inFolder $ \folder -> do
      let (program, rest) = fenced "```haskell" (snd (fenced "```haskell" text))
          (commands, _) = fenced "```sh" rest
          script = ["set -e", "cd '" ++ folder ++ "'"] ++ map (++ " > log") commands
      length commands `shouldBe` 2
      writeFile (folder </> "Own.hs") (unlines program)
      (code, out, err) <-
        cabal
          ["exec", "-v0", "--", "sh", "-c", unlines (script ++ ["runghc Own.hs"])]
      (code, takeWhile (/= ',') out, err) `shouldBe` (ExitSuccess, "lid", "")
  it "without a network, plain cabal plans a package by the configuration that is named" $ \text ->
    inFolder $ \folder -> besideGhc $ do
      here <- getCurrentDirectory
      let (named, _) = fenced "```sh" (snd (fenced "```cabal" text))
      named `shouldBe` ["export CABAL_CONFIG=$PWD/../pra-tactile/cabal/offline.config"]
      createDirectory (folder </> "example")
      createDirectoryLink here (folder </> "pra-tactile")
      writeFile (folder </> "example" </> "cabal.project") "packages: .\n  ../pra-tactile\n"
      writeFile (folder </> "example" </> "Main.hs") "main :: IO ()\nmain = pure ()\n"
      writeFile
        (folder </> "example" </> "example.cabal")
        ( unlines
            [ "cabal-version: 3.0",
              "name: example",
              "version: 0",
              "executable example",
              "  default-language: Haskell2010",
              "  main-is: Main.hs",
              "  build-depends: base, pra-tactile, pra-tactile:files"
            ]
        )
      let script =
            ["set -e", "cd '" ++ (folder </> "example") ++ "'", "export HOME='" ++ folder ++ "'"]
              ++ named
              ++ ["cabal build -v1 --dry-run"]
      (code, out, err) <- readProcessWithExitCode "sh" ["-c", unlines script] ""
      (code, "hackage" `isInfixOf` (out ++ err)) `shouldBe` (ExitSuccess, False)
  it "a package with the lines for cabal.project is planned with these libraries" $
    \text -> inFolder $ \folder -> do
      here <- getCurrentDirectory
      let (project, rest) = fenced "```cabal-project" text
          (depends, _) = fenced "```cabal" rest
          found line = if words line == ["../pra-tactile"] then "          " ++ here else line
      [() | line <- project, words line == ["../pra-tactile"]] `shouldBe` [()]
      writeFile (folder </> "cabal.project") (unlines (map found project))
      writeFile (folder </> "Main.hs") "main :: IO ()\nmain = pure ()\n"
      writeFile
        (folder </> "example.cabal")
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
      let planning =
            [ "build",
              "-v1",
              "--dry-run",
              "--project-file=" ++ (folder </> "cabal.project"),
              "example"
            ]
      (code, out, _) <- cabal planning
      code `shouldBe` ExitSuccess
      -- Those to be built, of this package: the libraries named, and what they rest on.
      let seen =
            [ part
              | "-" : package : part : _ <- map words (lines out),
                "pra-tactile-" `isPrefixOf` package
            ]
      seen
        `shouldMatchList` [ "(lib:common)",
                            "(lib:code-internal)",
                            "(lib:touch-internal)",
                            "(lib:recognition-internal)",
                            "(lib)",
                            "(lib:simulation)",
                            "(lib:solid)",
                            "(lib:formats)",
                            "(lib:files)"
                          ]
  where
    -- One of the libraries tells whether they come with GHC, as Debian's do.
    besideGhc act = do
      (_, listed, _) <- readProcessWithExitCode "ghc-pkg" (words "list --simple-output hmatrix") ""
      if "hmatrix" `isPrefixOf` listed
        then act
        else pendingWith "the libraries are not beside GHC here"
    library = dropWhile (/= "## The library") . lines
    cabal arguments = readProcessWithExitCode "tools/cabal.sh" arguments ""

-- | The lines of the first block that this fence opens, and the lines after the block.
fenced :: String -> [String] -> ([String], [String])
fenced fence text = drop 1 <$> break (== "```") (drop 1 (dropWhile (/= fence) text))

-- | The first indented block.
indented :: [String] -> [String]
indented = map (drop 4) . takeWhile ("    " `isPrefixOf`) . dropWhile (not . ("    " `isPrefixOf`))
