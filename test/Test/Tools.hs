-- | Tests completions, manual pages and installing.
module Test.Tools (spec) where

import Control.Monad (filterM, forM)
import Data.Char (isAlphaNum, isLower)
import Data.Foldable (for_)
import Data.List (sort, stripPrefix, (\\))
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
  installSpec

-- | The completions of the last of these words.
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
  it "finds a value by its first letters" $ do
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
  it "finds the names of files and folders" $ do
    completions ["decode", "data/worked"] `shouldReturn` ["data/worked-example"]
    completions ["stitch", "data/worked"] `shouldReturn` ["data/worked-example"]
    completions ["check", "data/check_c"] `shouldReturn` ["data/check_certificate.py"]
    completions ["stitch", "data/check"] `shouldReturn` []
  it "works in bash, by the installed script" $
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

-- | Expects that the manual pages in a folder are one for the program and one for each command,
-- with every option in its help.
completeManual :: FilePath -> Expectation
completeManual folder = do
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
  it "puts program, whole manual and completions under DESTDIR and PREFIX, and removes them" $
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
        "share/bash-completion/completions/pra-tactile",
        "share/zsh/site-functions/_pra-tactile",
        "share/fish/vendor_completions.d/pra-tactile.fish"
        ]
        \\ files
        `shouldBe` []
      completeManual (folder </> "opt/here/share/man/man1")
      (removed, _, _) <- run "uninstall"
      removed `shouldBe` ExitSuccess
      filesUnder folder `shouldReturn` []

filesUnder :: FilePath -> IO [FilePath]
filesUnder folder = do
  inside <- map (folder </>) <$> listDirectory folder
  files <- filterM doesFileExist inside
  deeper <- filterM doesDirectoryExist inside >>= traverse filesUnder
  pure (files ++ concat deeper)

withShell :: FilePath -> (FilePath -> Expectation) -> Expectation
withShell name test = findExecutable name >>= maybe (pendingWith (name ++ " is not there")) test
