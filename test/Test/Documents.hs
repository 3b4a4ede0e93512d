-- | Tests that the commands in the documents and in the help do what is written beside them. They
-- are read from these texts.
module Test.Documents (spec) where

import Control.Monad (filterM, forM_, unless)
import Data.Char (isAlphaNum, isSpace, toLower)
import Data.List (dropWhileEnd, isInfixOf, isPrefixOf, stripPrefix, tails)
import Data.Maybe (mapMaybe)
import Documents.Transcript
import System.Directory
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, takeExtension, (</>))
import System.Process (CreateProcess (..), proc, readCreateProcessWithExitCode)
import Test.CommandLine.Run
import Test.Effort (byEffort)
import Test.Hspec
import Test.QuickCheck (property)
import Test.Support

spec :: Spec
spec = do
  pages <- runIO documents
  it "a document is the concatenation of its pieces" $
    forM_ pages $ \file -> do
      text <- readText file
      (file, rendered (pieces text)) `shouldBe` (file, text)
  it "a transcript is written as it was read" $
    property
      ( \shown ->
          let text =
                rendered [Transcript Quick [Step ["a", "b"] (map clean shown)]]
           in rendered (pieces text) == text
      )
  forM_ pages $ \file -> describe file $ do
    it "the document's console commands print what is shown under them" $
      scratch $ \folder -> do
        text <- readText file
        let steps = [step | Transcript Quick found <- pieces text, step <- found]
        forM_ (filter (isTried . commandText) steps) $ \step -> do
          shown <- run folder (commandText step)
          (commandText step, shown) `shouldBe` (commandText step, stepShown step)
    it "the document's other commands succeed" $
      scratch $ \folder -> do
        text <- readText file
        makefile <- readText "Makefile"
        forM_
          [ command
            | Script commands <- pieces text,
              command <- map uncommented commands,
              not (null command),
              isTried command
          ]
          $ \command ->
            case words command of
              "make" : targets ->
                forM_ [target | target <- targets, '=' `notElem` target] $ \target ->
                  (command, any ((target ++ ":") `isPrefixOf`) (lines makefile))
                    `shouldBe` (command, True)
              first : _
                | any (`isPrefixOf` first) ["pra-tactile", "echo"] ->
                  works folder command
              -- "Test.Readme" plans a package with it.
              "export" : _ -> pure ()
              -- tools/check-packages.sh installs packages.
              first : _ | first `elem` ["dpkg", "pip"] -> pure ()
              -- Scripts of the repository must exist and be executable.
              first : _
                | any (`isPrefixOf` first) ["bench/", "tools/"] ->
                  doesFileExist first >>= ((command, True) `shouldBe`) . (,) command
              _ -> expectationFailure (command ++ ": this kind of command is not run")
  describe "links lead to files and headings that exist" $
    forM_ (pages ++ ["CHANGELOG.md", "proofs/README.md", "python/README.md"]) $ \file ->
      it file $ do
        text <- readText file
        astray <- filterM (fmap not . leads file) (linksIn text)
        astray `shouldBe` []
  describe "the examples of the help" $ do
    names <- runIO commandNames
    it "exist for every command" $ length names `shouldSatisfy` (> 20)
    parallel $
      forM_ names $ \name -> it name $
        scratch $ \folder -> do
          (_, help, _) <- praAlone [name, "--help"]
          let examples = examplesIn help
          examples `shouldSatisfy` (not . null)
          forM_ (zip [1 :: Int ..] (byEffort (take 1) id examples)) $ \(i, line) -> do
            let own = folder </> show i
            createDirectory own
            forM_ ["data", "examples"] $ \shared ->
              createDirectoryLink (folder </> shared) (own </> shared)
            furnish own line
            works own line
  where
    works folder line = do
      (status, _, err) <- shell folder (briefly line)
      let cutOff = "timeout" `isPrefixOf` briefly line && status == 124
      unless (status < 2 || cutOff) (expectationFailure (line ++ "\n" ++ err))
    clean = filter (`elem` ['a' .. 'z'])
    uncommented = dropWhileEnd isSpace . takeWhile' . dropWhile isSpace
    -- A comment begins with a space and a number sign.
    takeWhile' text = case text of
      ' ' : '#' : _ -> []
      '#' : _ -> []
      c : others -> c : takeWhile' others
      [] -> []

-- | The targets of a document's links, without those to other sites.
linksIn :: String -> [String]
linksIn text =
  [ target
    | rest <- tails (unlines (proseOf text)),
      Just linked <- [stripPrefix "](" rest],
      let target = takeWhile (/= ')') linked,
      not ("http" `isPrefixOf` target)
  ]

-- | The lines of a document outside fenced blocks.
proseOf :: String -> [String]
proseOf = outside . lines
  where
    outside text = case break fence text of
      (prose, _ : block) -> prose ++ outside (drop 1 (dropWhile (not . fence) block))
      (prose, []) -> prose
    fence = isPrefixOf "```"

-- | Whether a link in that document leads somewhere: to a file or folder, and where it names a
-- heading of a document, to that heading.
leads :: FilePath -> String -> IO Bool
leads file target = do
  there <- doesPathExist path
  if there && not (null anchor) && takeExtension path == ".md"
    then elem (drop 1 anchor) . mapMaybe heading . proseOf <$> readText path
    else pure there
  where
    (name, anchor) = break (== '#') target
    path = if null name then file else takeDirectory file </> name
    heading line = case span (== '#') line of
      (_ : _, ' ' : words') -> Just (concatMap letter words')
      _ -> Nothing
    letter c
      | c == ' ' = "-"
      | isAlphaNum c || c `elem` "-_" = [toLower c]
      | otherwise = ""

-- | Whether a document's command is run. A quick run leaves out those that take a second or more:
-- evaluations, many presses, large arrays, laws of touch and of objects, and a process per request.
-- Other tests run the like on less.
isTried :: String -> Bool
isTried command = byEffort (not (any (`isInfixOf` command) laborious)) True
  where
    laborious =
      [ "pra-tactile evaluate",
        "part-",
        "pressed",
        "frames9",
        "large",
        "conform --one-shot",
        "conform --stage touch",
        "conform --stage segment",
        "conform --stage objects"
      ]

-- | A command with smaller counts. The reader may choose counts, and other tests cover large ones.
-- Whole training takes a minute and is left to make check-network. A quick run tests laws and
-- vectors of one profile.
briefly :: String -> String
briefly line = case words line of
  "pra-tactile" : "train" : _ -> "timeout 0.5 " ++ line
  "pra-tactile" : "shapes" : "--design" : _ -> "timeout 0.5 " ++ line
  given@("pra-tactile" : "conform" : "--stage" : stage : options)
    | "--cases" `elem` options -> setting "--cases" "1" given
    | otherwise ->
      unwords
        ( ["pra-tactile", "conform", "--cases", "1", "--stage", stage]
            ++ byEffort paper []
            ++ options
        )
  given@["pra-tactile", "vectors", "--output", _, "--operation", _] ->
    unwords (given ++ byEffort paper [])
  given@("pra-tactile" : "rates" : _)
    | "--patch" `elem` given -> setting "--trials" "50" given
    | otherwise -> setting "--trials" "50" given ++ " --patch 2x2"
  given@("pra-tactile" : "evaluate" : _) -> setting "--presses" "1" given
  ["pra-tactile", "vectors", "--compare", "data/vectors"] ->
    "mkdir few; ln -s ../data/vectors/locate few; pra-tactile vectors --compare few"
  _ -> line
  where
    paper = ["--profile", "examples/adapter/paper.json"]
    setting name value given = case break (== name) given of
      (front, _ : _ : others) -> unwords (front ++ [name, value] ++ others)
      _ -> line

-- | The commands that the help names.
commandNames :: IO [String]
commandNames = do
  (_, help, _) <- praAlone ["--help"]
  pure
    [ name
      | line <- lines help,
        Just text <- [stripPrefix "  " line],
        name : _ <- [words text],
        not (" " `isPrefixOf` text),
        all (`elem` ['a' .. 'z']) name
    ]

-- | The examples at the end of a command's help: a line each, or more where a line is indented
-- deeper.
examplesIn :: String -> [String]
examplesIn help =
  joined
    ( map
        (drop 2)
        (filter (not . all isSpace) (drop 1 (dropWhile (not . isPrefixOf "Example") (lines help))))
    )
  where
    joined text = case text of
      first : others ->
        let (more, next) =
              span (" " `isPrefixOf`) others
         in unwords (first : map (dropWhile isSpace) more) : joined next
      [] -> []

-- | Runs an action in a new folder that has the shipped data and the examples where the repository
-- has them.
scratch :: (FilePath -> IO a) -> IO a
scratch act = inFolder $ \folder -> do
  top <- getCurrentDirectory
  createDirectoryLink (top </> "data") (folder </> "data")
  createDirectoryLink (top </> "examples") (folder </> "examples")
  createDirectoryIfMissing True (folder </> "docs" </> "results")
  act folder

-- | Makes the files that examples mention, with the commands that make such files, unless the
-- example makes them itself.
furnish :: FilePath -> String -> IO ()
furnish folder line = forM_ files $ \(name, command) -> do
  let made = any (`isInfixOf` line) [word ++ name | word <- ["--output ", "--write ", "> "]]
  if name `isInfixOf` line && not made
    then shell folder command >>= (`shouldSatisfy` \(status, _, _) -> status == 0)
    else pure ()
  where
    files =
      [ ("array.csv", "pra-tactile array --format csv --output array.csv"),
        ("paper.json", "pra-tactile certificate --output paper.json"),
        ("patches.txt", "printf '3 2 / 3 1\\n0 0 / 0 0\\n' > patches.txt"),
        ("frames", "pra-tactile probe --object cube --seed 7 --output frames"),
        ( "truth.json",
          "pra-tactile probe --object cube --seed 7 --truth truth.json --output pressed"
        ),
        ("answer.json", "pra-tactile decode --json pressed > answer.json"),
        ( "pairs.jsonl",
          "printf '{\"a\": \"data/worked-example/frames/frame_000.pgm\", \"b\": \
          \\"data/worked-example/frames/frame_001.pgm\", \"step\": [8, 0]}\\n' > pairs.jsonl"
        ),
        ("images", "pra-tactile images --set bitmap --count 1 --seed 1 --output images"),
        ("dark", "pra-tactile probe --dark 4 --sensor hard --seed 7 --output dark"),
        ("flat", "pra-tactile probe --flat 4 --sensor hard --seed 7 --output flat"),
        ("placement.json", "pra-tactile place cube --output placement.json"),
        ("cube.stl", "pra-tactile emboss --object cube --output cube.stl"),
        ("left.pgm", half "left" "0,19.05"),
        ("right.pgm", half "right" "76.2,19.05")
      ]
        ++ [ (name, "pra-tactile " ++ work ++ " --shard " ++ show i ++ "/3 --output " ++ name)
             | (work, ending) <-
                 [ ("census --q 4 --degree 4", ".csv"),
                   ("evaluate --presses 3 --seed 1", ".json")
                 ],
               i <- [1 .. 3 :: Int],
               let name = "part" ++ show i ++ ending
           ]
    -- A part of one face, 50.8 mm wide.
    half name at =
      "pra-tactile probe --object cube --face 'C1 C2 C3 C4' --upright --at "
        ++ at
        ++ " --size 32x52 --seed 1 --output "
        ++ name
        ++ " && pra-tactile stitch "
        ++ name
        ++ " --output "
        ++ name
        ++ ".pgm"

shell :: FilePath -> String -> IO Outcome
shell folder command = do
  (code, out, err) <-
    readCreateProcessWithExitCode (proc "sh" ["-c", command]) {cwd = Just folder} ""
  pure (case code of ExitSuccess -> 0; ExitFailure n -> n, out, err)
