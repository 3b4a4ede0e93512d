-- | What stands around the program: completions, manual pages, installing, the quiet build, the
-- Makefile's help and the linter.
module Test.Tools (spec) where

import Control.Monad (filterM, forM)
import Data.Char (isAlphaNum, isLower, isUpper)
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, partition, sort, stripPrefix, (\\))
import Data.Maybe (fromMaybe)
import System.Directory (doesDirectoryExist, doesFileExist, findExecutable, listDirectory)
import System.Exit (ExitCode (..))
import System.FilePath (makeRelative, (</>))
import System.Process (readProcess, readProcessWithExitCode)
import Test.CommandLine.Run
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  completionSpec
  manualSpec
  installSpec
  quietSpec
  makeSpec
  lintSpec

-- | What completes the last of these words.
completions :: [String] -> IO [String]
completions typed = do
  (_, out, _) <-
    pra
      ( ["--bash-completion-index", show (length typed)]
          ++ concatMap (\word -> ["--bash-completion-word", word]) ("pra-tactile" : typed)
      )
  pure (lines out)

-- | Options with a fixed set of values: the command with its other arguments, the option, and the
-- values as the help has them.
fixedValues :: [([String], String, [String])]
fixedValues =
  [ (["array"], "--format", words "text csv json pgm svg"),
    (["array"], "--folding", ["diagonal", "row-major"]),
    (["table"], "--format", ["csv", "c", "mem"]),
    (["prove"], "--surface", ["torus", "twisted-torus", "sheet"]),
    ( words "rates --trials 1 --size 2x2 --errors 2 --erasures 0",
      "--format",
      ["text", "csv", "json"]
    ),
    (["locate", "3 2 / 3 1"], "--road", ["table", "algebra", "search"]),
    (["locate", "3 2 / 3 1"], "--orientation", ["upright", "turned", "any"])
  ]

completionSpec :: Spec
completionSpec = describe "completion" $ do
  it "of a value by its first letters" $ do
    completions ["array", "--format", "s"] `shouldReturn` ["svg"]
    completions ["probe", "--object", "p"] `shouldReturn` ["parallelepiped"]
    completions ["probe", "--turn", "9"] `shouldReturn` ["90"]
    completions ["census", "--folding", "r"] `shouldReturn` ["row-major"]
  for_ fixedValues $ \(command, option, values) ->
    it (unwords (take 1 command) ++ " " ++ option ++ ": all values, each of which is accepted") $ do
      offered <- completions (command ++ [option, ""])
      sort offered `shouldBe` sort values
      refused <-
        filterM
          (\value -> (\(status, _, _) -> status == 2) <$> pra (command ++ [option, value]))
          offered
      refused `shouldBe` []
  it "of a file's and a folder's name" $ do
    completions ["decode", "data/worked"] `shouldReturn` ["data/worked-example"]
    completions ["stitch", "data/worked"] `shouldReturn` ["data/worked-example"]
    completions ["check", "data/check_c"] `shouldReturn` ["data/check_certificate.py"]
    completions ["stitch", "data/check"] `shouldReturn` []
  it "in bash, by the script that is installed" $
    withShell "bash" $ \bash -> do
      (_, script, _) <- pra ["--bash-completion-script", "pra-tactile"]
      let typed =
            "\nCOMP_WORDS=(pra-tactile array --format s)\nCOMP_CWORD=3\n_pra-tactile\nprintf \
            \'%s\\n' \"${COMPREPLY[@]}\"\n"
      readProcess bash [] (script ++ typed) `shouldReturn` "svg\n"

-- | The commands that the program's own help lists.
commandsOfHelp :: IO [String]
commandsOfHelp = do
  (_, out, _) <- pra ["--help"]
  let sections = drop 1 (dropWhile (/= "Available options:") (lines out))
  pure
    [ takeWhile (/= ' ') entry
      | line <- sections,
        Just entry <- [stripPrefix "  " line],
        any isLower (take 1 entry)
    ]

-- | The long options that a text names.
longOptions :: String -> [String]
longOptions text = case text of
  '-' : '-' : rest@(c : _)
    | isLower c ->
      ("--" ++ takeWhile ofName rest) : longOptions (dropWhile ofName rest)
  _ : rest -> longOptions rest
  [] -> []
  where
    ofName c = isAlphaNum c || c == '-'

manualSpec :: Spec
manualSpec = describe "manual pages" $
  it "one for the program and one a command, each with every option that its help names" $
    inFolder $ \folder -> do
      program <- fromMaybe "pra-tactile" <$> findExecutable "pra-tactile"
      _ <- readProcess "sh" ["tools/manual.sh", program, folder] ""
      commands <- commandsOfHelp
      length commands `shouldSatisfy` (> 20)
      pages <- listDirectory folder
      sort pages
        `shouldBe` sort ("pra-tactile.1" : ["pra-tactile-" ++ name ++ ".1" | name <- commands])
      lacking <- forM commands $ \name -> do
        (_, help, _) <- pra [name, "--help"]
        page <- filter (/= '\\') <$> readFile (folder </> "pra-tactile-" ++ name ++ ".1")
        pure
          [ (name, missing)
            | missing <-
                (longOptions help \\ longOptions page)
                  ++ [ heading
                       | heading <-
                           [ ".SH NAME",
                             ".SH SYNOPSIS",
                             ".SH DESCRIPTION",
                             ".SH OPTIONS",
                             ".SH EXAMPLES"
                           ],
                         heading `notElem` lines page
                     ]
          ]
      concat lacking `shouldBe` []

installSpec :: Spec
installSpec = describe "installing" $
  it "puts program, pages and completions under DESTDIR and PREFIX; and takes them away" $
    inFolder $ \folder -> do
      program <- fromMaybe "pra-tactile" <$> findExecutable "pra-tactile"
      let run what =
            readProcessWithExitCode
              "env"
              [ "PROGRAM=" ++ program,
                "DESTDIR=" ++ folder,
                "PREFIX=/opt/here",
                "sh",
                "tools/install.sh",
                what
              ]
              ""
      (installed, _, _) <- run "install"
      installed `shouldBe` ExitSuccess
      files <- map (makeRelative (folder </> "opt/here")) <$> filesUnder folder
      [ "bin/pra-tactile",
        "share/man/man1/pra-tactile.1",
        "share/man/man1/pra-tactile-locate.1",
        "share/bash-completion/completions/pra-tactile",
        "share/zsh/site-functions/_pra-tactile",
        "share/fish/vendor_completions.d/pra-tactile.fish"
        ]
        \\ files
        `shouldBe` []
      (removed, _, _) <- run "uninstall"
      removed `shouldBe` ExitSuccess
      filesUnder folder `shouldReturn` []

filesUnder :: FilePath -> IO [FilePath]
filesUnder folder = do
  inside <- map (folder </>) <$> listDirectory folder
  files <- filterM doesFileExist inside
  deeper <- filterM doesDirectoryExist inside >>= traverse filesUnder
  pure (files ++ concat deeper)

quietSpec :: Spec
quietSpec = describe "tools/quietly.sh" $ do
  it "keeps what is said in a log, and shows the compiler's warnings alone" $
    inFolder $ \folder -> do
      (status, out, log') <-
        quietly
          folder
          "echo chatter; printf 'A.hs:1:2: warning: [-Wx]\\n    unused\\n  |\\n1 | x\\n'; echo \
          \'[2 of 3] Compiling B'"
      (status, takeWhile (/= "") (drop 1 (lines out)))
        `shouldBe` (ExitSuccess, ["A.hs:1:2: warning: [-Wx]", "    unused", "  |", "1 | x"])
      out `shouldNotSatisfy` (\text -> "chatter" `isInfixOf` text || "Compiling" `isInfixOf` text)
      log'
        `shouldBe` "chatter\nA.hs:1:2: warning: [-Wx]\n    unused\n  |\n1 | x\n[2 of 3] Compiling \
                   \B\n"
  it "leaves cabal's warnings about sublibraries out of the log" $
    inFolder $ \folder -> do
      (_, _, log') <-
        quietly
          folder
          "printf 'Warning: x.cabal:318:26: visibility is experimental feature \
          \(issue\\n#5660)\\nkept\\n'"
      log' `shouldBe` "kept\n"
  it "of a failure keeps the exit status, shows the first error and names the log" $
    inFolder $ \folder -> do
      let script =
            "echo chatter; printf 'A.hs:1:2: error:\\n    first\\n\\nB.hs:3:4: error:\\n    \
            \second\\n\\n'; exit 7"
      (status, _, err) <-
        readProcessWithExitCode
          "sh"
          ["tools/quietly.sh", folder </> "log", "building", "sh", "-c", script]
          ""
      (status, take 2 (lines err)) `shouldBe` (ExitFailure 7, ["A.hs:1:2: error:", "    first"])
      err `shouldNotSatisfy` (\text -> "second" `isInfixOf` text || "chatter" `isInfixOf` text)
      err `shouldSatisfy` ((folder </> "log") `isInfixOf`)
  where
    quietly folder script = do
      (status, out, _) <-
        readProcessWithExitCode
          "sh"
          ["tools/quietly.sh", folder </> "log", "building", "sh", "-c", script]
          ""
      (,,) status out <$> readFile (folder </> "log")

makeSpec :: Spec
makeSpec = describe "make help" $
  it "tells of every target but the default one and files" $
    withShell "make" $ \make -> do
      rules <- lines <$> readFile "Makefile"
      let targets =
            [ target
              | rule <- rules,
                (target, ':' : _) <- [span (\c -> isLower c || c == '-') rule],
                not (null target)
            ]
      told <- readProcess make ["--no-print-directory", "help"] ""
      length targets `shouldSatisfy` (> 10)
      (targets \\ ["all"]) \\ [target | "make" : target : _ <- map words (lines told)] `shouldBe` []

withShell :: FilePath -> (FilePath -> Expectation) -> Expectation
withShell name test = findExecutable name >>= maybe (pendingWith (name ++ " is not there")) test

-- | A file that breaks every restriction once: each is found there, with the settings that @make
-- lint@ gives to pure code.
lintSpec :: Spec
lintSpec = describe "hlint" $
  it "finds every module and every function that pure code may not use" $
    inFolder $ \folder -> do
      hlint <- findExecutable "hlint"
      version <- maybe (pure "") (\program -> readProcess program ["--numeric-version"] "") hlint
      if not ("3.3" `isPrefixOf` version)
        then pendingWith "there is no hlint of version 3.3"
        else do
          restricted <- concatMap namesIn <$> traverse readFile settings
          let (modules, functions) = partition (any isUpper . take 1) restricted
              file = folder </> "Breach.hs"
          writeFile
            file
            ( unlines
                ( ["module Breach where"] ++ ["import " ++ concatMap instead name | name <- modules]
                    ++ [ "breach" ++ show i ++ " = " ++ name
                         | (i, name) <- zip [1 :: Int ..] functions
                       ]
                )
            )
          (_, out, _) <-
            readProcessWithExitCode
              "hlint"
              (map ("--hint=" ++) settings ++ ["--no-summary", file])
              ""
          length restricted `shouldSatisfy` (> 30)
          length (filter ("Avoid restricted" `isInfixOf`) (lines out)) `shouldBe` length restricted
  where
    settings = [".hlint.yaml", "tools/pure.hlint.yaml"]
    namesIn text =
      [ name
        | line <- lines text,
          Just names <- [stripPrefix "    - {name: [" line],
          name <- words (filter (/= ',') (takeWhile (/= ']') names))
      ]
    -- A pattern stands for any module.
    instead letter = if letter == '*' then "Any" else [letter]
